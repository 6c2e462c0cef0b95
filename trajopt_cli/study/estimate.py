"""`estimate`: how long a program takes as the controller would drive it, beside length over speed, and what that rests
on."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import PurePath
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.job import Job
from trajopt_cli.measured.align import Alignment, SeenSettling, align, settles, settling_seen
from trajopt_cli.measured.reached import Reached, contradictions, reached_in, tool_beyond
from trajopt_cli.motion import Move, MoveAbsJ, PoseMove, SignalEvent, Source, Wait
from trajopt_cli.pipeline.planning import Clock, as_written, changes_of
from trajopt_cli.problem.corners import corners_of, passed_in
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.report.stepwise import StepMove, analyse
from trajopt_cli.runs.summary import SETTLING, Settled, motion_label, settled
from trajopt_cli.runs.uncertainty import WRITTEN, Uncertainty
from trajopt_cli.table import TextTable, place, seconds, signed, tabulate
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import slides

_STANDS = 1e-9  # m
_RESTS = 1e-6  # m and parts of a turn: what is written to 0.001 mm
_OF_AXIS = re.compile(r"(\w+) (speed|acceleration|jerk|torque)")
_KEY = {"speed": "velocity", "acceleration": "acceleration", "jerk": "jerk", "torque": "torque"}
_GRADE = re.compile(r"\(grade ([A-D])\)$")
LEFT_OUT = (
    "not in the model: the servo's lag, speeds the load costs, singularities that slow the "
    "controller down, and waits that take longer than their least time"
)


@dataclass(frozen=True)
class EstimatedMotion:
    """One motion: naive [s] is length over programmed speed, driven [s] under all limits; of a wait, and of a move
    whose tool rests for a programmed time, both are its least time. binding: the limit that holds it back longest."""

    index: int
    source: Source
    wait: bool
    naive: float
    driven: float
    binding: str


@dataclass(frozen=True)
class RestsOn:
    """A limit of an axis that holds motions back: its value [SI], where it comes from, for how many seconds of motions
    but waits it is the first to bind; guess: nobody at hand confirms it (grade C or D)."""

    limit: str
    value: float
    unit: str
    source: str
    guess: bool
    seconds: float


@dataclass(frozen=True, eq=False)
class Estimate:
    """plan: the program as written under the cell's limits; unsure: between which times it is. motions: those that take
    time, in order. corners: how many fly-bys are driven as corners, stops: how many are stops. rests: the most seconds
    first."""

    job: Job
    plan: Plan
    unsure: Uncertainty
    motions: tuple[EstimatedMotion, ...]
    rests: tuple[RestsOn, ...]
    corners: int
    stops: int

    @property
    def naive(self) -> float:
        """Length over speed, waits apart [s]."""
        return sum(one.naive for one in self.motions if not one.wait)

    @property
    def driven(self) -> float:
        """As driven, waits apart [s]."""
        return sum(one.driven for one in self.motions if not one.wait)

    @property
    def waits(self) -> float:
        """Programmed waits, their least time [s]."""
        return sum(one.driven for one in self.motions if one.wait)

    @property
    def settling(self) -> Settled | None:
        """At the stops that are waited for; None for none."""
        return settled(self.job.program, self.job.scenario.settle)

    @property
    def guesses(self) -> tuple[RestsOn, ...]:
        """The numbers that are guesses."""
        return tuple(one for one in self.rests if one.guess)


def estimate(job: Job) -> Estimate | str:
    """The program as written, driven by the RAPID controller under the cell's limits; or why it cannot be, one line."""
    from trajopt_cli.plan import PlanCache
    from trajopt_cli.plan.uncertainty import uncertainty

    plan = as_written(job, changes_of(job, Target.RAPID), Clock(), PlanCache())
    if isinstance(plan, str):
        return plan
    steps = {move.index: move for move in analyse(job.program, job.plant).moves}
    motions = []
    for one in plan.motions:
        motion = job.program.motions[one.index]
        if isinstance(motion, SignalEvent) or (isinstance(motion, Wait) and motion.settles):
            continue
        wait, driven = isinstance(motion, Wait) or _rests(motion, steps[one.index]), one.t_1 - one.t_0
        naive = driven if wait else _naive(job, steps[one.index])
        motions.append(EstimatedMotion(one.index, one.source, wait, naive, driven, one.binding))
    programmed = corners_of(job.program, job.plant)
    passed = len(passed_in(job.program, job.plant, plan))
    stopped = len(programmed.passed) + len(programmed.stopped) - passed
    unsure = uncertainty(job.program, job.plant, job.scenario.settle, {WRITTEN: plan})
    return Estimate(job, plan, unsure, tuple(motions), tuple(_rests_on(job, motions)), passed, stopped)


