"""Lines and arcs on a work object that positioners turn meanwhile: drawn in its frame, seen from the world.

All axes share the path's parameter s: X_WT(s) = E_1(s) E_2(s) X(s), where X(s) is the path with the table where it
stands at the start, and E_i(s) the rotation about axis i as it lies there, by s times its whole angle (the product of
exponentials, axes from the floor on).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, rotation_about
from trajopt_cli.motion import UnitMove
from trajopt_cli.path.segment import Segment
from trajopt_cli.path.symbols import Flange, Layout, Symbols, rotated

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True, eq=False)
class Turn:
    """A rotation about the axis through p (3,) [m] along the unit vector u (3,), by an angle [rad]; or a shift along
    way (3,) [m] with none."""

    p: Array
    u: Array
    angle: float
    way: Array = field(default_factory=lambda: np.zeros(3))

    @classmethod
    def of(cls, unit: UnitMove) -> Turn:
        """What an axis does in a whole move."""
        u = np.array(unit.u)
        return cls(np.array(unit.p), u, 0.0, unit.angle * u) if unit.slides else cls(np.array(unit.p), u, unit.angle)

    def pose(self, s: Array) -> Array:
        """E (n, 4, 4) at s (n,)."""
        E = np.zeros((len(s), 4, 4))
        E[:, :3, :3] = rotation_about(self.u, s * self.angle)
        E[:, :3, 3] = self.p - E[:, :3, :3] @ self.p + s[:, None] * self.way
        E[:, 3, 3] = 1.0
        return E


def turned_back(turns: Sequence[Turn], X: Array) -> Array:
    """A pose (4, 4) at the end of the turns, as it lies where they begin."""
    for turn in turns:
        X = inverse_pose(turn.pose(np.ones(1))[0]) @ X
    return X


@dataclass(frozen=True, eq=False)
class Turning(Segment):
    """path: with the table where it stands at the start. turns: of the table's axes, from the floor on.

    length and angle are those over the work object, for which speeds are programmed.
    """

    path: Segment
    turns: tuple[Turn, ...]

    @property
    def length(self) -> float:
        """Of the tool's path over the work object [m]."""
        return self.path.length

    @property
    def angle(self) -> float:
        """Reorientation against the work object [rad]."""
        return self.path.angle

    @property
    def radius(self) -> float:
        """The largest radius of curvature over the work object [m]."""
        return self.path.radius

    @property
    def evenly_turned(self) -> bool:
        """Whether the tool turns at a constant rate against the work object."""
        return self.path.evenly_turned

    @property
    def fastest_turn(self) -> float:
        """The highest rate of turning against the work object by s [rad]."""
        return self.path.fastest_turn

    @property
    def unclear(self) -> tuple[str, str] | None:
        """Of the path."""
        return self.path.unclear

    @property
    def on_work(self) -> Segment:
        """The path alone."""
        return self.path

    @property
    def numbers(self) -> Array:
        """Of the path; the axes that turn are the leg's."""
        return self.path.numbers

    @property
    def symbols(self) -> TurningSymbols:
        """The path's, and how many axes turn."""
        return TurningSymbols(self.path.symbols, len(self.turns))

    def parameters(self, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of the expression."""
        parts: dict[str, Array | float] = {"path": self.path.parameters(X_BA, X_FT)}
        for i, turn in enumerate(self.turns):
            parts[f"p_{i}"] = X_BA[:3, :3] @ turn.p + X_BA[:3, 3]
            parts[f"u_{i}"], parts[f"angle_{i}"] = X_BA[:3, :3] @ turn.u, turn.angle
            parts[f"way_{i}"] = X_BA[:3, :3] @ turn.way
        return self.symbols.layout.vector(parts)

    def pose(self, s: Array) -> Array:
        """X_WT (n, 4, 4) at s (n,)."""
        X = self.path.pose(s)
        for turn in reversed(self.turns):
            X = turn.pose(s) @ X
        return X

    def twist(self, s: Array) -> Array:
        """First derivative (n, 6) by s."""
        return self._rates(s)[0]

    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6) by s."""
        return self._rates(s)[1]

    def _rates(self, s: Array) -> tuple[Array, Array]:
        """Both derivatives, axis by axis from the work object down to the floor."""
        X = self.path.pose(s)
        (v, w), (a, b) = (np.split(x, 2, axis=1) for x in (self.path.twist(s), self.path.twist_rate(s)))
        for turn in reversed(self.turns):
            E, spin = turn.pose(s), turn.angle * turn.u
            X = E @ X
            v, w, a, b = ((E[:, :3, :3] @ x[..., None])[..., 0] for x in (v, w, a, b))  # seen from below the axis
            carried = np.cross(spin, X[:, :3, 3] - turn.p)  # of a shift there is none
            a, b = a + 2 * np.cross(spin, v) + np.cross(spin, carried), b + np.cross(spin, w)
            v, w = v + carried + turn.way, w + spin
        return np.hstack([v, w]), np.hstack([a, b])


@dataclass(frozen=True)
class TurningSymbols(Symbols):
    """The flange over a turning work object as an expression. path: of its kind; axes: how many turn."""

    path: Symbols
    axes: int

    @property
    def layout(self) -> Layout:
        """The path's own parameters; p, u, angle: of each turn, seen from the arm's base."""
        turns = {f"{name}_{i}": (3,) for i in range(self.axes) for name in ("p", "u", "way")}
        angles: dict[str, tuple[int, ...]] = {f"angle_{i}": () for i in range(self.axes)}
        return Layout({"path": (self.path.size,), **turns, **angles})

    def flange(self, p: ca.SX, s: ca.SX | float) -> Flange:
        """The flange in the arm's base frame at s of the path with parameters p (size,)."""
        part = self.layout.split(p)
        position, rotation = self.path.flange(part["path"], s)
        for i in reversed(range(self.axes)):
            E, at = rotated(part[f"u_{i}"], part[f"angle_{i}"] * s), part[f"p_{i}"]
            position, rotation = at + E @ (position - at) + part[f"way_{i}"] * s, E @ rotation
        return Flange(position, rotation)

    def tangent_rate(self, p: ca.SX, s: ca.SX) -> ca.SX | float:
        """Of the path over the work object."""
        return self.path.tangent_rate(self.layout.split(p)["path"], s)
