"""Joints along a sequence: the right ones, without jumps, and every limit broken said with time, value and limit."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from joint_ways import HOME, H, line, product_forward, quintic, sequence, spin

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.joint_checks import Arm, stops_loop
from trajopt_cli.iiwa.task.joints import Followed, Unfollowable, follow
from trajopt_cli.iiwa.task.model import AngleMeaning
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle, configuration

TRUTH = Path(__file__).parents[2] / "data" / "truth" / "iiwa7_ik.json"
ROBOT = load_srs("iiwa7")
LIMITS = ROBOT.profile()
FLANGE = np.eye(4)
MOUNT = pose(rotation_about([0, 0, 1], 0.7) @ rotation_about([0, 1, 0], 0.3), [0.4, -0.2, 0.9])
TOOL = pose(rotation_about([1, 0, 0], 0.5), [0.03, -0.02, 0.15])


def followed(way: Equilibrium, start: Array = HOME, arm_angle: float | None = None, free: bool = False) -> Followed:
    answer = follow(way, Arm(ROBOT, FLANGE, start, LIMITS, given=arm_angle), free)
    assert isinstance(answer, Followed)
    return answer


def found(answer: Followed, check: str, joint: str) -> Finding:
    return next(one for one in answer.findings if (one.check, one.subject) == (check, joint))


def failed(answer: Followed) -> list[tuple[str, str]]:
    return [(one.check, one.subject) for one in answer.findings if not one.passed]


def truth_cases() -> list[dict[str, Any]]:
    cases: list[dict[str, Any]] = json.loads(TRUTH.read_text(encoding="utf-8"))["cases"]
    return cases


@pytest.mark.parametrize("definition", ArmAngle)
def test_from_every_true_case_the_joints_and_every_pose_come_back(definition: ArmAngle) -> None:
    robot = ROBOT.mounted(MOUNT)
    for case in truth_cases():
        start = np.array(case["q"])
        X_WT = product_forward(start[None], MOUNT)[0] @ TOOL
        share = quintic(41)[:, None]
        shoulder = MOUNT[:3, 3] + 0.34 * MOUNT[:3, 2]
        by = 0.02 * (shoulder - X_WT[:3, 3])  # inwards: some cases are all but stretched
        turn = np.array([1e-3, -2e-3, 1.5e-3])
        wanted = np.concatenate([X_WT[:3, 3] + share * by, share * turn], axis=1)
        way = line(X_WT, by, turn, 0.04)
        answer = follow(way, Arm(robot, TOOL, start, LIMITS, definition))
        assert isinstance(answer, Followed)
        q = answer.trajectory.q
        np.testing.assert_allclose(q[0], start, rtol=0, atol=1e-9)
        X = product_forward(q, MOUNT) @ TOOL
        np.testing.assert_allclose(X[:, :3, 3], wanted[:, :3], rtol=0, atol=1e-12)
        a, b, g = wanted[:, 3:].T
        R = rotation_about([0, 0, 1], g) @ rotation_about([0, 1, 0], b) @ rotation_about([1, 0, 0], a)
        np.testing.assert_allclose(X[:, :3, :3], R @ X_WT[:3, :3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(answer.X_WF, X @ inverse_pose(TOOL), rtol=0, atol=1e-12)
        assert answer.configuration == case["config_bits"]
        assert set(configuration(q)) == {case["config_bits"]}
        np.testing.assert_allclose(
            np.angle(np.exp(1j * (arm_angle(robot, q, definition) - answer.arm_angle))), 0, atol=1e-9
        )


@settings(max_examples=40, deadline=None)
@given(
    q=st.tuples(*[st.floats(-0.7, 0.7)] * 7),
    by=st.tuples(*[st.floats(-0.1, 0.1)] * 3),
    turn=st.tuples(*[st.floats(-1.0, 1.0)] * 3),
    delta=st.one_of(st.none(), st.floats(-3.1, 3.1)),
)
def test_whatever_is_followed_is_the_way_itself(q: Any, by: Any, turn: Any, delta: float | None) -> None:
    start = np.array(q) * LIMITS.upper
    X = product_forward(start[None])[0]
    way = line(X, np.array(by), np.array(turn), 0.5, h=5e-3)
    answer = follow(way, Arm(ROBOT, FLANGE, start, LIMITS, ArmAngle.SWIVEL, delta))
    if isinstance(answer, Unfollowable):
        d = wrist_distance(way.pose, way.rotations(X[:3, :3]))
        assert d[answer.index] > 0.8 - 1e-12
        assert (d[: answer.index] <= 0.8 + 1e-12).all()
        return
    reached = product_forward(answer.trajectory.q)
    # near a singularity two joints share one turn, each with its own rounding
    np.testing.assert_allclose(reached[:, :3, 3], way.pose[:, :3], rtol=0, atol=1e-11)
    np.testing.assert_allclose(reached[:, :3, :3], way.rotations(X[:3, :3]), rtol=0, atol=1e-11)
    assert np.abs(np.diff(answer.trajectory.q, axis=0)).max() <= np.pi


def wrist_distance(rows: Array, R: Array) -> Array:
    return np.asarray(np.linalg.norm(rows[:, :3] - 0.126 * R[:, :, 2] - [0, 0, 0.34], axis=1))


def test_the_last_row_is_the_exact_end_pose_and_the_arm_rests_at_both_ends() -> None:
    X = ROBOT.forward(HOME)
    answer = followed(line(X, np.array([0, 0.2, 0]), np.array([0, 0, 0.4]), 1.0))
    last = product_forward(answer.trajectory.q[-1:])[0]
    np.testing.assert_allclose(last[:3, 3], X[:3, 3] + [0, 0.2, 0], rtol=0, atol=1e-14)
    q, qd = answer.trajectory.q, answer.trajectory.qd
    assert qd is not None
    np.testing.assert_array_equal(qd[[0, -1]], 0.0)
    np.testing.assert_allclose(qd[400], (q[401] - q[399]) / 2e-3, rtol=1e-12)
    assert answer.trajectory.names == tuple(f"joint_{j}" for j in range(1, 8))
    assert failed(answer) == []


def test_a_speed_on_its_limit_passes_and_one_just_above_is_named() -> None:
    X = ROBOT.forward(HOME)
    on = followed(spin(X, np.arange(601) * H * np.pi))  # joint_7 may do 180 deg/s
    speed = found(on, "speed", "joint_7")
    assert speed.passed
    assert (speed.limit, speed.unit) == (pytest.approx(np.pi, rel=1e-15), "rad/s")
    assert speed.value == pytest.approx(np.pi, rel=1e-9)
    assert any(note.startswith("joint_7 uses 100.0 % of its speed limit") for note in on.notes)
    angles = np.arange(601) * H * 0.5 * np.pi
    angles[401:] += H * np.pi * 0.50001  # one step at 1.00001 of the limit, from row 400 on
    above = followed(spin(X, angles))
    assert ("speed", "joint_7") in failed(above)
    speed = found(above, "speed", "joint_7")
    assert speed.time == pytest.approx(0.4)
    assert speed.message == (
        "joint_7 speed 180.002°/s at t = 0.400 s (a -> b, 67 % of the way), limit 180°/s;"
        " let the arm angle move (--arm-angle free) or lower v_max or omega_max there"
    )


def test_speeds_and_accelerations_are_the_differences_of_the_joints() -> None:
    answer = followed(line(ROBOT.forward(HOME), np.array([0.1, 0.25, -0.1]), np.array([0.3, 0, 0.6]), 0.6))
    for j, name in enumerate(answer.trajectory.names):
        q = answer.trajectory.q[:, j].tolist()
        steps = [b - a for a, b in pairwise(q)]
        speed = found(answer, "speed", name)
        fastest = max(range(len(steps)), key=lambda k: abs(steps[k]))
        assert speed.value == pytest.approx(abs(steps[fastest]) / H, rel=1e-12)
        assert speed.time == pytest.approx(fastest * H)
        assert speed.passed == (speed.value <= LIMITS.velocity[j])
        bends = [2 * abs(steps[0]), *(abs(b - a) for a, b in pairwise(steps)), 2 * abs(steps[-1])]
        sharpest = max(range(len(bends)), key=bends.__getitem__)
        acceleration = found(answer, "acceleration", name)
        assert acceleration.value == pytest.approx(bends[sharpest] / H**2, rel=1e-9)
        assert acceleration.time == pytest.approx(sharpest * H)
        assert acceleration.passed == (acceleration.value <= LIMITS.acceleration[j])


@pytest.mark.parametrize(("share", "passes"), [(1.0, True), (1.0001, False)])
def test_full_acceleration_from_rest_to_rest_passes_and_no_more(share: float, passes: bool) -> None:
    t = np.arange(401) * H
    top = float(LIMITS.acceleration[6]) * share
    angles = np.where(t <= 0.2, top * t * t / 2, top * (0.04 - (0.4 - t) ** 2 / 2))
    answer = followed(spin(ROBOT.forward(HOME), angles))
    acceleration = found(answer, "acceleration", "joint_7")
    assert acceleration.value == pytest.approx(top, rel=1e-9)
    assert acceleration.passed is passes


def test_a_start_at_full_speed_is_an_acceleration_with_its_remedy() -> None:
    u = np.linspace(0, 1, 301)
    answer = followed(spin(ROBOT.forward(HOME), 0.3 * u * (2 - u)))  # at 2 rad/s at once, evenly down to rest
    acceleration = found(answer, "acceleration", "joint_7")
    assert acceleration.value == pytest.approx(2 * 0.3 * u[1] * (2 - u[1]) / H**2, rel=1e-9)
    assert acceleration.time == 0.0
    assert failed(answer) == [("acceleration", "joint_7")]
    assert stops_loop(answer.findings) == ()
    assert "profile trapezoid or s-curve" in acceleration.message
    stop = np.concatenate([quintic(301) * 0.3, [0.3 + 1e-4]])  # jerks on in the last period
    acceleration = found(followed(spin(ROBOT.forward(HOME), stop)), "acceleration", "joint_7")
    assert acceleration.time == pytest.approx(0.301)
    assert acceleration.value == pytest.approx(2e-4 / H**2, rel=1e-6)


def test_joint_7_past_half_a_turn_goes_on_and_is_a_position_finding() -> None:
    start = np.array([*HOME[:6], np.radians(150.0)])
    answer = followed(spin(ROBOT.forward(start), quintic(2001) * np.radians(45)), start)
    np.testing.assert_allclose(np.degrees(answer.trajectory.q[[0, -1], 6]), [150, 195], rtol=0, atol=1e-9)
    assert failed(answer) == [("position", "joint_7")]
    position = found(answer, "position", "joint_7")
    assert position.value == pytest.approx(np.radians(195.0))
    assert position.limit == LIMITS.upper[6]
    assert position.message == (
        "joint_7 position 195° at t = 2.000 s (a -> b, 100 % of the way), limit 175°; -165° would be inside, but is a"
        " whole turn away; let the arm angle move (--arm-angle free) or begin with other joints"
    )
    wide = replace(LIMITS, upper=np.array([*LIMITS.upper[:6], np.radians(195.0)]))
    far = spin(ROBOT.forward(start), quintic(2001) * np.radians(45))
    answer_wide = follow(far, Arm(ROBOT, FLANGE, start, wide))
    assert isinstance(answer_wide, Followed)
    assert failed(answer_wide) == []  # exactly on the limit
    back = np.array([*HOME[:6], np.radians(-150.0)])
    position = found(followed(spin(ROBOT.forward(back), -quintic(2001) * np.radians(45)), back), "position", "joint_7")
    assert (position.value, position.limit) == (pytest.approx(np.radians(-195.0)), LIMITS.lower[6])


def test_the_turns_of_the_start_joints_are_kept() -> None:
    wide = replace(LIMITS, lower=np.full(7, -9.0), upper=np.full(7, 9.0))
    start = HOME + 2 * np.pi * np.array([1, 0, 0, 0, -1, 0, 1])
    answer = follow(spin(ROBOT.forward(start), quintic(101) * 0.1), Arm(ROBOT, FLANGE, start, wide))
    assert isinstance(answer, Followed)
    np.testing.assert_allclose(answer.trajectory.q[-1], start + 0.1 * np.eye(7)[6], rtol=0, atol=1e-9)


def test_the_elbow_follows_from_the_pose_alone_and_the_message_says_so() -> None:
    inwards = line(ROBOT.forward(HOME), np.array([-0.25, 0, 0.0]), np.zeros(3), 2.0)
    position = found(followed(inwards), "position", "joint_4")
    assert not position.passed
    assert "the pose alone decides this joint, no arm angle helps" in position.message
    started = process_time()
    free = followed(inwards, free=True)
    assert process_time() - started < 0.5  # nothing is searched for
    np.testing.assert_array_equal(free.trajectory.q, followed(inwards).trajectory.q)


def test_the_first_pose_out_of_reach_is_named() -> None:
    X = ROBOT.forward(HOME)
    way = line(X, np.array([0.4, 0, 0]), np.zeros(3), 1.0)
    answer = follow(way, Arm(ROBOT, FLANGE, HOME, LIMITS))
    assert isinstance(answer, Unfollowable)
    d = wrist_distance(way.pose, way.rotations(X[:3, :3]))
    first = int(np.argmax(d > 0.8))
    share = 100 * quintic(1001)[first]
    assert (answer.index, answer.time) == (first, pytest.approx(first * H))
    assert answer.place == f"a -> b, {share:.0f} % of the way"
    assert answer.message == (
        f"pose at t = {first * H:.3f} s ({answer.place}) cannot be reached:"
        f" wrist centre out of reach: {d[first]:.6g} m from the shoulder, at most 0.8 m; move the path"
    )


def test_pieces_and_dwells_name_the_place() -> None:
    X = ROBOT.forward(HOME)
    angles = np.concatenate([quintic(101) * 0.05, np.full(100, 0.05), 0.05 + np.arange(1, 101) * H * 4.0])
    way = replace(
        spin(X, angles), pieces=(Piece(0, 100, "a", "b"), Piece(100, 200, "b", "b", True), Piece(200, 300, "b", "c"))
    )
    assert (
        "t = 0.250 s (b -> c, 50 % of the way)"
        in found(
            followed(
                replace(
                    way, R=X[:3, :3] @ rotation_about([0, 0, 1], np.where(np.arange(301) > 250, angles + 0.01, angles))
                )
            ),
            "speed",
            "joint_7",
        ).message
    )
    jerk = np.where(np.arange(301) == 150, angles + 0.02, angles)
    held = followed(replace(way, R=X[:3, :3] @ rotation_about([0, 0, 1], jerk)))
    assert "(standing at b)" in found(held, "speed", "joint_7").message


def test_a_first_pose_elsewhere_is_noted_with_the_pull() -> None:
    X = ROBOT.forward(HOME)
    shifted = X @ pose(rotation_about([0, 0, 1], np.radians(2.0)), [0, 0, 0.005])
    notes = followed(spin(shifted, quintic(101) * 0.01)).notes
    assert notes[0].startswith(
        "the first pose is 5 mm and 2° away from the tool at the start joints: the controller would be pulled there at"
        " once, joint_7 by 2°"
    )
    assert followed(spin(X, quintic(101) * 0.01)).notes == ()
    other = followed(spin(X, quintic(101) * 0.01), arm_angle=0.2).notes
    assert other[0].startswith("the first pose is the tool's at the start joints, but other joints reach it: joint_")


def test_singularities_and_nearness_to_limits_are_noted() -> None:
    start = np.radians([10, 40, 20, -80, 30, 0.5, 0])
    notes = followed(spin(ROBOT.forward(start), quintic(201) * 0.1), start).notes
    assert [note for note in notes if "joint_6 = 0" in note and "within 0.5° at t = " in note]
    start = np.array([*HOME[:6], np.radians(170.0)])
    notes = followed(spin(ROBOT.forward(start), quintic(1001) * np.radians(4)), start).notes
    assert notes == ("joint_7 comes within 1° of its limit 175° at t = 1.000 s (a -> b, 100 % of the way)",)


def test_relative_angles_count_from_the_tool_at_the_start() -> None:
    start = np.radians([15, 35, -10, -80, 20, 60, 40])
    X = product_forward(start[None])[0] @ TOOL
    rows = np.zeros((2, 6))
    rows[:, :3] = X[:3, 3]
    turned = rotation_about([0, 0, 1], 1e-3)
    R = np.stack([np.eye(3), turned])
    relative = sequence(rows, R, AngleMeaning.RELATIVE, H)
    absolute = sequence(rows, R @ X[:3, :3], AngleMeaning.ABSOLUTE, H)
    q = []
    for way in (relative, absolute):
        answer = follow(way, Arm(ROBOT, TOOL, start, LIMITS))
        assert isinstance(answer, Followed)
        q.append(answer.trajectory.q)
    np.testing.assert_allclose(q[0], q[1], rtol=0, atol=1e-13)
    np.testing.assert_allclose(q[0][0], start, rtol=0, atol=1e-12)


def test_a_minute_at_1_khz_is_followed_in_under_a_second() -> None:
    way = line(ROBOT.forward(HOME), np.array([0, 0.2, 0]), np.array([0.2, 0, 0.5]), 60.0)
    times = []
    for _ in range(3):
        started = process_time()
        assert failed(followed(way)) == []
        times.append(process_time() - started)
    assert len(way.pose) == 60001
    assert min(times) < 1.0
