"""Tait-Bryan angles and turn vectors against scipy, and what it means not to jump."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import angles_near, angles_of, continuous, rotation, rotation_vector

DEG = np.pi / 180
RNG = np.random.default_rng(5)
MANY = RNG.uniform(-np.pi, np.pi, (500, 3)) * [1, 0.5, 1]


def test_the_matrix_is_scipys_extrinsic_xyz_and_comes_back() -> None:
    R = rotation(MANY)
    assert np.abs(R - Rotation.from_euler("xyz", MANY).as_matrix()).max() < 1e-15
    assert np.abs(angles_of(R) - MANY).max() < 1e-12
    assert np.abs(angles_of(R) - Rotation.from_matrix(R).as_euler("xyz")).max() < 1e-12


def test_leading_axes_are_kept() -> None:
    block = MANY[:24].reshape(2, 3, 4, 3)
    assert rotation(block)[1, 2, 3] == pytest.approx(rotation(block[1, 2, 3]), abs=0)
    assert rotation_vector(rotation(block)).shape == angles_of(rotation(block)).shape == block.shape


@pytest.mark.parametrize("off", [0.0, 1e-15, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3])
@pytest.mark.parametrize("sign", [1, -1])
def test_at_and_near_the_lock_the_orientation_survives(off: float, sign: int) -> None:
    angles = np.array([[0.7, sign * (np.pi / 2 - off), -2.1]])
    R = rotation(angles)
    found = angles_of(R)
    assert np.abs(rotation(found) - R).max() < 2e-15 + (off if off < 1e-10 else 0)
    if off < 1e-10:
        assert found[0, 0] == 0.0
        assert found[0, 2] == pytest.approx(-2.1 - sign * 0.7, abs=1e-9)


@settings(max_examples=100, deadline=None)
@given(arrays(np.float64, 3, elements=st.floats(-1, 1)), st.sampled_from([0, 1e-300, 1e-18, 1e-9, 1e-3, 1.0]))
def test_turn_vectors_small_and_large_come_back(direction: Array, size: float) -> None:
    turn = direction * size * 1.8
    away = np.abs(rotation_vector(Rotation.from_rotvec(turn).as_matrix()) - turn).max()
    assert away <= 5e-15 * np.abs(turn).max() + 1e-300


@pytest.mark.parametrize("short", [0.0, 1e-15, 1e-12, 1e-8, 1e-7, 1e-4])
def test_turns_of_nearly_half_a_revolution_keep_their_axis(short: float) -> None:
    axes = RNG.normal(size=(200, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    turns = axes * (np.pi - short)
    found = rotation_vector(Rotation.from_rotvec(turns).as_matrix())
    # at half a revolution both ends of the axis are right
    away = np.minimum(np.abs(found - turns).max(axis=1), np.abs(found + turns).max(axis=1) + short)
    assert away.max() < 3e-15


def turned_about(axis: Array, start: Array, turn: float, rows: int) -> Array:
    """Orientations of a constant turn about a fixed axis."""
    share = np.linspace(0, turn, rows)[:, None]
    return Rotation.from_rotvec(share * axis / np.linalg.norm(axis)).as_matrix() @ rotation(start)


def test_full_turns_are_counted_on() -> None:
    R = turned_about(np.array([0, 0, 1.0]), np.array([0.3, 0.2, 0.1]), 6 * np.pi, 200)
    found = continuous(angles_of(R))
    assert found[-1] == pytest.approx([0.3, 0.2, 0.1 + 6 * np.pi], abs=1e-12)
    assert np.abs(rotation(found) - R).max() < 1e-13


@pytest.mark.parametrize("rows", [181, 200, 1801])
@pytest.mark.parametrize("turn", [2 * np.pi, -2 * np.pi])
@pytest.mark.parametrize("start", [[0.0, 0.0, 0.0], [0.0, 0.0, 1.2], [0.0, 0.5, -2.0]])
def test_through_the_lock_beta_counts_on_evenly(rows: int, turn: float, start: list[float]) -> None:
    """About the turned y axis beta alone moves: through 90, 180 and 270 deg, hit exactly by some of the rows."""
    along = rotation(np.array([0, 0, start[2]]))[:, 1]
    R = turned_about(along, np.array(start), turn, rows)
    found = continuous(angles_of(R))
    wanted = np.array(start) + np.linspace(0, turn, rows)[:, None] * [0, 1, 0]
    assert np.abs(found - wanted).max() < 1e-6  # alpha is noise of 1e-16 / cos(beta)
    assert np.abs(rotation(found) - R).max() < 1e-9


@pytest.mark.parametrize("begin", [0, 90])
def test_a_sequence_that_touches_or_begins_at_the_lock_does_not_jump(begin: int) -> None:
    """alpha runs on evenly through a row where it means nothing."""
    angles = np.column_stack([np.linspace(0.5, 0.9, 181), np.linspace(0, np.pi, 181), np.linspace(-1, 1, 181)])[begin:]
    found = continuous(angles_of(rotation(angles)))
    assert np.abs(np.diff(found, axis=0)).max() < 0.03
    assert np.abs(rotation(found) - rotation(angles)).max() < 1e-9


@settings(max_examples=60, deadline=None)
@given(arrays(np.float64, (6, 3), elements=st.floats(-4, 4)))
def test_continuous_keeps_every_orientation_and_never_steps_half_a_turn(angles: Array) -> None:
    found = continuous(angles)
    assert np.abs(rotation(found) - rotation(angles)).max() < 1e-9
    assert np.abs(np.diff(found, axis=0)).max() <= np.pi + 1e-9


def test_rows_that_need_nothing_are_untouched() -> None:
    angles = np.cumsum(RNG.uniform(-0.02, 0.02, (50, 3)), axis=0)
    assert np.array_equal(continuous(angles), angles)
    assert np.array_equal(continuous(angles[:1]), angles[:1])
    locked = np.array([[0.1, np.pi / 2, 0.2], [0.0, np.pi / 2, 0.4]])
    assert np.array_equal(continuous(locked), locked)


@given(st.lists(st.tuples(*[st.floats(-4, 4)] * 6), min_size=1, max_size=8))
def test_angles_near_others_are_the_same_orientation_and_the_nearest_way(rows: list[tuple[float, ...]]) -> None:
    table = np.array(rows)
    given, near = table[:, :3], table[:, 3:]
    R = rotation(given)
    found = angles_near(R, near)
    np.testing.assert_allclose(rotation(found), R, rtol=0, atol=1e-7)
    ways = [given, np.column_stack([given[:, 0] + np.pi, np.pi - given[:, 1], given[:, 2] + np.pi])]
    wrapped = [near + (way - near) - 2 * np.pi * np.rint((way - near) / (2 * np.pi)) for way in ways]
    best = np.min([np.linalg.norm(way - near, axis=1) for way in wrapped], axis=0)
    assert (np.linalg.norm(found - near, axis=1) <= best + 1e-6).all()
