"""Lines and arcs on a work object that positioners turn meanwhile: drawn in its frame, seen from the world.

All axes share the way's parameter s: X_WT(s) = E_1(s) E_2(s) X(s), where X(s) is the way with the table where it stands
at the start, and E_i(s) the rotation about axis i as it lies there, by s times its whole angle (the product of
exponentials, axes from the floor on).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, rotation_about
from trajopt_cli.path.arc import Arc, ArcSymbols
from trajopt_cli.path.line import Line, LineSymbols
from trajopt_cli.path.segment import Segment
from trajopt_cli.path.symbols import Flange, Layout, about

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True, eq=False)
class Turn:
    """A rotation about the axis through p (3,) [m] along the unit vector u (3,), by an angle [rad]."""

    p: Array
    u: Array
    angle: float

    def pose(self, s: Array) -> Array:
        """E (n, 4, 4) at shares s (n,)."""
        E = np.zeros((len(s), 4, 4))
        E[:, :3, :3] = rotation_about(self.u, s * self.angle)
        E[:, :3, 3] = self.p - E[:, :3, :3] @ self.p
        E[:, 3, 3] = 1.0
        return E


def turned_back(turns: Sequence[Turn], X: Array) -> Array:
    """A pose (4, 4) at the end of the turns, as it lies where they begin."""
    for turn in turns:
        X = inverse_pose(turn.pose(np.ones(1))[0]) @ X
    return X


@dataclass(frozen=True, eq=False)
class Turning:
    """way: a line or an arc with the table where it stands at the start. turns: of its axes, from the floor on.

    length and angle are those over the work object, for which speeds are programmed.
    """

    way: Line | Arc
    turns: tuple[Turn, ...]

    @property
    def length(self) -> float:
        """The tool's way over the work object [m]."""
        return self.way.length

    @property
    def angle(self) -> float:
        """Reorientation against the work object [rad]."""
        return self.way.angle

    @property
    def fastest_turn(self) -> float:
        """The highest rate of turning against the work object per unit of s [rad]."""
        return self.way.fastest_turn

    @property
    def breaks(self) -> Array:
        """None."""
        return self.way.breaks

    def pose(self, s: Array) -> Array:
        """X_WT (n, 4, 4) at shares s (n,)."""
        X = self.way.pose(s)
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
        X = self.way.pose(s)
        (v, w), (a, b) = (np.split(x, 2, axis=1) for x in (self.way.twist(s), self.way.twist_rate(s)))
        for turn in reversed(self.turns):
            E, spin = turn.pose(s), turn.angle * turn.u
            X = E @ X
            v, w, a, b = ((E[:, :3, :3] @ x[..., None])[..., 0] for x in (v, w, a, b))  # seen from below the axis
            carried = np.cross(spin, X[:, :3, 3] - turn.p)
            a, b = a + 2 * np.cross(spin, v) + np.cross(spin, carried), b + np.cross(spin, w)
            v, w = v + carried, w + spin
        return np.hstack([v, w]), np.hstack([a, b])


def over_work(segments: Sequence[Segment], shares: Sequence[Array], twist: Array, bend: Array) -> tuple[Array, Array]:
    """What the tool's caps hold for: the twists and their rates (m, 6) of segments at shares (n,) of each, one after
    the other, against the work object where that turns, as given elsewhere. Only their lengths are comparable."""
    if not any(isinstance(segment, Turning) for segment in segments):
        return twist, bend
    twist, bend, first = twist.copy(), bend.copy(), 0
    for segment, s in zip(segments, shares, strict=True):
        at = slice(first, first + len(s))
        if isinstance(segment, Turning):
            twist[at], bend[at] = segment.way.twist(s), segment.way.twist_rate(s)
        first += len(s)
    return twist, bend


@dataclass(frozen=True)
class TurningSymbols:
    """The flange over a turning work object as an expression. way: the kind of its line or arc; axes: how many turn."""

    way: LineSymbols | ArcSymbols
    axes: int

    @property
    def layout(self) -> Layout:
        """The way's own parameters; p, u, angle: of each turn, seen from the arm's base."""
        turns = {f"{name}_{i}": shape for i in range(self.axes) for name, shape in (("p", (3,)), ("u", (3,)))}
        angles: dict[str, tuple[int, ...]] = {f"angle_{i}": () for i in range(self.axes)}
        return Layout({"way": (self.way.size,), **turns, **angles})

    @property
    def size(self) -> int:
        """How many parameters."""
        return self.layout.size

    def vector(self, turning: Turning, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of a way of the tool X_FT; X_BA (4, 4): its frame seen from the arm's base."""
        match self.way, turning.way:
            case (LineSymbols(), Line()) | (ArcSymbols(), Arc()):
                way = self.way.vector(turning.way, X_BA, X_FT)  # type: ignore[arg-type]
            case _:
                raise ValueError(f"{type(turning.way).__name__} has no parameters of {type(self.way).__name__}")
        parts: dict[str, Array | float] = {"way": way}
        for i, turn in enumerate(turning.turns):
            parts[f"p_{i}"] = X_BA[:3, :3] @ turn.p + X_BA[:3, 3]
            parts[f"u_{i}"], parts[f"angle_{i}"] = X_BA[:3, :3] @ turn.u, turn.angle
        return self.layout.vector(parts)

    def flange(self, p: ca.SX, s: ca.SX) -> Flange:
        """The flange in the arm's base frame at share s of the way with parameters p (size,)."""
        part = self.layout.split(p)
        position, rotation = self.way.flange(part["way"], s)
        for i in reversed(range(self.axes)):
            E, at = about(part[f"u_{i}"], part[f"angle_{i}"] * s), part[f"p_{i}"]
            position, rotation = at + E @ (position - at), E @ rotation
        return Flange(position, rotation)
