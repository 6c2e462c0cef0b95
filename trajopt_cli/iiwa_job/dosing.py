"""`trajopt iiwa dose`: a folder's sequence retimed so that the controller follows it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from trajopt_cli.iiwa.angles import rotation
from trajopt_cli.iiwa.equilibrium import Equilibrium
from trajopt_cli.iiwa.legs import legs
from trajopt_cli.iiwa.meaning import counted
from trajopt_cli.iiwa.task import AngleMeaning, Clamps, Feed, SegmentSpeeds
from trajopt_cli.iiwa_job.folder import Opened, open_folder, sequence_files, sequence_record
from trajopt_cli.iiwa_job.joints import joint_record
from trajopt_cli.iiwa_job.simulation import Unstable, lag_record, run_controller
from trajopt_cli.run_folder import check_replaceable
from trajopt_cli.task_folder import write_task_folder

if TYPE_CHECKING:
    from trajopt_cli.admittance.dose import CannotDose, Dosed, FeedRow
    from trajopt_cli.iiwa.joints import Followed, Unfollowable


@dataclass(frozen=True, eq=False)
class DosedJob:
    """A dosed sequence in its folder, beside the ways to feed the one it came from.

    rows: as programmed, with the equilibrium's speed, dosed. joints: the arm's, as it follows the dosed sequence.
    """

    before: Opened
    after: Opened
    dosed: Dosed
    rows: tuple[FeedRow, ...]
    joints: Followed
    folder: Path


def dose_folder(
    folder: Path, output: Path, bound: float, turn_bound: float | None
) -> DosedJob | CannotDose | Unfollowable | Unstable:
    """Retime a folder's sequence: least time with a lag of at most bound [m] (and turn_bound [rad]), into output.

    The sequence keeps its path, its segments' speeds and the joints' speed limits. Nothing is written where there is no
    such sequence, or the arm cannot follow it. Raises InputError where output may not be replaced.
    """
    from trajopt_cli.admittance.dose import CannotDose, compare, dose
    from trajopt_cli.admittance.dose_path import dose_path
    from trajopt_cli.iiwa.joints import Followed, follow

    check_replaceable(output)
    before = open_folder(folder)
    sequence = counted(before.equilibrium, AngleMeaning.RELATIVE, before.X_start[:3, :3])
    before = replace(before, equilibrium=sequence)
    task = before.task
    limits = before.robot.profile(task.limits)
    followed = follow(
        sequence, before.robot, task.X_FT, task.start_joints, limits, task.definition, task.arm_angle, free=False
    )
    if not isinstance(followed, Followed):
        return followed
    try:
        path = dose_path(sequence, _speeds(before), joints=followed.trajectory.q, joint_speed=limits.velocity)
    except ValueError as error:
        return CannotDose(str(error))
    dosed = dose(path, task.compliance, sequence.h, bound, turn_bound=turn_bound, integration=task.integration)
    if isinstance(dosed, CannotDose):
        return dosed
    after = replace(before, equilibrium=_dosed_sequence(sequence, dosed))
    rows = compare(sequence, task.compliance, dosed, integration=task.integration)
    # what happens to the controller besides its feed is left out: the dosing does not know it either
    quiet = replace(task, changes=(), pushes=(), sensor=None, clamps=Clamps(), contact=None)
    run = run_controller(replace(after, task=quiet), None, None, Feed.POSITION, None, None)
    if isinstance(run, Unstable):
        return run
    if not isinstance(run.joints, Followed):
        assert run.joints is not None
        return run.joints
    job = DosedJob(before, after, dosed, rows, run.joints, output)
    _write(job)
    return job


def _speeds(opened: Opened) -> tuple[SegmentSpeeds, ...]:
    """The caps of the segments that move."""
    route = opened.task.route
    return tuple(speeds for leg, speeds in zip(legs(route), route.speeds, strict=True) if not leg.stands)


def _dosed_sequence(sequence: Equilibrium, dosed: Dosed) -> Equilibrium:
    return Equilibrium(
        h=sequence.h,
        pose=dosed.pose,
        R=rotation(dosed.pose[:, 3:]),
        rotation=sequence.rotation,
        meaning=sequence.meaning,
        pieces=dosed.pieces,
        notes=dosed.notes,
    )


def _write(job: DosedJob) -> None:
    found = job.before.folder
    assert found is not None
    inputs = {name: content for name, content in found.files.items() if name.startswith("input/")}
    dosing = {
        "bound_m": job.dosed.bound,
        "least_duration_s": job.dosed.least,
        "held_back_s": job.dosed.braked * job.dosed.h,
        "ways": [
            {
                "feed": row.feeding.value,
                "duration_s": row.duration,
                "arrived_s": row.arrived,
                "lag": lag_record(row.lag),
            }
            for row in job.rows
        ],
        "joints": joint_record(job.joints),
        "notes": list(job.dosed.notes),
    }
    write_task_folder(
        job.folder,
        inputs | sequence_files(job.after),
        {"task": found.summary["task"], "sequence": sequence_record(job.after), "dosing": dosing},
        found.task,
        found.program,
        {"command": "dose", "max_lag_m": job.dosed.bound},
    )
