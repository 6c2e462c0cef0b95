from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rail_plans import J1, J2, changed_lines, made, plan_for, read_back, unified_diff

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.exporters.rapid_check import mismatches, read_again
from trajopt_cli.motion import ConfData, MoveAbsJ, MoveC, MoveExtJ, MoveJ, MoveL, Program, TextFile, Wait
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import EditableText
from trajopt_cli.problem.move_call import read_move
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.problem.scopes import names_in
from trajopt_cli.rapid.reader import read_program, run_program
from trajopt_cli.robot.inverse import confdata
from trajopt_cli.scenario import RailUnit, Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
MOVES = (MoveJ, MoveL, MoveAbsJ, MoveExtJ)


def test_named_arguments_keep_their_names_where_a_target_is_exchanged(plant: Plant) -> None:
    body = (
        "        MoveJ ToPoint:=p1,Speed:=v100,Zone:=fine,Tool:=tool0;\n"
        "        MoveL ToPoint:=Offs(Point:=p1,XOffset:=0,YOffset:=0,ZOffset:=50),Speed:=v100,fine,Tool:=tool0;\n"
    )
    program = made(body)
    export = export_rapid(program, plan_for(program, plant, {0: 0.25, 1: 0.3}), plant)
    text = export.texts["m.mod"]
    assert "MoveJ ToPoint:=RailAt(p1,250\\conf:=[-1,0,-1,0]),Speed:=v100,Zone:=fine,Tool:=tool0;" in text
    moved = "RailAt(Offs(Point:=p1,XOffset:=0,YOffset:=0,ZOffset:=50),300\\conf:=[-1,0,-1,0])"
    assert f"MoveL ToPoint:={moved},Speed:=v100,fine,Tool:=tool0;" in text
    again = read_back(program, export)
    assert [plant.rail_value(move.extax)[0] for move in again.motions] == pytest.approx([0.25, 0.3])
    assert [*names_in("MoveL ToPoint:=p, Zone := fine, t{n}\\WObj:=w;")] == ["MoveL", "p", "fine", "t", "n", "w"]


@pytest.mark.parametrize("name", ["MoveC", "ArcC", "CapC", "DispC", "PaintC"])
def test_the_circle_point_of_every_arc_is_known(name: str) -> None:
    data = {"ArcC": "s,w,", "CapC": "c,w,", "DispC": "b,"}.get(name, "")
    via = "[[550,100,450],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]"
    text = f"{name} CirPoint:={via},ToPoint:=p1,Speed:=v100,{data}fine,Tool:=tool0;"
    move = made(f"        {text}\n").motions[0]
    assert isinstance(move, MoveC)
    call, start = read_move(move, text), move.written.statement.start
    parts = (call.via, call.target, call.speed, call.tool)
    assert [text[p.start - start : p.end - start] for p in parts if p] == [via, "p1", "v100", "tool0"]


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_cell.yaml"))


# ------------------------------------------------------------------------------------------------- the shipped cells

HINGE_RAILS = {0: 0.25, 1: 0.1234567891, 2: 0.3, 3: 0.35, 4: 1.2, 5: 1.3, 6: 1.5, 7: 1.55, 8: 1.8, 9: 1.75, 10: 1.6}
HINGE_RAILS |= {11: 1.5, 12: 0.0}


def test_every_motion_of_the_hinge_cell_reads_back_as_planned(plant: Plant) -> None:
    program = read_program(PROGRAMS / "hinge_cell.mod")
    plan = plan_for(program, plant, HINGE_RAILS)
    again = read_back(program, export_rapid(program, plan, plant))
    assert len(again.motions) == 13
    for old, new, planned in zip(program.motions, again.motions, plan.motions, strict=True):
        assert isinstance(new, MOVES)  # all three waits move the rail
        assert plant.rail_value(new.extax) == pytest.approx(planned.q_1[0], abs=5.7e-7)  # 0.001 mm, and 24 bits
        if isinstance(new, (MoveJ, MoveL)):
            assert new.conf == confdata(plant.robot, planned.q_1[1:])
        if isinstance(old, (MoveJ, MoveL)):
            assert type(new) is type(old)
            np.testing.assert_allclose(new.X_WT, old.X_WT, rtol=0, atol=1e-9)
            assert (new.speed, new.zone, new.tool.name, new.wobj) == (old.speed, old.zone, old.tool.name, old.wobj)
    waits = [new for old, new in zip(program.motions, again.motions, strict=True) if isinstance(old, Wait)]
    assert [wait.duration for wait in waits if isinstance(wait, MoveL)] == [0.3, 0.8, 0.8]


