"""Task files: what they mean in SI, and one line with the place for every mistake."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import load_contact, load_task, parse_task
from trajopt_cli.iiwa.task.model import AngleMeaning, Integration, Profile, RotationLaw

PROGRAMS = Path(__file__).parents[3] / "programs"
# Flange at q = [0, 30, 0, -100, 0, 50, 0] deg, by hand from the arm's lengths: it points straight down.
A, B = np.radians(30), np.radians(130)
START = np.array([0.4 * np.sin(A) + 0.4 * np.sin(B), 0, 0.34 + 0.4 * np.cos(A) + 0.4 * np.cos(B) - 0.126])

MINIMAL = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
poses:
  - start
  - [0.5, 0.1, 300 mm, 0, 10 deg, 0]
v_max: 0.2
omega_max: 30 deg/s
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""


def changed(old: str, new: str) -> str:
    assert old in MINIMAL
    return MINIMAL.replace(old, new)


def test_a_minimal_file_in_si() -> None:
    task = parse_task(MINIMAL, "t.yaml")
    first, second = task.route.waypoints
    np.testing.assert_allclose(first.pose, [*START, 0, 0, 0], rtol=0, atol=1e-15)
    np.testing.assert_allclose(second.pose, [0.5, 0.1, 0.3, 0, np.radians(10), 0], rtol=1e-15)
    assert second.place == "t.yaml:4"
    ((v_max, omega_max, *_),) = task.route.caps
    assert v_max == 0.2
    assert omega_max == pytest.approx(np.radians(30), rel=1e-15)
    assert (task.route.h, task.route.profile, task.route.rotation) == (0.001, Profile.THESIS, RotationLaw.TAIT_BRYAN)
    assert task.route.meaning is AngleMeaning.RELATIVE
    assert task.integration is Integration.EULER
    np.testing.assert_array_equal(task.compliance.K, [1000, 1000, 1000, 30, 30, 30])
    assert task.load is task.sensor is task.contact is None


def test_start_counts_from_the_world_where_angles_do() -> None:
    task = parse_task(MINIMAL + "angles: absolute\n", "t.yaml")
    # The flange points down with its x axis backwards: half a turn about y, which is half a turn about x and z.
    np.testing.assert_allclose(np.abs(task.route.waypoints[0].pose[3:]), [np.pi, 0, np.pi], atol=1e-12)


def test_by_adds_to_the_pose_before_and_the_tool_moves_the_start() -> None:
    text = changed(
        "  - [0.5, 0.1, 300 mm, 0, 10 deg, 0]", "  - {name: up, by: [0, 0, 0.05, 0, 0, 90 deg], dwell: 20 ms}"
    )
    task = parse_task(text + "tool: {position: [0, 0, 0.1]}\n", "t.yaml")
    first, second = task.route.waypoints
    np.testing.assert_allclose(first.pose[:3], START - [0, 0, 0.1], rtol=0, atol=1e-15)
    np.testing.assert_allclose(second.pose - first.pose, [0, 0, 0.05, 0, 0, np.pi / 2], rtol=0, atol=1e-15)
    assert (second.name, second.dwell) == ("up", 0.02)


def test_changes_come_in_order_and_keep_what_they_do_not_name() -> None:
    text = MINIMAL + (
        "changes:\n"
        "  - {at: 2 s, D: [50, 50, 50, 2, 2, 2]}\n"
        "  - {at: 1 s, K: [0, 1000, 1000, 30, 30, 30], zero: {components: [fx, my], frame: [0, 30 deg, 0]}}\n"
    )
    task = parse_task(text, "t.yaml")
    assert [change.t for change in task.changes] == [1.0, 2.0]
    first, last = (change.compliance for change in task.changes)
    assert first is not None
    assert last is not None
    assert (first.K[0], first.D[0]) == (0, 500)
    assert (last.K[0], last.D[0]) == (0, 50)
    assert task.changes[0].zeroing is not None
    assert task.changes[0].zeroing.zeroed == (True, False, False, False, True, False)


@pytest.mark.parametrize("name", ["iiwa_cube", "iiwa_edge", "iiwa_eight", "iiwa_polish", "iiwa_wall"])
def test_the_files_that_ship_are_read(name: str) -> None:
    assert len(load_task(PROGRAMS / f"{name}.yaml").route.waypoints) >= 2


def test_contact_stands_in_a_task_file_or_alone(tmp_path: Path) -> None:
    alone = tmp_path / "wall.yaml"
    alone.write_text("contact: {tip: 2 cm, obstacles: {wall: {box: {size: [1, 1, 0.1]}, stiffness: 20 N/mm}}}\n")
    contact, text = load_contact(alone)
    assert (contact.tip, contact.obstacles[0].stiffness, contact.obstacles[0].friction) == (0.02, 20e3, 0)
    assert text.startswith("contact")
    both, _ = load_contact(PROGRAMS / "iiwa_polish.yaml")
    assert both.obstacles[0].shape.name == "plate"


PROGRAM_TASK = "".join(
    line + "\n" for line in MINIMAL.splitlines() if not line.startswith(("poses", "  - ", "v_max", "omega_max"))
)

MISTAKES = [
    (changed("v_max: 0.2", "vmax: 0.2"), "t.yaml:5: vmax: unknown key; did you mean 'v_max'?"),
    (changed("M: [25,", "M: [-25,"), "t.yaml:9: M: needs a number above zero, not -25"),
    (changed("K: [1000,", "K: [-1,"), "t.yaml:7: K: cannot be negative: -1"),
    (changed("K: [1000,", "K: [.nan,"), "t.yaml:7: K: needs a finite number, not nan"),
    (
        changed("K: [1000,", "K: [0,").replace("D: [500,", "D: [0,"),
        "t.yaml:7: K and D of x are both 0: nothing would stop the motion; give it some damping",
    ),
    (changed("  - [0.5, 0.1, 300 mm, 0, 10 deg, 0]\n", ""), "t.yaml:2: poses: 1 given; a path needs at least two"),
    (changed("[0.5, 0.1, 300 mm, 0, 10 deg, 0]", "[0.5, 0.1]"), "t.yaml:4: poses.1.at: needs 6 values, not 2"),
    (
        changed("10 deg", "10 mm"),
        "t.yaml:4: poses.1.at: unit 'mm' of \"10 mm\" is not one of deg, rad, °",
    ),
    (changed("  - start\n", "  - home\n"), "needs [x, y, z, alpha, beta, gamma] or 'start', not \"home\""),
    (changed("  - start\n", "  - {by: [0, 0, 0, 0, 0, 0]}\n"), "t.yaml:3: poses.0: 'by' adds to the pose before"),
    (changed("omega_max: 30 deg/s\n", ""), "t.yaml:1: omega_max: is missing; give a cap for all segments"),
    (changed("v_max: 0.2", "v_max: [0.2, 0.3]"), "t.yaml:5: v_max: 2 values for 1 segments; give one for all"),
    (changed("50, 0] deg", "50] deg"), "t.yaml:1: start.joints: needs 7 numbers, not 6"),
    (changed("start: {", "h: 0\nstart: {"), "t.yaml:1: h: needs a number above zero, not 0"),
    ("robot: iiwa8\n" + MINIMAL, "t.yaml:1: robot: unknown robot 'iiwa8'"),
    ("robot: irb140\n" + MINIMAL, "t.yaml:1: robot: "),
    ("limits: fast\n" + MINIMAL, "t.yaml:1: limits: robot iiwa7 has no limit profile 'fast'"),
    ("", "t.yaml:1: holds no 'key: value' lines; start, poses, v_max, omega_max, K, D and M are needed at least"),
    ("program: x.mod\n" + MINIMAL, "give one of 'poses' (a list) and 'program'"),
    ("clamps: {force: [0, 1, 1, 1, 1, 1]}\n" + MINIMAL, "t.yaml:1: clamps: force is [0.0, 1.0"),
    (changed("[0, 30, 0,", "[171, 30, 0,"), "t.yaml:1: start.joints: joint_1 = 171°, outside its range -170°..170°"),
    (changed("50, 0] deg", "0, 0] deg"), "t.yaml:1: start.joints: singular, "),
    (changed("-100, 0", "0, 0"), "t.yaml:1: start.joints: singular, "),
    (changed("v_max: 0.2", "v_max: 1e6"), "t.yaml:5: v_max: 1e+06 is beyond anything a cell has (at most 1000 m/s)"),
    ("h: 1e-9\n" + MINIMAL, "t.yaml:1: h: needs a period between 0.01 ms and 1 s, not 1e-09 s"),
    ("tool: {position: [0, 0, 100]}\n" + MINIMAL, "t.yaml:1: tool.position: 100 m is farther than 10 m"),
    (changed("  - start\n", '  - {name: "a\\nb", at: start}\n'), "t.yaml:3: poses.0.name: holds a character"),
    (PROGRAM_TASK + "program: ../x.mod\n", "program: needs a file in the task file's folder or below it"),
    (changed("M: [25,", "M: [1e-300,"), "t.yaml:9: M: 1e-300 is below anything a cell has"),
    (changed("v_max: 0.2", "v_max: 1e-300"), "t.yaml:5: v_max: 1e-300 is below anything a cell has"),
    (changed("  - start\n", f"  - {{name: {'a' * 101}, at: start}}\n"), "poses.0.name: needs a name of 1 to 100"),
    (PROGRAM_TASK + "program: no.mod\n", "program: there is no file no.mod"),
    (
        "contact: {tip: 20, obstacles: {b: {box: {size: [1, 1, 1]}, stiffness: 1}}}\n" + MINIMAL,
        "t.yaml:1: contact.tip: 20 m is thicker than 1 m",
    ),
    (
        "contact: {tip: 0.02, obstacles: {b: {box: {size: [1, 1e10, 1]}, stiffness: 1}}}\n" + MINIMAL,
        "t.yaml:1: contact.obstacles.b.box.size: 1, 1e+10, 1 m; wanted three lengths",
    ),
    ("sensor:\n" + MINIMAL, "t.yaml:1: sensor: is empty"),
    ("pushes: [{from: 2, to: 1, force: [1, 0, 0, 0, 0, 0]}]\n" + MINIMAL, "'from' comes first"),
]


@pytest.mark.parametrize(("text", "said"), MISTAKES, ids=[said[:40] for _, said in MISTAKES])
def test_every_mistake_is_one_line_with_its_place(text: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        parse_task(text, "t.yaml")
    assert said in str(error.value)
    assert "\n" not in str(error.value)


MODULE = """\
MODULE seam
  PERS tooldata tip := [TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST robtarget a := [[500,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget b := [[500,150,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveJ a, v100, fine, tip;
    MoveL b, v100, fine, tip;
    WaitTime 0.5;
    SetDO do1, 1;
    MoveL a, v200, fine, tip;
    MoveL a, v200, fine, tip;
  ENDPROC
ENDMODULE
"""


def test_rapid_moves_are_poses_with_their_speeds_and_waits(tmp_path: Path) -> None:
    (tmp_path / "seam.mod").write_text(MODULE)
    path = tmp_path / "seam.yaml"
    path.write_text(PROGRAM_TASK + "program: seam.mod\napproach: none\n")
    task = load_task(path)
    assert [waypoint.name for waypoint in task.route.waypoints] == ["a", "b", "a"]
    np.testing.assert_allclose(task.route.waypoints[1].pose[:3], [0.5, 0.15, 0.3], rtol=1e-15)
    # [0, 0, 1, 0] is half a turn about y, and so is the flange at the start: nothing to turn.
    np.testing.assert_allclose(task.route.waypoints[1].pose[3:], 0, atol=1e-12)
    assert task.route.caps[:, 0].tolist() == [0.1, 0.2]
    assert task.route.waypoints[1].dwell == 0.5
    assert any("do1 is left out" in note for note in task.notes)
    assert any("seam.mod:11: a repeats the pose before; left out" in note for note in task.notes)
    assert load_task(path, tmp_path / "seam.mod").route.waypoints[1].name == "b"
    # the program's tool is the task's: 100 mm along the flange's z, and the start is where that tool is
    np.testing.assert_array_equal(task.X_FT[:3, 3], [0, 0, 0.1])
    assert any("its load is not taken over" in note for note in task.notes)
    (tmp_path / "seam.mod").write_text(MODULE.replace("[0,0,100]", "[0,0,1E12]"))
    with pytest.raises(InputError, match=r"seam.mod: the moves' tool reaches 1e\+09 m from the flange, at most 10 m"):
        load_task(path)
    (tmp_path / "seam.mod").write_text(MODULE)
    path.write_text(PROGRAM_TASK + "program: seam.mod\ntool: {position: [0, 0, 0.1], load: {mass: 1}}\n")
    assert load_task(path).load is not None


def test_a_task_has_the_programs_one_tool_and_says_what_it_makes_of_zones(tmp_path: Path) -> None:
    path = tmp_path / "seam.yaml"
    (tmp_path / "seam.mod").write_text(MODULE)
    path.write_text(PROGRAM_TASK + "program: seam.mod\ntool: {position: [0, 0, 0.08]}\n")
    with pytest.raises(
        InputError, match=r"seam.mod:6:5: tool tip stands at 0 0 100 mm .* the task's tool at 0 0 80 mm"
    ):
        load_task(path)
    (tmp_path / "seam.mod").write_text(MODULE.replace("MoveL b, v100, fine, tip", "MoveL b, v100, z50, tool0"))
    path.write_text(PROGRAM_TASK + "program: seam.mod\n")
    with pytest.raises(InputError, match=r"seam.mod:7:5: tool tool0 after tip; a task has one tool"):
        load_task(path)
    (tmp_path / "seam.mod").write_text(MODULE.replace("v100, fine", "v100, z50"))
    told = "2 fly-by zones are taken as stops: every pose is reached; with 'passing' they are passed"
    assert told in load_task(path).notes


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "WaitTime 0.5;",
            "MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v100, fine, tip;",
            "MoveAbsJ is not a straight",
        ),
        ("WaitTime 0.5;", "MoveJ a, v100, fine, tip;", "MoveJ is not a straight segment"),
        ("MoveJ a", "WaitTime 1; MoveJ a", "a wait before the first pose"),
        ("MoveL b,", "MoveL \\Conc, b,", "a wait beside a move"),
        ("WaitTime 0.5;", "Stop;", "waits for Stop, which has no known length"),
        (
            "WaitTime 0.5;",
            "MoveC Offs(b,9,9,0), a, v100, fine, tip;",
            "MoveC is not a straight segment; give 'passing' a tolerance",
        ),
        ("MoveJ a", "AccSet 50,100; MoveJ a", "6:20: AccSet is active here; a task's segments have none, so take it"),
        ("MoveJ a", "PathAccLim TRUE\\AccMax:=2,FALSE; MoveJ a", "PathAccLim or WorldAccLim is active here"),
        ("MoveJ a", "SingArea\\Wrist; MoveJ a", "SingArea is active here"),
        (
            "MoveL b, v100, fine, tip",
            "MoveLDO b, v100, fine, tip, do1, 1",
            "MoveLDO does more than move",
        ),
        ("WaitTime 0.5;", 'TPReadNum reg1, "?";', "a task has no cell file to tell it; leave it out of the program"),
    ],
)
def test_other_rapid_motions_are_refused_with_their_place(tmp_path: Path, old: str, new: str, said: str) -> None:
    (tmp_path / "seam.mod").write_text(MODULE.replace(old, new, 1))
    path = tmp_path / "seam.yaml"
    path.write_text(PROGRAM_TASK + "program: seam.mod\n")
    with pytest.raises(InputError, match=said) as error:
        load_task(path)
    assert "seam.mod:" in str(error.value)
