"""Plans of least effort in a given time: closed forms, the time held, and never more effort than driving slower."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, rapid
from unrefined import IMPROVED

from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.plan.local_refinement import refine
from trajopt_cli.plan.min_effort import spread
from trajopt_cli.problem.objective import GENTLE, LeastEffort, Objective
from trajopt_cli.problem.plan import Eased, Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant

pytestmark = pytest.mark.usefixtures("coarse")

APART = "CONST jointtarget j_off:=[[40,10,-20,30,60,-50],[0,9E9,9E9,9E9,9E9,9E9]];"
AWAY = "MoveAbsJ j_off, v5000, fine, tool0;"
SHORT = """MoveJ p_in, v1000, fine, tool0;
WaitTime 0.3;
MoveAbsJ j_home, v1000, fine, tool0;"""
STATION = """MoveJ p_in, v1000, fine, tool0;
MoveL p_low, v500, fine, tool0;
WaitTime 0.3;"""


IN_TIME = LeastEffort(4.5)
Streams = dict[Objective, tuple[Plan, Eased]]


def planned(program: Program, target: Target, objective: Objective, plant: Plant | None = None) -> tuple[Plan, Eased]:
    """A plan of least effort, which the judge finds legal."""
    plant = plant or plant_with_rail()
    plan = optimize(program, plant, target, bounded=False, objective=objective)
    assert isinstance(plan, Plan), plan
    assert plan.eased is not None
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [finding.message for finding in report.findings if not finding.passed]
    return plan, plan.eased


@cache
def away(target: Target) -> tuple[Plan, Eased]:
    return planned(rapid(AWAY, data=APART), target, LeastEffort(3.0), plant_without_rail())


@pytest.mark.parametrize("target", Target)
def test_a_joint_move_alone_has_the_effort_of_the_closed_form(target: Target) -> None:
    plant = plant_without_rail()
    plan, eased = away(target)
    d = np.radians([40, 10, -20, 30, 30, -50])  # from home to there
    wanted = float(np.sum(12 * (d / plant.limits.acceleration) ** 2) / 3.0**3)  # of a cubic from rest to rest
    assert plan.duration == pytest.approx(3.0, abs=1e-9)
    assert eased.planned.effort == pytest.approx(wanted, rel=3e-3)  # the acceleration is constant in each interval
    assert eased.planned.effort > wanted * (1 - 1e-9)


@pytest.fixture(scope="module")
def streamed() -> Streams:
    """Of one program in a given time and in the least; the fastest motion is looked for once."""
    found = []

    def once(*args: Any) -> object:
        found[:] = found or [refine(*args)]
        return found[0]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(IMPROVED, once)
        return {asked: planned(rapid(SHORT), Target.STREAM, asked) for asked in (IN_TIME, GENTLE)}


def gentler_than_slower(plan: Plan, eased: Eased, share: float = 1.0) -> bool:
    """Whether the plan has less than a share of the effort of the fastest driven slower, its wait of 0.3 s as it is."""
    slower = (plan.duration - 0.3) / (eased.least_time - 0.3)
    return slower > 1 and eased.planned.effort < share * eased.fastest.effort / slower**3


@pytest.mark.long
def test_a_stream_holds_its_time_and_no_slower_driving_is_gentler(streamed: Streams) -> None:
    plan, eased = streamed[IN_TIME]
    assert plan.duration == pytest.approx(4.5, abs=1e-9)
    assert gentler_than_slower(plan, eased)


def test_a_rapid_plan_holds_its_time_and_no_slower_driving_is_gentler() -> None:
    plan, eased = planned(rapid(STATION), Target.RAPID, LeastEffort(3.0))
    assert plan.duration == pytest.approx(3.0, abs=1e-9)
    assert gentler_than_slower(plan, eased, 0.7)


def test_the_effort_of_the_rows_is_the_effort_that_is_told(streamed: Streams) -> None:
    plan, eased = streamed[IN_TIME]
    h, A = np.diff(plan.trajectory.t), plant_with_rail().limits.acceleration
    assert plan.trajectory.qd is not None
    means = np.diff(plan.trajectory.qd, axis=0) / h[:, None] / A
    assert np.sum(h[:, None] * means**2) == pytest.approx(eased.planned.effort, rel=1e-4)
    way = np.abs(np.diff(plan.trajectory.q[:, 0])).sum()
    assert way == pytest.approx(eased.planned.rail_way, rel=1e-4)


@pytest.mark.parametrize("target", Target)
def test_at_the_least_time_and_a_hair_a_plan_is_gentler(target: Target, streamed: Streams) -> None:
    plan, eased = streamed[GENTLE] if target is Target.STREAM else planned(rapid(SHORT), target, GENTLE)
    assert eased.least_time <= plan.duration <= eased.least_time * (1 + 1e-4)
    share = 0.95 if target is Target.STREAM else 1.0
    assert eased.planned.effort < share * eased.fastest.effort


def test_too_short_a_time_is_the_answer_no() -> None:
    answer = optimize(rapid(STATION), plant_with_rail(), Target.RAPID, bounded=False, objective=LeastEffort(1.0))
    assert isinstance(answer, Infeasible)
    assert str(answer).startswith("t.mod:7:1: the rapid plan shall end here after 1 s; the least time found is 1.2")


def test_the_other_target_takes_its_least_time_where_the_given_one_is_too_short() -> None:
    plan, eased = planned(rapid(STATION), Target.RAPID, LeastEffort(1.0, or_least=True))
    assert plan.duration == pytest.approx(eased.least_time, rel=1e-4)


def test_corners_are_driven_gently_too() -> None:
    body = f"MoveAbsJ j_mid, v5000, z50, tool0;\n{AWAY}"
    data = f"{APART}\nCONST jointtarget j_mid:=[[20,-10,10,0,30,20],[0,9E9,9E9,9E9,9E9,9E9]];"
    plan, eased = planned(rapid(body, data=data), Target.RAPID, LeastEffort(2.0), plant_without_rail())
    slower = plan.duration / eased.least_time
    assert eased.planned.effort < 0.9 * eased.fastest.effort / slower**3


def test_time_that_no_leg_can_take_is_a_rest() -> None:
    body = r"MoveAbsJ j_off, v1000 \T:=2, fine, tool0;"
    plan, eased = planned(rapid(f"{AWAY}\n{body}", data=APART), Target.RAPID, LeastEffort(5.0), plant_without_rail())
    assert plan.duration == pytest.approx(5.0, abs=1e-9)
    assert eased.planned.effort < 0.5 * eased.fastest.effort


def test_equal_questions_have_equal_rows() -> None:
    plans = [question(Target.STREAM)[0] for question in (away, away.__wrapped__)]
    texts = [write_csv_text(plan.trajectory) for plan in plans]
    assert texts[0] == texts[1]


def test_time_goes_where_it_spares_most() -> None:
    rng = np.random.default_rng(1)
    for _ in range(50):
        times, efforts, least = rng.uniform(0.1, 2, (3, 6))
        total = float(times @ least) * rng.uniform(1.01, 4)
        k = spread(times, efforts, least, total)
        assert times @ k == pytest.approx(total, rel=1e-12)
        assert np.all(k >= least)
        gain = 3 * efforts / times / k**4  # of effort per second more
        free = k > least * (1 + 1e-9)
        assert np.ptp(gain[free]) < 1e-9 * gain.max()
        assert np.all(gain[~free] <= gain[free].min() * (1 + 1e-9))
