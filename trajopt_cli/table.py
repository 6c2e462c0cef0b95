"""A table of an answer as text: rows and descriptions of columns in, the same cells for terminal and page out."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import TypeVar

from trajopt_cli.findings import Finding, good_side, nearest
from trajopt_cli.motion import Source

Row = TypeVar("Row")
_OPEN = 9e9  # RAPID's 9E9: an external axis that is not there, or keeps its place
_ROUNDED = 5e-4  # a share that is printed as 0.0 %: its sign may be rounding


class Good(str):
    """A cell that says yes."""


class Bad(str):
    """A cell that says no."""


class Verbatim(str):
    """A line that is printed as it is, however long, to be pasted."""


@dataclass(frozen=True)
class TextTable:
    """heads: ">" before one puts its column to the right, "~" marks names, which may be cut in the middle. rows: a cell
    per head. total: whether the last row is a sum."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    total: bool = False


def tabulate(
    title: str, rows: Iterable[Row], columns: Mapping[str, Callable[[Row], str]], total: Sequence[str] | None = None
) -> TextTable:
    """A table of one row per item. columns: a cell's text by head, in order. total: a last row of its own."""
    cells = [tuple(short_target(column(row)) for column in columns.values()) for row in rows]
    cells += [] if total is None else [tuple(total)]
    return TextTable(title, tuple(columns), tuple(cells), total is not None)


def short_target(text: str) -> str:
    """A target written out, as "[1090.0, -496.5, 994.0] [812.5]": its position [mm] or joints [deg], then its external
    axes, then what stands behind it. Any other text as it is."""
    groups = re.findall(r"\[([^\[\]]*)\]", text) if text.startswith("[[") else []
    try:
        first, *_, external = [[float(value) for value in group.split(",")] for group in groups]
    except ValueError:  # names or expressions in it
        return text
    shown = [[value for value in group if value < _OPEN] for group in (first, external)]
    figures = (", ".join(f"{round(x, 1) + 0.0:.1f}" for x in values) for values in shown if values)
    return " ".join(f"[{one}]" for one in figures) + text.rpartition("]")[2]


def seconds(value: float | None, without: str = "") -> str:
    """Three digits; `without` for None."""
    return without if value is None else f"{value:.3f}"


def signed(value: float, digits: int = 3) -> str:
    """With its sign, "−0.851" or "+0.020"; no sign where it rounds to 0."""
    text = f"{value:+.{digits}f}".replace("-", "−")
    return text[1:] if float(text[1:]) == 0.0 else text


TOLD_GAP = 0.5  # a gap beyond says more of the bound than of the plan


def told_gap(gap: float) -> str:
    """How far above its lower bound a plan is, or why that says little."""
    if gap > TOLD_GAP:
        return "which says little here: it leaves out obstacles, the wrist and the rail in corners"
    return f"gap {100 * gap:.1f} %"


def percent(share: float | None, digits: int = 1) -> str:
    """A share as "26.5 %"; nothing for None."""
    if share is None:
        return ""
    return f"{100 * (0.0 if abs(share) < _ROUNDED else share):.{digits}f} %".replace("-", "−")


def change(before: float, after: float) -> str:
    """What becomes of a time, in per cent: "−26.5 %", or "unchanged"."""
    text = signed(100 * (after / before - 1), 1) if before > 0 else "0.0"
    return "unchanged" if text == "0.0" else f"{text} %"


def figure(value: float | None, digits: int) -> str:
    """So many figures; "-" for a number that could not be computed, nothing for None."""
    return "" if value is None else f"{value:.{digits}g}" if math.isfinite(value) else "-"


def place(source: Source | None) -> str:
    """The file's name and the line."""
    return f"{PurePath(source.file).name}:{source.line}" if source else ""


def by_name(text: str, files: Iterable[str]) -> str:
    """A sentence with its places as the tables have them: the file's name alone, where no two files share it."""
    names = {path: PurePath(path).name for path in files}
    if len(set(names.values())) < len(names):
        return text
    for path in sorted(names, key=len, reverse=True):  # a path may be the end of another
        text = re.sub(rf"(?<![\w./-]){re.escape(path)}(?=:\d|\b)", names[path].replace("\\", r"\\"), text)
    return text


def findings_table(title: str, findings: Iterable[Finding], everything: bool = False) -> TextTable:
    """The tightest case of each check, or all cases."""
    rows = [(one, 1) for one in findings] if everything else nearest(findings)
    return tabulate(
        title,
        rows,
        {
            "check": lambda row: row[0].check,
            "": lambda row: Good("ok") if row[0].passed else Bad("NO"),
            "~of": lambda row: row[0].subject,
            ">worst value": lambda row: figure(row[0].value, 6),
            ">limit": lambda row: figure(row[0].limit, 6),
            ">margin": lambda row: figure(good_side(row[0]), 3),
            "unit": lambda row: row[0].unit,
            ">time [s]": lambda row: "" if row[0].time is None else f"{row[0].time:.4f}",
            "place": lambda row: place(row[0].source),
            ">cases": lambda row: str(row[1]),
        },
    )
