"""How fast paths are driven: closed forms where there are any, and every limit between the nodes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import beta
from small_cells import plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.search import search
from trajopt_cli.limits import TcpCaps
from trajopt_cli.path_timing.path_timing import time_path
from trajopt_cli.path_timing.sampled_path import sample_path
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import Pieces

OPEN, RAIL = "9E9", "600"
DATA = """CONST robtarget p_a:=[[500,{y},450],[0,0,1,0],[0,0,0,0],[{rail},9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_b:=[[540,{y},390],[0,0.1,0.99,0.1],[0,0,0,0],[{rail},9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_c:=[[480,{y},360],[0,0,1,0],[0,0,0,0],[{far},9E9,9E9,9E9,9E9,9E9]];
CONST zonedata z_t:=[FALSE,12,18,25,9E9,9E9,9E9];"""
TO = "MoveJ p_a, v1000, fine, tool0;\n"
MIXED = {
    "line, line": "MoveL p_b, v500, z_t, tool0;\nMoveL p_c, v300, fine, tool0;",
    "arc": "MoveC p_b, p_c, v2500, fine, tool0;",
    "line, arc": "MoveL p_c, v1000, z_t, tool0;\nMoveC p_b, p_a, v300, fine, tool0;",
    "joints, line": "MoveJ p_b, v2500, z_t, tool0;\nMoveL p_c, v2500, fine, tool0;",
    "line, joints": "MoveL p_b, v2500, z_t, tool0;\nMoveJ p_c, v500, fine, tool0;",
    "joints": "MoveJ p_b, v100, z_t, tool0;\nMoveJ p_c, v2500, z_t, tool0;\nMoveJ p_a, v2500, fine, tool0;",
}


def strong(speed: float, acceleration: float) -> Plant:
    """An arm so strong that the caps of the tool alone count."""
    plant = plant_without_rail(tcp=TcpCaps(speed, acceleration))
    limits = plant.limits
    return replace(
        plant, limits=replace(limits, velocity=limits.velocity * 100, acceleration=limits.acceleration * 1000)
    )


def driven(body: str, plant: Plant, nodes: int = DEFAULT.run_nodes) -> tuple[Axes, Problem, dict[int, Pieces]]:
    """The motions of the run behind the approach."""
    rail = plant.robot.has_rail
    data = DATA.format(y=600 if rail else 100, rail=RAIL if rail else OPEN, far="650" if rail else OPEN)
    problem = problem_of(rapid(TO + body, data=data), plant, Target.RAPID, AS_WRITTEN)
    problem = replace(problem, waypoints=tuple(replace(point, conf=None) for point in problem.waypoints))
    axes = Axes.of(plant)
    route = search(axes, replace(problem, waypoints=tuple(replace(one, fly_by=None) for one in problem.waypoints)))
    assert route is not None
    path = sample_path(axes, problem, problem.runs[-1], route.q, [label.cfx for label in route.labels], nodes)
    assert path is not None
    found = time_path(axes, problem, path)
    assert found is not None
    return axes, problem, found


def time_of(body: str, plant: Plant, nodes: int = DEFAULT.run_nodes) -> float:
    return sum(motion.T for motion in driven(body, plant, nodes)[2].values())


@pytest.mark.parametrize(("speed", "way"), [(500, 0.08), (2500, 0.08), (100, 0.003)])
def test_a_line_under_the_tools_caps_alone_takes_its_trapezoid(speed: float, way: float) -> None:
    """D/v + v/a where the speed is reached, 2 sqrt(D/a) where not; a hair of every limit stays free."""
    v, a = speed * 1e-3, 20.0
    wanted = way / v + v / a if way * a > v * v else 2 * np.sqrt(way / a)
    got = time_of(f"MoveL Offs(p_a,0,0,{-way * 1e3}), v{speed}, fine, tool0;", strong(2.5, a))
    assert wanted <= got <= wanted * 1.002


def test_slow_ramps_beside_a_long_line_in_a_run_take_no_longer_than_they_do() -> None:
    """D/v + v/a over 160 mm with a corner of no angle: a ramp of 0.06 mm, a step between nodes is 1.5 mm."""
    lines = "MoveL Offs(p_a,0,0,-140), v50, z_t, tool0;\nMoveL Offs(p_a,0,0,-160), v50, fine, tool0;"
    wanted = 0.160 / 0.05 + 0.05 / 20
    assert wanted <= time_of(lines, strong(2.5, 20.0)) <= wanted + 0.002


def test_an_arc_is_as_fast_as_the_acceleration_towards_its_centre_allows() -> None:
    """With x = v^2: dx/ds = 2 sqrt(a^2 - x^2/r^2), so x = a r sin(2 s/r) until v = sqrt(a r) at s = pi r/4, in
    sqrt(r/a) B(1/4, 1/2)/4."""
    r, a, body = 0.04, 5.0, "MoveC Offs(p_a,40,0,-40), Offs(p_a,0,0,-80), v2500, fine, tool0;"
    axes, _, found = driven(body, strong(2.5, a))
    (motion,) = found.values()
    wanted = 2 * np.sqrt(r / a) * beta(0.25, 0.5) / 4 + (np.pi - np.pi / 2) * r / np.sqrt(a * r)
    assert wanted <= motion.T <= wanted * 1.01
    t = np.linspace(0, motion.T, 4001)
    tool = axes.forward(motion.sample(axes, t).q)[:, :3, 3]
    speed = np.linalg.norm(np.diff(tool, axis=0), axis=1) / np.diff(t)
    assert speed.max() <= np.sqrt(a * r) * (1 + 1e-6)
    assert speed.max() > np.sqrt(a * r) * 0.998


def ramp_time(way: float, v: float, up: float, down: float) -> float:
    """From rest to rest, speeding up at one acceleration and slowing down at another."""
    top = min(v, np.sqrt(2 * way * up * down / (up + down)))
    ramps = top / up + top / down
    return float(ramps + (way - ramps * top / 2) / top)


@pytest.mark.parametrize(("up", "down"), [(20.0, 1.0), (1.5, 20.0), (4.0, 0.5), (2.0, 2.0)])
@pytest.mark.parametrize("speed", [150, 2500])
def test_speeding_up_and_slowing_down_are_limited_apart(up: float, down: float, speed: float) -> None:
    said = [f"{on}{name}" for on, name in ((f"TRUE\\AccMax:={up}" if up < 20 else "FALSE", ""),
                                           (f"TRUE\\DecelMax:={down}" if down < 20 else "FALSE", ""))]  # fmt: skip
    body = f"PathAccLim {said[0]}, {said[1]};\nMoveL Offs(p_a,0,0,-80), v{speed}, fine, tool0;"
    wanted = ramp_time(0.08, speed * 1e-3, up, down)
    assert wanted <= time_of(body, strong(2.5, 20.0)) <= wanted * 1.002


def test_bends_are_free_of_what_limits_the_acceleration_along_the_path() -> None:
    """Half a circle of 40 mm at 0.5 m/s: 6.25 m/s2 towards its centre, 1 m/s2 along it."""
    body = "PathAccLim TRUE\\AccMax:=4, TRUE\\DecelMax:=1;\n"
    body += "MoveC Offs(p_a,40,0,-40), Offs(p_a,0,0,-80), v500, fine, tool0;"
    wanted = ramp_time(0.04 * np.pi, 0.5, 4.0, 1.0)
    assert wanted <= time_of(body, strong(2.5, 20.0)) <= wanted * 1.005


def ratios(axes: Axes, problem: Problem, k: int, motion: Pieces) -> Array:
    """Worst ratios to the limits of the axes' velocity and acceleration and the tool's speed, acceleration and turning,
    from positions alone: central differences at 20 places of every interval."""
    leg, h = problem.legs[k], 1e-5
    edges = motion.breaks()
    edges = np.stack([edges[:-1], edges[1:]])[:, np.diff(edges) > 4 * h]
    t = (edges[0] + h + (edges[1] - edges[0] - 2 * h) * np.linspace(1e-3, 1 - 1e-3, 20)[:, None]).ravel()
    before, at, after = (motion.sample(axes, t + x).q for x in (-h, 0, h))
    X = [axes.forward(q) @ leg.X_FT for q in (before, at, after)]
    qd, qdd = (after - before) / (2 * h), (after - 2 * at + before) / h**2
    p = [one[:, :3, 3] for one in X]
    turn = np.arccos(np.clip((np.trace(np.swapaxes(X[0], 1, 2)[:, :3, :3] @ X[2][:, :3, :3], axis1=1, axis2=2) - 1) / 2,
                             -1, 1))  # fmt: skip
    limits = axes.velocity_on(leg), axes.acceleration * leg.acceleration
    return np.array([
        (np.abs(qd) / limits[0]).max(),
        (np.abs(qdd) / limits[1]).max(),
        np.linalg.norm(p[2] - p[0], axis=1).max() / (2 * h) / leg.v_tcp,
        np.linalg.norm(p[2] - 2 * p[1] + p[0], axis=1).max() / h**2 / leg.a_tcp,
        turn.max() / (2 * h) / leg.v_ori,
    ])  # fmt: skip


@pytest.mark.parametrize("plant", [plant_with_rail(), plant_without_rail()], ids=["rail", "no rail"])
@pytest.mark.parametrize("name", MIXED)
def test_what_is_clean_passes_no_limit_between_its_nodes(name: str, plant: Plant) -> None:
    axes, problem, found = driven(MIXED[name], plant)
    worst = np.array([ratios(axes, problem, k, motion) for k, motion in found.items()])
    assert worst.max() <= 1 + 2e-6  # differences of rounded positions
    assert worst.max(axis=1).min() > 0.9  # and none is driven needlessly slowly


@pytest.mark.parametrize("plant", [plant_with_rail(), plant_without_rail()], ids=["rail", "no rail"])
@pytest.mark.parametrize("move", ["MoveL Offs(p_a,0,0,-20)", "MoveJ Offs(p_a,0,20,-20)"])
def test_half_the_acceleration_takes_the_square_root_of_two_longer(move: str, plant: Plant) -> None:
    """Where no speed is reached."""
    text = f"{move}, v2500, fine, tool0;"
    assert time_of(f"AccSet 50, 100;\n{text}", plant) == pytest.approx(np.sqrt(2) * time_of(text, plant), rel=1e-6)