RAIL_AT = (
    "    ! p with the rail at rail, and where it is given in configuration conf",
    "    LOCAL FUNC robtarget RailAt(robtarget p,num rail\\confdata conf)",
    "        p.extax.eax_a:=rail;",
    "        IF Present(conf) p.robconf:=conf;",
    "        RETURN p;",
    "    ENDFUNC",
)


def test_only_the_edits_that_are_promised_are_made(plant: Plant) -> None:
    program = read_program(PROGRAMS / "hinge_cell.mod")
    export = export_rapid(program, plan_for(program, plant, HINGE_RAILS), plant)
    changes = changed_lines(program, export)
    assert len([line for line in changes if line[0] == "-"]) == 9 + 3  # nine robtargets, three waits
    assert "+    CONST robtarget p_n1_in:=[[500,200,450],[0,0,1,0],[-1,0,-1,0],[250,9E9,9E9,9E9,9E9,9E9]];" in changes
    assert any(",[123.457,9E9,9E9,9E9,9E9,9E9]];" in line for line in changes)
    moved = "RailAt(p_n1,300\\conf:=[-1,0,-1,0])"
    assert f"+        MoveL {moved},v500\\T:=0.3,fine,tool0\\WObj:=wobj0; ! the gripper closes" in changes
    assert changes[-7:] == [f"+{line}" for line in ("", *RAIL_AT)]


def test_a_plan_that_is_the_program_changes_no_byte(plant: Plant) -> None:
    program = read_program(PROGRAMS / "hinge_cell.mod")
    rails = {0: 0.2, 4: 1.35, 8: 1.9, 12: 0.0}
    export = export_rapid(program, plan_for(program, plant, rails), plant)
    assert export.texts == {path: file.text for path, file in program.files.items()}
    assert unified_diff(program, export) == ""
    assert tuple(map(str, export.notes)) == ()


@pytest.mark.parametrize(("encoding", "end"), [("cp1252", "\r\n"), ("utf-8-sig", "\r\n"), ("utf-8", "\r")])
def test_encoding_line_ends_and_everything_else_survive(plant: Plant, tmp_path: Path, encoding: str, end: str) -> None:
    text = (PROGRAMS / "hinge_cell.mod").read_text().replace("takes a hinge", "nimmt ein Türband")
    file = tmp_path / "hinge.mod"
    file.write_bytes(text.replace("\n", end).replace("    CONST", "\tCONST").encode(encoding))
    program = read_program(file)
    assert program.files[str(file)].encoding == encoding
    export = export_rapid(program, plan_for(program, plant, HINGE_RAILS), plant)
    old, new = (data.split(end.encode()) for data in (file.read_bytes(), export.texts[str(file)].encode(encoding)))
    assert b"\n" not in b"".join(new)
    assert b"\r" not in b"".join(new)
    added = [b"", *(line.encode() for line in RAIL_AT)]
    assert new[-9:] == [*added, b"ENDMODULE", b""]
    kept = [*new[:-9], *new[-2:]]
    different = [(a, b) for a, b in zip(old, kept, strict=True) if a != b]
    assert len(different) == 9 + 3
    assert all(b"robtarget" in a or b"WaitTime" in a for a, _ in different)
    assert all(b.startswith(a[: len(a) - len(a.lstrip())]) for a, b in different)


def test_a_six_axis_cell_that_is_planned_as_written_changes_no_byte() -> None:
    cell = load_cell(PROGRAMS / "bench_irb140.yaml")
    plant = build_plant(cell)
    program = read_program(PROGRAMS / "bench_irb140.mod", cell.scenario)
    export = export_rapid(program, plan_for(program, plant, {}), plant, scenario=cell.scenario)
    assert unified_diff(program, export) == ""


# ---------------------------------------------------------------------------------------------------------- numbers


