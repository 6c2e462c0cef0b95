"""A legal motion before any nonlinear program: the search's chain, its rail positions refined, every run timed by TOPP.

The axes of a leg share one progress, as a RAPID controller drives them; so the motion serves both targets. Between two
stops the rail's positions decide everything else. They are refined by dynamic programming over a few positions beside
those at hand, with every leg timed along its way, in steps that shrink until nothing is gained.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import dataclass, replace
from itertools import groupby, pairwise

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.course import Along, course_of, rates, spaced
from trajopt_cli.optimize.double_integrator import trapezoid_time
from trajopt_cli.optimize.draft import Draft
from trajopt_cli.optimize.exchange import check_leg
from trajopt_cli.optimize.legs import JointNodes, JointProfiles, LegMotion, PathLeg
from trajopt_cli.optimize.pace import Shares, Unresolved, clean, columns, law_of, top_rate
from trajopt_cli.optimize.profiles import hold, profiles
from trajopt_cli.optimize.search import Chain, best_chain
from trajopt_cli.optimize.smooth import rest_time, smooth
from trajopt_cli.optimize.tuning import (
    ALONE_NODES,
    CALM,
    CARRY,
    CARRY_LAST,
    JERK_ROOM,
    LATE,
    LEAST_POLISH,
    LONG_LINE,
    LONG_TURN,
    MOST_MARKS,
    OVER,
    PAIR_NODES,
    PAIRS_AT_ONCE,
    POLISH,
    POLISH_LAST,
    POLISH_STEP,
    REFINE_GAIN,
    REFINE_LAST,
    REFINE_NARROW,
    REFINE_OFFSETS,
    REFINE_ROUNDS,
    REFINE_STEP,
    RUN_NODES,
    RUSH,
    SHORT_NODES,
    SLACK,
)
from trajopt_cli.path.along import along_all
from trajopt_cli.path.line import Line
from trajopt_cli.path.segment import Segment
from trajopt_cli.problem.alike import leg_name
from trajopt_cli.problem.freedom import RailFreedom
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.timing.retiming import fastest_laws

_SAME = 1e-9  # m between rail positions that are one
_JUMP = 1e-4  # rad, m between axes that are not one place


class NotDriven(Exception):
    """A run of a chain that no law drives: run, its first waypoint and last. least: the time [s] that a leg would take
    which the program gives less; singular: where the run passes a singularity; None where that is not why."""

    def __init__(self, run: tuple[int, int], least: float | None = None, singular: Unresolved | None = None):
        super().__init__(run)
        self.run, self.least, self.singular = run, least, singular


def incumbent(axes: Axes, problem: Problem, chain: Chain) -> Draft:
    """The legal motion from a chain; the problem may be of either coupling. Raises NotDriven."""
    return timed(axes, problem, refined(axes, problem, chain))


# ------------------------------------------------------------------------------------------------ timing of a chain


Runs = dict[bytes, tuple[dict[int, LegMotion], Sequence[Leg]]]  # motions of runs, by leg in the run; its legs


def timed(axes: Axes, problem: Problem, chain: Chain, known: Runs | None = None) -> Draft:
    """Every run driven along its coordinated course, at the chain's rail positions and configurations, as fast as all
    limits allow. known: runs of this plant that were driven before; those driven here are added. Raises NotDriven."""
    legs: list[LegMotion | None] = [None] * len(problem.legs)
    cfx = tuple(label.cfx for label in chain.labels)
    known = {} if known is None else known
    for first, last in problem.runs:
        name = run_name(problem, (first, last), chain.q, cfx)
        if name not in known:  # equal runs are driven alike
            found = _fastest(axes, problem, (first, last), chain.q, cfx)
            known[name] = {k - first: motion for k, motion in found.items()}, problem.legs[first:last]
        for k, motion in known[name][0].items():
            legs[first + k] = motion
    return Draft(chain.q, np.zeros_like(chain.q), cfx, tuple(legs))


def run_name(problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> bytes:
    """Equal for runs that are driven alike, between axes q (M, n) on branches cfx at all waypoints."""
    first, last = run
    points = [problem.waypoints[k].fly_by for k in range(first, last + 1)]
    name = repr((cfx[first : last + 1], points, problem.coupling.value)).encode() + q[first : last + 1].tobytes()
    return b"|".join([name, *(_leg_name(problem, k) for k in range(first, last))])


def _fastest(axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> dict[int, LegMotion]:
    """The run's motions in one go or, where axes are free, in parts between stops if that is faster."""
    parts = [run] if problem.coordinated else _stops(axes, problem, run, q, cfx)
    if parts == [run]:
        return _driven(axes, problem, run, q, cfx)
    ways: list[dict[int, LegMotion]] = []
    failure: NotDriven | None = None
    for tried in (parts, [run]):
        try:
            found = [_driven(axes, problem, part, q, cfx) for part in tried]
        except NotDriven as said:
            failure = failure or said
        else:
            ways.append({k: motion for part in found for k, motion in part.items()})
    if not ways:
        assert failure is not None
        raise failure
    return min(ways, key=lambda way: sum(motion.T for motion in way.values()))


