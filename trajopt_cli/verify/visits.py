"""When a file without marks is at which stop of the program.

Near rows: a row is near a stop when its pose is the wanted one within tolerance (for a MoveAbsJ its arm joints, for a
MoveExtJ its rail with the TCP at rest). A file that has no row at the boundary itself shows a stop in its nearest row,
half a gap tau away at most, where the TCP may still be a tau^2/2 off and have the speed a tau: that much is granted.

An event is an unbroken run of near rows; its good rows are those where the TCP rests as well (for RAPID: every axis)
and a programmed rail position is met. Events are then matched with the stops in program order so that most stops find
a good event (an event without good rows counts less, a missed optional point hardly), the earliest where several do. So
one wrong stop stays one wrong stop: a point flown by, skipped or swapped does not shift the blame to the points after
it. Consecutive stops at one pose (waits and moves of the redundant axis) share an event.

Within an event the time runs: the first good row is the arrival, each wait and each `\\T` takes its length from there,
the last good row is the latest departure. A rest may be longer than asked; a slow plan is legal.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveExtJ
from trajopt_cli.verify.course import Stop
from trajopt_cli.verify.frame import Frame, angular_acceleration
from trajopt_cli.verify.geometry import angle_between
from trajopt_cli.verify.rows import Rows
from trajopt_cli.verify.tolerances import (
    JOINT_TARGET,
    REST_ANGULAR,
    REST_LINEAR,
    STOP_POSITION,
    STOP_ROTATION,
)

Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Closeness:
    """How near every row is to a stop. distance (n,): the larger of position and rotation (or axes) in tolerances.

    tight: within tolerance without anything granted for missing rows. rests: the TCP stands. rail_met: the rail is
    where the program wants it. stands: every axis rests (RAPID; else always true).
    """

    distance: Array
    near: Mask
    tight: Mask
    rests: Mask
    rail_met: Mask
    stands: Mask


@dataclass(frozen=True, eq=False)
class Event:
    """A run of near rows [first, last]; good: the rows in it that count as the stop itself, maybe none."""

    first: int
    last: int
    good: NDArray[np.intp]
    best: int

    @property
    def end(self) -> int:
        """The last row that counts."""
        return int(self.good[-1]) if len(self.good) else self.last


@dataclass(frozen=True, eq=False)
class Match:
    """What a stop found in the file. event None: it was never near. later: other events of the same stop."""

    stop: Stop
    close: Closeness
    event: Event | None
    later: tuple[Event, ...]


def closeness(rows: Rows, frame: Frame, stop: Stop, rapid: bool) -> Closeness:
    """Every row against one stop. rapid: every axis must stand there."""
    limits, tau = rows.plant.limits, rows.open_time
    a, alpha = rows.plant.tcp.acceleration, angular_acceleration(rows)
    rests = (frame.least_speed <= REST_LINEAR + a * tau) & (frame.least_turning <= REST_ANGULAR + alpha * tau)
    granted = JOINT_TARGET + rows.doubt_q / 2 + limits.acceleration * tau[:, None] ** 2 / 2
    n = len(rows.t)
    stands: Mask = rows.axes_rest if rapid else np.ones(n, dtype=bool)
    rail_met = np.ones(n, dtype=bool) if stop.rail is None else np.abs(rows.q[:, 0] - stop.rail) <= granted[:, 0]
    near: Mask
    tight: Mask
    if isinstance(stop.move, MoveExtJ):
        off = np.abs(rows.q[:, 0] - (stop.rail or 0.0))
        near, tight = rail_met & rests, off <= JOINT_TARGET + rows.doubt_q[0] / 2
        return Closeness(off / JOINT_TARGET, near, tight, rests, rail_met, stands)
    if stop.arm is not None:
        off = np.abs(rows.q[:, -6:] - stop.arm)
        near = np.asarray((off <= granted[:, -6:]).all(axis=1))
        tight = np.asarray((off <= JOINT_TARGET + rows.doubt_q[-6:] / 2).all(axis=1))
        return Closeness(off.max(axis=1) / JOINT_TARGET, near, tight, rests, rail_met, stands)
    assert stop.X_WF is not None
    X_WT = stop.X_WF @ stop.X_FT
    d_p = np.maximum(np.linalg.norm(frame.p - X_WT[:3, 3], axis=1) - frame.doubt_p, 0.0)
    d_R = np.maximum(angle_between(frame.R, X_WT[:3, :3]) - frame.doubt_R, 0.0)
    near = (d_p <= STOP_POSITION + a * tau**2 / 2) & (d_R <= STOP_ROTATION + alpha * tau**2 / 2)
    tight = (d_p <= STOP_POSITION) & (d_R <= STOP_ROTATION)
    return Closeness(np.maximum(d_p / STOP_POSITION, d_R / STOP_ROTATION), near, tight, rests, rail_met, stands)


def events_of(close: Closeness) -> tuple[Event, ...]:
    """All events of one stop, in time order."""
    edges = np.flatnonzero(np.diff(np.r_[False, close.near, False].astype(np.int8)))
    out = []
    for first, after in zip(edges[::2], edges[1::2], strict=True):
        run = np.arange(first, after)
        resting = run[close.rests[run]]
        good = resting[close.rail_met[resting] & close.stands[resting]]
        pool = resting if len(resting) else run
        best = int(pool[np.argmin(close.distance[pool])])
        out.append(Event(int(first), int(after) - 1, _core(close, good), best))
    return tuple(out)


def _core(close: Closeness, good: NDArray[np.intp]) -> NDArray[np.intp]:
    """Of every unbroken run of good rows the tight ones, or else the closest: where something is granted for missing
    rows, rows of the motion beside the stop are good as well. RAPID's axes rest at both ends of a dwell: two runs."""
    runs = np.split(good, np.flatnonzero(np.diff(good) > 1) + 1) if len(good) else []
    kept = []
    for run in runs:
        tight = run[close.tight[run]]
        kept.append(tight if len(tight) else run[[int(np.argmin(close.distance[run]))]])
    return np.concatenate(kept) if kept else good


