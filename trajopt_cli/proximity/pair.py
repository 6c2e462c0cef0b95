"""The signed distance of two bodies, built once and asked for many placings."""

from __future__ import annotations

import coal  # type: ignore[import-untyped]
import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.proximity.meshes import coal_geometry, convex, inside
from trajopt_cli.shapes import Box, Capsule, Mesh, Shape


class Pair:
    """Two shapes; every question places both. Distances in m, negative where the shapes overlap: then minus the depth.

    Against a mesh that is not convex the depth is that in its surface, at most the size of the other body.
    """

    def __init__(self, a: Shape, b: Shape):
        self.a, self.b = a, b
        # Kept here too: coal.ComputeDistance holds bare pointers to both.
        (self._geometry_a, self._X_a), (self._geometry_b, self._X_b) = coal_geometry(a), coal_geometry(b)
        self._compute = coal.ComputeDistance(self._geometry_a, self._geometry_b)
        self._request = coal.DistanceRequest(False, 0.0, 0.0)
        # A request built from arguments measures overlaps without depth (0 instead of -0.3 m) unless told so.
        self._request.enable_signed_distance = True
        self._result = coal.DistanceResult()
        self._T_a, self._T_b = coal.Transform3s(), coal.Transform3s()

    def distances(self, X_BA: Array, solid: bool = True) -> Array:
        """Distances (n,) of a placed at X_BA (n, 4, 4) in the frame of b.

        solid False: a mesh that is not convex is its surface alone, positive inside; looking inside costs a glance at
        every triangle.
        """
        X = X_BA @ self._X_a
        self._T_b.setTransform(self._X_b[:3, :3].copy(), self._X_b[:3, 3].copy())
        R, p = np.ascontiguousarray(X[:, :3, :3]), np.ascontiguousarray(X[:, :3, 3])
        compute, place, request, result = self._compute, self._T_a.setTransform, self._request, self._result
        out = np.empty(len(X))
        for i in range(len(X)):
            place(R[i], p[i])
            result.clear()  # else it keeps the least distance of all questions before
            out[i] = compute(self._T_a, self._T_b, request, result)
        if not np.isfinite(out).all():
            raise ArithmeticError(f"no distance of '{self.a.name}' and '{self.b.name}' placed at {X_BA}")
        return self._inside(X_BA, out) if solid else out

    def distance(self, X_WA: Array, X_WB: Array) -> float:
        """Distance of a at X_WA and b at X_WB, (4, 4) each."""
        return float(self.distances((np.linalg.inv(X_WB) @ X_WA)[None])[0])

    def nearest(self, X_WA: Array, X_WB: Array) -> tuple[Array, Array]:
        """The nearest points (3,) of a and of b in the world; where they overlap, the deepest ones."""
        self.distances((np.linalg.inv(X_WB) @ X_WA)[None])
        p_a, p_b = (np.asarray(point()) for point in (self._result.getNearestPoint1, self._result.getNearestPoint2))
        return X_WB[:3, :3] @ p_a + X_WB[:3, 3], X_WB[:3, :3] @ p_b + X_WB[:3, 3]

    def _inside(self, X_BA: Array, surface: Array) -> Array:
        """surface distances, negative where one shape lies inside the other's mesh without touching its surface."""
        out = surface
        for mesh, other, turned in ((self.b, self.a, False), (self.a, self.b, True)):
            if isinstance(mesh, Mesh) and convex(mesh) is None:
                X = np.linalg.inv(X_BA) if turned else X_BA
                points = X[:, :3, :3] @ _some_point(other) + X[:, :3, 3]
                apart = np.flatnonzero(out > 0)
                out[apart[inside(mesh, points[apart])]] *= -1
        return out


def _some_point(shape: Shape) -> Array:
    """A point (3,) of the shape, in the frame it is given in."""
    match shape:
        case Box():
            return np.asarray(shape.X[:3, 3])
        case Capsule():
            return np.asarray(shape.a)
        case Mesh():
            return np.asarray(shape.X[:3, :3] @ shape.vertices[shape.triangles[0, 0]] + shape.X[:3, 3])
