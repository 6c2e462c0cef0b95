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
from trajopt_cli.motion import MoveJ, MoveL, Program, SignalEvent, Wait
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.editable_text import EditableText
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


WHILE = PICK.replace("FOR i FROM 1 TO 3 DO", "WHILE i<4 DO").replace("ENDFOR", "    i:=i+1;\n        ENDWHILE")
COUNT = "    VAR num i:=1;\n"


def test_counters_of_for_loops_tell_passes_apart(plant: Plant) -> None:
    found = changes(made(PICK), plant)
    assert (found.ties, found.values, found.kept) == ((), frozenset(range(15)), ())


def test_executions_of_one_statement_are_tied_however_their_target_is_computed(plant: Plant) -> None:
    found = changes(made(WHILE, COUNT), plant)
    assert found.ties == ((0, 5, 10), (1, 6, 11), (2, 7, 12), (3, 8, 13), (4, 9, 14))
    assert (found.values, found.kept) == (frozenset(range(15)), ())


def test_the_loop_stays_and_its_targets_are_wrapped(plant: Plant) -> None:
    program = made(WHILE.replace("p2", "p3"), P3 + COUNT)
    rails = {i: (0.25, 0.28, 0.31, 0.25, 1.3)[i % 5] for i in range(15)}
    plan = plan_for(program, plant, rails)
    export = export_rapid(program, plan, plant)
    conf = "\\conf:=[-1,0,-1,0]"
    assert [line for line in changed_lines(program, export) if line[:9] == "+        " and "Move" in line] == [
        f"+            MoveJ RailAt(p1,250{conf}),v100,fine,tool0;",
        f"+            MoveL RailAt(Offs(p1,0,0,-50),280{conf}),v100,fine,tool0;",
        f"+            MoveL RailAt(Offs(p1,0,0,-50),310{conf}),v100\\T:=0.5,fine,tool0;",
        f"+            MoveL RailAt(p1,250{conf}),v100,fine,tool0;",
    ]
    assert "p3:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1300,9E9" in export.texts["m.mod"]  # which serves one statement
    for motion, planned in zip(read_back(program, export).motions, plan.motions, strict=True):
        if isinstance(motion, MoveJ | MoveL):
            assert plant.rail_value(motion.extax) == pytest.approx(planned.q_1[0], abs=1e-9)


@pytest.mark.parametrize(
    ("bounds", "index"),
    [
        ("1 TO 3", "i"),
        ("0 TO 2", "i+1"),
        ("-4 TO -2", "i+5"),
        ("3 TO 1", "4-i"),
        ("2 TO 6 STEP 2", "(i-2) DIV 2+1"),
        ("0 TO 4 STEP 2", "i DIV 2+1"),
        ("9 TO 3 STEP -3", "(9-i) DIV 3+1"),
        ("nLow TO nHigh", "i-1"),
        ("0 TO nHigh-nLow", "i+1"),
        ("Dim(rows,2) TO nLow*1 STEP -1", "5-i"),
    ],
)
def test_passes_take_their_values_from_an_array(plant: Plant, bounds: str, index: str) -> None:
    data = "    CONST num nLow:=2;\n    CONST num nHigh:=nLow+2;\n    VAR num rows{2,nHigh};\n"
    body = f"        FOR i FROM {bounds} DO\n            MoveJ Offs(p1,0,i,0),v100,fine,tool0;\n        ENDFOR\n"
    program = made(body, data)
    rails = {0: 0.25, 1: 0.26, 2: 0.27}
    export = export_rapid(program, plan_for(program, plant, rails), plant)
    text = export.texts["m.mod"]
    assert "    LOCAL CONST num rail1{3}:=[250,260,270];\n" in text
    assert f"MoveJ RailAt(Offs(p1,0,i,0),rail1{{{index}}}\\conf:=[-1,0,-1,0]),v100" in text
    assert [plant.rail_value(m.extax)[0] for m in read_back(program, export).motions if isinstance(m, MoveJ)] == [
        0.25, 0.26, 0.27,
    ]  # fmt: skip


NESTED = """        FOR i FROM 1 TO 2 DO
            FOR j FROM 0 TO 2 DO
                FOR k FROM 1 TO 2 DO
                    IF i<>j MoveJ Offs(p1,i,j,k),v100,fine,tool0;
                ENDFOR
            ENDFOR
        ENDFOR
"""


