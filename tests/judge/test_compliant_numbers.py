"""The compliant judge's numbers: each check lets pass what it grants and no more, and tells value, limit and time.

Every case is a motion whose excess over a limit is known in closed form, made with a share of what is granted there:
with 0.999 of it it has to pass, with 1.001 not, and both are told with the same place and their own numbers.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from told_cases import Cases, Told

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge.chain import Followed
from trajopt_cli.iiwa.judge.joints import check_between, check_follows, check_limits, check_posture
from trajopt_cli.iiwa.judge.path import legs
from trajopt_cli.iiwa.judge.samples import Poses
from trajopt_cli.iiwa.judge.sequence import _caps_there, check_sequence
from trajopt_cli.iiwa.judge.task_order import FramePose, JudgedArm, Order, Stop, read_arm
from trajopt_cli.iiwa.judge.tolerances import (
    ARM_ANGLE,
    ARM_CAP,
    BACKWARD,
    BETWEEN,
    CAP,
    FOLLOW,
    JOINT,
    PATH,
    RAMP,
    REST,
    ROUNDING,
    START,
)
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.motion import Source
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, inverse_branch
from trajopt_cli.trajectory import Trajectory

H = 1e-3


CASES = Cases()


# --------------------------------------------------------------------------------------------------------- the joints

NAMES = ("a", "b")
LOW, HIGH, SPEED, ACCELERATION = (np.array(x) for x in ([-2.0, -1.0], [1.0, 3.0], [0.5, 0.8], [4.0, 30.0]))
ARM = JudgedArm(None, LOW, HIGH, SPEED, ACCELERATION)  # type: ignore[arg-type]  # no mechanism is needed for limits
T = np.array([0.0, 0.1, 0.3, 0.4, 0.6, 0.7])
PRINTED = Resolution(np.array([2e-6, 1e-6]), np.array([[1e-6, 2e-5], [2e-6, 1e-5]]), np.array([[4e-6, 2e-6]]))


def two(column: Array, j: int) -> Array:
    """Rows of both joints, the other one stands at 0.25."""
    q = np.full((len(column), 2), 0.25)
    q[:, j] = column
    return q


def limits_of(q: Array, printed: Resolution | None = PRINTED, qd: Array | None = None, t: Array = T) -> list[Finding]:
    return list(check_limits(ARM, Trajectory(NAMES, t, q, qd), printed))


@CASES.with_each([True, False])
def position_above(share: float, printed: bool) -> Told:
    granted = JOINT * 4 + (1e-5 if printed else 1e-12)
    value = 3 + share * granted
    q = two(np.r_[2.9, 2.9, 2.95, value, 2.9, 2.9], 1)
    return Told(limits_of(q, PRINTED if printed else None), "joint position", "b", value, 3.0, 0.4)


@CASES.one
def a_jump(share: float) -> Told:
    column = np.r_[0, 0, 0, 0, -np.pi * share, -np.pi * share]
    return Told(limits_of(two(column, 0)), "jump", "a", np.pi * share, np.pi, 0.6)


@CASES.with_each([-1, 1])
def speed(share: float, way: int) -> Told:
    """In the gap from 0.1 s to 0.3 s; positions are off by half a printed step at both ends of the shortest gap."""
    fixed, by_time = 0.8 * (1 + JOINT) + 2 * 1e-5 / 0.1, 2e-6 / 0.2
    most = fixed / (1 - by_time)
    value = 0.8 + share * (most - 0.8)
    column = np.cumsum(np.r_[0, 0.02, 0.2 * value, 0.03, 0.02, 0.01]) * way
    return Told(limits_of(two(column, 1)), "joint speed", "b", value, 0.8, 0.1)


@CASES.with_each(["begin", "end"])
def acceleration_from_rest(share: float, side: str) -> Told:
    """Who is at x a row later than rest needed 2 x / h^2; both values of that step are off by half a printed one."""
    t = T if side == "begin" else 0.7 - T[::-1]
    step = (4 + share * (4 * JOINT + 4 * 1e-6 / 0.01)) * 0.01 / 2
    column = np.r_[0, step * np.array([1, 3, 4, 5, 5.2])]  # uneven gaps
    q = two(column if side == "begin" else column[::-1], 0)
    return Told(limits_of(q, t=t), "joint acceleration", "a", 200 * step, 4.0, 0.0 if side == "begin" else 0.7)


@CASES.one
def acceleration_between(share: float) -> Told:
    """A row aside by x has 2 x / h^2 where rows are a gap apart; the doubt: printed steps of three rows over h^2."""
    doubt = 4 * 1e-12 / H**2
    value = 30 * (1 + JOINT) + doubt - (1 - share) * (30 * JOINT + doubt)
    t = np.arange(9) * H
    column = np.r_[0, 0, 0, 0, value * H**2 / 2, 0, 0, 0, 0]
    return Told(limits_of(two(column, 1), None, t=t), "joint acceleration", "b", value, 30.0, 4 * H)


@CASES.with_each([-1, 1])
def speed_column_off(share: float, way: int) -> Told:
    """A row's speed lies between those of the steps beside it, but for half of what the largest gap lets it change."""
    steps = way * np.array([0.05, 0.1, 0.04, 0.05, 0.01])
    column = np.r_[0, np.cumsum(steps * np.diff(T))]
    qd = two(way * np.r_[0, 0.05, 0.05, 0.04, 0.04, 0], 0)
    qd[:, 1] = 0
    room = 4 * 0.2 / 2 + 2 * 1e-6 / 0.1 + 2e-6
    qd[2, 0] = way * (0.1 + share * room)
    return Told(limits_of(two(column, 0), qd=qd), "speed column", "a", share * room, room, 0.3)


