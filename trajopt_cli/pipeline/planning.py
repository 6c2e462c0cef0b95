"""What plans of a job may change, the plans of both targets, and the judge on the text of each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from time import perf_counter
from typing import TYPE_CHECKING, TextIO

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.job import Job
from trajopt_cli.motion import Motion, MoveJ, Program
from trajopt_cli.pipeline.lead_in import differing, kept_for, lead_in, starting, to_targets
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING
from trajopt_cli.problem.detours import held_against
from trajopt_cli.problem.editable import Changes, Loops, everything
from trajopt_cli.problem.objective import LEAST_TIME, LeastEffort, Objective
from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan, Target
from trajopt_cli.problem.progress import Progress, Report
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.runs.results import CSV
from trajopt_cli.runs.rows import RowsFile, without_rows
from trajopt_cli.runs.summary import NOT_TIMED, Judged
from trajopt_cli.workers import Worker, give_back

if TYPE_CHECKING:
    from trajopt_cli import findings
    from trajopt_cli.plan import PlanCache
    from trajopt_cli.problem.plant import Plant

_PER_MOTION = 0.06  # s of judging and writing for each motion of a program, where nothing was judged yet
_JUDGED = 3.5  # times what judging the program as written took: two plans, side by side or not, and a page
_COPIES = "routines have copies as with --loops unroll, as without them no plan could be driven"
# What is being solved ("stream", "rapid", a baseline's name) and how far it is.
Listener = Callable[[str, Progress], None]
# What the judge said of rows for the RAPID controller, by their digest (Plan.own_rows).
_Verdicts = dict[str, "findings.Report"]
# Of one target: a plan that was judged, why the program cannot be done, or why no plan was found.
Answer = Judged | Infeasible | NoPlan


@dataclass
class Clock:
    """Seconds per phase, added up by name."""

    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        """Add what happens inside to a phase."""
        start = perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + perf_counter() - start


@dataclass(frozen=True)
class MayChange:
    """What plans may change, by target, and what that makes of loops. notices: what a user should know of that.
    infeasible: what cannot be done on one of the targets whatever changes, known before either is solved."""

    changes: Mapping[Target, Changes]
    loops: Loops
    notices: tuple[str, ...] = ()
    infeasible: Infeasible | None = None


def may_change(job: Job, loops: Loops) -> MayChange:
    """What plans of this job may change: for all commands that plan, so that they answer one question alike.

    Routines that no plan could drive as they are get copies, and that is said.
    """
    from trajopt_cli.plan import check_feasible

    def held_against_reach(loops: Loops) -> MayChange:
        changes = {one: changes_of(job, one, loops) for one in Target}
        found = (check_feasible(job.program, job.plant, one, changes=changes[one]) for one in Target)
        return MayChange(changes, loops, infeasible=next((one for one in found if one is not None), None))

    asked = held_against_reach(loops)
    if asked.infeasible is None or loops is Loops.UNROLL:
        return asked
    freer = held_against_reach(Loops.UNROLL)
    if freer.infeasible is not None:
        return asked
    return replace(freer, notices=(f"{_COPIES}: {asked.infeasible}",))


def changes_of(job: Job, target: Target, loops: Loops = Loops.KEEP) -> Changes:
    """What a plan may change on one target.

    loops: what a plan for the RAPID controller makes of them; a stream has none.
    """
    from trajopt_cli.problem.editable_text import EditableText

    if target is Target.STREAM:
        return everything(job.program, job.plant)
    return EditableText(job.program, job.plant, job.scenario, loops).changes


def plan_all(
    job: Job,
    listen: Listener,
    clock: Clock,
    changes: Mapping[Target, Changes],
    patience: Patience,
    jobs: int,
    asked: Mapping[Target, Objective],
    kept: Mapping[Target, RowsFile],
    kept_written: RowsFile | None = None,
) -> tuple[dict[Target, Answer], Plan | str, float | None]:
    """Both targets and the program as written, in up to `jobs` processes.

    A target whose plan is refused, not found or slower takes what the ladder has below it (plan.ladder).

    Args:
        changes: what plans of each target may change.
        patience: how long a faster plan is looked for. With a time limit the program as written is timed first: what
            every plan can fall back on.
        asked: the objective of each target. One that cannot be done in the time given has no slower plan.
        kept: where the rows of each target's plan go.
        kept_written: where those of the program as written go; None: only its first and last row are kept.

    Returns:
        The answers by target, a stream that cannot be done alone; the program as written, or why it cannot be driven;
        what the route takes [s] that the rapid plan began with.
    """
    from trajopt_cli.plan import PlanCache, first_legal, out_of_order

    stream, rapid = Target.STREAM, Target.RAPID

    def settled(target: Target, found: Answer, below: Plan | None, clock: Clock, tell: Report) -> Answer:
        if isinstance(found, Infeasible) and isinstance(asked[target], LeastEffort):
            return found
        rows = kept[target]
        if not isinstance(found, Judged):
            tell(Progress("judge"))
        slow = partial(_slow_plan, job, target, changes[target], clock)
        return first_legal(target, found, below, lambda plan: _judged(job, rows.keep(plan), rows, clock, said), slow)

    def plan_stream(listen: Listener, max_workers: Callable[[], int]) -> Answer:
        return solve(
            job, stream, changes[stream], listen, clock, patience, kept[stream], max_workers=max_workers,
            objective=asked[stream],
        )  # fmt: skip

    def plan_rapid(
        tell: Report,
    ) -> tuple[tuple[Plan, findings.Report] | Infeasible | NoPlan, Plan | str, float | None, dict[str, float]]:
        own = Clock()
        found = solve(
            job, rapid, changes[rapid], lambda _, progress: tell(progress), own, patience, kept[rapid], memory,
            objective=asked[rapid], said=said,
        )  # fmt: skip
        if isinstance(found, Judged) and job.program.before is not None:

            def again(less: Changes) -> Answer:
                return solve(
                    job, rapid, less, lambda _, progress: tell(progress), own, patience, kept[rapid],
                    objective=asked[rapid],
                )  # fmt: skip

            with own.phase("rapid: way into the loop"):
                found = _led_in(job, found, changes[rapid], again)
        written = first
        if written is None:
            tell(Progress("as written", *((found.plan.duration,) if isinstance(found, Judged) else ())))
            known = found if isinstance(found, Judged) else None
            written = as_written(job, changes[rapid], own, memory, kept_written, patience, known)
        answer = settled(rapid, found, written if isinstance(written, Plan) else None, own, tell)
        estimate = memory.estimates.get((rapid, EVERYTHING))
        if isinstance(written, Plan):
            written = without_rows(written)
        if not isinstance(answer, Judged):
            return answer, written, None, own.seconds
        return (without_rows(answer.plan), answer.report), written, estimate, own.seconds

    memory, first, said = PlanCache(), None, _Verdicts()
    if patience.limit is not None:
        listen(rapid.value, Progress("as written"))
        patience.reserve(_PER_MOTION * len(job.program.motions) * patience.load)
        first = as_written(job, changes[rapid], clock, memory, kept_written, patience, said=said)
        if isinstance(first, Plan):
            patience.settle()
    with ExitStack() as stack:
        hear = partial(listen, rapid.value)
        worker = stack.enter_context(Worker(plan_rapid, hear)) if jobs > 1 else None

        def listen_to_both(label: str, progress: Progress) -> None:
            listen(label, progress)
            if worker is not None:
                worker.listen()

        if worker is not None:
            patience.hear(worker.listen)
        alone = plan_rapid(hear) if worker is None and patience.limit is not None else None  # a stream falls back on it
        free = plan_stream(listen_to_both, lambda: max(1, jobs - (worker is not None and not worker.done)))
        patience.hear(None)
        if isinstance(free, Infeasible) and isinstance(asked[stream], LeastEffort):
            return {stream: free}, "", None
        found, written, estimate, seconds = alone or (plan_rapid(hear) if worker is None else worker.answer())
    clock.seconds |= seconds
    if isinstance(written, Plan) and kept_written is not None:
        written = kept_written.kept(written)
    answer = Judged(kept[rapid].kept(found[0]), kept[rapid], found[1]) if isinstance(found, tuple) else found
    legal = answer.plan if isinstance(answer, Judged) and answer.report.legal else None
    free = settled(stream, free, legal, clock, partial(listen, stream.value))
    plans = {one.value: judged.plan for one, judged in ((stream, free), (rapid, answer)) if isinstance(judged, Judged)}
    if isinstance(written, Plan) and not any(isinstance(one, LeastEffort) for one in asked.values()):
        plans["as-written"] = written
    if (wrong := out_of_order(plans)) is not None:
        return {stream: NoPlan(stream.value, wrong)}, written, estimate
    return {stream: free, rapid: answer}, written, estimate


def _led_in(job: Job, found: Judged, changes: Changes, again: Callable[[Changes], Answer]) -> Answer:
    """A plan of a loop's cycle to whose targets what runs before can be driven as well, and passes that differ: the one
    found, or one that again makes of less that may change."""
    notes: list[str] = []
    kept: tuple[Motion, ...] = ()

    for name, (motions, plant, sets) in _outside(job).items():
        while (why := _why_not(job, to_targets(job, found.plan, motions), starting(plant, found.plan))) is not None:
            if _why_not(job, motions, plant) is not None:
                notes.append(f"{name} cannot be driven, nor can it as written: {why}")
                break
            if not sets:
                return NoPlan(Target.RAPID, f"{name} cannot be driven to its targets: {why}")
            kept = (*kept, *sets.pop(0))
            less = again(kept_for(job, changes, kept))
            if not isinstance(less, Judged):
                return less
            found = less
            notes.append(f"targets stay as programmed, as {name} could not be driven to others: {why}")
    return replace(found, plan=replace(found.plan, notes=(*found.plan.notes, *dict.fromkeys(notes))))


def undriven(job: Job) -> tuple[str, ...]:
    """What a loop that never ends drives outside its cycle and cannot as written, and why, a line each."""
    whys = {name: _why_not(job, motions, plant) for name, (motions, plant, _) in _outside(job).items()}
    return tuple(f"{name} cannot be driven as written: {why}" for name, why in whys.items() if why is not None)


def _outside(job: Job) -> dict[str, tuple[tuple[Motion, ...], Plant, list[tuple[Motion, ...]]]]:
    """What runs outside the cycle, from where, and of which motions targets stay as programmed, one set after the
    other, where it cannot."""
    outside, inside = lead_in(job)
    return {
        "the way into the loop": ((*outside, *inside), job.plant.at_home, [outside, (*outside, *inside)]),
        "a pass behind the cycle": (job.program.beyond, job.plant, [differing(job), job.program.beyond]),
    }


def _why_not(job: Job, motions: tuple[Motion, ...], plant: Plant) -> str | None:
    """Why motions cannot be driven as written from where a plant starts; None where they can."""
    from trajopt_cli.plan import PlanCache

    program = replace(job.program, motions=motions, before=None, beyond=())
    alone = replace(job, program=program, plant=plant)
    answer = as_written(alone, everything(program, plant), Clock(), PlanCache()) if motions else None
    return answer if isinstance(answer, str) else None


def _slow_plan(job: Job, target: Target, changes: Changes, clock: Clock, why: str) -> Plan | None:
    from trajopt_cli.plan import slow_plan

    with clock.phase(f"{target.value}: slow plan"):
        return slow_plan(job.program, job.plant, target, changes, why)


def solve(
    job: Job, target: Target, changes: Changes, listen: Listener, clock: Clock, patience: Patience, kept: RowsFile,
    memory: PlanCache | None = None, max_workers: Callable[[], int] = lambda: 1, objective: Objective = LEAST_TIME,
    said: _Verdicts | None = None,
) -> Answer:  # fmt: skip
    """Plan one target, write its trajectory as CSV text, and let the judge read that text; where that refuses a stream,
    what it is repaired to. The bound is found meanwhile where another process may work. kept: where the rows go."""
    from trajopt_cli.plan import NoCleanPlan, PlanCache, optimize

    label, memory = target.value, memory or PlanCache()

    def tell(progress: Progress) -> None:
        listen(label, progress)

    try:
        with clock.phase(f"{label}: plan"), patience.cutting():
            plan = optimize(
                job.program, job.plant, target, progress=tell, bounded=False, changes=changes, memory=memory,
                patience=patience, max_workers=max_workers, objective=objective,
            )  # fmt: skip
            if target is Target.RAPID and isinstance(plan, Plan) and (why := _unwritable(job, plan)):
                taught = optimize(
                    job.program, job.plant, target, replace(EVERYTHING, turn=False), progress=tell, bounded=False,
                    changes=changes, memory=memory, patience=patience, max_workers=max_workers, objective=objective,
                )  # fmt: skip
                plan = taught if isinstance(taught, Infeasible) else replace(taught, notes=(why, *taught.notes))
        if isinstance(plan, Infeasible):
            return plan
        if plan.duration == 0.0:
            message = f"{job.program.entry} moves nothing: every move ends where the robot stands at the start"
            raise InputError(message, file=str(job.program_path))
        with clock.phase(f"{label}: judge"):
            plan = kept.keep(plan)
        give_back()
        repair = memory.repair.get((target, EVERYTHING))
        judged = _bounded_and_judged(job, plan, kept, changes, tell, clock, patience, max_workers, said, repair)
    except NoCleanPlan as failure:
        return NoPlan(label, str(failure))
    except Stopped:
        tell(Progress("stopped"))
        return NoPlan(label, patience.why(), stopped=True)
    for phase, spent in judged.plan.seconds.items():
        clock.seconds[f"{label}: {phase}"] = spent
    return judged


def _unwritable(job: Job, plan: Plan) -> str | None:
    """Why the program's text cannot carry turned tools; None where it can, or where none is turned."""
    from trajopt_cli.exporters.rapid import export_rapid

    loops = (Loops.KEEP, Loops.UNROLL) if plan.turns else ()
    whys = list[str]()
    for one in loops:
        try:
            export_rapid(job.program, plan, job.plant, scenario=job.scenario, loops=one)
        except InputError as error:
            whys.append(f"tools stay as taught (free): {error}")
        else:
            return None
    return next(iter(whys), None)


