"""What holds the rail although nobody asked for it is said, with what lets it move."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from unrefined import set_defaults

from trajopt_cli.cli import run

HELD = """MODULE held
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j_home, v1000, fine, tool0;
        Set do1;
        WaitTime 0.2;
    ENDPROC
ENDMODULE
"""
CELL = (Path(__file__).parents[2] / "programs" / "hinge_cell.yaml").read_text(encoding="utf-8")


@pytest.mark.usefixtures("unrefined")
@pytest.mark.parametrize("held", [True, False])
def test_what_holds_the_rail_unasked_is_said_once(
    held: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    set_defaults(monkeypatch, polished_legs=0)  # how good a plan is does not matter
    monkeypatch.setattr("trajopt_cli.plan.rail_refinement._REFINE_ROUNDS", 1)
    Path("held.mod").write_text(HELD, encoding="utf-8")
    Path("held.yaml").write_text(CELL.replace("waits:", "# waits:") if held else CELL, encoding="utf-8")
    sentence = "the rail holds still in 1 wait (held.mod:6); 'waits: {rail: free}' in the cell file"
    for command in (["optimize", "held.mod", "--jobs", "1"], ["compare", "baseline", "held.mod"]):
        assert run(command) == 0
        assert " ".join(capsys.readouterr().out.split()).count(f"{sentence} lets it move") == held
    said = json.loads(Path("results/held/summary.json").read_text())["warnings"]
    assert sum(line.startswith(sentence) for line in said) == held
