"""Motions spoiled in corners and on arcs, and fly-bys taken for stops the wrong way round."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from legal_motion import Case, Piece, arm_at, down, move_l, nudged, program, trapezoid, wait
from legal_runs import (
    P0,
    P1,
    P2,
    P3,
    RAILS,
    V100,
    V200,
    VIA,
    Z10,
    Leg,
    arc_alone,
    driven,
    joint_joint,
    joint_line,
    line_line,
    parts_of,
    rounded_rail,
    run_case,
    time_at,
    turned,
    two_turns,
    with_rail,
)
from spoil_book import OVER, Judged, spoiled
from tcp_motion import inverse_velocity

from trajopt_cli.geometry import Array
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.joint_move import JointMove
from trajopt_cli.path.line import Line
from trajopt_cli.problem.plan import Target

R, TURN = Z10.radius, Z10.path_ori


def ran(case: Case, legs: Sequence[Leg], sizes: Sequence[tuple[float, float]], v: float = 0.15, **more: object) -> Case:
    """The case with another last piece."""
    piece = driven(parts_of(case.plant, legs, sizes, **more), v, 1.0)
    return replace(case, pieces=(*case.pieces[:-1], piece))


def bumped(case: Case, t_0: float, t_1: float, twist: Sequence[float], high: float, axis: int | None = None) -> Case:
    """The TCP displaced by high * twist [m, rad], or one axis, between two times of the last piece, smoothly."""
    piece, T = case.pieces[-1], t_1 - t_0

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(t)
        u = np.clip((t - t_0) / T, 0, 1)
        bump, rate = high * np.sin(np.pi * u) ** 2, high * np.pi / T * np.sin(2 * np.pi * u)
        unit = np.tile(np.eye(q.shape[1])[axis or 0], (len(t), 1))
        if axis is None:
            unit = inverse_velocity(case.plant.robot, q, np.tile(np.asarray(twist, dtype=float), (len(t), 1)), None)
        return q + unit * bump[:, None], qd + unit * rate[:, None]

    fresh = [t for t in (t_0, t_1) if min(abs(t - old) for old in piece.switches) > 1e-5]
    new = Piece(piece.T, at, tuple(sorted([*piece.switches, *fresh])))
    return replace(case, pieces=(*case.pieces[:-1], new))


def moved(X: Array, *way: float) -> Array:
    out = np.array(X)
    out[:3, 3] += way
    return out


@spoiled("line position", "TCP", 12)
def corner_cut_too_early() -> Judged:
    """A zone 0.25 mm larger: where it enters the right one, it is 1.5 um off the line."""
    case = ran(line_line(), [Line(P0, P1), Line(P1, P2)], [(R + 0.25e-3, TURN)])
    return case, case.rows(), None


LONG = 0.11  # the way of line_line


@spoiled("corner position", "TCP", 12)
def corner_that_bulges() -> Judged:
    """To the outside over the first half of the corner, where the parabola is hardly inside."""
    t_0, t_1 = time_at(0.05 - R, LONG), time_at(0.05 - R / 2, LONG)
    case = bumped(line_line(), t_0, t_1, [0, -1.0, 0, 0, 0, 0], 0.15e-3)
    return case, case.rows(), None


@spoiled("corner position", "TCP", 12)
def corner_out_of_its_plane() -> Judged:
    t_0, t_1 = time_at(0.05 - R, LONG), time_at(0.05 + R, LONG)
    case = bumped(line_line(), t_0, t_1, [0, 0, 1.0, 0, 0, 0], OVER * tol.LINE_POSITION)
    return case, case.rows(), None


@spoiled("line position", "TCP")
def corner_beyond_its_sphere() -> Judged:
    """Straight on through the point and 12 mm beyond it, then back to the other line."""
    X, Y = moved(P1, 0.012, 0, 0), moved(P1, 0, 0.012, 0)
    case = ran(line_line(), [Line(P0, X), Line(X, Y), Line(Y, P2)], [(1e-3, 1e-3)] * 2, 0.03)
    return case, case.rows(), None


def arc_driven_as(legs: Sequence[Leg], v: float = 0.15) -> Judged:
    case = ran(arc_alone(0.0), legs, [(2e-3, 2e-3)] * (len(legs) - 1), v)
    return case, case.rows(), None


@spoiled("arc position", "TCP", 13)
def arc_flattened_to_its_chord() -> Judged:
    return arc_driven_as([Line(P1, P2)])


@spoiled("arc position", "TCP", 13)
def arc_bulged() -> Judged:
    case = arc_alone(0.0)
    case = case.swap(p2=nudged(case.plant, case.pieces[2], [1.0, 0, 0, 0, 0, 0], OVER * tol.LINE_POSITION))
    return case, case.rows(), None


@spoiled("arc position", "TCP", 13)
def arc_the_wrong_way_round() -> Judged:
    back = 2 * np.array([0.5, 0.03, 0.4]) - VIA
    return arc_driven_as([Arc.through(P1, back, P2)])


@spoiled("arc position", "TCP", 13)
def arc_that_misses_the_point_on_the_way() -> Judged:
    return arc_driven_as([Arc.through(P1, VIA + np.array([3 * tol.LINE_POSITION, 0, 0]), P2)])


@spoiled("arc rotation", "TCP", 13)
def arc_whose_orientation_lags() -> Judged:
    case = arc_alone()
    case = case.swap(p2=nudged(case.plant, case.pieces[2], [0, 0, 0, 0, 0, -1.0], OVER * tol.LINE_ROTATION))
    return case, case.rows(), None


@spoiled("arc progress", "TCP", 13)
def backwards_on_the_arc() -> Judged:
    """Half way, back by the offence, and on."""
    case, arc = arc_alone(), Arc.through(P1, VIA, turned(P2, 0.5))
    parts, back = parts_of(case.plant, [arc], []), OVER * tol.BACKWARD / arc.length
    T, half, _ = trapezoid(1.5, 10.0)
    pause = 0.05

    def at(t: Array) -> tuple[Array, Array]:
        (s_1, v_1), (s_2, v_2) = half(np.clip(t, 0, T)), half(np.clip(t - T - pause, 0, T))
        u = np.clip((t - T) / pause, 0, 1)
        s = 0.5 * s_1 - back * u**3 * (10 - 15 * u + 6 * u * u) + (0.5 + back) * s_2
        return s, 0.5 * v_1 - back * 30 * (u * (1 - u)) ** 2 / pause + (0.5 + back) * v_2

    piece = driven(parts, 0, 0, (2 * T + pause, at, (T, T + pause)))
    case = case.swap(p2=piece)
    return case, case.rows(), None


def by_way_of(*legs: Line) -> Judged:
    """line_line driven by other ways, stopping at the end of each, then through its corner."""
    case = line_line()
    last = [Line(legs[-1].X_1, P1), Line(P1, P2)]
    pieces = [driven(parts_of(case.plant, [leg], []), 0.15, 1.0) for leg in legs]
    pieces.append(driven(parts_of(case.plant, last, [(R, R)]), 0.1, 1.0))
    case = replace(case, pieces=(case.pieces[0], *pieces))
    return case, case.rows(), None


@spoiled("line position", "TCP", 13)
def fly_by_passed_backwards() -> Judged:
    """Into the zone, out of it on the way it came, and only then through the corner."""
    X, Y = moved(P1, -0.004, 0, 0), moved(P1, -0.02, 0, 0)
    return by_way_of(Line(P0, X), Line(X, Y))


@spoiled("line progress", "TCP", 12)
def backwards_before_the_zone() -> Judged:
    X, Y = moved(P1, -0.015, 0, 0), moved(P1, -0.015 - 0.005, 0, 0)
    return by_way_of(Line(P0, X), Line(X, Y))


def joint_course(*order: Array) -> Judged:
    """Joint moves with corners of z10 from P0 to P3, programmed by P1 and P2."""
    case = joint_joint()
    q = [arm_at(case.plant, X[None], None)[0] for X in (P0, *order, P3)]
    legs = [JointMove(a, b) for a, b in pairwise(q)]
    case = ran(case, legs, [(R, R)] * len(order))
    return case, case.rows(), None


@spoiled("fly-by passed", "TCP")
def fly_bys_swapped() -> Judged:
    return joint_course(P2, P1)


@spoiled("fly-by passed", "TCP", 13)
def fly_by_skipped() -> Judged:
    return joint_course(P1)


@spoiled("fly-by passed", "TCP", 12)
def fly_by_missed() -> Judged:
    """A free way round the outside; it comes no nearer than 11 mm."""
    return joint_course(moved(P1, 1.6 * R, -1.6 * R, 0.0), P2)


@spoiled("line position", "TCP", 13)
def line_off_its_way_behind_the_zone() -> Judged:
    t_0, t_1 = time_at(0.05 + 1.1 * R, LONG), time_at(0.105, LONG)
    case = bumped(line_line(), t_0, t_1, [1.0, 0, 0, 0, 0, 0], 2e-3)
    return case, case.rows(), None


@spoiled("line rotation", "TCP", 13)
def turned_behind_the_zone() -> Judged:
    t_0, t_1 = time_at(0.05 + 1.1 * TURN, LONG), time_at(0.105, LONG)
    case = bumped(line_line(turn=0.3), t_0, t_1, [0, 0, 0, 0, 0, 1.0], OVER * tol.LINE_ROTATION)
    return case, case.rows(), None


@spoiled("corner rotation", "TCP", 12)
def turned_in_the_corner() -> Judged:
    """About an axis that neither way turns about."""
    t_0, t_1 = time_at(0.05 - TURN, LONG), time_at(0.05 + TURN, LONG)
    case = bumped(line_line(turn=0.3), t_0, t_1, [0, 0, 0, 1.0, 0, 0], 2e-3)
    return case, case.rows(), None


@spoiled("programmed speed", "TCP", 12)
def too_fast_in_the_corner() -> Judged:
    """Both moves at v200; only within the zone faster."""
    case = line_line(v=0.19, speed=V200)
    return faster_between(case, *(time_at(0.05 + x, LONG, 0.19) for x in (-0.8 * R, 0.8 * R)), 1.6)


@spoiled("corner rotation", "TCP", 12)
def turned_between_two_axes() -> Judged:
    """About the third axis, by twice what two turns that go over into each other may leave their triangle by."""
    t_0, t_1 = time_at(0.05 - TURN, LONG), time_at(0.05 + TURN, LONG)
    case = bumped(two_turns(), t_0, t_1, [0, 0, 0, 0, 1.0, 0], 2 * (0.3 * TURN / 0.05) * (0.3 * TURN / 0.06) / 16)
    return case, case.rows(), None


def faster_between(case: Case, t_0: float, t_1: float, factor: float) -> Judged:
    """The last piece's clock runs faster between two times, smoothly."""
    piece, T = case.pieces[-1], t_1 - t_0
    gain = (factor - 1) * T / 2  # the clock's lead behind it

    def at(t: Array) -> tuple[Array, Array]:
        u = np.clip((t - t_0) / T, 0, 1)
        lead = gain * (u - np.sin(2 * np.pi * u) / (2 * np.pi))
        rate = 1 + gain / T * (1 - np.cos(2 * np.pi * u)) * (u < 1) * (u > 0)
        q, qd = piece.at(np.minimum(t + lead, piece.T))
        return q, qd * rate[:, None]

    clock = Piece(piece.T - gain, at, tuple(s for s in (t_0, t_1, *(s - gain for s in piece.switches if s > t_1))))
    case = replace(case, pieces=(*case.pieces[:-1], clock))
    return case, case.rows(), None


