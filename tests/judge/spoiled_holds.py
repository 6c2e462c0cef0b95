"""Motions whose rail moves where it must stand still."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from legal_motion import A_IN, B_IN, HELD_RAILS, A, Case, Piece, held_case, line_move, rapid_case, ride, swayed
from spoil_book import OVER, Judged, spoiled

from trajopt_cli.geometry import Array
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.motion import Hold, Wait
from trajopt_cli.problem.plan import Target


def in_the_wait(way: float) -> Case:
    """The rail of held_case goes away and back within the wait of line 13."""
    case = held_case()
    return case.swap(p2=swayed(case.plant, A, HELD_RAILS[0], 0.1, way))


def on_the_line(way: float) -> Case:
    """The rail of held_case goes away and back on the line 12."""
    case = held_case()

    def rail(_: Array, s: Array) -> tuple[Array, Array]:
        phase = np.pi * s[:, 0]
        return HELD_RAILS[0] + way * np.sin(phase) ** 2, way * np.pi * np.sin(2 * phase) * s[:, 1]

    return case.swap(p1=line_move(case.plant, A_IN, A, rail, 6.0, 60.0))


def in_the_joint_move(way: float) -> Case:
    """The rail of held_case goes away and back on the joint move 15."""
    case = held_case()
    piece = case.pieces[4]

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(t)
        phase = np.pi * t / piece.T
        q[:, 0] += way * np.sin(phase) ** 2
        qd[:, 0] += way * np.pi / piece.T * np.sin(2 * phase)
        return q, qd

    return case.swap(p4=Piece(piece.T, at, piece.switches))


@spoiled("way while held", "rail", 13)
def rail_sways_in_a_held_wait() -> Judged:
    case = in_the_wait(OVER * tol.HELD)
    return case, case.rows(), None


@spoiled("way while held", "rail", 13)
def rail_drifts_in_a_held_wait() -> Judged:
    """It never comes back: the wait ends beside where it began."""
    case = held_case()
    d_0, d_1, _ = HELD_RAILS
    d = d_0 + OVER * tol.HELD
    case = case.swap(p2=ride(case.plant, A, d_0, d, 0.1), p3=ride(case.plant, A, d, d_1))
    return case, case.rows(), Target.RAPID


@spoiled("way while held", "rail", 12)
def rail_moves_on_a_held_line() -> Judged:
    case = on_the_line(OVER * tol.HELD)
    return case, case.rows(), None


@spoiled("way while held", "rail", 15)
def rail_moves_in_a_held_joint_move() -> Judged:
    case = in_the_joint_move(OVER * tol.HELD)
    return case, case.rows(), None


@spoiled("way while held", "rail", 17)
def rail_rides_through_a_held_wait() -> Judged:
    """Every axis rests at both ends of the wait, and a RAPID controller would ride so; but an output was set."""
    case = rapid_case()
    motions = [
        replace(motion, hold=Hold.GRIPPER) if isinstance(motion, Wait) else motion for motion in case.program.motions
    ]
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), Target.RAPID


@spoiled("way while held", "rail", 17)
def rail_rides_until_a_held_wait_is_over() -> Judged:
    """The ride before the wait takes the wait's time, too: no stretch of the rest is long enough."""
    case = held_case()
    _, d_1, d_2 = HELD_RAILS
    X = B_IN
    case = case.swap(p5=ride(case.plant, X, d_1, (d_1 + d_2) / 2), p6=ride(case.plant, X, (d_1 + d_2) / 2, d_2, 0.1))
    return case, case.rows(), None


@spoiled("way while held", "rail", 16)
def rail_moves_in_a_held_move_that_stays() -> Judged:
    """A line to the point where the TCP is, with a programmed time and held, ridden through."""
    case = held_case()
    motions = list(case.program.motions)
    motions[5] = replace(motions[5], duration=0.3, hold=Hold.CELL)
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None


@spoiled("way while held", "rail", 15)
def rail_rides_at_a_stop_while_its_unit_is_not_active() -> Judged:
    """Both moves beside the stop hold it, each on its own."""
    case = held_case()
    motions = [
        replace(motion, hold=Hold.UNIT) if motion.source.line in (12, 15) else motion
        for motion in case.program.motions
        if motion.source.line != 14
    ]
    return replace(case, program=replace(case.program, motions=tuple(motions))), case.rows(), None
