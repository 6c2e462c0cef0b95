"""The map of path and arm angle: what is forbidden stands where it is, flips and courses, too."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.arm_angle import ArmAngleSeries, map_figure
from trajopt_cli.iiwa.task.arm_map import ArmMap, ArmTask, arm_map, stages
from trajopt_cli.iiwa.task.joint_checks import Arm
from trajopt_cli.report.style import house_style
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle, configuration, inverse, inverse_branch

ROBOT = load_srs("iiwa7")
LIMITS = ROBOT.profile()
UPRIGHT = np.radians([30, 0, 40, -90, 20, 60, 10])  # joint_2 = 0: the elbow straight over the shoulder
T = np.arange(401) * 1e-2


@pytest.fixture(scope="module")
def drawn() -> tuple[Figure, ArmMap, Array, list[ArmAngleSeries]]:
    """A way aside through a pose at which one arm angle has joint_2 = 0, half-way."""
    X_WF = np.tile(ROBOT.forward(UPRIGHT), (len(T), 1, 1))
    X_WF[:, 0, 3] += 0.1 * (T - T[-1] / 2) / T[-1]
    branch, begin = int(configuration(UPRIGHT)), float(arm_angle(ROBOT, UPRIGHT, ArmAngle.FARIA)) - 0.7
    start = inverse_branch(ROBOT, X_WF[:1], begin, ArmAngle.FARIA, branch)[0]
    task = ArmTask(Arm(ROBOT, np.eye(4), start, LIMITS), X_WF, T[1])
    chart = arm_map(task, stages(len(T), 100), 180)
    courses = []
    for name, angles in (("fixed", np.full(len(T), begin)), ("chosen", begin + 0.3 * np.sin(T))):
        courses.append(
            ArmAngleSeries(name, angles, np.unwrap(inverse_branch(ROBOT, X_WF, angles, ArmAngle.FARIA, branch), axis=0))
        )
    with house_style():
        ease = ROBOT.manipulability(chart.q)
        return map_figure(T, chart, ease, LIMITS, courses, "faria", (), "a way"), chart, X_WF, courses


def line(axes: Axes, gid: str) -> Array:
    (found,) = (one for one in axes.lines if one.get_gid() == gid)
    return np.asarray(found.get_xydata(), dtype=np.float64)


def test_the_shoulder_flips_where_joint_2_is_zero(drawn: tuple[Figure, ArmMap, Array, list[ArmAngleSeries]]) -> None:
    figure, chart, _, courses = drawn
    spots = line(figure.axes[0], "flip")
    at = np.degrees(courses[0].arm_angle[0] + 0.7)
    assert len(spots) == 1
    np.testing.assert_allclose(spots[0], [T[-1] / 2, at], rtol=0, atol=np.degrees(chart.cell))
    # past it joint_1 turns by half a turn: left and right of it, from below to above
    k, i = len(chart.rows) // 2, round(0.7 / chart.cell)
    turn = np.degrees(np.remainder(chart.q[k, i + 3, 0] - chart.q[k, i - 3, 0], 2 * np.pi))
    assert min(turn, 360 - turn) > 120


def test_a_cell_is_coloured_where_a_joint_is_out_of_its_range(
    drawn: tuple[Figure, ArmMap, Array, list[ArmAngleSeries]],
) -> None:
    figure, chart, X_WF, _ = drawn
    axes = figure.axes[0]
    branch = int(configuration(UPRIGHT))
    zones = {str(one.get_gid()): one for one in axes.collections if str(one.get_gid() or "").startswith("out joint")}
    (room,) = (one for one in axes.collections if one.get_gid() == "margin")
    assert zones
    low, high = axes.get_ylim()
    assert high - low >= 360
    cells = np.ma.asarray(room.get_array()).shape
    delta = np.linspace(low, high, cells[0])
    for i in range(0, cells[0], 7):
        # all configurations at once, the other way of counting
        q = inverse(ROBOT, X_WF[chart.rows], np.full(len(chart.rows), np.radians(delta[i])), ArmAngle.FARIA)[:, branch]
        free = [0, 1, 2, 4, 5, 6]
        excess = np.maximum(q - LIMITS.upper, LIMITS.lower - q)[:, free]
        edge = np.abs(excess).min(axis=1) < 1e-6
        out = excess.max(axis=1) > 0
        masked = np.ma.getmaskarray(np.ma.asarray(room.get_array()))[i]
        np.testing.assert_array_equal(masked[~edge], out[~edge])
        for j, joint in enumerate(free):
            mine = out & (excess.argmax(axis=1) == j)
            if f"out joint_{joint + 1}" not in zones:
                assert not mine.any()
                continue
            shown = ~np.ma.getmaskarray(np.ma.asarray(zones[f"out joint_{joint + 1}"].get_array()))[i]
            np.testing.assert_array_equal(shown[~edge], mine[~edge])
        values = np.ma.asarray(room.get_array())[i]
        np.testing.assert_allclose(values[~out], -np.degrees(excess.max(axis=1))[~out], rtol=0, atol=1e-6)


def test_courses_stand_on_the_map_and_over_their_figures(
    drawn: tuple[Figure, ArmMap, Array, list[ArmAngleSeries]],
) -> None:
    figure, _, _, courses = drawn
    plan, room, speed = figure.axes[:3]
    for one in courses:
        np.testing.assert_allclose(line(plan, one.name)[-1], [T[-1], np.degrees(one.arm_angle[-1])])
        used = 100 * np.abs(np.diff(one.q, axis=0) / 1e-2 / LIMITS.velocity)[:, [0, 1, 2, 4, 5, 6]].max()
        assert line(speed, f"{one.name} speed")[:, 1].max() == pytest.approx(used)
        near = np.minimum(LIMITS.upper - one.q, one.q - LIMITS.lower)[:, [0, 1, 2, 4, 5, 6]].min()
        assert line(room, f"{one.name} distance")[:, 1].min() == pytest.approx(np.degrees(near))


def test_texts_stand_on_the_page(drawn: tuple[Figure, ArmMap, Array, list[ArmAngleSeries]]) -> None:
    figure = drawn[0]
    with house_style():
        figure.canvas.draw()
    page = figure.bbox.padded(1)
    ticks = [t for axes in figure.axes for t in (*axes.get_xticklabels(), *axes.get_yticklabels())]
    texts = [t for t in figure.findobj(Text) if t not in ticks and t.get_visible() and t.get_text().strip()]
    assert len(texts) > 10
    for text in texts:
        box = Text.get_window_extent(text)
        assert page.x0 <= box.x0, text
        assert box.x1 <= page.x1, text
        assert page.y0 <= box.y0, text
        assert box.y1 <= page.y1, text
