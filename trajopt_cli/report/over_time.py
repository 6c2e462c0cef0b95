"""Pictures over time: axes against their limits, rail, TCP speed, and all there is of the TCP."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Wait
from trajopt_cli.problem.workspace import rail_ranges
from trajopt_cli.report import style
from trajopt_cli.report.names import name_times, spread
from trajopt_cli.report.skeleton import angles
from trajopt_cli.trajectories.plan_series import PlanSeries, programmed_speed, target_flange, torques_along
from trajopt_cli.units import DEG, MM, slides, unit_of

TIME = "time [s]"
_LEAST_TURN = 20.0  # deg that a panel shows at least, so that a constant does not fill it with its rounding
_LIMIT = Line2D([], [], **style.LIMIT, label="limit")  # type: ignore[arg-type]
WAIT = Patch(color=style.PALE, linewidth=0, label="wait")
_LINE: dict[str, Any] = {"color": "#c4c4c4", "linewidth": 0.9}
_PASSED: dict[str, Any] = {**_LINE, "linestyle": (0, (1.5, 3))}
PASSED = Line2D([], [], **_PASSED | {"color": style.GREY}, label="point passed")


def joints(series: PlanSeries) -> Figure:
    """Position, speed, acceleration of each axis between its limits, torque where it is limited. Figs 6.4 to 6.6 with
    their limits."""
    names, limits = series.plant.limits.names, series.plant.limits
    below, above = limits.acceleration_at(series.q)
    figure = style.new_figure(1.2 + 1.55 * len(names), "Axes against their limits", series.below)
    columns = [
        ("position", "", series.q, limits.lower, limits.upper),
        ("speed", "/s", series.qd, -limits.velocity, limits.velocity),
        ("acceleration", "/s²", series.qdd, -below, above),
    ]
    if limits.binding_torque is not None:
        columns.append(("torque", "", torques_along(series), -limits.binding_torque, limits.binding_torque))
    grid = figure.subplots(len(names), len(columns), sharex=True, squeeze=False)
    for k, name in enumerate(names):
        for panel, (what, per, values, lower, upper) in zip(grid[k], columns, strict=True):
            factor, unit = unit_of(name)
            if what == "torque":
                factor, unit = 1.0, "N" if slides(name) else "Nm"
            ends = [np.broadcast_to(end, values.shape)[:, k] / factor for end in (lower, upper)]
            low, high = float(ends[0].min()), float(ends[1].max())
            if np.isfinite(high):
                _between_limits(panel, series.t, ends)
            panel.plot(series.t, values[:, k] / factor, color=style.BLUE, linewidth=1.5, solid_joinstyle="round")
            panel.set_ylabel(f"[{unit}{per}]", size=style.SMALL)
            if k == 0:
                panel.set_title(what, pad=10)
            told = f"{whole(low)} to {whole(high)}" if np.isfinite(high) else "no limit"
            if what != "position" and np.isfinite(high):
                used = float(np.max(values[:, k] / np.where(values[:, k] > 0, *ends[::-1]) / factor))
                told = f"±{whole(high)}, peak {100 * used:.0f} %"
            panel.text(
                0.99, 0.985, told, transform=panel.transAxes, ha="right", va="top", size=style.LEAST, color=style.GREY,
                gid="limits", bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8}, zorder=0.9,
            )  # fmt: skip
        grid[k, 0].set_ylabel(f"{name.replace('_', ' ')}\n[{unit_of(name)[1]}]", size=style.SMALL)
    mark_motions(series, grid.flat)
    for panel in grid[-1]:
        panel.set_xlabel(TIME)
    key(figure, series, [_LIMIT])
    style.settle(figure)
    figure.align_ylabels()  # before, the layout would measure a column once for each of its panels
    return figure


def _between_limits(panel: Axes, t: Array, ends: Sequence[Array]) -> None:
    """Dashed lines at both limits over time, room for their values over them, and round ticks between them."""
    low, high = float(ends[0].min()), float(ends[1].max())
    room = 0.3 * (high - low)
    panel.set_ylim(low - room / 2, high + 1.1 * room)
    ticks = MaxNLocator(nbins=4, steps=style.ROUND).tick_values(low, high)
    panel.set_yticks([tick for tick in ticks if low <= tick <= high])
    for limit in ends:
        if np.ptp(limit) == 0:
            panel.axhline(limit[0], **style.LIMIT)  # type: ignore[arg-type]
        else:
            panel.plot(t, limit, **style.LIMIT)  # type: ignore[arg-type]


def rail(series: PlanSeries) -> Figure | None:
    """Rail position, and from where each work point can be reached, at the time it is reached; of several rails the
    axes' own picture tells. Figs 5.2 and 6.4."""
    if series.plant.layout.r != 1:
        return None
    figure = style.new_figure(6.0, "Rail, and from where on it each point is in reach", series.below)
    axes = figure.subplots()
    width = 0.004 * (series.t[-1] - series.t[0])
    ranges = np.empty((0, 2))
    for leg in series.legs:
        X_WF = target_flange(leg)
        if isinstance(leg.motion, Wait):
            for low, high in ranges:  # the point last reached is held
                axes.fill_between([leg.t_0, leg.t_1], low / MM, high / MM, color=style.SKY, alpha=0.25, linewidth=0)
            continue
        ranges = np.empty((0, 2)) if X_WF is None else rail_ranges(series.plant, X_WF)
        for low, high in ranges:
            axes.vlines(leg.t_1, low / MM, high / MM, color=style.SKY, linewidth=3, gid="reach")
            for end in (low, high):
                axes.hlines(end / MM, leg.t_1 - width, leg.t_1 + width, color=style.BLUE, linewidth=2)
        asked = series.plant.rail_value(leg.motion.extax)
        if asked is not None:
            axes.plot(
                leg.t_1,
                asked[0] / MM,
                "x",
                color=style.VERMILLION,
                markersize=8,
                markeredgewidth=2,
                zorder=6,
                clip_on=False,
            )
    axes.plot(
        series.t, series.plant.layout.place(series.q) / MM, color=style.BLACK, linewidth=2.4, zorder=5, gid="rail"
    )
    layout, limits = series.plant.layout, series.plant.limits
    low, high = float(layout.place(limits.lower)) / MM, float(layout.place(limits.upper)) / MM
    style.name_limit(axes, high, f"end of the rail {number(high)} mm")
    style.name_limit(axes, low, f"end of the rail {number(low)} mm", below=True)
    axes.set_ylim(low - 0.09 * (high - low), high + 0.09 * (high - low))
    axes.set_ylabel("rail [mm]")
    axes.set_xlabel(TIME)
    mark_motions(series, [axes])
    handles: list[Line2D | Patch] = [Line2D([], [], color=style.BLACK, linewidth=2.4, label="rail")]
    if any(target_flange(leg) is not None for leg in series.legs):
        told = "rail positions that reach the point"
        handles.append(Line2D([], [], color=style.SKY, linewidth=3, marker="_", markeredgecolor=style.BLUE, label=told))
    if any(series.plant.rail_value(leg.motion.extax) is not None for leg in series.moves):  # type: ignore[union-attr]
        handles.append(Line2D([], [], color=style.VERMILLION, marker="x", linestyle="", label="rail as programmed"))
    key(figure, series, handles)
    return named(series, figure, axes)


