"""Where a robot's axes stand in its vectors of n axes: the one place that knows whether there is a rail, and where."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array

Number = TypeVar("Number", bound=np.generic)


@dataclass(frozen=True)
class AxisLayout:
    """rail: the axis that carries the arm along, an empty range where there is none; arm: the arm's joints.

    With a rail there is r = 1 of it, without one r = 0: arrays (..., r) of rail values then have no element, and what
    is computed with them has no rail in it.
    """

    rail: slice
    arm: slice

    @classmethod
    def rail_first(cls, joints: int, has_rail: bool) -> AxisLayout:
        """An arm of so many joints, the rail before them if there is one."""
        r = int(has_rail)
        return cls(slice(0, r), slice(r, r + joints))

    @property
    def has_rail(self) -> bool:
        """Whether there is a rail."""
        return self.r > 0

    @property
    def r(self) -> int:
        """Rails: 1 or 0."""
        return int(self.rail.stop - self.rail.start)

    @property
    def joints(self) -> int:
        """Joints of the arm."""
        return int(self.arm.stop - self.arm.start)

    @property
    def n(self) -> int:
        """All axes."""
        return self.r + self.joints

    def place(self, q: Array) -> Array:
        """The rail's value (...) in vectors of all axes (..., n); 0 without a rail."""
        return self.value(q[..., self.rail])

    def value(self, d: Array) -> Array:
        """Plain rail values (...) of (..., r); 0 without a rail."""
        return d[..., 0] if self.r else np.zeros(d.shape[:-1])

    def join(self, d: Array | float, arm: Array) -> Array:
        """All axes (..., n) from rail values (...) and joints (..., m), or their rates; without a rail the joints."""
        d = np.broadcast_to(np.asarray(d, dtype=np.float64), arm.shape[:-1])
        return self.merge(np.repeat(d[..., None], self.r, axis=-1), arm)

    def merge(self, d: NDArray[Number], arm: NDArray[Number]) -> NDArray[Number]:
        """All axes (..., n) from rail values (..., r) and joints (..., m), or anything else that comes by axis."""
        out = np.empty((*arm.shape[:-1], self.n), dtype=arm.dtype)
        out[..., self.rail], out[..., self.arm] = d, arm
        return out
