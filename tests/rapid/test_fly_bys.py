"""How far a fly-by point is rounded: position, orientation and external axes, each from its own part of zonedata."""

from __future__ import annotations

import json
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.geometry import pose, rotation_from_wxyz
from trajopt_cli.judge.program_points import points_of
from trajopt_cli.motion import FlyBy, Program, TextFile
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program, try_program
from trajopt_cli.rapid.zones import effective_radii, fly_bys, stopped_fly_bys, ways

TRUTH = json.loads((Path(__file__).parents[1] / "data/truth/irb140_fk.json").read_text(encoding="utf-8"))
NONE = "[9E9,9E9,9E9,9E9,9E9,9E9]"
RAIL = {
    "robot": "irb140_rail",
    "rail": {"eax": "a", "stroke": [-0.2, 2.2]},
    "limits": {"rail": {"velocity": 1.0, "acceleration": 3.0, "source": "a test"}},
    "start": {"joints": "[0, 0, 0, 0, 30, 0] deg", "rail": 0},
}


def kinematics() -> PlantKinematics:
    return PlantKinematics(build_plant(parse_cell(json.dumps(RAIL), "cell.yaml")))


def program(*moves: str) -> Program:
    text = f"MODULE m\nPROC main()\n{''.join(moves)}\nENDPROC\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")])


def line(x: float, y: float, zone: str, turn: float = 0.0, rail: float | None = None) -> str:
    """A line to a tool that points down, turned about its own axis by so many degrees."""
    half = radians(turn) / 2
    eax = NONE if rail is None else f"[{rail},9E9,9E9,9E9,9E9,9E9]"
    return f"MoveL [[{x},{y},500],[0,{np.sin(half):.9f},{np.cos(half):.9f},0],[0,0,0,0],{eax}],v100,{zone},tool0;\n"


def joints(q: list[float], zone: str) -> str:
    return f"MoveAbsJ [{[round(value * 180 / pi, 6) for value in q]},{NONE}],v100,{zone},tool0;\n"


def the_corner(*moves: str) -> FlyBy:
    (found,) = fly_bys(program(*moves), kinematics()).values()
    return FlyBy(*(round(value * 1e3, 4) for value in found))


def corner_of_a_square(zone: str, turn: float = 0.0, rail: float = 0.0, long: float = 400.0) -> FlyBy:
    """90 degrees between a line of 200 mm and one of `long`; the second turns and takes the rail along."""
    return the_corner(line(300, 0, "fine", 0, 0), line(500, 0, zone, 0, 0), line(500, long, "fine", turn, rail))


@pytest.mark.parametrize(
    ("zone", "expected"),
    [
        ("z50", FlyBy(50, 75, 75)),
        ("z80", FlyBy(80, 100, 100)),  # half of 200 mm; written 120
        ("z200", FlyBy(100, 100, 100)),
        ("[FALSE,50,20,30,5,50,5]", FlyBy(50, 50, 50)),  # smaller than the tool's own zone: as large
        ("[FALSE,10,40,60,0,0,0]", FlyBy(10, 40, 60)),
        ("z50\\Z:=90", FlyBy(90, 90, 90)),
    ],
)
def test_each_part_ends_at_the_middle_of_the_way_and_no_earlier_than_the_position(zone: str, expected: FlyBy) -> None:
    assert corner_of_a_square(zone) == expected


def test_the_smaller_share_of_the_turn_counts() -> None:
    # z50 turns over 7.5 deg at most. 45 deg on 400 mm: a sixth of the way is 66.67 mm, less than the 75 mm of path_ori.
    assert corner_of_a_square("z50", turn=45) == FlyBy(50, 66.6667, 75)
    assert corner_of_a_square("z50", turn=30) == FlyBy(50, 75, 75)
    assert corner_of_a_square("z50", turn=90) == FlyBy(50, 50, 75)  # 33.33 mm by its share, never below the radius


def test_a_size_of_zero_says_nothing_about_the_share() -> None:
    assert corner_of_a_square("[FALSE,10,40,60,0,0,0]", turn=90, rail=500) == FlyBy(10, 40, 60)


def test_the_smaller_share_of_the_rail_counts_where_it_moves() -> None:
    # leax of z50 is 75 mm: of 500 mm that is 0.15 of 400 mm.
    assert corner_of_a_square("z50", rail=500) == FlyBy(50, 75, 60)
    assert corner_of_a_square("z50", rail=0) == FlyBy(50, 75, 75)


def test_only_the_axes_the_robot_has_travel() -> None:
    moves = (line(300, 0, "fine", 0, 0), line(500, 0, "z50", 0, 0), line(500, 400, "fine", 0, 500))
    assert fly_bys(program(*moves))[1].external == pytest.approx(0.075)


