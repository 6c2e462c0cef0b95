"""Pictures in space: the TCP's path, and the arm's workspace."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon
from matplotlib.ticker import MaxNLocator

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.motion import MoveL, PathMove, Wait
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.workspace import sections
from trajopt_cli.report import obstacles, style
from trajopt_cli.report.names import by_place, name_places
from trajopt_cli.report.over_time import legend
from trajopt_cli.report.skeleton import reach_section
from trajopt_cli.robot.parallel_arm import ParallelArm
from trajopt_cli.scene import rail_ends
from trajopt_cli.trajectories.plan_series import PlanSeries, TimedMotion
from trajopt_cli.units import MM

# How the path looks in lines and arcs (the thesis' functional parts), elsewhere, where only the rail moves, in corners.
KINDS: dict[str, dict[str, Any]] = {
    "line": {"color": style.VERMILLION, "linewidth": 3.4, "label": "lines (MoveL)"},
    "arc": {"color": style.PURPLE, "linewidth": 3.4, "label": "arcs (MoveC)"},
    "free": {"color": style.BLUE, "linewidth": 1.4, "label": "free moves"},
    "wait": {"color": style.GREY, "linewidth": 2.0, "linestyle": (0, (1.5, 1.2)), "label": "waits"},
    "corner": {"color": style.GREEN, "linewidth": 2.4, "linestyle": (0, (2.5, 0.7)), "label": "in zones (fly-by)"},
}
# A point where the plan stops, and one that it passes.
STOP: dict[str, Any] = {"marker": "o", "linestyle": "", "color": style.BLACK, "markersize": 4.5}
PASSED: dict[str, Any] = {**STOP, "markerfacecolor": "white", "markersize": 5.5}
# The same of points that the plan has added.
ADDED: dict[str, Any] = {"marker": "D", "color": style.VERMILLION}
SAME = 5e-3  # m: points nearer than this share a name tag
STANDS = 1e-6  # m: no way to show
_NAMES = "xyz"
WORLD, CARRIAGE = "in the world", "seen from the carriage"
_RAIL: dict[str, Any] = {"color": "#c8c8c8", "linewidth": 9, "solid_capstyle": "butt", "zorder": 0.8}
_CARRIAGE: dict[str, Any] = {"color": "#a8a8a8", "marker": "s", "markersize": 13, "linestyle": "", "zorder": 0.8}
_RAIL_LABEL = Line2D([], [], **_RAIL, label="rail")
_CARRIAGE_LABEL = Line2D([], [], **_CARRIAGE, label="carriage")
_ARROW: dict[str, Any] = {"arrowstyle": "-|>", "color": style.BLACK, "linewidth": 0, "shrinkA": 0, "shrinkB": 0}
_POINT = 25.0  # px: a path that is no longer has nothing to show
_ARROWS_FROM, _ARROWS_EVERY = 20.0, 260.0  # px


@dataclass(frozen=True, eq=False)
class Space:
    """What a path is drawn in: its name, the path (n, 3), the places of the program's points (m, 3), and what the arm
    stands on (k, 3): both ends of each rail, the carriage alone, or nothing (k = 0), all in m. bodies: clouds of points
    (n, 3) whose hulls stand there."""

    name: str
    path: Array
    places: Array
    ground: Array
    bodies: Sequence[Array] = ()


def path(series: PlanSeries) -> Figure:
    """The TCP's path from the side and from above, in the real space and as the carriage sees it. Figs 4.3 and 4.6.

    Relative to the carriage ("deformed" in the thesis) means: minus the rail's travel, so both agree at rail 0.
    """
    points, plant, places = series.X_WT[:, :3, 3], series.plant, series.points
    spaces = [Space(WORLD, points, np.vstack([points[:1], places]), rail_ends(plant), obstacles.clouds(plant))]
    if plant.robot.has_rail:
        seen = points - series.rail
        spaces.append(Space(CARRIAGE, seen, np.vstack([seen[:1], places - _carried(series)]), carriage(plant)))
    return path_figure(
        "Path of the tool centre point",
        series.below,
        spaces,
        ["start", *(leg.name for leg in series.moves)],
        _parts(series),
        [series.at(leg.t_1) for leg in series.moves],
        along_page(plant, points),
        passed=np.r_[False, series.passed],
        added=np.r_[False, series.added],
    )


def carriage(plant: Plant) -> Array:
    """Where the arm's base is with the rail at 0 (1, 3) [m]; (0, 3) without a rail."""
    return plant.robot.X_WB0[None, :3, 3] if plant.robot.has_rail else np.empty((0, 3))


