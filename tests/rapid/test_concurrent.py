r"""Waits behind moves with \Conc: they run beside the move, and what is longer than it is waited for at its end."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.judge.program_points import points_of
from trajopt_cli.motion import Move, Program, TextFile, Wait
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.rapid.zones import stopped_fly_bys
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind

NONE = "[9E9,9E9,9E9,9E9,9E9,9E9]"
CELL = {
    "robot": "irb140_rail",
    "rail": {"eax": "a", "stroke": [-0.2, 2.2]},
    "limits": {"rail": {"velocity": 1.0, "acceleration": 3.0, "source": "a test"}},
    "start": {"joints": "[0, 0, 0, 0, 30, 0] deg", "rail": 0},
}
PLANT = build_plant(parse_cell(json.dumps(CELL), "cell.yaml"))


def program(body: str, **scenario: object) -> Program:
    text = f"MODULE m\nVAR num n;\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], Scenario(**scenario), kinematics=PlantKinematics(PLANT))


def line(x: float, zone: str, conc: str = "", speed: str = "v100", kind: str = "MoveL", eax: str = NONE) -> str:
    return f"{kind} {conc}[[{x},0,500],[0,0,1,0],[0,0,0,0],{eax}],{speed},{zone},tool0;\n"


def times(found: Program) -> list[tuple[float, float | None, bool]]:
    """Of each wait what is left behind its move, what it was, and whether it makes a stop."""
    return [(round(m.duration, 9), m.beside, m.stops) for m in found.motions if isinstance(m, Wait)]


def lasting(found: Program) -> list[float]:
    return [move.beside for move in found.motions if isinstance(move, Move)]


@pytest.mark.parametrize("conc", ["\\Conc,", "\\conc ,"])
def test_a_wait_beside_a_move_that_lasts_longer_costs_nothing(conc: str) -> None:
    """200 mm at 100 mm/s, the last 50 in the zone: the wait may take 1.5 s."""
    found = program(line(300, "fine") + line(500, "z50", conc) + "WaitTime 1;\nWaitTime 0.5;\n" + line(300, "fine"))
    assert times(found) == [(0, 1, False), (0, 0.5, False)]
    assert lasting(found) == [0, 0, 0]
    assert not stopped_fly_bys(found)
    assert points_of(found, PLANT)[2].fly_by is not None
    assert points_of(found, PLANT)[2].beside == 1.5


@pytest.mark.parametrize("zone", ["z50", "fine"])
def test_of_a_longer_one_the_rest_is_waited_for_at_the_point(zone: str) -> None:
    found = program(line(300, "fine") + line(500, zone, "\\Conc,") + "WaitTime 1.6;\n" + line(300, "fine"))
    assert times(found) == [(0, 1.6, zone == "z50")]
    assert lasting(found) == [0, 1.6, 0]  # of the 2 s that it needs, and whatever else it takes
    assert [*stopped_fly_bys(found)] == [1] * (zone == "z50")
    assert points_of(found, PLANT)[2].fly_by is None


def turned(angle: float, zone: str, conc: str = "", speed: str = "[100,20,500,500]") -> str:
    return f"MoveL {conc}RelTool([[500,0,500],[0,0,1,0],[0,0,0,0],{NONE}],0,0,0\\Rz:={angle}),{speed},{zone},tool0;\n"


@pytest.mark.parametrize("speed", ["[100,20,500,500]", "v100\\T:=1.5"])
@pytest.mark.parametrize("wait", [1.12, 1.13, 1.6])
def test_beside_a_turn_in_place_the_zone_is_an_angle(speed: str, wait: float) -> None:
    """30 deg at 20 deg/s, the last 7.5 in the zone: the wait may take 1.125 s. Behind that corner 22.5 deg count."""
    first = line(500, "fine") + turned(30, "z50", "\\Conc,", speed) + f"WaitTime {wait};\n"
    found = program(first + turned(60, "fine"))
    passed = wait <= 1.125
    assert [*stopped_fly_bys(found, PlantKinematics(PLANT))] == [1] * (not passed)
    assert (points_of(found, PLANT)[2].fly_by is not None) == passed
    assert lasting(found)[1] == (0 if passed or "T" in speed else wait)
    behind = program(line(500, "fine") + turned(30, "z50") + turned(60, "fine", "\\Conc,") + "WaitTime 1.2;\n")
    assert times(behind) == [(pytest.approx(0.075, abs=1e-6), 1.2, True)]
    apart = program(line(500, "fine") + turned(30, "z50") + line(600, "fine", "\\Conc,") + "WaitTime 1.5;\n")
    assert (times(apart), lasting(apart)) == ([(0, 1.5, False)], [0, 0, 1.5])  # from a stop


def test_behind_a_corner_only_the_way_between_the_zones_counts() -> None:
    """200 - 20 = 180 mm to the point, 1.8 s at 100 mm/s; 130 mm to its zone."""
    start = line(300, "fine") + line(400, "z20")
    short = program(start + line(600, "z50", "\\Conc,") + "WaitTime 1.3;\n" + line(300, "fine"))
    assert times(short) == [(0, 1.3, False)]
    assert not short.warnings
    long = program(start + line(600, "z50", "\\Conc,") + "WaitTime 2;\nWaitTime 0.5;\n" + line(300, "fine"))
    assert times(long) == [(0.2, 2, True), (0.5, 0.5, True)]
    assert lasting(long) == [0, 0, 0, 0]
    assert [(one.kind, one.place and one.place[1]) for one in long.warnings] == [(WarningKind.ASSUMED, 6)]


def test_a_programmed_time_is_the_time_of_the_move() -> None:
    found = program(
        line(300, "fine") + line(500, "fine", "\\Conc,", "v100\\T:=2") + "WaitTime 2.5;\n" + line(300, "fine")
    )
    assert times(found) == [(0.5, 2.5, True)]
    assert lasting(found) == [0, 0, 0]


def test_what_moves_nothing_takes_no_time_from_a_wait() -> None:
    pause = "WaitTime 0.5;\n"
    assert times(program(line(500, "fine") + line(500, "fine", "\\Conc,") + pause)) == [(0.5, 0.5, True)]
    for rail, left in ((0, 0.5), (300, 0.0)):
        ext = f"MoveExtJ \\Conc,[[0,0,0,0,30,0],[{rail},9E9,9E9,9E9,9E9,9E9]],v1000,fine;\n"
        found = program(ext + pause + line(500, "fine"))
        assert times(found) == [(left, 0.5, left > 0)]
        assert lasting(found)[0] == 0.5 - left


@pytest.mark.parametrize("what", ["WaitRob \\InPos;", "WaitTime \\InPos, 0;", "Stop;", "StopMove;"])
def test_what_stops_the_robot_ends_what_runs_beside(what: str) -> None:
    found = program(line(300, "fine") + line(500, "z50", "\\Conc,") + what + "\nWaitTime 1;\n" + line(300, "fine"))
    assert [(wait.duration, wait.beside, wait.stops) for wait in found.motions if isinstance(wait, Wait)] == [
        (0, None, True),
        (1, None, True),
    ]


def test_waits_for_signals_and_operators_run_beside_too_with_their_least_time() -> None:
    moves = line(300, "fine"), line(500, "z50", "\\Conc,", kind="MoveJ"), line(300, "fine")
    found = program(
        f'{moves[0]}{moves[1]}WaitDI di1,1;\nTPReadNum n,"?";\n{moves[2]}', waits={"di1": 1.0}, answers={"n": 1}
    )
    assert times(found) == [(0, 1, False), (0, 0, False)]
    free = program(f"{moves[0]}{moves[1]}WaitDI di1,1;\n{moves[2]}", waits={"di1": 1.0}, free_speed=True)
    assert times(free) == [(0, 1, True)]  # a joint move may then be as fast as its axes
    assert lasting(free) == [0, 1, 0]


def test_a_move_without_it_has_no_wait_beside_it_nor_has_one_that_may_be_left_out() -> None:
    plain = program(line(300, "fine", "\\Conc,") + line(500, "z50") + "WaitTime 1;\n" + line(300, "fine"))
    assert times(plain) == [(1, None, True)]
    marked = line(500, "z50", "\\Conc,").replace(";", "; ! trajopt: optional")
    assert times(program(line(300, "fine") + marked + "WaitTime 1;\n" + line(300, "fine"))) == [(1, None, True)]


def test_at_most_five_in_succession() -> None:
    moves = [line(300 + 20 * i, "fine", "\\Conc,") for i in range(6)]
    assert len(program("".join(moves[:5])).motions) == 5
    assert len(program("".join([*moves[:5], line(300, "fine"), *moves[:5]])).motions) == 11
    with pytest.raises(InputError) as caught:
        program("".join(moves))
    assert (caught.value.file, caught.value.line) == ("m.mod", 9)
    handled = "".join(moves) + "ERROR\nIF ERRNO=ERR_CONC_MAX TRYNEXT;"
    assert len(program(handled).motions) == 5


def test_none_between_store_path_and_resto_path() -> None:
    conc = line(300, "fine", "\\Conc,")
    assert len(program(f"StorePath;\n{line(300, 'fine')}RestoPath;\n{conc}").motions) == 3
    with pytest.raises(InputError) as caught:
        program(f"StorePath;\n{conc}RestoPath;")
    assert (caught.value.file, caught.value.line) == ("m.mod", 5)


def test_reading_again_with_shorter_waits_gives_the_same_motions() -> None:
    """What is left of a wait is no part of the text: the same text always comes to the same."""
    body = line(300, "fine") + line(500, "z50", "\\Conc,") + "WaitTime 3;\n" + line(300, "fine")
    one, other = program(body), program(body)
    assert times(one) == times(other)
    wait = next(m for m in one.motions if isinstance(m, Wait))
    assert wait.programmed == replace(wait, duration=1.0).programmed == 3
