r"""Synchronised moves (\ID): they last as long as the slowest robot, and who does not know that promises nothing."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from small_cells import DATA, plant_without_rail, rapid

from trajopt_cli.job import read_job
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Move, Program
from trajopt_cli.plan import lower_bound_of, optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report.stepwise import analyse
from trajopt_cli.scenario import Scenario

pytestmark = pytest.mark.usefixtures("coarse", "unrefined")

STOPS = r"""MoveJ p_in, v500, z10, tool0;
SyncMoveOn s1, both;
MoveL p_low \ID:=10, v500, fine, tool0;
MoveL p_low \ID:=20, v500, fine, tool0;
MoveJ p_in \ID:=30, v500 \T:=0.5, fine, tool0;
MoveAbsJ j_home \ID:=40, v500, fine, tool0;
SyncMoveOff s1;"""
CORNERS = r"""MoveJ p_in, v500, fine, tool0;
SyncMoveOn s1, both;
MoveL p_low \ID:=10, v200, z10, tool0;
MoveL Offs(p_low,0,-80,0) \ID:=20, v200, z10, tool0;
MoveJ p_in \ID:=30, v200, fine, tool0;
SyncMoveOff s1;"""


def program_of(body: str, **partner: float) -> Program:
    scenario = Scenario(partner={int(name[1:]): time for name, time in partner.items()})
    near = body.replace("p_in", "Offs(p_in,0,-600,0)").replace("p_low", "Offs(p_low,0,-600,0)")
    return rapid(near, scenario, "VAR syncident s1; VAR tasks both{2};")


def times_of(program: Program, plan: Plan) -> dict[int, float]:
    moves = {i: one for i, one in enumerate(program.motions) if isinstance(one, Move) and one.identity is not None}
    return {moves[one.index].identity or 0: one.t_1 - one.t_0 for one in plan.motions if one.index in moves}


@cache
def plan_of(body: str, target: Target, **partner: float) -> tuple[Program, Plant, Plan]:
    program, plant = program_of(body, **partner), plant_without_rail()
    plan = optimize(program, plant, target, bounded=False)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [one.message for one in report.findings if not one.passed]
    return program, plant, plan


@pytest.mark.parametrize("target", Target)
def test_between_stops_a_move_lasts_as_long_as_the_slower_robot(target: Target) -> None:
    program, _, alone = plan_of(STOPS, target)
    own = times_of(program, alone)
    assert own[30] == pytest.approx(0.5, abs=1e-9)
    assert own[20] == pytest.approx(0.0, abs=1e-9)
    others = {10: 1.5, 20: 0.3, 30: 0.8, 40: 0.9 * own[40]}
    program, plant, plan = plan_of(STOPS, target, **{f"_{name}": time for name, time in others.items()})
    times = times_of(program, plan)
    assert times == pytest.approx({name: max(own[name], others[name]) for name in others}, abs=2e-5)
    assert {one.binding for one in plan.motions if one.index in (2, 3)} == {"partner"}
    assert sum(others.values()) <= lower_bound_of(program, plant, plan) <= plan.duration


@pytest.mark.parametrize("target", Target)
def test_a_corner_is_passed_and_each_move_beside_it_takes_its_time(target: Target) -> None:
    program, _, alone = plan_of(CORNERS, target)
    own = times_of(program, alone)
    others = {10: 1.25, 20: 0.5 * own[20], 30: 0.9}
    program, plant, plan = plan_of(CORNERS, target, **{f"_{name}": time for name, time in others.items()})
    times = times_of(program, plan)
    for name, least in ((10, 1.25), (30, 0.9)):
        assert least - 1e-6 <= times[name] <= least * (1 + 1e-4)
    assert own[20] * 0.99 <= times[20] <= own[20] * 1.2  # it only begins and ends slower
    assert plan.duration - sum(times.values()) == pytest.approx(alone.duration - sum(own.values()), abs=2e-3)
    assert lower_bound_of(program, plant, plan) >= 1.25 + 0.9
    # another distribution of the same time: the judge looks at each move beside its corners
    moves = [one for one in program.motions if isinstance(one, Move)]
    swapped = {10: 0.1, 20: 1.1, 30: 0.1}
    motions = tuple(
        replace(one, partner=swapped[one.identity]) if one in moves and one.identity else one for one in program.motions
    )
    report = verify(replace(program, motions=motions), plant, plan.trajectory, target=target, advice=False)
    failed = [(one.check, one.source.line) for one in report.findings if not one.passed and one.source]
    assert failed == [("partner", 8)]


def test_the_judge_wants_all_of_the_other_robots_time() -> None:
    program, plant, plan = plan_of(STOPS, Target.RAPID, _10=1.5)
    motions = [replace(one, partner=1.5 + 1e-4) if getattr(one, "partner", None) else one for one in program.motions]
    report = verify(replace(program, motions=tuple(motions)), plant, plan.trajectory, advice=False)
    assert [(one.check, one.source and one.source.line) for one in report.findings if not one.passed] == [
        ("partner", 7)
    ]


RAIL = r"""MoveJ p_in, v2500, fine, tool0;
SyncMoveOn s1, both;
MoveL p_low \ID:=10, v2500, fine, tool0;
MoveL p_in \ID:=20, v2500, fine, tool0;
WaitTime 0.2;
MoveJ Offs(p_in,0,300,0) \ID:=30, v2500, fine, tool0;
SyncMoveOff s1;
MoveAbsJ j_home, v2500, fine, tool0;"""


def test_nothing_is_saved_in_moves_of_which_nobody_knows_the_other_robots_time(tmp_path: Path) -> None:
    text = f"MODULE T\nVAR syncident s1; VAR tasks both{{2}};\n{DATA}\nPROC main()\n{RAIL}\nENDPROC\nENDMODULE\n"
    (tmp_path / "t.mod").write_text(text)
    cell = (
        "robot: irb140_rail\nrail: {eax: a, stroke: [-0.1, 1.2]}\nstart: {joints: [0, 0, 0, 0, 0.5236, 0], rail: 0}\n"
    )
    cell += "limits: {rail: {velocity: 1, acceleration: 3, source: test}}\n"
    (tmp_path / "t.yaml").write_text(f"{cell}partner: {{10: 1.0}}\n")
    job = read_job(tmp_path / "t.mod")
    assert sum("t.mod:10-12" in str(one) for one in job.program.warnings) == 1
    written = optimize(job.program, job.plant, Target.RAPID, AS_WRITTEN, bounded=False)
    free = optimize(job.program, job.plant, Target.STREAM, bounded=False)
    assert isinstance(written, Plan)
    assert isinstance(free, Plan)
    before, after = times_of(job.program, written), times_of(job.program, free)
    assert before[10] == pytest.approx(1.0, abs=2e-5)
    assert [name for name in before if after[name] < before[name] - 2e-5] == []
    assert free.duration < written.duration - 0.01, "the other moves get faster"


def test_steps_of_speed_wait_for_the_other_robots_too() -> None:
    program = program_of(STOPS, _10=1.5, _20=0.3)
    taken = {program.motions[one.index].identity: one.duration for one in analyse(program, plant_without_rail()).moves}
    assert (taken[10], taken[20], taken[30]) == (1.5, 0.3, 0.5)


def test_a_plan_of_least_effort_takes_no_time_from_the_other_robots() -> None:
    program, plant, plan = plan_of(STOPS, Target.RAPID, _10=1.5, _30=0.8)
    gentle = optimize(program, plant, Target.RAPID, bounded=False, objective=LeastEffort(plan.duration + 0.5))
    assert isinstance(gentle, Plan)
    assert gentle.duration == pytest.approx(plan.duration + 0.5, abs=1e-6)
    report = verify(program, plant, gentle.trajectory, target=Target.RAPID, advice=False)
    assert report.legal, [one.message for one in report.findings if not one.passed]


@pytest.mark.parametrize("share", [1.001, 1.02])
def test_a_little_later_than_alone_is_found_as_well(share: float) -> None:
    program, _, alone = plan_of(CORNERS, Target.RAPID)
    others = {name: share * time for name, time in times_of(program, alone).items()}
    program, _, plan = plan_of(CORNERS, Target.RAPID, **{f"_{name}": time for name, time in others.items()})
    assert times_of(program, plan) == pytest.approx(others, rel=5e-3)
