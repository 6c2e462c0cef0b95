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


@pytest.mark.parametrize(
    ("body", "message"),
    [
        # ---- blocks that are not closed, at their opener
        (
            "IF a THEN\nx:=1;",
            "3:1: IF is not closed: expected ENDIF before 'ENDPROC' of line 5; write ENDIF where it ends",
        ),
        (
            "FOR i FROM 1 TO 2 DO\nIF a THEN\nENDFOR",
            "4:1: IF is not closed: expected ENDIF before 'ENDFOR' of line 5; write ENDIF where it ends",
        ),
        (
            "IF a THEN\nFOR i FROM 1 TO 2 DO\nx:=1;\nENDIF",
            "4:1: FOR is not closed: expected ENDFOR before 'ENDIF' of line 6; write ENDFOR where it ends",
        ),
        (
            "WHILE a DO",
            "3:1: WHILE is not closed: expected ENDWHILE before 'ENDPROC' of line 4; write ENDWHILE where it ends",
        ),
        (
            "TEST a\nCASE 1:\nx:=1;",
            "3:1: TEST is not closed: expected ENDTEST before 'ENDPROC' of line 6; write ENDTEST where it ends",
        ),
        (
            "IF a THEN\nx:=1;\nELSE IF b THEN\nx:=2;\nENDIF",
            "3:1: IF is not closed: expected ENDIF before 'ENDPROC' of line 8; "
            "'ELSE IF' of line 5 opens an IF of its own, so write ELSEIF there or one more ENDIF",
        ),
        # ---- words that close nothing
        ("ENDIF", f"3:1: ENDIF without IF: no IF is open here; {EARLY}"),
        ("ELSE\nx:=1;\nENDIF", f"3:1: ELSE without IF: no IF is open here; {EARLY}"),
        ("CASE 1:\nx:=1;", f"3:1: CASE without TEST: no TEST is open here; {EARLY}"),
        (
            "ENDFOR\nENDWHILE",
            f"3:1: ENDFOR without FOR: no FOR is open here; {EARLY}\n"
            f"4:1: ENDWHILE without WHILE: no WHILE is open here; {EARLY}",
        ),
        ("WHILE a DO\nx:=1;\nENDFOR", "5:1: expected ENDWHILE for WHILE of line 3, found 'ENDFOR'; write ENDWHILE"),
        (
            "IF a THEN\nELSE\nELSE\nENDIF",
            "5:1: expected ENDIF, found 'ELSE'; ELSE comes last, and once",
        ),
        (
            "IF a THEN\nFOR i FROM 1 TO 2 DO\nx:=1;\nENDIF\n    ENDFOR",
            "4:1: FOR is not closed: expected ENDFOR before 'ENDIF' of line 6; write ENDFOR where it ends",
        ),
        # ---- the head of a block
        (
            "IF a\nx:=1;\ny:=2;\nENDIF\nz:=3;",
            "3:5: expected THEN after the condition of IF, which ENDIF of line 6 belongs to; write THEN here",
        ),
        (
            "IF a\nx:=1;\nELSEIF b THEN\ny:=2;\nELSE\nENDIF",
            "3:5: expected THEN after the condition of IF, which ELSEIF of line 5 belongs to; write THEN here",
        ),
        ("IF a\nENDIF", "3:5: expected THEN after the condition of IF, or a statement, found 'ENDIF'"),
        ("IF a;", "3:5: expected THEN after the condition of IF, or a statement, found ';'"),
        (
            "IF a THEN x:=1; ELSEIF b x:=2; ENDIF",
            "3:25: expected THEN after the condition of ELSEIF, found 'x'; write THEN here",
        ),
        ("WHILE a\nx:=1;\nENDWHILE", "3:8: expected DO after the condition of WHILE, found 'x'; write DO here"),
        ("FOR i = 1 TO 3 DO\nENDFOR", "3:7: expected FROM after FOR i, found '='; write 'FOR i FROM first TO last DO'"),
        ("FOR i FROM 1 DO\nENDFOR", "3:13: expected TO after the first value of FOR, found 'DO'"),
        ("IF (a THEN\nENDIF", "3:6: expected ')' to close the '(' of column 4, found 'THEN'"),
        ("WHILE (a\nx:=1;\nENDWHILE", "3:9: expected ')' to close the '(' of column 7, found 'x'"),
        (
            "TEST a\nx:=1;\nCASE 1:\nENDTEST",
            "4:1: expected CASE, DEFAULT or ENDTEST after TEST, found 'x'; a statement belongs to a CASE",
        ),
        ("TEST a\nCASE 1\nx:=1;\nENDTEST", "4:7: expected ':' after the values of CASE, found 'x'; write ':' here"),
        # ---- operators of other languages
        ("IF a == b THEN\nENDIF", "3:6: expected '=' to compare, found '=='; write '='"),
        (
            "IF a != b THEN\nx:=1;\nENDIF",
            "3:6: expected '<>' for 'not equal', found '!='; '!' begins a comment, so write '<>'",
        ),
        (
            "WHILE a != b DO\nx:=1;\nENDWHILE",
            "3:9: expected '<>' for 'not equal', found '!='; '!' begins a comment, so write '<>'",
        ),
        (
            "IF a && b THEN\nENDIF",
            "3:6: expected THEN after the condition of IF, or a statement, found '&&'; write AND",
        ),
        ("IF a || b THEN\nENDIF", "3:6: expected THEN after the condition of IF, or a statement, found '||'; write OR"),
        (
            "IF a := b THEN\nENDIF",
            "3:6: expected THEN after the condition of IF, or a statement, found ':='; ':=' assigns, '=' compares",
        ),
        ("x = 1;", "3:3: expected ':=' in the assignment, found '='; ':=' assigns, '=' compares"),
        ("a{1}.b == 1;", "3:8: expected ':=' in the assignment, found '=='; ':=' assigns, '=' compares"),
        ("VAR num x = 1;", "3:11: expected ';' after the declaration of x, found '='; ':=' assigns, '=' compares"),
        ("MoveL p,v1\\V=100,z1,t;", "3:13: expected ':=' after \\V, found '='; ':=' assigns, '=' compares"),
        ("// note", "3:1: expected '!' before a comment, found '//'; write '!'"),
        (
            "x:=1; /* more\nof it */ y:=2;",
            "3:7: expected '!' before a comment, found '/*'; write '!' on each of its lines",
        ),
        # ---- semicolons, commas, parentheses
        ("x:=1\ny:=2;", "3:5: expected ';' after the assignment, found 'y'; write ';' here"),
        ("x:=1 y:=2;", "3:5: expected ';' after the assignment, found 'y'"),
        (
            "MoveL p,v100\nMoveL p,v100;",
            "3:13: expected ';' after the arguments of MoveL, found 'MoveL'; write ';' here",
        ),
        ("RETURN", "3:7: expected ';' after RETURN, found 'ENDPROC'; write ';' here"),
        ("MoveL p10 v100, fine, tool0;", "3:10: expected ',' or ';' after the arguments of MoveL, found 'v100'"),
        ("WaitTime\\InPos 0.1;", "3:15: expected ',' or ';' after the arguments of WaitTime, found '0.1'"),
        ("MoveL p,,v100;", "3:9: expected an expression, found ','; one ',' is too many"),
        ("MoveL p,v100,;", "3:14: expected an argument after ',', found ';'; one ',' is too many"),
        ("x:=[1,2,];", "3:9: expected an expression, found ']'; one ',' is too many"),
        ("x:=[1,2;", "3:8: expected ']' or ',' in the aggregate, found ';'"),
        ("x:=a{1,2;", "3:9: expected '}' after the indices, found ';'"),
        ("x:=f(1;", "3:7: expected ',' or ')' after the arguments of f, found ';'"),
        ("x:=(1+2;", "3:8: expected ')' to close the '(' of column 4, found ';'"),
        ("x:=1);", "3:5: expected ';' after the assignment, found ')'; no '(' opens it, so remove it"),
        ("go();", "3:3: expected arguments or ';' after go, found '('; a procedure is called without parentheses: go;"),
        ("f(1):=2;", "3:5: expected ',' or ';' after the arguments of f, found ':='; ':=' assigns, '=' compares"),
        ("x:=1 # 2;", "3:5: expected ';' after the assignment, found '#'"),
        # ---- strings, names, numbers
        (
            'TPWrite "abc;\nx:=1;',
            "3:9: expected an expression, found a string that is not closed on its line; close it with '\"'",
        ),
        ("MoveL 10p,v100;", f"3:7: expected a name, found '10p'; {CHOOSE}"),
        ("VAR num p(1);", f"3:9: expected a name, found 'p(1)'; {CHOOSE}"),
        (
            "VAR num if;",
            "3:9: expected a name after VAR num, found 'if'; that is a reserved word, so choose another name",
        ),
        ("GOTO 1;", "3:6: expected a label after GOTO, found '1'"),
        (
            "LOCAL VAR num x;",
            "3:1: expected a statement, found 'LOCAL'; only a module's declarations have it, so remove it",
        ),
        ("x:=1E999;", "3:4: number 1E999 is too large"),
        ("x:=0x" + "F" * 300 + ";", "3:4: number 0x" + "F" * 35 + "... is too large"),
        ("x:=a{1,2,3,4};", "3:5: 4 dimensions; RAPID has at most 3"),
        # ---- nesting
        *(
            (text, f"3:{column}: nested deeper than 60 levels: split it up")
            for text, column in (
                ("x:=" + "f(" * 70, 126),
                ("x:=" + "a{" * 70, 126),
                ("x:=" + "-" * 70, 65),
                ("x:=" + "(" * 70, 65),
                ("IF a " * 70, 301),
                ("IF a THEN " * 70, 601),
            )
        ),
    ],
)
def test_a_mistake_in_a_body_is_one_sentence_at_its_place(body: str, message: str) -> None:
    assert in_main(body) == message


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "MODULE m\nPROC a()\nx:=1;\nPROC b()\nENDPROC\nENDMODULE",
            "2:1: PROC a is not closed: expected ENDPROC before 'PROC' of line 4; write ENDPROC where it ends",
        ),
        (
            "MODULE m\nPROC a()\nENDPROC\n",
            "1:1: MODULE m is not closed: expected ENDMODULE before the end of the file; write ENDMODULE where it ends",
        ),
        (
            "MODULE m\nPROC a()\nIF b THEN\nx:=1;\n",
            "3:1: IF is not closed: expected ENDIF ENDPROC ENDMODULE before the end of the file; "
            "the file seems to be cut off",
        ),
        (
            "MODULE m\nFUNC num f()\nRETURN 1;\nENDPROC\nENDMODULE",
            "4:1: expected ENDFUNC for FUNC f of line 2, found 'ENDPROC'; write ENDFUNC",
        ),
        ("MODULE m\nENDPROC\nENDMODULE", f"2:1: ENDPROC without PROC: no PROC is open here; {EARLY}"),
        ("ENDMODULE", "1:1: expected a declaration, found 'ENDMODULE'; no MODULE is open here"),
        (
            "MODULE m\nPROC main\nx:=1;\nENDPROC\nENDMODULE",
            "2:10: expected '(' after PROC main, found 'x'; write 'PROC main()'",
        ),
        ("MODULE m\nPROC pick(1)()\nx:=1;\nENDPROC\nENDMODULE", f"2:6: expected a name, found 'pick(1)'; {CHOOSE}"),
        (
            "PERS tooldata grip(Closed) := [TRUE];\nPROC pick(left)()\nENDPROC",
            f"1:15: expected a name, found 'grip(Closed)'; {CHOOSE}\n"
            f"m.mod:2:6: expected a name, found 'pick(left)'; {CHOOSE}",
        ),
        (
            "MODULE m(SYSMODULE READONLY) ENDMODULE",
            "1:20: expected ')' after the module's attributes, found 'READONLY'",
        ),
        ("PROC type name ENDPROC", "1:10: expected '(' after PROC type, found 'name'; write 'PROC type()'"),
        ("MODULE 1st\nENDMODULE", f"1:8: expected a name, found '1st'; {CHOOSE}"),
        ("MODULE my-program\nENDMODULE", f"1:8: expected a name, found 'my-program'; {CHOOSE}"),
        (
            "MODULE m(FAST)\nENDMODULE",
            "1:10: expected a module attribute (SYSMODULE, NOVIEW, NOSTEPIN, VIEWONLY, READONLY), found 'FAST'",
        ),
        (
            "MODULE m\nMoveL p,v100,fine,tool0;\nMoveL p,v100,fine,tool0;\nVAR num n;\nENDMODULE",
            f"2:1: expected {DECLARATION}, found 'MoveL'; instructions belong in a PROC",
        ),
        ("RECORD r\nnum a\nENDRECORD", "2:6: expected ';' after the component, found 'ENDRECORD'; write ';' here"),
        ("PROC main(num a num b)\nENDPROC", "1:16: expected ',' or ')' after a parameter of main, found 'num'"),
    ],
)
def test_a_mistake_in_a_module_is_one_sentence_at_its_place(text: str, message: str) -> None:
    assert said(text) == f"m.mod:{message}"


