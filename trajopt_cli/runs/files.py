"""Files and folders that appear whole or not at all. No project imports but errors."""

from __future__ import annotations

import ctypes
import errno
import fcntl
import glob
import os
import re
import secrets
import shutil
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from io import BufferedRandom
from pathlib import Path
from tempfile import TemporaryFile
from time import monotonic, sleep
from typing import BinaryIO

from trajopt_cli.errors import InputError
from trajopt_cli.runs import EXPORTS, RUN

PATIENCE = 10.0  # s, to wait for another run that is writing just now
_TRIES = 100
_LEFT = re.compile(r"\..+\.trajopt-[0-9a-f]{8}(\.old)?")
_THERE = (errno.ENOTEMPTY, errno.EEXIST)
_AT_FDCWD, _RENAME_EXCHANGE = -100, 2  # linux/fcntl.h, linux/fs.h


def write_file(path: Path, content: bytes | Iterable[bytes]) -> None:
    """Write a file so that path holds its old content or all of the new one, whenever the process is killed. content:
    or its parts one after the other, made while they are written.

    Missing parent folders are made. Raises InputError where the place cannot be written.
    """
    path = Path(os.path.realpath(path))
    with said_of(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        _tidy(path)
        with _part(path) as (part, file):
            fill(file, content)
            os.replace(part, path)
            sync(path.parent)


def check_file(path: Path, option: str = "--output") -> None:
    """Before any work: a file can be written here, by trying one under another name. option: what named it.

    Raises InputError for a folder or a device, for a folder to hold it that is none, and for what the system refuses.
    """
    if path.is_dir():
        raise InputError(f"is a folder; {option} names a file", file=str(path))
    if path.exists() and not path.is_file():
        raise InputError(f"is no file; {option} names one", file=str(path))
    real = Path(os.path.realpath(path))
    if not real.parent.is_dir():
        raise InputError(f"is not a folder to write to; make it or correct {option}", file=str(path.parent))
    if real.exists() and real.name not in EXPORTS and any((folder / RUN).is_file() for folder in (*real.parents[:2],)):
        raise InputError("is a file of a results folder, which keeps its hash; write to another place", file=str(path))
    try:
        _tidy(real)
        with _part(real):
            pass
    except OSError as error:
        raise InputError(f"cannot write: {error.strerror}", file=str(path)) from error


def write_folder(path: Path, files: Mapping[str, bytes | BufferedRandom]) -> None:
    """Make path a folder that holds exactly files, or leave it as it was. files: relative name to content, or an open
    file that holds it.

    A folder already there is replaced, whatever it holds: ask before. The new folder is written beside it, brought to
    the disk, and takes its name in one step of the file system (an exchange of two names on Linux). Where the file
    system cannot exchange, two renames do it; a kill between them leaves the old folder under a name that the next
    call, or recover(), gives back. Raises InputError where the place cannot be written.
    """
    path = Path(os.path.realpath(path))
    recover(path)
    with said_of(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        fresh, lock = _fresh(path)
        try:
            _fill(fresh, files)
            _swap(fresh, path)
            sync(path.parent)
        finally:
            os.close(lock)
            shutil.rmtree(fresh, ignore_errors=True)  # the old folder after the swap; the half-made one before it


def check_writable(path: Path, into: bool = False) -> None:
    """Before the work: raise InputError unless a file or folder of this name could be made, or files be written into a
    folder of this name. Missing parents stand in nobody's way, a file among them does. A nameless file is made and goes
    again: rights alone do not tell of disks that are read-only."""
    full = Path(os.path.realpath(path))
    if full == full.parent:
        raise InputError("is the whole file system; choose a folder in it", file=str(path))
    try:
        place = next(one for one in ((full, *full.parents) if into else full.parents) if one.exists())
        if not place.is_dir():
            raise InputError("is a file, and no folder to write to; choose another place", file=str(place))
        with TemporaryFile(dir=place):
            pass
    except OSError as error:
        raise InputError(f"cannot write: {error.strerror}", file=str(path)) from error


def recover(path: Path) -> None:
    """Tidy up after calls of write_folder(path) that were killed; calls still running are left alone.

    Half-made folders beside path are removed. A folder set aside by an interrupted pair of renames goes back to path,
    or is removed where path exists. Only names that write_folder makes, in path's own folder, are looked at.
    Raises InputError where the place cannot be written.
    """
    path = Path(os.path.realpath(path))
    mark = glob.escape(_prefix(path))
    with said_of(path):
        (path.parent / f"{_prefix(path)}{'0' * 8}.old").exists()  # a name too long for its neighbours is said at once
        for aside in sorted(path.parent.glob(f"{mark}????????.old")):
            with _free(aside.with_suffix("")) as free:
                if not free:
                    continue
                if path.exists():
                    shutil.rmtree(aside, ignore_errors=True)
                else:
                    with _unless_there():
                        os.rename(aside, path)
        for leftover in path.parent.glob(f"{mark}????????"):
            if leftover.is_dir() and not leftover.is_symlink():
                with _free(leftover) as free:
                    if free:
                        shutil.rmtree(leftover, ignore_errors=True)  # another process may be at it, too


def leftovers(folder: Path) -> list[Path]:
    """What killed runs left in a folder, hidden: half-made files and folders, folders set aside. What a living run
    holds is none; what cannot be opened is none of this user's."""
    out = []
    for path in sorted(folder.glob(".*.trajopt-*")):
        with suppress(OSError):
            if _LEFT.fullmatch(path.name):
                with _free(path.with_suffix("") if path.suffix == ".old" else path) as free:
                    out += [path] if free else []
    return out


@contextmanager
def holding(folder: Path) -> Iterator[None]:
    """Nobody else who holds this folder writes it meanwhile. Raises InputError where another run does not let go."""
    folder, until = Path(os.path.realpath(folder)), monotonic() + PATIENCE
    while folder.is_dir():
        with said_of(folder):
            handle = os.open(folder, os.O_RDONLY)
        try:
            if locked(handle) is not False:
                if is_named(folder, handle):  # and not what another run has put aside
                    yield
                    return
            elif monotonic() > until:
                raise InputError("another run is writing it; run this again when that has ended", file=str(folder))
        finally:
            os.close(handle)
        sleep(0.01)
    yield


@contextmanager
def said_of(path: Path) -> Iterator[None]:
    """What the system refuses inside is told in one line about path."""
    try:
        yield
    except OSError as error:
        where = "" if error.errno == errno.ENAMETOOLONG or error.filename is None else f": {error.filename}"
        raise InputError(f"cannot write: {error.strerror}{where}", file=str(path)) from error


def fill(file: BinaryIO, content: bytes | BufferedRandom | Iterable[bytes]) -> None:
    """Write content, or its parts, into an open file, down to the disk."""
    if isinstance(content, bytes):
        file.write(content)
    elif isinstance(content, BufferedRandom):
        content.seek(0)
        shutil.copyfileobj(content, file)
    else:
        file.writelines(content)
    file.flush()
    os.fsync(file.fileno())


def sync(folder: Path) -> None:
    """Bring the names in a folder to the disk."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def discard(part: Path) -> None:
    """Remove a half-made file, if there is one."""
    with suppress(OSError):  # a read-only disk refuses even where there is nothing; what went wrong before is the news
        part.unlink()


def locked(handle: int) -> bool | None:
    """Whether this process may have an open file or folder alone, and has it from now on until it is closed; None where
    the file system knows no locks. A lock goes with its process, so that what a killed one leaves is free."""
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return None
    return True


def _prefix(path: Path) -> str:
    return f".{path.name}.trajopt-"


def is_named(path: Path, handle: int) -> bool:
    """Whether path is the name of an open file or folder."""
    try:
        found = os.stat(path, follow_symlinks=False)
    except FileNotFoundError:
        return False
    return os.path.samestat(found, os.fstat(handle))


@contextmanager
def _part(path: Path) -> Iterator[tuple[Path, BinaryIO]]:
    """A new file beside path, locked, that is to get its name; removed at the end if it has not."""
    while True:
        part = path.with_name(f"{_prefix(path)}{secrets.token_hex(4)}")
        try:
            with open(part, "xb") as file:
                locked(file.fileno())
                if not is_named(part, file.fileno()):  # another run took it for a killed one's before it was locked
                    continue
                yield part, file
                return
        finally:
            discard(part)


def _fresh(path: Path) -> tuple[Path, int]:
    """A new folder beside path, and the open handle that locks it."""
    while True:
        fresh = path.with_name(f"{_prefix(path)}{secrets.token_hex(4)}")
        fresh.mkdir()
        with suppress(FileNotFoundError):  # another run took it for a killed one's before it was locked
            handle = os.open(fresh, os.O_RDONLY)
            locked(handle)
            if is_named(fresh, handle):
                return fresh, handle
            os.close(handle)


def _tidy(path: Path) -> None:
    """Remove what killed calls of write_file(path) left beside it."""
    for leftover in path.parent.glob(f"{glob.escape(_prefix(path))}????????"):
        if leftover.is_file() and not leftover.is_symlink():
            with _free(leftover) as free:
                if free:
                    discard(leftover)


@contextmanager
def _free(place: Path) -> Iterator[bool]:
    """Whether no living process holds place, or it is gone; no other one can as long as this lasts."""
    try:
        handle = os.open(place, os.O_RDONLY | os.O_NONBLOCK)
    except FileNotFoundError:
        yield True
        return
    try:
        yield locked(handle) is True
    finally:
        os.close(handle)


def _fill(folder: Path, files: Mapping[str, bytes | BufferedRandom]) -> None:
    for name, content in files.items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        with open(place, "xb") as file:
            fill(file, content)
    for inner in (*folder.rglob("*"), folder):
        if inner.is_dir():
            sync(inner)


def _swap(fresh: Path, path: Path) -> None:
    """Give fresh the name path; what was there stands under fresh's name afterwards, or is gone."""
    for _ in range(_TRIES):  # more than one only where another run puts its own there at this moment
        if path.exists() and _exchange(fresh, path):
            return
        with _unless_there():
            os.rename(fresh, path)  # nothing there, or an empty folder
            return
        aside = fresh.with_name(fresh.name + ".old")
        with suppress(FileNotFoundError):  # another run has just taken it away
            os.rename(path, aside)
            try:
                os.rename(fresh, path)
            except OSError as error:
                if error.errno not in _THERE:
                    os.rename(aside, path)
                    raise
            else:
                shutil.rmtree(aside, ignore_errors=True)  # recover() of another run may be at it, too
                return
            shutil.rmtree(aside, ignore_errors=True)  # another run has just put its own in its place
    raise InputError("other runs write it all the time; choose another place", file=str(path))


@contextmanager
def _unless_there() -> Iterator[None]:
    """A rename inside that finds its goal taken does nothing; nor does one that another run has done before."""
    try:
        yield
    except OSError as error:
        if error.errno not in (*_THERE, errno.ENOENT):
            raise


def _exchange(one: Path, other: Path) -> bool:
    """Swap two names in one step (renameat2 of Linux 3.15 and glibc 2.28). False where that cannot be done here."""
    if sys.platform != "linux":
        return False
    libc = ctypes.CDLL(None, use_errno=True)
    with suppress(AttributeError):
        names = os.fsencode(one), os.fsencode(other)
        return bool(libc.renameat2(_AT_FDCWD, names[0], _AT_FDCWD, names[1], _RENAME_EXCHANGE) == 0)
    return False
