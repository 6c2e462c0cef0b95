"""Pictures of the compliant controller: drawn data equal the given, limits and maxima stand where they are."""

from __future__ import annotations

from functools import cache, partial
from itertools import combinations

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text

from trajopt_cli.iiwa.report.follow import (
    Following,
    family_figure,
    following_figure,
    loop_time_figure,
    number_of,
    picture,
    stability_figure,
)
from trajopt_cli.iiwa.report.forces import contact_figure, draw_paths, guided_figure, steps_figure, zeroing_figure
from trajopt_cli.iiwa.report.page import thinned
from trajopt_cli.report import style

H = 2e-3
START = np.array([0.5, 0.0, 0.6, 0.0, 0.0, 0.0])
FREE = np.array([-0.354, 0.707, 0.612])
K_GRID, D_GRID, M, PERIOD = np.r_[0, np.geomspace(1, 1e6, 31)], np.r_[0, np.geomspace(1, 1e6, 25)], 25.0, 1e-3
POINTS = [("cube", 1000.0, 500.0), ("by hand", 0.0, 100.0)]
PARTS = [("regulator", 3e-6, 4e-6, 9e-6), ("whole step", 4e-5, 5e-5, 1.6e-4)]


def run(label: str, seconds: float, *corners: tuple[float, ...], lag: float = 0.05, **more: np.ndarray) -> Following:
    """An equilibrium from corner to corner (offsets from START), and a controller a first-order lag [s] behind it."""
    n = round(seconds / H) + 1
    t = np.arange(n) * H
    places = np.array([np.pad(corner, (0, 6 - len(corner))) for corner in ((0,) * 3, *corners)])
    x_e = START + np.column_stack([np.interp(t, np.linspace(0, 0.8 * seconds, len(places)), c) for c in places.T])
    x = x_e.copy()
    for i in range(1, n):
        x[i] = x[i - 1] + H / lag * (x_e[i - 1] - x[i - 1])
    return Following(label, t, x_e, x, **more)


def box(label: str, seconds: float = 2.0, **more: np.ndarray) -> Following:
    return run(label, seconds, (0.2, 0, 0), (0.2, 0.2, 0), (0.2, 0.2, 0.2), (0, 0.2, 0.2), **more)


def pushed(label: str) -> Following:
    """Led by hand along x, then y, then z; the flange a little behind the controller."""
    t = np.arange(1501) * H
    force, x = np.zeros((len(t), 6)), np.tile(START, (len(t), 1))
    for i in range(6):
        on = (t > 0.5 * (i % 3)) & (t < 0.5 * (i % 3) + 0.4)
        force[on, i] = 10 - i
        x[:, i] += 0.1 * np.cumsum(on) * H
    return Following(label, t, np.tile(START, (len(t), 1)), x, force, np.vstack([x[:5], x[:-5]]))


def bumped() -> tuple[Following, np.ndarray]:
    t = np.arange(1001) * H
    depth = 1e-3 * np.clip(np.sin(2 * np.pi * t), 0, None) * ((t > 0.4) & (t < 1.6))
    x_e = START + np.outer(t / 10, [0, 1, 0, 0, 0, 0])
    force = np.outer(depth * 3e4, [0, -0.2, 1, 0, 0, 0])
    return Following("wall", t, x_e, x_e + np.outer(20 * depth, [0, 0, 1, 0, 0, 0]), force), depth


@cache
def verdicts() -> np.ndarray:
    """From the roots of the discrete law itself: 2 inside the unit circle, 1 simple on it, 0 beyond."""
    out = np.zeros((len(K_GRID), len(D_GRID)), dtype=int)
    for i, k in enumerate(K_GRID):
        for j, d in enumerate(D_GRID):
            step = np.array([[1 - PERIOD * d / M, -PERIOD * k / M], [PERIOD, 1]])
            most = np.abs(np.linalg.eigvals(step)).max()
            out[i, j] = 2 if most < 1 - 1e-12 else 1 if most <= 1 + 1e-12 and d > 0 else 0
    return out


