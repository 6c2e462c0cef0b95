"""Cycle time over the place where something stands, as a map."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation, TriContourSet

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.report.style import BLACK, GREY, PALE, SMALL, VERMILLION, files, house_style, new_figure, settle

_HEIGHT = 7.2  # in
_LEVELS = 9
_COLOURS = "cividis"  # the same in grey, and for colour-blind readers


@dataclass(frozen=True)
class Spot:
    """A place by its offsets [m, rad], its time [s], None where it cannot be done, and whether it was planned whole."""

    offset: tuple[float, ...]
    seconds: float | None
    planned: bool


def place_map(
    spots: Sequence[Spot],
    axes: Sequence[tuple[str, str, float]],
    best: tuple[float, ...] | None,
    of: str,
    title: str,
    name: str,
) -> dict[str, bytes]:
    """place_NAME.svg and .png. axes: of each range its key, its unit and how many of them are one SI unit. best: the
    best place, None for none. of: what the times are. title: for people."""
    with house_style():
        return files(f"place_{name}", place_figure(spots, axes, best, of, title), title)


def place_figure(
    spots: Sequence[Spot], axes: Sequence[tuple[str, str, float]], best: tuple[float, ...] | None, of: str, title: str
) -> Figure:
    """The figure of place_map; call it in house_style."""
    more = "" if len(axes) < 3 else f"; {', '.join(key for key, _, _ in axes[2:])} differ from point to point"
    figure = new_figure(_HEIGHT, f"{of[0].upper()}{of[1:]} over place{more}", title)
    panel = figure.subplots()
    scale = np.array([factor for _, _, factor in axes])
    at = np.array([one.offset for one in spots]) * scale
    seconds = np.array([np.nan if one.seconds is None else one.seconds for one in spots])
    can = np.isfinite(seconds)
    if len(axes) == 1:
        _line(panel, at, seconds, can)
        panel.set_ylabel("cycle [s]")
    else:
        _contours(figure, panel, at[:, :2], seconds, can, filled=len(axes) == 2)
        key, unit, _ = axes[1]
        panel.set_ylabel(f"{key} from the present place [{unit}]")
    key, unit, _ = axes[0]
    panel.set_xlabel(f"{key} from the present place [{unit}]")
    _mark(panel, np.zeros(len(axes)), at, seconds, "o", "the present place", "present")
    if best is not None and any(best):
        _mark(panel, np.array(best) * scale, at, seconds, "*", "the best place found", "best")
    figure.legend(loc="outside lower center", ncols=5)
    settle(figure)
    return figure


def _line(panel: Axes, at: Array, seconds: Array, can: BoolArray) -> None:
    order = np.argsort(at[:, 0])
    panel.plot(at[order, 0], seconds[order], color=GREY, marker=".", markersize=7, label="tried", gid="tried")
    if not can.all():
        low = np.full((~can).sum(), np.nanmin(seconds) if can.any() else 0.0)
        panel.plot(at[~can, 0], low, "x", color=VERMILLION, label="cannot be done", gid="impossible")


def _contours(figure: Figure, panel: Axes, at: Array, seconds: Array, can: BoolArray, filled: bool) -> None:
    """Filled contours inside the triangles whose corners can all be done, over a pale ground; or points alone."""
    panel.set_facecolor(PALE)
    shown: TriContourSet | PathCollection | None = None
    if filled and np.linalg.matrix_rank(at - at[:1], tol=1e-6) == 2:
        triangles = Triangulation(at[:, 0], at[:, 1])
        hidden = ~can[triangles.triangles].all(axis=1)
        if not hidden.all():
            triangles.set_mask(hidden)
            known = np.where(can, seconds, np.nanmax(seconds))
            # as many places in each colour, so that places near the best can be told apart
            levels = np.unique(np.quantile(seconds[can], np.linspace(0, 1, _LEVELS)))
            if len(levels) > 2:
                norm = BoundaryNorm(levels, colormaps[_COLOURS].N)
                shown = panel.tricontourf(triangles, known, levels=levels, cmap=_COLOURS, norm=norm)
    if shown is None:
        shown = panel.scatter(at[can, 0], at[can, 1], s=40, c=seconds[can], cmap=_COLOURS, label="tried", gid="tried")
    else:
        panel.scatter(
            at[can, 0], at[can, 1], s=14, color="white", edgecolors=GREY, linewidths=0.8, label="tried", gid="tried",
            clip_on=False, zorder=3,
        )  # fmt: skip
    if not can.all():
        panel.plot(
            at[~can, 0], at[~can, 1], "x", color=VERMILLION, label="cannot be done", gid="impossible", clip_on=False
        )
    if can.any():
        bar = figure.colorbar(shown, ax=panel, format="%.3f")
        bar.set_label("cycle [s]", size=SMALL)


def _mark(panel: Axes, point: Array, at: Array, seconds: Array, marker: str, label: str, name: str) -> None:
    """A place that is named; over one range at its time."""
    x, y = point[:2] if len(point) > 1 else (point[0], seconds[np.argmin(np.abs(at[:, 0] - point[0]))])
    size = 19 if marker == "*" else 11
    panel.plot(
        [x], [y], marker, color="white", markeredgecolor=BLACK, markersize=size, markeredgewidth=1.6, zorder=4,
        clip_on=False, label=label, gid=name,
    )  # fmt: skip
