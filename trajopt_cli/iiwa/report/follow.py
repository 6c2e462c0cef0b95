"""Following: equilibrium and controller over time, families of runs, feed schedules. Graf 6.11 to 6.16."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import (
    CONTROLLER,
    COORDINATES,
    FLANGE,
    PLANNED,
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
from trajopt_cli.report.style import BLACK, GREY, JOINT_STYLES, LineStyle, name_limit, new_figure
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
        shown = [("equilibrium", run.x_e, PLANNED), ("controller", run.x, CONTROLLER)]
        if run.true is not None:
            shown.append(("flange", run.true, FLANGE))
        for name, x, style in shown:
            curve(axes, run.t, x[:, i] / factor, f"{name} {COORDINATES[i]}", **style)
        room_around(axes, [x[:, i] / factor for _, x, _ in shown], 1.0)
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
    legend(figure, _handles(run))
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


def _handles(run: Following) -> list[Line2D]:
    return [Line2D([], [], **style) for style in (PLANNED, CONTROLLER, *([FLANGE] if run.true is not None else []))]
