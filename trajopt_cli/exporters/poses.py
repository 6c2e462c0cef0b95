"""Poses of a tool with twist, wrench and stiffness at any rate, as CSV or MCAP, by the names of those who take them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.ros2 import BAR, HEADER, JOINT_STATE, TIME, Message, bag, header
from trajopt_cli.geometry import Array, inverse_pose, rotation_vector, rotations_by, wxyz_in_turn

_MOST_RATE = 10_000.0  # Hz
_AXES = ("x", "y", "z")
_VECTOR = f"{BAR}\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
_POSE = (
    f"{BAR}\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n"
    f"{BAR}\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"
)
_DEFINITIONS = {
    "geometry_msgs/msg/Pose": f"geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n{_POSE}",
    "geometry_msgs/msg/PoseStamped": f"std_msgs/Header header\ngeometry_msgs/Pose pose\n{HEADER}{TIME}{BAR}\n"
    f"MSG: geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n{_POSE}",
    "geometry_msgs/msg/TwistStamped": f"std_msgs/Header header\ngeometry_msgs/Twist twist\n{HEADER}{TIME}{BAR}\n"
    f"MSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n{_VECTOR}",
    "geometry_msgs/msg/WrenchStamped": f"std_msgs/Header header\ngeometry_msgs/Wrench wrench\n{HEADER}{TIME}{BAR}\n"
    f"MSG: geometry_msgs/Wrench\ngeometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n{_VECTOR}",
    "std_msgs/msg/Float64MultiArray": f"std_msgs/MultiArrayLayout layout\nfloat64[] data\n{BAR}\n"
    f"MSG: std_msgs/MultiArrayLayout\nstd_msgs/MultiArrayDimension[] dim\nuint32 data_offset\n{BAR}\n"
    "MSG: std_msgs/MultiArrayDimension\nstring label\nuint32 size\nuint32 stride\n",
    "lbr_fri_idl/msg/LBRWrenchCommand": "float64[7] joint_position\nfloat64[6] wrench\n",
    JOINT_STATE[0]: JOINT_STATE[1],
}


@dataclass(frozen=True)
class Stack:
    """Who takes the poses: topics with their messages, by what they hold: pose, twist, wrench, stiffness, command
    (joints with the wrench), joints.

    frame: that of the poses; based: whether it is the arm's base, else the world. joints: their names. tool: the frame
    of the wrench where it is the tool's own, empty where it is that of the poses. parameter: how stiffness is set where
    no topic takes it.
    """

    topics: Mapping[str, tuple[str, str]]
    frame: str
    based: bool
    joints: tuple[str, ...]
    tool: str = ""
    parameter: str = ""


_STAMPED = {name: f"geometry_msgs/msg/{name.title()}Stamped" for name in ("pose", "twist", "wrench")}
_LBR = tuple(f"A{i}" for i in range(1, 8))
_MAYR = "/CartesianImpedance_trajectory_controller"
_FZI = "/cartesian_compliance_controller"
STACKS = {
    "ros": Stack(
        {name: (f"/target_{name}", kind) for name, kind in (*_STAMPED.items(), ("stiffness", _STAMPED["wrench"]))},
        frame="world", based=False, joints=_LBR,
    ),
    # lbr_fri_ros2_stack: lbr_demos_advanced_cpp's pose_control_node.cpp, LBRWrenchCommand.msg, lbr_controllers.yaml
    "lbr": Stack(
        {
            "pose": ("/lbr/command/pose", "geometry_msgs/msg/Pose"),
            "command": ("/lbr/command/wrench", "lbr_fri_idl/msg/LBRWrenchCommand"),
        },
        frame="link_0", based=True, joints=_LBR, parameter="Sunrise's CartesianImpedanceControlMode",
    ),
    # cartesian_controllers (FZI): CartesianComplianceController; target_wrench in the end effector's frame
    # (hand_frame_control, its default), frame_id has to be robot_base_link's
    "cartesian": Stack(
        {"pose": (f"{_FZI}/target_frame", _STAMPED["pose"]), "wrench": (f"{_FZI}/target_wrench", _STAMPED["wrench"])},
        frame="base_link", based=True, joints=_LBR, tool="tool0", parameter="stiffness.trans_x ... rot_z",
    ),
    # crisp_controllers: cartesian_controller.cpp and .yaml (variable_stiffness.enabled), its demos' config/iiwa
    "crisp": Stack(
        {
            "pose": ("/target_pose", _STAMPED["pose"]),
            "wrench": ("/target_wrench", _STAMPED["wrench"]),
            "stiffness": ("/target_stiffness", "std_msgs/msg/Float64MultiArray"),
            "joints": ("/target_joint", JOINT_STATE[0]),
        },
        frame="iiwa_base", based=True, joints=tuple(f"joint_a{i}" for i in range(1, 8)),
    ),
    # Cartesian-Impedance-Controller (Mayr): its README; wrenches without a frame_id would count in the end effector's
    "impedance": Stack(
        {
            "pose": (f"{_MAYR}/reference_pose", _STAMPED["pose"]),
            "wrench": (f"{_MAYR}/set_cartesian_wrench", _STAMPED["wrench"]),
            "stiffness": (f"{_MAYR}/set_cartesian_stiffness", _STAMPED["wrench"]),
        },
        frame="world", based=False, joints=tuple(f"iiwa_joint_{i}" for i in range(1, 8)),
    ),
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class ToolPoses:
    """A tool centre point over time: t (n,) [s], p (n, 3) [m], R (n, 3, 3) in the world; wrench (n, 6) [N, Nm] that it
    presses with besides, world axes; K (6,) along these; joints q (n, 7) [rad], None where there are none."""

    t: Array
    p: Array
    R: Array
    wrench: Array
    K: Array
    q: Array | None = None

    def at(self, rate: float) -> ToolPoses:
        """Rows at rate [Hz] and the exact end: straight between the rows, turning about one axis."""
        if not 0 < rate <= _MOST_RATE:
            raise InputError(f"--rate: {rate:g} Hz is not above 0 and at most {_MOST_RATE:g}")
        end = float(self.t[-1])
        t = np.arange(math.floor(end * rate + 1e-9) + 1) / rate
        t = np.append(t[t < end - 1e-9], end)
        i = np.clip(np.searchsorted(self.t, t + 1e-12, side="right") - 1, 0, len(self.t) - 2)
        share = (t - self.t[i]) / (self.t[i + 1] - self.t[i])

        def between(rows: Array) -> Array:
            return np.asarray(rows[i] + share[:, None] * (rows[i + 1] - rows[i]))

        turn = rotation_vector(np.swapaxes(self.R[i], 1, 2) @ self.R[i + 1])
        R = self.R[i] @ rotations_by(share[:, None] * turn)
        q = None if self.q is None else between(self.q)
        return replace(self, t=t, p=between(self.p), R=R, wrench=between(self.wrench), q=q)

    def seen_from(self, X_WB: Array) -> ToolPoses:
        """The same in the base's frame X_WB (4, 4). Raises InputError for a stiffness that would be none of axes."""
        R, apart = X_WB[:3, :3], np.ptp(self.K[:3]) > 0 or np.ptp(self.K[3:]) > 0
        if apart and not np.allclose(np.abs(R), np.eye(3), atol=1e-9):
            raise InputError("K is along the world's axes, and the base is turned; give x, y and z the same stiffness")
        p = (self.p - X_WB[:3, 3]) @ R
        wrench = np.hstack([self.wrench[:, :3] @ R, self.wrench[:, 3:] @ R])
        return replace(self, p=p, R=inverse_pose(X_WB)[:3, :3] @ self.R, wrench=wrench)

    @property
    def twist(self) -> Array:
        """Velocity and angular velocity (n, 6) up to the next row [m/s, rad/s], zero in the last."""
        out, dt = np.zeros((len(self.t), 6)), np.diff(self.t)[:, None]
        out[:-1, :3] = np.diff(self.p, axis=0) / dt
        out[:-1, 3:] = rotation_vector(self.R[1:] @ np.swapaxes(self.R[:-1], 1, 2)) / dt
        return out


