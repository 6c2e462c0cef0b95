"""Velocities and accelerations both ways, against pin, differences along a motion, and closed forms."""

import numpy as np
import pytest
from tcp_motion import forward_acceleration, forward_velocity, inverse_acceleration, inverse_velocity, singularity

from trajopt_cli.robot.model import load_robot


def states(robot, rng, count=100):
    k = len(robot.axis_names)
    q, qd, qdd = (rng.uniform(-s, s, (count, k)) for s in (3, 4, 20))
    regular = np.all(singularity(robot, q) > 0.05, axis=-1)
    assert regular.sum() > count / 2
    return q[regular], qd[regular], qdd[regular]


def test_forward_velocity_and_acceleration_equal_pin(mounted, rng):
    import pinocchio as pin

    q, qd, qdd = states(mounted, rng)
    V, A = forward_velocity(mounted, q, qd), forward_acceleration(mounted, q, qd, qdd)
    model = mounted.pin_model
    data, flange = model.createData(), model.getFrameId("tool0")
    world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    for i in range(len(q)):
        pin.forwardKinematics(model, data, q[i], qd[i], qdd[i])
        np.testing.assert_allclose(V[i], pin.getFrameVelocity(model, data, flange, world).vector, rtol=0, atol=1e-11)
        found = pin.getFrameClassicalAcceleration(model, data, flange, world).vector
        np.testing.assert_allclose(A[i], found, rtol=0, atol=1e-10)


def test_tcp_velocity_and_acceleration_are_differences_of_the_pose(mounted, X_FT, rng):
    q, qd, qdd = states(mounted, rng)
    h = 1e-4
    p_0, p_1, p_2 = ((mounted.forward(q + t * qd + 0.5 * t * t * qdd) @ X_FT)[..., :3, 3] for t in (-h, 0.0, h))
    V, A = forward_velocity(mounted, q, qd, X_FT), forward_acceleration(mounted, q, qd, qdd, X_FT)
    np.testing.assert_allclose(V[:, :3], (p_2 - p_0) / (2 * h), rtol=0, atol=2e-5)
    np.testing.assert_allclose(A[:, :3], (p_2 - 2 * p_1 + p_0) / h**2, rtol=0, atol=2e-3)


def test_inverse_undoes_forward_with_the_rail_moving(mounted, X_FT, rng):
    q, qd, qdd = states(mounted, rng)
    rail, rail_acceleration = (qd[:, 0], qdd[:, 0]) if mounted.has_rail else (None, None)
    V = forward_velocity(mounted, q, qd, X_FT)
    np.testing.assert_allclose(inverse_velocity(mounted, q, V, rail, X_FT), qd, rtol=0, atol=1e-10)
    A = forward_acceleration(mounted, q, qd, qdd, X_FT)
    found = inverse_acceleration(mounted, q, qd, A, rail_acceleration, X_FT)
    np.testing.assert_allclose(found, qdd, rtol=0, atol=1e-9)
    one = inverse_velocity(mounted, q[0], V[0], None if rail is None else rail[0], X_FT)
    np.testing.assert_allclose(one, qd[0], rtol=0, atol=1e-10)


def test_axes_follow_a_tool_as_pin_says_it_moves(mounted, X_FT, rng):
    import pinocchio as pin

    q, qd, qdd = states(mounted, rng)
    model = mounted.pin_model.copy()
    flange = model.frames[model.getFrameId("tool0")]
    tool = pin.Frame("tool", flange.parentJoint, flange.placement * pin.SE3(X_FT), pin.FrameType.OP_FRAME)
    number, world = model.addFrame(tool), pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    data = model.createData()
    V, A = np.empty((len(q), 6)), np.empty((len(q), 6))
    for i in range(len(q)):
        pin.forwardKinematics(model, data, q[i], qd[i], qdd[i])
        V[i] = pin.getFrameVelocity(model, data, number, world).vector
        A[i] = pin.getFrameClassicalAcceleration(model, data, number, world).vector
    at, rail = mounted.differential(q, X_FT), mounted.layout.rail
    found = at.follow(V, A, qd[:, rail], qdd[:, rail])
    np.testing.assert_allclose(found[0], qd, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found[1], qdd, rtol=0, atol=1e-8)
    np.testing.assert_allclose(at.motion(qd, qdd), np.stack([V, A], axis=1), rtol=0, atol=1e-10)


