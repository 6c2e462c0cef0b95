"""`check`: a program as it stands in one traffic light: does it read, reach, keep its limits, touch nothing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

from trajopt_cli.findings import CLEARANCE, CLEARANCES, SELF_CLEARANCE, Finding, Report, closeness, good_side
from trajopt_cli.job import Job
from trajopt_cli.pipeline.planning import changes_of, judge, undriven
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.uncertainty import WRITTEN, Uncertainty
from trajopt_cli.table import place

_PLACES = ("joint position", CLEARANCE, SELF_CLEARANCE)  # what a motion as fast as it may be does not use up by itself


class State(StrEnum):
    """What a light says."""

    OK = "ok"
    NO = "NO"
    OPEN = "not checked"


@dataclass(frozen=True)
class Light:
    """One question about a program, its answer, and a line on it."""

    check: str
    state: State
    said: str


@dataclass(frozen=True)
class Checked:
    """lights: in the order in which they are asked; those behind a NO that forbids to ask are open. cycle: as written
    [s], None where it cannot be driven; unsure: between which times it is. worst: the line that fails, or comes nearest
    to a limit."""

    lights: tuple[Light, ...]
    cycle: float | None
    worst: str
    unsure: Uncertainty | None = None

    @property
    def ok(self) -> bool:
        """Whether no answer is NO."""
        return all(one.state is not State.NO for one in self.lights)


def check(job: Job) -> Checked:
    """Ask a program that was read. It is driven as written by its controller, under the cell's limits, and judged."""
    from trajopt_cli.plan import NoCleanPlan, optimize
    from trajopt_cli.plan.uncertainty import uncertainty

    count, warnings = len(job.program.motions), len(job.program.warnings)
    doubts = f", {warnings} warning{'s' if warnings > 1 else ''}: trajopt parse tells" if warnings else ""
    reads = Light("reads", State.OK, f"{count} motions{doubts}")
    rows = RowsFile()
    try:
        plan = optimize(
            job.program, job.plant, Target.RAPID, AS_WRITTEN, bounded=False, changes=changes_of(job, Target.RAPID)
        )
    except NoCleanPlan as failure:
        plan = Infeasible(0, job.program.motions[0].source, f"no motion found: {failure}")
    if isinstance(plan, Infeasible):
        behind = (Light(name, State.OPEN, "no motion reaches every point") for name in ("limits", "collisions"))
        return Checked((reads, Light("reaches", State.NO, str(plan)), *behind), None, str(plan))
    if whys := undriven(job):
        behind = (Light(name, State.OPEN, "not every motion can be driven") for name in ("limits", "collisions"))
        return Checked((reads, Light("reaches", State.NO, whys[0]), *behind), None, whys[0])
    plan = rows.keep(plan)
    report = judge(job.plant, job.program, rows.text, "as written", (), Target.RAPID, advice=False)
    reaches = Light("reaches", State.OK, "every point and line, as programmed")
    lights = (reads, reaches, *_judged(report, job.plant.unchecked))
    return Checked(
        lights, plan.duration, _worst(report), uncertainty(job.program, job.plant, job.scenario.settle, {WRITTEN: plan})
    )


def _judged(report: Report, unchecked: tuple[str, ...]) -> Iterator[Light]:
    hits = [one for one in report.findings if one.check in CLEARANCES]
    limits = [one for one in report.findings if one not in hits]
    for name, findings in (("limits", limits), ("collisions", hits)):
        failed = [one for one in findings if not one.passed]
        doubts = [one for one in unchecked if ("colli" in one or "obstacle" in one) == (name == "collisions")]
        if failed:
            more = f" ({len(failed) - 1} more)" if len(failed) > 1 else ""
            yield Light(name, State.NO, f"{failed[0].message or _told(failed[0])}{more}")
        elif not findings:
            yield Light(name, State.OPEN, "; ".join(doubts))
        else:
            yield Light(name, State.OK, "; ".join([f"{len(findings)} check{'s' * (len(findings) > 1)}", *doubts]))


def _worst(report: Report) -> str:
    found = [one for one in report.findings if not one.passed or one.check in _PLACES]
    worst = min(found, key=closeness, default=None)
    if worst is None:
        return "no line comes near a limit"
    return worst.message if not worst.passed and worst.message else f"nearest to a limit: {_told(worst)}"


def _told(one: Finding) -> str:
    at = f"{place(one.source)}, " if one.source else ""
    return f"{at}{one.check} of {one.subject} {one.value:.4g} {one.unit}, {abs(good_side(one)):.3g} {one.unit} left"
