"""Pictures of the compliant controller: drawn data equal the given, limits and maxima stand where they are."""

from __future__ import annotations

from functools import cache
from itertools import combinations, pairwise

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text

from trajopt_cli.geometry import pose
from trajopt_cli.iiwa.report import pictures as compliance
from trajopt_cli.iiwa.report.arm import arm_figure
from trajopt_cli.iiwa.report.charts import STABLE, joints_figure
from trajopt_cli.iiwa.report.follow import family_figure, path_figure
from trajopt_cli.iiwa.report.forces import contact_figure
from trajopt_cli.iiwa.report.pictures import Following
from trajopt_cli.iiwa.report.runs import looked_at, number_of
from trajopt_cli.iiwa.report.space import View
from trajopt_cli.iiwa.report.thinning import thinned
from trajopt_cli.report import style
from trajopt_cli.shapes import Box, Capsule

H = 2e-3
START = np.array([0.5, 0.0, 0.6, 0.0, 0.0, 0.0])
FREE = np.array([-0.354, 0.707, 0.612])
K_GRID, D_GRID, M, PERIOD = np.r_[0, np.geomspace(1, 1e6, 31)], np.r_[0, np.geomspace(1, 1e6, 25)], 25.0, 1e-3
POINTS = [("cube", 1000.0, 500.0), ("by hand", 0.0, 100.0)]
TABLE = [("0.05 m/s", 0.043, 0.0433), ("1 m/s", 0.295, 0.306)]
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


def draw_all() -> dict[str, tuple[Figure, str]]:
    """Every picture through its public function."""
    done: dict[str, tuple[Figure, str]] = {}

    def keep(name: str, figure: Figure, title: str) -> dict[str, bytes]:
        assert name not in done
        done[name] = (figure, title)
        return {f"{name}.svg": b"", f"{name}.png": b""}

    wall, depth = bumped()
    hand = pushed("k = 0")
    along = START + np.outer(hand.t / 10, np.r_[FREE, 0, 0, 0])
    free = Following("k = 0", hand.t, np.tile(START, (len(hand.t), 1)), along)
    tall = np.deg2rad([170, 120, 170])
    t = np.arange(501) * H
    turns = np.column_stack([np.sin(t), 2.2 * np.sin(3 * t), t])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compliance, "files", keep)
        compliance.following(run("all six", 2.0, (0.1, 0.2, 0.05, 0.3, 0, 0.2), true=None), "Following")
        runs = [box("0.4", 1.0), box("0.2", 2.0), box("0.05", 8.0)]
        compliance.family(runs, "speed v [m/s]", "speeds", "Three speeds")
        line = [run(label, s, (0.2, 0.2, 0.2)) for label, s in (("fast", 0.5), ("slow", 2.0))]
        compliance.family(line, "speed", "line", "One line")
        compliance.dosing(box("undosed", 1.0), [box("dosed", 6.0), box("fed", 1.0)], 0.005, "Dosing")
        compliance.contact(wall, depth, 2, "Collision")
        compliance.steps([("K = 100 N/m", hand), ("K = 500 N/m", pushed("b"))], (0, 1, 2, 3, 5), "steps", "Steps")
        phases = [("along x", 0.0, 0.45), ("along y", 0.5, 0.95), ("along z", 1.0, 1.45)]
        compliance.guided(hand, phases, "hand", "Guided")
        compliance.zeroing(
            free, hand.force, np.outer(hand.force @ np.r_[FREE, 0, 0, 0], [*FREE, 0, 0, 0]), FREE, "Zero"
        )
        compliance.stability(K_GRID, D_GRID, verdicts(), M, PERIOD, POINTS, "Stability")
        compliance.table_bars(TABLE, "largest deviation", "mm", "table", "Table")
        compliance.loop_time(PARTS, 148e-6, "Loop")
        compliance.joints(t, turns, -tall, tall, np.deg2rad([98, 98, 100]), "Joints", delta=0.1 * t)
    return done


@pytest.fixture(scope="module")
def pictures() -> dict[str, tuple[Figure, str]]:
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


