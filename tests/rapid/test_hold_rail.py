"""Where the rail must stand still: comments in the program, the cell file, waits right after an output."""

from __future__ import annotations

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.motion import Hold, Move, Program, SignalEvent, TextFile, Wait
from trajopt_cli.rapid.execution.rail import freed_by_default, held_by_default
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import HoldRail, Scenario

CELL = (
    "robot: irb140_rail\nrail: {eax: a, stroke: [-0.2, 2.2]}\nstart: {joints: [0, 0, 0, 0, 0.5, 0], rail: 0}\n"
    "hold_rail: "
)
P = "CONST robtarget p:=[[500,0,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];"
L = "MoveL p,v100,fine,tool0;"
NO, PROGRAM, OF_CELL, GRIPPER = None, Hold.PROGRAM, Hold.CELL, Hold.GRIPPER


def run(text: str, wish: HoldRail | None = None, rest: str = "") -> Program:
    """A program whose main begins in line 4."""
    module = f"MODULE m\n{P}\nPROC main()\n{text}\nENDPROC\n{rest}\nENDMODULE\n"
    scenario = Scenario(hold_rail=wish) if wish else None
    return run_program([TextFile("cell/m.mod", module, "utf-8")], scenario)


def holds(text: str, wish: HoldRail | None = None, rest: str = "") -> list[Hold | None]:
    program = run(text, wish, rest)
    return [motion.hold for motion in program.motions if not isinstance(motion, SignalEvent)]


# --------------------------------------------------------------------------------------------------------- comments


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (f"{L}\n{L} ! trajopt: hold rail\n{L}", [NO, PROGRAM, NO]),
        (f"{L}\n!TRAJOPT:  Hold  Rail\nWaitTime 1;\n{L}", [NO, PROGRAM, NO]),
        (f"{L} {L} ! trajopt: hold rail", [NO, PROGRAM]),
        (f"MoveL p,\nv100,fine,tool0; ! trajopt: hold rail\n{L}", [PROGRAM, NO]),
        (f"FOR i FROM 1 TO 2 DO ! trajopt: hold rail\n{L}\nENDFOR\n{L}", [PROGRAM, PROGRAM, NO]),
        (f"FOR i FROM 1 TO 2 DO\n{L}\nENDFOR ! trajopt: hold rail\n{L}", [PROGRAM, PROGRAM, NO]),
        (f"! trajopt: hold rail\nFOR i FROM 1 TO 2 DO\n{L}\nENDFOR\n{L}", [PROGRAM, PROGRAM, NO]),
        (f"IF TRUE THEN\n{L} ! trajopt: hold rail\n{L}\nENDIF", [PROGRAM, NO]),
    ],
)
def test_a_comment_marks_a_statement_with_all_that_runs_in_it(body: str, expected: list[Hold | None]) -> None:
    program = run(body)
    assert [motion.hold for motion in program.motions if not isinstance(motion, SignalEvent)] == expected
    assert tuple(map(str, program.warnings)) == ()


@pytest.mark.parametrize(
    "routine",
    [
        f"! trajopt: hold rail\nPROC weld()\n{L}\nseam;\nENDPROC",
        f"PROC weld() ! trajopt: hold rail\n{L}\nseam;\nENDPROC",
        f"PROC weld()\n{L}\nseam;\nENDPROC ! trajopt: hold rail",
    ],
)
def test_a_marked_procedure_holds_the_rail_in_what_it_calls_too(routine: str) -> None:
    seam = f"PROC seam()\n{L}\nENDPROC\n"
    assert holds(f"{L} weld; seam;", rest=seam + routine) == [NO, PROGRAM, PROGRAM, NO]


def test_a_marked_call_holds_the_rail_during_this_call_alone() -> None:
    assert holds("seam; ! trajopt: hold rail\nseam;", rest=f"PROC seam()\n{L}\nENDPROC") == [PROGRAM, NO]


