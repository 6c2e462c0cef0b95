"""Polytopes of 26 directions: corners and surface by scipy's half-spaces, distances proven by planes between them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import ConvexHull, HalfspaceIntersection

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.proximity.near import NearPairs
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.model import load_robot
from trajopt_cli.shapes import DIRECTIONS, Box, Capsule, Mesh, Polytope, polytope


def around(points: Array, name: str = "p") -> Polytope:
    return polytope(name, (points @ DIRECTIONS.T).max(axis=0).tolist())


def lump(rng: np.random.Generator) -> Array:
    return rng.normal(size=(30, 3)) * rng.uniform(0.02, 0.3, 3) + rng.normal(size=3) * 0.2


def distance_from_segment(points: Array, capsule: Capsule) -> Array:
    along = capsule.b - capsule.a
    share = np.clip((points - capsule.a) @ along / max(along @ along, 1e-300), 0, 1)
    return np.asarray(np.linalg.norm(points - capsule.a - share[:, None] * along, axis=1))


def test_directions_are_in_the_order_that_files_have() -> None:
    np.testing.assert_allclose(DIRECTIONS[[0, 1, 4, 21, 25]] * np.sqrt([[3], [2], [1], [1], [3]]),
                               [[-1, -1, -1], [-1, -1, 0], [-1, 0, 0], [1, 0, 0], [1, 1, 1]], atol=1e-15)  # fmt: skip
    assert len(DIRECTIONS) == 26


@pytest.mark.parametrize("seed", range(12))
def test_corners_surface_and_outer_capsule(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = lump(rng)
    body = around(points)
    h = (points @ DIRECTIONS.T).max(axis=0)
    wanted = HalfspaceIntersection(np.column_stack([DIRECTIONS, -h]), points.mean(axis=0)).intersections
    apart = np.linalg.norm(wanted[:, None] - body.vertices, axis=2)
    assert apart.min(axis=1).max() < 1e-6
    assert apart.min(axis=0).max() < 1e-6
    a, b, c = np.moveaxis(body.vertices[body.triangles], 1, 0)
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6  # counts what faces inwards, or is missing
    assert volume == pytest.approx(ConvexHull(wanted).volume, rel=1e-6)
    edges = np.sort(body.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()
    assert (distance_from_segment(body.vertices, body.outer) <= body.outer.radius + 1e-12).all()


def test_a_cube_whose_other_planes_touch_its_edges_and_corners_has_eight_corners() -> None:
    corners = np.array([[x, y, z] for x in (-0.1, 0.1) for y in (-0.2, 0.2) for z in (0.0, 0.5)])
    body = around(corners)
    assert len(body.vertices) == 8
    assert ConvexHull(body.vertices).volume == pytest.approx(0.2 * 0.4 * 0.5)
    with pytest.raises(ValueError, match="no body"):
        around(corners * [1, 1, 0])  # flat
    with pytest.raises(ValueError, match="no body"):
        polytope("p", [*[1.0] * 12, -1.5, *[1.0] * 13])


@pytest.mark.parametrize("seed", range(4))
def test_distances_are_proven_from_both_sides(seed: int) -> None:
    """Points of both bodies are that near, and a plane keeps them that far apart; an overlap has a point in both."""
    rng = np.random.default_rng(seed)
    one, two = around(lump(rng)), around(lump(rng), "q")
    box, pin = Box("box", np.array([0.2, 0.1, 0.3])), Capsule("pin", np.zeros(3), np.array([0, 0.1, 0.2]), 0.03)
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * box.size / 2
    X = np.array([pose(rotation_about(axis / np.linalg.norm(axis), turn), at)
                  for axis, turn, at in zip(rng.normal(size=(60, 3)), rng.uniform(0, 3, 60),
                                            rng.uniform(-0.9, 0.9, (60, 3)), strict=True)])  # fmt: skip
    apart = 0
    for other, points, radius in ((two, two.vertices, 0.0), (box, corners, 0.0), (pin, np.array([pin.a, pin.b]), 0.03)):
        near = NearPairs([(one, 0, other, 1)])
        placings = np.stack([X, np.broadcast_to(np.eye(4), X.shape)], axis=1)
        found = near.nearest(placings, np.arange(60), np.zeros(60, dtype=np.intp))
        judged = Pair(one, other).distances(X)
        np.testing.assert_allclose(found.distance, judged, atol=2e-5)
        for i in range(60):
            mine = one.vertices @ X[i, :3, :3].T + X[i, :3, 3]
            if judged[i] > 1e-5:
                n = (found.on_a[i] - found.on_b[i]) / judged[i]
                assert (mine @ n).min() - (points @ n).max() - radius == pytest.approx(judged[i], abs=2e-5)
                inner = (found.on_a[i] - X[i, :3, 3]) @ X[i, :3, :3]
                assert (DIRECTIONS @ inner <= (one.vertices @ DIRECTIONS.T).max(axis=0) + 1e-6).all()
                apart += 1
            elif judged[i] < -1e-4:
                away = found.normal[i]
                gap = (mine @ away).min() - (points @ away).max() - radius
                assert gap == pytest.approx(judged[i], abs=3e-4)  # moved along the normal by the depth they are apart
    assert apart > 20


def test_nothing_nearer_than_the_limit_is_left_out() -> None:
    rng = np.random.default_rng(3)
    robot = load_robot("irb140")
    bodies = [shapes[0] for shapes in robot.bodies.values()]
    box = Box("box", np.array([0.2, 0.4, 0.3]), pose(rotation_about([0.6, 0, 0.8], 0.4), [0.3, 0.1, 0.2]))
    pin = Capsule("pin", np.array([0.3, -0.4, 0.0]), np.array([0.3, -0.4, 0.5]), 0.1)
    wedge = Mesh("wedge", np.array([[0, 0, 0], [0.4, 0, 0], [0, 0.4, 0], [0, 0, 0.4]]),
                 np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]), pose(np.eye(3), [-0.4, 0.2, 0.0]))  # fmt: skip
    pairs = [*((a, i, b, j) for i, a in enumerate(bodies) for j, b in enumerate(bodies[:i])),
             *((a, i, other, -1) for i, a in enumerate(bodies) for other in (box, pin, wedge))]  # fmt: skip
    near = NearPairs(pairs)
    turns = rotation_about([0, 0.6, 0.8], rng.uniform(0, 6, 280))
    X = np.array([pose(R, at) for R, at in zip(turns, rng.uniform(-0.6, 0.6, (280, 3)), strict=True)])
    X = X.reshape(40, 7, 4, 4)
    rows, columns = (one.ravel() for one in np.indices((40, len(pairs))))
    distance = near.nearest(X, rows, columns).distance.reshape(40, -1)
    for limit in (0.0, 0.02, 0.2):
        found = np.zeros(distance.shape, dtype=bool)
        found[near.closer(X, np.full(len(pairs), limit))] = True
        assert found[distance < limit - 1e-5].all()
        assert found.sum() < 0.8 * found.size


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("seed", [712, 1020, 1222])  # boxes of which rounding puts a corner outside the least circle
def test_a_box_has_an_outer_capsule_whatever_rounding_does(seed: int) -> None:
    rng = np.random.default_rng(seed)
    h = rng.uniform(0.02, 0.3, 3)
    corners = h * (2.0 * np.indices((2, 2, 2)).reshape(3, -1).T - 1) + rng.uniform(-1, 1, 3)
    capsule = around(corners).outer
    assert distance_from_segment(corners, capsule).max() <= capsule.radius * (1 + 1e-9)
