"""What the program allows and the judge must not punish, or not forgive."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from legal_motion import (
    A_IN,
    HELD_RAILS,
    HOME,
    V2500,
    A,
    B,
    Case,
    Piece,
    arm_at,
    bench_case,
    eax,
    held_case,
    hold,
    home,
    joint_move,
    line_move,
    move_ext,
    move_j,
    move_l,
    plant_with_rail,
    program,
    rail_share,
    rapid_case,
    ride,
    rows_of,
    wait,
)
from legal_motion import judged as verify
from scipy.interpolate import CubicHermiteSpline
from spoil_book import OVER, limited
from spoiled_holds import in_the_wait, rail_rides_through_a_held_wait
from tcp_motion import inverse_velocity

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.judge import waypoint_matching
from trajopt_cli.judge.joints import check_joints
from trajopt_cli.judge.program_points import ProgramPoint
from trajopt_cli.judge.samples import BLOCK, Boxes, judged_rows
from trajopt_cli.judge.tolerances import DURATION, HELD
from trajopt_cli.judge.waypoint_matching import Closeness, Event, events_of
from trajopt_cli.motion import FlyBy, Hold, Motion
from trajopt_cli.problem.plan import Target
from trajopt_cli.trajectory import Trajectory


def test_nan_and_reversed_time_are_malformed_files() -> None:
    case = rapid_case()
    text = write_csv_text(case.rows(step=1e-3))
    lines = text.split("\n")
    fields = lines[300].split(",")
    lines[300] = ",".join([*fields[:3], "nan", *fields[4:]])
    with pytest.raises(InputError, match=r"^joints.csv:301:\d+: 'nan' is not a finite number$"):
        read_csv_text("\n".join(lines), "joints.csv")
    lines = text.split("\n")
    lines[301], lines[300] = lines[300], lines[301]
    with pytest.raises(InputError, match=r"^joints.csv:302:1: time 0.29\d* s follows 0.29\d* s; times must increase$"):
        read_csv_text("\n".join(lines), "joints.csv")


def test_a_programmed_time_replaces_the_programmed_speed() -> None:
    slow = replace(V2500, name="v100", v_tcp=0.1)
    case = rapid_case()
    motions = list(case.program.motions)
    motions[1] = move_l(12, "p_a", A, 0.08, speed=slow, duration=case.pieces[1].T)
    assert verify(program(*motions), case.plant, case.rows()).legal


@pytest.mark.parametrize("stays", [0, 1, 2])
def test_a_programmed_time_may_end_in_a_rest_that_later_moves_share(stays: int) -> None:
    """A line that comes to rest before its time is over: lines of no length behind its wait take nothing of that."""
    case, rest = rapid_case(), 0.02
    q = case.pieces[2].at(np.zeros(1))[0][0]
    case = case.swap(p2=hold(q, 0.1 + rest))

    def programmed(T: float) -> list[str]:
        motions = list(case.program.motions)
        motions[1] = move_l(12, "p_a", A, 0.08, duration=T)
        motions[3:3] = [move_l(19 + k, "p_a", A, 0.08) for k in range(stays)]
        return [f.check for f in verify(program(*motions), case.plant, rows).findings if not f.passed]

    T, rows = case.pieces[1].T, case.rows()
    assert programmed(T) == programmed(T + rest / 2) == programmed(T + rest) == []
    assert programmed(T + rest + OVER * DURATION) == programmed(T - OVER * DURATION) == ["duration"]


@pytest.mark.parametrize("target", [None, Target.RAPID])
def test_a_slow_end_is_within_tolerance_of_a_stop_before_its_time_is_over(target: Target | None) -> None:
    """80 mm in 20 s: the last 1e-5 m/s take 8 ms. Joint moves to the same pose behind it take nothing of that; one
    with a time of its own takes that, and nothing counts for both."""
    case, T = rapid_case(), 20.0
    law = (T, lambda t: (np.sin(np.pi * t / T / 2) ** 2, np.pi / T / 2 * np.sin(np.pi * t / T)), ())
    slow = line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), 0, 0, profile=law)
    q = slow.at(np.array([T]))[0][0]

    def failed(least: float, again: float | None, rest: float) -> list[str]:
        motions = list(case.program.motions)
        motions[1] = move_l(12, "p_a", A, 0.08, duration=least)
        motions[2:3] = [move_j(19, "p_a", A), replace(move_j(20, "p_a", A), duration=again), wait(21, 0.1)]
        rows = case.swap(p1=slow, p2=hold(q, rest)).rows(step=8e-3)
        report = verify(program(*motions), case.plant, rows, target=target)
        return [f"{f.check} {f.source[1]}" for f in report.findings if not f.passed]

    assert failed(T, None, 0.1) == failed(T, 0.2, 0.3) == []
    assert failed(T + 0.02, None, 0.1) == failed(T - 0.05, None, 0.1) == ["duration 12"]
    assert "dwell length 21" in failed(T, 0.2, 0.25)


def test_two_joint_moves_to_one_pose_share_a_rest() -> None:
    case = rapid_case()
    motions = list(case.program.motions)
    motions = [*motions[:3], move_j(19, "p_a_again", A), wait(20, 0.05), *motions[3:]]
    assert [f.message for f in verify(program(*motions), case.plant, case.rows()).findings if not f.passed] == [
        "cell.mod:20:5: TCP dwell length 0 s at t = 0.734 s, at least 0.05 at MoveJ p_a_again"
    ]
    q = case.pieces[2].at(np.zeros(1))[0][0]
    for target in (None, Target.RAPID):
        assert verify(program(*motions), case.plant, case.swap(p2=hold(q, 0.15)).rows(), target=target).legal


@pytest.mark.parametrize("fixed", [False, True])
@pytest.mark.parametrize("kind", ["joints", "poses"])
def test_a_rail_that_goes_there_and_back_under_one_posture(kind: str, fixed: bool) -> None:
    """The pose, or the arm's joints, are the same at every stop: the rail tells which it is. One that is left out is
    missing at its own line."""
    plant, places = plant_with_rail(rail_fixed=fixed), (0.3, 0.0, 0.3, 0.3, 0.1, 0.0)
    rails = [0.0, *places]
    if kind == "joints":
        motions = [replace(home(11 + k, d), target=f"j_{k}") for k, d in enumerate(places)]
        q = [np.r_[d, HOME] for d in rails]
    else:
        motions = [move_j(11 + k, f"p_{k}", A, d) for k, d in enumerate(places)]
        q = [plant.start, *(arm_at(plant, A[None], np.array([d]))[0] for d in places)]
    moves = [joint_move(plant, a, b) for a, b in pairwise(q) if a[0] != b[0] or a is plant.start]
    case = Case(plant, program(*motions[:3], wait(29, 0.2), *motions[3:]), (*moves[:3], hold(q[3], 0.2), *moves[3:]))
    for target in (None, Target.RAPID):
        report = verify(case.program, plant, case.rows(), target=target)
        assert report.legal, [f.message for f in report.findings if not f.passed]
    if kind == "joints" or fixed:
        short = Case(plant, case.program, (moves[0], hold(q[1], 0.2), *moves[3:]))
        missed = [f for f in verify(case.program, plant, short.rows()).findings if not f.passed]
        missed = [f for f in missed if f.check in ("stop reached", "rail target")]
        assert [(f.source.line, f.subject, f.unit) for f in missed if f.source] == [(12, "rail", "m")]
        assert missed[0].value == pytest.approx(0.3)


def test_rows_beside_a_stop_show_neither_a_held_rail_moving_nor_axes_that_do_not_rest() -> None:
    """No row stands at the stops. The rail brakes to the first and leaves from the second; between them its unit is not
    active. The row nearest to a stop in place may be the farther one in time."""
    plant, away = plant_with_rail(), np.r_[0.3, np.zeros(6)]
    q = [plant.start, plant.start + away, plant.start + away + 0.3 * np.eye(7)[4], plant.start]
    moves = [joint_move(plant, a, b) for a, b in pairwise(q)]
    X = plant.robot.forward(np.array(q))
    held = replace(move_j(13, "p_b", X[2], 0.3), hold=Hold.UNIT)
    asked = program(move_j(11, "p_a", X[1], 0.3), wait(12, 0.0, "di1 = 1"), held, wait(14, 0.0, "di1 = 0"), home(15))
    for step in np.linspace(1e-3, 4e-3, 16):
        report = verify(asked, plant, rows_of(plant, moves, step, grid_only=True))
        assert report.legal, [f.message for f in report.findings if not f.passed]


def test_a_line_that_takes_no_time_asks_nothing_of_a_rail_that_runs_through() -> None:
    """The tool stops for a moment, the rail runs on at 0.3 m/s, and a line to the same pose allows it 0.1 m/s."""
    plant, none = plant_with_rail(), np.zeros(7)
    q_1, q_2 = (arm_at(plant, X[None], np.array([d]))[0] for X, d in ((A, 0.2), (B, 0.4)))
    v = inverse_velocity(plant.robot, q_1[None], np.zeros((1, 6)), np.array([0.3]))[0]
    line = move_l(12, "p", A, speed=replace(V2500, v_leax=0.1))
    asked = program(move_j(11, "p", A), line, move_j(13, "p_b", B))

    def brakes(q_0: Array, v_0: Array, q_1: Array, v_1: Array, T: float) -> Piece:
        way = CubicHermiteSpline([0.0, T], [q_0, q_1], [v_0, v_1])
        return Piece(T, lambda t: (way(t), way(t, 1)))

    pieces = (brakes(plant.start, none, q_1, v, 1.0), brakes(q_1, v, q_2, none, 1.5))
    for step, bare in ((1e-3, False), (4e-3, False), (3e-3, True)):
        report = verify(asked, plant, rows_of(plant, pieces, step, grid_only=bare))
        assert report.legal, [f.message for f in report.findings if not f.passed]


@pytest.mark.parametrize("places", [(0.0, 0.3, 0.0), (0.05, 0.3, 0.3, 0.05, 0.05, 0.2)])
@pytest.mark.parametrize("fixed", [False, True])
def test_lines_and_joint_moves_of_the_rail_take_turns_at_one_pose(places: tuple[float, ...], fixed: bool) -> None:
    """A line of the rail alone keeps the tool where it is, and it is one rest with the stop before it; a joint move of
    the rail alone takes the tool away and back. Wherever a plan has the rail, each stop is its own."""
    plant, first = plant_with_rail(rail_fixed=fixed), 0.1
    q = {d: arm_at(plant, A[None], np.array([d]))[0] for d in (first, *places)}
    motions: list[Motion] = [move_j(11, "p_0", A, first)]
    pieces = [joint_move(plant, plant.start, q[first])]
    for k, (a, b) in enumerate(pairwise((first, *places))):
        line = k % 2 == 0
        motions.append((move_l if line else move_j)(12 + k, f"p_{k}", A, b, V2500))
        pieces += [] if a == b else [ride(plant, A, a, b, 1.0) if line else joint_move(plant, q[a], q[b])]
    meant = Case(plant, program(*motions), tuple(pieces))
    programs = [meant.program] + ([] if fixed else [program(*(replace(m, extax=eax(0.1)) for m in motions))])
    for asked in programs:
        for target in (None, Target.RAPID):
            report = verify(asked, plant, meant.rows(), target=target)
            assert report.legal, [f.message for f in report.findings if not f.passed]


@pytest.mark.parametrize("bare", [False, True])
def test_an_open_rail_that_moves_alone_behind_a_posture(bare: bool) -> None:
    """The arm keeps the posture of a MoveAbsJ with 9E9 all through the moves of the rail behind it: it is reached in
    the first rest."""
    plant, rails = plant_with_rail(), (0.0, 0.4, 0.0, 0.2)
    asked = program(home(11, None), wait(12, 0.5), *(move_ext(13 + k, d) for k, d in enumerate(rails[1:])))
    moves = [joint_move(plant, np.r_[a, HOME], np.r_[b, HOME]) for a, b in pairwise(rails)]
    rows = rows_of(plant, (hold(plant.start, 0.5), *moves), grid_only=bare)
    for target in (None,) if bare else (None, Target.RAPID):
        report = verify(asked, plant, rows, target=target)
        assert report.legal, [f.message for f in report.findings if not f.passed]


def test_a_line_at_its_joint_limit_is_not_blamed_for_the_hermite() -> None:
    """With the limit at the line's true greatest joint acceleration, the Hermite alone would be above it by 2e-6."""
    case = rapid_case()
    T, j = 0.3, 5
    profile = (T, lambda t: (np.sin(np.pi * t / T / 2) ** 2, np.pi / T / 2 * np.sin(np.pi * t / T)), ())
    at = line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), 0, 0, profile=profile).at
    t = np.arange(301) * 1e-3
    rows = Trajectory(case.plant.limits.names, t, *at(t))
    middle, step = np.clip(np.linspace(0, T, 3001), 1e-5, T - 1e-5), 1e-5
    true = np.abs(at(middle + step)[1] - at(middle - step)[1])[:, j].max() / (2 * step)
    seen = replace(judged_rows(case.plant, rows, None), marked=True)
    plain = np.abs(np.diff(rows.qd[:, j]) / 1e-3) + np.abs(6 * seen.mismatch[0][:, j] / 1e-3)
    assert plain.max() > true * (1 + 2e-6)
    plant = limited(case.plant, acceleration={j: float(true)})
    found = check_joints(replace(seen, plant=plant), lambda _: None)
    assert [f.message for f in found if f.subject == "joint_5" and not f.passed] == []
    plant = limited(case.plant, acceleration={j: float(true) / (1 + OVER * 1e-4)})
    found = check_joints(replace(seen, plant=plant), lambda _: None)
    assert "joint acceleration" in [f.check for f in found if f.subject == "joint_5" and not f.passed]