@CASES.with_each([-1, 1])
def speed_by_its_column(share: float, way: int) -> Told:
    value = 0.5 + share * (0.5 * JOINT + 2e-6)
    qd = two(way * np.r_[0, 0.5, 0.5, value, 0.5, 0], 0)
    qd[:, 1] = 0
    column = way * np.r_[0, np.cumsum(np.r_[0.25, 0.5, 0.5, 0.5, 0.25] * np.diff(T))]
    return Told(limits_of(two(column, 0), qd=qd), "joint speed", "a", value, 0.5, 0.4)


@CASES.with_each([("first row", 0), ("last row", -1)])
def no_rest(share: float, end: tuple[str, int]) -> Told:
    what, row = end
    most = REST + 1e-6
    qd = np.zeros((6, 2))
    qd[row] = [REST / 3, -share * most]
    return Told(limits_of(np.full((6, 2), 0.25), qd=qd), what, "b", share * most, most, T[row])


# ---------------------------------------------------------------------------------------------------------- the posture

HOME = np.radians([0, 30, 0, -100, 0, 50, 0])


@cache
def iiwa() -> JudgedArm:
    return read_arm("iiwa7", "default")


def order_of(poses: Array, **more: object) -> Order:
    """A task with one stop per row of poses (n, 6), at which nothing dwells."""
    stops = tuple(Stop(f"P{i}", pose, 0.0, Source("task.yaml", 10 + i, 1)) for i, pose in enumerate(poses))
    start = FramePose(
        np.array([0.5, 0.1, 0.4]), Rotation.from_euler("xyz", [3.0, 0.1, -0.4]).as_quat(scalar_first=True)
    )
    order = Order(
        file="task.yaml", arm=iiwa(), X_FT=FramePose(np.zeros(3), np.array([1.0, 0, 0, 0])), start_joints=HOME,
        start=start, driven=False, h=H, profile="trapezoid", slerp=False, relative=True, stops=stops, passing=None,
        caps={}, swivel=False, arm_angle=None, arm_angle_free=False, reframed=False, unchecked=(),
    )  # fmt: skip
    return replace(order, **more)  # type: ignore[arg-type]


def posture(q: Array, told: tuple[float, float] | None = None, begins: bool = False, **more: object) -> list[Finding]:
    rows = Trajectory(iiwa().mechanism.names, np.arange(len(q)) * 0.5, q)
    return list(check_posture(order_of(np.zeros((2, 6)), **more), rows, told, begins))


@CASES.with_each([1, 3, 5])
def another_configuration(share: float, j: int) -> Told:
    start = np.where(np.arange(7) == j, np.array([0, 1, 0, -1, 0, 1, 0]), HOME)
    q = np.tile(start, (4, 1))
    sign = np.sign(start[j])
    q[2, j] = -sign * share * ROUNDING
    found = [one for one in posture(q, start_joints=start) if one.check == "configuration"]
    return Told(found, "configuration", f"joint_{j + 1}", q[2, j], 0.0, 1.0)


