"""The lower bound of programs with corners: below every plan, and never above that of the same program with stops."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid
from unrefined import IMPROVED, as_it_comes, set_defaults

from trajopt_cli.bound import lower_bound
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.robot.enclosure import Range
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectory import hermite

pytestmark = pytest.mark.usefixtures("few_places")

CORNERS = """MoveJ p_in, v2500, {0}, tool0;
MoveL p_low, v500, fine, tool0;
MoveL p_in, v800, {0}, tool0;
MoveJ p_near, v1000, {0}, tool0;
MoveL p_side, v500, {0}, tool0;
MoveL p_in, v500, fine, tool0;
MoveAbsJ j_home, v2500, fine, tool0;"""
NEAR = """CONST robtarget p_near:=[[520,420,430],[0,0,1,0],[0,0,0,0],[450,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_side:=[[480,440,330],[0,0.0436194,0.9990482,0],[0,0,0,0],[450,9E9,9E9,9E9,9E9,9E9]];"""
ROOMY = (-0.16, 0.8)


def case(name: str, zone: str) -> tuple[Program, Plant]:
    text, data = CORNERS.format(zone), NEAR
    if name == "rail":
        return rapid(text, data=data), plant_with_rail(ROOMY)
    lines = [text, data]  # the same stations 500 mm nearer, without external axes
    return rapid("MoveAbsJ j_home, v2500, fine, tool0;\n" + lines[0], data=lines[1]), plant_without_rail()


@cache
def solved(name: str, zone: str, target: Target) -> tuple[Plan, Problem]:
    program, plant = case(name, zone)
    with pytest.MonkeyPatch.context() as patch:
        set_defaults(patch, polished_legs=30)  # more saves no more than 0.3 % here
        patch.setattr(IMPROVED, as_it_comes)  # these streams are hardly improved
        plan = optimize(program, plant, target)
    assert isinstance(plan, Plan), plan
    return plan, problem_of(program, plant, target)


def crossing(axes: Axes, plan: Plan, X_WF: Array, begin: float, end: float) -> float:
    """When the flange comes nearest to a pose."""
    t = np.linspace(begin, end, 20001)
    q, _, _ = hermite(plan.trajectory, t)
    X = axes.forward(q)
    off = np.linalg.norm(X[:, :3, 3] - X_WF[:3, 3], axis=1) + np.abs(X[:, :3, :3] - X_WF[:3, :3]).sum(axis=(1, 2))
    i = int(np.argmin(off))
    assert off[i] < 2e-4, f"the plan passes a gate {off[i] * 1e3:.3f} mm away"
    return float(t[i])


def shrunk(cells: lower_bound._Cells, keep: Array) -> lower_bound._Cells:
    pick = lambda r: Range(r.lo[:, keep], r.hi[:, keep])  # noqa: E731
    return lower_bound._Cells(pick(cells.q), pick(cells.v), cells.key[keep])


@pytest.mark.parametrize("level", range(DEFAULT.bound_levels - 1))
@pytest.mark.parametrize("target", Target)
@pytest.mark.parametrize("name", ["rail"])
def test_no_stretch_of_a_plan_beats_the_bound_between_the_cells_that_hold_its_ends(
    name: str, target: Target, level: int
) -> None:
    plan, problem = solved(name, "z20", target)
    axes = Axes.of(problem.plant)
    route = lower_bound._route(axes, problem, [0.0] * len(problem.runs))
    assert sum(place.gate is not None for place in route.places) == 3
    ends = np.array([0.0, *(m.t_1 for m in plan.motions)])
    times, held = [], []
    for place in route.places:
        gate = place.gate
        t = ends[place.k] if gate is None else crossing(axes, plan, gate.X_WF, ends[gate.leg], ends[gate.leg + 1])
        q, qd, _ = hermite(plan.trajectory, np.array([t]))
        cells = lower_bound._cells(axes, problem, place, lower_bound._grid(axes, problem, place), level, None, {})
        slack, slack_v = (1e-9, 1e-6) if gate is None else (1e-3, 2e-2)  # found within 2e-4 m, m/s
        inside = (cells.q.lo - slack <= q[0, :4, None]) & (q[0, :4, None] <= cells.q.hi + slack)
        inside &= (cells.v.lo - slack_v <= qd[0, :4, None]) & (qd[0, :4, None] <= cells.v.hi + slack_v)
        keep = np.flatnonzero(np.all(inside, axis=0))
        assert len(keep), f"no cell at level {level} holds the plan at {place.k}"
        times.append(t)
        held.append(shrunk(cells, keep))
    stretches = [(k, k + 1, run) for k, run in enumerate(route.hops)] + [(*ij, run) for ij, run in route.direct.items()]
    for i, j, run in stretches:
        a, b = held[i], held[j]
        T = lower_bound._edge(axes, run, a, b, np.zeros(len(a.key)), np.zeros(len(b.key)), np.inf)
        assert np.min(T) <= times[j] - times[i] + 1e-3, (i, j)


@pytest.mark.parametrize("target", Target)
@pytest.mark.parametrize("name", ["rail", "bench"])
def test_the_bound_stays_under_the_plan_and_falls_as_zones_grow(name: str, target: Target) -> None:
    plan, problem = solved(name, "z20", target)
    axes = Axes.of(problem.plant)
    assert lower_bound.lower_bound(axes, problem, 1.3 * plan.duration) <= plan.duration
    assert plan.lower_bound is not None
    assert plan.lower_bound > 0.7 * plan.duration
    bounds = []
    for zone in ("fine", "z1", "z20", "z100"):
        program, plant = case(name, zone)
        bounds.append(lower_bound.lower_bound(axes, problem_of(program, plant, target), 2 * plan.duration))
    assert bounds == sorted(bounds, reverse=True)


@pytest.mark.parametrize("target", Target)
def test_a_contour_of_many_points_takes_its_way(target: Target) -> None:
    """60 points of z1 on a circle of 60 mm at 100 mm/s: its chords, each cut short by its zones, and one run-up."""
    phi = np.linspace(0, 2 * np.pi, 61)
    points = np.column_stack([500 + 60 * np.cos(phi), 60 * np.sin(phi)])
    lines = [
        f"MoveL [[{x:.6f},{y:.6f},350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v100, {zone}, tool0;"
        for (x, y), zone in zip(points, ["fine", *["z1"] * 59, "fine"], strict=True)
    ]
    start = lines[0].replace("MoveL", "MoveJ")
    problem = problem_of(rapid("\n".join([start, *lines[1:]])), plant_without_rail(), target)
    assert len(problem.runs) == 2
    chord = 2 * 0.06 * np.sin(np.pi / 60)
    cut = 2 * 0.001 * (1 - np.cos(np.pi / 60))
    least = (60 * chord - 59 * cut) / 0.1 + 0.1 / problem.plant.tcp.acceleration
    first = lower_bound.lower_bound(Axes.of(problem.plant), replace(problem, waypoints=problem.waypoints[:2],
                                                              legs=problem.legs[:1]), 100.0)  # fmt: skip
    whole = lower_bound.lower_bound(Axes.of(problem.plant), problem, 100.0)
    assert whole - first == pytest.approx(least, abs=1e-6)
