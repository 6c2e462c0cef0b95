"""What the optimiser gives back: motions with their times, the whole trajectory, and how much is left at most."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from hashlib import sha256

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.motion import Source
from trajopt_cli.trajectory import Trajectory


class Target(StrEnum):
    """Which machine executes the plan: the RAPID controller itself, which every ABB cell has, or one that follows a
    stream of joint positions. In the order in which answers name them."""

    RAPID = "rapid"
    STREAM = "stream"

    @property
    def first(self) -> tuple[Target, Target]:
        """Both, this one first."""
        return self, Target.RAPID if self is Target.STREAM else Target.STREAM

    @property
    def in_words(self) -> str:
        """What a stranger reads of its plan, as in titles of pictures."""
        if self is Target.STREAM:
            return "stream plan, for a machine that follows joint positions"
        return "RAPID plan, for the controller that runs the program"


@dataclass(frozen=True, eq=False)
class Via:
    """An additional point. q (k,): all axes. radius: of the fly-by [m], one of detours.radii(); None for a stop."""

    q: Array
    radius: float | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "q", readonly(self.q))


@dataclass(frozen=True, eq=False)
class Detour:
    """A way around. motion: before which one of Program.motions its points are, in order. around: names of the bodies
    that are in the straight way, at least one."""

    motion: int
    points: tuple[Via, ...]
    around: tuple[str, ...]

    def __post_init__(self) -> None:
        if not self.points or not self.around:
            raise ValueError(f"detour of motion {self.motion}: wanted at least one point and one name")


@dataclass(frozen=True, eq=False)
class Passing:
    """An additional point of a motion as planned: t [s] when it is reached, q (k,) all axes there, binding: the limit
    that holds the way to it back."""

    t: float
    q: Array
    binding: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "q", readonly(self.q))


@dataclass(frozen=True, eq=False)
class PlannedMotion:
    """One motion of the program as planned.

    index: its place in Program.motions. t_0, t_1: start and end [s]. q_0, q_1: axis positions (k,) at both. binding:
    the limit that holds the motion back ("joint_1 acceleration", "programmed TCP speed", "programmed duration"), or
    "settling".
    dropped: the user allowed it and the plan leaves it out; then t_0 = t_1. via: the points that are added on its way.
    """

    index: int
    source: Source
    t_0: float
    t_1: float
    q_0: Array
    q_1: Array
    binding: str
    dropped: bool = False
    via: tuple[Passing, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "q_0", readonly(self.q_0))
        object.__setattr__(self, "q_1", readonly(self.q_1))


@dataclass(frozen=True)
class Strain:
    """How hard a motion drives its axes: effort [s], see problem.objective; how far the rail goes in all [m]."""

    effort: float
    rail_way: float


@dataclass(frozen=True)
class Eased:
    """Of a plan of least effort: the least time found [s], and the strain of that motion and of the plan."""

    least_time: float
    fastest: Strain
    planned: Strain


MOST_GAP = 1.0
"""Gap beyond which a plan is suspicious: first legal plans of random programs have up to a third of this."""

MOST_TIMES = 2.0
"""Times the search's estimate beyond which a plan is suspicious: those take 0.6 to 1.1 times as long."""


@dataclass(frozen=True, eq=False)
class Plan:
    """A motion for the whole program on one target.

    lower_bound: no legal motion of this target's model is faster [s], None where none was asked for.
    grid: intervals per motion the optimiser ended with, for the printed duration. seconds: time spent per phase.
    notes: where the plan came by another way than hoped, one line each. eased: where the least effort was asked for.
    estimate: what the route takes that the search began with [s], None where there was no search.
    stopped: the search was; bound_cut: the time for the bound was over before it was all that can be proved.
    detours: the ways around bodies. motions are the program's own, each from its start to its end with its points.
    turns: by how much [rad] targets are turned about the tool's axis, by motion.
    """

    target: Target
    trajectory: Trajectory
    motions: tuple[PlannedMotion, ...]
    lower_bound: float | None
    grid: str
    seconds: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    eased: Eased | None = None
    detours: tuple[Detour, ...] = ()
    estimate: float | None = None
    stopped: bool = False
    bound_cut: bool = False
    turns: Mapping[int, float] = field(default_factory=dict)

    @property
    def duration(self) -> float:
        """Cycle time [s], programmed waits included."""
        return self.trajectory.duration

    @property
    def gap(self) -> float | None:
        """(least time found - lower_bound) / lower_bound: how much faster a motion of the same model could be at most;
        0 where nothing takes any time."""
        least = self.duration if self.eased is None else self.eased.least_time
        if self.lower_bound is None or least == self.lower_bound:
            return None if self.lower_bound is None else 0.0
        return (least - self.lower_bound) / self.lower_bound

    @property
    def own_rows(self) -> str:
        """A digest of the rows of a plan that drives the program as it stands, by which equal ones are known; empty
        where the plan leads around something or leaves something out."""
        if self.detours or any(motion.dropped for motion in self.motions):
            return ""
        whole, found = self.trajectory.whole, sha256()
        for array in (whole.t, whole.q, whole.qd):
            found.update(b"none" if array is None else np.ascontiguousarray(array).data)
        return found.hexdigest()

    @property
    def suspicion(self) -> str | None:
        """Why the plan is suspiciously slow, in words; None where it is not."""
        least = self.duration if self.eased is None else self.eased.least_time
        if self.gap is not None and self.gap > MOST_GAP and not self.bound_cut:
            return f"it takes {least / max(self.lower_bound or 0.0, 1e-9):.3g} times its lower bound"
        if self.estimate is not None and least > MOST_TIMES * self.estimate:
            return f"it takes {least / max(self.estimate, 1e-9):.3g} times what the search estimated"
        return None


@dataclass(frozen=True)
class NoPlan:
    """The solver failed on a program that can be done, or was stopped: neither an answer nor the user's mistake. label:
    what was being solved, a target or a baseline."""

    label: str
    message: str
    stopped: bool = False


@dataclass(frozen=True)
class Infeasible:
    """The answer no: which motion cannot be done, where on it, and the limit that forbids it (message, one line).

    index: its place in Program.motions. source: its place in the program, which message leaves out; str() is the line
    to print, with both. spare: how much farther apart than wanted bodies are that are refused for the planner's reserve
    alone [m], else 0 or less.
    """

    index: int
    source: Source
    message: str
    spare: float = 0.0

    def __str__(self) -> str:
        return f"{self.source}: {self.message}"
