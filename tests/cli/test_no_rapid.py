"""A plan that the program's text cannot carry: nothing of it is lost."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from fake_planner import Planner

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError

REASON = "tiny.mod:6:9: cannot carry it"


@pytest.fixture
def refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise InputError("cannot carry it", file="tiny.mod", line=6, column=9)

    monkeypatch.setattr("trajopt_cli.exporters.rapid.export_rapid", refuse)


@pytest.mark.parametrize(("target", "code"), [("stream", 0), ("rapid", 1)])
def test_a_plan_without_rapid_text_is_kept(
    program: Path, planner: Planner, refused: None, target: str, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--target", target]) == code
    folder = Path("results/tiny")
    out, err = capsys.readouterr()
    assert f"warning: no RAPID text: {REASON}\n" in out
    assert "program.mod" not in out
    assert (f"no RAPID text: {REASON}\n" in err) == (target == "rapid")
    assert f"no RAPID text: {REASON}" in json.loads((folder / "summary.json").read_text())["warnings"]
    names = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    assert names == {
        "report.html", "trajectory.csv", "stream.csv", "rapid.csv", "summary.json", "run.json", "input/tiny.mod",
        "input/tiny.yaml",
    }  # fmt: skip

    assert run(["verify", str(folder)]) == 0
    assert run(["export", "joint", str(folder), "--output", "joints.csv"]) == 0
    capsys.readouterr()
    assert run(["export", "rapid", str(folder), "--diff"]) == 2
    assert capsys.readouterr() == ("", f"results/tiny: holds no RAPID text: {REASON}\n")
    assert run(["optimize", str(program), "--target", target]) == code  # such a folder may be replaced


def test_export_writes_nothing_then(program: Path, planner: Planner, refused: None) -> None:
    assert run(["optimize", str(program), "--export", "new.mod"]) == 1
    assert not Path("new.mod").exists()
    assert Path("results/tiny/summary.json").exists()


def test_export_in_one_step_is_what_export_rapid_writes(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--export", "new.mod", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["exported"] == ["new.mod"]
    assert run(["export", "rapid", "results/tiny", "--output", "same.mod"]) == 0
    assert Path("new.mod").read_bytes() == Path("same.mod").read_bytes()


def test_a_place_that_cannot_be_written_is_refused_before_the_work(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--export", "nowhere/new.mod"]) == 2
    assert capsys.readouterr().err.startswith("nowhere: is not a folder to write to; make it or correct --export")
    assert planner.asked == []
    assert not Path("results").exists()


def test_a_diff_without_changes_says_why(program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(program)]) == 0
    capsys.readouterr()
    assert run(["export", "rapid", "results/tiny", "--diff"]) == 0
    assert capsys.readouterr() == ("", "no change: the plan needs no change to the program\n")


def test_moves_kept_as_programmed_are_told_by_a_diff_without_changes(
    program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    kept = "any words: tiny.mod:6 (hangs on signal di1); a statement of its own would free it"
    monkeypatch.setattr("trajopt_cli.problem.editable_text.EditableText._kept", lambda *_: [kept])
    assert run(["optimize", str(program)]) == 0
    summary = json.loads(Path("results/tiny/summary.json").read_text())
    assert (summary["notes"][1:], summary["kept"]) == ([kept], [kept])
    capsys.readouterr()
    assert run(["export", "rapid", "results/tiny", "--diff"]) == 0
    assert capsys.readouterr() == ("", f"no change: {kept}\n")