@spoiled("programmed speed", "TCP", 13)
def too_fast_behind_the_corner() -> Judged:
    """The next line is programmed at v100."""
    case = line_line()
    motions = [*case.program.motions[:2], replace(case.program.motions[2], speed=V100)]
    case = replace(case, program=program(*motions))
    return case, case.rows(), None


@spoiled("stop rest", "TCP", 12)
def stop_driven_as_a_fly_by() -> Judged:
    """Straight through a stop."""
    middle = down(0.475, 0, 0.4)
    case = run_case([move_l(12, "p_1", middle), move_l(13, "p_2", P1)], [Line(P0, middle), Line(middle, P1)], [(0, 0)])
    return case, case.rows(), None


@spoiled("stop rest", "TCP", 12)
def wait_at_a_fly_by_not_stopped_for() -> Judged:
    middle = down(0.475, 0, 0.4)
    motions = [move_l(12, "p_1", middle, zone=Z10), wait(13, 0.0, "di_go"), move_l(14, "p_2", P1)]
    case = run_case(motions, [Line(P0, middle), Line(middle, P1)], [(0, 0)])
    return case, case.rows(), None


@spoiled("rail along arc", "rail", 13)
def rail_out_of_proportion_on_an_arc() -> Judged:
    """On the arc the rail sways by the offence, in the middle of its way."""
    legs = [Line(P0, P1), Arc.through(P1, VIA, turned(P2, 0.3)), Line(turned(P2, 0.3), P3)]
    edges = np.r_[0.0, np.cumsum([leg.length for leg in legs])]
    straight = rounded_rail(RAILS, edges, [TURN] * 2)
    a, b = edges[1] + 0.02, edges[2] - 0.02

    def rail(sigma: Array) -> tuple[Array, Array]:
        d, rate = straight(sigma)
        u = np.clip((sigma - a) / (b - a), 0, 1)
        high = OVER * tol.JOINT_TARGET
        return d + high * np.sin(np.pi * u) ** 2, rate + high * np.pi / (b - a) * np.sin(2 * np.pi * u)

    case = ran(with_rail(), legs, [(R, TURN)] * 2, rail=rail)
    return case, case.rows(), Target.RAPID


