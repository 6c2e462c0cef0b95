"""Rail and arm in space at several stops, with the TCP's path."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # type: ignore[import-untyped]

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Wait
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report import obstacles, style
from trajopt_cli.report.names import short
from trajopt_cli.report.skeleton import skeleton
from trajopt_cli.scene import LINK, rail_ends, scene_of_plant
from trajopt_cli.shapes import Mesh
from trajopt_cli.trajectories.plan_series import PlanSeries
from trajopt_cli.units import MM

_TAG = 45.0  # mm from an elbow up to its number
_SOLID = 0.06  # opacity of a face of the bodies around the links
_GHOSTS = (style.BLACK, style.VERMILLION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE)


def arm(series: PlanSeries) -> Figure:
    """Rail and arm in space at the start and at the plan's stations, with the TCP's path. Fig. 6.1."""
    robot = series.plant.robot
    figure = style.new_figure(7.4, "Rail, arm and path" if robot.has_rail else "Arm and path", series.below)
    figure.set_layout_engine(None)
    axes: Any = figure.add_axes((0, 0, 1, 1), projection="3d", computed_zorder=False)
    stations = _stations(series)
    shapes = [skeleton(series.plant, series.q[i], X_FT) / MM for i, _, X_FT in stations]
    bodies = [_solids(series.plant, series.q[i]) / MM for i, _, _ in stations]
    p = series.X_WT[:, :3, 3] / MM
    beams = rail_ends(series.plant) / MM
    for beam in beams.reshape(-1, 2, 3):
        axes.plot(*beam.T, color="#c8c8c8", linewidth=11, solid_capstyle="butt", zorder=1)
        axes.plot(*beam.T, color=style.GREY, linewidth=1, zorder=1.1)
    halo = [withStroke(linewidth=3, foreground="white")]
    for order, (shape, solids, color) in enumerate(zip(shapes, bodies, _GHOSTS, strict=False)):
        axes.add_collection3d(Poly3DCollection(solids, facecolor=color, alpha=_SOLID, zorder=1.5, gid="bodies"))
        axes.plot(*shape[:2].T, color=color, linewidth=9, alpha=0.45, solid_capstyle="round", zorder=2 + order)
        axes.plot(*shape[1:5].T, color=color, linewidth=6, alpha=0.6, solid_joinstyle="round", zorder=2 + order)
        axes.plot(*shape[4:].T, color=color, linewidth=3, zorder=2 + order)
        axes.plot(*shape[1:5].T, "o", color="white", markeredgecolor=color, markersize=5, zorder=2.1 + order)
        axes.text(
            *(shape[3] + [0, 0, _TAG]),
            str(order + 1),
            color=color,
            size=style.TEXT,
            ha="center",
            zorder=30,
            path_effects=halo,
        )
    axes.plot(*p.T, color=style.BLACK, linewidth=1.5, zorder=20)
    everything = np.vstack([p, beams, *shapes, *(solids.reshape(-1, 3) for solids in bodies)])
    low, high = everything.min(axis=0), everything.max(axis=0)
    span = np.maximum(high - low, 0.15 * float((high - low).max()))
    _to_scale(axes, low, span)
    for cloud in obstacles.clouds(series.plant):
        if faces := obstacles.surface(cloud / MM, low - 0.03 * span, low + 1.03 * span):
            axes.add_collection3d(Poly3DCollection(faces, zorder=0.5, gid="obstacle", **obstacles.FACE))
    for letter, pad in zip("xyz", (14, 22, 24), strict=True):
        getattr(axes, f"set_{letter}label")(f"{letter} [mm]", labelpad=pad)
    handles: list[Line2D | Patch] = [Line2D([], [], color=style.BLACK, linewidth=1.5, label="path")]
    for order, ((_, name, _), color) in enumerate(zip(stations, _GHOSTS, strict=False)):
        handles.append(Line2D([], [], color=color, linewidth=6, alpha=0.7, label=f"{order + 1}: {name}"))
    handles += [obstacles.LABEL] if series.plant.obstacles else []
    letters = sum(len(str(handle.get_label())) for handle in handles)
    ncols = len(handles) if 0.75 * len(handles) + 0.093 * letters < style.WIDTH - 0.4 else 3  # in
    figure.legend(handles=handles, loc="lower center", ncols=ncols, columnspacing=1.6)
    _fit(figure, axes, span, low=0.4 + 0.28 * -(-len(handles) // ncols))
    _tags_apart(figure, axes)
    return figure


def _solids(plant: Plant, q: Array) -> Array:
    """Faces (m, 3, 3) [m] of the polytopes around the links, in the world at axes q (k,)."""
    scene = scene_of_plant(plant)
    poses = [*scene.poses(q[None])[0], scene.base]  # the last one is BASE's
    faces = [np.empty((0, 3, 3))]
    for body in scene.bodies:
        if body.role == LINK and isinstance(body.shape, Mesh):
            X = poses[body.frame] @ body.shape.X
            faces.append((body.shape.vertices @ X[:3, :3].T + X[:3, 3])[body.shape.triangles])
    return np.concatenate(faces)


def _tags_apart(figure: Figure, axes: Any) -> None:
    """Lift each number over an elbow off those before it; where the arm stands is fitted already."""
    seen: list[Array] = []
    for text in axes.texts:
        while True:
            at = _pixels(axes, np.array([text.get_position_3d()]))[0]
            if all(np.abs(at - other).max() > 1.3 * style.TEXT * figure.dpi / 72 for other in seen):
                break
            x, y, z = text.get_position_3d()
            text.set_position_3d((x, y, z + 0.5 * _TAG))
        seen.append(at)


def _to_scale(axes: Any, low: Array, span: Array) -> None:
    """The same length for a metre on all three axes, seen from in front with the longer way across the page."""
    for setter, a, s in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), low, span, strict=True):
        setter(a - 0.03 * s, a + 1.03 * s)
    axes.set_box_aspect(tuple(span))
    axes.view_init(elev=24, azim=-28 if span[1] > span[0] else -62)
    axes.set_proj_type("ortho")
    for axis, s in zip((axes.xaxis, axes.yaxis, axes.zaxis), span, strict=True):
        low_end, high_end = axis.get_view_interval()
        ticks = _inner_ticks(low_end, high_end, max(2, round(7 * s / span.max())))
        axis.set_ticks(ticks[::2] if len(ticks) == 3 and s < 0.4 * span.max() and axis is not axes.zaxis else ticks)
        axis.pane.set_facecolor("white")
        axis.pane.set_edgecolor("#d8d8d8")
    axes.tick_params(labelsize=style.SMALL, pad=3)
    axes.tick_params(axis="z", pad=8)


def _inner_ticks(low: float, high: float, wanted: int) -> list[float]:
    """About so many round ticks, two at least, away from the ends: numbers at a corner of the box would stand on those
    of the next axis."""
    edge = 0.05 * (high - low)
    for count in range(wanted, wanted + 20):
        ticks = MaxNLocator(nbins=count, steps=style.ROUND).tick_values(low, high)
        inner = [float(tick) for tick in ticks if low + edge < tick < high - edge]
        if len(inner) >= 2:
            break
    return inner


def _fit(figure: Figure, axes: Any, span: Array, low: float) -> None:
    """Make the box of the axes fill the figure's width above low [in] and close the figure's height around it."""
    labels, head, foot = 1.0, 0.75, 0.55  # in, at each side, above, and for the numbers below
    wide, tall = _box(axes)[1] / figure.dpi
    height = min(6.2, (style.WIDTH - 2 * labels) * tall / wide)
    before = figure.get_figheight()
    figure.set_size_inches(style.WIDTH, height + head + low + foot)
    for text in figure.texts:  # the heading keeps its distance from the top
        text.set_y(1 - (1 - text.get_position()[1]) * before / figure.get_figheight())
    # The box is drawn in a square, and cut at its sides: as wide as the page, and measured again before it is enlarged.
    square = style.WIDTH / figure.get_figheight()
    axes.set_position((0, 0, 1, square))
    axes.set_box_aspect(tuple(span), zoom=height * figure.dpi / float(_box(axes)[1][1]))
    middle, _ = _box(axes)
    wanted = np.array([0.49 * style.WIDTH, low + foot + height / 2]) * figure.dpi
    shift = (wanted - middle) / figure.bbox.size
    axes.set_position((shift[0], shift[1], 1, square))


def _box(axes: Any) -> tuple[Array, Array]:
    """Middle and size (2,) [px] of the drawn axes' box."""
    axes.apply_aspect()
    corners = np.array([*product(axes.get_xlim(), axes.get_ylim(), axes.get_zlim())])
    pixels = _pixels(axes, corners)
    return (pixels.max(axis=0) + pixels.min(axis=0)) / 2, np.ptp(pixels, axis=0)


