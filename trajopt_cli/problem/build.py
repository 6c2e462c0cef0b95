"""A program on a plant as a problem: waypoints with what may be chosen there, and the legs between them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import (
    FlyBy,
    Hold,
    Motion,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    PathMove,
    PoseMove,
    Program,
    SignalEvent,
    Wait,
    motion_name,
    turned_under,
)
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.problem.acceleration_settings import acceleration_share, path_acceleration, tcp_acceleration
from trajopt_cli.problem.configurations import arms_as_written
from trajopt_cli.problem.corners import corners_of
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom, RailFreedom
from trajopt_cli.problem.editable import Changes, everything
from trajopt_cli.problem.loads import loads_of
from trajopt_cli.problem.nearest import nearest
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.plannable import demands_configuration
from trajopt_cli.problem.plant import Plant, shown_rail
from trajopt_cli.problem.problem import Coupling, Leg, LegKind, Problem, Waypoint, stations_of
from trajopt_cli.units import slides

_POINT = 1e-9  # m, rad: a line to where it starts


_STILL = 1e-7  # m of rail: less is the rounding of a num


_HOLDERS = {
    Hold.PROGRAM: "a comment in the program",
    Hold.CELL: "hold_rail in the cell file",
    Hold.GRIPPER: "an output set just before",
    Hold.WAIT: "a wait",
    Hold.UNIT: "DeactUnit",
    Hold.SETTLING: "settling at a stop",
}


_ON_LIMIT = 1e-9  # m, rad an axis may stand outside its range by rounding


_LONG = 4.0  # times what the axes take to come to rest: a wait as long has a rest between its ends. Measured: with ends


def build_problem(
    program: Program,
    plant: Plant,
    freedom: Freedom = EVERYTHING,
    target: Target = Target.STREAM,
    changes: Changes | None = None,
    dropped: Collection[int] = (),
) -> Problem | Infeasible:
    """Waypoints and legs of a program on one target, or why a fixed position is out of range.

    freedom: what may change at all. changes: which motions may have it, None for all of them; the others keep their
    rail and confdata.
    dropped: motions that are left out.
    """
    changes = changes or everything(program, plant)
    build = _Build(program, plant, freedom, changes, target, corners_of(program, plant, dropped).passed)
    try:
        if (entrance := program.entrance) is not None:
            build.enter(program.motions.index(entrance), entrance)
        for index, motion in enumerate(program.motions):
            if index not in dropped:
                build.add(index, motion)
    except _Impossible as out:
        motion = program.motions[out.index]
        return Infeasible(out.index, motion.source, f"{motion_name(motion)} {out}")
    waypoints = [*build.waypoints[:-1], replace(build.waypoints[-1], rest=True)]
    if (start := waypoints[0]).q is not None and program.entrance is not None:
        waypoints[-1] = replace(waypoints[-1], q=start.q, rail=start.rail, others=start.others, conf=None)
    ties = _ties(changes, waypoints, program.entrance is not None)
    for group in ties:
        pinned = [one for one in (waypoints[k] for k in group) if one.pinned]
        for k in group if pinned else ():
            waypoints[k] = replace(waypoints[k], rail=pinned[0].rail, others=pinned[0].others)
    return Problem(
        plant,
        program,
        freedom,
        tuple(waypoints),
        tuple(_timed(leg, waypoints) for leg in _loaded(program, plant, _at_rest(build.legs, program, target))),
        stations_of(build.legs, len(waypoints)),
        frozenset(dropped),
        target,
        Coupling.COORDINATED if target is Target.RAPID else Coupling.FREE,
        ties,
    )


def _loaded(program: Program, plant: Plant, legs: list[Leg]) -> list[Leg]:
    """The legs with what the flange carries on them, where that matters."""
    if plant.limits.binding_torque is None:
        return legs
    loads = loads_of(program)
    return [replace(leg, load=loads[leg.motion]) for leg in legs]


def _timed(leg: Leg, waypoints: Sequence[Waypoint]) -> Leg:
    """A leg whose programmed time stands for a speed: between fly-bys it has no beginning and no end of its own."""
    before, after = waypoints[leg.start : leg.start + 2]
    if leg.duration is None or (before.fly_by is None and after.fly_by is None):
        return leg
    X_0, X_1 = before.X_WF @ leg.X_FT, after.X_WF @ leg.X_FT
    way = leg.chord or float(np.linalg.norm(X_1[:3, 3] - X_0[:3, 3]))
    if any(point.fly_by is not None and point.fly_by.in_place for point in (before, after)):
        return replace(leg, duration=None, v_ori=min(leg.v_ori, leg.angle / leg.duration))
    return replace(leg, duration=None, v_tcp=min(leg.v_tcp, way / leg.duration))


def _ties(changes: Changes, waypoints: Sequence[Waypoint], steady: bool) -> tuple[tuple[int, ...], ...]:
    """The waypoints of tied motions, and both ends of a steady cycle; those that joints fix, or that a plan may not
    change, are what they are."""
    ends = {
        waypoint.motion: k
        for k, waypoint in enumerate(waypoints)
        if waypoint.q is None and (waypoint.free or waypoint.conf is None)
    }
    groups = [tuple(ends[index] for index in group if index in ends) for group in changes.ties]
    if steady and waypoints[0].q is None:
        last = len(waypoints) - 1
        with_last = next((group for group in groups if last in group), (last,))
        groups = [(0, *with_last), *(group for group in groups if last not in group)]
    return tuple(group for group in groups if len(group) > 1)


class _Impossible(Exception):
    def __init__(self, index: int, why: str):
        super().__init__(why)
        self.index = index


class _OutOfRange(_Impossible):
    def __init__(self, index: int, axis: str, value: float, low: float, high: float):
        unit, factor = ("mm", 1e3) if slides(axis) else ("deg", 180 / np.pi)
        super().__init__(
            index,
            f"asks for {axis} = {value * factor:.6g} {unit}, range {low * factor:.6g}..{high * factor:.6g} {unit}",
        )


def _at_rest(legs: Sequence[Leg], program: Program, target: Target) -> list[Leg]:
    """The legs of a program; a RAPID controller, which stops every axis before a wait, moves none in the last one:
    nothing comes of it."""
    out, k = [*legs], len(legs)
    while k > 0 and target is Target.RAPID and isinstance(program.motions[legs[k - 1].motion], Wait):
        k -= 1
        out[k] = replace(legs[k], rail_moves=False)
    return out


class _Held(_Impossible):
    def __init__(self, index: int, motion: Move, rail: Array, asked: Array):
        holder = f"{motion.speed.name} (v_leax 0)" if motion.hold is None else _HOLDERS[motion.hold]
        super().__init__(
            index,
            f"takes the rail from {shown_rail(rail)} to {shown_rail(asked)}, and {holder} says that it"
            " stands still there; give both ends the same position, or take the hold back",
        )


class _Build:
    """Waypoints and legs of the motions added so far. written (r,) [m]: the rails as the program has them there."""

    def __init__(
        self,
        program: Program,
        plant: Plant,
        freedom: Freedom,
        changes: Changes,
        target: Target,
        fly_bys: Mapping[int, FlyBy],
    ):
        self._program = program
        self._arms: Mapping[int, Array | None] | None = None  # as written; made where it is asked
        self._plant, self._freedom, self._changes, self._fly_bys = plant, freedom, changes, fly_bys
        self._target = target
        self._has_rail = plant.robot.has_rail
        rail = plant.layout.rail
        self._stroke = [*zip(plant.limits.lower[rail].tolist(), plant.limits.upper[rail].tolist(), strict=True)]
        self._pinned = freedom.rail is RailFreedom.PROGRAMMED or plant.rail_fixed
        self._written = plant.start[rail]
        self.waypoints = [self._at_joints(-1, plant.start)]
        self.legs: list[Leg] = []

    def enter(self, index: int, move: Move) -> None:
        """Begin at rest where a steady cycle ends: at the end of its last move. As written that is in the joints that a
        controller has come to by then, where these are known."""
        match move:
            case MoveAbsJ():
                self._take_rail(index, move)
                start = replace(self._at_joints(index, self._axes(move.q)), motion=-1)
            case PoseMove():
                start = replace(self._at_pose(index, move), motion=-1, rest=True, nearest=False)
                known = np.abs(self._plant.robot.forward(self._plant.start) - start.X_WF).max() < _STILL
                if known and self._pinned and not self._freedom.configuration:
                    start = replace(start, q=self._plant.start, conf=None)
            case _:
                return
        self.waypoints = [start]

    def add(self, index: int, motion: Motion) -> None:
        """The next motion. Raises _Impossible for what the program itself asks for and cannot be."""
        match motion:
            case SignalEvent():
                pass
            case Wait():
                self._wait(index, motion)
            case MoveAbsJ():
                self._take_rail(index, motion)
                self._to(self._at_joints(index, self._axes(motion.q)), motion, _caps(motion, self._plant))
            case MoveExtJ():
                self._external(index, motion)
            case PathMove():
                self._way(index, motion)
            case MoveJ():
                before, end = self.waypoints[-1], self._at_pose(index, motion)
                there = before.q is None and np.allclose(before.X_WF, end.X_WF, rtol=0, atol=_POINT)
                if motion.least and there and not _apart(before, end):
                    self._stand(motion, end, self._target is not Target.RAPID and motion.hold is None)
                else:
                    self._to(end, motion, _caps(motion, self._plant))

    # ------------------------------------------------------------------------------------------------------- motions

    def _wait(self, index: int, wait: Wait) -> None:
        """The tool rests for a time; the rail may move, where the text has room for it. A condition ends at rest.

        In a long wait it moves at the beginning and at the end only, which together is time for its whole stroke, and
        rests in between; for a RAPID controller, whose text would have one creeping move, it rests all the time.
        """
        before, rest = self.waypoints[-1], wait.ends_at_rest
        if wait.duration == 0.0:
            self.waypoints[-1] = replace(before, rest=before.rest or rest)
            return
        moves = self._freedom.dwells and before.free and index in self._changes.values
        moves = moves and wait.hold is None and wait.beside is None
        settled = _settled(self._plant) if moves else np.inf
        parts = [(wait.duration, moves)]
        if wait.duration > _LONG * settled:
            rests = wait.duration - 2 * settled, False
            parts = [(settled, True), rests, (settled, True)]
            if self._target is Target.RAPID:
                parts = [(wait.duration, False)]
        for seconds, moves in parts:
            dwell = Leg(
                index, LegKind.DWELL, len(self.legs), np.eye(4), np.inf, np.inf, np.inf, np.inf,
                duration=seconds, rail_moves=moves,
            )  # fmt: skip
            self.legs.append(dwell)
            self.waypoints.append(self._as_before(before, index, before.rest or rest))

    def _stand(self, motion: Move, end: Waypoint, moves: bool) -> None:
        """The tool stands while positioners turn or other robots move; moves: the rail may move meanwhile."""
        v_rail = np.inf if isinstance(motion, MoveExtJ) else _caps(motion, self._plant)[2]
        moves = moves and self._has_rail and self._freedom.dwells and v_rail > 0
        leg = Leg(end.motion, LegKind.DWELL, len(self.legs), np.eye(4), np.inf, np.inf, np.inf, v_rail or np.inf,
                  duration=max(motion.duration or 0.0, motion.least), rail_moves=moves, least=motion.least,
                  waits_for=motion.waits_for)  # fmt: skip
        self.legs.append(leg)
        self.waypoints.append(end)
        if not moves:
            self._hold(motion)

    def _external(self, index: int, motion: MoveExtJ) -> None:
        """The arm's joints hold, so the waypoint before is as the program writes it. Where positioners alone turn, all
        axes stand for as long as that takes, wherever they are."""
        if self._plant.rail_value(motion.extax) is None:
            if not motion.least:  # every axis is where it should be
                self.waypoints[-1] = replace(self.waypoints[-1], rest=True)
                return
            self._stand(motion, self._as_before(self.waypoints[-1], index, True), False)
            return
        self._take_rail(index, motion)
        before = self.waypoints[-1]
        q, layout = self._as_written(before), self._plant.layout
        self.waypoints[-1] = replace(before, q=q, conf=None, **_rails(q[layout.rail]))
        v_rail = motion.speed.v_leax if motion.duration is None else np.inf
        self._to(self._at_joints(index, self._axes(q[layout.arm])), motion, (np.inf, np.inf, v_rail))

    def _as_written(self, waypoint: Waypoint) -> Array:
        """All axes at a waypoint as the program writes it: its rail value, and the joints that a controller takes;
        where these cannot be had, others of the postures that may be taken, the nearest to the joints given last."""
        if waypoint.q is not None:
            return waypoint.q
        if self._arms is None:
            self._arms = arms_as_written(self._program, self._plant)
        plant, arm = self._plant, self._arms.get(waypoint.motion)
        rail = np.array([waypoint.written, *waypoint.also][: plant.layout.r])
        if arm is None:
            given = (point.q for point in reversed(self.waypoints) if point.q is not None)
            near = next(given, plant.start)[plant.layout.arm]
            arm = next(iter(nearest(plant, waypoint.X_WF, rail, near[None], waypoint.conf)), None)
        if arm is None:
            raise InputError(
                "MoveExtJ holds the arm's joints, but the point before it cannot be reached with its confdata at its"
                " own rail value; correct eax or confdata there"
            )
        return plant.layout.merge(rail, arm)

    def _way(self, index: int, motion: PathMove) -> None:
        """A line or an arc; a line of no length is a dwell that lasts as long as its rail needs."""
        start = self.waypoints[-1]
        end = self._at_pose(index, motion)
        path = segment_of(motion, start.X_WF @ motion.tool.X_FT)
        units = turned_under(motion)
        still = path.length < _POINT and path.angle < _POINT and not units
        moves = still or self._freedom.lines
        moves = self._has_rail and (moves or _apart(start, end)) and motion.hold is None
        if still and motion.least and not _apart(start, end):
            self._stand(motion, end, moves)
            return
        self._to(end, motion, _caps(motion, self._plant))
        kind, segment = (LegKind.DWELL, None) if still else (LegKind.LINE, path)
        moves = moves and self.legs[-1].rail_moves
        self.legs[-1] = replace(self.legs[-1], kind=kind, rail_moves=moves, segment=segment, units=units)

    def _to(self, end: Waypoint, motion: Move, caps: tuple[float, float, float]) -> None:
        """A joint move to a waypoint. caps: programmed speeds of tool [m/s], turning [rad/s] and rail [m/s]."""
        X_FT = np.eye(4) if isinstance(motion, MoveExtJ) else motion.tool.X_FT
        v_tcp, v_ori, v_rail = caps
        before = self.waypoints[-1]
        driven = max(abs(end.written - before.written), *_ways(end.also, before.also), 0.0) > _STILL
        moves = motion.hold is None and v_rail > 0 and (driven or not motion.searches)  # else: at the hit, where is it?
        v_rail = v_rail or np.inf
        tcp, zone = self._plant.tcp, self._fly_bys.get(end.motion)
        v_tcp, a_tcp = min(v_tcp, tcp.speed), tcp_acceleration(motion, tcp)
        duration = None if motion.duration is None else max(motion.duration, motion.least)
        leg = Leg(
            end.motion, LegKind.JOINT, len(self.legs), X_FT, v_tcp, a_tcp, v_ori, v_rail, duration=duration,
            rail_moves=moves or not self._has_rail, acceleration=acceleration_share(motion),
            least=motion.least, waits_for=motion.waits_for, along=path_acceleration(motion, tcp),
        )  # fmt: skip
        self.legs.append(leg)
        self.waypoints.append(end if zone is None else replace(end, rest=False, fly_by=zone))
        if not leg.rail_moves:
            self._hold(motion)

    # ----------------------------------------------------------------------------------------------------- waypoints

    def _take_rail(self, index: int, motion: Move) -> None:
        """The rail goes where a motion's external axes say, or stays; where it must go it has to be in its stroke."""
        if not self._plant.asks_rail(motion.extax):
            if index not in self._changes.values:  # nobody can say where instead, so it must be there already
                self._pin(-1, self._written)
            return
        given = self._plant.rail_after(motion.extax, self._written)
        fixed = self._pinned or isinstance(motion, MoveAbsJ | MoveExtJ)
        names = self._plant.limits.names[self._plant.layout.rail]
        for name, value, (low, high) in zip(names, given.tolist(), self._stroke, strict=True):
            if fixed and not low - _ON_LIMIT <= value <= high + _ON_LIMIT:
                raise _OutOfRange(index, name, value, low, high)
        self._written = given

    def _hold(self, motion: Move) -> None:
        """The rail stands still on the last leg: where one end of it is fixed, the other is there, too."""
        (low, high), (end_low, end_high) = (one.ranges(self._plant.layout) for one in self.waypoints[-2:])
        stands, ends = bool(np.all(low == high)), bool(np.all(end_low == end_high))
        if stands and ends and np.abs(end_low - low).max(initial=0.0) > _STILL:
            raise _Held(self.waypoints[-1].motion, motion, low, end_low)
        if stands:
            self._pin(-1, low)
        elif ends:
            self._pin(-2, end_low)

    def _pin(self, k: int, rail: Array) -> None:
        """The rails (r,) at waypoint k stand where it is said [m], if they were free."""
        if self.waypoints[k].q is None:
            there = _rails(rail)
            self.waypoints[k] = replace(self.waypoints[k], rail=there["rail"], others=there["others"])

    def _as_before(self, before: Waypoint, index: int, rest: bool) -> Waypoint:
        """The same place at the end of another motion."""
        there = _rails(self._written)
        return replace(before, motion=index, rest=rest, written=there["written"], also=there["also"])

    def _at_pose(self, index: int, motion: PoseMove) -> Waypoint:
        self._take_rail(index, motion)
        free = index in self._changes.values
        rails = _rails(self._written, self._stroke if free and not self._pinned else None)
        demanded = demands_configuration(motion, self._plant.robot)
        fixed = not (free and self._freedom.configuration)
        return Waypoint(
            index,
            motion.X_WT @ inverse_pose(motion.tool.X_FT),
            None,
            rest=motion.works or not self._freedom.through_stops,
            conf=motion.conf if fixed and demanded else None,
            nearest=fixed and isinstance(motion, MoveJ) and not motion.settings.conf_j,
            **rails,
        )

    def _at_joints(self, index: int, q: Array) -> Waypoint:
        limits = self._plant.limits
        for name, value, low, high in zip(limits.names, q, limits.lower, limits.upper, strict=True):
            if not low - _ON_LIMIT <= value <= high + _ON_LIMIT:
                raise _OutOfRange(index, name, value, low, high)
        for one, value in zip(limits.coupled, limits.couplings.rows @ q, strict=True):
            if not one.lower - _ON_LIMIT <= value <= one.upper + _ON_LIMIT:
                raise _OutOfRange(index, one.name, value, one.lower, one.upper)
        return Waypoint(index, self._plant.robot.forward(q), q, rest=True, **_rails(self._written))

    def _axes(self, arm: Array) -> Array:
        """All axes (k,) with the rails as written and the arm's joints (6,)."""
        return np.asarray(np.r_[self._written, arm])


