"""What the tool's caps ask for along a path, against the vectors that they hold for."""

from __future__ import annotations

import numpy as np
from small_cells import plant_with_rail

from trajopt_cli.trajectories.axes import Axes, AxisLimits
from trajopt_cli.trajectories.limits.limit import PathSamples
from trajopt_cli.trajectories.limits.tool_limit import ToolLimit

M = 300
RNG = np.random.default_rng(11)


def samples(axes: Axes, v_tcp: float, a_tcp: float, v_ori: float, ramps: tuple[float, float]) -> PathSamples:
    of_axes = np.ones((M, axes.n))
    caps = AxisLimits(of_axes, of_axes, *(np.full(M, x) for x in (v_tcp, a_tcp, v_ori)), np.tile(ramps, (M, 1)))
    tool = RNG.normal(size=(3, M, 3))
    return PathSamples([], np.zeros(M, dtype=np.intp), caps, of_axes, of_axes, of_axes, *tool, np.zeros((M, 2)))


def test_the_polygon_holds_the_acceleration_within_two_percent() -> None:
    axes = Axes.of(plant_with_rail((0.0, 0.8)))
    path = samples(axes, 2.0, 5.0, 3.0, (np.inf, np.inf))
    rows = ToolLimit(axes).path_rows(path)
    assert not rows.rests.any()
    rate = np.min(rows.top, axis=1)
    used = np.maximum(rate * np.linalg.norm(path.v, axis=1) / 2.0, rate * np.linalg.norm(path.w, axis=1) / 3.0)
    np.testing.assert_allclose(used, 1.0, rtol=1e-12)
    for _ in range(20):
        u, x = RNG.normal(size=(M, 1)), RNG.uniform(0, 2, (M, 1))
        wanted = np.linalg.norm(path.v * u + path.bend * x, axis=1) / 5.0
        found = np.abs(rows.slopes * u + rows.bends * x).max(axis=1)
        assert np.all(found <= wanted * (1 + 1e-12))
        assert np.all(found >= wanted * np.cos(np.pi / 16) * (1 - 1e-12))


def test_along_the_path_speeding_up_and_slowing_down_have_their_own_limits() -> None:
    axes = Axes.of(plant_with_rail((0.0, 0.8)))
    path = samples(axes, 2.0, 5.0, 3.0, (1.5, 4.0))
    rows = ToolLimit(axes).path_rows(path)
    size, x = np.linalg.norm(path.v, axis=1), RNG.uniform(0, 2, M)
    forward = np.sum(path.v * path.bend, axis=1) / size
    for along, wanted in ((1.5, 1.0), (-4.0, -1.0), ((1.5 - 4.0) / 2, 0.0)):
        u = (along - forward * x) / size
        found = rows.slopes[:, -1] * u + rows.bends[:, -1] * x + rows.rests[:, -1]
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9)
    assert not rows.rests[:, :-1].any()


def test_a_tool_at_rest_is_not_limited() -> None:
    axes = Axes.of(plant_with_rail((0.0, 0.8)))
    path = samples(axes, 2.0, np.inf, np.inf, (np.inf, np.inf))
    for x in (path.v, path.w, path.bend):
        x[:] = 0.0
    rows = ToolLimit(axes).path_rows(path)
    assert np.isinf(rows.top).all()
    assert not rows.slopes.any()
    assert not rows.bends.any()
