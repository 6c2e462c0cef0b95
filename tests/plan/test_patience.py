"""A search that is cut short leaves the best motion so far, and says so."""

from __future__ import annotations

import json
import multiprocessing
import os
import signal
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import casadi as ca
import pytest
from small_cells import plant_with_rail, problem_of, rapid
from unrefined import coarse_search, set_defaults

from trajopt_cli.cli import run
from trajopt_cli.nlp.block import express
from trajopt_cli.nlp.mesh_refinement import MeshRefinement, Stage
from trajopt_cli.nlp.nlp_assembly import BlockNlp
from trajopt_cli.path_timing.path_parameterized_plan import duration
from trajopt_cli.plan.initial_plan import InitialPlan, initial_plan_of
from trajopt_cli.plan.local_refinement import refine
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate

BODY = """MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v500, fine, tool0;
WaitTime 0.3;
MoveL p_in, v500, fine, tool0;
MoveJ Offs(p_in,0,150,0), v2500, fine, tool0;
MoveL Offs(p_low,0,150,0), v500, fine, tool0;
MoveL Offs(p_in,0,150,0), v500, fine, tool0;
MoveAbsJ j_home, v2500, fine, tool0;"""
DATA = """CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_in:=[[500,600,450],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_low:=[[500,600,390],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];"""
CELL = """robot: irb140_rail
rail: {eax: a, stroke: [-0.16, 0.8]}
limits:
  rail: {velocity: 1.0, acceleration: 3.0, source: test}
tcp: {speed: 2.5, acceleration: 20, source: test}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


@pytest.fixture(autouse=True)
def _coarse_search(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)


STATION = "\n".join([*BODY.split("\n")[:4], "MoveAbsJ j_home, v2500, fine, tool0;"])


@pytest.fixture
def cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """One station, whose bound is not asked for."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("trajopt_cli.plan.lower_bound_of", lambda *_, **__: 0.1)
    Path("t.mod").write_text(f"MODULE T\n{DATA}\nPROC main()\n{STATION}\nENDPROC\nENDMODULE\n")
    Path("t.yaml").write_text(CELL)
    return Path("t.mod")


def legal() -> InitialPlan:
    plant = plant_with_rail((-0.16, 0.8))
    found = initial_plan_of(Axes.of(plant), [problem_of(rapid(BODY), plant)], Patience(), lambda _: None, {})
    assert isinstance(found, InitialPlan)
    return found


@pytest.mark.parametrize(("stopped", "motions"), [(False, 2), (True, 1)])
def test_the_first_legal_motion_is_an_answer_that_an_end_leaves(stopped: bool, motions: int) -> None:
    """A stream has two routes to time: of one progress for all axes, and of free ones."""
    patience, told = Patience(), list[float | None]()

    def tell(progress: Progress) -> None:
        assert patience.answered
        told.append(progress.incumbent)
        if stopped:
            patience.interrupt()

    plant = plant_with_rail((-0.16, 0.8))
    found = initial_plan_of(Axes.of(plant), [problem_of(rapid(BODY), plant)], patience, tell, {})
    assert isinstance(found, InitialPlan)
    assert len(told) == motions
    assert found.duration == min(time for time in told if time is not None)


def test_what_was_found_before_the_end_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    patience, first = Patience(), True

    def solve(self: MeshRefinement, stage: Stage) -> Iterate:
        nonlocal first
        iterate = stage.iterate
        if not first:
            patience.interrupt()
            raise Stopped
        first = False
        legs = [type(motion)(**{**vars(motion), "T": 0.9 * motion.T}) for motion in iterate.legs if motion is not None]
        return Iterate(iterate.q, iterate.qd, iterate.cfx, tuple(legs))

    set_defaults(monkeypatch, window_legs=4)
    monkeypatch.setattr(MeshRefinement, "begun", lambda _, iterate: Stage(iterate, [], []))
    monkeypatch.setattr(MeshRefinement, "rough", lambda _, stage: stage)
    monkeypatch.setattr(MeshRefinement, "finished", solve)
    monkeypatch.setattr("trajopt_cli.plan.local_refinement.search", lambda *_: None)
    base = legal()
    _, iterate, notes = refine(Axes.of(base.problem.plant), base, patience, lambda _: None, {})
    assert duration(iterate) < base.duration
    assert iterate.legs[-1] is base.iterate.legs[-1]
    assert notes == ("stopped by Ctrl-C: the best plan so far; the search for a faster one was not finished",)


def test_a_solver_ends_when_it_is_told_to() -> None:
    asked = 0

    def stop() -> bool:
        nonlocal asked
        asked += 1
        return asked == 4

    nlp = BlockNlp()
    x = nlp.variables([3.0, 1.0], -10.0, 10.0)
    nlp.minimise(int(x[0]))
    nlp.add(express(2, 0, lambda z, _: [(z[0] - ca.exp(z[1]) - z[1] ** 2, 0.0, ca.inf)]).block("bowl"), x)
    assert nlp.solve().iterations > 4
    result = nlp.solve(stop=stop)
    assert not result.converged
    assert (asked, result.iterations) == (4, 3)


def test_no_time_gives_the_first_legal_plan_and_says_so(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(cell), "--time-limit", "0"]) == 0
    note = "stream: the plan is the rapid plan: stopped by the time limit after 0 s"
    assert f"note: {note}" in capsys.readouterr().out.splitlines()
    summary = json.loads(Path("results/t/summary.json").read_text())
    assert note in summary["notes"]
    assert summary["plans"]["stream"]["cycle_time_s"] <= summary["plans"]["rapid"]["cycle_time_s"]


@pytest.mark.parametrize("limit", ["-1", "nan", "inf"])
def test_a_time_that_is_none_is_a_wrong_request(limit: str, cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(cell), "--time-limit", limit]) == 2
    assert capsys.readouterr().err == f"--time-limit: needs a time of 0 s or more, not {limit}\n"


def optimise_in_a_process_of_its_own(cell: Path, progress: int) -> None:
    """As from a terminal: a group of its own, which Ctrl-C is sent to. It tells all its progress to a pipe at once."""
    os.setsid()
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with (
        pytest.MonkeyPatch.context() as patch,
        open("out.txt", "w", encoding="utf-8") as out,
        open(progress, "w", encoding="utf-8", buffering=1) as err,
        redirect_stdout(out),
        redirect_stderr(err),
    ):
        patch.setattr("trajopt_cli.cli.progress.log_pause", lambda spent: 0.0)
        code = run(["optimize", str(cell)])
    sys.exit(code)


def test_ctrl_c_behind_the_first_legal_plan_writes_the_best_so_far(cell: Path) -> None:
    """Sent to the whole group, as a terminal does."""
    ours, theirs = os.pipe()
    process = multiprocessing.get_context("fork").Process(target=optimise_in_a_process_of_its_own, args=(cell, theirs))
    process.start()
    assert process.pid is not None
    os.close(theirs)
    with open(ours, encoding="utf-8") as progress:
        assert any("stream: " in line and "best" in line for line in progress)
        os.killpg(process.pid, signal.SIGINT)
        err = progress.read()
    process.join(timeout=120)
    assert process.exitcode == 0, err
    assert "stopping: the best plan so far is being completed (Ctrl-C again to give it up)" in err.splitlines()
    assert "note: stream: stopped by Ctrl-C: " in Path("out.txt").read_text(encoding="utf-8")
    assert "Traceback" not in err
    assert run(["verify", "results/t", "--quiet"]) == 0
