"""How programs go on: jumps, calls, errors and their handlers, loops without an end, and what ran exactly once."""

from __future__ import annotations

import gc
import sys

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Program, TextFile, Wait
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind


def run(body: str, data: str = "", rest: str = "", scenario: Scenario | None = None) -> Program:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], scenario)


def trace(body: str, data: str = "", rest: str = "", scenario: Scenario | None = None) -> list[float]:
    """Values shown by a program as `WaitTime value;`, in order."""
    return [m.duration for m in run(body, data, rest, scenario).motions if isinstance(m, Wait)]


def error(body: str, data: str = "", rest: str = "", scenario: Scenario | None = None) -> str:
    with pytest.raises(InputError) as caught:
        run(body, data, rest, scenario)
    return str(caught.value)


# ------------------------------------------------------------------------------------------------------------- GOTO


@pytest.mark.parametrize(
    ("body", "values"),
    [
        ("GOTO on; WaitTime 1; on: WaitTime 2;", [2]),
        ("GOTO On; WaitTime 1; oN: WaitTime 2;", [2]),
        ("n:=0; again: Incr n; WaitTime n; IF n<3 GOTO again; WaitTime 9;", [1, 2, 3, 9]),
        ("FOR i FROM 1 TO 5 DO WaitTime i; IF i=2 GOTO out; ENDFOR out: WaitTime 9;", [1, 2, 9]),
        ("IF TRUE THEN WHILE n<9 DO Incr n; IF n=4 GOTO out; ENDWHILE ENDIF out: WaitTime n;", [4]),
        ("FOR i FROM 1 TO 2 DO IF i=1 GOTO next; WaitTime i; next: ENDFOR", [2]),
        ("TEST 1 CASE 1: GOTO inner; WaitTime 1; inner: WaitTime 2; ENDTEST", [2]),
    ],
)
def test_goto_reaches_labels_of_its_own_and_of_outer_blocks(body: str, values: list[float]) -> None:
    assert trace(body, "VAR num n;") == values


def test_goto_out_of_a_loop_gives_the_hidden_data_back() -> None:
    assert trace("VAR num i:=7; FOR i FROM 1 TO 5 DO GOTO out; ENDFOR out: WaitTime i;") == [7]


# ---------------------------------------------------------------------------------------------------------- handlers


@pytest.mark.parametrize(
    ("body", "values"),
    [
        ("d:=0; WaitTime 1/d; WaitTime 2; ERROR WaitTime 3; d:=4; RETRY;", [3, 0.25, 2]),
        ("WaitTime 1/d; WaitTime 2; ERROR WaitTime 3; TRYNEXT;", [3, 2]),
        ("WaitTime 1/d; WaitTime 2; ERROR WaitTime 3; RETURN;", [3]),
        ("FOR i FROM 0 TO 2 DO WaitTime 2/i; ENDFOR WaitTime 5; ERROR TRYNEXT;", [2, 1, 5]),
        (
            "FOR i FROM 0 TO 2 DO WaitTime 2/i; ENDFOR ERROR IF ERRNO=ERR_DIVZERO THEN WaitTime 8; TRYNEXT; ENDIF",
            [8, 2, 1],
        ),
        ("WaitTime a{3}; ERROR (ERR_DIVZERO) WaitTime 1; TRYNEXT; ERROR (ERR_STRTOOLNG,ERR_OUTOFBND) TRYNEXT;", []),
        ('s:=s+s; WaitTime 1; ERROR (ERR_STRTOOLNG) s:=""; RETRY;', [1]),
        ("RAISE 14; WaitTime 2; ERROR WaitTime ERRNO; TRYNEXT;", [14, 2]),
        ("BookErrNo ERR_MY; RAISE ERR_MY; ERROR IF ERRNO=ERR_MY WaitTime 6; TRYNEXT;", [6]),
        (
            'BookErrNo ERR_MY; ErrRaise "ERR_MY",7055,"T","C","","",""; WaitTime 1; '
            "ERROR IF ERRNO=ERR_MY WaitTime 7; TRYNEXT;",
            [7, 1],
        ),
    ],
)
def test_a_handler_goes_on_where_the_program_says(body: str, values: list[float]) -> None:
    data = 'VAR num d; VAR num a{2}; VAR errnum ERR_MY:=-1; VAR string s:="' + 50 * "x" + '";'
    assert trace(body, data) == values