def at_arm_angles(angles: Array) -> Array:
    """Joints that hold the tool where it is at home, at arm angles by the closed form."""
    robot = load_srs("iiwa7")
    X = np.tile(robot.forward(HOME[None]), (len(angles), 1, 1))
    return inverse_branch(robot, X, angles, ArmAngle.FARIA, 2)


@CASES.one
def arm_angle_of_an_arm_nearly_stretched(share: float) -> Told:
    """The elbow stands 2e-8 m off the line: rounding of its place alone leaves the angle open."""
    se, ew, bend = 0.4, 0.4, 1e-7
    off_line = se * ew * math.sin(bend) / (se + ew)
    turned = 10 * ROUNDING / off_line + share * ARM_ANGLE
    start = np.array([0, 0.5, 0, -bend, 0, 1, 0])
    q = np.tile(start, (3, 1))
    q[1, 2] = turned
    return Told(posture(q, start_joints=start), "arm angle", "elbow", share * ARM_ANGLE, ARM_ANGLE, 0.5)


@CASES.one
def other_joints_at_the_start(share: float) -> Told:
    q = np.tile(HOME, (3, 1))
    q[0, 4], q[0, 6], q[1] = -share * START, START / 2, HOME + 1e-3
    return Told(posture(q, begins=True), "start joints", "joint_5", share * START, START, 0.0)


def test_what_fixes_the_arm_angle_and_the_start() -> None:
    """A told range in which the arm angle hardly moves fixes it; the task's own angle leaves the start open; an angle
    that is free and of which nothing is told is not looked at."""
    q = at_arm_angles(np.array([0.0, 3 * ARM_ANGLE, 0.0]))
    q[0, 6] += 2 * START

    def checks(*told: float, begins: bool = True, **more: object) -> set[str]:
        found = posture(q, told or None, begins, **more)
        assert {"arm angle", "arm angle range"} - {one.check for one in found}
        return {one.check for one in found if not one.passed}

    assert checks() == {"arm angle", "start joints"}
    assert checks(begins=False) == checks(arm_angle=0.0) == {"arm angle"}
    assert checks(0.0, 0.99 * ARM_ANGLE, begins=False) == {"arm angle"}
    assert checks(0.0, 1.01 * ARM_ANGLE, begins=False) == {"arm angle range"}
    assert checks(0.0, 2.01 * ARM_ANGLE) == checks(arm_angle_free=True) == {"start joints"}
    assert checks(0.0, 0.0, arm_angle_free=True, begins=False) == {"arm angle range"}
    free = posture(q, arm_angle_free=True)
    assert {one.check for one in free} == {"configuration"}


# ------------------------------------------------------------------------------------------------- tools against poses


def still(n: int, off_p: float = 0.0, off_q: float = 0.0) -> Poses:
    """Rows at one pose, each more uncertain than the one before."""
    more = np.arange(1, n + 1)
    q = np.tile(Rotation.from_euler("xyz", [0.3, -0.2, 1.0]).as_quat(scalar_first=True), (n, 1))
    return Poses(np.arange(n) * H, np.tile([0.5, 0.1, 0.4], (n, 1)), q, off_p * more, off_q * more, H)


def moved(rows: Poses, row: int, step: Array, turn: Array | None = None) -> Poses:
    """One row by a step, and by a turn vector about the world's axes."""
    p, q = rows.p.copy(), rows.q.copy()
    p[row] += step
    if turn is not None:
        both = Rotation.from_rotvec(turn) * Rotation.from_quat(q[row], scalar_first=True)
        q[row] = both.as_quat(scalar_first=True)
    return replace(rows, p=p, q=q)


ASIDE = np.array([0.36, -0.48, 0.8])


@CASES.with_each(["tool position", "tool orientation"])
def tool_beside_its_pose(share: float, check: str) -> Told:
    """The worst row is the one most beyond its own doubt, not the one farthest off."""
    wanted = still(5, 1e-9, 3e-9)
    doubt = 1e-9 if check == "tool position" else 3e-9
    here, there = share * (FOLLOW + 3 * doubt) * ASIDE, 0.9 * 5 * doubt * ASIDE
    tool = wanted
    for row, off in ((2, here), (4, there)):
        tool = moved(tool, row, off, 0 * off) if check == "tool position" else moved(tool, row, 0 * off, off)
    return Told(
        check_follows(tool, wanted), check, "TCP", share * (FOLLOW + 3 * doubt), FOLLOW + 3 * doubt, 2 * H
    )  # fmt: skip


