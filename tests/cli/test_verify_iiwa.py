"""`trajopt verify` on what `trajopt iiwa` writes, and on joints of an arm that anybody wrote."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.trajectory import Trajectory

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses:
  - {name: start, at: start}
  - {name: side, by: [0, 0.1, 0, 0, 0, 20 deg]}
  - {name: up, by: [0.02, 0, 0.051, 0, 0, 0]}
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
PROGRAM = """MODULE m
CONST robtarget p:=[[500,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget q:=[[500,100,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
PROC main()
MoveL p,v100,fine,tool0;
MoveL q,v100,fine,tool0;
ENDPROC
ENDMODULE
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A task and its folder with joints."""
    place = tmp_path_factory.mktemp("made")
    (place / "task.yaml").write_text(TASK)
    assert run(["iiwa", "segments", str(place / "task.yaml"), "--output", str(place / "results")]) == 0
    assert run(["iiwa", "joints", str(place / "results")]) == 0
    return place


def test_a_folder_is_judged_against_the_task_in_it(made: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["verify", str(made / "results")]) == 0
    printed = capsys.readouterr().out
    assert "equilibrium.csv: legal" in printed
    assert "joints.csv: legal" in printed
    assert "not checked" not in printed
    assert run(["verify", "--all", str(made / "results")]) == 0
    everything = capsys.readouterr().out
    assert everything.count("joint acceleration") == 7
    assert printed.count("joint acceleration") == 1


def test_a_spoiled_sequence_ends_with_exit_code_1(
    made: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(made / "results", tmp_path / "spoiled")
    path = tmp_path / "spoiled" / "equilibrium_quaternion.csv"
    lines = path.read_text().splitlines()
    cells = lines[200].split(",")
    lines[200] = ",".join([*cells[:3], repr(float(cells[3]) + 1e-4), *cells[4:]])
    path.write_text("\n".join(lines) + "\n")
    assert run(["verify", str(tmp_path / "spoiled")]) == 1
    printed = capsys.readouterr().out.replace("\n", " ")
    assert "equilibrium_quaternion.csv: ILLEGAL" in printed
    assert "start -> side is off the straight path by" in printed


def test_joints_of_a_file_are_judged_against_a_task_or_a_robot(
    made: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows, _ = read_csv_text((made / "results" / "joints.csv").read_text(), "joints.csv")
    file = tmp_path / "mine.csv"
    file.write_text(write_csv_text(rows))
    assert run(["verify", str(file), "--task", str(made / "task.yaml")]) == 0
    assert "pose reached" in capsys.readouterr().out
    assert run(["verify", str(file), "--robot", "iiwa7"]) == 0
    assert "not checked: no task is given" in capsys.readouterr().out
    assert rows.qd is not None
    quick = Trajectory(rows.names, rows.t / 20, rows.q, rows.qd * 20)
    file.write_text(write_csv_text(quick))
    assert run(["verify", str(file), "--robot", "iiwa7"]) == 1
    assert "joint_1 acceleration" in capsys.readouterr().out
    assert run(["verify", str(file), "--task", str(made / "task.yaml")]) == 1
    assert "start -> side v_max" in capsys.readouterr().out.replace("\n", " ")
    aside = rows.q + np.where(
        np.arange(7) == 0, 1e-4 * np.sin(np.pi * np.minimum(rows.t[:, None] / 0.6, 1.0)) ** 2, 0.0
    )
    file.write_text(write_csv_text(Trajectory(rows.names, rows.t, aside)))
    assert run(["verify", str(file), "--task", str(made / "task.yaml")]) == 1
    assert "start -> side is off the straight path by" in capsys.readouterr().out.replace("\n", " ")


def test_coarse_digits_and_rows_beside_the_period_are_doubted_not_condemned(made: Path, tmp_path: Path) -> None:
    rows, _ = read_csv_text((made / "results" / "joints.csv").read_text(), "joints.csv")
    file, task = tmp_path / "mine.csv", str(made / "task.yaml")
    head = ",".join(["t [s]", *(f"{name} [deg]" for name in rows.names)])
    table = np.column_stack([rows.t, np.degrees(rows.q)])
    file.write_text("\n".join([head, *(",".join(f"{v:.6f}" for v in row) for row in table)]) + "\n")
    assert run(["verify", str(file), "--task", task]) == 0
    every = np.unique(np.r_[0 : len(rows.t) : 3, len(rows.t) - 1])
    file.write_text(write_csv_text(Trajectory(rows.names, rows.t[every], rows.q[every])))
    assert run(["verify", str(file), "--task", task]) == 0


def test_what_a_rapid_program_says_is_not_checked_and_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "m.mod").write_text(PROGRAM)
    (tmp_path / "m.yaml").write_text("".join(line for line in TASK.splitlines(True) if line[0] in "sKDM"))
    assert run(["iiwa", "segments", str(tmp_path / "m.mod"), "--output", str(tmp_path / "results")]) == 0
    assert run(["iiwa", "joints", str(tmp_path / "results")]) == 1  # at once at full speed: accelerations
    capsys.readouterr()
    assert run(["verify", str(tmp_path / "results")]) == 1
    printed = capsys.readouterr().out
    assert "equilibrium_quaternion.csv: legal" in printed
    assert "path and speeds, because they come from a RAPID program" in printed


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["FOLDER", "--task", "TASK"], "a results folder holds its own task and robot"),
        (["FOLDER", "--robot", "iiwa7"], "a results folder holds its own task and robot"),
        (["FILE"], "say which --program it executes; of an iiwa --task or --robot"),
        (["FILE", "--task", "TASK", "--robot", "iiwa7"], "give one of --program, --task and --robot"),
        (["FILE", "--task", "TASK", "--program", "x.mod"], "give one of --program, --task and --robot"),
        (["FILE", "--robot", "irb140"], "the file's axes are joint_1, joint_2"),
        (["FILE", "--robot", "iiwa8"], "unknown robot 'iiwa8'"),
        (["FILE", "--task", "nowhere.yaml"], "nowhere.yaml: cannot read the task file"),
        (["TASK", "--robot", "iiwa7"], "is a task file of the iiwa, not a CSV file"),
    ],
)
def test_mistakes_are_one_line(arguments: list[str], said: str, made: Path, capsys: pytest.CaptureFixture[str]) -> None:
    places = {"FOLDER": made / "results", "FILE": made / "results" / "joints.csv", "TASK": made / "task.yaml"}
    assert run(["verify", *(str(places.get(one, one)) for one in arguments)]) == 2
    error = capsys.readouterr().err.strip()
    assert said in error
    assert len(error.splitlines()) == 1
