"""Numbers as text: byte for byte what Python's own formatting writes, and what it reads back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trajopt_cli.decimals import Bytes, read_back, rows_of, texts

TENS = 10.0 ** np.arange(-5, 17)
EDGES = np.concatenate(
    [
        [0.0, -0.0, 0.5, 0.25, 2.0**49 + 0.5, 123456789012345.6, 9.999999999999999e-5, 5e-324, 1.8e308],
        TENS,
        np.nextafter(TENS, 0),
        np.nextafter(TENS, np.inf),
        -(np.arange(1, 200) / 2.0**12),
    ]
)


def read(found: Bytes) -> list[str]:
    return [bytes(row[row != 0]).decode() for row in found]


@pytest.mark.parametrize("digits", [15, 17])
def test_edges_are_written_as_python_writes_them(digits: int) -> None:
    assert read(texts(EDGES, digits)) == [f"{value:.{digits}g}" for value in EDGES.tolist()]


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=1, max_size=50), st.sampled_from([15, 17]))
def test_any_number_is_written_as_python_writes_it(values: list[float], digits: int) -> None:
    assert read(texts(np.array(values), digits)) == [f"{value:.{digits}g}" for value in values]


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(1e-4, 1e12) | st.just(0.0), min_size=1, max_size=50))
def test_texts_are_read_back_as_python_reads_them(values: list[float]) -> None:
    assert read_back(np.array(values), 15).tolist() == [float(f"{value:.15g}") for value in values]


def test_a_table_longer_than_a_part() -> None:
    table = np.random.default_rng(1).normal(size=(20_000, 3))
    found = b"".join(rows_of([table[:, :2], table[:, 2:]], texts(np.arange(20_000) / 8)))
    wanted = [",".join(f"{x:.17g}" for x in (k / 8, *row)) + "\n" for k, row in enumerate(table.tolist())]
    assert found.decode() == "".join(wanted)
