"""MuJoCo as the world: the arm as a body of links with motors, the tool's tip against boxes. The extra `sim`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from math import ceil, hypot, isfinite, nan, sqrt
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Contact, Push, PushLog
from trajopt_cli.iiwa.task.world import LinkContact, Measured, Motor, Seven, Six
from trajopt_cli.iiwa.world.contact import APART, FRICTION_RISE, about, added, bodies
from trajopt_cli.iiwa.world.mjcf import HULL, SLIP_RATIO, SOFTEST, TCP, TIP, mjcf
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs import SrsRobot

SERVO_DELAY = 5e-3
"""How far the arm runs behind its command [s]. Inferred (grade C), for KUKA does not say: Cihala's flange is 0.7 to
1.6 mm off its command at worst and 0.1 mm on average (tables 6.1, 6.4), 5 ms at speeds of 0.1 to 0.3 m/s; he prints no
speeds."""
SERVO_STIFFNESS = 100.0
"""Joint stiffness [1/rad] per range of the joint's torque sensor: its full range winds a joint by 10 mrad, 17,600
Nm/rad in the shoulder, 4,000 at the wrist. An estimate of gears and servo together, unconfirmed (grade D)."""
_OMEGA = 2.0 / SERVO_DELAY  # a critically damped filter lags by two over its frequency
_EXPLICIT = 1.8
"""Longest time step of the physics in time constants of the servo's fastest motion, which Runge-Kutta bears up to 2.78.

