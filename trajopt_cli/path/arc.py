r"""Arcs (MoveC): the tool centre point on a circle at a constant rate, and how the tool turns meanwhile.

RAPID reference manual, MoveC and CirPathMode: by default (\PathFrame) the tool is reoriented at a constant rate
relative to the circular path, and of the circle point's orientation only the direction of the turn is taken.
\ObjectFrame: at a constant rate against the work object, as on a line. \CirPointOri: through the orientation of the
circle point; how it turns on the way there and on from there is not published. Here that is the quadratic through all
three orientations, which is even where they allow it.

With E(s) the rotation about the circle's normal by spin s:

    R(s) = E(s) R_0 exp(f(s) w_1) exp(g(s) w_2)

PathFrame: spin is the sweep, f = s, w_2 = 0. ObjectFrame: spin 0, f = s, w_2 = 0. CirPointOri with the circle point at
s = c: spin 0, f = s (1 + c - s) / c, g = s (s - c) / (1 - c).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, axis_angle, rotation_about
from trajopt_cli.motion import CirPathMode
from trajopt_cli.path.circle import Point, circle_through
from trajopt_cli.path.segment import Segment
from trajopt_cli.path.symbols import Flange, Layout, Symbols, flange_at_start, rotated

if TYPE_CHECKING:
    import casadi as ca

_HALF_TURN = 1e-3  # rad: a turn this near to half a turn is as long to either side
_NO_SIDE = 0.02  # rad: circle points that differ less in how near they are to both say nothing
_STILL = 1e-9  # rad: no turn
_SAME = 1e-12  # rad: turns so close to one axis have it
_GAUSS = 32  # points for the sum of an uneven turn
_LEAST_PASSED = 0.25  # CirPointOri wants its circle point between this and 1 - this (manual: CirPathMode)
_DENSE = 257  # places where its highest rate is looked for
_X = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True, eq=False)
class Arc(Segment):
    """From tool pose X_0 to X_1 (4, 4) about a centre (3,) [m] and unit normal (3,), by sweep [rad] in (0, 2 pi).

    spin [rad]: how far the frame in which the tool turns goes about the normal. turns: rotation vectors (3,) [rad] in
    the tool's own frame, to X_1, or to the circle point and from there to X_1; None for the shorter turn without a
    spin. passed: s at which the circle point lies. decided: False where the tool turns by half a
    turn relative to the path and the circle point's orientation does not say to which side.
    """

    X_0: Array
    X_1: Array
    centre: Array
    normal: Array
    sweep: float
    spin: float = 0.0
    turns: tuple[Array, ...] | None = None
    passed: float = 0.5
    decided: bool = True

    @classmethod
    def through(cls, X_0: Array, via: Array, X_1: Array, mode: CirPathMode = CirPathMode.OBJECT_FRAME) -> Arc:
        """The arc from X_0 through the circle point via, a pose (4, 4), to X_1. mode: in OBJECT_FRAME its place (3,) is
        enough; those that move the wrist alone, which no plan takes, turn as that.

        Raises:
            InputError: the three points lie on one line, or two of them in one place.
        """
        point = via if via.ndim == 1 else via[:3, 3]
        points = X_0[:3, 3], point, X_1[:3, 3]
        found = circle_through(*(_point(p) for p in points))
        if found is None:
            places = ", ".join("[" + ", ".join(f"{x * 1e3:.3f}" for x in p) + "]" for p in points)
            raise InputError(
                f"no circle leads through three points on one line: start, point on the way and end {places} mm;"
                " move the point on the way, or use MoveL"
            )
        arc = cls(X_0, X_1, np.array(found.centre), np.array(found.axis), found.angle)
        if mode not in (CirPathMode.PATH_FRAME, CirPathMode.CIR_POINT_ORI):
            return arc
        passed, spin, decided = arc.s_at(point), 0.0, True
        R_0, R_V, R_1 = X_0[:3, :3], via[:3, :3], X_1[:3, :3]
        if mode is CirPathMode.CIR_POINT_ORI:
            turns: tuple[Array, ...] = (_turn(R_0, R_V), _turn(R_V, R_1))
        else:
            spin = arc.sweep
            R_V, R_1 = (rotation_about(arc.normal, -spin * s) @ R for s, R in ((passed, R_V), (1.0, R_1)))
            turn, decided = _turn_by(R_0, R_V, R_1, passed)
            along = R_0.T @ arc.normal
            if (
                np.linalg.norm(np.cross(turn, along)) < _SAME
            ):  # both about the normal, as where the tool stands: one turn
                turn, spin = (round(float(turn @ along) + spin, 12) + 0.0) * along, 0.0
            turns = (turn,)
        return replace(arc, spin=spin, turns=turns, passed=passed, decided=decided)

    def s_at(self, p: Array) -> float:
        """Where a point p (3,) of the circle lies."""
        out = p - self.centre
        return float(np.arctan2(out @ self._side, out @ self._first) % (2 * np.pi)) / self.sweep

    @cached_property
    def _turns(self) -> tuple[Array, ...]:
        return (_turn(self.X_0[:3, :3], self.X_1[:3, :3]),) if self.turns is None else self.turns

    @cached_property
    def _first(self) -> Array:
        """From the centre to the start (3,)."""
        return np.asarray(self.X_0[:3, 3] - self.centre)

    @cached_property
    def _side(self) -> Array:
        """From the centre to the point a quarter turn on (3,)."""
        return np.cross(self.normal, self._first)

    @property
    def radius(self) -> float:
        """Of the circle [m]."""
        return float(np.linalg.norm(self._first))

    @property
    def length(self) -> float:
        """Along the arc [m]."""
        return self.radius * self.sweep

    @property
    def evenly_turned(self) -> bool:
        """Whether the tool turns at a constant rate: by all modes but through the circle point's orientation."""
        return len(self._turns) == 1

    @cached_property
    def angle(self) -> float:
        """Reorientation [rad], what the path's own frame turns included."""
        if self.evenly_turned:
            return float(np.linalg.norm(self._turn_rates(np.zeros(1))[0]))
        x, weight = np.polynomial.legendre.leggauss(_GAUSS)
        return float(weight @ np.linalg.norm(self._turn_rates((1 + x) / 2)[0], axis=1)) / 2

    @cached_property
    def fastest_turn(self) -> float:
        """The highest rate of turning by s [rad]."""
        rates = self._turn_rates(np.linspace(0.0, 1.0, 1 if self.evenly_turned else _DENSE))[0]
        return float(np.linalg.norm(rates, axis=1).max())

    @cached_property
    def numbers(self) -> Array:
        """Its ends and all that makes it, in a row."""
        own = self.centre, self.normal, [self.sweep, self.spin, self.passed], *self._turns
        return np.concatenate([super().numbers, *own])

    @property
    def unclear(self) -> tuple[str, str] | None:
        """What is wrong with the orientation of the circle point."""
        if not self.decided:
            return (
                "turns the tool by half a turn relative to the circle, and its circle point does not say to which side",
                "give the circle point an orientation between those of both ends",
            )
        if not self.evenly_turned and not _LEAST_PASSED <= self.passed <= 1 - _LEAST_PASSED:
            return (
                f"has its circle point at {self.passed:.0%} of the arc under CirPathMode \\CirPointOri, which takes"
                f" {_LEAST_PASSED:.0%} to {1 - _LEAST_PASSED:.0%}",
                "move the circle point to the middle",
            )
        return None

    def pose(self, s: Array) -> Array:
        """Tool poses (n, 4, 4) at s (n,)."""
        X = np.zeros((len(s), 4, 4))
        X[:, :3, :3] = self._frames(s) @ self._turned(s)
        X[:, :3, 3] = self.centre + self._on_circle(s)
        X[:, 3, 3] = 1.0
        return X

    def twist(self, s: Array) -> Array:
        """First derivative (n, 6): along the tangent, and the rate of turning."""
        phi = (self.sweep * s)[:, None]
        along = self.sweep * (np.cos(phi) * self._side - np.sin(phi) * self._first)
        return np.hstack([along, self._turn_rates(s)[0]])

    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6): towards the centre, and how the rate of turning changes."""
        return np.hstack([-(self.sweep**2) * self._on_circle(s), self._turn_rates(s)[1]])

    @property
    def even_turns(self) -> tuple[Array, Array] | None:
        """Its spin in the poses' frame, and its turn in the tool's own."""
        return (self.spin * self.normal, self._turns[0]) if self.evenly_turned else None

    def between(self, s_0: float, s_1: float) -> Arc:
        """The part of it from s_0 to s_1, an arc; where the tool turns at a constant rate."""
        if not self.evenly_turned:
            raise NotImplementedError("the part of an arc that turns unevenly is no such arc")
        part = s_1 - s_0
        X_0, X_1 = self.pose(np.array([s_0, s_1]))
        turns = (part * self._turns[0],)
        return replace(self, X_0=X_0, X_1=X_1, sweep=part * self.sweep, spin=part * self.spin, turns=turns)

    @property
    def symbols(self) -> ArcSymbols:
        """By how many turns it has, and whether their frame goes around."""
        own = int(np.linalg.norm(self._turns[0]) > _STILL) if self.evenly_turned else 2
        return ArcSymbols(own, self.spin > 0)

    def parameters(self, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of the expression."""
        centre, normal = X_BA[:3, :3] @ self.centre + X_BA[:3, 3], X_BA[:3, :3] @ self.normal
        first = (X_BA @ self.X_0)[:3, 3] - centre
        parts: dict[str, ArrayLike] = {
            "centre": centre, "normal": normal, "first": first, "side": np.cross(normal, first), "sweep": self.sweep,
            "spin": self.spin, "passed": self.passed, "offset": X_FT[:3, 3],
            "R": flange_at_start(X_BA, self.X_0, X_FT)[:3, :3],
        }  # fmt: skip
        for i, turn in enumerate((*self._turns, np.zeros(3))[:2]):
            angle = float(np.linalg.norm(turn))
            parts |= {f"axis_{i}": X_FT[:3, :3] @ (turn / angle if angle > 0 else _X), f"angle_{i}": angle}
        return ArcSymbols.layout.vector(parts)

    def _frames(self, s: Array) -> Array:
        """E R_0 (n, 3, 3): where the tool would be without turns of its own."""
        R_0 = self.X_0[:3, :3]
        if self.spin == 0:
            return np.broadcast_to(R_0, (len(s), 3, 3))
        return np.asarray(rotation_about(self.normal, self.spin * s) @ R_0)

    def _turned(self, s: Array) -> Array:
        """Its turns in its own frame (n, 3, 3)."""
        first, *second = self._turns
        R = _rotations(first, self._fractions(s)[0])
        return R @ _rotations(second[0], self._fractions(s)[3]) if second else R

    def _fractions(self, s: Array) -> tuple[Array, Array, float, Array, Array, float]:
        """f and g (n,) with their first and second derivatives."""
        if self.evenly_turned:
            return s, np.ones_like(s), 0.0, np.zeros_like(s), np.zeros_like(s), 0.0
        c = self.passed
        f, df, ddf = s * (1 + c - s) / c, (1 + c - 2 * s) / c, -2 / c
        return f, df, ddf, s * (s - c) / (1 - c), (2 * s - c) / (1 - c), 2 / (1 - c)

    def _turn_rates(self, s: Array) -> tuple[Array, Array]:
        """The rate of turning and its derivative (n, 3), in the poses' frame."""
        f, df, ddf, _, dg, ddg = self._fractions(s)
        first, *second = self._turns
        own, change = df[:, None] * first, np.broadcast_to(ddf * first, (len(s), 3))
        if second:
            E = _rotations(first, f)
            other = E @ second[0]
            own = own + dg[:, None] * other
            change = change + ddg * other + (df * dg)[:, None] * np.cross(first, other)
        R, spin = self._frames(s), self.spin * self.normal
        own, change = ((R @ x[..., None])[..., 0] for x in (own, change))
        return own + spin, change + np.cross(spin, own)

    def _on_circle(self, s: Array) -> Array:
        phi = (self.sweep * s)[:, None]
        return np.asarray(np.cos(phi) * self._first + np.sin(phi) * self._side)