def test_several_mistakes_are_told_in_one_run_and_in_order() -> None:
    text = (
        "MODULE m\nVAR num if;\nVAR num a\nVAR num b:=(1;\nPROC pick(1)()\nIF a THEN\nx = 1;\nENDPROC\n"
        "PROC other()\nMoveL p10 v100;\ny:=[1,2;\nERROR (1\nRETRY;\nENDPROC\nENDMODULE\n"
    )
    with pytest.raises(InputErrorGroup) as caught:
        parse_module(text, "m.mod")
    assert [(error.line, error.column) for error in caught.value.errors] == [
        (2, 9), (3, 10), (4, 14), (5, 6), (6, 1), (7, 3), (10, 10), (11, 8), (12, 9),
    ]  # fmt: skip


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


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("n:=a{k+3};", "index 4 of a{k+3} lies outside 1..3"),
        ("n:=m{1,k+2};", "index 3 in dimension 2 of m{1,k+2} lies outside 1..2"),
        ("n:=a{1,2};", "a is an array of 1 dimension(s), found 2 index(es)"),
    ],
)
def test_an_index_says_of_which_array(body: str, message: str) -> None:
    assert refused(body, "VAR num n; VAR num k:=1; VAR num a{3}; VAR num m{3,2};").message == message


def test_a_target_without_external_axes_is_told_about_the_rail() -> None:
    message = refused("", "CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0]];").message
    assert message.endswith(
        "; the external axes are missing, write [9E9,9E9,9E9,9E9,9E9,9E9], with the rail's position in its place if "
        "the robot rides on one"
    )


