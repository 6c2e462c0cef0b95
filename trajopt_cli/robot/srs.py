"""SrsRobot: seven revolute joints with a spherical shoulder, an elbow and a spherical wrist, as KUKA's LBR iiwa.

q = 0 stretches the arm straight up; the flange frame is tool0 (z out of the flange), parallel to the base at q = 0:
X_BF = T(bs) Rz(q1) Ry(q2) Rz(q3) T(se) Ry(-q4) Rz(q5) T(ew) Ry(q6) Rz(q7) T(wf), every T along z.
Frames: W world, B the arm's base (the URDF's root), F the flange, T the tool centre point.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, readonly, rotation_about
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.chain import checked_pose, named_profile, pin_model
from trajopt_cli.robot.urdf import UrdfJoint, check_ranges
from trajopt_cli.shapes import Capsule

JOINTS = 7
_EXACT = 1e-12  # m or a matrix entry: how far a URDF number may lie from the structure the closed form needs
_AXES = ((0, 0, 1), (0, 1, 0), (0, 0, 1), (0, -1, 0), (0, 0, 1), (0, 1, 0), (0, 0, 1))


@dataclass(frozen=True)
class SrsLengths:
    """Lengths [m]: base to shoulder, shoulder to elbow, elbow to wrist centre, wrist centre to flange."""

    bs: float
    se: float
    ew: float
    wf: float


@dataclass(frozen=True, eq=False)
class SrsRobot:
    """A seven-axis arm with its base mounted at X_WB (4, 4) in the world.

    profiles: limits of the joints by profile name, each number with its source. torque (7,): limits of the joints'
    motors and ranges of their sensors [Nm]. damping [Nm s/rad], friction [Nm] (7,): what a turning joint loses between
    motor and sensor, 0 where nobody says. notes: sources of what is not a limit, by name ("joint_1.torque").
    chain: the seven joints and the fixed one to the flange, as the URDF has them. capsules: around the links, by link
    name, in the link's frame. self_pairs: the links held against each other, the one nearer the base first;
    "attached" stands for what the flange carries.
    """

    name: str
    title: str
    axis_names: tuple[str, ...]
    lengths: SrsLengths
    X_WB: Array
    profiles: Mapping[str, JointLimits]
    torque: Array
    damping: Array
    friction: Array
    notes: Mapping[str, str]
    urdf: Path
    chain: tuple[UrdfJoint, ...]
    capsules: Mapping[str, Capsule]
    self_pairs: tuple[tuple[str, str], ...]
    colour: str | None = None

    @property
    def bodies(self) -> Mapping[str, tuple[Capsule, ...]]:
        """Around the links, by link name, in the link's frame."""
        return {name: (capsule,) for name, capsule in self.capsules.items()}

    def profile(self, name: str | None = None) -> JointLimits:
        """Limits of the joints under a named profile, "default" for None. Raises InputError listing the profiles."""
        return named_profile(self.name, self.profiles, name)

    def mounted(self, X_WB: Array) -> SrsRobot:
        """The same arm with its base at X_WB (4, 4). Raises ValueError for what is no pose."""
        return replace(self, X_WB=checked_pose(X_WB, "X_WB"))

    def forward(self, q: Array) -> Array:
        """Flange poses X_WF (..., 4, 4) of joints q (..., 7) [rad]."""
        R, _, o = self.axes_and_points(q)
        X = np.zeros((*R.shape[2:], 4, 4))
        R_WB = self.X_WB[:3, :3]
        X[..., :3, :3] = np.moveaxis(np.tensordot(R_WB, R, axes=1), (0, 1), (-2, -1))
        p = o[:, 6] + self.lengths.wf * R[:, 2]
        X[..., :3, 3] = np.moveaxis(np.tensordot(R_WB, p, axes=1), 0, -1) + self.X_WB[:3, 3]
        X[..., 3, 3] = 1.0
        return X

    def jacobian(self, q: Array, X_FT: Array | None = None) -> Array:
        """Geometric Jacobian (..., 6, 7) at the TCP in world axes, linear rows first: [v; omega] = J qd.

        q (..., 7). X_FT (4, 4): the TCP in the flange frame, the flange itself for None.
        """
        R, a, o = self.axes_and_points(q)
        at = np.array([0.0, 0.0, self.lengths.wf])  # the TCP from the wrist centre, in the flange's axes
        if X_FT is not None:
            at = at + np.asarray(X_FT, dtype=np.float64)[:3, 3]
        p = o[:, 6] + sum(at[i] * R[:, i] for i in range(3))
        lever = p[:, None] - o
        linear = np.stack([a[i - 2] * lever[i - 1] - a[i - 1] * lever[i - 2] for i in range(3)])
        J = np.empty((*R.shape[2:], 6, JOINTS))
        for rows, block in ((slice(0, 3), linear), (slice(3, 6), a)):
            J[..., rows, :] = np.moveaxis(np.tensordot(self.X_WB[:3, :3], block, axes=1), (0, 1), (-2, -1))
        return J

    def manipulability(self, q: Array) -> Array:
        """Yoshikawa's sqrt(det(J J^T)) (...) of joints q (..., 7), 0 where the arm is singular; in m^3, for J mixes m
        and rad. It is the same at every TCP: a lever's matrix has the determinant 1."""
        J = self.jacobian(q)
        return np.asarray(np.sqrt(np.maximum(np.linalg.det(J @ np.swapaxes(J, -1, -2)), 0.0)))

    def axes_and_points(self, q: Array) -> tuple[Array, Array, Array]:
        """Flange rotation (3, 3, ...), unit joint axes (3, 7, ...), a point (3, 7, ...) on each [m], all in the base.

        q (..., 7). Components lead, so that each is one contiguous block. The first three points are the shoulder, the
        fourth is the elbow, the last is the wrist centre.
        """
        q = self._joints(q)
        c, s = np.cos(np.moveaxis(q, -1, 0)), np.sin(np.moveaxis(q, -1, 0))
        batch = q.shape[:-1]
        a, o = np.empty((3, JOINTS, *batch)), np.zeros((3, JOINTS, *batch))
        x, y, z = (np.zeros((3, *batch)) for _ in range(3))
        x[0] = y[1] = z[2] = 1.0
        p = self.lengths.bs * z
        for i, axis in enumerate(_AXES):
            if axis[2]:
                a[:, i] = z
                x, y = c[i] * x + s[i] * y, c[i] * y - s[i] * x
            else:
                a[:, i] = axis[1] * y
                sine = axis[1] * s[i]
                x, z = c[i] * x - sine * z, c[i] * z + sine * x
            if i == 3 or i == 5:  # the elbow lies behind axis 3, the wrist centre behind axis 5
                p = p + (self.lengths.se if i == 3 else self.lengths.ew) * a[:, i - 1]
            o[:, i] = p
        return np.stack([x, y, z], axis=1), a, o

    def links(self, q: Array) -> Array:
        """Poses (n, 8, 4, 4) of the links in link_names order in the world, at q (n, 7) [rad]."""
        q = self._joints(q)
        X = np.empty((len(q), JOINTS + 1, 4, 4))
        X[:, 0] = self.X_WB
        for i, joint in enumerate(self.chain[:JOINTS]):
            turn = np.tile(np.eye(4), (len(q), 1, 1))
            turn[:, :3, :3] = rotation_about(joint.axis, q[:, i])
            X[:, i + 1] = X[:, i] @ joint.X @ turn
        return X

    @cached_property
    def link_names(self) -> tuple[str, ...]:
        """The links from the base on: the base, then the link behind each of the seven joints."""
        return (self.chain[0].parent, *(joint.child for joint in self.chain[:JOINTS]))

    @cached_property
    def pin_model(self) -> Any:
        """pin.Model of the URDF mounted at X_WB, so that its gravity points along the world's -z; built once."""
        return pin_model(self.urdf, self.X_WB)

    def _joints(self, q: Array) -> Array:
        q = np.asarray(q, dtype=np.float64)
        if q.ndim == 0 or q.shape[-1] != JOINTS:
            raise ValueError(f"q has shape {q.shape}, wanted (..., {JOINTS}) for {', '.join(self.axis_names)}")
        return q


