"""Where the rail may stand for a pose: every joint configuration's own rail position lies there."""

from __future__ import annotations

from math import hypot
from pathlib import Path

import numpy as np
import pytest
from arms import KNOWN, OFFSET_WRISTS, on_rail, random_pose

from trajopt_cli.geometry import pose
from trajopt_cli.robot.model import load_robot, robot_names

LONGEST = {
    "irb4600": 0.175 + 1.095 + hypot(0.175, 1.27) + 0.135,
    "irb1200": 0.448 + hypot(0.042, 0.451) + 0.082,
    "puma560": hypot(0.4318 + hypot(0.0203, 0.4318), 0.1501) + 0.056,
    "gofa": 0.444 + hypot(0.110, 0.470) + 0.080 + 0.101,
    "crx": 0.710 + 0.540 + 0.150 + 0.160,
}
"""Of arms by their data sheets, from where axis 2's height is on axis 1 to the flange [m]."""
HEIGHT = {"irb4600": 0.495, "irb1200": 0.3991, "puma560": 0.0, "gofa": 0.265, "crx": 0.245}


@pytest.mark.parametrize("name", [name for name in robot_names() if name.endswith("_rail")])
def test_the_rail_stands_within_what_the_arm_can_span(name: str) -> None:
    robot, rng = load_robot(name), np.random.default_rng(12)
    q = rng.uniform(-np.pi, np.pi, (20_000, 7))
    q[:, 0] = rng.uniform(-3, 3, len(q))
    low, high = robot.rail_within(robot.forward(q)).T
    assert np.all((low <= q[:, 0] + 1e-12) & (q[:, 0] <= high + 1e-12))
    span = (high - low) / 2  # of the arm's length that is not needed aside
    assert np.max(np.maximum(q[:, 0] - low, high - q[:, 0]) / (2 * span)) > 0.9


@pytest.mark.parametrize("name", LONGEST)
def test_at_both_ends_the_arm_would_be_stretched(name: str, tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    robot = on_rail((KNOWN | OFFSET_WRISTS)[name](), "oblique").load(tmp_path, random_pose(rng))
    shoulder = robot.X_WB0 @ np.array([0, 0, HEIGHT[name], 1.0])
    X = np.array([pose(random_pose(rng)[:3, :3], shoulder[:3] + rng.uniform(-1.4, 1.4, 3)) for _ in range(60)])
    ends = robot.rail_within(X)
    at = shoulder[:3] + ends[..., None] * robot.rail_axes_W[0]
    away = np.linalg.norm(X[:, None, :3, 3] - at, axis=-1)
    reached = ends[:, 1] > ends[:, 0]
    np.testing.assert_allclose(away[reached], LONGEST[name], rtol=0, atol=1e-9)
    assert reached.sum() > 10
    assert np.all(away[~reached] >= LONGEST[name] - 1e-12)
    square = np.sum((X[~reached, :3, 3] - at[~reached, 0]) * robot.rail_axes_W[0], axis=-1)
    np.testing.assert_allclose(square, 0, rtol=0, atol=1e-12)
    fixed = (KNOWN | OFFSET_WRISTS)[name]().load(tmp_path, name="fixed")
    np.testing.assert_array_equal(fixed.rail_within(X), np.zeros((60, 2)))
