"""Results folders of `trajopt optimize` side by side: cycle times, motions in step, limits, and inputs that differ."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher, unified_diff
from itertools import combinations
from pathlib import Path, PurePath
from typing import Any

from trajopt_cli.errors import InputError, printable
from trajopt_cli.problem.plan import Target
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.runs import SUMMARY
from trajopt_cli.runs.folder import PLAN, TASK, ResultsFolder, kind_of, read_run
from trajopt_cli.runs.record import INPUT
from trajopt_cli.runs.results import PlanRecord
from trajopt_cli.runs.summary import MotionRow, PlanSummary, Summary
from trajopt_cli.yaml_file import parse

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
"""What runs are called, in the order they were given."""
EQUAL = 5e-4  # s: two times this close are printed alike
_LIMITS = ("joint speed", "joint acceleration", "joint jerk", "joint torque", "TCP speed", "TCP acceleration")
_ALIKE = 0.5  # of the motions: two runs with fewer in common are of different programs


@dataclass(frozen=True, eq=False)
class OneRun:
    """A run: its letter, its folder, the target it chose, both plans, the cycle as written [s] where that can be
    driven, and what it was made from."""

    letter: str
    folder: Path
    target: Target
    plans: Mapping[Target, PlanSummary]
    written: float | None
    inputs: RunInputs


@dataclass(frozen=True, eq=False)
class AlignedMotion:
    """A motion as each run has it; None where the run's program does not have it."""

    motions: tuple[MotionRow | None, ...]

    @property
    def any(self) -> MotionRow:
        """As the first run has it that does."""
        return next(one for one in self.motions if one is not None)

    @property
    def times(self) -> tuple[float, ...]:
        """What it takes in each run [s]; nothing where it is missing or dropped."""
        return tuple(0.0 if one is None else one.time_s for one in self.motions)

    @property
    def spread(self) -> float:
        """Longest less shortest [s]."""
        return max(self.times) - min(self.times)

    @property
    def bindings(self) -> tuple[str | None, ...]:
        """What holds it back in each run; None where it is missing or dropped."""
        return tuple(None if one is None or one.dropped else one.binding for one in self.motions)


@dataclass(frozen=True, eq=False)
class ComparedRuns:
    """Runs side by side. target: of the plans whose motions rows has, in the order of the programs. limits: speed and
    acceleration limits in force that differ. inputs: other things that differ. modules: changes of program text by run
    after the first. notes: what a reader must know, one line each."""

    runs: tuple[OneRun, ...]
    target: Target
    rows: tuple[AlignedMotion, ...]
    limits: tuple[Difference, ...]
    inputs: tuple[Difference, ...]
    modules: Mapping[str, tuple[ModuleChange, ...]]
    notes: tuple[str, ...]

    @property
    def by_difference(self) -> tuple[AlignedMotion, ...]:
        """The rows whose times differ, the largest difference first."""
        differ = [row for row in self.rows if row.spread >= EQUAL]
        return tuple(sorted(differ, key=lambda row: -row.spread))

    @property
    def bound_otherwise(self) -> tuple[AlignedMotion, ...]:
        """The rows that different limits hold back."""
        return tuple(row for row in self.rows if len({one for one in row.bindings if one is not None}) > 1)


def compare_runs(folders: Sequence[Path], target: Target | None = None) -> ComparedRuns:
    """Two results folders of trajopt optimize or more. target: whose motions are put side by side; None for the first
    run's choice. Raises InputError for a folder that is none, of another kind, or damaged."""
    if not 2 <= len(folders) <= len(LETTERS):
        wanted = f"two results folders or more, at most {len(LETTERS)}"
        raise InputError(f"{len(folders)} given; compare runs needs {wanted}", file="RESULTS")
    runs = tuple(_read(folder, letter) for folder, letter in zip(folders, LETTERS, strict=False))
    chosen = target or runs[0].target
    rows = _in_step([run.plans[chosen].motions for run in runs])
    modules = {run.letter: changed_modules(runs[0].inputs, run.inputs) for run in runs[1:]}
    limits = differences("", [_limits(run.plans[chosen]) for run in runs])
    return ComparedRuns(
        runs, chosen, rows, limits, _inputs(runs), modules, (*_same(runs), *_strangers(runs, rows), *_chosen(runs))
    )


