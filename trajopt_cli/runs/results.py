"""The results folder of `trajopt optimize`: what is in it, how it is read back, and put over the user's own files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from glob import escape
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from trajopt_cli.errors import InputError
from trajopt_cli.findings import Report, finding_record
from trajopt_cli.joint_csv import FARTHEST
from trajopt_cli.motion import Program, SignalEvent, Wait, as_written, without_name
from trajopt_cli.problem.constant_speed import Stretch, stretch_record
from trajopt_cli.problem.corners import Corners
from trajopt_cli.problem.detours import Detour, Via, point_names
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Eased, Passing, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.quantity import complain
from trajopt_cli.runs import SUMMARY
from trajopt_cli.runs.folder import PLAN, ResultsFolder, read_bytes, read_run
from trajopt_cli.runs.record import RunRecord, Section, UserPath, as_json, quoted
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.transaction import replace_files

CHOSEN = "trajectory.csv"
CSV = {Target.STREAM: "stream.csv", Target.RAPID: "rapid.csv"}
MODULES = (".mod", ".prg", ".sys", ".modx", ".sysx")
NOT_TIMED = "not timed: stopped by Ctrl-C"


@dataclass(frozen=True, eq=False)
class Judged:
    """A plan, the file of its rows, and what the judge said of their text."""

    plan: Plan
    rows: RowsFile
    report: Report


def _as_list(value: object) -> object:
    return [value] if isinstance(value, str) else value  # as older runs wrote a single program


def _a_target(value: str) -> str:
    if value and value not in [*Target]:
        raise complain(f"{quoted(value)} is none of {', '.join(Target)}")
    return value


class PlanOptions(Section):
    """As the user gave them, and the name of the target whose plan was chosen. cycle_time [s]: given for a plan of
    least effort, 0 where it was to be the least; None for the fastest plan."""

    program: Annotated[list[str], BeforeValidator(_as_list)] = Field(default_factory=list)
    cell: str = ""
    entry: str = "main"
    assume_identity: list[str] = Field(default_factory=list)
    target: Annotated[str, AfterValidator(_a_target)] = ""
    loops: Annotated[Loops, Field(strict=False)] = Loops.KEEP
    cycle_time: Annotated[float, Field(ge=0, le=FARTHEST)] | None = None


class AddedModule(Section):
    """A module that the export added: its path beside the program, and its place in the folder."""

    path: UserPath
    rapid: str


class PlanRecord(RunRecord[PlanOptions]):
    """run.json of trajopt optimize. no_rapid: why the plan could not be written as RAPID. seconds: per phase."""

    KIND: ClassVar[str] = PLAN
    LIBRARIES: ClassVar[tuple[str, ...]] = ("casadi", "numpy", "pin", "ruckig", "scipy", "toppra")
    REMEDY: ClassVar[str] = "run trajopt optimize again"

    options: PlanOptions = PlanOptions()
    no_rapid: str | None = None
    added: list[AddedModule] = Field(default_factory=list)
    started: str = ""
    seconds: dict[str, float] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _modules_have_places(self) -> PlanRecord:
        """Every module has an optimised version, or none has one."""
        for i, one in enumerate(self.inputs.files):
            if (one.rapid is not None) != (one.module and self.no_rapid is None):
                wanted = "none" if one.rapid is not None else "the place of the optimised module"
                raise complain(f"inputs.files[{i}].rapid: {quoted(one.rapid)}, wanted {wanted}")
        for key, module in (("program", True), ("cell", False)):
            place = getattr(self.inputs, key)
            if place not in [one.place for one in self.inputs.files if one.module is module]:
                kind = "a module" if module else "no module"
                raise complain(f"inputs.{key}: {quoted(place)} is not one of inputs.files that is {kind}")
        return self

    @model_validator(mode="after")
    def _added_lie_beside_the_program(self) -> PlanRecord:
        """New modules: each called as in the folder, and beside one of the program's own files."""
        own = {Path(one.path) for one in self.inputs.files}
        beside = {Path(one.path).parent for one in self.inputs.files if one.module}
        for i, one in enumerate(self.added):
            path = Path(one.path)
            self.listed(f"added[{i}].rapid", one.rapid)
            if path.parent not in beside or path in own or path.name in ("..", "."):
                raise complain(f"added[{i}].path: {quoted(one.path)} is no new file in a folder of the program")
            if Path(one.rapid).name != path.name:
                raise complain(f"added[{i}].rapid: {quoted(one.rapid)} is no file called {path.name}")
        return self