def test_what_a_handler_does_not_take_goes_to_the_caller_who_repeats_the_call() -> None:
    rest = "PROC go()\nWaitTime 1;\nWaitTime 6/d;\nERROR (ERR_OUTOFBND)\nTRYNEXT;\nENDPROC"
    assert trace("go; WaitTime 9; ERROR d:=2; RETRY;", "VAR num d;", rest) == [1, 1, 3, 9]
    assert trace("go; WaitTime 9; ERROR TRYNEXT;", "VAR num d;", rest) == [1, 9]


def test_raise_passes_on_and_the_end_of_a_handler_does_too() -> None:
    rest = "PROC go()\nWaitTime 1/0;\nERROR\nWaitTime 1;\n{}\nENDPROC"
    for tail, values in (("RAISE;", [1, 2]), ("", [1, 2]), ("RAISE ERR_OUTOFBND;", [1, 3])):
        body = "go; ERROR (ERR_DIVZERO) WaitTime 2; TRYNEXT; ERROR (ERR_OUTOFBND) WaitTime 3; TRYNEXT;"
        assert trace(body, rest=rest.format(tail)) == values


def test_a_handler_runs_once_for_an_error_deep_inside_its_routine() -> None:
    rest = "PROC go()\nFOR i FROM 1 TO 2 DO\nIF TRUE WaitTime 1/0;\nENDFOR\nERROR\nWaitTime 1;\nRAISE;\nENDPROC"
    assert trace("go; ERROR TRYNEXT;", rest=rest) == [1]


def test_an_error_in_a_handler_stops_the_program_whatever_handlers_the_callers_have() -> None:
    """RAPID reference manual, error recovery: such errors are always propagated to the system error handler."""
    rest = "PROC go()\nWaitTime 1/0;\nERROR\n{}\nTRYNEXT;\nENDPROC\nPROC inner()\n{}\nENDPROC"
    for inside, inner in (("WaitTime a{9};", ""), ("inner;", "WaitTime a{9};"), ("RAISE -1;", "")):
        text = error("go; ERROR WaitTime 7; TRYNEXT;", "VAR num a{2};", rest.format(inside, inner))
        assert text.startswith(f"m.mod:{13 if inner else 9}:"), text
    handled = "WaitTime a{9};\nERROR\nWaitTime 3;\nTRYNEXT;"
    assert trace("go; ERROR WaitTime 7;", "VAR num a{2};", rest.format("inner;", handled)) == [3]


CHAIN = (  # main calls one, one calls two, two fails
    "PROC one()\ntwo;\nWaitTime 10;\n{}\nENDPROC\nPROC two()\n{}\nWaitTime 20;\n{}\nENDPROC"
)


ERR_RAISE = 'ErrRaise "own",7055,ERRSTR_TASK,ERRSTR_CONTEXT,ERRSTR_UNUSED,ERRSTR_UNUSED,ERRSTR_UNUSED;'


