"""Pictures over time: joints against limits, rail, TCP speed, axis speeds, effector, motors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Wait
from trajopt_cli.problem.course import Course, programmed_speed, target_flange
from trajopt_cli.problem.workspace import rail_ranges
from trajopt_cli.report.marks import PASSED, WAIT, mark_motions
from trajopt_cli.report.names import name_times, spread
from trajopt_cli.report.skeleton import angles
from trajopt_cli.report.style import (
    AXIS_STYLES,
    BLACK,
    BLUE,
    GREY,
    JOINT_STYLES,
    LIMIT,
    SKY,
    SMALL,
    VERMILLION,
    name_limit,
    new_figure,
    settle,
)
from trajopt_cli.units import DEG, MM

TIME = "time [s]"
_LIMIT = Line2D([], [], **LIMIT, label="limit")  # type: ignore[arg-type]


def joints(course: Course) -> Figure:
    """Position, speed and acceleration of each axis; the ticks are its limits. Figs 6.5 and 6.6 with their limits."""
    names, limits = course.plant.limits.names, course.plant.limits
    figure = new_figure(1.2 + 1.5 * len(names), "Axes against their limits", course.below)
    grid = figure.subplots(len(names), 3, sharex=True, squeeze=False)
    columns = (
        ("position", "", course.q, limits.lower, limits.upper),
        ("speed", "/s", course.qd, -limits.velocity, limits.velocity),
        ("acceleration", "/s²", course.qdd, -limits.acceleration, limits.acceleration),
    )
    for k, name in enumerate(names):
        factor, unit = unit_of(name)
        for panel, (what, per, values, lower, upper) in zip(grid[k], columns, strict=True):
            low, high = lower[k] / factor, upper[k] / factor
            _between_limits(panel, low, high)
            panel.plot(course.t, values[:, k] / factor, color=BLUE, linewidth=1.5, solid_joinstyle="round")
            panel.set_ylabel(f"[{unit}{per}]", size=SMALL)
            if k == 0:
                panel.set_title(what, pad=10)
            if what != "position":
                used = float(np.max(np.abs(values[:, k])) / upper[k])
                panel.text(
                    0.99, 0.985, f"peak {100 * used:.0f} %", transform=panel.transAxes, ha="right", va="top",
                    size=SMALL - 1.5, color=GREY,
                )  # fmt: skip
        grid[k, 0].set_ylabel(f"{readable(name)}\n[{unit}]", size=SMALL)
    mark_motions(course, grid.flat)
    for panel in grid[-1]:
        panel.set_xlabel(TIME)
    key(figure, course, [_LIMIT])
    figure.align_ylabels()
    settle(figure)
    return figure


def _between_limits(panel: Axes, low: float, high: float) -> None:
    """Dashed lines and ticks at both limits, and one between them: 0 where it is clear of both."""
    middle = 0.0 if min(-low, high) > 0.25 * (high - low) else (low + high) / 2
    room = 0.3 * (high - low)
    panel.set_ylim(low - room / 2, high + room)
    panel.set_yticks([low, middle, high], [number(value) for value in (low, middle, high)])
    for limit in (low, high):
        panel.axhline(limit, **LIMIT)  # type: ignore[arg-type]


def rail(course: Course) -> Figure | None:
    """Rail position, and from where each work point can be reached, at the time it is reached. Figs 5.2 and 6.4."""
    if not course.plant.robot.has_rail:
        return None
    figure = new_figure(6.0, "Rail and the positions each point can be reached from", course.below)
    axes = figure.subplots()
    width = 0.004 * (course.t[-1] - course.t[0])
    ranges = np.empty((0, 2))
    for leg in course.legs:
        X_WF = target_flange(leg)
        if isinstance(leg.motion, Wait):
            for low, high in ranges:  # the point last reached is held
                axes.fill_between([leg.t_0, leg.t_1], low / MM, high / MM, color=SKY, alpha=0.25, linewidth=0)
            continue
        ranges = np.empty((0, 2)) if X_WF is None else rail_ranges(course.plant, X_WF)
        for low, high in ranges:
            axes.vlines(leg.t_1, low / MM, high / MM, color=SKY, linewidth=3, gid="reach")
            for end in (low, high):
                axes.hlines(end / MM, leg.t_1 - width, leg.t_1 + width, color=BLUE, linewidth=2)
        asked = course.plant.rail_value(leg.motion.extax)
        if asked is not None:
            axes.plot(
                leg.t_1, asked / MM, "x", color=VERMILLION, markersize=8, markeredgewidth=2, zorder=6, clip_on=False
            )
    axes.plot(course.t, course.plant.layout.place(course.q) / MM, color=BLACK, linewidth=2.4, zorder=5, gid="rail")
    layout, limits = course.plant.layout, course.plant.limits
    low, high = float(layout.place(limits.lower)) / MM, float(layout.place(limits.upper)) / MM
    name_limit(axes, high, f"end of the rail {number(high)} mm")
    name_limit(axes, low, f"end of the rail {number(low)} mm", below=True)
    axes.set_ylim(low - 0.09 * (high - low), high + 0.09 * (high - low))
    axes.set_ylabel("rail [mm]")
    axes.set_xlabel(TIME)
    mark_motions(course, [axes])
    handles: list[Line2D | Patch] = [Line2D([], [], color=BLACK, linewidth=2.4, label="rail")]
    if any(target_flange(leg) is not None for leg in course.legs):
        handles.append(Line2D([], [], color=SKY, linewidth=3, marker="_", markeredgecolor=BLUE, label="point in reach"))
    if any(course.plant.rail_value(leg.motion.extax) is not None for leg in course.moves):  # type: ignore[union-attr]
        handles.append(Line2D([], [], color=VERMILLION, marker="x", linestyle="", label="as programmed"))
    key(figure, course, handles)
    return named(course, figure, axes)


def tcp_speed(course: Course) -> Figure:
    """Speed of the TCP, the speed the program gives each motion, and the plant's cap. Fig. 4.4."""
    figure = new_figure(5.4, "Speed of the tool centre point", course.below)
    axes = figure.subplots()
    speed = np.linalg.norm(course.V_WT[:, :3], axis=1) / MM
    cap = course.plant.tcp.speed / MM
    bound = False
    for leg in course.legs:
        value = programmed_speed(course.plant, leg.motion)
        if value is not None:
            bound = True
            axes.plot([leg.t_0, leg.t_1], [min(value / MM, cap)] * 2, color=VERMILLION, linewidth=2.2, gid="programmed")
    axes.plot(course.t, speed, color=BLUE, gid="speed")
    name_limit(axes, cap, f"cap of the tool centre point {number(cap)} mm/s")
    axes.set_ylim(0, 1.1 * max(cap, float(speed.max())))
    axes.set_ylabel("TCP speed [mm/s]")
    axes.set_xlabel(TIME)
    mark_motions(course, [axes])
    handles = [Line2D([], [], color=BLUE, label="planned")]
    if bound:
        handles.append(Line2D([], [], color=VERMILLION, linewidth=2.2, label="programmed, at most the cap"))
    key(figure, course, handles)
    return named(course, figure, axes)


