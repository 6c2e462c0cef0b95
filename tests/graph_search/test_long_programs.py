"""Long programs and long rails: searched in windows, within the arm's reach, equal stretches once."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import down, plant_with_rail, problem_of, rapid
from unrefined import coarse_search, set_defaults

from trajopt_cli.bound import lower_bound
from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.graph_search.search import search
from trajopt_cli.path_timing.path_parameterized_plan import duration, stopped_at_joint_moves, timed
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Coupling, Problem
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.trajectories.axes import Axes


def places(ys: list[float], plant: Plant, target: Target = Target.RAPID) -> Problem:
    """A place at each y, with a way down and up."""
    data, body = [], []
    for i, y in enumerate(ys):
        X = down(0.45 + 0.01 * (i % 7), y, 0.4, 0.1 * (i % 3))
        place = ",".join(f"{x * 1e3:.6f}" for x in X[:3, 3])
        turned = ",".join(f"{x:.12f}" for x in wxyz_from_rotation(X[:3, :3]))
        data.append(f"CONST robtarget p_{i}:=[[{place}],[{turned}],[0,0,0,0],[{y * 1e3:.3f},9E9,9E9,9E9,9E9,9E9]];")
        body += [f"MoveJ p_{i}, v2500, fine, tool0;", f"MoveL Offs(p_{i},0,0,-60), v500, fine, tool0;"]
        body += [f"MoveL p_{i}, v1000, fine, tool0;"]
    return problem_of(
        rapid("\n".join([*body, "MoveAbsJ j_home, v2500, fine, tool0;"]), data="\n".join(data)), plant, target
    )


def test_windows_find_what_the_whole_search_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    """12 places: the windows' route hangs together, is driven, and as fast as that of all legs at once but for what six
    legs ahead cannot see."""
    problem = places([*np.random.default_rng(4).uniform(0.1, 1.8, 12)], plant_with_rail())
    axes = Axes.of(problem.plant)
    whole = search(axes, problem)
    set_defaults(monkeypatch, searched_legs=15)
    set_defaults(monkeypatch, overlapping_legs=6)
    parts = search(axes, problem)
    assert whole is not None
    assert parts is not None
    assert parts.q.shape == whole.q.shape
    assert len(parts.labels) == len(whole.labels)
    assert len(parts.times) == len(problem.legs)
    np.testing.assert_allclose(parts.times.sum(), whole.times.sum(), rtol=4e-3)
    timed(axes, problem, replace(parts, w=np.zeros_like(parts.w)))


@pytest.mark.parametrize("target", Target)
def test_a_bound_in_windows_holds_and_is_hardly_weaker(target: Target, monkeypatch: pytest.MonkeyPatch) -> None:
    """Against a legal motion, whatever is aimed at, and against the bound over all cells at once."""
    problem = places([0.3, 1.4, 0.8, 1.7], plant_with_rail(), target)
    axes = Axes.of(problem.plant)
    coarse_search(monkeypatch)
    route = search(axes, replace(problem, coupling=Coupling.COORDINATED))
    assert route is not None
    legal = duration(timed(axes, problem, refine_rail(axes, replace(problem, coupling=Coupling.COORDINATED), route)))
    whole = lower_bound.lower_bound(axes, problem, legal)
    set_defaults(monkeypatch, bound_legs=8)
    set_defaults(monkeypatch, bound_window=4)
    for aim in (legal, 1.5 * legal):
        parts = lower_bound.lower_bound(axes, problem, aim)
        assert 0.95 * whole < parts < legal
    assert lower_bound.lower_bound(axes, problem, 0.5 * whole) == 0.5 * whole


def test_a_rail_of_forty_metres_is_searched_where_the_arm_reaches() -> None:
    problem = places([1.0, 20.0, 38.5], plant_with_rail((-0.2, 40.0)))
    axes = Axes.of(problem.plant)
    route = search(axes, problem)
    assert route is not None
    rail = axes.layout.place(route.q)
    assert np.all(np.abs(rail[1:-1] - np.repeat([1.0, 20.0, 38.5], 3)) < 0.8)


def test_the_arm_reaches_from_nowhere_outside_its_rail_range() -> None:
    """The closed form against the inverse kinematics, at random poses and rail positions."""
    robot, rng = plant_with_rail().robot, np.random.default_rng(2)
    q = rng.uniform(-1.5, 1.5, (400, 7))
    X_WF = robot.forward(q)
    ends = robot.rail_within(X_WF)
    assert np.all((q[:, 0] > ends[:, 0]) & (q[:, 0] < ends[:, 1]))
    d = rng.uniform(-4, 4, 400)
    outside = (d < ends[:, 0]) | (d > ends[:, 1])
    assert np.isnan(inverse(robot, X_WF[outside], d[outside])).all()
    assert 100 < outside.sum() < 390
    assert np.ptp(ends, axis=1).max() < 2 * 0.9


def contour(end: str) -> Problem:
    """60 points of z1 on a wave, and a fly-by behind them to where the program ends."""
    points = [down(0.5 + 0.03 * np.sin(0.4 * i), 0.2 + 0.01 * i, 0.4, 0.0)[:3, 3] * 1e3 for i in range(60)]
    lines = [f"MoveL Offs(p_1,{x - 450:.4f},{y - 200:.4f},0), v200, z1, tool0;" for x, y, _ in points]
    data = "CONST robtarget p_1:=[[450,200,400],[0,1,0,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];"
    body = ["MoveJ p_1, v1000, fine, tool0;", *lines, f"{end} Offs(p_1,50,800,50), v200, fine, tool0;"]
    return problem_of(rapid("\n".join(body), data=data), plant_with_rail(), Target.RAPID)


def test_points_carried_along_a_contour_are_where_the_program_has_them() -> None:
    """With the rail refined: every pose is kept on one branch, and the rail goes on steadily."""
    problem = contour("MoveL")
    axes = Axes.of(problem.plant)
    route = search(axes, problem)
    assert route is not None
    refined = refine_rail(axes, problem, route)
    assert refined.cost < route.cost
    poses = [point.X_WF for point in problem.waypoints[1:]]
    np.testing.assert_allclose(axes.forward(refined.q[1:]), poses, atol=1e-9)
    steps = np.diff(refined.q[2:-1], axis=0)
    assert np.abs(steps[:, axes.layout.arm]).max() < 0.2
    assert 0.0 < np.ptp(axes.layout.place(refined.q)) < 1.0
    assert np.abs(np.diff(axes.layout.place(steps))).max() < 1e-3


def test_only_a_fly_by_beside_a_joint_move_becomes_a_stop_there() -> None:
    """That of the last line where a joint move follows; none, and the same problem, where a line does."""
    problem = contour("MoveL")
    assert stopped_at_joint_moves(problem) is problem
    problem = contour("MoveJ")
    stopping = stopped_at_joint_moves(problem)
    assert [k for k in range(len(problem.waypoints)) if problem.passes(k) != stopping.passes(k)] == [61]
    assert problem.passes(61)
