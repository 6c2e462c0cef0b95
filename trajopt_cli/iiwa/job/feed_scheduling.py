"""`trajopt iiwa dose`: a folder's sequence retimed so that the controller follows it."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.controller.feed_path import LAGS, TURN_LAGS, Allowed, CannotDose, Lead, dose_path
from trajopt_cli.iiwa.controller.feed_schedule import ARRIVED, ARRIVED_TURN, Dosed, FeedTask, dose
from trajopt_cli.iiwa.controller.lag import settling
from trajopt_cli.iiwa.job.folder import (
    Opened,
    check_place,
    counted_from_start,
    open_folder,
    sequence_files,
    sequence_record,
    start_distance,
    write_task_run,
)
from trajopt_cli.iiwa.job.joints import joint_record
from trajopt_cli.iiwa.job.kept_push import KeptPush, gentler, pushed
from trajopt_cli.iiwa.job.simulation import Simulated, clamped, lag_record, run_controller
from trajopt_cli.iiwa.report.answer import Refused
from trajopt_cli.iiwa.task.angles import rotation_vector
from trajopt_cli.iiwa.task.joint_checks import ACCELERATION
from trajopt_cli.iiwa.task.joints import Followed
from trajopt_cli.iiwa.task.model import Change, Clamps, Feed, Profile, RotationLaw, Task
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import check_replaceable
from trajopt_cli.runs.record import INPUT
from trajopt_cli.units import MM

AS_PROGRAMMED, SCHEDULED = "as programmed", "scheduled, inverse law"
FEED = "inverse"
"""The feed's name in summary.json."""
FRONT = 5
"""Leads of the front below the one at which the inverse feed is as fast as programmed, each half the one before."""
_EASED, _MARGIN = 12, 0.02
"""Times that the inverse feed is slowed down for the joints' accelerations, and by which fraction more each time."""
_STEADY = 1e-6  # m/s2, rad/s2, N, m: a smaller acceleration or push is rounding
_NEAR_START = 1e-6  # m, rad: a sequence that begins this near to the start begins there
_Caps = tuple[float | None, float | None]  # on the acceleration of position [m/s2] and angles [rad/s2]


@dataclass(frozen=True)
class FrontPoint:
    """What one lead allows: the least time [s] that was found, None where none was."""

    lead: Lead
    duration: float | None


@dataclass(frozen=True, eq=False)
class ScheduledJob:
    """A scheduled sequence in its folder, beside the one it came from.

    run: the controller's answer to the scheduled sequence, joints: the arm's then; programmed: its answer to the one
    before, arrived [s]: when the arm did then, None where it did not. push: on what the tool touches, None
    where that is nothing. steady: the speed [m/s] that the lead allows on a long line along the slowest axis, where no
    lead was asked for; else None. front: by lead, empty if not asked for. left_out: what the task has that the schedule
    does not regard.
    """

    before: Opened
    after: Opened
    scheduled: Dosed
    run: Simulated
    programmed: Simulated
    arrived: float | None
    joints: Followed
    push: KeptPush | None
    steady: float | None
    front: tuple[FrontPoint, ...]
    left_out: tuple[str, ...]
    folder: Path

    def remarks(self) -> list[str]:
        """Notes, one line each."""
        lines = []
        if self.left_out:
            lines.append(f"note: the schedule does not regard the task's {', '.join(self.left_out)}; simulate does")
        return [*lines, *(f"note: {note}" for note in self.scheduled.notes)]

    def record(self) -> dict[str, Any]:
        """What summary.json says of it."""
        allowed, one = self.scheduled.allowed, self.programmed
        undosed = {
            "feed": AS_PROGRAMMED,
            "duration_s": one.opened.equilibrium.duration,
            "arrived_s": self.arrived,
            "lag": lag_record(one.lag),
            "largest_push_N": one.most_push,
        }
        return {
            "feed": FEED,
            "max_lag_m": allowed.lag,
            "max_turn_lag_rad": allowed.turn_lag,
            "max_lead": lead_record(allowed.lead),
            "max_turn_lead": lead_record(allowed.turn_lead, ("Nm", "rad")),
            "feeds": {FEED: feed_record(self.scheduled)},
            "undosed": [undosed],
            "contact": None if self.push is None else self.push.record(),
            "front": [{"lead": lead_record(one.lead), f"{FEED}_s": one.duration} for one in self.front],
            "left_out": list(self.left_out),
            "joints": joint_record(self.joints),
            "notes": list(self.scheduled.notes),
        }


