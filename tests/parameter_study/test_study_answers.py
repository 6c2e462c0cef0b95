"""`trajopt study show` and `study optimize` as people type them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from distributed import Client
from tiny import CELL, MODULE, written

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.cli import run
from trajopt_cli.parameter_study.point import Row, blank
from trajopt_cli.parameter_study.results import new_or_same
from trajopt_cli.parameter_study.study_file import read_study

STUDY = """programs: [tiny.mod]
vary:
  limits.joint_1.velocity: [0.5, 1.0, 1.5, 2.0]
  tcp.speed: [1.0, 2.0, 3.0]
answers: [as_written, rapid]
price: 100 * limits.joint_1.velocity
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A study of twelve points of which ten are done; slow joints take long, one point cannot be done."""
    monkeypatch.chdir(tmp_path)
    study = read_study(written(tmp_path, STUDY))
    rows: list[Row] = []
    for i in range(10):
        point = study.design.point(i)
        v, speed = point.values
        times: dict[str, Any] = {"as_written_s": 9.0, "rapid_s": 4 + 2 / v + 0.1 / speed, "price": 100 * v}
        times["saved_s"] = times["as_written_s"] - times["rapid_s"]
        bad = blank(study.inputs, point, "infeasible", "tiny.mod:7: out of reach")
        rows.append(bad if i == 0 else {**blank(study.inputs, point, "ok", ""), **times})
    results = new_or_same(Path("out"), study)
    results.write_part(rows, [])
    return Path("out")


def test_a_study_that_is_not_done_is_shown_as_far_as_it_is(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["study", "show", str(folder)]) == 0
    said = capsys.readouterr().out
    assert "10 of 12 points done, 9 with an answer" in said
    assert "1 × infeasible: tiny.mod:7: out of reach" in said
    rows = [line.split() for line in said.split("best points by rapid_s")[1].splitlines()[4:13]]
    assert [row[0] for row in rows] == ["9", "8", "7", "6", "5", "4", "3", "2", "1"]
    assert rows[0][1] == f"{4 + 2 / 2.0 + 0.1 / 1.0:.3f}"
    page = (folder / "report.html").read_text()
    assert 'data-point="9"' in page


def test_the_same_as_json_by_another_answer(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["study", "show", str(folder), "--by", "saved_s", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["by"], told["against"], told["points"]) == ("saved_s", "price", 12)
    assert told["best"][0]["point"] == 9
    # of each price the fastest: the tool's greatest speed that was done
    assert [(row["price"], row["tcp.speed_m_per_s"]) for row in told["front"]] == [
        (200, 1),
        (150, 3),
        (100, 3),
        (50, 3),
    ]
    assert told["shares"]["shares"][0]["columns"] == ["limits.joint_1.velocity_rad_per_s"]


def test_a_study_without_an_answer_says_why(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also where the program as written can be done, and its plan cannot."""
    monkeypatch.chdir(tmp_path)
    study = read_study(written(tmp_path, STUDY))
    row = blank(study.inputs, study.design.point(0), "infeasible", "tiny.mod:7: out of reach")
    new_or_same(Path("out"), study).write_part([{**row, "as_written_s": 9.0}], [])
    assert run(["study", "show", "out"]) == 1
    assert "1 × infeasible: tiny.mod:7: out of reach" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["--by", "stream_s"], ["--against", "colour"]])
def test_answers_that_are_not_there_are_refused(words: list[str], folder: Path) -> None:
    assert run(["study", "show", str(folder), *words]) == 2


def test_what_is_no_study_is_refused(tmp_path: Path) -> None:
    assert run(["study", "show", str(tmp_path)]) == 2


def test_a_search_from_the_command_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], client: Client
) -> None:
    """The constraint keeps the joint slow, so the fastest of what is left is known."""
    monkeypatch.chdir(tmp_path)
    written(tmp_path, STUDY)
    asked = ["study", "optimize", "study.yaml", "--points", "6", "--quiet"]
    asked += ["--scheduler", client.scheduler.address]
    assert run([*asked, "--constraint", "limits.joint_1.velocity <= 1.2", "--seed", "1"]) == 0
    assert "limits.joint_1.velocity_rad_per_s 1," in capsys.readouterr().out
    assert run([*asked, "--by", "stream_s"]) == 2
    assert run([*asked, "--constraint", "cheap"]) == 2


@pytest.mark.long
def test_a_points_plan_is_that_of_its_cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Offsets and keys of a point, held against files written by hand."""
    monkeypatch.chdir(tmp_path)
    vary = "limits.joint_1.velocity: [1, 2], place.base.x: [0, 20 mm], target.p_in.z: [0, 30 mm]"
    vary = f"{{{vary}, place.table.y: [0, 10 mm]}}"
    study = written(tmp_path, f"programs: [tiny.mod]\nvary: {vary}\n")
    assert run(["study", "plan", "study.yaml", "15", "--time-limit", "0", "--quiet"]) == 0
    folder = Path("results/study/plans/15")
    cell = load_cell(folder / "input/tiny.yaml")
    assert cell.X_WB[:3, 3].tolist() == [0.02, 0, 0]
    assert "p_in:=[[500,0,630]" in (folder / "input/tiny.mod").read_text()
    hand = MODULE.replace("[500,0,600]", "[500,0,630]").replace('"",[[0,0,0]', '"",[[0,10,0]')
    study.with_name("hand.mod").write_text(hand)
    limit = "limits: {joint_1: {velocity: 2, source: x}}\nbase: {position: [0.02, 0, 0]}\n"
    study.with_name("hand.yaml").write_text(CELL + limit)
    assert run(["optimize", "hand.mod", "--time-limit", "0", "--quiet"]) == 0
    there, here = (json.loads((one / "summary.json").read_text())["plans"] for one in (folder, Path("results/hand")))
    assert [there[one]["cycle_time_s"] for one in there] == [here[one]["cycle_time_s"] for one in here]
    assert run(["study", "plan", "study.yaml", "16"]) == 2
