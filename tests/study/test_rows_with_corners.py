"""Rows that time a motion by other means than the optimiser's: the same corners and arcs, sampled."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from timed_rows import attempt, broken, fixed_rail_plan, plant_with_rail, rapid, solver

from trajopt_cli.geometry import Array
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.study.along_path import SmoothPath, on_path
from trajopt_cli.study.cartesian import bang_bang_row
from trajopt_cli.study.case import Answer, Case
from trajopt_cli.study.fixed_rail import caps_of, fixed_rail
from trajopt_cli.study.ruckig_row import _drive, ruckig, ruckig_jerk
from trajopt_cli.study.toppra_row import toppra
from trajopt_cli.trajectory import Trajectory, hermite

pytestmark = pytest.mark.usefixtures("coarse")

# Corners of joint move and line, of two lines, of line and arc; an arc passed at both ends; then a stop.
BODY = """MoveJ p_in, v2500, z50, tGrip;
MoveL Offs(p_in,0,0,-60), v500, z10, tGrip;
MoveL Offs(p_in,0,80,-60), v500, z20, tGrip;
MoveC Offs(p_in,40,120,-60), Offs(p_in,0,160,-60), v300, z10, tGrip;
MoveL Offs(p_in,0,160,0), v500, fine, tGrip;
WaitTime 0.2;
MoveJ Offs(p_in,0,0,60), v2500, z50, tGrip;
MoveAbsJ j_home, vmax, fine, tGrip;"""
ARC = """MoveJ p_in, v2500, fine, tGrip;
MoveC Offs(p_in,40,40,0), Offs(p_in,0,80,0), v300, fine, tGrip;"""
ROWS = {"toppra": toppra, "ruckig": ruckig, "jerk": ruckig_jerk, "bang-bang": bang_bang_row}
P_IN = np.array([0.5, 0.3, 0.45])


@cache
def corners() -> Case:
    plant = plant_with_rail()
    return Case(rapid(BODY), plant, solver(plant))


@cache
def one_arc(body: str = ARC) -> Case:
    """The arc's plan is the coordinated one."""
    plant, program = plant_with_rail(), rapid(body)
    plan = optimize(program, plant, Target.RAPID, FIXED_RAIL, bounded=False)
    return Case(program, plant, lambda *_: plan)


@cache
def made(name: str) -> Trajectory:
    return attempt(ROWS[name](corners())).trajectory


def sampled(case: Case, rows: Trajectory) -> tuple[Array, Array, Array, Array, Array, Array]:
    """t, axes' q, qd, qdd, and the TCP's position and velocity, everywhere inside the intervals between rows."""
    t = (rows.t[:-1, None] + np.diff(rows.t)[:, None] * [1e-6, 0.3, 0.7, 1 - 1e-6]).ravel()
    q, qd, qdd = hermite(rows, t)
    X_FT = case.program.motions[0].tool.X_FT  # type: ignore[union-attr]
    tool = (case.plant.robot.forward(q) @ X_FT)[:, :3, 3]
    return t, q, qd, qdd, tool, (case.plant.robot.jacobian(q, X_FT)[:, :3] @ qd[..., None])[..., 0]


@pytest.mark.long
@pytest.mark.parametrize("row", ROWS)
def test_the_corners_are_those_of_the_zones(row: str) -> None:
    """Lines that meet at 90 deg: the parabola's middle is sqrt(2) / 4 of the zone from the point. On the arc the TCP
    keeps its radius outside the zones. Nothing stops before the stop."""
    case, rows = corners(), made(row)
    t, _, _, _, tool, V = sampled(case, rows)
    corner = np.add(P_IN, [0, 0, -0.06])
    away = np.linalg.norm(tool - corner, axis=1)
    assert away.min() == pytest.approx(0.01 * np.sqrt(2) / 4, rel=1e-3)
    in_arc = (tool[:, 0] > 0.5 + 0.021) & (tool[:, 2] < 0.4)
    radius = np.linalg.norm(tool[in_arc] - np.add(P_IN, [0, 0.12, -0.06]), axis=1)
    assert np.abs(radius - 0.04).max() < 1e-5
    stop = t[np.linalg.norm(tool - np.add(P_IN, [0, 0.16, 0]), axis=1).argmin()]
    driven = (t > 0.1) & (t < stop - 0.1)
    assert np.linalg.norm(V[driven], axis=1).min() > 0.05
    assert np.linalg.norm(V, axis=1).max() < 2.5 * (1 + 1e-9)


