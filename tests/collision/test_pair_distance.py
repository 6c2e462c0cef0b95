"""Distances of placed bodies against closed forms, another mesh of the same body, and symmetry."""

from __future__ import annotations

import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.proximity.meshes import convex, inside, load_mesh
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import Box, Capsule, Mesh, MeshFile, Shape, outline

CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2.0
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(316)


def some_pose(rng: np.random.Generator, far: float = 0.5) -> np.ndarray:
    axis = rng.normal(size=3)
    return pose(rotation_about(axis / np.linalg.norm(axis), rng.uniform(-3, 3)), rng.uniform(-far, far, 3))


def at(x: float, y: float = 0.0, z: float = 0.0) -> np.ndarray:
    return pose(np.eye(3), [x, y, z])


def box_mesh(size: np.ndarray, X: np.ndarray) -> Mesh:
    return Mesh("mesh", CORNERS * size, FACES, X)


def segments_apart(a: np.ndarray, b: np.ndarray, c: np.ndarray, d: np.ndarray) -> float:
    """Distance of the segments ab and cd: the least over both ends of each and the lines' common normal."""

    def point_to_segment(p: np.ndarray, e: np.ndarray, f: np.ndarray) -> float:
        s = np.clip((p - e) @ (f - e) / max((f - e) @ (f - e), 1e-30), 0, 1)
        return float(np.linalg.norm(p - e - s * (f - e)))

    least = min(point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b),
                point_to_segment(d, a, b))  # fmt: skip
    A = np.column_stack([b - a, c - d])
    s, t = np.linalg.lstsq(A, c - a, rcond=None)[0]
    if 0 <= s <= 1 and 0 <= t <= 1:
        least = min(least, float(np.linalg.norm(A @ [s, t] - (c - a))))
    return least


def test_capsules_are_as_far_apart_as_their_segments_less_both_radii(rng: np.random.Generator) -> None:
    worst = 0.0
    for _ in range(300):
        a, b, c, d = rng.uniform(-0.3, 0.3, (4, 3))
        r1, r2 = rng.uniform(0.01, 0.2, 2)
        X_WA, X_WB = some_pose(rng), some_pose(rng)
        ends = [X[:3, :3] @ p + X[:3, 3] for X, p in ((X_WA, a), (X_WA, b), (X_WB, c), (X_WB, d))]
        found = Pair(Capsule("a", a, b, r1), Capsule("b", c, d, r2)).distance(X_WA, X_WB)
        worst = max(worst, abs(found - segments_apart(*ends) + r1 + r2))
    assert worst < 1e-9


@pytest.mark.parametrize(
    ("centre", "expected"),
    [
        ((0.5, 0, 0), 0.5 - 0.2 - 0.1),  # beside a face
        ((0.2 + 0.3, 0.3 + 0.4, 0), 0.5 - 0.1),  # beside an edge
        ((0.2 + 0.2, 0.3 + 0.3, 0.1 + 0.6), 0.7 - 0.1),  # beside a corner
        ((0.25, 0, 0), 0.05 - 0.1),  # its centre outside, its skin inside
        ((0, 0, 0.08), -(0.02 + 0.1)),  # inside: the way out is through the nearest face
    ],
)
def test_sphere_and_box_in_closed_form(centre: tuple[float, float, float], expected: float) -> None:
    pair = Pair(Capsule("ball", np.zeros(3), np.zeros(3), 0.1), Box("box", np.array([0.4, 0.6, 0.2])))
    assert pair.distance(at(*centre), np.eye(4)) == pytest.approx(expected, abs=1e-9)
    turn = pose(rotation_about([0.6, 0, 0.8], 1.1), [0.3, -0.2, 0.5])
    assert pair.distance(turn @ at(*centre), turn) == pytest.approx(expected, abs=1e-9)


