"""All branches and turns of the inverse, confdata, and what is said of a pose out of reach."""

import re
from dataclasses import replace
from math import cos, pi, radians, sin

import numpy as np
import pytest
from places import crooked_pose

from trajopt_cli.geometry import inverse_pose, pose, rotation_from_wxyz
from trajopt_cli.motion import ConfData
from trajopt_cli.robot.inverse import confdata, confdata_admits, inverse, representatives, solutions, why_unreachable
from trajopt_cli.robot.model import load_robot

# rapid-facts, table of the IRB 140: joints [deg], tool0 [mm], quaternion wxyz, confdata. The last four are one pose,
# their joints as a virtual controller printed them.
TABLE = [
    ([0, 0, 0, 0, 0, 0], [515, 0, 712], [0.707107, 0, 0.707107, 0], [0, 0, 0, 0]),
    ([0, 0, 0, 0, 30, 0], [506.292, 0, 679.5], [0.5, 0, 0.866025, 0], [0, 0, 0, 0]),
    ([0, 0, 0, 0, 90, 0], [450, 0, 647], [0, 0, 1, 0], [0, 0, 0, 0]),
    ([90, 0, 0, 0, 0, 0], [0, 515, 712], [0.5, -0.5, 0.5, 0.5], [1, 0, 0, 0]),
    ([-90, 0, 0, 0, 30, 0], [0, -506.292, 679.5], [0.353553, 0.612372, 0.612372, -0.353553], [-1, 0, 0, 0]),
    ([30, 20, 10, 45, 30, 60], [473.030, 299.640, 452.241], [0.022260, -0.492348, -0.791955, -0.360423], [0, 0, 0, 0]),
    (
        [-45, -30, 20, -100, 60, 200],
        [169.069, -247.468, 745.025],
        [0.784108, 0.580900, -0.212351, 0.051352],
        [-1, -2, 2, 0],
    ),
    (
        [120, 40, -60, 190, -45, -270],
        [-365.491, 617.086, 730.930],
        [0.494994, -0.816436, -0.199234, 0.220725],
        [1, 2, -3, 1],
    ),
    ([23.9625, 6.7721, -7.1508, 90.852, -23.9653, -90.9324], [515, 200, 712], [0.7071, 0, 0.7071, 0], [0, 1, -2, 1]),
    ([23.9625, 92.3536, -172.849, -24.2578, 81.3214, 3.8899], [515, 200, 712], [0.7071, 0, 0.7071, 0], [0, -1, 0, 2]),
    (
        [-156.038, -83.6501, -38.9353, 152.189, 60.5187, 14.5523],
        [515, 200, 712],
        [0.7071, 0, 0.7071, 0],
        [-2, 1, 0, 4],
    ),
    (
        [-156.038, -31.1061, -141.065, 107.04, 25.1372, 71.296],
        [515, 200, 712],
        [0.7071, 0, 0.7071, 0],
        [-2, 1, 0, 6],
    ),
]


@pytest.mark.parametrize(("joints", "p", "quaternion", "conf"), TABLE)
def test_table_of_controller_poses_and_confdata(irb140, joints, p, quaternion, conf):
    q = np.radians(np.array(joints, dtype=float))
    X = irb140.forward(q)
    np.testing.assert_allclose(X[:3, 3] * 1e3, p, rtol=0, atol=0.06)
    np.testing.assert_allclose(X[:3, :3], rotation_from_wxyz(quaternion), rtol=0, atol=2e-4)
    assert confdata(irb140, q) == ConfData(*conf)
    limits = irb140.profile()
    same = [s for cfx, s in solutions(irb140, X, None, limits) if np.abs(s - q).max() < 1e-9]
    assert len(same) == 1


