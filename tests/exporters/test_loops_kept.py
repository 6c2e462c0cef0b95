"""A plan for a program with loops and routines: one text serves all passes, and the loop stays a loop."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rail_plans import J1, changed_lines, made, plan_for, read_back

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.job import read_job
from trajopt_cli.motion import MoveJ, MoveL, Program, SignalEvent
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.editable_text import KEPT, EditableText
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
PICK = """        FOR i FROM 1 TO 3 DO
            MoveJ p1,v100,fine,tool0;
            MoveL Offs(p1,0,0,-50),v100,fine,tool0;
            WaitTime 0.5;
            MoveL p1,v100,fine,tool0;
            MoveJ Offs(p2,0,20*i,0),v100,fine,tool0;
        ENDFOR
"""


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_cell.yaml"))


def changes(program: Program, plant: Plant, loops: Loops = Loops.KEEP, scenario: Scenario | None = None) -> Changes:
    return EditableText(program, plant, scenario or Scenario(), loops).changes


def test_all_passes_through_one_target_are_tied(plant: Plant) -> None:
    """p1 before and after the pick is one literal; Offs(p1,0,0,-50) and the wait are one statement each. What depends
    on the counter stays."""
    found = changes(made(PICK), plant)
    assert set(found.ties) == {(0, 3, 5, 8, 10, 13), (1, 6, 11), (2, 7, 12)}
    assert found.values == set(range(15)) - {4, 9, 14}
    assert found.kept == (
        f"{KEPT}: m.mod:11 (depend on i); a declared target would free them, or --loops unroll, which writes this "
        "run's values out",
    )


def test_the_loop_stays_and_its_targets_are_edited(plant: Plant) -> None:
    program = made(PICK)
    rails = {i: 0.25 if i % 5 in (0, 3) else 0.28 if i % 5 == 1 else 0.31 for i in range(15) if i % 5 != 4}
    rails |= {4: 1.35, 9: 1.35, 14: 1.35}  # p2 leaves the rail open, so it stays where it was programmed last
    program = made(PICK.replace("p2", "p3"), P3)
    plan = plan_for(program, plant, rails)
    export = export_rapid(program, plan, plant)
    assert export.new == {}
    assert [line for line in changed_lines(program, export) if "CONST" not in line] == [
        "-            MoveL Offs(p1,0,0,-50),v100,fine,tool0;",
        "-            WaitTime 0.5;",
        "+            MoveL p1_2,v100,fine,tool0;",
        "+            MoveL p1_b, v100 \\T:=0.5, fine, tool0;",
    ]
    assert len([note for note in export.notes if "is computed" in note.text]) == 1
    for motion, planned in zip(read_back(program, export).motions, plan.motions, strict=True):
        if isinstance(motion, MoveJ | MoveL):
            assert plant.rail_value(motion.extax) == pytest.approx(planned.q_1[0], abs=1e-9)


P3 = "    CONST robtarget p3:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1350,9E9,9E9,9E9,9E9,9E9]];\n"
LITERAL = """        FOR i FROM 1 TO 3 DO
            MoveJ p3,v100,fine,tool0;
            MoveL p1,v100,fine,tool0;
        ENDFOR