@pytest.mark.parametrize(
    ("main", "one", "fails", "two", "values"),
    [
        # RAISE in a handler goes to the handler that lists the number, past those that do not.
        ("ERROR (55) WaitTime ERRNO; TRYNEXT;", "ERROR\nWaitTime 1;\nTRYNEXT;", "RAISE 55;", "ERROR\nRAISE;", [55, 9]),
        ("ERROR (56) WaitTime ERRNO; TRYNEXT;", "ERROR\nTRYNEXT;", "RAISE 55;", "ERROR (55)\nRAISE 56;", [56, 9]),
        ("ERROR (own) WaitTime 5; TRYNEXT;", "ERROR\nTRYNEXT;", "RAISE own;", "ERROR\nIF ERRNO=own RAISE;", [5, 9]),
        ("ERROR (own) WaitTime 5; TRYNEXT;", "ERROR (1)\nTRYNEXT;", "RAISE 1;", "ERROR\nRAISE own;", [5, 9]),
        ("ERROR (LONG_JMP_ALL_ERR) WaitTime 5; TRYNEXT;", "ERROR\nTRYNEXT;", "x:=1/0;", "ERROR\nRAISE;", [5, 9]),
        ("ERROR (55) x:=1; RETRY;", "ERROR\nTRYNEXT;", "IF x=0 RAISE 55;", "ERROR\nRAISE;", [20, 10, 9]),
        # The nearest that lists it; where none does, the caller's handler.
        ("ERROR (55) WaitTime 5;", "ERROR (55)\nWaitTime 1;\nTRYNEXT;", "RAISE 55;", "ERROR\nRAISE;", [1, 10, 9]),
        ("ERROR (7) WaitTime 5;", "ERROR\nWaitTime 1;\nTRYNEXT;", "RAISE 55;", "ERROR\nRAISE;", [1, 10, 9]),
        ("ERROR (own) WaitTime 5;", "ERROR (own)\nTRYNEXT;", "RAISE 1;", f"ERROR\n{ERR_RAISE}", [10, 9]),
        # Without a handler of its own an error goes up call by call.
        ("ERROR (55) WaitTime 5;", "ERROR\nWaitTime 1;\nTRYNEXT;", "RAISE 55;", "", [1, 10, 9]),
        ("ERROR (own) WaitTime 5; RETURN;", "", "RAISE own;", "", [5]),
        ("ERROR TEST ERRNO CASE 1: WaitTime 1; CASE own: WaitTime 2; ENDTEST TRYNEXT;", "", "RAISE own;", "", [2, 9]),
        # StartMoveRetry is StartMove and RETRY; the robot rests at StopMove.
        ("ERROR StopMove; x:=4; StartMoveRetry;", "", "WaitTime 4/x;", "", [0, 1, 20, 10, 9]),
        # The handler that lists the number goes before one without a list.
        ("ERROR WaitTime 1; TRYNEXT; ERROR (55) SkipWarn; WaitTime 2; TRYNEXT;", "", "RAISE 55;", "", [2, 9]),
    ],
)
def test_an_error_finds_its_handler_up_the_calls(
    main: str, one: str, fails: str, two: str, values: list[float]
) -> None:
    """RAPID overview, error recovery and error recovery with long jump."""
    body = f"BookErrNo own; one; WaitTime 9; {main}"
    assert trace(body, "VAR errnum own:=-1; VAR num x;", CHAIN.format(one, fails, two)) == values


def test_a_long_jump_says_whose_undo_handler_it_leaves_out() -> None:
    one = "UNDO\nWaitTime 3;"
    warnings = run("one; ERROR (55) RETURN;", rest=CHAIN.format(one, "RAISE 55;", "ERROR\nRAISE;")).warnings
    assert [str(w.place) for w in warnings if w.kind is WarningKind.ASSUMED] == ["m.mod:9:1"]


def test_every_booked_error_has_a_number_of_its_own_that_no_program_raises_as_it_is() -> None:
    data = "VAR errnum a:=-1; VAR errnum b:=-1;"
    assert trace("BookErrNo a; BookErrNo b; IF a=b OR a<91 OR b<91 WaitTime 1;", data) == []
    assert trace("BookErrNo a; RAISE 1; ERROR (a) WaitTime 1; TRYNEXT; ERROR WaitTime 2; TRYNEXT;", data) == [2]


def test_a_handler_of_a_function_gives_its_value() -> None:
    rest = "FUNC num safe(num x)\nRETURN 1/x;\nERROR\nRETURN 5;\nENDFUNC"
    assert trace("WaitTime safe(2)+safe(0);", rest=rest) == [5.5]


