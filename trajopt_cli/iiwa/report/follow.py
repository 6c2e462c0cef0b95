"""Following: equilibrium and controller over time and in space, families of runs, dosing. Graf 6.11 to 6.16."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.report.runs import (
    CONTROLLER,
    COORDINATES,
    FLANGE,
    MOVES,
    PLANNED,
    POSE_UNITS,
    Following,
    Marks,
    curve,
    finish,
    moving,
    number_of,
    peak,
    room_above,
    room_around,
)
from trajopt_cli.iiwa.report.space import View, Way, draw_ways, ends
from trajopt_cli.report.over_time import TIME, legend
from trajopt_cli.report.style import BLACK, GREY, JOINT_STYLES, SMALL, WIDTH, LineStyle, name_limit, new_figure
from trajopt_cli.units import DEG, MM

APART = 5.0  # runs of durations further apart than this share a logarithmic time axis
_PLAIN = FuncFormatter(lambda value, _: number_of(value))  # no powers of ten
_AT_BOUND = 0.01  # share of a bound by which a peak may miss it to be at it
_FOLLOWED = 1e-3  # mm: a smaller deviation is none that anybody sees
_FLAT = 1e-3  # of a line's length: what leaves it by less is straight
_TURNS = 1e-4  # rad: angles that move less are not drawn
# Six runs as joints are told apart, four more by wider and finer dashes.
_STYLES: tuple[tuple[str, LineStyle], ...] = (*JOINT_STYLES, ("#56b4e9", "-"), (GREY, (0, (8, 1.5, 1.5, 1.5))))


def following_figure(run: Following, title: str) -> Figure:
    """Each coordinate that moves, planned and as the controller has it, and the deviation with its maximum."""
    turns = moving(run.x_e, run.x, rows=range(3, 6), least=_TURNS)
    rows = [*(moving(run.x_e, run.x, rows=range(3)) or ([] if turns else range(3))), *turns]
    last = ["d", "turn"] if turns else ["d"]
    figure = new_figure(1.7 + 1.25 * len(rows) + 1.6 * len(last), title, _worst(run))
    grid = figure.subplots(
        len(rows) + len(last), 1, sharex=True, height_ratios=[1.0] * len(rows) + [1.3] * len(last), squeeze=False
    )[:, 0]
    for axes, i in zip(grid, rows, strict=False):
        factor, unit = POSE_UNITS[i]
        shown = [run.x_e[:, i] / factor, run.x[:, i] / factor]
        curve(axes, run.t, shown[0], f"equilibrium {COORDINATES[i]}", **PLANNED)
        curve(axes, run.t, shown[1], f"controller {COORDINATES[i]}", **CONTROLLER)
        if run.true is not None:
            shown.append(run.true[:, i] / factor)
            curve(axes, run.t, shown[2], f"flange {COORDINATES[i]}", **FLANGE)
        room_around(axes, shown, 1.0, 0.1)
        axes.yaxis.set_major_locator(MaxNLocator(4))
        axes.set_ylabel(f"{COORDINATES[i]} [{unit}]")
    marks: list[tuple[Any, Marks]] = []
    for axes, name in zip(grid[len(rows) :], last, strict=True):
        values, unit = (run.deviation / MM, "mm") if name == "d" else (run.turn / DEG, "deg")
        curve(axes, run.t, values, name, color=BLACK)
        room_above(axes, [values], 1e-3, 0.45)
        axes.yaxis.set_major_locator(MaxNLocator(4))
        axes.set_ylabel(f"deviation d\n[{unit}]" if name == "d" else f"deviation of\nangles [{unit}]")
        marks.append((axes, [peak(run.t, values, unit)]))
    grid[-1].set_xlabel(TIME)
    grid[-1].set_xlim(run.t[0], run.t[-1])
    legend(figure, _handles(run))
    return finish(figure, marks)


def path_figure(run: Following, title: str) -> Figure:
    """The planned path and the controller's in space, start and end marked."""
    ways: list[Way] = [(run.x_e[:, :3], PLANNED, "equilibrium"), (run.x[:, :3], CONTROLLER, "controller")]
    if run.true is not None:
        ways.append((run.true[:, :3], FLANGE, "flange"))
    return _space(title, _worst(run), ways, _handles(run), run)


def family_figure(runs: Sequence[Following], parameter: str, title: str) -> Figure:
    """The deviation of each run over time, its maximum marked; a logarithmic time axis where durations differ much."""
    _told_apart(runs)
    figure = new_figure(6.2, title, "distance of the controller from the equilibrium (eq. 6.8), maxima marked")
    axes = figure.subplots()
    marks: Marks = []
    for run, (color, line) in zip(runs, _STYLES, strict=False):
        d = run.deviation / MM
        curve(axes, run.t - run.t[0], d, f"d {run.label}", color=color, linestyle=line)
        at, most, _ = peak(run.t - run.t[0], d, "mm")
        marks.append((at, most, f"{number_of(most)} mm"))
    _share_time(axes, runs, marks)
    room_above(axes, [run.deviation / MM for run in runs], 1e-3, 0.12)
    axes.set_ylabel("deviation d [mm]")
    axes.set_xlabel(TIME)
    _legend_of(figure, runs, parameter, [])
    return finish(figure, [(axes, marks)])


