"""report.html of the compliant job: the arm in space, charts on its clock, tables. Made from plain data."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import block, text
from trajopt_cli.page.scene import HOLDER, SCRIPTS
from trajopt_cli.page.tables import Tile, chart, head, numbers, points

BEFORE, AFTER = "before", "after"
AXES = ("a", "b", "c")
"""Looks of a curve: two runs beside each other, and x, y, z of one."""
_MOST = 8_000_000  # bytes of a page
_SMALL = 600_000  # bytes of a picture that goes into one
SHOWN = 2400
"""Points per curve that a page can show, highest and lowest of each bin kept."""


def thinned(values: Array, progress: Array | None = None, bins: int = SHOWN // 2) -> IndexArray:
    """Rows (k,) of values (n,) or (n, c) that show as all would: lowest and highest of each bin, first and last.

    progress (n,): what the bins are equal parts of, the row number unless given; it never falls.
    """
    columns = values.reshape(len(values), -1)
    n = len(columns)
    if n <= 2 * bins:
        return np.arange(n)
    along = np.arange(n, dtype=np.float64) if progress is None else progress
    which = (bins * (along - along[0]) / max(float(along[-1] - along[0]), 1e-300)).astype(int)
    starts = np.flatnonzero(np.diff(which, prepend=-1))
    counts = np.diff(starts, append=n)
    kept = [starts, np.array([n - 1])]
    for column in columns.T:
        for best in (np.minimum, np.maximum):
            hits = np.flatnonzero(column == np.repeat(best.reduceat(column, starts), counts))
            kept.append(hits[np.diff(which[hits], prepend=-1) > 0])  # the first of each bin
    return np.unique(np.concatenate(kept))


@dataclass(frozen=True, eq=False)
class Curve:
    """y (n,) over t (n,) [s], in the chart's unit; style as in page/assets/charts.js."""

    name: str
    t: Array
    y: Array
    style: str


@dataclass(frozen=True, eq=False)
class Chart:
    """Curves over one axis. limits: value and name, in the chart's unit. peak: mark the highest value of each curve."""

    name: str
    title: str
    unit: str
    curves: Sequence[Curve]
    limits: Sequence[tuple[float, str]] = ()
    peak: bool = False
    zero: bool = False
    digits: int = 2


@dataclass(frozen=True)
class TimelineEntry:
    """A part of the run: what it is, from when to when [s], and further cells."""

    name: str
    start: float
    end: float
    more: Sequence[str] = ()


def run_page(
    title: str,
    about: str,
    tiles: Sequence[Tile],
    cycles: Sequence[tuple[str, float]],
    scene: Mapping[str, Any] | str,
    charts: Mapping[str, tuple[str, Sequence[Chart]]],
    tables: Sequence[Section],
) -> bytes:
    """The page's bytes, the same for the same arguments.

    cycles: name and duration [s]. scene: of page.scene with a cycle for each, or why there is none. charts: by the
    heading of their section, with its lead. tables: sections below.
    """
    specs, arrays = charts_data([one for _, group in charts.values() for one in group])
    space = HOLDER if not isinstance(scene, str) else points([scene])
    keys = "Space plays, arrow keys step 10 ms, with Shift 100 ms. Drag over a chart to enlarge an interval."
    sections = [Section("motion", "Motion", space, keys=keys)]
    for heading, (lead, group) in charts.items():
        figures = "".join(chart(one.name, f"{one.title} over time") for one in group)
        wide = len(group) == 1
        html = figures if wide else f'<div class="charts">{figures}</div>'
        sections.append(Section(heading.lower().replace(" ", "-"), heading, html, lead))
    shown = [{"name": name, "duration": duration} for name, duration in cycles]
    data: dict[str, Any] = {
        "clock": {"duration": max(duration for _, duration in cycles), "cycles": shown},
        "charts": specs,
        "arrays": arrays,
    }
    if not isinstance(scene, str):
        data["scene"] = scene
    return document(f"{title} · trajopt", head(title, about, tiles), [*sections, *tables], data, (*SCRIPTS, "legs.js"))


def legs_table(heads: Sequence[str], legs: Sequence[TimelineEntry]) -> str:
    """Parts of a run as a table; a click on one goes to its beginning. heads: of the further cells."""
    names = ["", ">from [s]", ">to [s]", *heads]
    top = "".join(
        f'<th scope="col" class="n">{text(name[1:])}</th>'
        if name.startswith(">")
        else f'<th scope="col">{text(name)}</th>'
        for name in names
    )
    rows = "".join(
        f'<tr data-from="{one.start:.6g}" data-to="{one.end:.6g}"><td><button type="button" class="quiet">'
        f"{text(one.name)}</button></td>{''.join(numbers(f'{one.start:.3f}', f'{one.end:.3f}', *one.more))}</tr>"
        for one in legs
    )
    return (
        '<div class="scroll tall" role="region" aria-label="Legs" tabindex="0"><table id="legs"><caption>A click goes '
        f"to the beginning of a leg.</caption><thead><tr>{top}</tr></thead><tbody>{rows}</tbody></table></div>"
    )


def charts_data(charts: Sequence[Chart]) -> tuple[dict[str, Any], dict[str, Any]]:
    """The charts' specs and the blocks they name; of each curve the samples that show, highest and lowest kept."""
    specs, arrays = {}, {}
    for one in charts:
        series = []
        for i, curve in enumerate(one.curves):
            rows = thinned(curve.y)
            t, y = f"{one.name}.{i}.t", f"{one.name}.{i}.y"
            arrays[t], arrays[y] = block(curve.t[rows]), block(curve.y[rows])
            series.append({"name": curve.name, "t": t, "y": y, "style": curve.style})
        peaks = [(curve.t, curve.y, int(np.argmax(np.abs(curve.y)))) for curve in one.curves] if one.peak else []
        specs[one.name] = {
            "title": one.title,
            "unit": one.unit,
            "digits": one.digits,
            "zero": one.zero,
            "series": series,
            "limits": [{"value": value, "name": name} for value, name in one.limits],
            "points": [{"t": float(t[i]), "y": float(y[i])} for t, y, i in peaks],
        }
    return specs, arrays


def picture_page(title: str, about: str, groups: Sequence[tuple[Section, Sequence[tuple[str, bytes]]]]) -> bytes:
    """A page of tables with pictures below each: section, and names with SVG contents.

    A picture too large to carry, or for which there is no room left, is named instead.
    """
    sections, room = [], _MOST
    for section, pictures in groups:
        html = section.html
        for name, content in pictures:
            coded = b64encode(content).decode()
            if len(content) > _SMALL or len(coded) > room:
                html += f"<p>Not in this page, for its size: {text(name)} in the folder.</p>"
                continue
            room -= len(coded)
            label = text(name.removesuffix(".svg").replace("_", " "))
            html += (
                f'<figure class="picture"><img src="data:image/svg+xml;base64,{coded}" alt="{label}" loading="lazy">'
                "</figure>"
            )
        sections.append(Section(section.name, section.heading, html, section.lead))
    return document(f"{title} · trajopt", head(title, about, ()), sections, {}, ("picture.css",))
