"""Additional points in RAPID text: what is written, and that it reads back as the program with the points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import pytest
from rail_plans import J1, J2, changed_lines, made, plan_for, read_back
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.exporters.rapid_write import RapidExport
from trajopt_cli.geometry import pose
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Move, MoveAbsJ, MoveJ, Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.problem.detours import Detour, Numbering, Via, folded, with_detours
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.editable_text import EditableText
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario
from trajopt_cli.shapes import Box, Solid
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
ONE = np.r_[0.25, 0.6, -0.4, -0.3, 0.4, 0.9, -0.5]
TWO = np.r_[0.4, 0.9, -0.2, -0.4, 0.3, 1.1, 0.2]
HELD = np.r_[0.2, ONE[1:]]
WAY = "! trajopt: way around 'column'"
ABSJ = "        MoveAbsJ home,v100,fine,tool0;\n"
Ways = Mapping[int, Sequence[Via]]


def detours(ways: Ways, around: tuple[str, ...] = ("column",)) -> tuple[Detour, ...]:
    return tuple(Detour(motion, tuple(points), around) for motion, points in ways.items())


def plan_around(
    program: Program,
    ways: Ways,
    plant: Plant = PLANT,
    around: tuple[str, ...] = ("column",),
    rails: Mapping[int, float] | None = None,
) -> Plan:
    """A plan that goes by these points. rails [m]: after the program's own motions; elsewhere as they say."""
    found = detours(ways, around)
    there, numbering = with_detours(program, plant, found), Numbering(len(program.motions), found)
    where = {numbering.at(i): rail for i, rail in (rails or {}).items()}
    for k, motion in enumerate(there.motions):
        if isinstance(motion, Move) and (given := plant.rail_value(motion.extax)) is not None:
            where.setdefault(k, given[0])
    return folded(plan_for(there, plant, where), program, found)


def there_and_back(
    program: Program,
    ways: Ways,
    plant: Plant = PLANT,
    rails: Mapping[int, float] | None = None,
    loops: Loops = Loops.KEEP,
) -> RapidExport:
    """Export, and hold what is read back against the program with the points, motion by motion."""
    plan = plan_around(program, ways, plant, rails=rails)
    export = export_rapid(program, plan, plant, loops=loops)
    read = read_back(program, export).motions
    wanted = with_detours(program, plant, plan.detours).motions
    assert len(read) == len(wanted)
    for one, other in zip(read, wanted, strict=True):
        assert type(one) is type(other)
        if not isinstance(one, Move) or not isinstance(other, Move):
            continue
        assert (one.zone, one.speed, one.marked) == (other.zone, other.speed, other.marked)
        assert (one.settings, one.hold, one.optional) == (other.settings, other.hold, other.optional)
        if isinstance(one, MoveJ) and isinstance(other, MoveJ):
            np.testing.assert_allclose(one.X_WT, other.X_WT, rtol=0, atol=1e-6)
            np.testing.assert_allclose(one.tool.X_FT, other.tool.X_FT, rtol=0, atol=1e-9)
            assert one.wobj == other.wobj
        if isinstance(one, MoveAbsJ) and isinstance(other, MoveAbsJ):
            np.testing.assert_allclose(one.q, other.q, rtol=0, atol=2e-7)
        if other.detour:
            assert one.target == other.target
            assert getattr(one, "conf", None) == getattr(other, "conf", None)
            assert one.extax[0] == pytest.approx(other.extax[0], abs=1e-3)
    return export


def changes(program: Program, loops: Loops = Loops.KEEP, scenario: Scenario | None = None) -> Changes:
    return EditableText(program, PLANT, scenario or Scenario(), loops).changes


def test_points_are_lines_of_their_own_and_constants_beside_the_others() -> None:
    program = made("        MoveJ p1,v100,z10,tool0\\WObj:=wobj0; ! go\n" + ABSJ)
    export = there_and_back(program, {0: [Via(ONE, 0.02), Via(TWO)], 1: [Via(TWO, 0.05)]})
    lines = changed_lines(program, export)
    declared = [line for line in lines if ":=[" in line]
    assert [line.split(":=[")[0] for line in declared] == [
        "+    CONST robtarget pVia_10",
        "+    CONST robtarget pVia_20",
        "+    CONST jointtarget jVia_30",
    ]
    assert declared[0].endswith(",[0,0,-1,0],[250,9E9,9E9,9E9,9E9,9E9]];")
    assert [line for line in lines if line not in declared] == [
        f"+        MoveJ pVia_10, v100, z20, tool0 \\WObj:=wobj0; {WAY}",
        f"+        MoveJ pVia_20, v100, fine, tool0 \\WObj:=wobj0; {WAY}",
        f"+        MoveAbsJ jVia_30, v100, z50, tool0; {WAY}",
    ]
    text = next(iter(export.texts.values()))
    assert text.index("CONST robtarget pVia_10") < text.index("CONST robtarget p1:=")
    notes = [str(note) for note in export.notes]
    assert "m.mod:6:9: pVia_10, pVia_20 are added before p1, around 'column'" in notes
    assert "m.mod:7:9: jVia_30 is added before home, around 'column'" in notes