def test_a_mark_at_nothing_is_an_error_and_one_where_nothing_ran_a_warning() -> None:
    with pytest.raises(InputError) as caught:
        run(f"{L}\n! trajopt: hold rail\n\n{L}")
    assert str(caught.value) == (
        "cell/m.mod:5:1: '! trajopt: hold rail' marks no instruction; "
        "put it after a move, a wait, a block or a routine or on the line above it"
    )
    assert tuple(map(str, run(f"IF FALSE THEN\n{L} ! trajopt: hold rail\nENDIF").warnings)) == (
        "cell/m.mod:5:1: marked 'hold rail', but no move and no wait ran there",
    )


# -------------------------------------------------------------------------------------------------------- cell file


def of(text: str) -> HoldRail:
    return parse_cell(CELL + text, "cell.yaml").scenario.hold_rail


def test_the_cell_file_names_procedures_lines_and_waits() -> None:
    weld = f"PROC weld()\n{L}\nWaitTime 1;\nENDPROC"
    body = f"{L}\nWaitTime 1;\nWeld;\n{L}"
    assert holds(body, of("{procedures: [WELD]}"), weld) == [NO, NO, OF_CELL, OF_CELL, NO]
    assert holds(body, of("{lines: [4, 'M.mod:6']}"), weld) == [OF_CELL, NO, OF_CELL, OF_CELL, NO]
    assert holds(body, of("{lines: [10]}"), weld) == [NO, NO, OF_CELL, NO, NO]
    assert holds(body, of("{waits: true}"), weld) == [NO, OF_CELL, NO, OF_CELL, NO]
    assert of("{}") == HoldRail() == Scenario().hold_rail


def test_the_program_s_own_mark_goes_first() -> None:
    assert holds("WaitTime 1; ! trajopt: hold rail\nWaitTime 1;", of("{waits: true}")) == [PROGRAM, OF_CELL]
    assert holds(f"{L} ! trajopt: hold rail", of("{lines: [4]}")) == [PROGRAM]


