"""A sampled joint motion, and the cubic Hermite between its rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array, readonly

TABLE = "eax_"  # with which the names of positioners' axes begin


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Rows of time t (n,) [s], positions q (n, k) and, where the file has them, speeds qd (n, k), in rad or m.

    names gives the k axes in order, "rail" first where there is one. tables: the same of the positioners that turn,
    at the same times, each axis by its external axis, "eax_b"; None where none does, or the file does not tell.
    """

    names: tuple[str, ...]
    t: Array
    q: Array
    qd: Array | None = None
    tables: Trajectory | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "t", _kept(self.t))
        object.__setattr__(self, "q", _kept(self.q))
        n, k = len(self.t), len(self.names)
        if self.q.shape != (n, k):
            raise ValueError(f"Trajectory.q has shape {self.q.shape}, wanted ({n}, {k})")
        if self.qd is not None:
            object.__setattr__(self, "qd", _kept(self.qd))
            if self.qd.shape != (n, k):
                raise ValueError(f"Trajectory.qd has shape {self.qd.shape}, wanted ({n}, {k})")

    @property
    def whole(self) -> Trajectory:
        """All axes as one, the positioners' last."""
        if self.tables is None:
            return self
        qd = None if self.qd is None or self.tables.qd is None else np.hstack([self.qd, self.tables.qd])
        return Trajectory(self.names + self.tables.names, self.t, np.hstack([self.q, self.tables.q]), qd)

    @property
    def apart(self) -> Trajectory:
        """The same with what whole put together taken apart."""
        k = len([name for name in self.names if not name.startswith(TABLE)])
        if k == len(self.names) or any(name.startswith(TABLE) for name in self.names[:k]):
            return self
        own, its = slice(0, k), slice(k, len(self.names))
        qd, its_qd = (None if self.qd is None else self.qd[:, part] for part in (own, its))
        tables = Trajectory(self.names[its], self.t, self.q[:, its], its_qd)
        return Trajectory(self.names[own], self.t, self.q[:, own], qd, tables)

    def of(self, names: Sequence[str]) -> Trajectory:
        """The same of some axes, in this order. Raises ValueError for one that it does not have."""
        if tuple(names) == self.names:
            return self
        own = [self.names.index(name) for name in names]
        return replace(self, names=tuple(names), q=self.q[:, own], qd=None if self.qd is None else self.qd[:, own])

    @property
    def duration(self) -> float:
        """Time of the last row minus time of the first, s."""
        return float(self.t[-1] - self.t[0])


def _kept(values: Array) -> Array:
    """An array that nobody writes to as it is, a copy of any other: those of an hour are large."""
    return readonly(values) if values.flags.writeable or values.dtype != np.float64 else values


def hermite(trajectory: Trajectory, times: Array) -> tuple[Array, Array, Array]:
    """Position, speed and acceleration (m, k) of the cubic Hermite between rows, at times (m,) inside the file.

    At a row the acceleration is the one of the interval that begins there. Needs speeds in the file.
    """
    if trajectory.qd is None:
        raise ValueError("hermite needs a trajectory with speeds")
    t = trajectory.t
    i = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    h = (t[i + 1] - t[i])[:, None]
    u = (np.asarray(times)[:, None] - t[i][:, None]) / h
    delta = trajectory.q[i + 1] - trajectory.q[i]
    v0, v1 = trajectory.qd[i] * h, trajectory.qd[i + 1] * h
    c2, c3 = 3 * delta - 2 * v0 - v1, v0 + v1 - 2 * delta
    q = trajectory.q[i] + u * (v0 + u * (c2 + u * c3))
    qd = (v0 + u * (2 * c2 + 3 * u * c3)) / h
    qdd = (2 * c2 + 6 * u * c3) / (h * h)
    return q, qd, qdd
