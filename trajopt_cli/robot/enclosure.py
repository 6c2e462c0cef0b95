"""Enclosures of the first three arm joints and their rates over intervals of the rail, for the lower bound.

In the canonical angles and lengths of robot.arm; joints are made of them at the end, in every turn their ranges hold.

Everything is evaluated as intervals (lo, hi) of doubles and widened by WIDEN, a thousand times the rounding of the few
operations involved; the arithmetic itself is not outward rounded, which is why the bound is not called certified.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, inverse_pose
from trajopt_cli.robot.arm import Arm
from trajopt_cli.robot.parallel_arm import ParallelArm

WIDEN = 1e-9  # rad: a thousand times the rounding of the few operations below
BIG = 1e9  # rad/m in place of infinity


@dataclass(frozen=True, eq=False)
class Range:
    """An interval per element: lo <= hi."""

    lo: Array
    hi: Array

    def __add__(self, other: Range) -> Range:
        return Range(self.lo + other.lo, self.hi + other.hi)

    def __sub__(self, other: Range) -> Range:
        return Range(self.lo - other.hi, self.hi - other.lo)

    def __mul__(self, other: Range) -> Range:
        a, b, c, d = self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi
        return Range(*(f(f(a, b), f(c, d)) for f in (np.minimum, np.maximum)))  # np.stack takes twice as long

    def scaled(self, k: float) -> Range:
        """Times a number."""
        return Range(np.minimum(k * self.lo, k * self.hi), np.maximum(k * self.lo, k * self.hi))

    def square(self) -> Range:
        """x^2."""
        a, b = self.lo**2, self.hi**2
        low = np.where((self.lo <= 0) & (self.hi >= 0), 0.0, np.minimum(a, b))
        return Range(low, np.maximum(a, b))

    def over(self, positive: Range) -> Range:
        """Divided by a range that is not negative; up to +-BIG where it touches zero."""
        low, high = np.maximum(positive.lo, 1 / BIG), np.maximum(positive.hi, 1 / BIG)
        return self * Range(1 / high, 1 / low)

    def magnitude(self) -> Array:
        """Largest |x|."""
        return np.maximum(np.abs(self.lo), np.abs(self.hi))


@dataclass(frozen=True, eq=False)
class Enclosure:
    """Per branch pair and rail interval (4, n): joints and their rates per rail metre as ranges (3, 4, n); alive. way:
    their rates on the tool's way, None for a pose that stands."""

    q: Range
    rate: Range
    alive: Array
    way: Range | None = None


def _hull(values: Array) -> Range:
    """Range over consecutive nodes, (..., n) from (..., n + 1)."""
    return Range(np.minimum(values[..., :-1], values[..., 1:]), np.maximum(values[..., :-1], values[..., 1:]))


def _anything(n: int, lower: Array, upper: Array, on_way: bool) -> Enclosure:
    """What is known of an arm without a closed form on n intervals: its joints' ranges."""
    low, high = (np.broadcast_to(end[:, None, None], (3, 4, n)) for end in (lower, upper))
    rate = Range(np.full((3, 4, n), -BIG), np.full((3, 4, n), BIG))
    return Enclosure(Range(low, high), rate, np.ones((4, n), dtype=bool), rate if on_way else None)


