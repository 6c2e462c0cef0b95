"""Bodies fitted around collision geometry, and the pairs of links that are worth watching."""

import struct

import numpy as np
import pytest
from loose_arm import written
from scipy.spatial import ConvexHull

from trajopt_cli.adopt.add import new_robot
from trajopt_cli.adopt.capsule import smallest_capsule, smallest_circle
from trajopt_cli.adopt.polytopes import polytopes_around, reach, volume
from trajopt_cli.adopt.solids import find_mesh, self_pairs
from trajopt_cli.geometry import rotation_about
from trajopt_cli.robot.model import load_robot
from trajopt_cli.shapes import DIRECTIONS, Capsule, polytope

ROUND = '<cylinder radius="0.2" length="0.3"/>'
TILT = rotation_about([0.6, 0, 0.8], 1.1)


def distance(points, capsule):
    """Of points from the capsule's segment, by a dense walk along it."""
    steps = capsule.a + np.linspace(0, 1, 2001)[:, None] * (capsule.b - capsule.a)
    return np.array([np.linalg.norm(steps - point, axis=1).min() for point in points])


def test_a_capsule_comes_back_from_its_own_surface():
    sphere = np.random.default_rng(0).normal(size=(3000, 3))
    sphere /= np.linalg.norm(sphere, axis=1, keepdims=True)
    ends = np.where(sphere[:, 2:] > 0, 1.0, -1.0) * np.array([0, 0, 0.25])
    points = (0.1 * sphere + ends) @ TILT.T + [1, 2, 3]
    found = smallest_capsule("x", points)
    axis = (found.b - found.a) / np.linalg.norm(found.b - found.a)
    assert found.radius == pytest.approx(0.1, abs=2e-3)
    assert np.linalg.norm(found.b - found.a) == pytest.approx(0.5, abs=5e-3)
    assert abs(axis @ TILT[:, 2]) > 1 - 1e-4


@pytest.mark.parametrize("seed", range(6))
def test_all_points_lie_inside(seed):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(200, 3)) * rng.uniform(0.01, 0.5, 3) @ TILT.T
    found = smallest_capsule("x", points)
    assert distance(points, found).max() <= found.radius + 1e-6
    assert distance(points, found).max() >= found.radius - 2e-4  # and it is no larger than rounding makes it


def test_no_direction_has_a_much_smaller_one():
    def volume(radius, length):
        return np.pi * radius**2 * (length + 4 / 3 * radius)

    rng = np.random.default_rng(11)
    for _ in range(3):
        points = rng.normal(size=(6, 3)) * [0.1, 0.2, 0.3]  # few corners: their main axes are no good guess
        found = smallest_capsule("x", points)
        best = np.inf
        for direction in rng.normal(size=(600, 3)):
            direction /= np.linalg.norm(direction)
            sides = np.linalg.svd(direction[None])[2][1:]
            centre, radius = smallest_circle(points @ sides.T)
            cap = np.sqrt(np.maximum(radius**2 - ((points @ sides.T - centre) ** 2).sum(axis=1), 0))
            t = points @ direction
            best = min(best, volume(radius, max(float((t - cap).max() - (t + cap).min()), 0.0)))
        assert volume(found.radius, np.linalg.norm(found.b - found.a)) < 1.03 * best


@pytest.mark.parametrize(
    "points",
    [
        [[0, 0, 0]],
        [[0, 0, 0], [0, 0, 1]],
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]],
        np.zeros((9, 3)),
        [[0, 0, i / 10] for i in range(11)],
    ],
)
def test_points_in_a_place_a_row_or_a_plane_have_one_too(points):
    found = smallest_capsule("x", np.array(points, dtype=float))
    assert distance(np.array(points), found).max() <= found.radius + 1e-9


def test_the_smallest_circle_has_no_smaller_neighbour():
    rng = np.random.default_rng(5)
    for _ in range(20):
        points = rng.normal(size=(12, 2)) * [1, rng.uniform(0.01, 1)]
        centre, radius = smallest_circle(points)
        assert np.hypot(*(points - centre).T).max() == pytest.approx(radius, rel=1e-9)
        for step in ([1e-4, 0], [-1e-4, 0], [0, 1e-4], [0, -1e-4]):  # the problem is convex: no way is downhill
            assert np.hypot(*(points - centre - step).T).max() > radius


