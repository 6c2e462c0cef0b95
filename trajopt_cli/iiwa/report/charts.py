"""Charts beside the runs: stability map, loop time. Graf 6.10 and 6.19."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import finish, number_of
from trajopt_cli.report.over_time import legend
from trajopt_cli.report.style import BLACK, BLUE, SMALL, TEXT, VERMILLION, LineStyle, new_figure

# By their numbers, poles beyond the unit circle, on it, inside; a grey print tells them apart, too.
_VERDICTS = (("#bb6a48", "unstable"), ("#f0b73a", "marginal"), ("#d9eaf6", "stable"))
_RANGE = "#a6cbe2"
_MICRO = 1e-6


def stability_figure(
    k: Array,
    d: Array,
    verdicts: NDArray[np.int8],
    m: float,
    h: float,
    points: Sequence[tuple[str, float, float]],
    title: str,
) -> Figure:
    """Map of verdicts (a, b) over stiffness k (a,) and damping d (b,) where both are positive, the two limits, and
    chosen points (name, k, d); one with k = 0 is at the left edge.

    verdicts: 0 unstable, 1 marginal, 2 stable.
    """
    a, b = k > 0, d > 0
    x, y, shown = k[a], d[b], verdicts[np.ix_(a, b)]
    figure = new_figure(7.6, title, f"forward Euler, m = {number_of(m)} kg, h = {number_of(h * 1e3)} ms")
    axes = figure.subplots()
    axes.set_xscale("log")
    axes.set_yscale("log")
    colors = ListedColormap([color for color, _ in _VERDICTS])
    axes.pcolormesh(x, y, shown.T, cmap=colors, vmin=-0.5, vmax=2.5, shading="nearest", rasterized=True, gid="verdicts")
    axes.set_xlim(x[0], x[-1])
    axes.set_ylim(y[0], y[-1])
    handles: list[Line2D | Patch] = [
        Patch(color=color, linewidth=0, label=name) for i, (color, name) in enumerate(_VERDICTS) if (shown == i).any()
    ]
    fine = np.geomspace(x[0], x[-1], 400)
    limits: tuple[tuple[Array, str, LineStyle], ...] = (
        (h * fine, "h·k = d", "-"),
        (2 * m / h + h * fine / 2, "h·d/m = 2 + h²·k/(2m)", (0, (7, 2.5))),
    )
    for values, name, line in limits:
        axes.plot(fine, values, color=BLACK, linestyle=line, linewidth=2.0, gid=name, zorder=3)
        handles.append(Line2D([], [], color=BLACK, linestyle=line, linewidth=2.0, label=f"limit {name}"))
    for name, at, height in points:
        place = (max(at, x[0]), height)
        axes.plot(*place, "o", color=BLACK, markerfacecolor="white", gid=name, zorder=5, clip_on=False)
        right = place[0] > np.sqrt(x[0] * x[-1])
        style = {"ha": "right" if right else "left", "va": "center", "size": SMALL, "zorder": 5}
        axes.annotate(name, place, (-8 if right else 8, 0), textcoords="offset points", **style)  # type: ignore[arg-type]
    axes.set_xlabel("stiffness k [N/m]")
    axes.set_ylabel("damping d [N s/m]")
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
