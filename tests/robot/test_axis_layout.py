"""Rail and arm in vectors of n axes, whatever n is."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.model import load_robot


@pytest.mark.parametrize(("name", "rail", "n"), [("irb140_rail", True, 7), ("irb140", False, 6)])
def test_a_robot_says_which_axes_are_the_rails_and_the_arms(name: str, rail: bool, n: int) -> None:
    robot = load_robot(name)
    layout = robot.layout
    assert (layout.n, layout.has_rail, layout.r, layout.joints) == (n, rail, int(rail), 6)
    assert robot.axis_names[layout.rail] == (("rail",) if rail else ())
    assert robot.axis_names[layout.arm] == tuple(f"joint_{i}" for i in range(1, 7))


@pytest.mark.parametrize("joints", [5, 6, 7])
def test_joining_and_taking_apart_undo_each_other(joints: int) -> None:
    rng = np.random.default_rng(1)
    arm, d = rng.normal(size=(4, 3, joints)), rng.normal(size=(4, 3))
    on_rail, alone = AxisLayout.rail_first(joints, True), AxisLayout.rail_first(joints, False)
    q = on_rail.join(d, arm)
    assert q.shape == (4, 3, joints + 1)
    np.testing.assert_array_equal(on_rail.place(q), d)
    np.testing.assert_array_equal(q[..., on_rail.arm], arm)
    np.testing.assert_array_equal(on_rail.join(0.7, arm)[..., 0], np.full((4, 3), 0.7))
    np.testing.assert_array_equal(alone.join(d, arm), arm)
    np.testing.assert_array_equal(alone.place(arm), np.zeros((4, 3)))
    np.testing.assert_array_equal(alone.value(np.zeros((4, 3, 0))), np.zeros((4, 3)))
