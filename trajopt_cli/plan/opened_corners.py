"""Runs with corners as legs of their own, between places that are passed in motion, for the nonlinear program.

A run is cut where its path changes: where a zone meets a line or an arc the tool goes on along it, between two lines or
arcs lies a corner leg, and where joint moves meet the tool comes through the zone's sphere anyhow. A joint move beside
a line is one free leg from zone to zone, so its point is passed by construction. The motion at hand is cut into the
same legs, exactly; what was found for them is put together again as motions of the program.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, pose, rotations_by
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.line import Line
from trajopt_cli.path_timing.edge_times import short
from trajopt_cli.problem.problem import Leg, LegKind, Passage, Problem, Waypoint, stations_of
from trajopt_cli.rapid.zones import NO_WAY
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, LegMotion, PathLeg, Piece, Pieces, integrate

_WAY = 1e-3  # m or rad: how long the way of a passage is; it stands for a direction.
_MANY = 3  # short lines in a row are a contour, which is left to path timing: a program of its corners is large.
_TOUCH = 1e-6  # share of a line between two zones that touch.
_MOMENT = 1e-10  # s: a shorter part of a motion is rounding.
_HALVINGS = 60  # of a time at which a share of a way is done.


@dataclass(frozen=True, eq=False, kw_only=True)
class OpenedProblem(Problem):
    """A problem whose runs are opened, and the way back to the whole one and its motion at hand.

    owners: of each leg the leg of the whole problem it belongs to, or both beside a corner. stops: of each waypoint of
    the whole problem the opened one, None where it is passed.
    """

    whole: Problem
    base: Iterate
    owners: tuple[tuple[int, ...], ...]
    stops: tuple[int | None, ...]

    def closed(self, axes: Axes, found: Iterate) -> Iterate:
        """A motion of this problem as one of the whole one: half a corner belongs to either leg beside it."""
        legs: list[list[Piece]] = [[] for _ in self.whole.legs]
        for owner, motion in zip(self.owners, found.legs, strict=True):
            if len(owner) == 1:
                legs[owner[0]] += [] if motion is None else _pieces(motion)
            else:
                assert isinstance(motion, PathLeg)
                middle = _when(motion, 0.5)
                for k, (a, b) in zip(owner, ((0.0, middle), (middle, motion.T)), strict=True):
                    legs[k].append(excerpt(axes, motion, a, b))
        q, qd = self.base.q.copy(), self.base.qd.copy()
        for k, i in enumerate(self.stops):
            if i is not None:
                q[k], qd[k] = found.q[i], found.qd[i]
        motions = tuple(Pieces(tuple(own)) if len(own) > 1 else next(iter(own), None) for own in legs)
        return Iterate(q, qd, self.base.cfx, motions)


@dataclass(frozen=True, eq=False)
class _Cut:
    """Where a run is cut. leg, s: on which of its lines or arcs, in its s; 1.0 on a joint move's end. point: what is
    asked there. ends: the run's, at a waypoint of the whole problem."""

    leg: int
    s: float
    point: Waypoint
    cfx: int


