"""Streams through corners: runs opened and put together again, against a closed form, against stops, and judged."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid
from unrefined import coarse_grids, coarse_search

from trajopt_cli.judge.verify import verify
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import MeshRefinement, on_grid
from trajopt_cli.path_timing.path_parameterized_plan import duration
from trajopt_cli.plan import optimize
from trajopt_cli.plan.initial_plan import InitialPlan, initial_plan_of
from trajopt_cli.plan.opened_corners import OpenedProblem, opened
from trajopt_cli.plan.subproblems import Window
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.problem import LegKind
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.timing.double_integrator import trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import sampled

BODY = """MoveJ p_in, v2500, z50, tool0;
MoveL p_low, v1000, z10, tool0;
MoveL Offs(p_low,0,150,0), v500, fine, tool0;
MoveL Offs(p_in,0,150,0), v1000, z50, tool0;
MoveAbsJ j_home, v2500, fine, tool0;"""
PLANT = plant_with_rail((-0.16, 0.8))
AXES = Axes.of(PLANT)


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)


@cache
def runs() -> tuple[OpenedProblem, Iterate]:
    problem = problem_of(rapid(BODY), PLANT)
    with pytest.MonkeyPatch.context() as patch:
        coarse_search(patch)
        found = initial_plan_of(AXES, [problem], Patience(), lambda _: None, {})
    assert isinstance(found, InitialPlan)
    out = opened(AXES, found.problem, found.iterate)
    assert out is not None
    return out


def test_a_run_is_cut_where_its_zones_are_entered_and_left() -> None:
    """A joint move, a line from zone to zone, a corner, a line; a line up to the zone, a joint move."""
    legs, points = runs()[0].legs, runs()[0].waypoints
    kinds = [leg.kind for leg in legs]
    assert kinds == [LegKind.JOINT, LegKind.LINE, LegKind.LINE, LegKind.LINE, LegKind.LINE, LegKind.JOINT]
    # z50 is 30 mm on a line of 60 mm; so is z10 10 mm of 60 and 150
    ways = [leg.chord for leg in legs if leg.segment is not None and not leg.segment.is_corner]
    np.testing.assert_allclose(ways, [0.02, 0.14, 0.03], rtol=0, atol=1e-9)
    assert [leg.segment is not None and leg.segment.is_corner for leg in legs] == [False, False, True] + 3 * [False]
    assert [point.passage is not None for point in points] == [False, True, True, True, False, True, False]
    assert runs()[0].owners == ((0,), (1,), (1, 2), (2,), (3,), (4,))


def test_opened_and_closed_again_the_motion_is_what_it_was() -> None:
    closed = runs()[0].closed(AXES, runs()[1])
    assert duration(runs()[1]) == pytest.approx(duration(runs()[0].base), rel=1e-12)
    np.testing.assert_array_equal(closed.q, runs()[0].base.q)
    ends = [np.cumsum([0.0, *(motion.T for motion in one.legs if motion)]) for one in (runs()[0].base, closed)]
    t = np.linspace(0, ends[0][-1], 401)
    both = []
    for one, end in zip((runs()[0].base, closed), ends, strict=True):
        legs = [motion for motion in one.legs if motion is not None]
        number = np.clip(np.searchsorted(end, t, side="right") - 1, 0, len(legs) - 1)
        times = [np.clip(t[number == k] - end[k], 0, legs[k].T) for k in range(len(legs))]
        sample = sampled(AXES, legs, times)
        both.append((sample.q, sample.qd))
    np.testing.assert_allclose(both[1][0], both[0][0], rtol=0, atol=1e-7)
    np.testing.assert_allclose(both[1][1], both[0][1], rtol=0, atol=1e-5)


def test_a_window_between_passed_places_is_held_in_motion() -> None:
    """From the first zone's edge on the line to the second one's behind the corner."""
    window = Window.of(runs()[0], runs()[1], (1, 3))
    assert np.abs(window.iterate.qd[[0, -1]]).max(axis=1).min() > 0.05
    start = on_grid(AXES, window.problem, window.iterate)
    found = MeshRefinement(AXES, Formulation(AXES), window.problem, Patience()).run(start)
    np.testing.assert_array_equal(found.q[[0, -1]], window.iterate.q[[0, -1]])
    np.testing.assert_array_equal(found.qd[[0, -1]], window.iterate.qd[[0, -1]])
    assert duration(found) < duration(window.iterate) * 1.001
    for motion, q, qd in zip(found.legs, pairwise(found.q), pairwise(found.qd), strict=True):
        assert motion is not None
        ends = motion.sample(AXES, np.array([1e-9, motion.T - 1e-9]))
        np.testing.assert_allclose(ends.q, q, rtol=0, atol=1e-6)
        np.testing.assert_allclose(ends.qd, qd, rtol=0, atol=1e-4)


def test_a_stream_through_corners_is_legal_and_faster_than_stops_and_than_rapid() -> None:
    program = rapid(BODY)
    with coarse_grids():
        stream = optimize(program, PLANT, Target.STREAM, bounded=False)
        fine = optimize(rapid(BODY.replace("z50", "fine").replace("z10", "fine")), PLANT, Target.STREAM, bounded=False)
    assert isinstance(stream, Plan)
    assert isinstance(fine, Plan)
    report = verify(program, PLANT, stream.trajectory, target=Target.STREAM, advice=False)
    assert [f"{f.check} {f.subject} {f.value} > {f.limit}" for f in report.findings if not f.passed] == []
    assert stream.duration < 0.95 * duration(runs()[0].base)
    assert stream.duration < fine.duration


def test_joint_moves_pass_a_zone_in_the_least_time_of_the_axis_that_must_move() -> None:
    """Joint 1 goes on through the point, joint 6 away and back: the tool centre point does not see it, so a stream
    leaves it where it is."""
    plant = plant_without_rail()
    there = "MoveAbsJ [[{},0,0,0,30,{}],[9E9,9E9,9E9,9E9,9E9,9E9]], vmax, {}, tool0;"
    program = rapid("\n".join([there.format(30, 80, "z50"), there.format(60, 0, "fine")]))
    plan = optimize(program, plant, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    V, A = plant.limits.velocity[0], plant.limits.acceleration[0]
    assert plan.duration == pytest.approx(float(trapezoid_time(np.pi / 3, V, A)), rel=2e-4)
    assert verify(program, plant, plan.trajectory, target=Target.STREAM, advice=False).legal


def test_runs_over_many_short_lines_stay_as_they_are() -> None:
    body = "MoveJ p_in, v500, fine, tool0;\n"
    body += "\n".join(f"MoveL Offs(p_in,0,{20 * i},{3 * (i % 2)}), v500, z5, tool0;" for i in range(1, 5))
    problem = problem_of(rapid(body + "\nMoveL Offs(p_in,0,100,0), v500, fine, tool0;"), PLANT)
    found = initial_plan_of(AXES, [problem], Patience(), lambda _: None, {})
    assert isinstance(found, InitialPlan)
    assert opened(AXES, found.problem, found.iterate) is None
