"""The scene that a page's script is given, worked out here as the script does it, against pin."""

from __future__ import annotations

from base64 import b64decode
from dataclasses import replace
from itertools import product
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from arms import on_rail, pin_flange, some_arm
from link_poses import link_poses
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.job import read_job
from trajopt_cli.motion import SignalEvent
from trajopt_cli.page.scene import plant_scene, robot_scene
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.scene import Cycle, plan_cycle, rail_ends, scene_of_robot
from trajopt_cli.shapes import Box, Capsule, Mesh, Solid
from trajopt_cli.trajectory import Trajectory

X_FT = pose(rotation_about([0, 1, 0], 0.4), [0.05, -0.02, 0.12])
PLACE = pose(rotation_about([1, 0, 0], 0.6) @ rotation_about([0, 0, 1], -0.8), [-0.1, 0.2, 0.3])


def unpacked(block: dict[str, Any]) -> Array:
    return np.frombuffer(b64decode(block["f32"]), "<f4").reshape(block["shape"]).astype(np.float64)


def frames(scene: dict[str, Any], q: Array) -> list[Array]:
    """Frames of the chain in the world, the flange last: what the script computes."""
    less = [one.get("less", 0.0) for one in scene["chain"] if one["kind"] != "fixed"]
    turned = q - np.array(less) * np.concatenate([[0.0], q[:-1]])
    X, values, out = np.reshape(scene["base"], (4, 4)), iter(turned), []
    for joint in scene["chain"]:
        X = X @ np.reshape(joint["placement"], (4, 4))
        if joint["kind"] == "prismatic":
            X = X @ pose(np.eye(3), next(values) * np.array(joint["axis"]))
        elif joint["kind"] == "revolute":
            X = X @ pose(rotation_about(joint["axis"], next(values)), np.zeros(3))
        out.append(X)
    return out


def robots() -> dict[str, Any]:
    return {
        "rail": plant_with_rail(X_WR=PLACE).robot,
        "bench": plant_without_rail().robot,
        "iiwa": load_srs("iiwa7", PLACE),
    }


@pytest.mark.parametrize("name", ["rail", "bench", "iiwa"])
def test_chain_and_links_stand_where_pin_has_them(name: str) -> None:
    robot = robots()[name]
    rng = np.random.default_rng(5)
    q = rng.uniform(-1.5, 1.5, (4, len(robot.axis_names)))
    scene = robot_scene(robot, [], [Cycle("one", np.arange(4.0), q, ((0.0, X_FT),))])
    links = dict(zip(robot.link_names, link_poses(robot, q).swapaxes(0, 1), strict=True))
    bodies = [body for body in scene["bodies"] if body["role"] == "link"]
    assert {body["name"] for body in bodies} == set(robot.bodies)
    assert scene["colour"] == robot.colour
    flange = robot.pin_model.frames[robot.pin_model.getFrameId("tool0")].placement.homogeneous
    poses = scene_of_robot(robot).poses(q)
    for i, row in enumerate(q):
        found = frames(scene, row)
        np.testing.assert_allclose(poses[i], found, atol=1e-12)
        for body in bodies:
            X = np.reshape(scene["base"], (4, 4)) if body["link"] < 0 else found[body["link"]]
            np.testing.assert_allclose(X, links[body["name"]][i], atol=1e-12)
            (shape,) = robot.bodies[body["name"]]
            if isinstance(shape, Capsule):
                np.testing.assert_array_equal(body["a"], shape.a)
            else:
                np.testing.assert_allclose(unpacked(body["vertices"]), shape.vertices, atol=1e-6)
        X_WT = links[robot.link_names[-1]][i] @ flange @ X_FT
        np.testing.assert_allclose(found[-1] @ np.reshape(scene["tool"], (4, 4)), X_WT, atol=1e-12)
        np.testing.assert_allclose(unpacked(scene["cycles"][0]["path"])[i], X_WT[:3, 3], atol=1e-6)