def test_a_number_that_stays_keeps_its_spelling_and_the_rest_of_the_line_too(plant: Plant) -> None:
    program = made(J1 + J2)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 1.35}), plant)
    assert changed_lines(program, export) == [
        "-    CONST robtarget p2:=[[500, 1350., 450], [0,0,1,0], [0,0,0,0], [9E+09,9E9,9E9,9E9,9E9,9E9]];",
        "+    CONST robtarget p2:=[[500, 1350., 450], [0,0,1,0], [0,0,0,0], [1350,9E9,9E9,9E9,9E9,9E9]];",
    ]


def test_numbers_that_already_say_what_is_planned_are_not_rewritten(plant: Plant) -> None:
    data = "    CONST robtarget p3:=[[500,200,450],[0,0,1,0],[+0,0.,0e0,0],[200.0004,9E9,9E9,9E9,9E9,9E9]];\n"
    program = made("        MoveJ p3,v100,fine,tool0;\n        MoveL Offs(p3,0,0,-50),v100,fine,tool0;\n", data)
    assert unified_diff(program, export_rapid(program, plan_for(program, plant, {0: 0.2}), plant)) == ""
    export = export_rapid(
        program, plan_for(program, plant, {0: 0.25}), plant
    )  # only axes 1 and 6 change their quadrant
    assert "[0,0,1,0],[-1,0.,-1,0],[250,9E9" in export.texts["m.mod"]


@pytest.mark.parametrize(
    ("metres", "text"),
    [(0.25, "250"), (0.2500004, "250"), (0.250001, "250.001"), (0.1234567891, "123.457"), (-4e-7, "0"), (-0.05, "-50")],
)
def test_rail_values_are_written_to_a_thousandth_of_a_millimetre(plant: Plant, metres: float, text: str) -> None:
    program = made(J1)
    export = export_rapid(program, plan_for(program, plant, {0: metres}), plant)
    assert f",[{text},9E9,9E9,9E9,9E9,9E9]]; ! first\n" in export.texts["m.mod"]


@pytest.mark.parametrize("written", ["[0,0,0,0]", "[0,0,0]"], ids=["four", "three, as S4 wrote it"])
def test_another_branch_of_the_arm_is_written_as_its_confdata(plant: Plant, written: str) -> None:
    text = made(J1).files["m.mod"].text.replace("[0,0,1,0],[0,0,0,0]", f"[0,0,1,0],{written}", 1)
    program = run_program([TextFile("m.mod", text, "utf-8")])
    plan = plan_for(program, plant, {0: 0.2}, cfx={0: 1})  # the wrist turned over: axes 4 and 6 by half a turn
    conf = confdata(plant.robot, plan.motions[0].q_1[1:])
    assert conf.cfx == 1
    assert conf != ConfData(0, 0, 0, 1)
    export = export_rapid(program, plan, plant)
    assert f"[0,0,1,0],[{conf.cf1},{conf.cf4},{conf.cf6},1],[200,9E9" in export.texts["m.mod"]
    (move,) = read_back(program, export).motions
    assert isinstance(move, MoveJ)
    assert move.conf == conf


def test_a_home_that_leaves_the_rail_open_gets_the_planned_position(plant: Plant) -> None:
    data = "    CONST jointtarget free:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    program = made("        MoveAbsJ free,v100,fine,tool0;\n", data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.4}), plant)
    assert changed_lines(program, export)[1:] == [
        "+    CONST jointtarget free:=[[0,0,0,0,30,0],[400,9E9,9E9,9E9,9E9,9E9]];"
    ]


def test_external_axes_given_as_data_stay_and_the_target_is_wrapped(plant: Plant) -> None:
    data = (
        "    CONST extjoint e:=[200,9E9,9E9,9E9,9E9,9E9];\n"
        "    CONST confdata c:=[0,0,0,0];\n"
        "    CONST robtarget p3:=[[500,200,450],[0,0,1,0],c,e];\n"
    )
    program = made("        MoveJ p3,v100,fine,tool0;\n", data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.25}), plant)
    assert "p3:=[[500,200,450],[0,0,1,0],c,e];\n" in export.texts["m.mod"]
    assert "MoveJ RailAt(p3,250\\conf:=[-1,0,-1,0]),v100" in export.texts["m.mod"]


