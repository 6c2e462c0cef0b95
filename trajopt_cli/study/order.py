"""`order`: in which order to do what the cell file lets be done in any, for the shortest cycle.

The search's own times between stations give the best order of their model, exactly up to exact_stations stations; the
most promising orders are then planned whole and judged, and the fastest plan is the answer.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from trajopt_cli.graph_search import sequence
from trajopt_cli.page.answer import answer_page
from trajopt_cli.pipeline.planning import Listener, may_change
from trajopt_cli.plan.initial_plan import PlanRequest
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import ORDER
from trajopt_cli.runs.record import as_json
from trajopt_cli.runs.transaction import replace_files
from trajopt_cli.study.answers import study_record, why_illegal, write_answer
from trajopt_cli.study.order_text import Group
from trajopt_cli.table import TextTable
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.workers import cores, shared_out

Order = tuple[int, ...]

_WRITING = 1.0  # s of writing the answer
PLANNED = 3
"""Orders that are planned besides the written one, that of the nearest neighbour and the best of the model."""
_NEAR = 8  # orders one step away from the best that are searched whole


@dataclass(frozen=True)
class Tour:
    """An order of a group's parts. model: its time by the search's times between stations [s]; estimate: of the best
    route that the search finds for the whole program [s]; planned: of the judged plan [s]; why: there is none."""

    order: Order
    model: float
    estimate: float | None = None
    planned: float | None = None
    why: str = ""


@dataclass(frozen=True, eq=False)
class Ordered:
    """The answer. found: every order that was planned or searched whole, by itself. best_of_model: the best one by the
    search's times between stations, exact or the best that was found. bound: no order takes less by these times [s].
    why_not: why the best order is not written into the program."""

    group: Group
    target: Target
    found: Mapping[Order, Tour]
    nearest: Order
    best_of_model: Order
    exact: bool
    bound: float
    stopped: str | None
    why_not: str | None

    @property
    def written(self) -> Tour:
        """The order of the program as it stands."""
        return self.found[tuple(range(len(self.group.parts)))]

    @property
    def best(self) -> Tour | None:
        """The fastest plan, the written order first among equals; None for none."""
        known = [self.written, *self.found.values()]
        return min((one for one in known if one.planned is not None), key=lambda one: one.planned or 0.0, default=None)

    @property
    def new_text(self) -> str | None:
        """The program's file in the best order, None where that is the written one or cannot be written."""
        best = self.best
        if best is None or best.order == self.written.order or self.why_not is not None:
            return None
        return self.group.text(best.order)

    def names(self, order: Order) -> str:
        """The parts in an order."""
        return ", ".join(self.group.parts[i].name for i in order)

    @property
    def in_words(self) -> str:
        """The answer in a line."""
        best, now = self.best, self.written.planned
        assert best is not None
        assert best.planned is not None
        if best.order == self.written.order:
            return f"{self.group.name}: no order that was planned is faster than the written one, {best.planned:.3f} s"
        saved = "" if now is None else f"{now:.3f} s → "
        share = "" if now is None else f" (−{100 * (now - best.planned) / now:.1f} %)"
        return f"{self.group.name}: {saved}{best.planned:.3f} s{share} in the order {self.names(best.order)}"

    @property
    def remarks(self) -> Iterator[str]:
        """What is exact, what is a plan, and what was left out."""
        n = len(self.group.parts)
        model = self.found[self.best_of_model].model
        if not math.isfinite(model):
            yield "model: the search's times between stations were not found in the time"
        elif self.exact:
            yield (
                f"model: {model:.3f} s is the least of all {math.factorial(n):,} orders by the search's times between "
                "stations, exact on its grid of rail positions"
            )
        else:
            yield (
                f"model: {model:.3f} s is the best order found for {n} parts (nearest neighbour, then Or-opt and "
                f"2-opt); by the same times no order takes less than {self.bound:.3f} s"
            )
        plans = sum(one.planned is not None for one in self.found.values())
        several = "s" if plans != 1 else ""
        yield f"plans: {plans} order{several} planned whole and judged; one that was not planned may be faster still"
        if self.stopped is not None:
            yield f"{self.stopped}: the best found by then"
            left = [one for one in self.found.values() if one.planned is None and not one.why and one.estimate]
            if left:
                one = min(left, key=lambda one: one.estimate or math.inf)
                yield f"not planned: {self.names(one.order)}, for which the search foretells {one.estimate:.3f} s"
        for one in self.found.values():
            if one.why:
                yield f"{self.names(one.order)}: {one.why}"
        if self.why_not is not None:
            yield f"not written into the program: {self.why_not}"


