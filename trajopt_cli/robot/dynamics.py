"""Torques of an arm and its tool as rigid bodies, by pinocchio.

No friction; rotors where their inertia is given: the masses are those of the URDF, whose source and grade the robot's
YAML gives.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.robot.urdf import FLANGE

GRAVITY = 9.81
"""Acceleration of free fall [m/s2] where nobody says otherwise."""
_ROUNDING = 1e-9  # of the largest moment: what an inertia written with digits may miss symmetry or positivity by


@dataclass(frozen=True, eq=False)
class ToolLoad:
    """What the flange carries: mass [kg], its centre com (3,) [m] in the flange frame, inertia (3, 3) [kg m2] about it.

    The inertia stands in the flange's axes. Raises ValueError for a mass that is not positive, and for an inertia that
    no body has: not symmetric, a negative principal moment, or one larger than the sum of the others.
    """

    mass: float
    com: Array
    inertia: Array

    def __post_init__(self) -> None:
        for name, shape in (("com", (3,)), ("inertia", (3, 3))):
            values = readonly(getattr(self, name))
            if values.shape != shape or not np.isfinite(values).all():
                raise ValueError(f"ToolLoad.{name} is {values.tolist()}, wanted finite numbers of shape {shape}")
            object.__setattr__(self, name, values)
        if not (np.isfinite(self.mass) and self.mass > 0):
            raise ValueError(f"ToolLoad.mass is {self.mass:g} kg, wanted a mass above zero")
        size = float(np.abs(self.inertia).max())
        if np.abs(self.inertia - self.inertia.T).max() > _ROUNDING * size:
            raise ValueError(f"ToolLoad.inertia {self.inertia.tolist()} kg m2 is not symmetric")
        least, middle, most = (float(v) for v in np.linalg.eigvalsh(self.inertia))
        moments = f"its principal moments are {least:.6g}, {middle:.6g}, {most:.6g} kg m2"
        if least < -_ROUNDING * size:
            raise ValueError(f"ToolLoad.inertia has a negative moment: {moments}")
        if most > least + middle + _ROUNDING * size:
            raise ValueError(f"ToolLoad.inertia is no body's, one moment exceeds the sum of the others: {moments}")

    @property
    def numbers(self) -> tuple[float, ...]:
        """All of it (13,): equal for equal loads."""
        return self.mass, *self.com.tolist(), *self.inertia.ravel().tolist()


class Bodies(Protocol):
    """A robot of k axes whose links have masses."""

    @property
    def pin_model(self) -> Any:
        """pin.Model, mounted in the world."""


class Dynamics:
    """A robot of k axes with what its flange carries, under gravity [m/s2] along the world's -z. rotor (k,): inertias
    of the drives as the axes feel them, none for None.

    One object serves one thread: it owns its work space.
    """

    def __init__(
        self, robot: Bodies, load: ToolLoad | None = None, gravity: float = GRAVITY, rotor: Array | None = None
    ) -> None:
        """Raises ValueError for a gravity that is not finite."""
        import pinocchio as pin

        if not np.isfinite(gravity):
            raise ValueError(f"gravity is {gravity}, wanted a finite acceleration [m/s2]")
        model = pin.Model(robot.pin_model)  # a copy: the load must not stay in the robot's model
        model.gravity.linear = np.array([0.0, 0.0, -gravity])
        if load is not None:
            flange = model.frames[model.getFrameId(FLANGE)]
            body = pin.Inertia(load.mass, np.array(load.com), np.array(load.inertia))
            model.appendBodyToJoint(flange.parentJoint, body, flange.placement)
        if rotor is not None:
            model.armature = np.array(rotor)
        self._pin: Any = pin
        self._model, self._data = model, model.createData()

    def torque(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Joint torques (k,) or (n, k) [Nm] that move the arm so: inverse dynamics. q, qd, qdd alike [rad, s]."""
        rows = [self._rows(values, name) for values, name in ((q, "q"), (qd, "qd"), (qdd, "qdd"))]
        if len({len(values) for values in rows}) != 1:
            raise ValueError(f"q, qd, qdd have {', '.join(str(len(v)) for v in rows)} rows, wanted as many of each")
        out = np.array([self._pin.rnea(self._model, self._data, *row) for row in zip(*rows, strict=True)])
        return out.reshape(np.shape(q))

    def torque_row(self, q: Sequence[float], qd: Sequence[float], qdd: Sequence[float]) -> list[float]:
        """As torque, of one sample (k,) in plain floats: what a control loop calls."""
        out: list[float] = self._pin.rnea(self._model, self._data, np.array(q), np.array(qd), np.array(qdd)).tolist()
        return out

    def inertia_and_bias(self, q: Array, qd: Array) -> tuple[Array, Array]:
        """The joints' inertia (k, k) [kg m2] at q (k,) and the torques (k,) [Nm] of gravity and speed qd (k,)."""
        M = np.triu(self._pin.crba(self._model, self._data, q))
        bias = self._pin.rnea(self._model, self._data, q, qd, np.zeros(len(q)))
        return M + np.triu(M, 1).T, np.array(bias)

    def gravity_torque(self, q: Array) -> Array:
        """Joint torques (k,) or (n, k) [Nm] that hold the arm at rest at q."""
        rows = self._rows(q, "q")
        out = [np.array(self._pin.computeGeneralizedGravity(self._model, self._data, row)) for row in rows]
        return np.array(out).reshape(np.shape(q))

    def _rows(self, values: Array, name: str) -> Array:
        k, values = self._model.nv, np.asarray(values, dtype=np.float64)
        if values.ndim not in (1, 2) or values.shape[-1] != k:
            raise ValueError(f"{name} has shape {values.shape}, wanted ({k},) or (n, {k})")
        return values.reshape(-1, k)
