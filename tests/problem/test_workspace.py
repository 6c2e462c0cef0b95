"""Reachable rail ranges against closed forms and a dense look."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from arms import KNOWN, PARALLEL, RAILS, on_rail, some_arm, urdf_joints
from matplotlib.path import Path as MplPath

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.geometry import Array, pose
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.problem.workspace import rail_ranges, reachable, sections
from trajopt_cli.report.skeleton import skeleton
from trajopt_cli.robot.inverse import branch_margins

PROGRAMS = Path(__file__).parents[2] / "programs"
DOWN = np.diag([-1.0, 1.0, -1.0])  # the flange looks down, x towards the base


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_cell.yaml"))


@pytest.mark.parametrize("phi_min", [0.0, np.radians(10), np.radians(25)])
def test_the_range_ends_where_the_elbow_stretches(plant: Plant, phi_min: float) -> None:
    # Wrist centre at height w over axis 2 and x ahead; the arm reaches it while the distance from axis 2 is at most
    # that of the law of cosines at an elbow phi_min from stretched.
    x, y, z = 0.5, 1.0, 0.33
    arm = plant.robot.arm
    far2 = arm.c2**2 + arm.c3**2 + 2 * arm.c2 * arm.c3 * np.cos(phi_min)
    up = z + arm.c4 - arm.c1
    ahead = arm.a1 + np.sqrt(far2 - up**2)
    half = np.sqrt(ahead**2 - x**2)
    np.testing.assert_allclose(rail_ranges(plant, pose(DOWN, [x, y, z]), phi_min), [[y - half, y + half]], atol=3e-6)


def test_the_stroke_cuts_the_range_and_far_poses_have_none(plant: Plant) -> None:
    assert rail_ranges(plant, pose(DOWN, [0.5, -0.1, 0.33]))[0, 0] == plant.limits.lower[0]
    assert rail_ranges(plant, pose(DOWN, [1.5, 1.0, 0.33])).shape == (0, 2)


def test_a_pose_near_the_rail_has_a_gap_where_the_arm_would_fold_into_itself(plant: Plant) -> None:
    ranges = rail_ranges(plant, pose(DOWN, [0.1, 1.0, 0.3]))
    assert len(ranges) == 2
    np.testing.assert_allclose(ranges.sum(), 4.0, atol=1e-4)  # the scene is a mirror image of itself about y = 1
    rail = np.linspace(plant.limits.lower[0], plant.limits.upper[0], 4801)
    within = ((rail[:, None] >= ranges[:, 0]) & (rail[:, None] <= ranges[:, 1])).any(axis=1)
    np.testing.assert_array_equal(reachable(plant, pose(DOWN, [0.1, 1.0, 0.3]), rail), within)


def test_a_branch_reaches_no_more_than_all_branches(plant: Plant) -> None:
    X = pose(DOWN, [0.5, 1.0, 0.33])
    rail = np.linspace(-0.2, 2.2, 500)
    per_branch = np.array([reachable(plant, X, rail, branch=i) for i in range(8)])
    np.testing.assert_array_equal(per_branch.any(axis=0), reachable(plant, X, rail))
    assert per_branch[0].sum() > per_branch[6].sum() > 0  # overhead it reaches less far


def test_every_wrist_centre_of_random_joints_lies_inside_an_outline(plant: Plant) -> None:
    rng = np.random.default_rng(5)
    arm = plant.robot.arm
    q = rng.uniform(plant.limits.lower, plant.limits.upper, (500, 7))
    q[:, 1] = 0.0  # the arm's own plane is the base's x-z plane
    q = q[np.abs(np.cos(q[:, 3])) > 0.02]  # nearer to the border than its chords are
    X = plant.robot.forward(q)
    wrist = X[:, :3, 3] - arm.c4 * X[:, :3, 2]
    base = plant.robot.base(q[:, 0])
    local = np.einsum("nji,nj->ni", base[:, :3, :3], wrist - base[:, :3, 3])[:, [0, 2]]
    inside = np.array([winding(outline, local) != 0 for outline in sections(plant)])
    assert inside.any(axis=0).all()
    stretched = rng.uniform(-np.pi, np.pi, 200)
    beyond = [arm.a1, arm.c1] + 1.001 * (arm.c2 + arm.c3) * np.column_stack([np.cos(stretched), np.sin(stretched)])
    assert not any(winding(outline, beyond).any() for outline in sections(plant))


def winding(outline: Array, points: Array) -> Array:
    """How often the outline runs around each point: the turns of the ray from the point to the outline."""
    rays = np.vstack([outline, outline[:1]])[None] - points[:, None]
    angle = np.arctan2(rays[..., 1], rays[..., 0])
    turn = np.angle(np.exp(1j * np.diff(angle, axis=1)))
    return np.round(turn.sum(axis=1) / (2 * np.pi))


@pytest.mark.parametrize("name", [*KNOWN, *range(8), *PARALLEL, "parallel 1", "parallel 2", "linked 0", "linked 5"])
def test_of_every_arm_the_wrist_centre_lies_inside_the_outlines_and_the_skeleton_on_its_axes(
    name: str | int, tmp_path: Path
) -> None:
    """The wrist centre, or axis 4 where it is parallel to axis 3, and the lines of axes 2 and 3 by pin."""
    route = some_arm(name)
    route.ranges[1:3] = [
        (m - h, m + h) for (a, b), h in zip(route.ranges[1:3], (1.0, 1.8), strict=True) for m in [(a + b) / 2]
    ]
    robot = route.load(tmp_path)
    limits, rng = robot.profile(), np.random.default_rng(3)
    plant = Plant(robot, limits, robot.tcp, limits.lower, (), False, False, frozenset())
    outlines = [MplPath(outline) for outline in sections(plant)]
    q = rng.uniform(limits.lower, limits.upper, (150, 6))
    q = q[branch_margins(robot.arm, q)[1] > 0] if robot.linkage else q
    model, inside = robot.pin_model, []
    data, X_WC = model.createData(), robot.X_WC0
    for row in q:
        u = pin.computeJointJacobians(model, data, urdf_joints(robot, row))[3:].T
        p = np.array([data.oMi[i].translation for i in range(1, 7)])
        across = [np.eye(3) - np.outer(v, v) for v in u]
        first = 4 if abs(u[2] @ u[3]) > 0.5 else 3
        wrist = np.linalg.solve(sum(across[first:]), sum(A @ o for A, o in zip(across[first:], p[first:], strict=True)))
        end = p[3] if first == 4 else wrist  # what axes 2 and 3 alone carry
        # in the canonical base: axis 1 is z, and axis 2 points left of the arm's plane
        left = X_WC[:3, :3].T @ u[1]
        w = X_WC[:3, :3].T @ (end - X_WC[:3, 3])
        ahead = np.cross(left, [0, 0, 1]) @ w * np.sign(robot.arm.signs[1])
        inside.append(
            any(outline.contains_point((ahead, w[2]), radius=s) for outline in outlines for s in (-2e-3, 2e-3))
        )
        shape = skeleton(plant, row, np.eye(4))
        assert np.linalg.norm(shape[first + 1] - wrist) < 1e-9
        for place, j in ((shape[2], 1), (shape[3], 2), *(((shape[4], 3),) if first == 4 else ())):
            assert np.linalg.norm(across[j] @ (place - p[j])) < 1e-9
        assert np.linalg.norm(across[0] @ (shape[:2] - p[0]).T) < 1e-9
    assert np.mean(inside) > 0.99  # the outlines are chords of arcs
    assert all(area(outline) < 0.9 * np.pi * (robot.arm.c2 + robot.arm.upper) ** 2 for outline in outlines)


def area(outline: MplPath) -> float:
    x, y = outline.vertices.T
    return float(abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1)))) / 2


@pytest.mark.parametrize("rail", RAILS)
@pytest.mark.parametrize("name", ["irb4600", "puma560", 3, 5, "ur10e", "parallel 0"])
def test_no_pose_is_reached_from_outside_the_rails_range(name: str | int, rail: str, tmp_path: Path) -> None:
    robot = on_rail(some_arm(name), rail).load(tmp_path)
    limits = robot.profile()
    q = np.random.default_rng(2).uniform(limits.lower, limits.upper, (3000, 7))
    ends = robot.rail_within(robot.forward(q))
    assert np.all((ends[:, 0] <= q[:, 0]) & (q[:, 0] <= ends[:, 1]))
    arm = robot.arm
    longest = np.hypot(abs(arm.a1) + arm.c2 + arm.upper, arm.b) + np.linalg.norm(arm.wrist)
    longest += np.linalg.norm(arm.X_KF[:3, 3] + [0, 0, arm.c4])
    assert np.diff(ends).max() < 2 * longest + 1e-12
