"""The whole controller against an ideal world: an arm that follows every command and knows its own torques."""

from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import replace
from typing import ClassVar

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array, pose
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.forces import TorqueErrors, force_of
from trajopt_cli.iiwa.controller.loop import LoopRun, run
from trajopt_cli.iiwa.controller.parameters import Settings, Stop, StopKind
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.task.model import (
    Change,
    Clamps,
    Compliance,
    Feed,
    Integration,
    Push,
    RotationLaw,
    Sensor,
    Zeroing,
)
from trajopt_cli.iiwa.task.world import Measured, Seven
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.srs import SrsRobot, load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle

H = 1e-3
HOME: Seven = tuple(np.radians([0.0, 30, 0, -100, 0, 50, 0]).tolist())
COMPLIANCE = Compliance(
    np.array([1000.0, 800, 1200, 30, 25, 40]),
    np.array([500.0, 400, 300, 20, 15, 25]),
    np.array([25.0, 25, 25, 3, 3, 3]),
)
SETTINGS = Settings(COMPLIANCE, H, ArmAngle.FARIA)
TOOL = pose(Rotation.from_euler("xyz", [10, 20, 30], degrees=True).as_matrix(), [0.02, -0.03, 0.15])
BENT = pose(Rotation.from_euler("y", 40, degrees=True).as_matrix(), [0.1, 0, 0.05])
ELSEWHERE = pose(Rotation.from_euler("z", 60, degrees=True).as_matrix(), [0.5, 0.2, 0])
TILTED = pose(Rotation.from_euler("xz", [30, 60], degrees=True).as_matrix(), [1, 0, 0])
LOAD = ToolLoad(2.0, np.zeros(3), np.diag([0.01, 0.01, 0.01]))
Force = Callable[[int], Array]


class Ideal:
    """Follows every command at once; its speeds are the commands' differences. force: on the TCP, by period."""

    name = "ideal"

    def __init__(
        self, robot: SrsRobot, load: ToolLoad | None = None, force: Force | None = None, X_FT: Array | None = None
    ) -> None:
        self._robot, self._X_FT, self._force = robot, X_FT, force
        self._dynamics = Dynamics(robot, load)

    def reset(self, q: Seven) -> Measured:
        self._k, self._q, self._qd = 0, np.array(q), np.zeros(7)
        return self._measured(np.zeros(7))

    def step(self, q: Seven) -> Measured:
        self._k += 1
        qd = (np.array(q) - self._q) / H
        qdd = (qd - self._qd) / H
        self._q, self._qd = np.array(q), qd
        return self._measured(qdd)

    def _measured(self, qdd: Array) -> Measured:
        F = np.zeros(6) if self._force is None else self._force(self._k)
        tau = self._dynamics.torque(self._q, self._qd, qdd)
        if np.any(F):
            tau = tau - self._robot.jacobian(self._q, self._X_FT).T @ F
        return Measured(tuple(self._q), tuple(self._qd), tuple(qdd), tuple(tau), tuple(F), 0.0)


@pytest.fixture(scope="module")
def robot() -> SrsRobot:
    return load_srs("iiwa7")


def start_row(robot: SrsRobot, X_FT: Array | None = None) -> Array:
    X = robot.forward(np.array(HOME)) @ (np.eye(4) if X_FT is None else X_FT)
    return np.concatenate([X[:3, 3], np.zeros(3)])


def way(robot: SrsRobot, n: int, by: tuple[float, ...], X_FT: Array | None = None) -> Array:
    """A smooth way (n, 6) from the start by so much in every coordinate."""
    s = np.linspace(0, 1, n)
    return start_row(robot, X_FT) + (s * s * (3 - 2 * s))[:, None] * np.array(by)


def go(robot: SrsRobot, settings: Settings, x_e: Array, world: Ideal | None = None, **more: object) -> LoopRun:
    controller = Controller(robot, settings, HOME)
    return run(controller, x_e, world or Ideal(robot), robot.profile(), **more)  # type: ignore[arg-type]


def poses(found: LoopRun, robot: SrsRobot, X_FT: Array) -> Array:
    return np.asarray(robot.forward(found.q_command) @ X_FT)


