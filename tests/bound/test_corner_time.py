"""The least time through corners: closed forms of tool and joints, motions along arcs that fit, and legal plans."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.bound.corner_time import corner_time
from trajopt_cli.bound.lower_bound import lower_bound
from trajopt_cli.bound.tcp_time_bound import tool_time
from trajopt_cli.geometry import Array, pose
from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import FlyBy
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.line import Line
from trajopt_cli.path.segment import Segment
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg, LegKind, Problem, Waypoint
from trajopt_cli.table import told_gap
from trajopt_cli.trajectories.axes import Axes

A_TCP = 2.0  # m/s2


def through(segments: list[Segment], radii: list[float], v: float, a: float, plant: Plant) -> Problem:
    """Segments one after the other, from rest to rest; radii [m]: of the zones between them."""
    base = problem_of(rapid("MoveAbsJ j_home, v2500, fine, tool0;"), plant)
    zones = [None, *(FlyBy(r, r, r) for r in radii), None]
    poses = [segments[0].pose(np.zeros(1))[0], *(one.pose(np.ones(1))[0] for one in segments)]
    points = [Waypoint(k - 1, X, None, (0, 0), 0.0, True, fly_by=zones[k]) for k, X in enumerate(poses)]
    legs = [Leg(k, LegKind.LINE, k, np.eye(4), v, a, np.inf, np.inf, segment=one) for k, one in enumerate(segments)]
    return replace(base, waypoints=tuple(points), legs=tuple(legs))


def lines(points: Array, radii: list[float], v: float) -> Problem:
    """Lines between points (n, 3), by a tool that an arm on a rail carries: nobody knows where its joints are."""
    ways = [Line(pose(np.eye(3), a), pose(np.eye(3), b)) for a, b in pairwise(points)]
    return through(list(ways), radii, v, A_TCP, plant_with_rail(tcp=TcpCaps(5.0, A_TCP)))


def least(problem: Problem) -> float:
    return corner_time(Axes.of(problem.plant), problem, 0, len(problem.legs))


def trapezoid(D: float, v: float, a: float) -> float:
    return D / v + v / a if v * v < D * a else 2 * float(np.sqrt(D / a))


@pytest.mark.parametrize(("D", "r", "v"), [(1.0, 0.1, 5.0), (0.4, 0.2, 5.0), (1.0, 0.1, 0.3)])
def test_out_and_back_the_tool_rests_where_the_zone_begins(D: float, r: float, v: float) -> None:
    """Whatever it does in the zone, it comes by its edge forwards and then backwards: at best with a rest there."""
    found = least(lines(np.array([[0, 0, 0], [D, 0, 0], [0, 0, 0.0]]), [r], v))
    exact = 2 * trapezoid(D - r, v, A_TCP)
    assert exact - 4 * v / 40 / A_TCP < found <= exact + 1e-6


def test_out_and_back_about_joint_1_it_rests_where_the_zone_begins() -> None:
    """A tool that turns about the arm's first axis and back, 0.8 rad but for a zone of 0.1 rad: joint 1 alone."""
    plant = plant_without_rail()
    ends = [plant.robot.forward(np.array([q, 0.1, 0, 0, np.pi / 6, 0])) for q in (-0.4, 0.0, 0.4)]
    out, back = (Arc.through(a, ends[1][:3, 3], b) for a, b in (ends[::2], ends[::-2]))
    zone = 0.1 * out.radius
    V, A = plant.limits.velocity[0], plant.limits.most_acceleration[0]
    found = least(through([out, back], [zone], 2.0, 1e3, plant))
    exact = 2 * trapezoid(0.7, V, A)
    assert exact - 4 * V / 40 / A < found <= exact + 1e-6


def test_no_tool_that_rounds_a_corner_on_the_arc_that_fits_is_faster() -> None:
    """From rest to the zone's edge, round the arc that touches both lines there at the speed it allows, and to rest."""
    rng, shares = np.random.default_rng(4), []
    for _ in range(60):
        D, v, phi = rng.uniform(0.2, 1.0, 2), rng.uniform(0.3, 3.0), rng.uniform(0.3, 2.8)
        r = rng.uniform(0.05, 0.5) * min(D)
        points = np.array([[0, 0, 0], [D[0], 0, 0], [D[0] + D[1] * np.cos(phi), D[1] * np.sin(phi), 0]])
        bend = r / np.tan(phi / 2)
        top = min(v, np.sqrt(A_TCP * bend), *np.sqrt(2 * A_TCP * (D - r)))
        ramps = 0.0
        for way in D - r:  # to the top or back to the arc's speed, and on to rest
            peak = min(v, np.sqrt(A_TCP * way + top * top / 2))
            ramps += (2 * peak - top) / A_TCP + (way - (peak * peak - top * top / 2) / A_TCP) / peak
        legal = ramps + bend * phi / top
        problem = lines(points, [r], v)
        found = max(least(problem), tool_time(problem, 0, 2))
        assert found <= legal + 1e-6
        shares.append(found / legal)
    assert np.median(shares) > 0.9


def test_a_corner_in_which_the_velocity_hardly_turns_is_left_to_the_way_alone() -> None:
    assert least(lines(np.array([[0, 0, 0], [1, 0, 0], [2, 0.01, 0]]), [0.1], 0.5)) == 0.0


def text_of(seed: int) -> str:
    """Lines, joint moves and reorientations in front of a robot without a rail, through zones of all sizes."""
    rng, moves = np.random.default_rng(seed), []
    for i in range(6):
        x, y, z = rng.uniform([420, -250, 250], [540, 250, 450])
        half = rng.uniform(-0.2, 0.2) if seed % 2 else 0.0
        zone = "fine" if i in (0, 5) else rng.choice(["z1", "z10", "z50", "z200"])
        kind, speed = ("MoveJ" if i == 0 or rng.random() < 0.2 else "MoveL"), rng.choice(["v500", "v5000", "vmax"])
        target = f"[[{x:.2f},{y:.2f},{z:.2f}],[0,{np.sin(half):.7f},{np.cos(half):.7f},0],[0,0,0,0],"
        moves.append(f"{kind} {target}[9E9,9E9,9E9,9E9,9E9,9E9]], {speed}, {zone}, tool0;")
    return "\n".join([*moves, "MoveAbsJ j_home, v2500, fine, tool0;"])


@pytest.mark.long
@pytest.mark.parametrize("seed", range(8))
def test_no_stretch_of_a_legal_plan_is_faster(seed: int) -> None:
    program, plant = rapid(text_of(seed)), plant_without_rail()
    target = Target.STREAM if seed == 2 else Target.RAPID
    plan = optimize(program, plant, target, bounded=False)
    assert isinstance(plan, Plan)
    problem = problem_of(program, plant, target)
    axes, ends = Axes.of(plant), [0.0, *(motion.t_1 for motion in plan.motions)]
    for first, last in problem.runs:
        assert corner_time(axes, problem, first, last) <= ends[last] - ends[first] + 1e-6
    bound = lower_bound(axes, problem, 2 * plan.duration)
    assert 0.75 * plan.duration < bound <= plan.duration


def test_a_gap_that_says_little_is_no_percentage() -> None:
    assert "12.3 %" in told_gap(0.123)
    assert "%" not in told_gap(0.51)
