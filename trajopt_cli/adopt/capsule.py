"""The smallest capsule around points that a short search finds: rounded outward, the same for the same points."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from trajopt_cli.geometry import Array
from trajopt_cli.shapes import Capsule

_STEP = 1e-4  # m: what ends and radius are rounded to
_LEAST = 1e-3  # m: a plate's or a wire's radius
_WIDER = (1.0, 1.05, 1.15, 1.3)  # of the narrowest tube: a wider one may be shorter


def smallest_capsule(name: str, points: Array) -> Capsule:
    """A capsule that holds all points (n, 3) [m]: the best of a search over directions and radii, by its volume."""
    corners = _hull(points)
    middle = corners.mean(axis=0)
    corners = corners - middle
    best = min((_along(corners, direction) for direction in _directions(corners)), key=capsule_volume)
    turn = 0.35  # rad
    while turn > 1e-3:
        axis = _direction(best)
        sides = np.linalg.svd(axis[None])[2][1:]
        around = (axis + np.tan(turn) * (c * sides[0] + s * sides[1]) for c, s in ((1, 0), (-1, 0), (0, 1), (0, -1)))
        found = min(
            (_along(corners, direction / np.linalg.norm(direction)) for direction in around), key=capsule_volume
        )
        if capsule_volume(found) < capsule_volume(best) * (1 - 1e-6):
            best = found
        else:
            turn /= 2
    a, b = (np.round((end + middle) / _STEP) * _STEP for end in (best.a, best.b))
    radius = max(_reach(corners + middle, a, b), _LEAST)
    return Capsule(name, a + 0.0, b + 0.0, float(np.ceil(radius / _STEP - 1e-9) * _STEP))


def _hull(points: Array) -> Array:
    """The points that matter; all of them where they lie in a plane."""
    points = np.unique(points, axis=0)
    if len(points) < 5:
        return points
    try:
        return np.asarray(points[np.sort(ConvexHull(points).vertices)])
    except QhullError:
        return points


def _directions(corners: Array) -> Array:
    """Where the search begins: the coordinate axes, the diagonals between them, the points' own main axes."""
    grid = np.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)], dtype=np.float64)[14:]
    own = np.linalg.svd(corners, full_matrices=False)[2] if len(corners) > 2 else np.empty((0, 3))
    directions = np.vstack([grid, own])
    return np.asarray(directions / np.linalg.norm(directions, axis=1, keepdims=True))


def _direction(capsule: Capsule) -> Array:
    along = capsule.b - capsule.a
    length = float(np.linalg.norm(along))
    return along / length if length > 1e-9 else np.array([0.0, 0.0, 1.0])


def capsule_volume(capsule: Capsule) -> float:
    """[m3]"""
    length = float(np.linalg.norm(capsule.b - capsule.a))
    return np.pi * capsule.radius**2 * (length + 4 / 3 * capsule.radius)


def _along(corners: Array, direction: Array) -> Capsule:
    """The smallest capsule whose axis has this direction, of a few radii from that of the narrowest tube on."""
    sides = np.linalg.svd(direction[None])[2][1:]
    flat = corners @ sides.T
    centre, narrow = smallest_circle(flat)
    aside2 = ((flat - centre) ** 2).sum(axis=1)
    t = corners @ direction
    found = []
    for wider in _WIDER:
        radius = max(narrow * wider, _LEAST)
        cap = np.sqrt(np.maximum(radius**2 - aside2, 0.0))
        low, high = float((t + cap).min()), float((t - cap).max())
        if low > high:
            low = high = (low + high) / 2
        a, b = (centre @ sides + end * direction for end in (low, high))
        found.append(Capsule("", a, b, radius))
    return min(found, key=capsule_volume)


def _reach(points: Array, a: Array, b: Array) -> float:
    """The greatest distance of points (n, 3) from the segment a b."""
    along = b - a
    square = float(along @ along)
    t = np.clip((points - a) @ along / square, 0, 1) if square > 0 else np.zeros(len(points))
    return float(np.linalg.norm(points - a - t[:, None] * along, axis=1).max())


def smallest_circle(points: Array) -> tuple[Array, float]:
    """Centre (2,) and radius of the smallest circle around points (n, 2): the farthest point outside joins the at
    most three that hold it, and the circle grows with every step (Gaertner's pivoting)."""
    slack = 1e-12 * (1 + float(np.abs(points).max()))
    held = [int(np.argmax(np.hypot(*(points - points.mean(axis=0)).T)))]
    centre, radius = points[held[0]], 0.0
    for _ in range(10 * len(points) + 10):
        away = np.hypot(*(points - centre).T)
        i = int(np.argmax(away))
        if away[i] <= radius + slack:
            break
        centre, radius, held = _circle_of(points, [*held, i])
    return np.asarray(centre), radius


def _circle_of(points: Array, held: list[int]) -> tuple[Array, float, list[int]]:
    """The smallest circle around at most four points, and those that hold it."""
    best: tuple[Array, float, list[int]] | None = None
    sets = [[i, j] for n, i in enumerate(held) for j in held[:n]]
    sets += [[i, j, k] for n, i in enumerate(held) for m, j in enumerate(held[:n]) for k in held[:m]]
    for chosen in sets:
        centre = _centre(points[chosen])
        if centre is None:
            continue
        radius = float(np.hypot(*(points[chosen] - centre).T).max())
        around = np.hypot(*(points[held] - centre).T).max() <= radius * (1 + 1e-9) + 1e-15
        if around and (best is None or radius < best[1]):
            best = centre, radius, chosen
    if best is None:  # points in one place
        return points[held[-1]], 0.0, held[-1:]
    return best


def _centre(points: Array) -> Array | None:
    """Of the circle through two points as its diameter, or through three; None for three in a row."""
    if len(points) == 2:
        return np.asarray((points[0] + points[1]) / 2)
    a, b = points[1] - points[0], points[2] - points[0]
    cross = 2 * (a[0] * b[1] - a[1] * b[0])
    if abs(cross) < 1e-18:
        return None
    u = np.array([b[1] * (a @ a) - a[1] * (b @ b), a[0] * (b @ b) - b[0] * (a @ a)]) / cross
    return np.asarray(points[0] + u)
