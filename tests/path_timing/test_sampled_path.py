"""Courses of runs: derivatives are those of the positions, corners are where the zones say, and small ones vanish."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from small_cells import down, plant_with_rail, plant_without_rail, problem_of, rapid
from unrefined import set_defaults

from trajopt_cli.geometry import Array, pose, rotation_about, wxyz_from_rotation
from trajopt_cli.graph_search.search import search
from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path_timing.sampled_path import SampledPath, sample_path
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes

TILTED = pose(rotation_about([1, 0, 0], 0.3), [0, 0, 0])
PLACES = {  # pose of the flange, and where the rail is written [m]
    "p_a": (down(0.50, 0.60, 0.45), 0.60),
    "p_b": (down(0.53, 0.66, 0.43, 0.3) @ TILTED, 0.63),
    "p_c": (down(0.47, 0.70, 0.40, -0.1), 0.70),
    "p_d": (down(0.45, 0.60, 0.42, 0.4), 0.64),
}
TOOL = "PERS tooldata t_long:=[TRUE,[[30,-20,120],[0.97,0.1,0.2,0.1]],[1,[0,0,1],[1,0,0,0],0,0,0]];"
GOTO = "MoveJ p_a, v1000, fine, t_long;\n"
RUNS = {
    "line": "MoveL p_b, v500, fine, t_long;",
    "arc": "MoveC p_b, p_c, v500, fine, t_long;",
    "turn in place": "MoveL p_turned, v500, fine, t_long;",
    "line, line": "MoveL p_b, v500, z_t, t_long;\nMoveL p_c, v500, fine, t_long;",
    "line, arc": "MoveL p_b, v500, z_t, t_long;\nMoveC p_c, p_d, v500, fine, t_long;",
    "arc, line": "MoveC p_b, p_c, v500, z_t, t_long;\nMoveL p_d, v500, fine, t_long;",
    "joints, line": "MoveJ p_b, v500, z_t, t_long;\nMoveL p_c, v500, fine, t_long;",
    "line, joints": "MoveL p_b, v500, z_t, t_long;\nMoveJ p_c, v500, fine, t_long;",
    "joints, arc": "MoveJ p_b, v500, z_t, t_long;\nMoveC p_c, p_d, v500, fine, t_long;",
    "joints, joints": "MoveJ p_b, v500, z_t, t_long;\nMoveJ p_c, v500, fine, t_long;",
    "all": "MoveL p_b, v500, z_t, t_long;\nMoveJ p_c, v500, z_t, t_long;\nMoveL p_d, v500, z_t, t_long;\n"
    "MoveC p_b, p_c, v500, fine, t_long;",
}
ALIKE = (15.0, 15.0, 15.0)  # zones [mm] of position, orientation and external axes
APART = (12.0, 20.0, 28.0)
CORNERS = [name for name in RUNS if "," in name]


def data(zone: tuple[float, float, float], rail: bool) -> str:
    radius, turning, external = zone
    out = [f"CONST zonedata z_t:=[FALSE,{radius},{turning},{external},9E9,9E9,9E9];", TOOL]
    places = {**PLACES, "p_turned": (PLACES["p_a"][0] @ pose(rotation_about([0.6, 0, 0.8], 0.5), [0, 0, 0]), 0.62)}
    for name, (X, d) in places.items():
        turn = ",".join(f"{x:.12f}" for x in wxyz_from_rotation(X[:3, :3]))
        # without a rail the arm stands where the rail would be at 0.6 m
        place = ",".join(f"{x * 1e3:.9f}" for x in X[:3, 3] - (0 if rail else np.array([0, 0.6, 0])))
        axis = f"{d * 1e3:.9f}" if rail else "9E9"
        out.append(f"CONST robtarget {name}:=[[{place}],[{turn}],[0,0,0,0],[{axis},9E9,9E9,9E9,9E9,9E9]];")
    return "\n".join(out)


def posed(body: str, zone: tuple[float, float, float], plant: Plant) -> tuple[Axes, Problem, Array, tuple[int, ...]]:
    """The run's problem as written, with axes and branches at its waypoints."""
    return Axes.of(plant), written(body, zone, plant), *stops_of(body, plant)


def written(body: str, zone: tuple[float, float, float], plant: Plant) -> Problem:
    program = rapid(GOTO + body, data=data(zone, plant.robot.has_rail))
    problem = problem_of(program, plant, Target.RAPID, AS_WRITTEN)
    return replace(problem, waypoints=tuple(replace(point, conf=None) for point in problem.waypoints))


@cache
def stops_of(body: str, plant: Plant) -> tuple[Array, tuple[int, ...]]:
    """Axes and branches at the waypoints, whatever the zones."""
    route = search(Axes.of(plant), stopping(written(body, ALIKE, plant)))
    assert route is not None
    return route.q, tuple(label.cfx for label in route.labels)


def stopping(problem: Problem) -> Problem:
    """The same without corners."""
    return replace(problem, waypoints=tuple(replace(point, fly_by=None) for point in problem.waypoints))


