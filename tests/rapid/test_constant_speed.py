"""Which lines and arcs should keep their programmed speed, as the cell file names them."""

from __future__ import annotations

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveC, MoveL, Program, TextFile
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import ConstantSpeed, Lines, Scenario

CELL = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\nconstant_speed: "
REST = ",[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
L = f"MoveL [[500,0,500]{REST},v100,z10,tool0;"
J = f"MoveJ [[500,0,400]{REST},v100,z10,tool0;"
C = f"MoveC [[500,50,500]{REST},[[550,50,500]{REST},v100,z10,tool0;"
WELD = f"PROC weld()\n{J}\n{L}\nseam;\nENDPROC\nPROC seam()\n{C}\nENDPROC"


def of(text: str) -> ConstantSpeed:
    return parse_cell(CELL + text, "cell.yaml").scenario.constant_speed


def run(body: str, wish: ConstantSpeed, rest: str = "") -> Program:
    """A program whose main begins in line 3."""
    text = f"MODULE m\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n"
    return run_program([TextFile("cell/m.mod", text, "utf-8")], Scenario(constant_speed=wish))


def marks(body: str, wish: str, rest: str = "") -> list[bool]:
    return [m.constant_speed for m in run(body, of(wish), rest).motions if isinstance(m, MoveL | MoveC)]


def test_a_procedure_with_all_it_calls() -> None:
    assert marks(f"{L}\nWeld;\n{L}\nseam;", "[WELD]", WELD) == [False, True, True, False, False]
    assert marks(f"{L}\nWeld;\n{L}\nseam;", "[seam]", WELD) == [False, False, True, False, True]


def test_lines_with_all_they_call() -> None:
    body = f"{L}\n{L}\nweld;\n{L}"
    assert marks(body, "[3]", WELD) == [True, False, False, False, False]
    assert marks(body, "['M.mod:4-5']", WELD) == [False, True, True, True, False]
    assert marks(body, "[m.mod:3, 6]", WELD) == [True, False, False, False, True]
    assert marks(body, "[]", WELD) == [False] * 5


def test_joint_moves_keep_no_speed() -> None:
    program = run("weld;", of("[weld]"), WELD)
    assert [getattr(m, "constant_speed", None) for m in program.motions] == [False, True, True]


def test_what_the_cell_file_says() -> None:
    expected = ConstantSpeed(frozenset({"weld"}), frozenset({Lines(None, 7, 7), Lines("glue.mod", 35, 48)}))
    assert of("[Weld, 7, 'glue.mod:35-48']") == expected
    assert of("[weld, '7', 'glue.mod: 35 - 48']") == expected


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("maine", "the program has no procedure 'maine'; did you mean 'main'?"),
        ("glue", "the program has no procedure 'glue'; there is main"),
        ("4", "no statement begins in line 4; the nearest one is in line 3"),
        ("m.mod:8-9", "no statement begins in lines m.mod:8-9; the nearest one is in line 3"),
        ("x.mod:3", "no statement begins in line x.mod:3; there is m.mod"),
    ],
)
def test_what_the_program_does_not_have_is_an_error(entry: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        run(L, of(f"[{entry}]"))
    assert str(caught.value) == f"constant_speed in the cell file: {message}"


@pytest.mark.parametrize(("entry", "text"), [("weld", "weld"), ("3", "line 3"), ("3-4", "lines 3-4")])
def test_an_entry_without_a_line_or_an_arc_is_said(entry: str, text: str) -> None:
    program = run(f"{J}\n{J}", of(f"[{entry}]"), WELD)
    assert [*map(str, program.warnings)] == [f"constant_speed in the cell file: no line and no arc ran in {text}"]


@pytest.mark.parametrize("entry", ["0", "true", "a b", "'glue.mod:'", "1.5", "[1]", "'glue.mod'", "'3-'"])
def test_what_is_neither_a_procedure_nor_lines_is_refused(entry: str) -> None:
    expected = r"cell.yaml:3: constant_speed.*needs a procedure or lines of the program, weld, 41 or 'glue.mod:35-48'"
    with pytest.raises(InputError, match=expected):
        of(f"[{entry}]")


def test_lines_go_forward() -> None:
    with pytest.raises(InputError, match="goes from line 9 to line 3; the first one comes first"):
        of("[9-3]")
    with pytest.raises(InputError, match=r'needs a line of the program, 41 or .hinge.mod:41., not "3-4"'):
        parse_cell(CELL + "[]\nhold_rail: {lines: [3-4]}\n", "cell.yaml")
