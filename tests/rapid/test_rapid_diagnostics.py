"""What is said about broken text: each mistake its own sentence, at its place, and no sentence that only follows."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.motion import TextFile
from trajopt_cli.rapid.language.parser import parse_module, parse_statement
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

CHOOSE = "a name begins with a letter and has only letters, digits and '_', so rename it wherever it is used"
EARLY = "remove it, or look for one closed too early"
DECLARATION = "a declaration (VAR, PERS, CONST, PROC, FUNC, TRAP, RECORD, ALIAS) or ENDMODULE"


def said(text: str) -> str:
    with pytest.raises(InputError) as caught:
        parse_module(text, "m.mod")
    return str(caught.value)


def in_main(body: str) -> str:
    """The sentences about a procedure's body; its first line is line 3."""
    return said(f"MODULE m\nPROC main()\n{body}\nENDPROC\nENDMODULE\n").replace("m.mod:", "")


def test_of_very_many_mistakes_the_first_twenty_are_told_and_the_rest_counted() -> None:
    lines = in_main("x:=);\n" * 30).splitlines()
    assert len(lines) == 21
    assert lines[19:] == ["22:4: expected an expression, found ')'", " and 10 more mistakes"]
    assert in_main("x:=);\n" * 21).splitlines()[-1] == " and 1 more mistake"


def test_one_mistake_is_no_group() -> None:
    with pytest.raises(InputError) as caught:
        parse_module("VAR num if;", "m.mod")
    assert not isinstance(caught.value, InputErrorGroup)


# --------------------------------------------------------------------------------------------------------- warnings


def warnings(text: str) -> list[tuple[int, str]]:
    return list(parse_module(text, "m.mod").warnings)


def test_text_after_the_last_module_is_counted() -> None:
    after = " is not part of the program and does not run"
    text = "MODULE m\nENDMODULE\n"
    assert warnings(text + "MoveL p,v,z,t;\n\n! no line\nMoveL p,v,z,t;\n" * 38) == [
        (len(text), f"text after ENDMODULE (76 lines){after}")
    ]
    assert warnings(text + '"\n' + text) == [(len(text), f"text after ENDMODULE (1 line){after}")]
    assert warnings(text + "! only a comment\n" + text) == []


def test_odd_but_legal_text_is_a_warning() -> None:
    name = "a" * 33
    assert warnings(f"VAR num\x00{name};VAR num {'b' * 32}:=[1,2];CONST num {name}:=[1];") == [
        (7, "NUL bytes between the tokens are read as blanks"),
        (8, f"'{name}' has 33 characters; a controller takes at most 32 in a name"),
        (100, f"'{name}' has 33 characters; a controller takes at most 32 in a name"),
    ]


def test_placeholders_are_legal_to_load() -> None:
    marks = ("SMT", "EXP", "VAR", "ID", "ARG", "PAR", "ALT", "DIM", "EIT", "CSE", "DDN", "RDN", "TDN")
    body = "".join(f"<{mark}>\nx:=<{mark}>;\n" for mark in marks)
    assert (
        warnings(
            f"MODULE <ID>\n<DDN>\n<RDN>\nPROC <ID>(<PAR>)\n{body}<VAR>:=1;TEST x\n<CSE>\nENDTEST\nENDPROC\nENDMODULE"
        )
        == []
    )


# --------------------------------------------------------------------------------------------------------- excerpts


@pytest.mark.parametrize(
    ("text", "offset", "excerpt"),
    [
        ("x;\n  MoveL p10 v100, fine;\n", 14, "    MoveL p10 v100, fine;\n             ^"),
        ("\tMoveL p10\tv100;\r\n", 10, "    MoveL p10 v100;\n             ^"),
        ("x\x00y\x1bz", 4, "    x y?z\n        ^"),
        ("日本:=é1", 4, "    日本:=é1\n          ^"),
        ("a" * 100 + "b" + "c" * 100, 100, f"    ...{'a' * 70}b{'c' * 46}...\n    {' ' * 73}^"),
        ("x:=1;\n\n", 6, None),
    ],
)
def test_the_line_is_shown_with_a_caret_below_the_place(text: str, offset: int, excerpt: str | None) -> None:
    error = Places(text, "m.mod").error(offset, "wrong")
    assert error.excerpt == excerpt
    assert error.shown() == (f"{error}\n{excerpt}" if excerpt else str(error))
    assert "\n" not in str(error)


def test_the_command_prints_every_mistake_with_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "m.mod"
    file.write_text("MODULE m\n    VAR num if;\n    VAR num (;\nENDMODULE\n")
    assert run(["parse", str(file)]) == 2
    assert capsys.readouterr().err == (
        f"{file}:2:13: expected a name after VAR num, found 'if'; that is a reserved word, so choose another name\n"
        "    VAR num if;\n            ^\n"
        f"{file}:3:13: expected a name after VAR num, found '('\n"
        "    VAR num (;\n            ^\n"
    )


# ---------------------------------------------------------------------------------------------- text to choke on

HEAD = "MODULE m\nPROC main()\n"