NAMES = ["following", "path", "speeds_deviation", "speeds_path", "line_deviation", "line_path", "dosing", "dosing_path",
         "contact", "steps", "hand", "zeroing", "stability", "table", "loop_time", "joints"]  # fmt: skip


def test_every_picture_is_there(pictures: dict[str, tuple[Figure, str]]) -> None:
    assert list(pictures) == NAMES
    assert all(title for _, title in pictures.values())


@pytest.mark.parametrize("name", NAMES)
def test_texts_are_legible_at_half_size_inside_the_page_and_apart(
    pictures: dict[str, tuple[Figure, str]], name: str
) -> None:
    figure = pictures[name][0]
    with style.house_style():
        figure.canvas.draw()
    ticks = [t for axes in figure.axes for t in (*axes.get_xticklabels(), *axes.get_yticklabels())]
    texts = [t for t in figure.findobj(Text) if t not in ticks and t.get_visible() and t.get_text().strip()]
    page = figure.bbox.padded(1)
    boxes = [(text.get_text(), Text.get_window_extent(text)) for text in texts]
    assert [
        t for t, b in boxes if not (page.x0 <= b.x0 and b.x1 <= page.x1 and page.y0 <= b.y0 and b.y1 <= page.y1)
    ] == []
    assert min(text.get_fontsize() for text in texts) >= 10
    assert [(a, b) for (a, p), (b, q) in combinations(boxes, 2) if p.overlaps(q)] == []


def test_following_shows_the_given_and_marks_the_largest_deviation(pictures: dict[str, tuple[Figure, str]]) -> None:
    shown = run("all six", 2.0, (0.1, 0.2, 0.05, 0.3, 0, 0.2))
    figure = pictures["following"][0]
    assert [axes.get_ylabel() for axes in figure.axes][:5] == ["x [mm]", "y [mm]", "z [mm]", "α [deg]", "γ [deg]"]
    for i, sign in ((0, "x"), (2, "z"), (3, "α")):
        factor = 1e3 if i < 3 else 180 / np.pi
        assert np.allclose(curve(figure, f"equilibrium {sign}"), np.column_stack([shown.t, shown.x_e[:, i] * factor]))
        assert np.allclose(curve(figure, f"controller {sign}"), np.column_stack([shown.t, shown.x[:, i] * factor]))
    d = 1e3 * np.sqrt(((shown.x - shown.x_e)[:, :3] ** 2).sum(axis=1))
    assert np.allclose(curve(figure, "d"), np.column_stack([shown.t, d]))
    panel = next(axes for axes in figure.axes if "d" in curves(axes))
    assert np.allclose(peaks(panel), [[shown.t[d.argmax()], d.max()]])
    assert words(panel) == [f"{number_of(d.max())} mm at {number_of(shown.t[d.argmax()])} s"]


def test_a_path_in_one_plane_is_drawn_in_it_and_one_in_space_to_one_scale() -> None:
    flat = run("flat", 1.0, (0.2, 0, 0), (0.2, 0, 0.1))
    with style.house_style():
        plane, space = path_figure(flat, "Flat"), path_figure(box("box"), "Box")
    assert (plane.axes[0].get_xlabel(), plane.axes[0].get_ylabel()) == ("x [mm]", "z [mm]")
    assert np.allclose(curve(plane, "controller"), 1e3 * flat.x[:, [0, 2]])
    assert np.allclose(peaks(plane.axes[0]), 1e3 * flat.x_e[[0, -1]][:, [0, 2]])
    shown, (axes,) = box("box"), space.axes
    page = curve(space, "controller")
    # parallel rays: one linear map takes all of space to the page, and the scales' numbers with it
    given = np.column_stack([1e3 * shown.x[:, :3], np.ones(len(shown.t))])
    way, *_ = np.linalg.lstsq(given, page, rcond=None)
    assert np.abs(given @ way - page).max() < 1e-6
    turned = way[:3]  # rows: x, y, z on the page; columns of a rotation's first two rows
    assert np.allclose(turned.T @ turned, np.eye(2), atol=1e-9)
    assert axes.get_aspect() == 1
    numbers = [(float(t.get_text().replace("−", "-")), np.array(t.xy)) for t in axes.texts if t.get_text()[0].isdigit()]
    steps = {tuple(np.round((b[1] - a[1]) / (b[0] - a[0]), 6)) for a, b in pairwise(numbers)}
    assert {tuple(np.round(row, 6)) for row in turned} <= steps