@CASES.with_each(["position between rows", "orientation between rows"])
def tool_off_between_rows(share: float, check: str) -> Told:
    rows, off = moved(still(4), 2, 0.1 * ASIDE, 0.2 * ASIDE), share * BETWEEN * ASIDE
    middle = replace(still(3), t=rows.t[:-1] + H / 2)
    for row in (1, 2):
        middle = moved(middle, row, 0.05 * ASIDE, 0.1 * ASIDE)
    other = np.array([0.8, 0.6, 0]) * share * BETWEEN
    middle = moved(middle, 1, off if "position" in check else 0 * off, other if "orientation" in check else None)
    return Told(check_between(middle, rows), check, "TCP", share * BETWEEN, BETWEEN, 1.5 * H)


# ------------------------------------------------------------------------------------------------------- the sequence

PERIOD = 0.01
OFF_P, OFF_Q = 3e-12, 2e-12
KINDS = ("way", "angles", "slerp")
BEGIN = np.array([0.0, 0.1, 0.2, 0.0, 0.0, 0.1])


def rows_of(order: Order, pose: Array, t: Array | None = None) -> Poses:
    """Rows (n, 6) as a sequence, one a period where t says nothing else; the digits of the last leave most open."""
    assert order.start is not None
    zero = Rotation.from_quat(order.start.q, scalar_first=True)
    q = (Rotation.from_euler("xyz", pose[:, 3:]) * zero).as_quat(scalar_first=True)
    n = len(pose)
    t = np.arange(n) * PERIOD if t is None else t
    share = np.linspace(0.5, 1, n)
    return Poses(t, pose[:, :3], q, OFF_P * share, OFF_Q * share, PERIOD)


def stepped(kind: str, steps: Array, t: Array | None = None, **more: object) -> tuple[Order, Poses]:
    """A way in x, or a turn about z, in these steps; the task's ends are its own."""
    way = np.zeros((len(steps) + 1, 6)) + BEGIN
    way[1:, 0 if kind == "way" else 5] += np.cumsum(steps)
    order = order_of(way[[0, -1]], h=PERIOD, slerp=kind == "slerp", **more)
    return order, rows_of(order, way, t)


def rough(kind: str) -> float:
    return OFF_P if kind == "way" else OFF_Q + ROUNDING


def cap_of(kind: str, power: int) -> str:
    return (("v_max", "a_max", "jerk") if kind == "way" else ("omega_max", "epsilon_max", "angular_jerk"))[power]


@CASES.with_each([(kind, exact) for kind in KINDS for exact in (True, False)])
def faster_than_its_cap(share: float, which: tuple[str, bool]) -> Told:
    kind, exact = which
    granted = 0.2 * (CAP if exact else ARM_CAP) + 2 * rough(kind) / PERIOD
    value, key = 0.2 + share * granted, cap_of(kind, 0)
    steps = np.array([0.3, 0.5, 0.9, 1.0, 0.8, 0.4]) * value * PERIOD
    order, rows = stepped(kind, steps, profile="thesis", caps={key: [0.2]})
    return Told(check_sequence(order, rows, exact=exact), key, "P0 -> P1", value, 0.2, 3 * PERIOD)


@CASES.with_each([(kind, place) for kind in KINDS for place in (1, 3, 4)])
def faster_than_its_cap_beside_the_grid(share: float, which: tuple[str, int]) -> Told:
    """No row stands at the poses: the rows beside them are of other ways as much."""
    kind, place = which
    t = np.r_[0, 0.007, 0.016, 0.022, 0.03, 0.038, 0.047]
    value, key = 0.2 + share * (0.2 * ARM_CAP + 2 * rough(kind) / 0.006), cap_of(kind, 0)
    steps = np.array([5, 0.5, 0.9, 0.6, 0.8, 5])
    steps[place] = 1.0
    steps *= value * np.diff(t)
    order, rows = stepped(kind, steps, t, caps={key: [0.2]})
    rows = replace(rows, off_p=np.r_[1, rows.off_p[1:-2], OFF_P, 1], off_q=np.r_[1, rows.off_q[1:-2], OFF_Q, 1])
    return Told(check_sequence(order, rows, exact=False), key, "P0 -> P1", value, 0.2, t[place])


