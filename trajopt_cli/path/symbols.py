"""Segments as CasADi expressions: a vector of parameters with named parts, and the flange's pose from it.

A compiled block serves every segment of a kind; what differs between two of them are the parameters.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, inverse_pose

if TYPE_CHECKING:
    import casadi as ca


@dataclass(frozen=True)
class Layout:
    """Named parts of one vector, in order: their shapes, () for a number; matrices column by column."""

    shapes: Mapping[str, tuple[int, ...]]

    @property
    def size(self) -> int:
        """How many numbers the vector has."""
        return sum(prod(shape) for shape in self.shapes.values())

    def vector(self, parts: Mapping[str, ArrayLike]) -> Array:
        """The vector (size,) of all its parts.

        Raises:
            ValueError: a part is missing, unknown or of another shape.
        """
        if parts.keys() != self.shapes.keys():
            raise ValueError(f"the parts are {', '.join(self.shapes)}; found {', '.join(parts)}")
        out = []
        for name, shape in self.shapes.items():
            part = np.asarray(parts[name], dtype=np.float64)
            if part.shape != shape:
                raise ValueError(f"{name} has shape {part.shape}, wanted {shape}")
            out.append(part.ravel(order="F"))
        return np.concatenate(out)

    def split(self, p: ca.SX) -> dict[str, ca.SX]:
        """The parts of a vector p (size,) by their names.

        Raises:
            ValueError: p has another size.
        """
        import casadi as ca

        if p.numel() != self.size:
            raise ValueError(f"{p.numel()} parameters, wanted {self.size}: {', '.join(self.shapes)}")
        out, at = {}, 0
        for name, shape in self.shapes.items():
            end = at + prod(shape)
            part = p[at:end] if shape else p[at]
            out[name] = ca.reshape(part, *shape) if len(shape) == 2 else part
            at = end
        return out


class Flange(NamedTuple):
    """Position (3,) [m] and rotation (3, 3) of the flange in the arm's base frame."""

    position: ca.SX
    rotation: ca.SX


class Curve(NamedTuple):
    """First and second derivative (3,) of the tool centre point [m] by s, and its rate of turning (3,) [rad] in the
    tool's own frame."""

    tangent: ca.SX
    bend: ca.SX
    turn: ca.SX


class Symbols(ABC):
    """The flange on a kind of segment as an expression of parameters (size,), by the layout's names, and of s."""

    @property
    @abstractmethod
    def layout(self) -> Layout:
        """The parameters' names and shapes."""

    @property
    def size(self) -> int:
        """How many parameters."""
        return self.layout.size

    @abstractmethod
    def flange(self, p: ca.SX, s: ca.SX | float) -> Flange:
        """The flange in the arm's base frame at s of the segment with parameters p (size,)."""

    def tangent_rate(self, p: ca.SX, s: ca.SX) -> ca.SX | float:
        """By what angle the path's tangent turns per unit of s [rad], over the work object: length by radius."""
        return 0.0

    def curve(self, p: ca.SX, s: ca.SX) -> Curve | None:
        """How the tool goes at s where that is not evenly; None where the rates by s are its length and its angle."""
        return None


def flange_at_start(X_BA: Array, X_AT: Array, X_FT: Array) -> Array:
    """X_BF (4, 4) of a tool pose X_AT, seen from the arm's base."""
    return np.asarray(X_BA @ (X_AT @ inverse_pose(X_FT)))


def rotated(axis: ca.SX, angle: ca.SX) -> ca.SX:
    """Rotation matrix (3, 3) about a unit axis (3,) by an angle [rad] (Rodrigues)."""
    import casadi as ca

    K = ca.skew(axis)
    return ca.SX.eye(3) + ca.sin(angle) * K + (1 - ca.cos(angle)) * (K @ K)
