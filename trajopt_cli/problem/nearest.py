r"""The configuration a controller takes where confdata is switched off: the one nearest to where the arm stands.

With ConfJ \Off a joint move ends, of all joints that reach its target with the external axes where the target has them,
in those closest to the joints it begins with, turns of axes included; a line is always driven in the closest
configuration, the one its way leads to (RAPID reference manual, robot configuration; ConfJ; ConfL). ABB publishes no
measure of close. Here it is the sum of the squares of the axes' turns, and who asks is told where another measure, the
largest turn or the sum of turns, has another configuration nearest.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import ConfData, Motion, PathMove
from trajopt_cli.problem.plan import PlannedMotion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import confdata_admits, folded, solutions

_ALIKE = 1e-9  # rad2 or rad: below, two configurations are equally near
SAME_JOINTS = 1e-6  # rad between joints that are one configuration


def nearest(plant: Plant, X_WF: Array, rail: Array | float | None, arm: Array, conf: ConfData | None = None) -> Array:
    """Arm joints (n, 6) [rad] nearest to joints arm (n, 6), of those that bring the flange to X_WF; (0, 6) where none.

    rail [m], (r,): where it stands then. conf: the confdata they must have, None for any. Of two that are
    equally near the less turned one.
    """
    found = postures(plant, X_WF, rail)
    if conf is not None:
        found = found[confdata_admits(plant.robot, conf, found)]
    if not len(found):
        return found
    away = np.sum((found - arm[:, None]) ** 2, axis=-1)
    return np.asarray(found[np.argmax(away <= away.min(axis=1, keepdims=True) + _ALIKE, axis=1)])


def is_nearest(plant: Plant, planned: PlannedMotion, motion: Motion | None = None) -> bool:
    """Whether a motion ends in the joints nearest to those it begins with, of all at its end and its rail position.
    motion: what it is, where known; a line or an arc has no other."""
    if isinstance(motion, PathMove):
        return True
    q_0, q_1, rail = _ends(plant, planned)
    return bool(
        np.abs(nearest(plant, plant.robot.forward(planned.q_1), rail, q_0[None]) - q_1).max(initial=0) <= SAME_JOINTS
    )


def is_sure(plant: Plant, X_WF: Array, rail: Array, arm: Array) -> bool:
    """Whether one configuration alone is the nearest to joints arm (6,), however near is measured."""
    found = postures(plant, X_WF, rail)
    turns = np.abs(found - arm)
    measures = np.stack([np.sum(turns**2, axis=1), np.max(turns, axis=1), np.sum(turns, axis=1)], axis=1)
    return bool(np.all(measures <= measures.min(axis=0) + _ALIKE, axis=1).any()) and (
        np.count_nonzero(measures[:, 0] <= measures[:, 0].min() + _ALIKE) == 1
    )


def _ends(plant: Plant, planned: PlannedMotion) -> tuple[Array, Array, Array]:
    q_0, q_1 = (np.asarray(q[plant.layout.arm]) for q in (planned.q_0, planned.q_1))
    return q_0, q_1, np.asarray(planned.q_1[plant.layout.rail])


def postures(plant: Plant, X_WF: Array, rail: Array | float | None) -> Array:
    """All joints (m, 6) of a flange pose within the limits that a controller may take, the least turned first."""
    found = np.array([q for _, q in solutions(plant.robot, X_WF, rail, plant.limits)]).reshape(-1, 6)
    if plant.robot.linkage:
        found = found[~folded(plant.robot.arm, found)]
    return found[np.lexsort((*np.round(found.T, 6), np.round(np.abs(found).sum(axis=1), 6)))]