@pytest.mark.parametrize("integration", Integration)
@pytest.mark.parametrize("feed", Feed)
def test_free_it_is_the_regulator_alone(robot: SrsRobot, integration: Integration, feed: Feed) -> None:
    """No contact, no errors: the response to 1e-9; the joints put the tool there, the arm was measured there."""
    x_e = way(robot, 250, (0.01, 0.02, -0.015, 0.1, -0.08, 0.12), TOOL)
    settings = replace(SETTINGS, X_FT=TOOL, integration=integration, feed=feed)
    found = go(robot, settings, x_e)
    wanted = response(x_e, H, COMPLIANCE, integration=integration, feed=feed)
    assert found.stop is None
    assert np.allclose(found.x, wanted.x, rtol=0, atol=1e-9)
    assert np.allclose(found.v, wanted.v, rtol=0, atol=1e-9)
    assert np.abs(found.x[-1] - found.x[0]).min() > 1e-3
    R_start = (robot.forward(np.array(HOME)) @ TOOL)[:3, :3]
    X = poses(found, robot, TOOL)
    assert np.allclose(X[:, :3, 3], found.x[:, :3], rtol=0, atol=1e-12)
    R = Rotation.from_euler("xyz", found.x[:, 3:]).as_matrix() @ R_start
    assert np.allclose(X[:, :3, :3], R, rtol=0, atol=1e-12)
    assert np.allclose(found.R, R, rtol=0, atol=1e-12)
    assert np.array_equal(found.q, found.q_command)
    assert found.t[-1] == pytest.approx(0.249)
    assert found.world == "ideal"
    assert np.array_equal(found.x_e, x_e)


def test_a_true_force_is_believed_and_followed(robot: SrsRobot) -> None:
    """Tilted base, turned tool, a load that both know: the force at the TCP in world axes, to rounding."""
    tilted = robot.mounted(pose(Rotation.from_euler("xyz", [20, -10, 70], degrees=True).as_matrix(), [0.3, -1, 0.5]))
    forces = np.zeros((200, 6))
    forces[20:150] = [10, -5, 8, 0.6, -0.4, 0.9]
    world = Ideal(tilted, LOAD, lambda k: forces[k], TOOL)
    x_e = np.tile(start_row(tilted, TOOL), (200, 1))
    found = go(tilted, replace(SETTINGS, X_FT=TOOL, load=LOAD), x_e, world)
    assert np.allclose(found.force_believed, forces, rtol=0, atol=1e-8)
    assert np.array_equal(found.contact_true, forces)
    assert np.allclose(found.x, response(x_e, H, COMPLIANCE, force=forces).x, rtol=0, atol=1e-9)


def test_an_unknown_load_is_a_weight(robot: SrsRobot) -> None:
    """2 kg in the flange's middle that the model does not know pull down with m g; K z = -m g in the end."""
    stiff = Compliance(np.full(6, 1000.0), np.full(6, 120.0), np.full(6, 4.0))
    x_e = np.tile(start_row(robot), (900, 1))
    found = go(robot, replace(SETTINGS, compliance=stiff), x_e, Ideal(robot, LOAD))
    assert found.force_believed[0] == pytest.approx([0, 0, -2 * 9.81, 0, 0, 0], abs=1e-9)
    assert found.x[-1, 2] - x_e[0, 2] == pytest.approx(-2 * 9.81 / 1000, abs=2e-4)


def test_a_model_of_gravity_alone_takes_acceleration_for_a_force(robot: SrsRobot) -> None:
    sensor = Sensor(0.0, (), rigid=False)
    x_e = way(robot, 200, (0, 0.03, 0, 0, 0, 0))
    found = go(robot, replace(SETTINGS, sensor=sensor), x_e)
    dynamics = Dynamics(robot)
    qd = np.diff(found.q, axis=0, prepend=found.q[:1]) / H
    qdd = np.diff(qd, axis=0, prepend=qd[:1]) / H
    felt = dynamics.gravity_torque(found.q) - dynamics.torque(found.q, qd, qdd)
    assert np.allclose(found.force_believed, force_of(robot.jacobian(found.q), felt), rtol=0, atol=1e-8)
    assert np.abs(found.force_believed).max() > 0.3
    assert np.abs(go(robot, SETTINGS, x_e).force_believed).max() < 1e-9


