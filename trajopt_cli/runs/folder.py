"""Folders that trajopt writes, whole, and reads back only as they were written."""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cache, wraps
from importlib.metadata import version
from io import BufferedRandom
from pathlib import Path
from stat import S_ISDIR, S_ISREG
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.file_kinds import refuse_other
from trajopt_cli.runs import EXPORTS, REPORT, RUN, SUMMARY
from trajopt_cli.runs.files import check_writable, holding, recover, write_folder
from trajopt_cli.runs.record import INPUT, Model, RunRecord, as_json, checked, parse_record, quoted, sha256

FORMAT = 1
"""Of the folders; a reader refuses a newer one."""
PLAN, TASK, EXPERIMENTS, SENSITIVITY, COMPARISON = "plan", "iiwa", "experiments", "sensitivity", "comparison"
PLACE, ORDER = "place", "order"
_COMMANDS = {
    PLAN: "optimize",
    TASK: "iiwa segments",
    EXPERIMENTS: "iiwa experiments",
    SENSITIVITY: "sensitivity",
    COMPARISON: "compare baseline",
    PLACE: "place",
    ORDER: "order",
}
"""What makes a folder of each kind."""
_REPORTS = _COMMANDS | {TASK: "iiwa simulate"}
"""What writes a folder's page."""
MOST_BYTES, MOST_RECORD = 1_000_000_000, 20_000_000
"""Of all files of a folder, and of its run.json; a folder that holds more is not read."""
_FOREIGN, _ANEW = "was not written by trajopt", "move the folder away and make it again"
Record = TypeVar("Record", bound=RunRecord[Any])
P = ParamSpec("P")
T = TypeVar("T")


@dataclass(frozen=True, eq=False)
class ResultsFolder(Generic[Record]):
    """A folder read back: its record, and the content of every other file by name, each with the hash recorded.
    stamp: the bytes of run.json."""

    folder: Path
    record: Record
    contents: Mapping[str, bytes]
    stamp: bytes

    def text(self, name: str) -> str:
        """A file's text. Raises InputError where the command that makes it has not run."""
        if name not in self.contents:
            raise InputError(f"has no {name}", file=str(self.folder))
        return self.contents[name].decode("ascii", "replace")

    def summary(self, model: type[Model]) -> Model:
        """summary.json as far as model has it. Raises InputError where it is not what trajopt writes."""
        file = str(self.folder / SUMMARY)
        return checked(model, self.sections(), file, "is not what trajopt wrote", self.record.REMEDY)

    def sections(self) -> dict[str, Any]:
        """summary.json as it stands."""
        return parse_record(self.contents[SUMMARY], str(self.folder / SUMMARY))


def _as_it_stands(work: Callable[Concatenate[Path, P], T]) -> Callable[Concatenate[Path, P], T]:
    """Work on a folder, done again where a run that ended just now has made another one of it meanwhile."""

    @wraps(work)
    def again(folder: Path, /, *args: P.args, **options: P.kwargs) -> T:
        while True:
            before = _identity(folder)
            try:
                return work(folder, *args, **options)
            except InputError:
                if _identity(folder) == before:
                    raise

    return again


@_as_it_stands
def read_run(
    folder: Path, model: type[Record], needed: tuple[str, ...] = (), judged: tuple[str, ...] = ()
) -> ResultsFolder[Record]:
    """Read a folder of model's kind with all files that its run.json lists.

    needed: names it must list. judged: names whose content may differ from what the run wrote, because a judge looks at
    it. Raises InputError for a folder that is none, is another or newer, for a record that trajopt cannot have written,
    and for a file that was changed.
    """
    with _reading(folder):
        try:
            folder.stat()
        except (FileNotFoundError, NotADirectoryError) as error:
            message = f"does not exist; make it with trajopt {_COMMANDS[model.KIND]}"
            raise InputError(message, file=str(folder)) from error
    record, stamp = _record(folder, model)
    for name in needed:
        if name not in record.files:
            raise InputError(f"{_FOREIGN}: files: {quoted(name)} is missing; {_ANEW}", file=str(folder / RUN))
    _check_plain(folder)
    contents, left = {}, MOST_BYTES
    for name, digits in record.files.items():
        contents[name] = _read_listed(folder, name, left)
        left -= len(contents[name])
        if name not in judged and sha256(contents[name]) != digits:
            raise InputError(f"was changed since the run; {model.REMEDY}", file=str(folder / name))
    return ResultsFolder(folder, record, contents, stamp)


def write_run(
    folder: Path,
    model: type[RunRecord[Any]],
    files: Mapping[str, bytes | BufferedRandom],
    command: str,
    instead_of: ResultsFolder[Any] | None = None,
    **said: Any,
) -> None:
    """Write a folder of model's kind whole: files, as in write_folder, and run.json with what is said of them.

    command: that made the folder. instead_of: the run that it is made from and must still hold. said: the model's other
    fields. Raises InputError where folder may not be replaced.
    """
    record = model(
        trajopt=__version__,
        format=FORMAT,
        kind=model.KIND,
        command=command,
        versions=library_versions(model),
        files={name: sha256(content) for name, content in sorted(files.items())},
        finished=datetime.now(UTC).isoformat(),
        **said,
    )
    with holding(folder):
        if instead_of is not None and _read_listed(folder, RUN, MOST_RECORD) != instead_of.stamp:
            raise InputError("another run has changed it meanwhile, and that stays; run this again", file=str(folder))
        check_replaceable(folder)
        write_folder(folder, {**files, RUN: as_json(record)})


