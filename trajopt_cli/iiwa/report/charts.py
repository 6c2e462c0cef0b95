"""Charts beside the runs: stability map, thesis' numbers beside ours, loop time, joints. Graf 6.10 and 6.19."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.report.runs import PEAK, Marks, curve, finish, looked_at, number_of, room_around, times
from trajopt_cli.report.over_time import TIME, legend, number
from trajopt_cli.report.style import BLACK, BLUE, GREY, LIMIT, SMALL, TEXT, VERMILLION, LineStyle, new_figure, settle
from trajopt_cli.units import DEG, MM

# Verdicts by their numbers: poles beyond the unit circle, on it, inside. The thesis: blue stable, orange marginal.
UNSTABLE, MARGINAL, STABLE = 0, 1, 2
# Light to dark, so that a grey print tells them apart too.
_VERDICTS = {STABLE: ("#d9eaf6", "stable"), MARGINAL: ("#f0b73a", "marginal"), UNSTABLE: ("#bb6a48", "unstable")}
_THESIS, _RANGE = "#8c8c8c", "#a6cbe2"
# SI per shown unit of table_bars.
UNITS = {"mm": MM, "deg": DEG, "m": 1.0, "N": 1.0, "Nm": 1.0, "s": 1.0, "ms": 1e-3, "µs": 1e-6}


def stability_figure(
    k: ArrayLike,
    d: ArrayLike,
    verdict: ArrayLike,
    m: float,
    h: float,
    points: Sequence[tuple[str, float, float]],
    title: str,
) -> Figure:
    """Map of verdicts (a, b) over stiffness k (a,) and damping d (b,), both limits, chosen points (name, k, d)."""
    stiffness, damping = np.asarray(k, dtype=np.float64), np.asarray(d, dtype=np.float64)
    verdicts = np.asarray(verdict)
    for name, values in (("k", stiffness), ("d", damping)):
        if values.ndim != 1 or (values > 0).sum() < 2 or (np.diff(values) <= 0).any() or values[0] < 0:
            raise ValueError(f"stability: {name} has shape {values.shape}, wanted two positive, growing values or more")
    if verdicts.shape != (len(stiffness), len(damping)) or not set(np.unique(verdicts)) <= set(_VERDICTS):
        raise ValueError(
            f"stability: verdict has shape {verdicts.shape}, wanted {(len(stiffness), len(damping))} of 0, 1 and 2"
        )
    figure = new_figure(7.6, title, f"forward Euler, m = {number_of(m)} kg, h = {number_of(h * 1e3)} ms")
    axes = figure.subplots()
    axes.set_xscale("log")
    axes.set_yscale("log")
    columns, rows = _strips(stiffness), _strips(damping)
    for which, x in columns:
        for what, y in rows:
            _cells(axes, x, y, verdicts[np.ix_(which, what)].T)
    low, high = columns[-1][1][[0, -1]]
    curve_k = np.geomspace(low, high, 400)
    bottom, top = rows[-1][1][[0, -1]]
    limits: tuple[tuple[Array, str, LineStyle], ...] = (
        (h * curve_k, "h·k = d", "-"),
        (2 * m / h + h * curve_k / 2, "h·d/m = 2 + h²·k/(2m)", (0, (7, 2.5))),
    )
    handles: list[Line2D | Patch] = [
        Patch(color=color, linewidth=0, label=name)
        for value, (color, name) in _VERDICTS.items()
        if (verdicts == value).any()
    ]
    for values, name, line in limits:
        within = (values >= bottom) & (values <= top)
        axes.plot(curve_k[within], values[within], color=BLACK, linestyle=line, linewidth=2.0, gid=name, zorder=3)
        handles.append(Line2D([], [], color=BLACK, linestyle=line, linewidth=2.0, label=f"limit {name}"))
    axes.set_xlim(columns[0][1][0], high)
    axes.set_ylim(rows[0][1][0], top)
    for axis, strips, values in ((axes.xaxis, columns, stiffness), (axes.yaxis, rows, damping)):
        first = int(np.ceil(np.log10(values[values > 0][0]) - 1e-9))
        last = int(np.floor(np.log10(values[-1]) + 1e-9))
        ticks = [(10.0**n, f"$10^{{{n}}}$") for n in range(first, last + 1)]
        if len(strips) == 2:
            edges = strips[0][1]
            ticks.insert(0, (float(np.sqrt(edges[0] * edges[-1])), "0"))
        axis.set_ticks([at for at, _ in ticks], [text for _, text in ticks])
        axis.set_minor_locator(NullLocator())
    axes.set_xlabel("stiffness k [N/m]")
    axes.set_ylabel("damping d [N s/m]")
    chosen: Marks = [(_place(a, columns), _place(b, rows), name) for name, a, b in points if a > 0]
    for name, a, b in points:
        if a == 0:  # its strip is too narrow for a name: that stands beside it
            at, height, beside = _place(a, columns), _place(b, rows), float(columns[-1][1][0])
            axes.plot([at, beside], [height, height], color=GREY, linewidth=0.8, gid="line to a name")
            axes.plot(at, height, gid="peak", zorder=5, **PEAK)
            axes.annotate(name, (beside, height), (4, 0), textcoords="offset points", va="center", size=SMALL)
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles), columnspacing=1.4)
    return finish(figure, [(axes, chosen)])


def _strips(values: Array) -> list[tuple[IndexArray, Array]]:
    """Rows of values and the edges of their cells on a logarithmic scale; a zero has a strip of its own before them."""
    positive = np.flatnonzero(values > 0)
    logs = np.log(values[positive])
    middles = (logs[1:] + logs[:-1]) / 2
    edges = np.exp(np.concatenate([[1.5 * logs[0] - 0.5 * logs[1]], middles, [1.5 * logs[-1] - 0.5 * logs[-2]]]))
    strips = [(positive, edges)]
    if values[0] == 0:
        decades = float(np.log10(edges[-1] / edges[0]))
        wide, gap = 10 ** (0.06 * decades), 10 ** (0.015 * decades)
        strips.insert(0, (np.array([0]), np.array([edges[0] / gap / wide, edges[0] / gap])))
    return strips


def _cells(axes: Axes, x: Array, y: Array, verdicts: Array) -> None:
    colors = ListedColormap([_VERDICTS[value][0] for value in sorted(_VERDICTS)])
    axes.pcolormesh(x, y, verdicts, cmap=colors, vmin=-0.5, vmax=2.5, rasterized=True, zorder=1, gid="verdicts")


def _place(value: float, strips: list[tuple[IndexArray, Array]]) -> float:
    """Where a value stands on its scale; zero in the middle of its strip."""
    edges = strips[0][1]
    return float(np.sqrt(edges[0] * edges[-1])) if value == 0 and len(strips) == 2 else value


def table_figure(
    rows: Sequence[tuple[str, float, float]],
    quantity: str,
    unit: str,
    title: str,
    names: tuple[str, str] = ("thesis", "ours"),
) -> Figure:
    """The thesis' number beside ours per row (label, thesis, ours) in SI, drawn in unit, with the difference.

    names: of both in the legend.
    """
    if not rows or unit not in UNITS:
        raise ValueError(f"table_bars needs rows and one of {', '.join(UNITS)}, not {len(rows)} rows in {unit}")
    figure = new_figure(1.8 + 0.78 * len(rows), title)
    axes = figure.subplots()
    longest = max(max(thesis, ours) for _, thesis, ours in rows) / UNITS[unit]
    for row, (_, thesis, ours) in enumerate(rows):
        first, second = thesis / UNITS[unit], ours / UNITS[unit]
        change = f"{100 * (ours / thesis - 1):+.1f} %".replace("-", "−") if thesis else ""
        for at, value, color, text in (
            (row - 0.19, first, _THESIS, number_of(first)),
            (row + 0.19, second, BLUE, f"{number_of(second)}   {change}".rstrip()),
        ):
            axes.barh(at, value, 0.36, color=color)
            axes.annotate(text, (value, at), (5, 0), textcoords="offset points", va="center", size=SMALL)
    axes.set_yticks(range(len(rows)), [label for label, _, _ in rows], size=TEXT)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(rows) - 0.45, -0.55)
    axes.set_xlim(0, 1.2 * longest)
    axes.spines["left"].set_visible(False)
    axes.set_xlabel(f"{quantity} [{unit}]")
    handles = [Patch(color=color, label=name) for color, name in zip((_THESIS, BLUE), names, strict=True)]
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    settle(figure)
    return figure


def loop_time_figure(
    parts: Sequence[tuple[str, float, float, float]], thesis_worst: float, title: str, period: float = 1e-3
) -> Figure:
    """Least, mean and longest time of each part of a step (label, min, mean, max) [s] on a logarithmic scale."""
    for label, least, mean, longest in parts:
        if not 0 < least <= mean <= longest:
            raise ValueError(f"loop_time: {label} has {least}, {mean}, {longest} s, wanted 0 < min <= mean <= max")
    if not parts:
        raise ValueError("loop_time needs at least one part")
    figure = new_figure(2.2 + 0.6 * len(parts), title)
    axes = figure.subplots()
    micro = 1e-6
    clear = {"facecolor": "white", "edgecolor": "none", "pad": 0.5}  # of the limits' lines
    for row, (_, least, mean, longest) in enumerate(parts):
        axes.plot(
            [least / micro, longest / micro], [row, row], color=_RANGE, linewidth=7, solid_capstyle="butt", gid="range"
        )
        axes.plot([least / micro, longest / micro], [row, row], "|", color=BLUE, markersize=13, markeredgewidth=2)
        axes.plot(mean / micro, row, "o", color=BLUE, markersize=8, gid="mean")
        words = f"{number_of(mean / micro)} ({number_of(least / micro)} to {number_of(longest / micro)}) µs"
        axes.annotate(
            words, (mean / micro, row), (0, 10), textcoords="offset points", ha="center", size=SMALL, bbox=clear
        )
    for value, text, color in (
        (thesis_worst, f"thesis' worst {number_of(thesis_worst / micro)} µs", VERMILLION),
        (period, f"period {number_of(period * 1e3)} ms", BLACK),
    ):
        axes.axvline(value / micro, color=color, linestyle=(0, (5, 2.5)), linewidth=1.6, gid=text)
        axes.annotate(
            text, (value / micro, 1), (0, 3), xycoords=("data", "axes fraction"), textcoords="offset points",
            ha="center", va="bottom", size=SMALL, color=color,
        )  # fmt: skip
    shown = [value / micro for part in parts for value in part[1:]] + [thesis_worst / micro, period / micro]
    axes.set_xscale("log")
    axes.set_xlim(min(shown) / 4, max(shown) * 2.2)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.10g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_yticks(range(len(parts)), [label for label, *_ in parts], size=TEXT)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(parts) - 0.5, -0.75)
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("time [µs]")
    handles = [
        Line2D([], [], color=BLUE, marker="o", linestyle="", markersize=8, label="mean"),
        Line2D([], [], color=_RANGE, linewidth=7, solid_capstyle="butt", label="least to longest"),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    settle(figure)
    return figure


def joints_figure(
    t: ArrayLike,
    q: ArrayLike,
    lower: ArrayLike,
    upper: ArrayLike,
    velocity: ArrayLike,
    title: str,
    delta: ArrayLike | None = None,
) -> Figure:
    """Position and speed of each joint against its limits, and the arm angle (n,) [rad] where it changes."""
    time = times(t, "joints")
    count = len(np.atleast_1d(lower))
    angles = looked_at(q, (len(time), count), "joints: q") / DEG
    low, high, fast = (
        looked_at(v, (count,), f"joints: {n}") / DEG
        for v, n in ((lower, "lower"), (upper, "upper"), (velocity, "velocity"))
    )
    # the step of each period, as the controller judges it
    speed = np.diff(angles, axis=0) / np.diff(time)[:, None]
    arm = None if delta is None else looked_at(delta, time.shape, "joints: delta") / DEG
    extra = arm is not None and float(np.ptp(arm)) > 1e-6
    used = np.abs(speed).max(axis=0) / fast
    near = np.minimum(angles.min(axis=0) - low, high - angles.max(axis=0))
    worst, tight = int(np.argmax(used)), int(np.argmin(near))
    text = (
        f"fastest joint {worst + 1}: {100 * used[worst]:.0f} % of its speed limit · "
        f"nearest to its end joint {tight + 1}: {_left(float(near[tight]))}"
    )
    figure = new_figure(1.5 + 1.3 * count + (1.3 if extra else 0), title, text)
    grid = figure.subplots(count + extra, 2, sharex=True, squeeze=False)
    for k in range(count):
        _bounded(grid[k, 0], float(low[k]), float(high[k]))
        _bounded(grid[k, 1], -float(fast[k]), float(fast[k]))
        curve(grid[k, 0], time, angles[:, k], f"q {k + 1}", color=BLUE, linewidth=1.6)
        curve(
            grid[k, 1], np.repeat(time, 2)[1:-1], np.repeat(speed[:, k], 2), f"speed {k + 1}", color=BLUE,
            linewidth=1.6,
        )  # fmt: skip
        grid[k, 0].set_ylabel(f"joint {k + 1}\n[deg]", size=SMALL)
        grid[k, 1].set_ylabel("[deg/s]", size=SMALL)
        _note(grid[k, 0], _left(float(near[k])), near[k] < 0)
        _note(grid[k, 1], f"peak {100 * used[k]:.0f} %", used[k] > 1)
    for panel in grid[count - 1]:
        panel.tick_params(labelbottom=True)
        panel.set_xlabel(TIME)
    if extra and arm is not None:
        places = grid[-1, 0].get_gridspec()
        for panel in grid[-1]:
            panel.remove()
        wide = figure.add_subplot(places[-1, :], sharex=grid[0, 0])
        curve(wide, time, arm, "arm angle", color=BLACK, linewidth=1.6)
        room_around(wide, [arm], 1.0, 0.15)
        wide.set_ylabel("arm angle\n[deg]", size=SMALL)
        wide.set_xlabel(TIME)
    grid[0, 0].set_title("position", pad=8)
    grid[0, 1].set_title("speed", pad=8)
    grid[0, 0].set_xlim(time[0], time[-1])
    legend(figure, [Line2D([], [], **LIMIT, label="limit")])  # type: ignore[arg-type]
    figure.align_ylabels()
    settle(figure)
    return figure


def _bounded(axes: Axes, low: float, high: float) -> None:
    """Dashed lines and ticks at both limits and between them, and room for a note above."""
    middle = (low + high) / 2
    axes.set_ylim(low - 0.15 * (high - low), high + 0.3 * (high - low))
    axes.set_yticks([low, middle, high], [number(value) for value in (low, middle, high)])
    for limit in (low, high):
        axes.axhline(limit, **LIMIT)  # type: ignore[arg-type]


def _left(room: float) -> str:
    return f"{number_of(room)}° left" if room >= 0 else f"{number_of(-room)}° beyond"


def _note(axes: Axes, text: str, broken: bool) -> None:
    style: dict[str, Any] = {"size": SMALL - 1.5, "color": VERMILLION if broken else GREY}
    axes.text(0.99, 1.0, text, transform=axes.transAxes, ha="right", va="top", **style)
