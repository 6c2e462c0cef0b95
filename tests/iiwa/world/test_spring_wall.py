"""The ideal arm: differences of its commands, torques of rigid bodies less the contact's."""

import numpy as np
import pytest

from trajopt_cli.geometry import pose
from trajopt_cli.iiwa.task.model import Contact, Obstacle
from trajopt_cli.iiwa.world.worlds import SpringWorld
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.shapes import Box

H = 1e-3


def test_free_motion_has_the_commands_differences_and_the_truths_torques(iiwa7, X_FT, truth):
    world = SpringWorld(iiwa7, X_FT, None, None, H)
    for case in truth("iiwa7_rnea.json")[:5]:
        q, qd, qdd = (np.array(case[key]) for key in ("q", "qd", "qdd"))
        # three positions whose backward differences at the last are qd and qdd
        first, second = q - 2 * H * qd + H * H * qdd, q - H * qd
        world.reset(tuple(first))
        world.step(tuple(second))
        last = world.step(tuple(q))
        np.testing.assert_allclose(last.q, q, rtol=0, atol=0)
        np.testing.assert_allclose(last.qd, qd, rtol=0, atol=1e-11)
        np.testing.assert_allclose(last.qdd, qdd, rtol=0, atol=1e-8)
        np.testing.assert_allclose(last.tau, case["tau"], rtol=0, atol=1e-6)
        assert last.contact == (0.0,) * 6
        assert last.depth == 0.0


def test_torques_miss_exactly_what_the_contact_bears(crooked, X_FT, load):
    rng = np.random.default_rng(4)
    dynamics = Dynamics(crooked, load)
    for _ in range(20):
        q = rng.uniform(-1.5, 1.5, 7)
        p = (crooked.forward(q) @ X_FT)[:3, 3]
        box = Box("block", np.array([0.3, 0.3, 0.3]), pose(np.eye(3), p + np.array([0.0, 0.16, 0.02])))
        world = SpringWorld(crooked, X_FT, load, Contact((Obstacle(box, 5e3, 100.0, 0.4),), 0.02), H)
        rates = rng.uniform(-0.5, 0.5, 7)
        world.reset(tuple(q - H * rates))
        seen = world.step(tuple(q))
        F = np.array(seen.contact)
        assert seen.depth == pytest.approx(0.01, abs=1e-12)
        assert np.linalg.norm(F) > 1
        free = dynamics.torque(*(np.array(row) for row in (seen.q, seen.qd, seen.qdd)))
        J = crooked.jacobian(q, X_FT)
        np.testing.assert_allclose(free - seen.tau, J.T @ F, rtol=0, atol=1e-9)
        # the damper and the friction see the tip's own speed: 100 N s/m on top of the spring's 50 N
        v = J[:3] @ rates
        assert F[1] == pytest.approx(-max(0.0, 5e3 * 0.01 + 100.0 * v[1]), abs=1e-6)


@pytest.mark.parametrize("damping", [0.0, 200.0])
@pytest.mark.parametrize("share", [0.8, 1.2])
def test_an_euler_controller_rests_on_a_wall_up_to_the_stiffness_its_damping_allows(
    iiwa7, X_FT, load, floor, ball_at, share, damping
):
    """M = 25 kg, D = 400 N s/m, K = 1 kN/m along z, pressing with 20 N; disturbed by 0.4 N."""
    M, D, K, press = 25.0, 400.0, 1000.0, 20.0
    stiffness = share * (D + damping) / H - K
    world = SpringWorld(iiwa7, X_FT, load, floor(press / stiffness, stiffness, damping, 0.0), H)
    q = tuple(np.radians([0, 30, 0, -100, 0, 50, 0]))
    p = (iiwa7.forward(np.array(q)) @ X_FT)[:3, 3]
    measured, z, v, swing = world.reset(q), 0.02 * press / stiffness, 0.0, []
    for _ in range(400):
        v, z = v + H / M * (measured.contact[2] - press - D * v - K * z), z + H * v
        q = ball_at(p + np.array([0.0, 0.0, z]), q, steps=1)
        measured = world.step(q)
        swing.append(abs(measured.contact[2] - press))
    early, late = max(swing[:100]), max(swing[300:])
    assert late < 0.8 * early if share < 1 else late > 1.2 * early


def test_a_reset_forgets_the_motion_before(iiwa7, X_FT, load, floor):
    world = SpringWorld(iiwa7, X_FT, load, floor(0.001), H)
    q = tuple(np.radians([0, 30, 0, -100, 0, 50, 0]))
    first = world.reset(q)
    world.step(tuple(np.array(q) + 1e-3))
    assert world.reset(q) == first
    assert first.qd == (0.0,) * 7
    assert first.contact[2] == pytest.approx(20.0, abs=1e-6)