FRAMES = """    TASK PERS tooldata grip:=[TRUE,[[10,-20,130],[0.9238795,0,0.3826834,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
    TASK PERS wobjdata table:=[FALSE,TRUE,"",[[300,100,20],[0.9659258,0,0,0.258819]],[[1,2,3],[1,0,0,0]]];
    CONST pose shift:=[[5,10,20],[0.9914449,0,0,0.1305262]];
    CONST robtarget pt:=[[200,100,430],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];
"""


@pytest.mark.parametrize(
    ("body", "written"),
    [
        pytest.param("MoveJ p1,v100,z10,grip\\WObj:=table;", "v100, z20, grip \\WObj:=table", id="tool and wobj"),
        pytest.param("PDispSet shift;\nMoveJ pt,v100,z10,grip\\WObj:=table;", "v100, z20, grip", id="displaced"),
        pytest.param("EOffsSet [50,0,0,0,0,0];\nMoveJ p1,v100,fine,tool0;", "v100, z20, tool0", id="offset axes"),
        pytest.param("EOffsSet [50,0,0,0,0,0];\nMoveAbsJ home,v100,fine,tool0;", "jVia_10, v100", id="offset joints"),
        pytest.param(
            "EOffsSet [50,0,0,0,0,0];\nMoveAbsJ home\\NoEOffs,v100,fine,tool0;", "jVia_10\\NoEOffs, v100", id="none"
        ),
        pytest.param("MoveJ p1,v100\\V:=250,fine,tool0;", "v100\\V:=250, z20, tool0", id="own speed"),
        pytest.param("MoveJ Offs(p1,0,0,40),v100,fine,tool0;", "pVia_10, v100, z20, tool0", id="computed"),
        pytest.param("MoveJ RelTool(p1,0,0,-40),v100,fine,tool0;", "pVia_10, v100", id="seen by the tool"),
        pytest.param(
            "MoveJ [[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;",
            "pVia_10, v100",
            id="in the statement",
        ),
        pytest.param("MoveJDO p1,v100,fine,tool0,do1,1;", "MoveJ pVia_10, v100, z20, tool0;", id="with an output"),
        pytest.param("ConfJ \\Off;\nMoveJ p1,v100,fine,tool0;", "ConfJ \\On;", id="any configuration"),
        pytest.param("MoveJ p1,v100,fine,tool0; ! trajopt: optional", "pVia_10, v100", id="marked behind"),
        pytest.param("! trajopt: optional\nMoveJ p1,v100,fine,tool0;", "pVia_10, v100", id="marked above"),
        pytest.param("IF TRUE THEN MoveJ p1,v100,fine,tool0; ENDIF", "IF TRUE THEN MoveJ pVia_10", id="in a branch"),
        pytest.param("MoveAbsJ home,v100,fine,tool0; MoveJ p1,v100,fine,tool0;", "tool0; MoveJ pVia_10", id="one line"),
    ],
)
def test_what_is_in_force_at_the_move_is_in_force_at_its_points(body: str, written: str) -> None:
    program = made(f"{body}\n", data=FRAMES)
    at = [i for i, motion in enumerate(program.motions) if isinstance(motion, MoveJ | MoveAbsJ)][-1]
    assert (at,) in changes(program).detours
    there = with_detours(program, PLANT, detours({at: [Via(ONE, 0.02)]}))
    if not isinstance(program.motions[at], MoveAbsJ):
        assert isinstance(there.motions[at], MoveJ)
    export = there_and_back(program, {at: [Via(ONE, 0.02)]})
    assert written in next(iter(export.texts.values()))


