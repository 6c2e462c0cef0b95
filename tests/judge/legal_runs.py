"""Small legal motions with corners and arcs, made from the segments of path and a trapezoid of speed over the way.

The way sigma [m] counts along the legs as if there were no corners; a corner begins and ends as far from its point as
its largest zone, so the speed is continuous.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise

import numpy as np
from legal_motion import (
    CONF,
    TOOL,
    V500,
    Case,
    Piece,
    _common,
    arm_at,
    down,
    joint_move,
    move_j,
    move_l,
    plant_with_rail,
    plant_without_rail,
    program,
    trapezoid,
)
from tcp_motion import inverse_velocity

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.motion import DEFAULT_SETTINGS, CirPathMode, Motion, MoveAbsJ, MoveC, Speed, Zone
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path.joint_move import JointMove
from trajopt_cli.path.line import Line
from trajopt_cli.problem.plant import Plant

Z0 = Zone("z0", False, 0.3e-3, 0.3e-3, 0.3e-3)
Z1 = Zone("z1", False, 1e-3, 1e-3, 1e-3)
Z10 = Zone("z10", False, 10e-3, 15e-3, 15e-3)
V100 = replace(V500, name="v100", v_tcp=0.1)
V200 = replace(V500, name="v200", v_tcp=0.2)

Leg = Line | Arc | JointMove
Rail = Callable[[Array], tuple[Array, Array]]


def move_c(line: int, target: str, via: Array, X: Array, rail: float | None = None, **more: object) -> MoveC:
    common = _common(line, target, V500, rail)
    return MoveC(**{**common, "tool": TOOL, **more}, X_WT=X, conf=CONF, X_WV=pose(X[:3, :3], via))


def move_abs(line: int, q: Array, rail: float | None = None, speed: Speed = V500, **more: object) -> MoveAbsJ:
    return MoveAbsJ(**{**_common(line, "j_at", speed, rail), **more}, q=q, tool=TOOL)


@dataclass(frozen=True)
class Part:
    """A stretch [begin, end] of the way: axes and their rates by the way."""

    begin: float
    end: float
    axes: Callable[[Array], tuple[Array, Array]]


def way_of(plant: Plant, leg: Leg) -> float:
    if not isinstance(leg, JointMove):
        return leg.length or leg.angle
    X_0, X_1 = plant.robot.forward(np.stack([leg.q_0, leg.q_1]))
    return float(np.linalg.norm(X_1[:3, 3] - X_0[:3, 3]))


def rounded_rail(values: Sequence[float], edges: Array, zones: Sequence[float]) -> Rail:
    """In proportion to every leg's way, a parabola over the zone of every point."""

    def rail(sigma: Array) -> tuple[Array, Array]:
        slopes = np.diff(values) / np.diff(edges)
        leg = np.clip(np.searchsorted(edges, sigma, side="right") - 1, 0, len(slopes) - 1)
        d, rate = np.asarray(values)[leg] + slopes[leg] * (sigma - edges[leg]), slopes[leg]
        for k, size in enumerate(zones, start=1):
            x = sigma - (edges[k] - size)
            inside = (x > 0) & (x < 2 * size)
            bend = (slopes[k] - slopes[k - 1]) / (2 * size) if size else 0.0
            d = np.where(inside, values[k] - slopes[k - 1] * size + slopes[k - 1] * x + bend * x * x / 2, d)
            rate = np.where(inside, slopes[k - 1] + bend * x, rate)
        return d, rate

    return rail


