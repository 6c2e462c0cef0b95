"""Angles on a circle: half turns, the turn nearest to a range, and what is said of branches that no range holds."""

from __future__ import annotations

from math import degrees, pi

import numpy as np
import pytest

from trajopt_cli.robot.turns import ON_LIMIT, broken_limits, close_at_pi, excess, half_turn


def test_half_a_turn_stays_in_the_half_open_circle() -> None:
    angles = np.array([0.0, -0.0, 1e-17, -1e-17, 1.0, -1.0, pi, np.nextafter(-pi, 0)])
    wanted = [pi, pi, pi, pi, 1 - pi, pi - 1, 0, np.nextafter(-pi, 0) + pi]
    np.testing.assert_array_equal(half_turn(angles), np.where(np.array(wanted) <= -pi, pi, wanted))
    for some in (np.array([-pi, -3.0, pi, -4.0]), np.array([1.0])):
        closed = some.copy()
        close_at_pi(closed)
        np.testing.assert_array_equal(closed, np.where(some <= -pi, pi, some))


@pytest.mark.parametrize("turn", range(-2, 3))
def test_how_far_an_angle_stays_outside_a_range(turn: int) -> None:
    """Any turn of it may be within; else the nearest one is told, and the end that it breaks."""
    for value, low, high, wanted in (
        (0.5, 0.0, 1.0, (0.0, 0.5, 1.0)),
        (0.5, 0.7, 1.0, (0.2, 0.5, 0.7)),
        (0.5, -1.0, 0.2, (0.3, 0.5, 0.2)),
        (0.5, 2 * pi, 2 * pi + 0.1, (0.4, 2 * pi + 0.5, 2 * pi + 0.1)),
        (0.5, -2 * pi - 0.1, -2 * pi, (0.5, 0.5 - 2 * pi, -2 * pi)),
        (3.0, -3.0, 2.0, (2 * pi - 6, 3 - 2 * pi, -3.0)),
    ):
        found = excess(value + 2 * pi * turn * (abs(low) < 2 * pi), low, high)
        assert found == pytest.approx(wanted, abs=1e-12)


def test_what_is_said_of_branches() -> None:
    lower, upper, names = np.array([-1.0, -2.0]), np.array([1.0, 2.0]), ("a", "b")

    def said(*branches: tuple[float, float]) -> str | None:
        return broken_limits({f"no. {i}": np.array(q) for i, q in enumerate(branches)}, names, lower, upper)

    def of(name: str, value: float, limit: float) -> str:
        return f"{name} = {degrees(value):.6g}°, limit {degrees(limit):.6g}°"

    every = "every branch needs"
    assert said((1.5, 0), (0.5, 0.5)) is None
    assert said((1 + 0.9 * ON_LIMIT, 0)) is None
    assert said((1 + 1.1 * ON_LIMIT, 0)) == f"{every} a beyond its range: nearest {of('a', 1, 1)} (no. 0)"
    assert said((1.5, 0), (-1.2, 0)) == f"{every} a beyond its range: nearest {of('a', -1.2, -1)} (no. 1)"
    assert said((1.2, 0), (1.2, 2.9)) == f"{every} a beyond its range: nearest {of('a', 1.2, 1)} (no. 0)"
    # both are out in both: the one that is least beyond
    assert said((1.5, 2.3), (1.6, 2.1)) == f"{every} b beyond its range: nearest {of('b', 2.1, 2)} (no. 1)"
    # no joint in common: each branch with its worst, the nearest first
    assert said((1.6, 0), (0, -2.5)) == (
        f"every branch breaks a joint limit: no. 1 needs {of('b', -2.5, -2)}; no. 0 needs {of('a', 1.6, 1)}"
    )
    assert said((1.6, 2.1), (0, -2.5), (1.1, 0)) == (
        f"every branch breaks a joint limit: no. 2 needs {of('a', 1.1, 1)}; no. 1 needs {of('b', -2.5, -2)};"
        f" no. 0 needs {of('a', 1.6, 1)}"
    )
