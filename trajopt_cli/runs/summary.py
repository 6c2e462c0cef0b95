"""summary.json, the answer of `trajopt optimize` in numbers, SI: the one record that terminal and pages render."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import Annotated, Any

from pydantic import AliasChoices, BeforeValidator, Field

from trajopt_cli.findings import Finding, Report
from trajopt_cli.motion import Program, SignalEvent, Wait, as_written, without_name
from trajopt_cli.problem.constant_speed import Stretch, stretch_record
from trajopt_cli.problem.corners import Corners
from trajopt_cli.problem.detours import point_names
from trajopt_cli.problem.plan import Eased, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.record import Section
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.uncertainty import Uncertainty
from trajopt_cli.scenario import Settling
from trajopt_cli.table import change, short_target, told_gap

NOT_TIMED = "not timed: stopped by Ctrl-C"
SETTLING = "settling"


@dataclass(frozen=True, eq=False)
class Judged:
    """A plan, the file of its rows, and what the judge said of their text."""

    plan: Plan
    rows: RowsFile
    report: Report


def _finite(value: object) -> object:
    return None if isinstance(value, float) and not math.isfinite(value) else value


_Figure = Annotated[float | None, BeforeValidator(_finite)]
_Place = Annotated[str | None, BeforeValidator(lambda one: None if one is None else str(one))]


class FindingRow(Section):
    """What one check of the judge found; None for a number that could not be computed."""

    check: str
    subject: str
    value: _Figure = None
    limit: _Figure
    margin: _Figure = None
    unit: str
    passed: bool = True
    time_s: _Figure = Field(None, validation_alias=AliasChoices("time_s", "time"))
    source: _Place = None
    message: str = ""


def finding_record(finding: Finding) -> dict[str, Any]:
    """A finding as plain data for JSON."""
    return FindingRow.model_validate(finding, from_attributes=True).model_dump()


class Verdict(Section):
    """The judge's word on a plan."""

    legal: bool
    findings: list[FindingRow]


class MotionRow(Section):
    """A motion of a plan; times in s from the start. until: the condition that ends a wait, None for none. binding: the
    limit that holds it back."""

    index: int
    source: str = ""
    instruction: str
    target: str
    until: str | None = None
    start_s: float
    time_s: float
    binding: str = ""
    dropped: bool
    axes_at_end: list[float]

    @property
    def place(self) -> str:
        """The file's name and the line."""
        path, _, line = self.source.removesuffix(":" + self.source.rsplit(":", 1)[-1]).rpartition(":")
        return f"{PurePath(path).name}:{line}" if path else self.source

    @property
    def key(self) -> tuple[str, str]:
        """What it is called."""
        return self.instruction, self.target

    @property
    def name(self) -> str:
        """The same, for people."""
        return f"{self.instruction} {short_target(self.target)}".strip()


class PointRow(Section):
    """An additional point: its name in the RAPID text, all axes there, the radius of its zone [m] or None for a stop,
    and when it is passed [s]."""

    target: str
    axes: list[float]
    radius_m: float | None
    time_s: float
    binding: str


class DetourRow(Section):
    """A way around. motion: index of the one that its points are before."""

    motion: int
    around: list[str]
    points: list[PointRow]


class PlanSummary(Section):
    """A plan. lower_bound_s: no legal motion is faster, None where none was asked for."""

    cycle_time_s: float
    lower_bound_s: float | None = None
    gap: float | None = None
    least_effort: dict[str, Any] | None = None
    suspicious: str | None = None
    grid: str = ""
    axes: list[str] = Field(default_factory=list)
    motions: list[MotionRow]
    detours: list[DetourRow] = Field(default_factory=list)
    constant_speed: list[dict[str, Any]] = Field(default_factory=list)
    judge: Verdict


class Plans(Section):
    """The plans of both targets."""

    stream: PlanSummary
    rapid: PlanSummary

    def of(self, target: Target) -> PlanSummary:
        """The plan of one of them."""
        return self.stream if target is Target.STREAM else self.rapid


class Written(Section):
    """The program as it stands: its times [s], or why it has none."""

    cycle_time_s: float | None = None
    motion_times_s: list[float] = Field(default_factory=list)
    why_not: str | None = None


