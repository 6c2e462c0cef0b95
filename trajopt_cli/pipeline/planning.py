"""What plans of a job may change, the plans of both targets, and the judge on the text of each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from itertools import pairwise
from time import perf_counter
from typing import TYPE_CHECKING, TextIO

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.job import Job
from trajopt_cli.motion import Program
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING
from trajopt_cli.problem.detours import held_against
from trajopt_cli.problem.editable import Changes, Loops, everything
from trajopt_cli.problem.objective import LEAST_TIME, LeastEffort, Objective
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.progress import Progress, Report
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.results import (
    CSV,
    NOT_TIMED,
    Judged,
)
from trajopt_cli.runs.rows import RowsFile, without_rows
from trajopt_cli.workers import Worker, give_back

if TYPE_CHECKING:
    from trajopt_cli import findings
    from trajopt_cli.findings import Finding
    from trajopt_cli.plan import Memory
    from trajopt_cli.problem.plant import Plant

_ROUNDING = 1e-6  # of a cycle time: rows are a few of them longer where switches would not stand apart
_WRITTEN_OUT = "loops and routines are written out as with --loops unroll, as none of their plans could be driven"
# What is being solved ("stream", "rapid", a baseline's name) and how far it is.
Listener = Callable[[str, Progress], None]


@dataclass(frozen=True)
class NoPlan:
    """The solver failed on a program that can be done: neither an answer nor the user's mistake."""

    label: str
    message: str


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

    Loops that are to be kept, but that no plan could drive, are written out, and that is said.
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
    return replace(freer, notices=(f"{_WRITTEN_OUT}: {asked.infeasible}",))


def changes_of(job: Job, target: Target, loops: Loops = Loops.KEEP) -> Changes:
    """What a plan may change on one target.

    loops: what a plan for the RAPID controller makes of them; a stream has none.
    """
    from trajopt_cli.exporters.rapid_reading import Reading
    from trajopt_cli.exporters.rapid_writable import text_changes

    if target is Target.STREAM:
        return everything(job.program, job.plant)
    reading = Reading(job.program, job.plant, job.scenario, job.program.entry)
    return text_changes(job.program, job.plant, reading, loops)


