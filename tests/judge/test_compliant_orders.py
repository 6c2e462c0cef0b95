"""What a task orders, as the judge reads it: every key in every unit, what is refused, and where its poses lie."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from iiwa_folders import CONTROLLER, HOME
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, pose
from trajopt_cli.iiwa.judge.path import legs
from trajopt_cli.iiwa.judge.task_order import FramePose, Order, lines_of, read_order, read_poses
from trajopt_cli.iiwa.judge.tolerances import EXACT, ROUNDING, START
from trajopt_cli.iiwa.judge.written import METRE, RADIAN, rate
from trajopt_cli.robot.srs import load_srs

FULL = """robot: iiwa7
limits: default
base: {position: "[400, -200, 100] mm", rpy: "[10, -20, 30] deg"}
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
tool: {position: [0.01, 0.02, 5 cm], wxyz: [0, 3, 0, 4]}
v_max: 200 mm/s
omega_max: [30 deg/s, 0.5]
a_max: 2 m/s2
epsilon_max: 90 °/s²
jerk: 4 m/s^3
angular_jerk: [100, 2e2 rad/s³]
h: 2 ms
profile: s-curve
rotation: slerp
angles: absolute
arm_angle: {value: 20 deg, definition: swivel}
poses:
  - {name: first, at: [0.5, 10 cm, 300 mm, 0, 0, 90 deg], dwell: 20 ms}
  - {by: [0.1, 0, 0, 0.1, 0.2, -0.3]}
  - {name: home, at: start, dwell: 0.5}
