"""Frames of the RAPID interpreter are those of scipy's rotations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.rapid.data.frames import (
    about,
    between,
    compose,
    inverse,
    length,
    matrix,
    norm,
    normalised,
    product,
    rotate,
)

RNG = np.random.default_rng(20)
TURNS = [Rotation.from_quat(q) for q in RNG.normal(size=(40, 4))]
PLACES = [tuple(p) for p in RNG.normal(size=(40, 3))]


def rotation(q: tuple[float, ...]) -> np.ndarray:
    return matrix(((0.0, 0.0, 0.0), q))[:3, :3]  # type: ignore[arg-type]


def quaternion(turn: Rotation) -> tuple[float, float, float, float]:
    x, y, z, w = turn.as_quat()
    return (w, x, y, z)


@pytest.mark.parametrize("i", range(0, 40, 2))
def test_turning_joining_and_reversing(i: int) -> None:
    a, b = TURNS[i], TURNS[i + 1]
    p, r = PLACES[i], PLACES[i + 1]
    np.testing.assert_allclose(rotation(quaternion(a)), a.as_matrix(), atol=1e-14)
    np.testing.assert_allclose(rotation(product(quaternion(a), quaternion(b))), (a * b).as_matrix(), atol=1e-14)
    np.testing.assert_allclose(rotate(quaternion(a), p), a.apply(p), atol=1e-14)
    place, turn = compose((p, quaternion(a)), (r, quaternion(b)))
    np.testing.assert_allclose(place, np.add(p, a.apply(r)), atol=1e-14)
    np.testing.assert_allclose(rotation(turn), (a * b).as_matrix(), atol=1e-14)
    place, turn = compose(inverse((p, quaternion(a))), (p, quaternion(a)))
    np.testing.assert_allclose(place, 0, atol=1e-14)
    np.testing.assert_allclose(rotation(turn), np.eye(3), atol=1e-14)


@pytest.mark.parametrize("axis", range(3))
def test_turns_about_an_axis(axis: int) -> None:
    wanted = Rotation.from_euler("xyz"[axis], 0.7).as_matrix()
    np.testing.assert_allclose(rotation(about(axis, 0.7)), wanted, atol=1e-15)


@pytest.mark.parametrize("i", range(0, 40, 2))
def test_the_line_between_two_frames_turns_the_shorter_way_and_keeps_the_first_sign(i: int) -> None:
    a, b = (PLACES[i], quaternion(TURNS[i])), (PLACES[i + 1], quaternion(TURNS[i + 1]))
    for first in (a, (a[0], tuple(-x for x in a[1]))):
        assert between(first, first, 0.3) == first
        for second in (b, (b[0], tuple(-x for x in b[1]))):
            for share in (0.0, 0.25, 0.6, 1.0):
                place, turn = between(first, second, share)
                np.testing.assert_allclose(place, (1 - share) * np.array(a[0]) + share * np.array(b[0]), atol=1e-14)
                wanted = Slerp([0, 1], Rotation.concatenate([TURNS[i], TURNS[i + 1]]))(share)
                np.testing.assert_allclose(rotation(turn), wanted.as_matrix(), atol=1e-14)
                assert np.dot(turn, first[1]) > 0


def test_a_small_turn_is_shared_too() -> None:
    a, b = (PLACES[0], quaternion(TURNS[0])), (PLACES[0], quaternion(TURNS[0] * Rotation.from_rotvec([0, 3e-15, 0])))
    assert between(a, b, 0.5)[1] == pytest.approx(a[1], abs=1e-14)
    b = (PLACES[0], quaternion(TURNS[0] * Rotation.from_rotvec([0, 0, 1e-7])))
    (_, y, z) = Rotation.from_quat(np.roll(between(a, b, 0.25)[1], -1)).apply([1, 0, 0]) - TURNS[0].apply([1, 0, 0])
    wanted = TURNS[0].apply([0, 0.25e-7, 0])
    np.testing.assert_allclose([y, z], wanted[1:], rtol=0, atol=1e-15)


def test_lengths() -> None:
    assert norm((2e200, -4e200, 5e200, 6e200)) == pytest.approx(9e200, rel=1e-15)
    assert normalised((2.0, -4.0, 5.0, 6.0)) == pytest.approx((2 / 9, -4 / 9, 5 / 9, 6 / 9), rel=1e-15)
    assert length((2.0, -3.0, 6.0)) == 7.0
