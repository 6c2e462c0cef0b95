"""The protocol by which engines ask a limit, and the data that they ask with.

Adding a limit: a file here with a class derived from `Limit`, its name in `KINDS`, and its number: a field of
`JointLimits` or `TcpCaps`, which the cell file's `limits` and `tcp` have as a key by itself.

- the dense check and the report of active limits ask `ratios` and `used` at samples of a motion,
- path timing asks `path_rows` at places of a sampled path: with x the squared rate of the path parameter and u its
  second derivative, every column is |slopes u + bends x + rests| <= margin, and the rate itself is at most `top` times
  the margin. It keeps a margin for each limit (by `name`) and interval, starts with `start`, compares `ratios` with
  `safe`, and tightens what exceeds it,
- sensitivity asks `numbers`: what a change of the cell or the program changes for a leg,
- the search and the initial plan ask `holds` and `why_not`: where the robot can rest,
- the nonlinear program asks `node_rows` at its nodes, with parameters of `node_shapes` and values of `node_values`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.path.symbols import Curve
from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.axes import Axes, AxisLimits
from trajopt_cli.trajectories.leg_trajectories import Sample

if TYPE_CHECKING:
    import casadi as ca


INF = float("inf")
Row = tuple["ca.SX", float, float]
"""lower <= expression <= upper."""


@dataclass(frozen=True, eq=False)
class MotionSamples:
    """Samples of motions on legs, place i on legs[number[i]].

    number (m,). sample: the axes at m places. caps: what the legs allow at each. tool (m, 2, 6): the tool's twist and
    its rate, against the work object where that turns. first (N,): the place with which each interval begins. progress
    (2, m): first and second derivative of the share of the way by time, None where nobody needs it.
    """

    legs: Sequence[Leg]
    number: IndexArray
    sample: Sample
    caps: AxisLimits
    tool: Array
    first: IndexArray
    progress: Array | None = None


@dataclass(frozen=True, eq=False)
class PathSamples:
    """Places of a sampled path on legs, place i on legs[number[i]]; all derivatives by the path parameter.

    q, dq, ddq (m, n): axes. v, w, bend (m, 3): the tool's velocity, rate of turning and second derivative of position.
    positioner_use (m, 2): what positioners use of their velocity at the rate 1, of their acceleration at u = 1.
    """

    legs: Sequence[Leg]
    number: IndexArray
    caps: AxisLimits
    q: Array
    dq: Array
    ddq: Array
    v: Array
    w: Array
    bend: Array
    positioner_use: Array


@dataclass(frozen=True, eq=False)
class PathRows:
    """What a limit asks for at m places of a path: the rate is at most top (m, k) and |slopes u + bends x + rests| <= 1
    (m, c), with x the squared rate and u the second derivative of the path parameter. k or c may be 0."""

    top: Array
    slopes: Array
    bends: Array
    rests: Array

    @property
    def rate(self) -> Array:
        """The greatest rate (m,) that is left; by columns, for which NumPy takes a fifth of the time."""
        return np.min(np.ascontiguousarray(self.top.T), axis=0, initial=np.inf)

    def at(self, places: IndexArray) -> PathRows:
        """Those of some of the places, in any order."""
        return PathRows(*(np.take(getattr(self, one.name), places, axis=0) for one in fields(self)))

    @classmethod
    def of_rate(cls, top: Array) -> PathRows:
        """A limit of the rate alone."""
        none = np.zeros((*top.shape[:-1], 0))
        return cls(top, none, none, none)

    @classmethod
    def of_acceleration(cls, slopes: Array, bends: Array, rests: Array | None = None) -> PathRows:
        """A limit linear in u and x."""
        return cls(slopes[..., :0], slopes, bends, cls.no_rests(slopes) if rests is None else rests)

    @staticmethod
    def no_rests(slopes: Array) -> Array:
        """Rests that are 0 of slopes (m, c), in no memory: most have none."""
        return np.broadcast_to(0.0, slopes.shape)


@dataclass(frozen=True, eq=False)
class NodeMotion:
    """A node of the nonlinear program as expressions, by scaled time tau = t / T of its leg.

    q, qd (n,): all axes and their first derivative. qdds, qddds: second and third ones (n,) on the sides of the node,
    the left before the right; without a limit of jerk there are no third ones, with one a single second.
    dependent: which axes are functions of others and so have no bounds. share: of a line or an arc, else None. ends:
    whether the node is the first or the last of its leg.
    """

    q: ca.SX
    qd: ca.SX
    qdds: Sequence[ca.SX]
    qddds: Sequence[ca.SX]
    T: ca.SX
    dependent: slice
    share: Share | None = None
    ends: bool = False


@dataclass(frozen=True, eq=False)
class Share:
    """First derivative v and second ones a, by side, of the share of a line or an arc. inward: part of the tool's
    acceleration towards the centre of an arc by v^2 and the length of its way, 0 on a line. curve: how the tool goes by
    the share in a corner, None elsewhere. turn: rate of the tool's turn beyond its way, None where it has none."""

    v: ca.SX
    a: Sequence[ca.SX]
    inward: ca.SX | float
    curve: Curve | None = None
    turn: ca.SX | None = None


