"""What a target depends on, by hand: assignments, calls, conditions, and what of the scenario they hang on."""

from __future__ import annotations

import pytest

from trajopt_cli.motion import Move, TextFile
from trajopt_cli.problem.program_text import ProgramText
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

WORLD = Scenario(signals={"di1": 1.0}, answers={"n": 2.0}, endless_passes=1)
ASK = 'TPReadNum n,"?";'
MOVE = "MoveJ Offs(p,0,0,h),v100,fine,tool0;"


def text_of(body: str, rest: str = "") -> ProgramText:
    text = (
        "MODULE m\n    CONST robtarget p:=[[500,200,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        "    CONST robtarget q{2}:=[[[500,0,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],"
        "[[500,9,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];\n"
        f"    VAR num n;\n    VAR num h;\n    VAR num k;\n    PROC main()\n{body}\n    ENDPROC\n{rest}ENDMODULE\n"
    )
    return ProgramText(run_program([TextFile("m.mod", text, "utf-8")], WORLD), WORLD)


def labels(body: str, rest: str = "") -> set[str]:
    text = text_of(body, rest)
    move = next(one for one in reversed(text.program.motions) if isinstance(one, Move))
    return text.trace(move).labels


@pytest.mark.parametrize(
    ("body", "hangs_on"),
    [
        (f"{ASK} h:=3; {MOVE}", set()),
        (f"{ASK} h:=n; {MOVE}", {"answer n"}),
        (f"{ASK} k:=n; h:=k*2; {MOVE}", {"answer n"}),
        (f"IF di1=1 THEN h:=5; ENDIF {MOVE}", {"signal di1"}),  # which value it has
        (f"IF di1=1 THEN h:=5; {MOVE} ENDIF", set()),  # only whether it moves
        (f"{MOVE} {ASK} h:=n;", set()),  # asked too late
        (f"FOR i FROM 1 TO 2 DO {MOVE} {ASK} h:=n; ENDFOR", {"answer n"}),  # not for the second pass
        (f"WHILE TRUE DO h:=h+1; {MOVE} ENDWHILE", {"endless_passes"}),
        (f"WHILE TRUE DO h:=5; {MOVE} ENDWHILE", set()),  # the same in every pass
        (f"WHILE TRUE DO {MOVE} h:=5; ENDWHILE", {"endless_passes"}),
    ],
)
def test_what_a_target_hangs_on(body: str, hangs_on: set[str]) -> None:
    assert labels(body) == hangs_on


def test_values_flow_through_calls_and_not_from_routines_that_never_run() -> None:
    go = f"    PROC go(num h)\n        {MOVE}\n    ENDPROC\n"
    assert labels(f"{ASK} go n;", go) == {"answer n"}
    assert labels(f"{ASK} go 3;", go) == set()
    fill = "    PROC fill(INOUT num x)\n        x:=n;\n    ENDPROC\n"
    assert labels(f"{ASK} fill h; {MOVE}", fill) == {"answer n"}
    assert labels(f"{ASK} {MOVE}", fill.replace("x:=n", "h:=n")) == set()
    up = "    FUNC robtarget up()\n        RETURN Offs(p,0,0,n);\n    ENDFUNC\n"
    assert labels(f"{ASK} MoveJ up(),v100,fine,tool0;", up) == {"answer n"}


def test_a_statement_knows_its_target_its_runs_and_its_loops() -> None:
    text = text_of("FOR i FROM 1 TO 2 DO MoveJ q{i},v100,fine,tool0; ENDFOR MoveJ Offs(q{2},0,0,9),v100,fine,tool0;")
    loop, single = text.statements.values()
    assert (loop.target, loop.runs, loop.variable, len(loop.loops)) == ("q{i}", (0, 1), "i", 1)
    assert len(set(loop.literals)) == 2
    assert (single.runs, single.literals, single.variable, single.loops) == ((2,), (None,), None, ())
    moves = [one for one in text.program.motions if isinstance(one, Move)]
    first, second = (text.literal_data(one) for one in moves[:2])
    assert first is not None
    assert second is not None
    reads = text.trace(moves[2])
    assert (reads.reads(*first), reads.reads(*second)) == (False, True)