def _rests(motion: Move, step: StepMove) -> bool:
    r"""Whether a move is a wait in which the rail moves, as `export rapid` writes it: the tool rests for \T."""
    return motion.duration is not None and np.allclose(step.X_WT_0, step.X_WT_1, atol=_RESTS)


def _naive(job: Job, move: StepMove) -> float:
    """Length over speed [s], for the rail as for the tool; a programmed duration as it is."""
    motion, limits = job.program.motions[move.index], job.plant.limits
    assert isinstance(motion, Move)
    way = abs(move.rail_1 - move.rail_0)
    if motion.duration is not None or not job.plant.robot.has_rail or way < _STANDS:
        return move.duration
    return max(move.t_arm, way / min(motion.speed.v_leax, float(limits.velocity[job.plant.layout.rail].min())))


def _rests_on(job: Job, motions: list[EstimatedMotion]) -> Iterator[RestsOn]:
    limits = job.plant.limits
    seconds: dict[str, float] = {}
    for one in motions:
        if not one.wait and _OF_AXIS.fullmatch(one.binding) and one.binding.split()[0] in limits.names:
            seconds[one.binding] = seconds.get(one.binding, 0.0) + one.driven
    for name in sorted(seconds, key=lambda name: (-seconds[name], name)):
        axis, kind = name.split()
        values = getattr(limits, _KEY[kind])
        source = limits.sources.get(f"{axis}.{_KEY[kind]}", "")
        grade = _GRADE.search(source)
        base = "m" if slides(axis) else "rad"
        powers = {"speed": "", "acceleration": "²", "jerk": "³"}
        unit = f"{base}/s{powers[kind]}" if kind in powers else "N" if slides(axis) else "Nm"
        guess = grade is not None and grade[1] in "CD"
        yield RestsOn(name, float(values[limits.names.index(axis)]), unit, source, guess, seconds[name])


def doubts(answer: Estimate) -> Iterator[str]:
    """What the cycle time rests on that nobody has measured, a line each."""
    if answer.guesses:
        share = sum(one.seconds for one in answer.guesses)
        names = ", ".join(f"{one.limit} {one.value:g} {one.unit}" for one in answer.guesses)
        yield f"guesses: {names}; they hold back {share:.3f} s of {answer.driven:.3f} s of motion"
    if answer.corners:
        yield (
            f"also assumed: parabolic corners at {answer.corners} fly-by{'s' if answer.corners > 1 else ''}; "
            "controllers publish no other shape"
        )
    if answer.stops:
        yield f"{answer.stops} programmed fly-by{'s are' if answer.stops > 1 else ' is'} driven as stops here"
    if answer.job.plant.limits.binding_jerk is None:
        yield "accelerations may jump: the cell file has no jerk_limits"
    yield LEFT_OUT


@dataclass(frozen=True)
class Logs:
    """Logs beside an estimate: those that follow the program, what is wrong with the others, what axes reached in them,
    and where that and the limits in force cannot both be right."""

    alignments: tuple[Alignment, ...]
    wrong: tuple[InputError, ...]
    reached: tuple[Reached, ...]
    against: tuple[str, ...]
    settling: tuple[SeenSettling, ...] = ()

    @property
    def settled(self) -> tuple[str, ...]:
        """How long the axes settled, and the key of the cell file that says so; nothing where no log tells."""
        seen = [
            f"{one.kind} {one.seconds:.3f} s ({one.stops} seen, predicted {one.predicted:g} s)" for one in self.settling
        ]
        keys = ", ".join(f"{one.kind}: {one.seconds:.3f}" for one in self.settling)
        line = f"settling at stops by the logs: {', '.join(seen)}; for the cell file: 'settle: {{{keys}}}'"
        return (line,) if seen else ()

    @property
    def said(self) -> str:
        """What was compared, one line."""
        if len(self.alignments) == 1:
            return self.alignments[0].said
        shares = {one.file: 1 - one.predicted / one.cycle for one in self.alignments}
        worst = max(shares, key=lambda file: abs(shares[file]))
        mean = float(np.mean(np.abs([*shares.values()])))
        return (
            f"compared with {len(shares)} logs: |measured - predicted| {100 * mean:.1f} % on average, at most "
            f"{100 * shares[worst]:+.1f} % ({PurePath(worst).name})"
        )


