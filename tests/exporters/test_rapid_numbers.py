"""What is written is rounded, and rapid.csv is still what the controller makes of it."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from small_cells import plant_with_rail, rapid

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.exporters.rapid_check import read_again
from trajopt_cli.exporters.rapid_targets import _pose
from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.scenario import Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
TURNED = "CONST robtarget p_t:=[[500,600,450],[0,0.3826834,0.9238795,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];"
# A wait after joints, targets that are computed and turned, and a wait at one of them.
COMPUTED = """
    MoveAbsJ j_home,v1000,fine,tool0;
    WaitTime 0.2;
    MoveJ Offs(p_t,33.3333,0,0),v1000,fine,tool0;
    MoveL RelTool(p_t,0,0,60\\Rz:=7),v500,fine,tool0;
    WaitTime 0.3;
    MoveJ p_in,v1000,fine,tool0;
"""


def judged_as_written(program: Program, plant: Plant) -> str:
    """The text of a plan, judged: its rows against the program that the text is, the rail where the text says."""
    plan = optimize(program, plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    export = export_rapid(program, plan, plant)
    trajectory, resolution = read_csv_text(write_csv_text(plan.trajectory), "rapid.csv")
    fixed = replace(plant, rail_fixed=True)
    read = read_again(program, plant, Scenario(), export.texts)
    report = verify(read, fixed, trajectory, resolution, target=Target.RAPID, advice=False)
    assert [finding.message for finding in report.findings if not finding.passed] == []
    rail = [finding for finding in report.findings if finding.check == "rail target"]
    assert len(rail) > 3
    assert max(abs(f.value - f.limit) for f in rail) <= 5.7e-7  # half of 0.001 mm, and a num's 24 bits
    return "".join(export.texts.values())


def test_the_hinge_cells_rows_are_its_texts() -> None:
    cell = load_cell(PROGRAMS / "hinge_cell.yaml")
    text = judged_as_written(read_program(PROGRAMS / "hinge_cell.mod", cell.scenario), build_plant(cell))
    given = (PROGRAMS / "hinge_cell.mod").read_text()
    new = set(re.findall(r"[\d.]+(?=[],])", text)) - set(re.findall(r"[\d.]+(?=[],])", given))
    assert len(new) > 9
    assert max(len(number.partition(".")[2]) for number in new) == 3


def test_rows_of_computed_targets_are_their_texts() -> None:
    text = judged_as_written(rapid(COMPUTED, data=TURNED), plant_with_rail())
    assert "RailAt(Offs(p_t,33.3333,0,0)," in text


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(-1, 1), min_size=4, max_size=4).filter(lambda q: np.linalg.norm(q) > 0.1))
def test_an_orientation_is_written_as_fine_as_it_must_be(wxyz: list[float]) -> None:
    turn = Rotation.from_quat(wxyz, scalar_first=True)
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = turn.as_matrix(), [0.1234567, -1.0, 0.0]
    position, rotation = _pose(X)[1:-1].split("],[")
    assert position == "123.457,-1000,0"
    said = np.array([float(number) for number in rotation.split(",")])
    assert (Rotation.from_quat(said, scalar_first=True) * turn.inv()).magnitude() <= 6e-7
    assert np.linalg.norm(said) == pytest.approx(1, abs=1.1e-6)
    assert max(len(number.partition(".")[2]) for number in rotation.split(",")) <= 7


@pytest.mark.parametrize(
    ("degrees", "text"),
    [(0, "1,0,0,0"), (90, "0.707107,0,0,0.707107"), (60, "0.866025,0,0,0.5"), (45, "0.9238795,0,0,0.3826834")],
)
def test_six_decimals_where_they_do(degrees: float, text: str) -> None:
    """45 degrees with six would be 1.1 urad off, more than the judge lets pass."""
    X = np.eye(4)
    X[:3, :3] = Rotation.from_euler("z", degrees, degrees=True).as_matrix()
    assert _pose(X) == f"[0,0,0],[{text}]"
