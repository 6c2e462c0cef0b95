"""The glTF animation, read back by pygltflib: where it puts every link is held against pin."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation
from small_cells import HOME, plant_with_rail, plant_without_rail

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.gltf import gltf
from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scenario import PositionerAxis
from trajopt_cli.shapes import Box, Capsule, Mesh, Polytope, Rides, Solid
from trajopt_cli.trajectory import Trajectory

ASIDE = pose(rotation_about([1, 0, 0], 0.3), [1.0, 0.2, 0.4])
WEDGE = Mesh("wedge", [[0, 0, 0], [0.3, 0, 0], [0, 0.2, 0], [0, 0, 0.1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
UP = pose(rotation_about([1, 0, 0], -np.pi / 2), [0, 0, 0])  # our z is glTF's y


class Read:
    """A GLB file by pygltflib: its nodes by name, numbers of accessors, and every node's pose at a key frame."""

    def __init__(self, content: bytes):
        library = pytest.importorskip("pygltflib")
        self.file = library.GLTF2.load_from_bytes(content)
        self.nodes = self.file.nodes
        self.parents = {child: i for i, node in enumerate(self.nodes) for child in node.children or ()}
        (animation,) = self.file.animations
        self.curves = {
            (one.target.node, one.target.path): animation.samplers[one.sampler] for one in animation.channels
        }

    def numbers(self, index: int) -> np.ndarray:
        accessor = self.file.accessors[index]
        view = self.file.bufferViews[accessor.bufferView]
        kind = {5126: np.float32, 5125: np.uint32}[accessor.componentType]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor.type]
        blob = self.file.binary_blob()[view.byteOffset : view.byteOffset + view.byteLength]
        rows = np.frombuffer(blob, dtype=kind).reshape(accessor.count, width).astype(float)
        assert (accessor.min, accessor.max) == (rows.min(axis=0).tolist(), rows.max(axis=0).tolist())
        return rows

    def X_WN(self, node: int, frame: int) -> np.ndarray:
        """In glTF's world."""
        parts = {}
        for path, still in (("translation", [0, 0, 0]), ("rotation", [0, 0, 0, 1])):
            curve = self.curves.get((node, path))
            value = getattr(self.nodes[node], path)
            parts[path] = self.numbers(curve.output)[frame] if curve else still if value is None else value
        X = pose(Rotation.from_quat(parts["rotation"]).as_matrix(), parts["translation"])
        return self.X_WN(self.parents[node], frame) @ X if node in self.parents else X

    def surfaces(self) -> Iterator[tuple[int, str, np.ndarray, np.ndarray]]:
        for i, node in enumerate(self.nodes):
            if node.mesh is not None:
                (primitive,) = self.file.meshes[node.mesh].primitives
                corners = self.numbers(primitive.indices).astype(int).reshape(-1, 3)
                yield i, node.name, self.numbers(primitive.attributes.POSITION), corners


def sweep(plant: Plant, n: int = 40) -> Trajectory:
    """All axes from one end of 300 degrees (1 m) to the other, joint_6 over its half turn."""
    share = np.linspace(0, 1, n)[:, None]
    q = (
        np.r_[np.zeros(len(plant.start) - 6), HOME]
        + (share - 0.3) * np.r_[1.0, np.full(6, np.deg2rad(300))][-len(plant.start) :]
    )
    q[:, -1] *= 2
    return Trajectory(plant.robot.axis_names, 3 + 2 * share[:, 0], q)


def volume(vertices: np.ndarray, corners: np.ndarray) -> float:
    """Signed; positive where the triangles turn counter-clockwise seen from outside."""
    a, b, c = vertices[corners].transpose(1, 0, 2)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


@pytest.mark.parametrize("rail", [True, False])
def test_every_link_is_where_pin_has_it_at_every_key_frame(rail: bool) -> None:
    plant = plant_with_rail(X_WR=ASIDE) if rail else plant_without_rail()
    motion = sweep(plant)
    read = Read(gltf(motion, plant, "a plan"))
    X, _ = Mechanism(plant.robot.urdf, plant.robot.X_WR).links(motion.q)
    names = {node.name: i for i, node in enumerate(read.nodes) if node.mesh is None}
    assert names.keys() == {"a plan", "base", *["rail"] * rail, *plant.robot.link_names, "tool0"}
    for frame in (0, 7, 20, 39):
        for link, name in enumerate((*plant.robot.link_names, "tool0")):
            np.testing.assert_allclose(read.X_WN(names[name], frame), UP @ X[frame, link], rtol=0, atol=1e-6)
    assert len(read.curves) == len(plant.start)
    for (_, path), curve in read.curves.items():
        np.testing.assert_allclose(read.numbers(curve.input)[:, 0], motion.t - 3, atol=1e-6)
        if path == "rotation":  # between key frames the shorter way is gone, and that is not half a turn off
            turns = read.numbers(curve.output)
            assert np.sum(turns[1:] * turns[:-1], axis=1).min() > 0.9


