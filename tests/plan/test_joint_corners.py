"""Corners where tool or work object change, and between turns in place, planned whole: on the ways outside the zones,
going over in the axes inside, and legal."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.geometry import Array, inverse_pose, pose
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import FlyBy, MoveL, Program
from trajopt_cli.path_timing.sampled_path import sample_path
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectory import Trajectory, hermite

DATA = """PERS tooldata a:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
PERS tooldata b:=[TRUE,[[30,0,140],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
PERS wobjdata w:=[FALSE,TRUE,"",[[400,Y,350],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
PERS wobjdata v:=[FALSE,TRUE,"",[[400,Y,350],[0.984807753,0,0,0.173648178]],[[0,0,0],[1,0,0,0]]];"""
X_FA, X_FB = pose(np.eye(3), [0, 0, 0.1]), pose(np.eye(3), [0.03, 0, 0.14])
FREE = "[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]"
RAIL = "600,9E9,9E9,9E9,9E9,9E9"
BESIDE = {  # what follows the first line, of 60 mm, in a zone of 20 mm
    "tool": "MoveL [[90,60,20],[0,0,1,0],[0,0,0,0],[RAIL]], v200, fine, b\\WObj:=w;",
    "work object": "MoveL [[90,60,20],[0,0,1,0],[0,0,0,0],[RAIL]], v200, fine, a\\WObj:=v;",
    "neither": "MoveL [[90,60,20],[0,0,1,0],[0,0,0,0],[RAIL]], v200, fine, a\\WObj:=w;",
}


@cache
def planned(changes: str, rail: bool = False) -> tuple[Program, Plant, Plan]:
    start = "MoveJ [[0,0,0],[0,0,1,0],[0,0,0,0],[RAIL]], v500, fine, a\\WObj:=w;"
    line = "MoveL [[0,60,0],[0,-0.258819045,0.965925826,0],[0,0,0,0],[RAIL]], v200, z20, a\\WObj:=w;"  # turns by 30 deg
    body = "\n".join(["ConfJ\\Off; ConfL\\Off;", start, line, BESIDE[changes]])
    body = body.replace("RAIL", RAIL)
    if rail:
        body = body.replace("[[90,60,20],[0,0,1,0],[0,0,0,0],[600", "[[90,60,20],[0,0,1,0],[0,0,0,0],[650")
    program = rapid(body, data=DATA.replace("Y", "600" if rail else "0"))
    plant = plant_with_rail() if rail else plant_without_rail()
    plan = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    return program, plant, plan


@pytest.mark.parametrize("target", [Target.STREAM, Target.RAPID])
def test_a_tool_far_beside_the_one_that_turns_comes_in_and_goes_on(target: Target) -> None:
    """The first tool turns by 90 deg over its 60 mm; the other one, 200 mm beside it, is farther from its point than
    the zone reaches when the corner begins. Legal in full, at 250 Hz and at 50 Hz without speeds."""
    turned = BESIDE["tool"].replace("0,0,1,0", TURNED)
    line = f"MoveL [[0,60,0],[{TURNED}],[0,0,0,0],[RAIL]], v200, z20, a\\WObj:=w;"
    start = "MoveJ [[0,0,0],[0,0,1,0],[0,0,0,0],[RAIL]], v500, fine, a\\WObj:=w;"
    body = "\n".join(["ConfJ\\Off; ConfL\\Off;", start, line, turned]).replace("RAIL", RAIL)
    program, plant = rapid(body, data=DATA.replace("Y", "0").replace("30,0,140", "200,0,140")), plant_without_rail()
    plan = optimize(program, plant, target, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan)
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert [f.message for f in report.findings if not f.passed] == []
    for step in (0.004, 0.02):
        t = np.append(np.arange(0, plan.duration, step), plan.duration)
        rows = Trajectory(plan.trajectory.names, t, hermite(plan.trajectory, t)[0])
        report = verify(program, plant, rows, target=target, advice=False)
        assert [f.message for f in report.findings if not f.passed] == []


TURNED = "0,-0.707106781,0.707106781,0"


def flange(plant: Plant, plan: Plan, n: int = 4001) -> tuple[Array, Array, Array]:
    t = np.linspace(0, plan.duration, n)
    q = hermite(plan.trajectory, t)[0]
    return t, q, plant.robot.forward(q)


@pytest.mark.parametrize("rail", [False, True])
@pytest.mark.parametrize("changes", ["tool", "work object"])
def test_axes_go_over_in_a_corner_where_the_coordinate_system_changes(changes: str, rail: bool) -> None:
    """Before the zone the first tool is on the first line, behind it the second tool on the second; between, both leave
    their lines and no axis stops."""
    program, plant, plan = planned(changes, rail)
    first, second = (motion for motion in program.motions if isinstance(motion, MoveL))
    t, _, X_WF = flange(plant, plan)
    end = {motion.index: motion.t_1 for motion in plan.motions}
    X_then = X_FB if changes == "tool" else X_FA
    P_0 = np.array([0.4, 0.6 if rail else 0.0, 0.35])
    P_1 = P_0 + np.array([0, 0.06, 0])
    point = first.X_WT @ inverse_pose(X_FA) @ X_then
    Q_0, Q_1 = point[:3, 3], second.X_WT[:3, 3]
    for X_FT, a, b, at in ((X_FA, P_0, P_1, P_1), (X_then, Q_0, Q_1, Q_0)):
        tool = (X_WF @ X_FT)[:, :3, 3]
        beside = t <= end[1] if at is P_1 else t >= end[1]
        beside &= t >= end[0]
        away = np.linalg.norm(tool - at, axis=1)
        along = (b - a) / np.linalg.norm(b - a)
        off = np.linalg.norm(np.cross(tool - a, along), axis=1)
        assert off[beside & (away > 0.0201)].max() < 2e-6
        assert away[beside].min() < 0.019
        assert off[beside & (away < 0.0195)].max() > 1e-4
    report = verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False)
    assert [f.message for f in report.findings if not f.passed] == []
    assert np.abs(hermite(plan.trajectory, np.array([end[1]]))[1]).max() > 0.05


def test_the_judge_tells_tools_and_frames_apart() -> None:
    """The motion with another tool is not legal for the program without, nor the other way round; nor is the joint
    interpolated corner where the frame stays, which leaves the triangle of the zone."""
    for one, other in (("tool", "neither"), ("neither", "tool"), ("work object", "neither")):
        _, plant, plan = planned(one)
        report = verify(planned(other)[0], plant, plan.trajectory, target=Target.RAPID, advice=False)
        assert not report.legal, (one, other)


TURNS = (("", "z50"), ("\\Rx:=25", "fine"))


@pytest.mark.long
@pytest.mark.parametrize("target", [Target.STREAM, Target.RAPID])
def test_turns_in_place_go_over_into_each_other_by_the_degrees_of_their_zone(target: Target) -> None:
    """z50: 7.5 deg before the point the second turn begins; the centre point stands all the while."""
    turns = [f"MoveL RelTool(p_in,0,0,0\\Rz:=30{more}), v200, {zone}, tool0;" for more, zone in TURNS]
    program = rapid("\n".join(["ConfJ\\Off; ConfL\\Off;", "MoveJ p_in, v500, fine, tool0;", *turns]))
    plant = plant_with_rail()
    plan = optimize(program, plant, target, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan)
    t, _, X_WT = flange(plant, plan)
    end = {motion.index: motion.t_1 for motion in plan.motions}
    X_0, X_1, X_2 = (motion.X_WT for motion in program.motions)
    turning = t >= end[0]
    assert np.linalg.norm(X_WT[turning, :3, 3] - X_0[:3, 3], axis=1).max() < 2e-6
    R = Rotation.from_matrix(X_WT[:, :3, :3])
    away = (R.inv() * Rotation.from_matrix(X_1[:3, :3])).magnitude()
    for a, b, beside in ((X_0, X_1, turning & (t <= end[1])), (X_1, X_2, t >= end[1])):
        slerp = Slerp([0, 1], Rotation.from_matrix([a[:3, :3], b[:3, :3]]))(np.linspace(0, 1, 400))
        apart = np.array([(slerp.inv() * one).magnitude().min() for one in R[beside][::8]])
        outside = away[beside][::8] > np.radians(7.6)
        assert apart[outside].max() < 1e-3
        assert apart[~outside].max() > 5e-3
    assert away.min() > np.radians(2)
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert [f.message for f in report.findings if not f.passed] == []
    first, turn, last = program.motions
    assert isinstance(turn, MoveL)
    smaller = replace(turn, zone=replace(turn.zone, ori=np.radians(2)))
    narrow = replace(program, motions=(first, smaller, last))
    assert not verify(narrow, plant, plan.trajectory, target=target, advice=False).legal


@pytest.mark.parametrize("gap", [1.5e-9, 5e-6])
def test_zones_that_all_but_meet_leave_no_sliver_between_them(gap: float) -> None:
    """Of a line of 17 mm with zones of half of it, or of a hair less: 1.5 nm of way between them are none, 5 um are."""
    places = (60, 0, "z10"), (60, 17, "z10"), (77, 17, "fine")
    lines = [f"MoveL Offs(p_in,{x},{y},0), v300, {zone}, tool0;" for x, y, zone in places]
    program, plant = rapid("\n".join(["MoveJ p_in, v500, fine, tool0;", *lines])), plant_with_rail()
    problem, axes = problem_of(program, plant, Target.RAPID, AS_WRITTEN), Axes.of(plant)
    less = FlyBy(*(0.0085 - gap,) * 3)
    points = tuple(replace(one, fly_by=less) if k == 3 else one for k, one in enumerate(problem.waypoints))
    q = [axes.layout.join(0.6, axes.inverse(point.X_WF[None], np.array([0.6]))[0, 0]) for point in points]
    path = sample_path(axes, replace(problem, waypoints=points), (1, 4), np.array(q), [0] * 5, 40)
    assert path is not None
    sizes = [part.size for part in path.parts if part.leg == 2]
    assert len(sizes) == (2 if gap < 1e-6 else 3)
    assert sum(sizes) == pytest.approx(0.017, rel=1e-9)


@pytest.mark.parametrize(("off", "tool"), [(3e-4, "a"), (2e-3, "a"), (2e-3, "b")])
def test_a_turn_whose_point_is_rounded_is_driven_in_its_zones(off: float, tool: str) -> None:
    """Points of one place that digits put 0.3 or 2 um apart: turns in place whose zones count degrees, or ways with
    zones of half of them, in which another tool may come in."""
    turns = [Rotation.from_euler("yx", (180, angle), degrees=True).as_quat() for angle in (0, 6, 14)]
    places = (0, 0, "z20"), (0, off, "z20"), (off, off, "fine")
    lines = [
        "ConfJ\\Off; ConfL\\Off;",
        f"MoveJ [[0,-30,0],[0,0,1,0],{FREE}], v500, z10, a\\WObj:=w;",
    ]
    for (x, y, zone), (b, c, d, a), one in zip(places, turns, ("a", tool, "a"), strict=True):
        shift = [30, 0, 40] if one == "b" else [0, 0, 0]  # where the other tool stands meanwhile
        p = Rotation.from_quat((b, c, d, a)).apply(shift) + np.array([x, y, 0])
        place, turn = (",".join(f"{value:.9f}" for value in values) for values in (p, (a, b, c, d)))
        lines.append(f"MoveL [[{place}],[{turn}],{FREE}], v100, {zone}, {one}\\WObj:=w;")
    program, plant = rapid("\n".join(lines), data=DATA.replace("Y", "0")), plant_without_rail()
    plan = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    assert verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False).legal


def test_an_arc_in_the_spheres_of_two_zones_in_which_tools_change_need_not_be_gone_around() -> None:
    """Arc of 5 mm on a radius of 5 mm, both its zones 2.495 mm: 0.01 mm lie outside them along it, none off their
    spheres, which hold 2 r asin(2.495 / 2 r) = 2.52 mm of it each."""
    zone = "[FALSE,2.495,2.495,2.495,10,10,10]"
    via, end = (5 - 5 * np.cos(one) for one in (0.5, 1.0)), (5 * np.sin(one) for one in (0.5, 1.0))
    (x_0, x_1), (y_0, y_1) = via, end
    over, turn = f"[0,0,1,0],{FREE}", np.array([-30.0, 0.0, 40.0])
    other = [f"[[{x + turn[0]:.6f},{y:.6f},{-turn[2]:.6f}],{over}]" for x, y in ((x_0, y_0), (x_1, y_1))]
    lines = [
        "ConfJ\\Off; ConfL\\Off;",
        f"MoveJ [[0,-40,0],{over}], v500, fine, a\\WObj:=w;",
        f"MoveL [[0,0,0],{over}], v500, {zone}, a\\WObj:=w;",
        f"MoveC {other[0]}, {other[1]}, v500, {zone}, b\\WObj:=w;",
        f"MoveL [[30,30,0],{over}], v500, fine, a\\WObj:=w;",
    ]
    program, plant = rapid("\n".join(lines), data=DATA.replace("Y", "0")), plant_without_rail()
    plan = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    report = verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False)
    assert [f.message for f in report.findings if not f.passed] == []
