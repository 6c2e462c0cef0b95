"""An arm on two linear axes among obstacles: what is found, and what is said where nothing is."""

from __future__ import annotations

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.plan.collision_diagnosis import blocked_place
from trajopt_cli.plan.fallback_plan import fallback_motion
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.trajectories.axes import Axes

pytestmark = pytest.mark.usefixtures("coarse")

DOWN = "[0,0,1,0],[0,0,0,0]"
WALL = "wall: {box: {size: [3, 0.1, 2], position: [0.75, 0.1, 1.0]}}"  # through which the arm reaches from small b
BOX = "box: {box: {size: [0.12, 0.12, 0.6], position: [0.75, 0.4, 0.3]}}"
AROUND_THE_POINT = "block: {box: {size: [0.3, 0.3, 0.6], position: [0.9, 0.25, 0.3]}}"


def case(obstacles: str, first: str, b: str = "[-0.3, 0.8]", start: float = 0.75) -> tuple[Plant, Program]:
    text = f"""robot: irb140
tool_radius: 0
axes:
  eax_a: {{axis: [1, 0, 0], stroke: [-0.2, 1.2]}}
  eax_b: {{axis: [0, 1, 0], stroke: {b}}}
start: {{joints: "[0, 0, 0, 0, 30, 0] deg", rail: [0, {start}]}}
obstacles: {{{obstacles}}}
"""
    plant = build_plant(parse_cell(text, "cell.yaml"))
    body = rf"""ConfJ \Off;
MoveJ [{first},{DOWN},[0,{1000 * start},9E9,9E9,9E9,9E9]], v1000, fine, tool0;
MoveJ [[900,250,400],{DOWN},[200,0,9E9,9E9,9E9,9E9]], v1000, fine, tool0;"""
    file = TextFile("t.mod", f"MODULE T\nPROC main()\n{body}\nENDPROC\nENDMODULE", "utf-8")
    return plant, run_program([file], None, "main", PlantKinematics(plant))


def problem_of(plant: Plant, program: Program) -> Problem:
    problem = build_problem(program, plant)
    assert isinstance(problem, Problem)
    return problem


def test_a_point_that_another_axis_frees_is_not_blocked() -> None:
    """With b at its least every way to the second point leads through the wall, from beyond it none does."""
    plant, program = case(WALL, "[600,550,400]")
    assert blocked_place(Axes.of(plant), problem_of(plant, program)) is None
    assert isinstance(optimize(program, plant, Target.STREAM, bounded=False), Plan)


@pytest.mark.long
def test_axes_are_sought_all_over_their_strokes_where_nothing_near_is_clear() -> None:
    """Neither as written, in the wall, nor abreast of the points is there a way around the box."""
    plant, program = case(f"{WALL}, {BOX}", "[600,550,400]")
    plan = optimize(program, plant, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=Target.STREAM, advice=False)
    assert report.legal, report.violations


def test_a_point_inside_a_body_is_blocked_wherever_the_axes_are() -> None:
    plant, program = case(AROUND_THE_POINT, "[600,550,400]")
    found = blocked_place(Axes.of(plant), problem_of(plant, program))
    assert isinstance(found, Infeasible)
    assert (found.index, found.source and found.source.line) == (1, 5)
    assert "'block'" in found.message


def test_the_slow_plan_moves_several_axes() -> None:
    plant, program = case(AROUND_THE_POINT.replace("0.25, 0.3", "2.25, 0.3"), "[600,550,400]")
    axes, problem = Axes.of(plant), problem_of(plant, program)
    slow = fallback_motion(axes, problem)
    assert slow is not None
    for q, point in zip(slow.q, problem.waypoints, strict=True):
        assert axes.forward(q) == pytest.approx(point.X_WF, abs=1e-9)