@pytest.mark.parametrize("name", ["pPick", "m.x", "x{1}"])
def test_a_name_that_is_declared_nowhere_asks_for_its_file(name: str) -> None:
    message = refused(f"MoveL {name},v100,fine,tool0;").message
    value = "[[0,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
    beginning, line = {
        "pPick": ("robtarget 'pPick'", f'data: {{pPick: "{value}"}}'),
        "m.x": ("'m'", None),  # no record has an x that is a robtarget
        "x{1}": ("array of unknown size 'x'", f'data: {{x: "[{value}]"}}'),
    }[name]
    assert message.startswith(f"{beginning} is not declared in the program")
    end = f", or its value: the line '{line}' in the cell file" if line else ""
    assert message.endswith(f"; give the file that declares it{end}")


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("dice;", "dice is a FUNC; only a PROC is called as a statement; write 'x:=dice();', or make it a PROC"),
        ("dice 6;", "dice is a FUNC; only a PROC is called as a statement; write 'x:=dice(...);', or make it a PROC"),
        (
            "halt;",
            "halt is a TRAP; only a PROC is called as a statement; move what it does into a PROC that TRAP halt calls "
            "too",
        ),
    ],
)
def test_what_to_do_about_a_call_of_what_is_no_procedure(body: str, message: str) -> None:
    routines = "FUNC num dice(\\num top)\nRETURN 4;\nENDFUNC\nTRAP halt\nENDTRAP"
    assert refused(body, routines=routines).message == message


