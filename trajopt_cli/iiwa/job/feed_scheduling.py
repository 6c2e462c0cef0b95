"""`trajopt iiwa dose`: a folder's sequence retimed so that the controller follows it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_limits import LAGS, TURN_LAGS, Allowed, DoseFeed, Lead
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
from trajopt_cli.iiwa.job.simulation import Simulated, clamped, lag_record, run_controller
from trajopt_cli.iiwa.report.answer import Refused
from trajopt_cli.iiwa.task.angles import rotation_vector
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.model import Clamps, Feed, Profile, RotationLaw, Task
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import check_replaceable
from trajopt_cli.runs.record import INPUT
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose, Dosed
    from trajopt_cli.iiwa.task.joints import Followed

AS_PROGRAMMED, WITH_SPEED = "as programmed", "with the equilibrium's speed"
SCHEDULED = {
    DoseFeed.POSITION: "scheduled, positions",
    DoseFeed.VELOCITY: "scheduled, with speed",
    DoseFeed.INVERSE: "scheduled, inverse law",
}
LONG = 400_000
"""Rows of a sequence that is worked out although another feed is known to be faster; more take minutes."""
FRONT = 5
"""Leads of the front below the one at which the inverse feed is as fast as programmed, each half the one before."""
_EASED, _MARGIN = 12, 0.02
"""Times that the inverse feed is slowed down for the joints' accelerations, and by which fraction more each time."""
_STEADY = 1e-6  # m/s2, rad/s2, N, m: a smaller acceleration or push is rounding
_NEAR_START = 1e-6  # m, rad: a sequence that begins this near to the start begins there
_Caps = tuple[float | None, float | None]  # on the acceleration of position [m/s2] and angles [rad/s2]


@dataclass(frozen=True, eq=False)
class FeedRun:
    """The path as programmed, fed in one way, and the controller's answer; arrived [s]: None where it did not."""

    name: str
    run: Simulated
    arrived: float | None


@dataclass(frozen=True)
class FrontPoint:
    """What one lead allows: the least time [s] that was found for each feed, None where none was."""

    lead: Lead
    durations: Mapping[DoseFeed, float | None]


@dataclass(frozen=True, eq=False)
class ScheduledJob:
    """A scheduled sequence in its folder, beside the feeds of the one it came from.

    before_feeds: as programmed, with the equilibrium's speed. tried: what every feed that was asked for comes to;
    scheduled: the fastest of them that the arm can follow, run: the controller's answer to it. joints: the arm's then.
    passed_over: why faster feeds were not taken. steady: the speed [m/s] at which the arm would lag by the bound on a
    long line along its slowest axis. front: by lead, empty if not asked for. left_out: what the task has that the
    schedule does not regard.
    """

    before: Opened
    after: Opened
    scheduled: Dosed
    run: Simulated
    tried: Mapping[DoseFeed, Dosed | CannotDose]
    before_feeds: tuple[FeedRun, ...]
    joints: Followed
    passed_over: tuple[str, ...]
    steady: float
    front: tuple[FrontPoint, ...]
    left_out: tuple[str, ...]
    folder: Path

    def remarks(self) -> list[str]:
        """Feeds that were not taken and why, and notes."""
        from trajopt_cli.iiwa.controller.feed_schedule import CannotDose

        refused = [(feed, one.message) for feed, one in self.tried.items() if isinstance(one, CannotDose)]
        lines = [f"not taken: {reason}" for reason in self.passed_over]
        lines += [f"left out: {SCHEDULED[feed]}: {message}" for feed, message in refused]
        if self.left_out:
            lines.append(f"note: the schedule does not regard the task's {', '.join(self.left_out)}; simulate does")
        return [*lines, *(f"note: {note}" for note in self.scheduled.notes)]

    def record(self) -> dict[str, Any]:
        """What summary.json says of it."""
        allowed = self.scheduled.allowed
        undosed = [
            {
                "feed": one.name,
                "duration_s": one.run.opened.equilibrium.duration,
                "arrived_s": one.arrived,
                "lag": lag_record(one.run.lag),
                "largest_push_N": one.run.most_push,
            }
            for one in self.before_feeds
        ]
        return {
            "feed": self.scheduled.feed.value,
            "max_lag_m": allowed.lag,
            "max_turn_lag_rad": allowed.turn_lag,
            "max_lead": lead_record(allowed.lead),
            "max_turn_lead": lead_record(allowed.turn_lead, ("Nm", "rad")),
            "feeds": {feed.value: feed_record(made) for feed, made in self.tried.items()},
            "passed_over": list(self.passed_over),
            "undosed": undosed,
            "front": [
                {"lead": lead_record(point.lead), **{f"{feed.value}_s": s for feed, s in point.durations.items()}}
                for point in self.front
            ],
            "left_out": list(self.left_out),
            "joints": joint_record(self.joints),
            "notes": list(self.scheduled.notes),
        }


