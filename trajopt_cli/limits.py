"""What the axes and the tool centre point may do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, readonly

SPREADS: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "velocity": {"B": (0.98, 1.02), "C": (0.9, 1.1), "D": (0.5, 2.0)},
    "acceleration": {"B": (0.9, 1.1), "C": (0.7, 1.5), "D": (0.6, 2.5)},
    "settling": {"B": (0.9, 1.5), "C": (0.5, 1.75), "D": (0.25, 3.0)},
}
"""Between which shares of a number the true one is taken to be, by kind and grade; what is not here is sure. Speeds:
chosen, not measured; data sheets of tracks say 1 to 4 m/s. Accelerations: the middles of a virtual controller's tables
of an IRB 1200-5/0.9 and an IRB 6640-180/2.55 are 0.63 to 2.42 times "full speed in 0.2 s" for joints 1 to 3 (3.6 times
for a wrist), and half of that times one of "in 0.1 s". Settling: eleven logged cycles of that IRB 6640 are 0.98 to 1.52
times 0.1 s a stop longer than predicted without (benchmarks/bench_logs.py)."""

_NEAREST_ROWS = 1e-5  # s: no rows of the files written here are nearer to each other


@dataclass(frozen=True)
class CoupledRange:
    """A range of a weighted sum of joints, as a parallel linkage has it: lower <= sum of factor * angle <= upper [rad].

    axes: names of different axes of the arm; source: where the numbers come from, with the grade in words.
    """

    axes: tuple[str, ...]
    factors: tuple[float, ...]
    lower: float
    upper: float
    source: str = ""

    def __post_init__(self) -> None:
        if not (len(self.axes) == len(self.factors) == len({*self.axes}) and all(self.factors)):
            raise ValueError(f"CoupledRange: wanted a factor, not 0, for each of different axes, got {self}")
        if not self.lower < self.upper:
            raise ValueError("CoupledRange: the lower limit must lie under the upper limit")

    @property
    def name(self) -> str:
        """The sum as a formula: "joint_2 + joint_3", "joint_3 - 0.5 joint_2"."""
        out = ""
        for axis, factor in zip(self.axes, self.factors, strict=True):
            size = "" if abs(factor) == 1 else f"{abs(factor):g} "
            sign = ("- " if factor < 0 else "+ ") if out else ("-" if factor < 0 else "")
            out += f"{' ' if out else ''}{sign}{size}{axis}"
        return out


@dataclass(frozen=True, eq=False)
class AccelerationTable:
    """Accelerations of some axes by the posture of others: linear between the places of a grid, held beyond its edges.

    axes: the k axes that are limited; over: the p axes of the posture. places: p ascending lists [rad or m] that span
    the grid. lower, upper: the grid's shape and (k,), how much of either sign is allowed, both positive [1/s2].
    file: where it was read. times: by axis, how many times what is read there is asked for, where not once.
    """

    axes: tuple[str, ...]
    over: tuple[str, ...]
    places: tuple[Array, ...]
    lower: Array
    upper: Array
    file: Path | None = None
    times: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        shape = (*map(len, self.places), len(self.axes))
        for name in ("lower", "upper"):
            values = readonly(getattr(self, name))
            if values.shape != shape or not np.all((values > 0) & np.isfinite(values)):
                raise ValueError(f"AccelerationTable.{name}: wanted positive numbers of shape {shape}")
            object.__setattr__(self, name, values)
        if not all(len(places) > 1 and np.all(np.diff(places) > 0) for places in self.places):
            raise ValueError("AccelerationTable.places: wanted two or more of each axis, ascending")

    @cached_property
    def range(self) -> dict[str, tuple[float, float, float]]:
        """By axis the least of either sign, the median of the smaller sign's, and the greatest."""
        sides = [side.reshape(-1, len(self.axes)) for side in (self.lower, self.upper)]
        small = np.minimum(*sides)
        each = np.array([small.min(axis=0), np.median(small, axis=0), np.maximum(*sides).max(axis=0)]).T.tolist()
        return {axis: (least, usual, most) for axis, (least, usual, most) in zip(self.axes, each, strict=True)}

    @cached_property
    def _reads(self) -> Any:
        from scipy.interpolate import RegularGridInterpolator

        return RegularGridInterpolator(self.places, np.stack([self.lower, self.upper], axis=-2))

    def at(self, posture: Array) -> tuple[Array, Array]:
        """Both (..., k) at postures (..., p)."""
        low, high = ([places[end] for places in self.places] for end in (0, -1))
        found = self._reads(np.clip(np.nan_to_num(posture), low, high))
        return found[..., 0, :], found[..., 1, :]

    def without(self, axis: str) -> AccelerationTable | None:
        """The same of the other axes; None where that is none."""
        kept = [i for i, one in enumerate(self.axes) if one != axis]
        if not kept:
            return None
        names = tuple(self.axes[i] for i in kept)
        return replace(self, axes=names, lower=self.lower[..., kept], upper=self.upper[..., kept])

    def scaled(self, factors: Mapping[str, float]) -> AccelerationTable:
        """With those of some axes so many times as large."""
        each = [factors.get(axis, 1.0) for axis in self.axes]
        times = {axis: self.times.get(axis, 1.0) * one for axis, one in zip(self.axes, each, strict=True)}
        return replace(self, lower=self.lower * each, upper=self.upper * each, times=times)