def all_three(
    job: Job,
    listen: Listener,
    clock: Clock,
    changes: Mapping[Target, Changes],
    patience: Patience,
    jobs: int,
    asked: Mapping[Target, Objective],
    kept: Mapping[Target, RowsFile],
    kept_written: RowsFile | None = None,
) -> tuple[dict[Target, Judged | Infeasible | NoPlan], Plan | str, float | None]:
    """Both targets with what is asked of them, the program as written, and what the chain takes [s] that the rapid plan
    began with, in up to `jobs` processes. A stream that cannot be done ends the run at once. A plan that collides, or
    that the judge rejects, gives way to the next one that may change less and is legal. kept: where the rows of each
    target go; kept_written: those of the program as written, of which else the first and the last alone are known."""
    from trajopt_cli.plan import Memory

    stream, rapid = Target.STREAM, Target.RAPID

    def refused(target: Target, answer: Judged | Infeasible | NoPlan) -> bool:
        """Whether the answer is no to a time that was asked for: no slower plan will do."""
        return isinstance(answer, Infeasible) and isinstance(asked[target], LeastEffort)

    def second(
        tell: Callable[[Progress], None],
    ) -> tuple[tuple[Plan, findings.Report] | Infeasible | NoPlan, Plan | str, float | None, dict[str, float]]:
        own, memory = Clock(), Memory()
        answer = solve(
            job,
            rapid,
            changes[rapid],
            lambda _, progress: tell(progress),
            own,
            patience,
            kept[rapid],
            memory,
            objective=asked[rapid],
        )
        tell(Progress("as written", *((answer.plan.duration,) if isinstance(answer, Judged) else ())))
        known = answer if isinstance(answer, Judged) else None
        written = as_written(job, changes[rapid], own, memory, kept_written, patience, known)
        if isinstance(written, Plan):
            if not refused(rapid, answer) and (why := instead(answer, written)) is not None:
                note, found = f"the plan is the program as written: {why}", answer
                plan = replace(written, notes=(note,))
                if isinstance(found, Judged):
                    plan = replace(plan, lower_bound=found.plan.lower_bound, seconds=found.plan.seconds)
                answer = _judged(job, kept[rapid].keep(plan), kept[rapid], own)
            written = without_rows(written)
        if not isinstance(answer, Judged):
            return answer, written, None, own.seconds
        estimate = memory.estimates.get((rapid, EVERYTHING))
        return (without_rows(answer.plan), answer.report), written, estimate, own.seconds

    def hear(progress: Progress) -> None:
        listen(rapid.value, progress)

    if jobs == 1:
        first = solve(job, stream, changes[stream], listen, clock, patience, kept[stream], objective=asked[stream])
        if refused(stream, first):
            return {stream: first}, "", None
        found, written, estimate, seconds = second(hear)
    else:
        with Worker(second, hear) as beside:

            def listen_to_both(label: str, progress: Progress) -> None:
                listen(label, progress)
                beside.listen()

            first = solve(
                job,
                stream,
                changes[stream],
                listen_to_both,
                clock,
                patience,
                kept[stream],
                hands=lambda: max(1, jobs - (not beside.done)),
                objective=asked[stream],
            )
            if refused(stream, first):
                return {stream: first}, "", None
            found, written, estimate, seconds = beside.answer()
    clock.seconds |= seconds
    if isinstance(written, Plan) and kept_written is not None:
        written = kept_written.kept(written)
    answer = Judged(kept[rapid].kept(found[0]), kept[rapid], found[1]) if isinstance(found, tuple) else found
    if not refused(rapid, answer):
        answer = legal_or_slow(job, rapid, changes[rapid], answer, kept[rapid], clock)
    failure = None
    if isinstance(first, NoPlan | Infeasible):
        failure = f"no other one was found ({said(first)}): an error in trajopt; please report it"
    elif not first.report.legal:
        failure = f"a stream plan that was found {forbidden(first)}"
    if isinstance(answer, Judged) and answer.report.legal:
        plan = streamed(answer.plan, first.plan if isinstance(first, Judged) else None, failure)
        first = first if plan is None else _judged(job, plan, answer.rows, clock)
    else:
        first = legal_or_slow(job, stream, changes[stream], first, kept[stream], clock)
    plans = {one.value: judged.plan for one, judged in ((stream, first), (rapid, answer)) if isinstance(judged, Judged)}
    if isinstance(written, Plan) and not any(isinstance(one, LeastEffort) for one in asked.values()):
        plans["as-written"] = written
    if (wrong := out_of_order(plans)) is not None:
        return {stream: NoPlan(stream.value, wrong)}, written, estimate
    return {stream: first, rapid: answer}, written, estimate


def said(answer: Infeasible | NoPlan) -> str:
    """Why there is no plan, in words."""
    return answer.message if isinstance(answer, NoPlan) else str(answer)


def instead(answer: Judged | Infeasible | NoPlan, written: Plan) -> str | None:
    """Why the program as written is the better answer, in words; None where it is not."""
    if not isinstance(answer, Judged):
        return f"no other one was found ({said(answer)}): an error in trajopt; please report it"
    if not answer.report.legal:
        return f"a faster one {forbidden(answer)}"
    slower = answer.plan.eased is None and answer.plan.duration > written.duration * (1 + _ROUNDING)
    return "what was found takes longer: an error in trajopt; please report it" if slower else None


def legal_or_slow(
    job: Job, target: Target, changes: Changes, answer: Judged | Infeasible | NoPlan, kept: RowsFile, clock: Clock
) -> Judged | Infeasible | NoPlan:
    """The answer; where that is no legal plan, a slow one that stops at every point, if that is legal. kept: where its
    rows go then."""
    from trajopt_cli.plan import slow_plan

    if isinstance(answer, Judged) and answer.report.legal:
        return answer
    why = said(answer) if not isinstance(answer, Judged) else f"the one found {forbidden(answer)}"
    with clock.phase(f"{target.value}: slow plan"):
        slow = slow_plan(job.program, job.plant, target, changes, why)
        if slow is None or slow.duration == 0.0:
            return answer
        own = RowsFile()  # the rows of the other plan are in kept
        if not _judged(job, own.keep(slow), own, clock).report.legal:
            return answer
        return _judged(job, kept.keep(slow), kept, clock)


def touches(judged: Judged) -> tuple[Finding, ...]:
    """What a plan hits, in time order, where that is all that is wrong with it; else none."""
    from trajopt_cli.judge.clearance import collisions

    hits = collisions(judged.report.findings)
    return hits if len(hits) == sum(not finding.passed for finding in judged.report.findings) else ()