def test_a_capsules_length_is_that_of_its_segment() -> None:
    standing = Capsule("standing", np.array([0, 0, -0.25]), np.array([0, 0, 0.25]), 0.1)
    floor = Box("floor", np.array([2, 2, 0.1]), at(0, 0, -0.05))
    pair = Pair(standing, floor)
    assert pair.distance(at(0, 0, 1.0), np.eye(4)) == pytest.approx(0.65, abs=1e-9)
    assert pair.distance(at(0, 0, 0.3), np.eye(4)) == pytest.approx(-0.05, abs=1e-9)
    lying = pose(rotation_about([0, 1, 0], np.pi / 2), [0, 0, 0.3])
    assert pair.distance(lying, np.eye(4)) == pytest.approx(0.2, abs=1e-9)


def test_nearest_points_are_as_far_apart_as_the_bodies(rng: np.random.Generator) -> None:
    pair = Pair(Capsule("rod", np.zeros(3), np.array([0.2, 0, 0]), 0.05), Box("box", np.array([0.1, 0.2, 0.3])))
    for _ in range(20):
        X_WA, X_WB = some_pose(rng, 1.0), some_pose(rng, 1.0)
        p, q = pair.nearest(X_WA, X_WB)
        distance = pair.distance(X_WA, X_WB)
        if distance > 0:
            assert np.linalg.norm(p - q) == pytest.approx(distance, abs=1e-9)
    p, q = pair.nearest(at(1.0), at(0.0))
    assert (p[0], q[0]) == (pytest.approx(0.95), pytest.approx(0.05))


def test_a_mesh_of_a_box_is_the_box(rng: np.random.Generator) -> None:
    """Apart: the same distance. Overlapping: the same depth, also where the capsule lies wholly inside. As triangles
    with corners of their own, too, which is what STL files hold."""
    counts = {"apart": 0, "over": 0, "inside": 0}
    for _ in range(160):
        size, X_B = rng.uniform(0.2, 0.8, 3), some_pose(rng, 0.1)
        rod = Capsule("rod", rng.uniform(-0.1, 0.1, 3), rng.uniform(-0.1, 0.1, 3), rng.uniform(0.01, 0.06))
        X_WA, X_WB = some_pose(rng, 0.4), some_pose(rng, 0.1)
        box = Pair(rod, Box("box", size, X_B)).distance(X_WA, X_WB)
        mesh = Pair(rod, box_mesh(size, X_B)).distance(X_WA, X_WB)
        apart = Mesh("mesh", (CORNERS * size)[FACES].reshape(-1, 3), np.arange(36).reshape(-1, 3), X_B)
        assert Pair(rod, apart).distance(X_WA, X_WB) == pytest.approx(mesh, abs=1e-6)
        turned = Pair(box_mesh(size, X_B), rod).distance(X_WB, X_WA)
        assert turned == pytest.approx(mesh, abs=1e-9)
        assert mesh == pytest.approx(box, abs=1e-6)
        if box > 0:
            counts["apart"] += 1
        else:
            counts["inside" if box < -2 * rod.radius - np.linalg.norm(rod.a - rod.b) else "over"] += 1
    assert min(counts.values()) >= 5, counts