def test_torque_errors_pass_for_forces(robot: SrsRobot) -> None:
    sensor = Sensor(seed=3)
    found = go(robot, replace(SETTINGS, sensor=sensor), np.tile(start_row(robot), (60, 1)))
    errors = TorqueErrors(sensor, robot.torque, H).at(np.arange(60))
    assert np.allclose(found.force_believed, force_of(robot.jacobian(found.q), -errors), rtol=0, atol=1e-8)


def test_clamps_before_and_after_the_mapping(robot: SrsRobot) -> None:
    F = np.array([40.0, -30, 20, 3, -2, 1])
    world = Ideal(robot, force=lambda k: F)
    x_e = np.tile(start_row(robot), (2, 1))
    J = robot.jacobian(np.array(HOME))
    bounds = np.full(7, 4.0)
    before = go(robot, replace(SETTINGS, clamps=Clamps(torque=bounds)), x_e, world).force_believed[0]
    assert before == pytest.approx(force_of(J, np.clip(J.T @ F, -4, 4)), abs=1e-8)
    after = go(robot, replace(SETTINGS, clamps=Clamps(force=np.array([5.0, 5, 50, 1, 5, np.inf]))), x_e, world)
    assert after.force_believed[0] == pytest.approx([5, -5, 20, 1, -2, 1], abs=1e-8)


def test_pushes_act_from_their_start_to_their_end_past_the_clamps(robot: SrsRobot) -> None:
    pushes = (Push(0.01, 0.02, np.array([7.0, 0, 0, 0, 0, 0])), Push(0.015, 0.03, np.array([0, 0, 2.0, 0, 0, 0.5])))
    settings = replace(SETTINGS, pushes=pushes, clamps=Clamps(force=np.full(6, 1.0)))
    found = go(robot, settings, np.tile(start_row(robot), (40, 1)))
    wanted = np.zeros((40, 6))
    wanted[10:20, 0] = 7
    wanted[15:30, 2], wanted[15:30, 5] = 2, 0.5
    assert np.allclose(found.force_believed, wanted, rtol=0, atol=1e-9)


def test_zeroing_in_the_thesis_rotated_frame_leaves_one_line(robot: SrsRobot) -> None:
    """alpha* = -45, beta* = -30, gamma* = 0 deg with x and y zeroed: pushed anyhow, it moves along one line."""
    zeroing = Zeroing((True, True, False, False, False, False), np.radians([-45.0, -30, 0]))
    even = Compliance(np.full(6, 500.0), np.full(6, 100.0), np.full(6, 25.0))
    push = Push(0, 1, np.array([15.0, 25, 5, 0, 0, 0]))
    settings = replace(SETTINGS, compliance=even, zeroing=zeroing, pushes=(push,))
    found = go(robot, settings, np.tile(start_row(robot), (300, 1)))
    moved = (found.x - found.x[0])[-1, :3]
    assert np.linalg.norm(moved) > 5e-3
    assert moved / np.linalg.norm(moved) == pytest.approx([-0.354, 0.707, 0.612], abs=5e-4)


def test_changes_hold_from_their_time_on(robot: SrsRobot) -> None:
    """Hand guiding, then stiff again: the response in two pieces; a zeroing and a clamp begin on their row."""
    guided = Compliance(np.array([0.0, 800, 1200, 30, 25, 40]), COMPLIANCE.D, COMPLIANCE.M)
    changes = (
        Change(0.1, compliance=COMPLIANCE),
        Change(0.15, zeroing=Zeroing((True, *(False,) * 5))),
        Change(0.05, clamps=Clamps(force=np.full(6, 6.0))),
    )
    F = np.array([20.0, 9, 0, 0, 0, 0])
    x_e = np.tile(start_row(robot), (200, 1))
    settings = replace(SETTINGS, compliance=guided, changes=changes)
    found = go(robot, settings, x_e, Ideal(robot, force=lambda k: F))
    assert found.stop is None
    believed = found.force_believed[[0, 49, 50, 149, 150, 199], :2]
    assert np.allclose(believed, [[20, 9], [20, 9], [6, 6], [6, 6], [0, 6], [0, 6]], rtol=0, atol=1e-8)
    first = response(x_e[:101], H, guided, force=found.force_believed[:101])
    second = response(x_e[100:], H, COMPLIANCE, force=found.force_believed[100:], x_0=first.x[100], v_0=first.v[100])
    assert np.allclose(found.x, np.vstack([first.x[:100], second.x]), rtol=0, atol=1e-9)