def forbidden(judged: Judged) -> str:
    """What the judge says against a plan that is not legal: what it hits, or an error in trajopt."""
    if hits := touches(judged):
        return f"collides: {hits[0].message}"
    return f"is not legal: {worst(judged.report).message}: an error in trajopt; please report it"


def streamed(rapid: Plan, stream: Plan | None, failure: str | None = None) -> Plan | None:
    """A legal RAPID plan as the stream plan, where that is faster or there is none to be had; else None. Any motion
    that the RAPID controller makes can be streamed. failure: why the stream plan is not to be had, if so."""
    if stream is not None and not _better(rapid, stream) and failure is None:
        return None
    better = "faster" if rapid.eased is None else "gentler"
    note = f"the plan is the rapid plan: {failure or f'nothing {better} was found'}"
    if stream is None:
        return replace(rapid, target=Target.STREAM, lower_bound=None, notes=(note,))
    bound, seconds, notes = stream.lower_bound, stream.seconds, (note, *stream.notes)
    return replace(rapid, target=Target.STREAM, lower_bound=bound, seconds=seconds, notes=notes)


def _better(one: Plan, other: Plan) -> bool:
    """Whether a plan is faster than another; of two within a given time the gentler is better."""
    if one.eased is None or other.eased is None:
        return one.duration < other.duration
    longer = one.duration > other.duration * (1 + _ROUNDING)
    return not longer and one.eased.planned.effort < other.eased.planned.effort


def out_of_order(plans: Mapping[str, Plan]) -> str | None:
    """What is wrong where a plan takes longer than one behind it, which may change less; None where nothing is."""
    for (free, plan), (bound, other) in pairwise(plans.items()):
        if plan.duration > other.duration * (1 + _ROUNDING):
            return (
                f"an error in trajopt: the {free} plan takes {plan.duration:.6f} s, the {bound} plan, which may change "
                f"less, {other.duration:.6f} s"
            )
    return None


def solve(
    job: Job,
    target: Target,
    changes: Changes,
    listen: Listener,
    clock: Clock,
    patience: Patience,
    kept: RowsFile,
    memory: Memory | None = None,
    hands: Callable[[], int] = lambda: 1,
    objective: Objective = LEAST_TIME,
) -> Judged | Infeasible | NoPlan:
    """Plan one target, write its trajectory as CSV text, and let the judge read that text. The bound is found
    meanwhile where another process may work. kept: where the rows go."""
    from trajopt_cli.plan import NoCleanPlan, optimize

    label = target.value

    def tell(progress: Progress) -> None:
        listen(label, progress)

    try:
        with clock.phase(f"{label}: plan"):
            plan = optimize(
                job.program,
                job.plant,
                target,
                progress=tell,
                bounded=False,
                changes=changes,
                memory=memory,
                patience=patience,
                hands=hands,
                objective=objective,
            )
        if isinstance(plan, Infeasible):
            return plan
        if plan.duration == 0.0:
            message = f"{job.program.entry} moves nothing: every move ends where the robot stands at the start"
            raise InputError(message, file=str(job.program_path))
        with clock.phase(f"{label}: judge"):
            plan = kept.keep(plan)
        give_back()
        judged = _bounded_and_judged(job, plan, kept, changes, tell, clock, patience, hands)
    except NoCleanPlan as failure:
        return NoPlan(label, str(failure))
    for phase, spent in judged.plan.seconds.items():
        clock.seconds[f"{label}: {phase}"] = spent
    return judged


def _bounded_and_judged(
    job: Job,
    plan: Plan,
    kept: RowsFile,
    changes: Changes,
    tell: Report,
    clock: Clock,
    patience: Patience,
    hands: Callable[[], int],
) -> Judged:
    """A plan with its bound, but where the user said to stop, and what the judge says of its text. Raises NoCleanPlan
    where the plan refutes the bound."""
    from trajopt_cli.plan import bounded, lower_bound_of

    def bound(_: Report) -> tuple[float, float]:
        start = perf_counter()
        return lower_bound_of(job.program, job.plant, plan, changes=changes), perf_counter() - start

    with ExitStack() as stack:
        asked = not patience.interrupted
        if asked:
            tell(Progress("bound", plan.duration))
        beside = stack.enter_context(Worker(bound, tell)) if asked and hands() > 1 else None
        known = bounded(plan, *bound(tell)) if asked and beside is None else plan
        tell(Progress("judge", known.duration, known.lower_bound))
        judged = _judged(job, known, kept, clock)
        return judged if beside is None else replace(judged, plan=bounded(plan, *beside.answer()))


