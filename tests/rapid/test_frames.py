"""Frames of the RAPID interpreter are those of scipy's rotations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.rapid.data.frames import about, compose, inverse, matrix, product, rotate

RNG = np.random.default_rng(20)
TURNS = [Rotation.from_quat(q) for q in RNG.normal(size=(40, 4))]
PLACES = [tuple(p) for p in RNG.normal(size=(40, 3))]


def quaternion(turn: Rotation) -> tuple[float, float, float, float]:
    x, y, z, w = turn.as_quat()
    return (w, x, y, z)


@pytest.mark.parametrize("i", range(0, 40, 2))
def test_turning_joining_and_reversing(i: int) -> None:
    a, b = TURNS[i], TURNS[i + 1]
    p, r = PLACES[i], PLACES[i + 1]
    np.testing.assert_allclose(matrix(quaternion(a)), a.as_matrix(), atol=1e-14)
    np.testing.assert_allclose(matrix(product(quaternion(a), quaternion(b))), (a * b).as_matrix(), atol=1e-14)
    np.testing.assert_allclose(rotate(quaternion(a), p), a.apply(p), atol=1e-14)
    place, turn = compose((p, quaternion(a)), (r, quaternion(b)))
    np.testing.assert_allclose(place, np.add(p, a.apply(r)), atol=1e-14)
    np.testing.assert_allclose(matrix(turn), (a * b).as_matrix(), atol=1e-14)
    place, turn = compose(inverse((p, quaternion(a))), (p, quaternion(a)))
    np.testing.assert_allclose(place, 0, atol=1e-14)
    np.testing.assert_allclose(matrix(turn), np.eye(3), atol=1e-14)


@pytest.mark.parametrize("axis", range(3))
def test_turns_about_an_axis(axis: int) -> None:
    wanted = Rotation.from_euler("xyz"[axis], 0.7).as_matrix()
    np.testing.assert_allclose(matrix(about(axis, 0.7)), wanted, atol=1e-15)
