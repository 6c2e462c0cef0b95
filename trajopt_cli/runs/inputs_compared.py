"""What runs were made from, and where that differs: program text, cell file, other files, options, versions."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher, unified_diff
from pathlib import PurePath
from typing import Any

from trajopt_cli.errors import printable
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.runs.folder import ResultsFolder
from trajopt_cli.runs.record import INPUT
from trajopt_cli.runs.results import PlanRecord
from trajopt_cli.yaml_file import parse


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
