"""Mechanical units: whose axes a target moves, which may be active together, and what moves by itself."""

from __future__ import annotations

from math import degrees, pi

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.motion import Hold, Move, MoveJ, Program, TextFile, Wait
from trajopt_cli.problem.plannable import check_plannable
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.rapid.reader import run_program, try_program
from trajopt_cli.rapid.zones import stopped_fly_bys
from trajopt_cli.scenario import MissingError, Scenario
from trajopt_cli.warnings import WarningKind

TABLE = '{{eax: {}, frame: {{position: [0.5, {}, 0.1]}}, range: "[-185, 185] deg", velocity: 90 deg/s, \
acceleration: 180 deg/s2, start: {} deg, source: "a test"}}'
HOME = 'start: {joints: "[0, 0, 0, 0, 30, 0] deg"'
ONE = f"robot: irb140\n{HOME}}}\npositioners:\n  STN1: {TABLE.format('b', 0.3, 0)}\n"
TWO = ONE.replace("}\n", "%s}\n", 1) + f"  STN2: {TABLE.format('b', -0.3, 10)}\n"
RAIL = f"robot: irb140_rail\n{HOME}, rail: 0}}\nrail: {{eax: a, stroke: [-0.2, 2.2]%s}}\n"
DATA = """PERS wobjdata w1:=[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],[[100,0,0],[1,0,0,0]]];
PERS wobjdata w2:=[FALSE,FALSE,"Stn2",[[0,0,0],[1,0,0,0]],[[100,0,0],[1,0,0,0]]];
PERS wobjdata belt:=[FALSE,FALSE,"%s",[[0,0,0],[1,0,0,0]],[[500,0,0],[1,0,0,0]]];
"""


def at(a: object = "9E9", b: object = "9E9", x: float = 0) -> str:
    return f"[[{x},0,300],[0,0,1,0],[0,0,0,0],[{a},{b},9E9,9E9,9E9,9E9]]"


def joints(a: object = "9E9", b: object = "9E9") -> str:
    return f"[[0,0,0,0,30,0],[{a},{b},9E9,9E9,9E9,9E9]]"


def go(target: str, wobj: str = "wobj0", zone: str = "fine") -> str:
    return f"MoveJ {target},v1000,{zone},tool0\\WObj:={wobj}; "


def scenario(cell: str) -> Scenario:
    return parse_cell(cell, "c.yaml").scenario


def read(body: str, cell: str = ONE, unit: str = "CNV1", rest: str = "") -> Program:
    """main begins in line 6."""
    text = f"MODULE m\n{DATA % unit}PROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], scenario(cell))


def moves(program: Program) -> list[Move]:
    return [motion for motion in program.motions if isinstance(motion, Move)]


def turns(program: Program) -> list[list[tuple[str, float, float]]]:
    """What turns in each move, from and to where [deg]."""
    return [
        [(one.unit, round(degrees(one.start), 6), round(degrees(one.end), 6)) for one in move.units]
        for move in moves(program)
    ]


def place(program: Program, index: int) -> list[float]:
    move = moves(program)[index]
    assert isinstance(move, MoveJ)
    return [round(float(value), 9) for value in move.X_WT[:3, 3]]


def told(program: Program, kind: WarningKind) -> list[int]:
    """The lines of the notices of a kind."""
    return [one.place.line for one in program.warnings if one.kind is kind]  # type: ignore[union-attr]


# ------------------------------------------------------------------------------------------ whose axes a target moves


def test_a_unit_that_is_not_active_stands_whatever_targets_say() -> None:
    """Beyond its range, too; the work object stands with it, and active again it begins where it stands."""
    body = go(at(b=90), "w1") + "DeactUnit STN1; " + go(at(b=-45), "w1") + "MoveAbsJ " + joints(b=700)
    body += ",v1000,fine,tool0; MoveExtJ " + joints(b=20) + ",vrot50,fine;\nActUnit STN1; " + go(at(b=0), "w1")
    program = read(body)
    assert turns(program) == [[("stn1", 0, 90)], [], [], [], [("stn1", 90, 0)]]
    assert place(program, 0) == place(program, 1) == [0.5, 0.4, 0.4]  # 100 mm out, turned by 90 deg
    assert place(program, 4) == [0.6, 0.3, 0.4]
    assert told(program, WarningKind.NO_EFFECT) == [6]