def match(rows: Rows, frames: dict[bytes, Frame], stops: Sequence[Stop], rapid: bool) -> list[Match]:
    """Every stop after the start with its event; see the module's docstring for the rule."""
    known: dict[tuple[object, ...], tuple[Closeness, tuple[Event, ...]]] = {}
    found = []
    for stop in stops[1:]:
        key = tuple(None if part is None else np.asarray(part).tobytes() for part in (stop.X_WF, stop.X_FT, stop.arm))
        full = (*key, stop.rail, isinstance(stop.move, MoveExtJ))
        if full not in known:
            frame = frames[np.asarray(stop.X_FT).tobytes()]
            close = closeness(rows, frame, stop, rapid)
            known[full] = close, events_of(close)
        found.append(known[full])
    chosen = _align(stops[1:], [events for _, events in found])
    return [
        Match(stop, close, event, tuple(e for e in events if event is None or e.first > event.last))
        for stop, (close, events), event in zip(stops[1:], found, chosen, strict=True)
    ]


def _align(stops: Sequence[Stop], events: Sequence[tuple[Event, ...]]) -> list[Event | None]:
    """Dynamic programme from the last stop back: value[r] is what the stops from here on are worth from rank r on."""
    ends = sorted({event.end for own in events for event in own})
    rank = {end: r for r, end in enumerate(ends)}
    values = [np.zeros(len(ends) + 1)]
    for stop, own in zip(reversed(stops), reversed(events), strict=True):
        after = values[-1]
        gain = np.full(len(ends) + 1, -np.inf)
        for event in own:
            r = rank[event.end]
            gain[r] = max(gain[r], _worth(stop, event) + after[r])
        values.append(np.maximum(after, np.maximum.accumulate(gain[::-1])[::-1]))
    values.reverse()
    chosen: list[Event | None] = []
    now = 0
    for k, (stop, own) in enumerate(zip(stops, events, strict=True)):
        pick = None
        for event in own:
            r = rank[event.end]
            if r >= now and _worth(stop, event) + values[k + 1][r] >= values[k][now] - 1e-9:
                pick = event
                break
        chosen.append(pick)
        if pick is not None:
            now = rank[pick.end]
    return chosen


def _worth(stop: Stop, event: Event) -> float:
    return (0.25 if stop.optional else 1.0) * (1.0 if len(event.good) else 0.6)
