"""Obstacles in the pictures of a plan: where they stand, cut at the edge, and nowhere they are not."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from matplotlib.patches import Polygon
from small_cells import plant_with_rail
from test_added_points import planned

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.report import in_space, obstacles
from trajopt_cli.report.arm import arm
from trajopt_cli.shapes import Box, Capsule, Mesh, Solid
from trajopt_cli.trajectories.plan_series import follow

TABLE = Solid(Box("table", np.array([0.4, 0.6, 0.1]), pose(rotation_about([0, 0, 1], 0.3), [0.6, 0.5, 0.2])))
POST = Solid(Capsule("post", np.array([0.4, 1.2, 0.0]), np.array([0.4, 1.2, 0.8]), 0.05))
CORNERS = np.array([[0.0, 0, 0], [0.3, 0, 0], [0, 0.2, 0], [0, 0, 0.1]])
WEDGE = Solid(Mesh("wedge", CORNERS, np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])))
PLANT = plant_with_rail(obstacles=(TABLE, POST, WEDGE))


def area(corners: Array) -> float:
    x, y = corners.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def test_outlines_are_those_of_the_bodies() -> None:
    table, post, wedge = obstacles.clouds(PLANT)
    assert abs(area(obstacles.seen(table, [0, 1])) - 0.4 * 0.6) < 1e-6
    assert abs(area(obstacles.seen(post, [1, 2])) - (0.8 * 0.1 + np.pi * 0.05**2)) < 4e-4  # drawn with 24 corners
    assert abs(area(obstacles.seen(wedge, [0, 2])) - 0.5 * 0.3 * 0.1) < 1e-6


def test_a_surface_is_cut_at_the_edge_of_what_is_shown() -> None:
    box = np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    low, high = np.array([-1.0, -1, -1]), np.array([1.5, 2, 0.5])
    faces = obstacles.surface(box, low, high)
    corners = np.concatenate(faces)
    assert (corners >= low - 1e-9).all()
    assert (corners <= high + 1e-9).all()
    # what is left of the sides: bottom, both long ones, the one at x = 0
    areas = [0.5 * np.linalg.norm(sum(np.cross(b - one[0], c - one[0]) for b, c in pairwise(one[1:]))) for one in faces]
    assert abs(sum(areas) - (1.5 * 1 + 2 * 1.5 * 0.5 + 0.5)) < 1e-6
    assert obstacles.surface(box + 5.0, low, high) == []


def test_path_and_arm_show_them() -> None:
    program, plan = planned()
    with_bodies, without = (follow(program, replace(PLANT, obstacles=one), plan, "") for one in (PLANT.obstacles, ()))
    pictures = [in_space.path(series) for series in (with_bodies, without)]
    for series, figure, count in zip((with_bodies, without), pictures, (3, 0), strict=True):
        world, carriage = figure.axes[0], figure.axes[1]
        drawn = [one for one in world.patches if isinstance(one, Polygon) and one.get_gid() == "obstacle"]
        assert len(drawn) == 2 * count  # filled, and their outlines
        assert not [one for one in carriage.patches if one.get_gid() == "obstacle"]
        legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes if axes.get_legend())]
        labels = [text.get_text() for one in legends for text in one.get_texts()]
        assert ("obstacles" in labels) == bool(count)
        space = arm(series)
        faces = [one for one in space.axes[0].collections if one.get_gid() == "obstacle"]
        assert len(faces) == count
        arms = [one for one in space.axes[0].collections if one.get_gid() == "bodies"]
        assert len(arms) == len([text for text in space.legends[0].get_texts() if ": " in text.get_text()])  # stations
        assert ("obstacles" in [text.get_text() for text in space.legends[0].get_texts()]) == bool(count)
    table = next(one for one in pictures[0].axes[0].patches if one.get_gid() == "obstacle")
    y, z = table.get_xy().T  # mm; the side view
    np.testing.assert_allclose([z.min(), z.max()], [150, 250], atol=1e-3)
    np.testing.assert_allclose(y.mean() > 300, y.mean() < 700)
