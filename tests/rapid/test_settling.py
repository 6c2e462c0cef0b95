r"""Where axes settle: at the stops behind which a program waits, or reads or sets a signal, before it moves on."""

from __future__ import annotations

import pytest

from trajopt_cli.motion import Hold, Move, Program, Source, TextFile, Wait
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import NO_SETTLING, HoldRail, RailUnit, Scenario, Settling

FINE, INPOS = 0.25, 0.125
BOTH = Settling(FINE, INPOS)
DATA = """CONST robtarget p:=[[500,0,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget q:=[[500,0,600],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
CONST jointtarget j:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
VAR num n; VAR bool b;"""
STOP, PASSED, ASKED = "MoveL p,v100,fine,tool0;", "MoveL p,v100,z10,tool0;", r"MoveL p,v100,fine\Inpos:=inpos20,tool0;"
BESIDE, ON = r"MoveL\Conc,p,v100,fine,tool0;", "MoveL q,v100,fine,tool0;"


def run(body: str, settle: Settling = BOTH, **more: object) -> Program:
    given = {"signals": {"di1": 1.0, "gi1": 2.0, "ai1": 0.5}, "answers": {"uimsgbox": 1.0}, **more}
    scenario = Scenario(settle=settle, **given)  # type: ignore[arg-type]
    return run_program(
        [TextFile("m.mod", f"MODULE m\n{DATA}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n", "utf-8")], scenario
    )


def settling(program: Program) -> list[float]:
    return [one.duration for one in program.motions if isinstance(one, Wait) and one.settles]


@pytest.mark.parametrize(
    "statement",
    [
        "WaitTime 1;", r"WaitTime\InPos,0.5;", "WaitDI di1,1;", "WaitUntil di1=1;", r"WaitRob\InPos;", "Stop;",
        "WaitSyncTask sync1,tasks1;", 'UIMsgBox "n";', "SetDO do1,1;", "Set do1;", "SetGO go1,3;",
        r"PulseDO\PLength:=0.2,do1;", "IF di1=1 n:=1;", "b:=TestDI(di1);", "n:=DOutput(do1);", "n:=GInput(gi1);",
        "TEST di1 CASE 1: n:=1; DEFAULT: n:=2; ENDTEST", "MoveL Offs(q,0,0,100*di1),v100,fine,tool0;",
        'TPWrite "n"; n:=1; WaitTime 0.1;', "WHILE n<3 DO n:=n+1; WaitTime 0.1; ENDWHILE",
        "SetDO do1,1; WaitTime 1; SetDO do1,0; WaitDI di1,1;",
    ],
)  # fmt: skip
def test_a_stop_settles_once_where_the_program_waits_or_reads_or_sets_a_signal(statement: str) -> None:
    bare, found = run(f"{STOP} {statement} {ON}", NO_SETTLING), run(f"{STOP} {statement} {ON}")
    assert settling(bare) == []
    assert settling(found) == [FINE]
    at = next(i for i, one in enumerate(found.motions) if isinstance(one, Wait) and one.settles)
    assert isinstance(found.motions[at - 1], Move)  # before everything that waits for it
    assert [type(one) for i, one in enumerate(found.motions) if i != at] == [type(one) for one in bare.motions]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (f"{STOP} {ON}", []),  # between two moves
        (f"WaitTime 1; {STOP} {ON}", []),  # the program begins at rest
        (f"{STOP} WaitTime 0; {ON}", []),  # which waits for nothing
        (f'{STOP} TPWrite "n"; n:=n+1; ConfL\\Off; {ON}', []),
        (f"{PASSED} SetDO do1,1; {ON}", []),
        (f"{PASSED} WaitTime 1; {ON}", []),  # a stop, and the wait runs while the axes come to it
        (f"{PASSED} WaitTime\\InPos,1; {ON}", [INPOS]),
        (f"{PASSED} WaitTime 1; WaitRob\\InPos; {ON}", [INPOS]),
        (f"{ASKED} WaitTime 1; {ON}", [INPOS]),
        (f"{ASKED} WaitTime\\InPos,1; {ON}", [INPOS]),
        (f"{BESIDE} WaitTime 1; {ON}", []),  # the wait runs beside the move
        (f"{BESIDE} WaitTime 1; WaitTime\\InPos,0.1; {ON}", [FINE]),
        (f"{STOP} WaitTime 1; {STOP} SetDO do1,1; {ON} WaitTime 1;", [FINE, FINE, FINE]),
        ("MoveAbsJ j,v100,fine,tool0; WaitTime 1; MoveAbsJ j,v100,fine,tool0; WaitTime 0.1;", [FINE, FINE]),
        (f"FOR i FROM 1 TO 3 DO {STOP} WaitTime 1; ENDFOR", [FINE] * 3),
    ],
)
def test_which_stops_settle(body: str, expected: list[float]) -> None:
    assert settling(run(body)) == expected


def test_a_cycle_in_steady_state_settles_at_the_stop_that_the_pass_before_ended_at() -> None:
    program = run(f"WHILE TRUE DO WaitDI di1,1; {STOP} {ON} ENDWHILE")
    assert settling(program) == [FINE]
    assert program.before is not None
    assert not any(isinstance(one, Wait) and one.settles for one in program.before)


def test_a_line_that_stands_for_a_wait_settles_like_the_wait() -> None:
    r"""As `export rapid` writes it: the tool rests for \T while the rail moves, and what is left is waited for."""
    line = r"MoveL [[500,0,500],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]],v100\T:=1,fine,tool0;"
    for body in (f"{STOP} {line} {ON}", f"{STOP} {line} WaitDI di1,1; {ON}"):
        program = run(body, waits={"di1": 1.0})
        assert settling(program) == [FINE]
        assert [one.hold for one in program.motions[1:2] if isinstance(one, Wait)] == [Hold.SETTLING]
        assert sum(one.duration for one in program.motions if isinstance(one, Wait)) == FINE


def test_what_settles_is_no_wait_that_the_cell_file_frees_and_no_time_between_an_output_and_a_wait() -> None:
    freed = HoldRail(free={"di1": Source("c.yaml", 1, 1), "main": Source("c.yaml", 2, 1)})
    program = run(f"{STOP} SetDO do1,1; WaitTime 0.5; WaitDI di1,1; {ON}", hold_rail=freed, rail=RailUnit(0))
    assert [one.hold for one in program.motions if isinstance(one, Wait)] == [Hold.SETTLING, None, None]
    program = run(f"MoveLDO p,v100,fine,tool0,do1,1; WaitTime 1; {ON}")
    assert [one.hold for one in program.motions if isinstance(one, Wait)] == [Hold.SETTLING, Hold.GRIPPER]
    program = run(f"{STOP} ! trajopt: hold rail\nWaitTime 1; ! trajopt: hold rail\n{ON}")
    assert [one.hold for one in program.motions if isinstance(one, Wait)] == [Hold.SETTLING, Hold.PROGRAM]