class MotionRow(Section):
    """A motion in summary.json, as far as it is read back; times in s from the start. until: the condition that ends a
    wait, None for none."""

    index: int
    source: str = ""
    instruction: str
    target: str
    until: str | None = None
    start_s: float
    time_s: float
    dropped: bool
    axes_at_end: list[float]


class PointRow(Section):
    """An additional point in summary.json: its name in the RAPID text, all axes there, the radius of its zone [m] or
    None for a stop, and when it is passed [s]."""

    target: str
    axes: list[float]
    radius_m: float | None
    time_s: float
    binding: str


class DetourRow(Section):
    """A way around in summary.json. motion: index of the one that its points are before."""

    motion: int
    around: list[str]
    points: list[PointRow]


class PlanSummary(Section):
    """A plan in summary.json, as far as it is read back."""

    motions: list[MotionRow]
    detours: list[DetourRow] = Field(default_factory=list)


class Plans(Section):
    """The plans of both targets."""

    stream: PlanSummary
    rapid: PlanSummary

    def of(self, target: Target) -> PlanSummary:
        """The plan of one of them."""
        return self.stream if target is Target.STREAM else self.rapid


class Summary(Section):
    """summary.json, as far as it is read back. kept: what the RAPID text keeps as programmed, and why."""

    target: Annotated[Target, Field(strict=False)]
    plans: Plans
    kept: list[str] = Field(default_factory=list)


@dataclass(frozen=True)
class RapidModule:
    """A module with the rapid plan in it. path: as the user gave it, or beside the program for a new one. place: in a
    folder of them all. given: the module as it was, None for a new one."""

    path: Path
    place: Path
    content: bytes
    given: bytes | None


@dataclass(frozen=True)
class Results:
    """A results folder read back. modules and cell are the copies of the run's inputs inside it, in their order.

    robot: the copy of the robot's own YAML file, None for a robot that ships. entry, assume_identity, loops: as the
    run was asked for. texts: the three CSV files by name. motions, ways: of each target's plan, and around what it
    goes. holds: when the chosen plan stands still until a signal comes [s], and for what. rapid: the optimised modules;
    none where no_rapid says why. kept: what they keep as programmed, and why. cycle_time: as in PlanOptions.
    """

    folder: Path
    target: Target
    modules: tuple[Path, ...]
    cell: Path
    robot: Path | None
    entry: str
    assume_identity: tuple[str, ...]
    loops: Loops
    texts: Mapping[str, str]
    motions: Mapping[Target, tuple[MotionRow, ...]]
    ways: Mapping[Target, tuple[DetourRow, ...]]
    holds: tuple[tuple[float, str], ...]
    rapid: tuple[RapidModule, ...]
    no_rapid: str | None = None
    kept: tuple[str, ...] = ()
    cycle_time: float | None = None

    def dropped(self, target: Target) -> tuple[int, ...]:
        """The motions that a target's plan leaves out."""
        return tuple(row.index for row in self.motions[target] if row.dropped)

    def detours(self, target: Target) -> tuple[Detour, ...]:
        """The ways around obstacles in a target's plan."""
        return tuple(
            Detour(row.motion, tuple(Via(np.array(one.axes), one.radius_m) for one in row.points), tuple(row.around))
            for row in self.ways[target]
        )

    def passings(self, target: Target, motion: int) -> tuple[Passing, ...]:
        """The additional points of one motion of a target's plan."""
        points = [point for row in self.ways[target] if row.motion == motion for point in row.points]
        return tuple(Passing(point.time_s, np.array(point.axes), point.binding) for point in points)