def test_nothing_follows_at_a_singular_wrist_and_beside_it_rows_are_their_own(irb140):
    q = np.radians([[10, 20, -40, 30, 40, 50], [0, 20, -40, 0, 0, 0], [10, 20, -40, 30, 40, 50]])
    none = np.zeros((3, 0))
    qd, qdd = irb140.differential(q).follow(np.ones((3, 6)), np.ones((3, 6)), none, none)
    assert np.isnan(qd[1]).all()
    assert np.isnan(qdd[1]).all()
    np.testing.assert_allclose(irb140.jacobian(q[[0, 2]]) @ qd[[0, 2], :, None], np.ones((2, 6, 1)), rtol=0, atol=1e-12)


def test_the_arm_can_hold_the_tcp_while_the_rail_runs(rng):
    robot = load_robot("irb140_rail")
    q, _, _ = states(robot, rng)
    qd = inverse_velocity(robot, q, np.zeros((len(q), 6)), 0.7)
    assert np.all(qd[:, 0] == 0.7)
    h = 1e-6
    apart = robot.forward(q + h * qd) - robot.forward(q - h * qd)
    assert np.abs(apart / (2 * h)).max() < 1e-6 < np.abs(qd[:, 1:]).max()


def test_product_of_the_singularity_measures_is_the_determinant(irb140, rng):
    q = rng.uniform(-3, 3, (200, 6))
    wanted = np.abs(np.linalg.det(irb140.jacobian(q)))
    found = irb140.arm.c2 * irb140.arm.c3 * singularity(irb140, q).prod(axis=-1)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-13)


@pytest.mark.parametrize(
    ("joints", "words"),
    [
        ([10, 20, -40, 30, 0, 50], r"wrist singularity: \|sin\| of axis 5 = 0 at row 1, at least 1e-09"),
        ([10, 20, -90, 30, 40, 50], r"elbow singularity: \|cos\| of the elbow = \S+ at row 1, at least 1e-09"),
        (
            [10, np.degrees(np.arcsin(-0.07 / 0.36)), -90 - np.degrees(np.arcsin(-0.07 / 0.36)) + 180, 30, 40, 50],
            r"shoulder singularity: wrist centre off axis 1 by \[m\] = \S+ at row 1, at least 1e-09",
        ),
    ],
)
def test_singular_configurations_are_named(irb140, joints, words):
    q = np.radians([[10, 20, -40, 30, 40, 50], joints])
    with pytest.raises(ValueError, match=words):
        inverse_velocity(irb140, q, np.ones((2, 6)))
    with pytest.raises(ValueError, match=words):
        inverse_acceleration(irb140, q, np.ones((2, 6)), np.ones((2, 6)))


def test_a_rail_needs_its_motion_given():
    robot = load_robot("irb140_rail")
    with pytest.raises(ValueError, match="irb140_rail rides a rail: give the rail's own motion"):
        inverse_velocity(robot, np.radians([0, 10, 20, -40, 30, 40, 50]), np.ones(6))


@pytest.mark.parametrize("which", range(3))
def test_what_counts_as_singular(irb140, which):
    """The measures one by one, just beside their limit."""
    for off, singular in ((0.9e-9, True), (1.1e-9, False)):
        q = np.array([0.3, -0.4, 0.2, 0.5, off if which == 0 else 0.7, 0.6])
        if which == 1:
            q[2] = -np.pi / 2 + off
        elif which == 2:
            q[2] = np.arccos((off - 0.07 - 0.36 * np.sin(q[1])) / 0.38) - q[1]
        assert singularity(irb140, q)[which] == pytest.approx(off, rel=1e-5)
        if singular:
            name = ("wrist", "elbow", "shoulder")[which]
            with pytest.raises(ValueError, match=rf"{name} singularity: .* = 9e-10 at row 1, at least 1e-09 to be"):
                inverse_velocity(irb140, np.array([np.full(6, 0.3), q]), np.ones(6))
        else:
            rates = inverse_velocity(irb140, q, np.ones(6))
            np.testing.assert_allclose(irb140.jacobian(q) @ rates, np.ones(6), rtol=0, atol=1e-4)
