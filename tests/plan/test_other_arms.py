"""Small programs with arms that are not ABB's straight ones, solved whole: legal by the judge, and no faster than the
bound."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
import pytest
from arms import KNOWN, PARALLEL, Chain, on_rail, random_chain
from small_cells import problem_of, rapid

from trajopt_cli.bound import lower_bound
from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import confdata
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.trajectories.axes import Axes

pytestmark = pytest.mark.usefixtures("coarse", "few_places")

# arm, rail, joints [deg] of home, of the line's start and of what is near its end
CASES = {
    "offset elbow": (KNOWN["irb1200"], None, [0, 0, 0, 0, 30, 0], [40, 20, 10, 10, 50, 20], [35, 30, 5, 15, 60, 30]),
    "offset shoulder, overhead": (
        KNOWN["puma560"], "overhead",
        [0, -60, -160, 0, 40, 0], [20, -30, -170, 20, 50, 10], [25, -40, -175, 25, 55, 20],
    ),
    "offset elbow, on a rail upright": (
        KNOWN["irb1200"], "vertical", [0, 0, 0, 0, 30, 0], [40, 20, 10, 10, 50, 20], [35, 30, 5, 15, 60, 30],
    ),
    "crooked": (
        lambda: random_chain(4), None, [0, 0, 20, 0, 40, 0], [-60, -40, 10, 10, 30, 10], [-55, -45, 5, 15, 35, 20],
    ),
    "three parallel axes": (
        PARALLEL["ur10e"], None,
        [0, -90, 90, -90, -90, 0], [30, -70, 80, -100, -90, 30], [10, -60, 75, -105, -80, 10],
    ),
    "three parallel axes, overhead": (
        PARALLEL["ur5e"], "overhead",
        [0, -90, 90, -90, -90, 0], [30, -70, 80, -100, -90, 30], [10, -60, 75, -105, -80, 10],
    ),
}  # fmt: skip


def plant_of(chain: Chain, rail: str | None, home: Array) -> Plant:
    robot = (chain if rail is None else on_rail(chain, rail)).load(Path(mkdtemp()))
    base, r = robot.profile(), robot.layout.r
    limits = JointLimits(
        base.names,
        np.r_[[-0.1] * r, base.lower[r:]],
        np.r_[[0.5] * r, base.upper[r:]],
        base.velocity,
        np.r_[[3.0] * r, 15, 12.5, 20, 40, 40, 60],
    )
    return Plant(
        robot, limits, TcpCaps(2.5, 20.0), np.r_[[0.0] * r, home], (0,) if r else (), False, False, frozenset()
    )


def target(name: str, robot: RobotModel, q: Array, rail: float) -> str:
    X = robot.forward(np.r_[rail, q] if robot.has_rail else q)
    p, o, c = X[:3, 3] * 1e3, wxyz_from_rotation(X[:3, :3]), confdata(robot, q)
    numbers = [",".join(f"{v:.9f}" for v in part) for part in (p, o)]
    eax = f"{rail * 1e3:.3f}" if robot.has_rail else "9E9"
    conf = f"{c.cf1},{c.cf4},{c.cf6},{c.cfx}"
    return f"CONST robtarget {name}:=[[{numbers[0]}],[{numbers[1]}],[{conf}],[{eax},9E9,9E9,9E9,9E9,9E9]];\n"


@cache
def solved(case: str) -> tuple[Program, Plant, Plan]:
    chain, rail, *joints = CASES[case]
    home, here, there = (np.radians(np.array(q, dtype=float)) for q in joints)
    plant = plant_of(chain(), rail, home)
    if case == "offset elbow, on a rail upright":  # a tool held back needs more blocks
        plant = replace(plant, tcp=TcpCaps(9.0, 99.0), free_speed=True)
    eax = "0" if plant.robot.has_rail else "9E9"
    degrees = ",".join(f"{v:.10g}" for v in np.degrees(home))
    data = f"CONST jointtarget j_h:=[[{degrees}],[{eax},9E9,9E9,9E9,9E9,9E9]];\n"
    data += target("p_a", plant.robot, here, 0.3) + target("p_b", plant.robot, there, 0.3)
    wait = "WaitTime 0.1;" if case == "offset shoulder, overhead" else ""
    body = f"MoveJ p_a,v2500,fine,tool0;\nMoveL p_b,v500,fine,tool0;\n{wait}\nMoveAbsJ j_h,v2500,fine,tool0;"
    program = rapid(body, data=data)
    plan = optimize(program, plant, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan), plan
    return program, plant, plan


@pytest.mark.parametrize("case", CASES)
def test_the_plan_is_legal_and_no_faster_than_the_bound(case: str) -> None:
    program, plant, plan = solved(case)
    report = verify(program, plant, plan.trajectory, target=Target.STREAM, advice=False)
    assert [f"{f.check} {f.subject} {f.value} > {f.limit}" for f in report.findings if not f.passed] == []
    problem = problem_of(program, plant)
    value = lower_bound.lower_bound(Axes.of(plant), problem, 1.5 * plan.duration)
    assert 0.5 * plan.duration < value <= plan.duration
    written = optimize(program, plant, Target.STREAM, AS_WRITTEN, bounded=False)
    assert isinstance(written, Plan)
    assert plan.duration <= written.duration * (1 + 1e-6)
