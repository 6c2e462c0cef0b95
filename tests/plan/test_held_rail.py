"""Plans in which the rail must stand still on some legs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid
from unrefined import IMPROVED, as_it_comes

from trajopt_cli.graph_search.search import search
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.trajectories.axes import Axes

pytestmark = pytest.mark.usefixtures("coarse")

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
def test_a_held_rail_stands_still_on_joint_moves_lines_and_waits(
    target: Target, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In every row, to rounding; without the comments it moves there, and even the first legal motion is faster."""
    held = solved(rapid(BODY), target)
    monkeypatch.setattr(IMPROVED, as_it_comes)
    free = solved(rapid(BODY.replace("! trajopt: hold rail", "")), target)
    for plan, still in ((held, True), (free, False)):
        first, last = plan.motions[1], plan.motions[3]
        rail = plan.trajectory.q[(plan.trajectory.t >= first.t_0) & (plan.trajectory.t <= last.t_1), 0]
        assert (np.ptp(rail) <= 1e-9) == still
    assert free.duration < held.duration


def test_a_line_there_and_back_has_other_rail_positions_each_way() -> None:
    """As a rule or a text may give them; the times of the way there say nothing of the way back then."""
    moves = "MoveJ p_in, v2500, fine, tool0; MoveL p_low, v500, fine, tool0; MoveL p_in, v500, fine, tool0;"
    program, plant = rapid(moves), plant_with_rail()
    problem = problem_of(program, plant)
    rails = iter((0.55, 0.6, 0.65))
    points = [replace(one, rail=(d, d)) if one.q is None and (d := next(rails)) else one for one in problem.waypoints]
    given = replace(problem, waypoints=tuple(points))
    route = search(Axes.of(plant), given)
    assert route is not None
    np.testing.assert_allclose(plant.layout.place(route.q)[1:], (0.55, 0.6, 0.65))
