"""Row `sampled turn`: legal, made of whole samples, and no faster than what is optimised from there."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from small_cells import plant_without_rail, rapid

from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.motion import FreeTurn, Program
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.scenario import FreeTool, Scenario
from trajopt_cli.study.case import Attempt, Case, NotApplicable
from trajopt_cli.study.toppra_row import sampled_turn, toppra
from trajopt_cli.warnings import Source

REST = "[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]"
DATA = f"""PERS tooldata tHead:=[TRUE,[[110,0,60],[0.7071068,0,0.7071068,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
CONST robtarget p_a:=[[500,-200,350],[0,0,1,0],{REST}];
CONST robtarget p_c:=[[500,200,350],[0,0.5,0.8660254,0],{REST}];"""
BODY = """MoveJ p_a,v1000,fine,tHead;\nMoveL RelTool(p_a,0,0,-40),v200,fine,tHead;\nMoveJ p_c,v1000,fine,tHead;
MoveAbsJ j_home\\NoEOffs,v1000,fine,tHead;"""


def case_of(free: bool) -> Case:
    """p_a and p_c: 60 degrees apart about the tool's axis as taught."""
    sector = FreeTool(FreeTurn((0.0, 0.0, 1.0), -np.pi, np.pi), Source("cell.yaml", 3, 1))
    plant, program = plant_without_rail(), rapid(BODY, Scenario(free=(sector,) if free else ()), DATA)

    def solve(program: Program, target: Target, freedom: Freedom) -> Plan | Infeasible:
        return optimize(program, plant, target, freedom, bounded=False)

    return Case(program, plant, solve)


@pytest.mark.long
def test_sampled_turns_are_legal_and_between_taught_and_best() -> None:
    case = case_of(True)
    answer, taught = sampled_turn(case), toppra(case)
    assert isinstance(answer, Attempt)
    assert isinstance(taught, Attempt)
    best = case.solve(case.program, Target.STREAM, EVERYTHING)
    assert isinstance(best, Plan)
    assert best.duration <= answer.trajectory.duration < taught.trajectory.duration
    said = partial(judge, case.plant, case.program, write_csv_text(answer.trajectory), "t.csv", None, Target.STREAM)
    assert said(advice=False).legal
    assert answer.program is case.program


def test_nothing_to_sample() -> None:
    case = case_of(False)
    answer, taught = sampled_turn(case), toppra(case)
    assert isinstance(taught, Attempt)
    assert isinstance(answer, NotApplicable) or answer.trajectory.duration == taught.trajectory.duration  # type: ignore[union-attr]
