"""Motions with a tool that may be turned about its axis: one that is, and spoiled ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from legal_motion import (
    A_IN,
    A,
    Case,
    Piece,
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
    wait,
)
from spoil_book import OVER, Judged, spoiled

from trajopt_cli.geometry import Array, rotation_about
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.motion import FreeTurn
from trajopt_cli.problem.plan import Target

Z = (0.0, 0.0, 1.0)
SECTOR = FreeTurn(Z, -0.5, 0.5)
RAIL = 0.08


def about_z(X: Array, angle: float, axis: Array | tuple[float, ...] = Z) -> Array:
    out = np.array(X)
    out[:3, :3] = out[:3, :3] @ rotation_about(axis, angle)
    return out


def turned_case(first: float, last: float, line: Piece | None = None, free: FreeTurn | None = SECTOR) -> Case:
    """A joint move to p_a_in turned by first [rad], a line to p_a turned by last, and a wait there, both free."""
    plant = plant_with_rail()
    X_0, X_1 = about_z(A_IN, first), about_z(A, last)
    line = line or line_move(plant, X_0, X_1, rail_share(RAIL, RAIL), 4.0, 20.0)
    ends = [line.at(np.array([t]))[0][0] for t in (0.0, line.T)]
    motions = program(
        move_j(11, "p_a_in", A_IN, RAIL, free=free), move_l(12, "p_a", A, RAIL, free=free), wait(13, 0.1), home(14)
    )
    pieces = (
        joint_move(plant, plant.start, ends[0]),
        line,
        hold(ends[1], 0.1),
        joint_move(plant, ends[1], plant.start),
    )
    return Case(plant, motions, pieces)


def bent(piece: Piece, most: float) -> Piece:
    """The same way with joint 6 farther on by up to so much [rad], halfway."""

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = (np.array(x) for x in piece.at(t))
        phase = np.pi * t / piece.T
        q[:, 6] += most * np.sin(phase) ** 2
        qd[:, 6] += most * np.pi / piece.T * np.sin(2 * phase)
        return q, qd

    return replace(piece, at=at)


@spoiled("line rotation", "TCP", 12)
def tilted_axis_of_a_free_tool() -> Judged:
    case = turned_case(0.2, 0.2)
    tilt = [0, 0, 0, 0.6, 0.8, 0]
    case = case.swap(p1=nudged(case.plant, case.pieces[1], tilt, OVER * tol.LINE_ROTATION))
    return case, case.rows(), None


@spoiled("line rotation", "TCP", 12)
def axis_tilted_by_half_a_degree_halfway_of_an_uneven_turn() -> Judged:
    case = turned_case(0.1, 0.4)
    case = case.swap(p1=bent(case.pieces[1], 0.05))
    case = case.swap(p1=nudged(case.plant, case.pieces[1], [0, 0, 0, 0.6, 0.8, 0], np.radians(0.5)))
    return case, case.rows(), None


@spoiled("line rotation", "TCP", 12)
def beyond_the_sector_between_two_rows() -> Judged:
    """At the edge of the sector on every row; the speeds of two rows say that joint 6 is beyond it between them."""
    case = turned_case(0.5, 0.5)
    rows = case.rows()
    i = int(np.searchsorted(rows.t, case.starts[1] + case.pieces[1].T / 2))
    assert rows.qd is not None
    qd, step = rows.qd.copy(), float(rows.t[i + 1] - rows.t[i])
    qd[i : i + 2, 6] += np.array([1.0, -1.0]) * 4 * OVER * tol.LINE_ROTATION / step
    return case, replace(rows, qd=qd), None


@spoiled("line rotation", "TCP", 12)
def beyond_the_sector_on_the_line() -> Judged:
    line = turned_case(0.5, 0.5).pieces[1]
    case = turned_case(0.5, 0.5, bent(line, OVER * tol.LINE_ROTATION))
    return case, case.rows(), None


@spoiled("stop reached", "TCP", 12)
def beyond_the_sector_at_the_stop() -> Judged:
    case = turned_case(0.5, 0.5 + OVER * tol.STOP_ROTATION)
    return case, case.rows(), None


@spoiled("turn along line", "TCP", 12)
def unevenly_turned_by_a_controller() -> Judged:
    line = turned_case(0.1, 0.4).pieces[1]
    case = turned_case(0.1, 0.4, bent(line, OVER * tol.LINE_ROTATION))
    return case, case.rows(), Target.RAPID


@spoiled("dwell drift", "TCP", 13)
def turned_in_the_wait() -> Judged:
    case = turned_case(0.2, 0.2)
    case = case.swap(p2=bent(case.pieces[2], OVER * tol.STOP_ROTATION))
    return case, case.rows(), None


@spoiled("stop reached", "TCP", 11)
def turned_though_not_free() -> Judged:
    case = turned_case(0.2, 0.2, free=None)
    return case, case.rows(), None
