"""A legal motion made gentler within a given time: more time where it spares most, and laws of least effort.

Between two rests a motion may be driven k times as long: its effort falls with k^-3, so what time there is goes where
the fourth powers meet. On a path with one progress the law of least effort in a given time is a convex program in
x = (rate)^2, for the effort is a square over a root and every limit is linear; it is solved in the rates themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from time import perf_counter

import numpy as np

from trajopt_cli.collision.merge_via_points import merge_via_points
from trajopt_cli.geometry import Array
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import Grids
from trajopt_cli.path_timing.path_parameterized_plan import duration, run_name
from trajopt_cli.path_timing.path_timing import PathMargins, Unresolved, time_path
from trajopt_cli.path_timing.sampled_path import SampledPath, sample_path
from trajopt_cli.plan.initial_plan import InitialPlan, add
from trajopt_cli.plan.local_refinement import SweepReport, WindowSweeps, with_fixed_runs
from trajopt_cli.plan.min_effort_law import min_effort_law
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.timing.topp import TimeLaw
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_legs
from trajopt_cli.trajectories.effort import efforts
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, LegMotion, Pieces

_SAME = 1e-9  # share of a time that is rounding


@dataclass(frozen=True, eq=False)
class _Span:
    """The legs between two rests of all axes, from waypoint first to last: time and effort [s], the least times it may
    be driven as long, and the most."""

    first: int
    last: int
    time: float
    effort: float
    least: float
    most: float


def spread(times: Array, efforts: Array, least: Array, total: float) -> Array:
    """How many times as long (m,) motions are to be driven, each at least `least` times, so that they take `total` [s]
    in all with the least effort: where it is more than the least, effort / time / k^4 is one for all. More than the
    total only where the least are."""
    wish = (np.maximum(efforts, 1e-12 * efforts.max()) / times) ** 0.25
    order = np.argsort(least / wish, kind="stable")
    spent, wanted = (times * least)[order], (times * wish)[order]
    for free in range(1, len(order) + 1):
        k = (total - spent[free:].sum()) / wanted[:free].sum()
        if free == len(order) or k <= (least / wish)[order[free]]:
            break
    return np.maximum(least, k * wish)


def slowed_to(axes: Axes, problem: Problem, iterate: Iterate, seconds: float) -> Iterate:
    """The motion with what time is left given to the spans between rests that can be driven slower; it takes less than
    so many seconds where there is no such span. Waits keep their time."""
    spans = _spans(axes, problem, iterate)
    free = [span for span in spans if span.most > 1.0]
    fixed = sum(span.time for span in spans if span.most == 1.0)
    if not free:
        return iterate
    time, effort, least = (np.array([getattr(span, name) for span in free]) for name in ("time", "effort", "least"))
    times = spread(time, effort, least, seconds - fixed)
    legs, qd = list(iterate.legs), iterate.qd.copy()
    qdd = None if iterate.qdd is None else iterate.qdd.copy()
    for span, k in zip(free, times.tolist(), strict=True):
        legs[span.first : span.last] = [m and m.slowed(k) for m in iterate.legs[span.first : span.last]]
        qd[span.first + 1 : span.last] /= k
        if qdd is not None:
            qdd[span.first + 1 : span.last] /= k**2
    return replace(iterate, qd=qd, qdd=qdd, legs=tuple(legs))


def _spans(axes: Axes, problem: Problem, iterate: Iterate) -> list[_Span]:
    moves = np.abs(iterate.qd if iterate.qdd is None else np.hstack([iterate.qd, iterate.qdd])).max(axis=1) > 0
    marks = [k for k in range(len(iterate.q)) if not problem.passes(k) and not moves[k]]
    each = efforts(axes, iterate.legs)
    out = []
    for first, last in pairwise(marks):
        legs, motions = problem.legs[first:last], iterate.legs[first:last]
        there = [(leg, motion) for leg, motion in zip(legs, motions, strict=True) if motion is not None]
        time, stiff = sum(motion.T for _, motion in there), any(leg.duration is not None for leg in legs)
        least = 1.0
        if there and not stiff:
            ratios = check_legs(axes, [leg for leg, _ in there], [motion for _, motion in there])
            waits = max(leg.least / motion.T if leg.least else 0.0 for leg, motion in there)
            least = min(max(*(r.times_slower() for r in ratios), waits), 1.0)
        rests = stiff or not time or least <= 0
        out.append(
            _Span(first, last, time, float(each[first:last].sum()), 1.0 if rests else least, 1.0 if rests else np.inf)
        )
    return out


def with_min_effort_laws(
    axes: Axes, formulation: Formulation, problem: Problem, iterate: Iterate, seconds: float
) -> Iterate:
    """The motion of runs that share one progress, in so many seconds, with laws of least effort where they were found.
    Never more effort than time alone gives it."""
    best = slowed_to(axes, problem, iterate, seconds)
    for _ in range(axes.settings.effort_rounds):
        legs, known = list(best.legs), dict[bytes, dict[int, LegMotion]]()
        for span in _spans(axes, problem, best):
            if not span.effort:
                continue
            key = run_name(problem, (span.first, span.last), best.q, best.cfx) + repr(span.time).encode()
            if key not in known:  # equal runs are driven alike
                found = _min_effort_motions(axes, formulation, problem, best, span)
                known[key] = {k - span.first: motion for k, motion in found.items()}
            for k, motion in known[key].items():
                legs[span.first + k] = motion
        now = slowed_to(axes, problem, replace(best, legs=tuple(legs)), seconds)
        gained = float(efforts(axes, best.legs).sum() - efforts(axes, now.legs).sum())
        if gained <= 0:
            break
        best = now
    return best


def _min_effort_motions(
    axes: Axes, formulation: Formulation, problem: Problem, iterate: Iterate, span: _Span
) -> dict[int, LegMotion]:
    """A span's motions by the law of least effort; none where no gentler one is found."""
    settings = axes.settings
    path = sample_path(axes, problem, (span.first, span.last), iterate.q, iterate.cfx, settings.run_nodes)
    if path is None:
        return {}

    def make_law(axes: Axes, problem: Problem, path: SampledPath, margins: PathMargins) -> TimeLaw | None:
        return min_effort_law(axes, formulation, problem, path, margins, span.time)

    try:
        found = time_path(axes, problem, path, make_law)
    except Unresolved:
        return {}
    if found is None:
        return {}
    motions: dict[int, LegMotion] = dict(found)
    if span.last == span.first + 1:  # one leg between stops is one piece
        motions = {k: motion.pieces[0] for k, motion in found.items()}
    if float(efforts(axes, [*motions.values()]).sum()) >= span.effort:
        return {}
    return motions


