"""What a picky reader asks of every picture, measured by the renderer, over several programs and both plans."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import combinations, pairwise
from pathlib import Path

import numpy as np
import pytest
from drawn_plans import Drawn, drawn, many
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text
from test_corner_pictures import series as corners

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.report.bars import Bar, comparison_figure, levers_figure, savings_figure
from trajopt_cli.report.pictures import PICTURES, STEP_PICTURES
from trajopt_cli.report.steps import Steps, steps_of
from trajopt_cli.report.stepwise import analyse
from trajopt_cli.report.style import house_style, new_figure
from trajopt_cli.scenario import Scenario
from trajopt_cli.trajectories.plan_series import PlanSeries, follow

LONG = "the_third_line_of_the_left_magazine_and_of_the_right_magazine_as_of_today.mod"
CASES = ("rail", "no rail", "corners", "many")
STEPS = (1.0, 2.0, 2.5, 4.0, 5.0)  # times a power of ten: what a reader counts by


def case_of(name: str) -> Drawn:
    return many(60) if name == "many" else drawn(rail=name == "rail")


@cache
def series(name: str) -> PlanSeries:
    if name == "corners":
        return corners()
    case = case_of(name)
    return follow(case.program, case.plant, case.plan, LONG)


def written(case: str) -> Steps:
    """A case's program in steps of speed."""
    if case == "hinge_cell":
        path = Path(__file__).parents[2] / "programs" / case
        program, plant = read_program(path.with_suffix(".mod"), Scenario()), build_plant(load_cell(f"{path}.yaml"))
    else:
        program, plant = series(case).program, series(case).plant
    return steps_of(program, plant, analyse(program, plant), LONG)


@cache
def figure(case: str, picture: str) -> Figure | None:
    with house_style():
        made = PICTURES[picture](series(case)) if picture in PICTURES else STEP_PICTURES[picture](written(case))
        if made is not None:
            made.draw_without_rendering()
        return made


def panels(case: str, picture: str) -> list[Axes]:
    made = figure(case, picture)
    return [] if made is None else made.axes


def axes_of(panel: Axes) -> list[str]:
    return ["x", "y", "z"] if panel.name == "3d" else ["x", "y"]


def ticks(panel: Axes, name: str) -> np.ndarray:
    """Where an axis has a number, as shown."""
    axis = getattr(panel, f"{name}axis")
    low, high = sorted(axis.get_view_interval())
    at = np.array([tick for tick in axis.get_majorticklocs() if low - 1e-9 <= tick <= high + 1e-9])
    return at


def shown(made: Figure) -> list[Text]:
    """Every text on the page but for those inside 3-D boxes, whose extent is not in pixels of the page."""
    hidden = set()
    for axes in made.axes:
        for name in axes_of(axes):
            axis = getattr(axes, f"{name}axis")
            hidden |= {label for tick in axis.get_major_ticks() for label in (tick.label1, tick.label2)}
            # Those of them that are in view; in a box all are, and asking would move them.
            seen = axis.get_major_ticks() if axes.name == "3d" else axis._update_ticks()
            hidden -= {tick.label1 for tick in seen}
    texts = [text for text in made.findobj(Text) if type(text).__name__ != "Text3D" and text not in hidden]
    return [text for text in texts if text.get_visible() and text.get_text().strip()]


EVERY = [(case, picture) for case in CASES for picture in (*PICTURES, *STEP_PICTURES)]
# The panels of joints are alike for two with a rail and for two without one: of the limits, which they share.
EVERY = [one for one in EVERY if one not in {("rail", "joints"), ("no rail", "joints")}]
# As written, the arm of the hinge cell goes only up and down, seen from the carriage.
EVERY += [("hinge_cell", picture) for picture in STEP_PICTURES]