def family_path_figure(runs: Sequence[Following], parameter: str, title: str) -> Figure:
    """The paths of all runs in space over the path of the first one's equilibrium.

    Along one straight line all would cover one another: then, how far each run is when its equilibrium arrives.
    """
    _told_apart(runs)
    straight = _straight(runs)
    if straight is not None:
        return _tracks(runs, straight, parameter, title)
    ways: list[Way] = [(runs[0].x_e[:, :3], PLANNED, "equilibrium")]
    for run, (color, line) in zip(runs, _STYLES, strict=False):
        ways.append((run.x[:, :3], {"color": color, "linestyle": line, "linewidth": 1.7}, f"path {run.label}"))
    return _space(title, f"controller's path by {parameter}", ways, (runs, parameter), runs[0])


def _straight(runs: Sequence[Following]) -> Array | None:
    """Start and end (2, 3) [m] of the straight line that every equilibrium goes along once; None if there is none."""
    start, end = runs[0].x_e[0, :3], runs[0].x_e[-1, :3]
    length = float(np.linalg.norm(end - start))
    if length < MOVES:
        return None
    way = (end - start) / length
    for run in runs:
        for path, forward in ((run.x_e[:, :3], True), (run.x[:, :3], False)):
            along = (path - start) @ way
            off = np.linalg.norm(path - start - along[:, None] * way, axis=1)
            if off.max() > _FLAT * length or (forward and np.diff(along).min() < -MOVES):
                return None
        if np.linalg.norm(run.x_e[-1, :3] - end) > _FLAT * length:
            return None
    return np.array([start, end])


def _tracks(runs: Sequence[Following], line: Array, parameter: str, title: str) -> Figure:
    length = float(np.linalg.norm(line[1] - line[0]))
    way = (line[1] - line[0]) / length
    below = f"one straight line of {number_of(length / MM)} mm: where the controller is when the equilibrium arrives"
    figure = new_figure(1.9 + 0.62 * len(runs), title, below)
    axes = figure.subplots()
    for row, (run, (color, _)) in enumerate(zip(runs, _STYLES, strict=False)):
        planned, reached = ((path[:, :3] - line[0]) @ way for path in (run.x_e, run.x))
        arrival = int(np.argmax(planned > planned[-1] - MOVES))
        at = float(reached[arrival]) / MM
        axes.plot([0, length / MM], [row, row], gid=f"planned {run.label}", **PLANNED)
        axes.plot([0, at], [row, row], color=color, linewidth=2.6, gid=f"reached {run.label}")
        axes.plot(at, row, "o", color=color, markersize=9, gid=f"at {run.label}")
        words = f"{number_of(length / MM - at)} mm behind after {number_of(float(run.t[arrival] - run.t[0]))} s"
        axes.annotate(words, (length / MM, row), (12, 0), textcoords="offset points", va="center", size=SMALL)
    axes.set_yticks(range(len(runs)), [run.label for run in runs])
    axes.set_ylim(len(runs) - 0.4, -0.6)
    axes.set_xlim(-0.01 * length / MM, 1.32 * length / MM)
    axes.set_xticks([tick for tick in axes.get_xticks() if 0 <= tick <= 1.001 * length / MM])
    axes.set_ylabel(parameter)
    axes.set_xlabel("along the line [mm]")
    controller = Line2D([], [], color=BLACK, marker="o", markersize=8, linewidth=2.6, label="controller")
    legend(figure, [Line2D([], [], **PLANNED), controller])
    return finish(figure, [])


def dosing_figure(undosed: Following, others: Sequence[Following], bound: float, title: str) -> Figure:
    """Deviation of the undosed run and of the others against the bound [m], and how fast each is fed, over time."""
    runs = (undosed, *others)
    _told_apart(runs)
    largest = [f"{run.label} {_deviation(run)}" for run in runs]
    figure = new_figure(8.2, title, "largest deviation: " + " · ".join(largest))
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[1.35, 1])
    marks: Marks = []
    for run, (color, line) in zip(runs, _STYLES, strict=False):
        d = run.deviation / MM
        curve(above, run.t - run.t[0], d, f"d {run.label}", color=color, linestyle=line)
        at, most, _ = peak(run.t - run.t[0], d, "mm")
        if abs(most - bound / MM) > _AT_BOUND * bound / MM:  # the bound is named already
            marks.append((at, most, _deviation(run)))
        t, speed = fed(run)
        curve(below, t, speed / MM, f"speed {run.label}", color=color, linestyle=line)
    name_limit(above, bound / MM, f"bound {number_of(bound / MM)} mm")
    most = max(float(run.deviation.max()) / MM for run in runs)
    if most > APART * bound / MM:
        above.set_yscale("log")
        above.set_ylim(bound / MM / 20, 2 * most)
        above.yaxis.set_major_formatter(_PLAIN)
    else:
        room_above(above, [np.array([most, bound / MM])], 1e-3, 0.15)
    fastest = [float(fed(run)[1].max()) / MM for run in runs]
    if max(fastest) > 2 * APART * min(fastest) > 0:
        below.set_yscale("log")
        below.set_ylim(min(fastest) / 10, 1.5 * max(fastest))
        below.yaxis.set_major_formatter(_PLAIN)
    else:
        room_above(below, [np.array(fastest)], 1e-3, 0.1)
    above.set_ylabel("deviation d [mm]")
    below.set_ylabel("speed of the\nplan [mm/s]")
    below.set_xlabel(TIME)
    _share_time(below, runs, marks)
    _legend_of(figure, runs, "", [])
    return finish(figure, [(above, marks)])


