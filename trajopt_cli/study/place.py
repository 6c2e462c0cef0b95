"""`place`: where the robot's base, its rail or a work object should stand for the shortest cycle, by search over plans.

Coarsely over points spread evenly in the ranges, each by a first legal motion; then by full plans at the best of them
and, in steps that halve, around the best.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from pathlib import Path

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Source
from trajopt_cli.pipeline.planning import Listener, may_change
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.study.answers import why_illegal
from trajopt_cli.study.places import Offset, Range, Site
from trajopt_cli.units import DEG
from trajopt_cli.workers import cores, in_turns

EACH = 30
"""Points of the coarse search for each range."""
FEW = 4
"""Best points of the coarse search that are planned."""
RESOLUTION, TURN = 0.01, 2 * DEG
"""m and rad: the last steps around the best place are no longer than that."""
LEAST = 5e-4
"""s by which a place has to be better than another one to be preferred."""
_TOLD = 5  # places between two words of progress


@dataclass(frozen=True)
class Tried:
    """One place. first: of its first legal motion [s]; estimate: of the best chain that the search finds [s], which
    ranks places better than the first motion where axes are free; planned: of the full plan [s], None where none was
    asked for. cut: the plan was cut short by the user or the time limit. why: it cannot be done, and why; motion: on
    which line, empty where that is not known. rows: what a legal plan's rows are told by, empty where it leads around
    something or leaves something out."""

    offset: Offset
    first: float | None = None
    estimate: float | None = None
    planned: float | None = None
    cut: bool = False
    why: str = ""
    motion: str = ""
    rows: str = ""


@dataclass(frozen=True, eq=False)
class Placed:
    """The answer. places: by offset, in the order they were tried in, the present one first. steps: the last steps
    [m, rad] by range, None where the search was cut short before them. stopped: what cut it short, if so."""

    site: Site
    target: Target
    places: Mapping[Offset, Tried]
    steps: tuple[float, ...] | None
    stopped: str | None

    @property
    def present(self) -> Tried:
        """Where it stands now."""
        return self.places[self.site.present]

    @property
    def planned(self) -> bool:
        """Whether full plans are compared: of the present place, unless that cannot be done, and of another one."""
        any_plan = any(one.planned is not None for one in self.places.values() if one is not self.present)
        return any_plan and (self.present.planned is not None or self.present.first is None)

    def seconds(self, one: Tried) -> float | None:
        """What a place is compared by [s]."""
        return one.planned if self.planned else one.first

    @property
    def best(self) -> Tried | None:
        """The fastest place inside the ranges; the present one where none is faster by LEAST, None where none can be
        done."""
        known = [(seconds, one) for one in self.places.values() if (seconds := self.seconds(one)) is not None]
        inside = [pair for pair in known if self._inside(pair[1])]
        if not inside:
            return None
        best = min(inside, key=lambda pair: pair[0])
        now = self.seconds(self.present)
        stays = now is not None and best[0] > now - LEAST and self._inside(self.present)
        return self.present if stays else best[1]

    def _inside(self, one: Tried) -> bool:
        pairs = zip(self.site.ranges, one.offset, strict=True)
        return all(range_.low <= value <= range_.high for range_, value in pairs)

    @property
    def gained(self) -> float | None:
        """Seconds that the best place saves, None where the present one or none can be done."""
        now, best = self.seconds(self.present), self.best
        then = None if best is None else self.seconds(best)
        return None if now is None or then is None else now - then

    @property
    def impossible(self) -> list[Tried]:
        """The places that cannot be done, the nearest to the present one first."""
        widths = [one.width for one in self.site.ranges]

        def far(one: Tried) -> float:
            return math.hypot(*(value / width for value, width in zip(one.offset, widths, strict=True)))

        return sorted((one for one in self.places.values() if one.why), key=far)

    @property
    def in_words(self) -> str:
        """The answer in a line."""
        site, best = self.site, self.best
        if best is None:
            return f"{site.in_words}: no place in these ranges can be done"
        now, then = self.seconds(self.present), self.seconds(best)
        assert then is not None
        if best is self.present:
            return f"{site.in_words}: no place that was tried is faster than the present one, {then:.3f} s"
        where = f"{site.in_words} at {site.shown(best.offset)} from where it stands"
        if now is None:
            return f"{where}: {then:.3f} s; at the present place the program cannot be done"
        return f"{where}: {now:.3f} s → {then:.3f} s (−{100 * (now - then) / now:.1f} %)"

    @property
    def remarks(self) -> Iterator[str]:
        """How far the answer was looked for, and under what."""
        plans = sum(one.planned is not None for one in self.places.values())
        cell = self.site.job.cell_path
        yield f"{len(self.places)} places tried, {plans} of them planned, all under the limits of {cell}"
        if self.steps is not None:
            pairs = zip(self.site.ranges, self.steps, strict=True)
            steps = ", ".join(f"{one.key} {one.shown(step).lstrip('+')}" for one, step in pairs)
            yield f"resolution: no neighbour of the best is faster in steps of {steps}"
        at_end = [
            one.key
            for one, value in zip(self.site.ranges, () if self.best is None else self.best.offset, strict=False)
            if value in (one.low, one.high)
        ]
        if at_end:
            yield f"the best place lies at the end of the range of {', '.join(at_end)}: a wider one may gain more"
        if self.stopped is not None:
            what = "full plans" if self.planned else "first legal motions, which full plans shorten"
            yield f"{self.stopped}: the best found by then, compared by {what}"
        if self.present.why:
            yield f"at the present place: {self.present.why}"


def place(
    site: Site,
    target: Target,
    listen: Listener,
    patience: Patience,
    jobs: int | None = None,
    points: int | None = None,
) -> Placed:
    """The best place of what a site moves, on one target.

    points: of the coarse search. jobs: processes; the answer is the same for any number. patience: ends the search, and
    what was found by then is the answer.
    """
    search = _Search(site, target, listen, patience, jobs or cores(), {})
    design = spread(site.ranges, points or EACH * len(site.ranges))
    search.try_all([site.present], full=False)
    patience.answer()
    search.try_all(design, full=False)
    steps = None
    best = search.ranked()[:FEW]
    if best:
        search.try_all([site.present, *best], full=True)
        steps = search.around(points or EACH * len(site.ranges))
    stopped = patience.why() if patience.over else None
    return Placed(site, target, search.places, steps, stopped)


def spread(ranges: Sequence[Range], count: int) -> list[Offset]:
    """Places spread evenly over all ranges, their corners first: of one range even steps, of several the additive
    recurrence with the generalised golden ratio (M. Roberts, 2018, The unreasonable effectiveness of quasirandom
    sequences)."""
    d = len(ranges)
    if d == 1:
        return [(ranges[0].at(i / (count - 1)),) for i in range(max(2, count))] if count > 1 else [(ranges[0].at(0.5),)]
    ratio = 2.0
    for _ in range(60):
        ratio = (1 + ratio) ** (1 / (d + 1))
    shares: list[tuple[float, ...]] = list(product((0.0, 1.0), repeat=d))[:count]
    shares += [tuple((0.5 + n * ratio ** -(k + 1)) % 1 for k in range(d)) for n in range(count - len(shares))]
    return [tuple(one.at(share) for one, share in zip(ranges, point, strict=True)) for point in shares]


@dataclass(frozen=True, eq=False)
class _Search:
    """Places that are tried, in processes, as long as there is patience."""

    site: Site
    target: Target
    listen: Listener
    patience: Patience
    workers: int
    places: dict[Offset, Tried]

    def try_all(self, offsets: Sequence[Offset], full: bool) -> None:
        """Try places that were not tried so far, or were not planned where full plans are asked for."""
        known = self.places
        wanted = [
            one
            for one in dict.fromkeys(offsets)
            if one not in known or (full and not known[one].why and known[one].planned is None)
        ]
        count = 0

        def hear(_: Offset) -> None:
            nonlocal count
            count += 1
            if count % _TOLD == 0 or full or len(wanted) <= _TOLD:
                what = "planned" if full else "tried"
                self.listen("place", Progress(f"{count} of {len(wanted)} places {what}", self._least()))

        tasks = {one: partial(self._try, one, full) for one in wanted}
        for offset, tried in in_turns(tasks, hear, self.workers).items():
            if tried is not None:
                self.places[offset] = tried

    def _try(self, offset: Offset, full: bool, tell: Callable[[Offset], None]) -> Tried | None:
        """One place; None where there is no patience left. The present one is always tried, if not planned."""
        if self.patience.over and (full or any(offset)):
            return None
        out = tried(self.site, offset, self.target, self.patience if full else None, self.places.get(offset))
        tell(offset)
        return out

    def _least(self) -> float | None:
        plans = [one.planned for one in self.places.values() if one.planned is not None]
        firsts = [one.first for one in self.places.values() if one.first is not None]
        return min(plans or firsts, default=None)

    def ranked(self) -> list[Offset]:
        """The places that can be done, the most promising first."""
        known = [one for one in self.places.values() if one.first is not None and (one is not self._present)]
        return [one.offset for one in sorted(known, key=lambda one: score(one, self.target))]

    @property
    def _present(self) -> Tried:
        return self.places[self.site.present]

    def around(self, points: int) -> tuple[float, ...] | None:
        """Plan the neighbours of the best place in both ways of every range, in steps that halve where none of them is
        better; the last steps, None where patience ended before them."""
        ranges = self.site.ranges
        many = points ** (1 / len(ranges))
        steps = [one.width / many / 2 for one in ranges]
        least = [min(TURN if one.turns else RESOLUTION, one.width / 8) for one in ranges]
        while not self.patience.over:
            planned = [one for one in self.places.values() if one.planned is not None]
            if not planned:
                return None
            best = min(planned, key=lambda one: one.planned or math.inf)
            self.try_all(_neighbours(ranges, best.offset, steps), full=True)
            now = min(one.planned for one in self.places.values() if one.planned is not None)
            assert best.planned is not None
            if now > best.planned - LEAST:
                if all(step <= end for step, end in zip(steps, least, strict=True)):
                    return None if self.patience.over else tuple(steps)
                steps = [max(step / 2, end) for step, end in zip(steps, least, strict=True)]
        return None


def _neighbours(ranges: Sequence[Range], at: Offset, steps: Sequence[float]) -> list[Offset]:
    out = []
    for k, (one, step) in enumerate(zip(ranges, steps, strict=True)):
        for way in (-step, step):
            value = one.rounded(at[k] + way)
            if value != at[k]:
                out.append((*at[:k], value, *at[k + 1 :]))
    return out


def score(one: Tried, target: Target) -> float:
    """What places are ranked and drawn by [s]: of the RAPID controller the first motion, which is its plan; of a stream
    what the search foretells."""
    known = (one.planned or one.first, one.estimate)
    first, second = known if target is Target.RAPID else known[::-1]
    return first or second or math.inf


def tried(site: Site, offset: Offset, target: Target, patience: Patience | None, known: Tried | None = None) -> Tried:
    """One place: its first legal motion or, with patience, its full plan, judged. known: what is known of it."""
    from trajopt_cli.plan import NoCleanPlan, optimize, search_estimate

    try:
        job = site.at(offset)
        agreed = may_change(job, Loops.KEEP)
        if agreed.infeasible is not None:
            return _refused(offset, agreed.infeasible)
        changes = agreed.changes[target]
        limit = patience if patience is not None else Patience(0.0)
        plan = optimize(job.program, job.plant, target, bounded=False, changes=changes, patience=limit)
    except (InputError, NoCleanPlan) as no:
        return Tried(offset, why=str(no))
    if isinstance(plan, Infeasible):
        return _refused(offset, plan)
    rows = plan.own_rows
    judged = rows and known is not None and rows == known.rows  # and so legal
    if not judged and (illegal := why_illegal(job.plant, job.program, plan, target)) is not None:
        return Tried(offset, why=illegal[0], motion="" if illegal[1] is None else _line(illegal[1]))
    if known is None or known.estimate is None:
        known = Tried(offset, estimate=search_estimate(job.program, job.plant, target, changes))
    known = replace(known, rows=rows)
    if patience is None:
        return replace(known, first=plan.duration)
    return replace(known, planned=plan.duration, cut=patience.over)


def _refused(offset: Offset, no: Infeasible) -> Tried:
    return Tried(offset, why=str(no), motion=_line(no.source))


def _line(source: Source) -> str:
    return f"{Path(source.file).name}:{source.line}"
