"""Files of the iiwa job: numbers and places that the judge tells, what it grants, and what it says is unchecked."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from iiwa_folders import CONTROLLER, HOME, Table, list_files, make_folder, task_text
from told_cases import Cases, Told

from trajopt_cli.errors import InputError
from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.job.pages import simulation_page
from trajopt_cli.iiwa.job.simulation import simulate
from trajopt_cli.iiwa.judge.samples import read_table, unit
from trajopt_cli.iiwa.judge.tolerances import PERIOD, SIMULATED
from trajopt_cli.iiwa.judge.verify import Judged, verify_folder, verify_joints

SMALL = """
v_max: 0.2
omega_max: 1
a_max: 2
epsilon_max: 6
poses:
  - {at: start, dwell: 2 ms}
  - {by: [1e-5, 0, 0, 0, 0, 1e-5], dwell: 3 ms}
"""
ASIDE = np.array([0.36, -0.48, 0.8])
FOLDER: list[Path] = []
CASES = Cases()


@pytest.fixture(scope="module", autouse=True)
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of eleven rows, with joints and a simulation."""
    folder = make_folder(tmp_path_factory.mktemp("small") / "small", task_text(poses=SMALL))
    simulate(folder, simulation_page, settle=0.004)
    FOLDER[:] = [folder]
    return folder


@contextmanager
def edited(name: str, edit: Callable[[Array], Array | None]) -> Iterator[None]:
    """One table of the folder otherwise for a while."""
    path = FOLDER[0] / name
    before, table = path.read_bytes(), Table.read(path)
    changed = edit(table.rows)
    Table(table.heads, table.rows if changed is None else changed).write(path)
    try:
        yield
    finally:
        path.write_bytes(before)


def found(name: str, edit: Callable[[Array], Array | None]) -> list[Finding]:
    with edited(name, edit):
        return list(verify_folder(FOLDER[0]).reports[name].findings)


def rows_of(name: str) -> Array:
    return Table.read(FOLDER[0] / name).rows


@CASES.with_each(["equilibrium.csv", "equilibrium_quaternion.csv", "simulation.csv", "joints.csv"])
def a_row_beside_its_place_in_time(share: float, name: str) -> Told:
    def edit(rows: Array) -> None:
        rows[4, 0], rows[6, 0] = 4e-3 - share * PERIOD / 2, 6e-3 - share * PERIOD

    return Told(found(name, edit), "period", "row 6", share * PERIOD, PERIOD, 6e-3 - share * PERIOD)


@CASES.with_each([-1, 1])
def a_jump_of_an_angle(share: float, way: int) -> Told:
    def edit(rows: Array) -> None:
        rows[6:, 6] = rows[5, 6] + way * share * np.pi / 2

    return Told(found("equilibrium.csv", edit), "angle jump", "row 6", share * np.pi / 2, np.pi / 2, 6e-3)


def fed(row: int) -> Array:
    """What a simulation is fed in a row: the sequence, and its last pose held."""
    return rows_of("equilibrium.csv")[min(row, 10), 1:]


@CASES.with_each([7, 13])
def fed_another_position(share: float, row: int) -> Told:
    def edit(rows: Array) -> None:
        rows[row, 1:4] = fed(row)[:3] + share * SIMULATED * ASIDE

    said = found("simulation.csv", edit)
    return Told(said, "position fed", f"row {row}", share * SIMULATED, SIMULATED, row * 1e-3)


@pytest.mark.parametrize("name", CASES)
def test_what_is_granted_passes_and_no_more(name: str) -> None:
    CASES.check(name)


def test_angles_may_swing_near_their_lock_and_nowhere_else() -> None:
    """Where the cosine of beta is under 0.05 in either row two angles may swing for one small turn."""
    for cosine, other, passes in ((0.0499, 0.5, True), (0.5, 0.0499, True), (0.0501, 0.0501, False)):

        def edit(rows: Array, betas: tuple[float, float] = (cosine, other)) -> None:
            rows[5:7, 5], rows[6:, 6] = np.arccos(betas), rows[5, 6] + 2.0
            rows[7:, 5] = rows[6, 5]

        (jump,) = (one for one in found("equilibrium.csv", edit) if one.check == "angle jump")
        assert jump.passed == passes


