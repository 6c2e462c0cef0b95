"""Obstacles in pictures: their outlines in a view, and their surfaces in space, cut at the edge of what is shown."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.patches import Patch
from scipy.spatial import ConvexHull

from trajopt_cli.geometry import Array
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report.style import GREY
from trajopt_cli.scene import OBSTACLE, scene_of_plant
from trajopt_cli.shapes import Capsule, Mesh, outline

FACE: dict[str, Any] = {"facecolor": "#d9b48c", "alpha": 0.3, "linewidth": 0}
"""How they are filled."""
EDGE: dict[str, Any] = {"facecolor": "none", "edgecolor": GREY, "linewidth": 0.8}
"""How their outlines are drawn."""
LABEL = Patch(facecolor=FACE["facecolor"], alpha=0.6, label="obstacles")
_TURN, _LIFT = np.meshgrid(np.linspace(0, 2 * np.pi, 24, endpoint=False), np.linspace(-1.5, 1.5, 7))
_BALL = np.stack([np.cos(_LIFT) * np.cos(_TURN), np.cos(_LIFT) * np.sin(_TURN), np.sin(_LIFT)], axis=-1).reshape(-1, 3)


def clouds(plant: Plant) -> list[Array]:
    """Points (n, 3) [m] of each obstacle, as it stands at the start, whose convex hull is what is drawn of it."""
    out = []
    for shape in (body.shape for body in scene_of_plant(plant).bodies if body.role == OBSTACLE):
        points, radius = outline(shape)
        if isinstance(shape, Capsule):
            points = (points[:, None] + radius * _BALL).reshape(-1, 3)
        elif isinstance(shape, Mesh):
            points = shape.vertices @ shape.X[:3, :3].T + shape.X[:3, 3]
        out.append(points)
    return out


def seen(cloud: Array, plane: list[int]) -> Array:
    """The corners (m, 2) of a cloud's outline seen along the third axis."""
    flat = cloud[:, plane]
    return np.asarray(flat[ConvexHull(flat, qhull_options="QJ").vertices])


def surface(cloud: Array, low: Array, high: Array) -> list[Array]:
    """The triangles of a cloud's convex hull, each cut at the faces of a box from low to high (3,): its corners
    (m, 3)."""
    out = []
    for triangle in cloud[ConvexHull(cloud, qhull_options="QJ").simplices]:
        corners = triangle
        for i, limit, sign in [(i, one[i], sign) for i in range(3) for one, sign in ((low, 1), (high, -1))]:
            inside = sign * (corners[:, i] - limit)  # what lies behind the face is cut off
            kept = []
            for a, b, p, q in zip(inside, np.roll(inside, -1), corners, np.roll(corners, -1, axis=0), strict=True):
                kept += [p] if a >= 0 else []
                kept += [p + a / (a - b) * (q - p)] if a * b < 0 else []
            corners = np.array(kept).reshape(-1, 3)
        if len(corners) >= 3:
            out.append(corners)
    return out