def test_a_raise_out_of_a_loop_gives_the_hidden_data_back() -> None:
    rest = "PROC go()\nVAR num i:=7;\nFOR i FROM 1 TO 2 DO\nRAISE 5;\nENDFOR\nERROR\nWaitTime i;\nRETURN;\nENDPROC"
    assert trace("VAR num i:=4; FOR i FROM 8 TO 8 DO go; ENDFOR WaitTime i;", rest=rest) == [1, 4]


def test_five_failures_in_five_passes_are_no_failure_in_a_row() -> None:
    body = "FOR i FROM 1 TO 9 DO d:=0; WaitTime i/d; ENDFOR ERROR d:=1; RETRY;"
    assert trace(body, "VAR num d;") == list(range(1, 10))


def test_undo_does_not_run_and_that_is_said() -> None:
    program = run("go;", rest="PROC go()\nWaitTime 1;\nUNDO\nWaitTime 2;\nENDPROC")
    assert len(program.motions) == 1
    assert [(str(w.place), w.kind) for w in program.warnings] == [("m.mod:8:1", WarningKind.NO_EFFECT)]


# ------------------------------------------------------------------------------------------------------------- calls


def test_late_binding_calls_by_the_value_of_an_expression() -> None:
    rest = "PROC go1(num x)\nWaitTime x;\nENDPROC\nPROC go2()\nWaitTime 20;\nENDPROC"
    assert trace('%"go"+ValToStr(1)% 3; CallByVar "go",2; %"m:go1"% 4;', rest=rest) == [3, 20, 4]


# Two stations, each with a LOCAL routine of the same name, and a global one in the second.
STATIONS = {
    "a.mod": "MODULE A\nLOCAL PROC Pick()\nWaitTime 1;\nENDPROC\nPROC main()\n{}\nENDPROC\nENDMODULE\n",
    "b.mod": (
        "MODULE B\nLOCAL PROC pick()\nWaitTime 2;\nENDPROC\nLOCAL PROC main()\npick;\nENDPROC\n"
        'LOCAL PROC pick1(num x)\nWaitTime x;\nENDPROC\nPROC place()\n%"Pick"%;\nENDPROC\nENDMODULE\n'
    ),
}
P0 = "[[500,0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"


@pytest.mark.parametrize(
    ("body", "values"),
    [
        ('%"Pick"%; %"A:Pick"%; %"B:Pick"%; %"b:PICK"%;', [1, 1, 2, 2]),
        ('%"B:main"%; place; %"place"%; %"B:place"%;', [2, 2, 2, 2]),  # inside B its own Pick is meant
        ('%"B:pick"+ValToStr(1)% 7; %"B:pick1"% x:=8;', [7, 8]),
        (f'MoveLSync {P0},v100,z10,tool0,"B:pick"; MoveCSync {P0},{P0},v100,fine,tool0,ProcName:="pick";', [2, 1]),
        ('%"A:place"%; ERROR (ERR_REFUNKPRC) WaitTime 9; TRYNEXT;', [9]),  # global, but of another module
        ('CallByVar "B:pick",1; ERROR (ERR_CALLPROC) WaitTime 9; TRYNEXT;', [9]),
    ],
)
def test_late_binding_with_a_modules_name_runs_that_modules_routine(body: str, values: list[float]) -> None:
    body = body.replace(f"{P0},{P0}", f"{P0.replace('500,0', '550,50')},{P0.replace('500,0', '600,0')}")
    files = [TextFile(name, text.replace("{}", body), "utf-8") for name, text in STATIONS.items()]
    assert [m.duration for m in run_program(files).motions if isinstance(m, Wait)] == values


FILE = "; give the file that declares it"


