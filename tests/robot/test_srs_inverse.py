"""Eight configurations at an arm angle: truth, invariants, singularities, what is said of a pose out of reach."""

from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import TRUTH, crooked_pose

from trajopt_cli.geometry import pose, rotation_about, rotation_from_wxyz
from trajopt_cli.robot.srs import SrsLengths, load_srs
from trajopt_cli.robot.srs_inverse import (
    ArmAngle,
    arm_angle,
    configuration,
    inverse,
    inverse_branch,
    singularities,
    why_unreachable,
)
from trajopt_cli.robot.srs_step import SrsStep

HUNG = load_srs("iiwa7", crooked_pose(9))
LIMITS = HUNG.profile()
BOTH = pytest.mark.parametrize("definition", list(ArmAngle))


@pytest.fixture(scope="module")
def iiwa7():
    return load_srs("iiwa7")


def wrapped(angle):
    return (np.asarray(angle) + pi) % (2 * pi) - pi


def index(gc):
    return sum(bit * (sign < 0) for bit, sign in zip((1, 2, 4), gc, strict=True))


def poses(cases):
    return pose(rotation_from_wxyz([c["quat_wxyz"] for c in cases]), [c["p"] for c in cases])


def postures(rng, n):
    return rng.uniform(LIMITS.lower, LIMITS.upper, (n, 7))


@pytest.mark.parametrize(
    ("solutions", "angle", "definition"),
    [("all_8", "arm_angle", ArmAngle.FARIA), ("same_elbow_8", "swivel_up", ArmAngle.SWIVEL)],
)
def test_all_eight_are_the_truths(iiwa7, truth, solutions, angle, definition):
    cases = truth("iiwa7_ik.json")
    assert len(cases) == 50
    psi = np.array([c[angle] for c in cases])
    found = inverse(iiwa7, poses(cases), psi, definition)
    wanted = np.full((50, 8, 7), np.nan)
    for i, case in enumerate(cases):
        for one in case[solutions]:
            wanted[i, index(one["GC"])] = one["q"]
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(configuration(wanted), np.tile(np.arange(8), (50, 1)))
    np.testing.assert_allclose(wrapped(arm_angle(iiwa7, wanted, definition) - psi[:, None]), 0, atol=1e-12)
    own = np.array([c["config_bits"] for c in cases])
    if definition is ArmAngle.FARIA:
        np.testing.assert_allclose(found[range(50), own], [c["q"] for c in cases], rtol=0, atol=1e-12)


def test_arm_angle_and_configuration_are_the_truths(iiwa7, truth):
    cases = truth("iiwa7_fk.json")
    q = np.array([c["q"] for c in cases])
    found = arm_angle(iiwa7, q, ArmAngle.FARIA)
    np.testing.assert_allclose(wrapped(found - [c["arm_angle"] for c in cases]), 0, atol=1e-12)
    np.testing.assert_array_equal(configuration(q), [c["config_bits"] for c in cases])
    assert configuration(q[0]) == cases[0]["config_bits"]


def test_singular_and_boundary_postures_of_the_truth(iiwa7):
    path = TRUTH / "iiwa7_singular_unreachable.json"
    import json

    cases = json.loads(path.read_text())["singular_and_boundary"]
    assert len(cases) == 19
    for case in cases:
        X, psi, q = poses([case]), case["arm_angle"], np.array(case["q"])
        found = inverse(iiwa7, X, psi, ArmAngle.FARIA)[0]
        np.testing.assert_allclose(iiwa7.forward(found), np.tile(X, (8, 1, 1)), rtol=0, atol=1e-12)
        np.testing.assert_allclose(wrapped(arm_angle(iiwa7, q, ArmAngle.FARIA) - psi), 0, atol=1e-12)
        own = found[index(case["GC"])]
        offset = abs(case["offset"])
        if case["kind"].startswith("limit"):
            np.testing.assert_allclose(own, q, rtol=0, atol=1e-12)
            continue
        # Joints 1 and 3, or 5 and 7, are sharp only in sum, each for itself to rounding over the offset.
        first = 0 if case["kind"] == "shoulder_q2" else 4
        pair = [first, first + 2]
        rest = [i for i in range(7) if i not in pair]
        np.testing.assert_allclose(own[rest], q[rest], rtol=0, atol=1e-12)
        assert own[pair].sum() == pytest.approx(q[pair].sum(), abs=1e-12)
        if offset:
            np.testing.assert_allclose(own[pair], q[pair], rtol=0, atol=max(1e-12, 1e-15 / offset))
        else:
            assert own[first] == 0.0
            assert found[index(case["GC"]) ^ (1 if first == 0 else 4)][first] == pi


