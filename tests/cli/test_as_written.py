"""What was saved against the program as it stands: the first line of the answer, the table, the summary."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from fake_planner import Planner

from trajopt_cli.cli import run
from trajopt_cli.findings import Report
from trajopt_cli.job import read_job
from trajopt_cli.judge.findings import finding
from trajopt_cli.pipeline import planning
from trajopt_cli.pipeline.planning import changes_of
from trajopt_cli.plan import PlanCache, initial_plan, optimize, search_estimate
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.runs.uncertainty import between, changes
from trajopt_cli.trajectories.axes import Axes


def test_the_answer_begins_with_what_was_saved(
    program: Path,
    planner: Planner,
    capsys: pytest.CaptureFixture[str],
) -> None:
    planner.freest = 1.0 / 0.9  # plans that may choose the configuration are faster: not the program as written
    planner.speed = 0.9
    assert run(["optimize", str(program)]) == 0
    out = capsys.readouterr().out
    plans = json.loads(Path("results/tiny/summary.json").read_text())
    before, rapid, stream = (
        plans["as_written"]["cycle_time_s"],
        *(plans["plans"][one]["cycle_time_s"] for one in Target),
    )
    assert stream < rapid < before
    percent = [f"{100 * (1 - after / before):.1f}" for after in (rapid, stream)]
    hows = ("by the RAPID controller", "as a joint stream")
    ranges = [plans["uncertainty"]["saving_range"].get(one) for one in Target]
    assert ranges[0] is None  # joint_1 alone moves, and the cell file has its limits
    least, most = ranges[1]
    assert least < 1 - stream / before < most + 1e-3
    told = [
        f"{after:.3f} s (−{share} %{f', {changes(ends)}' if ends else ''}) {how}"
        for after, share, ends, how in zip((rapid, stream), percent, ranges, hows, strict=True)
    ]
    assert out.splitlines()[0].startswith(f"as written {before:.3f} s → {told[0]}, {told[1]}")
    low, high = plans["uncertainty"]["cycle_time_range_s"]["stream"]
    assert low <= stream < high
    assert f"{between((low, high))} s" in Path("results/tiny/report.html").read_text()
    assert "rapid [s]   stream [s]   what limits the rapid plan" in out
    assert "grid" not in out
    assert run(["optimize", str(program), "--target", "stream", "-v"]) == 0
    out = capsys.readouterr().out
    assert out.splitlines()[0].startswith(f"as written {before:.3f} s → {told[1]}, {told[0]}")
    assert "stream [s]   rapid [s]   what limits the stream plan" in out
    assert out.count(", grid ") == 2
    times = plans["as_written"]["motion_times_s"]
    assert sum(times) == pytest.approx(before)
    assert f"{times[0]:.3f}" in next(line for line in out.splitlines() if "j_side" in line)


def test_a_program_that_cannot_be_driven_as_written_is_told_so(
    program: Path,
    planner: Planner,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    right = planner.__call__

    class Picky(Planner):
        def __call__(self, program, plant, target, freedom=None, *arguments, **more):  # type: ignore[no-untyped-def]
            if freedom == AS_WRITTEN:
                return Infeasible(0, program.motions[0].source, "MoveAbsJ j_side cannot be reached")
            return right(program, plant, target, *arguments, **more)

    monkeypatch.setattr("trajopt_cli.plan.optimize", Picky())
    assert run(["optimize", str(program)]) == 0
    out = capsys.readouterr().out
    assert out.startswith("as written it cannot be driven (tiny.mod:6:9) → ")
    assert "as written it cannot be driven: tiny.mod:6:9: MoveAbsJ j_side cannot be reached\n" in out
    written = json.loads(Path("results/tiny/summary.json").read_text())["as_written"]
    assert written["cycle_time_s"] is None
    assert written["why_not"] == "tiny.mod:6:9: MoveAbsJ j_side cannot be reached"


@pytest.mark.parametrize(("freest", "judged"), [(1.0, []), (1.0 / 0.9, ["as written"])])
def test_the_program_as_written_is_judged_where_its_rows_are_not_those_of_the_rapid_plan(
    freest: float, judged: list[str], program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch
) -> None:
    right, names = planning.judge, list[str]()

    def judge(plant, program, text, file, *more, **others):  # type: ignore[no-untyped-def]
        names.append(file)
        report = right(plant, program, text, file, *more, **others)
        over = finding("joint speed", "joint_1", 3.0, 2.0, "rad/s", False, time=0.2)
        return Report((*report.findings, over), report.advice) if file == "as written" else report

    planner.speed, planner.freest = 0.9, freest
    monkeypatch.setattr(planning, "judge", judge)
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    assert [one for one in names if one == "as written"] == judged
    written = json.loads(Path("results/tiny/summary.json").read_text())["as_written"]
    assert (written["cycle_time_s"] is None) == bool(judged)


def test_a_motion_in_memory_is_the_one_that_would_be_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And is known to be in reach; what its search took is that of the search alone."""
    text = (
        "MODULE m\nCONST jointtarget j:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        "CONST robtarget p:=[[450,0,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        "PROC main()\nMoveJ p,v500,fine,tool0;\nMoveL Offs(p,0,0,-20),v100,fine,tool0;\nMoveAbsJ j,v500,fine,tool0;\n"
        "ENDPROC\nENDMODULE\n"
    )
    (tmp_path / "m.mod").write_text(text)
    (tmp_path / "m.yaml").write_text(
        'robot: irb140_rail\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}\n'
        "rail: {eax: a, stroke: [-0.2, 0.6]}\nlimits: {rail: {velocity: 1, acceleration: 3, source: a}}\n"
    )
    job = read_job(tmp_path / "m.mod")
    changes = changes_of(job, Target.RAPID)
    memory, checked, check = PlanCache(), list[Problem](), initial_plan.check_reach

    def counted(axes: Axes, problem: Problem) -> Infeasible | None:
        checked.append(problem)
        return check(axes, problem)

    monkeypatch.setattr(initial_plan, "check_reach", counted)
    optimize(job.program, job.plant, Target.RAPID, bounded=False, changes=changes, memory=memory)
    assert (Target.RAPID, AS_WRITTEN) in memory.answers
    first, second = [
        optimize(job.program, job.plant, Target.RAPID, AS_WRITTEN, bounded=False, changes=changes, memory=known)
        for known in (None, memory)
    ]
    assert len(checked) == 2  # what the first question may change, and the one that knows nothing of it
    estimate = search_estimate(job.program, job.plant, Target.RAPID, changes)
    assert memory.estimates[Target.RAPID, EVERYTHING] == estimate
    assert isinstance(first, Plan)
    assert isinstance(second, Plan)
    np.testing.assert_allclose(first.trajectory.q, second.trajectory.q, rtol=0, atol=1e-12)  # others are driven with it
    assert first.duration == pytest.approx(second.duration, rel=1e-12)
