"""`compare`: every baseline on one job, judged, and the saving by cause; composes engines as the pipeline does."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from trajopt_cli.findings import Report
from trajopt_cli.job import Job
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.motion import PoseMove, Program, Wait
from trajopt_cli.pipeline.planning import Listener, judge, may_change
from trajopt_cli.problem.corners import corners_of, with_stops
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, Freedom, RailFreedom
from trajopt_cli.problem.detours import held_against
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped, checkpoint
from trajopt_cli.runs.summary import Settled, settled
from trajopt_cli.runs.uncertainty import Uncertainty
from trajopt_cli.study.case import Answer, Attempt, Case, NotApplicable, RailRule, Solve
from trajopt_cli.study.causes import asked, causes
from trajopt_cli.study.table import BASELINES, SAMPLED, Baseline, solved
from trajopt_cli.workers import shared_out

_WRITING = 2.0  # s of writing the comparison
_EQUAL = 1e-6  # s: two plans this close are equally fast


@dataclass(frozen=True, eq=False)
class Tried:
    """A baseline's motion and what the judge said of its CSV text."""

    attempt: Attempt
    report: Report


Result = Tried | Infeasible | NoPlan | str  # the text says why there is nothing to say
Tell = Callable[[tuple[str, Progress]], None]
Question = tuple[Target, Freedom, bool]  # the last: of the program with every fly-by a stop


@dataclass(frozen=True, eq=False)
class Row:
    """One line of a comparison."""

    name: str
    baseline: Baseline
    result: Result


@dataclass(frozen=True, eq=False)
class Step:
    """One cause of the saving. plan: the fastest legal one up to here. saved: seconds against the step before.

    why_not: what became of the step's own plan where the one before stands, or of the step before the first; empty
    where the plan is its own.
    """

    name: str
    plan: Plan
    saved: float
    why_not: str = ""


_JERK_FREE = "as written, jerk free"
_UNOBSTRUCTED = "without obstacles"


@dataclass(frozen=True, eq=False)
class Comparison:
    """waits: seconds of programmed waiting in every row. steps: the saving by cause, or why it cannot be told. unsure:
    between which times legal plans are, by the row's name, and what they save against the first legal row."""

    job: Job
    rows: tuple[Row, ...]
    steps: tuple[Step, ...] | str
    waits: float
    notices: tuple[str, ...] = ()
    unsure: Uncertainty = field(default_factory=Uncertainty)

    @property
    def settling(self) -> Settled | None:
        """The same in every row; None for none."""
        return settled(self.job.program, self.job.scenario.settle)

    @property
    def standing(self) -> float:
        """Waiting and settling [s]."""
        return self.waits + (0.0 if self.settling is None else self.settling.seconds)


def compare(
    job: Job,
    listen: Listener,
    rule: RailRule | None = None,
    loops: Loops = Loops.KEEP,
    patience: Patience | None = None,
) -> Comparison:
    """Every baseline on this job, judged, in the table's order, and the saving by cause.

    rule: of the row `thesis`. loops: as in optimize_job. patience: once a row is legal its end cuts the others short;
    with a time limit the program as written and the RAPID optimum come first, then those that take least.
    """
    from trajopt_cli.plan.uncertainty import uncertainty

    patience = patience or Patience()
    patience.reserve(_WRITING * patience.load)
    study = _Study(job, rule, loops, patience)
    passed = bool(corners_of(job.program, job.plant).passed)
    reasons = causes(job.plant, bool(study.changes[Target.STREAM].droppable), passed, study.free)
    names = {study.question(cause.target, cause.freedom, cause.stops): cause.name for cause in reasons}
    table = {name: one for name, one in BASELINES.items() if study.free or name != SAMPLED}
    asks = {name: study.question(one.target, one.freedom) for name, one in table.items() if one.freedom}
    names |= {question: name for name, question in asks.items()}

    tasks: dict[str, Callable[[Tell], dict[Question | str, Result]]] = {}
    order = sorted(names.items(), key=_effort)
    if patience.limit is not None:
        first = ["as-written", "optimum rapid"]
        order = sorted(reversed(order), key=lambda item: first.index(item[1]) if item[1] in first else len(first))
    for question, name in order:
        following = [later for later, one in table.items() if one.after and asks[one.after] == question]
        tasks[name] = partial(study.answer, name, question, following)
    limited = job.plant.limits.binding_jerk is not None
    if limited:
        tasks[_JERK_FREE] = study.jerk_free
    if job.plant.obstacles:
        tasks[_UNOBSTRUCTED] = study.unobstructed
    alone = [name for name, one in table.items() if not one.freedom and not one.after]
    tasks |= {name: partial(study.make, name) for name in alone}
    results: dict[Question | str, Result] = {}
    for found in shared_out(tasks, lambda told: listen(*told)).values():
        results |= found
    results |= study.ordered(results)
    rows = tuple(Row(name, one, results[asks.get(name, name)]) for name, one in table.items())
    answers = [(cause.name, results[study.question(cause.target, cause.freedom, cause.stops)]) for cause in reasons]
    if limited:
        answers = [(_JERK_FREE, results[_JERK_FREE]), ("jerk limits", answers[0][1]), *answers[1:]]
    steps = _after(answers) if passed or limited else _steps(answers)
    waits = sum(one.duration for one in job.program.motions if isinstance(one, Wait) and not one.settles)
    notices = (*study.notices, *_cost_of_avoiding(results, study)) if job.plant.obstacles else study.notices
    before = next((row.name for row in rows if isinstance(row.result, Tried) and row.result.report.legal), "")
    plans = {row.name: plan for row in rows if (plan := _legal_plan(row.result)) is not None and _own(plan, job)}
    return Comparison(
        job, rows, steps, waits, notices, uncertainty(job.program, job.plant, job.scenario.settle, plans, before)
    )