def schedule_feed(
    folder: Path, output: Path, allowed: Allowed, feed: DoseFeed | None = None, front: bool = False
) -> ScheduledJob | Refused:
    """Retime a folder's sequence: least time within what is allowed, into output.

    feed: the one to take; None for positions alone where no lead is bounded, else for the fastest of all. The sequence
    keeps its path and is nowhere faster than before, nor than the joints' speed limits. Nothing is written where there
    is no such sequence, or the arm cannot follow it. Raises InputError where output may not be replaced, and for a
    front without a bound on the lead.
    """
    from trajopt_cli.iiwa.controller.feed_bound import least_duration
    from trajopt_cli.iiwa.controller.feed_path import dose_path
    from trajopt_cli.iiwa.controller.feed_schedule import ARRIVED, ARRIVED_TURN, CannotDose, dose
    from trajopt_cli.iiwa.controller.lag import settling
    from trajopt_cli.iiwa.task.joints import Followed, follow

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
        message = "is dosed already, and its equilibrium is not its path; dose the folder it came from"
        raise InputError(message, file=str(folder))

    def none(message: str) -> Refused:
        return Refused("no sequence", [f"{folder}: {message}"])

    task, sequence, robot = before.task, before.equilibrium, before.robot
    way, turn = start_distance(before)
    if max(way, turn) > _NEAR_START:
        return none(
            f"the sequence begins {way / MM:.4g} mm and {np.degrees(turn):.3g}° from start, where the controller is"
            " switched on: no timing lags by less; let the task approach its first pose, or begin with 'at: start'"
        )
    limits = robot.profile(task.limits)
    followed = follow(
        sequence, robot, task.X_FT, task.start_joints, limits, task.definition, task.arm_angle, free=False
    )
    if not isinstance(followed, Followed):
        return none(followed.message)
    try:
        path = dose_path(sequence, None, joints=followed.trajectory.q, joint_speed=limits.velocity)
    except ValueError as error:
        return none(str(error))

    def timed(feed: DoseFeed, allowed: Allowed, acceleration: _Caps | None = None) -> Dosed | CannotDose:
        caps = acceleration or _accelerations(task)
        law, how = task.compliance, task.integration
        return dose(path, law, sequence.h, allowed, feed=feed, integration=how, acceleration=caps)

    pushes = allowed.lead is not None or allowed.turn_lead is not None
    feeds = [feed] if feed is not None else list(DoseFeed) if pushes else [DoseFeed.POSITION]
    tried: dict[DoseFeed, Dosed | CannotDose] = {}
    for one in reversed(feeds):  # the one that lags least first
        best = min((made.duration for made in tried.values() if not isinstance(made, CannotDose)), default=inf)
        least = least_duration(path, sequence.h, task.compliance, allowed, task.integration, one)
        if least > max(best, LONG * sequence.h):
            tried[one] = CannotDose(f"not worked out: it takes at least {least:.0f} s, and another feed {best:.3f} s")
        else:
            tried[one] = timed(one, allowed)
    if all(isinstance(one, CannotDose) for one in tried.values()):
        return none("; ".join(sorted({one.message for one in tried.values() if isinstance(one, CannotDose)})))
    # what happens to the controller besides its feed is left out: the schedule does not know it either
    quiet = replace(before, task=replace(task, changes=(), pushes=(), sensor=None, clamps=Clamps(), contact=None))
    found = _fastest(quiet, tried, lambda caps: timed(DoseFeed.INVERSE, allowed, caps), none)
    if isinstance(found, Refused):
        return found
    scheduled, opened, run, joints, passed_over = found
    before_feeds = []
    for name, how in ((AS_PROGRAMMED, Feed.POSITION), (WITH_SPEED, Feed.VELOCITY)):
        fed = run_controller(quiet, None, None, how, None, None)
        if isinstance(fed, Refused):
            return fed
        before_feeds.append(FeedRun(name, fed, settling(fed.x, fed.x_e[-1], ARRIVED, ARRIVED_TURN, sequence.h)))
    job = ScheduledJob(
        before,
        replace(opened, task=task),
        scheduled,
        run,
        tried,
        tuple(before_feeds),
        joints,
        passed_over,
        _steady(task, allowed.lags(task.compliance.K)[0]),
        _front(timed, allowed, feeds) if front else (),
        _left_out(task),
        output,
    )
    _write(job)
    return job