def order_of(
    group: Group, target: Target, listen: Listener, patience: Patience, jobs: int | None = None
) -> Ordered | Infeasible:
    """The fastest order of a group's parts on one target. jobs: processes; the answer is the same for any number.

    patience: ends the search, and what was found by then is the answer; with a time limit the written order is planned
    first, in a third of it. Raises InputError for parts that do not begin with a joint move. Infeasible: no order is
    connected, or the motion that cannot be done in any.
    """
    job = group.job
    agreed = may_change(job, Loops.KEEP)
    if agreed.infeasible is not None:
        return agreed.infeasible
    changes = agreed.changes[target]
    axes = Axes.of(job.plant)
    problem = PlanRequest(job.program, job.plant, target, EVERYTHING, changes).unchecked()[0]
    if not isinstance(problem, Problem):
        return problem
    n, last = len(group.parts), group.parts[-1].motions[1] - 1
    written, at_last = tuple(range(n)), partial(Infeasible, last, job.program.motions[last].source)
    work, planned = _Work(group, target, changes, listen, patience, jobs or cores()), dict[Order, Tour]()
    if patience.limit is not None:
        patience.reserve(_WRITING * patience.load)
        planned = work.all_of([Tour(written, math.inf)], patience.part(1 / 3))
        if planned[written].planned is not None:
            patience.settle()
    listen("order", Progress("search"))
    try:
        with patience.cutting():
            steps = sequence.steps_of(axes, problem, [part.motions for part in group.parts])
    except sequence.NotApart as no:
        raise job.cell.error(f"order.{group.name}", _not_apart(group, no.station)) from no
    except Stopped:
        if planned[written].planned is None:
            return Infeasible(0, job.program.motions[0].source, f"the written order: {planned[written].why}")
        return Ordered(group, target, planned, written, written, False, 0.0, patience.why(), None)
    nearest = written if steps is None else sequence.nearest_order(steps)
    exact = n <= axes.settings.exact_stations
    best, top = (math.inf, written) if steps is None else _best(steps, written, nearest, exact)
    if steps is None or not math.isfinite(best):
        return at_last("no order of the parts connects the start with the end")
    bound = best if exact else sequence.least_time(steps)
    tried = dict.fromkeys([written, nearest, top, *sequence.near_orders(steps, top, _NEAR)])
    found = {one: Tour(one, steps.cost(one)) for one in tried}
    patience.answer()
    found |= work.all_of([found[one] for one in tried])
    found |= {one: replace(found[one], planned=tour.planned, why=tour.why) for one, tour in planned.items()}
    ranked = sorted(found, key=lambda one: found[one].estimate or math.inf)[:PLANNED]
    left = [one for one in dict.fromkeys([written, nearest, top, *ranked]) if one not in planned]
    found |= work.all_of([found[one] for one in left], patience)
    stopped = patience.why() if patience.over else None
    answer = Ordered(group, target, found, nearest, top, exact, bound, stopped, None)
    fastest = answer.best
    if fastest is None:
        why = next((one.why for one in found.values() if one.why), "no plan was found")
        return at_last(f"no order that was planned can be done: {why}")
    why_not = None if fastest.order == written else group.why_not(fastest.order)
    return Ordered(group, target, found, nearest, top, exact, bound, stopped, why_not)


def _best(steps: sequence.Steps, written: Order, nearest: Order, exact: bool) -> tuple[float, Order]:
    if exact:
        return sequence.best_order(steps)
    starts = [sequence.improved_order(steps, one) for one in (nearest, written)]
    best = min(starts, key=steps.cost)
    return steps.cost(best), best


def _not_apart(group: Group, station: int | None) -> str:
    if station is None:
        return f"what follows {group.parts[-1].name} does not begin with a joint move (MoveJ, MoveAbsJ)"
    name = group.parts[station].name
    return f"{name} does not begin with a joint move (MoveJ, MoveAbsJ); a part is approach, work and departure"