def parts_of(
    plant: Plant, legs: Sequence[Leg], sizes: Sequence[tuple[float, float]], rail: Rail | None = None,
    joint: bool = False,
) -> list[Part]:  # fmt: skip
    """The whole way with corners. sizes: radius and turning [m] of every corner, both 0 for none; [rad] between turns
    in place. joint: all of them are joint interpolated."""
    paths = [way_of(plant, leg) for leg in legs]
    edges = np.r_[0.0, np.cumsum(paths)]
    parts: list[Part] = []

    def at_poses(X: Array, twist: Array, sigma: Array) -> tuple[Array, Array]:
        d, rate = (None, None) if rail is None else rail(sigma)
        q = arm_at(plant, X, d)
        return q, inverse_velocity(plant.robot, q, twist, rate)

    def on_leg(i: int) -> Callable[[Array], tuple[Array, Array]]:
        leg = legs[i]

        def axes(sigma: Array) -> tuple[Array, Array]:
            s = np.clip((sigma - edges[i]) / paths[i], 0.0, 1.0)
            if isinstance(leg, JointMove):
                return leg.axes(s), leg.rate(s) / paths[i]
            return at_poses(leg.pose(s), leg.twist(s) / paths[i], sigma)

        return axes

    def in_corner(k: int, size: float) -> Callable[[Array], tuple[Array, Array]]:
        before, after = legs[k - 1], legs[k]
        begin = edges[k] - size
        if joint or isinstance(before, JointMove) or isinstance(after, JointMove):
            (q_0, rate_0), (q_1, rate_1) = (
                (x[0] for x in on_leg(i)(np.array([sigma]))) for i, sigma in ((k - 1, begin), (k, edges[k] + size))
            )
            bend = JointCorner(q_0, 2 * size * rate_0, q_1, 2 * size * rate_1)
            return lambda sigma: tuple(f((sigma - begin) / (2 * size)) / g for f, g in
                                       ((bend.axes, 1.0), (bend.rate, 2 * size)))  # fmt: skip
        if before.length == 0:
            corner = Corner(before, after, size / paths[k - 1], size / paths[k])
        else:
            corner = Corner.of_zone(before, after, *sizes[k - 1])

        def axes(sigma: Array) -> tuple[Array, Array]:
            s = np.clip((sigma - begin) / (2 * size), 0.0, 1.0)
            return at_poses(corner.pose(s), corner.twist(s) / (2 * size), sigma)

        return axes

    done = 0.0
    for i in range(len(legs)):
        size = max(sizes[i]) if i < len(sizes) else 0.0
        if edges[i + 1] - size > done + 1e-12:
            parts.append(Part(done, edges[i + 1] - size, on_leg(i)))
        if size:
            parts.append(Part(edges[i + 1] - size, edges[i + 1] + size, in_corner(i + 1, size)))
        done = edges[i + 1] + size
    return parts


def driven(parts: Sequence[Part], v: float, a: float, profile: object = None) -> Piece:
    """The whole way from rest to rest with a trapezoid of speed v [m/s], a [m/s2]."""
    length = parts[-1].end
    T, at, switches = profile or trapezoid(v / length, a / length)
    starts = np.array([part.begin for part in parts])
    crossed = times_at(at, T, starts[1:] / length)

    def q_at(t: Array) -> tuple[Array, Array]:
        s, rate = at(t)
        which = np.clip(np.searchsorted(starts, s * length, side="right") - 1, 0, len(parts) - 1)
        found = [parts[i].axes(s[which == i] * length) for i in np.unique(which)]
        q, dq = (np.concatenate(x) for x in zip(*found, strict=True))
        return np.unwrap(q, axis=0), dq * (rate * length)[:, None]

    return Piece(T, q_at, tuple(sorted({*switches, *crossed})))


def time_at(sigma: float, length: float, v: float = 0.15, a: float = 1.0) -> float:
    """When a driven way of this length has come so far [m]."""
    T, at, _ = trapezoid(v / length, a / length)
    return float(times_at(at, T, np.array([sigma / length]))[0])


def times_at(at: Callable[[Array], tuple[Array, Array]], T: float, fractions: Array) -> Array:
    """When a profile at of time T has come to these shares of its way, by halving."""
    low, high = np.zeros(len(fractions)), np.full(len(fractions), T)
    for _ in range(45):
        middle = (low + high) / 2
        before = at(middle)[0] < fractions
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return (low + high) / 2


# Half a metre before the robot; room for 100 mm of way each.
P0, P1, P2, P3 = (down(0.45, 0.0, 0.4), down(0.5, 0.0, 0.4), down(0.5, 0.06, 0.4), down(0.45, 0.06, 0.4))


def run_case(
    motions: Sequence[Motion],
    legs: Sequence[Leg],
    sizes: Sequence[tuple[float, float]],
    v: float = 0.15,
    a: float = 1.0,
    plant: Plant | None = None,
    rails: Sequence[float] | None = None,
    external: Sequence[float] = (),
    joint: bool = False,
) -> Case:
    """To the first leg's start by a joint move, then the run."""
    plant = plant or (plant_without_rail() if rails is None else plant_with_rail())
    first = legs[0]
    edges = np.r_[0.0, np.cumsum([way_of(plant, leg) for leg in legs])]
    rail = None if rails is None else rounded_rail(rails, edges, external)
    if isinstance(first, JointMove):
        q_0 = first.q_0
    else:
        q_0 = arm_at(plant, first.pose(np.zeros(1)), None if rail is None else rail(np.zeros(1))[0])[0]
    return Case(
        plant,
        program(move_j(11, "p_0", P0, None if rails is None else rails[0]), *motions),
        (joint_move(plant, plant.start, q_0, 0.5), driven(parts_of(plant, legs, sizes, rail, joint), v, a)),
    )


@cache
def line_line(zone: Zone = Z10, turn: float = 0.0, v: float = 0.15, speed: Speed = V500) -> Case:
    """A right angle."""
    legs = [Line(P0, turned(P1, turn)), Line(turned(P1, turn), turned(P2, -turn))]
    motions = [move_l(12, "p_1", legs[0].X_1, zone=zone, speed=speed), move_l(13, "p_2", legs[1].X_1, speed=speed)]
    return run_case(motions, legs, [(zone.radius, max(zone.path_ori, zone.radius))], v)


