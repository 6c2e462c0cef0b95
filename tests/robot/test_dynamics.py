"""Torques against the truth, a load's effect against statics and the parallel axis theorem, energy, wrong loads."""

import numpy as np
import pytest
from places import crooked_pose

from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.srs import load_srs

COM = np.array([0.03, -0.05, 0.12])
INERTIA = rotation_about([0.6, 0, 0.8], 0.7) @ np.diag([0.02, 0.03, 0.04]) @ rotation_about([0.6, 0, 0.8], -0.7)
LOAD = ToolLoad(2.5, COM, INERTIA)


@pytest.fixture(scope="module")
def hung():
    return load_srs("iiwa7", crooked_pose(9))


def mass_matrix(dynamics, q):
    """What joint accelerations of 1 cost, one by one (7, 7)."""
    columns = [dynamics.torque(q, np.zeros(7), one) - dynamics.gravity_torque(q) for one in np.eye(7)]
    return np.column_stack(columns)


def test_torques_gravity_and_mass_matrices_are_the_truths(truth):
    cases = truth("iiwa7_rnea.json")
    assert len(cases) == 25
    dynamics = Dynamics(load_srs("iiwa7"))
    q, qd, qdd, tau, gravity, nle = (
        np.array([c[k] for c in cases]) for k in ("q", "qd", "qdd", "tau", "gravity", "nle")
    )
    np.testing.assert_allclose(dynamics.torque(q, qd, qdd), tau, rtol=0, atol=1e-12)
    np.testing.assert_allclose(dynamics.torque(q, qd, np.zeros_like(q)), nle, rtol=0, atol=1e-12)
    np.testing.assert_allclose(dynamics.gravity_torque(q), gravity, rtol=0, atol=1e-12)
    for case in cases:
        wanted = np.reshape(case["M_rowmajor_7x7"], (7, 7))
        np.testing.assert_allclose(mass_matrix(dynamics, np.array(case["q"])), wanted, rtol=0, atol=1e-12)


def test_a_loads_weight_is_the_jacobians_of_its_centre(hung, rng):
    """On a crooked mounting gravity stays along the world's -z."""
    q = rng.uniform(-2, 2, (20, 7))
    bare, loaded = Dynamics(hung), Dynamics(hung, LOAD)
    lift = np.array([0, 0, LOAD.mass * 9.81])
    wanted = np.einsum("nij,i->nj", hung.jacobian(q, pose(np.eye(3), COM))[:, :3], lift)
    np.testing.assert_allclose(loaded.gravity_torque(q) - bare.gravity_torque(q), wanted, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(Dynamics(hung).gravity_torque(q), bare.gravity_torque(q))  # the model is a copy
    moon = Dynamics(hung, LOAD, gravity=1.62)
    np.testing.assert_allclose(moon.gravity_torque(q), loaded.gravity_torque(q) * 1.62 / 9.81, rtol=0, atol=1e-12)
    assert np.all(Dynamics(hung, LOAD, gravity=0.0).gravity_torque(q) == 0)


def test_a_loads_inertia_is_the_jacobians_too(hung, rng):
    q = rng.uniform(-2, 2, (10, 7))
    J = hung.jacobian(q, pose(np.eye(3), COM))
    R = hung.forward(q)[:, :3, :3]
    bare, loaded = Dynamics(hung), Dynamics(hung, LOAD)
    for i in range(10):
        linear, angular = J[i, :3], J[i, 3:]
        wanted = LOAD.mass * linear.T @ linear + angular.T @ R[i] @ INERTIA @ R[i].T @ angular
        found = mass_matrix(loaded, q[i]) - mass_matrix(bare, q[i])
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12)


def test_power_is_the_change_of_energy(hung, rng):
    """tau qd = d/dt (kinetic energy + height of every mass): no source or sink is hidden in the torques."""
    dynamics = Dynamics(hung, LOAD)
    q, qd, qdd = (rng.normal(size=7) for _ in range(3))
    h = 1e-5
    energies = []
    for t in (-h, h):
        q_t, qd_t = q + qd * t + qdd * t * t / 2, qd + qdd * t
        energies.append(qd_t @ mass_matrix(dynamics, q_t) @ qd_t / 2)
    climb = dynamics.gravity_torque(q) @ qd
    power = dynamics.torque(q, qd, qdd) @ qd
    assert power == pytest.approx((energies[1] - energies[0]) / (2 * h) + climb, rel=1e-7)


def test_torques_are_the_mass_matrix_times_accelerations_and_what_is_left_at_none(hung, rng):
    dynamics = Dynamics(hung, LOAD)
    for _ in range(20):
        q, qd, qdd = rng.uniform(-2, 2, 7), rng.normal(size=7), rng.normal(size=7)
        tau = dynamics.torque(q, qd, qdd)
        assert tau.shape == dynamics.gravity_torque(q).shape == (7,)
        by_matrix = mass_matrix(dynamics, q) @ qdd + dynamics.torque(q, qd, np.zeros(7))
        np.testing.assert_allclose(by_matrix, tau, rtol=0, atol=1e-11)


@pytest.mark.parametrize(
    ("mass", "com", "inertia", "words"),
    [
        (0.0, COM, INERTIA, "ToolLoad.mass is 0 kg, wanted a mass above zero"),
        (-1.0, COM, INERTIA, "ToolLoad.mass is -1 kg"),
        (float("nan"), COM, INERTIA, "ToolLoad.mass is nan kg"),
        (1.0, [0, 0], INERTIA, r"ToolLoad.com is \[0.0, 0.0\], wanted finite numbers of shape \(3,\)"),
        (1.0, [0, 0, np.inf], INERTIA, "ToolLoad.com is"),
        (1.0, COM, np.eye(2), "ToolLoad.inertia is"),
        (1.0, COM, [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]], "is not symmetric"),
        (1.0, COM, np.diag([1.0, 1, -0.1]), "negative moment: its principal moments are -0.1, 1, 1 kg m2"),
        (1.0, COM, np.diag([1.0, 2, 3.1]), "exceeds the sum of the others: its principal moments are 1, 2, 3.1 kg m2"),
    ],
)
def test_a_load_that_no_body_has_is_refused(mass, com, inertia, words):
    with pytest.raises(ValueError, match=words):
        ToolLoad(mass, np.array(com, dtype=float), np.array(inertia, dtype=float))


def test_a_point_mass_and_a_flat_plate_are_bodies():
    assert ToolLoad(1.0, COM, np.zeros((3, 3))).mass == 1.0
    assert ToolLoad(1.0, COM, np.diag([1.0, 2.0, 3.0])).mass == 1.0


def test_wrong_shapes_are_named(hung):
    dynamics = Dynamics(hung)
    with pytest.raises(ValueError, match=r"qd has shape \(6,\), wanted \(7,\) or \(n, 7\)"):
        dynamics.torque(np.zeros(7), np.zeros(6), np.zeros(7))
    with pytest.raises(ValueError, match="q, qd, qdd have 2, 3, 2 rows"):
        dynamics.torque(np.zeros((2, 7)), np.zeros((3, 7)), np.zeros((2, 7)))
    with pytest.raises(ValueError, match="gravity is nan"):
        Dynamics(hung, gravity=float("nan"))