def test_long_runs_are_thinned_and_keep_every_extreme() -> None:
    n = 240_000
    rng = np.random.default_rng(3)
    walk = np.cumsum(rng.standard_normal(n))
    rows = thinned(walk, stretches=600)
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


def test_families_share_a_logarithmic_axis_where_durations_differ(pictures: dict[str, tuple[Figure, str]]) -> None:
    (axes,) = pictures["speeds_deviation"][0].axes
    assert axes.get_xscale() == "symlog"  # from 0 on
    assert axes.get_xlim()[1] == pytest.approx(8.0)
    runs = [box("0.4", 1.0), box("0.2", 2.0), box("0.05", 8.0)]
    wanted = [(r.t[r.deviation.argmax()], 1e3 * r.deviation.max()) for r in runs]
    assert np.allclose(peaks(axes), wanted)
    assert sorted(words(axes)) == sorted(f"{number_of(d)} mm" for _, d in wanted)
    assert axes.get_xlim()[0] == 0
    assert pictures["line_deviation"][0].axes[0].get_xscale() == "linear"
    styles = {(line.get_color(), line.get_linestyle()) for name, line in curves(axes).items() if name != "peak"}
    assert len(styles) == 3
    (space,) = pictures["speeds_path"][0].axes
    assert set(curves(space)) == {"equilibrium", "path 0.4", "path 0.2", "path 0.05", "peak"}


def test_on_one_line_the_lag_at_arrival_is_shown(pictures: dict[str, tuple[Figure, str]]) -> None:
    figure = pictures["line_path"][0]
    length = 200 * np.sqrt(3)
    for label, seconds in (("fast", 0.5), ("slow", 2.0)):
        shown = run(label, seconds, (0.2, 0.2, 0.2))
        arrival = round(0.8 * seconds / H)
        assert curve(figure, f"at {label}")[0, 0] == pytest.approx(length - 1e3 * shown.deviation[arrival])
        assert curve(figure, f"planned {label}")[1, 0] == pytest.approx(length)
    assert any(text.endswith("behind after 1.6 s") for text in words(figure.axes[0]))


def test_dosing_draws_the_bound_and_speeds_that_add_up_to_the_way(pictures: dict[str, tuple[Figure, str]]) -> None:
    above, below = pictures["dosing"][0].axes
    assert [line.get_ydata()[0] for line in above.lines if line.get_gid() is None] == pytest.approx([5.0])
    assert "bound 5 mm" in words(above)
    assert above.get_yscale() == "log"
    for label in ("undosed", "fed"):
        t, speed = np.array(curves(below)[f"speed {label}"].get_xydata()).T
        assert np.sum(np.diff(t)[::2] * speed[::2]) == pytest.approx(800, rel=1e-9)  # mm: four edges of 200
    assert np.median(curves(below)["speed dosed"].get_ydata()) == pytest.approx(800 / 4.8)
    runs = [box("undosed", 1.0), box("dosed", 6.0), box("fed", 1.0)]
    assert np.allclose(peaks(above)[:, 1], [1e3 * r.deviation.max() for r in runs])


def test_contact_is_shaded_where_it_is_and_its_worst_marked(pictures: dict[str, tuple[Figure, str]]) -> None:
    wall, depth = bumped()
    place, force, across = pictures["contact"][0].axes
    for axes in (place, force, across):
        (band,) = [c for c in axes.collections if c.get_gid() == "contact"]
        spans = [(p.vertices[:, 0].min(), p.vertices[:, 0].max()) for p in band.get_paths()]
        edges = np.flatnonzero(np.diff((depth > 0).astype(int)))
        assert np.allclose(spans, [(wall.t[a + 1], wall.t[b]) for a, b in edges.reshape(-1, 2)])
        assert len(spans) == 2
    i = int(np.argmax(np.abs(wall.x - wall.x_e)[:, 2]))
    assert np.allclose(peaks(place), [[wall.t[i], 1e3 * wall.x[i, 2]]])
    assert words(place) == [f"tool 20 mm from the plan at {number_of(wall.t[i])} s"]
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
    assert words(dragged.axes[1]) == [f"6 N at {number_of(wall.t[i])} s"]
    assert "peak" not in curves(dragged.axes[0])
    assert len(figure.axes) == 2
    assert [c for axes in figure.axes for c in axes.collections if c.get_gid() == "contact"] == []