@pytest.mark.parametrize(
    ("body", "handler", "message"),
    [
        ('%"go3"%;', "ERR_REFUNKPRC", f"there is no procedure 'go3' in the program{FILE}"),
        ('CallByVar "go",3;', "ERR_REFUNKPRC", f"there is no procedure 'go3' in the program{FILE}"),
        ('%"m:go3"%;', "ERR_REFUNKPRC", f"there is no procedure 'go3' in module m{FILE}"),
        ('%"k:go1"%;', "ERR_REFUNKPRC", f"there is no procedure 'go1' in the program: no module k{FILE}"),
        ('CallByVar "k:go",1;', "ERR_REFUNKPRC", f"there is no procedure 'go1' in the program: no module k{FILE}"),
        ('%"m:MoveL"%;', "ERR_REFUNKPRC", f"there is no procedure 'MoveL' in module m{FILE}"),
        ('%"go1"% 1;', "ERR_CALLPROC", "go1 takes 0 argument(s), found 1"),
        ('%"f"%;', "ERR_CALLPROC", "f is a FUNC; only a PROC is called by its name"),
        ("WaitTime f(1);", "ERR_FNCNORET", "FUNC f ended without RETURN"),
        ("opt;", "ERR_NOTPRES", "optional parameter 'x' was not given; ask Present(x) before"),
        ("n:=1E30*1E30;", "ERR_NUM_LIMIT", "the result of '*' is too large for a num"),
    ],
)
def test_errors_that_a_program_may_handle_have_their_names(body: str, handler: str, message: str) -> None:
    rest = "PROC go1()\nENDPROC\nFUNC num f(num x)\nENDFUNC\nPROC opt(\\num x)\nWaitTime x;\nENDPROC"
    assert trace(f"{body} ERROR ({handler}) WaitTime 1; TRYNEXT;", "VAR num n;", rest) == [1]
    assert error(body, "VAR num n;", rest).endswith(f": {message}")


def test_alternatives_exclude_each_other() -> None:
    rest = "PROC go(\\num a | num b | switch c, num d)\nIF Present(a) WaitTime a; IF Present(b) WaitTime b;\nENDPROC"
    assert trace("go\\a:=1,0; go\\b:=2,0; go\\c,0;", rest=rest) == [1, 2]
    assert error("go\\a:=1\\c,0;", rest=rest) == "m.mod:4:1: go takes only one of \\a and \\c"


def test_parameters_by_reference_reach_into_arrays_and_records() -> None:
    rest = """PROC deep(INOUT num x, VAR num y, PERS num z, INOUT num open{*,*})
        x:=x+1; y:=y+2; z:=z+3; open{2,1}:=9;
    ENDPROC"""
    data = "VAR num a{2,2}:=[[1,2],[3,4]]; VAR pos p:=[5,6,7]; PERS num q:=8; VAR num b{2,1}:=[[0],[0]];"
    assert trace("deep a{2,1}, p.y, q, b; WaitTime a{2,1}; WaitTime p.y; WaitTime q; WaitTime b{2,1};", data, rest) == [
        4, 8, 11, 9,
    ]  # fmt: skip


def test_recursion_goes_two_hundred_deep_inside_expressions() -> None:
    loop = "FOR i FROM 1 TO 1 DO RETURN Abs(n+(0+(0+sum(n-1)))); ENDFOR"
    rest = f"FUNC num sum(num n)\nIF n=0 THEN RETURN 0; ELSE {loop}\nENDIF\nENDFUNC"
    assert trace("WaitTime sum(200);", rest=rest) == [200 * 201 / 2]
    limit, collecting = sys.getrecursionlimit(), gc.isenabled()
    assert error("WaitTime sum(300);", rest=rest) == "m.mod:7:68: calls are nested deeper than 250 routines at sum"
    assert (sys.getrecursionlimit(), gc.isenabled()) == (limit, collecting)


def test_a_function_that_moves_runs_inside_an_expression() -> None:
    rest = "FUNC num go(num x)\nWaitTime x;\nRETURN 10*x;\nENDFUNC"
    assert trace("WaitTime go(1)+go(2); IF go(3)>0 WaitTime 4;", rest=rest) == [1, 2, 30, 3, 4]


def test_a_routine_of_the_program_goes_before_an_instruction() -> None:
    assert trace("WaitTime 1; SetDO do1,1;", rest="PROC SetDO(signaldo s, num v)\nWaitTime 5;\nENDPROC") == [1, 5]


