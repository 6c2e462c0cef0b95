"""Logs of a robot that does not exist: hidden limits, coordinated joint moves, servo lag, and a recorder's sins.

Shares nothing with trajopt_cli.measured: phases case by case instead of boxes, a filter that is stepped instead of a
closed form. Axes as in robots/irb140_rail.yaml: rail [m], six joints [rad].
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.signal import cont2discrete, lfilter

NAMES = ("rail", *(f"joint_{i}" for i in range(1, 7)))
TOP = np.array([1.0, *np.radians([200.0, 200, 260, 360, 360, 450])])
LOW = np.array([0.0, *np.radians([-160.0, -80, -200, -180, -105, -300])])
HIGH = np.array([2.0, *np.radians([160.0, 95, 40, 180, 105, 300])])
PERIODS = (0.004, 0.012, 0.024, 0.048, 0.1)
_STEP = 5e-4  # s of the simulation


@dataclass(frozen=True, eq=False)
class Robot:
    """Hidden limits (7,), SI; jerk None for a robot that jumps to its acceleration. lag: per axis numerator and
    denominator of its servo."""

    velocity: np.ndarray
    acceleration: np.ndarray
    jerk: np.ndarray | None
    lag: tuple[tuple[list[float], list[float]], ...]


@dataclass(frozen=True, eq=False)
class Move:
    """To q (7,), at rest; cap: most progress per second that was programmed (1 for the whole way in 1 s); wait [s]
    afterwards."""

    q: np.ndarray
    cap: float
    wait: float


@dataclass(frozen=True)
class Recorder:
    """period [s]; jitter [s] of the instants; stamped: whether the times written are those of the instants, to the ms,
    or the period's; quantum and noise in rad and m; dropped: share of rows that are missing."""

    period: float
    jitter: float
    stamped: bool
    quantum: float
    quantum_rail: float
    noise: float
    noise_rail: float
    dropped: float


def random_robot(rng: np.random.Generator, jerk: bool) -> Robot:
    velocity = TOP * rng.uniform(0.6, 1.3, 7)
    ramp = np.r_[rng.uniform(0.3, 0.6), rng.uniform(0.08, 0.25, 6)]
    acceleration = velocity / ramp
    lag = []
    for _ in range(7):
        delay = rng.uniform(0.010, 0.060)
        if rng.random() < 0.5:
            lag.append(([1.0], [delay, 1.0]))
        else:
            damping = rng.uniform(0.7, 1.0)
            omega = 2 * damping / delay
            lag.append(([omega**2], [1.0, 2 * damping * omega, omega**2]))
    return Robot(velocity, acceleration, acceleration / rng.uniform(0.02, 0.08, 7) if jerk else None, tuple(lag))


def random_recorder(rng: np.random.Generator, period: float) -> Recorder:
    return Recorder(
        period=period,
        jitter=rng.choice([0.0, 1e-4, 3e-4, 1e-3]),
        stamped=bool(rng.random() < 0.5),
        quantum=np.radians(rng.choice([0.001, 0.01])),
        quantum_rail=1e-4,
        noise=np.radians(rng.choice([0.0, 0.001, 0.005])),
        noise_rail=rng.choice([0.0, 2e-5]),
        dropped=rng.choice([0.0, 0.01, 0.05]),
    )


def identification_moves(rng: np.random.Generator, slow: Sequence[int] = ()) -> tuple[np.ndarray, list[Move]]:
    """A start and moves that drive every axis alone over several lengths, and all together. The axes in slow never
    get to their top speed: each of their moves is programmed slower, and always at another speed."""
    start = np.array([0.2, 0.0, 0.0, -0.5, 0.0, 0.6, 0.0])
    q, moves = start, []

    def go(to: np.ndarray, cap: float = np.inf) -> None:
        nonlocal q
        moves.append(Move(to, cap, rng.uniform(0.5, 1.0)))
        q = to

    for j in rng.permutation(7):
        for share in (0.9, 0.55, 0.75, 0.4):
            to = q.copy()
            middle, half = (LOW[j] + HIGH[j]) / 2, (HIGH[j] - LOW[j]) / 2
            way = share * rng.uniform(0.9, 1.0) * 2 * half
            to[j] = np.clip(q[j] - np.sign(q[j] - middle + 1e-9) * way, LOW[j], HIGH[j])
            cap = np.inf
            if j in slow:
                cap = rng.uniform(0.15, 0.45) * TOP[j] * 0.6 / abs(to[j] - q[j])
            go(to, cap)
    for _ in range(8):
        to = rng.uniform(LOW, HIGH)
        for j in slow:  # never fast in company either
            to[j] = q[j]
        go(to)
    return start, moves


