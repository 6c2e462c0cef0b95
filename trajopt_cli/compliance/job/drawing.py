"""Pictures of runs and of dosing, made from what the commands found."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from trajopt_cli.compliance.job.dosing import DosedJob
from trajopt_cli.compliance.job.simulation import Simulated, frames_change
from trajopt_cli.compliance.report import pictures as compliance
from trajopt_cli.compliance.report.pictures import Following
from trajopt_cli.compliance.task.angles import angles_near
from trajopt_cli.compliance.task.joints import Followed
from trajopt_cli.geometry import Array


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
        pictures |= compliance.joints(run.t, q, limits.lower, limits.upper, limits.velocity, f"{title}: joints", angle)
    return pictures


def dose_pictures(job: DosedJob) -> dict[str, bytes]:
    """Deviation, fed speed and path: as programmed, fed with the equilibrium's speed, and dosed."""
    runs = [_following(way.run, way.name) for way in job.ways]
    title = f"{Path(job.before.task.file).stem}: lag of at most {job.dosed.bound * 1e3:g} mm"
    return compliance.dosing(runs[0], runs[1:], job.dosed.bound, title)


def _following(run: Simulated, label: str) -> Following:
    force = run.force if np.any(run.force) else None
    true = None
    if run.loop is not None:
        force = run.loop.contact_true if np.any(run.loop.contact_true) else force
        # poses in other frames later on: the flange's would have to be counted anew with every change
        true = None if frames_change(run.opened.task) else _flange(run)
    return Following(label, run.t, run.x_e, run.x, force, true)


def _flange(run: Simulated) -> Array:
    """The tool (n, 6) as the arm really stood, angles from the start."""
    assert run.loop is not None
    X = run.opened.robot.forward(run.loop.q) @ run.opened.task.X_FT
    turned = X[:, :3, :3] @ run.opened.X_start[:3, :3].T
    return np.column_stack([X[:, :3, 3], angles_near(turned, run.x[:, 3:])])
