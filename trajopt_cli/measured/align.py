"""A log beside a plan: when each motion of the program began and ended in it.

The program's stops are looked for in the log in their order, nearest in joint space. Between two of them a motion
begins and ends where a small share of its way is behind it and before it, in log and plan alike, so that the servo's
delay cancels; the rest of the ramps is taken from the plan, slower or faster as the log is between. What lies between
the motions is waiting. Fly-bys are placed where the log passes nearest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Program, Wait, motion_name
from trajopt_cli.problem.plan import Plan, PlannedMotion
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM

_NEAR = {"m": 10 * MM, "rad": 2 * DEG}  # farther from the program's stop is not there
_SAME = 0.05  # of that: nearer is as good as there
_SLOWNESS = 0.01  # per s: of two ways through the log the shorter one
_GRID = 0.01  # s
_COARSEST = 0.05  # s
_WORK = 3e7  # stops times rows
_EDGE = 0.03  # of the way: where a motion is seen to begin and to end
_RESTS = 1e-6  # of the top speed


@dataclass(frozen=True)
class MeasuredMotion:
    """One motion or wait: predicted and measured [s]."""

    index: int
    wait: bool
    predicted: float
    measured: float


@dataclass(frozen=True)
class Alignment:
    """motions: those that the log holds; waits before the first move and behind the last are not. t_0, t_1 [s]: by the
    log's clock. farthest: from the program's stops, in words."""

    file: str
    motions: tuple[MeasuredMotion, ...]
    t_0: float
    t_1: float
    predicted: float
    farthest: str

    @property
    def cycle(self) -> float:
        """From the first move's begin to the last one's end [s]."""
        return self.t_1 - self.t_0

    @property
    def motion(self) -> float:
        """Waits apart [s]."""
        return sum(one.measured for one in self.motions if not one.wait)

    @property
    def waits(self) -> float:
        """Measured standing [s]."""
        return sum(one.measured for one in self.motions if one.wait)

    @property
    def said(self) -> str:
        """What was compared, one line."""
        moves = [one for one in self.motions if not one.wait]
        off = sum(one.predicted for one in moves) - self.motion
        return (
            f"compared with {self.file}, {self.t_0:.3f} to {self.t_1:.3f} s: "
            f"{len(moves)} motions take {self.motion:.3f} s, "
            f"predicted {off:+.3f} s ({100 * off / self.motion:+.1f} %); waits {self.waits:.3f} s; {self.farthest}"
        )


@dataclass(frozen=True)
class _Run:
    """Motions from one stop to the next."""

    motions: tuple[PlannedMotion, ...]

    @property
    def t(self) -> tuple[float, float]:
        return self.motions[0].t_0, self.motions[-1].t_1


def align(program: Program, plan: Plan, velocity: Array, log: Trajectory, file: str) -> Alignment:
    """The log's times of the plan's motions. velocity (k,): top speeds, which weigh the axes against each other.

    Raises InputError with the place in the program from which on the log does not follow it.
    """
    from scipy.interpolate import PchipInterpolator

    runs = _runs(program, plan, velocity)
    stops = [run.motions[0].q_0 for run in runs] + [runs[-1].motions[-1].q_1]
    near = np.array([_NEAR["m" if name == "rail" else "rad"] for name in log.names])
    step = max(_GRID, log.duration * len(stops) / _WORK)
    if step > _COARSEST:
        raise InputError(
            f"{log.duration:.0f} s are too long a log for {len(stops)} stops; cut out a few cycles", file=file
        )
    grid = np.arange(log.t[0], log.t[-1], step)
    at: Callable[[Array], Array] = PchipInterpolator(log.t, log.q)
    q = at(grid)
    rows = _in_order(stops, q, grid, near)
    off = np.array([np.max(np.abs(q[r] - stop) / near) for r, stop in zip(rows, stops, strict=True)])
    if np.any(off > 1):
        raise _departure(program, runs, stops, rows, q, grid, near, int(np.argmax(off > 1)), log.names, file)
    rests = [_rest(r, stop, q, near) for r, stop in zip(rows, stops, strict=True)]
    dense = plan.trajectory
    ends = [_ends(run, dense, grid, q, velocity, rests[i], rests[i + 1], at) for i, run in enumerate(runs)]
    for i in range(len(ends) - 1):
        if ends[i + 1][0] < ends[i][1] or not _waits_between(program, plan, runs[i], runs[i + 1]):
            middle = (ends[i][1] + ends[i + 1][0]) / 2  # the program does not wait there
            ends[i], ends[i + 1] = (ends[i][0], middle), (middle, ends[i + 1][1])
    out: list[MeasuredMotion] = []
    for i, run in enumerate(runs):
        marks = [ends[i][0], *_passes(run, ends[i], at, near), ends[i][1]]
        out += [
            MeasuredMotion(motion.index, False, motion.t_1 - motion.t_0, b - a)
            for motion, a, b in zip(run.motions, marks[:-1], marks[1:], strict=True)
        ]
        if i + 1 < len(runs):
            waits = _waits_between(program, plan, run, runs[i + 1])
            planned = sum(wait.t_1 - wait.t_0 for wait in waits)
            stood = ends[i + 1][0] - ends[i][1]
            for wait in waits:
                T = wait.t_1 - wait.t_0
                out.append(MeasuredMotion(wait.index, True, T, stood * (T / planned if planned else 1 / len(waits))))
    worst = int(np.argmax(off))
    k = int(np.argmax(np.abs(q[rows[worst]] - stops[worst]) / near))
    apart = _shown(log.names[k], float(q[rows[worst], k] - stops[worst][k]))
    return Alignment(
        file, tuple(out), ends[0][0], ends[-1][1], runs[-1].t[1] - runs[0].t[0],
        f"stops are met within {apart} ({log.names[k]})",
    )  # fmt: skip


def _shown(name: str, value: float) -> str:
    return f"{abs(value) / MM:.2f} mm" if name == "rail" else f"{abs(value) / DEG:.2f}°"


def _runs(program: Program, plan: Plan, velocity: Array) -> list[_Run]:
    rows = plan.trajectory
    assert rows.qd is not None
    out, now = [], []
    for motion in plan.motions:
        if motion.t_1 - motion.t_0 <= 0 or (
            np.allclose(motion.q_0, motion.q_1, atol=1e-9) and isinstance(program.motions[motion.index], Wait)
        ):
            continue
        now.append(motion)
        rates = np.array([np.interp(motion.t_1, rows.t, column) for column in rows.qd.T])
        if np.all(np.abs(rates) < _RESTS * velocity):
            out.append(_Run(tuple(now)))
            now = []
    if now:
        out.append(_Run(tuple(now)))
    return out


def _waits_between(program: Program, plan: Plan, one: _Run, other: _Run) -> list[PlannedMotion]:
    first, last = one.motions[-1].index, other.motions[0].index
    return [m for m in plan.motions if first < m.index < last and isinstance(program.motions[m.index], Wait)]


def _in_order(stops: Sequence[Array], q: Array, t: Array, near: Array) -> list[int]:
    """Rows of the log, none before the other, that are nearest to the stops in all."""
    back = np.empty((len(stops), len(t)), dtype=np.int32)
    rows = np.arange(len(t))
    f = np.zeros(len(t))
    for i, stop in enumerate(stops):
        far = np.max(np.abs(q - stop) / near, axis=1)
        cost = np.minimum(np.maximum(far - _SAME, 0.0), 50.0) ** 2
        if i:
            held = f - _SLOWNESS * t
            least = np.minimum.accumulate(held)
            back[i] = np.maximum.accumulate(np.where(held <= least, rows, 0))
            f = least + _SLOWNESS * t + cost
        else:
            f = cost
    out = [int(np.argmin(f))]
    for i in range(len(stops) - 1, 0, -1):
        out.append(int(back[i][out[-1]]))
    return out[::-1]


def _rest(row: int, stop: Array, q: Array, near: Array) -> int:
    """Where the log stands stillest around a row, as long as it is no farther from the stop."""
    far = np.max(np.abs(q - stop) / near, axis=1)
    limit = far[row] + _SAME
    first, last = row, row
    while first > 0 and far[first - 1] <= limit:
        first -= 1
    while last + 1 < len(q) and far[last + 1] <= limit:
        last += 1
    speed = np.max(np.abs(np.gradient(q[max(first - 1, 0) : last + 2], axis=0)) / near, axis=1)
    still = np.flatnonzero(speed <= speed.min() + 1e-3)
    return max(first - 1, 0) + int(still[len(still) // 2])


def _ends(
    run: _Run,
    dense: Trajectory,
    t: Array,
    q: Array,
    velocity: Array,
    first: int,
    last: int,
    at: Callable[[Array], Array],
) -> tuple[float, float]:
    """When a run begins and ends in the log."""
    t_0, t_1 = run.t
    times = np.linspace(t_0, t_1, 1 + max(int((t_1 - t_0) / 0.001), 50))
    planned = np.column_stack([np.interp(times, dense.t, column) for column in dense.q.T])
    length = float(np.max(np.abs(planned - planned[0]) / velocity))
    edge = _EDGE * length
    leaves, arrives = _edges(times, planned, planned[0], planned[-1], velocity, edge)
    fine = np.linspace(t[first], t[max(last, first + 1)], 1 + max(int((t[last] - t[first]) / 0.002), 50))
    measured = at(fine)
    seen = _edges(fine, measured, q[first], q[last], velocity, edge)
    slower = (seen[1] - seen[0]) / (arrives - leaves)  # the ends are as much slower as what lies between
    return seen[0] - slower * (leaves - t_0), seen[1] + slower * (t_1 - arrives)


def _edges(t: Array, q: Array, q_0: Array, q_1: Array, velocity: Array, edge: float) -> tuple[float, float]:
    """When the first part of the way is behind, and when the last part is left."""
    gone = np.max(np.abs(q - q_0) / velocity, axis=1)
    left = np.max(np.abs(q - q_1) / velocity, axis=1)
    return _crossing(t, gone, edge, True), _crossing(t, left, edge, False)


def _crossing(t: Array, far: Array, level: float, first: bool) -> float:
    """When a distance first, or last, passes a level."""
    beyond = np.flatnonzero(far > level)
    if not len(beyond):
        return float(t[0] if first else t[-1])
    i = max(int(beyond[0]) - 1, 0) if first else min(int(beyond[-1]), len(t) - 2)
    step = far[i + 1] - far[i]
    return float(t[i] + (t[i + 1] - t[i]) * np.clip((level - far[i]) / step, 0, 1)) if step else float(t[i])


def _passes(run: _Run, ends: tuple[float, float], at: Callable[[Array], Array], near: Array) -> list[float]:
    """When the log passes each fly-by inside a run."""
    out: list[float] = []
    (t_0, t_1), before = run.t, ends[0]
    for motion in run.motions[:-1]:
        share = (motion.t_1 - t_0) / (t_1 - t_0)
        around = ends[0] + np.clip(np.array([share - 0.3, share + 0.3]), 0, 1) * (ends[1] - ends[0])
        times = np.linspace(max(around[0], before), max(around[1], before), 600)
        before = float(times[int(np.argmin(np.linalg.norm((at(times) - motion.q_1) / near, axis=1)))])
        out.append(before)
    return out


def _departure(
    program: Program, runs: Sequence[_Run], stops: Sequence[Array], rows: Sequence[int], q: Array, t: Array,
    near: Array, i: int, names: Sequence[str], file: str,
) -> InputError:  # fmt: skip
    """The message where stop i is not met."""
    motion = runs[max(i - 1, 0)].motions[-1]
    row = rows[i]
    if i:  # the nearest that the log comes behind the stop before
        behind = np.max(np.abs(q[rows[i - 1] :] - stops[i]) / near, axis=1)
        row = rows[i - 1] + int(np.argmin(behind))
    k = int(np.argmax(np.abs(q[row] - stops[i]) / near))
    where = f"{motion_name(program.motions[motion.index])} ({motion.source})"
    apart = _shown(names[k], float(q[row, k] - stops[i][k]))
    if not i:
        text = f"the log never is where the program starts: {names[k]} stays {apart} away from it"
    else:
        text = (
            f"the log departs from the program at {where}: {names[k]} stays {apart} away from its end, "
            f"nearest at {t[row]:.3f} s"
        )
    text += "; is it a log of this program, from its start on, with each axis in its own column?"
    return InputError(text, file=file, kind=ErrorKind.RESULTS)
