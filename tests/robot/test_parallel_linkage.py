"""Arms with a parallel linkage: axis 3 is the upper arm's angle against the base. Against pin and closed forms."""

import casadi as ca
import numpy as np
import pytest
from arms import MADE_UP, pin_flange, random_pose, some_arm, urdf_joints
from tcp_motion import singularity

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import inverse_pose
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.motion import ConfData
from trajopt_cli.robot.inverse import confdata, confdata_admits, inverse, solutions
from trajopt_cli.robot.model import load_robot

STEP = 1e-6  # rad of differences


@pytest.fixture(scope="module", params=range(6))
def arm(request, tmp_path_factory):
    """An arm of any lengths, signs and offsets with a linkage, its base anywhere in the world."""
    chain = some_arm(f"linked {request.param}")
    return chain.load(tmp_path_factory.mktemp("arm"), random_pose(np.random.default_rng(1)))


def postures(robot, n, seed=3):
    limits = robot.profile()
    return np.random.default_rng(seed).uniform(limits.lower, limits.upper, (n, 6))


def differences(f, q):
    """Central differences of f (...) by each axis (6, ...)."""
    return np.array([(f(q + STEP * e) - f(q - STEP * e)) / (2 * STEP) for e in np.eye(6)])


def test_axis_2_shifts_the_upper_arm_and_does_not_turn_it(arm):
    q, rng = postures(arm, 20), np.random.default_rng(5)
    turned = q.copy()
    turned[:, 1] += rng.uniform(0.1, 1, 20)
    for robot_poses in (arm.forward, lambda axes: pin_flange(arm, axes), lambda axes: judge(arm).flange(axes)[0]):
        before, after = robot_poses(q), robot_poses(turned)
        np.testing.assert_allclose(after[:, :3, :3], before[:, :3, :3], rtol=0, atol=1e-13)
        way = np.linalg.norm(after[:, :3, 3] - before[:, :3, 3], axis=1)
        chord = 2 * arm.arm.c2 * np.abs(np.sin((turned - q)[:, 1] / 2))
        np.testing.assert_allclose(way, chord, rtol=0, atol=1e-13)


def judge(robot):
    return Mechanism(robot.urdf, robot.X_WR, robot.linkage)


def test_planner_and_judge_see_pins_flange(arm):
    q = postures(arm, 100)
    wanted = pin_flange(arm, q)
    np.testing.assert_allclose(arm.forward(q), wanted, rtol=0, atol=1e-13)
    for part in (q, q[:3]):  # many rows at once, and row by row
        np.testing.assert_allclose(judge(arm).flange(part)[0], wanted[: len(part)], rtol=0, atol=1e-13)


def test_both_jacobians_are_differences_of_pins_flange(arm):
    q = postures(arm, 70)
    J = np.stack([*judge(arm).flange(q)[1][:2], *judge(arm).flange(q[:2])[1]])
    for row, own, other in zip(np.tile(q[:2], (2, 1)), J, arm.jacobian(np.tile(q[:2], (2, 1))), strict=True):
        X = pin_flange(arm, row[None])[0]
        rates = differences(lambda axes: pin_flange(arm, axes[None])[0], row)
        turns = rates[:, :3, :3] @ X[:3, :3].T
        wanted = np.vstack([rates[:, :3, 3].T, turns[:, 2, 1], turns[:, 0, 2], turns[:, 1, 0]])
        for found in (own, other):
            np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-8)


def test_motions_are_differences_of_the_jacobian(arm, X_FT):
    (q,), (qd, qdd) = postures(arm, 1), np.random.default_rng(4).normal(size=(2, 6))
    rate = np.tensordot(qd, differences(lambda axes: arm.jacobian(axes, X_FT), q), axes=1)
    moves, J = arm.differential(q, X_FT), arm.jacobian(q, X_FT)
    np.testing.assert_allclose(moves.bias(qd), rate @ qd, rtol=0, atol=1e-7)
    np.testing.assert_allclose(moves.motion(qd, qdd), [J @ qd, J @ qdd + rate @ qd], rtol=0, atol=1e-6)
    X, V, A = judge(arm).flange_motion(q[None], qd[None], qdd[None])
    np.testing.assert_allclose([V[0], A[0]], arm.differential(q).motion(qd, qdd), rtol=0, atol=1e-10)
    np.testing.assert_allclose(X[0], arm.forward(q), rtol=0, atol=1e-13)


def test_links_of_the_judge_stand_where_the_flange_does(arm):
    q = postures(arm, 5)
    X, _ = judge(arm).links(q)
    np.testing.assert_allclose(X[:, 7], pin_flange(arm, q), rtol=0, atol=1e-13)


def test_every_branch_leads_back_and_the_posture_is_among_them(arm):
    q = postures(arm, 200)
    found, limits = inverse(arm, pin_flange(arm, q)), arm.profile()
    there = np.isfinite(found).all(axis=-1)
    back = pin_flange(arm, found[there])
    assert np.abs(back - pin_flange(arm, q)[np.nonzero(there)[0]]).max() < 1e-9
    assert np.abs(found[there] - arm.middles).max() <= np.pi + 1e-9
    for row, branches, distance in zip(q, found, singularity(arm, q).min(axis=1), strict=True):
        off = branches[arm.branch_of(row)] - row
        assert np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max() < 1e-12 / distance + 1e-9
    inside = np.array([one for _, one in solutions(arm, arm.forward(q[0]), None, limits)])
    assert np.all((inside >= limits.lower) & (inside <= limits.upper))
    assert np.abs(inside - q[0]).max(axis=1).min() < 1e-6


