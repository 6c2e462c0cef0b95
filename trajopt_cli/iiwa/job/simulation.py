"""`trajopt iiwa simulate`: what the compliant controller makes of a folder's sequence."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import astuple, dataclass, replace
from functools import cached_property
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.forces import zero
from trajopt_cli.iiwa.controller.impedance import ImpedanceController
from trajopt_cli.iiwa.controller.lag import Lag, deviation, held, held_rows, worst_lag
from trajopt_cli.iiwa.controller.loop import LoopRun, run
from trajopt_cli.iiwa.controller.parameters import Settings
from trajopt_cli.iiwa.controller.regulator import equilibrium_rates, response
from trajopt_cli.iiwa.controller.stability import AxisStability, StabilityVerdict, stability
from trajopt_cli.iiwa.job.folder import SIMULATION, Opened, add_to_folder, counted_from_start, open_folder
from trajopt_cli.iiwa.job.force import Pressing, force_along, force_records, pressing
from trajopt_cli.iiwa.job.joints import joint_record
from trajopt_cli.iiwa.report.answer import Refused
from trajopt_cli.iiwa.task.angles import angles_near, rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.joints import Followed, Unfollowable
from trajopt_cli.iiwa.task.loader import load_contact
from trajopt_cli.iiwa.task.model import (
    COORDINATES,
    UNITS,
    AngleMeaning,
    Contact,
    Feed,
    Integration,
    RotationLaw,
    Task,
    Zeroing,
)
from trajopt_cli.iiwa.task.world import LinkContact, Motor, World, seven
from trajopt_cli.iiwa.world import mujoco_world
from trajopt_cli.iiwa.world.contact import check_start
from trajopt_cli.iiwa.world.worlds import Engine, make_world
from trajopt_cli.runs import REPORT

_LONGEST_SETTLING = 10.0  # s
_SOON = 1e-9  # s: a change this little after a period's start begins with it
# of LinkContact and Motor, field by field
_LINK = ("link", "obstacle", "first_s", "last_s", "deepest_m", "largest_force_N")
_MOTOR = ("joint", "largest_torque_Nm", "limit_Nm", "saturated_at_s")
_FORCES = ("fx [N]", "fy [N]", "fz [N]", "mx [Nm]", "my [Nm]", "mz [Nm]")


@dataclass(frozen=True, eq=False)
class Simulated:
    """A run of n periods, the last pose held for a while at its end.

    x_e, x (n, 6) [m, rad]: equilibrium and controller, angles from the start; target: where the controller should be,
    on the plan where there is one, else the equilibrium. force (n, 6) [N, Nm]: what the controller
    believes pushes the tool. lag: how far x stays behind. joints: the arm's, where it follows exactly. loop: the whole
    controller against its world, None where nothing asks for it; why: what does; links, motors: what that world tells
    of them. fallback: its world is springs only because MuJoCo is not installed.
    """

    opened: Opened
    x_e: Array
    x: Array
    target: Array
    force: Array
    lag: Lag
    axes: tuple[AxisStability, ...]
    joints: Followed | Unfollowable | None
    loop: LoopRun | None
    contact: Contact | None
    feed: Feed
    settle: float
    why: tuple[str, ...]
    fallback: bool = False
    links: tuple[LinkContact, ...] = ()
    motors: tuple[Motor, ...] = ()
    pressing: Pressing | None = None

    @property
    def t(self) -> Array:
        """Times (n,) [s]."""
        return np.asarray(np.arange(len(self.x)) * self.opened.equilibrium.h, dtype=np.float64)

    @property
    def broken(self) -> tuple[str, ...]:
        """Why this is no motion for the arm, one line each: what stopped the loop, or the joints that break a limit."""
        if self.loop is not None:
            return () if self.loop.stop is None else (self.loop.stop.message,)
        if isinstance(self.joints, Followed):
            return tuple(finding.message for finding in self.joints.findings if not finding.passed)
        assert self.joints is not None
        return (self.joints.message,)

    @property
    def tool(self) -> Array:
        """The tool (n, 6) where the arm is, angles from the start: where the loop's joints put it, else x.

        Also x where poses are counted from other frames in the course of the run.
        """
        if self.loop is None or frames_change(self.opened.task):
            return self.x
        X = self.opened.robot.forward(self.loop.q) @ self.opened.task.X_FT
        turned = X[:, :3, :3] @ self.opened.X_start[:3, :3].T
        return np.column_stack([X[:, :3, 3], angles_near(turned, self.x[:, 3:])])

    @cached_property
    def touch(self) -> dict[str, Any] | None:
        """The contact as plain data, None where the tool touched nothing.

        Excursions are how far the tool, where the arm is, was from the equilibrium along each axis while it touched,
        its lag included; the controller's are those of its own pose.
        """
        if self.loop is None or not np.any(self.loop.depth > 0):
            return None
        t, rows = self.t, np.flatnonzero(self.loop.depth > 0)
        force = np.linalg.norm(self.loop.contact_true[:, :3], axis=1)
        away, own = (np.abs(pose - self.x_e)[rows, :3].max(axis=0).tolist() for pose in (self.tool, self.x))
        strongest, deepest = (int(np.argmax(values)) for values in (force, self.loop.depth))
        return {
            "first_s": float(t[rows[0]]),
            "last_s": float(t[rows[-1]]),
            "in_contact_s": len(rows) * self.opened.equilibrium.h,
            "largest_force_N": float(force[strongest]),
            "largest_force_at_s": float(t[strongest]),
            "largest_per_axis_N": np.abs(self.loop.contact_true[:, :3]).max(axis=0).tolist(),
            "deepest_m": float(self.loop.depth[deepest]),
            "deepest_at_s": float(t[deepest]),
            "largest_excursion_per_axis_m": away,
            "controllers_excursion_per_axis_m": own,
        }

    @cached_property
    def pressed(self) -> Array | None:
        """How hard the tool presses (n,) [N] as the task asks; None where it asks for nothing, or nothing is there."""
        if self.loop is None or self.pressing is None or self.contact is None:
            return None
        path = self.opened.plan or self.opened.equilibrium
        return force_along(self.pressing, path, self.tool[:, :3], self.loop.contact_true[:, :3])

    @cached_property
    def forces(self) -> list[dict[str, Any]]:
        """The same by piece, as force.force_records."""
        if self.pressing is None or self.pressed is None:
            return []
        return force_records(self.pressing, self.opened.equilibrium.h, self.pressed)

    @property
    def q(self) -> Array | None:
        """The arm's joints (n, 7) [rad], None where it cannot follow."""
        if self.loop is not None:
            return self.loop.q
        return self.joints.trajectory.q if isinstance(self.joints, Followed) else None

    @property
    def on_plan(self) -> bool:
        """Whether lag is counted from plan.csv."""
        return self.opened.plan is not None and not frames_change(self.opened.task)

    @property
    def most_push(self) -> float:
        """The largest force [N] the tool would begin to push with if it were blocked."""
        return float(np.linalg.norm(self.push, axis=1).max())

    @property
    def spring(self) -> Array:
        """K (x - x_e) (n, 3) [N]: the stiffness' pull, with which the tool pushes what holds it."""
        return np.asarray(diagonal(self.opened.task, "K", self.t) * (self.x - self.x_e)[:, :3], dtype=np.float64)

    @property
    def push(self) -> Array:
        """K (x_e - x), + D v_e where the speed is fed (n, 3) [N]: with what the tool would begin to push if held."""
        if self.feed is Feed.POSITION:
            return -self.spring
        rates = equilibrium_rates(self.x_e[:, :3], self.opened.equilibrium.h)
        return np.asarray(diagonal(self.opened.task, "D", self.t) * rates - self.spring, dtype=np.float64)


