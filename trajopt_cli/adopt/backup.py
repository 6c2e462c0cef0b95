"""The cell file that is made of a backup: what the controller's MOC.cfg says, with its lines."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose, wxyz_from_rotation
from trajopt_cli.moc import ConfiguredRobot, External, Mechanics
from trajopt_cli.problem.controller import LETTERS, read_mechanics, shipped_robot, shown, travel
from trajopt_cli.robot.model import RobotModel, load_robot, robot_names
from trajopt_cli.warnings import ProgramWarning

_HOME = (0.0, 0.0, 0.0, 0.0, 30.0, 0.0)  # deg
_SLACK = 1e-3  # rad, of ranges that are printed with six digits
_ALONG = 0.01  # of a direction: a rail that is measured is that far off


def cell_from_backup(backup: Path, place: Path, robot: str | None) -> tuple[str, str, tuple[ProgramWarning, ...]]:
    """The text of a cell file in the folder of place, the robot in it, and what of the backup was not read. robot: a
    name, or its YAML file, instead of the controller's type.

    Raises InputError where the backup has no MOC.cfg that can be read or no robot in it, and for a robot that does not
    ship, or has no rail where it stands on one.
    """
    if not backup.exists():
        raise InputError("no such backup", file=str(backup))
    moc, told = read_mechanics([backup])
    if moc is None:
        why = "; ".join(map(str, told)) or "there is no folder SYSPAR in it"
        raise InputError(f"holds no SYSPAR/MOC.cfg that can be read: {why}", file=str(backup))
    arm = moc.robot_of(str(backup.resolve()))
    if arm is None:
        raise InputError("names no robot in a section ROBOT; give the backup of a robot's controller", file=moc.file)
    name = robot or shipped_robot(arm.type)
    if name is None:
        what = f"no robot that ships is of type '{arm.type}'; say by --robot which stands for it"
        raise InputError(f"{what} ('trajopt robot list', 'trajopt robot add')", file=moc.file, line=arm.line)
    if arm.track is not None and f"{name}_rail" in robot_names():
        name = f"{name}_rail"
    model = load_robot(name)
    if arm.track is not None and not model.has_rail:
        what = f"{arm.name} stands on {arm.track.name}, and robot {name} has no rail; give one on a rail by --robot"
        raise InputError(what, file=moc.file, line=arm.line)
    own = name.endswith((".yaml", ".yml"))
    said = os.path.relpath(os.path.realpath(name), os.path.realpath(place.parent)) if own else name
    return "\n".join(_lines(moc, arm, said, model)) + "\n", name, told


def _lines(moc: Mechanics, arm: ConfiguredRobot, name: str, model: RobotModel) -> Iterator[str]:
    others = [f"{one.name} ({moc.place(one.line)})" for one in moc.robots if one is not arm]
    yield f"# Proposed by 'trajopt new' from {moc.file}: check every line. Numbers are SI (m, rad, s)."
    yield "# Not from there: the start, speeds and accelerations of the arm, caps on the tool, obstacles, signals."
    if others:
        yield f"# {arm.name} is taken, not {', '.join(others)}: '--from BACKUP/RAPID/T_ROB2' takes that of a task."
    yield ""
    yield f"robot: {name}  # {arm.name} is {arm.type}: {moc.place(arm.line)}"
    yield "profile: default  # acceleration limits: estimates, MOC.cfg has none of the arm"
    track = arm.track if model.has_rail else None
    if track is not None:
        yield from _rail(moc, arm, track, model)
        yield "# waits: {rail: free}  # lets the rail move while the tool waits; without it it holds"
    else:
        if arm.moved_by:
            yield f"# {arm.moved_by} moves its base frame, and is no track of this file: {moc.place(arm.line)}"
        yield from _frame("base", arm.X, arm, moc)
    yield from _limits(moc, arm, track, model)
    yield from _start(arm, track)
    for one in moc.externals:
        if one is not track:
            yield from _external(moc, arm, one)


def _rail(moc: Mechanics, arm: ConfiguredRobot, track: External, model: RobotModel) -> Iterator[str]:
    switches = (["active from start-up"] if track.active else []) + (["cannot be deactivated"] if track.fixed else [])
    yield f"rail:  # {', '.join([track.name, *switches])}: {moc.place(track.line)}"
    if track.eax is None:
        yield "  # eax: ?  # no JOINT with -logical_axis tells the letter of this unit; see the program's targets"
    else:
        yield f"  eax: {LETTERS[track.eax]}  # logical axis {track.eax + 7}: {moc.place(track.eax_line)}"
    if track.range is None:
        yield "  # stroke: [?, ?]  # no ARM tells the range of this unit"
    else:
        yield f"  stroke: [{track.range.lower:.9g}, {track.range.upper:.9g}]  # {moc.place(track.range.line)}"
    drives = arm.X[:3, :3].T @ travel(track)
    own = model.X_RB[:3, :3].T @ model.rail_axes[0]
    said = f"[{shown(track.X[:3, 3], 6)}], it runs along [{shown(travel(track), 4)}] of the world"
    yield f"  # {track.name}'s own base frame is at {said}"
    if np.linalg.norm(drives - own) <= _ALONG:
        yield from ("  " + line for line in _frame("frame", arm.X @ inverse_pose(model.X_RB), arm, moc))
        return
    yield f"  direction: [{shown(drives, 9)}]  # seen from the arm's base; that of {model.name} is [{shown(own, 4)}]"
    yield from ("  " + line for line in _frame("frame", arm.X @ inverse_pose(model.X_RB), arm, moc))


def _frame(key: str, X: Array, arm: ConfiguredRobot, moc: Mechanics) -> Iterator[str]:
    yield f"{key}:  # the base frame of {arm.name} in the world: {moc.place(arm.line)}"
    yield f"  position: [{shown(X[:3, 3], 9)}]"
    yield f"  wxyz: [{shown(wxyz_from_rotation(X[:3, :3]), 9)}]"


def _limits(moc: Mechanics, arm: ConfiguredRobot, track: External | None, model: RobotModel) -> Iterator[str]:
    base, out, bare = model.profile(), list[str](), list[str]()
    for name, there in zip(model.axis_names[-6:], arm.ranges, strict=True):
        i = base.names.index(name)
        if there is None:
            bare.append(name)
            continue
        place, sides = moc.place(there.line), {}
        if there.lower > base.lower[i] + _SLACK:
            sides["lower"] = there.lower
        if there.upper < base.upper[i] - _SLACK:
            sides["upper"] = there.upper
        if sides:
            told = ", ".join(f"{side}: {value:.9g}" for side, value in sides.items())
            out.append(f"  {name}: {{{told}, source: {json.dumps(f'controller, {place}')}}}")
        elif there.lower < base.lower[i] - _SLACK or there.upper > base.upper[i] + _SLACK:
            own = f"{base.lower[i]:.6g}..{base.upper[i]:.6g}"
            out.append(
                f"  # {name}: the controller allows {there.lower:g}..{there.upper:g}, {model.name} {own}: {place}"
            )
    if track is not None:
        told = ", ".join(
            f"{kind}: {value:.6g}"
            for kind, value in (("velocity", track.velocity), ("acceleration", track.acceleration))
            if value is not None
        )
        out.append(
            f"  rail: {{{told}, source: {json.dumps(f'controller, drive of {track.name}, {moc.place(track.line)}')}}}"
            if told
            else "  # rail: MOC.cfg has no speed and no acceleration of its drive; the robot file's estimates hold"
        )
    if bare:
        out.append(f"  # {', '.join(bare)}: no range in MOC.cfg, that of {model.name} holds")
    if any(not line.startswith("  #") for line in out):
        yield "limits:"
    yield from out


def _start(arm: ConfiguredRobot, track: External | None) -> Iterator[str]:
    home = [
        value if there is None else float(np.clip(value, np.degrees(there.lower), np.degrees(there.upper)))
        for value, there in zip(_HOME, arm.ranges, strict=True)
    ]
    yield "start:  # where the cycle begins, at rest: adapt it"
    yield f'  joints: "[{", ".join(f"{value:.6g}" for value in home)}] deg"'
    if track is not None:
        low, high = (0.0, 1.0) if track.range is None else track.range[:2]
        yield f"  rail: {min(max(0.0, low), high):.9g}"


def _external(moc: Mechanics, arm: ConfiguredRobot, one: External) -> Iterator[str]:
    """A unit that is not the rail, as a comment to take over: what a positioner needs and MOC.cfg does not say is ?."""
    place = moc.place(one.line)
    if one.slides is not False or one is arm.track:
        kind = "slides" if one.slides else "may slide or turn, MOC.cfg does not say"
        yield f"# {one.name} {kind}, and does not move the base frame of {arm.name}: it is not in this file; {place}"
        return
    low, high = (f"{x:.6g}" for x in one.range[:2]) if one.range else ("?", "?")
    letter = "?" if one.eax is None else f"{LETTERS[one.eax]}  # {moc.place(one.eax_line)}"
    speed, acc = ("?" if x is None else f"{x:.6g}" for x in (one.velocity, one.acceleration))
    yield "# positioners:  # what ? stands for MOC.cfg does not say; take the '#' away then"
    yield f"#   {one.name}:  # turns about z of its base frame; without what moves that: {place}"
    yield f"#     eax: {letter}"
    yield "#     frame:"
    yield f"#       position: [{shown(one.X[:3, 3], 9)}]"
    yield f"#       wxyz: [{shown(wxyz_from_rotation(one.X[:3, :3]), 9)}]"
    yield f"#     range: [{low}, {high}]"
    yield f"#     velocity: {speed}"
    yield f"#     acceleration: {acc}"
    yield f"#     source: {json.dumps(f'controller, {place}')}"
