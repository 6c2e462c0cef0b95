"""Program displacement (PDisp) and offsets of external axes (EOffs).

W = U O D P: D maps a programmed point to where it is to be now, both seen from the object frame. A displacement
replaces the one before it. The points given to PDispOn and EOffsOn are read as if none were active.
"""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import POSE, Data
from trajopt_cli.rapid.data.frames import IDENTITY
from trajopt_cli.rapid.execution.arguments import Effect, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import current_target, read_at_rest
from trajopt_cli.rapid.execution.equipment import orientation, setup_of
from trajopt_cli.rapid.execution.instructions.moves import NO_POSITION, robtarget
from trajopt_cli.rapid.execution.instructions.settings import change
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall


def _pose(run: Context, node: Expression) -> frames.Frame:
    data = run.evaluate(node, POSE).data
    written = data != POSE.default
    return data[0], orientation(run, data[1], run.text(node), node, run.file, written)


_TOPIC = Topic(__doc__, frame=_pose)


def _displace(run: Context, displacement: frames.Frame) -> None:
    active = displacement != IDENTITY
    run.position.displacement = displacement if active else None
    change(run, replace(run.settings, displaced=active))


@_TOPIC.instruction(Effect.RUN, r"PDispOn ProgPoint Tool \Rot \ExeP:expr \WObj:expr")
def _on(
    run: Context,
    node: ProcedureCall,
    point: Expression,
    tool: Expression,
    rot: bool = False,
    exep: Expression | None = None,
    wobj: Expression | None = None,
) -> None:
    r"""PDispOn [\Rot] [\ExeP] ProgPoint, Tool [\WObj]: ProgPoint comes to ExeP, or to where the robot is."""
    setup = setup_of(run, tool, wobj, displaced=False)
    programmed = robtarget(run, point).frame
    if exep is None:
        read_at_rest(run, node, "PDispOn reads where the robot is")
    place = current_target(run, node, "PDispOn", setup) if exep is None else robtarget(run, exep).frame
    if rot:
        _displace(run, frames.compose(place, frames.inverse(programmed)))
        return
    (ax, ay, az), (bx, by, bz) = programmed[0], place[0]
    _displace(run, ((bx - ax, by - ay, bz - az), IDENTITY[1]))


@_TOPIC.instruction(Effect.RUN, "PDispSet DispFrame:frame", "PDispOff")
def _set(run: Context, node: ProcedureCall, frame: frames.Frame = IDENTITY) -> None:
    """PDispSet DispFrame; PDispOff."""
    _displace(run, frame)


@_TOPIC.instruction(Effect.RUN, "PDispAdd DispFrame:frame")
def _add(run: Context, node: ProcedureCall, frame: frames.Frame) -> None:
    """PDispAdd DispFrame: behind the displacement that is active, D := D DispFrame."""
    _displace(run, frames.compose(run.position.displacement or IDENTITY, frame))


@_TOPIC.instruction(Effect.RUN, r"EOffsOn ProgPoint:robtarget \ExeP:robtarget")
def _offset_on(run: Context, node: ProcedureCall, programmed: Data, exep: Data = None) -> None:
    r"""EOffsOn [\ExeP] ProgPoint: the difference of the external axes; 0 for one that has no position."""
    if exep is None:
        read_at_rest(run, node, "EOffsOn reads where the robot is")
        there = tuple(NO_POSITION * 2 if value is None else value for value in run.units.driven(run.position.extax))
    else:
        there = exep[3]
    pairs = zip(there, programmed[3], strict=True)
    known = tuple(0.0 if max(abs(now), abs(was)) > NO_POSITION else now - was for now, was in pairs)
    _offset(run, node, known)


@_TOPIC.instruction(Effect.RUN, "EOffsSet EAxOffs:extjoint", "EOffsOff")
def _offset(run: Context, node: ProcedureCall, values: Data = (0.0,) * 6) -> None:
    a, b, c, d, e, f = (0.0 if abs(value) > NO_POSITION else value for value in values)
    change(run, replace(run.settings, eax_offset=(a, b, c, d, e, f)))
