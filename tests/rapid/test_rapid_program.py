"""What programs mean: values, flow, data, signals."""

from __future__ import annotations

import json
from collections.abc import Mapping
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import rotation_about, rotation_from_wxyz
from trajopt_cli.motion import (
    ConfData,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    SignalEvent,
    Source,
    Speed,
    TextFile,
    Wait,
    Zone,
)
from trajopt_cli.rapid.listing import describe
from trajopt_cli.rapid.reader import read_program, run_program
from trajopt_cli.scenario import Scenario

ROOT = Path(__file__).parents[2]
CASE = ROOT / "tests" / "data" / "cases" / "hinge_cell.json"


def run(text: str, scenario: Scenario | None = None) -> Program:
    return run_program([TextFile("m.mod", text, "utf-8")], scenario)


def run_main(body: str, data: str = "", rest: str = "", scenario: Scenario | None = None) -> Program:
    return run(f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\n{rest}\nENDMODULE\n", scenario)


def waits(body: str, data: str = "", rest: str = "", scenario: Scenario | None = None) -> list[float]:
    """Values shown by a program as `WaitTime value;`."""
    program = run_main(body, data, rest, scenario)
    return [motion.duration for motion in program.motions if isinstance(motion, Wait)]


def value(expression: str, data: str = "", rest: str = "") -> float:
    (seconds,) = waits(f"WaitTime {expression};", data, rest)
    return seconds


def truth(expression: str, data: str = "") -> bool:
    (seconds,) = waits(f"IF {expression} THEN WaitTime 1; ELSE WaitTime 0; ENDIF", data)
    return seconds == 1.0


def move(target: str, data: str = "", rest: str = "", options: str = "", tool: str = "tool0") -> MoveL:
    program = run_main(f"MoveL {target},v100,fine,{tool}{options};", data, rest)
    (motion,) = program.motions
    assert isinstance(motion, MoveL)
    return motion


P = "CONST robtarget p:=[[100,200,300],[0.5,0.5,0.5,0.5],[0,-1,2,1],[10,9E9,9E+09,9E9,9E9,-5]];\n"

# --------------------------------------------------------------------------------------------------- shipped cells


def test_the_hinge_cell_is_the_agreed_case() -> None:
    case = json.loads(CASE.read_text())
    program = read_program(ROOT / "programs" / "hinge_cell.mod")
    rails = {"n1": 200.0, "n2": 1350.0, "n3": 1900.0}
    assert len(program.motions) == len(case["program"])
    for motion, (kind, *rest) in zip(program.motions, case["program"], strict=True):
        if kind == "Wait":
            assert isinstance(motion, Wait)
            assert (motion.duration, motion.condition) == (rest[0], None)
            continue
        assert type(motion).__name__ == kind
        assert isinstance(motion, (MoveJ, MoveL, MoveAbsJ))
        assert motion.zone == Zone("fine", stop=True)
        if isinstance(motion, MoveAbsJ):
            np.testing.assert_allclose(motion.q, case["home_q"][1:], rtol=0, atol=1e-16)
            assert motion.extax == (0.0, None, None, None, None, None)
            continue
        pose = case["poses"][rest[0]]
        np.testing.assert_allclose(motion.X_WT[:3, 3], pose["xyz"], rtol=0, atol=1e-7)
        np.testing.assert_allclose(motion.X_WT[:3, :3], rotation_from_wxyz(pose["quat"]), rtol=0, atol=1e-7)
        assert motion.extax[0] == rails[rest[0][:2]]
        wanted = rest[1]["v"] if len(rest) > 1 else 2.5
        assert motion.speed.v_tcp == pytest.approx(wanted, abs=1e-15)
        assert motion.conf == ConfData(0, 0, 0, 0)
    assert tuple(map(str, program.warnings)) == ()
    assert program.name == "hinge_cell"


def test_the_bench_cell_does_three_rounds() -> None:
    program = read_program(ROOT / "programs" / "bench_irb140.mod")
    assert [type(m).__name__ for m in program.motions].count("MoveL") == 12
    listing = describe(program)
    assert listing.fly_by == 3
    # Per round 80 mm down (from RelTool above), 80 mm up, 80 mm down, 80 mm up, all along the vertical.
    assert listing.line_length == pytest.approx(3 * 4 * 80.0, abs=1e-9)
    places = [m.X_WT[:3, 3] for m in program.motions if isinstance(m, MoveL) and m.target == "p"]
    np.testing.assert_allclose(places, [[0.38, 0.12, 0.08], [0.44, 0.15, 0.08], [0.5, 0.18, 0.08]], atol=1e-15)
    events = [(m.signal, m.value) for m in program.motions if isinstance(m, SignalEvent)]
    assert events == [("do_gripper", 0.0), *[("do_gripper", 1.0), ("do_gripper", 0.0)] * 3]


# ------------------------------------------------------------------------------------------------------ expressions


@pytest.mark.parametrize(
    ("expression", "result"),
    [
        ("1+2*3", 7.0),
        ("7 DIV 2 + 7 MOD 2", 4.0),
        ("0-(-7 DIV 2)", 3.0),
        ("2 - -3", 5.0),
        (".5 + 1. + 1E-05 + 0x1F", 32.50001),
        ("10-4-3", 3.0),
        ("Abs(-2.5)", 2.5),
        ("Sin(30)+Cos(60)+Tan(45)", 2.0),
        ("ATan2(1,1)", 45.0),
        ("ACos(0)+ASin(1)+ATan(1)", 225.0),
        ("Sqrt(2)*Sqrt(2)", 2.0),
        ("Pow(2,10)", 1024.0),
        ("Round(2.5)+Trunc(2.9)", 5.0),
        ("Round(3.14159\\Dec:=2)", 3.14),
        ("Distance([0,0,0],[3,4,0])", 5.0),
        ("DotProd([1,2,3],[4,5,6])", 32.0),
        ("VectMagn([2,4,4])", 6.0),
        ("EulerZYX(\\Z,OrientZYX(30,20,10))", 30.0),
        ("EulerZYX(\\Y,OrientZYX(30,20,10))", 20.0),
        ("EulerZYX(\\X,OrientZYX(30,20,10))", 10.0),
        ('StrLen("a""b\\\\c\\41")', 6.0),
        ('StrLen(StrPart("abcdef",2,3))', 3.0),
        ("StrLen(NumToStr(3.14159,2)+ValToStr(TRUE))", 8.0),
        ("pi", pi),
    ],
)
def test_expressions_have_the_value_a_controller_gives(expression: str, result: float) -> None:
    assert value(expression) == pytest.approx(result, rel=2.4e-7)  # two roundings to 32 bits


@pytest.mark.parametrize(
    ("expression", "result"),
    [
        ("NOT FALSE AND FALSE", True),
        ("(NOT FALSE) AND FALSE", False),
        ("TRUE AND NOT FALSE", True),
        ("NOT TRUE OR TRUE", True),
        ("TRUE XOR TRUE", False),
        ("1 < 2 = TRUE", True),
        ('"a" + "b" = "ab"', True),
        ("[1,2,3] = a", True),
        ("a + [1,0,0] = [2,2,3]", True),
        ("a * [0,0,1] = [2,-1,0]", True),
        ("2 * a - a / 1 = a", True),
        ("-a <> a", True),
        ("TRUE OR 1/0 = 1", True),
    ],
)
def test_conditions_and_vectors(expression: str, result: bool) -> None:
    assert truth(expression, "CONST pos a:=[1,2,3];") is result


def test_orientations_compose_outer_first() -> None:
    data = f"{P}VAR robtarget r;\n"
    body = "r:=p; r.rot:=OrientZYX(90,0,0)*OrientZYX(0,0,90); MoveL r,v100,fine,tool0;"
    (motion,) = run_main(body, data).motions
    assert isinstance(motion, MoveL)
    wanted = rotation_about([0, 0, 1], pi / 2) @ rotation_about([1, 0, 0], pi / 2)
    np.testing.assert_allclose(motion.X_WT[:3, :3], wanted, atol=1e-15)


# ------------------------------------------------------------------------------------------------- data and routines


def test_names_do_not_care_about_case_and_shadow_from_inside_out() -> None:
    data = "VAR num Tool:=1; VAR num v10:=7;"
    rest = "PROC show(num TOOL)\nWaitTime tool;\nENDPROC"
    assert waits("WaitTime tOOL; SHOW 3; WaitTime V10;", data, rest) == [1.0, 3.0, 7.0]


def test_a_loop_variable_shadows_and_gives_back() -> None:
    assert waits("VAR num i:=9; FOR i FROM 1 TO 2 DO WaitTime i; ENDFOR WaitTime i;") == [1.0, 2.0, 9.0]


@pytest.mark.parametrize(
    ("bounds", "values"),
    [("1 TO 3", [1, 2, 3]), ("1 TO 0", [1, 0]), ("0 TO 1 STEP -1", []), ("0 TO 1 STEP 0.25", [0, 0.25, 0.5, 0.75, 1])],
)
def test_for_counts_as_rapid_does(bounds: str, values: list[float]) -> None:
    assert waits(f"FOR i FROM {bounds} DO WaitTime i; ENDFOR") == values


def test_while_test_if_and_return() -> None:
    body = """
    n:=0;
    WHILE TRUE DO
        Incr n;
        TEST n CASE 1,2: WaitTime 10; CASE 3: WaitTime 20; DEFAULT: WaitTime twice(n); ENDTEST
        IF n=5 RETURN;
        IF n>100 THEN WaitTime 99; ELSEIF n=4 THEN WaitTime 40; ELSE WaitTime 0; ENDIF
    ENDWHILE
    WaitTime 77;
    """
    rest = "FUNC num twice(num x)\nIF x>100 RETURN 0;\nRETURN 2*x;\nENDFUNC"
    assert waits(body, "VAR num n;", rest) == [10, 0, 10, 0, 20, 0, 8, 40, 10]


def test_parameters_by_copy_and_by_reference() -> None:
    body = "change a, b, c{2}, p.trans.x; WaitTime a; WaitTime b; WaitTime c{2}; WaitTime p.trans.x;"
    data = f"VAR num a:=1; VAR num b:=1; VAR num c{{3}}:=[1,1,1];\n{P.replace('CONST', 'VAR')}"
    rest = "PROC change(num a, INOUT num b, VAR num c, INOUT num x)\na:=5; b:=6; c:=7; Add x,1;\nENDPROC"
    assert waits(body, data, rest) == [1, 6, 7, 101]


def test_optional_parameters_are_present_or_passed_on() -> None:
    rest = """PROC outer(\\num t \\switch s)
        inner \\t?t \\s?s;
    ENDPROC
    PROC inner(\\num t \\switch s)
        IF Present(t) WaitTime t;
        IF Present(s) WaitTime 100;
        IF (NOT Present(t)) AND NOT Present(s) WaitTime 0;
    ENDPROC"""
    assert waits("outer; outer\\t:=3; outer\\s; outer\\t:=4\\s;", rest=rest) == [0, 3, 100, 4, 100]


def test_arrays_of_three_dimensions_and_of_records() -> None:
    data = "VAR num a{2,2,2}:=[[[1,2],[3,4]],[[5,6],[7,8]]];\nCONST pos b{2}:=[[1,2,3],[4,5,6]];\n"
    body = "a{2,1,2}:=60; WaitTime a{2,1,2}+a{1,2,1}+Dim(a,3); WaitTime b{2}.y; total a;"
    rest = "PROC total(num x{*,*,*})\nWaitTime x{1,1,1}+x{2,2,2};\nENDPROC"
    assert waits(body, data, rest) == [65, 5, 9]


def test_records_and_aliases_of_the_program() -> None:
    data = "RECORD part\nkilo weight;\npos at;\nENDRECORD\nALIAS num kilo;\nVAR part a:=[2.5,[1,2,3]];\n"
    assert waits("a.at.z:=a.at.z+a.weight; WaitTime a.at.z;", data) == [5.5]


def test_data_of_other_modules_is_seen_and_local_data_is_not() -> None:
    text = (
        "MODULE a\nPROC main()\nWaitTime shared; go;\nENDPROC\nENDMODULE\n"
        "MODULE b\nVAR num shared:=other+1;\nLOCAL CONST num other:=4;\n"
        "PROC go()\nWaitTime other;\nENDPROC\nENDMODULE\n"
    )
    assert [m.duration for m in run(text).motions if isinstance(m, Wait)] == [5, 4]
    with pytest.raises(InputError, match="'other' is not declared in the program"):
        run(text.replace("WaitTime shared;", "WaitTime other;"))


def test_exit_ends_the_run_and_handlers_do_not_run() -> None:
    rest = "PROC inner()\nEXIT;\nERROR\nWaitTime 50;\nENDPROC"
    assert waits("WaitTime 1; inner; WaitTime 2;", rest=rest) == [1]


# ---------------------------------------------------------------------------------------------------------- targets


def test_a_move_has_everything_in_si() -> None:
    data = f"{P}PERS tooldata t:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];\n"
    motion = move("p", data, tool="t", options="\\WObj:=wobj0\\TLoad:=load0")
    np.testing.assert_array_equal(motion.X_WT[:3, 3], [0.1, 0.2, 0.3])
    np.testing.assert_allclose(motion.X_WT[:3, :3], [[0, 0, 1], [1, 0, 0], [0, 1, 0]], atol=1e-15)
    np.testing.assert_array_equal(motion.tool.X_FT[:3, 3], [0, 0, 0.12])
    assert motion.conf == ConfData(0, -1, 2, 1)
    assert motion.extax == (10.0, None, None, None, None, -5.0)
    assert motion.speed == Speed("v100", 0.1, radians(500), 5.0, radians(1000))
    assert (motion.tool.name, motion.wobj, motion.duration, motion.optional) == ("t", "wobj0", None, False)
    assert motion.source == Source("m.mod", 6, 1)


def test_work_object_frames_stand_before_the_target() -> None:
    data = f'{P}TASK PERS wobjdata w:=[FALSE,TRUE,"",[[1000,0,0],[0.70710678,0,0,0.70710678]],[[0,0,50],[0,1,0,0]]];\n'
    motion = move("p", data, options="\\WObj:=w")
    # U: x by 1 m and 90 degrees about z; O: 50 mm up and 180 degrees about x; P: 100, 200, 300.
    np.testing.assert_allclose(motion.X_WT[:3, 3], [1.0 + 0.2, 0.1, 0.05 - 0.3], atol=1e-8)
    R = rotation_about([0, 0, 1], pi / 2) @ rotation_about([1, 0, 0], pi) @ rotation_from_wxyz([0.5, 0.5, 0.5, 0.5])
    np.testing.assert_allclose(motion.X_WT[:3, :3], R, atol=1e-8)
    assert motion.wobj == "w"


def test_offs_goes_along_the_work_object_and_keeps_the_rest() -> None:
    motion = move("Offs(p,1,-2,3.5)", P)
    np.testing.assert_allclose(motion.X_WT[:3, 3], [0.101, 0.198, 0.3035], atol=1e-15)
    assert (motion.conf, motion.extax) == (ConfData(0, -1, 2, 1), (10.0, None, None, None, None, -5.0))
    assert motion.target == "Offs(p,1,-2,3.5)"


def test_rel_tool_goes_along_the_tool_then_turns_about_its_new_axes() -> None:
    motion = move("RelTool(p,10,20,30\\Rx:=10\\Ry:=20\\Rz:=30)", P)
    R = rotation_from_wxyz([0.5, 0.5, 0.5, 0.5])
    np.testing.assert_allclose(motion.X_WT[:3, 3], [0.1, 0.2, 0.3] + R @ [0.01, 0.02, 0.03], atol=1e-15)
    turned = R
    for axis, angle in (([1, 0, 0], 10), ([0, 1, 0], 20), ([0, 0, 1], 30)):
        turned = turned @ rotation_about(axis, radians(angle))
    np.testing.assert_allclose(motion.X_WT[:3, :3], turned, atol=2e-7)


def test_pose_functions_agree_with_matrices() -> None:
    data = f"{P}CONST pose a:=[[1,2,3],[0.5,0.5,0.5,0.5]];\nVAR robtarget r;\n"
    body = (
        "r:=p; r.trans:=PoseVect(PoseInv(a),[4,5,6]); MoveL r,v100,fine,tool0;"
        "r.trans:=PoseVect(PoseMult(PoseInv(a),a),[4,5,6]); MoveL r,v100,fine,tool0;"
    )
    one, two = (m.X_WT[:3, 3] * 1e3 for m in run_main(body, data).motions if isinstance(m, MoveL))
    np.testing.assert_allclose(one, rotation_from_wxyz([0.5, 0.5, 0.5, 0.5]).T @ [3, 3, 3], atol=1e-12)
    np.testing.assert_allclose(two, [4, 5, 6], atol=1e-12)


def test_joint_and_external_moves() -> None:
    data = "CONST jointtarget j:=[[10,-20,30,0,90,-180],[500,9E9,9E9,9E9,9E9,9E9]];\n"
    first, second = run_main(
        "MoveAbsJ\\Conc,j\\NoEOffs,v50\\V:=75,z10\\Z:=12,tool0; MoveExtJ j,vlin100,fine;", data
    ).motions
    assert isinstance(first, MoveAbsJ)
    np.testing.assert_allclose(first.q, np.radians([10, -20, 30, 0, 90, -180]), atol=1e-15)
    assert (first.extax[0], first.speed.v_tcp, first.speed.name) == (500.0, 0.075, "v50")
    assert first.zone == Zone("z10", False, 0.012, 0.015, 0.015, radians(1.5), 0.015, radians(1.5))
    assert isinstance(second, MoveExtJ)
    assert (second.extax[0], second.speed.v_leax) == (500.0, 0.1)


@pytest.mark.parametrize(
    ("zone", "wanted"),
    [
        ("fine", Zone("fine", stop=True)),
        ("z0", Zone("z0", False, 3e-4, 3e-4, 3e-4, pytest.approx(radians(0.03)), 3e-4, pytest.approx(radians(0.03)))),
        ("z50\\Inpos:=inpos50", Zone("z50", stop=True, criterion="inpos50")),
        ("[TRUE,0,0,0,0,0,0]", Zone("[TRUE,0,0,0,0,0,0]", stop=True)),
    ],
)
def test_zones(zone: str, wanted: Zone) -> None:
    (motion,) = run_main(f"MoveL p,v100\\T:=2.5,{zone},tool0;", P).motions
    assert isinstance(motion, MoveL)
    assert motion.zone == wanted
    assert motion.duration == 2.5


@pytest.mark.parametrize(("name", "v_tcp"), [("v5", 0.005), ("v2500", 2.5), ("v7000", 7.0), ("vmax", 5.0)])
def test_predefined_speeds(name: str, v_tcp: float) -> None:
    (motion,) = run_main(f"MoveL p,{name},fine,tool0;", P).motions
    assert isinstance(motion, MoveL)
    assert motion.speed == Speed(name, pytest.approx(v_tcp), radians(500), 5.0, radians(1000))


# ------------------------------------------------------------------------------------------------- waits and signals

WAITS: Mapping[str, float] = {"DI_Ready": 0.5, "di2": 0.1, "di2=0": 0.25, "di1 = 1 and count>2": 2.0, "other": 1.5}


@pytest.mark.parametrize(
    ("body", "duration", "condition"),
    [
        ("WaitTime\\InPos,0.1;", 0.1, None),
        ("WaitDI di_ready,1\\MaxTime:=5;", 0.5, "di_ready = 1"),
        ("WaitDI di2,0;", 0.25, "di2 = 0"),
        ("WaitDI di2,1;", 0.1, "di2 = 1"),
        ("WaitUntil  di1=1  AND count > 2;", 2.0, "di1=1 AND count > 2"),
        ("WaitUntil\\InPos,other=1;", 1.5, "other=1"),
        ("WaitUntil DInput(other)=1 OR di2=1;", 0.0, "DInput(other)=1 OR di2=1"),
    ],
)
def test_waits_last_at_least_as_the_scenario_says(body: str, duration: float, condition: str | None) -> None:
    (wait,) = run_main(body, scenario=Scenario(waits=WAITS)).motions
    assert isinstance(wait, Wait)
    assert (wait.duration, wait.condition) == (pytest.approx(duration, rel=6e-8), condition)


def test_outputs_are_events_and_are_remembered() -> None:
    body = (
        "Set do1; Reset DO2; SetDO\\Sync,do3,high; SetGO go1,7; SetAO ao1,2.5; PulseDO\\PLength:=0.2,do1; InvertDO do1;"
        "IF do1=0 AND GOutput(go1)=7 WaitTime 1;"
    )
    program = run_main(body)
    assert [(m.signal, m.value) for m in program.motions if isinstance(m, SignalEvent)] == [
        *(("do1", 1.0), ("do2", 0.0), ("do3", 1.0), ("go1", 7.0), ("ao1", 2.5)),
        *(("do1", 0.0), ("do1", 0.0)),  # a pulse of a set output, which is then inverted
    ]
    assert isinstance(program.motions[-1], Wait)


def test_signals_come_from_the_scenario_by_name_and_through_parameters() -> None:
    rest = "PROC ask(VAR signaldi s)\nIF s=1 WaitTime 2;\nWaitDI s,1;\nENDPROC"
    program = run_main("IF di1=1 AND TestDI(DI1) WaitTime 1; ask di1;", rest=rest, scenario=Scenario({"di1": 1.0}))
    assert [m.duration for m in program.motions if isinstance(m, Wait)] == [1, 2, 0]


def test_instructions_without_effect_on_motion_are_read_over() -> None:
    body = (
        'TPErase; TPWrite "x"\\Num:=undeclared; ClkStart c; ConfL\\On; ConfJ; AccSet 100,100; SingArea\\Off; WaitRob;'
    )
    assert run_main(body, "VAR clock c;").motions == ()


def test_a_loop_may_run_exactly_as_often_as_the_scenario_allows() -> None:
    body = "FOR j FROM 1 TO 2 DO FOR i FROM 1 TO 3 DO WaitTime i; ENDFOR ENDFOR"
    assert len(waits(body, scenario=Scenario(pass_limit=3))) == 6
    with pytest.raises(InputError, match=r"m.mod:4:22: the loop has not ended after 2 passes"):
        waits(body, scenario=Scenario(pass_limit=2))


# ----------------------------------------------------------------------------------------------------------- listing


def test_a_line_begins_where_the_tool_of_the_line_stands() -> None:
    data = (
        "CONST robtarget a:=[[500,0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        "PERS tooldata t:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];\n"
    )
    body = "MoveL a,v100,fine,tool0; MoveL a,v100,z10,t; MoveL Offs(a,30,40,0),v100,fine,t; WaitDI x,1;"
    listing = describe(run_main(body, data))
    # The first line's start is unknown; tool t's tip is 100 mm below tool0's, so the second line is 100 mm up.
    assert listing.line_length == pytest.approx(100.0 + 50.0, abs=1e-9)
    assert listing.fly_by == 1
    row = listing.rows[2]
    assert (row.instruction, row.target, row.index, row.zone, row.stop) == ("MoveL", "Offs(a,30,40,0)", 2, "fine", True)
    assert row.position == pytest.approx((530, 40, 400))
    assert row.orientation == pytest.approx((0, 0, 1, 0))
    assert listing.rows[3].instruction == "WaitDI"
    assert listing.rows[3].target == "x = 1"


def test_angles_come_back_in_degrees() -> None:
    (row,) = describe(run_main("MoveAbsJ [[1,2,3,4,5,6],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;")).rows
    assert row.joints == pytest.approx((1, 2, 3, 4, 5, 6), abs=1e-12)
    assert row.extax == (None,) * 6
