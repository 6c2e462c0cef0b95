"""How near two placed bodies are and where, for many placings at once: what the planner asks.

Capsules against capsules and boxes by closed forms over arrays, all other pairs by coal, one placing at a time: those
that `closer` leaves. The judge measures by `pair`, which shares with this what a mesh is (`meshes`), and coal.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import coal  # type: ignore[import-untyped]
import numpy as np

from trajopt_cli.geometry import Array, IndexArray, inverse_pose
from trajopt_cli.proximity.meshes import coal_geometry, convex, inside, with_z
from trajopt_cli.shapes import Box, Capsule, Mesh, Polytope, Shape, outline

_NONE = 1e-12  # m: a length that has no direction
WORLD = -1
_BOX, _CAPSULE, _OTHER = range(3)
_PAIRS = np.array([*combinations(range(6), 2)])


@dataclass(frozen=True, eq=False)
class Nearest:
    """Where two bodies come nearest in k placings, in the world: the distance [m], below zero where they overlap (no
    deeper than they do); points (k, 3) on each; the unit normal (k, 3) from the second to the first."""

    distance: Array
    on_a: Array
    on_b: Array
    normal: Array

    @classmethod
    def empty(cls, k: int) -> Nearest:
        """To be filled in."""
        return cls(np.empty(k), np.empty((k, 3)), np.empty((k, 3)), np.empty((k, 3)))

    def put(self, at: IndexArray, other: Nearest) -> None:
        """Fill some in."""
        self.distance[at], self.on_a[at], self.on_b[at] = other.distance, other.on_a, other.on_b
        self.normal[at] = other.normal


class NearPairs:
    """P pairs of shapes, each with the number of the frame that carries it, the second also with WORLD for none. Frames
    are placed at X (m, F, 4, 4) in the world, in m ways."""

    def __init__(self, pairs: Sequence[tuple[Shape, int, Shape, int]]):
        self._pairs = [*pairs]
        self._a = np.array([frame for _, frame, _, _ in pairs], dtype=np.intp)
        self._b = np.array([frame for _, _, _, frame in pairs], dtype=np.intp)
        balls = [_ball(a) for a, _, _, _ in pairs]
        boxes = [rounded_box(b) for _, _, b, _ in pairs]
        firsts = {(id(a), frame): i for i, (a, frame, _, _) in enumerate(pairs)}
        number = {key: j for j, key in enumerate(firsts)}
        self._ball = np.array([number[id(a), frame] for a, frame, _, _ in pairs], dtype=np.intp)  # of each pair
        self._ball_frame = np.array([frame for _, frame in firsts], dtype=np.intp)
        self._centre = np.array([balls[i][0] for i in firsts.values()]).reshape(-1, 3, 1)
        self._X_SB = np.array([X for X, _, _ in boxes]).reshape(-1, 4, 4)
        self._X_BS = inverse_pose(self._X_SB)
        self._half = np.array([half for _, half, _ in boxes]).reshape(-1, 3)
        self._round = np.array([radius for _, _, radius in boxes])
        self._grown = np.array([radius for _, radius in balls]) + self._round
        self._apart, self._joined = np.flatnonzero(self._b == WORLD), np.flatnonzero(self._b != WORLD)
        closed = [isinstance(a, Capsule) and not isinstance(b, Mesh) for a, _, b, _ in pairs]
        boxed = [isinstance(b, Box) for _, _, b, _ in pairs]
        self._kind = np.where(closed, np.where(boxed, _BOX, _CAPSULE), _OTHER).astype(np.int8)
        none = np.zeros(3)
        # a segment with a radius around the first body: of a polytope its outer capsule
        around = [outline(a) if isinstance(a, Capsule | Polytope) else (np.zeros((2, 3)), 0.0) for a, *_ in pairs]
        self._held = np.array([radius > 0 for _, radius in around], dtype=bool) & (self._kind == _OTHER)
        self._ends = np.array([ends for ends, _ in around])
        self._radius = np.array([radius for _, radius in around])
        self._others = np.array([(b.a, b.b) if isinstance(b, Capsule) else (none, none) for *_, b, _ in pairs])
        self._coal: dict[int, _Coal] = {}

    def bound(self, X: Array) -> Array:
        """No more than the distances (m, P): of balls around the first bodies from rounded boxes around the second."""
        X_WA = X[:, self._ball_frame]
        centre = (X_WA[..., :3, :3] @ self._centre)[..., 0] + X_WA[..., :3, 3]
        outside = np.empty((len(X), len(self._ball), 3))
        if len(self._apart):
            R, t = self._X_SB[self._apart, :3, :3], self._X_SB[self._apart, :3, 3]
            in_all = centre.reshape(-1, 3) @ R.reshape(-1, 3).T  # of every ball in every box
            in_all = in_all.reshape(len(X), len(self._ball_frame), len(self._apart), 3)
            p = in_all[:, self._ball[self._apart], np.arange(len(self._apart))]
            outside[:, self._apart] = np.abs(p + t) - self._half[self._apart]
        if len(self._joined):
            X_WB = X[:, self._b[self._joined]]
            p = (centre[:, self._ball[self._joined]] - X_WB[..., :3, 3])[..., None, :] @ X_WB[..., :3, :3]
            R, t = self._X_SB[self._joined, :3, :3], self._X_SB[self._joined, :3, 3]
            outside[:, self._joined] = np.abs((p @ np.swapaxes(R, 1, 2))[..., 0, :] + t) - self._half[self._joined]
        over = np.maximum(outside, 0.0)
        apart = np.sqrt(np.einsum("mpi,mpi->mp", over, over)) + np.minimum(outside.max(axis=2), 0.0)
        return np.asarray(apart - self._grown)

    def closer(self, X: Array, limits: Array, bound: Array | None = None) -> tuple[IndexArray, IndexArray]:
        """Rows and pairs (k,) of all placings that may be nearer than limits (P,) or (m, P) [m]: by `bound`, where the
        caller has it, then by capsules around first bodies and boxes around second ones."""
        limits = np.broadcast_to(limits, (len(X), len(self._pairs)))
        rows, pairs = np.nonzero((self.bound(X) if bound is None else bound) < limits)
        some = np.flatnonzero(self._held[pairs])
        if len(some):
            boxes = self._from_boxes(X, rows[some], pairs[some]).distance - self._round[pairs[some]]
            far = some[boxes >= limits[rows[some], pairs[some]]]
            rows, pairs = np.delete(rows, far), np.delete(pairs, far)
        return rows, pairs

    def nearest(self, X: Array, rows: IndexArray, pairs: IndexArray, points: bool = True) -> Nearest:
        """Where pairs (k,) come nearest in rows (k,) of the placings; points False: distances alone, of the rest
        nothing is sure."""
        out, kind = Nearest.empty(len(rows)), self._kind[pairs]
        for which, find in ((_BOX, self._from_boxes), (_CAPSULE, self._from_capsules)):
            if len(at := np.flatnonzero(kind == which)):
                out.put(at, find(X, rows[at], pairs[at]))
        if len(at := np.flatnonzero(kind == _OTHER)):
            out.put(at, self._by_coal(X, rows[at], pairs[at], points))
        return out

    def _from_boxes(self, X: Array, rows: IndexArray, pairs: IndexArray) -> Nearest:
        X_WB = self._X_BS[pairs]
        if (self._b[pairs] != WORLD).any():
            X_WB = self._frames(X, rows, pairs) @ X_WB
        R, t = X_WB[:, :3, :3], X_WB[:, :3, 3]
        a, b = (np.einsum("kji,kj->ki", R, end - t) for end in self._segment(X, rows, pairs))
        p, on, away = (np.asarray(x) for x in _segment_and_box(a, b, self._half[pairs]))
        p, on = (np.einsum("kij,kj->ki", R, x) + t for x in (p, on))
        away = np.einsum("kij,kj->ki", R, away)
        radius = self._radius[pairs]
        return Nearest(np.einsum("ij,ij->i", p - on, away) - radius, p - radius[:, None] * away, on, away)

    def _from_capsules(self, X: Array, rows: IndexArray, pairs: IndexArray) -> Nearest:
        a, b = self._segment(X, rows, pairs)
        X_WB = self._frames(X, rows, pairs)
        c, d = (np.einsum("kij,kj->ki", X_WB[:, :3, :3], self._others[pairs, i]) + X_WB[:, :3, 3] for i in (0, 1))
        p, on, away = _segments(a, b, c, d)
        r_a, r_b = self._radius[pairs], self._round[pairs]
        distance = np.einsum("ij,ij->i", p - on, away) - r_a - r_b
        return Nearest(distance, p - r_a[:, None] * away, on + r_b[:, None] * away, away)

    def _by_coal(self, X: Array, rows: IndexArray, pairs: IndexArray, points: bool) -> Nearest:
        for number in np.unique(pairs).tolist():
            if number not in self._coal:
                self._coal[number] = _Coal(self._pairs[number][0], self._pairs[number][2])
        of = [self._coal[number] for number in pairs.tolist()]
        X_WB = self._frames(X, rows, pairs)
        X_BA = inverse_pose(X_WB) @ X[rows, self._a[pairs]]
        found = _by_coal(of, X_BA, points)
        if points:
            R, t = X_WB[:, :3, :3], X_WB[:, :3, 3]
            on_a, on_b = (np.einsum("kij,kj->ki", R, x) + t for x in (found.on_a, found.on_b))
            found = Nearest(found.distance, on_a, on_b, np.einsum("kij,kj->ki", R, found.normal))
        return found

    def _segment(self, X: Array, rows: IndexArray, pairs: IndexArray) -> list[Array]:
        """Both ends (k, 3) of the first bodies in the world."""
        X_WA = X[rows, self._a[pairs]]
        return [np.einsum("kij,kj->ki", X_WA[:, :3, :3], self._ends[pairs, i]) + X_WA[:, :3, 3] for i in (0, 1)]

    def _frames(self, X: Array, rows: IndexArray, pairs: IndexArray) -> Array:
        """Where (k, 4, 4) the second bodies' frames are."""
        frames = self._b[pairs]
        return np.where((frames == WORLD)[:, None, None], np.eye(4), X[rows, np.maximum(frames, 0)])