def test_dropped_motions() -> None:
    """Leaving out p_b_in: legal only where the user marked it, known or unknown to the judge."""
    plant = plant_with_rail()
    q_b = arm_at(plant, B[None], np.array([0.25]))[0]
    pieces = (joint_move(plant, plant.start, q_b), joint_move(plant, q_b, plant.start))

    def case(optional: bool) -> Case:
        motions = (move_j(11, "p_a_in", A_IN, optional=optional), move_j(12, "p_b", B), home(13))
        return Case(plant, program(*motions), pieces)

    free, bound = case(True), case(False)
    rows = free.rows()
    assert verify(free.program, plant, rows).legal
    assert verify(free.program, plant, rows, dropped={0}).legal
    failed = [f for f in verify(bound.program, plant, rows).findings if not f.passed]
    assert [f.check for f in failed] == ["stop reached"]
    failed = [f for f in verify(bound.program, plant, rows, dropped={0}).findings if not f.passed]
    assert [(f.check, f.subject) for f in failed] == [("dropped motion", "MoveJ p_a_in")]
    by_name = replace(plant, droppable=frozenset({"p_a_in"}))
    assert verify(bound.program, by_name, rows, dropped={0}).legal


def test_free_speed_lifts_the_programmed_speed_of_joint_moves_only() -> None:
    slow = replace(V2500, name="v100", v_tcp=0.1)
    case = rapid_case()
    motions = list(case.program.motions)
    motions[0], motions[1] = move_j(11, "p_a_in", A_IN, speed=slow), move_l(12, "p_a", A, speed=slow)
    free = replace(case.plant, free_speed=True)
    new = program(*motions)
    failed = {f.source.line for f in verify(new, case.plant, case.rows()).findings if not f.passed and f.source}
    assert failed == {11, 12}
    failed = {f.source.line for f in verify(new, free, case.rows()).findings if not f.passed and f.source}
    assert failed == {12}


