"""report.html as people get it: in the folders of optimize and of compare baseline."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from fake_planner import Planner

from trajopt_cli.cli import run
from trajopt_cli.runs.folder import read_run
from trajopt_cli.study.comparison_record import ComparisonRecord


def test_the_page_of_a_run_has_the_numbers_of_its_summary(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program)]) == 0
    told = capsys.readouterr().out
    assert (
        "written to results/tiny: program.mod (the rapid plan), report.html (open it in a browser), rapid.csv" in told
    )
    page = Path("results/tiny/report.html").read_text(encoding="utf-8")
    summary = json.loads(Path("results/tiny/summary.json").read_text())
    record = json.loads(Path("results/tiny/run.json").read_text())
    data = json.loads(re.findall(r'id="data">(.*?)</script>', page, re.DOTALL)[0])
    plans, written = summary["plans"], summary["as_written"]
    for cycle, numbers in zip(data["cycles"], (written, plans["rapid"], plans["stream"]), strict=True):
        assert cycle["duration"] == numbers["cycle_time_s"]
        times = [b - a for a, b in zip(cycle["legs"]["from"], cycle["legs"]["to"], strict=True)]
        assert times == pytest.approx(numbers.get("motion_times_s") or [one["time_s"] for one in numbers["motions"]])
    for plan in plans.values():
        assert f"gap {100 * plan['gap']:.1f} %" in page
        assert plan["grid"] in page
    for one in record["inputs"]["files"]:
        assert one["sha256"] in page
    assert record["started"][:16] not in page
    with Path("results/tiny/report.html").open("a") as file:
        file.write(" ")
    assert run(["verify", "results/tiny"]) == 2
    assert "results/tiny/report.html: was changed since the run" in capsys.readouterr().err


@pytest.mark.usefixtures("compared_once")
def test_a_comparison_is_a_folder_of_its_own(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["compare", "baseline", str(program), "--json"]) == 0
    said = capsys.readouterr()
    folder = Path("results/tiny_comparison")
    assert said.err.splitlines()[-1] == f"written to {folder}: report.html (open it in a browser) and 4 files more"
    kept = read_run(folder, ComparisonRecord)
    assert set(kept.contents) == {
        "comparison.json", "comparison.csv", "report.html", "input/tiny.mod", "input/tiny.yaml",
    }  # fmt: skip
    assert json.loads(kept.contents["comparison.json"]) == json.loads(said.out)
    assert kept.record.options.program == ["tiny.mod"]
    data = json.loads(re.findall(r'id="data">(.*?)</script>', kept.contents["report.html"].decode(), re.DOTALL)[0])
    driven = [row for row in json.loads(said.out)["rows"] if row.get("cycle_time_s")]
    assert [(one["name"], one["duration"]) for one in data["cycles"]] == [
        (row["name"], row["cycle_time_s"]) for row in driven
    ]
    assert len(driven) > 3
    assert run(["compare", "baseline", str(program), "--output", "again"]) == 0
    assert capsys.readouterr().out.endswith("written to again: report.html (open it in a browser) and 4 files more\n")
    assert run(["verify", "again"]) == 2
    assert "again: was made by trajopt compare baseline" in capsys.readouterr().err


def test_a_place_that_may_not_be_replaced_is_told_before_the_work(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("mine").mkdir()
    Path("mine/notes.txt").write_text("mine")
    assert run(["compare", "baseline", str(program), "--output", "mine"]) == 2
    assert "mine: is not a results folder of trajopt (no run.json) and is not replaced" in capsys.readouterr().err
    assert not planner.asked
