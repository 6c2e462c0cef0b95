"""What a command does to its own process; the library leaves the process as it found it."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

import typer

from trajopt_cli.rapid.execution.room import FRAMES


def own_process() -> None:
    """Set up a process that does nothing but one command."""
    for library in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        # both targets are solved side by side on two cores; more threads inside would only wait for each other
        os.environ.setdefault(library, "1")
    sys.setrecursionlimit(max(sys.getrecursionlimit(), FRAMES))


_finished: list[str] = []  # what this command has written whole


def wrote(path: Path) -> None:
    """Remember that a file or folder is written, to say so where the user ends the command after that."""
    _finished.append(str(path))


def begin() -> None:
    """Nothing is written yet."""
    _finished.clear()


def interrupted() -> str:
    """What a command that Ctrl-C ended says that it kept."""
    if not _finished:
        return "interrupted: nothing written, earlier results stand"
    return f"interrupted: {', '.join(_finished)} written before that, nothing half-written"


def tidied(files: Iterable[Path]) -> None:
    """Put back what a killed run left half-written of these files, and say so."""
    from trajopt_cli.runs.together import put_back

    for line in put_back(files):
        typer.echo(line, err=True)


@contextmanager
def reading(program: Iterable[Path] = ()) -> Iterator[None]:
    """No garbage collector while a program is read, and no second look at what was read; modules that a killed run left
    half-written are put back before, and that is told.

    Nearly all of the objects stay, so looking for those that do not doubles the time (bench_parse.py).
    """
    from trajopt_cli.rapid.sources import modules_at

    tidied(modules_at(program))
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