def beside(answer: Estimate, logs: Mapping[str, Trajectory], wrong: Sequence[InputError]) -> Logs:
    """Logs by file, beside the estimate. wrong: with files that could not even be read."""
    limits, found, out = answer.job.plant.limits, list[Alignment](), list(wrong)
    for file, log in logs.items():
        try:
            found.append(align(answer.job.program, answer.plan, limits.velocity, log, file))
        except InputError as error:
            out.append(error)
    motions, names = [logs[one.file] for one in found], [PurePath(one.file).name for one in found]
    reached = reached_in(motions, names, limits)
    seen = tuple(settling_seen(answer.job.program.motions, found))
    against = [*contradictions(motions, names, limits, reached)]
    tools = {one.tool.name: one.tool for one in answer.job.program.motions if isinstance(one, PoseMove | MoveAbsJ)}
    if len(tools) == 1 and not (tool := tools.popitem()[1]).stationary:
        for name, log in zip(names, motions, strict=True):
            p = (answer.job.plant.robot.forward(log.q) @ tool.X_FT)[:, :3, 3]
            against += tool_beyond(log.t, p, answer.job.plant.tcp, name)
    return Logs(tuple(found), tuple(out), tuple(reached), (*against, *(one.doubt for one in found if one.doubt)), seen)


def uncalibrated(logs: Logs | None) -> str:
    """What was compared, or that nothing was."""
    return logs.said if logs else "uncalibrated: no log of this cell was compared with it; --log FILE.csv does that"


def estimate_record(answer: Estimate, logs: Logs | None, many: bool = False) -> dict[str, Any]:
    """The whole answer as plain data, SI. many: logs of a folder."""
    alignment = logs.alignments[0] if logs and not many else None
    measured = {} if alignment is None else {one.index: one for one in alignment.motions}
    motions = []
    for one in answer.motions:
        instruction, target = motion_label(answer.job.program, one.index)
        entry: dict[str, Any] = {
            "index": one.index, "source": str(one.source), "instruction": instruction, "target": target,
            "wait": one.wait, "length_over_speed_s": one.naive, "predicted_s": one.driven, "binding": one.binding,
        }  # fmt: skip
        if one.index in measured:
            entry["measured_s"] = measured[one.index].measured
            entry["measured_minus_predicted_s"] = measured[one.index].measured - one.driven
        motions.append(entry)
    record: dict[str, Any] = {
        "program": str(answer.job.program_path),
        "cycle_time_s": answer.plan.duration,
        "uncertainty": answer.unsure.model_dump(),
        "motion_s": answer.driven,
        "length_over_speed_s": answer.naive,
        "waits_s": answer.waits,
        "settling": None if answer.settling is None else answer.settling.model_dump(),
        "corners": answer.corners,
        "fly_bys_driven_as_stops": answer.stops,
        "calibrated": logs is not None,
        "calibration": uncalibrated(logs),
        "rests_on": [asdict(one) for one in answer.rests],
        "doubts": list(doubts(answer)),
        "motions": motions,
    }  # fmt: skip
    if alignment is not None:
        record["log"] = _log_record(alignment)
    if logs:
        record["logs"] = [_log_record(one) for one in logs.alignments]
        record["refused"] = [str(error) for error in logs.wrong]
        record["reached"] = [asdict(one) for one in logs.reached]
        record["contradictions"] = list(logs.against)
        record["settling_seen"] = [asdict(one) for one in logs.settling]
    return record


