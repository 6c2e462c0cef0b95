"""The tool centre point at the rows of a file: where it is, how fast it moves at least, how sure that is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import angle_between, column_lengths, lengths
from trajopt_cli.judge.samples import INNER, ROUNDING, Along, Boxes, Pieces, Rows, both_sides
from trajopt_cli.judge.tolerances import STOP_POSITION
from trajopt_cli.units import slides


@dataclass(frozen=True, eq=False)
class ToolKinematics:
    """One tool's centre point along all rows. X_FT (4, 4): the TCP in the flange frame."""

    rows: Rows
    X_FT: Array

    @property
    def exact(self) -> bool:
        """Whether the Hermite between rows is the motion itself."""
        return self.rows.exact

    @cached_property
    def R(self) -> Along:
        """Rotations (n, 3, 3) in the world."""
        rows = self.rows
        return Along(Pieces(len(rows.t), lambda a, b: (rows.X_WF[a:b, :3, :3] @ self.X_FT[:3, :3],)))

    @cached_property
    def _jacobians(self) -> Pieces:
        """Jacobians with the lengths of their columns."""
        rows = self.rows

        def make(a: int, b: int) -> tuple[Array, ...]:
            J = shifted(rows.J[a:b], rows.X_WF[a:b], self.X_FT)
            return J, column_lengths(J[:, :3]), column_lengths(J[:, 3:])

        return Pieces(len(rows.t), make)

    @cached_property
    def _small(self) -> tuple[Array, ...]:
        """What is kept of all rows: positions, how far printing may put them off and turn rotations, and where the file
        has speeds, the least ones."""
        rows = self.rows

        def make(a: int, b: int) -> tuple[Array, ...]:
            X, columns = rows.X_WF[a:b], [part[a:b] for part in self.columns]
            p = X[:, :3, :3] @ self.X_FT[:3, 3] + X[:, :3, 3]
            doubts = [_dot(one, rows.doubt_q[a:b]) / 2 for one in columns]
            if rows.qd is None:
                return p, *doubts
            V, total = (self.J[a:b] @ rows.qd[a:b, :, None])[..., 0], np.abs(rows.qd[a:b]).sum(axis=1)
            doubt_V = [
                _dot(one, rows.doubt_v[a:b]) / 2 + total * doubt for one, doubt in zip(columns, doubts, strict=True)
            ]
            speeds = lengths(V[:, :3]), lengths(V[:, 3:])
            least = (np.maximum(one - doubt, 0.0) for one, doubt in zip(speeds, doubt_V, strict=True))
            return p, *doubts, *least

        return Pieces(len(rows.t), make).whole()

    @property
    def p(self) -> Array:
        """Positions (n, 3) in the world, m."""
        return self._small[0]

    def rotations(self, rows: NDArray[np.intp]) -> Array:
        """Rotations (m, 3, 3) at some rows, wherever they are."""
        X = self.rows.mechanism.flange(self.rows.q[rows])[0]
        return np.asarray(X[:, :3, :3] @ self.X_FT[:3, :3])

    @property
    def J(self) -> Along:
        """Jacobians (n, 6, k) at the TCP."""
        return Along(self._jacobians)

    @property
    def columns(self) -> tuple[Along, Along]:
        """Lengths of the Jacobian's columns (n, k), linear and angular: what an axis' doubt does to the TCP."""
        return Along(self._jacobians, 1), Along(self._jacobians, 2)

    @property
    def doubt_p(self) -> Array:
        """How far printing may put a position off (n,), m."""
        return self._small[1]

    @property
    def doubt_R(self) -> Array:
        """How far printing may turn a rotation (n,), rad."""
        return self._small[2]

    @cached_property
    def _velocities(self) -> Pieces:
        rows = self.rows
        assert rows.qd is not None
        qd = rows.qd

        def make(a: int, b: int) -> tuple[Array, ...]:
            total = np.abs(qd[a:b]).sum(axis=1)
            linear, angular = (_dot(columns[a:b], rows.doubt_v[a:b]) / 2 for columns in self.columns)
            V = (self.J[a:b] @ qd[a:b, :, None])[..., 0]
            return V, linear + total * self.doubt_p[a:b], angular + total * self.doubt_R[a:b]

        return Pieces(len(rows.t), make)

    @property
    def V(self) -> Along:
        """TCP speed (n, 6) at the rows, from the file's speed columns."""
        return Along(self._velocities)

    @property
    def doubt_V(self) -> tuple[Along, Along]:
        """How far printing may put V off, linear and angular (n,). Rounded positions turn the Jacobian, too: by r/2 of
        every axis at most, at the speed all axes make together."""
        return Along(self._velocities, 1), Along(self._velocities, 2)

    @cached_property
    def _between(self) -> Pieces:
        rows = self.rows

        def make(a: int, b: int) -> tuple[Array, Array]:
            X, V, A = (values[a:b] for values in rows.hermite_motion)
            return carried(V, A, X, self.X_FT)

        return Pieces(len(INNER) * (len(rows.t) - 1), make, len(INNER))

    @property
    def inner_motion(self) -> tuple[Along, Along]:
        """TCP velocities and accelerations (m, 6) at the rows' hermite_places."""
        return Along(self._between), Along(self._between, 1)

    @cached_property
    def least_speed(self) -> Array:
        """Least TCP speed (n,) at the rows, m/s: the file's own, or mean speed to a neighbour less a h/2."""
        if self.rows.qd is not None:
            return self._small[3]
        return self._from_neighbours(self.path_lengths(1)[:], self.rows.plant.tcp.acceleration)

    @cached_property
    def least_turning(self) -> Array:
        """Least angular speed (n,) at the rows, rad/s."""
        if self.rows.qd is not None:
            return self._small[4]
        return self._from_neighbours(self.angles(1).pieces.whole()[0], angular_acceleration(self.rows))

    def _from_neighbours(self, path: Array, top: float) -> Array:
        h = np.diff(self.rows.t) + self.rows.unsure(slice(None, -1), slice(1, None))
        return both_sides(np.maximum(path / h - top * h / 2, 0.0)[:, None])[:, 0]

    @cached_property
    def stop_boxes(self) -> Boxes:
        """Around the positions in each block, with what is granted at a stop."""
        blocks, a = self.rows.blocks, self.rows.plant.tcp.acceleration
        granted = STOP_POSITION + a * blocks.most(self.rows.open_time) ** 2 / 2 + blocks.most(self.doubt_p)
        return blocks.boxes(self.p, granted + ROUNDING)

    @cached_property
    def way_boxes(self) -> Boxes:
        """Around the positions in each block, with how far the chords that begin there and the TCP may be from them."""
        chords = lengths(np.diff(self.p, axis=0))
        return replace(self.stop_boxes, room=self.rows.blocks.most(np.r_[self.reach + chords, 0.0]) + ROUNDING)

    @cached_property
    def reach(self) -> Array:
        """How far (n-1,) the TCP may be from the chords between rows, m: a h^2/8, and what printing leaves open."""
        sagitta = self.rows.plant.tcp.acceleration * self.rows.longest**2 / 8
        return np.asarray(sagitta + np.maximum(self.doubt_p[1:], self.doubt_p[:-1]))

    def path_lengths(self, lag: int) -> Along:
        """Least distance (n-lag,) between rows i and i + lag."""
        return self._over(self._lengths, lag, self._length)

    def angles(self, lag: int) -> Along:
        """Least angle (n-lag,) between rows i and i + lag."""
        return self._over(self._angles, lag, self._angle)

    def mean_speeds(self, lag: int) -> Along:
        """Least mean speeds (n-lag,) between rows i and i + lag."""
        return Along(self.path_lengths(lag).pieces, 1)

    def mean_turnings(self, lag: int) -> Along:
        """Least mean angular speeds (n-lag,) between rows i and i + lag."""
        return Along(self.angles(lag).pieces, 1)

    def _over(self, known: dict[int, Along], lag: int, between: Callable[[slice, slice], Array]) -> Along:
        t, unsure = self.rows.t, self.rows.unsure

        def make(a: int, b: int) -> tuple[Array, Array]:
            here, after = slice(a, b), slice(a + lag, b + lag)
            path = np.maximum(between(here, after), 0.0)
            return path, path / (t[after] - t[here] + unsure(here, after))

        if lag not in known:
            known[lag] = Along(Pieces(len(self.rows.t) - lag, make))
        return known[lag]

    def _length(self, i: slice, k: slice) -> Array:
        return np.asarray(lengths(self.p[k] - self.p[i]) - self.doubt_p[k] - self.doubt_p[i])

    def _angle(self, i: slice, k: slice) -> Array:
        return np.asarray(angle_between(self.R[i], self.R[k]) - self.doubt_R[k] - self.doubt_R[i])

    @cached_property
    def _lengths(self) -> dict[int, Along]:
        return {}

    @cached_property
    def _angles(self) -> dict[int, Along]:
        return {}

    def places(self, first: int, last: int) -> Places:
        """All there is to see from row first to row last: the rows, and the Hermite between them where it is exact."""
        rows, part = self.rows, slice(first, last + 1)
        at_rows = Places(rows.t[part], self.p[part], self.R[part], self.doubt_p[part], self.doubt_R[part])
        if not rows.exact or last <= first:
            return at_rows
        n = len(INNER)
        inner = slice(first * n, last * n)
        times, X = rows.hermite_places[0][inner], rows.hermite_motion[0][inner]
        linear, angular = (_dot(columns[first:last], rows.inner_doubt[first:last]) for columns in self.columns)
        return Places(
            _merged(at_rows.t, times),
            _merged(at_rows.p, X[:, :3, :3] @ self.X_FT[:3, 3] + X[:, :3, 3]),
            _merged(at_rows.R, X[:, :3, :3] @ self.X_FT[:3, :3]),
            _merged(at_rows.doubt_p, np.repeat(linear, n)),
            _merged(at_rows.doubt_angle, np.repeat(angular, n)),
        )


