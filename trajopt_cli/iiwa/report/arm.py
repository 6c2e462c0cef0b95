"""The arm in space: its links at a few moments, what it may run into, the paths of equilibrium and tool."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import FLANGE, PLANNED, Following, finish
from trajopt_cli.iiwa.report.space import View, Way, draw_ways, ends
from trajopt_cli.report.over_time import legend
from trajopt_cli.report.style import ORANGE, WIDTH, new_figure
from trajopt_cli.shapes import Box, Capsule, outline
from trajopt_cli.units import MM

# Fill and edge of the links at the first moment; of all others the shade alone. Of obstacles.
_LOOKS = (("#9cc3df", "#3f7fab"), ("#cfcfcf", "#cfcfcf"), ("#e8e8e8", "#e8e8e8"))
_OBSTACLE = ("#f6dfb4c8", ORANGE)  # what is behind shows through
_TOOL = dict(FLANGE, label="tool", linestyle="-")
_PLANNED = dict(PLANNED, label="equilibrium", linewidth=3.0)
_FACES = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
_ROUND = np.linspace(-np.pi / 2, np.pi / 2, 25)


def arm_figure(
    run: Following, moments: Sequence[tuple[str, Sequence[Capsule]]], obstacles: Sequence[Box], title: str
) -> Figure:
    """Links as capsules in the world at one to three moments (name, capsules): one solid, shades of the others."""
    if not 1 <= len(moments) <= len(_LOOKS):
        raise ValueError(f"arm: {len(moments)} moments, wanted 1 to {len(_LOOKS)}")
    corners = [outline(box)[0] for box in obstacles]
    reach = [end + c.radius * side for _, links in moments for c in links for end in (c.a, c.b) for side in (-1.0, 1.0)]
    view = View([np.array(reach), *corners, run.x_e[:, :3], run.flange[:, :3]], flat=False)
    below = "links as capsules" + (", the obstacles as they push back" if obstacles else "")
    figure = new_figure(1.6 + view.height(WIDTH - 2.2, 8.0), title, below)
    axes = figure.subplots()
    solids: list[tuple[float, Array, str, str, str]] = []
    for i, ((name, links), (fill, edge)) in enumerate(zip(moments, _LOOKS, strict=False)):
        for link in links:
            depth = float(view.depth((link.a + link.b) / 2)) if i == 0 else -1e3 * i
            solids.append((depth, _stripe(view, link), fill, edge, f"{name} {link.name}"))
    for box, points in zip(obstacles, corners, strict=True):
        for face in _FACES:
            depth = float(view.depth(points[list(face)].mean(axis=0)))
            if depth > float(view.depth(box.X[:3, 3])):  # the others are turned away
                solids.append((depth, view(points[list(face)]), *_OBSTACLE, box.name))
    for order, (_, points, fill, edge, gid) in enumerate(sorted(solids, key=lambda solid: solid[0])):
        patch = Polygon(points, facecolor=fill, edgecolor=edge, linewidth=1.0, zorder=1 + order / len(solids), gid=gid)
        axes.add_patch(patch)
    ways: list[Way] = [
        (run.x_e[:, :3], _PLANNED | {"zorder": 3}, "equilibrium"),
        (run.flange[:, :3], _TOOL | {"zorder": 4}, "tool"),
    ]
    draw_ways(axes, view, ways)
    handles: list[Line2D | Patch] = [Line2D([], [], **style) for style in (_PLANNED, _TOOL)]
    handles += [
        Patch(facecolor=fill, edgecolor=edge, label=name)
        for (name, _), (fill, edge) in zip(moments, _LOOKS, strict=False)
    ]
    if obstacles:
        handles.append(Patch(facecolor=_OBSTACLE[0], edgecolor=_OBSTACLE[1], label="obstacle"))
    legend(figure, handles)
    return finish(figure, [(axes, ends(view, run.x_e[:, :3]))])


def _stripe(view: View, link: Capsule) -> Array:
    """A capsule on the page (n, 2) [mm]: parallel rays leave a stripe with round ends."""
    first, last = view(np.array([link.a, link.b]))
    along = last - first
    turn = float(np.arctan2(along[1], along[0]))
    caps = [(first, turn + np.pi), (last, turn)]
    return np.concatenate(
        [end + link.radius / MM * np.column_stack([np.cos(way + _ROUND), np.sin(way + _ROUND)]) for end, way in caps]
    )
