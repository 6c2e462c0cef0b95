"""Joints that a program gives need no margin from a singularity; lines leave one without a jump, or that is told."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.geometry import Array, pose, rotation_about, wxyz_from_rotation
from trajopt_cli.graph_search.ik_tables import rail_grid, station_table
from trajopt_cli.graph_search.search import search
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program
from trajopt_cli.path.line import Line
from trajopt_cli.plan import check_feasible, optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, Freedom
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import Route

ZEROS = "[[0,0,0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]"
AT_ZERO = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0.0]])  # of the flange, with all joints at zero
BOTH = pytest.mark.parametrize("target", list(Target))
PLANTS = pytest.mark.parametrize("plant", [plant_without_rail(), plant_with_rail()], ids=["no rail", "rail"])


def target_data(name: str, p: tuple[float, float, float], R: Array = AT_ZERO, eax: str = "0") -> str:
    quaternion = ",".join(f"{x:.6f}" for x in wxyz_from_rotation(R))
    place = ",".join(f"{x * 1e3:.3f}" for x in p)
    return f"CONST robtarget {name}:=[[{place}],[{quaternion}],[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]];"


def joints_data(name: str, degrees: tuple[float, ...], eax: float = 0) -> str:
    return f"CONST jointtarget {name}:=[[{','.join(map(str, degrees))}],[{eax},9E9,9E9,9E9,9E9,9E9]];"


def route_of(program: Program, plant: Plant, target: Target, freedom: Freedom = EVERYTHING) -> Route:
    assert check_feasible(program, plant, target, freedom) is None
    route = search(Axes.of(plant), problem_of(program, plant, target, freedom))
    assert route is not None
    return route


def refused(program: Program, plant: Plant, target: Target, freedom: Freedom = EVERYTHING) -> str:
    answer = check_feasible(program, plant, target, freedom)
    assert isinstance(answer, Infeasible)
    return str(answer)


# ------------------------------------------------------------------------------------------------------- at rest


@BOTH
@PLANTS
@pytest.mark.parametrize("degrees", [(0,) * 6, (10, 5, -90, 0, 20, 0), (0, 0, 0, -190, 0, 370)])
def test_joints_that_are_given_are_kept_in_a_wait(plant: Plant, target: Target, degrees: tuple[float, ...]) -> None:
    """The wrist singular, the arm stretched, and the wrist with whole turns; the rail at 300 mm."""
    program = rapid("MoveAbsJ j, v500, fine, tool0;\nWaitTime 1;", data=joints_data("j", degrees, 300))
    route = route_of(program, plant, target)
    wanted = np.r_[[0.3] if plant.robot.has_rail else [], np.radians(degrees)]
    np.testing.assert_allclose(route.q[1:], [wanted, wanted], rtol=0, atol=1e-12)
    assert route.times[1] == 1.0


@BOTH
@PLANTS
def test_a_start_at_zeros_may_wait(plant: Plant, target: Target) -> None:
    plant = replace(plant, start=0 * plant.start)
    route = route_of(rapid("WaitTime 1;\nMoveAbsJ j_home, v500, fine, tool0;"), plant, target)
    np.testing.assert_array_equal(route.q[:2], np.zeros((2, len(plant.start))))


@BOTH
@PLANTS
def test_such_a_program_is_planned_and_judged_legal(plant: Plant, target: Target) -> None:
    body = f"MoveAbsJ {ZEROS}, v1000, fine, tool0;\nWaitTime 0.5;\nMoveAbsJ j_home, v1000, fine, tool0;"
    legal_plan(rapid(body), plant, target)


@PLANTS
def test_a_pose_in_which_nothing_moves_may_be_singular(plant: Plant) -> None:
    """The pose of all joints at zero: the rail is where the program puts it, and waits there."""
    program = rapid("MoveJ p, v500, fine, tool0;\nWaitTime 1;", data=target_data("p", (0.515, 0, 0.712)))
    route = route_of(program, plant, Target.RAPID, AS_WRITTEN)
    np.testing.assert_allclose(route.q[1:], 0, rtol=0, atol=1e-5)


def test_a_free_rail_keeps_its_margin() -> None:
    plant = plant_with_rail()
    program = rapid("MoveJ p, v500, fine, tool0;\nWaitTime 1;", data=target_data("p", (0.515, 0, 0.712)))
    route = route_of(program, plant, Target.STREAM)
    assert np.all(np.abs(np.sin(route.q[1:, 5])) >= 1e-3)


# ------------------------------------------------------------------------------------------------------- lines


def departure(p: tuple[float, float, float], degrees: tuple[float, ...] = (0,) * 6, R: Array = AT_ZERO) -> Program:
    """From joints at a singularity along a line."""
    data = joints_data("j", degrees) + target_data("p", p, R)
    return rapid("MoveAbsJ j, v500, fine, tool0;\nMoveL p, v200, fine, tool0;", data=data)


IN_PLANE = (0.465, 0.0, 0.612)
ASIDE = (0.465, 0.06, 0.612)


@BOTH
@PLANTS
@pytest.mark.parametrize("joint_4", [0, 180, -180])
@pytest.mark.parametrize("p", [IN_PLANE, (0.5, 0.0, 0.8)], ids=["down", "up"])
def test_a_line_in_the_plane_of_the_arm_leaves_the_wrist_singularity(
    plant: Plant, target: Target, joint_4: int, p: tuple[float, float, float]
) -> None:
    """Joints 1, 4 and 6 stay what they are, joint 5 bends to either side: with joint 4 turned by 180 to the other."""
    program = departure(p, (0, 0, 0, joint_4, 0, -joint_4))
    plant = plant_with_rail(rail_fixed=True) if plant.robot.has_rail else plant
    route = route_of(program, plant, target)
    arm = route.q[:, -6:]
    wanted = np.radians([0, joint_4, -joint_4])
    np.testing.assert_allclose(arm[1:, [0, 3, 5]], [wanted, wanted], rtol=0, atol=2e-5)
    assert abs(arm[2, 4]) > 0.1
    X_WF = plant.robot.forward(route.q[2])
    np.testing.assert_allclose(X_WF, pose(AT_ZERO, p), rtol=0, atol=1e-5)


def test_the_table_holds_the_joints_given_and_then_the_line() -> None:
    """At the start the joints as given, at every node behind it the pose on the line, without a jump between."""
    plant = plant_without_rail()
    problem = problem_of(departure(IN_PLANE, (0, 0, 0, 180, 0, 180)), plant)
    axes = Axes.of(plant)
    d = rail_grid(problem, 1, 2, DEFAULT.coarse_grid)
    table = station_table(axes, problem, 1, 2, d)
    line = table.line(0)
    assert line is not None
    assert len(table.labels) == len(line) == 1
    q = line[0, :, 0]
    np.testing.assert_allclose(q[0], np.radians([0, 0, 0, 180, 0, 180]), atol=1e-12)
    X = Line(problem.waypoints[1].X_WF, problem.waypoints[2].X_WF).pose(np.linspace(0, 1, DEFAULT.line_samples))
    np.testing.assert_allclose(axes.forward(q), X, rtol=0, atol=1e-9)
    assert np.abs(np.diff(q, axis=0)).max() < 0.1


@BOTH
def test_a_line_aside_says_how_the_wrist_has_to_be_turned_before(target: Target) -> None:
    """The advice, followed, lets the line pass; the angle is that of the inverse a hair behind the start."""
    plant = plant_without_rail()
    message = refused(departure(ASIDE), plant, target)
    found = re.fullmatch(
        r"t\.mod:6:1: MoveL p starts in the wrist singularity \(joint_5 = 0°\) and leaves it with joint_4 turned by"
        r" ([+-][\d.]+)° and joint_6 turned by ([+-][\d.]+)°: turn them there before, or give the start another"
        r" joint_5",
        message,
    )
    assert found, message
    turn_4, turn_6 = float(found[1]), float(found[2])
    X = Line(pose(AT_ZERO, (0.515, 0, 0.712)), pose(AT_ZERO, ASIDE)).pose(np.array([1e-4]))
    near = np.degrees(plant.robot.branches(X, None)[0])
    nearest = near[np.argmin(np.abs((near[:, 3] + 180) % 360 - 180) + 1e3 * np.abs(near[:, 2]))]
    assert turn_4 == pytest.approx(nearest[3], abs=0.1)
    assert turn_6 == pytest.approx(-turn_4, abs=0.1)
    assert check_feasible(departure(ASIDE, (0, 0, 0, turn_4, 0, turn_6)), plant, target) is None
    assert check_feasible(departure(ASIDE, (0, 0, 0, turn_4 + 1e-4, 0, turn_6 - 1e-4)), plant, target) is not None


def test_joint_5_beside_zero_is_left_to_its_own_side_only() -> None:
    """0.03 degrees: the line bends the wrist to one side; from the other it would pass the singularity."""
    plant = plant_without_rail()
    for sign in (1, -1):
        degrees = (0, 0, 0, 0, 0.03 * sign, 0)
        R = AT_ZERO @ rotation_about([0, 1, 0], np.radians(0.03 * sign))
        way = departure(IN_PLANE, degrees, R)
        aside = departure(ASIDE, degrees, R)
        assert "starts in the wrist singularity (joint_5 = " in refused(aside, plant, Target.RAPID)
        if sign < 0:
            route_of(way, plant, Target.RAPID)
        else:
            assert "leaves it with joint_4 turned by +180.000000°" in refused(way, plant, Target.RAPID)


def legal_plan(program: Program, plant: Plant, target: Target, freedom: Freedom = EVERYTHING) -> None:
    plan = optimize(program, plant, target, freedom, bounded=False)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [finding.message for finding in report.findings if not finding.passed]


@BOTH
@pytest.mark.parametrize("joint_4", [180, -180])
@pytest.mark.parametrize("p", [IN_PLANE, (0.5, 0.0, 0.8)], ids=["down", "up"])
def test_such_a_line_is_planned_and_judged_legal(target: Target, joint_4: int, p: tuple[float, float, float]) -> None:
    """Half a turn of joint 4 is as far from what the inverse gives at the singularity by convention as can be."""
    legal_plan(departure(p, (0, 0, 0, joint_4, 0, -joint_4)), plant_without_rail(), target)


@BOTH
def test_such_a_line_is_planned_with_the_rail_going_along(target: Target) -> None:
    legal_plan(with_rail_going(0.1, 100), plant_with_rail(), target, AS_WRITTEN)


def test_wrists_turned_to_where_the_line_leaves_are_planned() -> None:
    """Not in the plane of the arm: the joints at the start are the ones told, and stay what they are there."""
    plant = plant_without_rail()
    found = re.search(r"joint_4 turned by ([+-][\d.]+)° ", refused(departure(ASIDE), plant, Target.RAPID))
    assert found
    program = departure(ASIDE, (0, 0, 0, float(found[1]), 0, -float(found[1])))
    legal_plan(program, plant, Target.RAPID)


def test_a_line_behind_a_wait_at_zeros() -> None:
    data = joints_data("j", (0,) * 6) + target_data("p", IN_PLANE)
    body = "MoveAbsJ j, v500, fine, tool0;\nWaitTime 0.2;\nMoveL p, v200, fine, tool0;\nWaitTime 0.1;"
    route = route_of(rapid(body, data=data), plant_without_rail(), Target.RAPID)
    assert route.times[1] == 0.2
    np.testing.assert_allclose(route.q[1:3], 0, atol=1e-12)


def with_rail_going(y: float, eax: float) -> Program:
    data = joints_data("j", (0,) * 6) + target_data("p", (0.465, y, 0.612), eax=str(eax))
    return rapid("ConfL \\Off;\nMoveAbsJ j, v500, fine, tool0;\nMoveL p, v200, fine, tool0;", data=data)


def test_a_rail_that_goes_along_keeps_the_line_in_the_plane_of_the_arm() -> None:
    """The rail is y: 100 mm of it with 100 mm of the tool are a line in the plane of the arm; either alone is not."""
    plant = plant_with_rail()
    route = route_of(with_rail_going(0.1, 100), plant, Target.RAPID, AS_WRITTEN)
    np.testing.assert_allclose(route.q[2, [0, 1, 4, 6]], [0.1, 0, 0, 0], atol=1e-5)
    for y, eax in ((0.1, 0), (0, 100)):
        message = refused(with_rail_going(y, eax), plant, Target.RAPID, AS_WRITTEN)
        assert "MoveL p starts in the wrist singularity" in message


def test_a_free_rail_that_shares_the_way_goes_where_the_line_begins_without_a_jump() -> None:
    """Coordinated, the rail's place at the end decides how the line begins: only one lies in the plane of the arm."""
    plant = plant_with_rail()
    problem = problem_of(with_rail_going(0.1, 100), plant, Target.RAPID)
    axes = Axes.of(plant)
    d = np.array([-0.1, 0.0, 0.1, 0.2])
    table = station_table(axes, problem, 1, 2, d)
    assert table.leaves is not None
    assert table.leaves.tolist() == [[False, False, True, False]]


def test_a_line_out_of_a_stretched_arm_is_refused_in_words() -> None:
    """Joint 3 at -90 degrees: the forearm in line with the upper arm; downwards it bends at infinite speed."""
    plant = plant_without_rail()
    q = np.radians([0, 30, -90, 0, 40, 0])
    X = plant.robot.forward(q)
    program = departure(tuple(X[:3, 3] - [0.1, 0, 0.1]), (0, 30, -90, 0, 40, 0), X[:3, :3])
    assert "starts with the arm stretched or folded (joint_3 = -90°)" in refused(program, plant, Target.RAPID)
    near = np.radians([0, 30, -88, 0, 40, 0])
    X = plant.robot.forward(near)
    program = departure(tuple(X[:3, 3] - [0.1, 0, 0.1]), (0, 30, -88, 0, 40, 0), X[:3, :3])
    route_of(program, plant, Target.RAPID)
