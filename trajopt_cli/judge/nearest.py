r"""Whether joint moves with confdata switched off (ConfJ \Off) end in the posture nearest to where they begin.

All postures at a move's end are sought by Newton's steps with pin's Jacobians, from the one that the file shows and
from flipped wrists and shoulders over a grid of axes 2 and 3: measured on 80 random poses of two arms, these found all
that a closed form has.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, product

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import finding
from trajopt_cli.judge.geometry import rotation_vectors
from trajopt_cli.judge.samples import Rows
from trajopt_cli.judge.timeline import Timeline, Visit
from trajopt_cli.judge.tolerances import NEAREST
from trajopt_cli.motion import MoveJ

_STEPS = 20
_DAMPED = 1e-9  # of a step near a singularity, m2
_FOUND = 1e-9  # m and rad from the pose
_AXIS_2, _AXIS_3 = np.linspace(-1.5, 1.5, 4), np.linspace(-3.0, 1.5, 4)  # rad


def check_nearest(line: Timeline) -> Iterator[Finding]:
    """How much farther from its start each such move ends, in the root of the sum of the axes' squared turns [rad],
    than in the posture nearest to it."""
    for before, visit in pairwise(line.visits):
        move = visit.point.move
        if isinstance(move, MoveJ) and not move.settings.conf_j and None not in (before.event, visit.event):
            yield _farther(line.rows, before, visit)


def _farther(rows: Rows, before: Visit, visit: Visit) -> Finding:
    here, there = _posture(rows, before, before.depart), _posture(rows, visit, visit.arrive)
    limits, others = rows.plant.limits, _postures(rows, visit.X_WF, there)
    low, high = limits.lower[-6:], limits.upper[-6:]
    turns = (others[:, -6:] - here[-6:]) / (2 * np.pi)
    nearer = others[:, -6:] - 2 * np.pi * np.round(turns)
    nearer += (
        2
        * np.pi
        * (
            np.ceil((low - nearer - _FOUND) / (2 * np.pi)).clip(0)
            - np.ceil((nearer - high - _FOUND) / (2 * np.pi)).clip(0)
        )
    )
    ok = np.all((nearer >= low - _FOUND) & (nearer <= high + _FOUND), axis=1) & limits.couplings.within(
        np.concatenate([others[:, :-6], nearer], axis=1)
    )
    least = np.min(np.linalg.norm(nearer[ok] - here[-6:], axis=1), initial=np.inf)
    excess = max(float(np.linalg.norm(there[-6:] - here[-6:]) - least), 0.0)
    limit = NEAREST + float(np.linalg.norm(rows.doubt_q[visit.arrive]))
    return finding(
        "nearest posture", visit.point.name, excess, limit, "rad", excess <= limit, time=float(rows.t[visit.arrive]),
        source=visit.point.source, note=" farther than the nearest posture, which a controller takes under ConfJ \\Off",
    )  # fmt: skip


def _posture(rows: Rows, visit: Visit, row: int) -> Array:
    """All axes (k,) at a visit: of its row, or of the point near it that is passed."""
    q = np.array(rows.q[row])
    if visit.point.fly_by is None:
        return q
    found = _solved(rows, visit.X_WF, q[None])
    return found[0] if len(found) else q


def _postures(rows: Rows, X_WF: Array, q: Array) -> Array:
    """All axes (m, k) that bring the flange to X_WF with the rail where it is in q."""
    seeds = [q]
    for shoulder, wrist, axis_2, axis_3 in product((0.0, np.pi), (False, True), _AXIS_2, _AXIS_3):
        seed = q.copy()
        seed[-6] += shoulder
        seed[-5:-3] = axis_2, axis_3
        if wrist:
            seed[-3:] += [np.pi, -2 * seed[-2], np.pi]
        seeds.append(seed)
    return _solved(rows, X_WF, np.array(seeds))


def _solved(rows: Rows, X_WF: Array, q: Array) -> Array:
    """Those of axes (m, k) that get to the pose by Newton's steps of the arm, where they get."""
    q = q.copy()
    for step in range(_STEPS + 1):
        X, J = rows.mechanism.flange(q)
        turn = rotation_vectors(X_WF[:3, :3] @ X[:, :3, :3].transpose(0, 2, 1))
        error = np.concatenate([X_WF[:3, 3] - X[:, :3, 3], turn], axis=1)
        if step < _STEPS:
            J = J[:, :, -6:]
            damped = J @ J.transpose(0, 2, 1) + _DAMPED * np.eye(6)
            q[:, -6:] += (J.transpose(0, 2, 1) @ np.linalg.solve(damped, error[..., None]))[..., 0]
    return np.asarray(q[np.abs(error).max(axis=1) < _FOUND])
