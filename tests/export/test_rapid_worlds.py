"""What of a plan can be written into a program whose world is only known by its scenario."""

from __future__ import annotations

from pathlib import Path

import pytest
from rail_plans import J1, made

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.export.rapid_reading import Reading
from trajopt_cli.export.rapid_writable import writable
from trajopt_cli.motion import Program
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Answer, Scenario

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
        (f"{ASK}        TEST n\n        CASE 3:\n            h:=80;\n        ENDTEST\n{UP.replace('50', 'h')}", 2.0, set()),
        (f'        TPReadNum n,"?";\n        IF n>700 h:=80;\n{UP.replace("50", "h")}{J1}', 1.0, {1}),
    ],
)  # fmt: skip
def test_a_target_is_pinned_by_what_it_hangs_on_only(plant: Plant, body: str, answer: Answer, free: set[int]) -> None:
    scenario = Scenario(answers={"n": answer})
    program = asking(body, scenario, "    VAR num n;\n    VAR num h:=50;\n")
    assert writable(program, plant, Reading(program, plant, scenario)) == free
