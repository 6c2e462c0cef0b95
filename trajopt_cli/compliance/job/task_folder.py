"""The results folder of `trajopt iiwa`: the task it came from, the sequence, and what later commands added.

run.json says what made it and lists every other file with its hash; summary.json has one section per command. A
command that adds to a folder writes the whole folder anew, in one step.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trajopt_cli.compliance.task.model import AngleMeaning, RotationLaw
from trajopt_cli.errors import InputError
from trajopt_cli.runs.folder import (
    RUN,
    SUMMARY,
    TASK,
    parse_record,
    read_listed,
    read_run,
    record,
    sha256,
    write_run,
)

EQUILIBRIUM, QUATERNIONS, JOINTS, SIMULATION = (
    "equilibrium.csv",
    "equilibrium_quaternion.csv",
    "joints.csv",
    "simulation.csv",
)
_LIBRARIES = ("numpy", "pin", "ruckig")


@dataclass(frozen=True, eq=False)
class TaskFolder:
    """A folder read back: its files but run.json, the summary, and which of the inputs are task and RAPID program."""

    folder: Path
    files: Mapping[str, bytes]
    summary: Mapping[str, Any]
    task: str
    program: str | None
    options: Mapping[str, Any]

    @property
    def task_path(self) -> Path:
        """The copy of the task file."""
        return self.folder / self.task

    @property
    def program_path(self) -> Path | None:
        """The copy of the RAPID program that replaces the task's poses, None where the task names its own."""
        return None if self.program is None else self.folder / self.program

    def text(self, name: str) -> str:
        """A file's text. Raises InputError where the command that makes it has not run."""
        if name not in self.files:
            raise InputError(f"has no {name}", file=str(self.folder))
        return self.files[name].decode("ascii", "replace")


@dataclass(frozen=True)
class SequenceRecord:
    """What summary.json says of the sequence and its CSV files do not.

    rotation: of RotationLaw, angles: of AngleMeaning, by their values. pieces: first row, last row (both included),
    from, to, dwell; each begins at the row the one before ends at, the first at 0.
    """

    period_s: float
    rotation: str
    angles: str
    pieces: tuple[tuple[int, int, str, str, bool], ...]

    @property
    def rows(self) -> int:
        """How many rows the sequence has."""
        return self.pieces[-1][1] + 1


def write_task_folder(
    folder: Path,
    files: Mapping[str, bytes],
    summary: Mapping[str, Any],
    task: str,
    program: str | None,
    options: Mapping[str, Any],
) -> None:
    """Write a folder whole; files holds everything but summary.json and run.json.

    task, program: the names in files of the task file and of the program read in place of its poses. Raises InputError
    where folder may not be replaced.
    """
    content = {**files, SUMMARY: record(summary)}
    write_run(
        folder, TASK, _LIBRARIES, content, {"options": dict(options), "inputs": {"task": task, "program": program}}
    )


def read_task_folder(folder: Path) -> TaskFolder:
    """Read a folder back. Raises InputError for a folder that is none, or whose files were changed since."""
    run = read_run(folder, TASK)
    inputs, options = run["inputs"], run.get("options")
    task, program = inputs.get("task"), inputs.get("program")
    listed = set(run["files"]) - {SUMMARY}
    named = isinstance(task, str) and task in listed and (program is None or isinstance(program, str))
    if not named or program not in (None, *listed) or SUMMARY not in run["files"] or not isinstance(options, dict):
        raise InputError("was not written by trajopt", file=str(folder / RUN))
    files = {}
    for name, digits in run["files"].items():
        files[name] = read_listed(folder, name)
        if sha256(files[name]) != digits:
            raise InputError("was changed since it was written; make the folder again", file=str(folder / name))
    summary = parse_record(files.pop(SUMMARY), str(folder / SUMMARY))
    if not isinstance(summary.get("sequence"), dict):
        raise _not_ours(folder)
    return TaskFolder(folder=folder, summary=summary, files=files, task=task, program=program, options=options)


def sequence_of(found: TaskFolder) -> SequenceRecord:
    """The sequence's section of the summary. Raises InputError where it is not what trajopt writes."""
    section = found.summary["sequence"]
    period, rotation, angles = section.get("period_s"), section.get("rotation"), section.get("angles")
    pieces = section.get("pieces")
    if (
        not (isinstance(period, float) and math.isfinite(period) and period > 0)
        or rotation not in [law.value for law in RotationLaw]
        or angles not in [meaning.value for meaning in AngleMeaning]
        or not (isinstance(pieces, list) and pieces)
    ):
        raise _not_ours(found.folder)
    rows = tuple(_piece(one, found.folder) for one in pieces)
    begins = [0, *(last for _, last, *_ in rows[:-1])]
    if any(not row == first <= last for row, (first, last, *_) in zip(begins, rows, strict=True)):
        raise _not_ours(found.folder)
    return SequenceRecord(period, rotation, angles, rows)


def _piece(value: object, folder: Path) -> tuple[int, int, str, str, bool]:
    if not isinstance(value, dict):
        raise _not_ours(folder)
    first, last, origin, goal, dwell = (value.get(key) for key in ("first", "last", "from", "to", "dwell"))
    if not (isinstance(first, int) and isinstance(last, int) and not isinstance(first, bool)):
        raise _not_ours(folder)
    if isinstance(last, bool) or not (isinstance(origin, str) and isinstance(goal, str) and isinstance(dwell, bool)):
        raise _not_ours(folder)
    return first, last, origin, goal, dwell


def _not_ours(folder: Path) -> InputError:
    return InputError("is not what trajopt wrote; make the folder again", file=str(folder / SUMMARY))
