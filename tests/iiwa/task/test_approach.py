"""The way to the first pose: where it begins, where it ends, and that orientations stay what the user wrote."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.loader import parse_task
from trajopt_cli.iiwa.task.model import Task
from trajopt_cli.iiwa.task.segments import interpolate
from trajopt_cli.robot.srs import load_srs

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
poses:
  - [0.52, 0.05, 0.3, 0, 10 deg, 0]
  - {name: up, at: [0.5, 0.1, 0.35, 0, 20 deg, 5 deg]}
  - [0.5, 0.1, 0.3, 0, 10 deg, 0]
v_max: [0.1, 0.2]
omega_max: 60 deg/s
a_max: 1
epsilon_max: 4
jerk: 20
angular_jerk: 80
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
CSV = """\
x [m],y [m],z [m],alpha [deg],beta [deg],gamma [deg]
0.52,0.05,0.3,0,10,0
0.5,0.1,0.35,0,20,5
0.5,0.1,0.3,0,10,0
"""


def tool_at_start(task: Task) -> Array:
    return load_srs(task.robot, task.X_WB).forward(task.start_joints) @ task.X_FT


def test_a_line_from_the_start_goes_before_the_path_at_the_first_segments_caps() -> None:
    task = parse_task(TASK, "t.yaml")
    X = tool_at_start(task)
    first, *rest = task.route.waypoints
    assert (first.name, first.place) == ("start", "t.yaml:1")
    assert [waypoint.name for waypoint in rest] == ["1", "up", "3"]
    assert first.pose == pytest.approx([*X[:3, 3], 0, 0, 0])
    assert task.route.caps[:, 0].tolist() == [0.1, 0.1, 0.2]
    found = interpolate(task.route)
    assert (found.pieces[0].origin, found.pieces[0].goal) == ("start", "1")
    assert np.array_equal(found.pose[found.pieces[0].last], rest[0].pose)
    way = np.linalg.norm(rest[0].pose[:3] - X[:3, 3])
    (note,) = task.notes
    assert note == (
        "approach: a line from the tool at the start joints to pose 1,"
        f" {1e3 * way:.4g} mm and 10°, goes before the path"
    )


@pytest.mark.parametrize("passing", ["", "passing: {tolerance: 1 mm}\n"])
def test_where_both_agree_nothing_changes(passing: str) -> None:
    text = TASK.replace("  - [0.52, 0.05, 0.3, 0, 10 deg, 0]", "  - start") + passing
    plain = interpolate(parse_task(text + "approach: none\n", "t.yaml").route)
    for approach in ("line", "joint"):
        task = parse_task(text + f"approach: {approach}\n", "t.yaml")
        found = interpolate(task.route)
        assert np.array_equal(found.pose, plain.pose)
        assert found.pieces == plain.pieces
        assert task.notes == ()


@pytest.mark.parametrize("angles", ["relative", "absolute"])
@pytest.mark.parametrize("law", ["tait-bryan", "slerp"])
def test_after_a_joint_move_the_controller_begins_at_the_first_pose(angles: str, law: str) -> None:
    text = TASK + f"angles: {angles}\nrotation: {law}\ntool: {{position: [0, 0, 0.1], rpy: [0, 10 deg, 0]}}\n"
    if angles == "absolute":
        text = text.replace("10 deg, 0]\n", "10 deg, 180 deg]\n").replace(", 0, 20 deg, 5", ", 180 deg, 20 deg, 5")
        text = text.replace("0.3, 0, 10", "0.3, 180 deg, 10")
    plain, task = (parse_task(text + f"approach: {kind}\n", "t.yaml") for kind in ("none", "joint"))
    R_0, X = tool_at_start(plain)[:3, :3], tool_at_start(task)
    before, found = (interpolate(one.route) for one in (plain, task))
    ends = [piece.last for piece in found.pieces]
    assert X[:3, 3] == pytest.approx(found.pose[0, :3], abs=1e-12)
    assert X[:3, :3] == pytest.approx(before.rotations(R_0)[0], abs=1e-12)
    wanted = before.rotations(R_0)[[piece.last for piece in before.pieces]]
    assert found.rotations(X[:3, :3])[ends] == pytest.approx(wanted, abs=1e-12)
    if angles == "relative":
        assert np.array_equal(found.pose[0, 3:], np.zeros(3))
    assert np.sign(task.start_joints[1::2]).tolist() == [1, -1, 1]
    assert any(note.startswith("approach: a joint move to pose 1, ") for note in task.notes)


def test_a_long_path_is_approached_alike_and_its_first_pose_is_a_stop(tmp_path: Path) -> None:
    (tmp_path / "p.csv").write_text(CSV)
    text = TASK[: TASK.index("poses")] + "poses: p.csv\n" + TASK[TASK.index("v_max") :]
    task = parse_task(text, str(tmp_path / "t.yaml"))
    assert [waypoint.name for waypoint in task.route.waypoints] == ["start", "1", "2", "3"]
    assert task.route.stops == [0, 1, 3]
    found = interpolate(task.route)
    assert [(piece.origin, piece.goal) for piece in found.pieces] == [("start", "1"), ("1", "3")]
    turned = parse_task(text + "approach: joint\n", str(tmp_path / "t.yaml"))
    listed = parse_task(TASK + "approach: joint\n", "t.yaml")
    assert turned.route.poses == pytest.approx(listed.route.poses, abs=1e-15)
    assert turned.start_joints == pytest.approx(listed.start_joints, abs=1e-12)


def test_a_first_pose_out_of_reach_cannot_be_driven_to() -> None:
    text = TASK.replace("[0.52,", "[2.52,") + "approach: joint\n"
    with pytest.raises(
        InputError, match=r"^t.yaml:3: approach: pose 1 is out of the arm's reach at an arm angle of 0°"
    ):
        parse_task(text, "t.yaml")


def test_orientations_by_scipy_are_those_of_a_joint_move() -> None:
    """R(angles) R_start of what was written is R(angles anew) R_first, with Scipy's rotations throughout."""
    turned = TASK.replace("0.3, 0, 10 deg, 0]\n  - {", "0.3, 5 deg, 10 deg, -7 deg]\n  - {")
    assert turned != TASK
    plain, task = (parse_task(turned + f"approach: {kind}\n", "t.yaml") for kind in ("none", "joint"))
    R_0, R_1 = (Rotation.from_matrix(tool_at_start(one)[:3, :3]) for one in (plain, task))
    for old, new in zip(plain.route.waypoints, task.route.waypoints, strict=True):
        was, now = (Rotation.from_euler("xyz", one.pose[3:]) for one in (old, new))
        assert ((was * R_0).inv() * (now * R_1)).magnitude() < 1e-12