def enclose(
    arm: Arm, X_CF: Array, e: Array, nodes: Array, lower: Array, upper: Array, twist: Array | None = None
) -> Enclosure:
    """Enclosures between rail nodes (k + 1,), for shoulder and elbow signs (+,+), (+,-), (-,+), (-,-).

    X_CF (4, 4), e (3,): the flange with the rail at 0 and the rail's direction, zero without a rail, both seen from the
    arm's canonical base. lower, upper (3,): ranges of the joints. twist (6,): of the flange on its way, in that base's
    axes. A joint that may stand in its range in several turns has the hull of them all. Of an arm with three parallel
    axes joint 1 alone is enclosed, and whether axis 4 may be in reach; joints 2 and 3 hang on the wrist's side.
    """
    if not arm.closed_form:
        return _anything(len(nodes) - 1, lower, upper, twist is not None)
    X_CK = X_CF @ inverse_pose(arm.X_KF)
    centre = X_CK[:3, 3] - arm.c4 * X_CK[:3, 2]
    # wrist centre at the nodes, linear in between
    w = centre[:, None] - e[:, None] * nodes
    h = np.diff(nodes)
    wz = _hull(w[2])
    along = _hull(w[0] * e[0] + w[1] * e[1])
    r2 = Range(
        np.minimum(*(x for x in (w[0, :-1] ** 2 + w[1, :-1] ** 2, w[0, 1:] ** 2 + w[1, 1:] ** 2))),
        np.maximum(w[0, :-1] ** 2 + w[1, :-1] ** 2, w[0, 1:] ** 2 + w[1, 1:] ** 2),
    )
    flat = e[0] ** 2 + e[1] ** 2
    cross = w[0, 0] * e[1] - w[1, 0] * e[0]  # constant along the rail
    if flat > 0:
        r2 = Range(np.where((along.lo <= 0) & (along.hi >= 0), np.minimum(cross**2 / flat, r2.lo), r2.lo), r2.hi)
    on_axis, b2 = r2.lo < 1e-12, arm.b**2
    r = Range(np.sqrt(np.maximum(r2.lo - b2, 0)), np.sqrt(np.maximum(r2.hi - b2, 0)))
    z = Range(wz.lo - arm.c1, wz.hi - arm.c1)
    with np.errstate(invalid="ignore"):
        node_r = np.sqrt(w[0] ** 2 + w[1] ** 2 - b2)  # NaN where the wrist centre is too near to axis 1
    q_lo, q_hi = (np.empty((3, 4, len(h))) for _ in range(2))
    ways = [-e] if twist is None else [-e, twist[:3] + np.cross(twist[3:], centre - X_CF[:3, 3])]  # of the wrist centre
    rates = [(np.empty((3, 4, len(h))), np.empty((3, 4, len(h)))) for _ in ways]
    alive = np.zeros((4, len(h)), dtype=bool)
    slack = float(np.linalg.norm(arm.wrist))  # of axis 4 from the wrist centre; of a spherical wrist 0
    for i, (shoulder, elbow) in enumerate(((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))):
        u = Range(r.lo - arm.a1, r.hi - arm.a1) if shoulder > 0 else Range(-r.hi - arm.a1, -r.lo - arm.a1)
        rho2 = u.square() + z.square()
        reach2 = rho2
        if slack:
            reach2 = Range(np.maximum(np.sqrt(rho2.lo) - slack, 0.0) ** 2, (np.sqrt(rho2.hi) + slack) ** 2)
        s3 = Range(*((arm.c2**2 + arm.upper**2 - x) / (2 * arm.c2 * arm.upper) for x in (reach2.hi, reach2.lo)))
        alive[i] = (s3.lo <= 1 + WIDEN) & (s3.hi >= -1 - WIDEN) & (r2.hi >= b2 - WIDEN)
        s3 = Range(np.clip(s3.lo, -1, 1), np.clip(s3.hi, -1, 1))
        a3 = Range(np.arcsin(s3.lo) - arm.bend, np.arcsin(s3.hi) - arm.bend)
        q3 = a3 if elbow > 0 else Range(-np.pi - a3.hi - 2 * arm.bend, -np.pi - a3.lo - 2 * arm.bend)
        s3_2 = s3.square()
        c3 = Range(np.sqrt(np.maximum(1 - s3_2.hi, 0)), np.sqrt(np.maximum(1 - s3_2.lo, 0)))
        triangle = _Triangle(arm, w, r, r2, u, z, rho2, c3, shoulder, elbow)
        q_rates = [triangle.rates(way) for way in ways]
        turn = np.arctan2(shoulder * w[1], shoulder * w[0])
        q1 = _hull(turn)
        cut = (q1.hi - q1.lo > np.pi) | on_axis
        q1 = Range(np.where(cut, -np.pi, q1.lo), np.where(cut, np.pi, q1.hi))
        if arm.b:
            aside = np.stack([np.arctan2(arm.b, r.lo), np.arctan2(arm.b, r.hi)])
            q1 = q1 - Range(aside.min(axis=0), aside.max(axis=0)).scaled(shoulder)
            q1 = _tighter(q1, turn - shoulder * np.arctan2(arm.b, node_r), q_rates[0][0], h, ~cut)
        node2 = _second_joint_at(arm, shoulder * node_r - arm.a1, w[2] - arm.c1, elbow)
        q2 = _tighter(_second_joint(arm, u, z, rho2, elbow), node2, q_rates[0][1], h)
        if arm.coupled:
            q3, q_rates = q2 + q3, [(one, two, two + three) for one, two, three in q_rates]
        for j, value in enumerate((q1, q2, q3)):
            q_lo[j, i], q_hi[j, i] = value.lo - WIDEN, value.hi + WIDEN
            for (low, high), found in zip(rates, q_rates, strict=True):
                rate = found[j].scaled(float(arm.signs[j]))
                low[j, i], high[j, i] = rate.lo - WIDEN * (1 + np.abs(rate.lo)), rate.hi + WIDEN * (1 + np.abs(rate.hi))
    if isinstance(arm, ParallelArm):
        q_lo[1:], q_hi[1:] = lower[1:, None, None], upper[1:, None, None]
        for low, high in rates:
            low[1:], high[1:] = -BIG, BIG
    for j in range(1 if isinstance(arm, ParallelArm) else 3):
        q, there = _in_range(arm, j, Range(q_lo[j], q_hi[j]), float(lower[j]), float(upper[j]))
        q_lo[j], q_hi[j] = q.lo, q.hi
        alive &= there
    rail, way = [*(Range(*rate) for rate in rates), None][:2]
    assert rail is not None
    return Enclosure(Range(q_lo, q_hi), rail, alive, way)


