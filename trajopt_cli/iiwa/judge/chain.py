"""Poses that are passed without a stop: whether rows follow a chain of them, in its order, within two tolerances."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge.path import StraightPiece
from trajopt_cli.iiwa.judge.samples import Poses, worst
from trajopt_cli.iiwa.judge.tolerances import CAP
from trajopt_cli.judge.findings import finding
from trajopt_cli.motion import Source
from trajopt_cli.native.loops import loops

_LARGE = 0.1  # rad: a leg that turns less has turn vectors that add up like angles, to a thousandth


@dataclass(frozen=True, eq=False)
class Followed:
    """Rows first..last along a chain: the first and the last leg (n,) that each may be on, how far it is off [m], [rad]
    (n,). lost: the first row for which the chain has no place, in order and within the tolerances; None where the rows
    reach its end."""

    first: int
    last: int
    leg: NDArray[np.intp]
    ahead: NDArray[np.intp]
    off_p: Array
    off_q: Array
    lost: int | None


def follow(
    chain: list[StraightPiece], rows: Poses, first: int, tolerance: float, turn_tolerance: float, end: Array
) -> Followed:
    """Follow a chain from a row on until its end pose is reached. end (n,): how far each row from first on is from it,
    m plus rad, less what is allowed.

    A row takes the earliest place on the chain, not before that of the row before, from which it is within both
    tolerances: where this fails no other assignment in order does better. How far it is off is reported for the nearest
    place that lies a little ahead of it.
    """
    legs = np.array([_leg(leg, turn_tolerance) for leg in chain])
    left = [np.append(np.cumsum(legs[::-1, column])[::-1], 0.0) for column in (9, 10)]
    p, q = rows.p[first:], rows.q[first:]
    turned = q if chain[0].slerp else np.pad(chain[0].angles + chain[0].turned(q), ((0, 0), (0, 1)))
    steps = np.column_stack([np.append(0.0, one[first:]) for one in (rows.step_p, rows.step_q)])
    found, state = np.zeros((len(p), 4)), np.zeros(2, dtype=np.int64)
    tolerances = tolerance, turn_tolerance, found, state
    places = np.hstack([p, turned]), steps, end, np.concatenate(left)
    loops("trajopt_cli.iiwa.judge.follow_loops")["follow"](int(chain[0].slerp), legs, *places, *tolerances)
    count, how = state.tolist()
    lost, last = (first + count, len(rows.t) - 1)[how - 1] if how else None, count - 1
    while how == 0 and last + 1 < len(end) and end[last + 1] < end[last]:
        last += 1  # rows behind, at the end of the last leg
    found[count : last + 1] = found[count - 1]
    (leg, ahead), (off_p, off_q) = found[: last + 1, :2].astype(np.intp).T, found[: last + 1, 2:].T
    return Followed(first, first + last, leg, ahead, off_p, off_q, lost)


def _turn_tolerance(leg: StraightPiece, tolerance: float) -> float:
    """Turn vectors of a large turn are farther apart than the rotations, by up to the sine's share."""
    if leg.slerp and leg.L_q > _LARGE:
        tolerance *= (leg.L_q / 2) / math.sin(min(leg.L_q, math.pi) / 2)
    return tolerance


def _leg(leg: StraightPiece, turn_tolerance: float) -> Array:
    """A row of follow_loops' legs."""
    begin = leg.q if leg.slerp else np.append(leg.angles, 0.0)
    return np.array([*leg.p, *leg.way, *leg.turn, leg.L_p, leg.L_q, _turn_tolerance(leg, turn_tolerance), *begin])


def check_chain(
    name: str, chain: list[StraightPiece], rows: Poses, found: Followed, passing: tuple[float, float]
) -> Iterator[Finding]:
    """Findings about rows that follow a chain: order, both tolerances, and that it passes every pose within them."""
    source = chain[0].place
    t = rows.t
    lost = 0 if found.lost is None else 1
    yield finding(
        "order of poses", name, lost, 0, "rows", not lost, time=None if found.lost is None else float(t[found.lost]),
        source=source, words="leaves the poses, or their order, by more than the tolerance at",
    )  # fmt: skip
    if not len(found.leg):
        return
    most = max(_turn_tolerance(leg, passing[1]) for leg in chain)
    offs = (("path", found.off_p, passing[0], "m"), ("orientation", found.off_q, most, "rad"))
    for check, off, limit, unit in offs:
        at, words = t[found.first :], "is off the chain of poses by"
        yield worst(check, name, off, limit, unit, at, limit * CAP, source=source, words=words)
    yield _vertices(name, chain, rows, found, passing[0], source)


def _vertices(
    name: str, chain: list[StraightPiece], rows: Poses, found: Followed, tolerance: float, source: Source
) -> Finding:
    """How far poses are from the straight path between rows, at most. What such a path cuts off a curve is granted: an
    eighth of the greatest change of step."""
    p = rows.p[found.first : found.last + 1]
    steps = np.diff(p, axis=0)
    sag = float(np.linalg.norm(np.diff(steps, axis=0), axis=1).max(initial=0.0)) / 8
    along = np.cumsum([0.0, *(leg.L_p for leg in chain)])
    of_row = along[found.leg]
    farthest, at, legs = 0.0, 0, chain[1 : int(found.leg[-1]) + 1]
    for i, leg in enumerate(legs, start=1):
        # rows on the leg before are counted from its beginning
        begin = max(0, int(np.searchsorted(of_row, along[i - 1] - 4 * tolerance, side="left")) - 1)
        finish = min(len(steps), int(np.searchsorted(of_row, along[i], side="right")) + 2)
        a, b = p[begin:finish], steps[begin:finish]
        w = leg.p - a
        u = np.clip(np.sum(w * b, axis=1) / np.maximum(np.sum(b * b, axis=1), 1e-300), 0.0, 1.0)
        near = np.linalg.norm(w - u[:, None] * b, axis=1)
        if len(near) and near.min() > farthest:
            farthest, at = float(near.min()), begin + int(np.argmin(near))
    limit = tolerance + sag
    passed, time = farthest <= limit, float(rows.t[found.first + at])
    words = "passes a pose at"
    return finding("poses passed", name, farthest, limit, "m", passed, time=time, source=source, words=words)
