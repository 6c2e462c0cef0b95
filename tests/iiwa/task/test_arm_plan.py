"""The best course of the arm angle: the best on a small grid by trying all, near it when smooth, right in every row."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np
import pinocchio as pin
import pytest
from joint_ways import HOME, line, product_forward, quintic, sequence, spin
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.arm_map import FREE, ArmTask, NoPlan, arm_map, cheapest, margins, stages
from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective, ArmPlan, Goal
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.joint_checks import Arm, stops_loop
from trajopt_cli.iiwa.task.joints import Followed, follow
from trajopt_cli.iiwa.task.model import AngleMeaning
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, arm_angle, configuration, inverse_branch

H = 2e-3
ROBOT = load_srs("iiwa7")
LIMITS = ROBOT.profile()
FLANGE = np.eye(4)
LOAD = ToolLoad(2.0, np.array([0.0, 0.05, 0.1]), np.diag([2e-3, 2e-3, 1e-3]))
BENT = np.radians([20, 50, -30, -80, 40, 60, -20])
# start [rad], by [m], turn [rad], seconds
WAYS = {
    "bent": (BENT, (0.0, 0.2, -0.1), (0.3, -0.2, 0.4), 1.5),
    "aside": (np.radians([-20, 60, 70, -80, 30, 60, 0]), (0.1, 0.1, -0.1), (0.2, 0.1, -0.3), 3.0),
    "turn": (HOME, (0, 0, 0), (0, 0, -3.3), 2.5),  # joint_7 passes its range at the fixed arm angle
}


def way_of(name: str) -> tuple[Equilibrium, Array]:
    start, by, turn, seconds = WAYS[name]
    return line(ROBOT.forward(start), np.array(by), np.array(turn), seconds, H), start


def chosen(way: Equilibrium, start: Array, goal: Goal, definition: ArmAngle = ArmAngle.FARIA) -> Followed:
    answer = follow(way, Arm(ROBOT, FLANGE, start, LIMITS, definition), objective=ArmAngleObjective(goal, LOAD))
    assert isinstance(answer, Followed)
    return answer


@pytest.fixture(scope="module")
def answers() -> dict[tuple[str, Goal], Followed]:
    return {(name, goal): chosen(*way_of(name), goal) for name in WAYS for goal in Goal}


def plan_of(answer: Followed) -> ArmPlan:
    assert answer.plan is not None
    return answer.plan


def test_on_a_small_grid_nothing_is_better() -> None:
    """By trying all courses of cells."""
    random = np.random.default_rng(3)
    blocked = 0
    for _ in range(12):
        q = random.uniform(-0.4, 0.4, (5, 5, 7))
        q[random.uniform(size=(5, 5)) < 0.25, 0] = 4.0  # out of every range
        q[0, 0] = 0.0
        dt = random.uniform(0.12, 0.3, 4)
        cell = 2 * np.pi / 5

        def hold(q: Array) -> Array:
            return np.where(margins(q, LIMITS) < 0, np.inf, np.square(q).sum(axis=-1))

        def drive(share: Array) -> Array:
            return share.sum(axis=0) / 10

        def worst(q: Array) -> Array:
            return np.where(margins(q, LIMITS) < 0, np.inf, -margins(q, LIMITS))

        best, least = np.inf, np.inf
        for cells in product(range(5), repeat=4):
            course = q[np.arange(5), (0, *cells)]
            share = np.abs(np.diff(course, axis=0)) / LIMITS.velocity / dt[:, None]
            # five cells, two steps either way: all of them can be got to in one stage
            if (share <= 1).all():
                best = min(best, float(dt @ (hold(course[1:]) + drive(share.T))))
                least = min(least, float(worst(course).max()))
        # the fastest arm angle looked at would cross less than a cell: cells are counted as narrow
        found = cheapest(iter(q), dt, LIMITS, cell / 12, hold, drive)
        other = cheapest(iter(q), dt, LIMITS, cell / 12, worst, lambda s: np.full(s.shape[1:], -np.inf), np.maximum)
        if best == np.inf:
            assert isinstance(found, NoPlan)
            blocked += 1
            continue
        assert not isinstance(found, NoPlan)
        assert not isinstance(other, NoPlan)
        course = q[np.arange(5), found % 5]
        share = np.abs(np.diff(course, axis=0)) / LIMITS.velocity / dt[:, None]
        assert float(dt @ (hold(course[1:]) + drive(share.T))) == pytest.approx(best, rel=1e-12)
        assert float(worst(q[np.arange(5), other % 5]).max()) == pytest.approx(least, rel=1e-12)
    assert blocked < 10


@pytest.mark.long
@pytest.mark.parametrize("goal", Goal)
@pytest.mark.parametrize("name", WAYS)
def test_a_chosen_course_is_right_in_every_row(
    name: str, goal: Goal, answers: dict[tuple[str, Goal], Followed]
) -> None:
    (way, start), answer = way_of(name), answers[name, goal]
    q, delta = answer.trajectory.q, answer.arm_angle
    assert all(one.passed for one in answer.findings)
    np.testing.assert_allclose(q[0], start, rtol=0, atol=1e-9)
    model, frame = ROBOT.pin_model, ROBOT.pin_model.getFrameId("tool0")
    data = model.createData()
    for row in range(0, len(q), 25):  # a second library's forward kinematics
        pin.framesForwardKinematics(model, data, q[row])
        np.testing.assert_allclose(data.oMf[frame].homogeneous, answer.X_WF[row], rtol=0, atol=1e-9)
    X = product_forward(q)
    np.testing.assert_allclose(X[:, :3, 3], way.pose[:, :3], rtol=0, atol=1e-9)
    np.testing.assert_allclose(X[:, :3, :3], way.rotations(X[0, :3, :3]), rtol=0, atol=1e-9)
    assert set(configuration(q)) == {int(configuration(start))}
    # by differences, not by the findings
    assert (q <= LIMITS.upper).all()
    assert (q >= LIMITS.lower).all()
    assert (np.abs(np.diff(q, axis=0)) / H <= LIMITS.velocity).all()
    assert (np.abs(np.diff(q, n=2, axis=0)) / H**2 <= LIMITS.acceleration).all()
    # from rest to rest, and the arm angle's acceleration has no jump
    bent = np.diff(delta, n=2) / H**2
    assert (np.abs(np.diff(delta)[[0, -1]]) <= 0.6 * H**2 * np.abs(bent[[0, -1]]) + 1e-12).all()
    assert np.abs(np.diff(bent)).max() < 0.15 * np.ptp(bent)


def figures_of(q: Array) -> tuple[float, float, float]:
    """Least distance from a limit, mean square of speeds and of holding torques, as shares."""
    room = np.minimum(LIMITS.upper - q, q - LIMITS.lower)[:, FREE].min()
    speed = np.square(np.diff(q, axis=0) / H / LIMITS.velocity).sum(axis=1).mean()
    torque = np.square(Dynamics(ROBOT, LOAD).gravity_torque(q[::5]) / ROBOT.torque).sum(axis=1).mean()
    return float(room), float(speed), float(torque)


@pytest.mark.long
@pytest.mark.parametrize("name", WAYS)
def test_each_goal_is_best_by_its_own_measure(name: str, answers: dict[tuple[str, Goal], Followed]) -> None:
    way, start = way_of(name)
    fixed = follow(way, Arm(ROBOT, FLANGE, start, LIMITS))
    assert isinstance(fixed, Followed)
    courses = {goal: figures_of(answers[name, goal].trajectory.q) for goal in Goal}
    if not stops_loop(fixed.findings):
        courses[None] = figures_of(fixed.trajectory.q)  # type: ignore[index]
    for i, (goal, sign) in enumerate(((Goal.LIMITS, -1), (Goal.SPEED, 1), (Goal.TORQUE, 1))):
        others = [sign * values[i] for key, values in courses.items() if key is not goal]
        # holding torques hardly depend on the arm angle in the other ways
        give = -5e-3 if name == "aside" else 1e-3
        assert sign * courses[goal][i] <= min(others) + give * abs(min(others))


@pytest.mark.parametrize("name", WAYS)
def test_the_figures_are_those_of_the_joints(name: str, answers: dict[tuple[str, Goal], Followed]) -> None:
    answer = answers[name, Goal.TORQUE]
    best, q = plan_of(answer).best, answer.trajectory.q
    room, speed, _ = figures_of(q)
    assert best.margin == pytest.approx(room, rel=1e-9)
    assert best.steady == pytest.approx(np.sqrt(speed), rel=1e-9)
    model, data = _with_load()
    held = np.array([pin.computeGeneralizedGravity(model, data, one) for one in q])
    assert best.effort == pytest.approx(np.sqrt(np.square(held / ROBOT.torque).sum(axis=1).mean()), rel=1e-3)
    assert best.gravity == pytest.approx(np.abs(held / ROBOT.torque).max(), rel=1e-3)
    azimuth, tilt = q[:, 0], q[:, 1]
    points = 0.4 * np.column_stack([np.cos(azimuth) * np.sin(tilt), np.sin(azimuth) * np.sin(tilt), np.cos(tilt)])
    assert best.elbow == pytest.approx(np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), rel=1e-9)
    assert best.turned == pytest.approx(np.abs(np.diff(answer.arm_angle)).sum())


def _with_load() -> tuple[pin.Model, pin.Data]:
    model = pin.Model(ROBOT.pin_model)
    frame = model.frames[model.getFrameId("tool0")]
    model.appendBodyToJoint(frame.parentJoint, pin.Inertia(LOAD.mass, LOAD.com, LOAD.inertia), frame.placement)
    return model, model.createData()


@pytest.mark.parametrize("name", WAYS)
def test_a_smooth_course_costs_hardly_more_than_the_best_on_the_grid(
    name: str, answers: dict[tuple[str, Goal], Followed]
) -> None:
    """The grid knows no accelerations: its elbow moves at once."""
    for goal in Goal:
        plan = plan_of(answers[name, goal])
        assert plan.cost <= 1.05 * plan.grid_cost
        assert not plan.held


def test_the_least_joint_speed_is_what_another_optimiser_finds(answers: dict[tuple[str, Goal], Followed]) -> None:
    """scipy's, over a spline with eleven knots, from the fixed arm angle: it has fewer freedoms."""
    answer = answers["bent", Goal.SPEED]
    n, begin, branch = len(answer.X_WF), answer.arm_angle[0], answer.configuration
    knots = np.linspace(0, n - 1, 11)

    def cost(values: Array) -> float:
        spline = CubicSpline(knots, [begin, *values], bc_type=((1, 0.0), (1, 0.0)))
        q = inverse_branch(ROBOT, answer.X_WF[::5], spline(np.arange(0, n, 5)), ArmAngle.FARIA, branch)
        return float(np.square(np.diff(np.unwrap(q, axis=0), axis=0) / LIMITS.velocity / H).sum() / 5)

    other = minimize(cost, np.full(10, begin), method="BFGS").fun
    ours = np.square(np.diff(answer.trajectory.q[::5], axis=0) / LIMITS.velocity / H).sum() / 5
    assert ours <= 1.01 * other
    assert other < 0.97 * cost(np.full(10, begin))


