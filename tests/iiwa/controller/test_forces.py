"""The force mapping and the zeroing against least squares, statics and the thesis' rotated frame."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.iiwa.controller.forces import SMALLEST, SingularArm, clamped, force_of, zero
from trajopt_cli.iiwa.task.model import Zeroing

TILTED = np.radians([-45.0, -30.0, 0.0])


def test_a_force_comes_back_from_its_torques() -> None:
    """tau = J^T F is what a force does to the joints; the thesis' printed formula does not even have the shape."""
    rng = np.random.default_rng(9)
    J, F = rng.normal(size=(20, 5, 6, 7)), rng.normal(size=(20, 5, 6)) * 30
    found = force_of(J, np.einsum("...ij,...i->...j", J, F))
    assert found.shape == (20, 5, 6)
    assert np.allclose(found, F, rtol=0, atol=1e-8)


def test_torques_no_force_can_make_are_met_by_least_squares() -> None:
    rng = np.random.default_rng(10)
    J, tau = rng.normal(size=(50, 6, 7)), rng.normal(size=(50, 7)) * 10
    found = force_of(J, tau)
    for row in range(50):
        wanted = np.linalg.lstsq(J[row].T, tau[row], rcond=None)[0]
        assert found[row] == pytest.approx(wanted, abs=1e-9)


def test_a_singular_arm_is_named_with_its_smallest_singular_value() -> None:
    rng = np.random.default_rng(11)
    U = np.linalg.qr(rng.normal(size=(6, 6)))[0]
    V = np.linalg.qr(rng.normal(size=(7, 7)))[0][:6]
    for smallest in (0.0, 1e-7, 0.9 * SMALLEST):
        J = U @ np.diag([2, 1, 1, 1, 0.5, smallest]) @ V
        with pytest.raises(SingularArm, match="smallest singular value is") as caught:
            force_of(J, np.ones(7))
        assert caught.value.smallest == pytest.approx(smallest, abs=1e-9)
    # just above, the answer is still the right one
    J = U @ np.diag([2, 1, 1, 1, 0.5, 1.2 * SMALLEST]) @ V
    F = np.array([1.0, -2, 3, 0.1, 0.2, -0.3])
    assert force_of(J, J.T @ F) == pytest.approx(F, abs=1e-3)
    stack = np.stack([rng.normal(size=(6, 7)), np.zeros((6, 7))])
    with pytest.raises(SingularArm, match="in row 1"):
        force_of(stack, np.ones((2, 7)))


def test_the_thesis_rotated_frame_leaves_one_direction() -> None:
    """alpha* = -45, beta* = -30, gamma* = 0 deg, x and y zeroed: +-(-0.354, 0.707, 0.612) passes (erratum)."""
    zeroing = Zeroing((True, True, False, False, False, False), TILTED)
    free = np.array([-0.354, 0.707, 0.612])
    rng = np.random.default_rng(12)
    F = rng.normal(size=(40, 6)) * 20
    left = zero(F, zeroing)
    exact = Rotation.from_euler("xyz", TILTED).as_matrix()[:, 2]
    assert exact == pytest.approx(free, abs=5e-4)
    assert np.allclose(left[:, :3], (F[:, :3] @ exact)[:, None] * exact, rtol=0, atol=1e-12)
    assert np.allclose(left[:, 3:], F[:, 3:], rtol=0, atol=1e-13)


def test_zeroed_moments_and_plain_axes() -> None:
    F = np.array([1.0, 2, 3, 4, 5, 6])
    assert zero(F, Zeroing((False, True, False, True, False, True))) == pytest.approx([1, 0, 3, 0, 5, 0])
    assert zero(F, Zeroing((True,) * 6, TILTED)) == pytest.approx(np.zeros(6))
    tilted = zero(F, Zeroing((False, False, False, False, False, True), TILTED))
    axis = Rotation.from_euler("xyz", TILTED).as_matrix()[:, 2]
    assert tilted[3:] @ axis == pytest.approx(0, abs=1e-12)
    assert tilted[:3] == pytest.approx(F[:3])
    assert zero(tilted, Zeroing((False, False, False, False, False, True), TILTED)) == pytest.approx(tilted)


def test_one_sample_in_plain_floats_is_the_same() -> None:
    rng = np.random.default_rng(13)
    for _ in range(50):
        F = rng.normal(size=6) * 30
        bounds = rng.uniform(1, 40, 6)
        assert clamped(F.tolist(), bounds.tolist()) == np.clip(F, -bounds, bounds).tolist()
    assert np.isnan(clamped([float("nan")], [1.0])[0])