def course_for(
    name: str, zone: tuple[float, float, float], plant: Plant, nodes: int = 64
) -> tuple[Axes, Problem, SampledPath, Array]:
    """The tool_parts of the run behind the approach; axes at the waypoints."""
    axes, problem, q, cfx = posed(RUNS[name], zone, plant)
    found = sample_path(axes, problem, problem.runs[-1], q, cfx, nodes)
    assert found is not None
    return axes, problem, found, q


@pytest.fixture(scope="module", params=["rail", "no rail"])
def plant(request: pytest.FixtureRequest) -> Plant:
    return plant_with_rail() if request.param == "rail" else plant_without_rail()


@pytest.fixture
def dense(monkeypatch: pytest.MonkeyPatch) -> None:
    """Many nodes in a corner's parts, for differences of neighbours."""
    set_defaults(monkeypatch, corner_nodes=40)


def rows(of: SampledPath) -> list[slice]:
    """The rows of each part."""
    return [slice(a, b) for a, b in pairwise(np.r_[0, np.cumsum(of.counts + 1)])]


def weights(sigma: Array) -> tuple[Array, Array]:
    """Weights (m, 5) of five neighbours for the first and the second derivative at the middle one, exact for quartics;
    sigma (m + 4,)."""
    away = np.array([sigma[i : len(sigma) - 4 + i] for i in range(5)]).T - sigma[2:-2, None]
    h = np.abs(away).max(axis=1)[:, None]
    powers = (away / h)[:, None, :] ** np.arange(5)[:, None]
    found = np.linalg.solve(powers, np.tile(np.eye(5)[:, 1:3] * [1, 2], (len(h), 1, 1)))
    return found[..., 0] / h, found[..., 1] / h**2


def spread(x: Array) -> Array:
    """Each place's five neighbours, (m, 5, ...)."""
    return np.stack([x[i : len(x) - 4 + i] for i in range(5)], axis=1)


def turned(R: Array) -> Array:
    """Rotation vectors (m, 5, 3) from the middle one of five rotations to each."""
    near = spread(R)
    away = near @ near[:, 2:3].transpose(0, 1, 3, 2)
    return Rotation.from_matrix(away.reshape(-1, 3, 3)).as_rotvec().reshape(-1, 5, 3)


@pytest.mark.parametrize("zone", [ALIKE, APART], ids=["one zone", "own zones"])
@pytest.mark.parametrize("name", RUNS)
def test_derivatives_are_slopes_of_the_positions(
    name: str, zone: tuple[float, float, float], plant: Plant, dense: None
) -> None:
    axes, problem, found, _ = course_for(name, zone, plant, 300)
    for i, (part, at) in enumerate(zip(found.parts, rows(found), strict=True)):
        assert part.N >= 10
        # the nodes at a part's ends stand a hair inside it
        along, inside = found.along.at(slice(at.start + 1, at.stop - 1)), slice(2, -2)
        sigma = found.sigma[at.start - i : at.stop - i][1:-1]
        X = axes.forward(along.q) @ problem.legs[part.leg].X_FT
        first, second = weights(sigma)
        h = np.diff(sigma).min()
        for got, weight, places, noise in (
            (along.dq, first, spread(along.q), 1e-14 / h),
            (along.ddq, second, spread(along.q), 1e-13 / h**2),
            (along.v, first, spread(X[:, :3, 3]), 1e-14 / h),
            (along.bend, second, spread(X[:, :3, 3]), 1e-13 / h**2),
            (along.w, first, turned(X[:, :3, :3]), 1e-14 / h),
        ):
            wanted = np.einsum("mj,mjk->mk", weight, places)
            scale = np.abs(wanted).max()
            np.testing.assert_allclose(got[inside], wanted, rtol=0, atol=1e-5 * scale + noise)


@pytest.mark.parametrize("zone", [ALIKE, APART], ids=["one zone", "own zones"])
@pytest.mark.parametrize("name", CORNERS)
def test_positions_and_first_derivatives_go_on_from_part_to_part(
    name: str, zone: tuple[float, float, float], plant: Plant
) -> None:
    _, _, found, _ = course_for(name, zone, plant)
    last, first = (np.array([getattr(at, side) for at in rows(found)]) for side in ("stop", "start"))
    along = found.along
    for x in (along.q, along.dq, along.v, along.w):
        np.testing.assert_allclose(x[last[:-1] - 1], x[first[1:]], rtol=0, atol=1e-6 * np.abs(x).max())
    assert len(found.parts) > 3


