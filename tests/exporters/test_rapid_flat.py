from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rail_plans import J1, J2, changed_lines, made, plan_for, read_back

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.motion import Hold, MoveJ, MoveL, Program, SignalEvent, TextFile
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import EditableText
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
LOOP = """FOR i FROM 0 TO 1 DO
            MoveJ Offs(p1,0,0,i*20),v100,fine,tool0;
            n:=n+1; ! count
            pick;
            SetDO do2, i;
            TPWrite "x";
            WaitTime 0.5;
        ENDFOR"""
PICK = (
    "    PROC pick()\n        MoveL p1,\n            v50,\n            fine,tool0;\n        Reset do1;\n    ENDPROC\n"
)
RAILS = {0: 0.2, 1: 0.21, 2: 0.22, 5: 0.27, 6: 0.26, 7: 0.25, 11: 1.35}


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_cell.yaml"))


def loop() -> Program:
    return made(f"{J1}        {LOOP}\n{J2}", "    VAR num n;\n", PICK)


@pytest.mark.parametrize(
    ("mark", "body"),
    [
        ("", LOOP.replace("FOR i FROM 0 TO 1 DO", "FOR i FROM 0 TO 1 DO ! trajopt: hold rail")),
        ("        ! trajopt: hold rail\n", LOOP),
        ("", LOOP.replace("WaitTime 0.5;", "WaitTime 0.5; ! trajopt: hold rail")),
    ],
)
def test_what_holds_the_rail_still_does_when_written_flat(plant: Plant, mark: str, body: str) -> None:
    program = made(f"{J1}{mark}        {body}\n{J2}", "    VAR num n;\n", PICK)
    export = export_rapid(program, plan_for(program, plant, {i: x for i, x in RAILS.items() if i != 5}), plant)
    assert [*export.new] == ["main_flat.mod"]
    again = run_program([*(replace(program.files[path], text=text) for path, text in export.texts.items()),
                         *export.new.values()])  # fmt: skip
    held = [[motion.hold for motion in one.motions if not isinstance(motion, SignalEvent)] for one in (program, again)]
    assert Hold.PROGRAM in held[0]
    assert held[1] == held[0]


def test_what_a_late_bound_procedure_does_besides_its_motions_is_said_to_be_left_out(plant: Plant) -> None:
    body = '        FOR i FROM 0 TO 1 DO\n            %"m:go"% h:=i*50;\n        ENDFOR\n'
    inside = "        MoveJ ToPoint:=Offs(p1,0,h,0),v100,fine,tool0;\n        Incr n;\n"
    rest = f"    LOCAL PROC go(num h)\n{inside}    ENDPROC\n"
    program = made(body, "    VAR num n;\n", rest)
    export = export_rapid(program, plan_for(program, plant, {0: 0.25, 1: 0.3}), plant, loops=Loops.UNROLL)
    assert "MoveJ ToPoint:=p1_flat2,v100" in export.new["main_flat.mod"].text
    assert any("not carried over" in note.text and "late-bound" in note.text for note in export.notes)


def test_a_loop_that_cannot_carry_the_plan_is_written_flat(plant: Plant) -> None:
    program = loop()
    plan = plan_for(program, plant, RAILS)
    export = export_rapid(program, plan, plant)
    assert [*export.new] == ["main_flat.mod"]
    lines = export.new["main_flat.mod"].text.splitlines()
    assert (lines[0], lines[-1]) == ("MODULE main_flat", "ENDMODULE")
    names = {line.split(":=")[0].split()[-1]: line.split(":=")[1] for line in lines if "CONST" in line}
    assert all(line.startswith("    LOCAL CONST robtarget ") for line in lines if "CONST" in line)
    assert lines[lines.index("    PROC trajopt_flat_1()") : -1] == [
        "    PROC trajopt_flat_1()",
        "        MoveJ p1_flat,v100,fine,tool0;",
        "        MoveL p1_flat2, v50, fine,tool0;",
        "        Reset do1;",
        "        SetDO do2, 0;",
        "        MoveL p1_b_flat, v50 \\T:=0.5, fine, tool0;",
        "        MoveJ p1_flat3,v100,fine,tool0;",
        "        MoveL p1_flat4, v50, fine,tool0;",
        "        Reset do1;",
        "        SetDO do2, 1;",
        "        WaitTime 0.5;",
        "    ENDPROC",
    ]
    assert names["p1_flat3"].startswith("[[500,200,470],[0,0,1,0],")
    assert "[270,9E9" in names["p1_b_flat"]
    assert [line for line in export.texts["m.mod"].splitlines() if "trajopt" in line or "! !" in line] == [
        "        ! written flat by trajopt: FOR i FROM 0 TO 1 DO",
        "        trajopt_flat_1;",
    ]
    assert "            ! n:=n+1; ! count\n" in export.texts["m.mod"]
    assert tuple(map(str, export.notes))[-2:] == (
        "m.mod:8: 'FOR i FROM 0 TO 1 DO MoveJ Offs(p1,0,...' is written flat as trajopt_flat_1; "
        "not carried over: assignments, TPWrite",
        "main_flat.mod: a new module; load it with the program",
    )
    again = read_back(program, export)
    assert len(again.motions) == len(program.motions)
    for new, planned in zip(again.motions, plan.motions, strict=True):
        if isinstance(new, MoveJ | MoveL):
            assert plant.rail_value(new.extax) == pytest.approx(planned.q_1[0], abs=1e-9)