def _ball(shape: Shape) -> tuple[Array, float]:
    """Centre (3,) and radius [m] of a ball around a shape."""
    points, radius = outline(shape)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return centre, float(np.linalg.norm(points - centre, axis=1).max()) + radius


def rounded_box(shape: Shape) -> tuple[Array, Array, float]:
    """X_SB (4, 4) of the frame in which a box of half lengths (3,) grown by a radius [m] holds the shape."""
    X = np.eye(4)
    if isinstance(shape, Capsule):
        along = shape.b - shape.a
        length = float(np.linalg.norm(along))
        X[:3, :3] = with_z(along / length if length > _NONE else np.array([0.0, 0.0, 1.0]))
        X[:3, 3] = (shape.a + shape.b) / 2
        half, radius = np.array([0.0, 0.0, length / 2]), shape.radius
    else:
        points, radius = outline(shape)
        X = np.array(shape.X)
        own = (points - X[:3, 3]) @ X[:3, :3]
        if isinstance(shape, Polytope):
            own, radius = shape.vertices, 0.0
        X[:3, 3] += X[:3, :3] @ (own.min(axis=0) + own.max(axis=0)) / 2
        half = np.ptp(own, axis=0) / 2
    inverse = np.eye(4)
    inverse[:3, :3] = X[:3, :3].T
    inverse[:3, 3] = -X[:3, :3].T @ X[:3, 3]
    return inverse, half, radius


