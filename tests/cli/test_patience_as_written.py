"""The program as written is timed while the user still waits: Ctrl-C ends that, a time limit what is optional in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from trajopt_cli.cli.tables import saving_line
from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
from trajopt_cli.pipeline.planning import Clock, as_written, changes_of
from trajopt_cli.plan import PlanCache
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.summary import NOT_TIMED

PROGRAM = """MODULE t
CONST robtarget p:=[[450,0,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
PROC main()
MoveJ p,v500,fine,tool0;
MoveL Offs(p,0,0,-60),v200,fine,tool0;
ENDPROC
ENDMODULE
"""
CELL = """robot: irb140
start: {joints: "[0, 0, 0, 0, 30, 0] deg"}
obstacles: {far: {box: {size: [0.1, 0.1, 0.1], position: [-0.6, 0, 1.5]}}}
"""


@pytest.fixture
def job(tmp_path: Path, request: pytest.FixtureRequest) -> Job:
    (tmp_path / "t.mod").write_text(PROGRAM)
    (tmp_path / "t.yaml").write_text(CELL + getattr(request, "param", ""))
    return read_job([tmp_path / "t.mod"])


def timed(job: Job, patience: Patience) -> Plan | str:
    return as_written(job, changes_of(job, Target.RAPID), Clock(), PlanCache(), patience=patience)


def test_ctrl_c_ends_the_timing_of_the_program_as_written(job: Job) -> None:
    patience = Patience()
    patience.interrupt()
    assert timed(job, patience) == NOT_TIMED
    assert isinstance(timed(job, Patience(0.0)), Plan)  # the time limit does not take it away


@pytest.mark.parametrize("job", ["jerk_limits: true\n"], indirect=True)
def test_a_time_limit_ends_what_makes_the_program_as_written_faster(job: Job) -> None:
    """With jerk limits the laws on lines are sharpened."""
    whole, cut = timed(job, Patience()), timed(job, Patience(0.0))
    assert isinstance(whole, Plan)
    assert isinstance(cut, Plan)
    assert whole.seconds.get("solve", 0.0) > 0.0
    assert cut.seconds.get("solve", 0.0) == 0.0
    assert cut.duration >= whole.duration * (1 - 1e-9)


def test_the_answer_says_that_it_was_not_timed(tmp_path: Path) -> None:
    """Where joints leave nothing to choose, no lesser freedom has given the time already."""
    joints = "MoveAbsJ [[20,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tool0;"
    (tmp_path / "t.mod").write_text(f"MODULE t\nPROC main()\n{joints}\nENDPROC\nENDMODULE\n")
    (tmp_path / "t.yaml").write_text(CELL)
    job, patience = read_job([tmp_path / "t.mod"]), Patience()

    def listen(label: str, progress: Progress) -> None:
        if (label, progress.phase) == ("rapid", "as written"):
            patience.interrupt()

    answer = optimize_job(job, Target.STREAM, tmp_path / "out", listen, patience=patience, jobs=1)
    assert isinstance(answer, OptimizedJob)
    assert saving_line(answer).startswith("as written it was not timed: stopped by Ctrl-C → ")
    assert "not timed: stopped by Ctrl-C" in (tmp_path / "out/report.html").read_text()
    assert "cannot be driven" not in (tmp_path / "out/report.html").read_text()
