"""Torques as CasADi expressions against pin's RNEA, on a robot made up for tests, with a load, rotors and a rail."""

from pathlib import Path

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from places import crooked_pose

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.robot.dynamics import GRAVITY, Dynamics, ToolLoad
from trajopt_cli.robot.model import load_robot
from trajopt_cli.robot.symbolic import forward
from trajopt_cli.robot.symbolic_dynamics import LOAD, _moved, load_parameters, torques

ROBOTS = Path(__file__).parents[1] / "data" / "robots"
TURN = rotation_about([0.6, 0, 0.8], 0.7)
CARRIED = ToolLoad(4.0, np.array([0.03, -0.05, 0.12]), TURN @ np.diag([0.02, 0.03, 0.04]) @ TURN.T)


def torque_function(robot):
    q, qd, qdd, p = (ca.SX.sym(name, n) for name, n in (("q", robot.layout.n),) * 3 + (("p", LOAD),))
    tau = torques(robot.pin_model, q, qd, qdd, GRAVITY, p, robot.rotor)
    return ca.Function("tau", [q, qd, qdd, p], [tau], {"cse": True})


@pytest.mark.parametrize("load", [None, CARRIED], ids=["bare", "loaded"])
@pytest.mark.parametrize("name", ["heavy", "heavy_rail"])
def test_expressions_are_pins_rnea(name, load, rng):
    """1,000 random states; the mount is crooked, so gravity is in no axis of the base."""
    robot = load_robot(str(ROBOTS / f"{name}.yaml"), crooked_pose(4))
    q, qd, qdd = (rng.uniform(-s, s, (1000, robot.layout.n)) for s in (3, 4, 40))
    wanted = Dynamics(robot, load, rotor=robot.rotor).torque(q, qd, qdd)
    function = torque_function(robot)
    found = np.array(function(q.T, qd.T, qdd.T, load_parameters(load))).T
    assert np.abs(found - wanted).max() < 1e-9 * np.abs(wanted).max()
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9)
    assert function.n_instructions() < 900


def test_a_load_on_a_flange_away_from_its_joint_is_pins_there():
    p = np.array([0.3, -0.2, 0.5])
    mass, first, second = (ca.DM(ca.evalf(ca.SX(one))) for one in _moved(ca.SX(load_parameters(CARRIED)), TURN.T, p))
    wanted = pin.SE3(TURN.T, p).act(pin.Inertia(CARRIED.mass, CARRIED.com, CARRIED.inertia))
    assert float(mass) == wanted.mass
    np.testing.assert_allclose(np.array(first)[:, 0], wanted.mass * wanted.lever, rtol=1e-14)
    about = wanted.inertia - wanted.mass * pin.skew(wanted.lever) @ pin.skew(wanted.lever)
    np.testing.assert_allclose(np.array(second), about, rtol=1e-13)


@pytest.mark.parametrize("kinds", ["RPRRP", "PRPPR", "RRRRR"])
def test_expressions_of_any_chain_of_one_axis_joints_are_pins(kinds, rng):
    """Joints that slide stand anywhere, along axes that are not those of their frames; so does the flange."""
    model, last, axes = pin.Model(), 0, rng.normal(size=(5, 3))
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    axes[3] = axes[2]
    for k, (kind, axis) in enumerate(zip(kinds, axes / np.linalg.norm(axes, axis=1, keepdims=True), strict=True)):
        joint = (pin.JointModelRevoluteUnaligned if kind == "R" else pin.JointModelPrismaticUnaligned)(axis)
        place = pin.SE3(crooked_pose(k) if k != 3 else pose(np.eye(3), [0.1, 0.2, 0.3]))
        last, c = model.addJoint(last, joint, place, f"axis_{k}"), rng.normal(size=(3, 3))
        model.appendBodyToJoint(last, pin.Inertia(rng.uniform(1, 5), c[0], np.eye(3) + c @ c.T), pin.SE3.Identity())
    flange = pin.SE3(crooked_pose(11))
    model.addFrame(pin.Frame("tool0", last, 0, flange, pin.FrameType.BODY))
    loaded = model.copy()
    loaded.appendBodyToJoint(last, pin.Inertia(CARRIED.mass, CARRIED.com, CARRIED.inertia), flange)
    q, qd, qdd = rng.uniform(-2, 2, (3, 5))
    symbols, rotor = [ca.SX.sym("x", 5) for _ in range(3)], rng.uniform(0, 3, 5)
    for whole, load in ((model, None), (loaded, CARRIED)):
        tau = torques(model, *symbols, GRAVITY, ca.SX(load_parameters(load)), rotor)
        found = np.array(ca.Function("tau", symbols, [tau])(q, qd, qdd))[:, 0]
        wanted = pin.rnea(whole, whole.createData(), q, qd, qdd) + rotor * qdd
        np.testing.assert_allclose(found, wanted, rtol=1e-10, atol=1e-9)
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    X = data.oMf[model.getFrameId("tool0")].homogeneous
    for tool, wanted in ((None, X), (crooked_pose(5), X @ crooked_pose(5))):
        where = ca.Function("X", symbols[:1], forward(model, symbols[0], tool))
        p, R = (np.array(one) for one in where(q))
        np.testing.assert_allclose(np.c_[R, p], wanted[:3], rtol=0, atol=1e-13)


def test_rotors_add_their_inertia_alone(rng):
    robot = load_robot(str(ROBOTS / "heavy.yaml"))
    assert robot.rotor.tolist() == [3.0, 3.5, 1.6, 0.15, 0.12, 0.06]
    q, qd, qdd = rng.uniform(-2, 2, (3, 50, 6))
    more = Dynamics(robot, rotor=robot.rotor).torque(q, qd, qdd) - Dynamics(robot).torque(q, qd, qdd)
    np.testing.assert_allclose(more, qdd * robot.rotor, rtol=0, atol=1e-12)


def test_what_a_robot_lacks_is_named():
    assert load_robot(str(ROBOTS / "heavy.yaml")).lacks_for_torques(np.full(6, 5.0)) == ()
    bare = load_robot("irb140")
    assert bare.profile().torque is None
    lacks = bare.lacks_for_torques(np.array([np.inf, 1, 1, 1, 1, 1]))
    assert lacks == ("effort of joint_1", *(f"mass of link_{i}" for i in range(1, 7)))
    rail = load_robot("irb140_rail")
    assert "mass of base_link" in rail.lacks_for_torques(np.full(7, 9.0))
    assert "mass of base_link" not in rail.lacks_for_torques(np.r_[np.inf, np.full(6, 9.0)])


def test_an_effort_without_a_source_is_no_limit(tmp_path):
    text = (ROBOTS / "heavy.yaml").read_text()
    (tmp_path / "heavy.urdf").write_text((ROBOTS / "heavy.urdf").read_text())
    (tmp_path / "heavy.yaml").write_text(
        text.replace("position: *made, velocity: *made, torque: *made", "position: *made, velocity: *made")
    )
    robot = load_robot(str(tmp_path / "heavy.yaml"))
    assert np.isfinite(robot.profile().torque).tolist() == [True] + [False] * 5
    (tmp_path / "heavy.yaml").write_text(text.replace("rotor_inertia: {value: 3.5", "rotor_inertia: {value: -3.5"))
    with pytest.raises(InputError, match=r"axes\.joint_2\.rotor_inertia\.value"):
        load_robot(str(tmp_path / "heavy.yaml"))