@CASES.with_each([(kind, place) for kind in KINDS for place in ("begin", "between", "end")])
def more_acceleration_than_its_cap(share: float, which: tuple[str, str]) -> Told:
    """Who is at x a row after standing needed 2 x / h^2; the same where it comes to rest."""
    kind, place = which
    value, key = 2 + share * (2 * RAMP + 4 * rough(kind) / PERIOD**2), cap_of(kind, 1)
    steps = {"begin": [0.5, 1, 1.4, 1.2, 0.8, 0.4], "between": [0.4, 0.8, 1.8, 1.2, 0.8, 0.4]}
    steps["end"] = steps["begin"][::-1]
    time = {"begin": 0, "between": 2, "end": 6}[place] * PERIOD
    order, rows = stepped(kind, np.array(steps[place]) * value * PERIOD**2, caps={key: [2.0]})
    return Told(check_sequence(order, rows), key, "P0 -> P1", value, 2.0, time)


@CASES.with_each(KINDS)
def more_jerk_than_its_cap(share: float, kind: str) -> Told:
    """From standing to standing: third differences sum to none, and so do their sums."""
    value, key = 40 + share * (40 * RAMP + 8 * rough(kind) / PERIOD**3), cap_of(kind, 2)
    third = np.array([0.5, 1, -0.2, -0.9, -0.7, -0.3, 0, 0, 0])
    rest = np.arange(9) >= 5
    sums = np.array([np.ones(9), np.arange(9)])
    third[rest] += np.linalg.lstsq(sums[:, rest], -sums @ third)[0]
    steps = np.cumsum(np.cumsum(third))[:-2] * value * PERIOD**3
    order, rows = stepped(kind, steps, profile="s-curve", caps={key: [40.0]})
    return Told(check_sequence(order, rows), key, "P0 -> P1", value, 40.0, PERIOD)


def evenly(n: int = 9, turn: float = 0.2, **more: object) -> tuple[Order, Array]:
    """A way that moves and turns evenly, n rows."""
    end = BEGIN + np.array([0.03, 0.04, 0, 0, 0, turn])
    order = order_of(np.array([BEGIN, end]), h=PERIOD, profile="thesis", **more)
    return order, BEGIN + np.linspace(0, 1, n)[:, None] * (end - BEGIN)


def doubts(row: int, n: int = 9) -> tuple[float, float]:
    share = 0.5 + 0.5 * row / (n - 1)
    return OFF_P * share, OFF_Q * share


@CASES.with_each([False, True])
def off_the_way(share: float, slerp: bool) -> Told:
    order, pose = evenly(slerp=slerp)
    value = share * (PATH + doubts(3)[0])
    pose[3, :3] += value * np.array([-0.8, 0.6, 0])
    pose[6, 2] += 0.9 * PATH
    return Told(check_sequence(order, rows_of(order, pose)), "path", "P0 -> P1", value, PATH + doubts(3)[0], 3 * PERIOD)


@CASES.with_each([1, 4, 7])
def off_the_way_beside_the_grid(share: float, row: int) -> Told:
    """Of rows beside the grid the first and the last are not on the way, those next to them are."""
    order, pose = evenly()
    value = share * (PATH + doubts(row)[0])
    pose[row, :3] += value * np.array([-0.8, 0.6, 0])
    pose[[0, 8], 2] += 1e-3
    t = np.r_[0, 0.007, 0.016, 0.022, 0.03, 0.038, 0.047, 0.06, 0.067]
    found = check_sequence(order, rows_of(order, pose, t), exact=False)
    return Told(found, "path", "P0 -> P1", value, PATH + doubts(row)[0], t[row])


@CASES.with_each([False, True])
def turned_off_the_way(share: float, slerp: bool) -> Told:
    order, pose = evenly(slerp=slerp)
    limit = PATH + doubts(3)[1]
    pose[3, 3] += share * limit
    pose[6, 3] += 0.9 * PATH
    found = check_sequence(order, rows_of(order, pose))
    return Told(found, "orientation", "P0 -> P1", share * limit, limit, 3 * PERIOD)


