"""Jerks of the axes, where they bind. Motions between nodes have constant accelerations, so samples show mean jerks."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.limit import INF, Limit, MotionSamples, NodeMotion, Row


class JointJerk(Limit):
    """|qddd| <= J."""

    name = "jerk"
    order = 3.0
    slows_paths = False  # laws with limited jerk are made apart, see path_timing/smooth.py
    safe_on_grid = INF

    @classmethod
    def in_force(cls, axes: Axes) -> bool:
        """See Limit."""
        return axes.jerk is not None

    @property
    def safe(self) -> float:
        """See Limit."""
        return self.axes.settings.safe_jerk

    @property
    def start(self) -> float:
        """See Limit."""
        return self.axes.settings.start_jerk

    @property
    def start_on_grid(self) -> float:
        """See Limit."""
        return self.axes.settings.start_jerk

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return self._limits[:, None]

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        return [f"{name} jerk" for name in self.axes.names]

    def ratios(self, motion: MotionSamples) -> Array:
        """Mean jerks from each sample to the next in the same interval; zero at the last."""
        sample = motion.sample
        out = np.zeros_like(sample.qdd)
        apart = np.diff(sample.t)  # 0 in a move to where the arm is
        inside = np.setdiff1d(np.flatnonzero(apart), motion.first - 1)
        steps = apart[inside, None]
        out[inside] = np.abs(sample.qdd[inside + 1] - sample.qdd[inside]) / steps / self._limits
        return out

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """See Limit."""
        return {"jerk": (self.axes.n,)}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit."""
        return {"jerk": self._limits * margin}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """See Limit."""
        return [(qddd / (p.jerk * node.T**3), -1.0, 1.0) for qddd in node.qddds]

    @property
    def _limits(self) -> Array:
        assert self.axes.jerk is not None
        return self.axes.jerk
