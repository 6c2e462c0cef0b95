"""Where the robot stands while a program is read: what CRobT, PDispOn, EOffsOn and searches start from.

In RAPID's units: frames in mm, external axes in mm or deg; joints in rad. A move to a pose leaves the joints unknown
until somebody asks, a move to joints leaves the pose unknown; what is not known is asked of the robot, if there is one.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from trajopt_cli.geometry import Array
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import (
    NO_EXTERNAL_AXES,
    ConfData,
    ExternalAxes,
    Move,
    MoveC,
    MoveJ,
    MoveL,
    SignalEvent,
    Tool,
    Wait,
    motion_name,
)
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.predefined import predefined
from trajopt_cli.rapid.execution.construction import maker
from trajopt_cli.rapid.execution.equipment import IDENTITY, Equipment, Setup, frame, matrices, matrix
from trajopt_cli.rapid.execution.units import Units
from trajopt_cli.warnings import WarningKind

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution
    from trajopt_cli.rapid.language.syntax import Node


class _Pose(NamedTuple):
    """The last pose: its setup and target, the configuration, and whether it must be that one."""

    setup: Setup
    target: frames.Frame
    conf: ConfData
    demanded: bool
    extax: ExternalAxes


_pose = maker(_Pose)


class Position:
    """The robot's place after the motions so far.

    extax: of every external axis the last value given, offsets included; None where none was. setup: tool and work
    object of the last move. equipment: what is shared between moves. unplaced: the moves to a pose so far, with where
    each goes; their X_WT is made for all at once, as one by one it is a tenth of a run.
    """

    def __init__(self, kinematics: Kinematics | Callable[[], Kinematics] | None, units: Units):
        self._given, self._units = kinematics, units
        self._robot: Kinematics | None = None
        self.equipment = Equipment()
        self.setup = _first_setup()
        self.extax: ExternalAxes = NO_EXTERNAL_AXES
        self.unplaced: list[tuple[MoveJ | MoveL | MoveC, frames.Frame]] = []
        self._pose: _Pose | None = None  # where the flange is, unless _away
        self._away = False  # external axes have moved since, alone
        self._joints: Array | None = None
        self._near: Array | None = None  # the last joints that were known

    # ------------------------------------------------------------------------------------------------- what moves do

    def to_pose(self, setup: Setup, target: frames.Frame, conf: ConfData, demanded: bool, extax: ExternalAxes) -> None:
        """A move has ended at a target."""
        if self._joints is not None:
            self._near, self._joints = self._joints, None
        if extax != self.extax:
            self.extax = _merged(self.extax, extax)
        self.setup = setup
        self._pose = _pose((setup, target, conf, demanded, self.extax))
        self._away = False

    def to_joints(self, setup: Setup, q: Array, extax: ExternalAxes) -> None:
        """A move has ended at arm joints (6,) in rad."""
        self.setup = setup
        self.extax = _merged(self.extax, extax)
        self._pose, self._joints, self._near, self._away = None, q, q, False

    def to_extax(self, extax: ExternalAxes) -> None:
        """External axes have moved alone; the arm's joints hold."""
        self.extax = _merged(self.extax, extax)
        self._away = True

    def place(self) -> None:
        """The run is over: give every move to a pose its X_WT."""
        poses = matrices([frame for _, frame in self.unplaced], len(self.unplaced))
        for (motion, _), X_WT in zip(self.unplaced, poses, strict=True):
            object.__setattr__(motion, "X_WT", X_WT)
        self.unplaced.clear()

    # --------------------------------------------------------------------------------------------------- what is known

    def kept(self, extax: ExternalAxes) -> ExternalAxes:
        """extax with the last value of every axis that it leaves open, or that no active unit drives."""
        return _merged(self.extax, self._units.driven(extax))

    def robot(self, run: Execution, node: Node, what: str) -> Kinematics:
        """The robot. Raises InputError where there is none; what: who needs it, as the sentence's subject."""
        if self._robot is None:
            if self._given is None:
                raise run.error(node, f"{what} needs the robot: give a cell file (--cell)")
            self._robot = self._given() if callable(self._given) else self._given
        return self._robot

    def known_target(self, setup: Setup) -> frames.Frame | None:
        """The target of a setup that the robot stands at, None where only the robot could tell."""
        if self._pose is None or self._away:
            return None
        if self._pose.setup is setup:
            return self._pose.target
        return setup.target(self._pose.setup.flange(self._pose.target))

    def flange(self, run: Execution, node: Node, what: str) -> frames.Frame:
        """X_WF [mm]."""
        if self._pose is not None and not self._away:
            return self._pose.setup.flange(self._pose.target)
        robot = self.robot(run, node, f"{what} {self._after}")
        return frame(robot.forward(self.joints(run, node, what), self.extax))

    def target(self, run: Execution, node: Node, what: str, setup: Setup) -> frames.Frame:
        """The target of a setup that the robot stands at."""
        known = self.known_target(setup)
        return setup.target(self.flange(run, node, what)) if known is None else known

    @property
    def _after(self) -> str:
        if self._pose is not None:
            return "after a move of external axes alone" if self._away else "after a move to a pose"
        return "before the first move" if self._joints is None else "after a move to joints"

    def joints(self, run: Execution, node: Node, what: str) -> Array:
        """Arm joints (6,) in rad. Raises Fault when the last pose is out of reach."""
        if self._joints is None:
            robot = self.robot(run, node, f"{what} {self._after}")
            if self._pose is None:
                self._joints, extax = robot.start
                self.extax = _merged(extax, self.extax)
            else:
                setup, target, conf, demanded, extax = self._pose
                self._joints = reach(
                    run, node, f"the target before {what}", robot, setup.flange(target), conf, demanded, extax
                )
        return self._joints

    def near(self) -> Array | None:
        """The last joints that were known."""
        return self._near if self._joints is None else self._joints

    def conf(self, run: Execution, node: Node, what: str) -> ConfData:
        """The configuration: as programmed after a move to a pose, else that of the joints."""
        if self._pose is not None and not self._away:
            return self._pose.conf
        robot = self.robot(run, node, f"{what} {self._after}")
        return robot.confdata(self.joints(run, node, what))


