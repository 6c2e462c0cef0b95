"""Where the tool centre point of a six-axis arm is and how it moves with its axes: pose, Jacobian, twist and its rate,
and the axes' own rates where the tool's are given. Compiled: robot.chain_loops.

Twists follow link by link from the base on (Featherstone, "Rigid Body Dynamics Algorithms", 2008, 2.11); no matrix of
derivatives is needed for their rates.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.arm import Arm

_NO_RAIL = np.zeros((0, 3))


@dataclass(frozen=True, eq=False)
class Differential:
    """Differential kinematics of an arm at axes q (..., k), those of r rails first; TCP motions are (..., 6) in world
    axes, linear first. X_WC (4, 4): the arm's canonical base with the rails at 0. ride (r, 3): directions of the rails'
    travel in the world. X_6T (4, 4): the TCP in the canonical frame behind axis 6."""

    arm: Arm
    q: Array
    X_WC: Array
    ride: Array
    X_6T: Array

    @classmethod
    def of(cls, arm: Arm, q: Array, X_FT: Array | None = None, X_WC: Array | None = None, ride: Array | None = None
    ) -> Differential:  # fmt: skip
        """Of an arm at q (..., k). None: the flange, in the canonical base, without a rail."""
        X_6T = arm.X_6F if X_FT is None else arm.X_6F @ X_FT
        return cls(arm, q, np.eye(4) if X_WC is None else X_WC, _NO_RAIL if ride is None else ride, X_6T)

    def pose(self) -> Array:
        """The TCP's pose X_WT (..., 4, 4)."""
        return self._found("poses", (4, 4))

    def points(self) -> Array:
        """A point on each axis and the TCP (..., 7, 3) [m]: axis 1 in the canonical base, axes 2 and 3 in the arm's
        plane, the wrist centre three times, for axis 6 with its offset; of three parallel axes axis 4 and then the
        wrist centre twice."""
        return self._found("points", (7, 3))

    def jacobian(self) -> Array:
        """Geometric Jacobian (..., 6, k): [v; omega] = J qd."""
        return self._found("jacobians", (6, self.q.shape[-1]))

    def motion(self, qd: Array, qdd: Array) -> Array:
        """The TCP's twist J qd and its rate J qdd + J' qd (..., 2, 6) at axis speeds and accelerations (..., k)."""
        for name, rates in (("qd", qd), ("qdd", qdd)):
            if rates.shape != self.q.shape:
                raise ValueError(f"{name} has shape {rates.shape}, wanted {self.q.shape} like q")
        return self._found("motions", (2, 6), qd, qdd)

    def velocity(self, qd: Array) -> Array:
        """The TCP's twist (..., 6) at axis speeds (..., k)."""
        return self.motion(qd, np.zeros_like(qd))[..., 0, :]

    def bias(self, qd: Array) -> Array:
        """The rate (..., 6) of that twist where no axis accelerates: J' qd."""
        return self.motion(qd, np.zeros_like(qd))[..., 1, :]

    def follow(self, twist: Array, change: Array, rail_rate: Array, rail_change: Array) -> tuple[Array, Array]:
        """Axis speeds and accelerations (m, k) at axes (m, k) with which the TCP moves by a twist and its rate (m, 6)
        while the rails have their own (m, r). NaN where the arm's Jacobian is singular."""
        qd, qdd = np.empty(self.q.shape), np.empty(self.q.shape)
        self._run("follow", self.q, twist, change, rail_rate, rail_change, qd, qdd)
        return qd, qdd

    def _found(self, name: str, shape: tuple[int, ...], *rates: Array) -> Array:
        """What a loop finds, an array of this shape for each place."""
        out, k = np.empty((self.q.size // self.q.shape[-1], *shape)), self.q.shape[-1]
        self._run(name, self.q.reshape(-1, k), *(np.asarray(x, dtype=np.float64).reshape(-1, k) for x in rates), out)
        return out.reshape(*self.q.shape[:-1], *shape)

    def _run(self, name: str, *arrays: Array) -> None:
        from trajopt_cli.native.loops import loops  # LLVM with it: not for who only loads a robot

        run = loops("trajopt_cli.robot.chain_loops")[name]
        run(self.arm.chain, self.X_WC, self.ride, self.X_6T, np.empty((4, 7, 7)), *arrays)
