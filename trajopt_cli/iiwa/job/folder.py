"""The results folder of `trajopt iiwa`: a task, the sequence made from it, and what later commands added.

summary.json has one section per command. A command that adds to a folder writes the whole folder anew, in one step.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np
from pydantic import Field, model_validator

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, axis_angle
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import (
    Equilibrium,
    Piece,
    counted,
    read_angles_csv,
    read_quaternion_csv,
    write_angles_csv,
    write_quaternion_csv,
)
from trajopt_cli.iiwa.task.joint_checks import Arm
from trajopt_cli.iiwa.task.joints import Followed, Unfollowable, follow
from trajopt_cli.iiwa.task.loader import load_task
from trajopt_cli.iiwa.task.model import AngleMeaning, Feed, RotationLaw, Task
from trajopt_cli.quantity import complain
from trajopt_cli.robot.srs import SrsRobot, load_srs
from trajopt_cli.runs import RUN, SUMMARY
from trajopt_cli.runs.files import check_writable
from trajopt_cli.runs.folder import TASK, ResultsFolder, read_run, write_run
from trajopt_cli.runs.record import Inputs, RunRecord, Section, as_json

if TYPE_CHECKING:
    from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective

EQUILIBRIUM, QUATERNIONS, JOINTS, SIMULATION = (
    "equilibrium.csv",
    "equilibrium_quaternion.csv",
    "joints.csv",
    "simulation.csv",
)
PLAN, PLAN_QUATERNIONS = "plan.csv", "plan_quaternion.csv"
"""Where the arm should be, in folders whose equilibrium leads it there (dose, inverse feed)."""


class TaskRecord(RunRecord[dict[str, Any]]):
    """run.json of trajopt iiwa. inputs.task: the task file; inputs.program: the RAPID program in place of its poses."""

    KIND: ClassVar[str] = TASK
    LIBRARIES: ClassVar[tuple[str, ...]] = ("numpy", "pin", "ruckig")

    @model_validator(mode="after")
    def _has_a_task(self) -> TaskRecord:
        if self.inputs.task is None:
            raise complain("inputs.task: is missing")
        return self


class PieceSection(Section):
    """A leg or a dwell of a sequence: first row, last row (both included), the poses' names."""

    first: int
    last: int
    origin: str = Field(alias="from")
    goal: str = Field(alias="to")
    dwell: bool


class SequenceSection(Section):
    """What summary.json says of the sequence and its CSV files do not.

    Each piece begins at the row where the one before ends, the first at 0.
    """

    period_s: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    rotation: Annotated[RotationLaw, Field(strict=False)]
    angles: Annotated[AngleMeaning, Field(strict=False)]
    pieces: Annotated[list[PieceSection], Field(min_length=1)]
    feed: Annotated[Feed, Field(strict=False)] = Feed.POSITION

    @property
    def rows(self) -> int:
        """How many rows the sequence has."""
        return self.pieces[-1].last + 1

    @model_validator(mode="after")
    def _joined(self) -> SequenceSection:
        row = 0
        for i, piece in enumerate(self.pieces):
            if not row == piece.first <= piece.last:
                raise complain(f"pieces[{i}]: rows {piece.first} to {piece.last} do not go on from row {row}")
            row = piece.last
        return self


class TaskSummary(Section):
    """summary.json, as far as it is read back."""

    sequence: SequenceSection


TaskRun = ResultsFolder[TaskRecord]


@dataclass(frozen=True, eq=False)
class Opened:
    """A task, its robot, mounted, and its equilibrium sequence; folder: where it came from, None for a fresh one.

    feed: what the controller is fed of it. plan: where the arm should be at every row, None where that is the
    equilibrium.
    """

    task: Task
    robot: SrsRobot
    equilibrium: Equilibrium
    folder: TaskRun | None = None
    feed: Feed = Feed.POSITION
    plan: Equilibrium | None = None

    @cached_property
    def arm(self) -> Arm:
        """The arm that follows."""
        return Arm.of(self.task, self.robot)

    @property
    def X_start(self) -> Array:
        """The tool in the world (4, 4) where the controller is switched on."""
        return self.arm.X_start

    def follow(
        self, sequence: Equilibrium, free: bool = False, stops: bool = True, objective: ArmAngleObjective | None = None
    ) -> Followed | Unfollowable:
        """The arm's joints along a sequence, as task.joints.follow has them."""
        return follow(sequence, self.arm, free, stops, objective)


def start_distance(opened: Opened) -> tuple[float, float]:
    """How far the sequence's first pose is from the tool where the controller is switched on [m], [rad]."""
    X, sequence = opened.X_start, opened.equilibrium
    turned = axis_angle(X[:3, :3].T @ sequence.rotations(X[:3, :3])[0])[1]
    return float(np.linalg.norm(sequence.pose[0, :3] - X[:3, 3])), turned


def check_place(place: Path | None, option: str) -> None:
    """Before the work: place can be made, and lies in no results folder, which what it did not write would spoil.

    Raises InputError naming the option.
    """
    if place is None:
        return
    full = place.absolute()
    try:
        for outer in (full, *full.parents):
            if outer.exists() and not outer.is_dir():
                raise InputError(f"is a file; {option} names a folder", file=str(outer))
            if (outer / RUN).is_file() and (outer != full or option != "--output"):
                message = f"{option}: lies in the results folder {outer}, which keeps to its own files; choose another"
                raise InputError(message, file=str(place))
    except OSError as error:
        raise InputError(f"{option}: {error.strerror}", file=str(place)) from error
    check_writable(place, into=True)


