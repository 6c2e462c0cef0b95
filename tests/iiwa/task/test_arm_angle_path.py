"""An arm angle that moves: found where the fixed one fails, right in every row, and denied only where there is none."""

from __future__ import annotations

from time import process_time

import numpy as np
import pytest
from joint_ways import HOME, H, line, product_forward, quintic, spin

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.arm_map import ArmTask, NoPlan
from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective, Goal, plan_arm
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.joint_checks import Arm, stops_loop
from trajopt_cli.iiwa.task.joints import Followed, follow
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle, configuration, inverse_branch

ROBOT = load_srs("iiwa7")
LIMITS = ROBOT.profile()
FLANGE = np.eye(4)


def followed(
    way: Equilibrium, start: Array, free: bool, definition: ArmAngle = ArmAngle.FARIA, delta: float | None = None
) -> Followed:
    answer = follow(way, Arm(ROBOT, FLANGE, start, LIMITS, definition, delta), free)
    assert isinstance(answer, Followed)
    return answer


def broken(answer: Followed) -> set[tuple[str, str]]:
    return {(one.check, one.subject) for one in stops_loop(answer.findings)}


def assert_keeps_every_limit(answer: Followed, accelerations: bool = True) -> None:
    """By differences of the joints, not by the findings."""
    q = answer.trajectory.q
    assert (q <= LIMITS.upper).all()
    assert (q >= LIMITS.lower).all()
    assert (np.abs(q[1:] - q[:-1]) / H <= LIMITS.velocity).all()
    if accelerations:
        assert (np.abs(q[2:] - 2 * q[1:-1] + q[:-2]) / H**2 <= LIMITS.acceleration).all()
        assert (2 * np.abs(q[[1, -1]] - q[[0, -2]]) / H**2 <= LIMITS.acceleration).all()


def assert_goes_the_way(answer: Followed, way: Equilibrium, start: Array) -> None:
    q = answer.trajectory.q
    X = product_forward(q)
    np.testing.assert_allclose(X[:, :3, 3], way.pose[:, :3], rtol=0, atol=1e-12)
    np.testing.assert_allclose(X[:, :3, :3], way.rotations(X[0, :3, :3]), rtol=0, atol=1e-12)
    np.testing.assert_allclose(q[0], start, rtol=0, atol=1e-9)
    assert set(configuration(q)) == {int(configuration(start))}
    off = arm_angle(ROBOT, q, answer.definition) - answer.arm_angle
    np.testing.assert_allclose(np.angle(np.exp(1j * off)), 0, rtol=0, atol=1e-9)
    steps = np.diff(answer.arm_angle)
    assert np.abs(steps).max() < np.radians(120.0) * H  # no jump by a turn
    assert np.abs(steps[[0, -1]]).max() < 40 * H * H / 2  # from rest to rest: 40 rad/s2 for one period at most


# Ways on which the fixed arm angle takes a joint past its limit: start [deg], by [m], turn [rad], seconds, what breaks.
BUILT = {
    "turn": (np.degrees(HOME), (0, 0, 0), (0, 0, -3.3), 4.0, {("position", "joint_7")}),
    "fast turn": (np.degrees(HOME), (0, 0, 0), (0, 0, -3.3), 3.0, {("position", "joint_7")}),
    "aside and round": (np.degrees(HOME), (0.2, 0, 0), (0, 0, -3.5), 20.0, {("position", "joint_7")}),
    "joint_6": (
        (-97, 44, -90, 82, 54, 6, 40),
        (-0.16, 0, -0.25),
        (-0.55, -0.54, -1.67),
        4.0,
        {("position", "joint_6")},
    ),
    # The tool's axis passes beside the forearm's: joint_5 and joint_7 would have to turn round within an instant.
    "wrist": ((0, 40, 0, -80, 0, 10, 0), (0, 0.05, 0), (0, -0.3, 0), 2.0, {("speed", "joint_5"), ("speed", "joint_7")}),
}


@pytest.mark.long
@pytest.mark.parametrize("name", BUILT)
def test_a_course_is_found_where_the_fixed_arm_angle_fails(name: str) -> None:
    degrees, by, turn, seconds, breaks = BUILT[name]
    start = np.radians(degrees)
    way = line(ROBOT.forward(start), np.array(by), np.array(turn), seconds)
    assert broken(followed(way, start, free=False)) == breaks
    started = process_time()
    answer = followed(way, start, free=True)
    assert process_time() - started < 5.0
    assert answer.arm_angle[0] == pytest.approx(float(arm_angle(ROBOT, start, ArmAngle.FARIA)), abs=1e-12)
    assert_goes_the_way(answer, way, start)
    assert_keeps_every_limit(answer)
    least, greatest, held = (
        np.degrees([answer.arm_angle.min(), answer.arm_angle.max(), answer.arm_angle[0]]).round(2) + 0.0
    )
    fixed = followed(way, start, free=False)
    first = next(one for one in fixed.findings if not one.passed and one.check != "acceleration")
    assert answer.notes[0] == (
        f"the arm angle moves between {least:.2f}° and {greatest:.2f}°; held at {held:.2f}°: "
        + first.message[: first.message.index(";")]
    )


