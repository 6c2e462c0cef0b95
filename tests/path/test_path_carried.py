"""Work carried past a stationary tool: straight or round over the work, whatever that makes of the flange."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from path_checks import check_slopes, inside, random_pose, seeds
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.carried import Carried, over_work
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.line import Line

S = np.linspace(0, 1, 21)


def flange(segment: Carried, s: Array) -> Array:
    """As everything downstream takes it from a tool on the flange."""
    return np.asarray(segment.pose(s) @ np.linalg.inv(segment.X_FT))


def tool_on_work(segment: Carried, s: Array) -> Array:
    """The standing tool as the work sees it."""
    return np.asarray(np.linalg.inv(flange(segment, s)) @ segment.X_WS)


def line(rng: np.random.Generator) -> tuple[Carried, Array]:
    X_WF, X_WS, X_FT = (random_pose(rng) for _ in range(3))
    return Carried.to(X_WF, X_WS, X_FT), X_WF


def arc(rng: np.random.Generator) -> tuple[Carried, Array]:
    X_WF, X_WS, X_FT, X_FV = (random_pose(rng) for _ in range(4))
    X_WV = X_WS @ np.linalg.inv(X_FV) @ X_FT  # the target where the via point is at the tool
    return Carried.to(X_WF, X_WS, X_FT, X_WV), X_WF


@given(seeds, st.booleans())
@settings(max_examples=40)
def test_it_leads_from_the_flange_to_the_target_at_the_tool(seed: int, round_: bool) -> None:
    segment, X_WF = (arc if round_ else line)(np.random.default_rng(seed))
    at = segment.pose(np.array([0.0, 1.0]))
    np.testing.assert_allclose(at[0] @ inverse_pose(segment.X_FT), X_WF, rtol=0, atol=1e-9)
    np.testing.assert_allclose(at[1], segment.X_WS, rtol=0, atol=1e-9)


@given(seeds)
@settings(max_examples=40)
def test_the_tool_goes_straight_over_the_work(seed: int) -> None:
    segment, X_WF = line(np.random.default_rng(seed))
    X_FS = tool_on_work(segment, S)
    first, last = np.linalg.inv(X_WF) @ segment.X_WS, segment.X_FT
    np.testing.assert_allclose(X_FS[:, :3, 3], first[:3, 3] + S[:, None] * (last - first)[:3, 3], rtol=0, atol=1e-12)
    slerp = Slerp([0, 1], Rotation.from_matrix([first[:3, :3], last[:3, :3]]))
    np.testing.assert_allclose(X_FS[:, :3, :3], slerp(S).as_matrix(), rtol=0, atol=1e-12)
    assert abs(segment.length - np.linalg.norm((last - first)[:3, 3])) < 1e-12
    assert abs(segment.angle - (slerp(0.0).inv() * slerp(1.0)).magnitude()) < 1e-9


@given(seeds)
@settings(max_examples=40)
def test_the_tool_goes_round_over_the_work_through_the_via_point(seed: int) -> None:
    segment, _ = arc(np.random.default_rng(seed))
    p = tool_on_work(segment, S)[:, :3, 3]
    way = segment.way
    assert isinstance(way, Arc)
    np.testing.assert_allclose(np.linalg.norm(p - way.centre, axis=1), way.radius, rtol=1e-6)
    assert abs(segment.length - way.radius * way.sweep) < 1e-9
    rng = np.random.default_rng(seed)
    X_FV = [random_pose(rng) for _ in range(4)][3]
    fine = tool_on_work(segment, np.linspace(0, 1, 4001))[:, :3, 3]
    assert np.linalg.norm(fine - X_FV[:3, 3], axis=1).min() <= segment.length / 4000


@given(seeds, st.booleans())
@settings(max_examples=20)
def test_slopes_of_carried_work(seed: int, round_: bool) -> None:
    """The bound: rates of turning up to pi and of the tool's way up to 2 pi per unit of s, levers of a metre."""
    rng = np.random.default_rng(seed)
    segment, _ = (arc if round_ else line)(rng)
    sweep = segment.way.sweep if isinstance(segment.way, Arc) else 1.0
    rate = np.pi + sweep
    check_slopes(segment, rng, bound=(1 + segment.length) * rate**4)


@given(seeds)
@settings(max_examples=20)
def test_a_corner_over_the_work_is_carried_too(seed: int) -> None:
    rng = np.random.default_rng(seed)
    X_WS, *X_FS = (random_pose(rng) for _ in range(4))
    before, after = Line(X_FS[0], X_FS[1]), Line(X_FS[1], X_FS[2])
    r = 0.4 * min(before.length, after.length)
    segment = Carried(Corner.of_zone(before, after, r, r), X_WS, X_FS[1])
    ends = flange(segment, np.array([0.0, 1.0]))
    np.testing.assert_allclose(
        ends[0], X_WS @ np.linalg.inv(before.pose(np.array([1 - r / before.length]))[0]), atol=1e-9
    )
    np.testing.assert_allclose(ends[1], X_WS @ np.linalg.inv(after.pose(np.array([r / after.length]))[0]), atol=1e-9)
    turning = np.abs(segment.twist(S)[:, 3:]).max() + 1
    check_slopes(segment, rng, bound=10 * turning**4)


@given(seeds, st.booleans())
@settings(max_examples=20)
def test_speed_over_the_work_is_the_slope_of_the_way(seed: int, round_: bool) -> None:
    """From the flange's motion in the world back to the way it was made from; speeds, and the change of them."""
    rng = np.random.default_rng(seed)
    segment, _ = (arc if round_ else line)(rng)
    s = inside(segment, rng)
    on_flange = Carried(segment.way, segment.X_WS, np.eye(4))  # the flange itself followed
    V, A = over_work(on_flange.pose(s), on_flange.twist(s), on_flange.twist_rate(s), segment.X_WS[:3, 3])
    np.testing.assert_allclose(V, segment.way.twist(s), rtol=0, atol=1e-9 * (1 + np.abs(V).max()))
    np.testing.assert_allclose(A, segment.way.twist_rate(s), rtol=0, atol=1e-8 * (1 + np.abs(V).max() ** 2))