def diagonal(task: Task, name: str, t: Array) -> Array:
    """The position's part of K or D at times t (n,) [s], (n, 3)."""
    out = np.tile(getattr(task.compliance, name)[:3], (len(t), 1))
    for change in task.changes:
        if change.compliance is not None:
            out[t >= change.t - _SOON] = getattr(change.compliance, name)[:3]
    return out


def simulate(
    folder: Path,
    page: Callable[[Simulated], bytes],
    contact_file: Path | None = None,
    engine: str | None = None,
    feed: Feed | None = None,
    integration: Integration | None = None,
    settle: float | None = None,
) -> Simulated | Refused:
    """Run the controller on a folder's sequence and write simulation.csv and report.html into it.

    page: makes report.html. contact_file: what the tool may run into, None for what the task itself says. engine:
    "spring" or "mujoco", None for MuJoCo where it is installed. feed: None for the one the folder was made for. settle
    [s]: how long the last pose is held, None for as long as the controller needs.
    """
    opened = open_folder(folder)
    contact = load_contact(contact_file)[0] if contact_file is not None else opened.task.contact
    place = str(contact_file or opened.task.file)
    answer = run_controller(opened, contact, engine, feed, integration, settle, place)
    if isinstance(answer, Simulated):
        files = {SIMULATION: simulation_csv(answer).encode(), REPORT: page(answer)}
        record = simulation_record(answer) | {"contact_file": None if contact_file is None else contact_file.name}
        add_to_folder(answer.opened, files, {"simulation": record})
    return answer


