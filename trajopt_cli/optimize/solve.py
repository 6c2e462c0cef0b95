"""The optimiser's door: a program, a plant and a target in; a plan with its bound, or the reason why there is none."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from time import perf_counter

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.motion import Hold, Program
from trajopt_cli.optimize.assemble import rows_of
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.binding import binding_limit
from trajopt_cli.optimize.bound import lower_bound
from trajopt_cli.optimize.draft import Draft
from trajopt_cli.optimize.driver import NotConverged, Refiner, first_draft
from trajopt_cli.optimize.formulation import Formulation
from trajopt_cli.optimize.legs import JointProfiles, LegMotion, PathLeg
from trajopt_cli.optimize.pieces import Memory, alone, cut, solve_pieces, with_leg
from trajopt_cli.optimize.reach import check_reach
from trajopt_cli.optimize.search import Chain, search
from trajopt_cli.optimize.tuning import (
    DENSER,
    DISAPPOINTING,
    LAST_ALONE,
    RESIDUAL,
    RETIMED,
    ROW_APART,
    SLOWER,
)
from trajopt_cli.problem.changes import Changes, everything
from trajopt_cli.problem.freedom import EVERYTHING, Freedom, RailFreedom
from trajopt_cli.problem.plan import Infeasible, Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Coupling, LegKind, Problem, build_problem
from trajopt_cli.problem.progress import Progress
from trajopt_cli.trajectory import Trajectory, hermite

_HELD = "the rail is held still there (hold_rail): begin the hold behind the approach, or let the rail move"
Report = Callable[[Progress], None]


class NoCleanPlan(Exception):
    """Every start ended with a limit passed or without convergence. A failure of the optimiser, not of the program."""


def check_feasible(
    program: Program,
    plant: Plant,
    target: Target = Target.STREAM,
    freedom: Freedom = EVERYTHING,
    changes: Changes | None = None,
) -> Infeasible | None:
    """The first motion that cannot be done, by name, or None. Takes seconds at most; optimises nothing.

    changes: as in optimize. Motions that the user lets go are left out where that helps.
    """
    problems = _problems(program, plant, freedom, target, changes)
    first = problems[0]
    if not isinstance(first, Infeasible) or any(isinstance(one, Problem) for one in problems):
        return None
    held = getattr(program.motions[first.index], "hold", None)
    asked = held in (Hold.CELL, Hold.PROGRAM) and plant.robot.has_rail
    return replace(first, message=f"{first.message}; {_HELD}") if asked else first


def optimize(
    program: Program,
    plant: Plant,
    target: Target,
    freedom: Freedom = EVERYTHING,
    progress: Report | None = None,
    bounded: bool = True,
    changes: Changes | None = None,
    memory: Memory | None = None,
) -> Plan | Infeasible:
    """The fastest motion found for a program on one target, with a lower bound of the same model if bounded.

    freedom: what may change at all. changes: which motions may have it, None for all of them (a plan that nobody
    writes back into the program's text). The bound leaves ties of passes out, so it holds with them, too. memory: what
    was solved for other plans on this plant; pieces that are the same are taken from it, new ones added.
    Raises NoCleanPlan when the solver fails from every start.
    """
    tell: Report = progress or (lambda _: None)
    seconds: dict[str, float] = {}
    start = perf_counter()
    axes = Axes.of(plant)
    tell(Progress("reach"))
    problems = _problems(program, plant, freedom, target, changes)
    open_ = [c for c in problems if isinstance(c, Problem)]
    if not open_:
        assert isinstance(problems[0], Infeasible)
        return problems[0]
    seconds["reach"] = perf_counter() - start
    tell(Progress("search"))
    start = perf_counter()
    found = [(chain, problem) for problem in open_ if (chain := search(axes, problem)) is not None]
    seconds["search"] = perf_counter() - start
    if not found:
        return _disconnected(program, any(problem.ties for problem in open_))
    chain, problem = min(found, key=lambda pair: pair[0].cost)
    draft, legs, trajectory, bounds = _clean_plan(axes, problem, chain, {} if memory is None else memory, tell, seconds)
    bound = None
    if bounded:
        start = perf_counter()
        tell(Progress("bound", incumbent=trajectory.duration))
        bound = _checked_bound(axes, problem, trajectory.duration)
        seconds["bound"] = perf_counter() - start
    tell(Progress("done", incumbent=trajectory.duration, bound=bound))
    grid = _grid(legs, problem)
    motions = _planned(axes, program, problem, draft, legs, bounds)
    return Plan(target, trajectory, motions, bound, grid, seconds)


def _checked_bound(axes: Axes, problem: Problem, duration: float) -> float:
    """The lower bound; it aims a hair above the plan, so that a bound the plan itself refutes shows."""
    bound = lower_bound(axes, problem, duration * 1.001)
    if bound > duration * (1 + 1e-6):
        raise NoCleanPlan(f"an error in trajopt: the lower bound {bound:.6f} s lies above the plan, {duration:.6f} s")
    return min(bound, duration)  # equal up to rounding where the bound is exact


def search_estimate(program: Program, plant: Plant, target: Target, changes: Changes) -> float | None:
    """The cycle time [s] of the best chain that the search finds: what optimize starts from, a few percent from its
    answer. None where there is no chain."""
    axes = Axes.of(plant)
    open_ = [c for c in _problems(program, plant, EVERYTHING, target, changes) if isinstance(c, Problem)]
    found = [chain.cost for problem in open_ if (chain := search(axes, problem)) is not None]
    return min(found, default=None)


Clean = tuple[Draft, list[LegMotion], Trajectory, Array]


def _clean_plan(
    axes: Axes, problem: Problem, chain: Chain, memory: Memory, tell: Report, seconds: dict[str, float]
) -> Clean:
    """The draft, its legs, rows and leg boundaries. A stream may also be coordinated, as a rapid plan is: that is tried
    where the freer problem finds nothing, or nothing near what the search promised."""
    failure = None
    best: Clean | None = None
    for tried in dict.fromkeys((problem.coupling, Coupling.COORDINATED)):
        if tried is not problem.coupling:
            good = best is not None and best[2].duration <= DISAPPOINTING * chain.cost
            if good and problem.freedom.rail is not RailFreedom.STATION:  # few stations: two basins are worth a look
                break
            problem = replace(problem, coupling=tried)
            other = search(axes, problem)
            if other is None:
                break
            chain = other
        try:
            draft = _refine(axes, problem, chain, memory, tell, seconds)
        except NoCleanPlan as said:
            failure = said
            continue
        legs = _final_legs(problem, draft)
        rows = _rows(axes, legs, _end(problem, draft))
        if rows is None:
            failure = NoCleanPlan("the written rows would pass a limit between each other")
            continue
        trajectory, bounds = rows
        if best is None or trajectory.duration < best[2].duration:
            best = draft, legs, trajectory, bounds
    if best is None:
        assert failure is not None
        raise failure
    return best


def _rows(axes: Axes, legs: list[LegMotion], end: Array) -> tuple[Trajectory, Array] | None:
    """The rows and leg boundaries of a clean draft, denser where the cubic between two rows would pass a limit; None
    where that does not help."""
    more: list[float] = []
    for _ in range(DENSER + 1):
        trajectory, bounds = rows_of(axes, legs, end, more)
        over = _passing(axes, trajectory)
        if not len(over):
            return trajectory, bounds
        gaps = np.diff(trajectory.t)[over]
        if gaps.min() < 2 * ROW_APART:
            return None
        more += list(trajectory.t[over] + gaps / 2)
    return None


def _passing(axes: Axes, trajectory: Trajectory) -> IndexArray:
    """The intervals between rows in which the cubic Hermite passes an axis' velocity or acceleration by more than what
    rounding does to rows that stand near each other."""
    h = np.diff(trajectory.t)
    noise = 6 * RESIDUAL / (h * h)[:, None]
    V, A = axes.velocity, axes.acceleration
    over = np.zeros(len(h), dtype=bool)
    for u in (1e-6, 1 - 1e-6):
        _, qd, qdd = hermite(trajectory, trajectory.t[:-1] + u * h)
        over |= np.any((np.abs(qd) > V * (1 + 1e-6)) | (np.abs(qdd) > A * (1 + 1e-6) + noise), axis=1)
    return np.flatnonzero(over)


def _problems(
    program: Program, plant: Plant, freedom: Freedom, target: Target, changes: Changes | None
) -> list[Problem | Infeasible]:
    """The whole program, and without the motions the user lets go if there are any; each checked for reach."""
    axes = Axes.of(plant)
    changes = changes or everything(program, plant)
    optional = changes.droppable if freedom.drop else frozenset()
    out: list[Problem | Infeasible] = []
    for dropped in [frozenset[int]()] + ([optional] if optional else []):
        problem = build_problem(program, plant, freedom, target, changes, dropped)
        if isinstance(problem, Problem):
            out.append(check_reach(axes, problem) or problem)
        else:
            out.append(problem)
    return out


def _disconnected(program: Program, tied: bool) -> Infeasible:
    index = len(program.motions) - 1
    source = program.motions[index].source
    why = "no chain of configurations connects the start with the program's end"
    if tied:
        why += ", each target of a loop or routine in one configuration for all passes; --loops unroll asks for less"
    return Infeasible(index, source, why)


def _refine(
    axes: Axes, problem: Problem, chain: Chain, memory: Memory, tell: Report, seconds: dict[str, float]
) -> Draft:
    formulation = Formulation(axes)

    def report(phase: str, legs: Sequence[LegMotion | None]) -> None:
        """The time of the legs at hand and the search's estimate for the others; a rapid dwell counts in full."""
        total = float(np.sum(chain.times))
        for leg, estimate, motion in zip(problem.legs, chain.times, legs, strict=False):
            if motion is not None and not (leg.kind is LegKind.DWELL and leg.duration is not None):
                total += motion.T - float(estimate)
        tell(Progress(phase, incumbent=total))

    whole = sum(1 for _ in cut(problem, chain)) == 1

    def solve(piece: Problem, part: Chain) -> Draft:
        said = []
        for start in _starts(part):
            refiner = Refiner(axes, formulation, piece)
            try:
                first = first_draft(axes, piece, start)
                return refiner.run(first, lambda phase, draft: report(phase, draft.legs) if whole else None)
            except NotConverged as failure:
                said.append(str(failure))
            finally:
                _add(seconds, refiner.seconds)
        raise NoCleanPlan(f"{problem.motion(piece.legs[0].motion).source}: {'; '.join(said)}")

    draft = solve_pieces(problem, chain, memory, solve, lambda legs: report("solve", legs))
    if problem.coordinated:  # at rest in every waypoint, the rail's positions chosen: each line can be timed by itself
        for k, leg in enumerate(problem.legs):
            if leg.kind is LegKind.LINE and draft.legs[k].N < LAST_ALONE:  # type: ignore[union-attr]
                tell(Progress("retime", incumbent=_time(problem, draft)))
                piece, part = alone(problem, draft, k)
                refiner = Refiner(axes, formulation, piece)
                draft = with_leg(draft, k, _finer(refiner, part))
                _add(seconds, refiner.seconds)
    return draft


def _finer(refiner: Refiner, draft: Draft) -> LegMotion | None:
    """The leg of a one-leg draft on a grid of at least RETIMED intervals; as it was when nothing cleaner is found."""
    motion = draft.legs[0]
    assert isinstance(motion, PathLeg)
    start = motion
    while start.N < RETIMED:
        start = start.refined()
    try:
        finer = refiner.run(replace(draft, legs=(start,)), lambda phase, draft: None).legs[0]
    except NotConverged:
        return motion
    return finer if finer is not None and motion.T > finer.T else motion


def _add(total: dict[str, float], part: dict[str, float]) -> None:
    for name, spent in part.items():
        total[name] = total.get(name, 0.0) + spent


def _time(problem: Problem, draft: Draft) -> float:
    """Cycle time of a draft: a rapid dwell counts in full, whatever its own profile needs."""
    total = 0.0
    for leg, motion in zip(problem.legs, draft.legs, strict=True):
        if leg.kind is LegKind.DWELL and leg.duration is not None:
            total += leg.duration
        elif motion is not None:
            total += motion.T
    return total


def _starts(chain: Chain) -> list[Chain]:
    """The chain itself, the same at rest in every waypoint, and slower."""
    still = replace(chain, w=np.zeros_like(chain.w))
    return [chain, still, replace(still, times=chain.times * SLOWER)]


def _end(problem: Problem, draft: Draft) -> Array:
    stop = problem.waypoints[-1]
    return stop.q if stop.q is not None else draft.q[-1]


def _final_legs(problem: Problem, draft: Draft) -> list[LegMotion]:
    """A rapid dwell's profile is played as slowly as the dwell is long."""
    legs = []
    for leg, motion in zip(problem.legs, draft.legs, strict=True):
        assert motion is not None
        if (
            problem.coordinated
            and isinstance(motion, PathLeg)
            and leg.kind is LegKind.DWELL
            and leg.duration is not None
        ):
            motion = replace(motion, T=leg.duration)
        legs.append(motion)
    return legs


def _grid(legs: list[LegMotion], problem: Problem) -> str:
    sizes = {
        name: sorted({m.N for leg, m in zip(problem.legs, legs, strict=True) if pick(leg.kind, m)})
        for name, pick in {
            "lines": lambda kind, m: kind is LegKind.LINE,
            "dwells": lambda kind, m: kind is LegKind.DWELL and isinstance(m, PathLeg),
            "joint moves": lambda kind, m: kind is LegKind.JOINT and not isinstance(m, JointProfiles),
        }.items()
    }
    parts = [f"{'/'.join(map(str, n))} intervals per {name[:-1]}" for name, n in sizes.items() if n]
    closed = sum(
        isinstance(m, JointProfiles) and leg.kind is LegKind.JOINT for leg, m in zip(problem.legs, legs, strict=True)
    )
    if closed:
        parts.append(f"{closed} joint move{'s' if closed > 1 else ''} in closed form")
    return ", ".join(parts)


def _planned(
    axes: Axes, program: Program, problem: Problem, draft: Draft, legs: list[LegMotion], bounds: Array
) -> tuple[PlannedMotion, ...]:
    by_motion = {leg.motion: k for k, leg in enumerate(problem.legs)}
    out = []
    now, q_now = 0.0, draft.q[0]
    for i, motion in enumerate(program.motions):
        k = by_motion.get(i)
        if k is None:
            out.append(PlannedMotion(i, motion.source, now, now, q_now, q_now, "", i in problem.dropped))
            continue
        q_1 = draft.q[k + 1]
        binding = binding_limit(axes, problem.legs[k], legs[k])
        out.append(PlannedMotion(i, motion.source, float(bounds[k]), float(bounds[k + 1]), q_now, q_1, binding))
        now, q_now = float(bounds[k + 1]), q_1
    return tuple(out)
