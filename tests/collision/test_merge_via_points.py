"""Joint moves by added points as one leg: the same motion, and what the nonlinear program makes of it."""

from __future__ import annotations

import numpy as np
import pytest
from small_cells import plant_without_rail, problem_of, rapid

from trajopt_cli.collision.merge_via_points import detours_left, merge_via_points
from trajopt_cli.collision.motion_collision import clear
from trajopt_cli.geometry import pose
from trajopt_cli.path_timing.path_parameterized_plan import duration
from trajopt_cli.plan.initial_plan import InitialPlan, PlanCache, PlanRequest, find_initial_plan
from trajopt_cli.plan.local_refinement import refine
from trajopt_cli.plan.solve import optimize
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.shapes import Box, Solid
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import JointNodes

WALL = Solid(Box("wall", np.array([0.5, 0.04, 0.4]), pose(np.eye(3), [0.6, 0.0, 0.2])))
PLANT = plant_without_rail(obstacles=(WALL,), clearance=0.01)
PROGRAM = rapid("""MoveJ p_left, v2500, fine, tool0;
MoveJ p_right, v2500, fine, tool0;
MoveL Offs(p_right,0,0,-60), v500, fine, tool0;""", data="""
CONST robtarget p_left:=[[400,400,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_right:=[[400,-400,350],[0,0,1,0],[-1,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];""")  # fmt: skip
AXES = Axes.of(PLANT)


@pytest.fixture(scope="module")
def legal() -> InitialPlan:
    question = PlanRequest(PROGRAM, PLANT, Target.STREAM, EVERYTHING)
    found = find_initial_plan(AXES, question, PlanCache(), Patience(), lambda _: None, {})
    assert isinstance(found, InitialPlan)
    return found


def test_one_leg_in_place_of_several_is_the_same_motion(legal: InitialPlan) -> None:
    (detour,) = legal.detours
    problem, iterate = merge_via_points(AXES, legal.problem, legal.iterate, legal.detours)
    points = len(detour.points)
    assert len(problem.legs) == len(legal.problem.legs) - points == 3
    assert [leg.start for leg in problem.legs] == [0, 1, 2]
    assert not any(problem.passes(k) for k in range(4))
    assert duration(iterate) == pytest.approx(duration(legal.iterate), abs=1e-12)
    one, parts = iterate.legs[1], legal.iterate.legs[1 : points + 2]
    assert isinstance(one, JointNodes)
    start = 0.0
    for part in parts:
        assert part is not None
        t = np.linspace(0, part.T, 97)[1:-1]
        before, now = part.sample(AXES, t), one.sample(AXES, start + t)
        assert now.q == pytest.approx(before.q, abs=1e-9)
        assert now.qd == pytest.approx(before.qd, abs=1e-7)
        start += part.T
    assert np.array_equal(iterate.q[1:3], legal.iterate.q[[1, points + 2]])


def test_a_problem_without_points_is_itself(legal: InitialPlan) -> None:
    problem, iterate = merge_via_points(AXES, legal.problem, legal.iterate, legal.detours)
    assert merge_via_points(AXES, problem, iterate, legal.detours) == (problem, iterate)
    assert detours_left(legal.problem, legal.detours) == legal.detours
    assert detours_left(problem, legal.detours) == ()
    own = problem_of(PROGRAM, PLANT)
    assert [leg.kind for leg in problem.legs] == [leg.kind for leg in own.legs]
    assert [point.X_WF.tolist() for point in problem.waypoints] == [point.X_WF.tolist() for point in own.waypoints]
    assert problem.stations == own.stations


def test_points_of_an_earlier_plan_are_the_programs_own(legal: InitialPlan) -> None:
    """As they are read from a text with the planner's mark."""
    marked = [motion for motion in legal.problem.program.motions if getattr(motion, "detour", ())]
    assert len(marked) == len(legal.detours[0].points)
    assert merge_via_points(AXES, legal.problem, legal.iterate, ()) == (legal.problem, legal.iterate)


def test_free_axes_go_around_faster_than_by_points(legal: InitialPlan) -> None:
    problem, iterate, _ = refine(AXES, legal, Patience(), lambda _: None, {})
    assert clear(AXES, problem, iterate)
    assert duration(iterate) < 0.98 * legal.duration


def test_a_stream_plan_has_no_points_left() -> None:
    plan = optimize(PROGRAM, PLANT, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    assert plan.detours == ()
    assert [motion.index for motion in plan.motions] == [0, 1, 2]
    assert not any(motion.via for motion in plan.motions)
    times = [plan.motions[0].t_0, *(motion.t_1 for motion in plan.motions)]
    assert times == sorted(times)
    assert times[-1] == plan.duration
    assert plan.motions[1].t_0 == plan.motions[0].t_1
    assert plan.notes == ("t.mod:6:1: MoveJ p_right goes around 'wall'",)
