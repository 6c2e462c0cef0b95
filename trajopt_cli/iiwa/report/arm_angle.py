"""The map of path and arm angle: which joint forbids what, how far from limits the rest is, and the courses taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap, ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MultipleLocator

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.follow import curve
from trajopt_cli.iiwa.task.arm_map import FREE, ArmMap, margins
from trajopt_cli.iiwa.task.joint_checks import ELBOW, position_excess, speeds
from trajopt_cli.limits import JointLimits
from trajopt_cli.report.over_time import TIME, with_names
from trajopt_cli.report.style import BLACK, GREY, LIMIT, SMALL, VERMILLION, name_limit, new_figure
from trajopt_cli.units import DEG, MM

# Of joints 1, 2, 3, 5, 6, 7, from light to dark in turns, so that neighbours differ in grey, too.
_ZONES = dict(zip(FREE, ("#f2d5a0", "#b98a8a", "#d9c2e0", "#9cbf9c", "#e9a98c", "#b9b08a"), strict=True))
_MARGIN = LinearSegmentedColormap.from_list("margin", ["#4f7fae", "#b9d2e8", "#ffffff"])
_NEAR = 10 * DEG  # of joint_2, joint_4 or joint_6 from zero
_FLIP = 3 * DEG  # of joint_2: a spot this near to zero is marked
_EASE = (0.01, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12, 0.14)  # m3
_AXIS = 20 * MM  # of the wrist centre from axis 1
_STYLES: tuple[dict[str, Any], ...] = (
    {"color": BLACK, "linestyle": (0, (5, 2)), "linewidth": 2.2},
    {"color": VERMILLION, "linestyle": "-", "linewidth": 2.6},
)


@dataclass(frozen=True, eq=False)
class ArmAngleSeries:
    """A course of the arm angle (n,) [rad] with its joints q (n, 7) [rad], by name."""

    name: str
    arm_angle: Array
    q: Array


def map_figure(
    t: Array,
    chart: ArmMap,
    ease: Array,
    limits: JointLimits,
    courses: Sequence[ArmAngleSeries],
    definition: str,
    places: Sequence[tuple[float, str]],
    title: str,
) -> Figure:
    """The map over times t (n,) [s], one or two courses on it, and their distance from limits and speed below.

    ease (K + 1, m): manipulability of the map's joints, drawn as lines. places: (time [s], name) of what the path
    passes.
    """
    figure = new_figure(
        9.6, title, "white: far from every limit · coloured: a joint out of its range · joint_4 left out"
    )
    plan, margin, speed = figure.subplots(3, 1, sharex=True, height_ratios=[6, 1.5, 1.5])
    at, columns, shown = t[chart.rows], _edges(t[chart.rows]), _shown(chart, courses)
    q = chart.q[:, shown % len(chart.delta)]
    delta = (chart.delta[0] + chart.cell * shown) / DEG
    handles = _zones(plan, q, columns, _edges(delta), limits, figure)
    handles += _singular(plan, q, at, delta, chart)
    lines = plan.contour(at, delta, ease[:, shown % len(chart.delta)].T, _EASE, colors=BLACK, linewidths=0.7, alpha=0.6)
    plan.clabel(lines, fmt="%g", fontsize=SMALL)
    handles.append(Line2D([], [], color=BLACK, linewidth=0.7, alpha=0.6, label="manipulability [m³]"))
    for one, style in zip(courses, _STYLES, strict=False):
        angles = one.arm_angle / DEG
        if style["linestyle"] == "-":  # a seam, so that it shows on every colour
            curve(plan, t, angles, f"{one.name} seam", color="white", linewidth=4.6)
        curve(plan, t, angles, one.name, **style)
        curve(margin, t, margins(one.q, limits) / DEG, f"{one.name} distance", **{**style, "linewidth": 1.8})
        used = 100 * (speeds(one.q, t[1] - t[0]) / limits.velocity)[:, FREE].max(axis=1)
        curve(speed, t[1:], used, f"{one.name} speed", **{**style, "linewidth": 1.8})
        handles.append(Line2D([], [], **style, label=f"{one.name} arm angle"))
    plan.set_ylim(delta[0], delta[-1])
    plan.yaxis.set_major_locator(MultipleLocator(60))
    plan.set_ylabel(f"arm angle, {definition} [deg]")
    margin.set_ylabel("to nearest\nlimit [deg]", size=SMALL)
    speed.set_ylabel("fastest joint\n[% of limit]", size=SMALL)
    margin.set_ylim(*_span(margin, 0.0))
    top = max(_span(speed, 0.0)[1], 20.0)
    speed.set_ylim(0.0, top)
    if top > 100:
        name_limit(speed, 100, "limit")
    if margin.get_ylim()[0] < 0:
        margin.axhline(0, **LIMIT)
    speed.set_xlabel(TIME)
    speed.set_xlim(columns[0], columns[-1])
    figure.legend(handles=handles, loc="outside lower center", ncols=3, columnspacing=1.4)
    for at_place, _ in places:
        plan.axvline(at_place, color=GREY, linewidth=0.6, alpha=0.6)
    return with_names(figure, plan, places)


def _shown(chart: ArmMap, courses: Sequence[ArmAngleSeries]) -> Any:
    """Cells, counted on over whole turns: a turn about the courses, or more where they need it."""
    low = min(float(one.arm_angle.min()) for one in courses)
    high = max(float(one.arm_angle.max()) for one in courses)
    half = max(len(chart.delta) / 2, (high - low) / 2 / chart.cell + len(chart.delta) / 24)
    middle = ((high + low) / 2 - chart.delta[0]) / chart.cell
    return np.arange(int(np.floor(middle - half)), int(np.ceil(middle + half)) + 1)


def _edges(values: Array) -> Array:
    middles = (values[1:] + values[:-1]) / 2
    return np.concatenate([[2 * values[0] - middles[0]], middles, [2 * values[-1] - middles[-1]]])


def _span(axes: Axes, least: float) -> tuple[float, float]:
    values = np.concatenate([np.asarray(line.get_ydata(), dtype=np.float64) for line in axes.lines])
    low, high = min(least, float(values.min())), max(least, float(values.max()))
    return low - 0.1 * (high - low) * (low < least), high + 0.12 * (high - low) + 1e-9


def _zones(
    axes: Axes, q: Array, columns: Array, rows: Array, limits: JointLimits, figure: Figure
) -> list[Patch | Line2D]:
    """Distance from limits where it is allowed; where not, the joint that is furthest out."""
    margin = margins(q, limits) / DEG
    excess = position_excess(q, limits)[..., FREE]
    broken, worst = excess.max(axis=-1) > 0, np.array(FREE)[excess.argmax(axis=-1)]
    scale = axes.pcolormesh(
        columns,
        rows,
        np.ma.masked_where(broken, margin).T,
        cmap=_MARGIN,
        vmin=0,
        vmax=60,
        rasterized=True,
        gid="margin",
    )
    bar = figure.colorbar(scale, ax=axes, extend="max", pad=0.01, aspect=30)
    bar.set_label("distance from the nearest joint limit [deg]", size=SMALL)
    handles: list[Patch | Line2D] = []
    for joint in FREE:
        zone = broken & (worst == joint)
        if not zone.any():
            continue
        color = ListedColormap([_ZONES[joint]])
        shade = np.ma.masked_where(~zone, np.ones(zone.shape)).T
        axes.pcolormesh(columns, rows, shade, cmap=color, rasterized=True, gid=f"out joint_{joint + 1}")
        handles.append(Patch(color=_ZONES[joint], linewidth=0, label=f"joint_{joint + 1} out of range"))
    return handles


def _singular(axes: Axes, q: Array, at: Array, delta: Array, chart: ArmMap) -> list[Patch | Line2D]:
    """Where joint_2 or joint_6 near zero; where the elbow is stretched or the wrist centre on axis 1, all angles."""
    handles: list[Patch | Line2D] = []
    for joint, hatch, name in ((1, "////", "shoulder: joint_2"), (5, "\\\\\\\\", "wrist: joint_6")):
        near = np.abs(q[..., joint])
        if near.min() < _NEAR:
            band = axes.contourf(at, delta, near.T, [-1.0, _NEAR], colors="none", hatches=[hatch])
            band.set_edgecolor(GREY)
            band.set_linewidth(0.0)
            axes.contour(at, delta, near.T, [_NEAR], colors=[GREY], linewidths=0.9)
            label = f"{name} within {_NEAR / DEG:.0f}° of 0"
            handles.append(Patch(facecolor="white", edgecolor=GREY, hatch=hatch, linewidth=0.8, label=label))
    near = np.abs(q[..., 1])
    inner = near[1:-1, 1:-1]
    lowest = inner < _FLIP
    for k, i in ((-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (-1, 1), (1, -1), (1, 1)):
        lowest &= inner <= near[1 + k : len(near) - 1 + k, 1 + i : near.shape[1] - 1 + i]
    spots = np.argwhere(lowest) + 1
    if len(spots):
        style: dict[str, Any] = {"color": BLACK, "marker": "X", "markersize": 9, "linestyle": "", "zorder": 5}
        axes.plot(at[spots[:, 0]], delta[spots[:, 1]], gid="flip", markeredgecolor="white", **style)
        handles.append(Line2D([], [], **style, label="shoulder flip: joint_2 = 0"))
    for rows, name, hatch in (
        (chart.on_axis < _AXIS, f"wrist centre within {_AXIS / MM:.0f} mm of axis 1", ".."),
        (np.abs(q[:, 0, ELBOW]) < _NEAR, f"elbow stretched: joint_4 within {_NEAR / DEG:.0f}° of 0", "xx"),
    ):
        if rows.any():
            style = {"facecolor": "none", "edgecolor": GREY, "hatch": hatch, "linewidth": 0.0}
            axes.fill_between(at, delta[0], delta[-1], where=rows.tolist(), step="mid", **style)
            handles.append(Patch(**{**style, "linewidth": 0.8}, label=name))
    return handles