def _judged(job: Job, plan: Plan, kept: RowsFile, clock: Clock) -> Judged:
    """A plan with what the judge says of its text. Advice is for who asks `trajopt verify`: its libraries take longer
    to load than a short program to judge, and on a long one more than all that decides."""
    with clock.phase(f"{plan.target.value}: judge"):
        left_out = [motion.index for motion in plan.motions if motion.dropped]
        program, dropped = held_against(job.program, job.plant, plan.target, plan.detours, left_out)
        report = judge(job.plant, program, kept.text, CSV[plan.target], dropped, plan.target, advice=False)
        give_back()
        return Judged(plan, kept, report)


class _Interrupted(Exception):
    """The user said to stop."""


def as_written(
    job: Job, changes: Changes, clock: Clock, memory: Memory, kept: RowsFile | None = None,
    patience: Patience | None = None, rapid: Judged | None = None,
) -> Plan | str:  # fmt: skip
    """The program as it stands, driven by the RAPID controller under the same limits; or why it cannot be, one line;
    NOT_TIMED where the user says to stop before a motion is known.

    The same question as that of the first row of `compare`. memory: legal motions that the rapid plan has found. kept:
    where its rows go. patience: its end leaves out what is done only to drive the program faster. rapid: the plan for
    that controller; where it has the same rows and is legal, so is the program as written.
    """
    from trajopt_cli.plan import NoCleanPlan, optimize

    patience, known = patience or Patience(), (Target.RAPID, AS_WRITTEN) in memory.answers

    def going_on(_: Progress) -> None:
        if patience.interrupted and not known:
            raise _Interrupted

    with clock.phase("as written"):
        try:
            plan = optimize(
                job.program,
                job.plant,
                Target.RAPID,
                AS_WRITTEN,
                progress=going_on,
                bounded=False,
                changes=changes,
                memory=memory,
                patience=patience,
            )
            going_on(Progress("judge"))
        except _Interrupted:
            return NOT_TIMED
        except NoCleanPlan as failure:
            return f"no plan found: {failure}"
        if isinstance(plan, Infeasible):
            return str(plan)
        if rapid is not None and rapid.report.legal and plan.own_rows and plan.own_rows == rapid.plan.own_rows:
            return plan if kept is None else kept.keep(plan)
        kept = kept or RowsFile()
        plan = kept.keep(plan)
        report = judge(job.plant, job.program, kept.text, "as written", (), Target.RAPID, advice=False)
    return plan if report.legal else f"not legal: {worst(report).message}"


def judge(
    plant: Plant,
    program: Program,
    text: str | TextIO,
    file: str,
    dropped: tuple[int, ...] | None = None,
    target: Target | None = None,
    advice: bool = True,
) -> findings.Report:
    """What the judge says of a CSV text or an open file. file: its name in messages; the rest as in verify."""
    from trajopt_cli.joint_csv import check_reach, read_csv_text
    from trajopt_cli.judge.verify import verify

    trajectory, resolution = read_csv_text(text, file)
    if sorted(trajectory.names) == sorted(plant.limits.names) and trajectory.names != plant.limits.names:
        order = [trajectory.names.index(name) for name in plant.limits.names]  # columns may stand in any order
        q, qd = trajectory.q[:, order], None if trajectory.qd is None else trajectory.qd[:, order]
        trajectory = replace(trajectory, names=plant.limits.names, q=q, qd=qd)
        qd_step = resolution.qd if qd is None else resolution.qd[:, order]
        resolution = replace(resolution, q=resolution.q[:, order], qd=qd_step)
    if trajectory.names == plant.limits.names:
        limits = plant.limits
        check_reach(trajectory, limits.lower, limits.upper, limits.velocity, file, resolution.lines)
    try:
        return verify(program, plant, trajectory, resolution, dropped, target, advice)
    except InputError as error:
        error.file = error.file or file
        error.take(ErrorKind.RESULTS)
        raise


def worst(report: findings.Report) -> Finding:
    """The failed finding that is farthest beyond its limit."""
    return min((finding for finding in report.findings if not finding.passed), key=lambda finding: finding.margin)
