"""The least time from stop to stop through corners, as the tool and the first joints allow.

Where the zone of a line or an arc begins or ends, the flange of every legal motion goes through one pose, forwards at
some speed (a gate). A state there is a pair of signs of shoulder and elbow and a range of that speed. From state to
state no motion is faster than the tool's parts between (parts_time), nor than any coordinate by itself, its ends free
in their ranges (bound_loops.raise_times), whose speed and acceleration have limits all the way:
- on one line or arc, the way gone by; its acceleration is a component of the tool's;
- else the tool's place along its chord, and across it in the plane in which its velocity turns: a component of a
  vector is no longer than the vector, whatever way the tool takes in zones and on joint moves;
- without a rail the first three joints, whose places and rates at a gate follow from pose, signs and speed.
The least sum over all routes of states is the bound.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trajopt_cli.bound.tcp_time_bound import Gate, TcpPart, parts_time, ramps_of, tool_parts
from trajopt_cli.geometry import Array
from trajopt_cli.native.loops import loops
from trajopt_cli.path.segment import POINT
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.robot.enclosure import Range
from trajopt_cli.trajectories.axes import Axes

_SPEEDS = 40  # ranges of speed at a gate. Measured by bench_bound.py: median gaps of 17.6 % with 16, 16.6 % with 40.
_TURNED = 0.25  # of the time of its chord: a corner in which the tool's velocity can turn within less has no gates.


@dataclass(frozen=True, eq=False)
class _States:
    """At a gate, by signs and ranges of speed: least time (s, n) to there, inf where no arm reaches; speed (s, n), as
    shares of the gate's. q, rate (3, s): joints, and their rates at the gate's speed; (0, 1) on a rail."""

    time: Array
    speed: Range
    q: Range
    rate: Range


def corner_time(axes: Axes, problem: Problem, first: int, last: int) -> float:
    """Least time [s] from the stop `first` to the next one, `last`, on any legal motion; 0 where no corner is tight."""
    gates, ways = _gates(problem, first, last)
    if len(gates) == 2:
        return 0.0
    states = _states(axes, problem, gates[0])
    for (a, b), parts in zip(pairwise(gates), ways, strict=True):
        if a.leg != b.leg or sum(part.length for part in parts) > POINT:  # else two zones meet in one gate
            checkpoint()
            before, states = states, _states(axes, problem, b)
            np.add(states.time, _passed(axes, problem, (a, b), parts, (before, states)), out=states.time)
    return float(states.time.min())


def _gates(problem: Problem, first: int, last: int) -> tuple[list[Gate], list[list[TcpPart]]]:
    """Gates in order, the stops first and last, at no speed; and the parts between them. A corner has none where the
    tool's velocity can turn in a small share of the time that the chord takes."""
    ends = [(first, first), (last, last - 1)]
    start, end = (Gate(k, leg, problem.waypoints[k].X_WF, np.zeros(6), np.zeros(3)) for k, leg in ends)
    gates, ways, chords = [start], [list[TcpPart]()], [0.0]  # the last: what each way's chords take [s]
    for part in [*tool_parts(problem, first, last), end]:
        if isinstance(part, TcpPart):
            ways[-1].append(part)
            chords[-1] += part.length / part.speed
            continue
        before = gates[-1]
        turned = float(np.linalg.norm(part.velocity - before.velocity)) / problem.legs[before.leg].a_tcp
        if part.k == before.k and turned < _TURNED * chords[-1]:
            gates.pop()
            behind, chord = ways.pop(), chords.pop()
            ways[-1] += behind
            chords[-1] += chord
        else:
            gates.append(part)
            ways.append([])
            chords.append(0.0)
    return gates, ways[:-1]


def _states(axes: Axes, problem: Problem, gate: Gate) -> _States:
    """The states at a gate, where no time has gone by."""
    n = _SPEEDS if np.any(gate.twist) else 1
    share = np.arange(n + 1) / n * np.any(gate.twist)
    if axes.layout.has_rail:
        return _States(np.zeros((1, n)), Range(share[None, :-1], share[None, 1:]), *[Range(*np.zeros((2, 0, 1)))] * 2)
    e = axes.robot.enclose(gate.X_WF, np.zeros(2), problem.plant.limits, gate.twist)
    assert e.way is not None
    q, rate = (Range(x.lo[..., 0], x.hi[..., 0]) for x in (e.q, e.way))
    most = axes.velocity[axes.layout.arm][:3, None] / np.maximum(np.maximum(rate.lo, -rate.hi), 1e-9)
    top = np.minimum(most.min(axis=0), 1.0)[:, None]  # where no joint is faster than it may be
    return _States(np.where(e.alive, 0.0, np.inf) + np.zeros(n), Range(top * share[:-1], top * share[1:]), q, rate)


