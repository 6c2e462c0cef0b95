r"""MoveJ, MoveL, MoveAbsJ and MoveExtJ: arguments to motions in SI units.

The pose of a robtarget in the world is X_WT = U O P: user frame and object frame of the work object, then the target.
External axes move the base under it and never the target. This is one of the two places where mm and degrees live.
"""

from __future__ import annotations

from functools import lru_cache
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.motion import (
    ConfData,
    ExternalAxes,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    MoveL,
    Speed,
    Tool,
    Written,
    Zone,
)
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import (
    JOINTTARGET,
    LOADDATA,
    ROBTARGET,
    SPEEDDATA,
    TOOLDATA,
    WOBJDATA,
    ZONEDATA,
    Value,
)
from trajopt_cli.rapid.execution.arguments import Arguments, Instruction, bind
from trajopt_cli.rapid.execution.evaluate import evaluate, number
from trajopt_cli.rapid.language.syntax import Expression, Name, Node, ProcedureCall
from trajopt_cli.units import DEG, MM

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run

NO_POSITION = 8.9e9  # RAPID's 9E9, with room for rounding
NORM_ERROR, NORM_WARNING = 1e-3, 1e-5  # how far a quaternion's length may be off: beyond is an error, a warning
_STOP_POINTS = ("inpos20", "inpos50", "inpos100")

_POSE_OPTIONS = ("Conc", "ID", "V", "T", "Z", "Inpos", "WObj", "TLoad")
_JOINT_OPTIONS = ("Conc", "ID", "NoEOffs", "V", "T", "Z", "Inpos", "WObj", "TLoad")
_EXTERNAL_OPTIONS = ("Conc", "ID", "T", "Inpos")


def move_j(run: Run, node: ProcedureCall) -> None:
    """MoveJ ToPoint, Speed, Zone, Tool."""
    run.motions.append(_pose_move(run, node, MoveJ))


def move_l(run: Run, node: ProcedureCall) -> None:
    """MoveL ToPoint, Speed, Zone, Tool."""
    run.motions.append(_pose_move(run, node, MoveL))


def move_abs_j(run: Run, node: ProcedureCall) -> None:
    """MoveAbsJ JointPos, Speed, Zone, Tool. The work object means nothing to joints; it is checked all the same."""
    args = bind(run, node, ("JointPos", "Speed", "Zone", "Tool"), _JOINT_OPTIONS)
    point, speed, zone, tool = args.required
    target = evaluate(run, point, JOINTTARGET)
    _work_object(run, args)
    robax, extax = target.data
    for axis, value in enumerate(robax, 1):
        if abs(value) > NO_POSITION:
            raise run.error(point, f"jointtarget {run.text(point)} gives no position for axis {axis} (9E9)")
    run.motions.append(
        MoveAbsJ(
            source=run.source(node),
            written=_written(run, node, point, speed, target),
            target=run.text(point),
            speed=_speed(run, speed, args),
            zone=_zone(run, zone, args),
            extax=_external(extax),
            duration=_duration(run, args),
            optional=(run.file, node.start) in run.optional,
            q=np.array(robax) * DEG,
            tool=_tool(run, tool),
        )
    )


def move_ext_j(run: Run, node: ProcedureCall) -> None:
    """MoveExtJ JointPos, Speed, Zone."""
    args = bind(run, node, ("JointPos", "Speed", "Zone"), _EXTERNAL_OPTIONS)
    point, speed, zone = args.required
    target = evaluate(run, point, JOINTTARGET)
    run.motions.append(
        MoveExtJ(
            source=run.source(node),
            written=_written(run, node, point, speed, target),
            target=run.text(point),
            speed=_speed(run, speed, args, external=True),
            zone=_zone(run, zone, args),
            extax=_external(target.data[1]),
            duration=_duration(run, args),
            optional=(run.file, node.start) in run.optional,
        )
    )


