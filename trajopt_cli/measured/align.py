"""A log beside a plan: when each motion of the program began and ended in it.

The program's stops are looked for in the log in their order, nearest in joint space. Between two of them a motion
begins and ends where a small share of its way is behind it and before it, in log and plan alike, so that the servo's
delay cancels; the rest of the ramps is taken from the plan, slower or faster as the log is between. What lies between
the motions is waiting. Fly-bys are placed where the log passes nearest. A log may hold the program several times, and
begin and end anywhere in it: every pass is looked for, and of a motion that several hold the median is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import takewhile

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.geometry import Array
from trajopt_cli.measured.log_csv import lost_rows
from trajopt_cli.motion import Motion, Move, Program, Wait, motion_name
from trajopt_cli.problem.plan import Plan, PlannedMotion
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM, slides

_NEAR = {"m": 10 * MM, "rad": 2 * DEG}  # farther from the program's stop is not there
_SAME = 0.05  # of that: nearer is as good as there
_SKIP = 1.0  # what a stop costs that a log leaves out where it begins or ends; one that is just near costs 0.9
_LOOSE = 3.0  # times as near: a stop that is programmed as a fly-by, the way between two stops that are one
_SLOWNESS = 0.01  # per s: of two ways through the log the shorter one
_GRID = 0.01  # s
_COARSEST = 0.05  # s
_WORK = 3e7  # stops times rows
_STANDS = 6000  # rows looked at around a stop for where the log stands still
_EDGE = 0.03  # of the way: where a motion is seen to begin and to end
_LONG = 0.05  # s: of motions that are held against each other
_ALIKE, _OTHER = 0.1, 0.1  # of what they are slower by: how far they may differ, and what is told
_RESTS = 1e-6  # of the top speed


@dataclass(frozen=True)
class MeasuredMotion:
    """One motion or wait: predicted and measured [s]."""

    index: int
    wait: bool
    predicted: float
    measured: float


@dataclass(frozen=True)
class Pass:
    """One pass of the program: its motions, from t_0 to t_1 [s] by the log's clock. whole: from the first to the last.
    off: how far its stops are from the program's, by axis [rad, m]."""

    motions: tuple[MeasuredMotion, ...]
    t_0: float
    t_1: float
    whole: bool
    off: Array


