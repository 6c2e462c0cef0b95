"""Enclosures over the rail: random configurations must lie inside, rates included."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import MOUNTS, mounted, plant_with_rail

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.robot.enclosure import Enclosure, Range

TURN = 2 * np.pi


def enclosed(axes: Axes, X: Array, nodes: Array) -> Enclosure:
    limits = replace(axes.robot.profile(), lower=axes.lower, upper=axes.upper)
    return axes.robot.enclose(X, nodes, limits)


def wrist_rates(axes: Axes, q: Array) -> Array:
    """Rates (n, 3) of the first three joints per metre of rail while the wrist centre stands still in the world."""
    X_FT = pose(np.eye(3), [0.0, 0.0, -axes.robot.arm.L6])
    J = axes.jacobian(q, X_FT)[:, :3]
    return -np.linalg.solve(J[:, :, 1:4], J[:, :, :1])[..., 0]


def poses(axes: Axes, rng: np.random.Generator, n: int, d: float) -> list[Array]:
    """Flange poses around the arm as it stands at rail d, near and far, some straight above axis 1."""
    out = []
    for i in range(n):
        axis = rng.normal(size=3)
        R = rotation_about(axis / np.linalg.norm(axis), rng.uniform(0, np.pi))
        p = rng.uniform([-0.9, -0.9, -0.4], [0.9, 0.9, 1.2])
        if i % 6 == 0:  # wrist centre that passes close to axis 1
            p = axes.robot.arm.L6 * R[:, 2] + np.array([*rng.normal(size=2) * 1e-3, rng.uniform(0.5, 0.9)])
        out.append(axes.robot.base(np.array(d)) @ pose(R, p))
    return out


@pytest.mark.parametrize("width", [2.5e-3, 0.04, 0.3])
@pytest.mark.parametrize("mount", MOUNTS)
def test_random_configurations_lie_inside(mount: str, width: float) -> None:
    axes = mounted(mount, (-1.5, 1.5))
    rng = np.random.default_rng(int(width * 1e4))
    nodes = np.arange(-1.2, 1.2, width)
    checked, tight = 0, 0
    for X in poses(axes, rng, 30, 0.0):
        e = enclosed(axes, X, nodes)
        d = rng.uniform(nodes[0], nodes[-1], 400)
        arm = axes.inverse(np.broadcast_to(X, (400, 4, 4)), d)
        interval = np.searchsorted(nodes, d, side="right") - 1
        for cfx in range(8):
            row = 2 * bool(cfx & 4) + bool(cfx & 2)
            q = arm[:, cfx]
            low, high = axes.lower[1:4], axes.upper[1:4]
            turned = q[:, :3, None] + TURN * np.array([-1, 0, 1])
            inside = (turned >= low[:, None] + 1e-9) & (turned <= high[:, None] - 1e-9)
            ok = np.all(inside.any(axis=2), axis=1) & ~np.isnan(q[:, 0])
            if not ok.any():
                continue
            i, q = interval[ok], q[ok]
            assert np.all(e.alive[row, i]), f"{mount}: a reachable interval is given up, cfx {cfx}"
            # a joint may be met a turn away, if the enclosure holds that turn
            for j in range(3):
                values = np.where(inside[ok, j], turned[ok, j], np.nan)
                lo, hi = e.q.lo[j, row, i, None], e.q.hi[j, row, i, None]
                assert np.all(np.any((values >= lo - 1e-12) & (values <= hi + 1e-12), axis=1)), (
                    f"{mount}: joint_{j + 1}, cfx {cfx}, outside its enclosure at rail {d[ok]}"
                )
            far = (np.abs(np.cos(q[:, 2])) > 1e-5) & (axis_distance(axes, q) > 1e-5)
            rate = wrist_rates(axes, np.column_stack([d[ok], q])[far])
            for j in range(3):
                lo, hi = e.rate.lo[j, row, i[far]], e.rate.hi[j, row, i[far]]
                room = 1e-9 * (1 + np.abs(rate[:, j]))
                assert np.all((rate[:, j] >= lo - room) & (rate[:, j] <= hi + room)), (mount, j, cfx)
            checked += int(ok.sum())
            tight += int(np.sum(e.q.hi[:, row, i] - e.q.lo[:, row, i] < 0.1) // 3)
    assert checked > 5000
    if width < 0.01:
        assert tight > 0.95 * checked  # an enclosure that says nothing would pass all of the above


def axis_distance(axes: Axes, q: Array) -> Array:
    arm = axes.robot.arm
    return np.abs(arm.a1 + arm.L2 * np.sin(q[:, 1]) + arm.L4 * np.cos(q[:, 1] + q[:, 2]))


def test_out_of_reach_is_given_up() -> None:
    axes = Axes.of(plant_with_rail((-1.5, 1.5)))
    X = axes.robot.base(np.array(0.0)) @ pose(np.eye(3), [0.5, 0.0, 0.3])
    e = enclosed(axes, X, np.array([-1.4, -1.39, 1.39, 1.4]))
    assert not np.any(e.alive[:, [0, 2]])
    far = axes.robot.base(np.array(0.0)) @ pose(np.eye(3), [1.2, 0.0, 0.3])
    assert not np.any(enclosed(axes, far, np.linspace(-1.4, 1.4, 200)).alive)


def test_ranges_hold_every_combination_of_their_members() -> None:
    rng = np.random.default_rng(4)
    lo = rng.normal(size=(2, 500))
    a, b = (Range(x, x + rng.uniform(0, 2, 500)) for x in lo)
    positive = Range(np.abs(b.lo), np.abs(b.lo) + 1)
    for _ in range(20):
        x, y = (r.lo + rng.uniform(0, 1, 500) * (r.hi - r.lo) for r in (a, b))
        z = positive.lo + rng.uniform(0, 1, 500) * (positive.hi - positive.lo)
        for value, r in (
            (x + y, a + b),
            (x - y, a - b),
            (x * y, a * b),
            (-1.7 * x, a.scaled(-1.7)),
            (x * x, a.square()),
            (x / z, a.over(positive)),
        ):
            assert np.all((value >= r.lo - 1e-12) & (value <= r.hi + 1e-12))
        assert np.all(np.abs(x) <= a.magnitude())
    crossing = Range(np.array([-1.0]), np.array([2.0]))
    assert (crossing.square().lo[0], crossing.square().hi[0]) == (0.0, 4.0)


@pytest.mark.parametrize("mount", MOUNTS)
def test_rates_on_a_way_of_the_tool_lie_inside(mount: str) -> None:
    """The first three joints' rates as the flange follows a twist with the rail at rest, against the Jacobian's."""
    axes = mounted(mount, (-1.5, 1.5))
    rng = np.random.default_rng(7)
    nodes = np.arange(-1.2, 1.2, 0.02)
    limits = replace(axes.robot.profile(), lower=axes.lower, upper=axes.upper)
    checked, tight = 0, 0
    for X in poses(axes, rng, 20, 0.0):
        twist = rng.normal(size=6) * [0.3, 0.3, 0.3, 1, 1, 1]
        e = axes.robot.enclose(X, nodes, limits, twist)
        assert e.way is not None
        d = rng.uniform(nodes[0], nodes[-1], 200)
        arm = axes.inverse(np.broadcast_to(X, (200, 4, 4)), d)
        for cfx in range(8):
            row, q = 2 * bool(cfx & 4) + bool(cfx & 2), arm[:, cfx]
            whole = np.column_stack([d, q])
            with np.errstate(invalid="ignore"):
                ok = (np.abs(np.cos(q[:, 2])) > 1e-3) & (np.abs(np.sin(q[:, 4])) > 1e-2) & ~np.isnan(q[:, 0])
            ok[ok] &= axis_distance(axes, q[ok]) > 1e-3
            if not ok.any():
                continue
            i = np.searchsorted(nodes, d[ok], side="right") - 1
            rate = np.linalg.solve(axes.jacobian(whole[ok], np.eye(4))[:, :, 1:], twist)[:, :3]
            lo, hi = (x[:, row, i].T for x in (e.way.lo, e.way.hi))
            slack = 1e-7 * (1 + np.abs(rate))
            assert np.all((lo - slack <= rate) & (rate <= hi + slack)), f"{mount}, cfx {cfx}"
            checked += rate.size
            tight += int(np.sum(hi - lo < 0.2 + np.abs(rate)))
    assert checked > 3000
    assert tight > 0.5 * checked
