"""A time limit holds in studies: what was not made or asked is said, what was found stands."""

from __future__ import annotations

from pathlib import Path

import pytest
from unrefined import coarse_search

from trajopt_cli.job import Job, read_job
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.study.comparison import Tried, compare
from trajopt_cli.study.sensitivity import Sensitivity, sensitivity

PROGRAM = """MODULE t
CONST robtarget p:=[[450,0,450],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
PROC main()
MoveJ p,v500,fine,tool0;
MoveL Offs(p,0,0,-60),v200,fine,tool0;
WaitTime 0.2;
ENDPROC
ENDMODULE
"""
CELL = """robot: irb140_rail
rail: {eax: a, stroke: [-0.1, 0.1]}
limits: {rail: {velocity: 1.0, acceleration: 3.0, source: test}}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


@pytest.fixture
def job(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Job:
    coarse_search(monkeypatch)
    monkeypatch.setattr(
        "trajopt_cli.study.comparison.shared_out", lambda tasks, hear: {n: t(hear) for n, t in tasks.items()}
    )
    (tmp_path / "t.mod").write_text(PROGRAM)
    (tmp_path / "t.yaml").write_text(CELL)
    return read_job([tmp_path / "t.mod"])


def ticking(limit: float) -> Patience:
    """Patience whose clock goes on by a second whenever it is looked at."""
    clock = iter(range(1 << 30))
    return Patience(limit, lambda: float(next(clock)))


def test_a_comparison_has_its_first_legal_row_and_says_which_others_were_not_made(job: Job) -> None:
    answer = compare(job, lambda *_: None, patience=ticking(0))
    rows = {row.name: row.result for row in answer.rows}
    assert isinstance(rows["as-written"], Tried)
    assert rows["as-written"].report.legal
    for name in ("optimum stream", "ruckig", "thesis"):
        assert rows[name] == "not made: stopped by the time limit after 0 s"
    assert not isinstance(answer.steps, str)
    assert {step.why_not for step in answer.steps[1:]} == {"not made: stopped by the time limit after 0 s"}


@pytest.mark.parametrize("limit", [0, 100])
def test_levers_that_no_time_is_left_for_are_told(job: Job, limit: float) -> None:
    answer = sensitivity(job, Loops.KEEP, None, (Target.RAPID,), lambda *_: None, 1, patience=ticking(limit))
    assert isinstance(answer, Sensitivity)
    rows = answer.rows[Target.RAPID]
    why = rows if isinstance(rows, str) else rows[-1].why
    assert f"stopped by the time limit after {limit} s" in why
