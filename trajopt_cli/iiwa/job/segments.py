"""`trajopt iiwa segments`: a task's poses to the sequence the controller is fed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from trajopt_cli.errors import InputError, printable
from trajopt_cli.iiwa.job.folder import (
    Opened,
    check_place,
    sequence_files,
    sequence_record,
    start_distance,
    write_task_run,
)
from trajopt_cli.iiwa.job.force import force_notes, pressed
from trajopt_cli.iiwa.report.answer import Refused
from trajopt_cli.iiwa.task.equilibrium import counted
from trajopt_cli.iiwa.task.joint_checks import Arm, ArmOnPath, Untimed
from trajopt_cli.iiwa.task.loader import load_task, minimal_task
from trajopt_cli.iiwa.task.model import AngleMeaning, Feed, Task
from trajopt_cli.iiwa.task.segments import SegmentFacts, planned
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.runs.folder import check_replaceable, read_bytes
from trajopt_cli.runs.record import INPUT, InputFile, Inputs
from trajopt_cli.units import DEG, MM

_POSES = (".mod", ".prg", ".sys", ".csv")
_MANY = 100_000  # rows whose writing is worth a line
_AT_START = 1e-6  # m, rad: nearer counts as the same pose


@dataclass(frozen=True, eq=False)
class Segments:
    """What `segments` made: the sequence and, per segment, its facts."""

    opened: Opened
    facts: tuple[SegmentFacts, ...]
    notes: tuple[str, ...]
    folder: Path


def read_task(path: Path, task: Path | None = None) -> tuple[Task, Path, Path | None]:
    """A task, its file, and the RAPID program or CSV path that gives its poses where path is one (task: its file, else
    beside it).

    Raises InputError for mistakes in either.
    """
    if path.suffix.lower() not in _POSES:
        if task is not None:
            raise InputError(
                "--task goes with a RAPID program or a CSV path; this is a task file itself", file=str(path)
            )
        return load_task(path), path, None
    beside = task or path.with_suffix(".yaml")
    if not path.is_file():
        raise InputError("no such path" if path.suffix.lower() == ".csv" else "no such program", file=str(path))
    if not beside.is_file():
        message = f"{path} has no task file; name one with --task, or save these lines there and adapt them:"
        raise InputError(message, file=str(beside), excerpt=minimal_task(printable(path.name)))
    return load_task(beside, path), beside, path


def make_segments(
    path: Path,
    folder: Path,
    task: Path | None,
    angles: AngleMeaning | None,
    tell: Callable[[str], None] = lambda _: None,
) -> Segments | Refused:
    """Interpolate the poses of a task file (or of a RAPID program or a path as CSV with one) and write folder.

    angles: how the sequence counts them, None for the task's own way. tell: hears of progress. Refused where the joints
    are to time the segments and cannot; raises InputError for mistakes; nothing is written then.
    """
    check_place(folder, "--output")
    check_replaceable(folder)
    read, task_path, program = read_task(path, task)
    robot = load_srs(read.robot, read.X_WB)
    try:
        arm = ArmOnPath(Arm.of(read, robot), read.route.meaning) if read.by_joints else None
        equilibrium, facts = planned(read.route, tell, arm)
    except Untimed as untimed:
        return Refused("cannot be timed", [f"{task_path}: {untimed}"])
    opened = Opened(read, robot, equilibrium, feed=Feed.VELOCITY if read.follows else Feed.POSITION)
    if angles is not None:
        try:
            equilibrium = counted(equilibrium, angles, opened.X_start[:3, :3])
        except InputError as error:
            raise InputError(str(error), file=str(task_path), kind=error.kind) from error
        opened = replace(opened, equilibrium=equilibrium)
    opened = pressed(opened, equilibrium)
    notes = (*read.notes, *equilibrium.notes, *_start_notes(opened), *force_notes(opened))
    if len(equilibrium.pose) > _MANY:
        tell(f"writing {len(equilibrium.pose)} rows")
    inputs = _inputs(read, task_path, program)
    files = {one.place: one.content for one in inputs} | sequence_files(opened)
    section = sequence_record(opened) | {
        "segments": [_fact_record(one) for one in facts],
        "notes": list(notes),
    }
    write_task_run(
        folder,
        "iiwa segments",
        {"angles": equilibrium.meaning.value},
        Inputs(
            task=f"{INPUT}{task_path.name}",
            program=None if program is None else f"{INPUT}{program.name}",
            files=[one.record() for one in inputs],
        ),
        files,
        {"task": task_path.name, "sequence": section},
    )
    return Segments(opened, facts, notes, folder)


def _fact_record(fact: SegmentFacts) -> dict[str, Any]:
    record = {
        "from": fact.origin,
        "to": fact.goal,
        "length_m": fact.L_p,
        "turn_rad": fact.L_theta,
        "duration_s": fact.duration,
        "top_speed_m_s": fact.v_top,
        "top_turn_rate_rad_s": fact.omega_top,
        "binding": fact.binds,
        "dwell_s": fact.dwell,
    }
    if (passed := fact.passed) is None:
        return record
    return record | {
        "poses_passed": passed.poses,
        "deviation_m": passed.away,
        "turn_deviation_rad": passed.turned,
        "top_acceleration_m_s2": passed.a_top,
        "top_turn_acceleration_rad_s2": passed.epsilon_top,
        "top_jerk_m_s3": passed.jerk_top,
        "top_turn_jerk_rad_s3": passed.angular_jerk_top,
    }


def _start_notes(opened: Opened) -> tuple[str, ...]:
    """What the controller would do where the sequence does not begin where it is switched on."""
    away, turned = start_distance(opened)
    if away < _AT_START and turned < _AT_START:
        return ()
    return (
        f"the first pose is {away / MM:.4g} mm and {turned / DEG:.4g}° from the tool at the start joints:"
        " a controller switched on there is pulled to it at once",
    )


def _inputs(task: Task, task_path: Path, program: Path | None) -> list[InputFile]:
    """The files the task was read from: the task file, the program, and what the task names beside it."""
    if program is not None and program.name == task_path.name:
        raise InputError("--task has the program's own name; give the task file another", file=str(task_path))
    given = {path: path.name for path in (task_path, program) if path is not None}
    for path in map(Path, task.sources):
        given.setdefault(path, path.relative_to(task_path.parent).as_posix())
    return [InputFile(str(path), f"{INPUT}{name}", read_bytes(path)) for path, name in given.items()]