def csv(poses: ToolPoses, stack: Stack) -> bytes:
    """A table: time, position, quaternion, twist, wrench, stiffness, joints if there are any."""
    heads = ["t [s]", *(f"{a} [m]" for a in _AXES), *(f"q{a} [1]" for a in "wxyz")]
    for name, units in (("v w", ("m/s", "rad/s")), ("f m", ("N", "Nm")), ("k kr", ("N/m", "Nm/rad"))):
        heads += [f"{one}{a} [{unit}]" for one, unit in zip(name.split(), units, strict=True) for a in _AXES]
    wxyz = wxyz_in_turn(poses.R)
    columns = [poses.t[:, None], poses.p, wxyz, poses.twist, _wrench(poses, stack), np.tile(poses.K, (len(poses.t), 1))]
    if poses.q is not None:
        heads, columns = [*heads, *(f"{name} [rad]" for name in stack.joints)], [*columns, poses.q]
    table = np.hstack(columns)
    row = ",".join(["%.12g"] * table.shape[1])
    return ("\n".join([",".join(heads), *(row % tuple(one) for one in (table + 0.0).tolist())]) + "\n").encode()


def mcap(poses: ToolPoses, stack: Stack) -> bytes:
    """The messages on the stack's topics, every row at its time; stiffness once, at 0. A command of joints with the
    wrench, and joints, only where there are joints."""
    return bag(_DEFINITIONS, _messages(poses, stack))


