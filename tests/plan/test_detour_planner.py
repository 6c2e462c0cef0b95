"""Plans among obstacles: the planner leads around them, moves the rail, or says what is in the way.

That nothing is touched is looked at densely by pin and coal; that the motion is legal by the judge.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from clear_of import least_along
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid
from unrefined import set_defaults

from trajopt_cli.collision import edge_collision
from trajopt_cli.collision.collision_scene import CollisionScene
from trajopt_cli.collision.edge_collision import EdgeCollision
from trajopt_cli.collision.roadmap import Roadmap, about
from trajopt_cli.geometry import Array, BoolArray, pose
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveJ, Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.detours import held_against
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scenario import RailUnit, Scenario
from trajopt_cli.shapes import Box, Capsule, Solid
from trajopt_cli.trajectories.axes import Axes

pytestmark = pytest.mark.usefixtures("coarse", "few_places")

MOVES = "MoveJ p_a,v1000,fine,tool0;\nMoveJ p_b,v1000,fine,tool0;"
PLACES = """CONST robtarget p_a:=[[450,-300,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_b:=[[450,300,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
NOD = "CONST jointtarget j_b:=[[0,0,0,0,60,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
ACROSS = rapid(f"ConfJ \\Off;\n{MOVES}", data=PLACES)
ACROSS_TWICE = rapid(f"ConfJ \\Off;\nFOR i FROM 1 TO 2 DO\n{MOVES}\nENDFOR", data=PLACES)
DOWN = rapid("MoveJ p_in,v1000,fine,tool0;\nMoveL p_low,v500,fine,tool0;")


def box(name: str, size: tuple[float, float, float], at: tuple[float, float, float]) -> Solid:
    return Solid(Box(name, np.array(size), pose(np.eye(3), at)))


POST = box("post", (0.1, 0.1, 0.45), (0.45, 0.0, 0.25))
WANTED = 0.01


@cache
def plan(name: str, target: Target, *obstacles: Solid) -> Plan | Infeasible:
    program, plant = CASES[name]
    return optimize(program, replace(plant, obstacles=obstacles, clearance=WANTED), target, bounded=False)


CASES: dict[str, tuple[Program, Plant]] = {
    "across": (ACROSS, plant_without_rail()),
    "down": (DOWN, plant_with_rail((-0.1, 0.9))),
    "nod": (rapid("MoveAbsJ j_b,v1000,fine,tool0;", data=NOD), plant_without_rail()),
    "there": (rapid("MoveJ p_in,v1000,fine,tool0;"), plant_with_rail((-0.1, 0.8))),
}


def judged(name: str, found: Plan, *obstacles: Solid) -> None:
    program, plant = CASES[name]
    plant = replace(plant, obstacles=obstacles, clearance=WANTED)
    there, dropped = held_against(program, plant, found.target, found.detours, ())
    report = verify(there, plant, found.trajectory, None, dropped, found.target, advice=False)
    assert report.legal, [one for one in report.findings if not one.passed]


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_a_joint_move_leads_around_what_is_in_its_way(target: Target) -> None:
    bare, found = plan("across", target), plan("across", target, POST)
    assert isinstance(bare, Plan)
    assert isinstance(found, Plan)
    plant = replace(CASES["across"][1], obstacles=(POST,), clearance=WANTED)
    assert least_along(plant, bare.trajectory) < -0.01  # it would go through it
    assert least_along(plant, found.trajectory) >= 0
    judged("across", found, POST)
    assert found.duration < 1.1 * bare.duration
    assert "MoveJ p_b goes around 'post'" in " ".join(found.notes)
    if target is Target.RAPID:  # a stream bends as it likes
        assert [detour.motion for detour in found.detours] == [1]
        assert found.detours[0].around == ("post",)


@pytest.mark.long
def test_the_same_question_has_the_same_answer() -> None:
    program, plant = CASES["across"]
    plant = replace(plant, obstacles=(POST,), clearance=WANTED)
    first, second = plan("across", Target.RAPID, POST), optimize(program, plant, Target.RAPID, bounded=False)
    assert isinstance(first, Plan)
    assert isinstance(second, Plan)
    assert first.trajectory.q.tobytes() == second.trajectory.q.tobytes()


def test_what_is_in_nobodys_way_changes_nothing() -> None:
    far = box("far", (0.2, 0.2, 0.2), (-0.8, 0.0, 1.4))
    bare, found = plan("across", Target.RAPID), plan("across", Target.RAPID, far)
    assert isinstance(bare, Plan)
    assert isinstance(found, Plan)
    assert bare.trajectory.q.tobytes() == found.trajectory.q.tobytes()
    assert found.detours == ()


@pytest.mark.long
def test_a_line_that_is_blocked_from_one_rail_position_is_driven_from_another() -> None:
    bare = plan("down", Target.RAPID)
    assert isinstance(bare, Plan)
    at = float(bare.motions[0].q_1[0])
    program, plant = CASES["down"]
    p_elbow = plant.robot.forward(bare.motions[0].q_1)[:3, 3] * [0.55, 0.5, 0] + [0, 0.5 * at, 0.72]
    beam = box("beam", (0.08, 0.08, 0.3), tuple(p_elbow))
    found = plan("down", Target.RAPID, beam)
    assert isinstance(found, Plan)
    blocked = replace(plant, obstacles=(beam,), clearance=WANTED)
    assert least_along(blocked, bare.trajectory) < 0
    assert least_along(blocked, found.trajectory) >= 0
    judged("down", found, beam)
    assert abs(float(found.motions[1].q_0[0]) - at) > 0.02
    lines = [motion for motion in found.motions if not isinstance(program.motions[motion.index], MoveJ)]
    assert not any(motion.via for motion in lines)


def test_a_place_that_is_blocked_everywhere_is_named_with_what_is_in_it() -> None:
    found = plan("down", Target.RAPID, box("block", (0.2, 0.2, 0.1), (0.5, 0.6, 0.36)))
    assert isinstance(found, Infeasible)
    assert found.index == 1
    assert "MoveL p_low cannot be driven clear: link_6 is" in found.message
    assert "mm inside 'block'; tried from rail" in found.message


def test_a_start_in_something_is_said() -> None:
    found = plan("across", Target.STREAM, box("post", (0.2, 0.2, 1.0), (0.45, 0.0, 0.5)))
    assert isinstance(found, Infeasible)
    assert "the start cannot be clear" in found.message


@pytest.mark.parametrize(("more", "planned"), [(2e-5, True), (-2e-5, False), (1e-6, False)])
def test_a_place_a_hair_beyond_the_clearance_is_planned(more: float, planned: bool) -> None:
    """Link 1 stands all the time, its foremost face at x = 0.193 m, less than the planner's reserve too far away."""
    block = box("block", (0.1, 0.1, 0.1), (0.193 + WANTED + more + 0.05, 0.0, 0.25))
    found = plan("nod", Target.RAPID, block)
    assert isinstance(found, Plan) is planned, found
    if isinstance(found, Plan):
        judged("nod", found, block)


def test_a_move_that_can_have_no_points_is_driven_in_another_configuration() -> None:
    program, plant = CASES["across"]
    plant = replace(plant, obstacles=(POST,), clearance=WANTED)
    free = everything(program, plant)
    changes = replace(free, detours=(), straight={1: "its text is fixed"})
    found = optimize(program, plant, Target.RAPID, bounded=False, changes=changes)
    assert isinstance(found, Plan)
    assert found.detours == ()
    judged("across", found, POST)


def test_the_program_as_written_is_driven_as_it_is() -> None:
    program, plant = CASES["across"]
    posted = replace(plant, obstacles=(POST,), clearance=WANTED)
    bare, found = (optimize(program, one, Target.RAPID, AS_WRITTEN, bounded=False) for one in (plant, posted))
    assert isinstance(bare, Plan)
    assert isinstance(found, Plan)
    assert bare.trajectory.q.tobytes() == found.trajectory.q.tobytes()


def test_ways_between_places_are_clear_and_hardly_longer() -> None:
    plant = replace(plant_without_rail(), obstacles=(POST,), clearance=WANTED)
    axes, around = Axes.of(plant), CollisionScene(plant, ACROSS)
    q = np.array([[-0.6, 0.5, 0.1, 0, 0.9, 0], [0.6, 0.5, 0.1, 0, 0.9, 0]])
    assert around.free(q, 0).all()
    assert not around.free_between(q[:1], q[1:], 0).any()
    found = [Roadmap(axes, around, 0, lambda x: np.ones(len(x), dtype=bool)).between(*q) for _ in range(2)]
    assert found[0] is not None
    assert found[1] is not None
    np.testing.assert_array_equal(*found)
    way = np.concatenate([q[:1], found[0], q[1:]])
    assert around.way_free(way, 0)
    assert len(found[0]) <= 2
    assert about(axes, way[None])[0] < 1.5 * about(axes, q[None])[0]


def test_a_state_that_joins_a_known_way_is_looked_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    plant = replace(plant_without_rail(), obstacles=(POST,), clearance=WANTED)
    axes, around = Axes.of(plant), CollisionScene(plant, ACROSS)
    leg, rng = problem_of(ACROSS, plant, Target.RAPID).legs[1], np.random.default_rng(5)
    avoid, points = EdgeCollision(axes, around, {}), rng.uniform(-0.5, 0.5, (2, 6))
    q = np.repeat(np.array([[-0.6, 0.5, 0.1, 0, 0.9, 0]]) + rng.uniform(-1, 1, (40, 6)), 2, axis=0)
    ends = {end: np.tile(points[end], (len(q), 1)) for end in (0, -1)}
    wanted = {0: around.free_between(q, ends[0], 1), -1: around.free_between(ends[-1], q, 1)}
    assert 0 < wanted[0].sum() < len(q)
    asked: list[int] = []
    look = around.free_between

    def counted(q_0: Array, q_1: Array, index: int) -> BoolArray:
        asked.append(len(q_0))
        return look(q_0, q_1, index)

    monkeypatch.setattr(around, "free_between", counted)
    for _ in range(2):
        for end in (0, -1):
            np.testing.assert_array_equal(avoid._joins(leg, points, end, q), wanted[end])
    assert sum(asked) == 2 * 40
    assert avoid._joins(leg, points, 0, q[:0]).shape == (0,)


def test_passes_that_share_a_text_go_by_the_same_points() -> None:
    program, plant = ACROSS_TWICE, replace(plant_without_rail(), obstacles=(POST,), clearance=WANTED)
    groups = ((0, 2), (1, 3))
    changes = replace(everything(program, plant), ties=groups, detours=groups)
    found = optimize(program, plant, Target.RAPID, bounded=False, changes=changes)
    assert isinstance(found, Plan)
    points = {detour.motion: np.array([via.q for via in detour.points]) for detour in found.detours}
    assert points
    assert len(found.notes) == len({*found.notes}) < len(points)  # a text's passes are told once
    for first, second in groups:
        assert (first in points) == (second in points)
        if first in points:
            np.testing.assert_array_equal(points[first], points[second])
    assert least_along(plant, found.trajectory) >= 0


def test_a_place_behind_a_wall_is_named_with_the_rail_positions_that_were_tried(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    set_defaults(monkeypatch, detour_tree=10)
    monkeypatch.setattr(edge_collision, "_AVOID_FAILURES", 2)
    wall = box("wall", (3.0, 0.1, 3.0), (0.0, 0.35, 0.5))  # across the rail
    found = plan("there", Target.RAPID, wall)
    assert isinstance(found, Infeasible)
    assert found.index == 0
    assert re.search(r"MoveJ p_in cannot be driven clear: \w+ is [\d.]+ mm inside 'wall'", found.message)
    told = re.search(r"no way around was found, tried from rail (-?\d+) to (\d+) mm, (\d+) positions", found.message)
    assert told is not None, found.message
    low, high, count = map(int, told.groups())
    assert -400 < low < 600 < high < 1600  # p_in is at y = 600 mm, and the arm reaches 0.8 m
    assert count > 5


CORNER = """CONST robtarget p_1:=[[550,-100,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_2:=[[550,350,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_3:=[[150,350,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
STAKE = Solid(Capsule("stake", np.array([0.45, 0.25, -0.2]), np.array([0.45, 0.25, 0.43]), 0.04))


def in_a_corner(zone: str, target: Target) -> Plan | Infeasible:
    moves = f"MoveJ p_1,v1000,fine,tool0;\nMoveL p_2,v1000,{zone},tool0;\nMoveL p_3,v1000,fine,tool0;"
    program = rapid(f"ConfJ \\Off;\nConfL \\Off;\n{moves}", data=CORNER)
    return optimize(program, plant_without_rail(obstacles=(STAKE,), clearance=0.005), target, bounded=False)


@pytest.mark.parametrize("target", Target)
def test_a_corner_that_cuts_into_something_is_told_with_the_zone_that_would_do(target: Target) -> None:
    found = in_a_corner("z200", target)
    assert isinstance(found, Infeasible)
    assert "MoveL p_3 cannot be driven clear: " in found.message  # in the latter half of the corner
    assert "'stake'" in found.message
    assert found.message.endswith("it would be clear with z150 instead of z200 at p_2")
    assert isinstance(in_a_corner("z150", target), Plan)


def test_no_zone_is_named_where_none_would_do() -> None:
    moves = "MoveJ p_1,v1000,fine,tool0;\nMoveL p_2,v1000,z50,tool0;\nMoveL p_3,v1000,fine,tool0;"
    program = rapid(f"ConfJ \\Off;\nConfL \\Off;\n{moves}", data=CORNER)
    block = box("block", (0.1, 0.1, 0.1), (0.55, 0.35, 0.5))  # at the point itself
    found = optimize(program, plant_without_rail(obstacles=(block,)), Target.RAPID, bounded=False)
    assert isinstance(found, Infeasible)
    assert "instead of" not in found.message


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_a_held_rail_stands_on_the_way_around_too(target: Target, unrefined: None) -> None:
    """The post is between the two points, and the rail would swerve for it if it might."""
    data = """CONST robtarget p_a:=[[450,-150,250],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_b:=[[450,350,250],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,9E9]];"""
    body = r"ConfJ \Off; DeactUnit TRACK1; MoveJ p_a, v1000, fine, tool0; MoveJ p_b, v1000, fine, tool0;"
    program = rapid(body, Scenario(rail=RailUnit(0, "TRACK1")), data)
    plant = plant_with_rail(obstacles=(box("post", (0.6, 0.04, 0.33), (0.6, 0.15, 0.165)),))
    found = optimize(program, plant, target, bounded=False)
    assert isinstance(found, Plan)
    there, dropped = held_against(program, plant, target, found.detours, ())
    report = verify(there, plant, found.trajectory, None, dropped, target, advice=False)
    assert report.legal, [one for one in report.findings if not one.passed]
    assert least_along(plant, found.trajectory) >= -1e-4