def test_steps_show_forces_over_answers_in_a_column_per_set(pictures: dict[str, tuple[Figure, str]]) -> None:
    figure = pictures["steps"][0]
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


def test_guided_draws_force_and_path_of_a_phase_in_one_colour(pictures: dict[str, tuple[Figure, str]]) -> None:
    figure = pictures["hand"][0]
    hand = pushed("k = 0")
    during = (hand.t >= 0.5) & (hand.t <= 0.95)
    fx, fy, _, space = figure.axes
    assert np.allclose(curves(fy)["along y y"].get_xydata(), np.column_stack([hand.t, hand.force[:, 1]])[during])
    assert np.allclose(curves(fx)["along y x"].get_ydata(), 0)
    assert curves(fy)["along y y"].get_color() == curves(space)["along y"].get_color()
    colors = {curves(space)[name].get_color() for name in ("along x", "along y", "along z", "else")}
    assert len(colors) == 4
    view = View([hand.true[:, :3]])
    assert np.allclose(curves(space)["along y"].get_xydata(), view(hand.true[during, :3]))


def test_zeroing_draws_the_free_axis_under_a_path_along_it(pictures: dict[str, tuple[Figure, str]]) -> None:
    figure = pictures["zeroing"][0]
    before, after, space = figure.axes
    hand = pushed("a")
    assert np.allclose(curves(before)["before z"].get_ydata(), hand.force[:, 2])
    assert np.allclose(curves(after)["after x"].get_ydata(), hand.force[:, :3] @ FREE * FREE[0])
    view = View([START[:3] + np.outer([0.0, 1.0], FREE)])
    way = view(START[:3] + FREE) - view(START[:3])
    a, b = np.array(curves(space)["axis"].get_xydata())
    for points in (b - a, a - view(START[:3])):
        assert abs(points[0] * way[1] - points[1] * way[0]) < 1e-6 * np.linalg.norm(way) * np.linalg.norm(points)
    path = np.array(curves(space)["path"].get_xydata())
    assert np.linalg.norm(b - a) > np.linalg.norm(path[-1] - path[0])
    assert any("leaves that axis by less than 0.001 mm" in text.get_text() for text in figure.texts)


def test_stability_limits_part_the_verdicts_and_points_stand_in_theirs(pictures: dict[str, tuple[Figure, str]]) -> None:
    (axes,) = pictures["stability"][0].axes
    meshes = [mesh for mesh in axes.collections if mesh.get_gid() == "verdicts"]
    assert len(meshes) == 4  # a strip for k = 0, one for d = 0, their corner and the map itself
    whole = max(meshes, key=lambda mesh: np.size(mesh.get_array()))
    drawn = np.array(whole.get_array()).T
    assert np.array_equal(drawn, verdicts()[1:, 1:])
    corners = np.array(whole.get_coordinates())
    middles = np.sqrt(corners[:-1, :-1] * corners[1:, 1:]).transpose(1, 0, 2)
    assert np.allclose(middles[..., 0], K_GRID[1:, None], rtol=1e-6)
    lower, upper = curves(axes)["h·k = d"], curves(axes)["h·d/m = 2 + h²·k/(2m)"]
    assert np.allclose(lower.get_ydata(), PERIOD * np.array(lower.get_xdata()))
    assert np.interp(1e6, *np.array(upper.get_xydata()).T) == pytest.approx(2 * M / PERIOD + PERIOD * 1e6 / 2)
    # in the drawing itself: stable exactly between both lines
    low = np.interp(K_GRID[1:], *np.array(lower.get_xydata()).T, left=0)
    high = np.interp(K_GRID[1:], *np.array(upper.get_xydata()).T)
    between = (D_GRID[1:] > low[:, None] * (1 + 1e-6)) & (D_GRID[1:] < high[:, None])
    assert (drawn[between] == STABLE).all()
    outside = (D_GRID[1:] < low[:, None] * (1 - 1e-6)) | (D_GRID[1:] > high[:, None])
    assert (drawn[outside] != STABLE).all()
    (cube, hand) = (line.get_xydata()[0] for line in reversed(axes.lines) if line.get_gid() == "peak")
    assert cube == pytest.approx([1000, 500])
    strip = next(mesh for mesh in meshes if np.shape(mesh.get_array()) == (len(D_GRID) - 1, 1))
    edges = np.array(strip.get_coordinates())[0, :, 0]
    assert edges[0] < hand[0] < edges[1] < np.array(whole.get_coordinates())[0, 0, 0]
    assert set(np.unique(strip.get_array())) == {0, 1}
    (name,) = [text for text in axes.texts if text.get_text() == "by hand"]
    left = Text.get_window_extent(name).x0
    assert left > axes.transData.transform((np.array(whole.get_coordinates())[0, 0, 0], 1))[0]  # beside the strip