@dataclass(frozen=True, eq=False)
class Places:
    """A stretch of a TCP's motion: times (m,), positions (m, 3), rotations (m, 3, 3), and the doubt about both (m,)."""

    t: Array
    p: Array
    R: Array
    doubt_p: Array
    doubt_angle: Array


def _merged(at_rows: Array, inner: Array) -> Array:
    """What is known at rows (m, ...) and at the INNER places behind each but the last ((m - 1) n, ...), in order."""
    m, rest = len(at_rows), at_rows.shape[1:]
    between = np.concatenate([at_rows[:-1, None], inner.reshape(m - 1, len(INNER), *rest)], axis=1)
    return np.concatenate([between.reshape(-1, *rest), at_rows[-1:]])


def _dot(a: Array, b: Array) -> Array:
    """Products (n,) of vectors a and b (n, k)."""
    return np.asarray(np.einsum("ij,ij->i", a, b))


def angular_acceleration(rows: Rows) -> float:
    """More than the tool's angular acceleration where it hardly turns, rad/s2: all rotary axes at their limits."""
    names = rows.plant.limits.names
    return float(sum(a for name, a in zip(names, rows.accelerations.most, strict=True) if not slides(name)))


def shifted(J: Array, X_WF: Array, X_FT: Array) -> Array:
    """Jacobians (..., 6, k) at the TCP from those at the flange: v_T = v_F + omega x (p_T - p_F)."""
    lever = X_WF[..., :3, :3] @ X_FT[:3, 3]
    if not lever.any():
        return J
    out = np.array(J)
    out[..., :3, :] += np.cross(J[..., 3:, :], lever[..., None], axis=-2)
    return out


def carried(V: Array, A: Array, X_WF: Array, X_FT: Array) -> tuple[Array, Array]:
    """Velocities and accelerations (m, 6) at the TCP from those at the flange: a_T = a_F + alpha x r + omega x v_r."""
    lever = X_WF[:, :3, :3] @ X_FT[:3, 3]
    if not lever.any():
        return V, A
    omega, alpha = V[:, 3:], A[:, 3:]
    v_r = np.cross(omega, lever)
    a_r = np.cross(alpha, lever) + np.cross(omega, v_r)
    return np.hstack([V[:, :3] + v_r, omega]), np.hstack([A[:, :3] + a_r, alpha])
