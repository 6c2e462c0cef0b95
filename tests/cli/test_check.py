"""`trajopt check`: one light, and the line that is worst."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from fake_planner import CELL, TEXT

from trajopt_cli.cli import run
from trajopt_cli.runs.uncertainty import between

WALL = "obstacles:\n  wall: {box: {size: [0.2, 0.1, 1.2], position: [0.5, 0.25, 0.6]}}\n"


def checked(capsys: pytest.CaptureFixture[str], code: int) -> dict[str, Any]:
    capsys.readouterr()
    assert run(["check", "tiny.mod", "--json"]) == code
    return json.loads(capsys.readouterr().out)


def states(told: dict[str, Any]) -> list[str]:
    return [one["state"] for one in told["checks"]]


def test_a_good_program_is_told_in_a_line(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told = checked(capsys, 0)
    assert told["ok"] is True
    assert states(told) == ["ok"] * 4
    assert run(["check", "tiny.mod", "--quiet"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    ends = told["uncertainty"]["cycle_time_range_s"]["as_written"]
    assert out.startswith(f"tiny.mod: OK, {told['cycle_time_s']:.3f} s, {between(ends)} with ")
    assert out.endswith("; obstacles not checked: the cell file gives none\n")
    assert out.count("\n") == 1
    assert not Path("results").exists()


def test_a_target_out_of_range_is_named_by_its_line(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program.write_text(TEXT.replace("[[20,", "[[200,"))
    told = checked(capsys, 1)
    assert states(told) == ["ok", "NO", "not checked", "not checked"]
    assert told["worst"].startswith("tiny.mod:6:9: MoveAbsJ j_side asks for joint_1 = 200 deg")
    assert told["cycle_time_s"] is None


def test_an_obstacle_in_the_way_is_named(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("tiny.yaml").write_text(CELL + WALL)
    told = checked(capsys, 1)
    assert states(told) == ["ok", "ok", "ok", "NO"]
    assert "'wall'" in told["worst"]
    assert told["worst"].startswith("tiny.mod:6:9: ")


def test_what_does_not_read_is_a_wrong_request(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program.write_text(TEXT.replace("MoveAbsJ", "MoveFoo", 1))
    assert run(["check", "tiny.mod"]) == 2
    assert capsys.readouterr().err.startswith("tiny.mod:6:9: ")
