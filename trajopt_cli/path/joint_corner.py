"""Corners with a joint move on one side or both: a cubic in the space of the axes, from where the zone is entered to
where it is left, with both sides' rates. Between two joint moves it is a quadratic Bézier. Where jerk is limited it is
a quintic that goes on with both sides' second derivatives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.hermite import hermite, quintic
from trajopt_cli.path.segment import JointSegment


@dataclass(frozen=True, eq=False)
class JointCorner(JointSegment):
    """From axes q_0 (k,) with rate_0 to q_1 with rate_1, rates per unit of this corner's own s; bends: second
    derivatives (2, k) at both ends, None for whatever the cubic has.

    A side that is a line or an arc gives its joints and their rates through the robot: of half the corner's s it covers
    the part inside the zone.
    """

    is_corner: ClassVar[bool] = True

    q_0: Array
    rate_0: Array
    q_1: Array
    rate_1: Array
    bends: Array | None = None

    def axes(self, s: Array) -> Array:
        """Axis positions (n, k) at s (n,)."""
        return np.asarray(self._at(s)[0])

    def rate(self, s: Array) -> Array:
        """First derivative (n, k)."""
        return np.asarray(self._at(s)[1])

    def rate_change(self, s: Array) -> Array:
        """Second derivative (n, k)."""
        return np.asarray(self._at(s)[2])

    def _at(self, s: Array) -> tuple[Array, ...]:
        if self.bends is not None:
            return quintic(self.q_0, self.rate_0, self.bends[0], self.q_1, self.rate_1, self.bends[1], s[:, None])
        return hermite(self.q_0, self.rate_0, self.q_1, self.rate_1, s[:, None])
