"""Row bang-bang: its axes keep the generator's limits, its times are Ruckig's, lines stay lines, the judge says no."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from ruckig import InputParameter, Ruckig, Trajectory
from timed_rows import attempt, broken, case_of, plant_with_rail, rapid

from trajopt_cli.geometry import Array, axis_angle
from trajopt_cli.problem.plan import Infeasible, Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.study.cartesian import bang_bang_row
from trajopt_cli.study.case import Answer, Attempt, Case

pytestmark = pytest.mark.usefixtures("coarse")

PROGRAMS = ["hinge_cell", "bench_irb140", "everything_once"]


def from_carriage(plant: Plant, made: Attempt) -> tuple[Array, Array]:
    """TCP velocity (n, 3) as seen from the carriage at all rows, by the Jacobian, and times (n,)."""
    q, qd = made.trajectory.q, made.trajectory.qd
    assert qd is not None
    arm = np.array(qd)
    if plant.robot.has_rail:
        arm[:, 0] = 0.0
    X_FT = next(motion.tool.X_FT for motion in made.program.motions if hasattr(motion, "tool"))
    return (plant.robot.jacobian(q, X_FT) @ arm[..., None])[:, :3, 0], made.trajectory.t


@pytest.mark.parametrize("name", PROGRAMS)
def test_every_axis_keeps_the_generators_limits_and_uses_them(name: str) -> None:
    """Mean accelerations between rows: 20 m/s2 at most and often exactly that; speeds continuous by the same token."""
    case = case_of(name, refined=False)
    v, t = from_carriage(case.plant, attempt(bang_bang_row(case)))
    a = np.diff(v, axis=0) / np.diff(t)[:, None]
    assert np.abs(v).max() <= 2.5 * (1 + 1e-9)
    assert np.abs(a).max() <= 20 * (1 + 1e-5)
    assert np.mean(np.abs(a).max(axis=1) > 20 * (1 - 1e-6)) > 0.05


def test_the_joints_pay_for_it_and_the_judge_says_so() -> None:
    """Illegal for joint limits, for TCP caps that hold for each axis only, and for points passed at speed; legal in
    everything the thesis keeps: lines, waits, ends, the order of points."""
    case = case_of("hinge_cell", refined=False)
    made = attempt(bang_bang_row(case))
    found = {finding.check for finding in broken(case, made)}
    assert "joint acceleration" in found
    assert found <= {"joint acceleration", "joint speed", "TCP acceleration", "TCP speed", "stop rest", "speed columns",
                     "programmed speed", "programmed reorientation"}  # fmt: skip
    np.testing.assert_array_equal(made.trajectory.q, attempt(bang_bang_row(case)).trajectory.q)


def alone(case: Case, q_1: Array, **more: object) -> Answer:
    """The row for one MoveAbsJ from the start to q_1 (7,), its plan given without an optimiser."""
    program = rapid("MoveAbsJ j_home, vmax, fine, tool0;")
    plant, motion = case.plant, program.motions[0]
    program = replace(program, motions=(replace(motion, q=q_1[1:], **more),))  # type: ignore[call-arg]
    planned = PlannedMotion(0, motion.source, 0.0, 1.0, plant.start, q_1, "")
    given = Plan(Target.STREAM, case_trajectory(plant), (planned,), None, "")
    return bang_bang_row(Case(program, plant, lambda *_: given))


def case_trajectory(plant: Plant):  # type: ignore[no-untyped-def]
    from trajopt_cli.trajectory import Trajectory as Rows

    return Rows(plant.robot.axis_names, np.array([0.0, 1.0]), np.tile(plant.start, (2, 1)), np.zeros((2, 7)))


def test_one_move_takes_ruckigs_time_for_its_five_axes() -> None:
    """x, y, z, turn and rail from rest to rest: Ruckig, told the displacements, says when they are all there."""
    plant = plant_with_rail()
    case = Case(rapid("MoveAbsJ j_home, vmax, fine, tool0;"), plant, lambda *_: None)  # type: ignore[arg-type,return-value]
    rng = np.random.default_rng(8)
    for rail in (0.0, 0.02, 0.4):
        q_1 = plant.start + np.r_[rail, rng.uniform(-0.3, 0.3, 6)]
        made = attempt(alone(case, q_1))
        X_0, X_1 = (plant.robot.forward(np.r_[0.0, q[1:]]) for q in (plant.start, q_1))
        speed = rapid("MoveAbsJ j_home, vmax, fine, tool0;").motions[0].speed  # type: ignore[union-attr]
        wish, out = InputParameter(5), Trajectory(5)
        wish.current_position = [0.0] * 5
        wish.target_position = [*(X_1 - X_0)[:3, 3], axis_angle(X_0[:3, :3].T @ X_1[:3, :3])[1], rail]
        wish.max_velocity, wish.max_acceleration = [2.5] * 3 + [speed.v_ori, 1.0], [20.0] * 3 + [speed.v_ori * 8, 3.0]
        wish.max_jerk = [float("inf")] * 5
        Ruckig(5).calculate(wish, out)
        assert made.trajectory.duration == pytest.approx(out.duration, abs=1e-9 if rail else 1e-3)
        np.testing.assert_allclose(made.trajectory.q[-1], q_1, atol=1e-12)


def test_speed_is_kept_where_the_way_goes_on_and_only_there() -> None:
    """Down to p_n1_in and on down the line at its 0.5 m/s; up and then away level: a stop. At rest around waits."""
    case = case_of("hinge_cell", refined=False)
    made = attempt(bang_bang_row(case))
    v, _ = from_carriage(case.plant, made)
    p = case.plant.robot.forward(made.trajectory.q)[:, :3, 3]

    def speed_at(index: int) -> Array:
        """TCP velocity when the point is reached first."""
        wanted = made.program.motions[index].X_WT[:3, 3]  # type: ignore[union-attr]
        near = np.flatnonzero(np.linalg.norm(p - wanted, axis=1) < 1e-9)
        return np.asarray(v[near[0]])

    np.testing.assert_allclose(speed_at(0), [0, 0, -0.5], atol=1e-9)  # p_n1_in
    np.testing.assert_allclose(speed_at(1), 0, atol=1e-9)  # p_n1, waits there
    np.testing.assert_allclose(speed_at(4), 0, atol=1e-9)  # p_n2_in: level, then down


def test_where_the_way_turns_back_the_tool_stops() -> None:
    """The bench lifts a part to 200 mm and carries it down to 160 mm: no speed at the top, whenever it is there."""
    case = case_of("bench_irb140", refined=False)
    made = attempt(bang_bang_row(case))
    v, _ = from_carriage(case.plant, made)
    top = made.program.motions[6]
    X_WT = case.plant.robot.forward(made.trajectory.q) @ top.tool.X_FT  # type: ignore[union-attr]
    near = np.linalg.norm(X_WT[:, :3, 3] - top.X_WT[:3, 3], axis=1) < 1e-9  # type: ignore[union-attr]
    assert near.sum() >= 2  # it waits there, too
    assert np.linalg.norm(v[near], axis=1).max() < 1e-9


def test_a_point_between_two_free_moves_is_passed() -> None:
    """Three points on a way where only y goes on: y passes at speed, x turns back and stops, so does the turning."""
    plant = plant_with_rail()
    program = rapid(
        "MoveJ p_in, vmax, fine, tool0;\nMoveJ RelTool(Offs(p_in,60,-200,0),0,0,0\\Rz:=20), vmax, fine, tool0;\n"
        "MoveJ RelTool(Offs(p_in,0,-400,0),0,0,0\\Rz:=40), vmax, fine, tool0;\nMoveAbsJ j_home, vmax, fine, tool0;"
    )
    from timed_rows import solver

    case = Case(program, plant, solver(plant, refined=False))
    made = attempt(bang_bang_row(case))
    v, _ = from_carriage(plant, made)
    p = plant.robot.forward(made.trajectory.q)[:, :3, 3]
    i = int(np.argmin(np.linalg.norm(p - program.motions[1].X_WT[:3, 3], axis=1)))  # type: ignore[union-attr]
    assert np.linalg.norm(p[i] - program.motions[1].X_WT[:3, 3]) < 1e-9  # type: ignore[union-attr]
    assert abs(v[i, 0]) < 1e-9
    assert v[i, 1] < -0.5
    assert made.trajectory.qd is not None
    assert np.linalg.norm(plant.robot.jacobian(made.trajectory.q[i])[3:] @ made.trajectory.qd[i]) < 1e-9
    first_two = Case(replace(program, motions=program.motions[:2]), plant, solver(plant, refined=False))
    alone_times = attempt(bang_bang_row(first_two))
    assert made.trajectory.duration > alone_times.trajectory.duration


def test_a_way_out_of_the_workspace_is_named() -> None:
    """An arm stretched forward turns its hand from the left to the right past its own wrist: the wrist would have to be
    65 mm farther out half way."""
    left = np.r_[0.3, 0.0, 1.48, -1.48, np.pi / 2, 1.75, 0.0]
    right = np.r_[0.3, 0.0, 1.48, -1.48, -np.pi / 2, 1.75, 0.0]
    case = Case(rapid("MoveAbsJ j_home, vmax, fine, tool0;"), plant_with_rail(start=left), lambda *_: None)  # type: ignore[arg-type,return-value]
    answer = alone(case, right)
    assert isinstance(answer, Infeasible)
    assert str(answer).startswith("t.mod:4:1: MoveAbsJ j_home leaves the workspace after 0.")
    assert "mm at rail 300.0 mm: wrist centre outside the outer workspace" in str(answer)


def test_another_configuration_and_too_short_a_time_are_named() -> None:
    plant = plant_with_rail()
    case = Case(rapid("MoveAbsJ j_home, vmax, fine, tool0;"), plant, lambda *_: None)  # type: ignore[arg-type,return-value]
    flipped = alone(case, np.r_[0.0, 0.1, 0.0, 0.0, 0.0, -0.4, 0.0])
    assert isinstance(flipped, Infeasible)
    assert "ends in another configuration than it begins in" in str(flipped)
    short = alone(case, plant.start + np.r_[0.0, 0.3, 0, 0, 0, 0, 0], duration=0.05)
    assert isinstance(short, Infeasible)
    assert "cannot be made in 0.05 s: the generator needs " in str(short)
    exact = attempt(alone(case, plant.start + np.r_[0.0, 0.3, 0, 0, 0, 0, 0], duration=0.9))
    assert exact.trajectory.duration == pytest.approx(0.9, abs=1e-12)
