"""The sweep over pairs that are held against each other for a while only, against dense samples of closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from clear_of import with_capsules
from legal_motion import plant_with_rail
from link_poses import link_poses
from scipy.interpolate import BPoly, CubicHermiteSpline

from trajopt_cli.geometry import Array
from trajopt_cli.judge.continuous_collision import COARSE, OVERLOOKED, Body, InterpolatedMotion, Near, Sweep
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.shapes import Capsule
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
ROBOT: RobotModel = with_capsules(PLANT.robot)
N, DENSE = 60, 40  # rows, and samples between two of them


def motion(seed: int) -> tuple[Trajectory, Array, Array, Array]:
    """Rows of a smooth motion of all axes; dense times, in rows and in s, and the poses of links and flange there."""
    rng = np.random.default_rng(seed)
    t = np.cumsum(rng.uniform(0.01, 0.03, N))
    phase, rate = rng.uniform(0, 6, 7), rng.uniform(2, 5, 7)
    q, qd = (f(rate * t[:, None] + phase) * x for f, x in ((np.sin, 0.5), (np.cos, 0.5 * rate)))
    s = np.linspace(0, N - 1, (N - 1) * DENSE + 1)
    i = np.minimum(s.astype(int), N - 2)
    times = t[i] + (s - i) * (t[i + 1] - t[i])
    at = CubicHermiteSpline(t, q, qd)(times)
    X = np.concatenate([link_poses(ROBOT, at), ROBOT.forward(at)[:, None]], axis=1)
    return Trajectory(PLANT.limits.names, t, q, qd), s, times, X


def apart(a: Array, b: Array, point: Array) -> Array:
    """Distances (n,) of points (n, 3) from segments a to b (n, 3)."""
    way = b - a
    share = np.clip(((point - a) * way).sum(axis=1) / (way * way).sum(axis=1), 0, 1)
    return np.linalg.norm(a + share[:, None] * way - point, axis=1)


def distances(X: Array, near: Near) -> Array:
    """Of a link's capsule from a ball in the world, or of a ball on the flange from it."""
    link = near.body if near.other is None else near.other
    a, b = (X[:, link.frame, :3, :3] @ end + X[:, link.frame, :3, 3] for end in (link.shape.a, link.shape.b))
    if near.other is None:
        return apart(a, b, np.tile(near.obstacle.a, (len(a), 1))) - link.shape.radius - near.obstacle.radius
    ball = near.body.shape
    return apart(a, b, X[:, 7, :3, :3] @ ball.a + X[:, 7, :3, 3]) - link.shape.radius - ball.radius


def inside(s: Array, near: Near) -> Array:
    spans = near.spans or ((0, N - 1),)
    return np.any([(s >= first) & (s <= last) for first, last in spans], axis=0)


@pytest.mark.parametrize("seed", range(4))
def test_bodies_count_in_their_spans_alone(seed: int) -> None:
    """The least distance, its time, and when one is first below a limit: within the spans, wherever else it is less."""
    rng = np.random.default_rng(100 + seed)
    trajectory, s, t, X = motion(seed)
    links = [Body(name, ROBOT.bodies[name][0], i) for i, name in enumerate(ROBOT.link_names)]
    spots = X[rng.integers(0, len(s), 3), rng.integers(3, 7, 3), :3, 3] + rng.uniform(-0.2, 0.2, (3, 3))
    balls = [Capsule(f"ball_{i}", spot, spot, 0.02) for i, spot in enumerate(spots)]
    held = Body("held", Capsule("held", np.array([0.0, 0.1, 0.3]), np.array([0.0, 0.1, 0.3]), 0.02), 7)
    group = []
    for ball in balls:
        cuts = np.sort(rng.choice(N, 4, replace=False)).tolist()
        spans = () if seed == 0 else ((cuts[0], cuts[1]), (cuts[2], cuts[3]))
        group.append(Near(links[int(rng.integers(3, len(links)))], ball, None, spans))
    group.append(Near(held, None, links[2], ((5, 25),) if seed % 2 else ()))
    found = {id(near): np.where(inside(s, near), distances(X, near), np.inf) for near in group}
    sweep = Sweep(Mechanism(ROBOT.urdf, ROBOT.X_WR), trajectory)
    least = sweep.least(group)
    wanted = min(float(one.min()) for one in found.values())
    assert least.proven
    assert least.distance == pytest.approx(wanted, abs=max(OVERLOOKED, COARSE * abs(wanted)) + 2e-4)
    i = int(np.searchsorted(t, least.time))
    own = found[id(least.near)]
    assert own[max(i - 1, 0) : i + 2].min() == pytest.approx(least.distance, abs=2e-3)
    far = [one for one in found.values() if np.isfinite(one).all()]
    assert (seed == 0) == (len(far) > 2)
    for limit in (wanted + 0.01, wanted + 0.05, wanted + 0.2):
        first = sweep.first_below(group, limit)
        below = np.min(list(found.values()), axis=0) < limit
        assert first is not None
        assert first.distance < limit
        assert first.time == pytest.approx(t[int(np.argmax(below))], abs=5e-3)
        assert found[id(first.near)][max(int(np.searchsorted(t, first.time)) - 2, 0)
                                     : int(np.searchsorted(t, first.time)) + 3].min() < limit + 1e-3  # fmt: skip
    assert sweep.first_below(group, wanted - 2 * OVERLOOKED - 2e-4) is None


def test_the_swing_of_a_part_of_a_row_is_that_of_its_control_points() -> None:
    """SciPy's Bernstein polynomial of the same cubic."""
    trajectory, _, _, _ = motion(9)
    course, rng = InterpolatedMotion(trajectory), np.random.default_rng(10)
    i = rng.integers(0, N - 1, 50)
    u = np.sort(rng.uniform(0, 1, (50, 2)), axis=1)
    here = rng.normal(size=(50, 7))
    found = course.swing(i + u[:, 0], i + u[:, 1], here)
    spline = CubicHermiteSpline(trajectory.t, trajectory.q, trajectory.qd)
    for k, row in enumerate(i):
        ends = trajectory.t[row] + u[k] * (trajectory.t[row + 1] - trajectory.t[row])
        part = BPoly.from_derivatives(ends, np.stack([spline(ends), spline(ends, 1)], axis=1))
        np.testing.assert_allclose(found[k], np.abs(part.c[:, 0] - here[k]).max(axis=0), rtol=1e-9)
