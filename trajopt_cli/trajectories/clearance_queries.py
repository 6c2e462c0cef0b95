"""What engines ask of bodies that motions must stay clear of, without knowing who answers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.problem.problem import Problem


@dataclass(frozen=True, eq=False)
class Contacts:
    """Pairs that are near, one entry each: the row asked for, the pair's name, its signed distance less what is wanted
    and the margin [m], its gradient (n,) by the axes, whether both are the robot's own; and the number of the pair."""

    row: IndexArray
    pair: IndexArray
    names: tuple[str, ...]
    distance: Array
    gradient: Array
    own: BoolArray


class ClearanceQueries(Protocol):
    """Distances of a program's motions to what stands in its cell; index: of a motion, or one for each row. turns
    (m, U): the share that each unit of the motion has turned; without it, what they turn is left out."""

    def scene(self, index: int) -> int:
        """A number that motions with the same bodies around them share."""

    def turning(self, index: int) -> int:
        """How many axes turn during a motion, where any of them turns bodies; else 0."""

    def distances(self, q: Array, index: int | IndexArray, turns: Array | None = None) -> Array:
        """The least distance less what is wanted (m,) [m] at axes q (m, n)."""

    def free(self, q: Array, index: int | IndexArray) -> BoolArray:
        """Which of axes q (m, n) touch nothing."""

    def contacts(self, q: Array, index: int | IndexArray, within: float, turns: Array | None = None) -> Contacts:
        """Pairs of bodies that are nearer than within [m] beyond what is wanted."""


@dataclass(frozen=True, eq=False)
class States:
    """States of a waypoint: axes (m, n) and branch (m,)."""

    q: Array
    cfx: IndexArray


class CheckedPairs(Protocol):
    """Times between the states of two waypoints, of which known (n_a, n_b) were looked at."""

    @property
    def known(self) -> BoolArray:
        """Pairs that were looked at; written to in place."""

    def add(self, i: IndexArray, j: IndexArray, time: Array) -> None:
        """More time (k,) [s] between pairs of states (k,); infinite where there is no way."""


class EdgeChecks(Protocol):
    """Answers the search's question which of its edges touch something.

    ended: the motion at whose end nothing arrives that touches nothing, once that is known.
    """

    ended: int | None

    @property
    def around(self) -> ClearanceQueries:
        """The bodies."""

    def scenes(self, problem: Problem, first: int, last: int) -> bytes:
        """Equal for stretches of a program with the same bodies around and in them."""

    def settle(
        self, problem: Problem, k: int, edge: CheckedPairs, a: States, b: States, through: Array, pair: tuple[int, int]
    ) -> None:
        """Look at pairs of states of leg k, first of all at one; through (n_a, n_b): the least cost of a route through
        each pair that is known."""