For the iiwa7 that is 0.2 ms in the middle of the workspace and 0.07 ms stretched out; stiff contacts take shorter ones.
"""
_LOOK = 0.01
"""How often the time step is set anew [s], for the posture then."""
FINEST = 2e-5
"""Shortest time step that a contact may need [s], 50 in a period of 1 ms: what needs a shorter one is refused."""
_BENT = np.radians([0.0, 90.0, 0.0, -90.0, 0.0, 90.0, 0.0])  # every joint bears about as much inertia as it ever does
_SPRING, _DAMPER = 0.2, 1.5  # longest step in time constants sqrt(m/k) and m/d of a contact; at 2 and 2 it blows up


def available() -> str | None:
    """The version of the MuJoCo that can be imported, None where there is none or where its import fails."""
    try:
        return str(_imported().__version__)
    except InputError:
        return None


def _imported() -> Any:
    """The module. Raises InputError where it is missing, broken or too old."""
    try:
        import mujoco
        from mujoco import MjLogConfig  # noqa: F401  older than 4, or a folder left behind: no such name
    except (ImportError, OSError, RuntimeError, AttributeError) as error:  # its own, of its libraries, of MUJOCO_GL
        fault = f"cannot be imported: {' '.join(str(error).split())}; pip install --force-reinstall"
        if isinstance(error, ModuleNotFoundError) and error.name == "mujoco":
            fault = "is not installed: pip install"
        raise InputError(f"MuJoCo {fault} 'trajopt-cli[sim]', or use the spring wall") from error
    return mujoco


_NOTHING = Measured((nan,) * 7, (nan,) * 7, (nan,) * 7, (nan,) * 7, (nan,) * 6, nan)


class MujocoWorld:
    """The arm robot with a tool at X_FT (4, 4) and its load, in MuJoCo; contact is what the tip may run into.

    Servo: a critically damped filter lets the command of every period h [s] lag by SERVO_DELAY. Critically damped
    motors of SERVO_STIFFNESS hold the joints on it, fed forward with the torques of the motion that nothing disturbs. A
    push on the tool bends the arm: the tip by about 1 mm per 40 N in the middle of the workspace. Motors give the
    robot's torque at most, and motors tells how near they came. Between motor and sensor joints lose the robot's
    damping times their speed and its friction, which the servo does not know; a joint's range is an end stop.

    Energy: without motors, friction and damping what the arm has is kept (docs/measured.md, RK4 and others).

    Contact: MuJoCo's own, at its smallest impedance. There its force is the obstacle's stiffness times the depth plus
    the damping times the speed of approach, as in BallOnBoxes, beside a small inertia (see mjcf.SLIP_RATIO): MuJoCo's
    solref sets accelerations, which divided by the contact's regularisation R = (1 - SOFTEST) / SOFTEST * A are forces,
    A the compliance that MuJoCo ascribes to the tool's body. Boxes on springs would need masses that bounce. Capsules
    around the links that move and the tool's body meet the obstacles by the same law, but not one another.

    A measurement is MuJoCo's state at the period's end: tau is what sensors behind the gears see, the motors' torques
    less what the joints lose. Equal commands give equal measurements, digit by digit. Once MuJoCo warns that its state
    is none any more, all that is measured is nan; it neither prints nor logs, and starts nothing anew.

    Raises InputError where MuJoCo cannot be imported or refuses the arm, ValueError for contacts that need
    shorter time steps than FINEST.
    """

    _servoed = True

    def __init__(self, robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, h: float) -> None:
        mujoco = _imported()
        self._mj: Any = mujoco
        self._version, self._h = str(mujoco.__version__), h
        self._contact = contact
        stiffness = SERVO_STIFFNESS * robot.torque
        bare = self._compiled(mjcf(robot, X_FT, load, contact, [(0.0, 0.0)] * len(stiffness)))
        data = mujoco.MjData(bare)
        with _Quiet(mujoco):
            inertia = _mass_matrix(mujoco, bare, _BENT, data)
        if data.warning.number.any() or not np.isfinite(inertia).all():
            raise InputError(
                "MuJoCo cannot resolve the inertia of the arm with this load: correct their masses and inertias, or "
                "use the spring wall"
            )
        stiffness = stiffness if self._servoed else 0.0 * stiffness
        gains = [(k, 2.0 * sqrt(k * m)) for k, m in zip(stiffness.tolist(), np.diag(inertia).tolist(), strict=True)]
        self.model: Any = self._compiled(mjcf(robot, X_FT, load, contact, gains))
        # A state that is none any more is to be seen, not replaced by the model's first.
        self.model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_AUTORESET)
        self._kp, self._kd = (np.array(column) for column in zip(*gains, strict=True))
        self._data, self._wanted = mujoco.MjData(self.model), mujoco.MjData(self.model)
        data = self._data
        self._ctrl = data.ctrl
        self._views = data.qpos, data.qvel, data.qacc
        self._force = data.actuator_force
        self._rubbing = np.flatnonzero(self.model.dof_frictionloss)
        self._names, self._limits = robot.axis_names, np.array(robot.torque)
        self._hulls = [name for name, *_ in bodies(robot, contact)] if contact is not None else []
        self._warnings = data.warning.number
        self._servo: _Servo
        self._tip = self.model.geom(TIP).id if contact is not None else -1
        self._tcp = self.model.site(TCP).id
        self._bodies = {self.model.geom(HULL + name).id: name for name in self._hulls}
        self._boxes: dict[int, str] = {}
        self._set_contacts()
        self._check_resolution()
        self._forget()

    @property
    def name(self) -> str:
        """MuJoCo and its version."""
        return f"MuJoCo {self._version}"

    @property
    def link_contacts(self) -> tuple[LinkContact, ...]:
        """Which links were in which obstacles since the reset."""
        return tuple(self._touched.values())

    @property
    def motors(self) -> tuple[Motor, ...]:
        """What the motors gave since the reset."""
        rows = zip(self._names, self._most.tolist(), self._limits.tolist(), strict=True)
        return tuple(Motor(*row, self._saturated.get(i)) for i, row in enumerate(rows))

    def _forget(self) -> None:
        self._t, self._most = 0.0, np.zeros(len(self._limits))
        self._saturated: dict[int, float] = {}
        self._touched: dict[tuple[str, str], LinkContact] = {}

    def reset(self, q: Seven) -> Measured:
        """Stand still at q [rad] (7,). Raises InputError where MuJoCo finds no state there."""
        with _Quiet(self._mj):
            measured = self._stand(q)
        if not isfinite(sum((*measured.qdd, *measured.tau, *measured.contact))):
            raise InputError("MuJoCo finds no forces at the start: start outside of the obstacles, or soften them")
        return measured

    def _stand(self, q: Seven) -> Measured:
        mj, model, data = self._mj, self.model, self._data
        mj.mj_resetData(model, data)
        data.qpos[:] = q
        self._filtered, self._speed = np.array(q, dtype=np.float64), np.zeros(len(data.qpos))
        self._servo = self._refined(q)
        self._forget()
        data.ctrl[:] = self._forward(self._filtered, self._speed, self._speed) + self._kp * self._filtered
        return self._measure()

    def _refined(self, q: Sequence[float] | Array) -> _Servo:
        """Set the time step for the posture q; the servo in such steps."""
        self._left, steps = ceil(_LOOK / self._h), self._resolution(q)
        self.model.opt.timestep = self._h / steps
        self.model.dof_solref[:] = 0.0, -steps / self._h  # friction brakes within a time step, up to its bound
        return _Servo(self._kp, self._kd, self._h, steps)

    def step(self, q: Seven) -> Measured:
        """Follow the command q [rad] (7,) for one period, after a reset."""
        self._left -= 1
        if self._left <= 0:
            self._servo = self._refined(self._filtered)
        before, before_speed, h = self._filtered, self._speed, self._h
        controls, after, speed = self._servo.period(before, before_speed, np.array(q, dtype=np.float64))
        # The filter's acceleration swings within a period, and its middle is not its mean.
        controls += self._forward((before + after) / 2, (after - before) / h, (speed - before_speed) / h)
        self._filtered, self._speed = after, speed
        return self._driven(controls)

    def _driven(self, controls: Array) -> Measured:
        """One period with the motors' controls (n + 1, 7) [Nm] of its time steps and its end."""
        step, model, data, ctrl, h = self._mj.mj_step, self.model, self._data, self._ctrl, self._h
        most = np.zeros(len(self._limits))
        with _Quiet(self._mj):
            for control in controls[:-1]:
                ctrl[:] = control
                step(model, data)
                np.maximum(most, np.abs(self._force), out=most)
            ctrl[:] = controls[-1]
            self._t += h
            for i in np.flatnonzero(most >= self._limits):
                self._saturated.setdefault(int(i), self._t)
            np.maximum(self._most, most, out=self._most)
            return self._measure()

    def _forward(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Torques (7,) [Nm] of that motion with nothing touching the tool."""
        mj, model, data = self._mj, self.model, self._wanted
        data.qpos[:], data.qvel[:], data.qacc[:] = q, qd, qdd
        mj.mj_kinematics(model, data)
        mj.mj_comPos(model, data)
        mj.mj_comVel(model, data)
        out = np.empty(len(q))
        mj.mj_rne(model, data, 1, out)
        return out

    def _measure(self) -> Measured:
        if any(self._warnings.tolist()):
            return _NOTHING
        self._mj.mj_forward(self.model, self._data)
        q, qd, qdd = (tuple(view.tolist()) for view in self._views)
        behind = self._force + self._data.qfrc_passive
        behind[self._rubbing] += self._data.efc_force[: len(self._rubbing)]  # friction's rows come before all others
        tau = tuple(behind.tolist())
        force, depth = self._touch() if self._data.ncon else (APART.force, APART.depth)
        return Measured(q, qd, qdd, tau, force, depth)

    def _touch(self) -> tuple[Six, float]:
        """The contacts' force on the tool, about its TCP in world axes, and the deepest depth; the links' are noted."""
        data, total, depth = self._data, APART.force, 0.0
        x, y, z = data.site_xpos[self._tcp].tolist()
        found, local = data.contact, np.empty(6)
        rows = zip(found.geom.tolist(), found.frame.tolist(), found.pos.tolist(), found.dist.tolist(), strict=True)
        for i, (geoms, (a, b, c, d, e, f, g, h, k), (px, py, pz), distance) in enumerate(rows):
            self._mj.mj_contactForce(self.model, data, i, local)
            # along the frame's rows, the first the normal from the pair's first to its second, on which the force acts
            u, v, w, *_ = local.tolist()
            if self._tip not in geoms:
                self._note(geoms, -distance, hypot(u, v, w))
                continue
            if geoms[1] != self._tip:
                u, v, w = -u, -v, -w
            force = (u * a + v * d + w * g, u * b + v * e + w * h, u * c + v * f + w * k)
            one = about((px - x, py - y, pz - z), force)
            total = added(total, one)
            depth = max(depth, -distance)
        return total, depth

    def _note(self, geoms: Sequence[int], depth: float, force: float) -> None:
        """A link in an obstacle at the present time."""
        link = next(self._bodies[i] for i in geoms if i in self._bodies)
        box = next(self._boxes[i] for i in geoms if i in self._boxes)
        old = self._touched.get((link, box), LinkContact(link, box, self._t, self._t, 0.0, 0.0))
        deepest, strongest = max(old.depth, depth), max(old.force or 0.0, force)
        self._touched[link, box] = LinkContact(link, box, old.first, self._t, deepest, strongest)

    def _compiled(self, text: str) -> Any:
        mj = self._mj
        try:
            with _Quiet(mj):
                return mj.MjModel.from_xml_string(text)
        except (ValueError, mj.FatalError) as error:
            reason = re.sub(r", id \d+, line \d+", "", " ".join(str(error).removeprefix("Error: ").split()))
            raise InputError(
                f"MuJoCo refuses the arm, its tool or an obstacle: {reason}; correct its mass, inertia or size, or use "
                "the spring wall"
            ) from error

    def _set_contacts(self) -> None:
        """Write the obstacles' stiffness and damping as reference accelerations; the tool's body sets the scale."""
        if self._contact is None:
            return
        model = self.model
        for i, obstacle in enumerate(self._contact.obstacles):
            self._boxes[model.geom(f"box_{i}").id] = obstacle.shape.name
            for geom, name in ((TIP, f"box_{i}"), *((HULL + link, f"{link}_box_{i}") for link in self._hulls)):
                scale = model.body_invweight0[model.geom_bodyid[model.geom(geom).id], 0] * (1.0 - SOFTEST)
                pair = model.pair(name).id
                # negative: stiffness and damping themselves, not time constants
                model.pair_solref[pair] = -scale * obstacle.stiffness, -scale * obstacle.damping
                model.pair_solreffriction[pair] = 0.0, -scale * FRICTION_RISE / SLIP_RATIO

    def _resolution(self, q: Sequence[float] | Array) -> int:
        """Time steps per period: for the servo at its fastest, and for the contacts by the tip's lightest way, at q."""
        with _Quiet(self._mj):
            inertia = _mass_matrix(self._mj, self.model, q, self._wanted)
        if not np.isfinite(inertia).all():
            return 1  # no state: what is measured says so
        fastest = np.linalg.eigvals(np.linalg.solve(inertia, np.diag(self._kd + self.model.dof_damping))).real.max()
        least = max(1, ceil(self._h * float(fastest) / _EXPLICIT))
        if self._contact is None:
            return least
        mass = self._tip_mass(q)
        for one in self._contact.obstacles:
            finest = min(_SPRING * sqrt(mass / one.stiffness), _DAMPER * mass / max(one.damping, FRICTION_RISE))
            least = max(least, ceil(self._h / finest))
        return least

    def _check_resolution(self) -> None:
        """Raise ValueError for a contact that needs shorter time steps than FINEST.

        By the tip at one configuration: its lightest direction is a turn of the last links, much the same in all.
        """
        if self._contact is None:
            return
        mass = self._tip_mass(_BENT)
        stiffest, strongest = mass * (_SPRING / FINEST) ** 2, _DAMPER * mass / FINEST
        for one in self._contact.obstacles:
            for what, value, bound, unit in (
                ("stiffness", one.stiffness, stiffest, "N/m"),
                ("damping", one.damping, strongest, "N s/m"),
                ("rise of friction", FRICTION_RISE, strongest, "N s/m"),
            ):
                if value > bound:
                    raise ValueError(
                        f"obstacle '{one.shape.name}': {what} {value:g} {unit}, at most {bound:.4g} {unit} with MuJoCo "
                        f"and the {mass:.3g} kg of this tip, for time steps of {FINEST:g} s; lower it, give the tool "
                        "its load, or use the spring wall"
                    )

    def _tip_mass(self, q: Sequence[float] | Array) -> float:
        """What the tip's lightest direction weighs at q [kg]."""
        mj, model, data = self._mj, self.model, self._wanted
        with _Quiet(mj):
            inertia = _mass_matrix(mj, model, q, data)
        J = np.zeros((3, model.nv))
        mj.mj_jacSite(model, data, J, None, self._tcp)
        return float(1.0 / np.linalg.eigvalsh(J @ np.linalg.solve(inertia, J.T))[-1])


Pushes = Sequence[Push | PushLog]


class TorqueWorld(MujocoWorld):
    """The same arm with motors that take torques, held for a period, and pushes on its tool.

    Joints lose nothing: an LBR's torque control goes by the sensors behind gears and friction, and makes up for both.
    """

    _servoed = False

    def __init__(
        self, robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, h: float, pushes: Pushes
    ) -> None:
        none = np.zeros(len(robot.torque))
        super().__init__(replace(robot, damping=none, friction=none), X_FT, load, contact, h)
        self._pushes = pushes

    def step(self, tau: Seven) -> Measured:
        """Drive the motors with tau [Nm] (7,) for one period, after a reset."""
        self._left -= 1
        if self._left <= 0:
            self._refined(self._data.qpos)
        if self._pushes:
            J = np.zeros((6, self.model.nv))
            self._mj.mj_jacSite(self.model, self._data, J[:3], J[3:], self._tcp)
            self._data.qfrc_applied[:] = J.T @ sum(push.at(self._t) for push in self._pushes)
        steps = round(self._h / self.model.opt.timestep)
        return self._driven(np.tile(tau, (steps + 1, 1)))


class _Servo:
    """The command's filter and the motors' springs over one period: all that is linear, prepared.

    The filter is critically damped: off its command by x with speed v, after a time t it is (x + (v + omega x) t) e
    off with speed (v - omega (v + omega x) t) e, e = exp(-omega t).
    """

    def __init__(self, kp: Array, kd: Array, h: float, substeps: int) -> None:
        # held over each time step: in its middle, that nothing lags behind the filter
        t = h * np.append((np.arange(substeps) + 0.5) / substeps, 1.0)[:, None]
        omega, gone = _OMEGA, np.exp(-_OMEGA * t)
        x_x, x_v = (1 + omega * t) * gone, t * gone
        v_x, v_v = -omega * omega * t * gone, (1 - omega * t) * gone
        self._kp = kp
        self._of_off, self._of_speed = kp * x_x + kd * v_x, kp * x_v + kd * v_v
        self._last = tuple(float(column[-1, 0]) for column in (x_x, x_v, v_x, v_v))

    def period(self, position: Array, speed: Array, command: Array) -> tuple[Array, Array, Array]:
        """The motors' controls (n + 1, 7) [Nm] for n time steps and at their end, without feed-forward; the end
        and speed of the filter."""
        off = position - command
        controls = self._of_off * off + self._of_speed * speed + self._kp * command
        x_x, x_v, v_x, v_v = self._last
        return controls, command + x_x * off + x_v * speed, v_x * off + v_v * speed


class _Quiet:
    """While it lasts, MuJoCo's warnings are counted, but neither printed nor appended to a file where we stand."""

    def __init__(self, mj: Any) -> None:
        self._before, self._now = mj.MjLogConfig.get(), mj.MjLogConfig.get()
        self._now.logto_console = self._now.logto_file = False

    def __enter__(self) -> None:
        self._now.set()

    def __exit__(self, *_: object) -> None:
        self._before.set()


def _mass_matrix(mj: Any, model: Any, q: Sequence[float] | Array, data: Any) -> Array:
    data.qpos[:] = q
    mj.mj_forward(model, data)
    out, column = np.empty((model.nv, model.nv)), np.empty(model.nv)
    for i, unit in enumerate(np.eye(model.nv)):
        mj.mj_mulM(model, data, column, unit)
        out[:, i] = column
    return out
