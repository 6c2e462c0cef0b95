"""The saving by cause of a program with corners: from stops to its zones first, and all causes add up."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from trajopt_cli.findings import Report
from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import Move
from trajopt_cli.problem.corners import corners_of, with_stops
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.study import comparison
from trajopt_cli.study.case import Attempt
from trajopt_cli.study.causes import causes
from trajopt_cli.study.comparison import Comparison, Tried, _after, compare
from trajopt_cli.study.comparison_record import comparison_record

TEXT = """MODULE made
    CONST robtarget p1:=[[450,50,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveJ p1, v1000, fine, tool0;
        MoveL Offs(p1,0,200,0), v500, ZONE, tool0;
        MoveL Offs(p1,0,200,-100), v500, ZONE, tool0;
        MoveL Offs(p1,0,0,-100), v500, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"


def job_of(zone: str, folder: Path) -> Job:
    path = folder / "made.mod"
    path.write_text(TEXT.replace("ZONE", zone), encoding="utf-8")
    path.with_suffix(".yaml").write_text(CELL, encoding="utf-8")
    return read_job(path)


@pytest.fixture(scope="module")
def compared(tmp_path_factory: pytest.TempPathFactory, coarse: None) -> Iterator[Comparison]:
    """All rows of the program with z20, taken as legal whatever the judge says."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("trajopt_cli.workers.cores", lambda: 1)
        patch.setattr(comparison, "judge", lambda *_, **__: Report(()))
        yield compare(job_of("z20", tmp_path_factory.mktemp("made")), lambda *_: None)


def test_corners_come_first_and_all_causes_add_up(compared: Comparison) -> None:
    steps = compared.steps
    assert not isinstance(steps, str)
    assert [step.name for step in steps[:3]] == ["as written, fly-bys as stops", "corners", "retimed: joint moves bend"]
    rows = {row.name: row.result for row in compared.rows}
    written, best = rows["as-written"], rows["optimum stream"]
    assert isinstance(written, Tried)
    assert isinstance(best, Tried)
    assert steps[1].plan is written.attempt.plan
    assert steps[-1].plan.duration == pytest.approx(best.attempt.trajectory.duration, abs=1e-6)
    whole = steps[0].plan.duration - steps[-1].plan.duration
    assert sum(step.saved for step in steps) == pytest.approx(whole, abs=1e-12)
    # two stops less at 0.5 m/s and at most 20 m/s2: at least v / a each, less what zones of 20 mm cut off or add
    assert 0.04 < steps[1].saved < 0.5
    record = {row["name"]: row for row in comparison_record(compared)["rows"]}
    for row in (record["as-written"], record["optimum stream"]):
        low, high = row["cycle_time_range_s"]
        assert low < row["cycle_time_s"] < high
    assert record["as-written"]["saving_range"] is None
    least, most = record["optimum stream"]["saving_range"]
    assert least < record["optimum stream"]["saving"] <= most
    names = [step["name"] for step in comparison_record(compared)["saving_by_cause"]["steps"]]
    assert names == [step.name for step in steps]


def test_every_row_with_a_motion_has_no_more_stops_than_the_program(compared: Comparison) -> None:
    """Ruckig and TOPP-RA say what they do; none of them is as slow as the program with stops timed by Ruckig."""
    rows = {row.name: row.result for row in compared.rows}
    for name in ("ruckig", "ruckig jerk"):
        result = rows[name]
        assert isinstance(result, Tried)
        assert any("corners and arcs: one profile along the path" in note for note in result.attempt.notes)
    steps = compared.steps
    assert not isinstance(steps, str)
    ruckig = rows["ruckig"]
    assert isinstance(ruckig, Tried)
    assert ruckig.attempt.trajectory.duration < steps[0].plan.duration


def test_a_program_without_corners_has_no_such_cause(tmp_path: Path) -> None:
    job = job_of("fine", tmp_path)
    assert not corners_of(job.program, job.plant).passed
    assert causes(job.plant, optional=False)[0].name == "as written"
    assert not any(cause.stops for cause in causes(job.plant, optional=False))


def test_with_stops_nothing_but_the_zones_is_another(tmp_path: Path) -> None:
    program = job_of("z20", tmp_path).program
    stopping = with_stops(program)
    for before, after in zip(program.motions, stopping.motions, strict=True):
        assert isinstance(before, Move)
        assert isinstance(after, Move)
        assert after.zone.stop
        assert (after.source, after.target, after.speed) == (before.source, before.target, before.speed)
    assert corners_of(stopping, job_of("z20", tmp_path).plant).passed == {}


def test_corners_that_cost_time_and_stops_that_cannot_be_driven_are_told(compared: Comparison) -> None:
    """The plan with stops made the faster one; then none at all."""
    assert not isinstance(compared.steps, str)
    stops, written = (step.plan for step in compared.steps[:2])
    program = compared.job.program

    def tried(plan):  # type: ignore[no-untyped-def]
        return Tried(Attempt(program, plan.trajectory, plan), Report(()))

    steps = _after([("stops", tried(written)), ("corners", tried(stops))])
    assert not isinstance(steps, str)
    assert [(step.name, step.plan) for step in steps] == [("stops", written), ("corners", stops)]
    assert steps[1].saved == pytest.approx(written.duration - stops.duration)
    assert steps[1].saved < 0
    no = Infeasible(0, program.motions[0].source, "no")
    steps = _after([("stops", no), ("corners", tried(written))])
    assert not isinstance(steps, str)
    assert [(step.name, step.saved) for step in steps] == [("as written", 0.0)]
    assert steps[0].why_not == f"stops: {no}"
