r"""Targets that are turned about the tool's axis, written as RelTool(TARGET,0,0,0\Rz:=ANGLE) and read again."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from rail_plans import plan_for
from small_cells import plant_with_rail, plant_without_rail

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.motion import FreeTurn, PoseMove, Program, TextFile
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.tool_turns import STEP, turned
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import FreeTool, Scenario
from trajopt_cli.warnings import Source

REST = "[0,0,1,0],[0,0,0,0],[{},9E9,9E9,9E9,9E9,9E9]]"


def read(text: str, axis: tuple[float, float, float] = (0.0, 0.0, 1.0)) -> Program:
    free = FreeTool(FreeTurn(axis, -3.0, 3.0), Source("cell.yaml", 3, 1))
    return run_program([TextFile("m.mod", text, "utf-8")], Scenario(free=(free,)))


def module(body: str, rail: str = "9E9") -> str:
    rest = REST.format(rail)
    return f"""MODULE m
CONST robtarget p1:=[[500,-100,450],{rest}; ! left
CONST robtarget ps{{3}}:=[[[500,0,450],{rest},[[500,50,450],{rest},[[500,100,450],{rest}];
PROC main()
{body}
ENDPROC
PROC serve(robtarget p)
MoveL p,v100,fine,tool0;
ENDPROC
ENDMODULE
"""


def exported(program: Program, turns: dict[int, float], plant: Plant, rails: dict[int, float] | None = None) -> str:
    """The text with the turns; export_rapid itself reads it again and holds it against the plan."""
    plan = replace(plan_for(turned(program, turns), plant, rails or {}), turns=turns)
    return export_rapid(program, plan, plant).texts["m.mod"]


def poses(program: Program) -> list[np.ndarray]:
    return [one.X_WT for one in program.motions if isinstance(one, PoseMove)]


@pytest.mark.parametrize(
    "target", ["p1", "Offs(p1,0,0,40)", "RelTool(p1,0,0,-40\\Rz:=10)", "ps{2}", "[[450,0,450]," + REST.format("9E9")]
)
def test_the_target_stays_as_written_inside(target: str) -> None:
    program, turns = read(module(f"MoveJ {target},v100,fine,tool0;")), {0: 12_345 * STEP}
    text = exported(program, turns, plant_without_rail())
    assert rf"MoveJ RelTool({target},0,0,0\Rz:=12.345),v100,fine,tool0;" in text
    assert poses(read(text))[0] == pytest.approx(poses(turned(program, turns))[0], abs=1e-6)


@pytest.mark.parametrize("axis", [0, 1])
def test_other_axes(axis: int) -> None:
    unit = (1.0, 0.0, 0.0) if axis == 0 else (0.0, 1.0, 0.0)
    program, turns = read(module("MoveJ p1,v100,fine,tool0;"), unit), {0: -20_000 * STEP}
    text = exported(program, turns, plant_without_rail())
    assert rf"RelTool(p1,0,0,0\R{'xy'[axis]}:=-20)" in text
    assert poses(read(text))[0] == pytest.approx(poses(turned(program, turns))[0], abs=1e-6)


def test_passes_of_a_counter_have_turns_of_their_own() -> None:
    program = read(module("MoveJ p1,v100,fine,tool0;\nFOR i FROM 1 TO 3 DO\nMoveL ps{i},v100,fine,tool0;\nENDFOR"))
    turns = {1: 5_000 * STEP, 3: -7_500 * STEP}
    text = exported(program, turns, plant_without_rail())
    (name,) = re.findall(r"RelTool\(ps\{i\},0,0,0\\Rz:=(\w+)\{i\}\)", text)
    assert f"LOCAL CONST num {name}{{3}}:=[5,0,-7.5];" in text
    assert [X for X in poses(read(text))] == [pytest.approx(X, abs=1e-6) for X in poses(turned(program, turns))]


def test_a_rail_and_a_turn_go_together() -> None:
    program = read(module("MoveJ p1,v100,fine,tool0;\nMoveL Offs(p1,0,0,30),v100,fine,tool0;", "0"))
    turns, plant = {0: 30_000 * STEP, 1: 20_000 * STEP}, plant_with_rail()
    text = exported(program, turns, plant, {0: 0.05, 1: 0.1})
    assert re.search(r"RelTool\(RailAt\(p1,50.*\),0,0,0\\Rz:=30\)", text)
    again = read(text)
    assert [one.extax[0] for one in again.motions if isinstance(one, PoseMove)] == pytest.approx([50.0, 100.0])
    assert poses(again)[1] == pytest.approx(poses(turned(program, turns))[1], abs=1e-6)


def test_one_statement_says_one_turn() -> None:
    program = read(module("MoveJ p1,v100,fine,tool0;\nserve ps{1};\nserve ps{2};"))
    with pytest.raises(InputError) as caught:
        exported(program, {1: 5_000 * STEP, 2: 6_000 * STEP}, plant_without_rail())
    assert caught.value.line == 10


def test_a_target_in_place_is_edited_inside() -> None:
    body = "MoveJ [[450,0,450],{},v100,fine,tool0;"
    program = read(module(body.format(REST.format("0"))))
    text = exported(program, {0: 9_000 * STEP}, plant_with_rail(), {0: 0.08})
    (inside,) = re.findall(r"MoveJ RelTool\((\[\[450,0,450\],.*\]),0,0,0\\Rz:=9\),v100", text)
    assert inside.endswith("[80,9E9,9E9,9E9,9E9,9E9]]")


def test_no_turn_no_change() -> None:
    assert "RelTool" not in exported(read(module("MoveJ p1,v100,fine,tool0;")), {}, plant_without_rail())