def test_two_calls_of_one_procedure_become_two_flat_ones(plant: Plant) -> None:
    body = "        pick 1; ! left\n        WaitTime 1;\n        pick 2; WaitTime 2;\n"
    moves = "        MoveJ Offs(p1,0,10*k,0),v100,fine,tool0;\n        MoveL p1,v50,fine,tool0;\n"
    rest = f"    PROC pick(num k)\n{moves}    ENDPROC\n"
    program = made(body, rest=rest)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.21, 2: 0.21, 3: 0.2, 4: 0.23}), plant)
    assert changed_lines(program, export)[:6] == [
        "-        pick 1; ! left",
        "+        ! written flat by trajopt: pick 1; ! left",
        "+        trajopt_flat_1;",
        "-        pick 2; WaitTime 2;",
        "+        ! written flat by trajopt: pick 2;",
        "+        trajopt_flat_2;",
    ]
    assert "        trajopt_flat_2;\n        WaitTime 2;\n" in export.texts["m.mod"]


def test_the_new_module_has_encoding_line_ends_and_name_of_its_own(plant: Plant, tmp_path: Path) -> None:
    program = loop()
    other = TextFile("x/n.sysx", "\ufeffMODULE n\r\n    VAR num MAIN_flat;\r\nENDMODULE\r\n", "utf-16-le")
    text = "\ufeff" + program.files["m.mod"].text.replace("\n", "\r\n")
    file = TextFile("x/m.modx", text, "utf-16-le")
    again = run_program([file, other])
    export = export_rapid(again, plan_for(again, plant, RAILS), plant)
    ((path, new),) = export.new.items()
    assert (path, new.path, new.encoding) == ("x/main_flat2.modx", "x/main_flat2.modx", "utf-16-le")
    assert new.text.startswith("\ufeffMODULE main_flat2\r\n")
    assert new.text.count("\r\n") == new.text.count("\n") == new.text.count("\r")


def test_nothing_is_flat_while_the_wishes_agree(plant: Plant) -> None:
    program = made("        go;\n        go;\n", rest=f"    PROC go()\n{J1}    ENDPROC\n")
    assert export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 0.3}), plant).new == {}


def refused(program: Program, plant: Plant, rails: dict[int, float], scenario: Scenario | None = None) -> str:
    with pytest.raises(InputError) as caught:
        export_rapid(program, plan_for(program, plant, rails), plant, scenario=scenario)
    return str(caught.value)


def test_names_that_only_a_routine_knows_are_refused(plant: Plant) -> None:
    data = "    PERS tooldata t:=[TRUE,[[0,0,10],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];\n"
    rest = "    PROC go(PERS tooldata grip)\n        MoveJ p1,v100,fine,grip;\n    ENDPROC\n"
    program = made("        go t;\n        go  t;\n", data, rest)
    assert refused(program, plant, {0: 0.2, 1: 0.3}).startswith("m.mod:11:9: ")
    assert EditableText(program, plant, Scenario(), Loops.UNROLL).changes.values == frozenset()


def test_a_speed_that_only_a_routine_knows_is_written_in_numbers(plant: Plant) -> None:
    rest = "    PROC go(speeddata v)\n        MoveJ p1,v\\V:=120,fine,tool0;\n    ENDPROC\n"
    program = made("        go v50;\n        go v60;\n", rest=rest)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant)
    assert "MoveJ p1_flat2,[120,500,5000,1000],fine,tool0;" in export.new["main_flat.mod"].text


def test_settings_that_change_inside_are_refused(plant: Plant) -> None:
    text = f"FOR i FROM 1 TO 2 DO\n{J1}        AccSet 50,100;\n        ENDFOR"
    program = made(f"        {text}\n{J1}")
    rails = {0: 0.2, 1: 0.3, 2: 0.3}
    assert refused(program, plant, rails).startswith("m.mod:7:9: ")
    assert EditableText(program, plant, Scenario(), Loops.UNROLL).changes.values == frozenset({2})


