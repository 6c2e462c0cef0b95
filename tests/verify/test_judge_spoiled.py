"""Spoiled motions, each 1.1 times the smallest offence the judge promises to see: all caught by the right check."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise

import numpy as np
import pytest
from legal_motion import (
    A_IN,
    B_IN,
    V2500,
    A,
    B,
    Case,
    Piece,
    arm_at,
    down,
    faster,
    hold,
    home,
    joint_move,
    line_move,
    move_j,
    move_l,
    nudged,
    plant_with_rail,
    program,
    rail_share,
    rapid_case,
    stream_case,
    trapezoid,
    wait,
)

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import header, read_csv_text, write_csv_text
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.report import Report
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.verify import tolerances as tol
from trajopt_cli.verify.joints import check_joints
from trajopt_cli.verify.judge import verify as verify_with_advice
from trajopt_cli.verify.rows import look

verify = partial(verify_with_advice, advice=False)
Judged = tuple[Case, Trajectory, Target | None]
SPOILED: dict[str, tuple[Callable[[], Judged], str, str | None, int | None]] = {}
OVER = 1.1  # times what is promised


def spoiled(check: str, subject: str | None = "TCP", line: int | None = None) -> Callable[..., Callable[[], Judged]]:
    """Register a spoiled motion with the check that must name it, its subject (None: any) and its motion's line."""

    def add(make: Callable[[], Judged]) -> Callable[[], Judged]:
        SPOILED[make.__name__] = make, check, subject, line
        return make

    return add


def limited(plant: Plant, **changes: dict[int, float]) -> Plant:
    values = {k: np.array(getattr(plant.limits, k)) for k in ("lower", "upper", "velocity", "acceleration")}
    for kind, axes in changes.items():
        for axis, value in axes.items():
            values[kind][axis] = value
    return replace(plant, limits=JointLimits(plant.limits.names, **values))


def edited(case: Case, edit: Callable[[Array, Array, Array], None]) -> Trajectory:
    rows = case.rows()
    t, q, qd = np.array(rows.t), np.array(rows.q), np.array(rows.qd)
    edit(t, q, qd)
    return Trajectory(rows.names, t, q, qd)


def row_in(case: Case, trajectory: Trajectory, piece: int, share: float) -> int:
    return int(np.searchsorted(trajectory.t, case.starts[piece] + share * case.pieces[piece].T))


@spoiled("joint speed", "rail", 15)
def too_fast_axis() -> Judged:
    case = rapid_case(limited(plant_with_rail(), velocity={0: 0.4}))
    assert verify(case.program, case.plant, case.rows()).legal
    case = case.swap(p4=faster(case.pieces[4], 1 + OVER * tol.JOINT))
    return replace(case, plant=limited(case.plant, acceleration={0: 3.1})), case.rows(), None


@spoiled("joint acceleration", "rail", 15)
def too_fast_start() -> Judged:
    case = rapid_case()
    case = case.swap(p4=faster(case.pieces[4], np.sqrt(1 + OVER * tol.JOINT)))
    return case, case.rows(), None


@spoiled("joint position", "joint_5")
def beyond_the_range() -> Judged:
    case = rapid_case()
    rows = case.rows()
    low, top = float(case.plant.limits.lower[5]), float(rows.q[:, 5].max())
    high = (top + OVER * tol.JOINT * low) / (1 + OVER * tol.JOINT)  # top = high + 1.1 tol (high - low)
    return replace(case, plant=limited(case.plant, upper={5: high})), rows, None


@spoiled("joint position", "rail")
def beyond_the_range_between_rows() -> Judged:
    """The rail turns back at its end stop between two rows 20 ms apart, as its speeds tell."""
    plant = plant_with_rail()
    case = Case(plant, program(home(18)), (hold(plant.start, 0.1),))
    t = np.arange(11) * 0.01
    qd, qs = np.zeros((11, 7)), np.tile(plant.start, (11, 1))
    v = 0.012
    qd[5, 0], qd[6, 0] = v, -v
    qs[5, 0] = qs[6, 0] = plant.limits.upper[0] - v * v / 6 + OVER * tol.JOINT * 2.4
    return case, Trajectory(plant.limits.names, t, qs, qd), None