def test_every_solution_of_the_truth_is_found_and_none_extra(irb140, truth):
    limits = irb140.profile()
    for case in truth("irb140_ik.json"):
        X = np.array(case["T_rowmajor_4x4"]).reshape(4, 4)
        found = solutions(irb140, X, None, limits)
        wanted = [
            (s["cfx"], r["q"], ConfData(**r["conf"])) for s in case["solutions"] for r in s["in_limits_representatives"]
        ]
        assert len(found) == len(wanted) == case["n_with_turns"]
        for (cfx, q), (cfx_wanted, q_wanted, conf) in zip(
            sorted(found, key=lambda s: (s[0], *np.round(s[1], 6))),
            sorted(wanted, key=lambda s: (s[0], *np.round(s[1], 6))),
            strict=True,
        ):
            np.testing.assert_allclose(q, q_wanted, rtol=0, atol=1e-10)
            assert (cfx, confdata(irb140, q)) == (cfx_wanted, conf)
            assert confdata_admits(irb140, conf, q)
        branches = inverse(irb140, X[None])[0]
        assert np.isfinite(branches).all(axis=1).sum() == case["n_branches_ignoring_limits"]
        for s in case["solutions"]:
            np.testing.assert_allclose(branches[s["cfx"]], s["q"], rtol=0, atol=1e-10)


def test_branches_lead_back_to_the_pose_from_a_rail_and_a_crooked_mounting(mounted, rng):
    if not mounted.closed_form:
        pytest.skip("branches that are sought step by step have tests of their own: test_offset_wrist.py")
    k = len(mounted.axis_names)
    q = rng.uniform(-3, 3, (3000, k))  # more than one chunk, and no whole number of them
    X = mounted.forward(q)
    rail = q[:, 0] if mounted.has_rail else None
    found = inverse(mounted, X, rail)
    there = np.isfinite(found).all(axis=-1)
    assert np.isnan(found[~there]).all()  # no half answers
    axes = found if rail is None else np.concatenate([np.broadcast_to(rail[:, None, None], (3000, 8, 1)), found], -1)
    residual = np.abs(mounted.forward(np.where(there[..., None], axes, 0.0)) - X[:, None])
    assert residual[there].max() < (1e-11 if mounted.arm.b else 1e-12)  # metres of a root beside a shoulder offset
    for cfx in (np.arange(3000) % 8, 5):  # one branch alone is what it is among all
        np.testing.assert_array_equal(mounted.branch(X, rail, cfx), found[np.arange(3000), cfx])
    # The configuration that made the pose is among the branches, where confdata says it is.
    for row, branches in zip(q[:500, -6:], found, strict=False):
        turned = (branches[confdata(mounted, row).cfx] - row + pi) % (2 * pi) - pi
        assert np.abs(turned).max() < 1e-7


def test_angles_are_wrapped_as_promised(irb140, rng):
    found = inverse(irb140, irb140.forward(rng.uniform(-7, 7, (2000, 6))))
    found = found[np.isfinite(found).all(axis=-1)]
    for joint, low, high in ((0, -pi, pi), (3, -pi, pi), (5, -pi, pi), (2, -1.5 * pi, 0.5 * pi)):
        assert np.all((found[:, joint] > low) & (found[:, joint] <= high))


def test_angles_on_the_seam_take_its_closed_side(irb140):
    arm = irb140.arm
    R = irb140.forward(np.zeros(6))[:3, :3]
    # A hair below the x axis and behind: arctan2 gives -pi, which stands for pi.
    behind = inverse(irb140, pose(R, [-0.4, -1e-20, 0.6])[None])[0]
    assert np.all(behind[:4, 0] == pi)
    assert np.all(behind[4:, 0] == 0.0)
    # Folded as far as the lengths allow, nearer by rounding: q3 = 90 deg on both elbows, never -270.
    fold = arm.c3 - arm.c2 - 1e-15
    folded = inverse(irb140, pose(R, [arm.a1 + arm.c4, 0.0, arm.c1 + fold])[None])[0]
    np.testing.assert_array_equal(folded[:4, 2], pi / 2)


def test_cfx_index_is_the_confdata_of_its_solution(irb140, rng):
    found = inverse(irb140, irb140.forward(rng.uniform(-3, 3, (300, 6))))
    for branches in found:
        for cfx, q in enumerate(branches):
            if np.isfinite(q).all():
                assert confdata(irb140, q).cfx == cfx