# ------------------------------------------------------------------------------------------------ around the target


def test_a_target_that_two_moves_want_otherwise_stays_and_each_says_its_own(plant: Plant) -> None:
    program = made(J1 + J2 + "        MoveL p1,v100,fine,tool0;\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 1.35, 2: 0.3}), plant)
    changes = changed_lines(program, export)
    assert not [line for line in changes if "p1:=" in line]
    assert "+        MoveL RailAt(p1,300\\conf:=[-1,0,-1,0]),v100,fine,tool0;" in changes
    assert J1 in export.texts["m.mod"]  # says what is planned
    assert [str(note) for note in export.notes] == [
        "m.mod:8:9: a function around the target sets another rail position or configuration"
    ]


def test_a_new_name_is_nobodys(plant: Plant) -> None:
    data = "    VAR num railAT;\n    VAR num rail_ps;\n" + ARRAY
    body = "        FOR i FROM 1 TO 2 DO\n            MoveJ ps{i},v100,fine,tool0;\n        ENDFOR\n"
    program = made(body, data)
    text = export_rapid(program, plan_for(program, plant, {0: 0.21, 1: 0.31}), plant).texts["m.mod"]
    assert "MoveJ RailAt_2(ps{i},rail_ps_2{i}\\conf:=[-1,0,-1,0]),v100,fine,tool0;" in text
    assert "    LOCAL CONST num rail_ps_2{2}:=[210,310];\n" in text


ARRAY = (
    "    CONST robtarget ps{2}:=[[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]],\n"
    "        [[500,300,450],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]]];\n"
)


def test_a_literal_in_the_statement_is_edited_there(plant: Plant) -> None:
    literal = "[[500,200,450],[0,0,1,0],[0,0,0,0],[150,9E9,9E9,9E9,9E9,9E9]]"
    program = made(f"        MoveJ {literal},v100,fine,tool0;\n        WaitTime 1;\n")
    text = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant).texts["m.mod"]
    assert f"        MoveJ {literal.replace('150', '200')},v100,fine,tool0;\n" in text
    assert f"        MoveL RailAt({literal},300\\conf:=[-1,0,-1,0]),v100\\T:=1,fine,tool0;\n" in text


def test_joints_that_leave_the_rail_open_twice_are_wrapped_by_a_function_of_their_own(plant: Plant) -> None:
    data = "    CONST jointtarget free:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    program = made(f"{J1}        MoveAbsJ free,v100,fine,tool0;\n" * 2, data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3, 2: 0.2, 3: 0.4}), plant)
    text = export.texts["m.mod"]
    assert "MoveAbsJ RailAtJ(free,300),v100" in text
    assert "MoveAbsJ RailAtJ(free,400),v100" in text
    assert "LOCAL FUNC jointtarget RailAtJ(jointtarget p,num rail)" in text


def test_what_was_exported_once_is_wrapped_once(plant: Plant) -> None:
    program = made(J1 + "        MoveL p1,v100,fine,tool0;\n")
    once = read_back(program, export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant))
    text = export_rapid(once, plan_for(once, plant, {0: 0.25, 1: 0.35}), plant).texts["m.mod"]
    assert text.count("LOCAL FUNC") == 1
    assert "MoveL RailAt(p1,350\\conf:=" in text
    assert "MoveJ RailAt(p1,250\\conf:=" in text


# ------------------------------------------------------------------------------------------------------------ waits


def test_a_wait_after_joints_becomes_a_line_to_where_they_are(plant: Plant) -> None:
    program = made("        MoveAbsJ home\\NoEOffs,v300,fine,tool0;\n        WaitTime\\InPos,0.5;\n" + J1)
    export = export_rapid(program, plan_for(program, plant, {0: 0.0, 1: 0.15, 2: 0.2}), plant)
    line = "        MoveL RailAt(CRobT(\\Tool:=tool0\\WObj:=wobj0),150\\conf:=[-1,0,-1,0]),v300\\T:=0.5,fine,tool0;\n"
    assert line in export.texts["m.mod"]
    home_b = read_again(program, plant, Scenario(), export.texts).motions[1]
    assert isinstance(home_b, MoveL)
    # 506.292, 0, 679.5 is the controller's own answer for axis 5 at 30 degrees.
    np.testing.assert_allclose(home_b.X_WT[:3, 3], [0.506291651, 0.0, 0.6795], rtol=0, atol=5.5e-7)
    assert home_b.extax[0] == 150.0


