r"""SearchJ, SearchL and SearchC: moves that stop or note where they are when a signal comes.

Where the signal comes only the user knows: scenario.searches gives it as a share of the way.
"""

from __future__ import annotations

from contextlib import suppress

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.motion import ExternalAxes, Move, MoveC, MoveJ, MoveL, Process
from trajopt_cli.path.arc import Arc
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import ROBTARGET, Value
from trajopt_cli.rapid.data.frames import between, frame, matrix
from trajopt_cli.rapid.execution.arguments import Arguments, Effect, Topic, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import current_joints, current_target, reach, read_at_rest, the_robot
from trajopt_cli.rapid.execution.equipment import setup_of
from trajopt_cli.rapid.execution.instructions.moves import Asked, PoseKind, Target, robtarget, to_pose
from trajopt_cli.rapid.execution.position import Setup
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

_STIFF = 0.1 + 1e-9  # m/s
_STOPS = ("stop", "pstop", "sstop")
_FLANKS = ("Flanks", "PosFlank", "NegFlank", "HighLevel", "LowLevel")


_TOPIC = Topic(__doc__)


def _enter(name: str, kind: PoseKind) -> None:
    via = kind.via
    required = ("Signal", "SearchPoint", *via, "ToPoint", "Speed", "Tool")
    options = ("Stop", "PStop", "SStop", "Sup", *_FLANKS, "ID", "V", "T", "WObj", "Corr", "TLoad")

    @_TOPIC.enter(Effect.PLANNED, name)
    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, required, options)
        signal, searched, *points, speed, tool = args.required
        point, circle = points[-1], points[0] if via else None
        request = Asked(point, speed, None, tool, Arguments((), args.optional), circle)
        process = Process(name, (("Signal", run.text(signal)), ("SearchPoint", run.text(searched))))
        share = _share(run, node, signal, searched)
        setup = setup_of(run, tool, args.optional.get("wobj"))
        end = robtarget(run, point)
        read_at_rest(run, node, f"{name} begins where the robot is")
        if share is None:
            to_pose(run, node, kind, request, process=process)
            what = f"{name} finds nothing on its way, as the cell file says for '{run.text(signal)}'"
            raise run.fault(node, "ERR_WHLSEARCH", what)
        hit = _hit(run, node, kind, setup, circle, end, share)
        if any(stop in args.optional for stop in _STOPS):
            target = Target(hit.frame, hit.conf, hit.extax, Value(ROBTARGET, end.value.data))
            half = _hit(run, node, kind, setup, circle, end, share / 2).frame if circle else None
            to_pose(run, node, kind, request, process=process, target=target, via=half)
            _tell_stop(run, node, args)
        else:
            to_pose(run, node, kind, request, process=process)
            what = f"{name} without \\Stop, \\PStop or \\SStop does not stop at the hit: it goes on to ToPoint"
            run.note("flying search", WarningKind.ASSUMED, what, node)
        run.assign(searched, hit.value)


for name, kind in (("SearchJ", MoveJ), ("SearchL", MoveL), ("SearchC", MoveC)):
    _enter(name, kind)


def _tell_stop(run: Context, node: ProcedureCall, args: Arguments) -> None:
    """What a controller makes of the stop of the last motion, a search (RAPID, SearchL)."""
    move = run.motions[-1]
    if "stop" in args.optional and isinstance(move, Move) and move.speed.v_tcp > _STIFF:
        what = f"{node.name} \\Stop is allowed below 100 mm/s only, found {move.speed.v_tcp / MM:.6g} mm/s"
        run.warn(WarningKind.UNUSUAL, f"{what}: search more slowly, or with \\PStop", run.source(node))
    what = f"{node.name} ends at the hit; a controller stops behind it and stays there (at 50 mm/s 1 to 3 mm "
    what = f"{what}with \\Stop, 4 to 8 with \\SStop, 15 to 25 with \\PStop)"
    run.note("search stop", WarningKind.ASSUMED, what, node)


def _share(run: Context, node: ProcedureCall, signal: Expression, searched: Expression) -> float | None:
    """Where the signal comes, as a share of the way; None for never."""
    known = {name.lower(): share for name, share in run.scenario.searches.items()}
    keys = [run.text(argument).lower() for argument in (searched, signal)]
    for key in keys:
        run.external.asked("searches", key)
        run.external.asked("signals", key)
    found = [known[key] for key in keys if key in known]
    if found:
        return found[0]
    named = searched if isinstance(searched, Name) else signal
    name = run.text(named)
    ends = f"{node.name} ends where '{run.text(signal)}' changes"
    reason = f"{ends}, which the program does not tell; say after what share of the way"
    run.missing("searches", name, node, reason, "0.5")
    return 0.5


def _hit(
    run: Context,
    node: ProcedureCall,
    kind: PoseKind,
    setup: Setup,
    circle: Expression | None,
    end: Target,
    share: float,
) -> Target:
    """The place at a share of the way, as a target of the setup."""
    position, name = run.position, node.name
    before = position.extax
    extax_1 = run.units.driven(end.extax)
    extax = _share_of(before, extax_1, share)
    conf = end.conf
    place: frames.Frame
    if kind is MoveJ:
        robot = the_robot(run, node, name)
        q_0 = current_joints(run, node, name)
        flange = setup.flange(end.frame)
        q_1 = reach(run, node, f"ToPoint of {name}", robot, flange, conf, run.settings.conf_j, extax_1, q_0)
        q = q_0 + share * (q_1 - q_0)
        place, conf = setup.target(frame(robot.forward(q, extax))), robot.confdata(q)
    else:
        start = current_target(run, node, name, setup)
        place = between(start, end.frame, share)
        if circle is not None:
            points = start, robtarget(run, circle).frame, end.frame
            with suppress(InputError):  # no circle, which is refused where it is planned
                X_0, X_V, X_1 = (matrix(point) for point in points)
                arc = Arc.through(X_0, X_V, X_1, run.settings.circle)
                place = frame(arc.pose(np.array([share]))[0])
    written = tuple(float(part) for part in (conf.cf1, conf.cf4, conf.cf6, conf.cfx))
    offsets = run.settings.eax_offset
    axes = tuple(9e9 if value is None else value - more for value, more in zip(extax, offsets, strict=True))
    return Target(place, conf, extax, Value(ROBTARGET, (*place, written, axes)))


def _share_of(start: ExternalAxes, end: ExternalAxes, share: float) -> ExternalAxes:
    """External axes on the way; one whose start or end is open stays what is known of it."""
    return tuple(
        last if first is None else first if last is None else first + share * (last - first)
        for first, last in zip(start, end, strict=True)
    )
