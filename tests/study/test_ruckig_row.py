"""Rows ruckig and ruckig jerk: legal by the judge, between known times, jerk held, programmed times kept."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from timed_rows import attempt, broken, case_of, fixed_rail_plan, plant_with_rail, rapid, solver

from trajopt_cli.limits import TcpCaps
from trajopt_cli.problem.plan import Infeasible, Plan, PlannedMotion, Target
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.study.case import Answer, Attempt, Case, NotApplicable
from trajopt_cli.study.ruckig_row import ruckig, ruckig_jerk
from trajopt_cli.trajectory import Trajectory, hermite

pytestmark = pytest.mark.usefixtures("coarse")

ROWS = {"free jerk": ruckig, "jerk": ruckig_jerk}


@cache
def timed(name: str, row: str) -> Attempt:
    return attempt(ROWS[row](case_of(name)))


@pytest.mark.long
@pytest.mark.parametrize("name", ["hinge_cell", "everything_once"])
@pytest.mark.parametrize("row", ROWS)
def test_it_is_legal_and_slower_than_the_plan_it_stands_on(name: str, row: str) -> None:
    case = case_of(name)
    made = timed(name, row)
    assert [str(finding) for finding in broken(case, made)] == []
    plan = fixed_rail_plan(case)
    # the optimiser may vary its acceleration along a line; this one may not. 1e-3: what the plan keeps of its limits
    assert plan.duration * (1 - 1e-3) < made.trajectory.duration < plan.duration * 1.5
    if name == "everything_once":
        again = attempt(ROWS[row](case))
        np.testing.assert_array_equal(made.trajectory.q, again.trajectory.q)


def test_hinge_cell_beats_the_known_figure() -> None:
    """7.95 s is what somebody else's program got from Ruckig alone with the rail at rest in lines."""
    assert timed("hinge_cell", "free jerk").trajectory.duration < 7.95


@pytest.mark.parametrize("name", ["hinge_cell", "everything_once"])
def test_jerk_stays_within_the_profiles_limits(name: str) -> None:
    """Differences of the acceleration in the middle of rows a millisecond apart, the same everywhere a bit longer."""
    case = case_of(name)
    jerk = case.plant.limits.jerk
    assert jerk is not None
    made = timed(name, "jerk").trajectory
    middles = (made.t[1:] + made.t[:-1]) / 2
    qdd = hermite(made, middles)[2]
    apart = np.diff(middles)[:, None]
    long = apart[:, 0] > 4e-4
    used = np.abs(np.diff(qdd, axis=0) / apart)[long] / jerk
    assert used.max() < 1.01
    assert used.max() > 0.9
    free = timed(name, "free jerk").trajectory
    assert made.duration > free.duration * 1.02


def test_without_jerk_limits_there_is_nothing_to_say() -> None:
    case = case_of("everything_once")
    bare = replace(case.plant, limits=replace(case.plant.limits, jerk=None))
    assert ruckig_jerk(Case(case.program, bare, case.solve)) == NotApplicable(
        "the robot's profile gives no jerk limits"
    )


def test_programmed_times_are_kept_and_too_short_ones_refused() -> None:
    case = case_of("everything_once")
    made = timed("everything_once", "free jerk")
    assert {motion.duration for motion in made.program.motions if getattr(motion, "duration", None)} == {0.12, 0.6, 1.4}
    plan = fixed_rail_plan(case)
    hurried = case.program.motions[5]
    motions = (*case.program.motions[:5], replace(hurried, duration=0.2), *case.program.motions[6:])  # type: ignore[call-arg]
    short = replace(case.program, motions=motions)
    answer: Answer = ruckig(Case(short, case.plant, lambda *_: plan))
    assert isinstance(answer, Infeasible)
    assert answer.index == 5
    assert "t.mod:9:1: MoveAbsJ j_home cannot be made in 0.2 s: Ruckig needs " in str(answer)


def test_a_tcp_cap_slows_the_move_no_more_than_it_must() -> None:
    """A cap of 1 m/s on a joint move: used to within a percent, and everything else as before."""
    plant = plant_with_rail(tcp=TcpCaps(1.0, 20.0), free_speed=True)
    program = rapid("MoveJ p_in, vmax, fine, tool0;\nMoveAbsJ j_home, vmax, fine, tool0;")
    case = Case(program, plant, solver(plant, refined=False))
    made = attempt(ruckig(case)).trajectory
    assert made.qd is not None
    v = np.linalg.norm((plant.robot.jacobian(made.q) @ made.qd[..., None])[:, :3, 0], axis=1)
    assert 0.99 < v.max() <= 1.0
    assert broken(case, attempt(ruckig(case))) == []


def test_a_program_that_cannot_be_planned_says_why() -> None:
    case = case_of("everything_once")
    no = Infeasible(1, case.program.motions[1].source, "no")
    assert ruckig(Case(case.program, case.plant, lambda *_: no)) is no


@pytest.mark.parametrize("body", ["MoveL Offs(p_in,60,0,-80), v500, fine, tool0;", "MoveL p_in, v500, fine, tool0;"])
def test_the_rail_may_move_on_a_line_and_while_the_tcp_rests(body: str) -> None:
    """A plan whose rail goes on by 50 mm, along 100 mm of line or none at all: in proportion, and legal."""
    program, plant = rapid(body), plant_with_rail()
    line = program.motions[0]
    X_0 = rapid("MoveJ p_in, v500, fine, tool0;").motions[0].X_WT  # type: ignore[union-attr]
    X_1 = line.X_WT  # type: ignore[union-attr]
    q_0, q_1 = (
        np.r_[rail, inverse(plant.robot, X[None], np.array([rail]))[0, 0]] for rail, X in ((0.1, X_0), (0.15, X_1))
    )
    plant = replace(plant, start=q_0)
    planned = PlannedMotion(0, line.source, 0.0, 1.0, q_0, q_1, "")
    rows = Trajectory(plant.robot.axis_names, np.array([0.0, 1.0]), np.array([q_0, q_1]))
    plan = Plan(Target.STREAM, rows, (planned,), None, "")
    case = Case(program, plant, lambda *_: plan)
    for row in ROWS.values():
        made = attempt(row(case))
        assert [str(finding) for finding in broken(case, made)] == []
        np.testing.assert_allclose(made.trajectory.q[-1], q_1, atol=1e-12)
        share = np.linalg.norm(plant.robot.forward(made.trajectory.q)[:, :3, 3] - X_0[:3, 3], axis=1) / 0.1
        if np.linalg.norm(X_1 - X_0) > 0:
            np.testing.assert_allclose(made.trajectory.q[:, 0], 0.1 + 0.05 * share, atol=1e-9)