def widest(X_WF: Array, start: Array) -> float:
    """Greatest least distance from a limit by floods over another grid, thresholds by bisection, no smoothness."""
    rows, m = np.arange(0, len(X_WF), 20), 500
    grid = float(arm_angle(ROBOT, start, ArmAngle.FARIA)) + 2 * np.pi / m * np.arange(m)
    q = inverse_branch(
        ROBOT, np.repeat(X_WF[rows], m, 0), np.tile(grid, len(rows)), ArmAngle.FARIA, int(configuration(start))
    ).reshape(len(rows), m, 7)
    room = np.minimum(LIMITS.upper - q, q - LIMITS.lower)[..., FREE].min(axis=-1)
    near = (np.arange(m) - np.arange(-7, 8)[:, None]) % m  # the cells that each may be got to from
    ways = [(np.abs(now - before[near]) <= LIMITS.velocity * 20 * H).all(axis=-1) for before, now in pairwise(q)]
    low, high = 0.0, float(room[0, 0])
    for level in [high, *[None] * 12]:
        level = (low + high) / 2 if level is None else level
        wet = (np.arange(m) == 0) & (room[0] >= level)
        for way, here in zip(ways, room[1:], strict=True):
            wet = (wet[near] & way).any(axis=0) & (here >= level)
        low, high = (level, high) if wet.any() else (low, level)
    return low


