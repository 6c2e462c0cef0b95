"""Polytopes around a surface: one, or several where it is hollow or bent, cut at planes where that saves most."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.shapes import DIRECTIONS, Polytope, polytope

_STEP = 1e-4  # m: numbers are rounded up to it
_MOST = 4  # bodies of a link
_WORTH = 0.8  # of a body's volume: two that have more together are no better than one
_CUTS = np.linspace(0.125, 0.875, 7)  # of a body's length along an axis of its link


def polytopes_around(name: str, triangles: Array) -> list[Polytope]:
    """Polytopes that together hold the solid inside triangles (m, 3, 3) [m]. Raises ValueError for a flat one."""
    parts = [(triangles, _around(name, triangles))]
    while len(parts) < _MOST:
        cuts = [(halves, i) for i, (part, whole) in enumerate(parts) if (halves := _halves(name, part, whole))]
        if not cuts:
            break
        saved = [volume(parts[i][1]) - sum(volume(body) for _, body in halves) for halves, i in cuts]
        halves, i = cuts[int(np.argmax(saved))]
        parts[i : i + 1] = halves
    return [body for _, body in parts]


def reach(body: Polytope) -> list[float]:
    """How far (26,) a polytope reaches in DIRECTIONS [m], as robots' files have it."""
    return _rounded(body.vertices)


def volume(body: Polytope) -> float:
    """[m3]"""
    a, b, c = np.moveaxis(body.vertices[body.triangles], 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def _around(name: str, triangles: Array) -> Polytope:
    return polytope(name, _rounded(triangles.reshape(-1, 3)))


def _rounded(points: Array) -> list[float]:
    far = (points @ DIRECTIONS.T).max(axis=0)
    return [float(one) + 0.0 for one in np.round(np.ceil(far / _STEP - 1e-4) * _STEP, 4)]


def _halves(name: str, part: Array, whole: Polytope) -> list[tuple[Array, Polytope]]:
    """The part cut in two where their bodies have least volume; nothing where that is no gain."""
    best: list[tuple[Array, Polytope]] = []
    least = _WORTH * volume(whole)
    for n, c in _planes(part):
        sides = [_clipped(part, n, c), _clipped(part, -n, -c)]
        try:
            halves = [(side, _around(name, side)) for side in sides if len(side)]
        except ValueError:  # one is flat
            continue
        if len(halves) == 2 and (found := sum(volume(body) for _, body in halves)) < least:
            best, least = halves, found
    return best


def _planes(part: Array) -> Iterator[tuple[Array, float]]:
    low, high = part.min(axis=(0, 1)), part.max(axis=(0, 1))
    for k, n in enumerate(np.eye(3)):
        for share in _CUTS:
            yield n, float(low[k] + share * (high[k] - low[k]))


def _clipped(triangles: Array, n: Array, c: float) -> Array:
    """What of triangles (m, 3, 3) lies where n @ p <= c."""
    s = triangles @ n - c
    inside = s <= 0
    out = [triangles[inside.all(axis=1)]]
    for lone in (True, False):  # one corner inside, or one outside: it comes first
        some = np.flatnonzero(inside.sum(axis=1) == (1 if lone else 2))
        order = (np.argmax(inside[some] == lone, axis=1)[:, None] + np.arange(3)) % 3
        p, d = triangles[some[:, None], order], s[some[:, None], order]
        on = [p[:, 0] + (p[:, k] - p[:, 0]) * (d[:, 0] / (d[:, 0] - d[:, k]))[:, None] for k in (1, 2)]
        kept = [(p[:, 0], *on)] if lone else [(p[:, 1], p[:, 2], on[0]), (p[:, 2], on[1], on[0])]
        out += [np.stack(corners, axis=1) for corners in kept]
    return np.concatenate(out)