def _bounded_and_judged(
    job: Job, plan: Plan, kept: RowsFile, changes: Changes, tell: Report, clock: Clock, patience: Patience,
    max_workers: Callable[[], int], said: _Verdicts | None, repair: Callable[..., Judged] | None,
) -> Judged:  # fmt: skip
    """A plan with its bound, but where the user said to stop, and what the judge says of its text; where that refuses
    it, of what it is repaired to."""
    from trajopt_cli.plan import bounded, lower_bound_of

    asked_of = without_rows(plan)  # those of a repaired plan may take their place meanwhile

    def bound(_: Report) -> tuple[float, float, bool]:
        start, cut = perf_counter(), list[bool]()
        with patience.cutting():
            least = lower_bound_of(job.program, job.plant, asked_of, changes=changes, cut=lambda: cut.append(True))
        return least, perf_counter() - start, bool(cut)

    with ExitStack() as stack:
        asked = not patience.interrupted
        if asked:
            tell(Progress("bound", plan.duration))
        beside = stack.enter_context(Worker(bound, tell)) if asked and max_workers() > 1 else None
        found = bound(tell) if asked and beside is None else None
        tell(Progress("judge", plan.duration, found and min(found[0], plan.duration)))
        judged = _judged(job, plan, kept, clock, said)
        if repair is not None:
            judged = repair(judged, lambda plan: _judged(job, kept.keep(plan), kept, clock))
        found = found if beside is None else beside.answer()
        return judged if found is None else replace(judged, plan=bounded(judged.plan, *found))