def _settled(plant: Plant) -> float:
    """What any axis takes at least to come from its top speed to rest half its range, or a quarter turn, away [s]."""
    limits, rail = plant.limits, plant.layout.rail
    way = np.minimum(limits.upper - limits.lower, np.pi)
    way[rail] = (limits.upper - limits.lower)[rail]
    return float((way / 2 / limits.velocity + limits.velocity / limits.acceleration).max())


def _caps(motion: PoseMove | MoveAbsJ, plant: Plant) -> tuple[float, float, float]:
    """Programmed speeds of tool, turning and rail; none for joint moves where the cell frees them, nor where a time
    replaces the speed. A rail's speed of 0 lets it stand."""
    if motion.duration is not None or (plant.free_speed and isinstance(motion, MoveJ | MoveAbsJ)):
        return np.inf, np.inf, np.inf
    return motion.speed.v_tcp, motion.speed.turning, motion.speed.v_leax


def _rails(written: Array, stroke: Sequence[tuple[float, float]] | None = None) -> dict[str, Any]:
    """Fields of a waypoint whose rails are at written (r,) [m] in the program; stroke: where they may be instead."""
    values = written.tolist() or [0.0]
    (rail, *others) = stroke or [(value, value) for value in values]
    return {"rail": rail, "written": values[0], "others": tuple(others), "also": tuple(values[1:])}


def _ways(a: Sequence[float], b: Sequence[float]) -> list[float]:
    return [abs(one - other) for one, other in zip(a, b, strict=True)]


def _apart(a: Waypoint, b: Waypoint) -> bool:
    """Whether ranges of some rail have no position in common, so that it has to move between them."""
    pairs = zip((a.rail, *a.others), (b.rail, *b.others), strict=True)
    return any(one[1] < other[0] or other[1] < one[0] for one, other in pairs)
