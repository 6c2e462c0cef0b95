"""Programs, their fixed-rail plans (solved once per run) and the judge's word, for the tests of rows that time them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from unrefined import IMPROVED, as_it_comes

from trajopt_cli.findings import Finding
from trajopt_cli.job import read_job
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import FIXED_RAIL, Freedom
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.robot.model import load_robot
from trajopt_cli.scenario import Scenario, Settling
from trajopt_cli.study.case import Answer, Attempt, Case

PROGRAMS = Path(__file__).parents[2] / "programs"
HOME = np.array([0, 0, 0, 0, np.pi / 6, 0])
DATA = """CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST jointtarget j_ext:=[[0,0,0,0,30,0],[250,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_in:=[[500,300,450],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_low:=[[500,340,390],[0,0.1736482,0.9848078,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_far:=[[100,300,450],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]];
PERS tooldata tGrip:=[TRUE,[[20,0,80],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];"""

# A tool, a signal, a wait for a condition, programmed times on a joint move and a line, the rail alone.
EVERYTHING_ONCE = """MoveJ p_in, v2500, fine, tGrip;
MoveL p_low, v200, fine, tGrip;
Set do_grip;
WaitDI di_part, 1;
MoveL p_in, v200\\T:=0.6, fine, tGrip;
MoveAbsJ j_home\\T:=1.4, vmax, fine, tGrip;
MoveExtJ j_ext, v500, fine;
MoveJ p_in, vmax, fine, tGrip;"""


def rapid(body: str, settle: float = 0.0) -> Program:
    lines = ["MODULE T", DATA.replace("\n", " "), "PROC main()", body, "ENDPROC", "ENDMODULE"]
    scenario = Scenario(signals={"di_part": 1}, waits={"di_part": 0.12}, settle=Settling(settle))
    return run_program([TextFile("t.mod", "\n".join(lines), "utf-8")], scenario)


def plant_with_rail(**more: object) -> Plant:
    robot = load_robot("irb140_rail")
    base = robot.profile()
    limits = replace(
        base, lower=np.r_[-0.2, base.lower[1:]], upper=np.r_[0.9, base.upper[1:]],
        velocity=np.r_[1.0, base.velocity[1:]], acceleration=np.r_[3.0, base.acceleration[1:]],
    )  # fmt: skip
    plant = Plant(robot, limits, TcpCaps(2.5, 20.0), np.r_[0.0, HOME], (0,), False, False, frozenset())
    return replace(plant, **more)  # type: ignore[arg-type]


def solver(plant: Plant, refined: bool = True) -> Callable[[Program, Target, Freedom], Plan | Infeasible]:
    known: dict[tuple[int, Target, Freedom], Plan | Infeasible] = {}

    def solve(program: Program, target: Target, freedom: Freedom) -> Plan | Infeasible:
        key = id(program), target, freedom
        if key not in known:
            with pytest.MonkeyPatch.context() as patch:
                if not refined:
                    patch.setattr(IMPROVED, as_it_comes)
                known[key] = optimize(program, plant, target, freedom, bounded=False)
        return known[key]

    return solve


@cache
def case_of(name: str, refined: bool = True) -> Case:
    """hinge_cell and bench_irb140 as shipped, or everything_once. Plans are the first legal ones where they are not
    refined, as all but hinge_cell's always are."""
    if name == "everything_once":
        program, plant = rapid(EVERYTHING_ONCE), plant_with_rail()
    else:
        job = read_job(PROGRAMS / f"{name}.mod")
        program, plant = job.program, job.plant
    return Case(program, plant, solver(plant, refined and name == "hinge_cell"))


def fixed_rail_plan(case: Case) -> Plan:
    plan = case.solve(case.program, Target.STREAM, FIXED_RAIL)
    assert isinstance(plan, Plan), plan
    return plan


def attempt(answer: Answer) -> Attempt:
    assert isinstance(answer, Attempt), answer
    return answer


def broken(case: Case, made: Attempt) -> list[Finding]:
    """What the judge holds against a motion, as a stream."""
    report = verify(made.program, case.plant, made.trajectory, None, made.dropped, Target.STREAM, advice=False)
    return [finding for finding in report.findings if not finding.passed]
