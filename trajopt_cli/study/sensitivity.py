"""`sensitivity`: what each limit, speed, wait and place of a cell is worth in seconds, from plans at hand."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from trajopt_cli.errors import InputError
from trajopt_cli.job import Job
from trajopt_cli.motion import Program
from trajopt_cli.page.answer import answer_page
from trajopt_cli.pipeline.folder import plans_of_results
from trajopt_cli.pipeline.optimize import Collides, Illegal, refused
from trajopt_cli.pipeline.planning import Clock, Listener, may_change, plan_all
from trajopt_cli.plan.plan_sensitivity import Effect, NotResolvable, PlanSensitivity
from trajopt_cli.problem.detours import Detour, Numbering, unfolded, with_detours
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.objective import LEAST_TIME
from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped, checkpoint
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import SENSITIVITY
from trajopt_cli.runs.record import as_json
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.study.answers import study_record, write_answer
from trajopt_cli.study.levers import STEP, Lever, LeverKind, levers, not_asked
from trajopt_cli.table import TextTable, tabulate
from trajopt_cli.workers import cores, in_turns, shared_out

APART = 0.3
"""Share by which first order and the plan solved again may differ before that is reported."""
WORTH = 1e-3
"""s; less is reported as next to nothing."""
_WRITING = 1.0  # s of writing the answer
_TOLD = 10  # levers between two words of progress
_APART = "≠"
_OFF = 2e-3  # share by which the plan solved again may be off before that is told


@dataclass(frozen=True, eq=False)
class Row:
    """One lever on one target.

    gain: seconds saved by its step, None where why says what is in the way. first_order: what multipliers predict,
    None where they say nothing. active: whether it meets anything that binds. searched: what is saved where the program
    is planned anew with it, None where that was not asked or gave no plan.
    """

    lever: Lever
    gain: float | None
    first_order: float | None
    active: bool
    why: str = ""
    searched: float | None = None

    @property
    def best(self) -> float:
        """The most that was found [s]; what is not known counts as nothing."""
        return max((one for one in (self.gain, self.searched) if one is not None), default=0.0)

    @property
    def apart(self) -> bool:
        """Whether first order says something else than the plan solved again."""
        if self.gain is None or self.first_order is None:
            return False
        most = max(abs(self.gain), abs(self.first_order))
        return most > WORTH and abs(self.gain - self.first_order) > APART * most


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """rows: of each target, the most worth first, or why there are none. again: the plans' times solved again with
    nothing changed, which gains count from. not_asked: what is no lever and why."""

    job: Job
    plans: Mapping[Target, Plan]
    rows: Mapping[Target, tuple[Row, ...] | str]
    again: Mapping[Target, float]
    not_asked: tuple[str, ...]

    def first(self, target: Target) -> str:
        """What to change first, one sentence."""
        rows, T = self.rows[target], self.plans[target].duration
        if isinstance(rows, str):
            return f"{target.value}: {rows}"
        good = [row for row in rows if row.best > WORTH][:3]
        if not good:
            return f"{target.value}: nothing that was asked saves more than a millisecond of {T:.3f} s"
        said = [
            f"{row.lever.name}, {row.lever.step} saves {row.best:.3f} s ({100 * row.best / T:.1f} %)" for row in good
        ]
        return f"{target.value}: change first: {'; then '.join(said)}"


def sensitivity(
    job: Job,
    loops: Loops,
    results: Path | None,
    targets: tuple[Target, ...],
    listen: Listener,
    jobs: int | None = None,
    search: bool = False,
    patience: Patience | None = None,
) -> Sensitivity | Infeasible | NoPlan | Illegal | Collides:
    """Every lever on the plans of these targets.

    results: the folder that holds the plans, None to plan them now. search: the program is also planned anew with each
    lever that saves something. jobs: processes, by default one for every core; the answer is the same for any number.
    patience: half of its time is for the plans; levers that there is none left for are told as not asked.
    """
    for key, binding in (("jerk", job.plant.limits.binding_jerk), ("torque", job.plant.limits.binding_torque)):
        if binding is not None:
            text = "sensitivity does not know what they cost; leave them out to ask about the other limits"
            raise InputError(f"{key}_limits: {text}", file=job.cell.file)
    if job.scenario.free:
        text = "free: sensitivity asks about tools as taught; leave it out to ask about the limits"
        raise InputError(text, file=job.cell.file, line=job.scenario.free[0].place.line)
    workers, patience = jobs or cores(), patience or Patience()
    agreed = may_change(job, loops)
    if agreed.infeasible is not None:
        return agreed.infeasible
    changes = agreed.changes
    if results is not None:
        plans = plans_of_results(results, job)
    else:
        question, kept = dict.fromkeys(Target, LEAST_TIME), {one: RowsFile() for one in Target}
        answers, _, _ = plan_all(job, listen, Clock(), changes, patience.part(0.5), workers, question, kept)
        plans = {}
        for target, answer in answers.items():
            if isinstance(answer, Infeasible | NoPlan):
                return answer
            if not answer.report.legal:
                return refused(target, answer.report)
            plans[target] = answer.plan
    patience.settle()
    patience.reserve(_WRITING * patience.load)
    return asked(job, changes, {one: plans[one] for one in targets}, listen, workers, search, patience)


def asked(
    job: Job,
    changes: Mapping[Target, Changes],
    plans: Mapping[Target, Plan],
    listen: Listener,
    workers: int,
    search: bool,
    patience: Patience,
) -> Sensitivity:
    """Every lever on plans at hand."""
    every = levers(job.program, job.plant)
    at_hand: dict[Target, PlanSensitivity] = {}
    failed: dict[Target, str] = {}
    for target, plan in plans.items():
        listen(target.value, Progress("solve again", plan.duration))
        try:
            numbering = Numbering(len(job.program.motions), plan.detours)
            there = with_detours(job.program, job.plant, plan.detours)
            with patience.cutting():
                at_hand[target] = PlanSensitivity(there, job.plant, unfolded(plan), numbering.changes(changes[target]))
        except Stopped:
            failed[target] = f"no lever was asked: {patience.why()}"
        except NotResolvable as no:
            failed[target] = f"the plan cannot be solved again: {no}"
    tasks = {
        (one, i): partial(_row, again, lever, plans[one].detours)
        for one, again in at_hand.items()
        for i, lever in enumerate(every)
    }
    count = dict.fromkeys(plans, 0)

    def hear(told: Target) -> None:
        count[told] += 1
        if count[told] % _TOLD == 0:
            listen(told.value, Progress(f"{count[told]} of {len(every)} levers"))

    rows: dict[Target, list[Row]] = {one: [] for one in at_hand}
    for (target, i), answer in in_turns(  # on this computer, where the plan's nonlinear program is compiled
        {name: partial(_told, name[0], task, patience) for name, task in tasks.items()}, hear, workers
    ).items():
        rows[target].append(Row(every[i], answer.gain, answer.first_order, answer.active, answer.why))
    if search:
        for target, found in rows.items():
            rows[target] = _searched(changes[target], plans[target], found, listen, workers, patience)
    ordered: dict[Target, tuple[Row, ...] | str] = {}
    for target in plans:
        ordered[target] = failed.get(target) or tuple(sorted(rows[target], key=lambda row: -row.best))
    again = {one: at.duration for one, at in at_hand.items()}
    return Sensitivity(job, plans, ordered, again, not_asked(job.program, job.plant))


def _told(target: Target, task: Callable[[], Effect], patience: Patience, tell: Callable[[Target], None]) -> Effect:
    try:
        with patience.cutting():
            checkpoint()
            answer = task()
    except Stopped:
        answer = Effect(None, None, why=f"not asked: {patience.why()}")
    tell(target)
    return answer


def _row(again: PlanSensitivity, lever: Lever, detours: Sequence[Detour]) -> Effect:
    def change(share: float) -> tuple[Program, Plant]:
        program, plant = lever.change(share)
        return with_detours(program, plant, detours), plant

    return again.answer(change, lever.loosens)


def _searched(
    changes: Changes, plan: Plan, rows: list[Row], listen: Listener, workers: int, patience: Patience
) -> list[Row]:
    """The rows with what is saved where the program is planned anew."""

    def anew(lever: Lever, tell: Callable[[str], None]) -> float | None:
        from trajopt_cli.plan import NoCleanPlan, optimize

        tell(lever.name)
        program, plant = lever.change(1.0)
        try:
            with patience.cutting():
                checkpoint()
                found = optimize(program, plant, plan.target, bounded=False, changes=changes, patience=patience)
        except (NoCleanPlan, Stopped):
            return None
        return None if isinstance(found, Infeasible) else plan.duration - found.duration

    worth = {i: partial(anew, row.lever) for i, row in enumerate(rows) if row.gain is None or row.gain > WORTH}
    found = shared_out(worth, lambda name: listen(plan.target.value, Progress(f"anew with {name}")), workers)
    return [replace(row, searched=found.get(i)) for i, row in enumerate(rows)]


# ------------------------------------------------------------------------------------------------------------ records


def sensitivity_record(answer: Sensitivity) -> dict[str, Any]:
    """The whole answer as plain data, SI: per target the levers, the most worth first."""
    targets = {}
    for target, rows in answer.rows.items():
        plan = answer.plans[target]
        known: dict[str, Any] = {"cycle_time_s": plan.duration, "change_first": answer.first(target)}
        if isinstance(rows, str):
            known["why_not"] = rows
        else:
            known |= {
                "cycle_time_again_s": answer.again[target],
                "levers": [_record(row, plan.duration) for row in rows],
                "places": gradients(rows),
            }
        targets[target.value] = known
    return {"program": str(answer.job.program_path), "targets": targets, "not_asked": list(answer.not_asked)}


def _record(row: Row, T: float) -> dict[str, Any]:
    lever = row.lever
    return {
        "kind": lever.kind.value,
        "name": lever.name,
        "unit": lever.unit,
        "now": lever.now,
        "then": lever.then,
        "step": lever.step,
        "gain_s": row.gain,
        "cycle_time_s": None if row.gain is None else T - row.gain,
        "first_order_s": row.first_order,
        "first_order_differs": row.apart,
        "binds": row.active,
        "searched_s": row.searched,
        "why_not": row.why or None,
    }


def gradients(rows: tuple[Row, ...]) -> list[dict[str, Any]]:
    """Seconds saved per mm that each place is moved along each axis of the world, from its steps both ways."""
    both: dict[str, dict[str, float | None]] = {}
    for row in rows:
        if row.lever.kind is LeverKind.PLACE:
            both.setdefault(row.lever.place, {})[row.lever.name[-2]] = row.gain
    out = []
    for place, ways in sorted(both.items()):
        up, down = ways.get("+"), ways.get("−")
        slope = None if up is None or down is None else (up - down) / (2 * STEP * 1e3)
        out.append({"place": place, "saved_s_per_mm": slope})
    return out


def write_sensitivity(folder: Path, answer: Sensitivity, tables: Sequence[TextTable]) -> int:
    """Write sensitivity.json, its picture, a page with the tables and the inputs; how many files that are. Raises
    InputError where folder may not be replaced."""
    pictures, first = sensitivity_pictures(answer), "; ".join(answer.first(one) for one in answer.rows)
    lines = [f"not asked: {line}" for line in answer.not_asked]
    files = {"sensitivity.json": as_json(sensitivity_record(answer))}
    files |= {f"plots/{name}": content for name, content in pictures.items()}
    files[REPORT] = answer_page(f"{answer.job.title}: what to change first", first, tables, lines, pictures)
    options = {"targets": [one.value for one in answer.plans], "entry": answer.job.program.entry}
    return write_answer(folder, study_record(SENSITIVITY), answer.job, files, options)


def sensitivity_pictures(answer: Sensitivity) -> dict[str, bytes]:
    """Bars of what each lever saves, for each target, by file name."""
    from trajopt_cli.report.bars import lever_bars

    out: dict[str, bytes] = {}
    for target, rows in answer.rows.items():
        if isinstance(rows, str):
            continue
        shown = [row for row in rows if row.best > WORTH]
        bars = [(f"{row.lever.name}, {row.lever.step}", row.best, row.first_order) for row in shown]
        out |= lever_bars(bars, answer.plans[target].duration, f"{answer.job.title} · {target.in_words}", target.value)
    return out


def levers_table(
    program: str, target: Target, rows: Sequence[Row], cycle: float, everything: bool, search: bool
) -> TextTable:
    """The levers that save something, or all of them. cycle: of the plan [s]."""

    def lever(text: Callable[[Lever], str]) -> Callable[[Row], str]:
        return lambda row: "" if row.lever.kind is LeverKind.PLACE else text(row.lever)

    columns: dict[str, Callable[[Row], str]] = {
        "~lever": lambda row: row.lever.name,
        "step": lambda row: row.lever.step,
        ">now": lever(lambda one: f"{one.now:.4g}"),
        ">then": lever(lambda one: f"{one.then:.4g}"),
        "": lever(lambda one: one.unit),
        ">saves [s]": lambda row: "-" if row.gain is None else f"{row.gain:.4f}",
        ">of the cycle": lambda row: "" if row.gain is None else f"{100 * row.gain / cycle:.2f} %",
        ">first order [s]": lambda row: "-" if row.first_order is None else f"{row.first_order:.4f}",
    }
    if search:
        columns[">planned anew [s]"] = lambda row: "" if row.searched is None else f"{row.searched:.4f}"
    columns[" "] = lambda row: row.why or (_APART if row.apart else "" if row.active else "not limiting")
    shown = [row for row in rows if everything or row.best > WORTH or row.gain is None]
    return tabulate(f"{program}, {target.value}: what one change saves of {cycle:.3f} s", shown, columns)


def rest_lines(rows: Sequence[Row], cycle: float, again: float, everything: bool) -> Iterator[str]:
    """What the table leaves out, and what its marks mean. cycle, again: of the plan, and of it solved again [s]."""
    if abs(again - cycle) > _OFF * cycle:
        yield f"solved again with nothing changed the plan takes {again:.3f} s: savings count from there"
    if any(row.apart for row in rows if everything or row.best > WORTH):
        yield (
            f"{_APART} linear estimate off by more than {100 * APART:g} %: along the step another limit takes "
            "over, the rail moves, or a corner changes its size"
        )
    if everything:
        return
    asleep = [row.lever.name for row in rows if not row.active]
    if asleep:
        yield f"not limiting, raising these saves nothing: {', '.join(asleep)}"
    little = [row.lever.name for row in rows if row.active and row.gain is not None and 0 <= row.best <= WORTH]
    if little:
        yield f"save a millisecond at most: {', '.join(little)}"
    costs = sum(row.gain is not None and row.gain < 0 and row.best <= WORTH for row in rows)
    if costs:
        yield f"{costs} steps cost time (--all lists them)"
