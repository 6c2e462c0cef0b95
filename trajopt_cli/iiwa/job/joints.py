"""`trajopt iiwa joints`: the arm's joints along a folder's sequence."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trajopt_cli.iiwa.job.folder import JOINTS, Opened, add_to_folder, open_folder
from trajopt_cli.iiwa.task.joint_checks import stops_loop
from trajopt_cli.iiwa.task.joints import Followed, Unfollowable
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.runs.summary import finding_record

if TYPE_CHECKING:
    from trajopt_cli.iiwa.task.arm_plan import ArmFigures, ArmPlan, Goal

Tell = Callable[[str], None]

LONG = 50_000
"""Rows of a sequence from which on what is being done is worth a line."""


def follow_joints(
    folder: Path, free: bool, goal: Goal | None = None, tell: Tell = lambda phase: None
) -> tuple[Opened, Followed | Unfollowable]:
    """Joints along a folder's sequence, written as joints.csv into it.

    free: the arm angle may change where the fixed one fails. goal: what it is chosen for instead. Nothing is written
    where a joint passes its range or its speed limit, which would stop the controller's loop. tell: hears what is
    being worked on where that takes a while.
    """
    opened = open_folder(folder)
    objective, rows = None, len(opened.equilibrium.pose)
    if goal is not None:
        from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective

        objective = ArmAngleObjective(goal, opened.task.load, tell)
    if rows >= LONG:
        tell(f"inverse kinematics and checks of {rows} poses")
    answer = opened.follow(opened.equilibrium, free, objective=objective)
    if isinstance(answer, Followed) and stops_nothing(answer):
        if rows >= LONG:
            tell("writing joints.csv")
        add_to_folder(opened, {JOINTS: write_csv_text(answer.trajectory).encode()}, {"joints": joint_record(answer)})
    return opened, answer


def stops_nothing(followed: Followed) -> bool:
    """Whether no joint passes its range or its speed limit: what the controller's loop stops at."""
    return not stops_loop(followed.findings)


def joint_record(followed: Followed) -> dict[str, Any]:
    """What summary.json says of joints."""
    plan = followed.plan
    return {
        "arm_angle": {
            "definition": followed.definition.value,
            "least_rad": float(followed.arm_angle.min()),
            "greatest_rad": float(followed.arm_angle.max()),
        },
        **({} if plan is None else {"chosen": _chosen(plan, followed.trajectory.names)}),
        "configuration": followed.configuration,
        "findings": [finding_record(finding) for finding in followed.findings],
        "notes": list(followed.notes),
    }


def _chosen(plan: ArmPlan, names: tuple[str, ...]) -> dict[str, Any]:
    """How the arm angle was chosen."""
    return {
        "for": plan.goal.value,
        "kept_fixed": plan.held or None,
        "grid": {
            "stages": len(plan.map.rows),
            "arm_angles": len(plan.map.delta),
            "cell_rad": plan.map.cell,
            "cost": plan.grid_cost,
            "margin_rad": plan.grid_margin,
        },
        "cost": plan.cost,
        "cost_fixed": plan.fixed_cost if plan.fixed.passes else None,
        "smoothing": plan.smoothing,
        "fixed": _figures(plan.fixed, names),
        "optimal": _figures(plan.best, names),
    }


def _figures(figures: ArmFigures, names: tuple[str, ...]) -> dict[str, Any]:
    return {
        "keeps_positions_and_speeds": figures.passes,
        "least_distance_from_limit_rad": figures.margin,
        "least_distance_joint": names[figures.near],
        "speed_share": figures.speed,
        "speed_joint": names[figures.fast],
        "speed_share_rms": figures.steady,
        "acceleration_share": figures.acceleration,
        "acceleration_joint": names[figures.abrupt],
        "gravity_torque_share": figures.gravity,
        "gravity_torque_joint": names[figures.loaded],
        "gravity_torque_share_rms": figures.effort,
        "torque_share": figures.torque,
        "torque_joint": names[figures.strained],
        "elbow_way_m": figures.elbow,
        "arm_angle_turned_rad": figures.turned,
    }