def tcp_speed(series: PlanSeries) -> Figure:
    """Speed of the TCP, the speed the program gives each motion, and the plant's cap. Fig. 4.4."""
    figure = style.new_figure(5.4, "Speed of the tool centre point", series.below)
    axes = figure.subplots()
    speed = np.linalg.norm(series.V_WT[:, :3], axis=1) / MM
    cap = series.plant.tcp.speed / MM
    bound = False
    for leg in series.legs:
        value = programmed_speed(series.plant, leg.motion)
        if value is not None:
            bound = True
            axes.plot(
                [leg.t_0, leg.t_1], [min(value / MM, cap)] * 2, color=style.VERMILLION, linewidth=2.2, gid="programmed"
            )
    axes.plot(series.t, speed, color=style.BLUE, gid="speed")
    style.name_limit(axes, cap, f"cap of the tool centre point {number(cap)} mm/s")
    axes.set_ylim(0, 1.1 * max(cap, float(speed.max())))
    axes.set_ylabel("TCP speed [mm/s]")
    axes.set_xlabel(TIME)
    mark_motions(series, [axes])
    handles = [Line2D([], [], color=style.BLUE, label="planned")]
    if bound:
        handles.append(Line2D([], [], color=style.VERMILLION, linewidth=2.2, label="programmed, at most the cap"))
    key(figure, series, handles)
    return named(series, figure, axes)


