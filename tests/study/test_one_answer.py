"""`optimize` and `compare` on the same programs: one answer to what may change, and to how fast it can be."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline import planning
from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
from trajopt_cli.plan import initial_plan
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.study import causes, comparison, table
from trajopt_cli.study.comparison import Tried, compare

CELL = (Path(__file__).parents[2] / "programs" / "hinge_cell.yaml").read_text(encoding="utf-8") + "signals: {di1: 1}\n"
HOME = "    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];"
SEEDS = range(8, 20)


def listing(seed: int) -> str:
    """Literal and computed targets, a loop that may ask an input, a routine without and one with a parameter."""
    rng = np.random.default_rng(seed)

    def target(k: int) -> str:
        y, z = rng.integers(200, 1800), rng.integers(380, 500)
        x, rail = rng.integers(420, 520), "9E9" if rng.random() < 0.2 else str(y + rng.integers(-60, 60))
        kind = rng.choice(["CONST", "PERS"])
        return f"    {kind} robtarget p{k}:=[[{x},{y},{z}],[0,0,1,0],[0,0,0,0],[{rail},9E9,9E9,9E9,9E9,9E9]];"

    def move(names: list[str], *more: str) -> str:
        name, instruction = rng.choice(names), rng.choice(["MoveJ", "MoveL"], p=[0.7, 0.3])
        shapes = [name, f"Offs({name},0,0,{rng.integers(1, 9)}0)", f"RelTool({name},0,0,-lift)", *more]
        marked = " ! trajopt: optional" if rng.random() < 0.1 else ""
        return f"        {instruction} {rng.choice(shapes).replace('NAME', name)}, v1000, fine, tool0;{marked}"

    plain = [f"p{k}" for k in range(4)]
    several = int(rng.integers(2, 4))
    loop = [move(plain, "Offs(NAME,0,0,20*i)") for _ in range(2)]
    body = [
        move(plain),
        f"        FOR i FROM 1 TO {several} DO",
        *(["        IF di1=1 THEN", loop[0], "        ENDIF"] if rng.random() < 0.4 else loop[:1]),
        loop[1],
        *(["        WaitTime 0.2;"] if rng.random() < 0.5 else []),
        "        ENDFOR",
        move(plain, "Offs(NAME,0,0,height)"),
        "        serve;",
        f"        go p{rng.integers(4)};",
        f"        go p{rng.integers(4)};",
        *(["        serve;"] if rng.random() < 0.5 else []),
        "        MoveAbsJ j_home, v1000, fine, tool0;",
    ]
    data = [HOME, *(target(k) for k in range(4)), "    CONST num lift:=40;", "    VAR num height:=30;"]
    serve = ["    PROC serve()", move(plain), move(plain), "    ENDPROC"]
    go = ["    PROC go(robtarget p)", move(["p"], "Offs(NAME,0,0,height)"), "    ENDPROC"]
    return "\n".join(["MODULE made", *data, "    PROC main()", *body, "    ENDPROC", *serve, *go, "ENDMODULE", ""])


def job_of(text: str, folder: Path) -> Job:
    path = folder / "made.mod"
    path.write_text(text, encoding="utf-8")
    path.with_suffix(".yaml").write_text(CELL, encoding="utf-8")
    return read_job(path)


@pytest.fixture(scope="module")
def jobs(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Job]:
    return {seed: job_of(listing(seed), tmp_path_factory.mktemp("made")) for seed in SEEDS}


changes_of = cache(planning.changes_of)  # whoever asks again


def said(problem: Problem) -> tuple[object, ...]:
    """What may change in a problem."""
    waypoints = tuple((one.motion, one.rail, one.conf, one.rest) for one in problem.waypoints)
    return waypoints, tuple(leg.rail_moves for leg in problem.legs), problem.dropped, problem.ties


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> dict[tuple[Target, bool], set[tuple[object, ...]]]:
    """The problems in which everything is free that get past reach, by target and whether motions are left out; none
    of them is solved."""
    found: dict[tuple[Target, bool], set[tuple[object, ...]]] = {}

    def check_reach(*given: object) -> None:
        (problem,) = (one for one in given if isinstance(one, Problem))
        if replace(problem.freedom, drop=True) == EVERYTHING:
            found.setdefault((problem.target, bool(problem.dropped)), set()).add(said(problem))

    monkeypatch.setattr(planning, "changes_of", changes_of)
    monkeypatch.setattr(initial_plan, "check_reach", check_reach)
    monkeypatch.setattr(initial_plan, "search", lambda *_: None)
    monkeypatch.setattr("trajopt_cli.plan.slow_plan", lambda *_: None)
    monkeypatch.delitem(table.BASELINES, "thesis")  # of a program with another rail
    monkeypatch.setattr("trajopt_cli.workers.cores", lambda: 1)
    monkeypatch.setattr("trajopt_cli.pipeline.optimize.cores", lambda: 1)
    return found


@pytest.mark.parametrize("loops", Loops)
@pytest.mark.parametrize("seed", SEEDS)
def test_both_commands_ask_for_the_same_problems(
    seed: int,
    loops: Loops,
    asked: dict[tuple[Target, bool], set[tuple[object, ...]]],
    jobs: dict[int, Job],
    tmp_path: Path,
) -> None:
    job = jobs[seed]
    answer = optimize_job(job, Target.STREAM, tmp_path / "results", lambda *_: None, loops=loops)
    assert isinstance(answer, Infeasible)
    optimised = dict(asked)
    asked.clear()
    compare(job, lambda *_: None, loops=loops)
    assert {Target.STREAM, Target.RAPID} == {target for target, _ in asked}
    assert asked == optimised
    assert all(len(problems) == 1 for problems in asked.values())


def test_the_programs_have_something_to_differ_in(jobs: dict[int, Job]) -> None:
    """Free, tied and kept targets, things to drop: else the test above would say nothing."""
    changes = [changes_of(job, Target.RAPID, Loops.KEEP) for job in jobs.values()]
    assert sum(bool(one.kept) for one in changes) >= 3
    assert sum(bool(one.ties) for one in changes) >= 5
    assert sum(bool(one.droppable) for one in changes) >= 3
    assert all(one.values for one in changes)


APPROACH = """MODULE made
{home}
    CONST robtarget p1:=[[500,300,380],[0,0,1,0],[0,0,0,0],[700,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        {body}
        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""


@pytest.mark.long
@pytest.mark.parametrize(
    "body",
    [
        "MoveJ Offs(p1,0,0,80), v1000, fine, tool0;\n        MoveL p1, v1000, fine, tool0;",
        "MoveJ RelTool(p1,0,0,-40), v1000, fine, tool0;",
    ],
)
@pytest.mark.usefixtures("alone", "unrefined")
def test_both_commands_find_the_same_time(body: str, tmp_path: Path) -> None:
    """Approach points that are computed: compare used to hold their rail where the program has it."""
    job = job_of(APPROACH.format(home=HOME, body=body), tmp_path)
    answer = optimize_job(job, Target.RAPID, tmp_path / "results", lambda *_: None)
    assert isinstance(answer, OptimizedJob)
    plan = answer.judged[Target.RAPID].plan
    (row,) = compare(job, lambda *_: None).rows
    assert isinstance(row.result, Tried)
    assert row.result.report.legal
    assert row.result.attempt.plan is not None
    assert row.result.attempt.plan.duration == plan.duration
    assert row.result.attempt.plan.lower_bound == plan.lower_bound
    assert abs(plan.motions[0].q_1[0] - 0.7) > 0.05  # the rail goes elsewhere than programmed


@pytest.fixture
def alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only the row of the RAPID optimum is made."""
    monkeypatch.setattr(comparison, "BASELINES", {"optimum rapid": table.BASELINES["optimum rapid"]})
    monkeypatch.setattr(
        causes, "CAUSES", (causes.Cause("optimum rapid", Target.RAPID, replace(EVERYTHING, drop=False)),)
    )