def _judged(job: Job, plan: Plan, kept: RowsFile, clock: Clock, said: _Verdicts | None = None) -> Judged:
    """A plan with what the judge says of its text. Advice is for who asks `trajopt verify`: its libraries take longer
    to load than a short program to judge, and on a long one more than all that decides."""
    with clock.phase(f"{plan.target.value}: judge"):
        if plan.target is Target.RAPID and said and (known := said.get(plan.own_rows)) is not None:
            return Judged(plan, kept, known)
        left_out = [motion.index for motion in plan.motions if motion.dropped]
        program, dropped = held_against(job.program, job.plant, plan.target, plan.detours, left_out)
        report = judge(job.plant, program, kept.text, CSV[plan.target], dropped, plan.target, advice=False)
        give_back()
        return Judged(plan, kept, report)


class _Interrupted(Exception):
    """The user said to stop."""


def as_written(
    job: Job, changes: Changes, clock: Clock, memory: PlanCache, kept: RowsFile | None = None,
    patience: Patience | None = None, rapid: Judged | None = None, said: _Verdicts | None = None,
) -> Plan | str:  # fmt: skip
    """The program as it stands, driven by the RAPID controller under the same limits; or why it cannot be, one line;
    NOT_TIMED where the user says to stop before a motion is known.

    The same question as that of the first row of `compare`. memory: legal motions that the rapid plan has found. kept:
    where its rows go. patience: its end leaves out what is done only to drive the program faster. rapid: the plan for
    that controller; where it has the same rows and is legal, so is the program as written. said: hears of the verdict.
    """
    from trajopt_cli.plan import NoCleanPlan, optimize

    patience, known = patience or Patience(), (Target.RAPID, AS_WRITTEN) in memory.answers

    def going_on(_: Progress) -> None:
        if patience.interrupted and not known:
            raise _Interrupted

    with clock.phase("as written"):
        try:
            plan = optimize(
                job.program, job.plant, Target.RAPID, AS_WRITTEN, progress=going_on, bounded=False, changes=changes,
                memory=memory, patience=patience,
            )  # fmt: skip
            going_on(Progress("judge"))
        except _Interrupted:
            return NOT_TIMED
        except NoCleanPlan as failure:
            return f"no plan found: {failure}"
        if isinstance(plan, Infeasible):
            return str(plan)
        chosen = any(isinstance(one, MoveJ) and not one.settings.conf_j for one in job.program.motions)
        same = rapid is not None and rapid.report.legal and plan.own_rows == rapid.plan.own_rows
        if same and plan.own_rows and not chosen:  # of the nearest configuration the judge is asked here alone
            return plan if kept is None else kept.keep(plan)
        kept, start = kept or RowsFile(), patience.spent
        plan = kept.keep(plan)
        report = judge(job.plant, job.program, kept.text, "as written", (), Target.RAPID, False, as_written=True)
        patience.reserve(_JUDGED * (patience.spent - start))
        if said is not None and report.legal and plan.own_rows:
            said[plan.own_rows] = report
    return plan if report.legal else f"not legal: {report.worst.message}"


