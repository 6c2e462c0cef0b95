"""Files beside the ones that were given: do they declare what those lack?"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.entry import NoEntry
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.rapid.sources import is_module

_MAX_FILES, _MAX_BYTES = 200, 10_000_000  # looked at for a hint; an error must not take longer than the program
_NAME = re.compile(r"[^\W\d]\w*")
_DECLARED = r"\b(?:(?:VAR|PERS|CONST|FUNC|ALIAS)\s+\w+|PROC|RECORD)\s+%s\b"


def with_hints(error: InputError, files: Sequence[TextFile], entry: str) -> InputError:
    """The error, each of its lines with the module near the given files that declares the name it stands at."""
    errors = error.errors if isinstance(error, InputErrorGroup) else (error,)
    beside = _Beside(files)
    hinted = [_hinted(one, beside, entry) for one in errors]
    if all(new is old for new, old in zip(hinted, errors, strict=True)):
        return error
    return InputErrorGroup(hinted) if len(hinted) > 1 else hinted[0]


def _hinted(error: InputError, beside: _Beside, entry: str) -> InputError:
    name = entry if isinstance(error, NoEntry) else beside.name_at(error)
    place = name and beside.declaring(name)
    if not place:
        return error
    message = f"{error.message}; {place} declares {name}: give the folder {beside.folder(place)} instead"
    return InputError(message, file=error.file, line=error.line, column=error.column, excerpt=error.excerpt)


class _Beside:
    """The modules in the folders of the given files, and in SYSMOD beside PROGMOD; read when first asked for."""

    def __init__(self, files: Sequence[TextFile]):
        self._given = {file.path: file.text for file in files}
        self._texts: dict[Path, str] | None = None

    def name_at(self, error: InputError) -> str | None:
        """The name that stands at an error's place, unless the given files declare it."""
        text = self._given.get(error.file or "")
        if text is None or not error.line or not error.column:
            return None
        lines = re.split(r"\r\n|\r|\n", text)
        match = _NAME.match(lines[error.line - 1], error.column - 1) if error.line <= len(lines) else None
        if match is None or any(_declares(text, match[0]) for text in self._given.values()):
            return None
        return match[0]

    def declaring(self, name: str) -> Path | None:
        """The module that declares a name, if exactly one does."""
        if self._texts is None:
            self._texts = dict(self._read())
        found = [path for path, text in self._texts.items() if _declares(text, name)]
        return found[0] if len(found) == 1 else None

    def folder(self, place: Path) -> Path:
        """The folder that holds the given files and place: the task's where they lie in PROGMOD and SYSMOD."""
        own = {Path(path).parent for path in self._given}
        return place.parent if place.parent in own else place.parent.parent

    def _read(self) -> Iterator[tuple[Path, str]]:
        given = {Path(path) for path in self._given}
        folders = {path.parent: None for path in given}
        for folder in [*folders]:
            if folder.name.lower() in ("progmod", "sysmod"):
                folders |= {other: None for other in _entries(folder.parent) if other.name.lower() in _TASK_FOLDERS}
        size = 0
        places = [path for folder in folders for path in _entries(folder) if is_module(path) and path not in given]
        for path in places[:_MAX_FILES]:
            try:
                size += path.stat().st_size if path.is_file() else 0
                if path.is_file() and size <= _MAX_BYTES:
                    yield path, decode(path.read_bytes())[0]
            except OSError:
                continue  # a hint that cannot be had is none; the error itself is told


_TASK_FOLDERS = ("progmod", "sysmod")


def _entries(folder: Path) -> list[Path]:
    try:
        return sorted(folder.iterdir())
    except OSError:
        return []  # as above


def _declares(text: str, name: str) -> bool:
    return re.search(_DECLARED % re.escape(name), text, re.IGNORECASE) is not None