def test_singular_poses_are_answered(irb140, truth):
    limits = irb140.profile()
    for case in truth("irb140_singular.json"):
        X = pose(rotation_from_wxyz(case["quat_wxyz"]), case["p"])
        found = solutions(irb140, X, None, limits)
        assert found, case["kind"]
        for _, q in found:
            np.testing.assert_allclose(irb140.forward(q), X, rtol=0, atol=1e-11)
            assert np.all((q >= limits.lower) & (q <= limits.upper))
        if case["kind"].startswith("limit_"):
            assert min(np.abs(q - case["q"]).max() for _, q in found) < 1e-9


def test_conventions_at_the_three_singularities(irb140):
    straight = inverse(irb140, irb140.forward(np.radians([[25, 20, -30, 40, 0, 70]])))[0]
    np.testing.assert_allclose(np.degrees(straight[0]), [25, 20, -30, 0, 0, 110], rtol=0, atol=1e-9)
    np.testing.assert_allclose(np.degrees(straight[1]), [25, 20, -30, 180, 0, -70], rtol=0, atol=1e-9)
    on_axis = pose(irb140.forward(np.zeros(6))[:3, :3], [irb140.arm.c4, 0.0, 0.9])
    found = inverse(irb140, on_axis[None])[0]
    assert np.array_equal(found[:, 0], [0, 0, 0, 0, pi, pi, pi, pi])
    stretched = np.radians([10, 30, -90, 20, 40, 60])
    limits = irb140.profile()
    at_stretch = [q for _, q in solutions(irb140, irb140.forward(stretched), None, limits)]
    assert min(np.abs(q - stretched).max() for q in at_stretch) < 1e-6  # sqrt of rounding: a double root


def test_solutions_beyond_the_stretch_by_rounding_only(irb140):
    turn, arm = radians(10), irb140.arm
    X = irb140.forward(np.array([turn, *np.radians([30, -90, 20, 40, 60])]))
    axis_2 = np.array([arm.a1 * cos(turn), arm.a1 * sin(turn), arm.c1])
    away = X[:3, 3] - arm.c4 * X[:3, 2] - axis_2
    away /= np.linalg.norm(away)
    for stretch, reachable in ((1e-14, True), (1e-9, False)):
        further = X.copy()
        further[:3, 3] += stretch * away
        assert np.isfinite(inverse(irb140, further[None])[0, :4]).any() == reachable
        # Both elbows are one there: a solution must not be told twice.
        found = [q for _, q in solutions(irb140, further, None, irb140.profile())]
        assert len({tuple(q) for q in found}) == len(found)


def test_unreachable_poses_are_named(irb140, truth):
    limits = irb140.profile()
    for case in truth("irb140_unreachable.json"):
        X = pose(rotation_from_wxyz(case["quat_wxyz"]), case["p"])
        assert solutions(irb140, X, None, limits) == []
        said = why_unreachable(irb140, X, None, limits)
        if "outer workspace" in case["why"]:
            assert re.fullmatch(r"wrist centre outside the outer workspace: \S+ m from axis 2, at most 0\.74 m", said)
        elif "axis 3 beyond +50 deg" in case["why"]:
            assert re.search(r"joint_3 = \d\S+°, limit 50°", said)
        else:
            assert re.search(r"joint_2 = 1\d\d\.\S+°, limit 110°|joint_2 = -9\d\.\S+°, limit -90°", said)


def test_reason_gives_value_and_limit_of_the_one_joint_in_the_way(irb140):
    q = np.radians([10, 20, -40, 30, 118, 50])
    limits = irb140.profile()
    tight = replace(limits, lower=np.radians([5, 15, -45, 25, -115, 45]), upper=np.radians([15, 25, -35, 35, 115, 55]))
    said = why_unreachable(irb140, irb140.forward(q), None, tight)
    assert said == "every branch needs joint_5 beyond its range: nearest joint_5 = 118°, limit 115° (cfx 0)"
    open_5 = replace(tight, upper=np.where(np.arange(6) == 4, 2.2, tight.upper))
    q_2 = np.array([*q[:5], radians(56)])
    said = why_unreachable(irb140, irb140.forward(q_2), None, open_5)
    assert said == "every branch needs joint_6 beyond its range: nearest joint_6 = 56°, limit 55° (cfx 0)"