"""


def test_only_the_aggregates_of_a_loop_over_literals_change(plant: Plant) -> None:
    program = made(LITERAL, P3)
    assert set(changes(program, plant).ties) == {(0, 2, 4), (1, 3, 5)}
    rails = dict.fromkeys((0, 2, 4), 1.2) | dict.fromkeys((1, 3, 5), 0.3)
    export = export_rapid(program, plan_for(program, plant, rails), plant)
    assert export.notes == ()
    assert [line for line in changed_lines(program, export) if line[0] == "+"] == [
        "+    CONST robtarget p1:=[[500,200,450],[0,0,1,0],[-1,0,-1,0],[300,9E9,9E9,9E9,9E9,9E9]]; ! first",
        "+    CONST robtarget p3:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1200,9E9,9E9,9E9,9E9,9E9]];",
    ]


def test_a_computed_target_of_an_open_rail_is_declared_for_all_passes(plant: Plant) -> None:
    """Only the first pass takes the rail along; the second would find it there by itself."""
    body = "        FOR i FROM 1 TO 2 DO\n            MoveJ Offs(p2,0,0,10),v100,fine,tool0;\n        ENDFOR\n"
    program = made(body)
    assert changes(program, plant).ties == ((0, 1),)
    export = export_rapid(program, plan_for(program, plant, {0: 1.3, 1: 1.3}), plant)
    assert export.new == {}
    assert "            MoveJ p2_2,v100,fine,tool0;" in export.texts["m.mod"]


def test_a_wait_in_which_the_rail_moves_by_less_than_a_num_can_say_stays(plant: Plant) -> None:
    program = made(f"{J1}        WaitTime 0.5;\n        MoveL p1,v100,fine,tool0;\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 0.3 + 2e-9, 2: 0.3 + 2e-9}), plant)
    assert "        WaitTime 0.5;\n" in export.texts["m.mod"]


def test_every_wish_that_keeps_the_ties_can_be_written(plant: Plant) -> None:
    rng = np.random.default_rng(3)
    program = made(PICK.replace("p2", "p3"), P3)
    found = changes(program, plant)
    first = {i: group[0] for group in found.ties for i in group}
    for _ in range(5):
        rails, wanted = {}, rng.uniform(0.1, 0.4, len(program.motions))
        for i in range(len(program.motions)):
            rails[i] = float(wanted[first.get(i, i)]) if i in found.values else 1.35
        assert export_rapid(program, plan_for(program, plant, rails), plant).new == {}


@pytest.mark.parametrize(
    ("call", "kept"),
    [
        ("Offs(p,0,0,20)", "p"),  # what the caller gave
        ("Offs(p1,0,0,h)", "h"),
        ("Offs(p1,0,0,n)", "n"),  # a variable of the module
        ("fUp(p1)", "n"),  # a function that reads one
        ("Offs(pNow,0,0,5)", "pNow"),  # a position that a statement changes
        ("Offs(p1,0,0,k)", None),
        ("RelTool(pTaught,0,0,-20)", None),  # a position that nothing changes
    ],
)
def test_what_depends_on_a_variable_is_never_frozen(plant: Plant, call: str, kept: str | None) -> None:
    """Neither in a routine called twice nor in one called once; with loops unrolled both may be."""
    taught = "[[500,250,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];\n"
    data = f"    VAR num n:=20;\n    CONST num k:=20;\n    VAR robtarget pNow;\n    PERS robtarget pTaught:={taught}"
    move = f"        MoveJ {call},v100,fine,tool0;\n"
    rest = (
        f"    PROC go(robtarget p,num h)\n{move}    ENDPROC\n"
        "    FUNC robtarget fUp(robtarget p)\n        RETURN Offs(p,0,0,n);\n    ENDFUNC\n"
    )
    for calls in ("        go p1,20;\n", "        go p1,20;\n        go p1,20;\n"):
        program = made(f"        pNow:=p1;\n{calls}{J1}", data, rest)
        found = changes(program, plant)
        assert [note.split(" (")[1].split(")")[0] for note in found.kept] == ([f"depend on {kept}"] if kept else [])
        assert 0 in changes(program, plant, Loops.UNROLL).values


def test_a_routine_with_a_target_for_parameter_keeps_both_callers_apart(plant: Plant) -> None:
    """Each literal is reached twice: two ties, and the routine's text stays."""
    rest = "    PROC go(robtarget p)\n        MoveJ p,v100,fine,tool0;\n    ENDPROC\n"
    program = made("        go p1;\n        go p3;\n        go p1;\n        go p3;\n", P3, rest)
    assert set(changes(program, plant).ties) == {(0, 2), (1, 3)}
    export = export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 1.2, 2: 0.3, 3: 1.2}), plant)
    assert export.new == {}
    assert len(changed_lines(program, export)) == 4


@pytest.mark.parametrize("calls", ["        go p1;\n", "        pNow:=p1;\n        here;\n"])
def test_what_a_variable_names_is_edited_where_it_is_declared(plant: Plant, calls: str) -> None:
    """The move never gets a constant in the variable's place, though another move wants p1 elsewhere."""
    rest = "    PROC go(robtarget p)\n        MoveJ p,v100,fine,tool0;\n    ENDPROC\n"
    rest += "    PROC here()\n        MoveJ pNow,v100,fine,tool0;\n    ENDPROC\n"
    program = made(f"{J1}{calls}", "    VAR robtarget pNow;\n", rest)
    assert changes(program, plant).values == {0, 1}
    lines = changed_lines(program, export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 0.35}), plant))
    assert [line for line in lines if "Move" in line] == [f"-{J1.rstrip()}", "+        MoveJ p1_2,v100,fine,tool0;"]