@pytest.mark.parametrize("speeds", [(0.19,), (0.21,), (0.05, 0.19), (0.05, 0.21), (0.21, 0.05)])
@pytest.mark.parametrize("fixed", [False, True])
def test_a_rail_alone_keeps_its_programmed_speed_on_a_line(speeds: tuple[float, ...], fixed: bool) -> None:
    """Two such lines in one rest are not told apart but by a rail that the cell fixes: then the faster one counts."""
    plant, d = plant_with_rail(rail_fixed=fixed), (0.05, 0.08, 0.08)
    q = [arm_at(plant, A[None], np.array([x]))[0] for x in d]
    lines = [move_l(12 + k, "p", A, d[1 + k], replace(V2500, v_leax=v)) for k, v in enumerate(speeds)]
    asked = program(move_j(11, "p", A, d[0]), *lines, home(18))
    pieces = (joint_move(plant, plant.start, q[0]), ride(plant, A, *d[:2]), joint_move(plant, q[1], plant.start))
    for step, bare in ((1e-3, False), (4e-3, True)):
        rows = rows_of(plant, pieces, step, grid_only=bare)
        for target in (None,) if bare else (None, Target.RAPID):
            found = [f for f in verify(asked, plant, rows, target=target).findings if not f.passed]
            legal = speeds[0] > 0.2 if fixed else max(speeds) > 0.2  # the peak of 30 mm in 0.3 s
            assert [(f.check, f.subject) for f in found] == ([] if legal else [("programmed speed", "rail")])


