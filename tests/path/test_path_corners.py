"""Corners of lines and arcs: parabolas where they are known to be, smooth at their ends, inside their zones."""

from __future__ import annotations

from dataclasses import replace
from math import asinh, comb, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from path_checks import check_expression, check_slopes, inside, random_pose, seeds
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, pose
from trajopt_cli.motion import CirPathMode
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.corner import Corner, CornerSymbols
from trajopt_cli.path.line import Line
from trajopt_cli.path.segment import along_all

S = np.linspace(0, 1, 41)
KINDS = ("line", "arc")
kinds = st.sampled_from(KINDS)
# parts of a corner where position and orientation are bent
PARTS = ((1.0, 1.0), (0.6, 1.0), (1.0, 0.3))
parts = st.sampled_from(PARTS)


def onward(rng: np.random.Generator, kind: str, X_0: Array, mode: CirPathMode = CirPathMode.OBJECT_FRAME) -> Line | Arc:
    """A segment from X_0 that turns by up to 1 rad."""
    R = X_0[:3, :3] @ Rotation.from_rotvec(rng.uniform(-0.57, 0.57, 3)).as_matrix()
    p = X_0[:3, 3] + rng.uniform(0.1, 0.4, 3) * rng.choice([-1, 1], 3)
    if kind == "line":
        return Line(X_0, pose(R, p))
    via = X_0[:3, 3] + rng.uniform(0.1, 0.4, 3) * rng.choice([-1, 1], 3)
    return Arc.through(X_0, pose(X_0[:3, :3], via), pose(R, p), mode)


def reversed_(segment: Line | Arc) -> Line | Arc:
    if isinstance(segment, Line):
        return Line(segment.X_1, segment.X_0)
    return Arc(segment.X_1, segment.X_0, segment.centre, -segment.normal, segment.sweep)


def moved(segment: Line | Arc, X: Array) -> Line | Arc:
    if isinstance(segment, Line):
        return Line(X @ segment.X_0, X @ segment.X_1)
    R, p = X[:3, :3], X[:3, 3]
    return Arc(X @ segment.X_0, X @ segment.X_1, R @ segment.centre + p, R @ segment.normal, segment.sweep)


def some_corner(rng: np.random.Generator, pair: tuple[str, str], bent: tuple[float, float]) -> Corner:
    """A corner of equal ways on both sides, as of a zone."""
    before = onward(rng, pair[0], random_pose(rng))
    after = onward(rng, pair[1], before.X_1)
    largest = min(before.length, after.length) * rng.uniform(0.1, 0.5)
    return Corner.of_zone(before, after, largest * bent[0], largest * bent[1])


@pytest.mark.parametrize("one", KINDS)
@pytest.mark.parametrize("other", KINDS)
@pytest.mark.parametrize("mode", [CirPathMode.OBJECT_FRAME, CirPathMode.PATH_FRAME])
def test_the_expression_of_a_corner_says_what_its_numbers_say(one: str, other: str, mode: CirPathMode) -> None:
    rng = np.random.default_rng(3)
    for _ in range(2):
        before = onward(rng, one, random_pose(rng), mode)
        after = onward(rng, other, before.X_1, mode)
        corner = Corner.of_zone(before, after, *[0.4 * min(before.length, after.length)] * 2)
        assert corner.whole
        check_expression(corner, rng)
    assert not some_corner(rng, (one, other), (0.6, 1.0)).whole  # a curve of three parts


def test_a_corner_without_turns_has_none_in_its_expression() -> None:
    X = random_pose(np.random.default_rng(4))
    here, there, on = (pose(X[:3, :3], p) for p in np.eye(3))
    corner = Corner.of_zone(Line(here, there), Line(there, on), 0.2, 0.2)
    assert corner.symbols == CornerSymbols(())
    check_expression(corner, np.random.default_rng(5))


