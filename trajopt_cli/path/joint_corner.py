"""Corners with a joint move on one side or both: a cubic in the space of the axes, from where the zone is entered to
where it is left, with both sides' rates. Between two joint moves it is a quadratic Bézier."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.hermite import hermite
from trajopt_cli.path.segment import POINT, JointSegment, check_fractions


@dataclass(frozen=True, eq=False)
class JointCorner(JointSegment):
    """From axes q_0 (k,) with rate_0 to q_1 with rate_1, rates per unit of this corner's own s.

    A side that is a line or an arc gives its joints and their rates through the robot: of half the corner's s it covers
    the part inside the zone.
    """

    is_corner: ClassVar[bool] = True

    q_0: Array
    rate_0: Array
    q_1: Array
    rate_1: Array

    @classmethod
    def between(
        cls, before: JointSegment, after: JointSegment, fraction_before: float, fraction_after: float
    ) -> JointCorner:
        """The corner that replaces the last fraction of before and the first of after, both in (0, 1].

        Raises:
            ValueError: a fraction is none, or after does not begin where before ends.
        """
        check_fractions(fraction_before, fraction_after)
        end, begin = before.axes(np.ones(1))[0], after.axes(np.zeros(1))[0]
        if np.abs(end - begin).max() > POINT:
            raise ValueError(f"the move after the corner begins at {begin}, the one before it ends at {end}")
        s_0, s_1 = np.array([1 - fraction_before]), np.array([fraction_after])
        return cls(
            before.axes(s_0)[0],
            2 * fraction_before * before.rate(s_0)[0],
            after.axes(s_1)[0],
            2 * fraction_after * after.rate(s_1)[0],
        )

    def axes(self, s: Array) -> Array:
        """Axis positions (n, k) at s (n,)."""
        return np.asarray(self._at(s)[0])

    def rate(self, s: Array) -> Array:
        """First derivative (n, k)."""
        return np.asarray(self._at(s)[1])

    def rate_change(self, s: Array) -> Array:
        """Second derivative (n, k)."""
        return np.asarray(self._at(s)[2])

    def _at(self, s: Array) -> tuple[Array, Array, Array]:
        return hermite(self.q_0, self.rate_0, self.q_1, self.rate_1, s[:, None])
