"""What a reader needs beside the numbers: a hold that forbids, and a plan that takes no time."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from fake_planner import Planner
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.cli import run
from trajopt_cli.motion import Hold, Program
from trajopt_cli.plan import check_feasible
from trajopt_cli.problem.progress import Progress

FAR = "CONST robtarget p_far:=[[500,1900,450],[0,0,1,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];"


def held(program: Program, hold: Hold | None) -> Program:
    return replace(program, motions=tuple(replace(motion, hold=hold) for motion in program.motions))


@pytest.mark.parametrize("hold", [Hold.CELL, Hold.PROGRAM])
def test_a_hold_that_keeps_a_point_out_of_reach_is_named(hold: Hold) -> None:
    program = rapid("MoveJ p_far, v500, fine, tool0;", data=FAR)
    assert check_feasible(program, plant_with_rail()) is None
    no = check_feasible(held(program, hold), plant_with_rail())
    assert no is not None
    assert no.message.endswith(
        "the rail is held still there (hold_rail): begin the hold behind the approach, or let the rail move"
    )


def test_without_a_rail_no_hold_is_blamed() -> None:
    no = check_feasible(held(rapid("MoveJ p_far, v500, fine, tool0;", data=FAR), Hold.CELL), plant_without_rail())
    assert no is not None
    assert "hold" not in no.message


def test_a_plan_that_takes_no_time_has_no_gap() -> None:
    assert Progress("done", 0.0, 0.0).gap == 0.0
    assert Progress("done", 1.1, 1.0).gap == pytest.approx(0.1)


def test_a_fly_by_that_is_a_stop_is_told_with_its_reason(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    program.write_text(program.read_text().replace("j_side, v1000, fine", "j_side, v1000, z10"))
    assert run(["optimize", str(program)]) == 0
    assert "1 fly-by point is a stop: a wait follows (1)" in " ".join(capsys.readouterr().out.split())
    summary = json.loads(Path("results/tiny/summary.json").read_text())
    assert summary["fly_bys_passed"] == {"stream": 0, "rapid": 0}
    assert summary["fly_bys_stopped"] == [{"index": 0, "source": "tiny.mod:6:9", "why": "a wait follows"}]
    # the key of older folders says nothing that is read back
    assert run(["verify", "results/tiny"]) == 0