def _messages(poses: ToolPoses, stack: Stack) -> Iterator[Message]:
    rows = {"pose": np.hstack([poses.p, wxyz_in_turn(poses.R)]), "twist": poses.twist, "wrench": _wrench(poses, stack)}
    if poses.q is not None:
        rows |= {"command": np.hstack([poses.q, rows["wrench"]]), "joints": poses.q}
    times = np.rint(poses.t * 1e9).astype(np.int64).tolist()
    for name, (topic, kind) in stack.topics.items():
        if name == "stiffness":
            yield topic, kind, _message(kind, poses.K.tolist(), header(0, stack.frame), stack), 0
        elif name in rows:
            frame = stack.tool if name == "wrench" and stack.tool else stack.frame
            for time, row in zip(times, rows[name].tolist(), strict=True):
                yield topic, kind, _message(kind, row, header(time, frame), stack), time


def _message(kind: str, row: Sequence[float], head: dict[str, Any], stack: Stack) -> dict[str, Any]:
    def vector(values: Sequence[float]) -> dict[str, float]:
        return dict(zip(_AXES, values, strict=True))

    match kind.split("/")[-1]:
        case "Pose" | "PoseStamped":
            w, *xyz = row[3:]
            pose = {"position": vector(row[:3]), "orientation": vector(xyz) | {"w": w}}
            return pose if kind.endswith("Pose") else {"header": head, "pose": pose}
        case "TwistStamped":
            return {"header": head, "twist": {"linear": vector(row[:3]), "angular": vector(row[3:])}}
        case "WrenchStamped":
            return {"header": head, "wrench": {"force": vector(row[:3]), "torque": vector(row[3:])}}
        case "LBRWrenchCommand":
            return {"joint_position": list(row[:7]), "wrench": list(row[7:])}
        case "JointState":
            return {"header": head, "name": [*stack.joints], "position": list(row), "velocity": [], "effort": []}
        case _:
            return {"layout": {"dim": [], "data_offset": 0}, "data": list(row)}


def _wrench(poses: ToolPoses, stack: Stack) -> Array:
    """In the axes that the stack counts wrenches in."""
    if not stack.tool:
        return poses.wrench
    return np.hstack([np.einsum("nji,nj->ni", poses.R, part) for part in (poses.wrench[:, :3], poses.wrench[:, 3:])])
