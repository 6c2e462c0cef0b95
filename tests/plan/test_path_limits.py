"""PathAccLim in whole plans: what is along the tool's path, up and down apart, held by the judge."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from small_cells import plant_without_rail, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program
from trajopt_cli.plan import lower_bound_of, optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant

pytestmark = pytest.mark.usefixtures("coarse")

LINE = "MoveL Offs(p_in,0,-580,0), v500, fine, tool0;"
ROUND = """MoveC Offs(p_in,40,-580,0), Offs(p_in,0,-540,0), v500, z10, tool0;
MoveL Offs(p_in,0,-540,-60), v500, fine, tool0;"""
JOINTS = "MoveJ Offs(p_in,0,-520,-60), v500, fine, tool0;"
BRAKE, GO = r"PathAccLim FALSE, TRUE\DecelMax:=1;", r"PathAccLim TRUE\AccMax:=1, FALSE;"


def program_of(setting: str, body: str) -> Program:
    return rapid(f"MoveJ Offs(p_in,0,-640,0), v500, fine, tool0;\n{setting}\n{body}")


@cache
def plan_of(setting: str, body: str, target: Target) -> tuple[Program, Plant, Plan]:
    program, plant = program_of(setting, body), plant_without_rail()
    plan = optimize(program, plant, target, bounded=False)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [one.message for one in report.findings if not one.passed]
    return program, plant, plan


def along(plant: Plant, plan: Plan, first: int) -> Array:
    """The tool's speeding up from row to row, from the end of a motion on; by differences of speeds."""
    rows = plan.trajectory
    V = (plant.robot.jacobian(rows.q, np.eye(4)) @ rows.qd[..., None])[:, :3, 0]
    after = rows.t[:-1] >= plan.motions[first].t_1 - 1e-9
    return (np.diff(np.linalg.norm(V, axis=1)) / np.diff(rows.t))[after]


@pytest.mark.parametrize("target", Target)
@pytest.mark.parametrize("body", [LINE, ROUND, JOINTS], ids=["line", "round", "joints"])
def test_only_what_is_limited_is_limited(body: str, target: Target) -> None:
    once = body == JOINTS and target is Target.STREAM  # which takes longest, and one way is as the other
    for setting, sign in ((BRAKE, -1), (GO, 1))[: 1 if once else 2]:
        program, plant, plan = plan_of(setting, body, target)
        found = along(plant, plan, 0)
        assert 0.97 <= (sign * found).max() <= 1 + 1e-4
        assert (-sign * found).max() > 2, "the other way is free"
        assert lower_bound_of(program, plant, plan) <= plan.duration
        other = program_of(GO if sign < 0 else BRAKE, body)
        report = verify(other, plant, plan.trajectory, target=target, advice=False)
        assert {one.check for one in report.findings if not one.passed} == {"PathAccLim"}


def test_the_whole_acceleration_in_the_world_is_another_cap() -> None:
    _, _, plan = plan_of(r"WorldAccLim \On:=1;", ROUND, Target.STREAM)
    _, _, free = plan_of(BRAKE.replace("FALSE", r"TRUE\AccMax:=1"), ROUND, Target.STREAM)
    assert free.duration < plan.duration - 0.05, "bends count for the one alone"
