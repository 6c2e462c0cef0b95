"""Data that the cell file gives: what nothing declares, what somebody outside writes, and what is asked for."""

from __future__ import annotations

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveL, Program, TextFile, Wait
from trajopt_cli.rapid.reader import run_program, try_program
from trajopt_cli.rapid.template import template
from trajopt_cli.scenario import Given, MissingError, Scenario

ARM = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\n"
TARGET = "[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
LOOKED = (
    "is not declared in the program "
    "(looked for in PROC main, MODULE m, the other modules' globals and the predefined data)"
)
NOWHERE = LOOKED.replace("PROC main, ", "")


def text_of(body: str, declared: str = "", rest: str = "") -> list[TextFile]:
    return [TextFile("m.mod", f"MODULE m\n{declared}\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n", "utf-8")]


def of(data: str) -> Scenario:
    return parse_cell(f"{ARM}data: {data}\n", "cell.yaml").scenario


def times(program: Program) -> list[float]:
    """What a program shows by `WaitTime value;`, waits for conditions left out."""
    return [one.duration for one in program.motions if isinstance(one, Wait) and one.condition is None]


def shown(body: str, declared: str = "", data: str = "{}", rest: str = "") -> list[float]:
    return times(run_program(text_of(body, declared, rest), of(data)))


def error(body: str, declared: str = "", data: str = "{}") -> str:
    with pytest.raises(InputError) as caught:
        run_program(text_of(body, declared), of(data))
    return str(caught.value)


# ------------------------------------------------------------------------------------------------- what is asked for


@pytest.mark.parametrize(
    ("body", "declared", "line"),
    [
        ("IF bReady WaitTime 1;", "", "data: {bReady: false}"),
        ("IF NOT bReady WaitTime 1;", "", "data: {bReady: false}"),
        ("IF bReady=TRUE WaitTime 1;", "", "data: {bReady: false}"),
        ("IF TRUE=bReady WaitTime 1;", "", "data: {bReady: false}"),
        ("IF bReady=bOther WaitTime 1;", "VAR bool bOther;", "data: {bReady: false}"),
        ("WaitUntil bReady; IF bReady WaitTime 1;", "", "data: {bReady: true}"),
        ("WaitUntil n<>0; WaitTime n;", "", "signals: {n: 1}"),
        ("WaitUntil n>4 AND n<9; WaitTime n;", "", "signals: {n: 5}"),
        ("WaitUntil n<>0; WaitTime n;", "PERS num n:=0;", "data: {n: 1}"),
        ("WaitUntil n>4; WaitTime n;", "VAR num n:=2;", "data: {n: 5}"),
        ("WaitUntil n=other; WaitTime n;", "VAR num n:=2; VAR num other:=5;", "data: {n: 5}"),
        ('WaitUntil order<>""; IF order="1" WaitTime 1;', 'PERS string order:="";', None),
        ("WaitUntil a{2}<>0; WaitTime a{2};", "PERS num a{2}:=[0,0];", 'data: {a: "[0,1]"}'),
        ("WaitUntil a OR b; IF a WaitTime 1;", "PERS bool a; PERS bool b;", "data: {a: true}"),
        ("FOR i FROM 1 TO 3 DO WaitTime x{i}; ENDFOR", "", 'data: {x: "[0,0,0]"}'),
        ("WaitTime x{1,2}; WaitTime x{2,1};", "", 'data: {x: "[[0,0],[0,0]]"}'),
        ("IF flags{2} WaitTime 1;", "", 'data: {flags: "[FALSE,FALSE]"}'),
        ("MoveL p{2},v100,fine,tool0;", "", None),
        ("show x;", "", 'data: {x: "[0]"}'),
        ("MoveL p,v100,fine,tool0;", "", None),
        ("MoveL Offs(p,0,0,9),v123,fine,tool0;", "", None),
        ("WaitTime p.trans.x;", "", None),
        ("WaitTime q.robax.rax_1;", "", None),
        ("a{1}:=3; WaitTime 1;", "VAR num a{nMax};", "data: {nMax: 1}"),
        ("WaitTime a{3};", "VAR num a{nMax}:=[1,2,3];", "data: {nMax: 3}"),
        ("WaitTime a{2,3};", "VAR num a{2,nMax}:=[[1,2,3],[4,5,6]];", "data: {nMax: 3}"),
        ("count:=count+1; WaitTime count;", "", "data: {count: 0}"),
        ("done:=TRUE; IF done WaitTime 1;", "", "data: {done: false}"),
        ("a{2}:=4; WaitTime a{2};", "", 'data: {a: "[0,0]"}'),
        ("p.trans.z:=4; MoveL p,v100,fine,tool0;", "", None),
    ],
)  # fmt: skip
def test_what_is_offered_is_what_then_works(body: str, declared: str, line: str | None) -> None:
    files = text_of(body, declared, "PROC show(num x{*}) WaitTime x{1}; ENDPROC")
    program, lacks = try_program(files)
    assert line is None or lacks[0].line == line
    with pytest.raises(MissingError) as caught:
        run_program(files)
    assert f"'{lacks[0].line}'" in str(caught.value)
    for text in (template(lacks), *([lacks[0].line] if len(lacks) == 1 else [])):
        again, left = try_program(files, parse_cell(f"{ARM}{text}\n", "cell.yaml").scenario)
        assert left == ()
        assert tuple(map(str, again.warnings)) == ()
        assert times(again) == times(program)
        assert [type(one) for one in again.motions] == [type(one) for one in program.motions]