@pytest.mark.parametrize(
    ("body", "data", "hint"),
    [
        ("MoveL p,v100,fine,tool0;", "VAR robtarget p;", "it was never given a value"),
        ("MoveL RelTool(p,0,0,1),v100,fine,tool0;", "VAR robtarget p;", "it was never given a value"),
        ("MoveL p,v100,fine,tool0;", "CONST robtarget p:={};", "give a quaternion of length 1"),
        ("MoveL RelTool(p,0,0,1),v100,fine,tool0;", "CONST robtarget p:={};", "give a quaternion of length 1"),
        ("MoveL {},v100,fine,tool0;", "", "give a quaternion of length 1"),
        ("MoveL p,v100,fine,t;", f"PERS tooldata t:=[TRUE,[[0,0,9],{'[0,0,0,0]'}],[0,[0,0,0],[1,0,0,0],0,0,0]];", ""),
    ],
)
def test_zeros_that_were_written_are_no_value_that_was_never_given(body: str, data: str, hint: str) -> None:
    zeros = "[[500,0,600],[0,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
    if not hint:
        data, hint = f"CONST robtarget p:={zeros.replace('0,0,0,0', '0,0,1,0', 1)};{data}", "a quaternion of length 1"
    message = refused(body.replace("{}", zeros), data.replace("{}", zeros)).message
    assert "has orientation [0,0,0,0]" in message
    assert message.endswith(hint)


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
        ("MoveL p,z10,v100,tool0;", "Speed of MoveL needs a speeddata, found zonedata z10"),
        ("MoveL 5,v100,fine,tool0;", "ToPoint of MoveL needs a robtarget, found num 5"),
        ('MoveL p,v100\\V:="x",fine,tool0;', '\\V of MoveL needs a num, found string "x"'),
        ("MoveL Offs(p,1,TRUE,0),v100,fine,tool0;", "YOffset of Offs needs a num, found bool TRUE"),
        (
            "MoveL [[1,2,3],b,[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;",
            "rot of a robtarget needs an orient",
        ),
        ("n:=fUp(b);", "parameter a of fUp needs a num, found bool b"),
        ("n:=fUp([1,2]);", "parameter a of fUp needs a num, found an aggregate"),
        ("n:=fUp(fUp(b));", "parameter a of fUp needs a num, found bool b"),
        ("n:=fUp(fBad());", "RETURN of fBad needs a num, found bool TRUE"),
        ('n:="one";', 'n needs a num, found string "one"'),
        ('n:="a" + "b of forty characters and more, so that it is cut";', 'n needs a num, found string "a" + "b of'),
        ("b:=TRUE AND n;", "the right side of AND needs a bool, found num n"),
        ("b:=n OR b;", "the left side of OR needs a bool, found num n"),
        ("b:=NOT n;", "the right side of NOT needs a bool, found num n"),
        ("IF n THEN ENDIF", "a condition needs a bool, found num n"),
        ("FOR i FROM b TO 3 DO ENDFOR", "a bound of FOR needs a num, found bool b"),
        ("TEST n CASE 2,TRUE: ENDTEST", "a CASE of n needs a num, found bool TRUE"),
        ("n:=list{b};", "an index needs a num, found bool b"),
    ],
)
def test_a_value_of_the_wrong_type_is_said_with_what_needs_it(body: str, message: str) -> None:
    data = "CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]; VAR num n:=1; VAR bool b; "
    data += "VAR num list{2};"
    routines = "FUNC num fUp(num a)\nRETURN a+1;\nENDFUNC\nFUNC num fBad()\nRETURN TRUE;\nENDFUNC"
    error = refused(body, data, routines)
    assert error.message.startswith(message)
    assert error.excerpt is not None


def test_initial_data_of_the_wrong_type_is_said_with_its_name() -> None:
    assert refused("", "VAR bool b; VAR num n:=b;").message == "n needs a num, found bool b"
    assert refused("", "VAR bool b; VAR num n{2}:=[1,b];").message == "element 2 of a num{*} needs a num, found bool b"


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
