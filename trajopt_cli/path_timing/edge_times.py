"""Least times of legs, each for itself, between axes at its ends: what rail positions are compared by.

By TOPP on a few nodes, many legs and many pairs of axes at once; of equal ones once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from hashlib import blake2b
from itertools import groupby

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.path.segment import along_all, over_work
from trajopt_cli.path_timing.path_derivatives import PathDerivatives
from trajopt_cli.path_timing.path_timing import but_torques, path_rows, samples_of, stacked
from trajopt_cli.path_timing.sampled_path import spaced
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.timing.double_integrator import mean_ramp, trapezoid_time
from trajopt_cli.timing.point_to_point import rest_time
from trajopt_cli.timing.topp import fastest_laws
from trajopt_cli.trajectories.axes import Axes

_SLACK = 1 + 0.0001  # times its least time that a wait must have, for limits are not used to the last hair.
_LATE = 1000.0  # times what a leg would pass its programmed time by, added to the route's.
_JERK_ROOM = 1.1  # times what a straight path takes at least that a wait must have.
_FLIPPED = 1.0  # rad, m by which axes in the middle of such a line may be elsewhere than at its ends.

_SAME = 1e-9  # m between rail positions that are one
_JUMP = 1e-4  # rad, m between axes that are not one place


@dataclass(frozen=True, eq=False)
class Pairs:
    """Axes q_0 and q_1 (m, n) at the ends of leg k, to be timed on branch cfx."""

    k: int
    q_0: Array
    q_1: Array
    cfx: int

    def only(self, these: IndexArray | BoolArray) -> Pairs:
        """Some of the pairs."""
        return replace(self, q_0=self.q_0[these], q_1=self.q_1[these])


def short(problem: Problem, k: int) -> bool:
    """Whether leg k is a short line or arc that is passed at both ends."""
    settings = problem.plant.settings
    leg = problem.legs[k]
    small = leg.chord < settings.long_line and leg.angle < settings.long_turn
    return leg.kind is LegKind.LINE and small and problem.passes(k) and problem.passes(k + 1)


def _nodes(problem: Problem, k: int) -> Array:
    """Path parameters (m,) at which leg k is sampled to be timed: of a short one middles of even parts."""
    settings = problem.plant.settings
    if not short(problem, k):
        return spaced(settings.pair_nodes, settings.end_spacing)
    fraction = max(problem.legs[k].chord / settings.long_line, problem.legs[k].angle / settings.long_turn)
    N = max(1, int(np.ceil(settings.short_nodes * fraction)))
    return (np.arange(N) + 0.5) / N


@dataclass(frozen=True, eq=False)
class Times:
    """What was found before, on one set of axes: least times (m,) by TOPP, by what was asked; names of legs."""

    found: dict[bytes, Array] = field(default_factory=dict)
    names: dict[Leg, bytes] = field(default_factory=dict)

    def name(self, problem: Problem, pairs: Pairs) -> bytes:
        """Equal for pairs of axes that are timed alike, whatever the legs around them and the coupling."""
        leg = problem.legs[pairs.k]
        if leg not in self.names:
            self.names[leg] = leg_name_at(problem, pairs.k)
        ends = problem.passes(pairs.k), problem.passes(pairs.k + 1), pairs.cfx
        parts = [self.names[leg], repr(ends).encode(), pairs.q_0.tobytes(), pairs.q_1.tobytes()]
        return blake2b(b"|".join(parts), digest_size=16).digest()


def leg_times(axes: Axes, problem: Problem, pairs: Sequence[Pairs], known: Times) -> list[Array]:
    """Least times (m,) of legs between axes, by TOPP on a few nodes; of equal ones once. known: what was found before,
    for this problem or one of the same legs; what is found here is added."""
    names = [known.name(problem, one) for one in pairs]
    asked = {name: one for name, one in zip(names, pairs, strict=True) if name not in known.found}
    moves = [one.only(~_resting(problem, one)) for one in asked.values()]
    known.found.update(zip(asked, _topp_times(axes, problem, moves), strict=True))
    distinct = {name: one for name, one in zip(reversed(names), reversed(pairs), strict=True)}
    times = {name: _as_asked(axes, problem, one, known.found[name]) for name, one in distinct.items()}
    return [times[name] for name in names]


def leg_name_at(problem: Problem, k: int) -> bytes:
    """Of a leg; of a wait with its pose."""
    X_WF = problem.waypoints[k].X_WF if problem.legs[k].kind is LegKind.DWELL else np.zeros(0)
    return problem.legs[k].key + X_WF.tobytes()


def _as_asked(axes: Axes, problem: Problem, pairs: Pairs, T: Array) -> Array:
    """Times (m,) of a leg between pairs of axes, from those T by TOPP of all that move."""
    leg, rest = problem.legs[pairs.k], _resting(problem, pairs)
    if axes.jerk is not None:
        T = np.maximum(T, _straight_times(axes, leg, pairs.q_0[~rest], pairs.q_1[~rest]))
    if leg.kind is LegKind.JOINT and not (
        problem.coordinated or problem.passes(pairs.k) or problem.passes(pairs.k + 1)
    ):
        T = np.minimum(T, _own_times(axes, leg, pairs.q_0, pairs.q_1))
    times = np.zeros(len(rest))
    times[~rest] = T
    return as_programmed(leg, times)


def as_programmed(leg: Leg, T: Array | float) -> Array:
    """Times (...) of a leg that takes T at least: its programmed one, and so much more where that is too short that
    what is late by less is better: no answer, but it can be compared."""
    if leg.duration is not None:
        T = leg.duration + _LATE * np.maximum(T * _SLACK - leg.duration, 0.0)
    return np.asarray(np.maximum(T, leg.least))


def _resting(problem: Problem, pairs: Pairs) -> BoolArray:
    """In which pairs (m,) of a wait nothing moves."""
    if problem.legs[pairs.k].kind is not LegKind.DWELL:
        return np.zeros(len(pairs.q_0), dtype=bool)
    return np.asarray(np.abs(pairs.q_1 - pairs.q_0).max(axis=1) < _SAME)


def _straight_times(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> Array:
    """What straight joint moves (m,) take under jerk limits; of other paths about what they take at least."""
    assert axes.jerk is not None
    span = np.maximum(np.abs(q_1 - q_0), 1e-12)
    limits = axes.velocity_on(leg), axes.acceleration_on(leg), axes.jerk
    T = rest_time(np.ones(len(span)), *(np.min(limit / span, axis=1) for limit in limits))
    return np.asarray(T * (_JERK_ROOM if leg.duration is not None else 1.0))


def least_time(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> float:
    """What a joint move between axes q_0 and q_1 (n,) takes at least from rest to rest, however its axes move."""
    return max(float(_own_times(axes, leg, q_0[None], q_1[None])[0]), leg.duration or 0.0)


def _own_times(axes: Axes, leg: Leg, q_0: Array, q_1: Array) -> Array:
    """Least times (m,) of joint moves in which every axis has its own profile; the tool's caps enter by the chord."""
    T = np.max(trapezoid_time(np.abs(q_1 - q_0), axes.velocity_on(leg), axes.acceleration_on(leg)), axis=-1)
    tool_0, tool_1 = (axes.tool_points(q, leg.X_FT) for q in (q_0, q_1))
    chord = np.linalg.norm(tool_1 - tool_0, axis=1)
    return np.asarray(np.maximum(T, trapezoid_time(chord, leg.v_tcp, mean_ramp(*leg.ramps))))