def _pixels(axes: Any, points: Array) -> Array:
    """Where points (n, 3) in data units are drawn (n, 2) [px]."""
    flat = np.column_stack([points, np.ones(len(points))]) @ axes.get_proj().T
    return np.asarray(axes.transData.transform(flat[:, :2] / flat[:, 3:]))


def _stations(series: PlanSeries) -> list[tuple[int, str, Array]]:
    """Sample, label and tool of the start and of where the plan waits (else of where it stops), five at most, spread
    over the cycle."""
    named = [(0, "start", series.legs[0].X_FT if series.legs else np.eye(4))]
    waits = [
        (before.t_1, before.name, before.X_FT)
        for before, leg in zip(series.legs, series.legs[1:], strict=False)
        if isinstance(leg.motion, Wait) and before.name
    ]
    for time, name, X_FT in waits or [(leg.t_1, leg.name, leg.X_FT) for leg in series.moves if not leg.passed]:
        i = series.at(time)
        if all(_apart(series, i, j) for j, _, _ in named):
            named.append((i, f"{short(name)}, {series.t[i]:.2f} s", X_FT))
    shown = min(len(named), len(_GHOSTS))
    return [named[k] for k in np.linspace(0, len(named) - 1, shown).round().astype(int)]


def _apart(series: PlanSeries, i: int, j: int) -> bool:
    """Whether two samples show the arm in two places, by 5 cm of the TCP at least."""
    return bool(np.linalg.norm(series.X_WT[i, :3, 3] - series.X_WT[j, :3, 3]) > 0.05)
