"""Straight lines: the tool centre point on a chord, the orientation at a constant rate the shorter way (slerp)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from trajopt_cli.geometry import (
    Array,
    IndexArray,
    axis_angle,
    pose,
    rotation_about,
    rotation_from_wxyz,
    rotations_by,
    wxyz_from_rotation,
)
from trajopt_cli.path.symbols import TURN, Flange, Layout, about, flange_at_start, turn_parts

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True, eq=False)
class Line:
    """From tool pose X_0 to X_1 (4, 4), both seen from the same frame."""

    X_0: Array
    X_1: Array

    @cached_property
    def chord(self) -> Array:
        """The way (3,) [m]."""
        return np.asarray(self.X_1[:3, 3] - self.X_0[:3, 3])

    @cached_property
    def _axis_angle(self) -> tuple[Array, float]:
        return axis_angle(self.X_0[:3, :3].T @ self.X_1[:3, :3])

    @property
    def axis(self) -> Array:
        """Unit axis (3,) of the turn in the tool's own frame; x where nothing turns."""
        return self._axis_angle[0]

    @cached_property
    def turn(self) -> Array:
        """Rotation vector (3,) [rad] of the turn in the axes of the poses' frame; constant on the way."""
        axis, angle = self._axis_angle
        return np.asarray(self.X_0[:3, :3] @ axis * angle)

    @cached_property
    def length(self) -> float:
        """The tool centre point's way [m]."""
        return float(np.linalg.norm(self.chord))

    @property
    def angle(self) -> float:
        """Reorientation [rad], 0..pi."""
        return self._axis_angle[1]

    @property
    def fastest_turn(self) -> float:
        """The highest rate of turning per unit of s [rad]: the same everywhere."""
        return self.angle

    @property
    def breaks(self) -> Array:
        """None."""
        return np.zeros(0)

    def pose(self, s: Array) -> Array:
        """Tool poses (n, 4, 4) at shares s (n,)."""
        axis, angle = self._axis_angle
        p = self.X_0[:3, 3] + s[..., None] * self.chord
        R = self.X_0[:3, :3]  # most lines turn nothing
        return pose(np.broadcast_to(R, (*p.shape[:-1], 3, 3)) if angle == 0 else R @ rotation_about(axis, s * angle), p)

    def twist(self, s: Array) -> Array:
        """Chord and turn (n, 6), the same everywhere."""
        return np.tile(np.concatenate([self.chord, self.turn]), (len(s), 1))

    def twist_rate(self, s: Array) -> Array:
        """Zeros (n, 6)."""
        return np.zeros((len(s), 6))


def lines_along(lines: Sequence[Line], of: IndexArray, s: Array) -> tuple[Array, Array, Array]:
    """Poses (m, 4, 4), twists and their rates (m, 6) at shares s (m,) of the lines with numbers of (m,)."""
    X = np.array([line.X_0 for line in lines])[of]
    twist = np.array([np.concatenate([line.chord, line.turn]) for line in lines])[of]
    turns = np.array([line.axis * line.angle for line in lines])
    X[:, :3, 3] += s[:, None] * twist[:, :3]
    if turns.any():  # most lines turn nothing
        X[:, :3, :3] @= rotations_by(s[:, None] * turns[of])
    return X, twist, np.zeros_like(twist)


def poses_of_many(X_0: Array, X_1: Array, s: Array) -> Array:
    """Tool poses (m, n, 4, 4) of the lines from X_0 to X_1 (m, 4, 4) at shares s (n,).

    What Line.pose gives up to rounding, 6 (41 shares) to 20 times (5 shares) faster.
    """
    w, v = np.split(wxyz_from_rotation(np.swapaxes(X_0[:, :3, :3], 1, 2) @ X_1[:, :3, :3]), [1], axis=1)
    sine = np.linalg.norm(v, axis=1, keepdims=True)
    half = np.arctan2(sine, w) * s  # (m, n), of the angle turned so far
    axis = v / np.where(sine < 1e-15, 1.0, sine)
    part = rotation_from_wxyz(np.concatenate([np.cos(half)[..., None], np.sin(half)[..., None] * axis[:, None]], -1))
    chord = X_1[:, :3, 3] - X_0[:, :3, 3]
    return pose(X_0[:, None, :3, :3] @ part, X_0[:, None, :3, 3] + s[:, None] * chord[:, None])


@dataclass(frozen=True)
class LineSymbols:
    """The flange on a line as an expression of the line's parameters and s. turning: False leaves the turn out, for
    lines without one and for resting poses."""

    turning: bool = True
    # p: the tool centre point at s = 0; chord: its way
    layout: ClassVar[Layout] = Layout({"p": (3,), "chord": (3,), **TURN})

    @property
    def size(self) -> int:
        """How many parameters."""
        return self.layout.size

    def vector(self, line: Line, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of a line of the tool X_FT; X_BA (4, 4): its frame seen from the arm's base."""
        X_B0, X_B1 = X_BA @ line.X_0, X_BA @ line.X_1
        X_BF = flange_at_start(X_BA, line.X_0, X_FT)
        return self.layout.vector(
            {"p": X_B0[:3, 3], "chord": X_B1[:3, 3] - X_B0[:3, 3], **turn_parts(X_B0, X_B1, X_BF, X_FT)}
        )

    def tool(self, p: ca.SX, s: ca.SX) -> ca.SX:
        """Position (3,) of the tool centre point in the arm's base frame."""
        part = self.layout.split(p)
        return part["p"] + s * part["chord"]

    def rotation(self, p: ca.SX, s: ca.SX) -> ca.SX:
        """Rotation (3, 3) of the flange there."""
        part = self.layout.split(p)
        return part["R"] @ about(part["axis"], part["angle"] * s) if self.turning else part["R"]

    def flange(self, p: ca.SX, s: ca.SX) -> Flange:
        """The flange in the arm's base frame at share s of the line with parameters p (size,)."""
        R = self.rotation(p, s)
        return Flange(self.tool(p, s) - R @ self.layout.split(p)["offset"], R)
