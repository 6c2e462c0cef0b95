"""Joint angles as numbers on a circle: half turns, full turns, and ranges that none of them enters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import degrees, pi

import numpy as np

from trajopt_cli.geometry import Array

ON_LIMIT = 1e-9  # rad or m: a solution this little outside a limit stands on it


def close_at_pi(angle: Array) -> None:
    """Move -pi, which arctan2 gives for a negative zero, to pi, in place."""
    low = angle <= -pi
    if low.any():
        angle[low] = pi


def half_turn(angle: Array) -> Array:
    """Angles in (-pi, pi] turned by half a turn, in (-pi, pi] again; 0 turns to pi, hence the shift of the sign."""
    turned: Array = angle - np.copysign(pi, angle - 1e-300)
    close_at_pi(turned)  # of an angle next to zero nothing is left beside pi
    return turned


def excess(value: float, low: float, high: float) -> tuple[float, float, float]:
    """How far value + 2 pi k stays outside low..high at least, that value, and the limit it breaks."""
    turned = [value + 2 * pi * k for k in range(-3, 4)]
    return min((max(low - v, v - high, 0.0), v, low if v < low else high) for v in turned)


def broken_limits(branches: Mapping[str, Array], names: Sequence[str], lower: Array, upper: Array) -> str | None:
    """One clause saying which joint limits (k,) [rad] keep every branch out; None where a branch is within them all.

    branches: finite joints (k,) by what the branch is called. A joint is out if no turn of it is within its range.
    """
    broken: dict[str, dict[int, tuple[float, float, float]]] = {}  # branch -> joint -> (excess, value, limit)
    for branch, q in branches.items():
        excesses = ((i, excess(float(q[i]), float(lower[i]), float(upper[i]))) for i in range(len(names)))
        broken[branch] = {i: found for i, found in excesses if found[0] > ON_LIMIT}
        if not broken[branch]:
            return None

    def say(i: int, value: float, limit: float) -> str:
        return f"{names[i]} = {degrees(value):.6g}°, limit {degrees(limit):.6g}°"

    order = list(broken)
    common = set.intersection(*(set(joints) for joints in broken.values()))
    if common:
        _, place, i = min((broken[branch][i][0], order.index(branch), i) for branch in broken for i in common)
        nearest = say(i, *broken[order[place]][i][1:])
        return f"every branch needs {names[i]} beyond its range: nearest {nearest} ({order[place]})"
    worst = {branch: max(joints.items(), key=lambda item: item[1][0]) for branch, joints in broken.items()}
    order.sort(key=lambda branch: worst[branch][1][0])
    return "every branch breaks a joint limit: " + "; ".join(
        f"{branch} needs {say(worst[branch][0], *worst[branch][1][1:])}" for branch in order
    )