def test_the_tool_at_joints_is_the_tool_of_the_move(plant: Plant) -> None:
    data = "    PERS tooldata t:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];\n"
    program = made("        MoveAbsJ home,v300,fine,t;\n        WaitTime 0.5;\n", data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.0, 1: 0.15}), plant)
    home_b = read_again(program, plant, Scenario(), export.texts).motions[1]
    assert isinstance(home_b, MoveL)
    assert home_b.tool.name == "t"
    # The tip is 100 mm further along the flange's z, 30 degrees below the horizontal.
    tip = np.array([0.506291651, 0.0, 0.6795]) + 0.1 * np.array([np.cos(np.pi / 6), 0.0, -0.5])
    np.testing.assert_allclose(home_b.X_WT[:3, 3], tip, rtol=0, atol=5.5e-7)


def test_a_wait_for_a_signal_stays_behind_a_line_of_its_least_duration(plant: Plant) -> None:
    scenario = Scenario(waits={"di_ready": 0.6})
    text = made(J1 + "        WaitDI di_ready,1; ! hand over\n").files["m.mod"]
    program = run_program([text], scenario)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant, scenario=scenario)
    line = "        MoveL RailAt(p1,300\\conf:=[-1,0,-1,0]),v100\\T:=0.6,fine,tool0;\n"
    lines = line + "        WaitDI di_ready,1; ! hand over\n"
    read = read_again(program, plant, scenario, export.texts).motions
    assert [one.duration for one in read[1:] if isinstance(one, MoveL | Wait)] == [0.6, 0.0]  # not counted twice
    assert lines in export.texts["m.mod"]


def test_no_line_stands_in_an_expression_that_waits_nor_behind_a_move_with_a_wait_beside_it(plant: Plant) -> None:
    """In a wait of an instruction the rail may move, in its place; in one of a function it may not."""
    scenario = Scenario(waits={"uinumentry": 1.0, "uimsgbox": 1.0}, answers={"UINumEntry": 1.0})
    conc = J2.replace("MoveJ ", "MoveJ \\Conc,") + "        WaitTime 9;\n"
    body = J1 + f'        reg1:=UINumEntry(\\Header:="n");\n        UIMsgBox "look";\n{conc}'
    text = made(J1).files["m.mod"]
    text = replace(text, text=text.text.replace(J1, body))
    program = run_program([text], scenario)
    values = EditableText(program, plant, scenario).changes.values
    assert [type(program.motions[i]) for i in sorted(values)] == [MoveJ, Wait, MoveJ]
    assert 2 in values


def test_a_wait_without_a_rail_move_stays(plant: Plant) -> None:
    program = made(J1 + "        WaitTime 0.5;\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.2}), plant)
    assert export.texts["m.mod"] == program.files["m.mod"].text


def test_the_frame_and_speed_of_the_move_before_go_along(plant: Plant) -> None:
    data = '    PERS wobjdata w:=[FALSE,TRUE,"",[[0,100,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n'
    program = made("        MoveJ p1,v50,fine,tool0\\WObj:=w;\n        WaitTime reg1+0.5;\n", data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant)
    assert "),v50\\T:=reg1+0.5,fine,tool0\\WObj:=w;" in export.texts["m.mod"]


# ---------------------------------------------------------------------------------------------------- dropped, fast


def test_a_dropped_move_becomes_a_comment_line_by_line(plant: Plant) -> None:
    body = "        MoveJ p2,\n            v100,fine,\n            tool0; ! trajopt: optional\n"
    program = made(J1 + body)
    assert [m.optional for m in program.motions if isinstance(m, MOVES)] == [False, True]
    export = export_rapid(program, plan_for(program, plant, {0: 0.2}, frozenset({1})), plant)
    assert changed_lines(program, export) == [
        "-        MoveJ p2,",
        "-            v100,fine,",
        "-            tool0; ! trajopt: optional",
        "+        ! dropped by trajopt: MoveJ p2,",
        "+            ! v100,fine,",
        "+            ! tool0; ! trajopt: optional",
    ]
    assert len(read_back(program, export).motions) == 1
    assert tuple(map(str, export.notes)) == ("m.mod:7:9: dropped, as the program allows",)


def test_code_behind_a_dropped_move_still_runs(plant: Plant) -> None:
    program = made("        MoveJ p1,v100,fine,tool0; MoveJ p2,v100,fine,tool0; WaitTime 1; ! three\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.2}, frozenset({1})), plant)
    assert (
        "        MoveJ p1,v100,fine,tool0; ! dropped by trajopt: MoveJ p2,v100,fine,tool0;\n"
        "        WaitTime 1; ! three\n" in export.texts["m.mod"]
    )


def test_a_mark_above_a_dropped_move_is_no_error(plant: Plant) -> None:
    program = made(J1 + "        ! trajopt: optional\n" + J2)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2}, frozenset({1})), plant)
    assert tuple(map(str, read_back(program, export).warnings)) == ()


