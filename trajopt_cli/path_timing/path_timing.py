"""Time-optimal timing of sampled paths: TOPP under all limits, tightened where a dense check finds an excess."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from itertools import groupby, pairwise

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.path.segment import JointSegment
from trajopt_cli.path_timing.path_derivatives import PathDerivatives
from trajopt_cli.path_timing.sampled_path import SampledPath, finer, together
from trajopt_cli.problem.problem import Leg, Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.settings import Settings
from trajopt_cli.timing.topp import TimeLaw, fastest_laws
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import Ratios, ratios_of, share_rates
from trajopt_cli.trajectories.leg_trajectories import JointNodes, PathLeg, Pieces, sampled
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.limits.joint_torque import of_room
from trajopt_cli.trajectories.limits.limit import Limit, PathRows, PathSamples

_WAITED = 1 + 1e-05  # of a least time, at which a leg between corners aims.
_NEARLY = 0.001  # of a leg's time is left to wait: all of it is waited for then.
# of what is left to wait is waited for in a round. Measured on four legs in corners that wait for 1 s each: all at once
# 1.006 s, so 1.000 s.
_MOST_LEFT = 0.9
_HALVINGS = 50  # of a rate at which a leg lasts long enough.
_PACE_ROUNDS = 25  # of checking and tightening.
_RESOLVED = 8  # halvings at most.
_STEEP = 1.25  # times by which the greatest rate may differ between two nodes before they are put closer.
_LED = 0.02  # rad, m by which axes may be elsewhere at the next node than their slopes lead.
_LOST = 0.2  # rad, m by which they may be with the nodes as close as they get.

_RANGE = 1 + 1e-6  # share of half an axis' range that a path may reach


class Unresolved(Exception):
    """A path passes so near a singularity that no rate is low enough: leg, its number; q (n,), axes there."""

    def __init__(self, leg: int, q: Array):
        super().__init__(leg, q)
        self.leg, self.q = leg, q


@dataclass
class PathMargins:
    """What an interval (N,) of a path may use of each limit: of what it asks of the rate and of the acceleration (N, 2)
    by the limit's name. rate (N,): of the path parameter at most, because its leg has a least time."""

    by_name: dict[str, Array]
    rate: Array

    @classmethod
    def full(cls, axes: Axes, N: int) -> PathMargins:
        """All but a hair."""
        return cls({limit.name: np.full((N, 2), limit.start) for limit in limits_of(axes)}, np.full(N, np.inf))

    def tighten(self, used: Mapping[str, Array], seen: Ratios, settings: Settings) -> BoolArray:
        """Less for the intervals whose worst ratios exceed what is safe: which (N,).

        used: what the law uses at the nodes (N, 2) by the limit's name, which is tightened, for what it leaves it would
        not miss.
        """
        changed = np.zeros(len(self.rate), dtype=bool)
        for limit in seen.limits:
            for k, order in enumerate((1, 2) if limit.name in used else ()):
                ratio = seen.by_name[limit.name][:, limit.orders == order].max(axis=1, initial=0.0)
                over, margin = ratio > limit.safe, self.by_name[limit.name][:, k]
                active = np.clip(used[limit.name][:, k], margin * settings.least_left, margin)
                margin[over] = active[over] * (limit.safe - settings.beyond) / ratio[over]
                changed |= over
        return changed

    def slow(self, seen: Ratios, law: TimeLaw, settings: Settings) -> BoolArray:
        """A lower rate for the intervals (N,) where a limit that has no rows on a path is exceeded: which."""
        changed = np.zeros(len(self.rate), dtype=bool)
        for limit in seen.limits:
            if limit.slows_paths:
                timed = limit.orders > 0
                excess = seen.by_name[limit.name][:, timed] / (limit.safe - settings.beyond)
                over = np.max(excess, axis=1, initial=0.0) * (limit.safe - settings.beyond) > limit.safe
                times = np.max(excess ** (1 / limit.orders[timed]), axis=1, initial=0.0)
                rates = np.maximum(law.rates[:-1], law.rates[1:])
                self.rate[over] = np.minimum(self.rate[over], rates[over] / times[over])
                changed |= over
        return changed

    def wait(self, problem: Problem, path: SampledPath, law: TimeLaw, over: BoolArray) -> BoolArray:
        """A lower rate for the intervals (N,) of legs beside a corner that would be over before their least time: over,
        and these too. A run that passes a limit, as over says, comes when it no longer does."""
        out = over.copy()
        legs = [0, *(1 + np.flatnonzero(np.diff(path.leg))).tolist(), len(path.part)]
        for a, b in pairwise(legs if len(legs) > 2 and not over.any() else ()):
            least, rates = problem.legs[path.leg[a]].least, law.rates[a : b + 1]
            if least > 0.0 and 0.0 < (T := _time(path.sigma[a : b + 1], rates)) < least:
                left = least * _WAITED - T  # legs beside it get slower as well: not all of it at once
                aim, low, high = T + left * (1.0 if left < _NEARLY * T else _MOST_LEFT), 0.0, float(rates.max())
                for _ in range(_HALVINGS):
                    middle = (low + high) / 2
                    late = _time(path.sigma[a : b + 1], np.minimum(rates, middle)) > aim
                    low, high = (middle, high) if late else (low, middle)
                self.rate[a:b], out[a:b] = low, True
        return out


