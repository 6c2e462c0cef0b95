from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rail_plans import J1, J2, changed_lines, made, plan_for, read_back

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.motion import MoveAbsJ, MoveJ, MoveL, Program, TextFile
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import read_program, run_program
from trajopt_cli.robot.inverse import confdata
from trajopt_cli.scenario import Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
OPEN = "9E9,9E9,9E9,9E9,9E9"
TARGETS = (
    "MODULE Punkte\n"
    "\t! die Türbänder, gemessen am Gerät\n"
    f"\tCONST robtarget pTür:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,{OPEN}]]; ! vor der Tür\n"
    f"\tLOCAL CONST robtarget pHere:=[[500,250,450],[0,0,1,0],[0,0,0,0],[250,{OPEN}]];\n"
    "\tPROC here()\n"
    "\t\tMoveL pHere,v100,fine,tool0;\n"
    "\t\tMoveL pHere,v50,fine,tool0;\n"
    "\tENDPROC\n"
    "ENDMODULE\n"
)
MAIN = "MODULE Start\n  PROC main()\n    MoveJ pTür,v100,fine,tool0; ! über\n    here;\n  ENDPROC\nENDMODULE\n"


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_cell.yaml"))


def two_modules(folder: Path, targets: bytes, main: bytes) -> Program:
    (folder / "targets.mod").write_bytes(targets)
    (folder / "main.mod").write_bytes(main)
    return read_program([folder / "main.mod", folder / "targets.mod"])


MIXED = (
    TARGETS.replace("\n", "\r\n").replace("Gerät\r\n", "Gerät\n").replace("fine,tool0;\r\n\t\t", "fine,tool0;\r\t\t")
)


@pytest.mark.parametrize(
    ("targets", "encoding"),
    [
        (TARGETS.replace("\n", "\r\n"), "cp1252"),
        (MIXED, "cp1252"),
        (TARGETS.rstrip("\n"), "utf-8"),
        (TARGETS.replace("\n", "\r\n"), "utf-8-sig"),
        ("\ufeff" + TARGETS.replace("\n", "\r\n"), "utf-16-le"),
        ("\ufeff" + TARGETS, "utf-16-be"),
    ],
    ids=["crlf-cp1252", "mixed", "no-final-newline", "bom", "utf-16-le", "utf-16-be"],
)
def test_each_module_is_edited_in_its_own_encoding_and_line_ends(
    plant: Plant, tmp_path: Path, targets: str, encoding: str
) -> None:
    program = two_modules(tmp_path, targets.encode(encoding), MAIN.encode())
    export = export_rapid(program, plan_for(program, plant, {0: 0.21, 1: 0.25, 2: 0.27}), plant)
    main, other = (str(tmp_path / name) for name in ("main.mod", "targets.mod"))
    assert program.files[other].encoding == encoding
    assert export.texts[main] == MAIN
    # By hand: the global target moves to 210; the two uses of the local one say their own, by a function that the
    # module has at its end, with the line end of the file; all else stays.
    end = "\r\n" if "\r\n" in targets else "\n"
    assert "MoveL RailAt(pHere,270\\conf:=[-1,0,-1,0]),v50,fine,tool0;" in export.texts[other]
    assert f"{end}\tLOCAL FUNC robtarget RailAt(robtarget p,num rail\\confdata conf){end}" in export.texts[other]
    # What is left after taking the edits out again is the file, byte for byte.
    back = re.sub(r"(\r\n|\r|\n)\t! p with.*ENDFUNC(\r\n|\r|\n)", "", export.texts[other], flags=re.DOTALL)
    back = re.sub(r"RailAt\(pHere,\d+(\\conf:=\[.*?\])?\)", "pHere", back)
    back = re.sub(r"(pTür:=\[\[500,200,450\],\[0,0,1,0\],)\[[^\]]*\],\[210,", r"\1[0,0,0,0],[200,", back)
    assert back.encode(encoding) == targets.encode(encoding)
    assert [m.extax[0] for m in read_back(program, export).motions if isinstance(m, MoveJ | MoveL)] == [210, 250, 270]


def test_each_module_has_its_own_function_under_a_name_that_nobody_has(plant: Plant) -> None:
    rest = "    LOCAL VAR num RAILAT;\n    PROC go()\n        MoveL p1,v50,fine,tool0;\n    ENDPROC\n"
    other = TextFile("b.mod", f"MODULE b\n{rest}ENDMODULE\n", "utf-8")
    program = made(J1 + "        go;\n", more={"b.mod": other})
    export = export_rapid(program, plan_for(program, plant, {0: 0.25, 1: 0.3}), plant)
    for path in ("m.mod", "b.mod"):
        assert "RailAt_2(p1," in export.texts[path]
        assert export.texts[path].count("LOCAL FUNC robtarget RailAt_2(") == 1


