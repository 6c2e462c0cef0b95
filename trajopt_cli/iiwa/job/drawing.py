"""Pictures of runs, feed schedules and joints, made from what the commands found."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np

from trajopt_cli.iiwa.job.feed_scheduling import AS_PROGRAMMED, SCHEDULED, ScheduledJob
from trajopt_cli.iiwa.job.folder import Opened
from trajopt_cli.iiwa.job.simulation import Simulated, frames_change
from trajopt_cli.iiwa.report.arm_angle import ArmAngleSeries, map_figure
from trajopt_cli.iiwa.report.follow import Following, family_figure, following_figure, picture
from trajopt_cli.iiwa.report.forces import contact_figure, steps_figure
from trajopt_cli.iiwa.task.arm_map import ArmTask, arm_map, stages
from trajopt_cli.iiwa.task.joints import Followed
from trajopt_cli.units import MM

_MAP = 480, 360  # stages and arm angles that a page can show


def simulation_pictures(run: Simulated) -> dict[str, bytes]:
    """A run over time, pushes and the contact where there were any: file name -> contents."""
    title, shown = Path(run.opened.task.file).stem, _following(run, "controller")
    pictures = picture("following", title, partial(following_figure, shown))
    if (pushed := shown.force) is not None and run.opened.task.pushes:
        which = [i for i in range(6) if np.any(pushed[:, i])]
        pictures |= picture("pushed", title, partial(steps_figure, [("", shown)], which))
    if run.loop is not None and run.touch is not None:
        # an edge may push hardest, but what the tool leans on pushes longest
        normal = int(np.argmax(np.abs(run.loop.contact_true[:, :3]).sum(axis=0)))
        make = partial(contact_figure, shown, run.loop.depth, normal)
        pictures |= picture("contact", f"{title}: contact ({run.loop.world})", make)
    return pictures


def feed_pictures(job: ScheduledJob) -> dict[str, bytes]:
    """Deviation as programmed, and scheduled."""
    allowed = job.scheduled.allowed
    runs = [_following(job.programmed, AS_PROGRAMMED), _following(job.run, SCHEDULED)]
    title = f"{Path(job.before.task.file).stem}: lag of at most {allowed.lag / MM:g} mm"
    return picture("dosing", title, partial(family_figure, runs, "feed", bound=allowed.lag))


def joint_pictures(opened: Opened, followed: Followed) -> dict[str, bytes]:
    """The map of path and arm angle with the courses on it."""
    task, t = opened.task, followed.trajectory.t
    limits, plan = opened.robot.profile(task.limits), followed.plan
    arm = ArmTask(opened.arm, followed.X_WF, opened.equilibrium.h)
    chart = arm_map(arm, stages(len(t), _MAP[0]), _MAP[1])
    fixed = opened.arm.angle
    q, name = followed.trajectory.q, Path(task.file).stem
    courses = [ArmAngleSeries("fixed", np.full(len(t), fixed), arm.joints(fixed))]
    if np.any(followed.arm_angle != fixed):
        courses.append(ArmAngleSeries("chosen" if plan is not None else "free", followed.arm_angle, q))
    places = [(t[one.last], one.goal) for one in opened.equilibrium.pieces if not one.dwell]
    title = f"{name}: arm angle" + (f" chosen for {plan.goal.value}" if plan is not None else "")
    make = partial(
        map_figure, t, chart, opened.robot.manipulability(chart.q), limits, courses, followed.definition.value, places
    )
    return picture("arm_angle", title, make)


def _following(run: Simulated, label: str) -> Following:
    force = run.force if np.any(run.force) else None
    true = None
    if run.loop is not None:
        force = run.loop.contact_true if np.any(run.loop.contact_true) else force
        # poses in other frames later on: the flange's would have to be counted anew with every change
        true = None if frames_change(run.opened.task) else run.tool
    return Following(label, run.t, run.target, run.x, force, true)
