"""Several files that change together: all of them or none, whenever the process is killed.

A journal stands beside the files as long as they change: what each was and becomes, by its hash. Whoever finds one
whose process is gone puts the files back. It is believed only as far as its own folder and the hashes go.
"""

from __future__ import annotations

import errno
import json
import os
import re
import secrets
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from hashlib import sha256
from pathlib import Path, PurePosixPath
from stat import S_ISREG
from time import monotonic, sleep

from trajopt_cli.errors import InputError
from trajopt_cli.runs.files import PATIENCE, discard, fill, is_named, locked, said_of, sync

JOURNAL = ".trajopt-unfinished"
_DONE = b"done\n"  # behind the journal: what it was about has happened
_MOST = 20_000_000  # bytes of a journal
_ASIDE = re.compile(r"\.(?P<name>.+)\.trajopt-[0-9a-f]{8}\.(new|old)")
_BACKUP = re.compile(r"(?P<name>.+)\.bak\d*")


@dataclass(frozen=True)
class _Change:
    """A file that changes: the hash of what it was, None where there was none, and of what it becomes; what stands
    beside it meanwhile. Names are relative to the journal's folder."""

    name: str
    was: str | None
    becomes: str
    part: str
    backup: str | None

    def refused(self) -> bool:
        """Whether a journal of ours cannot say this: everything lies in one folder, at or below the journal's."""
        path = PurePosixPath(self.name)
        inside = not path.is_absolute() and ".." not in path.parts and bool(path.name)
        part = _ASIDE.fullmatch(PurePosixPath(self.part).name)
        backup = PurePosixPath(self.backup or self.part).name
        kept = _ASIDE.fullmatch(backup) or _BACKUP.fullmatch(backup)
        beside = all(PurePosixPath(one).parent == path.parent for one in (self.part, self.backup or self.part))
        named = part is not None and kept is not None and part["name"] == kept["name"] == path.name
        return not (inside and beside and named)


