"""The study file: which programs on which cell, what varies and how, what is asked of each point."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, StrictStr, model_validator
from pydantic_core import PydanticCustomError

from trajopt_cli.cell.model import Cell
from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.job import MAIN, Job, cell_path_for, read_job
from trajopt_cli.parameter_study.cell_keys import TARGET, Data, in_si, is_offset, leaves, units_at, value_at
from trajopt_cli.parameter_study.offsets import check_offset, placed, shifted, target_names
from trajopt_cli.parameter_study.point import FIRST_LEGAL, FULL, Column, PointInputs, cell_at, column_name, worked_out
from trajopt_cli.parameter_study.sampling import GRID, METHODS, Design, Factor, normal
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.quantity import RATIO, TIME, complain, number, positive
from trajopt_cli.validation import hint
from trajopt_cli.yaml_file import line_of, parse, read_text, validated

_BYTES = {"GB": 1e9, "MB": 1e6, "B": 1.0}
_SHARE = {"%": 0.01, "": 1.0}


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class NormalSection(_Section):
    """Gauss' distribution: mean, by default what the cell has, and standard deviation, in the key's units."""

    mean: Any = None
    sigma: Any


class LevelsSection(_Section):
    """What a key takes: one of list, range (with count), uniform, normal and scale."""

    values: tuple[Any, ...] | None = Field(None, alias="list", min_length=1)
    ends: tuple[Any, Any] | None = Field(None, alias="range")
    count: Annotated[int, Field(strict=True, ge=2)] | None = None
    uniform: tuple[Any, Any] | None = None
    normal: NormalSection | None = None
    scale: Annotated[float, BeforeValidator(positive(_SHARE))] | None = None

    @model_validator(mode="after")
    def _one(self) -> LevelsSection:
        given = {"list": self.values, "range": self.ends, "uniform": self.uniform, "normal": self.normal}
        named = [name for name, value in {**given, "scale": self.scale}.items() if value is not None]
        if len(named) != 1:
            raise complain(f"has {' and '.join(named) or 'no levels'}; give one of list, range, uniform, normal, scale")
        if (self.ends is None) != (self.count is None):
            raise complain("range and count go together: {range: [1, 2], count: 5}")
        return self


class SamplingSection(_Section):
    """How many points are sampled, by one of the methods, and the seed of their numbers."""

    latin_hypercube: Annotated[int, Field(strict=True, ge=1)] | None = None
    sobol: Annotated[int, Field(strict=True, ge=1)] | None = None
    random: Annotated[int, Field(strict=True, ge=1)] | None = None
    seed: Annotated[int, Field(strict=True, ge=0)] = 0

    @model_validator(mode="after")
    def _one(self) -> SamplingSection:
        if sum(getattr(self, name) is not None for name in METHODS) != 1:
            raise complain(f"needs one of {', '.join(METHODS)} with its count of points")
        return self

    @property
    def chosen(self) -> tuple[str, int, int]:
        """Method, count and seed."""
        return next((name, count, self.seed) for name in METHODS if (count := getattr(self, name)) is not None)


class BoundsSection(_Section):
    """What one point may take: processor time [s], memory of its process [bytes]."""

    time: Annotated[float, BeforeValidator(positive(TIME))] | None = None
    memory: Annotated[float, BeforeValidator(positive(_BYTES))] | None = None


def _several(value: Any) -> Any:
    return [value] if isinstance(value, str) else value


def _effort(value: Any) -> Any:
    if value in (FIRST_LEGAL, FULL):
        return value
    if isinstance(value, dict) and [*value] == ["time_limit"]:
        return positive(TIME)(value["time_limit"])
    raise complain(f"needs {FIRST_LEGAL}, {FULL} or a time, {{time_limit: 20 s}}")


Levels = Annotated[LevelsSection, BeforeValidator(lambda value: {"list": value} if isinstance(value, list) else value)]
Modules = Annotated[tuple[StrictStr, ...], BeforeValidator(_several), Field(min_length=1)]


class StudyDocument(_Section):
    """The whole file. programs: each one file, or a list of the files of one program; paths from this file on."""

    programs: Annotated[tuple[Modules, ...], BeforeValidator(_several), Field(min_length=1)]
    cell: StrictStr | None = None
    entry: StrictStr = MAIN
    vary: Annotated[dict[StrictStr, Levels], Field(min_length=1)]
    sampling: Annotated[SamplingSection | None, BeforeValidator(lambda value: None if value == GRID else value)] = None
    answers: Annotated[
        tuple[Literal["rapid", "stream", "as_written", "fixed_rail", "bound", "sensitivity"], ...], Field(min_length=1)
    ] = ("as_written", "rapid")
    effort: Annotated[str | float, BeforeValidator(_effort)] = FIRST_LEGAL
    price: StrictStr | None = None
    limits: BoundsSection = BoundsSection()


@dataclass(frozen=True, eq=False)
class Study:
    """A study, read and checked. text: of its file. files: every other input by its path from the study file."""

    path: Path
    text: str
    inputs: PointInputs
    design: Design
    files: Mapping[str, bytes]


def read_study(path: Path) -> Study:
    """Read a study file, its programs and its cell, and check every level against them.

    Raises InputError, with file, line and key of every mistake that was found.
    """
    text = read_text(path, "study file")
    content, lines = parse(text, str(path), "at least programs and vary are needed")
    document = validated(StudyDocument, content, lines, str(path), _WANTED)
    return _Reading(path, text, document, lines).study()


_WANTED = {
    "programs": "name the programs, 'programs: [cell.mod]'",
    "vary": "say what varies: 'vary: {limits.rail.velocity: [1, 1.5, 2]}'",
    "sigma": "give the standard deviation",
}
_TIMES = {
    "as_written_s": "cycle time of the program as it stands",
    "rapid_s": "cycle time of the plan for the RAPID controller, no more than as written",
    "stream_s": "cycle time of the plan for a joint stream, no more than the RAPID plan's",
    "fixed_rail_s": "cycle time of a joint stream with one rail position for each station, the rail still there",
    "rapid_bound_s": "no RAPID plan of this model is faster",
    "stream_bound_s": "no stream of this model is faster",
    "saved_s": "as_written_s less rapid_s",
}


@dataclass(frozen=True, eq=False)
class _Reading:
    """A study file on its way to a study."""

    path: Path
    text: str
    document: StudyDocument
    lines: Mapping[str, int]

    def study(self) -> Study:
        """The study. Raises InputError."""
        document, beside = self.document, self.path.parent
        paths = [tuple(beside / one for one in modules) for modules in document.programs]
        names = [" ".join(modules) for modules in document.programs]
        if len({*names}) < len(names):
            raise self._error("programs", "names a program twice; keep one")
        cell_path = beside / document.cell if document.cell is not None else cell_path_for(paths[0])
        jobs = [read_job(each, cell_path, document.entry) for each in paths]
        cell, cell_lines = parse(read_text(cell_path, "cell file"), str(cell_path), "")
        factors = self._factors(jobs, cell)
        sampling = document.sampling
        if sampling is None and (unlevelled := [one.written for one in factors if one.quantile is not None]):
            said = "has no levels for a grid; add 'sampling: {latin_hypercube: 100, seed: 1}'"
            raise self._error(f"vary.{unlevelled[0]}", said)
        design = Design(factors, len(jobs), *(sampling.chosen if sampling else ()))
        inputs = PointInputs(
            programs={
                name: tuple(replace(file, path=self._relative(file.path)) for file in job.program.files.values())
                for name, job in zip(names, jobs, strict=True)
            },
            entry=document.entry,
            cell=cell,
            lines=cell_lines,
            cell_file=str(cell_path),
            beside={},
            keys=tuple(key for factor in factors for key in factor.keys),
            answers=document.answers,
            effort=document.effort,
            seconds=document.limits.time,
            memory=document.limits.memory,
            price=document.price,
            columns=tuple(self._columns(factors)),
        )
        used = {file for job in jobs for file in _files_of(job.cell, job.plant)}
        used |= self._checked(inputs, design, jobs)
        base = Path(os.path.commonpath([cell_path.parent.resolve(), *(file.resolve().parent for file in used)]))
        kept = {str(file.resolve().relative_to(base)): file.read_bytes() for file in sorted(used)}
        inputs = replace(inputs, cell_file=str(cell_path.resolve().relative_to(base)), beside=kept)
        read = [Path(name) for job in jobs for name in job.program.files]
        files = {self._relative(file): file.read_bytes() for file in (*read, cell_path, *sorted(used))}
        return Study(self.path, self.text, inputs, design, files)

    # ------------------------------------------------------------------------------------------------- what varies

    def _factors(self, jobs: Sequence[Job], cell: Data) -> tuple[Factor, ...]:
        """What varies, keys with * written out."""
        out, known = list[Factor](), set[str]()
        for written, section in self.document.vary.items():
            keys = tuple(key.strip() for key in written.split(","))
            try:
                for one in [keys] if len(keys) > 1 else [(key,) for key in _meant(written, jobs)]:
                    if again := known.intersection(one):
                        raise complain(f"{min(again)} varies already; keep one")
                    known.update(one)
                    out.append(_factor(written, one, section, jobs[0], cell))
            except PydanticCustomError as error:
                raise self._error(f"vary.{written}", error.message()) from error
        return tuple(out)

    def _columns(self, factors: Sequence[Factor]) -> Iterator[Column]:
        yield Column("point", "int64", "", "number of the point, from 0")
        yield Column("program", "string", "", "program, as the study file names it")
        varied = dict[str, Column]()
        for factor in factors:
            for levels in factor.levels or [(0.0,)]:
                for key, level in zip(factor.keys, levels, strict=True):
                    where = "offset" if is_offset(key) else "cell file"
                    for name, unit, value in leaves(key, level):
                        full = column_name(name, unit)
                        numeric = isinstance(value, int | float) and not isinstance(value, bool)
                        kind = (
                            "double" if numeric and (full not in varied or varied[full].kind == "double") else "string"
                        )
                        varied[full] = Column(full, kind, unit, f"{where}: {name}")
        yield from varied.values()
        yield from (Column(name, "double", "s", meaning) for name, meaning in _TIMES.items())
        if self.document.price is not None:
            yield Column("price", "double", "", self.document.price)
        if "sensitivity" in self.document.answers:
            yield Column("change_first", "string", "", "the limit, speed, wait or place that saves most by its step")
            yield Column("change_first_saves_s", "double", "s", "what that saves")
        yield Column("status", "string", "", "ok, infeasible, failed, time or memory")
        yield Column("reason", "string", "", "why an answer is missing; empty for none")

    # ------------------------------------------------------------------------------------------------ what is checked

    def _checked(self, inputs: PointInputs, design: Design, jobs: Sequence[Job]) -> set[Path]:
        """Check every level by itself; the files of robots and meshes that they name. Raises InputError."""
        used, errors = set[Path](), list[InputError]()
        for i, factor in enumerate(design.factors):
            for j, values in enumerate(factor.levels or design.extremes(i)):
                at = dict(zip(factor.keys, values, strict=True))
                offsets = {key: value for key, value in at.items() if is_offset(key)}
                try:
                    cell = cell_at(inputs, at)
                    plant = build_plant(cell)
                    used |= {*_files_of(cell, plant)}
                    for job in jobs if offsets else ():
                        shifted([*job.program.files.values()], offsets)
                        placed(job, offsets)
                except InputError as error:
                    first = error.errors[0] if isinstance(error, InputErrorGroup) else error
                    where = f"vary.{factor.written}{f'.list.{j}' if factor.levels else ''}"
                    said = first.message.removeprefix(f"{factor.keys[0]}: ")
                    errors.append(self._error(where, said.replace("--what ", "").replace("--range ", "")))
        if self.document.price is not None:
            try:
                worked_out(self.document.price, inputs, design.point(0))
            except InputError as error:
                errors.append(self._error("price", error.message))
        if errors:
            raise errors[0] if len(errors) == 1 else InputErrorGroup(errors)
        return used

    def _error(self, key: str, message: str) -> InputError:
        bare = key.replace(".list.", ".") if key not in self.lines else key
        return InputError(f"{key}: {message}", file=str(self.path), line=line_of(bare, self.lines))

    def _relative(self, path: str | Path) -> str:
        return Path(os.path.relpath(path, self.path.parent)).as_posix()


def _meant(written: str, jobs: Sequence[Job]) -> list[str]:
    """The keys that one with * stands for: of limits by axis, of targets by name and x, y, z."""
    parts = written.split(".")
    if is_offset(written):
        check_offset(written)
    if "*" not in written:
        return [written]
    if parts[0] == TARGET:
        names = dict.fromkeys(name for job in jobs for name in target_names([*job.program.files.values()]))
    else:
        names = dict.fromkeys(jobs[0].plant.limits.names if parts[0] == "limits" and len(parts) == 3 else ())
    axes = "xyz" if parts[-1] == "*" else [parts[-1]]
    found = [name for name in names if fnmatchcase(name.lower(), parts[1].lower())]
    if not found:
        raise complain(f"* stands for nothing here; {hint(parts[1], [*names])}")
    return [".".join((parts[0], name, axis)) for name in found for axis in axes]


def _factor(written: str, keys: tuple[str, ...], section: LevelsSection, job: Job, cell: Data) -> Factor:
    """What keys take, from what the study file says."""
    key = keys[0]
    units = units_at(key)
    read = number(units or RATIO)
    if section.values is not None:
        several = len(keys) > 1
        if several and any(not isinstance(one, list) or len(one) != len(keys) for one in section.values):
            raise complain(f"needs lists of {len(keys)} values, one for each key")
        rows = section.values if several else [[one] for one in section.values]
        return Factor(written, keys, tuple(tuple(map(_level, keys, row)) for row in rows))
    if len(keys) > 1:
        raise complain("several keys vary together by a list alone")
    if section.ends is not None:
        low, high = map(read, section.ends)
        steps = np.linspace(low, high, section.count or 2).round(12)  # a zero is one
        return Factor(written, keys, tuple((float(f"{value:.9g}"),) for value in steps))
    if section.normal is not None:
        mean = _in_force(key, job, cell) if section.normal.mean is None else read(section.normal.mean)
        return Factor(written, keys, quantile=normal(mean, positive(units or RATIO)(section.normal.sigma)))
    if section.uniform is not None:
        low, high = map(read, section.uniform)
    else:
        now, part = _in_force(key, job, cell), section.scale or 0.0
        low, high = now * (1 - part), now * (1 + part)
    return Factor(written, keys, quantile=lambda share: low + share * (high - low))


def _in_force(key: str, job: Job, cell: Data) -> float:
    """What a key's number is now: in the cell file, of a limit the robot's where that gives none."""
    if is_offset(key):
        return 0.0
    known, limits = value_at(cell, key), job.plant.limits
    section, axis, kind = [*key.split("."), "", ""][:3]
    if section == "limits" and axis in limits.names and key.count(".") == 2:
        if kind == "acceleration" and limits.table is not None and axis in limits.table.axes:
            raise complain(f"{axis} has accelerations by posture; vary acceleration_factor instead")
        of_axes = getattr(limits, kind, None)
        known = None if of_axes is None else of_axes[limits.names.index(axis)]
        known = 1.0 if kind == "acceleration_factor" else known
    if isinstance(known, bool) or not isinstance(known, int | float):
        raise complain("has no number now to start from; give {uniform: [a, b]} or a mean")
    return float(known)


def _level(key: str, value: Any) -> Any:
    """A level of a list with its numbers in SI; of an offset a number."""
    return number(units_at(key))(value) if is_offset(key) else in_si(value, units_at(key))


def _files_of(cell: Cell, plant: Plant) -> tuple[Path, ...]:
    """The files of a cell's own robot and meshes."""
    return (*cell.robot_files(plant.robot.files), *cell.mesh_files)