def test_nested_loops_have_arrays_of_several_dimensions(plant: Plant) -> None:
    """Of those loops alone on which the values depend; passes that did not run have a neighbour's."""
    program = made(NESTED)
    every = [(i, j, k) for i in (1, 2) for j in (0, 1, 2) for k in (1, 2) if i != j]
    rails = {n: 0.25 + i / 100 + j / 1000 for n, (i, j, _) in enumerate(every)}
    export = export_rapid(program, plan_for(program, plant, rails), plant)
    text = export.texts["m.mod"]
    assert "LOCAL CONST num rail1{2,3}:=[[260,260,262],[270,271,271]];\n" in text
    assert "RailAt(Offs(p1,i,j,k),rail1{i,j+1}" in text
    deep = {n: 0.25 + i / 100 + j / 1000 + k / 10000 for n, (i, j, k) in enumerate(every)}
    text = export_rapid(program, plan_for(program, plant, deep), plant).texts["m.mod"]
    assert "rail1{2,3,2}:=[[[260.1,260.2],[260.1,260.2],[262.1,262.2]],[[270.1" in text
    assert "rail1{i,j+1,k}" in text


@pytest.mark.parametrize("bounds", ["1 TO n", "1 TO 3.5 STEP 1.5", "1 TO 2 STEP n", "1 TO n+1", "1 TO Dim(rows,n)"])
def test_passes_of_other_loops_are_tied(plant: Plant, bounds: str) -> None:
    body = f"        FOR i FROM {bounds} DO\n            MoveJ p1,v100,fine,tool0;\n        ENDFOR\n"
    found = changes(made(body, "    VAR num n:=1;\n    VAR num rows{2};\n"), plant)
    assert len(found.ties) == (1 if bounds != "1 TO n" else 0)
    assert found.ties in (((0, 1),), ())


P3 = "    CONST robtarget p3:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1350,9E9,9E9,9E9,9E9,9E9]];\n"
LITERAL = """        FOR i FROM 1 TO 3 DO
            MoveJ p3,v100,fine,tool0;
            MoveL p1,v100,fine,tool0;
        ENDFOR
"""


def test_only_the_aggregates_of_a_loop_over_literals_change(plant: Plant) -> None:
    program = made(LITERAL, P3)
    rails = dict.fromkeys((0, 2, 4), 1.2) | dict.fromkeys((1, 3, 5), 0.3)
    export = export_rapid(program, plan_for(program, plant, rails), plant)
    assert export.notes == ()
    assert [line for line in changed_lines(program, export) if line[0] == "+"] == [
        "+    CONST robtarget p1:=[[500,200,450],[0,0,1,0],[-1,0,-1,0],[300,9E9,9E9,9E9,9E9,9E9]]; ! first",
        "+    CONST robtarget p3:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1200,9E9,9E9,9E9,9E9,9E9]];",
    ]


def test_an_open_rail_is_said_for_all_passes(plant: Plant) -> None:
    """Only the first pass takes the rail along; the second would find it there by itself."""
    move = "            MoveJ Offs(p2,0,0,10),v100,fine,tool0;\n"
    body = f"        WHILE i<3 DO\n{move}            i:=i+1;\n        ENDWHILE\n"
    program = made(body, COUNT)
    assert changes(program, plant).ties == ((0, 1),)
    export = export_rapid(program, plan_for(program, plant, {0: 1.3, 1: 1.3}), plant)
    assert "[1300,9E9" in export.texts["m.mod"]


