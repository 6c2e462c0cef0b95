"""Loops that never end, from the program's text to the text with the plan in it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from unrefined import coarse_search, rapid_alone

from trajopt_cli.cli import run
from trajopt_cli.job import read_job
from trajopt_cli.motion import Move
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.scenario import Scenario

CELL = """robot: irb140_rail
rail: {eax: a, stroke: [-0.2, 2.2]}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0.6}
"""
PROGRAM = """MODULE cycle
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[600,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_a:=[[500,600,450],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_b:=[[500,900,400],[0,0,1,0],[0,0,0,0],[900,9E9,9E9,9E9,9E9,9E9]];
    VAR num n;
    PROC main()
        rInit;
        WHILE TRUE DO
            MoveJ p_b,v1000,fine,tool0;
            n:=1-n;
            IF n=5 WaitTime 1;
            MoveJ p_a,v1000,fine,tool0;
        ENDWHILE
    ENDPROC
    PROC rInit()
        MoveAbsJ j_home,v1000,fine,tool0;
        MoveJ p_a,v1000,fine,tool0;
    ENDPROC
ENDMODULE
"""


@pytest.fixture
def rails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> object:
    """Plan a program on its cell and give back where the rail is at the points of its text with the plan in it."""
    monkeypatch.chdir(tmp_path)
    rapid_alone(monkeypatch)

    def of(more: str = "", text: str = PROGRAM) -> list[float]:
        Path("cycle.mod").write_text(text, encoding="utf-8")
        Path("cycle.yaml").write_text(CELL + more, encoding="utf-8")
        assert run(["optimize", "cycle.mod", "--quiet"]) == 0
        program = read_program([Path("results/cycle/program.mod")], Scenario())
        assert "WHILE TRUE DO" in Path("results/cycle/program.mod").read_text(encoding="utf-8")
        moves = [one for one in program.motions if isinstance(one, Move)]
        assert [one.source.line for one in moves] == [9, 12]
        return [(one.extax[0] or np.nan) / 1000 for one in moves]

    return of


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """For tests that ask nothing of how good the rail's places are."""
    coarse_search(monkeypatch)


@pytest.mark.usefixtures("few")
def test_two_passes_of_the_exported_loop_are_the_steady_pass_as_planned(rails) -> None:  # type: ignore[no-untyped-def]
    """As written the rail goes 0.3 m there and back; it ends up where it hardly goes."""
    found = rails()
    assert abs(found[1] - found[0]) < 0.15
    rows = np.loadtxt("results/cycle/rapid.csv", delimiter=",", skiprows=1)
    assert np.abs(rows[-1, 1:8] - rows[0, 1:8]).max() < 1e-6
    assert rows[0, 1] == pytest.approx(found[1], abs=1e-6)
    assert run(["verify", "results/cycle"]) == 0


@pytest.mark.usefixtures("few")
def test_the_way_into_the_loop_keeps_its_targets(rails) -> None:  # type: ignore[no-untyped-def]
    """rInit must hold the rail at p_a, 0.6 m, where its declaration stays; the loop's own moves say where they go."""
    held = rails("hold_rail: {procedures: [rInit]}\n")
    assert abs(held[1] - held[0]) < 0.15
    assert held[1] != 0.6
    text, given = (Path(name).read_text(encoding="utf-8") for name in ("results/cycle/program.mod", "cycle.mod"))
    assert [line for line in text.splitlines() if "p_a:=" in line] == [
        line for line in given.splitlines() if "p_a:=" in line
    ]
    assert run(["verify", "results/cycle"]) == 0


@pytest.mark.long
@pytest.mark.parametrize(("step", "told"), [(250, True), (20, False)])
def test_a_target_serves_the_passes_that_are_not_planned_as_well(  # type: ignore[no-untyped-def]
    rails, step: int, told: bool
) -> None:
    """Rows at y = 0.9, 1.15 and 1.4 m: the rail that suits the second is too far from the third."""
    text = PROGRAM.replace("MoveJ p_b,v1000", f"ConfJ\\Off; MoveJ Offs(p_b,0,{step}*n,0),v1000")
    found = rails(text=text.replace("n:=1-n", "n:=(n+1) MOD 3"))
    notes = json.loads(Path("results/cycle/summary.json").read_text())["notes"]
    assert any("a pass behind the cycle" in note and "cycle.mod:9:" in note for note in notes) == told
    assert (found[0] == 0.9) == told


@pytest.mark.long
@pytest.mark.usefixtures("few")
def test_savings_of_several_passes_are_told_per_pass(rails, capsys: pytest.CaptureFixture[str]) -> None:  # type: ignore[no-untyped-def]
    rails()
    once = capsys.readouterr().out.splitlines()[0]
    Path("cycle.yaml").write_text(f"{CELL}endless_passes: 2\n", encoding="utf-8")
    assert run(["optimize", "cycle.mod", "--quiet"]) == 0
    twice = capsys.readouterr().out.splitlines()[0]
    assert twice.split(" → ")[0] == once.split(" → ")[0]
    assert ", per pass of 2" in twice
    summary = json.loads(Path("results/cycle/summary.json").read_text())
    assert summary["passes"] == 2


def test_the_plant_of_a_job_stands_where_its_cycle_begins(tmp_path: Path) -> None:
    path = tmp_path / "cycle.mod"
    path.write_text(PROGRAM, encoding="utf-8")
    path.with_suffix(".yaml").write_text(CELL.replace("rail: 0.6}", "rail: 1.5}"), encoding="utf-8")
    job = read_job(path)
    assert job.plant.start[0] == 0.6
    X_WF = job.plant.robot.forward(job.plant.start)
    assert X_WF[:3, 3] == pytest.approx([0.5, 0.6, 0.45], abs=1e-9)
    assert job.plant.at_home.start == pytest.approx([1.5, 0, 0, 0, 0, np.pi / 6, 0])


@pytest.mark.usefixtures("few")
@pytest.mark.parametrize(
    ("given", "instead", "line"),
    [
        ("MoveAbsJ j_home", "MoveJ Offs(p_a,0,5000,0),v1000,fine,tool0; MoveAbsJ j_home", 16),
        ("j_home:=[[0,", "j_home:=[[400,", 16),
        ("],[600,", "],[6000,", 16),
        (
            "MoveJ p_b,",
            "MoveJ Offs(p_b,0,n DIV 2*5000,0),",
            9,
        ),  # of three passes the last is driven only behind the cycle
    ],
)
def test_what_cannot_be_driven_outside_the_cycle_is_told(
    rails: object, capsys: pytest.CaptureFixture[str], given: str, instead: str, line: int
) -> None:
    text = PROGRAM.replace(given, instead, 1).replace("n:=1-n", "n:=(n+1) MOD 3")
    Path("cycle.mod").write_text(text, encoding="utf-8")
    Path("cycle.yaml").write_text(CELL, encoding="utf-8")
    assert run(["check", "cycle.mod", "--json"]) == 1
    told = json.loads(capsys.readouterr().out)
    assert [one["state"] for one in told["checks"][:2]] == ["ok", "NO"]
    assert f"cycle.mod:{line}:" in told["worst"]
    assert run(["estimate", "cycle.mod", "--quiet"]) == 0
    assert f"cannot be driven as written: cycle.mod:{line}:" in capsys.readouterr().err
    assert run(["optimize", "cycle.mod", "--quiet"]) == 0
    assert f"; legal; {told['worst']}" in capsys.readouterr().out
