"""A band of times, and times that are found where they matter, answer what the table of all pairs does."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.graph_search.edges import Band, Dense, Lazy

LABELS, RAILS = 3, 9


def states(rng: np.random.Generator) -> IndexArray:
    """Some pairs of label and rail number, in order."""
    return np.stack(np.nonzero(rng.random((LABELS, RAILS)) < 0.7))


@pytest.mark.parametrize("widest", [0, 1, 3, 8])
@pytest.mark.parametrize("seed", range(5))
def test_a_band_answers_as_the_table_of_all_pairs(seed: int, widest: int) -> None:
    """The table is filled pair by pair; times are whole numbers: of equal ones the first counts."""
    rng = np.random.default_rng(seed)
    shifts = np.arange(widest, -widest - 1, -1)
    behind = np.arange(RAILS) + shifts[:, None]
    times = rng.integers(1, 4, (len(shifts), LABELS, RAILS)) * 1.0
    times[rng.random(times.shape) < 0.1] = np.inf
    times[np.broadcast_to(((behind < 0) | (behind >= RAILS))[:, None], times.shape)] = np.inf
    a, b = states(rng), states(rng)
    table = np.full((a.shape[1], b.shape[1]), np.inf)
    for i, (label, rail) in enumerate(a.T):
        for j, (other, to) in enumerate(b.T):
            if label == other and abs(to - rail) <= widest:
                table[i, j] = times[widest - (to - rail), label, rail]
    band, dense = Band(shifts, times, a, b), Dense(table)
    before, beyond = rng.integers(0, 3, len(table)) * 1.0, rng.integers(0, 3, table.shape[1]) * 1.0
    source, least = band.into(before)
    wanted, cost = dense.into(before)
    np.testing.assert_array_equal(least, cost)
    np.testing.assert_array_equal(source[np.isfinite(cost)], wanted[np.isfinite(cost)])
    np.testing.assert_array_equal(band.out(beyond), dense.out(beyond))
    np.testing.assert_array_equal(band.dense(), table)
    every = np.indices(table.shape)
    np.testing.assert_array_equal(band.at(*every), table)
    np.testing.assert_array_equal([band.at(i, j) for i, j in np.ndindex(table.shape)], table.ravel())


@pytest.mark.parametrize("seed", range(5))
def test_times_in_doubt_are_found_where_they_matter_and_only_there(seed: int) -> None:
    """A doubtful time is at most the true one; of 40 x 30 of them a few answer for all, a nearer one spares most."""
    rng = np.random.default_rng(seed)
    true = rng.uniform(1, 9, (40, 30))
    doubt = (rng.random(true.shape) < 0.8).astype(np.int8)
    asked = np.zeros((2, *true.shape), dtype=int)
    near = true - 0.01

    def nearer(i: IndexArray, j: IndexArray) -> Array:
        np.add.at(asked[0], (i, j), 1)
        return near[i, j]

    def sure(i: IndexArray, j: IndexArray) -> Array:
        np.add.at(asked[1], (i, j), 1)
        return true[i, j]

    first = np.where(doubt, true - rng.uniform(0.01, 1.5, true.shape), true)
    lazy, dense = Lazy(first, 2 * doubt, (nearer, sure)), Dense(true)
    before, beyond = rng.uniform(0, 5, 40), rng.uniform(0, 5, 30)
    for mine, its in zip(lazy.into(before), dense.into(before), strict=True):
        np.testing.assert_array_equal(mine, its)
    least = dense.out(beyond)
    most = np.full(40, np.median(least))
    early = lazy.out(beyond, most)
    np.testing.assert_array_equal(early[least <= most], least[least <= most])
    assert np.all(early[least > most] > most[0])
    np.testing.assert_array_equal(lazy.out(beyond), least)
    assert 0 < asked[1].sum() < 0.25 * true.size
    assert asked[0].sum() > 0
    assert asked.max() == 1
    assert lazy.at(3, 4) == true[3, 4]
    np.testing.assert_array_equal(lazy.at(np.arange(40), 5), true[:, 5])
    np.testing.assert_array_equal(lazy.dense(), true)


def test_a_single_state_behind_is_settled_from_every_state_before_it() -> None:
    """Going back from one state every one of the states before it needs its own time."""
    true = np.array([[3.0], [2.0], [4.0]])
    lazy = Lazy(true - 1, np.ones((3, 1), dtype=np.int8), (lambda i, j: true[i, j],))
    np.testing.assert_array_equal(lazy.out(np.zeros(1)), true[:, 0])


def test_a_band_the_other_way_round_has_the_times_transposed() -> None:
    rng = np.random.default_rng(3)
    shifts = np.arange(4, -5, -1)
    behind = np.arange(RAILS) + shifts[:, None]
    times = rng.uniform(1, 4, (len(shifts), LABELS, RAILS))
    times[np.broadcast_to(((behind < 0) | (behind >= RAILS))[:, None], times.shape)] = np.inf
    a, b = states(rng), states(rng)
    np.testing.assert_array_equal(Band(shifts, times, a, b).back(b, a).dense(), Band(shifts, times, a, b).dense().T)