def test_stops_are_passed_and_said_once() -> None:
    program = run("Stop; Stop\\NoRegain; Break; WaitTime 1;")
    told = [(one.kind, one.place and one.place[1]) for one in program.warnings]
    assert told == [(WarningKind.ASSUMED, 4), (WarningKind.ASSUMED, 4)]
    assert not program.ignored


def test_connect_needs_a_trap_and_interrupts_never_come() -> None:
    trap = "TRAP t\nWaitTime 1;\nENDTRAP"
    program = run("CONNECT i WITH t; CONNECT i WITH t; WaitTime i;", "VAR intnum i;", trap)
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [2]
    assert tuple(map(str, program.warnings)) == ("m.mod:4:1: interrupts are not simulated, so TRAP t does not run",)
    assert error("CONNECT i WITH u;", "VAR intnum i;", trap) == "m.mod:4:1: there is no TRAP u in the program"


# ------------------------------------------------------------------------------------------------------------- loops


@pytest.mark.parametrize(
    ("loop", "values"),
    [
        ("FOR i FROM 1 TO 0 DO WaitTime i; ENDFOR", [1, 0]),
        ("FOR i FROM 3 TO 1 DO WaitTime i; ENDFOR", [3, 2, 1]),
        ("FOR i FROM 1 TO 3 STEP -1 DO WaitTime i; ENDFOR", []),
        ("FOR i FROM 3 TO 1 STEP 1 DO WaitTime i; ENDFOR", []),
        ("FOR i FROM 1 TO n DO n:=0; WaitTime i; ENDFOR", [1, 2]),
        ("FOR n FROM 5 TO 5 DO WaitTime n; ENDFOR WaitTime n;", [5, 2]),
        ("FOR i FROM 1 TO 2 DO FOR i FROM 8 TO 9 DO ENDFOR WaitTime i; ENDFOR", [1, 2]),
    ],
)
def test_for(loop: str, values: list[float]) -> None:
    assert trace(loop, "VAR num n:=2;") == values


@pytest.mark.parametrize(
    ("first", "last", "step"), [(0, 1, 0.1), (0, 0.3, 0.1), (1, 0, -0.1), (0, 2, 0.4), (0.5, 3, 1)]
)
def test_a_loop_of_decimals_adds_32_bit_floats_and_is_told(first: float, last: float, step: float) -> None:
    """RAPID reference manual, FOR: undefined whether or not the last loop is running."""
    value, count = np.float32(first), 0
    while value <= np.float32(last) if step > 0 else value >= np.float32(last):
        value, count = value + np.float32(step), count + 1
    program = run(f"n:=1;\nFOR i FROM {first} TO {last} STEP {step} DO\nIncr n;\nENDFOR\nWaitTime n;", "VAR num n;")
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [count + 1]
    assert [str(warning.place) for warning in program.warnings] == ["m.mod:5:1"]
    assert run("FOR i FROM 1 TO 2.5 DO\nENDFOR\nFOR i FROM 6 TO 2 STEP -2 DO\nENDFOR").warnings == ()


@pytest.mark.parametrize(
    ("loop", "name"),
    [
        ("WHILE TRUE DO WaitTime 1; ENDWHILE", "WHILE TRUE"),
        ("WHILE 1=1 DO WaitTime 1; ENDWHILE", "WHILE 1=1"),
        ("WHILE NOT FALSE DO WaitTime 1; ENDWHILE", "WHILE NOT FALSE"),
        ("WHILE forever DO WaitTime 1; ENDWHILE", "WHILE forever"),
        ("a: WaitTime 1; GOTO a;", "GOTO a"),
        ("a: IF go WaitTime 1; GOTO a;", "GOTO a"),
        ("VAR bool on:=TRUE; WHILE on=TRUE DO WaitTime 1; ENDWHILE", "WHILE on=TRUE"),
    ],
)
def test_a_loop_that_cannot_end_runs_as_often_as_the_scenario_says(loop: str, name: str) -> None:
    data = "CONST bool forever:=TRUE; VAR bool go:=TRUE;"
    program = run(f"{loop} WaitTime 9;", data, scenario=Scenario(endless_passes=3))
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [1, 1, 1]
    (warning,) = tuple(map(str, program.warnings))
    assert f"{name} never ends by itself: it moves nothing" in warning