def test_a_wait_that_the_program_makes_true_asks_for_nothing() -> None:
    assert shown("n:=5; WaitUntil n>4; WaitTime n;", "PERS num n:=0;") == [5]
    assert shown("WaitUntil n=3; WaitTime n;", "PERS num n:=0;") == [3]
    assert shown("WaitUntil n>4; WaitTime 1;") == [1]  # read nowhere else


# ----------------------------------------------------------------------------------------------------- what is given


@pytest.mark.parametrize(
    ("data", "body", "expected"),
    [
        ("{n: 3}", "WaitTime n+n;", [6]),
        ("{N: 3}", "WaitTime n;", [3]),
        ("{n: {type: num, value: 3}}", "WaitTime n;", [3]),
        ("{n: [1, 2]}", "WaitTime n; WaitTime n; WaitTime n;", [1, 2, 2]),
        ("{go: true}", "IF go WaitTime 1;", [1]),
        ("{go: [false, true]}", "WHILE NOT go DO WaitTime 1; ENDWHILE", [1]),
        ("{t: ab}", "WaitTime StrLen(t);", [2]),
        ('{x: "[1,2,3]"}', "WaitTime x{3};", [3]),
        ('{x: "[[1,2],[3,4]]"}', "WaitTime x{2,1}+Dim(x,2);", [5]),
        ('{x: "[TRUE,FALSE]"}', "IF x{1} AND NOT x{2} WaitTime 1;", [1]),
        ('{v: "[1,2,3]"}', "WaitTime v.z;", [3]),
        ('{v: {type: pos, value: "[1,2,3]"}}', "WaitTime VectMagn(v-[1,2,0]);", [3]),
        (f'{{p: "{TARGET}"}}', "WaitTime p.trans.x;", [500]),
        (f'{{p: {{type: robtarget, value: "{TARGET}"}}}}', "WaitTime CalcDist(p);", [500]),
        ("{n: 3}", "n:=n+1; WaitTime n; WaitTime n;", [4, 4]),
    ],
)
def test_data_that_nothing_declares(data: str, body: str, expected: list[float]) -> None:
    rest = "FUNC num CalcDist(robtarget p) RETURN p.trans.x; ENDFUNC"
    assert shown(body, "", data, rest) == expected


def test_a_plain_value_that_fitted_one_wait_and_not_the_next_is_asked_for_again() -> None:
    body = "WaitUntil di=1 OR n>3;\nWaitUntil di=1 OR n>8;"
    assert error(body, "PERS num n:=0;", "{n: 4}").startswith("m.mod:5:1: ")


def test_a_target_that_is_given_is_where_the_robot_goes() -> None:
    (move,) = run_program(text_of("MoveL p,v100,fine,tool0;"), of(f'{{p: "{TARGET}"}}')).motions
    assert isinstance(move, MoveL)
    assert move.X_WT[:3, 3].tolist() == pytest.approx([0.5, 0, 0.6])