def test_only_the_whole_surface_of_a_convex_body_is_convex() -> None:
    size = np.array([0.2, 0.3, 0.4])
    whole = box_mesh(size, np.eye(4))
    faces = [face for face in FACES.tolist() if not {4, 7} <= set(face)]  # without those at x = 0.1
    faces += [[4, 6, 8], [6, 7, 8], [7, 5, 8], [5, 4, 8]]
    dent = Mesh("dent", np.vstack([CORNERS * size, [[0.09, 0, 0]]]), faces)
    assert convex(whole) is not None
    assert convex(replace(whole, triangles=FACES[:, ::-1])) is not None
    assert convex(dent) is None
    assert convex(replace(whole, triangles=FACES[1:])) is None
    assert convex(Mesh("flat", (CORNERS * size)[:4], [[0, 1, 3], [0, 3, 2], [0, 3, 1], [0, 2, 3]])) is None
    ball = Capsule("ball", np.zeros(3), np.zeros(3), 0.02)
    assert Pair(ball, dent).distance(np.eye(4), np.eye(4)) < 0
    assert Pair(ball, dent).distances(np.eye(4)[None], solid=False)[0] > 0  # still its surface
    aside = pose(rotation_about([0, 0, 1], np.pi / 2), [0.0, 0.12, 0.0])
    inner = Pair(ball, dent).distance(aside, np.eye(4))
    assert inner < 0
    assert Pair(dent, ball).distance(np.eye(4), aside) == pytest.approx(inner, abs=1e-12)
    over = Pair(ball, dent).distance(at(0.115), np.eye(4))  # above the dent's deepest point, in the hull or not
    assert over > Pair(ball, whole).distance(at(0.115), np.eye(4)) + 1e-4


def test_distance_is_symmetric_and_the_placing_is_relative(rng: np.random.Generator) -> None:
    shapes: list[Shape] = [
        Capsule("rod", np.zeros(3), np.array([0.3, 0.1, 0]), 0.05),
        Box("box", np.array([0.2, 0.3, 0.1]), some_pose(rng)),
        box_mesh(np.array([0.3, 0.2, 0.1]), some_pose(rng)),
    ]
    for a in shapes:
        for b in shapes:
            X_WA, X_WB, X = some_pose(rng, 1.0), some_pose(rng, 1.0), some_pose(rng)
            found = Pair(a, b).distance(X_WA, X_WB)
            assert Pair(b, a).distance(X_WB, X_WA) == pytest.approx(found, abs=1e-8)
            assert Pair(a, b).distance(X @ X_WA, X @ X_WB) == pytest.approx(found, abs=1e-8)


def test_many_placings_are_measured_one_by_one(rng: np.random.Generator) -> None:
    """A result that is not cleared, or a placing kept from before, would show here."""
    pair = Pair(Capsule("rod", np.zeros(3), np.array([0.2, 0, 0]), 0.05), Box("box", np.array([0.1, 0.2, 0.3])))
    X = np.array([some_pose(rng, 1.0) for _ in range(50)])
    alone = [Pair(pair.a, pair.b).distance(one, np.eye(4)) for one in X]
    np.testing.assert_allclose(pair.distances(X), alone, rtol=0, atol=1e-8)
    assert pair.distances(X[:0]).shape == (0,)


def test_outlines_hold_their_shapes(rng: np.random.Generator) -> None:
    """Points of each shape, drawn by their definition, lie in the hull of the outline grown by its radius."""
    X = some_pose(rng)
    size = np.array([0.2, 0.3, 0.4])
    for shape in (Box("box", size, X), box_mesh(size, X)):
        points, radius = outline(shape)
        assert radius == 0.0
        np.testing.assert_allclose(
            np.sort(points, axis=0), np.sort((X[:3, :3] @ (CORNERS * size).T).T + X[:3, 3], axis=0)
        )
    points, radius = outline(Capsule("rod", [0, 0, 0], [1, 0, 0], 0.2))
    np.testing.assert_array_equal(points, [[0, 0, 0], [1, 0, 0]])
    assert radius == 0.2


def test_inside_is_told_by_geometry(rng: np.random.Generator) -> None:
    size, X = np.array([0.2, 0.3, 0.4]), some_pose(rng)
    points = rng.uniform(-0.25, 0.25, (200, 3))
    expected = (np.abs(points) < size / 2).all(axis=1)
    assert 10 < expected.sum() < 190
    np.testing.assert_array_equal(inside(box_mesh(size, X), points @ X[:3, :3].T + X[:3, 3]), expected)
    flipped = Mesh("flipped", CORNERS * size, FACES[:, ::-1], X)
    np.testing.assert_array_equal(inside(flipped, points @ X[:3, :3].T + X[:3, 3]), expected)