def jumps(found: LoopRun, at: int) -> float:
    """How much the joints' speed changes at a row, against the most elsewhere."""
    kinks = np.abs(np.diff(found.q_command, 2, axis=0)).max(axis=1)
    return float(kinks[at - 3 : at + 2].max() / np.delete(kinks, range(at - 3, at + 2)).max())


@pytest.mark.parametrize("law", RotationLaw)
@pytest.mark.parametrize(
    ("earlier", "change"),
    [
        ((), Change(0.1, restart=True)),
        ((), Change(0.1, X_FT=TOOL)),
        ((), Change(0.1, X_WB=ELSEWHERE)),
        ((), Change(0.1, X_FT=TOOL, X_WB=TILTED, restart=True)),
        ((Change(0.05, X_FT=BENT, X_WB=ELSEWHERE, restart=True),), Change(0.1, X_FT=TOOL, X_WB=TILTED)),
    ],
    ids=["restart", "tool", "base", "all", "twice"],
)
def test_other_frames_move_nothing(
    robot: SrsRobot, law: RotationLaw, earlier: tuple[Change, ...], change: Change
) -> None:
    """In the middle of a motion: the arm's pose to 1e-12, its speed, and what the equilibrium means for the arm."""
    x_e = way(robot, 200, (0.02, 0.02, -0.02, 0.2, -0.1, 0.15))
    R_e = Rotation.from_euler("xyz", x_e[:, 3:]).as_matrix() @ robot.forward(np.array(HOME))[:3, :3]
    settings = replace(SETTINGS, changes=(change, *earlier), rotation=law)
    controller = Controller(robot, settings, HOME)
    found = run(controller, x_e, Ideal(robot), robot.profile(), R_e=R_e)
    assert found.stop is None
    before = run(
        Controller(robot, replace(settings, changes=earlier), HOME), x_e, Ideal(robot), robot.profile(), R_e=R_e
    )
    assert np.array_equal(found.q_command[:101], before.q_command[:101])
    X_FT = np.eye(4) if change.X_FT is None else change.X_FT
    X_WB = np.eye(4) if change.X_WB is None else change.X_WB
    # row 100 stands before its period: the same arm, written in the new frames
    X = X_WB @ robot.forward(before.q_command[100]) @ X_FT
    assert np.allclose(found.R[100], X[:3, :3], rtol=0, atol=1e-12)
    assert np.allclose(found.x[100, :3], X[:3, 3], rtol=0, atol=1e-12)
    R_start = controller.R_start
    angles = Rotation.from_euler("xyz", found.x[100:, 3:]).as_matrix()
    assert np.allclose(angles @ R_start, found.R[100:], rtol=0, atol=1e-12)
    if change.restart:
        assert np.allclose(found.x[100, 3:], 0, rtol=0, atol=1e-13)
        assert np.allclose(R_start, X[:3, :3], rtol=0, atol=1e-12)
    # the planned rows still mean the same place for the arm
    plan = pose(R_e[100:], x_e[100:, :3])
    seen = pose(Rotation.from_euler("xyz", found.x_e[100:, 3:]).as_matrix() @ R_start, found.x_e[100:, :3])
    assert np.allclose(seen, X_WB @ plan @ X_FT, rtol=0, atol=1e-12)
    assert jumps(found, 100) < 1.5
    # rates: of the TCP as it goes on, from the rows' own differences
    ahead = (found.x[101] - found.x[100]) / H
    assert ahead[:3] == pytest.approx(found.v[100, :3], abs=1e-9)
    turn = (Rotation.from_matrix(found.R[101]) * Rotation.from_matrix(found.R[100]).inv()).as_rotvec() / H
    old = (Rotation.from_matrix(before.R[101]) * Rotation.from_matrix(before.R[100]).inv()).as_rotvec() / H
    R_WB_before = np.eye(3) if not earlier else ELSEWHERE[:3, :3]
    assert turn == pytest.approx(X_WB[:3, :3] @ R_WB_before.T @ old, abs=2e-3 * np.linalg.norm(old))