def test_unreachable_poses_of_the_truth_are_told_with_figures(iiwa7):
    path = TRUTH / "iiwa7_singular_unreachable.json"
    import json

    cases = json.loads(path.read_text())["unreachable"]
    assert len(cases) == 10
    for case, X in zip(cases, poses(cases), strict=True):
        q = inverse(iiwa7, X[None], 0.3, ArmAngle.SWIVEL)
        said = why_unreachable(iiwa7, X, 0.3, ArmAngle.SWIVEL, iiwa7.profile())
        distance = np.linalg.norm(X[:3, 3] - 0.126 * X[:3, 2] - [0, 0, 0.34])
        if "beyond" in case["why"]:
            assert np.isnan(q).all()
            assert said == f"wrist centre out of reach: {distance:.6g} m from the shoulder, at most 0.8 m"
        else:
            assert np.isfinite(q).all()  # joint limits are not applied
            wanted = f"{distance:.6g} m from the shoulder, at least 0.4 m with joint_4 at 120°"
            assert said == f"wrist centre too near: {wanted}"


@BOTH
def test_forward_of_the_inverse_is_the_pose_and_the_sampled_posture_is_among_the_eight(rng, X_FT, definition):
    q = postures(rng, 1500)  # more than one chunk
    X = HUNG.forward(q)
    psi = arm_angle(HUNG, q, definition)
    found = inverse(HUNG, X, psi, definition)
    np.testing.assert_allclose(HUNG.forward(found), np.broadcast_to(X[:, None], (1500, 8, 4, 4)), rtol=0, atol=1e-12)
    np.testing.assert_array_equal(configuration(found), np.tile(np.arange(8), (1500, 1)))
    apart = np.abs(found[range(1500), configuration(q)] - q).max(axis=1)
    near = np.abs(np.sin(q[:, 1::2])).min(axis=1)  # sharp to rounding over the distance from a singularity
    assert np.all(apart < 1e-14 / np.minimum(near, 0.1) ** 2)
    one = np.array([inverse_branch(HUNG, X, psi, definition, i) for i in range(8)])
    np.testing.assert_array_equal(one.transpose(1, 0, 2), found)
    three = inverse_branch(HUNG, X, np.array([psi, psi + 0.3, psi - 1.0]), definition, 5)  # at each pose
    np.testing.assert_array_equal(three[0], one[5])
    np.testing.assert_array_equal(three[2], inverse_branch(HUNG, X, psi - 1.0, definition, 5))


def test_eight_elbows_are_one_by_swivel_and_two_by_faria(rng):
    X = HUNG.forward(postures(rng, 50))
    for definition, sides in ((ArmAngle.SWIVEL, 1), (ArmAngle.FARIA, 2)):
        _, _, points = HUNG.axes_and_points(inverse(HUNG, X, 0.7, definition))
        elbow = points[:, 3]  # (3, n, 8)
        for i in range(8):
            partner = i & 2 if sides == 2 else 0
            np.testing.assert_allclose(elbow[..., i], elbow[..., partner], rtol=0, atol=1e-12)
        line = points[:, 6, :, 0] - points[:, 0, :, 0]
        foot = points[:, 0, :, 0] + line * np.sum((elbow[..., 0] - points[:, 0, :, 0]) * line, 0) / np.sum(line**2, 0)
        opposite = 2 * foot - elbow[..., 0]
        np.testing.assert_allclose(elbow[..., 2], opposite if sides == 2 else elbow[..., 0], rtol=0, atol=1e-12)


