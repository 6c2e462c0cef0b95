"""How soon the tool can be there, against closed forms; the programs' own speeds in the lower bound."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from small_cells import HOME, plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.bound.lower_bound import lower_bound
from trajopt_cli.bound.tcp_time_bound import TcpPart, parts_time, tool_time
from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import FlyBy
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.line import Line
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg, LegKind, Problem, Waypoint
from trajopt_cli.trajectories.axes import Axes

A_TCP = 2.0  # m/s2
GRIP = "PERS tooldata grip:=[TRUE,[[0,80,120],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
THERE = np.radians([25, 8, -8, 10, 40, 15])


def joint_problem(speed: str, target: Target = Target.STREAM, plant: Plant | None = None) -> Problem:
    joints = ",".join(repr(float(x)) for x in np.degrees(THERE))
    data = f"{GRIP} CONST jointtarget j_there:=[[{joints}],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    program = rapid(f"MoveAbsJ j_there, {speed}, fine, grip;", data=data)
    return problem_of(program, plant or plant_without_rail(), target)


def grip_way() -> float:
    robot = plant_without_rail().robot
    tool = np.array([0, 0.08, 0.12, 1])
    return float(np.linalg.norm((robot.forward(THERE) - robot.forward(HOME)) @ tool))


def bound_of(problem: Problem) -> float:
    return lower_bound(Axes.of(problem.plant), problem, 100.0)


@pytest.mark.parametrize("target", Target)
@pytest.mark.parametrize("speed", [0.03, 0.05, 0.1])
def test_a_slow_joint_move_takes_its_chord_at_the_programmed_speed(target: Target, speed: float) -> None:
    plant = plant_without_rail(tcp=TcpCaps(2.5, A_TCP))
    bound = bound_of(joint_problem(f"v{speed * 1e3:.0f}", target, plant))
    assert bound >= grip_way() / speed + speed / A_TCP - 1e-9
    if target is Target.STREAM:
        assert bound == pytest.approx(grip_way() / speed + speed / A_TCP, abs=1e-9)


def test_a_cell_that_frees_joint_moves_frees_the_bound() -> None:
    slow, free = (joint_problem("v50", plant=plant_without_rail(free_speed=free)) for free in (False, True))
    assert bound_of(free) < 0.2 * bound_of(slow)


def test_the_bound_falls_as_the_programmed_speed_rises() -> None:
    bounds = [bound_of(joint_problem(speed)) for speed in ("v30", "v50", "v100", "v200", "v500", "v2500")]
    assert bounds == sorted(bounds, reverse=True)
    assert bounds[0] > 10 * bounds[-1]


def test_a_slow_rail_of_the_program_holds_for_joint_moves_and_not_for_their_programmed_time() -> None:
    """v_leax of 100 mm/s over 0.3 m; with \\T the rail has its own limits: a triangle at 3 m/s2."""
    speed = "CONST speeddata slow:=[2500,500,100,1000];"
    data = f"{speed} CONST jointtarget j_there:=[[0,0,0,0,30,0],[300,9E9,9E9,9E9,9E9,9E9]];"
    problem = problem_of(rapid("MoveAbsJ j_there, slow, fine, tool0;", data=data), plant_with_rail())
    assert bound_of(problem) == pytest.approx(3.0 + 0.1 / 3, abs=1e-7)
    timed = replace(problem, legs=(replace(problem.legs[0], duration=0.1),))
    assert bound_of(timed) == pytest.approx(2 * np.sqrt(0.3 / 3), abs=1e-7)
    assert bound_of(replace(problem, legs=(replace(problem.legs[0], duration=2.0),))) == pytest.approx(2.0, abs=1e-9)


# ---- ways given by hand


def way(
    poses: list[Array],
    radii: list[float],
    kinds: list[LegKind] | None = None,
    segments: dict[int, Arc] | None = None,
    **leg: float | None,
) -> Problem:
    """Lines (or joint moves) from pose to pose [m, rad] at 0.5 m/s; radii: of the zones at the poses between."""
    base = joint_problem("v500")
    caps = {"v_tcp": 0.5, "a_tcp": A_TCP, "v_ori": np.inf, "v_rail": np.inf, **leg}
    zones = [None, *(FlyBy(r, r, r) if r > 0 else None for r in radii), None]
    waypoints = [Waypoint(k - 1, X, None, (0, 0), 0.0, True, fly_by=zones[k]) for k, X in enumerate(poses)]
    legs = []
    for k, (a, b) in enumerate(pairwise(poses)):
        kind = LegKind.LINE if kinds is None else kinds[k]
        segment = (segments or {}).get(k, Line(a, b)) if kind is LegKind.LINE else None
        legs.append(Leg(k, kind, k, np.eye(4), segment=segment, **caps))
    return replace(base, waypoints=tuple(waypoints), legs=tuple(legs))


def at(*p: float, turn: float = 0.0) -> Array:
    return pose(rotation_about([0, 0, 1], turn), p)


def trapezoid(D: float, v: float) -> float:
    return D / v + v / A_TCP if v * v < D * A_TCP else 2 * float(np.sqrt(D / A_TCP))


@pytest.mark.parametrize("D", [0.02, 0.9])
def test_a_line_is_a_trapezoid(D: float) -> None:
    assert tool_time(way([at(0, 0, 0), at(0, D, 0)], []), 0, 1) == pytest.approx(trapezoid(D, 0.5), abs=1e-12)


def test_a_line_that_turns_slowly_takes_its_turn() -> None:
    """1.2 rad at 0.4 rad/s on 0.3 m: 3 s at 0.1 m/s."""
    problem = way([at(0, 0, 0), at(0, 0.3, 0, turn=1.2)], [], v_ori=0.4)
    assert tool_time(problem, 0, 1) == pytest.approx(3.0 + 0.1 / A_TCP, abs=1e-9)


def test_a_turn_on_the_spot_takes_its_angle() -> None:
    assert tool_time(way([at(0, 0, 0), at(0, 0, 0, turn=1.2)], [], v_ori=0.4), 0, 1) == pytest.approx(3.0, abs=1e-9)


def test_a_joint_move_takes_its_turn() -> None:
    problem = way([at(0, 0, 0), at(0, 0.3, 0, turn=1.2)], [], [LegKind.JOINT], v_ori=0.4)
    assert tool_time(problem, 0, 1) == pytest.approx(3.0, abs=1e-9)


@pytest.mark.parametrize(("radius", "speed"), [(0.5, 0.5), (0.05, np.sqrt(0.05 * A_TCP))])
def test_a_narrow_arc_is_no_faster_than_its_bend_allows(radius: float, speed: float) -> None:
    arc = Arc.through(at(radius, 0, 0), np.array([0, radius, 0]), at(-radius, 0, 0))
    problem = way([arc.X_0, arc.X_1], [], segments={0: arc})
    assert tool_time(problem, 0, 1) == pytest.approx(trapezoid(np.pi * radius, speed), abs=1e-9)


def test_a_programmed_time_is_the_least_and_replaces_the_programmed_speed() -> None:
    """0.3 m in 0.5 s, though 0.01 m/s would be 30 s."""
    poses = [at(0, 0, 0), at(0, 0.3, 0)]
    assert tool_time(way(poses, [], v_tcp=0.01, duration=1.5), 0, 1) == pytest.approx(1.5, abs=1e-12)
    short = tool_time(way(poses, [], v_tcp=0.01, duration=0.5), 0, 1)
    assert short == pytest.approx(2 * np.sqrt(0.3 / A_TCP), abs=1e-12)


# ---- points that are passed

ANGLE = [at(0, 0, 0), at(0.2, 0, 0), at(0.2, 0.2, 0)]


@pytest.mark.parametrize("r", [1e-6, 0.03, 0.1])
def test_a_right_angle_is_cut_across_its_zone_and_no_further(r: float) -> None:
    D = 2 * (0.2 - r) + r * np.sqrt(2)
    assert tool_time(way(ANGLE, [r]), 0, 2) == pytest.approx(trapezoid(D, 0.5), abs=1e-12)


def test_every_speed_holds_on_its_own_leg_outside_the_zone() -> None:
    problem = way(ANGLE, [0.05])
    slow = replace(problem.legs[1], v_tcp=0.05)
    time = tool_time(replace(problem, legs=(problem.legs[0], slow)), 0, 2)
    least = 0.15 / 0.5 + 0.05 * np.sqrt(2) / 0.5 + 0.15 / 0.05
    assert least < time <= least + 0.05 / A_TCP + 1e-12


def test_of_a_joint_move_beside_a_zone_nothing_counts_but_the_chord_outside_it() -> None:
    problem = way(ANGLE, [0.05], [LegKind.LINE, LegKind.JOINT])
    assert tool_time(problem, 0, 2) == pytest.approx(trapezoid(0.15 + 0.15, 0.5), abs=1e-12)


def shorter_ways(poses: list[Array]) -> list[float]:
    """The shorter way beside each pose between."""
    ways = [float(np.linalg.norm(b[:3, 3] - a[:3, 3])) for a, b in pairwise(poses)]
    return [min(pair) for pair in pairwise(ways)]


def random_way(rng: np.random.Generator, turning: float) -> tuple[list[Array], list[float]]:
    """Poses a few centimetres apart, and zones that reach half the shorter way beside them at most."""
    poses = [at(*rng.uniform(-0.1, 0.1, 3), turn=rng.uniform(-turning, turning)) for _ in range(5)]
    return poses, [rng.uniform(0.05, 0.5) * w for w in shorter_ways(poses)]


@pytest.mark.parametrize("seed", range(20))
def test_no_parabolic_corners_beat_it(seed: int) -> None:
    """The ways and corners at their caps of speed and turning all along, with one run-up and one run-down, are faster
    than any legal motion along them; the corners are those of the path room, which the bound does not know."""
    rng = np.random.default_rng(seed)
    poses, radii = random_way(rng, 1.5)
    wide = [rng.uniform(r, w / 2) for r, w in zip(radii, shorter_ways(poses), strict=True)]
    v, v_ori = rng.uniform(0.05, 1.0), rng.uniform(0.5, 6.0)
    problem = way(poses, radii, v_tcp=v, v_ori=v_ori)
    problem = replace(
        problem,
        waypoints=tuple(
            w if w.fly_by is None else replace(w, fly_by=FlyBy(radii[k - 1], wide[k - 1], wide[k - 1]))
            for k, w in enumerate(problem.waypoints)
        ),
    )
    lines = [Line(a, b) for a, b in pairwise(poses)]
    corners = [Corner.of_zone(*beside, r, o) for beside, r, o in zip(pairwise(lines), radii, wide, strict=True)]
    s = np.linspace(0, 1, 2001)
    time = 0.0
    for i, line in enumerate(lines):
        ends = [0.0 if not 0 <= k < len(wide) else wide[k] for k in (i - 1, i)]
        share = 1 - sum(ends) / line.length
        time += share * max(line.length / v, line.angle / v_ori)
    for corner in corners:
        rate = corner.twist(s)
        pace = np.maximum(np.linalg.norm(rate[:, :3], axis=1) / v, np.linalg.norm(rate[:, 3:], axis=1) / v_ori)
        time += float(np.sum((pace[1:] + pace[:-1]) / 2 * np.diff(s)))
    assert tool_time(problem, 0, 4) <= time + v / A_TCP + 1e-9
    assert tool_time(problem, 0, 4) > 0.5 * time


@pytest.mark.parametrize("seed", range(10))
def test_a_larger_zone_is_never_slower_and_a_stop_never_faster(seed: int) -> None:
    rng = np.random.default_rng(seed)
    poses, radii = random_way(rng, 1.0)
    times = [tool_time(way(poses, [f * r for r in radii], v_ori=1.0), 0, 4) for f in (0.01, 0.3, 0.7, 1.0)]
    assert times == sorted(times, reverse=True)
    stops = way(poses, [0.0] * 3, v_ori=1.0)
    assert times[0] < sum(tool_time(stops, k, k + 1) for k in range(4))


def test_turns_in_place_are_passed_by_the_degrees_of_their_zones() -> None:
    """20 and 15 deg about one axis, 6 deg of either in the corner: nothing is cut off; about axes at a right angle the
    corner turns from edge to edge, at 100 deg/s."""
    speed = "CONST speeddata slow:=[200,100,100,1000]; CONST zonedata z6:=[FALSE,50,75,75,6,75,6];"
    for axis in ("Rz", "Rx"):
        turn = "MoveL RelTool(p_in,0,0,0\\Rz:=20), slow, z6, tool0;"
        last = "MoveL RelTool(RelTool(p_in,0,0,0\\Rz:=20),0,0,0\\AXIS:=15), slow, fine, tool0;".replace("AXIS", axis)
        program = rapid("\n".join(["MoveJ p_in, v500, fine, tool0;", turn, last]), data=speed)
        problem = problem_of(program, plant_with_rail())
        across = 12.0 if axis == "Rz" else 2 * np.degrees(np.arccos(np.cos(np.radians(3)) ** 2))
        assert tool_time(problem, 1, 3) == pytest.approx((14 + 9 + across) / 100, abs=1e-6)


def test_another_tool_need_not_run_up() -> None:
    """A metre at 1 m/s and 1 m/s2 and another one: with one tool a ramp at either end."""
    ways = [TcpPart(1.0, 1.0), TcpPart(0.0, 1.0), TcpPart(1.0, 1.0)]
    assert parts_time(ways, 1.0, 1.0) == pytest.approx(3.0)
    assert parts_time([replace(one, jump=one.length == 0) for one in ways], 1.0, 1.0) == pytest.approx(2.0)
