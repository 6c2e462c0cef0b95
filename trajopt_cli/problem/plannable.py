"""What a program asks for that no plan can keep yet: said before any work, so that nothing is planned as if not asked.

Programs are read whole (arcs, stationary tools, AccSet, ...); this is where planning ends.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

import numpy as np

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.geometry import inverse_pose
from trajopt_cli.motion import (
    CirPathMode,
    Hold,
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    PathMove,
    PoseMove,
    Program,
    Refusal,
    SignalEvent,
    Singularity,
    Wait,
    motion_name,
    turned_under,
)
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.starts import Starts
from trajopt_cli.rapid.zones import stopped_fly_bys
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.structure import NO_CONFDATA
from trajopt_cli.scenario import Follower, Lines
from trajopt_cli.units import MM, unit_of

SHOWN = 20  # lines of one error; a program of a thousand arcs needs no thousand lines
_SHOWN_IDS = 3
_METRES = 10.0  # mm: 10 m, farther than any cell reaches
STILL = 0.1  # mm or deg: backups hold measured values of axes that stand
_STOP_POINTS = ("inpos20", "inpos50", "inpos100")  # stop points without a time of their own


def refusals(program: Program, plant: Plant) -> tuple[Refusal, ...]:
    """What no plan can keep, in program order; a statement that runs many times is named once per thing it asks for."""
    found = {(one.source, one.kind): one for one in program.refusals}
    axes, starts = _OtherAxes(plant), Starts(plant)
    for motion in program.motions:
        if isinstance(motion, Wait | SignalEvent):
            continue
        for kind, demand, advice in (*_demands(motion), *axes.demands(motion), *starts.wrong(motion)):
            key = (motion.source, kind)
            found.setdefault(key, Refusal(kind, motion.source, f"{motion_name(motion)} {demand}; {advice}"))
    return tuple(found.values())


def check_plannable(program: Program, plant: Plant) -> None:
    """Raise an InputErrorGroup that names each motion no plan can keep, what it asks for, and what to do."""
    found = refusals(program, plant)
    errors = [
        InputError(one.message, file=one.source.file, line=one.source.line, column=one.source.column)
        for one in found[:SHOWN]
    ]
    if rest := Counter(one.kind for one in found[SHOWN:]):
        told = ", ".join(f"{kind} {count}" for kind, count in rest.items())
        errors.append(InputError(f"and {rest.total()} more that cannot be planned: {told}"))
    if errors:
        raise InputErrorGroup(errors)


def target_doubts(program: Program, plant: Plant) -> tuple[str, ...]:
    """What is odd about the targets: places in metres, another axis than the rail, no place for the rail."""
    return (*_metre_doubts(program), *_rail_doubts(program, plant))


def _metre_doubts(program: Program) -> tuple[str, ...]:
    """Targets that all lie within millimetres of their work objects' origins, at fractions of one."""
    moves = [motion for motion in program.motions if isinstance(motion, PoseMove) and motion.X_WO is not None]
    places = [(inverse_pose(move.X_WO) @ move.X_WT)[:3, 3] / MM for move in moves if move.X_WO is not None]
    if len({tuple(place.round(6)) for place in places}) < 2 or np.max(np.abs(places)) > _METRES:
        return ()
    if np.allclose(places, np.round(places), atol=1e-6):
        return ()
    first, place = moves[0], " ".join(f"{value:g}" for value in places[0])
    text = f"{first.source}: {first.target} lies at {place} mm, and all other targets within {_METRES:g} mm of their"
    return (f"{text} work objects' origins: if metres are meant, write millimetres",)


def _rail_doubts(program: Program, plant: Plant) -> tuple[str, ...]:
    if not plant.rail_eaxes:
        return ()
    moves = [motion for motion in program.motions if isinstance(motion, Move) and motion.hold is not Hold.UNIT]
    letters = "abcdef"
    given = [letters[i] for i in range(6) if any(move.extax[i] is not None for move in moves)]
    return tuple(
        _rail_doubt(axis, moves, given) for axis in plant.rail_eaxes if any(m.extax[axis] is None for m in moves)
    )


def _rail_doubt(axis: int, moves: Sequence[Move], given: Sequence[str]) -> str:
    """What to know of a rail for which some moves give no position."""
    letter = "abcdef"[axis]
    if given and letter not in given:
        axes = f"external ax{'es' if len(given) > 1 else 'is'} {' and '.join(given)}"
        return f"targets give {axes}, the cell's rail is axis {letter}, for which none gives a value"
    open_ = dict.fromkeys(move.source for move in moves if move.extax[axis] is None)
    n, place = len(open_), next(iter(open_))
    targets = f"{n} target{'s give' if n > 1 else ' gives'} no position for the rail (9E9 on axis {letter})"
    return f"{place}: {targets}: a controller stops, a plan stays"


