"""What a case may end in, and what is a finding.

A reader may return, or raise an InputError of at most a page of text without control characters, or an OSError that
names its file. A command may end with exit code 0, 1, 2 or 130, with at most a page on stderr and no control characters
anywhere. Everything else is a finding: another exception, a warning of a library, more than SECONDS of processor, more
than MEMORY.
"""

from __future__ import annotations

import os
import re
import resource
import signal
import sys
import tempfile
import traceback
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from io import FileIO, TextIOWrapper
from pathlib import Path
from typing import TextIO
from zlib import crc32

from trajopt_cli.errors import InputError

SECONDS = 30  # of processor
MEMORY = 1 << 30  # bytes of address space more than at the start
PAGE = 4000  # characters on stderr
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
_INSIDE = f"{os.sep}trajopt_cli{os.sep}"


@dataclass(frozen=True)
class Finding:
    """What must not be: its kind with the place, which tells findings apart, and all there is to say."""

    place: str
    told: str


@dataclass(frozen=True)
class Ended:
    """How a case ended, a mark of the way that it took (the lines of trajopt that its error passed), and a finding."""

    how: str
    way: tuple[tuple[str, int], ...] = ()
    finding: Finding | None = None


class Hang(BaseException):
    """A case took too long; no Exception, so that no reader takes it for bad input."""


def _alarm(number: int, frame: object) -> None:
    raise Hang


def set_limits(memory: int = MEMORY) -> None:
    """Bound this process; once, when everything is imported."""
    signal.signal(signal.SIGPROF, _alarm)
    if sys.platform == "linux" and memory:
        size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (size + memory, resource.getrlimit(resource.RLIMIT_AS)[1]))


def guarded(work: Callable[[], str]) -> Ended:
    """work, which says how it ended, or raises."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return Ended(work())
    except InputError as error:
        way = _way(error)
        text = error.shown()
        if complaint := _complaint(text):
            return Ended("refused", way, Finding(f"message {complaint} {_place(way)}", text[:2000]))
        return Ended("refused", way)
    except OSError as error:
        way = _way(error)
        if error.filename is None:
            return Ended("refused", way, Finding(f"OSError without a file {_place(way)}", traceback.format_exc()))
        return Ended("refused", way)
    except (Exception, Hang) as error:  # noqa: BLE001  whatever it is, it is a finding
        way = _way(error)
        told = traceback.format_exc()
        return Ended("finding", way, Finding(f"{type(error).__name__} {_place(way)}", told))
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def _complaint(text: str) -> str:
    if len(text) > PAGE:
        return f"of {'more than a page' if len(text) < 10 * PAGE else 'ten pages'}"
    found = _CONTROL.search(text)
    return f"with the control character {found[0]!r}" if found else ""


def _way(error: BaseException) -> tuple[tuple[str, int], ...]:
    """The lines of trajopt on the way to where an error was raised."""
    out, trace = [], error.__traceback__
    while trace is not None:
        name = trace.tb_frame.f_code.co_filename
        if _INSIDE in name:
            out.append((name.rpartition(_INSIDE)[2], trace.tb_lineno))
        trace = trace.tb_next
    return tuple(out)


def _place(way: tuple[tuple[str, int], ...]) -> str:
    return "at {}:{}".format(*way[-1]) if way else "outside trajopt"


# --------------------------------------------------------------------------------------------------------- commands


def command(arguments: list[str]) -> Ended:
    """A command line in this process, with all that it prints, by libraries in C, too."""
    from trajopt_cli.cli import run

    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        ours, kept = (sys.stdout, sys.stderr), (os.dup(1), os.dup(2))
        for stream in ours:
            stream.flush()
        for number, file in ((1, out), (2, err)):
            os.dup2(file.fileno(), number)
        sys.stdout, sys.stderr = (_stream(number) for number in (1, 2))
        try:
            ended = guarded(lambda: f"exit {run(arguments)}")
        except SystemExit as error:
            ended = Ended(f"exit {error.code}")
        finally:
            for stream in (sys.stdout, sys.stderr):
                stream.flush()
            sys.stdout, sys.stderr = ours
            for number, was in zip((1, 2), kept, strict=True):
                os.dup2(was, number)
                os.close(was)
        texts = []
        for file in (out, err):
            file.seek(0)
            texts.append(file.read().decode("utf-8", "replace"))
    if ended.finding is not None:
        return ended
    return judged(ended.how, *texts)


def _stream(number: int) -> TextIO:
    return TextIOWrapper(FileIO(number, "w", closefd=False), "utf-8", "backslashreplace")  # type: ignore[arg-type]


def judged(how: str, out: str, err: str) -> Ended:
    """What a command has printed, and how it ended."""
    name = re.sub(r"\d+|'[^']*'|\"[^\"]*\"", "_", err[:60])
    if how not in ("exit 0", "exit 1", "exit 2", "exit 130"):
        return Ended(how, finding=Finding(f"{how}: {name}", err[-3000:]))
    if complaint := _complaint(err):
        return Ended(how, finding=Finding(f"stderr {complaint}: {name}", err[:3000]))
    if "Traceback" in err or "Warning" in err:
        return Ended(how, finding=Finding(f"stderr: {name}", err[:3000]))
    if how == "exit 2" and not err.strip():
        return Ended(how, finding=Finding("exit 2 without a word", out[:2000]))
    if found := _CONTROL.search(out.replace("\r\n", "\n")):
        return Ended(
            how,
            finding=Finding(
                f"stdout with the control character {found[0]!r}", out[max(0, found.start() - 500) :][:1000]
            ),
        )
    return Ended(how, (("", crc32(name.encode())),))