@pytest.mark.parametrize(("case", "picture"), EVERY)
def test_numbers_on_the_axes_are_round_and_two_at_least(case: str, picture: str) -> None:
    wrong = []
    for panel in panels(case, picture):
        for name in axes_of(panel):
            at = ticks(panel, name)
            step = np.diff(at).min() if len(at) > 1 else np.nan
            digits = step / 10 ** np.floor(np.log10(step)) if step > 0 else np.nan
            # evenly apart, by a round step, and through zero if they went on
            even = np.allclose(np.diff(at), step) and np.allclose(at / step, np.round(at / step), atol=1e-6)
            if not even or not np.isclose(digits, STEPS).any():
                wrong.append((name, at.tolist()))
    # A foreshortened axis of a box may show 50 and 150, every second of a round row.
    assert [one for one in wrong if picture != "arm" or one != ("y", [50.0, 150.0])] == []


@pytest.mark.parametrize(("case", "picture"), EVERY)
def test_every_axis_of_every_panel_says_what_it_is_and_in_what_unit(case: str, picture: str) -> None:
    made = figure(case, picture)
    for panel in panels(case, picture):
        assert made is not None
        for name in axes_of(panel):
            axis = panel
            if name == "x" and not panel.get_xlabel():  # above another one that shares its axis and has the label
                under = [other for other in made.axes if panel.get_shared_x_axes().joined(panel, other)]
                under = [other for other in under if np.isclose(other.get_position().x0, panel.get_position().x0)]
                axis = min(under, key=lambda other: other.get_position().y0)
            assert "[" in getattr(axis, f"get_{name}label")(), (panel.get_title(), name)


@pytest.mark.parametrize(("case", "picture"), EVERY)
def test_no_panel_is_empty(case: str, picture: str) -> None:
    """A panel shows a curve that is more than a point, inside it."""
    for panel in panels(case, picture):
        frame, reach = panel.get_window_extent(), []
        for line in panel.lines:
            if panel.name == "3d" or line.get_gid() == "ground" or len(line.get_xdata()) < 2:
                continue
            pixels = panel.transData.transform(np.column_stack(line.get_data()))
            reach.append(np.ptp(pixels[np.isfinite(pixels).all(axis=1)], axis=0).max())
        assert panel.name == "3d" or max(reach) > 0.05 * frame.width


@pytest.mark.parametrize(("case", "picture"), EVERY)
def test_texts_are_legible_inside_the_page_and_none_is_on_another(case: str, picture: str) -> None:
    made = figure(case, picture)
    if made is not None:
        texts = shown(made)
        assert outside(made, texts) == []
        assert list(overlapping(made, texts)) == []
        assert min(text.get_fontsize() for text in texts) >= 10  # legible at half size


def outside(made: Figure, texts: list[Text]) -> list[str]:
    page = made.bbox.padded(1)
    boxes = [(text.get_text(), Text.get_window_extent(text)) for text in texts]
    return [text for text, box in boxes if not (page.contains(box.x0, box.y0) and page.contains(box.x1, box.y1))]


def overlapping(made: Figure, texts: list[Text]) -> Iterator[tuple[str, str]]:
    """Pairs of texts that cover each other by more than a pixel; slanted ones by the strip that they stand in."""
    level = [(text.get_text(), Text.get_window_extent(text)) for text in texts if text.get_rotation() in (0, 90)]
    for (a, one), (b, other) in combinations(level, 2):
        if min(one.x1, other.x1) - max(one.x0, other.x0) > 1 and min(one.y1, other.y1) - max(one.y0, other.y0) > 1:
            yield a, b
    slanted = [text for text in texts if text.get_rotation() not in (0, 90)]
    if slanted and made.axes[0].name != "3d":
        feet = sorted(Text.get_window_extent(text).x0 for text in slanted)
        wanted = slanted[0].get_fontsize() * made.dpi / 72 / np.sin(np.radians(slanted[0].get_rotation()))
        for low, high in pairwise(feet):
            if high - low < wanted:
                yield f"slanted at {low:.0f}", f"at {high:.0f} px"


@pytest.mark.parametrize("case", CASES)
def test_the_title_says_whose_plan_it_is(case: str) -> None:
    """In words, whole, however long the program's name."""
    wanted = {Target.STREAM: "stream plan, for a machine", Target.RAPID: "RAPID plan, for the controller"}
    for picture in PICTURES:
        made = figure(case, picture) if (case, picture) in EVERY else None
        if made is not None:
            told = [text.get_text() for text in made.texts if wanted[series(case).plan.target] in text.get_text()]
            assert len(told) == 1, picture
            assert told[0].endswith(f"cycle {series(case).plan.duration:.3f} s")