@pytest.mark.parametrize("feed", Feed)
def test_a_restart_changes_nothing_of_a_turn_about_one_axis(robot: SrsRobot, feed: Feed) -> None:
    x_e = way(robot, 300, (0.01, 0, 0, 0, 0, 0.3))
    settings = replace(SETTINGS, feed=feed)
    plain = go(robot, settings, x_e)
    again = go(robot, replace(settings, changes=(Change(0.12, restart=True),)), x_e)
    assert np.allclose(again.q_command, plain.q_command, rtol=0, atol=1e-11)
    assert again.x_e[-1, 5] == pytest.approx(0.3 - plain.x[120, 5], abs=1e-12)


def test_a_restart_keeps_whole_turns_of_the_equilibrium(robot: SrsRobot) -> None:
    """More than half a turn ahead of a soft regulator, the equilibrium goes on pulling the same way, as hard."""
    soft = replace(SETTINGS, compliance=Compliance(np.full(6, 1.0), np.full(6, 40.0), np.full(6, 25.0)))
    x_e = way(robot, 200, (0, 0, 0, 0, 0, 8.0))
    plain = go(robot, soft, x_e)
    again = go(robot, replace(soft, changes=(Change(0.15, restart=True),)), x_e)
    assert x_e[150, 5] > 2 * np.pi
    assert np.allclose(again.q_command, plain.q_command, rtol=0, atol=1e-11)
    assert again.x_e[150:, 5] == pytest.approx(x_e[150:, 5] - plain.x[150, 5], abs=1e-11)


def test_forces_are_seen_from_the_new_tool_and_the_new_world(robot: SrsRobot) -> None:
    """A force at the flange is force and lever's moment at the new TCP; a base turned by 90 deg turns both."""
    turn = pose(Rotation.from_euler("z", 90, degrees=True).as_matrix(), [0.4, 0, 0])
    F = np.array([3.0, 4, 5, 0, 0, 0])
    changes = (Change(0.01, X_FT=TOOL), Change(0.02, X_WB=turn))
    stiff = Compliance(np.full(6, 1e4), np.full(6, 5e3), np.full(6, 25.0))
    x_e = np.tile(start_row(robot), (30, 1))
    world = Ideal(robot, force=lambda k: F)
    found = go(robot, replace(SETTINGS, compliance=stiff, changes=changes), x_e, world)
    for row, X_WB in ((15, np.eye(4)), (25, turn)):
        lever = robot.forward(found.q[row])[:3, :3] @ TOOL[:3, 3]
        wanted = np.concatenate([X_WB[:3, :3] @ F[:3], X_WB[:3, :3] @ np.cross(-lever, F[:3])])
        assert found.force_believed[row] == pytest.approx(wanted, abs=1e-8)


def test_settling_holds_the_last_row(robot: SrsRobot) -> None:
    x_e = way(robot, 50, (0.01, 0, 0, 0, 0, 0))
    found = go(robot, SETTINGS, x_e, settle=0.03)
    assert len(found.t) == 80
    assert np.array_equal(found.x_e[50:], np.tile(x_e[-1], (30, 1)))
    assert np.allclose(found.x, response(np.vstack([x_e, found.x_e[50:]]), H, COMPLIANCE).x, rtol=0, atol=1e-9)


def stopped(robot: SrsRobot, settings: Settings, x_e: Array, world: Ideal | None = None) -> tuple[LoopRun, Stop]:
    found = go(robot, settings, x_e, world)
    assert found.stop is not None
    return found, found.stop


QUICK = Compliance(np.full(6, 2000.0), np.full(6, 500.0), np.full(6, 5.0))


def test_a_joint_too_fast_stops_the_loop(robot: SrsRobot) -> None:
    x_e = np.tile(start_row(robot), (400, 1))
    x_e[50:, 1] += 0.5
    found, stop = stopped(robot, replace(SETTINGS, compliance=QUICK), x_e)
    limits = robot.profile()
    i = limits.names.index(stop.subject)
    assert stop.kind is StopKind.SPEED
    assert stop.limit == limits.velocity[i]
    assert stop.value > stop.limit
    assert stop.time == pytest.approx(len(found.t) * H)
    assert "would turn at" in stop.message
    assert stop.message.startswith(f"at {stop.time:.3f} s {stop.subject}")
    # what was sent was legal
    assert np.all(np.abs(np.diff(found.q_command, axis=0)) / H <= limits.velocity * (1 + 1e-9))