@pytest.mark.long
@pytest.mark.parametrize("row", ["toppra", "ruckig", "jerk"])
def test_every_limit_holds(row: str) -> None:
    case, rows = corners(), made(row)
    _, _, qd, qdd, tool, V = sampled(case, rows)
    limits = case.plant.limits
    assert (np.abs(qd) / limits.velocity).max() <= 1
    assert (np.abs(qdd) / limits.acceleration).max() <= 1 + 1e-6
    speed = np.linalg.norm(V, axis=1)
    on_arc = (tool[:, 0] > 0.5 + 0.021) & (tool[:, 2] < 0.4)
    on_line = (tool[:, 2] > 0.4) & (tool[:, 2] < 0.42) & (np.abs(tool[:, 0] - 0.5) < 1e-6)
    assert 0.25 < speed[on_arc].max() <= 0.3 * (1 + 1e-9)
    assert speed[on_line].max() <= 0.5 * (1 + 1e-9)


@pytest.mark.long
def test_toppra_takes_as_long_as_the_plan_that_is_optimal_on_it() -> None:
    assert made("toppra").duration == pytest.approx(fixed_rail_plan(corners()).duration, rel=2e-3)


def test_ruckig_is_slower_than_the_optimum_on_the_path_and_jerk_makes_it_slower() -> None:
    best = fixed_rail_plan(corners()).duration
    assert best * (1 - 1e-3) < made("ruckig").duration < best * 1.15
    assert made("ruckig").duration * 1.02 < made("jerk").duration


def test_jerk_holds_between_the_places_where_the_curvature_jumps() -> None:
    """Third differences over rows of a millisecond; rows beside the parts' ends, two each, may be anything."""
    case, rows = corners(), made("jerk")
    assert case.plant.limits.jerk is not None
    middles = (rows.t[1:] + rows.t[:-1]) / 2
    apart = np.diff(middles)
    jerk = np.abs(np.diff(hermite(rows, middles)[2], axis=0) / apart[:, None])[apart > 4e-4] / case.plant.limits.jerk
    given = fixed_rail(case)
    assert not isinstance(given, Infeasible)
    ends = sum(len(run.path.parts) for run in given.runs if run.path is not None)
    assert (jerk.max(axis=1) > 1.01).sum() <= 2 * ends < len(jerk) / 10


@pytest.mark.parametrize("row", ROWS)
def test_an_arc_between_stops(row: str) -> None:
    case = one_arc()
    rows = attempt(ROWS[row](case)).trajectory
    tool = sampled(case, rows)[4]
    on_arc = tool[int(np.linalg.norm(tool - P_IN, axis=1).argmin()) :]
    assert on_arc[:, 0].max() == pytest.approx(0.54, abs=1e-6)
    assert np.abs(np.linalg.norm(on_arc - np.add(P_IN, [0, 0.04, 0]), axis=1) - 0.04).max() < 1e-5
    np.testing.assert_allclose(on_arc[-1], np.add(P_IN, [0, 0.08, 0]), atol=1e-6)


@pytest.mark.parametrize(("row", "who"), [("toppra", "TOPP-RA"), ("ruckig", "Ruckig"), ("bang-bang", "the generator")])
def test_a_programmed_time_of_an_arc(row: str, who: str) -> None:
    case = one_arc(ARC.replace("v300", "v300\\T:=1.5"))
    rows = attempt(ROWS[row](case)).trajectory
    t, *_, tool, _ = sampled(case, rows)
    assert t[-1] - t[int(np.linalg.norm(tool - P_IN, axis=1).argmin())] == pytest.approx(1.5, abs=0.02)
    motions = (case.program.motions[0], *rapid(ARC.replace("v300", "v300\\T:=0.05")).motions[1:])
    short = replace(case.program, motions=motions)
    answer: Answer = ROWS[row](Case(short, case.plant, case.solve))
    assert isinstance(answer, Infeasible)
    assert f"cannot be made in 0.05 s: {who} needs " in str(answer)


TURNS = """MoveJ p_in, v500, fine, tGrip;
ConfL\\Off;
MoveL RelTool(p_in,0,0,0\\Rz:=20), v300\\T:=1, z50, tGrip;
MoveL RelTool(p_in,0,0,0\\Rx:=20), v300\\T:=1.2, fine, tGrip;"""
TIMED = (
    BODY.replace("v500, z20", "v500\\T:=0.6, z20").replace("v300, z10", "v300\\T:=1.1, z10").replace("z50", "fine", 1)
)


@pytest.mark.parametrize("body", [TIMED, TURNS])
@pytest.mark.parametrize("row", ["toppra", "ruckig"])
def test_a_programmed_time_beside_a_fly_by_is_a_speed(row: str, body: str) -> None:
    """The judge, who works it out from the way, refuses nothing; nothing is faster than the plan by more than grids."""
    plant = plant_with_rail()
    case = Case(rapid(body), plant, solver(plant, refined=False))
    found = attempt(ROWS[row](case))
    assert not broken(case, found)
    assert found.trajectory.duration > fixed_rail_plan(case).duration * 0.98


