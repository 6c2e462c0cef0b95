"""From pieces of motion to the rows of a file: a row at every switch and every boundary, a millisecond grid between."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.study.case import Answer, Attempt, Case
from trajopt_cli.study.fixed_rail import FixedRail, StopToStop
from trajopt_cli.trajectory import Trajectory

T = TypeVar("T")

SAFE = 1 - 1e-4  # share of limits used: rows at 1 kHz are not quite the path between them
GRID = 1e-3  # s between rows
LEAST = 1e-5  # s; no grid row is nearer to a switch than this
SAME = 1e-9  # s; switches nearer than this are one
LONGER = 4e-6  # s that a motion is given more at a time until its switches stand apart


@dataclass(frozen=True, eq=False)
class Piece:
    """A motion of all axes from rest or speed to rest or speed. duration [s]. switches (m,): times where some axis
    changes its acceleration abruptly, both ends included, in order. at: q, qd (n, k) at times (n,) in it. rests:
    nothing moves in it."""

    duration: float
    switches: Array
    at: Callable[[Array], tuple[Array, Array]]
    rests: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "switches", readonly(self.switches))

    def slowed(self, factor: float) -> Piece:
        """The same motion in `factor` times the time."""

        def at(t: Array) -> tuple[Array, Array]:
            q, qd = self.at(np.clip(t / factor, 0.0, self.duration))
            return q, qd / factor

        return Piece(self.duration * factor, self.switches * factor, at, self.rests)


def hold(q: Array, duration: float) -> Piece:
    """All axes (k,) at rest for duration seconds."""
    switches = np.array([0.0, duration])
    return Piece(duration, switches, lambda t: (np.tile(q, (len(t), 1)), np.zeros((len(t), len(q)))), rests=True)


def apart(switches: Array) -> bool:
    """Whether no two switches are neighbours too near to be rows of one file without being one and the same."""
    gaps = np.diff(switches)
    return not np.any((gaps > SAME) & (gaps < LEAST))


def attempt_of(case: Case, given: FixedRail, pieces: Sequence[Piece | Infeasible], notes: Sequence[str]) -> Answer:
    """The row made of a piece for each run, slowed where it is over before the run's least time; or the first no."""
    made = list[Piece]()
    for run, piece in zip(given.runs, pieces, strict=True):
        if isinstance(piece, Infeasible):
            return piece
        made.append(piece.slowed(run.least / piece.duration) if 0 < piece.duration < run.least else piece)
    end = given.runs[-1].legs[-1].q_1 if given.runs else case.plant.start
    trajectory = rows_of(case.plant.robot.axis_names, made or [hold(end, 1e-3)], end)
    return Attempt(given.program, trajectory, notes=(*notes, *given.notes))


def each_once(runs: Sequence[StopToStop], make: Callable[[StopToStop], T]) -> list[T]:
    """What is made of each run; of those that ask for the same motion once."""
    known: dict[bytes, T] = {}
    for run in runs:
        if run.key not in known:
            known[run.key] = make(run)
    return [known[run.key] for run in runs]


def rows_of(names: tuple[str, ...], pieces: Sequence[Piece], end: Array) -> Trajectory:
    """The trajectory of all pieces in order, from time 0. end (k,): axes at the end, at rest, written as they are."""
    bounds = np.concatenate([[0.0], np.cumsum([piece.duration for piece in pieces])])
    times, q, qd = [], [], []
    for piece, start, stop in zip(pieces, bounds, bounds[1:], strict=False):
        t = np.array([start]) if piece.rests else _row_times(piece.switches, start, stop)[:-1]
        positions, speeds = piece.at(np.clip(t - start, 0.0, piece.duration))
        times.append(t)
        q.append(positions)
        qd.append(speeds)
    times.append(bounds[-1:])
    q.append(end[None])
    qd.append(np.zeros((1, len(names))))
    return Trajectory(names, np.concatenate(times), np.concatenate(q), np.concatenate(qd))


def _row_times(switches: Array, start: float, stop: float) -> Array:
    """The switches of a piece from start to stop, and every grid time that keeps its distance from them."""
    marks = start + switches
    marks[0], marks[-1] = start, stop
    keep = np.r_[True, np.diff(marks) > SAME]
    keep[-1] = True
    marks = marks[keep]
    if len(marks) > 2 and marks[-1] - marks[-2] <= SAME:
        marks = np.delete(marks, -2)
    grid = np.arange(np.ceil(start / GRID - 1e-9), np.floor(stop / GRID + 1e-9) + 1) * GRID
    after = np.clip(np.searchsorted(marks, grid), 1, len(marks) - 1)
    gap = np.minimum(np.abs(grid - marks[after - 1]), np.abs(grid - marks[after]))
    return np.unique(np.concatenate([marks, grid[(gap >= LEAST) & (grid > start) & (grid < stop)]]))
