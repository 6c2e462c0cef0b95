"""One leg's motion as numbers: what the nonlinear program found, to be sampled, split and checked.

Every motion is piecewise polynomial in scaled time tau = t / T with exact integration, so a leg may be sampled at any
time without loss, and splitting an interval changes nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.path.segment import Segment


def integrate(grid: Array, x: Array, v: Array, tau: Array, right: bool = True) -> tuple[Array, Array, Array]:
    """Position, velocity, acceleration (scaled time) at tau (n,) of node values x, v (N+1, ...) on a grid over 0..1.

    At a node the acceleration is the one of the interval on its right or left. The cubic Hermite
    between nodes is the exact integral up to the solver's residual, without its jumps.
    """
    aside = tau + (1e-12 if right else -1e-12)  # a time that is a node up to rounding belongs to the side asked for
    i = np.clip(np.searchsorted(grid, aside, side="right") - 1, 0, len(grid) - 2)
    tail = [1] * (x.ndim - 1)
    h = (grid[i + 1] - grid[i]).reshape(-1, *tail)
    u = (tau - grid[i]).reshape(-1, *tail) / h
    v0, v1 = v[i] * h, v[i + 1] * h
    way = x[i + 1] - x[i]
    c2, c3 = 3 * way - 2 * v0 - v1, v0 + v1 - 2 * way
    position = x[i] + u * (v0 + u * (c2 + u * c3))
    return position, (v0 + u * (2 * c2 + 3 * u * c3)) / h, (2 * c2 + 6 * u * c3) / (h * h)


def halved(grid: Array) -> Array:
    """The grid with a node in the middle of every interval."""
    out = np.empty(2 * len(grid) - 1)
    out[::2], out[1::2] = grid, (grid[:-1] + grid[1:]) / 2
    return out


def split(grid: Array, x: Array, v: Array, a: Array) -> tuple[Array, Array, Array]:
    """The same motion on the halved grid."""
    finer = halved(grid)
    xs, vs, _ = integrate(grid, x, v, finer)
    xs[::2], vs[::2] = x, v
    return xs, vs, np.repeat(a, 2, axis=0)


def parabola(grid: Array) -> tuple[Array, Array, Array]:
    """Rest to rest over unit length with one switch in the middle, which must be a node: s, v, a."""
    s = np.where(grid <= 0.5, 2 * grid**2, 1 - 2 * (1 - grid) ** 2)
    v = np.where(grid <= 0.5, 4 * grid, 4 * (1 - grid))
    return s, v, np.where(grid[:-1] < 0.5 - 1e-12, 4.0, -4.0)


@dataclass(frozen=True, eq=False)
class Sample:
    """All axes (m, n) at times t (m,) of a leg: positions, velocities, accelerations."""

    t: Array
    q: Array
    qd: Array
    qdd: Array


@dataclass(frozen=True, eq=False)
class PathLeg:
    """A line or dwell with its rail motion. s, v: (N+1,), a: (N,); d, w: (N+1, r), b: (N, r); scaled time."""

    T: float
    segment: Segment  # of the tool, in the world; a line of no length for a dwell
    X_FT: Array
    cfx: int
    reference: Array  # joints near the start, on the branch and turn meant
    grid: Array
    s: Array
    v: Array
    a: Array
    d: Array
    w: Array
    b: Array

    @property
    def N(self) -> int:
        """Intervals."""
        return len(self.a)

    def refined(self) -> PathLeg:
        """The same motion on twice as many intervals."""
        s, v, a = split(self.grid, self.s, self.v, self.a)
        d, w, b = split(self.grid, self.d, self.w, self.b)
        return replace(self, grid=halved(self.grid), s=s, v=v, a=a, d=d, w=w, b=b)

    def breaks(self) -> Array:
        """Times (N+1,) where an acceleration may jump."""
        return self.T * self.grid

    def node_arm(self, axes: Axes) -> Array:
        """Arm joints (N+1, joints) at the nodes."""
        X_WT = self.segment.pose(self.s)
        arm = axes.inverse(X_WT @ inverse_pose(self.X_FT), axes.layout.value(self.d))[:, self.cfx, :]
        return unwind(arm, self.reference)

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """Positions by inverse kinematics, velocities, accelerations through the Jacobian. At a break: right side."""
        tau = np.clip(t / self.T, 0.0, 1.0)
        s, sv, sa = integrate(self.grid, self.s, self.v, tau, right)
        d, dv, da = integrate(self.grid, self.d, self.w, tau, right)
        sv, dv, sa, da = sv / self.T, dv / self.T, sa / self.T**2, da / self.T**2
        arm = axes.inverse(self.segment.pose(s) @ inverse_pose(self.X_FT), axes.layout.value(d))[:, self.cfx, :]
        q = axes.layout.merge(d, unwind(arm, self.reference))
        twist, bend = self.segment.twist(s), self.segment.twist_rate(s)
        J = axes.jacobian(q, self.X_FT)
        Jr, Ja = J[:, :, axes.layout.rail], J[:, :, axes.layout.arm]

        def arm_follows(tool: Array, rail: Array) -> Array:
            """Joint rates (n, m) that move the tool by its part of a rate, the rail having its own."""
            return np.asarray(np.linalg.solve(Ja, (tool - (Jr @ rail[..., None])[..., 0])[..., None])[..., 0])

        qd = axes.layout.merge(dv, arm_follows(sv[:, None] * twist, dv))
        carried = (axes.jacobian_rate(q, qd, self.X_FT) @ qd[..., None])[..., 0]
        qdd = axes.layout.merge(da, arm_follows(sa[:, None] * twist + sv[:, None] ** 2 * bend - carried, da))
        return Sample(t, q, qd, qdd)


def unwind(arm: Array, reference: Array) -> Array:
    """Joints (m, joints) moved by whole turns: the first near the reference, each next near the one before."""
    first = arm[0] + 2 * np.pi * np.round((reference - arm[0]) / (2 * np.pi))
    steps = np.diff(arm, axis=0)
    steps -= 2 * np.pi * np.round(steps / (2 * np.pi))
    return np.concatenate([first[None], first + np.cumsum(steps, axis=0)])


@dataclass(frozen=True, eq=False)
class JointNodes:
    """A joint move on a grid: q, v (N+1, n), a (N, n), scaled time. Also a straight one with one profile for all."""

    T: float
    grid: Array
    q: Array
    v: Array
    a: Array

    @property
    def N(self) -> int:
        """Intervals."""
        return len(self.a)

    def refined(self) -> JointNodes:
        """The same motion on twice as many intervals."""
        return JointNodes(self.T, halved(self.grid), *split(self.grid, self.q, self.v, self.a))

    def breaks(self) -> Array:
        """Times (N+1,) where an acceleration may jump."""
        return self.T * self.grid

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """Exact polynomial values."""
        q, v, a = integrate(self.grid, self.q, self.v, np.clip(t / self.T, 0.0, 1.0), right)
        return Sample(t, q, v / self.T, a / self.T**2)


@dataclass(frozen=True, eq=False)
class JointProfiles:
    """A joint move where each axis has three phases of its own. times (n, 4), accelerations (n, 3); real time."""

    T: float
    q_0: Array
    qd_0: Array
    times: Array
    accelerations: Array

    @property
    def N(self) -> int:
        """Phases of an axis."""
        return 3

    def breaks(self) -> Array:
        """Times where some axis switches, ascending; twice the start where no axis moves."""
        times = np.unique(self.times.ravel())
        return times if len(times) > 1 else np.repeat(times, 2)

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        """Exact polynomial values."""
        q, qd, qdd = (np.empty((len(t), len(self.q_0))) for _ in range(3))
        side: Literal["left", "right"] = "right" if right else "left"
        for j in range(len(self.q_0)):
            h, acc = np.diff(self.times[j]), self.accelerations[j]
            v = self.qd_0[j] + np.concatenate([[0], np.cumsum(acc * h)])
            x = self.q_0[j] + np.concatenate([[0], np.cumsum(v[:-1] * h + acc * h * h / 2)])
            i = np.clip(np.searchsorted(self.times[j], t, side=side) - 1, 0, 2)
            dt = t - self.times[j][i]
            q[:, j] = x[i] + v[i] * dt + acc[i] * dt * dt / 2
            qd[:, j] = v[i] + acc[i] * dt
            qdd[:, j] = acc[i]
        return Sample(t, q, qd, qdd)


LegMotion = PathLeg | JointNodes | JointProfiles


def share_of(motion: JointNodes) -> tuple[Array, Array, Array]:
    """The common share s, v, a of a straight joint move."""
    way = motion.q[-1] - motion.q[0]
    j = int(np.argmax(np.abs(way)))
    if way[j] == 0:
        return motion.grid, np.zeros(motion.N + 1), np.zeros(motion.N)
    return (motion.q[:, j] - motion.q[0, j]) / way[j], motion.v[:, j] / way[j], motion.a[:, j] / way[j]


def straight(T: float, grid: Array, q_0: Array, q_1: Array, s: Array, v: Array, a: Array) -> JointNodes:
    """A straight joint move from its common share."""
    way = q_1 - q_0
    return JointNodes(T, grid, q_0 + s[:, None] * way, v[:, None] * way, a[:, None] * way)