def test_a_joint_out_of_range_stops_the_loop(robot: SrsRobot) -> None:
    """Turned about the tool: joint 7 passes its 175 deg at the speed it may have."""
    n = 1500
    x_e = np.tile(start_row(robot), (n, 1))
    settings = replace(SETTINGS, rotation=RotationLaw.SLERP, feed=Feed.VELOCITY)
    R_0 = robot.forward(np.array(HOME))[:3, :3]
    angle = np.linspace(0, np.radians(200), n)
    R_e = R_0 @ Rotation.from_rotvec(angle[:, None] * [0, 0, 1]).as_matrix()
    found = go(robot, settings, x_e, R_e=R_e)
    assert found.stop is not None
    assert found.stop.kind is StopKind.POSITION
    assert found.stop.subject == robot.axis_names[6]
    assert found.stop.limit == pytest.approx(np.radians(175))
    assert found.stop.value == pytest.approx(np.radians(175), abs=2e-3)
    assert "joint_7 would go to 175.0" in found.stop.message
    assert found.q_command[-1, 6] <= np.radians(175)


def test_out_of_reach_stops_the_loop(robot: SrsRobot) -> None:
    x_e = way(robot, 2000, (0.6, 0, 0, 0, 0, 0))
    found, stop = stopped(robot, replace(SETTINGS, compliance=QUICK), x_e)
    assert stop.kind in (StopKind.UNREACHABLE, StopKind.SPEED)  # the elbow stretches ever faster
    assert found.x[-1, 0] > x_e[0, 0]
    leap = np.tile(start_row(robot), (5, 1))
    leap[:, 0] += 3e6
    _, stop = stopped(robot, SETTINGS, leap)
    assert stop.kind is StopKind.UNREACHABLE
    assert stop.value > stop.limit == pytest.approx(0.8)
    assert "is out of reach: its wrist centre is" in stop.message
    assert stop.time == pytest.approx(2 * H)


def test_the_lock_stops_the_angles_and_not_slerp(robot: SrsRobot) -> None:
    """beta at the regulator beyond 85 deg: the tool turns about the wrist's centre, joint 6 alone."""
    q_0: Seven = tuple(np.radians([0.0, 30, 0, -100, 0, 20, 0]).tolist())
    X_FT = pose(np.eye(3), [0, 0, -robot.lengths.wf])
    X = robot.forward(np.array(q_0)) @ X_FT
    s = np.linspace(0, 1, 1000)
    x_e = np.tile([*X[:3, 3], 0, 0, 0], (1000, 1))
    x_e[:, 4] = s * s * (3 - 2 * s) * np.radians(89)
    R_e = Rotation.from_euler("xyz", x_e[:, 3:]).as_matrix() @ X[:3, :3]
    by_angles, free = (
        run(
            Controller(robot, replace(SETTINGS, X_FT=X_FT, feed=Feed.VELOCITY, rotation=law), q_0),
            x_e,
            Ideal(robot),
            robot.profile(),
            R_e=R_e,
        )
        for law in RotationLaw
    )
    stop = by_angles.stop
    assert stop is not None
    assert stop.kind is StopKind.BETA
    assert stop.value > stop.limit == pytest.approx(np.radians(85))
    assert len(by_angles.t) * H == pytest.approx(stop.time)
    assert np.abs(by_angles.x[:, 4]).max() <= np.radians(85)
    assert "limit ±85°" in stop.message
    assert free.stop is None
    assert free.x[:, 4].max() > stop.value