@pytest.mark.parametrize(
    "change",
    ["on:=FALSE;", "swap on;", "FOR i FROM 1 TO 1 DO on:=NOT on; ENDFOR", "WaitTime 1/0; ERROR on:=FALSE; TRYNEXT;"],
)
def test_a_variable_that_its_routine_changes_may_end_a_loop(change: str) -> None:
    inside, _, handler = change.partition(" ERROR ")
    body = f"VAR bool on:=TRUE; WHILE on DO {inside} ENDWHILE WaitTime 9; {'ERROR ' + handler if handler else ''}"
    rest = "PROC swap(INOUT bool x)\nx:=NOT x;\nENDPROC"
    assert trace(body, rest=rest, scenario=Scenario(endless_passes=3)) == [9]


def test_a_variable_of_the_module_may_be_changed_by_anybody() -> None:
    body = "WHILE on DO WaitTime 1; other; ENDWHILE"
    rest = "PROC other()\non:=FALSE;\nENDPROC"
    assert trace(body, "VAR bool on:=TRUE;", rest, Scenario(endless_passes=3)) == [1]


def test_a_routine_that_calls_itself_at_its_end_is_a_loop_without_end() -> None:
    program = run("WaitTime 1; main;", scenario=Scenario(endless_passes=3))
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [1, 1, 1]
    (warning,) = tuple(map(str, program.warnings))
    assert "PROC main, whose last statement calls it again, never ends by itself" in warning


def test_a_routine_that_calls_itself_with_a_way_out_takes_it() -> None:
    rest = "PROC again()\nIncr n;\nWaitTime n;\nIF n=4 RETURN;\nagain;\nENDPROC"
    assert trace("again; WaitTime 9;", "VAR num n;", rest) == [1, 2, 3, 4, 9]


@pytest.mark.parametrize("body", ["WaitTime 1;", "IF TRUE GOTO next; next: WaitTime 1;"])
def test_without_a_number_of_passes_one_is_run(body: str) -> None:
    assert trace(f"WHILE TRUE DO\n{body}\nENDWHILE") == [1]


@pytest.mark.parametrize("way", ["RETURN;", "EXIT;", "GOTO out;", "RAISE 5;", "ExitCycle;"])
def test_a_loop_with_a_way_out_takes_it(way: str) -> None:
    body = f"WHILE TRUE DO WaitTime 1; Incr n; IF n=4 {way} ENDWHILE out: ERROR RETURN;"
    assert trace(body, "VAR num n;") == [1, 1, 1, 1]
    assert trace(body, "VAR num n;", scenario=Scenario(endless_passes=2)) == [1, 1]


def test_a_search_in_an_endless_loop_is_no_pass_of_the_program() -> None:
    rest = "FUNC num find(num x)\nVAR num i;\nWHILE TRUE DO\nIncr i;\nIF i=x RETURN i;\nENDWHILE\nENDFUNC"
    assert trace("WaitTime find(50);", rest=rest, scenario=Scenario(endless_passes=1)) == [50]


@pytest.mark.parametrize(
    ("body", "scenario", "message"),
    [
        ("WHILE n<1 DO ENDWHILE", Scenario(pass_limit=9), "4:1: the loop has not ended after 9 passes (pass_limit)"),
        ("x: IF n<1 GOTO x;", Scenario(pass_limit=9), "4:11: the loop has not ended after 9 passes (pass_limit)"),
        ("FOR i FROM 1 TO 10 DO ENDFOR", Scenario(pass_limit=9), "4:1: the loop has not ended after 9 passes"),
        ("FOR i FROM 1 TO 9 DO FOR j FROM 1 TO 9 DO n:=1; ENDFOR ENDFOR", Scenario(statement_limit=50),
         "4:43: the program has not ended after 50 statements (statement_limit)"),
        ("WHILE TRUE DO IF n=1 RETURN; ENDWHILE", Scenario(pass_limit=9), "4:1: the loop has not ended after 9 passes"),
    ],
)  # fmt: skip
def test_budgets_end_what_does_not_end(body: str, scenario: Scenario, message: str) -> None:
    assert error(body, "VAR num n;", scenario=scenario).startswith(f"m.mod:{message}")


