"""What the planner knows of its surroundings: by pin and coal, one by one; gradients by differences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from clear_of import by_pin_and_coal
from link_poses import link_poses
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.collision.collision_scene import CollisionScene, links
from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.problem.plant import Plant
from trajopt_cli.settings import DEFAULT
from trajopt_cli.shapes import Box, Capsule, Solid

POST = Solid(Capsule("post", np.array([0.45, 0.3, 0.0]), np.array([0.45, 0.3, 0.7]), 0.05))
SHELF = Solid(Box("shelf", np.array([0.4, 0.3, 0.05]), pose(rotation_about([0, 0, 1], 0.4), [0.5, 0.7, 0.55])),
              frozenset({"link_3"}))  # fmt: skip
GRIPPER = Solid(Box("gripper", np.array([0.1, 0.06, 0.12]), pose(np.eye(3), [0, 0, 0.06])))
PROGRAM = rapid("MoveAbsJ j_home,v1000,fine,tool0;")


def crowded(rail: bool = True) -> Plant:
    plant = plant_with_rail() if rail else plant_without_rail()
    return replace(plant, obstacles=(POST, SHELF), attached=(GRIPPER,), clearance=0.02)


def some_axes(plant: Plant, n: int, seed: int = 5) -> Array:
    return np.random.default_rng(seed).uniform(plant.limits.lower, plant.limits.upper, (n, len(plant.limits.lower)))


@pytest.mark.parametrize("rail", [True, False])
def test_the_links_are_where_pin_has_them(rail: bool) -> None:
    plant = crowded(rail)
    q = some_axes(plant, 20)
    np.testing.assert_allclose(links(plant.robot, q)[:, :7], link_poses(plant.robot, q), rtol=0, atol=1e-12)
    np.testing.assert_allclose(links(plant.robot, q)[:, 7], plant.robot.forward(q), rtol=0, atol=1e-12)


@pytest.mark.parametrize("rail", [True, False])
def test_distances_are_those_of_pin_and_coal(rail: bool) -> None:
    plant = crowded(rail)
    q = some_axes(plant, 200)
    around, wanted = CollisionScene(plant, PROGRAM), by_pin_and_coal(plant, q) - DEFAULT.clearance_margin
    found = around.distances(q, 0)
    outside = wanted > 0.02
    assert 20 < outside.sum() < 180
    np.testing.assert_allclose(found[outside], wanted[outside], rtol=0, atol=1e-9)
    np.testing.assert_array_equal(around.free(q, 0), wanted >= 0)
    assert not around.free(np.full_like(q[:1], np.nan), 0).any()


def test_gradients_are_those_of_differences() -> None:
    plant = crowded()
    around, q, h = CollisionScene(plant, PROGRAM), some_axes(plant, 60), 1e-6
    found = around.contacts(q, 0, within=0.15)
    assert len(found.row) > 60
    off = []
    for row, pair, distance, gradient in zip(found.row, found.pair, found.distance, found.gradient, strict=True):
        moved = q[row] + h * np.concatenate([np.eye(7), -np.eye(7)])
        beside = around.contacts(moved, 0, within=0.2)
        near = {(r, beside.names[p]): d for r, p, d in zip(beside.row, beside.pair, beside.distance, strict=True)}
        name = found.names[pair]
        numbers = np.array([near[j, name] - near[7 + j, name] for j in range(7)]) / (2 * h)
        off.append(np.abs(numbers - gradient).max())
        assert near[0, name] == pytest.approx(distance, abs=1e-5)
    assert np.quantile(off, 0.95) < 1e-4  # a few lie on a kink


def test_straight_ways_are_free_where_no_place_on_them_is_not() -> None:
    plant = crowded()
    rng, around = np.random.default_rng(8), CollisionScene(plant, PROGRAM)
    q = some_axes(plant, 4000, 9)
    q = q[around.free(q, 0)][:140]
    a, b = q[:70], q[:70] + rng.choice([0.1, 0.3, 1.0], (70, 1)) * (q[70:] - q[:70])
    found = around.free_between(a, b, 0)
    for one, start, end in zip(found, a, b, strict=True):
        way = start + np.linspace(0, 1, 200)[:, None] * (end - start)
        least = by_pin_and_coal(plant, way).min() - DEFAULT.clearance_margin
        assert one == (least >= 0) or abs(least) < 2e-3, least  # 200 places leave a few mm of way between them
        assert not one or least >= 0
    assert 5 < found.sum() < 68


def test_nothing_to_avoid_where_there_is_nothing() -> None:
    robot = replace(plant_without_rail().robot, bodies={}, self_pairs=())
    around = CollisionScene(replace(plant_without_rail(), robot=robot), PROGRAM)
    assert not around.anything
    assert around.free(np.zeros((3, 6)), 0).all()
    assert not len(around.contacts(np.zeros((3, 6)), 0, 1.0).row)


def test_a_hit_is_said_with_its_depth() -> None:
    plant = replace(plant_without_rail(), obstacles=(POST,))
    q = some_axes(plant, 500)
    around = CollisionScene(plant, PROGRAM)
    hit, *others = around.hits(q, 0)
    assert all(other.missing <= hit.missing for other in others)
    assert not around.free(hit.q[None], 0).any()
    assert "inside 'post'" in hit.said or "inside link" in hit.said or "inside base" in hit.said
