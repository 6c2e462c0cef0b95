"""The page of a study in a browser: a point that is chosen anywhere is shown everywhere."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from window import Window

from trajopt_cli.parameter_study.analysis import StudyRows, variance_shares
from trajopt_cli.parameter_study.study_page import study_page

SPEEDS, HEIGHTS = (1.0, 1.5, 2.0, 3.0), (0.0, 0.1, 0.2)
CHANGE = "const s = document.getElementById('up'); s.value = arguments[0]; s.dispatchEvent(new Event('change'))"
TEXT = "</script><script>document.title='no'</script>"


@pytest.fixture(scope="module")
def rows() -> StudyRows:
    """Four rails, three heights, two robots; the slowest rail cannot be used high up."""
    columns: dict[str, list[Any]] = {name: [] for name in ("limits.rail.velocity_m_per_s", "base_z_m", "robot")}
    columns |= {name: [] for name in ("rapid_s", "price", "status", "reason")}
    for v, z, robot in product(SPEEDS, HEIGHTS, ("a", "b")):
        bad = (v, z) == (1.0, 0.2)
        seconds = None if bad else 6 + 2 / v + 3 * (z - 0.12) ** 2 - 0.4 * (robot == "b")
        row = (v, z, robot, seconds, 1000 * v + 4000 * (robot == "b"), "infeasible" if bad else "ok", TEXT * bad)
        for column, value in zip(columns.values(), row, strict=True):
            column.append(value)
    units = {"limits.rail.velocity_m_per_s": "m/s", "base_z_m": "m", "rapid_s": "s"}
    return StudyRows({"point": [*range(24)], **columns}, units)


@pytest.fixture(scope="module")
def page(rows: StudyRows, written: Callable[[str, bytes], Path]) -> Path:
    shares = variance_shares(rows, "rapid_s")
    return written(
        "study.html", study_page("which <rail>", rows, "rapid_s", "price", 24, shares, {21: "plans/21/report.html"})
    )


def chosen(window: Window) -> str:
    return str(window.run("const it = document.getElementById('chosen'); return it.hidden ? '' : it.textContent"))


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_a_point_is_chosen_by_table_and_map(window: Window, page: Path, width: int, theme: str) -> None:
    window.open(page, width, 900, theme)
    assert window.run("return document.title") == "which <rail> · trajopt"
    assert window.run("return document.documentElement.scrollWidth <= innerWidth")
    assert chosen(window) == ""
    # the best point: the fastest rail, 0.1 m, robot b
    assert window.run("const b = document.querySelector('[data-point]'); b.click(); return b.textContent") == "21"
    assert "velocity [m/s]: 3" in chosen(window)
    assert "robot: b" in chosen(window)
    assert window.run("return document.querySelector('#chosen a').getAttribute('href')") == "plans/21/report.html"
    window.run(CHANGE, "base_z_m")
    # the map's cell at the lower left: the slowest rail at 0 m, the better of two robots there
    click = (
        "const it = document.querySelector('#heat canvas'), box = it.getBoundingClientRect();"
        "it.dispatchEvent(new MouseEvent('click', {clientX: box.left + arguments[0] * box.width,"
        "clientY: box.top + arguments[1] * box.height, bubbles: true}))"
    )
    window.run(click, 0.28, 0.8)
    assert "Point 1 " in chosen(window)
    # and that of a point that cannot be done says why
    window.run(click, 0.28, 0.12)
    assert "Point 4 " in chosen(window)
    assert TEXT in chosen(window)
    window.run("document.querySelector('#chosen button').click()")
    assert chosen(window) == ""


def test_charts_are_drawn_and_follow_what_is_asked(window: Window, page: Path) -> None:
    window.open(page, 1280, 900)
    inked = "return document.querySelector(arguments[0]).toDataURL()"
    before = {name: window.run(inked, f"#{name} canvas") for name in ("heat", "parallel", "spread")}
    window.run(CHANGE, "price")
    after = {name: window.run(inked, f"#{name} canvas") for name in before}
    assert after["heat"] != before["heat"]
    # lines that do not pass a part of an axis are left out, also far from it
    drag = (
        "const it = document.querySelector('#parallel canvas'), box = it.getBoundingClientRect();"
        "for (const [kind, y] of [['pointerdown', 0.15], ['pointerup', 0.3]]) it.dispatchEvent(new PointerEvent(kind, "
        "{clientX: box.left + 62, clientY: box.top + y * box.height, bubbles: true}))"
    )
    between = (
        "const all = document.querySelector('#parallel canvas'), part = document.createElement('canvas');"
        "part.getContext('2d').drawImage(all, -0.8 * all.width, -0.3 * all.height); return part.toDataURL()"
    )
    whole = window.run(between)
    window.run(drag)
    assert window.run(between) != whole
