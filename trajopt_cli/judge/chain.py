"""Poses, Jacobians and motion of a chain of joints at many rows at once, from the placements and axes that pin read.

Every joint has a frame of its own here whose z is the joint's axis. Along rows a vector is (3, n), a rotation its three
columns: no row depends on how many are looked at together.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array

_AT_ONCE = 2048  # rows: what is worked out of them stays near the processor

Vectors = list[Array]  # (3, n) each: the columns x, y, z of a rotation, then a position


@dataclass(frozen=True, eq=False)
class Joint:
    """Its place X (4, 4) behind the joint before it at 0, and the axis (3,) that it turns about or, where it slides,
    moves along."""

    X: Array
    axis: Array
    slides: bool


@dataclass(frozen=True, eq=False)
class _Place:
    """Where a frame stands in another: rotation R (3, 3), position p (3,)."""

    R: Array
    p: Array

    def seen_from(self, x: Array, y: Array, z: Array, p: Array) -> Vectors:
        """The frame in the world, from the other one there."""
        return [*(_sum(column, (x, y, z)) for column in self.R.T), _sum([*self.p, 1.0], (x, y, z, p))]


def _sum(weights: Sequence[float] | Array, vectors: Sequence[Array]) -> Array:
    """The weighted sum of vectors (3, n) in their order; of a single one with weight 1 itself."""
    out: Array | None = None
    for weight, vector in zip(weights, vectors, strict=True):
        if weight != 0.0:
            part = vector if weight == 1.0 else vector * weight
            out = part if out is None else out + part
    return np.zeros_like(vectors[0]) if out is None else out


class KinematicChain:
    """k joints, each behind the one before it, the first in the world; and the flange at X (4, 4) behind the last."""

    def __init__(self, joints: Sequence[Joint], X: Array):
        own = [np.eye(3), *(_with_z(joint.axis) for joint in joints)]
        frames = [*((joint.X, R) for joint, R in zip(joints, own[1:], strict=True)), (X, np.eye(3))]
        self._places = [
            _Place(before.T @ X[:3, :3] @ R, before.T @ X[:3, 3]) for before, (X, R) in zip(own, frames, strict=True)
        ]
        self._slides = [joint.slides for joint in joints]
        self._sliding = [i for i, slides in enumerate(self._slides) if slides]
        # the joints whose arm to the next frame has a length
        beyond = [*self._slides[1:], True]
        self._far = [i for i, slides in enumerate(beyond) if slides or self._places[i + 1].p.any()]

    def flange(self, q: Array) -> tuple[Array, Array]:
        """Flange poses (n, 4, 4) and Jacobians (n, 6, k) in world axes, linear rows first, at q (n, k)."""
        X, J = _poses(len(q)), np.empty((len(q), 6, q.shape[1]))
        for part in _batches(len(q)):
            frames = self._placed(q[part], X[part])
            z, p = (np.stack([frame[i] for frame in frames[:-1]]) for i in (2, 3))
            linear = _cross(z, frames[-1][3] - p)
            linear[self._sliding], z[self._sliding] = z[self._sliding], 0.0
            J[part, :3], J[part, 3:] = linear.transpose(2, 1, 0), z.transpose(2, 1, 0)
        return X, J

    def motion(self, q: Array, qd: Array, qdd: Array) -> tuple[Array, Array, Array]:
        """Flange poses (n, 4, 4), velocities and accelerations (n, 6) of its origin in world axes, linear first.

        What a joint carries turns with w and a about its origin: its arm r to the next one adds w x r and
        a x r + w x (w x r). A joint that slides adds its own speed v and acceleration, and 2 w x v.
        """
        X, V, A = _poses(len(q)), np.empty((len(q), 6)), np.empty((len(q), 6))
        for part in _batches(len(q)):
            frames = self._placed(q[part], X[part])
            z = np.stack([frame[2] for frame in frames[:-1]])
            w, a = (z * np.ascontiguousarray(x[part].T)[:, None] for x in (qd, qdd))
            slid = [(i, w[i].copy(), a[i].copy()) for i in self._sliding]
            w[self._sliding], a[self._sliding] = 0.0, 0.0
            spin = w.copy()
            _add_up(w)
            a += _cross(w, spin)
            _add_up(a)
            arms = np.stack([frames[i + 1][3] - frames[i][3] for i in self._far])
            w_far = w[self._far]
            rates = _cross(w_far, arms)
            v, pull = rates.sum(axis=0), (_cross(a[self._far], arms) + _cross(w_far, rates)).sum(axis=0)
            for i, speed, change in slid:
                v += speed
                pull += change + 2 * _cross(w[i], speed)
            V[part], A[part] = np.concatenate([v, w[-1]]).T, np.concatenate([pull, a[-1]]).T
        return X, V, A

    def _placed(self, q: Array, X: Array) -> list[Vectors]:
        """The frames of all joints and of the flange at q (n, k); its poses are written to X (n, 4, 4)."""
        frame: Vectors = [*np.eye(3)[:, :, None] * np.ones(len(q)), np.zeros((3, len(q)))]
        sine, cosine = np.sin(q.T), np.cos(q.T)
        out = []
        for i, (place, slides) in enumerate(zip(self._places[:-1], self._slides, strict=True)):
            x, y, z, p = place.seen_from(*frame)
            if slides:
                p = p + z * q[:, i]
            else:
                x, y = x * cosine[i] + y * sine[i], y * cosine[i] - x * sine[i]
            out.append(frame := [x, y, z, p])
        out.append(self._places[-1].seen_from(*frame))
        for i, vector in enumerate(out[-1]):
            X[:, :3, i] = vector.T
        return out


def _with_z(axis: Array) -> Array:
    """A rotation (3, 3) whose third column is a unit vector; for an axis of the frame its axes in another order."""
    x = np.eye(3)[(int(np.argmax(np.abs(axis))) + 1) % 3]
    x = x - axis * (axis @ x)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(axis, x), axis], axis=1)


def _batches(n: int) -> Iterator[slice]:
    yield from (slice(i, i + _AT_ONCE) for i in range(0, n, _AT_ONCE))


def _poses(n: int) -> Array:
    """Room for poses (n, 4, 4)."""
    X = np.zeros((n, 4, 4))
    X[:, 3, 3] = 1.0
    return X


def _add_up(x: Array) -> None:
    """To each of x (k, ...) all that is before it."""
    for i in range(1, len(x)):
        x[i] += x[i - 1]


def _cross(a: Array, b: Array) -> Array:
    """a x b (..., 3, n)."""
    out = np.empty_like(a)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(a[..., j, :], b[..., k, :], out=out[..., i, :])
        out[..., i, :] -= a[..., k, :] * b[..., j, :]
    return out
