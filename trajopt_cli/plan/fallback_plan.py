"""A slow motion by the plainest means, for a program that nothing faster was found for: a stop at every point.

From point to point in order, each time the axes nearest to those before that the arm can be driven to, going back a
point where it cannot be; each leg from rest to rest along a parabola of its own, as slow as its limits ask for. No
search over all points, no path, no TOPP, no nonlinear program has a say, so it stands where one of them fails. The
rails are where the program has them, where they are already, or in the middle or at the ends of what they may have.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from trajopt_cli.collision.motion_collision import clear
from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.shared_states import shared
from trajopt_cli.nlp.mesh_refinement import first_iterate
from trajopt_cli.problem.problem import LegKind, Problem, Waypoint
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_leg
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, LegMotion, integrate

_MOST = 1000  # legs that are tried before it is given up
_TIMES = 8  # looks at a leg that is made slower and slower
_SAME = 1e-9  # rad, m

State = tuple[Array, int]  # axes (k,), branch


def fallback_motion(axes: Axes, problem: Problem) -> Iterate | None:
    """A legal motion at rest at every point; None where none was found, and where jerk is limited, which parabolas do
    not keep."""
    if axes.jerk is not None:
        return None
    problem = replace(problem, waypoints=tuple(replace(point, fly_by=None) for point in problem.waypoints))
    states: list[State] = []
    legs: list[LegMotion] = []
    open_: list[Iterator[State]] = [_candidate_states(axes, problem, states, 0)]
    for _ in range(_MOST):
        if len(states) == len(problem.waypoints):
            break
        state = next(open_[-1], None)
        if state is None:
            open_.pop()
            if not open_:
                return None
            states.pop()
            del legs[len(states) - 1 :]
            continue
        motion = _leg_motion(axes, problem, len(legs), states[-1], state) if states else None
        if motion is not None:
            legs.append(motion)
        if motion is not None or not states:
            states.append(state)
            open_.append(_candidate_states(axes, problem, states, len(states)))
    if len(legs) < len(problem.legs):
        return None
    q = np.array([own for own, _ in states])
    iterate = Iterate(q, np.zeros_like(q), tuple(cfx for _, cfx in states), tuple(legs))
    return iterate if clear(axes, problem, iterate) else None


def _candidate_states(axes: Axes, problem: Problem, states: list[State], k: int) -> Iterator[State]:
    """Axes and branches that waypoint k may have, the nearest to those before first."""
    if k >= len(problem.waypoints):
        return
    point, layout = problem.waypoints[k], axes.layout
    q_0, cfx_0 = states[-1] if states else (problem.plant.start, -1)
    joint, moves = (True, True) if k == 0 else ((leg := problem.legs[k - 1]).kind is LegKind.JOINT, leg.rail_moves)
    tied = [(one, states[one][0]) for group in problem.ties if k in group for one in group if one < k]
    if point.q is not None:
        yield point.q, -1
        return
    low, high = point.ranges(layout)
    now, written = q_0[layout.rail], np.insert(point.also, layout.sought, point.written)[: layout.r]
    wanted = [written, now, (low + high) / 2, low, high] if moves else [now]
    rails = [*{one.tobytes(): one for one in (np.clip(rail, low, high) for rail in wanted)}.values()]
    if not moves and np.abs(rails[0] - now).max(initial=0.0) > _SAME:
        return
    for rail in rails:
        found = axes.robot.solutions(point.X_WF, layout.value(rail) if layout.has_rail else None, problem.plant.limits)
        options: list[State] = [(layout.merge(rail, arm), cfx) for cfx, arm in found
                                if point.conf is None or axes.robot.admits(point.conf, arm)]  # fmt: skip
        options.sort(key=lambda one: float(np.max(np.abs(one[0] - q_0) / axes.velocity)))
        for q, cfx in options:
            along = joint or cfx_0 in (-1, cfx)
            led = problem.leads(k - 1, q_0[None], q[None]) if k else None
            agreed = all(_agree(axes, [problem.waypoints[one], point], [own, q]) for one, own in tied)
            if along and agreed and (led is None or led.all()):
                yield q, cfx


def _agree(axes: Axes, points: list[Waypoint], q: list[Array]) -> bool:
    """Whether two waypoints at axes q (k,) have in common what tied ones must."""
    one, other = shared(axes, points, [own[None] for own in q], ((0, 1),))
    return bool(np.abs(one - other).max(initial=0.0) < 1e-6)


def _leg_motion(axes: Axes, problem: Problem, k: int, state: State, then: State) -> LegMotion | None:
    """Leg k from rest to rest within all limits; None where there is no such parabola, whatever its time."""
    leg, (q_0, cfx_0), (q_1, cfx_1) = problem.legs[k], state, then
    still = np.abs(q_1 - q_0).max() < _SAME and leg.segment is None
    least = 2 * float(np.max(np.abs(q_1 - q_0) / axes.velocity))
    T = leg.duration or max(least, leg.least, 0.02)
    alone = replace(problem, legs=(leg,), waypoints=problem.waypoints[k : k + 2])
    ends, rest = np.stack([q_0, q_1]), np.zeros((2, axes.n))
    motion: LegMotion | None
    if leg.kind is LegKind.JOINT and not still:
        grid = np.linspace(0, 1, axes.settings.first_joint_grid + 1)
        q, v, _ = integrate(np.array([0.0, 1.0]), ends, rest, grid)
        motion = JointNodes(T, grid, q, v, np.diff(v, axis=0) * axes.settings.first_joint_grid)
    else:
        times = np.array([0.0 if still else T])
        motion = first_iterate(axes, alone, ends, rest, (cfx_0, cfx_1), times).legs[0]
    if motion is None or motion.T == 0.0:
        return motion
    for _ in range(_TIMES):
        ratios = check_leg(axes, leg, motion)
        if not ratios.position.max() <= 1.0:
            return None
        slower = ratios.times_slower()
        if slower <= 1.0:
            return motion
        if leg.duration is not None:
            return None
        motion = motion.slowed(slower * (1 + 1e-9))
    return None