def axis_speeds(course: Course) -> Figure:
    """x, y, z speeds of the TCP in the world and, on a rail, as seen from the carriage. Fig. 4.5."""
    V = course.V_WT[:, :3]
    panels = [("in the world", V)]
    if course.plant.robot.has_rail:
        panels.append(("relative to the carriage", V - course.rail_speed))
    figure = new_figure(2.0 + 2.7 * len(panels), "Speeds of the tool centre point along the axes", course.below)
    grid = figure.subplots(len(panels), 1, sharex=True, sharey=True, squeeze=False)[:, 0]
    for axes, (where, values) in zip(grid, panels, strict=True):
        draw_xyz(axes, course.t, values / MM)
        axes.axhline(0, color=GREY, linewidth=0.7)
        axes.set_ylabel(f"TCP speed\n{where}\n[mm/s]" if len(panels) > 1 else "TCP speed [mm/s]")
    grid[-1].set_xlabel(TIME)
    mark_motions(course, grid)
    key(figure, course, xyz_handles())
    return named(course, figure, grid[0])


def effector(course: Course) -> Figure:
    """Position, speed and orientation of the TCP in the world. Figs 6.2 and 6.3, and the three angles."""
    figure = new_figure(9.4, "Effector: position, speed, orientation", course.below)
    grid = figure.subplots(3, 1, sharex=True)
    turned = angles(course.X_WT) / DEG
    draw_xyz(grid[0], course.t, course.X_WT[:, :3, 3] / MM)
    draw_xyz(grid[1], course.t, course.V_WT[:, :3] / MM)
    for i, (color, line) in enumerate(AXIS_STYLES):
        grid[2].plot(course.t, turned[:, i], color=color, linestyle=line)
    for axes, label in zip(grid, ("position [mm]", "speed [mm/s]", "x-y'-z'' angles [deg]"), strict=True):
        axes.set_ylabel(label)
    grid[1].axhline(0, color=GREY, linewidth=0.7)
    _at_least(grid[2], 20.0)
    grid[-1].set_xlabel(TIME)
    mark_motions(course, grid)
    key(figure, course, xyz_handles(("x · about x", "y · about y'", "z · about z''")))
    return named(course, figure, grid[0])


