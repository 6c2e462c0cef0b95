"""Flange poses, Jacobians and their rates against published truth, pin and differences."""

import numpy as np
import pytest

from trajopt_cli.geometry import pose, rotation_from_wxyz


def test_forward_reproduces_the_truth_of_four_independent_routes(irb140, truth):
    cases = truth("irb140_fk.json")
    q = np.array([c["q"] for c in cases])
    wanted = pose(rotation_from_wxyz([c["quat_wxyz"] for c in cases]), [c["p"] for c in cases])
    assert len(cases) == 250
    np.testing.assert_allclose(irb140.forward(q), wanted, rtol=0, atol=1e-12)


def test_jacobian_reproduces_the_truth(irb140, truth):
    cases = [c for c in truth("irb140_fk.json") if "jacobian_base_v_then_w_rowmajor_6x6" in c]
    wanted = np.array([c["jacobian_base_v_then_w_rowmajor_6x6"] for c in cases]).reshape(-1, 6, 6)
    assert len(cases) == 10
    np.testing.assert_allclose(irb140.jacobian(np.array([c["q"] for c in cases])), wanted, rtol=0, atol=1e-12)


def test_home_stands_where_the_data_sheet_draws_it(irb140):
    wanted = [[0, 0, 1, 0.515], [0, 1, 0, 0], [-1, 0, 0, 0.712], [0, 0, 0, 1]]
    np.testing.assert_allclose(irb140.forward(np.zeros(6)), wanted, rtol=0, atol=1e-15)


@pytest.fixture(scope="module")
def pin_tcp(mounted, X_FT):
    """pin's model of the mounted robot with a frame at the TCP: (pin, model, data, flange id, tcp id)."""
    import pinocchio as pin

    model = pin.Model(mounted.pin_model)  # a copy: the frame must not stay in the cached model
    flange = model.getFrameId("tool0")
    frame = model.frames[flange]
    at = frame.placement * pin.SE3(X_FT)
    tcp = model.addFrame(pin.Frame("tcp", frame.parentJoint, flange, at, pin.FrameType.OP_FRAME))
    return pin, model, model.createData(), flange, tcp


def states(robot, rng, count=80):
    k = len(robot.axis_names)
    return rng.uniform(-3, 3, (count, k)), rng.normal(size=(count, k)), rng.normal(size=(count, k))


def test_forward_equals_pin_on_any_mounting(mounted, pin_tcp, rng):
    pin, model, data, flange, _ = pin_tcp
    q, _, _ = states(mounted, rng)
    X = mounted.forward(q)
    for row, found in zip(q, X, strict=True):
        pin.framesForwardKinematics(model, data, row)
        np.testing.assert_allclose(found, data.oMf[flange].homogeneous, rtol=0, atol=1e-12)


def test_jacobian_and_motions_equal_pin_at_a_crooked_tool(mounted, pin_tcp, X_FT, rng):
    pin, model, data, _, tcp = pin_tcp
    q, qd, qdd = states(mounted, rng)
    moves = mounted.differential(q, X_FT)
    velocity, bias, motion = moves.velocity(qd), moves.bias(qd), moves.motion(qd, qdd)
    J = mounted.jacobian(q, X_FT)
    world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    for i in range(len(q)):
        pin.computeJointJacobiansTimeVariation(model, data, q[i], qd[i])
        pin.updateFramePlacements(model, data)
        np.testing.assert_allclose(J[i], pin.getFrameJacobian(model, data, tcp, world), rtol=0, atol=1e-12)
        wanted = pin.getFrameJacobianTimeVariation(model, data, tcp, world)
        both = [J[i] @ qd[i], J[i] @ qdd[i] + wanted @ qd[i]]
        np.testing.assert_allclose(velocity[i], both[0], rtol=0, atol=1e-12)
        np.testing.assert_allclose(bias[i], wanted @ qd[i], rtol=0, atol=1e-11)
        np.testing.assert_allclose(motion[i], both, rtol=0, atol=1e-11)


def test_bias_is_the_difference_of_jacobians_times_the_speeds(mounted, X_FT, rng):
    q, qd, _ = states(mounted, rng)
    h = 1e-6
    wanted = (mounted.jacobian(q + h * qd, X_FT) - mounted.jacobian(q - h * qd, X_FT)) / (2 * h)
    found = mounted.differential(q, X_FT).bias(qd)
    np.testing.assert_allclose(found, (wanted @ qd[..., None])[..., 0], rtol=0, atol=1e-7)


def test_base_carries_the_arm_along_the_rail(mounted, rng):
    q, _, _ = states(mounted, rng, 20)
    rail = q[:, 0] if mounted.has_rail else np.zeros(20)
    moved = q.copy()
    if mounted.has_rail:
        moved[:, 0] = 0.0
    X_BF = np.linalg.inv(mounted.base(np.zeros(20))) @ mounted.forward(moved)
    np.testing.assert_allclose(mounted.base(rail) @ X_BF, mounted.forward(q), rtol=0, atol=1e-12)
    travel = mounted.base(np.array(1.5))[:3, 3] - mounted.base(np.array(0.0))[:3, 3]
    wanted = 1.5 * mounted.X_WR[:3, 1] if mounted.has_rail else np.zeros(3)
    np.testing.assert_allclose(travel, wanted, rtol=0, atol=1e-15)


def test_any_leading_axes_give_the_same_numbers(mounted, X_FT, rng):
    q, qd, _ = states(mounted, rng, 12)
    k = len(mounted.axis_names)
    for found, rows in (
        (mounted.forward(q.reshape(3, 4, k)), mounted.forward(q)),
        (mounted.jacobian(q.reshape(3, 4, k), X_FT), mounted.jacobian(q, X_FT)),
        (mounted.differential(q.reshape(3, 4, k)).bias(qd.reshape(3, 4, k)), mounted.differential(q).bias(qd)),
    ):
        np.testing.assert_allclose(found.reshape(rows.shape), rows, rtol=0, atol=1e-15)
        assert found.shape[:2] == (3, 4)
    np.testing.assert_allclose(mounted.jacobian(q[0], X_FT), mounted.jacobian(q, X_FT)[0], rtol=0, atol=1e-15)


def test_a_wrong_number_of_axes_is_named(mounted):
    with pytest.raises(ValueError, match=r"q has shape \(4, 5\), wanted \(\.\.\., \d\) for .*joint_6"):
        mounted.forward(np.zeros((4, 5)))
    k = len(mounted.axis_names)
    with pytest.raises(ValueError, match=r"qd has shape \(2, \d\), wanted \(3, \d\)"):
        mounted.differential(np.zeros((3, k))).bias(np.zeros((2, k)))
