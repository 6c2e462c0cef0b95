"""Loops that never end: which of their motions are the cycle, and what ran before it."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Motion, Move, Program, SignalEvent, TextFile, Wait
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind

DATA = "VAR num n; VAR num a{4}:=[10,20,30,40];\n" + "".join(
    f"CONST robtarget p{i}:=[[{500 + 10 * i},0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n" for i in range(5)
)


def run(body: str, rest: str = "", passes: int | None = None, **scenario: object) -> Program:
    """Moves are written `to 1 fine;`."""
    text = "\n".join((body, rest))
    for i in range(5):
        for zone in ("fine", "z10"):
            text = text.replace(f"to {i} {zone};", f"MoveL p{i},v100,{zone},tool0;")
    main, _, routines = text.partition("\nPROC")
    routines = f"PROC{routines}" if routines else ""
    text = f"MODULE m\n{DATA}PROC main()\n{main}\nENDPROC\n{routines}\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], Scenario(endless_passes=passes, **scenario))


def told(motions: tuple[Motion, ...] | None) -> str:
    """The targets in order, W for waits, S for signals."""
    names = {Wait: "W", SignalEvent: "S"}
    return "".join(
        str(round((one.X_WT[0, 3] - 0.5) * 100)) if isinstance(one, Move) else names[type(one)] for one in motions or ()
    )


def warning(program: Program) -> str:
    return "".join(str(one) for one in program.warnings if one.kind is WarningKind.ENDLESS)


@pytest.mark.parametrize(
    ("body", "rest", "before", "cycle"),
    [
        ("to 0 fine; WHILE TRUE DO to 1 fine; to 2 fine; ENDWHILE", "", "012", "12"),
        ("WHILE TRUE DO WaitTime 1; to 1 z10; to 2 fine; Set do1; ENDWHILE", "", "W12S", "W12S"),
        # the last point is passed: behind the last stop; a wait makes a stop
        ("WHILE TRUE DO to 1 z10; to 2 fine; Set do1; to 3 z10; ENDWHILE", "", "12S", "312S"),
        ("WHILE TRUE DO to 1 z10; to 2 z10; WaitTime 1; to 3 z10; ENDWHILE", "", "12W", "312W"),
        ("WHILE TRUE DO WaitTime 1; to 1 z10; to 3 z10; ENDWHILE", "", "W13", "W13"),
        # only the first pass begins elsewhere
        ("n:=1; WHILE TRUE DO IF n=1 THEN to 0 fine; ENDIF n:=2; to 1 fine; to 2 fine; ENDWHILE", "", "012", "12"),
        # a loop that nothing breaks while the signal is 0, in a routine of a routine
        ("Setup; Work;", "PROC Setup()\nto 0 fine;\nENDPROC\nPROC Work()\nWHILE TRUE DO\nPick;\nIF di1=1 THEN\n"
         "to 0 fine; Stop;\nENDIF\nENDWHILE\nENDPROC\nPROC Pick()\nto 1 fine; to 2 fine;\nENDPROC", "012", "12"),
        ("WHILE TRUE DO to 1 fine; to 2 fine; IF di1=1 THEN to 0 fine; EXIT; ENDIF ENDWHILE", "", "12", "12"),
        ("WHILE TRUE DO to 1 fine; to 2 fine; IF di1=1 RETURN; ENDWHILE", "", "12", "12"),
        ("to 0 fine; again: to 1 fine; to 2 fine; GOTO again;", "", "012", "12"),
        ("to 1 fine; to 2 fine; main;", "", "12", "12"),
        # while a signal says so that stays as it is
        ("WHILE di0=0 DO to 1 fine; to 2 fine; ENDWHILE", "", "12", "12"),
        ("again: to 1 fine; to 2 fine; IF di0=0 GOTO again; to 3 fine;", "", "12", "12"),
        # no pass ends where it began, but all of them come by one stop
        ("WHILE TRUE DO to 1 fine; MoveL Offs(p2,0,0,n),v100,fine,tool0; n:=n+1; ENDWHILE", "", "1", "21"),
    ],
)  # fmt: skip
def test_the_cycle_is_a_pass_that_ends_where_it_begins(body: str, rest: str, before: str, cycle: str) -> None:
    program = run(body, rest, signals={"di0": 0.0, "di1": 0.0})
    assert (told(program.before), told(program.motions), program.passes) == (before, cycle, 1)
    assert "never ends by itself: one pass in steady state is planned" in warning(program)


ROWS = "WHILE TRUE DO MoveL Offs(p1,0,100*n,0),v100,fine,tool0; to 2 fine; n:=(n+1) MOD 3; ENDWHILE"


@pytest.mark.parametrize(
    ("passes", "rows", "said"), [(None, [1], True), (2, [1, 2], True), (3, [1, 2, 0], False), (6, [1, 2, 0] * 2, False)]
)
def test_passes_that_differ_are_told_with_the_number_that_covers_them(
    passes: int | None, rows: list[int], said: bool
) -> None:
    program = run(ROWS, passes=passes)
    moves = [one for one in program.motions if isinstance(one, Move)]
    assert [round(one.X_WT[1, 3] * 10) for one in moves[::2]] == rows
    assert program.passes == len(rows)
    assert told(program.beyond) == {1: "1212", 2: "12"}.get(len(rows), "")
    assert ("repeat after 3: 'endless_passes: 3' covers all of them" in warning(program)) == said


def test_as_many_passes_as_it_takes_to_come_back() -> None:
    """To the left, to the right: two passes."""
    body = "WHILE TRUE DO to 1 z10; IF n=0 THEN to 2 fine; ELSE to 3 fine; ENDIF n:=1-n; ENDWHILE"
    program = run(body)
    assert (told(program.before), told(program.motions), program.passes) == ("12", "1312", 2)
    assert "repeat" not in warning(program)
    alone = run(body, passes=1)
    assert (alone.before, told(alone.motions), alone.passes) == (None, "12", 1)
    assert "without a way back" in warning(alone)


def test_a_loop_that_never_comes_by_a_place_again_is_planned_from_the_start() -> None:
    program = run("to 0 fine; WHILE TRUE DO MoveL Offs(p1,0,0,n),v100,fine,tool0; n:=n+1; ENDWHILE")
    assert (program.before, told(program.motions), program.passes) == (None, "01", 1)
    assert "without a way back" in warning(program)
    assert "do not repeat within 26" in warning(program)


def test_a_loop_without_a_stop_has_one_at_the_end_of_its_cycle() -> None:
    program = run("to 0 fine; WHILE TRUE DO to 1 z10; to 2 z10; to 3 z10; ENDWHILE")
    assert (told(program.before), told(program.motions)) == ("0123", "123")
    assert "none of its points is a stop" in warning(program)


def test_what_ran_to_see_whether_passes_repeat_leaves_no_trace() -> None:
    """The fourth pass asks for a signal that nobody gives, the fifth reads behind the end of an array."""
    body = 'WHILE TRUE DO n:=n+1; to 1 fine; to 2 fine; TPWrite "x"; IF n=4 AND di9=1 AccSet 200,200;'
    program = run(f"{body} WaitTime 1+0*a{{n}}; ENDWHILE")
    assert told(program.motions) == "12W"
    assert program.ignored == {"TPWrite": 1}
    assert "pass 5 cannot be run: m.mod:" in warning(program)
    with pytest.raises(InputError):  # in a pass of the cycle it counts
        run("WHILE TRUE DO n:=n+3; to 1 fine; WaitTime a{n}; ENDWHILE")


@pytest.mark.parametrize(
    ("body", "moves"),
    [
        ("WHILE TRUE DO n:=n+1; to 1 fine; to 2 fine; IF n=40 RETURN; ENDWHILE", 80),
        ("WHILE di0=0 DO to 1 fine; to 2 fine; ENDWHILE", 4),
        ("again: to 1 fine; to 2 fine; IF di0=0 GOTO again; to 3 fine;", 7),
        ("WHILE n<1200 DO n:=n+1; to 1 fine; to 2 fine; ENDWHILE", 2400),
    ],
)
@pytest.mark.parametrize("passes", [None, 1])
def test_a_loop_that_takes_its_way_out_is_no_cycle(body: str, moves: int, passes: int | None) -> None:
    if passes and "TRUE" in body:
        pytest.skip("the number says when such a loop is over")
    program = run(body, passes=passes, signals={"di0": (0.0, 0.0, 1.0)})
    assert (program.before, len(program.motions), program.passes, warning(program)) == (None, moves, 0, "")


def test_the_cycle_knows_where_it_begins() -> None:
    program = run("to 0 fine; WHILE TRUE DO to 1 fine; to 2 fine; WaitTime 1; ENDWHILE")
    assert program.entrance is program.motions[1]
    assert [told(one.motions) for one in (program, program.from_start)] == ["12W", "012W12W"]
    begins = [one for one in program.before or () if isinstance(one, Move)][-1]
    assert np.array_equal(begins.X_WT, program.motions[1].X_WT)  # type: ignore[union-attr]
    assert run("to 0 fine;").entrance is None