def schedule_feed(
    folder: Path,
    output: Path,
    allowed: Allowed,
    page: Callable[[ScheduledJob], bytes],
    front: bool = False,
    unbounded: bool = False,
) -> ScheduledJob | Refused:
    """Retime a folder's sequence: least time within what is allowed, into output. page: makes report.html.

    Where no lead is bounded, a spring that is stretched by the lag is taken for one, unless unbounded. The sequence
    keeps its path and is nowhere faster than before, nor than the joints' speed limits. Where the tool touches what the
    task has, the push is kept as KeptPush says. Nothing is written where there is no such sequence, or the arm cannot
    follow it; a front needs a bound on the lead. Raises InputError where output may not be replaced.
    """
    for option, value, (least, most), unit in (
        ("--max-lag", allowed.lag, LAGS, "m"),
        ("--max-turn-lag", allowed.turn_lag, TURN_LAGS, "rad"),
    ):
        if value is not None and not least <= value <= most:
            raise InputError(f"{option}: {value:g} {unit} is not within {least:g} and {most:.4g} {unit}")
    check_place(output, "--output")
    if output.absolute() == folder.absolute() or output.resolve() == folder.resolve():
        raise InputError("--output: is RESULTS itself; the sequence to dose would be lost", file=str(output))
    check_replaceable(output)
    before = counted_from_start(open_folder(folder))
    if before.plan is not None or before.feed is not Feed.POSITION:
        message = "is dosed already, or presses with a force: its equilibrium is not its path; dose one that is"
        raise InputError(message, file=str(folder))
    if before.task.impedance is not None:
        raise InputError("controller: dosing goes by the admittance controller's law", file=before.task.file)
    try:
        job = _scheduled(before, output, allowed, front, unbounded)
    except CannotDose as error:
        return Refused("no sequence", [f"{folder}: {error}"])
    if isinstance(job, ScheduledJob):
        _write(job, page(job))
    return job