def test_faster_than_programmed_becomes_vmax(plant: Plant) -> None:
    program = made("        MoveJ p1,v100\\V:=150,fine,tool0;\n" + J2)
    plan = plan_for(program, plant, {0: 0.2, 1: 1.35})
    export = export_rapid(program, plan, replace(plant, free_speed=True), faster=frozenset({0}))
    assert "MoveJ p1,vmax,fine,tool0;" in export.texts["m.mod"]
    assert "MoveJ p2,v100,fine,tool0;" in export.texts["m.mod"]
    with pytest.raises(ValueError, match="free_speed"):
        export_rapid(program, plan, plant, faster=frozenset({0}))


# -------------------------------------------------------------------------------------------- reading the text back


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            ",[0,0,1,0],[-1,0,-1,0],[250",
            ",[0,0,1,0],[-1,0,-1,0],[250.1",
            "6:9: the plan wants the rail at 250.000000 mm",
        ),
        ("[[500,200,450]", "[[500.001,200,450]", "6:9: the plan wants the tool in the programmed place"),
        ("[-1,0,-1,0],[250", "[-1,0,-1,1],[250", "6:9: the plan wants another configuration than"),
        ("T:=0.5", "T:=0.6", "7:9: the plan wants the tool to rest for the time of the wait"),
        ("RailAt(p1,300)", "RailAt(Offs(p1,0,1,0),300)", "7:9: the plan wants the tool to rest"),
        ("MoveL RailAt", "MoveJ RailAt", "7:9: the plan wants a MoveL there"),
        ("Set do1;", "Set do2;", "8:9: the plan wants what the program says there"),
        ("Set do1;", "", "8:9: the plan wants what the program says there"),
        ("30,0],[0,", "31,0],[0,", "9:9: the plan wants the programmed joints"),
        ("MoveAbsJ home,v100,fine,tool0;", "", "9:9: the plan wants MoveAbsJ home there"),
        ("ENDPROC", "Set do1;ENDPROC", "the edited program has one motion too many at m.mod:"),
    ],
)
def test_a_text_that_does_not_give_the_plan_is_caught(plant: Plant, old: str, new: str, message: str) -> None:
    body = J1 + "        WaitTime 0.5;\n        Set do1;\n        MoveAbsJ home,v100,fine,tool0;\n"
    program = made(body)
    plan = plan_for(program, plant, {0: 0.25, 1: 0.3, 3: 0.0})
    text = export_rapid(program, plan, plant).texts["m.mod"]
    assert [*mismatches(program, plan, plant, read_again(program, plant, Scenario(), {"m.mod": text}))] == []
    assert old in text
    edited = {"m.mod": text.replace(old, new, 1)}
    error = next(mismatches(program, plan, plant, read_again(program, plant, Scenario(), edited)))
    assert message in str(error)


# ------------------------------------------------------------------------------------------- what cannot be written


def error(program: Program, plan: Plan, plant: Plant) -> str:
    with pytest.raises(InputError) as caught:
        export_rapid(program, plan, plant)
    return str(caught.value)