def _log_record(one: Alignment) -> dict[str, Any]:
    """What was compared as plain data, SI."""
    return {
        "file": one.file, "cycle_s": one.cycle, "predicted_s": one.predicted, "motion_s": one.motion,
        "waits_s": one.waits, "whole": one.whole, "period_s": one.period, "from_s": one.counted[0].t_0,
        "to_s": one.counted[-1].t_1, "passes": [{"from_s": a.t_0, "to_s": a.t_1, "whole": a.whole} for a in one.passes],
        "farthest": one.farthest,
    }  # fmt: skip


def estimate_table(answer: Estimate, log: Alignment | None) -> TextTable:
    """Motions in program order; waits in a column of their own."""
    program = answer.job.program
    measured = {} if log is None else {one.index: one.measured for one in log.motions}
    columns: dict[str, Callable[[EstimatedMotion], str]] = {
        "place": lambda one: place(one.source),
        "instruction": lambda one: motion_label(program, one.index)[0],
        "target": lambda one: motion_label(program, one.index)[1],
        ">length/speed [s]": lambda one: "" if one.wait else seconds(one.naive),
        ">predicted [s]": lambda one: "" if one.wait else seconds(one.driven),
        ">wait [s]": lambda one: seconds(one.driven) if one.wait else "",
    }
    if log:
        columns[">measured [s]"] = lambda one: seconds(measured.get(one.index))
        columns[">measured - predicted [s]"] = lambda one: (
            signed(measured[one.index] - one.driven) if one.index in measured else ""
        )
    columns["held back by"] = lambda one: "" if one.wait else one.binding
    title = f"{answer.job.title}: as written, driven by its controller under the limits of {answer.job.cell_path}"
    made = tabulate(title, answer.motions, columns)
    if answer.settling is None:
        return made
    cells = {"place": SETTLING, "target": answer.settling.how, ">wait [s]": seconds(answer.settling.seconds)}
    if log and (seen := [one for one in log.motions if settles(program.motions, one.index)]):
        stood, off = sum(one.measured for one in seen), sum(one.measured - one.predicted for one in seen)
        cells |= {">measured [s]": seconds(stood), ">measured - predicted [s]": signed(off)}
    return replace(made, rows=(*made.rows, tuple(cells.get(head, "") for head in made.heads)), total=True)


def logs_table(answer: Estimate, logs: Sequence[Alignment]) -> TextTable:
    """A line per log."""
    return tabulate(
        f"{answer.job.title}: logs beside the program as written under the limits of {answer.job.cell_path}",
        logs,
        {
            "~log": lambda one: PurePath(one.file).name,
            ">passes": lambda one: str(len(one.counted)) if one.whole else "in part",
            ">measured [s]": lambda one: seconds(one.cycle),
            ">predicted [s]": lambda one: seconds(one.predicted),
            ">measured - predicted [s]": lambda one: signed(one.cycle - one.predicted),
            ">[%]": lambda one: signed(100 * (one.cycle - one.predicted) / one.cycle, 1),
            ">motions [s]": lambda one: seconds(one.motion),
            ">predicted motions [s]": lambda one: seconds(one.predicted_motion),
            ">standing [s]": lambda one: seconds(one.waits),
        },
    )


def sums(answer: Estimate, log: Alignment | None) -> Iterator[str]:
    """The cycle, a line each."""
    slower = answer.driven - answer.naive
    yield (
        f"cycle {answer.plan.duration:.3f} s{answer.unsure.around(WRITTEN)}: motions {answer.driven:.3f} s, "
        f"waits {answer.waits:.3f} s (their least time)"
        f"{'' if answer.settling is None else f', {answer.settling.line}'}"
    )
    share = f" ({100 * slower / answer.naive:+.1f} %)" if answer.naive > 0 else ""
    yield f"length over speed {answer.naive:.3f} s; ramps, corners and limits make that {slower:+.3f} s{share}"
    if log:
        off = log.cycle - log.predicted
        what = "from the first move to the end of the last" if log.whole else "of the motions that the log holds"
        told = f"measured - predicted {off:+.3f} s ({100 * off / log.cycle:+.1f} %)"
        yield f"measured {log.cycle:.3f} s {what}, predicted {log.predicted:.3f} s: {told}"
