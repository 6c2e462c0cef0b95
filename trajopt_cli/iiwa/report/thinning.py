"""Fewer samples that show as all would."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, IndexArray

SHOWN = 2400
"""Points per curve that a page can show, highest and lowest of each bin kept."""


def thinned(values: Array, progress: Array | None = None, bins: int = SHOWN // 2) -> IndexArray:
    """Rows (k,) of values (n,) or (n, c) that show as all would: lowest and highest of each bin, first and last.

    progress (n,): what the bins are equal parts of, the row number unless given; it never falls.
    """
    columns = values.reshape(len(values), -1)
    n = len(columns)
    if n <= 2 * bins:
        return np.arange(n)
    along = np.arange(n, dtype=np.float64) if progress is None else progress
    which = (bins * (along - along[0]) / max(float(along[-1] - along[0]), 1e-300)).astype(int)
    starts = np.flatnonzero(np.diff(which, prepend=-1))
    counts = np.diff(starts, append=n)
    kept = [starts, np.array([n - 1])]
    for column in columns.T:
        for best in (np.minimum, np.maximum):
            hits = np.flatnonzero(column == np.repeat(best.reduceat(column, starts), counts))
            kept.append(hits[np.diff(which[hits], prepend=-1) > 0])  # the first of each bin
    return np.unique(np.concatenate(kept))