@given(seeds, parts)
@settings(max_examples=20)
def test_many_segments_at_once_say_what_each_says(seed: int, bent: tuple[float, float]) -> None:
    rng = np.random.default_rng(seed)
    X = random_pose(rng)
    straight = Line(X, pose(X[:3, :3], X[:3, 3] + 0.1))
    some = [some_corner(rng, pair, bent) for pair in (("line", "line"), ("line", "arc"), ("line", "line"))]
    segments = [straight, some[0], onward(rng, "line", X), some[1], onward(rng, "arc", X), some[2], some[0], straight]
    shares = [np.sort(np.r_[0, rng.uniform(0, 1, n), 1]) for n in range(3, 3 + len(segments))]
    found = along_all(segments, shares)
    wanted = [(one.pose(s), one.twist(s), one.twist_rate(s)) for one, s in zip(segments, shares, strict=True)]
    for at_once, alone in zip(found, zip(*wanted, strict=True), strict=True):
        assert np.abs(at_once - np.concatenate(alone)).max() < 1e-13


@given(seeds)
@settings(max_examples=25)
def test_between_lines_a_corner_is_the_parabola_entry_point_exit(seed: int) -> None:
    corner = some_corner(np.random.default_rng(seed), ("line", "line"), (1.0, 1.0))
    point = corner.after.X_0
    entry = corner.before.pose(np.array([1 - corner.fraction_before]))[0]
    end = corner.after.pose(np.array([corner.fraction_after]))[0]
    u = S[:, None]
    wanted = (1 - u) ** 2 * entry[:3, 3] + 2 * u * (1 - u) * point[:3, 3] + u**2 * end[:3, 3]
    got = corner.pose(S)
    np.testing.assert_allclose(got[:, :3, 3], wanted, rtol=0, atol=1e-14)
    first = Rotation.from_matrix(entry[:3, :3].T @ point[:3, :3]).as_rotvec()
    second = Rotation.from_matrix(point[:3, :3].T @ end[:3, :3]).as_rotvec()
    rotation = Rotation.from_matrix(entry[:3, :3]) * Rotation.from_rotvec((2 * u - u * u) * first)
    rotation = rotation * Rotation.from_rotvec(u * u * second)
    np.testing.assert_allclose(got[:, :3, :3], rotation.as_matrix(), rtol=0, atol=1e-13)


@pytest.mark.parametrize("between", [30, 90, 150, 179])
def test_a_corner_is_as_long_as_its_parabola(between: float) -> None:
    """between: the ways' directions [deg]; 179 nearly turns back. Arc length of y = x^2 / (4 f) in closed form."""
    r, half = 0.05, np.radians(between) / 2
    X = [pose(np.eye(3), p) for p in ([-np.cos(half), np.sin(half), 0], [0, 0, 0], [np.cos(half), np.sin(half), 0])]
    corner = Corner.of_zone(Line(X[0], X[1]), Line(X[1], X[2]), r, r)
    x, f = r * np.cos(half), r * np.cos(half) ** 2 / (2 * np.sin(half))
    k = x / (2 * f)
    assert corner.length == pytest.approx(2 * f * (k * sqrt(1 + k * k) + asinh(k)), rel=1e-6)
    assert corner.angle == 0
    # half as high as the point, in the middle
    np.testing.assert_allclose(corner.pose(np.array([0.5]))[0, :3, 3], [0, r * np.sin(half) / 2, 0], rtol=0, atol=1e-15)


def test_a_corner_straight_on_is_the_line() -> None:
    X_0, X_2 = np.eye(4), pose(Rotation.from_rotvec([0, 0, 1.2]).as_matrix(), [0.4, 0, 0])
    whole = Line(X_0, X_2)
    X_1 = whole.pose(np.array([0.25]))[0]
    corner = Corner.of_zone(Line(X_0, X_1), Line(X_1, X_2), 0.02, 0.04)
    np.testing.assert_allclose(corner.pose(S), whole.pose(0.15 + 0.2 * S), rtol=0, atol=1e-15)
    assert corner.length == pytest.approx(0.08, rel=1e-14)
    assert corner.angle == pytest.approx(0.24, rel=1e-14)