def test_motions_have_a_limit_of_their_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("trajopt_cli.rapid.execution.context.MOTION_LIMIT", 3)
    assert len(trace("FOR i FROM 1 TO 3 DO WaitTime i; ENDFOR")) == 3
    message = "m.mod:4:22: the program makes more than 3 motions; if a loop around this one goes on and on, "
    assert error("FOR i FROM 1 TO 9 DO WaitTime i; ENDFOR").startswith(message)


def test_a_large_array_counts_by_its_size() -> None:
    body = "FOR i FROM 1 TO 100 DO a{i}:=i; ENDFOR"
    assert "statement_limit" in error(body, "VAR num a{100000};", scenario=Scenario(statement_limit=10_000))
    assert trace(body, "VAR num a{100};", scenario=Scenario(statement_limit=10_000)) == []


# ----------------------------------------------------------------------------------------------- counters of loops


GO = "PROC go()\nWaitTime 1;\nENDPROC"


@pytest.mark.parametrize(
    ("body", "rest", "counters"),
    [
        ("WaitTime 1;", "", [()]),
        ("FOR i FROM 1 TO 2 DO WaitTime i; ENDFOR WaitTime 1;", "", [(1,), (2,), ()]),
        ("FOR i FROM 1 TO 2 DO FOR j FROM 3 TO 2 DO WaitTime 1; ENDFOR ENDFOR", "", [(1, 3), (1, 2), (2, 3), (2, 2)]),
        ("FOR i FROM 1 TO 2 DO go; ENDFOR", GO, [(), ()]),  # another routine's
        ("FOR i FROM 1 TO 2 DO WaitTime 1/(2-i); ENDFOR ERROR WaitTime 5; TRYNEXT;", "", [(1,), (2,)]),
        ("FOR i FROM 1 TO 2 DO GOTO out; ENDFOR out: WaitTime 1;", "", [()]),
    ],
)
def test_a_motion_knows_the_counters_of_the_loops_around_it(
    body: str, rest: str, counters: list[tuple[float, ...]]
) -> None:
    assert [motion.written.counters for motion in run(body, "", rest).motions] == counters


P = "[[500,200,450],[0,0,1,0],[0,0,0,0],[{},{},9E9,9E9,9E9,9E9]]"


@pytest.mark.parametrize(
    ("line", "least"),
    [
        ("MoveL {}\\T:=0.5,fine,tool0;", 0.2),  # the rail goes on in the wait
        ("MoveL {}\\T:=0.9,fine,tool0;", 0.0),
        ("MoveL {},fine,tool0;", 0.7),
        ("MoveL Offs({},0,0,1),v100\\T:=0.5,fine,tool0;", 0.7),
        ("MoveL {}\\T:=0.5,fine,tool0; Set do1;", 0.7),
    ],
)
def test_a_wait_is_not_counted_again_behind_a_line_that_stands_in_its_place(line: str, least: float) -> None:
    there = P.format(300, 0)
    text = line.format(there) if "Offs" in line else line.format(f"{there},v100")
    body = f"MoveJ {P.format(200, 0)},v100,fine,tool0; {text} WaitDI di1,1;"
    wait = run(body, scenario=Scenario(waits={"di1": 0.7})).motions[-1]
    assert isinstance(wait, Wait)
    assert wait.duration == pytest.approx(least)
    both = run(body.replace(there, P.format(300, 5)), scenario=Scenario(waits={"di1": 0.7})).motions[-1]
    assert isinstance(both, Wait)
    assert both.duration == 0.7  # another axis turns, too