def _scheduled(before: Opened, output: Path, allowed: Allowed, front: bool, unbounded: bool) -> ScheduledJob | Refused:
    """As schedule_feed, nothing written. Raises CannotDose."""
    task, sequence, robot = before.task, before.equilibrium, before.robot
    way, turn = start_distance(before)
    if max(way, turn) > _NEAR_START:
        raise CannotDose(
            f"the sequence begins {way / MM:.4g} mm and {np.degrees(turn):.3g}° from start, where the controller is"
            " switched on: no timing lags by less; let the task approach its first pose, or begin with 'at: start'"
        )
    in_time = next((one.t for one in task.changes if one.pose is None and one.t > 0 and not one.reframes), None)
    if in_time is not None:
        raise CannotDose(
            f"the controller changes at {in_time:g} s, and seconds do not move with the path; name the pose instead,"
            " 'changes: [{at: NAME, ...}]'"
        )
    followed = before.follow(sequence)
    if not isinstance(followed, Followed):
        raise CannotDose(followed.message)
    steady = None
    if allowed.lead is None and allowed.turn_lead is None and not unbounded:
        leads = [None if lag is None else Lead(lag, stretch=True) for lag in (allowed.lag, allowed.turn_lag)]
        allowed = replace(allowed, lead=leads[0], turn_lead=leads[1])
        steady = _steady(task, allowed.lag)
    begins = {one.first * sequence.h: i for i, one in reversed(list(enumerate(sequence.pieces)))}
    laws = [(begins[one.t], one.compliance) for one in task.changes if one.compliance and one.t in begins]
    slower = None

    def timed(allowed: Allowed, acceleration: _Caps | None = None) -> Dosed:
        path = dose_path(sequence, followed.trajectory.q, robot.profile(task.limits).velocity, slower)
        caps = acceleration or _accelerations(task)
        return dose(FeedTask(path, task.compliance, sequence.h, task.integration, caps, laws), allowed)

    # what happens to the controller besides its feed is left out: the schedule does not know it either
    changes = [Change(one.t, one.compliance, pose=one.pose) for one in task.changes if one.compliance is not None]
    bare = replace(task, changes=tuple(changes), pushes=(), sensor=None, clamps=Clamps(), contact=None)
    quiet = replace(before, task=bare)
    programmed = pushed(before)
    if isinstance(programmed, Refused):
        return programmed
    push: KeptPush | Refused | None = None
    for slower in gentler(task, sequence, programmed):  # noqa: B007
        found = _followed(quiet, timed(allowed), lambda caps: timed(allowed, caps))
        if isinstance(found, Refused):
            return found
        scheduled, run, joints = found
        push = None if programmed is None else pushed(_opened(before, scheduled), programmed.programmed)
        if push is None or (isinstance(push, KeptPush) and push.kept):
            break
    if isinstance(push, Refused):
        return push
    if push is not None and not push.kept:
        raise CannotDose(push.apart)
    fed = run_controller(quiet, None, None, Feed.POSITION, None, None)
    if isinstance(fed, Refused):
        return fed
    return ScheduledJob(
        before,
        _opened(before, scheduled),
        scheduled,
        run,
        fed,
        settling(fed.x, fed.x_e[-1], ARRIVED, ARRIVED_TURN, sequence.h),
        joints,
        push,
        steady,
        _front(timed, allowed) if front else (),
        _left_out(task),
        output,
    )


def _followed(
    before: Opened, made: Dosed, gentler: Callable[[_Caps], Dosed]
) -> tuple[Dosed, Simulated, Followed] | Refused:
    """The first of ever slower feeds whose answer breaks no limit of the joints: the sequence, its run, and the arm's
    joints.

    gentler: the feed under caps on the tool's acceleration, tried where joints' would break.
    """
    refused, slerp = None, before.equilibrium.rotation is RotationLaw.SLERP
    for _ in range(_EASED + 1):
        opened = _opened(before, made)
        run = run_controller(opened, None, None, opened.feed, None, None)
        if isinstance(run, Refused):
            return refused or run
        joints = run.joints
        if not isinstance(joints, Followed):
            assert joints is not None
            if refused is None:
                raise CannotDose(joints.message)
            break
        broken = [finding for finding in joints.findings if not finding.passed]
        if not broken:
            return made, run, joints
        # what is wrong, without a remedy: those are for sequences that are not scheduled
        failed = [finding.message.partition(";")[0] for finding in broken]
        last = "NOTHING WRITTEN: the arm cannot follow; allow less lead or lag, lower v_max, or move the path"
        refused = refused or Refused("not followed", [*failed, last])
        if any(one.check != ACCELERATION for one in broken):
            break
        note = f"slowed down for {broken[0].subject}, whose acceleration would pass its limit"
        try:
            made = gentler(_gentler(made, slerp, min(one.limit / one.value for one in broken)))
        except CannotDose:
            break
        made = replace(made, notes=(*made.notes, note))
    assert refused is not None
    return refused


def _gentler(made: Dosed, slerp: bool, fraction: float) -> _Caps:
    """Caps on the tool's acceleration at a fraction of what a sequence takes, of position and orientation.

    slerp: orientations are timed by how far they turn, else by their three angles.
    """
    angles = np.diff(made.x[:, 3:], axis=0)
    turns = rotation_vector(made.R_x[1:] @ np.swapaxes(made.R_x[:-1], 1, 2)) if slerp else angles
    steps = (np.diff(made.x[:, :3], axis=0), turns)
    most = [float(np.max(np.linalg.norm(np.diff(one, axis=0), axis=1))) / made.h**2 for one in steps]
    caps = [fraction * (1 - _MARGIN) * one if one > _STEADY else None for one in most]
    return caps[0], caps[1]