@dataclass(frozen=True, eq=False)
class _Work:
    """Orders that are searched or planned, in processes, as long as there is patience."""

    group: Group
    target: Target
    changes: Changes
    listen: Listener
    patience: Patience
    workers: int

    def all_of(self, orders: Sequence[Tour], full: Patience | None = None) -> dict[Order, Tour]:
        """Each with its estimate or, with patience, its plan; those that there was no patience for are left out."""
        count, n = 0, len(orders)

        def hear(_: object) -> None:
            nonlocal count
            count += 1
            self.listen("order", Progress(f"{count} of {len(orders)} orders {'planned' if full else 'searched'}"))

        shares = [None if full is None else full.part(self.workers / (n - i)) for i in range(n)]
        tasks = {one.order: partial(self._one, one, share) for one, share in zip(orders, shares, strict=True)}
        return {order: one for order, one in shared_out(tasks, hear, self.workers).items() if one is not None}

    def _one(self, one: Tour, full: Patience | None, tell: Callable[[object], None]) -> Tour | None:
        """None where there is no patience left; the written order is always planned."""
        from trajopt_cli.plan import NoCleanPlan, optimize, search_estimate

        if self.patience.over and one.order != tuple(sorted(one.order)):
            return None
        job, target = self.group.job, self.target
        program, changes = self.group.program(one.order), self.group.changes(one.order, self.changes)
        try:
            with (full or self.patience).cutting():
                if full is None:
                    estimate = search_estimate(program, job.plant, target, changes)
                    tell(None)
                    return replace(one, estimate=estimate)
                plan = optimize(program, job.plant, target, bounded=False, changes=changes, patience=full)
                if isinstance(plan, Infeasible):
                    return replace(one, why=str(plan))
                illegal = why_illegal(job.plant, program, plan, target)
                tell(None)
                return replace(one, planned=plan.duration) if illegal is None else replace(one, why=illegal[0])
        except NoCleanPlan as no:
            return replace(one, why=f"no plan found: {no}")
        except Stopped:
            return None


# ------------------------------------------------------------------------------------------------------------ records


def order_record(answer: Ordered) -> dict[str, Any]:
    """The whole answer as plain data, SI."""
    best = answer.best
    return {
        "program": str(answer.group.job.program_path),
        "group": answer.group.name,
        "target": answer.target.value,
        "parts": [part.name for part in answer.group.parts],
        "written": _record(answer, answer.written),
        "nearest_neighbour": _record(answer, answer.found.get(answer.nearest)),
        "best_of_model": _record(answer, answer.found.get(answer.best_of_model)),
        "best": _record(answer, best),
        "model_is_exact": answer.exact,
        "model_bound_s": answer.bound,
        "stopped": answer.stopped,
        "why_not_written": answer.why_not,
        "orders": [_record(answer, one) for one in answer.found.values()],
    }


def _record(answer: Ordered, one: Tour | None) -> dict[str, Any] | None:
    if one is None:
        return None
    return {
        "order": [answer.group.parts[i].name for i in one.order],
        "model_s": one.model if math.isfinite(one.model) else None,
        "search_estimate_s": one.estimate,
        "cycle_time_s": one.planned,
        "why_not": one.why or None,
    }


def write_order(folder: Path, answer: Ordered, table: TextTable, lines: Sequence[str] = ()) -> int:
    """Write order.json, a page with the table and the lines, the program in the best order and the inputs; how many
    files that are. Raises InputError where folder may not be replaced."""
    job = answer.group.job
    page = answer_page(f"{job.title}: order of {answer.group.name}", answer.in_words, [table], lines, {})
    files = {"order.json": as_json(order_record(answer)), REPORT: page}
    if answer.new_text is not None:
        given = job.program.files[answer.group.file]
        files[f"program/{Path(given.path).name}"] = answer.new_text.encode(given.encoding)
    options = {"group": answer.group.name, "target": answer.target.value, "entry": job.program.entry}
    return write_answer(folder, study_record(ORDER), job, files, options)


def apply_order(answer: Ordered) -> Path:
    """Write the program's file in the best order over the user's own; where the old one is kept.

    Raises InputError, with the file as it was, where it is another one by now or cannot be written.
    """
    given = answer.group.job.program.files[answer.group.file]
    text = answer.new_text
    assert text is not None
    path = Path(given.path)
    return replace_files({path: (given.text.encode(given.encoding), text.encode(given.encoding))}, {})[path]
