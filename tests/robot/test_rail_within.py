"""Where the rail may stand for a pose: every joint configuration's own rail position lies there."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.robot.model import load_robot, robot_names


@pytest.mark.parametrize("name", [name for name in robot_names() if name.endswith("_rail")])
def test_the_rail_stands_within_what_the_arm_can_span(name: str) -> None:
    robot, rng = load_robot(name), np.random.default_rng(12)
    q = rng.uniform(-np.pi, np.pi, (20_000, 7))
    q[:, 0] = rng.uniform(-3, 3, len(q))
    low, high = robot.rail_within(robot.forward(q)).T
    assert np.all((low <= q[:, 0] + 1e-12) & (q[:, 0] <= high + 1e-12))
    span = (high - low) / 2  # of the arm's length that is not needed aside
    assert np.max(np.maximum(q[:, 0] - low, high - q[:, 0]) / (2 * span)) > 0.9
