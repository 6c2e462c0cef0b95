"""Pictures: what they show equals what the plan says, every text is there, and the same plan gives the same bytes."""

from __future__ import annotations

import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from functools import cache
from hashlib import sha256
from itertools import combinations
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from drawn_plans import PAUSE, TOOL, Drawn, as_svg, drawn
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from trajopt_cli.report import style
from trajopt_cli.report.bars import Bar, comparison, comparison_figure, savings, savings_figure
from trajopt_cli.report.pictures import PICTURES, draw
from trajopt_cli.report.skeleton import skeleton
from trajopt_cli.report.style import files, house_style, new_figure, settle
from trajopt_cli.trajectories.plan_series import PlanSeries, follow

RAIL, BARE = drawn(rail=True), drawn(rail=False)


def series(case: Drawn) -> PlanSeries:
    return follow(case.program, case.plant, case.plan, "cell")


@cache
def figure(picture: str, rail: bool = True) -> Figure:
    """A picture of a plan; nobody changes it."""
    with style.house_style():
        made = PICTURES[picture](series(RAIL if rail else BARE))
    assert made is not None
    return made


@pytest.fixture(scope="module")
def with_rail() -> dict[str, bytes]:
    """As draw gives it, of the figures that the other tests look at; another process has it draw its own."""
    with pytest.MonkeyPatch.context() as patch:
        pictures = {name: lambda _, name=name: figure(name) for name in PICTURES}
        patch.setattr("trajopt_cli.report.pictures.PICTURES", pictures)
        patch.setattr(Figure, "savefig", as_svg)
        return draw(RAIL.program, RAIL.plant, RAIL.plan, "cell")


def texts(svg: bytes) -> list[str]:
    """Texts are drawn as outlines; each stands beside them as a comment."""
    root = ET.fromstring(svg, ET.XMLParser(target=ET.TreeBuilder(insert_comments=True)))
    return [element.text.strip() for element in root.iter() if element.tag is ET.Comment and element.text]


@pytest.mark.long
def test_each_picture_comes_twice_and_small(with_rail: dict[str, bytes]) -> None:
    assert set(with_rail) == {f"{name}.{kind}" for name in PICTURES for kind in ("svg", "png")}
    assert max(len(content) for name, content in with_rail.items() if name.endswith("svg")) < 400_000


def test_the_same_plan_gives_the_same_bytes_whatever_the_users_style(monkeypatch: pytest.MonkeyPatch) -> None:
    """And the style is put back. One picture here, all of them in another process. Without a rail, none of it."""
    monkeypatch.setattr(
        "trajopt_cli.report.pictures.PICTURES", {name: PICTURES[name] for name in ("rail", "tcp_speed")}
    )
    first = draw(BARE.program, BARE.plant, BARE.plan, "cell")
    assert set(first) == {"tcp_speed.svg", "tcp_speed.png"}
    with matplotlib.rc_context({"font.size": 30, "axes.grid": True, "lines.linewidth": 9}):
        again = draw(BARE.program, BARE.plant, BARE.plan, "cell")
        assert matplotlib.rcParams["font.size"] == 30
    assert again == first


_AGAIN = """
from hashlib import sha256
from drawn_plans import as_svg, drawn
from matplotlib.figure import Figure
from trajopt_cli.report.pictures import draw
case, Figure.savefig = drawn(rail=True), as_svg
for name, content in draw(case.program, case.plant, case.plan, "cell").items():
    if content:
        print(name, sha256(content).hexdigest())
"""


@pytest.mark.long
def test_another_process_gives_the_same_bytes(with_rail: dict[str, bytes], tmp_path: Path) -> None:
    folders = os.pathsep.join(str(Path(__file__).parents[i]) for i in (0, 2))
    # Another order of sets and an eager user's settings must not be seen.
    (tmp_path / "matplotlibrc").write_text(
        "font.size: 30\nsvg.fonttype: none\nsavefig.dpi: 40\naxes.grid: True\nlines.linewidth: 9\n"
    )
    around = {"PYTHONPATH": folders, "PYTHONHASHSEED": "7", "MATPLOTLIBRC": str(tmp_path), "TZ": "Asia/Tokyo"}
    done = subprocess.run(
        [sys.executable, "-c", _AGAIN],
        cwd=tmp_path,
        env=os.environ | around,
        capture_output=True,
        text=True,
        check=True,
    )
    asked = [name for name in with_rail if name.endswith(".svg") or name == "rail.png"]
    here = [f"{name} {sha256(with_rail[name]).hexdigest()}" for name in asked]
    assert done.stdout.splitlines() == here