@pytest.mark.parametrize("name", WAYS)
def test_the_least_distance_from_limits_is_what_floods_find(
    name: str, answers: dict[tuple[str, Goal], Followed]
) -> None:
    answer = answers[name, Goal.LIMITS]
    most = widest(answer.X_WF, answer.trajectory.q[0])
    assert plan_of(answer).best.margin == pytest.approx(most, rel=0.03)
    assert plan_of(answer).grid_margin == pytest.approx(most, rel=0.03)


def test_a_course_is_chosen_where_the_fixed_arm_angle_fails(answers: dict[tuple[str, Goal], Followed]) -> None:
    for goal in Goal:
        answer = answers["turn", goal]
        plan = plan_of(answer)
        assert not plan.fixed.passes
        assert plan.fixed_cost == np.inf
        assert plan.fixed.margin == pytest.approx(np.radians(175) - 3.3, abs=1e-9)
        assert "held at 0.00°: joint_7 position" in answer.notes[0]


def test_a_finer_grid_is_hardly_better(answers: dict[tuple[str, Goal], Followed]) -> None:
    start, answer = WAYS["bent"][0], answers["bent", Goal.SPEED]
    task = ArmTask(Arm(ROBOT, FLANGE, start, LIMITS), answer.X_WF, H)
    rows = stages(len(answer.X_WF), 60)
    costs = []
    for cells in (360, 1440):
        chart = arm_map(task, rows, cells)
        found = cheapest(
            iter(chart.q), np.diff(rows) * H, LIMITS, chart.cell,
            lambda q: np.where(margins(q, LIMITS) < 0, np.inf, 0.0), lambda share: np.square(share).sum(axis=0),
        )  # fmt: skip
        assert not isinstance(found, NoPlan)
        q = chart.q[np.arange(len(rows)), found % cells]
        share = np.diff(q, axis=0) / LIMITS.velocity / (np.diff(rows) * H)[:, None]
        costs.append(float((np.diff(rows) * H) @ np.square(share).sum(axis=1)))
    assert costs[1] <= costs[0] * (1 + 1e-12)
    q = answer.trajectory.q[rows]
    share = np.diff(q, axis=0) / LIMITS.velocity / (np.diff(rows) * H)[:, None]
    assert float((np.diff(rows) * H) @ np.square(share).sum(axis=1)) <= 1.01 * costs[1]