def _tcp_case(speed: float, acceleration: float, v: float, a: float, factor: float) -> Judged:
    plant = replace(plant_with_rail(), tcp=TcpCaps(speed, acceleration))
    case = rapid_case(plant)
    motions = list(case.program.motions)
    motions[1] = move_l(12, "p_a", A, 0.08, speed=V2500)
    case = replace(case, program=replace(case.program, motions=tuple(motions)))
    return _with_line(case, v, a, 1.0)[0], _with_line(case, v, a, factor)[1], None


def _with_line(case: Case, v: float, a: float, factor: float) -> tuple[Case, Trajectory]:
    case = case.swap(p1=faster(line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), v, a), factor))
    return case, case.rows()


@spoiled("TCP speed", "TCP", 12)
def tcp_too_fast() -> Judged:
    case, rows, _ = _tcp_case(0.5, 20.0, 0.5 / 0.08, 60.0, 1 + OVER * tol.TCP)
    return case, rows, None


@spoiled("TCP acceleration", "TCP", 12)
def tcp_accelerates_too_hard() -> Judged:
    case, rows, _ = _tcp_case(2.5, 4.8, 5.0, 60.0, np.sqrt(1 + OVER * tol.TCP))
    return case, rows, None


@spoiled("programmed speed", "TCP", 12)
def faster_than_programmed() -> Judged:
    case = rapid_case()
    case, rows = _with_line(case, 0.5 / 0.08, 60.0, 1 + OVER * tol.TCP)
    return case, rows, None


@spoiled("line position", "TCP", 12)
def bowed_line() -> Judged:
    case = rapid_case()
    case = case.swap(p1=nudged(case.plant, case.pieces[1], [0.6, 0.8, 0, 0, 0, 0], OVER * tol.LINE_POSITION))
    return case, case.rows(), None


@spoiled("line rotation", "TCP", 16)
def turned_on_the_line() -> Judged:
    case = rapid_case()
    case = case.swap(p5=nudged(case.plant, case.pieces[5], [0, 0, 0, 0, 0.6, 0.8], OVER * tol.LINE_ROTATION))
    return case, case.rows(), None


@spoiled("line progress", "TCP", 12)
def backwards_on_the_line() -> Judged:
    """Half way, back by the offence, and on: from rest to rest three times."""
    case, back = rapid_case(), OVER * tol.BACKWARD / 0.08
    T, half, _ = trapezoid(6.0, 60.0)
    t_back = 0.05

    def at(t: Array) -> tuple[Array, Array]:
        first, last = np.clip(t, 0, T), np.clip(t - T - t_back, 0, T)
        s_1, v_1 = half(first)
        s_2, v_2 = half(last)
        u = np.clip((t - T) / t_back, 0, 1)
        rate = -back * 30 * (u * (1 - u)) ** 2 / t_back
        s = 0.5 * s_1 - back * u**3 * (10 - 15 * u + 6 * u * u) + (0.5 + back) * s_2
        return s, 0.5 * v_1 + rate + (0.5 + back) * v_2

    profile = (2 * T + t_back, at, (0.1, T - 0.1, T, T + t_back, T + t_back + 0.1, 2 * T + t_back - 0.1))
    case = case.swap(p1=line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), 0, 0, profile=profile))
    return case, case.rows(), None


@spoiled("dwell length", "TCP", 13)
def short_dwell() -> Judged:
    case = rapid_case()
    q = case.pieces[2].at(np.zeros(1))[0][0]
    case = case.swap(p2=hold(q, 0.1 - OVER * tol.DWELL))
    return case, case.rows(), None


@spoiled("dwell drift", "TCP", 13)
def drift_in_a_dwell() -> Judged:
    case = rapid_case()
    case = case.swap(p2=nudged(case.plant, case.pieces[2], [0, 0.6, 0.8, 0, 0, 0], OVER * tol.STOP_POSITION))
    return case, case.rows(), None


@spoiled("dwell drift", "TCP", 17)
def turning_in_a_dwell() -> Judged:
    case = rapid_case()
    case = case.swap(p6=nudged(case.plant, case.pieces[6], [0, 0, 0, 0, 0, 1.0], OVER * tol.STOP_ROTATION))
    return case, case.rows(), None


def _short_of(twist: Array) -> Judged:
    """The line ends beside p_a, dwells there, and goes back."""
    case = rapid_case()
    X = np.array(A)
    X[:3, 3] += twist
    q = arm_at(case.plant, X[None], np.array([0.08]))[0]
    case = case.swap(
        p1=line_move(case.plant, A_IN, X, rail_share(0.05, 0.08), 6.0, 60.0),
        p2=hold(q, 0.1),
        p3=line_move(case.plant, X, A_IN, rail_share(0.08, 0.12), 6.0, 60.0),
    )
    return case, case.rows(), None


