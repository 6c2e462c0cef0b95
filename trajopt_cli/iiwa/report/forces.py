"""Forces and what the controller makes of them: steps, hand guiding, zeroing, contact. Graf 6.2 to 6.9 and 6.18."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, FigureBase, SubFigure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.follow import (
    COORDINATES,
    FORCE_UNITS,
    MOVES,
    POSE_UNITS,
    Following,
    component_handles,
    components,
    curve,
    finish,
    mark_peak,
    number_of,
    room_around,
    zero_line,
)
from trajopt_cli.iiwa.report.page import thinned
from trajopt_cli.report.over_time import TIME, legend
from trajopt_cli.report.style import AXIS_STYLES, BLACK, GREY, JOINT_STYLES, PALE, PURPLE, SMALL, new_figure
from trajopt_cli.units import MM

_FLAT = 0.02  # of the longest side: a coordinate that moves less is not worth a third dimension
_LEAST = 0.12  # of the longest side: no side of the box is shorter

# A path in space (n, 3) [m], how it is drawn, and what it is called in the file.
Path3D = tuple[Array, dict[str, Any], str]


def draw_paths(figure: FigureBase, paths: Sequence[Path3D]) -> None:
    """Paths to one scale, start and end of the first one marked: in the plane of two coordinates where the third hardly
    moves, else in a box."""
    low = np.min([points.min(axis=0) for points, _, _ in paths], axis=0) / MM
    high = np.max([points.max(axis=0) for points, _, _ in paths], axis=0) / MM
    span, middle = high - low, (low + high) / 2
    longest = max(float(span.max()), MOVES / MM)
    half = np.maximum(1.1 * span, _LEAST * longest) / 2
    order = np.argsort(-span, kind="stable")
    flat = bool(span[order[2]] < _FLAT * longest)
    shown = sorted(order[:2].tolist()) if flat else [0, 1, 2]
    axes: Any = figure.add_subplot() if flat else figure.add_subplot(projection="3d", computed_zorder=False)
    for points, style, gid in paths:
        along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        axes.plot(*(points[thinned(points, along)][:, shown] / MM).T, gid=gid, solid_joinstyle="round", **style)
    for i, which in zip(shown, "xyz", strict=False):
        getattr(axes, f"set_{which}lim")(middle[i] - half[i], middle[i] + half[i])
        getattr(axes, f"set_{which}label")(f"{'xyz'[i]} [mm]")
    if flat:
        axes.set_aspect("equal")
        axes.grid(color="#dedede", linewidth=0.8)
        axes.set_axisbelow(True)
    else:
        axes.set_box_aspect(half, zoom=0.9)
        axes.tick_params(labelsize=SMALL - 1)
        axes.locator_params(nbins=5)
    ends = paths[0][0][[0, -1]][:, shown] / MM
    same = float(np.linalg.norm(ends[1] - ends[0])) < 0.01 * longest
    for place, name in zip(ends, ["start and end"] if same else ["start", "end"], strict=False):
        axes.plot(*place[:, None], "o", color=GREY, markerfacecolor="white", gid=name, zorder=6)
        axes.text(*place, f"  {name}", size=SMALL, zorder=6)


_ACTS = 1e-9  # N: less is no force
_ELSE: dict[str, Any] = {"color": "#a9a9a9", "linewidth": 1.3}
_UNDER: dict[str, Any] = {"linewidth": 5.5, "alpha": 0.3}  # the flange under the controller, in the coordinate's colour
_FREE: dict[str, Any] = {"color": PURPLE, "linewidth": 1.6, "linestyle": (0, (7, 3))}


def steps_figure(panels: Sequence[tuple[str, Following]], coordinates: Sequence[int], title: str) -> Figure:
    """Forces above, how far the controller goes from its first equilibrium below; one column per set of parameters."""
    groups = [[i for i in coordinates if i < 3], [i for i in coordinates if i >= 3]]
    kinds = [(what, group) for what in ("force", "pose") for group in groups if group]
    figure = new_figure(2.0 + 2.6 * len(kinds), title)
    grid = figure.subplots(len(kinds), len(panels), sharex=True, sharey="row", squeeze=False)
    for row, (what, group) in zip(grid, kinds, strict=True):
        factor, unit = (FORCE_UNITS if what == "force" else POSE_UNITS)[group[0]]
        drawn: list[Array] = []
        for axes, (label, run) in zip(row, panels, strict=True):
            zero_line(axes)
            values = _force(run) if what == "force" else run.x - run.x_e[0]
            if what == "pose" and run.true is not None:
                away = run.true - run.x_e[0]
                for i in group:
                    style = {"color": AXIS_STYLES[i % 3][0], **_UNDER}
                    curve(axes, run.t, away[:, i] / factor, f"flange {COORDINATES[i]}", **style)
                drawn.append(away[:, group] / factor)
            components(axes, run.t, values, group, factor, what)
            drawn.append(values[:, group] / factor)
            if what == "pose":
                most = max(group, key=lambda i: float(np.abs(values[:, i]).max()))
                mark_peak(axes, run.t, values[:, most] / factor, unit)
            if what == kinds[0][0] and group is kinds[0][1]:
                axes.set_title(label, size=SMALL + 1.5, loc="left")
        room_around(row[0], drawn, 1e-6)
        turns = group[0] >= 3
        named = ("torque" if turns else "force") if what == "force" else ("turn" if turns else "displacement")
        row[0].set_ylabel(f"{named} [{unit}]")
    for axes in grid[-1]:
        axes.set_xlabel(TIME)
    handles = component_handles(coordinates)
    if any(run.true is not None for _, run in panels):
        handles.append(Line2D([], [], color=GREY, **_UNDER, label="flange (pale, under the controller)"))
    legend(figure, handles)
    return finish(figure)


def guided_figure(run: Following, phases: Sequence[tuple[str, float, float]], title: str) -> Figure:
    """Forces x, y, z of a hand above, the path it led the tool along below; both in the colours of phases (name, from,
    to [s])."""
    force, path = _force(run), run.flange[:, :3]
    length = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
    figure, grid, space = _forces_over_path(3, title, f"{run.label} · {number_of(length / MM)} mm led by hand", run)
    paths = [(path, _ELSE, "else")]
    handles: list[Line2D] = []
    for i, axes in enumerate(grid):
        curve(axes, run.t, force[:, i], f"force {COORDINATES[i]}", **_ELSE)
        axes.set_ylabel(f"force {COORDINATES[i]}\n[N]")
    for (name, begin, end), (color, line) in zip(phases, JOINT_STYLES[1 : 1 + len(phases)], strict=True):
        during = (run.t >= begin) & (run.t <= end)
        style = {"color": color, "linestyle": line, "linewidth": 2.2}
        for i, axes in enumerate(grid):
            curve(axes, run.t[during], force[during, i], f"{name} {COORDINATES[i]}", **style)
        paths.append((path[during], style, name))
        handles.append(Line2D([], [], **style, label=name))  # type: ignore[arg-type]
    room_around(grid[0], [force[:, :3]], 1e-6)
    draw_paths(space, paths)
    legend(figure, [*handles, Line2D([], [], **_ELSE, label="between")])
    return finish(figure)


def zeroing_figure(run: Following, unzeroed: Array, free: Array, title: str) -> Figure:
    """Forces (n, 6) before and after zeroing above, the path and the axis (3,) that is left free below."""
    before, after = unzeroed, _force(run)
    free = free / float(np.linalg.norm(free))
    path = run.flange[:, :3]
    along = (path - path[0]) @ free
    most = float(np.linalg.norm(path - path[0] - along[:, None] * free, axis=1).max()) / MM
    reach = max(float(np.ptp(along)), 1e-3)
    line = path[0] + np.outer([along.min() - 0.25 * reach, along.max() + 0.25 * reach], free)
    direction = ", ".join(f"{value:.3f}".replace("-", "−") for value in free)
    far = f"{number_of(most)} mm" if most >= 1e-3 else "less than 0.001 mm"
    text = f"free along ({direction}) · the path leaves that axis by {far}"
    figure, grid, space = _forces_over_path(2, title, text, run)
    for axes, force, name in zip(grid, (before, after), ("before", "after"), strict=True):
        components(axes, run.t, force, (0, 1, 2), 1.0, name)
        axes.set_ylabel(f"force {name}\nzeroing [N]")
    room_around(grid[0], [before[:, :3], after[:, :3]], 1e-6)
    style = {"color": BLACK, "linewidth": 3.4}
    draw_paths(space, [(path, style, "path"), (line, _FREE, "axis")])
    handles = [Line2D([], [], **style, label="path"), Line2D([], [], **_FREE, label="axis left free")]  # type: ignore[arg-type]
    legend(figure, [*component_handles((0, 1, 2)), *handles])
    return finish(figure)


def contact_figure(run: Following, depth: Array, axis: int, title: str) -> Figure:
    """Planned, controller's and flange's coordinate along an axis, the force along it, and that across it if any; in
    contact where depth (n,) [m] is over 0. Needs a force."""
    inside = np.asarray(depth > 0)
    force, sign = _force(run), COORDINATES[axis]
    across = [i for i in range(3) if i != axis and float(np.abs(force[:, i]).max()) > _ACTS]
    deepest = f" · deepest {number_of(float(np.max(depth)) / MM)} mm" if inside.any() else " · no contact"
    figure = new_figure(7.0 + (2.0 if across else 0.0), title, run.label + deepest)
    rows = 3 if across else 2
    grid = figure.subplots(rows, 1, sharex=True, height_ratios=[1.5, 1.1, 0.8][:rows])
    for name, x, style in run.shown:
        curve(grid[0], run.t, x[:, axis] / MM, name, **style)
    room_around(grid[0], [x[:, axis] / MM for _, x, _ in run.shown], 1e-3)
    grid[0].set_ylabel(f"{sign} [mm]")
    # what the contact pushed away, not the lag before it; without a contact the lag is all there is
    away = (run.flange - run.x_e)[:, axis] * (inside if inside.any() else 1.0)
    if float(np.abs(away).max()) > MOVES:
        planned = run.x_e[:, axis] / MM
        mark_peak(grid[0], run.t, away / MM, "mm", " from the plan", planned)
    handles: list[Line2D | Patch] = [Line2D([], [], **style) for _, _, style in run.shown]
    zero_line(grid[1])
    curve(grid[1], run.t, force[:, axis], "force", color=BLACK)
    room_around(grid[1], [force[:, axis], np.zeros(1)], 1e-6)
    grid[1].set_ylabel(f"force on the tool\nalong {sign} [N]")
    if float(np.abs(force[:, axis]).max()) > _ACTS:
        mark_peak(grid[1], run.t, force[:, axis], "N")
    if across:
        zero_line(grid[2])
        components(grid[2], run.t, force, across, 1.0, "along")
        room_around(grid[2], [force[:, across], np.zeros(1)], 1e-6)
        grid[2].set_ylabel("across it [N]")
        signs = [AXIS_STYLES[i] for i in across]
        handles += [
            Line2D([], [], color=color, linestyle=line, label=f"force along {COORDINATES[i]}")
            for i, (color, line) in zip(across, signs, strict=True)
        ]
    for axes in grid:
        if inside.any():
            axes.fill_between(
                run.t, 0, 1, where=inside, transform=axes.get_xaxis_transform(), color=PALE, linewidth=0, zorder=0.5,
                gid="contact",
            )  # fmt: skip
        axes.yaxis.set_major_locator(MaxNLocator(5))
    if inside.any():
        handles.append(Patch(color=PALE, linewidth=0, label="in contact"))
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    legend(figure, handles)
    return finish(figure)


def _forces_over_path(rows: int, title: str, below: str, run: Following) -> tuple[Figure, Sequence[Axes], SubFigure]:
    """A figure with rows of forces over time, and the place of a path under them."""
    tall = 1.4 * rows + 0.7
    figure = new_figure(tall + 6.6, title, below)
    halves = figure.add_gridspec(2, 1, height_ratios=[tall, 5.6])
    above, space = (figure.add_subfigure(half) for half in (halves[0], halves[1]))
    grid = above.subplots(rows, 1, sharex=True, sharey=True)
    for axes in grid:
        zero_line(axes)
        axes.yaxis.set_major_locator(MaxNLocator(4))
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    return figure, grid, space


def _force(run: Following) -> Array:
    if run.force is None:
        raise ValueError(f"Following {run.label} has no force to draw")
    return run.force
