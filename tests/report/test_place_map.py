"""The map of cycle time over place: what is drawn where."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.tri import TriContourSet

from trajopt_cli.report.place import Spot, place_figure, place_map
from trajopt_cli.report.style import house_style

AXES = [("x", "mm", 1e3), ("yaw", "deg", 180 / np.pi)]
GRID = [(x, turn) for x in (-0.1, 0.0, 0.1, 0.2) for turn in (-0.2, 0.0, 0.2)]


def figure(spots: list[Spot], axes: list[tuple[str, str, float]], best: tuple[float, ...] | None) -> Figure:
    with house_style():
        return place_figure(spots, axes, best, "planned cycle", "tiny · the rail")


def drawn(made: Figure, name: str) -> np.ndarray:
    line = next(one for one in made.axes[0].lines if one.get_gid() == name)
    return np.column_stack([line.get_xdata(), line.get_ydata()])


def test_contours_end_where_nothing_can_be_done_and_places_are_marked_in_their_units() -> None:
    spots = [Spot(at, None if at[0] > 0.15 else 5 + at[0] ** 2 + at[1], True) for at in GRID]
    made = figure(spots, AXES, (0.1, -0.2))
    panel = made.axes[0]
    contours = next(one for one in panel.collections if isinstance(one, TriContourSet))
    reach = np.concatenate([path.vertices for path in contours.get_paths() if len(path.vertices)])
    assert reach[:, 0].max() == pytest.approx(100)
    assert reach[:, 0].min() == pytest.approx(-100)
    assert contours.zmin == pytest.approx(4.8)
    assert drawn(made, "present") == pytest.approx(np.array([[0.0, 0.0]]))
    assert drawn(made, "best") == pytest.approx(np.array([[100.0, -0.2 * 180 / np.pi]]))
    assert drawn(made, "impossible")[:, 0] == pytest.approx([200] * 3)
    assert panel.get_xlabel() == "x from the present place [mm]"
    assert panel.get_ylabel() == "yaw from the present place [deg]"


def test_one_range_is_a_curve_and_three_are_points() -> None:
    made = figure([Spot((x,), 5 + x, False) for x in (0.2, -0.1, 0.0)], AXES[:1], (-0.1,))
    assert drawn(made, "tried")[:, 0] == pytest.approx([-100, 0, 200])
    assert drawn(made, "best") == pytest.approx(np.array([[-100, 4.9]]))
    more = [*AXES, ("z", "mm", 1e3)]
    made = figure([Spot((*at, 0.1), 5.0, False) for at in GRID], more, None)
    assert not any(isinstance(one, TriContourSet) for one in made.axes[0].collections)
    assert "z differ from point to point" in made.texts[0].get_text()


@pytest.mark.parametrize("can", [0, 1, 2])
def test_few_places_are_drawn_too_and_always_as_the_same_bytes(can: int) -> None:
    spots = [Spot((x, 0.0), 5.0 if i < can else None, False) for i, x in enumerate((0.0, 0.1, 0.2))]
    with np.errstate(all="raise"):
        one, two = (place_map(spots, AXES, None, "planned cycle", "tiny", "rapid") for _ in range(2))
    assert list(one) == ["place_rapid.svg", "place_rapid.png"]
    assert one == two