def test_accelerations_are_drawn_to_the_limit_and_never_over_it() -> None:
    names, limits = RAIL.plant.limits.names, RAIL.plant.limits
    shares = []
    for k, name in enumerate(names):
        axes = figure("joints").axes[3 * k + 2]
        drawn_line = max(axes.lines, key=lambda line: len(line.get_xdata()))
        peak = np.abs(drawn_line.get_ydata()).max() * (1e-3 if name == "rail" else np.pi / 180)
        shares.append(peak / limits.acceleration[k])
        dashed = sorted(line.get_ydata()[0] for line in axes.lines if line is not drawn_line)
        unit = 1e-3 if name == "rail" else np.pi / 180
        assert np.allclose(dashed, np.array([-1, 1]) * limits.acceleration[k] / unit)
    q, T = RAIL.plan.motions[0], RAIL.plan.motions[0].t_1
    assert max(shares) <= 1 + 1e-6
    assert shares[0] >= abs(4 * (q.q_1[0] - q.q_0[0]) / T**2) / limits.acceleration[0] - 1e-6


def test_the_rail_stands_within_reach_of_each_point_and_where_the_plan_says() -> None:
    (axes,) = figure("rail").axes
    (curve,) = [line for line in axes.lines if line.get_gid() == "rail"]
    reach = [np.array(c.get_segments()[0]) for c in axes.collections if c.get_gid() == "reach"]
    assert [segment[0, 0] for segment in reach] == pytest.approx([RAIL.plan.motions[i].t_1 for i in (0, 2)])
    for segment, rail in zip(reach, (150.0, 500.0), strict=True):
        at = np.interp(segment[0, 0], curve.get_xdata(), curve.get_ydata())
        assert at == pytest.approx(rail, abs=1e-6)
        assert segment[0, 1] < at < segment[1, 1]


def test_the_tcps_speed_is_the_change_of_its_place() -> None:
    shown_speed = figure("tcp_speed")
    (curve,) = [line for line in shown_speed.axes[0].lines if line.get_gid() == "speed"]
    times, q, v = RAIL.plan.trajectory.t, RAIL.plan.trajectory.q, RAIL.plan.trajectory.qd
    h = 1e-5  # s, straight along the axes' speeds: central differences are right to its square
    tip = [(RAIL.plant.robot.forward(q + step * v) @ TOOL.X_FT)[:, :3, 3] for step in (-h, h)]
    slope = np.linalg.norm(tip[1] - tip[0], axis=1) / (2 * h) * 1e3
    shown = np.interp(times, curve.get_xdata(), curve.get_ydata())
    assert np.abs(slope - shown).max() < 1e-3  # mm/s
    assert slope.max() > 500
    programmed = [line.get_ydata()[0] for line in shown_speed.axes[0].lines if line.get_gid() == "programmed"]
    assert programmed == pytest.approx([800.0] * 3)


def test_seen_from_the_carriage_the_wait_is_at_rest_and_the_speed_is_less_the_rails() -> None:
    c = series(RAIL)
    world, carriage = ([line.get_ydata() for line in axes.lines[:3]] for axes in figure("effector").axes[1:3])
    rail = c.qd[:, 0] * 1e3
    assert np.allclose(world[1] - carriage[1], rail, atol=1e-9)  # the rail runs along y
    assert np.allclose(world[0], carriage[0])
    waiting = (c.t > c.legs[1].t_0) & (c.t < c.legs[1].t_1)
    assert c.legs[1].t_1 - c.legs[1].t_0 == pytest.approx(PAUSE)
    assert np.abs(np.array(carriage)[:, waiting]).max() == 0


def test_the_wrists_path_is_inside_the_outlines_and_the_links_keep_their_lengths() -> None:
    c = series(BARE)
    (axes,) = figure("workspace", rail=False).axes[:1]
    (wrist,) = [line for line in axes.lines if line.get_gid() == "wrist"]
    arm, limits = BARE.plant.robot.arm, BARE.plant.limits
    flange = BARE.plant.robot.forward(c.q)
    centre = (flange[:, :3, 3] - arm.c4 * flange[:, :3, 2]) * 1e3  # the wrist centre is behind the flange
    ahead = centre[:, 0] * np.cos(c.q[:, 0]) + centre[:, 1] * np.sin(c.q[:, 0])
    assert np.allclose(wrist.get_xydata(), np.column_stack([ahead, centre[:, 2]]), atol=1e-6)
    outlines = [patch.get_path() for patch in axes.patches]
    assert any(outline.contains_points(wrist.get_xydata()).all() for outline in outlines)
    # Both elbows: inside are exactly the places that joints 2 and 3 within their limits bring the wrist to.
    joints = np.random.default_rng(5).uniform(limits.lower[1:3], limits.upper[1:3], (4000, 2))
    reached = 1e3 * np.column_stack([
        arm.a1 + arm.c2 * np.sin(joints[:, 0]) + arm.c3 * np.cos(joints.sum(axis=1)),
        arm.c1 + arm.c2 * np.cos(joints[:, 0]) - arm.c3 * np.sin(joints.sum(axis=1)),
    ])  # fmt: skip
    held = np.any([outline.contains_points(reached) for outline in outlines], axis=0)
    assert held.mean() > 0.985  # the outlines are chords of arcs
    shoulder = 1e3 * np.array([arm.a1, arm.c1])
    for outline in outlines:
        far = np.linalg.norm(outline.vertices - shoulder, axis=1)
        assert far.max() == pytest.approx(1e3 * (arm.c2 + arm.c3), abs=0.5)
    shape = skeleton(BARE.plant, c.q[len(c.t) // 3], c.legs[0].X_FT)
    lengths = np.linalg.norm(np.diff(shape, axis=0), axis=1)
    assert lengths == pytest.approx([arm.c1, arm.a1, arm.c2, arm.c3, arm.c4, 0.05])


# Machado, Oliveira, Fernandes 2009, severity 1.0, on linear RGB.
DEUTERANOPIA = np.array(
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]]
)
PROTANOPIA = np.array(
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
)