def test_a_literal_that_a_kept_target_is_computed_from_stays(plant: Plant) -> None:
    """Its rail position would be theirs, too; others in the loop are free."""
    body = LITERAL.replace("        ENDFOR", "            MoveL Offs(p1,0,0,-10*i),v100,fine,tool0;\n        ENDFOR")
    program = made(body, P3)
    found = changes(program, plant)
    assert found.ties == ((0, 3, 6),)
    assert [note.split(": ", 1)[1].split(";")[0] for note in found.kept] == [
        "m.mod:9 (cannot be edited without moving others)",
        "m.mod:10 (depend on i)",
    ]


def test_without_a_rail_a_configuration_would_be_theirs_too() -> None:
    """The shipped bench: what is set down at p is also approached at Offs(p,0,0,lift)."""
    job = read_job(PROGRAMS / "bench_irb140.mod")
    found = changes(job.program, job.plant, scenario=job.scenario)
    lines = {motion.source.line for i, motion in enumerate(job.program.motions) if i in found.values}
    assert lines & set(range(30, 44)) == {30, 31, 32, 34, 35}
    assert len(changes(job.program, job.plant, Loops.UNROLL, job.scenario).values) == len(
        [motion for motion in job.program.motions if not isinstance(motion, SignalEvent)]
    )


def test_one_literal_in_two_places_cannot_have_one_configuration(plant: Plant) -> None:
    """A displacement that grows from pass to pass: what was right for one place is not for the other."""
    body = LITERAL.replace(" DO\n", " DO\n            PDispSet [[0,10*i,0],[1,0,0,0]];\n")
    program = made(body, P3)
    assert changes(program, plant).ties == ()
    assert changes(program, plant).values == frozenset()


def test_what_hangs_on_an_input_may_change_where_it_stands(plant: Plant) -> None:
    """A literal in a branch of a loop is edited whether or not the branch is taken; a loop without end is edited for
    all its passes."""
    text = f"        WHILE TRUE DO\n            IF di1=1 THEN\n{J1}            ENDIF\n        ENDWHILE\n"
    scenario = Scenario(signals={"di1": 1.0}, endless_passes=3)
    base = made("        Set do1;\n").files["m.mod"]
    program = run_program([replace(base, text=base.text.replace("        Set do1;\n", text))], scenario)
    assert changes(program, plant, scenario=scenario).ties == ((0, 1, 2),)
    assert changes(program, plant, Loops.UNROLL, scenario).values == frozenset()


def test_an_open_rail_in_a_routine_stays_open_while_its_other_targets_move(plant: Plant) -> None:
    """go p2 finds the rail where it is; another pass of the same statement, with p1, takes it along."""
    rest = "    PROC go(robtarget p)\n        MoveJ p,v100,fine,tool0;\n    ENDPROC\n"
    program = made("        MoveJ p3,v100,fine,tool0;\n        go p2;\n        go p1;\n", P3, rest)
    export = export_rapid(program, plan_for(program, plant, {0: 1.35, 1: 1.35, 2: 0.3}), plant)
    assert [line.split(":=")[0].split()[-1] for line in changed_lines(program, export) if line[0] == "+"] == ["p1"]


def test_optional_passes_go_all_together_or_not_at_all(plant: Plant) -> None:
    marked = PICK.replace("MoveJ p1,v100,fine,tool0;", "MoveAbsJ home,v100,fine,tool0; ! trajopt: optional")
    joint = marked.replace("MoveL Offs(p1,0,0,-50)", "MoveJ Offs(p1,0,0,-50)")
    assert changes(made(joint), plant).droppable == {0, 5, 10}
    alternating = joint.replace("MoveJ Offs(p1,0,0,-50),v100,fine,tool0;", "IF i<3 MoveJ p1,v100,fine,tool0;")
    alternating = alternating.replace("            WaitTime 0.5;\n", "")
    program = made(alternating)
    assert not isinstance(program.motions[-1], SignalEvent)
    assert changes(program, plant).droppable == frozenset()  # before the last line it may not go
