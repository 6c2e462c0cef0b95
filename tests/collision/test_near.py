"""Many distances at once against coal, one by one, and against their own nearest points."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.proximity.near import WORLD, NearPairs
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import Box, Capsule, Mesh, Shape

CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2.0
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


def some_pose(rng: np.random.Generator, far: float) -> Array:
    axis = rng.normal(size=3)
    return pose(rotation_about(axis / np.linalg.norm(axis), rng.uniform(-3, 3)), rng.uniform(-far, far, 3))


def some_shape(rng: np.random.Generator, kind: str) -> Shape:
    if kind == "capsule":
        return Capsule("c", *rng.uniform(-0.3, 0.3, (2, 3)), rng.uniform(0.01, 0.2))
    if kind == "ball":
        a = rng.uniform(-0.3, 0.3, 3)
        return Capsule("s", a, a, rng.uniform(0.01, 0.2))
    size, X = rng.uniform(0.05, 0.6, 3), some_pose(rng, 0.2)
    return Box("b", size, X) if kind == "box" else Mesh("m", CORNERS * size, FACES, X)


@pytest.mark.parametrize("b", ["capsule", "box", "mesh", "ball"])
@pytest.mark.parametrize("a", ["capsule", "box", "ball"])
def test_distances_are_coals_and_the_nearest_points_are_that_far_apart(a: str, b: str) -> None:
    rng = np.random.default_rng(36)
    for _ in range(25):
        one, two = some_shape(rng, a), some_shape(rng, b)
        X_WA, X_WB = (np.array([some_pose(rng, 0.5) for _ in range(20)]) for _ in range(2))
        wanted = Pair(one, two).distances(np.linalg.inv(X_WB) @ X_WA)
        near, rows = NearPairs([(one, 0, two, 1)]), np.arange(20)
        found, apart = near.nearest(np.stack([X_WA, X_WB], axis=1), rows, 0 * rows), wanted > 0
        np.testing.assert_allclose(found.distance[apart], wanted[apart], rtol=0, atol=1e-9)
        assert np.all(found.distance[~apart] <= 0)
        if b != "mesh":
            assert np.all(found.distance >= wanted - 1e-9)  # never deeper than it is
            between = np.einsum("ij,ij->i", found.on_a - found.on_b, found.normal)
            np.testing.assert_allclose(between, found.distance, rtol=0, atol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(found.normal, axis=1), 1.0, rtol=0, atol=1e-9)
        assert np.all(near.bound(np.stack([X_WA, X_WB], axis=1))[:, 0] <= wanted + 1e-9)


def test_a_body_within_a_mesh_that_touches_no_surface_overlaps() -> None:
    ball = Capsule("s", np.zeros(3), np.zeros(3), 0.05)
    cube = Mesh("m", CORNERS, FACES)
    X = np.array([pose(np.eye(3), [x, 0, 0]) for x in (0.0, 1.0)])
    found = NearPairs([(ball, 0, cube, WORLD)]).nearest(X[:, None], np.arange(2), np.zeros(2, dtype=np.intp))
    assert np.sign(found.distance).tolist() == [-1, 1]