@pytest.mark.parametrize("rail", [False, True])
def test_a_parallel_linkage_is_drawn_by_the_urdfs_joints(tmp_path: Path, rail: bool) -> None:
    chain = some_arm("linked 2")
    robot = (on_rail(chain, "overhead") if rail else chain).load(tmp_path)
    q = np.random.default_rng(5).uniform(-1.5, 1.5, (3, len(robot.axis_names)))
    scene = robot_scene(robot, [], [Cycle("one", np.arange(3.0), q, ((0.0, X_FT),))])
    np.testing.assert_allclose([frames(scene, row)[-1] for row in q], pin_flange(robot, q), atol=1e-12)
    np.testing.assert_allclose(unpacked(scene["cycles"][0]["q"]), q, atol=1e-6)


def test_the_path_changes_tools_when_the_program_does() -> None:
    robot = plant_without_rail().robot
    t, q = np.arange(5.0), np.tile([0.1, 0.2, 0.3, 0.4, 0.5, 0.6], (5, 1))
    scene = robot_scene(robot, [], [Cycle("one", t, q, ((0.0, np.eye(4)), (2.0, X_FT)))])
    (cycle,) = scene["cycles"]
    assert unpacked(cycle["path_t"]).tolist() == [0, 1, 2, 4]  # where it stands still, its ends are enough
    flange = robot.forward(q[0])
    for p, tool in zip(unpacked(cycle["path"]), [np.eye(4), np.eye(4), X_FT, X_FT], strict=True):
        np.testing.assert_allclose(p, (flange @ tool)[:3, 3], atol=1e-6)


def test_a_long_path_is_drawn_by_the_points_where_it_bends() -> None:
    robot = plant_without_rail().robot
    t = np.linspace(0.0, 10.0, 5001)
    q = np.zeros((len(t), 6))
    q[:, 0], q[:, 4] = np.clip(0.4 * t - 0.8, 0.0, 1.6), 0.5  # rests, swings around axis 1, rests
    cycle = Cycle("one", t, q, ((0.0, X_FT),), ((3.001, 4.001),))
    drawn = robot_scene(robot, [], [cycle])["cycles"][0]
    path, path_t = unpacked(drawn["path"]), unpacked(drawn["path_t"])
    assert len(path) < 200
    assert {round(1000 * one) for one in path_t} >= {3002, 4002, 0, 10_000}
    whole = (robot.forward(q) @ X_FT)[:, :3, 3]
    shown = np.column_stack([np.interp(t, path_t, path[:, i]) for i in range(3)])
    np.testing.assert_allclose(np.hypot(*shown[:, :2].T), np.hypot(*whole[:, :2].T), atol=4e-4)
    assert np.linalg.norm(np.diff(path, axis=0), axis=1).max() < 0.021


def test_the_rail_carries_the_base_from_end_to_end_of_its_stroke() -> None:
    plant = plant_with_rail((-0.5, 1.5), PLACE)
    scene = plant_scene(plant, [], [Cycle("one", np.zeros(1), np.zeros((1, 7)))])
    (beam,) = [one for one in scene["static"] if one["role"] == "rail"]
    X, size = np.reshape(beam["X"], (4, 4)), np.array(beam["size"])
    for d in (-0.5, 1.5):
        foot = (np.linalg.inv(X) @ plant.robot.base(d))[:3, 3]
        assert abs(foot[0]) < size[0] / 2
        np.testing.assert_allclose(foot[1:], [0, size[2] / 2 + 0.03], atol=1e-12)
    inside = size[0] - 2.0
    assert 0 < inside < 0.5
    (plate,) = [one for one in scene["bodies"] if one["role"] == "carriage"]
    X_WP = frames(scene, np.r_[1.5, np.zeros(6)])[plate["link"]] @ np.reshape(plate["X"], (4, 4))
    np.testing.assert_allclose(X_WP[:3, :3], X[:3, :3], atol=1e-12)


