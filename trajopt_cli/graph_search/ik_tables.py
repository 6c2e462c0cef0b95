"""Where the rail may stand: arm joints over the rail's range for every waypoint and along every line, per IK branch.

A station's table is continued along its lines, so one branch and one set of whole turns means one continuous
configuration in the whole station. What cannot be reached is named here, before any optimising.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby, product

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.graph_search.singular_start import SingularStart, usable
from trajopt_cli.limits import Couplings
from trajopt_cli.path.line import Line
from trajopt_cli.problem.problem import Leg, LegKind, Problem, Waypoint
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.settings import Settings
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import ClearanceQueries
from trajopt_cli.trajectories.route import IkBranch

_FEWEST_NODES = 3  # of them on a short line.

_SAME = 1e-12  # m or 1: poses
_FAR = np.pi / 2  # rad from node to node of a line: it may have been the other way round
_CLOSE = 512  # places between such nodes
_HALF_TURN = 3.1  # rad: below, a turn and the way back are about one axis


@dataclass(frozen=True, eq=False)
class IkTable:
    """Arm joints of one station on a rail grid.

    d: (n,); waypoints: for each (L, n, m) with NaN where the configuration is not to be had, L labels; raw: per leg
    (branches, nodes, n, m) without turns, None for dwells. At a waypoint with fixed joints only its own rail value is
    open. limits (2, m): lower and upper ones; couplings: of sums of joints. leaves (L, n): where the first line begins
    at a singularity, to which places the rail can go in proportion; else None.
    """

    first: int
    d: Array
    labels: tuple[IkBranch, ...]
    waypoints: tuple[Array, ...]
    raw: tuple[Array | None, ...]
    limits: Array
    couplings: Couplings
    leaves: BoolArray | None = None

    def line(self, i: int) -> Array | None:
        """Joints (L, nodes, n, m) along leg i of the station, NaN where the configuration is not to be had; None for a
        dwell."""
        raw = self.raw[i]
        if raw is None:
            return None
        q = raw[[label.cfx for label in self.labels]] + np.array([label.turns for label in self.labels])[:, None, None]
        return np.where(self._within(q)[..., None], q, np.nan)

    def open_on(self, i: int) -> BoolArray:
        """Where (L, nodes, n) along line i of the station each label is to be had."""
        raw = self.raw[i]
        assert raw is not None
        open_ = np.ones((len(self.labels), *raw.shape[1:3]), dtype=bool)
        for j, turn, some, cfx in self._turned:
            q = raw[..., j] + turn
            open_[some] &= ((q >= self.limits[0, j]) & (q <= self.limits[1, j]))[cfx]
        if self.couplings:
            for label, one in zip(self.labels, open_, strict=True):
                one &= self.couplings.within(raw[label.cfx] + label.turns)
        return open_

    @cached_property
    def _turned(self) -> list[tuple[int, float, IndexArray, IndexArray]]:
        """Of every joint and whole turn the labels that have it, and their branches."""
        cfx, turns = np.array([label.cfx for label in self.labels]), np.array([label.turns for label in self.labels])
        pairs = [(j, value) for j, turn in enumerate(turns.T) for value in np.unique(turn).tolist()]
        return [(j, value, some, cfx[some]) for j, value in pairs for some in np.nonzero(turns[:, j] == value)]

    @property
    def serves_lines(self) -> bool:
        """Whether every line has a label that serves all of it from one rail position, whichever."""
        lines = [i for i, raw in enumerate(self.raw) if raw is not None]
        return all(self._ends_open(i)[self.open_on(i).all(axis=1)].any() for i in lines)

    def _ends_open(self, i: int) -> BoolArray:
        """Where (L, n) each label is to be had at both ends of leg i."""
        return ~np.isnan(self.waypoints[i][..., 0]) & ~np.isnan(self.waypoints[i + 1][..., 0])

    def _within(self, q: Array) -> BoolArray:
        each = np.all((q >= self.limits[0]) & (q <= self.limits[1]), axis=-1)
        return np.asarray(each & self.couplings.within(q)) if self.couplings else np.asarray(each)


def rail_grid(problem: Problem, first: int, last: int, n: int, window: tuple[float, float] | None = None) -> Array:
    """Grid of rail positions for the waypoints first..last, fixed values included exactly."""
    ranges = [problem.waypoints[k].rail for k in range(first, last + 1)]
    fixed = [low for low, high in ranges if low == high]
    free = [r for r in ranges if r[0] != r[1]]
    if not free:
        return np.unique(np.r_[fixed, np.linspace(min(fixed), max(fixed), n)])
    low, high = free[0]
    if window:
        low, high = max(low, window[0]), min(high, window[1])
    return np.unique(np.r_[np.linspace(low, high, n), fixed])


def grid_in_reach(axes: Axes, problem: Problem, first: int, last: int, fewest: int, apart: float) -> Array:
    """The same over the whole stroke, fewest positions or more that are no farther apart [m]; left out are those from
    which the arm is too short for all waypoints and all ways between them."""
    ranges = [problem.waypoints[k].rail for k in range(first, last + 1)]
    low, high = next(((low, high) for low, high in ranges if low != high), (0.0, 0.0))
    d = rail_grid(problem, first, last, max(fewest, 1 + int(np.ceil((high - low) / apart - 1e-9))))
    if low == high:
        return d
    near = np.clip(hull_in_reach(axes, problem, first, last), d[0], d[-1])
    step = float(np.diff(d).max())
    fixed = np.array([at for at, end in ranges if at == end])
    return np.asarray(d[((d > near[0] - step) & (d < near[1] + step)) | np.isin(d, fixed)])


def hull_in_reach(axes: Axes, problem: Problem, first: int, last: int) -> tuple[float, float]:
    """From which rail position to which [m] the arm could be long enough for some of the waypoints first..last."""
    ends = reach_intervals(axes, problem, first, last)
    return float(ends.min()), float(ends.max())


def reach_intervals(axes: Axes, problem: Problem, first: int, last: int) -> Array:
    """From which rail position to which (k, 2) [m] the arm could be long enough for each of the waypoints first..last,
    and for places on the lines between them."""
    X_WF = [problem.seen(k) for k in range(first, last + 1)]
    for leg in problem.legs[first:last]:
        if leg.segment is not None and leg.chord > 0:
            X_WF += [*problem.seen_along(leg, np.array([0.25, 0.5, 0.75]))]
    return np.asarray(axes.robot.rail_within(np.array(X_WF), axes.layout.sought))


def _unwrap(arm: Array, axis: int) -> Array:
    """Whole turns removed between neighbours along an axis, gaps of NaN bridged."""
    x = np.moveaxis(arm, axis, 0)
    turns = _windings(x)
    return arm if turns is None else np.moveaxis(x - 2 * np.pi * turns, 0, axis)


def _with_whole_turns(axes: Axes, problem: Problem, leg: Leg, line: Array, d: Array) -> Array:
    """A line (b, nodes, n, m) without whole turns between neighbouring nodes, but those that an axis turns on its way
    from one to the next: close to a singularity it may turn by more than half of one."""
    far = np.abs(np.diff(line, axis=1)).max(axis=-1) > _FAR  # (b, nodes - 1, n); NaN is not
    for i in np.flatnonzero(far.any(axis=(0, 2))):
        at = np.flatnonzero(far[:, i].any(axis=0))
        s = (i + np.linspace(0, 1, _CLOSE + 1)) / (line.shape[1] - 1)
        X = problem.seen_along(leg, s)
        arm = axes.inverse(np.repeat(X, len(at), axis=0), np.tile(d[at], len(s)))
        arm = np.moveaxis(arm.reshape(len(s), len(at), *arm.shape[1:]), 2, 0)
        arm[:, 0] = line[:, i, at]
        turns = np.round((_unwrap(arm, 1)[:, -1] - line[:, i + 1, at]) / (2 * np.pi))
        line[:, i + 1 :, at] += 2 * np.pi * np.where(far[:, i, at, None], turns, 0.0)[:, None]
    return line


def _unwrap_beside(line: Array, known: BoolArray) -> Array:
    """Whole turns removed between neighbouring columns of a line (b, nodes, n, m). Columns (b, n) that are known stay
    as they are; the others are continued from the known one before, or from the first.

    A column that is continued from the line's start is known. Beside it another may go round axis 1 the other way.
    """
    x = np.moveaxis(line, 2, 0)
    turns = _windings(x)
    if turns is None:
        return line
    rows = np.arange(len(x))[:, None]
    before = np.maximum.accumulate(np.where(known.T, rows, -1), axis=0)
    near = np.where(before >= 0, before, np.argmax(known, axis=1))
    turns = turns - np.take_along_axis(turns, near[:, :, None, None], axis=0)
    return np.moveaxis(x - 2 * np.pi * turns, 0, 2)


def _windings(x: Array) -> Array | None:
    """Whole turns by which values (k, ..., m) are ahead of the first, gaps of NaN bridged; None for none anywhere."""
    missing = np.isnan(x[..., 0])  # all joints of a place or none
    before = x[:-1]
    if missing.any():
        rows = np.arange(len(x)).reshape(-1, *[1] * (missing.ndim - 1))
        held = np.maximum.accumulate(np.where(missing, 0, rows), axis=0)
        before = np.take_along_axis(x, held[:-1, ..., None], axis=0)
    apart = x[1:] - before
    if not np.any(np.abs(apart) > np.pi):
        return None
    steps = np.nan_to_num(np.round(apart / (2 * np.pi)))
    return np.concatenate([np.zeros_like(x[:1]), np.cumsum(steps, axis=0)])


def line_nodes(leg: Leg, settings: Settings) -> int:
    """How many points of a line or an arc are held against the inverse kinematics: fewer on short ones."""
    share = max(leg.chord / settings.long_line, leg.angle / settings.long_turn)
    return int(
        np.clip(1 + np.ceil((settings.line_samples - 1) * min(share, 1.0)), _FEWEST_NODES, settings.line_samples)
    )


def _on_lines(axes: Axes, problem: Problem, legs: Sequence[tuple[Leg, int]], d: Array, pinned: bool) -> Iterator[Array]:
    """Joints (branches, nodes, n, m) along lines with so many nodes, in whatever turn, where they are usable."""
    settings = axes.settings
    n = len(d)
    behind = np.cumsum([nodes * n for _, nodes in legs])
    for _, group in groupby(range(len(legs)), key=lambda i: int(behind[i]) // (2 * settings.batch)):
        checkpoint()
        some = [legs[i] for i in group]
        X = [problem.seen_along(leg, np.linspace(0, 1, m)) for leg, m in some]
        counts = [m for _, m in some]
        arm = axes.inverse(np.repeat(np.concatenate(X), n, axis=0), np.tile(d, sum(counts)))
        arm = np.moveaxis(usable(axes, arm, pinned).reshape(sum(counts), n, *arm.shape[1:]), 2, 0)
        yield from np.split(arm, np.cumsum(counts)[:-1], axis=1)


def reversed_leg(problem: Problem, first: int, k: int) -> int | None:
    """The leg from waypoint first on, before leg k and waits, along which leg k leads straight back; None for none."""
    j = k - 1
    while j >= first and problem.legs[j].kind is LegKind.DWELL:
        j -= 1
    leg, back = problem.legs[k], problem.legs[j]
    if j < first or not (isinstance(leg.segment, Line) and isinstance(back.segment, Line)):
        return None
    held, its = ([problem.waypoints[i].held for i in ends] for ends in ((k, k + 1), (j + 1, j)))
    if held != its:
        return None
    apart = (leg.segment.X_0 - back.segment.X_1, leg.segment.X_1 - back.segment.X_0, leg.X_FT - back.X_FT)
    return j if leg.angle < _HALF_TURN and np.abs(apart).max() < _SAME else None


def _raw(
    axes: Axes, problem: Problem, first: int, last: int, d: Array, given: SingularStart | None
) -> tuple[list[Array], list[Array | None], BoolArray | None]:
    """Joints of a station by branch at its waypoints (branches, n, m) and along its legs (branches, nodes, n, m), each
    continued from the one before; and where the first line can leave to."""
    settings = axes.settings
    leaves, pinned = None, rail_pinned(problem, first, last)
    if given is not None:
        start, leaves = given.table(axes, problem, d)
    else:
        arm = axes.inverse(np.broadcast_to(problem.seen(first), (len(d), 4, 4)), d)
        arm = np.moveaxis(arm, 1, 0)
        start = _unwrap(arm if _at_rest(problem, first, last) else usable(axes, arm, pinned), 1)
    stops, lines = [start], list[Array | None]()
    legs = problem.legs[first:last]
    left = None if given is None else given.leg
    backs = [None if leg is left else reversed_leg(problem, first, first + i) for i, leg in enumerate(legs)]
    backs = [None if back is not None and problem.legs[back] is left else back for back in backs]
    asked = [leg for leg, back in zip(legs, backs, strict=True) if leg.segment is not None and back is None]
    found = _on_lines(
        axes, problem,
        [(leg, settings.line_samples if leg is left else line_nodes(leg, settings)) for leg in asked], d, pinned,
    )  # fmt: skip
    for leg, back in zip(legs, backs, strict=True):
        if leg.segment is None:
            stops.append(stops[-1])
            lines.append(None)
            continue
        if back is not None:
            line = lines[back - first]
            assert line is not None
            lines.append(line[:, ::-1])
            stops.append(line[:, 0])
            continue
        raw = next(found)
        raw[:, 0] = stops[-1]
        # along the line first; then along the rail, for columns whose start is out of reach and gave no reference
        line = _unwrap_beside(_with_whole_turns(axes, problem, leg, _unwrap(raw, 1), d), ~np.isnan(raw[:, 0, :, 0]))
        lines.append(line)
        stops.append(line[:, -1])
    return stops, lines, leaves


def station_table(
    axes: Axes, problem: Problem, first: int, last: int, d: Array, around: ClearanceQueries | None = None
) -> IkTable:
    """Tables of one station; around: what must not be touched, at the waypoints and at the nodes of lines."""
    checkpoint()
    given = SingularStart.of(axes, problem, first, last)
    stops, lines, leaves = _raw(axes, problem, first, last, d, given)
    if around is not None:
        stops, lines = _without_contacts(axes, problem, first, d, stops, lines, around)
    limits = np.array([axes.lower[axes.layout.arm] - 1e-9, axes.upper[axes.layout.arm] + 1e-9])
    couplings = axes.couplings.arm(axes.layout.arm)
    alone = problem.waypoints[first].q if first == last else None
    if alone is not None:
        d, arm = axes.layout.place(alone[None]), alone[axes.layout.arm]
        return IkTable(first, d, (IkBranch(-1, np.zeros_like(arm)),), (arm[None, None],), (), limits, couplings)
    branches = np.arange(len(stops[0]))
    if axes.robot.linkage and all(stop.q is None for stop in problem.waypoints[first : last + 1]):
        branches = branches[branches & 2 == 0]  # where no joints are given, it stays unfolded
    labels = [IkBranch(cfx, turns) for cfx, turns in product(branches.tolist(), axes.robot.turns)]
    kept = np.arange(len(labels))
    tables: list[Array] = []
    for i, raw in enumerate(stops):  # a label that is not to be had at some waypoint is none
        if not len(kept):
            break
        of = [labels[j] for j in kept]
        q = raw[[label.cfx for label in of]] + np.array([label.turns for label in of])[:, None]
        tables.append(np.where(_admissible(axes, problem.waypoints[first + i], q, d, limits)[..., None], q, np.nan))
        some = ~np.isnan(tables[-1][..., 0]).all(axis=1)
        if not some.all():
            kept, tables = kept[some], [one[some] for one in tables]
    return IkTable(
        first,
        d,
        tuple(labels[j] for j in kept),
        tuple(tables),
        tuple(lines),
        limits,
        couplings,
        None if leaves is None else leaves[[labels[j].cfx for j in kept]],
    )


def _without_contacts(
    axes: Axes, problem: Problem, first: int, d: Array, stops: list[Array], lines: list[Array | None],
    around: ClearanceQueries,
) -> tuple[list[Array], list[Array | None]]:  # fmt: skip
    """The joints of a station, NaN where the robot touches something; whole turns do not matter to that."""

    def kept(arm: Array, motions: set[int], held: Array) -> Array:
        every = axes.layout.join(np.broadcast_to(d, arm.shape[:-1]), arm)
        every[..., axes.layout.others] = held
        q = every.reshape(-1, axes.n)
        free = np.ones(len(q), dtype=bool)
        for index in {around.scene(motion): motion for motion in sorted(motions)}.values():
            free &= around.free(q, index)
        return np.where(free.reshape(arm.shape[:-1])[..., None], arm, np.nan)

    legs = problem.legs
    beside = [{legs[k].motion for k in (first + i - 1, first + i) if 0 <= k < len(legs)} for i in range(len(stops))]
    at = [np.array(problem.waypoints[first + i].held) for i in range(len(stops))]
    nodes = []
    for i, raw in enumerate(lines):
        if raw is not None:
            s = np.linspace(0, 1, raw.shape[1])[:, None, None]
            raw = kept(raw, {legs[first + i].motion}, at[i] + s * (at[i + 1] - at[i]))
        nodes.append(raw)
    return [kept(stop, motions, held) for stop, motions, held in zip(stops, beside, at, strict=True)], nodes


def _admissible(axes: Axes, point: Waypoint, q: Array, d: Array, limits: Array) -> BoolArray:
    """Where joints q (L, n, m) at rail positions d (n,) may be those of a waypoint."""
    ok = np.all((q >= limits[0]) & (q <= limits[1]), axis=-1) & axes.couplings.arm(axes.layout.arm).within(q)
    if point.rail[0] == point.rail[1]:
        ok &= np.abs(d - point.rail[0]) < 1e-12
    if point.conf is not None:
        there = all(abs(held - own) < 1e-12 for held, own in zip(point.held, point.also, strict=True))
        at = (np.abs(d - point.written) < 1e-12) & there
        ok[:, at] &= axes.robot.admits(point.conf, q[:, at])
    if point.q is not None:
        ok &= np.all(np.abs(q - point.q[axes.layout.arm]) < 1e-6, axis=-1)
    return np.asarray(ok)


def rail_pinned(problem: Problem, first: int, last: int) -> bool:
    """Whether the rail is given at every waypoint of a station, or there is none."""
    return all(low == high for low, high in (point.rail for point in problem.waypoints[first : last + 1]))


def _at_rest(problem: Problem, first: int, last: int) -> bool:
    """Whether no axis moves in a station, so that no singularity matters to it."""
    return rail_pinned(problem, first, first) and not any(
        leg.segment or leg.rail_moves for leg in problem.legs[first:last]
    )
