"""The joint motion of a results folder, whichever command made it: at any rate, and as FRI takes it.

Motions that are rows and nothing else, one every period, get no faster, no harder and never outside at another rate.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.exporters.joint import check_rate, resample
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.runs.folder import PLAN, TASK, kind_of, read_run
from trajopt_cli.runs.record import RunRecord
from trajopt_cli.runs.results import CHOSEN, read_results
from trajopt_cli.trajectory import Trajectory

_JOINTS = "joints.csv"
_WHOLE = 1e-9  # share of a period by which rows may miss their place
PERIOD = 1e-3  # s, of KUKA's fast robot interface (FRI)
_AXES = 7  # there
_OFF = 1e-9  # s


@dataclass(frozen=True, eq=False)
class Recorded:
    """A motion of all axes as a folder holds it: what it is, and when [s] it waits for what.

    period [s]: of a motion that is its rows and nothing else, as a controller is fed; None for one that is the cubic
    Hermite between its rows.
    """

    name: str
    trajectory: Trajectory
    holds: tuple[tuple[float, str], ...] = ()
    period: float | None = None

    def at(self, rate: float | None, rests: bool = True) -> tuple[Trajectory, str]:
        """The motion at rate [Hz], as recorded for None, and what a user should know of it. rests: False leaves two
        rows of a rest in a motion that is more than its rows. Raises InputError for a rate that cannot be."""
        if rate is None:
            return self.trajectory, ""
        return (resample(self.trajectory, rate, rests), "") if self.period is None else at_rate(self.trajectory, rate)


@of_kind(ErrorKind.RESULTS)
def recorded(folder: Path) -> Recorded:
    """The motion in a folder of `trajopt optimize` or `trajopt iiwa`.

    Raises InputError for a folder that is none, of another kind, without joints, or changed since it was written.
    """
    kind = kind_of(folder) if folder.exists() else PLAN
    if kind == PLAN:
        results = read_results(folder)
        trajectory = read_csv_text(results.texts[CHOSEN], str(folder / CHOSEN))[0]
        return Recorded(f"the {results.target.value} plan", trajectory, tuple(results.holds))
    if kind != TASK:
        raise InputError("holds no joint motion; give a folder of trajopt optimize or trajopt iiwa", file=str(folder))
    run = read_run(folder, RunRecord[Any])
    if _JOINTS not in run.contents:
        raise InputError(f"has no {_JOINTS}; make it with trajopt iiwa joints", file=str(folder))
    trajectory = read_csv_text(run.text(_JOINTS), str(folder / _JOINTS))[0]
    return Recorded("the arm's joints", trajectory, period=period_of(trajectory))


def period_of(trajectory: Trajectory) -> float:
    """The period [s] of rows that stand on a grid. Raises InputError where they do not."""
    t = trajectory.t
    h = trajectory.duration / (len(t) - 1)
    if np.abs(t - t[0] - np.arange(len(t)) * h).max() > 1e-6 * h:
        raise InputError("the joints' rows stand on no grid of one period; make them again with trajopt iiwa joints")
    return h


def at_rate(trajectory: Trajectory, rate: float) -> tuple[Trajectory, str]:
    """Rows at rate [Hz] and the exact end, and what to know of them.

    Every m-th row where the rate is an m-th of the rows' own. Else a curve of constant acceleration around every row,
    the second difference there (the quadratic B-spline with the rows as its control points): its speeds are means of
    the rows' steps and its positions of the rows, so that it keeps each limit that the rows keep. It passes a row at up
    to acceleration times period squared over 8, rests at both ends, and takes one period more.

    Raises InputError as resample.
    """
    check_rate(trajectory, rate)
    h, n = period_of(trajectory), len(trajectory.t)
    every = 1 / (rate * h)
    if round(every) >= 1 and abs(every - round(every)) <= _WHOLE * n:
        rows = np.unique(np.r_[np.arange(0, n, round(every)), n - 1])
        qd = None if trajectory.qd is None else trajectory.qd[rows]
        return Trajectory(trajectory.names, trajectory.t[rows], trajectory.q[rows], qd), ""
    duration = trajectory.duration + h
    t = np.arange(math.floor(duration * rate) + 1) / rate
    t = np.append(t[t <= duration - min(1e-5, 0.5 / rate)], duration)
    x = np.concatenate([trajectory.q[:1], trajectory.q, trajectory.q[-1:]])  # a row before and one behind, at rest
    u = t / h - 0.5
    i = np.clip(np.rint(u), 0, n - 1).astype(np.intp)
    w = (u - i)[:, None]
    before, here, after = x[i], x[i + 1], x[i + 2]
    q = before * (0.5 - w) ** 2 / 2 + here * (0.75 - w * w) + after * (0.5 + w) ** 2 / 2
    qd = (after * (0.5 + w) - before * (0.5 - w) - 2 * w * here) / h
    q[0], q[-1], qd[0], qd[-1] = x[0], x[-1], 0.0, 0.0
    off = float(np.abs(np.diff(x, n=2, axis=0)).max()) / 8
    note = f"between the rows: within their limits, {off:.1e} rad beside them at most, {1e3 * h:g} ms longer"
    return Trajectory(trajectory.names, trajectory.t[0] + t, q, qd), note


def fri_rows(motion: Recorded, between: bool = False) -> tuple[str, int, str]:
    """A text with a header and one line per millisecond, joints A1 to A7 [rad]; how many; what to know of them.

    between: rows of another period are resampled to 1 ms. Raises InputError for a motion that is no seven-axis arm's,
    and for another period where between is False.
    """
    trajectory = motion.trajectory
    if motion.period is None or len(trajectory.names) != _AXES:
        raise InputError("is no motion of an LBR iiwa; FRI is KUKA's, give a folder of trajopt iiwa")
    note = ""
    if abs(motion.period - PERIOD) > _OFF:
        if not between:
            raise InputError(
                f"its rows stand {1e3 * motion.period:g} ms apart, FRI's here 1 ms; give --resample, or make the folder"
                " with h: 1 ms"
            )
        trajectory, note = motion.at(1 / PERIOD)
    head = ",".join(f"A{i} [rad]" for i in range(1, _AXES + 1))
    lines = [",".join([f"{value:.17g}" for value in row]) for row in trajectory.q.tolist()]
    return "\n".join([head, *lines]) + "\n", len(lines), note
