"""What a task file asks for: poses, speeds, the compliance of the controller, its surroundings. Plain frozen data, SI.

Frames: W world, B the arm's base, F its flange, T the tool centre point. A pose has six coordinates (6,): the TCP's
position x, y, z [m] in W and extrinsic Tait-Bryan angles alpha, beta, gamma [rad], R = Rz(gamma) Ry(beta) Rx(alpha).
Equation numbers are those of Cihala, Poddajne rizeni prumysloveho robota, CVUT 2020.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from math import isfinite
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray, readonly
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs_inverse import ArmAngle
from trajopt_cli.shapes import Box, Capsule

COORDINATES = ("x", "y", "z", "alpha", "beta", "gamma")
UNITS = ("m", "m", "m", "rad", "rad", "rad")
CAPS = ("v_max", "omega_max", "a_max", "epsilon_max", "jerk", "angular_jerk")
"""Caps of a segment [m/s, rad/s, m/s2, rad/s2, m/s3, rad/s3], of its translation and its rotation in turns."""
_SOON = 1e-9  # s
BETA_LIMIT = np.radians(85.0)
"""Largest |beta| [rad] of the controller's angles: nearer to 90 deg the Tait-Bryan angles lock (section 4.1.2)."""


class Profile(Enum):
    """How fast a segment is run: at once at full speed (eqs 4.23-4.33), with ramps (section 2.3), jerk-limited."""

    THESIS = "thesis"
    TRAPEZOID = "trapezoid"
    S_CURVE = "s-curve"


class RotationLaw(Enum):
    """What is straight between two orientations: the three angles, or the turn about one axis (slerp)."""

    TAIT_BRYAN = "tait-bryan"
    SLERP = "slerp"


class AngleMeaning(Enum):
    """R_WT = R(angles) R_start (eq. 4.18, what the controller means), or R_WT = R(angles)."""

    RELATIVE = "relative"
    ABSOLUTE = "absolute"


class Integration(Enum):
    """How the controller's law is stepped: forward Euler as in eq. 4.13, or the exact zero-order-hold solution."""

    EULER = "euler"
    EXACT = "exact"


class Feed(Enum):
    """What the controller is told of the equilibrium: its position alone (eq. 4.15), or its speed too (eq. 4.2)."""

    POSITION = "position"
    VELOCITY = "velocity"


@dataclass(frozen=True)
class Force:
    """How hard the tool presses on what it touches [N], and along what: "tool" (its z axis), "normal" (that axis less
    what of it lies along the path), or an axis of the world ("x", "-z", ...). place: for messages."""

    value: float
    along: str
    place: str


@dataclass(frozen=True, eq=False)
class Waypoint:
    """A pose (6,) by name; place is the key or file:line it comes from, for messages. dwell [s]: standing there.

    rests: whether it is a stop although poses are passed; with a dwell it is one anyway. force: None for none.
    """

    name: str
    pose: Array
    place: str
    dwell: float = 0.0
    rests: bool = False
    force: Force | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "pose", _vector(self.pose, 6, f"pose '{self.name}'"))


@dataclass(frozen=True)
class Passing:
    """How near poses are passed that are no stops: within tolerance [m] and turn_tolerance [rad]."""

    tolerance: float
    turn_tolerance: float


@dataclass(frozen=True, eq=False)
class PathPoints(Sequence[Waypoint]):
    """Many waypoints as one array: poses (n, 6), named by their numbers. file and rows (n,): where each stands in it.

    number: of the first. names: those of some; dwells [s]: of those that have one; stops: further ones that are rested
    at though poses are passed. force: at all from number 1 on.
    """

    poses: Array
    file: str
    rows: IndexArray
    number: int = 1
    names: Mapping[int, str] = field(default_factory=dict)
    dwells: Mapping[int, float] = field(default_factory=dict)
    stops: frozenset[int] = frozenset()
    force: Force | None = None

    def __len__(self) -> int:
        return len(self.poses)

    @overload
    def __getitem__(self, index: int) -> Waypoint: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Waypoint, ...]: ...

    def __getitem__(self, index: int | slice) -> Waypoint | tuple[Waypoint, ...]:
        if isinstance(index, slice):
            return tuple(self[i] for i in range(*index.indices(len(self))))
        i = range(len(self))[index]
        name = self.names.get(i, str(i + self.number))
        place = f"{self.file}:{int(self.rows[i])}"
        force = self.force if i + self.number > 0 else None
        return Waypoint(name, self.poses[i], place, self.dwells.get(i, 0.0), i in self.stops, force)