def test_a_parameter_is_wrapped_where_the_statement_names_it(plant: Plant) -> None:
    body = (
        f"        CONST robtarget near:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,{OPEN}]];\n"
        "        MoveJ near,v100,fine,tool0;\n        go near;\n"
    )
    program = made(body, rest="    PROC go(robtarget p)\n        MoveL p,v100,fine,tool0;\n    ENDPROC\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant)
    changes = changed_lines(program, export)
    assert changes[:2] == [
        "-        MoveL p,v100,fine,tool0;",
        "+        MoveL RailAt(p,300\\conf:=[-1,0,-1,0]),v100,fine,tool0;",
    ]
    assert len(changes) == 9


def test_an_array_stands_behind_records_and_never_inside_a_line(plant: Plant) -> None:
    rail = f"[200,{OPEN}]"
    head = "MODULE m(SYSMODULE) RECORD pair num a; num b; ENDRECORD CONST robtarget p1:=\n"
    text = (
        f"{head}    [[500,200,450],[0,0,1,0],[0,0,0,0],{rail}];\nPROC main()\nFOR i FROM 1 TO 2 DO\n"
        "MoveJ p1,v100,fine,tool0;\nENDFOR\nENDPROC ENDMODULE"
    )
    program = run_program([TextFile("m.mod", text, "utf-8")])
    text = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant).texts["m.mod"]
    first = text.splitlines()[0]
    assert first.startswith("MODULE m(SYSMODULE) RECORD pair num a; num b; ENDRECORD LOCAL CONST ")
    assert first.endswith("; CONST robtarget p1:=")
    assert text.endswith("\nENDFUNC\nENDMODULE")


BLANKS = st.sampled_from(["", " ", "\t", "  ", "\u00a0"])
ENDS = st.sampled_from(["\n", "\r\n", "\r"])
NOTES = st.sampled_from(["", " ! übrig", " !\u2028 x", "!\x0c", " ! trajopt"])


@st.composite
def programs(draw: st.DrawFn) -> str:
    """A module of a few moves in any lay-out; every line ends on its own."""
    lines = [
        "MODULE m",
        f"CONST robtarget p1:=[[500,200,450],[0,0,1,0],[-1,0,-1,0],[{draw(ROUND)},{OPEN}]];",
        "PROC main()",
    ]
    for _ in range(draw(st.integers(1, 4))):
        target = draw(st.sampled_from(["p1", "Offs(p1,0,0,0)", "[p1.trans,p1.rot,p1.robconf,p1.extax]"]))
        lines.append(
            f"{draw(BLANKS)}MoveJ{draw(BLANKS)} {target}{draw(BLANKS)},v100,fine{draw(BLANKS)},tool0;{draw(NOTES)}"
        )
        lines += draw(st.lists(st.sampled_from(["", "WaitTime 0.5;", "Set do1;Reset do1;"]), max_size=2))
    return "".join(line + draw(ENDS) for line in [*lines, "ENDPROC"]) + "ENDMODULE" + draw(st.sampled_from(["", "\n"]))


ROUND = st.sampled_from(["250", "250.", "2.5E2", "+250", "250.0000001"])


@given(programs())
@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_plan_that_wishes_nothing_changes_no_character(plant: Plant, text: str) -> None:
    program = run_program([TextFile("m.mod", text, "utf-8")])
    export = export_rapid(program, plan_for(program, plant, {0: 0.25}), plant)
    assert export.texts == {"m.mod": text}
    assert tuple(map(str, export.notes)) == ()


# ------------------------------------------------------------------------------------ modal state, other instructions


def test_what_eoffs_adds_is_taken_out_of_the_literal(plant: Plant) -> None:
    body = "        EOffsSet [30,0,0,0,0,0];\n" + J1 + "        MoveAbsJ home\\NoEOffs,v100,fine,tool0;\n"
    program = made(body)
    assert [m.extax[0] for m in program.motions if isinstance(m, MoveJ | MoveAbsJ)] == [230, 0]
    export = export_rapid(program, plan_for(program, plant, {0: 0.25, 1: 0.1}), plant)
    assert "p1:=[[500,200,450],[0,0,1,0],[-1,0,-1,0],[220,9E9" in export.texts["m.mod"]
    assert f"home:=[[0,0,0,0,30,0],[100,{OPEN}]];" in export.texts["m.mod"]
    unchanged = export_rapid(program, plan_for(program, plant, {0: 0.23, 1: 0.0}), plant)
    assert f"[200,{OPEN}]]; ! first" in unchanged.texts["m.mod"]


