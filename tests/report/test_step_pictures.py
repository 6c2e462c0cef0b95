"""Pictures of a program in steps of speed: what they show equals targets and speeds as written, worked out by hand."""

from __future__ import annotations

from functools import cache
from itertools import combinations, pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.motion import Program
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.report import steps
from trajopt_cli.report.names import _apart
from trajopt_cli.report.pictures import STEP_PICTURES, stepwise
from trajopt_cli.report.stepwise import Analysis, analyse
from trajopt_cli.report.style import house_style
from trajopt_cli.scenario import Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
CELL = """
robot: irb140_rail
rail: {eax: a, stroke: [-0.2, 2.2]}
limits: {rail: {velocity: 1.0, acceleration: 2.0, source: the test's}}
tcp: {speed: 2.5, acceleration: 20, source: the test's}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
FIXED = "robot: irb140\nbase: {position: [0, 0, 0], rpy: [0, 0, 0]}\nstart: {joints: [0, 0, 0, 0, 0, 0]}\n"
# Targets in the world [mm] and the rail's place there [mm].
POINTS = {"p_1": ((500, 200, 400), 0), "p_2": ((530, 240, 280), 0), "p_3": ((530, 1740, 280), 1500),
          "p_4": ((530, 900, 280), 1000)}  # fmt: skip
CODE = """MoveJ p_1, v1000, fine, tool0;
    MoveL p_2, v500, fine, tool0; ! trajopt: optional
    WaitTime 0.5;
    MoveJ p_3, v2500, fine, tool0;
    MoveJ p_4, v200, fine, tool0;"""
HOME = (515.0 - 65 * (1 - np.cos(np.pi / 6)), 0.0, 712.0 - 65 * 0.5)  # mm: the flange tilted down by 30 degrees


Read = tuple[Program, Plant, Analysis]


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> Read:
    return read(tmp_path_factory.mktemp("steps"), CELL, CODE)


def read(folder: Path, cell: str, code: str) -> Read:
    data = "".join(
        f"CONST robtarget {name}:=[[{x},{y},{z}],[0,0,1,0],[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]];\n"
        for name, ((x, y, z), eax) in POINTS.items()
    )
    if cell == FIXED:
        data = data.replace("[1500,", "[9E9,").replace("[1000,", "[9E9,").replace("[0,9E9,", "[9E9,9E9,")
    path = folder / "part.mod"
    path.write_text(f"MODULE Part\n{data}PROC main()\n{code}\nENDPROC\nENDMODULE\n")
    program = read_program(path, Scenario())
    plant = build_plant(parse_cell(cell, "part.yaml"))
    return program, plant, analyse(program, plant)


def curve(figure: Figure, name: str) -> np.ndarray:
    (line,) = [line for axes in figure.axes for line in axes.lines if line.get_gid() == name]
    return np.array(line.get_xydata())


def drawn(picture: str, case: Read) -> Figure:
    with house_style():
        return STEP_PICTURES[picture](steps.steps_of(*case, "part"))


@cache
def drawn_line(picture: str) -> Figure:
    """The shipped line's, which has the most points; nobody changes it."""
    program = read_program(PROGRAMS / "hinge_line.mod", Scenario())
    plant = build_plant(load_cell(PROGRAMS / "hinge_line.yaml"))
    return drawn(picture, (program, plant, analyse(program, plant)))


def test_speeds_are_those_written_and_the_rail_alone_is_marked(case: Read) -> None:
    """p_1 to p_2 is a 30-40-120 box at v500; to p_3 only the rail moves, 2 s; to p_4 340 mm at v200 beside 1 s + 0.5 m.

    The rail's 0.5 m at 1 m/s and 2 m/s² just touch its top speed: 1 s, less than the arm's 1.7 s.
    """
    figure = drawn("steps_speed", case)
    first = np.linalg.norm(np.subtract((500, 200, 400), HOME)) / 1000
    begins = case[2].begins
    assert np.diff(begins) == pytest.approx([first, 0.26, 2.0, 1.7])
    speed = curve(figure, "speed")
    middles = (begins[1:] + begins[:-1]) / 2
    assert np.interp(middles, *speed.T) == pytest.approx([1000, 500, 0, 200])
    box = np.interp(middles[1], *curve(figure, "x").T), np.interp(middles[1], *curve(figure, "y").T)
    assert (*box, np.interp(middles[1], *curve(figure, "z").T)) == pytest.approx(500 * np.array([30, 40, -120]) / 130)
    bands = [c for axes in figure.axes for c in axes.collections if c.get_gid() == "band"]
    assert len(bands) == 2
    for band in bands:
        (outline,) = [path.vertices for path in band.get_paths()]
        assert (outline[:, 0].min(), outline[:, 0].max()) == pytest.approx((begins[2], begins[3]))


