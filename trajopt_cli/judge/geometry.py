"""The judge's own geometry: angles between rotations, and the paths that moves ask for: of a MoveL a line, of a MoveC
an arc."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np
import pinocchio as pin

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import CirPathMode, MoveC, MoveL, PathMove, UnitMove, motion_name, turned_under
from trajopt_cli.scenario import PositionerAxis

_POINT = 1e-6  # m: a line shorter than this is a reorientation, its progress is an angle
_FLAT = 1e-9  # sine of the angle between two chords below which three points lie on one line
_HALF_TURN = 1e-6  # rad: a reorientation this close to half a turn may go either way
_STEPS = 65  # places at which an arc's turn is added up


def lengths(x: Array) -> Array:
    """Lengths (...) of vectors (..., d)."""
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", x, x)))


def column_lengths(J: Array) -> Array:
    """Lengths (n, k) of the columns of matrices (n, d, k)."""
    return np.asarray(np.sqrt(np.einsum("nik,nik->nk", J, J)))


def angle_between(A: Array, B: Array) -> Array:
    """Angle (...) in rad between rotations (..., 3, 3); exact to rounding near zero."""
    apart = np.asarray(B) - np.asarray(A)
    chord = lengths(apart.reshape(*apart.shape[:-2], 9)) / (2 * np.sqrt(2.0))
    return np.asarray(2 * np.arcsin(np.minimum(chord, 1.0)))


def rotation_vectors(R: Array) -> Array:
    """Axis times angle (..., 3) of rotations (..., 3, 3); not for half turns."""
    skew = np.stack([R[..., i, j] - R[..., j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=-1) / 2
    sine = lengths(skew)[..., None]
    angle = np.arctan2(sine, (np.trace(R, axis1=-2, axis2=-1)[..., None] - 1) / 2)
    return np.asarray(skew * (angle / np.maximum(sine, 1e-300)))


def turned(units: Sequence[UnitMove], theta: Array) -> tuple[Array, Array]:
    """How positioners have moved a work object that they have turned by theta (n, m) [rad, m of those that slide]: R
    (n, 3, 3) and x (n, 3), so that a point p of it has come to R p + x. units: from the floor on."""
    R, x = np.tile(np.eye(3), (len(theta), 1, 1)), np.zeros((len(theta), 3))
    for unit, angle in zip(units, theta.T, strict=True):
        if unit.slides:
            x = x + angle[:, None] * (R @ np.array(unit.u))
            continue
        K, p = pin.skew(np.array(unit.u)), np.array(unit.p)
        E = np.eye(3) + np.sin(angle)[:, None, None] * K + (1 - np.cos(angle))[:, None, None] * (K @ K)
        x = x + np.einsum("nij,nj->ni", R, p - E @ p)
        R = R @ E
    return R, x


def turned_back(units: Sequence[UnitMove], X: Array) -> Array:
    """A pose (4, 4) on a work object at the end of a move that turns it, where it is at the move's start."""
    R, x = turned(units, np.array([[unit.angle for unit in units]]))
    E = np.eye(4)
    E[:3, :3], E[:3, 3] = R[0], x[0]
    return np.asarray(inverse_pose(E) @ X)


def mounted(axis: PositionerAxis) -> Array:
    """The frame (4, 4) about whose z a positioner's axis turns, on the axis before it or in the world."""
    w, x, y, z = axis.q
    return np.asarray(pin.XYZQUATToSE3(np.array([*axis.p, x, y, z, w])).homogeneous)


def table_frame(axes: Sequence[PositionerAxis], at: Sequence[float]) -> Array:
    """The frame (4, 4) in the world that the last of a positioner's axes carries, the axes at [rad or m]."""
    X = np.eye(4)
    for axis, angle in zip(axes, at, strict=True):
        turn, way = (0.0, angle) if axis.slides else (angle, 0.0)
        X = X @ mounted(axis) @ pin.SE3(pin.exp3(np.array([0.0, 0.0, turn])), np.array([0.0, 0.0, way])).homogeneous
    return X


