"""The robot as the judge knows it: pin's model of its URDF, mounted in the cell. No closed form and
none of the planner's code.

pin is asked row by row, 2 to 4 us each; where there are many, the same is worked out of pin's placements and axes for
all of them at once. Axis order: as the URDF has them from its root to tool0, a rail first.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path

import numpy as np
import pinocchio as pin

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.judge.chain import Joint, KinematicChain
from trajopt_cli.judge.machine import Machine

FLANGE = 7
"""Index of the flange among a mechanism's frames, after the arm's base and the six links."""

_ARM = 6
_AXIS_2, _AXIS_3 = -5, -4  # among all axes, a rail before them or not
_FEW = 64  # rows that pin is as fast for
_WORLD_AXES = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED


class Mechanism:
    """The chain from a URDF's root to tool0, its root mounted at X_WR (4, 4) in the world; other joints hold. carriers:
    linear axes of the cell that carry the whole, by name their directions (3,) in the world; then a rail of the URDF
    holds, too.

    linkage: the arm's joint 3 in the URDF is axis 3 - linkage * axis 2; all q, qd and qdd are of the axes, and so are
    the columns of Jacobians. names: of the k axes. link_names: the arm's base, then the link behind each of its six
    joints. Raises InputError for a file that pin does not read.
    """

    def __init__(
        self, urdf: Path, X_WR: Array, linkage: float = 0.0, carriers: Mapping[str, Sequence[float]] | None = None
    ):
        try:
            model = pin.buildModelFromUrdf(str(urdf))
        except ValueError as error:
            message = "pin cannot read it as a URDF; parent and child of every joint need their <link>"
            raise InputError(message, file=str(urdf)) from error
        chain = set(model.supports[model.frames[_flange(model)].parentJoint])
        own = [*sorted(chain - {0})][: -_ARM if carriers else 0]
        others = [joint for joint in range(1, model.njoints) if joint not in chain or joint in own]
        if others:
            model = pin.buildReducedModel(model, others, pin.neutral(model))
        mount = pin.SE3(np.array(X_WR))
        model.jointPlacements[1] = mount * model.jointPlacements[1]
        for fixed in (frame for frame in model.frames if frame.parentJoint == 0):
            fixed.placement = mount * fixed.placement
        if carriers:
            model = _carried(model, carriers)
        self._model, self._data, self._flange = model, model.createData(), _flange(model)
        bodies: list[int] = []
        frame = self._flange
        while len(bodies) <= FLANGE:
            if model.frames[frame].type == pin.FrameType.BODY:
                bodies.append(frame)
            frame = model.frames[frame].parentFrame
        self._frames = bodies[::-1]
        self._chain = _chain(model, self._flange)
        self.linkage = linkage
        self.names: tuple[str, ...] = tuple(model.names)[1:]
        self.link_names: tuple[str, ...] = tuple(model.frames[i].name for i in self._frames[:FLANGE])

    @property
    def rails(self) -> int:
        """How many axes stand before the arm's six."""
        return len(self.names) - _ARM

    @property
    def has_rail(self) -> bool:
        """Whether there are some."""
        return self.rails > 0

    @property
    def ranges(self) -> tuple[Array, Array, Array]:
        """Lowest and highest position and greatest speed (k,) of the axes, as the URDF has them."""
        model = self._model
        limits = (model.lowerPositionLimit, model.upperPositionLimit, model.velocityLimit)
        return limits[0].copy(), limits[1].copy(), limits[2].copy()

    def flange(self, q: Array) -> tuple[Array, Array]:
        """Flange poses X_WF (n, 4, 4) and Jacobians (n, 6, k) in world axes, linear rows first, at q (n, k)."""
        model, data, frame = self._model, self._data, self._flange
        new = np.ones(len(q), dtype=bool)  # rows unlike the one before: an arm that waits for a table is looked at once
        new[1:] = (q[1:] != q[:-1]).any(axis=1)
        rows, of = self._joints(q[new]), np.cumsum(new) - 1
        if len(rows) > _FEW:
            X, J = self._chain.flange(rows)
        else:
            X, J = np.empty((len(rows), 4, 4)), np.empty((len(rows), 6, len(self.names)))
            for i, row in enumerate(rows):
                J[i] = pin.computeFrameJacobian(model, data, row, frame, _WORLD_AXES)
                X[i] = pin.updateFramePlacement(model, data, frame).homogeneous
        J[..., _AXIS_2] -= self.linkage * J[..., _AXIS_3]
        return (X, J) if len(rows) == len(q) else (X[of], J[of])

    def _joints(self, q: Array) -> Array:
        """The URDF's joints (..., k) of axes (..., k), or their speeds and accelerations."""
        if not self.linkage:
            return q
        out = np.array(q)
        out[..., _AXIS_3] -= self.linkage * out[..., _AXIS_2]
        return out

    def flange_pose(self, q: Array) -> Array:
        """The flange pose X_WF (4, 4) at q (k,)."""
        return np.asarray(self.flange(q[None])[0][0])

    def flange_motion(self, q: Array, qd: Array, qdd: Array) -> tuple[Array, Array, Array]:
        """Poses X_WF (n, 4, 4), velocities and accelerations (n, 6) of the flange's origin in world axes, linear first.

        q, qd, qdd (n, k). The acceleration is J qdd + J' qd.
        """
        return self._chain.motion(self._joints(q), self._joints(qd), self._joints(qdd))

    def links(self, q: Array) -> tuple[Array, Array]:
        """Poses (n, 8, 4, 4) of the links in link_names order and of the flange, at q (n, k); and the unit axes
        (n, 6, 3) of the arm's joints in the world. A joint's axis runs through the origin of the link behind it."""
        model, data = self._model, self._data
        placed = [data.oMf[frame] for frame in self._frames]  # pin's own memory: each row's poses appear in it
        X, axes = np.empty((len(q), FLANGE + 1, 4, 4)), np.empty((len(q), _ARM, 3))
        for i, row in enumerate(self._joints(q)):
            axes[i] = pin.computeJointJacobians(model, data, row)[3:, -_ARM:].T
            pin.updateFramePlacements(model, data)
            X[i] = [pose.homogeneous for pose in placed]
        return X, axes


