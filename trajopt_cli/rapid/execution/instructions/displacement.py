"""Program displacement (PDisp) and offsets of external axes (EOffs).

W = U O D P: D maps a programmed point to where it is to be now, both seen from the object frame. A displacement
replaces the one before it. The points given to PDispOn and EOffsOn are read as if none were active.
"""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import EXTJOINT, POSE, ROBTARGET, Data
from trajopt_cli.rapid.data.frames import IDENTITY
from trajopt_cli.rapid.execution.arguments import bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import current_target, read_at_rest
from trajopt_cli.rapid.execution.equipment import orientation, setup_of
from trajopt_cli.rapid.execution.instructions.effect import Effect, Topic
from trajopt_cli.rapid.execution.instructions.moves import NO_POSITION, robtarget
from trajopt_cli.rapid.execution.instructions.settings import change
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall


def _displace(run: Context, displacement: frames.Frame) -> None:
    active = displacement != IDENTITY
    run.position.displacement = displacement if active else None
    change(run, replace(run.settings, displaced=active))


def _on(run: Context, node: ProcedureCall) -> None:
    r"""PDispOn [\Rot] [\ExeP] ProgPoint, Tool [\WObj]: ProgPoint comes to ExeP, or to where the robot is."""
    args = bind(run, node, ("ProgPoint", "Tool"), ("Rot", "ExeP", "WObj"))
    point, tool = args.required
    setup = setup_of(run, tool, args.value("wobj"), displaced=False)
    programmed, actual = robtarget(run, point).frame, args.value("exep")
    if actual is None:
        read_at_rest(run, node, "PDispOn reads where the robot is")
    place = current_target(run, node, "PDispOn", setup) if actual is None else robtarget(run, actual).frame
    if "rot" in args.optional:
        _displace(run, frames.compose(place, frames.inverse(programmed)))
        return
    (ax, ay, az), (bx, by, bz) = programmed[0], place[0]
    _displace(run, ((bx - ax, by - ay, bz - az), IDENTITY[1]))


def _pose(run: Context, node: Expression) -> frames.Frame:
    data = run.evaluate(node, POSE).data
    written = data != POSE.default
    return data[0], orientation(run, data[1], run.text(node), node, run.file, written)


def _set(run: Context, node: ProcedureCall) -> None:
    """PDispSet DispFrame."""
    (argument,) = bind(run, node, ("DispFrame",)).required
    _displace(run, _pose(run, argument))


def _add(run: Context, node: ProcedureCall) -> None:
    """PDispAdd DispFrame: behind the displacement that is active, D := D DispFrame."""
    (argument,) = bind(run, node, ("DispFrame",)).required
    _displace(run, frames.compose(run.position.displacement or IDENTITY, _pose(run, argument)))


def _off(run: Context, node: ProcedureCall) -> None:
    bind(run, node, ())
    _displace(run, IDENTITY)


def _offset(run: Context, values: Data) -> None:
    a, b, c, d, e, f = (0.0 if abs(value) > NO_POSITION else value for value in values)
    change(run, replace(run.settings, eax_offset=(a, b, c, d, e, f)))


def _offset_on(run: Context, node: ProcedureCall) -> None:
    r"""EOffsOn [\ExeP] ProgPoint: the difference of the external axes; 0 for one that has no position."""
    args = bind(run, node, ("ProgPoint",), ("ExeP",))
    programmed, actual = run.evaluate(args.required[0], ROBTARGET).data[3], args.value("exep")
    if actual is not None:
        there = run.evaluate(actual, ROBTARGET).data[3]
    else:
        read_at_rest(run, node, "EOffsOn reads where the robot is")
        there = tuple(NO_POSITION * 2 if value is None else value for value in run.units.driven(run.position.extax))
    pairs = zip(there, programmed, strict=True)
    _offset(run, tuple(0.0 if max(abs(now), abs(was)) > NO_POSITION else now - was for now, was in pairs))


def _offset_set(run: Context, node: ProcedureCall) -> None:
    (argument,) = bind(run, node, ("EAxOffs",)).required
    _offset(run, run.evaluate(argument, EXTJOINT).data)


def _offset_off(run: Context, node: ProcedureCall) -> None:
    bind(run, node, ())
    _offset(run, (0.0,) * 6)


INSTRUCTIONS: Topic = {
    Effect.RUN: {
        "PDispOn": _on,
        "PDispSet": _set,
        "PDispAdd": _add,
        "PDispOff": _off,
        "EOffsOn": _offset_on,
        "EOffsSet": _offset_set,
        "EOffsOff": _offset_off,
    }
}
