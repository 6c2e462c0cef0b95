"""A plan with additional points from the planner to its results folder, and read back from there."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from fake_planner import plan as parabolas

from trajopt_cli.cli import run
from trajopt_cli.job import read_results_job
from trajopt_cli.motion import Program
from trajopt_cli.pipeline.folder import plans_of_results, verify_results
from trajopt_cli.problem.detours import Detour, Via, folded, with_detours
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.results import read_results
from trajopt_cli.runs.summary import PlanSummary

SPEED = 0.8  # of the planner's parabolas, so that the longer ways keep v1000
BACK = np.deg2rad([-15.0, 0, 0, 0, 30, 0])  # on the other side of where j_side is


def detours(program: Program, target: Target) -> tuple[Detour, ...]:
    """Two before j_side, one before j_home, all stops; a plan as written has none."""
    between = Via(np.deg2rad([5.0, 0, 0, 0, 30, 0]))
    points = (Detour(0, (Via(BACK), between), ("column",)), Detour(2, (Via(BACK),), ("fence", "column")))
    return points[:1] if target is Target.STREAM else points


@pytest.fixture
def around(planner: object, monkeypatch: pytest.MonkeyPatch) -> None:
    """A planner that goes around; as written the program breaks limits."""

    def optimize(program: Program, plant: Plant, target: Target, freedom: object = None, **more: object) -> Plan:
        if not getattr(freedom, "configuration", True):
            return parabolas(program, plant, target, 2.0)
        ways = detours(program, target)
        return folded(parabolas(with_detours(program, plant, ways), plant, target, SPEED), program, ways)

    monkeypatch.setattr("trajopt_cli.plan.optimize", optimize)


@pytest.fixture
def results(program: Path, around: None) -> Path:
    assert run(["optimize", str(program), "--jobs", "1", "--quiet"]) == 0
    return Path("results/tiny")


def test_the_folder_has_the_points_and_gives_the_same_plan_back(results: Path) -> None:
    plans = json.loads((results / "summary.json").read_text())["plans"]
    rapid = plans["rapid"]["detours"]
    assert [(one["motion"], one["around"]) for one in rapid] == [(0, ["column"]), (2, ["fence", "column"])]
    assert [[p["target"] for p in one["points"]] for one in rapid] == [["jVia_10", "jVia_20"], ["jVia_30"]]
    assert [one["motion"] for one in plans["stream"]["detours"]] == [0]
    assert len(plans["rapid"]["motions"]) == 3  # the program's own
    job = read_results_job(results)
    read = plans_of_results(results, job)[Target.RAPID]
    there = with_detours(job.program, job.plant, detours(job.program, Target.RAPID))
    planned = folded(parabolas(there, job.plant, Target.RAPID, SPEED), job.program, read.detours)
    assert [len(one.via) for one in read.motions] == [2, 0, 1]
    for one, wanted in zip(read.motions, planned.motions, strict=True):
        assert (one.t_0, one.t_1) == pytest.approx((wanted.t_0, wanted.t_1), abs=1e-9)
        for point, other in zip(one.via, wanted.via, strict=True):
            assert point.t == pytest.approx(other.t, abs=1e-9)
            assert point.binding == other.binding
            np.testing.assert_array_equal(point.q, other.q)
    for way, other in zip(read.detours, planned.detours, strict=True):
        assert [via.radius for via in way.points] == [via.radius for via in other.points]
    assert with_detours(job.program, job.plant, read.detours).motions[1].target == "jVia_20"  # type: ignore[union-attr]


def test_verify_holds_the_rapid_rows_against_the_points(results: Path) -> None:
    _, reports = verify_results(results)
    assert all(report.legal for report in reports.values())
    # the stream's rows go by -15 and 5 deg at first and not by -15 deg on the way home
    text = (results / "rapid.csv").read_text()
    (results / "rapid.csv").write_text((results / "stream.csv").read_text())
    _, reports = verify_results(results)
    wrong = [one for one in reports["rapid.csv"].findings if not one.passed]
    assert any("jVia_30" in one.message for one in wrong)
    (results / "rapid.csv").write_text(text)
    (results / "stream.csv").write_text(text)
    _, reports = verify_results(results)
    assert reports["stream.csv"].legal  # a stream may go any way between the program's own points


def test_a_folder_without_the_key_reads_as_before() -> None:
    assert (
        PlanSummary.model_validate({"cycle_time_s": 1, "motions": [], "judge": {"legal": True, "findings": []}}).detours
        == []
    )


def test_a_plan_without_points_writes_none(program: Path, planner: object) -> None:
    assert run(["optimize", str(program), "--jobs", "1", "--quiet"]) == 0
    found = read_results(Path("results/tiny"))
    assert found.detours(Target.RAPID) == ()
    assert found.passings(Target.RAPID, 0) == ()


def test_a_line_tells_each_way_around(program: Path, around: None, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(program), "--jobs", "1", "--target", "rapid"]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "j_side (by 2 points around 'column')" in out
    assert "j_home (rapid by 1 point around 'fence', 'column')" in out
    assert "tiny.mod:6:9: jVia_10, jVia_20 are added before j_side, around 'column'" in out
    assert "tiny.mod:8:9: jVia_30 is added before j_home, around 'fence', 'column'" in out


def test_export_rapid_lists_the_ways_and_writes_them(results: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert run(["export", "rapid", str(results), "--output", "new.mod"]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        "tiny.mod:6:9: MoveAbsJ j_side goes around 'column' by jVia_10, jVia_20",
        "tiny.mod:8:9: MoveAbsJ j_home goes around 'fence', 'column' by jVia_30",
    ]
    text = Path("new.mod").read_text()
    assert "        MoveAbsJ jVia_10, v1000, fine, tool0; ! trajopt: way around 'column'\n" in text
    assert run(["export", "rapid", str(results), "--diff"]) == 0
    shown = capsys.readouterr()
    assert "+        MoveAbsJ jVia_30, v1000, fine, tool0; ! trajopt: way around 'fence', 'column'" in shown.out
    assert "goes around 'column' by jVia_10, jVia_20" in shown.err
    assert run(["export", "rapid", str(results), "--in-place", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["ways_around"][1] == "tiny.mod:8:9: MoveAbsJ j_home goes around 'fence', 'column' by jVia_30"
    assert Path("tiny.mod").read_text() == text
    assert run(["parse", "tiny.mod", "--json"]) == 0
    motions = json.loads(capsys.readouterr().out)["motions"]
    assert [one["detour"] for one in motions] == [["column"], ["column"], [], [], ["fence", "column"], []]


def test_what_was_exported_is_judged_by_the_rows_of_the_plan(results: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The new program is one like any other: its points are its own, and rapid.csv drives to each of them."""
    assert run(["export", "rapid", str(results), "--output", "new.mod"]) == 0
    rows = ["verify", str(results / "rapid.csv"), "--program", "new.mod", "--cell", "tiny.yaml"]
    assert run(rows) == 0
    assert run(["verify", str(results / "stream.csv"), *rows[2:]]) == 1
    assert "jVia_30" in capsys.readouterr().out
