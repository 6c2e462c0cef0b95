"""Motions spoiled at their stops, and what RAPID would not do."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from legal_motion import (
    A_IN,
    B_IN,
    A,
    Case,
    Piece,
    arm_at,
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
    quintic,
    rail_share,
    rapid_case,
    stream_case,
    wait,
)
from spoil_book import OVER, Judged, edited, row_in, spoiled

from trajopt_cli.geometry import Array
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.problem.plan import Target
from trajopt_cli.trajectory import Trajectory


@spoiled("dwell length", "TCP", 13)
def short_dwell() -> Judged:
    case = rapid_case()
    q = case.pieces[2].at(np.zeros(1))[0][0]
    case = case.swap(p2=hold(q, 0.1 - OVER * tol.DWELL))
    return case, case.rows(), None


def with_a_wait_beside_line_12(longer: float) -> Case:
    """Behind line 12 as much time goes by as its wait, which runs beside it, takes, less what is said [s]."""
    case = rapid_case()
    motions = list(case.program.motions)
    motions[2] = replace(motions[2], duration=0.0, beside=case.pieces[1].T + case.pieces[2].T + longer)
    return replace(case, program=program(*motions))


@spoiled("duration", "MoveL p_a", 13)
def next_move_before_a_wait_beside_is_over() -> Judged:
    case = with_a_wait_beside_line_12(OVER * tol.DURATION)
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


def short_of(twist: Array) -> Judged:
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
    return short_of(np.array([0, 0, OVER * tol.STOP_POSITION]))


@spoiled("stop reached", "TCP", 12)
def point_skipped() -> Judged:
    return short_of(np.array([0, 0, 0.079]))


@spoiled("stop reached")
def points_swapped() -> Judged:
    plant = plant_with_rail()
    q_a, q_b = (arm_at(plant, X[None], np.array([d]))[0] for X, d in ((A_IN, 0.05), (B_IN, 0.25)))
    route = (plant.start, q_b, q_a, plant.start)
    pieces = tuple(joint_move(plant, a, b) for a, b in pairwise(route))
    case = Case(plant, program(move_j(11, "p_a_in", A_IN), move_j(12, "p_b_in", B_IN), home(13)), pieces)
    return case, case.rows(), None


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


@spoiled("start rest", "rail")
def not_at_rest_at_the_start() -> Judged:
    case = rapid_case()

    def edit(t: Array, q: Array, qd: Array) -> None:
        qd[0, 0] = OVER * tol.REST_JOINT

    return case, edited(case, edit), None


@spoiled("end rest", "rail", 18)
def not_at_rest_at_the_end() -> Judged:
    case = rapid_case()

    def edit(t: Array, q: Array, qd: Array) -> None:
        qd[-1, 0] = OVER * tol.REST_JOINT

    return case, edited(case, edit), None


@spoiled("end rest", "rail", 18)
def not_at_rest_at_the_end_without_speed_columns() -> Judged:
    """From rest at the last row the rail can have come A h^2/2 in the row before: a mean speed of A h/2."""
    case = rapid_case()
    q_0 = case.pieces[7].at(np.zeros(1))[0][0]
    v = np.r_[OVER * (case.plant.limits.acceleration[0] * 1e-3 / 2 + tol.REST_JOINT), np.zeros(6)]
    case = case.swap(p7=quintic(q_0, np.zeros(7), case.plant.start, v, 1.0))
    rows = case.rows(step=1e-3)
    whole = rows.t[-1] - rows.t[-2] > 9e-4
    keep = np.arange(len(rows.t)) if whole else np.delete(np.arange(len(rows.t)), -2)
    return case, Trajectory(rows.names, rows.t[keep], rows.q[keep]), None


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


@spoiled("duration", "MoveJ p_a_in", 11)
def programmed_time_not_kept() -> Judged:
    case = rapid_case()
    motions = list(case.program.motions)
    motions[0] = move_j(11, "p_a_in", A_IN, 0.05, duration=case.pieces[0].T + OVER * tol.DURATION)
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None


@spoiled("partner", "MoveJ p_a_in", 11)
def done_before_the_other_robots() -> Judged:
    case = rapid_case()
    motions = list(case.program.motions)
    late = case.pieces[0].T + OVER * tol.DURATION
    motions[0] = move_j(11, "p_a_in", A_IN, 0.05, identity=10, partner=late)
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None


def _shorter_self_motion(case: Case) -> Trajectory:
    return case.swap(p4=faster(case.pieces[4], 1 / (1 - OVER * tol.DURATION / 0.3))).rows()


@spoiled("duration", "MoveL p_b", 15)
def programmed_self_motion_too_short() -> Judged:
    case = stream_case()
    return case.swap(p4=faster(case.pieces[4], 1 + OVER * tol.DURATION / 0.3)), _shorter_self_motion(case), None


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


@spoiled("row spacing", "file")
def rows_too_far_apart() -> Judged:
    case = rapid_case()
    return case, case.rows(grid_only=True, step=OVER * tol.LARGEST_GAP), None