def test_without_a_rail_nothing_speaks_of_one() -> None:
    assert figure("many", "rail") is None
    figures = [made for name in PICTURES if (made := figure("many", name)) is not None]
    words = [text.get_text().lower() for made in figures for text in made.findobj(Text)]
    assert any("time" in text for text in words)
    assert [text for text in words if "rail" in text or "carriage" in text] == []


def test_a_heading_loses_no_more_letters_than_it_must() -> None:
    with house_style():
        for name in ("p" * 300, "short.mod", LONG * 3):
            made = new_figure(4.0, f"{name} · stream plan")
            (heading,) = made.texts
            told = heading.get_text()
            assert told.endswith(" · stream plan")
            assert outside(made, shown(made)) == []
            if told.startswith(name):
                continue
            head, tail = told.removesuffix(" · stream plan").split("…")
            assert len(tail) - len(head) in (0, 1)
            heading.set_text(f"{name[: len(tail)]}…{name[-len(head) - 1 :]} · stream plan")  # a letter more
            assert heading.get_window_extent().x1 > 0.985 * made.bbox.x1


def test_directions_are_the_ways_the_tool_goes() -> None:
    """Each arrow of `path` lies on the path and points along the tool's velocity there."""
    c = series("rail")
    made = figure("rail", "path")
    assert made is not None
    for panel, up in ((made.axes[0], 2), (made.axes[2], 0)):
        arrows = [one for one in panel.texts if one.get_gid() == "direction"]
        assert len(arrows) >= 3
        plane = [1, up]
        for arrow in arrows:
            tip, tail = np.array(arrow.xy) * 1e-3, np.array(arrow.get_position()) * 1e-3
            away = np.linalg.norm(c.X_WT[:, :3, 3][:, plane] - (tip + tail) / 2, axis=1)
            assert away.min() < 3e-3
            there = c.V_WT[away < away.min() + 3e-3][:, plane]
            assert ((there @ (tip - tail)) > 0).any()


def test_the_rail_is_drawn_from_end_to_end_and_the_carriage_where_the_base_is() -> None:
    made = figure("rail", "path")
    assert made is not None
    limits, base = series("rail").plant.limits, series("rail").plant.robot.X_WB0[:3, 3]
    (rail,) = [line for line in made.axes[0].lines if line.get_gid() == "ground"]
    assert rail.get_xdata() == pytest.approx(1e3 * (base[1] + np.array([limits.lower[0], limits.upper[0]])))
    (carriage,) = [line for line in made.axes[1].lines if line.get_gid() == "ground"]
    assert [*carriage.get_xdata(), *carriage.get_ydata()] == pytest.approx([1e3 * base[1], 1e3 * base[2]])
    bare = figure("no rail", "path")
    assert bare is not None
    assert not [line for axes in bare.axes for line in axes.lines if line.get_gid() == "ground"]


def test_bars_are_readable_too() -> None:
    what = "the best rail position per station, the rail still there, and what else there is"
    rows = [
        Bar("practice", what, 10.5, True),
        Bar("bang-bang", what, 7.4, False),
        Bar("optimum stream", what, 6.5, True, 6.1),
    ]
    bars = [
        (f"v500 of MoveL p_number_{k} at a_long_name.mod:{k}, +10 %", 0.1 / (k + 1), 0.12 / (k + 1)) for k in range(20)
    ]
    causes = [("as written, fly-bys as stops", 9.0), ("retimed: joint moves bend", 7.0), ("rail through stops", 7.0)]
    told: list[set[str]] = []
    with house_style():
        for made in (comparison_figure(rows, LONG), savings_figure(causes, LONG), levers_figure(bars, 6.5, LONG)):
            made.draw_without_rendering()
            texts = shown(made)
            assert outside(made, texts) == []
            assert list(overlapping(made, texts)) == []
            told.append({text.get_text() for text in texts})
    assert {one for row in rows for one in (row.name, row.what)} <= told[0]
    assert {name for name, _ in causes} <= told[1]
    assert {name for name, _, _ in bars[:16]} <= told[2]