def library_versions(model: type[RunRecord[Any]]) -> dict[str, str]:
    """Python's and those of the libraries that a kind of folder keeps."""
    return {"python": platform.python_version(), **{name: _version(name) for name in model.LIBRARIES}}


@cache
def _version(name: str) -> str:
    return version(name)


@_as_it_stands
def check_replaceable(folder: Path) -> None:
    """Raise InputError unless folder is absent, empty, or a folder that holds only what trajopt wrote, and can be
    written."""
    recover(folder)
    check_writable(folder)
    with _reading(folder):
        if not folder.exists():
            return
        if not folder.is_dir():
            raise InputError("is a file; --output names a folder", file=str(folder))
        content = (path for path in folder.rglob("*") if path.is_symlink() or not path.is_dir())
        if not os.path.lexists(folder / RUN):
            if next(content, None) is None:  # looks no further than the first file: this may be a home folder
                return
            raise InputError(
                "is not a results folder of trajopt (no run.json) and is not replaced; choose another --output",
                file=str(folder),
            )
        known = {RUN, *EXPORTS, *_record(folder, RunRecord[Any])[0].files}
        strangers = sorted({path.relative_to(folder).as_posix() for path in content} - known)
    if strangers:
        raise InputError(
            f"holds {strangers[0]}, which trajopt did not write; move it away or choose another --output",
            file=str(folder),
        )


def kind_of(folder: Path) -> str:
    """What made a folder, as its run.json has it: PLAN, TASK and so on. Raises InputError for a folder that is none."""
    return _record(folder, RunRecord[Any])[0].kind


def read_report(folder: Path) -> bytes:
    """report.html of a folder of any kind, as it was written. Raises InputError, and says what makes one, where there
    is none, and for one that was changed."""
    record, _ = _record(folder, RunRecord[Any])
    if REPORT not in record.files:
        wanted = _REPORTS.get(record.kind)
        advice = f"; run trajopt {wanted} again" if wanted else ""
        raise InputError(f"has no {REPORT}{advice}", file=str(folder))
    content = _read_listed(folder, REPORT, MOST_BYTES)
    if sha256(content) != record.files[REPORT]:
        raise InputError(f"was changed since the run; {record.REMEDY}", file=str(folder / REPORT))
    return content


def read_bytes(path: Path) -> bytes:
    """A file's content. Raises InputError where it cannot be read."""
    with _reading(path):
        return path.read_bytes()


def _record(folder: Path, model: type[Record]) -> tuple[Record, bytes]:
    """run.json, of this kind if the model has one, and its bytes."""
    with _reading(folder):
        if not os.path.lexists(folder / RUN):
            refuse_other(folder, "results folder")
            raise InputError("is not a results folder of trajopt (no run.json)", file=str(folder))
    file = str(folder / RUN)
    stamp = _read_listed(folder, RUN, MOST_RECORD)
    content = parse_record(stamp, file)
    number, made, kind = content.get("format"), content.get("kind", PLAN), model.KIND
    if type(number) is int and number > FORMAT:
        raise InputError(f"is of format {quoted(number)}; this trajopt reads up to {FORMAT}", file=file)
    if kind and "trajopt" in content and isinstance(made, str) and made != kind:
        known = made in _COMMANDS
        by = f"made by trajopt {_COMMANDS[made]}" if known else f"written as an unknown kind, {quoted(made)}"
        raise InputError(f"was {by}; this needs a folder of {_COMMANDS[kind]}", file=str(folder))
    return checked(model, content, file, _FOREIGN, _ANEW), stamp


def _read_listed(folder: Path, name: str, most: int) -> bytes:
    """A file of the folder: a plain one, that no link leads away from, of at most so many bytes."""
    path = folder / name
    with _reading(path):
        if os.path.lexists(path):
            inside = os.path.realpath(path) == os.path.join(os.path.realpath(folder), name)
            if not (inside and path.is_file()):
                raise InputError("is not a file that trajopt wrote; make the folder again", file=str(path))
            if path.stat().st_size > most:
                bound = MOST_RECORD if name == RUN else MOST_BYTES
                message = f"is too large: of {'run.json' if name == RUN else 'all files together'} at most"
                raise InputError(f"{message} {bound // 10**6} MB are read", file=str(path))
    return read_bytes(path)


def _check_plain(folder: Path) -> None:
    """What the folder keeps of its inputs is read by names that stand in these inputs. So no link may lead out of it
    there, and nothing lie there that has no end."""
    with _reading(folder):
        for place, folders, files in os.walk(folder / INPUT):
            for path in (Path(place, name) for name in (*folders, *files)):
                mode = path.lstat().st_mode
                if not (S_ISREG(mode) or S_ISDIR(mode)):
                    raise InputError("is not a file that trajopt wrote; make the folder again", file=str(path))


def _identity(folder: Path) -> tuple[int, ...] | None:
    """What tells a folder from one that has taken its name, and maybe its number; None where there is none."""
    try:
        found = os.stat(folder)
    except OSError:
        return None
    return found.st_dev, found.st_ino, found.st_mtime_ns, found.st_ctime_ns


@contextmanager
def _reading(path: Path) -> Iterator[None]:
    """What the system refuses inside is told in one line about path."""
    try:
        yield
    except OSError as error:
        raise InputError(f"cannot read: {error.strerror}", file=str(path)) from error