def _pose_move(run: Run, node: ProcedureCall, kind: type[MoveJ] | type[MoveL]) -> MoveJ | MoveL:
    args = bind(run, node, ("ToPoint", "Speed", "Zone", "Tool"), _POSE_OPTIONS)
    point, speed, zone, tool = args.required
    target = evaluate(run, point, ROBTARGET)
    trans, rot, conf, extax = target.data
    literal = target.origin
    where = literal.literal if literal else point
    q = orientation(run, rot, f"{run.text(point)}", where, literal.file if literal else run.file)
    wobj, X_WO = _work_object(run, args)
    p, q = frames.compose(X_WO, (trans, q)) if X_WO else (trans, q)
    if not all(isfinite(value) and abs(value) < NO_POSITION for value in p):
        raise run.error(point, f"{run.text(point)} has no position: trans is [{', '.join(f'{v:.6g}' for v in p)}] mm")
    return kind(
        source=run.source(node),
        written=_written(run, node, point, speed, target),
        target=run.text(point),
        speed=_speed(run, speed, args),
        zone=_zone(run, zone, args),
        extax=_external(extax),
        duration=_duration(run, args),
        optional=(run.file, node.start) in run.optional,
        X_WT=_matrix((p, q)),
        conf=_configuration(run, point, conf),
        tool=_tool(run, tool),
        wobj=wobj,
        X_WO=_pose(X_WO) if X_WO else _IDENTITY,
    )


def _matrix(frame: frames.Frame) -> Array:
    """A frame [mm] as a pose [m]."""
    p, q = frame
    X = np.zeros((4, 4))
    X[:3, :3] = frames.matrix(q)
    X[:3, 3] = [value * MM for value in p]
    X[3, 3] = 1.0
    return X


@lru_cache(maxsize=64)
def _pose(frame: frames.Frame) -> Array:
    """As _matrix, one array for all motions in the same frame."""
    return readonly(_matrix(frame))


_IDENTITY = readonly(np.eye(4))


def _written(run: Run, node: ProcedureCall, point: Expression, speed: Expression, target: Value) -> Written:
    places, origin = run.places(), target.origin
    aggregate = run.places(origin.file).span(origin.literal.start, origin.literal.end) if origin else None
    return Written(
        statement=places.span(node.start, node.end),
        target=places.span(point.start, point.end),
        speed=places.span(speed.start, speed.end),
        aggregate=aggregate,
        declaration=origin.declaration if origin else None,
    )


# ------------------------------------------------------------------------------------------------------ the target


def orientation(run: Run, q: frames.Quaternion, name: str, node: Node, file: str) -> frames.Quaternion:
    """q at length 1, said when that changes it. name, node, file: whose orientation, and where it is written."""
    n = frames.norm(q)
    off = abs(n - 1.0)
    if not off <= NORM_ERROR:
        place = run.places(file)
        shown = ",".join(f"{value:.7g}" for value in q)
        hint = "it was never given a value" if n == 0 else "give a quaternion of length 1"
        raise place.error(node.start, f"{name} has orientation [{shown}] of length {n:.6g}, limit 1 +- 0.001; {hint}")
    if off > NORM_WARNING:
        run.warn(f"{run.places(file).source(node.start)}: {name} has an orientation of length {n:.7g}; taken as 1")
    return frames.normalised(q)


def _configuration(run: Run, point: Expression, conf: tuple[float, float, float, float]) -> ConfData:
    if any(value != int(value) or abs(value) > NO_POSITION for value in conf):
        shown = ",".join(f"{value:.6g}" for value in conf)
        raise run.error(point, f"{run.text(point)} has confdata [{shown}]; it takes four whole numbers")
    cf1, cf4, cf6, cfx = (int(value) for value in conf)
    return ConfData(cf1, cf4, cf6, cfx)


def _external(extax: tuple[float, ...]) -> ExternalAxes:
    a, b, c, d, e, f = (None if abs(value) > NO_POSITION else value for value in extax)
    return (a, b, c, d, e, f)