@pytest.mark.parametrize(
    "text",
    [
        *(
            HEAD + "x:=" + piece * 10_000
            for piece in ("(", "[", "[1,", '"', "-", "f(", "a{", "1.", "[[[1,2]]],", '"\n', "[1,2\n")
        ),
        *(
            HEAD + piece * 10_000
            for piece in ("IF a THEN ", "IF a ", "x:=1;ENDIF ", "ELSE ", "CASE 1 ", "/* ", "#;", ");\n", ";a,b", "%")
        ),
        *(
            piece * 10_000
            for piece in (
                "%%%(",
                "%%% a:b ",
                "MODULE m ",
                "ENDMODULE ",
                "PROC a(1)() ",
                "RECORD r num a;",
                "\x00(",
                "å",
            )
        ),
        HEAD + "x:=[" + " " * 150_000,
        HEAD + "x" * 150_000,
    ],
    ids=lambda text: ascii(text[-12:]),
)
def test_hopeless_text_is_refused_at_once_and_briefly(text: str) -> None:
    start = time.process_time()
    with pytest.raises(InputError) as caught:
        parse_module(text, "m.mod")
    assert time.process_time() - start < 1.5  # measured below 0.2 s; what is not linear takes half a minute
    shown = caught.value.shown().splitlines()
    assert len(shown) <= 61
    assert max(map(len, shown)) < 300


def test_a_statement_of_its_own_is_checked_too() -> None:
    with pytest.raises(InputError, match="write '='"):
        parse_statement("IF a == b x:=1;", "m.mod")


# ------------------------------------------------------------------------------------------------ programs that ran


def refused(body: str, data: str = "", routines: str = "", scenario: Scenario | None = None) -> InputError:
    """The error of a run; data is line 2, the body of main is line 4."""
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\n{routines}\nENDMODULE\n"
    with pytest.raises(InputError) as caught:
        run_program([TextFile("m.mod", text, "utf-8")], scenario)
    return caught.value


@pytest.mark.parametrize(
    ("body", "line", "caret"),
    [
        ("WaitTime 1/(n-n);", "    WaitTime 1/(n-n);", 9),  # an error that a handler may handle
        ("RAISE 7;", "    RAISE 7;", 0),
        ("n:=diPart;", "    n:=diPart;", 3),  # what the scenario lacks
        ("MoveAbsJ j,v100,fine,tGrip;", "    MoveAbsJ j,v100,fine,tGrip;", 21),
    ],
)
def test_what_a_run_comes_to_is_shown_with_its_line(body: str, line: str, caret: int) -> None:
    data = "VAR num n; CONST jointtarget j:=[[0,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    assert refused(body, data).shown().splitlines()[1:] == [line, f"    {' ' * caret}^"]


def test_an_error_in_another_module_is_shown_with_the_line_of_its_own_file() -> None:
    files = [
        TextFile("a.mod", "MODULE a\nPROC main()\nhelp;\nENDPROC\nENDMODULE\n", "utf-8"),
        TextFile("b.mod", "MODULE b\nPROC help()\n\n  WaitTime 1/0;\nENDPROC\nENDMODULE\n", "utf-8"),
    ]
    with pytest.raises(InputError) as caught:
        run_program(files)
    assert caught.value.shown() == "b.mod:4:12: division by zero in '/'\n    WaitTime 1/0;\n             ^"


def test_one_rough_orientation_is_told_once_however_often_it_is_shifted() -> None:
    target = "[[500,0,600],[0,0.71,0.71,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
    text = f"MODULE m\nCONST robtarget p:={target};\nPROC main()\n"
    text += "".join(f"MoveL Offs(p,{shift},0,0),v100,fine,tool0;\n" for shift in range(3))
    program = run_program([TextFile("m.mod", f"{text}ENDPROC\nENDMODULE\n", "utf-8")])
    assert tuple(map(str, program.warnings)) == (
        "m.mod:4:7: Offs(p,0,0,0) has an orientation of length 1.004092; it is normalised",
    )


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            "WHILE NOT flag DO ENDWHILE",
            "its condition reads flag, which is FALSE: see what should change it, or raise pass_limit in the cell file",
        ),
        (
            "WHILE n<k AND n<2 DO n:=n-1; ENDWHILE",
            "its condition reads n, which is -4 and k, which is 2: see what should change them, or raise pass_limit in "
            "the cell file",
        ),
        (
            "WHILE diGo=0 AND n=0 DO ENDWHILE",
            "its condition reads diGo: give a sequence of values that ends it under signals, or raise pass_limit in "
            "the cell file",
        ),
        (
            "back: IF NOT flag GOTO back;",
            "give values that end it (signals, data, answers), or raise pass_limit in the cell file",
        ),
    ],
)
def test_a_loop_that_does_not_end_says_what_it_reads(body: str, message: str) -> None:
    data = "PERS bool flag:=FALSE; VAR num n; VAR num k:=2;"
    error = refused(body, data, scenario=Scenario(pass_limit=4, signals={"diGo": 0.0}))
    assert error.message == f"the loop has not ended after 4 passes (pass_limit); {message}"
