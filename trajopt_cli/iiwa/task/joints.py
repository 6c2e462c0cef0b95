"""The joints that follow an equilibrium sequence: one configuration, an arm angle that is fixed, rescued or chosen."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, axis_angle
from trajopt_cli.iiwa.task.arm_map import ArmTask, NoPlan
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.joint_checks import (
    ELBOW,
    Arm,
    broken_limit,
    central_speeds,
    check_joints,
    place_of,
    remarks,
    stops_loop,
)
from trajopt_cli.robot.srs_inverse import ArmAngle, why_unreachable
from trajopt_cli.trajectory import Trajectory

if TYPE_CHECKING:
    from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective, ArmPlan

_SAME_POSITION, _SAME_ANGLE = 1e-6, 1e-6
"""m and rad: a first pose this near the tool's at the start joints is that pose, written down with rounding."""


@dataclass(frozen=True, eq=False)
class Followed:
    """Joints along the sequence, whether or not they keep the limits: the findings say.

    trajectory: a row every period; qd is the central difference, 0 in the first and last row, where the arm rests.
    X_WF (n, 4, 4): flange poses wanted. arm_angle (n,) [rad] by definition, without jumps. configuration: 0..7, that
    of the start joints. findings: worst position, speed and acceleration of every joint. notes: what to know besides.
    plan: how the arm angle was chosen, None where it was not, or where no choice keeps the limits.
    """

    trajectory: Trajectory
    X_WF: Array
    arm_angle: Array
    definition: ArmAngle
    configuration: int
    findings: tuple[Finding, ...]
    notes: tuple[str, ...]
    plan: ArmPlan | None = None


@dataclass(frozen=True)
class Unfollowable:
    """The answer no: the pose in row index, at time [s], that no arm angle reaches; place: between which poses."""

    time: float
    index: int
    place: str
    message: str


def follow(
    equilibrium: Equilibrium,
    arm: Arm,
    free: bool = False,
    stops: bool = True,
    objective: ArmAngleObjective | None = None,
) -> Followed | Unfollowable:
    """Joints of every pose of the sequence, each sample held against the limits.

    arm: its start is where the controller is switched on; R_start, the configuration, the joints' turns and, unless one
    is given, the arm angle come from there. free: if a fixed arm angle breaks a position or speed limit, the arm angle
    may move, from that of the start joints on. stops: whether the arm has to be at rest in the last row. objective:
    what the arm angle is chosen for, from that of the start joints on; free does not count then.
    """

    def place(row: int) -> str:
        return place_of(equilibrium, row)

    h, limits, fixed = equilibrium.h, arm.limits, arm.angle
    X_WF = arm.flange(equilibrium.rotations(arm.X_start[:3, :3]), equilibrium.pose[:, :3])
    q = arm.joints(X_WF)
    lost = np.isnan(q).any(axis=1)
    if lost.any():
        row = int(np.argmax(lost))
        reason = why_unreachable(arm.robot, X_WF[row], fixed, arm.definition, limits)
        message = f"pose at t = {row * h:.3f} s ({place(row)}) cannot be reached: {reason}; move the path"
        return Unfollowable(row * h, row, place(row), message)

    angles = np.full(len(q), fixed)
    free = free or objective is not None
    findings = check_joints(q, h, limits, place, free=objective is not None, stops=stops)
    notes: list[str] = []
    plan: ArmPlan | None = None
    broken = stops_loop(findings)
    hopeless = any(finding.subject == limits.names[ELBOW] for finding in broken)
    moved = False
    if free and objective is None and not broken:
        notes.append(f"the arm angle stays at {_printed(fixed)}: it keeps every position and speed limit")
    elif free and not hopeless:
        from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective, Goal, plan_arm

        found = plan_arm(ArmTask(arm, X_WF, h), fixed, objective or ArmAngleObjective(Goal.LIMITS), stops)
        plan = None if isinstance(found, NoPlan) or objective is None else found
        if isinstance(found, NoPlan):
            at = f"at t = {found.row * h:.3f} s ({place(found.row)})"
            notes.append(f"no path of the arm angle was found: {at} {found.message}")
        elif found.held:
            notes.append(f"the arm angle stays at {_printed(fixed)}: {found.held}")
        else:
            moved, angles, q = True, found.arm_angle, found.q
            if broken:
                at = place(round((broken[0].time or 0.0) / h))
                notes.append(
                    f"the arm angle moves between {_printed(float(angles.min()))} and {_printed(float(angles.max()))};"
                    f" held at {_printed(fixed)}: {broken_limit(broken[0], at)}"
                )
    if (free and broken) or moved:
        findings = check_joints(q, h, limits, place, free=True, stops=stops)
    notes += _start_notes(arm, X_WF[0] @ arm.X_FT, q[0])
    notes += remarks(arm.robot, q, h, limits, place)
    trajectory = Trajectory(limits.names, equilibrium.t, q, central_speeds(q, h))
    return Followed(trajectory, X_WF, angles, arm.definition, arm.configuration, findings, tuple(notes), plan)


def _printed(angle: float) -> str:
    """In degrees; 0 without a sign."""
    return f"{round(degrees(angle), 2) + 0.0:.2f}°"


def _start_notes(arm: Arm, X_first: Array, q: Array) -> list[str]:
    X_start, start, limits = arm.X_start, arm.start, arm.limits
    distance = float(np.linalg.norm(X_first[:3, 3] - X_start[:3, 3]))
    angle = axis_angle(X_start[:3, :3].T @ X_first[:3, :3])[1]
    j = int(np.argmax(np.abs(q - start)))
    jump = f"{limits.names[j]} by {degrees(abs(q[j] - start[j])):.4g}°"
    if distance > _SAME_POSITION or angle > _SAME_ANGLE:
        return [
            f"the first pose is {1e3 * distance:.4g} mm and {degrees(angle):.4g}° away from the tool at the start"
            f" joints: the controller would be pulled there at once, {jump}"
        ]
    if abs(q[j] - start[j]) > _SAME_ANGLE:
        return [f"the first pose is the tool's at the start joints, but other joints reach it: {jump}"]
    return []
