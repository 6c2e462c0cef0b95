"""From which rail positions a flange pose can be reached: the offsets of Krotký 2014, 5.2.1, with joint limits."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.arm import elbow_angle
from trajopt_cli.robot.inverse import inverse

STEP = 2e-3  # m of rail between two tests; a gap or an island narrower than this may be missed
EXACT = 1e-6  # m to which the ends of a range are found
_ON_LIMIT = 1e-9  # rad a joint may stand outside its limit by rounding


def reachable(plant: Plant, X_WF: Array, rail: Array, phi_min: float = 0.0, branch: int | None = None) -> BoolArray:
    """Whether the arm reaches flange pose X_WF (4, 4) from rail positions (n,) [m], joint limits kept: (n,).

    phi_min [rad]: least angle of the elbow from stretched or folded. branch: only this cfx, any for None.
    """
    rail = np.asarray(rail, dtype=np.float64)
    q = inverse(plant.robot, np.broadcast_to(X_WF, (len(rail), 4, 4)), rail if plant.robot.has_rail else None)
    low, high = plant.limits.lower[plant.layout.arm], plant.limits.upper[plant.layout.arm]
    # A joint's angle is known up to whole turns; it is inside its range if any turn of it is.
    turns = np.ceil((low - _ON_LIMIT - q) / (2 * np.pi))
    with np.errstate(invalid="ignore"):
        inside = (q + 2 * np.pi * turns <= high + _ON_LIMIT).all(axis=2)
        inside &= plant.limits.couplings.arm(plant.layout.arm).within(q + 2 * np.pi * turns)
        inside &= np.abs(np.cos(elbow_angle(plant.robot.arm, q))) >= np.sin(phi_min)
    if branch is not None:
        inside = inside[:, branch : branch + 1]
    return np.asarray(inside.any(axis=1))


def rail_ranges(plant: Plant, X_WF: Array, phi_min: float = 0.0, branch: int | None = None) -> Array:
    """All ranges of the rail from which flange pose X_WF (4, 4) can be reached: (m, 2) [m], in order, m = 0 for none.

    The thesis' least and greatest offset d of a work point, but as rail positions and inside the stroke. Arguments as
    in reachable. Raises ValueError for a robot without a rail.
    """
    if not plant.robot.has_rail:
        raise ValueError(f"rail_ranges: robot {plant.robot.name} has no rail")
    low, high = (float(plant.layout.place(end)) for end in (plant.limits.lower, plant.limits.upper))
    rail = np.linspace(low, high, int(np.ceil((high - low) / STEP)) + 1)
    ok = reachable(plant, X_WF, rail, phi_min, branch)
    edges = np.flatnonzero(np.diff(ok.astype(int)))
    inner, outer = rail[edges + ~ok[edges]], rail[edges + ok[edges]]  # on this and on the far side of each border
    while len(edges) and np.max(np.abs(outer - inner)) > EXACT:
        middle = (inner + outer) / 2
        good = reachable(plant, X_WF, middle, phi_min, branch)
        inner, outer = np.where(good, middle, inner), np.where(good, outer, middle)
    ends = np.r_[[low] if ok[0] else [], inner, [high] if ok[-1] else []]
    return np.asarray(ends.reshape(-1, 2))


def sections(plant: Plant, count: int = 361) -> tuple[Array, ...]:
    """Outlines (n, 2) [m] of what the wrist centre reaches in the arm's own plane, elbow bent the one or the other way.

    Columns: ahead of axis 1 and up, in the arm's canonical base. Joints 2 and 3 stay in range. Together they are the
    thesis' figure 5.1; each is joint 2 at its least, the elbow as stretched as it may be, joint 2 at its greatest, the
    elbow as folded as it may be. A parallel linkage leaves the elbow one way, so there is one outline.
    """
    arm, joints = plant.robot.arm, plant.layout.arm
    ends = [arm.signs * q[joints] + arm.offsets for q in (plant.limits.lower, plant.limits.upper)]
    low, high = np.minimum(*ends), np.maximum(*ends)
    t2, turns = np.linspace(low[1], high[1], count), 2 * np.pi * np.arange(-3, 4)
    stretched = -np.pi / 2
    back = (t2 - arm.offsets[1])[:, None] * arm.coupled  # a parallel linkage turns the elbow as joint 2 turns

    def outline(folded: float) -> Array:
        least, most = min(folded, stretched), max(folded, stretched)
        a, b = np.maximum(low[2] - back + arm.bend + turns, least), np.minimum(high[2] - back + arm.bend + turns, most)
        held = b > a
        none = ~held.any(axis=1)
        least_held = np.where(none, stretched, np.where(held, a, np.inf).min(axis=1))
        most_held = np.where(none, stretched, np.where(held, b, -np.inf).max(axis=1))
        first, last = (most_held, least_held) if folded > stretched else (least_held, most_held)
        a = np.concatenate([np.full(count, low[1]), t2, np.full(count, high[1]), t2[::-1]])
        sides = np.linspace(first[0], last[0], count), np.linspace(last[-1], first[-1], count)
        b = np.concatenate([sides[0], last, sides[1], first[::-1]])
        x = arm.a1 + arm.c2 * np.sin(a) + arm.upper * np.cos(a + b)
        return np.column_stack([x, arm.c1 + arm.c2 * np.cos(a) - arm.upper * np.sin(a + b)])

    return tuple(outline(folded) for folded in ((np.pi / 2,) if arm.coupled else (np.pi / 2, -1.5 * np.pi)))