@spoiled("joint line", "joint_3", 13)
def joint_move_bent_outside_its_zones() -> Judged:
    case = joint_joint()
    t_0, t_1 = (time_at(0.05 + x, 0.16) for x in (1.2 * R, 0.06 - 1.2 * R))
    case = bumped(case, t_0, t_1, (), 2 * OVER * tol.JOINT_TARGET, axis=2)
    return case, case.rows(), Target.RAPID


LINE_BETWEEN = 0.16  # the way of joint_line


@spoiled("line position", "TCP", 13)
def line_joined_beyond_the_zone() -> Judged:
    """A joint move comes to its line 0.25 mm beyond the zone, and the next one leaves it as much too early."""
    q = [arm_at(joint_line().plant, X[None], None)[0] for X in (P0, P1, P2, P3)]
    legs = [JointMove(q[0], q[1]), Line(P1, P2), JointMove(q[2], q[3])]
    case = ran(joint_line(), legs, [(R + 0.25e-3, R + 0.25e-3)] * 2)
    return case, case.rows(), None


@spoiled("line rotation", "TCP", 13)
def turned_on_the_line_beside_a_joint_move() -> Judged:
    t_0, t_1 = (time_at(0.05 + x * R, LINE_BETWEEN) for x in (1.05, 2.5))
    case = bumped(joint_line(), t_0, t_1, [0, 0, 0, 0, 0, 1.0], 2 * OVER * tol.LINE_ROTATION)
    return case, case.rows(), None


