"""Spoiled motions, each 1.1 times the smallest offence the judge promises to see: all caught by the right check."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
import spoiled_holds
import spoiled_runs
import spoiled_shapes
import spoiled_stops
import spoiled_turns
from legal_motion import A_IN, A, Case, faster, hold, line_move, nudged, rail_share, rapid_case, stream_case
from legal_motion import judged as verify
from spoil_book import OVER, SPOILED
from spoiled_holds import in_the_joint_move, in_the_wait, on_the_line
from spoiled_stops import short_of

from trajopt_cli.findings import Report
from trajopt_cli.joint_csv import header, read_csv_text
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge import verify as judge

REGISTERED = (spoiled_holds, spoiled_runs, spoiled_shapes, spoiled_stops, spoiled_turns)  # importing them fills SPOILED


@cache
def judged(name: str) -> tuple[Case, Report]:
    """A spoiled motion and what the judge finds in it."""
    case, rows, target = SPOILED[name][0]()
    return case, verify(case.program, case.plant, rows, target=target)


@pytest.mark.parametrize("name", SPOILED)
def test_every_spoiled_motion_is_caught_by_the_right_check(name: str) -> None:
    _, check, subject, line = SPOILED[name]
    _, report = judged(name)
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


# Where the worst of an offence is: in which piece of the motion, and at which share of its time; None: anywhere.
SIZED: dict[str, tuple[int, float] | None] = {
    "rail_sways_in_a_held_wait": (2, 0.5),
    "rail_drifts_in_a_held_wait": (2, 1.0),
    "rail_moves_on_a_held_line": (1, 0.5),
    "rail_moves_in_a_held_joint_move": (4, 0.5),
    "corner_out_of_its_plane": None,
    "arc_bulged": (2, 0.5),
    "arc_whose_orientation_lags": (2, 0.5),
    "backwards_on_the_arc": None,
    "turned_behind_the_zone": None,
    "rail_out_of_proportion_on_an_arc": None,
    "too_fast_axis": None,
    "too_fast_start": None,
    "beyond_the_range": (0, 1.0),
    "beyond_the_range_between_rows": (0, 0.5),
    "tcp_too_fast": None,
    "tcp_accelerates_too_hard": None,
    "faster_than_programmed": None,
    "bowed_line": (1, 0.5),
    "turned_on_the_line": (5, 0.5),
    "backwards_on_the_line": None,
    "only_between_rows": None,
    "too_fast_axis_without_speed_columns": None,
    "tcp_accelerates_too_hard_without_speed_columns": None,
    "tcp_accelerates_too_hard_only_between_rows": None,
    "faster_than_programmed_only_between_rows": None,
    "short_dwell": (2, 0.0),
    "drift_in_a_dwell": (2, 0.5),
    "turning_in_a_dwell": (6, 0.5),
    "flown_by_a_stop": (1, 0.0),
    "not_at_rest_at_the_start": (0, 0.0),
    "not_at_rest_at_the_end": (7, 1.0),
    "wrong_start": (0, 0.0),
    "wrong_rail_at_home": (7, 1.0),
    "programmed_time_not_kept": (0, 1.0),
    "programmed_self_motion_too_short": None,
    "rail_moved_although_fixed": (1, 1.0),
    "arm_moves_with_external_axes": (5, 0.5),
    "axes_move_when_a_condition_wait_ends": None,
    "an_axis_moves_at_a_rapid_stop": (2, 0.0),
    "a_rapid_joint_move_that_bends": (4, 0.5),
    "a_rail_out_of_proportion": (1, 0.5),
    "rows_too_far_apart": None,
}
# These break more than their check where they are smaller, too.
OTHERWISE = {
    "beyond_the_range_between_rows", "not_at_rest_at_the_end", "rail_moved_although_fixed",
    "axes_move_when_a_condition_wait_ends",
}  # fmt: skip


@pytest.mark.parametrize("name", SIZED)
def test_nine_tenths_of_an_offence_are_none(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """And both are told as they are: so much of the limit, there and then."""
    make, check, subject, line = SPOILED[name]
    beyond = judged(name)
    for module in REGISTERED:
        monkeypatch.setattr(module, "OVER", 0.9)
    case, rows, target = make()
    within = case, verify(case.program, case.plant, rows, target=target)
    for over, (case, report) in ((0.9, within), (OVER, beyond)):
        found = [f for f in report.findings if f.check == check and subject in (f.subject, None)]
        found = [f for f in found if line is None or (f.source is not None and f.source.line == line)]
        assert all(f.passed for f in found) == (over < 1), [f.message for f in found]
        assert report.legal == (over < 1) or name in OTHERWISE
        worst = next((f for f in found if not f.passed), max(found, key=lambda f: f.value))
        if worst.limit in SHARES:
            assert worst.value == pytest.approx(over * worst.limit, rel=1e-3)
        place = SIZED[name]
        if place is not None and worst.time is not None:
            when = case.starts[place[0]] + place[1] * case.pieces[place[0]].T
            assert worst.time == pytest.approx(when, abs=1.1e-3)


SHARES = (1e-6, 1e-5, tol.LARGEST_GAP)
"""Limits that are tolerances themselves: values are told as their multiples."""


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
    assert {f.check for f in judged(name)[1].findings if not f.passed} == TWICE.get(name, {SPOILED[name][1]})


def test_every_check_of_a_stream_is_broken_by_one_of_them_or_in_a_file_of_its_own() -> None:
    case = stream_case()
    made = {f.check for f in judge.verify(case.program, case.plant, case.rows()).findings}
    elsewhere = {"printed resolution", "programmed reorientation", "self clearance"}
    assert made - {check for _, check, *_ in SPOILED.values()} == elsewhere


def test_offences_stay_where_they_are() -> None:
    """One wrong stop is one wrong stop: the points after it are found."""
    for name in ("point_missed", "point_skipped", "flown_by_at_speed"):
        failed = [f for f in judged(name)[1].findings if not f.passed and f.check.startswith("stop")]
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
    found = next(f for f in judged(spoiled_one)[1].findings if f.check == name)
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