def _own(plan: Plan, job: Job) -> bool:
    """Whether a plan is of the job's program as it is."""
    return len(plan.motions) == len(job.program.motions)


def _cost_of_avoiding(results: Mapping[Question | str, Result], study: _Study) -> Iterator[str]:
    """What both optima would take if no obstacle stood in the cell."""
    said = []
    for target, name in ((Target.STREAM, "as a joint stream"), (Target.RAPID, "by the RAPID controller")):
        bare = _legal_plan(results.get(_bare(target)))
        plan = _legal_plan(results.get(study.question(target, EVERYTHING)))
        if bare is not None:
            costs = f" (avoiding them costs {plan.duration - bare.duration:.3f} s)" if plan is not None else ""
            said.append(f"{bare.duration:.3f} s {name}{costs}")
    if said:
        yield f"without the obstacles: {', '.join(said)}"


def _bare(target: Target) -> str:
    return f"{_UNOBSTRUCTED}, {target}"


def comparison_pictures(answer: Comparison, target: Target = Target.STREAM) -> dict[str, bytes]:
    """Bars of all rows, the saving by cause, and the pictures of the fastest legal plan for target, by file name."""
    from trajopt_cli.pipeline.optimize import plan_pictures
    from trajopt_cli.report.pictures import Bar, comparison, savings

    name = answer.job.title
    tried = [(row, row.result) for row in answer.rows if isinstance(row.result, Tried)]
    bars = [
        Bar(row.name, row.baseline.title, one.attempt.trajectory.duration, one.report.legal, _bound(row, one))
        for row, one in tried
    ]
    out = comparison(bars, name) if bars else {}
    if not isinstance(answer.steps, str):
        out |= savings([(step.name, step.plan.duration) for step in answer.steps], name)
    own = [
        one.attempt.plan
        for row, one in tried
        if one.attempt.plan
        and one.report.legal
        and row.baseline.target is target
        and _own(one.attempt.plan, answer.job)
    ]
    if own:
        pictures = plan_pictures(answer.job, min(own, key=lambda plan: plan.duration))
        out |= {Path(place).name: content for place, content in pictures.items()}
    return out


def _bound(row: Row, tried: Tried) -> float | None:
    """The time no legal motion on a row's target beats [s]; None where none was asked for."""
    return tried.attempt.plan.lower_bound if row.baseline.optimum and tried.attempt.plan else None


def _effort(item: tuple[Question, str]) -> int:
    """Orders the longest solves first, so that two processes end together: the more may move, the longer it takes, and
    rows wait for the rail that stands still."""
    target, free, _ = item[0]
    moves = (free.rail is not RailFreedom.PROGRAMMED) + free.lines + free.dwells + free.through_stops
    return -2 * moves - (target is Target.STREAM) - 3 * (free.rail is RailFreedom.STATION)


