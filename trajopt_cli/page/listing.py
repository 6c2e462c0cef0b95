"""The program's text beside its motions: whole where it is short, around the motions where it is long."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import PurePath
from typing import Any

from trajopt_cli.motion import Program

WHOLE = 2_000  # lines of a module that is shown from end to end
AROUND = 6  # lines before and after a motion, where the module is longer
MOST = 4_000  # lines in all


def sources_data(programs: Sequence[Program], files: Iterable[str]) -> list[dict[str, Any]]:
    """Each file by its name, with stretches of lines: [first line, [text, ...]]. cut: whether motions are left out.

    A module that holds no motion is left out; its index stays.
    """
    out, room = [], MOST
    for path in files:
        content = next(one.files[path].text for one in programs if path in one.files)
        lines = content.split("\n")
        moving = {m.source.line for one in programs for m in one.motions if m.source.file == path}
        wanted = _wanted(len(lines), moving) if moving else []
        shown = wanted[:room]
        room -= len(shown)
        out.append(
            {
                "name": PurePath(path).name,
                "parts": [[a, [line.rstrip("\r") for line in lines[a - 1 : b]]] for a, b in _stretches(shown)],
                "cut": len(shown) < len(wanted),
            }
        )
    return out


def _wanted(count: int, moving: set[int]) -> list[int]:
    if count <= WHOLE:
        return list(range(1, count + 1))
    near = {line for at in moving for line in range(at - AROUND, at + AROUND + 1)}
    return sorted(line for line in near if 1 <= line <= count)


def _stretches(lines: Sequence[int]) -> list[tuple[int, int]]:
    """First and last of each run of neighbours."""
    out: list[tuple[int, int]] = []
    for line in lines:
        out = [*out[:-1], (out[-1][0], line)] if out and line == out[-1][1] + 1 else [*out, (line, line)]
    return out
