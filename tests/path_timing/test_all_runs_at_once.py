"""What is done for all runs of a program at once is what is done for each of them alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid
from unrefined import coarse_search, set_defaults

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.search import search
from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.path_timing.path_parameterized_plan import about, duration, timed
from trajopt_cli.path_timing.path_timing import (
    PathMargins,
    least_times,
    motions,
    sampled_ratios,
    time_optimal_law,
    time_path,
)
from trajopt_cli.path_timing.sampled_path import SampledPath, sample_paths
from trajopt_cli.plan.rail_refinement import refine_corner_rail, refine_rail
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.problem import Coupling, Problem
from trajopt_cli.trajectories import dense_check
from trajopt_cli.trajectories.active_limits import binding_limits
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_leg
from trajopt_cli.trajectories.leg_trajectories import PathLeg
from trajopt_cli.trajectories.route import Route

DATA = "CONST zonedata z_t:=[FALSE,12,18,25,9E9,9E9,9E9];"
BODY = """MoveJ p_in, v1000, z_t, tool0;
MoveL p_low, v500, z_t, tool0;
MoveL Offs(p_low,30,40,0), v300, fine, tool0;
MoveL p_low, v500, fine, tool0;
MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v500, z_t, tool0;
MoveL Offs(p_low,0,-60,20), v800, fine, tool0;"""


def route_of(body: str = BODY) -> tuple[Axes, Problem, Route]:
    problem = problem_of(rapid(body, data=DATA), plant_with_rail(), Target.RAPID)
    axes = Axes.of(problem.plant)
    with pytest.MonkeyPatch.context() as patch:
        coarse_search(patch)
        route = search(axes, problem)
    assert route is not None
    return axes, problem, replace(route, w=np.zeros_like(route.w))


def paths(axes: Axes, problem: Problem, route: Route) -> list[SampledPath]:
    cfx = [label.cfx for label in route.labels]
    shifted = route.q.copy()
    shifted[problem.runs[0][1], 0] += 0.1  # the arm does not end there: no path, which the others must not feel
    q = [*([route.q] * len(problem.runs)), shifted]
    found = sample_paths(axes, problem, [*problem.runs, problem.runs[0]], q, cfx, [24] * len(q))
    made = [one for one in found if one is not None]
    assert found[-1] is None
    assert len(made) == len(problem.runs)
    alone = [sample_paths(axes, problem, [run], [route.q], cfx, [24])[0] for run in problem.runs]
    for one, other in zip(made, alone, strict=True):
        assert other is not None
        for name in ("q", "dq", "ddq", "v", "w", "bend"):
            np.testing.assert_array_equal(getattr(one.along, name), getattr(other.along, name))
    return made


def test_runs_compared_together_take_as_long_as_alone() -> None:
    axes, problem, route = route_of()
    made = paths(axes, problem, route)
    for path, T in zip(made, least_times(axes, problem, made), strict=True):
        found = time_path(axes, problem, path)
        assert found is not None
        law = time_optimal_law(axes, problem, path, PathMargins.full(axes, len(path.part)))
        assert law is not None
        assert law.duration == pytest.approx(T, rel=1e-12)
        assert sum(one.T for one in found.values()) * (1 + 1e-3) > T


def test_a_course_is_looked_at_as_its_motions_are(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same ratios at the same places, of ways of the tool, joint moves and corners between them."""
    set_defaults(monkeypatch, path_interval_samples=12)
    set_defaults(monkeypatch, corner_samples=1)
    set_defaults(monkeypatch, least_samples=12)
    monkeypatch.setattr(dense_check, "_SHORT_STEP", 1e3)
    axes, problem, route = route_of()
    for path in paths(axes, problem, route):
        law = time_optimal_law(axes, problem, path, PathMargins.full(axes, len(path.part)))
        assert law is not None
        found = sampled_ratios(axes, problem, path, law, range(len(path.parts)))
        for k, motion in motions(axes, problem, path, law).items():
            wanted, at = check_leg(axes, problem.legs[k], motion), path.leg == k
            for of in ("velocity", "acceleration", "position", "tool"):
                np.testing.assert_allclose(getattr(found, of)[at], getattr(wanted, of), rtol=1e-6, atol=1e-6)


