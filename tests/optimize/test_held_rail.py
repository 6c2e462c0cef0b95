"""Plans in which the rail must stand still on some legs."""

from __future__ import annotations

import numpy as np
import pytest
from small_cells import plant_with_rail, rapid

from trajopt_cli.motion import Program
from trajopt_cli.optimize import optimize
from trajopt_cli.problem.plan import Plan, Target

BODY = """MoveJ p_in, v2500, fine, tool0;
MoveJ Offs(p_low,0,400,0), v2500, fine, tool0; ! trajopt: hold rail
MoveL Offs(p_low,0,300,0), v1000, fine, tool0; ! trajopt: hold rail
WaitTime 0.2; ! trajopt: hold rail
MoveAbsJ j_home, v1000, fine, tool0;"""


def solved(program: Program, target: Target) -> Plan:
    plan = optimize(program, plant_with_rail(), target, bounded=False)
    assert isinstance(plan, Plan)
    return plan


@pytest.mark.parametrize("target", Target)
def test_a_held_rail_stands_still_on_joint_moves_lines_and_waits(target: Target) -> None:
    """In every row, to rounding; without the comments it moves there, and the plan is faster."""
    held, free = solved(rapid(BODY), target), solved(rapid(BODY.replace("! trajopt: hold rail", "")), target)
    for plan, still in ((held, True), (free, False)):
        first, last = plan.motions[1], plan.motions[3]
        rail = plan.trajectory.q[(plan.trajectory.t >= first.t_0) & (plan.trajectory.t <= last.t_1), 0]
        assert (np.ptp(rail) <= 1e-9) == still
    assert free.duration < held.duration
