"""Programs that name a place once more, wait for a microsecond or creep are improved like others, window by window."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from small_cells import down, plant_with_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.judge.verify import verify
from trajopt_cli.nlp.mesh_refinement import on_grid
from trajopt_cli.path_timing.path_parameterized_plan import timed
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.settings import DEFAULT
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import JointNodes, PathLeg

pytestmark = pytest.mark.usefixtures("coarse")

THERE, BACK = "MoveJ p_in, v2500, fine, tool0;", "MoveAbsJ j_home, v2500, fine, tool0;"
PLAIN = f"{THERE} MoveL p_low, v200, fine, tool0; {BACK}"
CREEPING = "MoveJ p_in, v20, fine, tool0; MoveAbsJ j_home, v2500, fine, tool0;"


@pytest.fixture(scope="module")
def plant() -> Plant:
    return plant_with_rail((-0.16, 0.8))


@cache
def stream(text: str, plant: Plant) -> Plan:
    program = rapid(text)
    plan = optimize(program, plant, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=Target.STREAM, advice=False)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    return plan


@cache
def driven(text: str, plant: Plant) -> Plan:
    plan = optimize(rapid(text), plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    return plan


@pytest.mark.parametrize("text", [PLAIN.replace(THERE, 4 * THERE), PLAIN.replace(THERE, f"{THERE} WaitTime 0.000001;")])
def test_what_takes_no_time_costs_no_time(text: str, plant: Plant) -> None:
    plain, odd = stream(PLAIN, plant), stream(text, plant)
    controller = driven(PLAIN, plant)
    assert plain.duration < 0.995 * controller.duration  # or there was nothing to be found
    assert odd.duration == pytest.approx(plain.duration, rel=1e-3)
    assert not odd.notes


def test_a_creeping_joint_move_goes_nearly_straight(plant: Plant) -> None:
    v = 0.05  # m/s
    slow = CREEPING.replace("v20", "v50")
    plan = stream(slow, plant)
    assert not plan.notes
    chord = np.linalg.norm(down(0.5, 0.6, 0.45)[:3, 3] - plant.robot.forward(plant.start)[:3, 3])
    way = plan.motions[0].t_1 - plan.motions[0].t_0
    assert chord / v < way < driven(slow, plant).motions[0].t_1
    assert way < 1.01 * chord / v


def test_the_last_grid_is_fine_where_a_slow_motion_changes(plant: Plant) -> None:
    axes, problem = Axes.of(plant), problem_of(rapid(f"{CREEPING[:30]} MoveL p_low, v20, fine, tool0;"), plant)
    route = search(axes, problem)
    assert route is not None
    legal = timed(axes, problem, route)
    joint, line = on_grid(axes, problem, legal).legs
    assert isinstance(joint, JointNodes)
    assert isinstance(line, PathLeg)
    for motion in (joint, line):
        steps = np.diff(motion.grid)
        assert motion.grid[[0, -1]].tolist() == [0.0, 1.0]
        assert steps[[0, -1]].max() < 0.2 / motion.N
        assert steps.max() < 4 / motion.N
    assert pytest.approx(float(trapezoid_time(0.06, 0.02, 20.0)), rel=3e-3) == line.T


ALONG = """CONST robtarget p_a:=[[500,0,400],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_b:=[[500,750,400],[0,0,1,0],[0,0,0,0],[750,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_v:=[[550,375,400],[0,0,1,0],[0,0,0,0],[375,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_r:=[[500,0,400],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_far:=[[500,1376.05,400],[0,0,1,0],[0,0,0,0],[750,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_near:=[[500,-700,400],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST speeddata slow:=[1000,500,100,10];"""
RAIL = 7.5 + 0.1 / 3  # s for 750 mm at 100 mm/s, rest to rest at 3 m/s2


@pytest.mark.parametrize(
    ("move", "least", "binding"),
    [
        ("MoveL p_b, slow, fine, tool0;", RAIL, "programmed rail speed"),
        ("MoveC p_v, p_b, slow, fine, tool0;", RAIL, "programmed rail speed"),
        (r"MoveL p_b, v2500\T:=9, fine, tool0;", 9.0, "programmed duration"),
        ("VelSet 2, 5000; MoveL p_b, [5000,500,5000,10], fine, tool0;", RAIL, "programmed rail speed"),
        (
            r"PathAccLim TRUE \AccMax:=0.1, TRUE \DecelMax:=0.1; MoveL p_b, v2500, fine, tool0;",
            2 * 7.5**0.5,
            "TCP acceleration",
        ),
        ("MoveL p_r, slow, fine, tool0;", 3.0 + 0.1 / 3, "programmed rail speed"),
    ],
)
def test_a_limit_that_slows_a_line_is_no_want_of_reach(move: str, least: float, binding: str, plant: Plant) -> None:
    """As written, the rail going along or alone: it takes as long as the slowest limit asks."""
    asked = rapid(rf"ConfJ \Off; ConfL \Off; MoveJ p_a, v2500, fine, tool0; {move}", data=ALONG)
    plan = optimize(asked, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    line = plan.motions[-1]
    assert line.t_1 - line.t_0 == pytest.approx(least, rel=1e-3)
    assert line.binding == binding
    assert verify(asked, plant, plan.trajectory, target=Target.RAPID, advice=False).legal


def test_a_rail_that_must_go_far_slowly_is_no_want_of_reach(plant: Plant) -> None:
    """Both ends are out of reach from any one place of a free rail, which has half a minute to go."""
    text = r"ConfJ \Off; ConfL \Off; MoveJ p_near, v2500, fine, tool0; MoveL p_far, [1000,500,20,10], fine, tool0;"
    plan = optimize(rapid(text, data=ALONG), plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan), plan
    line = plan.motions[-1]
    way = np.ptp(plan.trajectory.q[plan.trajectory.t >= line.t_0, 0])
    assert way / 0.02 < line.t_1 - line.t_0 < 1.1 * way / 0.02


def test_a_line_to_the_nearly_stretched_arm_is_slow_not_out_of_reach(plant: Plant) -> None:
    """The rail is given: 0.1 mm of reach are left, and the distance that a free rail keeps is not asked."""
    text = r"ConfJ \Off; ConfL \Off; MoveJ p_b, v2500, fine, tool0; MoveL p_far, v2500, fine, tool0;"
    plan = optimize(rapid(text, data=ALONG), plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    assert plant.robot.singularity_margins(plan.trajectory.q[-1:, 1:])[0][0] > DEFAULT.elbow


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_a_rail_without_a_speed_stands(target: Target, plant: Plant) -> None:
    """v_leax 0 on two lines, v_ori 0 on one and on a joint move that ends with the orientation it begins with: the rail
    stands on them, and the judge sees where it does not."""
    data = ALONG.replace("p_b:=[[500,750,400],[0,0,1,0],[0,0,0,0],[750", "p_b:=[[500,150,400],[0,0,1,0],[0,0,0,0],[0")
    text = r"ConfJ \Off; ConfL \Off; MoveJ p_a, v500, fine, tool0; MoveL p_b, [200,0,0,0], z20, tool0;"
    text += "MoveL p_a, [200,500,0,0], fine, tool0; MoveJ p_b, [500,0,500,0], fine, tool0;"
    asked = rapid(text, data=data)
    plan = optimize(asked, plant, target, bounded=False)
    assert isinstance(plan, Plan), plan
    assert verify(asked, plant, plan.trajectory, target=target, advice=False).legal
    line, rows = plan.motions[1], plan.trajectory
    there = (rows.t >= line.t_0) & (rows.t <= plan.motions[2].t_1)
    assert np.ptp(rows.q[there, 0]) < 1e-9
    if target is Target.STREAM:
        return  # the judge sees the same of both
    moving = ALONG.replace(
        "p_b:=[[500,750,400],[0,0,1,0],[0,0,0,0],[750", "p_b:=[[500,150,400],[0,0,1,0],[0,0,0,0],[50"
    )
    free = optimize(rapid(text.replace(",0,0]", ",500,0]"), data=moving), plant, target, AS_WRITTEN, bounded=False)
    assert isinstance(free, Plan)
    found = verify(asked, plant, free.trajectory, target=target, advice=False).findings
    assert {f.check for f in found if not f.passed and f.subject == "rail"} == {"programmed speed"}
