"""A band of times answers what the table of all pairs does."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.geometry import IndexArray
from trajopt_cli.optimize.edges import Band, Dense

LABELS, RAILS = 3, 9


def states(rng: np.random.Generator) -> IndexArray:
    """Some pairs of label and rail number, in order."""
    return np.stack(np.nonzero(rng.random((LABELS, RAILS)) < 0.7))


@pytest.mark.parametrize("widest", [0, 1, 3, 8])
@pytest.mark.parametrize("seed", range(5))
def test_a_band_answers_as_the_table_of_all_pairs(seed: int, widest: int) -> None:
    """The table is filled pair by pair; times are whole numbers: of equal ones the first counts."""
    rng = np.random.default_rng(seed)
    best = {d: rng.integers(1, 4, (LABELS, RAILS - abs(d))) * 1.0 for d in range(-widest, widest + 1)}
    best[0][rng.random(best[0].shape) < 0.2] = np.inf
    a, b = states(rng), states(rng)
    table = np.full((a.shape[1], b.shape[1]), np.inf)
    for i, (label, rail) in enumerate(a.T):
        for j, (other, to) in enumerate(b.T):
            if label == other and abs(to - rail) <= widest:
                table[i, j] = best[to - rail][label, rail - max(0, rail - to)]
    band, dense = Band.between(best, LABELS, RAILS, a, b), Dense(table)
    before, behind = rng.integers(0, 3, len(table)) * 1.0, rng.integers(0, 3, table.shape[1]) * 1.0
    source, least = band.into(before)
    wanted, cost = dense.into(before)
    np.testing.assert_array_equal(least, cost)
    np.testing.assert_array_equal(source[np.isfinite(cost)], wanted[np.isfinite(cost)])
    np.testing.assert_array_equal(band.out(behind), dense.out(behind))
    np.testing.assert_array_equal(band.dense(), table)
    assert all(band.at(i, j) == table[i, j] for i, j in np.ndindex(table.shape))
