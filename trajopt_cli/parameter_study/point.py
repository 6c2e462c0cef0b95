"""One point of a study: from its inputs to a row, the same wherever and however often it is worked out."""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from trajopt_cli.cell.loader import cell_of
from trajopt_cli.cell.model import Cell
from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.job import Job, job_on
from trajopt_cli.motion import TextFile
from trajopt_cli.parameter_study.cell_keys import Data, is_offset, leaves, put, value_at
from trajopt_cli.parameter_study.guard import Guard, OutOfMemory, OutOfTime
from trajopt_cli.parameter_study.offsets import placed, shifted
from trajopt_cli.parameter_study.price import price
from trajopt_cli.parameter_study.sampling import Point
from trajopt_cli.pipeline.planning import Clock, as_written, may_change
from trajopt_cli.plan import NoCleanPlan, PlanCache, bounded, lower_bound_of
from trajopt_cli.problem.decision_scope import EVERYTHING, FIXED_RAIL
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.runs.files import write_file
from trajopt_cli.study.answers import plan_of, why_illegal
from trajopt_cli.study.sensitivity import WORTH, asked

Row = dict[str, Any]
"""A point's answer by column; None for what there is none of."""

FIRST_LEGAL, FULL = "first_legal", "full"
ANSWERS = ("as_written", "rapid", "stream", "fixed_rail")
"""What a point may be asked for that has a cycle time, in the order it is worked out."""
OPTIMA = ("rapid", "stream")
"""Those of them that everything may change for, and that decide whether a point can be done."""
_MB = 1e6
_ROOTS: dict[str, TemporaryDirectory[str]] = {}  # where this process keeps the files of studies, by digest


@dataclass(frozen=True)
class Column:
    """A column of the results: kind is int64, double or string; unit is empty for none."""

    name: str
    kind: str
    unit: str
    meaning: str


@dataclass(frozen=True, eq=False)
class PointInputs:
    """All that rows follow from, besides the point.

    programs: by name, their texts. cell, lines: as yaml_file.parse gives them. cell_file, beside: where the cell file
    and the robots' and meshes' files are in one folder. keys: what varies, in the order of a point's values. effort:
    FIRST_LEGAL, FULL or a time limit [s]. seconds, memory: of one point, None for no bound [s, bytes].
    """

    programs: Mapping[str, tuple[TextFile, ...]]
    entry: str
    cell: Data
    lines: Mapping[str, int]
    cell_file: str
    beside: Mapping[str, bytes]
    keys: tuple[str, ...]
    answers: tuple[str, ...]
    effort: str | float
    seconds: float | None
    memory: float | None
    price: str | None
    columns: tuple[Column, ...]

    @cached_property
    def digest(self) -> str:
        """A name for these inputs."""
        return sha256(pickle.dumps([getattr(self, name) for name in self.__dataclass_fields__])).hexdigest()


def column_name(name: str, unit: str) -> str:
    """A column's name with its unit: limits.rail.velocity_m_per_s."""
    return f"{name}_{unit.replace('/', '_per_')}" if unit else name


def job_at(inputs: PointInputs, point: Point) -> Job:
    """A point's program on its cell. Raises InputError where they cannot be read or planned so."""
    program, files = [*inputs.programs.items()][point.program]
    values = dict(zip(inputs.keys, point.values, strict=True))
    offsets = {key: value for key, value in values.items() if is_offset(key)}
    cell, path = cell_at(inputs, values), Path(program)
    return placed(job_on(cell, (path,), Path(cell.file), inputs.entry, files=shifted(files, offsets)), offsets)


def cell_at(inputs: PointInputs, values: Mapping[str, Any]) -> Cell:
    """The cell with values at keys. Raises InputError where it is none."""
    return cell_of(cell_data(inputs, values), inputs.lines, str(_root(inputs) / inputs.cell_file))


def cell_data(inputs: PointInputs, values: Mapping[str, Any]) -> Data:
    """The cell file's content with values at keys."""
    data = deepcopy(inputs.cell)
    for key, value in values.items():
        if not is_offset(key):
            put(data, key, deepcopy(value))
    return data


def _root(inputs: PointInputs) -> Path:
    """A folder of this process with the files beside the cell; the current one where there are none."""
    if not inputs.beside:
        return Path()
    if inputs.digest not in _ROOTS:
        root = TemporaryDirectory(prefix="trajopt-study-")
        for name, content in inputs.beside.items():
            write_file(Path(root.name, name), content)
        _ROOTS[inputs.digest] = root
    return Path(_ROOTS[inputs.digest].name)


def blank(inputs: PointInputs, point: Point, status: str, reason: str) -> Row:
    """The row of a point without an answer, and why."""
    row: Row = dict.fromkeys(column.name for column in inputs.columns)
    row |= {"point": point.index, "program": [*inputs.programs][point.program], "status": status, "reason": reason}
    texts = {column.name for column in inputs.columns if column.kind == "string"}
    for key, value in zip(inputs.keys, point.values, strict=True):
        for name, unit, single in leaves(key, value):
            name = column_name(name, unit)
            row[name] = _text(single) if name in texts else float(single)
    return row


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def evaluate(inputs: PointInputs, point: Point) -> Row:
    """The row of a point: what it is asked for, or why there is no answer. An error in trajopt is raised."""
    row, guard = blank(inputs, point, "ok", ""), Guard(inputs.seconds, inputs.memory)
    try:
        with guard:
            row |= _answered(inputs, point)
    except InputError as error:
        status = "infeasible" if error.kind is ErrorKind.UNPLANNABLE else "failed"
        row = blank(inputs, point, status, str(error))
    except OutOfTime:
        row = blank(inputs, point, "time", f"took more than {inputs.seconds:g} s of processor time")
    except (OutOfMemory, MemoryError):
        bound = "all there is" if inputs.memory is None else f"more than {inputs.memory / _MB:.0f} MB"
        row = blank(inputs, point, "memory", f"took {bound} of memory")
    finally:
        guard.end()
    return {**row, "reason": without_root(inputs, row["reason"])}


