"""A duration no dosed sequence can go below: how far the arm itself has to travel, and how fast it may be pushed.

When the plan is at waypoint X_i the arm is within b of it, at p_i = X_i + b xi_i with ||xi_i|| <= 1 (the first exactly
at it, at rest). Along the chord n between two of them the arm gains at most c(n) a second, because its speed is a
weighted sum of what the law pushed with: c(n) = B/h sum_j ||W_j n||, W_j the weights on the push j periods ago and B
its bound. So the way takes n (p_k - p_i) / c(n).

Summed over the legs by parts, a corner with mu = n/c before and mu' after gives back at most b ||mu - mu'||. Where legs
are short against b that sum is void; then chords over many legs may say more: of all ways to lay chords that do not
overlap, with the time at the caps between them, the one that asks most is a bound, too. Both hold for every sequence,
corners cut or not. Angles count where only one of them changes, for only there is a sum of turns a turn.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_path import Allowed, DosePath
from trajopt_cli.iiwa.controller.regulator import Coefficients, coefficients
from trajopt_cli.iiwa.task.model import Compliance, Integration

_TAIL = 1e-15  # weights are summed until what is left is below this share of the sum
_MANY = 1_000_000  # weights at most; fewer than needed would make the bound too high
_ROUNDING = 1e-10  # share taken off the bound
_CHORDS = 600  # places of the path between which chords are laid


@dataclass(frozen=True, eq=False)
class _Measure:
    """Three of the six coordinates (part): slack, how far the arm may be from its plan; most, the bound on the push
    that weights (rows, 3) turn into steps."""

    part: slice
    slack: float
    most: float
    weights: Array

    def pace(self, n: Array, h: float) -> float:
        """Greatest gain a second along the unit vector n (3,)."""
        return self.most / h * float(np.sum(np.linalg.norm(self.weights * n, axis=1)))

    def greatest_pace(self, h: float) -> float:
        """The same along whatever direction."""
        return self.most / h * float(np.sum(np.max(np.abs(self.weights), axis=1)))


def least_duration(path: DosePath, h: float, law: Compliance, allowed: Allowed, integration: Integration) -> float:
    """Lower bound [s] of the duration of any sequence along path that keeps what is allowed.

    h [s]: the period. Dwells and the caps on ds/dt are counted.
    """
    times = np.diff(path.s) / path.cap
    own = np.array([leg.dwell + float(np.sum(times[leg.first : leg.last])) for leg in path.legs])  # at the caps
    measures = _measures(path, h, law, allowed, integration)
    choices = [[measure] for measure in measures] + ([measures] if len(measures) > 1 else [])
    bounds = [_total(path, h, own, choice) for choice in choices]
    bounds += [_chords(path, h, measure) for measure in measures]
    return max([float(np.sum(own)), *bounds]) * (1 - _ROUNDING)


def _measures(path: DosePath, h: float, law: Compliance, allowed: Allowed, integration: Integration) -> list[_Measure]:
    axes = coefficients(law.K, law.D, law.M, h, integration)
    moves = path.moves
    out = []
    for part, slack, lead in (
        (slice(0, 3), allowed.lag, allowed.lead),
        (slice(3, 6), allowed.turn_lag, allowed.turn_lead),
    ):
        if slack is None or not any(moves[part]) or (part.start == 3 and sum(moves[part]) > 1):
            continue
        weights = _weights(axes[part], moves[part])  # by the deviation x_e - x
        if weights is not None and lead is not None:
            # a push of P is a deviation of P / k
            push = np.where(moves[part], law.K[part] * lead.weight(law.K[part]), 1.0)
            out.append(_Measure(part, slack, lead.most, weights / push))
    return out


def _total(path: DosePath, h: float, own: Array, measures: Sequence[_Measure]) -> float:
    """The bound in which every leg is counted by the measure that asks most of it, or by its own time."""
    push = [np.zeros(3) for _ in measures]  # mu of the leg before
    total = 0.0
    for i, leg in enumerate(path.legs):
        # Any of a leg's bounds may stand in the sum; a lag's only where it beats the caps with both ends.
        most, chosen, asked = float(own[i]), float(own[i]), (-1, np.zeros(3))
        for which, measure in enumerate(measures):
            chord = path.pose[leg.last, measure.part] - path.pose[leg.first, measure.part]
            length = float(np.linalg.norm(chord))
            if length == 0:
                continue
            n = chord / length
            pace = measure.pace(n, h)
            if (length - 2 * measure.slack) / pace > most:
                most = (length - 2 * measure.slack) / pace
                chosen, asked = length / pace, (which, n / pace)
        total += chosen
        for which, measure in enumerate(measures):
            mu = asked[1] if which == asked[0] else np.zeros(3)
            if i > 0:  # the arm starts exactly at the first waypoint
                total -= measure.slack * float(np.linalg.norm(push[which] - mu))
            push[which] = mu
    return total - sum(measure.slack * float(np.linalg.norm(mu)) for measure, mu in zip(measures, push, strict=True))


def _chords(path: DosePath, h: float, measure: _Measure) -> float:
    """The most that chords between rows of the path ask for, each counted at the pace of the fastest direction.

    A row that is no waypoint is passed between two periods, when plan and arm may be a period's way farther apart.
    """
    marks = np.unique([0, *(leg.last for leg in path.legs)])
    even = np.searchsorted(path.s, np.linspace(0.0, path.s[-1], _CHORDS))
    rows = np.unique(np.concatenate([marks[:: -(-len(marks) // _CHORDS)], even, [0, len(path.s) - 1]]))
    steps = np.linalg.norm(np.diff(path.pose[:, measure.part], axis=0), axis=1) / np.diff(path.s) * path.cap
    pace = measure.greatest_pace(h)
    slack = np.where(np.isin(rows, marks), measure.slack, measure.slack + h * (float(np.max(steps)) + pace))
    slack[0] = 0.0
    dwells = np.zeros(len(path.s))
    for leg in path.legs:
        dwells[leg.last] += leg.dwell
    after = np.concatenate([[0.0], np.cumsum(np.diff(path.s) / path.cap)]) + np.cumsum(dwells)
    after, stays = after[rows], dwells[rows]
    place = path.pose[rows, measure.part]
    best = np.full(len(rows), stays[0])  # when the row is left
    for j in range(1, len(rows)):
        ways = np.linalg.norm(place[:j] - place[j], axis=1) - slack[:j] - slack[j]
        best[j] = stays[j] + float(np.max(best[:j] + np.maximum(ways / pace, after[j] - stays[j] - after[:j])))
    return float(best[-1])


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
