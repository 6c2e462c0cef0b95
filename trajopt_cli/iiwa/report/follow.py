"""Runs of the compliant controller and how their pictures are drawn: following over time, families of runs, stability
map, loop time. Graf 6.10 to 6.16, 6.19."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.page import thinned
from trajopt_cli.report.over_time import TIME, legend, number
from trajopt_cli.report.style import (
    AXIS_STYLES,
    BLACK,
    BLUE,
    GREY,
    JOINT_STYLES,
    SMALL,
    TEXT,
    VERMILLION,
    LineStyle,
    files,
    house_style,
    name_limit,
    new_figure,
    settle,
)
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
APART = 5.0
"""Runs whose durations differ by more, or deviations that pass their bound by more, share a logarithmic axis."""
_PLAIN = FuncFormatter(lambda value, _: number_of(value))  # no powers of ten
_TURNS = 1e-4  # rad: angles that move less are not drawn
# Six runs as joints have styles of their own, two more by wider and finer dashes.
_STYLES: tuple[tuple[str, LineStyle], ...] = (*JOINT_STYLES, ("#56b4e9", "-"), (GREY, (0, (8, 1.5, 1.5, 1.5))))


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


def following_figure(run: Following, title: str) -> Figure:
    """Each coordinate that moves, planned and as the controller has it, and the deviation with its maximum."""
    turns = moving(run.x_e, run.x, rows=range(3, 6), least=_TURNS)
    rows = [*(moving(run.x_e, run.x, rows=range(3)) or ([] if turns else range(3))), *turns]
    deviations = [("d", "deviation d\n[mm]", run.deviation / MM, "mm")]
    if turns:
        deviations.append(("turn", "deviation of\nangles [deg]", run.turn / DEG, "deg"))
    heights = [1.0] * len(rows) + [1.3] * len(deviations)
    figure = new_figure(1.7 + 1.25 * sum(heights), title, f"{run.label} · {number_of(float(run.t[-1]))} s")
    grid = figure.subplots(len(heights), 1, sharex=True, height_ratios=heights, squeeze=False)[:, 0]
    for axes, i in zip(grid, rows, strict=False):
        factor, unit = POSE_UNITS[i]
        for name, x, style in run.shown:
            curve(axes, run.t, x[:, i] / factor, f"{name} {COORDINATES[i]}", **style)
        room_around(axes, [x[:, i] / factor for _, x, _ in run.shown], 1.0)
        axes.set_ylabel(f"{COORDINATES[i]} [{unit}]")
    for axes, (gid, label, values, unit) in zip(grid[len(rows) :], deviations, strict=True):
        curve(axes, run.t, values, gid, color=BLACK)
        room_above(axes, [values], 1e-3)
        mark_peak(axes, run.t, values, unit)
        axes.set_ylabel(label)
    for axes in grid:
        axes.yaxis.set_major_locator(MaxNLocator(4))
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    legend(figure, [Line2D([], [], **style) for _, _, style in run.shown])
    return finish(figure)


def family_figure(runs: Sequence[Following], parameter: str, title: str, bound: float | None = None) -> Figure:
    """The deviation of each run over time, its maximum marked and named in the legend, and what it may be at most [m].

    From 0 on in seconds; where durations differ much, evenly to a tenth of the shortest and logarithmically on, and so
    where the largest deviation is far over its bound. Raises ValueError for more runs than there are styles for.
    """
    figure = new_figure(6.2, title, f"distance of the controller from the equilibrium (eq. 6.8) by {parameter}")
    axes, handles = figure.subplots(), []
    for run, (color, line) in zip(runs, _STYLES[: len(runs)], strict=True):
        t, d = run.t - run.t[0], run.deviation / MM
        curve(axes, t, d, f"d {run.label}", color=color, linestyle=line)
        shown = mark_peak(axes, t, d, "mm")
        handles.append(Line2D([], [], color=color, linestyle=line, label=f"{run.label}: at most {shown}"))
    axes.set_title("", loc="right")  # the legend has every maximum
    axes.set_ylabel("deviation d [mm]")
    axes.set_xlabel(TIME)
    most = max(float(run.deviation.max()) for run in runs) / MM
    room_above(axes, [np.array([most, (bound or 0.0) / MM])], 1e-3)
    if bound is not None:
        name_limit(axes, bound / MM, f"bound {number_of(bound / MM)} mm")
        if most > APART * bound / MM:
            axes.set_yscale("log")
            axes.set_ylim(bound / MM / 20, 2 * most)
            axes.yaxis.set_major_formatter(_PLAIN)
    spans = [float(run.t[-1] - run.t[0]) for run in runs]
    if max(spans) > APART * min(spans):
        axes.set_xscale("symlog", linthresh=min(spans) / 10, linscale=0.4)
        axes.xaxis.set_major_formatter(_PLAIN)
    axes.set_xlim(0, max(spans))
    legend(figure, handles)
    return finish(figure)


# By their numbers, poles beyond the unit circle, on it, inside; a grey print tells them apart, too.
_VERDICTS = (("#bb6a48", "unstable"), ("#f0b73a", "marginal"), ("#d9eaf6", "stable"))
_RANGE = "#a6cbe2"
_MICRO = 1e-6


def stability_figure(
    k: Array,
    d: Array,
    maps: Mapping[float, NDArray[np.int8]],
    h: float,
    m_points: float,
    points: Sequence[tuple[str, float, float]],
    title: str,
) -> Figure:
    """Maps of verdicts (a, b) over stiffness k (a,) and damping d (b,) where both are positive, by inertia [kg], with
    their two limits; and chosen points (name, k, d) of the inertia m_points, one with k = 0 at the left edge.

    verdicts: 0 unstable, 1 marginal, 2 stable.
    """
    a, b = k > 0, d > 0
    x, y = k[a], d[b]
    figure = new_figure(9.6, title, f"forward Euler, h = {number_of(h * 1e3)} ms")
    grid = figure.subplots(-(-len(maps) // 2), min(2, len(maps)), sharex=True, sharey=True, squeeze=False)
    colors = ListedColormap([color for color, _ in _VERDICTS])
    fine = np.geomspace(x[0], x[-1], 400)
    lines: tuple[tuple[str, LineStyle], ...] = (("h·k = d", "-"), ("h·d/m = 2 + h²·k/(2m)", (0, (7, 2.5))))
    for axes, (m, verdicts) in zip(grid.flat, maps.items(), strict=False):
        shown = verdicts[np.ix_(a, b)]
        axes.set_xscale("log")
        axes.set_yscale("log")
        style: dict[str, Any] = {"cmap": colors, "vmin": -0.5, "vmax": 2.5, "shading": "nearest", "rasterized": True}
        axes.pcolormesh(x, y, shown.T, gid=f"verdicts {number_of(m)}", **style)
        axes.set_xlim(x[0], x[-1])
        axes.set_ylim(y[0], y[-1])
        axes.set_title(f"m = {number_of(m)} kg", size=SMALL)
        for (name, line), values in zip(lines, (h * fine, 2 * m / h + h * fine / 2), strict=True):
            axes.plot(fine, values, color=BLACK, linestyle=line, linewidth=2.0, gid=f"{name}, {number_of(m)}", zorder=3)
        for name, at, height in points if m == m_points else ():
            place = (max(at, x[0]), height)
            axes.plot(*place, "o", color=BLACK, markerfacecolor="white", gid=name, zorder=5, clip_on=False)
            right = place[0] > np.sqrt(x[0] * x[-1])
            style = {"ha": "right" if right else "left", "va": "center", "size": SMALL, "zorder": 5}
            axes.annotate(name, place, (-8 if right else 8, 0), textcoords="offset points", **style)
    for axes in grid[-1]:
        axes.set_xlabel("stiffness k [N/m]")
    for axes in grid[:, 0]:
        axes.set_ylabel("damping d [N s/m]")
    handles: list[Line2D | Patch] = [
        Patch(color=color, linewidth=0, label=name)
        for i, (color, name) in enumerate(_VERDICTS)
        if any((verdicts[np.ix_(a, b)] == i).any() for verdicts in maps.values())
    ]
    handles += [Line2D([], [], color=BLACK, linestyle=s, linewidth=2.0, label=f"limit {n}") for n, s in lines]
    legend(figure, handles)
    return finish(figure)


def loop_time_figure(parts: Sequence[tuple[str, float, float, float]], thesis_worst: float, title: str) -> Figure:
    """Least, mean and longest time of each part of a period (label, least, mean, longest) [s] on a logarithmic scale,
    and the thesis' worst of all."""
    figure = new_figure(2.2 + 0.6 * len(parts), title)
    axes = figure.subplots()
    for row, (_, *seconds) in enumerate(parts):
        least, mean, longest = (value / _MICRO for value in seconds)
        axes.plot([least, longest], [row, row], "-|", color=_RANGE, linewidth=7, gid="range", solid_capstyle="butt")
        axes.plot(mean, row, "o", color=BLUE, markersize=8, gid="mean")
        words = f"{number_of(mean)} ({number_of(least)} to {number_of(longest)}) µs"
        axes.annotate(words, (mean, row), (0, 8), textcoords="offset points", ha="center", size=SMALL)
    worst = f"thesis' worst {number_of(thesis_worst / _MICRO)} µs"
    style = {"color": VERMILLION, "linestyle": (0, (5, 2.5)), "linewidth": 1.6}
    axes.axvline(thesis_worst / _MICRO, gid=worst, **style)  # type: ignore[arg-type]
    axes.set_xscale("log")
    axes.margins(x=0.25)
    axes.set_yticks(range(len(parts)), [label for label, *_ in parts], size=TEXT)
    axes.set_ylim(len(parts) - 0.5, -0.75)
    axes.set_xlabel("time [µs]")
    mean_of = Line2D([], [], color=BLUE, marker="o", linestyle="", markersize=8, label="mean")
    span = Line2D([], [], color=_RANGE, linewidth=7, solid_capstyle="butt", label="least to longest")
    legend(figure, [mean_of, span, Line2D([], [], **style, label=worst)])  # type: ignore[arg-type]
    return finish(figure)
