"""Where a robot's axes stand in its vectors of n axes: the one place that knows how many rails there are, and where."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array

Number = TypeVar("Number", bound=np.generic)


@dataclass(frozen=True)
class AxisLayout:
    """rail: the axes that carry the arm along, an empty range where there are none; arm: the arm's joints; sought: the
    rail whose place is looked for while the others are held, by number.

    There are r = 0 to 3 rails. With none arrays (..., r) of rail values have no element, and what is computed with them
    has no rail in it.
    """

    rail: slice
    arm: slice
    sought: int = 0

    @classmethod
    def rail_first(cls, joints: int, r: int) -> AxisLayout:
        """An arm of so many joints, r rails before them."""
        return cls(slice(0, r), slice(r, r + joints))

    @property
    def has_rail(self) -> bool:
        """Whether there is a rail."""
        return self.r > 0

    @property
    def r(self) -> int:
        """Rails: 0 to 3."""
        return int(self.rail.stop - self.rail.start)

    @property
    def joints(self) -> int:
        """Joints of the arm."""
        return int(self.arm.stop - self.arm.start)

    @property
    def n(self) -> int:
        """All axes."""
        return self.r + self.joints

    def seeking(self, i: int) -> AxisLayout:
        """The same that seeks rail number i."""
        return replace(self, sought=i)

    @property
    def others(self) -> list[int]:
        """The rails that are held while one is sought, as numbers in vectors of all axes."""
        return [i for i in range(*self.rail.indices(self.n)) if i != self.rail.start + self.sought]

    def place(self, q: Array) -> Array:
        """The sought rail's value (...) in vectors of all axes (..., n); 0 without a rail."""
        return q[..., self.rail.start + self.sought] if self.r else np.zeros(q.shape[:-1])

    def value(self, d: Array) -> Array:
        """Rail values (..., r) as a robot's inverse takes them: of one rail, and 0 without one, plain (...)."""
        return d if self.r > 1 else d[..., 0] if self.r else np.zeros(d.shape[:-1])

    def join(self, d: Array | float, arm: Array) -> Array:
        """All axes (..., n) from values (...) of the sought rail and joints (..., m), or their rates, other rails at 0;
        without a rail the joints."""
        rails = np.zeros((*arm.shape[:-1], self.r))
        if self.r:
            rails[..., self.sought] = d
        return self.merge(rails, arm)

    def merge(self, d: NDArray[Number], arm: NDArray[Number]) -> NDArray[Number]:
        """All axes (..., n) from rail values (..., r) and joints (..., m), or anything else that comes by axis."""
        out = np.empty((*arm.shape[:-1], self.n), dtype=arm.dtype)
        out[..., self.rail], out[..., self.arm] = d, arm
        return out
