"""`trajopt iiwa joints`: the arm's joints along a folder's sequence."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from trajopt_cli.compliance.job.folder import JOINTS, Opened, add_to_folder, open_folder
from trajopt_cli.findings import finding_record

if TYPE_CHECKING:
    from trajopt_cli.compliance.task.joints import Followed, Unfollowable


def follow_joints(folder: Path, free: bool) -> tuple[Opened, Followed | Unfollowable]:
    """Joints along a folder's sequence, written as joints.csv into it.

    free: the arm angle may change where the fixed one fails. Nothing is written where a joint passes its range or its
    speed limit, which would stop the controller's loop.
    """
    from trajopt_cli.compliance.task.joints import Followed, follow
    from trajopt_cli.joint_csv import write_csv_text

    opened = open_folder(folder)
    task = opened.task
    answer = follow(
        opened.equilibrium,
        opened.robot,
        task.X_FT,
        task.start_joints,
        opened.robot.profile(task.limits),
        task.definition,
        task.arm_angle,
        free,
    )
    if isinstance(answer, Followed) and stops_nothing(answer):
        add_to_folder(opened, {JOINTS: write_csv_text(answer.trajectory).encode()}, {"joints": joint_record(answer)})
    return opened, answer


def stops_nothing(followed: Followed) -> bool:
    """Whether no joint passes its range or its speed limit: what the controller's loop stops at."""
    from trajopt_cli.compliance.task.joint_checks import stops_loop

    return not stops_loop(followed.findings)


def joint_record(followed: Followed) -> dict[str, Any]:
    """What summary.json says of joints."""
    return {
        "arm_angle": {
            "definition": followed.definition.value,
            "least_rad": float(followed.arm_angle.min()),
            "greatest_rad": float(followed.arm_angle.max()),
        },
        "configuration": followed.configuration,
        "findings": [finding_record(finding) for finding in followed.findings],
        "notes": list(followed.notes),
    }
