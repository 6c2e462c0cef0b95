"""Joints that a linkage couples: the range of their sum is kept in tables, at targets and on the way between them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import STROKE, plant_with_rail, plant_without_rail, rapid
from unrefined import IMPROVED, as_it_comes

from trajopt_cli.geometry import Array
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import CoupledRange, TcpCaps
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.configurations import check_configurations
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.workspace import rail_ranges

pytestmark = pytest.mark.usefixtures("coarse")

ACROSS = """MoveAbsJ [[0,60,-37,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v2500, fine, tool0;
MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v2500, fine, tool0;"""
STATION = """MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v500, fine, tool0;
MoveAbsJ j_home, v2500, fine, tool0;"""
FREE_TOOL = {"tcp": TcpCaps(9.0, 99.0), "free_speed": True}


def coupled(plant: Plant, low: float, high: float, factors: tuple[float, float] = (1.0, 1.0)) -> Plant:
    """The plant with a range [deg] of a sum of joints 2 and 3."""
    one = CoupledRange(("joint_2", "joint_3"), factors, *np.radians([low, high]).tolist(), "made up (grade D)")
    return replace(plant, limits=replace(plant.limits, coupled=(one,)))


def broken(program: Program, plant: Plant, plan: Plan, target: Target) -> list[str]:
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    return [f"{f.check} {f.subject}" for f in report.findings if not f.passed]


def sums(plant: Plant, plan: Plan, factors: tuple[float, float] = (1.0, 1.0)) -> Array:
    return np.degrees(plan.trajectory.q[:, plant.layout.arm][:, 1:3] @ factors)


def planned(program: Program, plant: Plant, target: Target = Target.STREAM) -> Plan:
    """With nothing asked of the tool: the judge's caps are too high to bind."""
    plan = optimize(program, replace(plant, tcp=TcpCaps(np.inf, np.inf)), target, bounded=False)
    assert isinstance(plan, Plan), plan
    return plan


def test_free_profiles_keep_the_sum_on_their_way() -> None:
    """Joint 2 is soon at its speed, joint 3 never: both take as long, and the first is ahead half of the way."""
    program, free, factors = rapid(ACROSS), plant_without_rail(**FREE_TOOL), (1.0, 60 / 37)
    V, A = free.limits.velocity.copy(), free.limits.acceleration.copy()
    V[1:3], A[1:3] = [2.0, 4.5], [15.0, 6.0]
    free = replace(free, limits=replace(free.limits, velocity=V, acceleration=A))
    unbound = planned(program, free)
    most = np.abs(sums(free, unbound, factors)).max()
    assert most > 3
    plant = coupled(free, -most / 2, most / 2, factors)
    assert broken(program, plant, unbound, Target.STREAM) == ["joint position joint_2 + 1.62162 joint_3"]
    plan = planned(program, plant)
    assert broken(program, plant, plan, Target.STREAM) == []
    assert np.abs(sums(plant, plan, factors)).max() == pytest.approx(most / 2, rel=0.02)  # what may be used is
    assert 1.01 * unbound.duration < plan.duration < 1.2 * unbound.duration


def test_lines_and_their_ends_keep_the_sum(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a rail position and a configuration that the sum allows there is one, but not the one that is fastest."""
    program, free, target = rapid(STATION), plant_with_rail((0.0, 0.6), **FREE_TOOL), Target.STREAM
    with monkeypatch.context() as patch:
        patch.setattr(IMPROVED, as_it_comes)
        alone = planned(program, free, target)
    unbound = sums(free, alone)
    plant = coupled(free, -180, float(unbound.max()) - 8.0)
    plan = planned(program, plant, target)
    assert broken(program, plant, plan, target) == []
    assert sums(plant, plan).max() > unbound.max() - 9.0
    assert broken(program, plant, alone, target) == ["joint position joint_2 + joint_3"]


def test_a_pose_that_only_the_sum_forbids_is_refused_with_the_sum() -> None:
    plant = plant_with_rail(STROKE)
    robot, q = plant.robot, np.radians([20.0, 40, 10, 30, 50, 20])
    limits = coupled(plant, -250, 45).limits
    X = robot.forward(np.r_[0.3, q])
    alone = robot.solutions(X, 0.3, plant.limits)
    found = robot.solutions(X, 0.3, limits)
    assert 0 < len(found) < len(alone)
    assert {cfx for cfx, _ in alone} == {0, 1, 6, 7}
    assert {cfx for cfx, _ in found} == {6, 7}  # the others have 50 degrees
    narrow = coupled(plant, -1, 1).limits
    assert robot.solutions(X, 0.3, narrow) == []
    why = robot.why_unreachable(X, 0.3, narrow)
    assert why.startswith("every branch breaks a limit: nearest joint_2 + joint_3 = ")
    assert why.endswith("range -1..1°")


def test_parse_and_the_rails_ranges_know_the_sum() -> None:
    program, free = rapid(STATION), plant_with_rail((-0.16, 0.8))
    assert not check_configurations(program, free)
    narrow = coupled(free, -1, 1)
    told = [finding.message for finding in check_configurations(program, narrow)]
    assert "cannot be reached" in told[0]
    assert "nearest joint_2 + joint_3" in told[0]
    X = free.robot.forward(np.r_[0.3, np.radians([20.0, 40, 10, 30, 50, 20])])
    wide, less = (rail_ranges(plant, X, branch=0) for plant in (free, coupled(free, -250, 45)))
    assert 0 < np.diff(less).sum() < np.diff(wide).sum()


def test_joints_given_beyond_the_sum_are_refused() -> None:
    answer = optimize(rapid(ACROSS), coupled(plant_without_rail(), -20, 90, (1.0, -1.0)), Target.STREAM)
    assert isinstance(answer, Infeasible)
    assert "asks for joint_2 - joint_3 = 97 deg, range -20..90 deg" in answer.message


def test_names_of_sums_and_mistakes_in_them() -> None:
    assert CoupledRange(("joint_2", "joint_3"), (-1.0, 0.5), -1, 1).name == "-joint_2 + 0.5 joint_3"
    with pytest.raises(ValueError, match="different axes"):
        CoupledRange(("joint_2", "joint_2"), (1.0, 1.0), -1, 1)
    with pytest.raises(ValueError, match="under the upper"):
        CoupledRange(("joint_2",), (1.0,), 1, 1)
    limits = plant_without_rail().limits
    with pytest.raises(ValueError, match=r"joint_2 \+ elbow names an axis that is none of joint_1"):
        replace(limits, coupled=(CoupledRange(("joint_2", "elbow"), (1.0, 1.0), -1, 1),))
