"""What planning asks of a robot, asked of every six-axis robot that ships; pin is the second opinion."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from places import ARMS

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.robot.model import RobotModel, load_robot


@pytest.fixture(scope="module", params=ARMS)
def robot(request: pytest.FixtureRequest) -> RobotModel:
    return load_robot(request.param)


def some_axes(robot: RobotModel, n: int) -> Array:
    """Axes (n, k) within limits and away from the walls; the rail in 0..1 m."""
    rng, limits = np.random.default_rng(3), robot.profile()
    low, high = limits.lower[robot.layout.arm], limits.upper[robot.layout.arm]
    arm = rng.uniform(low, high, (8 * n, robot.layout.joints))
    elbow, wrist = robot.singularity_margins(arm)
    arm = arm[(elbow < 0.9) & (wrist > 0.2)][:n]
    assert len(arm) == n
    return robot.layout.join(rng.uniform(0, 1, n), arm)


def pin_pose(robot: RobotModel, q: Array) -> Array:
    data = robot.pin_model.createData()
    pin.framesForwardKinematics(robot.pin_model, data, q)
    return data.oMf[robot.pin_model.getFrameId("tool0")].homogeneous


def test_every_axis_has_a_name_and_no_turn_is_tried_first(robot: RobotModel) -> None:
    assert robot.layout.n == len(robot.axis_names)
    assert not np.any(robot.turns[0])


def test_the_branches_of_a_pose_hold_the_joints_it_came_from(robot: RobotModel) -> None:
    if not robot.closed_form:
        pytest.skip("branches that are sought step by step have tests of their own: test_offset_wrist.py")
    for q in some_axes(robot, 8):
        X, rail = pin_pose(robot, q), robot.layout.place(q)
        branches = robot.branches(X[None], rail[None])[0]
        away = np.abs(np.sin((branches - q[robot.layout.arm]) / 2)).max(axis=1)
        assert np.nanmin(away) < 1e-9
        limits = robot.profile()
        found = robot.solutions(X, float(rail), limits)
        assert any(np.allclose(arm, q[robot.layout.arm], atol=1e-8) for _, arm in found)
        assert all(robot.admits(robot.confdata(arm), arm) for _, arm in found)


def test_expressions_say_what_pin_says(robot: RobotModel) -> None:
    if not robot.closed_form:
        pytest.skip("its inverse has no expression")
    symbol = ca.SX.sym("q", robot.layout.n)
    flange = ca.Function("flange", [symbol], [*robot.expressions.flange(symbol)])
    p, R = ca.SX.sym("p", 3), ca.SX.sym("R", 3, 3)
    branch, near = ca.SX.sym("branch", 3), ca.SX.sym("near", robot.layout.joints)
    inverse = ca.Function("inverse", [p, R, branch, near], [*robot.expressions.inverse(p, R, branch, near)])
    for q in some_axes(robot, 20):
        X, arm = pin_pose(robot, q), q[robot.layout.arm]
        position, rotation = flange(q)
        np.testing.assert_allclose(np.ravel(position), X[:3, 3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(rotation, X[:3, :3], rtol=0, atol=1e-12)
        rail = robot.layout.place(q)
        number = int(np.nanargmin(np.abs(np.sin((robot.branches(X[None], rail[None])[0] - arm) / 2)).sum(axis=1)))
        X_BF = inverse_pose(robot.base(rail)) @ X
        joints, elbow, wrist = inverse(X_BF[:3, 3], X_BF[:3, :3], robot.expressions.branch(number), arm + 0.5)
        np.testing.assert_allclose(np.ravel(joints), arm, rtol=0, atol=1e-9)
        assert (np.abs(elbow).max(), float(wrist)) == pytest.approx(robot.singularity_margins(arm), abs=1e-9)


def test_the_jacobian_is_the_slope_of_pins_poses(robot: RobotModel) -> None:
    h = 1e-6
    for q in some_axes(robot, 5):
        J = robot.jacobian(q)
        for j in range(robot.layout.n):
            step = np.eye(robot.layout.n)[j] * h
            slope = (pin_pose(robot, q + step) - pin_pose(robot, q - step)) / (2 * h)
            np.testing.assert_allclose(J[:3, j], slope[:3, 3], rtol=0, atol=1e-7)
            spin = slope[:3, :3] @ pin_pose(robot, q)[:3, :3].T
            np.testing.assert_allclose(J[3:, j], [spin[2, 1], spin[0, 2], spin[1, 0]], rtol=0, atol=1e-7)