@pytest.mark.parametrize(
    ("wish", "message"),
    [
        ("{procedures: [maine]}", "the program has no procedure 'maine'; did you mean 'main'?"),
        ("{lines: [5]}", "no statement begins in line 5; the nearest one is in line 4"),
        ("{lines: ['x.mod:4']}", "no statement begins in line x.mod:4; there is m.mod"),
    ],
)
def test_a_name_or_a_line_that_the_program_does_not_have_is_an_error(wish: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        run(L, of(wish))
    assert str(caught.value) == f"hold_rail in the cell file: {message}"


def test_a_bare_line_number_needs_a_program_of_one_file() -> None:
    files = [
        TextFile("a/m.mod", f"MODULE m\n{P}\nPROC main()\n{L}\nother;\nENDPROC\nENDMODULE\n", "utf-8"),
        TextFile("a/n.mod", f"MODULE n\nPROC other()\n{L}\n{L}\nENDPROC\nENDMODULE\n", "utf-8"),
    ]
    with pytest.raises(InputError) as caught:
        run_program(files, Scenario(hold_rail=of("{lines: [4]}")))
    assert str(caught.value) == ("hold_rail in the cell file: line 4 could be in any of 2 files; name one, 'm.mod:4'")
    program = run_program(files, Scenario(hold_rail=of("{lines: ['n.mod:4']}")))
    assert [m.hold for m in program.motions if not isinstance(m, SignalEvent)] == [NO, NO, OF_CELL]


def test_a_procedure_that_did_not_run_is_said() -> None:
    program = run(L, of("{procedures: [weld]}"), f"PROC weld()\n{L}\nENDPROC")
    assert tuple(map(str, program.warnings)) == ("hold_rail in the cell file: no move and no wait ran in weld",)


@pytest.mark.parametrize("place", ["0", "true", "hinge.mod", "'hinge.mod:'", "1.5", "[1]"])
def test_what_is_no_line_is_refused(place: str) -> None:
    with pytest.raises(InputError, match=r"cell.yaml:4: hold_rail.lines.*needs a line of the program, 41 or"):
        of(f"{{lines: [{place}]}}")


def test_a_robot_without_a_rail_has_none_to_hold() -> None:
    with pytest.raises(InputError) as caught:
        parse_cell("robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\nhold_rail: {waits: true}\n", "cell.yaml")
    assert str(caught.value) == "cell.yaml:3: hold_rail: there is no rail; remove it or add a rail section"


# ----------------------------------------------------------------------------------------------- waits after outputs


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("Set doGrip; WaitTime 0.3;", [GRIPPER]),
        ("SetDO doGrip,1; WaitDI diClosed,1;", [GRIPPER]),
        (r"SetDO \SDelay:=0.1,doGrip,1; WaitTime 1;", [GRIPPER]),
        (r"SetDO \SDelay:=0.2,doGrip,1; WaitTime 1;", [NO]),
        ("Set doGrip; WaitTime 0.04; WaitTime 0.06; WaitTime 1; WaitTime 1;", [GRIPPER, GRIPPER, GRIPPER, NO]),
        (f"Set doGrip; {L} WaitTime 1;", [NO, NO]),
        (f"WaitTime 1; Set doGrip; {L}", [NO, NO]),
        (f"MoveLDO p,v100,fine,tool0,doGrip,1; WaitTime 1; {L} WaitTime 1;", [NO, GRIPPER, NO, NO]),
        ("TriggL p,v100,t,fine,tool0; WaitTime 1;", [NO, GRIPPER]),
    ],
)
def test_a_wait_right_after_an_output_holds_the_rail_unasked(body: str, expected: list[Hold | None]) -> None:
    body = rf"VAR triggdata t; TriggIO t,0.05\Time\DOp:=doGrip,1; {body}" if "Trigg" in body else body
    assert holds(body) == expected
    assert holds(body, HoldRail(gripper=False)) == [NO] * len(expected)


# -------------------------------------------------------------------------------------------------------- all waits

RIDE = CELL.removesuffix("hold_rail: ")
HELD, UNIT_WAITS = Hold.WAIT, "WaitTime 1;\nSet a; WaitDI diPart,1;\nWeld;"
WELD = f"PROC weld()\n{L}\nWaitUntil diPart=1 AND diB=1; WaitSyncTask s1,t;\nENDPROC"


def in_cell(cell: str, body: str = UNIT_WAITS, rest: str = WELD) -> Program:
    module = f"MODULE m\n{P}\nPROC main()\n{body}\nENDPROC\n{rest}\nVAR syncident s1; PERS tasks t{{1}};\nENDMODULE\n"
    scenario = parse_cell(RIDE + cell, "cell.yaml").scenario
    return run_program([TextFile("cell/m.mod", module, "utf-8")], scenario)


@pytest.mark.parametrize(
    ("cell", "expected"),
    [
        ("", [HELD, GRIPPER, HELD, HELD]),
        ("waits: {rail: hold}", [HELD, GRIPPER, HELD, HELD]),
        ("waits: {rail: 0.5 s}", [HELD, GRIPPER, HELD, HELD]),  # a signal of this name
        ("waits: {rail: free}", [NO, NO, NO, NO]),
        ("waits: {RAIL: {free: [WELD]}}", [HELD, GRIPPER, NO, NO]),
        ("waits: {rail: {free: [4, 'm.mod:5']}}", [NO, NO, HELD, HELD]),
        ("waits: {rail: {free: [diPart]}}", [HELD, NO, HELD, HELD]),
        ("waits: {rail: {free: ['DIPART=1', s1]}}", [HELD, NO, HELD, NO]),
        ("waits: {rail: {free: ['diPart = 1 AND diB = 1']}}", [HELD, GRIPPER, NO, HELD]),
        ("waits: {rail: free}\nhold_rail: {procedures: [weld], gripper: true}", [NO, GRIPPER, OF_CELL, OF_CELL]),
        ("waits: {rail: {free: [4]}}\nhold_rail: {waits: true}", [NO, OF_CELL, OF_CELL, OF_CELL]),
        ("hold_rail: {gripper: false}", [HELD, NO, HELD, HELD]),
        ("hold_rail: {waits: false}", [NO, GRIPPER, NO, NO]),
    ],
)
def test_every_wait_holds_the_rail_unless_the_cell_file_frees_it(cell: str, expected: list[Hold | None]) -> None:
    motions = in_cell(cell).motions
    assert [one.hold for one in motions if isinstance(one, Wait)] == expected
    assert all(one.hold is None or "weld" in cell for one in motions if isinstance(one, Move))


