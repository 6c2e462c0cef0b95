"""`trajopt iiwa dose`: a folder's sequence retimed so that the controller follows it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.compliance.job.folder import (
    Opened,
    check_place,
    counted_from_start,
    open_folder,
    sequence_files,
    sequence_record,
    write_task_run,
)
from trajopt_cli.compliance.job.joints import joint_record
from trajopt_cli.compliance.job.simulation import NoRun, Simulated, lag_record, run_controller
from trajopt_cli.compliance.task.angles import rotation
from trajopt_cli.compliance.task.equilibrium import Equilibrium
from trajopt_cli.compliance.task.model import Clamps, Feed, Task
from trajopt_cli.errors import InputError
from trajopt_cli.runs.folder import check_replaceable
from trajopt_cli.runs.record import INPUT

if TYPE_CHECKING:
    from trajopt_cli.compliance.controller.dose import CannotDose, Dosed
    from trajopt_cli.compliance.task.joints import Followed, Unfollowable

AS_PROGRAMMED, WITH_SPEED, DOSED = "as programmed", "with the equilibrium's speed", "dosed"
_ARRIVED_WITHIN, _TURNED_WITHIN = 1e-3, np.radians(0.1)  # m, rad


@dataclass(frozen=True, eq=False)
class Way:
    """One way to feed the path, and the controller's answer to it: name, when the arm arrived [s] (None: not yet)."""

    name: str
    run: Simulated
    arrived: float | None


@dataclass(frozen=True, eq=False)
class DosedJob:
    """A dosed sequence in its folder, beside the ways to feed the one it came from.

    ways: as programmed, with the equilibrium's speed, dosed. joints: the arm's, as it follows the dosed sequence.
    turn_bound [rad]: None where angles may lag as they like. steady: the speed [m/s] at which the arm would lag by the
    bound on a long line along its slowest axis. left_out: what the task has that dosing does not look at.
    """

    before: Opened
    after: Opened
    dosed: Dosed
    turn_bound: float | None
    ways: tuple[Way, ...]
    joints: Followed
    steady: float
    left_out: tuple[str, ...]
    folder: Path


@dataclass(frozen=True)
class NotFollowed:
    """The arm could not follow the dosed sequence's answer: one sentence per joint and limit."""

    sentences: tuple[str, ...]


def dose_folder(
    folder: Path, output: Path, bound: float, turn_bound: float | None
) -> DosedJob | CannotDose | Unfollowable | NotFollowed | NoRun:
    """Retime a folder's sequence: least time with a lag of at most bound [m] (and turn_bound [rad]), into output.

    The sequence keeps its path and is nowhere faster than before, nor than the joints' speed limits. Nothing is written
    where there is no such sequence, or the arm cannot follow it. Raises InputError where output may not be replaced.
    """
    from trajopt_cli.compliance.controller.dose import BOUNDS, TURN_BOUNDS, CannotDose, dose
    from trajopt_cli.compliance.controller.dose_path import dose_path
    from trajopt_cli.compliance.task.joints import Followed, follow

    for option, value, (least, most), unit in (
        ("--max-lag", bound, BOUNDS, "m"),
        ("--max-turn-lag", turn_bound, TURN_BOUNDS, "rad"),
    ):
        if value is not None and not least <= value <= most:
            raise InputError(f"{option}: {value:g} {unit} is not within {least:g} and {most:g} {unit}")
    check_place(output, "--output")
    if output.absolute() == folder.absolute() or output.resolve() == folder.resolve():
        raise InputError("--output: is RESULTS itself; the sequence to dose would be lost", file=str(output))
    check_replaceable(output)
    before = counted_from_start(open_folder(folder))
    task, sequence = before.task, before.equilibrium
    limits = before.robot.profile(task.limits)
    followed = follow(
        sequence, before.robot, task.X_FT, task.start_joints, limits, task.definition, task.arm_angle, free=False
    )
    if not isinstance(followed, Followed):
        return followed
    try:
        path = dose_path(sequence, None, joints=followed.trajectory.q, joint_speed=limits.velocity)
        dosed = dose(path, task.compliance, sequence.h, bound, turn_bound=turn_bound, integration=task.integration)
    except ValueError as error:
        return CannotDose(str(error))
    if isinstance(dosed, CannotDose):
        return dosed
    # what happens to the controller besides its feed is left out: the dosing does not know it either
    quiet = replace(task, changes=(), pushes=(), sensor=None, clamps=Clamps(), contact=None)
    after = replace(before, equilibrium=_dosed_sequence(sequence, dosed))
    ways = []
    for name, opened, feed in (
        (AS_PROGRAMMED, before, Feed.POSITION),
        (WITH_SPEED, before, Feed.VELOCITY),
        (DOSED, after, Feed.POSITION),
    ):
        run = run_controller(replace(opened, task=quiet), None, None, feed, None, None)
        if isinstance(run, NoRun):
            return run
        ways.append(Way(name, run, _arrived(run)))
    joints = ways[-1].run.joints
    if not isinstance(joints, Followed):
        assert joints is not None
        return joints
    failed = tuple(finding.message for finding in joints.findings if not finding.passed)
    if failed:
        return NotFollowed(failed)
    job = DosedJob(before, after, dosed, turn_bound, tuple(ways), joints, _steady(task, bound), _left_out(task), output)
    _write(job)
    return job


def _arrived(run: Simulated) -> float | None:
    """From when on the arm is within 1 mm and 0.1 deg of the end [s]; None where that is later than the run."""
    away = np.linalg.norm((run.x - run.x_e[-1])[:, :3], axis=1) > _ARRIVED_WITHIN
    turned = np.linalg.norm((run.x - run.x_e[-1])[:, 3:], axis=1) > _TURNED_WITHIN
    late = np.flatnonzero(away | turned)
    if not late.size:
        return 0.0
    return None if late[-1] == len(run.x) - 1 else float(run.t[late[-1] + 1])


def _steady(task: Task, bound: float) -> float:
    """The speed [m/s] at which the lag D v / K is bound [m] along the axis that lags most."""
    damped = task.compliance.D[:3] > 0
    if not damped.any():
        return float("inf")
    return float(bound * np.min(task.compliance.K[:3][damped] / task.compliance.D[:3][damped]))


def _left_out(task: Task) -> tuple[str, ...]:
    clamped = bool(np.isfinite(task.clamps.torque).any() or np.isfinite(task.clamps.force).any())
    has = {
        "contact": task.contact is not None,
        "sensor errors": task.sensor is not None,
        "clamps": clamped,
        "changes": bool(task.changes),
        "pushes": bool(task.pushes),
    }
    return tuple(name for name, there in has.items() if there)


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
    inputs = {name: content for name, content in found.contents.items() if name.startswith(INPUT)}
    dosing = {
        "bound_m": job.dosed.bound,
        "least_duration_s": job.dosed.least,
        "held_back_s": job.dosed.braked * job.dosed.h,
        "max_turn_lag_rad": job.turn_bound,
        "ways": [
            {
                "feed": way.name,
                "duration_s": way.run.opened.equilibrium.duration,
                "arrived_s": way.arrived,
                "lag": lag_record(way.run.lag),
            }
            for way in job.ways
        ],
        "left_out": list(job.left_out),
        "joints": joint_record(job.joints),
        "notes": list(job.dosed.notes),
    }
    write_task_run(
        job.folder,
        "iiwa dose",
        {"max_lag_m": job.dosed.bound},
        found.record.inputs,
        inputs | sequence_files(job.after),
        {"task": found.sections()["task"], "sequence": sequence_record(job.after), "dosing": dosing},
    )
