"""Plans that keep torque limits: the judge's word, a closed form, posture, rows of the program against pin."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import degrees, sqrt

import numpy as np
import pytest
from heavy_cells import START, first_axis_inertia, heavy
from small_cells import problem_of, rapid
from unrefined import set_defaults

from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import Program
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.path_timing.path_timing import PathMargins, in_force
from trajopt_cli.path_timing.sampled_path import sample_path
from trajopt_cli.plan import optimize
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.report.over_time import joints
from trajopt_cli.robot.dynamics import GRAVITY, Dynamics, ToolLoad
from trajopt_cli.robot.symbolic_dynamics import load_parameters
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.joint_torque import JointTorque, of_room
from trajopt_cli.trajectories.plan_series import follow, torques_along
from trajopt_cli.trajectory import hermite

pytestmark = pytest.mark.usefixtures("coarse")

GRIP = "PERS tooldata grip:=[TRUE,[[0,0,120],[1,0,0,0]],[2.5,[10,0,60],[1,0,0,0],0.01,0.01,0.005]];\n"
DATA = f"""{GRIP}CONST robtarget p_a:=[[600,-150,500],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_b:=[[600,150,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_c:=[[500,150,650],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
BODY = """ConfJ \\Off;
ConfL \\Off;
MoveJ p_a, vmax, fine, grip;
MoveL p_b, vmax, z50, grip;
MoveL p_c, vmax, fine, grip;"""


def used(plant: Plant, plan: Plan, load: ToolLoad | None) -> np.ndarray:
    """The greatest share of each torque limit, at both ends of every interval between rows and in its middle."""
    t = plan.trajectory.t
    q, qd, qdd = hermite(plan.trajectory, np.r_[t[:-1] + 1e-12, (t[1:] + t[:-1]) / 2, t[1:] - 1e-12])
    tau = Dynamics(plant.robot, load, rotor=plant.robot.rotor).torque(q, qd, qdd)
    return np.abs(tau).max(axis=0) / plant.limits.torque


def planned(program: Program, plant: Plant, target: Target, **more: object) -> Plan:
    plan = optimize(program, plant, target, bounded=False, **more)  # type: ignore[arg-type]
    assert isinstance(plan, Plan), plan
    return plan


@cache
def with_and_without(target: Target) -> tuple[Plan, Plan]:
    """The plan that keeps torque limits, and the one that need not."""
    with_them, without = (planned(rapid(BODY, data=DATA), heavy(binds=binds), target) for binds in (True, False))
    return with_them, without


@pytest.mark.parametrize("target", Target)
def test_lines_corners_and_joint_moves_keep_their_torques_and_use_them(target: Target) -> None:
    program, plant = rapid(BODY, data=DATA), heavy()
    plan, free = with_and_without(target)
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [finding.message for finding in report.findings if not finding.passed]
    load = ToolLoad(2.5, np.array([0.01, 0, 0.06]), np.diag([0.01, 0.01, 0.005]))
    assert 0.9995 < used(plant, plan, load).max() < 1 + 1e-6
    assert used(plant, free, load).max() > 1.3
    failed = [f for f in verify(program, plant, free.trajectory, target=target, advice=False).findings if not f.passed]
    assert {f.check for f in failed} == {"joint torque"}
    assert free.duration * 1.03 < plan.duration
    assert any(motion.binding.endswith(" torque") for motion in plan.motions)


@pytest.mark.long
def test_the_picture_of_the_axes_has_their_torques() -> None:
    program, plant, (plan, without) = rapid(BODY, data=DATA), heavy(), with_and_without(Target.RAPID)
    path = follow(program, plant, plan, "t")
    load = ToolLoad(2.5, np.array([0.01, 0, 0.06]), np.diag([0.01, 0.01, 0.005]))
    tau = torques_along(path)
    i = len(path.t) // 2
    wanted = Dynamics(plant.robot, load, rotor=plant.robot.rotor).torque(path.q[i], path.qd[i], path.qdd[i])
    np.testing.assert_allclose(tau[i], wanted, rtol=1e-12)
    panels = joints(path).axes
    assert [panel.get_title() for panel in panels[:4]] == ["position", "speed", "acceleration", "torque"]
    assert "±260, peak 100 %" in [text.get_text() for text in panels[7].texts]
    assert len(joints(follow(program, heavy(binds=False), without, "t")).axes) == 18


def to(q: np.ndarray, tool: str = "tool0", data: str = "") -> Program:
    text = ",".join(f"{degrees(v):.15g}" for v in q)
    joints = f"CONST jointtarget j_end:=[[{text}],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    return rapid(f"MoveAbsJ j_end, v7000, fine, {tool};", data=data + joints)


def test_a_swing_about_the_vertical_is_inertia_times_acceleration_and_a_folding_arm_is_faster() -> None:
    """RAPID drives the first axis alone: a bang-bang of torque over inertia. A stream may fold the arm on the way."""
    plant = heavy(times=np.array([0.35, 3, 3, 1, 1, 1]), free_speed=True)
    slowed_to = np.array([0, 0.9, -0.6, 0, 0.5, 0])
    plant = replace(plant, start=slowed_to)
    way = 0.5
    program = to(slowed_to + np.eye(6)[0] * way)
    a = plant.limits.torque[0] / first_axis_inertia(plant, slowed_to)
    assert 2 * sqrt(way / a) * a / 2 < plant.limits.velocity[0]
    asked = replace(plant, tcp=TcpCaps(np.inf, np.inf))  # nothing of the tool: the judge's caps are too high to bind
    rapid_plan, stream = (planned(program, asked, target) for target in (Target.RAPID, Target.STREAM))
    assert rapid_plan.duration == pytest.approx(2 * sqrt(way / a), rel=2e-4)
    assert np.abs(rapid_plan.trajectory.q[:, 1:] - slowed_to[1:]).max() < 1e-6
    assert stream.duration < 0.99 * rapid_plan.duration
    assert np.abs(stream.trajectory.q[:, 2] - slowed_to[2]).max() > 0.1
    assert verify(program, plant, stream.trajectory, advice=False).legal


def test_too_heavy_a_tool_is_an_answer() -> None:
    data = GRIP.replace("[2.5,", "[95,")
    answer = optimize(to(START + 0.1, "grip", data), heavy(), Target.RAPID)
    assert isinstance(answer, Infeasible)
    assert "cannot be driven: joint_" in answer.message
    assert "cannot hold the arm, " in answer.message
    above = rapid("ConfJ \\Off;\nMoveJ p_a, vmax, fine, grip;", data=DATA.replace("[2.5,", "[95,"))
    weak = heavy(times=np.array([1, 9, 1, 1, 1, 1]))
    answer = optimize(above, weak, Target.RAPID)
    assert isinstance(answer, Infeasible)
    assert "MoveJ p_a cannot be driven: joint_" in answer.message


def test_a_posture_that_the_drives_cannot_hold_is_not_chosen() -> None:
    """The fastest way to the point ends with the forearm level, 32 Nm at joint 3; a drive of 19.5 Nm holds another."""
    data = "CONST robtarget p_x:=[[450,0,700],[0.5,0.5,0.5,0.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    program, start = rapid("ConfJ \\Off;\nMoveJ p_x, vmax, fine, tool0;", data=data), np.array([0, 0, -1.5, 0, 0.5, 0])
    for times, held in ((1.0, 32.0), (0.15, 7.5)):
        plant = heavy(times=np.array([1, 1, times, 1, 1, 1]), start=start)
        plan = planned(program, plant, Target.RAPID)
        end = Dynamics(plant.robot).gravity_torque(plan.trajectory.q[-1])
        assert abs(end[2]) == pytest.approx(held, abs=0.2)
        assert verify(program, plant, plan.trajectory, advice=False).legal


@pytest.mark.parametrize("sides", ["l", "lr"])
def test_rows_at_a_node_are_pins_torques(sides: str) -> None:
    """moving / (T^2 share limit) + gravity / limit: 1 where what gravity leaves is used up to the share."""
    axes, rng = Axes.of(heavy()), np.random.default_rng(5)
    torque = JointTorque(axes)
    load = ToolLoad(3.0, np.array([0.1, 0.02, 0.05]), np.diag([0.02, 0.03, 0.04]))
    q, v, a = rng.uniform(-1, 1, (3, 6))
    T, share, limit = 0.7, rng.uniform(0.5, 1, 6), torque.limit
    z = {"q": q, "v": v, **{f"a_{side}": a * (1 + i) for i, side in enumerate(sides)}, "T": T}
    node = Formulation(axes).limit_node(torque, torque.limited, "joints", sides)
    rows = node.value(z, {"load": load_parameters(load), "limit": limit, "share": share})
    standing = Dynamics(axes.robot, load, GRAVITY, axes.plant.robot.rotor)
    rest = standing.gravity_torque(q)
    wanted = []
    for i in range(len(sides)):
        moving = standing.torque(q, v / T, a * (1 + i) / T**2) - rest
        wanted.append(moving / (share * limit) + rest / limit)
    np.testing.assert_allclose(rows, np.ravel(wanted), rtol=1e-9, atol=1e-12)


def test_columns_of_a_course_are_pins_torques() -> None:
    """At the ends of an interval driven with u and x, gravity in the rest; a share is of what gravity leaves."""
    plant, end = heavy(), START + np.array([0.5, 0.4, -0.6, 0.3, 0.2, 0.1])
    axes, problem = Axes.of(plant), problem_of(to(end), plant)
    path = sample_path(axes, problem, (0, 1), np.array([START, end]), (-1, -1), 12)
    assert path is not None
    margins = PathMargins.full(axes, 12)
    margins.by_name["torque"][:] = 0.8
    _, *rows = in_force(axes, problem, path, margins)
    dynamics, u, x = Dynamics(plant.robot, rotor=plant.robot.rotor), -1.7, 0.6
    for (slopes, bends, rests), at in zip(rows, (path.first, path.first + 1), strict=True):
        q, dq, ddq = (getattr(path.along, name)[at] for name in ("q", "dq", "ddq"))
        tau, still = dynamics.torque(q, dq * sqrt(x), dq * u + ddq * x), dynamics.gravity_torque(q)
        wanted = ((tau - still) / 0.8 + still) / plant.limits.torque
        np.testing.assert_allclose((slopes * u + bends * x + rests)[:, -6:], wanted, rtol=1e-9, atol=1e-12)
        assert not rests[:, :-6].any()


def test_the_measure_of_a_torque_is_what_gravity_leaves() -> None:
    moving, rest = np.array([0.4, -0.4, 1.2, 0.0]), np.array([0.6, 0.6, -0.2, 1.0])
    np.testing.assert_allclose(of_room(moving, rest), [1.0, 0.25, 1.0, 2.0])


def test_a_given_time_and_limited_jerk_keep_torques_too(monkeypatch: pytest.MonkeyPatch) -> None:
    set_defaults(monkeypatch, effort_rounds=1)  # how gentle it is does not matter
    program, plant = rapid(BODY, data=DATA), heavy()
    slow = planned(program, plant, Target.RAPID, objective=LeastEffort(1.4))
    assert slow.duration == pytest.approx(1.4)
    assert verify(program, plant, slow.trajectory, advice=False).legal
    smooth = replace(plant, limits=replace(plant.limits, jerk_binds=True))
    alone = to(START + 0.6 * np.eye(6)[0] + 0.4 * np.eye(6)[1])
    plan = planned(alone, smooth, Target.RAPID)
    assert verify(alone, smooth, plan.trajectory, advice=False).legal
    assert used(smooth, plan, None).max() > 0.9
