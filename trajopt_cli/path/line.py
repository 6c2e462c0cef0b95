"""Straight lines: the tool centre point on a chord, the orientation at a constant rate the shorter way (slerp). Where
both ends are one pose the tool rests."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray, axis_angle, pose, rotation_about, rotations_by
from trajopt_cli.path.segment import Batch, Segment
from trajopt_cli.path.symbols import Flange, Layout, Symbols, flange_at_start, rotated

if TYPE_CHECKING:
    import casadi as ca

_TURNS = 1e-9  # rad: a turn this small has no expression


@dataclass(frozen=True, eq=False)
class Line(Segment):
    """From tool pose X_0 to X_1 (4, 4), both seen from the same frame."""

    X_0: Array
    X_1: Array

    @cached_property
    def chord(self) -> Array:
        """From start to end (3,) [m]."""
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
        """Rotation vector (3,) [rad] of the turn in the axes of the poses' frame; constant on all of it."""
        axis, angle = self._axis_angle
        return np.asarray(self.X_0[:3, :3] @ axis * angle)

    @cached_property
    def length(self) -> float:
        """Of the chord [m]."""
        return float(np.linalg.norm(self.chord))

    @property
    def angle(self) -> float:
        """Reorientation [rad], 0..pi."""
        return self._axis_angle[1]

    def pose(self, s: Array) -> Array:
        """Tool poses (n, 4, 4) at s (n,)."""
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

    @property
    def batch(self) -> Batch:
        """Lines at once."""
        return lines_along

    @property
    def even_turns(self) -> tuple[Array, Array]:
        """What turns evenly on it: nothing about an axis of the poses' frame, and its turn (3,) in the tool's own."""
        axis, angle = self._axis_angle
        return np.zeros(3), angle * axis

    def between(self, s_0: float, s_1: float) -> Line:
        """The part of it from s_0 to s_1, a line."""
        return Line(*self.pose(np.array([s_0, s_1])))

    @property
    def symbols(self) -> LineSymbols:
        """With a turn or without one."""
        return LineSymbols(self.angle > _TURNS)

    def parameters(self, X_BA: Array, X_FT: Array) -> Array:
        """Parameters (size,) of the expression."""
        X_B0, X_B1 = X_BA @ self.X_0, X_BA @ self.X_1
        axis, angle = axis_angle(X_B0[:3, :3].T @ X_B1[:3, :3])
        parts: dict[str, ArrayLike] = {
            "p": X_B0[:3, 3], "chord": X_B1[:3, 3] - X_B0[:3, 3], "R": flange_at_start(X_BA, self.X_0, X_FT)[:3, :3],
            "axis": X_FT[:3, :3] @ axis, "angle": angle, "offset": X_FT[:3, 3],
        }  # fmt: skip
        return LineSymbols.layout.vector(parts)


def lines_along(segments: Sequence[Segment], of: IndexArray, s: Array) -> tuple[Array, Array, Array]:
    """Poses (m, 4, 4), twists and their rates (m, 6) at s (m,) of the lines with numbers of (m,)."""
    lines = [line for line in segments if isinstance(line, Line)]
    X = np.array([line.X_0 for line in lines])[of]
    twist = np.array([np.concatenate([line.chord, line.turn]) for line in lines])[of]
    turns = np.array([line.axis * line.angle for line in lines])
    X[:, :3, 3] += s[:, None] * twist[:, :3]
    if turns.any():  # most lines turn nothing
        X[:, :3, :3] @= rotations_by(s[:, None] * turns[of])
    return X, twist, np.zeros_like(twist)


@dataclass(frozen=True)
class LineSymbols(Symbols):
    """The flange on a line as an expression. turning: False leaves the turn out, for lines without one."""

    turning: bool = True
    # p: the tool centre point at s = 0; R: the flange's rotation there; axis, angle: its turn about an axis of its own;
    # offset: the tool centre point in the flange's frame
    layout: ClassVar[Layout] = Layout(
        {"p": (3,), "chord": (3,), "R": (3, 3), "axis": (3,), "angle": (), "offset": (3,)}
    )

    def flange(self, p: ca.SX, s: ca.SX | float) -> Flange:
        """The flange in the arm's base frame at s of the line with parameters p (size,)."""
        part = self.layout.split(p)
        R = part["R"] @ rotated(part["axis"], part["angle"] * s) if self.turning else part["R"]
        return Flange(part["p"] + s * part["chord"] - R @ part["offset"], R)