def test_a_computed_target_stays_in_the_displaced_frame_of_its_move(plant: Plant) -> None:
    data = '    PERS wobjdata w:=[FALSE,TRUE,"",[[0,100,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n'
    body = (
        "        PDispSet [[0,0,20],[1,0,0,0]];\n" + "        MoveJ p1,v100,fine,tool0\\WObj:=w;\n"
        "        MoveL Offs(p1,0,-10,-50),v100,fine,tool0\\WObj:=w;\n"
    )
    program = made(body, data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.2, 1: 0.3}), plant)
    assert "MoveL RailAt(Offs(p1,0,-10,-50),300\\conf:=" in export.texts["m.mod"]
    again = read_back(program, export).motions[1]
    assert isinstance(again, MoveL)
    np.testing.assert_allclose(again.X_WT[:3, 3], [0.5, 0.29, 0.42], atol=1e-12)


NEAR = "        MoveJ p1,v100,fine,tool0;\n        MoveL Offs(p1,0,0,40),v100,fine,tool0;\n"
SIDE = "        MoveJ p1,v100,fine,tool0;\n        MoveL Offs(p1,0,60,0),v100,fine,tool0;\n"
SEAM = "    PERS seamdata seam1:=[0,0,0,0];\n    PERS welddata weld1:=[10,0,[0,0,0,0,0,0,0,0,0],[0,0,0,0,0,0,0,0,0]];\n"


@pytest.mark.parametrize(
    ("before", "data", "line"),
    [
        (NEAR, "", "MoveLDO p1, v100, fine, tool0, do1, 1;"),
        (NEAR, "    VAR triggdata tr;\n", "TriggL p1, v100, tr, fine, tool0;"),
        (NEAR, SEAM, "ArcL p1, v100, seam1, weld1, fine, tool0;"),
        (NEAR, "    VAR robtarget p2_hit;\n", "SearchL di1, p2_hit, p1, v100, tool0;"),
        (SIDE, "", "MoveC Offs(p1,-20,30,0), p1, v100, fine, tool0;"),
    ],
    ids=["MoveLDO", "TriggL", "ArcL", "SearchL", "MoveC"],
)
def test_target_speed_and_tool_are_found_in_every_form_of_move(plant: Plant, before: str, data: str, line: str) -> None:
    scenario = Scenario(searches={"p2_hit": 1.0})
    ready = "        TriggIO tr, 5\\DOp:=do1, 1;\n" if "Trigg" in line else ""
    body = f"{before}{ready}        {line}\n        WaitTime 0.5;\n"
    text = made("", data).files["m.mod"].text.replace("main()\n", f"main()\n{body}")
    program = run_program([TextFile("m.mod", text, "utf-8")], scenario)
    last = len(program.motions) - 1
    plan = plan_for(program, plant, {0: 0.2, 1: 0.2, last - 1: 0.3, last: 0.31})
    export = export_rapid(program, plan, plant, scenario=scenario)
    moved = "RailAt(p1,300\\conf:=[-1,0,-1,0])"
    assert f"        {line.replace(' p1,', f' {moved},')}\n" in export.texts["m.mod"]
    assert f"        MoveL {moved.replace('300', '310')},v100\\T:=0.5,fine,tool0;\n" in export.texts["m.mod"]


# ------------------------------------------------------------------------------------------- confdata switched off