def effector(series: PlanSeries) -> Figure:
    """Position, speed and orientation of the TCP; on a rail its speed as the carriage sees it, too. Figs 4.5, 6.2, 6.3
    and the three angles."""
    V, cap = series.V_WT[:, :3] / MM, series.plant.tcp.speed / MM
    speeds = [("speed\n[mm/s]", V)]
    if series.plant.robot.has_rail:
        on_carriage = V - series.rail_speed / MM
        speeds = [("speed in the world\n[mm/s]", V), ("speed seen from\nthe carriage [mm/s]", on_carriage)]
    figure = style.new_figure(5.6 + 2.4 * len(speeds), "Tool centre point: position, speed, orientation", series.below)
    grid = figure.subplots(2 + len(speeds), 1, sharex=True)
    draw_xyz(grid[0], series.t, series.X_WT[:, :3, 3] / MM)
    grid[0].set_ylabel("position\n[mm]")
    for axes, (label, values) in zip(grid[1:-1], speeds, strict=True):
        draw_xyz(axes, series.t, values)
        axes.axhline(0, color=style.GREY, linewidth=0.7)
        axes.set_ylabel(label)
    reach = 1.12 * max(float(np.abs(V).max()), 0.0)
    if 1.3 * reach > cap:  # else the curves would be thin lines between two caps
        for limit in (-cap, cap):
            grid[1].axhline(limit, **style.LIMIT)
        grid[1].set_ylim(-1.15 * cap, 1.15 * cap)
    draw_xyz(grid[-1], series.t, angles(series.X_WT) / DEG)
    grid[-1].set_ylabel("orientation\n[deg]")
    low, high = grid[-1].get_ylim()
    if high - low < _LEAST_TURN:
        grid[-1].set_ylim((low + high - _LEAST_TURN) / 2, (low + high + _LEAST_TURN) / 2)
    for axes in grid:
        axes.yaxis.set_major_locator(MaxNLocator(5, steps=style.ROUND))
    grid[-1].legend(
        handles=xyz_handles(("turned about x", "then about the new y", "then about the new z")),
        loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.1, ncols=3, columnspacing=1.6, handlelength=2.6,
    )  # fmt: skip
    grid[-1].set_xlabel(TIME)
    mark_motions(series, grid)
    capped = [Line2D([], [], **style.LIMIT, label=f"cap {number(cap)} mm/s")] if 1.3 * reach > cap else []  # type: ignore[arg-type]
    key(figure, series, [*xyz_handles(("along x", "along y", "along z")), *capped])
    return named(series, figure, grid[0])


def draw_xyz(axes: Axes, t: Array, values: Array) -> None:
    """Three curves (n, 3) over t (n,) in the styles of x, y and z."""
    for i, (color, line) in enumerate(style.AXIS_STYLES):
        axes.plot(t, values[:, i], color=color, linestyle=line)