def turned(X: Array, angle: float) -> Array:
    return down(*X[:3, 3], angle)


@cache
def two_turns() -> Case:
    """A right angle; the tool turns about the vertical on the one line, about x on the other."""
    X_1 = turned(P1, 0.3)
    X_2 = pose(rotation_about([1, 0, 0], 0.3) @ X_1[:3, :3], P2[:3, 3])
    motions = [move_l(12, "p_1", X_1, zone=Z10), move_l(13, "p_2", X_2)]
    return run_case(motions, [Line(P0, X_1), Line(X_1, X_2)], [(Z10.radius, Z10.path_ori)])


@cache
def other_work_object(joint: bool = True) -> Case:
    """A right angle whose corner is joint interpolated, as the second line is programmed in another work object."""
    legs = [Line(P0, turned(P1, 0.3)), Line(turned(P1, 0.3), P2)]
    motions = [move_l(12, "p_1", legs[0].X_1, zone=Z10, X_WO=np.eye(4)), move_l(13, "p_2", P2, wobj="table", X_WO=P0)]
    return run_case(motions, legs, [(Z10.radius, Z10.radius)], joint=joint)


@cache
def turns_in_place(angle: float = 0.12) -> Case:
    """Two turns about different axes, one going over into the other over angle [rad] on both sides of the point."""
    X_1 = turned(P0, 0.4)
    X_2 = pose(rotation_about([1, 0, 0], 0.3) @ X_1[:3, :3], P0[:3, 3])
    motions = [move_l(12, "p_1", X_1, zone=replace(Z10, ori=0.12)), move_l(13, "p_2", X_2)]
    return run_case(motions, [Line(P0, X_1), Line(X_1, X_2)], [(angle, angle)], v=0.5, a=3.0)


VIA = np.array([0.53, 0.03, 0.4])


@cache
def line_arc(zone: Zone = Z10) -> Case:
    """Along y into half a circle that bulges to x, and a line back."""
    X_1, X_2, X_3 = P1, turned(P2, 0.3), turned(P3, 0.1)
    legs = [Line(P0, X_1), Arc.through(X_1, VIA, X_2), Line(X_2, X_3)]
    motions = [
        move_l(12, "p_1", X_1, zone=zone),
        move_c(13, "p_2", VIA, X_2, zone=zone),
        move_l(14, "p_3", X_3),
    ]
    size = (zone.radius, max(zone.path_ori, zone.radius))
    return run_case(motions, legs, [size, size])


@cache
def leaning(mode: CirPathMode, driven_as: CirPathMode | None = None) -> Case:
    """As line_arc, with a torch that leans by 0.3 rad to the middle of the circle and turns by 0.4 rad about its own
    axis on the way; at the circle point it leans twice as far. driven_as: with the arc of another mode."""
    mode_driven = driven_as or mode

    def at(angle: float, lean: float, turn: float, p: Array) -> Array:
        R = rotation_about([0, 0, 1], angle) @ rotation_about([1, 0, 0], lean) @ P0[:3, :3]
        return pose(R @ rotation_about([0, 0, 1], turn), p)

    X_1, X_V, X_2, X_3 = (
        at(*numbers, p)
        for *numbers, p in (
            (0.0, 0.3, 0.0, P1[:3, 3]),
            (np.pi / 2, 0.6, 0.2, VIA),
            (np.pi, 0.3, 0.4, P2[:3, 3]),
            (np.pi, 0.3, 0.4, P3[:3, 3]),
        )
    )
    legs = [Line(P0, X_1), Arc.through(X_1, X_V, X_2, mode_driven), Line(X_2, X_3)]
    settings = replace(DEFAULT_SETTINGS, circle=mode)
    motions = [
        move_l(12, "p_1", X_1, zone=Z10, settings=settings),
        replace(move_c(13, "p_2", VIA, X_2, zone=Z10, settings=settings), X_WV=X_V),
        move_l(14, "p_3", X_3, settings=settings),
    ]
    return run_case(motions, legs, [(Z10.radius, Z10.path_ori)] * 2, v=0.05)


@cache
def full_circle(zone: Zone = Z10) -> Case:
    """Two arcs, round once."""
    back = 2 * np.array([0.5, 0.03, 0.4]) - VIA
    legs = [Line(P0, P1), Arc.through(P1, VIA, P2), Arc.through(P2, back, P1)]
    motions = [move_l(12, "p_1", P1), move_c(13, "p_2", VIA, P2, zone=zone), move_c(14, "p_1", back, P1)]
    first = run_case(motions[:1], legs[:1], [])
    second = driven(parts_of(first.plant, legs[1:], [(zone.radius, max(zone.path_ori, zone.radius))]), 0.15, 1.0)
    return replace(first, program=program(*first.program.motions, *motions[1:]), pieces=(*first.pieces, second))