def test_every_axis_of_a_gantry_has_its_beam_on_the_carriage_before_it() -> None:
    """Wherever the axes are, a carriage lies flat on its own beam, and the next beam across it."""
    text = """robot: irb140
base: {position: [0, 0, 2], rpy: ["180 deg", 0, 0]}
axes: {eax_a: {axis: [1, 0, 0], stroke: [0, 3]}, eax_b: {axis: [0, 1, 0], stroke: [0, 1]}, eax_c: {axis: [0, 0, 1], stroke: [-1, 0]}}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: [1, 0.5, 0]}
"""  # noqa: E501
    plant = build_plant(parse_cell(text, "cell.yaml"))
    np.testing.assert_allclose(
        rail_ends(plant), [[0, 0.5, 2], [3, 0.5, 2], [1, 0, 2], [1, 1, 2], [1, 0.5, 1], [1, 0.5, 2]], atol=1e-12
    )
    scene = plant_scene(plant, [], [Cycle("one", np.zeros(1), plant.start[None])])
    (first,) = [one for one in scene["static"] if one["role"] == "rail"]
    beams = [first, *(one for one in scene["bodies"] if one["role"] == "rail")]
    plates = [one for one in scene["bodies"] if one["role"] == "carriage"]
    assert [one["name"] for one in beams] == ["rail_a", "rail_b", "rail_c"]
    for d in product((0.0, 3.0), (0.0, 1.0), (-1.0, 0.0)):
        at = frames(scene, np.r_[d, np.zeros(6)])
        X_beam = [np.reshape(one["X"], (4, 4)) for one in beams]
        X_beam = [X_beam[0], *(at[i] @ X for i, X in enumerate(X_beam[1:]))]
        for i, plate in enumerate(plates):
            assert plate["link"] == i
            foot = (np.linalg.inv(X_beam[i]) @ at[i] @ np.reshape(plate["X"], (4, 4)))[:3, 3]
            assert abs(foot[0]) <= (beams[i]["size"][0] - plate["size"][0]) / 2 + 1e-12
            np.testing.assert_allclose(foot[1:], [0, (beams[i]["size"][2] + plate["size"][2]) / 2], atol=1e-12)
            X_WP = at[i] @ np.reshape(plate["X"], (4, 4))
            above = plant.robot.base(np.array(d)) if i == 2 else X_beam[i + 1]
            assert abs((above[:3, 3] - X_WP[:3, 3]) @ X_WP[:3, 2]) < 0.25


def test_obstacles_and_what_the_flange_carries() -> None:
    wedge = Mesh("wedge", np.eye(3), np.array([[0, 1, 2]]), PLACE)
    plant = plant_without_rail(
        obstacles=(Solid(Box("table", np.ones(3), PLACE)), Solid(wedge)),
        attached=(Solid(Capsule("torch", np.zeros(3), np.array([0, 0, 0.2]), 0.03)),),
    )
    scene = plant_scene(plant, [], [])
    assert [(one["name"], one["kind"], one["role"]) for one in scene["static"]] == [
        ("table", "box", "obstacle"),
        ("wedge", "mesh", "obstacle"),
    ]
    np.testing.assert_array_equal(unpacked(scene["static"][1]["triangles"]), [[0, 1, 2]])
    (torch,) = [one for one in scene["bodies"] if one["role"] == "tool"]
    assert torch["link"] == len(scene["chain"]) - 1


def test_a_part_is_drawn_where_it_stands_with_the_flange_and_where_it_was_left() -> None:
    job = read_job(Path(__file__).parents[2] / "programs" / "machine_tending.mod")
    moves = [i for i, m in enumerate(job.program.motions) if not isinstance(m, SignalEvent)]
    motions = [SimpleNamespace(index=i, t_0=float(k), t_1=k + 1.0, dropped=False) for k, i in enumerate(moves)]
    rows = Trajectory(job.plant.limits.names, np.array([0.0, 10.0]), np.tile(job.plant.start, (2, 1)))
    plan = SimpleNamespace(motions=motions, trajectory=rows)
    scene = plant_scene(job.plant, [], [plan_cycle("one", job.program, plan, job.plant)])
    assert "blank" not in [one["name"] for one in scene["static"]]
    parts = [one for one in scene["cycles"][0]["parts"] if one["role"] == "part"]
    stands, held, left = sorted(parts, key=lambda one: one["from"])
    assert (stands["from"], stands["to"], held["to"], left["to"]) == (0.0, held["from"], left["from"], 11.0)
    taken = next(i for i, m in enumerate(job.program.motions) if isinstance(m, SignalEvent))
    assert held["from"] == moves.index(taken + 1)  # with the wait after the output
    assert [one["link"] for one in (stands, held, left)] == [-2, len(scene["chain"]) - 1, -2]
    np.testing.assert_allclose(np.reshape(held["X"], (4, 4))[:3, 3], [0, 0, 0.1], atol=1e-6)  # at the TCP
    np.testing.assert_allclose(np.reshape(left["X"], (4, 4))[:3, 3], [0.75, 0, 0.48], atol=1e-6)


