"""Names in pictures that do not cover one another: spread along a time axis, or by the free spot nearest to a place."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Annotation
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.report.style import GREY, SMALL

LONGEST = 18  # letters of a target's name that are shown
MOST_PLACES = 6  # that one name is written at
MOST_NAMES = 4  # at one place
MOST_TAGS = 24  # in one picture in space
_SLANT = 50.0  # deg
_LIFT = 10.0  # pt: from the top of the panel to the foot of a slanted name
_REACHES = (7.0, 13.0, 20.0, 29.0, 40.0, 54.0, 72.0, 94.0)  # pt: from a place to the edge of its name
_WAYS = np.radians(np.arange(0, 360, 20) + 90)
_ALONG = np.linspace(0.0, 0.9, 17)  # a line to a name is held against boxes at these shares of its length
_FINE = 4.0  # px: points of curves nearer than this count once
# What a name's spot costs, in pt of distance: outside, on another name, with a line through one, with a line past
# another place, over curves (per _FINE), over places.
_OUT, _ON, _THROUGH, _PAST, _COVER, _SPOIL = 5e3, 1e4, 300.0, 60.0, 4.0, 60.0


def short(name: str) -> str:
    """A target's name; of a long one the beginning and the end, which tell it from its neighbours."""
    return name if len(name) <= LONGEST else f"{name[: LONGEST // 2]}…{name[1 - LONGEST // 2 :]}"


def name_times(axes: Axes, ends: Sequence[tuple[float, str]]) -> list[Annotation]:
    """A name per (time, name), slanted, over the panel; in time order. spread moves them once the figure is settled.

    A name of more than MOST_PLACES times, as of a target in a loop, stands at the first and the last.
    """
    count = Counter(name for _, name in ends)
    first = {name: time for time, name in reversed(ends)}
    last = {name: time for time, name in ends}
    ends = [(time, name) for time, name in ends if count[name] <= MOST_PLACES or time in (first[name], last[name])]
    return [
        axes.annotate(
            short(name), (time, 1), (0, _LIFT), xycoords=("data", "axes fraction"), textcoords="offset points",
            rotation=_SLANT, rotation_mode="anchor", ha="left", va="bottom", size=SMALL, color=GREY,
            annotation_clip=False, in_layout=True,
        )
        for time, name in ends
    ]  # fmt: skip


def spread(names: list[Annotation]) -> None:
    """Push slanted names apart, as little as can be, each with a line to its time; the figure must be settled.

    Where even the whole width has no room for all, every second name is hidden, and so on until they fit.
    """
    if not names:
        return
    axes = names[0].axes
    assert isinstance(axes, Axes)
    gap = 1.12 * SMALL / np.sin(np.radians(_SLANT))  # pt
    scale = axes.figure.dpi / 72
    start, end = np.array(axes.transAxes.transform([(0, 0), (1, 0)]))[:, 0] / scale
    while (len(names) - 1) * gap > end - start:
        for name in names[-2::-2]:
            name.set_visible(False)
        names = names[::-2][::-1]
    wanted = np.array([float(axes.transData.transform((float(name.xy[0]), 0.0))[0]) for name in names]) / scale
    # The last one stays: the layout made room for it there.
    for name, x, at in zip(names, wanted, _apart(wanted, gap, start, wanted[-1]), strict=True):
        name.set_position((at - x, _LIFT))
        axes.annotate(
            "", (float(name.xy[0]), 1), (at - x + 1, _LIFT - 1), xycoords=("data", "axes fraction"),
            textcoords="offset points", annotation_clip=False, in_layout=False,
            arrowprops={"arrowstyle": "-", "color": GREY, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 1},
        )  # fmt: skip


def _apart(wanted: Array, gap: float, low: float, high: float) -> Array:
    """Places (n,) nearest to wanted in squares, gap apart at least and, if they fit, within low and high."""
    steps = gap * np.arange(len(wanted))
    blocks: list[tuple[float, int]] = []  # mean and size: pooled neighbours stand shoulder to shoulder
    for value in wanted - steps:
        mean, size = float(value), 1
        while blocks and blocks[-1][0] > mean:
            before, count = blocks.pop()
            mean, size = (before * count + mean * size) / (count + size), count + size
        blocks.append((mean, size))
    pooled = np.repeat([mean for mean, _ in blocks], [size for _, size in blocks])
    return np.asarray(np.clip(pooled, low, max(low, high - steps[-1])) + steps)


