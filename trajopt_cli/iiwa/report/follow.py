"""Following over time, families of runs, feed schedules; stability map, loop time. Graf 6.10 to 6.16, 6.19."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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
from trajopt_cli.iiwa.report.runs import (
    COORDINATES,
    POSE_UNITS,
    Following,
    curve,
    finish,
    mark_peak,
    moving,
    number_of,
    room_above,
    room_around,
)
from trajopt_cli.report.over_time import TIME, legend
from trajopt_cli.report.style import (
    BLACK,
    BLUE,
    GREY,
    JOINT_STYLES,
    SMALL,
    TEXT,
    VERMILLION,
    LineStyle,
    name_limit,
    new_figure,
)
from trajopt_cli.units import DEG, MM

APART = 5.0
"""Runs whose durations differ by more share a logarithmic time axis."""
_PLAIN = FuncFormatter(lambda value, _: number_of(value))  # no powers of ten
_TURNS = 1e-4  # rad: angles that move less are not drawn
# Six runs as joints have styles of their own, two more by wider and finer dashes.
_STYLES: tuple[tuple[str, LineStyle], ...] = (*JOINT_STYLES, ("#56b4e9", "-"), (GREY, (0, (8, 1.5, 1.5, 1.5))))


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


def family_figure(runs: Sequence[Following], parameter: str, title: str) -> Figure:
    """The deviation of each run over time, its maximum marked, and named in the legend."""
    figure = new_figure(6.2, title, f"distance of the controller from the equilibrium (eq. 6.8) by {parameter}")
    axes = figure.subplots()
    _deviations(figure, axes, runs)
    room_above(axes, [run.deviation / MM for run in runs], 1e-3)
    axes.set_xlabel(TIME)
    _share_time(axes, runs)
    return finish(figure)


def feed_figure(runs: Sequence[Following], bound: float, title: str) -> Figure:
    """Deviation of runs that feed one path in other ways against the bound [m], and how fast each is fed, over time."""
    figure = new_figure(8.2, title)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[1.35, 1])
    _deviations(figure, above, runs)
    name_limit(above, bound / MM, f"bound {number_of(bound / MM)} mm")
    most = max(float(run.deviation.max()) for run in runs) / MM
    if most > APART * bound / MM:
        above.set_yscale("log")
        above.set_ylim(bound / MM / 20, 2 * most)
        above.yaxis.set_major_formatter(_PLAIN)
    else:
        room_above(above, [np.array([most, bound / MM])], 1e-3)
    for run, (color, line) in zip(runs, _STYLES[: len(runs)], strict=True):
        t, speed = fed(run)
        curve(below, t, speed / MM, f"speed {run.label}", color=color, linestyle=line)
    below.set_ylabel("speed of the\nplan [mm/s]")
    below.set_xlabel(TIME)
    _share_time(below, runs)
    return finish(figure)


def fed(run: Following) -> tuple[Array, Array]:
    """How fast the equilibrium goes [m/s] as steps over time: each difference holds over its own period."""
    steps = np.linalg.norm(np.diff(run.x_e[:, :3], axis=0), axis=1) / np.diff(run.t)
    t = run.t - run.t[0]
    return np.repeat(t, 2)[1:-1], np.repeat(steps, 2)


def _deviations(figure: Figure, axes: Axes, runs: Sequence[Following]) -> None:
    """The runs' deviations; raises ValueError for more than there are styles for."""
    handles = []
    for run, (color, line) in zip(runs, _STYLES[: len(runs)], strict=True):
        t, d = run.t - run.t[0], run.deviation / MM
        curve(axes, t, d, f"d {run.label}", color=color, linestyle=line)
        shown = mark_peak(axes, t, d, "mm")
        handles.append(Line2D([], [], color=color, linestyle=line, label=f"{run.label}: at most {shown}"))
    axes.set_title("", loc="right")  # the legend has every maximum
    axes.set_ylabel("deviation d [mm]")
    legend(figure, handles)


def _share_time(axes: Axes, runs: Sequence[Following]) -> None:
    """Seconds from 0; where durations differ much, evenly to a tenth of the shortest and logarithmically on."""
    spans = [float(run.t[-1] - run.t[0]) for run in runs]
    if max(spans) > APART * min(spans):
        axes.set_xscale("symlog", linthresh=min(spans) / 10, linscale=0.4)
        axes.xaxis.set_major_formatter(_PLAIN)
    axes.set_xlim(0, max(spans))


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
