"""The impedance controller: torques that make the arm itself the spring and damper, as Sunrise's Cartesian mode.

    tau = J^T (K dx + D dv + W) + N (-k_n (q - q_0) - d_n qd) + C(q, qd) qd + g(q)

dx from the tool to the equilibrium, its rotation as log(R_e R^T), world axes; dv the equilibrium's velocity (0 where
only positions are fed) less the tool's; W what it is told to press with. D is given, or by damping ratios z: with A and
K1 the roots of the tool's inertia L = (J M^-1 J^T)^-1 and of K, D = A z K1 + K1 z A (Albu-Schaeffer and others,
"Cartesian impedance control of redundant robots", ICRA 2003). N = 1 - J^T L J M^-1 moves nothing of the tool.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.parameters import Command, Goal, Settings, Stop, StopKind
from trajopt_cli.iiwa.controller.rotations import Nine, Three, angles, logarithm, nine, rotation, transpose
from trajopt_cli.iiwa.task.model import Feed, Impedance
from trajopt_cli.iiwa.task.world import Measured, Seven, Six, seven
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_step import product


class ImpedanceController:
    """Switched on at rest at joints q_0 (7,) [rad]; the rest as of admittance.Controller, whose place it takes.

    Its Command holds the joints as measured and the motors' torques. x, v: the tool itself.
    """

    def __init__(self, robot: SrsRobot, settings: Settings, q_0: Seven, law: Impedance) -> None:
        self.settings, self.robot, self.q_0, self._law = settings, robot, q_0, law
        self.k, self.times = 0, (0.0,) * 5
        self.force: Six = (0.0,) * 6
        self._dynamics, self._rest = Dynamics(robot, settings.load), np.array(q_0)
        R = (robot.forward(self._rest) @ settings.X_FT)[:3, :3]
        self._R_start: Nine = nine(R.ravel().tolist())
        self.x: Six = (0.0,) * 6
        self._see(q_0, (0.0,) * 7)

    @property
    def t(self) -> float:
        """The present period's start [s]."""
        return self.k * self.settings.h

    @property
    def X_WT(self) -> tuple[Nine, Three]:
        """The tool in the world."""
        return self._R, self.x[:3]

    def adopt(self, measured: Measured | None = None) -> None:
        """See where the tool is."""
        if measured is not None:
            self._see(measured.q, measured.qd)

    def seen(self, goal: Goal) -> Goal:
        """A row of the equilibrium as it is."""
        return goal

    def feel(self, measured: Measured) -> float | Stop:
        """Set force: what pushes the tool; the controller does not go by it."""
        pushed = sum((push.at(self.t) for push in self.settings.pushes), np.array(measured.contact))
        a, b, c, d, e, f = pushed.tolist()
        self.force = (a, b, c, d, e, f)
        if not np.isfinite(self._q).all():
            message = f"at {self.t:.3f} s the arm's state is no number any more; lower stiffness or damping"
            return Stop(self.t, StopKind.TORQUE, "arm", float("nan"), float("nan"), "Nm", message)
        if self.k == 0:
            *_, L, D = self._damped()
            gain = self.settings.h * float(np.linalg.eigvals(np.linalg.solve(L, D)).real.max())
            if gain >= 2:
                message = (
                    f"damping of {gain:.3g} inertias per period, under 2 it has to be: the torque is held too long"
                )
                message += "; lower D (the angles' first), or give damping ratios, which go by the inertia"
                return Stop(self.t, StopKind.TORQUE, "arm", gain, 2.0, "", message)
        return 0.0

    def step(self, goal: Goal, measured: Measured, following: Goal | None = None) -> Command | Stop:
        """The torques of one period, from what is measured at its start."""
        if isinstance(stop := self.feel(measured), Stop):
            return stop
        q, qd, J, K = self._q, self._qd, self._J, self.settings.compliance.K
        M, bias, JM, L, D = self._damped()
        e, v_e = self._off(goal), np.zeros(6)
        if following is not None and self.settings.feed is Feed.VELOCITY:
            v_e = (self._off(following) - e) / self.settings.h
        wanted = K * e + D @ (v_e - np.array(self.v)) + np.array(goal.wrench)
        k_n = self._law.null_stiffness
        inner = -k_n * (q - self._rest) - 2 * self._law.null_damping * np.sqrt(k_n * np.diag(M)) * qd
        tau = J.T @ wanted + inner - J.T @ (L @ (JM @ inner)) + bias
        self.k += 1
        return Command(measured.q, seven(tau))

    def _damped(self) -> tuple[Array, Array, Array, Array, Array]:
        """The joints' inertia M and bias torques, J M^-1, the tool's inertia L, and D (6, 6)."""
        M, bias = self._dynamics.inertia_and_bias(self._q, self._qd)
        JM = np.linalg.solve(M, self._J.T).T
        L = np.linalg.inv(JM @ self._J.T)
        D = np.diag(self.settings.compliance.D)
        if self._law.damping_ratio is not None:
            values, axes = np.linalg.eigh(L)
            half = (axes * np.sqrt(values)) @ axes.T * (self._law.damping_ratio * np.sqrt(self.settings.compliance.K))
            D = half + half.T
        return M, bias, np.asarray(JM), np.asarray(L), D

    def _off(self, goal: Goal) -> Array:
        """From the tool to a row of the equilibrium (6,) [m, rad], world axes."""
        R_e = product(rotation(*goal.x[3:]), self._R_start) if goal.R is None else goal.R
        return np.array([*np.subtract(goal.x[:3], self.x[:3]), *logarithm(product(R_e, transpose(self._R)))])

    def _see(self, q: Seven, qd: Seven) -> None:
        self._q, self._qd = np.array(q), np.array(qd)
        self._J = self.robot.jacobian(self._q, self.settings.X_FT)
        X = self.robot.forward(self._q) @ self.settings.X_FT
        self._R = nine(X[:3, :3].ravel().tolist())
        x, y, z = X[:3, 3].tolist()
        self.x = (x, y, z, *angles(product(self._R, transpose(self._R_start)), self.x[3:]))
        a, b, c, d, e, f = (self._J @ self._qd).tolist()
        self.v: Six = (a, b, c, d, e, f)
