"""Files and folders that appear whole or not at all. No project imports but errors."""

from __future__ import annotations

import ctypes
import errno
import fcntl
import glob
import os
import secrets
import shutil
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from io import BufferedRandom
from pathlib import Path
from tempfile import TemporaryFile

from trajopt_cli.errors import InputError
from trajopt_cli.runs import RUN

_AT_FDCWD, _RENAME_EXCHANGE = -100, 2  # linux/fcntl.h, linux/fs.h


def write_file(path: Path, content: bytes) -> None:
    """Write a file so that path holds its old content or all of the new one, whenever the process is killed.

    Missing parent folders are made. Raises InputError where the place cannot be written.
    """
    path = Path(os.path.realpath(path))
    part = path.with_name(f"{_prefix(path)}{secrets.token_hex(4)}")
    with _said(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            _write(part, content)
            os.replace(part, path)
            _sync(path.parent)
        finally:
            _discard(part)


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
    if real.exists() and any((folder / RUN).is_file() for folder in (*real.parents[:2],)):
        raise InputError("is a file of a results folder, which keeps its hash; write to another place", file=str(path))
    part = real.with_name(f"{_prefix(real)}{secrets.token_hex(4)}")
    try:
        part.touch(exist_ok=False)
        part.unlink()
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
    with _said(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        fresh = path.with_name(f"{_prefix(path)}{secrets.token_hex(4)}")
        fresh.mkdir()
        lock = os.open(fresh, os.O_RDONLY)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            _fill(fresh, files)
            _swap(fresh, path)
            _sync(path.parent)
        finally:
            os.close(lock)
            shutil.rmtree(fresh, ignore_errors=True)  # the old folder after the swap; the half-made one before it


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write files by name into folder, which is made where it is missing; nothing else in it is touched.

    Each file is whole or not there. Raises InputError where the folder cannot be made or written.
    """
    with _said(folder):
        folder.mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        write_file(folder / name, content)


def replace_files(wanted: Mapping[Path, tuple[bytes, bytes]], added: Mapping[Path, bytes]) -> dict[Path, Path]:
    """Give every file of wanted its new content and add the new files: all of it, or nothing.

    wanted: by path, the content a file must have now and the one it shall get. Returns where the old ones are kept:
    beside each file that changes, as NAME.bak, or NAME.bak2 and so on where that is taken. Symbolic links are followed,
    mode bits kept. added: files that must not exist. Raises InputError, with everything as it was, where a file has
    another content, an added one exists, or a place cannot be written. Each file is whole at every moment; a kill in
    between leaves some of them old and some new, and every backup.
    """
    places = {Path(os.path.realpath(path)): pair for path, pair in wanted.items()}
    for path, (old, _) in wanted.items():
        with _said(path):
            if path.read_bytes() != old:
                raise InputError("is not what it was any more; nothing is written", file=str(path))
    backups: dict[Path, Path] = {}
    parts: dict[Path, Path] = {}
    replaced: list[Path] = []
    made: list[Path] = []
    try:
        for path, (old, new) in places.items():
            if old != new:
                with _said(path):
                    parts[path] = path.with_name(f"{_prefix(path)}{secrets.token_hex(4)}")
                    _write(parts[path], new)
                    parts[path].chmod(path.stat().st_mode & 0o7777)
                    backups[path] = _keep(path, old)
        for path, content in added.items():
            with _said(path):
                parts[path] = path.with_name(f"{_prefix(path)}{secrets.token_hex(4)}")
                _write(parts[path], content)
                _give_name(parts.pop(path), path)
                made.append(path)
        for path, part in parts.items():
            with _said(path):
                os.replace(part, path)
                replaced.append(path)
                _sync(path.parent)
    except BaseException:  # Ctrl-C too: all files or none, then it goes on
        for path in made:
            with _said(path):
                path.unlink()
        for path, backup in backups.items():
            with _said(path):
                if path in replaced:
                    os.replace(backup, path)
                else:
                    backup.unlink()
        raise
    finally:
        for part in parts.values():
            _discard(part)
    kept = {path: backups.get(Path(os.path.realpath(path))) for path in wanted}
    return {path: backup for path, backup in kept.items() if backup is not None}


def check_writable(path: Path, into: bool = False) -> None:
    """Before the work: raise InputError unless a file or folder of this name could be made, or files be written into a
    folder of this name. Missing parents stand in nobody's way, a file among them does. A nameless file is made and goes
    again: rights alone do not tell of disks that are read-only."""
    full = Path(os.path.realpath(path))
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
    with _said(path):
        (path.parent / f"{_prefix(path)}{'0' * 8}.old").exists()  # a name too long for its neighbours is said at once
        for aside in sorted(path.parent.glob(f"{mark}????????.old")):
            partner = aside.with_suffix("")
            if partner.exists() and _locked(partner):
                continue
            if path.exists():
                shutil.rmtree(aside)
            else:
                os.rename(aside, path)
        for leftover in path.parent.glob(f"{mark}????????"):
            if leftover.is_dir() and not leftover.is_symlink() and not _locked(leftover):
                shutil.rmtree(leftover)


@contextmanager
def _said(path: Path) -> Iterator[None]:
    """What the system refuses inside is told in one line about path."""
    try:
        yield
    except OSError as error:
        where = "" if error.errno == errno.ENAMETOOLONG or error.filename is None else f": {error.filename}"
        raise InputError(f"cannot write: {error.strerror}{where}", file=str(path)) from error


def _discard(part: Path) -> None:
    """Remove a half-made file, if there is one."""
    with suppress(OSError):  # a read-only disk refuses even where there is nothing; what went wrong before is the news
        part.unlink()


def _prefix(path: Path) -> str:
    return f".{path.name}.trajopt-"


def _locked(folder: Path) -> bool:
    """Whether a living process holds the folder; the lock goes with its process, so a killed one's folder is free."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    finally:
        os.close(handle)
    return False


def _fill(folder: Path, files: Mapping[str, bytes | BufferedRandom]) -> None:
    for name, content in files.items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        _write(place, content)
    for inner in (*folder.rglob("*"), folder):
        if inner.is_dir():
            _sync(inner)


def _write(path: Path, content: bytes | BufferedRandom) -> None:
    with open(path, "xb") as file:
        if isinstance(content, bytes):
            file.write(content)
        else:
            content.seek(0)
            shutil.copyfileobj(content, file)
        file.flush()
        os.fsync(file.fileno())


def _sync(folder: Path) -> None:
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _swap(fresh: Path, path: Path) -> None:
    """Give fresh the name path; what was there stands under fresh's name afterwards, or is gone."""
    if not path.exists():
        os.rename(fresh, path)
    elif not _exchange(fresh, path):
        aside = fresh.with_name(fresh.name + ".old")
        os.rename(path, aside)
        try:
            os.rename(fresh, path)
        except OSError:
            os.rename(aside, path)
            raise
        shutil.rmtree(aside)


def _exchange(one: Path, other: Path) -> bool:
    """Swap two names in one step (renameat2 of Linux 3.15 and glibc 2.28). False where that cannot be done here."""
    if sys.platform != "linux":
        return False
    libc = ctypes.CDLL(None, use_errno=True)
    with suppress(AttributeError):
        names = os.fsencode(one), os.fsencode(other)
        return bool(libc.renameat2(_AT_FDCWD, names[0], _AT_FDCWD, names[1], _RENAME_EXCHANGE) == 0)
    return False


def _keep(path: Path, content: bytes) -> Path:
    """A copy of a file beside it, under a name that is not taken yet."""
    number = 1
    while True:
        backup = path.with_name(f"{path.name}.bak{number if number > 1 else ''}")
        try:
            _write(backup, content)
        except FileExistsError:
            number += 1
            continue
        except BaseException:  # Ctrl-C too leaves no half of a copy
            _discard(backup)
            raise
        shutil.copystat(path, backup)
        return backup


def _give_name(part: Path, path: Path) -> None:
    """Name a finished file path; FileExistsError where there is something of that name."""
    try:
        os.link(part, path)
    except FileExistsError:
        raise
    except OSError:  # a file system without links
        if os.path.lexists(path):
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(path)) from None
        os.rename(part, path)
    finally:
        _discard(part)