class Settled(Section):
    """Settling at stops that are waited for, the same in every plan: at how many, how long at one and in all [s].
    source: as Settling has it."""

    stops: int
    each_s: list[float]
    seconds: float
    source: str

    @property
    def how(self) -> str:
        """At how many stops, how long at each, and how sure that is."""
        each = " or ".join(f"{one:g}" for one in self.each_s)
        graded = re.search(r"\((grade [A-D])\)$", self.source)
        stops = f"{self.stops} stop{'s' if self.stops > 1 else ''}"
        return f"{stops}, {each} s each, {graded[1] if graded else self.source}"

    @property
    def line(self) -> str:
        """The same as a sentence."""
        return f"settling {self.seconds:.3f} s ({self.how})"


def settled(program: Program, settle: Settling) -> Settled | None:
    """How long the axes settle in a program; None where no stop is waited for, or it takes no time."""
    times = [one.duration for one in program.motions if isinstance(one, Wait) and one.settles]
    if not times:
        return None
    return Settled(stops=len(times), each_s=sorted({*times}), seconds=sum(times), source=settle.source)


class Summary(Section):
    """The whole answer. passes: of a loop that never ends in the cycle, whose times all others are. limits: how sure
    they are; uncertainty: what that makes of the times. unchecked: what the judge was given nothing to hold the motion
    against. undriven: what runs outside a loop's cycle and cannot be driven as written, and why. notes: what the RAPID
    text changes, and what it could not; kept: those of the latter. settling: None for none."""

    target: Annotated[Target, Field(strict=False)]
    plans: Plans
    as_written: Written = Written()
    passes: int = 1
    fly_bys_passed: dict[str, int] = Field(default_factory=dict)
    fly_bys_stopped: list[dict[str, Any]] = Field(default_factory=list)
    warnings: list[str] = Field(default_factory=list)
    limits: list[str] = Field(default_factory=list)
    uncertainty: Uncertainty = Uncertainty()
    unchecked: list[str] = Field(default_factory=list)
    undriven: list[str] = Field(default_factory=list)
    notes: list[str] = Field(default_factory=list)
    kept: list[str] = Field(default_factory=list)
    settling: Settled | None = None

    @property
    def verdict(self) -> str:
        """The judge's word on both plans, with what cannot be driven besides and what was not looked at."""
        bad = [str(one) for one in Target if not self.plans.of(one).judge.legal]
        word = f"the {' and the '.join(bad)} plan: NOT LEGAL" if bad else "legal"
        return "; ".join([word, *self.undriven, *self.unchecked])

    @property
    def written_times(self) -> dict[int, float]:
        """What motions take as written [s], by index; empty where that is not known."""
        indices = (one.index for one in self.plans.rapid.motions)
        return dict(zip(indices, self.as_written.motion_times_s, strict=False))

    def change(self, target: Target) -> str:
        """What becomes of the time as written, in per cent, and between what: "−26.5 %, −24 to −28"; nothing where
        there is none to begin with."""
        before = self.as_written.cycle_time_s
        told = change(before, self.plans.of(target).cycle_time_s) if before else ""
        return f"{told}{self.uncertainty.saved(target.value)}"


def motion_label(program: Program, index: int) -> tuple[str, str]:
    """The instruction's name and its target (or signal, condition, duration) of one motion, for tables."""
    motion = program.motions[index]
    match motion:
        case Wait() if motion.settles:
            return SETTLING, f"{motion.duration:g} s"
        case Wait(condition=None, duration=0.0, in_position=True):  # WaitRob \\InPos, ActUnit and the like
            return as_written(program, motion)
        case Wait(condition=None):
            return "WaitTime", f"{motion.programmed:g} s{' beside' * (motion.beside is not None)}"
        case Wait():
            name = as_written(program, motion)[0]
            return name, without_name(motion.condition or "", name)
        case SignalEvent():
            name, said = as_written(program, motion)  # the alias of a signal stands for it
            spelled = re.search(rf"\b{re.escape(motion.signal)}\b", said, re.IGNORECASE)
            return name, f"{spelled[0] if spelled else motion.signal} = {motion.value:g}"
    return type(motion).__name__, motion.target


