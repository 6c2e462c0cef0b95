"""From the solver's variables back to an iterate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.nlp.transcription import LegVariables, Transcription, glides
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, LegMotion, PathLeg
from trajopt_cli.trajectories.profiles import hold, profiles


def read(program: Transcription, x: Array) -> Iterate:
    """The iterate that variables x describe.

    Raises ValueError for a joint move whose switches cannot be told apart in a file.
    """
    axes, problem, iterate = program.axes, program.problem, program.iterate
    q, qd = (np.array([x[i] for i in indices]) for indices in (program.waypoint_q, program.waypoint_qd))
    rates = {k: float(x[i]) for k, i in program.waypoint_rate.items()}
    turns = {k: x[i] for k, i in program.waypoint_turn.items()}
    q, qd = _polished(axes, problem, iterate, q, qd, rates, turns)
    qdd = None
    if program.waypoint_qdd:
        qdd = _accelerations(axes, problem, q, qd, np.array([x[i] for i in program.waypoint_qdd]))
    legs: list[LegMotion | None] = []
    for leg, motion, var in zip(problem.legs, iterate.legs, program.legs, strict=True):
        k = leg.start
        if motion is None:
            legs.append(None)
        elif var is None and glides(leg):
            assert isinstance(motion, PathLeg)
            legs.append(_glide(axes, motion, q[k : k + 2], turns.get(k, np.zeros(3))))
        elif var is None:  # a dwell in which nothing moves, or no time for it
            legs.append(replace(hold(motion.T, q[k]), qd_0=qd[k]))
        elif isinstance(motion, PathLeg):
            every = (q, qd) if qdd is None else (q, qd, qdd)
            both = [one[k : k + 2, axes.layout.rail] for one in every]
            if motion.axis is not None:
                both = [np.column_stack([one, [turns[i][n] for i in (k, k + 1)]]) for n, one in enumerate(both)]
            own = _path(motion, var, x, q[k, axes.layout.arm], both)
            for node, i in ((0, k), (-1, k + 1)):
                if i in rates and leg.kind is LegKind.LINE:
                    own.v[node] = rates[i] * own.T / program.rate_share(leg, node, i)
            legs.append(own)
        elif isinstance(motion, JointProfiles):
            legs.append(_profiles(axes, leg, q[k : k + 2], qd[k : k + 2], float(x[var.T]), program.least(leg)))
        else:
            assert isinstance(motion, JointNodes)
            T, nodes, velocities = float(x[var.T]), x[var.q], x[var.qv]
            if len(var.qj):
                assert qdd is not None
                ends = (q[k : k + 2], qd[k : k + 2] * T, qdd[k : k + 2] * T**2)
                legs.append(JointNodes(T, motion.grid, *_exact(motion.grid, ends, x[var.qj])))
                continue
            nodes[0], nodes[-1], velocities[0], velocities[-1] = q[k], q[k + 1], qd[k] * T, qd[k + 1] * T
            legs.append(JointNodes(T, motion.grid, nodes, velocities, x[var.qa]))
    return Iterate(q, qd, iterate.cfx, tuple(legs), qdd)


def _accelerations(axes: Axes, problem: Problem, q: Array, qd: Array, qdd: Array) -> Array:
    """Those at the waypoints (M, n) with the arm's exactly as the rail's make them."""
    rail, arm = axes.layout.rail, axes.layout.arm
    for k, stop in enumerate(problem.waypoints):
        if stop.q is None and not problem.rests(k):
            at = axes.differential(q[k], np.eye(4))
            J = at.jacobian()
            qdd[k, arm] = np.linalg.solve(J[:, arm], -J[:, rail] @ qdd[k, rail] - at.bias(qd[k]))
    return qdd


def _exact(grid: Array, ends: tuple[Array, Array, Array], jerk: Array) -> tuple[Array, Array, Array]:
    """Nodes x, v (N+1, k) and mean accelerations (N, k) of constant jerks (N, k) between given states (2, k) of
    position, velocity and acceleration: integrated to rounding, so that the acceleration goes on through the nodes,
    with what the solver leaves at the end spread over all of it."""
    h = np.diff(grid)[:, None]
    x, v, a = (np.zeros((len(grid), jerk.shape[1])) for _ in range(3))
    x[0], v[0], a[0] = (one[0] for one in ends)
    for i in range(len(jerk)):
        a[i + 1] = a[i] + h[i] * jerk[i]
        v[i + 1] = v[i] + h[i] * (a[i] + h[i] / 2 * jerk[i])
        x[i + 1] = x[i] + h[i] * (v[i] + h[i] * (a[i] / 2 + h[i] / 6 * jerk[i]))
    off = np.array([one[1] - now[-1] for one, now in zip(ends, (x, v, a), strict=True)])
    # the quintic that is nothing at the start and all of what is missing at the end
    powers = np.array([[1, 1, 1], [3, 4, 5], [6, 12, 20]])
    c = np.linalg.solve(powers, off)
    u = grid[:, None, None]
    x += np.sum(c * u ** np.array([3, 4, 5])[:, None], axis=1)
    v += np.sum(c * np.array([3, 4, 5])[:, None] * u ** np.array([2, 3, 4])[:, None], axis=1)
    x[-1], v[-1] = ends[0][1], ends[1][1]
    return x, v, np.diff(v, axis=0) / h


def _polished(
    axes: Axes, problem: Problem, iterate: Iterate, q: Array, qd: Array, rates: Mapping[int, float],
    turns: Mapping[int, Array],
) -> tuple[Array, Array]:  # fmt: skip
    """Waypoint states with the arm exactly where rail and turn put it; the solver leaves a residual. rates: at which
    those that are passed along a path are. turns: of tools beyond the waypoints' poses, with their rates."""
    rail, arm = axes.layout.rail, axes.layout.arm
    for k, stop in enumerate(problem.waypoints):
        passage = stop.passage
        if stop.q is not None or (passage is not None and passage.way is None):
            continue
        turn, spin, _ = turns.get(k, np.zeros(3))
        X_WF = stop.X_WF if stop.turn is None else stop.turn.turned(stop.X_WF, turn)
        joints = axes.inverse(X_WF[None], q[k : k + 1, rail])[0, iterate.cfx[k]]
        q[k, arm] = joints + 2 * np.pi * np.round((q[k, arm] - joints) / (2 * np.pi))
        qd[k, arm] = axes.self_motion(q[k]) @ qd[k, rail]
        if passage is not None and passage.way is not None:
            tool = rates[k] * passage.way.twist(np.zeros(1))[0]
            if stop.turn is not None:
                tool[3:] += spin * (X_WF[:3, :3] @ stop.turn.axis_F)
            qd[k, arm] += np.linalg.solve(axes.jacobian(q[k], passage.X_FT)[:, arm], tool)
    return q, qd


