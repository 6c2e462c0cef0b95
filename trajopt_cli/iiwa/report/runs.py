"""What pictures of the compliant controller are drawn from, and what they share: curves, marked maxima, files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.thinning import thinned
from trajopt_cli.report.over_time import number
from trajopt_cli.report.style import AXIS_STYLES, BLACK, BLUE, GREY, SMALL, VERMILLION, files, house_style, settle
from trajopt_cli.units import DEG, MM

COORDINATES = ("x", "y", "z", "α", "β", "γ")
# Of a shown coordinate: SI per shown unit and the unit's sign, of poses and of forces.
POSE_UNITS = ((MM, "mm"),) * 3 + ((DEG, "deg"),) * 3
FORCE_UNITS = ((1.0, "N"),) * 3 + ((1.0, "Nm"),) * 3
MOVES = 1e-6
"""m or rad: a coordinate that travels less does not move."""

Draw = Callable[[str], Figure]
"""Draws a figure under a title."""

# The thesis draws the planned trajectory and the controller's in two colours and the flange dashed.
PLANNED: dict[str, Any] = {"color": "#a9a9a9", "linewidth": 4.2, "label": "equilibrium (planned)"}
CONTROLLER: dict[str, Any] = {"color": BLUE, "linewidth": 1.8, "label": "controller"}
FLANGE: dict[str, Any] = {"color": VERMILLION, "linewidth": 1.8, "linestyle": (0, (2.5, 1.5)), "label": "tool itself"}
_PEAK: dict[str, Any] = {"marker": "o", "markersize": 6.5, "linestyle": "", "color": BLACK, "markerfacecolor": "white"}


@dataclass(frozen=True, eq=False)
class Following:
    """One run of the controller. x_e, x (n, 6): equilibrium and controller, positions [m] and angles [rad] over t [s].

    force (n, 6): on the tool [N, Nm], None where there is none to show. true (n, 6): the flange as it moved, None
    where it is the controller's.
    """

    label: str
    t: Array
    x_e: Array
    x: Array
    force: Array | None = None
    true: Array | None = None

    @property
    def flange(self) -> Array:
        """Where the flange was (n, 6): as measured, else as the controller has it."""
        return self.x if self.true is None else self.true

    @property
    def shown(self) -> list[tuple[str, Array, dict[str, Any]]]:
        """Name, poses (n, 6) and style of what is drawn of it: equilibrium, controller, and the flange if measured."""
        both = [("equilibrium", self.x_e, PLANNED), ("controller", self.x, CONTROLLER)]
        return both if self.true is None else [*both, ("flange", self.true, FLANGE)]

    @property
    def deviation(self) -> Array:
        """The controller's distance from the equilibrium (n,) [m], eq. 6.8."""
        return np.asarray(np.linalg.norm(self.x[:, :3] - self.x_e[:, :3], axis=1))

    @property
    def turn(self) -> Array:
        """The same of the angles (n,) [rad]: the norm of their differences."""
        return np.asarray(np.linalg.norm(self.x[:, 3:] - self.x_e[:, 3:], axis=1))


def picture(name: str, title: str, make: Draw) -> dict[str, bytes]:
    """What make draws under a title, as name.svg and name.png; the same input gives the same bytes."""
    with house_style():
        return files(name, make(title), title)


def curve(axes: Axes, t: Array, values: Array, gid: str, **style: Any) -> None:
    """A curve of values (n,) over t (n,), thinned to what the page shows."""
    rows = thinned(values)
    axes.plot(t[rows], values[rows], gid=gid, solid_joinstyle="round", **style)


def components(axes: Axes, t: Array, values: Array, which: Sequence[int], factor: float, gid: str) -> None:
    """Coordinates (n, 6) in the styles of x, y and z; gid is followed by the coordinate's sign."""
    for i in which:
        color, line = AXIS_STYLES[i % 3]
        curve(axes, t, values[:, i] / factor, f"{gid} {COORDINATES[i]}", color=color, linestyle=line)


def component_handles(which: Sequence[int]) -> list[Line2D]:
    """What the legend shows for components: one entry per style that is used."""
    out = []
    for i, (color, line) in enumerate(AXIS_STYLES):
        signs = [COORDINATES[k] for k in sorted(which) if k % 3 == i]
        if signs:
            name = signs[0] if len(signs) == 1 else f"{signs[0]}, about {signs[0]}"
            out.append(Line2D([], [], color=color, linestyle=line, label=name))
    return out


def moving(*paths: Array, rows: Sequence[int] = range(6), least: float = MOVES) -> list[int]:
    """Coordinates of rows that any of the paths (n, 6) travels along."""
    return [i for i in rows if max(float(np.ptp(path[:, i])) for path in paths) > least]


def mark_peak(axes: Axes, t: Array, values: Array, unit: str, of: str = "", offset: Array | float = 0.0) -> str:
    """Mark the value (n,) furthest from zero on its curve, drawn at values + offset, and say it above the panel.

    of: what the value is, between the number and its time. Returns the number with its unit.
    """
    i = int(np.argmax(np.abs(values)))
    axes.plot(t[i], (values + offset)[i], gid="peak", zorder=5, **_PEAK)
    shown = quantity_of(abs(float(values[i])), unit)
    axes.set_title(f"{shown}{of} at {number_of(float(t[i]))} s", loc="right", size=SMALL, pad=3)
    return shown


def number_of(value: float) -> str:
    """Three figures that matter, no exponents for ordinary sizes, and no minus before nothing."""
    if value == 0 or 1e-4 <= abs(value) < 1e5:
        decimals = 0 if value == 0 else max(0, 2 - int(np.floor(np.log10(abs(value)))))
        text = f"{value:.{decimals}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
        return text.replace("-", "−")
    return number(float(f"{value:.3g}"))


def quantity_of(value: float, unit: str) -> str:
    """A number with its unit; degrees by their sign."""
    return f"{number_of(value)}°" if unit == "deg" else f"{number_of(value)} {unit}"


def zero_line(axes: Axes) -> None:
    """A thin line at zero."""
    axes.axhline(0, color=GREY, linewidth=0.7, zorder=1)


def room_above(axes: Axes, values: Sequence[Array], least: float, margin: float = 0.15) -> None:
    """The vertical range from zero to a margin over the largest of values that are never negative."""
    top = max([least, *(float(v.max()) for v in values)])
    axes.set_ylim(-0.03 * top, (1 + margin) * top)


def room_around(axes: Axes, values: Sequence[Array], least: float, margin: float = 0.12) -> None:
    """The vertical range around values, at least so wide that rounding does not fill the panel."""
    low, high = min(float(v.min()) for v in values), max(float(v.max()) for v in values)
    span, middle = max(high - low, least), (low + high) / 2
    axes.set_ylim(middle - (0.5 + margin) * span, middle + (0.5 + margin) * span)


def finish(figure: Figure) -> Figure:
    """The figure laid out for good."""
    figure.align_ylabels()
    settle(figure)
    return figure
