"""Turns of tools that are free about their axis, as plans choose them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.limits import JointLimits
from trajopt_cli.motion import FreeTurn, Program
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.plan import check_feasible, lower_bound_of, optimize
from trajopt_cli.plan.tool_turns import best_sampled_turns, sampled, stays_at_wrist
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.tool_turns import turn_groups, turned
from trajopt_cli.scenario import FreeTool, Scenario
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.warnings import Source

Z = (0.0, 0.0, 1.0)
ROUND = FreeTurn(Z, -np.pi, np.pi)
TAUGHT = replace(EVERYTHING, turn=False)
REST = "[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]"
TOOLS = """PERS tooldata tRound:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
PERS tooldata tHead:=[TRUE,[[110,0,60],[0.7071068,0,0.7071068,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];"""
# Two places on a circle about axis 1; the taught spins differ by 170 degrees.
POINTS = f"""CONST robtarget p_a:=[[500,-200,350],[0,0,1,0],{REST}];
CONST robtarget p_b:=[[500,200,350],[0,0.9961947,0.0871557,0],{REST}];
CONST robtarget p_c:=[[500,200,350],[0,0.5,0.8660254,0],{REST}];
CONST robtarget p_t:=[[450,100,400],[0.1305262,0,0.9914449,0],{REST}];"""
HOME = r"MoveAbsJ j_home\NoEOffs,v5000,fine,tRound;"
MOVES = f"MoveJ p_a,v5000,fine,tRound;\nMoveJ p_b,v5000,fine,tRound;\nMoveJ p_a,v5000,fine,tRound;\n{HOME}"
DRILL = """MoveJ RelTool(p_a,0,0,-40),v1000,fine,tHead;
MoveL p_a,v100,fine,tHead;
WaitTime 0.1;
MoveL RelTool(p_a,0,0,-40),v200,fine,tHead;
MoveJ RelTool(p_c,0,0,-40),v1000,fine,tHead;
MoveL p_c,v100,fine,tHead;
MoveL RelTool(p_c,0,0,-40),v200,z10,tHead;
MoveAbsJ j_home\\NoEOffs,v1000,fine,tHead;"""


def program_of(body: str, free: FreeTurn | None = ROUND) -> Program:
    scenario = Scenario(free=() if free is None else (FreeTool(free, Source("cell.yaml", 3, 1)),))
    return rapid(body, scenario, f"{TOOLS}\n{POINTS}")


def slow_wrist() -> Plant:
    """Axis 6 is slow, as on a large robot."""
    plant = plant_without_rail()
    limits = plant.limits
    V, A = np.array(limits.velocity), np.array(limits.acceleration)
    V[5], A[5] = 1.0, 4.0
    return replace(plant, limits=JointLimits(limits.names, limits.lower, limits.upper, V, A))


@cache
def planned(body: str, target: Target, turn: bool = True) -> Plan:
    found = optimize(program_of(body), slow_wrist(), target, replace(EVERYTHING, turn=turn), bounded=False)
    assert isinstance(found, Plan), found
    return found


@pytest.mark.parametrize("target", Target)
def test_a_round_tool_never_waits_for_the_wrist(target: Target) -> None:
    """Turned so that axis 6 has no way of its own, the moves take what axis 1 alone takes between both places."""
    plant, plan, taught = slow_wrist(), planned(MOVES, target), planned(MOVES, target, False)
    swing = 2 * np.arctan2(0.2, 0.5)
    arm = float(trapezoid_time(swing, plant.limits.velocity[0], plant.limits.acceleration[0]))
    times, before = ([one.t_1 - one.t_0 for one in found.motions[1:3]] for found in (plan, taught))
    assert min(before) > 1.5 * arm  # whatever the wrist does
    assert times == pytest.approx([arm, arm], rel=0.02)
    spins = [plan.turns.get(i, 0.0) for i in range(3)]
    assert abs(np.degrees(spins[1] - spins[0]) % 360 - 190) < np.degrees(2 * swing)


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_turned_plans_are_faster_legal_and_above_their_bound(target: Target) -> None:
    plan, taught, plant = planned(DRILL, target), planned(DRILL, target, False), slow_wrist()
    assert plan.duration < 0.9 * taught.duration
    assert plan.turns
    text = write_csv_text(plan.trajectory)
    report = judge(plant, program_of(DRILL), text, "t.csv", None, target, advice=False)
    assert report.legal, report.worst.message
    assert not judge(plant, program_of(DRILL, None), text, "t.csv", None, target, advice=False).legal
    assert lower_bound_of(program_of(DRILL), plant, plan) <= plan.duration


def test_turns_stay_in_their_sector() -> None:
    sector = FreeTurn(Z, np.radians(-10.0), np.radians(25.0))
    plan = optimize(program_of(DRILL, sector), slow_wrist(), Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    assert plan.turns
    assert all(sector.low <= turn <= sector.high for turn in plan.turns.values())
    assert planned(DRILL, Target.RAPID).duration <= plan.duration <= planned(DRILL, Target.RAPID, False).duration


def test_nothing_turns_unless_it_is_free() -> None:
    for program, freedom in ((program_of(DRILL, None), EVERYTHING), (program_of(DRILL), AS_WRITTEN)):
        plan = optimize(program, slow_wrist(), Target.RAPID, freedom, bounded=False)
        assert not isinstance(plan, Plan) or not plan.turns
    assert planned(DRILL, Target.RAPID, False).turns == {}


@pytest.mark.long
def test_under_jerk_limits_a_turn_that_helps_a_corner_does_not_hide_that_a_stop_is_faster() -> None:
    """The corner of a spike costs more under jerk than a stop; a hair of a turn saves less than that."""
    body = """MoveJ p_a,v1000,fine,tRound;
MoveL RelTool(p_a,0,0,-30),v2000,z5,tRound;
MoveL RelTool(p_a,3,0,0),v2000,fine,tRound;
MoveAbsJ j_home\\NoEOffs,v1000,fine,tRound;"""
    plant, program = slow_wrist(), program_of(body, FreeTurn(Z, -0.003, 0.003))
    limits = replace(plant.limits, jerk=15 * plant.limits.acceleration, jerk_binds=True)
    times = []
    for freedom in (EVERYTHING, TAUGHT):
        plan = optimize(program, replace(plant, limits=limits), Target.RAPID, freedom, bounded=False)
        assert isinstance(plan, Plan)
        times.append(plan.duration)
    assert times[0] <= times[1]


def test_the_gentlest_motion_says_that_it_turns_no_tool() -> None:
    plant, goal = slow_wrist(), LeastEffort(2 * planned(MOVES, Target.RAPID, False).duration)
    for turn in (True, False):
        freedom = replace(EVERYTHING, turn=turn)
        plan = optimize(program_of(MOVES), plant, Target.RAPID, freedom, bounded=False, objective=goal)
        assert isinstance(plan, Plan)
        assert not plan.turns
        assert any("as taught" in note for note in plan.notes) == turn


def test_a_bound_holds_for_other_turns() -> None:
    """The bound of a tool whose axis misses the wrist says nothing of the arm's joints as taught."""
    program, plant = program_of(DRILL), slow_wrist()
    taught = planned(DRILL, Target.RAPID, False)
    free, held = (lower_bound_of(program, plant, taught, freedom) for freedom in (EVERYTHING, TAUGHT))
    assert free <= planned(DRILL, Target.RAPID).duration < taught.duration
    assert free < held <= taught.duration


@pytest.mark.parametrize(("tool", "expected"), [("tRound", True), ("tHead", False)])
def test_which_turns_leave_the_arm_alone(tool: str, expected: bool) -> None:
    program, plant = program_of(f"MoveJ p_a,v100,fine,{tool};"), plant_without_rail()
    groups = turn_groups(problem_of(program, plant), everything(program, plant))
    assert stays_at_wrist(Axes.of(plant), groups) == expected


def test_samples_go_around_once() -> None:
    program, plant = program_of("MoveJ p_a,v100,fine,tRound;"), plant_without_rail()
    groups = turn_groups(problem_of(program, plant), everything(program, plant))
    (turns,) = sampled(groups)
    assert len(turns) == 24
    assert 0.0 in turns
    assert np.ptp(turns) == pytest.approx(np.radians(345.0))


def test_the_ladder_of_way_is_the_shortest_of_all() -> None:
    """Against every combination of turns, each with the configuration nearest to the one before (brute force)."""
    plant = plant_without_rail()
    sector = FreeTurn(Z, np.radians(-45.0), np.radians(45.0))
    program = program_of(MOVES, sector)
    problem, axes = problem_of(program, plant, Target.RAPID), Axes.of(plant)
    groups = turn_groups(problem, everything(program, plant))
    route = search(axes, problem)
    assert route is not None
    angles, route = best_sampled_turns(axes, groups, route, by_way=True)
    assert route is not None
    way = np.abs(np.diff(route.q, axis=0)).sum()
    steps = np.radians(np.arange(-45.0, 46.0, 15.0))
    postures = {}
    for i in range(3):
        for a in steps:
            X = turned(program, {i: a}).motions[i]
            X_WF = X.X_WT @ np.linalg.inv(X.tool.X_FT)  # type: ignore[union-attr]
            postures[i, a] = np.array([arm for _, arm in plant.robot.solutions(X_WF, None, plant.limits)])
    q = np.array([plant.start])
    reached = np.zeros(1)
    for i in range(3):
        every = np.concatenate([postures[i, a] for a in steps])
        reached = (reached[:, None] + np.abs(q[:, None] - every[None]).sum(axis=2)).min(axis=0)
        q = every
    best = (reached + np.abs(q - problem.waypoints[-1].q).sum(axis=1)).min()
    assert way == pytest.approx(best, abs=1e-6)
    assert np.isin(np.round(np.degrees(angles)), np.arange(-45, 46, 15)).all()


@pytest.mark.long
def test_what_cannot_be_reached_as_taught_is_turned_until_it_can() -> None:
    body, plant = DRILL.replace("p_c", "p_b"), slow_wrist()
    assert check_feasible(program_of(body, None), plant, Target.RAPID) is not None
    assert check_feasible(program_of(body), plant, Target.RAPID) is None
    plan = optimize(program_of(body), plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    assert judge(plant, program_of(body), write_csv_text(plan.trajectory), "t.csv", None, Target.RAPID, False).legal
    narrow = program_of(body, FreeTurn(Z, -0.3, 0.3))
    refused = optimize(narrow, plant, Target.RAPID, bounded=False)
    assert isinstance(refused, Infeasible)
    assert refused.index == 4


@pytest.mark.long
def test_a_rail_goes_with_turned_tools() -> None:
    plant = plant_with_rail()
    program = program_of(DRILL)
    found = [optimize(program, plant, Target.RAPID, freedom, bounded=False) for freedom in (TAUGHT, EVERYTHING)]
    taught, plan = found
    assert isinstance(taught, Plan)
    assert isinstance(plan, Plan)
    assert plan.duration <= taught.duration
    text = write_csv_text(plan.trajectory)
    assert judge(plant, program, text, "t.csv", None, Target.RAPID, advice=False).legal