def test_zero_is_where_each_definition_says(iiwa7):
    """Swivel 0 holds the elbow in the upright plane above the line; Faria 0 is the posture with q3 = 0."""
    q = np.radians([20, 40, 0, 60, 10, 30, 50])
    for sign in (1, -1):
        q[3] = sign * radians(60)
        assert arm_angle(iiwa7, q, ArmAngle.FARIA) == pytest.approx(0, abs=1e-12)
        X = iiwa7.forward(q)[None]
        above = inverse_branch(iiwa7, X, 0.0, ArmAngle.SWIVEL, int(configuration(q)))
        _, _, points = iiwa7.axes_and_points(above)
        shoulder, elbow, wrist = points[:, 0, 0], points[:, 3, 0], points[:, 6, 0]
        normal = np.cross(wrist - shoulder, [0, 0, 1])
        assert (elbow - shoulder) @ normal == pytest.approx(0, abs=1e-12)
        middle = (shoulder + wrist) / 2
        assert elbow[2] > middle[2] + 0.03
    # A right-hand turn about S -> W by a small angle moves the elbow along n x b.
    psi = 0.01
    turned = inverse_branch(iiwa7, X, psi, ArmAngle.SWIVEL, int(configuration(q)))
    _, _, points_2 = iiwa7.axes_and_points(turned)
    n = (wrist - shoulder) / np.linalg.norm(wrist - shoulder)
    wanted = middle + rotation_about(n, psi) @ (elbow - middle)
    np.testing.assert_allclose(points_2[:, 3, 0], wanted, rtol=0, atol=1e-12)


@BOTH
def test_swivel_and_faria_differ_by_half_a_turn_where_q4_is_positive(rng, definition):
    q = postures(rng, 200)
    swivel, faria = arm_angle(HUNG, q, ArmAngle.SWIVEL), arm_angle(HUNG, q, ArmAngle.FARIA)
    shift = np.where(q[:, 3] < 0, 0.0, pi)
    np.testing.assert_allclose(wrapped(swivel - faria - shift + 1) - 1, 0, atol=1e-12)
    both = np.array([swivel, faria])
    assert np.all((both > -pi) & (both <= pi))


@BOTH
@pytest.mark.parametrize(
    "degrees",
    [
        [20, 0, 30, 60, 40, 50, 60],  # q2 = 0
        [20, 35, 30, 0, 40, 50, 60],  # stretched
        [20, 35, 30, 60, 40, 0, 60],  # q6 = 0
        [20, 0, 30, 0, 40, 0, 60],  # straight up
        [0, 0, 0, 0, 0, 0, 0],
        [20, 50, 0, 100, 40, 50, 60],  # wrist centre on axis 1, elbow ahead
        [20, -50, 180, -100, 40, 50, 60],
        [20, 35, 30, 180, 40, 50, 60],  # wrist centre in the shoulder
        [20, 180, 30, 60, 40, 50, 60],
        [20, 35, 30, 60, 40, 180, 60],
        [20, 180, 30, 0, 40, 180, 60],
        [20, 90, 30, 1e-9, 40, 50, 60],
    ],
)
def test_singular_postures_have_eight_finite_answers_with_the_right_pose(iiwa7, degrees, definition):
    q = np.radians(np.array(degrees, dtype=float))
    X = iiwa7.forward(q)[None]
    psi = float(arm_angle(iiwa7, q, definition))
    found = inverse(iiwa7, X, psi, definition)[0]
    np.testing.assert_allclose(iiwa7.forward(found), np.tile(X, (8, 1, 1)), rtol=0, atol=1e-12)
    _, _, points = iiwa7.axes_and_points(q[None])
    _, _, again = iiwa7.axes_and_points(found)
    own = int(configuration(q))
    if degrees[3] != 180:  # there the circle of elbows has no axis, and the base's z is taken
        np.testing.assert_allclose(again[:, 3, own], points[:, 3, 0], rtol=0, atol=1e-7)  # the elbow stays where it was
    for tilt, turn in ((1, 0), (5, 4)):
        upright = np.abs(found[:, tilt]) < 1e-13
        assert bool(upright[own]) is (degrees[tilt] == 0)
        assert set(found[upright, turn]) in ({0.0, pi}, set())