def opened(axes: Axes, problem: Problem, base: Iterate) -> tuple[OpenedProblem, Iterate] | None:
    """The problem with its runs with corners opened, and its motion at hand cut alike; None where no run can be.

    A run stays as it is, at rest and with the rail where the motion has it at its ends, where it leads over many short
    lines, changes its tool in a corner, turns in zones of two sizes (see with_even_zones), or waits for something.
    """
    runs = [run for run in problem.runs if run[1] > run[0] + 1]
    open_ones = {run for run in runs if _can_open(problem, run)}
    if not open_ones:
        return None
    points, legs = [problem.waypoints[0]], list[Leg]()
    q, qd, cfx = [base.q[0]], [base.qd[0]], [base.cfx[0]]
    motions, owners = list[LegMotion | None](), list[tuple[int, ...]]()
    stops: list[int | None] = [0] + [None] * len(problem.legs)
    for first, last in problem.runs:
        if (first, last) in open_ones:
            run = _Run(axes, problem, base, first, last)
            for leg, motion, owner, cut, state in run.legs():
                legs.append(replace(leg, start=len(legs)))
                motions.append(motion)
                owners.append(owner)
                if cut is not None:
                    points.append(cut.point)
                    cfx.append(cut.cfx)
                    q.append(state[0])
                    qd.append(state[1])
        else:
            fixed = (first, last) in runs
            for k in range(first, last):
                if fixed:
                    points[-1] = _fixed(problem, base, k, points[-1])
                legs.append(replace(problem.legs[k], start=len(legs)))
                motions.append(base.legs[k])
                owners.append((k,))
                if k + 1 < last:
                    stops[k + 1] = len(points)
                    points.append(problem.waypoints[k + 1])
                    q.append(base.q[k + 1])
                    qd.append(base.qd[k + 1])
                    cfx.append(base.cfx[k + 1])
        stops[last] = len(points)
        end = problem.waypoints[last]
        points.append(
            _fixed(problem, base, last, end) if (first, last) in runs and (first, last) not in open_ones else end
        )
        q.append(base.q[last])
        qd.append(base.qd[last])
        cfx.append(base.cfx[last])
    ties = (tuple(i for k in group if (i := stops[k]) is not None) for group in problem.ties)
    kept = {one.name: getattr(problem, one.name) for one in fields(Problem)}
    own = {
        "waypoints": tuple(points),
        "legs": tuple(legs),
        "stations": stations_of(legs, len(points)),
        "ties": tuple(group for group in ties if len(group) > 1),
    }
    back = {"whole": problem, "base": base, "owners": tuple(owners), "stops": tuple(stops)}
    return OpenedProblem(**{**kept, **own, **back}), Iterate(np.array(q), np.array(qd), tuple(cfx), tuple(motions))


def _fixed(problem: Problem, base: Iterate, k: int, point: Waypoint) -> Waypoint:
    """A waypoint of a run that stays as it is."""
    return replace(point.standing(problem.layout, base.q[k]), rest=not problem.passes(k), turn=None)


def _can_open(problem: Problem, run: tuple[int, int]) -> bool:
    first, last = run
    legs = problem.legs[first:last]
    in_a_row = "".join("s" if short(problem, k) else " " for k in range(first, last))
    if "s" * _MANY in in_a_row:
        return False
    if any(leg.kind is LegKind.DWELL or leg.units or leg.least > 0 or leg.duration is not None for leg in legs):
        return False
    if any(leg.segment is not None and not leg.segment.evenly_turned for leg in legs):
        return False
    for k in range(first + 1, last):
        zone, (before, after) = problem.waypoints[k].fly_by, problem.legs[k - 1 : k + 1]
        assert zone is not None
        if zone.joint or not np.array_equal(before.X_FT, after.X_FT):
            return False
        if before.segment is not None and after.segment is not None:
            corner = _corner(problem, k)
            if not corner.whole or before.along is not None or after.along is not None:
                return False
    return True


def _measure(leg: Leg) -> float:
    """What zones count on a line or an arc: metres, or radians of a turn in place."""
    return leg.chord if leg.chord >= NO_WAY else leg.angle


def _corner(problem: Problem, k: int) -> Corner:
    """The corner between lines or arcs at waypoint k. Where nothing turns its orientation has no zone of its own."""
    zone, before, after = problem.waypoints[k].fly_by, problem.segment(k - 1), problem.segment(k)
    assert zone is not None
    if zone.in_place:
        return Corner(before, after, zone.turning / before.angle, zone.turning / after.angle)
    turns = before.angle + after.angle > NO_WAY
    return Corner.of_zone(before, after, zone.radius, zone.turning if turns else zone.radius)


