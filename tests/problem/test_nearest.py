"""The nearest configuration against brute force over all branches and turns that other libraries find."""

from __future__ import annotations

from itertools import product
from math import pi

import numpy as np
import pinocchio as pin
import pytest
from small_cells import HOME, down, plant_with_rail, plant_without_rail

from trajopt_cli.geometry import Array
from trajopt_cli.motion import Source
from trajopt_cli.problem.nearest import is_nearest, is_sure, nearest
from trajopt_cli.problem.plan import PlannedMotion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.model import load_robot


def brute_force(plant: Plant, branches: Array, arm: Array) -> tuple[Array, float]:
    """Of joints (m, 6) in every whole turn within the limits the nearest to arm, and how much farther the next is."""
    turned = []
    for branch in branches:
        ends = zip(branch, plant.limits.lower, plant.limits.upper, strict=True)
        turned += product(*([v for v in value + 2 * pi * np.arange(-2, 3) if a <= v <= b] for value, a, b in ends))
    away = np.sum((np.array(turned) - arm) ** 2, axis=1)
    first, *others = np.argsort(away)
    return np.array(turned[first]), float(away[others[0]] - away[first]) if others else np.inf


def starts(plant: Plant, rng: np.random.Generator) -> tuple[Array, Array]:
    """Joints within the limits, and others, some near and some anywhere."""
    low, high = plant.limits.lower, plant.limits.upper
    q = rng.uniform(low, high)
    other = q + rng.uniform(-1, 1, 6) * rng.choice([0.3, 1.0, 7.0])
    return q, np.clip(other, low, high)


def test_two_hundred_random_poses_against_all_that_py_opw_kinematics_finds() -> None:
    opw = pytest.importorskip("py_opw_kinematics")
    from scipy.spatial.transform import RigidTransform

    plant, rng = plant_without_rail(), np.random.default_rng(11)
    model = opw.KinematicModel(0.07, 0, 0, 0.352, 0.36, 0.38, 0.065, offsets=(0, 0, -pi / 2, 0, 0, 0))
    q, arm = (np.array(part) for part in zip(*(starts(plant, rng) for _ in range(200)), strict=True))
    X = plant.robot.forward(q)
    result = opw.Robot(model, degrees=False).reach(RigidTransform.from_matrix(X))
    theirs = np.asarray(result.joints if hasattr(result, "joints") else result[0])
    for X_WF, branches, now in zip(X, theirs, arm, strict=True):
        wanted, spare = brute_force(plant, branches[np.isfinite(branches).all(axis=1)], now)
        (found,) = nearest(plant, X_WF, None, now[None])
        assert spare < 1e-6 or np.abs(found - wanted).max() < 1e-6


def by_newton(plant: Plant, X_WF: Array, rng: np.random.Generator) -> Array:
    """All joints (m, 6) of a pose, by Newton's steps with pinocchio's Jacobians from random seeds."""
    model = pin.buildModelFromUrdf(str(plant.robot.urdf))
    data, flange = model.createData(), model.getFrameId("tool0")
    wanted, found = pin.SE3(X_WF), list[Array]()
    for _ in range(300):
        q = rng.uniform(-pi, pi, 6)
        for _ in range(60):
            pin.framesForwardKinematics(model, data, q)
            error = pin.log6(data.oMf[flange].actInv(wanted)).vector
            if np.linalg.norm(error) < 1e-11:
                if not any(np.abs(np.sin((q - one) / 2)).max() < 1e-6 for one in found):
                    found.append(q - 2 * pi * np.round(q / (2 * pi)))
                break
            J = pin.computeFrameJacobian(model, data, q, flange)
            q = q + J.T @ np.linalg.solve(J @ J.T + 1e-9 * np.eye(6), error)
    return np.array(found)


@pytest.mark.long
def test_random_poses_of_another_robot_against_all_that_newtons_method_finds() -> None:
    robot, rng = load_robot("irb1600_6_120"), np.random.default_rng(12)
    plant = plant_without_rail(robot=robot, limits=robot.profile())
    for _ in range(12):
        q, now = starts(plant, rng)
        X_WF = robot.forward(q)
        wanted, spare = brute_force(plant, by_newton(plant, X_WF, rng), now)
        (found,) = nearest(plant, X_WF, None, now[None])
        assert spare < 1e-6 or np.abs(found - wanted).max() < 1e-6


def ends_in(plant: Plant, q_0: Array, q_1: Array) -> PlannedMotion:
    return PlannedMotion(0, Source("t.mod", 1, 1), 0.0, 1.0, q_0, q_1, "test")


def test_the_nearest_is_that_at_the_rail_the_target_gives() -> None:
    """Straight ahead with the rail abreast; with the rail 0.5 m on, the arm turns back to the same tool."""
    plant, X_WF = plant_with_rail(), down(0.5, 0.6, 0.45)
    for rail in (0.4, 0.6, 0.9):
        (arm,) = nearest(plant, X_WF, rail, HOME[None])
        q = np.r_[rail, arm]
        np.testing.assert_allclose(plant.robot.forward(q), X_WF, rtol=0, atol=1e-9)
        assert np.sign(np.round(arm[0], 6)) == np.sign(0.6 - rail)
        assert is_nearest(plant, ends_in(plant, np.r_[0.0, HOME], q))
        flipped = q + np.array([0, 0, 0, 0, pi if arm[3] < 0.5 else -pi, -2 * arm[4], -pi])
        np.testing.assert_allclose(plant.robot.forward(flipped), X_WF, rtol=0, atol=1e-9)
        assert not is_nearest(plant, ends_in(plant, np.r_[0.0, HOME], flipped))
        assert is_nearest(plant, ends_in(plant, flipped, flipped))
    assert len(nearest(plant, X_WF, 2.2, HOME[None])) == 0


def test_where_measures_differ_the_answer_is_not_sure() -> None:
    """Axes 4, 5 and 6 turn by 75, 30 and 100 degrees, or with the wrist flipped by 105, 10 and 80: less in all, but the
    largest turn and the squares are greater. Half a turn either way is no more sure."""
    plant = plant_without_rail()
    q = np.radians([10, 5, -20, 0, 20, 0])
    X_WF = plant.robot.forward(q)
    for turns, sure in (([0, 0, 0], True), ([75, -30, 80], True), ([75, -30, 100], False), ([0, 0, 180], False)):
        assert is_sure(plant, X_WF, None, q + np.radians([0, 0, 0, *turns])) == sure
    found = nearest(plant, X_WF, None, q[None] + np.radians([0, 0, 0, 75, -30, 100]))[0]
    np.testing.assert_allclose(found, q, rtol=0, atol=1e-12)