def stopping(axes: Axes, problem: Problem, chain: Chain) -> Problem:
    """The problem with a stop at every fly-by where the timed chain stops."""
    cfx = tuple(label.cfx for label in chain.labels)
    ends = {last for run in problem.runs for _, last in _stops(axes, problem, run, chain.q, cfx)}
    return _with_stops(problem, ends)


def stopped(problem: Problem) -> Problem:
    """The problem with a stop at every fly-by but those between short lines, which no stop at each would resemble."""
    short = [_short(problem, k) for k in range(len(problem.legs))]
    return _with_stops(problem, {k for k in range(1, len(short)) if not (short[k - 1] and short[k])})


def stopped_at_joint_moves(problem: Problem) -> Problem:
    """The problem with a stop at every fly-by beside a joint move."""
    joint = [leg.kind is LegKind.JOINT for leg in problem.legs]
    return _with_stops(problem, {k for k in range(1, len(joint)) if joint[k - 1] or joint[k]})


def _with_stops(problem: Problem, at: Set[int]) -> Problem:
    points = (replace(point, fly_by=None) if k in at else point for k, point in enumerate(problem.waypoints))
    return replace(problem, waypoints=tuple(points))


def _stops(axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> list[tuple[int, int]]:
    """The run in parts between stops, if stopping at a fly-by beside a joint move is faster: between stops its axes
    need not keep to one progress."""
    first, last = run
    joint = [leg.kind is LegKind.JOINT for leg in problem.legs]
    marks = [first, *(k for k in range(first + 1, last) if joint[k - 1] or joint[k]), last]
    if len(marks) == 2:
        return [run]
    best: dict[int, tuple[float, list[tuple[int, int]]]] = {first: (0.0, [])}
    for at, end in enumerate(marks[1:], start=1):
        ways = []
        for start in marks[max(0, at - MOST_MARKS) : at]:
            T, parts = best[start]
            if np.isfinite(T):
                ways.append((T + _about(axes, problem, (start, end), q, cfx), [*parts, (start, end)]))
        best[end] = min(ways, default=(np.inf, []))
    T, parts = best[last]
    return parts if np.isfinite(T) else [run]


def _about(axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> float:
    """How long a run takes between stops, on a few nodes; infinite where it cannot be driven."""
    first, last = run
    if last == first + 1:
        simple = _simple(axes, problem, problem.legs[first], q[first], q[last])
        if simple is not None:
            return simple.T
    course = course_of(axes, problem, run, q, cfx, PAIR_NODES)
    law = None if course is None else law_of(axes, problem, course, Shares.full(len(course.part)))
    return np.inf if law is None else law.duration


def _driven(axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> dict[int, LegMotion]:
    first, last = run
    leg = problem.legs[first]
    alone = last == first + 1
    motion: PathLeg | JointNodes | JointProfiles | None = None
    if alone:
        motion = _simple(axes, problem, leg, q[first], q[last])
    if motion is None and axes.jerk is not None:
        motion = smooth(axes, problem, first, q, cfx)
        if motion is None:
            raise NotDriven(run)
    if motion is None:
        course = course_of(axes, problem, run, q, cfx, ALONE_NODES if alone else RUN_NODES)
        try:
            found = None if course is None else clean(axes, problem, course)
        except Unresolved as singular:
            raise NotDriven(run, singular=singular) from singular
        if found is None:
            raise NotDriven(run)
        if not alone:
            return dict(found)
        (motion,) = found[first].pieces  # one leg between stops is one piece
    if leg.duration is not None and leg.duration * (1 + 1e-9) < motion.T:
        raise NotDriven(run, motion.T)
    if leg.duration is not None and not isinstance(motion, JointProfiles):
        motion = replace(motion, T=leg.duration)
    return {first: motion}


def _simple(axes: Axes, problem: Problem, leg: Leg, q_0: Array, q_1: Array) -> JointProfiles | None:
    """The motion of a leg between stops that needs no TOPP: resting, or joint profiles that pass no cap of the tool."""
    if leg.kind is LegKind.DWELL and np.abs(q_1 - q_0).max() < _SAME:
        return hold(leg.duration or 0.0, q_0)
    if leg.kind is not LegKind.JOINT or axes.jerk is not None:
        return None
    still = np.zeros_like(q_0)
    V, A = axes.velocity_on(leg), axes.acceleration_on(leg)
    try:
        motion = profiles(q_0, still, q_1, still, V, A, leg.duration or 0.0, problem.coordinated)
    except ValueError:  # an axis whose switches a file could not tell apart
        return None
    ratios = check_leg(axes, leg, motion)
    return motion if max(ratios.tool.max(), ratios.position.max()) <= 1 + OVER else None


def duration(draft: Draft) -> float:
    """Cycle time [s] of a draft."""
    return float(sum(motion.T for motion in draft.legs if motion is not None))


# -------------------------------------------------------------------------------------------- refinement of the rail


def refined(axes: Axes, problem: Problem, chain: Chain) -> Chain:
    """The chain with the rail positions that the least time is found at, beside those it has."""
    free = [k for k, point in enumerate(problem.waypoints) if point.q is None and point.rail[0] < point.rail[1]]
    still = replace(chain, w=np.zeros_like(chain.w))
    if not free or not axes.layout.has_rail:
        return still
    marks, best = _smoothed(axes, problem, still)
    index = {k: i for i, k in enumerate(marks.tolist())}
    ties = tuple(tuple(index[k] for k in group) for group in problem.ties)
    reached, cost = np.inf, np.inf
    changed = np.ones(len(marks), dtype=bool)
    step = np.where(np.isin(np.arange(len(problem.waypoints)), free), REFINE_STEP, 0.0)
    near: list[Array] = []
    edges: list[Array] = []
    for _ in range(REFINE_ROUNDS):
        before = near
        found = iter(_near(axes, problem, best, marks[changed], step))
        near = [next(found) if new else before[i] for i, new in enumerate(changed)]
        edges = _edges(axes, problem, marks, near, best, before, edges)
        cost, path = best_chain(near, edges, ties)
        if not np.isfinite(cost):
            break
        q = np.array([near[k][i] for k, i in enumerate(path)])
        times = np.array([edges[k][path[k], path[k + 1]] for k in range(len(edges))])
        stays = np.abs(q - best.q[marks]).max(axis=1) < _SAME
        there = stays | (cost > reached * (1 - REFINE_GAIN))
        best, reached = _through(axes, problem, best, marks, q, times), cost
        last = np.where(_carrying(marks), CARRY_LAST, REFINE_LAST)
        if np.all(there & (step[marks] <= last)):
            break
        shorter = np.where(there & (step[marks] > last), np.maximum(step[marks] / 2, last), step[marks])
        changed, step[marks] = ~stays | (shorter != step[marks]), shorter
    return _rounded(axes, problem, best, marks)


def _rounded(axes: Axes, problem: Problem, chain: Chain, marks: IndexArray) -> Chain:
    """The chain with the rail on a cubic spline through the marks where points are carried along: between short lines
    there is no room for the rail to change its speed. As it is where the arm cannot follow."""
    from scipy.interpolate import CubicSpline  # takes longer to load than most programs to search

    q = chain.q.copy()
    for far, group in groupby(pairwise(marks.tolist()), key=lambda pair: pair[1] > pair[0] + 1):
        ends = [*group]
        if not far or len(ends) < 2:
            continue
        first, last = ends[0][0], ends[-1][1]
        knots = np.array([first, *(b for _, b in ends)])
        if np.ptp(axes.layout.place(q[knots])) < _SAME:  # the rail stands
            continue
        way = np.concatenate([[0.0], np.cumsum([leg.chord for leg in problem.legs[first:last]])])
        d = CubicSpline(way[knots - first], axes.layout.place(q[knots]), bc_type="natural")(way)
        found = _along_rail(axes, problem, chain, first, d[None, 1:-1])[0]
        if np.isfinite(found).all():
            q[first + 1 : last] = found
    return replace(chain, q=q)


def _carrying(marks: IndexArray) -> BoolArray:
    """Which of the marks have points beside them that are carried along."""
    far = np.diff(marks) > 1
    return np.r_[False, far] | np.r_[far, False]


def _smoothed(axes: Axes, problem: Problem, chain: Chain) -> tuple[IndexArray, Chain]:
    """The waypoints between which the rail is in proportion to the tool's way, and a chain in which it is: those that
    lie between short lines are carried along, but for one every CARRY of the way."""
    tied = {k for group in problem.ties for k in group}
    marks, way = [0], 0.0
    for k in range(1, len(problem.waypoints) - 1):
        point, (before, after) = problem.waypoints[k], problem.legs[k - 1 : k + 1]
        way += before.chord
        free = point.q is None and point.rail[0] < point.rail[1] and k not in tied
        alike = before.rail_moves == after.rail_moves and chain.labels[k - 1].cfx == chain.labels[k + 1].cfx
        if not (free and alike and _short(problem, k - 1) and _short(problem, k)) or way >= CARRY:
            marks.append(k)
            way = 0.0
    marks.append(len(problem.waypoints) - 1)
    q = chain.q.copy()
    left = list(pairwise(marks))
    while left:  # where the arm cannot follow a straight rail, the chain's own places
        a, b = left.pop()
        inner = _between(axes, problem, chain, a, b, chain.q[a][None], chain.q[b][None])[0]
        if np.isfinite(inner).all():
            q[a : b + 1] = inner
        else:
            middle = (a + b) // 2
            marks.append(middle)
            left += [(a, middle), (middle, b)]
    return np.array(sorted(marks)), replace(chain, q=q)


def _between(axes: Axes, problem: Problem, chain: Chain, a: int, b: int, q_0: Array, q_1: Array) -> Array:
    """Axes (m, b - a + 1, n) at the waypoints a to b, near those of a chain, between pairs of them at both ends, with
    the rail in proportion to the tool's way; NaN where the arm does not reach."""
    if b == a + 1:
        return np.stack([q_0, q_1], axis=1)
    way = np.cumsum([leg.chord for leg in problem.legs[a:b]])
    d_0, d_1 = (axes.layout.place(q)[:, None] for q in (q_0, q_1))
    inner = _along_rail(axes, problem, chain, a, d_0 + (way[:-1] / way[-1]) * (d_1 - d_0))
    return np.concatenate([q_0[:, None], inner, q_1[:, None]], axis=1)


def _along_rail(axes: Axes, problem: Problem, chain: Chain, a: int, d: Array) -> Array:
    """Axes (m, k, n) at the k waypoints behind number a at rail positions d (m, k), near those of a chain; NaN where
    they are not to be had."""
    layout, behind = axes.layout, slice(a + 1, a + 1 + d.shape[1])
    points = problem.waypoints[behind]
    low, high = np.array([point.rail for point in points]).T
    X_WF = np.tile([point.X_WF for point in points], (len(d), 1, 1))
    arm = axes.inverse(X_WF, d.ravel())[:, _branch(chain, a)].reshape(*d.shape, axes.n - layout.r)
    q = layout.join(d, arm + 2 * np.pi * np.round((chain.q[behind, layout.arm] - arm) / (2 * np.pi)))
    inside = np.all((q >= axes.lower - 1e-9) & (q <= axes.upper + 1e-9), axis=-1) & (d >= low) & (d <= high)
    return np.where(inside[..., None], q, np.nan)


def _through(axes: Axes, problem: Problem, chain: Chain, marks: IndexArray, q: Array, times: Array) -> Chain:
    """The chain through axes (m, n) at the marks, with the times (m - 1,) between them."""
    every, spent = chain.q.copy(), chain.times.copy()
    for i, (a, b) in enumerate(pairwise(marks.tolist())):
        every[a : b + 1] = _between(axes, problem, chain, a, b, q[i][None], q[i + 1][None])[0]
        way = np.array([leg.chord for leg in problem.legs[a:b]])
        spent[a:b] = times[i] if b == a + 1 else times[i] * way / way.sum()
    return replace(chain, q=every, times=spent, cost=float(times.sum()))


def polished(axes: Axes, problem: Problem, chain: Chain) -> Chain:
    """The chain with the rail shifted at the points of runs with corners, one after the other and all of a run, until
    nothing is gained: there a leg alone does not say how fast it is passed."""
    runs = [run for run in problem.runs if run[1] > run[0] + 1]
    tied = {k for group in problem.ties for k in group}
    cfx = tuple(label.cfx for label in chain.labels)
    q = chain.q.copy()

    known: dict[tuple[int, int], float] = {}

    def times(at: Sequence[int], q: Array) -> dict[tuple[int, int], float]:
        """Of all runs that points are in."""
        touched = [run for run in problem.runs if any(run[0] <= k <= run[1] for k in at)]
        return {run: _about(axes, problem, run, q, cfx) for run in touched}

    def open_(k: int) -> bool:
        point = problem.waypoints[k]
        held = any(not problem.legs[i].rail_moves for i in (k - 1, k) if 0 <= i < len(problem.legs))
        return point.q is None and point.rail[0] < point.rail[1] and k not in tied and not held

    left = POLISH
    for first, last in runs if axes.layout.has_rail and problem.freedom.rail is not RailFreedom.STATION else ():
        points = [k for k in range(first, last + 1) if open_(k)]
        if not points or 10 * (last - first) > left:
            continue
        known |= times(points, q)
        groups = [[k] for k in points] if len(points) < 2 else [points, *([k] for k in points)]
        step = POLISH_STEP
        while step >= POLISH_LAST and left > 0:
            gained = False
            for group in groups:
                for way in (step, -step):
                    left -= last - first
                    moved = _moved(axes, problem, q, cfx, group, way)
                    found = {} if moved is None or left < 0 else times(group, moved)
                    if moved is not None and sum(found.values()) < sum(known[run] for run in found) - LEAST_POLISH:
                        q, gained = moved, True
                        known |= found
                        break
            if not gained:
                step /= 3
    return replace(chain, q=q)


def _moved(axes: Axes, problem: Problem, q: Array, cfx: Sequence[int], at: Sequence[int], way: float) -> Array | None:
    """Axes (M, n) with the rail elsewhere [m] at some points, on their branches; None where that cannot be."""
    out = q.copy()
    for k in at:
        point, d = problem.waypoints[k], float(axes.layout.place(q[k])) + way
        arm = axes.inverse(point.X_WF[None], np.array([d]))[0, cfx[k]]
        turned = arm + 2 * np.pi * np.round((q[k, axes.layout.arm] - arm) / (2 * np.pi))
        out[k] = axes.layout.join(np.array(d), turned)
        if not (point.rail[0] <= d <= point.rail[1] and np.all((out[k] >= axes.lower) & (out[k] <= axes.upper))):
            return None
    return out


def _branch(chain: Chain, k: int) -> int:
    return chain.labels[k].cfx if chain.labels[k].cfx >= 0 else chain.labels[k + 1].cfx


def _near(axes: Axes, problem: Problem, chain: Chain, at: IndexArray, step: Array) -> list[Array]:
    """Axes (m, n) to try at each of some waypoints, those of the chain among them; step [m] at every waypoint."""
    points = [problem.waypoints[k] for k in at]
    free = [i for i, point in enumerate(points) if point.q is None and point.rail[0] < point.rail[1]]
    out = [chain.q[k][None] for k in at]
    if not free:
        return out
    k, low, high = at[free], *np.array([points[i].rail for i in free]).T
    d = axes.layout.place(chain.q[k])[:, None] + step[k][:, None] * np.array(REFINE_OFFSETS)
    far = np.abs(REFINE_OFFSETS) > 1
    d[:, far] = np.where(step[k][:, None] < REFINE_NARROW, d[:, ~far][:, :1], d[:, far])  # once is enough
    d = np.sort(np.clip(d, low[:, None], high[:, None]), axis=1)
    tries = d.shape[1]
    X_WF = np.repeat([points[i].X_WF for i in free], tries, axis=0)
    cfx = np.repeat([chain.labels[i].cfx for i in k], tries)
    arm = axes.inverse(X_WF, d.ravel())[np.arange(d.size), cfx]
    turned = arm + 2 * np.pi * np.round((np.repeat(chain.q[k][:, axes.layout.arm], tries, axis=0) - arm) / (2 * np.pi))
    q = axes.layout.join(d.ravel(), turned)
    ok = np.all((q >= axes.lower - 1e-9) & (q <= axes.upper + 1e-9), axis=1).reshape(d.shape)
    ok[:, 1:] &= np.diff(d, axis=1) > 0
    for i, every, these in zip(free, q.reshape(*d.shape, -1), ok, strict=True):
        if these.any():
            out[i] = every[these]
    return out


@dataclass(frozen=True, eq=False)
class _Pairs:
    """Axes q_0 and q_1 (m, n) at the ends of leg k, to be timed on branch cfx."""

    k: int
    q_0: Array
    q_1: Array
    cfx: int

    def only(self, these: IndexArray | BoolArray) -> _Pairs:
        """Some of the pairs."""
        return replace(self, q_0=self.q_0[these], q_1=self.q_1[these])


def _edges(
    axes: Axes,
    problem: Problem,
    marks: IndexArray,
    near: Sequence[Array],
    chain: Chain,
    before: Sequence[Array] = (),
    known: Sequence[Array] = (),
) -> list[Array]:
    """(m_a, m_b) least time from each mark to the next between the axes near them, infinite where it cannot be. A
    fly-by is passed as fast as may be: its corner is not looked at. known: the same between the axes that were near
    before."""
    timed, opens, out = [], [], []
    same = [None if a is b else _places(a, b) for a, b in zip(near, before, strict=True)] if before else []
    for i, (first, last) in enumerate(pairwise(marks.tolist())):
        a, b = near[i], near[i + 1]
        if before and a is before[i] and b is before[i + 1]:
            out.append(known[i])
            continue
        edge = np.full((len(a), len(b)), np.nan)
        if before:
            (at, at_before), (to, to_before) = (
                (np.arange(len(x)), np.arange(len(x))) if rows is None else rows
                for x, rows in zip((a, b), same[i : i + 2], strict=True)
            )
            edge[np.ix_(at, to)] = known[i][np.ix_(at_before, to_before)]
        ia, ib = np.nonzero(np.isnan(edge))
        worth = _worth(axes, problem, first, last, a[ia], b[ib], chain)
        edge[ia, ib] = np.inf
        ia, ib = ia[worth], ib[worth]
        q = _between(axes, problem, chain, first, last, a[ia], b[ib])
        can = np.isfinite(q).all(axis=(1, 2))
        q, cfx = q[can], _branch(chain, first)
        ia, ib = ia[can], ib[can]
        way = axes.layout.place(b[ib]) - axes.layout.place(a[ia])
        opens.append(
            (edge, ia, ib, last - first, way**2 / max(sum(leg.chord for leg in problem.legs[first:last]), 1e-9))
        )
        timed += [_Pairs(first + j, q[:, j], q[:, j + 1], cfx) for j in range(last - first)]
        out.append(edge)
    times = iter(leg_times(axes, problem, timed))
    for edge, ia, ib, legs, calm in opens:
        edge[ia, ib] = np.sum([next(times) for _ in range(legs)], axis=0)
        if legs > 1:  # of many that take the same time the calmest
            edge[ia, ib] += CALM * calm
    return out


def _places(a: Array, b: Array) -> tuple[IndexArray, IndexArray]:
    """Which rows of a (m, n) are rows of b, and which."""
    i, j = np.nonzero(np.abs(a[:, None] - b[None]).max(axis=2) < _SAME)
    return i, j


def _worth(axes: Axes, problem: Problem, first: int, last: int, q_0: Array, q_1: Array, chain: Chain) -> BoolArray:
    """Which pairs (m,) of axes at two marks are timed: the rail stays where it must, and where the tool passes both
    it goes at most as far as it can in a few times what the way takes, or as it goes now."""
    leg, place = problem.legs[first], axes.layout.place
    way = np.abs(place(q_1) - place(q_0))
    if not leg.rail_moves or (problem.freedom.rail is RailFreedom.STATION and leg.kind is not LegKind.JOINT):
        return np.asarray(way <= _SAME)
    if not _short(problem, first):
        return np.ones(len(way), dtype=bool)
    now = abs(float(place(chain.q[last]) - place(chain.q[first])))
    farthest = RUSH * float(place(axes.velocity_on(leg)) * chain.times[first:last].sum())
    return np.asarray(way <= max(now, farthest) + _SAME)


def _short(problem: Problem, k: int) -> bool:
    """Whether leg k is a short line or arc that is passed at both ends."""
    leg = problem.legs[k]
    short = leg.chord < LONG_LINE and leg.angle < LONG_TURN
    return leg.kind is LegKind.LINE and short and problem.passes(k) and problem.passes(k + 1)


def _nodes(problem: Problem, k: int) -> Array:
    """Shares (m,) of leg k at which it is looked at to be timed."""
    if not _short(problem, k):
        return spaced(PAIR_NODES)
    share = max(problem.legs[k].chord / LONG_LINE, problem.legs[k].angle / LONG_TURN)
    return np.linspace(0, 1, 1 + max(2, int(np.ceil(SHORT_NODES * share))))


def leg_times(axes: Axes, problem: Problem, pairs: Sequence[_Pairs]) -> list[Array]:
    """Least times (m,) of legs between axes, by TOPP on a few nodes; of equal ones once."""
    names = [_name(problem, one) for one in pairs]
    distinct = {name: one for name, one in zip(reversed(names), reversed(pairs), strict=True)}
    times = dict(zip(distinct, _leg_times(axes, problem, [*distinct.values()]), strict=True))
    return [times[name] for name in names]


def _name(problem: Problem, pairs: _Pairs) -> bytes:
    k = pairs.k
    ends = problem.passes(k), problem.passes(k + 1), pairs.cfx
    return b"|".join([_leg_name(problem, k), repr(ends).encode(), pairs.q_0.tobytes(), pairs.q_1.tobytes()])


def _leg_name(problem: Problem, k: int) -> bytes:
    """Of a leg; of a wait with its pose."""
    X_WF = problem.waypoints[k].X_WF if problem.legs[k].kind is LegKind.DWELL else np.zeros(0)
    return leg_name(problem.legs[k]) + X_WF.tobytes()


def _leg_times(axes: Axes, problem: Problem, pairs: Sequence[_Pairs]) -> list[Array]:
    """The same, one by one."""
    resting = [_resting(problem, one) for one in pairs]
    moved = _topp_times(axes, problem, [one.only(~rest) for one, rest in zip(pairs, resting, strict=True)])
    out = []
    for one, rest, T in zip(pairs, resting, moved, strict=True):
        leg = problem.legs[one.k]
        if axes.jerk is not None:
            T = np.maximum(T, _straight_times(axes, leg, one.q_0[~rest], one.q_1[~rest]))
        if leg.kind is LegKind.DWELL:
            times = np.full(len(rest), leg.duration or 0.0)
            fits = (leg.duration or np.inf) >= T * SLACK
            times[~rest] = np.where(fits, T if leg.duration is None else leg.duration, np.inf)
            out.append(times)
            continue
        if leg.kind is LegKind.JOINT and not (
            problem.coordinated or problem.passes(one.k) or problem.passes(one.k + 1)
        ):
            T = np.minimum(T, _own_times(axes, leg, one.q_0, one.q_1))
        if leg.duration is not None:  # what takes longer than it may is no answer, but shows the way to one
            late = np.maximum(T * SLACK - leg.duration, 0.0)
            T = np.where(np.isfinite(T), leg.duration + LATE * late, np.inf)
        out.append(T)
    return out


def _resting(problem: Problem, pairs: _Pairs) -> BoolArray:
    """In which pairs (m,) of a wait nothing moves."""
    if problem.legs[pairs.k].kind is not LegKind.DWELL:
        return np.zeros(len(pairs.q_0), dtype=bool)
    return np.asarray(np.abs(pairs.q_1 - pairs.q_0).max(axis=1) < _SAME)


def _straight_times(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> Array:
    """What straight ways (m,) between axes take under jerk limits; of other ways about what they take at least."""
    assert axes.jerk is not None
    way = np.maximum(np.abs(q_1 - q_0), 1e-12)
    limits = axes.velocity_on(leg), axes.acceleration_on(leg), axes.jerk
    T = rest_time(np.ones(len(way)), *(np.min(limit / way, axis=1) for limit in limits))
    return np.asarray(T * (JERK_ROOM if leg.duration is not None else 1.0))


def least_time(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> float:
    """What a joint move between axes q_0 and q_1 (n,) takes at least from rest to rest, however its axes move."""
    return max(float(_own_times(axes, leg, q_0[None], q_1[None])[0]), leg.duration or 0.0)


def _own_times(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> Array:
    """Least times (m,) of joint moves in which every axis has its own profile; the tool's caps enter by the chord."""
    T = np.max(trapezoid_time(np.abs(q_1 - q_0), axes.velocity_on(leg), axes.acceleration_on(leg)), axis=-1)
    tool_0, tool_1 = ((axes.forward(q) @ leg.X_FT)[:, :3, 3] for q in (q_0, q_1))
    chord = np.linalg.norm(tool_1 - tool_0, axis=1)
    return np.asarray(np.maximum(T, trapezoid_time(chord, leg.v_tcp, leg.a_tcp)))


def _topp_times(axes: Axes, problem: Problem, pairs: Sequence[_Pairs]) -> list[Array]:
    """The same, of what moves; legs of one tool and kind at once, as many as the memory takes."""
    counts = np.array([len(one.q_0) for one in pairs], dtype=np.intp)
    out = [np.zeros(0)] * len(pairs)
    alike: dict[tuple[bytes, bool, int], list[int]] = {}
    for i in np.flatnonzero(counts).tolist():
        leg = problem.legs[pairs[i].k]
        key = leg.X_FT.tobytes(), leg.kind is LegKind.JOINT, len(_nodes(problem, pairs[i].k))
        alike.setdefault(key, []).append(i)
    for numbers in alike.values():
        behind = np.cumsum(counts[numbers])
        for _, group in groupby(range(len(numbers)), key=lambda i: int(behind[i]) // PAIRS_AT_ONCE):
            some = [numbers[i] for i in group]
            T = _timed_together(axes, problem, [pairs[i] for i in some])
            for i, times in zip(some, np.split(T, np.cumsum(counts[some])[:-1]), strict=True):
                out[i] = times
    return out


def _timed_together(axes: Axes, problem: Problem, pairs: Sequence[_Pairs]) -> Array:
    """Least times of all pairs of legs of one tool and kind, one leg after the other."""
    counts = [len(one.q_0) for one in pairs]
    leg, B = problem.legs[pairs[0].k], sum(counts)
    s = _nodes(problem, pairs[0].k)
    along, ok = (_straight if leg.kind is LegKind.JOINT else _on_ways)(axes, problem, pairs, s)
    caps = axes.caps([problem.legs[one.k] for one in pairs]).at(
        np.repeat(np.arange(len(pairs)), np.array(counts) * len(s))
    )
    joints, tool = top_rate(caps, along)
    slopes, bends = columns(caps, along)
    top = np.minimum(joints, tool).reshape(B, -1)
    slopes, bends = (x.reshape(B, len(s), -1) for x in (slopes, bends))
    ok = np.asarray(ok & np.isfinite(slopes).all(axis=(1, 2)) & np.isfinite(bends).all(axis=(1, 2)))
    T = np.full(B, np.inf)
    if ok.any():
        rates = [
            np.repeat([np.inf if problem.passes(one.k + end) else 0.0 for one in pairs], counts)[ok] for end in (0, 1)
        ]
        slopes, bends = slopes[ok], bends[ok]
        begins, ends = (slopes[:, :-1], bends[:, :-1]), (slopes[:, 1:], bends[:, 1:])
        T[ok] = fastest_laws(s, top[ok], begins, ends, *rates).durations
    return T


def _straight(axes: Axes, problem: Problem, pairs: Sequence[_Pairs], s: Array) -> tuple[Along, BoolArray]:
    """Along joint moves, by their share; all places of the first, then of the next. And which are in range: all."""
    q_0, q_1 = (np.concatenate(x) for x in ([one.q_0 for one in pairs], [one.q_1 for one in pairs]))
    B, m = len(q_0), len(s)
    way = q_1 - q_0
    q = (q_0[:, None] + s[:, None] * way[:, None]).reshape(B * m, -1)
    dq = np.repeat(way, m, axis=0)
    X_FT = problem.legs[pairs[0].k].X_FT
    twist = (axes.jacobian(q, X_FT) @ dq[..., None])[..., 0]
    bend = (axes.jacobian_rate(q, dq, X_FT) @ dq[..., None])[..., 0]
    return Along(q, dq, np.zeros_like(q), twist[:, :3], twist[:, 3:], bend[:, :3]), np.ones(B, dtype=bool)


def _on_ways(axes: Axes, problem: Problem, pairs: Sequence[_Pairs], s: Array) -> tuple[Along, BoolArray]:
    """The same along legs of the tool, the rail in proportion; and which stay in range and end where they should."""
    q_0, q_1 = (np.concatenate(x) for x in ([one.q_0 for one in pairs], [one.q_1 for one in pairs]))
    B, m, layout, X_FT = len(q_0), len(s), axes.layout, problem.legs[pairs[0].k].X_FT
    counts = [len(one.q_0) for one in pairs]
    rail_way = q_1[:, layout.rail] - q_0[:, layout.rail]
    d = (q_0[:, None, layout.rail] + s[:, None] * rail_way[:, None]).reshape(B * m, -1)
    kept = np.clip(s, 1e-9, 1 - 1e-9)
    X, twist, bend = along_all([_segment(problem, one.k) for one in pairs], [kept] * len(pairs))
    of = (np.repeat(np.arange(len(pairs)), counts)[:, None] * m + np.arange(m)).ravel()  # place on the leg's way
    cfx = np.repeat([one.cfx for one in pairs], np.array(counts) * m)
    arm = axes.inverse((X @ inverse_pose(X_FT))[of], layout.value(d))[np.arange(B * m), cfx].reshape(B, m, -1)
    steps = np.diff(np.concatenate([q_0[:, None, layout.arm], arm], axis=1), axis=1)
    arm = arm - 2 * np.pi * np.cumsum(np.round(np.nan_to_num(steps) / (2 * np.pi)), axis=1)
    q = layout.merge(d, arm.reshape(B * m, -1))
    dd = np.repeat(rail_way, m, axis=0)
    dq, ddq = rates(axes, q, X_FT, twist[of], bend[of], dd, np.zeros_like(dd))
    every = q.reshape(B, m, -1)
    with np.errstate(invalid="ignore"):
        ends = np.maximum(np.abs(every[:, 0] - q_0), np.abs(every[:, -1] - q_1)).max(axis=1)
        inside = np.all((every >= axes.lower - 1e-9) & (every <= axes.upper + 1e-9), axis=(1, 2))
        ok = np.asarray(inside & (ends < _JUMP))
    return Along(q, dq, ddq, twist[of, :3], twist[of, 3:], bend[of, :3]), ok


def _segment(problem: Problem, k: int) -> Segment:
    """The tool's way on leg k; of a wait the line of no length."""
    leg = problem.legs[k]
    X_WT = problem.waypoints[k].X_WF @ leg.X_FT
    return leg.segment or Line(X_WT, X_WT)