@spoiled("stop reached", "TCP", 12)
def point_missed() -> Judged:
    return _short_of(np.array([0, 0, OVER * tol.STOP_POSITION]))


@spoiled("stop reached", "TCP", 12)
def point_skipped() -> Judged:
    return _short_of(np.array([0, 0, 0.079]))


@spoiled("stop reached")
def points_swapped() -> Judged:
    plant = plant_with_rail()
    q_a, q_b = (arm_at(plant, X[None], np.array([d]))[0] for X, d in ((A_IN, 0.05), (B_IN, 0.25)))
    route = (plant.start, q_b, q_a, plant.start)
    pieces = tuple(joint_move(plant, a, b) for a, b in pairwise(route))
    case = Case(plant, program(move_j(11, "p_a_in", A_IN), move_j(12, "p_b_in", B_IN), home(13)), pieces)
    return case, case.rows(), None


@spoiled("line position", "TCP", 14)
def an_extra_excursion() -> Judged:
    """From p_a up and down again by another way, before the program's own way up."""
    case = rapid_case()
    X = down(0.48, 0.1, 0.40)
    detour = [
        line_move(case.plant, A, X, rail_share(0.08, 0.08), 6.0, 60.0),
        line_move(case.plant, X, A, rail_share(0.08, 0.08), 6.0, 60.0),
    ]
    case = replace(case, pieces=(*case.pieces[:3], *detour, *case.pieces[3:]))
    return case, case.rows(), None


@spoiled("joint acceleration", "joint_4")
def spike_in_one_row() -> Judged:
    """A position off by A h^2 in one row needs more than A before, at or after it, whatever the motion there."""
    case = rapid_case()
    top = case.plant.limits.acceleration[4]

    def edit(t: Array, q: Array, qd: Array) -> None:
        q[200, 4] += OVER * top * 1e-3**2

    return case, edited(case, edit), None


@spoiled("joint acceleration", "joint_4")
def spike_without_speed_columns() -> Judged:
    case, rows, _ = spike_in_one_row()
    return case, Trajectory(rows.names, rows.t, rows.q), None


@spoiled("joint acceleration", "joint_1")
def a_jump() -> Judged:
    case = rapid_case()
    top = case.plant.limits.acceleration[1]

    def edit(t: Array, q: Array, qd: Array) -> None:
        q[1100:1150, 1] += OVER * top * 1e-3**2

    return case, edited(case, edit), None


@spoiled("stop rest", "TCP", 11)
def flown_by_a_stop() -> Judged:
    case = rapid_case()

    def edit(t: Array, q: Array, qd: Array) -> None:
        row = int(np.searchsorted(t, case.starts[1] - 1e-9))
        J = case.plant.robot.jacobian(q[row : row + 1])[0]
        qd[row, 1:] += np.linalg.solve(J[:, 1:], np.r_[0, 0, -OVER * tol.REST_LINEAR, 0, 0, 0])

    return case, edited(case, edit), None


@spoiled("stop rest", "TCP", 11)
def flown_by_at_speed() -> Judged:
    """The second visit of the same pose must not hide that the first was flown through."""
    plant = plant_with_rail()
    case = rapid_case(plant)
    rows = case.rows()
    X = plant.robot.forward(rows.q[row_in(case, rows, 1, 0.3)])
    motions = list(case.program.motions)
    motions[0] = move_j(11, "p_through", X)
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None


@spoiled("end rest", "rail", 18)
def not_at_rest_at_the_end() -> Judged:
    case = rapid_case()

    def edit(t: Array, q: Array, qd: Array) -> None:
        qd[-1, 0] = OVER * tol.REST_JOINT

    return case, edited(case, edit), None


@spoiled("stop reached")
def reversed_program() -> Judged:
    case = rapid_case()
    rows = case.rows()
    t = rows.t[-1] - rows.t[::-1]
    return case, Trajectory(rows.names, t, rows.q[::-1], -rows.qd[::-1]), None


@spoiled("stop reached", "arm", 18)
def cut_end() -> Judged:
    case = rapid_case()
    rows = case.rows()
    return case, Trajectory(rows.names, rows.t[:-5], rows.q[:-5], rows.qd[:-5]), None


