"""Row toppra: legal by the judge, on the plan's path, as fast as the plan that was optimal on it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from timed_rows import attempt, broken, case_of, fixed_rail_plan

from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.study.case import Answer, Case
from trajopt_cli.study.toppra_row import toppra

pytestmark = pytest.mark.usefixtures("coarse")


@pytest.mark.parametrize("name", ["hinge_cell", "bench_irb140", "everything_once"])
def test_it_is_legal_and_as_fast_as_the_plan(name: str) -> None:
    """The plan is the fastest on its own path up to what it keeps of its limits: 0.1 % is TOPP-RA's discretisation."""
    case = case_of(name)
    made = attempt(toppra(case))
    assert [str(finding) for finding in broken(case, made)] == []
    assert made.trajectory.duration == pytest.approx(fixed_rail_plan(case).duration, rel=1e-3)
    assert not any("keep the plan's" in note for note in made.notes)
    if name == "bench_irb140":
        np.testing.assert_array_equal(made.trajectory.q, attempt(toppra(case)).trajectory.q)


def test_a_slow_plan_gets_faster() -> None:
    """The same path at 80 % of its speed: its waits stay as long, its moves come back to what they were."""
    case = case_of("hinge_cell")
    plan = fixed_rail_plan(case)
    slow = 1.25
    trajectory = replace(
        plan.trajectory,
        t=plan.trajectory.t * slow,
        qd=None if plan.trajectory.qd is None else plan.trajectory.qd / slow,
    )
    motions = tuple(replace(motion, t_0=motion.t_0 * slow, t_1=motion.t_1 * slow) for motion in plan.motions)
    slowed = replace(plan, trajectory=trajectory, motions=motions)
    made = attempt(toppra(Case(case.program, case.plant, lambda *_: slowed)))
    assert made.trajectory.duration == pytest.approx(plan.duration, rel=2e-3)
    assert broken(case, made) == []


def test_it_keeps_to_the_plans_path() -> None:
    """Every row lies on the plan's joint path: distance to the nearest of its rows, which are a millisecond apart."""
    case = case_of("hinge_cell")
    plan, made = fixed_rail_plan(case), attempt(toppra(case)).trajectory
    path = plan.trajectory.q
    for q in made.q[:: len(made.q) // 200]:
        assert np.abs(path - q).max(axis=1).min() < 2.5e-3  # half a millisecond at 4.5 rad/s


def test_too_short_a_time_is_refused() -> None:
    case = case_of("everything_once")
    plan = fixed_rail_plan(case)
    hurried = case.program.motions[5]
    motions = (*case.program.motions[:5], replace(hurried, duration=0.2), *case.program.motions[6:])  # type: ignore[call-arg]
    answer: Answer = toppra(Case(replace(case.program, motions=motions), case.plant, lambda *_: plan))
    assert isinstance(answer, Infeasible)
    assert "t.mod:9:1: MoveAbsJ j_home cannot be made in 0.2 s: TOPP-RA needs " in str(answer)


def test_other_robots_that_take_longer_are_waited_for() -> None:
    case = case_of("everything_once")
    plan = fixed_rail_plan(case)
    first = replace(case.program.motions[0], identity=1, partner=2.5)  # type: ignore[call-arg]
    together = replace(case.program, motions=(first, *case.program.motions[1:]))
    before = attempt(toppra(case)).trajectory.duration
    made = attempt(toppra(Case(together, case.plant, lambda *_: plan)))
    own = plan.motions[0].t_1 - plan.motions[0].t_0
    assert made.trajectory.duration - before == pytest.approx(2.5 - own, rel=2e-3)
