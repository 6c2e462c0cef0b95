"""What pictures of the compliant controller are drawn from, and what they share: curves, bands, marked maxima."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.iiwa.report.thinning import thinned
from trajopt_cli.report.names import name_places
from trajopt_cli.report.over_time import number
from trajopt_cli.report.style import AXIS_STYLES, BLACK, BLUE, GREY, PALE, VERMILLION, settle
from trajopt_cli.units import DEG, MM

COORDINATES = ("x", "y", "z", "α", "β", "γ")
# Of a shown coordinate: SI per shown unit and the unit's sign, of poses and of forces.
POSE_UNITS = ((MM, "mm"),) * 3 + ((DEG, "deg"),) * 3
FORCE_UNITS = ((1.0, "N"),) * 3 + ((1.0, "Nm"),) * 3
MOVES = 1e-6  # m or rad: a coordinate that travels less stands still
ACTS = 1e-9  # N or Nm: less is no force
_FINE = 4.0  # px: no name is narrower
_WIDE, _HIGH = 450.0, 260.0  # px: no name stands further from its place

# The thesis draws the planned trajectory and the controller's in two colours and the flange dashed.
PLANNED: dict[str, Any] = {"color": "#a9a9a9", "linewidth": 4.2, "label": "equilibrium (planned)"}
CONTROLLER: dict[str, Any] = {"color": BLUE, "linewidth": 1.8, "label": "controller"}
FLANGE: dict[str, Any] = {"color": VERMILLION, "linewidth": 1.8, "linestyle": (0, (2.5, 1.5)), "label": "tool itself"}
PEAK: dict[str, Any] = {"marker": "o", "markersize": 6.5, "linestyle": "", "color": BLACK, "markerfacecolor": "white"}

# (time, value, name) of what is marked in a panel, in its units.
Marks = list[tuple[float, float, str]]


@dataclass(frozen=True, eq=False)
class Following:
    """One run of the controller. x_e, x (n, 6): equilibrium and controller, positions [m] and angles [rad] over t [s].

    force (n, 6): on the tool [N, Nm], None where there is none to show. true (n, 6): the flange as it moved, None
    where it is the controller's. The arrays are looked at, not copied. Raises ValueError for shapes that do not fit,
    a time that does not grow, and values that are no numbers.
    """

    label: str
    t: Array
    x_e: Array
    x: Array
    force: Array | None = None
    true: Array | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "t", times(self.t, f"Following {self.label}"))
        for name in ("x_e", "x", "force", "true"):
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, looked_at(value, (len(self.t), 6), f"Following {self.label}: {name}"))

    @property
    def flange(self) -> Array:
        """Where the flange was (n, 6): as measured, else as the controller has it."""
        return self.x if self.true is None else self.true

    @property
    def deviation(self) -> Array:
        """The controller's distance from the equilibrium (n,) [m], eq. 6.8."""
        return np.asarray(np.linalg.norm(self.x[:, :3] - self.x_e[:, :3], axis=1))

    @property
    def turn(self) -> Array:
        """The same of the angles (n,) [rad]: the norm of their differences."""
        return np.asarray(np.linalg.norm(self.x[:, 3:] - self.x_e[:, 3:], axis=1))


def looked_at(values: ArrayLike, shape: tuple[int, ...], what: str) -> Array:
    """A read-only view of finite values of a shape; ValueError names what, the shape and the wish."""
    view = np.asarray(values, dtype=np.float64).view()
    if view.shape != shape or not np.isfinite(view).all():
        raise ValueError(f"{what} has shape {view.shape}, wanted {shape} of finite numbers")
    view.setflags(write=False)
    return view


def times(values: ArrayLike, what: str) -> Array:
    """A read-only view of times (n,) [s]; ValueError unless there are two at least and they grow."""
    t = looked_at(values, (len(np.atleast_1d(values)),), f"{what}: t")
    if len(t) < 2 or not (np.diff(t) > 0).all():
        raise ValueError(f"{what}: t has {len(t)} samples, wanted at least two that grow")
    return t


def curve(axes: Axes, t: Array, values: Array, gid: str, **style: Any) -> None:
    """A curve of values (n,) over t (n,), thinned to what the page shows."""
    rows = thinned(values)
    axes.plot(t[rows], values[rows], gid=gid, solid_joinstyle="round", **style)


def components(axes: Axes, t: Array, values: Array, which: Sequence[int], factor: float, gid: str) -> None:
    """Coordinates (n, 6) in the styles of x, y and z; gid is followed by the coordinate's sign."""
    for i in which:
        color, line = AXIS_STYLES[i % 3]
        curve(axes, t, values[:, i] / factor, f"{gid} {COORDINATES[i]}", color=color, linestyle=line)


def component_handles(which: Sequence[int]) -> list[Line2D]:
    """What the legend shows for components: one entry per style that is used."""
    out = []
    for i, (color, line) in enumerate(AXIS_STYLES):
        signs = [COORDINATES[k] for k in sorted(which) if k % 3 == i]
        if signs:
            name = signs[0] if len(signs) == 1 else f"{signs[0]}, about {signs[0]}"
            out.append(Line2D([], [], color=color, linestyle=line, label=name))
    return out


