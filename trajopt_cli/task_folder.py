"""The results folder of `trajopt iiwa`: the task it came from, the sequence, and what later commands added.

run.json says what made it and lists every other file with its hash; summary.json has one section per command. A
command that adds to a folder writes the whole folder anew, in one step.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trajopt_cli.errors import InputError
from trajopt_cli.run_folder import SUMMARY, TASK, read_bytes, read_run, record, sha256, write_run

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
    files = {}
    for name, digits in run["files"].items():
        files[name] = read_bytes(folder / name)
        if sha256(files[name]) != digits:
            raise InputError("was changed since it was written; make the folder again", file=str(folder / name))
    return TaskFolder(
        folder=folder,
        summary=json.loads(files.pop(SUMMARY)),
        files=files,
        task=run["inputs"]["task"],
        program=run["inputs"]["program"],
        options=run["options"],
    )
