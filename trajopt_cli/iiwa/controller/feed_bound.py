"""A duration no dosed sequence can go below: how far the arm itself has to travel, and how fast it may be pushed.

When the plan is at a place the arm is within b of it, and along any way the arm gains at most c = B/h sum_j max W_j a
second, because its speed is a weighted sum of what the law pushed with: W_j the weights on the push j periods ago, B
its bound. So from one place to another it takes (their distance - 2 b) / c. Of all ways to lay such chords that do not
overlap, with the time at the caps between, the one that asks most is a bound of every sequence, corners cut or not.
Angles count where only one of them changes, for only there is a sum of turns a turn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_path import Allowed, DosePath
from trajopt_cli.iiwa.controller.regulator import Coefficients, coefficients
from trajopt_cli.iiwa.task.model import Compliance, Integration

_TAIL = 1e-15  # weights are summed until what is left is below this share of the sum
_MANY = 1_000_000  # weights at most; fewer than needed would make the bound too high
_ROUNDING = 1e-10  # share taken off the bound
_CHORDS = 600  # places of the path between which chords are laid


def least_duration(path: DosePath, h: float, law: Compliance, allowed: Allowed, integration: Integration) -> float:
    """Lower bound [s] of the duration of any sequence along path that keeps what is allowed.

    h [s]: the period. Dwells and the caps on ds/dt are counted. A row that is no waypoint is passed between two
    periods, when plan and arm may be a period's way farther apart.
    """
    marks = np.unique([0, *(leg.last for leg in path.legs)])
    even = np.searchsorted(path.s, np.linspace(0.0, path.s[-1], _CHORDS))
    rows = np.unique(np.concatenate([marks[:: -(-len(marks) // _CHORDS)], even, [0, len(path.s) - 1]]))
    dwells = np.zeros(len(path.s))
    for leg in path.legs:
        dwells[leg.last] += leg.dwell
    after = np.concatenate([[0.0], np.cumsum(np.diff(path.s) / path.cap)]) + np.cumsum(dwells)
    after, stays = after[rows], dwells[rows]
    asked = []
    for part, within, pace in _measures(path, h, law, allowed, integration):
        steps = np.linalg.norm(np.diff(path.pose[:, part], axis=0), axis=1) / np.diff(path.s) * path.cap
        slack = np.where(np.isin(rows, marks), within, within + h * (float(np.max(steps)) + pace))
        slack[0] = 0.0  # the arm starts exactly there
        asked.append((path.pose[rows, part], slack, pace))
    best = np.full(len(rows), stays[0])  # when the row is left
    for j in range(1, len(rows)):
        least = after[j] - stays[j] - after[:j]
        for place, slack, pace in asked:
            ways = np.linalg.norm(place[:j] - place[j], axis=1) - slack[:j] - slack[j]
            least = np.maximum(least, ways / pace)
        best[j] = stays[j] + float(np.max(best[:j] + least))
    return float(best[-1]) * (1 - _ROUNDING)


def _measures(
    path: DosePath, h: float, law: Compliance, allowed: Allowed, integration: Integration
) -> Iterator[tuple[slice, float, float]]:
    """Three of the six coordinates, how far the arm may be from its plan there, and its greatest gain a second."""
    axes, moves = coefficients(law.K, law.D, law.M, h, integration), path.moves
    for part, slack, lead in (
        (slice(0, 3), allowed.lag, allowed.lead),
        (slice(3, 6), allowed.turn_lag, allowed.turn_lead),
    ):
        if lead is None or slack is None or not any(moves[part]) or (part.start == 3 and sum(moves[part]) > 1):
            continue
        weights = _weights(axes[part], moves[part])  # by the deviation x_e - x
        if weights is not None:
            # a push of P is a deviation of P / k
            push = np.where(moves[part], law.K[part] * lead.weight(law.K[part]), 1.0)
            yield part, slack, lead.most / h * float(np.sum(np.max(np.abs(weights / push), axis=1)))


def _weights(axes: Sequence[Coefficients], moves: Sequence[bool]) -> Array | None:
    """Step of the position by the deviation x_e - x of j periods ago, (rows, 3); None where the sum has no end.

    v' = a v - b u and x' - x = p v - q u for u = x_e - x. Zero for an axis along which nothing moves.
    """
    used = {i: (a, b, p, q) for i, ((a, b, _, p, q, _), there) in enumerate(zip(axes, moves, strict=True)) if there}
    slowest = max(abs(a) for a, _, _, _ in used.values())
    if slowest >= 1:  # no damping: the speed under a held deviation grows without end
        return None
    rows = 2 if slowest == 0 else 2 + int(np.ceil(np.log(_TAIL) / np.log(slowest)))
    if rows > _MANY:
        return None
    powers = np.arange(rows - 1)
    weights = np.zeros((rows, 3))
    for i, (a, b, p, q) in used.items():
        weights[0, i] = -q
        weights[1:, i] = p * -b * np.power(a, powers)
    # What the cut-off tail could add at most, so that the bound stays one.
    weights[-1] += np.abs(weights[-1]) * slowest / (1 - slowest)
    return weights