def run_controller(
    opened: Opened,
    contact: Contact | None,
    engine: str | None,
    feed: Feed | None,
    integration: Integration | None,
    settle: float | None,
    place: str | None = None,
) -> Simulated | Refused:
    """As simulate, on a sequence at hand; nothing is written.

    contact: what the tool may run into. place: the contact's file, for messages.
    """
    task = opened.task if integration is None else replace(opened.task, integration=integration)
    opened = counted_from_start(replace(opened, task=task))
    sequence, feed = opened.equilibrium, feed or opened.feed
    axes = () if task.impedance else stability(task.compliance, sequence.h, task.integration)
    unstable = [axis.sentence for axis in axes if axis.verdict is StabilityVerdict.UNSTABLE]
    for change in task.changes:
        if change.compliance is not None:
            changed = stability(change.compliance, sequence.h, task.integration)
            axes += tuple(replace(axis, since=change.t) for axis in changed)
            bad = (axis for axis in changed if axis.verdict is StabilityVerdict.UNSTABLE)
            unstable += [f"with the change at {change.t:g} s {axis.sentence}" for axis in bad]
    if unstable:
        return _no_run(unstable)
    if settle is None:
        slowest = [axis.slowest for axis in axes if np.isfinite(axis.slowest) and axis.k > 0]
        # a round time, so that runs whose laws differ by rounding end together
        settle = min(_LONGEST_SETTLING, ceil(80 * max(slowest, default=0.25 if task.impedance else 0.0)) / 10)
    asked = pressing(task, opened.plan or sequence, opened.X_start[:3, :3])
    wrench = None if asked is None or not task.wrench else asked.wrench
    if contact is not None:
        contact = replace(contact, body=task.tool)
        try:
            check_start(opened.robot, task.start_joints, task.X_FT, contact)
        except ValueError as error:
            raise InputError(f"contact: {error}", file=place) from error
    why = _loop_needed(task, contact, engine)
    if task.impedance and engine == Engine.SPRING.value:
        raise InputError("--engine spring: an impedance controller moves an arm with masses; only mujoco has them")
    fallback = bool(why) and engine is None and not task.impedance and not mujoco_world.available()
    links: tuple[LinkContact, ...] = ()
    motors: tuple[Motor, ...] = ()
    if why:
        chosen = Engine(engine) if engine is not None else Engine.SPRING if fallback else Engine.MUJOCO
        loop, world = _loop(opened, contact, chosen, feed, settle, place, wrench)
        links, motors = world.link_contacts, world.motors
        if len(loop.x) == 0:
            assert loop.stop is not None
            return _no_run([loop.stop.message])
        x_e, x, R, force, joints = loop.x_e, loop.x, loop.R, loop.force_believed, None
    else:
        loop = None
        x_e, x, R, force = _law_alone(opened, feed, settle, wrench)
        joints = _joints(opened, x, R @ opened.X_start[:3, :3].T)
    plan, target = opened.plan, x_e
    if plan is not None and not frames_change(task):
        target = plan.pose[np.minimum(np.arange(len(x_e)), len(plan.pose) - 1)]
    if sequence.rotation is RotationLaw.SLERP and not frames_change(task):
        x = np.column_stack([x[:, :3], angles_near(R @ opened.X_start[:3, :3].T, x_e[:, 3:])])
    lag = worst_lag(x, target, sequence.h, sequence.pieces)
    of_world = loop, contact, feed, settle, why, fallback, links, motors, asked
    return Simulated(opened, x_e, x, target, force, lag, axes, joints, *of_world)