def _unit(v: Array, instead: Array) -> Array:
    """Directions (m, 3) of v (m, 3), or of what stands instead where it has none."""
    length = np.linalg.norm(v, axis=1, keepdims=True)
    some = np.linalg.norm(instead, axis=1, keepdims=True)
    other = np.where(some > _NONE, instead / np.maximum(some, _NONE), [0.0, 0.0, 1.0])
    return np.asarray(np.where(length > _NONE, v / np.maximum(length, _NONE), other))


def _segments(a: Array, b: Array, c: Array, d: Array) -> tuple[Array, Array, Array]:
    """The nearest points (k, 3) of segments ab and cd, and the direction from the second to the first."""
    u, v, w = b - a, d - c, a - c
    uu, vv, uv, uw, vw = (np.einsum("ij,ij->i", x, y) for x, y in ((u, u), (v, v), (u, v), (u, w), (v, w)))
    det = uu * vv - uv**2
    skew = det > _NONE * np.maximum(uu * vv, _NONE**2)
    s = np.where(skew, np.clip((uv * vw - uw * vv) / np.where(skew, det, 1.0), 0.0, 1.0), 0.0)
    t = np.where(vv > _NONE**2, np.clip((uv * s + vw) / np.maximum(vv, _NONE**2), 0.0, 1.0), 0.0)
    s = np.where(uu > _NONE**2, np.clip((uv * t - uw) / np.maximum(uu, _NONE**2), 0.0, 1.0), 0.0)
    p, on = a + s[:, None] * u, c + t[:, None] * v
    return p, on, _unit(p - on, np.cross(u, v))


