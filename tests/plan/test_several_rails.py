"""Programs of an arm on two and three linear axes: planned, written as RAPID, judged."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import product

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.exporters.files import export
from trajopt_cli.exporters.rapid import export_rapid, intents_of
from trajopt_cli.exporters.rapid_check import mismatches, read_again
from trajopt_cli.findings import Report
from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.by_rails import check_reach, search
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveL, Program, TextFile
from trajopt_cli.path_timing.edge_times import Pairs, Times, leg_times
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.plan import optimize
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plannable import check_plannable
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Follower, Scenario
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectory import Trajectory

pytestmark = pytest.mark.usefixtures("coarse")

WAYS = {
    "a": "[1, 0, 0], stroke: [-0.2, 1.2]",
    "b": "[0, 1, 0], stroke: [-0.5, 0.5]",
    "c": "[0, 0, 1], stroke: [-0.2, 0.5]",
}
DOWN = "[0,0,1,0],[0,0,0,0]"
BODY = rf"""ConfJ \Off; ConfL \Off;
MoveJ [[500,-100,400],{DOWN},[0,0,0,9E9,9E9,0]], v1000, fine, tool0;
MoveL [[900,100,400],{DOWN},[400,200,50,9E9,9E9,400]], v1000, fine, tool0;
MoveJ [[900,100,500],{DOWN},[400,200,50,9E9,9E9,400]], v1000, fine, tool0;
MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[0,0,0,9E9,9E9,0]], v1000, fine;"""


@cache
def gantry(letters: str = "abc", stroke: str = "") -> Plant:
    axes = "".join(f"  eax_{one}: {{axis: {WAYS[one]}}}\n" for one in letters)
    text = f"robot: irb140\ntool_radius: 0\naxes:\n{axes}  eax_f: {{follows: eax_a}}\n{stroke}"
    return build_plant(parse_cell(text + 'start: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n', "cell.yaml"))


def program(plant: Plant, body: str = BODY) -> Program:
    file = TextFile("t.mod", f"MODULE T\nPROC main()\n{body}\nENDPROC\nENDMODULE", "utf-8")
    return run_program([file], None, "main", PlantKinematics(plant))


def judged(program: Program, plant: Plant, rows: Trajectory, target: Target) -> Report:
    return verify(program, plant, rows, target=target, advice=False)


@cache
def planned(letters: str, target: Target, written: bool = False, bounded: bool = False) -> tuple[Plant, Program, Plan]:
    plant = gantry(letters)
    body = BODY if "b" in letters else BODY.replace("[400,200,50", "[400,9E9,9E9")
    own = program(plant, body)
    plan = optimize(own, plant, target, *([AS_WRITTEN] if written else []), bounded=bounded)
    assert isinstance(plan, Plan), plan
    return plant, own, plan


@pytest.mark.long
@pytest.mark.parametrize("target", [*Target])
def test_a_plan_of_three_axes_is_legal_and_uses_them(target: Target) -> None:
    plant, own, plan = planned("abc", target, bounded=True)
    report = judged(own, plant, plan.trajectory, target)
    assert report.legal, report.violations
    assert np.ptp(plan.trajectory.q[:, :3], axis=0).min() > 0.01
    assert plan.lower_bound is not None
    assert plan.lower_bound <= plan.duration


@pytest.mark.long
def test_more_axes_and_more_freedom_take_no_longer() -> None:
    rapid = {letters: planned(letters, Target.RAPID)[2].duration for letters in ("a", "ab", "abc")}
    written = planned("abc", Target.RAPID, written=True)[2].duration
    assert rapid["abc"] <= written + 1e-6
    assert planned("abc", Target.STREAM)[2].duration <= rapid["abc"] + 1e-6
    assert rapid["abc"] <= rapid["a"] * 1.05  # as fast on a program that asks for one axis; the others may idle


def test_axes_go_in_proportion_along_a_line() -> None:
    plant, _, plan = planned("abc", Target.RAPID)
    line = next(one for one in plan.motions if one.index == 1)
    part = (plan.trajectory.t >= line.t_0) & (plan.trajectory.t <= line.t_1)
    q = plan.trajectory.q[part]
    tool = plant.robot.forward(q)[:, :3, 3]
    s = np.linalg.norm(tool - tool[0], axis=1) / np.linalg.norm(tool[-1] - tool[0])
    np.testing.assert_allclose(q[:, :3], q[0, :3] + s[:, None] * (q[-1, :3] - q[0, :3]), atol=1e-6)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_judge_tells_an_axis_that_leaves_its_share(axis: int) -> None:
    plant, own, plan = planned("abc", Target.RAPID)
    line, rows = next(one for one in plan.motions if one.index == 1), plan.trajectory
    x = np.clip((rows.t - line.t_0) / (line.t_1 - line.t_0), 0, 1)
    q = np.array(rows.q)
    off = 0.02 * np.sin(np.pi * x) ** 2
    X = plant.robot.forward(q)
    q[:, axis] += off
    for i in np.flatnonzero(off > 0):  # the tool stays on its line
        arms = [arm for _, arm in plant.robot.solutions(X[i], q[i, :3], plant.limits)]
        q[i, 3:] = min(arms, key=lambda arm: np.abs(arm - q[i, 3:]).max())
    report = judged(own, plant, replace(rows, q=q, qd=None), Target.RAPID)
    told = [one for one in report.findings if one.check == "rail along line" and not one.passed]
    assert [one.subject for one in told] == [plant.limits.names[axis]]


def test_no_shift_of_several_axes_at_once_is_left_that_saves_time() -> None:
    """Where each axis alone gains nothing, two together do: 9 ms of 2.3 s here."""
    body = f"""ConfJ \\Off; ConfL \\Off;