def _deviation(run: Following) -> str:
    """The largest one in words."""
    largest = float(run.deviation.max() / MM)
    return f"{number_of(largest)} mm" if largest >= _FOLLOWED else f"below {_FOLLOWED:g} mm"


def dosing_path_figure(undosed: Following, others: Sequence[Following], title: str) -> Figure:
    """The paths of all runs in space, undosed and dosed."""
    return _space(
        title,
        "controller's path, undosed and dosed",
        [
            (undosed.x_e[:, :3], PLANNED, "equilibrium"),
            *(
                (run.x[:, :3], {"color": color, "linestyle": line, "linewidth": 1.7}, f"path {run.label}")
                for run, (color, line) in zip((undosed, *others), _STYLES, strict=False)
            ),
        ],
        ((undosed, *others), ""),
        undosed,
    )


def _share_time(axes: Axes, runs: Sequence[Following], peaks: Marks) -> None:
    """Seconds from 0; where durations differ much, evenly to well before the first peak and logarithmically on."""
    spans = [float(run.t[-1] - run.t[0]) for run in runs]
    if max(spans) <= APART * min(spans):
        axes.set_xlim(0, max(spans))
        return
    first = min([at for at, _, _ in peaks if at > 0], default=min(spans))
    even = min(first / 2, min(spans) / 10)
    axes.set_xscale("symlog", linthresh=even, linscale=0.4)
    axes.set_xlim(0, max(spans))
    ticks = [value for value in LogLocator(subs=(1.0, 2.0, 5.0)).tick_values(even, max(spans)) if value <= max(spans)]
    axes.set_xticks([0.0, *(value for value in ticks if value >= even / 2)])
    axes.xaxis.set_major_formatter(_PLAIN)
    axes.xaxis.set_minor_formatter(NullFormatter())


def fed(run: Following) -> tuple[Array, Array]:
    """How fast the equilibrium goes [m/s] as steps over time: each difference holds over its own period."""
    steps = np.linalg.norm(np.diff(run.x_e[:, :3], axis=0), axis=1) / np.diff(run.t)
    t = run.t - run.t[0]
    return np.repeat(t, 2)[1:-1], np.repeat(steps, 2)


def _space(
    title: str, below: str, ways: Sequence[Way], key: list[Line2D] | tuple[Sequence[Following], str], run: Following
) -> Figure:
    view = View([points for points, _, _ in ways])
    figure = new_figure(1.6 + view.height(WIDTH - 2.2, 7.2), title, below)
    axes = figure.subplots()
    draw_ways(axes, view, ways)
    if isinstance(key, list):
        legend(figure, key)
    else:
        _legend_of(figure, key[0], key[1], [Line2D([], [], **PLANNED)])
    return finish(figure, [(axes, ends(view, run.x_e[:, :3]))])


def _handles(run: Following) -> list[Line2D]:
    styles = [PLANNED, CONTROLLER] + ([FLANGE] if run.true is not None else [])
    return [Line2D([], [], **style) for style in styles]


def _legend_of(figure: Figure, runs: Sequence[Following], parameter: str, first: list[Line2D]) -> None:
    handles = list(first)
    for run, (color, line) in zip(runs, _STYLES, strict=False):
        handles.append(Line2D([], [], color=color, linestyle=line, label=run.label))
    letters = sum(len(str(handle.get_label())) for handle in handles)
    rows = -(-int(0.8 * len(handles) * 10 + letters) // 105)
    figure.legend(
        handles=handles, loc="outside lower center", ncols=-(-len(handles) // rows), columnspacing=1.6,
        handlelength=2.6, title=parameter or None, title_fontsize=SMALL,
    )  # fmt: skip


def _told_apart(runs: Sequence[Following]) -> None:
    labels = [run.label for run in runs]
    if not 1 <= len(runs) <= len(_STYLES) or len(set(labels)) < len(labels):
        raise ValueError(f"a picture tells 1 to {len(_STYLES)} runs of different labels apart, not {labels}")


def _worst(run: Following) -> str:
    text = peak(run.t, run.deviation / MM, "mm")[2]
    return f"{run.label} · largest deviation {text} of {number_of(float(run.t[-1]))} s"
