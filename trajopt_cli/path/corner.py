"""Corners of two Cartesian segments: a fly-by point is passed inside its zone without a stop.

The position leaves the first segment where the zone is entered and joins the second where it is left, with the rate of
either; between two lines that is a parabola (quadratic Bézier: entry, point, exit). The orientation does the same over
a zone of its own, as a cumulative quadratic Bézier of the two turns: the rest of the one comes to rest while the part
of the other gathers speed. Run backwards a corner's positions are the same; its orientations are if both turns have one
axis, else they differ by less than a sixteenth of the product of both turns [rad].

Where jerk is limited a corner is smooth, without a curvature of its own at its ends: both segments are added up, the
one coming to rest at the point and the other gathering speed, over 2 u^3 - u^4 instead of u^2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, BoolArray, IndexArray, axis_angle, rotations_by
from trajopt_cli.path.hermite import hermite
from trajopt_cli.path.line import Line, lines_along
from trajopt_cli.path.segment import POINT, Batch, Segment, check_fractions
from trajopt_cli.path.symbols import Curve, Flange, Layout, Symbols, rotated

if TYPE_CHECKING:
    import casadi as ca

_HALF = 0.5 + 1e-9  # of a segment, with rounding
_START, _END = np.zeros(1), np.ones(1)
_NO_TURN = 1e-9  # rad: a turn this small has no expression
_X = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True, eq=False)
class Corner(Segment):
    """Replaces the last part of one segment, a fraction of it, and the first of the next, each by half of its own s.

    position, orientation: in which part of the corner, around its middle, the one and the other is bent; the larger is
    1, for the corner begins and ends where the larger zone does. Outside its part either runs on as on the segments.
    smooth: second derivatives go on at the corner's ends, too.
    """

    is_corner: ClassVar[bool] = True

    before: Segment
    after: Segment
    fraction_before: float
    fraction_after: float
    position: float = 1.0
    orientation: float = 1.0
    smooth: bool = False

    def __post_init__(self) -> None:
        check_fractions(self.fraction_before, self.fraction_after, self.position, self.orientation)
        if max(self.position, self.orientation) != 1:
            raise ValueError("a corner is as large as the larger of its two zones: one of them is 1")
        X, Y = self.before.pose(_END)[0], self.after.pose(_START)[0]
        apart = np.linalg.norm(X[:3, 3] - Y[:3, 3])
        if apart > POINT or axis_angle(X[:3, :3].T @ Y[:3, :3])[1] > POINT:
            raise ValueError(
                f"the segment after a corner does not begin where the other ends: {apart * 1e3:.6f} mm apart"
            )

    @classmethod
    def of_zone(cls, before: Segment, after: Segment, radius: float, turning: float, smooth: bool = False) -> Corner:
        """The corner of a zone whose edges are radius [m] from the point along both segments, and turning [m] for the
        orientation.

        Raises:
            InputError: a zone reaches beyond the middle of a segment, or is none.
        """
        largest, least = max(radius, turning), min(radius, turning)
        if least <= 0:
            raise InputError(f"a corner needs zones above 0 mm, found {least * 1e3:g} mm; a stop point has no corner")
        shortest = min(before.length, after.length)
        if largest > _HALF * shortest:
            raise InputError(
                f"a zone of {largest * 1e3:.6g} mm reaches beyond the middle of a way of {shortest * 1e3:.6g} mm;"
                f" at most {shortest / 2 * 1e3:.6g} mm"
            )
        return cls(
            before, after, largest / before.length, largest / after.length, radius / largest, turning / largest, smooth
        )

    # ---- the position's curve: both ends with their rates per unit of the part where it is bent
    @cached_property
    def _curve(self) -> tuple[Array, Array, Array, Array]:
        f_0, f_1 = self.position * self.fraction_before, self.position * self.fraction_after
        s_0, s_1 = np.array([1 - f_0]), np.array([f_1])
        return (
            self.before.pose(s_0)[0, :3, 3],
            2 * f_0 * self.before.twist(s_0)[0, :3],
            self.after.pose(s_1)[0, :3, 3],
            2 * f_1 * self.after.twist(s_1)[0, :3],
        )

    @cached_property
    def _R_point(self) -> Array:
        """Rotation (3, 3) at the point."""
        return self.after.pose(_START)[0, :3, :3]

    # ---- the orientation's, of lines: rotation at the entry, both turns as rotation vectors of the tool's own frame
    @cached_property
    def _turns(self) -> tuple[Array, Array, Array]:
        f_0, f_1 = self.orientation * self.fraction_before, self.orientation * self.fraction_after
        R_0 = self.before.pose(np.array([1 - f_0]))[0, :3, :3]
        turn_0 = f_0 * self.before.twist(_END)[0, 3:]
        turn_1 = f_1 * self.after.twist(_START)[0, 3:]
        return R_0, R_0.T @ turn_0, self._R_point.T @ turn_1

    @property
    def breaks(self) -> Array:
        """Where the smaller zone is entered and left, if it is smaller."""
        least = min(self.position, self.orientation)
        return np.array([(1 - least) / 2, (1 + least) / 2]) if least < 1 else np.zeros(0)

    @cached_property
    def length(self) -> float:
        """Of the tool centre point's path [m]."""
        return self._sum(slice(0, 3))

    @cached_property
    def angle(self) -> float:
        """Reorientation [rad], summed up."""
        return self._sum(slice(3, 6))

    def _sum(self, part: slice) -> float:
        """Integral of a rate's size over s, by Gauss' rule between breaks; the middle is one, too: a narrow corner is
        steep there."""
        x, weight = np.polynomial.legendre.leggauss(64)
        edges = np.sort(np.r_[0.0, self.breaks, 0.5, 1.0])
        half = np.diff(edges) / 2
        s = edges[:-1, None] + half[:, None] * (1 + x)
        size = np.linalg.norm(self.twist(s.ravel())[:, part], axis=1).reshape(s.shape)
        return float(half @ size @ weight)

    def pose(self, s: Array) -> Array:
        """Tool poses (n, 4, 4) at s (n,)."""
        first, t_0, t_1 = self._sides(s)
        X = np.empty((len(s), 4, 4))
        X[first], X[~first] = self.before.pose(t_0), self.after.pose(t_1)
        inside, u = _part(s, self.position)
        X[inside, :3, 3] = self._bent(u)[0]
        inside, u = _part(s, self.orientation)
        _, K, turn = self._turning(u)
        X[inside, :3, :3] = K @ turn.R
        return X

    def twist(self, s: Array) -> Array:
        """First derivative (n, 6) by s."""
        first, t_0, t_1 = self._sides(s)
        V = np.empty((len(s), 6))
        V[first] = 2 * self.fraction_before * self.before.twist(t_0)
        V[~first] = 2 * self.fraction_after * self.after.twist(t_1)
        inside, u = _part(s, self.position)
        V[inside, :3] = self._bent(u)[1] / self.position
        inside, u = _part(s, self.orientation)
        rest, K, turn = self._turning(u)
        V[inside, 3:] = (rest.rate + _times(K, turn.rate)) / self.orientation
        return V

    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6) by s."""
        first, t_0, t_1 = self._sides(s)
        A = np.empty((len(s), 6))
        A[first] = (2 * self.fraction_before) ** 2 * self.before.twist_rate(t_0)
        A[~first] = (2 * self.fraction_after) ** 2 * self.after.twist_rate(t_1)
        inside, u = _part(s, self.position)
        A[inside, :3] = self._bent(u)[2] / self.position**2
        inside, u = _part(s, self.orientation)
        rest, K, turn = self._turning(u)
        change = rest.change + np.cross(rest.rate, _times(K, turn.rate)) + _times(K, turn.change)
        A[inside, 3:] = change / self.orientation**2
        return A

    @cached_property
    def numbers(self) -> Array:
        """Both ends with their rates, and its turns."""
        return np.concatenate([super().numbers, self._curve[1], self._curve[3], *self._turns_in_order])

    @property
    def whole(self) -> bool:
        """Whether one expression is all of it: both zones are one, between lines or arcs that turn evenly."""
        return (
            self.breaks.size == 0
            and not self.smooth
            and all(one.even_turns is not None for one in (self.before, self.after))
        )

    @cached_property
    def _turns_in_order(self) -> list[Array]:
        """Four rotation vectors (3,) in the tool's frame at the point: what turns in the zone before it with the frame
        of an arc, and by itself; then the same behind it."""
        out = []
        for one, fraction in ((self.before, self.fraction_before), (self.after, self.fraction_after)):
            spin, own = one.even_turns or (np.zeros(3), np.zeros(3))
            out += [fraction * (self._R_point.T @ spin), fraction * own]
        return out

    @property
    def symbols(self) -> CornerSymbols:
        """With the turns that there are."""
        if not self.whole:
            raise NotImplementedError("no expression is all of this corner")
        return CornerSymbols(tuple(i for i, turn in enumerate(self._turns_in_order) if np.linalg.norm(turn) > _NO_TURN))

    def parameters(self, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of the expression."""
        R_BA, (p_0, m_0, p_1, m_1) = X_BA[:3, :3], self._curve
        parts: dict[str, ArrayLike] = {
            "p_0": R_BA @ p_0 + X_BA[:3, 3], "m_0": R_BA @ m_0, "p_1": R_BA @ p_1 + X_BA[:3, 3], "m_1": R_BA @ m_1,
            "R": R_BA @ self._R_point @ X_FT[:3, :3].T, "offset": X_FT[:3, 3],
        }  # fmt: skip
        for i, turn in enumerate(self._turns_in_order):
            angle = float(np.linalg.norm(turn))
            parts |= {f"axis_{i}": X_FT[:3, :3] @ (turn / angle if angle > 0 else _X), f"angle_{i}": angle}
        return CornerSymbols.layout.vector(parts)

    @property
    def batch(self) -> Batch:
        """Corners of lines at once."""
        lines = isinstance(self.before, Line) and isinstance(self.after, Line) and not self.smooth
        return _corners_along if lines else super().batch

    def _sides(self, s: Array) -> tuple[BoolArray, Array, Array]:
        """Which s belong to the first half, and what they would be on the two segments."""
        first = np.asarray(s < 0.5)
        return first, 1 - self.fraction_before * (1 - 2 * s[first]), self.fraction_after * (2 * s[~first] - 1)

    def _bent(self, u: Array) -> tuple[Array, Array, Array]:
        """At u (n,) of the part where it is bent: the position with both derivatives by u, each (n, 3)."""
        if not self.smooth:
            return hermite(*self._curve, u[:, None])
        first, second = self._passed(self.position, u)
        P = self.after.pose(_START)[0, :3, 3]
        rate, change = first.rate + second.rate, first.change + second.change
        return first.X[:, :3, 3] + second.X[:, :3, 3] - P, rate[:, :3], change[:, :3]

    def _turning(self, u: Array) -> tuple[_Turn, Array, _Turn]:
        """At u (n,) of the part where the orientation is bent: the first turn, which comes to rest at the point,
        what it makes of the second (n, 3, 3), and the second, which begins there at rest."""
        first, second = (one.turn for one in self._passed(self.orientation, u))
        return first, np.asarray(first.R @ self._R_point.T), second

    def _passed(self, part: float, u: Array) -> tuple[_Passed, _Passed]:
        """Where both segments are at u (n,) of a part: the first comes to rest at the point, the second leaves it."""
        f_0, f_1 = part * self.fraction_before, part * self.fraction_after
        (h_0, dh_0, ddh_0), (h_1, dh_1, ddh_1) = (_gathered(x, self.smooth) for x in (1 - u, u))
        first = _passed(self.before, 1 - f_0 * h_0, f_0 * dh_0, -f_0 * ddh_0)
        return first, _passed(self.after, f_1 * h_1, f_1 * dh_1, f_1 * ddh_1)