def _turn(R_0: Array, R_1: Array) -> Array:
    """The rotation vector (3,) of the shorter turn from R_0 to R_1 (3, 3), in the frame of R_0."""
    axis, angle = axis_angle(R_0.T @ R_1)
    return np.asarray(axis * angle)


def _turn_by(R_0: Array, R_V: Array, R_1: Array, s: float) -> tuple[Array, bool]:
    """The rotation vector (3,) of the turn from R_0 to R_1 (3, 3) that comes nearer to R_V at s of it, and whether that
    says to which side it is.

    A turn by more than half a turn has to come nearer by a third of what it is longer, so that a circle point
    that was taught without care does not send a tool around that stands the same at both ends.
    """
    short = _turn(R_0, R_1)
    angle = float(np.linalg.norm(short))
    if angle < _STILL:
        return short, True
    long = short * (1 - 2 * np.pi / angle)
    off_short, off_long = (axis_angle(R_V.T @ R_0 @ _rotations(w, np.array([s]))[0])[1] for w in (short, long))
    decided = angle < np.pi - _HALF_TURN or abs(off_long - off_short) > _NO_SIDE
    return long if off_long + (2 * np.pi - 2 * angle) / 3 < off_short else short, decided


def _rotations(turn: Array, fraction: Array) -> Array:
    """Rotations (n, 3, 3) by fractions (n,) of a rotation vector (3,)."""
    angle = float(np.linalg.norm(turn))
    return rotation_about(turn / angle if angle > 0 else _X, fraction * angle)