def _fastest(
    before: Opened,
    tried: dict[DoseFeed, Dosed | CannotDose],
    gentler: Callable[[_Caps], Dosed | CannotDose],
    none: Callable[[str], Refused],
) -> tuple[Dosed, Opened, Simulated, Followed, tuple[str, ...]] | Refused:
    """Of the feeds that were timed the first, by duration, whose answer breaks no limit of the joints: the sequence,
    opened, run, the arm's joints, and why faster ones were passed over.

    gentler: the inverse feed under caps on the tool's acceleration, tried in its place where joints' would break.
    """
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose
    from trajopt_cli.iiwa.task.joint_checks import ACCELERATION
    from trajopt_cli.iiwa.task.joints import Followed

    timings = [one for one in tried.values() if not isinstance(one, CannotDose)]
    refusals: list[Refused] = []
    passed_over: list[str] = []
    eased, slerp = 0, before.equilibrium.rotation is RotationLaw.SLERP
    while timings:
        made = timings.pop(min(range(len(timings)), key=lambda i: timings[i].duration))
        opened = _opened(before, made)
        run = run_controller(opened, None, None, opened.feed, None, None)
        if isinstance(run, Refused):
            refusals.append(run)
            continue
        joints = run.joints
        if not isinstance(joints, Followed):
            assert joints is not None
            refusals.append(none(joints.message))
            passed_over.append(f"{SCHEDULED[made.feed]}: {joints.message}")
            continue
        broken = [finding for finding in joints.findings if not finding.passed]
        if not broken:
            return made, opened, run, joints, tuple(passed_over)
        # what is wrong, without a remedy: those are for sequences that are not scheduled
        failed = [finding.message.partition(";")[0] for finding in broken]
        last = "NOTHING WRITTEN: the arm cannot follow; allow less lead or lag, lower v_max, or move the path"
        refusals.append(Refused("not followed", [*failed, last]))
        if made.feed is DoseFeed.INVERSE and eased < _EASED and all(one.check == ACCELERATION for one in broken):
            again = gentler(_gentler(made, slerp, min(one.limit / one.value for one in broken)))
            if not isinstance(again, CannotDose):
                eased += 1
                note = f"slowed down for {broken[0].subject}, whose acceleration would pass its limit"
                again = replace(again, notes=(*again.notes, note))
                tried[made.feed] = again
                timings.append(again)
                continue
        passed_over.append(f"{SCHEDULED[made.feed]}: {failed[0]}")
    return refusals[0]


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