def _identity(frame: object) -> bool:
    return frame == ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))


def _work_object(run: Run, args: Arguments) -> tuple[str, frames.Frame | None]:
    """Name and X_WO [mm], None for the identity."""
    node = args.value("wobj")
    if node is None:
        return "wobj0", None
    name = run.text(node)
    robhold, fixed, unit, uframe, oframe = evaluate(run, node, WOBJDATA).data
    if robhold:
        raise run.error(node, f"work object {name} is held by the robot (robhold TRUE), which is not supported")
    if not fixed:
        raise run.error(node, f"work object {name} rides on the unit '{unit}' (ufprog FALSE), which is not supported")
    if _identity(uframe) and _identity(oframe):
        return name, None
    (up, uq), (op, oq) = uframe, oframe
    uq = orientation(run, uq, f"uframe of {name}", node, run.file)
    oq = orientation(run, oq, f"oframe of {name}", node, run.file)
    return name, frames.compose((up, uq), (op, oq))


def _tool(run: Run, node: Expression) -> Tool:
    name = run.text(node)
    robhold, tframe, _ = evaluate(run, node, TOOLDATA).data
    if not robhold:
        raise run.error(node, f"tool {name} is stationary (robhold FALSE), which is not supported")
    p, q = tframe
    q = orientation(run, q, f"tframe of {name}", node, run.file)
    X_FT = np.eye(4)
    X_FT[:3, :3] = frames.matrix(q)
    X_FT[:3, 3] = [value * MM for value in p]
    return Tool(name, X_FT)


# ----------------------------------------------------------------------------------------------- speed and accuracy


def _speed(run: Run, node: Expression, args: Arguments, external: bool = False) -> Speed:
    r"""Speed in SI; \V replaces the TCP speed."""
    name = run.text(node)
    v_tcp, v_ori, v_leax, v_reax = evaluate(run, node, SPEEDDATA).data
    override = args.value("v")
    if override is not None:
        v_tcp = number(run, override)
    load = args.value("tload")
    if load is not None:
        evaluate(run, load, LOADDATA)
    if not external and args.value("t") is None and not v_tcp > 0:
        raise run.error(override or node, f"TCP speed {v_tcp:.6g} mm/s of {name} must be above 0")
    speeds = (v_tcp * MM, v_ori * DEG, v_leax * MM, v_reax * DEG)
    if not all(isfinite(v) and v >= 0 for v in speeds):
        raise run.error(node, f"speeddata {name} has a negative speed")
    return Speed(name, *speeds)


def _duration(run: Run, args: Arguments) -> float | None:
    node = args.value("t")
    if node is None:
        return None
    seconds = number(run, node)
    if not seconds > 0:
        raise run.error(node, f"duration \\T:={seconds:.6g} s must be above 0")
    return seconds


def _zone(run: Run, node: Expression, args: Arguments) -> Zone:
    r"""Accuracy; \Inpos makes a stop of any zone, \Z replaces the radius."""
    name = run.text(node)
    finep, radius = evaluate(run, node, ZONEDATA).data[:2]
    stop_point = args.value("inpos")
    if "inpos" in args.optional:
        if not isinstance(stop_point, Name) or stop_point.name.lower() not in _STOP_POINTS:
            raise run.error(
                stop_point or node, f"\\Inpos takes one of {', '.join(_STOP_POINTS)}; others are not supported"
            )
        return Zone(name, stop=True)
    if finep:
        return Zone(name, stop=True)
    override = args.value("z")
    if override is not None:
        radius = number(run, override)
    if not radius >= 0:
        raise run.error(override or node, f"zone radius {radius:.6g} mm must not be negative")
    return Zone(name, stop=False, radius=radius * MM)


INSTRUCTIONS: dict[str, Instruction] = {
    "MoveJ": move_j,
    "MoveL": move_l,
    "MoveAbsJ": move_abs_j,
    "MoveExtJ": move_ext_j,
}
