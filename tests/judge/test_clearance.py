"""Obstacles and self-collision: the least distance against brute force, closed forms, and what sampling would miss."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from clear_of import with_capsules
from legal_motion import HOME, plant_with_rail, plant_without_rail, program, rapid_case
from legal_motion import home as home_move
from link_poses import link_poses

from trajopt_cli.findings import CLEARANCE, SELF_CLEARANCE, Finding, collisions
from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about
from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.judge.clearance import check_clearance, least_clearance
from trajopt_cli.judge.continuous_collision import (
    BLOCK,
    COARSE,
    OVERLOOKED,
    Body,
    InterpolatedMotion,
    Near,
    Sweep,
    _Sample,
)
from trajopt_cli.judge.mechanism import Mechanism, mechanism_of
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.model import load_robot
from trajopt_cli.shapes import Box, Capsule, Mesh, Polytope, Shape, Solid, outline
from trajopt_cli.trajectory import Trajectory, hermite

EVERY_LINK = frozenset({"base_link", *(f"link_{i}" for i in range(1, 7))})
EMPTY = Program("main", (), {})
STRETCHED = np.array(
    [0, np.pi / 2, -np.pi / 2, 0, 0, 0]
)  # the arm level, straight ahead: the flange 0.875 m from axis 1
REACH = 0.07 + 0.36 + 0.38 + 0.065
HEIGHT = 0.352
UP = np.array([0.0, 0.0, 1.0])
CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2.0
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(4104)


def box(name: str, size: list[float], position: list[float], ignore: frozenset[str] = frozenset()) -> Solid:
    return Solid(Box(name, np.array(size), pose(np.eye(3), position)), ignore)


def ball(radius: float, ahead: float = 0.0) -> Solid:
    """On the flange's axis, with its centre `ahead` of the flange."""
    return Solid(Capsule("ball", np.array([0, 0, ahead]), np.array([0, 0, ahead]), radius))


def quintic_move(plant: Plant, stops: list[Array], T: float = 0.4, step: float = 1e-3) -> Trajectory:
    u = np.arange(0, 1, step / T)[:, None]
    share, rate = u**3 * (10 + u * (6 * u - 15)), 30 * u**2 * (1 - u) ** 2 / T
    q = [a + share * (b - a) for a, b in pairwise(stops)]
    qd = [rate * (b - a) for a, b in pairwise(stops)]
    rows = np.concatenate([*q, [stops[-1]]])
    speeds = np.concatenate([*qd, np.zeros((1, rows.shape[1]))])
    return Trajectory(plant.limits.names, np.arange(len(rows)) * step, rows, speeds)


def turning(plant: Plant, q: Array, angle: float, rate: float, step: float) -> Trajectory:
    """Joint 1 from -angle to angle at a constant rate, the others as in q, rows every step."""
    t = np.arange(0, 2 * angle / rate, step)
    rows = np.tile(q, (len(t), 1))
    rows[:, 0] = rate * t - angle
    speeds = np.zeros_like(rows)
    speeds[:, 0] = rate
    return Trajectory(plant.limits.names, t, rows, speeds)


def check(plant: Plant, trajectory: Trajectory) -> dict[tuple[str, str], Finding]:
    """Findings by check and the quoted obstacle (empty for the robot against itself)."""
    found = check_clearance(EMPTY, plant, trajectory, lambda _: None)
    return {(f.check, f.subject.partition("'")[2].rstrip("'")): f for f in found}


def one(plant: Plant, trajectory: Trajectory) -> Finding:
    (found,) = (f for (kind, _), f in check(plant, trajectory).items() if kind == CLEARANCE)
    return found