@spoiled("end", "motion after it", 18)
def goes_on_after_the_end() -> Judged:
    case = rapid_case()
    away = joint_move(case.plant, case.plant.start, case.plant.start + np.r_[0.0, 0.01, np.zeros(5)])
    case = replace(case, pieces=(*case.pieces, away))
    return case, case.rows(), None


@spoiled("start", "joint_1", None)
def wrong_start() -> Judged:
    case = rapid_case()
    q_1 = case.pieces[0].at(np.array([case.pieces[0].T]))[0][0]
    start = case.plant.start + np.r_[0, OVER * tol.JOINT_TARGET, np.zeros(5)]
    case = case.swap(p0=joint_move(case.plant, start, q_1))
    return case, case.rows(), None


@spoiled("rail target", "rail", 18)
def wrong_rail_at_home() -> Judged:
    case = rapid_case()
    q_0 = case.pieces[7].at(np.zeros(1))[0][0]
    end = case.plant.start + np.r_[OVER * tol.JOINT_TARGET, np.zeros(6)]
    case = case.swap(p7=joint_move(case.plant, q_0, end))
    return case, case.rows(), None


@spoiled("speed columns", "joint_1")
def speeds_that_positions_deny() -> Judged:
    """Speeds off by A h/4 over a stretch cannot belong to the positions, although neither alone is too fast."""
    case = rapid_case()
    top = case.plant.limits.acceleration[1]

    def edit(t: Array, q: Array, qd: Array) -> None:
        first = int(np.searchsorted(t, case.starts[4] + 0.15))
        assert np.ptp(np.diff(t[first : first + 12])) < 1e-9
        qd[first : first + 10, 1] += OVER * top * 1e-3 / 4

    return case, edited(case, edit), None


@spoiled("joint acceleration", "joint_4")
def only_between_rows() -> Judged:
    """One speed off by A h/4: mean accelerations are a quarter of the limit, the Hermite's at the row is above it."""
    case = rapid_case()
    top = case.plant.limits.acceleration[4]

    def edit(t: Array, q: Array, qd: Array) -> None:
        qd[200, 4] += OVER * top * 1e-3 / 4

    return case, edited(case, edit), None


@spoiled("duration", "MoveJ p_a_in", 11)
def programmed_time_not_kept() -> Judged:
    case = rapid_case()
    motions = list(case.program.motions)
    motions[0] = move_j(11, "p_a_in", A_IN, 0.05, duration=case.pieces[0].T + OVER * tol.DURATION)
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None


@spoiled("duration", "MoveL p_b", 15)
def programmed_self_motion_too_short() -> Judged:
    case = stream_case()
    return case.swap(p4=faster(case.pieces[4], 1 + OVER * tol.DURATION / 0.3)), _shorter_self_motion(case), None


def _shorter_self_motion(case: Case) -> Trajectory:
    return case.swap(p4=faster(case.pieces[4], 1 / (1 - OVER * tol.DURATION / 0.3))).rows()


@spoiled("rail target", "rail", 12)
def rail_moved_although_fixed() -> Judged:
    case = rapid_case(plant_with_rail(rail_fixed=True))
    motions = list(case.program.motions)
    motions[1] = move_l(12, "p_a", A, 0.08 + OVER * tol.JOINT_TARGET)
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None


@spoiled("arm holds", "joint_6", 16)
def arm_moves_with_external_axes() -> Judged:
    case = stream_case()
    piece = case.pieces[5]

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(t)
        phase = np.pi * t / piece.T
        q[:, 6] += OVER * tol.JOINT_TARGET * np.sin(phase) ** 2
        qd[:, 6] += OVER * tol.JOINT_TARGET * np.pi / piece.T * np.sin(2 * phase)
        return q, qd

    case = case.swap(p5=Piece(piece.T, at, piece.switches))
    return case, case.rows(), None


def _creep(case: Case) -> float:
    """Rail speed at which the fastest joint (1 or 6, they turn alike) makes the offence while the TCP rests at p_a."""
    J = case.plant.robot.jacobian(arm_at(case.plant, A[None], np.array([0.08]))[0])
    return OVER * tol.REST_JOINT / float(np.abs(np.linalg.solve(J[:, 1:], J[:, 0])).max())


