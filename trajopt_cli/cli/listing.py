"""A program's motions as text, in the units of RAPID: mm, deg, mm/s. As wide as the terminal, without rich.

Columns that are empty everywhere are left out. Those that do not fit stand below each row, in the same order.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import PurePath
from textwrap import wrap
from typing import Any

from trajopt_cli.motion import Happens, Hold, PathEvent, without_name
from trajopt_cli.rapid.listing import Listing, Row

PIPED_WIDTH = 300  # columns when nobody tells; a log must not wrap
_GAP = "  "
_LONGEST = {
    "target": 44,
    "speed": 34,
    "zone": 26,
}  # figures and expressions written out in the program: cut in the middle
_SAYABLE = ("speed", "zone", "conf", "ext. axes", "tool", "wobj", "orientation w x y z", "settings")  # once for all
_OF_POSES = {"conf", "wobj", "orientation w x y z"}  # moves to joints need none
_NAMED = re.compile(r"(v|vrot|vlin)(\d+)$", re.IGNORECASE)
_SAID = (Hold.PROGRAM, Hold.CELL, Hold.UNIT)  # a note below the table tells of the waits after an output
_ZONE = re.compile(r"z(\d+)$", re.IGNORECASE)

# What each column shows, the most telling first.
COLUMNS: dict[str, Callable[[Row], str]] = {
    "place": lambda row: f"{PurePath(row.source.file).name}:{row.source.line}",
    "instruction": lambda row: row.instruction,
    "target": lambda row: " ".join(without_name(row.target or "", row.instruction).split()),
    "to": lambda row: _to(row),
    "speed": lambda row: _speed(row),
    "zone": lambda row: _zone(row),
    "conf": lambda row: "" if row.conf is None else f"{row.conf.cf1},{row.conf.cf4},{row.conf.cf6},{row.conf.cfx}",
    "ext. axes": lambda row: _external(row),
    "tool": lambda row: row.tool or "",
    "wobj": lambda row: row.wobj or "",
    "orientation w x y z": lambda row: _figures(row.orientation, 5),
    "by way of": lambda row: _figures(row.via),
    "length": lambda row: "" if row.length is None else f"{round(row.length, 2) + 0.0:g}",
    "events": lambda row: ", ".join(_event(event) for event in row.events),
    "settings": lambda row: settings_text(row.settings),
    "besides": lambda row: _besides(row),
}


def terminal_width(piped: int = PIPED_WIDTH) -> int:
    """Columns of the terminal that stdout is, or what COLUMNS says; piped where nobody tells."""
    told = os.environ.get("COLUMNS", "")
    asked = sys.stdout.isatty() or (told.isdecimal() and int(told) > 0)
    return shutil.get_terminal_size().columns if asked else piped


def listing_lines(program: str, listing: Listing, width: int) -> Iterator[str]:
    """The table, line by line, none wider than width unless a single cell is."""
    title = f"{program}: positions in mm, world; joints in deg; lengths in mm; external axes as written"
    yield from wrap(title, width, break_long_words=False, break_on_hyphens=False)
    if not listing.rows:
        return
    yield ""
    cells = {name: [_cut(name, show(row)) for row in listing.rows] for name, show in COLUMNS.items()}
    cells = {name: column for name, column in cells.items() if any(column)}
    widths = {name: max(len(name), *map(len, column)) for name, column in cells.items()}
    beside, below = _fitting(widths, width)
    if below and (same := _same_for_all_moves(cells, listing.rows)):
        told = ", ".join(f"{name} {text}" for name, text in same.items())
        yield from wrap(f"every move: {told}", width, subsequent_indent="    ", break_on_hyphens=False)
        yield ""
        beside, below = _fitting({name: widths[name] for name in widths if name not in same}, width)
    yield _line([name.ljust(widths[name]) for name in beside])
    if below:
        yield from wrap("then " + ", ".join(below), width, initial_indent="    ", subsequent_indent="    ")
    yield "─" * min(width, sum(widths[name] + len(_GAP) for name in beside) - len(_GAP))
    for i in range(len(listing.rows)):
        yield _line([cells[name][i].ljust(widths[name]) for name in beside])
        rest = _GAP.join(_labelled(name, cells[name][i]) for name in below if cells[name][i])
        yield from wrap(rest, width, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)


def _same_for_all_moves(cells: Mapping[str, Sequence[str]], rows: Sequence[Row]) -> dict[str, str]:
    """What columns say that say the same for every move, by column."""
    moves = [i for i, row in enumerate(rows) if row.zone is not None]
    if len(moves) < 2:
        return {}
    texts = {name: {cells[name][i] for i in moves} for name in cells if name in _SAYABLE}
    for name in texts.keys() & _OF_POSES:
        texts[name].discard("")
    return {name: text for name, (text, *more) in ((n, [*t]) for n, t in texts.items()) if text and not more}


def _fitting(widths: Mapping[str, int], width: int) -> tuple[list[str], list[str]]:
    """The columns that stand beside each other, and those that do not fit."""
    names, used = list(widths), 0
    for i, name in enumerate(names):
        used += widths[name] + (len(_GAP) if i else 0)
        if used > width:
            return names[: max(i, 1)], names[max(i, 1) :]
    return names, []


def _line(parts: Sequence[str]) -> str:
    return _GAP.join(parts).rstrip()


def _labelled(name: str, text: str) -> str:
    """A cell that stands under its row, with what it is where it does not tell itself."""
    label = {"conf": "conf", "ext. axes": "eax", "orientation w x y z": "wxyz", "by way of": "via", "length": "length"}
    return f"{label[name]} {text}" if name in label else text


def _cut(name: str, text: str) -> str:
    return shortened(text, _LONGEST[name]) if name in _LONGEST else text


def shortened(text: str, longest: int) -> str:
    """A text on one line; one of more than longest characters without its middle."""
    text = " ".join(text.split())
    half = (longest - 1) // 2
    return text if len(text) <= longest else f"{text[:half]}…{text[-half:]}"


def _figures(values: tuple[float, ...] | None, digits: int = 2) -> str:
    # + 0.0 takes the sign off a zero
    return " ".join(f"{round(value, digits) + 0.0:.10g}" for value in values or ())


def _to(row: Row) -> str:
    """Where a move ends, how long a wait lasts, what a signal is set to."""
    if row.kind == "Wait":
        least = "at least " if row.target is not None else ""
        if row.beside is None:
            return f"{least}{row.duration:.7g} s"
        return f"{least}{row.beside:.7g} s beside the move{f', {row.duration:.7g} s behind it' * bool(row.duration)}"
    if row.value is not None:
        return f"= {row.value:.7g}"
    return _figures(row.position or row.joints)


def _external(row: Row) -> str:
    """Positions as programmed; in brackets those that the motion leaves as they are."""
    kept = row.extax_kept or (None,) * 6
    texts = ["-" if value is None else f"{value:.7g}" for value in row.extax or ()]
    both = (text if old is None else f"({old:.7g})" for text, old in zip(texts, kept, strict=False))
    return " ".join(both).rstrip(" -")


def _speed(row: Row) -> str:
    """The name, and the four figures where they are not those of the name; a programmed time."""
    if row.speed is None:
        return ""
    figures = (row.v_tcp, row.v_ori, row.v_leax, row.v_reax)
    text = row.speed
    if not all(_same(figure, usual) for figure, usual in zip(figures, _usual(row.speed), strict=True)):
        shown = f"[{','.join('-' if figure is None else f'{figure:.6g}' for figure in figures)}]"
        text = shown if text.startswith("[") else f"{text} {shown}"
    return text if row.duration is None else f"{text} in {row.duration:.7g} s"


def _usual(name: str) -> tuple[float | None, ...]:
    """The figures of predefined speeddata by its name, None where the name does not tell."""
    match = _NAMED.match(name)
    if match is None:
        return (None,) * 4
    n = float(match[2])
    kinds = {"v": (n, 500.0, 5000.0, 1000.0), "vrot": (0.0, 0.0, 0.0, n), "vlin": (0.0, 0.0, n, 0.0)}
    return kinds[match[1].lower()]


def _same(figure: float | None, usual: float | None) -> bool:
    return figure is None or (usual is not None and abs(figure - usual) <= 1e-4 * max(figure, 1.0))


def _zone(row: Row) -> str:
    """The name; the radius where the name does not tell it; what is left of it."""
    if row.zone is None:
        return ""
    name = "" if row.zone.startswith("[") else row.zone
    if row.stop:
        return " ".join(part for part in (name or "fine", row.criterion) if part)
    match, radius = _ZONE.match(row.zone), row.radius or 0.0
    usual = match is not None and abs(radius - (float(match[1]) or 0.3)) <= 1e-4
    told = name if usual else f"{name} {radius:.4g}".strip()
    left = row.effective_radius
    if row.effective_angle is not None:
        return f"{told}, {row.effective_angle:.3g} deg"
    if left is not None and left < radius - 1e-6:
        return f"{told}, {f'{left:.3g} mm' if left else 'stops here'}"
    return told


def _event(event: PathEvent) -> str:
    match event.kind:
        case Happens.SIGNAL:
            what = event.name if event.value is None else f"{event.name}={event.value:.7g}"
        case Happens.INTERRUPT:
            what = f"interrupt {event.name}"
        case Happens.PROCEDURE:
            what = f"{event.name}()"
    parts = [f"{value:.5g} {unit}" for value, unit in ((event.distance * 1e3, "mm"), (event.time, "s")) if value]
    place = ("after the start" if event.from_start else "before the end") if parts else ""
    return " ".join([what, *parts, place or ("at the start" if event.from_start else "at the end")])


def settings_text(settings: Mapping[str, Any]) -> str:
    """Settings that differ, as the program would write them, on one line."""
    return ", ".join(
        " ".join([word, *(_setting(one) for one in (value if isinstance(value, list) else [value]))])
        for word, value in settings.items()
    )


def _setting(value: Any) -> str:
    return "-" if value is None else value if isinstance(value, str) else f"{value:.6g}"


def _besides(row: Row) -> str:
    said = {"optional": row.optional, "hold rail": row.hold in _SAID, "constant speed": row.constant_speed}
    marks = [mark for mark, there in said.items() if there]
    marks += [f"way around {', '.join(row.detour)}"] if row.detour else []
    return ", ".join([*(f"{key} {value}" for key, value in row.process), *marks])