@pytest.mark.parametrize(
    ("data", "body", "expected"),
    [
        ("{n: 7}", "WaitTime n; n:=1; WaitTime n;", [7, 1]),
        ("{n: 7}", "n:=0; WaitUntil n<>0; WaitTime n; WaitTime n;", [7, 7]),
        ("{n: [1, 2]}", "n:=0; WaitUntil n<>0; WaitTime n; WaitTime n; n:=0; WaitUntil n<>0; WaitTime n;", [1, 1, 2]),
        ("{n: [1, 5, 20]}", "WaitUntil n>2 AND n<9; WaitTime n;", [5]),
        ("{n: 1}", "WaitUntil n=3; WaitTime n;", [3]),  # a plain value gives way, as a signal's
        ("{n: 4}", "FOR i FROM 1 TO n DO WaitTime i; ENDFOR", [1, 2, 3, 4]),
        ('{a: "[5,6]"}', "WaitTime a{2};", [6]),
        ('{a: ["[0,0]", "[0,8]"]}', "WaitUntil a{2}>0; WaitTime a{2};", [8]),
        ("{go: [false, true]}", "WaitUntil go AND n=0; IF go WaitTime 1;", [1]),
    ],
)
def test_data_that_the_program_declares_and_somebody_else_writes(data: str, body: str, expected: list[float]) -> None:
    assert shown(body, "PERS num n:=0; LOCAL VAR num a{2}; PERS bool go:=FALSE;", data) == expected


def test_shared_data_is_one_in_all_modules() -> None:
    files = [*text_of("other; WaitTime n;", "PERS num n:=1;")]
    files.append(TextFile("o.mod", "MODULE o\nPERS num n:=2;\nPROC other()\nn:=n+1;\nENDPROC\nENDMODULE\n", "utf-8"))
    program = run_program(files, of("{n: 7}"))
    assert times(program) == [8]
    assert tuple(map(str, program.warnings)) == ()


@pytest.mark.parametrize(
    ("data", "body", "message"),
    [
        ("{c: 2}", "WaitTime c;",
         "m.mod:2:1: c is a CONST, and data.c in the cell file gives it another value; change it here"),
        ("{n: true}", "WaitTime n;", "m.mod:2:17: the value true of 'n' in the cell file is not a number"),
        ("{b: 1}", "IF b WaitTime 1;", "m.mod:4:4: the value 1 of 'b' in the cell file is not true or false"),
        ("{n: [1, 2]}", "WaitUntil n>2;",
         "m.mod:4:1: WaitUntil waits for n>2, and none of the values that the cell file has left for n makes it true; "
         "add one under data, or let the wait end by its time: 'waits: {\"n>2\": timeout}'"),
        ("{n: [1, 2]}", "WaitUntil n=3;",
         "m.mod:4:1: WaitUntil waits for n=3, and none of the values that the cell file has left for n makes it true; "
         "add one under data, or let the wait end by its time: 'waits: {\"n=3\": timeout}'"),
        ('{x: "[a,b]"}', "WaitTime x{1};",
         "m.mod:4:10: the value of 'x' in the cell file does not tell its type; "
         "say it, 'data: {x: {type: num, value: ...}}'"),
        ("{x: {type: nix, value: 1}}", "WaitTime x;",
         "m.mod:4:10: data.x in the cell file is of type nix, whose values mean nothing here"),
    ],
)  # fmt: skip
def test_values_that_do_not_fit(data: str, body: str, message: str) -> None:
    assert error(body, "CONST num c:=1; PERS num n:=0;", data) == message


def test_data_that_the_program_never_asks_for_is_said() -> None:
    (warning,) = tuple(map(str, run_program(text_of("WaitTime 1;"), of("{x: 1, y: 2}")).warnings))
    assert warning == "the program never uses x, y (data in the cell file)"


def test_the_cell_file_takes_plain_values_sequences_and_types() -> None:
    scenario = of('{nCount: 3, bReady: [true, false], pPick: {type: robtarget, value: "[1]"}}')
    assert scenario.data == {
        "ncount": Given(3.0),
        "bready": Given((True, False)),
        "ppick": Given("[1]", "robtarget"),
    }
    with pytest.raises(InputError, match=r"data\.x\.value: is missing"):
        of("{x: {type: num}}")