def test_surfaces_are_the_shapes_and_face_outwards() -> None:
    box = Box("table", np.array([1.0, 0.5, 0.1]), ASIDE)
    grip, ball = (
        Capsule("grip", np.zeros(3), np.array([0, 0.03, 0.1]), 0.02),
        Capsule("ball", *np.full((2, 3), 0.1), 0.05),
    )
    plant = replace(
        plant_with_rail(), obstacles=(Solid(box), Solid(replace(WEDGE, X=ASIDE)), Solid(ball)), attached=(Solid(grip),)
    )
    read = Read(gltf(sweep(plant), plant, "a plan"))
    found = {name: (i, vertices, corners) for i, name, vertices, corners in read.surfaces()}
    capsules = {capsule.name: capsule for capsule in (grip, ball)}
    assert found.keys() == {*capsules, *plant.robot.bodies, "table", "wedge", "rail", "carriage"}
    for name, (link,) in plant.robot.bodies.items():
        assert isinstance(link, Polytope)
        assert volume(*found[name][1:]) == pytest.approx(ConvexHull(link.vertices).volume, rel=1e-6)
    for name, capsule in capsules.items():
        _, vertices, corners = found[name]
        along = capsule.b - capsule.a
        share = np.clip((vertices - capsule.a) @ along / max(along @ along, 1e-300), 0, 1)
        away = np.linalg.norm(vertices - capsule.a - share[:, None] * along, axis=1)
        np.testing.assert_allclose(away, capsule.radius, rtol=0, atol=1e-6)
        whole = np.pi * capsule.radius**2 * (np.linalg.norm(along) + 4 / 3 * capsule.radius)
        assert 0.9 * whole < volume(vertices, corners) < whole
    for name, whole in (("table", 0.05), ("wedge", 0.001)):
        i, vertices, corners = found[name]
        assert volume(vertices, corners) == pytest.approx(whole, rel=1e-6)
        np.testing.assert_allclose(read.X_WN(i, 0), UP @ ASIDE, rtol=0, atol=1e-6)
    parent = {name: read.nodes[read.parents[i]].name for name, (i, *_) in found.items()}
    assert (parent["grip"], parent["ball"], parent["table"]) == ("tool0", "a plan", "a plan")
    assert [parent[name] for name in plant.robot.bodies] == [*plant.robot.bodies]


def test_the_arm_has_its_makers_paint_and_the_tool_another() -> None:
    """sRGB's curve by its two ends and by 18 % grey, which is #767676 or one step beside it."""
    for colour, wanted in (("#ffffff", [1, 1, 1]), ("#000000", [0, 0, 0]), ("#767676", [0.181] * 3)):
        plant = plant_with_rail()
        grip = Solid(Capsule("grip", np.zeros(3), np.ones(3) / 9, 0.02))
        plant = replace(plant, robot=replace(plant.robot, colour=colour), attached=(grip,))
        file = Read(gltf(sweep(plant), plant, "a plan")).file
        material = {
            node.name: file.meshes[node.mesh].primitives[0].material for node in file.nodes if node.mesh is not None
        }
        paint = {name: file.materials[one].pbrMetallicRoughness.baseColorFactor for name, one in material.items()}
        np.testing.assert_allclose(paint["link_3"], [*wanted, 1], atol=2e-3)
        assert paint["grip"] != paint["link_3"]
        assert paint["rail"] == paint["carriage"]


def test_the_same_motion_gives_the_same_bytes_and_another_robots_is_refused() -> None:
    plant = plant_with_rail()
    assert gltf(sweep(plant), plant, "a plan") == gltf(sweep(plant), plant, "a plan")
    with pytest.raises(InputError, match=r"moves joint_1, .*, not the axes of ABB IRB 140-6/0\.81 on a linear track"):
        gltf(sweep(plant_without_rail()), plant, "a plan")


def test_a_body_on_a_table_turns_with_it() -> None:
    """The table's second axis has turned by 90 degrees behind its first one's 90, in closed form: a box over it."""
    first = PositionerAxis(1, (0.6, 0.2, 0.3), (1, 0, 0, 0), (-3, 3), 1, 1, 0.0, "a test")
    tilted = PositionerAxis(2, (0.1, 0, 0), (np.sqrt(0.5), 0, np.sqrt(0.5), 0), (-3, 3), 1, 1, 0.0, "a test")
    X = pose(rotation_about([0, 1, 0], np.pi / 2), [0.7, 0.2, 0.3])  # of the second axis at start
    box = Box("box", np.array([0.1, 0.2, 0.3]), X @ pose(np.eye(3), [0.2, 0, 0.1]))
    plant = replace(
        plant_without_rail(), units={"stn1": (first, tilted)}, obstacles=(Solid(box, rides=Rides("stn1", 2)),)
    )
    rows = sweep(plant)
    share = np.linspace(0, 1, len(rows.t))[:, None]
    tables = Trajectory(("eax_b", "eax_c"), rows.t, np.pi / 2 * np.hstack([share, share]))
    read = Read(gltf(replace(rows, tables=tables), plant, "a plan"))
    node = next(i for i, name, *_ in read.surfaces() if name == "box")
    turned = pose(rotation_about([0, 0, 1], np.pi / 2), [0.6, 0.2, 0.3]) @ pose(np.eye(3), [0.1, 0, 0])
    turned = turned @ pose(rotation_about([0, 1, 0], np.pi / 2) @ rotation_about([0, 0, 1], np.pi / 2), [0, 0, 0])
    np.testing.assert_allclose(read.X_WN(node, 0), UP @ box.X, atol=1e-6)
    np.testing.assert_allclose(read.X_WN(node, -1), UP @ turned @ pose(np.eye(3), [0.2, 0, 0.1]), atol=1e-6)
