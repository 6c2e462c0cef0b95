"""Pictures of runs and of dosing, made from what the commands found."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.job.feed_scheduling import DOSED, DosedJob
from trajopt_cli.iiwa.job.folder import Opened
from trajopt_cli.iiwa.job.simulation import Simulated, frames_change
from trajopt_cli.iiwa.report import pictures as compliance
from trajopt_cli.iiwa.report.pictures import ArmAngleSeries, Following
from trajopt_cli.iiwa.task.joints import Followed
from trajopt_cli.shapes import Box, Capsule
from trajopt_cli.units import MM

_THIN = 0.01  # m

_MAP = 480, 360  # stages and arm angles that a page can show


def simulation_pictures(run: Simulated) -> dict[str, bytes]:
    """A run over time and in space, its joints, and the contact where there was one: file name -> contents."""
    title = Path(run.opened.task.file).stem
    shown = _following(run, "controller")
    pictures = compliance.following(shown, title)
    limits = run.opened.robot.profile(run.opened.task.limits)
    q, angle = None, None
    if run.loop is not None:
        q = run.loop.q
        if np.any(run.loop.depth > 0):
            # an edge may push hardest, but what the tool leans on pushes longest
            normal = int(np.argmax(np.abs(run.loop.contact_true[:, :3]).sum(axis=0)))
            pictures |= compliance.contact(shown, run.loop.depth, normal, f"{title}: contact ({run.loop.world})")
    elif isinstance(run.joints, Followed):
        q, angle = run.joints.trajectory.q, run.joints.arm_angle
    if q is not None:
        pictures |= compliance.arm(shown, _moments(run, q), _obstacles(run), f"{title}: the arm in space")
        pictures |= compliance.joints(run.t, q, limits.lower, limits.upper, limits.velocity, f"{title}: joints", angle)
    return pictures


def _moments(run: Simulated, q: Array) -> list[tuple[str, list[Capsule]]]:
    """The arm's links where the tool or else a link touches, or it lags most, where it starts, and where it ends."""
    if run.loop is not None and np.any(run.loop.depth > 0):
        row, what = int(np.argmax(run.loop.depth)), "deepest contact"
    elif run.links:
        first = run.links[0]
        row, what = (
            min(round(first.first / run.opened.equilibrium.h), len(q) - 1),
            f"{first.link} touches {first.obstacle}",
        )
    else:
        row, what = min(run.lag.row, len(q) - 1), "largest lag"
    rows = {f"{what}, {run.t[row]:.2f} s": row, "start": 0, "end": len(q) - 1}
    robot, out = run.opened.robot, []
    for name, at in rows.items():
        links = zip(robot.link_names, robot.links(q[at : at + 1])[0], strict=True)
        placed = [(X, robot.capsules[link]) for link, X in links if link in robot.capsules]
        out.append((name, [_placed(X, capsule) for X, capsule in placed] + [_tool(run, q[at])]))
    return out


def _tool(run: Simulated, q: Array) -> Capsule:
    """From the flange to the tool centre point, as thick as the tip's ball; thin where the task tells of none."""
    X_WF = run.opened.robot.forward(q)
    radius = _THIN if run.contact is None else run.contact.tip
    return Capsule("tool", X_WF[:3, 3], (X_WF @ run.opened.task.X_FT)[:3, 3], radius)


def _placed(X: Array, capsule: Capsule) -> Capsule:
    a, b = (X[:3, :3] @ end + X[:3, 3] for end in (capsule.a, capsule.b))
    return Capsule(capsule.name, a, b, capsule.radius)


def _obstacles(run: Simulated) -> list[Box]:
    return [] if run.contact is None else [obstacle.box for obstacle in run.contact.obstacles]


def dose_pictures(job: DosedJob) -> dict[str, bytes]:
    """Deviation, fed speed and path: as programmed, fed with the equilibrium's speed, and dosed."""
    allowed = job.dosed.allowed
    runs = [_following(way.run, way.name) for way in job.ways] + [_following(job.run, DOSED[job.dosed.feed])]
    title = f"{Path(job.before.task.file).stem}: lag of at most {allowed.lag / MM:g} mm"
    pictures = compliance.dosing(runs[0], runs[1:], allowed.lag, title)
    if job.front and allowed.lead is not None:
        curves = {DOSED[feed]: [point.durations[feed] for point in job.front] for feed in job.front[0].durations}
        leads = [point.lead.most for point in job.front]
        unit = (MM, "mm") if allowed.lead.stretch else (1.0, "N")
        chosen = (allowed.lead.most, job.dosed.duration)
        pictures |= compliance.front(leads, curves, chosen, unit, job.before.equilibrium.duration, title)
    return pictures


def joint_pictures(opened: Opened, followed: Followed) -> dict[str, bytes]:
    """The map of path and arm angle with the courses on it, and the joints against their limits."""
    from trajopt_cli.iiwa.task.arm_map import arm_map, stages
    from trajopt_cli.iiwa.task.joint_rows import joints_along
    from trajopt_cli.robot.srs_inverse import arm_angle

    task, robot, t = opened.task, opened.robot, followed.trajectory.t
    limits, plan = robot.profile(task.limits), followed.plan
    begin = float(arm_angle(robot, task.start_joints, followed.definition))
    rows = stages(len(t), _MAP[0])
    chart = arm_map(robot, followed.X_WF, rows, followed.definition, followed.configuration, begin, _MAP[1])
    title = f"{Path(task.file).stem}: arm angle"
    if plan is not None:
        title += f" chosen for {plan.goal.value}"
    fixed = begin if task.arm_angle is None else task.arm_angle
    q, joints = followed.trajectory.q, f"{Path(task.file).stem}: joints"
    held = joints_along(robot, followed.X_WF, fixed, followed.definition, followed.configuration, task.start_joints)
    courses = [ArmAngleSeries("fixed", np.full(len(t), fixed), held)]
    if np.any(followed.arm_angle != fixed):
        courses.append(ArmAngleSeries("chosen" if plan is not None else "free", followed.arm_angle, q))
    places = [(t[one.last], one.goal) for one in opened.equilibrium.pieces if not one.dwell]
    pictures = compliance.arm_angle_map(t, chart, limits, courses, followed.definition.value, title, places)
    angle = followed.arm_angle if len(courses) == 2 else None
    return pictures | compliance.joints(t, q, limits.lower, limits.upper, limits.velocity, joints, angle)


def _following(run: Simulated, label: str) -> Following:
    force = run.force if np.any(run.force) else None
    true = None
    if run.loop is not None:
        force = run.loop.contact_true if np.any(run.loop.contact_true) else force
        # poses in other frames later on: the flange's would have to be counted anew with every change
        true = None if frames_change(run.opened.task) else run.tool
    return Following(label, run.t, run.target, run.x, force, true)
