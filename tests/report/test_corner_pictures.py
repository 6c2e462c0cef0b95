"""Pictures of a plan with corners and an arc: drawn as driven; points that are passed look unlike stops."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from small_cells import plant_with_rail, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.report import arm, in_space, over_time, style
from trajopt_cli.report.names import by_place
from trajopt_cli.trajectories.plan_series import PlanSeries, follow

BODY = """MoveJ p_in, v2500, z50, tool0;
MoveL Offs(p_in,0,0,-60), v500, z10, tool0;
MoveL Offs(p_in,0,80,-60), v500, fine, tool0;
WaitTime 0.2;
MoveC Offs(p_in,40,120,-60), Offs(p_in,0,160,-60), v300, z10, tool0;
MoveL Offs(p_in,0,160,0), v500, fine, tool0;"""
PASSED = [True, True, False, True, False]  # by move


@cache
def series() -> PlanSeries:
    program, plant = rapid(BODY), plant_with_rail()
    plan = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    return follow(program, plant, plan, "corners")


def points() -> Array:
    """Where the program's moves lead to, in order [m]."""
    moves = [motion for motion in series().program.motions if hasattr(motion, "X_WT")]
    return np.array([motion.X_WT[:3, 3] for motion in moves])  # type: ignore[union-attr]


@cache
def drawn() -> dict[str, Figure]:
    pictures = {"path": in_space.path, "workspace": in_space.workspace, "tcp_speed": over_time.tcp_speed}
    with style.house_style():
        return {name: picture(series()) for name, picture in pictures.items()}


def curves(axes: Axes, gid: str) -> list[Array]:
    """Every curve of a kind in m."""
    return [np.column_stack(line.get_data()) * 1e-3 for line in axes.lines if line.get_gid() == gid]


def test_nothing_of_the_motion_is_left_out() -> None:
    """All kinds together are the whole path, each of its samples in one of them, ends shared."""
    shown = np.zeros(len(series().t), dtype=int)
    for part, _ in in_space._parts(series()):
        shown[part] += 1
    assert shown.min() == 1
    assert (shown > 1).sum() <= 2 * len(series().legs) + 2 * len(series().corners)


def test_an_arc_is_drawn_as_an_arc_and_corners_within_their_zones() -> None:
    above = drawn()["path"].axes[2]  # the real space from above: y across, x up
    (arc,) = curves(above, "arc")
    centre = np.add(points()[2][:2], [0, 0.04])
    np.testing.assert_allclose(np.linalg.norm(arc[:, ::-1] - centre, axis=1), 0.04, atol=1e-5)
    assert len(curves(above, "line")) == 3
    for corner, point, radius in zip(series().corners, points()[PASSED], (0.03, 0.01, 0.01), strict=True):
        tool = series().X_WT[corner, :3, 3]
        away = np.linalg.norm(tool - point, axis=1)
        assert away[1:-1].max() <= radius * (1 + 1e-5)
        assert away.max() < radius + 2e-3  # the samples beside the zone, a millisecond on
        assert away.min() < radius / 2


@pytest.mark.parametrize(("panel", "plane"), [(0, (1, 2)), (2, (1, 0))])
def test_points_that_are_passed_are_hollow_and_stand_where_they_are_programmed(
    panel: int, plane: tuple[int, int]
) -> None:
    axes = drawn()["path"].axes[panel]
    stops, passed = (line for line in axes.lines if line.get_marker() == "o")
    assert passed.get_markerfacecolor() == "white"
    assert stops.get_markerfacecolor() != "white"
    start = series().X_WT[:1, :3, 3]
    for line, places in (
        (stops, np.vstack([start, points()[~np.array(PASSED)]])),
        (passed, points()[np.array(PASSED)]),
    ):
        np.testing.assert_allclose(np.column_stack(line.get_data()) * 1e-3, places[:, plane], atol=1e-8)


def test_the_legend_names_both_and_a_plan_of_stops_has_neither() -> None:
    names = {text.get_text() for text in drawn()["path"].legends[0].get_texts()}
    assert {"arcs (MoveC)", "in zones (fly-by)", "stop", "passed"} <= names
    assert "point passed" in {text.get_text() for text in drawn()["tcp_speed"].legends[0].get_texts()}
    assert "point passed" in {text.get_text() for text in drawn()["workspace"].legends[0].get_texts()}


def test_over_time_a_point_that_is_passed_is_a_dotted_line_in_the_middle_of_its_corner() -> None:
    (axes,) = drawn()["tcp_speed"].axes
    (dotted,) = [one for one in axes.collections if one.get_gid() == "passed"]
    times = [segment[0, 0] for segment in dotted.get_segments()]
    moves = [motion for motion in series().plan.motions if motion.t_1 > motion.t_0]
    assert times == [moves[i].t_1 for i in (0, 1, 4)]
    speed = np.linalg.norm(series().V_WT[:, :3], axis=1)
    assert min(speed[series().at(time)] for time in times) > 0.02


def test_the_arm_is_shown_where_it_stops() -> None:
    labels = [name for _, name, _ in arm._stations(series())]
    assert labels[0] == "start"
    assert [label.split(",")[0] for label in labels[1:]] == ["Offs(p_in…"]


def test_a_name_of_many_places_is_written_once_and_all_places_are_kept() -> None:
    """As Offs(p_middle,...) in a loop along a contour: sixty labels would cover the picture."""
    around = np.column_stack([np.cos(np.arange(60) / 10), np.sin(np.arange(60) / 10)])
    places, names = by_place(np.vstack([around, around[:1] + 3]), ["Offs(p,x,y,0)"] * 60 + ["p_home"], 1e-3)
    assert len(places) == 61
    assert [name for name in names if name] == ["Offs(p,x,y,0)", "p_home"]
    few, told = by_place(around[:6], ["p_in"] * 6, 1e-3)
    assert told == ["p_in"] * len(few) == ["p_in"] * 6