def test_flat_targets_are_called_after_the_data_they_come_from(plant: Plant) -> None:
    data = (
        "    CONST robtarget aZiel{2}:=[[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]],"
        "[[500,300,450],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]]];\n"
        "    CONST robtarget pF:=[[500,250,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];\n"
    )
    moves = "        MoveJ Offs(p,0,0,h),v100,fine,tool0;\n        MoveL p,v100,fine,tool0;\n"
    rest = f"    PROC go(num h,robtarget p)\n{moves}    ENDPROC\n"
    program = made("        go 10,pF;\n        go 20,aZiel{2};\n", data, rest)
    plan = plan_for(program, plant, {0: 0.2, 1: 0.21, 2: 0.22, 3: 0.23})
    export = export_rapid(program, plan, plant, loops=Loops.UNROLL)
    lines = export.new["main_flat.mod"].text.splitlines()
    assert [line.split(":=")[0].split()[-1] for line in lines if "CONST" in line] == [
        "pF_flat", "pF_flat2", "aZiel_flat", "aZiel_flat2",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("condition", "scenario"),
    [
        ("di1=1", Scenario(signals={"di1": 1.0})),
        ("DInput(di1)=1", Scenario(signals={"di1": (1.0, 1.0)})),
    ],
)
def test_what_hangs_on_an_input_is_not_written_flat(plant: Plant, condition: str, scenario: Scenario) -> None:
    text = f"FOR i FROM 1 TO 2 DO\n            IF {condition} THEN\n{J1}            ENDIF\n        ENDFOR"
    base = made(f"        {text}\n".replace(condition, "TRUE"))
    file = replace(base.files["m.mod"], text=base.files["m.mod"].text.replace("IF TRUE", f"IF {condition}"))
    program = run_program([file], scenario)
    assert "this statement runs more than once" in refused(program, plant, {0: 0.2, 1: 0.3}, scenario)
    assert EditableText(program, plant, scenario, Loops.UNROLL).changes.values == frozenset()


def test_a_target_that_an_operator_gives_is_not_written_out(plant: Plant) -> None:
    scenario = Scenario(answers={"h": -50.0})
    text = (
        made("        Set do1;\n", "    VAR num h;\n")
        .files["m.mod"]
        .text.replace(
            "        Set do1;\n", f'        TPReadNum h,"height";\n{J1}        MoveL Offs(p1,0,0,h),v100,fine,tool0;\n'
        )
    )
    program = run_program([TextFile("m.mod", text, "utf-8")], scenario)
    assert refused(program, plant, {1: 0.2, 2: 0.3}, scenario) == (
        "m.mod:9:9: the plan wants other values for Offs(p1,0,0,h), which hangs on what only the scenario says; it "
        "cannot be written out"
    )
    assert EditableText(program, plant, scenario, Loops.UNROLL).changes.values == frozenset({1})


# ------------------------------------------------------------------------------------------------- known beforehand


def test_what_can_be_written_is_known_beforehand(plant: Plant) -> None:
    array = (
        "    CONST robtarget ps{2}:=[[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]],"
        "[[500,300,450],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]]];\n"
    )
    body = (
        J1  # 0: a literal
        + "        MoveL Offs(p1,0,0,-50),v100,fine,tool0;\n"  # 1: computed, once
        + "        WaitTime 1;\n"  # 2
        # 3, 4: a literal each
        + "        FOR i FROM 1 TO 2 DO\n            MoveJ ps{i},v100,fine,tool0;\n        ENDFOR\n"
        + "        IF TRUE go;\n        IF TRUE go;\n"  # 5, 6: the same literal, nowhere to write it flat
        + "        EOffsSet [10,0,0,0,0,0];\n        WaitTime 1;\n"  # 7
        + "        Set do1;\n"  # 8
        + "        IF TRUE MoveJ p2,v100,fine,tool0;\n"  # 9
    )
    program = made(body, array, f"    PROC go()\n{J1}    ENDPROC\n")
    assert EditableText(program, plant, Scenario(), Loops.UNROLL).changes.values == frozenset({0, 1, 2, 3, 4, 9})


def test_every_wish_for_a_writable_motion_can_be_written(plant: Plant) -> None:
    program = loop()
    free = EditableText(program, plant, Scenario(), Loops.UNROLL).changes.values
    assert free == frozenset(i for i, m in enumerate(program.motions) if not isinstance(m, SignalEvent))
    rng = np.random.default_rng(1)
    rails: dict[int, float] = {}
    rail = 0.2
    for i in sorted(free):
        rail = 1.35 if i == len(program.motions) - 1 else float(rng.uniform(0.1, 0.3))
        rails[i] = rail
    export_rapid(program, plan_for(program, plant, rails), plant)
