"""The RAPID modules of a results folder: what they change, and how they are put over the user's own."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from trajopt_cli.errors import InputError
from trajopt_cli.files import replace_files
from trajopt_cli.runs.folder import read_bytes
from trajopt_cli.runs.results import read_results


@dataclass(frozen=True)
class RapidFile:
    """A module with the rapid plan in it. path: as the user gave it, or beside the program for a new one. place: in a
    folder of them all. given: the module as it was, None for a new one."""

    path: Path
    place: Path
    content: bytes
    given: bytes | None


@dataclass(frozen=True)
class RapidFiles:
    """The optimised modules of a results folder. patch: their difference from the program as given, for patch -p1;
    difference: the same to read. kept: what the plan had to leave as programmed, and why.
    """

    modules: tuple[RapidFile, ...]
    patch: bytes
    difference: str
    kept: tuple[str, ...] = ()


def rapid_export(folder: Path) -> RapidFiles:
    """The optimised modules of a results folder. Raises InputError where the plan could not be written as RAPID."""
    from trajopt_cli.export.rapid_diff import patch, unified_diff
    from trajopt_cli.export.rapid_writable import KEPT
    from trajopt_cli.rapid.language.text import read_text

    results = read_results(folder)
    if results.no_rapid is not None:
        raise InputError(f"holds no RAPID text: {results.no_rapid}", file=str(folder))
    given = {path: replace(read_text(copy), path=path) for path, copy, _ in results.rapid}
    contents = {path: place.read_bytes() for path, _, place in results.rapid}
    texts = {path: content.decode(given[path].encoding) for path, content in contents.items()}
    new = {path: replace(read_text(place), path=path) for path, place in results.added}
    modules = [
        RapidFile(Path(path), place.relative_to(folder), contents[path], copy.read_bytes())
        for path, copy, place in results.rapid
    ]
    modules += [
        RapidFile(Path(path), place.relative_to(folder), place.read_bytes(), None) for path, place in results.added
    ]
    kept = tuple(note for note in results.notes if note.startswith(KEPT))
    if len(modules) > 1:
        modules = [replace(one, place=_inside_program(one)) for one in modules]
    return RapidFiles(tuple(modules), patch(given, texts, new), unified_diff(given, texts, new), kept)


def _inside_program(module: RapidFile) -> Path:
    """A module's place without the folder program/; program.mod alone is called as the user calls it."""
    return Path(*module.place.parts[1:]) if len(module.place.parts) > 1 else Path(module.path.name)


def write_in_place(modules: Sequence[RapidFile]) -> dict[Path, Path]:
    """Write the optimised modules over the user's own; where each old one is kept, by its path.

    Raises InputError, with every file as it was, where one is not what the results were made from, a new module's name
    is taken, or a place cannot be written.
    """
    for one in modules:
        if one.given is None:
            if os.path.lexists(one.path):
                raise InputError("is a new module of the plan, and the name is taken; move it away", file=str(one.path))
        elif read_bytes(one.path) != one.given:
            raise InputError(
                "is not the file that the results were made from; run trajopt optimize again", file=str(one.path)
            )
    wanted = {one.path: (one.given, one.content) for one in modules if one.given is not None}
    return replace_files(wanted, {one.path: one.content for one in modules if one.given is None})