def distinct_names(paths: Sequence[str]) -> dict[str, str]:
    """A name for each file inside one folder: its own; where two are the same but for case, with the folders that
    tell them apart."""
    names = {path: Path(path).name for path in paths}
    if len({name.lower() for name in names.values()}) == len(names):
        return names
    real = {path: os.path.realpath(path) for path in paths}
    above = os.path.commonpath([os.path.dirname(place) for place in real.values()])
    return {path: Path(place).relative_to(above).as_posix() for path, place in real.items()}


def motion_label(program: Program, index: int) -> tuple[str, str]:
    """The instruction's name and its target (or signal, condition, duration) of one motion, for tables."""
    motion = program.motions[index]
    match motion:
        case Wait(condition=None, duration=0.0, in_position=True):  # WaitRob \\InPos, ActUnit and the like
            return as_written(program, motion)
        case Wait(condition=None):
            return "WaitTime", f"{motion.programmed:g} s{' beside' * (motion.beside is not None)}"
        case Wait():
            name = as_written(program, motion)[0]
            return name, without_name(motion.condition or "", name)
        case SignalEvent():
            return "Signal", f"{motion.signal} = {motion.value:g}"
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
    limits: Iterable[str],
    unchecked: Iterable[str],
    notes: Iterable[str] = (),
    kept: Iterable[str] = (),
) -> bytes:
    """summary.json: the answer in numbers, SI, the same bytes for the same inputs.

    written: the program as it stands, or why it cannot be driven so, or NOT_TIMED. kept_speed: the stretches that
    should keep their programmed speed, by target. corners: of the whole program. passed: at how many fly-bys a plan
    does not stop. limits: how sure they are. unchecked: what the judge was given nothing to hold the motion against.
    notes: what the RAPID text changes, and what it could not; kept: those of the latter.
    """
    return as_json(
        {
            "target": target.value,
            "plans": {one.value: _plan(program, plant, judged[one], kept_speed[one]) for one in Target},
            "as_written": _as_written(written),
            "fly_bys_passed": {one.value: passed[one] for one in Target},
            "fly_bys_stopped": [
                {"index": index, "source": str(program.motions[index].source), "why": why}
                for index, why in corners.stopped.items()
            ],
            "warnings": list(warnings),
            "limits": list(limits),
            "unchecked": list(unchecked),
            "notes": list(notes),
            "kept": list(kept),
        }
    )


def _as_written(written: Plan | str) -> dict[str, Any]:
    if isinstance(written, str):
        return {"cycle_time_s": None, "motion_times_s": [], "why_not": written}
    times = [motion.t_1 - motion.t_0 for motion in written.motions]
    return {"cycle_time_s": written.duration, "motion_times_s": times, "why_not": None}


def _plan(program: Program, plant: Plant, judged: Judged, stretches: Sequence[Stretch]) -> dict[str, Any]:
    plan = judged.plan
    motions = []
    for motion in plan.motions:
        instruction, target = motion_label(program, motion.index)
        motions.append(
            {
                "index": motion.index,
                "source": str(motion.source),
                "instruction": instruction,
                "target": target,
                "until": getattr(program.motions[motion.index], "condition", None),
                "start_s": motion.t_0,
                "time_s": motion.t_1 - motion.t_0,
                "binding": motion.binding,
                "dropped": motion.dropped,
                "axes_at_end": motion.q_1.tolist(),
            }
        )
    return {
        "cycle_time_s": plan.duration,
        "lower_bound_s": plan.lower_bound,
        "gap": plan.gap,
        "least_effort": None if plan.eased is None else _eased(plan.eased),
        "grid": plan.grid,
        "axes": list(plan.trajectory.names),
        "motions": motions,
        "detours": _detours(program, plant, plan),
        "constant_speed": [stretch_record(program, one) for one in stretches],
        "judge": {
            "legal": judged.report.legal,
            "findings": [finding_record(finding) for finding in judged.report.findings],
        },
    }