def working_moves(rng: np.random.Generator, start: np.ndarray, driven: Sequence[int], count: int = 8) -> list[Move]:
    """Another program: joint moves of one to all of the axes that may be driven."""
    q, moves = start, []
    for _ in range(count):
        to = q.copy()
        axes = rng.choice(driven, size=rng.integers(1, len(driven) + 1), replace=False)
        to[axes] = rng.uniform(LOW, HIGH)[axes]
        moves.append(Move(to, np.inf, float(rng.choice([0.0, 0.3, 0.8]))))
        q = to
    return moves


def ramps(way: np.ndarray, cap: float, robot: Robot) -> tuple[list[float], list[float]]:
    """Seven (or three) phases of a coordinated move over way (7,): durations [s] and jerks (accelerations) of the
    progress from 0 to 1."""
    far = np.maximum(np.abs(way), 1e-12)
    v = min(float(np.min(robot.velocity / far)), cap)
    a = float(np.min(robot.acceleration / far))
    if robot.jerk is None:
        if v * v / a >= 1.0:
            v = np.sqrt(a)
        t_a = v / a
        return [t_a, 1.0 / v - t_a, t_a], [a, 0.0, -a]
    j = float(np.min(robot.jerk / far))

    def climb(top: float) -> tuple[float, float]:
        """Durations of a jerk phase and of the constant acceleration, from rest to a speed."""
        t_j = min(a / j, np.sqrt(top / j))
        return t_j, max(top / (j * t_j) - t_j, 0.0)

    def length(top: float) -> float:
        t_j, t_a = climb(top)
        return top * (2 * t_j + t_a)

    if length(v) > 1.0:
        low, high = 0.0, v
        for _ in range(200):
            v = (low + high) / 2
            low, high = (v, high) if length(v) < 1.0 else (low, v)
    t_j, t_a = climb(v)
    cruise = max((1.0 - length(v)) / v, 0.0)
    return [t_j, t_a, t_j, cruise, t_j, t_a, t_j], [j, 0.0, -j, 0.0, -j, 0.0, j]


def drive(robot: Robot, start: np.ndarray, moves: Sequence[Move]) -> tuple[np.ndarray, np.ndarray, list[float]]:
    """What the controller asks for: times (n,), positions (n, 7), and when each move begins and ends, in turn [s]."""
    pieces, marks, now, q = [], [], 0.3, start
    for move in moves:
        durations, highest = ramps(move.q - q, move.cap, robot)
        pieces.append((now, q, move.q - q, durations, highest))
        marks += [now, now + sum(durations)]
        now += sum(durations) + move.wait
        q = move.q
    t = np.arange(0.0, now + 0.7, _STEP)
    out = np.tile(start, (len(t), 1))
    for begin, q_0, way, durations, highest in pieces:
        rows = t >= begin
        out[rows] = q_0 + np.outer(_progress(t[rows] - begin, durations, highest, robot.jerk is not None), way)
    return t, out, marks


def _progress(t: np.ndarray, durations: list[float], highest: list[float], jerky: bool) -> np.ndarray:
    s, v, a, begin = 0.0, 0.0, 0.0, 0.0
    out = np.ones(len(t))
    for duration, value in zip(durations, highest, strict=True):
        j = value if jerky else 0.0
        a = a if jerky else value
        rows = (t >= begin) & (t < begin + duration)
        h = t[rows] - begin
        out[rows] = s + h * (v + h * (a / 2 + h * j / 6))
        s, v, a = (
            s + duration * (v + duration * (a / 2 + duration * j / 6)),
            v + duration * (a + duration * j / 2),
            a + duration * j,
        )
        begin += duration
    assert abs(s - 1) < 1e-6, s
    return out


def record(robot: Robot, t: np.ndarray, q: np.ndarray, recorder: Recorder, rng: np.random.Generator):
    """Times (m,) and positions (m, 7) as the recorder writes them."""
    lagged = np.empty_like(q)
    for i, (num, den) in enumerate(robot.lag):
        b, a, _ = cont2discrete((num, den), _STEP, method="foh")
        lagged[:, i] = q[0, i] + lfilter(np.atleast_1d(b.squeeze()), a, q[:, i] - q[0, i])
    n = int((t[-1] - 0.01) / recorder.period)
    grid = 0.005 + recorder.period * np.arange(n)
    instants = np.clip(grid + rng.uniform(-1, 1, n) * recorder.jitter, 0, t[-1])
    rows = CubicSpline(t, lagged)(instants)
    noise = np.r_[recorder.noise_rail, np.full(6, recorder.noise)]
    quantum = np.r_[recorder.quantum_rail, np.full(6, recorder.quantum)]
    rows = np.rint((rows + rng.normal(size=rows.shape) * noise) / quantum) * quantum
    stamps = np.round(instants, 3) if recorder.stamped else grid
    keep = rng.random(n) >= recorder.dropped
    keep[:2] = True
    keep &= np.r_[True, np.diff(stamps) > 0]
    return stamps[keep] + 1000.0, rows[keep]
