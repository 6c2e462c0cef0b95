"""Comments that speak to trajopt: `! trajopt: optional` and `! trajopt: hold rail`.

`! trajopt: way around 'column'` says of a point that an export has added it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from trajopt_cli.rapid.language.syntax import ModuleFile, ProcedureCall, Routine, Statement, walk
from trajopt_cli.rapid.language.text import Places

DROPPED = "! dropped by trajopt: "  # how an export begins the comment that a dropped move becomes
FLAT = "! written flat by trajopt: "  # and what it has written out elsewhere
HOLD = "! trajopt: hold rail"
_MARK = re.compile(r"!\s*trajopt\s*:\s*(.*?)\s*$", re.IGNORECASE)
_OPTIONAL, _HOLD, _WAY = "optional", "hold rail", "way around"
_AROUND = re.compile(r"way\s+around\s+('(?:[^']|'')+'(?:\s*,\s*'(?:[^']|'')+')*)", re.IGNORECASE)
_NAME = re.compile(r"'((?:[^']|'')+)'")
_Stretch = tuple[int, int]


@dataclass(frozen=True)
class Marks:
    """optional: starts of the instructions that may be dropped. held: stretches of the statements and routines in
    which the rail stands still. ways: around what the way leads that an additional point is on, by the start of its
    move."""

    optional: tuple[int, ...]
    held: tuple[_Stretch, ...]
    ways: Mapping[int, tuple[str, ...]] = field(default_factory=dict)


def way_around(names: Sequence[str]) -> str:
    """The comment behind an additional point; find_marks gives the names back, blanks in them made one each."""
    listed = ", ".join("'" + " ".join(name.split()).replace("'", "''") + "'" for name in names)
    return f"! trajopt: {_WAY} {listed}"


def find_marks(tree: ModuleFile, places: Places) -> Marks:
    """What the comments of a file mark.

    A comment stands behind what it marks on its last line, or alone on the line above it; one about the rail also
    behind the opening line of a block or a routine. Raises InputError for an unknown mark, and for one at nothing.
    """
    found: dict[str, list[int]] = {_OPTIONAL: [], _HOLD: [], _WAY: []}
    around: dict[int, tuple[str, ...]] = {}
    for start, end in tree.comments:
        if match := _MARK.match(places.text[start:end]):
            word = " ".join(match[1].lower().split())
            if way := _AROUND.fullmatch(match[1]):
                word, around[start] = _WAY, tuple(name.replace("''", "'") for name in _NAME.findall(way[1]))
            elif word not in (_OPTIONAL, _HOLD):
                marks = f"'{_OPTIONAL}', '{_HOLD}' and, with names, \"{_WAY} 'column'\""
                raise places.error(start, f"there is no mark '{match[1]}'; the marks are {marks}")
            found[word].append(start)
    if not any(found.values()):
        return Marks((), ())
    nodes = sorted(
        ((node.start, node.end, type(node)) for node in walk(tree) if isinstance(node, Statement | Routine)),
        key=lambda one: (one[0], -one[1]),
    )
    calls = [(start, end) for start, end, kind in nodes if kind is ProcedureCall]
    optional = [one for mark in found[_OPTIONAL] for one in _at(mark, places, calls, _OPTIONAL)]
    blocks = [(start, end) for start, end, _ in nodes]
    held = [one for mark in found[_HOLD] for one in _at(mark, places, blocks, _HOLD)]
    ways = {start: around[mark] for mark in found[_WAY] for start, _ in _at(mark, places, calls, _WAY)}
    return Marks(tuple(start for start, _ in optional), tuple(held), ways)


def _at(mark: int, places: Places, stretches: Sequence[_Stretch], word: str) -> list[_Stretch]:
    """The stretch that a mark is about. stretches: in order, an outer one before those inside it."""
    line = places.line(mark)
    if not places.text[:mark].rpartition("\n")[2].strip():
        found = [one for one in stretches if one[0] > mark and places.line(one[0]) == line + 1][:1]
    else:
        ending = [one for one in stretches if one[1] <= mark and places.line(one[1] - 1) == line]
        found = [max(ending, key=lambda one: one[1])] if ending else []
        if not found and word == _HOLD:
            found = [one for one in stretches if one[0] < mark < one[1] and places.line(one[0]) == line][-1:]
    if not found and not _already_dropped(places.text, mark):
        what = "a move, a wait, a block or a routine" if word == _HOLD else "a move"
        message = f"'! trajopt: {word}' marks no instruction; put it after {what} or on the line above it"
        raise places.error(mark, message)
    return found


def _already_dropped(text: str, mark: int) -> bool:
    below = text[mark:].splitlines()[1:2]
    beside = [text[:mark].splitlines()[-1], *below]
    return any(beginning in line for line in beside for beginning in (DROPPED, FLAT))