def test_a_unit_that_never_was_active_stands_at_its_start() -> None:
    program = read(go(at(b=45), "w2"), TWO % ", units: []")
    a = pi / 18
    np.testing.assert_allclose(place(program, 0)[:2], [0.5 + 0.1 * np.cos(a), -0.3 + 0.1 * np.sin(a)], atol=1e-9)
    assert turns(program) == [[]]


def test_units_on_one_axis_take_turns() -> None:
    body = "ActUnit STN1; " + go(at(b=45), "w1") + "DeactUnit STN1; ActUnit STN2; " + go(at(b=-30), "w2")
    body += go(at(b=0), "w1") + "DeactUnit STN2; ActUnit STN1; " + go(at(b=90), "w1")
    body += "DeactUnit STN1; ActUnit STN2; " + go(at(b=0), "w2")
    program = read(body, TWO % "")
    assert turns(program) == [[("stn1", 0, 45)], [("stn2", 10, -30)], [("stn2", -30, 0)], [("stn1", 45, 90)], []]
    x = 0.1 * 0.5**0.5
    assert place(program, 2)[:2] == [round(0.5 + x, 9), round(0.3 + x, 9)]  # as STN1 was left
    assert {one.column for move in moves(program) for one in move.units} == {"eax_b_stn1", "eax_b_stn2"}
    check_plannable(program, build_plant(parse_cell(TWO % "", "c.yaml")))


def test_a_rail_without_its_unit_is_held_and_stays() -> None:
    body = go(at(a=300)) + "DeactUnit Track1; " + go(at(a=7000)) + "WaitTime 1;" + go(at()) + "ActUnit TRACK1; "
    program = read(body + go(at(a=100)), RAIL % ", unit: TRACK1")
    assert [move.extax[0] for move in moves(program)] == [300, None, None, 100]
    assert [one.hold for one in program.motions if isinstance(one, Move) or one.duration] == [  # type: ignore[union-attr]
        None, Hold.UNIT, Hold.UNIT, Hold.UNIT, None,
    ]  # fmt: skip


def test_an_inactive_rail_at_the_start_is_held_from_there() -> None:
    cell = (RAIL % ", unit: TRACK1").replace("rail: 0", "rail: 0, units: []")
    assert [one.hold for one in moves(read(go(at(a=300)), cell))] == [Hold.UNIT]


@pytest.mark.parametrize("name", ["ActUnit", "DeactUnit"])
@pytest.mark.parametrize("unit", ["STN1", "STN7"])
def test_the_point_before_is_a_stop(name: str, unit: str) -> None:
    program = read(f"{go(at(b=0), zone='z50')} {name} {unit}; {go(at(b=0, x=99))}")
    assert list(stopped_fly_bys(program)) == [0]
    wait = program.motions[1]
    assert isinstance(wait, Wait)
    assert wait.stops
    assert wait.duration == 0


def test_the_controller_says_which_units_are_active_and_where_they_are() -> None:
    """A unit reaches a routine as an argument; 9E9 is what CRobT and CJointT say of one that stands."""
    rest = "PROC off(VAR mecunit u)\nDeactUnit u;\nENDPROC\nVAR robtarget p;\nVAR jointtarget j;\n"
    body = go(at(b=45), "w1") + "p:=CRobT(); off STN1; "
    body += "IF p.extax.eax_b=45 AND IsMechUnitActive(STN1)=FALSE " + go(at(b=45, x=9))
    cell_with_robot = parse_cell(ONE, "c.yaml")
    assert len(moves(read(body, rest=rest))) == 2
    from trajopt_cli.problem.programmed import PlantKinematics

    text = f"MODULE m\n{rest}PROC main()\n{go(at(b=45))} off STN1; p:=CRobT(); j:=CJointT();\n"
    text += f"IF p.extax.eax_b>8E9 AND j.extax.eax_b>8E9 {go(at(b=45, x=9))}\nENDPROC\nENDMODULE\n"
    kinematics = PlantKinematics(build_plant(cell_with_robot))
    text = text.replace("[[0,0,300]", "[[500,0,300]")
    program = run_program([TextFile("m.mod", text, "utf-8")], cell_with_robot.scenario, kinematics=kinematics)
    assert len(moves(program)) == 2


