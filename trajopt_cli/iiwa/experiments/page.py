"""report.html of the experiments: the numbers as recorded, the thesis' beside ours, and the pictures below them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from trajopt_cli.iiwa.report.page import picture_page
from trajopt_cli.page.document import Section
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import facts, points, table
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
# Of axes in one table: ways, and forces, whose unit is the row's.
_WAYS = ("steady", "force_over_stiffness", "largest", "mean", "thesis_largest", "thesis_mean")
_HEAD = ("section", "title", "notes")
_MEASURED = "loop_time"


def experiments_page(numbers: Mapping[str, Any], pictures: Mapping[str, bytes]) -> bytes:
    """The page's bytes. numbers: of record(). pictures: files by name; that of the loop's times, which differ from run
    to run, is named instead."""
    sections = {name: one for name, one in numbers.items() if isinstance(one, dict) and "section" in one}
    groups = [(_overview(sections), list[tuple[str, bytes]]())]
    for name, one in sections.items():
        html = "".join(_tables(one)) + points([*one["notes"], *_only(name)])
        drawn = [(file, pictures[file]) for file in sorted(pictures) if _belongs(file, name, sections)]
        groups.append((Section(name, f"{one['section']} {one['title']}", html), [] if name == _MEASURED else drawn))
    worst = numbers["flange_worst"]
    if worst:
        html = _table("the flange behind the controller, worst of all", worst) + points(numbers["flange_worst_notes"])
        groups.insert(5, (Section("flange", "6.1.5 the flange", html), []))
    about = (
        "Chapter 6 of the thesis that the compliant job goes back to (V. Číhala, Poddajné řízení průmyslového robota, "
        f"ČVUT 2020), its numbers beside ours; engine {numbers['engine']}"
    )
    return picture_page("iiwa experiments", about, groups)


def _overview(sections: Mapping[str, Any]) -> Section:
    rows = [
        (text(one["section"]), f'<a href="#{name}">{text(one["title"])}</a>', text(_summary(one)))
        for name, one in sections.items()
    ]
    return Section(
        "overview", "Overview", table("Every experiment", ("section", "experiment", "note"), rows, html=True)
    )


def _summary(one: Mapping[str, Any]) -> str:
    worst = one.get("largest_relative_difference")
    if worst is not None:
        return f"within {100 * worst:.0f} % of the thesis"
    return next(iter(one["notes"]), "")


def _only(name: str) -> list[str]:
    if name != _MEASURED:
        return []
    return ["What the clock said in this run is in measured.json and loop_time.svg: no two runs are alike in it."]


def _belongs(file: str, name: str, sections: Mapping[str, Any]) -> bool:
    """Whether a picture is of an experiment: its name, alone or with more behind it that no other experiment has."""
    stem, _, ending = file.partition(".")
    best = max((other for other in sections if f"{stem}_".startswith(f"{other}_")), key=len, default="")
    return ending == "svg" and best == name


def _tables(one: Mapping[str, Any]) -> Iterator[str]:
    """Its lists as tables, rows within rows flat, and its single numbers."""
    plain = [
        (*_named(key), value) for key, value in one.items() if key not in _HEAD and isinstance(value, (int, float, str))
    ]
    if plain:
        yield facts((f"{name}{f' [{unit}]' if unit else ''}", _shown(value, size)) for name, unit, size, value in plain)
    for key, rows in one.items():
        if key == "notes" or not isinstance(rows, list) or not rows or not isinstance(rows[0], dict):
            continue
        inner = sorted({name for row in rows for name, value in row.items() if isinstance(value, list)})
        for name in inner:
            flat = [{"setting": row["label"], **part} for row in rows for part in row[name] or []]
            if flat:
                yield _table(name, flat)
        if not inner:
            yield _table(key, rows)


def _table(caption: str, rows: Sequence[Mapping[str, Any]]) -> str:
    """Dictionaries as a table; a dictionary within one has a column for each of its keys."""
    wide = [
        {key if not isinstance(value, dict) else f"{part}|{key}": inner
         for key, value in row.items()
         for part, inner in (value.items() if isinstance(value, dict) else [("", value)])}
        for row in rows
    ]  # fmt: skip
    heads = []
    for key in wide[0]:
        name, unit, _ = _named(key)
        numeric = any(isinstance(row[key], (int, float)) for row in wide)
        heads.append(f"{'>' if numeric else ''}{name}{f' [{unit}]' if unit else ''}")
    cells = [[_cell(key, value, str(row.get("axis", ""))) for key, value in row.items()] for row in wide]
    return table(caption.replace("_", " "), heads, cells)


def _named(key: str) -> tuple[str, str, float]:
    """A recorded name for people, its unit, and what that unit is in SI."""
    part, _, key = key.rpartition("|")
    for ending, unit, size in _UNITS:
        if key.endswith(ending):
            return part or key.removesuffix(ending).replace("_", " "), unit, size
    return part or key.replace("_", " "), "", 1.0


def _cell(key: str, value: Any, axis: str) -> str:
    if key in _WAYS and axis and value is not None:
        return f"{value / DEG:.3f} °" if axis in _TURNS else f"{value / MM:.3f} mm"
    if key == "force":
        return f"{value:g} {'Nm' if axis in _TURNS else 'N'}"
    return _shown(value, _named(key)[2])


def _shown(value: Any, size: float) -> str:
    if value is None:
        return "–"
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    return f"{value / size:.4g}".replace("-", "−")
