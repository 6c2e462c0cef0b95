"""Accelerations of the axes; the program may ask for a fraction of them."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.limit import INF, Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row


class JointAcceleration(Limit):
    """-lower <= qdd <= upper, which the posture may decide."""

    name = "acceleration"
    order = 2.0

    def __init__(self, axes: Axes):
        super().__init__(axes)
        self._limits = axes.plant.limits
        self._by_posture = self._limits.table is not None
        self.safe_on_grid = None if self._by_posture else INF

    @property
    def start_on_grid(self) -> float:
        """See Limit."""
        return self.start if self._by_posture else self.axes.settings.exact

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        least = self.axes.acceleration_on(leg)
        return np.column_stack([least, self._limits.most_acceleration * leg.acceleration])

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        asked = "programmed " if leg.acceleration < 1.0 else ""
        return [f"{asked}{name} acceleration" for name in self.axes.names]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit."""
        qdd = motion.sample.qdd
        if not self._by_posture:
            return np.asarray(np.abs(qdd) / motion.caps.acceleration)
        lower, upper = self._allowed(motion.sample.q, motion.caps.acceleration)
        return np.asarray(np.maximum(qdd / upper, -qdd / lower))

    def path_rows(self, path: PathSamples) -> PathRows:
        """See Limit."""
        half, rests = self._around(path.q, path.caps.acceleration)
        return PathRows.of_acceleration(path.dq / half, path.ddq / half, rests)

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """See Limit."""
        n = (self.axes.n,)
        return {"A": n, "A_rest": n} if self._by_posture else {"A": n}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit; at the posture of the motion at hand, and held by the dense check."""
        half, rests = self._around(q, np.broadcast_to(self.axes.acceleration_on(leg), q.shape))
        return {"A": half * margin, **({} if rests is None else {"A_rest": rests})}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """See Limit."""
        rest = p.A_rest if self._by_posture else 0.0
        return [(qdd / (p.A * node.T * node.T) + rest, -1.0, 1.0) for qdd in node.qdds]

    def _allowed(self, q: Array, least: Array) -> tuple[Array, Array]:
        """What is allowed of either sign at axes q (m, n), positive, where the program leaves so much of the least."""
        asked = least / self.axes.acceleration
        lower, upper = self._limits.acceleration_at(q)
        return lower * asked, upper * asked

    def _around(self, q: Array, least: Array) -> tuple[Array, Array | None]:
        """half (m, n) and rests (m, n): |qdd / half + rests| <= 1 says the same; no rests for limits without table."""
        if not self._by_posture:
            return least, None
        lower, upper = self._allowed(q, least)
        return (lower + upper) / 2, (lower - upper) / (lower + upper)