def test_joint_moves_count_by_their_chord() -> None:
    a, b, c = (case for case in TRUTH["cases"][5:8])
    at = [np.array(case["p"]) for case in (a, b, c)]
    before, after = (float(np.linalg.norm(one - other)) for one, other in zip(at[1:], at, strict=False))
    found = program(*(joints(case["q"], "z200") for case in (a, b, c)))
    assert ways(found, kinematics())[1:] == pytest.approx([before, after], abs=1e-6)
    assert fly_bys(found, kinematics())[1].radius == pytest.approx(min(0.2, before / 2, after / 2), abs=1e-6)
    assert fly_bys(found) == {}
    assert effective_radii(found) == (None, None, 0)


def test_a_line_after_external_axes_alone_begins_where_they_took_the_tool() -> None:
    moves = (
        line(300, 0, "fine", 0, 0),
        "MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[40,9E9,9E9,9E9,9E9,9E9]],vrot10,fine;\n",
        line(440, 0, "z50", 0, 40),
        line(440, 400, "fine", 0, 40),
    )
    (corner,) = fly_bys(program(*moves), kinematics()).values()
    axis = build_plant(parse_cell(json.dumps(RAIL), "cell.yaml")).robot.rail_axes[0]
    way = float(np.linalg.norm(np.array([0.14, 0, 0]) - 0.04 * np.asarray(axis)))
    assert ways(program(*moves), kinematics())[1:3] == [None, pytest.approx(way)]
    assert corner.radius == pytest.approx(min(0.05, way / 2))


def test_passed_and_stopped_points_are_all_fly_bys_there_are() -> None:
    found = program(line(300, 0, "z10"), line(500, 0, "z10"), "WaitTime 1;", line(500, 90, "z10"))
    assert list(fly_bys(found, kinematics())) == [0]
    assert stopped_fly_bys(found, kinematics()) == {1: "a wait follows", 3: "no move follows"}


def test_the_start_is_where_the_cell_file_says() -> None:
    start = kinematics().forward(*kinematics().start)
    truth = pose(rotation_from_wxyz([np.cos(pi / 3), 0, np.sin(pi / 3), 0]), [0.45 + 0.065 * np.cos(pi / 6), 0, 0.6795])
    np.testing.assert_allclose(start, truth, atol=1e-9)
    (first, *_) = ways(program(line(300, 0, "z10")), kinematics())
    assert first == pytest.approx(np.linalg.norm(truth[:3, 3] - [0.3, 0, 0.5]))


# ---------------------------------------------------------------------------------- what the program waits for


@pytest.mark.parametrize(
    "between",
    [
        "Stop;",
        "Break;",
        "StopMove;",
        "WaitRob \\InPos;",
        "WaitSyncTask s, tasks;",
        "WaitSyncTask \\InPos, s, tasks \\TimeOut:=9;",
        "WaitTestAndSet taken;",
        'UIMsgBox "look";',
        "IF UIMessageBox(\\MsgLine1:=text)=1 SetDO do1,1;",
        'n:=UINumEntry(\\Header:="n");',
        "TPReadNum n, text;",
        "SocketConnect sock, text, 80;",
        "SocketReceive sock \\Str:=text;",
        "text:=ReadStr(file);",
        "RMQReadWait msg;",
        "Ask;",
    ],
)
def test_a_fly_by_in_front_of_what_the_program_waits_for_is_a_stop(between: str) -> None:
    data = (
        "VAR string text; VAR num n; VAR socketdev sock; VAR iodev file; VAR rmqmessage msg; VAR syncident s; "
        'PERS tasks tasks{1}:=[["T"]]; PERS bool taken:=FALSE;'
    )
    sub = "PROC Ask()\nFOR i FROM 1 TO 2 DO\nTPReadNum n, text;\nENDFOR\nENDPROC"
    moves = f"{line(300, 0, 'fine')}{line(500, 0, 'z20')}{between}\n{line(500, 300, 'fine')}"
    text = f"MODULE m\n{data}\nPROC main()\n{moves}ENDPROC\n{sub}\nENDMODULE\n"
    found, _ = try_program([TextFile("m.mod", text, "utf-8")])
    assert [*stopped_fly_bys(found)] == [1]
    point = points_of(found, build_plant(parse_cell(json.dumps(RAIL), "cell.yaml")))[2]
    assert (point.index, point.fly_by) == (1, None)  # for the judge as well


@pytest.mark.parametrize(
    "between", ["SocketSend sock \\Str:=text;", "TPWrite text;", "Open text, file;", "WaitTime 0;"]
)
def test_what_only_sends_or_writes_holds_nothing_up(between: str) -> None:
    found = program(line(300, 0, "fine"), line(500, 0, "z20"), between, line(500, 300, "fine"))
    assert not stopped_fly_bys(found)
