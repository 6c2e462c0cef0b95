"""What a command does to its own process; the library leaves the process as it found it."""

from __future__ import annotations

import gc
import os
import resource
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from trajopt_cli.rapid.execution.recursion_limit import FRAMES

if TYPE_CHECKING:
    from trajopt_cli.job import Job

LEAST_MEMORY = 300_000_000  # bytes of address space: below, OpenBLAS ends the process in words and a code of its own


def own_process() -> None:
    """Set up a process that does nothing but one command. Raises MemoryError where `ulimit -v` leaves too little."""
    for library in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        # both targets are solved side by side on two cores; more threads inside would only wait for each other
        os.environ.setdefault(library, "1")
    sys.setrecursionlimit(max(sys.getrecursionlimit(), FRAMES))
    limit = _address_space()
    if limit is not None and limit < LEAST_MEMORY:
        raise MemoryError(f"trajopt needs {LEAST_MEMORY // 10**6} MB")


def _address_space() -> int | None:
    """How many bytes this process may have at most; None for as many as there are."""
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    return None if limit == resource.RLIM_INFINITY else limit


_REFUSED: tuple[str, ...] = ("bad_alloc", "failed to map segment", "cannot allocate memory", "can't start new thread")
_REFUSED += ("error return without exception set",)  # what Python says where it found no memory for a MemoryError


def out_of_memory(error: BaseException) -> str | None:
    """The line for an error that says, in whatever words, that there is no more memory; None for any other."""
    chain: BaseException | None = error
    seen: list[BaseException] = []  # an error may be its own cause
    while chain is not None and chain not in seen:
        seen.append(chain)
        text = str(chain)
        unloaded = isinstance(chain, OSError) and chain.errno is None and "libllvmlite" in text  # llvmlite says no more
        if isinstance(chain, MemoryError) or unloaded or any(words in text.lower() for words in _REFUSED):
            break
        chain = chain.__cause__ or chain.__context__
    else:
        return None
    limit, why = _address_space(), " ".join(str(chain).split()) if isinstance(chain, MemoryError) else ""
    may = "the system has no more" if limit is None else f"the process may have {limit // 10**6} MB (ulimit -v)"
    give = "give it 1 GB or more" if limit is not None and limit < 10**9 else "give it more, or --jobs 1"
    return f"out of memory: {may}{f'; {why}' if why else ''}; {give}. {interrupted().removeprefix('interrupted: ')}"


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
    from trajopt_cli.runs.transaction import put_back

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


def job_of(program: Sequence[Path], cell: Path | None, entry: str | None, assume_identity: Sequence[str] | None) -> Job:
    """The job of a command's program and cell, read as in reading. Raises InputError as read_job does."""
    from trajopt_cli.job import MAIN, read_job

    with reading(program):
        return read_job(program, cell, entry or MAIN, assume_identity or ())