@dataclass(frozen=True)
class CornerSymbols(Symbols):
    """The flange in a corner whose zones are one, as an expression: R(s) = R exp(-(1 - s)^2 w_0) exp(-(1 - s)^2 w_1)
    exp(s^2 w_2) exp(s^2 w_3) with the turns w inside the zone. turns: numbers of those that there are."""

    turns: tuple[int, ...] = ()
    # p_i, m_i: both ends and the derivatives there; R: the flange's rotation at the point; axis_i, angle_i: the turns
    # in the zone about axes of the flange; offset: the tool centre point in its frame
    layout: ClassVar[Layout] = Layout(
        {
            **dict.fromkeys(("p_0", "m_0", "p_1", "m_1", "offset", "axis_0", "axis_1", "axis_2", "axis_3"), (3,)),
            **dict.fromkeys(("angle_0", "angle_1", "angle_2", "angle_3"), ()),
            "R": (3, 3),
        }
    )

    def flange(self, p: ca.SX, s: ca.SX | float) -> Flange:
        """The flange in the arm's base frame at s of the corner with parameters p (size,)."""
        part = self.layout.split(p)
        R = part["R"]
        for i in self.turns:
            R = R @ rotated(part[f"axis_{i}"], part[f"angle_{i}"] * (-((1 - s) ** 2) if i < 2 else s**2))
        return Flange(self._along(part, s)[0] - R @ part["offset"], R)

    def curve(self, p: ca.SX, s: ca.SX) -> Curve:
        """See Symbols."""
        import casadi as ca

        part = self.layout.split(p)
        _, tangent, bend = self._along(part, s)
        turn = ca.SX.zeros(3)
        for i in self.turns:
            axis, angle = part[f"axis_{i}"], part[f"angle_{i}"]
            back = rotated(axis, -angle * (-((1 - s) ** 2) if i < 2 else s**2))
            turn = back @ turn + 2 * ((1 - s) if i < 2 else s) * angle * axis
        return Curve(tangent, bend, turn)

    def _along(self, part: dict[str, ca.SX], s: ca.SX | float) -> tuple[ca.SX, ca.SX, ca.SX]:
        return hermite(part["p_0"], part["m_0"], part["p_1"], part["m_1"], s)