def without_root(inputs: PointInputs, said: str) -> str:
    """A message without the folder of this process in its paths."""
    return said.replace(f"{_root(inputs)}/", "") if inputs.beside else said


def worked_out(text: str, inputs: PointInputs, point: Point, row: Mapping[str, Any] | None = None) -> float:
    """The value of an expression, as the price, at a point. row: its answers, where they may be named, too. Raises
    InputError."""
    values = dict(zip(inputs.keys, point.values, strict=True))
    data, known = cell_data(inputs, values), {**values, **(row or {})}
    return price(text, lambda key: value_at(data, key) if known.get(key) is None else known[key])


def _answered(inputs: PointInputs, point: Point) -> Row:
    """The columns of a point's answer."""
    row: Row = {} if inputs.price is None else {"price": worked_out(inputs.price, inputs, point)}
    job = job_at(inputs, point)
    agreed = may_change(job, Loops.KEEP)
    if agreed.infeasible is not None:
        return {**row, "status": "infeasible", "reason": str(agreed.infeasible)}
    wanted = [name for name in ANSWERS if name in inputs.answers]
    planner = _Planner(job, agreed.changes, inputs.effort, len(wanted))
    found = {name: planner.plan(name) for name in wanted}
    plans = {name: one for name, one in found.items() if isinstance(one, Plan)}
    seconds = {name: plan.duration for name, plan in plans.items()}
    for name, below in (("rapid", "as_written"), ("stream", "rapid")):  # what may change less it may have, too
        if name in seconds and below in seconds:
            seconds[name] = min(seconds[name], seconds[below])
    row |= {f"{name}_s": value for name, value in seconds.items()}
    if "rapid" in seconds and "as_written" in seconds:
        row["saved_s"] = seconds["as_written"] - seconds["rapid"]
    main = [name for name in wanted if name in OPTIMA] or wanted
    if "bound" in inputs.answers:
        row |= {f"{name}_bound_s": planner.bound(plans[name], seconds[name]) for name in OPTIMA if name in plans}
    whys = [f"{name}: {one}" for name, one in found.items() if not isinstance(one, Plan)]
    if "sensitivity" in inputs.answers and main[0] in plans:
        change, saves, why = planner.change_first(plans[main[0]])
        row |= {"change_first": change, "change_first_saves_s": saves}
        whys += [f"sensitivity: {why}"] if why else []
    lacking = [found[name] for name in main if name not in plans]
    status = "ok" if not lacking else "infeasible" if isinstance(lacking[0], Infeasible) else "failed"
    return {**row, "status": status, "reason": "; ".join(whys)}


@dataclass(frozen=True, eq=False)
class _Planner:
    """Plans of one job. count: how many are asked, which share a time limit."""

    job: Job
    changes: Mapping[Target, Changes]
    effort: str | float
    count: int
    memory: PlanCache = field(default_factory=PlanCache)

    def plan(self, name: str) -> Plan | Infeasible | str:
        """The plan of an answer; a text says why there is none."""
        if name == "as_written":
            return as_written(self.job, self.changes[Target.RAPID], Clock(), self.memory)
        target = Target.RAPID if name == "rapid" else Target.STREAM
        freedom, memory = (FIXED_RAIL, None) if name == "fixed_rail" else (EVERYTHING, self.memory)
        patience = None if self.effort == FIRST_LEGAL else self._patience()
        try:
            with (patience or Patience()).cutting():
                plan = plan_of(self.job, target, self.changes[target], patience, freedom, memory)
        except (NoCleanPlan, Stopped) as no:
            return str(no) or "stopped by the time limit"
        if isinstance(plan, Plan) and (illegal := why_illegal(self.job.plant, self.job.program, plan, target)):
            return illegal[0]
        return plan

    def _patience(self) -> Patience:
        """Of one plan."""
        return Patience(self.effort / self.count if isinstance(self.effort, float) else None)

    def bound(self, plan: Plan, seconds: float) -> float | None:
        """The lower bound of a plan that takes so long [s]; None where an error in trajopt refutes it."""
        with self._patience().cutting():
            bound = lower_bound_of(self.job.program, self.job.plant, plan, changes=self.changes[plan.target])
        known = bounded(plan, bound, 0.0).lower_bound
        return None if known is None else min(known, seconds)

    def change_first(self, plan: Plan) -> tuple[str | None, float | None, str]:
        """What to change first in the cell, what that saves [s], and why nobody knows."""
        limits, target = self.job.plant.limits, plan.target
        if limits.binding_jerk is not None or limits.binding_torque is not None:
            return None, None, "does not know what jerk and torque limits cost"
        answer = asked(self.job, self.changes, {target: plan}, lambda *_: None, 1, False, Patience())
        rows = answer.rows[target]
        if isinstance(rows, str):
            return None, None, rows
        best = rows[0] if rows and rows[0].best > WORTH else None
        return ("nothing", 0.0, "") if best is None else (f"{best.lever.name}, {best.lever.step}", best.best, "")