def _read(folder: Path, letter: str) -> OneRun:
    made = kind_of(folder)
    if made == TASK:
        why = "its sequence has no motions of a program to put side by side"
        raise InputError(f"was made by trajopt iiwa; compare runs reads folders of optimize: {why}", file=str(folder))
    if made != PLAN:
        raise InputError(f"is a folder of kind {made}; compare runs reads folders of optimize", file=str(folder))
    run = read_run(folder, PlanRecord, (SUMMARY,))
    told = run.summary(Summary)
    plans = {one: told.plans.of(one) for one in Target}
    return OneRun(letter, folder, told.target, plans, told.as_written.cycle_time_s, inputs_of(run))


def _inputs(runs: Sequence[OneRun]) -> tuple[Difference, ...]:
    """What else differs, in the order a reader looks for it."""
    return (
        *differences("cell", [run.inputs.cell for run in runs]),
        *differences("file", [run.inputs.others for run in runs]),
        *differences("option", [run.inputs.options for run in runs]),
        *differences("version", [run.inputs.versions for run in runs]),
    )


def _limits(plan: PlanSummary) -> dict[str, str]:
    """The speed and acceleration limits that were in force, by name: "joint_1 speed", "TCP speed"."""
    found = (one for one in plan.judge.findings if one.check in _LIMITS and one.limit is not None)
    kinds = ((one, one.check.removeprefix("joint ")) for one in found)
    named = {kind if kind.startswith("TCP") else f"{one.subject} {kind}": one for one, kind in kinds}
    return {name: f"{one.limit:.6g} {one.unit}" for name, one in sorted(named.items())}


def _in_step(columns: Sequence[Sequence[MotionRow]]) -> tuple[AlignedMotion, ...]:
    """Rows of the same motions, in order: of equal name; where names differ of equal target, or waits.

    Each run is put beside the rows of those before it; a motion that they lack has a row of its own.
    """
    rows: list[list[MotionRow | None]] = [[one] for one in columns[0]]
    for n, column in enumerate(columns[1:], start=1):
        keys = [next(one for one in row if one is not None).key for row in rows]
        own = [one.key for one in column]
        out: list[list[MotionRow | None]] = []
        empty: list[MotionRow | None] = [None] * n
        for what, a, b, c, d in SequenceMatcher(None, keys, own, autojunk=False).get_opcodes():
            if what == "equal":
                out += [[*row, one] for row, one in zip(rows[a:b], column[c:d], strict=True)]
                continue
            at = c
            for row, key in zip(rows[a:b], keys[a:b], strict=True):
                found = next((i for i in range(at, d) if _alike(key, own[i])), None)
                if found is not None:
                    out += [[*empty, one] for one in column[at:found]]
                    at = found + 1
                out.append([*row, None if found is None else column[found]])
            out += [[*empty, one] for one in column[at:d]]
        rows = out
    return tuple(AlignedMotion(tuple(row)) for row in rows)


def _alike(one: tuple[str, str], other: tuple[str, str]) -> bool:
    """Whether two motions of different names stand for each other: to one target, or waits of another length."""
    return one[1] == other[1] or one[0] == other[0] == "WaitTime"


def _same(runs: Sequence[OneRun]) -> list[str]:
    out = []
    for a, b in combinations(runs, 2):
        if os.path.realpath(a.folder) == os.path.realpath(b.folder):
            out.append(f"{a.letter} and {b.letter} are the same folder, so nothing differs between them")
    return out


def _strangers(runs: Sequence[OneRun], rows: Sequence[AlignedMotion]) -> list[str]:
    """Runs that have little in common with the first."""
    out = []
    for n, run in enumerate(runs[1:], start=1):
        both = sum(row.motions[0] is not None and row.motions[n] is not None for row in rows)
        most = max(sum(row.motions[0] is not None for row in rows), sum(row.motions[n] is not None for row in rows))
        if both < _ALIKE * most:
            names = " and ".join(", ".join(one.inputs.modules) for one in (runs[0], run))
            out.append(
                f"{runs[0].letter} and {run.letter} are of different programs ({names}): {both} of {most} motions are "
                "in both, so differences of their times say little"
            )
    return out


def _chosen(runs: Sequence[OneRun]) -> list[str]:
    """Plans that no judge calls legal, as of a folder whose run said so."""
    return [
        f"{run.letter}: the {target} plan is not legal, says its judge"
        for run in runs
        for target, plan in run.plans.items()
        if not plan.judge.legal
    ]


