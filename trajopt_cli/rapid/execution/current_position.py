"""Where the robot stands now: what CRobT, PDispOn, EOffsOn and searches start from, and what is no move at all."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import (
    ConfData,
    ExternalAxes,
    Motion,
    Move,
    MoveAbsJ,
    MoveL,
    PoseMove,
    SignalEvent,
    Wait,
    motion_name,
)
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.frames import frame, matrix
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.position import Pose, Setup, merged
from trajopt_cli.rapid.language.syntax import Node
from trajopt_cli.warnings import WarningKind


def the_robot(run: Context, node: Node, what: str) -> Kinematics:
    """The robot. Raises InputError where there is none; what: who needs it, as the sentence's subject."""
    given = run.position.kinematics
    if given is None:
        raise run.error(node, f"{what} needs the robot: give a cell file (--cell)")
    return given


def current_flange(run: Context, node: Node, what: str) -> frames.Frame:
    """X_WF [mm]."""
    position = run.position
    if position.pose is not None and not position.away:
        return position.pose.setup.flange(position.pose.target)
    robot = the_robot(run, node, f"{what} {_after(run)}")
    return frame(robot.forward(current_joints(run, node, what), position.extax))


def current_target(run: Context, node: Node, what: str, setup: Setup) -> frames.Frame:
    """The target of a setup that the robot stands at."""
    known = run.position.known_target(setup)
    return setup.target(current_flange(run, node, what)) if known is None else known


def _after(run: Context) -> str:
    position = run.position
    if position.pose is not None:
        return "after a move of external axes alone" if position.away else "after a move to a pose"
    return "before the first move" if position.joints is None else "after a move to joints"


def current_joints(run: Context, node: Node, what: str) -> Array:
    """Arm joints (6,) in rad. Raises Fault when the last pose is out of reach."""
    position = run.position
    if position.joints is None:
        robot = the_robot(run, node, f"{what} {_after(run)}")
        if position.pose is None:
            position.joints, extax = robot.start
            position.extax = merged(extax, position.extax)
        else:
            near = position.near()
            for pose in position.trail[:-1]:
                near = _joints_at(robot, pose, near)
            last = position.pose
            if not last.demanded and (q := _joints_at(robot, last, near)) is not None:
                position.joints = q
            else:
                subject, flange = f"the target before {what}", last.setup.flange(last.target)
                position.joints = reach(run, node, subject, robot, flange, last.conf, last.demanded, last.extax, near)
    return position.joints


def _joints_at(robot: Kinematics, pose: Pose, near: Array | None) -> Array | None:
    """Joints (6,) [rad] at a pose: in its configuration where that counts, else where its line leads, or the nearest to
    those before it; None where there are none."""
    X_WF = matrix(pose.setup.flange(pose.target))
    q = robot.inverse(X_WF, pose.extax, pose.conf, near) if pose.demanded else None
    straight = pose.line and pose.setup.tool is not None and pose.setup.unit is None
    if q is None and straight and not pose.demanded:
        assert pose.setup.tool is not None
        start = robot.start[0] if near is None else near
        q = robot.along(start, pose.before, X_WF, pose.extax, pose.setup.tool.X_FT)
    return robot.inverse(X_WF, pose.extax, None, near) if q is None else q


def current_conf(run: Context, node: Node, what: str) -> ConfData:
    """The configuration: as programmed after a move to a pose whose confdata counts, or where there is no robot to ask;
    else that of the joints."""
    position, pose = run.position, run.position.pose
    if pose is not None and not position.away and (pose.demanded or position.kinematics is None):
        return pose.conf
    robot = the_robot(run, node, f"{what} {_after(run)}")
    return robot.confdata(current_joints(run, node, what))


def reach(
    run: Context,
    node: Node,
    what: str,
    robot: Kinematics,
    flange: frames.Frame,
    conf: ConfData,
    demanded: bool,
    extax: ExternalAxes,
    near: Array | None,
) -> Array:
    """Joints (6,) [rad] that bring the flange to X_WF [mm]; what: whose target, as the sentence's subject; near:
    of several solutions the nearest to these joints.

    A configuration that cannot be had is given up for the nearest posture, with a warning. Raises Fault for a flange
    pose that has none at all.
    """
    X_WF = matrix(flange)
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
        what = f"{what} has no posture with confdata [{shown}]; the nearest one is taken"
        run.warn(WarningKind.ASSUMED, what, run.source(node))
    return q


def still_moving(run: Context) -> Move | None:
    """The move that may still run where the program is: one with a fly-by or with \\Conc, and no stop behind it."""
    for motion in reversed(run.motions):
        if isinstance(motion, Wait):
            if motion.stops and motion.beside is None:
                return None
        elif not isinstance(motion, SignalEvent):
            return motion if not motion.zone.stop or run.concurrent else None
    return None


def read_at_rest(run: Context, node: Node, what: str) -> None:
    """Warn where the robot should stand for something (what), but is right behind a fly-by or a move with \\Conc."""
    motion = still_moving(run)
    if motion is not None:
        why = "has \\Conc" if motion.zone.stop else f"ends in a fly-by, {motion.zone.name}"
        text = f"{what} while it still moves ({motion_name(motion)} {why}); here that is the point. Stop there"
        run.warn(WarningKind.ASSUMED, f"{text}: fine, or WaitRob \\InPos", run.source(node))


_SAME = 1e-6  # m, entries of rotations, s


def count_rests(motions: Sequence[Motion]) -> None:
    """Take the time of such a line off the least time of the wait behind it. The motions are still the run's own."""
    motions = [one for one in motions if not (isinstance(one, Wait) and one.settles)]
    for before, line, wait in zip(motions, motions[1:], motions[2:], strict=False):
        signal = isinstance(wait, Wait) and wait.condition is not None
        if signal and isinstance(before, Move) and isinstance(line, MoveL):
            assert isinstance(wait, Wait)
            left = wait.duration - _rested(before, line)
            object.__setattr__(wait, "duration", left if left > _SAME else 0.0)


def settle_before(run: Context) -> None:
    """The last motion is a line with a time: where it stands for a wait, axes settle before it as before the wait."""
    line = run.motions[-1]
    before = next((one for one in reversed(run.motions) if isinstance(one, Move) and one is not line), None)
    if isinstance(line, MoveL) and before is not None:
        run.position.place()
        if _rested(before, line):
            run.settle_stop(behind=1)
            run.unsettled, run.looked_at = None, len(run.motions)


def _rested(before: Move, line: MoveL) -> float:
    """The time [s] of a line in which one external axis alone goes elsewhere; 0 of any other."""
    if line.duration is None or line.units:
        return 0.0
    there = isinstance(before, PoseMove) and np.abs(before.X_WT - line.X_WT).max() <= _SAME
    there = there or (isinstance(before, MoveAbsJ) and "crobt(" in line.target.lower())
    others = sum(one != other for one, other in zip(before.extax, line.extax, strict=True))
    return line.duration if there and others == 1 else 0.0
