"""What a program finds out about its world: readings, waits, answers, and what is said where the cell file lacks it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveL, Program, SignalEvent, Source, TextFile, Wait
from trajopt_cli.rapid.data.datatypes import NUM
from trajopt_cli.rapid.execution.arguments import Effect, Topic
from trajopt_cli.rapid.execution.instructions import rows
from trajopt_cli.rapid.execution.table import FUNCTIONS, INSTRUCTIONS
from trajopt_cli.rapid.reader import run_program, try_program
from trajopt_cli.rapid.template import template
from trajopt_cli.scenario import Answer, Missing, Scenario, condition_key, yaml_answer, yaml_name

ARM = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\n"


def text_of(body: str, declared: str = "") -> list[TextFile]:
    return [TextFile("m.mod", f"MODULE m\n{declared}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n", "utf-8")]


def run(body: str, declared: str = "", scenario: Scenario | None = None) -> Program:
    return run_program(text_of(body, declared), scenario)


def times(body: str, declared: str = "", **scenario: object) -> list[float]:
    """What a program shows by `WaitTime value;`, waits for conditions left out."""
    program = run(body, declared, Scenario(**scenario))  # type: ignore[arg-type]
    return [one.duration for one in program.motions if isinstance(one, Wait) and one.condition is None]


def error(body: str, declared: str = "", **scenario: object) -> str:
    with pytest.raises(InputError) as caught:
        run(body, declared, Scenario(**scenario))  # type: ignore[arg-type]
    return str(caught.value)


# ---------------------------------------------------------------------------------------------------------- signals


@given(st.lists(st.integers(0, 3), min_size=1, max_size=12), st.integers(1, 15))
def test_reading_k_of_a_sequence_gives_its_value_k_and_the_last_one_for_ever(values: list[int], count: int) -> None:
    shown = times("WaitTime s;" * count, signals={"s": tuple(map(float, values))})
    assert shown == [float((values + [values[-1]] * count)[k]) for k in range(count)]


@given(st.lists(st.integers(0, 2), min_size=1, max_size=10), st.lists(st.integers(0, 2), max_size=4))
def test_waits_walk_through_a_sequence_as_a_search_from_the_last_place(values: list[int], wanted: list[int]) -> None:
    body = "".join(f"WaitDI s,{value};" for value in wanted) + "WaitTime s;"
    place: int | None = 0
    for value in wanted:
        place = next((k for k in range(place, len(values)) if values[k] == value), None)
        if place is None:
            assert f"WaitDI waits for s = {value}, and none of the values" in error(body, signals={"s": tuple(values)})
            return
    assert times(body, signals={"s": tuple(map(float, values))}) == [values[place or 0]]


def test_a_wait_for_an_inequality_leaves_a_plain_value_as_it_is() -> None:
    assert times("WaitAI a\\GT,5; WaitTime a;", signals={"a": 2.0}) == [2.0]
    assert "'a' is not declared in the program" in error("WaitAI a\\GT,5; WaitTime a;")


def test_what_the_program_sets_goes_before_the_cell_file() -> None:
    assert times("WaitTime d; SetDO d,0; WaitTime d; InvertDO d; WaitTime d;", signals={"d": (5.0, 6.0)}) == [5, 0, 1]
    assert times("InvertDO d; WaitTime d;", signals={"d": 1.0}) == [0]


def test_outputs_that_are_declared_begin_at_0_and_inputs_lack() -> None:
    assert times("WaitTime lamp;", "VAR signaldo lamp;") == [0.0]
    assert "add the line 'signals: {button: 0}'" in error("WaitTime button;", "VAR signaldi button;")


def test_a_delayed_output_knows_its_delay() -> None:
    (event,) = run("SetDO\\SDelay:=0.25,d,1;").motions
    assert isinstance(event, SignalEvent)
    assert event.delay == 0.25
    assert error("SetDO\\SDelay:=-1,d,1;") == "m.mod:4:15: \\SDelay of -1 s must not be negative"
    assert error("PulseDO\\PLength:=-1,d;") == "m.mod:4:18: \\PLength of -1 s must not be negative"
    assert error("SetGO g,1.5;") == "m.mod:4:9: SetGO g needs a whole number, 0 or more, found 1.5"


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            "EGMRunPose e;",
            "m.mod:4:1: EGMRunPose lets a sensor guide the robot, so its path is not in the program; leave it out",
        ),
        ("AliasIO a,n;", "m.mod:4:11: an alias is declared as a signal, 'VAR signaldi n;'"),
        ("WaitTime -1;", "m.mod:4:10: WaitTime -1 s must not be negative"),
        ("SocketListen n;", "m.mod:4:14: needs a socketdev, found n of type num"),
        ("TPReadFK n,a,b,c,d,e,f;", "m.mod:4:10: the answer 6 to 'n' in the cell file is not a key from 1 to 5"),
        ('SetDataVal "c",2;', "m.mod:4:12: 'c' is a CONST (line 2) and cannot be changed"),
        ('GetDataVal "t",n;', "m.mod:4:12: 't' is a string, and the value a num"),
    ],
)
def test_messages(body: str, message: str) -> None:
    declared = "VAR num n; CONST num c:=1; VAR string t;"
    assert error(body, declared, answers={"n": 6.0}) == message


# ------------------------------------------------------------------------------------------------------------ waits


@pytest.mark.parametrize(
    ("body", "waits", "seconds"),
    [
        ("WaitDI Di1,1;", {"di1": 2.0}, 2.0),
        ("WaitDI Di1,1;", {"di1": 2.0, "di1=1": 3.0}, 3.0),
        ("WaitDI Di1,1;", {"di1=0": 3.0}, 0.0),
        ("WaitGI g\\NOTEQ,4;", {"g<>4": 0.5}, 0.5),
        ("WaitUntil Di1 = 1;", {"di1=1": 0.75}, 0.75),
        ("WaitUntil DInput(Di1)>3;", {"di1": 0.75}, 0.75),
        ("WaitUntil Di1=1 OR Di2=1;", {"di1": 0.75}, 0.0),
        ("WaitUntil f{2} AND x=1;", {"f{2}andx=1": 0.25}, 0.25),
        ("WaitWObj wConv\\RelDist:=100;", {"wconv": 1.5}, 1.5),
    ],
)
def test_least_durations_by_condition_and_by_signal(body: str, waits: dict[str, float], seconds: float) -> None:
    (wait,) = run(body, "VAR bool f{2};", Scenario(waits=waits)).motions
    assert isinstance(wait, Wait)
    assert wait.duration == seconds


def test_a_wait_without_max_time_cannot_time_out() -> None:
    message = "m.mod:4:1: waits for di1 = 1 forever: the cell file says timeout, and \\MaxTime is not given"
    assert error("WaitDI di1,1;", waits={"di1": None}) == message


def test_a_condition_that_cannot_become_true_is_waited_for_and_leaves_the_sequences_where_they_were() -> None:
    assert times("WaitUntil a=7 OR b=7; WaitTime a; WaitTime b;", signals={"a": (1.0, 2.0), "b": 3.0}) == [1, 3]
    assert times("WaitUntil ClkRead(c)>4; WaitTime 1;", "VAR clock c;", answers={"c": 2.0}) == [1]


def test_conditions_with_calls_are_polled() -> None:
    functions = "FUNC bool Ready()\nRETURN s>1;\nENDFUNC"
    assert times("WaitUntil Ready(); WaitTime s; WaitTime s;", functions, signals={"s": (0.0, 1.0, 2.0, 9.0)}) == [2, 9]


def test_flags_in_arrays_come_true_and_parts_of_records_do_not() -> None:
    declared = "VAR bool f{2}; VAR pos p; CONST num c:=3; VAR num x:=2;"
    assert times("WaitUntil f{2} AND p.x=c; IF f{2} AND NOT f{1} WaitTime x+p.x;", declared) == [2]


# ---------------------------------------------------------------------------------------------------------- answers


def test_answers_go_by_the_whole_variable_and_take_the_next_value_each_time() -> None:
    body = 'FOR i FROM 1 TO 2 DO TPReadNum a{i},""; ENDFOR TPReadNum p.y,""; WaitTime 100*a{1}+10*a{2}+p.y;'
    assert times(body, "VAR num a{2}; VAR pos p;", answers={"a": (1.0, 2.0), "p": 3.0}) == [123]


@pytest.mark.parametrize(
    ("declared", "answer", "message"),
    [
        ("VAR num v;", True, "the answer true to 'v' in the cell file is not a number"),
        ("VAR bool v;", 1.0, "the answer 1 to 'v' in the cell file is not true or false"),
        ("VAR string v;", 12.0, "the answer 12 to 'v' in the cell file is not a text; put it in quotes"),
        ("VAR pos v;", 12.0, "the answer 12 to 'v' in the cell file is not a pos as RAPID writes it, in quotes"),
        (
            "VAR pos v;",
            "[1,2]",
            "the answer to 'v' in the cell file must be a pos such as [0,0,0]; it is not: pos needs 3 parts [x,y,z], "
            "found 2",
        ),
        (
            "VAR num v{2};",
            "1",
            "the answer to 'v' in the cell file must be a num{*} such as [0,0]; it is not a value in brackets",
        ),
    ],
)
def test_answers_of_another_type(declared: str, answer: Answer, message: str) -> None:
    assert error("ReadAnyBin d,v;", f"VAR iodev d; {declared}", answers={"v": answer}) == f"m.mod:4:14: {message}"


def test_arrays_are_asked_for_in_full_as_long_as_a_cell_file_can_hold_them() -> None:
    _, (lack,) = try_program(text_of("ReadAnyBin d,v;", "VAR iodev d; VAR num v{500};"))
    assert lack.value == f'"[{",".join("0" * 500)}]"'
    assert lack.line == 'answers: {v: "[' + "0," * 99 + "...}"
    message = "m.mod:4:14: 'v' is a num{*} with more values than a cell file can hold"
    assert error("ReadAnyBin d,v;", "VAR iodev d; VAR num v{1000,1000};") == message.replace("{*}", "{*,*}")


def test_the_first_key_that_is_labelled_stands_in() -> None:
    _, (lack,) = try_program(text_of('TPReadFK n,"?",stEmpty,""," ","Go","Stop";', "VAR num n;"))
    assert lack.value == "4"


def test_an_alias_that_is_declared_nowhere_stands_for_its_signal() -> None:
    program = run("AliasIO doReal,lamp; Set lamp;")
    (event,) = program.motions
    assert isinstance(event, SignalEvent)
    assert event.signal == "doreal"
    assert tuple(map(str, program.warnings)) == (
        "m.mod:4:16: alias 'lamp' is not declared in the files read; it is taken as a signal",
    )


def test_what_stands_in_ends_the_loops_that_read_files() -> None:
    body = "WHILE ReadStr(d)<>EOF DO WaitTime 1; ENDWHILE WHILE ReadNum(d)<9E36 DO WaitTime 2; ENDWHILE"
    program, lacks = try_program(text_of(body, 'VAR iodev d; CONST string EOF:="EOF";'))
    assert [m.condition for m in program.motions if isinstance(m, Wait)] == ["ReadStr", "ReadNum"]
    assert [(lack.name, lack.value) for lack in lacks] == [("ReadStr", '"EOF"'), ("ReadNum", "9.998e+36")]


# ------------------------------------------------------------------------------------------------- scenario template

ASKING = r"""
IF diPart=1 OR null=1 WaitTime 1;
TPReadFK key,"?","A","B",stEmpty,stEmpty,stEmpty;
SocketReceive s\Str:=order;
ready:=IsFile("x");
ReadAnyBin d,spot;
ReadAnyBin d,label;
WaitTime UINumEntry()+ClkRead(cycle);
"""
DECLARED = (
    "VAR num key; VAR socketdev s; VAR string order; VAR bool ready; VAR iodev d; VAR robtarget spot; "
    "VAR string label{2}; VAR clock cycle;"
)


def test_a_template_answers_everything_that_lacks() -> None:
    program, lacks = try_program(text_of(ASKING, DECLARED))
    text = template(lacks)
    scenario = parse_cell(ARM + text, "cell.yaml").scenario
    again, left = try_program(text_of(ASKING, DECLARED), scenario)
    assert len(lacks) == 9
    assert left == ()
    assert [type(one) for one in again.motions] == [type(one) for one in program.motions]
    assert text.splitlines()[:5] == [
        "signals:",
        "  diPart: 0  # m.mod:5:4, 'diPart' is not declared in the program and has no value as a signal",
        "  \"null\": 0  # m.mod:5:16, 'null' is not declared in the program and has no value as a signal",
        "answers:",
        "  key: 1  # m.mod:6:10, TPReadFK asks the operator for key, a key of 1..5",
    ]


def test_a_template_answers_for_tools_and_work_objects_that_can_be_moved_with() -> None:
    """A stationary tool with a fixed work object, as zeros would be, is no answer: no controller moves with it."""
    body = "MoveL [[0,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,grip()\\WObj:=table();"
    _, lacks = try_program(text_of(body))
    scenario = parse_cell(ARM + template(lacks), "cell.yaml").scenario
    (move,) = try_program(text_of(body), scenario)[0].motions
    assert isinstance(move, MoveL)
    assert (move.tool.name, move.wobj) == ("grip()", "table()")


def test_a_template_has_every_section_once_in_one_order() -> None:
    def lack(section: str, name: str, line: int, value: str, reason: str = "asks") -> Missing:
        return Missing(section, name, Source("a # b.mod", line, 2), reason, value)

    lacks = [
        lack("assume_identity", "tGrip", 9, "tGrip", "not declared"),
        lack("searches", "p_found", 8, "0.5", "two\nlines \x07"),
        lack("signals", "true", 6, "0"),
        lack("assume_identity", "w{1}", 10, "w{1}"),
    ]
    text = template(lacks)
    assert text == (
        'signals:\n  "true": 0  # a # b.mod:6:2, asks\n'
        "searches:\n  p_found: 0.5  # a # b.mod:8:2, two lines ?\n"
        'assume_identity:\n  - tGrip  # a # b.mod:9:2, not declared\n  - "w{1}"  # a # b.mod:10:2, asks\n'
    )
    scenario = parse_cell(ARM + text, "cell.yaml").scenario
    assert (scenario.signals, scenario.searches) == ({"true": 0.0}, {"p_found": 0.5})
    assert scenario.assume_identity == frozenset({"tgrip", "w{1}"})
    assert template([]) == ""


@given(
    st.text(st.characters(exclude_categories=("C", "Z")), min_size=1, max_size=30),
    st.one_of(
        st.floats(allow_nan=False, allow_infinity=False),
        st.booleans(),
        st.text(st.characters(exclude_categories=("C",)), max_size=30),
    ),
)
def test_names_and_answers_come_back_from_yaml_as_they_were(name: str, value: Answer) -> None:
    text = f"{ARM}answers:\n  {yaml_name(name)}: {yaml_answer(value)}\n"
    ((key, read),) = parse_cell(text, "cell.yaml").scenario.answers.items()
    assert key == name.lower()
    assert type(read) is type(value)
    assert read == value


def test_conditions_are_compared_without_blanks_and_case() -> None:
    assert condition_key(" DI_1 =\t1 AND  x ") == "di_1=1andx"


# ----------------------------------------------------------------------------------------------------------- tables


def test_no_name_has_two_meanings() -> None:
    for names in (INSTRUCTIONS, FUNCTIONS):
        assert len({name.lower() for name in names}) == len(names)
    with pytest.raises(AssertionError):
        Topic("again").enter(Effect.RUN, "MoveL")(lambda run, node: None)
    with pytest.raises(AssertionError):
        Topic("again").values("Offs", NUM)(float)


def unread(effect: Effect) -> list[str]:
    return [name for _, its, names in rows.UNREAD if its is effect for name in names.split()]


def test_everything_without_effect_is_counted_and_nothing_else_happens() -> None:
    for name in unread(Effect.IGNORED):
        program = run(f"{name} nobody; {name} \\x, nobody;")
        assert (program.motions, dict(program.ignored)) == ((), {name: 2})


def test_what_waits_for_somebody_outside_is_a_wait_of_its_least_time() -> None:
    for name in unread(Effect.STOPS):
        program = run(f"{name} nobody;", "", Scenario(waits={name.lower(): 0.5}))
        (wait,) = program.motions
        assert isinstance(wait, Wait)
        assert (wait.stops, wait.duration, program.ignored) == (True, 0.5, {})
        (wait,) = run(f"{name};").motions
        assert isinstance(wait, Wait)
        assert wait.stops


def test_what_has_no_time_out_cannot_time_out() -> None:
    with pytest.raises(InputError) as caught:
        run("WaitTime 1;\nStop;", "", Scenario(waits={"stop": None}))
    assert (caught.value.file, caught.value.line) == ("m.mod", 5)


# ------------------------------------------------------------------------------------------------- missing routines


def test_procedures_that_no_file_declares_do_nothing_where_the_cell_file_says_so() -> None:
    body = "WaitTime 1;\nOpenDoor 3\\Fast;\nopendoor;\nWaitTime 2;"
    assert [lack.name for lack in try_program(text_of(body))[1]] == ["OpenDoor"]
    program = run(body, "", Scenario(stubs=frozenset({"opendoor"})))
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [1, 2]
    assert program.ignored == {"OpenDoor": 1, "opendoor": 1}
    assert parse_cell(ARM + "stubs: [OpenDoor]\n", "cell.yaml").scenario.stubs == {"opendoor"}


def test_functions_that_no_file_declares_are_answered_by_the_cell_file() -> None:
    body = "IF DoorOpen(2) WaitTime Level();"
    assert [lack.line for lack in try_program(text_of(body))[1]] == ["answers: {DoorOpen: false}"]
    assert times(body, answers={"dooropen": True, "level": 2.5}) == [2.5]
    assert error(body, answers={"dooropen": 1.0}) == (
        "m.mod:4:4: the answer 1 to 'DoorOpen' in the cell file is not true or false"
    )
    assert error("WaitTime Ofs(1);") == (
        "m.mod:4:10: Ofs is neither a function of the files read nor a known function; did you mean 'Offs'? "
        "Else add the line 'answers: {Ofs: 0}' to the cell file"
    )