@of_kind(ErrorKind.RESULTS)
def open_folder(folder: Path) -> Opened:
    """A folder read back: its task, and the sequence as its files have it. Raises InputError if it is none."""
    found = read_task_run(folder)
    record, inputs = found.summary(TaskSummary).sequence, found.record.inputs
    program = None if inputs.program is None else folder / inputs.program
    task = load_task(folder / str(inputs.task), program)
    robot = load_srs(task.robot, task.X_WB)
    if abs(record.period_s - task.route.h) > 1e-9 * task.route.h:
        message = (
            f"summary.json has a period of {record.period_s:g} s, the task {task.route.h:g} s; make the folder again"
        )
        raise InputError(message, file=str(folder))
    X_start = Arm.of(task, robot).X_start
    sequence = _sequence(found, EQUILIBRIUM, QUATERNIONS, record, X_start)
    plan = _sequence(found, PLAN, PLAN_QUATERNIONS, record, X_start) if PLAN in found.contents else None
    task = replace(task, changes=(plan or sequence).timed(task.changes))
    return Opened(task, robot, sequence, found, record.feed, plan)


def counted_from_start(opened: Opened) -> Opened:
    """The same with angles counted from the start's orientation, as the controller means them.

    Raises InputError where an angle then passes its limit.
    """
    try:
        R_start = opened.X_start[:3, :3]
        sequence = counted(opened.equilibrium, AngleMeaning.RELATIVE, R_start)
        plan = None if opened.plan is None else counted(opened.plan, AngleMeaning.RELATIVE, R_start)
    except InputError as error:
        raise InputError(str(error), file=opened.task.file, kind=error.kind) from error
    return replace(opened, equilibrium=sequence, plan=plan)


@of_kind(ErrorKind.RESULTS)
def read_task_run(folder: Path) -> TaskRun:
    """A folder read back. Raises InputError for a folder that is none, or whose files were changed since."""
    return read_run(folder, TaskRecord, (SUMMARY,))


def read_summary(folder: Path) -> Mapping[str, Any]:
    """summary.json of a folder: one section per command."""
    return read_task_run(folder).sections()


def write_task_run(
    folder: Path,
    command: str,
    options: Mapping[str, Any],
    inputs: Inputs,
    files: Mapping[str, bytes],
    sections: Mapping[str, Any],
    instead_of: TaskRun | None = None,
) -> None:
    """Write a folder whole; files: everything but summary.json, which gets the sections, and run.json. instead_of: the
    folder as it was read, where it is added to.

    Raises InputError where folder may not be replaced.
    """
    content = {**files, SUMMARY: as_json(sections)}
    write_run(folder, TaskRecord, content, command, instead_of, options=dict(options), inputs=inputs)


def add_to_folder(opened: Opened, files: Mapping[str, bytes], sections: Mapping[str, Any]) -> None:
    """Write the folder anew with these files and these sections of its summary added or replaced."""
    found = opened.folder
    assert found is not None
    record, sections = found.record, {**found.sections(), **sections}
    content = {**found.contents, **files}
    write_task_run(found.folder, record.command, record.options, record.inputs, content, sections, found)


def sequence_files(opened: Opened) -> dict[str, bytes]:
    """The sequence as CSV: angles, and quaternions of the tool in the world."""
    files = {}
    for sequence, angles, quaternions in (
        (opened.equilibrium, EQUILIBRIUM, QUATERNIONS),
        (opened.plan, PLAN, PLAN_QUATERNIONS),
    ):
        if sequence is not None:
            R_WT = sequence.rotations(opened.X_start[:3, :3])
            files[angles] = write_angles_csv(sequence).encode()
            files[quaternions] = write_quaternion_csv(sequence.t, sequence.pose[:, :3], R_WT).encode()
    return files


def sequence_record(opened: Opened) -> dict[str, Any]:
    """What summary.json says of a sequence."""
    sequence, route = opened.equilibrium, opened.task.route
    return {
        "robot": opened.task.robot,
        "period_s": sequence.h,
        "duration_s": sequence.duration,
        "rows": len(sequence.pose),
        "profile": route.profile.value,
        "rotation": sequence.rotation.value,
        "angles": sequence.meaning.value,
        "feed": opened.feed.value,
        "pieces": [
            {"first": one.first, "last": one.last, "from": one.origin, "to": one.goal, "dwell": one.dwell}
            for one in sequence.pieces
        ],
    }


def _sequence(found: TaskRun, angles: str, quaternions: str, record: SequenceSection, X_start: Array) -> Equilibrium:
    """A sequence from its files; its matrices count as its angles do."""
    _, pose = read_angles_csv(found.text(angles), str(found.folder / angles))
    _, _, R_WT = read_quaternion_csv(found.text(quaternions), str(found.folder / quaternions))
    if not len(pose) == len(R_WT) == record.rows:
        rows = f"{len(pose)} and {len(R_WT)} rows, summary.json says {record.rows}"
        raise InputError(f"{angles} and {quaternions} have {rows}; make the folder again", file=str(found.folder))
    law, meaning = record.rotation, record.angles
    pieces = tuple(Piece(one.first, one.last, one.origin, one.goal, one.dwell) for one in record.pieces)
    R = rotation(pose[:, 3:])
    if law is RotationLaw.SLERP:
        R = R_WT @ X_start[:3, :3].T if meaning is AngleMeaning.RELATIVE else R_WT
    return Equilibrium(record.period_s, pose, R, law, meaning, pieces)
