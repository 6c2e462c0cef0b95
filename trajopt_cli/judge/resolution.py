"""Whether a file's rows are close enough, and its digits fine enough, to show every limit.

Every check grants what printed digits and missing rows leave open, so that no legal motion fails. What digits hide must
therefore stay small: a position is off by half its printed step r, a time by half of r_t, so a mean speed v over H is
open by (2 r + 2 v r_t) / H, a mean acceleration of speeds in steps r_v by (2 r_v + 2 a r_t) / H, a second divided
difference of positions by (4 r + 5 v r_t) / H^2, a third one by (12 r + 12 v r_t) / H^3: once as it may have been
printed, once as it is granted. Of the lags that the judge looks at, the one that hides least counts.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from math import floor, log10
from typing import Any, NamedTuple

import numpy as np

from trajopt_cli.findings import Finding, GridResolution
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import axis_unit, finding
from trajopt_cli.judge.geometry import lengths
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.judge.samples import LAGS, Rows
from trajopt_cli.judge.timeline import Timeline
from trajopt_cli.judge.tolerances import (
    COARSEST_PRINT,
    COARSEST_RATE,
    COARSEST_TURN,
    DWELL,
    LARGEST_GAP,
    REST_LINEAR,
    STOP_POSITION,
)
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.shapes import Shape, outline
from trajopt_cli.sheet import missing_rows

_SHORT = 1e-9  # s: of a file at rest throughout, whose gaps count for nothing


def check_resolution(
    line: Timeline, frames: Mapping[bytes, ToolKinematics], first: ToolKinematics
) -> Iterator[Finding]:
    """Row spacing and printed digits.

    Args:
        line: the file's rows with its stops.
        frames: the motion of every tool's centre point.
        first: the one in force at the start, which the position's digits are told of.

    Yields:
        A finding for the widest gap and for the TCP's position; one more for every limit that digits hide.
    """
    rows = line.rows
    i, k = int(np.argmax(rows.gaps)), int(np.argmax(first.doubt_p))
    far, coarse = float(rows.gaps[i]), float(first.doubt_p[k])
    note = ": rows this far apart do not show whether the TCP stops; sample the motion at 50 Hz or more"
    if lost := missing_rows(rows.t, rows.gaps):
        note = f"{note} and lose no row; {lost}"
    yield finding("row spacing", "file", far, LARGEST_GAP, "s", far <= LARGEST_GAP * (1 + 1e-9) + rows.doubt_t,
                  time=float(rows.t[i]), note=note)  # fmt: skip
    note = f": printed digits leave the TCP this uncertain; {_finer(rows, Hidden(coarse), COARSEST_PRINT)}"
    yield finding("printed resolution", "file", coarse, COARSEST_PRINT, "m", coarse <= COARSEST_PRINT,
                  time=float(rows.t[k]), note=note)  # fmt: skip
    turned = Hidden(max(float(frame.doubt_R.max()) for frame in frames.values()))
    if turned.total > COARSEST_TURN:
        yield _too_coarse(rows, "stop reached", "tool", "rad", turned, COARSEST_TURN)
    for one in _moving(line, frames):
        for order, (check, limit) in enumerate(one.limits.items(), 1):
            hidden, most = _hidden(rows, one, order), order * COARSEST_RATE * limit
            if hidden.total > most:
                per = ("/s", "/s2", "/s3")[order - 1]
                yield _too_coarse(rows, check, one.name, one.unit + per, hidden, most)


class Hidden(NamedTuple):
    """What printed digits hide of a value: those of positions (or of speeds), and those of times."""

    digits: float
    times: float = 0.0
    speeds: bool = False

    @property
    def total(self) -> float:
        """Of both."""
        return self.digits + self.times


class _Moving(NamedTuple):
    """What is limited: printed step of its place, and of its speed where the file has speeds; limits by check, of its
    speed, acceleration and jerk in this order."""

    name: str
    unit: str
    step: float
    speed_step: float | None
    limits: dict[str, float]


def _moving(line: Timeline, frames: Mapping[bytes, ToolKinematics]) -> Iterator[_Moving]:
    rows, plant = line.rows, line.rows.plant
    limits, jerk = plant.limits, plant.limits.binding_jerk
    r, r_v = rows.doubt_q.max(axis=0), rows.doubt_v.max(axis=0)
    for j, name in enumerate(limits.names):
        of_axis = {"joint speed": float(limits.velocity[j]), "joint acceleration": float(limits.acceleration[j])}
        of_axis |= {} if jerk is None else {"joint jerk": float(jerk[j])}
        yield _Moving(name, axis_unit(name), float(r[j]), None if rows.qd is None else float(r_v[j]), of_axis)

    def twice(values: Iterable[Any]) -> float:
        return 2 * max(float(one[:].max()) for one in values)

    places = [twice(one.doubt_p for one in frames.values()), twice(one.doubt_R for one in frames.values())]
    speeds: list[float | None] = [None, None]
    if rows.qd is not None:
        speeds = [twice(one.doubt_V[i] for one in frames.values()) for i in (0, 1)]
    caps = {"TCP speed": plant.tcp.speed, "TCP acceleration": plant.tcp.acceleration}
    yield _Moving("TCP", "m", places[0], speeds[0], caps)
    turns = [visit.point.move.speed.v_ori for visit in line.visits if visit.point.move is not None]
    if (top := max(turns, default=0.0)) > 0:
        yield _Moving("TCP", "rad", places[1], speeds[1], {"programmed reorientation": float(top)})


def _hidden(rows: Rows, one: _Moving, order: int) -> Hidden:
    """Of a derivative of that order, by the lag that hides least."""
    r_t = float(rows.step_t[1:-1].max() if len(rows.t) > 4 else rows.step_t.max())
    speeds = one.speed_step is not None and order > 1
    below = order - speeds  # differences that are taken
    step = one.speed_step if speeds and one.speed_step is not None else one.step
    rate = list(one.limits.values())[speeds]  # of what the differences are taken of
    digits, times = ((2, 2), (4, 5), (12, 12))[below - 1]
    found = [] if one.speed_step is None or speeds else [Hidden(1.5 * one.speed_step, 0.0, True)]
    for m in LAGS:
        if below * m + 1 < len(rows.t):
            H = float((rows.t[below * m :] - rows.t[: -below * m]).min()) / below
            found.append(Hidden(digits * step / H**below, times * rate * r_t / H**below, speeds))
    return min(found, key=lambda hidden: hidden.total, default=Hidden(0.0))


def _too_coarse(rows: Rows, check: str, name: str, unit: str, hidden: Hidden, most: float) -> Finding:
    note = f" of {check}: {_finer(rows, hidden, most)}"
    return finding("printed resolution", name, hidden.total, most, unit, False, words="may be off unseen by", note=note)


def _finer(rows: Rows, hidden: Hidden, most: float) -> str:
    """How finely to print so that half of what may be hidden is."""
    digits = ("speeds", rows.doubt_v) if hidden.speeds else ("positions", rows.doubt_q)
    needs = [
        f"{name} in steps of {10.0 ** floor(log10(float(steps.max()) * most / (2 * open_))):g}"
        for (name, steps), open_ in ((digits, hidden.digits), (("times", rows.step_t), hidden.times))
        if open_ > most / 2
    ]
    return f"print {' and '.join(needs)} (SI) or finer" if needs else "give more rows"


def grid_resolution(line: Timeline, frames: Mapping[bytes, ToolKinematics]) -> GridResolution | None:
    """What the rows of a bare grid leave open of stops and waits; None for files with a row at every boundary."""
    rows = line.rows
    every = float(np.median(rows.gaps))
    if rows.marked or every == 0.0:
        return None
    a, tau, h = rows.plant.tcp.acceleration, float(rows.open_time.max()), max(float(rows.longest.max()), _SHORT)
    p = max(float(frame.doubt_p.max()) for frame in frames.values())
    if rows.qd is not None:
        rest = REST_LINEAR + a * tau + 2 * max(float(frame.doubt_V[0][:].max()) for frame in frames.values())
    else:
        rest = REST_LINEAR + a * (tau + h / 2) + 4 * p / h
    return GridResolution(1 / every, DWELL + 2 * rows.doubt_t + 4 * tau, STOP_POSITION + a * tau**2 / 2 + 2 * p, rest)


def granted_clearance(rows: Rows, carried: Iterable[Shape]) -> float:
    """How much nearer than it is the robot may be seen [m]: printed digits and rows move every axis by so much."""
    lever = np.array(levers(rows.plant, rows.mechanism, carried))
    bend = 0.0 if rows.exact else max(float(rows.longest.max()), _SHORT) ** 2 / 8
    return float(lever @ (rows.doubt_q.max(axis=0) / 2 + rows.accelerations.most * bend))


def levers(plant: Machine, mechanism: Mechanism, carried: Iterable[Shape]) -> Sequence[float]:
    """How far from every axis (k,) a point of the robot or of the bodies that it carries may be [m]: the links
    stretched out; 1 for a rail."""
    X_WL = mechanism.links(np.array(plant.start)[None])[0][0]
    links = lengths(np.diff(X_WL[1:, :3, 3], axis=0))  # from joint to joint, then to the flange
    stretched: Array = np.cumsum(links[::-1])[::-1]
    beyond = 0.0
    for shape in (*chain.from_iterable(plant.robot.bodies.values()), *carried):
        points, radius = outline(shape)
        beyond = max(beyond, float(lengths(points).max()) + radius)
    return [1.0] * mechanism.rails + [float(one) + beyond for one in stretched]
