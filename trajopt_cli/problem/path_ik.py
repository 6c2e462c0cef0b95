"""Paths of the tool followed with the joints changing continuously from a given start: where they end, and how.

The arm stays in its branch (no path leads from one to another but through a singularity), so a path is one branch of
the inverse, sampled, its whole turns removed between neighbours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.path.segment import Segment, along_all
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import inverse

# Samples per line: short ones, all others, and again where a joint turns more than _FAST between two of them.
_SHORT, _USUAL, _FINE = 5, 41, 641
_SMALL = (0.03, 0.2)  # m and rad: a line this short has few samples
_FAST = 0.8  # rad of a joint between two samples beyond which a turn may be missed
_JUMP = 0.5 * np.pi  # rad between the finest samples: no joint follows that
_WRIST = 1e-3  # sine of the bent wrist below which joint_4 and joint_6 are no longer told apart
_SAME = 1e-5  # rad between start joints and their branch
_BEYOND = 1e-6  # rad a joint may be past its limit by rounding
_AT_ONCE = 40_000  # samples: 30 MB of work arrays


@dataclass(frozen=True, eq=False)
class ArmPath:
    """A path of the tool X_FT and where the arm begins it. rail [m] (r,) at both ends. q (6,) [rad]: joints at the
    start."""

    segment: Segment
    X_FT: Array
    rail: tuple[Array, Array]
    q: Array


@dataclass(frozen=True, eq=False)
class Followed:
    """end (6,) [rad]: joints at the end, NaN where the path does not get there. length [m]: of the path.

    At most one of three things, the first on the path, at s in 0..1. lost: from where on the branch has no
    solution. singular: where joints jump; jump (6,) [rad]: by how much in one sample. beyond: (joint, s, limit
    [rad]) that is passed.
    """

    end: Array
    length: float
    lost: float | None
    singular: float | None
    jump: Array
    beyond: tuple[int, float, float] | None

    @property
    def whole(self) -> bool:
        """Whether the arm gets to the end."""
        return self.lost is None and self.singular is None and self.beyond is None

    def at(self, s: float) -> str:
        """A place on the path, in words."""
        if self.length < 1e-6:
            return f"at {100 * s:.0f} % of its turn"
        return f"at {s * self.length * 1e3:.1f} mm of {self.length * 1e3:.1f} mm"

    def what(self, names: Sequence[str]) -> str:
        """What the joints would have to do at the singularity, in words."""
        parts = [
            f"{name} turns by {np.degrees(value):.0f}° at once"
            for name, value in zip(names, np.abs(self.jump), strict=True)
            if value > _JUMP
        ]
        return ", ".join(parts) or f"{names[4]} is 0° and {names[3]} and {names[5]} turn about one axis"


def follow(plant: Plant, paths: Sequence[ArmPath]) -> list[Followed | None]:
    """Each path followed; None where the start joints are on no branch (a singular start) or are not at the start."""
    out: list[Followed | None] = [None] * len(paths)
    todo = np.array([_short(path.segment) for path in paths], dtype=bool)
    short, rest = np.flatnonzero(todo), np.flatnonzero(~todo)
    rest = np.r_[rest, _level(plant, paths, short, _SHORT, out)]
    rest = _level(plant, paths, rest, _USUAL, out)
    _level(plant, paths, rest, _FINE, out)
    return out


def _short(segment: Segment) -> bool:
    return segment.straight and segment.length < _SMALL[0] and segment.angle < _SMALL[1]


def _level(
    plant: Plant, paths: Sequence[ArmPath], which: IndexArray, samples: int, out: list[Followed | None]
) -> IndexArray:
    """Follow some paths with so many samples; gives those back that need more."""
    again: list[int] = []
    per = max(_AT_ONCE // samples, 1)
    for start in range(0, len(which), per):
        some = which[start : start + per]
        q, known = _sampled(plant, [paths[i] for i in some], samples)
        steps = np.abs(np.diff(q, axis=1))
        fast: BoolArray = np.asarray(~(steps <= _FAST).all(axis=(1, 2)))  # NaN is fast, too
        weak: BoolArray = np.asarray(plant.robot.singularity_margins(q)[1] < _WRIST)
        for j, i in enumerate(some.tolist()):
            if not known[j]:
                out[i] = None
            elif samples < _FINE and (fast[j] or weak[j].any()):
                again.append(i)
            else:
                out[i] = _followed(plant, paths[i].segment.length, q[j], steps[j], weak[j])
    return np.array(again, dtype=np.intp)


def _sampled(plant: Plant, paths: Sequence[ArmPath], samples: int) -> tuple[Array, Array]:
    """Joints (m, samples, 6) along each path, and which of them have a branch at the start."""
    m, s = len(paths), np.linspace(0, 1, samples)
    X_FT = np.array([path.X_FT for path in paths])
    X_WT = along_all([path.segment for path in paths], [s] * m)[0].reshape(m, samples, 4, 4)
    X_WF = X_WT @ inverse_pose(X_FT)[:, None]
    rail = np.array([path.rail for path in paths])  # (m, 2, r)
    rails = rail[:, :1] + s[:, None] * (rail[:, 1:] - rail[:, :1])
    branches = inverse(plant.robot, X_WF.reshape(-1, 4, 4), rails.reshape(m * samples, -1))
    branches = branches.reshape(m, samples, *branches.shape[1:])
    start = np.array([path.q for path in paths])
    away = branches[:, 0] - start[:, None]
    away = np.abs(away - 2 * np.pi * np.round(away / (2 * np.pi))).max(axis=-1)
    away = np.where(np.isnan(away), np.inf, away)
    branch = np.argmin(away, axis=1)
    each = np.arange(m)
    q = np.unwrap(branches[each, :, branch], axis=1)
    q += 2 * np.pi * np.round((start - q[:, 0]) / (2 * np.pi))[:, None]
    return q, away[each, branch] <= _SAME


def _followed(plant: Plant, length: float, q: Array, steps: Array, weak: BoolArray) -> Followed:
    """What joints (samples, 6) along one path come to. steps: between them; weak: where the wrist is straight."""
    last = len(q) - 1
    gone = np.flatnonzero(np.isnan(q[:, 0]))
    lost = None if not len(gone) else int(gone[0]) / last
    jumps = np.flatnonzero((steps > _JUMP).any(axis=1))
    jump = np.nan_to_num(steps[jumps]).max(axis=0) if len(jumps) else np.zeros(q.shape[-1])
    singular = (int(jumps[0]) + 0.5) / last if len(jumps) else None
    if weak.any():
        singular = int(np.nanargmin(plant.robot.singularity_margins(q)[1])) / last
    low, high = plant.limits.lower[plant.layout.arm], plant.limits.upper[plant.layout.arm]
    with np.errstate(invalid="ignore"):
        out = (q < low - _BEYOND) | (q > high + _BEYOND)
    beyond = None
    if out.any():
        sample = int(np.argmax(out.any(axis=1)))
        joint = int(np.argmax(out[sample]))
        beyond = (joint, sample / last, float(low[joint] if q[sample, joint] < low[joint] else high[joint]))
    first = min(s for s in (lost, singular, None if beyond is None else beyond[1], 2.0) if s is not None)
    return Followed(
        q[-1],
        length,
        lost if lost == first else None,
        singular if singular == first else None,
        jump,
        beyond if beyond is not None and beyond[1] == first else None,
    )