def least_effort_plan(
    axes: Axes,
    legal: Sequence[InitialPlan],
    solved: Problem,
    fast: Iterate,
    asked: LeastEffort,
    patience: Patience,
    spent: dict[str, float],
    max_workers: Callable[[], int],
) -> tuple[Problem, Iterate, tuple[str, ...]] | None:
    """The problem and the gentlest motion of it found in the time that is asked for, and what a reader should know of
    it; None where that is too short. legal: motions before any nonlinear program; fast: the fastest one and the problem
    it solves."""
    start, seconds = perf_counter(), asked.time(duration(fast))
    if seconds is None:
        return None
    formulation, bases = Formulation(axes), list[tuple[Problem, Iterate]]()
    for one in legal:
        if one.duration <= seconds:
            base = slowed_to(axes, one.problem, one.iterate, seconds)
            if axes.jerk is None:  # laws of least effort are of constant accelerations between their nodes
                base = with_min_effort_laws(axes, formulation, one.problem, one.iterate, seconds)
            own = with_fixed_runs(one.problem, one.route)
            bases.append((own, base) if solved.coordinated else merge_via_points(axes, own, base, one.detours))
    bases = sorted(bases, key=lambda base: efforts(axes, base[1].legs).sum())[:1]
    add(spent, "ease", perf_counter() - start)
    sweeps, tally = WindowSweeps(axes, Grids.of(solved), patience, spent, max_workers), SweepReport()
    if not solved.coordinated:
        bases.append((solved, slowed_to(axes, solved, fast, seconds)))
        bases = [(one, _swept(axes, sweeps, one, base, seconds, tally)) for one, base in bases]

    def strain(base: tuple[Problem, Iterate]) -> tuple[bool, float]:
        return duration(base[1]) < seconds * (1 - _SAME), float(efforts(axes, base[1].legs).sum())

    problem, best = min(bases, key=strain)
    return problem, *_with_rest_at_end(problem, best, asked.seconds)


def _swept(
    axes: Axes, sweeps: WindowSweeps, problem: Problem, iterate: Iterate, seconds: float, tally: SweepReport
) -> Iterate:
    """The motion with free axes made gentler window by window, and its time given anew to what it became."""
    asked = replace(problem, objective=LeastEffort(seconds))
    for _ in range(axes.settings.effort_rounds):
        iterate = sweeps.run(asked, iterate, tally, lambda _: None)
        again = slowed_to(axes, problem, iterate, seconds)
        before, after = (float(efforts(axes, one.legs).sum()) for one in (iterate, again))
        if duration(iterate) >= seconds * (1 - _SAME) and after >= before:
            return iterate
        iterate = again
        if before - after < axes.settings.sweep_gain * before:
            return iterate
    return iterate


def _with_rest_at_end(problem: Problem, iterate: Iterate, seconds: float) -> tuple[Iterate, tuple[str, ...]]:
    """The motion with a rest where no leg of it could be given what time is left, and a word on it."""
    left = seconds - duration(iterate)
    if left <= seconds * _SAME:
        return iterate, ()
    rests = [
        k
        for k, (leg, motion) in enumerate(zip(problem.legs, iterate.legs, strict=True))
        if motion is not None and leg.duration is None and not problem.passes(k + 1) and not iterate.qd[k + 1].any()
    ]
    if not rests:
        return iterate, (f"{left:.6f} s of the given time are left: every leg has a time that the program gives",)
    motion, still = iterate.legs[rests[-1]], np.array([iterate.q[rests[-1] + 1]] * 2)
    assert motion is not None
    rest = JointNodes(left, np.array([0.0, 1.0]), still, np.zeros_like(still), np.zeros_like(still[:1]))
    legs = list(iterate.legs)
    legs[rests[-1]] = Pieces((*(motion.pieces if isinstance(motion, Pieces) else (motion,)), rest))
    note = f"the last {left:.6f} s before a stop are a rest: no leg could be given more time"
    return replace(iterate, legs=tuple(legs)), (note,)
