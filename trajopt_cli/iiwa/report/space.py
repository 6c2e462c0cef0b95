"""Paths of the compliant controller in space, or in the one plane that is moved in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.figure import FigureBase

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import MOVES
from trajopt_cli.iiwa.report.thinning import thinned
from trajopt_cli.report.style import GREY, SMALL
from trajopt_cli.units import MM

_FLAT = 0.02  # of the longest side: a coordinate that moves less is not worth a third dimension
_LEAST = 0.12  # of the longest side: no side of the box is shorter

# A path in space (n, 3) [m], how it is drawn, and what it is called in the file.
Path3D = tuple[Array, dict[str, Any], str]


def draw_paths(figure: FigureBase, paths: Sequence[Path3D]) -> None:
    """Paths to one scale, start and end of the first one marked: in the plane of two coordinates where the third hardly
    moves, else in a box."""
    low = np.min([points.min(axis=0) for points, _, _ in paths], axis=0) / MM
    high = np.max([points.max(axis=0) for points, _, _ in paths], axis=0) / MM
    span, middle = high - low, (low + high) / 2
    longest = max(float(span.max()), MOVES / MM)
    half = np.maximum(1.1 * span, _LEAST * longest) / 2
    order = np.argsort(-span, kind="stable")
    flat = bool(span[order[2]] < _FLAT * longest)
    shown = sorted(order[:2].tolist()) if flat else [0, 1, 2]
    axes: Any = figure.add_subplot() if flat else figure.add_subplot(projection="3d", computed_zorder=False)
    for points, style, gid in paths:
        along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        axes.plot(*(points[thinned(points, along)][:, shown] / MM).T, gid=gid, solid_joinstyle="round", **style)
    for i, which in zip(shown, "xyz", strict=False):
        getattr(axes, f"set_{which}lim")(middle[i] - half[i], middle[i] + half[i])
        getattr(axes, f"set_{which}label")(f"{'xyz'[i]} [mm]")
    if flat:
        axes.set_aspect("equal")
        axes.grid(color="#dedede", linewidth=0.8)
        axes.set_axisbelow(True)
    else:
        axes.set_box_aspect(half, zoom=0.9)
        axes.tick_params(labelsize=SMALL - 1)
        axes.locator_params(nbins=5)
    ends = paths[0][0][[0, -1]][:, shown] / MM
    same = float(np.linalg.norm(ends[1] - ends[0])) < 0.01 * longest
    for place, name in zip(ends, ["start and end"] if same else ["start", "end"], strict=False):
        axes.plot(*place[:, None], "o", color=GREY, markerfacecolor="white", gid=name, zorder=6)
        axes.text(*place, f"  {name}", size=SMALL, zorder=6)
