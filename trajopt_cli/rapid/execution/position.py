"""Where the robot stands while a program is read, and what its moves share: the state that moves change.

In RAPID's units: frames in mm, external axes in mm or deg; joints in rad. A move to a pose leaves the joints unknown
until somebody asks, a move to joints leaves the pose unknown: current_position.py asks the robot for what is not known.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from trajopt_cli.geometry import Array
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import NO_EXTERNAL_AXES, ConfData, ExternalAxes, PoseMove, Settings, Speed, Tool, Zone
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import Data
from trajopt_cli.rapid.data.frames import IDENTITY, matrices, matrix
from trajopt_cli.rapid.data.predefined import predefined
from trajopt_cli.rapid.execution.construction import maker


@dataclass(frozen=True, slots=True, eq=False)
class Setup:
    """A tool and a work object together. Frames in mm.

    name, wobj: as written. tool_data, wobj_data: what they were made from. displacement: the D that was active. tcp:
    the tool's frame, seen from the flange, or from the world where it is stationary. base: U O D, seen from the world,
    or from the flange where the tool is stationary; None for the identity. tool: shared by all motions; None for a
    stationary one, which has another X_FT for each target. X_WO: base as a pose [m], None where it moves. unit: the
    positioner that carries the work object, whose axes stand at `at` [deg] in base.
    """

    name: str
    wobj: str
    tool_data: Data
    wobj_data: Data
    displacement: frames.Frame | None
    tcp: frames.Frame
    base: frames.Frame | None
    stationary: bool
    tool: Tool | None
    X_WO: Array | None
    unit: str | None = None
    at: tuple[float, ...] = ()

    def placed(self, target: frames.Frame) -> frames.Frame:
        """A target seen from the world, or from the flange where the tool is stationary."""
        return frames.compose(self.base, target) if self.base else target

    def flange(self, target: frames.Frame) -> frames.Frame:
        """X_WF at a target."""
        placed = self.placed(target)
        if self.stationary:
            return frames.compose(self.tcp, frames.inverse(placed))
        return frames.compose(placed, frames.inverse(self.tcp))

    def target(self, flange: frames.Frame) -> frames.Frame:
        """The target that X_WF is at."""
        if self.stationary:
            placed = frames.compose(frames.inverse(flange), self.tcp)
        else:
            placed = frames.compose(flange, self.tcp)
        return frames.compose(frames.inverse(self.base), placed) if self.base else placed


class Pose(NamedTuple):
    """A pose that a move ends in: its setup and target, the configuration, and whether it must be that one. before,
    extax: external axes before the move and at the pose. line: the tool goes straight there."""

    setup: Setup
    target: frames.Frame
    conf: ConfData
    demanded: bool
    before: ExternalAxes
    extax: ExternalAxes
    line: bool


_make_pose = maker(Pose)


class Manner(NamedTuple):
    r"""duration: the programmed \T [s]."""

    setup: Setup
    speed: Speed
    zone: Zone
    duration: float | None


class Known(NamedTuple):
    """A manner, the state it was made in, and the names that it was made from with what each stood for."""

    settings: Settings
    displacement: frames.Frame | None
    data: tuple[tuple[str, Data], ...]
    manner: Manner


class Position:
    """The robot's place after the motions so far, and what its moves share.

    extax: of every external axis the last value given, offsets included; None where none was. setup: tool and work
    object of the last move. pose: where the flange is, unless away; away: external axes have moved since, alone.
    joints: the arm's, where they are known; near: the last that were; trail: the poses since then, from the last one
    whose configuration counts on. displacement: the active program displacement D.
    manners, setups, turned: in use, by name. rough: the orientations off unit length that were
    reported. unplaced: the moves to a pose so far, with where each goes; their X_WT is made for all at once, as one by
    one it is a tenth of a run.
    """

    def __init__(self, kinematics: Kinematics | None):
        self.kinematics = kinematics
        self.setup = _first_setup()
        self.extax: ExternalAxes = NO_EXTERNAL_AXES
        self.displacement: frames.Frame | None = None
        self.manners: dict[tuple[str, ...], Known] = {}  # by the names of speed, zone, tool and work object
        self.setups: dict[tuple[str, str], Setup] = {}
        self.turned: dict[tuple[Setup, tuple[float, ...]], Setup] = {}
        self.rough: set[frames.Quaternion] = set()
        self.unplaced: list[tuple[PoseMove, frames.Frame]] = []
        self.pose: Pose | None = None
        self.trail: list[Pose] = []
        self.away = False
        self.joints: Array | None = None
        self._near: Array | None = None

    def to_pose(
        self, setup: Setup, target: frames.Frame, conf: ConfData, demanded: bool, extax: ExternalAxes, line: bool
    ) -> None:
        """A move has ended at a target."""
        if self.joints is not None:
            self._near, self.joints = self.joints, None
            self.trail.clear()
        elif demanded:
            self.trail.clear()
        before = self.extax
        if extax != before:
            self.extax = merged(before, extax)
        self.setup = setup
        self.pose = _make_pose((setup, target, conf, demanded, before, self.extax, line))
        self.trail.append(self.pose)
        self.away = False

    def to_joints(self, setup: Setup, q: Array, extax: ExternalAxes) -> None:
        """A move has ended at arm joints (6,) in rad."""
        self.setup = setup
        self.extax = merged(self.extax, extax)
        self.pose, self.joints, self._near, self.away = None, q, q, False

    def to_extax(self, extax: ExternalAxes) -> None:
        """External axes have moved alone; the arm's joints hold."""
        self.extax = merged(self.extax, extax)
        self.away = True

    def place(self) -> None:
        """The run is over: give every move to a pose its X_WT."""
        poses = matrices([frame for _, frame in self.unplaced], len(self.unplaced))
        for (motion, _), X_WT in zip(self.unplaced, poses, strict=True):
            object.__setattr__(motion, "X_WT", X_WT)
        self.unplaced.clear()

    def near(self) -> Array | None:
        """The last joints that were known."""
        return self._near if self.joints is None else self.joints

    def known_target(self, setup: Setup) -> frames.Frame | None:
        """The target of a setup that the robot stands at, None where only the robot could tell."""
        if self.pose is None or self.away:
            return None
        if self.pose.setup is setup:
            return self.pose.target
        return setup.target(self.pose.setup.flange(self.pose.target))


def merged(last: ExternalAxes, new: ExternalAxes) -> ExternalAxes:
    """New external axes, the last of each that they leave open."""
    a, b, c, d, e, f = new
    p, q, r, s, t, u = last
    return (
        p if a is None else a,
        q if b is None else b,
        r if c is None else c,
        s if d is None else d,
        t if e is None else e,
        u if f is None else f,
    )


def _first_setup() -> Setup:
    known = predefined()
    tool = Tool("tool0", matrix(IDENTITY))
    data = known["tool0"].data, known["wobj0"].data
    return Setup("tool0", "wobj0", *data, None, IDENTITY, None, False, tool, tool.X_FT)
