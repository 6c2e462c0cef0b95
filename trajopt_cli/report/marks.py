"""What all pictures over time share: the program's stops and waits behind the curves, and names that do not overlap."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.patches import Patch
from matplotlib.text import Annotation
from matplotlib.transforms import Bbox

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Wait
from trajopt_cli.report.course import Course
from trajopt_cli.report.style import GREY, PALE, SMALL

LONGEST = 18  # letters of a target's name that are shown
_SLANT = 50.0  # deg
WAIT = Patch(color=PALE, linewidth=0, label="wait")


def short(name: str) -> str:
    """A target's name, cut with an ellipsis where it is long."""
    return name if len(name) <= LONGEST else name[: LONGEST - 1] + "…"


def mark_motions(course: Course, panels: Iterable[Axes]) -> None:
    """Light vertical lines where a move ends, bands where the program waits, the time axis from 0 to the end."""
    stops = [leg.t_1 for leg in course.moves if leg.t_1 < course.t[-1]]
    waits = [(leg.t_0, leg.t_1 - leg.t_0) for leg in course.legs if isinstance(leg.motion, Wait)]
    for axes in panels:
        axes.set_xlim(course.t[0], course.t[-1])
        axes.set_axisbelow(True)
        whole_height = axes.get_xaxis_transform()
        axes.vlines(stops, 0, 1, transform=whole_height, color="#c4c4c4", linewidth=0.9, zorder=0.6)
        axes.broken_barh(waits, (0, 1), transform=whole_height, color=PALE, linewidth=0, zorder=0.5)


def name_moves(course: Course, axes: Axes) -> list[Annotation]:
    """Each move's target, slanted, over the time it is reached; settled figures keep_apart them."""
    return [
        axes.annotate(
            short(leg.name),
            (leg.t_1, 1),
            (0, 3),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
            rotation=_SLANT,
            rotation_mode="anchor",
            ha="left",
            va="bottom",
            size=SMALL,
            color=GREY,
            annotation_clip=False,
            in_layout=True,
        )
        for leg in course.moves
    ]


def keep_apart(names: list[Annotation]) -> None:
    """Hide each slanted name that would touch the last one shown; the figure must be settled."""
    last = -np.inf
    for name in names:
        axes = name.axes
        assert axes is not None
        x = float(axes.transData.transform((float(name.xy[0]), 0.0))[0])
        if x - last < 1.15 * SMALL * axes.figure.dpi / 72 / np.sin(np.radians(_SLANT)):
            name.set_visible(False)
        else:
            last = x


def name_places(axes: Axes, places: Array, names: list[str], avoid: Array) -> None:
    """Name places (m, 2) in data units by the free spot nearest to each, with a thin line to it.

    avoid (n, 2): points of curves that a name should not cover. The figure must be settled.
    """
    canvas = axes.figure.canvas
    assert isinstance(canvas, FigureCanvasAgg)
    renderer = canvas.get_renderer()  # type: ignore[no-untyped-call]
    scale = axes.figure.dpi / 72
    curve = axes.transData.transform(avoid[np.isfinite(avoid).all(axis=1)])
    frame = axes.get_window_extent(renderer)
    taken: list[Bbox] = []
    for place, name in zip(places, names, strict=True):
        anchor = axes.transData.transform(place)
        label = axes.annotate(
            name, tuple(place), (0, 0), textcoords="offset points", size=SMALL, ha="center", va="center", zorder=6,
            arrowprops={"arrowstyle": "-", "color": GREY, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 2},
        )  # fmt: skip
        box = label.get_window_extent(renderer)
        width, height = box.width, box.height * 1.05
        best, best_cost = (0.0, 0.0), np.inf
        for reach in (12, 22, 34, 48, 64, 84):
            for direction in np.radians(np.arange(0, 360, 30) + 90):
                way = np.array([np.cos(direction), np.sin(direction)])
                # The name's edge, not its middle, stands at the reach.
                middle = anchor + way * reach * scale + way * [width / 2, height / 2]
                spot = Bbox.from_bounds(middle[0] - width / 2, middle[1] - height / 2, width, height)
                covered = spot.padded(2).count_contains(curve)
                clash = sum(spot.padded(2).overlaps(other) for other in taken)
                out = max(frame.x0 - spot.x0, spot.x1 - frame.x1, frame.y0 - spot.y0, spot.y1 - frame.y1, 0.0)
                cost = 1e4 * clash + 50.0 * out + 15.0 * min(covered, 20) + reach
                if cost < best_cost:
                    best, best_cost, chosen = tuple((middle - anchor) / scale), cost, spot
        label.set_position(best)
        taken.append(chosen)


def by_place(places: Array, names: list[str], apart: float) -> tuple[Array, list[str]]:
    """Places (m, d) [m] with those nearer than apart [m] put together, the names of one place below each other."""
    kept: list[Array] = []
    groups: list[list[str]] = []
    for place, name in zip(places, map(short, names), strict=True):
        near = [i for i, other in enumerate(kept) if np.linalg.norm(place - other) < apart]
        if not near:
            kept.append(place)
            groups.append([name])
        elif name not in groups[near[0]]:
            groups[near[0]].append(name)
    return np.array(kept).reshape(-1, places.shape[1]), ["\n".join(group) for group in groups]
