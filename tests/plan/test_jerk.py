"""Jerk limits: closed forms and Ruckig where there are any, third derivatives, and plans that the judge finds legal."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from small_cells import HOME, down, plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import Program
from trajopt_cli.nlp.block_cache import Maps
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.path.line import Line, LineSymbols
from trajopt_cli.plan import optimize
from trajopt_cli.problem.objective import LEAST_TIME, LeastEffort, Objective
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.timing.point_to_point import point_to_point, rest_time
from trajopt_cli.trajectories.axes import Axes

pytestmark = pytest.mark.usefixtures("coarse", "few_places")

APART = "CONST jointtarget j_off:=[[40,10,-20,30,60,-50],[0,9E9,9E9,9E9,9E9,9E9]];"
AWAY = "MoveAbsJ j_off, v5000, fine, tool0;"
LINE = """MoveJ p_top, v1000, fine, tool0;
MoveL p_down, v500, fine, tool0;
WaitTime 0.3;
MoveAbsJ j_off, v1000, fine, tool0;"""
POINTS = f"""{APART}
CONST robtarget p_top:=[[500,100,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_down:=[[520,120,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""
PASSING = "MoveJ p_in, v1000, fine, tool0;\nMoveAbsJ j_home, v1000, fine, tool0;"  # the rail goes through the stop


def limited(plant: Plant, times: float = 10.0) -> Plant:
    """The plant with jerk limits of so many accelerations per second."""
    limits = plant.limits
    return replace(plant, limits=replace(limits, jerk=times * limits.acceleration, jerk_binds=True))


@cache
def without_rail(body: str, target: Target) -> Plan:
    """The plan of an arm without a rail under jerk limits."""
    return planned(rapid(body, data=POINTS), target, limited(plant_without_rail()))


def planned(program: Program, target: Target, plant: Plant, objective: Objective = LEAST_TIME) -> Plan:
    """A plan that the judge finds legal, its jerk looked at. A free speed: nothing is asked of the tool either."""
    if plant.free_speed:
        plant = replace(plant, tcp=TcpCaps(np.inf, np.inf))
    plan = optimize(program, plant, target, bounded=False, objective=objective)
    assert isinstance(plan, Plan), plan
    judged = replace(plant, tcp=TcpCaps(99.0, 999.0)) if plant.free_speed else plant
    report = verify(program, judged, plan.trajectory, target=target, advice=False)
    assert report.legal, [finding.message for finding in report.findings if not finding.passed]
    looked_at = sum(finding.check == "joint jerk" for finding in report.findings)
    assert looked_at == (plant.limits.binding_jerk is not None) * len(plant.limits.names)
    return plan


def jerks(plan: Plan) -> tuple[Array, Array]:
    """Accelerations (n-1, k) between the rows, and jerks (n-2, k) between those."""
    t, qd = plan.trajectory.t, plan.trajectory.qd
    assert qd is not None
    qdd = np.diff(qd, axis=0) / np.diff(t)[:, None]
    middles = (t[1:] + t[:-1]) / 2
    return qdd, np.diff(qdd, axis=0) / np.diff(middles)[:, None]


def test_the_time_from_rest_to_rest_is_ruckigs() -> None:
    rng = np.random.default_rng(3)
    D, V, A, J = 10.0 ** rng.uniform(-2, 1, (4, 200))
    for d, v, a, j, T in zip(D, V, A, J, rest_time(D, V, A, J), strict=True):
        known = point_to_point(np.zeros(1), np.array([d]), np.array([v]), np.array([a]), np.array([j])).duration
        assert pytest.approx(known, rel=1e-9) == T
    assert rest_time(np.array(0.1), np.array(99.0), np.array(99.0), np.array(2.0)) == pytest.approx(1.6 ** (1 / 3))


@pytest.mark.parametrize("target", Target)
def test_a_joint_move_alone_takes_what_ruckig_says(target: Target) -> None:
    plant = limited(plant_without_rail())
    plan = without_rail(AWAY, target)
    limits, end = plant.limits, np.radians([40, 10, -20, 30, 60, -50])
    straight = target is Target.RAPID
    assert limits.jerk is not None
    known = point_to_point(HOME, end, limits.velocity, limits.acceleration, limits.jerk, straight=straight).duration
    assert known <= plan.duration <= known * (1 + 1e-3)


@pytest.mark.long
@pytest.mark.parametrize(("target", "rail"), [(Target.STREAM, True), (Target.STREAM, False), (Target.RAPID, False)])
def test_plans_keep_jerk_limits_everywhere(target: Target, rail: bool) -> None:
    """Also at the stops: accelerations begin at nothing, and do not jump. With the rail the tool may do anything."""
    base = plant_with_rail(free_speed=True) if rail else plant_without_rail()
    program, plant = rapid(PASSING) if rail else rapid(LINE, data=POINTS), limited(base)
    plan = planned(program, target, plant) if rail else without_rail(LINE, target)
    qdd, jerk = jerks(plan)
    h = np.diff(plan.trajectory.t)
    assert plant.limits.jerk is not None
    assert np.all(np.abs(jerk) <= plant.limits.jerk * (1 + 1e-4) + 1e-12 / h.min() ** 2)
    assert np.all(np.abs(qdd[[0, -1]]) <= plant.limits.jerk * h[[0, -1], None])
    if not rail:
        free = optimize(program, base, Target.RAPID, bounded=False)  # a stream has no less freedom
        assert isinstance(free, Plan)
        assert plan.duration > 1.02 * free.duration
    if target is Target.RAPID:
        assert write_csv_text(planned(program, target, plant).trajectory) == write_csv_text(plan.trajectory)


def test_a_limit_that_no_rows_show_changes_nothing() -> None:
    program, plant = rapid(f"{AWAY}\nMoveAbsJ j_home, v1000, z50, tool0;", data=APART), plant_without_rail()
    huge = replace(plant.limits, jerk=np.full(6, 1e9), jerk_binds=True)
    rows = [planned(program, Target.STREAM, one).trajectory for one in (plant, replace(plant, limits=huge))]
    assert write_csv_text(rows[0]) == write_csv_text(rows[1])


def test_lines_are_driven_faster_than_by_one_profile(monkeypatch: pytest.MonkeyPatch) -> None:
    from trajopt_cli.plan import solve

    program, plant = rapid(LINE, data=POINTS), limited(plant_without_rail())
    plan = without_rail(LINE, Target.RAPID)
    monkeypatch.setattr(solve, "refine_laws", lambda axes, legal, *_: legal.iterate)
    assert plan.duration < planned(program, Target.RAPID, plant).duration - 5e-3


def test_a_stream_of_given_time_keeps_its_jerk_limits() -> None:
    plant = limited(plant_without_rail())
    plan = planned(rapid(AWAY, data=APART), Target.STREAM, plant, LeastEffort(1.5))
    assert plan.duration == pytest.approx(1.5, abs=1e-9)
    assert plan.eased is not None
    d = np.radians([40, 10, -20, 30, 30, -50])  # from home to there
    free = float(np.sum(12 * (d / plant.limits.acceleration) ** 2) / 1.5**3)  # accelerations that jump at both ends
    assert free < plan.eased.planned.effort < 1.3 * free


def test_third_derivatives_along_a_line_are_those_of_its_joints() -> None:
    plant = limited(plant_with_rail())
    axes, line = Axes.of(plant), Line(down(0.45, 0.5, 0.4), down(0.55, 0.7, 0.35))
    relation = Formulation(axes, Maps()).node(LineSymbols(False), "l")
    c, e, T = np.array([0.3, 0.5, 0.4, 0.7]), np.array([0.5, 0.2, -0.6, 0.3]), 1.3  # s and d as cubics of tau
    at = 0.4

    def values(x: Array, tau: float) -> list[float]:
        one = np.polynomial.Polynomial(x)
        return [float(one.deriv(i)(tau)) if i else float(one(tau)) for i in range(4)]

    (s, v, a, ja), (d, w, b, jb) = values(c * 0.5, at), values(e, at)

    def joints(tau: float) -> Array:
        S, D = np.array([values(c * 0.5, tau)[0]]), np.array([values(e, tau)[0]])
        return np.asarray(axes.inverse(line.pose(S), D)[0, 0])

    z = {"s": s, "v": v, "a": a, "d": [d], "w": [w], "b": [b], "T": T, "ja_l": ja, "jb_l": [jb]}
    p = {
        "path": line.parameters(inverse_pose(axes.X_WB0), np.eye(4)),
        "branch": axes.robot.expressions.branch(0), "near": joints(at), "V": axes.velocity, "A": axes.acceleration,
        "room": np.ones(7), "jerk": axes.jerk,
    }  # fmt: skip
    h = 2e-3
    third = (joints(at + 2 * h) - 2 * joints(at + h) + 2 * joints(at - h) - joints(at - 2 * h)) / (2 * h**3)
    assert axes.jerk is not None
    wanted = np.r_[jb / axes.jerk[0], third / axes.jerk[1:]] / T**3
    assert np.abs(third).max() > 0.1
    first = 2 + 7 + 7  # walls, velocities, accelerations
    assert relation.value(z, p)[first : first + 7] == pytest.approx(wanted, rel=1e-3, abs=1e-5)


CORNERS = """MoveJ p_top, v1000, fine, tool0;
MoveL p_down, v500, z50, tool0;
MoveL p_side, v500, z50, tool0;
MoveJ p_top, v1000, fine, tool0;"""
SIDE = f"""{POINTS}
CONST robtarget p_side:=[[520,-100,350],[0,0.1,0.995,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"""


@cache
def through_corners(zone: str) -> Plan:
    """A line, a line that turns the tool, and a joint move, with corners between them or without."""
    program = rapid(CORNERS.replace("z50", zone), data=SIDE)
    return planned(program, Target.RAPID, limited(plant_without_rail()))


@pytest.mark.long
def test_fly_bys_are_passed_under_jerk_limits() -> None:
    """Faster than with stops, which the judge finds legal, and its jerks are within the limits wherever rows show."""
    plan, stopping = through_corners("z50"), through_corners("fine")
    assert plan.duration < 0.96 * stopping.duration
    rows = plan.trajectory
    for motion in plan.motions[1:3]:
        assert np.abs(rows.qd[np.argmin(np.abs(rows.t - motion.t_1))]).max() > 0.05  # type: ignore[index]
    jerk = jerks(plan)[1]
    limit, h = limited(plant_without_rail()).limits.jerk, np.diff(rows.t)
    assert limit is not None
    assert np.all(np.abs(jerk) <= limit * (1 + 1e-4) + 1e-12 / h.min() ** 2)
    assert np.abs(jerk / limit).max() > 0.95


def test_second_derivatives_go_on_through_corners_with_a_rail() -> None:
    """Of all axes: lines with zones of their own for position, turns and rail, and a joint move beside one."""
    from trajopt_cli.graph_search.search import search
    from trajopt_cli.path_timing.sampled_path import sample_path

    plant = limited(plant_with_rail())
    points = SIDE.replace("[9E9,9E9,9E9,9E9,9E9,9E9]]", "[%d,9E9,9E9,9E9,9E9,9E9]]") % (0, 60, 20)
    zone = "CONST zonedata z_own:=[FALSE,20,30,40,3,40,3];"
    program = rapid(CORNERS.replace("z50", "z_own"), data=f"{zone}\n{points}")
    problem, axes = problem_of(program, plant, Target.RAPID), Axes.of(plant)
    route = search(axes, problem)
    assert route is not None
    (run,) = (run for run in problem.runs if run[1] > run[0] + 1)
    path = sample_path(axes, problem, run, route.q, [label.cfx for label in route.labels], 24)
    assert path is not None
    assert len(path.parts) > 9
    ends = np.array(path.begins[1:-1])
    for values in (path.along.dq, path.along.ddq):
        np.testing.assert_allclose(values[ends], values[ends - 1], atol=1e-5 * np.abs(values).max())


def test_a_smooth_law_of_one_axis_is_nearly_ruckigs() -> None:
    """A straight way of one axis, with and without a top speed that is reached, against the closed form."""
    from trajopt_cli.path_timing.sampled_path import sample_path
    from trajopt_cli.path_timing.smooth_runs import _Run

    plant = limited(plant_without_rail())
    for turn in (5, 40):
        body = AWAY.replace("j_off", "j_turn")
        data = f"CONST jointtarget j_turn:=[[{turn},0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];"
        problem, axes = problem_of(rapid(body, data=data), plant), Axes.of(plant)
        q = np.array([HOME, HOME + np.radians([turn, 0, 0, 0, 0, 0])])
        path = sample_path(axes, problem, (0, 1), q, [0, 0], 24)
        assert path is not None
        law = _Run(axes, problem, path).law()
        assert law is not None
        limits = plant.limits
        assert limits.jerk is not None
        best = rest_time(np.radians(turn), limits.velocity[0], limits.acceleration[0], limits.jerk[0])
        assert best <= law.T * (1 + 2e-3) <= 1.12 * best


def test_the_judge_sees_accelerations_that_jump() -> None:
    program = rapid(AWAY, data=APART)
    plan = optimize(program, plant_without_rail(), Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    for speeds in (True, False):
        trajectory = plan.trajectory if speeds else replace(plan.trajectory, qd=None)
        report = verify(program, limited(plant_without_rail(), 100.0), trajectory, target=Target.RAPID)
        failed = [finding for finding in report.findings if not finding.passed]
        assert {finding.check for finding in failed} == {"joint jerk"}
        assert "rad/s3" in failed[0].message


@pytest.mark.parametrize(("speeds", "step"), [(True, 1), (False, 1), (True, 5), (False, 5)])
def test_the_judge_passes_rows_of_any_spacing(speeds: bool, step: int) -> None:
    program, plant = rapid(AWAY, data=APART), limited(plant_without_rail())
    rows = without_rail(AWAY, Target.RAPID).trajectory
    t = np.unique(np.r_[np.arange(0.0, rows.duration, 1e-3 * step), rows.duration])
    from trajopt_cli.trajectory import hermite

    q, qd, _ = hermite(rows, t)
    report = verify(program, plant, replace(rows, t=t, q=q, qd=qd if speeds else None), target=Target.RAPID)
    assert report.legal, [finding.message for finding in report.findings if not finding.passed]


@pytest.mark.parametrize("target", Target)
def test_a_move_to_where_the_arm_is_takes_no_time(target: Target) -> None:
    alone, again = (without_rail(body, target) for body in (AWAY, f"{AWAY}\nWaitTime 0.2;\n{AWAY}\nWaitTime 0.1;"))
    assert again.duration == pytest.approx(alone.duration + 0.3, abs=1e-6)
    assert again.motions[2].binding == "already there"
