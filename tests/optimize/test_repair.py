"""A plan is repaired where it is broken, and stays as it is elsewhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, timed
from trajopt_cli.plan.detour_planner import coordinated
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.plan.repair import timed_in_time
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import LegKind
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_legs

TWO_WAITS = """MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v300, fine, tool0;
WaitTime 0.5;
MoveL p_in, v300, fine, tool0;
WaitTime 0.4;
MoveAbsJ j_far, v2500, fine, tool0;"""
FAR = "CONST jointtarget j_far:=[[0,0,0,0,30,0],[2000,9E9,9E9,9E9,9E9,9E9]];"


def with_rail(plant: Plant, times: float) -> Plant:
    limits = plant.limits
    faster = np.r_[times, np.ones(6)]
    return replace(
        plant, limits=replace(limits, velocity=limits.velocity * faster, acceleration=limits.acceleration * faster)
    )


@pytest.mark.parametrize("target", Target)
@pytest.mark.parametrize("times", [1.01, 1.3])
def test_a_way_in_a_wait_that_is_too_far_is_shortened_to_what_the_rail_can(target: Target, times: float) -> None:
    """A rail from rest to rest in T goes A T^2 / 4. Red where only the whole plan falls back, or the way is dropped."""
    plant, program = plant_with_rail((-0.2, 2.4)), rapid(TWO_WAITS, data=FAR)
    problem, faster = (coordinated(problem_of(program, one, target)) for one in (plant, with_rail(plant, times)))
    quick, axes = Axes.of(faster.plant), Axes.of(plant)
    chain = search(quick, faster)
    assert chain is not None
    chain = refine_rail(quick, faster, chain)
    with pytest.raises(NotDriven):
        timed(axes, problem, chain)
    shorter, draft = timed_in_time(axes, problem, chain, None, axes, Times())
    waits = [k for k, leg in enumerate(problem.legs) if leg.kind is LegKind.DWELL]
    assert len(waits) == 2
    for k in waits:
        most = 3.0 * (problem.legs[k].duration or 0.0) ** 2 / 4
        assert 0.97 * most < shorter.q[k + 1, 0] - shorter.q[k, 0] <= most * (1 + 1e-9)
        assert problem.legs[k].duration == draft.legs[k].T
    assert all(one.worst <= 1 + 1e-6 for one in check_legs(axes, problem.legs, draft.legs))