@dataclass(frozen=True, eq=False)
class Route:
    """Poses X_1..X_M (M >= 2) and caps (M - 1, 6) of the segments between them, NaN for none, sampled every h [s].

    passing: how the poses between the first and the last are passed that have no dwell; None where all are stops.
    """

    waypoints: Sequence[Waypoint]
    caps: Array
    h: float
    profile: Profile
    rotation: RotationLaw
    meaning: AngleMeaning
    passing: Passing | None = None

    @property
    def poses(self) -> Array:
        """All poses (M, 6)."""
        if isinstance(self.waypoints, PathPoints):
            return self.waypoints.poses
        return np.array([waypoint.pose for waypoint in self.waypoints])

    @property
    def stops(self) -> list[int]:
        """Numbers of the waypoints that are rested at, from 0."""
        ends = {0, len(self.waypoints) - 1}
        if self.passing is None:
            return list(range(len(self.waypoints)))
        if isinstance(self.waypoints, PathPoints):
            return sorted(ends | self.waypoints.dwells.keys() | self.waypoints.stops)
        return sorted(ends | {i for i, one in enumerate(self.waypoints) if one.dwell > 0 or one.rests})


@dataclass(frozen=True, eq=False)
class Compliance:
    """Diagonals (6,) of stiffness K [N/m, Nm/rad], damping D [N s/m, N m s/rad] and inertia M [kg, kg m2].

    k = 0 is hand guiding. Raises ValueError for m <= 0, a negative k or d, and k = d = 0, which no force brings back.
    """

    K: Array
    D: Array
    M: Array

    def __post_init__(self) -> None:
        for name in ("K", "D", "M"):
            object.__setattr__(self, name, _vector(getattr(self, name), 6, name))
        for axis, k, d, m in zip(COORDINATES, self.K, self.D, self.M, strict=True):
            if m <= 0:
                raise ValueError(f"M of {axis} is {m:g}: an inertia is above zero")
            if k < 0 or d < 0:
                raise ValueError(f"K and D of {axis} are {k:g} and {d:g}: neither may be negative")
            if k == 0 and d == 0:
                raise ValueError(f"K and D of {axis} are both 0: nothing would stop the motion; give it some damping")


@dataclass(frozen=True, eq=False)
class Impedance:
    """A controller of torques: damping ratios (6,) in place of D, None for D itself; stiffness [Nm/rad] and damping
    ratio of the arm's motion that moves nothing of the tool."""

    damping_ratio: Array | None
    null_stiffness: float
    null_damping: float


@dataclass(frozen=True, eq=False)
class Zeroing:
    """Forces the controller is blind to: zeroed (6,) of bool, in the frame R* = Rz Ry Rx of frame (3,) [rad] (4.21)."""

    zeroed: tuple[bool, ...] = (False,) * 6
    frame: Array = field(default_factory=lambda: np.zeros(3))

    def __post_init__(self) -> None:
        object.__setattr__(self, "frame", _vector(self.frame, 3, "zeroing frame"))


@dataclass(frozen=True, eq=False)
class Clamps:
    """Bounds on what is believed: joint torques (7,) [Nm] before the mapping, forces (6,) [N, Nm] after; inf: none."""

    torque: Array = field(default_factory=lambda: np.full(7, np.inf))
    force: Array = field(default_factory=lambda: np.full(6, np.inf))

    def __post_init__(self) -> None:
        for name, count in (("torque", 7), ("force", 6)):
            values = readonly(getattr(self, name))
            if values.shape != (count,) or not np.all(values > 0):
                raise ValueError(f"clamps: {name} is {values.tolist()}, wanted {count} bounds above zero")
            object.__setattr__(self, name, values)


@dataclass(frozen=True, eq=False)
class Change:
    """From time t [s] on, what is given here holds instead of what held before; None stays as it was.

    restart: R_start becomes the tool's orientation at t, so that all angles begin at zero again. pose: at whose arrival
    t is, nan until a sequence says so (timed); None where the task gives seconds.
    """

    t: float
    compliance: Compliance | None = None
    zeroing: Zeroing | None = None
    clamps: Clamps | None = None
    X_FT: Array | None = None
    X_WB: Array | None = None
    restart: bool = False
    pose: str | None = None

    @property
    def reframes(self) -> bool:
        """Whether poses are counted from other frames from then on."""
        return self.restart or self.X_FT is not None or self.X_WB is not None


