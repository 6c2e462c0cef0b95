"""Which fly-bys are passed: as the program and the cell say, and where a held rail begins or ends they are stops."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.pipeline.optimize import fly_bys_told
from trajopt_cli.problem.corners import corners_of, passed_in
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.trajectory import Trajectory

BODY = """MoveJ p_in, v500, z50, tool0;
MoveL Offs(p_in,0,0,-60), v500, z10, tool0;
MoveL Offs(p_in,0,80,-60), v500, z20, tool0;
WaitTime 0.2;
MoveL p_in, v500, z1, tool0;"""


def test_passed_and_stopped_by_the_index_of_the_motion() -> None:
    found = corners_of(rapid(BODY), plant_with_rail())
    assert dict(found.stopped) == {2: "a wait follows", 4: "no move follows"}
    # z50 at half of the 60 mm line, z10 as it is
    assert {k: round(one.radius, 9) for k, one in found.passed.items()} == {0: 0.03, 1: 0.01}
    assert list(fly_bys_told(found)) == [
        "2 fly-by points are passed in corners: cycle times of programs with corners are for parabolic corners",
        "2 fly-by points are stops: a wait follows (1), no move follows (1)",
    ]
    said = "the stream plan stops at 1 of them: joint moves between stops may bend"
    assert said in fly_bys_told(found, {Target.STREAM: {1}, Target.RAPID: {0, 1}})


def test_without_a_motion_its_neighbours_are_others() -> None:
    found = corners_of(rapid(BODY), plant_with_rail(), dropped={1})
    assert {k: round(one.radius, 9) for k, one in found.passed.items()} == {0: 0.05}
    assert set(found.stopped) == {2, 4}


@pytest.mark.parametrize("rail", [True, False])
def test_a_hold_that_begins_or_ends_makes_a_stop_where_there_is_a_rail(rail: bool) -> None:
    lines = BODY.splitlines()
    held = "\n".join([lines[0], f"{lines[1]} ! trajopt: hold rail", *lines[2:]])
    plant = plant_with_rail() if rail else plant_without_rail()
    found = corners_of(rapid(held), plant)
    assert set(found.passed) == (set() if rail else {0, 1})
    whys = {0: "a rail hold begins there", 1: "a rail hold ends there"} if rail else {}
    assert {k: why for k, why in found.stopped.items() if k < 2} == whys
    if rail:
        problem = problem_of(rapid(held), plant)
        assert [problem.passes(k) for k in range(len(problem.waypoints))] == [False] * 6


def test_a_program_without_fly_bys_is_told_nothing() -> None:
    found = corners_of(rapid("MoveJ p_in, v500, fine, tool0;"), plant_with_rail())
    assert list(fly_bys_told(found)) == []


def test_a_plan_passes_what_it_does_not_stop_at() -> None:
    """Straight on through a fly-by the axes are at its point, and move; the same rows at rest there are a stop."""
    program = rapid("MoveL Offs(p_in,0,0,-60), v500, z10, tool0;\nMoveL Offs(p_in,0,0,-120), v500, fine, tool0;")
    plant = plant_without_rail()
    q = plant.start + np.outer([0.0, 0.1, 0.2], [1.0, 0, 0, 0, 0, 0])
    names, t = plant.robot.axis_names, np.array([0.0, 1.0, 2.0])
    still = np.zeros((3, 6))
    moving = still.copy()
    moving[1, 0] = 0.1
    sources = [motion.source for motion in program.motions]
    motions = tuple(PlannedMotion(i, sources[i], t[i], t[i + 1], q[i], q[i + 1], "") for i in range(2))
    found = [
        passed_in(program, plant, Plan(Target.STREAM, Trajectory(names, t, q, qd), motions, None, ""))
        for qd in (moving, still)
    ]
    assert found == [{0}, set()]
    beside = tuple(replace(motion, q_1=motion.q_1 + 1e-3) for motion in motions)
    plan = Plan(Target.STREAM, Trajectory(names, t, q, still), beside, None, "")
    assert passed_in(program, plant, plan) == {0}


def test_corners_where_the_tool_changes_are_told() -> None:
    grip = "PERS tooldata grip:=[TRUE,[[0,0,50],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];"
    body = BODY.replace("z10, tool0", "z10, grip")
    found = corners_of(rapid(body, data=grip), plant_with_rail())
    assert {k: one.joint for k, one in found.passed.items()} == {0: True, 1: True}
    assert any("2 of 2 corners" in line for line in fly_bys_told(found))