@dataclass(frozen=True, eq=False)
class RunInputs:
    """modules: texts by name. cell: the cell file's values as text, by dotted key. others: the SHA-256 of other files,
    by name. options, versions: as text."""

    modules: Mapping[str, str]
    cell: Mapping[str, str]
    others: Mapping[str, str]
    options: Mapping[str, str]
    versions: Mapping[str, str]


@dataclass(frozen=True)
class Difference:
    """One thing that differs: kind ("cell", "option", ...), name, and each run's value, None where it has none."""

    kind: str
    name: str
    values: tuple[str | None, ...]

    @property
    def what(self) -> str:
        """Kind and name."""
        return f"{self.kind} {self.name}".strip()


@dataclass(frozen=True)
class ModuleChange:
    """A module that differs from the first run's: lines added and removed, and the difference as `diff -U1` has it."""

    name: str
    added: int
    removed: int
    diff: tuple[str, ...]


def inputs_of(run: ResultsFolder[PlanRecord]) -> RunInputs:
    """What a folder was made from. Raises InputError for a cell file that is no mapping."""
    record = run.record
    texts = {_name(one.place): decode(run.contents[one.place])[0] for one in record.inputs.files if one.module}
    place = str(record.inputs.cell)
    content, _ = parse(run.contents[place].decode("utf-8", "replace"), str(run.folder / place), "a cell")
    others = {_name(one.place): one.sha256[:12] for one in record.inputs.files if not one.module and one.place != place}
    options = {name: _text(value) for name, value in record.options.model_dump(mode="json").items()}
    versions = {"trajopt": record.trajopt, **record.versions}
    return RunInputs(texts, dict(_flat(content, "")), others, options, versions)


def differences(kind: str, runs: Sequence[Mapping[str, str]]) -> tuple[Difference, ...]:
    """The names whose values are not the same in all runs, in the order of their first run."""
    names = dict.fromkeys(name for one in runs for name in one)
    rows = (Difference(kind, name, tuple(one.get(name) for one in runs)) for name in names)
    return tuple(row for row in rows if len(set(row.values)) > 1)


def changed_modules(first: RunInputs, other: RunInputs) -> tuple[ModuleChange, ...]:
    """The modules of other that differ from those of the same name in first; the only ones of both whatever they are
    called."""
    pairs = [(name, name) for name in dict.fromkeys((*first.modules, *other.modules))]
    if len(first.modules) == len(other.modules) == 1:
        pairs = [(next(iter(first.modules)), next(iter(other.modules)))]
    changes = (_change(first.modules.get(a), other.modules.get(b), a, b) for a, b in pairs)
    return tuple(change for change in changes if change is not None)


def _change(before: str | None, after: str | None, a: str, b: str) -> ModuleChange | None:
    """None: a run does not have the module, which counts as an empty one."""
    name = a if a == b else f"{a} → {b}"
    old, new = (before or "").splitlines(), (after or "").splitlines()
    if old == new:
        return None
    codes = [code for code in SequenceMatcher(None, old, new, autojunk=False).get_opcodes() if code[0] != "equal"]
    added, removed = sum(d - c for _, _, _, c, d in codes), sum(b - a for _, a, b, _, _ in codes)
    return ModuleChange(name, added, removed, tuple(map(printable, unified_diff(old, new, a, b, n=1, lineterm=""))))


def _flat(value: Any, path: str) -> Iterator[tuple[str, str]]:
    """Every value of a section by its dotted key; a list of plain values is one."""
    if isinstance(value, Mapping) and (value or not path):
        for key, inner in value.items():
            yield from _flat(inner, f"{path}.{key}" if path else str(key))
    elif isinstance(value, list) and any(isinstance(one, Mapping) for one in value):
        for i, inner in enumerate(value):
            yield from _flat(inner, f"{path}.{i}")
    else:
        yield path, _text(value)


def _text(value: Any) -> str:
    """As JSON, but for texts, which stand as they are."""
    if isinstance(value, list) and value and all(isinstance(one, str) for one in value):
        return ", ".join(value)
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False, default=str)


def _name(place: str) -> str:
    return PurePath(place).as_posix().removeprefix(INPUT)