def brute_force(plant: Plant, obstacle: Solid, trajectory: Trajectory, step: float) -> float:
    """Least distance at samples `step` apart, by poses of pin; the depth in a mesh is that in its surface.

    Every tenth sample is looked at first. In ten steps no point goes farther than `way`, at 10 m/s: where the distance
    is more than that above the least one, the samples that follow are not looked at.
    """
    times = np.arange(trajectory.t[0], trajectory.t[-1], step)
    some = distances(plant, obstacle, hermite(trajectory, times[::10])[0])
    way = 10 * step * 10.0
    near = np.repeat(some < some.min() + way, 10)[: len(times)]
    return float(distances(plant, obstacle, hermite(trajectory, times[near])[0]).min())


def distances(plant: Plant, obstacle: Solid, q: Array) -> Array:
    """Of the robot from the obstacle (n,)."""
    import pinocchio as pin

    model = plant.robot.pin_model
    data = model.createData()
    names = [*plant.robot.link_names, "tool0"]
    bodies: list[tuple[int, Shape]] = [(i, plant.robot.bodies[n][0]) for i, n in enumerate(names[:-1])]
    bodies = [(i, shape) for i, shape in bodies if names[i] not in obstacle.ignore and (i or plant.robot.has_rail)]
    bodies += [(7, solid.shape) for solid in plant.attached]
    ids = [model.getFrameId(name) for name in names]
    X = np.empty((len(q), 8, 4, 4))
    for row, out in zip(q, X, strict=True):
        pin.framesForwardKinematics(model, data, row)
        out[:] = [data.oMf[i].homogeneous for i in ids]
    return np.min([Pair(shape, obstacle.shape).distances(X[:, i], solid=False) for i, shape in bodies], axis=0)


