"""Bang-bang motions against Ruckig without jerk, and against closed forms where Ruckig has no answer."""

from __future__ import annotations

import numpy as np
import pytest
from timing.test_double_integrator import ruckig_time

from trajopt_cli.geometry import Array
from trajopt_cli.timing.double_integrator import fastest_profile
from trajopt_cli.timing.point_to_point import bang_bang


def one(D: float, v_0: float, v_1: float, V: float, A: float, T: float | None = None):  # type: ignore[no-untyped-def]
    return bang_bang(*(np.array([float(x)]) for x in (D, v_0, v_1, V, A)), T)


@pytest.mark.parametrize("k", [1, 3])
def test_axes_arrive_together_as_soon_as_ruckig_says_within_their_limits(k: int) -> None:
    """Random states and short ways, so that speeds at the ends matter and some times are blocked."""
    rng = np.random.default_rng(k)
    blocked = 0
    for _ in range(400):
        V, A = rng.uniform(0.1, 3.0, k), rng.uniform(0.5, 30.0, k)
        v_0, v_1 = rng.uniform(-1, 1, (2, k)) * V
        D = rng.normal(0, 0.1, k)
        motion = bang_bang(D, v_0, v_1, V, A)
        assert motion.duration == pytest.approx(ruckig_time(D, v_0, v_1, V, A), abs=1e-9)
        alone = max(fastest_profile(*row)[0][-1] for row in zip(D, v_0, v_1, V, A, strict=True))
        blocked += alone + 1e-9 < motion.duration
        q, qd, qdd = motion.at(np.linspace(0, motion.duration, 60))
        np.testing.assert_allclose(q[[0, -1]], [0 * D, D], atol=1e-10)
        np.testing.assert_allclose(qd[[0, -1]], [v_0, v_1], atol=1e-10)
        assert (np.abs(qd) <= V * (1 + 1e-9)).all()
        assert (np.abs(qdd) <= A * (1 + 1e-12)).all()
        np.testing.assert_allclose(np.diff(q, axis=0).sum(axis=0), D, atol=1e-10)
    assert blocked > 5 or k == 1


@pytest.mark.parametrize(
    ("case", "wanted"),
    [
        ((1, 0, 0, 2.5, 20), 1 / 2.5 + 2.5 / 20),  # at top speed
        ((-1, 0, 0, 2.5, 20), 1 / 2.5 + 2.5 / 20),
        ((0.2, 0, 0, 2.5, 20), 2 * np.sqrt(0.2 / 20)),  # never at top speed
        ((0, 1, -1, 2.5, 20), 2 / 20),  # one ramp, back where it was
        ((0, 1, 1, 2.5, 20), 0.0),
        ((-0.1, 1, 1, 2.5, 20), 2 * (1 + np.sqrt(20 * 0.1 + 1)) / 20),  # back and once more past its start
    ],
)
def test_closed_forms(case: tuple[float, ...], wanted: float) -> None:
    motion = one(*case)
    assert motion.duration == pytest.approx(wanted, rel=1e-12)
    assert len(motion.switches) <= 4


def test_one_ramp_is_one_ramp_however_its_way_is_rounded() -> None:
    rng = np.random.default_rng(3)
    for _ in range(500):
        V, A = rng.uniform(0.1, 3.0), rng.uniform(0.5, 30.0)
        v_0, v_1 = rng.uniform(-1, 1, 2) * V
        D = (v_0 + v_1) / 2 * abs(v_1 - v_0) / A
        assert fastest_profile(D, v_0, v_1, V, A)[0][-1] == pytest.approx(abs(v_1 - v_0) / A, abs=1e-9)


def test_a_longer_time_is_kept_exactly_or_refused() -> None:
    """20 mm at 1 m/s at both ends: no slower than braking and speeding up at once, or else with a way back."""
    case = (0.02, 1.0, 1.0, 2.5, 20.0)
    assert one(0.3, 0, 0, 2.5, 20, 0.7).duration == 0.7
    with pytest.raises(ValueError, match="does not fit into"):
        one(*case, 0.05)
    D, v, V, A = (np.array(x) for x in ([0.02, 0.0125], [1.0, 0.0], [2.5, 2.5], [20.0, 20.0]))
    # the second axis needs 0.05 s
    later: Array = np.array(bang_bang(D, np.array([1.0, 1.0]), v, V, A).duration)
    assert float(later) == pytest.approx((2 + 2 * np.sqrt(-20 * 0.02 + 1)) / 20, rel=1e-12)