def draw_all() -> dict[str, Figure]:
    """Every picture."""
    wall, depth = bumped()
    hand = pushed("k = 0")
    along = START + np.outer(hand.t / 10, np.r_[FREE, 0, 0, 0])
    passed = np.outer(hand.force @ np.r_[FREE, 0, 0, 0], [*FREE, 0, 0, 0])
    free = Following("k = 0", hand.t, np.tile(START, (len(hand.t), 1)), along, passed)
    phases = [("along x", 0.0, 0.45), ("along y", 0.5, 0.95), ("along z", 1.0, 1.45)]
    line = [run(label, s, (0.2, 0.2, 0.2)) for label, s in (("fast", 0.5), ("slow", 2.0))]
    with style.house_style():
        return {
            "following": following_figure(run("all six", 2.0, (0.1, 0.2, 0.05, 0.3, 0, 0.2)), "Following"),
            "speeds": family_figure([box("0.4", 1.0), box("0.2", 2.0), box("0.05", 8.0)], "speed v [m/s]", "Speeds"),
            "line": family_figure(line, "speed", "One line"),
            "dosing": family_figure([box("undosed", 1.0), box("dosed", 6.0), box("fed", 1.0)], "feed", "Dosing", 0.005),
            "contact": contact_figure(wall, depth, 2, "Collision"),
            "steps": steps_figure([("K = 100 N/m", hand), ("K = 500 N/m", pushed("b"))], (0, 1, 2, 3, 5), "Steps"),
            "hand": guided_figure(hand, phases, "Guided"),
            "zeroing": zeroing_figure(free, hand.force, FREE, "Zero"),
            "stability": stability_figure(K_GRID, D_GRID, {M: verdicts()}, PERIOD, M, POINTS, "Stability"),
            "loop_time": loop_time_figure(PARTS, 148e-6, "Loop"),
        }


@pytest.fixture(scope="module")
def pictures() -> dict[str, Figure]:
    return draw_all()


def curve(figure: Figure, name: str, column: int = 0) -> np.ndarray:
    lines = [line for axes in figure.axes for line in axes.lines if line.get_gid() == name]
    return np.array(lines[column].get_xydata(), dtype=float)


def curves(axes: Axes) -> dict[str, Line2D]:
    return {str(line.get_gid()): line for line in axes.lines if line.get_gid()}


def peaks(axes: Axes) -> np.ndarray:
    return np.array(curves(axes)["peak"].get_xydata())


def words(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts]


NAMES = ("following", "speeds", "line", "dosing", "contact", "steps", "hand", "zeroing", "stability",
         "loop_time")  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES)
def test_texts_are_legible_at_half_size_inside_the_page_and_apart(pictures: dict[str, Figure], name: str) -> None:
    figure = pictures[name]
    with style.house_style():
        figure.canvas.draw()
    ticks = [t for axes in figure.axes for t in (*axes.get_xticklabels(), *axes.get_yticklabels())]
    ticks += [t for axes in figure.axes if hasattr(axes, "get_zticklabels") for t in axes.get_zticklabels()]
    texts = [t for t in figure.findobj(Text) if t not in ticks and t.get_visible() and t.get_text().strip()]
    texts = [t for t in texts if not hasattr(t, "get_position_3d")]  # whose extent is where they were before projection
    page = figure.bbox.padded(1)
    boxes = [(text.get_text(), Text.get_window_extent(text)) for text in texts]
    assert [
        t for t, b in boxes if not (page.x0 <= b.x0 and b.x1 <= page.x1 and page.y0 <= b.y0 and b.y1 <= page.y1)
    ] == []
    assert min(text.get_fontsize() for text in texts) >= 10
    assert [(a, b) for (a, p), (b, q) in combinations(boxes, 2) if p.overlaps(q)] == []


def test_following_shows_the_given_and_marks_the_largest_deviation(pictures: dict[str, Figure]) -> None:
    shown = run("all six", 2.0, (0.1, 0.2, 0.05, 0.3, 0, 0.2))
    figure = pictures["following"]
    assert [axes.get_ylabel() for axes in figure.axes][:5] == ["x [mm]", "y [mm]", "z [mm]", "α [deg]", "γ [deg]"]
    for i, sign in ((0, "x"), (2, "z"), (3, "α")):
        factor = 1e3 if i < 3 else 180 / np.pi
        assert np.allclose(curve(figure, f"equilibrium {sign}"), np.column_stack([shown.t, shown.x_e[:, i] * factor]))
        assert np.allclose(curve(figure, f"controller {sign}"), np.column_stack([shown.t, shown.x[:, i] * factor]))
    d = 1e3 * np.sqrt(((shown.x - shown.x_e)[:, :3] ** 2).sum(axis=1))
    assert np.allclose(curve(figure, "d"), np.column_stack([shown.t, d]))
    panel = next(axes for axes in figure.axes if "d" in curves(axes))
    assert np.allclose(peaks(panel), [[shown.t[d.argmax()], d.max()]])
    assert panel.get_title(loc="right") == f"{number_of(d.max())} mm at {number_of(shown.t[d.argmax()])} s"


