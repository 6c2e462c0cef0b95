"""A plan is repaired where it is broken, and stays as it is elsewhere."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import Grids, MeshRefinement, NotConverged, first_iterate
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, timed
from trajopt_cli.plan.detour_planner import coordinated
from trajopt_cli.plan.initial_plan import InitialPlan
from trajopt_cli.plan.local_refinement import refine
from trajopt_cli.plan.output_rows import rows_of
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.plan.repair import timed_in_time, with_legal_rows
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import LegKind
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_legs
from trajopt_cli.trajectories.iterate import Iterate, Margins
from trajopt_cli.trajectory import Trajectory

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
    route = search(quick, faster)
    assert route is not None
    route = refine_rail(quick, faster, route)
    with pytest.raises(NotDriven):
        timed(axes, problem, route)
    shorter, iterate = timed_in_time(axes, problem, route, None, axes, Times())
    waits = [k for k, leg in enumerate(problem.legs) if leg.kind is LegKind.DWELL]
    assert len(waits) == 2
    for k in waits:
        most = 3.0 * (problem.legs[k].duration or 0.0) ** 2 / 4
        assert 0.97 * most < shorter.q[k + 1, 0] - shorter.q[k, 0] <= most * (1 + 1e-9)
        assert problem.legs[k].duration == iterate.legs[k].T
    assert all(one.worst <= 1 + 1e-6 for one in check_legs(axes, problem.legs, iterate.legs))


def accelerations(trajectory: Trajectory) -> np.ndarray:
    """Of the cubics between rows, at both ends of each (2, rows - 1, n)."""
    assert trajectory.qd is not None
    h = np.diff(trajectory.t)[:, None]
    slope, before, behind = np.diff(trajectory.q, axis=0) / h, trajectory.qd[:-1], trajectory.qd[1:]
    return np.stack([6 * slope - 4 * before - 2 * behind, 2 * before + 4 * behind - 6 * slope]) / h


@pytest.mark.usefixtures("coarse")
@pytest.mark.parametrize("in_motion", [False, True])
def test_rows_that_pass_a_limit_are_mended_where_they_do(in_motion: bool) -> None:
    """The limits are lowered by a hair behind the planner's back. Red where the whole plan is slowed, which makes
    speeds jump where a wait begins in motion, and where nothing is mended."""
    plant = plant_with_rail((-0.2, 2.4))
    axes, problem = Axes.of(plant), problem_of(rapid(TWO_WAITS, data=FAR), plant)
    route = search(axes, coordinated(problem))
    assert route is not None
    route = refine_rail(axes, problem, route)
    iterate = timed(axes, problem, route)
    if in_motion:
        _, iterate, _ = refine(axes, InitialPlan(problem, route, iterate), Patience(), lambda _: None, {})
        assert np.abs(iterate.qd[:, 0]).max() > 0.1
    assert not len(rows_of(axes, problem, iterate)[2])
    below = 6e-5  # more than the 3e-5 and 5e-5 that a clean motion leaves of a limit
    limits = replace(plant.limits, acceleration=plant.limits.acceleration * (1 - below * np.eye(7)[0]))
    lower = replace(plant, limits=limits)
    tight, asked = Axes.of(lower), replace(problem, plant=lower)
    assert len(rows_of(tight, asked, iterate)[2])
    mended = with_legal_rows(tight, asked, iterate, Patience())
    assert mended is not None
    trajectory, bounds = mended.rows
    assert np.abs(accelerations(trajectory)).max(axis=(0, 1))[0] <= limits.acceleration[0] * (1 + 2e-6)
    assert 0 < bounds[-1] / sum(motion.T for motion in iterate.legs) - 1 < 2e-3
    kept = [now is then for now, then in zip(mended.iterate.legs, iterate.legs, strict=True)]
    assert any(kept) != in_motion
    assert not all(kept)
    for leg, motion in zip(problem.legs, mended.iterate.legs, strict=True):
        assert leg.duration is None or leg.duration == motion.T
    ends = [motion.sample(axes, np.array([0.0, motion.T])) for motion in mended.iterate.legs]
    for one, then in pairwise(ends):
        np.testing.assert_allclose(one.qd[1], then.qd[0], atol=1e-7)


@pytest.mark.usefixtures("coarse")
def test_a_grid_on_which_one_solve_fails_is_solved_otherwise() -> None:
    """Red where the answer stays on the coarser grid: whether a solve converges is a matter of a tenth of a millimetre,
    and that grid costs up to 0.1 % of the cycle."""
    axes = Axes.of(plant_with_rail())
    problem = problem_of(rapid("MoveJ p_in, v2500, fine, tool0;\nMoveL p_low, v300, fine, tool0;"), axes.plant)
    route = search(axes, coordinated(problem))
    assert route is not None
    refiner = MeshRefinement(axes, Formulation(axes), problem, Patience(), grids := Grids.of(problem))
    solve, failed = refiner._solve, list[float]()

    def once(iterate: Iterate, margins: list[Margins | None], mu: float, *more: Any, **named: Any) -> Any:
        if not failed and grids.path == iterate.legs[1].N:
            failed.append(mu)
            raise NotConverged("as some do")
        return solve(iterate, margins, mu, *more, **named)

    refiner._solve = once
    found = refiner.run(
        first_iterate(axes, problem, route.q, route.w, tuple(label.cfx for label in route.labels), route.times)
    )
    assert len(failed) == 1
    assert grids.path == found.legs[1].N


def test_a_stop_passed_in_motion_keeps_to_the_range_that_the_legs_beside_it_are_left() -> None:
    """An axis that comes away from its end in motion was beyond it before. Red where only nodes inside the leg are
    tightened: then no round of it changes anything, and the whole motion is given up."""
    plant = plant_with_rail()
    axes = Axes.of(plant)
    body = "MoveJ p_in, v2500, fine, tool0;\nMoveL p_low, v300, fine, tool0;\nMoveL p_in, v300, fine, tool0;"
    problem = problem_of(rapid(body), plant)
    route = search(axes, problem)
    assert route is not None
    cfx = tuple(label.cfx for label in route.labels)
    iterate = first_iterate(axes, problem, route.q, route.w, cfx, route.times)
    refiner = MeshRefinement(axes, Formulation(axes), problem, Patience())
    margins = refiner.margins(iterate)
    k = next(k for k in range(1, len(problem.legs)) if not problem.rests(k) and margins[k - 1] is not None)
    half = np.array([0.9, 0.95, 0.9, 0.95, 0.9, 0.95, 0.9])
    margins[k - 1].position[-1], margins[k].position[0] = half, 0.93
    program = refiner.transcription(iterate, margins)
    bounds = program.nlp.bounds()
    middle, room = (axes.upper + axes.lower) / 2, np.minimum(half, 0.93) * (axes.upper - axes.lower) / 2
    at = program.waypoint_q[k]
    np.testing.assert_allclose(bounds.upper[at], middle + room, atol=1e-12)
    np.testing.assert_allclose(bounds.lower[at], middle - room, atol=1e-12)
    last = program.waypoint_q[len(problem.legs)]
    assert problem.rests(len(problem.legs))
    np.testing.assert_array_equal(bounds.upper[last[1:]], axes.upper[1:])
