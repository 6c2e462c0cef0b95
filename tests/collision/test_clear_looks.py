"""How often a motion is looked at for what it may touch: however long it takes, and whatever of it rests."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, rapid

from trajopt_cli.collision.collision_scene import CollisionScene
from trajopt_cli.settings import DEFAULT
from trajopt_cli.shapes import Capsule, Solid
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, Pieces, sample_times

DAY = 86_400.0
STEP = 5e-3  # s between two looks
POST = Solid(Capsule("post", np.array([0.45, 0.3, 0.0]), np.array([0.45, 0.3, 0.7]), 0.05))


def way(T: float, n: int = 7) -> JointNodes:
    """From rest to rest in three intervals: speeding up, even, slowing down."""
    grid = np.array([0.0, 0.25, 0.75, 1.0])
    q, v, a = ([0.0, 0.05, 0.25, 0.3], [0.0, 0.4, 0.4, 0.0], [1.6, 0.0, -1.6])
    return JointNodes(T, grid, *(np.repeat(np.array(x)[:, None], n, axis=1) for x in (q, v, a)))


def rest(T: float, n: int = 7) -> JointProfiles:
    return JointProfiles(T, np.full(n, 0.3), np.zeros(n), np.tile([0.0, 0.0, 0.0, T], (n, 1)), np.zeros((n, 3)))


def test_a_way_and_a_days_rest_is_looked_at_as_the_way_alone() -> None:
    alone, first = sample_times(way(1.0), STEP, 1, DEFAULT.most_samples)
    t, begins = sample_times(Pieces((way(1.0), rest(DAY))), STEP, 1, DEFAULT.most_samples)
    np.testing.assert_array_equal(t[: len(alone)], alone)
    np.testing.assert_array_equal(t[len(alone) :], [1.0 + DAY])
    np.testing.assert_array_equal(t[begins], [0.0, 0.25, 0.75, 1.0])
    assert np.diff(alone).max() <= STEP * (1 + 1e-9)
    assert len(alone) == 201
    np.testing.assert_array_equal(first, [0, 50, 150])


def test_a_motion_of_a_day_is_looked_at_so_often_and_no_more() -> None:
    t, begins = sample_times(way(DAY), STEP, 1, DEFAULT.most_samples)
    assert len(t) == 3 * DEFAULT.most_samples + 1
    np.testing.assert_allclose(t[begins], [0.0, 0.25 * DAY, 0.75 * DAY])
    assert (t[0], t[-1]) == (0.0, DAY)


@pytest.mark.parametrize("question", ["distances", "contacts"])
def test_many_places_take_the_memory_of_some(question: str) -> None:
    plant = replace(plant_with_rail(), obstacles=(POST,), clearance=0.02)
    around = CollisionScene(plant, rapid("MoveAbsJ j_home,v1000,fine,tool0;"))
    q = np.random.default_rng(3).uniform(plant.limits.lower, plant.limits.upper, (4 * (DEFAULT.batch // 2), 7))

    def peak(rows: int) -> int:
        tracemalloc.start()
        try:
            around.distances(q[:rows], 0) if question == "distances" else around.contacts(q[:rows], 0, 1e-3)
            return tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()

    peak(10)
    assert peak(4 * (DEFAULT.batch // 2)) < 2 * peak(DEFAULT.batch // 2)


def test_places_in_parts_answer_as_all_at_once() -> None:
    plant = replace(plant_with_rail(), obstacles=(POST,), clearance=0.02)
    around = CollisionScene(plant, rapid("MoveAbsJ j_home,v1000,fine,tool0;"))
    q = np.random.default_rng(4).uniform(plant.limits.lower, plant.limits.upper, ((DEFAULT.batch // 2) + 50, 7))
    tail = slice((DEFAULT.batch // 2) - 20, None)
    np.testing.assert_allclose(around.distances(q, 0)[tail], around.distances(q[tail], 0), rtol=0, atol=1e-15)
    found, wanted = around.contacts(q, 0, 0.05), around.contacts(q[tail], 0, 0.05)
    here = found.row >= tail.start
    np.testing.assert_array_equal(found.row[here] - tail.start, wanted.row)
    np.testing.assert_allclose(found.distance[here], wanted.distance, rtol=0, atol=1e-15)
    assert [found.names[i] for i in found.pair[here]] == [wanted.names[i] for i in wanted.pair]