def _tighter(x: Range, at_nodes: Array, rate: Range, h: Array, ok: BoolArray | bool = True) -> Range:
    """By its rate where that is tighter: within the hull of the nodes, widened where the joint may turn back. Not where
    it passes the cut of its angle from one node to the next."""
    hull = _hull(at_nodes)
    spread = np.where(rate.lo * rate.hi <= 0, h / 2 * rate.magnitude(), 0.0)
    ok = ok & ~np.isnan(hull.lo) & (spread < 1.0) & (hull.hi - hull.lo < np.pi)
    return Range(
        np.where(ok, np.maximum(x.lo, hull.lo - spread - WIDEN), x.lo),
        np.where(ok, np.minimum(x.hi, hull.hi + spread + WIDEN), x.hi),
    )


def _in_range(arm: Arm, j: int, t: Range, lower: float, upper: float) -> tuple[Range, BoolArray]:
    """Joint j where its canonical angle is t, of a coupled joint 3 that of joints 2 and 3 together: in all turns that
    its range holds; and where it holds any."""
    turn, offset = 2 * np.pi, float(arm.offsets[j] + arm.offsets[1] * (arm.coupled and j == 2))
    q = Range(t.lo - offset, t.hi - offset).scaled(float(arm.signs[j]))
    first, last = np.ceil((lower - q.hi.max()) / turn), np.floor((upper - q.lo.min()) / turn)
    shifts = turn * np.arange(first, last + 1).reshape(-1, *[1] * q.lo.ndim)
    low, high = np.maximum(q.lo + shifts, lower), np.minimum(q.hi + shifts, upper)
    holds = high >= low
    # a turn that only touches the range's end counts where no other does
    wide = holds & (high - low > 6 * WIDEN)
    holds = np.where(wide.any(axis=0), wide, holds)
    there = holds.any(axis=0)
    found = Range(
        np.where(there, np.where(holds, low, np.inf).min(axis=0, initial=np.inf), lower),
        np.where(there, np.where(holds, high, -np.inf).max(axis=0, initial=-np.inf), upper),
    )
    return found, np.asarray(there)