def _front(timed: Callable[[Allowed], Dosed], allowed: Allowed) -> tuple[FrontPoint, ...]:
    """Least times from the lead that the programmed speed asks for downwards, the one that is asked for among them."""
    assert allowed.lead is not None
    lead, most = allowed.lead, allowed.lead.most
    with suppress(CannotDose):
        free = timed(replace(allowed, lead=None))
        most = free.lead if lead.stretch else free.push
    # a path that only turns pushes with nothing but rounding: what other leads allow is the same
    others = (most / 2**i for i in range(FRONT if most > _STEADY else 0))
    points = []
    for one in (replace(lead, most=most) for most in sorted({lead.most, *others}, reverse=True)):
        duration = None
        with suppress(CannotDose):
            duration = timed(replace(allowed, lead=one)).duration
        points.append(FrontPoint(one, duration))
    return tuple(points)


def _accelerations(task: Task) -> _Caps:
    """The least a_max [m/s2] and epsilon_max [rad/s2] of the task's segments, None where its profile has none."""
    if task.route.profile is Profile.THESIS:
        return None, None
    least = np.fmin.reduce(task.route.caps[:, 2:4], axis=0)
    return tuple(None if np.isnan(cap) else float(cap) for cap in least)  # type: ignore[return-value]


def _steady(task: Task, bound: float) -> float:
    """The speed [m/s] at which D v is what a spring stretched by bound [m] pushes with, along the slowest axis."""
    damped = (task.compliance.D[:3] > 0) & (task.compliance.K[:3] > 0)
    if not damped.any():
        return float("inf")
    return float(bound * np.min(task.compliance.K[:3][damped] / task.compliance.D[:3][damped]))


def _left_out(task: Task) -> tuple[str, ...]:
    has = {
        "sensor errors": task.sensor is not None,
        "clamps": clamped(task) and task.contact is None,
        "changes of frames": any(change.reframes for change in task.changes),
        "pushes": bool(task.pushes),
    }
    return tuple(name for name, there in has.items() if there)


def _opened(before: Opened, made: Dosed) -> Opened:
    """The scheduled sequence in place of the one before, and its plan, with what changes at its poses."""
    plan = replace(before.equilibrium, pose=made.plan, R=made.R_plan, pieces=made.pieces, notes=())
    fed = replace(plan, pose=made.pose, R=made.R, notes=made.notes)
    return replace(
        before, task=replace(before.task, changes=plan.timed(before.task.changes)), equilibrium=fed, plan=plan
    )


def lead_record(lead: Lead | None, units: tuple[str, str] = ("N", "m")) -> dict[str, Any] | None:
    """A bound on the lead as plain data."""
    return None if lead is None else {"most": lead.most, "unit": units[lead.stretch]}


def feed_record(made: Dosed) -> dict[str, Any]:
    """What a schedule comes to, as plain data."""
    return {
        "duration_s": made.duration,
        "least_duration_s": made.least,
        "arrived_s": made.arrived,
        "lag": lag_record(made.lag),
        "largest_push_N": made.push,
        "largest_turn_push_Nm": made.turn_push,
    }


def _write(job: ScheduledJob, page: bytes) -> None:
    found = job.before.folder
    assert found is not None
    inputs = {name: content for name, content in found.contents.items() if name.startswith(INPUT)}
    allowed = job.scheduled.allowed
    options = {"max_lag_m": allowed.lag, "max_lead": lead_record(allowed.lead), "feed": FEED}
    write_task_run(
        job.folder,
        "iiwa dose",
        options,
        found.record.inputs,
        {**inputs, **sequence_files(job.after), REPORT: page},
        {"task": found.sections()["task"], "sequence": sequence_record(job.after), "dosing": job.record()},
    )