def _path(motion: PathLeg, var: LegVariables, x: Array, reference: Array, ends: list[Array]) -> PathLeg:
    """ends: positions (2, m) of the rail, and of the tool's turn if it has one, at the waypoints, their velocities and,
    where jerk is limited, their accelerations."""
    T = float(x[var.T])
    lengths = np.repeat(x[var.h], motion.N // 3)
    grid = np.concatenate([[0.0], np.cumsum(lengths[:-1]), [1.0]])
    s, v, a = (x[var.s], x[var.v], x[var.a]) if len(var.s) else (motion.s, motion.v, motion.a)
    still = np.zeros((2, 1))
    if not len(var.d):  # in proportion to the path parameter
        s, v, a = _exact(grid, (np.array([[0.0], [1.0]]), still, still), x[var.j][:, None])
        span = ends[0][1] - ends[0][0]
        d, w, b = ends[0][0] + s * span, v * span, a * span
        return replace(motion, T=T, grid=grid, s=s[:, 0], v=v[:, 0], a=a[:, 0], d=d, w=w, b=b)
    d, w, b = x[var.d], x[var.w], x[var.b]
    w[0], w[-1] = ends[1] * T  # short legs make much of what the solver leaves
    if len(ends) > 2:
        d, w, b = _exact(grid, (ends[0], ends[1] * T, ends[2] * T**2), x[var.y])
        if len(var.j):
            s, v, a = (one[:, 0] for one in _exact(grid, (np.array([[0.0], [1.0]]), still, still), x[var.j][:, None]))
    return replace(motion, T=T, grid=grid, s=s, v=v, a=a, d=d, w=w, b=b, reference=reference)


def _glide(axes: Axes, motion: PathLeg, q: Array, turn: Array) -> PathLeg:
    d_0, d_1 = q[:, axes.layout.rail]
    if motion.axis is not None:
        d_0, d_1 = np.append(d_0, turn[0]), np.append(d_1, turn[0])
    d = d_0 + motion.grid[:, None] * (d_1 - d_0)
    w = np.tile(d_1 - d_0, (motion.N + 1, 1))
    return replace(motion, d=d, w=w, b=np.zeros_like(motion.b), reference=q[0, axes.layout.arm])


def _profiles(axes: Axes, leg: Leg, q: Array, qd: Array, T: float, low: float) -> JointProfiles:
    # between given states the least time is known in closed form; the solver's T only comes near it
    least = T if leg.duration is not None else low
    return profiles(
        q[0], qd[0], q[1], qd[1], axes.velocity_on(leg), axes.acceleration_on(leg), least, False, axes.settings
    )