def _carried(series: PlanSeries) -> Array:
    """Where the carriage stands at the points that the moves lead to (m, 3) [m], from the rail's 0."""
    return np.array([series.plant.robot.way_at(leg.q_1) for leg in series.moves]).reshape(-1, 3)


def _parts(series: PlanSeries) -> list[tuple[slice, str]]:
    """Samples and how they are drawn: every leg, but for what of it lies in a corner; the corners."""
    out = [(corner, "corner") for corner in series.corners]
    for leg in series.legs:
        own = series.during(leg)
        first = max((c.stop - 1 for c in series.corners if c.start < own.start < c.stop), default=own.start)
        last = min((c.start + 1 for c in series.corners if c.start < own.stop < c.stop), default=own.stop)
        if first < last:
            out.append((slice(first, last), _kind(leg)))
    return out


def _kind(leg: TimedMotion) -> str:
    match leg.motion:
        case MoveL():
            return "line"
        case PathMove():
            return "arc"
        case Wait():
            return "wait"
    return "free"


def path_figure(
    heading: str,
    below: str,
    spaces: list[Space],
    names: list[str],
    parts: list[tuple[slice, str]],
    ends: list[int],
    along: int,
    kinds: dict[str, dict[str, Any]] = KINDS,
    passed: BoolArray | None = None,
    added: BoolArray | None = None,
) -> Figure:
    """Spaces side by side, each seen from the side and from above, all to one scale, with arrows along the way.

    names: of the places (m). parts: samples and the key of kinds they are drawn in. ends: the samples where ways end.
    along: the world axis across the page. passed, added: which of the places are passed, and which of them no program
    has (m,); none if not given. One space alone has its two views side by side, or one below the other where that shows
    it larger. A view in which the path is a point is left out.
    """
    passed, added = (np.zeros(len(names), dtype=bool) if which is None else which for which in (passed, added))
    looks = [(which & ~added, look) for which, look in ((~passed, STOP), (passed, PASSED))]
    looks += [(which & added, look | ADDED) for which, look in ((~passed, STOP), (passed, PASSED))]
    across = 1 - along
    views = [[(i, up) for i in range(len(spaces))] for up in (2, across)]
    shown = [np.vstack([space.path, space.places, space.ground]) for space in spaces]
    if len(spaces) == 1 and np.ptp(shown[0][:, along]) < 1.5 * max(np.ptp(shown[0][:, [2, across]], axis=0)):
        views = [[(0, 2), (0, across)]]
    spans = [np.ptp(points, axis=0) for points in shown]
    room = 0.08 * max(float(span.max()) for span in spans) + 0.02  # m for names at every side
    wide = [spans[i][along] + 2 * room for i, _ in views[0]]
    wide = [max(width, 0.7 * max(wide)) for width in wide]  # a narrow space has as many names
    # Where all is in one plane names need room, too.
    least = min(1.7 + 0.08 * len(set(names)), 3.2) * sum(wide) / 9.4  # m
    tall = [max(least, *(spans[i][up] + 2 * room for i, up in row)) for row in views]
    scale = min(9.4 / sum(wide), 7.4 / sum(tall))  # in per m
    figure = style.new_figure(1.6 + scale * sum(tall) + 0.75 * len(tall), heading, below)
    grid = figure.subplots(*np.shape(views)[:2], width_ratios=wide, height_ratios=tall, squeeze=False)
    for panels, row, height in zip(grid, views, tall, strict=True):
        for axes, (i, up), width in zip(panels, row, wide, strict=True):
            space, plane = spaces[i], [along, up]
            for cloud in space.bodies:
                corners = obstacles.seen(cloud, plane) / MM
                for look in (obstacles.FACE, obstacles.EDGE):
                    axes.add_patch(Polygon(corners, zorder=0.5, gid="obstacle", **look))
            look, count = (_RAIL, 2) if len(space.ground) > 1 else (_CARRIAGE, 1)
            for beam in space.ground.reshape(-1, count, 3):  # between two places, or a block at one
                axes.plot(*beam[:, plane].T / MM, **look, gid="ground")
            for part, kind in parts:
                axes.plot(*space.path[part][:, plane].T / MM, **kinds[kind], solid_capstyle="round", gid=kind)
            for which, look in looks:
                axes.plot(*space.places[which][:, plane].T / MM, **look, zorder=4)
            middle = (shown[i].max(axis=0) + shown[i].min(axis=0)) / 2
            axes.set_xlim((middle[along] - width / 2) / MM, (middle[along] + width / 2) / MM)
            axes.set_ylim((middle[up] - height / 2) / MM, (middle[up] + height / 2) / MM)
            axes.set_aspect("equal")
            axes.xaxis.set_major_locator(MaxNLocator(max(4, round(0.9 * scale * width)), steps=style.ROUND))
            axes.yaxis.set_major_locator(MaxNLocator(max(4, round(1.4 * scale * height)), steps=style.ROUND))
            axes.set_xlabel(f"{_NAMES[along]} [mm]")
            axes.set_ylabel(f"{_NAMES[up]} [mm]")
            axes.set_title(
                f"{space.name}, {'side view' if up == 2 else 'from above'}", size=style.SMALL + 0.5, loc="left"
            )
    used = {kind for part, kind in parts if any(np.ptp(one.path[part], axis=0).max() > STANDS for one in spaces)}
    handles: list[Line2D | Patch] = [Line2D([], [], **look) for kind, look in kinds.items() if kind in used]
    if passed.any():
        handles += [Line2D([], [], **STOP, label="stop"), Line2D([], [], **PASSED, label="passed")]
    if added.any():
        handles.append(Line2D([], [], **STOP | ADDED, label="added on a way around obstacles"))
    handles += [_RAIL_LABEL, _CARRIAGE_LABEL] if len(spaces[0].ground) else []
    handles += [obstacles.LABEL] if spaces[0].bodies else []
    legend(figure, handles)
    style.settle(figure)
    for axes, (i, up) in zip(grid.flat, (view for row in views for view in row), strict=True):
        plane = [along, up]
        curve = spaces[i].path[:, plane] / MM
        if np.ptp(axes.transData.transform(curve), axis=0).max() < _POINT:
            axes.remove()  # seen along the only way there is: a point
            continue
        draw_arrows(axes, curve, ends)
        places, told = by_place(spaces[i].places[:, plane], names, SAME)
        name_places(axes, places / MM, told, np.vstack([_dense(curve), _filled(spaces[i].ground[:, plane] / MM)]))
    return figure


