"""What `trajopt study show` says of a results folder: tables, and the page with charts of all points."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from trajopt_cli.geometry import IndexArray
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.tables import Tile, drawn, head, linked, points
from trajopt_cli.parameter_study.analysis import MORE_IS_BETTER, Shares, StudyRows, pareto
from trajopt_cli.table import TextTable, percent, tabulate

BEST = 10
"""Rows of a table, and columns of what varies in it."""
_DRAWN = 5_000  # points on a page: 1 MB, and lines that a browser draws in a blink
_NOTHING = 0.005  # of the variance: what is said to matter explains more
_REASONS, _LONG = 12, 160  # kinds of reasons that are told, characters of one
_WORDS = {
    "rapid_s": "RAPID cycle time",
    "stream_s": "cycle time as a joint stream",
    "as_written_s": "cycle time as written",
    "fixed_rail_s": "cycle time with a fixed rail",
    "saved_s": "time saved",
    "price": "price",
}


def leading(rows: StudyRows, shares: Shares | None) -> list[str]:
    """The columns of what varies that matter, what matters most first; all where nobody knows."""
    found = [name for one in shares.shares if one.total > _NOTHING for name in one.columns] if shares else []
    return (found or [*rows.factors])[:BEST]


def front(rows: StudyRows, name: str, against: str) -> IndexArray:
    """The rows of the Pareto front of two answers, the best by the first one first."""
    where = rows.best(name)
    signs = [-1 if one in MORE_IS_BETTER else 1 for one in (name, against)]
    values = np.column_stack([rows.numbers(name)[where] * signs[0], rows.numbers(against)[where] * signs[1]])
    known = np.isfinite(values).all(axis=1)
    return where[known][pareto(values[known])]


def tables(rows: StudyRows, name: str, against: str | None, shares: Shares | None) -> dict[str, TextTable]:
    """The best points by an answer, the front of both where there is another one, and what matters most."""
    factors = leading(rows, shares)
    out = {"best": _points_table(rows, rows.best(name), factors, f"best points by {name}")}
    if against is not None:
        title = f"no point is better both by {name} and by {against}"
        out["front"] = _points_table(rows, front(rows, name, against), factors, title)
    return out if shares is None else {**out, "matters": _shares_table(shares, name)}


def _points_table(rows: StudyRows, where: IndexArray, factors: Sequence[str], title: str) -> TextTable:
    """Points with their answers and what they have of the first factors."""

    def shown(name: str) -> Callable[[int], str]:
        return lambda i: _figure(rows.columns[name][i], "s" if name in rows.answers and name != "price" else "")

    columns: dict[str, Callable[[int], str]] = {">point": shown("point")}
    for name in (*rows.answers, *factors):
        names = any(isinstance(one, str) for one in rows.columns[name])
        columns[name if names else f">{name}"] = shown(name)
    return tabulate(title, [int(i) for i in where[:BEST]], columns)


def _shares_table(found: Shares, name: str) -> TextTable:
    """What matters most for an answer, in shares of its variance."""
    columns: dict[str, Callable[[Any], str]] = {
        "varied": lambda one: one.factor,
        ">alone": lambda one: percent(one.alone),
        ">with others": lambda one: percent(one.total),
    }
    matter = [one for one in found.shares if one.total > _NOTHING]
    left = f", {len(found.shares) - len(matter)} others hardly" if len(matter) < len(found.shares) else ""
    return tabulate(f"what matters most for {name}, in shares of its variance{left}", matter, columns)


def summary_lines(rows: StudyRows, name: str, count: int) -> list[str]:
    """How many points there are, how an answer is spread, and why some have none. count: of all points, done or not."""
    status = Counter(rows.columns["status"])
    lines = [f"{status.total()} of {count} points done, {status['ok']} with an answer"]
    for one in dict.fromkeys((name, *(["saved_s"] if "saved_s" in rows.answers else []))):
        quantiles = np.quantile(rows.numbers(one)[rows.best(one)], (0.05, 0.5, 0.95))
        low, middle, high = (_figure(float(x), rows.units.get(one, "")) for x in quantiles)
        lines.append(f"{one}: median {middle}, 90 % of the points between {low} and {high}")
    return lines + reasons(rows)


def reasons(rows: StudyRows) -> list[str]:
    """Why points have no answer, the most frequent reasons first."""
    bad = zip(rows.columns["status"], rows.columns["reason"], strict=True)
    kinds = Counter(f"{kind}: {why[:_LONG]}" for kind, why in bad if kind != "ok")
    return [f"{number} × {why}" for why, number in kinds.most_common(_REASONS)]


def study_page(
    title: str,
    rows: StudyRows,
    name: str,
    against: str | None,
    count: int,
    shares: Shares | None,
    plans: Mapping[int, str],
) -> bytes:
    """The page's bytes. name: the answer that is looked at. against: another one, for a front of both. count: of all
    points. plans: links to pages of plans that are kept, by point."""
    best, factors = rows.best(name), leading(rows, shares)
    button = '<button type="button" class="quiet" data-point="{0}">{0}</button>'
    words = f"{_WORDS[name]}{f' against {_WORDS[against]}' if against else ''}"
    about = {
        "best": ("Best points", "A point's number shows it below and in every chart."),
        "front": (words[0].upper() + words[1:], "Nothing is better than these in both."),
        "matters": ("What matters most", shares.in_words if shares else ""),
    }
    sections = [
        Section(key, about[key][0], drawn(made) if key == "matters" else linked(made, button), about[key][1])
        for key, made in tables(rows, name, against, shares).items()
    ]
    every = len(rows.columns["point"])
    some = sorted({*range(0, every, -(-every // _DRAWN)), *map(int, best[: 2 * BEST])})
    less = f" {len(some)} points are drawn, the others evenly left out." if len(some) < every else ""
    lead = f"Two of what varies, the answer by colour; blue is better. Click a point.{less}"
    lines = "A line is a point. Drag along an axis to keep its lines; a click ends it."
    sections += [
        Section("map", "Map", _MAP, lead),
        Section("lines", "All points", _LINES, lines),
        Section(
            "spread", "Spread", '<figure id="spread"></figure>', f"The {_WORDS[name]} of all points with an answer."
        ),
    ]
    sections.append(Section("told", "How many, and why not all", points(summary_lines(rows, name, count))))
    data = {
        "shown": name,
        "more": [*MORE_IS_BETTER],
        "factors": [*dict.fromkeys((*factors, *rows.factors))],
        "axes": [one.columns[0] for one in shares.shares[:2]] if shares else factors[:2],
        "lines": [*factors, name],
        "answers": [*rows.answers],
        "units": {one: rows.units.get(one, "") for one in (*rows.factors, *rows.answers)},
        "columns": {one: _values([rows.columns[one][i] for i in some]) for one in (*rows.factors, *rows.answers)},
        "point": [rows.columns["point"][i] for i in some],
        "ok": [rows.columns["status"][i] == "ok" for i in some],
        "reason": [(rows.columns["reason"][i] or "")[:_LONG] for i in some],
        "plans": {str(point): link for point, link in plans.items()},
    }
    unit, first = rows.units.get(name, ""), best[0]
    said = f"{_WORDS[name]}, point {rows.columns['point'][first]}"
    tile = Tile("best", f"{_figure(rows.columns[name][first], unit)} {unit}", said, "after")
    top = head(title, "trajopt study", [tile])
    return document(f"{title} · trajopt", top, sections, data, ("study.css", "study.js"))


_SELECTS = "".join(f'<label>{one} <select id="{one.lower()}"></select></label>' for one in ("Across", "Up", "Colour"))
_MAP = f'<div class="controls">{_SELECTS}</div><figure id="heat"></figure>'
_LINES = '<figure id="parallel"></figure><div id="chosen" role="status" hidden></div>'


def _figure(value: Any, unit: str) -> str:
    """A value as text, a time with three digits."""
    if value is None or isinstance(value, str):
        return value or ""
    digits = 4 if isinstance(value, float) and abs(value) < 1e3 else 9
    return f"{value:.3f}" if unit == "s" else f"{value:.{digits}g}"


def _values(values: Sequence[Any]) -> dict[str, Any]:
    """A column as the page's script reads it: numbers, or names and which of them; null for none."""
    if any(isinstance(one, str) for one in values):
        names = sorted({one for one in values if one is not None})
        return {"names": names, "values": [None if one is None else names.index(one) for one in values]}
    return {"values": [None if one is None else float(f"{one:.7g}") for one in values]}
