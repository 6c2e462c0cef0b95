"""A copy of a routine for each call of it, and the same motions."""

from __future__ import annotations

import numpy as np
import pytest
from small_cells import plant_with_rail

from trajopt_cli.motion import MoveJ, Program, TextFile
from trajopt_cli.problem.unrolled import unrolled
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

PLANT = plant_with_rail()
GO = """    PROC go(num h)
        MoveJ Offs(p,0,0,h),v100,fine,tool0; ! up
    ENDPROC
"""


def made(body: str, rest: str = GO, scenario: Scenario | None = None) -> Program:
    text = (
        "MODULE m\n    CONST robtarget p:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];\n"
        f"    VAR num n;\n    PROC main()\n{body}    ENDPROC\n{rest}ENDMODULE\n"
    )
    return run_program([TextFile("m.mod", text, "utf-8")], scenario)


def text_of(program: Program) -> str:
    return program.files["m.mod"].text


def heights(program: Program) -> list[float]:
    return [round(float(one.X_WT[2, 3]) * 1e3 - 450, 6) for one in program.motions if isinstance(one, MoveJ)]


@pytest.mark.parametrize(
    ("body", "rest", "statements"),
    [
        ("        go 1;\n        go 2;\n", GO, 2),
        ("        two;\n        two;\n", f"    PROC two()\n        go 1;\n        go 2;\n    ENDPROC\n{GO}", 4),
        ("        FOR i FROM -1 TO 1 DO\n            go i;\n        ENDFOR\n", GO, 3),
        ("        FOR i FROM 4 TO 1 STEP -3 DO\n            FOR j FROM 1 TO 2 DO\n                go i*j;\n"
         "            ENDFOR\n        ENDFOR\n", GO, 4),
        ("        IF n=0 THEN\n            go 1;\n        ENDIF\n        go 2;\n", GO, 2),
        ("        WHILE n<2 DO\n            go n;\n            n:=n+1;\n        ENDWHILE\n", GO, 1),
        ('        %"go"% 1;\n        go 2;\n', GO, 1),
        ("        go 2;\n", GO.replace("        MoveJ", "        IF h>1 go h-1;\n        MoveJ"), 1),
        ("        FOR i FROM 1 TO 2 DO\n            MoveJ Offs(p,0,0,i),v100,fine,tool0;\n        ENDFOR\n", GO, 1),
    ],
)  # fmt: skip
def test_calls_get_copies_and_the_motions_stay(body: str, rest: str, statements: int) -> None:
    """By hand: how many statements the motions then have."""
    program = made(body, rest)
    there = unrolled(program, PLANT, Scenario())
    assert len({motion.written.statement for motion in there.motions}) == statements
    again = run_program(list(there.files.values()))
    assert heights(again) == heights(program)
    assert [m.written.statement for m in again.motions] == [m.written.statement for m in there.motions]
    np.testing.assert_array_equal([m.source.line for m in there.motions], [m.source.line for m in program.motions])
    if statements == 1:
        assert there is program


def test_only_the_calls_that_are_asked_for_are_copied() -> None:
    rest = GO + GO.replace("go", "other").replace("Offs(p,0,0,h)", "Offs(p,h,0,0)")
    program = made("        go 1;\n        go 2;\n        other 1;\n        other 2;\n", rest)
    text = text_of(unrolled(program, PLANT, Scenario(), {"other"}))
    assert "        go 1;\n        go 2;\n        other 1;\n        other_2 2;\n" in text
    assert text.count("PROC other_2(num h)") == text.count("ENDPROC") - 3 == 1


def test_a_mark_on_a_loop_keeps_it_a_loop() -> None:
    body = "        FOR i FROM 1 TO 2 DO ! trajopt: hold rail\n            go i;\n        ENDFOR\n"
    assert unrolled(program := made(body), PLANT, Scenario()) is program