def with_even_zones(problem: Problem) -> Problem:
    """The problem with zones of orientation no larger than those of position where lines or arcs meet that turn: inside
    the larger one the tool is then as long as it may on either of them, and one expression is all of a corner."""
    points = list(problem.waypoints)
    for k, (before, after) in enumerate(pairwise(problem.legs), start=1):
        zone = points[k].fly_by
        if zone is None or zone.joint or zone.in_place or before.segment is None or after.segment is None:
            continue
        if before.angle + after.angle > NO_WAY and zone.turning > zone.radius:
            points[k] = replace(points[k], fly_by=zone._replace(turning=zone.radius))
    return problem if points == list(problem.waypoints) else replace(problem, waypoints=tuple(points))


class _Run:
    """A run with corners, from one stop to the next, cut into legs."""

    def __init__(self, axes: Axes, problem: Problem, base: Iterate, first: int, last: int):
        self._axes, self._problem, self._base, self._first, self._last = axes, problem, base, first, last
        self._starts: dict[int, float] = {}
        self._parts: list[tuple[float, int, Piece]] = []  # when each begins, and its leg
        now = 0.0
        for k in range(first, last):
            self._starts[k] = now
            motion = base.legs[k]
            for piece in () if motion is None else _pieces(motion):
                self._parts.append((now, k, piece))
                now += piece.T
        self._starts[last] = now

    def legs(self) -> Iterator[tuple[Leg, LegMotion, tuple[int, ...], _Cut | None, tuple[Array, Array]]]:
        """Leg, motion at hand, owners, and the cut at its end with the state there; no cut at the run's end."""
        problem = self._problem
        todo: list[tuple[Leg, tuple[int, ...], _Cut | None, tuple[float, float]]] = []
        begins = 0.0  # s of the leg's own segment where it begins
        for k in range(self._first, self._last):
            leg = problem.legs[k]
            if k + 1 == self._last:
                todo.append((self._own(k, begins, 1.0), (k,), None, (begins, 1.0)))
                continue
            zone, after = problem.waypoints[k + 1].fly_by, problem.legs[k + 1]
            assert zone is not None
            if leg.segment is None and after.segment is None:
                todo.append((leg, (k,), self._in_sphere(k, zone.radius), (0.0, 1.0)))
                begins = 0.0
            elif leg.segment is None:
                begins = zone.radius / _measure(after)
                todo.append((leg, (k,), self._on(k + 1, begins, k + 1), (0.0, 1.0)))
            else:
                corner = None if after.segment is None else _corner(problem, k + 1)
                end = 1.0 - (zone.radius / _measure(leg) if corner is None else corner.fraction_before)
                if end > begins + _TOUCH:
                    todo.append((self._own(k, begins, end), (k,), self._on(k, end, k + 1), (begins, end)))
                begins = 0.0 if corner is None else corner.fraction_after
                if corner is not None:
                    bend = _either(leg, after, corner, problem.waypoints[k + 1].turn is not None)
                    todo.append((bend, (k, k + 1), self._on(k + 1, begins, k + 1), (0.0, 1.0)))
        now = 0.0
        for i, (leg, owners, cut, part) in enumerate(todo):
            if cut is not None and any(one[0].kind is LegKind.LINE and one[0].turn is None for one in todo[i : i + 2]):
                cut = replace(cut, point=replace(cut.point, turn=None))
            then = self._starts[self._last] if cut is None else self._time(cut)
            motion = self._motion(leg, part, now, then)
            sample = motion.sample(self._axes, np.array([motion.T]), right=False)
            yield leg, motion, owners, cut, (sample.q[0], sample.qd[0])
            now = then

    # ---- legs and cuts
    def _own(self, k: int, a: float, b: float) -> Leg:
        """Leg k from s = a to b of its line or arc; all of a joint move."""
        leg = self._problem.legs[k]
        if leg.segment is None or (a, b) == (0.0, 1.0):
            return leg
        return replace(leg, segment=leg.segment.between(a, b), turn=leg.turn and leg.turn.between(a, b))

    def _in_sphere(self, k: int, radius: float) -> _Cut:
        """Between joint moves k and k + 1."""
        point, X_FT = self._problem.waypoints[k + 1], self._problem.legs[k].X_FT
        return _Cut(k, 1.0, replace(point, q=None, fly_by=None, passage=Passage(X_FT, radius=radius), turn=None), -1)

    def _on(self, k: int, s: float, corner: int) -> _Cut:
        """At s of the line or arc of leg k, at an edge of the zone of a waypoint."""
        leg, point = self._problem.legs[k], self._problem.waypoints[corner]
        assert leg.segment is not None
        at = np.array([s])
        X_WT, twist = leg.segment.pose(at)[0], leg.segment.twist(at)[0]
        size = float(np.linalg.norm(twist[:3] if leg.chord >= NO_WAY else twist[3:]))
        step = _WAY / size
        way = _line_along(X_WT, twist * step)
        if not point.free and self._axes.layout.has_rail:
            point = point.standing(self._problem.layout, self._at(self._time_on(k, s)))
        cfx = next(piece.cfx for _, own, piece in self._parts if own == k and isinstance(piece, PathLeg))
        own = replace(point, X_WF=X_WT @ inverse_pose(leg.X_FT), q=None, fly_by=None,
                      passage=Passage(leg.X_FT, way, _WAY), turn=leg.turn and leg.turn.between(s, 1.0))  # fmt: skip
        return _Cut(k, s, own, cfx)

    # ---- the motion at hand
    def _time(self, cut: _Cut) -> float:
        if cut.point.passage is not None and cut.point.passage.way is None:
            return self._starts[cut.leg + 1]
        return self._time_on(cut.leg, cut.s)

    def _time_on(self, k: int, s: float) -> float:
        """When the motion at hand is at s of the line or arc of leg k."""
        for start, own, piece in self._parts:
            if own == k and isinstance(piece, PathLeg):
                scale, shift = _on_line(piece)
                at = (s - shift) / scale
                if at <= piece.s[-1] + _TOUCH:
                    return start + _when(piece, at)
        return self._starts[k + 1]

    def _at(self, time: float) -> Array:
        """All axes (n,) at a time."""
        start, _, piece = [one for one in self._parts if one[0] <= time + _MOMENT][-1]
        return piece.sample(self._axes, np.array([np.clip(time - start, 0.0, piece.T)])).q[0]

    def _motion(self, leg: Leg, part: tuple[float, float], begin: float, end: float) -> LegMotion:
        """The motion at hand between two times, on a leg that is a part of a line or an arc."""
        parts = []
        for start, _, piece in self._parts:
            a, b = max(begin - start, 0.0), min(end - start, piece.T)
            if b - a > _MOMENT:
                parts.append(excerpt(self._axes, piece, a, b))
        if leg.kind is LegKind.JOINT:
            return Pieces(tuple(parts)) if len(parts) > 1 else parts[0]
        ways = [(piece, *_onto(leg, part, piece)) for piece in parts if isinstance(piece, PathLeg)]
        T = sum(piece.T for piece, _, _ in ways)
        begins = np.cumsum([0.0, *(piece.T for piece, _, _ in ways)]) / T
        grid = np.concatenate(
            [*(at + one.grid[:-1] * one.T / T for at, (one, *_) in zip(begins, ways, strict=False)), [1.0]]
        )
        rows = [np.column_stack([scale * one.s + shift, one.d, scale * one.v * T / one.T, one.w * T / one.T])
                for one, scale, shift in ways]  # fmt: skip
        nodes = np.vstack([*(own[:-1] for own in rows), rows[-1][-1:]])
        r = ways[0][0].d.shape[1]
        s, d, v, w = nodes[:, 0], nodes[:, 1 : 1 + r], nodes[:, 1 + r], nodes[:, 2 + r :]
        s[0], s[-1] = 0.0, 1.0
        h = np.diff(grid)
        reference = ways[0][0].sample(self._axes, np.zeros(1)).q[0, self._axes.layout.arm]
        assert leg.segment is not None
        return PathLeg(
            T, leg.segment, leg.X_FT, ways[0][0].cfx, reference, grid, s, v, np.diff(v) / h, d, w,
            np.diff(w, axis=0) / h[:, None],
        )  # fmt: skip