def test_tables_and_loop_times_are_as_long_as_their_numbers(pictures: dict[str, tuple[Figure, str]]) -> None:
    (axes,) = pictures["table"][0].axes
    assert [bar.get_width() for bar in axes.patches] == pytest.approx([43, 43.3, 295, 306])
    assert words(axes) == ["43", "43.3   +0.7 %", "295", "306   +3.7 %"]
    (axes,) = pictures["loop_time"][0].axes
    assert axes.get_xscale() == "log"
    ranges = [line.get_xdata() for line in axes.lines if line.get_gid() == "range"]
    assert np.allclose(ranges, [[3, 9], [40, 160]])
    assert [line.get_xdata()[0] for line in axes.lines if line.get_gid() == "mean"] == pytest.approx([4, 50])
    assert curves(axes)["thesis' worst 148 µs"].get_xdata()[0] == pytest.approx(148)
    assert curves(axes)["period 1 ms"].get_xdata()[0] == pytest.approx(1000)


def test_joints_stand_between_their_limits_and_say_where_they_do_not(pictures: dict[str, tuple[Figure, str]]) -> None:
    figure = pictures["joints"][0]
    t = np.arange(501) * H
    position, speed = figure.axes[2], figure.axes[3]  # joint 2: 126 deg of 120, 378 deg/s of 98
    assert np.allclose(curves(position)["q 2"].get_ydata(), np.rad2deg(2.2 * np.sin(3 * t)))
    steps = np.array(curves(speed)["speed 2"].get_ydata())[::2]
    assert np.allclose(steps, np.rad2deg(np.diff(2.2 * np.sin(3 * t)) / H))
    for axes, limit in ((position, 120), (speed, 98)):
        assert sorted(line.get_ydata()[0] for line in axes.lines if not line.get_gid()) == pytest.approx(
            [-limit, limit]
        )
    assert words(position) == ["6.05° beyond"]
    assert position.texts[0].get_color() == speed.texts[0].get_color() == style.VERMILLION
    assert figure.axes[0].texts[0].get_color() == style.GREY
    assert np.allclose(curve(figure, "arm angle")[:, 1], np.rad2deg(0.1 * t))
    with style.house_style():
        fixed = joints_figure(t, t[:, None], [-2], [2], [2], "Fixed", delta=np.full(501, 0.3))
    assert len(fixed.axes) == 2


