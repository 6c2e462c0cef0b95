"""Motions spoiled on their way: axes, TCP, lines, speed columns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from legal_motion import (
    A_IN,
    V2500,
    A,
    Case,
    down,
    faster,
    hold,
    home,
    line_move,
    move_l,
    nudged,
    plant_with_rail,
    program,
    rail_share,
    rapid_case,
    trapezoid,
)
from legal_motion import judged as verify
from spoil_book import OVER, Judged, edited, limited, row_in, spoiled

from trajopt_cli.geometry import Array
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.limits import TcpCaps
from trajopt_cli.trajectory import Trajectory


@spoiled("joint speed", "rail", 15)
def too_fast_axis() -> Judged:
    case = rapid_case(limited(plant_with_rail(), velocity={0: 0.5}))
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


def with_line(case: Case, v: float, a: float, factor: float) -> Trajectory:
    """Rows of the case with another line p_a_in to p_a: speed v, acceleration a in shares, all of it times factor."""
    return case.swap(p1=faster(line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), v, a), factor)).rows()


def tcp_case(speed: float, acceleration: float) -> Case:
    """The line p_a_in to p_a programmed so fast that only the TCP caps hold it."""
    case = rapid_case(replace(plant_with_rail(), tcp=TcpCaps(speed, acceleration)))
    motions = list(case.program.motions)
    motions[1] = move_l(12, "p_a", A, 0.08, speed=V2500)
    return replace(case, program=program(*motions))


@spoiled("TCP speed", "TCP", 12)
def tcp_too_fast() -> Judged:
    case = tcp_case(0.5, 20.0)
    return case, with_line(case, 0.5 / 0.08, 60.0, 1 + OVER * tol.TCP), None


@spoiled("TCP acceleration", "TCP", 12)
def tcp_accelerates_too_hard() -> Judged:
    case = tcp_case(2.5, 4.8)
    return case, with_line(case, 5.0, 60.0, np.sqrt(1 + OVER * tol.TCP)), None


@spoiled("programmed speed", "TCP", 12)
def faster_than_programmed() -> Judged:
    case = rapid_case()
    return case, with_line(case, 0.5 / 0.08, 60.0, 1 + OVER * tol.TCP), None


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
    return case, case.rows(step=1e-3), None


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
