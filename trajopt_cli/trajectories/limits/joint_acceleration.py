"""Accelerations of the axes; the program may ask for a fraction of them."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.limits.limit import INF, Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row


class JointAcceleration(Limit):
    """|qdd| <= A."""

    name = "acceleration"
    order = 2.0
    safe_on_grid = INF

    @property
    def start_on_grid(self) -> float:
        """See Limit."""
        return self.axes.settings.exact

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return self.axes.acceleration_on(leg)[:, None]

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        asked = "programmed " if leg.acceleration < 1.0 else ""
        return [f"{asked}{name} acceleration" for name in self.axes.names]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit."""
        return np.asarray(np.abs(motion.sample.qdd) / motion.caps.acceleration)

    def path_rows(self, path: PathSamples) -> PathRows:
        """See Limit."""
        return PathRows.of_acceleration(path.dq / path.caps.acceleration, path.ddq / path.caps.acceleration)

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """See Limit."""
        return {"A": (self.axes.n,)}

    def node_values(self, leg: Leg, margin: Array, on_path: bool) -> Mapping[str, Array]:
        """See Limit."""
        return {"A": self.axes.acceleration_on(leg) * margin}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """See Limit."""
        return [(qdd / (p.A * node.T * node.T), -1.0, 1.0) for qdd in node.qdds]