def lab(color: str, seen: np.ndarray) -> np.ndarray:
    """CIELAB (D65) of a colour as somebody sees it."""
    rgb = np.array([int(color[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    linear = np.clip(seen @ linear, 0, 1)
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    f = to_xyz @ linear / [0.9505, 1.0, 1.089]
    f = np.where(f > 216 / 24389, np.cbrt(f), (24389 / 27 * f + 16) / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


@pytest.mark.parametrize("seen", [np.eye(3), DEUTERANOPIA, PROTANOPIA])
@pytest.mark.parametrize("styles", [style.AXIS_STYLES, style.JOINT_STYLES])
def test_colour_blind_readers_can_tell_the_curves_apart(seen: np.ndarray, styles: tuple) -> None:
    for (a, dash_a), (b, dash_b) in combinations(styles, 2):
        difference = np.linalg.norm(lab(a, seen) - lab(b, seen))
        # 2.3 is just noticeable; thin lines need several times as much, and a line style of their own.
        assert difference > 12, (a, b, difference)
        assert dash_a != dash_b or difference > 30, (a, b)


ROWS = [
    Bar("b", "what b does", 5.0, False),
    Bar("a", "what a does", 9.0, True),
    Bar("c", "what c does", 6.0, True, 5.5),
]


def test_savings_steps_add_up_and_comparison_marks_what_is_illegal() -> None:
    steps = [("as written", 9.0), ("retimed", 7.5), ("margin", 7.75), ("rail", 6.0)]
    with style.house_style():
        bars = savings_figure(steps, "Saving").axes[0].patches
        compared = comparison_figure(ROWS, "Rows").axes[0]
    assert [bar.get_width() for bar in bars] == pytest.approx([9.0, 1.5, 0.25, 1.75, 6.0])
    assert [bar.get_x() for bar in bars] == pytest.approx([0, 7.5, 7.5, 6.0, 0])
    assert bars[1].get_facecolor() != bars[2].get_facecolor()
    assert [bool(bar.get_hatch()) for bar in compared.patches] == [True, False, False]
    assert [line.get_xdata()[0] for line in compared.lines if line.get_gid() == "reference"] == [9.0]
    assert [line.get_xdata()[0] for line in compared.lines if line.get_gid() == "bound"] == [5.5]
    files = savings(steps, "Saving") | comparison(ROWS, "Rows")
    assert set(files) == {f"{name}.{kind}" for name in ("savings", "comparison") for kind in ("svg", "png")}
    assert {"as written", "−1.500 s", "+0.250 s", "6.000 s", "cycle time [s]"} <= set(texts(files["savings.svg"]))
    told = {"5.000 s, breaks a limit", "9.000 s, reference", "6.000 s, −33.3 %, bound 5.500 s", "what a does"}
    assert told | {"Rows · savings count against a, the first legal row"} <= set(texts(files["comparison.svg"]))


def test_too_little_to_compare_is_said() -> None:
    with pytest.raises(ValueError, match="a start and at least one step, not 1"):
        savings([("as written", 9.0)], "Saving")
    with pytest.raises(ValueError, match="at least one row"):
        comparison([], "Rows")


def test_what_a_layout_leaves_in_the_last_digits_is_not_in_the_file(monkeypatch: pytest.MonkeyPatch) -> None:
    def drawn(noise: float) -> dict[str, bytes]:
        execute = ConstrainedLayoutEngine.execute

        def with_noise(self: ConstrainedLayoutEngine, figure: Figure) -> None:
            execute(self, figure)
            for axes in figure.axes:
                axes.set_position(np.add(axes.get_position().bounds, noise).tolist())

        monkeypatch.setattr(ConstrainedLayoutEngine, "execute", with_noise)
        with house_style():
            figure = new_figure(3.0, "heading")
            for axes in figure.subplots(2):
                axes.plot([0, 1, 2], [3, 1, 2])
            settle(figure)
            made = files("one", figure, "title")
        monkeypatch.undo()
        return made

    assert drawn(0.0) == drawn(1e-14)
