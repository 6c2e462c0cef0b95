"""Joint moves and joint corners against closed forms, central differences and their own expressions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from path_checks import STEPS, seeds

from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path.joint_move import JointMove
from trajopt_cli.path.segment import JointSegment

S = np.linspace(0, 1, 21)


def check_slopes(segment: JointSegment, k: int) -> None:
    s = np.linspace(0.01, 0.99, 21)
    for h in STEPS:
        slope = (segment.axes(s + h / 2) - segment.axes(s - h / 2)) / h
        bend = (segment.rate(s + h / 2) - segment.rate(s - h / 2)) / h
        assert slope.shape == (21, k)
        # the third derivative is constant
        third = (segment.rate_change(np.ones(1)) - segment.rate_change(np.zeros(1)))[0]
        np.testing.assert_allclose(slope - third * h**2 / 24, segment.rate(s), rtol=0, atol=1e-14 / h)
        np.testing.assert_allclose(bend, segment.rate_change(s), rtol=0, atol=1e-14 / h)


@pytest.mark.parametrize("k", [6, 7])
def test_a_joint_move_is_straight(k: int) -> None:
    q_0, q_1 = np.random.default_rng(k).normal(size=(2, k))
    move = JointMove(q_0, q_1)
    np.testing.assert_allclose(move.axes(S), np.linspace(q_0, q_1, 21), rtol=0, atol=1e-15)
    assert move.breaks.shape == (0,)
    check_slopes(move, k)


def two_moves(rng: np.random.Generator, k: int = 6) -> tuple[JointMove, JointMove]:
    q = rng.normal(size=(3, k))
    return JointMove(q[0], q[1]), JointMove(q[1], q[2])


def cornered(before: JointMove, after: JointMove, a: float, b: float) -> JointCorner:
    """Over the last fraction a of a move and the first b of the next."""
    s, t = np.array([1 - a]), np.array([b])
    return JointCorner(before.axes(s)[0], 2 * a * before.rate(s)[0], after.axes(t)[0], 2 * b * after.rate(t)[0])


@given(seeds, st.floats(0.01, 1), st.floats(0.01, 1))
@settings(max_examples=50)
def test_a_corner_of_two_joint_moves_is_a_quadratic_bezier(seed: int, a: float, b: float) -> None:
    before, after = two_moves(np.random.default_rng(seed))
    corner = cornered(before, after, a, b)
    entry, point, end = before.axes(np.array([1 - a]))[0], after.q_0, after.axes(np.array([b]))[0]
    u = S[:, None]
    bezier = (1 - u) ** 2 * entry + 2 * u * (1 - u) * point + u**2 * end
    np.testing.assert_allclose(corner.axes(S), bezier, rtol=0, atol=1e-14)
    rates = [2 * a * (before.q_1 - before.q_0), 2 * b * (after.q_1 - after.q_0)]
    np.testing.assert_allclose(corner.rate(S[[0, -1]]), rates, rtol=0, atol=1e-14)
    back = cornered(JointMove(after.q_1, point), JointMove(point, before.q_0), b, a)
    np.testing.assert_allclose(back.axes(S), corner.axes(1 - S), rtol=0, atol=1e-13)
    np.testing.assert_allclose(back.rate_change(S), corner.rate_change(1 - S), rtol=0, atol=1e-12)


@pytest.mark.parametrize("k", [6, 7])
def test_a_corner_meets_any_two_ends_with_their_rates(k: int) -> None:
    q_0, rate_0, q_1, rate_1 = np.random.default_rng(k).normal(size=(4, k))
    corner = JointCorner(q_0, rate_0, q_1, rate_1)
    np.testing.assert_allclose(corner.axes(np.array([0.0, 1.0])), [q_0, q_1], rtol=0, atol=1e-15)
    np.testing.assert_allclose(corner.rate(np.array([0.0, 1.0])), [rate_0, rate_1], rtol=0, atol=1e-14)
    assert corner.breaks.shape == (0,)
    check_slopes(corner, k)