@given(seeds, kinds, kinds, parts)
@settings(max_examples=40)
def test_a_corner_goes_over_into_its_neighbours_with_their_rates(
    seed: int, one: str, other: str, bent: tuple[float, float]
) -> None:
    corner = some_corner(np.random.default_rng(seed), (one, other), bent)
    before, after, a, b = corner.before, corner.after, corner.fraction_before, corner.fraction_after
    ends = np.array([0.0, 1.0])
    np.testing.assert_allclose(
        corner.pose(ends), [before.pose(np.array([1 - a]))[0], after.pose(np.array([b]))[0]], rtol=0, atol=1e-13
    )
    wanted = [2 * a * before.twist(np.array([1 - a]))[0], 2 * b * after.twist(np.array([b]))[0]]
    np.testing.assert_allclose(corner.twist(ends), wanted, rtol=0, atol=1e-12)
    # the same TCP speed on both sides: its way over one s is that of the whole zone
    way = 2 * a * before.length
    np.testing.assert_allclose(np.linalg.norm(corner.twist(ends)[:, :3], axis=1), way, rtol=1e-9)
    for edge in corner.breaks:
        left, right = np.array([edge - 1e-9]), np.array([edge + 1e-9])
        np.testing.assert_allclose(corner.pose(left), corner.pose(right), rtol=0, atol=1e-7)
        np.testing.assert_allclose(corner.twist(left), corner.twist(right), rtol=0, atol=1e-6)


@given(seeds, kinds, kinds, parts)
@settings(max_examples=40)
def test_a_corner_stays_in_its_zone(seed: int, one: str, other: str, bent: tuple[float, float]) -> None:
    """Inside the sphere while the position is bent, and on the segments before and after."""
    corner = some_corner(np.random.default_rng(seed), (one, other), bent)
    radius = corner.position * corner.fraction_before * corner.before.length
    s = np.linspace(0, 1, 403)[1:-1]  # none on the edge of a part
    p = corner.pose(s)[:, :3, 3]
    bend = np.abs(s - 0.5) <= corner.position / 2
    assert np.linalg.norm(p[bend] - corner.after.X_0[:3, 3], axis=1).max() <= radius * (1 + 1e-12)
    first, last = s[~bend & (s < 0.5)], s[~bend & (s > 0.5)]
    on_before = corner.before.pose(1 - corner.fraction_before * (1 - 2 * first))[:, :3, 3]
    on_after = corner.after.pose(corner.fraction_after * (2 * last - 1))[:, :3, 3]
    np.testing.assert_allclose(p[~bend], np.vstack([on_before, on_after]), rtol=0, atol=1e-14)


def test_turns_in_place_have_corners_too() -> None:
    rng = np.random.default_rng(8)
    X = random_pose(rng)
    R = [X[:3, :3] @ Rotation.from_rotvec(v).as_matrix() for v in ([0, 0, 0.8], [0.5, 0, 0])]
    before, after = Line(pose(R[0], X[:3, 3]), X), Line(X, pose(R[1], X[:3, 3]))
    corner = Corner(before, after, 0.25, 0.4)
    check_slopes(corner, rng, bound=1.0)
    np.testing.assert_allclose(corner.pose(S)[:, :3, 3], np.tile(X[:3, 3], (41, 1)), rtol=0, atol=1e-15)
    np.testing.assert_allclose(
        np.linalg.norm(corner.twist(np.array([0.0, 1.0]))[:, 3:], axis=1), [2 * 0.25 * 0.8, 2 * 0.4 * 0.5], rtol=1e-12
    )
    assert len(inside(corner, rng)) > 20


