"""Forces and what the controller makes of them: steps, hand guiding, zeroing, contact. Graf 6.2 to 6.9 and 6.18."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import (
    ACTS,
    CONTROLLER,
    COORDINATES,
    FLANGE,
    FORCE_UNITS,
    MOVES,
    PLANNED,
    POSE_UNITS,
    Following,
    Marks,
    bands,
    component_handles,
    components,
    curve,
    finish,
    intervals,
    looked_at,
    number_of,
    peak,
    quiet_zero,
    room_around,
)
from trajopt_cli.iiwa.report.space import View, Way, draw_ways, ends
from trajopt_cli.report.over_time import TIME, legend
from trajopt_cli.report.style import (
    AXIS_STYLES,
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PALE,
    PURPLE,
    SMALL,
    VERMILLION,
    WIDTH,
    LineStyle,
    new_figure,
)
from trajopt_cli.units import MM

# Phases of hand guiding; the thesis has red, green and blue for x, y and z.
_PHASES: tuple[tuple[str, LineStyle], ...] = (
    (VERMILLION, "-"),
    (BLUE, (0, (6, 1.2))),
    (GREEN, (0, (2, 0.9))),
    (PURPLE, "-"),
    (ORANGE, (0, (6, 1.2, 1.5, 1.2))),
)
# Forces across a contact: told apart from controller and flange above them.
_ACROSS: tuple[tuple[str, LineStyle], ...] = ((GREEN, "-"), (PURPLE, (0, (5, 1.5))))
_ELSE = "#a9a9a9"
_UNDER: dict[str, Any] = {"linewidth": 5.5, "alpha": 0.3}  # the flange under the controller, in the coordinate's colour


def steps_figure(panels: Sequence[tuple[str, Following]], coordinates: Sequence[int], title: str) -> Figure:
    """Forces above, how far the controller goes from its first equilibrium below; one column per set of parameters."""
    if not panels or not coordinates or not set(coordinates) <= set(range(6)):
        raise ValueError(f"steps needs panels and coordinates 0 to 5, not {len(panels)} and {list(coordinates)}")
    groups = [[i for i in coordinates if i < 3], [i for i in coordinates if i >= 3]]
    kinds = [(what, group) for what in ("force", "pose") for group in groups if group]
    figure = new_figure(2.0 + 2.6 * len(kinds), title, "")
    grid = figure.subplots(len(kinds), len(panels), sharex=True, sharey="row", squeeze=False)
    marks: list[tuple[Axes, Marks]] = []
    flange = any(run.true is not None for _, run in panels)
    for row, (what, group) in zip(grid, kinds, strict=True):
        factor, unit = (FORCE_UNITS if what == "force" else POSE_UNITS)[group[0]]
        drawn: list[Array] = []
        for axes, (_, run) in zip(row, panels, strict=True):
            quiet_zero(axes)
            if what == "force":
                values = _force(run)
            else:
                values = run.x - run.x_e[0]
                if run.true is not None:
                    away = run.true - run.x_e[0]
                    for i in group:
                        curve(
                            axes, run.t, away[:, i] / factor, f"flange {COORDINATES[i]}", color=AXIS_STYLES[i % 3][0],
                            **_UNDER,
                        )  # fmt: skip
                    drawn.append(away[:, group] / factor)
            components(axes, run.t, values, group, factor, what)
            drawn.append(values[:, group] / factor)
            most = max(group, key=lambda i: float(np.abs(values[:, i]).max()))
            if what == "pose":
                marks.append((axes, [peak(run.t, values[:, most] / factor, unit)]))
        room_around(row[0], drawn, 1e-6, 0.16)
        rotation = group[0] >= 3
        named = ("torque" if rotation else "force") if what == "force" else ("turn" if rotation else "displacement")
        row[0].set_ylabel(f"{named} [{unit}]")
    for axes, (label, _) in zip(grid[0], panels, strict=True):
        axes.set_title(label, size=SMALL + 1.5, loc="left")
    for axes in grid[-1]:
        axes.set_xlabel(TIME)
    grid[0, 0].set_xlim(min(run.t[0] for _, run in panels), max(run.t[-1] for _, run in panels))
    handles = component_handles(coordinates)
    if flange:
        handles.append(Line2D([], [], color=GREY, **_UNDER, label="flange (pale, under the controller)"))
    legend(figure, handles)
    return finish(figure, marks)


def guided_figure(run: Following, phases: Sequence[tuple[str, float, float]], title: str) -> Figure:
    """Forces x, y, z of a hand above, the path it led the tool along below; both in the colours of the phases."""
    force = _force(run)
    if not 1 <= len(phases) <= len(_PHASES):
        raise ValueError(f"guided tells 1 to {len(_PHASES)} phases apart, not {len(phases)}")
    path = run.flange[:, :3]
    view = View([path])
    tall = view.height(WIDTH - 3.0, 5.0)
    figure = new_figure(1.7 + 3 * 1.15 + tall, title, f"{run.label} · {number_of(_length(path) / MM)} mm led by hand")
    halves = figure.add_gridspec(2, 1, height_ratios=[3 * 1.15 + 0.7, tall + 0.3])
    above, below = (figure.add_subfigure(half) for half in (halves[0], halves[1]))
    grid = above.subplots(3, 1, sharex=True, sharey=True)
    space = below.subplots()
    ways: list[Way] = [(path, {"color": _ELSE, "linewidth": 1.3}, "else")]
    handles: list[Line2D] = []
    for i, axes in enumerate(grid):
        quiet_zero(axes)
        curve(axes, run.t, force[:, i], f"force {COORDINATES[i]}", color=_ELSE, linewidth=1.3)
        axes.set_ylabel(f"force {COORDINATES[i]}\n[N]")
        axes.yaxis.set_major_locator(MaxNLocator(4))
    for (name, begin, end), (color, line) in zip(phases, _PHASES, strict=False):
        during = (run.t >= begin) & (run.t <= end)
        if during.sum() < 2:
            raise ValueError(f"guided: phase {name} from {begin} to {end} s holds fewer than two samples")
        for i, axes in enumerate(grid):
            curve(
                axes, run.t[during], force[during, i], f"{name} {COORDINATES[i]}", color=color, linestyle=line,
                linewidth=2.0,
            )  # fmt: skip
        ways.append((path[during], {"color": color, "linestyle": line, "linewidth": 2.6}, name))
        handles.append(Line2D([], [], color=color, linestyle=line, linewidth=2.4, label=name))
    room_around(grid[0], [force[:, :3]], 1e-6, 0.1)
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    draw_ways(space, view, ways)
    handles.append(Line2D([], [], color=_ELSE, linewidth=1.3, label="between"))
    legend(figure, handles)
    return finish(figure, [(space, ends(view, path))])


def zeroing_figure(
    run: Following, force_before: ArrayLike, force_after: ArrayLike, axis_free: ArrayLike, title: str
) -> Figure:
    """Forces before and after zeroing above, the path and the axis (3,) that is left free below."""
    before, after = (looked_at(f, run.x.shape, "zeroing: force") for f in (force_before, force_after))
    free = looked_at(axis_free, (3,), "zeroing: axis_free")
    free = free / float(np.linalg.norm(free))
    path = run.flange[:, :3]
    along = (path - path[0]) @ free
    off = np.linalg.norm(path - path[0] - along[:, None] * free, axis=1)
    reach = max(float(np.ptp(along)), 1e-3)
    line = path[0] + np.outer([along.min() - 0.25 * reach, along.max() + 0.25 * reach], free)
    view = View([path, line])
    tall = view.height(WIDTH - 3.0, 4.8)
    direction = ", ".join(f"{value:.3f}".replace("-", "−") for value in free)
    most = float(off.max()) / MM
    far = f"{number_of(most)} mm" if most >= 1e-3 else "less than 0.001 mm"
    text = f"free along ({direction}) · the path leaves that axis by {far}"
    figure = new_figure(1.7 + 2 * 1.7 + tall, title, text)
    halves = figure.add_gridspec(2, 1, height_ratios=[2 * 1.7 + 0.7, tall + 0.3])
    above, below = (figure.add_subfigure(half) for half in (halves[0], halves[1]))
    grid = above.subplots(2, 1, sharex=True, sharey=True)
    for axes, force, name in zip(grid, (before, after), ("before", "after"), strict=True):
        quiet_zero(axes)
        components(axes, run.t, force, (0, 1, 2), 1.0, name)
        axes.set_ylabel(f"force {name}\nzeroing [N]")
        axes.yaxis.set_major_locator(MaxNLocator(5))
    room_around(grid[0], [before[:, :3], after[:, :3]], 1e-6, 0.1)
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    space = below.subplots()
    axis_style = {"color": PURPLE, "linewidth": 1.6, "linestyle": (0, (7, 3))}
    draw_ways(space, view, [(path, {"color": BLACK, "linewidth": 3.4}, "path"), (line, axis_style, "axis")])
    handles = component_handles((0, 1, 2))
    handles.append(Line2D([], [], color=BLACK, linewidth=3.4, label="path"))
    handles.append(Line2D([], [], **axis_style, label="axis left free"))  # type: ignore[arg-type]
    legend(figure, handles)
    return finish(figure, [(space, ends(view, path))])


def contact_figure(run: Following, depth: ArrayLike, axis: int, title: str) -> Figure:
    """Planned, controller's and flange's coordinate along an axis, the force along it, and that across it if any."""
    if axis not in range(3):
        raise ValueError(f"contact: axis is {axis}, wanted 0, 1 or 2")
    inside = looked_at(depth, run.t.shape, "contact: depth")
    force = _force(run)
    across = [i for i in range(3) if i != axis and float(np.abs(force[:, i]).max()) > ACTS]
    deepest = f" · deepest {number_of(float(inside.max()) / MM)} mm" if (inside > 0).any() else " · no contact"
    figure = new_figure(7.0 + (2.0 if across else 0.0), title, run.label + deepest)
    grid = figure.subplots(3 if across else 2, 1, sharex=True, height_ratios=[1.5, 1.1, 0.8][: 3 if across else 2])
    planned, controller, flange = (p[:, axis] / MM for p in (run.x_e, run.x, run.flange))
    curve(grid[0], run.t, planned, "equilibrium", **PLANNED)
    curve(grid[0], run.t, controller, "controller", **CONTROLLER)
    shown = [planned, controller]
    handles: list[Line2D | Patch] = [Line2D([], [], **PLANNED), Line2D([], [], **CONTROLLER)]
    if run.true is not None:
        curve(grid[0], run.t, flange, "flange", **FLANGE)
        shown.append(flange)
        handles.append(Line2D([], [], **FLANGE))
    room_around(grid[0], shown, 1e-3, 0.18)
    grid[0].set_ylabel(f"{COORDINATES[axis]} [mm]")
    quiet_zero(grid[1])
    curve(grid[1], run.t, force[:, axis], "force", color=BLACK)
    room_around(grid[1], [force[:, axis], np.zeros(1)], 1e-6, 0.2)
    grid[1].set_ylabel(f"force on the tool\nalong {COORDINATES[axis]} [N]")
    marks: list[tuple[Axes, Marks]] = []
    # what the contact pushed away, not the lag before it; without a contact the lag is all there is
    away = np.where(inside > 0, flange - planned, 0.0) if (inside > 0).any() else flange - planned
    if float(np.abs(away).max()) > MOVES / MM:
        at, _, text = peak(run.t, away, "mm", " from the plan")
        i = int(np.searchsorted(run.t, at))
        marks.append((grid[0], [(at, float(flange[i]), f"tool {text}")]))
    if float(np.abs(force[:, axis]).max()) > ACTS:
        marks.append((grid[1], [peak(run.t, force[:, axis], "N")]))
    if across:
        quiet_zero(grid[2])
        for i, (color, line) in zip(across, _ACROSS, strict=False):
            name = f"along {COORDINATES[i]}"
            curve(grid[2], run.t, force[:, i], name, color=color, linestyle=line)
            handles.append(Line2D([], [], color=color, linestyle=line, label=name))
        room_around(grid[2], [force[:, across], np.zeros(1)], 1e-6, 0.15)
        grid[2].set_ylabel("across it [N]")
    touched = intervals(run.t, inside > 0)
    if touched:
        bands(list(grid), touched, gid="contact")
        handles.append(Patch(color=PALE, linewidth=0, label="in contact"))
    for axes in grid:
        axes.yaxis.set_major_locator(MaxNLocator(5))
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    legend(figure, handles)
    return finish(figure, marks)


def _force(run: Following) -> Array:
    if run.force is None:
        raise ValueError(f"Following {run.label} has no force to draw")
    return run.force


def _length(path: Array) -> float:
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