@dataclass(frozen=True, eq=False)
class _Triangle:
    """Shoulder, elbow and wrist centre between rail nodes: wrist centres w (3, k + 1) at the nodes, in the arm's plane
    its distances r from axis 1, u and z from axis 2; the squares r2 from axis 1, not only in that plane, and rho2 from
    axis 2; and |cos| of the elbow."""

    arm: Arm
    w: Array
    r: Range
    r2: Range
    u: Range
    z: Range
    rho2: Range
    c3: Range
    shoulder: float
    elbow: float

    def rates(self, way: Array) -> tuple[Range, Range, Range]:
        """Of the three canonical angles as the wrist centre goes along a vector (3,)."""
        arm, n = self.arm, self.w.shape[1] - 1

        def constant(value: float) -> Range:
            return Range(np.full(n, value), np.full(n, value))

        if not way.any():  # no rail
            return constant(0.0), constant(0.0), constant(0.0)
        q1_rate = _hull(self.w[0] * way[1] - self.w[1] * way[0]).over(self.r2)
        outward = _hull(self.w[0] * way[0] + self.w[1] * way[1])
        u_rate = outward.over(self.r).scaled(self.shoulder)
        if arm.b:
            q1_rate = q1_rate + u_rate.scaled(arm.b).over(self.r2)
        z_rate = constant(way[2])
        half_rate = self.u * u_rate + self.z * z_rate
        q3_rate = half_rate.scaled(-1 / (arm.c2 * arm.upper)).over(self.c3).scaled(self.elbow)
        phi_rate = (u_rate * self.z - self.u * z_rate).over(self.rho2)
        factor = constant(1.0) + constant(arm.upper**2 - arm.c2**2).over(self.rho2)
        psi_rate = (factor * half_rate).scaled(-1 / (2 * arm.c2 * arm.upper)).over(self.c3)
        return q1_rate, phi_rate - psi_rate.scaled(self.elbow), q3_rate


def _second_joint(arm: Arm, u: Range, z: Range, rho2: Range, elbow: float) -> Range:
    """q2 = phi - elbow psi: direction of the wrist seen from the shoulder, less the triangle's angle there."""
    corners = np.stack([np.arctan2(a, b) for a in (u.lo, u.hi) for b in (z.lo, z.hi)])
    wild = (z.lo <= 0) & (u.lo <= 0) & (u.hi >= 0)  # the cut of atan2(u, z), or the origin
    phi = Range(np.where(wild, -np.pi, corners.min(axis=0)), np.where(wild, np.pi, corners.max(axis=0)))
    c = arm.upper**2 - arm.c2**2
    rho = Range(np.sqrt(np.maximum(rho2.lo, 1e-12)), np.sqrt(np.maximum(rho2.hi, 1e-12)))
    cosine = [np.clip((x - c / x) / (2 * arm.c2), -1, 1) for x in (rho.lo, rho.hi)]  # increasing in rho for c >= 0
    psi = Range(np.arccos(cosine[1]), np.arccos(cosine[0]))
    if c < 0:
        turning = rho.lo < np.sqrt(-c)
        psi = Range(np.where(turning, 0.0, psi.lo), np.where(turning, np.pi, psi.hi))
    return phi - psi.scaled(elbow)


def _second_joint_at(arm: Arm, u: Array, z: Array, elbow: float) -> Array:
    """q2 at points; NaN out of reach."""
    s3 = (arm.c2**2 + arm.upper**2 - u**2 - z**2) / (2 * arm.c2 * arm.upper)
    with np.errstate(invalid="ignore"):
        c3 = elbow * np.sqrt(1 - s3**2)
    return np.asarray(np.arctan2(u, z) - np.arctan2(arm.upper * c3, arm.c2 - arm.upper * s3))
