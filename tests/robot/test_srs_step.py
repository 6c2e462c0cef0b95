"""One sample in plain floats against the vectorised functions, on straight and crooked mountings and tools."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from places import crooked_pose

from trajopt_cli.geometry import inverse_pose
from trajopt_cli.robot.srs import SrsLengths, load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle, configuration, inverse_branch
from trajopt_cli.robot.srs_step import SrsStep

BOTH = pytest.mark.parametrize("definition", list(ArmAngle))
PLACES = pytest.mark.parametrize(
    ("X_WB", "X_FT"),
    [(None, None), (crooked_pose(1), crooked_pose(2)), (None, crooked_pose(3)), (crooked_pose(4), None)],
)


def floats(X):
    return tuple(X[:3, :3].ravel().tolist()), tuple(X[:3, 3].tolist())


@BOTH
@PLACES
def test_joints_forward_and_jacobian_equal_the_vectorised(X_WB, X_FT, definition, rng):
    robot = load_srs("iiwa7", X_WB)
    limits = robot.profile()
    q = rng.uniform(limits.lower, limits.upper, (100, 7))
    X_WT = robot.forward(q) if X_FT is None else robot.forward(q) @ X_FT
    X_WF = X_WT if X_FT is None else X_WT @ inverse_pose(X_FT)
    J = robot.jacobian(q, X_FT)
    own, psi = configuration(q), arm_angle(robot, q, definition)
    for i in range(100):
        for branch in {int(own[i]), i % 8}:
            step = SrsStep(robot, definition, branch, float(psi[i]), X_FT)
            found = step.joints(*floats(X_WT[i]))
            wanted = inverse_branch(robot, X_WF[i : i + 1], psi[i], definition, branch)[0]
            near = min(float(np.abs(np.sin(wanted[1::2])).min()), 0.1)  # of a singularity
            np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-14 / near**2)
        R, p = step.forward(tuple(q[i].tolist()))
        np.testing.assert_allclose(np.reshape(R, (3, 3)), X_WT[i, :3, :3], rtol=0, atol=1e-14)
        np.testing.assert_allclose(p, X_WT[i, :3, 3], rtol=0, atol=1e-14)
        np.testing.assert_allclose(step.jacobian(tuple(q[i].tolist())), J[i], rtol=0, atol=1e-14)


@BOTH
@pytest.mark.parametrize("posture", range(5))
def test_singular_postures_are_those_of_the_vectorised(posture, definition):
    robot = load_srs("iiwa7")
    q = np.array([0.3, 0.6, 0.4, 1.2, 0.7, -0.9, 1.0])
    for i in ([1], [3], [5], [1, 3, 5], [2])[posture]:
        q[i] = 0.0
    if posture == 4:
        q[1] = q[3] / 2  # the wrist centre on axis 1
    X, psi = robot.forward(q), float(arm_angle(robot, q, definition))
    for branch in range(8):
        step = SrsStep(robot, definition, branch, psi)
        found = step.joints(*floats(X))
        np.testing.assert_allclose(
            found, inverse_branch(robot, X[None], psi, definition, branch)[0], rtol=0, atol=1e-12
        )
        R, p = step.forward(found)
        np.testing.assert_allclose(np.reshape(R, (3, 3)), X[:3, :3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(p, X[:3, 3], rtol=0, atol=1e-12)


def test_unequal_links_and_the_end_of_reach():
    robot = replace(load_srs("iiwa7"), lengths=SrsLengths(0.34, 0.42, 0.4, 0.126))
    step = SrsStep(robot, ArmAngle.SWIVEL, 3, 0.4)
    R = tuple(np.eye(3).ravel().tolist())
    for distance, reached in (
        (0.0, False),
        (0.019, False),
        (0.0200001, True),
        (0.5, True),
        (0.82, True),
        (0.8201, False),
    ):
        found = step.joints(R, (0.6 * distance, 0.8 * distance, 0.34 + 0.126))
        assert (found is not None) is reached, distance
        if found is not None:
            wrist = robot.forward(np.array(found))[:3, 3] - [0.0, 0.0, 0.126]
            np.testing.assert_allclose(wrist, (0.6 * distance, 0.8 * distance, 0.34), rtol=0, atol=1e-9)
            assert all(type(value) is float for value in found)


def test_angles_lie_in_half_open_turns(rng):
    robot = load_srs("iiwa7")
    X = robot.forward(np.zeros(7))
    for branch in range(8):
        for psi in (0.0, -0.0, pi, -pi, 1e-17, -1e-17):
            found = SrsStep(robot, ArmAngle.FARIA, branch, psi).joints(*floats(X))
            assert found is not None
            assert all(-pi < found[i] <= pi for i in (0, 2, 4, 6))


@PLACES
def test_the_compiled_force_is_the_least_squares_solution(X_WB, X_FT, rng):
    """Of J^T F = tau with pinocchio's J; its trace is that of the singular values."""
    step = SrsStep(load_srs("iiwa7", X_WB), ArmAngle.SWIVEL, 0, 0.0, X_FT)
    for _ in range(20):
        q, tau = tuple(rng.uniform(-2, 2, 7).tolist()), rng.normal(size=7) * 20
        J = np.array(step.jacobian(q))
        F, trace = step.force(q, tau.tolist())
        sigma = np.linalg.svd(J, compute_uv=False)
        np.testing.assert_allclose(trace, np.sum(sigma**-2.0), rtol=1e-8)
        wanted = np.linalg.lstsq(J.T, tau, rcond=None)[0]
        np.testing.assert_allclose(F, wanted, rtol=0, atol=1e-13 * trace * np.abs(tau).max())


@pytest.mark.parametrize("degrees", [(0, 0, 0, 0, 0, 0, 0), (0, 30, 0, 0, 0, 0, 0)])
def test_an_arm_without_leverage_has_no_finite_trace(degrees):
    _, trace = SrsStep(load_srs("iiwa7"), ArmAngle.SWIVEL, 0, 0.0).force(tuple(np.radians(degrees)), [1.0] * 7)
    assert not trace < 1e10


def test_what_makes_no_step_is_named():
    robot = load_srs("iiwa7")
    with pytest.raises(ValueError, match=r"configuration 9, wanted 0\.\.7"):
        SrsStep(robot, ArmAngle.SWIVEL, 9, 0.0)
    with pytest.raises(ValueError, match="arm_angle is nan, wanted a finite angle"):
        SrsStep(robot, ArmAngle.SWIVEL, 0, float("nan"))
    with pytest.raises(ValueError, match="X_FT is not a pose"):
        SrsStep(robot, ArmAngle.SWIVEL, 0, 0.0, np.diag([1.0, 1, -1, 1]))
