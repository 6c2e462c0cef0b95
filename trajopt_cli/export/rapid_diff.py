"""What an export changes, as a unified diff: for people as text, for `patch -p1` as the very bytes of the files."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import PurePath

from trajopt_cli.motion import TextFile

_NO_END = "\\ No newline at end of file\n"
_LINE = re.compile(r"[^\n]*\n|[^\n]+")


def unified_diff(files: Mapping[str, TextFile], texts: Mapping[str, str], new: Mapping[str, TextFile]) -> str:
    """A diff to read. files: as given, by path; texts: edited, by the same paths; new: modules that are added."""
    old = {path: file.text for path, file in files.items()}
    return "".join(_differences(old, texts, {path: file.text for path, file in new.items()}))


def patch(files: Mapping[str, TextFile], texts: Mapping[str, str], new: Mapping[str, TextFile]) -> bytes:
    """As unified_diff, in every file's own encoding and line ends.

    Lines end at the byte LF, as the patch command has it, whatever the encoding. Its paths are as given; where one is
    absolute or climbs out of the working folder, all are relative to the folder that holds them, as patch follows no
    others.
    """
    names = relative_names([*files, *new])
    old = {names[path]: _bytes(file.text, file.encoding) for path, file in files.items()}
    edited = {names[path]: _bytes(texts[path], file.encoding) for path, file in files.items()}
    added = {names[path]: _bytes(file.text, file.encoding) for path, file in new.items()}
    return "".join(_differences(old, edited, added)).encode("latin-1")


def relative_names(paths: list[str]) -> dict[str, str]:
    """What each path is called in a patch."""
    plain = {path: os.path.normpath(path) for path in paths}
    if all(not os.path.isabs(name) and ".." not in PurePath(name).parts for name in plain.values()):
        return plain
    absolute = {path: os.path.abspath(path) for path in paths}
    folder = os.path.commonpath([os.path.dirname(name) for name in absolute.values()])
    return {path: os.path.relpath(name, folder) for path, name in absolute.items()}


def _bytes(text: str, encoding: str) -> str:
    """The file's bytes, one character each."""
    return text.encode(encoding).decode("latin-1")


def _differences(old: Mapping[str, str], edited: Mapping[str, str], added: Mapping[str, str]) -> Iterator[str]:
    for path, text in old.items():
        if text != edited[path]:
            yield from _one(text, edited[path], f"a/{path}", f"b/{path}")
    for path, text in added.items():
        yield from _one("", text, "/dev/null", f"b/{path}")


def _one(old: str, new: str, before: str, after: str) -> Iterator[str]:
    # str.splitlines would also part lines at form feeds and U+0085, which neither RAPID nor patch take for line ends.
    lines = difflib.unified_diff(_LINE.findall(old), _LINE.findall(new), _quoted(before), _quoted(after))
    for line in lines:
        yield line if line.endswith("\n") else f"{line}\n{_NO_END}"


def _quoted(name: str) -> str:
    """A tab ends a name that holds blanks."""
    return f"{name}\t" if " " in name else name