def _axis(turning: str, rail: str) -> dict[str, str]:
    """A limit of every axis, which the cell file's `limits` have as a key: its units there."""
    return {"turning": turning, "rail": rail}


@dataclass(frozen=True, eq=False)
class JointLimits:
    """Limits of all axes in the robot's order (rail first), rad or m: position, speed [1/s], acceleration [1/s2].

    jerk [1/s3]: None where the robot's profile gives none; jerk_binds: every motion keeps it, not those alone that are
    made with it. torque [Nm, N for a rail]: what the drives give at most, inf for an axis of which nobody says it; None
    where nobody says it of any; torque_binds: every motion keeps it.
    sources maps "joint_3.acceleration" to where the number comes from and its grade in words; grades to the grade, A to
    D, of a number of the robot's own files; spread to between which shares of it the true one is taken to be. coupled:
    ranges of sums of axes, where the arm's links are coupled.
    table: accelerations by posture; `acceleration` has the least of them, which every posture allows.
    """

    names: tuple[str, ...]
    lower: Array
    upper: Array
    velocity: Array = field(metadata=_axis("rad/s", "m/s"))
    acceleration: Array = field(metadata=_axis("rad/s2", "m/s2"))
    sources: Mapping[str, str] = field(default_factory=dict)
    jerk: Array | None = field(default=None, metadata=_axis("rad/s3", "m/s3"))
    grades: Mapping[str, str] = field(default_factory=dict)
    spread: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    jerk_binds: bool = False
    coupled: tuple[CoupledRange, ...] = ()
    torque: Array | None = field(default=None, metadata=_axis("Nm", "N"))
    torque_binds: bool = False
    table: AccelerationTable | None = None

    def acceleration_at(self, q: Array) -> tuple[Array, Array]:
        """What the axes may have of negative and of positive acceleration, both positive (..., n), at q (..., n)."""
        lower, upper = (np.broadcast_to(self.acceleration, q.shape).copy() for _ in range(2))
        if self.table is not None:
            at, over = ([self.names.index(one) for one in of] for of in (self.table.axes, self.table.over))
            lower[..., at], upper[..., at] = self.table.at(q[..., over])
        return lower, upper

    @property
    def most_acceleration(self) -> Array:
        """The greatest (n,) that any posture allows."""
        return self._of_table(2)

    @property
    def usual_acceleration(self) -> Array:
        """What (n,) most postures allow: for estimates."""
        return self._of_table(1)

    def _of_table(self, place: int) -> Array:
        known = {} if self.table is None else self.table.range
        own = zip(self.names, self.acceleration.tolist(), strict=True)
        return np.array([known[axis][place] if axis in known else one for axis, one in own])

    def changed(self, kind: str, values: Array) -> JointLimits:
        """The same with these (n,) of a kind, "velocity" say; accelerations of a table change as the least of them."""
        one: dict[str, Any] = {kind: values}
        if kind == "acceleration" and self.table is not None:
            factors = dict(zip(self.names, (np.asarray(values) / self.acceleration).tolist(), strict=True))
            one["table"] = self.table.scaled(factors)
        return replace(self, **one)

    @property
    def binding_torque(self) -> Array | None:
        """The torque limits where every motion keeps them."""
        return self.torque if self.torque_binds else None

    @property
    def binding_jerk(self) -> Array | None:
        """The jerk limits where every motion keeps them; None also for limits so high that no rows of a file could show
        whether they are kept: the acceleration may turn round from one row to the next."""
        if not self.jerk_binds or self.jerk is None:
            return None
        return None if np.all(self.jerk * _NEAREST_ROWS >= 2 * self.acceleration) else self.jerk

    @cached_property
    def couplings(self) -> Couplings:
        """The ranges of sums of axes as numbers."""
        rows = np.zeros((len(self.coupled), len(self.names)))
        for row, one in zip(rows, self.coupled, strict=True):
            row[[self.names.index(axis) for axis in one.axes]] = one.factors
        ends = (np.array([getattr(one, end) for one in self.coupled], dtype=np.float64) for end in ("lower", "upper"))
        return Couplings(rows, *ends)

    def __post_init__(self) -> None:
        for one in self.coupled:
            if not {*one.axes} <= {*self.names}:
                raise ValueError(f"JointLimits: {one.name} names an axis that is none of {', '.join(self.names)}")
        for name in ("lower", "upper", *AXIS_LIMITS):
            if getattr(self, name) is None:
                continue
            values = readonly(getattr(self, name))
            if values.shape != (len(self.names),):
                raise ValueError(f"JointLimits.{name} has shape {values.shape}, wanted ({len(self.names)},)")
            object.__setattr__(self, name, values)
        if not np.all(self.lower < self.upper):
            raise ValueError("JointLimits: every lower limit must lie under its upper limit")
        if not (np.all(self.velocity > 0) and np.all(self.acceleration > 0)):
            raise ValueError("JointLimits: speeds and accelerations must be positive")
        if self.jerk is not None and not np.all(self.jerk > 0):
            raise ValueError("JointLimits: jerks must be positive")
        if self.jerk_binds and self.jerk is None:
            raise ValueError("JointLimits: jerks that bind must be given")
        if self.torque is not None and not np.all(self.torque > 0):
            raise ValueError("JointLimits: torques must be positive")
        if self.torque_binds and self.torque is None:
            raise ValueError("JointLimits: torques that bind must be given")
        if self.table is not None and not {*self.table.axes, *self.table.over} <= {*self.names}:
            raise ValueError(f"JointLimits.table names an axis that is none of {', '.join(self.names)}")