@CASES.with_each([0.02, 0.2])
def back_on_the_way(share: float, turn: float) -> Told:
    """Against the farthest point reached so far, by the longer of way [m] and turn [rad]."""
    order, pose = evenly(turn=turn)
    limit = BACKWARD + 2 * sum(doubts(8))
    back = share * limit / max(0.05, turn)
    for row, at in ((4, 0.625), (5, 0.625 - 0.6 * back), (6, 0.625 - back)):
        pose[row] = BEGIN + at * (pose[8] - BEGIN)
    found = check_sequence(order, rows_of(order, pose))
    return Told(found, "backward", "P0 -> P1", share * limit, limit, 6 * PERIOD)


@CASES.with_each([True, False])
def short_of_a_pose(share: float, gridded: bool) -> Told:
    """Beside the grid a pose may lie as far from the nearest row as the next row is, way and turn together."""
    order, pose = evenly()
    rows = rows_of(order, pose, None if gridded else np.r_[0, 0.007, 0.016, 0.022, 0.03, 0.038, 0.047, 0.06, 0.067])
    limit = PATH + sum(doubts(8)) + (0 if gridded else (0.05 + 0.2) / 8)
    if gridded:
        rows = moved(rows, 8, share * limit * np.array([0.0, 0, -1]))
    else:
        assert order.stops is not None
        aside = order.stops[1].pose + np.array([0, 0, share * limit, 0, 0, 0])
        order = replace(order, stops=(order.stops[0], replace(order.stops[1], pose=aside)))
    time = 8 * PERIOD if gridded else 0.067
    return Told(check_sequence(order, rows, exact=gridded), "pose reached", "P1", share * limit, limit, time)


TOLERANCES = (1e-3, 2e-3)


def there_and_back(short: float, step: float, **more: object) -> tuple[Order, Poses]:
    """Poses that are passed: along x and back, turned round so far short of the one where the way ends."""
    poses = BEGIN + np.outer([0, 1, 2, 1, 0], [0.02, 0, 0, 0, 0, 0])
    order = order_of(poses, h=PERIOD, profile="thesis", passing=TOLERANCES, **more)
    n = round((0.04 - short) / step)
    x = 0.04 - short - step * np.arange(n + 1)[::-1]
    x = np.r_[0, x, x[-2::-1], 0]
    return order, rows_of(order, BEGIN + np.outer(x, [1, 0, 0, 0, 0, 0]))


@CASES.with_each([4e-4, 1e-3])
def passing_a_pose_too_far(share: float, step: float) -> Told:
    """An eighth of the greatest change of step is what straight ways between rows may cut off a curve."""
    limit = TOLERANCES[0] + 2 * step / 8
    order, rows = there_and_back(share * limit, step)
    row = len(rows.t) // 2 - 1
    found = [one for one in check_sequence(order, rows, exact=False) if one.subject == "P0 -> P4"]
    return Told(found, "poses passed", "P0 -> P4", share * limit, limit, row * PERIOD)


@CASES.with_each([0, 1, 2, 3])
def faster_than_the_caps_of_the_ways_it_may_be_on(share: float, leg: int) -> Told:
    """A step that may be on two ways has the higher cap of both; of one that is farther away, none."""
    caps = [0.2] * 4
    caps[leg] = 0.15
    order, rows = there_and_back(0.0, 4e-4, caps={"v_max": caps})
    value = 0.15 + share * (0.15 * RAMP + 2 * OFF_P / PERIOD)
    k, p = (25, 75, 127, 178)[leg], rows.p.copy()
    p[k + 1, 0] = p[k, 0] + math.copysign(value * PERIOD, p[k + 1, 0] - p[k, 0])
    found = check_sequence(order, replace(rows, p=p), exact=True)
    return Told(found, "v_max", "P0 -> P4", value, 0.15, k * PERIOD)


def test_a_way_of_few_rows_is_judged_as_far_as_it_has_any() -> None:
    """Steps are held against caps where there are three of them; rows beside the grid need one between two others."""
    for n, judged in ((2, False), (3, False), (4, True), (5, True)):
        order, pose = evenly(n, caps={"v_max": [0.2]})
        fast = {one.check: one.passed for one in check_sequence(order, rows_of(order, pose))}
        assert fast.get("v_max", True) != judged
        assert {"path", "orientation", "backward"} <= fast.keys()
        beside = {one.check for one in check_sequence(order, rows_of(order, pose, np.arange(n) * 0.7 * PERIOD), False)}
        assert ("path" in beside) == ("backward" in beside) == (n > 2)
        assert "v_max" not in beside