@spoiled("dwell rest", None, 14)
def axes_move_when_a_condition_wait_ends() -> Judged:
    """The rail creeps under the resting TCP through the whole stop at p_a."""
    case = rapid_case()
    motions = list(case.program.motions)
    motions[2] = wait(14, 0.0, "di_ready")
    rate = _creep(case)

    def edit(t: Array, q: Array, qd: Array) -> None:
        a, b = (int(np.searchsorted(t, case.starts[i] - 1e-9)) for i in (2, 3))
        d = 0.08 + rate * (t[a : b + 1] - t[a])
        q[a : b + 1] = arm_at(case.plant, np.tile(A, (b + 1 - a, 1, 1)), d)
        J = case.plant.robot.jacobian(q[a : b + 1])
        qd[a : b + 1, 0] = rate
        qd[a : b + 1, 1:] = -np.linalg.solve(J[:, :, 1:], J[:, :, :1] * rate)[..., 0]

    return replace(case, program=program(*motions)), edited(case, edit), None


@spoiled("axes rest", None, 12)
def an_axis_moves_at_a_rapid_stop() -> Judged:
    case = rapid_case()

    def edit(t: Array, q: Array, qd: Array) -> None:
        a, b = (int(np.searchsorted(t, case.starts[i] - 1e-9)) for i in (2, 3))
        J = case.plant.robot.jacobian(q[a])
        qd[a : b + 1, 0] = _creep(case)
        qd[a : b + 1, 1:] = -np.linalg.solve(J[:, 1:], J[:, 0] * _creep(case))

    return case, edited(case, edit), Target.RAPID


@spoiled("joint line", "joint_4", 15)
def a_rapid_joint_move_that_bends() -> Judged:
    case = rapid_case()
    piece = case.pieces[4]

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(t)
        phase = np.pi * t / piece.T
        q[:, 4] += OVER * tol.JOINT_TARGET * np.sin(phase) ** 2
        qd[:, 4] += OVER * tol.JOINT_TARGET * np.pi / piece.T * np.sin(2 * phase)
        return q, qd

    case = case.swap(p4=Piece(piece.T, at, piece.switches))
    return case, case.rows(), Target.RAPID


@spoiled("rail along line", "rail", 12)
def a_rail_out_of_proportion() -> Judged:
    case = rapid_case()
    extra = OVER * tol.JOINT_TARGET

    def rail(t: Array, s: Array) -> tuple[Array, Array]:
        d = 0.05 + 0.03 * s[:, 0] + extra * np.sin(np.pi * s[:, 0]) ** 2
        return d, (0.03 + extra * np.pi * np.sin(2 * np.pi * s[:, 0])) * s[:, 1]

    case = case.swap(p1=line_move(case.plant, A_IN, A, rail, 6.0, 60.0))
    return case, case.rows(), Target.RAPID


@spoiled("joint speed", "rail", 15)
def too_fast_axis_without_speed_columns() -> Judged:
    case, rows, _ = too_fast_axis()
    return case, Trajectory(rows.names, rows.t, rows.q), None


@spoiled("TCP acceleration", "TCP", 12)
def tcp_accelerates_too_hard_without_speed_columns() -> Judged:
    case, rows, _ = tcp_accelerates_too_hard()
    return case, Trajectory(rows.names, rows.t, rows.q), None


@spoiled("TCP acceleration", "TCP", 12)
def tcp_accelerates_too_hard_only_between_rows() -> Judged:
    """Acceleration that grows to its peak at a switch: no mean over a row reaches it, the Hermite's end does."""
    ramp, middle = 0.12, 0.12  # s: acceleration rises, speed stays; then the mirror image
    T, jerk = 2 * ramp + middle, 1.0 / (ramp**3 / 3 + ramp**2 / 2 * middle)

    def at(t: Array) -> tuple[Array, Array]:
        up, down_ = np.minimum(t, ramp), np.clip(T - t, 0, ramp)
        way = jerk * (up**3 / 6 + ramp**2 / 2 * np.clip(t - ramp, 0, middle))
        s = np.where(t <= T - ramp, way, 1.0 - jerk * down_**3 / 6)
        return s, jerk * np.minimum(up, down_) ** 2 / 2

    cap = 0.08 * jerk * ramp / (1 + OVER * tol.TCP)
    case = rapid_case(replace(plant_with_rail(), tcp=TcpCaps(2.5, cap)))
    profile = (T, at, (ramp, ramp + middle))
    case = case.swap(p1=line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), 0, 0, profile=profile))
    return case, case.rows(), None


