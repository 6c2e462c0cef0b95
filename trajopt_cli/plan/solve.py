"""The optimiser's door: a program, a plant and a target in; a plan with its bound, or the reason why there is none."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from time import perf_counter

import numpy as np

from trajopt_cli.bound.lower_bound import lower_bound
from trajopt_cli.bound.tcp_time_bound import tool_time
from trajopt_cli.collision.collision_scene import collision_scene_of
from trajopt_cli.collision.merge_via_points import detours_left
from trajopt_cli.collision.motion_collision import clear
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.graph_search.by_rails import check_reach, search
from trajopt_cli.motion import Hold, PoseMove, Program, Wait, motion_name
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, duration, timed
from trajopt_cli.path_timing.positioner_timing import turning
from trajopt_cli.plan.fallback_plan import fallback_motion
from trajopt_cli.plan.initial_plan import (
    InitialPlan,
    NoCleanPlan,
    PlanCache,
    PlanRequest,
    find_initial_plan,
    plans_with_less_rail,
)
from trajopt_cli.plan.local_refinement import refine, refine_laws
from trajopt_cli.plan.min_effort import least_effort_plan
from trajopt_cli.plan.opened_corners import OpenedProblem
from trajopt_cli.plan.output_rows import motions_of, rows_of
from trajopt_cli.plan.rail_refinement import refine_corner_rail, refine_rail
from trajopt_cli.plan.repair import Repaired, repaired, with_legal_rows
from trajopt_cli.plan.tool_turns import best_sampled_turns, reachable, refined_turns, route_time, stays_at_wrist
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.corners import corners_of, with_stops
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom
from trajopt_cli.problem.detours import Detour, Numbering, folded, quoted
from trajopt_cli.problem.editable import Changes, everything
from trajopt_cli.problem.objective import LEAST_TIME, LeastEffort, Objective
from trajopt_cli.problem.plan import Eased, Infeasible, Plan, PlannedMotion, Strain, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import LegKind, Problem, TurnRoom
from trajopt_cli.problem.progress import Progress, Report, never_worse
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.problem.tool_turns import turn_groups, turned, with_room_to_turn
from trajopt_cli.trajectories.active_limits import binding_limits
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.effort import efforts, rail_way
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointProfiles, LegMotion, PathLeg
from trajopt_cli.trajectory import Trajectory, hermite

_SLOW = (
    "no fast plan was found ({why}); this one is legal but slow, and stops at every point: please report the program"
)
_REACHES = "the tool is turned about its axis (free) at {count} targets that cannot be reached as taught"
_TURNS = 1e-6  # rad: a tool that is turned by less is as it was
_NOT_EASED = "tools stay as taught (free): the gentlest motion in a given time turns none"
_SAVES = 5e-4  # of a cycle time: less is no reason to turn a tool
_CUT_BOUND = "the bound was not proved to its end for want of time: it holds, but a better one may"
_LEAST_SPARE = 4e-6  # m: files' digits and the judge's looks ask for a reserve of a micrometre or two
_FIRST = (
    "the plan is the first legal one: between rows of the file the faster one passes a limit, wherever it is mended"
)
_HOLD = "the rail is held still there (hold_rail): begin the hold behind the approach, or let the rail move"
_UNIT = "the rail's unit is not active there: ActUnit before it, or DeactUnit where the rail stands in reach"
_HELD = {Hold.CELL: _HOLD, Hold.PROGRAM: _HOLD, Hold.UNIT: _UNIT}


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
    question, axes = PlanRequest(program, plant, target, freedom, changes), Axes.of(plant)
    problems = question.problems(axes)
    first = problems[0]
    if not isinstance(first, Infeasible) or any(isinstance(one, Problem) for one in problems):
        return None
    if _turned_to_reach(question):
        return None
    held = getattr(program.motions[first.index], "hold", None)
    hint = _HELD.get(held) if held is not None and plant.robot.has_rail else None
    first = first if hint is None else replace(first, message=f"{first.message}; {hint}")
    return question.in_first_pass(axes, first)


def optimize(
    program: Program,
    plant: Plant,
    target: Target,
    freedom: Freedom = EVERYTHING,
    progress: Report | None = None,
    bounded: bool = True,
    changes: Changes | None = None,
    memory: PlanCache | None = None,
    patience: Patience | None = None,
    max_workers: Callable[[], int] = lambda: 1,
    objective: Objective = LEAST_TIME,
) -> Plan | Infeasible:
    """The fastest motion found for a program on one target, with a lower bound of the same model if bounded; or the
    gentlest within a time, where that is the objective. The bound is that of the fastest one.

    freedom: what may change at all. changes: which motions may have it, None for all of them (a plan that nobody
    writes back into the program's text). The bound leaves ties of passes out, so it holds with them, too. memory: legal
    motions of other questions about this program, plant and changes; those found here are added.
    patience: how long a faster plan is looked for once there is a legal one; notes say where that was cut short.
    max_workers: how many processes may work, asked when there is work for several; the plan is the same for
    any number.
    Where jerk is limited the program with every fly-by a stop is planned as well; where tools may be turned about their
    axis, the program with targets turned so that it is fast: the faster one of both is the plan.
    Raises NoCleanPlan when the solver fails from every start.
    """
    patience, memory = patience or Patience(), memory or PlanCache()
    tell = never_worse(progress or (lambda _: None))
    with_limits = plant, target, freedom, changes, patience, tell, max_workers, objective
    question = PlanRequest(program, plant, target, freedom, changes)
    if base := _turned_to_reach(question):
        memory = PlanCache(repair=memory.repair)  # what is known of the program says nothing of a turned one
    found = _planned_as_given(program, memory, bounded, *with_limits, base, False)
    if isinstance(found, Infeasible) and found.spare > _LEAST_SPARE:  # half of it is reserve enough
        closer = replace(plant, settings=replace(plant.settings, clearance_margin=found.spare / 2))
        own = PlanCache(repair=memory.repair)
        return optimize(program, closer, target, freedom, tell, bounded, changes, own, patience, max_workers, objective)
    if isinstance(found, Plan) and base:
        found = replace(found, notes=(_REACHES.format(count=len(base)), *found.notes))
    known = memory.answers.get((target, freedom))
    if isinstance(found, Plan) and isinstance(known, InitialPlan) and not isinstance(objective, LeastEffort):
        taught = found
        with suppress(NoCleanPlan, Stopped):
            for turns, own in _turned(question, known, base, patience, tell):
                other = _planned_as_given(program, own, False, *with_limits, turns, True)
                if isinstance(other, Plan) and other.duration < min(found.duration, taught.duration * (1 - _SAVES)):
                    memory.repair.update(own.repair)
                    found = _with_turns(program, other, taught)
    elif isinstance(found, Plan) and isinstance(objective, LeastEffort) and not base and _may_turn(question):
        found = replace(found, notes=(*found.notes, _NOT_EASED))
    jerk, fastest = plant.limits.binding_jerk is not None, not isinstance(objective, LeastEffort)
    if jerk and fastest and isinstance(found, Plan) and corners_of(program, plant).passed:
        with suppress(NoCleanPlan, Stopped):  # short ways that end in large zones may take longer than stops
            other = _planned_as_given(with_stops(program), own := PlanCache(), False, *with_limits, base, False)
            if isinstance(other, Plan) and other.duration < found.duration:
                bound = found.lower_bound
                memory.repair.update(own.repair)
                notes = (*found.notes[: bool(base)], *other.notes)
                return replace(other, lower_bound=None if bound is None else min(bound, other.duration), notes=notes)
    return found


def _may_turn(question: PlanRequest) -> bool:
    """Whether any tool may be turned about its axis."""
    return question.freedom.turn and any(getattr(one, "free", None) for one in question.program.motions)


def _turned_to_reach(question: PlanRequest) -> dict[int, float]:
    """Turns [rad] of targets, by motion, that cannot be reached as taught; none where all can, or none would help."""
    if not _may_turn(question):
        return {}
    axes = Axes.of(question.plant)
    for problem in question.unchecked():
        if isinstance(problem, Problem):
            groups = turn_groups(problem, question.changes or everything(question.program, question.plant))
            turns = reachable(groups, partial(_out_of_reach, axes, question, problem))
            if turns is not None:
                return turns
    return {}


def _out_of_reach(axes: Axes, question: PlanRequest, problem: Problem, turns: Mapping[int, float]) -> Infeasible | None:
    return check_reach(axes, _turned_problem(question, turns, problem))


def _turned(
    question: PlanRequest, known: InitialPlan, base: dict[int, float], patience: Patience, tell: Report
) -> Iterator[tuple[dict[int, float], PlanCache]]:
    """Turns [rad] of targets, by motion, with which a faster route is found than that of a plan with those of base,
    each with a legal motion through it or, where the search finds a faster one still, without. For a stream, which may
    turn the tool as it goes, those of base where there is none."""
    if not _may_turn(question):
        return
    axes, name = Axes.of(question.plant), (question.target, question.freedom)
    problem = next(one for one in question.unchecked() if isinstance(one, Problem) and one.dropped == known.dropped)
    groups = turn_groups(problem, question.changes or everything(question.program, question.plant))
    route = search(axes, _turned_problem(question, base, problem)) if known.detours else known.route
    tell(Progress("tool turns"))
    best, least = known.duration, None
    for _ in range(2 if axes.layout.has_rail else 1):  # the rail may stand elsewhere for turned tools
        if not groups.groups or route is None or patience.over:
            break
        angles, route = best_sampled_turns(axes, groups, route)
        if route is None or patience.over:
            break
        angles, route = refined_turns(axes, groups, route, angles)
        turns = groups.turns(angles)
        asked = _turned_problem(question, turns, problem)
        route = refine_corner_rail(axes, asked, refine_rail(axes, asked, route, around=collision_scene_of(asked)))
        with suppress(NotDriven):
            iterate = timed(axes, asked, route)
            if duration(iterate) < best and clear(axes, asked, iterate):
                best, least = duration(iterate), (turns, InitialPlan(asked, route, iterate))
    if least is None:
        if not known.problem.coordinated:
            yield base, PlanCache({name: known})
        return
    turns, legal = least
    yield turns, PlanCache({name: legal})
    other = search(axes, legal.problem)
    if other is not None and not patience.over:
        other = refine_corner_rail(axes, legal.problem, refine_rail(axes, legal.problem, other))
        if route_time(axes, legal.problem, other) < route_time(axes, legal.problem, legal.route) * (1 - _SAVES):
            yield turns, PlanCache()


def _turned_problem(question: PlanRequest, turns: Mapping[int, float], problem: Problem) -> Problem:
    """A problem of the question's with targets turned by angles [rad], by motion."""
    program = turned(question.program, turns)
    out = build_problem(program, question.plant, question.freedom, question.target, question.changes, problem.dropped)
    assert isinstance(out, Problem), out  # as it was one as taught
    return out


def _with_turns(program: Program, plan: Plan, taught: Plan) -> Plan:
    """A plan with a note on its turns. taught: the plan without, whose bound holds for this one, too."""
    places = {program.motions[i].source for i in plan.turns}
    if taught.turns:
        return replace(plan, lower_bound=taught.lower_bound, notes=(taught.notes[0], *plan.notes))
    where = "between its targets"
    if plan.turns:
        degrees = np.degrees([*plan.turns.values()])
        where = f"at {len(places)} target{'s' if len(places) > 1 else ''}, by "
        where += f"{degrees.min():.0f} to {degrees.max():.0f} deg"
    note = f"the tool is turned about its axis {where} from as taught (free); that saves "
    note += f"{taught.duration - plan.duration:.3f} s"
    bound = taught.lower_bound if taught.lower_bound is None else min(taught.lower_bound, plan.duration)
    return replace(plan, lower_bound=bound, bound_cut=taught.bound_cut, notes=(note, *plan.notes))


def _planned_as_given(
    program: Program, memory: PlanCache, bounded: bool, plant: Plant, target: Target, freedom: Freedom,
    changes: Changes | None, patience: Patience, tell: Report, max_workers: Callable[[], int], objective: Objective,
    turns: Mapping[int, float], room: bool,
) -> Plan | Infeasible:  # fmt: skip
    """As optimize, of one program with targets turned by angles [rad], by motion; where jerk is limited a program
    without its corners may be driven in less time. room: a stream turns free tools beyond that."""
    seconds: dict[str, float] = {}
    axes, program = Axes.of(plant), turned(program, turns)
    question = PlanRequest(program, plant, target, freedom, changes)
    legal = find_initial_plan(axes, question, memory, patience, tell, seconds)
    if isinstance(legal, Infeasible):
        return legal
    if target is Target.STREAM:
        memory.runs.clear()  # of a long program they fill the memory, and nothing asks for them again
    problem, iterate, notes = legal.problem, legal.iterate, tuple[str, ...]()
    if problem.coordinated and (target, freedom) in memory.stopped:
        notes = (f"{patience.why()}: the best plan so far; the search for a faster one was not finished",)
    tell(Progress("timing", incumbent=legal.duration))
    if room and not problem.coordinated:
        numbering, allowed = Numbering(len(program.motions), legal.detours), changes or everything(program, plant)
        legal = replace(legal, problem=with_room_to_turn(problem, numbering.changes(allowed)))
    if not problem.coordinated:
        problem, iterate, notes = refine(axes, legal, patience, tell, seconds, max_workers)
    elif axes.jerk is not None:
        iterate = refine_laws(axes, legal, patience, seconds, max_workers)
    least, eased = duration(iterate), None
    if isinstance(objective, LeastEffort):
        tell(Progress("ease", incumbent=least))
        calmer = list[InitialPlan]()
        with suppress(Stopped):
            calmer += plans_with_less_rail(axes, question, legal, memory, seconds)
        found = least_effort_plan(axes, [legal, *calmer], problem, iterate, objective, patience, seconds, max_workers)
        if found is None:
            return _too_short(program, target, objective.seconds, least)
        problem, gentle, more = found
        eased = Eased(least, _strain(axes, iterate), _strain(axes, gentle))
        iterate, notes = gentle, (*notes, *more)
    _check_lengths(program, problem, iterate)
    mended = with_legal_rows(axes, problem, iterate, patience)
    if mended is not None and isinstance(problem, OpenedProblem):
        notes, closed = (*notes, *mended.notes), problem.closed(axes, mended.iterate)
        problem = problem.whole
        mended = with_legal_rows(axes, problem, closed, patience)
    if mended is None:
        problem, eased, notes = legal.problem, None, (_FIRST,)
        mended = with_legal_rows(axes, problem, legal.iterate, patience)
    if mended is None:
        raise NoCleanPlan("between two rows of the file the motion would pass a limit")
    notes, trajectory = (*notes, *mended.notes), mended.rows[0]
    bound: float | None = None
    if bounded and not patience.interrupted:
        start, cut = perf_counter(), list[bool]()
        tell(Progress("bound", incumbent=trajectory.duration))
        known = least if eased else trajectory.duration
        asked = next(one for one in question.unchecked() if isinstance(one, Problem) and one.dropped == legal.dropped)
        least_possible = _bound(axes, asked if legal.detours else problem, known, lambda: cut.append(True))
        if _refutes(least_possible, known):
            notes = (*notes, _refuted(least_possible, known))
        else:
            bound = min(least_possible, known)  # equal up to rounding where the bound is exact
            notes = (*notes, *([_CUT_BOUND] if cut else []))
        seconds["bound"] = perf_counter() - start
    tell(Progress("done", incumbent=least if eased else trajectory.duration, bound=bound))

    def planned(problem: Problem, mended: Repaired) -> Plan:
        driven = detours_left(problem, legal.detours)
        ways = _detour_notes(program, legal.detours, driven)
        plan = _plan(axes, problem, mended.iterate, target, mended.rows, (*ways, *mended.notes))
        known, cut = memory.estimates.get((target, freedom)), (target, freedom) in memory.stopped
        plan = replace(plan, seconds=seconds, eased=eased, estimate=known, stopped=cut, turns=turns)
        plan = _with_detours(folded(plan, program, legal.detours), driven)
        beyond = room and target is Target.STREAM
        return replace(plan, turns=_turns_at_ends(plant, program, plan)) if beyond else plan

    if target is Target.STREAM:  # how fast the RAPID controller drives is not for a plan to say
        first = None if eased is not None or mended.iterate is legal.iterate else (legal.problem, legal.iterate)
        found = problem, mended.iterate, notes
        memory.repair[target, freedom] = partial(repaired, axes, *found, first, patience, planned)
    plan = planned(problem, replace(mended, notes=notes))
    return replace(plan, lower_bound=bound, bound_cut=_CUT_BOUND in notes)


def _turns_at_ends(plant: Plant, program: Program, plan: Plan) -> dict[int, float]:
    """By how much [rad] tools are turned from as taught where motions of a program end or, in corners, are nearest."""
    moves = [(one, motion) for one in plan.motions if isinstance(motion := program.motions[one.index], PoseMove)]
    q = hermite(plan.trajectory, np.array([one.t_1 for one, _ in moves]))[0]
    out = dict[int, float]()
    for (one, motion), X_WF in zip(moves, plant.robot.forward(q), strict=True):
        if motion.free is not None and not one.dropped:
            room = TurnRoom(np.array(motion.free.axis), motion.tool.X_FT, motion.free.low, motion.free.high)
            turn = motion.turn + room.angle(motion.X_WT @ inverse_pose(motion.tool.X_FT), X_WF)
            out |= {one.index: turn} if abs(turn) > _TURNS else {}
    return out


def _plan(
    axes: Axes, problem: Problem, iterate: Iterate, target: Target, rows: tuple[Trajectory, Array],
    notes: tuple[str, ...],
) -> Plan:  # fmt: skip
    legs, (trajectory, bounds) = motions_of(iterate), rows
    motions = _planned(axes, problem, iterate, legs, bounds)
    return Plan(target, trajectory, motions, None, _grid(legs, problem), notes=notes)


def slow_plan(program: Program, plant: Plant, target: Target, changes: Changes | None, why: str) -> Plan | None:
    """A slow plan that stops at every point, by none of the means of optimize: for where that has no legal one. why: in
    words, for its note. None where there is none either."""
    axes = Axes.of(plant)
    problems = PlanRequest(program, plant, target, EVERYTHING, changes).problems(axes)
    for problem in problems:
        iterate = fallback_motion(axes, problem) if isinstance(problem, Problem) else None
        if isinstance(problem, Infeasible) or iterate is None:
            continue
        _check_lengths(program, problem, iterate)
        trajectory, bounds, over = rows_of(axes, problem, iterate)
        if not len(over):
            return _plan(axes, problem, iterate, target, (trajectory, bounds), (_SLOW.format(why=why),))
    return None


def _strain(axes: Axes, iterate: Iterate) -> Strain:
    return Strain(float(efforts(axes, iterate.legs).sum()), rail_way(axes, iterate.legs))


def _too_short(program: Program, target: Target, asked: float, least: float) -> Infeasible:
    index = len(program.motions) - 1
    text = f"the {target} plan shall end here after {asked:g} s; the least time found is {least:.3f} s"
    return Infeasible(index, program.motions[index].source, text)


def lower_bound_of(
    program: Program, plant: Plant, plan: Plan, freedom: Freedom = EVERYTHING, changes: Changes | None = None,
    cut: Callable[[], None] = lambda: None,
) -> float:  # fmt: skip
    """The lower bound [s] of a plan that optimize found without one for the same question: for another process. cut: as
    in lower_bound."""
    axes = Axes.of(plant)
    dropped = frozenset(motion.index for motion in plan.motions if motion.dropped)
    problems = PlanRequest(program, plant, plan.target, freedom, changes).unchecked()
    problem = next(one for one in problems if isinstance(one, Problem) and one.dropped == dropped)
    return _bound(axes, problem, plan.duration if plan.eased is None else plan.eased.least_time, cut)


def bounded(plan: Plan, bound: float, spent: float, cut: bool = False) -> Plan:
    """The plan with its lower bound [s], and the seconds spent for that; where the plan refutes it, or the time for it
    was over, with a note."""
    seconds = {**plan.seconds, "bound": spent}
    if _refutes(bound, plan.duration):
        return replace(plan, notes=(*plan.notes, _refuted(bound, plan.duration)), seconds=seconds)
    notes = (*plan.notes, *([_CUT_BOUND] if cut else []))
    return replace(plan, lower_bound=min(bound, plan.duration), seconds=seconds, notes=notes, bound_cut=cut)


def _bound(axes: Axes, problem: Problem, duration: float, cut: Callable[[], None]) -> float:
    """The lower bound; it aims a hair above the plan, so that a bound the plan itself refutes shows."""
    apart, settling = problem.without_settling()
    if problem.freedom.turn and any(getattr(one, "free", None) for one in problem.program.motions):
        apart = replace(apart, legs=tuple(replace(leg, v_ori=np.inf) for leg in apart.legs))
        if not stays_at_wrist(axes, turn_groups(problem, everything(problem.program, problem.plant))):
            return min(sum(tool_time(apart, *run) for run in apart.runs), duration) + settling
    return lower_bound(axes, apart, duration * 1.001 - settling, cut) + settling


def _refutes(bound: float, duration: float) -> bool:
    return bound > duration * (1 + 1e-6)


def _refuted(bound: float, duration: float) -> str:
    return (
        f"no lower bound is told: the one found, {bound:.6f} s, lies above the plan, {duration:.6f} s: an error in "
        "trajopt; please report it"
    )


def search_estimate(program: Program, plant: Plant, target: Target, changes: Changes) -> float | None:
    """The cycle time [s] of the best route that the search finds: what optimize starts from, a few percent from its
    answer. None where there is no route."""
    axes = Axes.of(plant)
    open_ = [c for c in PlanRequest(program, plant, target, EVERYTHING, changes).unchecked() if isinstance(c, Problem)]
    found = [route.cost for problem in open_ if (route := search(axes, problem)) is not None]
    return min(found, default=None)


def _check_lengths(program: Program, problem: Problem, iterate: Iterate) -> None:
    """Raise InputError for a motion on which something moves for longer than longest_motion: its rows fill a disk."""
    settings = problem.plant.settings
    for leg, motion, busy in zip(problem.legs, iterate.legs, turning(problem), strict=True):
        under_way = 0.0 if motion is None else float(np.diff(motion.breaks())[~motion.resting() | busy].sum())
        if under_way > settings.longest_motion:
            one = program.motions[leg.motion]
            text = f"{motion_name(one)} takes {under_way:.6g} s; plans hold motions of up to"
            text += f" {settings.longest_motion:g} s: give it another speed or time, or a part of its way"
            raise InputError(text, file=one.source.file, line=one.source.line, column=one.source.column)


def _grid(legs: list[LegMotion], problem: Problem) -> str:
    sizes = {
        name: sorted({m.N for leg, m in zip(problem.legs, legs, strict=True) if pick(leg.kind, m)})
        for name, pick in {
            "lines": lambda kind, m: kind is LegKind.LINE,
            "dwells": lambda kind, m: kind is LegKind.DWELL and isinstance(m, PathLeg),
            "joint moves": lambda kind, m: kind is LegKind.JOINT and not isinstance(m, JointProfiles),
        }.items()
    }
    parts = [
        f"{' to '.join(map(str, sorted({n[0], n[-1]})))} intervals per {name[:-1]}" for name, n in sizes.items() if n
    ]
    closed = sum(
        isinstance(m, JointProfiles) and leg.kind is LegKind.JOINT for leg, m in zip(problem.legs, legs, strict=True)
    )
    if closed:
        parts.append(f"{closed} joint move{'s' if closed > 1 else ''} in closed form")
    return ", ".join(parts) or "none, as all is in closed form"


def _detour_notes(program: Program, detours: Sequence[Detour], driven: Sequence[Detour]) -> Iterator[str]:
    """What a reader should know of ways around, a line each: one for all passes of a text that go around the same.
    driven: those that lead by their points."""
    lines = []
    for detour in detours:
        motion, count = program.motions[detour.motion], len(detour.points)
        by = f" by {count} point{'s' if count > 1 else ''}" if detour in driven else ""
        lines.append(f"{motion.source}: {motion_name(motion)} goes around {quoted(detour.around)}{by}")
    yield from dict.fromkeys(lines)


def _with_detours(plan: Plan, driven: tuple[Detour, ...]) -> Plan:
    """The plan with the points alone that it is driven by."""
    by = {detour.motion for detour in driven}
    motions = tuple(one if one.index in by else replace(one, via=()) for one in plan.motions)
    return replace(plan, motions=motions, detours=driven)


def _planned(
    axes: Axes, problem: Problem, iterate: Iterate, legs: list[LegMotion], bounds: Array
) -> tuple[PlannedMotion, ...]:
    first = {leg.motion: k for k, leg in reversed([*enumerate(problem.legs)])}
    last = {leg.motion: k for k, leg in enumerate(problem.legs)}
    moved = sorted(last.values())
    limits = binding_limits(axes, [problem.legs[k] for k in moved], [legs[k] for k in moved])
    binding = dict(zip(moved, limits, strict=True))
    out = []
    now, q_now = 0.0, iterate.q[0]
    for i, motion in enumerate(problem.program.motions):
        k = last.get(i)
        if k is None:
            out.append(PlannedMotion(i, motion.source, now, now, q_now, q_now, "", i in problem.dropped))
            continue
        q_1 = iterate.q[k + 1]
        begin, why = float(bounds[first[i]]), "settling" if isinstance(motion, Wait) and motion.settles else binding[k]
        out.append(PlannedMotion(i, motion.source, begin, float(bounds[k + 1]), q_now, q_1, why))
        now, q_now = float(bounds[k + 1]), q_1
    return tuple(out)