def moving(*paths: Array, rows: Sequence[int] = range(6), least: float = MOVES) -> list[int]:
    """Coordinates of rows that any of the paths (n, 6) travels along."""
    return [i for i in rows if max(float(np.ptp(path[:, i])) for path in paths) > least]


def peak(t: Array, values: Array, unit: str, of: str = "") -> tuple[float, float, str]:
    """The mark of the value (n,) furthest from zero: where, how much, and both in words; of: what the value is, said
    between them."""
    i = int(np.argmax(np.abs(values)))
    shown = abs(float(values[i]))
    return float(t[i]), float(values[i]), f"{quantity_of(shown, unit)}{of} at {number_of(float(t[i]))} s"


def number_of(value: float) -> str:
    """Three figures that matter, no exponents for ordinary sizes, and no minus before nothing."""
    if value == 0 or 1e-4 <= abs(value) < 1e5:
        decimals = 0 if value == 0 else max(0, 2 - int(np.floor(np.log10(abs(value)))))
        text = f"{value:.{decimals}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
        return text.replace("-", "−")
    return number(float(f"{value:.3g}"))


def quantity_of(value: float, unit: str) -> str:
    """A number with its unit; degrees by their sign."""
    return f"{number_of(value)}°" if unit == "deg" else f"{number_of(value)} {unit}"


def quiet_zero(axes: Axes) -> None:
    """A thin line at zero."""
    axes.axhline(0, color=GREY, linewidth=0.7, zorder=1)


def room_above(axes: Axes, values: Sequence[Array], least: float, share: float = 0.3) -> None:
    """The vertical range from zero to share over the largest of values that are never negative."""
    top = max([least, *(float(v.max()) for v in values)])
    axes.set_ylim(-0.03 * top, (1 + share) * top)


def room_around(axes: Axes, values: Sequence[Array], least: float, share: float = 0.18) -> None:
    """The vertical range around values, at least so wide that rounding does not fill the panel."""
    low, high = min(float(v.min()) for v in values), max(float(v.max()) for v in values)
    span, middle = max(high - low, least), (low + high) / 2
    axes.set_ylim(middle - (0.5 + share) * span, middle + (0.5 + share) * span)


def bands(panels: Sequence[Axes], spans: Sequence[tuple[float, float]], color: str = PALE, gid: str = "band") -> None:
    """Bands over spans (from, to) [s] behind the curves."""
    for axes in panels:
        axes.broken_barh(
            [(a, b - a) for a, b in spans], (0, 1), transform=axes.get_xaxis_transform(), facecolor=color, linewidth=0,
            zorder=0.5, gid=gid,
        )  # fmt: skip


def intervals(t: Array, on: BoolArray) -> list[tuple[float, float]]:
    """Where on (n,) holds, as (from, to) [s]: from the first sample of each stretch to the last."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], on, [False]]).astype(int)))
    return [(float(t[a]), float(t[b - 1])) for a, b in edges.reshape(-1, 2)]


def finish(figure: Figure, marks: Sequence[tuple[Axes, Marks]]) -> Figure:
    """Mark the places, settle the figure, and name each place by the nearest free spot."""
    for axes, places in marks:
        if places:
            axes.plot([x for x, _, _ in places], [y for _, y, _ in places], gid="peak", zorder=5, **PEAK)
    figure.align_ylabels()
    settle(figure)
    for axes, places in marks:
        if not places:
            continue
        spots = np.array([(x, y) for x, y, _ in places]).reshape(-1, 2)
        name_places(axes, spots, [name for _, _, name in places], crowded(axes, spots))
    return figure


def crowded(axes: Axes, spots: Array) -> Array:
    """Points (n, 2) in data units on curves and texts where names of spots (m, 2) could stand; once settled.

    They are close enough for no name to slip between.
    """
    frame = axes.get_window_extent()
    low, high = np.array([frame.x0, frame.y0]) - _FINE, np.array([frame.x1, frame.y1]) + _FINE
    points = [np.empty((0, 2))]
    for text in axes.texts:
        box = text.get_window_extent()
        across, up = np.arange(box.x0, box.x1, _FINE), np.arange(box.y0, box.y1, _FINE)
        points.append(np.stack(np.meshgrid(across, up), axis=-1).reshape(-1, 2))
    for line in axes.lines:
        data = np.asarray(line.get_xydata(), dtype=np.float64)
        if len(data) < 2 or line.get_gid() in (None, "peak"):
            continue
        # a logarithmic scale puts 0 very far away
        at = np.clip(np.asarray(line.get_transform().transform(data)), low, high)
        way = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(at, axis=0).T))])
        steps = np.arange(0.0, way[-1], _FINE)
        points.append(np.column_stack([np.interp(steps, way, at[:, i]) for i in range(2)]))
    cells = np.round(np.vstack(points) / _FINE).astype(np.int64)
    codes = np.unique(cells[:, 0] * 1_000_000 + cells[:, 1])
    once = np.column_stack(np.divmod(codes, 1_000_000)) * _FINE
    gaps = np.abs(once[:, None] - np.asarray(axes.transData.transform(spots)))
    near = (gaps < [_WIDE, _HIGH]).all(axis=2).any(axis=1)
    return np.asarray(axes.transData.inverted().transform(once[near]))
