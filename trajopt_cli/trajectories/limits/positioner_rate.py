"""Velocities and accelerations of positioners that turn a work object under the tool, in step with its path."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.problem import Leg, LegKind
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row


class PositionerRate(Limit):
    """The share's rate times the turn is at most what positioners allow, its second derivative likewise; see
    Leg.positioner_use."""

    name = "positioner"
    apart = True

    @property
    def orders(self) -> Array:
        """See Limit."""
        return np.array([1.0, 2.0])

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return np.array(leg.positioner_use)[:, None]

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        return ["positioner", "positioner"]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit; zero where the share's rates are not given."""
        if motion.progress is None:
            return np.zeros((len(motion.number), 2))
        return np.abs(motion.progress.T) * np.array([leg.positioner_use for leg in motion.legs])[motion.number]

    def used(self, motion: MotionSamples) -> Array:
        """The larger one in both columns: reports tell them apart by nothing."""
        return np.repeat(self.ratios(motion).max(axis=1, keepdims=True), 2, axis=1)

    def path_rows(self, path: PathSamples) -> PathRows | None:
        """See Limit."""
        if not path.positioner_use.any():
            return None
        with np.errstate(divide="ignore"):
            top = 1 / path.positioner_use[..., :1]
        slopes = path.positioner_use[..., 1:]
        return PathRows(top, slopes, np.zeros_like(slopes), PathRows.no_rests(slopes))

    def node_kind(self, leg: Leg) -> Hashable:
        """See Limit."""
        return True if leg.units and leg.kind is LegKind.LINE else None

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """See Limit."""
        return {"positioner_use": (2,)} if on_path else {}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit."""
        return {"positioner_use": np.array(leg.positioner_use) / margin} if on_path else {}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """See Limit."""
        if node.share is None:
            return []
        rates = [
            p.positioner_use[0] * node.share.v / node.T,
            *(p.positioner_use[1] * a / node.T**2 for a in node.share.a),
        ]
        return [(rate, -1.0, 1.0) for rate in rates]
