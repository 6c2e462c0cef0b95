"""A legal motion before any nonlinear program: every run of a chain timed by TOPP.

The axes of a leg share one progress, as a RAPID controller drives them; so the motion serves both targets.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.course import course_of
from trajopt_cli.optimize.draft import Draft
from trajopt_cli.optimize.exchange import check_leg
from trajopt_cli.optimize.leg_times import leg_name_at, short
from trajopt_cli.optimize.legs import JointNodes, JointProfiles, LegMotion, PathLeg
from trajopt_cli.optimize.pace import Shares, Unresolved, clean, law_of
from trajopt_cli.optimize.profiles import hold, profiles
from trajopt_cli.optimize.search import Chain
from trajopt_cli.optimize.smooth import smooth
from trajopt_cli.optimize.tuning import ALONE_NODES, MOST_MARKS, OVER, PAIR_NODES, RUN_NODES
from trajopt_cli.problem.problem import Leg, LegKind, Problem

_SAME = 1e-9  # m between rail positions that are one

Runs = dict[bytes, tuple[dict[int, LegMotion], Sequence[Leg]]]  # motions of runs, by leg in the run; its legs


class NotDriven(Exception):
    """A run of a chain that no law drives: run, its first waypoint and last. least: the time [s] that a leg would take
    which the program gives less; singular: where the run passes a singularity; None where that is not why."""

    def __init__(self, run: tuple[int, int], least: float | None = None, singular: Unresolved | None = None):
        super().__init__(run)
        self.run, self.least, self.singular = run, least, singular


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
    return b"|".join([name, *(leg_name_at(problem, k) for k in range(first, last))])


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
    passing = [short(problem, k) for k in range(len(problem.legs))]
    return _with_stops(problem, {k for k in range(1, len(passing)) if not (passing[k - 1] and passing[k])})


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
                ways.append((T + about(axes, problem, (start, end), q, cfx), [*parts, (start, end)]))
        best[end] = min(ways, default=(np.inf, []))
    T, parts = best[last]
    return parts if np.isfinite(T) else [run]


def about(axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> float:
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