def judge(
    plant: Plant, program: Program, text: str | TextIO, file: str, dropped: tuple[int, ...] | None = None,
    target: Target | None = None, advice: bool = True, as_written: bool = False,
) -> findings.Report:  # fmt: skip
    """What the judge says of a CSV text or an open file. file: its name in messages; the rest as in verify."""
    from trajopt_cli.joint_csv import check_reach, read_csv_text
    from trajopt_cli.judge.verify import verify

    trajectory, resolution = read_csv_text(text, file)
    names = (*plant.limits.names, *(one.column for one in plant.followers if one.column in trajectory.names))
    if sorted(trajectory.names) == sorted(names) and trajectory.names != names:
        order = [trajectory.names.index(name) for name in names]  # columns may stand in any order
        trajectory = trajectory.of(names)
        qd_step = resolution.qd if trajectory.qd is None else resolution.qd[:, order]
        resolution = replace(resolution, q=resolution.q[:, order], qd=qd_step)
    if trajectory.names == names:
        limits = plant.limits
        check_reach(trajectory, limits.lower, limits.upper, limits.velocity, file, resolution.lines)
    try:
        return verify(program, plant, trajectory, resolution, dropped, target, advice, as_written)
    except InputError as error:
        error.file = error.file or file
        error.take(ErrorKind.RESULTS)
        raise
