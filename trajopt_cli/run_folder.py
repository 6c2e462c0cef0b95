"""What every folder that trajopt writes has in common: run.json, which says what made it and lists its other files."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Iterable, Mapping
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.files import recover, write_folder

RUN, SUMMARY = "run.json", "summary.json"
PLAN, TASK, EXPERIMENTS = "plan", "iiwa", "experiments"
"""Kinds of folders: of trajopt optimize, of trajopt iiwa on a task, and of the thesis' experiments."""
FORMAT = 1
"""Of the folders; a reader refuses a newer one."""


def read_run(folder: Path, kind: str) -> dict[str, Any]:
    """run.json of a folder of this kind. Raises InputError for a folder that is none, is another, or is newer."""
    run = _run(folder)
    if run.get("kind", PLAN) != kind:
        commands = {PLAN: "optimize", TASK: "iiwa segments", EXPERIMENTS: "iiwa experiments"}
        made = commands.get(run.get("kind", PLAN), "another command")
        raise InputError(f"was made by trajopt {made}; this needs a folder of {commands[kind]}", file=str(folder))
    return run


def write_run(
    folder: Path, kind: str, libraries: Iterable[str], files: Mapping[str, bytes], more: Mapping[str, Any]
) -> None:
    """Write a folder of this kind whole: files, and run.json with the versions of libraries and what more says.

    Raises InputError where folder may not be replaced.
    """
    run = {
        "trajopt": __version__,
        "format": FORMAT,
        "kind": kind,
        "versions": {"python": platform.python_version(), **{name: version(name) for name in libraries}},
        "inputs": {},
        **more,
        "files": {name: sha256(content) for name, content in sorted(files.items())},
        "written": datetime.now(UTC).isoformat(),
    }
    check_replaceable(folder)
    write_folder(folder, {**files, RUN: record(run)})


def check_replaceable(folder: Path) -> None:
    """Raise InputError unless folder is absent, empty, or a folder that holds only what trajopt wrote."""
    recover(folder)
    if not folder.exists():
        return
    if not folder.is_dir():
        raise InputError("is a file; --output names a folder", file=str(folder))
    present = {str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir()}
    if not present:
        return
    if RUN not in present:
        raise InputError(
            "is not a results folder of trajopt (no run.json) and is not replaced; choose another --output",
            file=str(folder),
        )
    strangers = sorted(present - {RUN, *_run(folder)["files"]})
    if strangers:
        raise InputError(
            f"holds {strangers[0]}, which trajopt did not write; move it away or choose another --output",
            file=str(folder),
        )


def read_bytes(path: Path) -> bytes:
    """A file's content. Raises InputError where it cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"cannot read: {error.strerror}", file=str(path)) from error


def read_record(path: Path) -> dict[str, Any]:
    """A JSON object in a file. Raises InputError for anything else."""
    try:
        content = json.loads(read_bytes(path))
    except ValueError as error:
        raise InputError(f"is not JSON: {error}", file=str(path)) from error
    if not isinstance(content, dict):
        raise InputError("is not a JSON object", file=str(path))
    return content


def sha256(content: bytes) -> str:
    """Of the exact bytes, in hexadecimal."""
    return hashlib.sha256(content).hexdigest()


def record(content: Mapping[str, Any]) -> bytes:
    """JSON for a person and for programs; raises ValueError for numbers that are not finite."""
    return (json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _run(folder: Path) -> dict[str, Any]:
    if not (folder / RUN).is_file():
        raise InputError("is not a results folder of trajopt (no run.json)", file=str(folder))
    run = read_record(folder / RUN)
    if not {"trajopt", "format", "inputs", "files"} <= run.keys():
        raise InputError("was not written by trajopt", file=str(folder / RUN))
    if run["format"] > FORMAT:
        raise InputError(f"is of format {run['format']}; this trajopt reads up to {FORMAT}", file=str(folder / RUN))
    return run
