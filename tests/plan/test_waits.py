"""Waits of a microsecond and of a day: neither costs more than one of a second."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from small_cells import HOME, plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.plan.output_rows import output_rows
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.execution.rail import freed_by_default
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import HoldRail, Scenario, Settling
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.profiles import hold

pytestmark = pytest.mark.usefixtures("coarse")

BODY = """MoveJ p_in, v2500, fine, tool0;
WaitTime %s;
MoveAbsJ j_home, v2500, fine, tool0;"""
DAY = 86400.0


def freed(wait: str) -> Program:
    """The rail may move in the wait."""
    return freed_by_default(rapid(BODY % wait))


def solved(wait: float, target: Target, plant: Plant) -> Plan:
    program = rapid(BODY % f"{wait:.6f}")
    plan = optimize(program, plant, target, bounded=wait < 1)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    return plan


def test_the_rail_of_a_stream_moves_at_both_ends_of_a_day_and_that_of_a_controller_not_at_all() -> None:
    at = {target: problem_of(freed("86400"), plant_with_rail(), target=target) for target in Target}
    stream, controller = at[Target.STREAM], at[Target.RAPID]
    parts = stream.legs[1:-1]
    assert [leg.rail_moves for leg in parts] == [True, False, True]
    assert sum(leg.duration or 0.0 for leg in parts) == pytest.approx(DAY, abs=1e-10)
    # from 1 m/s to rest takes 1/3 s and 1/6 m, the rest of half the stroke as long as it is
    assert parts[0].duration == parts[2].duration >= 1.2
    assert stream.rests(2)
    assert stream.rests(3)
    assert not stream.rests(1)
    (wait,) = controller.legs[1:-1]
    assert (wait.rail_moves, wait.duration) == (False, DAY)
    short = problem_of(freed("1"), plant_with_rail(), target=Target.RAPID)
    assert [leg.rail_moves for leg in short.legs[1:-1]] == [True]


@pytest.mark.parametrize("target", Target)
def test_a_day_is_two_rows_and_what_moves_besides(target: Target) -> None:
    plan = solved(DAY, target, plant_with_rail((-0.16, 0.8)))
    wait = plan.motions[1]
    assert wait.t_1 - wait.t_0 == pytest.approx(DAY, abs=1e-9)
    assert np.diff(plan.trajectory.t).max() > 0.99 * DAY
    assert len(plan.trajectory.t) < 10_000


@pytest.mark.parametrize(("rest", "rows"), [(59.0, 59_001), (60.0, 2)])
def test_a_rest_has_even_rows_up_to_a_minute_and_two_from_there_on(rest: float, rows: int) -> None:
    axes, q = Axes.of(plant_with_rail()), np.r_[0.3, HOME]
    trajectory, _ = output_rows(axes, [hold(rest, q)], q)
    assert len(trajectory.t) == rows
    np.testing.assert_allclose(np.diff(trajectory.t), rest / (rows - 1), rtol=1e-6)
    assert trajectory.qd is not None
    assert not trajectory.qd.any()
    assert (trajectory.q == q).all()


@cache
def without_a_wait() -> Plan:
    program, plant = rapid(BODY.replace("WaitTime %s;\n", "")), plant_with_rail((-0.16, 0.8))
    plan = optimize(program, plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    return plan


@pytest.mark.parametrize("wait", [1e-6, 1e-3])
def test_the_shortest_wait_is_planned_and_bounded(wait: float) -> None:
    plan = solved(wait, Target.RAPID, plant_with_rail((-0.16, 0.8)))
    none = without_a_wait()
    assert plan.duration - wait == pytest.approx(none.duration, abs=1e-6)
    assert plan.lower_bound is not None
    assert plan.lower_bound <= plan.duration


def test_without_a_rail_nothing_moves_in_a_wait() -> None:
    plan = solved(DAY, Target.STREAM, plant_without_rail())
    assert np.diff(plan.trajectory.t).max() == pytest.approx(DAY, rel=1e-12)


def test_a_move_lasts_as_long_as_what_runs_beside_it_and_the_judge_holds_it_to_that() -> None:
    body = "MoveJ p_a,v2500,fine,tool0; MoveJ \\Conc,p_b,v2500,%s,tool0; WaitTime %g; MoveJ p_a,v2500,fine,tool0;"
    data = "".join(
        f"CONST robtarget p_{name}:=[[500,{y},500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
        for name, y in (("a", -150), ("b", 150))
    )
    plant = plant_without_rail()
    plans = {}
    for zone, wait in (("fine", 0.0), ("fine", 0.2), ("fine", 1.5), ("z10", 1.5)):
        program = rapid("ConfJ \\Off; " + body % (zone, wait), None, data)
        plan = optimize(program, plant, Target.STREAM, bounded=False)
        assert isinstance(plan, Plan), plan
        assert verify(program, plant, plan.trajectory, advice=False).legal
        plans[zone, wait] = program, plan
    _, bare = plans["fine", 0.0]
    alone = bare.motions[1].t_1 - bare.motions[1].t_0
    assert 0.2 < alone < 1.5
    assert plans["fine", 0.2][1].duration == pytest.approx(bare.duration, abs=1e-6)
    for zone in ("fine", "z10"):
        program, plan = plans[zone, 1.5]
        assert plan.duration == pytest.approx(1.5 + bare.duration - alone, abs=1e-6)
        assert plan.motions[1].binding == "wait beside it"
        failed = [f.check for f in verify(program, plant, bare.trajectory, advice=False).findings if not f.passed]
        assert failed == ["duration"]


@pytest.mark.parametrize("target", Target)
def test_what_settles_is_in_every_plan_and_bound_and_no_axis_moves_meanwhile(target: Target) -> None:
    plant, plans, programs = plant_with_rail(), dict[float, Plan](), dict[float, Program]()
    far = BODY.replace("j_home", "[[0,0,0,0,30,0],[1500,9E9,9E9,9E9,9E9,9E9]]") % "0.3"
    for time in (0.0, 0.2):
        scenario = Scenario(settle=Settling(time), hold_rail=HoldRail(free=True))
        programs[time] = rapid(far, scenario)
        plan = optimize(programs[time], plant, target)
        assert isinstance(plan, Plan)
        plans[time] = plan
    none, plan = plans[0.0], plans[0.2]
    assert None not in (none.lower_bound, plan.lower_bound)
    aimed = 1e-3 if target is Target.RAPID else 0.02  # no bound is told closer than what it aims at
    assert plan.lower_bound == pytest.approx((none.lower_bound or 0.0) + 0.2, abs=aimed)
    _, settles, wait, _ = plan.motions
    assert settles.t_1 - settles.t_0 == pytest.approx(0.2, abs=1e-9)
    np.testing.assert_array_equal(settles.q_0, settles.q_1)
    assert np.abs(wait.q_1 - wait.q_0)[0] > 1e-3  # the wait itself is used
    report = verify(programs[0.2], plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    missing = verify(programs[0.2], plant, none.trajectory, target=target, advice=False)
    found = [(f.check, f.source.line) for f in missing.findings if not f.passed and f.source]
    assert found == [("dwell length", 6), ("way while held", 5)]  # the wait is short, and the rail moves before it
    if target is Target.STREAM:  # whose rail would have driven through the stop
        assert plan.duration >= none.duration + 0.2 - 1e-6
        return
    assert plan.duration == pytest.approx(none.duration + 0.2, abs=1e-4)
    scenario = Scenario(settle=Settling(0.2), hold_rail=HoldRail(free=True))
    export = export_rapid(programs[0.2], plan, plant, scenario=scenario)
    (text,) = export.texts.values()
    assert "WaitTime" not in text  # a line in its place, and nothing for what settles
    read = run_program([TextFile("t.mod", text, "utf-8")], scenario)
    again = optimize(read, plant, target, AS_WRITTEN, bounded=False)
    assert isinstance(again, Plan)
    assert again.duration == pytest.approx(plan.duration, abs=1e-4)
