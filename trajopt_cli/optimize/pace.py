"""How fast a run's course may be driven: TOPP under all limits, then tightened where a dense check finds an excess."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.optimize.axes import Axes, Caps
from trajopt_cli.optimize.course import Along, Course, Part, finer
from trajopt_cli.optimize.exchange import Ratios, check_legs
from trajopt_cli.optimize.legs import JointNodes, PathLeg, Pieces
from trajopt_cli.optimize.tuning import (
    BEYOND,
    LEAST_FELT,
    LED,
    LOST,
    PACE_ROUNDS,
    RESOLVED,
    SAFE,
    START,
    STEEP,
    TOOL_DIRECTIONS,
)
from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path.joint_move import JointMove
from trajopt_cli.problem.problem import Leg, Problem
from trajopt_cli.timing.law import TimeLaw
from trajopt_cli.timing.retiming import fastest_laws

_RANGE = 1 + 1e-6  # share of half an axis' range that a course may reach
_ANGLES = (np.arange(TOOL_DIRECTIONS) + 0.5) * np.pi / TOOL_DIRECTIONS - np.pi / 2


class Unresolved(Exception):
    """A course passes so near a singularity that no rate is low enough: leg, its number; q (n,), axes there."""

    def __init__(self, leg: int, q: Array):
        super().__init__(leg, q)
        self.leg, self.q = leg, q


@dataclass
class Shares:
    """Of each limit, what an interval (N,) of a course may use: axes' and tool's speed, axes' and tool's
    acceleration."""

    speed: Array
    tool_speed: Array
    acceleration: Array
    tool_acceleration: Array

    @classmethod
    def full(cls, N: int) -> Shares:
        """All but a hair."""
        return cls(*(np.full(N, START) for _ in range(4)))

    def tighten(self, at: slice, used: Shares, speed: Array, acceleration: Array, tool: Array) -> bool:
        """Less for the intervals of a leg whose worst ratios (m,), (m, 3) exceed what is safe; True when any did.

        used: what the law uses at the nodes, which is tightened, for what it leaves it would not miss.
        """
        changed = False
        for share, use, ratio in (
            (self.speed, used.speed, speed),
            (self.acceleration, used.acceleration, acceleration),
            (self.tool_speed, used.tool_speed, np.maximum(tool[:, 0], tool[:, 2])),
            (self.tool_acceleration, used.tool_acceleration, tool[:, 1]),
        ):
            over = ratio > SAFE
            felt = np.clip(use[at], share[at] * LEAST_FELT, share[at])
            share[at][over] = felt[over] * (SAFE - BEYOND) / ratio[over]
            changed |= bool(over.any())
        return changed


def top_rate(caps: Caps, along: Along) -> tuple[Array, Array]:
    """The greatest rates of sigma (m,) that axes and that tool allow at places, or at all of them under one cap."""
    with np.errstate(divide="ignore"):
        joints = np.min(caps.velocity / np.abs(along.dq), axis=-1)
        speed, turning = (np.linalg.norm(x, axis=-1) for x in (along.v, along.w))
        tool = np.minimum(caps.v_tcp / speed, caps.v_ori / turning)
    return joints, tool


def columns(caps: Caps, along: Along) -> tuple[Array, Array]:
    """Slopes and bends (m, c) of what is limited at places: |slope u + bend x| <= 1 with u the second derivative of
    sigma and x its squared rate. Axes first, then the tool's acceleration in the directions of a half circle; its limit
    is a circle, around which they are drawn."""
    size = np.linalg.norm(along.v, axis=-1, keepdims=True)
    ahead = along.v / np.maximum(size, 1e-12)
    forward = np.sum(along.bend * ahead, axis=-1, keepdims=True)
    aside = np.linalg.norm(along.bend - forward * ahead, axis=-1, keepdims=True)
    c, s = (of(_ANGLES) / caps.a_tcp[:, None] for of in (np.cos, np.sin))
    slopes = np.concatenate([along.dq / caps.acceleration, size * c], axis=-1)
    return slopes, np.concatenate([along.ddq / caps.acceleration, forward * c + aside * s], axis=-1)


def limits(axes: Axes, problem: Problem, course: Course) -> tuple[Array, Array, Array]:
    """top_rate and columns at all nodes of a course: (rows, 2), (rows, c), (rows, c)."""
    legs = np.repeat([part.leg for part in course.parts], course.counts + 1)
    caps = axes.caps(problem.legs[: legs[-1] + 1]).at(legs)
    return np.column_stack(top_rate(caps, course.along)), *columns(caps, course.along)


def used_by(axes: Axes, problem: Problem, course: Course, law: TimeLaw) -> Shares:
    """What a law uses of each limit at the ends of every interval."""
    tops, slopes, bends = limits(axes, problem, course)
    x = law.rates**2
    u = np.diff(x) / (2 * np.diff(course.sigma))
    most = [np.zeros((len(u), 2)), np.zeros((len(u), slopes.shape[1]))]
    for row, rate in ((course.first, law.rates[:-1]), (course.first + 1, law.rates[1:])):
        most[0] = np.maximum(most[0], rate[:, None] / tops[row])
        most[1] = np.maximum(most[1], np.abs(slopes[row] * u[:, None] + bends[row] * rate[:, None] ** 2))
    speed, acceleration = most
    return Shares(
        speed[:, 0], speed[:, 1], acceleration[:, : axes.n].max(axis=1), acceleration[:, axes.n :].max(axis=1)
    )


def in_force(
    axes: Axes, problem: Problem, course: Course, shares: Shares
) -> tuple[Array, tuple[Array, Array], tuple[Array, Array]]:
    """The greatest rates (N+1,) at the nodes of a course, and slopes and bends (N, c) of what is limited where each
    interval begins and where it ends."""
    N = len(course.part)
    tops, slopes, bends = limits(axes, problem, course)
    give = np.column_stack([np.repeat(shares.acceleration[:, None], axes.n, 1),
                            np.repeat(shares.tool_acceleration[:, None], TOOL_DIRECTIONS, 1)])  # fmt: skip
    a, b = course.first, course.first + 1
    allowed = np.column_stack([shares.speed, shares.tool_speed])
    top = np.full(N + 1, np.inf)
    top[:-1] = np.min(tops[a] * allowed, axis=1)
    top[1:] = np.minimum(top[1:], np.min(tops[b] * allowed, axis=1))
    begins, ends = ((slopes[i] / give, bends[i] / give) for i in (a, b))
    return top, begins, ends


def law_of(axes: Axes, problem: Problem, course: Course, shares: Shares) -> TimeLaw | None:
    """The fastest law of a run's course, from rest to rest; None where there is none."""
    top, *rows = in_force(axes, problem, course, shares)
    begins, ends = ((slopes[None], bends[None]) for slopes, bends in rows)
    return fastest_laws(course.sigma[None], top[None], begins, ends, 0.0, 0.0).law(0)


