"""Windows beside bodies: what their rows say, that they gain, and what the judge says of what they found."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from clear_of import with_capsules
from link_poses import link_poses
from small_cells import down, plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.collision.collision_scene import CollisionScene, collision_scene_of
from trajopt_cli.geometry import Array, pose
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.nlp.clearances import Clearances, Tangents
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import LONG, MeshRefinement, NotConverged, on_grid
from trajopt_cli.path.line import Line, LineSymbols
from trajopt_cli.path_timing.path_parameterized_plan import duration
from trajopt_cli.plan.initial_plan import InitialPlan, initial_plan_of
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.settings import DEFAULT
from trajopt_cli.shapes import Box, Capsule, Solid
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate, Margins
from trajopt_cli.trajectories.leg_trajectories import JointNodes, PathLeg
from trajopt_cli.trajectory import Trajectory

PROGRAM = rapid("""MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v500, fine, tool0;
MoveL p_in, v500, fine, tool0;
MoveJ Offs(p_in,0,500,0), v2500, fine, tool0;""")
ROOMY = replace(plant_with_rail(), robot=with_capsules(plant_with_rail().robot))
AXES = Axes.of(ROOMY)
FORMULATION = Formulation(AXES)


def beside_box(x: float, y: float, z: float, clearance: float = 0.01) -> Plant:
    """A cube of 0.1 m there."""
    box = Solid(Box("cube", np.full(3, 0.1), pose(np.eye(3), [x, y, z])))
    return replace(ROOMY, obstacles=(box,), clearance=clearance)


@cache
def legal() -> InitialPlan:
    """A motion that is free of all cubes here."""
    found = initial_plan_of(AXES, [problem_of(PROGRAM, ROOMY)], Patience(), lambda _: None, {})
    assert isinstance(found, InitialPlan)
    return found


def solved(plant: Plant) -> Iterate:
    problem, grids = problem_of(PROGRAM, plant), LONG.rough
    start = on_grid(AXES, problem, legal().iterate, grids)
    return MeshRefinement(AXES, FORMULATION, problem, Patience(), grids, collision_scene_of(problem)).run(start)


def missing(plant: Plant, iterate: Iterate) -> float:
    """By how much the judge finds that a motion comes nearer than wanted [m]; the rows are 2 ms apart."""
    t, q, qd, now = [], [], [], 0.0
    for motion in iterate.legs:
        assert motion is not None
        at = np.linspace(0, motion.T, max(2, int(motion.T / 2e-3)), endpoint=False)
        sample = motion.sample(AXES, at)
        t, q, qd, now = [*t, now + at], [*q, sample.q], [*qd, sample.qd], now + motion.T
    trajectory = Trajectory(ROOMY.limits.names, np.concatenate(t), np.concatenate(q), np.concatenate(qd))
    findings = check_clearance(PROGRAM, plant, trajectory, lambda _: None)
    return max(one.limit - one.value for one in findings)


@pytest.fixture(scope="module")
def roomy() -> Iterate:
    return solved(ROOMY)


@pytest.mark.long
def test_a_window_beside_a_body_gains_and_is_free(roomy: Iterate) -> None:
    """Without the cube the fastest motion goes 54 mm into it; first answers go there, too."""
    plant = beside_box(0.2, 0.8, 0.1)
    assert missing(plant, legal().iterate) < 0 < 0.05 < missing(plant, roomy)
    found = solved(plant)
    assert missing(plant, found) <= 0
    assert duration(roomy) < duration(found) < 0.9 * duration(legal().iterate)
    again = solved(plant)
    for one, other in zip(found.legs, again.legs, strict=True):
        assert isinstance(one, PathLeg | JointNodes) == isinstance(other, PathLeg | JointNodes)
        times = np.linspace(0, one.T, 50)
        assert one.T == other.T
        assert np.array_equal(one.sample(AXES, times).q, other.sample(AXES, times).q)


def test_a_window_far_from_everything_is_the_same_with_bodies_and_without(roomy: Iterate) -> None:
    found = solved(beside_box(3.0, 3.0, 3.0))
    assert duration(found) == duration(roomy)
    assert np.array_equal(found.q, roomy.q)


def test_where_nothing_stands_a_program_has_no_rows_of_distances() -> None:
    """The links are always near one another."""
    problem = problem_of(PROGRAM, ROOMY)
    start = on_grid(AXES, problem, legal().iterate, LONG.rough)
    margins = [Margins.full(AXES, motion.N, isinstance(motion, PathLeg)) for motion in start.legs]
    assert ROOMY.self_pairs
    assert Clearances(AXES, problem, collision_scene_of(problem)).tangents(start, margins) == {}


def test_what_the_program_itself_brings_too_near_has_no_answer() -> None:
    """The cube is 10 mm beside the flange at p_low, and 30 mm are wanted."""
    with pytest.raises(NotConverged):
        solved(beside_box(0.5, 0.6, 0.33, 0.03))


def tip_beside_ball(radius: float = 0.03) -> tuple[Plant, Pair]:
    """Only the last link may not touch the ball."""
    others, centre = frozenset(ROOMY.robot.link_names) - {"link_6"}, np.array([0.62, 0.65, 0.42])
    ball = Solid(Capsule("ball", centre, centre, radius), others)
    return replace(ROOMY, obstacles=(ball,)), Pair(ROOMY.robot.bodies["link_6"][0], ball.shape)


def distances(pair: Pair, q: Array) -> Array:
    """By pin and coal, less what the planner stays farther away."""
    last = ROOMY.robot.link_names.index("link_6")
    return pair.distances(link_poses(ROOMY.robot, q)[:, last]) - DEFAULT.clearance_margin


def tangents(plant: Plant, k: int, q: Array) -> Iterator[tuple[int, dict[str, Array]]]:
    """Of leg k at axes q (m, n): of each node with something near."""
    found = Tangents.about(
        CollisionScene(plant, PROGRAM), problem_of(PROGRAM, plant).legs[k], q, np.zeros(len(q)), DEFAULT
    )
    assert found is not None
    assert not found.gradient[:, 1:].any()
    assert (found.least[:, 1:] == -1).all()
    for node in np.flatnonzero(found.gradient[:, 0].any(axis=1)).tolist():
        yield node, {"gradient": found.gradient[node], "least": found.least[node]}


def test_rows_of_joint_moves_are_tangents_of_distances() -> None:
    plant, pair = tip_beside_ball()
    motion = legal().iterate.legs[0]
    assert motion is not None
    q = motion.sample(AXES, np.linspace(0.9, 1, 5) * motion.T).q
    seen = 0
    for node, tangent in tangents(plant, 0, q):
        x, steps = q[node], np.eye(AXES.n) * 1e-5
        rows = [FORMULATION.clear_axes().value({"q": one}, tangent)[0] for one in (x, *(x - steps), *(x + steps))]
        here, *beside = distances(pair, np.array([x, *(x - steps), *(x + steps)]))
        assert rows[0] == pytest.approx(here - min(DEFAULT.clearance_margin_nlp, here), abs=1e-9)
        changes = (np.reshape(one, (2, -1)) for one in (rows[1:], beside))
        assert np.diff(next(changes), axis=0) == pytest.approx(np.diff(next(changes), axis=0), abs=2e-9)
        seen += 1
    assert seen > 2


def test_rows_of_lines_are_tangents_of_distances() -> None:
    """By the share of the way and the rail, through the inverse kinematics."""
    plant, pair = tip_beside_ball()
    motion = on_grid(AXES, problem_of(PROGRAM, plant), legal().iterate, LONG.rough).legs[1]
    assert isinstance(motion, PathLeg)
    assert isinstance(motion.segment, Line)
    arm, track = motion.node_arm(AXES), LineSymbols(False)
    path = motion.segment.parameters(np.linalg.inv(AXES.X_WB0), motion.X_FT)
    seen = 0
    for node, tangent in tangents(plant, 1, AXES.layout.merge(motion.d, arm)):
        p = {"path": path, "branch": AXES.robot.expressions.branch(motion.cfx), "near": arm[node], **tangent}
        s, d = np.clip(motion.s[node], 1e-4, 1 - 1e-4), motion.d[node]
        x = np.array([[s, *d], [s - 1e-4, *d], [s + 1e-4, *d], [s, *(d - 1e-5)], [s, *(d + 1e-5)]])
        joints = AXES.inverse(motion.segment.pose(x[:, 0]) @ np.linalg.inv(motion.X_FT), x[:, 1])[:, motion.cfx]
        joints += 2 * np.pi * np.round((arm[node] - joints) / (2 * np.pi))
        here = distances(pair, AXES.layout.merge(x[:, 1:], joints))
        rows = [FORMULATION.clear_path(track).value({"s": one[0], "d": one[1:]}, p)[0] for one in x]
        assert rows[0] == pytest.approx(here[0] - DEFAULT.clearance_margin_nlp, abs=1e-5)
        assert np.subtract(rows[2::2], rows[1::2]) == pytest.approx(here[2::2] - here[1::2], abs=2e-9)
        seen += 1
    assert seen > 2


def test_rows_of_a_robot_without_a_rail_have_no_rail() -> None:
    axes, track = Axes.of(plant_without_rail()), LineSymbols(False)
    line = Line(down(0.5, 0.1, 0.4), down(0.5, 0.2, 0.4))
    arm = axes.inverse(line.pose(np.array([0.3])), np.zeros(1))[0, 0]
    gradient = np.vstack([np.arange(1.0, 7.0), np.zeros((DEFAULT.body_pairs - 1, 6))])
    p = {
        "path": line.parameters(np.linalg.inv(axes.X_WB0), np.eye(4)),
        "branch": axes.robot.expressions.branch(0),
        "near": arm,
        "gradient": gradient,
        "least": np.full(DEFAULT.body_pairs, -1.0),
    }
    rows = Formulation(axes).clear_path(track).value({"s": 0.3, "d": np.zeros(0)}, p)
    assert rows == pytest.approx(gradient @ arm + 1.0)


def test_nodes_keep_farther_off_where_a_motion_dips_between_them() -> None:
    """The last link swings over a ball, 1 cm into it."""
    plant, pair = tip_beside_ball(0.12)
    q = legal().iterate.q[1] + np.array([[0, -0.3, 0, 0, 0, 0, 0], [0, 0.3, 0, 0, 0, 0, 0]])
    ends, middle = distances(pair, q), distances(pair, q.mean(axis=0)[None])[0]
    assert middle < 0 < ends.min()
    swing = JointNodes(1.0, np.array([0.0, 1.0]), q, np.zeros_like(q), np.zeros_like(q[:1]))
    iterate, margins = replace(legal().iterate, legs=(None, swing, None, None)), Margins.full(AXES, 1, on_path=False)
    problem = problem_of(PROGRAM, plant)
    clearances = Clearances(AXES, problem, collision_scene_of(problem))
    assert clearances.make_room(iterate, [None, margins, None, None])
    assert margins.room.min() > ends.min() - middle
    assert (margins.refined().room == margins.room[0]).all()
    found = clearances.tangents(iterate, [None, margins, None, None])[1]
    assert found.gradient[0, 0] @ q[0] - found.least[0, 0] == pytest.approx(ends[0] - margins.room[0])