def _passed(
    axes: Axes, problem: Problem, gates: tuple[Gate, Gate], parts: Sequence[TcpPart], states: tuple[_States, _States]
) -> Array:
    """Least times (s, n) to the second of two gates' states by way of the first's."""
    legs = problem.legs[gates[0].leg : gates[1].leg + 1]
    kept = all(leg.kind is not LegKind.JOINT for leg in legs)
    there, here = (np.asarray(np.isfinite(one.time).any(axis=1)) for one in states)
    at = np.nonzero(np.diag(there & here) if kept else there[:, None] & here)
    shape = len(at[0]), states[0].time.shape[1], states[1].time.shape[1]
    T = np.full(np.prod(shape), parts_time(parts, *ramps_of(legs), sum(not np.any(gate.twist) for gate in gates)))
    speeds = [Range(one.speed.lo[i], one.speed.hi[i]) for one, i in zip(states, at, strict=True)]

    def coordinate(way: Range, rates: Sequence[Range], V: float, A: float) -> Array:
        """How far (m,) it goes, its rates (m, 1) at the gates' speeds."""
        one, two = (rate * speed for rate, speed in zip(rates, speeds, strict=True))
        ends = way.lo[:, None, None], way.hi[:, None, None]
        v = [np.clip(x, -V, V) for x in (one.lo[:, :, None], one.hi[:, :, None], two.lo[:, None], two.hi[:, None])]
        low, high, *v = (np.broadcast_to(x, shape).ravel() for x in (*ends, *v))
        out = T.copy()
        loops("trajopt_cli.bound.bound_loops")["raise_times"](out, low, high, *v, float(V), float(A))
        return out

    for D, *v, A in _tool(gates, parts, legs):
        way, *rates = (Range(*np.full((2, len(at[0]), 1), x)) for x in (D, *v))
        T = coordinate(Range(way.lo[:, 0], way.hi[:, 0]), rates, max(part.speed for part in parts), A)
    arm = axes.layout.arm
    most = np.max([problem.plant.limits.most_acceleration * leg.acceleration for leg in legs], axis=0)[arm]
    turns = np.ptp([axes.lower[arm][0], axes.upper[arm][0]]) > 2 * np.pi + 1e-6  # joint_1 may come round
    for j in range(int(turns), len(states[0].q.lo)):
        q_0, q_1 = (Range(one.q.lo[j, i], one.q.hi[j, i]) for one, i in zip(states, at, strict=True))
        rates = [Range(one.rate.lo[j, i, None], one.rate.hi[j, i, None]) for one, i in zip(states, at, strict=True)]
        T = coordinate(q_1 - q_0, rates, axes.velocity[arm][j], most[j])
    out = np.full(states[1].time.shape, np.inf)
    np.minimum.at(out, at[1], (states[0].time[at[0]][:, :, None] + T.reshape(shape)).min(axis=1))
    return out


def _tool(gates: tuple[Gate, Gate], parts: Sequence[TcpPart], legs: Sequence[Leg]) -> Iterator[tuple[float, ...]]:
    """Coordinates of the tool: how far [m], speeds at the gates' own [m/s], and acceleration [m/s2]."""
    v_0, v_1 = (gate.velocity for gate in gates)
    if len(legs) == 1:
        yield sum(part.length for part in parts), *np.linalg.norm([v_0, v_1], axis=1), max(ramps_of(legs))
    elif all(np.array_equal(leg.X_FT, legs[0].X_FT) for leg in legs):
        chord = ((gates[1].X_WF - gates[0].X_WF) @ legs[0].X_FT)[:3, 3]
        along = chord / max(float(np.linalg.norm(chord)), POINT)
        across = (v_1 - v_0) - (v_1 - v_0) @ along * along
        for u in (along, across / max(float(np.linalg.norm(across)), POINT)):
            yield *(float(x @ u) for x in (chord, v_0, v_1)), max(leg.a_tcp for leg in legs)
