"""What every folder that trajopt writes has in common: run.json, which says what made it and lists its other files."""

from __future__ import annotations

import hashlib
import json
import os
import platform
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path, PurePosixPath
from typing import Any

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.files import recover, write_folder

RUN, SUMMARY = "run.json", "summary.json"
PLAN, TASK, EXPERIMENTS = "plan", "iiwa", "experiments"
"""Kinds of folders: of trajopt optimize, of trajopt iiwa on a task, and of the thesis' experiments."""
FORMAT = 1
"""Of the folders; a reader refuses a newer one."""
_COMMANDS = {PLAN: "optimize", TASK: "iiwa segments", EXPERIMENTS: "iiwa experiments"}


def read_run(folder: Path, kind: str) -> dict[str, Any]:
    """run.json of a folder of this kind; its files are names inside the folder to hashes, its inputs a dict.

    Raises InputError for a folder that is none, is another, or is newer.
    """
    with _read(folder):
        try:
            folder.stat()
        except (FileNotFoundError, NotADirectoryError) as error:
            message = f"does not exist; make it with trajopt {_COMMANDS[kind]}"
            raise InputError(message, file=str(folder)) from error
    run = _run(folder)
    made = run.get("kind", PLAN)
    if made != kind:
        by = (
            f"made by trajopt {_COMMANDS[made]}"
            if made in _COMMANDS
            else f"written as an unknown kind, {_quoted(made)}"
        )
        raise InputError(f"was {by}; this needs a folder of {_COMMANDS[kind]}", file=str(folder))
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
    with _read(folder):
        if not folder.exists():
            return
        if not folder.is_dir():
            raise InputError("is a file; --output names a folder", file=str(folder))
        content = (path for path in folder.rglob("*") if not path.is_dir())
        if not os.path.lexists(folder / RUN):
            if next(content, None) is None:  # looks no further than the first file: this may be a home folder
                return
            raise InputError(
                "is not a results folder of trajopt (no run.json) and is not replaced; choose another --output",
                file=str(folder),
            )
        known = {RUN, *_run(folder)["files"]}
        strangers = sorted({path.relative_to(folder).as_posix() for path in content} - known)
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


def read_listed(folder: Path, name: str) -> bytes:
    """A file that run.json lists. Raises InputError where it cannot be read, or is a link or a device."""
    path = folder / name
    with _read(path):
        inside = os.path.realpath(path) == os.path.join(os.path.realpath(folder), name)
        if path.exists() and not (inside and path.is_file()):
            raise InputError("is not a file that trajopt wrote; make the folder again", file=str(path))
    return read_bytes(path)


def read_record(path: Path) -> dict[str, Any]:
    """A JSON object in a file. Raises InputError for anything else."""
    return parse_record(read_bytes(path), str(path))


def parse_record(text: bytes, file: str) -> dict[str, Any]:
    """The JSON object in text; file is its name in messages. Raises InputError for anything else."""
    try:
        content = json.loads(text)
    except ValueError as error:
        raise InputError(f"is not JSON: {error}", file=file) from error
    except RecursionError as error:
        raise InputError("is not JSON that trajopt wrote: nested too deep", file=file) from error
    if not isinstance(content, dict):
        raise InputError("is not a JSON object", file=file)
    return content


def sha256(content: bytes) -> str:
    """Of the exact bytes, in hexadecimal."""
    return hashlib.sha256(content).hexdigest()


def record(content: Mapping[str, Any]) -> bytes:
    """JSON for a person and for programs; raises ValueError for numbers that are not finite."""
    text = json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    return text.encode(errors="backslashreplace")  # a lone surrogate, \udc80, is written as JSON's own escape


def _run(folder: Path) -> dict[str, Any]:
    with _read(folder):
        if not (folder / RUN).is_file():
            raise InputError("is not a results folder of trajopt (no run.json)", file=str(folder))
    run, file = read_record(folder / RUN), str(folder / RUN)
    number = run.get("format")
    if type(number) is not int or number < 1 or not {"trajopt", "inputs", "files"} <= run.keys():
        raise InputError("was not written by trajopt", file=file)
    if number > FORMAT:
        raise InputError(f"is of format {_quoted(number)}; this trajopt reads up to {FORMAT}", file=file)
    files, kind = run["files"], run.get("kind", PLAN)
    if not isinstance(files, dict) or not isinstance(run["inputs"], dict) or not isinstance(kind, str):
        raise InputError("was not written by trajopt", file=file)
    for name, digits in files.items():
        if not isinstance(digits, str) or not _stays_inside(name):
            raise InputError(f"was not written by trajopt: its files have {_quoted(name)}", file=file)
    return run


def _stays_inside(name: str) -> bool:
    """Whether a folder may have a file of this name: relative, as write_run spells it, nothing above the folder."""
    try:
        os.fsencode(name)
    except UnicodeEncodeError:
        return False
    path = PurePosixPath(name)
    spelled = name == str(path) and bool(path.name) and not any(sign < " " for sign in name)
    return spelled and not path.is_absolute() and ".." not in path.parts


def _quoted(value: object) -> str:
    """For a message: JSON, of bounded length."""
    text = json.dumps(value) if not isinstance(value, int) or value.bit_length() < 64 else "a very large number"
    return text if len(text) <= 80 else f"{text[:77]}..."


@contextmanager
def _read(path: Path) -> Iterator[None]:
    """What the system refuses inside is told in one line about path."""
    try:
        yield
    except OSError as error:
        raise InputError(f"cannot read: {error.strerror}", file=str(path)) from error