def test_wrong_axes_are_an_input_error() -> None:
    case = rapid_case()
    rows = case.rows()
    with pytest.raises(InputError, match=r"the file's axes are joint_1, .*; the robot's are rail, joint_1"):
        verify(case.program, case.plant, Trajectory(rows.names[1:], rows.t, rows.q[:, 1:]))


def test_rows_that_are_no_motion_are_refused() -> None:
    case = rapid_case()
    rows = case.rows()
    q = np.array(rows.q)
    q[17, 3] = np.nan
    with pytest.raises(InputError, match=r"^row 17: joint_3 is nan, wanted a finite number$"):
        verify(case.program, case.plant, Trajectory(rows.names, rows.t, q, rows.qd))
    with pytest.raises(InputError, match=r"^row 1: time 2\.\d+ s follows 2\.\d+ s; times must increase$"):
        verify(case.program, case.plant, Trajectory(rows.names, rows.t[::-1], rows.q, rows.qd))
    with pytest.raises(InputError, match=r"^the motion has 1 rows; at least 2 are needed$"):
        verify(case.program, case.plant, Trajectory(rows.names, rows.t[:1], rows.q[:1]))


def test_a_program_without_moves_is_a_rest_at_the_start() -> None:
    case = rapid_case()
    rest = Case(case.plant, program(wait(11, 0.2)), (hold(case.plant.start, 0.2),))
    assert verify(rest.program, rest.plant, rest.rows()).legal
    short = Case(case.plant, program(wait(11, 0.3)), rest.pieces)
    failed = [f.check for f in verify(short.program, short.plant, short.rows()).findings if not f.passed]
    assert failed == ["dwell length"]
    report = verify(program(), case.plant, case.rows())
    assert "end" in [f.check for f in report.findings if not f.passed]