def test_a_held_rail_is_held_on_the_way_too() -> None:
    program = made(J1 + "! trajopt: hold rail\n        MoveJ Offs(p1,0,0,40),v100,fine,tool0;\n")
    export = there_and_back(program, {1: [Via(HELD, 0.02)]})
    assert f"        {WAY}\n        MoveJ pVia_10, v100, z20, tool0; ! trajopt: hold rail\n! trajopt: hold rail\n" in (
        next(iter(export.texts.values()))
    )


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_line_ends_and_letters_are_the_files_own(end: str) -> None:
    home = "[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]]"
    text = f"MODULE m\nPROC main()\n{ABSJ}ENDPROC\nENDMODULE\n".replace("home", home)
    program = run_program([TextFile("m.mod", text.replace("\n", end), "cp1252")])
    names = ("Säule 柱", "bob's   fence")
    export = export_rapid(program, plan_around(program, {0: [Via(ONE)]}, around=names), PLANT)
    made_text = export.texts["m.mod"]
    assert made_text.encode("cp1252").count(end.encode()) == 7
    assert "! trajopt: way around 'Säule ?', 'bob''s fence'" in made_text
    (first, _) = read_back(program, export).motions
    assert isinstance(first, MoveAbsJ)
    assert first.marked == ("Säule ?", "bob's fence")


LOOP = f"        FOR i FROM 1 TO 2 DO\n    {J1}    {ABSJ}        ENDFOR\n"


def test_passes_of_a_loop_share_their_points_and_the_text_has_them_once() -> None:
    program = made(LOOP)
    assert changes(program).detours == ((0, 2), (1, 3))
    same = [Via(ONE, 0.02)]
    export = there_and_back(program, {0: same, 2: same})
    text = next(iter(export.texts.values()))
    assert text.count("pVia_10") == 2  # declared, and driven to


def test_calls_that_differ_get_copies_of_the_routine_where_loops_are_unrolled() -> None:
    rest = f"    PROC go()\n{J1}{ABSJ}    ENDPROC\n"
    program = made("        go;\n        go;\n", rest=rest)
    assert changes(program).detours == ((0, 2), (1, 3))
    assert changes(program, Loops.UNROLL).detours == ((0,), (1,), (2,), (3,))
    ways = {0: [Via(ONE, 0.02)], 1: [Via(ONE)], 2: [Via(TWO)], 3: [Via(ONE)]}
    plan = plan_around(program, ways)
    with pytest.raises(InputError):
        export_rapid(program, plan, PLANT)
    text = there_and_back(program, ways, loops=Loops.UNROLL).texts["m.mod"]
    assert text.count("    PROC go_2()\n") == 1
    assert f"        MoveJ pVia_10, v100, z20, tool0; {WAY}\n" in text
    assert f"        MoveJ pVia_30, v100, fine, tool0; {WAY}\n" in text


def test_a_routine_with_other_frames_in_its_calls_has_no_points() -> None:
    rest = "    PROC go(PERS tooldata t)\n        MoveJ p1,v100,fine,t;\n    ENDPROC\n"
    bare = "    TASK PERS tooldata bare:=[TRUE,[[0,0,0],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];"
    data = f"{FRAMES.splitlines()[0]}\n{bare}\n"
    program = made("        go grip;\n        go bare;\n        go grip;\n", data=data, rest=rest)
    found = changes(program)
    assert found.detours == ()
    assert set(found.straight.values()) == {"its tool, work object or settings are not the same in all passes"}
    alike = made("        go grip;\n        go grip;\n", data=data, rest=rest)
    assert changes(alike).detours == ((0, 1),)
    there_and_back(alike, {0: [Via(ONE)], 1: [Via(ONE)]})


def test_a_point_is_declared_in_the_module_of_its_move() -> None:
    """The target is another module's, where a name may be LOCAL, or a routine's own."""
    work = """MODULE work
    PROC go()
        CONST robtarget mine:=[[500,200,470],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];
        MoveJ p1,v100,fine,tool0;
        MoveJ mine,v100,fine,tool0;
    ENDPROC
ENDMODULE
"""
    program = made("        go;\n", more={"work.mod": TextFile("work.mod", work, "utf-8")})
    export = there_and_back(program, {0: [Via(ONE)], 1: [Via(TWO)]})
    assert export.texts["m.mod"] == program.files["m.mod"].text
    head = export.texts["work.mod"].split("PROC go()")[0]
    assert head.count("CONST robtarget pVia_") == 2


