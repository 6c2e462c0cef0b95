"""The thesis' open wish: the cube at 0.4 m/s fed gradually, so that the controller lags by 5 mm at most."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_limits import Allowed
from trajopt_cli.iiwa.controller.feed_path import dose_path
from trajopt_cli.iiwa.controller.feed_schedule import CannotDose, Dosed, Feeding, FeedRow, compare, dose
from trajopt_cli.iiwa.controller.lag import held, steady_lag
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.experiments.setup import Bench, Series, program
from trajopt_cli.iiwa.task.joints import Followed, follow
from trajopt_cli.iiwa.task.model import Compliance, Feed, Integration, Profile
from trajopt_cli.iiwa.task.segments import interpolate
from trajopt_cli.robot.srs import load_srs

BOUND = 5e-3
"""Lag [m] that is allowed."""
SPEED = 0.4
"""v_max [m/s] of the cube's edges."""
_AFTER = 2.0  # s shown after the last row


@dataclass(frozen=True, eq=False)
class Dosing:
    """rows: the same path as programmed, fed with the equilibrium's speed, and dosed to lag by bound [m] at most.

    least [s]: what no sequence with that lag can go below. steady [m]: D v/K of a long line at SPEED. ramped [m]: the
    lag of the task with the profile of its file, fed with the equilibrium's speed. series: one per row.
    """

    section: str
    title: str
    task: str
    bound: float
    rows: tuple[FeedRow, ...]
    least: float | None
    steady: float
    ramped: float
    sentences: tuple[str, ...]
    series: tuple[Series, ...]


def dosing(bench: Bench) -> Dosing:
    """The wish of chapter 7, on programs/iiwa_cube.yaml with the thesis' profile at SPEED."""
    from trajopt_cli.iiwa.task.loader import load_task

    file = program("iiwa_cube.yaml")
    task = load_task(file)
    caps = tuple(replace(one, v_max=SPEED) for one in task.route.speeds)
    path = interpolate(replace(task.route, profile=Profile.THESIS, speeds=caps))
    robot = load_srs(task.robot, task.X_WB)
    limits = robot.profile(task.limits)
    joints = follow(path, robot, task.X_FT, task.start_joints, limits, task.definition, task.arm_angle, False)
    if not isinstance(joints, Followed):
        raise RuntimeError(f"{file.name} cannot be followed: {joints.message}")
    law = task.compliance
    way = dose_path(path, caps, joints=joints.trajectory.q, joint_speed=limits.velocity)
    dosed = dose(way, law, path.h, Allowed(BOUND), integration=task.integration)
    if isinstance(dosed, CannotDose):
        raise RuntimeError(f"{file.name} cannot be dosed: {dosed.message}")
    rows = compare(path, law, dosed, integration=task.integration)
    x_e = held(path.pose, _AFTER, path.h)
    undosed, fed = (
        response(x_e, path.h, law, feed=feed, integration=task.integration).x for feed in (Feed.POSITION, Feed.VELOCITY)
    )
    programmed = interpolate(task.route)
    ramped = compare(programmed, law, None, integration=task.integration)[1].lag.maximum
    slow = BOUND / steady_lag(np.array([1.0, 0.0, 0.0]), law)
    return Dosing(
        section="7",
        title=f"the cube at {SPEED:g} m/s, lag of at most {1e3 * BOUND:g} mm",
        task=file.name,
        bound=BOUND,
        rows=rows,
        least=dosed.least,
        steady=steady_lag(np.array([SPEED, 0.0, 0.0]), law),
        ramped=ramped,
        sentences=(
            f"on a line the lag is D v/K: {1e3 * BOUND:g} mm allow {slow:g} m/s with K = {law.K[0]:g} N/m and"
            f" D = {law.D[0]:g} N s/m; fed positions alone dosing cannot be faster, more stiffness or less damping can,"
            " and so can other feeds that push harder (trajopt iiwa dose --max-lead)",
            "fed with the equilibrium's speed only the inertia M lags, at starts and corners:"
            f" {1e3 * rows[1].lag.maximum:.1f} mm at once at full speed, {1e3 * ramped:.1f} mm with the profile of"
            f" {file.name} ({task.route.profile.value})",
        ),
        series=(
            _series(Feeding.UNDOSED, path.h, x_e, undosed),
            _series(Feeding.VELOCITY, path.h, x_e, fed),
            _dosed_series(dosed, law, task.integration),
        ),
    )


def _series(feeding: Feeding, h: float, x_e: Array, x: Array) -> Series:
    return Series(feeding.value, np.arange(len(x_e), dtype=np.float64) * h, x_e, x)


def _dosed_series(dosed: Dosed, law: Compliance, integration: Integration) -> Series:
    x_e = held(dosed.pose, _AFTER, dosed.h)
    return _series(Feeding.DOSED, dosed.h, x_e, response(x_e, dosed.h, law, integration=integration).x)
