"""The legal motion that every plan begins with: refined for the better, honest about time, also under tool caps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import HOME, down, plant_with_rail, plant_without_rail, problem_of, rapid
from unrefined import coarse_search

from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.graph_search.search import search
from trajopt_cli.judge.verify import verify
from trajopt_cli.path_timing.path_parameterized_plan import Runs, duration, timed
from trajopt_cli.plan import optimize
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import Route

pytestmark = pytest.mark.usefixtures("coarse")


def random_cell(seed: int, stations: int = 3) -> tuple[str, str]:
    """Body and data of some stations beside the rail, each approached, entered on a line, waited in and left."""
    rng = np.random.default_rng(seed)
    body, data = [], []
    for i in range(stations):
        y, turn = rng.uniform(0.2, 1.6), rng.uniform(-0.5, 0.5)
        X = down(rng.uniform(0.4, 0.55), y, rng.uniform(0.38, 0.5), turn)
        place = ",".join(f"{x * 1e3:.6f}" for x in X[:3, 3])
        turned = ",".join(f"{x:.12f}" for x in wxyz_from_rotation(X[:3, :3]))
        data.append(f"CONST robtarget p_{i}:=[[{place}],[{turned}],[0,0,0,0],[{y * 1e3:.3f},9E9,9E9,9E9,9E9,9E9]];")
        speed = rng.choice([200, 500, 1000])
        body += [
            f"MoveJ p_{i}, v2500, fine, tool0;",
            f"MoveL Offs(p_{i},0,{rng.uniform(-30, 30):.3f},-60), v{speed}, fine, tool0;",
            f"WaitTime {rng.uniform(0.05, 0.3):.3f};",
            f"MoveL p_{i}, v1000, fine, tool0;",
        ]
    return "\n".join([*body, "MoveAbsJ j_home, v2500, fine, tool0;"]), "\n".join(data)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("target", Target)
def test_refining_the_rail_is_never_slower(seed: int, target: Target) -> None:
    body, data = random_cell(seed, 2)
    plant = plant_with_rail()
    problem, axes = problem_of(rapid(body, data=data), plant, target), Axes.of(plant)
    route = search(axes, problem)
    assert route is not None
    before = duration(timed(axes, problem, replace(route, w=np.zeros_like(route.w))))
    after = duration(timed(axes, problem, refine_rail(axes, problem, route)))
    assert after < before * (1 - 1e-3)


def test_runs_driven_before_are_driven_alike_and_only_once() -> None:
    body, data = random_cell(1)
    plant = plant_with_rail()
    axes, known = Axes.of(plant), Runs()
    for target in Target:  # axes that are free go another way
        problem = problem_of(rapid(body, data=data), plant, target)
        route = search(axes, problem)
        assert route is not None
        first, again, alone = (timed(axes, problem, route, *runs) for runs in ((known,), (known,), ()))
        assert all(a is b for a, b in zip(first.legs, again.legs, strict=True))
        assert [one.T for one in first.legs if one] == [one.T for one in alone.legs if one]


@pytest.mark.long
def test_the_rail_does_not_jitter_along_a_contour() -> None:
    """80 points of z1, 3 mm apart: from one to the next the rail changes its slope by no more than a few percent, and
    the contour is no slower than with the rail standing where it begins."""
    ways = [f"Offs(p_low,{5 * np.sin(0.4 * i):.3f},{3 * i},0)" for i in range(1, 81)]
    body = "\n".join(["MoveJ p_low, v1000, fine, tool0;", *(f"MoveL {way}, v200, z1, tool0;" for way in ways)])
    plant = plant_with_rail()
    problem = problem_of(rapid(f"{body}\nMoveL Offs(p_low,0,250,0), v200, fine, tool0;"), plant, Target.STREAM)
    axes = Axes.of(plant)
    route = search(axes, problem)
    assert route is not None
    found = refine_rail(axes, problem, route)
    slopes = np.diff(axes.layout.place(found.q))[1:] / [leg.chord for leg in problem.legs[1:]]
    assert np.abs(np.diff(slopes[2:-2])).max() < 0.05
    fixed = replace(problem, waypoints=tuple(
        replace(point, rail=(at, at)) if point.q is None else point
        for point in problem.waypoints for at in [float(axes.layout.place(found.q[1]))]
    ))  # fmt: skip
    still = search(axes, fixed)
    assert still is not None
    assert duration(timed(axes, problem, found)) < duration(timed(axes, fixed, still)) * (1 + 1e-3)


@pytest.mark.parametrize("target", Target)
def test_a_time_too_short_is_infeasible_and_names_the_motion(target: Target, monkeypatch: pytest.MonkeyPatch) -> None:
    """60 mm under 2.5 m/s and 20 m/s2 take 0.11 s at least."""
    coarse_search(monkeypatch)
    body = "MoveJ p_in, v2500, fine, tool0;\nMoveL p_low, v500\\T:={}, fine, tool0;"
    plant = plant_with_rail((-0.1, 0.8))
    answer = optimize(rapid(body.format(0.01)), plant, target, bounded=False)
    assert isinstance(answer, Infeasible)
    assert (answer.index, str(answer.source)) == (1, "t.mod:6:1")
    assert answer.message.startswith("MoveL p_low has 0.01 s and takes 0.1")
    enough = optimize(rapid(body.format(0.5)), plant, target, bounded=False)
    assert isinstance(enough, Plan)
    assert enough.motions[1].t_1 - enough.motions[1].t_0 == pytest.approx(0.5, abs=1e-9)


def test_a_time_far_too_short_is_refused_without_trying_narrower_ranges(monkeypatch: pytest.MonkeyPatch) -> None:
    """One search; a time a little too short is worth all of them."""
    coarse_search(monkeypatch)
    searched: list[float] = []

    def counted(axes: Axes, problem: Problem) -> Route | None:
        searched.append(float(axes.upper[0] - axes.lower[0]))
        return search(axes, problem)

    monkeypatch.setattr("trajopt_cli.plan.initial_plan.search", counted)
    body = "MoveJ p_in, v2500, fine, tool0;\nMoveL p_low, v500\\T:={}, fine, tool0;"
    for T, count in ((0.01, 1), (0.1, len(DEFAULT.range_shares))):
        searched.clear()
        answer = optimize(rapid(body.format(T)), plant_with_rail(), Target.RAPID, FIXED_RAIL, bounded=False)
        assert isinstance(answer, Infeasible), answer
        assert len(set(searched)) == count


@pytest.mark.parametrize("target", Target)
def test_slow_joint_moves_of_a_long_tool_are_planned_and_legal(target: Target) -> None:
    """Every cap of the tool binds all the way; the corner lies between two joint moves."""
    data = """PERS tooldata t_long:=[TRUE,[[80,-40,250],[0.96592583,0,0.25881905,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
CONST jointtarget j_a:=[[20,10,-5,8,40,15],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST jointtarget j_b:=[[-15,-5,5,-10,35,-30],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_by:=[[500,-100,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
    body = "\n".join([
        "ConfJ \\Off;",
        "MoveAbsJ j_b, v60, fine, t_long;",
        "MoveJ p_by, v200, z50, t_long;",
        "MoveAbsJ j_a, v200, fine, t_long;",
    ])  # fmt: skip
    program, plant = rapid(body, data=data), plant_without_rail()
    plan = optimize(program, plant, target, bounded=False)
    assert isinstance(plan, Plan)
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert [f"{f.check} {f.subject} {f.value} > {f.limit}" for f in report.findings if not f.passed] == []
    # the tool at its programmed speeds all the way is the least time there is; ramps and corners add little
    t, q = plan.trajectory.t, plan.trajectory.q
    tool = (plant.robot.forward(q) @ problem_of(program, plant, target).legs[-1].X_FT)[:, :3, 3]
    way = np.linalg.norm(np.diff(tool, axis=0), axis=1)
    speed = np.where(t[1:] <= plan.motions[0].t_1, 0.06, 0.2)
    assert np.sum(way / speed) <= plan.duration <= 1.1 * np.sum(way / speed)
    np.testing.assert_allclose(q[0], HOME)