@of_kind(ErrorKind.ROBOT)
def load_srs(name_or_path: str, X_WB: Array | None = None) -> SrsRobot:
    """A shipped seven-axis arm by name or any by the path of its YAML file, its base mounted at X_WB in the world.

    X_WB (4, 4), identity for None. Raises InputError for an unknown name, for a file with a mistake, and for an arm of
    another structure.
    """
    from trajopt_cli.robot import description

    data, path, raw = description.read_srs(name_or_path)
    urdf, chain = description.urdf_chain(data, path, raw)
    lengths = lengths_from_chain(chain, str(urdf))
    axes = chain[:JOINTS]
    description.check(data, path, raw, axes, chain, {})
    origins = [data.axes[joint.name] for joint in axes]
    joint_notes = {
        f"{joint.name}.{key}": str(origin)
        for joint, said in zip(axes, origins, strict=True)
        for key, origin in (("torque", said.torque), ("damping", said.damping), ("friction", said.friction))
        if origin is not None
    }
    return SrsRobot(
        name=data.name,
        title=data.title,
        axis_names=tuple(joint.name for joint in axes),
        lengths=lengths,
        X_WB=checked_pose(X_WB, "X_WB"),
        profiles=description.profiles(data, axes),
        torque=readonly([joint.effort for joint in axes]),
        damping=readonly([said.damping.value if said.damping else 0.0 for said in origins]),
        friction=readonly([said.friction.value if said.friction else 0.0 for said in origins]),
        notes=description.notes(data) | {"inertia": str(data.inertia)} | joint_notes,
        urdf=urdf,
        chain=tuple(chain),
        capsules=description.capsules(data, path, raw),
        colour=data.colour,
        self_pairs=data.collision.self_pairs if data.collision else (),
    )