def test_what_is_no_corner_is_refused() -> None:
    X = [pose(np.eye(3), p) for p in ([0, 0, 0], [0.1, 0, 0], [0.1, 0.3, 0])]
    before, after = Line(X[0], X[1]), Line(X[1], X[2])
    with pytest.raises(InputError, match="a zone of 60 mm reaches beyond the middle of a way of 100 mm; at most 50"):
        Corner.of_zone(before, after, 0.05, 0.06)
    with pytest.raises(InputError, match="needs zones above 0 mm, found 0 mm"):
        Corner.of_zone(before, after, 0.0, 0.05)
    half = Corner.of_zone(before, after, 0.05 * (1 + 1e-9), 0.025)  # rounding beyond the middle is let pass
    assert (half.fraction_before, half.fraction_after) == pytest.approx((0.5, 1 / 6))
    assert (half.position, half.orientation) == pytest.approx((1.0, 0.5))
    with pytest.raises(InputError, match="reaches beyond the middle of a way of 100 mm"):
        Corner.of_zone(before, after, 0.05 * (1 + 3e-9), 0.02)
    near = [pose(np.eye(3), [0.1, 0.9e-9, 0]), pose(Rotation.from_rotvec([0, 0, 0.9e-9]).as_matrix(), [0.1, 0, 0])]
    for X_1, by in [(X_1, by) for by in (1.0, 1.2) for X_1 in near]:
        moved_1 = X_1.copy()
        moved_1[1, 3] *= by
        moved_1[:3, :3] = Rotation.from_rotvec(by * Rotation.from_matrix(X_1[:3, :3]).as_rotvec()).as_matrix()
        if by == 1.0:
            Corner(before, Line(moved_1, X[2]), 0.5, 0.5)
        else:
            with pytest.raises(ValueError, match="does not begin where the other ends"):
                Corner(before, Line(moved_1, X[2]), 0.5, 0.5)
    with pytest.raises(ValueError, match="one of them is 1"):
        Corner(before, after, 0.5, 0.5, 0.5, 0.5)
    with pytest.raises(ValueError, match="0 is no fraction of a segment"):
        Corner(before, after, 0.5, 0.0)
    with pytest.raises(ValueError, match=r"does not begin where the other ends: 100\.000000 mm apart"):
        Corner(before, Line(X[0], X[2]), 0.5, 0.5)


@given(seeds, kinds, kinds, parts)
@settings(max_examples=20)
def test_a_smooth_corner_goes_over_with_second_derivatives_too(
    seed: int, one: str, other: str, bent: tuple[float, float]
) -> None:
    """Also where the smaller of two zones begins and ends; its rates are the slopes of what they belong to."""
    rng = np.random.default_rng(seed)
    corner = replace(some_corner(rng, (one, other), bent), smooth=True)
    check_slopes(corner, rng, 2e3)
    near, marks = 1e-6, np.r_[0.0, corner.breaks, 1.0]
    changes = [corner.twist_rate(np.clip(marks + side * near, 0, 1)) for side in (-1, 1)]
    ends = [
        (2 * fraction) ** 2 * segment.twist_rate(np.array([at]))
        for segment, fraction, at in (
            (corner.before, corner.fraction_before, 1 - corner.fraction_before),
            (corner.after, corner.fraction_after, corner.fraction_after),
        )
    ]
    sides = np.vstack([ends[0], changes[0][1:-1], ends[1]]), np.vstack([changes[1][:-1], changes[0][-1:]])
    np.testing.assert_allclose(*sides, atol=1e-4)


def test_between_lines_a_smooth_corner_is_the_quintic_on_both_ways() -> None:
    """Control points on the ways, r - 2 r/5 and r - 4 r/5 from the point; so it is in the triangle."""
    rng = np.random.default_rng(5)
    corner = replace(some_corner(rng, ("line", "line"), (1.0, 1.0)), smooth=True)
    P = corner.after.pose(np.zeros(1))[0, :3, 3]
    ends = [corner.pose(np.array([s]))[0, :3, 3] for s in (0.0, 1.0)]
    points = np.array(
        [P + x * (end - P) for end, xs in zip(ends, ((1, 0.6, 0.2), (0.2, 0.6, 1)), strict=True) for x in xs]
    )
    weights = np.array([comb(5, i) * S**i * (1 - S) ** (5 - i) for i in range(6)]).T
    np.testing.assert_allclose(corner.pose(S)[:, :3, 3], weights @ points, atol=1e-12)