@pytest.mark.long
def test_it_is_the_same_every_time() -> None:
    way = line(ROBOT.forward(HOME), np.zeros(3), np.array([0, 0, -3.3]), 3.0)
    a, b = (followed(way, HOME, free=True) for _ in range(2))
    np.testing.assert_array_equal(a.trajectory.q, b.trajectory.q)


def test_a_fixed_arm_angle_that_passes_is_kept() -> None:
    way = line(ROBOT.forward(HOME), np.array([0, 0.2, 0]), np.zeros(3), 1.0)
    fixed, free = (followed(way, HOME, free=free) for free in (False, True))
    np.testing.assert_array_equal(fixed.trajectory.q, free.trajectory.q)
    assert free.notes == ("the arm angle stays at 0.00°: it keeps every position and speed limit",)


@pytest.mark.long
def test_an_arm_angle_goes_on_past_half_a_turn() -> None:
    """The elbow hangs down, so that swivel is 180 deg at the start, on the cut of every angle in (-180, 180]."""
    start = np.radians([0, 20, 0, 80, 0, -60, 150])
    way = spin(ROBOT.forward(start), quintic(6001) * np.radians(45.0))
    assert broken(followed(way, start, False, ArmAngle.SWIVEL)) == {("position", "joint_7")}
    swivel = followed(way, start, True, ArmAngle.SWIVEL)
    assert_goes_the_way(swivel, way, start)
    assert_keeps_every_limit(swivel)
    faria = followed(way, start, True, ArmAngle.FARIA)
    np.testing.assert_allclose(np.abs(swivel.arm_angle - faria.arm_angle), np.pi, rtol=0, atol=1e-9)
    np.testing.assert_allclose(swivel.trajectory.q, faria.trajectory.q, rtol=0, atol=1e-9)


def can_be_got_to(X_WF: Array, start: Array, faster: float) -> int | None:
    """The row at which a flood over a fine grid, joints up to `faster` times as fast, has nowhere to go; None: never.

    No costs, no smoothness, other grids: everything a course could do and more.
    """
    rows, m = np.arange(0, len(X_WF), 20), 360
    grid = float(arm_angle(ROBOT, start, ArmAngle.FARIA)) + 2 * np.pi / m * np.arange(m)
    q = inverse_branch(
        ROBOT, np.repeat(X_WF[rows], m, 0), np.tile(grid, len(rows)), ArmAngle.FARIA, int(configuration(start))
    )
    q = q.reshape(len(rows), m, 7)
    inside = ((q >= LIMITS.lower) & (q <= LIMITS.upper)).all(axis=2)
    wet = np.arange(m) == 0
    near = (np.arange(m) - np.arange(-12, 13)[:, None]) % m  # the cells that each may be got to from
    for i in range(1, len(rows)):
        way = (np.abs(q[i] - q[i - 1][near]) <= faster * LIMITS.velocity * 20 * H).all(axis=2)
        wet = (wet[near] & way).any(axis=0) & inside[i]
        if not wet.any():
            return int(rows[i])
    return None


# Ways the flood finds no end of: start [deg], by [m], turn [rad]; 4 s each.
BLOCKED = [
    ((-65.7, 26.1, -112.7, -78.3, -113.4, -69.1, 74.0), (-0.077, -0.004, -0.029), (-0.732, -1.136, -1.591)),
    ((-119.9, 25.9, -110.9, -88.1, 87.8, -34.8, 64.9), (0.018, 0.17, 0.084), (1.182, -0.063, 1.766)),
]


@pytest.mark.parametrize(("degrees", "by", "turn"), BLOCKED)
def test_none_is_found_only_where_a_flood_finds_none(
    degrees: tuple[float, ...], by: tuple[float, ...], turn: tuple[float, ...]
) -> None:
    start = np.radians(degrees)
    way = line(ROBOT.forward(start), np.array(by), np.array(turn), 4.0)
    fixed, free = (followed(way, start, free=free) for free in (False, True))
    row = can_be_got_to(fixed.X_WF, start, faster=3.0)
    assert row is not None
    found = plan_arm(
        ArmTask(Arm(ROBOT, FLANGE, start, LIMITS), fixed.X_WF, H),
        float(fixed.arm_angle[0]),
        ArmAngleObjective(Goal.LIMITS),
    )
    assert isinstance(found, NoPlan)
    assert found.row == pytest.approx(row, abs=50)
    assert found.message == "no arm angle that keeps every joint in its range can be reached in time"
    np.testing.assert_array_equal(free.trajectory.q, fixed.trajectory.q)
    assert broken(free) == broken(fixed) != set()
    assert free.notes[0].startswith(f"no path of the arm angle was found: at t = {found.row * H:.3f} s (a -> b, ")


