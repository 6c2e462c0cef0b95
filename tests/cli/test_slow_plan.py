"""Whatever fails inside, a program that can be done has a plan: the slow one, told as such and judged by verify."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from fake_planner import Planner
from unrefined import coarse_search

from trajopt_cli.cli import run
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven
from trajopt_cli.plan import NoCleanPlan, fallback_plan, solve
from trajopt_cli.problem.plan import MOST_GAP, MOST_TIMES, Infeasible, Plan, Target
from trajopt_cli.trajectory import Trajectory

TEXT = """MODULE Small
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_in:=[[500,100,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_at:=[[500,100,380],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_in, v1000, z10, tool0;
        MoveL p_at, v500, fine, tool0;
        WaitTime 0.3;
        MoveL p_in, v500, fine, tool0;
        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""
RAILED = """robot: irb140_rail
rail: {eax: a, stroke: [-0.2, 0.6]}
limits: {rail: {velocity: 1, acceleration: 3, source: a}}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
CELL = 'robot: irb140\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'


def _none(*_: object, **__: object) -> None:
    return None


def _not_driven(*_: object, **__: object) -> None:
    raise NotDriven((0, 1))


def _no_clean_plan(*_: object, **__: object) -> None:
    raise NoCleanPlan("the solver failed from every start")


def _disconnected(program: object, *_: object, **__: object) -> Infeasible:
    motion = program.motions[0]  # type: ignore[attr-defined]
    return Infeasible(0, motion.source, "no route of configurations connects the start with the program's end")


FAILURES: dict[str, tuple[str, Callable[..., object]]] = {
    "the search finds no route": ("trajopt_cli.plan.initial_plan.search", _none),
    "no law drives a run": ("trajopt_cli.plan.detour_planner.timed", _not_driven),
    "windows fail": ("trajopt_cli.plan.solve.refine", _no_clean_plan),
    "rows are not legal": ("trajopt_cli.plan.solve.with_legal_rows", None),  # but those of the slow plan
    "the whole optimiser says that there is no way": ("trajopt_cli.plan.optimize", _disconnected),
    "the whole optimiser fails": ("trajopt_cli.plan.optimize", _no_clean_plan),
}  # type: ignore[dict-item]


@pytest.fixture
def small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    coarse_search(monkeypatch)
    Path("small.mod").write_text(TEXT)
    Path("small.yaml").write_text(CELL)
    return Path("small.mod")


@pytest.mark.parametrize("name", FAILURES)
def test_a_program_that_can_be_done_has_a_plan_whatever_fails(
    name: str, small: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    if name not in ("no law drives a run", "rows are not legal"):  # from every rail position they would be tried
        Path("small.yaml").write_text(RAILED)
    place, failing = FAILURES[name]
    if name == "rows are not legal":
        right, plainly = solve.with_legal_rows, []

        def failing(*arguments):  # type: ignore[no-untyped-def]
            return right(*arguments) if plainly else None

        motion = fallback_plan.fallback_motion

        def then(*arguments):  # type: ignore[no-untyped-def]
            plainly.append(True)
            return motion(*arguments)

        monkeypatch.setattr("trajopt_cli.plan.solve.fallback_motion", then)
    monkeypatch.setattr(place, failing)
    assert run(["optimize", str(small), "--jobs", "1"]) == 0
    told = capsys.readouterr()
    slow = "no fast plan was found"
    wanted = "the plan is the rapid plan: no other one was found" if name == "windows fail" else slow
    assert wanted in told.out, told
    record = json.loads(Path("results/small/summary.json").read_text())
    for one in record["plans"].values():
        assert one["judge"]["legal"]
    assert run(["verify", "results/small", "--quiet"]) == 0


def test_the_plain_motion_is_told_only_where_nothing_else_was_found(
    small: Path, unrefined: None, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(small), "--jobs", "1"]) == 0
    assert "slow plan" not in capsys.readouterr().out


def test_a_program_that_cannot_be_done_stays_so(small: Path, capsys: pytest.CaptureFixture[str]) -> None:
    small.write_text(TEXT.replace("500,100,380", "5000,100,380"))
    assert run(["optimize", str(small), "--jobs", "1"]) == 1
    assert "p_at" in capsys.readouterr().err
    assert not Path("results").exists()


def test_a_bound_that_a_plan_refutes_takes_no_plan_away(
    planner: Planner, program: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        "trajopt_cli.plan.lower_bound_of", lambda program, plant, plan, **more: 2 * plan.duration
    )  # fmt: skip
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    assert "no lower bound is told" in capsys.readouterr().out
    assert np.isfinite(json.loads(Path("results/tiny/summary.json").read_text())["plans"]["rapid"]["cycle_time_s"])


def test_a_plan_far_from_its_bound_is_told_as_suspicious(
    planner: Planner, program: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        "trajopt_cli.plan.lower_bound_of", lambda program, plant, plan, **more: plan.duration / 151
    )  # fmt: skip
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    out = capsys.readouterr().out
    assert ", SUSPICIOUS: see the warning" in out
    assert "15000" not in out  # such a gap is no percentage
    assert "warning: the rapid plan is suspicious: it takes 151 times its lower bound" in out
    assert "suspicious: it takes 151 times its lower bound" in Path("results/tiny/report.html").read_text()
    assert run(["optimize", str(program), "--jobs", "1", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["plans"]["stream"]["suspicious"] == "it takes 151 times its lower bound"
    assert any("the stream plan is suspicious" in one for one in told["warnings"])


def test_what_is_suspicious() -> None:
    rows = Trajectory(("joint_1",), np.array([0.0, 2.0]), np.zeros((2, 1)))
    plan = Plan(Target.STREAM, rows, (), 2.0 / (1 + MOST_GAP) * 1.001, "", estimate=2.0 / MOST_TIMES * 1.001)
    assert plan.suspicion is None
    assert replace(plan, lower_bound=2.0 / (1 + MOST_GAP) * 0.999).suspicion == "it takes 2 times its lower bound"
    slow = replace(plan, estimate=2.0 / MOST_TIMES * 0.999)
    assert slow.suspicion == "it takes 2 times what the search estimated"
    assert replace(plan, lower_bound=None, estimate=None).suspicion is None
