"""RAPID plans with tools that are free about their axis, from files to a verdict and to text."""

from __future__ import annotations

from pathlib import Path

import pytest

from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline.planning import Clock, changes_of, solve
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.summary import Judged

REST = "[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
DATA = f"""PERS tooldata tHead:=[TRUE,[[110,0,60],[0.7071068,0,0.7071068,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_a:=[[500,-200,350],[0,0,1,0],{REST};
CONST robtarget p_c:=[[500,200,350],[0,0.5,0.8660254,0],{REST};"""
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\nsettle: 0\nfree: {axis: z}\n"
HOME = r"MoveAbsJ j_home\NoEOffs,v1000,fine,tHead;"


def job_of(folder: Path, *body: str) -> Job:
    (folder / "t.mod").write_text("\n".join(["MODULE T", DATA, "PROC main()", *body, HOME, "ENDPROC", "ENDMODULE", ""]))
    (folder / "t.yaml").write_text(CELL)
    return read_job(folder / "t.mod")


def rapid_plan(job: Job) -> Judged:
    changes = changes_of(job, Target.RAPID)
    found = solve(job, Target.RAPID, changes, lambda *_: None, Clock(), Patience(), RowsFile())
    assert isinstance(found, Judged), found
    return found


def test_arcs_corners_and_lines_that_tilt(tmp_path: Path) -> None:
    job = job_of(
        tmp_path,
        "MoveJ p_a,v1000,fine,tHead;",
        "MoveC Offs(p_a,60,60,0),Offs(p_a,0,120,0),v200,fine,tHead;",
        "MoveL Offs(p_a,0,160,0),v200,z10,tHead;",
        r"MoveL RelTool(Offs(p_a,0,160,0),0,0,-60\Ry:=8),v200,fine,tHead;",
    )
    found = rapid_plan(job)
    assert found.report.legal, found.report.worst.message
    assert found.plan.turns
    assert found.plan.turns[0] == pytest.approx(found.plan.turns[1])  # both ends of the arc
    (text,) = export_rapid(job.program, found.plan, job.plant).texts.values()
    assert text.count(r",0,0,0\Rz:=") == len(found.plan.turns)


def test_a_target_that_asks_where_the_robot_is_keeps_tools_as_taught(tmp_path: Path) -> None:
    job = job_of(
        tmp_path,
        "VAR robtarget p;",
        "MoveJ p_a,v1000,fine,tHead;",
        r"p:=CRobT(\Tool:=tHead);",
        "MoveL RelTool(p,0,0,-40),v200,fine,tHead;",
        "MoveJ p_c,v1000,fine,tHead;",
    )
    found = rapid_plan(job)
    assert found.report.legal
    assert found.plan.turns == {}
    assert any("as taught" in note and "t.mod:10" in note for note in found.plan.notes)
    (text,) = export_rapid(job.program, found.plan, job.plant).texts.values()
    assert "Rz" not in text
