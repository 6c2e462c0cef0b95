"""Joints that a program gives at a singularity: no margin is needed there, and a line may begin there.

At the wrist singularity many splits of one turn between two joints make the same pose. Just behind its start a line is
on one of them, which its direction decides; where that is the one given, the arm drives off without a jump.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.trajectories.axes import Axes

_STRETCHED = 1 - 1e-06  # |sin q3| up to which an arm given by its joints has not met its other branch: 0.08 degrees.
_LEAVING = 1e-07  # rad between joints given at a singularity and those with which a line leaves it.
_NEAREST = 16  # halvings of a line's first interval that look for where it has left a singularity.

_STRAIGHT = 1e-9  # sine of joint 5 up to which the wrist is straight


def walled(axes: Axes, arm: Array, most: float | None = None) -> BoolArray:
    """Whether joints (..., m) stand too near a singularity for a line, or to choose the rail there. most: how far the
    elbow may be stretched."""
    elbow, wrist = axes.robot.singularity_margins(arm)
    return np.asarray((elbow > (axes.settings.elbow if most is None else most)) | (wrist < axes.settings.wrist))


def usable(axes: Axes, arm: Array, pinned: bool = False) -> Array:
    """Joints (..., m), NaN where they do so. pinned: the rail is given at every point, and a line near the stretched
    elbow is but a slow one."""
    settings = axes.settings
    return np.where(walled(axes, arm, _STRETCHED if pinned else settings.elbow)[..., None], np.nan, arm)


@dataclass(frozen=True, eq=False)
class SingularStart:
    """How a station begins that rests in joints given by the program, which stand at a singularity.

    arm (m,); rail [m]; leg: the line that leaves it, None where the station has none; problem: whose it is.
    """

    arm: Array
    rail: float
    leg: Leg | None
    problem: Problem

    @classmethod
    def of(cls, axes: Axes, problem: Problem, first: int, last: int) -> SingularStart | None:
        """Of the station first..last; None where it begins in a pose, or in joints far from every singularity."""
        lines = [leg for leg in problem.legs[first:last] if leg.kind is LegKind.LINE]
        rests = lines[0].start if lines else last
        q = next((problem.waypoints[k].q for k in range(first, rests + 1) if problem.waypoints[k].q is not None), None)
        if q is None or not walled(axes, q[axes.layout.arm]):
            return None
        return cls(q[axes.layout.arm], float(axes.layout.place(q)), lines[0] if lines else None, problem)

    def column(self, d: Array) -> int:
        """Where on a grid of rail positions (n,) the rail stands."""
        return int(np.argmin(np.abs(d - self.rail)))

    def table(self, axes: Axes, problem: Problem, d: Array) -> tuple[Array, BoolArray]:
        """The joints (b, n, m), turned back within half a turn, of the branches that go on from them without a jump;
        NaN but where the rail stands. And (b, n): whether they do, where the rail goes to each place in proportion."""
        ok = np.abs(self.beginnings(axes, d) - self.arm).max(axis=-1) <= _LEAVING  # NaN is not
        out = np.full((*ok.shape, len(self.arm)), np.nan)
        turning = np.any(axes.robot.turns != 0, axis=0)
        within = self.arm - 2 * np.pi * np.round((self.arm - axes.robot.middles) / (2 * np.pi)) * turning
        out[ok[:, self._may_go(problem, d)].any(axis=1), self.column(d)] = within
        return out, ok

    def _may_go(self, problem: Problem, d: Array) -> BoolArray:
        """Towards which of the places (n,) the rail may set out."""
        if self.leg is None or not self.leg.rail_moves:
            return np.arange(len(d)) == self.column(d)
        low, high = problem.waypoints[self.leg.start + 1].rail
        return (low - 1e-12 <= d) & (d <= high + 1e-12) if problem.coordinated else np.ones(len(d), dtype=bool)

    def beginnings(self, axes: Axes, d: Array) -> Array:
        """Joints (b, n, m) in which each branch would begin, whole turns as given, where the rail goes to each place d
        (n,) in proportion to the line; NaN where a branch does not begin at all."""
        elbow, wrist = axes.robot.singularity_margins(self.arm)
        if self.leg is not None and (wrist < axes.settings.wrist or elbow > _STRETCHED):
            return self._leaving(axes, d)
        out = self._nearest_turns(axes.inverse(self._pose(axes), np.array([self.rail]))[0])
        if self.leg is None:
            out[:] = np.nan
            out[axes.robot.branch_of(self.arm)] = self.arm
        return np.repeat(out[:, None], len(d), axis=1)

    def _leaving(self, axes: Axes, d: Array) -> Array:
        """The line's joints just behind its start, continued back to it by a parabola through three places outside the
        singularity margins; NaN where a branch is not outside soon."""
        assert self.leg is not None
        shares = 2.0 ** np.arange(-_NEAREST, 3) / (axes.settings.line_samples - 1)
        X_WF = self.problem.seen_along(self.leg, shares)
        rails = self.rail + shares[:, None] * (d - self.rail)
        arm = axes.inverse(np.repeat(X_WF, len(d), axis=0), rails.ravel())
        arm = np.moveaxis(usable(axes, arm).reshape(*rails.shape, *arm.shape[1:]), 0, 2)  # (n, b, shares, m)
        out = np.full((*arm.shape[:2], arm.shape[-1]), np.nan)
        for place, cfx in np.ndindex(arm.shape[:2]):
            lost = np.flatnonzero(np.isnan(arm[place, cfx, :, 0]))
            i = int(lost[-1]) + 1 if len(lost) else 0
            if i + 2 < len(shares):
                q = np.unwrap(arm[place, cfx, i : i + 3], axis=0)
                out[place, cfx] = (8 * q[0] - 6 * q[1] + q[2]) / 3  # Lagrange's at 0 of places s, 2s, 4s
        # beside the singularity: on the other branch the line crosses it
        if axes.robot.singularity_margins(self.arm)[1] > _STRAIGHT:
            own = self._nearest_turns(axes.inverse(self._pose(axes), np.array([self.rail]))[0])
            out[:, ~(np.abs(own - self.arm).max(axis=1) <= _LEAVING)] = np.nan
        return np.swapaxes(self._nearest_turns(out), 0, 1)

    def jump(self, axes: Axes, problem: Problem, d: Array) -> str | None:
        """What the joints would have to do before the line could leave, in words; None where nothing is in the way."""
        away = (self.beginnings(axes, d) - self.arm)[:, self._may_go(problem, d)].reshape(-1, len(self.arm))
        most = np.abs(away).max(axis=1)
        if np.isnan(most).all() or np.nanmin(most) <= _LEAVING:
            return None
        least = away[np.nanargmin(most)]
        names = [axes.names[i] for i in range(axes.n)[axes.layout.arm]]
        turns = [
            f"{name} turned by {np.degrees(turn):+.6f}°"
            for name, turn in zip(names, least, strict=True)
            if abs(turn) > _LEAVING
        ]
        wrist = axes.robot.singularity_margins(self.arm)[1] < axes.settings.wrist
        i, where = (4, "in the wrist singularity") if wrist else (2, "with the arm stretched or folded")
        return (
            f" starts {where} ({names[i]} = {np.degrees(self.arm[i]):.3g}°) and leaves it with {' and '.join(turns)}:"
            f" turn them there before, or give the start another {names[i]}"
        )

    def _nearest_turns(self, arm: Array) -> Array:
        return np.asarray(arm - 2 * np.pi * np.round((arm - self.arm) / (2 * np.pi)))

    def _pose(self, axes: Axes) -> Array:
        """The flange there (1, 4, 4)."""
        return axes.forward(axes.layout.join(np.array([self.rail]), self.arm[None]))
