"""Arms whose axis 6 passes the point where axes 4 and 5 meet: kinematics against pin, branches, and a plan."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from arms import KNOWN, OFFSET_WRISTS, abb_like, pin_flange, random_chain, random_pose
from small_cells import rapid

from trajopt_cli.errors import InputError
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import TcpCaps
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import confdata, inverse, representatives


@pytest.fixture(scope="module", params=[*OFFSET_WRISTS, 0, 1])
def arm(request, tmp_path_factory):
    chain = OFFSET_WRISTS[request.param]() if request.param in OFFSET_WRISTS else random_chain(request.param, 0.15)
    return chain.load(tmp_path_factory.mktemp("arm"), random_pose(np.random.default_rng(1)))


def configurations(robot, n):
    limits = robot.profile()
    return np.random.default_rng(2).uniform(limits.lower, limits.upper, (n, 6))


def test_kinematics_are_pins(arm):
    q, qd = configurations(arm, 20), np.random.default_rng(3).normal(size=6)
    np.testing.assert_allclose(arm.forward(q), pin_flange(arm, q), rtol=0, atol=1e-13)
    model = arm.pin_model
    flange, data = model.getFrameId("tool0", pin.FrameType.BODY), model.createData()
    for row in q:
        pin.computeJointJacobiansTimeVariation(model, data, row, qd)
        pin.updateFramePlacements(model, data)
        J = pin.getFrameJacobian(model, data, flange, pin.LOCAL_WORLD_ALIGNED)
        rate = pin.getFrameJacobianTimeVariation(model, data, flange, pin.LOCAL_WORLD_ALIGNED)
        np.testing.assert_allclose(arm.jacobian(row), J, rtol=0, atol=1e-12)
        np.testing.assert_allclose(arm.differential(row).bias(qd), rate @ qd, rtol=0, atol=1e-10)


@pytest.mark.parametrize(("name", "along", "across"), [("gofa", 0.0, 0.080), ("crx", -0.150, 0.0)])
def test_lengths_say_how_far_axis_6_stands_off(name, along, across, tmp_path):
    lengths = OFFSET_WRISTS[name]().load(tmp_path).arm.lengths
    assert list(lengths) == ["a1", "a2", "b", "c1", "c2", "c3", "c4", "wrist along", "wrist across"]
    assert (lengths["wrist along"], lengths["wrist across"]) == pytest.approx((along, across), abs=1e-15)
    plain = KNOWN["irb4600"]().load(tmp_path).arm.lengths
    wanted = {"a1": 0.175, "a2": -0.175, "b": 0, "c1": 0.495, "c2": 1.095, "c3": 1.27, "c4": 0.135}
    assert plain == pytest.approx(wanted, abs=1e-15)


def test_answers_have_the_pose_and_nearly_all_configurations_are_among_them(arm):
    q, limits = configurations(arm, 300), arm.profile()
    X = pin_flange(arm, q)
    found = inverse(arm, X)
    there = np.isfinite(found).all(axis=-1)
    back = pin_flange(arm, found[there])
    assert np.abs(back - X[np.nonzero(there)[0]]).max() < 1e-9
    for cfx in range(8):  # a branch is named by what its joints are
        for branch in (cfx, cfx + 8):
            assert all(confdata(arm, row).cfx == cfx for row in found[there[:, branch], branch][:20])
    among = [
        any(
            np.abs(representatives(branch, limits.lower, limits.upper) - row).max(axis=1, initial=0).min(initial=9)
            < 1e-7
            for branch in branches[[confdata(arm, row).cfx, confdata(arm, row).cfx + 8]]
        )
        for row, branches in zip(q, found, strict=True)
    ]
    assert np.mean(among) > 0.8  # GoFa's lengths: 0.94
    assert there.any(axis=1).mean() > 0.97


def test_without_an_offset_it_is_the_closed_form(tmp_path):
    nearly = abb_like(0.0, 0.265, 0.444, -0.110, 0.470, 0.101, wrist=(0.0, 1e-6)).load(tmp_path, name="nearly")
    exactly = abb_like(0.0, 0.265, 0.444, -0.110, 0.470, 0.101).load(tmp_path, name="exactly")
    X = exactly.forward(configurations(exactly, 100))
    a, b = inverse(nearly, X)[:, :8], inverse(exactly, X)
    both = np.isfinite(a).all(axis=-1) & np.isfinite(b).all(axis=-1)
    assert both.sum() > 0.95 * np.isfinite(b).all(axis=-1).sum()
    away = np.abs((a - b)[both] + np.pi) % (2 * np.pi) - np.pi
    assert np.median(np.abs(away).max(axis=-1)) < 1e-4


def test_it_has_no_expression_of_its_inverse(arm):
    assert not arm.closed_form
    with pytest.raises(ValueError, match="offset"):
        arm.expressions.inverse(ca.SX.zeros(3), ca.SX.eye(3), ca.SX.ones(3), ca.SX.zeros(6))


def test_a_plan_is_legal_and_says_that_no_nonlinear_program_improved_it(tmp_path):
    robot = OFFSET_WRISTS["gofa"]().load(tmp_path)
    start = np.array([0, 0, 0, 0, np.pi / 6, 0])
    plant = Plant(robot, robot.profile(), TcpCaps(2.5, 20.0), start, (), False, False, frozenset())
    data = """CONST robtarget a:=[[500,300,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
              CONST robtarget b:=[[500,300,340],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
    program = rapid(r"ConfJ \Off; ConfL \Off; MoveJ a, v1000, fine, tool0; MoveL b, v200, fine, tool0;", None, data)
    plan = optimize(program, plant, Target.STREAM)
    assert isinstance(plan, Plan)
    report = verify(program, plant, plan.trajectory)
    assert report.legal, [one.message for one in report.findings if not one.passed]
    assert plan.lower_bound is not None
    assert plan.lower_bound <= plan.duration
    assert any("no nonlinear program" in note for note in plan.notes)


def test_axis_5_beside_axis_4_is_refused(tmp_path):
    chain = abb_like(0.0, 0.265, 0.444, 0.0, 0.470, 0.101)
    chain.origins[4][2, 3] = 0.01
    with pytest.raises(InputError, match=r"axis 5 passes axis 4 by 10 mm"):
        chain.load(tmp_path)
