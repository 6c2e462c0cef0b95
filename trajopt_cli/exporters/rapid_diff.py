"""What an export changes, as a unified diff: for people as text, for `patch -p1` as the very bytes of the files."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from difflib import SequenceMatcher
from pathlib import PurePath

from trajopt_cli.motion import TextFile

_NO_END = "\\ No newline at end of file\n"
_CONTEXT = 3
_GAP = 250_000  # pairs of lines; more are taken as changed without looking for what they share
_LINE = re.compile(r"[^\n]*\n|[^\n]+")


def unified_diff(files: Mapping[str, TextFile], texts: Mapping[str, str]) -> str:
    """A diff to read. files: as given, by path; texts: edited, by the same paths."""
    return "".join(_differences({path: file.text for path, file in files.items()}, texts))


def patch(files: Mapping[str, TextFile], texts: Mapping[str, str]) -> bytes:
    """As unified_diff, in every file's own encoding and line ends.

    Lines end at the byte LF, as the patch command has it, whatever the encoding. Its paths are as given; where one is
    absolute or climbs out of the working folder, all are relative to the folder that holds them, as patch follows no
    others.
    """
    names = relative_names([*files])
    old = {names[path]: _bytes(file.text, file.encoding) for path, file in files.items()}
    edited = {names[path]: _bytes(texts[path], file.encoding) for path, file in files.items()}
    return "".join(_differences(old, edited)).encode("latin-1")


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


def _differences(old: Mapping[str, str], edited: Mapping[str, str]) -> Iterator[str]:
    for path, text in old.items():
        if text != edited[path]:
            yield from _one(text, edited[path], f"a/{path}", f"b/{path}")


def _one(old: str, new: str, before: str, after: str) -> Iterator[str]:
    # str.splitlines would also part lines at form feeds and U+0085, which neither RAPID nor patch take for line ends.
    a, b = _LINE.findall(old), _LINE.findall(new)
    yield f"--- {_quoted(before)}\n"
    yield f"+++ {_quoted(after)}\n"
    for hunk in _hunks(_changes(a, b)):
        first, last = hunk[0], hunk[-1]
        start_a, end_a = max(first[0] - _CONTEXT, 0), min(last[1] + _CONTEXT, len(a))
        start_b, end_b = first[2] - (first[0] - start_a), last[3] + (end_a - last[1])
        yield f"@@ -{_range(start_a, end_a)} +{_range(start_b, end_b)} @@\n"
        at = start_a
        for i_0, i_1, j_0, j_1 in hunk:
            lines = [f" {line}" for line in a[at:i_0]]
            lines += [f"-{line}" for line in a[i_0:i_1]] + [f"+{line}" for line in b[j_0:j_1]]
            yield from map(_ended, lines)
            at = i_1
        yield from map(_ended, [f" {line}" for line in a[at:end_a]])


def _ended(line: str) -> str:
    return line if line.endswith("\n") else f"{line}\n{_NO_END}"


def _range(start: int, end: int) -> str:
    """Lines [start, end) as a hunk's head counts them."""
    length = end - start
    return f"{start + 1}" if length == 1 else f"{start + 1 if length else start},{length}"


# Lines [i_0, i_1) of the old text become lines [j_0, j_1) of the new one.
_Change = tuple[int, int, int, int]


def _hunks(changes: Iterator[_Change]) -> Iterator[list[_Change]]:
    """Changes so near to each other that their context would touch, together."""
    hunk: list[_Change] = []
    for change in changes:
        if hunk and change[0] - hunk[-1][1] > 2 * _CONTEXT:
            yield hunk
            hunk = []
        hunk.append(change)
    if hunk:
        yield hunk


def _changes(a: Sequence[str], b: Sequence[str]) -> Iterator[_Change]:
    """What differs between two texts, in order.

    difflib takes the square of the number of lines, hours for a hundred thousand targets. Lines that both texts have
    once part them into small gaps first; edits never change the order of lines, so they need no sorting out.
    """
    i, j = 0, 0
    for i_next, j_next in [*_anchors(a, b), (len(a), len(b))]:
        if i_next < i or j_next < j:
            continue
        yield from _in_gap(a, b, (i, i_next, j, j_next))
        i, j = i_next + 1, j_next + 1


def _anchors(a: Sequence[str], b: Sequence[str]) -> Iterator[tuple[int, int]]:
    counts_a, counts_b = Counter(a), Counter(b)
    place = {line: j for j, line in enumerate(b) if counts_b[line] == 1}
    last = -1
    for i, line in enumerate(a):
        if counts_a[line] == 1 and (j := place.get(line, -1)) > last:
            last = j
            yield i, j


def _in_gap(a: Sequence[str], b: Sequence[str], gap: _Change) -> Iterator[_Change]:
    i_0, i_1, j_0, j_1 = gap
    while i_0 < i_1 and j_0 < j_1 and a[i_0] == b[j_0]:
        i_0, j_0 = i_0 + 1, j_0 + 1
    while i_0 < i_1 and j_0 < j_1 and a[i_1 - 1] == b[j_1 - 1]:
        i_1, j_1 = i_1 - 1, j_1 - 1
    if (i_1 - i_0) * (j_1 - j_0) > _GAP:
        yield i_0, i_1, j_0, j_1
        return
    matcher = SequenceMatcher(None, a[i_0:i_1], b[j_0:j_1], autojunk=False)
    for kind, p_0, p_1, q_0, q_1 in matcher.get_opcodes():
        if kind != "equal":
            yield i_0 + p_0, i_0 + p_1, j_0 + q_0, j_0 + q_1


def _quoted(name: str) -> str:
    """A tab ends a name that holds blanks."""
    return f"{name}\t" if " " in name else name