def test_two_active_units_on_one_axis_are_an_error() -> None:
    with pytest.raises(InputError) as caught:
        read("ActUnit STN1;\nActUnit STN2;", TWO % "")
    assert caught.value.line == 7


def test_9e9_on_an_active_axis_is_told_and_on_another_is_not() -> None:
    body = go(at(b=0)) + "DeactUnit STN1; " + go(at()) + "ActUnit STN1;\n"
    assert told(read(body + go(at(b=0))), WarningKind.DOUBTFUL) == []
    assert told(read(body + "MoveAbsJ " + joints() + ",v1000,fine,tool0;"), WarningKind.DOUBTFUL) == [7]


@pytest.mark.parametrize(
    ("cell", "line"),
    [
        (TWO % ", units: [STN1, STN2]", 2),
        (TWO % ", units: [STN3]", 2),
        (RAIL % ", unit: STN1" + f"positioners: {{STN1: {TABLE.format('b', 0, 0)}}}", 3),
        (RAIL % "" + f"positioners: {{STN1: {TABLE.format('a', 0, 0)}}}", 4),
        (
            f"robot: irb140\n{HOME}}}\npositioners:\n  STN1:\n" + 2 * f"  - {TABLE.format('b', 0, 0)}\n",
            4,
        ),
    ],
)
def test_units_of_a_cell_that_cannot_be(cell: str, line: int) -> None:
    with pytest.raises(InputError) as caught:
        parse_cell(cell, "c.yaml")
    assert caught.value.line == line


# ------------------------------------------------------------------------------------------------ what moves by itself


@pytest.mark.parametrize(
    ("body", "cell", "lines"),
    [
        (f"{go(at(b=0))}\nDeactUnit TRACK1;", RAIL % "", [7]),  # may be the rail
        (f"{go(at(b=0))}\nDeactUnit STN7;", RAIL % ", unit: TRACK1", []),
        (f"{go(at(b=0))}\nDeactUnit TRACK1;", ONE, []),
        (f"{go(at(b=0))}\nIndCMove STN1,1,30;\n{go(at(b=0), 'w1')}", ONE, [7, 8]),
        (f"{go(at(b=0))}\nIndAMove STN1,1\\ToAbsNum:=90,30;", ONE, [7]),
        (f"{go(at(b=0))}\nIndDMove TRACK1,1,90,30;", RAIL % ", unit: TRACK1", [7]),
        (f"{go(at(b=0))}\nIndRMove M7DM1,1\\ToRelNum:=90\\Fwd,30;", RAIL % "", [7]),
        (
            f"{go(at(b=0))}\nIndReset STN1,1\\RefNum:=0\\Short;\nIndCMove EXTR,1,30; WaitUntil IndSpeed(EXTR,1);",
            ONE,
            [],
        ),
        (f"WaitWObj belt\\RelDist:=5;\n{go(at(), 'belt')}\nDropWObj belt;", RAIL % "", [6, 7, 8]),
        (f"{go(at(), 'belt')}", ONE, [6]),
        (
            "ActUnit CNV1;\nWaitSensor SSYNC1\\RelDist:=5;\nSyncToSensor SSYNC1\\On;\nDropSensor SSYNC1;",
            ONE,
            [6, 7, 8, 9],
        ),
    ],
)
def test_what_no_plan_can_follow_is_refused_by_line(body: str, cell: str, lines: list[int]) -> None:
    program = read(body, cell)
    assert [one.source.line for one in program.refusals] == lines
    if lines:
        with pytest.raises(InputError) as caught:
            check_plannable(program, build_plant(parse_cell(cell, "c.yaml")))
        assert caught.value.line == lines[0]


