"""The program as the optimiser sees it: stops joined by legs, in stations that one arm configuration serves.

A waypoint is where a motion of the program ends: a stop, where the TCP rests, or a fly-by, which is passed inside its
zone. A leg leads from one waypoint to the next: a joint move, a line or arc, or a dwell. A run is the legs between two
stops, driven in one go. Waypoints joined by lines, arcs and dwells form a station: within it the IK branch and the
turns of the joints cannot change.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property
from itertools import pairwise
from typing import Self

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, inverse_pose, moved_by, rotation_about
from trajopt_cli.motion import ConfData, FlyBy, Motion, Program, UnitMove, Wait
from trajopt_cli.path.line import Line
from trajopt_cli.path.segment import Segment
from trajopt_cli.problem.decision_scope import Freedom
from trajopt_cli.problem.nearest import SAME_JOINTS, nearest
from trajopt_cli.problem.objective import LEAST_TIME, Objective
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.layout import AxisLayout

# of twice the time a wait of a day gave a stream plan of 1.1199 s besides the wait for 1.1051 s.


class Coupling(Enum):
    """How the axes of a leg are bound to each other on the way."""

    FREE = "free"  # each axis of a joint move has its own profile, the rail moves freely along lines and waits
    COORDINATED = "coordinated"  # as a RAPID controller drives: one share of the way for all axes, rest at every stop


class LegKind(Enum):
    """How a leg moves: axes free on the way, the tool on its way (a line or an arc), or not at all."""

    JOINT = "joint"
    LINE = "line"
    DWELL = "dwell"


@dataclass(frozen=True, eq=False)
class Passage:
    """A place that is passed in motion inside a run that was opened. way: of the tool, a short line from here on, with
    which the tool goes; None where joint moves meet. measure: how far the tool goes on it [m], or turns [rad]. Then the
    tool centre point is within radius [m] of the waypoint's, its axes free. X_FT: tool in force."""

    X_FT: Array
    way: Line | None = None
    measure: float = 1.0
    radius: float = 0.0

    @cached_property
    def key(self) -> bytes:
        """What is asked by it."""
        way = b"" if self.way is None else _digits(self.way.numbers)
        return b"|".join([_digits(self.X_FT), way, repr((self.measure, self.radius)).encode()])


@dataclass(frozen=True, eq=False)
class TurnRoom:
    """How far a tool X_FT may be turned about an axis (3,) of its own, a unit vector, from how a pose or a way has it:
    from low to high [rad] at the start of a leg, both less by slope at its end, evenly between."""

    axis: Array
    X_FT: Array
    low: float
    high: float
    slope: float = 0.0

    def between(self, s_0: float, s_1: float) -> TurnRoom:
        """On the part of a leg from s_0 to s_1."""
        gone = s_0 * self.slope
        return replace(self, low=self.low - gone, high=self.high - gone, slope=(s_1 - s_0) * self.slope)

    @property
    def axis_F(self) -> Array:
        """The axis (3,) in the flange's frame."""
        return np.asarray(self.X_FT[:3, :3] @ self.axis)

    def turned(self, X_WF: Array, angle: float) -> Array:
        """A flange pose (4, 4) with the tool turned by an angle [rad]."""
        turn = np.eye(4)
        turn[:3, :3] = rotation_about(self.axis, angle)
        return np.asarray(X_WF @ self.X_FT @ turn @ inverse_pose(self.X_FT))

    def angle(self, X_WF: Array, X_WF_turned: Array) -> float:
        """By how much [rad] a flange pose (4, 4) turns the tool from another, -pi to pi."""
        u, R = self.axis_F, X_WF[:3, :3].T @ X_WF_turned[:3, :3]
        sine = u @ [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]
        return float(np.arctan2(sine, np.trace(R) - u @ R @ u))

    @cached_property
    def key(self) -> bytes:
        """Equal where as much is allowed."""
        return b"|".join([_digits(self.axis), _digits(self.X_FT), repr((self.low, self.high, self.slope)).encode()])


