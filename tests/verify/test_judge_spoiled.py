"""Spoiled motions, each 1.1 times the smallest offence the judge promises to see: all caught by the right check."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
import pytest
import spoiled_holds
import spoiled_runs
import spoiled_shapes
import spoiled_stops
from legal_motion import (
    A_IN,
    A,
    Case,
    faster,
    hold,
    line_move,
    nudged,
    rail_share,
    rapid_case,
    stream_case,
)
from spoil_book import SPOILED, verify
from spoiled_holds import in_the_joint_move, in_the_wait, on_the_line
from spoiled_stops import short_of

from trajopt_cli.findings import Report
from trajopt_cli.joint_csv import header, read_csv_text
from trajopt_cli.verify import tolerances as tol

REGISTERED = (spoiled_holds, spoiled_runs, spoiled_shapes, spoiled_stops)  # importing them fills SPOILED


def judged(name: str) -> Report:
    case, rows, target = SPOILED[name][0]()
    return verify(case.program, case.plant, rows, target=target)


@pytest.mark.parametrize("name", SPOILED)
def test_every_spoiled_motion_is_caught_by_the_right_check(name: str) -> None:
    _, check, subject, line = SPOILED[name]
    report = judged(name)
    failed = [f for f in report.findings if not f.passed]
    assert not report.legal
    named = [f for f in failed if f.check == check and subject in (f.subject, None)]
    assert named, [(f.check, f.subject, f.message) for f in failed]
    if line is not None:
        assert any(f.source is not None and f.source.line == line for f in named), [f.message for f in failed]
    for f in failed:
        assert "\n" not in f.message
        assert f.unit
        assert f.message


IN_RUNS = [name for name, (make, *_) in SPOILED.items() if make.__module__ == "spoiled_runs"]
# An arc driven the other way round leaves the circle's part and comes back from its far end; a wait that is not
# stopped for is told of the stop and of the wait; far beyond the sphere one is off the way and outside the triangle.
TWICE = {
    "arc_the_wrong_way_round": {"arc position", "arc progress"},
    "wait_at_a_fly_by_not_stopped_for": {"stop rest", "dwell rest"},
    "corner_beyond_its_sphere": {"line position", "corner position"},
}


@pytest.mark.parametrize("name", IN_RUNS)
def test_an_offence_in_a_run_is_told_by_one_check(name: str) -> None:
    assert {f.check for f in judged(name).findings if not f.passed} == TWICE.get(name, {SPOILED[name][1]})


def test_every_check_of_a_stream_is_broken_by_one_of_them_or_in_a_file_of_its_own() -> None:
    case = stream_case()
    made = {f.check for f in verify(case.program, case.plant, case.rows()).findings}
    elsewhere = {"printed resolution", "programmed reorientation", "self clearance"}
    assert made - {check for _, check, *_ in SPOILED.values()} == elsewhere


def test_offences_stay_where_they_are() -> None:
    """One wrong stop is one wrong stop: the points after it are found."""
    for name in ("point_missed", "point_skipped", "flown_by_at_speed"):
        failed = [f for f in judged(name).findings if not f.passed and f.check.startswith("stop")]
        assert len(failed) == 1, [f.message for f in failed]


def test_just_inside_the_tolerance_passes() -> None:
    case = rapid_case()
    case = case.swap(p1=nudged(case.plant, case.pieces[1], [0.6, 0.8, 0, 0, 0, 0], 0.9 * tol.LINE_POSITION))
    assert verify(case.program, case.plant, case.rows()).legal
    case = rapid_case()
    case = case.swap(p4=faster(case.pieces[4], np.sqrt(1 + 0.9 * tol.JOINT)))
    assert verify(case.program, case.plant, case.rows()).legal


def test_the_message_says_place_value_time_and_limit() -> None:
    case = rapid_case()
    case = case.swap(p4=faster(case.pieces[4], 1.05))
    failed = [f.message for f in verify(case.program, case.plant, case.rows()).findings if not f.passed]
    assert len(failed) == 1
    assert re.fullmatch(r"cell\.mod:15:5: rail acceleration 3\.307 m/s2 at t = 1\.\d{3} s, limit 3", failed[0])


@pytest.mark.parametrize(("name", "unit"), [("TCP speed", "m/s"), ("TCP acceleration", "m/s2")])
def test_the_tcp_is_named_once(name: str, unit: str) -> None:
    spoiled_one = next(key for key, (_, check, *_) in SPOILED.items() if check == name)
    found = next(f for f in judged(spoiled_one).findings if f.check == name)
    assert re.fullmatch(rf"cell\.mod:12:5: {name} [\d.]+ {unit} at t = [\d.]+ s, limit [\d.]+", found.message)


def test_tolerances_are_the_promised_ones() -> None:
    assert (tol.JOINT, tol.TCP) == (1e-6, 1e-4)
    assert tol.LINE_POSITION <= 1e-6
    assert max(tol.STOP_POSITION, tol.STOP_ROTATION, tol.LINE_ROTATION, tol.JOINT_TARGET, tol.BACKWARD) <= 1e-6
    assert (tol.DWELL, tol.DURATION) == (1e-9, 1e-6)
    assert max(tol.REST_LINEAR, tol.REST_ANGULAR, tol.REST_JOINT) <= 1e-5


FOREIGN: dict[str, tuple[Callable[[Case], Case], str]] = {
    "bowed by 10 um": (
        lambda c: c.swap(p1=nudged(c.plant, c.pieces[1], [0.6, 0.8, 0, 0, 0, 0], 1e-5)),
        "line position",
    ),
    "turned by 20 urad": (
        lambda c: c.swap(p5=nudged(c.plant, c.pieces[5], [0, 0, 0, 0, 0, 1.0], 2e-5)),
        "line rotation",
    ),
    "accelerates 2 % too hard": (lambda c: c.swap(p4=faster(c.pieces[4], 1.01)), "joint acceleration"),
    "1 % faster than programmed": (
        lambda c: c.swap(p1=line_move(c.plant, A_IN, A, rail_share(0.05, 0.08), 0.505 / 0.08, 60.0)),
        "programmed speed",
    ),
    "waits 20 ms too short": (
        lambda c: c.swap(p2=hold(c.pieces[2].at(np.zeros(1))[0][0], 0.08)),
        "dwell length",
    ),
    "drifts by 10 um": (lambda c: c.swap(p2=nudged(c.plant, c.pieces[2], [0, 1.0, 0, 0, 0, 0], 1e-5)), "dwell drift"),
    "the held rail sways by 10 um in a wait": (lambda _: in_the_wait(1e-5), "way while held"),
    "the held rail sways by 10 um on a line": (lambda _: on_the_line(1e-5), "way while held"),
    "the held rail sways by 1 mm in a joint move": (lambda _: in_the_joint_move(1e-3), "way while held"),
    "turns 0.2 mm before the point": (lambda _: short_of(np.array([0, 0, 2e-4]))[0], "stop reached"),
}


@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("offence", FOREIGN)
def test_a_foreign_file_at_250_hz_and_six_digits_still_shows_coarse_offences(offence: str, speeds: bool) -> None:
    spoil, check = FOREIGN[offence]
    case = spoil(rapid_case())
    rows = case.rows(grid_only=True, step=0.004)
    table = np.hstack([rows.t[:, None], rows.q, *([rows.qd] if speeds else [])])
    lines = [",".join(header(rows.names, speeds)), *(",".join(f"{x:.6f}" for x in row) for row in table)]
    trajectory, resolution = read_csv_text("\n".join(lines), "foreign.csv")
    failed = {f.check for f in verify(case.program, case.plant, trajectory, resolution).findings if not f.passed}
    assert check in failed
