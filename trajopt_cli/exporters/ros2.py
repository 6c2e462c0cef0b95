"""A joint motion as ROS 2 has it: a JointTrajectory as YAML text, and an MCAP file of messages for bag tools."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from io import BytesIO
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.trajectory import Trajectory

_NANO = 10**9
Message = tuple[str, str, dict[str, Any], int]
"""Topic, the message's name, its content, and when [ns]."""
BAR = "=" * 80
TIME = f"{BAR}\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"
HEADER = f"{BAR}\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
# Name and fields of a message, those of the messages in it behind a bar: how MCAP holds a ROS 2 definition.
JOINT_STATE = (
    "sensor_msgs/msg/JointState",
    f"std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n{HEADER}{TIME}",
)
JOINT_TRAJECTORY = (
    "trajectory_msgs/msg/JointTrajectory",
    "std_msgs/Header header\nstring[] joint_names\ntrajectory_msgs/JointTrajectoryPoint[] points\n"
    f"{HEADER}{TIME}{BAR}\nMSG: trajectory_msgs/JointTrajectoryPoint\nfloat64[] positions\nfloat64[] velocities\n"
    "float64[] accelerations\nfloat64[] effort\nbuiltin_interfaces/Duration time_from_start\n"
    f"{BAR}\nMSG: builtin_interfaces/Duration\nint32 sec\nuint32 nanosec\n",
)


def mcap(trajectory: Trajectory, names: Sequence[str] | None = None) -> bytes:
    """The file: /joint_trajectory once, with all rows, and /joint_states row by row, each stamped with its time.

    Times count from 0 at the first row, as time and as stamp, so the same motion gives the same bytes. names: as in
    trajectory_parts. Raises InputError as that does, and where mcap-ros2-support, the extra mcap, is missing.
    """
    trajectory = trajectory.whole
    names, qd = checked_names(trajectory, names)
    return bag(dict((JOINT_STATE, JOINT_TRAJECTORY)), _messages([*_points(trajectory, qd)], names))


def bag(definitions: Mapping[str, str], messages: Iterable[Message]) -> bytes:
    """An MCAP file of ROS 2 messages. definitions: by the message's name. Raises InputError where mcap-ros2-support,
    the extra mcap, is missing."""
    try:
        from mcap_ros2.writer import Writer
    except ImportError as error:
        missing = "mcap-ros2-support is not installed: pip install 'trajopt-cli[mcap]'"
        raise InputError(missing if error.name == "mcap_ros2" else f"MCAP cannot be written: {error}") from error
    out, sent, known = BytesIO(), Counter[str](), dict[str, Any]()
    with Writer(out) as writer:
        for topic, kind, message, time in messages:
            if kind not in known:
                known[kind] = writer.register_msgdef(kind, definitions[kind])
            writer.write_message(topic, known[kind], message, log_time=time, sequence=sent[topic])
            sent[topic] += 1
    return out.getvalue()


def _messages(points: Sequence[dict[str, Any]], names: Sequence[str]) -> Iterator[Message]:
    yield "/joint_trajectory", JOINT_TRAJECTORY[0], {"header": header(0), "joint_names": [*names], "points": points}, 0
    for point in points:
        since = point["time_from_start"]
        time = since["sec"] * _NANO + since["nanosec"]
        message = {
            "header": header(time),
            "name": [*names],
            "position": point["positions"],
            "velocity": point["velocities"],
            "effort": [],
        }
        yield "/joint_states", JOINT_STATE[0], message, time


def _points(trajectory: Trajectory, qd: Array) -> Iterator[dict[str, Any]]:
    times = np.rint((trajectory.t - trajectory.t[0]) * _NANO).astype(np.int64).tolist()
    for time, *row in zip(times, trajectory.q, qd, accelerations(trajectory), strict=True):
        positions, velocities, acceleration = (values.tolist() for values in row)
        yield {
            "positions": positions,
            "velocities": velocities,
            "accelerations": acceleration,
            "effort": [],
            "time_from_start": _stamp(time),
        }


def header(time: int, frame: str = "") -> dict[str, Any]:
    """A std_msgs/Header at a time [ns]."""
    return {"stamp": _stamp(time), "frame_id": frame}


def _stamp(time: int) -> dict[str, int]:
    return {"sec": time // _NANO, "nanosec": time % _NANO}


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