Pace = Callable[[Axes, Problem, Course, Shares], TimeLaw | None]


def clean(axes: Axes, problem: Problem, course: Course, pace: Pace = law_of) -> dict[int, Pieces] | None:
    """The motions of a run's legs, fastest on its course (or as another pace wants) and within every limit wherever it
    is looked at; None where the course itself leaves the axes' ranges, or no law is found. Raises Unresolved."""
    resolved = _resolved(axes, problem, course)
    if resolved is None:
        return None
    course, shares = resolved, Shares.full(len(resolved.part))
    checked: dict[int, Ratios] = {}
    before: Array | None = None
    for _ in range(PACE_ROUNDS):
        law = pace(axes, problem, course, shares)
        if law is None:
            return None
        legs = motions(axes, problem, course, law)
        spans = {k: slice(*np.searchsorted(course.leg, (k, k + 1))) for k in legs}
        # what a round tightens is felt nearby only: a leg driven as before is what it was
        new = [
            k
            for k, at in spans.items()
            if before is None or not np.array_equal(law.rates[at.start : at.stop + 1], before[at.start : at.stop + 1])
        ]
        found = check_legs(axes, [problem.legs[k] for k in new], [legs[k] for k in new])
        checked |= dict(zip(new, found, strict=True))
        changed, used, before = False, used_by(axes, problem, course, law), law.rates
        for k, ratios in checked.items():
            if ratios.position.max() > _RANGE:
                return None
            changed |= shares.tighten(
                spans[k],
                used,
                ratios.velocity.max(axis=1),
                ratios.acceleration.max(axis=1),
                ratios.tool,
            )
        if not changed:
            return legs
    return None