def test_reason_names_the_nearest_turn(irb140):
    q = np.radians([10, 20, -40, 30, 40, 30])
    limits = irb140.profile()
    far = replace(limits, lower=np.radians([0, 0, -60, 0, 0, 395]), upper=np.radians([20, 40, -20, 60, 60, 400]))
    said = why_unreachable(irb140, irb140.forward(q), None, far)
    assert said == "every branch needs joint_6 beyond its range: nearest joint_6 = 390°, limit 395° (cfx 0)"


def test_reason_inside_the_inner_workspace(irb140):
    limits = irb140.profile()
    # 10 mm above axis 2, seen from both shoulders: the forward one is too near, the backward one reaches over.
    X = pose(irb140.forward(np.zeros(6))[:3, :3], [0.07 + 0.065, 0.0, 0.362])
    assert not np.isfinite(inverse(irb140, X[None])[0, :4]).any()
    assert np.isfinite(inverse(irb140, X[None])[0, 4:]).all()
    # An arm standing on its own axis has no other shoulder.
    centred = replace(irb140, arm=replace(irb140.arm, a1=0.0))
    said = why_unreachable(centred, pose(X[:3, :3], [0.065, 0.0, 0.362]), None, limits)
    assert said == (
        "wrist centre inside the inner workspace: 0.01 m from axis 2, at least 0.02 m"
        " (turned by half a turn 0.01 m, at most 0.74 m)"
    )


def test_rail_outside_its_stroke_is_an_answer():
    robot = load_robot("irb140_rail")
    limits = robot.profile()
    q = np.array([2.5, 0, 0, 0, 0, 0.5, 0])
    X = robot.forward(q)
    assert solutions(robot, X, 2.5, limits) == []
    assert why_unreachable(robot, X, 2.5, limits) == "rail = 2.5 m, outside its stroke 0..2 m"
    assert solutions(robot, X, 2.0, limits)
    with pytest.raises(ValueError, match="the pose has solutions"):
        why_unreachable(robot, X, 2.0, limits)
    with pytest.raises(ValueError, match="rides a rail: give rail"):
        inverse(robot, X[None])
    for cfx in (-1, 8):
        with pytest.raises(ValueError, match=f"branches {cfx} to {cfx}: they are 0 to 7"):
            robot.branch(X[None], np.zeros(1), cfx)


def test_why_a_pose_is_out_of_reach_depends_on_the_rail():
    robot = load_robot("irb140_rail", X_WR=crooked_pose(7))
    X, limits = robot.forward(np.array([0.5, 0.3, 0.2, -0.4, 0.5, 0.6, 0.7])), robot.profile()
    for rail in (1.4, 1.9):
        w = inverse_pose(robot.base(rail)) @ X @ np.array([0, 0, -0.065, 1.0])
        near = np.hypot(np.hypot(w[0], w[1]) - 0.07, w[2] - 0.352)
        assert robot.why_unreachable(X, rail, limits) == (
            f"wrist centre outside the outer workspace: {near:.6g} m from axis 2, at most 0.74 m"
        )
    tight = replace(limits, upper=np.where(np.arange(7) == 6, 0.69, limits.upper))
    tight = replace(tight, lower=np.where(np.arange(7) == 0, 0.0, np.array([0, 0.29, 0.19, -0.41, 0.49, 0.59, 0.5])))
    said = robot.why_unreachable(X, 0.5, tight)
    assert f"joint_6 = {np.degrees(0.7):.6g}°, limit {np.degrees(0.69):.6g}° (cfx 0)" in said