def _segment_and_box(a: Array, b: Array, half: Array) -> tuple[Array, Array, Array]:
    """The point (k, 3) of segments ab nearest to boxes about the origin of half lengths (k, 3), or deepest in them; the
    point of the box' surface there, and the direction out of the box."""
    d = b - a
    with np.errstate(divide="ignore", invalid="ignore"):
        knots = np.concatenate([(half - a) / d, (-half - a) / d], axis=1)
    knots = np.sort(np.concatenate([np.zeros((len(a), 1)), np.clip(np.nan_to_num(knots), 0, 1), np.ones((len(a), 1))],
                                   axis=1), axis=1)  # fmt: skip
    # half the slope of the squared distance, which is convex and a parabola between two knots
    at = a[:, None] + knots[..., None] * d[:, None]
    slope = np.einsum("mki,mi->mk", at - np.clip(at, -half[:, None], half[:, None]), d)
    rows = np.arange(len(a))
    k = np.argmax(slope >= 0, axis=1)
    k = np.where((slope >= 0).any(axis=1), k, knots.shape[1] - 1)
    before = np.maximum(k - 1, 0)
    s_0, s_1, t_0, t_1 = slope[rows, before], slope[rows, k], knots[rows, before], knots[rows, k]
    share = np.where(s_1 > s_0, -s_0 / np.where(s_1 > s_0, s_1 - s_0, 1.0), 1.0)
    p = a + (t_0 + np.clip(share, 0.0, 1.0) * (t_1 - t_0))[:, None] * d
    on = np.clip(p, -half, half)
    away = _unit(p - on, np.ones_like(p))
    within = np.flatnonzero(np.abs(p - on).max(axis=1) < _NONE)
    if len(within):
        p[within], on[within], away[within] = _deepest(a[within], d[within], half[within])
    return p, on, away


def _deepest(a: Array, d: Array, half: Array) -> tuple[Array, Array, Array]:
    """The point of segments a + t d that lies deepest under the faces of a box, the point on the nearest face, and that
    face's normal: the greatest of six straight lines over t is least at an end or where two of them cross."""
    height = np.concatenate([a, -a], axis=1) - np.concatenate([half, half], axis=1)
    rise = np.concatenate([d, -d], axis=1)
    one, two = _PAIRS.T
    with np.errstate(divide="ignore", invalid="ignore"):
        cross = -(height[:, one] - height[:, two]) / (rise[:, one] - rise[:, two])
    ends = np.tile([0.0, 1.0], (len(a), 1))
    t = np.clip(np.nan_to_num(np.concatenate([ends, cross], axis=1), posinf=1.0, neginf=0.0), 0.0, 1.0)
    top = (height[:, None] + t[..., None] * rise[:, None]).max(axis=2)
    rows = np.arange(len(a))
    t_best = t[rows, np.argmin(top, axis=1)]
    p = a + t_best[:, None] * d
    face: IndexArray = np.argmax(height + t_best[:, None] * rise, axis=1)
    away = np.concatenate([np.eye(3), -np.eye(3)])[face]
    above = (height + t_best[:, None] * rise)[rows, face]
    return p, p - above[:, None] * away, away


class _Coal:
    """A pair for coal."""

    def __init__(self, a: Shape, b: Shape):
        # ComputeDistance holds bare pointers to both geometries
        (self._geometry_a, self.X_a), (self._geometry_b, X_b) = coal_geometry(a), coal_geometry(b)
        self.distance = coal.ComputeDistance(self._geometry_a, self._geometry_b)
        self.T_b = coal.Transform3s()
        self.T_b.setTransform(X_b[:3, :3].copy(), X_b[:3, 3].copy())
        self.middle = outline(a)[0].mean(axis=0)
        self.hollow = b if isinstance(b, Mesh) and convex(b) is None else None


def _by_coal(of: Sequence[_Coal], X_BA: Array, points: bool) -> Nearest:
    """Pairs (k,) in the frames of their second bodies, the first ones at X_BA (k, 4, 4); points as in `nearest`."""
    request, result, T_a = coal.DistanceRequest(points, 0.0, 0.0), coal.DistanceResult(), coal.Transform3s()
    request.enable_signed_distance = True
    X = X_BA @ np.array([pair.X_a for pair in of])
    R, t = np.ascontiguousarray(X[:, :3, :3]), np.ascontiguousarray(X[:, :3, 3])
    out = Nearest.empty(len(of))
    distance, on_a, on_b, normal = out.distance, out.on_a, out.on_b, out.normal
    place, clear = T_a.setTransform, result.clear
    for i, pair in enumerate(of):
        place(R[i], t[i])
        clear()
        distance[i] = pair.distance(T_a, pair.T_b, request, result)
        if points:
            on_a[i], on_b[i], normal[i] = result.getNearestPoint1(), result.getNearestPoint2(), result.normal
    if points:
        normal *= -1
        apart = np.abs(distance) > 1e-6
        normal[apart] = _unit(((on_a - on_b) * np.sign(distance)[:, None])[apart], normal[apart])
    for i in np.flatnonzero([pair.hollow is not None for pair in of] & (distance > 0)).tolist():
        mesh = of[i].hollow
        assert mesh is not None
        if inside(mesh, (X_BA[i, :3, :3] @ of[i].middle + X_BA[i, :3, 3])[None])[0]:
            distance[i] *= -1
            normal[i] *= -1
    return out
