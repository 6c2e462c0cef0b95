"""rail_at in the cell file: where the rail stood for targets that leave it open (9E9)."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.motion import Move, Program, SignalEvent, TextFile
from trajopt_cli.problem.editable import droppable
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.rapid.reader import run_program

PROGRAMS = Path(__file__).parents[2] / "programs"
LINE, CELL = ((PROGRAMS / f"hinge_line.{end}").read_text(encoding="utf-8") for end in ("mod", "yaml"))
GIVEN = re.compile(r"\],\[(0|1500),9E9")
OPEN = GIVEN.sub("],[9E9,9E9", LINE)
POINTS = "".join(
    f"  {line.split(':=')[0].split()[-1]}: {found[1]} mm\n"
    for line in LINE.splitlines()
    if (found := GIVEN.search(line))
)
SIGNALS = OPEN.replace("    PROC main()\n", "    PROC main()\n        SetDO doRail,1;\n")
for home, value in (("_n2, v2500", 2), (", v2500", 1)):
    SIGNALS = SIGNALS.replace(f"MoveAbsJ j_home{home}", f"SetDO doRail,{value};\n        MoveAbsJ j_home{home}")
BASE = "robot: irb140_rail\nrail: {eax: a, stroke: [-0.2, 2.2]}\nstart: {joints: [0, 0, 0, 0, 0.5, 0], rail: 0}\n"
P = "[[500,0,500],[0,0,1,0],[0,0,0,0],[%s,9E9,9E9,9E9,9E9,9E9]];"


def read(module: str, cell: str) -> Program:
    return run_program([TextFile("m.mod", module, "utf-8")], parse_cell(cell, "cell.yaml").scenario)


def rails(program: Program) -> list[float | None]:
    return [one.extax[0] for one in program.motions if isinstance(one, Move)]


@pytest.mark.parametrize(
    ("module", "entries"),
    [
        (OPEN, f"\n{POINTS}"),
        (OPEN, "{MAIN: 1500 mm, ServeN1: 0, j_home: 0}"),
        (SIGNALS, "{doRail = 1: 0, DORAIL=2: 1.5}"),
    ],
    ids=["points", "procedures", "outputs"],
)
def test_the_hinge_line_without_its_rail_values_is_the_same_with_rail_at(module: str, entries: str) -> None:
    assert set(rails(read(module, CELL))) == {None}
    program, written = read(module, f"{CELL}rail_at: {entries}"), read(LINE, CELL)
    assert rails(program) == rails(written)
    assert not program.warnings
    plant = build_plant(parse_cell(CELL, "cell.yaml"))
    names = [
        [getattr(one.motions[i], "target", "") for i in sorted(droppable(one, plant))] for one in (program, written)
    ]
    assert names[0] == names[1]  # an output that drives the rail keeps no point


BODY = """MoveL p,v100,fine,tool0; MoveL Offs(p,0,0,9),v100,fine,tool0;
Set doA; Go q; MoveL given,v100,fine,tool0; Reset doA; MoveLDO r,v100,fine,tool0,doB,1; MoveL r,v100,fine,tool0;"""


@pytest.mark.parametrize(
    ("entries", "expected"),
    [
        ("{p: 0.1}", [100, 100, None, 70, None, None]),
        ("{q: 0.2}", [None, None, 200, 70, None, None]),
        ("{main: 0.1, Go: 0.2, t: 0.3}", [100, 100, 300, 70, 100, 100]),
        ("{main: 0.1, Go: 0.2}", [100, 100, 200, 70, 100, 100]),
        ("{doA = 1: 0.1, doA = 0: 0.2, doB = 1: 0.3}", [None, None, 100, 70, 200, 300]),
        ("{doA = 1: 0.1, Go: 0.3, r: 0.5}", [None, None, 300, 70, 500, 500]),
    ],
)
def test_a_point_goes_before_a_procedure_and_that_before_an_output(entries: str, expected: list[float | None]) -> None:
    data = "".join(f"CONST robtarget {name}:={P % value}\n" for name, value in zip("pqr", ["9E9"] * 3, strict=True))
    data += f"CONST robtarget given:={P % 70}\n"
    rest = "PROC Go(robtarget t)\nMoveL t,v100,fine,tool0;\nENDPROC\n"
    module = f"MODULE m\n{data}PROC main()\n{BODY}\nENDPROC\n{rest}ENDMODULE\n"
    program = read(module, f"{BASE}rail_at: {entries}\n")
    assert rails(program) == expected
    assert [one.drives_rail for one in program.motions if isinstance(one, SignalEvent)][:1] == ["doA = 1" in entries]


@pytest.mark.parametrize(
    ("cell", "message"),
    [
        ("rail_at:\n  p_n1: 0\n  p_n11_in: 0.2\n", ":6: rail_at.p_n11_in: .*did you mean 'p_n1_in'"),
        ("rail_at: {ServN1: 0}\n", ":4: rail_at.ServN1: .*did you mean 'ServeN1'"),
        ("rail_at: {doRial = 2: 0}\n", ":4: rail_at.doRial = 2: .*did you mean 'doRail'"),
        ("rail_at: {p_n1: 15}\n", ":4: rail_at.p_n1: 15 m is not on the rail, whose stroke is -0.2..2.2 m"),
        ("rail_at: {p_n1: 1, P_N1: 2}\n", ":4: rail_at.P_N1: is the same to RAPID as rail_at.p_n1"),
        ("rail_at: {p_n1: here}\n", ":4: rail_at.p_n1: "),
    ],
)
def test_what_is_no_name_or_no_position_is_told_by_its_line(cell: str, message: str) -> None:
    with pytest.raises(InputError, match=f"^cell.yaml{message}") as caught:
        read(SIGNALS, BASE + cell)
    assert caught.value.kind is ErrorKind.CELL


def test_an_entry_that_no_target_takes_is_told_with_its_line() -> None:
    (warning,) = read(LINE, f"{CELL}rail_at:\n  p_n1: 0.3\n").warnings
    assert str(warning).startswith(
        f"cell.yaml:{len(CELL.splitlines()) + 2}:1: rail_at in the cell file: no target took"
    )