def stl(path, corners):
    """A binary STL of the box between two corners."""
    low, high = np.array(corners)
    v = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * (high - low) + low
    faces = [(0, 1, 3), (0, 3, 2), (4, 7, 5), (4, 6, 7), (0, 5, 1), (0, 4, 5)]
    faces += [(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(faces)))
        for face in faces:
            file.write(struct.pack("<12fH", 0, 0, 0, *v[list(face)].ravel(), 0))


def collision(geometry, xyz="0 0 0"):
    return f'<collision><origin xyz="{xyz}"/><geometry>{geometry}</geometry></collision>'


def test_meshes_are_found_in_packages_and_scaled(tmp_path):
    package = tmp_path / "src" / "arm_description"
    (package / "urdf").mkdir(parents=True)
    stl(package / "meshes" / "lower.stl", [(-50, -50, 0), (50, 50, 700)])  # mm
    mesh = '<mesh filename="package://arm_description/meshes/lower.stl" scale="0.001 0.001 0.001"/>'
    lost = '<mesh filename="package://other/meshes/fore.stl"/>'
    edits = {
        '<link name="lower"/>': f'<link name="lower">{collision(mesh)}</link>',
        '<link name="fore"/>': f'<link name="fore">{collision(lost)}{collision(mesh)}</link>',
        '<link name="foot"/>': f'<link name="foot">{collision(ROUND)}</link>',
    }
    made = new_robot(written(package / "urdf", edits), "mine")
    assert list(made.bodies) == ["base_link", "link_2"]
    (lower,) = made.bodies["link_2"]
    assert ConvexHull(lower.vertices).volume == pytest.approx(0.1 * 0.1 * 0.7, rel=5e-3)  # rounded up to 0.1 mm
    corners = np.array([[x, y, z] for x in (-0.05, 0.05) for y in (-0.05, 0.05) for z in (0, 0.7)])
    assert (corners @ DIRECTIONS.T <= (lower.vertices @ DIRECTIONS.T).max(axis=0) + 1e-9).all()
    assert made.missing == (
        "link_4: mesh package://other/meshes/fore.stl is in no folder above the URDF: put the folder 'other' beside it,"
        " or the link has no body",
    )
    text = made.files["mine.yaml"].decode()
    assert "#   link_4: mesh package://other/meshes/fore.stl is in no folder above the URDF" in text
    assert "Without a body, and so not looked at: link_1, link_3, link_4, link_5, link_6" in text
    assert find_mesh("../meshes/lower.stl", package / "urdf" / "x.urdf").is_file()


def test_without_collision_geometry_there_is_no_section_and_the_file_says_so(tmp_path):
    made = new_robot(written(tmp_path), "mine")
    text = made.files["mine.yaml"].decode()
    assert "\ncollision:" not in text
    assert "# No collision section" in text
    for name, content in made.files.items():
        (tmp_path / name).write_bytes(content)
    assert load_robot(str(tmp_path / "mine.yaml")).bodies == {}


def surface(boxes):
    """Triangles (m, 3, 3) of boxes between two corners each."""
    out = []
    for low, high in boxes:
        v = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * np.subtract(high, low) + low
        out.append(v[ConvexHull(v).simplices])
    return np.concatenate(out)