def write_mesh(folder: Path, kind: str) -> Path:
    """A cuboid of 200 x 300 x 400 units in a file of a kind."""
    path, corners = folder / f"block.{'obj' if kind == 'obj' else 'stl'}", CORNERS * [200, 300, 400]
    if kind == "obj":
        lines = ["v {:g} {:g} {:g}".format(*p) for p in corners] + ["f {} {} {}".format(*(t + 1)) for t in FACES]
        path.write_text("\n".join(lines) + "\n")
    elif kind == "ascii":
        facets = [
            "facet normal 0 0 0\nouter loop\n"
            + "".join("vertex {:g} {:g} {:g}\n".format(*corners[i]) for i in face)
            + "endloop\nendfacet\n"
            for face in FACES
        ]
        path.write_text("solid block\n" + "".join(facets) + "endsolid block\n")
    else:
        facets = [struct.pack("<12fH", 0, 0, 0, *corners[face].ravel(), 0) for face in FACES]
        path.write_bytes(b"\0" * 80 + struct.pack("<I", len(FACES)) + b"".join(facets))
    return path


@pytest.mark.parametrize("kind", ["ascii", "binary", "obj"])
def test_mesh_files_are_read_in_their_scale(kind: str, tmp_path: Path, rng: np.random.Generator) -> None:
    X = some_pose(rng)
    mesh = load_mesh(MeshFile("block", write_mesh(tmp_path, kind), X, 1e-3))
    assert len(mesh.triangles) == 12
    ball = Capsule("ball", np.zeros(3), np.zeros(3), 0.1)
    for _ in range(20):
        X_WA = some_pose(rng, 1.0)
        box = Pair(ball, Box("box", np.array([0.2, 0.3, 0.4]), X)).distance(X_WA, np.eye(4))
        assert Pair(ball, mesh).distance(X_WA, np.eye(4)) == pytest.approx(box, abs=1e-6) or box < 0


@pytest.mark.parametrize(
    ("content", "reason"),
    [("hello", "File is too small"), ("", "File is empty"), ("\0" * 80 + "\1\0\0\0abc", "Failed to determine STL")],
)
def test_broken_mesh_files_are_refused_in_one_line(content: str, reason: str, tmp_path: Path) -> None:
    path = tmp_path / "block.stl"
    path.write_text(content)
    with pytest.raises(InputError) as caught:
        load_mesh(MeshFile("block", path))
    assert str(caught.value).startswith(f"cannot read the mesh {path}: {reason}")
    assert "\n" not in str(caught.value)


def test_a_missing_mesh_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"no such mesh file: .*nope\.stl$"):
        load_mesh(MeshFile("block", tmp_path / "nope.stl"))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Box("b", [1, 0, 1]), r"box 'b': size .* wanted three lengths above zero"),
        (lambda: Box("b", [1, 1]), r"box 'b': size is .*, wanted three finite numbers"),
        (lambda: Box("b", [1, 1, 1], np.diag([2.0, 1, 1, 1])), r"box 'b': X has no rotation"),
        (lambda: Capsule("c", [0, 0, 0], [0, 0, np.nan], 1), r"capsule 'c': b is .*, wanted three finite numbers"),
        (lambda: Capsule("c", [0, 0, 0], [0, 0, 1], 0), r"capsule 'c': radius 0 m, wanted a length above zero"),
        (lambda: Mesh("m", np.zeros((3, 3)), [[0, 1, 3]]), r"mesh 'm': a triangle names a vertex outside 0\.\.2"),
        (lambda: Mesh("m", np.zeros((3, 3)), np.zeros((0, 3))), r"mesh 'm': triangles have shape \(0, 3\)"),
        (lambda: MeshFile("m", Path("x"), np.eye(4), -1.0), r"mesh 'm': scale -1\.0, wanted a number above zero"),
    ],
)
def test_shapes_refuse_what_is_none(make: object, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        make()
