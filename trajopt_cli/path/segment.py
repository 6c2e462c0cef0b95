"""What every kind of segment offers: numbers, and for the nonlinear program expressions. One file per kind.

The path parameter s goes from 0 at a segment's start to 1 at its end, and every derivative is by s. Lengths in m and
angles in rad belong to the whole segment.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from trajopt_cli.geometry import Array, IndexArray, readonly

if TYPE_CHECKING:
    from trajopt_cli.path.symbols import Symbols

POINT = 1e-9  # m, rad: no path at all
_NO_BREAKS: Array = readonly(np.zeros(0))
_ENDS = np.array([0.0, 1.0])

Batch = Callable[[Sequence["Segment"], IndexArray, Array], tuple[Array, Array, Array]]


class Segment(ABC):
    """A path of the tool. Poses X_AT are seen from one frame A, the world unless the maker chose another.

    The tool's position and orientation are continuous over [0, 1], and their first derivatives, too. Their second ones
    may jump at the breaks; there they are the ones of what follows. is_corner: it replaces the ends of two others.
    """

    is_corner: ClassVar[bool] = False

    @property
    @abstractmethod
    def length(self) -> float:
        """Of the tool centre point's path [m]."""

    @property
    @abstractmethod
    def angle(self) -> float:
        """Reorientation [rad], summed up; turns back count, too."""

    @abstractmethod
    def pose(self, s: Array) -> Array:
        """X_AT (n, 4, 4) at s (n,)."""

    @abstractmethod
    def twist(self, s: Array) -> Array:
        """First derivative (n, 6) by s: dp/ds [m] and the rate of turning [rad], both in the axes of A."""

    @abstractmethod
    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6) by s: that of the twist."""

    @property
    def breaks(self) -> Array:
        """Where inside (0, 1) a second derivative may jump, s (m,), ascending."""
        return _NO_BREAKS

    @property
    def radius(self) -> float:
        """The largest radius of curvature anywhere on it [m], inf where it is straight."""
        return np.inf

    @property
    def straight(self) -> bool:
        """Whether the tool centre point stays on a line, or rests."""
        return bool(np.isinf(self.radius))

    @property
    def evenly_turned(self) -> bool:
        """Whether the tool turns at a constant rate."""
        return True

    @property
    def even_turns(self) -> tuple[Array, Array] | None:
        """What turns evenly on it, about axes (3,) of the poses' frame and of the tool's own [rad]; None where a corner
        beside it has no expression."""
        return None

    @property
    def unclear(self) -> tuple[str, str] | None:
        """What its program leaves open, and what to do about it, in words."""
        return None

    @property
    def fastest_turn(self) -> float:
        """The highest rate of turning by s [rad]."""
        return self.angle

    @property
    def on_work(self) -> Segment:
        """As the work object sees it, for which speeds are programmed; only their sizes are comparable."""
        return self

    @cached_property
    def numbers(self) -> Array:
        """Equal (up to rounding) for the same path, different for others: its ends, and what a kind has besides."""
        return self.pose(_ENDS).ravel()

    @property
    def batch(self) -> Batch:
        """What evaluates many such segments at once: poses (m, 4, 4), twists and their rates (m, 6) of segments at
        s (m,), each on the one with its number of (m,)."""
        return _one_by_one

    def between(self, s_0: float, s_1: float) -> Segment:
        """The part of it from s_0 to s_1, with an s of its own from 0 to 1.

        Raises:
            NotImplementedError: no segment of its kind is a part of it.
        """
        raise NotImplementedError(f"{type(self).__name__} has no parts")

    @property
    def symbols(self) -> Symbols:
        """The flange on it as an expression: equal for segments that one compiled block serves."""
        raise NotImplementedError(f"{type(self).__name__} has no expression")

    def parameters(self, X_BA: Array, X_FT: Array) -> Array:
        """The parameters (size,) of that expression for a tool X_FT; X_BA (4, 4): frame A seen from the arm's base."""
        raise NotImplementedError(f"{type(self).__name__} has no expression")


class JointSegment(ABC):
    """A path of k axes [m, rad] in their own space; where the tool is on it only the robot knows."""

    is_corner: ClassVar[bool] = False
    breaks: ClassVar[Array] = _NO_BREAKS

    @abstractmethod
    def axes(self, s: Array) -> Array:
        """Axis positions (n, k) at s (n,)."""

    @abstractmethod
    def rate(self, s: Array) -> Array:
        """First derivative (n, k) by s."""

    @abstractmethod
    def rate_change(self, s: Array) -> Array:
        """Second derivative (n, k) by s."""


def _one_by_one(segments: Sequence[Segment], of: IndexArray, s: Array) -> tuple[Array, Array, Array]:
    X, twist, rate = np.empty((len(s), 4, 4)), np.empty((len(s), 6)), np.empty((len(s), 6))
    for i, segment in enumerate(segments):
        at = np.flatnonzero(of == i)
        X[at], twist[at], rate[at] = segment.pose(s[at]), segment.twist(s[at]), segment.twist_rate(s[at])
    return X, twist, rate


def along_all(segments: Sequence[Segment], s: Sequence[Array]) -> tuple[Array, Array, Array]:
    """Pose, twist and its rate of segments at s (n,) of each, one after the other: (m, 4, 4), (m, 6), (m, 6)."""
    every = np.concatenate(s)
    number = np.repeat(np.arange(len(segments)), [len(one) for one in s])
    groups: dict[Batch, dict[int, Segment]] = {}
    for segment in {id(one): one for one in segments}.values():
        groups.setdefault(segment.batch, {})[id(segment)] = segment
    if len(groups) == 1:
        ((batch, own),) = groups.items()
        place = {name: i for i, name in enumerate(own)}
        return batch([*own.values()], np.array([place[id(one)] for one in segments], dtype=np.intp)[number], every)
    X, twist, rate = np.empty((len(every), 4, 4)), np.empty((len(every), 6)), np.empty((len(every), 6))
    for batch, own in groups.items():
        place = {name: i for i, name in enumerate(own)}
        of = np.array([place.get(id(one), -1) for one in segments], dtype=np.intp)[number]
        at = np.flatnonzero(of >= 0)
        X[at], twist[at], rate[at] = batch([*own.values()], of[at], every[at])
    return X, twist, rate


def over_work(segments: Sequence[Segment], s: Sequence[Array], twist: Array, rate: Array) -> tuple[Array, Array]:
    """What the tool's caps hold for: the twists and their rates (m, 6) of segments at s (n,) of each, one after the
    other, against the work object where that turns, as given elsewhere."""
    if all(segment.on_work is segment for segment in segments):
        return twist, rate
    twist, rate, first = twist.copy(), rate.copy(), 0
    for segment, own in zip(segments, s, strict=True):
        at = slice(first, first + len(own))
        if segment.on_work is not segment:
            twist[at], rate[at] = segment.on_work.twist(own), segment.on_work.twist_rate(own)
        first += len(own)
    return twist, rate


def check_fractions(*fractions: float) -> None:
    """Refuse what is no part of a segment.

    Raises:
        ValueError: a fraction is not in (0, 1].
    """
    for one in fractions:
        if not 0 < one <= 1:
            raise ValueError(f"{one:g} is no fraction of a segment; give one above 0 and up to 1")