def _time(sigma: Array, rates: Array) -> float:
    """How long a path takes whose nodes are passed at these rates; 0 where it is at rest."""
    sums = rates[1:] + rates[:-1]
    return float(np.sum(2 * np.diff(sigma) / sums)) if np.all(sums > 0) else 0.0


def samples_of(axes: Axes, legs: Sequence[Leg], number: IndexArray, along: PathDerivatives) -> PathSamples:
    """Places along paths, to be asked of limits; place i on legs[number[i]]."""
    caps = axes.caps(legs).at(number)
    return PathSamples(legs, number, caps, *(getattr(along, one.name) for one in fields(along)))


def path_rows(limits: Sequence[Limit], path: PathSamples) -> dict[str, PathRows]:
    """What limits ask for along a path, by name, of those that ask for anything."""
    return {limit.name: rows for limit in limits if (rows := limit.path_rows(path)) is not None}


def but_torques(axes: Axes) -> list[Limit]:
    """The limits but for those of torque, which take too long to be asked for all that a search compares."""
    return [limit for limit in limits_of(axes) if limit.name != "torque"]


def stacked(rows: Mapping[str, PathRows]) -> PathRows:
    """The columns of all limits side by side."""
    every = [*rows.values()]
    top, slopes, bends = (np.hstack([getattr(one, name) for one in every]) for name in ("top", "slopes", "bends"))
    none = not any(one.rests.any() for one in every)
    return PathRows(top, slopes, bends, PathRows.no_rests(slopes) if none else np.hstack([one.rests for one in every]))


def rows_on(
    axes: Axes, problem: Problem, path: SampledPath, limits: Sequence[Limit] | None = None
) -> dict[str, PathRows]:
    """What limits, by default all in force, ask for at all nodes of a path."""
    legs, of = np.unique([part.leg for part in path.parts], return_inverse=True)
    number = np.repeat(of, path.counts + 1)
    samples = samples_of(axes, [problem.legs[k] for k in legs], number, path.along)
    return path_rows(limits_of(axes) if limits is None else limits, samples)


def used_by(axes: Axes, problem: Problem, path: SampledPath, law: TimeLaw) -> dict[str, Array]:
    """What a law uses of each limit (N, 2), of the rate and of the acceleration, at the ends of every interval."""
    u = np.diff(law.rates**2) / (2 * np.diff(path.sigma))
    out = dict[str, Array]()
    for name, rows in rows_on(axes, problem, path).items():
        out[name] = np.zeros((len(u), 2))
        for row, rate in ((path.first, law.rates[:-1, None]), (path.first + 1, law.rates[1:, None])):
            at = rows.at(row)
            pushed = of_room(at.slopes * u[:, None] + at.bends * rate**2, at.rests)
            used = [np.max(x, axis=1, initial=0.0) for x in (rate / at.top, pushed)]
            out[name] = np.maximum(out[name], np.column_stack(used))
    return out


def in_force(axes: Axes, problem: Problem, path: SampledPath, margins: PathMargins) -> tuple[Array, Rows, Rows]:
    """The greatest rates (N+1,) at the nodes of a path, and slopes, bends and rests (N, c) of what is limited where
    each interval begins and where it ends."""
    found = rows_on(axes, problem, path)
    top, sides = np.full(len(path.part) + 1, np.inf), list[Rows]()
    for row, at in ((path.first, slice(None, -1)), (path.first + 1, slice(1, None))):
        of = [(rows.at(row), margins.by_name[name]) for name, rows in found.items()]
        tops = [rows.rate * margin[:, 0] for rows, margin in of]
        top[at] = np.min([top[at], margins.rate, *tops], axis=0)
        sides.append(
            (
                np.hstack([rows.slopes / margin[:, 1:] for rows, margin in of]),
                np.hstack([rows.bends / margin[:, 1:] for rows, margin in of]),
                np.hstack([rows.rests for rows, _ in of]),
            )
        )
    top[[*path.rests]] = 0.0
    return top, sides[0], sides[1]


