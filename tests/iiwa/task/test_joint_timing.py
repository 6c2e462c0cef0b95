"""Segments timed by the joints: limits by plain differences, least times by the library toppra, refusals by place."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from toppra import SplineInterpolator
from toppra.algorithm import TOPPRA
from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraint

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.joint_checks import Arm, ArmOnPath, Untimed
from trajopt_cli.iiwa.task.joints import Followed, follow
from trajopt_cli.iiwa.task.model import AngleMeaning, Passing, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.segments import planned
from trajopt_cli.robot.srs import load_srs

ROBOT = load_srs("iiwa7")
LIMITS = ROBOT.profile()
FLANGE = np.eye(4)
HOME = np.radians([10.0, 35, -20, -95, 15, 55, 5])
FAST = np.array([0.6, 3.0, 8.0, 40.0, 200.0, 1000.0])


def arm(start: Array = HOME, angle: float | None = None) -> ArmOnPath:
    return ArmOnPath(Arm(ROBOT, FLANGE, start, LIMITS, given=angle), AngleMeaning.RELATIVE)


def route(steps: list[list[float]], profile: Profile, law: RotationLaw, start: Array = HOME) -> Route:
    pose = np.r_[ROBOT.forward(start)[:3, 3], np.zeros(3)]
    rows = np.cumsum([pose, *steps], axis=0)
    ways = tuple(Waypoint(f"p{i}", row, "task.yaml:7") for i, row in enumerate(rows))
    return Route(ways, np.tile(FAST, (len(steps), 1)), 1e-3, profile, law, AngleMeaning.RELATIVE)


def joints(way: Equilibrium, start: Array = HOME) -> Array:
    found = follow(way, Arm(ROBOT, FLANGE, start, LIMITS))
    assert isinstance(found, Followed)
    return found.trajectory.q


def used(q: Array, h: float) -> tuple[float, float]:
    """Greatest shares of the joints' speeds and accelerations, from rest to rest."""
    v = np.diff(q, axis=0) / h
    a = np.concatenate([2 * v[:1], np.diff(v, axis=0), -2 * v[-1:]]) / h
    return float(np.max(np.abs(v) / LIMITS.velocity)), float(np.max(np.abs(a) / LIMITS.acceleration))


STEPS = [[0.1, -0.12, 0.05, 0.3, -0.2, 0.25], [-0.15, 0.1, 0.08, -0.3, 0.1, 0.0], [0.0, 0.0, 0.0, 0.0, 0.35, 0.2]]


@pytest.mark.parametrize("law", RotationLaw)
@pytest.mark.parametrize("profile", [Profile.TRAPEZOID, Profile.S_CURVE])
def test_joints_keep_their_limits_and_lose_less_than_a_whole_slowed_down(profile: Profile, law: RotationLaw) -> None:
    asked = route(STEPS, profile, law)
    free, timed = planned(asked)[0], planned(asked, arm=arm())[0]
    v, a = used(joints(free), asked.h)
    assert a > 1.5  # the poses' caps alone ask for too much
    assert max(used(joints(timed), asked.h)) <= 1
    assert free.duration < timed.duration < 0.97 * free.duration * max(v, a**0.5)
    for i, piece in enumerate(timed.pieces):  # stops stay stops, and straight ways straight
        assert np.array_equal(timed.pose[piece.last, :3], asked.poses[i + 1, :3])
        part = timed.pose[piece.first : piece.last + 1, :3]
        way = part[-1] - part[0]
        if np.linalg.norm(way) > 0:
            assert np.abs(np.cross(part - part[0], way / np.linalg.norm(way))).max() < 1e-12


@pytest.mark.parametrize("step", STEPS[:2])
def test_a_trapezoid_takes_the_least_time_that_toppra_finds(step: list[float]) -> None:
    asked = route([step], Profile.TRAPEZOID, RotationLaw.TAIT_BRYAN)
    timed = planned(asked, arm=arm())[0]
    s = np.linspace(0, 1, 401)
    line = replace(timed, pose=asked.poses[0] + s[:, None] * np.array(step))
    line = replace(line, R=rotation(line.pose[:, 3:]), pieces=(Piece(0, len(s) - 1, "p0", "p1"),))
    lengths = np.linalg.norm(step[:3]), np.linalg.norm(step[3:])
    path = SplineInterpolator(s, np.column_stack([joints(line), *(s * one for one in lengths)]))
    speeds = np.r_[LIMITS.velocity, FAST[:2]]
    pushes = np.r_[LIMITS.acceleration, FAST[2:4]]
    of = [JointVelocityConstraint(np.c_[-speeds, speeds]), JointAccelerationConstraint(np.c_[-pushes, pushes])]
    least = TOPPRA(of, path, gridpoints=np.linspace(0, 1, 801)).compute_trajectory(0, 0).duration
    assert least <= timed.duration + asked.h
    assert timed.duration < 1.01 * least + 2 * asked.h


def test_where_the_joints_have_room_the_time_is_the_poses() -> None:
    slow = np.tile([0.05, 0.2, 0.3, 1.0, 5.0, 20.0], (3, 1))
    asked = replace(route(STEPS, Profile.S_CURVE, RotationLaw.SLERP), caps=slow)
    assert planned(asked, arm=arm())[0].duration == pytest.approx(planned(asked)[0].duration, rel=0.03)


def test_poses_that_are_passed_are_timed_too() -> None:
    asked = replace(route(STEPS[:2], Profile.S_CURVE, RotationLaw.SLERP), passing=Passing(1e-3, 0.02))
    timed = planned(asked, arm=arm())[0]
    assert len(timed.pieces) == 1
    assert max(used(joints(timed), asked.h)) <= 1


def test_a_way_through_a_singularity_a_joint_out_of_range_and_a_pose_out_of_reach_are_named() -> None:
    start = np.radians([0.0, 30, 0, -100, 0, 20, 0])
    over = route([[0, 0, 0, 0, np.radians(-40), 0]], Profile.TRAPEZOID, RotationLaw.SLERP, start)
    with pytest.raises(Untimed, match=r"p0 -> p1.*joint_[57]"):
        planned(over, arm=arm(start))
    far = route([[0.0, 0, 0, 0, 0, 0.3], [0.6, 0, 0, 0, 0, 0]], Profile.TRAPEZOID, RotationLaw.SLERP)
    with pytest.raises(Untimed, match=r"p1 -> p2.*out of reach"):
        planned(far, arm=arm())
    last = np.radians([10.0, 35, -20, -95, 15, 55, 165])
    turned = route([[0, 0, 0, 0, 0, np.radians(-30)]], Profile.TRAPEZOID, RotationLaw.SLERP, last)
    with pytest.raises(Untimed, match=r"p0 -> p1.*joint_7"):
        planned(turned, arm=arm(last))


def test_a_profile_without_accelerations_is_refused() -> None:
    with pytest.raises(InputError) as error:
        planned(route(STEPS, Profile.THESIS, RotationLaw.SLERP), arm=arm())
    assert error.value.file == "task.yaml:7"
