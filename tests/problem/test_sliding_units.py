"""Positioners that slide: a lifting column under a work piece, read, planned, judged, exported.

Truth: closed forms; for derivatives, differences of the poses.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from unrefined import coarse_search

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.exporters.egm import stream_of
from trajopt_cli.exporters.joint import resample
from trajopt_cli.exporters.recorded import Recorded
from trajopt_cli.findings import CLEARANCE
from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveL, PoseMove, Program, TextFile
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.plan import optimize
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program

pytestmark = pytest.mark.usefixtures("coarse", "unrefined")

LIFT = "LIFT: {eax: c, frame: {position: [0.5, 0, 0.1]}, stroke: [0, 0.3], velocity: 0.2, acceleration: 1, source: t}"
TABLE = """LIFT:
    - {eax: c, frame: {position: [0.5, 0, 0.1]}, stroke: [0, 0.3], velocity: 0.2, acceleration: 1, source: t}
    - {eax: d, frame: {position: [0, 0, 0.05]}, range: "[-180, 180] deg", velocity: 2, acceleration: 5, source: t}"""
DATA = """PERS wobjdata w:=[FALSE,FALSE,"LIFT",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
CONST robtarget p_1:=[[-50,-100,250],[0,0,1,0],[0,0,0,0],[9E9,9E9,0,0,9E9,9E9]];
CONST robtarget p_2:=[[-50,100,250],[0,0,1,0],[0,0,0,0],[9E9,9E9,200,0,9E9,9E9]];
CONST robtarget p_3:=[[-50,100,250],[0,0,1,0],[0,0,0,0],[9E9,9E9,100,40,9E9,9E9]];
CONST robtarget p_4:=[[-50,100,250],[0,0,1,0],[0,0,0,0],[9E9,9E9,400,0,9E9,9E9]];
CONST robtarget q_1:=[[500,0,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,0,9E9,9E9,9E9]];
CONST robtarget q_2:=[[500,0,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,100,9E9,9E9,9E9]];
CONST robtarget q_3:=[[500,0,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,250,9E9,9E9,9E9]];
CONST speeddata vS:=[1000,500,50,100];
"""
ON_WORK = r"MoveJ p_1,v1000,fine,tool0\WObj:=w; MoveL p_2,v100,fine,tool0\WObj:=w; MoveL p_1,v1000,fine,tool0\WObj:=w;"


@pytest.fixture(autouse=True)
def _coarse_search(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)


def job(body: str, unit: str = LIFT, more: str = "") -> tuple[Plant, Program]:
    text = f'robot: irb140\nstart: {{joints: "[0, 0, 0, 0, 30, 0] deg"}}\npositioners:\n  {unit}\n{more}'
    cell = parse_cell(text, "c.yaml")
    lines = "MODULE T\n" + DATA + f"PROC main()\nConfJ \\Off; ConfL \\Off;\n{body}\nENDPROC\nENDMODULE"
    return build_plant(cell), run_program([TextFile("t.mod", lines, "utf-8")], cell.scenario)


def planned(plant: Plant, program: Program, target: Target = Target.RAPID) -> Plan | Infeasible:
    return optimize(program, plant, target, changes=everything(program, plant), bounded=False)


def test_targets_stand_as_high_as_the_column() -> None:
    _, program = job(ON_WORK)
    heights = [motion.X_WT[2, 3] for motion in program.motions if isinstance(motion, PoseMove)]
    np.testing.assert_allclose(heights, [0.35, 0.55, 0.35], atol=1e-9)
    (unit,) = program.motions[1].units
    assert (unit.start, unit.end, unit.column) == (0.0, pytest.approx(0.2), "eax_c_slide")
    assert unit.least == pytest.approx(0.2 / 0.2 + 0.2 / 1)  # trapezoid: way / v + v / a


def test_the_programmed_speed_of_linear_axes_holds_it_back() -> None:
    _, program = job(r"MoveJ p_1,v1000,fine,tool0\WObj:=w; MoveJ p_2,vS,fine,tool0\WObj:=w;")
    assert program.motions[1].units[0].least == pytest.approx(0.2 / 0.05 + 0.05 / 1)


@pytest.mark.parametrize("unit", [LIFT, TABLE])
def test_a_line_on_the_rising_work_and_its_derivatives(unit: str) -> None:
    """The line on the work plus the column's share of the way; and, with a table on the column, its turn."""
    _, program = job(ON_WORK if unit == LIFT else ON_WORK.replace("p_2", "p_3"), unit)
    move = program.motions[1]
    assert isinstance(move, MoveL)
    first = program.motions[0]
    assert isinstance(first, PoseMove)
    segment, s, h = segment_of(move, first.X_WT), np.linspace(0.05, 0.95, 7), 1e-5
    X = segment.pose(s)
    if unit == LIFT:
        wanted = np.column_stack([np.full(7, 0.45), -0.1 + 0.2 * s, 0.35 + 0.2 * s])
        np.testing.assert_allclose(X[:, :3, 3], wanted, atol=1e-9)
    else:
        np.testing.assert_allclose(X[:, 2, 3], 0.4 + 0.1 * s, atol=1e-9)
    after, before = segment.pose(s + h), segment.pose(s - h)
    np.testing.assert_allclose(segment.twist(s)[:, :3], (after - before)[:, :3, 3] / (2 * h), atol=1e-7)
    second = (after - 2 * X + before)[:, :3, 3] / h**2
    np.testing.assert_allclose(segment.twist_rate(s)[:, :3], second, atol=1e-4)


@pytest.mark.parametrize("target", [Target.RAPID, Target.STREAM])
@pytest.mark.parametrize("unit", [LIFT, TABLE])
def test_plans_are_legal_by_their_files_and_bounded_by_the_column(unit: str, target: Target) -> None:
    plant, program = job(ON_WORK if unit == LIFT else ON_WORK.replace("p_2", "p_3"), unit)
    plan = planned(plant, program, target)
    assert isinstance(plan, Plan)
    text = write_csv_text(resample(plan.trajectory, 500.0))
    assert "eax_c_slide [m]" in text.splitlines()[0]
    rows, resolution = read_csv_text(text, "a.csv")
    report = verify(program, plant, rows, resolution, target=target, advice=False)
    assert report.legal, [one.message for one in report.findings if not one.passed]
    assert plan.motions[1].t_1 - plan.motions[1].t_0 >= program.motions[1].units[0].least - 1e-9
    tables = rows.tables
    assert tables is not None
    j = tables.names.index("eax_c_slide")
    moved = np.array(tables.q)
    moved[:, j] += 0.002 * np.sin(np.pi * np.linspace(0, 1, len(moved))) ** 2
    spoiled = replace(rows, tables=replace(tables, q=moved))
    failed = [one for one in verify(program, plant, spoiled, resolution, target=target).findings if not one.passed]
    assert any("eax_c_slide" in one.subject or "eax_c_slide" in one.message for one in failed)


def test_a_column_lifts_a_plate_into_the_arm() -> None:
    """The plate's top is 200 mm high with the column down, the flange 350: 50 mm are left at 100, none at 250."""
    plate = "obstacles: {plate: {on: LIFT, box: {size: [0.1, 0.1, 0.02], position: [0, 0, 0.09]}}}\ntool_radius: 0\n"
    plant, low = job("MoveJ q_1,v1000,fine,tool0; MoveJ q_2,v1000,fine,tool0;", more=plate)
    plan = planned(plant, low)
    assert isinstance(plan, Plan)
    (found,) = (one for one in verify(low, plant, plan.trajectory).findings if one.check == CLEARANCE)
    assert 0.03 < found.value <= 0.0501
    _, high = job("MoveJ q_1,v1000,fine,tool0; MoveJ q_3,v1000,fine,tool0;", more=plate)
    answer = planned(plant, high)
    assert isinstance(answer, Infeasible)
    assert "plate" in answer.message
    plan = planned(replace(plant, obstacles=()), high)
    assert isinstance(plan, Plan)
    (found,) = (one for one in verify(high, plant, plan.trajectory).findings if one.check == CLEARANCE)
    assert found.value < -0.02


def test_egm_has_the_column_in_mm() -> None:
    plant, program = job(ON_WORK)
    plan = planned(plant, program, Target.STREAM)
    assert isinstance(plan, Plan)
    stream = stream_of(Recorded("a plan", plan.trajectory))
    assert stream.units[6:] == ("mm", "mm", "mm")
    assert stream.q[:, 8].max() == pytest.approx(200, abs=0.1)


def test_a_place_beyond_the_stroke_is_refused_by_line() -> None:
    with pytest.raises(InputError, match=r"stroke 0\.\.300 mm"):
        job(r"MoveJ p_4,v1000,fine,tool0\WObj:=w;")


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ("velocity: 0.2", "velocity: 20 deg/s", "velocity"),
        ("acceleration: 1", "acceleration: 1 rad/s2", "acceleration"),
        ("stroke: [0, 0.3],", "stroke: [0, 0.3], start: 10 deg,", "start"),
        ("stroke: [0, 0.3],", "", "stroke"),
        ("stroke: [0, 0.3],", 'stroke: [0, 0.3], range: "[0, 90] deg",', "stroke"),
        ("stroke: [0, 0.3]", "stroke: [0.3, 0]", "stroke"),
        ("stroke: [0, 0.3]", "stroke: [0, 300]", "stroke"),
        ("stroke: [0, 0.3],", "stroke: [0, 0.3], start: 400 mm,", "start"),
    ],
)
def test_what_fits_no_sliding_axis_is_refused(old: str, new: str, word: str) -> None:
    assert old in LIFT
    with pytest.raises(InputError) as error:
        job("", LIFT.replace(old, new))
    assert error.value.line == 4
    assert word in str(error.value)


def test_the_command_line_reads_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("t.yaml").write_text(f'robot: irb140\nstart: {{joints: "[0, 0, 0, 0, 30, 0] deg"}}\npositioners:\n  {LIFT}\n')
    Path("t.mod").write_text(
        "MODULE T\n" + DATA + f"PROC main()\nConfJ \\Off; ConfL \\Off;\n{ON_WORK}\nENDPROC\nENDMODULE"
    )
    assert run(["check", "t.mod"]) == 0