def test_the_rail_is_bent_in_its_own_zone_alone(dense: None) -> None:
    """28 mm of 85 and 73 mm: before and behind, its rate is that of the way."""
    axes, problem, found, q = course_for("line, line", APART, plant_with_rail())
    rail = axes.layout.rail
    d, rate = found.along.q[:, rail][:, 0], found.along.dq[:, rail][:, 0]
    before, after = problem.legs[-2:]
    sigma = np.insert(found.sigma, np.cumsum(found.counts)[:-1], found.sigma[np.cumsum(found.counts)[:-1]])
    lengths = before.chord, after.chord
    ways = [float(q[k + 1, 0] - q[k, 0]) / length for k, length in ((1, lengths[0]), (2, lengths[1]))]
    inside = np.abs(sigma - lengths[0]) < 0.028 - 1e-9
    outside = np.abs(sigma - lengths[0]) > 0.028 + 1e-9
    np.testing.assert_allclose(rate[outside], np.where(sigma < lengths[0], *ways)[outside], rtol=1e-9)
    u = (sigma[inside] - lengths[0] + 0.028) / 0.056
    np.testing.assert_allclose(rate[inside], (1 - u) * ways[0] + u * ways[1], rtol=1e-9)
    edge, corner, exit_ = q[2, 0] - 0.028 * ways[0], q[2, 0], q[2, 0] + 0.028 * ways[1]
    np.testing.assert_allclose(d[inside], (1 - u) ** 2 * edge + 2 * u * (1 - u) * corner + u**2 * exit_, rtol=1e-9)
    assert inside.sum() > 50


@pytest.mark.parametrize("radius", [4.0, 20.0])
def test_a_corner_of_lines_is_a_parabola_between_both_edges_of_its_zone(radius: float, plant: Plant) -> None:
    """Entry and exit lie r from the point C. The middle of the Bezier curve C - r e1, C, C + r e2 with the unit
    directions e1 into and e2 out of the point is C + r (e2 - e1) / 4."""
    axes, problem, found, _ = course_for("line, line", (radius, radius, radius), plant)
    r, X_FT = radius * 1e-3, problem.legs[-1].X_FT
    C, (before, after) = (problem.waypoints[2].X_WF @ X_FT)[:3, 3], problem.legs[-2:]
    e1, e2 = (leg.segment.chord / leg.chord for leg in (before, after))
    ends = [at.stop - 1 for at in rows(found)]
    tool = (axes.forward(found.along.q[ends]) @ X_FT)[:, :3, 3] - C
    assert [part.leg - problem.runs[-1][0] for part in found.parts] == [0, 0, 1, 1]
    wanted = [-r * e1, r * (e2 - e1) / 4, r * e2, e2 * after.chord]
    np.testing.assert_allclose(tool, wanted, rtol=0, atol=1e-9)
    assert found.sigma[np.cumsum(found.counts)] == pytest.approx(
        np.cumsum([before.chord - r, r, r, after.chord - r]), abs=1e-12
    )


@pytest.mark.parametrize("name", CORNERS)
def test_small_zones_leave_the_way_of_the_stops(name: str, plant: Plant) -> None:
    """At the same shares of its legs a path with corners comes as near to the one with stops as its zones are
    small."""
    away, straight = [], dict[int, SampledPath | None]()
    for radius in (16.0, 1.6, 0.16):
        axes, problem, q, cfx = posed(RUNS[name], (radius, radius, radius), plant)
        found = sample_path(axes, problem, problem.runs[-1], q, cfx, 64)
        assert found is not None
        most = 0.0
        for k in range(*problem.runs[-1]):
            if k not in straight:  # whatever the zones
                straight[k] = sample_path(axes, stopping(problem), (k, k + 1), q, cfx, 2000)
            stops = straight[k]
            assert stops is not None
            share = _shares_of(found, k)
            at = np.concatenate(
                [found.along.q[rows_] for part, rows_ in zip(found.parts, rows(found), strict=True) if part.leg == k]
            )
            wanted = [np.interp(share, stops.sigma / stops.sigma[-1], column) for column in stops.along.q.T]
            most = max(most, float(np.abs(at - np.array(wanted).T).max()))
        away.append(most)
    assert away[0] > 1e-3
    assert away[1] < 0.15 * away[0]
    assert away[2] < 0.15 * away[1]


def _shares_of(found: SampledPath, k: int) -> Array:
    """Which shares of leg k its nodes are, in order; a place between two parts stands twice."""
    of = [(i, at) for i, (part, at) in enumerate(zip(found.parts, rows(found), strict=True)) if part.leg == k]
    sigma = np.concatenate([found.sigma[at.start - i : at.stop - i] for i, at in of])
    return np.asarray((sigma - sigma[0]) / (sigma[-1] - sigma[0]))


@pytest.mark.parametrize("name", [name for name in CORNERS if "joints" in name])
def test_a_corner_of_all_axes_keeps_the_tool_within_its_zone(name: str, plant: Plant, dense: None) -> None:
    axes, problem, found, _ = course_for(name, ALIKE, plant)
    X_FT = problem.legs[-1].X_FT
    C = (problem.waypoints[2].X_WF @ X_FT)[:3, 3]
    corners = [at for part, at in zip(found.parts, rows(found), strict=True) if isinstance(part.segment, JointCorner)]
    tool = np.concatenate([(axes.forward(found.along.q[at]) @ X_FT)[:, :3, 3] for at in corners])
    away = np.linalg.norm(tool - C, axis=1)
    assert away.max() <= 0.015 * (1 + 1e-5)
    assert away[[0, -1]].min() > 0.3 * 0.015
