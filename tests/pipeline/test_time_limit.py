"""A time limit holds in every phase: what is under way is cut, what is left is legal, and what was not done is said."""

from __future__ import annotations

from pathlib import Path

import pytest
from small_cells import plant_with_rail, problem_of, rapid
from unrefined import coarse_search

from trajopt_cli.bound.lower_bound import lower_bound
from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped, checkpoint
from trajopt_cli.trajectories.axes import Axes

BODY = """MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v500, fine, tool0;
WaitTime 0.3;
MoveL p_in, v500, fine, tool0;
MoveAbsJ j_home, v2500, fine, tool0;"""
DATA = """CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_in:=[[500,600,450],[0,0,1,0],[0,0,CFG,0],[600,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_low:=[[500,600,390],[0,0,1,0],[0,0,CFG,0],[600,9E9,9E9,9E9,9E9,9E9]];"""
CELL = """robot: irb140_rail
rail: {eax: a, stroke: [-0.16, 0.8]}
limits:
  rail: {velocity: 1.0, acceleration: 3.0, source: test}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


class Ticks:
    """A clock that goes on by a second whenever it is looked at."""

    def __init__(self) -> None:
        self.t = 0.0

    def __call__(self) -> float:
        self.t += 1.0
        return self.t


@pytest.fixture(autouse=True)
def _coarse_search(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)


@pytest.fixture
def job(tmp_path: Path, request: pytest.FixtureRequest) -> Job:
    """One station; its programmed configuration cannot be had where the test asks for another one."""
    data = DATA.replace("CFG", str(getattr(request, "param", 0)))
    (tmp_path / "t.mod").write_text(f"MODULE t\n{data}\nPROC main()\n{BODY}\nENDPROC\nENDMODULE\n")
    (tmp_path / "t.yaml").write_text(CELL)
    return read_job([tmp_path / "t.mod"])


def test_a_checkpoint_ends_work_once_there_is_something_to_fall_back_on() -> None:
    now = [0.0]
    patience = Patience(3.0, lambda: now[0])
    with patience.cutting():
        now[0] = 4.0
        checkpoint()  # nothing is at hand yet
        patience.settle()
        with pytest.raises(Stopped):
            checkpoint()
        now[0] = 2.0
        checkpoint()
    now[0] = 4.0
    checkpoint()


def test_time_for_what_comes_behind_the_search_is_kept() -> None:
    now = [0.0]
    patience = Patience(10.0, lambda: now[0])
    patience.reserve(4.0)
    now[0] = 5.9
    assert not patience.over
    now[0] = 6.0
    assert patience.over
    assert patience.late is None
    now[0] = 12.0
    patience.settle()
    assert patience.late == 12.0


def test_a_bound_that_was_cut_holds() -> None:
    plant = plant_with_rail((-0.16, 0.8))
    problem, axes, cut = problem_of(rapid(BODY), plant), Axes.of(plant), list[int]()
    whole = lower_bound(axes, problem, 30.0, lambda: cut.append(-1))
    assert not cut
    found = []
    for ticks in (0, 4, 8, 16, 1 << 30):
        patience = Patience(ticks, Ticks())
        patience.settle()
        with patience.cutting():
            found.append(lower_bound(axes, problem, 30.0, lambda ticks=ticks: cut.append(ticks)))  # type: ignore[misc]
    assert cut[:2] == [0, 4]
    assert 1 << 30 not in cut
    assert 0.3 < found[0] < whole  # the programmed wait and the tool's ways at their speeds
    assert found == sorted(found)
    assert found[-1] == whole


@pytest.mark.long
@pytest.mark.parametrize("ticks", [0, 30, 120, 400])
def test_wherever_the_time_ends_both_plans_are_legal_and_in_order(job: Job, tmp_path: Path, ticks: int) -> None:
    patience = Patience(ticks, Ticks())
    answer = optimize_job(job, None, tmp_path / "out", lambda *_: None, patience=patience, jobs=1)
    assert isinstance(answer, OptimizedJob)
    assert isinstance(answer.written, Plan)
    plans = [answer.judged[one].plan for one in (Target.STREAM, Target.RAPID)]
    assert all(one.report.legal for one in answer.judged.values())
    times = [*(plan.duration for plan in plans), answer.written.duration]
    assert times == pytest.approx(sorted(times))
    assert all(plan.lower_bound is None or plan.lower_bound <= plan.duration for plan in plans)
    assert any("time limit" in note for note in plans[0].notes)
    assert not any("already the fastest" in note for plan in plans for note in plan.notes)


@pytest.mark.parametrize("job", [1], indirect=True)
def test_without_a_legal_program_the_first_legal_motion_is_looked_for_and_told(job: Job, tmp_path: Path) -> None:
    told = list[str]()

    def listen(label: str, progress: Progress) -> None:
        told.append(f"{label} {progress.phase}")

    patience = Patience(1.0, Ticks())
    answer = optimize_job(job, None, tmp_path / "out", listen, plots=True, patience=patience, jobs=1)
    assert isinstance(answer, OptimizedJob)
    assert isinstance(answer.written, str)
    assert all(one.report.legal for one in answer.judged.values())
    assert any("the first legal motion was there after" in line for line in answer.summary.warnings)
    assert any("no pictures" in line for line in answer.summary.warnings)
    assert not (tmp_path / "out/plots").exists()
    assert "stream stopped" in told
