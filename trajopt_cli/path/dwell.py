"""Dwells: the tool rests in one pose, while external axes may move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.line import LineSymbols
from trajopt_cli.path.symbols import Flange, flange_at_start

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True, eq=False)
class Dwell:
    """At tool pose X (4, 4)."""

    X: Array

    @property
    def length(self) -> float:
        """0."""
        return 0.0

    @property
    def angle(self) -> float:
        """0."""
        return 0.0

    @property
    def breaks(self) -> Array:
        """None."""
        return np.zeros(0)

    def pose(self, s: Array) -> Array:
        """The pose, once for each of the shares s (n,): (n, 4, 4)."""
        return np.tile(self.X, (len(s), 1, 1))

    def twist(self, s: Array) -> Array:
        """Zeros (n, 6)."""
        return np.zeros((len(s), 6))

    def twist_rate(self, s: Array) -> Array:
        """Zeros (n, 6)."""
        return np.zeros((len(s), 6))


@dataclass(frozen=True)
class DwellSymbols:
    """The resting flange as an expression. Parameters are those of a line of no length, so that a block of lines that
    turn nothing serves dwells too."""

    @property
    def size(self) -> int:
        """How many parameters."""
        return LineSymbols.layout.size

    def vector(self, dwell: Dwell, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of a dwell of the tool X_FT; X_BA (4, 4): its frame seen from the arm's base."""
        return LineSymbols.layout.vector(
            {
                "p": (X_BA @ dwell.X)[:3, 3],
                "chord": np.zeros(3),
                "R": flange_at_start(X_BA, dwell.X, X_FT)[:3, :3],
                "axis": [1.0, 0.0, 0.0],
                "angle": 0.0,
                "offset": X_FT[:3, 3],
            }
        )

    def flange(self, p: ca.SX) -> Flange:
        """The flange in the arm's base frame, the same at every share."""
        part = LineSymbols.layout.split(p)
        return Flange(part["p"] - part["R"] @ part["offset"], part["R"])