@dataclass(frozen=True, eq=False)
class Push:
    """A force (6,) [N, Nm] on the tool, world axes, from start to end [s]: the thesis' simulated force."""

    start: float
    end: float
    force: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "force", _vector(self.force, 6, "push"))

    def at(self, t: ArrayLike) -> Array:
        """The force (..., 6) at times t (...) [s]; a period's start this little before its edge is on it."""
        soon = np.asarray(t)[..., None] + _SOON
        return np.asarray(((self.start <= soon) & (soon < self.end)) * self.force)


@dataclass(frozen=True, eq=False)
class PushLog:
    """A recorded force on the tool: times t (n,) [s], force (n, 6) [N, Nm], world axes; linear in between, none
    outside."""

    t: Array
    force: Array

    def at(self, t: ArrayLike) -> Array:
        """The force (..., 6) at times t (...) [s]."""
        when = np.asarray(t, dtype=np.float64)
        return np.stack([np.interp(when, self.t, column, left=0.0, right=0.0) for column in self.force.T], axis=-1)


@dataclass(frozen=True)
class Sensor:
    """Errors of the measured joint torques (section 3.1.2).

    bias: constant error per joint, drawn from +-bias of its range (0.02 in the data sheet) with seed. ripple: pairs of
    frequency [Hz] and amplitude [Nm], on all joints, phases drawn with seed. rigid: whether the controller's model
    tau_c knows the inertia of the arm in motion; if not it holds gravity only, and every acceleration looks like a
    force.
    """

    bias: float = 0.02
    ripple: tuple[tuple[float, float], ...] = ((8.0, 0.3), (17.0, 0.2))
    rigid: bool = True
    seed: int = 1


@dataclass(frozen=True, eq=False)
class Obstacle:
    """A shape in the world that pushes back: stiffness [N/m], damping [N s/m], friction coefficient."""

    shape: Box | Capsule
    stiffness: float
    damping: float
    friction: float


@dataclass(frozen=True)
class Contact:
    """What the tool may run into, and the tool's tip: a ball of this radius [m] around the TCP. body: of the tool
    behind its tip, in the flange frame."""

    obstacles: tuple[Obstacle, ...]
    tip: float
    body: Capsule | None = None


@dataclass(frozen=True, eq=False)
class Task:
    """A task file's content. X_WB (4, 4): base in the world; X_FT (4, 4): TCP in the flange frame.

    start_joints (7,) [rad]: where the controller is switched on; configuration, arm angle and R_start come from them.
    limits: which of the robot's limit profiles holds. arm_angle [rad] by definition: None for the one at the start.
    tool: its body, in the flange frame.
    by_joints: whether the joints' speeds and accelerations time the route, too.
    impedance: the controller is one of torques, else the admittance controller of eq. 4.13.
    follows: it moves on with the equilibrium's speed.
    wrench: whether the waypoints' forces are told to the controller, instead of shifting its equilibrium;
    lead: whether this runs ahead of the path besides, so that the tool does not lag.
    notes: what the user should know. sources: name -> text of the files the task came from, the task file first.
    """

    file: str
    robot: str
    limits: str
    route: Route
    compliance: Compliance
    start_joints: Array
    X_WB: Array
    X_FT: Array
    load: ToolLoad | None
    definition: ArmAngle
    arm_angle: float | None
    integration: Integration
    zeroing: Zeroing
    clamps: Clamps
    changes: tuple[Change, ...]
    pushes: tuple[Push | PushLog, ...]
    sensor: Sensor | None
    contact: Contact | None
    tool: Capsule | None = None
    by_joints: bool = False
    impedance: Impedance | None = None
    follows: bool = False
    wrench: bool = False
    lead: bool = False
    notes: tuple[str, ...] = ()
    sources: Mapping[str, str] = field(default_factory=dict)


def _vector(values: ArrayLike, count: int, what: str) -> Array:
    out = readonly(values)
    if out.shape != (count,) or not all(isfinite(value) for value in out):
        raise ValueError(f"{what} is {np.asarray(values).tolist()}, wanted {count} finite numbers")
    return out