class _Turn(NamedTuple):
    """Rotations (n, 3, 3), their rates of turning and how these change (n, 3), in the poses' frame."""

    R: Array
    rate: Array
    change: Array


class _Passed(NamedTuple):
    """Poses (n, 4, 4) of a segment that goes by, twists and how these change (n, 6)."""

    X: Array
    rate: Array
    change: Array

    @property
    def turn(self) -> _Turn:
        """Of the orientation."""
        return _Turn(self.X[:, :3, :3], self.rate[:, 3:], self.change[:, 3:])


def _passed(segment: Segment, s: Array, ds: Array, dds: Array) -> _Passed:
    """A segment at s (n,) that go by at ds and dds (n,)."""
    rate, change = segment.twist(s), segment.twist_rate(s)
    return _Passed(segment.pose(s), rate * ds[:, None], change * ds[:, None] ** 2 + rate * dds[:, None])


def _gathered(u: Array, smooth: bool) -> tuple[Array, Array, Array]:
    """What part of a zone's way is done at u (n,), from rest to a rate of 2 at u = 1, and both derivatives."""
    if smooth:
        return u**3 * (2 - u), u * u * (6 - 4 * u), 12 * u * (1 - u)
    return u * u, 2 * u, np.full_like(u, 2.0)


def _times(R: Array, x: Array) -> Array:
    """Vectors x (n, 3) turned by R (n, 3, 3)."""
    return np.asarray((R @ x[..., None])[..., 0])