def _front(
    timed: Callable[[DoseFeed, Allowed], Dosed | CannotDose], allowed: Allowed, feeds: Sequence[DoseFeed]
) -> tuple[FrontPoint, ...]:
    """Least times from the lead that the programmed speed asks for downwards, the one that is asked for among them."""
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose

    if allowed.lead is None:
        raise InputError("--front: needs a bound on the lead; give --max-lead")
    free = timed(DoseFeed.INVERSE, replace(allowed, lead=None))
    most = allowed.lead.most
    if not isinstance(free, CannotDose):
        most = free.lead if allowed.lead.stretch else free.push
    # a path that only turns pushes with nothing but rounding: what other leads allow is the same
    others = (most / 2**i for i in range(FRONT if most > _STEADY else 0))
    points = []
    for lead in (replace(allowed.lead, most=one) for one in sorted({allowed.lead.most, *others}, reverse=True)):
        made = {feed: timed(feed, replace(allowed, lead=lead)) for feed in feeds}
        durations = {feed: None if isinstance(one, CannotDose) else one.duration for feed, one in made.items()}
        points.append(FrontPoint(lead, durations))
    return tuple(points)


def _accelerations(task: Task) -> _Caps:
    """The least a_max [m/s2] and epsilon_max [rad/s2] of the task's segments, None where its profile has none."""
    if task.route.profile is Profile.THESIS:
        return None, None
    caps = zip(*((one.a_max, one.epsilon_max) for one in task.route.speeds), strict=True)
    least = (min((cap for cap in column if cap is not None), default=None) for column in caps)
    return next(least), next(least)


def _steady(task: Task, bound: float) -> float:
    """The speed [m/s] at which the lag D v / K is bound [m] along the axis that lags most."""
    damped = (task.compliance.D[:3] > 0) & (task.compliance.K[:3] > 0)
    if not damped.any():
        return float("inf")
    return float(bound * np.min(task.compliance.K[:3][damped] / task.compliance.D[:3][damped]))


def _left_out(task: Task) -> tuple[str, ...]:
    has = {
        "contact": task.contact is not None,
        "sensor errors": task.sensor is not None,
        "clamps": clamped(task),
        "changes": bool(task.changes),
        "pushes": bool(task.pushes),
    }
    return tuple(name for name, there in has.items() if there)


def _opened(before: Opened, made: Dosed) -> Opened:
    """The scheduled sequence in place of the one before, how it is fed, and its plan where that is another."""
    sequence = before.equilibrium

    def of(pose: Array, R: Array, notes: tuple[str, ...]) -> Equilibrium:
        return Equilibrium(sequence.h, pose, R, sequence.rotation, sequence.meaning, made.pieces, notes)

    return replace(
        before,
        equilibrium=of(made.pose, made.R, made.notes),
        plan=of(made.plan, made.R_plan, ()) if made.feed is DoseFeed.INVERSE else None,
        feed=Feed.VELOCITY if made.feed is DoseFeed.VELOCITY else Feed.POSITION,
    )


def lead_record(lead: Lead | None, units: tuple[str, str] = ("N", "m")) -> dict[str, Any] | None:
    """A bound on the lead as plain data."""
    return None if lead is None else {"most": lead.most, "unit": units[lead.stretch]}


def feed_record(made: Dosed | CannotDose) -> dict[str, Any]:
    """What one feed comes to, as plain data."""
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose

    if isinstance(made, CannotDose):
        return {"refused": made.message}
    return {
        "duration_s": made.duration,
        "least_duration_s": made.least,
        "arrived_s": made.arrived,
        "lag": lag_record(made.lag),
        "largest_push_N": made.push,
        "largest_turn_push_Nm": made.turn_push,
        "held_back_s": made.braked * made.h,
    }


def _write(job: ScheduledJob) -> None:
    from trajopt_cli.iiwa.job.pages import feed_page

    found = job.before.folder
    assert found is not None
    inputs = {name: content for name, content in found.contents.items() if name.startswith(INPUT)}
    allowed = job.scheduled.allowed
    options = {"max_lag_m": allowed.lag, "max_lead": lead_record(allowed.lead), "feed": job.scheduled.feed.value}
    write_task_run(
        job.folder,
        "iiwa dose",
        options,
        found.record.inputs,
        {**inputs, **sequence_files(job.after), REPORT: feed_page(job)},
        {"task": found.sections()["task"], "sequence": sequence_record(job.after), "dosing": job.record()},
    )
