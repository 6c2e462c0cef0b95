"""What the robot carries on each motion of a program: the tool's own mass (tload) and what it holds (GripLoad).

Of a wait nobody says it: what the motion before carries. Before the first tool there is no load.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, rotation_from_wxyz
from trajopt_cli.motion import Load, Move, MoveExtJ, Program, SignalEvent, Source, Tool, Wait
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.dynamics import ToolLoad

_UNIT = 0.02  # by which the length of an orientation may be off, as where RAPID is read


def loads_of(program: Program) -> list[ToolLoad | None]:
    """Of every motion, in the flange's frame. Raises InputError, placed at the move, for axes of moment that are no
    orientation, an inertia that no body has, and a load in a gripper that holds the work object."""
    out: list[ToolLoad | None] = []
    tool: Tool | None = None
    for motion in program.motions:
        if isinstance(motion, Wait | SignalEvent):
            out.append(out[-1] if out else None)
            continue
        tool = tool if isinstance(motion, MoveExtJ) else motion.tool
        out.append(_carried(tool, motion.settings.load, motion.source))
    return out


def load_notes(program: Program, plant: Plant) -> tuple[str, ...]:
    """What plans and the judge count of it, one line, where torques have limits."""
    if plant.limits.binding_torque is None:
        return ()
    moves = [motion for motion in program.motions if isinstance(motion, Move)]
    tools = {move.tool.name: move.tool for move in moves if not isinstance(move, MoveExtJ)}
    held = dict.fromkeys(move.settings.load.name for move in moves if move.settings.load is not None)
    known = [f"{name} {tool.load.mass:g} kg" for name, tool in tools.items() if tool.load is not None]
    unknown = [name for name, tool in tools.items() if tool.load is None]
    told = f"counted in torques: {', '.join([*known, *(f'load {name}' for name in held)])}" if known or held else ""
    left = f"not counted: the mass of {', '.join(unknown)}, whose tload says none" if unknown else ""
    return tuple(["; ".join(part for part in (told, left) if part)] if told or left else [])


def _carried(tool: Tool | None, held: Load | None, source: Source) -> ToolLoad | None:
    parts = []
    if tool is not None and tool.load is not None:
        parts.append(_body(tool.load, np.eye(4), source))
    if held is not None and held.mass > 0:
        if tool is not None and tool.stationary:
            text = f"load {held.name}: torque_limits does not know where a work object held by the robot has its mass"
            raise InputError(f"{text}; put it into the tool's tload", file=source.file, line=source.line)
        parts.append(_body(held, np.eye(4) if tool is None else tool.X_FT, source))
    if len(parts) < 2:
        return parts[0] if parts else None
    mass = sum(part.mass for part in parts)
    com = sum((part.mass * part.com for part in parts), np.zeros(3)) / mass
    inertia = sum((part.inertia + part.mass * _steiner(part.com - com) for part in parts), np.zeros((3, 3)))
    return ToolLoad(mass, com, inertia)


def _steiner(away: Array) -> Array:
    return np.asarray(away @ away * np.eye(3) - np.outer(away, away))


def _body(load: Load, X_F: Array, source: Source) -> ToolLoad:
    """A load given in a frame X_F (4, 4) of the flange."""
    length = float(np.linalg.norm(load.aom))
    if abs(length - 1) > _UNIT:
        text = f"aom of {load.name} is no orientation: its length is {length:.6g}, wanted 1"
        raise InputError(text, file=source.file, line=source.line)
    axes = X_F[:3, :3] @ rotation_from_wxyz(np.array(load.aom) / length)
    try:
        return ToolLoad(load.mass, X_F[:3, :3] @ np.array(load.cog) + X_F[:3, 3], axes @ np.diag(load.inertia) @ axes.T)
    except ValueError as error:
        text = f"load of {load.name}: {error}; correct its inertia"
        raise InputError(text, file=source.file, line=source.line) from error
