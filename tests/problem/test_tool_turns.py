"""Which targets may be turned together, against what slerp makes of their orientations (scipy)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from small_cells import plant_without_rail, problem_of, rapid

from trajopt_cli.motion import FreeTurn, PoseMove, Program
from trajopt_cli.path.line import Line
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.problem import TurnRoom
from trajopt_cli.problem.tool_turns import TurnGroups, keeps_axis, turn_groups, turned, turned_motion, with_room_to_turn
from trajopt_cli.scenario import FreeTool, Scenario
from trajopt_cli.warnings import Source

Z = (0.0, 0.0, 1.0)
FREE = FreeTurn(Z, -3.0, 3.0)
E = "[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]"
DATA = f"""CONST robtarget p_1:=[[500,0,450],[0,0,1,0],{E}]; CONST robtarget p_2:=[[500,50,450],[0,0,1,0],{E}];
CONST robtarget p_3:=[[500,100,450],[0,0.0871557,0.9961947,0],{E}];
CONST robtarget p_t:=[[500,150,450],[0.0871557,0,0.9961947,0],{E}];"""


def groups(body: str, free: FreeTurn = FREE, **more: object) -> TurnGroups:
    program = free_program(body, free)
    plant = plant_without_rail()
    return turn_groups(problem_of(program, plant, **more), everything(program, plant))


def free_program(body: str, free: FreeTurn = FREE) -> Program:
    return rapid(body, Scenario(free=(FreeTool(free, Source("cell.yaml", 3, 1)),)), DATA)


def together(found: TurnGroups) -> list[tuple[int, ...]]:
    return [group.waypoints for group in found.groups]


def test_lines_of_one_axis_turn_apart_and_waits_with_their_stop() -> None:
    found = groups("MoveJ p_1,v100,fine,tool0;\nMoveL p_2,v100,fine,tool0;\nWaitTime 0.2;\nMoveL p_3,v100,fine,tool0;")
    assert together(found) == [(1,), (2, 3), (4,)]
    assert found.apart == {1, 3}


def test_lines_that_tilt_turn_alike() -> None:
    body = (
        "MoveJ p_2,v100,fine,tool0;\nMoveL p_t,v100,fine,tool0;\nMoveL p_1,v100,z10,tool0;\nMoveJ p_3,v100,fine,tool0;"
    )
    assert together(groups(body)) == [(1, 2, 3), (4,)]


def test_lines_from_joints_and_lines_that_only_turn_stay_as_taught() -> None:
    home = "MoveAbsJ j_home,v100,fine,tool0;"
    assert together(groups(f"{home}\nMoveL p_t,v100,fine,tool0;\nMoveJ p_1,v100,fine,tool0;")) == [(3,)]
    body = "MoveJ p_1,v100,fine,tool0;\nMoveL RelTool(p_1,0,0,0\\Rz:=40),v100,fine,tool0;\nMoveJ p_2,v100,fine,tool0;"
    assert together(groups(body)) == [(3,)]


def test_no_turn_without_leave() -> None:
    program = rapid("MoveJ p_1,v100,fine,tool0;", None, DATA)
    assert (
        turn_groups(problem_of(program, plant_without_rail()), everything(program, plant_without_rail())).groups == ()
    )


@pytest.mark.parametrize("turns", [(0.7, 0.7), (-0.4, 1.2)])
@pytest.mark.parametrize("ends", [("p_1", "p_3"), ("p_2", "p_t")])
def test_the_axis_is_kept_where_slerp_keeps_it(ends: tuple[str, str], turns: tuple[float, float]) -> None:
    body = "\n".join(f"{move} {p},v100,fine,tool0;" for move, p in zip(("MoveJ", "MoveL"), ends, strict=True))
    found = groups(body)
    program = turned(found.problem.program, dict(enumerate(turns)))
    before = found.problem.legs[1]
    X = [motion.X_WT for motion in program.motions if isinstance(motion, PoseMove)]
    assert [motion.turn for motion in program.motions if isinstance(motion, PoseMove)] == [*turns]
    s = np.linspace(0, 1, 7)
    slerp = Slerp([0, 1], Rotation.from_matrix([x[:3, :3] for x in X]))(s).as_matrix()
    kept = np.abs(slerp[:, :, 2] - before.segment.pose(s)[:, :3, 2]).max() < 1e-7  # type: ignore[union-attr]
    assert kept == (ends == ("p_1", "p_3") or turns[0] == turns[1])
    assert keeps_axis(before, replace(before, segment=Line(*X)), FREE) == kept
    if len(found.groups) == 2 or turns[0] == turns[1]:
        angles = np.array(turns[: len(found.groups)])
        leg = found.leg(1, found.waypoint(1, angles[0]), angles[-1])
        assert leg.segment is not None
        assert leg.segment.pose(s)[:, :3, :3] == pytest.approx(slerp, abs=1e-9)


def test_turning_back_is_as_taught() -> None:
    (motion,) = free_program("MoveJ p_3,v100,fine,tool0;").motions
    assert isinstance(motion, PoseMove)
    back = turned_motion(turned_motion(motion, 0.8), -0.8)
    assert isinstance(back, PoseMove)
    assert pytest.approx(motion.X_WT, abs=1e-12) == back.X_WT
    assert back.turn == 0.0
    assert turned_motion(motion, 0.8).X_WT[:3, 2:] == pytest.approx(motion.X_WT[:3, 2:])  # type: ignore[union-attr]


def test_a_stream_has_room_for_turns_of_their_own_at_both_ends_of_a_tilting_line() -> None:
    """What is left of the sector beyond the turns at hand, evenly from end to end; none beside joints, on a line that
    only turns the tool, and where another tool comes."""
    home = "MoveAbsJ j_home,v100,fine,tool0;"
    body = f"""MoveJ p_2,v100,fine,tool0; MoveL p_t,v100,fine,tool0; WaitTime 0.2; MoveL p_1,v100,fine,tool0;
{home} MoveL p_1,v100,fine,tool0; MoveL RelTool(p_1,0,0,0\\Rz:=40),v100,fine,tool0; MoveJ p_2,v100,fine,tool0;
MoveL p_1,v100,fine,tOther;""".replace("\\\\", "\\")
    other = "PERS tooldata tOther:=[TRUE,[[0,10,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];"
    scenario = Scenario(free=(FreeTool(FREE, Source("cell.yaml", 3, 1)),))
    program = turned(rapid(body, scenario, DATA + other), {0: 1.0, 1: 1.5})
    problem = problem_of(program, plant_without_rail())
    found = with_room_to_turn(problem, everything(program, plant_without_rail()))
    rooms = [None if one.turn is None else (one.turn.low, one.turn.high) for one in found.waypoints]
    assert rooms == [None, (-4, 2), (-4.5, 1.5), (-4.5, 1.5), (-3, 3), None, None, None, None, (-3, 3)]
    rooms = [None if one.turn is None else (one.turn.low, one.turn.high, one.turn.slope) for one in found.legs]
    tilting, back = (-4, 2, 0.5), (-4.5, 1.5, -1.5)
    assert rooms == [None, tilting, (-4.5, 1.5, 0), back, None, (-3, 3, 0), None, None, (-3, 3, 0)]
    part = found.legs[1].turn.between(0.2, 0.6)  # type: ignore[union-attr]
    assert (part.low, part.high, part.slope) == pytest.approx((-4.1, 1.9, 0.2))


def test_room_to_turn_knows_what_turns_from_a_pose() -> None:
    """A turn about a tool's own axis, by scipy; told from the pose that it leads to."""
    rng = np.random.default_rng(4)
    for _ in range(20):
        X_FT, X_WF, turned_by = np.eye(4), np.eye(4), rng.uniform(-3, 3)
        X_FT[:3, :3], X_WF[:3, :3] = Rotation.random(2, random_state=rng).as_matrix()
        X_FT[:3, 3], X_WF[:3, 3] = rng.normal(size=(2, 3))
        room = TurnRoom(np.array([0.0, 0.6, 0.8]), X_FT, -3.0, 3.0)
        X = room.turned(X_WF, turned_by)
        relative = np.linalg.inv(X_WF @ X_FT) @ X @ X_FT
        expected = Rotation.from_rotvec(turned_by * room.axis).as_matrix()
        np.testing.assert_allclose(relative, np.block([[expected, np.zeros((3, 1))], [0, 0, 0, 1]]), atol=1e-12)
        assert room.angle(X_WF, X) == pytest.approx(turned_by, abs=1e-9)