def test_a_standing_arm_keeps_its_arm_angle() -> None:
    answer = chosen(spin(ROBOT.forward(HOME), np.zeros(151), H), HOME, Goal.SPEED)
    assert plan_of(answer).held
    assert np.ptp(answer.arm_angle) == 0
    assert answer.notes[0].startswith("the arm angle stays at 0.00°: ")


@pytest.mark.long
def test_a_way_with_hardly_any_room_is_gone() -> None:
    """joint_7 would have to turn by 225 deg: what the arm angle can take of it ends less than 2 deg from a limit."""
    answer = chosen(line(ROBOT.forward(HOME), np.zeros(3), np.array([0, 0, -3.92]), 6.0, H), HOME, Goal.SPEED)
    assert not stops_loop(answer.findings)
    assert 0 < plan_of(answer).best.margin < np.radians(2.0)


@pytest.mark.parametrize("goal", Goal)
@pytest.mark.parametrize("rows", [2, 3, 4, 30])
def test_short_sequences_are_followed(rows: int, goal: Goal) -> None:
    answer = chosen(line(ROBOT.forward(BENT), np.array([0, 1e-6, 0]), np.zeros(3), (rows - 1) * H, H), BENT, goal)
    assert len(answer.arm_angle) == rows
    assert not stops_loop(answer.findings)
    np.testing.assert_allclose(product_forward(answer.trajectory.q), answer.X_WF, rtol=0, atol=1e-9)


def test_a_sequence_whose_speed_steps_has_a_course() -> None:
    """Profile thesis: accelerations fail in the first and the last row whatever the arm angle, and nowhere else."""
    by = np.array([0.1, 0.15, -0.05])
    X = ROBOT.forward(BENT)
    share = np.linspace(0, 1, 751)[:, None]
    way = sequence(
        np.hstack([X[:3, 3] + share * by, np.zeros((751, 3))]), np.tile(np.eye(3), (751, 1, 1)),
        AngleMeaning.RELATIVE, H,
    )  # fmt: skip
    answer = chosen(way, BENT, Goal.SPEED)
    assert not plan_of(answer).held
    assert {one.check for one in answer.findings if not one.passed} == {"acceleration"}
    bent = np.abs(np.diff(answer.trajectory.q, n=2, axis=0)) / H**2 / LIMITS.acceleration
    assert (bent[2:-2] <= 1).all()
    assert plan_of(answer).best.steady < 0.997 * plan_of(answer).fixed.steady


def test_both_definitions_of_the_arm_angle_give_the_same_joints(answers: dict[tuple[str, Goal], Followed]) -> None:
    faria, swivel = answers["bent", Goal.SPEED].trajectory.q, chosen(*way_of("bent"), Goal.SPEED, ArmAngle.SWIVEL)
    np.testing.assert_allclose(faria, swivel.trajectory.q, rtol=0, atol=1e-6)


def test_none_is_found_where_every_arm_angle_is_out_of_range() -> None:
    """The start and the way of a flood that ends: see test_arm_course."""
    start = np.radians([-65.7, 26.1, -112.7, -78.3, -113.4, -69.1, 74.0])
    way = line(ROBOT.forward(start), np.array([-0.077, -0.004, -0.029]), np.array([-0.732, -1.136, -1.591]), 4.0, H)
    answer = chosen(way, start, Goal.LIMITS)
    assert answer.plan is None
    assert stops_loop(answer.findings)
    assert answer.notes[0].startswith("no path of the arm angle was found: at t = ")
    assert "no arm angle that keeps every joint in its range can be reached in time" in answer.notes[0]


@pytest.mark.parametrize("goal", Goal)
def test_the_start_itself_out_of_range_is_said(goal: Goal) -> None:
    start = np.array([*HOME[:6], np.radians(178.0)])
    answer = chosen(spin(ROBOT.forward(start), quintic(251) * 0.1, H), start, goal)
    assert answer.plan is None
    assert answer.notes[0] == (
        "no path of the arm angle was found: at t = 0.000 s (a -> b, 0 % of the way) the arm angle of the start"
        " joints breaks a range: joint_7"
    )