class Forces:
    """Torques of a mechanism's axes, gravity along the world's -z. rotor (k,): inertias of the drives. carried: bodies
    fixed to the flange, each its mass [kg], centre (3,) and inertia (3, 3) about that, in the flange's frame. Not of a
    mechanism with a linkage, whose levers the URDF's chain leaves out."""

    GRAVITY = 9.81
    """m/s2, as plans have it."""

    def __init__(self, mechanism: Mechanism, rotor: Array, carried: Sequence[tuple[float, Array, Array]]):
        model = pin.Model(mechanism._model)  # a copy: loads must not stay in the mechanism's
        model.gravity.linear = np.array([0.0, 0.0, -self.GRAVITY])
        model.armature = np.array(rotor)
        flange = model.frames[mechanism._flange]
        for mass, centre, inertia in carried:
            model.appendBodyToJoint(flange.parentJoint, pin.Inertia(mass, centre, inertia), flange.placement)
        self._model, self._data = model, model.createData()

    def torques(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques (n, k) [Nm, N] at q, qd, qdd (n, k)."""
        model, data = self._model, self._data
        return np.array([pin.rnea(model, data, *row) for row in zip(q, qd, qdd, strict=True)]).reshape(q.shape)

    def changes(self, q: Array, qd: Array, qdd: Array) -> tuple[Array, Array, Array]:
        """Derivatives (n, k, k) of torques by q, by qd, and by qdd (the mass matrix, rotors in it), at rows (n, k)."""
        model, data, k = self._model, self._data, q.shape[1]
        out = np.empty((3, len(q), k, k))
        for i, row in enumerate(zip(q, qd, qdd, strict=True)):
            out[0, i], out[1, i], out[2, i] = pin.computeRNEADerivatives(model, data, *row)
        return out[0], out[1], out[2]

    def masses(self, q: Array) -> Array:
        """Mass matrices (n, k, k) with rotors, at q (n, k)."""
        model, data = self._model, self._data
        upper = np.array([np.triu(pin.crba(model, data, row)) for row in q]).reshape(*q.shape, q.shape[1])
        return np.asarray(upper + np.triu(upper, 1).swapaxes(1, 2))


def mechanism_of(machine: Machine) -> Mechanism:
    """The mechanism of a machine's URDF on its mount; read once for each."""
    robot = machine.robot
    urdf, X_WR, carriers = robot.urdf, np.asarray(robot.X_WR), None
    if robot.X_UB is not None:
        ways = (X_WR[:3, :3] @ robot.rail_axes.T).T.tolist()
        carriers = tuple((name, tuple(way)) for name, way in zip(robot.axis_names, ways, strict=False))
        X_WR = X_WR @ robot.X_RB @ np.linalg.inv(robot.X_UB)
    return _mechanism(urdf if urdf.is_absolute() else urdf.resolve(), X_WR.tobytes(), robot.linkage, carriers)


def _carried(model: pin.Model, carriers: Mapping[str, Sequence[float]]) -> pin.Model:
    """A model on linear axes, one on the other."""
    out, parent = pin.Model(), 0
    for name, way in carriers.items():
        parent = out.addJoint(parent, pin.JointModelPrismaticUnaligned(*way), pin.SE3.Identity(), name)
        out.addJointFrame(parent)
    return pin.appendModel(out, model, out.nframes - 1, pin.SE3.Identity())


def _flange(model: pin.Model) -> int:
    """The frame of the link tool0; a joint may have the same name."""
    return int(model.getFrameId("tool0", pin.FrameType.BODY))


def _chain(model: pin.Model, flange: int) -> KinematicChain:
    """The joints and the flange as pin has them."""
    data, joints = model.createData(), list[Joint]()
    for i in range(1, model.njoints):
        along, about = np.asarray(data.joints[i].S).reshape(2, 3)
        joints.append(Joint(model.jointPlacements[i].homogeneous, along + about, bool(along.any())))
    return KinematicChain(joints, model.frames[flange].placement.homogeneous)


@lru_cache(maxsize=8)
def _mechanism(
    urdf: Path, X_WR: bytes, linkage: float, carriers: tuple[tuple[str, tuple[float, ...]], ...] | None
) -> Mechanism:
    return Mechanism(urdf, np.frombuffer(X_WR).reshape(4, 4), linkage, None if carriers is None else dict(carriers))