@pytest.mark.parametrize("feed", Feed)
def test_slerp_free_is_its_regulator_alone(robot: SrsRobot, feed: Feed) -> None:
    x_e = way(robot, 250, (0.01, 0.02, -0.015, 0, 0, 0))
    R_0 = robot.forward(np.array(HOME))[:3, :3]
    R_e = Rotation.from_rotvec(np.linspace(0, 0.3, 250)[:, None] * np.array([0.6, 0, 0.8])).as_matrix() @ R_0
    forces = np.zeros((250, 6))
    forces[30:80, 3:] = [0.5, -0.3, 0.2]
    settings = replace(SETTINGS, rotation=RotationLaw.SLERP, feed=feed)
    found = go(robot, settings, x_e, Ideal(robot, force=lambda k: forces[k]), R_e=R_e)
    C = COMPLIANCE
    wanted = response(x_e, H, C, R_e=R_e, force=forces, feed=feed)
    assert np.allclose(found.R, wanted.R, rtol=0, atol=1e-9)
    assert np.allclose(found.v, wanted.v, rtol=0, atol=1e-9)
    assert np.allclose(found.x[:, :3], response(x_e, H, C, feed=feed).x[:, :3], rtol=0, atol=1e-9)
    assert np.allclose(poses(found, robot, np.eye(4))[:, :3, :3], found.R, rtol=0, atol=1e-12)


def test_a_singular_arm_and_torques_that_are_none_stop_the_loop(robot: SrsRobot) -> None:
    stretched = (0.3, 0.4, 0.1, 0.0, 0.2, 0.0, 0.1)
    X = robot.forward(np.array(stretched))
    x_e = np.tile([*X[:3, 3], 0, 0, 0], (3, 1))
    found = run(Controller(robot, SETTINGS, stretched), x_e, Ideal(robot), robot.profile())
    assert found.stop is not None
    assert found.stop.kind is StopKind.SINGULAR
    assert found.stop.value < found.stop.limit
    assert len(found.t) == 0
    world = Ideal(robot, force=lambda k: np.full(6, np.nan if k == 3 else 0.0))
    found, stop = stopped(robot, SETTINGS, np.tile(start_row(robot), (9, 1)), world)
    assert stop.kind is StopKind.TORQUE
    assert len(found.t) == 3
    assert stop.time == pytest.approx(3 * H)


def test_an_arm_angle_of_its_own_is_held_and_the_starts_otherwise(robot: SrsRobot) -> None:
    x_e = way(robot, 60, (0.01, 0, 0, 0, 0, 0))
    given = replace(SETTINGS, arm_angle=Controller(robot, SETTINGS, HOME).arm_angle)
    assert np.array_equal(go(robot, given, x_e).q_command, go(robot, SETTINGS, x_e).q_command)
    other = go(robot, replace(SETTINGS, arm_angle=0.5 + Controller(robot, SETTINGS, HOME).arm_angle), x_e)
    assert other.stop is not None
    assert other.stop.kind is StopKind.SPEED  # the elbow is not there


def test_every_period_is_timed(robot: SrsRobot) -> None:
    found = go(robot, SETTINGS, way(robot, 50, (0.01, 0, 0, 0, 0, 0)))
    assert found.step_times.shape == (49, 5)
    assert np.all(found.step_times > 0)
    assert found.step_times[:, :4].sum(axis=1) == pytest.approx(found.step_times[:, 4], rel=1e-6)


def test_no_period_loads_compiled_loops(robot: SrsRobot, monkeypatch: pytest.MonkeyPatch) -> None:
    controller = Controller(robot, SETTINGS, HOME)
    monkeypatch.setattr("trajopt_cli.native.loops.loops", None)
    found = run(controller, way(robot, 5, (0.001, 0, 0, 0, 0, 0)), Ideal(robot), robot.profile())
    assert found.stop is None


@pytest.mark.parametrize("collecting", [True, False])
def test_nothing_is_collected_during_a_run_and_the_collector_is_as_before_afterwards(
    robot: SrsRobot, collecting: bool
) -> None:
    class Watching(Ideal):
        collects: ClassVar[list[bool]] = []

        def step(self, q: Seven) -> Measured:
            self.collects.append(gc.isenabled())
            if len(self.collects) > 3:
                raise RuntimeError("the arm broke")
            return super().step(q)

    thresholds, frozen = gc.get_threshold(), gc.get_freeze_count()
    if not collecting:
        gc.disable()
    try:
        with pytest.raises(RuntimeError, match="broke"):
            go(robot, SETTINGS, way(robot, 10, (0.001, 0, 0, 0, 0, 0)), Watching(robot))
        assert gc.isenabled() is collecting
    finally:
        gc.enable()
    assert gc.get_threshold() == thresholds
    assert gc.get_freeze_count() <= frozen  # something frozen by an earlier test may have been released meanwhile
    assert Watching.collects == [False] * 4
