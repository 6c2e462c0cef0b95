"""The experiments for people: tables in mm and degrees with the unit that a number's name ends in, and report.html."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from trajopt_cli.iiwa.report.page import picture_page
from trajopt_cli.page.document import Section
from trajopt_cli.page.tables import drawn, facts, points
from trajopt_cli.table import TextTable
from trajopt_cli.units import DEG, MM

_UNITS = (
    ("_m_s", "m/s", 1.0),
    ("_kg", "kg", 1.0),
    ("_rad", "°", DEG),
    ("_m", "mm", MM),
    ("_N", "N", 1.0),
    ("_s", "s", 1.0),
)
_TURNS = ("alpha", "beta", "gamma")
# Of axes in one table: lengths, and forces, whose unit is the row's.
_LENGTHS = ("steady", "force_over_stiffness", "largest", "mean", "thesis_largest", "thesis_mean")
_HEAD = ("section", "title", "notes")


_MEASURED = "loop_time"
_CLOCK = "What the clock said in this run is in measured.json and loop_time.svg: no two runs are alike in it."


class Shown(NamedTuple):
    """A section for people: its name and heading, single numbers with their names, tables, and notes."""

    name: str
    heading: str
    facts: list[tuple[str, str]]
    tables: list[TextTable]
    notes: list[str]


def sections(numbers: Mapping[str, Any], measured: Mapping[str, Any]) -> Iterator[Shown]:
    """Every experiment of experiments.json (numbers) and measured.json, and the worst of the flange after 6.1.4."""
    for name, one in numbers.items():
        if name == "flange_worst" and one:
            caption = "6.1.5 the flange behind the controller, worst of all"
            yield Shown("flange", caption, [], [_table(caption, one)], numbers["flange_worst_notes"])
        elif isinstance(one, dict) and "section" in one:
            record = {**one, **measured.get(name, {})}
            yield Shown(name, f"{one['section']} {one['title']}", _singles(record), list(_tables(record)), one["notes"])


def experiments_page(numbers: Mapping[str, Any], pictures: Mapping[str, Mapping[str, bytes]]) -> bytes:
    """report.html. pictures: files by name, by experiment; that of the loop's times, which differ from run to run, is
    named instead."""
    groups = []
    for one in sections(numbers, {}):
        made = "".join(drawn(part) for part in one.tables)
        notes = [*one.notes, *([_CLOCK] if one.name == _MEASURED else [])]
        files = [] if one.name == _MEASURED else list(pictures.get(one.name, {}).items())
        section = Section(one.name, one.heading, facts(one.facts) + made + points(notes))
        groups.append((section, [(file, content) for file, content in files if file.endswith(".svg")]))
    about = (
        "Chapter 6 of the thesis that the compliant job goes back to (V. Číhala, Poddajné řízení průmyslového robota, "
        f"ČVUT 2020), its numbers beside ours; engine {numbers['engine']}"
    )
    return picture_page("iiwa experiments", about, groups)


def _singles(record: Mapping[str, Any]) -> list[tuple[str, str]]:
    out = []
    for key, value in record.items():
        vector = isinstance(value, list) and bool(value) and isinstance(value[0], float)
        if key not in _HEAD and (isinstance(value, (int, float, str)) or vector):
            name, unit, size = _named(key)
            shown = f"({', '.join(_shown(one, size) for one in value)})" if vector else _shown(value, size)
            out.append((f"{name}{f' [{unit}]' if unit else ''}", shown))
    return out


def _tables(record: Mapping[str, Any]) -> Iterator[TextTable]:
    """The lists of rows in a record, rows within rows flat."""
    for key, rows in record.items():
        if isinstance(rows, list) and rows and isinstance(rows[0], dict):
            inner = sorted({name for row in rows for name, value in row.items() if isinstance(value, list)})
            flat = {
                name: [{"setting": row["label"], **part} for row in rows for part in row[name] or []] for name in inner
            }
            yield from (_table(name, some) for name, some in (flat or {key: rows}).items() if some)


def _table(caption: str, rows: Sequence[Mapping[str, Any]]) -> TextTable:
    heads = []
    for key in rows[0]:
        name, unit, _ = _named(key)
        numeric = any(isinstance(row[key], (int, float)) for row in rows)
        heads.append(f"{'>' if numeric else ''}{name}{f' [{unit}]' if unit else ''}")
    cells = [tuple(_cell(key, value, str(row.get("axis", ""))) for key, value in row.items()) for row in rows]
    return TextTable(caption.replace("_", " "), tuple(heads), tuple(cells))


def _named(key: str) -> tuple[str, str, float]:
    """A recorded name for people, its unit, and what that unit is in SI."""
    for ending, unit, size in _UNITS:
        if key.endswith(ending):
            return key.removesuffix(ending).replace("_", " "), unit, size
    return key.replace("_", " "), "", 1.0


def _cell(key: str, value: Any, axis: str) -> str:
    if key in _LENGTHS and axis and value is not None:
        return f"{value / DEG:.3f} °" if axis in _TURNS else f"{value / MM:.3f} mm"
    if key == "force":
        return f"{value:g} {'Nm' if axis in _TURNS else 'N'}"
    return _shown(value, _named(key)[2])


def _shown(value: Any, size: float) -> str:
    if value is None:
        return "–"
    if isinstance(value, dict):
        return ", ".join(f"{_shown(one, size)} ({name})" for name, one in value.items())
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    return f"{value / size:.4g}".replace("-", "−")