def replace_files(wanted: Mapping[Path, tuple[bytes, bytes]], added: Mapping[Path, bytes]) -> dict[Path, Path]:
    """Give every file of wanted its new content and add the new files: all of it, or nothing.

    wanted: by path, the content a file must have now and the one it shall get. Returns where the old ones are kept:
    beside each file that changes, as NAME.bak, or NAME.bak2 and so on where that is taken. Symbolic links are followed,
    mode bits kept. added: files that must not exist; missing parent folders are made. Raises InputError, with every
    file as it was, where one has another content, an added one exists, or a place cannot be written. After a kill in
    between put_back() makes everything what it was.
    """
    for path, (old, _) in wanted.items():
        with said_of(path):
            if path.read_bytes() != old:
                raise InputError("is not what it was any more; nothing is written", file=str(path))
    places = {Path(os.path.realpath(path)): pair for path, pair in wanted.items() if pair[0] != pair[1]}
    for path in added:
        if os.path.lexists(path):
            raise InputError("cannot write: File exists", file=str(path))
        with said_of(path):
            path.parent.mkdir(parents=True, exist_ok=True)
    fresh = {Path(os.path.realpath(path.parent)) / path.name: (None, content) for path, content in added.items()}
    kept = _change({**places, **fresh}, {path: _free_name(path) for path in places})
    found = {path: kept.get(Path(os.path.realpath(path))) for path in wanted}
    return {path: backup for path, backup in found.items() if backup is not None}


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write files by name into folder, which is made where it is missing, as write_together does; nothing else in it is
    touched."""
    with said_of(folder):
        folder.mkdir(parents=True, exist_ok=True)
    write_together({folder / name: content for name, content in files.items()})


def write_together(files: Mapping[Path, bytes]) -> None:
    """Write files over what has their names: all of them or none. Missing parent folders are made. Raises InputError,
    with everything as it was, where a place cannot be written."""
    put_back(files)
    changes: dict[Path, tuple[bytes | None, bytes]] = {}
    for given, content in files.items():
        path = Path(os.path.realpath(given))
        with said_of(given):
            path.parent.mkdir(parents=True, exist_ok=True)
            if path.exists() and not path.is_file():
                raise InputError("is no file, and is not written over; move it away", file=str(given))
            old = path.read_bytes() if path.exists() else None
        if old != content:
            changes[path] = (old, content)
    _change(changes, {})


def put_back(paths: Iterable[Path]) -> list[str]:
    """Undo what killed calls of replace_files and write_files left half-done of these files; a line on each such call.

    Raises InputError where a living process is still at it, or something cannot be put back.
    """
    told = []
    real = [Path(os.path.realpath(path)) for path in paths]
    for folder in dict.fromkeys(above for path in real for above in path.parents):
        if os.path.lexists(folder / JOURNAL):
            told += _settle(folder, real)
    return told


def _change(wanted: Mapping[Path, tuple[bytes | None, bytes]], backups: Mapping[Path, Path]) -> dict[Path, Path]:
    """Change files, by their real paths, from what they hold to what they shall. backups: where the old ones stay, by
    path; of others they are gone."""
    if not wanted:
        return {}
    folder = Path(os.path.commonpath([path.parent for path in wanted]))
    changes = [_planned(path, old, new, backups.get(path), folder) for path, (old, new) in wanted.items()]
    with _journal(folder, changes) as journal:
        try:
            for (path, (old, new)), change in zip(wanted.items(), changes, strict=True):
                with said_of(path):
                    _prepare(folder, change, old, new)
            for path, change in zip(wanted, changes, strict=True):
                with said_of(path):
                    _give(folder, path, change)
            with said_of(folder):
                journal.done()
        except BaseException:  # Ctrl-C too: all files or none, then it goes on
            journal.not_done()
            for path, change in zip(wanted, changes, strict=True):
                with said_of(path):
                    _undo(folder, change)
            journal.remove()
            raise
        for change in changes:
            _clear(folder, change)
        journal.remove()
    return dict(backups)


def _planned(path: Path, old: bytes | None, new: bytes, backup: Path | None, folder: Path) -> _Change:
    aside = path.with_name(f".{path.name}.trajopt-{secrets.token_hex(4)}")
    kept = None if old is None else backup or aside.with_name(f"{aside.name}.old")
    names = (path, aside.with_name(f"{aside.name}.new"), kept)
    name, part, keep = (None if one is None else one.relative_to(folder).as_posix() for one in names)
    assert name is not None
    assert part is not None
    return _Change(name, None if old is None else sha256(old).hexdigest(), sha256(new).hexdigest(), part, keep)


def _prepare(folder: Path, change: _Change, old: bytes | None, new: bytes) -> None:
    """Write the new content, and the old one once more, under names of their own."""
    path = folder / change.name
    mode = None if old is None else path.stat()
    for name, content in ((change.part, new), (change.backup, old)):
        if name is not None and content is not None:
            with open(folder / name, "xb") as file:
                fill(file, content)
            if mode is not None:
                os.chmod(folder / name, mode.st_mode & 0o7777)
    if mode is not None and change.backup is not None:
        os.utime(folder / change.backup, ns=(mode.st_atime_ns, mode.st_mtime_ns))


def _give(folder: Path, path: Path, change: _Change) -> None:
    """Let a file have its new content."""
    part = folder / change.part
    if change.was is not None:
        os.replace(part, path)
    else:
        try:
            os.link(part, path)
        except FileExistsError:
            raise
        except OSError:  # a file system without links
            if os.path.lexists(path):
                raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(path)) from None
            os.rename(part, path)
    sync(path.parent)


def _undo(folder: Path, change: _Change) -> bool:
    """Make a file what it was, at whatever step the change has ended; whether there was anything to do. Raises
    InputError where what it was is not there any more."""
    path, part = folder / change.name, folder / change.part
    backup = None if change.backup is None else folder / change.backup
    now = _digest(path)
    if change.was is None:
        ours = os.path.samefile(part, path) if now and part.exists() else now == change.becomes
        if ours and now == change.becomes:
            path.unlink()
    elif now == change.becomes:
        if backup is None or _digest(backup) != change.was:
            message = f"cannot be put back: {backup} does not hold what it was"
            raise InputError(f"{message}; to keep the files as they are, remove {folder / JOURNAL}", file=str(path))
        os.replace(backup, path)
    elif now == change.was and backup is not None and _digest(backup) is not None:
        with open(path, "rb") as whole, open(backup, "rb") as copy:
            copied = copy.read()
            ours = whole.read(len(copied)) == copied
        if ours:  # as far as it came
            backup.unlink()
    if _digest(part) is not None:
        part.unlink()
    return now == change.becomes


def _clear(folder: Path, change: _Change) -> None:
    """Remove what stands beside a changed file and is not to stay."""
    for name in (change.part, change.backup):
        if name is not None and _ASIDE.fullmatch(Path(name).name):
            discard(folder / name)


def _digest(path: Path) -> str | None:
    """Hash of a regular file; None for anything else, and where there is nothing."""
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return None
    with open(handle, "rb") as file:
        if not S_ISREG(os.fstat(handle).st_mode):
            return None
        whole = sha256()
        while block := file.read(1 << 20):
            whole.update(block)
    return whole.hexdigest()


def _free_name(path: Path) -> Path:
    """NAME.bak, NAME.bak2 and so on: the first that is not taken."""
    number = 1
    while os.path.lexists(backup := path.with_name(f"{path.name}.bak{number if number > 1 else ''}")):
        number += 1
    return backup


class _Journal:
    """An open, locked journal: what is about to change, and in the end that it has. It stays until it is removed."""

    def __init__(self, path: Path, handle: int, changes: Iterable[_Change]):
        self._path, self._handle = path, handle
        text = json.dumps({"files": [asdict(one) for one in changes]}).encode("ascii") + b"\n"
        self._size = len(text)
        try:
            self._append(text)
            sync(path.parent)
        except BaseException:  # Ctrl-C too: no half-written journal stays, then it goes on
            self.remove()
            raise

    def done(self) -> None:
        self._append(_DONE)

    def not_done(self) -> None:
        os.ftruncate(self._handle, self._size)

    def remove(self) -> None:
        discard(self._path)

    def _append(self, text: bytes) -> None:
        while text:
            text = text[os.write(self._handle, text) :]
        os.fsync(self._handle)


@contextmanager
def _journal(folder: Path, changes: Sequence[_Change]) -> Iterator[_Journal]:
    path, first = folder / JOURNAL, folder / changes[0].name
    while True:
        with said_of(first):
            try:
                handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o644)
            except FileExistsError:
                handle = -1
        if handle < 0:
            _settle(folder, None)
            continue
        try:
            if locked(handle) is False or not is_named(path, handle):  # somebody took it for a killed one's
                continue
            with said_of(first):
                journal = _Journal(path, handle, changes)
            yield journal
            return
        finally:
            os.close(handle)


def _settle(folder: Path, paths: Sequence[Path] | None) -> list[str]:
    """Undo what a journal tells, and remove it; a line on that. paths: real ones; a journal about none of them is
    left alone. None: it is in the way in any case."""
    journal = folder / JOURNAL
    until = monotonic() + PATIENCE
    while True:
        try:
            handle = os.open(journal, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
        except FileNotFoundError:
            return []
        except OSError as error:
            if paths is not None and error.errno == errno.ELOOP:
                return []  # a link: none of ours
            raise InputError(f"cannot be read: {error.strerror}; remove it", file=str(journal)) from error
        try:
            regular = S_ISREG(os.fstat(handle).st_mode)
            changes, done = _read(os.read(handle, _MOST)) if regular else ([], False)
            named = {os.path.realpath(folder / one.name) for one in changes}
            foreign = not regular or os.fstat(handle).st_uid != os.geteuid()
            if paths is not None and (named.isdisjoint(map(str, paths)) if changes else foreign):
                return []
            if foreign:
                message = "was left by another user's run, or by none; that user runs the same again, or remove it"
                raise InputError(message, file=str(journal))
            if locked(handle) is False:
                if monotonic() > until:
                    raise InputError("another run is writing here; run this again when it has ended", file=str(folder))
            elif is_named(journal, handle):
                return _settled(folder, changes, done)
        finally:
            os.close(handle)
        sleep(0.02)


def _settled(folder: Path, changes: Sequence[_Change], done: bool) -> list[str]:
    """The same of a journal whose process is gone."""
    journal, root = folder / JOURNAL, os.path.realpath(folder)
    for one in changes:
        parent = os.path.realpath(os.path.dirname(folder / one.name))
        if one.refused() or os.path.commonpath([root, parent]) != root:
            raise InputError(f"is no journal of trajopt's: {one.name!r}; remove it", file=str(journal))
    undone = []
    for one in changes:
        if done:
            _clear(folder, one)
            continue
        with said_of(folder / one.name):
            if _undo(folder, one):
                undone.append(one.name)
    with said_of(journal):
        for inner in {(folder / one.name).parent for one in changes}:
            if inner.is_dir():
                sync(inner)
        os.unlink(journal)
    if not undone:
        return []
    names = ", ".join(undone[:3]) + (f" and {len(undone) - 3} more" if len(undone) > 3 else "")
    return [f"{folder}: a run that wrote here was killed half-way; put back as before it: {names}"]


def _read(text: bytes) -> tuple[list[_Change], bool]:
    """What a journal tells, and whether that is done. Nothing where it is not whole: then nothing has begun."""
    line, end, rest = text.partition(b"\n")
    if not end:
        return [], False
    try:
        files = json.loads(line)["files"]
        changes = [_Change(*(one[key] for key in ("name", "was", "becomes", "part", "backup"))) for one in files]
        for one in changes:
            for key, value in asdict(one).items():
                if not (value is None and key in ("was", "backup")) and b"\0" in os.fsencode(value):
                    return [], False
    except (ValueError, TypeError, KeyError, RecursionError):
        return [], False
    return changes, rest == _DONE