def planned_otherwise(program: Program, loads_count: bool = False) -> tuple[str, ...]:
    """What a plan takes lightly, one line each: for those who read its times. loads_count: torques are limited, so
    what the gripper holds is no such thing."""
    moves = [motion for motion in program.motions if not isinstance(motion, Wait | SignalEvent)]
    lines = []
    off = {
        (r"on lines (ConfL \Off)" if isinstance(move, PathMove) else r"on joint moves (ConfJ \Off)"): None
        for move in moves
        if not _monitored(move) and isinstance(move, PoseMove)
    }
    if off:
        lines.append(f"confdata is ignored {' and '.join(sorted(off))}, as the program asks")
    if lines_at := sum(isinstance(move, PathMove) and move.settings.singularity is Singularity.WRIST for move in moves):
        lines.append(
            f"lines that may leave their orientation (SingArea \\Wrist, {lines_at}) are planned with the exact one"
        )
    if uneven := sum(isinstance(m, MoveC) and m.settings.circle is CirPathMode.CIR_POINT_ORI for m in moves):
        lines.append(
            f"arcs under CirPathMode \\CirPointOri ({uneven}) are planned as a smooth turn through the circle point's"
            " orientation: how a controller turns between the points is not published"
        )
    if ramps := sum(move.settings.ramp < 1.0 for move in moves):
        lines.append(
            f"AccSet's ramp ({ramps}) does not affect the plan: it shapes jerk, which the cell file alone limits"
        )
    stops = stopped_fly_bys(program)
    passed = [not m.zone.stop and i not in stops for i, m in enumerate(program.motions) if isinstance(m, Move)]
    ends = zip(moves, [False, *passed], passed, strict=False)  # before each move, and at its end
    if timed := sum(move.duration is not None and (before or end) for move, before, end in ends):
        lines.append(f"programmed times (\\T, {timed}) of moves beside a fly-by are planned as the speeds they make")
    if beside := [one.beside for one in program.motions if isinstance(one, Wait) and one.beside]:
        lines.append(f"waits behind \\Conc ({len(beside)}, {sum(beside):g} s) run beside their moves")
    if open_ := [move for move in moves if move.identity is not None and move.partner is None]:
        lines.append(unpartnered(open_))
    if events := sum(len(move.events) for move in moves):
        lines.append(f"path events ({events}) take no time and do not affect the plan")
    if written := Counter(move.process.instruction for move in moves if move.process is not None):
        told = ", ".join(f"{instruction} {count}" for instruction, count in written.items())
        lines.append(f"process instructions are planned as the plain moves they make: {told}")
    loads = dict.fromkeys(move.settings.load.name for move in moves if move.settings.load is not None)
    if loads and not loads_count:
        lines.append(
            f"loads ({', '.join(loads)}) do not affect the plan: the cell's acceleration limits apply to any load"
        )
    return tuple(lines)


def unpartnered(moves: Sequence[Move], so: str = "they may take longer") -> str:
    r"""A sentence on synchronised moves of which nobody says how long the other robots take for them. so: what that
    makes of their times."""
    where: dict[str, list[int]] = {}
    for move in moves:
        where.setdefault(move.source.file, []).append(move.source.line)
    places = ", ".join(str(Lines(file, min(at), max(at))) for file, at in where.items())
    numbers = list(dict.fromkeys(move.identity for move in moves))
    keys = ", ".join(f"{one}: SECONDS" for one in numbers[:_SHOWN_IDS]) + (", ..." if len(numbers) > _SHOWN_IDS else "")
    return (
        f"{places}: nothing says how long the other robots take for the synchronised moves (\\ID, {len(moves)}): "
        f"{so}; say it in the cell file: 'partner: {{{keys}}}'"
    )


def demands_configuration(motion: Move, robot: RobotModel) -> bool:
    r"""Whether a motion must end in its programmed configuration: ConfJ \On for joint moves, ConfL \On for lines, and a
    robot that has a rule for confdata."""
    return robot.confdata_rule != NO_CONFDATA and _monitored(motion)


def with_exact_orientation(motion: Motion) -> str:
    r"""What to know of a line or an arc under SingArea \Wrist that no plan drives, "" for other motions. A controller
    interpolates the wrist's axes there one by one, the TCP on its way, and with ConfL \On it always comes to the
    programmed configuration, else to the nearest (RAPID reference manual, SingArea\Wrist under positioning; robot
    configuration)."""
    if not isinstance(motion, PathMove) or motion.settings.singularity is not Singularity.WRIST:
        return ""
    which = "programmed" if motion.settings.conf_l else "nearest"
    return (
        f"; under SingArea \\Wrist a controller turns axes 4, 5 and 6 evenly to the {which} configuration, the"
        " orientation off on the way; plans keep the programmed orientation"
    )