class _Study:
    """What is asked of the optimiser about one job, and what it answered. changes: what may change, by target."""

    def __init__(self, job: Job, rule: RailRule | None, loops: Loops, patience: Patience):
        self.job, self.rule, self.patience = job, rule or RailRule(), patience
        self.stopping = with_stops(job.program)
        self.free = any(getattr(one, "free", None) is not None for one in job.program.motions)
        agreed = may_change(job, loops)
        self.changes, self.notices = agreed.changes, agreed.notices
        self._known: dict[Question, Result] = {}

    def question(self, target: Target, freedom: Freedom, stops: bool = False) -> Question:
        """A question in the form that is equal for all that ask for the same plan."""
        return target, asked(freedom, self.job.plant, bool(self.changes[target].droppable), self.free), stops

    def answer(
        self, name: str, question: Question, following: Sequence[str], tell: Tell
    ) -> dict[Question | str, Result]:
        """The answer to a question, and the rows that start from its plan."""
        target, freedom, stops = question
        program = self.stopping if stops else self.job.program
        self._known[question] = self._tried(name, target, solved(target, freedom), tell, program)
        out: dict[Question | str, Result] = {question: self._known[question]}
        for row in following:
            out |= self.make(row, tell)
        return out

    def make(self, name: str, tell: Tell) -> dict[Question | str, Result]:
        """A row that makes a motion of its own."""
        one = BASELINES[name]
        result = self._tried(name, one.target, one.make, tell, self.job.program)
        if isinstance(result, Tried) and one.target is Target.RAPID:
            result = replace(
                result, attempt=replace(result.attempt, notes=(*result.attempt.notes, *self._beyond_the_text()))
            )
        return {name: result}

    def jerk_free(self, tell: Tell) -> dict[Question | str, Result]:
        """The program as written where jerk is not limited."""
        free, plant = copy(self), self.job.plant
        free.job = replace(self.job, plant=replace(plant, limits=replace(plant.limits, jerk_binds=False)))
        make = solved(Target.RAPID, AS_WRITTEN)
        return {_JERK_FREE: free._tried(_JERK_FREE, Target.RAPID, make, tell, self.job.program)}

    def unobstructed(self, tell: Tell) -> dict[Question | str, Result]:
        """Both optima where no obstacle stands in the cell."""
        bare = copy(self)
        bare._known = {}
        bare.job = replace(self.job, plant=replace(self.job.plant, obstacles=(), grips=()))
        found: dict[Question | str, Result] = {}
        for target in (Target.RAPID, Target.STREAM):
            make = solved(target, EVERYTHING)
            found[_bare(target)] = bare._tried(_bare(target), target, make, tell, self.job.program)
        return found

    def _beyond_the_text(self) -> Iterator[str]:
        """A word where the optimum is held to what the program's text can carry, and a motion of its own is not."""
        free = self.changes[Target.RAPID].values
        kept = sum(isinstance(motion, PoseMove) and i not in free for i, motion in enumerate(self.job.program.motions))
        if kept and self.job.plant.layout.has_rail:
            yield f"may put the rail elsewhere in {kept} moves that the program's text keeps, as no RAPID optimum does"

    def ordered(self, results: Mapping[Question | str, Result]) -> dict[Question | str, Result]:
        """The answers that another one changes: a stream optimum that the RAPID optimum beats is that, as in optimize;
        and a plan that takes longer than one that may change less is none."""
        from trajopt_cli.plan import instead_of, out_of_order

        stream, rapid = (self.question(target, EVERYTHING) for target in (Target.STREAM, Target.RAPID))
        written = self.question(Target.RAPID, AS_WRITTEN)
        names = {stream: "optimum stream", rapid: "optimum rapid", written: "as-written"}
        plans = {one: plan for one in names if (plan := _legal_plan(results.get(one))) is not None}
        out: dict[Question | str, Result] = {}
        found = results.get(stream)
        cut = found if isinstance(found, str) else None
        if (
            stream in results
            and rapid in plans
            and (plan := instead_of(plans.get(stream), plans[rapid], Target.STREAM, cut))
        ):
            out[stream] = self._judged(names[stream], Target.STREAM, Attempt(self.job.program, plan.trajectory, plan))
            plans = {stream: plan} | plans | {stream: plan}
        if wrong := out_of_order({names[one]: plan for one, plan in plans.items()}):
            out |= {one: NoPlan(names[one], wrong) for one in (stream, rapid) if one in results}
        return out

    def _tried(self, name: str, target: Target, make: Callable[[Case], Answer], tell: Tell, program: Program) -> Result:
        """What make gives, judged as the CSV text it would be written as."""
        from trajopt_cli.plan import NoCleanPlan

        try:
            with self.patience.cutting():
                checkpoint()
                answer = make(Case(program, self.job.plant, self._solver(name, tell), self.rule))
        except NoCleanPlan as failure:
            return NoPlan(name, str(failure))
        except Stopped:
            return f"not made: {self.patience.why()}"
        if isinstance(answer, NotApplicable):
            return f"n/a: {answer.why}"
        if isinstance(answer, Infeasible):
            return answer
        tell((name, Progress("judge", answer.trajectory.duration)))
        return self._judged(name, target, answer)

    def _judged(self, name: str, target: Target, answer: Attempt) -> Tried:
        text = write_csv_text(answer.trajectory)
        detours = () if answer.plan is None else answer.plan.detours
        program, dropped = held_against(answer.program, self.job.plant, target, detours, answer.dropped)
        report = judge(self.job.plant, program, text, name, dropped, target, advice=False)
        if report.legal:
            self.patience.settle()
        return Tried(answer, report)

    def _solver(self, name: str, tell: Tell) -> Solve:
        """The optimiser, that does not answer twice; a plan gets a bound where everything is free."""
        from trajopt_cli.plan import NoCleanPlan, optimize

        def solve(program: Program, target: Target, freedom: Freedom) -> Plan | Infeasible:
            question = self.question(target, freedom)
            if program is self.job.program and question in self._known:
                match self._known[question]:
                    case Tried(attempt=attempt) if attempt.plan is not None:
                        return attempt.plan
                    case Infeasible() as no:
                        return no
                    case NoPlan(message=message):
                        raise NoCleanPlan(message)
            bounded = program is self.job.program and question == self.question(target, EVERYTHING)
            listen = lambda progress: tell((name, progress))  # noqa: E731
            changes = self.changes[target] if program in (self.job.program, self.stopping) else None
            plant, patience = self.job.plant, self.patience
            return optimize(program, plant, target, freedom, listen, bounded, changes, patience=patience)

        return solve


