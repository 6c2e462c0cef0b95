"""Where a plan lacks programmed speed, held against closed forms: the rail alone carries the tool along a line."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.motion import Program, SignalEvent, TextFile
from trajopt_cli.problem.constant_speed import DIP, Stretch, Why, constant_speed, stretch_record
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Settling
from trajopt_cli.trajectory import Trajectory

A = 3.0  # m/s2 of the rail
CELL = {
    "robot": "irb140_rail",
    "rail": {"eax": "a", "stroke": [-0.2, 2.2]},
    "limits": {"rail": {"velocity": 1.5, "acceleration": A, "source": "a test"}},
    "start": {"joints": "[0, 0, 0, 0, 30, 0] deg", "rail": 0},
    "constant_speed": ["bead"],
}
PLANT = build_plant(parse_cell(json.dumps(CELL), "cell.yaml"))
K = 1 - DIP
Phase = tuple[float, float]  # acceleration [m/s2], how long [s]


def program(*motions: str, rest: str = "", settle: float = 0.0) -> Program:
    """A bead of these motions, which begins in line 3."""
    text = f"MODULE m\nPROC bead()\n{chr(10).join(motions)}\nENDPROC\nPROC main()\nbead;\n{rest}\nENDPROC\nENDMODULE\n"
    scenario = replace(parse_cell(json.dumps(CELL), "cell.yaml").scenario, settle=Settling(settle))
    return run_program([TextFile("m.mod", text, "utf-8")], scenario)


def line(speed: str, zone: str, x: float = 0.0) -> str:
    return f"MoveL [[{x},0,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],{speed},{zone},tool0;"


def stretches(given: Program, *phases: Sequence[Phase]) -> tuple[Stretch, ...]:
    """Of a plan whose motions have these phases of the rail; the arm keeps its joints."""
    t, s, v = [0.0], [0.0], [0.0]
    planned = []
    courses = iter(phases)
    for index, motion in enumerate(given.motions):  # a plan has them all
        t_0 = t[-1]
        for a, duration in () if isinstance(motion, SignalEvent) else next(courses):
            t.append(t[-1] + duration)
            s.append(s[-1] + v[-1] * duration + a * duration**2 / 2)
            v.append(v[-1] + a * duration)
        planned.append(PlannedMotion(index, motion.source, t_0, t[-1], PLANT.start, PLANT.start, ""))
    q = np.tile(PLANT.start, (len(t), 1))
    q[:, 0] = s
    qd = np.zeros_like(q)
    qd[:, 0] = v
    rows = Trajectory(PLANT.limits.names, np.array(t), q, qd)
    return constant_speed(given, Plan(Target.STREAM, rows, tuple(planned), None, ""), PLANT)


def only(found: tuple[Stretch, ...]) -> Stretch:
    (one,) = found
    return one


def test_run_up_and_run_down_of_a_line_from_stop_to_stop() -> None:
    v, a = 1.0, A  # 0.1667 m and 0.3333 s to full speed
    one = only(stretches(program(line("v1000", "fine")), [(a, v / a), (0, 0.5), (-a, v / a)]))
    assert (one.start, one.duration, one.length) == pytest.approx((0, 2 * v / a + 0.5, v**2 / a + 0.5), abs=1e-6)
    up, down = one.dips
    for dip in (up, down):
        assert dip.duration == pytest.approx(K * v / a, abs=1e-6)
        assert dip.length == pytest.approx((K * v) ** 2 / (2 * a), abs=1e-6)
        assert (dip.lowest, dip.depth, dip.programmed) == (0, 1, v)
        assert (dip.limit, dip.used) == ("rail acceleration", pytest.approx(1))
    assert (up.why, up.along, up.start) == (Why.RUN_UP, 0, pytest.approx(0, abs=1e-8))
    assert (down.why, down.along) == (Why.RUN_DOWN, pytest.approx(one.length, abs=1e-6))
    assert up.cause == "run-up from rest, limited by rail acceleration"


def test_a_line_too_short_for_its_speed() -> None:
    v = 0.6
    (dip,) = only(stretches(program(line("v1000", "fine")), [(A, v / A), (-A, v / A)])).dips
    assert dip.why is Why.SHORT
    assert (dip.highest, dip.duration, dip.length) == pytest.approx((v, 2 * v / A, v**2 / A), abs=2e-3)
    assert dip.length == pytest.approx(v**2 / A, abs=1e-6)


def test_what_keeps_its_speed_within_a_percent_has_no_dip() -> None:
    wave = [(-0.5, 0.019), (0.5, 0.019)]  # 0.0095 m/s, a little less than 1 %
    before = line("v1000", "z10", -500)
    text = program(line("v1000", "z10"), rest=before).motions
    assert [motion.constant_speed for motion in text] == [True, False]  # type: ignore[union-attr]
    one = only(stretches(program(line("v1000", "fine")), [(A, 1 / A), *wave, (-A, 1 / A)]))
    assert [dip.why for dip in one.dips] == [Why.RUN_UP, Why.RUN_DOWN]
    deeper = [(-0.5, 0.021), (0.5, 0.021)]
    one = only(stretches(program(line("v1000", "fine")), [(A, 1 / A), (0, 0.1), *deeper, (0, 0.1), (-A, 1 / A)]))
    assert [dip.why for dip in one.dips] == [Why.RUN_UP, Why.LIMIT, Why.RUN_DOWN]


def test_a_dip_on_the_way_has_place_depth_and_the_nearest_limit() -> None:
    v, low, a = 1.0, 0.6, 1.5
    dent = [(-a, (v - low) / a), (a, (v - low) / a)]
    one = only(stretches(program(line("v1000", "fine")), [(A, v / A), (0, 0.2), *dent, (0, 0.2), (-A, v / A)]))
    dip = one.dips[1]
    assert (dip.index, dip.source.line, dip.why) == (0, 3, Why.LIMIT)
    down = (v + low) / 2 * (v - low) / a
    assert dip.along == pytest.approx(v**2 / (2 * A) + 0.2 + down, abs=1e-3)
    assert dip.lowest == pytest.approx(low, abs=2e-3)
    assert dip.duration == pytest.approx(2 * (K * v - low) / a, abs=1e-6)
    assert dip.length == pytest.approx((K**2 - low**2) / a, abs=1e-6)
    assert (dip.limit, dip.used) == ("rail speed", pytest.approx(K / 1.5, abs=2e-3))
    assert dip.cause == "the nearest limit is rail speed, used to 66 %"


def test_a_stop_between_two_lines_is_one_dip_with_its_zone() -> None:
    ramp = [(A, 1 / A), (0, 0.1), (-A, 1 / A)]
    for zone, expected in (
        ("fine", "stop programmed there (fine)"),
        ("z10\\Inpos:=inpos20", "stop programmed there (inpos20)"),
        ("z10\\Z:=0", "z10 driven as a stop: its zone is 0 mm"),
        ("z10", "z10 driven as a stop"),
    ):
        one = only(stretches(program(line("v1000", zone), line("v1000", "fine", 500)), ramp, ramp))
        stop = one.dips[1]
        assert [dip.why for dip in one.dips] == [Why.RUN_UP, Why.STOP, Why.RUN_DOWN]
        assert (stop.index, stop.lowest, stop.duration) == (0, 0, pytest.approx(2 * K / A, abs=1e-6))
        assert stop.detail == expected


def test_a_corner_is_named_by_its_point() -> None:
    slow = [(A, 1 / A), (0, 0.2), (-A, 0.1)]
    one = only(stretches(program(line("v1000", "z50"), line("v1000", "fine", 500)), slow, [(A, 0.1), (-A, 1 / A)]))
    corner = one.dips[1]
    assert (corner.why, corner.lowest) == (Why.CORNER, pytest.approx(0.7, abs=1e-6))
    assert corner.cause == "corner z50 (line 3), limited by rail acceleration"


def test_a_slower_line_behind_is_a_change_of_speed() -> None:
    v, w = 1.0, 0.1
    first, second = [(A, v / A), (0, 0.2), (-A, (v - w) / A)], [(0, 0.3), (-A, w / A)]
    one = only(stretches(program(line("v1000", "z10"), line("v100", "fine", 500)), first, second))
    change = one.dips[1]
    assert (change.index, change.duration) == (0, pytest.approx((K * v - w) / A, abs=1e-6))
    # A corner says more than a change of speed; a point that is no corner is nothing but the change.
    assert change.why is Why.CORNER
    one = only(stretches(program(line("v1000", "fine"), line("v100", "fine", 500)), first, second))
    assert one.dips[1].detail == "the programmed speed changes from 1000 to 100 mm/s"


def test_several_stops_in_one_dip() -> None:
    short = [(A, 0.1), (-A, 0.1)]
    points = [line("v1000", "fine", x) for x in (0, 30, 60)]
    (dip,) = only(stretches(program(*points), short, short, short)).dips
    assert (dip.why, dip.detail) == (Why.STOP, "stop programmed there (fine) and 1 more")


def test_a_wait_or_another_move_ends_a_stretch_and_a_signal_does_not() -> None:
    ramp = [(A, 1 / A), (-A, 1 / A)]
    bead = program(line("v1000", "fine"), "WaitTime 0.5;", line("v1000", "fine", 500))
    assert [one.first for one in stretches(bead, ramp, [(0, 0.5)], ramp)] == [0, 2]
    bead = program(line("v1000", "fine"), "Set do1;", line("v1000", "fine", 500), rest=line("v1000", "fine", 900))
    assert [(one.first, one.last) for one in stretches(bead, ramp, ramp, ramp)] == [(0, 2)]
    bead = program(line("v1000", "fine"), "Set do1;", line("v1000", "fine", 500), settle=0.25)
    found = only(stretches(bead, ramp, [(0, 0.25)], ramp))
    (stop,) = [dip for dip in found.dips if dip.why is Why.STOP]
    assert (found.first, found.last) == (0, 3)
    assert stop.duration > 0.25  # as long as the tool stands there
    bead = program(line("v1000", "fine"), line("v1000", "fine"), line("v1000", "fine", 500))
    assert [(one.first, one.last) for one in stretches(bead, ramp, [], ramp)] == [(0, 2)]


def test_a_programmed_time_asks_for_its_mean_speed() -> None:
    ramp = [(A, 0.5 / A), (0, 1 - 1 / A), (-A, 0.5 / A)]
    one = only(stretches(program(line("v1000\\T:=1", "fine")), ramp))
    assert [dip.programmed for dip in one.dips] == pytest.approx([one.length] * 2)


def test_the_record_is_plain() -> None:
    given = program(line("v1000", "fine"))
    record = stretch_record(given, only(stretches(given, [(A, 0.5 / A), (-A, 0.5 / A)])))
    assert json.loads(json.dumps(record)) == record
    assert (record["from"], record["dips"][0]["why"]) == ("m.mod:3:1", "short")


def test_what_the_program_makes_of_the_limits_counts() -> None:
    v, a = 1.0, 1.5
    ramps = [(a, v / a), (0, 0.5), (-a, v / a)]
    for before, limit in (("AccSet 50,100;", "rail acceleration"), ("WorldAccLim\\On:=1.5;", "TCP acceleration")):
        one = only(stretches(program(before, line("v1000", "fine")), ramps))
        assert {(dip.limit, round(dip.used, 6)) for dip in one.dips} == {(limit, 1)}
    one = only(stretches(program(line("[1000,500,5000,1000]", "fine")), ramps))
    assert {(dip.limit, round(dip.used, 2)) for dip in one.dips} == {("rail speed", 0.66)}
    one = only(stretches(program(line("[1000,500,660,1000]", "fine")), ramps))
    assert {(dip.limit, round(dip.used, 2)) for dip in one.dips} == {("rail speed", 1.5)}
