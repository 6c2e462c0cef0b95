"""What fuzzing found: programs that once ended in a traceback, a hang or a wrong tree."""

from __future__ import annotations

from time import process_time

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Program, TextFile, Wait
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario


def error(body: str, data: str = "") -> str:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"
    with pytest.raises(InputError) as caught:
        run_program([TextFile("m.mod", text, "utf-8")])
    return caught.value.message


@pytest.mark.parametrize(
    ("data", "body"),
    [
        ("", "FOR i FROM 1 TO 90000 DO FOR j FROM 1 TO 90000 DO ENDFOR ENDFOR"),
        ("VAR num n; FUNC num f(num k) IF k<2 RETURN 1; RETURN f(k-1)+f(k-1); ENDFUNC", "n:=f(60);"),
        ("VAR num n;", "FOR i FROM 1 TO 90000 DO FOR j FROM 1 TO 90000 DO n:=Abs(n)+Abs(n); ENDFOR ENDFOR"),
        ("VAR num n;", f"FOR i FROM 1 TO 90000 DO n:={'+'.join(['1'] * 5000)}; ENDFOR"),
        ("PROC q() VAR num n{50}:=[" + "1," * 49 + "1]; ENDPROC", "FOR i FROM 1 TO 90000 DO q; ENDFOR"),
    ],
)
def test_all_work_is_charged_to_one_budget(data: str, body: str) -> None:
    run = Scenario(statement_limit=1_000)
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"
    begun = process_time()
    with pytest.raises(InputError, match=r"has not ended after 1000 statements \(statement_limit\)"):
        run_program([TextFile("m.mod", text, "utf-8")], run)
    assert process_time() - begun < 5


def test_a_copy_of_a_large_array_costs_no_more_than_a_number() -> None:
    text = (
        "MODULE m\nVAR robtarget a{50000};\nVAR robtarget c{50000};\nPROC main()\nFOR i FROM 1 TO 300 DO c:=a; ENDFOR\n"
        "WaitTime c{1}.trans.x;\nENDPROC\nENDMODULE\n"
    )
    begun = process_time()
    assert len(run_program([TextFile("m.mod", text, "utf-8")]).motions) == 1
    assert process_time() - begun < 5


DATA = "VAR robtarget g; VAR num n; VAR bool f; VAR bool s{2}; CONST num k:=1;\n"


def read(body: str, scenario: Scenario | None = None) -> Program:
    text = f"MODULE m\n{DATA}PROC main()\n{body}\nENDPROC\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], scenario)


def waits(program: Program) -> list[float]:
    return [motion.duration for motion in program.motions if isinstance(motion, Wait)]


def test_a_wait_makes_up_no_position() -> None:
    program = read("WaitUntil g.trans.y=1500 AND n=4 AND s{2}\\PollRate:=1; IF s{2} WaitTime g.trans.y+n;")
    assert waits(program) == [0, 4]
    (warning,) = program.warnings
    assert str(warning) == ("m.mod:4:1: WaitUntil g.trans.y=1500 AND n=4 AND s{2} is taken to come true; g is not "
                            "changed")  # fmt: skip
    assert tuple(map(str, read("WaitUntil g.trans.y=0;").warnings)) == ()


@pytest.mark.parametrize(
    "wait", ["FALSE", "n=1 AND n=2", "do1=1 AND do1=0", "k=2", "f AND NOT f", "TestDI(do1) AND do1=0", "NOT TRUE"]
)
def test_a_wait_that_cannot_come_true(wait: str) -> None:
    message = f"waits for {wait}: this condition can never come true, and \\MaxTime is not given"
    assert error(f"WaitUntil {wait};", DATA) == message
    assert waits(read(f"WaitUntil {wait} \\MaxTime:=3 \\TimeFlag:=f; IF f WaitTime 1;")) == [3, 1]


@pytest.mark.parametrize("body", ["WaitDI d,1;", "IF TestDI(d) n:=1;", "n:=DInput(d);", "SetDO d,1;"])
def test_a_digital_signal_is_0_or_1(body: str) -> None:
    for value in (0.5, (1.0, 0.5)):
        (warning,) = tuple(map(str, read(body, Scenario(signals={"d": value})).warnings))
        assert warning.endswith("d is 0.5 in the cell file, and a digital signal is 0 or 1")
    assert tuple(map(str, read(body, Scenario(signals={"d": (0.0, 1.0)})).warnings)) == ()
    assert waits(read("WaitTime AInput(d);", Scenario(signals={"d": 0.5}))) == [0.5]


def test_a_signal_too_large_for_a_num_is_an_error() -> None:
    with pytest.raises(InputError, match=r"the value 1e\+40 of signal 'd' is too large for a num"):
        read("n:=d;", Scenario(signals={"d": 1e40}))


def test_names_in_the_cell_file_that_nobody_asks_for() -> None:
    scenario = Scenario(
        signals={"d": 1, "Unknown": 3, "other": 2},
        waits={"d": 1, "nope": 2, "d = 0": 1},
        answers={"n": 1, "no": 2},
        searches={"x": 0.5},
        stubs=frozenset({"theirs", "mine"}),
    )
    program = read('WaitDI d,1; TPReadNum n,"n?"; theirs;', scenario)
    assert tuple(map(str, program.warnings)) == (
        "the program never uses Unknown, other (signals in the cell file)",
        "the program never uses no (answers in the cell file)",
        "the program never uses d = 0, nope (waits in the cell file)",
        "the program never uses x (searches in the cell file)",
        "the program never uses mine (stubs in the cell file)",
    )
    with pytest.raises(InputError) as caught:
        read("WaitTime e;", scenario)
    assert "never asks" not in str(caught.value)


TARGET = "CONST robtarget p:=[[450,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nVAR robtarget g;\n"


def test_nul_bytes_in_a_string_are_told_of() -> None:
    program = read('WaitTime StrLen("a\x00b");')
    assert waits(program) == [3]
    assert tuple(map(str, program.warnings)) == ("m.mod:4:17: NUL bytes inside a string stay in it",)


def test_answers_keep_to_the_limits_of_literals() -> None:
    with pytest.raises(InputError, match="the answer to 'UIAlphaEntry' in the cell file has 81 characters, limit 80"):
        read("WaitTime StrLen(UIAlphaEntry());", Scenario(answers={"uialphaentry": "x" * 81}))
    with pytest.raises(InputError, match=r"the answer 1e\+40 to 'n' in the cell file is too large for a num"):
        read('TPReadNum n,"";', Scenario(answers={"n": 1e40}))
