"""run.json of a results folder of trajopt optimize, checked before anything it names is opened."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trajopt_cli.errors import InputError
from trajopt_cli.runs.folder import PLAN, RUN, read_listed, read_run, sha256

_SHOWN = 60  # characters of a wrong value


@dataclass(frozen=True)
class RecordedInput:
    """A file the run was made from. path: as the user gave it; copy and rapid: places in the folder. module: whether
    it is a RAPID module; rapid None where not, and where the plan could not be written as RAPID."""

    path: str
    copy: str
    rapid: str | None
    module: bool


@dataclass(frozen=True)
class PlanRecord:
    """What run.json says, and contents: every file that it lists, by name, each with the hash that it lists.

    added: path beside the program and place in the folder of each module that the export added. no_rapid: why the plan
    could not be written as RAPID.
    """

    inputs: tuple[RecordedInput, ...]
    cell: str
    entry: str
    assume_identity: tuple[str, ...]
    added: tuple[tuple[str, str], ...]
    no_rapid: str | None
    contents: Mapping[str, bytes]


def read_plan_record(folder: Path, needed: tuple[str, ...], judged: tuple[str, ...] = ()) -> PlanRecord:
    """Read run.json and all files that it lists. needed: names it must list. judged: names whose content may differ
    from what the run wrote, because a judge looks at it.

    Raises InputError for a folder that is none, for a run.json that trajopt cannot have written, and for a file that
    was changed.
    """
    run = read_run(folder, PLAN)
    record = _Checked(str(folder / RUN), run)
    for name in needed:
        record.listed(name, name)
    no_rapid = None if run.get("no_rapid") is None else record.text(run["no_rapid"], "no_rapid")
    inputs = tuple(_inputs(record, no_rapid is not None))
    modules = [one.copy for one in inputs if one.module]
    if record.listed(run["inputs"].get("program"), "inputs.program") not in modules:
        raise record.wrong("inputs.program", run["inputs"]["program"], "one of the modules in inputs.files")
    cell = record.listed(run["inputs"].get("cell"), "inputs.cell")
    if cell not in [one.copy for one in inputs if not one.module]:
        raise record.wrong("inputs.cell", cell, "one of inputs.files that is no module")
    options = record.mapping(run.get("options", {}), "options")
    program = options.get("program", "")
    for i, path in enumerate(program if isinstance(program, list) else [program]):
        record.text(path, f"options.program[{i}]")
    names = record.items(options.get("assume_identity", []), "options.assume_identity")
    found = PlanRecord(
        inputs=inputs,
        cell=cell,
        entry=record.text(options.get("entry", "main"), "options.entry"),
        assume_identity=tuple(record.text(name, f"options.assume_identity[{i}]") for i, name in enumerate(names)),
        added=tuple(_added(record, inputs)),
        no_rapid=no_rapid,
        contents=_held(folder, run["files"], judged),
    )
    for i, (one, entry) in enumerate(zip(inputs, run["inputs"]["files"], strict=True)):
        if entry.get("sha256") != run["files"][one.copy]:
            raise record.wrong(f"inputs.files[{i}].sha256", entry.get("sha256"), f"the one of {one.copy} in files")
    return found


class _Checked:
    """The values of one run.json, each asked for by the kind it must be; InputError where it is another."""

    def __init__(self, file: str, run: Mapping[str, Any]):
        self.file, self.run = file, run

    def wrong(self, what: str, value: object, wanted: str) -> InputError:
        shown = json.dumps(value)
        shown = shown if len(shown) <= _SHOWN else f"{shown[:_SHOWN]}..."
        return InputError(f"was not written by trajopt: {what} is {shown}, wanted {wanted}", file=self.file)

    def mapping(self, value: object, what: str) -> Mapping[str, Any]:
        if not isinstance(value, dict):
            raise self.wrong(what, value, "an object")
        return value

    def items(self, value: object, what: str) -> list[Any]:
        if not isinstance(value, list):
            raise self.wrong(what, value, "a list")
        return value

    def text(self, value: object, what: str) -> str:
        if not isinstance(value, str):
            raise self.wrong(what, value, "a text")
        return value

    def path(self, value: object, what: str) -> str:
        """A path of the user's: whatever the system takes as one."""
        path = self.text(value, what)
        try:
            usable = bool(Path(path).name) and b"\0" not in os.fsencode(path)
        except UnicodeEncodeError:
            usable = False
        if not usable:
            raise self.wrong(what, path, "the path of a file")
        return path

    def listed(self, value: object, what: str) -> str:
        """A name in the folder: one of the record's files, none of which leaves it."""
        name = self.text(value, what)
        if name not in self.run["files"]:
            raise self.wrong(what, name, "a file that its files list")
        return name


def _inputs(record: _Checked, no_rapid: bool) -> Iterator[RecordedInput]:
    seen: set[str] = set()
    for i, one in enumerate(record.items(record.run["inputs"].get("files"), "inputs.files")):
        what = f"inputs.files[{i}]"
        entry = record.mapping(one, what)
        path = record.path(entry.get("path"), f"{what}.path")
        copy = record.listed(entry.get("copy"), f"{what}.copy")
        rapid = None if entry.get("rapid") is None else record.listed(entry["rapid"], f"{what}.rapid")
        for key, place in (("copy", copy), ("rapid", rapid)):
            if place in seen:
                raise record.wrong(f"{what}.{key}", place, "a place that no other file has")
        seen |= {place for place in (copy, rapid) if place is not None}
        module = entry.get("module", rapid is not None)
        if not isinstance(module, bool) or (rapid is not None) != (module and not no_rapid):
            raise record.wrong(f"{what}.module", module, "true for a RAPID module, whose rapid is a place")
        yield RecordedInput(path, copy, rapid, module)


def _added(record: _Checked, inputs: tuple[RecordedInput, ...]) -> Iterator[tuple[str, str]]:
    """New modules: each called as in the folder, and beside one of the program's own files."""
    own = {Path(one.path) for one in inputs}
    beside = {Path(one.path).parent for one in inputs if one.module}
    for i, one in enumerate(record.items(record.run.get("added", []), "added")):
        entry = record.mapping(one, f"added[{i}]")
        path = record.path(entry.get("path"), f"added[{i}].path")
        place = record.listed(entry.get("rapid"), f"added[{i}].rapid")
        if Path(path).parent not in beside or Path(path) in own or Path(path).name in ("..", "."):
            raise record.wrong(f"added[{i}].path", path, "a new file in a folder of the program")
        if Path(place).name != Path(path).name:
            raise record.wrong(f"added[{i}].rapid", place, f"a file called {Path(path).name}")
        yield path, place


def _held(folder: Path, files: Mapping[str, str], judged: tuple[str, ...]) -> dict[str, bytes]:
    """Every listed file, each with the hash that the run wrote."""
    contents = {}
    for name, digits in files.items():
        contents[name] = read_listed(folder, name)
        if name not in judged and sha256(contents[name]) != digits:
            raise InputError("was changed since the run; run trajopt optimize again", file=str(folder / name))
    return contents
