"""Some legs of a motion at a time: what the nonlinear program is asked, so that its size and its failures stay local.

Where nothing is left to choose a problem falls into pieces, a cell without a rail into single legs. A short piece is
one window. A long one is covered by windows side by side, and by smaller ones over the borders between them. Both
ends of a window are held where, and as fast as, the motion at hand passes them: so one that finds something faster can
take the place of its part, and one that does not changes nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.collision.collision_scene import collision_scene_of
from trajopt_cli.path_timing.path_parameterized_plan import duration
from trajopt_cli.problem.objective import LeastEffort, Objective
from trajopt_cli.problem.problem import LegKind, Problem, Waypoint
from trajopt_cli.trajectories.iterate import Iterate

Span = tuple[int, int]  # waypoints: the first and the last


@dataclass(frozen=True, eq=False)
class Window:
    """The legs from waypoint first to waypoint last of a problem, as a problem of their own with held ends, and their
    motion at hand."""

    first: int
    last: int
    problem: Problem
    iterate: Iterate

    @classmethod
    def of(cls, problem: Problem, iterate: Iterate, span: Span) -> Window:
        """Of a whole problem and the motion at hand. The problem's own ends are as free as they are in it."""
        first, last = span
        points = list(problem.waypoints[first : last + 1])
        for k, i in ((0, first), (-1, last)):
            if 0 < i < len(problem.waypoints) - 1:
                points[k] = _held(problem, iterate, i)
        legs = tuple(replace(leg, start=leg.start - first) for leg in problem.legs[first:last])
        mine = iterate.part(range(first, last + 1), range(first, last))
        asked = _share(problem.objective, mine, iterate)
        own = replace(problem, waypoints=tuple(points), legs=legs, stations=(), ties=(), objective=asked)
        return cls(first, last, own, mine)

    def put(self, found: Iterate, iterate: Iterate) -> Iterate:
        """The whole motion with the window's part as found."""
        return iterate.put(range(self.first, self.last + 1), range(self.first, self.last), found)

    def key(self) -> bytes:
        """Equal for windows that ask for the same and have the same motion at hand."""
        problem, iterate = self.problem, self.iterate
        times = np.array([0.0 if motion is None else motion.T for motion in iterate.legs])
        given = problem.objective.seconds if isinstance(problem.objective, LeastEffort) else np.nan
        numbers = (iterate.q, iterate.qd, iterate.qd if iterate.qdd is None else iterate.qdd, times, np.array([given]))
        scene = collision_scene_of(problem)
        bodies = None if scene is None else [scene.scene(leg.motion) for leg in problem.legs]
        loads = [leg.load and leg.load.numbers for leg in problem.legs]
        asked = iterate.cfx, [leg.units for leg in problem.legs], loads, bodies
        parts = [(np.round(one, 12) + 0.0).tobytes() for one in numbers]  # -0 is 0
        return b"|".join([*parts, repr(asked).encode(), problem.key(0, len(problem.legs))])


def ends_held(problem: Problem, iterate: Iterate) -> Problem:
    """The problem with its first and its last waypoint where the motion at hand has them."""
    inner = problem.waypoints[1:-1]
    ends = (_held(problem, iterate, k) for k in (0, len(problem.legs)))
    return replace(problem, waypoints=(next(ends), *inner, next(ends)), ties=())