def test_links_are_drawn_as_wide_as_they_are_and_boxes_by_the_faces_that_are_seen() -> None:
    shown = pushed("tool")
    links = [Capsule("upper", np.array([0.0, 0, 0.3]), np.array([0.1, 0.1, 0.7]), 0.08)]
    links.append(Capsule("ball", np.array([0.5, 0.0, 0.6]), np.array([0.5, 0.0, 0.6]), 0.05))
    table = Box("table", np.array([0.4, 0.3, 0.1]), pose(np.eye(3), [0.5, 0.0, 0.2]))
    with style.house_style():
        figure = arm_figure(shown, [("now", links), ("then", links[:1])], [table], "Arm")
    (axes,) = figure.axes
    drawn = [patch for patch in axes.patches if patch.get_gid()]
    assert [patch.get_gid() for patch in drawn].count("table") == 3
    # the shade of another moment lies under all that is solid
    assert min(drawn, key=lambda patch: patch.get_zorder()).get_gid() == "then upper"
    eye = np.radians([-56.0, 26.0])
    across = np.array([-np.sin(eye[0]), np.cos(eye[0]), 0.0])
    up = np.array([-np.sin(eye[1]) * np.cos(eye[0]), -np.sin(eye[1]) * np.sin(eye[0]), np.cos(eye[1])])
    for link in links:
        (patch,) = [one for one in drawn if one.get_gid() == f"now {link.name}"]
        edge = np.array(patch.get_xy())
        a, b = (1e3 * np.array([across @ end, up @ end]) for end in (link.a, link.b))
        share = np.clip((edge - a) @ (b - a) / max((b - a) @ (b - a), 1e-9), 0.0, 1.0)
        off = np.linalg.norm(edge - a - share[:, None] * (b - a), axis=1)
        assert np.allclose(off, 1e3 * link.radius)
        for way in (np.eye(2)[0], np.eye(2)[1], -np.eye(2)[0], -np.eye(2)[1]):
            reach = max(float(a @ way), float(b @ way)) + 1e3 * link.radius
            assert float((edge @ way).max()) == pytest.approx(reach, rel=5e-3)
    assert len({text.get_text() for text in figure.findobj(Text)} & {"now", "then", "obstacle", "tool"}) == 4
    with pytest.raises(ValueError, match="4 moments, wanted 1 to 3"):
        arm_figure(shown, [("now", links)] * 4, [], "Arm")


def test_the_same_input_gives_the_same_bytes(pictures: dict[str, tuple[Figure, str]]) -> None:
    first = compliance.contact(*bumped(), 2, "Collision")
    first |= compliance.stability(K_GRID, D_GRID, verdicts(), M, PERIOD, POINTS, "Stability")
    assert set(first) == {f"{n}.{kind}" for n in ("contact", "stability") for kind in ("svg", "png")}
    with style.house_style():
        assert first == style.files("contact", *pictures["contact"]) | style.files("stability", *pictures["stability"])
    assert b"20 mm from the plan" in first["contact.svg"]
    assert first["stability.png"].startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"x": np.zeros((4, 6))}, r"Following a: x has shape \(4, 6\), wanted \(3, 6\) of finite numbers"),
        ({"x_e": np.full((3, 6), np.nan)}, r"x_e has shape \(3, 6\), wanted"),
        ({"t": np.array([0.0, 0.2, 0.2])}, "t has 3 samples, wanted at least two that grow"),
        ({"force": np.zeros(3)}, r"force has shape \(3,\)"),
    ],
)
def test_runs_that_do_not_fit_are_refused(change: dict[str, np.ndarray], message: str) -> None:
    fits = {"t": np.arange(3.0), "x_e": np.zeros((3, 6)), "x": np.zeros((3, 6))}
    with pytest.raises(ValueError, match=message):
        Following("a", **{**fits, **change})


def test_what_cannot_be_drawn_is_said() -> None:
    shown = box("a", 0.5)
    with pytest.raises(ValueError, match="Following a has no force to draw"):
        compliance.steps([("K", shown)], (0,), "steps", "Steps")
    with pytest.raises(ValueError, match="different labels apart"):
        compliance.family([shown, shown], "speed", "speeds", "Twice")
    with pytest.raises(ValueError, match=r"verdict has shape \(2, 2\), wanted \(32, 26\)"):
        compliance.stability(K_GRID, D_GRID, np.zeros((2, 2)), M, PERIOD, [], "Map")
    with pytest.raises(ValueError, match=r"regulator has 2\.0, 1\.0, 3\.0 s"):
        compliance.loop_time([("regulator", 2.0, 1.0, 3.0)], 1e-4, "Loop")
    with pytest.raises(ValueError, match="0 rows in mm"):
        compliance.table_bars([], "d", "mm", "table", "Table")
    with pytest.raises(ValueError, match="read-only"):
        looked_at(np.zeros(3), (3,), "view")[0] = 1.0