def test_axis_speeds_add_up_to_the_ways_between_the_points(case: Read) -> None:
    figure = drawn("steps_speed", case)
    seen = [HOME, *(np.subtract(place, (0, rail, 0)) for place, rail in POINTS.values())]
    for i, name in enumerate("xyz"):
        t, v = curve(figure, name).T
        way = np.concatenate([[0], np.cumsum(np.diff(t) * (v[1:] + v[:-1]) / 2)])
        for begin, place in zip(case[2].begins, seen, strict=True):
            assert np.interp(begin, t, way) == pytest.approx(place[i] - HOME[i], abs=1e-6), (name, begin)


def test_paths_go_through_the_points_in_both_spaces_and_tell_the_parts_apart(case: Read) -> None:
    figure = drawn("steps_path", case)
    real = [HOME, *(place for place, _ in POINTS.values())]
    seen = [HOME, *(np.subtract(place, (0, rail, 0)) for place, rail in POINTS.values())]
    kinds = [steps.FUNCTIONAL, steps.OPTIONAL, steps.RAIL, steps.FUNCTIONAL]
    for column, places in enumerate((real, seen)):
        for row, up in enumerate((2, 0)):
            axes = figure.axes[2 * row + column]
            ways = [line for line in axes.lines if line.get_gid() not in (None, "ground")]
            assert [line.get_gid() for line in ways] == kinds
            for line, a, b in zip(ways, places, places[1:], strict=False):
                xy = np.array(line.get_xydata())
                assert np.allclose(xy[[0, -1]], [[a[1], a[up]], [b[1], b[up]]], atol=1e-6)
                shares = np.linspace(0, 1, len(xy))[:, None]
                assert np.allclose(xy, xy[0] + shares * (xy[-1] - xy[0]), atol=1e-6)
    styles = [(line.get_color(), line.get_linestyle()) for line in ways[:3]]
    assert len(set(styles)) == 3
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert labels == ["has to be driven", "may be left out", "only the rail moves", "rail", "carriage"]
    named = [text.get_text() for text in figure.axes[0].texts if text.get_text()]
    assert named == ["start", "p_1", "p_2", "p_3", "p_4"]
    assert [text.get_text() for text in figure.axes[1].texts if text.get_text()] == ["start", "p_1", "p_2\np_3", "p_4"]


def test_the_lines_sums_stand_in_its_pictures() -> None:
    figure = drawn_line("steps_speed")
    assert any("arm 5.557 s + rail 4.000 s = 9.557 s" in text.get_text() for text in figure.texts)
    assert curve(figure, "speed")[-1, 0] == pytest.approx(9.557, abs=0.01)


@pytest.mark.parametrize("picture", STEP_PICTURES)
def test_names_stand_apart_and_inside_the_page(picture: str) -> None:
    """No two names touch, and all of them are shown."""
    figure = drawn_line(picture)
    figure.draw_without_rendering()
    page = figure.bbox.padded(1)
    shown = 0
    for axes in figure.axes:
        names = [text for text in axes.texts if text.get_text() and text.get_visible()]
        shown += sum(len(name.get_text().split("\n")) for name in names)
        boxes = [Text.get_window_extent(name) for name in names]  # without the line to its place
        outside = [box for box in boxes if not (page.contains(box.x0, box.y0) and page.contains(box.x1, box.y1))]
        assert outside == []
        level = [box for name, box in zip(names, boxes, strict=True) if not name.get_rotation()]
        assert not [1 for a, b in combinations(level, 2) if a.overlaps(b)]
        slanted = sorted(box.x0 for name, box in zip(names, boxes, strict=True) if name.get_rotation())
        assert all(b - a > 24 for a, b in pairwise(slanted))  # px, at 50 degrees a line of text 18 px high
    assert shown >= 18


def test_spreading_moves_as_little_as_can_be() -> None:
    assert _apart(np.array([0.0, 50.0, 51.0, 90.0]), 11.0, 0.0, 90.0) == pytest.approx([0, 45, 56, 90])
    assert _apart(np.array([88.0, 89.0, 90.0]), 10.0, 0.0, 90.0) == pytest.approx([70, 80, 90])
    assert _apart(np.array([0.0, 1.0]), 10.0, 0.0, 90.0) == pytest.approx([0, 10])


@pytest.mark.long
def test_without_a_rail_there_is_one_space_and_without_moves_no_picture(tmp_path: Path) -> None:
    case = read(tmp_path, FIXED, "MoveJ p_1, v1000, fine, tool0;\nMoveL p_2, v500, fine, tool0;")
    files = stepwise(*case, "part")
    assert set(files) == {f"{name}.{kind}" for name in ("steps_speed", "steps_path") for kind in ("svg", "png")}
    assert files == stepwise(*case, "part")
    for name in ("steps_speed.svg", "steps_path.svg"):
        assert b"carriage" not in files[name]
        assert b"rail" not in files[name]
    assert stepwise(*read(tmp_path, FIXED, "WaitTime 1;"), "part") == {}
