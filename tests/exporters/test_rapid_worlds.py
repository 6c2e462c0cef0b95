"""What of a plan can be written into a program whose world is only known by its scenario."""

from __future__ import annotations

from pathlib import Path

import pytest
from rail_plans import J1, made, plan_for

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.motion import Program
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import KEPT, EditableText
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Answer, Given, Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
ASK = '        TPReadFK n,"?","a",stEmpty,stEmpty,stEmpty,"b";\n'
UP = "        MoveJ Offs(p1,0,0,50),v100,fine,tool0;\n"
FUNC = (
    "    FUNC robtarget fUp(robtarget p)\n        p.trans.z:=p.trans.z+50;\n        RETURN p;\n    ENDFUNC\n"
    f"    PROC go()\n{UP}    ENDPROC\n"
)


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_cell.yaml"))


def asking(body: str, scenario: Scenario, data: str = "    VAR num n;\n", rest: str = FUNC) -> Program:
    """A program like made(), which may ask for what the scenario answers."""
    file = made("        Set do1;\n", data, rest).files["m.mod"]
    text = file.text.replace("        Set do1;\n", body)
    return run_program([type(file)(file.path, text, file.encoding)], scenario)


@pytest.mark.parametrize(
    ("body", "answer", "free"),
    [
        (ASK + UP + J1, 1.0, {0, 1}),  # asked, and used nowhere
        (f"{ASK}        IF n=5 RETURN;\n{UP.replace('Offs(p1,0,0,50)', 'fUp(p1)')}{J1}", 1.0, {0, 1}),
        (f"{ASK}        go;\n{J1}", 5.0, {0, 1}),
        (f"{ASK}{UP.replace('50', '50*n')}{J1}", 1.0, {1}),
        (f"{ASK}        IF n=4 h:=80;\n{UP.replace('50', 'h')}{J1}", 1.0, {1}),
        (f"{ASK}        TEST n\n        CASE 3:\n        h:=80;\n        ENDTEST\n{UP.replace('50', 'h')}", 2, set()),
        (f'        TPReadNum n,"?";\n        IF n>700 h:=80;\n{UP.replace("50", "h")}{J1}', 1.0, {1}),
    ],
)  # fmt: skip
def test_a_target_is_pinned_by_what_it_hangs_on_only(plant: Plant, body: str, answer: Answer, free: set[int]) -> None:
    scenario = Scenario(answers={"n": answer})
    program = asking(body, scenario, "    VAR num n;\n    VAR num h:=50;\n")
    free = {i + 1 for i in free}  # the first motion is the wait for the operator
    assert EditableText(program, plant, scenario, Loops.UNROLL).changes.values == free
    rails = {i: 0.2 if i not in free else 0.3 + i / 10 for i in range(1, len(program.motions))}
    assert export_rapid(program, plan_for(program, plant, rails), plant, scenario=scenario).texts


@pytest.mark.parametrize(
    ("value", "up"),
    [(Given(30.0), "h"), (Given((30.0, 40.0)), "h"), (Given("[30,40]"), "h{1}"), (Given("[30,40]"), "h{2}")],
)
def test_a_target_that_hangs_on_data_of_the_cell_file_is_pinned(plant: Plant, value: Given, up: str) -> None:
    scenario = Scenario(data={"h": value})
    program = asking(UP.replace("50", up) + J1, scenario)
    assert EditableText(program, plant, scenario).changes.values == {1}


ARRAY = (
    "    CONST robtarget ps{2}:=[[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]],"
    "[[500,300,450],[0,0,1,0],[0,0,0,0],[300,9E9,9E9,9E9,9E9,9E9]]];\n    VAR num n;\n"
)
EACH = "        IF TRUE each;\n"
LEFT = """    PROC each()
        VAR num i;
        WHILE TRUE DO
            i:=i+1;
            IF i>2 RETURN;
            MoveJ ps{i},v100,fine,tool0;
        ENDWHILE
    ENDPROC
"""


def test_a_literal_that_cannot_get_another_beside_it_is_pinned_by_what_is_computed_from_it(plant: Plant) -> None:
    scenario = Scenario(answers={"n": 10.0})
    ask = '        TPReadNum n,"?";\n'
    hanging = "        MoveL Offs(ps{2},0,0,n),v100,fine,tool0;\n"
    several = asking(f"{ask}{EACH}", scenario, ARRAY, LEFT)
    assert EditableText(several, plant, scenario, Loops.UNROLL).changes.values == {1, 2}
    program = asking(f"{ask}{EACH}{hanging}{J1}", scenario, ARRAY, LEFT)
    assert EditableText(program, plant, scenario, Loops.UNROLL).changes.values == {1, 4}  # ps{1} is read by none
    plan = plan_for(program, plant, {1: 0.2, 2: 0.3, 3: 0.3, 4: 0.35})
    assert "[350,9E9" in export_rapid(program, plan, plant, scenario=scenario).texts["m.mod"]


def kept(body: str, plant: Plant, scenario: Scenario) -> list[str]:
    program = asking(body, scenario)
    notes = EditableText(program, plant, scenario, Loops.UNROLL).changes.kept
    return [note.removeprefix(f"{KEPT}: ") for note in notes]


def test_what_stays_as_programmed_is_said_with_the_reason(plant: Plant) -> None:
    moves = f"        WHILE TRUE DO\n            IF di1=1 THEN\n{UP}{J1}            ENDIF\n        ENDWHILE\n"
    assert kept(moves, plant, Scenario(signals={"di1": 1.0}, endless_passes=2)) == [
        "m.mod:9, 10 (run 2 times with different values); one statement per pass would free them"
    ]
    loop = moves.replace("WHILE TRUE DO", "FOR i FROM 1 TO 2 DO").replace("ENDWHILE", "ENDFOR")
    assert kept(loop, plant, Scenario(signals={"di1": 1.0})) == [
        "m.mod:9, 10 (run 2 times and depend on signal di1); one statement with a declared target per pass would free "
        "them"
    ]
    many = ASK + "".join(UP.replace("50", f"{k}*n") for k in range(1, 8))
    assert [note.split(";")[0] for note in kept(many, plant, Scenario(answers={"n": 1.0}))] == [
        "m.mod:8, 9, 10, 11, 12 and 2 more (depend on answer n)"
    ]
    assert kept(J1, plant, Scenario()) == []