FAR = "[9E9,9E9,9E9,9E9,9E9,9E9]"
JOINT_CORNERS = f"""MoveJ [[433,-98,739],[0.5296,-0.0386,0.8117,0.2432],[-1,0,-1,0],{FAR}], v500, z10\\Z:=30, tLong;
MoveAbsJ [[-17.64,13.1,16.61,23.88,45.6,-25.79],{FAR}], v500, z5, tLong;
MoveL [[392,-294,531],[0.1491,0.1175,0.912,0.3637],[-1,0,-1,0],{FAR}], v200, fine, tLong;"""
SHARP_CORNER = f"""MoveJ [[440,-50,740],[0.4305,0,0.9026,0],[0,0,0,0],{FAR}], v300, fine, tool0;
MoveL [[424,-20,765],[0.4305,0,0.9026,0],[0,0,0,0],{FAR}], v200, z50, tool0;
MoveL [[560,0,690],[0.4305,0,0.9026,0],[0,0,0,0],{FAR}], v400, fine, tool0;"""


@pytest.mark.parametrize("body", [JOINT_CORNERS, SHARP_CORNER])
def test_no_speed_in_a_corner_is_overlooked(body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The tool slows down and speeds up within an interval: what is looked at is what twenty times as many looks see,
    to less than what is kept free (SAFE) and what the judge grants besides."""
    long = "PERS tooldata tLong:=[TRUE,[[15,-66,-44],[0.96,-0.245,0.0237,0.1127]],[1,[0,0,50],[1,0,0,0],0,0,0]];"
    problem = problem_of(rapid(body, data=long), plant_without_rail(), Target.RAPID)
    axes = Axes.of(problem.plant)
    route = search(axes, problem)
    assert route is not None
    cfx = [label.cfx for label in route.labels]
    path = sample_paths(axes, problem, problem.runs[-1:], [route.q], cfx, [48])[0]
    assert path is not None
    law = time_optimal_law(axes, problem, path, PathMargins.full(axes, len(path.part)))
    assert law is not None
    every = range(len(path.parts))
    found = sampled_ratios(axes, problem, path, law, every).tool
    set_defaults(monkeypatch, path_interval_samples=100)
    assert found == pytest.approx(sampled_ratios(axes, problem, path, law, every).tool, rel=4e-5)


def test_motions_hold_no_more_than_their_own_numbers() -> None:
    """And none of the paths they were timed on, which are ten times as large; timed few at a time they are the same."""
    axes, problem, route = route_of(BODY.replace("z_t", "fine"))
    few = replace(axes, plant=replace(axes.plant, settings=replace(axes.settings, batch=64)))
    for one, other in zip(timed(axes, problem, route).legs, timed(few, problem, route).legs, strict=True):
        assert one is not None
        assert other is not None
        assert pytest.approx(other.T, rel=1e-12) == one.T
        for array in (x for x in vars(one).values() if isinstance(x, np.ndarray) and isinstance(one, PathLeg)):
            whole = array if array.base is None else array.base
            assert whole.size <= 4 * array.size


def test_what_binds_many_legs_binds_each_alone() -> None:
    axes, problem, route = route_of(BODY.replace("p_low, v500, fine", "p_low, v20, fine"))
    motions = [one for one in timed(axes, problem, route).legs if one is not None]
    found = binding_limits(axes, problem.legs, motions)
    alone = [binding_limits(axes, [leg], [motion])[0] for leg, motion in zip(problem.legs, motions, strict=True)]
    assert found == alone
    assert found[3] == "programmed TCP speed"
    assert len({*found}) > 1


def test_shifts_at_corners_gain() -> None:
    axes, problem, route = route_of()
    cfx = [label.cfx for label in route.labels]

    def time(q: Array) -> float:
        return float(about(axes, problem, problem.runs, [q] * len(problem.runs), cfx).sum())

    found = refine_corner_rail(axes, problem, route)
    assert time(found.q) < time(route.q) * (1 - 1e-3)
    assert duration(timed(axes, problem, found)) < duration(timed(axes, problem, route))


@pytest.mark.long
def test_no_shift_of_neighbours_across_stops_gains() -> None:
    """Neither of one point nor of up to four together by the last step, timed with joints of the robot's own."""
    axes, problem, route = route_of(BODY.replace("v300, fine", "v300, z_t"))
    cfx = [label.cfx for label in route.labels]
    q = refine_corner_rail(axes, problem, route).q
    free = [k for k, point in enumerate(problem.waypoints) if point.q is None]

    def time(q: Array) -> float:
        return float(about(axes, problem, problem.runs, [q] * len(problem.runs), cfx).sum())

    for i in range(len(free)):
        for group in (free[i : i + count] for count in range(1, 5)):
            for way in (axes.settings.polish_last, -axes.settings.polish_last):
                shifted = q.copy()
                for k in group:
                    rail = q[k, :1] + way
                    arm = axes.inverse(problem.waypoints[k].X_WF[None], rail)[0, cfx[k]]
                    shifted[k] = np.r_[rail, arm + 2 * np.pi * np.round((q[k, 1:] - arm) / (2 * np.pi))]
                assert not time(shifted) < time(q) - 2e-5


def test_the_rail_is_shifted_where_it_stands_in_a_wait() -> None:
    """Both ends of the wait alike, which takes no more."""
    axes, problem, route = route_of(BODY.replace("MoveL p_low, v500, fine, tool0;", "WaitTime 0.2;"))
    wait = next(k for k, leg in enumerate(problem.legs) if leg.duration)
    legs = [replace(leg, rail_moves=k != wait) for k, leg in enumerate(problem.legs)]
    route.q[wait + 1] = route.q[wait]
    found = refine_corner_rail(axes, replace(problem, legs=tuple(legs)), route).q
    np.testing.assert_allclose(found[wait + 1], found[wait], rtol=0, atol=1e-9)
    assert abs(found[wait, 0] - route.q[wait, 0]) > axes.settings.polish_last / 2


def test_points_that_are_carried_along_are_not_shifted() -> None:
    """Nor those around them, where these are fewer."""
    ways = [f"MoveL Offs(p_low,{5 * np.sin(i):.3f},{3 * i},0), v200, z1, tool0;" for i in range(1, 9)]
    around = [f"MoveL Offs(p_low,{x},{y},40), v200, z5, tool0;" for x, y in ((60, -80), (-60, -160), (0, -240))]
    begin, end = "MoveJ p_low, v1000, fine, tool0;", "MoveL p_low, v200, fine, tool0;"
    axes, problem, route = route_of("\n".join([begin, *ways, end]))
    assert np.array_equal(refine_corner_rail(axes, problem, route).q, route.q)
    axes, problem, route = route_of("\n".join([begin, *around, *ways[:3], end]))
    moved = np.abs(refine_corner_rail(axes, problem, route).q - route.q).max(axis=1) > 0
    assert moved[:6].any()
    assert not moved[6]


def test_what_was_timed_for_one_coupling_is_known_to_the_other() -> None:
    axes, problem, route = route_of(BODY.replace("z_t", "fine"))
    free, known = replace(problem, coupling=Coupling.FREE), Times()
    refine_rail(axes, problem, route, known)
    before = len(known.found)
    after = refine_rail(axes, free, route, known)
    assert before < len(known.found) < 2 * before
    np.testing.assert_array_equal(after.q, refine_rail(axes, free, route).q)