def inverse_pose(X: Array) -> Array:
    """X_BA (..., 4, 4) of poses X_AB."""
    out = np.zeros_like(X)
    out[..., :3, :3] = np.swapaxes(X[..., :3, :3], -1, -2)
    out[..., :3, 3] = -np.einsum("...ji,...j->...i", X[..., :3, :3], X[..., :3, 3])
    out[..., 3, 3] = 1.0
    return out


@dataclass(frozen=True, eq=False)
class Line:
    """From X_0 (4, 4) straight along chord (3,) [m] in the world, turning evenly by the rotation vector turn (3,) [rad]
    in the frame of X_0."""

    kind: ClassVar[str] = "line"
    shape: ClassVar[str] = "chord"
    straight: ClassVar[bool] = True

    X_0: Array
    chord: Array
    turn: Array

    @classmethod
    def between(cls, X_0: Array, X_1: Array, R: Array) -> Line:
        """The line from X_0 to X_1 (4, 4), turning the shorter way; of half a turn the way that rotations R (m, 3, 3)
        on it went."""
        turn = np.asarray(pin.log3(X_0[:3, :3].T @ X_1[:3, :3]))
        angle = float(np.linalg.norm(turn))
        if angle > np.pi - _HALF_TURN and turn @ pin.log3(X_0[:3, :3].T @ R[len(R) // 2]) < 0:
            turn = turn * (1 - 2 * np.pi / angle)
        return cls(X_0, X_1[:3, 3] - X_0[:3, 3], turn)

    @cached_property
    def length(self) -> float:
        """Of the tool centre point's path, m."""
        return float(np.linalg.norm(self.chord))

    @cached_property
    def angle(self) -> float:
        """How far the tool turns, rad."""
        return float(np.linalg.norm(self.turn))

    @property
    def only_turns(self) -> bool:
        """Whether the line is a reorientation, whose progress is an angle."""
        return self.length < _POINT and self.length < self.angle

    @property
    def extent(self) -> float:
        """What progress is counted in: the length [m], or of a reorientation the angle [rad]."""
        return self.angle if self.only_turns else self.length

    def progress(self, p: Array, R: Array | None = None) -> Array:
        """Fraction of the path (m,) at positions p (m, 3), of a reorientation at rotations R (m, 3, 3), not clipped."""
        if self.length == 0.0 == self.angle:
            return np.zeros(len(p))
        if not self.only_turns:
            return np.asarray((p - self.X_0[:3, 3]) @ self.chord / self.length**2)
        assert R is not None
        # the angle about the line's own axis: what is not about it shows in the deviation
        turned = self.X_0[:3, :3].T @ R
        skew = np.stack([turned[:, i, j] - turned[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=1)
        cosine = (np.trace(turned, axis1=1, axis2=2) - 1) / 2
        return np.asarray(np.arctan2(skew @ self.turn / (2 * self.angle), cosine) / self.angle)

    def at(self, s: Array) -> tuple[Array, Array]:
        """Positions (m, 3) and rotations (m, 3, 3) at s (m,)."""
        K = pin.skew(self.turn / self.angle) if self.angle > 0 else np.zeros((3, 3))
        sine, cosine = (f(s * self.angle)[:, None, None] for f in (np.sin, np.cos))
        R = self.X_0[:3, :3] @ (np.eye(3) + sine * K + (1 - cosine) * (K @ K))
        return self.positions(s), R

    def positions(self, s: Array) -> Array:
        """Positions (m, 3) alone."""
        return np.asarray(self.X_0[:3, 3] + s[:, None] * self.chord)


@dataclass(frozen=True, eq=False)
class Arc:
    r"""From where line begins to where it ends, on a circle about centre (3,) [m]: first (3,) leads from there to the
    start, side (3,) as far to the point a quarter turn on; by sweep [rad] in (0, 2 pi).

    turns: how the tool turns, as rotation vectors (3,) [rad] in its own frame. None: as on the line. One: relative to
    the frame of the path, which is (radial, tangent, normal) and goes around with it. Two: to the orientation of the
    circle point, at s = passed, and from there to the end (RAPID reference manual, CirPathMode: the
    modes \ObjectFrame, \PathFrame, \CirPointOri).
    """

    kind: ClassVar[str] = "arc"
    shape: ClassVar[str] = "circle"
    straight: ClassVar[bool] = False

    line: Line
    centre: Array
    first: Array
    side: Array
    sweep: float
    turns: tuple[Array, ...] | None = None
    passed: float = 0.5

    @classmethod
    def through(cls, line: Line, via: Array, mode: CirPathMode = CirPathMode.OBJECT_FRAME) -> Arc | None:
        """The arc with the line's ends through the circle point via, its place (3,) [m] or its pose (4, 4); None where
        no circle leads through all three."""
        X_V = via if via.ndim == 2 else np.block([[line.X_0[:3, :3], via[:, None]], [np.zeros(3), 1.0]])
        start, u, v = line.X_0[:3, 3], X_V[:3, 3] - line.X_0[:3, 3], line.chord
        normal = np.cross(u, v)
        if np.linalg.norm(normal) <= _FLAT * np.linalg.norm(u) * np.linalg.norm(v):
            return None
        # the centre is as far from all three: (c - start) u = u u / 2, likewise v, and in their plane
        first = -np.linalg.solve(np.stack([u, v, normal]), np.array([u @ u / 2, v @ v / 2, 0.0]))
        side = np.cross(normal / np.linalg.norm(normal), first)
        last = first + v
        arc = cls(line, start - first, first, side, float(np.arctan2(last @ side, last @ first) % (2 * np.pi)))
        if mode not in (CirPathMode.PATH_FRAME, CirPathMode.CIR_POINT_ORI):
            return arc
        passed = float(np.arctan2((first + u) @ side, (first + u) @ first) % (2 * np.pi)) / arc.sweep
        R_0, R_V, R_1 = line.X_0[:3, :3], X_V[:3, :3], line.X_0[:3, :3] @ pin.exp3(line.turn)
        if mode is CirPathMode.CIR_POINT_ORI:
            return replace(
                arc, turns=(np.asarray(pin.log3(R_0.T @ R_V)), np.asarray(pin.log3(R_V.T @ R_1))), passed=passed
            )
        C_0, C_V, C_1 = arc.frames(np.array([0.0, passed, 1.0]))
        Q_0, Q_V, Q_1 = C_0.T @ R_0, C_V.T @ R_V, C_1.T @ R_1
        turn = _nearer(Q_0.T @ Q_1, Q_0.T @ Q_V, passed)
        return replace(arc, turns=(turn,), passed=passed)

    @property
    def length(self) -> float:
        """Of the tool centre point's path, m."""
        return float(np.linalg.norm(self.first)) * self.sweep

    @cached_property
    def angle(self) -> float:
        """How far the tool turns, rad."""
        if self.turns is None:
            return self.line.angle
        R = self.at(np.linspace(0.0, 1.0, _STEPS))[1]
        return float(angle_between(R[:-1], R[1:]).sum())

    def frames(self, s: Array) -> Array:
        """The frame of the path (m, 3, 3) at s (m,): radial, tangent and normal as its columns."""
        size = np.linalg.norm(self.first)
        radial, tangent = self.first / size, self.side / size
        phi = (s * self.sweep)[:, None]
        x, y = np.cos(phi) * radial + np.sin(phi) * tangent, np.cos(phi) * tangent - np.sin(phi) * radial
        return np.stack([x, y, np.broadcast_to(np.cross(radial, tangent), x.shape)], axis=-1)

    @property
    def only_turns(self) -> bool:
        """Never: its progress is a length."""
        return False

    @property
    def extent(self) -> float:
        """What progress is counted in: the length [m]."""
        return self.length

    def progress(self, p: Array, R: Array | None = None) -> Array:
        """Fraction of the path (m,) at positions p (m, 3), not clipped; what the circle leaves over belongs half to its
        start and half to its end. Rotations do not matter."""
        out = p - self.centre
        left_over = 2 * np.pi - self.sweep
        phi = np.arctan2(out @ self.side, out @ self.first)
        return np.asarray(((phi + left_over / 2) % (2 * np.pi) - left_over / 2) / self.sweep)

    def at(self, s: Array) -> tuple[Array, Array]:
        """Positions (m, 3) and rotations (m, 3, 3) at s (m,)."""
        if self.turns is None:
            return self.positions(s), self.line.at(s)[1]
        R_0, c = self.line.X_0[:3, :3], self.passed
        if len(self.turns) == 1:
            Q_0 = self.frames(np.zeros(1))[0].T @ R_0
            return self.positions(s), self.frames(s) @ Q_0 @ _exponentials(np.outer(s, self.turns[0]))
        first, second = self.turns
        R = R_0 @ _exponentials(np.outer(s * (1 + c - s) / c, first))
        return self.positions(s), R @ _exponentials(np.outer(s * (s - c) / (1 - c), second))

    def positions(self, s: Array) -> Array:
        """Positions (m, 3) alone."""
        phi = (s * self.sweep)[:, None]
        return np.asarray(self.centre + np.cos(phi) * self.first + np.sin(phi) * self.side)


Path = Line | Arc


def wanted_path(move: PathMove, X_0: Array, X_1: Array, R: Array) -> Path:
    """The path that a move asks for from X_0 to X_1 (4, 4), over a table as it stands at the start. R (m, 3, 3):
    rotations on it.

    Raises:
        InputError: the three points of a MoveC lie on one line or in one place; with its place in the program.
    """
    line = Line.between(X_0, X_1, R)
    match move:
        case MoveL():
            return line
        case MoveC():
            X_V = turned_back(turned_under(move), move.X_WV)
            if arc := Arc.through(line, X_V, move.settings.circle):
                return arc
            places = ", ".join("[" + ", ".join(f"{x * 1e3:.3f}" for x in X[:3, 3]) + "]" for X in (X_0, X_V, X_1))
            file, row, column = move.source
            raise InputError(
                f"{motion_name(move)}: start, point on the way and end {places} mm lie on one line, no circle leads"
                " through them; move the point on the way, or use MoveL",
                file=file, line=row, column=column, kind=ErrorKind.PROGRAM,
            )  # fmt: skip
    raise NotImplementedError(f"the judge knows no path of a {type(move).__name__}")


def _nearer(A: Array, V: Array, fraction: float) -> Array:
    """The rotation vector (3,) by which a turn A (3, 3) goes: of the two ways around the one that is nearer to V (3, 3)
    at a share of it, where the longer way needs to be nearer by a third of the difference in length."""
    turn = np.asarray(pin.log3(A))
    size = float(np.linalg.norm(turn))
    paths = [turn, turn - 2 * np.pi * turn / size] if size > 0 else [turn]
    costs = [float(angle_between(pin.exp3(fraction * w), V)) + float(np.linalg.norm(w)) / 3 for w in paths]
    return paths[int(np.argmin(costs))]


def _exponentials(turns: Array) -> Array:
    """Rotations (m, 3, 3) by rotation vectors (m, 3)."""
    return np.array([pin.exp3(turn) for turn in turns]).reshape(-1, 3, 3)


def off_segments(p: Array, a: Array, b: Array) -> Array:
    """Distances (m,) of points p from the segments a to b, all (m, 3)."""
    path = b - a
    fraction = np.einsum("ij,ij->i", p - a, path) / np.maximum(np.einsum("ij,ij->i", path, path), 1e-300)
    return lengths(p - a - np.clip(fraction, 0.0, 1.0)[:, None] * path)


def off_triangles(p: Array, a: Array, b: Array, c: Array) -> Array:
    """Distances (m,) of points p from the triangles a, b, c, all (m, 3); a triangle may be flat."""
    u, v, w = a - b, c - b, p - b
    normal = np.cross(u, v)
    area = np.einsum("ij,ij->i", normal, normal)
    real = area > (_FLAT * lengths(u) * lengths(v)) ** 2
    area = np.where(real, area, 1.0)
    alpha = np.einsum("ij,ij->i", np.cross(w, v), normal) / area
    beta = np.einsum("ij,ij->i", np.cross(u, w), normal) / area
    inside = real & (alpha >= 0) & (beta >= 0) & (alpha + beta <= 1)
    edges = np.minimum(np.minimum(off_segments(p, a, b), off_segments(p, b, c)), off_segments(p, a, c))
    return np.where(inside, np.abs(np.einsum("ij,ij->i", w, normal)) / np.sqrt(area), edges)