MoveJ [[500,-100,400],{DOWN},[0,0,9E9,9E9,9E9,0]], v1000, fine, tool0;
MoveL [[1400,500,400],{DOWN},[900,400,9E9,9E9,9E9,900]], v2000, fine, tool0;
MoveL [[500,-100,300],{DOWN},[0,0,9E9,9E9,9E9,0]], v2000, fine, tool0;"""
    plant = gantry("ab")
    problem, axes = build_problem(program(plant, body), plant, target=Target.RAPID), Axes.of(plant)
    assert isinstance(problem, Problem)
    route = search(axes, problem)
    assert route is not None
    found = refine_rail(axes, problem, route)

    def time(q: Array) -> float:
        pairs = [Pairs(k, q[[k]], q[[k + 1]], found.labels[k + 1].cfx) for k in range(len(problem.legs))]
        return float(np.sum(leg_times(axes, problem, pairs, Times())))

    assert time(found.q) == pytest.approx(found.cost, abs=1e-6)
    for k, shift, step in product(range(1, 4), product((-1, 0, 1), repeat=2), (0.01, 0.03)):
        q, point = found.q.copy(), problem.waypoints[k]
        d = np.clip(q[k, :2] + step * np.array(shift), *point.ranges(problem.layout))
        arm = axes.branch(point.X_WF[None], d[None], np.array([found.labels[k].cfx]))[0]
        q[k] = np.r_[d, arm + 2 * np.pi * np.round((q[k, 2:] - arm) / (2 * np.pi))]
        if np.isfinite(q[k]).all() and axes.within(q[k]):
            assert time(q) > found.cost - 1e-4


def test_targets_of_a_plan_say_all_axes_and_what_follows() -> None:
    plant, own, plan = planned("abc", Target.RAPID)
    for index, intent in intents_of(own, plan, plant, frozenset()).items():
        end = next(one for one in plan.motions if one.index == index).q_1[:3] * 1e3
        assert intent.rail == pytest.approx((*end, end[0]), abs=1e-9)


LED = [Follower(5, 0), Follower(4, 1, -2.0, 0.1)]


@pytest.mark.parametrize("led", LED)
@pytest.mark.parametrize("digits", [17, 6])
def test_a_followers_column_is_held_against_its_leader(led: Follower, digits: int) -> None:
    plant, own, plan = planned("abc", Target.STREAM)
    plant = replace(plant, followers=(led,))
    head, *lines = export(plan, plant=plant)["joints.csv"].decode().splitlines()
    heads = head.split(",")
    place, speed = heads.index(f"{led.column} [m]"), heads.index(f"{led.column} speed [m/s]")
    assert heads[place - 1] == f"{plant.limits.names[led.leader]} [m]"
    table = np.array([line.split(",") for line in lines], float)
    leader = plan.trajectory.q[[0, -1], led.leader]
    np.testing.assert_allclose(table[[0, -1], place], led.ratio * leader + led.offset, atol=1e-15)

    def told(column: int | None = None, over: float = 0.0, order: slice = slice(None)) -> list[tuple[str, bool]]:
        rows = table.copy()
        if column is not None:
            rows[len(rows) // 2, column] += over
        body = [",".join(f"{x:.{digits}g}" for x in row) for row in rows]
        report = judge(plant, own, "\n".join([head, *body]) + "\n", "j.csv", advice=False)
        assert led != LED[0] or column is not None or digits < 17 or report.legal, report.violations
        return [(one.check, one.passed) for one in report.findings if one.subject == led.column]

    assert told()[:2] == [("follower", True), ("follower speed", True)]
    assert told(place, 1.1e-6 if digits == 17 else 6e-6)[:2] == [("follower", False), ("follower speed", True)]
    assert told(speed, -1.1e-5 if digits == 17 else -6e-5)[:2] == [("follower", True), ("follower speed", False)]


def test_columns_of_a_followers_file_stand_in_any_order() -> None:
    plant, own, plan = planned("abc", Target.STREAM)
    rows = plant.with_followers(plan.trajectory)
    assert rows.qd is not None
    turned = replace(rows, names=rows.names[::-1], q=rows.q[:, ::-1], qd=rows.qd[:, ::-1])
    assert judge(plant, own, write_csv_text(turned), "j.csv", advice=False).legal


def test_the_judge_tells_a_target_that_has_a_follower_apart() -> None:
    plant, own, plan = planned("abc", Target.RAPID)
    spoiled = program(plant, BODY.replace("50,9E9,9E9,400]]", "50,9E9,9E9,399]]", 1))
    for one, line in ((own, None), (spoiled, 5)):
        report = judged(one, plant, plan.trajectory, Target.RAPID)
        found = [f for f in report.findings if f.check == "follower in target"]
        assert {f.subject for f in found} == {"rail_f"}
        assert [f.source and f.source.line for f in found if not f.passed] == ([line] if line else [])


def test_a_text_whose_target_has_a_follower_apart_is_no_export() -> None:
    plant, own, plan = planned("abc", Target.RAPID)
    texts = export_rapid(own, plan, plant, frozenset()).texts
    read = read_again(own, plant, Scenario(), texts)
    assert [*mismatches(own, plan, plant, read)] == []
    i = next(i for i, one in enumerate(read.motions) if isinstance(one, MoveL))
    move = read.motions[i]
    assert isinstance(move, MoveL)
    assert move.extax[5] is not None
    apart = replace(move, extax=(*move.extax[:5], move.extax[5] + 1))
    spoiled = replace(read, motions=(*read.motions[:i], apart, *read.motions[i + 1 :]))
    assert len([*mismatches(own, plan, plant, spoiled)]) == 1


def test_a_follower_that_stands_apart_is_refused_with_its_place() -> None:
    plant = gantry()
    own = program(
        plant,
        BODY.replace("50,9E9,9E9,400]], v1000, fine, tool0;\nMoveJ", "50,9E9,9E9,399]], v1000, fine, tool0;\nMoveJ"),
    )
    with pytest.raises((InputError, InputErrorGroup)) as said:
        check_plannable(own, plant)
    assert "t.mod:5" in str(said.value)


@pytest.mark.long
def test_a_point_that_no_axis_brings_near_is_named() -> None:
    plant = gantry()
    own = program(plant, BODY.replace("[900,100,400]", "[900,3100,400]"))
    problem = build_problem(own, plant)
    assert isinstance(problem, Problem)
    out = check_reach(Axes.of(plant), problem)
    assert isinstance(out, Infeasible)
    assert out.index == 1


def test_held_axes_shift_what_is_seen() -> None:
    """With the others held the sought axis alone reaches the same places."""
    plant = gantry()
    problem = build_problem(program(plant), plant)
    assert isinstance(problem, Problem)
    rng = np.random.default_rng(2)
    q = np.hstack([rng.uniform(-0.1, 0.4, (len(problem.waypoints), 3)), np.zeros((len(problem.waypoints), 6))])
    axes = Axes.of(plant)
    for i in range(3):
        own = problem.seeking(i, q)
        for k in range(len(q)):
            seen = axes.seeking(i).inverse(own.seen(k)[None], q[k, [i]])
            np.testing.assert_allclose(seen, axes.inverse(problem.waypoints[k].X_WF[None], q[k, None, :3]), atol=1e-12)
        leg = own.legs[1]
        middle = axes.seeking(i).inverse(own.seen_along(leg, np.array([0.25])), (0.75 * q[1] + 0.25 * q[2])[[i]])
        X_WF = leg.segment.pose(np.array([0.25]))
        np.testing.assert_allclose(middle, axes.inverse(X_WF, (0.75 * q[1] + 0.25 * q[2])[None, :3]), atol=1e-12)
        assert own.seeking((i + 1) % 3, q).seeking(i).waypoints[2].ranges(own.layout)[0] == pytest.approx(q[2, :3])


def test_held_rails_stand_where_axes_have_them_and_the_sought_one_stays_free() -> None:
    problem = build_problem(program(gantry()), gantry())
    assert isinstance(problem, Problem)
    q = np.tile(np.r_[0.1, 0.2, 0.3, np.zeros(6)], (len(problem.waypoints), 1))
    free = problem.waypoints[1].ranges(problem.layout)
    held = problem.seeking(1).with_rails_held(q)
    low, high = held.waypoints[1].ranges(held.layout)
    assert low == pytest.approx([0.1, free[0][1], 0.3])
    assert high == pytest.approx([0.1, free[1][1], 0.3])