def _point(p: Array) -> Point:
    x, y, z = p.tolist()
    return x, y, z


@dataclass(frozen=True)
class ArcSymbols(Symbols):
    """The flange on an arc as an expression of the arc's parameters and s. turns: how many turns of the tool's own
    there are, 0 to 2. spins: whether the frame in which it turns goes about the normal."""

    turns: int = 1
    spins: bool = False
    # first, side: from the centre to the start, and to the point a quarter turn on; R: the flange's rotation at s = 0;
    # axis_i, angle_i: its turns about axes of its own; offset: the tool centre point in the flange's frame
    layout: ClassVar[Layout] = Layout(
        {
            **dict.fromkeys(("centre", "first", "side", "normal", "axis_0", "axis_1", "offset"), (3,)),
            **dict.fromkeys(("sweep", "spin", "angle_0", "angle_1", "passed"), ()),
            "R": (3, 3),
        }
    )

    def flange(self, p: ca.SX, s: ca.SX | float) -> Flange:
        """The flange in the arm's base frame at s of the arc with parameters p (size,)."""
        import casadi as ca

        part = self.layout.split(p)
        R, c, phi = part["R"], part["passed"], part["sweep"] * s
        if self.spins:
            R = rotated(part["normal"], part["spin"] * s) @ R
        if self.turns == 1:
            R = R @ rotated(part["axis_0"], part["angle_0"] * s)
        elif self.turns == 2:
            R = R @ rotated(part["axis_0"], part["angle_0"] * s * (1 + c - s) / c)
            R = R @ rotated(part["axis_1"], part["angle_1"] * s * (s - c) / (1 - c))
        tool = part["centre"] + ca.cos(phi) * part["first"] + ca.sin(phi) * part["side"]
        return Flange(tool - R @ part["offset"], R)

    def tangent_rate(self, p: ca.SX, s: ca.SX) -> ca.SX | float:
        """The sweep, everywhere."""
        return self.layout.split(p)["sweep"]