@pytest.mark.long
def test_what_the_planner_finds_is_written_and_judged_as_written() -> None:
    """From a post in the way to the exported text, whose program the plan's rows carry out."""
    data = """CONST robtarget p_a:=[[450,-300,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_b:=[[450,300,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
    program = rapid("ConfJ \\Off;\nMoveJ p_a,v1000,fine,tool0;\nMoveJ p_b,v1000,fine,tool0;", data=data)
    post = Solid(Box("post", np.array([0.1, 0.1, 0.45]), pose(np.eye(3), [0.45, 0.0, 0.25])))
    plant = plant_without_rail(obstacles=(post,), clearance=0.01)
    plan = optimize(program, plant, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    export = export_rapid(program, plan, plant)
    text = export.texts["t.mod"]
    assert text.count("! trajopt: way around 'post'\n") == len(plan.detours[0].points)
    read = read_back(program, export)
    report = verify(read, plant, plan.trajectory, None, (), Target.RAPID, advice=False)
    assert report.legal, [one.message for one in report.findings if not one.passed]
    assert not verify(read, plant, straight(program), None, (), Target.RAPID, advice=False).legal


def straight(program: Program) -> Trajectory:
    """What the program asks for where nothing is in its way."""
    plan = optimize(program, plant_without_rail(), Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    return plan.trajectory


def test_moves_that_can_have_no_points_say_why() -> None:
    program = made("        IF TRUE MoveJ p1,v100,fine,tool0;\n        MoveJ p1,v100\\T:=2,fine,tool0;\n")
    found = changes(program)
    assert found.detours == ()
    assert found.straight[0].startswith("it is part of an IF without THEN")
    assert found.straight[1] == r"its time is programmed (\T)"
    with pytest.raises(InputError, match="IF without THEN"):
        export_rapid(program, plan_around(program, {0: [Via(ONE)]}), PLANT)


def test_an_open_rail_that_cannot_be_closed_has_no_points() -> None:
    """It is where the caller left it, which one number cannot say."""
    rest = "    PROC go()\n" + J2 + "    ENDPROC\n"
    p3 = J1.replace("p1", "[[500,1350,450],[0,0,1,0],[0,0,0,0],[1350,9E9,9E9,9E9,9E9,9E9]]")
    found = changes(made(f"{J1}        go;\n{p3}        go;\n", rest=rest))
    assert found.values == {0, 2}
    why = "it leaves the rail where it is (9E9), and its target cannot be changed"
    assert found.straight == dict.fromkeys((1, 3), why)
    assert changes(made(J2)).detours == ((0,),)  # p2's own rail is open, too, and a number may stand there


def test_an_open_rail_is_closed_where_the_way_takes_the_rail_along() -> None:
    """Passes whose rail is where it was before: the number stays open, but not behind a point with another one."""
    first = J2.replace("p2", "Offs(p1,0,1150,0)")
    program = made(first + "        FOR i FROM 1 TO 2 DO\n    " + J2 + "        ENDFOR\n")
    plan = plan_around(program, {}, rails=dict.fromkeys(range(3), 1.35))
    (first, *_) = read_back(program, export_rapid(program, plan, PLANT)).motions[1:]
    assert isinstance(first, MoveJ)
    assert first.extax[0] is None
    away = np.r_[1.5, TWO[1:]]
    ways = {key: [Via(away)] for key in (1, 2)}
    export = there_and_back(program, ways, rails=dict.fromkeys(range(3), 1.35))
    read = [motion for motion in read_back(program, export).motions if isinstance(motion, MoveJ)]
    assert [motion.extax[0] for motion in read] == pytest.approx([1350, 1500, 1350, 1500, 1350])


def test_free_speed_counts_for_the_points_as_well() -> None:
    plant = plant_with_rail(free_speed=True)
    program = made(J1)
    plan = plan_around(program, {0: [Via(ONE)]}, plant)
    export = export_rapid(program, plan, plant, faster=frozenset({0}))
    assert f"MoveJ pVia_10, vmax, fine, tool0; {WAY}" in next(iter(export.texts.values()))


def test_a_robot_without_a_rail_has_points_too() -> None:
    plant = plant_without_rail()
    program = run_program([TextFile("m.mod", f"""MODULE m
    CONST robtarget p1:=[[500,0,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
{J1}    ENDPROC
ENDMODULE
""", "utf-8")])  # fmt: skip
    export = there_and_back(program, {0: [Via(ONE[1:], 0.1)]}, plant)
    assert "[9E9,9E9,9E9,9E9,9E9,9E9]];\n" in next(iter(export.texts.values())).split("pVia_10:=")[1]


def test_what_was_exported_once_takes_more_points() -> None:
    program = made(J1 + J2)
    once = there_and_back(program, {0: [Via(ONE, 0.02)]}, rails={1: 1.35})
    again = read_back(program, once)
    assert [m.target for m in again.motions if isinstance(m, MoveJ)] == ["pVia_10", "p1", "p2"]
    assert [m.detour for m in again.motions if isinstance(m, MoveJ)] == [(), (), ()]  # its own now
    twice = there_and_back(again, {2: [Via(TWO, 0.02)]}, rails={2: 1.35})
    targets = [m.target for m in read_back(again, twice).motions if isinstance(m, MoveJ)]
    assert targets == ["pVia_10", "p1", "pVia_20", "p2"]
