"""Paths of the compliant controller in space: an axonometric box with its scales, or the one plane that is moved in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import MOVES, Marks
from trajopt_cli.iiwa.report.thinning import thinned
from trajopt_cli.report.over_time import number
from trajopt_cli.report.style import BLACK, SMALL
from trajopt_cli.units import MM

_AZIMUTH, _ELEVATION = np.radians(-56.0), np.radians(26.0)  # of the eye; parallel rays
_FLAT = 0.02  # of the longest way: a coordinate that moves less is not worth a third dimension
_LEAST = 0.12  # of the longest way: no side of the box is shorter
_GRID = {"color": "#dedede", "linewidth": 0.8, "zorder": 0.4}
_EDGE = {"color": "#9a9a9a", "linewidth": 1.0, "zorder": 0.5}

# A way in space (n, 3) [m], how it is drawn, and what it is called in the file.
Way = tuple[Array, dict[str, Any], str]


class View:
    """How points in space [m] are put on the page [mm]: in the plane of two coordinates, or axonometrically."""

    def __init__(self, ways: Sequence[Array], flat: bool = True) -> None:
        """The view of all ways (n, 3): a plane where the third coordinate hardly moves, unless flat is False."""
        low = np.min([way.min(axis=0) for way in ways], axis=0)
        high = np.max([way.max(axis=0) for way in ways], axis=0)
        span = high - low
        longest = max(float(span.max()), MOVES)
        order = np.argsort(-span, kind="stable")
        self.flat = flat and bool(span[order[2]] < _FLAT * longest)
        # one straight way along an axis is shown with the height where it has one, else with the next axis
        first, second = int(order[0]), int(order[1])
        if self.flat and span[second] < _FLAT * longest and first != 2:
            second = 2
        self.plane = (min(first, second), max(first, second))
        middle = (low + high) / 2
        half = np.maximum(1.08 * span, _LEAST * longest) / 2
        if self.flat:
            half = np.maximum(half, 0.15 * longest)
        self.low, self.high = middle - half, middle + half

    def __call__(self, points: Array) -> Array:
        """Points (..., 3) [m] on the page (..., 2) [mm]."""
        if self.flat:
            return np.asarray(points[..., self.plane] / MM)
        x, y, z = np.moveaxis(points / MM, -1, 0)
        s, c = np.sin(_AZIMUTH), np.cos(_AZIMUTH)
        across = -s * x + c * y
        return np.stack([across, np.cos(_ELEVATION) * z - np.sin(_ELEVATION) * (c * x + s * y)], axis=-1)

    def depth(self, points: Array) -> Array:
        """How near to the eye points (..., 3) [m] are (...) [m], of an axonometric view."""
        x, y, z = np.moveaxis(points, -1, 0)
        ahead = np.cos(_AZIMUTH) * x + np.sin(_AZIMUTH) * y
        return np.asarray(np.cos(_ELEVATION) * ahead + np.sin(_ELEVATION) * z)

    @property
    def corners(self) -> Array:
        """The box (8, 3) [m] around all ways."""
        ends = np.array([self.low, self.high])
        return np.array([[ends[i, 0], ends[j, 1], ends[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])

    @property
    def shape(self) -> float:
        """Height over width on the page."""
        wide, tall = np.ptp(self(self.corners), axis=0)
        return float(tall / wide)

    def height(self, width: float, most: float) -> float:
        """Inches of page that the picture fills when it is width [in] wide, at most so many."""
        return min(most, max(0.25 * width, width * self.shape))


def draw_ways(axes: Axes, view: View, ways: Sequence[Way]) -> None:
    """The ways over the scales of the view, to one scale."""
    (_plane if view.flat else _box)(axes, view)
    for points, style, gid in ways:
        along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        rows = thinned(points, along)
        axes.plot(*view(points[rows]).T, gid=gid, solid_capstyle="round", solid_joinstyle="round", **style)
    axes.set_aspect("equal")


def ends(view: View, points: Array) -> Marks:
    """Marks of the start and the end of a way (n, 3) [m], of one place where it comes back."""
    first, last = view(points[[0, -1]])
    if np.linalg.norm(points[-1] - points[0]) < 0.01 * max(float(np.ptp(points, axis=0).max()), MOVES):
        return [(float(first[0]), float(first[1]), "start and end")]
    return [(float(first[0]), float(first[1]), "start"), (float(last[0]), float(last[1]), "end")]


def _plane(axes: Axes, view: View) -> None:
    i, j = view.plane
    axes.set_xlim(view.low[i] / MM, view.high[i] / MM)
    axes.set_ylim(view.low[j] / MM, view.high[j] / MM)
    axes.set_xlabel(f"{'xyz'[i]} [mm]")
    axes.set_ylabel(f"{'xyz'[j]} [mm]")
    axes.xaxis.set_major_locator(MaxNLocator(8))
    axes.yaxis.set_major_locator(MaxNLocator(6))
    axes.grid(color=_GRID["color"], linewidth=0.8)
    axes.set_axisbelow(True)


def _box(axes: Axes, view: View) -> None:
    """Floor and the two far walls with their grid; scales on the near edges of the floor and at the left."""
    low, high = view.low, view.high
    longest = float((high - low).max())

    def line(a: Array, b: Array, style: dict[str, Any]) -> None:
        axes.plot(*view(np.array([a, b])).T, clip_on=False, **style)

    def at(x: float, y: float, z: float) -> Array:
        return np.array([x, y, z])

    scales: list[list[float]] = []
    for i in range(3):
        ticks: Any = MaxNLocator(max(2, round(6 * (high[i] - low[i]) / longest))).tick_values(low[i] / MM, high[i] / MM)
        scales.append([float(tick) * MM for tick in ticks if low[i] < tick * MM < high[i]])
    for x in scales[0]:
        line(at(x, low[1], low[2]), at(x, high[1], low[2]), _GRID)
        line(at(x, high[1], low[2]), at(x, high[1], high[2]), _GRID)
    for y in scales[1]:
        line(at(low[0], y, low[2]), at(high[0], y, low[2]), _GRID)
        line(at(low[0], y, low[2]), at(low[0], y, high[2]), _GRID)
    for z in scales[2]:
        line(at(low[0], low[1], z), at(low[0], high[1], z), _GRID)
        line(at(low[0], high[1], z), at(high[0], high[1], z), _GRID)
    far = [at(low[0], low[1], high[2]), at(low[0], high[1], high[2]), at(high[0], high[1], high[2])]
    for a, b in (far[:2], far[1:], (far[1], at(low[0], high[1], low[2])), (far[2], at(high[0], high[1], low[2]))):
        line(a, b, _GRID)
    # the near edge of each scale: where it runs, how far off its numbers stand [pt] and how they are aligned
    near = (
        (low, at(high[0], low[1], low[2]), (-2.0, -5.0), "right", "top"),
        (at(high[0], low[1], low[2]), at(high[0], high[1], low[2]), (5.0, -5.0), "left", "top"),
        (low, at(low[0], low[1], high[2]), (-6.0, 0.0), "right", "center"),
    )
    for i, (a, b, off, ha, va) in enumerate(near):
        line(a, b, _EDGE)
        names = [(tick, number(round(tick / MM, 6)), SMALL, 1.0) for tick in scales[i]]
        names.append(((low[i] + high[i]) / 2, f"{'xyz'[i]} [mm]", SMALL + 1.5, 0.0))
        for value, text, size, tick in names:
            place = np.where(np.arange(3) == i, value, a)
            away = off if tick else _name_off(i)
            axes.annotate(
                text, tuple(view(place)), away, textcoords="offset points", ha=ha, va=va, size=size, color=BLACK,
                annotation_clip=False,
            )  # fmt: skip
    across, up = view(view.corners).T
    axes.set_xlim(across.min(), across.max())
    axes.set_ylim(up.min(), up.max())
    axes.set_axis_off()


def _name_off(i: int) -> tuple[float, float]:
    """How far [pt] the name of a scale stands off its middle: beyond its numbers."""
    return ((-26.0, -22.0), (28.0, -22.0), (-46.0, 0.0))[i]
