"""Accelerations by posture: plans against quadratures of the table, bounds below them, and a judge that reads alone."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.ndimage import map_coordinates
from scipy.optimize import brentq
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.judge.accelerations import Accelerations
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import AccelerationTable, JointLimits, TcpCaps
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.acceleration_table import read_acceleration_table
from trajopt_cli.robot.model import load_robot
from trajopt_cli.trajectory import Trajectory

pytestmark = pytest.mark.usefixtures("coarse", "few_places")

START, END = -0.6, 0.7
PLACES = np.array([-1.0, 0.0, 1.0])
UP, DOWN = np.array([4.0, 6.0, 3.0]), np.array([5.0, 2.5, 8.0])
SWING = "MoveAbsJ [[0,40.107045,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v5000, fine, tool0;"


def by_joint_2(plant: Plant) -> Plant:
    """Joint 2 speeds up by UP and slows down by DOWN, which its own position decides; nothing else holds it back."""
    sides = [np.repeat(side[:, None, None], 2, axis=1) for side in (DOWN, UP)]
    table = AccelerationTable(("joint_2",), ("joint_2", "joint_3"), (PLACES, np.array([-1.0, 1.0])), sides[0], sides[1])
    limits, j = plant.limits, plant.limits.names.index("joint_2")
    acceleration, velocity = limits.acceleration.copy(), limits.velocity.copy()
    acceleration[j], velocity[j] = table.range["joint_2"][0], 50.0
    limits = replace(limits, acceleration=acceleration, velocity=velocity, table=table)
    start = plant.start.copy()
    start[j] = START
    return replace(plant, limits=limits, start=start, free_speed=True, tcp=TcpCaps(99.0, 999.0))


def quadrature() -> float:
    """Least time of the swing: v dv/dq is UP until the switch and -DOWN behind it."""

    def gained(side: np.ndarray, a: float, b: float) -> float:
        return quad(lambda q: np.interp(q, PLACES, side), a, b, points=[0.0] if a < 0 < b else None, limit=200)[0]

    switch = brentq(lambda q: gained(UP, START, q) - gained(DOWN, q, END), START, END)
    first = quad(lambda u: 2 * u / np.sqrt(2 * gained(UP, START, START + u * u)), 0, np.sqrt(switch - START))[0]
    last = quad(lambda u: 2 * u / np.sqrt(2 * gained(DOWN, END - u * u, END)), 0, np.sqrt(END - switch))[0]
    return float(first + last)


def planned(plant: Plant, target: Target) -> Plan:
    plan = optimize(rapid(SWING), plant, target, bounded=True)
    assert isinstance(plan, Plan), plan
    return plan


@pytest.mark.parametrize("target", Target)
def test_a_swing_takes_what_the_table_says_and_its_bound_lies_below(target: Target) -> None:
    plant, least = by_joint_2(plant_without_rail()), quadrature()
    plan = planned(plant, target)
    assert least * (1 - 1e-5) < plan.duration < least * 1.01
    assert plan.lower_bound is not None
    assert 0.5 * least < plan.lower_bound < least
    report = verify(rapid(SWING), plant, plan.trajectory, target=target, advice=False)
    assert report.legal, [finding.message for finding in report.findings if not finding.passed]


def test_the_judge_sees_a_side_of_the_table_that_is_passed() -> None:
    plant = by_joint_2(plant_without_rail())
    rows = planned(plant, Target.RAPID).trajectory
    j = rows.names.index("joint_2")
    table = plant.limits.table
    assert table is not None
    for side in ("lower", "upper"):  # 3 % less of one sign is allowed than the rows use
        less = replace(table, **{side: getattr(table, side) * 0.97})
        own = replace(plant, limits=replace(plant.limits, table=less))
        failed = [one for one in verify(rapid(SWING), own, rows, target=Target.RAPID).findings if not one.passed]
        assert [(one.check, one.subject) for one in failed] == [("joint acceleration", "joint_2")]
        at = int(np.searchsorted(rows.t, failed[0].time))
        assert failed[0].value / failed[0].limit == pytest.approx(1 / 0.97, abs=2e-3)
        assert (np.gradient(rows.qd[:, j], rows.t)[at] > 0) == (side == "upper")
    faster = Trajectory(rows.names, rows.t * 0.995, rows.q, rows.qd / 0.995)
    assert not verify(rapid(SWING), plant, faster, target=Target.RAPID).legal


def test_a_cell_asks_for_a_share_of_a_table_or_for_another_number() -> None:
    cell = "robot: irb6640_180_255\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\nlimits: {joint_1: {%s, source: ours}}"
    robot, q = load_robot("irb6640_180_255"), np.array([0, 0.3, -0.7, 0, 0.5, 0])
    before = robot.profile()
    factor = parse_cell(cell % "acceleration_factor: 1.2", "c.yaml").apply_limits(before, robot.axis_names)
    for found in (factor.acceleration_at(q), Accelerations(factor).at(q[None])[:, 0]):
        np.testing.assert_allclose(found[0], before.acceleration_at(q)[0] * [1.2, 1, 1, 1, 1, 1], rtol=1e-12)
    assert factor.table is not None
    wrong = replace(factor.table, lower=factor.table.lower * 1.0001, upper=factor.table.upper * 1.0001)
    misread = replace(factor, table=wrong, acceleration=factor.acceleration * 1.0001)
    np.testing.assert_array_equal(
        Accelerations(misread).at(q[None])[:, 0, :3], Accelerations(factor).at(q[None])[:, 0, :3]
    )
    own = parse_cell(cell % "acceleration: 5", "c.yaml").apply_limits(before, robot.axis_names)
    assert own.acceleration_at(q)[1][0] == own.most_acceleration[0] == Accelerations(own).most[0] == 5
    assert own.table is not None
    assert own.table.axes == ("joint_2", "joint_3")
    with pytest.raises(InputError, match="keep one"):
        parse_cell(cell % "acceleration: 5, acceleration_factor: 2", "c.yaml")
    for wrong in ("true", "0", "1.2 rad/s2", ".inf", "'1,5'"):
        with pytest.raises(InputError, match="acceleration_factor: "):
            parse_cell(cell % f"acceleration_factor: {wrong}", "c.yaml")


HEAD, ROWS = "joint_2 [deg],rail [m],joint_1 [rad/s2],rail [m/s2]", ["0,0,1,5", "0,1,2,5", "9,0,3,5", "9,1,4,5"]


@pytest.mark.parametrize(
    ("rows", "line"),
    [
        ([HEAD, *ROWS[:3]], 1),  # a row lacks
        ([HEAD, *ROWS, "", ROWS[1]], 7),  # one too many
        ([HEAD, *ROWS[:2]], 1),  # one place
        ([HEAD, *(f"{k},{k},1,5" for k in range(40_000))], 1),  # a grid of 40 000 x 40 000
        ([HEAD.replace("rail [m]", "rail [deg]"), *ROWS], 1),
        ([HEAD.replace("joint_1 [rad/s2]", "joint_1 [m/s2]"), *ROWS], 1),
        (["", HEAD, *ROWS[:3], '9,1,"4",5'], 6),
        ([HEAD, *ROWS[:3], "1" * 200_000], 5),
    ],
)
def test_a_table_that_is_no_grid_of_numbers_is_refused_where_it_is_wrong(
    tmp_path: Path, rows: list[str], line: int
) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\n".join(rows))
    with pytest.raises(InputError) as refused:
        read_acceleration_table(file, {"rail": True, "joint_1": False, "joint_2": False})
    assert refused.value.line == line


def test_planner_and_judge_leave_out_the_same_lines(tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text("\r\n".join(["", HEAD, "  ", *ROWS[::-1], ""]))
    table = read_acceleration_table(file, {"rail": True, "joint_1": False, "joint_2": False})
    q = np.array([[0.5, 0.0, np.radians(4.5)]])
    least = np.array([5.0, 1.0, 7.0])
    one = np.ones(3)
    limits = JointLimits(("rail", "joint_1", "joint_2"), -one, one, one, least, {}, table=table)
    for side in (*limits.acceleration_at(q), *Accelerations(limits).at(q)):
        np.testing.assert_allclose(side, [[5.0, 2.5, 7.0]], rtol=1e-12)


@pytest.mark.parametrize("name", ["irb1200_5_90", "irb6640_180_255_rail"])
def test_planner_and_judge_read_a_shipped_table_as_scipy_does(name: str) -> None:
    limits, rng = load_robot(name).profile(), np.random.default_rng(4)
    file = Path(__file__).parents[2] / "robots" / f"{name.removesuffix('_rail')}_acceleration.csv"
    rows = np.loadtxt(file, delimiter=",", skiprows=1)
    second, third = np.unique(rows[:, 0]), np.unique(rows[:, 1])
    q = rng.uniform(-3.6, 3.6, (300, len(limits.names)))
    q2, q3 = np.degrees(q[:, -5]), np.degrees(q[:, -4])
    places = [np.interp(x, grid, np.arange(len(grid))) for x, grid in ((q2, second), (q3, third))]
    lower, upper = limits.acceleration_at(q)
    for column, (side, joint) in enumerate([(0, -6), (0, -5), (1, -5), (0, -4), (1, -4)], start=2):
        grid = rows[:, column].reshape(len(second), len(third))
        wanted = map_coordinates(grid, places, order=1, mode="nearest")
        np.testing.assert_allclose((lower, upper)[side][:, joint], wanted, rtol=1e-9)
        np.testing.assert_allclose(Accelerations(limits).at(q)[side][:, joint], wanted, rtol=1e-9)
        assert grid.max() <= limits.most_acceleration[joint] * (1 + 1e-12)
        assert grid.min() >= limits.acceleration[joint] * (1 - 1e-12)


@pytest.mark.long
def test_a_plan_over_a_rail_by_a_shipped_table_is_legal_and_above_its_bound() -> None:
    robot = load_robot("irb6640_180_255_rail")
    plant = plant_with_rail()
    limits = replace(robot.profile(), lower=np.r_[0.0, robot.profile().lower[1:]])
    plant = replace(plant, robot=robot, limits=limits, start=np.r_[0.0, 0, 0, 0, 0, np.pi / 6, 0])
    data = "CONST robtarget p_far:=[[1500,900,900],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];"
    body = "MoveJ p_far, v2000, fine, tool0;\nMoveL RelTool(p_far,0,0,200), v1000, fine, tool0;"
    program = rapid(body, data=data)
    plans = {}
    for target in Target:
        plan = optimize(program, plant, target, bounded=True)
        assert isinstance(plan, Plan), plan
        report = verify(program, plant, plan.trajectory, target=target, advice=False)
        assert report.legal, [finding.message for finding in report.findings if not finding.passed]
        assert plan.lower_bound is not None
        assert plan.lower_bound < plan.duration
        plans[target] = plan.duration
    assert plans[Target.STREAM] <= plans[Target.RAPID]
    least = replace(plant, limits=replace(limits, table=None))  # what every posture allows is never faster
    slow = optimize(program, least, Target.RAPID, bounded=False)
    assert isinstance(slow, Plan)
    assert plans[Target.RAPID] < slow.duration


def test_a_table_that_is_too_large_is_to_be_coarser(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("joint_2 [rad],joint_3 [rad],joint_1 [rad/s2]\n" + "1,2,3\n" * 200_000)
    with pytest.raises(InputError, match="grid") as refused:
        read_acceleration_table(tmp_path / "a.csv", {"joint_1": False})
    assert refused.value.file == str(tmp_path / "a.csv")