def test_the_caps_of_differences_of_rows() -> None:
    """The greatest of the legs that any of the rows of a difference may be on."""
    rng = np.random.default_rng(6)
    one = legs(order_of(BEGIN + np.outer([0, 1], np.ones(6))))[0]
    for n in (2, 5, 30):
        caps = rng.permutation(12) / 10 + 0.1
        way = [replace(one, caps={"v_max": cap}) for cap in caps]
        leg = np.sort(rng.integers(0, 12, n))
        on = Followed(0, n - 1, leg, np.minimum(leg + rng.integers(0, 4, n), 11), caps, caps, None)
        for count in {n - 1, max(n - 2, 1)}:
            wanted = [
                max(max(caps[on.leg[row] : on.ahead[row] + 1]) for row in range(i, i + n - count + 1) if row < n)
                for i in range(count)
            ]
            np.testing.assert_array_equal(_caps_there(way, on, "v_max", count), wanted)
        np.testing.assert_array_equal(_caps_there(way, None, "v_max", 3), np.full(3, caps[0]))
        np.testing.assert_array_equal(_caps_there(way[:1] * 12, on, "v_max", n - 1), np.full(n - 1, caps[0]))


def test_rows_at_a_stop_are_counted() -> None:
    """A dwell of 5 periods is stood for 5 to 7; beside the grid two gaps less or more. A way retimed by another law may
    stand longer, never shorter. Repeated poses have the dwells of all."""
    order, pose = evenly()
    assert order.stops is not None
    stand = replace(order.stops[1], dwell=4.6 * PERIOD)

    def of(order: Order, n: int, gap: float = 1.0, **more: bool) -> dict[str, Finding]:
        rows = np.concatenate([pose, np.tile(pose[-1], (n, 1))])
        found = check_sequence(order, rows_of(order, rows, np.arange(9 + n) * PERIOD * gap), exact=False, **more)
        return {one.check: one for one in found if one.subject == order.stops[-1].name}  # type: ignore[index]

    once = replace(order, stops=(order.stops[0], stand))
    twice = replace(order, stops=(order.stops[0], replace(stand, dwell=1.5 * PERIOD), replace(stand, dwell=3 * PERIOD)))
    for task in (once, twice):
        for n in (4, 5, 7, 8):
            found = of(task, n)
            assert found["dwell"].passed == (n >= 5)
            assert found["standing"].passed == (n <= 7)
            for check, limit in (("dwell", 5), ("standing", 7.5)):
                assert found[check].value == pytest.approx(n * PERIOD)
                assert found[check].limit == pytest.approx(limit * PERIOD)
                assert found[check].time == pytest.approx(8 * PERIOD)
    for n, gap, passed in (
        (2, 0.9, (False, True)),
        (3, 0.9, (True, True)),
        (8, 1.1, (True, True)),
        (9, 1.1, (True, False)),
    ):
        found = of(once, n, gap)
        assert (found["dwell"].passed, found["standing"].passed) == passed
    found = of(once, 20, retimed=True)
    assert found["dwell"].passed
    assert "standing" not in found
    assert not of(once, 4, retimed=True)["dwell"].passed
    assert of(once, 5)["rows behind the end"].value == 0


def test_what_is_missing_and_what_is_too_much_is_counted() -> None:
    """Poses that are not reached, from the first one that is not; and rows behind the last one."""
    poses = BEGIN + np.outer([0, 1, 2, 3, 4], [0.01, 0, 0, 0, 0, 0])
    order = order_of(poses, h=PERIOD, profile="thesis")
    for last in range(5):
        rows = rows_of(order, np.concatenate([poses[: last + 1], poses[last : last + 1] + 1e-3]))
        found = {one.check: one for one in check_sequence(order, rows)}
        assert found["poses missing"].value == 4 - last
        assert found["poses missing"].passed == (last == 4)
        assert ("rows behind the end" in found) == ("last pose" in found) == (last == 4)
    assert found["rows behind the end"].value == 1
    assert not found["rows behind the end"].passed


@pytest.mark.parametrize("name", CASES)
def test_what_is_granted_passes_and_no_more(name: str) -> None:
    CASES.check(name)
