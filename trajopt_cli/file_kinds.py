"""What a file is that was given in the place of another: a program, a cell, a task, a robot, a study, results
or a joint CSV."""

from __future__ import annotations

import re
from pathlib import Path

from trajopt_cli.errors import InputError

_TASK = {"poses", "program", "K", "D", "M", "h"}  # keys of a task file of the iiwa that no cell file has
_CELL = {"robot", "rail", "limits", "tcp", "signals", "data", "start"}
_HEAD = 100_000  # characters of a file that are looked at
_KINDS = {
    "program": ("a RAPID program", "'trajopt optimize {0}'"),
    "cell file": ("a cell file", "'trajopt optimize PROGRAM.mod --cell {0}'"),
    "task file": ("a task file of the iiwa", "'trajopt iiwa segments {0}'"),
    "robot file": ("a robot file", "'robot: {0}' in a cell file"),
    "study file": ("a study file", "'trajopt study run {0}'"),
    "results folder": ("a results folder", "'trajopt verify {0}' or 'trajopt view {0}'"),
    "joint CSV": ("a CSV file", "'trajopt verify {0} --program PROGRAM.mod'"),
}


def kind_of(path: Path) -> str | None:
    """One of the keys of _KINDS, by the file's name and how it begins; None for what it may be otherwise."""
    if path.is_dir():
        return "results folder" if (path / "run.json").is_file() else None
    name = path.suffix.lower()
    if name in (".mod", ".sys", ".prg", ".pgf"):
        return "program"
    if name == ".csv":
        return "joint CSV"
    if name not in (".yaml", ".yml"):
        return None
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            keys = set(re.findall(r"^(\w+)[ ]*:", file.read(_HEAD), re.MULTILINE))
    except OSError:  # who reads it says why it cannot be read
        return None
    if "urdf" in keys:
        return "robot file"
    if "vary" in keys:
        return "study file"
    if keys & _TASK:
        return "task file"
    return "cell file" if keys & _CELL else None


def refuse_other(path: str | Path, wanted: str) -> None:
    """Raise InputError where a file is of another kind than wanted, naming its kind and the command that takes it.

    wanted: "program", "cell file", "task file", "robot file", "study file", "results folder" or "joint CSV".
    """
    kind = kind_of(Path(path))
    if kind is not None and kind != wanted:
        what, takes = _KINDS[kind]
        raise InputError(f"is {what}, not {_KINDS[wanted][0]}; {takes.format(path)} takes it", file=str(path))