AXIS_LIMITS = {one.name: one.metadata for one in fields(JointLimits) if one.metadata}
"""Limits of every axis but its range, by name, with their units."""


@dataclass(frozen=True, eq=False)
class Couplings:
    """c ranges of sums of n axes: lower <= rows @ q <= upper, rows (c, n), lower and upper (c,). c may well be 0."""

    rows: Array
    lower: Array
    upper: Array

    def __bool__(self) -> bool:
        return len(self.rows) > 0

    def arm(self, joints: slice) -> Couplings:
        """The same of the arm's joints alone."""
        return Couplings(self.rows[:, joints], self.lower, self.upper)

    def within(self, q: Array, slack: float = 1e-9) -> BoolArray:
        """Whether axes (..., n) keep all of them, but for a slack [rad]; NaN does not."""
        if not self:
            return np.ones(q.shape[:-1], dtype=bool)
        with np.errstate(invalid="ignore"):
            sums = q @ self.rows.T
            return np.asarray(np.all((sums >= self.lower - slack) & (sums <= self.upper + slack), axis=-1))

    def ratios(self, q: Array) -> Array:
        """How far the sums (..., c) are from the middles of their ranges, as shares of half of them."""
        half = (self.upper - self.lower) / 2
        return np.asarray(np.abs(q @ self.rows.T - (self.upper + self.lower) / 2) / half)


@dataclass(frozen=True)
class TcpCaps:
    """Caps on the tool centre point in the world, on every motion: keys of the cell file's `tcp`, each with its unit;
    one with a default may be left out there."""

    speed: float = field(metadata={"unit": "m/s"})
    acceleration: float = field(metadata={"unit": "m/s2"})
