"""The generated CasADi functions against pin, and the promise that they stay small."""

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from symbolic_functions import forward_function, jacobian_function, jacobian_rate_function, tcp_motion_function

from trajopt_cli.robot.model import load_robot
from trajopt_cli.robot.symbolic import forward

WORLD = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
COUNT = 25


@pytest.fixture(scope="module")
def with_tcp(mounted, X_FT):
    """(model, data, id of a frame at the TCP) in pin."""
    model = pin.Model(mounted.pin_model)
    flange = model.getFrameId("tool0")
    frame = model.frames[flange]
    at = frame.placement * pin.SE3(X_FT)
    tcp = model.addFrame(pin.Frame("tcp", frame.parentJoint, flange, at, pin.FrameType.OP_FRAME))
    return model, model.createData(), tcp


def rows(model, rng):
    return (rng.uniform(-s, s, (COUNT, model.nq)) for s in (3, 1, 1))


def test_forward_equals_pin(mounted, with_tcp, X_FT, rng):
    model, data, tcp = with_tcp
    at_flange, at_tcp = forward_function(mounted), forward_function(mounted, X_FT)
    flange = model.getFrameId("tool0")
    assert (at_tcp.name_in(), at_tcp.name_out()) == (["q"], ["p", "R"])
    for q in next(rows(model, rng)):
        pin.framesForwardKinematics(model, data, q)
        for function, frame in ((at_flange, flange), (at_tcp, tcp)):
            p, R = (np.array(value) for value in function(q))
            np.testing.assert_allclose(p[:, 0], data.oMf[frame].translation, rtol=0, atol=1e-12)
            np.testing.assert_allclose(R, data.oMf[frame].rotation, rtol=0, atol=1e-12)


def test_jacobian_and_its_rate_equal_pin(mounted, with_tcp, X_FT, rng):
    model, data, tcp = with_tcp
    jacobian, rate = jacobian_function(mounted, X_FT), jacobian_rate_function(mounted, X_FT)
    assert (rate.name_in(), rate.name_out()) == (["q", "qd"], ["J_rate"])
    q, qd, _ = rows(model, rng)
    for i in range(COUNT):
        pin.computeJointJacobiansTimeVariation(model, data, q[i], qd[i])
        pin.updateFramePlacements(model, data)
        wanted = pin.getFrameJacobian(model, data, tcp, WORLD)
        np.testing.assert_allclose(np.array(jacobian(q[i])), wanted, rtol=0, atol=1e-12)
        wanted = pin.getFrameJacobianTimeVariation(model, data, tcp, WORLD)
        np.testing.assert_allclose(np.array(rate(q[i], qd[i])), wanted, rtol=0, atol=1e-12)


def test_tcp_motion_equals_pin(mounted, with_tcp, X_FT, rng):
    model, data, tcp = with_tcp
    motion = tcp_motion_function(mounted, X_FT)
    assert motion.name_in() == ["q", "qd", "qdd"]
    for q, qd, qdd in zip(*rows(model, rng), strict=True):
        pin.forwardKinematics(model, data, q, qd, qdd)
        pin.updateFramePlacements(model, data)
        velocity = pin.getFrameVelocity(model, data, tcp, WORLD)
        acceleration = pin.getFrameClassicalAcceleration(model, data, tcp, WORLD)
        found = motion(q=q, qd=qd, qdd=qdd)
        for name, wanted in (
            ("p", data.oMf[tcp].translation),
            ("v", velocity.linear),
            ("a", acceleration.linear),
            ("omega", velocity.angular),
            ("alpha", acceleration.angular),
        ):
            np.testing.assert_allclose(np.array(found[name])[:, 0], wanted, rtol=0, atol=1e-12, err_msg=name)


@pytest.mark.parametrize("name", ["irb140", "irb140_rail"])
def test_expressions_stay_small(name):
    """Hand-written by others' count: 128 instructions for the pose."""
    robot = load_robot(name)
    assert forward_function(robot).n_instructions() <= 128


def test_expression_can_be_differentiated_where_it_is_used():
    robot = load_robot("irb140_rail")
    q = ca.SX.sym("q", 7)
    p, _ = forward(robot.pin_model, q)
    gradient = ca.Function("gradient", [q], [ca.jacobian(p, q)])
    at = np.array([0.3, 0.1, 0.2, -0.3, 0.4, 0.5, 0.6])
    np.testing.assert_allclose(np.array(gradient(at)), robot.jacobian(at)[:3], rtol=0, atol=1e-14)
