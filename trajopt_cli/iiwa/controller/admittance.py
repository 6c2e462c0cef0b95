"""The whole controller of scheme 4.1, one period at a time: torques in, joints out.

Torque errors, tau_e = tau_c - tau_m, clamp, force mapping, clamp, simulated pushes, zeroing, regulator, inverse.
"""

from __future__ import annotations

from math import degrees, hypot, isfinite, nan
from operator import add, sub
from time import perf_counter

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, pose
from trajopt_cli.iiwa.controller.forces import SMALLEST, SingularArm, TorqueErrors, clamped, force_of, zero
from trajopt_cli.iiwa.controller.parameters import Command, Goal, Settings, Stop, StopKind
from trajopt_cli.iiwa.controller.regulator import Regulator
from trajopt_cli.iiwa.controller.rotations import Nine, Three, angles, nine, rotation, transpose
from trajopt_cli.iiwa.task.model import BETA_LIMIT, Change, Clamps, RotationLaw
from trajopt_cli.iiwa.task.world import Measured, Seven, Six
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import arm_angle, configuration
from trajopt_cli.robot.srs_step import SrsStep, product

_AHEAD = 256  # periods whose torque errors and pushes are worked out at once
_SOON = 1e-9  # s: a change or push this little after a period's start begins with it