def motors(course: Course) -> Figure:
    """Angle and speed of every motor of the arm, and the rail's trajectory. Figs 6.4, 6.5 and 6.6."""
    has_rail, joints = course.plant.layout.has_rail, course.plant.layout.arm
    figure = new_figure(9.4 if has_rail else 7.4, "Motors", course.below)
    heights = [3, 3, 2] if has_rail else [3, 3]
    grid = figure.subplots(len(heights), 1, sharex=True, height_ratios=heights)
    for panel, values in zip(grid, (course.q, course.qd), strict=False):
        for value, (color, line) in zip(values[:, joints].T, JOINT_STYLES, strict=True):
            panel.plot(course.t, value / DEG, color=color, linestyle=line)
    grid[0].set_ylabel("angle [deg]")
    grid[1].set_ylabel("speed [deg/s]")
    grid[1].axhline(0, color=GREY, linewidth=0.7)
    if has_rail:
        grid[2].plot(course.t, course.plant.layout.place(course.q) / MM, color=BLACK)
        grid[2].set_ylabel("rail [mm]")
    grid[-1].set_xlabel(TIME)
    mark_motions(course, grid)
    styles = zip(course.plant.limits.names[joints], JOINT_STYLES, strict=True)
    key(figure, course, [Line2D([], [], color=c, linestyle=s, label=readable(n)) for n, (c, s) in styles])
    return named(course, figure, grid[0])


def draw_xyz(axes: Axes, t: Array, values: Array) -> None:
    """Three curves (n, 3) over t (n,) in the styles of x, y and z."""
    for i, (color, line) in enumerate(AXIS_STYLES):
        axes.plot(t, values[:, i], color=color, linestyle=line)


def xyz_handles(labels: tuple[str, str, str] = ("x", "y", "z")) -> list[Line2D]:
    """What the legend shows for draw_xyz."""
    return [Line2D([], [], color=c, linestyle=s, label=n) for n, (c, s) in zip(labels, AXIS_STYLES, strict=True)]


def unit_of(axis: str) -> tuple[float, str]:
    """SI per shown unit, and the unit's sign, of an axis by name."""
    return (MM, "mm") if axis == "rail" else (DEG, "deg")


def number(value: float) -> str:
    """Four figures, and the minus sign that the ticks have."""
    return f"{value:.4g}".replace("-", "−")


def readable(axis: str) -> str:
    """An axis' name as people write it."""
    return axis.replace("_", " ")


def key(figure: Figure, course: Course, handles: list[Line2D] | list[Line2D | Patch]) -> None:
    """The legend in one row under the picture; with the waits and the points passed where there are any."""
    more: list[Line2D | Patch] = [WAIT] if any(isinstance(leg.motion, Wait) for leg in course.legs) else []
    legend(figure, [*handles, *more, *([PASSED] if course.passed.any() else [])])


def legend(figure: Figure, entries: Sequence[Line2D | Patch]) -> None:
    """The entries in one row under the picture."""
    figure.legend(handles=entries, loc="outside lower center", ncols=len(entries), columnspacing=1.6, handlelength=2.6)


def named(course: Course, figure: Figure, top: Axes) -> Figure:
    """The settled figure with the targets' names over its top panel."""
    return with_names(figure, top, [(leg.t_1, leg.name) for leg in course.moves])


def with_names(figure: Figure, top: Axes, ends: Sequence[tuple[float, str]]) -> Figure:
    """The settled figure with a name per (time [s], name) over its top panel."""
    names = name_times(top, ends)
    figure.align_ylabels()
    settle(figure)
    spread(names)
    return figure


def _at_least(axes: Axes, span: float) -> None:
    """Widen the vertical range to span, so that a constant does not fill the panel with its rounding."""
    low, high = axes.get_ylim()
    if high - low < span:
        middle = (low + high) / 2
        axes.set_ylim(middle - span / 2, middle + span / 2)
