"""Velocities of the axes; the rail's may be capped by the program as well."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row


class JointVelocity(Limit):
    """|qd| <= V."""

    name = "velocity"
    safe_on_grid = 1.0

    @property
    def start_on_grid(self) -> float:
        """See Limit."""
        return self.axes.settings.exact

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return self.axes.velocity_on(leg)[:, None]

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        capped = self.axes.velocity_on(leg) < self.axes.velocity
        return [
            ("programmed " if cap else "") + f"{name} speed" for name, cap in zip(self.axes.names, capped, strict=True)
        ]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit."""
        return np.asarray(np.abs(motion.sample.qd) / motion.caps.velocity)

    def path_rows(self, path: PathSamples) -> PathRows:
        """See Limit."""
        with np.errstate(divide="ignore"):
            return PathRows.of_rate(path.caps.velocity / np.abs(path.dq))

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """See Limit."""
        return {"V": (self.axes.n,)}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit."""
        return {"V": self.axes.velocity_on(leg) * margin}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """See Limit."""
        return [(node.qd / (p.V * node.T), -1.0, 1.0)]