@pytest.mark.parametrize("unit", ["ROB_2", "rob_l", "ROB2", "T_ROB2", "Robot1"])
def test_work_that_another_robot_carries_is_refused_and_no_frame_is_asked_for(unit: str) -> None:
    text = f"MODULE m\n{DATA % unit}PROC main()\n{go(at(), 'belt')}\nENDPROC\nENDMODULE\n"
    program, lacking = try_program([TextFile("m.mod", text, "utf-8")], scenario(ONE))
    assert (len(lacking), [one.source.line for one in program.refusals]) == (0, [6])


def test_a_belt_by_another_name_is_known_by_what_waits_for_it() -> None:
    text = f"MODULE m\n{DATA % 'L3'}PROC main()\n{go(at(), 'belt')}\n%s\nENDPROC\nENDMODULE\n"
    for wait, lacks, refused in (("", 1, []), ("WaitWObj belt;\n" + go(at(), "belt"), 0, [7, 8])):
        program, lacking = try_program([TextFile("m.mod", text % wait, "utf-8")], scenario(ONE))
        assert len(lacking) == lacks
        assert [one.source.line for one in program.refusals] == refused


def test_instructions_about_loads_of_units_change_nothing() -> None:
    data = "PERS loaddata l:=[100,[0,0,50],[1,0,0,0],0,0,10];"
    body = f"MechUnitLoad STN1,1,l; LoadId 1,2,tool0; HollowWristReset; {go(at(b=0))}"
    program = read(body, rest=data)
    assert set(program.ignored) == {"MechUnitLoad", "LoadId", "HollowWristReset"}
    assert len(program.motions) == 1


# -------------------------------------------------------------------------------------------- functions nobody knows


@pytest.mark.parametrize(
    ("condition", "answer", "close"),
    [
        ("IndInpso(STN1,1)", "false", "IndInpos"),
        ("IndInpso(STN1,1)=TRUE", "false", "IndInpos"),
        ("NOT(TRUE=IndInpso(STN1,1)) OR di1=1", "false", "IndInpos"),
        ("di1=1 AND Far(3)>2", "0", None),
        ('Name(1)="x"', '""', None),
    ],
)
@pytest.mark.parametrize("statement", ["WaitUntil {};", "WaitUntil {}\\MaxTime:=3;"])
def test_a_wait_for_a_function_nobody_knows_lacks_its_answer(
    statement: str, condition: str, answer: str, close: str | None
) -> None:
    with pytest.raises(MissingError) as caught:
        read(go(at(b=0)) + statement.format(condition))
    (lack,) = caught.value.missing
    assert (lack.section, lack.source.line, lack.value, lack.close) == ("answers", 6, answer, close)


def test_a_function_with_an_answer_or_known_to_rapid_is_a_wait_like_any_other() -> None:
    waits = "WaitUntil Far(3)=TRUE; WaitUntil IndInpos(EXTR,1)=TRUE; WaitUntil IndSpeed(EXTR,1\\InSpeed);"
    program = read(waits + go(at(b=0)), ONE + "answers: {Far: true}")
    assert [one.condition for one in program.motions[:3] if isinstance(one, Wait)] == [
        "Far(3)=TRUE", "IndInpos(EXTR,1)=TRUE", "IndSpeed(EXTR,1\\InSpeed)",
    ]  # fmt: skip


@pytest.mark.parametrize("condition", ["Foo()=TRUE", "TRUE<>Foo()", "Foo()"])
def test_if_and_while_take_such_a_function_for_what_it_is_held_against(condition: str) -> None:
    for statement in (f"IF {condition} Stop;", f"WHILE {condition} DO ENDWHILE", f"b:={condition};"):
        with pytest.raises(MissingError) as caught:
            read(go(at(b=0)) + statement, rest="VAR bool b;")
        assert [one.value for one in caught.value.missing] == ["false"]