@dataclass(frozen=True, eq=False)
class Seam:
    """The legs around where a steady cycle ends and begins: those from waypoint last on, then those to waypoint first,
    as a problem of their own with held ends, and their motion at hand."""

    first: int
    last: int
    problem: Problem
    iterate: Iterate

    @classmethod
    def of(cls, problem: Problem, iterate: Iterate) -> Seam | None:
        """About as many as one window has; None where no waypoint may be an end."""
        n, half = len(problem.legs), problem.plant.settings.window_legs // 2
        first = _border_near(problem, 0, n, min(half, n // 2))
        if first is None:
            return None
        last = max((k for k in _possible_borders(problem, first - 1, n) if k <= max(n - half, first)), default=first)
        mine = iterate.part(*_around(n, first, last))
        asked = _share(problem.objective, mine, iterate)
        own = replace(problem.around_end(last, first), stations=(), objective=asked)
        return cls(first, last, ends_held(own, mine), mine)

    def put(self, found: Iterate, iterate: Iterate) -> Iterate:
        """The whole motion with these legs as found."""
        n = len(iterate.legs)
        out = iterate.put(*_around(n, self.first, self.last), found)
        return out.put([0], [], out.part([n], []))


def _around(n: int, first: int, last: int) -> tuple[list[int], list[int]]:
    """Waypoints and legs around where a cycle of n legs ends and begins."""
    return [*range(last, n + 1), *range(1, first + 1)], [*range(last, n), *range(first)]


def _share(asked: Objective, part: Iterate, whole: Iterate) -> Objective:
    """What is asked of a part: its own time, and its share of what the whole has to spare."""
    if not isinstance(asked, LeastEffort):
        return asked
    return LeastEffort(duration(part) * asked.seconds / duration(whole))


def _held(problem: Problem, iterate: Iterate, k: int) -> Waypoint:
    """Waypoint k where the motion passes it; its velocity is the iterate's."""
    return replace(problem.waypoints[k].standing(problem.layout, iterate.q[k]), q=iterate.q[k])


def pieces(problem: Problem) -> list[Span]:
    """The parts between waypoints where nothing is left to choose, in order."""
    marks = [k for k in range(len(problem.waypoints)) if _pinned(problem, k)]
    return list(pairwise(sorted({0, *marks, len(problem.waypoints) - 1})))


def _pinned(problem: Problem, k: int) -> bool:
    stop = problem.waypoints[k]
    if problem.passes(k):
        return False
    return stop.q is not None or (not stop.free and stop.turn is None and problem.rests(k))


def red_black(problem: Problem) -> tuple[list[Span], list[Span]]:
    """Windows that cover the whole problem, none over another, and such as lie over the borders inside long pieces; in
    order. Those of one colour can be solved in any order, or at once."""
    red: list[Span] = []
    black: list[Span] = []
    for first, last in pieces(problem):
        borders = [first, *_borders(problem, first, last), last]
        red += pairwise(borders)
        middles = [k for a, b in pairwise(borders) if (k := _middle(problem, a, b)) is not None]
        black += [_over_borders(problem, borders, *one) for one in pairwise(middles)]
    return red, black


def _borders(problem: Problem, first: int, last: int) -> Iterator[int]:
    """Where a piece is cut into windows of about one size, none of more than WINDOW legs where there may be borders."""
    settings = problem.plant.settings
    at = first
    while (count := -(-(last - at) // settings.window_legs)) > 1:
        border = _border_near(problem, at, min(last, at + settings.window_legs + 1), at + (last - at) / count)
        if border is None:
            border = min(_possible_borders(problem, at + settings.window_legs, last), default=None)
        if border is None:
            break
        yield border
        at = border


def _over_borders(problem: Problem, borders: list[int], first: int, last: int) -> Span:
    """Within a span, the legs beside the borders in it: about OVERLAP of them, for one farther away changes little."""
    settings = problem.plant.settings
    inside = [k for k in borders if first < k < last]
    low, high = inside[0] - settings.window_overlap / 2, inside[-1] + settings.window_overlap / 2
    near = [k for k in _possible_borders(problem, first, last) if low <= k <= high]
    return (
        first if first >= low else min((k for k in near if k < inside[0]), default=first),
        last if last <= high else max((k for k in near if k > inside[-1]), default=last),
    )


def _middle(problem: Problem, a: int, b: int) -> int | None:
    """A border about in the middle between waypoints a and b, None where there is none."""
    return min(_possible_borders(problem, a, b), key=lambda k: abs(k - (a + b) / 2), default=None)


def _border_near(problem: Problem, a: int, b: int, wanted: float) -> int | None:
    """The waypoint between a and b, both left out, that is nearest to where a border is wanted; rather one in front of
    a joint move, where configurations meet. None where none may be a border."""

    def cost(k: int) -> float:
        settings = problem.plant.settings
        return abs(k - wanted) + settings.window_legs / 6 * (problem.legs[k].kind is not LegKind.JOINT)

    return min(_possible_borders(problem, a, b), key=cost, default=None)


def _possible_borders(problem: Problem, a: int, b: int) -> list[int]:
    """The waypoints between a and b, both left out, that may be borders."""
    return [k for k in range(a + 1, b) if not problem.passes(k)]