def reach(
    run: Execution,
    node: Node,
    what: str,
    robot: Kinematics,
    flange: frames.Frame,
    conf: ConfData,
    demanded: bool,
    extax: ExternalAxes,
) -> Array:
    """Joints (6,) [rad] that bring the flange to X_WF [mm]; what: whose target, as the sentence's subject.

    A configuration that cannot be had is given up for the nearest posture, and said. Raises Fault for a flange pose
    that has none at all.
    """
    X_WF, near = matrix(flange), run.position.near()
    if demanded:
        q = robot.inverse(X_WF, extax, conf, near)
        if q is not None:
            return q
    q = robot.inverse(X_WF, extax, None, near)
    if q is None:
        x, y, z = flange[0]
        message = f"{what} cannot be reached: the flange would stand at [{x:.6g},{y:.6g},{z:.6g}] mm in the world"
        raise run.fault(node, "ERR_ROBLIMIT", message)
    if demanded:
        shown = ",".join(str(part) for part in (conf.cf1, conf.cf4, conf.cf6, conf.cfx))
        run.warn(
            WarningKind.ASSUMED,
            f"{what} has no posture with confdata [{shown}]; the nearest one is taken",
            run.source(node),
        )
    return q


def still_moving(run: Execution) -> Move | None:
    """The move that may still run where the program is: one with a fly-by or with \\Conc, and no stop behind it."""
    for motion in reversed(run.motions):
        if isinstance(motion, Wait):
            if motion.stops and motion.beside is None:
                return None
        elif not isinstance(motion, SignalEvent):
            return motion if not motion.zone.stop or run.concurrent else None
    return None


def read_at_rest(run: Execution, node: Node, what: str) -> None:
    """Warn where the robot should stand for something (what), but is right behind a fly-by or a move with \\Conc."""
    motion = still_moving(run)
    if motion is not None:
        why = "has \\Conc" if motion.zone.stop else f"ends in a fly-by, {motion.zone.name}"
        text = f"{what} while it still moves ({motion_name(motion)} {why}); here that is the point. Stop there"
        run.warn(WarningKind.ASSUMED, f"{text}: fine, or WaitRob \\InPos", run.source(node))


def _merged(last: ExternalAxes, new: ExternalAxes) -> ExternalAxes:
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
