"""Joint moves as a controller drives them: straight in the space of the axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.symbols import Layout

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True, eq=False)
class JointMove:
    """From axis positions q_0 to q_1 (k,) [m, rad]."""

    q_0: Array
    q_1: Array

    @property
    def breaks(self) -> Array:
        """None."""
        return np.zeros(0)

    def axes(self, s: Array) -> Array:
        """Axis positions (n, k) at shares s (n,)."""
        return np.asarray(self.q_0 + s[:, None] * (self.q_1 - self.q_0))

    def rate(self, s: Array) -> Array:
        """The way (n, k), the same everywhere."""
        return np.tile(self.q_1 - self.q_0, (len(s), 1))

    def rate_change(self, s: Array) -> Array:
        """Zeros (n, k)."""
        return np.zeros((len(s), len(self.q_0)))


@dataclass(frozen=True)
class JointMoveSymbols:
    """A joint move of k axes as an expression of its ends and s."""

    k: int

    @property
    def layout(self) -> Layout:
        """Ends q_0, q_1 (k,)."""
        return Layout({"q_0": (self.k,), "q_1": (self.k,)})

    @property
    def size(self) -> int:
        """How many parameters."""
        return 2 * self.k

    def vector(self, move: JointMove) -> Array:
        """Parameters (size,) of a move."""
        return self.layout.vector({"q_0": move.q_0, "q_1": move.q_1})

    def axes(self, p: ca.SX, s: ca.SX) -> ca.SX:
        """Axis positions (k,) at share s."""
        part = self.layout.split(p)
        return part["q_0"] + s * (part["q_1"] - part["q_0"])