def _topp_times(axes: Axes, problem: Problem, pairs: Sequence[Pairs]) -> list[Array]:
    """The same, of what moves; legs of one tool and kind at once, as many as the memory takes."""
    settings = axes.settings
    counts = np.array([len(one.q_0) for one in pairs], dtype=np.intp)
    out = [np.zeros(0)] * len(pairs)
    alike: dict[tuple[bytes, bool, int], list[int]] = {}
    for i in np.flatnonzero(counts).tolist():
        leg = problem.legs[pairs[i].k]
        key = leg.X_FT.tobytes(), leg.kind is LegKind.JOINT, len(_nodes(problem, pairs[i].k))
        alike.setdefault(key, []).append(i)
    for numbers in alike.values():
        behind = np.cumsum(counts[numbers])
        for _, group in groupby(range(len(numbers)), key=lambda i: int(behind[i]) // (3 * settings.batch // 16)):
            checkpoint()
            some = [numbers[i] for i in group]
            T = _timed_together(axes, problem, [pairs[i] for i in some])
            for i, times in zip(some, np.split(T, np.cumsum(counts[some])[:-1]), strict=True):
                out[i] = times
    return out


def _timed_together(axes: Axes, problem: Problem, pairs: Sequence[Pairs]) -> Array:
    """Least times of all pairs of legs of one tool and kind, one leg after the other."""
    counts = [len(one.q_0) for one in pairs]
    leg, B = problem.legs[pairs[0].k], sum(counts)
    s = _nodes(problem, pairs[0].k)
    along, ok = (_straight if leg.kind is LegKind.JOINT else _on_paths)(axes, problem, pairs, s)
    number = np.repeat(np.arange(len(pairs)), np.array(counts) * len(s))
    samples = samples_of(axes, [problem.legs[one.k] for one in pairs], number, along)
    found = stacked(path_rows(but_torques(axes), samples))
    top = found.rate.reshape(B, -1)
    slopes, bends, rests = (x.reshape(B, len(s), -1) for x in (found.slopes, found.bends, found.rests))
    ok = np.asarray(ok & np.isfinite(slopes).all(axis=(1, 2)) & np.isfinite(bends).all(axis=(1, 2)))
    T = np.full(B, np.inf)
    if short(problem, pairs[0].k):  # changes of speed on it are not counted
        steady = np.sqrt(np.abs(bends[ok]).max(axis=2))
        T[ok] = np.maximum(1 / top[ok], steady).mean(axis=1)
    elif ok.any():
        rates = [
            np.repeat([np.inf if problem.passes(one.k + end) else 0.0 for one in pairs], counts)[ok] for end in (0, 1)
        ]
        kept = slice(None) if ok.all() else ok
        rows = tuple(x[kept] for x in ((slopes, bends, rests) if rests.any() else (slopes, bends)))
        begins, ends = tuple(x[:, :-1] for x in rows), tuple(x[:, 1:] for x in rows)
        T[ok] = fastest_laws(s, top[ok], begins, ends, *rates).durations
    return T


def _straight(axes: Axes, problem: Problem, pairs: Sequence[Pairs], s: Array) -> tuple[PathDerivatives, BoolArray]:
    """Along joint moves, by s; all places of the first, then of the next. And which are in range: all."""
    q_0, q_1 = (np.concatenate(x) for x in ([one.q_0 for one in pairs], [one.q_1 for one in pairs]))
    B, m = len(q_0), len(s)
    span = q_1 - q_0
    q = (q_0[:, None] + s[:, None] * span[:, None]).reshape(B * m, -1)
    dq = np.repeat(span, m, axis=0)
    X_FT = problem.legs[pairs[0].k].X_FT
    ddq, still = np.zeros_like(q), np.zeros((len(q), 2))
    tool = axes.differential(q, X_FT).motion(dq, ddq)
    along = PathDerivatives(q, dq, ddq, tool[:, 0, :3], tool[:, 0, 3:], tool[:, 1, :3], still)
    return along, np.ones(B, dtype=bool)


def _on_paths(axes: Axes, problem: Problem, pairs: Sequence[Pairs], s: Array) -> tuple[PathDerivatives, BoolArray]:
    """The same along legs of the tool, the rail in proportion; and which stay in range and end where they should."""
    q_0, q_1 = (np.concatenate(x) for x in ([one.q_0 for one in pairs], [one.q_1 for one in pairs]))
    B, m, layout, X_FT = len(q_0), len(s), axes.layout, problem.legs[pairs[0].k].X_FT
    counts = [len(one.q_0) for one in pairs]
    rail_span = q_1[:, layout.rail] - q_0[:, layout.rail]
    d = (q_0[:, None, layout.rail] + s[:, None] * rail_span[:, None]).reshape(B * m, -1)
    kept = np.clip(s, 1e-9, 1 - 1e-9)
    segments = [problem.segment(one.k) for one in pairs]
    X, twist, bend = along_all(segments, [kept] * len(pairs))
    of = (np.repeat(np.arange(len(pairs)), counts)[:, None] * m + np.arange(m)).ravel()  # place on the leg's path
    cfx = np.repeat([one.cfx for one in pairs], np.array(counts) * m)
    arm = axes.branch((X @ inverse_pose(X_FT))[of], layout.value(d), cfx).reshape(B, m, -1)
    steps = np.diff(np.concatenate([q_0[:, None, layout.arm], arm], axis=1), axis=1)
    arm = arm - 2 * np.pi * np.cumsum(np.round(np.nan_to_num(steps) / (2 * np.pi)), axis=1)
    q = layout.merge(d, arm.reshape(B * m, -1))
    dd = np.repeat(rail_span, m, axis=0)
    dq, ddq = axes.differential(q, X_FT).follow(twist[of], bend[of], dd, np.zeros_like(dd))
    every = q.reshape(B, m, -1)
    with np.errstate(invalid="ignore"):
        ends = np.maximum(np.abs(every[:, 0] - q_0), np.abs(every[:, -1] - q_1)).max(axis=1)
        inside = axes.within(every).all(axis=1)
        ok = np.asarray(inside & (ends < (_JUMP if s[0] == 0 else _FLIPPED)))
    twist, bend = over_work(segments, [kept] * len(pairs), twist, bend)
    use = np.repeat([problem.legs[one.k].positioner_use for one in pairs], np.array(counts) * m, axis=0)
    return PathDerivatives(q, dq, ddq, twist[of, :3], twist[of, 3:], bend[of, :3], use), ok
