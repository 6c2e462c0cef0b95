"""Paths as CSV: what they mean in SI, and one line with the row for every mistake."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import load_task
from trajopt_cli.iiwa.task.model import AngleMeaning, Passing, Profile
from trajopt_cli.iiwa.task.path_csv import read_path, read_text

R_START = Rotation.from_euler("xyz", [3.0, 0.1, -0.2]).as_matrix()
HEAD = "x [mm],y [mm],z [mm],alpha [deg],beta [deg],gamma [deg]"
ROWS = ["500,0,300,0,0,0", "500,1,300,0,2,0", "500,2,300,0,3,0"]


def read(*lines: str, meaning: AngleMeaning = AngleMeaning.RELATIVE) -> np.ndarray:
    return read_path("\n".join(lines) + "\n", "p.csv", meaning, R_START).poses


def test_units_order_and_separators_mean_the_same() -> None:
    wanted = read(HEAD, *ROWS)
    assert wanted[1] == pytest.approx([0.5, 0.001, 0.3, 0, np.radians(2), 0], abs=1e-15)
    other = "z [m]; y [cm];x [m];gamma [rad]; beta [°];alpha [rad]"
    rows = ["0.3;0;0.5;0;0;0", "0.3; 0.1 ;.5;0;2;0", "3e-1;0.2;+0.5;0;3;0"]
    assert read(other, *rows) == pytest.approx(wanted, abs=1e-15)
    assert np.array_equal(read(HEAD.replace(",", "\t"), *[row.replace(",", "\t") for row in ROWS]), wanted)


def test_byte_order_mark_and_line_ends_of_others(tmp_path: Path) -> None:
    file = tmp_path / "p.csv"
    file.write_bytes(b"\xef\xbb\xbf" + "\r\n".join([HEAD, *ROWS, "", ""]).encode())
    found = read_path(read_text(str(file)), str(file), AngleMeaning.RELATIVE, R_START)
    assert np.array_equal(found.poses, read(HEAD, *ROWS))
    assert found[2].place == f"{file}:4"


def test_quaternions_are_the_tool_in_the_world() -> None:
    turns = Rotation.from_euler("xyz", [[0.1, 0.2, 0.3], [0.2, 0.2, 0.3]])
    rows = [
        ",".join([f"{x}", "0", "0", *(f"{value:.6f}" for value in q)])
        for x, q in enumerate(turns.as_quat(scalar_first=True))
    ]
    head = "x [cm],y [cm],z [cm],qw,qx,qy [1],qz"
    absolute = read(head, *rows, meaning=AngleMeaning.ABSOLUTE)
    assert absolute[:, 3:] == pytest.approx(turns.as_euler("xyz"), abs=2e-6)
    relative = read(head, *rows)
    assert (Rotation.from_euler("xyz", relative[:, 3:]) * Rotation.from_matrix(R_START)).as_matrix() == pytest.approx(
        turns.as_matrix(), abs=2e-6
    )


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["", *ROWS], "p.csv:1: the first line must be a header, for example 'x [mm]"),
        (
            [HEAD.replace("[mm]", "", 1), *ROWS],
            "p.csv:1: column 'x' has no unit; write 'x [m]' or 'x [cm]' or 'x [mm]'",
        ),
        ([HEAD.replace("[deg]", "[mm]"), *ROWS], "p.csv:1: column 'alpha' has the unit 'mm'; write 'alpha [deg]' or"),
        ([HEAD.replace("beta", "speed"), *ROWS], "p.csv:1: the column is 'speed [deg]'; wanted are x, y, z, alpha"),
        ([HEAD.replace("beta", "alpha"), *ROWS], "p.csv:1: column 'alpha' stands twice"),
        ([HEAD.replace(",beta [deg]", ""), *ROWS], "p.csv:1: the header lacks beta; write it for example"),
        (["x [m],y [m],z [m]", "0,0,0", "0,0,1"], "p.csv:1: the header needs either angles or a quaternion"),
        ([*ROWS, *ROWS], "p.csv:1: the column is '500'"),
        ([HEAD, ROWS[0]], "p.csv:2: 1 rows under the header; a path needs at least 2"),
        ([HEAD, ROWS[0], "500,1,300,0,0", ROWS[2]], "p.csv:3: 5 values, the header has 6 columns"),
        ([HEAD, ROWS[0], "", ROWS[2]], "p.csv:3: no values, the header has 6 columns"),
        ([HEAD, *ROWS[:2], "500,nan,300,0,0,0"], "p.csv:4:5: 'nan' is not a finite number"),
        ([HEAD, ROWS[0], "500,1,300,0,inf,0"], "p.csv:3:13: 'inf' is not a finite number"),
        ([HEAD, ROWS[0], "500,one,300,0,0,0"], "p.csv:3:5: 'one' is not a finite number"),
        (
            [HEAD.replace(",", ";"), "500;0;0;0;0;0", "500;1,5;0;0;0;0"],
            "p.csv:3:5: '1,5' is not a finite number; write numbers with a decimal point",
        ),
        ([HEAD, *ROWS, ROWS[2], ROWS[2]], "p.csv:5: row 4: repeats the row before, as do 1 more rows; take"),
        ([HEAD, *ROWS, "2e6,0,0,0,0,0"], "p.csv:5: row 4: 2000 m from the origin, at most 1000 m; check the unit"),
        ([HEAD, *ROWS, "9e5,0,0,0,0,0"], "p.csv:5: row 4: 899.5 m from the row before, at most 10 m; check the row"),
        ([HEAD, *ROWS, "500,3,300,0,0,1e6"], "p.csv:5: row 4: an angle of 17453.3 rad, at most 1000 rad"),
        (
            ["x [m],y [m],z [m],qw,qx,qy,qz", "0,0,0,1,0,0,0", "0,0,0.1,1,0.1,0,0"],
            "p.csv:3: row 2: the quaternion's norm is 1.00499; it must be 1 within 0.0001",
        ),
    ],
)
def test_every_mistake_is_one_line_with_its_row(lines: list[str], message: str) -> None:
    with pytest.raises(InputError) as caught:
        read(*lines)
    assert str(caught.value).startswith(message)


TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
poses: p.csv
approach: none
v_max: 0.2
omega_max: 30 deg/s
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""


def test_a_task_file_names_a_path_and_passes_it(tmp_path: Path) -> None:
    (tmp_path / "p.csv").write_text("\n".join([HEAD, *ROWS]))
    file = tmp_path / "t.yaml"
    file.write_text(TASK)
    task = load_task(file)
    assert list(task.sources) == [str(file), str(tmp_path / "p.csv")]
    assert np.array_equal(task.route.poses, read(HEAD, *ROWS))
    assert task.route.passing == Passing(1e-4, np.radians(0.5))
    assert task.route.profile is Profile.S_CURVE
    file.write_text(
        TASK + "passing: {tolerance: 1 mm}\nprofile: trapezoid\nv_max: [0.1, 0.2]\n".replace("v_max", "jerk")
    )
    task = load_task(file)
    assert task.route.passing == Passing(1e-3, np.radians(0.5))
    assert task.route.profile is Profile.TRAPEZOID
    assert task.route.caps[:, 4].tolist() == [0.1, 0.2]
    file.write_text(TASK + "passing: stop\n")
    task = load_task(file)
    assert (task.route.passing, task.route.profile, task.route.stops) == (None, Profile.THESIS, [0, 1, 2])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (TASK.replace("p.csv", "q.csv"), ":2: poses: there is no file "),
        (TASK.replace("p.csv", "p.txt"), ":2: poses: "),
        (TASK + "passing: slow\n", ":9: passing: needs 'stop' or a section with tolerance and turn_tolerance, not"),
        (TASK + "passing: {tolerance: 0.1 um}\n", ":9: passing.tolerance: unit 'um'"),
        (TASK + "passing: {tolerance: 1e-7}\n", ":9: passing: needs tolerances of at least 1e-06 m and rad"),
        (TASK + "program: x.mod\n", ":2: poses: give one of 'poses' and 'program'"),
    ],
)
def test_mistakes_of_a_task_with_a_path(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "p.csv").write_text("\n".join([HEAD, *ROWS]))
    file = tmp_path / "t.yaml"
    file.write_text(text)
    with pytest.raises(InputError) as caught:
        load_task(file)
    assert message in str(caught.value)