@dataclass(frozen=True)
class Alignment:
    """passes: in the log's order; those that count are the whole ones where there are any. moves: of the program.
    farthest: from the program's stops, in words."""

    file: str
    passes: tuple[Pass, ...]
    moves: int
    farthest: str

    @property
    def counted(self) -> tuple[Pass, ...]:
        """The passes that count."""
        return tuple(one for one in self.passes if one.whole) or self.passes

    @cached_property
    def motions(self) -> tuple[MeasuredMotion, ...]:
        """Those that the log holds, each with its median; waits before the first move and behind the last are not."""
        found: dict[int, list[MeasuredMotion]] = {}
        for one in (motion for held in self.counted for motion in held.motions):
            found.setdefault(one.index, []).append(one)
        return tuple(
            replace(some[0], measured=float(np.median([one.measured for one in some])))
            for _, some in sorted(found.items())
        )

    @property
    def whole(self) -> bool:
        """Whether the log holds a pass from the first move to the last."""
        return any(one.whole for one in self.passes)

    @property
    def cycle(self) -> float:
        """From the first move's begin to the last one's end [s], median; of parts, what they hold together."""
        return float(np.median([one.t_1 - one.t_0 for one in self.counted])) if self.whole else self.motion + self.waits

    @property
    def period(self) -> float | None:
        """From one whole pass to the next [s], median; None where there is one."""
        begins = [one.t_0 for one in self.passes if one.whole]
        return float(np.median(np.diff(begins))) if len(begins) > 1 else None

    @property
    def predicted(self) -> float:
        """Of the motions that the log holds, waits between them included [s]."""
        return sum(one.predicted for one in self.motions)

    @property
    def motion(self) -> float:
        """Waits apart [s]."""
        return sum(one.measured for one in self.motions if not one.wait)

    @property
    def predicted_motion(self) -> float:
        """The same as predicted [s]."""
        return sum(one.predicted for one in self.motions if not one.wait)

    @property
    def waits(self) -> float:
        """Measured standing [s]."""
        return sum(one.measured for one in self.motions if one.wait)

    @property
    def doubt(self) -> str:
        """That the motions are all slower, or all faster, by the same; empty where they are not."""
        times = [one.measured / one.predicted for one in self.motions if not one.wait and one.predicted > _LONG]
        low, middle, high = np.quantile(times, [0.1, 0.5, 0.9]) if times else (1.0, 1.0, 1.0)
        if high - low > _ALIKE * middle or abs(middle - 1) < _OTHER:
            return ""
        what = f"motions take {middle:.2f} times as long as predicted, all alike"
        return f"{self.file}: {what}: another speed, override or AccSet?"

    @property
    def said(self) -> str:
        """What was compared, one line."""
        moves, off = len([one for one in self.motions if not one.wait]), self.motion - self.predicted_motion
        held = f"{moves} motions" if moves == self.moves else f"{moves} of {self.moves} motions"
        times = [one.t_1 - one.t_0 for one in self.counted]
        many = f"{len(times)} {'passes' if self.whole else 'parts'} of {min(times):.3f} to {max(times):.3f} s, "
        many = (many if len(times) > 1 else "") + (f"one every {self.period:.3f} s, medians: " if self.period else "")
        return (
            f"compared with {self.file}, {self.counted[0].t_0:.3f} to {self.counted[-1].t_1:.3f} s: "
            f"{many}{held} take {self.motion:.3f} s, measured - predicted {off:+.3f} s "
            f"({100 * off / self.motion:+.1f} %); standing {self.waits:.3f} s; {self.farthest}"
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
    near = np.array([_NEAR["m" if slides(name) else "rad"] for name in log.names])
    step = max(_GRID, log.duration * len(runs) / _WORK)
    if step > _COARSEST:
        raise InputError(
            f"{log.duration:.0f} s are too long a log for {len(runs)} stops; cut out a few cycles", file=file
        )
    grid = np.arange(log.t[0], log.t[-1], step)
    at: Callable[[Array], Array] = PchipInterpolator(log.t, log.q)
    found = _Search(program, plan, velocity, runs, near, grid, at(grid), at)
    passes = found.passes(0, len(grid))
    if not passes:
        raise found.departure(log.names, file, lost_rows(log.t))
    off = np.max([one.off for one in passes], axis=0)
    k = int(np.argmax(off / near))
    moves = sum(len(run.motions) for run in runs)
    farthest = f"stops are met within {_shown(log.names[k], off[k])} ({log.names[k]})"
    return Alignment(file, tuple(passes), moves, farthest)


@dataclass(frozen=True)
class _Search:
    """Looks for passes of runs in a log of rows q at times t, evenly apart; at: the log between them."""

    program: Program
    plan: Plan
    velocity: Array
    runs: Sequence[_Run]
    near: Array
    t: Array
    q: Array
    at: Callable[[Array], Array]

    @cached_property
    def stops(self) -> list[Array]:
        """Where runs begin, and where the last one ends."""
        return [run.motions[0].q_0 for run in self.runs] + [self.runs[-1].motions[-1].q_1]

    @cached_property
    def marks(self) -> list[tuple[Array, int, float]]:
        """What a pass meets in turn: the posture, which stop that is, and how many times as near it has to be met.
        Between two stops that are one also the farthest of the way, as stop -1; at what is programmed as a fly-by the
        robot need not stop."""
        ends = [self.program.motions[run.motions[-1].index] for run in self.runs]
        times = [1.0, *(1.0 if not isinstance(one, Move) or one.zone.stop else _LOOSE for one in ends)]
        out: list[tuple[Array, int, float]] = []
        dense = self.plan.trajectory
        for i, stop in enumerate(self.stops):
            same = np.all(np.abs(self.stops[-1] - stop) < self.near)
            out.append((stop, i, times[-1] if i == 0 and same else times[i]))
            if i < len(self.runs) and np.all(np.abs(self.stops[i + 1] - stop) < 2 * self.near):
                way = dense.q[slice(*np.searchsorted(dense.t, self.runs[i].t))]
                far = np.max(np.abs(way - stop) / self.near, axis=1)
                out.append((way[int(np.argmax(far))], -1, _LOOSE))
        return out

    def passes(self, a: int, b: int) -> list[Pass]:
        """Those in the rows from a to b, in order."""
        for skip in (np.inf, _SKIP):
            first, rows = _in_order([mark for mark, *_ in self.marks], self.q[a:b], self.t[a:b], self.near, skip)
            here = self.marks[first : first + len(rows)]
            met = all(
                np.all(np.abs(self.q[a + row] - mark) <= times * self.near)
                for row, (mark, _, times) in zip(rows, here, strict=True)
            )
            held = {i: a + row for row, (_, i, _) in zip(rows, here, strict=True) if i >= 0}
            if met and rows[-1] > rows[0] and len(held) > 1 and self._there(held, a, b):
                begin, *_, end = held.values()
                return [*self.passes(a, begin + 1), self._measured(held), *self.passes(end, b)]
        return []

    def _there(self, held: Mapping[int, int], a: int, b: int) -> bool:
        """Whether stops that a pass leaves out cannot be in the rows from a to b, since the log begins or ends there;
        the first of all is the cell file's, and may be left out anywhere."""
        first, *_, last = held
        begins = first <= 1 or (a == 0 and self.t[held[first]] - self.t[0] < self._longest(first - 1))
        away = np.any(np.abs(self.q[held[last] : b] - self.stops[last]) > self.near, axis=1)
        left = self.t[held[last] + int(np.argmax(away))] if away.any() else self.t[-1]
        return begins and (last == len(self.runs) or (b == len(self.t) and self.t[-1] - left < self._longest(last)))

    def _longest(self, i: int) -> float:
        """What run i takes at most [s], with the programmed speed turned down to half."""
        return 2 * (self.runs[i].t[1] - self.runs[i].t[0]) + 1.0

    def _measured(self, held: Mapping[int, int]) -> Pass:
        first, *_, last = held
        runs, rows = self.runs[first:last], list(held.values())
        program, plan = self.program, self.plan
        rests = [_rest(row, self.stops[first + i], self.q, self.near) for i, row in enumerate(rows)]
        ends = [self._ends(run, rests[i], rests[i + 1]) for i, run in enumerate(runs)]
        for i in range(len(ends) - 1):
            if ends[i + 1][0] < ends[i][1] or not _waits_between(program, plan, runs[i], runs[i + 1]):
                middle = (ends[i][1] + ends[i + 1][0]) / 2  # the program does not wait there
                ends[i], ends[i + 1] = (ends[i][0], middle), (middle, ends[i + 1][1])
        out: list[MeasuredMotion] = []
        for i, run in enumerate(runs):
            marks = [ends[i][0], *self._fly_bys(run, *ends[i]), ends[i][1]]
            out += [
                MeasuredMotion(motion.index, False, motion.t_1 - motion.t_0, b - a)
                for motion, a, b in zip(run.motions, marks[:-1], marks[1:], strict=True)
            ]
            if i + 1 < len(runs):
                waits = _waits_between(program, plan, run, runs[i + 1])
                settling = {one.index for one in waits if settles(program.motions, one.index)}
                sure = settling and timed(program.motions, max(settling))  # what is more than programmed is theirs
                given = sum(wait.t_1 - wait.t_0 for wait in waits if sure and wait.index not in settling)
                planned = sum(wait.t_1 - wait.t_0 for wait in waits) - given
                stood = ends[i + 1][0] - ends[i][1] - given
                for wait in waits:
                    T = wait.t_1 - wait.t_0
                    share = T / planned if planned else 1 / len(waits)
                    measured = T if sure and wait.index not in settling else stood * share
                    out.append(MeasuredMotion(wait.index, True, T, measured))
        off = np.max([np.abs(self.q[row] - self.stops[first + i]) for i, row in enumerate(rests)], axis=0)
        return Pass(tuple(out), ends[0][0], ends[-1][1], len(runs) == len(self.runs), off)

    def _ends(self, run: _Run, first: int, last: int) -> tuple[float, float]:
        """When a run begins and ends in the log."""
        (t_0, t_1), t, dense = run.t, self.t, self.plan.trajectory
        times = np.linspace(t_0, t_1, 1 + max(int((t_1 - t_0) / 0.001), 50))
        planned = np.column_stack([np.interp(times, dense.t, column) for column in dense.q.T]) / self.velocity
        edge = _EDGE * float(np.max(np.abs(planned - planned[0])))
        leaves, arrives = _edges(times, planned, edge)
        fine = np.linspace(t[first], t[max(last, first + 1)], 1 + max(int((t[last] - t[first]) / 0.002), 50))
        seen = _edges(fine, np.vstack([self.q[first], self.at(fine[1:-1]), self.q[last]]) / self.velocity, edge)
        slower = (seen[1] - seen[0]) / (arrives - leaves)  # the ends are as much slower as what lies between
        return seen[0] - slower * (leaves - t_0), seen[1] + slower * (t_1 - arrives)

    def _fly_bys(self, run: _Run, begin: float, end: float) -> list[float]:
        """When the log passes each fly-by inside a run."""
        out: list[float] = []
        (t_0, t_1), before = run.t, begin
        for motion in run.motions[:-1]:
            share = (motion.t_1 - t_0) / (t_1 - t_0)
            around = begin + np.clip(np.array([share - 0.3, share + 0.3]), 0, 1) * (end - begin)
            times = np.linspace(max(around[0], before), max(around[1], before), 600)
            before = float(times[int(np.argmin(np.linalg.norm((self.at(times) - motion.q_1) / self.near, axis=1)))])
            out.append(before)
        return out

    def departure(self, names: Sequence[str], file: str, lost: str) -> InputError:
        """The message where the first stop is not met. lost: where the log lost rows, in which it may have been."""
        q, t, stops = self.q / self.near, self.t, [stop / self.near for stop in self.stops]
        _, rows = _in_order(self.stops, self.q, t, self.near)
        missed = [i for i, row in enumerate(rows) if np.any(np.abs(q[row] - stops[i]) > 1)]
        i = missed[0] if missed else 0
        row = rows[i]
        if i:  # the nearest that the log comes behind the stop before
            row = rows[i - 1] + int(np.argmin(np.max(np.abs(q[rows[i - 1] :] - stops[i]), axis=1)))
        k = int(np.argmax(np.abs(q[row] - stops[i])))
        apart = f"{names[k]} stays {_shown(names[k], float(self.q[row, k] - self.stops[i][k]))} away from"
        motion = self.runs[max(i - 1, 0)].motions[-1]
        where = f"{motion_name(self.program.motions[motion.index])} ({motion.source})"
        text = f"the log departs from the program at {where}: {apart} its end, nearest at {t[row]:.3f} s"
        if not i:
            text = f"the log never is where the program starts: {apart} it"
        if not missed:
            text = f"the log holds no motion of the program from stop to stop, in {t[-1] - t[0]:.3f} s"
        text += "; is it a log of this program, with each axis in its own column?"
        text += f" {lost}" if lost and i else ""
        return InputError(text, file=file, kind=ErrorKind.RESULTS)


def settles(motions: Sequence[Motion], index: int) -> bool:
    """Whether a motion is the settling at a stop."""
    wait = motions[index]
    return isinstance(wait, Wait) and wait.settles


def timed(motions: Sequence[Motion], index: int) -> bool:
    """Whether all waits from a motion on to the next move have a programmed time."""
    waits = takewhile(lambda one: not isinstance(one, Move), motions[index:])
    return all(one.condition is None for one in waits if isinstance(one, Wait))


def _shown(name: str, value: float) -> str:
    return f"{abs(value) / MM:.2f} mm" if slides(name) else f"{abs(value) / DEG:.2f}°"


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


def _in_order(marks: Sequence[Array], q: Array, t: Array, near: Array, skip: float = np.inf) -> tuple[int, list[int]]:
    """Rows of the log, none before the other, that are nearest to the marks in all; from which mark on. skip: what it
    costs to leave one out at the begin or the end. Of passes that are as good, the middle one."""
    back = np.empty((len(marks), len(t)), dtype=np.int32)
    rows = np.arange(len(t))
    f = np.zeros(len(t))
    ends: list[Array] = []
    for i, mark in enumerate(marks):
        far = np.max(np.abs(q - mark) / near, axis=1)
        cost = np.minimum(np.maximum(far - _SAME, 0.0), 50.0) ** 2
        if i:
            held = f - _SLOWNESS * t
            least = np.minimum.accumulate(held)
            back[i] = np.maximum.accumulate(np.where(held <= least, rows, 0))
            f = least + _SLOWNESS * t
            back[i][f > skip * i] = -1  # it begins here
            f = np.minimum(f, skip * i) + cost
        else:
            f, back[i] = cost, -1
        ends.append(f)
    left = np.arange(len(marks))[::-1]
    i = int(np.argmin(np.array([one.min() for one in ends]) + np.where(left, skip * np.maximum(left, 1), 0.0)))
    good = np.flatnonzero(ends[i] <= ends[i].min() + _SLOWNESS)
    out = [int(good[np.argmin(np.abs(good - len(t) / 2))])]
    while back[i][out[-1]] >= 0:
        out.append(int(back[i][out[-1]]))
        i -= 1
    return i, out[::-1]


def _rest(row: int, stop: Array, q: Array, near: Array) -> int:
    """Where the log stands stillest around a row, as long as it is no farther from the stop."""
    begin = max(row - _STANDS, 0)
    far = np.max(np.abs(q[begin : row + _STANDS] - stop) / near, axis=1)
    away = np.r_[-1, np.flatnonzero(far > far[row - begin] + _SAME), len(far)]
    i = int(np.searchsorted(away, row - begin))
    first = max(begin + int(away[i - 1]), 0)
    speed = np.max(np.abs(np.gradient(q[first : begin + int(away[i]) + 1], axis=0)) / near, axis=1)
    still = np.flatnonzero(speed <= speed.min() + 1e-3)
    return first + int(still[len(still) // 2])


def _edges(t: Array, q: Array, edge: float) -> tuple[float, float]:
    """When the first part of the way is behind, and when the last part is left."""
    return _crossing(t, q, edge), -_crossing(-t[::-1], q[::-1], edge)


def _crossing(t: Array, q: Array, level: float) -> float:
    """When q is first so far from where it begins."""
    far = np.max(np.abs(q - q[0]), axis=1)
    i = max(int(np.argmax(far > level)) - 1, 0)
    step = far[i + 1] - far[i]
    return float(t[i] + (t[i + 1] - t[i]) * np.clip((level - far[i]) / step, 0, 1)) if step else float(t[i])


@dataclass(frozen=True)
class SeenSettling:
    """kind: "fine" or "inpos", see scenario.Settling; seconds: the mean of so many stops; predicted: in force [s]."""

    kind: str
    seconds: float
    predicted: float
    stops: int


def settling_seen(motions: Sequence[Motion], logs: Sequence[Alignment]) -> list[SeenSettling]:
    """By kind; stops before a wait for a signal, whose length is not known, tell nothing. motions: of the program."""
    found: dict[str, list[tuple[float, float]]] = {"fine": [], "inpos": []}
    for one in (measured for log in logs for measured in log.motions):
        if settles(motions, one.index) and timed(motions, one.index):
            before = next(move for move in motions[one.index :: -1] if isinstance(move, Move))
            ordinary = before.zone.stop and before.zone.criterion is None
            found["fine" if ordinary else "inpos"].append((one.measured, one.predicted))
    return [
        SeenSettling(kind, max(sum(a for a, _ in some) / len(some), 0.0), some[0][1], len(some))
        for kind, some in found.items()
        if some
    ]