def test_a_course_between_its_nodes_is_what_its_derivatives_say() -> None:
    """Derivatives against central differences of the positions, and nodes as the path has them."""
    given = fixed_rail(corners())
    assert not isinstance(given, Infeasible)
    run = next(run for run in given.runs if run.by_parts)
    assert run.path is not None
    path, sampled, h = SmoothPath.of(run), run.path, 1e-4
    i = np.arange(len(path.kept))
    np.testing.assert_allclose(path.at(i, np.zeros(len(i))), sampled.along.q[sampled.first[path.kept]], atol=1e-9)
    np.testing.assert_allclose(
        path.at(i, np.ones(len(i)), 2), sampled.along.ddq[sampled.first[path.kept] + 1], atol=1e-6
    )
    for order in (1, 2, 3):
        middle = np.full(len(i), 0.4)
        around = path.at(i, middle + h, order - 1) - path.at(i, middle - h, order - 1)
        step = 2 * h * np.diff(path.sigma)[:, None]
        exact = path.at(i, middle, order)
        assert np.abs(around / step - exact).max() < 1e-5 * max(1.0, float(np.abs(exact).max()))


def test_a_run_at_rest_at_both_ends_has_one_speed_where_parts_meet() -> None:
    """The profile's rate is continuous: axes' speeds just before and after every switch agree."""
    given = fixed_rail(corners())
    assert not isinstance(given, Infeasible)
    run = next(run for run in given.runs if run.by_parts)
    piece = on_path(given.axes, run, caps_of(given.axes, run), None, _drive)
    before, after = (piece.at(piece.switches[1:-1] + side)[1] for side in (-1e-9, 1e-9))
    assert np.abs(after - before).max() < 1e-5
    ends = piece.at(np.array([0.0, piece.duration]))
    np.testing.assert_allclose(ends[1], 0.0, atol=1e-9)
    np.testing.assert_allclose(ends[0], [run.legs[0].q_0, run.legs[-1].q_1], atol=1e-14)


@cache
def contour() -> Case:
    """A quarter circle of 40 mm in 24 lines of 2.6 mm with zones of 2 mm: corners touch, nothing but rounding is left
    of the lines between them."""
    turns = np.pi / 2 * np.arange(1, 25) / 24
    lines = [
        f"MoveL Offs(p_in,{40 * np.sin(a):.4f},{40 - 40 * np.cos(a):.4f},0), v100, {zone}, tGrip;"
        for a, zone in zip(turns, [*["z5"] * 23, "fine"], strict=True)
    ]
    plant = plant_with_rail()
    program = rapid("\n".join(["MoveJ p_in, v1000, fine, tGrip;", *lines]))
    plan = optimize(program, plant, Target.RAPID, FIXED_RAIL, bounded=False)
    return Case(program, plant, lambda *_: plan)


@pytest.mark.parametrize(("row", "most"), [("toppra", 1.001), ("ruckig", 1.1), ("jerk", 2.5), ("bang-bang", 1.1)])
def test_corners_that_touch(row: str, most: float) -> None:
    plan = contour().solve(contour().program, Target.STREAM, FIXED_RAIL)
    assert not isinstance(plan, Infeasible)
    found = attempt(ROWS[row](contour()))
    assert not any("keep the plan's" in note for note in found.notes)
    assert found.trajectory.duration < plan.duration * most
    assert np.diff(found.trajectory.t).min() > 9e-6
    if row != "bang-bang":
        _, _, qd, qdd, _, _ = sampled(contour(), found.trajectory)
        limits = contour().plant.limits
        assert (np.abs(qd) / limits.velocity).max() <= 1
        assert (np.abs(qdd) / limits.acceleration).max() <= 1 + 1e-6


# A line without a way, and corners in which the tool changes; on the last line the first one is slower.
CHANGED = """MoveJ p_in, v500, fine, tGrip;
MoveL p_in, v500, z10, tGrip;
MoveL Offs(p_in,0,0,-60), v500, z10, tGrip;
MoveL Offs(p_in,0,60,-60), v500, z20, tool0;
MoveL RelTool(Offs(p_in,0,160,-60),0,0,0\\Rx:=40), v200, fine, tool0;"""


@pytest.mark.parametrize("row", ["toppra", "ruckig"])
def test_tools_that_change_in_corners_keep_their_own_caps(row: str) -> None:
    plant = plant_with_rail()
    case = Case(rapid(CHANGED), plant, solver(plant))
    assert broken(case, attempt(ROWS[row](case))) == []