@spoiled("programmed speed", "TCP", 12)
def too_fast_in_the_corner_beside_a_joint_move() -> Judged:
    """The run at v200; only within the zone faster."""
    case = joint_line()
    first, *motions = case.program.motions
    slow = [replace(motion, speed=V200) for motion in motions]  # type: ignore[call-arg]
    case = replace(case, program=program(first, *slow))
    return faster_between(case, *(time_at(0.05 + x, LINE_BETWEEN) for x in (-0.8 * R, 0.8 * R)), 2.0)


@spoiled("rail along line", "rail", 14)
def rail_sways_on_a_line_behind_a_corner() -> Judged:
    """A stream may do that; a RAPID controller leads the rail in proportion."""
    case = with_swaying_rail(OVER * tol.JOINT_TARGET)
    return case, case.rows(), Target.RAPID


def with_swaying_rail(high: float) -> Case:
    """Line, arc and line with corners, the rail off its share on the last line by so much [m], in the middle of it."""
    legs = [Line(P0, P1), Arc.through(P1, VIA, turned(P2, 0.3)), Line(turned(P2, 0.3), P3)]
    edges = np.r_[0.0, np.cumsum([leg.length for leg in legs])]
    straight, a, b = rounded_rail(RAILS, edges, [TURN] * 2), edges[2] + 1.1 * TURN, edges[3]

    def rail(sigma: Array) -> tuple[Array, Array]:
        d, rate = straight(sigma)
        u = np.clip((sigma - a) / (b - a), 0, 1)
        return d + high * np.sin(np.pi * u) ** 2, rate + high * np.pi / (b - a) * np.sin(2 * np.pi * u)

    return ran(with_rail(), legs, [(R, TURN)] * 2, rail=rail)