def test_a_computed_target_that_goes_along_with_its_base_is_fine(plant: Plant) -> None:
    program = made(J1 + "        MoveL Offs(p1,0,0,-50),v100,fine,tool0;\n")
    again = read_back(program, export_rapid(program, plan_for(program, plant, {0: 0.3}), plant))
    assert [m.extax[0] for m in again.motions if isinstance(m, MOVES)] == [300.0, 300.0]


def test_a_statement_that_runs_twice_and_has_to_differ_needs_loops_unrolled(plant: Plant) -> None:
    program = made("        go;\n        go;\n", rest=f"    PROC go()\n{J1}    ENDPROC\n")
    plan = plan_for(program, plant, {0: 0.2, 1: 0.3})
    assert error(program, plan, plant).startswith("m.mod:10:9: ")
    again = read_back(program, export_rapid(program, plan, plant, loops=Loops.UNROLL))
    assert [m.extax[0] for m in again.motions if isinstance(m, MOVES)] == [200.0, 300.0]
    export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 0.3}), plant)


def test_a_move_under_a_compact_if_cannot_be_dropped(plant: Plant) -> None:
    program = made(J1 + "        IF TRUE MoveJ p2,v100,fine,tool0;\n")
    assert error(program, plan_for(program, plant, {0: 0.2}, frozenset({1})), plant) == (
        "m.mod:7:17: this statement is part of an IF without THEN; write IF ... THEN ... ENDIF"
    )


def test_a_rail_move_before_the_first_move_has_no_place(plant: Plant) -> None:
    program = made("        WaitTime 1;\n" + J1)
    plan = plan_for(program, plant, {0: 0.1, 1: 0.2})
    assert error(program, plan, plant).startswith("m.mod:6:9: ")


def test_a_plan_that_leaves_a_motion_out_is_refused(plant: Plant) -> None:
    program = made(J1 + J2)
    plan = plan_for(program, plant, {0: 0.2, 1: 1.35})
    with pytest.raises(ValueError, match=r"leaves out motion 1 \(m.mod:7:9\)"):
        export_rapid(program, replace(plan, motions=plan.motions[:1]), plant)


def test_a_stream_plan_is_no_rapid_program(plant: Plant) -> None:
    program = made(J1)
    with pytest.raises(ValueError, match="only a plan for the RAPID controller"):
        export_rapid(program, replace(plan_for(program, plant, {0: 0.2}), target=Target.STREAM), plant)


def test_values_of_a_rail_whose_unit_is_not_active_stay_as_written(plant: Plant) -> None:
    """The plan may change what else a target says; p3 is driven to with its unit and without."""
    body = J1 + "        DeactUnit TRACK1;\n        MoveL p3,v100,fine,tool0;\n        MoveJ p4,v100,fine,tool0;\n"
    body += "        ActUnit TRACK1;\n        MoveL p3,v100,fine,tool0;\n"
    data = "    CONST robtarget p3:=[[500,250,450],[0,0,1,0],[0,0,0,0],[9000,9E9,9E9,9E9,9E9,9E9]];\n"
    data += "    CONST robtarget p4:=[[500,300,450],[0,0,1,0],[0,0,0,0],[7000,9E9,9E9,9E9,9E9,9E9]];\n"
    given = made(body, data)
    scenario = Scenario(rail=RailUnit(0, "TRACK1"))
    program = run_program([*given.files.values()], scenario)
    free = EditableText(program, plant, scenario).changes.values
    assert {0, 2, 3, 5} <= free
    again = made(f"        FOR i FROM 1 TO 2 DO\n{body}        ENDFOR\n", data)
    again = run_program([*again.files.values()], scenario)
    assert {2, 3, 8, 9} <= EditableText(again, plant, scenario).changes.values
    plan = plan_for(program, plant, {0: 0.21, 5: 0.23}, cfx={3: 1, 5: 1})
    export = export_rapid(program, plan, plant, scenario=scenario)
    texts = "".join(export.texts.values())
    assert "[9000,9E9" in texts
    assert "[0,0,0,0],[7000,9E9" not in texts  # its confdata changed
    assert "],[7000,9E9" in texts
    for motion, planned in zip(read_back(program, export, scenario).motions, plan.motions, strict=True):
        if isinstance(motion, MoveJ | MoveL):
            assert plant.rail_value(motion.extax) == (None if planned.index in (2, 3) else planned.q_1[0])
