r"""MoveJ, MoveL, MoveC, MoveAbsJ and MoveExtJ: arguments to motions in SI units.

External axes move the base under a robtarget and never the target; a jointtarget takes the target along. What other
instructions that move have in common with these is here too: to_pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, dist
from typing import Any, NamedTuple

import numpy as np

from trajopt_cli.motion import (
    ConfData,
    ExternalAxes,
    Happens,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    MoveL,
    PathEvent,
    PoseMove,
    Process,
    Span,
    Speed,
    Tool,
    UnitMove,
    Written,
    Zone,
)
from trajopt_cli.path.circle import circle_through
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import JOINTTARGET, ROBTARGET, Data, Value
from trajopt_cli.rapid.data.frames import IDENTITY, matrix
from trajopt_cli.rapid.execution.arguments import Arguments, Effect, Topic, bind
from trajopt_cli.rapid.execution.construction import made, maker
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import settle_before
from trajopt_cli.rapid.execution.equipment import orientation, turned, value_of
from trajopt_cli.rapid.execution.instructions.motion_settings import duration_of, manner, speed_of, zone_of
from trajopt_cli.rapid.execution.instructions.multimove import together
from trajopt_cli.rapid.execution.position import Setup
from trajopt_cli.rapid.execution.positioners import driven_axes, kept_axes, moved
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall
from trajopt_cli.units import DEG
from trajopt_cli.warnings import WarningKind

NO_POSITION = 8.9e9  # RAPID's 9E9, with room for rounding
_NEAR = 0.1  # mm; a controller refuses circles with points nearer than this
_MOST_CONCURRENT = 5  # RAPID, argument \Conc
_WIDEST_ARC = 240.0  # deg; beyond it a controller calls the circle uncertain

POSE_OPTIONS = ("Conc", "ID", "V", "T", "Z", "Inpos", "WObj", "Corr", "TLoad")
_JOINT_OPTIONS = ("Conc", "ID", "NoEOffs", "V", "T", "Z", "Inpos", "WObj", "TLoad")
_EXTERNAL_OPTIONS = ("Conc", "ID", "UseEOffs", "T", "Inpos")

PoseKind = type[PoseMove]
_TOPIC = Topic(__doc__)


class Target(NamedTuple):
    """A robtarget as read: its frame [mm], orientation at length 1, external axes with offsets. value: as evaluated."""

    frame: frames.Frame
    conf: ConfData
    extax: ExternalAxes
    value: Value


_target = maker(Target)


class Asked(NamedTuple):
    """The arguments of an instruction that moves to a pose. zone None: a stop."""

    point: Expression
    speed: Expression
    zone: Expression | None
    tool: Expression
    args: Arguments
    via: Expression | None = None


_asked = maker(Asked)


def asked(args: Arguments, via: bool) -> Asked:
    """[CirPoint], ToPoint, Speed, Zone, Tool in this order; more may follow."""
    if via:
        circle, point, speed, zone, tool, *_ = args.required
        return Asked(point, speed, zone, tool, args, circle)
    point, speed, zone, tool, *_ = args.required
    return _asked((point, speed, zone, tool, args, None))


def _enter(name: str, kind: PoseKind) -> None:
    """MoveJ, MoveL or MoveC."""
    via = kind.via

    @_TOPIC.enter(Effect.PLANNED, name)
    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, (*via, "ToPoint", "Speed", "Zone", "Tool"), POSE_OPTIONS)
        to_pose(run, node, kind, asked(args, via=bool(via)))


for name, kind in (("MoveJ", MoveJ), ("MoveL", MoveL), ("MoveC", MoveC)):
    _enter(name, kind)


def check_joints(run: Context, point: Expression, robax: Sequence[float]) -> None:
    """Raise InputError for a jointtarget that leaves an axis of the arm open."""
    for axis, value in enumerate(robax, 1):
        if abs(value) > NO_POSITION:
            raise run.error(point, f"jointtarget {run.text(point)} gives no position for axis {axis} (9E9)")


@_TOPIC.enter(Effect.PLANNED, "MoveAbsJ")
def _move_abs_j(run: Context, node: ProcedureCall) -> None:
    """MoveAbsJ ToJointPos, Speed, Zone, Tool. Work object and displacement mean nothing to joints."""
    args = bind(run, node, ("ToJointPos", "Speed", "Zone", "Tool"), _JOINT_OPTIONS)
    point, speed, zone, tool = args.required
    target = run.evaluate(point, JOINTTARGET)
    how = manner(run, speed, zone, tool, args)
    robax = target.data[0]
    check_joints(run, point, robax)
    setup = how.setup
    motion = MoveAbsJ(
        **_of_joints(run, node, args, target, how.speed, how.zone, how.duration, "noeoffs" not in args.optional),
        q=np.array(robax) * DEG,
        tool=setup.tool or Tool(setup.name, matrix(setup.base or IDENTITY), stationary=True),
        wobj=setup.wobj if "wobj" in args.optional else None,
    )
    _succession(run, node, args)
    run.motions.append(motion)
    run.position.to_joints(setup, motion.q, motion.extax)


@_TOPIC.enter(Effect.PLANNED, "MoveExtJ")
def _move_ext_j(run: Context, node: ProcedureCall) -> None:
    """MoveExtJ ToJointPos, Speed, Zone."""
    args = bind(run, node, ("ToJointPos", "Speed", "Zone"), _EXTERNAL_OPTIONS)
    point, speed, zone = args.required
    target = run.evaluate(point, JOINTTARGET)
    caps, duration = speed_of(run, speed, args, external=True), duration_of(run, args)
    accuracy = zone_of(run, zone, args)
    motion = MoveExtJ(**_of_joints(run, node, args, target, caps, accuracy, duration, "useeoffs" in args.optional))
    _succession(run, node, args)
    run.motions.append(motion)
    run.position.to_extax(motion.extax)


def _of_joints(
    run: Context,
    node: ProcedureCall,
    args: Arguments,
    target: Value,
    speed: Speed,
    zone: Zone,
    duration: float | None,
    offset: bool,
) -> dict[str, Any]:
    """What moves to a jointtarget have in common. offset: whether EOffs adds to its external axes."""
    point = args.required[0]
    at = driven_axes(run, point, external(run, target.data[1], offset=offset))
    number, partner = together(run, node, args)
    return {
        "source": run.source(node),
        "written": written(run, node, point),
        "target": run.text(point),
        "speed": speed,
        "zone": zone,
        "extax": at,
        "duration": duration,
        "optional": marked(run, node),
        "marked": run.ways.get((run.file, node.start), ()) if run.ways else (),
        "settings": run.settings,
        "units": moved(run, point, at, speed, None, duration is not None),
        "identity": number,
        "partner": partner,
    }


def to_pose(
    run: Context,
    node: ProcedureCall,
    kind: PoseKind,
    asked: Asked,
    *,
    events: tuple[PathEvent, ...] = (),
    process: Process | None = None,
    speed: Speed | None = None,
    target: Target | None = None,
    via: frames.Frame | None = None,
) -> None:
    """Append the motion of an instruction that moves to a pose, and stand there.

    speed: in place of the instruction's own. target, via: in place of ToPoint and CirPoint.
    """
    point, args = asked.point, asked.args
    if target is None:
        target = robtarget(run, point)
    setup, caps, zone, duration = manner(run, asked.speed, asked.zone, asked.tool, args, speed)
    number, partner = together(run, node, args)
    place, conf, extax, _ = target
    extax = driven_axes(run, point, extax)
    _check_unit(run, node, setup)
    units: tuple[UnitMove, ...] = ()
    before = setup
    if run.scenario.positioners:
        units = moved(run, point, extax, caps, setup.unit, duration is not None)
        before = turned(run, setup, run.position.extax)
        setup = turned(run, setup, kept_axes(run, extax))
    placed = setup.placed(place)
    x, y, z = placed[0]
    if not (abs(x) < NO_POSITION and abs(y) < NO_POSITION and abs(z) < NO_POSITION):
        shown = ", ".join(f"{value:.6g}" for value in placed[0])
        raise run.error(point, f"{run.text(point)} has no position: trans is [{shown}] mm")
    settings = run.settings
    parts = {  # fields at their defaults aside
        "source": run.source(node),
        "written": written(run, node, point),
        "target": run.text(point),
        "speed": caps,
        "zone": zone,
        "extax": extax,
        "duration": duration,
        "optional": marked(run, node),
        "marked": run.ways.get((run.file, node.start), ()) if run.ways else (),
        "settings": settings,
        "events": events,
        "process": process,
        "units": units,
        "identity": number,
        "partner": partner,
        "conf": conf,
        "tool": setup.tool or Tool(setup.name, matrix(placed), stationary=True),
        "wobj": setup.wobj,
        "X_WO": setup.X_WO,
    }
    if asked.via is not None:
        through = via or robtarget(run, asked.via).frame
        _check_circle(run, asked.via, point, run.position.known_target(before), through, place)
        # A stationary tool's via point as the flange passes it: X_WF = X_WV inv(X_FT) there too.
        parts["X_WV"] = matrix(setup.placed(through) if setup.tool else frames.compose(setup.flange(through), placed))
    motion = made(kind, parts)
    _succession(run, node, args)
    run.motions.append(motion)
    counts = settings.conf_j if kind is MoveJ else settings.conf_l
    run.position.to_pose(setup, place, conf, counts, extax, line=kind is MoveL)
    for event in events:
        if event.kind is Happens.SIGNAL and event.value is not None:
            run.rail_places.set(event.name, event.value)
    run.position.unplaced.append((motion, placed if setup.tool else setup.tcp))
    if duration is not None and kind is MoveL and run.scenario.settle.counts:
        settle_before(run)


def _succession(run: Context, node: ProcedureCall, args: Arguments) -> None:
    r"""\Conc: what follows runs while the robot moves; at most five moves in succession may have it."""
    run.concurrent = run.concurrent + 1 if "conc" in args.optional else 0
    if run.concurrent and run.stored:
        raise run.error(node, "\\Conc is not allowed between StorePath and RestoPath; leave it out")
    if run.concurrent > _MOST_CONCURRENT:
        message = f"more than {_MOST_CONCURRENT} moves in succession with \\Conc; leave it out of this one"
        raise run.fault(node, "ERR_CONC_MAX", message)


def _check_unit(run: Context, node: ProcedureCall, setup: Setup) -> None:
    """Refuse a move on a work object that moves by itself."""
    unit = "" if setup.wobj_data[1] else str(setup.wobj_data[2])
    if unit and run.units.moves_by_itself(unit):
        what = f"{node.name} goes to a target on work object {setup.wobj}, which {unit} moves, and the program "
        what += "does not say how fast; plan the motions between such moves on their own (--entry)"
        run.refuse("moving work objects", node, what)


def _check_circle(
    run: Context, node: Expression, end: Expression, start: frames.Frame | None, via: frames.Frame, place: frames.Frame
) -> None:
    """The three points must be apart. start None: only the robot knows, and the check waits for it."""
    at, through, to = None if start is None else start[0], run.text(node), run.text(end)
    pairs = ((through, via[0], to, place[0]), ("the start", at, through, via[0]), ("the start", at, to, place[0]))
    for one, p, other, q in pairs:
        if p is not None and dist(p, q) < _NEAR:
            message = f"the circle is not determined: {one} and {other} are {dist(p, q):.3g} mm apart, least {_NEAR} mm"
            raise run.error(node, f"{message}; move one of them, or use MoveL")
    if at is None:
        return
    circle = circle_through(at, via[0], place[0])
    if circle is None:
        run.warn(WarningKind.UNUSUAL, f"start, {through} and {to} lie on one line, not on a circle", run.source(node))
    elif degrees(circle.angle) > _WIDEST_ARC:
        what = f"the arc through {through} is {degrees(circle.angle):.4g} deg long; "
        what += f"a controller takes at most {_WIDEST_ARC:g} deg, so divide it in two"
        run.warn(WarningKind.UNUSUAL, what, run.source(node))


def written(run: Context, node: ProcedureCall, point: Expression) -> Written:
    """Where the parts of an instruction stand in the text."""
    file = run.file
    statement, target = _span((file, node.start, node.end)), _span((file, point.start, point.end))
    return _written((statement, target, run.frame.counters))


_span, _written = maker(Span), maker(Written)


def marked(run: Context, node: ProcedureCall) -> bool:
    """Whether a comment marks the move as one that may be dropped."""
    return bool(run.optional) and (run.file, node.start) in run.optional


# ------------------------------------------------------------------------------------------------------ the target


def robtarget(run: Context, node: Expression) -> Target:
    """A robtarget. Raises InputError for an orientation or a configuration that is none, at its literal."""
    value = value_of(run, node, ROBTARGET)
    (x, y, z), q, conf, extax = value.data
    w, i, j, k = q
    if abs(w * w + i * i + j * j + k * k - 1.0) > _UNIT:
        literal = value.origin
        where, file = (literal.literal, literal.file) if literal else (node, run.file)
        q = orientation(run, q, run.text(node), where, file)
    return _target((((x, y, z), q), _configuration(run, node, conf), external(run, extax), value))


def _configuration(run: Context, point: Expression, conf: Data) -> ConfData:
    known = _CONFIGURATIONS.get(conf)
    if known is None:
        if any(abs(value) > NO_POSITION or value != int(value) for value in conf):
            shown = ",".join(f"{value:.6g}" for value in conf)
            raise run.error(point, f"{run.text(point)} has confdata [{shown}]; it takes four whole numbers")
        known = ConfData(*(int(value) for value in conf))
        if len(_CONFIGURATIONS) < _MANY:
            _CONFIGURATIONS[conf] = known
    return known


_UNIT = 1e-12  # of a squared length: rounding of the 16th digit, which nobody has to say or to mend
_CONFIGURATIONS: dict[Data, ConfData] = {}
_MANY = 4096


def external(run: Context, extax: Data, offset: bool = True) -> ExternalAxes:
    """External axes as the controller drives them. offset: whether EOffs adds to them."""
    offsets = run.settings.eax_offset
    if offset and offsets != _NO_OFFSET:
        extax = [value + more for value, more in zip(extax, offsets, strict=True)]
    a, b, c, d, e, f = extax
    return (
        None if a > NO_POSITION or a < -NO_POSITION else a,
        None if b > NO_POSITION or b < -NO_POSITION else b,
        None if c > NO_POSITION or c < -NO_POSITION else c,
        None if d > NO_POSITION or d < -NO_POSITION else d,
        None if e > NO_POSITION or e < -NO_POSITION else e,
        None if f > NO_POSITION or f < -NO_POSITION else f,
    )


_NO_OFFSET = (0.0,) * 6
