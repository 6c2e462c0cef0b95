"""Programs that name a place once more, wait for a microsecond or creep are improved like others, window by window."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from small_cells import down, plant_with_rail, problem_of, rapid

from trajopt_cli.optimize import optimize
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.double_integrator import trapezoid_time
from trajopt_cli.optimize.driver import on_grid
from trajopt_cli.optimize.incumbent import timed
from trajopt_cli.optimize.legs import JointNodes, PathLeg
from trajopt_cli.optimize.search import search
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.verify.judge import verify

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
    chain = search(axes, problem)
    assert chain is not None
    legal = timed(axes, problem, chain)
    joint, line = on_grid(axes, problem, legal).legs
    assert isinstance(joint, JointNodes)
    assert isinstance(line, PathLeg)
    for motion in (joint, line):
        steps = np.diff(motion.grid)
        assert motion.grid[[0, -1]].tolist() == [0.0, 1.0]
        assert steps[[0, -1]].max() < 0.2 / motion.N
        assert steps.max() < 4 / motion.N
    assert pytest.approx(float(trapezoid_time(0.06, 0.02, 20.0)), rel=3e-3) == line.T