def _resolved(axes: Axes, problem: Problem, course: Course) -> Course | None:
    """The course on nodes so close that what happens at one says what happens up to the next: the rate at which it may
    be driven changes little, and the axes go where their slopes lead. Beside a singularity that takes many.

    Raises Unresolved where no nodes are close enough: the course passes a singularity.
    """
    for _ in range(RESOLVED):
        wanted, _ = _steep(axes, problem, course)
        if not wanted.any():
            return course
        found = finer(axes, problem, course, wanted)
        if found is None:
            return None
        course = found
    _, lost = _steep(axes, problem, course)
    if lost.any():
        i = int(np.argmax(lost))
        raise Unresolved(int(course.leg[i]), course.along.q[course.first[i]])
    return course


def _steep(axes: Axes, problem: Problem, course: Course) -> tuple[BoolArray, BoolArray]:
    """Which intervals (N,) want a node in the middle, and which say nothing of what happens in them."""
    top = np.min(limits(axes, problem, course)[0], axis=1)
    row, along = course.first, course.along
    low, high = np.minimum(top[row], top[row + 1]), np.maximum(top[row], top[row + 1])
    step = np.diff(course.sigma)[:, None]
    led = np.abs(along.q[row + 1] - along.q[row] - step * (along.dq[row] + along.dq[row + 1]) / 2).max(axis=1)
    return (high > STEEP * low) | (led > LED), led > LOST


def motions(axes: Axes, problem: Problem, course: Course, law: TimeLaw) -> dict[int, Pieces]:
    """The motions of a run's legs under a law, by leg."""
    out: dict[int, list[PathLeg | JointNodes]] = {}
    edges = np.concatenate([[0], np.cumsum(course.counts)])
    for i, part in enumerate(course.parts):
        here = slice(edges[i], edges[i + 1] + 1)
        row = edges[i] + i
        q = course.along.q[row : row + part.N + 1]
        dq = course.along.dq[row : row + part.N + 1]
        out.setdefault(part.leg, []).append(
            _piece(axes, problem.legs[part.leg], part, q, dq, law.times[here], law.rates[here])
        )
    return {k: Pieces(tuple(pieces)) for k, pieces in out.items()}


def _piece(axes: Axes, leg: Leg, part: Part, q: Array, dq: Array, times: Array, rates: Array) -> PathLeg | JointNodes:
    """One part in scaled time, from when and how fast (N+1,) its nodes are passed."""
    T = float(times[-1] - times[0])
    grid = (times - times[0]) / T
    grid[-1] = 1.0
    if isinstance(part.segment, JointMove | JointCorner):
        v = dq * (rates * T)[:, None]
        return JointNodes(T, grid, q, v, np.diff(v, axis=0) / np.diff(grid)[:, None])
    assert part.rail is not None
    rate = rates * T / part.size  # of the part's share by scaled time
    way = part.s_1 - part.s_0
    d, dd, _ = part.rail.at(part.u)
    w = dd * rate[:, None]
    steps = np.diff(grid)
    return PathLeg(
        T, part.segment, leg.X_FT, part.cfx, q[0, axes.layout.arm], grid, part.own(part.u), way * rate,
        way * np.diff(rate) / steps, d, w, np.diff(w, axis=0) / steps[:, None],
    )  # fmt: skip