"""
RPY = Rotation.from_euler("xyz", [10, -20, 30], degrees=True)


def order_of(tmp_path: Path, text: str) -> Order:
    path = tmp_path / "task.yaml"
    path.write_text(text + CONTROLLER)
    return read_order(str(path))


def same_turn(q: Array, wanted: Rotation) -> bool:
    return bool((Rotation.from_quat(q, scalar_first=True) * wanted.inv()).magnitude() < 1e-14)


def test_every_key_of_a_task(tmp_path: Path) -> None:
    order = order_of(tmp_path, FULL)
    assert (order.h, order.profile, order.slerp, order.relative) == (2e-3, "s-curve", True, False)
    assert (order.swivel, order.arm_angle_free, order.reframed, order.driven) == (True, False, False, False)
    assert order.arm_angle == pytest.approx(math.radians(20), rel=1e-15)
    assert (order.passing, order.unchecked) == (None, ())
    caps = {
        "v_max": [0.2, 0.2], "omega_max": [math.pi / 6, 0.5], "a_max": [2, 2], "epsilon_max": [math.pi / 2] * 2,
        "jerk": [4, 4], "angular_jerk": [100, 200],
    }  # fmt: skip
    assert order.caps.keys() == caps.keys()
    for key, values in caps.items():
        assert order.caps[key] == pytest.approx(values, rel=1e-15), key
    assert order.X_FT is not None
    np.testing.assert_allclose(order.X_FT.p, [0.01, 0.02, 0.05], rtol=1e-15)
    np.testing.assert_allclose(order.X_FT.q, [0, 0.6, 0, 0.8], rtol=0, atol=1e-15)
    # the start by the closed form of the arm
    home = np.radians([0, 30, 0, -100, 0, 50, 0])
    robot = load_srs("iiwa7", pose(RPY.as_matrix(), [0.4, -0.2, 0.1]))
    X_FT = pose(Rotation.from_quat([0, 0.6, 0, 0.8], scalar_first=True).as_matrix(), [0.01, 0.02, 0.05])
    X_WT = robot.forward(home) @ X_FT
    np.testing.assert_allclose(order.start_joints, home, rtol=1e-15)
    assert order.start is not None
    np.testing.assert_allclose(order.start.p, X_WT[:3, 3], rtol=0, atol=1e-14)
    assert same_turn(order.start.q, Rotation.from_matrix(X_WT[:3, :3]))
    assert order.stops is not None
    assert [(one.name, one.dwell, one.rests) for one in order.stops] == [
        ("first", 0.02, False), ("2", 0.0, False), ("home", 0.5, False),
    ]  # fmt: skip
    assert [str(one.place) for one in order.stops] == [f"{tmp_path}/task.yaml:{line}:1" for line in (18, 19, 20)]
    first = [0.5, 0.1, 0.3, 0, 0, math.pi / 2]
    wanted = [first, np.add(first, [0.1, 0, 0, 0.1, 0.2, -0.3])]
    np.testing.assert_allclose([one.pose for one in order.stops[:2]], wanted, rtol=0, atol=1e-15)
    np.testing.assert_array_equal(order.stops[2].pose[:3], order.start.p)
    assert same_turn(order.start.q, Rotation.from_euler("xyz", order.stops[2].pose[3:]))


def test_what_a_task_need_not_say(tmp_path: Path) -> None:
    order = order_of(tmp_path, f"{HOME}poses:\n  - start\n  - {{by: [0.1, 0, 0, 0, 0, 0]}}\n")
    assert (order.h, order.profile, order.slerp, order.relative) == (1e-3, "thesis", False, True)
    assert (order.swivel, order.arm_angle, order.arm_angle_free, order.passing) == (False, None, False, None)
    assert set(order.caps.values()) == {None}
    assert order.X_FT is not None
    assert order.start is not None
    assert order.stops is not None
    np.testing.assert_array_equal([order.X_FT.p, order.X_FT.q[1:], order.stops[0].pose[3:]], np.zeros((3, 3)))
    np.testing.assert_allclose(order.start.p, load_srs("iiwa7").forward(order.start_joints)[:3, 3], atol=1e-14)
    swivel = order_of(tmp_path, f"{HOME}arm_angle: {{definition: faria}}\nposes: [start, start]\n")
    assert (swivel.swivel, swivel.arm_angle) == (False, None)
    assert order_of(tmp_path, f"{HOME}arm_angle: free\nposes: [start, start]\n").arm_angle_free
    passing = order_of(tmp_path, f"{HOME}passing: {{}}\nposes: [start, start]\n")
    assert (passing.profile, passing.passing) == ("s-curve", (1e-4, pytest.approx(math.radians(0.5), rel=1e-15)))
    assert order_of(tmp_path, f"{HOME}passing: stop\nposes: [start, start]\n").passing is None


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ("omega_max: [30 deg/s, 0.5]", "omega_max: [1, 2, 3]", "9: omega_max: 3 values for 2 segments"),
        ("omega_max: [30 deg/s, 0.5]", "omega_max: [1, -2]", "9: omega_max: is -2; a cap is 0 or more"),
        ("a_max: 2 m/s2", "a_max: 1.0e9", "10: a_max: needs a number, or a text with one of m/s2, m/s^2, m/s²"),
        ("v_max: 200 mm/s", "v_max: 200 mm/s2", "8: v_max: needs a number, or a text with one of m/s, cm/s, mm/s,"),
        ("jerk: 4 m/s^3", "jerk: true", "12: jerk: needs a number"),
        ("wxyz: [0, 3, 0, 4]", "wxyz: [0, 3, 4]", "7: tool.wxyz: needs a list of 4 numbers"),
        ("wxyz: [0, 3, 0, 4]", "wxyz: [0, 0, 0, 0]", "7: tool.wxyz: is zero"),
        ("wxyz: [0, 3, 0, 4]", "wxyz: here", "7: tool.wxyz: needs a list of 4 numbers"),
        ("wxyz: [0, 3, 0, 4]", "wxyz: [0, 3, 0, 4 deg]", "7: tool.wxyz: needs a number, not '4 deg'"),
        ("by: [0.1, 0, 0, 0.1, 0.2, -0.3]", "by: [0.1, 0, 0]", "21: poses.1: needs 6 values, not [0.1, 0, 0]"),
        ("by: [0.1, 0, 0, 0.1, 0.2, -0.3]", "by: there", "21: poses.1: needs 6 values, not 'there'"),
        ("by: [0.1, 0, 0, 0.1, 0.2, -0.3]", "by: [0, 0, 0, 1 mm, 0, 0]", "21: poses.1: needs a number, or a text with"),
        ("by: [0.1, 0, 0, 0.1, 0.2, -0.3]", "by: [0, 0, 1 deg, 0, 0, 0]", "21: poses.1: needs a number, or a text"),
        ("at: [0.5, 10 cm", "by: [0.5, 10 cm", "20: poses.0: 'by' adds to the pose before, and there is none"),
        ("at: start, dwell: 0.5}", "at: start, by: start}", "22: poses.2: needs one of 'at' and 'by'"),
        ("poses:", "changes: 3\nposes:", "19: changes: needs a list, not 3"),
        ("poses:", "passing: 3\nposes:", "19: passing: needs 'stop' or a section, not 3"),
        ("h: 2 ms", "h: -0.001", "14: h: needs a period above zero, not -0.001"),
    ],
)  # fmt: skip
def test_what_is_refused_and_where(before: str, after: str, message: str, tmp_path: Path) -> None:
    text = CONTROLLER[: CONTROLLER.index("\n") + 1] + "D: [1, 1, 1, 1, 1, 1]\n" + FULL.replace(before, after)
    (tmp_path / "task.yaml").write_text(text)
    with pytest.raises(InputError) as caught:
        read_order(str(tmp_path / "task.yaml"))
    assert str(caught.value).startswith(f"{tmp_path}/task.yaml:{message}")


@pytest.mark.parametrize(
    ("poses", "message"), [("{a: 1}", "needs a list of poses"), ("[start]", "1 given; a path needs")]
)
def test_a_path_needs_two_poses(poses: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=rf"task\.yaml:2: poses: {message}"):
        order_of(tmp_path, f"{HOME}poses: {poses}\n")


def test_units_of_rates() -> None:
    assert rate(METRE, 1) == {"m/s": 1.0, "cm/s": 0.01, "mm/s": 1e-3}
    assert rate(RADIAN, 2).keys() == {f"{unit}/s{end}" for unit in ("rad", "deg", "°") for end in ("2", "^2", "²")}
    assert rate(METRE, 3).keys() == {f"{unit}/s{end}" for unit in ("m", "cm", "mm") for end in ("3", "^3", "³")}


@pytest.mark.parametrize(("off", "near"), [(0.999 * START, True), (1.001 * START, False)])
@pytest.mark.parametrize("turned", [False, True])
def test_how_far_the_first_pose_is_from_the_start_before_there_is_a_way(
    turned: bool, off: float, near: bool, tmp_path: Path
) -> None:
    start = order_of(tmp_path, HOME + "poses: [start, start]\n").start
    assert start is not None
    at = np.r_[start.p, 0, 0, 0] + off * np.eye(6)[3 if turned else 1]
    for how in ("line", "joint", "none"):
        poses = f"  - {at.tolist()}\n  - {{by: [0.1, 0, 0, 0, 0, 0]}}\n"
        order = order_of(tmp_path, f"{HOME}approach: {how}\nposes:\n{poses}")
        assert order.stops is not None
        assert len(order.stops) == (2 if near or how != "line" else 3)
        assert order.driven == (how == "joint" and not near)


def test_where_rows_begin_decides_what_a_task_leaves_open(tmp_path: Path) -> None:
    """A way from the start is taken where the rows begin there."""
    path = tmp_path / "task.yaml"
    path.write_text(f"{HOME}poses:\n  - [0.5, 0, 0.3, 0, 0, 0]\n  - {{by: [0.1, 0, 0, 0, 0, 0]}}\n{CONTROLLER}")
    start = read_order(str(path)).start
    assert start is not None
    for off, count in ((0.999 * START, 3), (1.001 * START, 2)):
        order = read_order(str(path), first=lambda *_, off=off: FramePose(start.p + np.array([0, off, 0]), start.q))
        assert order.stops is not None
        assert len(order.stops) == count
    order = read_order(str(path))
    assert order.stops is not None
    assert len(order.stops) == 2


@pytest.mark.parametrize(
    ("keys", "reframed"),
    [("{K: [1]}", False), ("{at: 1, tool: {}}", True), ("{base: {}}", True), ("{K: [1]}, {restart: 1}", True)],
)  # fmt: skip
def test_changes_that_give_other_frames(keys: str, reframed: bool, tmp_path: Path) -> None:
    assert order_of(tmp_path, f"{HOME}changes: [{keys}]\nposes: [start, start]\n").reframed == reframed


# -------------------------------------------------------------------------------------------------------------- the way


def turns_of(tmp_path: Path, *angles: float, rotation: str = "tait-bryan") -> list[float]:
    """What the legs turn about z, of poses at these angles [rad]."""
    poses = "".join(f"  - [{0.1 * i}, 0, 0, 0, 0, {angle!r}]\n" for i, angle in enumerate(angles))
    order = order_of(tmp_path, f"{HOME}angles: absolute\napproach: none\nrotation: {rotation}\nposes:\n{poses}")
    return [float(leg.turn[2]) for leg in legs(order)]


def test_angles_turn_the_shorter_way_round(tmp_path: Path) -> None:
    """By half a turn as it is written; by more, the other way; and on from where they are."""
    pi = math.pi
    assert turns_of(tmp_path, 0.0, 3.0, -3.0, 3.0) == pytest.approx([3, 2 * pi - 6, 6 - 2 * pi], abs=1e-14)
    assert turns_of(tmp_path, 0.0, pi, 0.0, -pi, pi) == pytest.approx([pi, -pi, -pi, 0], abs=1e-14)
    assert turns_of(tmp_path, 1.0, 1.0 - pi, 1.0) == pytest.approx([-pi, pi], abs=1e-14)
    for off, turn in ((0.5 * EXACT, pi), (3 * EXACT, -pi)):
        assert turns_of(tmp_path, 0.0, pi + off) == pytest.approx([turn], abs=1e-11)
    assert turns_of(tmp_path, 0.0, 3.0, -3.0, rotation="slerp") == pytest.approx([3, 2 * pi - 6], abs=1e-13)


def test_ways_and_turns_of_rounding_are_none(tmp_path: Path) -> None:
    for off, moves in ((0.9 * EXACT, False), (1.1 * EXACT, True)):
        poses = f"  - [0, 0, 0, 0, 0, 0]\n  - [{off}, 0, 0, 0, 0, 0.1]\n  - [0.1, 0, 0, 0, 0, {0.1 + off!r}]\n"
        first, second = legs(order_of(tmp_path, f"{HOME}approach: none\nposes:\n{poses}"))
        assert (first.L_p > 0) == (second.L_q > 0) == moves
        assert (first.L_q, second.L_p) == pytest.approx((0.1, 0.1))
        assert (first.name, second.name) == ("1 -> 2", "2 -> 3")


@pytest.mark.parametrize("rotation", ["tait-bryan", "slerp"])
def test_a_leg_is_known_by_its_shares(rotation: str, tmp_path: Path) -> None:
    """Any rotation on it and beside it: shares, turns and steps by SciPy, angles on from those before."""
    poses = "  - [0, 0, 0, 0.1, 0.2, 3.0]\n  - [0.2, 0.1, 0, 0.4, -0.1, -2.9]\n  - [0.1, 0, 0.3, 1.0, 0.3, -1.0]\n"
    order = order_of(tmp_path, f"{HOME}angles: absolute\napproach: none\nrotation: {rotation}\nposes:\n{poses}")
    first, second = legs(order)
    s = np.linspace(0, 1, 9)
    for leg, angles in ((first, [0.4, -0.1, 2 * math.pi - 2.9]), (second, [1.0, 0.3, 2 * math.pi - 1.0])):
        p, q = leg.at(s)
        ends = Rotation.from_quat(q[[0, -1]], scalar_first=True)
        assert same_turn(q[-1], Rotation.from_euler("xyz", angles))
        np.testing.assert_allclose(leg.share(p, q), s, rtol=0, atol=1e-13)
        np.testing.assert_allclose(leg.turned(q), s[:, None] * leg.turn, rtol=0, atol=1e-13)
        np.testing.assert_allclose(leg.steps(q), np.tile(leg.turn / 8, (8, 1)), rtol=0, atol=1e-13)
        if rotation == "slerp":
            assert leg.L_q == pytest.approx((ends[0].inv() * ends[1]).magnitude(), rel=1e-13)
        off = np.cross(leg.way, [0.3, 0.5, -0.2])
        np.testing.assert_allclose(leg.share(p + off, q), s, rtol=0, atol=1e-13)
        ahead = leg.share(p + 0.01 * leg.way, q) - s
        np.testing.assert_allclose(ahead, 0.01 * leg.L_p**2 / (leg.L_p**2 + leg.L_q**2), rtol=1e-9)


def test_angles_lose_digits_near_their_lock(tmp_path: Path) -> None:
    """As one over the cosine of beta, of the row nearest to it; a thousandfold at most; turn vectors lose none."""
    for rotation in ("tait-bryan", "slerp"):
        poses = "  - [0, 0, 0, 0, 0, 0]\n  - [0, 0, 0, 0, 1, 0]\n"
        (leg,) = legs(
            order_of(tmp_path, f"{HOME}angles: absolute\napproach: none\nrotation: {rotation}\nposes:\n{poses}")
        )
        for beta, lost in ((0.0, 1.0), (1.0, 1 / math.cos(1.0)), (-1.5, 1 / math.cos(1.5)), (math.pi / 2 - 1e-5, 1e3)):
            q = Rotation.from_euler("xyz", [[0.3, 0, 1.0], [0.3, beta, 1.0], [0.3, 0.1, 1]]).as_quat(scalar_first=True)
            wanted = 1.0 if rotation == "slerp" else max(lost, 1 / math.cos(0.1))
            assert leg.rounding(q) == pytest.approx(ROUNDING * wanted, rel=1e-9)


# ------------------------------------------------------------------------------------------------------------ CSV files


@pytest.mark.parametrize("mark", [",", ";", "\t"])
def test_a_path_as_csv(mark: str, tmp_path: Path) -> None:
    rng = np.random.default_rng(8)
    zero = Rotation.from_euler("xyz", [0.3, -0.4, 1.0])
    p, angles = rng.uniform(-1, 1, (2, 5, 3))
    q = (Rotation.from_euler("xyz", angles) * zero).as_quat(scalar_first=True)
    by_angles = [" X [mm]", '"y [m]"', "z[cm]", "Alpha [deg]", "beta", "gamma [rad]"]
    by_angles[4] = "beta [°]"
    columns = np.column_stack([p * [1e3, 1, 100], np.degrees(angles[:, :2]), angles[:, 2]])
    by_q = ["qw", "qx [1]", "qy []", "qz", "z [m]", "y [m]", "x [m]"]
    for heads, table in ((by_angles, columns), (by_q, np.column_stack([3 * q, p[:, ::-1]]))):
        rows = [mark.join(repr(value) for value in row) for row in table.tolist()]
        (tmp_path / "way.csv").write_text("\n\n".join([mark.join(heads), *rows]) + "\n")
        lines = lines_of(str(tmp_path / "way.csv"))
        assert len(lines) == 6
        found = read_poses(lines, "way.csv", zero.as_quat(scalar_first=True))
        np.testing.assert_allclose(found, np.column_stack([p, angles]), rtol=0, atol=1e-14)
    assert len(read_poses(lines[:3], "way.csv", np.array([1.0, 0, 0, 0]))) == 2
    for bad, message in (
        (lines[:2], "way.csv: a path needs a header and at least two poses"),
        ([lines[0].replace("z [m]", "z [in]"), *lines[1:]], "way.csv:1: the judge does not know the column 'z [in]'"),
        ([mark.join(["a", "x"]), *lines[1:]], "way.csv:1: the judge does not know the column 'a'"),
        ([*lines, mark.join("1234")], "way.csv: a row is no row of numbers"),
        ([mark.join(["x [m]", "y [m]"]), *[mark.join("12")] * 2], "way.csv:1: has no column z"),
        ([*lines[:2], mark.join(["nan"] * 7)], "way.csv: a row is no row of numbers: not all are finite"),
    ):
        with pytest.raises(InputError) as caught:
            read_poses(bad, "way.csv", np.array([1.0, 0, 0, 0]))
        assert str(caught.value).startswith(message)


@pytest.mark.parametrize(("most", "read"), [(3, True), (2, False)])
def test_a_path_of_more_poses_than_the_judge_takes_is_said(
    most: int, read: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trajopt_cli.iiwa.judge.task_order.MOST", most)
    rows = "".join(f"{i},0,0,0.6,0,0.8,0\n" for i in range(3))
    (tmp_path / "way.csv").write_text(f"x [m],y [m],z [m],qw,qx,qy,qz\n{rows}")
    order = order_of(tmp_path, f"{HOME}approach: none\nangles: absolute\nposes: way.csv\n")
    said = () if read else (f"{tmp_path}/way.csv: path and speeds, because 3 poses are more than 2",)
    assert (order.unchecked, order.driven) == (said, False)
    assert (order.stops is not None) == read
    for i, stop in enumerate(order.stops or ()):
        np.testing.assert_allclose(stop.pose[:3], [i, 0, 0], rtol=0, atol=0)
        assert same_turn(np.array([0.6, 0, 0.8, 0]), Rotation.from_euler("xyz", stop.pose[3:]))
        assert (stop.name, str(stop.place)) == (str(i + 1), f"{tmp_path}/way.csv:{i + 2}:1")


def test_half_a_turn_may_go_either_way(tmp_path: Path) -> None:
    """Of a slerp by half a turn the rows say which way; of a smaller one the shorter."""
    for size, free in ((math.pi, True), (math.pi - 0.9e-6, True), (math.pi - 1.1e-6, False)):
        poses = f"  - [0, 0, 0, 0, 0, 0]\n  - [0, 0, 0, 0, 0, {size!r}]\n"
        order = order_of(tmp_path, f"{HOME}angles: absolute\napproach: none\nrotation: slerp\nposes:\n{poses}")
        (leg,) = legs(order)
        for way in (1, -1):
            angles = way * np.array([0, 0, 0.3, 1.0, math.pi - 0.05])
            q = Rotation.from_euler("z", angles[:, None]).as_quat(scalar_first=True)
            on, turns = leg.as_gone(q), way if free else np.sign(leg.turn[2])
            assert np.sign(on.turn[2]) == turns
            assert on.L_q == pytest.approx(size if turns == np.sign(leg.turn[2]) else 2 * math.pi - size, abs=1e-12)
            if free:
                np.testing.assert_allclose(on.turned(q), np.outer(angles, [0, 0, 1]), rtol=0, atol=1e-12)
                end = Rotation.from_rotvec([0, 0, way * (math.pi + 0.5e-6)]).as_quat(scalar_first=True)
                np.testing.assert_allclose(on.turned(end[None])[0, 2], way * (math.pi + 0.5e-6), rtol=0, atol=1e-12)