def test_the_capsule_that_stands_for_the_tool_is_drawn_while_its_tool_is_in_force() -> None:
    """From the flange to one radius before the TCP, as the judge holds it; none for tool0."""
    data = "PERS tooldata tLong:=[TRUE,[[0,0,200],[1,0,0,0]],[1,[0,0,40],[1,0,0,0],0,0,0]];"
    data += "PERS tooldata tShort:=[TRUE,[[0,0,20],[1,0,0,0]],[1,[0,0,40],[1,0,0,0],0,0,0]];"
    joints = "[[0,0,0,0,{0},0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
    moves = [
        f"MoveAbsJ {joints.format(20 + k)},v100,fine,{tool};" for k, tool in enumerate(("tLong", "tShort", "tLong"))
    ]
    program = rapid("\n".join(moves), data=data)
    motions = [SimpleNamespace(index=k, t_0=float(k), t_1=k + 1.0, dropped=False) for k in range(3)]
    plant = plant_without_rail(tool_radius=0.025)
    rows = Trajectory(plant.limits.names, np.array([0.0, 3.0]), np.tile(plant.start, (2, 1)))
    cycle = plan_cycle("one", program, SimpleNamespace(motions=motions, trajectory=rows), plant)
    scene = plant_scene(replace(plant, obstacles=(Solid(Box("cube", np.ones(3))),)), [], [cycle])
    first, last = scene["cycles"][0]["parts"]
    for one, since, until in ((first, 0.0, 1.0), (last, 2.0, 4.0)):
        assert (one["role"], one["kind"], one["link"]) == ("tool", "capsule", len(scene["chain"]) - 1)
        assert (one["from"], one["to"], one["radius"]) == (since, until, 0.025)
        np.testing.assert_allclose([one["a"], one["b"]], [[0, 0, 0], [0, 0, 0.175]], atol=1e-12)
    assert [one["name"] for one in scene["static"]] == ["cube"]  # a tool's capsule is no part that leaves its place


def test_a_fine_mesh_is_drawn_coarser_with_the_same_outline() -> None:
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 301), np.linspace(0, np.pi, 201), indexing="ij")
    ball = np.stack([np.sin(v) * np.cos(u), np.sin(v) * np.sin(u), np.cos(v)], axis=-1).reshape(-1, 3)
    corner = (np.arange(300)[:, None] * 201 + np.arange(200)).ravel()
    fine = np.concatenate([corner[:, None] + [0, 201, 202], corner[:, None] + [0, 202, 1]])
    robot = plant_without_rail().robot
    shapes = [Mesh("ball", ball, fine, PLACE), Mesh("tip", np.eye(3), np.array([[0, 1, 2]]))]
    drawn, tip = robot_scene(robot, [], [], shapes)["static"]
    vertices, triangles = unpacked(drawn["vertices"]), unpacked(drawn["triangles"])
    assert len(fine) == 120_000
    assert 10_000 < len(triangles) <= 30_000
    np.testing.assert_allclose(np.linalg.norm(vertices, axis=1), 1.0, atol=1e-6)
    np.testing.assert_allclose([vertices.min(axis=0), vertices.max(axis=0)], [[-1] * 3, [1] * 3], atol=0.02)
    assert triangles.max() == len(vertices) - 1
    assert len(unpacked(tip["triangles"])) == 1


def test_a_robot_without_shapes_is_drawn_by_rods_between_its_joints() -> None:
    robot = replace(plant_without_rail().robot, bodies={})
    scene = robot_scene(robot, [], [])
    rods = [np.linalg.norm(body["b"]) for body in scene["bodies"]]
    np.testing.assert_allclose(rods, [np.hypot(0.07, 0.352), 0.36, 0.239, 0.141, 0.065])