def frames_change(task: Task) -> bool:
    """Whether poses are counted from other frames in the course of the run."""
    return any(change.reframes for change in task.changes)


def clamped(task: Task) -> bool:
    """Whether torques or forces are clamped."""
    return bool(np.isfinite(task.clamps.torque).any() or np.isfinite(task.clamps.force).any())


def simulation_csv(run: Simulated) -> str:
    """simulation.csv: equilibrium, controller, deviation, forces, joints; what a world adds comes last."""
    heads = ["t [s]"]
    heads += [f"{name}_e [{unit}]" for name, unit in zip(COORDINATES, UNITS, strict=True)]
    heads += [f"{name} [{unit}]" for name, unit in zip(COORDINATES, UNITS, strict=True)]
    heads += ["deviation [m]", *(f"believed {name}" for name in _FORCES)]
    columns = [run.t[:, None], run.x_e, run.x, deviation(run.x, run.target)[:, None], run.force]
    names = run.opened.robot.axis_names
    if run.loop is not None:
        heads += [f"{name} command [rad]" for name in names] + [f"{name} [rad]" for name in names]
        heads += [f"true {name}" for name in _FORCES] + ["depth [m]"]
        columns += [run.loop.q_command, run.loop.q, run.loop.contact_true, run.loop.depth[:, None]]
    elif run.q is not None:
        heads += [f"{name} [rad]" for name in names]
        columns += [run.q]
    if run.q is not None:
        heads += ["manipulability [m3]"]
        columns += [run.opened.robot.manipulability(run.q)[:, None]]
    table = np.hstack(columns)
    row = ",".join(["%.10g"] * table.shape[1])  # finer than any model here is true
    return "\n".join([",".join(heads), *(row % tuple(values) for values in table.tolist())]) + "\n"


def simulation_record(run: Simulated) -> dict[str, Any]:
    """What summary.json says of a run."""
    record: dict[str, Any] = {
        "feed": run.feed.value,
        "integration": run.opened.task.integration.value,
        "controller": "admittance" if run.opened.task.impedance is None else "impedance",
        "duration_s": float(run.t[-1]),
        "held_s": run.settle,
        "loop_run_for": list(run.why),
        "lag": lag_record(run.lag),
        "largest_spring_force_N": float(np.linalg.norm(run.spring, axis=1).max()),
        "largest_push_N": run.most_push,
        "stability": [
            {
                "axis": axis.axis,
                "from_s": axis.since,
                "verdict": axis.verdict.name.lower(),
                "largest_period_s": _finite(axis.h_max),
                "damping_ratio": _finite(axis.damping_ratio),
                "slowest_time_constant_s": _finite(axis.slowest),
            }
            for axis in run.axes
        ],
    }
    if isinstance(run.joints, Followed):
        record["joints"] = joint_record(run.joints)
    elif isinstance(run.joints, Unfollowable):
        record["joints"] = {"unfollowable": run.joints.message}
    if run.loop is not None:
        record["world"] = run.loop.world
        record["contact"] = run.touch
        record["forces"] = run.forces
        for name, keys, rows in (("links_in_obstacles", _LINK, run.links), ("motors", _MOTOR, run.motors)):
            record[name] = [dict(zip(keys, astuple(one), strict=True)) for one in rows]
        record["stopped"] = None if run.loop.stop is None else run.loop.stop.message
    return record