def test_the_flood_runs_where_a_course_is_found() -> None:
    """So that the test above does not rest on a flood that is always stopped."""
    way = line(ROBOT.forward(HOME), np.zeros(3), np.array([0, 0, -3.3]), 4.0)
    assert can_be_got_to(followed(way, HOME, free=False).X_WF, HOME, faster=1.0) is None


def test_the_start_itself_out_of_range_is_said() -> None:
    start = np.array([*HOME[:6], np.radians(178.0)])
    way = spin(ROBOT.forward(start), quintic(501) * 0.1)
    answer = followed(way, start, free=True)
    assert answer.notes[0] == (
        "no path of the arm angle was found: at t = 0.000 s (a -> b, 0 % of the way) the arm angle of the start"
        " joints breaks a range: joint_7"
    )


@pytest.mark.long
@pytest.mark.parametrize("speed", [0.5, 1.5])
def test_a_start_at_full_speed_does_not_keep_a_course_from_being_found(speed: float) -> None:
    """Profile thesis: the accelerations fail at any arm angle, positions and speeds need not."""
    start = np.array([*HOME[:6], np.radians(150.0)])
    way = spin(ROBOT.forward(start), np.arange(round(0.8 / speed / H) + 1) * speed * H)
    assert broken(followed(way, start, free=False)) == {("position", "joint_7")}
    answer = followed(way, start, free=True)
    assert_goes_the_way(answer, way, start)
    assert_keeps_every_limit(answer, accelerations=False)
    assert {one.check for one in answer.findings if not one.passed} == {"acceleration"}


def test_a_course_begins_at_the_start_joints_arm_angle_even_if_another_was_asked_to_be_held() -> None:
    way = line(ROBOT.forward(HOME), np.zeros(3), np.array([0, 0, -3.3]), 4.0)
    held = followed(way, HOME, free=False, delta=0.1)
    assert broken(held) == {("position", "joint_7")}
    answer = followed(way, HOME, free=True, delta=0.1)
    assert answer.arm_angle[0] == pytest.approx(0.0, abs=1e-12)
    assert_goes_the_way(answer, way, HOME)


@pytest.mark.long
@pytest.mark.parametrize("goal", Goal)
@pytest.mark.parametrize("name", ["fast turn", "joint_6", "wrist"])
def test_the_chosen_course_is_no_worse_than_the_free_one(name: str, goal: Goal) -> None:
    """By the goal's own measure over the rows, integrals and distances made anew."""
    degrees, by, turn, seconds, _ = BUILT[name]
    start = np.radians(degrees)
    way = line(ROBOT.forward(start), np.array(by), np.array(turn), seconds)
    free = followed(way, start, free=True).trajectory.q
    found = follow(way, Arm(ROBOT, FLANGE, start, LIMITS), objective=ArmAngleObjective(goal))
    assert isinstance(found, Followed)
    assert_keeps_every_limit(found)

    def worth(q: Array) -> float:
        if goal is Goal.LIMITS:
            moved = [0, 1, 2, 4, 5, 6]
            return float(-np.minimum(LIMITS.upper - q, q - LIMITS.lower)[:, moved].min())
        if goal is Goal.SPEED:
            return float(np.square(np.diff(q, axis=0) / LIMITS.velocity).sum())
        return float(np.square(Dynamics(ROBOT).gravity_torque(q[::10]) / ROBOT.torque).sum())

    assert worth(found.trajectory.q) <= worth(free) * (1 + 1e-3 * np.sign(worth(free)))


def test_a_joint_4_at_its_speed_limit_keeps_no_course_from_being_sought() -> None:
    """As `timing: joints` drives it: no arm angle changes that joint's speed."""
    start = np.radians([0.0, 30, 20, -100, 10, 50, 150])
    seconds = 1.0
    for _ in range(3):
        way = line(ROBOT.forward(start), np.array([0.15, 0, 0.1]), np.array([0, 0, -0.3]), seconds)
        q = followed(way, start, free=False).trajectory.q
        seconds *= float(np.abs(np.diff(q[:, 3])).max() / H / LIMITS.velocity[3]) / 0.995
    found = follow(way, Arm(ROBOT, FLANGE, start, LIMITS), objective=ArmAngleObjective(Goal.LIMITS))
    assert isinstance(found, Followed)
    assert found.plan is not None
    assert found.plan.held == ""
    assert found.plan.best.margin > found.plan.fixed.margin
