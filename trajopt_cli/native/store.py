"""A folder of the user's that keeps what takes long to make, and may be lost at any time.

An entry is one file: a digest of its key and content, then the content. Whatever is damaged, cut off or foreign has
another digest and counts as absent. Files are written aside and then renamed, so that processes do not meet half ones.
What is kept is run as machine code, so a folder that others may write to is not used: digests are against accidents.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import fields, is_dataclass
from enum import Enum
from errno import EACCES, ENOENT
from io import BytesIO
from pathlib import Path
from tempfile import NamedTemporaryFile

import numpy as np
import platformdirs
from numpy.typing import NDArray

MOST_BYTES = 100_000_000  # in all; the blocks of a robot and its mount take 2 to 4 MB. Read longest ago goes first.
_SUFFIX, _PART = ".block", ".part"


class Store:
    """Named arrays by key. trouble: what keeps it from writing, None while nothing does."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.trouble: str | None = None

    def read(self, key: str) -> dict[str, NDArray[np.generic]] | None:
        """The arrays under a key, None where there are none that can be used. They count as new from then on."""
        try:
            self._check_own()
            content = self._file(key).read_bytes()
            with suppress(OSError):  # where nothing can be written they are read all the same
                os.utime(self._file(key))
        except OSError:
            return None
        digest, body = content[:32], content[32:]
        if digest != _digest(key, body):
            return None
        with np.load(BytesIO(body), allow_pickle=False) as found:
            return dict(found)

    def write(self, key: str, arrays: Mapping[str, NDArray[np.generic]]) -> None:
        """Keep arrays under a key; where that is not possible, trouble says why."""
        packed = BytesIO()
        np.savez(packed, **arrays)  # type: ignore[arg-type]
        body = packed.getvalue()
        try:
            self._begin()
            self._make_room(len(body))
            with NamedTemporaryFile(dir=self.folder, suffix=_PART, delete=False) as aside:
                fcntl.flock(aside, fcntl.LOCK_EX)  # as long as this process lives
                aside.write(_digest(key, body) + body)
                aside.flush()
                os.replace(aside.name, self._file(key))
        except OSError as error:
            self.trouble = f"{self.folder}: {error.strerror}"

    def _file(self, key: str) -> Path:
        return self.folder / (hashlib.sha256(key.encode()).hexdigest()[:32] + _SUFFIX)

    def _begin(self) -> None:
        """Make the folder. Raise OSError where that, or using it, is not possible."""
        if not self.folder.is_absolute():
            raise FileNotFoundError(ENOENT, "the user has no home folder")
        self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self._check_own()

    def _check_own(self) -> None:
        """Raise OSError unless the folder is this user's, and nobody else may write to it."""
        found = self.folder.stat()
        if found.st_uid != os.geteuid() or found.st_mode & 0o022:
            raise PermissionError(EACCES, "others may write there, and what is kept is run as code")

    def _make_room(self, more: int) -> None:
        """Remove what killed processes left, and the files not read for longest until there is room for more bytes."""
        files = []
        for file in self.folder.iterdir():
            with suppress(FileNotFoundError):  # another process makes room, too
                if file.suffix == _SUFFIX:
                    files.append((file.stat().st_mtime, file.stat().st_size, file))
                elif file.suffix == _PART:
                    with open(file, "rb") as part, suppress(BlockingIOError):  # a living one writes it
                        fcntl.flock(part, fcntl.LOCK_EX | fcntl.LOCK_NB)
                        file.unlink()
        total = more + sum(size for _, size, _ in files)
        for _, size, file in sorted(files):
            if total <= MOST_BYTES:
                return
            file.unlink(missing_ok=True)
            total -= size


def users_store() -> Store:
    """The one in the user's cache folder."""
    return Store(platformdirs.user_cache_path("trajopt"))


def _digest(key: str, body: bytes) -> bytes:
    return hashlib.sha256(len(key).to_bytes(8, "big") + key.encode() + body).digest()


def exact(value: object) -> str:
    """A text that is equal for equal data only: numbers to the last bit, the content of files for their paths.

    Raises TypeError for what is not plain data.
    """
    match value:
        case None | bool() | int() | float() | str() | bytes() | slice():
            return repr(value)
        case Enum():
            return str(value)
        case np.ndarray():
            return f"{value.shape}{value.dtype}{hashlib.sha256(value.tobytes()).hexdigest()}"
        case Path():
            return hashlib.sha256(value.read_bytes()).hexdigest()
        case Mapping():
            return f"{{{','.join(sorted(f'{exact(name)}:{exact(one)}' for name, one in value.items()))}}}"
        case tuple() | list():
            return f"({','.join(exact(one) for one in value)})"
    if is_dataclass(value):
        parts = (f"{field.name}={exact(getattr(value, field.name))}" for field in fields(value))
        return f"{type(value).__qualname__}({','.join(parts)})"
    raise TypeError(f"{type(value).__qualname__} is no plain data")