def test_rows_are_counted_and_told() -> None:
    def last(rows: Array) -> Array:
        return rows[:-1]

    for name, subject, count in (("equilibrium.csv", "angles", 11), ("joints.csv", "joints", 11)):
        with edited(name, last):
            report = verify_folder(FOLDER[0]).reports[name]
        (rows,) = (one for one in report.findings if one.check == "rows")
        assert (rows.subject, rows.value, rows.limit, rows.passed) == (subject, 10, count, False)
        assert not {"tool position", "angles", "period"} & {one.check for one in report.findings}
    whole = {name: list(report.findings) for name, report in verify_folder(FOLDER[0]).reports.items()}
    assert all(one.passed for report in whole.values() for one in report)
    told = [(one.subject, one.value, one.limit) for report in whole.values() for one in report if one.check == "rows"]
    assert told == [("angles", 11, 11), ("sequence", 11, 11), ("joints", 11, 11)]


# ------------------------------------------------------------------------------------------ joints that anybody wrote


def failed(judged: Judged) -> set[str]:
    return {one.check for report in judged.reports.values() for one in report.findings if not one.passed}


def checks(judged: Judged) -> set[str]:
    return {one.check for report in judged.reports.values() for one in report.findings}


def test_joints_of_anybody_are_held_against_arm_and_task() -> None:
    joints, task = FOLDER[0] / "joints.csv", FOLDER[0].parent / "small.yaml"
    judged = verify_joints(joints, task)
    assert list(judged.reports) == ["joints.csv"]
    assert (failed(judged), judged.unchecked) == (set(), ())
    assert {"joint speed", "pose reached", "v_max", "dwell", "arm angle", "start joints"} <= checks(judged)
    assert not {"first pose", "last pose"} & checks(judged)  # nobody promised the last digit
    for robot in (None, "iiwa7"):
        alone = verify_joints(joints, None, robot)
        assert (failed(alone), alone.unchecked) == (set(), ("no task is given: the tool's way",))
        assert "pose reached" not in checks(alone)

    def shaken(rows: Array) -> None:
        rows[5, 7] += 1e-3

    with edited("joints.csv", shaken):
        assert {"joint acceleration"} <= failed(verify_joints(joints, None))
        assert {"joint acceleration", "orientation"} <= failed(verify_joints(joints, task))


def test_a_program_that_the_judge_does_not_read_is_said(tmp_path: Path) -> None:
    task = tmp_path / "task.yaml"
    task.write_text(f"{HOME}v_max: 0.2\nprogram: way.mod\n{CONTROLLER}")
    judged = verify_joints(FOLDER[0] / "joints.csv", task)
    assert len(judged.unchecked) == 2
    assert f"{task}:3: path and speeds, because they come from a RAPID program" in judged.unchecked[0]
    assert judged.unchecked[1].endswith("joints.csv: the tool's way, because the tool is the program's")
    assert "pose reached" not in checks(judged)


def test_a_task_of_unknown_keys_leaves_the_arm_to_be_judged(tmp_path: Path) -> None:
    task = tmp_path / "task.yaml"
    task.write_text((FOLDER[0].parent / "small.yaml").read_text() + "weaving: 5 mm\n")
    judged = verify_joints(FOLDER[0] / "joints.csv", task)
    assert len(judged.unchecked) == 1
    assert judged.unchecked[0].endswith("path and speeds, because the judge does not know the key 'weaving'")
    assert failed(judged) == set()
    assert {"joint speed", "arm angle", "start joints"} <= checks(judged)
    assert not {"pose reached", "poses missing"} & checks(judged)


def test_joints_of_another_robot_are_refused(tmp_path: Path) -> None:
    path, joints = tmp_path / "joints.csv", (FOLDER[0] / "joints.csv").read_text()
    path.write_text(joints.replace("joint_3", "elbow"))
    for task in (None, FOLDER[0].parent / "small.yaml"):
        with pytest.raises(
            InputError, match=r"the file's axes are joint_1, joint_2, elbow, .*; the robot's are joint_1,"
        ):
            verify_joints(path, task)
    own = FOLDER[0] / "joints.csv"
    before = own.read_bytes()
    own.write_bytes(path.read_bytes())
    with pytest.raises(InputError, match="the file's axes are joint_1, joint_2, elbow"):
        verify_folder(FOLDER[0])
    own.write_bytes(before)


def test_joints_that_no_arm_can_have_are_refused() -> None:
    def far(rows: Array) -> None:
        rows[3, 2] = 1e6

    with edited("joints.csv", far), pytest.raises(InputError, match=r"joints\.csv:5: joint_2 is 1e\+06 rad, its range"):
        verify_joints(FOLDER[0] / "joints.csv", None)


