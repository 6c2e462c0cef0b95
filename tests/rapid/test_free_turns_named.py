"""Where the tool may be turned about its axis, as the cell file says."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.motion import FreeTurn, PoseMove, Program, TextFile
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.warnings import WarningKind

CELL = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\nfree: "
REST = ",[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
TEXT = f"""MODULE m
PERS tooldata tDrill:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
PERS tooldata tPost:=[FALSE,[[500,0,500],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
PERS wobjdata wHeld:=[TRUE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,100],[1,0,0,0]]];
PROC main()
MoveJ [[500,0,500]{REST},v100,fine,tool0;
Drill;
MoveL [[500,0,600]{REST},v100,fine,tool0;
MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
ENDPROC
PROC Drill()
MoveJ [[500,0,400]{REST},v100,fine,tDrill;
MoveL [[500,0,390]{REST},v100,fine,tDrill;
ENDPROC
ENDMODULE
"""
ALL, IN_DRILL = [True, True, True, True], [False, True, True, False]


def run(free: str, text: str = TEXT) -> Program:
    return run_program([TextFile("m.mod", text, "utf-8")], parse_cell(CELL + free, "cell.yaml").scenario)


@pytest.mark.parametrize(
    ("free", "expected"),
    [
        ("{axis: z}", ALL),
        ("{axis: z, in: [Drill]}", IN_DRILL),
        ("{axis: z, in: [tdrill]}", IN_DRILL),
        ("{axis: z, in: [7]}", IN_DRILL),
        ("{axis: z, in: [MoveL]}", [False, False, True, True]),
        ("{axis: z, in: ['m.mod:12']}", [False, True, False, False]),
        ("[{axis: z, in: [6]}, {axis: z, in: [8]}]", [True, False, False, True]),
    ],
)
def test_program_routine_line_tool_or_instruction(free: str, expected: list[bool]) -> None:
    program = run(free)
    assert [m.free is not None for m in program.motions if isinstance(m, PoseMove)] == expected
    assert not program.warnings


def test_axis_and_sector() -> None:
    (motion, *_) = run("{axis: x, within: [-90 deg, 0.5]}").motions
    assert isinstance(motion, PoseMove)
    assert motion.free == FreeTurn((1.0, 0.0, 0.0), pytest.approx(-np.pi / 2), 0.5)
    (motion, *_) = run("[{axis: z}, {axis: y, in: [6], within: '[0, 180] deg'}]").motions  # the last one counts
    assert isinstance(motion, PoseMove)
    assert motion.free == FreeTurn((0.0, 1.0, 0.0), 0.0, pytest.approx(np.pi))


@pytest.mark.parametrize(
    ("free", "key"),
    [
        ("{axis: q}", "free.axis"),
        ("{axis: z, within: [-180, 180]}", "free: within"),
        ("{axis: z, within: [0.1, 0.5]}", "free: within"),
        ("{axis: z, within: [0, 0]}", "free: within"),
        ("{axis: z, within: [-4, 0]}", "free: within"),
        ("{axis: z, in: []}", "free.in"),
        ("{axis: z, of: [Drill]}", "free.of"),
        ("{within: [-1, 1]}", "free."),
        ("{axis: z, in: [Dril]}", "free"),
        ("{axis: z, in: [99]}", "free"),
        ("3", "free"),
    ],
)
def test_what_is_no_free_turn_is_refused_in_its_line(free: str, key: str) -> None:
    with pytest.raises(InputError) as caught:
        run(free)
    assert (caught.value.file, caught.value.line) == ("cell.yaml", 3)
    assert caught.value.message.startswith(key)


def test_an_unknown_name_is_held_against_procedures_instructions_and_tools_alone() -> None:
    text = TEXT.replace("PROC main()", "CONST speeddata vGrilling:=[1,1,1,1];\nPROC main()")
    for entry, near in (("vGrill", "Drill"), ("xyzzy", None)):
        with pytest.raises(InputError) as caught:
            run(f"{{axis: z, in: [{entry}]}}", text)
        said = caught.value.message.partition(";")[2]
        assert "vGrilling" not in said
        if near is not None:
            assert f"'{near}'" in said
        else:
            assert all(name in said for name in ("Drill", "MoveJ", "tDrill"))
    assert "wHeld" not in said


@pytest.mark.parametrize("entry", ["9", "tPost"])
def test_what_frees_nothing_is_told(entry: str) -> None:
    (told,) = run(f"{{axis: z, in: [Drill, {entry}]}}").warnings
    assert told.kind is WarningKind.UNUSED
    assert entry in told.text


def test_a_tool_that_stands_in_the_world_is_not_turned() -> None:
    text = TEXT.replace("v100,fine,tDrill", r"v100,fine,tPost\WObj:=wHeld")
    program = run("{axis: z}", text)
    assert [m.free is not None for m in program.motions if isinstance(m, PoseMove)] == [not x for x in IN_DRILL]
    (told,) = program.warnings
    assert (told.kind, getattr(told.place, "line", None)) == (WarningKind.UNUSED, 12)