def test_a_path_in_one_plane_is_drawn_in_it_and_one_in_space_to_one_scale() -> None:
    flat, shown = run("flat", 1.0, (0.2, 0, 0), (0.2, 0, 0.1)), box("a box")
    drawn = []
    with style.house_style():
        for one in (flat, shown):
            drawn.append(style.new_figure(8.0, one.label))
            draw_paths(drawn[-1], [(one.x_e[:, :3], {}, "equilibrium"), (one.x[:, :3], {}, "controller")])
    (plane,), (space,) = (figure.axes for figure in drawn)
    assert (plane.get_xlabel(), plane.get_ylabel()) == ("x [mm]", "z [mm]")
    assert plane.get_aspect() == 1
    assert np.allclose(curves(plane)["controller"].get_xydata(), 1e3 * flat.x[:, [0, 2]])
    assert np.allclose(curves(plane)["start"].get_xydata(), 1e3 * flat.x_e[:1, [0, 2]])
    assert np.allclose(curves(plane)["end"].get_xydata(), 1e3 * flat.x_e[-1:, [0, 2]])
    assert np.allclose(in_space(space, "controller"), 1e3 * shown.x[:, :3])
    spans = np.ptp([space.get_xlim(), space.get_ylim(), space.get_zlim()], axis=1)  # type: ignore[attr-defined]
    assert np.allclose(space._box_aspect / spans, (space._box_aspect / spans)[0])  # type: ignore[attr-defined]


def in_space(axes: Axes, name: str) -> np.ndarray:
    return np.array(curves(axes)[name].get_data_3d()).T  # type: ignore[attr-defined]


def test_long_runs_are_thinned_and_keep_every_extreme() -> None:
    n = 240_000
    rng = np.random.default_rng(3)
    walk = np.cumsum(rng.standard_normal(n))
    rows = thinned(walk, bins=600)
    assert len(rows) <= 3 * 601 + 1
    stretch = (600 * np.arange(n) / (n - 1)).astype(int)
    for part in (0, 1, 299, 599):
        kept = walk[rows[stretch[rows] == part]]
        assert (kept.min(), kept.max()) == (walk[stretch == part].min(), walk[stretch == part].max())
    assert (rows[0], rows[-1]) == (0, n - 1)
    t, still = np.arange(n) * 1e-3, np.tile(START, (n, 1))
    x = still.copy()
    x[123_457, 1] += 0.03
    with style.house_style():
        figure = family_figure([Following("spike", t, still, x)], "one sample", "Spike")
    drawn = curve(figure, "d spike")
    assert len(drawn) < 5000
    assert drawn[drawn[:, 1].argmax()] == pytest.approx([123.457, 30.0])


def test_families_share_a_logarithmic_axis_where_durations_differ(pictures: dict[str, Figure]) -> None:
    (axes,) = pictures["speeds"].axes
    assert axes.get_xscale() == "symlog"  # from 0 on
    assert axes.get_xlim()[1] == pytest.approx(8.0)
    runs = [box("0.4", 1.0), box("0.2", 2.0), box("0.05", 8.0)]
    wanted = [(r.t[r.deviation.argmax()], 1e3 * r.deviation.max()) for r in runs]
    marked = [line.get_xydata()[0] for line in axes.lines if line.get_gid() == "peak"]
    assert np.allclose(marked, wanted)
    (legend,) = pictures["speeds"].legends
    assert [text.get_text() for text in legend.texts] == [
        f"{one.label}: at most {number_of(d)} mm" for one, (_, d) in zip(runs, wanted, strict=True)
    ]
    assert axes.get_xlim()[0] == 0
    assert pictures["line"].axes[0].get_xscale() == "linear"
    styles = {(line.get_color(), line.get_linestyle()) for name, line in curves(axes).items() if name != "peak"}
    assert len(styles) == 3