def xyz_handles(labels: tuple[str, str, str] = ("x", "y", "z")) -> list[Line2D]:
    """What the legend shows for draw_xyz."""
    return [Line2D([], [], color=c, linestyle=s, label=n) for n, (c, s) in zip(labels, style.AXIS_STYLES, strict=True)]


def number(value: float) -> str:
    """Four figures, and the minus sign that the ticks have."""
    return f"{value:.4g}".replace("-", "−")


def whole(value: float) -> str:
    """The nearest whole number; of a small one three figures."""
    return f"{value:.0f}".replace("-", "−") if abs(value) >= 100 else f"{value:.3g}".replace("-", "−")


def key(figure: Figure, series: PlanSeries, handles: list[Line2D] | list[Line2D | Patch]) -> None:
    """The legend in one row under the picture; with the waits and the points passed where there are any."""
    more: list[Line2D | Patch] = [WAIT] if any(isinstance(leg.motion, Wait) for leg in series.legs) else []
    legend(figure, [*handles, *more, *([PASSED] if series.passed.any() else [])])


def legend(figure: Figure, entries: Sequence[Line2D | Patch]) -> None:
    """The entries under the picture, in as few rows as the page is wide."""
    figure.legend(
        handles=entries, loc="outside lower center", ncols=columns(entries), columnspacing=1.6, handlelength=2.6
    )


def columns(entries: Sequence[Line2D | Patch]) -> int:
    """How many entries of a legend stand beside each other."""
    wide = [0.75 + 0.093 * len(str(entry.get_label())) for entry in entries]  # in
    rows = 1
    while (
        max(wide) * -(-len(wide) // rows) > style.WIDTH - 0.4
        and sum(wide) > (style.WIDTH - 0.4) * rows
        and rows < len(wide)
    ):
        rows += 1
    return -(-len(wide) // rows)


def named(series: PlanSeries, figure: Figure, top: Axes) -> Figure:
    """The settled figure with the targets' names over its top panel."""
    return with_names(figure, top, [(leg.t_1, leg.name) for leg in series.moves])


def with_names(figure: Figure, top: Axes, ends: Sequence[tuple[float, str]]) -> Figure:
    """The settled figure with a name per (time [s], name) over its top panel."""
    names = name_times(top, ends)
    figure.align_ylabels()
    style.settle(figure)
    spread(names)
    return figure


def mark_motions(series: PlanSeries, panels: Iterable[Axes]) -> None:
    """Light vertical lines where a move ends, dotted where it does not stop there; bands where the program waits, the
    time axis from 0 to the end."""
    waits = [(leg.t_0, leg.t_1 - leg.t_0) for leg in series.legs if isinstance(leg.motion, Wait)]
    stops, passed = ([leg.t_1 for leg in series.moves if leg.passed == moving] for moving in (False, True))
    mark_times(panels, float(series.t[-1]), stops, waits, WAIT, passed)


def mark_times(
    panels: Iterable[Axes], end: float, stops: Sequence[float], spans: Sequence[tuple[float, float]], band: Patch,
    passed: Sequence[float] = (),
) -> None:  # fmt: skip
    """Light vertical lines at stops [s], dotted ones where points are passed, bands of band's look over spans
    (start, length) [s], time from 0 to end."""
    for axes in panels:
        axes.set_xlim(0, end)
        axes.set_axisbelow(True)
        whole_height = axes.get_xaxis_transform()
        inner = [stop for stop in stops if stop < end]
        axes.vlines(inner, 0, 1, transform=whole_height, **_LINE, zorder=0.6)
        if passed:
            axes.vlines(passed, 0, 1, transform=whole_height, **_PASSED, zorder=0.6, gid="passed")
        axes.broken_barh(
            spans, (0, 1), transform=whole_height, facecolor=band.get_facecolor(), linewidth=0, zorder=0.5, gid="band"
        )
