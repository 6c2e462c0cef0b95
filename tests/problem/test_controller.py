"""What a backup's MOC.cfg says of its mechanics, the cell file made of it, and a cell file that says otherwise."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.moc import read_moc
from trajopt_cli.problem.controller import differences, read_mechanics, shipped_robot
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.warnings import ProgramWarning, WarningKind

MOC = """MOC:CFG_1.0:6:0::
# a comment
MECHANICAL_UNIT:

      -name "TRACK" -use_single_0 "T1" -activate_at_start_up\\
      -deactivation_forbidden
#
ROBOT:

      -name "ROB_1" -use_robot_type "ROB1_140_0.81_6"\\
      -base_frame_pos_x 1.5 -base_frame_pos_z 0.25\\
      -base_frame_orient_u0 0.707107 -base_frame_orient_u3 0.707107 -base_frame_coordinated "TRACK"
#
SINGLE:

      -name "T1" -use_single_type "TR" -use_joint "track1" -base_frame_orient_u0 0\\
      -base_frame_orient_u3 1

      -name "STN1" -use_single_type "STN" -use_joint "stn1" -base_frame_pos_x 2
#
JOINT:

      -name "track1" -use_arm "t" -logical_axis 8 -use_transmission "tt" -use_drive_system "td"

      -name "stn1" -use_arm "s" -logical_axis 9 -use_transmission "ts"
#
TRANSMISSION:

      -name "tt" -transm_joint -250

      -name "ts" -rotating_move -transm_joint 100
#
DRIVE_SYSTEM:

      -name "td" -use_stress_duty_cycle "sd"
#
STRESS_DUTY_CYCLE:

      -name "sd" -speed_absolute_max 300
#
ACC_DATA:

      -name "ta" -wc_acc 2.5 -wc_dec 2.25
#
ARM:

      -name "rob1_1" -upper_joint_bound 1.5 -lower_joint_bound -2.5 -upper_joint_bound_max 3 -lower_joint_bound_min -3

      -name "rob1_4" -upper_joint_bound 9 -lower_joint_bound -9

      -name "t" -use_acc_data "ta" -upper_joint_bound 3.901 -lower_joint_bound -0.001

      -name "s" -upper_joint_bound 3 -lower_joint_bound -3
