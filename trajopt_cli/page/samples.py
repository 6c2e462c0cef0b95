"""Fewer rows for a page, none of whose curves shows: straight lines between those kept stay within a hair of all."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.limits import JointLimits
from trajopt_cli.trajectories.plan_series import before
from trajopt_cli.trajectory import Trajectory, hermite

GAP = 4e-3  # s between rows, at most, in cycles of up to a minute
ROWS = 15_000  # kept at least GAP apart; longer cycles have longer gaps where nothing bends
MOST_ROWS = 100_000  # about, whatever bends: of two cycles 25 MB of page; 300 moves of a pallet have 80,000
_HAIR = 2.5e-4  # of a limit, at each of the levels below: half a pixel of a chart is 3e-3
_LEVELS = 6
_CHUNK = 100_000  # rows looked at at once: those of an hour have no room in memory several times over


def sample_times(trajectory: Trajectory, limits: JointLimits, marks: Array, coarse: float = 1.0) -> Array:
    """Times (m,) [s] of the rows to keep, in order; where an acceleration jumps, the last number before the row, too.

    The first and the last row are kept, those at marks (times [s], in any order), and every row from which a line
    between its neighbours would be off by more than a hair, in position, speed or acceleration against the limits.
    coarse: how many times wider gap and hair may be; wider still where more than MOST_ROWS would be kept.
    """
    t = trajectory.t
    always = np.zeros(len(t), dtype=bool)
    always[np.clip(np.searchsorted(t, marks - 1e-9), 0, len(t) - 1)] = True
    while True:
        jumps, keep = np.zeros(len(t), dtype=bool), always.copy()
        gap = coarse * max(GAP, trajectory.duration / ROWS)
        for start in range(0, len(t), _CHUNK):
            part = slice(start, min(start + _CHUNK, len(t)))
            keep[part], jumps[part] = _kept(trajectory, limits, part, always[part], gap, coarse * _HAIR)
        jumps &= keep
        if keep.sum() + jumps.sum() <= MOST_ROWS or coarse * _HAIR >= 1:
            return np.sort(np.concatenate([t[keep], before(t[jumps])]))
        coarse *= 4


def _kept(
    trajectory: Trajectory, limits: JointLimits, part: slice, marked: BoolArray, gap: float, hair: float
) -> tuple[BoolArray, BoolArray]:
    """Which rows of a part stay, its ends among them, and at which an acceleration jumps."""
    t = trajectory.t[part]
    ahead = hermite(trajectory, t)
    behind = hermite(trajectory, np.maximum(before(t), trajectory.t[0]))[2]
    spans = limits.upper - limits.lower, limits.velocity, limits.acceleration
    values = np.hstack([value / span for value, span in zip(ahead, spans, strict=True)])
    jumps: BoolArray = np.asarray((np.abs(ahead[2] - behind) / limits.acceleration > hair * _LEVELS).any(axis=1))
    jumps[0] &= part.start > 0  # before the first row there is nothing
    fixed = marked | jumps
    fixed[[0, -1]] = True
    rows = np.arange(len(t))
    for _ in range(_LEVELS):
        rows = _thinned(rows, t, values, fixed, gap, hair)
    keep = np.zeros(len(t), dtype=bool)
    keep[rows] = True
    return keep, jumps


def _thinned(rows: IndexArray, t: Array, values: Array, fixed: BoolArray, gap: float, hair: float) -> IndexArray:
    """Without every second row that lies on the line between its neighbours, where those are no more than gap apart."""
    inner = np.arange(1, len(rows) - 1, 2)
    a, b, c = rows[inner - 1], rows[inner], rows[inner + 1]
    width = t[c] - t[a]
    share = ((t[b] - t[a]) / width)[:, None]
    off = np.abs(values[a] * (1 - share) + values[c] * share - values[b]).max(axis=1, initial=0.0)
    gone = (off <= hair) & (width <= gap * (1 + 1e-9)) & ~fixed[b]
    return np.delete(rows, inner[gone])
