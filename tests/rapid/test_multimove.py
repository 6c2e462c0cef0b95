r"""Moves that robots make together: \ID between SyncMoveOn and SyncMoveOff, and what the other robots take for them."""

from __future__ import annotations

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.motion import Hold, Move, Program, TextFile, Wait
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

DATA = (
    "CONST robtarget p:=[[500,0,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]; "
    "CONST robtarget q:=[[500,80,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]; "
    "CONST robtarget v:=[[520,40,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]; "
    "CONST jointtarget j:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]]; "
    'PERS tasks both{2}:=[["T_ROB1"],["T_ROB2"]]; VAR syncident s1; VAR triggdata t; CONST identno seven:=7; '
    "PERS seamdata sm:=[0,0,0,0]; PERS welddata wd:=[10,0,[0,0,0,0,0,0,0,0,0],[0,0,0,0,0,0,0,0,0]];"
)


def run(body: str, **scenario: object) -> Program:
    """A program whose main begins in line 4."""
    module = f"MODULE m\n{DATA}\nPROC main()\n{body}\nENDPROC\nPROC beside()\nENDPROC\nENDMODULE\n"
    return run_program([TextFile("m.mod", module, "utf-8")], Scenario(**scenario))


def moves(program: Program) -> list[Move]:
    return [one for one in program.motions if isinstance(one, Move)]


@pytest.mark.parametrize(
    "move",
    [
        r"MoveL q\ID:=7,v100,fine,tool0;",
        r"MoveJ q \ID:=seven,v100,z10,tool0;",
        r"MoveC v,q\ID:=3+4,v100,fine,tool0;",
        r"MoveAbsJ j\ID:=7,v100,fine,tool0;",
        r"MoveAbsJ j\ID:=7\NoEOffs,v100,fine,tool0;",
        r"MoveExtJ j\ID:=7,v100,fine;",
        r"MoveLDO q\ID:=7,v100,fine,tool0,do1,1;",
        r'MoveJSync q\ID:=7,v100,fine,tool0,"beside";',
        r"TriggIO t,0\DOp:=do1,1; TriggL q\ID:=7,v100,t,fine,tool0;",
        r"ArcL q\ID:=7,v100,sm,wd,fine,tool0;",
    ],
)
def test_the_number_of_a_move_and_what_the_other_robots_take_for_it(move: str) -> None:
    program = run(f"MoveJ p,v100,fine,tool0;\nSyncMoveOn s1,both;\n{move}\nSyncMoveOff s1;", partner={7: 2.5, 8: 9.0})
    before, together = moves(program)
    assert (before.identity, before.least) == (None, 0.0)
    assert (together.identity, together.partner, together.least) == (7, 2.5, 2.5)
    assert any("8" in str(one) for one in program.warnings), "nothing of the cell file is ignored silently"


def test_who_says_nothing_of_the_other_robots_leaves_the_time_open() -> None:
    (one,) = moves(run("SyncMoveOn s1,both;\nMoveJ p\\ID:=1,v100,fine,tool0;\nSyncMoveOff s1;"))
    assert (one.identity, one.partner, one.least) == (1, None, 0.0)


def test_synchronisation_begins_and_ends_at_stops_for_which_the_other_tasks_are_waited() -> None:
    body = "MoveJ p,v100,z10,tool0;\nSyncMoveOn s1,both\\TimeOut:=5;\nMoveL q\\ID:=1,v100,z10,tool0;\nSyncMoveOff s1;"
    waits = [one for one in run(body, waits={"s1": 0.25}).motions if isinstance(one, Wait)]
    assert [(one.source.line, one.duration, one.stops) for one in waits] == [(5, 0.25, True), (7, 0.25, True)]
    # no other task knows of a move that an export would add behind SyncMoveOn
    assert [one.hold for one in waits] == [None, Hold.SYNCHRONISED]


def test_suspending_and_undoing_stop_and_change_back() -> None:
    body = "SyncMoveOn s1,both;\nSyncMoveSuspend;\nMoveL q,v100,z10,tool0;\nSyncMoveResume;\n"
    body += "MoveL p\\ID:=1,v100,z10,tool0;\nSyncMoveUndo;\nSyncMoveUndo;\nMoveL q,v100,fine,tool0;"
    program = run(body)
    assert [one.identity for one in moves(program)] == [None, 1, None]
    assert [one.source.line for one in program.motions if isinstance(one, Wait) and one.stops] == [4, 5, 7, 9]
    assert program.ignored == {"SyncMoveUndo": 1}


def test_a_program_asks_whether_it_is_synchronised() -> None:
    body = "IF IsSyncMoveOn() Stop;\nSyncMoveOn s1,both;\nIF IsSyncMoveOn() MoveJ p\\ID:=4,v100,fine,tool0;\n"
    program = run(f"{body}SyncMoveOff s1;\nIF NOT IsSyncMoveOn() MoveJ q,v100,fine,tool0;")
    assert [one.identity for one in moves(program)] == [4, None]


@pytest.mark.parametrize(("option", "line"), [("", 4), (r"\TimeOut:=2", None)])
def test_other_tasks_that_never_come(option: str, line: int | None) -> None:
    body = f"SyncMoveOn s1,both{option};\nERROR\nIF ERRNO=ERR_SYNCMOVEON MoveJ p,v100,fine,tool0;\nTRYNEXT;"
    if line is None:
        program = run(body, waits={"s1": None})
        assert [type(one).__name__ for one in program.motions] == ["Wait", "MoveJ"]
        assert program.motions[0].duration == 2.0
    else:
        with pytest.raises(InputError) as raised:
            run(body, waits={"s1": None})
        assert raised.value.line == line


def test_the_cell_file_names_the_other_robots_times_by_number() -> None:
    text = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\npartner: {10: 4.0, 20: 500 ms}\n"
    assert parse_cell(text, "cell.yaml").scenario.partner == {10: 4.0, 20: 0.5}


@pytest.mark.parametrize("bad", ["{ten: 4.0}", "{10: -1}", "{10: 1e9}", "{-1: 2}", "{010: 2}", "{10: timeout}"])
def test_no_number_or_no_time_of_other_robots(bad: str) -> None:
    text = f"robot: irb140\nstart: {{joints: [0, 0, 0, 0, 0.5, 0]}}\npartner: {bad}\n"
    with pytest.raises(InputError) as raised:
        parse_cell(text, "cell.yaml")
    assert raised.value.line == 3
