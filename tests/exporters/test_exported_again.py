"""Exported programs that are exported again, and what must not be taken for an export's."""

from __future__ import annotations

import pytest
from rail_plans import J1, made, plan_for
from small_cells import plant_with_rail

from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.exporters.rapid_check import read_again
from trajopt_cli.motion import MoveJ, MoveL, Program, TextFile
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

PLANT = plant_with_rail()


def exported(program: Program, rails: dict[int, float]) -> str:
    return export_rapid(program, plan_for(program, PLANT, rails), PLANT).texts["m.mod"]


def read(text: str) -> Program:
    return run_program([TextFile("m.mod", text, "utf-8")])


LOOP = "        FOR i FROM 1 TO 3 DO\n            MoveJ Offs(p1,i,0,0),v100,fine,tool0;\n        ENDFOR\n"


def test_arrays_do_not_pile_up() -> None:
    once = exported(made(LOOP), {0: 0.25, 1: 0.26, 2: 0.27})
    twice = exported(read(once), {0: 0.28, 1: 0.29, 2: 0.3})
    thrice = exported(read(twice), {0: 0.25, 1: 0.26, 2: 0.27})
    assert [text.count("LOCAL CONST num") for text in (once, twice, thrice)] == [1, 1, 1]
    assert [text.count("LOCAL FUNC") for text in (once, twice, thrice)] == [1, 1, 1]
    assert thrice == once
    both = once.replace("        ENDFOR\n", "        ENDFOR\n        nRail:=rail1{1};\n")
    both = both.replace("    PROC main", "    VAR num nRail;\n    PROC main")
    assert exported(read(both), {0: 0.28, 1: 0.29, 2: 0.3}).count("LOCAL CONST num") == 2  # somebody else reads it


@pytest.mark.parametrize(
    "function",
    [
        "LOCAL FUNC robtarget RailAt(robtarget p,num rail)\np.extax.eax_b:=rail;\nRETURN p;\nENDFUNC\n",
        "FUNC robtarget RailAt(robtarget p,num rail\\confdata conf)\np.extax.eax_a:=rail;\n"
        "IF Present(conf) p.robconf:=conf;\nRETURN p;\nENDFUNC\n",
    ],
    ids=["of another axis", "that all modules see"],
)
def test_a_users_own_function_stays(function: str) -> None:
    program = made("        MoveJ RailAt(p1,5),v100,fine,tool0;\n", rest=function)
    text = exported(program, {0: 0.3})
    assert "MoveJ RailAt_2(RailAt(p1,5),300\\conf:=" in text


def test_a_declaration_stays_that_moves_name_that_never_ran() -> None:
    """What they do was neither planned nor judged."""
    for idle in ("        IF FALSE THEN\n            MoveL p1,v50,fine,tool0;\n        ENDIF\n", ""):
        rest = "" if idle else "    PROC other()\n        MoveL Offs(p1,0,0,9),v50,fine,tool0;\n    ENDPROC\n"
        text = exported(made(J1 + idle, rest=rest), {0: 0.3})
        assert "p1:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9" in text
        assert "MoveJ RailAt(p1,300" in text
    assert "RailAt" not in exported(made(J1), {0: 0.3})


@pytest.mark.parametrize("target", ["Offs(CRobT(\\Tool:=tool0),0,0,20)", "Offs(pHere,0,0,20)"])
def test_what_hangs_on_where_the_robot_is_says_its_own_rail(target: str) -> None:
    """As given the target has the rail that the plan wants; in the edited program it would have that of the move
    before."""
    read_it = "        pHere:=CRobT(\\Tool:=tool0);\n" if "pHere" in target else ""
    body = f"{J1}{read_it}        MoveL {target},v100,fine,tool0;\n"
    program = made(body, "    VAR robtarget pHere;\n")
    text = exported(program, {0: 0.3, 1: 0.2})
    assert f"MoveL RailAt({target},200" in text
    moves = read_again(program, PLANT, Scenario(), {"m.mod": text}).motions
    assert [move.extax[0] for move in moves if isinstance(move, MoveJ | MoveL)] == [300, 200]