def by_place(places: Array, names: list[str], apart: float) -> tuple[Array, list[str]]:
    """Places (m, d) [m] with those nearer than apart [m] put together, the names of one place below each other.

    A name of more than MOST_PLACES places, as of a target computed in a loop, stands at the first, others have none. Of
    more than MOST_NAMES at one place two are written, and how many more there are.
    """
    kept: list[Array] = []
    groups: list[list[str]] = []
    for place, name in zip(places, map(short, names), strict=True):
        near = [i for i, other in enumerate(kept) if np.linalg.norm(place - other) < apart]
        if not near:
            kept.append(place)
            groups.append([name])
        elif name not in groups[near[0]]:
            groups[near[0]].append(name)
    count = Counter(name for group in groups for name in group)
    told: set[str] = set()
    for group in groups:
        group[:] = [name for name in group if count[name] <= MOST_PLACES or name not in told]
        told.update(group)
    told_of = [group if len(group) <= MOST_NAMES else [*group[:2], f"and {len(group) - 2} more"] for group in groups]
    return np.array(kept).reshape(-1, places.shape[1]), ["\n".join(group) for group in told_of]


def name_places(axes: Axes, places: Array, names: list[str], avoid: Array) -> None:
    """Name places (m, 2) in data units by the free spot nearest to each, with a thin line to it.

    avoid (n, 2): points of curves that a name should not cover. The figure must be settled. Of more than MOST_TAGS
    names every second, third, ... is tried; one that finds no spot inside the panel and clear of the others is left
    out, and the label under the panel says how many are there.
    """
    places, names = places[[bool(name) for name in names]], [name for name in names if name]
    if not names:
        return
    asked, every = len(names), -(-len(names) // MOST_TAGS)
    places, names = places[::every], names[::every]
    canvas = axes.figure.canvas
    assert isinstance(canvas, FigureCanvasAgg)
    renderer = canvas.get_renderer()  # type: ignore[no-untyped-call]
    scale = axes.figure.dpi / 72
    labels = [
        axes.annotate(
            name, tuple(place), (0, 0), textcoords="offset points", size=SMALL, ha="center", va="center", zorder=6,
            arrowprops={"arrowstyle": "-", "color": GREY, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 2},
        )
        for place, name in zip(places, names, strict=True)
    ]  # fmt: skip
    boxes = [label.get_window_extent(renderer) for label in labels]
    half = np.array([[box.width / 2, box.height * 0.525] for box in boxes])
    anchors = np.asarray(axes.transData.transform(places))
    curve = axes.transData.transform(avoid[np.isfinite(avoid).all(axis=1)])
    curve = _FINE * np.unique(np.round(curve / _FINE), axis=0)
    frame = axes.get_window_extent(renderer)
    reaches = np.repeat(_REACHES, len(_WAYS))
    away = np.tile(np.column_stack([np.cos(_WAYS), np.sin(_WAYS)]), (len(_REACHES), 1))
    # The name's edge, not its middle, stands at the reach.
    edge = (half[:, None] / np.maximum(np.abs(away), 1e-9)).min(axis=2)
    spots = anchors[:, None] + away * (reaches * scale + edge)[..., None]  # (m, c, 2)
    low, high = spots - half[:, None] - 2, spots + half[:, None] + 2
    out = np.maximum(np.maximum([frame.x0, frame.y0] - low, high - [frame.x1, frame.y1]), 0).sum(axis=2) > 0
    alone = reaches + _OUT * out
    for i in range(len(names)):
        alone[i] += _COVER * _contain(low[i], high[i], curve).sum(axis=1)
        alone[i] += _SPOIL * _contain(low[i], high[i], anchors).sum(axis=1)
    kept: list[tuple[Array, Array]] = []
    lines: list[Array] = []
    for i in sorted(range(len(names)), key=lambda i: -alone[i].min()):  # the hardest to place first
        ways = anchors[i] + (spots[i] - anchors[i])[:, None] * _ALONG[:, None]  # (c, k, 2)
        cost, on = alone[i].copy(), np.zeros(len(reaches), dtype=bool)
        for other in kept:
            on |= ((low[i] < other[1]) & (high[i] > other[0])).all(axis=1)
            cost += _THROUGH * ((ways > other[0]) & (ways < other[1])).all(axis=2).any(axis=1)
        past = np.linalg.norm(ways[:, :, None] - np.delete(anchors, i, axis=0), axis=3).min(axis=1, initial=np.inf)
        cost += _PAST * (past < _FINE).sum(axis=1)
        for line in lines:
            cost += _THROUGH * _contain(low[i], high[i], line).any(axis=1)
        k = int(np.argmin(cost + _ON * on))
        if on[k] or out[i, k]:
            labels[i].remove()
            continue
        labels[i].set_position(tuple((spots[i, k] - anchors[i]) / scale))
        kept.append((low[i, k], high[i, k]))
        lines.append(ways[k])
    if len(kept) < asked:
        axes.set_xlabel(f"{axes.get_xlabel()} ({len(kept)} of {asked} names shown)")


def _contain(low: Array, high: Array, points: Array) -> NDArray[np.bool_]:
    """Which boxes (c, 2), (c, 2) hold which points (n, 2): (c, n)."""
    return np.asarray(((points > low[:, None]) & (points < high[:, None])).all(axis=2))
