"""Files beside the ones that were given: do they declare what those do not?"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.data.scope import Undeclared
from trajopt_cli.rapid.entry import NoEntry
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.rapid.sources import is_module, leads_out
from trajopt_cli.scenario import MissingError

_MAX_FILES, _MAX_BYTES = 200, 10_000_000  # looked at for a hint; an error must not take longer than the program
_NAME = re.compile(r"[^\W\d]\w*")
_TOKEN = re.compile(  # what can hold or end a declaration, and what only looks like one: comments and texts
    r'![^\r\n]*|"[^"\r\n]*"|\b(?:(?P<end>END(?:PROC|FUNC|TRAP))|(?P<local>LOCAL\s+)?(?:TASK\s+)?'
    r"(?:(?P<routine>PROC|TRAP|FUNC\s+\w+)|VAR\s+\w+|PERS\s+\w+|CONST\s+\w+|ALIAS\s+\w+|RECORD)\s+(?P<name>\w+))\b",
    re.IGNORECASE,
)
_MISSING = ("signals", "answers", "data", "assume_identity", "stubs")  # of a name that a file might declare


def with_hints(error: InputError, files: Sequence[TextFile], entry: str) -> InputError:
    """The error; of its lines those about undeclared names with the module near the given files that declares each."""
    errors = error.errors if isinstance(error, InputErrorGroup) else (error,)
    missing = error.missing if isinstance(error, MissingError) else ()
    sections = (*(one.section for one in missing), *[""] * (len(errors) - len(missing)))
    beside = _Beside(files)
    hinted = [_hinted(one, section, beside, entry) for one, section in zip(errors, sections, strict=True)]
    if all(new is old for new, old in zip(hinted, errors, strict=True)):
        return error
    return InputErrorGroup(hinted) if len(hinted) > 1 else hinted[0]


def _hinted(error: InputError, section: str, beside: _Beside, entry: str) -> InputError:
    name = None
    if isinstance(error, NoEntry):
        name = entry
    elif isinstance(error, Undeclared) or section in _MISSING:
        name = beside.name_at(error)
    place = name and beside.declaring(name)
    if not place:
        return error
    message = f"{error.message}; {place} declares {name}: give the folder {beside.folder(place)} instead"
    return error.saying(message)


class _Beside:
    """The modules in the folders of the given files, and in SYSMOD beside PROGMOD; read when first asked for."""

    def __init__(self, files: Sequence[TextFile]):
        self._given = {file.path: file.text for file in files}
        self._shared: dict[Path, set[str]] | None = None

    def name_at(self, error: InputError) -> str | None:
        """The name that stands at an error's place, unless the given files share it."""
        text = self._given.get(error.file or "")
        if text is None or not error.line or not error.column:
            return None
        lines = re.split(r"\r\n|\r|\n", text)
        match = _NAME.match(lines[error.line - 1], error.column - 1) if error.line <= len(lines) else None
        if match is None or any(match[0].lower() in _shared(text) for text in self._given.values()):
            return None
        return match[0]

    def declaring(self, name: str) -> Path | None:
        """The module that shares a name, if exactly one does."""
        if self._shared is None:
            self._shared = {path: _shared(text) for path, text in self._read()}
        found = [path for path, names in self._shared.items() if name.lower() in names]
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
        places = [path for path in places if not leads_out(path, path.parent)]
        for path in places[:_MAX_FILES]:
            try:
                size += path.stat().st_size if path.is_file() else 0
                if path.is_file() and size <= _MAX_BYTES:
                    yield path, decode(path.read_bytes())[0]
            except OSError:
                continue  # a hint that cannot be had is none; the error itself is reported


_TASK_FOLDERS = ("progmod", "sysmod")


def _entries(folder: Path) -> list[Path]:
    try:
        return sorted(folder.iterdir())
    except OSError:
        return []  # as above


def _shared(text: str) -> set[str]:
    """The names, in lower case, that a module shares with others: declared outside its routines, and not LOCAL."""
    names = set()
    inside = False
    for token in _TOKEN.finditer(text):
        if token["end"]:
            inside = False
        elif token["name"] and not inside:
            inside = token["routine"] is not None
            if not token["local"]:
                names.add(token["name"].lower())
    return names