def test_dosing_draws_the_bound_and_far_over_it_a_logarithmic_axis(pictures: dict[str, Figure]) -> None:
    (axes,) = pictures["dosing"].axes
    assert [line.get_ydata()[0] for line in axes.lines if line.get_gid() is None] == pytest.approx([5.0])
    assert "bound 5 mm" in words(axes)
    assert axes.get_yscale() == "log"
    runs = [box("undosed", 1.0), box("dosed", 6.0), box("fed", 1.0)]
    marked = [line.get_ydata()[0] for line in axes.lines if line.get_gid() == "peak"]
    assert np.allclose(marked, [1e3 * r.deviation.max() for r in runs])


def test_contact_is_shaded_where_it_is_and_its_worst_marked(pictures: dict[str, Figure]) -> None:
    wall, depth = bumped()
    place, force, across = pictures["contact"].axes
    for axes in (place, force, across):
        (band,) = [c for c in axes.collections if c.get_gid() == "contact"]
        spans = [(p.vertices[:, 0].min(), p.vertices[:, 0].max()) for p in band.get_paths()]
        edges = np.flatnonzero(np.diff((depth > 0).astype(int)))
        assert np.allclose(spans, [(wall.t[a + 1], wall.t[b]) for a, b in edges.reshape(-1, 2)])
        assert len(spans) == 2
    i = int(np.argmax(np.abs(wall.x - wall.x_e)[:, 2]))
    assert np.allclose(peaks(place), [[wall.t[i], 1e3 * wall.x[i, 2]]])
    assert place.get_title(loc="right") == f"20 mm from the plan at {number_of(wall.t[i])} s"
    assert peaks(force)[0, 1] == pytest.approx(30.0)
    assert np.allclose(curves(across)["along y"].get_ydata(), -0.2 * 3e4 * depth)
    with style.house_style():
        smooth = Following("no friction", wall.t, wall.x_e, wall.x, wall.force * [0, 0, 1, 0, 0, 0])
        figure = contact_figure(smooth, np.zeros_like(depth), 2, "Free")
        dragged = contact_figure(wall, depth, 1, "Along the wall")
        lagging = wall.x.copy()
        lagging[:20, 2] += 0.05  # farther from the plan than the wall pushes, but nothing touches yet
        late = contact_figure(Following("late", wall.t, wall.x_e, lagging, wall.force), depth, 2, "Late")
    assert not np.any(depth[:20] > 0)
    assert np.allclose(peaks(late.axes[0]), [[wall.t[i], 1e3 * wall.x[i, 2]]])
    assert peaks(dragged.axes[1])[0, 1] == pytest.approx(-6.0)  # the largest is the one that pulls back
    assert dragged.axes[1].get_title(loc="right") == f"6 N at {number_of(wall.t[i])} s"
    assert "peak" not in curves(dragged.axes[0])
    assert len(figure.axes) == 2
    assert [c for axes in figure.axes for c in axes.collections if c.get_gid() == "contact"] == []


def test_steps_show_forces_over_answers_in_a_column_per_set(pictures: dict[str, Figure]) -> None:
    figure = pictures["steps"]
    hand = pushed("a")
    grid = np.array(figure.axes).reshape(4, 2)
    assert [row[0].get_ylabel() for row in grid] == ["force [N]", "torque [Nm]", "displacement [mm]", "turn [deg]"]
    assert [axes.get_title(loc="left") for axes in grid[0]] == ["K = 100 N/m", "K = 500 N/m"]
    for column in (0, 1):
        assert np.allclose(curves(grid[0, column])["force y"].get_ydata(), hand.force[:, 1])
        assert np.allclose(curves(grid[1, column])["force γ"].get_ydata(), hand.force[:, 5])
        assert "force β" not in curves(grid[1, column])
        assert np.allclose(curves(grid[2, column])["pose x"].get_ydata(), 1e3 * (hand.x - START)[:, 0])
        assert np.allclose(curves(grid[2, column])["flange x"].get_ydata(), 1e3 * (hand.true - START)[:, 0])
        assert peaks(grid[2, column])[0, 1] == pytest.approx(1e3 * np.abs((hand.x - START)[:, :3]).max())


def test_guided_draws_force_and_path_of_a_phase_in_one_colour(pictures: dict[str, Figure]) -> None:
    figure = pictures["hand"]
    hand = pushed("k = 0")
    during = (hand.t >= 0.5) & (hand.t <= 0.95)
    fx, fy, _, space = figure.axes
    assert np.allclose(curves(fy)["along y y"].get_xydata(), np.column_stack([hand.t, hand.force[:, 1]])[during])
    assert np.allclose(curves(fx)["along y x"].get_ydata(), 0)
    assert curves(fy)["along y y"].get_color() == curves(space)["along y"].get_color()
    colors = {curves(space)[name].get_color() for name in ("along x", "along y", "along z", "else")}
    assert len(colors) == 4
    assert hand.true is not None
    assert np.allclose(in_space(space, "along y"), 1e3 * hand.true[during, :3])