def _filled(ground: Array) -> Array:
    """Points (n, 2) on what the arm stands on, for names to keep away from."""
    if len(ground) > 1:
        begins, ends = ground[0::2], ground[1::2]
        return np.asarray(begins + np.linspace(0, 1, 200)[:, None, None] * (ends - begins)).reshape(-1, 2)
    return np.vstack([ground + np.array(corner) for corner in product((-40.0, 0.0, 40.0), repeat=2)])  # mm


def draw_arrows(axes: Axes, curve: Array, ends: Sequence[int]) -> None:
    """Arrow heads along a curve (n, 2) in data units of a settled figure: one on every way from one sample of ends to
    the next, beyond its middle, so that ways there and back show both; more on long ways, fewer where ways are short.
    """
    pixels = np.asarray(axes.transData.transform(curve))
    run = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(pixels, axis=0), axis=1))]
    low = before = 0.0
    for high in (*run[list(ends)], run[-1]):
        own, before = high - before, high
        if own < _ARROWS_FROM and high - low < 4 * _ARROWS_FROM:
            continue  # with the next way together
        count = 1 + int((high - low) // _ARROWS_EVERY)
        for k in range(count):
            middle = low + (high - low) * (k + 0.7) / count
            tail, tip = (np.array([np.interp(middle + d, run, column) for column in curve.T]) for d in (-4.0, 4.0))
            if np.linalg.norm(np.subtract(*axes.transData.transform([tail, tip]))) > 4.0:  # no way back within it
                look = _ARROW | {"mutation_scale": 15 if high - low > 2 * _ARROWS_FROM else 10}
                axes.annotate("", tuple(tip), tuple(tail), arrowprops=look, zorder=5, gid="direction")
        low = high


def along_page(plant: Plant, points: Array) -> int:
    """The world axis drawn across the page: 0 or 1, the one that rails go far along, else the one the path runs
    along."""
    stroke = (plant.limits.upper - plant.limits.lower)[plant.layout.rail]
    reach = np.abs(plant.robot.rail_axes_W.T) @ stroke
    return int(np.argmax((reach if max(reach[:2]) > reach[2] else np.ptp(points, axis=0))[:2]))


def _dense(curve: Array, count: int = 600) -> Array:
    """Points a name should not cover, thinned evenly."""
    return curve[:: max(len(curve) // count, 1)]


def workspace(series: PlanSeries) -> Figure:
    """What the wrist centre can reach in the arm's own plane, and where this plan takes it. Fig. 5.1."""
    what = "axis 4" if isinstance(series.plant.robot.arm, ParallelArm) else "the wrist centre"
    figure = style.new_figure(8.6, f"Workspace of {what} in the arm's own plane", series.below)
    axes = figure.subplots()
    outlines = sections(series.plant)
    elbows = zip(outlines, (style.GREY, style.GREEN), ("-", (0, (5, 2))), strict=False)
    for outline, color, line in elbows:
        axes.fill(*outline.T / MM, color=color, alpha=0.08, linewidth=0)
        axes.plot(*outline.T / MM, color=color, linestyle=line, linewidth=1.6)
    wrist = reach_section(series.plant, series.q)
    axes.plot(*wrist.T / MM, color=style.BLUE, linewidth=2.2, gid="wrist")
    ends = np.vstack([np.empty((0, 2)), *(reach_section(series.plant, leg.q_1[None]) for leg in series.moves)])
    for passed, look in ((False, STOP), (True, PASSED)):
        axes.plot(*ends[series.passed == passed].T / MM, **look, zorder=4)
    arm = series.plant.robot.arm
    base = np.array([[0, 0], [0, arm.c1], [arm.a1, arm.c1]])
    t2 = arm.angles(series.q[0, series.plant.layout.arm])[1]
    knee = base[2] + arm.c2 * np.array([np.sin(t2), np.cos(t2)])
    chain = np.vstack([base, knee, wrist[0]])
    axes.plot(*chain.T / MM, "-o", color="#b0b0b0", linewidth=5, solid_capstyle="round", zorder=1, markersize=7)
    axes.set_aspect("equal")
    axes.xaxis.set_major_locator(MaxNLocator(9, steps=style.ROUND))
    axes.set_xlabel("ahead of axis 1 [mm]")
    axes.set_ylabel("above the base [mm]")
    handles = [
        Line2D([], [], color=style.GREY, label="reach, elbow up"),
        *[Line2D([], [], color=style.GREEN, linestyle=(0, (5, 2)), label="reach, elbow turned over")]
        * (len(outlines) > 1),
        Line2D([], [], color=style.BLUE, linewidth=2.2, label="this plan"),
        Line2D([], [], color="#b0b0b0", linewidth=5, label="arm at the start"),
    ]
    if series.passed.any():
        handles.append(Line2D([], [], **PASSED, label="point passed"))
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles), columnspacing=1.4)
    # Equal scales leave room at the sides of the page: names stand in it, right of the outline.
    low, high = axes.get_xlim()
    axes.set_xlim(low, high + 0.17 * (high - low))
    style.settle(figure)
    kept, names = by_place(ends, [leg.name for leg in series.moves], 2 * SAME)
    name_places(axes, kept / MM, names, np.vstack([_dense(wrist), *outlines]) / MM)
    return figure