def test_a_wait_after_an_output_says_what_lets_the_rail_move() -> None:
    case, rows, _ = rail_rides_through_a_held_wait()
    report = verify(case.program, case.plant, rows)
    (failed,) = [f.message for f in report.findings if not f.passed]
    end = case.starts[7]
    assert failed == (
        f"cell.mod:17:5: rail way while held 0.0675 m at t = {end:.3f} s, limit 1e-06 in the wait at MoveL p_b: "
        "it holds still after an output; 'waits: {rail: free}' in the cell file lets it move"
    )
    assert verify(rapid_case().program, case.plant, rows).legal


def test_a_rail_that_sways_less_than_promised_is_held() -> None:
    case = in_the_wait(0.9 * HELD)
    assert verify(case.program, case.plant, case.rows()).legal


@pytest.mark.parametrize("when", ["before", "after"])
def test_a_held_wait_may_lie_anywhere_in_a_longer_rest(when: str) -> None:
    """Foreign files may ride to their rail position before the process begins, or away when it is over."""
    case = held_case()
    d_0, d_1, _ = HELD_RAILS
    pieces = list(case.pieces)
    d = d_1 if when == "before" else d_0
    held = hold(arm_at(case.plant, A[None], np.array([d]))[0], 0.1)
    free = hold(arm_at(case.plant, A[None], np.array([d_1]))[0], 0.3)
    move = ride(case.plant, A, d_0, d_1, 0.25)
    pieces[2:4] = [move, held, free] if when == "before" else [held, move, free]
    late = replace(case, pieces=tuple(pieces))
    for rows in (late.rows(), late.rows(grid_only=True, step=0.004)):
        for target in (None, Target.RAPID):
            report = verify(case.program, case.plant, rows, target=target)
            assert report.legal, [f.message for f in report.findings if not f.passed]


def test_a_robot_without_a_rail_holds_none() -> None:
    case = bench_case()
    motions = [replace(motion, hold=Hold.PROGRAM) for motion in case.program.motions]
    assert verify(program(*motions), case.plant, case.rows()).legal


def test_a_row_at_the_stop_counts_before_one_that_is_near_only_by_what_missing_rows_are_granted() -> None:
    """A row behind a wide gap is granted more than it is off, the next ones, closer together, are not, until one stands
    at the stop: the move arrives there. Where none does, the first will do."""

    def chosen(*tight: bool) -> int:
        near = np.array([False, True, False, True, True, False])
        all_good = np.ones(6, dtype=bool)
        distance = np.array([9.0, 1.4, 1.2, 0.0, 0.2, 2.0])
        close = Closeness(
            np.arange(6), distance, near, np.array([False, False, False, *tight, False]), all_good, all_good, all_good
        )
        stop = case.program.motions[0]
        event = waypoint_matching._align(
            [ProgramPoint(0, stop, None, "p", None, None, None, None, False)], [events_of(close)]
        )[0]
        assert event is not None
        return event.first

    case = rapid_case()
    assert chosen(True, True) == 3
    assert chosen(False, False) == 1