@spoiled("programmed speed", "TCP", 12)
def faster_than_programmed_only_between_rows() -> Judged:
    """Rows of 10 ms, the peak of a smooth profile half way between two of them: 0.2 % above what the rows show. Of the
    places looked at between the rows the nearest is 1 ms off and shows it to 1e-4."""
    case = rapid_case()
    T = 0.31

    def at(t: Array) -> tuple[Array, Array]:
        u = t / T
        return u**3 * (10 - 15 * u + 6 * u * u), 30 * (u * (1 - u)) ** 2 / T

    start, peak = case.starts[1] + T / 2, 0.08 * 1.875 / T
    # the piece before waits until the peak falls between two rows
    rest = (0.005 - start) % 0.01
    q_in = case.pieces[1].at(np.zeros(1))[0][0]
    pieces = [case.pieces[0], hold(q_in, rest + 0.01), line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), 0, 0,
              profile=(T, at, ())), *case.pieces[2:]]  # fmt: skip
    motions = list(case.program.motions)
    motions[1] = move_l(12, "p_a", A, 0.08, speed=replace(V2500, name="v", v_tcp=peak / (1 + OVER * 2 * tol.TCP)))
    case = Case(case.plant, program(*motions), tuple(pieces))
    rows = case.rows(step=0.01)
    assert not np.any(np.abs(rows.t - start - rest - 0.01) < 4e-3)
    return case, rows, None


@spoiled("line position", "TCP", 12)
def bowed_only_between_rows() -> Judged:
    """Rows of 10 ms on the line, one with a speed across it: the Hermite leaves the chord beside that row."""
    case = rapid_case()
    rows = case.rows(step=0.01)
    t, q, qd = np.array(rows.t), np.array(rows.q), np.array(rows.qd)
    row = row_in(case, rows, 1, 0.5)
    across = OVER * tol.LINE_POSITION / (4 / 27 * 0.01)
    J = case.plant.robot.jacobian(q[row])
    qd[row, 1:] += np.linalg.solve(J[:, 1:], np.r_[0, across, 0, 0, 0, 0])
    return case, Trajectory(rows.names, t, q, qd), None


@spoiled("row spacing", "file")
def rows_too_far_apart() -> Judged:
    case = rapid_case()
    return case, case.rows(grid_only=True, step=OVER * tol.LARGEST_GAP), None


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


def test_nan_and_reversed_time_are_malformed_files() -> None:
    case = rapid_case()
    text = write_csv_text(case.rows())
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


def test_two_joint_moves_to_one_pose_share_a_rest() -> None:
    case = rapid_case()
    motions = list(case.program.motions)
    motions = [*motions[:3], move_j(19, "p_a_again", A), wait(20, 0.05), *motions[3:]]
    assert [f.message for f in verify(program(*motions), case.plant, case.rows()).findings if not f.passed] == [
        "cell.mod:20:5: TCP dwell length 0 s at t = 0.734 s, at least 0.05 at MoveJ p_a_again"
    ]
    q = case.pieces[2].at(np.zeros(1))[0][0]
    assert verify(program(*motions), case.plant, case.swap(p2=hold(q, 0.15)).rows()).legal


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
    seen = replace(look(case.plant, rows, None), marked=True, open_time=np.zeros(len(t)))
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


def test_wrong_axes_are_an_input_error() -> None:
    case = rapid_case()
    rows = case.rows()
    with pytest.raises(InputError, match=r"the file's axes are joint_1, .*; the robot's are rail, joint_1"):
        verify(case.program, case.plant, Trajectory(rows.names[1:], rows.t, rows.q[:, 1:]))


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
    "turns 0.2 mm before the point": (lambda _: _short_of(np.array([0, 0, 2e-4]))[0], "stop reached"),
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


def test_tolerances_are_the_promised_ones() -> None:
    assert (tol.JOINT, tol.TCP) == (1e-6, 1e-4)
    assert tol.LINE_POSITION <= 1e-6
    assert max(tol.STOP_POSITION, tol.STOP_ROTATION, tol.LINE_ROTATION, tol.JOINT_TARGET, tol.BACKWARD) <= 1e-6
    assert (tol.DWELL, tol.DURATION) == (1e-9, 1e-6)
    assert max(tol.REST_LINEAR, tol.REST_ANGULAR, tol.REST_JOINT) <= 1e-5