def test_confdata_that_is_switched_off_is_left_alone_where_the_nearest_is_planned(plant: Plant) -> None:
    program = made("        ConfJ\\Off;\n        ConfL\\Off;\n" + J1 + "        MoveL p1,v50,fine,tool0;\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.25, 1: 0.25}), plant)
    assert changed_lines(program, export)[1:] == [
        f"+    CONST robtarget p1:=[[500,200,450],[0,0,1,0],[0,0,0,0],[250,{OPEN}]]; ! first"
    ]


def test_another_configuration_than_the_nearest_is_switched_on(plant: Plant) -> None:
    body = "        ConfJ\\Off;\n" + J1 + J2 + "        MoveJ p1,v50,fine,tool0;\n"
    program = made(body)
    plan = plan_for(program, plant, {0: 0.2, 1: 1.35, 2: 0.2}, cfx={1: 1, 2: 1})  # the wrist turned over, needlessly
    export = export_rapid(program, plan, plant)
    assert [line for line in changed_lines(program, export) if "Conf" in line] == [
        "+        ConfJ \\On;",
        "+        ConfJ \\Off;",
    ]
    assert (
        "        ConfJ \\On;\n        MoveJ p2,v100,fine,tool0;\n        ConfJ \\Off;\n        MoveJ p1,v50"
        in export.texts["m.mod"]
    )
    assert [note for note in tuple(map(str, export.notes)) if "nearest" in note] == [
        "m.mod:8:9: ConfJ \\On added: the plan needs a configuration other than the nearest"
    ]
    moves = [m for m in read_back(program, export).motions if isinstance(m, MoveJ)]
    assert [m.settings.conf_j for m in moves] == [False, True, False]
    assert moves[1].conf == confdata(plant.robot, plan.motions[1].q_1[1:])


# ---------------------------------------------------------------------------------- what is computed from a literal


def test_a_literal_stays_where_something_that_must_stay_is_computed_from_it(plant: Plant) -> None:
    """The two calls want p1's own rail for what they compute, so p1 itself cannot be edited."""
    body = J1 + "        go 1;\n        IF TRUE go 2;\n"
    rest = "    PROC go(num k)\n        MoveL Offs(p1,0,0,-10*k),v100,fine,tool0;\n    ENDPROC\n"
    program = made(body, rest=rest)
    export = export_rapid(program, plan_for(program, plant, {0: 0.3, 1: 0.2, 2: 0.2}), plant)
    rails = [m.extax[0] for m in read_back(program, export).motions if isinstance(m, MoveJ | MoveL)]
    assert rails == [300, 200, 200]
    assert "MoveJ RailAt(p1,300\\conf:=[-1,0,-1,0]),v100" in export.texts["m.mod"]


def test_a_literal_stays_where_the_program_asks_for_its_rail(plant: Plant) -> None:
    program = made(J1 + "        IF p1.extax.eax_a>250 THEN\n            Set do1;\n        ENDIF\n")
    export = export_rapid(program, plan_for(program, plant, {0: 0.3}), plant)
    assert "MoveJ RailAt(p1,300\\conf:=[-1,0,-1,0]),v100" in export.texts["m.mod"]
    assert f"[200,{OPEN}]]; ! first" in export.texts["m.mod"]


def test_elements_of_an_array_are_said_where_they_are_used(plant: Plant) -> None:
    data = (
        f"    CONST robtarget ps{{2}}:=[[[500,200,450],[0,0,1,0],[0,0,0,0],[200,{OPEN}]],"
        f"[[500,300,450],[0,0,1,0],[0,0,0,0],[300,{OPEN}]]];\n"
    )
    loop = "        FOR i FROM 1 TO 2 DO\n            MoveJ ps{i},v100,fine,tool0;\n        ENDFOR\n"
    program = made("        MoveJ ps{1},v100,fine,tool0;\n" + loop, data)
    export = export_rapid(program, plan_for(program, plant, {0: 0.25, 1: 0.21, 2: 0.31}), plant)
    text = export.texts["m.mod"]
    assert "        MoveJ RailAt(ps{1},250\\conf:=[-1,0,-1,0]),v100,fine,tool0;\n" in text
    assert "            MoveJ RailAt(ps{i},rail_ps{i}\\conf:=[-1,0,-1,0]),v100,fine,tool0;\n" in text
    assert "    LOCAL CONST num rail_ps{2}:=[210,310];\n" in text


def test_a_target_that_two_modules_declare_stays_in_both(plant: Plant) -> None:
    declared = f"PERS robtarget g:=[[500,600,450],[0,0,1,0],[0,0,0,0],[0,{OPEN}]];"
    other = TextFile("b.mod", f"MODULE b\n    {declared}\n    PROC other()\n    ENDPROC\nENDMODULE\n", "utf-8")
    main = f"MODULE m\n    {declared}\n    PROC main()\n        MoveJ g,v100,fine,tool0;\n    ENDPROC\nENDMODULE\n"
    program = run_program([TextFile("m.mod", main, "utf-8"), other])
    export = export_rapid(program, plan_for(program, plant, {0: 0.2}), plant)
    assert export.texts["b.mod"] == other.text
    assert declared in export.texts["m.mod"]
    assert "MoveJ RailAt(g,200),v100,fine,tool0;" in export.texts["m.mod"]
    assert [m.extax[0] for m in read_back(program, export).motions if isinstance(m, MoveJ)] == [200]
    alone = run_program([TextFile("m.mod", main, "utf-8")])
    assert "MoveJ g,v100" in export_rapid(alone, plan_for(alone, plant, {0: 0.2}), plant).texts["m.mod"]