def test_what_is_aligned_in_one_go_is_of_most_worth() -> None:
    """Random events of random points: the choice is that of the dynamic programme, and most often needs none."""
    rng, quick = np.random.default_rng(7), 0
    move = rapid_case().program.motions[0]
    for _ in range(300):
        points, events = [], []
        cuts = np.sort(rng.choice(400, 40, replace=False))
        for _ in range(rng.integers(1, 9)):
            spans = rng.integers(0, 20, rng.integers(0 if rng.random() < 0.1 else 1, 12))
            worst = rng.choice([0.0, 0.0, 0.3])
            own = []
            for i in np.unique(spans):
                first, last = (int(cut) for cut in cuts[2 * i : 2 * i + 2])
                good = np.arange((first + last + 1) // 2, last + 1)
                own.append(Event(first, last, good[: 0 if rng.random() < worst else None], last, rng.random() < worst))
            fly_by = FlyBy(0.01, 0.01, 0.01) if rng.random() < 0.3 else None
            if fly_by is not None:  # all passages are worth the same
                own = [Event(one.first, one.last, np.array([one.first]), one.first + 1) for one in own]
            optional = bool(rng.random() < 0.2)
            points.append(ProgramPoint(0, move, None, "p", None, np.eye(4), None, None, optional, (), fly_by))
            events.append(tuple(own))
        assert waypoint_matching._align(points, events) == waypoint_matching._of_most_worth(points, events)
        quick += waypoint_matching._at_once(points, events) is not None
    assert 30 < quick < 270


def test_boxes_near_a_point_are_found_by_boxes_around_them() -> None:
    rng = np.random.default_rng(7)
    low = rng.uniform(-1, 1, (BLOCK**2 + BLOCK + 5, 3)).cumsum(axis=0) / 10
    boxes = Boxes(low, low + rng.uniform(0, 0.1, low.shape), rng.uniform(0, 0.2, len(low)))
    for P in low[::500] + rng.normal(size=(len(low[::500]), 3)):
        found = boxes.near(P, 0.3)
        np.testing.assert_array_equal(found, np.flatnonzero(boxes.off(P) <= 0.3 + boxes.room))
        assert len(found) < len(low) / 4


def rail_runs_on(target: float) -> Case:
    """The tool stops at A for a moment while the rail runs on at 0.3 m/s, being at 0.15 m when it stands."""
    plant, v, d, T = replace(plant_with_rail(), rail_fixed=True), 0.3, 0.15, 1 / 6 + 6 / 60  # T: of the lines
    before, after = (arm_at(plant, A_IN[None], np.array([one]))[0] for one in (d - v * T / 2, d + v * T / 2))
    motions = program(
        move_j(11, "p_a_in", A_IN, float(before[0])),
        move_l(12, "p_a", A, target),
        move_l(13, "p_a_out", A_IN, float(after[0])),
        home(14, 0.0),
    )
    pieces = (
        joint_move(plant, plant.start, before),
        line_move(plant, A_IN, A, lambda t, _: (d - v * T / 2 + v * t**2 / (2 * T), v * t / T), 6.0, 60.0),
        line_move(plant, A, A_IN, lambda t, _: (d + v * t - v * t**2 / (2 * T), v - v * t / T), 6.0, 60.0),
        joint_move(plant, after, plant.start),
    )
    return Case(plant, motions, pieces)


@pytest.mark.parametrize("step", [0.001, 0.004, 0.007, 0.02])
def test_a_rail_may_run_on_while_the_tool_stops(step: float) -> None:
    """Between two rows nobody knows the moment of the stop: whatever grid there is, a legal motion is legal, and a
    target beside all places of the rail while the tool may stand is not met."""
    for marked in (True, False):
        rows = rail_runs_on(0.15).rows(step=step, grid_only=not marked)
        case = rail_runs_on(0.15)
        assert verify(case.program, case.plant, rows).legal
        case = rail_runs_on(0.15 + 2.5 * 0.3 * step)
        failed = [one for one in verify(case.program, case.plant, rows).findings if not one.passed]
        assert [(one.check, one.value) for one in failed] == [("rail target", pytest.approx(0.15, abs=0.3 * step))]
