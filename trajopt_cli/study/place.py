"""`place`: where the robot's base, its rail or a work object should stand for the shortest cycle, by search over plans.

From the present place on, which is planned first: coarsely over points spread evenly in the ranges, each by a first
legal motion; then by full plans at the best of them and, in steps that halve, around the best; as long as that pays.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import product
from pathlib import Path

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Source
from trajopt_cli.pipeline.planning import Listener, may_change
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.study.answers import plan_of, why_illegal
from trajopt_cli.study.places import Offset, Range, Site
from trajopt_cli.units import DEG
from trajopt_cli.workers import cores, shared_out

EACH = 30
"""Points of the coarse search for each range."""
FEW = 4
"""Best points of the coarse search that are planned."""
RESOLUTION, TURN = 0.01, 2 * DEG
"""m and rad: the last steps around the best place are no longer than that."""
PAYS = 1e-3
"""Share of the cycle time that further places have to gain, or the search ends."""
_BATCH = 10  # places at least between two looks at whether the coarse search pays
LEAST = 5e-4
"""s by which a place has to be better than another one to be preferred."""
_WRITING = 1.0  # s of drawing and writing the answer
_TOLD = 5  # places between two words of progress


@dataclass(frozen=True)
class Tried:
    """One place. first: of its first legal motion [s]; estimate: of the best route that the search finds [s], which
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
    [m, rad] by range, None where the search was cut short before them. stopped: what cut it short, if so; ended: after
    which rules it ended by itself before all places."""

    site: Site
    target: Target
    places: Mapping[Offset, Tried]
    steps: tuple[float, ...] | None
    stopped: str | None
    ended: tuple[str, ...] = ()

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
        yield from self.ended
        if self.stopped is not None:
            what = "full plans" if self.planned else "first legal motions, which full plans shorten"
            yield f"{self.stopped}: the best found by then, compared by {what}"
        if self.present.why:
            yield f"at the present place: {self.present.why}"


def place(
    site: Site, target: Target, listen: Listener, patience: Patience, jobs: int | None = None, points: int | None = None
) -> Placed:
    """The best place of what a site moves, on one target.

    points: of the coarse search. jobs: processes; the answer is the same for any number. patience: ends the search, and
    what was found by then is the answer.
    """
    search = _Search(site, target, listen, patience, jobs or cores(), {})
    count = points or EACH * len(site.ranges)
    patience.reserve(_WRITING * patience.load)
    search.try_all([site.present], False, patience)
    patience.answer()
    search.try_all([site.present], True, patience.part(0.25))
    search.coarsely(spread(site.ranges, count))
    steps = None
    best = search.ranked()[:FEW]
    if best:
        search.try_all([site.present, *best], True, patience.part(0.5))
        steps = search.around(count)
    stopped = patience.why() if patience.over or search.cut else None
    return Placed(site, target, search.places, steps, stopped, tuple(search.ended))


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
    """Places that are tried, in processes, as long as there is patience; cut: those that there was none for."""

    site: Site
    target: Target
    listen: Listener
    patience: Patience
    workers: int
    places: dict[Offset, Tried]
    ended: list[str] = field(default_factory=list)
    cut: list[Offset] = field(default_factory=list)

    def coarsely(self, design: Sequence[Offset]) -> None:
        """Try the first legal motion at these places, the most different ones first, as long as that pays."""
        steps = 4 if len(self.site.ranges) == 1 else 1  # those of several ranges are in such an order
        order = [one for first in range(steps) for one in design[first::steps]]
        size, half = max(_BATCH, len(order) // 3), self.patience.part(0.5)
        for first in range(0, len(order), size):
            before, some = self._foretold(), order[first : first + size]
            self.try_all(some, full=False, patience=half)
            left = 0 if self.cut else len(order) - first - size
            if left > 0 and before - self._foretold() < PAYS * before < math.inf:
                self.ended.append(
                    f"the coarse search ended {left} places early: its last {len(some)} gained less than {PAYS:.1%}"
                )
                return

    def _foretold(self) -> float:
        """What the most promising place promises [s]."""
        return min((score(one, self.target) for one in self.places.values() if one.first is not None), default=math.inf)

    def try_all(self, offsets: Sequence[Offset], full: bool, patience: Patience) -> None:
        """Try places that were not tried so far, or were not planned where full plans are asked for."""
        known = self.places
        wanted = [
            one
            for one in dict.fromkeys(offsets)
            if one not in known or (full and not known[one].why and known[one].planned is None)
        ]
        count = 0
        now = known.get(self.site.present)
        today = None if now is None else now.planned or now.first
        least = min((T for one in known.values() if (T := self._comparable(one))), default=today)

        def hear(one: Tried) -> None:
            nonlocal count, least
            count += 1
            least = min((T for T in (least, self._comparable(one)) if T), default=None)
            if count % _TOLD == 0 or full or len(wanted) <= _TOLD:
                saved = f", {today - least:.3f} s less than today's" if today and least and least < today else ""
                what = "planned" if full else "tried"
                self.listen("place", Progress(f"{count} of {len(wanted)} places {what}{saved}", least))

        tasks = {
            one: partial(self._try, one, full, patience.part(self.workers / (len(wanted) - i)) if full else patience)
            for i, one in enumerate(wanted)
        }
        for offset, tried in shared_out(tasks, hear, self.workers).items():
            if tried is None:
                self.cut.append(offset)
            else:
                self.places[offset] = tried

    def _comparable(self, one: Tried) -> float | None:
        """What progress tells of a place [s]: its plan, which the RAPID controller's first motion nearly is."""
        return one.planned or (one.first if self.target is Target.RAPID else None)

    def _try(self, offset: Offset, full: bool, patience: Patience, tell: Callable[[Tried], None]) -> Tried | None:
        """One place; None where there is no patience left. The present one is always tried, if not planned."""
        if patience.over and (full or any(offset)):
            return None
        try:
            with patience.cutting():
                out = tried(self.site, offset, self.target, patience if full else None, self.places.get(offset))
        except Stopped:
            return None
        if out.first is not None:
            self.patience.settle()
        tell(out)
        return out

    def ranked(self) -> list[Offset]:
        """The places that can be done, the most promising first."""
        known = [one for one in self.places.values() if one.first is not None and (one is not self._present)]
        return [one.offset for one in sorted(known, key=lambda one: score(one, self.target))]

    @property
    def _present(self) -> Tried:
        return self.places[self.site.present]

    def around(self, points: int) -> tuple[float, ...] | None:
        """Plan the neighbours of the best place in both ways of every range, in steps that halve where none of them is
        better, as long as that pays; the last steps, None where patience ended before them.

        Where no neighbour is better and all are hardly worse, no smaller step would gain more than they lose if cycle
        times are convex in the place.
        """
        ranges = self.site.ranges
        many = points ** (1 / len(ranges))
        steps = [one.width / many / 2 for one in ranges]
        least = [min(TURN if one.turns else RESOLUTION, one.width / 8) for one in ranges]
        while not self.patience.over:
            planned = [one for one in self.places.values() if one.planned is not None]
            if not planned:
                return None
            best = min(planned, key=lambda one: one.planned or math.inf)
            near = _neighbours(ranges, best.offset, steps)
            self.try_all(near, True, self.patience)
            now = min(one.planned for one in self.places.values() if one.planned is not None)
            assert best.planned is not None
            if now > best.planned - LEAST:
                if all(step <= end for step, end in zip(steps, least, strict=True)):
                    return None if self.patience.over else tuple(steps)
                beside = [one.planned for place in near if (one := self.places.get(place)) is not None]
                worst = max((T or math.inf for T in beside), default=math.inf)
                if len(beside) == len(near) and worst - best.planned < PAYS * best.planned:
                    self.ended.append(f"the search ended where all neighbours are within {PAYS:.1%} of the best place")
                    return tuple(steps)
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
    from trajopt_cli.plan import NoCleanPlan, search_estimate

    try:
        job = site.at(offset)
        agreed = may_change(job, Loops.KEEP)
        if agreed.infeasible is not None:
            return _refused(offset, agreed.infeasible)
        changes = agreed.changes[target]
        plan = plan_of(job, target, changes, patience)
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