@cache
def arc_alone(turn: float = 0.5) -> Case:
    """From stop to stop."""
    X_2 = turned(P2, turn)
    case = run_case([move_l(12, "p_1", P1)], [Line(P0, P1)], [])
    arc = driven(parts_of(case.plant, [Arc.through(P1, VIA, X_2)], []), 0.15, 1.0)
    motions = [*case.program.motions, move_c(13, "p_2", VIA, X_2)]
    return replace(case, program=program(*motions), pieces=(*case.pieces, arc))


@cache
def joint_line(zone: Zone = Z10, plant: Plant | None = None) -> Case:
    """A joint move, a line, a joint move, all in one run."""
    plant = plant or plant_without_rail()
    q = [arm_at(plant, X[None], None)[0] for X in (P0, P1, P2, P3)]
    legs = [JointMove(q[0], q[1]), Line(P1, P2), JointMove(q[2], q[3])]
    motions = [move_j(12, "p_1", P1, zone=zone), move_l(13, "p_2", P2, zone=zone), move_j(14, "p_3", P3)]
    return run_case(motions, legs, [(zone.radius, zone.radius)] * 2, plant=plant)


@cache
def joint_joint(zone: Zone = Z10) -> Case:
    """Three joint moves; the second ends at joints."""
    plant = plant_without_rail()
    q = [arm_at(plant, X[None], None)[0] for X in (P0, P1, P2, P3)]
    legs = [JointMove(a, b) for a, b in pairwise(q)]
    motions = [move_j(12, "p_1", P1, zone=zone), move_abs(13, q[2], zone=zone), move_j(14, "p_3", P3)]
    return run_case(motions, legs, [(zone.radius, zone.radius)] * 2, plant=plant)


RAILS = (0.05, 0.09, 0.08, 0.1)


@cache
def with_rail(zone: Zone = Z10) -> Case:
    """Line, arc, line with a rail in proportion to each and rounded over its own zone."""
    X_2 = turned(P2, 0.3)
    legs = [Line(P0, P1), Arc.through(P1, VIA, X_2), Line(X_2, P3)]
    motions = [
        move_l(12, "p_1", P1, RAILS[1], zone=zone),
        move_c(13, "p_2", VIA, X_2, RAILS[2], zone=zone),
        move_l(14, "p_3", P3, RAILS[3]),
    ]
    size = (zone.radius, max(zone.path_ori, zone.radius))
    return run_case(motions, legs, [size, size], rails=RAILS, external=[max(zone.path_eax, zone.radius)] * 2)


@cache
def stopped_on_points() -> Case:
    """A plan of stops for a program with zones: every point met exactly, at rest."""
    case = line_line(turn=0.2)
    legs = [Line(P0, turned(P1, 0.2)), Line(turned(P1, 0.2), turned(P2, -0.2))]
    pieces = [driven(parts_of(case.plant, [leg], []), 0.15, 1.0) for leg in legs]
    return replace(case, pieces=(case.pieces[0], *pieces))


@cache
def contour(n: int = 38, zone: Zone = Z1, v: float = 0.05) -> Case:
    """Chords of 2 mm along a screw of 1.2 mm pitch: every turn comes near all the points of the one before."""
    phi = 0.2 * np.arange(n + 1)
    X = [P0, *(down(0.44 + 0.01 * np.cos(x), 0.01 * np.sin(x), 0.4 - 4e-5 * k) for k, x in enumerate(phi) if k)]
    legs = [Line(a, b) for a, b in pairwise(X)]
    motions = [move_l(12 + k, f"p_{k + 1}", b, zone=zone, speed=V100) for k, b in enumerate(X[1:-1])]
    motions.append(move_l(12 + n, "p_end", X[-1], speed=V100))
    sizes = [(min(zone.radius, a.length / 2, b.length / 2),) * 2 for a, b in pairwise(legs)]
    return run_case(motions, legs, sizes, v, 0.5)


RUNS = {
    "line-line": line_line,
    "other work object": other_work_object,
    "turns in place": turns_in_place,
    "line-line z0": lambda: line_line(Z0, v=0.03),
    "turning": lambda: line_line(turn=0.3),
    "two turns": two_turns,
    "line-arc": line_arc,
    "full circle": full_circle,
    "leaning": lambda: leaning(CirPathMode.PATH_FRAME),
    "through the circle point's orientation": lambda: leaning(CirPathMode.CIR_POINT_ORI),
    "arc": arc_alone,
    "joint-line": joint_line,
    "joint-joint": joint_joint,
    "rail": with_rail,
    "stopped": stopped_on_points,
    "contour": contour,
}