def time_optimal_law(axes: Axes, problem: Problem, path: SampledPath, margins: PathMargins) -> TimeLaw | None:
    """The fastest law of a run's path, from rest to rest; None where there is none."""
    law = _time_optimal(axes, problem, path, margins)
    return law if np.all(law.rates[1:] + law.rates[:-1] > 0) else None  # one that takes no time is at rest


Rows = tuple[Array, Array, Array]
LawMaker = Callable[[Axes, Problem, SampledPath, PathMargins], TimeLaw | None]


def time_path(
    axes: Axes, problem: Problem, path: SampledPath, make_law: LawMaker = time_optimal_law
) -> dict[int, Pieces] | None:
    """The motions of a run's legs, fastest on its path or by another law, within every limit wherever it is
    sampled; None where the path itself leaves the axes' ranges, or no law is found. Raises Unresolved."""
    resolved = _resolved(axes, problem, path)
    if resolved is None:
        return None
    path, N = resolved, len(resolved.part)
    margins, seen, before = PathMargins.full(axes, N), Ratios.none(axes, N), None
    for _ in range(_PACE_ROUNDS):
        checkpoint()
        law = make_law(axes, problem, path, margins)
        if law is None:
            return None
        new = _timed_anew(path, law, before)  # a round tightens nearby only: a leg timed as before is what it was
        if new.any():
            ratios = sampled_ratios(axes, problem, path, law, np.unique(path.part[new]).tolist())
            seen.put(np.flatnonzero(new), ratios)
        if seen.position.max() > _RANGE:
            return None
        over = margins.tighten(used_by(axes, problem, path, law), seen, axes.settings)
        over |= margins.slow(seen, law, axes.settings)
        if not margins.wait(problem, path, law, over).any():
            return motions(axes, problem, path, law)
        before = law.rates
    return None


