"""The generator against Ruckig without jerk, against closed forms where Ruckig has no answer, and against itself."""

from __future__ import annotations

import numpy as np
import pytest
from ruckig import InputParameter, Result, Ruckig, RuckigError, Trajectory

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.study.bang_bang import AxisMotion, bang_bang, common_time, in_region_a, in_time

CASES = 10_000
BORDER = 2_000


def ruckig_time(s_0: Array, v_0: Array, s_f: Array, v_f: Array, v_max: Array, a_max: Array) -> float:
    """Ruckig's least common time of k axes with free jerk; NaN where it gives up."""
    k = len(s_0)
    wish, out = InputParameter(k), Trajectory(k)
    wish.current_position, wish.target_position = s_0.tolist(), s_f.tolist()
    wish.current_velocity, wish.target_velocity = v_0.tolist(), v_f.tolist()
    wish.current_acceleration = wish.target_acceleration = [0.0] * k
    wish.max_velocity, wish.max_acceleration = v_max.tolist(), a_max.tolist()
    wish.max_jerk = [float("inf")] * k
    try:
        result = Ruckig(k).calculate(wish, out)
    except RuckigError:
        return float("nan")
    return float(out.duration) if result in (Result.Working, Result.Finished) else float("nan")


def random_cases(n: int, seed: int) -> tuple[Array, ...]:
    """States and limits (n,): ends at top speed, at rest, without a way, and a way of a metre or a few."""
    rng = np.random.default_rng(seed)
    v_max, a_max = rng.uniform(0.1, 3.0, n), rng.uniform(0.5, 30.0, n)
    v_0, v_f = rng.uniform(-1, 1, n) * v_max, rng.uniform(-1, 1, n) * v_max
    s_0 = rng.uniform(-1, 1, n)
    s_f = s_0 + rng.normal(0, 1, n)
    top, rest = slice(500, 1000), slice(1500, 2000)
    v_0[top] = v_max[top]
    v_f[750:1250] = v_max[750:1250]
    v_f[1250:1400] = -v_max[1250:1400]
    v_0[rest] = 0.0
    v_f[1750:2250] = 0.0
    s_f[2000:2500] = s_0[2000:2500]
    s_f[900:1000] = s_0[900:1000]  # no way at top speed at both ends: there already
    return s_0, v_0, s_f, v_f, v_max, a_max


def states(motion: AxisMotion, share: Array) -> tuple[Array, Array, Array]:
    """s, v, u (n, m) of every case at shares (m,) of its own duration."""
    parts = [
        AxisMotion(*(x[i] for x in (motion.s_0, motion.v_0, motion.phases, motion.accelerations))).at(share * T)
        for i, T in enumerate(motion.duration)
    ]
    s, v, u = (np.array(column) for column in zip(*parts, strict=True))
    return s, v, u


def test_the_duration_is_ruckigs_on_ten_thousand_random_cases() -> None:
    cases = random_cases(CASES, seed=20140)
    ours = bang_bang(*cases).duration
    ruckigs = np.array([ruckig_time(*(x[i : i + 1] for x in cases)) for i in range(CASES)])
    s_0, v_0, s_f, v_f, v_max, _ = cases
    there = (s_0 == s_f) & (v_0 == v_f)
    assert not np.isnan(ruckigs[~there]).any()
    assert np.abs(ours - ruckigs)[~there].max() < 1e-9
    # Ruckig gives no answer to some of these; the answer is 0
    assert there.sum() >= 100
    assert (v_0[there] == v_max[there]).sum() >= 100
    assert (ours[there] == 0.0).all()
    region_a = in_region_a(s_f - s_0, v_0, v_f, cases[5])
    assert 0.3 < region_a.mean() < 0.7


def test_it_ends_where_it_should_within_its_limits() -> None:
    cases = random_cases(CASES, seed=7)
    s_0, v_0, s_f, v_f, v_max, a_max = cases
    motion = bang_bang(*cases)
    s, v, u = states(motion, np.linspace(0, 1, 41))
    assert np.abs(s[:, -1] - s_f).max() < 1e-12
    assert np.abs(v[:, -1] - v_f).max() < 1e-12
    assert (np.abs(v) <= v_max[:, None] * (1 + 1e-12)).all()
    assert (np.abs(u) <= a_max[:, None]).all()
    np.testing.assert_array_equal(s[:, 0], s_0)
    np.testing.assert_array_equal(v[:, 0], v_0)