class Controller:
    """Switched on at rest at joints q_0 (7,) [rad] of a robot mounted in the world.

    R_start, the TCP's position, the configuration and, unless the settings have one, the arm angle come from q_0. The
    torque model keeps the base and the load it was made with: a change of X_WB or X_FT is another way to look at the
    same arm, and neither the arm nor its planned path jumps. k counts the periods; force is the one last believed;
    times [s] are how long the last period took: torque model, force mapping, regulator, inverse, all of it.
    """

    def __init__(self, robot: SrsRobot, settings: Settings, q_0: Seven) -> None:
        self.settings, self.robot, self.q_0 = settings, robot, q_0
        self.k = 0
        self.force: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        self.times = (0.0, 0.0, 0.0, 0.0, 0.0)
        self.configuration = int(configuration(np.array(q_0)))
        given = settings.arm_angle
        self.arm_angle = float(arm_angle(robot, np.array(q_0), settings.definition)) if given is None else given
        self._X_FT = settings.X_FT
        self._kinematics = self._step_of(robot, settings.X_FT)
        self._kinematics.force(q_0, (0.0,) * 7)  # loads its loops: in the first period that took 30 ms
        self._dynamics = Dynamics(robot, settings.load)
        sensor = settings.sensor
        self._rigid = sensor is None or sensor.rigid
        self._errors = None if sensor is None else TorqueErrors(sensor, robot.torque, settings.h)
        self._block: tuple[int, list[list[float]], list[list[float]]] = (-1, [], [])
        self._zeroing = settings.zeroing
        self._set_clamps(settings.clamps)
        self._changes = sorted(settings.changes, key=lambda change: change.t)
        R, p = self._kinematics.forward(q_0)
        laws = settings.rotation, settings.integration, settings.feed
        self._state = Regulator(settings.compliance, settings.h, R, p, *laws)
        self._R_first = R
        self._seen_from: tuple[Array, Array] | None = None  # X_W'W and X_TT' since the start, None while unchanged
        self._near: Three = (0.0, 0.0, 0.0)  # the equilibrium's angles of the row before, in the present frames

    @property
    def t(self) -> float:
        """The present period's start [s]."""
        return self.k * self.settings.h

    @property
    def x(self) -> Six:
        """The regulator's position [m] and angles [rad] from R_start."""
        return self._state.x

    @property
    def v(self) -> Six:
        """Its rates: of x, or velocity and angular velocity where the law is slerp."""
        return self._state.v

    @property
    def X_WT(self) -> tuple[Nine, Three]:
        """The regulator's pose of the TCP in the world: nine floats row by row, and position [m]."""
        return self._state.R, self._state.x[:3]

    @property
    def R_start(self) -> Array:
        """The orientation (3, 3) that the angles count from."""
        return np.reshape(self._state.R_start, (3, 3))

    def step(self, goal: Goal, measured: Measured, following: Goal | None = None) -> Command | Stop:
        """One period: what to command for its end, towards the equilibrium goal, from what is measured at its start.

        following: the equilibrium's next row, of which Feed.VELOCITY takes the speed; None at its end.
        """
        begin = perf_counter()
        self.adopt()
        model_at = self.feel(measured)
        if isinstance(model_at, Stop):
            return model_at
        force_at = perf_counter()
        aim = self.seen(goal)
        if following is not None and self._seen_from is not None:
            following = self._looked_at(following, aim.x[3:])
        self._near = aim.x[3:]
        a, b, c, d, e, f = (felt + told for felt, told in zip(self.force, goal.wrench, strict=True))
        self._state.step(aim, (a, b, c, d, e, f), following)
        self.k += 1
        x = self._state.x
        R, p = self.X_WT
        moved_at = perf_counter()
        if self.settings.rotation is RotationLaw.TAIT_BRYAN and not abs(x[4]) <= BETA_LIMIT:
            return self._locked(x[4])
        q = self._kinematics.joints(R, p)
        if q is None:
            return self._unreachable(R, p)
        end = perf_counter()
        self.times = (model_at - begin, force_at - model_at, moved_at - force_at, end - moved_at, end - begin)
        return Command(q)

    def feel(self, measured: Measured) -> float | Stop:
        """Set force from what is measured at the present period's start; when (perf_counter) tau_c was known."""
        if self._rigid:
            tau_c = self._dynamics.torque_row(measured.q, measured.qd, measured.qdd)
        else:
            tau_c = self._dynamics.gravity_torque(np.array(measured.q)).tolist()
        tau_e = list(map(sub, tau_c, measured.tau))
        if self._errors is not None:
            tau_e = list(map(sub, tau_e, self._ahead()[1][self.k % _AHEAD]))
        if not isfinite(sum(tau_e)):
            return self._stop(StopKind.TORQUE, "arm", nan, nan, "Nm", "the measured torques are not finite")
        if self._tau_bounds is not None:
            tau_e = clamped(tau_e, self._tau_bounds)
        model_at = perf_counter()
        try:
            F, trace = self._kinematics.force(measured.q, tau_e)
            if not trace * SMALLEST**2 < 1:  # no singular value is smaller than one over the trace's root
                F = force_of(self._kinematics.jacobian(measured.q), tau_e).tolist()
        except SingularArm as singular:
            return self._stop(StopKind.SINGULAR, "arm", singular.smallest, SMALLEST, "", str(singular))
        if self._force_bounds is not None:
            F = clamped(F, self._force_bounds)
        if self.settings.pushes:
            F = list(map(add, F, self._ahead()[2][self.k % _AHEAD]))
        if any(self._zeroing.zeroed):
            F = zero(F, self._zeroing).tolist()
        self.force = (F[0], F[1], F[2], F[3], F[4], F[5])
        return model_at

    def _ahead(self) -> tuple[int, list[list[float]], list[list[float]]]:
        """The present block of _AHEAD periods: its number, and for each of them torque errors and pushes."""
        part = self.k // _AHEAD
        if part != self._block[0]:
            k = part * _AHEAD + np.arange(_AHEAD)
            errors = [] if self._errors is None else self._errors.at(k).tolist()
            pushes = sum((push.at(k * self.settings.h) for push in self.settings.pushes), np.zeros((_AHEAD, 6)))
            self._block = part, errors, pushes.tolist()
        return self._block

    def seen(self, goal: Goal) -> Goal:
        """A row of the planned equilibrium as the present frames have it; the row itself while none has changed."""
        if self._seen_from is None:
            return goal
        return self._looked_at(goal, self._near)

    def adopt(self, _: Measured | None = None) -> None:
        """Take up the changes due by the present period. The pose and its rates stay, however they are written."""
        while self._changes and self._changes[0].t <= self.t + _SOON:
            change = self._changes.pop(0)
            if change.compliance is not None:
                self._state.set(change.compliance)
            if change.zeroing is not None:
                self._zeroing = change.zeroing
            if change.clamps is not None:
                self._set_clamps(change.clamps)
            if change.X_FT is not None or change.X_WB is not None or change.restart:
                self._look_anew(change)

    def _look_anew(self, change: Change) -> None:
        """Other frames: X_W'T' = X_W'W X_WT X_TT' for the regulator's pose, its start and the planned rows alike."""
        X_WB = self.robot.X_WB if change.X_WB is None else change.X_WB
        X_FT = self._X_FT if change.X_FT is None else change.X_FT
        world = X_WB @ inverse_pose(self.robot.X_WB)
        tool = inverse_pose(self._X_FT) @ X_FT
        x_before, (R, p), (v, w) = self._state.x, self.X_WT, map(np.array, self._state.twist)
        v = v + np.cross(w, np.reshape(R, (3, 3)) @ tool[:3, 3])  # the new TCP turns about the old one
        turn, after = world[:3, :3], self._mapped(R, p, world, tool)
        if change.restart:
            R_start, near = after[0], (0.0, 0.0, 0.0)
        else:
            R_start, near = nine((turn @ self.R_start @ tool[:3, :3]).ravel().tolist()), self._state.x[3:]
        self._state.put(after, (_three(turn @ v), _three(turn @ w)), R_start, near)
        before = self._seen_from or (np.eye(4), np.eye(4))
        self._seen_from = world @ before[0], before[1] @ tool
        # whole turns between equilibrium and regulator pull as before
        a, b, c = (now + e - was for now, e, was in zip(self._state.x[3:], self._near, x_before[3:], strict=True))
        self._near = (a, b, c)
        if change.X_WB is not None or change.X_FT is not None:
            self.robot, self._X_FT = self.robot.mounted(X_WB), X_FT
            self._kinematics = self._step_of(self.robot, X_FT)

    def _looked_at(self, goal: Goal, near: Three) -> Goal:
        """A planned row in the present frames, its angles nearest to near."""
        assert self._seen_from is not None
        x, y, z, *turn = goal.x
        R = product(rotation(*turn), self._R_first) if goal.R is None else goal.R
        R, p = self._mapped(R, (x, y, z), *self._seen_from)
        at = angles(product(R, transpose(self._state.R_start)), near)
        return Goal((*p, *at), None if goal.R is None else R)

    @staticmethod
    def _mapped(R: Nine, p: Three, world: Array, tool: Array) -> tuple[Nine, Three]:
        X = world @ pose(np.reshape(R, (3, 3)), p) @ tool
        return nine(X[:3, :3].ravel().tolist()), _three(X[:3, 3])

    def _step_of(self, robot: SrsRobot, X_FT: Array) -> SrsStep:
        return SrsStep(robot, self.settings.definition, self.configuration, self.arm_angle, X_FT)

    def _set_clamps(self, clamps: Clamps) -> None:
        tau, force = clamps.torque.tolist(), clamps.force.tolist()
        self._tau_bounds = tau if any(map(isfinite, tau)) else None
        self._force_bounds = force if any(map(isfinite, force)) else None

    def _locked(self, beta: float) -> Stop:
        message = (
            f"beta = {degrees(beta):.4g}°, limit ±{degrees(BETA_LIMIT):g}°: beyond it the three angles lock; "
            "take the start's orientation nearer to the path's, or slerp"
        )
        return self._stop(StopKind.BETA, "beta", abs(beta), float(BETA_LIMIT), "rad", message)

    def _unreachable(self, R: Nine, p: Three) -> Stop:
        L = self.robot.lengths
        X = inverse_pose(self.robot.X_WB) @ pose(np.reshape(R, (3, 3)), p) @ inverse_pose(self._X_FT)
        x, y, z = (X[:3, 3] - L.wf * X[:3, 2]).tolist()
        far = hypot(x, y, z - L.bs)
        bounds = (abs(L.se - L.ew), L.se + L.ew)
        limit = bounds[0] if far < bounds[0] else bounds[1]
        message = (
            f"the pose ({', '.join(f'{value:.4g}' for value in p)}) m is out of reach: its wrist centre is {far:.4g} m "
            f"from the shoulder, possible are {bounds[0]:.4g} to {bounds[1]:.4g} m; keep the path or the force smaller"
        )
        return self._stop(StopKind.UNREACHABLE, "TCP", far, limit, "m", message)

    def _stop(self, kind: StopKind, subject: str, value: float, limit: float, unit: str, message: str) -> Stop:
        return Stop(self.t, kind, subject, value, limit, unit, f"at {self.t:.3f} s {message}")


def _three(values: Array) -> Three:
    x, y, z = values.tolist()
    return (x, y, z)
