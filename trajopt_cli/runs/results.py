"""The results folder of `trajopt optimize`: what is in it, how it is read back, and put over the user's own files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from glob import escape
from pathlib import Path
from typing import Annotated, ClassVar

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import FARTHEST
from trajopt_cli.problem.detours import Detour, Via
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Passing, Target
from trajopt_cli.quantity import complain
from trajopt_cli.runs import SUMMARY
from trajopt_cli.runs.folder import PLAN, ResultsFolder, read_bytes, read_run
from trajopt_cli.runs.record import RunRecord, Section, quoted
from trajopt_cli.runs.summary import Summary
from trajopt_cli.runs.transaction import replace_files

CHOSEN = "trajectory.csv"
CSV = {Target.STREAM: "stream.csv", Target.RAPID: "rapid.csv"}
MODULES = (".mod", ".prg", ".sys", ".modx", ".sysx")


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


class PlanRecord(RunRecord[PlanOptions]):
    """run.json of trajopt optimize. no_rapid: why the plan could not be written as RAPID. added: modules that exports
    of old versions added, which none does any more. seconds: per phase."""

    KIND: ClassVar[str] = PLAN
    LIBRARIES: ClassVar[tuple[str, ...]] = ("casadi", "numpy", "pin", "ruckig", "scipy", "toppra")
    REMEDY: ClassVar[str] = "run trajopt optimize again"

    options: PlanOptions = PlanOptions()
    no_rapid: str | None = None
    added: Annotated[list[str], Field(max_length=0)] = Field(default_factory=list)
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


@dataclass(frozen=True)
class RapidModule:
    """A module with the rapid plan in it. path: as the user gave it. place: in a folder of them all. given: the module
    as it was."""

    path: Path
    place: Path
    content: bytes
    given: bytes


@dataclass(frozen=True)
class Results:
    """A results folder read back. modules and cell are the copies of the run's inputs inside it, in their order.

    robot: the copy of the robot's own YAML file, None for a robot that ships. entry, assume_identity, loops: as the
    run was asked for. texts: the three CSV files by name. rapid: the optimised modules; none where no_rapid says why.
    cycle_time: as in PlanOptions.
    """

    folder: Path
    modules: tuple[Path, ...]
    cell: Path
    robot: Path | None
    entry: str
    assume_identity: tuple[str, ...]
    loops: Loops
    texts: Mapping[str, str]
    summary: Summary
    rapid: tuple[RapidModule, ...]
    no_rapid: str | None = None
    cycle_time: float | None = None

    @property
    def target(self) -> Target:
        """Whose plan was chosen."""
        return self.summary.target

    @property
    def holds(self) -> tuple[tuple[float, str], ...]:
        """When the chosen plan stands still until a signal comes [s], and for what."""
        return tuple(
            (row.start_s + row.time_s, until)
            for row in self.summary.plans.of(self.target).motions
            if (until := row.target if row.instruction == "Wait" else row.until) is not None  # Wait: older runs
        )

    def dropped(self, target: Target) -> tuple[int, ...]:
        """The motions that a target's plan leaves out."""
        return tuple(row.index for row in self.summary.plans.of(target).motions if row.dropped)

    def detours(self, target: Target) -> tuple[Detour, ...]:
        """The ways around obstacles in a target's plan."""
        return tuple(
            Detour(row.motion, tuple(Via(np.array(one.axes), one.radius_m) for one in row.points), tuple(row.around))
            for row in self.summary.plans.of(target).detours
        )

    def passings(self, target: Target, motion: int) -> tuple[Passing, ...]:
        """The additional points of one motion of a target's plan."""
        points = [
            point for row in self.summary.plans.of(target).detours if row.motion == motion for point in row.points
        ]
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


def read_results(folder: Path, judged: bool = False) -> Results:
    """Read a results folder; judged: its CSV files as they stand, for who decides whether they are legal.

    Raises InputError for a folder that is none or is newer, or where any other file was changed since the run.
    """
    plans = (CHOSEN, *CSV.values())
    run = read_run(folder, PlanRecord, (SUMMARY, *plans), plans if judged else ())
    inputs, options = run.record.inputs, run.record.options
    return Results(
        folder=folder,
        modules=tuple(folder / one.place for one in inputs.files if one.module),
        cell=folder / str(inputs.cell),
        robot=None if inputs.robot is None else folder / inputs.robot,
        entry=options.entry,
        assume_identity=tuple(options.assume_identity),
        loops=options.loops,
        cycle_time=options.cycle_time,
        texts={name: run.text(name) for name in plans},
        summary=run.summary(Summary),
        rapid=tuple(_rapid(run)),
        no_rapid=run.record.no_rapid,
    )


def _rapid(run: ResultsFolder[PlanRecord]) -> Iterator[RapidModule]:
    """The optimised modules: each without the folder program/; program.mod alone is called as the user calls it."""
    for one in run.record.inputs.files:
        if one.rapid is not None:
            path, inner = Path(one.path), Path(one.rapid).parts[1:]
            place = Path(*inner) if inner else Path(path.name)
            yield RapidModule(path, place, run.contents[one.rapid], run.contents[one.place])


def beside_results(modules: Sequence[RapidModule], folder: Path) -> tuple[RapidModule, ...]:
    """The modules where they lie: paths that are not found from here are looked for above the results folder, which
    was made from there."""
    given = [one.path for one in modules if not one.path.is_absolute()]
    if any(path.exists() for path in given):
        return tuple(modules)
    above = next(
        (up for up in folder.resolve().parents[:2] if given and all((up / path).exists() for path in given)), None
    )
    if above is None:
        return tuple(modules)
    return tuple(replace(one, path=Path(os.path.relpath(above / one.path))) for one in modules)


def write_in_place(modules: Sequence[RapidModule]) -> dict[Path, Path]:
    """Write the optimised modules over the user's own; where each old one is kept, by its path.

    Raises InputError, with every file as it was, where one is not what the results were made from, or a place cannot be
    written.
    """
    for one in modules:
        if one.path.suffix.lower() not in MODULES:  # whoever made the folder chose these paths
            known = ", ".join(MODULES)
            message = f"is no RAPID module by its name ({known}), and is not written over; give --output"
            raise InputError(message, file=str(one.path))
        if read_bytes(one.path) != one.given:
            copies = sorted(one.path.parent.glob(f"{escape(one.path.name)}.bak*"))
            kept = [copy.name for copy in copies if copy.is_file() and read_bytes(copy) == one.given]
            where = f" (that is kept as {kept[-1]})" if kept else ""
            message = f"is not the file that the results were made from{where}; run trajopt optimize again"
            raise InputError(message, file=str(one.path))
    return replace_files({one.path: (one.given, one.content) for one in modules}, {})