def lengths_from_chain(chain: list[UrdfJoint], file: str) -> SrsLengths:
    """The arm's lengths from its seven revolute joints and the fixed flange joint, in that order.

    A joint's frame may lie anywhere on its axis. Raises InputError where an axis, an offset, a range, a speed or a
    torque range is not one the closed forms stand on.
    """
    kinds = [joint.kind for joint in chain]
    if kinds != ["revolute"] * JOINTS + ["fixed"]:
        raise InputError(f"the chain is {', '.join(kinds)}: wanted seven revolute joints and a fixed flange", file=file)
    check_ranges(chain[:JOINTS], file)
    need = "the closed-form inverse needs axes z, y, z, -y, z, y, z that meet in shoulder, elbow and wrist at q = 0"
    at, heights = np.zeros(3), []
    for i, joint in enumerate(chain):
        where = f"joint '{joint.name}'"
        if i < JOINTS and not np.allclose(joint.axis, _AXES[i], rtol=0, atol=_EXACT):
            wish = " ".join(f"{v:g}" for v in _AXES[i])
            raise InputError(f"{where} has axis {_row(joint.axis)}, wanted {wish}: {need}", file=file)
        if not np.allclose(joint.X[:3, :3], np.eye(3), rtol=0, atol=_EXACT):
            raise InputError(f"{where} has a turned origin, wanted rpy 0 0 0: {need}", file=file)
        if i < JOINTS and not joint.effort > 0:
            raise InputError(f"{where} has effort {joint.effort:g}, wanted its torque range [Nm] above zero", file=file)
        at = at + joint.X[:3, 3]
        free = np.array([0, 1, 1]) if i in (1, 3, 5) else np.array([0, 0, 1])
        if np.any(np.abs(at * (1 - free)) > _EXACT):
            raise InputError(f"{where} stands at {_row(at)} m at q = 0, beside the arm's line: {need}", file=file)
        heights.append(float(at[2]))
    bs, elbow, wrist, flange = (heights[i] for i in (1, 3, 5, 7))
    # Differences of sums carry rounding; lengths are given to less than a nanometre.
    lengths = SrsLengths(*(round(v, 12) for v in (bs, elbow - bs, wrist - elbow, flange - wrist)))
    if min(lengths.se, lengths.ew) <= 0:
        raise InputError(f"arm lengths se = {lengths.se} m and ew = {lengths.ew} m must be positive", file=file)
    return lengths


def _row(values: Array) -> str:
    return " ".join(f"{v:g}" for v in values)