def test_expressions_are_the_numbers(arm):
    symbol, p, R, branch = (ca.SX.sym(*shape) for shape in (("q", 6), ("p", 3), ("R", 3, 3), ("branch", 3)))
    flange = ca.Function("flange", [symbol], [*arm.expressions.flange(symbol)])
    inverse_of = ca.Function("inverse", [p, R, branch, symbol], [*arm.expressions.inverse(p, R, branch, symbol)])
    q = postures(arm, 12)
    for row in q[singularity(arm, q).min(axis=1) > 0.03]:
        X_WF = pin_flange(arm, row[None])[0]
        position, rotation = flange(row)
        np.testing.assert_allclose(np.ravel(position), X_WF[:3, 3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(rotation, X_WF[:3, :3], rtol=0, atol=1e-12)
        X_BF = inverse_pose(arm.X_WB0) @ X_WF
        near = row + np.random.default_rng(2).uniform(-0.2, 0.2, 6)
        own = arm.expressions.branch(arm.branch_of(row))
        np.testing.assert_allclose(np.ravel(inverse_of(X_BF[:3, 3], X_BF[:3, :3], own, near)[0]), row, atol=1e-9)


def test_confdata_has_the_quadrant_of_axis_2_and_asks_for_those_of_1_4_and_6(arm):
    """RAPID reference manual, confdata: cfx of robots that are no serial link robots."""
    for row in postures(arm, 40):
        conf = confdata(arm, row)
        assert conf == ConfData(*np.floor(row[[0, 3, 5, 1]] / (np.pi / 2)).astype(int))
        before = np.cos(arm.arm.signs[2] * urdf_joints(arm, row)[2] + arm.arm.offsets[2]) > 0
        for cfx in (0, 7, conf.cfx):  # a parallelogram does not fold the upper arm past the lower arm's line
            assert confdata_admits(arm, ConfData(conf.cf1, conf.cf4, conf.cf6, cfx), row) == before
        for other in (ConfData(conf.cf1 + 2, conf.cf4, conf.cf6, 0), ConfData(conf.cf1, conf.cf4 + 2, conf.cf6, 0)):
            assert not confdata_admits(arm, other, row)


@pytest.mark.parametrize("seed", range(4))
def test_the_factor_is_what_the_urdfs_directions_make_it(tmp_path, seed):
    robot = some_arm(f"linked {seed}").load(tmp_path)
    text = (tmp_path / "arm.yaml").read_text()
    alike = f"factors: [{robot.linkage:.0f}, 1]"
    assert alike in text
    for wrong in ("factors: [0.5, 1]", f"factors: [{-robot.linkage:.0f}, 1]", f"factors: [{robot.linkage:.0f}, -1]"):
        (tmp_path / "arm.yaml").write_text(text.replace(alike, wrong))
        with pytest.raises(InputError, match="parallelogram") as error:
            load_robot(str(tmp_path / "arm.yaml"))
        assert error.value.line == len(text.splitlines())


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("axis: joint_3", "axis: joint_2"),
        ("axis: joint_3", "axis: joint_6"),
        ("[joint_2, joint_3]", "[joint_5, joint_6]"),
        ("axis: joint_3, ", "axis: joint_3, lower: -1, upper: 1, "),
        ("axis: joint_3, ", ""),
        ("]\n", f", {{axis: joint_3, axes: [joint_2, joint_3], factors: [K, 1], {MADE_UP}}}]\n"),
    ],
)
def test_what_no_parallelogram_makes_is_refused(tmp_path, old, new):
    robot = some_arm("linked 0").load(tmp_path)
    path = tmp_path / "arm.yaml"
    path.write_text(path.read_text().replace(old, new.replace("K", f"{robot.linkage:.0f}")))
    with pytest.raises(InputError) as error:
        load_robot(str(path))
    assert (error.value.file, error.value.line) == (str(path), len(path.read_text().splitlines()))


def test_a_range_of_the_angle_between_the_arms_is_one_of_axes(tmp_path):
    """Of the controller's axes: their difference is the URDF's joint_3."""
    robot = some_arm("linked 0").load(tmp_path)
    path = tmp_path / "arm.yaml"
    low, high = np.quantile(urdf_joints(robot, postures(robot, 200))[:, 2], [0.2, 0.7]).tolist()
    bend = f"{{axes: [joint_2, joint_3], factors: [{-robot.linkage:.0f}, 1], lower: {low}, upper: {high}, {MADE_UP}}}"
    path.write_text(path.read_text().replace("coupled: [", f"coupled: [{bend}, "))
    narrow = load_robot(str(path), robot.X_WR)
    kept = left_out = 0
    for row in postures(robot, 30):
        X = robot.forward(row)
        every, found = (np.array([q for _, q in solutions(one, X, None, one.profile())]) for one in (robot, narrow))
        bent = urdf_joints(robot, every)[:, 2]
        np.testing.assert_allclose(found.reshape(-1, 6), every[(bent >= low) & (bent <= high)], atol=1e-12)
        kept, left_out = kept + len(found), left_out + len(every) - len(found)
    assert min(kept, left_out) > 5