def _detours(program: Program, plant: Plant, plan: Plan) -> list[dict[str, Any]]:
    names = point_names(program, plant, plan.detours)
    via = {motion.index: motion.via for motion in plan.motions}
    return [
        {
            "motion": detour.motion,
            "around": list(detour.around),
            "points": [
                {
                    "target": name,
                    "axes": point.q.tolist(),
                    "radius_m": point.radius,
                    "time_s": passing.t,
                    "binding": passing.binding,
                }
                for name, point, passing in zip(called, detour.points, via[detour.motion], strict=True)
            ],
        }
        for detour, called in zip(plan.detours, names, strict=True)
    ]


def _eased(eased: Eased) -> dict[str, Any]:
    strains = (("fastest", eased.fastest), ("planned", eased.planned))
    told = {name: {"effort_s": one.effort, "rail_way_m": one.rail_way} for name, one in strains}
    return {"least_time_s": eased.least_time, **told}


def read_results(folder: Path, judged: bool = False) -> Results:
    """Read a results folder; judged: its CSV files as they stand, for who decides whether they are legal.

    Raises InputError for a folder that is none or is newer, or where any other file was changed since the run.
    """
    plans = (CHOSEN, *CSV.values())
    run = read_run(folder, PlanRecord, (SUMMARY, *plans), plans if judged else ())
    inputs, options, digest = run.record.inputs, run.record.options, run.summary(Summary)
    return Results(
        folder=folder,
        target=digest.target,
        modules=tuple(folder / one.place for one in inputs.files if one.module),
        cell=folder / str(inputs.cell),
        robot=None if inputs.robot is None else folder / inputs.robot,
        entry=options.entry,
        assume_identity=tuple(options.assume_identity),
        loops=options.loops,
        cycle_time=options.cycle_time,
        texts={name: run.text(name) for name in plans},
        motions={one: tuple(digest.plans.of(one).motions) for one in Target},
        ways={one: tuple(digest.plans.of(one).detours) for one in Target},
        holds=tuple(
            (row.start_s + row.time_s, until)
            for row in digest.plans.of(digest.target).motions
            if (until := row.target if row.instruction == "Wait" else row.until) is not None  # Wait: older runs
        ),
        rapid=tuple(_rapid(run)),
        no_rapid=run.record.no_rapid,
        kept=tuple(digest.kept),
    )


def _rapid(run: ResultsFolder[PlanRecord]) -> Iterator[RapidModule]:
    """The optimised modules: each without the folder program/; program.mod alone is called as the user calls it."""
    given = [(one.path, one.rapid, run.contents[one.place]) for one in run.record.inputs.files if one.rapid is not None]
    for path, place, before in (*given, *((one.path, one.rapid, None) for one in run.record.added)):
        inner = Path(place).parts[1:]
        yield RapidModule(Path(path), Path(*inner) if inner else Path(Path(path).name), run.contents[place], before)


def write_in_place(modules: Sequence[RapidModule]) -> dict[Path, Path]:
    """Write the optimised modules over the user's own; where each old one is kept, by its path.

    Raises InputError, with every file as it was, where one is not what the results were made from, a new module's name
    is taken, or a place cannot be written.
    """
    for one in modules:
        if one.path.suffix.lower() not in MODULES:  # whoever made the folder chose these paths
            known = ", ".join(MODULES)
            message = f"is no RAPID module by its name ({known}), and is not written over; give --output"
            raise InputError(message, file=str(one.path))
        if one.given is None:
            if os.path.lexists(one.path):
                raise InputError("is a new module of the plan, and the name is taken; move it away", file=str(one.path))
        elif read_bytes(one.path) != one.given:
            copies = sorted(one.path.parent.glob(f"{escape(one.path.name)}.bak*"))
            kept = [copy.name for copy in copies if copy.is_file() and read_bytes(copy) == one.given]
            where = f" (that is kept as {kept[-1]})" if kept else ""
            message = f"is not the file that the results were made from{where}; run trajopt optimize again"
            raise InputError(message, file=str(one.path))
    wanted = {one.path: (one.given, one.content) for one in modules if one.given is not None}
    return replace_files(wanted, {one.path: one.content for one in modules if one.given is None})