@dataclass(frozen=True, eq=False)
class Waypoint:
    """Where a motion ends. motion: its index, -1 for the start.

    X_WF: flange pose, None where joints decide. q: all axes (k,) if the program fixes them. rail: range allowed of the
    rail that is sought [m]; written: its value in the program as written; others, also: the same of the other rails in
    order, one of no room where they are held. rest: every axis must stand still here. conf:
    the program's confdata, demanded at the written rail value; None where any configuration will do. nearest: a joint
    move ends here in the configuration nearest to where it begins. fly_by: how large its corner is, None where the TCP
    stops. passage: how it is passed where a run was opened, else None. turn: how far the tool may be turned from X_WF,
    None where it may not.
    """

    motion: int
    X_WF: Array
    q: Array | None
    rail: tuple[float, float]
    written: float
    rest: bool
    conf: ConfData | None = None
    fly_by: FlyBy | None = None
    nearest: bool = False
    passage: Passage | None = None
    others: tuple[tuple[float, float], ...] = ()
    also: tuple[float, ...] = ()
    turn: TurnRoom | None = None

    @property
    def free(self) -> bool:
        """Whether some rail may stand elsewhere than at one place."""
        return self.q is None and not self.pinned

    @property
    def pinned(self) -> bool:
        """Whether every rail has one place."""
        return not any(low < high for low, high in (self.rail, *self.others))

    @property
    def held(self) -> tuple[float, ...]:
        """Where the other rails stand while one is sought (r - 1,) [m]."""
        return tuple(low for low, _ in self.others)

    def ranges(self, layout: AxisLayout) -> tuple[Array, Array]:
        """What all rails are allowed at least and at most (r,) [m]."""
        each = list(self.others)
        each.insert(layout.sought, self.rail)
        low, high = np.array(each[: layout.r]).reshape(-1, 2).T
        return low, high

    def standing(self, layout: AxisLayout, q: Array) -> Waypoint:
        """The same with its rails where axes q (k,) have them."""
        d = float(layout.place(q))
        return replace(self, rail=(d, d), others=tuple((value, value) for value in q[layout.others].tolist()))

    def seeking(self, layout: AxisLayout, sought: int, q: Array | None = None) -> Waypoint:
        """The same that seeks another rail; the others held where axes q (k,) have them, or as free as they are."""
        ranges, also = [*self.others], [*self.also]
        ranges.insert(layout.sought, self.rail)
        also.insert(layout.sought, self.written)
        rail, written = ranges.pop(sought), also.pop(sought)
        if q is not None:
            ranges = [(value, value) for value in q[layout.seeking(sought).others].tolist()]
        return replace(self, rail=rail, written=written, others=tuple(ranges), also=tuple(also))

    @cached_property
    def key(self) -> bytes:
        """What is asked at it: equal where the same is, wherever it stands in a program."""
        asked = self.rail, self.written, self.rest, self.conf, self.fly_by, self.nearest, self.others, self.also
        parts = [_digits(self.X_WF), repr(asked).encode(), b"" if self.q is None else _digits(self.q)]
        parts += [one.key for one in (self.passage, self.turn) if one is not None]
        return b"|".join(parts)


@dataclass(frozen=True, eq=False)
class Leg:
    """From waypoint `start` to waypoint `start + 1`. X_FT: tool in force. v_tcp, v_ori, v_rail: programmed caps (inf if
    none).

    duration: fixed time [s] or None. rail_moves: the rail may move during the leg. segment:
    the way of a line or an arc, tool in the world; None where the tool rests or the joints decide. acceleration: share
    of every axis' acceleration limit that is in force. least: time [s] that it takes at least, as a positioner turns,
    waits run beside it or other robots move together with it; waits_for: which of them.
    load: what the flange carries, None for nothing and where torques have no limit. units: positioners that turn the
    work object under a line or an arc, in step with it; chord and speeds are then those over the work object. along:
    the tool's speeding up and slowing down along its path at most [m/s2], None where a_tcp alone limits both. turn: how
    far the tool may be turned from the segment, as it likes on a line or an arc, by as much all through a rest.
    """

    motion: int
    kind: LegKind
    start: int
    X_FT: Array
    v_tcp: float
    a_tcp: float
    v_ori: float
    v_rail: float
    duration: float | None = None
    rail_moves: bool = True
    segment: Segment | None = None
    acceleration: float = 1.0
    least: float = 0.0
    load: ToolLoad | None = None
    units: tuple[UnitMove, ...] = ()
    waits_for: str = ""
    along: tuple[float, float] | None = None
    turn: TurnRoom | None = None

    @cached_property
    def key(self) -> bytes:
        """Its path, its caps and its load: equal where the same is asked, wherever it stands in a program."""
        numbers = self.v_tcp, self.a_tcp, self.v_ori, self.v_rail, self.duration, self.rail_moves, self.acceleration
        parts = [self.kind.value.encode(), repr((*numbers, self.least, self.along)).encode(), _digits(self.X_FT)]
        if self.load is not None:
            parts.append(repr(self.load.numbers).encode())
        if self.segment is not None:
            parts += [repr(self.units).encode(), _digits(self.segment.numbers)]
        parts += [] if self.turn is None else [self.turn.key]
        return b"|".join(parts)

    @property
    def chord(self) -> float:
        """The length of a line or an arc [m]."""
        return 0.0 if self.segment is None else self.segment.length

    @property
    def angle(self) -> float:
        """Reorientation on a line or an arc [rad]."""
        return 0.0 if self.segment is None else self.segment.angle

    @property
    def fastest_turn(self) -> float:
        """The highest rate of turning on a line or an arc by its path parameter [rad]."""
        return 0.0 if self.segment is None else self.segment.fastest_turn

    @property
    def ramps(self) -> tuple[float, float]:
        """Speeding up and slowing down of the tool along its path at most [m/s2]."""
        return self.along or (self.a_tcp, self.a_tcp)

    @property
    def positioner_use(self) -> tuple[float, float]:
        """What the units take for the whole way at their velocity [s], and at their acceleration [s2]: no share of it
        goes by at more than 1 / the first, nor gathers speed at more than 1 / the second; 0 where none turns."""
        return (
            max((abs(unit.angle) / unit.velocity for unit in self.units), default=0.0),
            max((abs(unit.angle) / unit.acceleration for unit in self.units), default=0.0),
        )