def _corners_along(segments: Sequence[Segment], of: IndexArray, s: Array) -> tuple[Array, Array, Array]:
    """Poses (m, 4, 4), twists and their rates (m, 6) at s (m,) of the corners of lines with numbers of (m,)."""
    corners = [corner for corner in segments if isinstance(corner, Corner)]
    numbers = np.array([(one.fraction_before, one.fraction_after, one.position, one.orientation) for one in corners])
    f_0, f_1, position, orientation = numbers[of].T
    lines = [one.before for one in corners] + [one.after for one in corners]
    first = s < 0.5
    t = np.where(first, 1 - f_0 * (1 - 2 * s), f_1 * (2 * s - 1))
    X, twist, bend = lines_along(lines, of + len(corners) * ~first, t)
    twist *= 2 * np.where(first, f_0, f_1)[:, None]
    for part, fill in ((position, _bent), (orientation, _turning)):
        u = 0.5 + (s - 0.5) / part
        at = np.flatnonzero(((u >= 0) & (u < 1)) | (part >= 1))
        fill(corners, of[at], u[at, None], part[at, None], at, X, twist, bend)
    return X, twist, bend


def _bent(
    corners: Sequence[Corner], of: IndexArray, u: Array, part: Array, at: IndexArray, X: Array, twist: Array,
    bend: Array,
) -> None:  # fmt: skip
    """Fill in the positions at u (m, 1) of the part where they are bent."""
    p_0, rate_0, p_1, rate_1 = (np.array(end)[of] for end in zip(*(one._curve for one in corners), strict=True))
    p, rate, change = hermite(p_0, rate_0, p_1, rate_1, u)
    X[at, :3, 3], twist[at, :3], bend[at, :3] = p, rate / part, change / part**2


def _turning(
    corners: Sequence[Corner], of: IndexArray, u: Array, part: Array, at: IndexArray, X: Array, twist: Array,
    bend: Array,
) -> None:  # fmt: skip
    """Fill in the orientations at u (m, 1) of the part where they are bent."""
    R_0, turn_0, turn_1 = (np.array(end)[of] for end in zip(*(one._turns for one in corners), strict=True))
    R = R_0 @ rotations_by((2 * u - u * u) * turn_0)
    X[at, :3, :3] = R @ rotations_by(u * u * turn_1)
    a, b, across = (
        (left @ right[..., None])[..., 0] for left, right in ((R_0, turn_0), (R, turn_1), (R, np.cross(turn_0, turn_1)))
    )
    twist[at, 3:] = ((2 - 2 * u) * a + 2 * u * b) / part
    bend[at, 3:] = (2 * (b - a) + 4 * u * (1 - u) * across) / part**2


def _part(s: Array, part: float) -> tuple[BoolArray, Array]:
    """Which s lie in the middle part of a corner, and what fraction (m,) of that part they are."""
    u = 0.5 + (s - 0.5) / part
    inside = np.asarray((u >= 0) & (u < 1) if part < 1 else np.ones(len(s), dtype=bool))
    return inside, u[inside]
