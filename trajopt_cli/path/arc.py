"""Arcs (MoveC): the tool centre point on a circle at a constant rate, the orientation evenly from start to end.

The orientation of the point on the way plays no part, as is the controller's default.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.path.circle import Point, circle_through
from trajopt_cli.path.line import Line
from trajopt_cli.path.symbols import TURN, Flange, Layout, about, flange_at_start, turn_parts

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True, eq=False)
class Arc:
    """From tool pose X_0 to X_1 (4, 4) about a centre (3,) [m] and unit normal (3,), by sweep [rad] in (0, 2 pi)."""

    X_0: Array
    X_1: Array
    centre: Array
    normal: Array
    sweep: float

    @classmethod
    def through(cls, X_0: Array, via: Array, X_1: Array) -> Arc:
        """The arc from X_0 through the point via (3,) [m] to X_1.

        Raises:
            InputError: the three points lie on one line, or two of them in one place.
        """
        points = X_0[:3, 3], via, X_1[:3, 3]
        found = circle_through(*(_point(p) for p in points))
        if found is None:
            places = ", ".join("[" + ", ".join(f"{x * 1e3:.3f}" for x in p) + "]" for p in points)
            raise InputError(
                f"no circle leads through three points on one line: start, point on the way and end {places} mm;"
                " move the point on the way, or use MoveL"
            )
        return cls(X_0, X_1, np.array(found.centre), np.array(found.axis), found.angle)

    @cached_property
    def _turning(self) -> Line:
        """What the orientation does: the same as on a line."""
        return Line(self.X_0, self.X_1)

    @cached_property
    def _first(self) -> Array:
        """From the centre to the start (3,)."""
        return np.asarray(self.X_0[:3, 3] - self.centre)

    @cached_property
    def _side(self) -> Array:
        """From the centre to the point a quarter turn on (3,)."""
        return np.cross(self.normal, self._first)

    @property
    def radius(self) -> float:
        """Of the circle [m]."""
        return float(np.linalg.norm(self._first))

    @property
    def length(self) -> float:
        """The tool centre point's way [m], along the arc."""
        return self.radius * self.sweep

    @property
    def angle(self) -> float:
        """Reorientation [rad], 0..pi; the sweep is none."""
        return self._turning.angle

    @property
    def breaks(self) -> Array:
        """None."""
        return np.zeros(0)

    def pose(self, s: Array) -> Array:
        """Tool poses (n, 4, 4) at shares s (n,)."""
        X = self._turning.pose(s)
        X[:, :3, 3] = self.centre + self._on_circle(s)
        return X

    def twist(self, s: Array) -> Array:
        """First derivative (n, 6): along the tangent, and the turn, which is the same everywhere."""
        out = self._turning.twist(s)
        phi = (self.sweep * s)[:, None]
        out[:, :3] = self.sweep * (np.cos(phi) * self._side - np.sin(phi) * self._first)
        return out

    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6): towards the centre."""
        out = np.zeros((len(s), 6))
        out[:, :3] = -(self.sweep**2) * self._on_circle(s)
        return out

    def _on_circle(self, s: Array) -> Array:
        phi = (self.sweep * s)[:, None]
        return np.asarray(np.cos(phi) * self._first + np.sin(phi) * self._side)


def _point(p: Array) -> Point:
    x, y, z = p.tolist()
    return x, y, z


@dataclass(frozen=True)
class ArcSymbols:
    """The flange on an arc as an expression of the arc's parameters and s. turning: as of LineSymbols."""

    turning: bool = True
    # first, side: from the centre to the start, and to the point a quarter turn on
    layout: ClassVar[Layout] = Layout({"centre": (3,), "first": (3,), "side": (3,), "sweep": (), **TURN})

    @property
    def size(self) -> int:
        """How many parameters."""
        return self.layout.size

    def vector(self, arc: Arc, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of an arc of the tool X_FT; X_BA (4, 4): its frame seen from the arm's base."""
        X_B0, X_B1 = X_BA @ arc.X_0, X_BA @ arc.X_1
        centre = X_BA[:3, :3] @ arc.centre + X_BA[:3, 3]
        first = X_B0[:3, 3] - centre
        side = np.cross(X_BA[:3, :3] @ arc.normal, first)
        turn = turn_parts(X_B0, X_B1, flange_at_start(X_BA, arc.X_0, X_FT), X_FT)
        return self.layout.vector({"centre": centre, "first": first, "side": side, "sweep": arc.sweep, **turn})

    def tool(self, p: ca.SX, s: ca.SX) -> ca.SX:
        """Position (3,) of the tool centre point in the arm's base frame."""
        import casadi as ca

        part = self.layout.split(p)
        phi = part["sweep"] * s
        return part["centre"] + ca.cos(phi) * part["first"] + ca.sin(phi) * part["side"]

    def rotation(self, p: ca.SX, s: ca.SX) -> ca.SX:
        """Rotation (3, 3) of the flange there."""
        part = self.layout.split(p)
        return part["R"] @ about(part["axis"], part["angle"] * s) if self.turning else part["R"]

    def flange(self, p: ca.SX, s: ca.SX) -> Flange:
        """The flange in the arm's base frame at share s of the arc with parameters p (size,)."""
        R = self.rotation(p, s)
        return Flange(self.tool(p, s) - R @ self.layout.split(p)["offset"], R)