@dataclass(frozen=True, eq=False)
class Problem:
    """Waypoints and legs in order, for one target; stations as (first waypoint, last); the motions left out.

    coupling: how the axes of a leg are bound to each other, which need not be as loose as the target allows. ties:
    waypoints, in order, that must have one rail position and one configuration: those of a steady cycle's ends among
    them. objective: what makes a motion good.
    """

    plant: Plant
    program: Program
    freedom: Freedom
    waypoints: tuple[Waypoint, ...]
    legs: tuple[Leg, ...]
    stations: tuple[tuple[int, int], ...]
    dropped: frozenset[int]
    target: Target
    coupling: Coupling
    ties: tuple[tuple[int, ...], ...] = ()
    objective: Objective = LEAST_TIME
    sought: int = 0

    @property
    def layout(self) -> AxisLayout:
        """Where the axes stand in vectors of all of them, the sought rail marked."""
        return self.plant.layout.seeking(self.sought)

    def seeking(self, sought: int, q: Array | None = None) -> Problem:
        """The same that seeks another rail; the others held where axes q (M, n) have them at the waypoints, or as free
        as they are."""
        each = q if q is not None else [None] * len(self.waypoints)
        points = [one.seeking(self.layout, sought, own) for one, own in zip(self.waypoints, each, strict=True)]
        return replace(self, waypoints=tuple(points), sought=sought)

    def with_rails_held(self, q: Array) -> Self:
        """The same whose rails but the sought one stand at the waypoints where axes q (M, n) have them."""
        points = [one.seeking(self.layout, self.sought, own) for one, own in zip(self.waypoints, q, strict=True)]
        return replace(self, waypoints=tuple(points))

    def seen(self, k: int) -> Array:
        """The flange pose at waypoint k as the base sees it that only the sought rail carries."""
        return self._seen(self.waypoints[k].X_WF, np.array(self.waypoints[k].held))

    def seen_along(self, leg: Leg, s: Array) -> Array:
        """The same along a line or an arc at its path parameters s (m,)."""
        assert leg.segment is not None
        X = leg.segment.pose(s) @ inverse_pose(leg.X_FT)
        before, behind = (np.array(self.waypoints[k].held) for k in (leg.start, leg.start + 1))
        return self._seen(X, before + s[:, None] * (behind - before)) if len(before) else X

    def _seen(self, X_WF: Array, held: Array) -> Array:
        if not held.size:
            return X_WF
        return moved_by(X_WF, -(held @ np.delete(self.plant.robot.rail_axes_W, self.sought, axis=0)))

    def axes_at(self, k: int, d: Array, arm: Array) -> Array:
        """All axes (..., n) at waypoint k with the sought rail at d (...) and joints (..., m)."""
        q = self.layout.join(d, arm)
        q[..., self.layout.others] = self.waypoints[k].held
        return q

    def ways(self, k: int, way: Array) -> Array:
        """How far the rails go on leg k (r, p) [m], the sought one by way (p,)."""
        out = np.empty((self.layout.r, *way.shape))
        ends = (self.waypoints[i].held for i in (k, k + 1))
        for i, before, behind in zip(self.layout.others, *ends, strict=True):
            out[i] = abs(behind - before)
        out[self.sought : self.sought + 1] = np.abs(way)
        return out

    @property
    def coordinated(self) -> bool:
        """Whether all axes of a leg share one way and rest at every stop."""
        return self.coupling is Coupling.COORDINATED

    @property
    def steady(self) -> bool:
        """Whether it ends where it begins, wherever that is."""
        return any(group[0] == 0 and len(self.legs) in group for group in self.ties)

    def around_end(self, last: int, first: int) -> Problem:
        """Of a cycle the legs from waypoint last on, and behind them those up to waypoint first."""
        waypoints = (*self.waypoints[last:], *self.waypoints[1 : first + 1])
        legs = [replace(leg, start=k) for k, leg in enumerate((*self.legs[last:], *self.legs[:first]))]
        return replace(self, waypoints=waypoints, legs=tuple(legs), stations=stations_of(legs, len(waypoints)), ties=())

    def without_settling(self) -> tuple[Problem, float]:
        """The problem whose stops do not settle, with no ties, and what settling takes in this one [s]: every legal
        motion of it becomes one of that problem, shorter by so much, where the axes do not stand for it."""
        waits = [one if isinstance(one := self.motion(leg.motion), Wait) else None for leg in self.legs]
        kept = [k for k, wait in enumerate(waits) if wait is None or not wait.settles]
        legs = [replace(self.legs[k], start=i) for i, k in enumerate(kept)]
        waypoints = (self.waypoints[0], *(self.waypoints[k + 1] for k in kept))
        apart = replace(
            self, waypoints=waypoints, legs=tuple(legs), stations=stations_of(legs, len(waypoints)), ties=()
        )
        return apart, sum(wait.duration for wait in waits if wait is not None and wait.settles)

    def passes(self, k: int) -> bool:
        """Whether waypoint k is a fly-by."""
        return self.waypoints[k].fly_by is not None

    @cached_property
    def runs(self) -> tuple[tuple[int, int], ...]:
        """The runs, as (first waypoint, last): stops with nothing but fly-bys between them."""
        stops = [k for k in range(len(self.waypoints)) if not self.passes(k)]
        return tuple(pairwise(stops))

    def rests(self, k: int) -> bool:
        """Whether every axis stands still at waypoint k."""
        if self.passes(k) or self.waypoints[k].passage is not None:
            return False
        return self.waypoints[k].rest or self.coordinated or not self.rail_may_pass(k)

    def rail_may_pass(self, k: int) -> bool:
        """Whether the rail may move through stop k: no leg beside it holds it still."""
        near = [self.legs[i] for i in (k - 1, k) if 0 <= i < len(self.legs)]
        return self.plant.robot.has_rail and all(leg.rail_moves for leg in near)

    def leads(self, k: int, q_0: Array, q_1: Array) -> BoolArray | None:
        """Whether a controller ends leg k, begun at axes q_0 (n, axes), in axes q_1 (m, axes): (n, m); None where it
        does not choose."""
        point = self.waypoints[k + 1]
        if not point.nearest or self.legs[k].kind is not LegKind.JOINT:
            return None
        layout, out = self.layout, np.zeros((len(q_0), len(q_1)), dtype=bool)
        rails, of = np.unique(q_1[:, layout.rail], axis=0, return_inverse=True)
        for i, rail in enumerate(rails):
            found = nearest(self.plant, point.X_WF, rail, q_0[:, layout.arm])
            if len(found):
                apart = np.abs(found[:, None] - q_1[of == i][:, layout.arm]).max(axis=-1)
                out[:, of == i] = apart <= SAME_JOINTS
        return out

    def key(self, first: int, last: int) -> bytes:
        """What is asked from one waypoint to another, and at them: equal where it is the same."""
        held = self.freedom.rail.value, self.freedom.through_stops, self.coupling.value, self.sought
        points = [point.key for point in self.waypoints[first : last + 1]]
        return b"|".join([*points, *(leg.key for leg in self.legs[first:last]), repr(held).encode()])

    def segment(self, k: int) -> Segment:
        """The tool's path on leg k; of a wait, which has none of its own, the line of no length where it stands."""
        leg = self.legs[k]
        X_WT = self.waypoints[k].X_WF @ leg.X_FT
        return leg.segment or Line(X_WT, X_WT)

    def motion(self, index: int) -> Motion:
        """The program's motion number index."""
        return self.program.motions[index]


def _digits(values: Array) -> bytes:
    return (np.round(values, 12) + 0.0).tobytes()  # -0 is 0


def stations_of(legs: Sequence[Leg], count: int) -> tuple[tuple[int, int], ...]:
    """The stations of so many waypoints: from one joint move to the next."""
    starts = [0] + [leg.start + 1 for leg in legs if leg.kind is LegKind.JOINT]
    ends = [start - 1 for start in starts[1:]] + [count - 1]
    return tuple(zip(starts, ends, strict=True))