def test_the_axis_1_line_is_crossed_with_azimuth_zero(iiwa7):
    X = pose(np.eye(3), [0, 0, 0.34 + 0.5 + 0.126])[None]
    swivel = inverse_branch(iiwa7, X, 0.0, ArmAngle.SWIVEL, 0)[0]
    assert abs(swivel[0]) == pi  # b_0 points along -x
    faria = inverse_branch(iiwa7, X, 0.0, ArmAngle.FARIA, 0)[0]
    assert faria[0] == 0.0
    turned = inverse_branch(iiwa7, X, 0.3, ArmAngle.FARIA, 0)[0]
    assert turned[0] == pytest.approx(0.3, abs=1e-12)


def test_reach_ends_at_the_stretched_arm(iiwa7):
    for excess, reached in ((0.0, True), (5e-13, True), (2e-12, False), (1e-6, False)):
        X = pose(np.eye(3), np.array([0.8 + excess, 0, 0.34 + 0.126]))[None]
        found = inverse(iiwa7, X, 0.2, ArmAngle.SWIVEL)
        assert bool(np.isfinite(found).all()) is reached
        assert bool(np.isnan(found).all()) is not reached
    unequal = replace(iiwa7, lengths=SrsLengths(0.34, 0.42, 0.4, 0.126))
    for distance, reached in ((0.0, False), (0.0199, False), (0.02, True), (0.3, True), (0.82, True)):
        X = pose(rotation_about([0, 1, 0], 0.3), [0, 0, 0])[None]
        X[0, :3, 3] = [distance * 0.6, distance * 0.8, 0.34]
        X[0, :3, 3] += 0.126 * X[0, :3, 2]
        found = inverse(unequal, X, 0.2, ArmAngle.FARIA)
        assert bool(np.isfinite(found).all()) is reached, distance
        if reached:
            np.testing.assert_allclose(unequal.forward(found[0]), np.tile(X, (8, 1, 1)), rtol=0, atol=1e-12)


@settings(max_examples=60, deadline=None)
@given(
    st.lists(
        st.sampled_from([-2.0, -1.5707963267948966, -1e-6, -1e-9, 0.0, 1e-13, 1e-9, 0.5, pi]), min_size=7, max_size=7
    ),
    st.sampled_from(ArmAngle),
)
def test_any_posture_comes_back_with_its_pose(q, definition):
    q = np.array(q)
    X = HUNG.forward(q)[None]
    found = inverse(HUNG, X, float(arm_angle(HUNG, q, definition)), definition)[0]
    assert np.isfinite(found).all()
    np.testing.assert_allclose(HUNG.forward(found), np.tile(X, (8, 1, 1)), rtol=0, atol=2e-12)
    assert np.all((found[:, ::2] > -pi) & (found[:, ::2] <= pi))
    assert np.all(np.abs(found[:, 1::2]) <= pi)


def test_continuous_along_a_path_through_the_wrist_singularity(iiwa7):
    """At a fixed arm angle the elbow moves evenly, and joint_6 may pass zero only by changing the configuration."""
    q_0, q_1 = (np.radians(v) for v in ([10, 30, 20, 70, 15, 20, 30], [25, 40, 10, 90, 25, 45, 0]))
    q = q_0 + np.linspace(0, 1, 400)[:, None] * (q_1 - q_0)
    X, psi = iiwa7.forward(q), arm_angle(iiwa7, q, ArmAngle.SWIVEL)
    np.testing.assert_allclose(inverse_branch(iiwa7, X, psi, ArmAngle.SWIVEL, 0), q, rtol=0, atol=1e-12)


def test_singularities_are_named_once_per_stretch_at_their_nearest_sample(iiwa7):
    q = np.tile(np.radians([10.0, 40, 20, 70, 15, 20, 30]), (100, 1))
    q[:, 5] = np.abs(np.linspace(-0.495, 0.495, 100)) + 0.002
    q[20:25, 3] = [0.02, 0.006, -0.003, 0.009, 0.02]
    q[60, 3] = 0.001
    q[80, 1] = 0.004
    found = singularities(iiwa7, q, 0.01)
    assert [(one.index, one.name.split(":")[0], one.unit) for one in found] == [
        (22, "elbow stretched", "rad"),
        (49, "joint_6 = 0", "rad"),
        (60, "elbow stretched", "rad"),
        (80, "joint_2 = 0", "rad"),
    ]
    assert found[0].value == pytest.approx(0.003)
    on_axis = np.radians([[20.0, 50, 0, 100, 40, 50, 60]])
    (one,) = singularities(iiwa7, on_axis, 0.01)
    assert one.name == "wrist centre on axis 1: the arm angle has no reference"
    assert one.unit == "m"
    assert one.value < 1e-12
    assert singularities(iiwa7, np.radians([[20.0, 50, 0, 90, 40, 50, 60]]), 0.01) == []