"""
FRAME = pose(rotation_about([0, 0, 1], pi / 2), [1.5, 0, 0.25])


def line(words: str, text: str = MOC) -> int:
    """The first line that holds some words."""
    return next(i for i, one in enumerate(text.splitlines(), start=1) if words in one)


ROB, TRACK, ARM_1, ARM_T = (
    line(one) for one in ("use_robot_type", "use_single_type", '"rob1_1" -upper', '"ta" -upper')
)
MODULE = """MODULE m
    CONST jointtarget j:=[[0,0,0,0,30,0],[9E9,100,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""
# the controller's track runs along -x of the world, which is +y of the arm's base
SAME = """robot: irb140_rail
rail:
  eax: b
  stroke: [0, 3.9]
  frame: {position: [1.5, 0, 0.25], rpy: "[0, 0, 90] deg"}
limits:
  joint_1: {lower: -2.5, upper: 1.5, source: test}
  rail: {velocity: 1, acceleration: 2, source: test}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


@pytest.fixture
def backup(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    for place, text in (("SYSPAR/MOC.cfg", MOC), ("RAPID/TASK1/PROGMOD/m.mod", MODULE)):
        path = Path("b") / place
        path.parent.mkdir(parents=True)
        path.write_text(text)
    return Path("b")


def told(backup: Path, cell: str) -> list[ProgramWarning]:
    Path("b.yaml").write_text(cell)
    loaded = load_cell("b.yaml")
    return [*differences([backup], loaded, build_plant(loaded), [str(backup)])]


def test_units_ranges_and_frames_are_read() -> None:
    moc = read_moc(MOC, "MOC.cfg")
    (arm,) = moc.robots
    track, table = moc.externals
    assert (arm.name, arm.type, arm.line) == ("ROB_1", "ROB1_140_0.81_6", ROB)
    assert np.allclose(arm.X, FRAME, atol=1e-6)
    assert arm.ranges == ((-2.5, 1.5, ARM_1), None, None, (-9, 9, ARM_1 + 2), None, None)
    assert arm.track is track
    assert (track.name, track.eax, track.range[:2] if track.range else None) == ("TRACK", 1, (-0.001, 3.901))
    assert (track.slides, track.active, track.fixed) == (True, True, True)
    assert (track.velocity, track.acceleration) == (pytest.approx(300 / 250), 2.25)
    assert track.X[:3, 0] == pytest.approx([-1, 0, 0], abs=1e-6)
    assert (table.name, table.eax, table.slides, table.active) == ("STN1", 2, False, False)
    assert not moc.notices


def test_a_unit_of_abbs_own_has_its_range_by_the_type_of_its_arm() -> None:
    """As an IRBT 4004 has it: no JOINT, an ARM of another name."""
    moc = read_moc(
        'ROBOT:\n-name "ROB_1" -use_joint_0 "rob1_1" -base_frame_coordinated "TRACK_1"\n'
        'SINGLE:\n-name "TRACK_1" -use_single_type "IRBT4004_1" -use_joint "track1"\n'
        'ARM:\n-name "T4004_3.9_1" -use_arm_type "track1" -upper_joint_bound 3.901 -lower_joint_bound -0.001\n'
        '-name "rob1_1" -upper_joint_bound 3.1416 -lower_joint_bound -3.1416\n',
        "MOC.cfg",
    )
    (track,) = moc.externals
    assert (track.eax, track.slides, track.velocity) == (None, True, None)
    assert track.range == (-0.001, 3.901, 6)
    assert moc.robots[0].ranges[0] == (-3.1416, 3.1416, 7)


def test_the_robot_of_a_task_is_taken() -> None:
    moc = read_moc('ROBOT:\n-name "ROB_1"\n-name "ROB_2"\n-name "ROB_L"\n', "MOC.cfg")
    names = {place: getattr(moc.robot_of(place), "name", None) for place in
             ("b/RAPID/T_ROB2/m.mod", "b/RAPID/T_ROB_L/m.mod", "b/RAPID/TASK1/m.mod", "b/t_rob1")}  # fmt: skip
    assert [*names.values()] == ["ROB_2", "ROB_L", "ROB_1", "ROB_1"]
    assert read_moc("ROBOT:\n", "MOC.cfg").robot_of("T_ROB1") is None


@pytest.mark.parametrize(
    ("old", "new", "at"),
    [
        ("-logical_axis 8", "-logical_axis 6", "-logical_axis 6"),
        ("-upper_joint_bound 3.901", "-upper_joint_bound 3901", "3901"),  # millimetres
        ("-upper_joint_bound 1.5", "-upper_joint_bound 155", "155"),  # degrees
        ("-base_frame_pos_z 0.25", "-base_frame_pos_z high", "high"),
        ("-base_frame_orient_u0 0.707107", "-base_frame_orient_u0 7", "use_robot_type"),
        ("JOINT:\n", "JOINT:\nsome words\n", "some words"),
        ('-name "tt"', 'name "tt"', 'name "tt"'),
        (
            "-upper_joint_bound 3 -lower_joint_bound -3\n",
            "-upper_joint_bound 3 -lower_joint_bound -3\\\n",
            '"s" -upper',
        ),
    ],
)
def test_what_is_broken_is_told_by_its_line_and_the_rest_is_read(old: str, new: str, at: str) -> None:
    text = MOC.replace(old, new)
    moc = read_moc(text, "MOC.cfg")
    assert {(one.kind, one.place) for one in moc.notices} == {(WarningKind.NOT_READ, f"MOC.cfg:{line(at, text)}")}
    assert (len(moc.robots), len(moc.externals)) == (1, 2)


@pytest.mark.parametrize("text", ["", "\0\1\2", "MODULE m\nENDMODULE\n", MOC[: MOC.index("-deact")]])
def test_a_file_that_is_none_or_cut_off_is_told(text: str) -> None:
    assert read_moc(text, "MOC.cfg").notices


def test_a_table_may_go_round_and_round_and_a_joint_may_not() -> None:
    moc = read_moc(MOC.replace("_bound 3 -lower_joint_bound -3\n", "_bound 700 -lower_joint_bound -700\n"), "MOC.cfg")
    assert [one.range and one.range[:2] for one in moc.externals] == [(-0.001, 3.901), (-700, 700)]
    assert not moc.notices


def test_of_several_robots_is_told_which(backup: Path) -> None:
    (backup / "SYSPAR/MOC.cfg").write_text(MOC.replace("#\nSINGLE", '\n      -name "ROB_2"\n#\nSINGLE'))
    assert [one.kind for one in told(backup, SAME)] == [WarningKind.NOT_READ]


def test_the_task_is_told_by_the_folder_also_from_inside(backup: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (backup / "SYSPAR/MOC.cfg").write_text(MOC.replace("#\nSINGLE", '\n      -name "ROB_2"\n#\nSINGLE'))
    (backup / "RAPID/TASK1").rename(backup / "RAPID/T_ROB2")
    Path("b.yaml").write_text(SAME)
    loaded = load_cell("b.yaml")
    monkeypatch.chdir(backup / "RAPID/T_ROB2/PROGMOD")
    found = differences([Path("m.mod")], loaded, build_plant(loaded), ["m.mod"])
    assert "b.yaml:2" in [one.place for one in found]  # ROB_2 stands on no track


def test_robot_types_are_those_that_ship() -> None:
    types = ("ROB1_4600_2.55_40", "ROB1_140_0.81_6", "ROB1_1200_0.9_5_TypeB", "ROB1_15000_0.95_5")
    assert [shipped_robot(kind) for kind in types] == ["irb4600_40_255", "irb140", "irb1200_5_90", "crb15000_5_95"]
    assert [shipped_robot(kind) for kind in ("ROB1_2600ID_2.00_8", "ROB1_4600_2.05_60", "ROB_L", "")] == [None] * 4


@pytest.mark.parametrize(
    ("kind", "told_at"),
    [("ROB1_2400_1.55_10", ["b.yaml:1"]), ("ROB1_2600ID_2.00_8", ["b.yaml:1"]), ("ROB1_140", []), ("custom", [])],
)
def test_a_robot_that_ships_for_a_type_that_does_not_is_told(backup: Path, kind: str, told_at: list[str]) -> None:
    (backup / "SYSPAR/MOC.cfg").write_text(MOC.replace("ROB1_140_0.81_6", kind))
    assert [one.place for one in told(backup, SAME)] == told_at


def test_a_file_without_a_robot_is_told(backup: Path) -> None:
    (backup / "SYSPAR/MOC.cfg").write_text(MOC.replace("ROBOT:", "ROBOTS:"))
    assert [one.place for one in told(backup, SAME)] == ["b/SYSPAR/MOC.cfg"]


@pytest.mark.parametrize("whole", [False, True])
def test_parameters_behind_a_link_out_of_the_backup_are_not_read(whole: bool, backup: Path, tmp_path: Path) -> None:
    (backup / "SYSPAR").rename(tmp_path / "elsewhere")
    if whole:
        (backup / "SYSPAR").symlink_to(tmp_path / "elsewhere")
    else:
        (backup / "SYSPAR").mkdir()
        (backup / "SYSPAR/MOC.cfg").symlink_to(tmp_path / "elsewhere/MOC.cfg")
    found, notices = read_mechanics([backup])
    assert found is None
    assert [one.kind for one in notices] == ([] if whole else [WarningKind.NOT_READ])


def test_a_cell_file_that_says_the_same_is_not_spoken_of(backup: Path) -> None:
    assert not told(backup, SAME)


@pytest.mark.parametrize(
    ("old", "new", "at", "there"),
    [
        ("[0, 3.9]", "[-0.2, 3.9]", 4, ARM_T),
        ("[0, 3.9]", "[0, 4]", 4, ARM_T),
        ("eax: b", "eax: a", 3, line("-logical_axis 8")),
        ("lower: -2.5", "lower: -2.6", 7, ARM_1),
        ("  joint_1: {lower: -2.5, upper: 1.5, source: test}\n", "", 6, ARM_1),
        ("[1.5, 0, 0.25]", "[1.5, 0.1, 0.25]", 5, ROB),
        ("acceleration: 2,", "acceleration: 2.5,", 8, TRACK),
        ("irb140_rail", "irb1200_5_90_rail", 1, ROB),
    ],
)
def test_a_contradiction_is_told_by_both_lines(backup: Path, old: str, new: str, at: int, there: int) -> None:
    found = [one for one in told(backup, SAME.replace(old, new)) if f"MOC.cfg:{there}" in one.text]
    assert [(one.kind, one.place) for one in found] == [(WarningKind.DOUBTFUL, f"b.yaml:{at}")]


def test_a_rail_that_runs_another_way_is_told(backup: Path) -> None:
    turned = SAME.replace("[0, 0, 90] deg", "[0, 0, 0] deg")
    assert [one.place for one in told(backup, turned)] == ["b.yaml:5"] * 2  # the base and the way


def test_a_rail_where_nothing_moves_the_base_is_told_and_none_where_something_does(backup: Path) -> None:
    moc = backup / "SYSPAR/MOC.cfg"
    moc.write_text(MOC.replace(' -base_frame_coordinated "TRACK"', ""))
    assert [one.place for one in told(backup, SAME)] == ["b.yaml:2"]
    moc.write_text(MOC)
    still = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"
    still += "base: {position: [1.5, 0, 0.25], rpy: '[0, 0, 90] deg'}\n"
    still += "limits: {joint_1: {lower: -2.5, upper: 1.5, source: test}}\n"
    assert [one.place for one in told(backup, still)] == ["b.yaml:1"]


def test_a_positioner_that_differs_is_told(backup: Path) -> None:
    table = "positioners:\n  STN1: {eax: d, range: [-4, 3], velocity: 1, acceleration: 1, source: test, frame: {"
    table += "position: [2, 0, 0]}}\n"
    assert [one.place for one in told(backup, SAME + table)] == ["b.yaml:10"] * 2
    same = table.replace("eax: d", "eax: c").replace("-4", "-3")
    assert told(backup, SAME + same) == []
    moc, stand = backup / "SYSPAR/MOC.cfg", line("-base_frame_pos_x 2")
    for old, new in (("[2, 0, 0]", "[2, 0.1, 0]"), ("[2, 0, 0]", "[2, 0, 0], rpy: [0, 0, 0.1]")):
        (found,) = told(backup, SAME + same.replace(old, new))
        assert (found.place, f"MOC.cfg:{stand}" in found.text) == ("b.yaml:10", True)
    moc.write_text(MOC.replace("-base_frame_pos_x 2", '-base_frame_pos_x 3 -base_frame_coordinated "TRACK"'))
    assert told(backup, SAME + same) == []  # the table rides on something else, so its frame is not the world's
    moc.write_bytes(MOC.replace("STN1", "St\xf6r1").encode("cp1252"))
    assert [one.place for one in told(backup, SAME + table.replace("STN1", "St\xf6r1"))] == ["b.yaml:10"] * 2


def test_the_cell_file_that_is_proposed_says_what_the_controller_says(
    backup: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (backup / "SYSPAR/EIO.cfg").write_text("EIO:CFG_1.0:6:0::\n")
    assert run(["new", "b", "--from", "b"]) == 0
    assert "EIO.cfg" in capsys.readouterr().err  # what is not read
    assert not Path("b.mod").exists()
    text = Path("b.yaml").read_text()
    assert f"MOC.cfg:{TRACK}" in text
    cell = load_cell("b.yaml")
    assert cell.robot == "irb140_rail"
    assert cell.rail is not None
    assert (cell.rail.eax, cell.rail.stroke) == (1, (-0.001, 3.901))
    assert np.allclose(cell.rail.X_WR, FRAME, atol=1e-6)
    assert {(one.axis, one.kind): one.value for one in cell.overrides} == {
        ("joint_1", "lower"): -2.5,
        ("joint_1", "upper"): 1.5,
        ("rail", "velocity"): 1.2,
        ("rail", "acceleration"): 2.25,
    }
    assert [one.kind for one in told(backup, text)] == [WarningKind.NOT_READ]
    assert run(["parse", "b", "--quiet"]) == 0
    assert run(["new", "b", "--from", "b"]) == 2  # nothing is overwritten
    filled = "positioners:\n" + "\n".join(one[2:] for one in text.split("# positioners:")[1].splitlines()[1:])
    filled = filled.replace("velocity: ?", "velocity: 1").replace("acceleration: ?", "acceleration: 1")
    (axis,) = parse_cell(text + filled, "b.yaml").scenario.positioners["stn1"]
    assert (axis.eax, axis.p, axis.range) == (2, (2, 0, 0), (-3, 3))


def test_a_rail_that_runs_elsewhere_than_the_robots_has_its_direction(backup: Path) -> None:
    moc = backup / "SYSPAR/MOC.cfg"
    moc.write_text(MOC.replace("-base_frame_orient_u0 0\\", "-base_frame_orient_u0 1\\").replace("_u3 1\n", "_u3 0\n"))
    assert run(["new", "b", "--from", "b/RAPID/TASK1"]) == 0
    cell = load_cell("b.yaml")
    assert cell.rail is not None
    plant = build_plant(cell)
    np.testing.assert_allclose(plant.robot.base(0.0), FRAME, atol=1e-6)
    np.testing.assert_allclose(plant.robot.rail_axes_W, [[1, 0, 0]], atol=1e-6)
    assert not told(backup, Path("b.yaml").read_text())


def test_what_the_controller_does_not_say_of_its_track_is_asked_for(backup: Path) -> None:
    (backup / "SYSPAR/MOC.cfg").write_text(MOC.replace('-name "track1"', '-name "other"'))
    assert run(["new", "b", "--from", "b"]) == 0
    with pytest.raises(InputError, match=r"(?s)b.yaml:6: .*eax.*b.yaml:6: .*stroke"):
        load_cell("b.yaml")


def test_without_a_track_the_base_stands_where_the_controller_says(backup: Path) -> None:
    (backup / "SYSPAR/MOC.cfg").write_text(
        'ROBOT:\n-name "ROB_1" -use_robot_type "ROB1_4600_2.55_40" -base_frame_pos_z -0.5\n'
        'ARM:\n-name "rob1_5" -lower_joint_bound -1 -upper_joint_bound 0.25\n'
    )
    assert run(["new", "b", "--from", "b"]) == 0
    cell = load_cell("b.yaml")
    assert (cell.robot, cell.rail) == ("irb4600_40_255", None)
    assert cell.X_WB[:3, 3] == pytest.approx([0, 0, -0.5])
    assert cell.start_joints[4] == pytest.approx(0.25, abs=1e-6)


@pytest.mark.parametrize(
    ("place", "text", "options"),
    [
        ("SYSPAR/MOC.cfg", "nothing", []),
        ("SYSPAR/MOC.cfg", 'ROBOT:\n-name "ROB_L" -use_robot_type "ROB_L_14000"\n', []),
        ("SYSPAR/MOC.cfg", MOC, ["--robot", "iiwa7"]),
        ("SYSPAR/MOC.cfg", MOC, ["--rail"]),
        ("SYSPAR/SIO.cfg", "", ["--from", "c"]),
        ("SYSPAR/SIO.cfg", "", ["--from", "b/RAPID/TASK1/PROGMOD/none.mod"]),
    ],
)
def test_a_backup_without_what_is_needed_is_refused(backup: Path, place: str, text: str, options: list[str]) -> None:
    (backup / place).write_text(text)
    assert run(["new", "b", "--from", "b", *options]) == 2
    assert not Path("b.yaml").exists()


def test_a_backup_without_a_cell_file_says_how_to_make_one(backup: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["parse", "b"]) == 0
    assert "trajopt new b.yaml --from b'" in capsys.readouterr().out
    assert run(["optimize", "b"]) == 2
    assert "trajopt new b.yaml --from b'" in capsys.readouterr().err
    with pytest.raises(InputError):
        load_cell("b.yaml")
