"""Joint moves as a controller drives them: straight in the space of the axes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.segment import JointSegment


@dataclass(frozen=True, eq=False)
class JointMove(JointSegment):
    """From axis positions q_0 to q_1 (k,) [m, rad]."""

    q_0: Array
    q_1: Array

    def axes(self, s: Array) -> Array:
        """Axis positions (n, k) at s (n,)."""
        return np.asarray(self.q_0 + s[:, None] * (self.q_1 - self.q_0))

    def rate(self, s: Array) -> Array:
        """From start to end (n, k), the same everywhere."""
        return np.tile(self.q_1 - self.q_0, (len(s), 1))

    def rate_change(self, s: Array) -> Array:
        """Zeros (n, k)."""
        return np.zeros((len(s), len(self.q_0)))