def test_representatives_are_all_turns_within_the_limits():
    lower, upper = np.radians([-180, -90, -230, -200, -115, -400]), np.radians([180, 110, 50, 200, 115, 400])
    q = np.radians([180, 0, 0, 170, 10, -30])
    found = np.degrees(representatives(q, lower, upper))
    wanted = [[j1, 0, 0, j4, 10, j6] for j1 in (-180, 180) for j4 in (-190, 170) for j6 in (-390, -30, 330)]
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9)
    assert representatives(np.radians([0, 0, 0, 0, 116, 0]), lower, upper).shape == (0, 6)
    assert representatives(np.full(6, np.nan), lower, upper).shape == (0, 6)
    over = upper + 5e-10
    assert np.array_equal(representatives(over, lower, upper)[-1], upper)
    assert representatives(upper + np.array([0, 2e-9, 0, 0, 0, 0]), lower, upper).shape == (0, 6)


def test_confdata_at_and_beside_multiples_of_a_quadrant(irb140):
    for angle, cf in (
        (-90, -1),
        (-90 - 1e-9, -1),
        (-90.001, -2),
        (0, 0),
        (-1e-9, 0),
        (-0.001, -1),
        (90, 1),
        (-270, -3),
    ):
        q = np.radians([angle if abs(angle) <= 180 else 0, 0, 0, 0, 10, angle])
        assert confdata(irb140, q).cf6 == cf


def test_confdata_admits_the_neighbour_only_at_rounding_distance(irb140):
    q = np.radians([90, 10, -20, 30, 40, 50])
    for shift, quadrants in ((0.0, {0, 1}), (5e-7, {0, 1}), (-5e-7, {0, 1}), (3e-6, {1}), (-3e-6, {0})):
        moved = q + np.array([shift, 0, 0, 0, 0, 0])
        assert {cf for cf in range(-4, 4) if confdata_admits(irb140, ConfData(cf, 0, 0, 0), moved)} == quadrants
    straight = np.radians([10, 10, -20, 30, 0, 50])
    assert confdata_admits(irb140, ConfData(0, 0, 0, 1), straight)
    assert not confdata_admits(irb140, ConfData(0, 0, 0, 1), straight + np.array([0, 0, 0, 0, 3e-6, 0]))
    assert not confdata_admits(irb140, ConfData(0, 0, 0, 2), straight)


def test_branches_and_labels_equal_py_opw_kinematics(irb140, rng):
    opw = pytest.importorskip("py_opw_kinematics")
    from scipy.spatial.transform import RigidTransform

    model = opw.KinematicModel(0.07, 0, 0, 0.352, 0.36, 0.38, 0.065, offsets=(0, 0, -pi / 2, 0, 0, 0))
    X = irb140.forward(rng.uniform(-3, 3, (200, 6)))
    result = opw.Robot(model, degrees=False).reach(RigidTransform.from_matrix(X))
    theirs = np.asarray(result.joints if hasattr(result, "joints") else result[0])
    cfx_of_slot = [0, 2, 4, 6, 1, 3, 5, 7]
    ours = inverse(irb140, X)[:, cfx_of_slot]
    np.testing.assert_array_equal(np.isfinite(ours).all(axis=-1), np.isfinite(theirs).all(axis=-1))
    apart = np.abs((ours - theirs + pi) % (2 * pi) - pi)
    assert np.nanmax(apart) < 1e-6


def test_number_and_place_of_solutions_equal_eaik(irb140, rng):
    dh = pytest.importorskip("eaik.IK_DH")
    half = pi / 2
    robot = dh.DhRobot(
        np.array([-half, 0, -half, half, -half, 0]),
        np.array([0.07, 0.36, 0, 0, 0, 0]),
        np.array([0.352, 0, 0, 0.38, 0, 0.065]),
    )
    X = irb140.forward(rng.uniform(-3, 3, (200, 6)))
    ours = inverse(irb140, X)
    for pose_, branches in zip(X, ours, strict=True):
        answer = robot.IK(pose_)
        theirs = np.array([q for q, least in zip(answer.Q, answer.is_LS, strict=True) if not least])
        theirs = theirs - [0, -half, 0, 0, 0, pi]
        mine = branches[np.isfinite(branches).all(axis=1)]
        assert len(mine) == len(theirs)
        apart = np.abs((mine[:, None] - theirs[None] + pi) % (2 * pi) - pi).max(axis=-1)
        assert apart.min(axis=1).max() < 1e-6
        assert apart.min(axis=0).max() < 1e-6