MODULE = """MODULE seam
  CONST robtarget a := [[500,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveJ a, v100, fine, tool0;
    MoveL Offs(a,0,0.02,0), v100, fine, tool0;
  ENDPROC
ENDMODULE
"""


def test_a_folder_of_a_program_is_judged_as_far_as_its_task_tells(tmp_path: Path) -> None:
    """The tool is the program's: its way, the angles that count from it and the tool's poses are said to be left."""
    (tmp_path / "seam.mod").write_text(MODULE)
    text = f"{HOME}approach: none\nprogram: seam.mod\n{CONTROLLER}"
    folder = make_folder(tmp_path / "seam", text)
    judged = verify_folder(folder)
    assert [line.split(": ", 1)[1] for line in judged.unchecked] == [
        "path and speeds, because they come from a RAPID program, which this judge does not read",
        "its angles, because they count from the program's tool",
        "the tool's poses, because the tool is the program's",
    ]
    assert failed(judged) <= {"joint acceleration"}  # a task of steps at full speed
    assert not {"pose reached", "angles", "tool position", "start joints"} & checks(judged)
    assert {"arm angle", "configuration", "period"} <= checks(judged)


def test_what_a_folder_lacks_is_told(tmp_path: Path) -> None:
    summary = FOLDER[0] / "summary.json"
    before = {name: (FOLDER[0] / name).read_bytes() for name in ("summary.json", "run.json")}
    content = json.loads(before["summary.json"])
    for section, message in (("sequence", "has no section 'sequence'"), ("joints", "has no section 'joints'")):
        summary.write_text(json.dumps({key: value for key, value in content.items() if key != section}))
        list_files(FOLDER[0], "summary.json")
        with pytest.raises(InputError, match=message):
            verify_folder(FOLDER[0])
    for name, text in before.items():
        (FOLDER[0] / name).write_bytes(text)


# ------------------------------------------------------------------------------------------------------------- tables


def test_a_table_is_read_or_refused_with_its_line() -> None:
    heads, good = "t [s],x [m],y [m]", "0,1,2\n0.5,3,4\n1,5,6\n"
    for end in ("", "\r\n"):
        table = read_table(f"{heads}\n{good}{end}", "file.csv", ("y [m]", "t [s]"))
        assert list(table) == ["t [s]", "x [m]", "y [m]"]
        np.testing.assert_array_equal(np.array(list(table.values())), [[0, 0.5, 1], [1, 3, 5], [2, 4, 6]])
    assert len(read_table(f"{heads}\n0,1,2\n1,1,1", "file.csv", ())["t [s]"]) == 2
    wrong = {
        f"{heads}\n0,1,2\n": (2, "1 rows; a sequence needs at least 2"),
        f"{heads},x [m]\n{good}": (1, "needs one column 'x [m]', has"),
        f"t [s],y [m]\n{good}": (1, "needs one column 'x [m]', has"),
        f"{heads}\n{good}2,here,2\n": (5, "holds what is no number"),
        f"{heads}\n0,1\n{good}": (2, "2 values, the header has 3 columns"),
        f"{heads}\n{good}2,nan,1\n": (5, "holds a number that is not finite"),
        f"{heads}\n{good}1,1,1\n": (5, "its time does not follow the one before"),
        f"{heads}\n0,1,1\n0,1,1\n{good}": (3, "its time does not follow the one before"),
    }
    for text, (line, message) in wrong.items():
        with pytest.raises(InputError) as caught:
            read_table(text, "file.csv", ("x [m]",))
        assert str(caught.value).startswith(f"file.csv:{line}: {message}"), text


def test_quaternions_are_of_norm_one_but_for_printed_digits() -> None:
    q = np.array([[0.5, -0.5, 0.5, 0.5], [0.6, 0, 0.8, 0], [0, 0, 0, 1]])
    for norm in (1 + 0.999e-6, 1 - 0.999e-6):
        np.testing.assert_allclose(unit(q * norm, "file.csv"), q, rtol=0, atol=1e-15)
    for norm in (1 + 1.001e-6, 1 - 1.001e-6, 1e300):
        with pytest.raises(InputError, match=r"^file.csv:3: the quaternion's norm is"):
            unit(q * [[1], [norm], [norm]], "file.csv")
