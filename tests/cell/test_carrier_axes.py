"""The cell file's linear axes under the base: what is read, what is refused and where."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli.export import _begins
from trajopt_cli.errors import InputError
from trajopt_cli.exporters.egm import stream_of
from trajopt_cli.exporters.recorded import Recorded
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.trajectory import Trajectory

GANTRY = """robot: irb140
base: {position: [0, 0, 3], rpy: ["180 deg", 0, 0]}
axes:
  eax_c: {axis: [0, 0, 2], stroke: [-0.2, 0.5]}
  eax_a: {axis: [1, 0, 0], stroke: [-0.2, 1.2]}
  eax_f: {follows: eax_a, ratio: -2, offset: 0.1, stroke: [-1.1, 0.2], velocity: 1, source: drive}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: [0.5, 0.1]}
"""


def plant(text: str = GANTRY) -> Plant:
    return build_plant(parse_cell(text, "cell.yaml"))


def test_axes_come_by_their_letters_and_stand_in_the_world() -> None:
    gantry = plant()
    assert gantry.limits.names[:3] == ("rail_a", "rail_c", "joint_1")
    assert gantry.rail_eaxes == (0, 2)
    np.testing.assert_allclose(gantry.robot.rail_axes_W, [[1, 0, 0], [0, 0, 1]], atol=1e-12)
    np.testing.assert_allclose(gantry.start[:2], [0.5, 0.1])
    np.testing.assert_allclose(gantry.robot.base(gantry.start[:2])[:3, 3], [0.5, 0, 3.1], atol=1e-12)


def test_what_follows_holds_its_leader_back() -> None:
    limits = plant().limits
    # f = 0.1 - 2 a within [-1.1, 0.2] and at 1 m/s: a within [-0.05, 0.6] and at 0.5 m/s
    np.testing.assert_allclose([limits.lower[0], limits.upper[0], limits.velocity[0]], [-0.05, 0.6, 0.5])


def test_targets_say_all_axes_and_what_follows() -> None:
    gantry = plant()
    open_ = (None,) * 6
    assert gantry.with_rail(open_, np.array([0.4, 0.2])) == pytest.approx((400, None, 200, None, None, -700))
    before = np.array([0.1, 0.3])
    np.testing.assert_allclose(gantry.rail_after((400, None, None, None, None, None), before), [0.4, 0.3])
    assert gantry.rail_value(open_) is None


def test_one_axis_alone_is_the_rail() -> None:
    one = plant(GANTRY.replace("  eax_c: {axis: [0, 0, 2], stroke: [-0.2, 0.5]}\n", "").replace("[0.5, 0.1]", "0.5"))
    assert one.limits.names[0] == "rail"
    assert one.layout.r == 1


def test_places_that_are_not_told_are_zero() -> None:
    text = GANTRY.replace(", rail: [0.5, 0.1]", "")
    np.testing.assert_array_equal(plant(text).start[:2], [0, 0])


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("axis: [1, 0, 0]", "axis: [0, 0, 0]", "axes.eax_a.axis"),
        ("axis: [1, 0, 0], ", "", "axes.eax_a"),
        ("stroke: [-0.2, 1.2]", "stroke: [1.2, -0.2]", "axes.eax_a.stroke"),
        ("stroke: [-0.2, 1.2]", "stroke: [-200, 1200]", "axes.eax_a.stroke"),
        ("follows: eax_a", "follows: eax_b", "axes.eax_f.follows"),
        ("follows: eax_a", "follows: eax_f", "axes.eax_f.follows"),
        ("ratio: -2", "ratio: 0", "axes.eax_f"),
        ("stroke: [-1.1, 0.2]", "stroke: [10, 11]", "axes.eax_f.stroke"),
        (", source: drive", "", "axes.eax_f"),
        ("  eax_c:", "  z:", "axes.z"),
        ("rail: [0.5, 0.1]", "rail: 0.5", "start.rail"),
        ("rail: [0.5, 0.1]", "rail: [0.9, 0.1]", "start.rail"),
        ("axes:\n", "rail: {eax: b, stroke: [0, 1]}\naxes:\n", "rail"),
        ("start:", "rail_at: {pA: 0.1}\nstart:", "rail_at"),
        (
            "axes:\n",
            "axes:\n  eax_b: {axis: [0, 1, 0], stroke: [0, 1]}\n  eax_d: {axis: [0, 1, 0], stroke: [0, 1]}\n",
            "axes",
        ),
    ],
)  # fmt: skip
def test_a_mistake_is_placed(old: str, new: str, key: str) -> None:
    text = GANTRY.replace(old, new, 1)
    with pytest.raises(InputError) as said:
        plant(text)
    assert str(said.value).startswith("cell.yaml:")
    assert said.value.message.startswith(f"{key}:")
    name = key.rpartition(".")[2]
    assert said.value.line is not None
    told = text.splitlines()[said.value.line - 1]
    assert name in told or key.split(".")[-2] in told


def test_a_rails_direction_is_seen_from_the_arm() -> None:
    text = 'robot: irb140_rail\nrail: {eax: a, stroke: [0, 1], direction: [0, -1, 0], frame: {rpy: [0, 0, "90 deg"]}}\n'
    robot = plant(text + 'start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}\n').robot
    np.testing.assert_allclose(robot.rail_axes_W, [[1, 0, 0]], atol=1e-12)


def test_where_a_motion_begins_tells_every_axis_in_its_unit() -> None:
    names = ("rail_a", "rail_c", *(f"joint_{i}" for i in range(1, 7)))
    rows = Trajectory(names, np.array([0.0, 1.0]), np.tile([0.5, 0.1, 0, 0, 0, 0, np.pi / 6, 0], (2, 1)))
    assert _begins(rows).startswith("begins at rail_a 0.5000 m, rail_c 0.1000 m, joints 0.00 0.00 0.00 0.00 30.00 0.00")


def test_egm_has_every_axis_in_the_place_of_its_letter() -> None:
    names = ("rail_a", "rail_c", *(f"joint_{i}" for i in range(1, 7)))
    rows = np.tile([0.5, 0.1, 0, 0, 0, 0, 0, 0], (2, 1))
    stream = stream_of(Recorded("m", Trajectory(names, np.array([0.0, 0.1]), rows, np.zeros((2, 8)))))
    np.testing.assert_allclose(stream.q[0], [0, 0, 0, 0, 0, 0, 500, 0, 100])


def test_a_follower_has_the_place_of_its_letter_too() -> None:
    names = ("rail_a", "rail_c", *(f"joint_{i}" for i in range(1, 7)))
    rows = Trajectory(names, np.array([0.0, 0.1]), np.tile([0.5, 0.1, 0, 0, 0, 0, 0, 0], (2, 1)), np.full((2, 8), 0.1))
    led = plant(GANTRY).with_followers(rows)
    assert led.names[:4] == ("rail_a", "rail_f", "rail_c", "joint_1")
    stream = stream_of(Recorded("m", led))
    np.testing.assert_allclose(stream.q[0], [0, 0, 0, 0, 0, 0, 500, 0, 100, 0, 0, -900], atol=1e-9)
    np.testing.assert_allclose(stream.qd[0, 6:], [100, 0, 100, 0, 0, -200], atol=1e-9)
