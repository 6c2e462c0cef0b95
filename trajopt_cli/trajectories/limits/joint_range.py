"""Ranges of the axes, and of weighted sums of them where a linkage couples them."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples, NodeMotion, Row

_RANGE_ROUNDING = 1e-09  # of half an axis' range by which it may be passed: rounding.


class JointRange(Limit):
    """lower <= q <= upper, as the distance from the middle by half the range. The margin is a fraction of that half."""

    name = "position"
    order = 0.0
    safe = 1.0 + _RANGE_ROUNDING
    start = start_on_grid = 1.0

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return np.column_stack([self.axes.lower, self.axes.upper])

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        return [f"{name} range" for name in self.axes.names]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit; where a sum of axes is beyond its own range, these axes have its ratio."""
        q, couplings = motion.sample.q, self.axes.couplings
        ratios = np.abs(q - self._middle) / np.maximum(self._half, 1e-9)
        if couplings:
            for row, ratio in zip(couplings.rows, couplings.ratios(q).T, strict=True):
                ratios = np.where((row != 0) & (ratio > 1.0)[:, None], np.maximum(ratios, ratio[:, None]), ratios)
        return np.asarray(ratios)

    def used(self, motion: MotionSamples) -> Array:
        """None of it: a range bounds where axes are, not how fast."""
        return np.zeros_like(motion.sample.q)

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """See Limit."""
        return {"room": (self.axes.n,)} if on_path else {}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit."""
        return {"room": margin} if on_path else {}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """Of axes that follow from a path; the others' variables have bounds."""
        own = node.dependent
        if own == slice(0):
            return []
        ratio = (node.q[own] - self._middle[own]) / (self._half[own] * p.room[own])
        return [(ratio, -1.0, 1.0), *self.sum_rows(node.q, p.room)]

    def sum_rows(self, q: Any, room: Any) -> list[Row]:
        """Sums of axes q (n,) in their ranges, of which the least margin of any of the axes is in force."""
        import casadi as ca

        out = []
        c = self.axes.couplings
        for row, low, high in zip(c.rows, c.lower, c.upper, strict=True):
            at = np.flatnonzero(row).tolist()
            total = sum(float(row[i]) * q[i] for i in at) - (low + high) / 2
            out.append((total / ((high - low) / 2 * ca.mmin(ca.vertcat(*(room[i] for i in at)))), -1.0, 1.0))
        return out

    @property
    def _middle(self) -> Array:
        return np.asarray((self.axes.upper + self.axes.lower) / 2)

    @property
    def _half(self) -> Array:
        return np.asarray((self.axes.upper - self.axes.lower) / 2)
