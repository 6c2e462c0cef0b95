"""`trajopt_cli.exporters`: a plan as files by name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rail_plans import plan_for

from trajopt_cli import Target, build_plant, export, load_cell
from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.trajectory import Trajectory

TEXT = """MODULE m ! Türband
    CONST robtarget p1:=[[500,200,450],[0,0,1,0],[-1,0,-1,0],[200,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveJ p1,v100,fine,tool0;
    ENDPROC
ENDMODULE
""".replace("\n", "\r\n")


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(Path(__file__).parents[2] / "programs" / "hinge_cell.yaml"))


def test_joint_rows_are_the_motion_at_the_rate_asked_for() -> None:
    t = np.array([0.0, 0.3, 1.0])
    q, qd = np.stack([t**2, 1 - t**2], axis=1), np.stack([2 * t, -2 * t], axis=1)  # a cubic has these exactly
    plan = Plan(Target.STREAM, Trajectory(("joint_1", "joint_2"), t, q, qd), (), None, "test")
    files = export(plan, rate=8)
    assert list(files) == ["joints.csv"]
    found, _ = read_csv_text(files["joints.csv"].decode("ascii"), "joints.csv")
    np.testing.assert_allclose(found.t, np.arange(9) / 8, atol=1e-9)
    np.testing.assert_allclose(found.q, np.stack([found.t**2, 1 - found.t**2], axis=1), atol=1e-8)


def test_modules_come_back_by_path_in_their_own_bytes(plant: Plant, tmp_path: Path) -> None:
    path = tmp_path / "m.mod"
    path.write_bytes(TEXT.encode("cp1252"))
    program = read_program(path)
    files = export(plan_for(program, plant, {0: 0.25}), "rapid", program=program, plant=plant)
    wanted = TEXT.replace("[200,9E9", "[250,9E9").encode("cp1252")
    assert files == {str(path): wanted}


def test_a_request_without_an_answer_says_what_is_missing(plant: Plant, tmp_path: Path) -> None:
    path = tmp_path / "m.mod"
    path.write_bytes(TEXT.encode("cp1252"))
    program = read_program(path)
    plan = plan_for(program, plant, {0: 0.25})
    with pytest.raises(ValueError, match=r"^the RAPID export needs program and plant"):
        export(plan, "rapid", program=program)
    with pytest.raises(ValueError, match=r"^no export is called 'csv': joint or rapid$"):
        export(plan, "csv")  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"^rate 0 Hz lies outside"):
        export(plan, rate=0)