def test_reasons_name_the_joint_its_value_and_its_limit(iiwa7):
    q = np.radians([10, 30, 20, 70, 15, 40, 30])
    X, psi = iiwa7.forward(q), float(arm_angle(iiwa7, q, ArmAngle.SWIVEL))
    limits = iiwa7.profile()
    bound = np.radians([170, 120, 170, 60, 170, 120, 175])
    tight = replace(limits, upper=bound, lower=-bound)
    said = why_unreachable(iiwa7, X, psi, ArmAngle.SWIVEL, tight)
    assert said.startswith(
        "wrist centre too near: 0.655322 m from the shoulder, at least 0.69282 m with joint_4 at 60°"
    )
    single = replace(limits, lower=np.where(np.arange(7) == 6, radians(31), q - 0.01), upper=q + 0.1)
    said = why_unreachable(iiwa7, X, psi, ArmAngle.SWIVEL, single)
    assert said == (
        f"at arm angle {np.degrees(psi):.6g}° every branch needs joint_7 beyond its range:"
        " nearest joint_7 = 30°, limit 31° (configuration 0)"
    )
    with pytest.raises(ValueError, match="a configuration reaches the pose"):
        why_unreachable(iiwa7, X, psi, ArmAngle.SWIVEL, limits)


def test_wrong_shapes_and_configurations_are_named(iiwa7):
    with pytest.raises(ValueError, match=r"X_WF has shape \(4, 4\), wanted \(n, 4, 4\)"):
        inverse(iiwa7, np.eye(4), 0.0, ArmAngle.FARIA)
    with pytest.raises(ValueError, match=r"arm_angle has shape \(3,\), wanted one number or \(2,\)"):
        inverse(iiwa7, np.tile(np.eye(4), (2, 1, 1)), np.zeros(3), ArmAngle.FARIA)
    with pytest.raises(ValueError, match=r"configuration 8, wanted 0\.\.7"):
        inverse_branch(iiwa7, np.eye(4)[None], 0.0, ArmAngle.FARIA, 8)
    assert inverse(iiwa7, np.empty((0, 4, 4)), 0.0, ArmAngle.FARIA).shape == (0, 8, 7)


@BOTH
def test_a_wrist_centre_in_the_shoulder_holds_the_elbow_level(iiwa7, definition):
    """Where W comes from does not matter within 1e-12 m: the line is taken as the base's z, its azimuth as 0."""
    for offset in ([0, 0, 0], [3e-13, 0, 0], [0, -3e-13, 0], [0, 0, -3e-13], [1e-13, 2e-13, 1e-13]):
        X = pose(np.eye(3), np.array([0, 0, 0.34 + 0.126]) + offset)[None]
        found = inverse(iiwa7, X, 0.3, definition)[0]
        np.testing.assert_allclose(np.abs(found[:, 1]), pi / 2, rtol=0, atol=1e-11)
        np.testing.assert_allclose(np.abs(found[:, 3]), pi, rtol=0, atol=1e-11)
        wanted = pi + 0.3 if definition is ArmAngle.SWIVEL else 0.3
        np.testing.assert_allclose(wrapped(found[0, 0] - wanted), 0, atol=1e-11)
        np.testing.assert_allclose(iiwa7.forward(found), np.tile(X, (8, 1, 1)), rtol=0, atol=2e-12)
        step = SrsStep(iiwa7, definition, 5, 0.3)
        np.testing.assert_allclose(step.joints(tuple(np.eye(3).ravel()), tuple(X[0, :3, 3])), found[5], atol=1e-11)