def least_times(axes: Axes, problem: Problem, paths: Sequence[SampledPath]) -> Array:
    """What paths (m,) take from rest to rest, unchecked between their nodes; infinite where there is no law."""
    settings = axes.settings
    T = np.full(len(paths), np.inf)
    sizes = np.cumsum([len(path.part) for path in paths])
    for _, group in groupby(range(len(paths)), key=lambda i: int(sizes[i]) // (2 * settings.batch)):
        checkpoint()
        numbers = [*group]
        every = together([paths[i] for i in numbers])
        law = _time_optimal(axes, problem, every, PathMargins.full(axes, len(every.part)))
        with np.errstate(divide="ignore"):
            steps = 2 * np.diff(every.sigma) / (law.rates[1:] + law.rates[:-1])
        T[numbers] = np.add.reduceat(steps, [0, *every.rests])
    return T


def _time_optimal(axes: Axes, problem: Problem, path: SampledPath, margins: PathMargins) -> TimeLaw:
    """The fastest law of paths one after the other; it is at rest on those that have none."""
    top, *rows = in_force(axes, problem, path, margins)
    begins, ends = (tuple(x[None] for x in (one if np.any(one[2]) else one[:2])) for one in rows)
    return TimeLaw(path.sigma, fastest_laws(path.sigma[None], top[None], begins, ends, 0.0, 0.0).rates[0])


def _timed_anew(path: SampledPath, law: TimeLaw, before: Array | None) -> BoolArray:
    """The intervals (N,) of legs that were timed otherwise before."""
    if before is None:
        return np.ones(len(path.part), dtype=bool)
    other = law.rates != before
    starts = np.flatnonzero(np.diff(path.leg, prepend=-1))
    legs = np.logical_or.reduceat(other[:-1] | other[1:], starts)
    return np.repeat(legs, np.diff(starts, append=len(path.leg)))


def _resolved(axes: Axes, problem: Problem, path: SampledPath) -> SampledPath | None:
    """The path on nodes so close that what happens at one says what happens up to the next: the rate at which it may
    be passed changes little, and the axes go where their slopes lead. Beside a singularity that takes many.

    Raises Unresolved where no nodes are close enough: the path passes a singularity.
    """
    for _ in range(_RESOLVED):
        wanted, _ = _too_coarse(axes, problem, path)
        if not wanted.any():
            return path
        found = finer(axes, problem, path, wanted)
        if found is None:
            return None
        path = found
    _, lost = _too_coarse(axes, problem, path)
    if lost.any():
        i = int(np.argmax(lost))
        raise Unresolved(int(path.leg[i]), path.along.q[path.first[i]])
    return path


def _too_coarse(axes: Axes, problem: Problem, path: SampledPath) -> tuple[BoolArray, BoolArray]:
    """Which intervals (N,) want a node in the middle, and which say nothing of what happens in them."""
    top = stacked(rows_on(axes, problem, path, but_torques(axes))).rate
    row, along = path.first, path.along
    low, high = np.minimum(top[row], top[row + 1]), np.maximum(top[row], top[row + 1])
    step = np.diff(path.sigma)[:, None]
    led = np.abs(along.q[row + 1] - along.q[row] - step * (along.dq[row] + along.dq[row + 1]) / 2).max(axis=1)
    return (high > _STEEP * low) | (led > _LED), led > _LOST


def sampled_ratios(axes: Axes, problem: Problem, path: SampledPath, law: TimeLaw, parts: Sequence[int]) -> Ratios:
    """Worst ratio to each limit in every interval of some of the parts of a path that is timed by a law, in order; not
    of jerk. Both ends of an interval are sampled from inside."""
    settings = axes.settings
    found = list[Ratios]()
    rows = np.cumsum([path.parts[i].N * settings.path_interval_samples * settings.corner_samples for i in parts])
    for _, group in groupby(zip(parts, rows, strict=True), key=lambda one: int(one[1]) // (6 * settings.batch)):
        checkpoint()
        numbers = [i for i, _ in group]
        legs = [problem.legs[path.parts[i].leg] for i in numbers]
        pieces = [_piece(axes, problem, path, law, i) for i in numbers]
        times, first, count = list[Array](), list[IndexArray](), 0
        for i, leg, piece in zip(numbers, legs, pieces, strict=True):
            in_corner = path.parts[i].segment.is_corner
            samples = settings.path_interval_samples * (
                settings.along_path_samples if leg.along else settings.corner_samples if in_corner else 1
            )
            inside = np.clip((np.arange(samples + 2) - 0.5) / samples, 1e-9, 1 - 1e-9)
            breaks = piece.breaks()
            times.append((breaks[:-1, None] + np.diff(breaks)[:, None] * inside).ravel())
            first.append(count + np.arange(piece.N) * len(inside))
            count += len(times[-1])
        number = np.repeat(np.arange(len(legs)), [len(t) for t in times])
        sample, progress = sampled(axes, pieces, times), share_rates(legs, pieces, times)
        found.append(ratios_of(axes, legs, number, sample, np.concatenate(first), progress))
    return Ratios.joined(found)


def motions(axes: Axes, problem: Problem, path: SampledPath, law: TimeLaw) -> dict[int, Pieces]:
    """The motions of a run's legs under a law, by leg."""
    out: dict[int, list[PathLeg | JointNodes]] = {}
    for i, part in enumerate(path.parts):
        out.setdefault(part.leg, []).append(_piece(axes, problem, path, law, i))
    return {k: Pieces(tuple(pieces)) for k, pieces in out.items()}


def _piece(axes: Axes, problem: Problem, path: SampledPath, law: TimeLaw, i: int) -> PathLeg | JointNodes:
    """Part i of a path under a law, in scaled time."""
    part, row = path.parts[i], path.begins[i]
    leg, at = problem.legs[part.leg], slice(row, row + part.N + 1)
    q, dq, rates = path.along.q[at].copy(), path.along.dq[at], law.rates[row - i : row - i + part.N + 1]
    times = np.concatenate([[0.0], np.cumsum(2 * part.size * np.diff(part.u) / (rates[1:] + rates[:-1]))])
    T = float(times[-1])
    grid = times / T
    grid[-1] = 1.0
    if isinstance(part.segment, JointSegment):
        v = dq * (rates * T)[:, None]
        return JointNodes(T, grid, q, v, np.diff(v, axis=0) / np.diff(grid)[:, None])
    assert part.rail is not None
    rate = rates * T / part.size  # of the part's share by scaled time
    way = part.s_1 - part.s_0
    d, dd, _ = part.rail.at(part.u)
    w = dd * rate[:, None]
    steps = np.diff(grid)
    return PathLeg(
        T, part.segment, leg.X_FT, part.cfx, q[0, axes.layout.arm].copy(), grid, part.own(part.u), way * rate,
        way * np.diff(rate) / steps, d, w, np.diff(w, axis=0) / steps[:, None],
    )  # fmt: skip