class Limit(ABC):
    """One thing that a motion keeps. A ratio to it is at most 1 where it is kept; columns: one for each thing limited,
    such as the n axes."""

    name: str
    """In Ratios and Margins."""
    unreached = 2.0
    """The ratio where there is none: the rail left the arm's reach between nodes, or gravity alone passes a torque."""
    order = 1.0
    """How a ratio falls with time: driven k times as slowly it is 1 / k^order as large."""
    apart = False
    """Whether its rows at nodes are evaluated in a block of their own, because their expressions are large or differ
    from leg to leg."""
    safe_on_grid: float | None = None
    """The same for joint moves on a grid, where another; infinite where they keep it between nodes by construction."""

    def __init__(self, axes: Axes):
        self.axes = axes

    @classmethod
    def in_force(cls, axes: Axes) -> bool:
        """Whether motions of these axes must keep it at all."""
        return True

    @property
    def slows_paths(self) -> bool:
        """Whether path timing drives more slowly where it is exceeded, because `path_rows` does not ask for it."""
        return type(self).path_rows is Limit.path_rows and bool(np.any(self.orders > 0))

    @property
    def safe(self) -> float:
        """The ratio up to which a dense check is content."""
        return self.axes.settings.safe

    @property
    def start(self) -> float:
        """The margin that nonlinear programs and path timing start with."""
        return self.axes.settings.start

    @property
    def start_on_grid(self) -> float:
        """The same for axes that move by polynomials on a grid."""
        return self.axes.settings.start

    @property
    def orders(self) -> Array:
        """The order of each column (w,)."""
        return np.full(self.axes.n, self.order)

    @abstractmethod
    def labels(self, leg: Leg) -> list[str]:
        """What reports call its columns on a leg, such as "joint_1 speed"."""

    @abstractmethod
    def numbers(self, leg: Leg) -> Array:
        """What each column is held against on a leg (w, k): legs of equal numbers are limited alike."""

    def holds(self, leg: Leg, q: Array) -> BoolArray:
        """At which axes (m, n) the robot can rest on a leg (m,)."""
        return np.ones(len(q), dtype=bool)

    def why_not(self, leg: Leg, q: Array) -> str | None:
        """Why the robot cannot rest at axes q (n,) on a leg, in words; None where it can."""
        return None

    @abstractmethod
    def ratios(self, motion: MotionSamples) -> Array:
        """Ratios (m, w) at samples."""

    def used(self, motion: MotionSamples) -> Array:
        """The same as reports count it."""
        return self.ratios(motion)

    def path_rows(self, path: PathSamples) -> PathRows | None:
        """What it asks for along a sampled path; None where path timing cannot ask for it."""
        return None

    def node_kind(self, leg: Leg) -> Hashable:
        """Legs of equal kinds have equal rows; None where it asks nothing of a leg's nodes."""
        return True

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """Parameters of its rows by name."""
        return {}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """Their values at nodes where this margin (m, w) is in force, each (m, ...). q (m, n): the axes at hand."""
        return {}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """Its rows at a node of the nonlinear program; p: the parameters as attributes."""
        return []
