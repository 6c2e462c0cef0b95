"""The least that limits must be, by any motion that a log holds: with or without rests, along whatever path.

The slope of a least-squares line through the rows of a window is a mean of the speeds in it, the curvature of the
parabola a mean of its accelerations, with weights that are nowhere negative, however the rows lie (they are orthogonal
to 1, and to 1 and t, and change sign once and twice: their Peano kernels do not). So but for noise neither passes the
greatest in the window. Noise is what the parabola leaves, in the window itself or at its speed in the whole log,
whichever is more (rounding, and clocks that are off), wider by as much as it is alike from row to row. _SURE standard
deviations of it are taken off: what stays was reached. `python benchmarks/bench_reached.py` holds that against motions
in closed form.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.measured.identify import Kind
from trajopt_cli.measured.log_csv import long_gaps
from trajopt_cli.measured.motions import at_rest, noise_of
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM, slides

_SHORTEST = 0.04  # s: of windows
_ROWS = 8  # of the shortest window, at least
_WIDTHS = (1.0, 1.6, 2.5, 4.0, 6.3)  # of the shortest window: short ones see peaks, wide ones little noise
_STEPS = 8  # windows begin so many times in the length of one
_LOST, _MOST = 0.3, 2.0  # of its rows: a window that lost more, or has more than that, is left out
_SURE = 4.0  # standard deviations of the noise
_TOO_LOW = 1.05  # of the limit in force: below, a servo of damping 0.7 that overshoots by 4.6 % may be all that is seen
_BESIDE = {"deg": 0.1 * DEG, "mm": 1 * MM}  # of a range: farther out is not what stops and rounding make
_BATCH = 20_000  # windows at a time
_Seen = tuple[Array, Array]


@dataclass(frozen=True)
class Reached:
    """What an axis reached at least [SI]; of all windows the one that is nearest to the limit in force there, or
    farthest beyond. at [s], posture: middle of the window and mean of the axes there. noise: what was taken off. file:
    the log."""

    axis: str
    kind: Kind
    value: float
    limit: float
    at: float
    posture: dict[str, float]
    noise: float
    file: str

    @property
    def too_low(self) -> bool:
        """Whether the limit in force cannot be that of the robot."""
        return self.value > _TOO_LOW * self.limit

    @property
    def said(self) -> str:
        """That it is, and where it was seen."""
        unit = ("m" if slides(self.axis) else "rad") + {"speed": "/s", "acceleration": "/s²"}[self.kind]
        arm = ", ".join(f"{value / DEG:.0f}" for name, value in self.posture.items() if not slides(name))
        where = f"at {self.at:.3f} s of {self.file}, arm at [{arm}] deg"
        factor = np.ceil(100 * self.value / self.limit) / 100
        allows = f" (acceleration_factor: {factor:g})" if self.kind is Kind.ACCELERATION else ""
        limit = f"the limit in force, {self.limit:.3g}, is too low by this log{allows}"
        return f"{self.axis} reached {self.value:.3g} {unit} ({where}): {limit}"


def reached_in(logs: Sequence[Trajectory], files: Sequence[str], limits: JointLimits) -> list[Reached]:
    """Speed and acceleration of every axis that moved beyond the noise. logs: axes in the order of limits; files: their
    names."""
    best: dict[tuple[str, Kind], Reached] = {}
    for log, file in zip(logs, files, strict=True):
        for one in _of_log(log, file, limits):
            held = best.get((one.axis, one.kind))
            if held is None or one.value / one.limit > held.value / held.limit:
                best[one.axis, one.kind] = one
    return [best[key] for name in limits.names for kind in Kind if (key := (name, kind)) in best]


def _of_log(log: Trajectory, file: str, limits: JointLimits) -> Iterator[Reached]:
    for at, middle, rates, bends in _slopes(log.t, log.q):
        speeds = np.broadcast_to(limits.velocity, middle.shape)
        allowed = np.where(bends[0] < 0, *limits.acceleration_at(middle))
        for kind, seen, limit in (Kind.SPEED, rates, speeds), (Kind.ACCELERATION, bends, allowed):
            sure = _sure(np.abs(seen[0]), seen[1])
            for k, i in enumerate(np.argmax(sure / limit, axis=0)):
                if sure[i, k] > 0:
                    where = float(at[i]), dict(zip(log.names, middle[i].tolist(), strict=True))
                    value, there, noise = (float(of[i, k]) for of in (sure, limit, seen[1]))
                    yield Reached(log.names[k], kind, value, there, *where, noise, file)


def _sure(values: Array, noise: Array) -> Array:
    """What is left of values without the noise; 0 where that is less than it."""
    return np.where(2 * noise < values, values - noise, 0.0)


def _slopes(t: Array, q: Array) -> Iterator[tuple[Array, Array, _Seen, _Seen]]:
    """By width of windows (m,): their middle [s], mean posture (m, n), speeds and accelerations (m, n), each with its
    noise (m, n)."""
    period = float(np.median(np.diff(t)))
    floor = noise_of(q, at_rest(t, q)).astype(np.float32)
    for width in max(_SHORTEST, _ROWS * period) * np.array(_WIDTHS):
        found = _windows(t, q, width, period)
        if found is None:
            continue
        at, middle, rates, rate_per, bends, bend_per, left, alike = found
        fast = np.abs(rates) >= np.maximum(0.3 * np.abs(rates).max(axis=0), 1e-12)
        clock = np.sqrt(np.sum((left / np.where(fast, rates, np.inf)) ** 2, axis=0) / np.maximum(fast.sum(axis=0), 1))
        noise = np.maximum(left, np.hypot(floor, clock * np.hypot(rates, bends * width / 2)))
        noise *= _SURE * np.sqrt((1 + alike) / (1 - alike))
        yield at, middle, (rates, noise * rate_per), (bends, noise * bend_per)


def tool_beyond(t: Array, p: Array, caps: TcpCaps, file: str) -> Iterator[str]:
    """Where the tool centre point, at p (n, 3) [m] at times t (n,) [s], passes the caps on it, a line each."""
    most = {"speed": (0.0, 0.0), "acceleration": (0.0, 0.0)}
    for at, _, *both in _slopes(t, p):
        for what, seen in zip(most, both, strict=True):
            sure = _sure(*(np.linalg.norm(one, axis=1) for one in seen))
            most[what] = max(most[what], (float(sure.max()), float(at[np.argmax(sure)])))
    for (what, (value, when)), unit in zip(most.items(), ("m/s", "m/s²"), strict=True):
        if value > _TOO_LOW * getattr(caps, what):
            limit = f"the cap in force, {getattr(caps, what):.3g}, is too low by this log"
            yield f"the tool centre point reached {value:.3g} {unit} (at {when:.3f} s of {file}): {limit}"


def contradictions(
    logs: Sequence[Trajectory], files: Sequence[str], limits: JointLimits, reached: Sequence[Reached]
) -> Iterator[str]:
    """Where logs and the limits in force cannot both be right, a line each."""
    yield from (one.said for one in reached if one.too_low)
    for k, name in enumerate(limits.names):
        unit, size = ("mm", MM) if slides(name) else ("deg", DEG)
        for log, file in zip(logs, files, strict=True):
            low, high = limits.lower[k], limits.upper[k]
            i = int(np.argmax(np.maximum(low - log.q[:, k], log.q[:, k] - high)))
            if not low - _BESIDE[unit] <= (value := log.q[i, k]) <= high + _BESIDE[unit]:
                yield (
                    f"{name} stood at {value / size:.2f} {unit} (at {log.t[i]:.3f} s of {file}): its range in force, "
                    f"{low / size:.2f} to {high / size:.2f}, is too narrow by this log"
                )
                break


def _windows(t: Array, q: Array, width: float, period: float) -> tuple[Array, ...] | None:
    """Of windows (m,) with all their rows: their middle [s], mean posture, slope, its standard deviation by that of a
    row, curvature, likewise, what is left (standard deviation), and how alike that is from row to row (n,); None where
    there are none."""
    middle = np.arange(t[0] + width / 2, t[-1] - width / 2, width / _STEPS)
    first, last = np.searchsorted(t, middle - width / 2), np.searchsorted(t, middle + width / 2, side="right")
    rows, usual = last - first, width / period
    gaps = long_gaps(t)
    late = np.sort(2 * t[gaps + 1] - t[gaps])  # what a recorder held back comes in a burst, no longer than it was held
    hindered = np.searchsorted(t[gaps], middle + width / 2) > np.searchsorted(late, middle - width / 2)
    whole = ~hindered & (rows >= _ROWS - 1) & (rows >= (1 - _LOST) * usual - 1) & (rows < _MOST * usual)
    parts: list[list[Any]] = []
    alike = np.zeros((2, q.shape[1]))
    for count in np.unique(rows[whole]):
        some = np.flatnonzero(whole & (rows == count))
        for chosen in np.split(some, range(_BATCH, len(some), _BATCH)):
            inside = first[chosen][:, None] + np.arange(count)
            u, p = t[inside] - middle[chosen][:, None], q[inside]
            u -= u.mean(axis=1, keepdims=True)
            mean = p.mean(axis=1)
            p -= mean[:, None]
            uu = np.sum(u**2, axis=1)
            w = u**2 - (uu / count)[:, None] - (np.sum(u**3, axis=1) / uu)[:, None] * u
            ww = np.sum(w**2, axis=1)
            slope, bend = (np.einsum("mi,mik->mk", of, p) / by[:, None] for of, by in ((u, uu), (w, ww)))
            p -= u[:, :, None] * slope[:, None] + w[:, :, None] * bend[:, None]
            alike += np.sum(p[:, 1:] * p[:, :-1], axis=(0, 1)), np.sum(p**2, axis=(0, 1))
            left = np.sqrt(np.sum(p**2, axis=1) / (count - 3))
            found = mean, slope, 1 / np.sqrt(uu)[:, None], 2 * bend, 2 / np.sqrt(ww)[:, None], left
            parts.append([middle[chosen], *(one.astype(np.float32) for one in found)])  # there are many
    if not parts:
        return None
    return *(np.concatenate(part) for part in zip(*parts, strict=True)), np.clip(
        alike[0] / (alike[1] + 1e-300), 0, 0.9
    ).astype(np.float32)