@pytest.mark.parametrize("rail", [False, True])
def test_the_least_distance_is_that_of_dense_sampling(rail: bool, rng: np.random.Generator) -> None:
    """Random joint moves among boxes, capsules and meshes, on a rail and without: apart and overlapping."""
    counts = {"hit": 0, "apart": 0}
    plain = plant_with_rail() if rail else plant_without_rail()
    limits = plain.limits
    for k in range(6):
        axis = rng.normal(size=3)
        stops = list(rng.uniform(limits.lower / 3, limits.upper / 3, (3, len(limits.names))))
        beside = plain.robot.forward(stops[1])[:3, 3] + (0.0, 0.25, 0.4)[k // 2] * axis / np.linalg.norm(axis)
        X = pose(rotation_about(axis / np.linalg.norm(axis), rng.uniform(-3, 3)), beside)
        size = rng.uniform(0.05, 0.2, 3)
        shape = (
            Box("thing", size, X),
            Capsule("thing", X[:3, 3], X[:3, 3] + size, 0.05),
            Mesh("thing", CORNERS * size, FACES, X),
        )[k % 3]
        obstacle = Solid(shape, frozenset({"base_link"}))
        wanted = float(rng.choice([0.0, 0.05]))
        plant = replace(plain, obstacles=(obstacle,), attached=(ball(0.03, 0.1),), clearance=wanted)
        trajectory = quintic_move(plant, stops, 0.5, 5e-3)
        brute = brute_force(plant, obstacle, trajectory, 4e-4)
        found = one(plant, trajectory)
        # Sampling may miss what happens within 0.2 ms; the sweep what it says.
        assert -4e-4 <= found.value - brute <= max(OVERLOOKED, COARSE * (found.value - wanted)), k
        assert found.passed == (found.value >= wanted)
        counts["hit" if brute < 0 else "apart"] += 1
    assert min(counts.values()) >= 2, counts


def test_a_hair_is_not_jumped_over(rng: np.random.Generator) -> None:
    """A blade of 0.6 mm on the flange passes a wire of 0.6 mm at 7 m/s: rows of 1 kHz are 7 mm apart.

    The wire stands where no row is; the blade is through it after 0.2 ms.
    """
    plant = plant_without_rail()
    rate = 8.0
    blade = Solid(Box("blade", np.array([0.0006, 0.0006, 0.02])))  # at the flange's origin
    trajectory = turning(plant, STRETCHED, 0.8, rate, 1e-3)
    for share in rng.uniform(0.3, 0.7, 5):
        angle = float(trajectory.q[100, 0] + share * (trajectory.q[101, 0] - trajectory.q[100, 0]))
        p = np.array([REACH * np.cos(angle), REACH * np.sin(angle), HEIGHT])
        wire = Solid(Capsule("wire", p - UP / 100, p + UP / 100, 0.0003), EVERY_LINK)
        watched = replace(plant, obstacles=(wire,), attached=(blade,))
        flange = plant.robot.forward(trajectory.q)
        assert Pair(blade.shape, wire.shape).distances(flange).min() > 1e-3, "a row shows it; the test shows nothing"
        found = one(watched, trajectory)
        assert not found.passed
        assert found.value < -0.0004
        touched = trajectory.t[100] + (share * 1e-3) - 0.0006 / (rate * REACH)
        assert found.time == pytest.approx(touched, abs=5e-5)


@pytest.mark.parametrize(("gap", "hit"), [(2e-4, False), (-2e-4, True)])
def test_a_wall_just_beyond_reach_and_just_within(gap: float, hit: bool) -> None:
    """The stretched arm sweeps a circle; a ball of 50 mm on the flange is farthest out at joint_1 = 0, between rows."""
    plant = plant_without_rail()
    wall = box("wall", [0.1, 4, 4], [REACH + 0.05 + gap + 0.05, 0, 0], EVERY_LINK)
    watched = replace(plant, obstacles=(wall,), attached=(ball(0.05),))
    trajectory = turning(plant, STRETCHED, 0.5013, 3.0, 20e-3)
    assert np.abs(trajectory.q[:, 0]).min() > 5e-3
    found = one(watched, trajectory)
    assert found.value == pytest.approx(gap, abs=OVERLOOKED)
    assert found.passed is not hit
    assert found.subject == "ball and 'wall'"
    if not hit:
        assert found.time == pytest.approx(0.5013 / 3.0, abs=5e-3)


def test_the_first_touch_is_timed_in_closed_form() -> None:
    """The ball's centre reaches the distance of its radius from a wall beside the arm when R sin(angle) = y - r."""
    plant = plant_without_rail()
    y, r, rate = 0.3, 0.05, 2.0
    wall = box("wall", [4, 0.01, 4], [0, y + 0.005, 0], EVERY_LINK)
    watched = replace(plant, obstacles=(wall,), attached=(ball(r),))
    found = one(watched, turning(plant, STRETCHED, 0.6, rate, 1e-3))
    expected = (0.6 + np.arcsin((y - r) / REACH)) / rate
    assert found.time == pytest.approx(expected, abs=OVERLOOKED / (rate * REACH * 0.9) + 1e-6)
    deepest = REACH * np.sin(0.6 - rate * 1e-3) - y + r  # it passes the thin wall and is deepest when half through
    assert found.value == pytest.approx(-min(deepest, r + 0.005), abs=1e-3)


def test_the_rail_alone_runs_into_a_wall() -> None:
    """The base does not turn: closed form, at a constant speed of the rail."""
    plant = plant_with_rail()
    t = np.linspace(0, 1, 101)
    rows = np.tile(plant.start, (101, 1))
    rows[:, 0] = t
    trajectory = Trajectory(plant.limits.names, t, rows)
    (base,) = plant.robot.bodies["base_link"]
    assert isinstance(base, Polytope)
    front = base.vertices[:, 1].max()
    wall = box("wall", [4, 0.1, 0.1], [0, 0.9 + 0.05, 0.05], EVERY_LINK - {"base_link"})
    found = one(replace(plant, obstacles=(wall,)), trajectory)
    assert found.time == pytest.approx(0.9 - front, abs=2e-4)
    assert found.value < -0.1
    assert check(replace(plant, obstacles=(replace(wall, ignore=EVERY_LINK),)), trajectory).keys() == {
        (SELF_CLEARANCE, "")
    }


def test_a_base_that_no_axis_moves_is_not_held_against_the_table_it_stands_on() -> None:
    plant = plant_without_rail()
    table = box("table", [1, 1, 0.1], [0, 0, -0.05])
    found = one(replace(plant, obstacles=(table,)), turning(plant, HOME, 0.5, 1.0, 1e-2))
    assert found.passed
    assert "base_link" not in found.subject


def test_rows_without_speeds_are_joined_straight_and_with_speeds_by_their_cubic() -> None:
    """Two rows at the same place: straight between them nothing moves, by their speeds joint_1 swings out and back."""
    plant = plant_without_rail()
    rows = np.array([STRETCHED, STRETCHED])
    rate = np.zeros((2, 6))
    rate[:, 0] = [4.0, -4.0]
    t = np.array([0.0, 0.02])
    farthest = 4.0 * 0.02 / 4  # of the cubic, half way
    y = REACH * np.sin(farthest)
    wall = box("wall", [4, 0.01, 4], [0, 0.05 + y - 1e-3 + 0.005, 0], EVERY_LINK)
    plant = replace(plant, obstacles=(wall,), attached=(ball(0.05),))
    names = plant.limits.names
    assert one(plant, Trajectory(names, t, rows)).value == pytest.approx(y - 1e-3, abs=1e-6)
    found = one(plant, Trajectory(names, t, rows, rate))
    assert found.value == pytest.approx(-1e-3, abs=OVERLOOKED)
    assert not found.passed


def test_a_mirrored_motion_has_the_mirrored_clearance(rng: np.random.Generator) -> None:
    """y to -y turns joints 1, 4 and 6 around; a ball on the flange has no sides."""
    plant = plant_without_rail()
    mirror = np.array([-1, 1, 1, -1, 1, -1])
    for _ in range(3):
        position = rng.uniform(-0.6, 0.6, 3) + 0.6 * UP
        stops = list(rng.uniform(plant.limits.lower / 3, plant.limits.upper / 3, (2, 6)))
        values = []
        for side in (1, -1):
            wall = box("wall", [0.3, 0.2, 0.1], [position[0], side * position[1], position[2]], EVERY_LINK)
            watched = replace(plant, obstacles=(wall,), attached=(ball(0.05, 0.1),))
            q = [stop * (1 if side == 1 else mirror) for stop in stops]
            values.append(one(watched, quintic_move(plant, q)).value)
        assert values[0] == pytest.approx(values[1], abs=max(OVERLOOKED, COARSE * abs(values[0])))


def test_a_mesh_of_a_box_gives_the_boxes_answer(rng: np.random.Generator) -> None:
    plant = plant_without_rail()
    size, X = np.array([0.2, 0.3, 0.4]), pose(rotation_about([0, 0.6, 0.8], 0.7), [0.75, 0.2, 0.6])
    stops = list(rng.uniform(plant.limits.lower / 3, plant.limits.upper / 3, (3, 6)))
    first, second = (
        one(replace(plant, obstacles=(Solid(shape),)), quintic_move(plant, stops))
        for shape in (Box("thing", size, X), Mesh("thing", CORNERS * size, FACES, X))
    )
    assert (first.passed, first.time) == (second.passed, pytest.approx(second.time, abs=1e-3))


@pytest.mark.parametrize("as_mesh", [False, True])
def test_a_robot_that_starts_inside_a_body_hits_it(as_mesh: bool) -> None:
    """A block around the whole arm: no link ever touches the mesh's surface."""
    plant = plant_without_rail()
    size, X = np.array([4.0, 4.0, 4.0]), pose(np.eye(3), [0, 0, 0.5])
    shape = Mesh("block", CORNERS * size, FACES, X) if as_mesh else Box("block", size, X)
    trajectory = quintic_move(plant, [HOME, HOME * 0.5])
    found = one(replace(plant, obstacles=(Solid(shape),)), trajectory)
    assert (found.passed, found.time) == (False, 0.0)
    open_mesh = Mesh("tube", CORNERS * size, FACES[4:8], X)  # two walls of the block
    assert one(replace(plant, obstacles=(Solid(open_mesh),)), trajectory).passed


def segments_apart(a: Array, b: Array, c: Array, d: Array) -> float:
    """By ternary search along the first segment: the distance to a segment is convex."""

    def away(s: float) -> float:
        p = a + s * (b - a)
        u = np.clip((p - c) @ (d - c) / max((d - c) @ (d - c), 1e-30), 0, 1)
        return float(np.linalg.norm(p - c - u * (d - c)))

    low, high = 0.0, 1.0
    for _ in range(50):
        m, n = low + (high - low) / 3, high - (high - low) / 3
        low, high = (low, n) if away(m) < away(n) else (m, high)
    return away(low)


def test_a_posture_that_bends_the_hand_into_the_base_is_a_hit() -> None:
    """Both ways to the truth: joints that fold the arm down, and the capsules' segments by pin's poses."""
    import pinocchio as pin

    plant = plant_without_rail()
    folded = np.array([0, np.radians(20), np.radians(50), 0, np.radians(100), 0])
    robot = with_capsules(plant.robot)
    plant = replace(plant, robot=robot)
    data = robot.pin_model.createData()
    worst: dict[tuple[str, str], float] = {}
    trajectory = quintic_move(plant, [HOME, folded], 0.4, 5e-3)
    for row in trajectory.q[::-4]:  # the last one folds it most
        pin.framesForwardKinematics(robot.pin_model, data, row)
        ends = {}
        for name, (capsule,) in robot.bodies.items():
            X = data.oMf[robot.pin_model.getFrameId(name)]
            ends[name] = X * np.array(capsule.a), X * np.array(capsule.b), capsule.radius
        for first, second in robot.self_pairs:
            if second in ends:
                (a, b, r), (c, d, s) = ends[first], ends[second]
                worst[first, second] = min(worst.get((first, second), np.inf), segments_apart(a, b, c, d) - r - s)
    pair = min(worst, key=lambda names: worst[names])
    found = check(plant, trajectory)[SELF_CLEARANCE, ""]
    assert found.value == pytest.approx(worst[pair], abs=OVERLOOKED)
    assert (worst[pair] < 0) is (not found.passed)
    assert worst[pair] < -0.005, (pair, worst[pair])
    assert "hits link_1 with" in found.message or "hits base_link with" in found.message
    assert "name the pair under may_touch" in found.message
    allowed = frozenset(frozenset(names) for names, distance in worst.items() if distance < 0)
    assert check(replace(plant, may_touch=allowed), trajectory)[SELF_CLEARANCE, ""].passed


def test_what_the_flange_carries_is_held_against_the_robot() -> None:
    plant = plant_without_rail()
    long_tool = Solid(Capsule("lance", np.array([0, 0, 0.05]), np.array([0, 0, 0.7]), 0.02))
    down = np.array([0, 0, 0, 0, np.radians(110), 0])
    trajectory = quintic_move(plant, [HOME, down])
    found = check(replace(plant, attached=(long_tool,)), trajectory)[SELF_CLEARANCE, ""]
    assert not found.passed
    assert " with lance at " in found.message
    touched = found.subject.removeprefix("lance and ")
    allowed = replace(long_tool, ignore=EVERY_LINK)
    assert check(replace(plant, attached=(allowed,)), trajectory)[SELF_CLEARANCE, ""].passed
    assert touched in {"base_link", "link_1", "link_2"}
    pairs = frozenset(frozenset((link, "lance")) for link in EVERY_LINK)
    assert check(replace(plant, attached=(long_tool,), may_touch=pairs), trajectory)[SELF_CLEARANCE, ""].passed


def test_no_point_moves_farther_than_the_bound(rng: np.random.Generator) -> None:
    """The ground the sweep stands on: dense samples of random intervals, every body, seen from every link below it."""
    for name in ("irb140_rail", "irb140"):
        robot = load_robot(name, pose(rotation_about([0, 0.6, 0.8], 0.5), [0.1, 0.2, 0.3]))
        k, mechanism = len(robot.axis_names), Mechanism(robot.urdf, robot.X_WR)
        bodies = [Body(n, robot.bodies[n][0], i) for i, n in enumerate(robot.link_names)]
        tightest = 0.0
        for _ in range(4):
            n = 6
            t = np.cumsum(rng.uniform(0.01, 0.2, n))
            q = np.cumsum(rng.uniform(-0.3, 0.3, (n, k)), axis=0)
            trajectory = Trajectory(robot.axis_names, t, q, rng.normal(size=(n, k)) * 3)
            motion = InterpolatedMotion(trajectory)
            nodes = np.array([[0, 5], [1, 3], [2, 3], [2.25, 2.5], [3.5, 4], [4.875, 5]], dtype=float)
            sample = _Sample(mechanism, motion, nodes)
            for i, (s_0, s_1) in enumerate(nodes):
                s = np.r_[sample.middle[i], np.linspace(s_0, s_1, 100)]
                X = link_poses(robot, motion.at(s))
                for body in bodies:
                    for since in range(-1, body.frame):
                        seen = X[:, body.frame] if since < 0 else inverse_pose(X[:, since]) @ X[:, body.frame]
                        ends, radius = outline(body.shape)
                        skin = rng.normal(size=(10, 3))
                        skin *= radius / np.linalg.norm(skin, axis=1, keepdims=True)
                        points = np.concatenate([*(ends + one for one in skin), body.shape.vertices])
                        placed = points @ np.swapaxes(seen[:, :3, :3], 1, 2) + seen[:, None, :3, 3]
                        moved = np.linalg.norm(placed - placed[0], axis=2).max()
                        bound = sample.moved(body, since)[i]
                        assert moved <= bound + 1e-12
                        tightest = max(tightest, moved / bound if bound > 1e-9 else 0.0)
        assert tightest > 0.8  # and the bound is no giant


def test_the_course_is_the_hermite_and_its_swing_holds_it(rng: np.random.Generator) -> None:
    t = np.cumsum(rng.uniform(0.01, 0.2, 40))
    q, qd = rng.normal(size=(40, 3)), rng.normal(size=(40, 3)) * 5
    names = ("joint_1", "joint_2", "joint_3")
    trajectory = Trajectory(names, t, q, qd)
    motion = InterpolatedMotion(trajectory)
    s = np.sort(rng.uniform(0, 39, 500))
    times = np.array([motion.time(one) for one in s])
    np.testing.assert_allclose(motion.at(s), hermite(trajectory, times)[0], rtol=0, atol=1e-12)
    assert [motion.time(float(i)) for i in (0, 7, 38, 39)] == t[[0, 7, 38, 39]].tolist()
    np.testing.assert_allclose(motion.at(np.array([0.0, 38.0, 39.0])), q[[0, 38, 39]], rtol=0, atol=1e-12)
    straight = InterpolatedMotion(Trajectory(names, t, q)).at(s)
    np.testing.assert_allclose(straight, np.column_stack([np.interp(times, t, q[:, i]) for i in range(3)]), atol=1e-12)
    for _ in range(200):
        a, b = sorted(rng.integers(0, 40, 2))
        nodes = np.array([[a, b]], dtype=float) if a < b else np.array([[min(a, 38) + 0.25, min(a, 38) + 0.5]])
        middle = motion.at(nodes.mean(axis=1))
        dense = motion.at(np.linspace(*nodes[0], 400))
        swing = motion.swing(nodes[:, 0], nodes[:, 1], middle)[0]
        assert (np.abs(dense - middle[0]).max(axis=0) <= swing + 1e-12).all()


@pytest.mark.parametrize("speeds", [True, False])
def test_the_swing_over_many_rows_is_that_of_the_control_points(rng: np.random.Generator, speeds: bool) -> None:
    for n in (2, BLOCK, BLOCK + 1, BLOCK + 2, 5 * BLOCK + 3):
        t, q = np.cumsum(rng.uniform(0.01, 0.2, n)), rng.normal(size=(n, 3))
        qd = rng.normal(size=(n, 3)) * 5 if speeds else None
        motion = InterpolatedMotion(Trajectory(("joint_1", "joint_2", "joint_3"), t, q, qd))
        pairs = np.array([(a, b) for a in range(n) for b in range(a + 1, n)], dtype=float)
        here = rng.normal(size=(len(pairs), 3))
        found = motion.swing(*pairs.T, here)
        third = np.zeros((2, n - 1, 3)) if qd is None else np.diff(t)[:, None] / 3 * np.stack([qd[:-1], -qd[1:]])
        control = np.stack([q[:-1], q[:-1] + third[0], q[1:] + third[1], q[1:]])
        for (a, b), middle, swing in zip(pairs.astype(int), here, found, strict=True):
            wanted = np.abs(control[:, a:b] - middle).max(axis=(0, 1))
            np.testing.assert_allclose(swing, wanted, rtol=0, atol=1e-12)


def watched_case(*obstacles: Solid, **more: object) -> tuple[Plant, Program, Trajectory]:
    case = rapid_case()
    return replace(case.plant, obstacles=obstacles, **more), case.program, case.rows()


FAR = box("cupboard", [0.3, 0.3, 2.0], [-1.2, 0.2, 1.0])
LOW = box("anvil", [0.1, 0.1, 0.3], [0.5, 0.1, 0.20])  # under the point that line 12 goes down to: its top at 0.35


def test_the_judge_says_how_near_a_legal_motion_comes() -> None:
    plant, motions, rows = watched_case(FAR)
    report = verify(motions, plant, rows, target=Target.RAPID)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    found = next(f for f in report.findings if f.check == CLEARANCE)
    assert found.unit == "m"
    assert found.margin < 0  # at least, not at most
    assert found.message.endswith("; no touch deeper than 0.1 mm was overlooked")
    assert f"{found.subject} come nearest at {found.time:.3f} s, {found.value * 1e3:.1f} mm" in found.message
    assert {f.check for f in report.findings} >= {CLEARANCE, SELF_CLEARANCE}


def test_a_hit_is_illegal_and_names_motion_time_pair_and_depth() -> None:
    tip = 0.37 + 0.0074 - 0.0259  # of link_6's capsule over the flange at p_a
    assert tip > 0.35
    plant, motions, rows = watched_case(LOW, attached=(Solid(Capsule("pin", [0, 0, 0.01], [0, 0, 0.03], 0.01)),))
    report = verify(motions, plant, rows, target=Target.RAPID)
    assert not report.legal
    (found,) = (f for f in report.findings if not f.passed)
    depth = 0.35 - (0.37 - 0.04)  # the pin's tip stands 40 mm under the flange
    assert found.value == pytest.approx(-depth, abs=OVERLOOKED)
    assert found.source is not None
    assert found.source.line == 12
    end = rapid_case().starts[2]
    assert found.time is not None
    assert found.time < end
    deepest = found.message.split(" at ")[-1].split(" s")[0]
    assert found.message == (
        f"cell.mod:12:5: MoveL p_a hits 'anvil' with pin at {found.time:.3f} s, deepest 20.0 mm at {deepest} s"
    )


def test_helpers_pick_the_nearest_obstacle_and_the_hits_in_time_order() -> None:
    plant, motions, rows = watched_case(FAR, LOW, clearance=0.001, attached=(ball(0.01, 0.05),))
    findings = verify(motions, plant, rows).findings
    nearest = least_clearance(findings)
    assert nearest is not None
    assert nearest.subject.endswith("'anvil'")
    assert [f.subject for f in collisions(findings)] == [nearest.subject]
    assert least_clearance(f for f in findings if f.check != CLEARANCE) is None


def test_too_near_is_illegal_where_a_clearance_is_wanted() -> None:
    plant, motions, rows = watched_case(replace(LOW, ignore=EVERY_LINK), attached=(ball(0.01),), clearance=0.02)
    report = verify(motions, plant, rows)
    (found,) = (f for f in report.findings if not f.passed)
    assert (found.value, found.limit) == (pytest.approx(0.01, abs=OVERLOOKED), 0.02)  # 0.37 - 0.01 over 0.35
    assert found.message.startswith("cell.mod:12:5: MoveL p_a comes too close to 'anvil' with ball at ")
    assert " s, wanted 20 mm, least 10.0 mm at " in found.message
    assert verify(motions, replace(plant, clearance=0.0095), rows).legal


def test_an_obstacle_over_the_start_is_hit_at_once() -> None:
    plant, motions, rows = watched_case(
        box("lid", [0.2, 0.2, 0.02], plant_with_rail().robot.forward(np.r_[0.0, HOME])[:3, 3].tolist())
    )
    found = next(f for f in verify(motions, plant, rows).findings if f.check == CLEARANCE)
    assert (found.passed, found.time) == (False, 0.0)
    assert found.message.startswith("cell.mod:11:5: MoveJ p_a_in hits 'lid' with link_")


def test_a_rest_in_an_obstacle_is_hit_once_and_quickly() -> None:
    """A motion that stands still inside something must not be halved for ever."""
    plant = plant_without_rail()
    where = plant.robot.forward(HOME)[:3, 3].tolist()
    plant = replace(plant, obstacles=(box("lid", [0.2, 0.2, 0.02], where),))
    rows = np.tile(HOME, (5000, 1))
    found = one(plant, Trajectory(plant.limits.names, np.arange(5000) * 1e-3, rows, np.zeros_like(rows)))
    assert (found.passed, found.time) == (False, 0.0)


def test_files_as_we_write_them_give_the_same_clearance() -> None:
    plant, motions, rows = watched_case(FAR)
    text = write_csv_text(rows)
    read, resolution = read_csv_text(text, "x.csv")
    values = [
        [f.value for f in verify(motions, plant, one, resolution=r).findings if "clearance" in f.check]
        for one, r in ((rows, None), (read, resolution))
    ]
    np.testing.assert_allclose(values[0], values[1], atol=1e-6)


def test_without_obstacles_only_the_robot_itself_is_watched_and_without_shapes_nothing() -> None:
    plant, motions, rows = watched_case()
    assert [f.check for f in check_clearance(motions, plant, rows, lambda _: None)] == [SELF_CLEARANCE]
    bare = replace(plant, robot=replace(plant.robot, bodies={}, self_pairs=()), obstacles=(FAR,))
    assert check_clearance(motions, bare, rows, lambda _: None) == []


def test_the_programs_home_is_clear_of_itself() -> None:
    case_file = Path(__file__).parents[1] / "data" / "cases" / "hinge_cell.json"
    q = np.array(json.loads(case_file.read_text())["home_q"])
    plant = plant_with_rail()
    rest = Trajectory(plant.limits.names, np.array([0.0, 1.0]), np.array([q, q]))
    found = check_clearance(program(home_move(5)), plant, rest, lambda _: None)
    assert [f.passed for f in found] == [True]
    assert found[0].value > 0.05


def test_the_sweep_finds_no_first_miss_where_there_is_none() -> None:
    plant = plant_without_rail()
    trajectory = quintic_move(plant, [HOME, HOME * 0.5])
    body = Body("link_6", plant.robot.bodies["link_6"][0], 6)
    group = [Near(body, FAR.shape)]
    sweep = Sweep(mechanism_of(plant), trajectory)
    least = sweep.least(group)
    assert sweep.first_below(group, least.distance - 0.01) is None
    first = sweep.first_below(group, least.distance + 0.01)
    assert first is not None
    assert first.time <= least.time