def _onto(leg: Leg, part: tuple[float, float], piece: PathLeg) -> tuple[float, float]:
    """scale, shift: s of a leg, which is a part of a line or an arc or a corner, is scale s + shift of a piece."""
    if isinstance(leg.segment, Corner):
        assert isinstance(piece.segment, Corner)
        bent = piece.segment.position / leg.segment.position
        return 1 / bent, 0.5 - 0.5 / bent
    (scale, shift), (a, b) = _on_line(piece), part
    return scale / (b - a), (shift - a) / (b - a)


def _on_line(piece: PathLeg) -> tuple[float, float]:
    """scale, shift: s of a leg's line or arc is scale s + shift of a piece of it, which may be half of a corner."""
    corner = piece.segment
    if not isinstance(corner, Corner):
        return 1.0, 0.0
    if piece.s[-1] > 0.5 + _TOUCH:
        return 2 * corner.fraction_after, -corner.fraction_after
    return 2 * corner.fraction_before, 1 - corner.fraction_before


def _either(before: Leg, after: Leg, corner: Corner, turning: bool) -> Leg:
    """The corner between two legs: what either of them allows, as one goes over into the other; if turning, of turns of
    the tool what both do all through it."""
    turn = None
    if turning and before.turn is not None and after.turn is not None:
        ends = [before.turn.between(s, 1.0) for s in (1 - corner.fraction_before, 1.0)]
        ends += [after.turn.between(s, 1.0) for s in (0.0, corner.fraction_after)]
        turn = replace(ends[0], low=max(one.low for one in ends), high=min(one.high for one in ends), slope=0.0)
    return replace(
        before,
        segment=corner,
        v_tcp=max(before.v_tcp, after.v_tcp),
        a_tcp=max(before.a_tcp, after.a_tcp),
        v_ori=max(before.v_ori, after.v_ori),
        v_rail=max(before.v_rail, after.v_rail),
        acceleration=max(before.acceleration, after.acceleration),
        rail_moves=before.rail_moves and after.rail_moves,
        turn=turn,
    )