def test_a_wait_in_which_the_rail_moves_by_less_than_a_num_can_say_stays(plant: Plant) -> None:
    program = made(f"{J1}        WaitTime 0.5;\n        MoveL p1,v100,fine,tool0;\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 0.3 + 2e-9, 2: 0.3 + 2e-9}), plant)
    assert "        WaitTime 0.5;\n" in export.texts["m.mod"]


@pytest.mark.parametrize(("body", "data"), [(PICK, ""), (WHILE, COUNT)])
def test_every_wish_that_keeps_the_ties_can_be_written(plant: Plant, body: str, data: str) -> None:
    rng = np.random.default_rng(3)
    program = made(body.replace("p2", "p3"), P3 + data)
    found = changes(program, plant)
    first = {i: group[0] for group in found.ties for i in group}
    for _ in range(5):
        wanted = rng.uniform(0.1, 0.4, len(program.motions))
        rails = {i: float(wanted[first.get(i, i)]) if i % 5 < 4 else 1.2 for i in range(len(program.motions))}
        assert export_rapid(program, plan_for(program, plant, rails), plant).texts


@pytest.mark.parametrize(
    "call",
    ["Offs(p,0,0,20)", "Offs(p1,0,0,h)", "Offs(p1,0,0,n)", "fUp(p1)", "Offs(pNow,0,0,5)", "RelTool(pTaught,0,0,-20)"],
)
def test_no_expression_is_frozen(plant: Plant, call: str) -> None:
    """Neither in a routine called twice nor in one called once, with loops kept or unrolled."""
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
        assert (found.values, found.kept) == (frozenset(range(len(program.motions))), ())
        last = len(program.motions) - 1
        rails = dict.fromkeys(range(last), 0.3) | {last: 0.31}
        for loops in Loops:
            text = export_rapid(program, plan_for(program, plant, rails), plant, loops=loops).texts["m.mod"]
            assert f"MoveJ RailAt({call},300" in text or "[300,9E9" in text


def test_a_routine_called_for_targets_of_several_rails_stays_as_programmed(plant: Plant) -> None:
    """One value serves all calls; with loops unrolled each has its own."""
    rest = "    PROC go(robtarget p)\n        MoveJ p,v100,fine,tool0;\n    ENDPROC\n"
    program = made("        go p1;\n        go p3;\n        go p1;\n        go p3;\n", P3, rest)
    found = changes(program, plant)
    assert found.values == frozenset()
    assert [note.split("(")[1].split(")")[0] for note in found.kept] == [
        "run 4 times with different rail values or configurations"
    ]
    free = changes(program, plant, Loops.UNROLL)
    assert (free.values, free.ties) == ({0, 1, 2, 3}, ())
    plan = plan_for(program, plant, {0: 0.3, 1: 1.2, 2: 0.31, 3: 1.2})
    text = export_rapid(program, plan, plant, loops=Loops.UNROLL).texts["m.mod"]
    assert text.count("RailAt(p,") == 4
    assert "        go p1;\n        go_2 p3;\n        go_3 p1;\n        go_4 p3;\n" in text


@pytest.mark.parametrize("calls", ["        go p1;\n", "        pNow:=p1;\n        here;\n"])
def test_what_a_variable_names_is_wrapped(plant: Plant, calls: str) -> None:
    rest = "    PROC go(robtarget p)\n        MoveJ p,v100,fine,tool0;\n    ENDPROC\n"
    rest += "    PROC here()\n        MoveJ pNow,v100,fine,tool0;\n    ENDPROC\n"
    program = made(f"{J1}{calls}", "    VAR robtarget pNow;\n", rest)
    assert changes(program, plant).values == {0, 1}
    lines = changed_lines(program, export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.35}), plant))
    name = "p" if "go" in calls else "pNow"
    assert [line for line in lines if line[0] == "+" and "Move" in line] == [
        f"+        MoveJ RailAt({name},350\\conf:=[-1,0,-1,0]),v100,fine,tool0;"
    ]


def test_without_a_rail_configurations_are_free() -> None:
    """The shipped bench: one routine sets down at three targets."""
    job = read_job(PROGRAMS / "bench_irb140.mod")
    moving = [i for i, motion in enumerate(job.program.motions) if not isinstance(motion, SignalEvent)]
    found = changes(job.program, job.plant, scenario=job.scenario)
    assert set(moving) - found.values <= {i for i in moving if isinstance(job.program.motions[i], Wait)}
    free = changes(job.program, job.plant, Loops.UNROLL, job.scenario)
    assert len(free.ties) < len(found.ties)


def test_one_target_in_several_places_has_one_value(plant: Plant) -> None:
    """A displacement that grows from pass to pass."""
    body = WHILE.replace(" DO\n", " DO\n            PDispSet [[0,10*i,0],[1,0,0,0]];\n").replace("p2", "p3")
    program = made(body, P3 + COUNT)
    assert (0, 5, 10) in changes(program, plant).ties


def test_what_hangs_on_an_input_may_change_where_it_stands(plant: Plant) -> None:
    text = f"        WHILE TRUE DO\n            IF di1=1 THEN\n{J1}            ENDIF\n        ENDWHILE\n"
    scenario = Scenario(signals={"di1": 1.0}, endless_passes=3)
    base = made("        Set do1;\n").files["m.mod"]
    program = run_program([replace(base, text=base.text.replace("        Set do1;\n", text))], scenario)
    for loops in Loops:
        assert changes(program, plant, loops, scenario=scenario).ties == ((0, 1, 2),)


def test_optional_passes_go_all_together_or_not_at_all(plant: Plant) -> None:
    marked = PICK.replace("MoveJ p1,v100,fine,tool0;", "MoveAbsJ home,v100,fine,tool0; ! trajopt: optional")
    joint = marked.replace("MoveL Offs(p1,0,0,-50)", "MoveJ Offs(p1,0,0,-50)")
    assert changes(made(joint), plant).droppable == {0, 5, 10}
    alternating = joint.replace("MoveJ Offs(p1,0,0,-50),v100,fine,tool0;", "IF i<3 MoveJ p1,v100,fine,tool0;")
    alternating = alternating.replace("            WaitTime 0.5;\n", "")
    program = made(alternating)
    assert not isinstance(program.motions[-1], SignalEvent)
    assert changes(program, plant).droppable == frozenset()  # before the last line it may not go
