"""Files as found in the field: encodings, places, spans, marks, and what is said about broken text."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveAbsJ, MoveExtJ, MoveJ, MoveL, Program, SignalEvent, Span, TextFile, Wait
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.rapid.marks import way_around
from trajopt_cli.rapid.reader import read_program, run_program
from trajopt_cli.scenario import Scenario

ROOT = Path(__file__).parents[2]
MOVES = (MoveJ, MoveL, MoveAbsJ, MoveExtJ)
DATA = (
    "CONST robtarget p:=[[100,200,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    "LOCAL VAR robtarget ps{2} := [\n[[1,2,3], [0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],"
    "[[4,5,6],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]]; ! two\n"
    "TASK PERS jointtarget j:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
)


def run(text: str) -> Program:
    return run_program([TextFile("m.mod", text, "utf-8")])


def run_main(body: str, data: str = DATA, rest: str = "") -> Program:
    return run(f"MODULE m\n{data}PROC main()\n{body}\nENDPROC\n{rest}ENDMODULE\n")


def error(text: str) -> str:
    with pytest.raises(InputError) as caught:
        run(text)
    return str(caught.value)


def error_main(body: str, data: str = "", rest: str = "") -> str:
    return error(f"MODULE m\n{data}PROC main()\n{body}\nENDPROC\n{rest}ENDMODULE\n")


# ------------------------------------------------------------------------------------------------------------ spans


def stretch(program: Program, span: Span | None) -> str:
    assert span is not None
    return program.files[span.file].text[span.start : span.end]


def test_every_span_is_exactly_the_text_it_names() -> None:
    body = (
        "MoveJ\n  p ,v100\\V:=50,z10,tool0 \\WObj:=wobj0 ; MoveL ps{1+1}, vmax, fine, tool0; "
        "MoveAbsJ j\\NoEOffs,v50,fine,tool0;"
    )
    program = run_main(body)
    one, two, _ = (m for m in program.motions if isinstance(m, MOVES))
    assert stretch(program, one.written.statement) == "MoveJ\n  p ,v100\\V:=50,z10,tool0 \\WObj:=wobj0 ;"
    assert stretch(program, one.written.target) == "p"
    assert stretch(program, two.written.target) == "ps{1+1}"


def test_waits_and_events_know_their_statement() -> None:
    program = run_main("Set do1;\nWaitTime 0.5 ; ! half\nWaitDI di1,1;")
    texts = [stretch(program, m.written.statement) for m in program.motions]
    assert texts == ["Set do1;", "WaitTime 0.5 ;", "WaitDI di1,1;"]
    assert [type(m) for m in program.motions] == [SignalEvent, Wait, Wait]


# -------------------------------------------------------------------------------------------------------- encodings


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1252", "utf-16"])
def test_a_file_is_read_in_its_own_encoding_and_written_back_the_same(tmp_path: Path, encoding: str) -> None:
    text = f"MODULE m\r\n{DATA}PROC main()\r\nMoveL pörta,v100,fine,tool0;\r\nENDPROC\r\nENDMODULE\r\n"
    file = tmp_path / "m.mod"
    file.write_bytes(text.replace("robtarget p:", "robtarget Pörta:").encode(encoding))
    program = read_program(file)
    assert len(program.motions) == 1
    read = program.files[str(file)]
    assert read.text.encode(read.encoding) == file.read_bytes()


def test_any_bytes_at_all_decode_and_encode_to_themselves() -> None:
    for data in (bytes(range(256)), b"\xef\xbb\xbfabc\x81", b"\xff\xfea", "å".encode("cp1252"), b""):
        text, encoding = decode(data)
        assert text.encode(encoding) == data


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_utf_16_is_known_without_its_mark_too(encoding: str) -> None:
    text = f"MODULE m\r\n! pörta\r\n{DATA}ENDMODULE\r\n"
    assert decode(text.encode(encoding)) == (text, encoding)
    assert decode(b"MODULE\x00m ENDMODULE" + b"\x00" * 8)[1] == "utf-8"


def test_blanks_of_all_kinds_headers_and_nul_bytes_stand_between_tokens() -> None:
    text = (
        "\u3000%%%\n VERSION:1\n LANGUAGE:ENGLISH\n %%%\n! before\nMODULE\x00m\n"
        f"{DATA}PROC\u00a0main()\x00MoveL\tp,\x00v100,fine,tool0;;\n ENDPROC ENDMODULE"
    )
    program = run(text)
    assert len(program.motions) == 1
    assert tuple(map(str, program.warnings)) == ("m.mod:6:7: NUL bytes between the tokens are read as blanks",)


@pytest.mark.parametrize(
    "call",
    [
        "MoveL p,v100,fine,tool0\\WObj:=wobj0;",
        "MoveL p,v100,fine,tool0 \\WObj := wobj0 ;",
        "MoveL p,v100,fine,tool0,\\WObj:=wobj0;",
        "SyncMoveOn s1,t; MOVEL\\Conc,p\\ID:=10,v100\\V:=100,fine\\Inpos:=inpos20,tool0\\wobj:=WOBJ0\\TLoad:=load0;",
    ],
)
def test_optional_arguments_in_every_spelling(call: str) -> None:
    *_, move = run_main(call).motions
    assert isinstance(move, MoveL)
    assert move.wobj.lower() == "wobj0"


@pytest.mark.parametrize(
    "call",
    [
        "MoveL ToPoint:=p,Speed:=v100,Zone:=fine,Tool:=tool0\\WObj:=wobj0;",
        "movel p, v100, zone := fine, TOOL:=tool0 \\WObj:=wobj0;",
        "MoveL\n ToPoint:=Offs(Point:=p,XOffset:=0,0,ZOffset:=0),\n Speed:=v100\\V:=100,fine,tool0;",
        "go where:=p, 0;",
        "go p, high:=1;",
        "go where:=rise(of:=p, 0), high:=0 \\fast;",
        '%"go"% where:=p, high:=Pow(Base:=0,Exponent:=2);',
    ],
)
def test_a_required_argument_may_carry_its_parameters_name(call: str) -> None:
    """RAPID reference manual, formal syntax: `[ ToPoint ':=' ] < expression (IN) of robtarget >`."""
    rest = (
        "PROC go(robtarget where, num high \\switch fast)\nMoveL Offs(where,0,0,high),v100,fine,tool0;\nENDPROC\n"
        "FUNC robtarget rise(robtarget of, num high)\nRETURN Offs(of,0,0,high);\nENDFUNC\n"
    )
    (move,) = run_main(call, rest=rest).motions
    assert isinstance(move, MoveL)
    assert move.X_WT[:2, 3].tolist() == pytest.approx([0.1, 0.2])
    assert move.X_WT[2, 3] == pytest.approx(0.301 if "high:=1" in call else 0.3)
    assert move.speed.v_tcp == pytest.approx(0.1)


def test_text_after_the_module_is_reported_and_never_run() -> None:
    program = run(f'MODULE m\n{DATA}PROC main()\nENDPROC\nENDMODULE\nMoveL p,v100,fine,tool0; " ENDPROC\n')
    assert program.motions == ()
    assert tuple(map(str, program.warnings)) == (
        "m.mod:9:1: text after ENDMODULE (1 line) is not part of the program and does not run",
    )


def test_a_file_of_loose_declarations_is_read() -> None:
    assert len(run(f"{DATA}PROC main()\nMoveL p,v100,fine,tool0;\nENDPROC\n").motions) == 1


# ------------------------------------------------------------------------------------------------------------ marks


def test_a_mark_stands_behind_the_move_or_alone_above_it() -> None:
    body = (
        "MoveL p,v100,fine,tool0; MoveJ p,v100,fine,tool0; ! trajopt: optional\n"
        "MoveL p,v100,fine,\ntool0; !TRAJOPT:Optional\n"
        "! trajopt: optional\nMoveJ p,v100,fine,tool0; MoveL p,v100,fine,tool0;\n"
        "MoveAbsJ j,v100,fine,tool0; ! not trajopt: optional\n"
    )
    moves = [m for m in run_main(body).motions if isinstance(m, MOVES)]
    assert [m.optional for m in moves] == [False, True, True, True, False, False]


def test_a_mark_that_marks_nothing_is_an_error_and_one_on_no_move_is_said() -> None:
    assert error_main("WaitTime 1;\n! trajopt: optional\n\nWaitTime 1;") == (
        "m.mod:4:1: '! trajopt: optional' marks no instruction; put it after a move or on the line above it"
    )
    assert error_main("WaitTime 1; ! trajopt: optinal") == (
        "m.mod:3:13: there is no mark 'optinal'; the marks are 'optional', 'hold rail' and, with names, "
        "\"way around 'column'\""
    )
    assert tuple(map(str, run_main("WaitTime 1; ! trajopt: optional").warnings)) == (
        "m.mod:7:1: marked as optional, but no move ran there",
    )


def test_an_additional_point_says_what_it_goes_around() -> None:
    names = ("column", "bob's  fence", "'", "a, b")
    body = f"MoveJ p,v100,fine,tool0; {way_around(names)}\n! trajopt: Way  Around 'x'\nMoveAbsJ j,v100,fine,tool0;\n"
    moves = [m for m in run_main(body + "MoveJ p,v100,fine,tool0;").motions if isinstance(m, MOVES)]
    assert [m.marked for m in moves] == [("column", "bob's fence", "'", "a, b"), ("x",), ()]
    for wrong in ("way around", "way around column", "way around 'a' 'b'", "way around ''", "way around 'a"):
        assert "there is no mark" in error_main(f"MoveJ p,v100,fine,tool0; ! trajopt: {wrong}")


# -------------------------------------------------------------------------------------------------- broken meaning

P = DATA.splitlines()[0] + "\n"
LOOKED = (
    " (looked for in PROC main, MODULE m, the other modules' globals and the predefined data); "
    "give the file that declares it"
)


@pytest.mark.parametrize(
    "call",
    [
        *("GlueL q,a,s,g,t;", "MoveHome;", "FCPressL q,a,b,c;", "SpotMPL x;", "ArcMoveJ q;"),
        *("TriggLIOs x;", "SpeedLimAxis STN1,1,20;", "pathrecmovebwd;", "StepBwdPath 30,1;"),
        *("Go p;", "Go ps{2};", "Go 1,Offs(p,0,0,5);", "Go target();", "Go j;", "Go where:=p;", "Rush v100;"),
    ],
)
def test_no_stub_is_advised_for_what_moves_or_sets_speeds(call: str) -> None:
    text = error_main(call, DATA, "FUNC robtarget target()\nRETURN p;\nENDFUNC\n")
    place = f"m.mod:{DATA.count(chr(10)) + 3}:1"
    assert text.startswith(f"{place}: ")
    assert "stubs" not in text
    scenario = Scenario(stubs=frozenset({call.split()[0].strip(";").lower()}))
    rest = "FUNC robtarget target()\nRETURN p;\nENDFUNC\n"
    told = run_program(
        [TextFile("m.mod", f"MODULE m\n{DATA}PROC main()\n{call}\nENDPROC\n{rest}ENDMODULE\n", "utf-8")], scenario
    )
    assert [str(warning.place) for warning in told.warnings] == [place]


RAIL = "[9E9,9E9,9E9,9E9,9E9,9E9], with the rail's position in its place if the robot rides on one"


def test_a_rounded_orientation_is_taken_as_unit_and_said_once() -> None:
    body = "MoveL p,v100,fine,tool0; MoveL p,v100,fine,tool0;"
    assert tuple(map(str, run_main(body, P.replace("[0,0,1,0]", "[0,0.707,0.707,0]")).warnings)) == ()
    assert tuple(map(str, run_main(body, P.replace("[0,0,1,0]", "[0,0.708,0.707,0]")).warnings)) == (
        "m.mod:2:20: p has an orientation of length 1.000556; it is normalised",
    )


def test_files_and_entries_that_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read_program(tmp_path / "none.mod")
    assert str(caught.value) == f"{tmp_path / 'none.mod'}: cannot be read: No such file or directory"
    message = "m.mod: there is no PROC main(), nor another procedure without arguments to start with"
    assert error("MODULE m\nENDMODULE\n") == message
    assert error("") == "m.mod: holds no RAPID module"
    (tmp_path / "m.mod").write_text("MODULE m\nPROC go()\nWaitTime 2;\nENDPROC\nENDMODULE\n")
    assert len(read_program(tmp_path / "m.mod", entry="GO").motions) == 1


# ------------------------------------------------------------------------------------------------------------ speed


def test_a_small_program_is_read_without_heavy_imports() -> None:
    heavy = ("casadi", "pinocchio", "scipy", "toppra", "ruckig", "pydantic", "ruamel", "rich", "typer", "lark")
    code = (
        "import sys; from trajopt_cli.rapid.reader import read_program; "
        f"read_program({str(ROOT / 'programs' / 'hinge_cell.mod')!r}); "
        f"print([m for m in {heavy!r} if m in sys.modules])"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    assert answer.stdout.strip() == "[]"