def _line_along(X: Array, twist: Array) -> Line:
    """The line from a pose (4, 4) that goes by a twist (6,) at its start."""
    R = rotations_by((X[:3, :3].T @ twist[3:])[None])[0]
    return Line(X, pose(X[:3, :3] @ R, X[:3, 3] + twist[:3]))


def _pieces(motion: LegMotion) -> Sequence[Piece]:
    return motion.pieces if isinstance(motion, Pieces) else (motion,)


def _when(motion: PathLeg, s: float) -> float:
    """The time at which a share of a way is done."""
    low, high = 0.0, motion.T
    if s >= motion.s[-1]:
        return high
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        done = motion.progress(np.array([middle]), right=True)[0, 0, 0]
        low, high = (middle, high) if done < s else (low, middle)
    return high


def excerpt(axes: Axes, motion: Piece, begin: float, end: float) -> Piece:
    """What a motion does between two of its times."""
    if begin <= 0.0 and end >= motion.T:
        return motion
    breaks = motion.breaks()
    times = np.concatenate([[begin], breaks[(breaks > begin + _MOMENT) & (breaks < end - _MOMENT)], [end]])
    T, grid = end - begin, (times - begin) / (end - begin)
    h = np.diff(grid)[:, None]
    if not isinstance(motion, PathLeg):
        sample = motion.sample(axes, times)
        v = sample.qd * T
        return JointNodes(T, grid, sample.q, v, np.diff(v, axis=0) / h)
    nodes = times / motion.T
    s, v, _ = integrate(motion.grid, motion.s[:, None], motion.v[:, None], nodes)
    d, w, _ = integrate(motion.grid, motion.d, motion.w, nodes)
    v, w = v * T / motion.T, w * T / motion.T
    reference = motion.sample(axes, times[:1]).q[0, axes.layout.arm]
    return replace(
        motion, T=T, reference=reference, grid=grid, s=s[:, 0], v=v[:, 0], a=(np.diff(v, axis=0) / h)[:, 0], d=d, w=w,
        b=np.diff(w, axis=0) / h,
    )  # fmt: skip