def _monitored(motion: Move) -> bool:
    match motion:
        case MoveJ():
            return motion.settings.conf_j
        case PathMove():
            return motion.settings.conf_l
        case _:
            return False


def _demands(motion: Move) -> Iterator[tuple[str, str, str]]:
    """Kind, demand and advice, in words, of everything a motion asks for and no plan keeps."""
    settings = motion.settings
    if isinstance(motion, PoseMove | MoveAbsJ) and motion.tool.stationary:
        yield (
            "stationary tools",
            f"carries the workpiece to the stationary tool {motion.tool.name} (robhold FALSE)",
            "plans support only a tool on the flange (robhold TRUE)",
        )
    if isinstance(motion, PathMove) and settings.singularity is Singularity.LOCK_AXIS_4:
        yield (
            "SingArea",
            "holds axis 4 and leaves its orientation (SingArea \\LockAxis4)",
            "plans keep the exact orientation: set SingArea \\Off before it",
        )
    if isinstance(motion, MoveC) and settings.circle.wrist_alone:
        yield (
            "CirPathMode",
            f"turns with wrist axes alone (CirPathMode \\{settings.circle.value})",
            "plans support \\PathFrame, \\ObjectFrame and \\CirPointOri: set one of them before it",
        )
    for unit in motion.units:
        size, sign = unit_of(unit.column)
        axis = f"{unit.unit}'s eax_{'abcdef'[unit.eax]} from {unit.start / size:g} to {unit.end / size:g} {sign}"
        if motion.duration is not None and motion.duration < unit.least:
            yield (
                "times of positioners",
                f"turns {axis} in {motion.duration:g} s",
                f"that takes {unit.least:.3f} s: give it more time",
            )
    if turned_under(motion) and settings.world_acceleration is not None:
        yield (
            "WorldAccLim",
            "is drawn on a work object that turns meanwhile, under WorldAccLim",
            "plans hold the tool's acceleration against the work object there: set WorldAccLim \\Off before it",
        )
    if motion.zone.criterion is not None and motion.zone.criterion.lower() not in _STOP_POINTS:
        yield (
            "stop times",
            f"stops by {motion.zone.criterion}, whose time is not planned",
            f"plans support only a plain stop: use fine or \\Inpos with {', '.join(_STOP_POINTS)}, and a WaitTime",
        )


class _OtherAxes:
    """External axes that no rail of the cell answers for: they may stand anywhere, but not move."""

    def __init__(self, plant: Plant):
        self._plant, self._led = plant, {one.eax: one for one in plant.followers}
        self._at: dict[int, float] = {}

    def demands(self, motion: Move) -> Iterator[tuple[str, str, str]]:
        """As _demands, for the axes that this motion moves; positions are taken over."""
        moved: dict[str, str] = {}
        for axis, value in enumerate(motion.extax):
            if value is None or axis in self._plant.rail_eaxes:
                continue
            if (led := self._led.get(axis)) is not None:
                yield from _apart(motion, led)
                continue
            before = self._at.setdefault(axis, value)
            self._at[axis] = value
            if axis in self._plant.turning or axis in {unit.eax for unit in motion.units}:
                continue
            if abs(value - before) > STILL:
                moved[f"eax_{'abcdef'[axis]}"] = f"from {before:g} to {value:g}"
        if moved:
            what = ", ".join(f"{name} {way}" for name, way in moved.items())
            yield "external axes", f"moves {what}", self._advice([*moved])
        elif isinstance(motion, MoveExtJ) and not self._plant.rail_eaxes and not (motion.units or self._plant.turning):
            yield "external axes", "moves external axes only, and the cell has none", self._advice(["eax_a"])

    def _advice(self, names: list[str]) -> str:
        letters = [f"eax_{'abcdef'[eax]}" for eax in self._plant.rail_eaxes]
        where = "axes (a linear one under the base) or positioners" if letters else "rail, axes or positioners"
        known = f"; of those the cell knows {', '.join(letters)}" if letters else ""
        still = "it" if len(names) == 1 else "them"
        return f"describe {', '.join(names)} in the cell file under {where}, else hold {still} still{known}"


def _apart(motion: Move, led: Follower) -> Iterator[tuple[str, str, str]]:
    """A follower that the target has elsewhere than its leader takes it."""
    value, leader = motion.extax[led.eax], motion.extax[led.leader]
    if value is None or leader is None:
        return
    wanted = led.ratio * leader + led.offset / MM
    if abs(value - wanted) > STILL:
        names = [f"eax_{'abcdef'[axis]}" for axis in (led.eax, led.leader)]
        what = f"has {names[0]} = {value:g}, which follows {names[1]} = {leader:g} and so stands at {wanted:g}"
        yield "external axes", what, f"give it {wanted:g}, or correct {names[0]} under axes in the cell file"