def _legal_plan(result: Result | None) -> Plan | None:
    """The plan of a legal answer."""
    return result.attempt.plan if isinstance(result, Tried) and result.report.legal else None


def _after(answers: list[tuple[str, Result]]) -> tuple[Step, ...] | str:
    """The saving by cause from the program with stops, or with free jerk, on: its corners are driven and its jerk
    limits kept whatever they save or cost."""
    (before_all, earlier), (reason, written), *others = answers
    steps = _steps([("as written", written), *others])
    if isinstance(steps, str):
        return steps
    first, *later = steps
    if isinstance(earlier, Tried) and earlier.report.legal and earlier.attempt.plan:
        before = earlier.attempt.plan
        saved = before.duration - first.plan.duration
        return (Step(before_all, before, 0.0), replace(first, name=reason, saved=saved), *later)
    return (replace(first, why_not=f"{before_all}: {_nothing(earlier)}"), *later)


def _steps(answers: list[tuple[str, Result]]) -> tuple[Step, ...] | str:
    """The saving by cause. A legal plan stays legal when more may move: where a step's own is no faster, or there is
    none, the plan before it stands."""
    (name, start), *others = answers
    if not (isinstance(start, Tried) and start.report.legal and start.attempt.plan):
        return f"{name}: {_nothing(start)}"
    steps = [Step(name, start.attempt.plan, 0.0)]
    for name, result in others:
        best = steps[-1].plan
        if isinstance(result, Tried) and result.report.legal and result.attempt.plan:
            saved = best.duration - result.attempt.plan.duration
            if saved > _EQUAL:
                steps.append(Step(name, result.attempt.plan, saved))
            else:
                steps.append(Step(name, best, 0.0, "nothing gained"))
        else:
            steps.append(Step(name, best, 0.0, _nothing(result)))
    return tuple(steps)


def _nothing(result: Result) -> str:
    match result:
        case Tried():
            return "its plan is not legal"
        case Infeasible() as no:
            return str(no)
        case NoPlan(message=message):
            return f"no plan found: {message}"
    return result