def summary(
    program: Program,
    plant: Plant,
    target: Target,
    judged: Mapping[Target, Judged],
    written: Plan | str,
    kept_speed: Mapping[Target, Sequence[Stretch]],
    corners: Corners,
    passed: Mapping[Target, int],
    warnings: Iterable[str],
    notes: Iterable[str] = (),
    kept: Iterable[str] = (),
    undriven: Iterable[str] = (),
    unsure: Uncertainty | None = None,
    settling: Settled | None = None,
) -> Summary:
    """The same for the same inputs. written: the program as it stands, or why it cannot be driven so, or NOT_TIMED.
    kept_speed: the stretches that should keep their programmed speed, by target. corners: of the whole program. passed:
    at how many fly-bys a plan does not stop."""
    times = None if isinstance(written, str) else [motion.t_1 - motion.t_0 for motion in written.motions]
    return Summary(
        target=target,
        plans=Plans(**{one.value: _plan(program, plant, judged[one], kept_speed[one]) for one in Target}),
        as_written=Written(
            cycle_time_s=None if isinstance(written, str) else written.duration,
            motion_times_s=times or [],
            why_not=written if isinstance(written, str) else None,
        ),
        passes=max(program.passes, 1),
        fly_bys_passed={one.value: passed[one] for one in Target},
        fly_bys_stopped=[
            {"index": index, "source": str(program.motions[index].source), "why": why}
            for index, why in corners.stopped.items()
        ],
        warnings=list(warnings),
        limits=list(plant.notes),
        uncertainty=unsure or Uncertainty(),
        unchecked=list(plant.unchecked),
        undriven=list(undriven),
        notes=list(notes),
        kept=list(kept),
        settling=settling,
    )


def _plan(program: Program, plant: Plant, judged: Judged, stretches: Sequence[Stretch]) -> PlanSummary:
    plan = judged.plan
    labels = [motion_label(program, motion.index) for motion in plan.motions]
    return PlanSummary(
        cycle_time_s=plan.duration,
        lower_bound_s=plan.lower_bound,
        gap=plan.gap,
        least_effort=None if plan.eased is None else _eased(plan.eased),
        suspicious=plan.suspicion,
        grid=plan.grid,
        axes=list(plan.trajectory.names),
        motions=[
            MotionRow(
                index=motion.index,
                source=str(motion.source),
                instruction=instruction,
                target=target,
                until=getattr(program.motions[motion.index], "condition", None),
                start_s=motion.t_0,
                time_s=motion.t_1 - motion.t_0,
                binding=motion.binding,
                dropped=motion.dropped,
                axes_at_end=motion.q_1.tolist(),
            )
            for motion, (instruction, target) in zip(plan.motions, labels, strict=True)
        ],
        detours=[*_detours(program, plant, plan)],
        constant_speed=[stretch_record(program, one) for one in stretches],
        judge=Verdict(
            legal=judged.report.legal,
            findings=[FindingRow.model_validate(one, from_attributes=True) for one in judged.report.findings],
        ),
    )


def _detours(program: Program, plant: Plant, plan: Plan) -> Iterator[DetourRow]:
    via = {motion.index: motion.via for motion in plan.motions}
    for detour, names in zip(plan.detours, point_names(program, plant, plan.detours), strict=True):
        points = [
            PointRow(
                target=name, axes=point.q.tolist(), radius_m=point.radius, time_s=passing.t, binding=passing.binding
            )
            for name, point, passing in zip(names, detour.points, via[detour.motion], strict=True)
        ]
        yield DetourRow(motion=detour.motion, around=list(detour.around), points=points)


def _eased(eased: Eased) -> dict[str, Any]:
    strains = (("fastest", eased.fastest), ("planned", eased.planned))
    told = {name: {"effort_s": one.effort, "rail_way_m": one.rail_way} for name, one in strains}
    return {"least_time_s": eased.least_time, **told}


def cycle_line(label: str, plan: PlanSummary, grid: bool = True) -> str:
    """A duration with its bound, gap and grid; of a gentle plan its strain beside that of the fastest."""
    bound = "" if plan.gap is None else f" (lower bound {plan.lower_bound_s:.3f} s, {told_gap(plan.gap)})"
    bound += "" if plan.suspicious is None else ", SUSPICIOUS: see the warning"
    on = f", grid {plan.grid}" if grid else ""
    if plan.least_effort is None:
        return f"{label}: T = {plan.cycle_time_s:.3f} s{bound}{on}"
    now, fast = plan.least_effort["planned"], plan.least_effort["fastest"]
    rail, before = (f", rail {one['rail_way_m']:.3f} m" if fast["rail_way_m"] else "" for one in (now, fast))
    return (
        f"{label}: T = {plan.cycle_time_s:.3f} s, effort {now['effort_s']:.3f} s{rail}; fastest found T = "
        f"{plan.least_effort['least_time_s']:.3f} s{bound}, effort {fast['effort_s']:.3f} s{before}{on}"
    )
