"""The parts of the compliant job's judge, each against a second source: truth files, SciPy, closed forms."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from iiwa_folders import task_text
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import pose
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.joints import arm_angles, configuration, wrapped
from trajopt_cli.iiwa.judge.path import legs
from trajopt_cli.iiwa.judge.samples import poses_of_joints
from trajopt_cli.iiwa.judge.task_order import FramePose, arm_frame, periods, read_arm, read_order
from trajopt_cli.iiwa.judge.tolerances import ROUNDING
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.trajectory import Trajectory

TRUTH = Path(__file__).parents[1] / "data" / "truth"
FAR_BASE = FramePose(np.array([3.0, -2.0, 1.0]), np.array([1.0, 0, 0, 0]))


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(7)


def test_tool_arm_angle_and_configuration_are_those_of_the_truth_file() -> None:
    arm = read_arm("iiwa7", "default")
    cases = json.loads((TRUTH / "iiwa7_fk.json").read_text())["cases"]
    q = np.array([case["q"] for case in cases])
    for row, case in zip(q, cases, strict=True):
        flange = arm_frame(arm.mechanism, row)
        np.testing.assert_allclose(flange.p, case["p"], rtol=0, atol=1e-14)
        assert turns.angle_between(flange.q, np.array(case["quat_wxyz"])) < 1e-14
        assert configuration(row) == case["config_bits"]
    angle, off = arm_angles(arm.mechanism, q, swivel=False)
    wanted = np.array([case["arm_angle"] for case in cases])
    assert np.all(np.abs(wrapped(angle - wanted)) * off < 1e-14)
    swivel = arm_angles(arm.mechanism, q, swivel=True)[0]
    np.testing.assert_allclose(np.cos(swivel - angle), np.where(q[:, 3] < 0, 1, -1), rtol=0, atol=1e-12)


def test_what_printed_joints_leave_open_about_the_tool(rng: np.random.Generator) -> None:
    """Poses and levers by the closed form; half a printed step of every joint, and rounding that grows with size."""
    robot, arm = load_srs("iiwa7", pose(np.eye(3), [3.0, -2.0, 1.0])), read_arm("iiwa7", "default", FAR_BASE)
    tool = FramePose(np.array([0.1, -0.2, 0.3]), np.array([0.6, 0, 0.8, 0]))
    X_FT = pose(Rotation.from_quat(tool.q, scalar_first=True).as_matrix(), tool.p)
    q, steps = rng.uniform(-2, 2, (5, 7)), rng.uniform(1e-6, 1e-5, (5, 7))
    rows = Trajectory(robot.axis_names, np.arange(5) * 1.0, q)
    X, J = robot.forward(q) @ X_FT, robot.jacobian(q, X_FT)
    for resolution in (None, Resolution(0.0, steps, 0 * steps), Resolution(0.0, steps[:1], 0 * steps[:1])):
        found = poses_of_joints(arm, tool, rows, resolution, 2e-3)
        np.testing.assert_allclose(found.p, X[:, :3, 3], rtol=0, atol=1e-13)
        wanted = Rotation.from_matrix(X[:, :3, :3]).as_quat(scalar_first=True)
        assert np.all(turns.angle_between(found.q, wanted) < 1e-13)
        half = np.broadcast_to(0.0 if resolution is None else resolution.q / 2, (5, 7))
        rounding = ROUNDING * (1 + np.linalg.norm(X[:, :3, 3], axis=1))
        off_p = (np.linalg.norm(J[:, :3], axis=1) * half).sum(axis=1) + rounding
        np.testing.assert_allclose(found.off_p, off_p, rtol=1e-9)
        np.testing.assert_allclose(found.off_q, half.sum(axis=1) + ROUNDING, rtol=1e-12)
        assert (found.period, list(found.t)) == (2e-3, [0, 1, 2, 3, 4])


def test_limits_are_those_of_the_data_sheet() -> None:
    arm = read_arm("iiwa7", "default")
    np.testing.assert_allclose(np.degrees(arm.upper), [170, 120, 170, 120, 170, 120, 175], rtol=1e-12)
    np.testing.assert_allclose(arm.lower, -arm.upper)
    np.testing.assert_allclose(np.degrees(arm.velocity), [98, 98, 100, 130, 140, 180, 180], rtol=1e-12)
    np.testing.assert_allclose(arm.acceleration, [8.65, 5.44, 5.69, 11.01, 11.78, 13.76, 13.17])


def test_rotations_are_scipys(rng: np.random.Generator) -> None:
    angles = rng.uniform(-1.5, 1.5, (50, 3))
    ours, theirs = turns.from_angles(angles), Rotation.from_euler("xyz", angles)
    assert np.all(turns.angle_between(ours, theirs.as_quat(scalar_first=True)) < 1e-14)
    np.testing.assert_allclose(turns.to_angles(ours), angles, rtol=0, atol=1e-13)
    np.testing.assert_allclose(turns.logarithm(ours), theirs.as_rotvec(), rtol=0, atol=1e-14)
    np.testing.assert_allclose(turns.from_matrix(theirs.as_matrix()), theirs.as_quat(True, scalar_first=True) * np.sign(
        np.sum(turns.from_matrix(theirs.as_matrix()) * theirs.as_quat(True, scalar_first=True), axis=1))[:, None],
        rtol=0, atol=1e-15)  # fmt: skip
    points = rng.normal(size=(50, 3))
    np.testing.assert_allclose(turns.turned(ours, points), theirs.apply(points), rtol=0, atol=1e-14)
    for tiny in (1e-9, 1e-14):
        turn = np.array([tiny, 0, 0])
        assert turns.angle_between(turns.exponential(turn), np.array([1.0, 0, 0, 0])) == pytest.approx(tiny, rel=1e-9)
    half = Rotation.from_rotvec(np.pi * np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0, 0.8]]))
    assert np.all(turns.angle_between(turns.from_matrix(half.as_matrix()), half.as_quat(scalar_first=True)) < 1e-14)


@pytest.mark.parametrize("rotation", ["tait-bryan", "slerp"])
def test_the_way_between_two_poses(rotation: str, tmp_path: Path) -> None:
    path = tmp_path / "task.yaml"
    path.write_text(task_text(rotation=rotation))
    order = read_order(str(path))
    assert order.start is not None
    assert order.stops is not None
    leg, s = legs(order)[1], np.linspace(0, 1, 11)
    begin, end = order.stops[1].pose, order.stops[2].pose
    ends = Rotation.from_euler("xyz", [begin[3:], end[3:]])
    start = Rotation.from_quat(order.start.q, scalar_first=True)
    wanted = Slerp([0, 1], ends)(s) if rotation == "slerp" else Rotation.from_euler(
        "xyz", begin[3:] + s[:, None] * (end - begin)[3:])  # fmt: skip
    p, q = leg.at(s)
    np.testing.assert_allclose(p, begin[:3] + s[:, None] * (end - begin)[:3], rtol=0, atol=1e-15)
    assert np.all(turns.angle_between(q, (wanted * start).as_quat(scalar_first=True)) < 1e-14)
    np.testing.assert_allclose(leg.share(p, q), s, rtol=0, atol=1e-13)


def test_a_dwell_is_whole_periods_and_never_shorter_than_told() -> None:
    assert [periods(dwell, 1e-3) for dwell in (0.0, 1e-4, 1e-3, 0.5, 0.5004)] == [0, 1, 1, 500, 501]
    assert periods(0.3, 0.1) == 3


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ("v_max: 0.2", "v_max: fast", "v_max: needs a number, or a text with one of m/s, cm/s, mm/s, not 'fast'"),
        ("dwell: 50 ms", "dwell: 50 mm", "poses.2.dwell: needs a number, or a text with one of s, ms, not '50 mm'"),
        ("at: start, dwell", "dwell", "poses.0: needs one of 'at' and 'by'"),
        ("start: {joints", "robot: irb141\nstart: {joints", "unknown robot 'irb141'"),
        ("v_max: 0.2", "v_max: -1", "v_max: is -1; a cap is 0 or more"),
        ("v_max: 0.2", "v_max: .inf", "v_max: needs a number"),
        ("profile: trapezoid", "profile: best", "profile: needs thesis or trapezoid or s-curve, not 'best'"),
        ("tool: {position: [0, 0, 0.05]}", "tool: here", "tool: needs a section, not 'here'"),
        ("poses:", "h: 0\nposes:", "h: needs a period above zero, not 0"),
        ("start: {joints", "limits: best\nstart: {joints", "there is no profile best; known are default"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_one_line(before: str, after: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "task.yaml"
    path.write_text(task_text().replace(before, after))
    with pytest.raises(InputError) as caught:
        read_order(str(path))
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize(
    ("more", "poses", "said"),
    [
        ("weaving: 5 mm\n", None, "task.yaml:4: path and speeds, because the judge does not know the key 'weaving'"),
        (
            "",
            "program: way.mod\n",
            "path and speeds, because they come from a RAPID program, which this judge does not",
        ),
    ],
)
def test_a_way_that_the_judge_cannot_build_is_said(more: str, poses: str | None, said: str, tmp_path: Path) -> None:
    path = tmp_path / "task.yaml"
    path.write_text(task_text(more=more) if poses is None else task_text(poses=poses))
    order = read_order(str(path))
    assert order.stops is None
    assert any(said in line for line in order.unchecked), order.unchecked
