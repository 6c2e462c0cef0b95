"""A joint motion as the text of a ROS 2 message: trajectory_msgs/msg/JointTrajectory in YAML."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.trajectory import Trajectory

_NANO = 10**9


def trajectory_parts(trajectory: Trajectory, names: Sequence[str] | None = None) -> Iterator[str]:
    """The message as YAML in parts, as `ros2 topic pub` takes it. names: the joints' in ROS, None for the motion's own.

    Times count from the first row. Accelerations are second divided differences, 0 in the first and the last row.
    Raises InputError as checked_names.
    """
    trajectory = trajectory.whole
    names, qd = checked_names(trajectory, names)
    return _lines(trajectory, qd, names)


def checked_names(trajectory: Trajectory, names: Sequence[str] | None) -> tuple[tuple[str, ...], Array]:
    """The joints' names in ROS, the motion's own for None, and its speeds.

    Raises InputError for a motion without speeds, for names that are not one for each axis, and for a motion too long
    for the message's seconds.
    """
    if trajectory.qd is None:
        raise InputError("the motion has no speeds; a JointTrajectory needs them")
    names = trajectory.names if names is None else tuple(names)
    if len(names) != len(trajectory.names) or len(set(names)) < len(names) or not all(map(_plain, names)):
        given, wanted = ", ".join(names), ", ".join(trajectory.names)
        raise InputError(f"--joints: '{given}' are not {len(trajectory.names)} different names, one each for {wanted}")
    if trajectory.duration >= 2**31:
        raise InputError(f"takes {trajectory.duration:g} s; a JointTrajectory counts up to 2^31 s")
    return names, trajectory.qd


def _plain(name: str) -> bool:
    """Whether a name is one in ROS, and text in YAML without quotes."""
    return name.replace("_", "a").replace("/", "a").isalnum() and name.isascii() and not name[0].isdigit()


def _lines(trajectory: Trajectory, qd: Array, names: Sequence[str]) -> Iterator[str]:
    yield "header: {stamp: {sec: 0, nanosec: 0}, frame_id: ''}\n"
    yield f"joint_names: [{', '.join(names)}]\npoints:\n"
    times = np.rint((trajectory.t - trajectory.t[0]) * _NANO).astype(np.int64).tolist()
    rows = zip(times, trajectory.q, qd, accelerations(trajectory), strict=True)
    for time, q, speed, acceleration in rows:
        yield f"- positions: {_row(q)}\n  velocities: {_row(speed)}\n  accelerations: {_row(acceleration)}\n"
        yield f"  effort: []\n  time_from_start: {{sec: {time // _NANO}, nanosec: {time % _NANO}}}\n"


def accelerations(trajectory: Trajectory) -> Array:
    """Second divided differences of the positions, 0 in the first and the last row."""
    gaps = np.diff(trajectory.t)[:, None]
    inner = 2 * np.diff(np.diff(trajectory.q, axis=0) / gaps, axis=0) / (gaps[1:] + gaps[:-1])
    rest = np.zeros((1, trajectory.q.shape[1]))
    return np.concatenate([rest, inner, rest])


def _row(values: Array) -> str:
    """In fixed decimals: what reads YAML in ROS takes 1e-05 for text. No zero with a sign."""
    return f"[{', '.join(f'{value:.12f}' for value in (np.round(values, 12) + 0.0).tolist())}]"