def test_a_bent_link_is_cut_into_bodies_that_hold_all_of_it():
    """An elbow of two boxes has two bodies as large as these; a point on its surface lies in one of them."""
    elbow = surface([([0, 0, 0], [0.1, 0.1, 0.6]), ([0, 0, 0.5], [0.5, 0.1, 0.6])])
    parts = polytopes_around("elbow", elbow)
    assert len(parts) == 2
    assert sum(map(volume, parts)) == pytest.approx(0.006 + 0.004, rel=0.15)
    assert volume(polytopes_around("whole", surface([([0, 0, 0], [0.1, 0.1, 0.6])]))[0]) == pytest.approx(
        0.006, rel=0.01
    )
    rng = np.random.default_rng(2)
    weights = rng.dirichlet(np.ones(3), 4000)
    points = np.einsum("kc,kcx->kx", weights, elbow[rng.integers(0, len(elbow), 4000)])
    held = [(points @ DIRECTIONS.T <= np.array(reach(part)) + 1e-9).all(axis=1) for part in parts]
    assert np.any(held, axis=0).all()
    assert not np.all(held, axis=0).all()


@pytest.mark.parametrize("seed", range(3))
def test_bodies_of_any_surface_hold_it(seed):
    rng = np.random.default_rng(seed)
    boxes = [(at, at + rng.uniform(0.05, 0.4, 3)) for at in rng.uniform(0, 0.5, (4, 3))]
    triangles = surface(boxes)
    parts = polytopes_around("x", triangles)
    points = np.concatenate([rng.uniform(low, high, (1000, 3)) for low, high in boxes])  # inside, too
    assert np.any([(points @ DIRECTIONS.T <= np.array(reach(p)) + 1e-9).all(axis=1) for p in parts], axis=0).all()
    if len(parts) > 1:
        assert sum(map(volume, parts)) < volume(polytope("x", (triangles.reshape(-1, 3) @ DIRECTIONS.T).max(axis=0)))


def test_a_robot_with_a_bent_link_is_read_again(tmp_path):
    bent = "".join(
        collision(f'<box size="{size}"/>', xyz)
        for size, xyz in (("0.1 0.1 0.6", "0 0 0.3"), ("0.5 0.1 0.1", "0.2 0 0.55"))
    )
    ball = collision('<sphere radius="0.1"/>')
    edits = {f'<link name="{n}"/>': f'<link name="{n}">{s}</link>' for n, s in (("lower", bent), ("hand", ball))}
    made = new_robot(written(tmp_path, edits), "mine")
    for name, content in made.files.items():
        (tmp_path / name).write_bytes(content)
    bodies = load_robot(str(tmp_path / "mine.yaml")).bodies
    assert {link: len(parts) for link, parts in bodies.items()} == {"link_2": 2, "link_6": 1}
    assert isinstance(bodies["link_6"][0], Capsule)  # smaller than its polytope
    for one, other in zip(bodies["link_2"], made.bodies["link_2"], strict=True):
        assert volume(one) == pytest.approx(volume(other), rel=1e-3)


def test_the_pairs_of_the_irb_140_are_those_a_person_chose():
    """But for one, of which the meshes' hulls are known never to touch."""
    robot = load_robot("irb140")
    assert set(self_pairs(robot.chain, robot.bodies)) - {*robot.self_pairs} == {("link_2", "link_4")}
    assert {*robot.self_pairs} <= {*self_pairs(robot.chain, robot.bodies)}
    assert self_pairs(robot.chain, {}) == ()


def test_a_mesh_that_is_missing_or_drawn_in_mm_is_told_with_what_to_do(tmp_path):
    def made(mesh):
        collision = f'<link name="fore"><collision><geometry>{mesh}</geometry></collision></link>'
        return new_robot(written(tmp_path, {'<link name="fore"/>': collision}), "mine").missing

    (tmp_path / "large.obj").write_text(
        "v 0 0 0\nv 400 0 0\nv 0 400 0\nv 0 0 400\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    )
    assert made('<mesh filename="large.obj"/>') == (
        "link_4: mesh large.obj is 400 m long, so the link has no body: if it is drawn in mm, say"
        ' <mesh scale="0.001 0.001 0.001">',
    )
    assert made('<mesh filename="large.obj" scale="0.001 0.001 0.001"/>') == ()
    assert made('<mesh filename="other.obj"/>') == (
        "link_4: mesh other.obj is not there: put it beside the URDF, or the link has no body",
    )
    (told,) = made('<mesh filename="package://parts/a.stl"/>')
    assert told.endswith("put the folder 'parts' beside it, or the link has no body")