def test_zeroing_draws_the_free_axis_under_a_path_along_it(pictures: dict[str, Figure]) -> None:
    figure = pictures["zeroing"]
    before, after, space = figure.axes
    hand = pushed("a")
    assert np.allclose(curves(before)["before z"].get_ydata(), hand.force[:, 2])
    assert np.allclose(curves(after)["after x"].get_ydata(), hand.force[:, :3] @ FREE * FREE[0])
    a, b = in_space(space, "axis")
    for points in (b - a, a - 1e3 * START[:3]):
        assert np.linalg.norm(np.cross(points, FREE)) < 1e-3 * np.linalg.norm(points)
    path = in_space(space, "path")
    assert np.linalg.norm(b - a) > np.linalg.norm(path[-1] - path[0])
    assert any("leaves that axis by less than 0.001 mm" in text.get_text() for text in figure.texts)


def test_stability_limits_part_the_verdicts_and_points_stand_in_theirs(pictures: dict[str, Figure]) -> None:
    (axes,) = pictures["stability"].axes
    (whole,) = [mesh for mesh in axes.collections if str(mesh.get_gid()).startswith("verdicts")]
    drawn = np.array(whole.get_array()).T
    assert np.array_equal(drawn, verdicts()[1:, 1:])
    corners = np.array(whole.get_coordinates())
    assert (corners[0, :-1, 0] < K_GRID[1:]).all()
    assert (K_GRID[1:] < corners[0, 1:, 0]).all()
    lower, upper = (line for name, line in curves(axes).items() if name.startswith("h·"))
    assert np.allclose(lower.get_ydata(), PERIOD * np.array(lower.get_xdata()))
    assert np.interp(1e6, *np.array(upper.get_xydata()).T) == pytest.approx(2 * M / PERIOD + PERIOD * 1e6 / 2)
    # in the drawing itself: stable exactly between both lines
    low = np.interp(K_GRID[1:], *np.array(lower.get_xydata()).T, left=0)
    high = np.interp(K_GRID[1:], *np.array(upper.get_xydata()).T)
    between = (D_GRID[1:] > low[:, None] * (1 + 1e-6)) & (D_GRID[1:] < high[:, None])
    assert (drawn[between] == 2).all()
    outside = (D_GRID[1:] < low[:, None] * (1 - 1e-6)) | (D_GRID[1:] > high[:, None])
    assert (drawn[outside] != 2).all()
    assert curves(axes)["cube"].get_xydata()[0] == pytest.approx([1000, 500])
    assert curves(axes)["by hand"].get_xydata()[0] == pytest.approx([1, 100])  # k = 0: at the left edge


def test_loop_times_are_as_long_as_their_numbers(pictures: dict[str, Figure]) -> None:
    (axes,) = pictures["loop_time"].axes
    assert axes.get_xscale() == "log"
    ranges = [line.get_xdata() for line in axes.lines if line.get_gid() == "range"]
    assert np.allclose(ranges, [[3, 9], [40, 160]])
    assert [line.get_xdata()[0] for line in axes.lines if line.get_gid() == "mean"] == pytest.approx([4, 50])
    assert curves(axes)["thesis' worst 148 µs"].get_xdata()[0] == pytest.approx(148)


def test_the_same_input_gives_the_same_bytes(pictures: dict[str, Figure]) -> None:
    first = picture("contact", "Collision", partial(contact_figure, *bumped(), 2))
    assert set(first) == {"contact.svg", "contact.png"}
    with style.house_style():
        assert first == style.files("contact", pictures["contact"], "Collision")
    assert b"20 mm from the plan" in first["contact.svg"]
    assert first["contact.png"].startswith(b"\x89PNG")


def test_what_cannot_be_drawn_is_refused() -> None:
    with pytest.raises(ValueError, match="has no force to draw"):
        steps_figure([("K", box("a", 0.5))], (0,), "Steps")
    with pytest.raises(ValueError, match="shorter"):
        family_figure([box(f"{i}", 0.1) for i in range(9)], "speed", "More than there are styles")