@pytest.mark.parametrize(
    ("cell", "message"),
    [
        ("waits:\n  rail: {free: [weldd]}", "5: waits.rail.free: 'weldd' is no procedure, and .*; did you mean 'weld'"),
        (
            "waits:\n  rail:\n    free:\n    - weld\n    - diPrat",
            "8: waits.rail.free: 'diPrat' is .*; did you mean 'diPart'",
        ),
        ("waits: {rail: {free: [77]}}", "4: waits.rail.free in the cell file: no statement begins in line 77"),
        ("waits: {diPart: free}", r"4: waits.diPart: says nothing .*rail: {free: \[diPart\]}"),
        ("waits: {rail: {free: []}}", "4: waits.rail: needs the waits in which"),
        ("waits: {rail: {free: [1.5]}}", "4: waits.rail: needs a line, a procedure or what is waited for, not 1.5"),
        ("waits: {rail: {held: [weld]}}", "4: waits.rail: needs the waits in which"),
    ],
)
def test_what_cannot_be_freed_is_told_by_its_line_in_the_cell_file(cell: str, message: str) -> None:
    with pytest.raises(InputError, match=f"^cell.yaml:{message}") as caught:
        in_cell(cell)
    assert caught.value.kind is ErrorKind.CELL


def test_a_procedure_that_nobody_has_holds_the_rail_for_its_time() -> None:
    stub = "stubs: [Rivet, Blink]\nwaits: {rivet: 1.5 s"
    body = f"{L} Rivet 3; Blink; {L}"
    one, other = (in_cell(f"{stub}{free}}}", body, "").motions for free in ("", ", rail: {free: [Rivet]}"))
    assert [(type(motion), getattr(motion, "duration", None)) for motion in one][1:2] == [(Wait, 1.5)]
    assert [len(one), one[1].hold, other[1].hold] == [3, HELD, NO]  # type: ignore[union-attr]
    assert len(in_cell("stubs: [Rivet]", f"{L} Rivet;", "").motions) == 1


def test_without_a_rail_no_wait_holds_it_and_none_is_freed() -> None:
    assert [one.hold for one in run("WaitTime 1;").motions] == [None]
    with pytest.raises(InputError, match=r"^cell.yaml:3: waits.rail: there is no rail"):
        parse_cell("robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\nwaits: {rail: free}\n", "cell.yaml")


def test_an_entry_that_frees_no_wait_is_said() -> None:
    (warning,) = in_cell("waits: {rail: {free: [main, weld]}}", f"{L}", WELD).warnings[:1]
    assert "no wait ran in or for main" in str(warning)


def test_it_is_said_once_for_all_of_them() -> None:
    program = in_cell("", "Set a; WaitTime 1;\nWaitTime 1;\nWaitDI b,1;\nWaitTime 1;\nReset a; WaitTime 1;", "")
    assert held_by_default(program) == (
        "the rail holds still in 4 waits (m.mod:4, m.mod:5, m.mod:7 and 1 more); "
        "'waits: {rail: free}' in the cell file lets it move"
    )
    assert held_by_default(freed_by_default(program)) is None