def test_on_the_border_between_the_regions_one_ramp_does_it() -> None:
    """The way of the ramp from v_0 to v_f, rounded as it happens: t_f = |v_f - v_0| / a, also against (3.10)."""
    s_0, v_0, _, v_f, v_max, a_max = random_cases(BORDER, seed=3)
    s_f = s_0 + (v_0 + v_f) / 2 * np.abs(v_f - v_0) / a_max
    motion = bang_bang(s_0, v_0, s_f, v_f, v_max, a_max)
    ramp = np.abs(v_f - v_0) / a_max
    np.testing.assert_allclose(motion.duration, ramp, rtol=0, atol=1e-9)
    s, v, _ = states(motion, np.array([1.0]))
    assert np.abs(s[:, 0] - s_f).max() < 1e-12
    assert np.abs(v[:, 0] - v_f).max() < 1e-12
    cases = np.column_stack([s_0, v_0, s_f, v_f, v_max, a_max])[BORDER // 2 :]
    ruckigs = np.array([ruckig_time(*row[:, None]) for row in cases])
    # where rounding puts the way on the far side, Ruckig takes the detour; it is never faster
    assert np.nanmin(ruckigs - ramp[BORDER // 2 :]) > -1e-9
    assert np.mean(np.abs(ruckigs - ramp[BORDER // 2 :]) < 1e-9) > 0.75


@pytest.mark.parametrize(
    ("case", "wanted"),
    [
        ((0, 0, 1, 0, 2.5, 20), 1 / 2.5 + 2.5 / 20),  # region A at top speed, (3.43)
        ((0, 0, -1, 0, 2.5, 20), 1 / 2.5 + 2.5 / 20),  # region D, (3.46)
        ((0, 0, 0.2, 0, 2.5, 20), 2 * np.sqrt(0.2 / 20)),  # never at top speed, (3.25)
        ((0, 1, 0, -1, 2.5, 20), 2 / 20),  # back where it was: the border for v_0 > v_f
        ((0, 1, 0, 1, 2.5, 20), 0.0),
        ((0, 1, -0.1, 1, 2.5, 20), 2 * (1 + np.sqrt(20 * 0.1 + 1)) / 20),  # back and once more past its start
    ],
)
def test_closed_forms(case: tuple[float, ...], wanted: float) -> None:
    assert float(bang_bang(*case).duration) == pytest.approx(wanted, rel=1e-12)


def test_axes_arrive_together_as_soon_as_ruckig_says() -> None:
    """Least common time of three axes with speeds at both ends, blocked times included, and motions that keep it."""
    s_0, v_0, s_f, v_f, v_max, a_max = random_cases(3 * 1500, seed=11)
    short = s_0, v_0, s_0 + 0.1 * (s_f - s_0), v_f, v_max, a_max  # so that speeds at the ends matter
    blocked = compared = 0
    for i in range(800, 1500):
        axes = tuple(x[3 * i : 3 * i + 3] for x in short)
        T = common_time(*axes)
        alone = bang_bang(*axes).duration.max()
        blocked += int(alone + 1e-9 < T)
        motion = in_time(axes[0], axes[1], axes[2], axes[3], axes[4], axes[5], T)
        s, v, _ = motion.at(np.linspace(0, T, 60))
        np.testing.assert_allclose(motion.duration, T, rtol=0, atol=1e-12)
        assert np.abs(s[:, -1] - axes[2]).max() < 1e-11
        assert np.abs(v[:, -1] - axes[3]).max() < 1e-11
        assert (np.abs(v) <= axes[4][:, None] * (1 + 1e-9)).all()
        wanted = ruckig_time(*axes)
        if not np.isnan(wanted):
            compared += 1
            assert wanted == pytest.approx(T, abs=1e-9)
    assert compared > 690
    assert blocked > 15


def test_a_longer_time_that_cannot_be_is_refused() -> None:
    """20 mm at 1 m/s at both ends: no slower than braking and speeding up at once, or else with a way back."""
    move = (0.0, 1.0, 0.02, 1.0, 2.5, 20.0)
    assert float(in_time(*move, common_time(*move)).duration) == pytest.approx(float(bang_bang(*move).duration))
    with pytest.raises(InputError, match=r"a way of 0\.02 from speed 1 to 1 cannot take 0\.05 s"):
        in_time(*move, 0.05)
    later = common_time([0, 0], [1, 0], [0.02, 0.0125], [1, 0], [2.5, 2.5], [20, 20])  # the second needs 0.05 s
    assert later == pytest.approx((2 + 2 * np.sqrt(-20 * 0.02 + 1)) / 20, rel=1e-12)


@pytest.mark.parametrize(
    ("case", "said"),
    [
        ((0, 2.6, 1, 0, 2.5, 20), "v_0 = 2.6 passes v_max = 2.5"),
        ((0, 0, 1, -3, 2.5, 20), "v_f = -3 passes v_max = 2.5"),
        ((0, 0, 1, 0, 2.5, 0), "a_max = 0; a limit must be positive and finite"),
        ((0, 0, 1, 0, np.inf, 20), "v_max = inf; a limit must be positive and finite"),
    ],
)
def test_bad_input_is_named(case: tuple[float, ...], said: str) -> None:
    with pytest.raises(InputError) as caught:
        bang_bang(*case)
    assert said in str(caught.value)