def lag_record(lag: Lag) -> dict[str, Any]:
    """A lag as plain data."""
    return {
        "largest_m": lag.maximum,
        "time_s": lag.time,
        "from": lag.piece.origin if lag.piece else None,
        "to": lag.piece.goal if lag.piece else None,
        "mean_m": lag.mean,
        "largest_turn_rad": lag.turn_maximum,
        "turn_time_s": lag.turn_time,
    }


def _no_run(sentences: Sequence[str]) -> Refused:
    """An unstable law, or a loop that stops before its first period."""
    return Refused("no run", [*sentences, "NOTHING WRITTEN: the controller cannot run"])


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _loop_needed(task: Task, contact: Contact | None, engine: str | None) -> tuple[str, ...]:
    """What happens that the law alone cannot tell; empty where nothing does."""
    asked = {
        "contact": contact is not None,
        "sensor errors": task.sensor is not None,
        "clamps": clamped(task),
        "changes": any(one.reframes or one.zeroing is not None or one.clamps is not None for one in task.changes),
        "the impedance controller": task.impedance is not None,
        "--engine": engine is not None,
    }
    return tuple(name for name, wanted in asked.items() if wanted)


def _loop(
    opened: Opened,
    contact: Contact | None,
    engine: Engine,
    feed: Feed,
    settle: float,
    place: str | None,
    wrench: Array | None,
) -> tuple[LoopRun, World]:
    task, sequence, settings = opened.task, opened.equilibrium, Settings.of(opened.task, feed)
    body, q_0 = (opened.robot, task.X_FT, task.load, contact, sequence.h), seven(task.start_joints)
    controller: Controller | ImpedanceController
    try:
        if task.impedance is None:
            world, controller = make_world(engine, *body), Controller(opened.robot, settings, q_0)
        else:
            world = mujoco_world.TorqueWorld(*body, task.pushes)
            controller = ImpedanceController(opened.robot, settings, q_0, task.impedance)
    except ValueError as error:
        raise InputError(str(error), file=place) from error
    R_e = sequence.rotations(opened.X_start[:3, :3])
    limits = opened.robot.profile(task.limits)
    return run(controller, sequence.pose, world, limits, R_e=R_e, wrench=wrench, settle=settle), world


def _law_alone(opened: Opened, feed: Feed, settle: float, wrench: Array | None) -> tuple[Array, Array, Array, Array]:
    """Equilibrium x_e, controller x (n, 6) with its R (n, 3, 3) in the world, and the forces pushed with (n, 6).

    The controller is switched on at rest in the pose of the start, wherever the sequence begins.
    """
    task, sequence, R_start = opened.task, opened.equilibrium, opened.X_start[:3, :3]
    h, law = sequence.h, task.compliance
    x_e = held(sequence.pose, settle, h)
    t = np.arange(len(x_e)) * h
    force = np.zeros_like(x_e)
    for push in task.pushes:
        force += push.at(t)
    if task.zeroing != Zeroing():
        force = zero(force, task.zeroing)
    told = force if wrench is None else force + held(wrench, settle, h)
    start = np.r_[opened.X_start[:3, 3], np.zeros(3)]  # angles count from there
    changes = [(held_rows(one.t - _SOON, h), one.compliance) for one in task.changes if one.compliance is not None]
    changes = [(row, one) for row, one in changes if row < len(x_e)]
    # in the world, whose axes the stiffness has
    R_e = held(sequence.R, settle, h) @ R_start if sequence.rotation is RotationLaw.SLERP else None
    found = response(
        *(x_e, h, law), R_e=R_e, integration=task.integration, feed=feed, force=told, x_0=start, R_0=R_start,
        changes=changes,
    )  # fmt: skip
    return x_e, found.x, rotation(found.x[:, 3:]) @ R_start if found.R is None else found.R, force


def _joints(opened: Opened, x: Array, R: Array) -> Followed | Unfollowable:
    """The joints of an arm that follows the controller exactly."""
    sequence = opened.equilibrium
    last = sequence.pieces[-1]
    pieces = (*sequence.pieces, Piece(last.last, len(x) - 1, last.goal, last.goal, dwell=True))
    path = Equilibrium(sequence.h, x, R, sequence.rotation, AngleMeaning.RELATIVE, pieces)
    return opened.follow(path, stops=False)
