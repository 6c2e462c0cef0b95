"""The batch of TOPP-RA against toppra, closed forms and its own limits.

toppra lowers x = (ds/dt)^2 by 1e-8 at every point of its forward pass (by 1e-4 of it, where that is less), accepts a
first x that passes its bounds by 1e-5, and does not hold the last one to its bound; its solver seidel gives up where x
may be far beyond what the rows leave, or on columns of zeros. The paths here have x of some hundreds and finite tops.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from timing.toppra_law import fastest_law

from trajopt_cli.geometry import Array
from trajopt_cli.timing.topp import TimeLaws, fastest_laws

Rows = tuple[Array, Array]
Paths = tuple[Array, Array, Rows, Rows]


def smooth(seed: int, B: int, n: int, m: int) -> Paths:
    """Axes on sines, uneven points: slopes and bends agree on both sides of a point. ds/dt about 15."""
    rng = np.random.default_rng(seed)
    s = np.cumsum(rng.uniform(0.5, 1.5, (B, n)), axis=1)
    s = (s - s[:, :1]) / (s[:, -1:] - s[:, :1])
    turns, phase, size = (rng.uniform(*span, (B, 1, m)) for span in ((1, 8), (0, 6), (0.2, 1)))
    angle = turns * s[..., None] + phase
    slope, bend = size * turns * np.cos(angle), -size * turns**2 * np.sin(angle)
    top = (rng.uniform(15, 150, (B, 1, m)) / np.abs(slope)).min(axis=-1)
    limit = rng.uniform(1800, 18000, (B, 1, m))
    slope, bend = slope / limit, bend / limit
    return s, top, (slope[:, :-1], bend[:, :-1]), (slope[:, 1:], bend[:, 1:])


def jumping(seed: int, B: int, n: int, m: int) -> Paths:
    """Slopes run on, bends jump at every point and often are none. ds/dt about 10."""
    rng = np.random.default_rng(seed)
    s = np.tile(np.linspace(0, 1, n), (B, 1))
    slope = rng.normal(0, 1e-3, (B, n, m))
    bends = [rng.normal(0, 2e-3, (B, n - 1, m)) * (rng.random((B, n - 1, m)) < 0.7) for _ in range(2)]
    return s, rng.uniform(10, 60, (B, n)), (slope[:, :-1], bends[0]), (slope[:, 1:], bends[1])


def one(paths: Paths, k: int) -> Paths:
    s, top, begins, ends = paths
    return s[k], top[k], (begins[0][k], begins[1][k]), (ends[0][k], ends[1][k])


def greatest(paths: Paths, laws: TimeLaws) -> float:
    """The greatest share of a limit that is used at either end of an interval; and that of top."""
    s, top, begins, ends = paths
    timed = np.isfinite(laws.rates[:, 0])
    x = laws.rates[timed] ** 2
    u = (np.diff(x) / (2 * np.diff(s[timed])))[..., None]
    here = np.abs(begins[0][timed] * u + begins[1][timed] * x[:, :-1, None])
    there = np.abs(ends[0][timed] * u + ends[1][timed] * x[:, 1:, None])
    return float(max(here.max(), there.max(), (laws.rates[timed] / top[timed]).max()))


def same(one: TimeLaws, other: TimeLaws) -> bool:
    return np.array_equal(one.rates, other.rates, equal_nan=True) and np.array_equal(one.durations, other.durations)


@pytest.mark.parametrize("make", [smooth, jumping])
@pytest.mark.parametrize(("share_0", "share_1"), [(0.0, 0.0), (1.0, 0.0), (0.0, 1.5), (1.0, 1.5), (2.5, 0.5)])
def test_rates_are_those_of_toppra(make: Callable[..., Paths], share_0: float, share_1: float) -> None:
    paths = make(11, 15, 60, 6)
    s, top = paths[:2]
    # rates at the ends by those one interval inside of a run from rest to rest: some paths can have them, some not
    inner = fastest_laws(*paths, 0.0, 0.0).rates
    rate_0, rate_1 = share_0 * inner[:, 1], np.minimum(share_1 * inner[:, -2], top[:, -1])
    laws = fastest_laws(*paths, rate_0, rate_1)
    assert greatest(paths, laws) < 1 + 1e-9
    timed = 0
    for k in range(len(s)):
        law, peer = laws.law(k), fastest_law(*one(paths, k), rate_0[k], rate_1[k])
        assert (law is None) == (peer is None), k
        if law is not None and peer is not None:
            timed += 1
            np.testing.assert_allclose(law.rates, peer.rates, rtol=1e-6)
            assert law.duration <= peer.duration * (1 + 1e-9)
            np.testing.assert_allclose(law.rates[[0, -1]], [rate_0[k], rate_1[k]], rtol=1e-9)
    assert timed >= 4
    assert timed == len(s) or share_0 + share_1 > 0


def test_a_straight_path_is_the_trapezoid() -> None:
    """Ramps at 2 that end on points of the grid, from 0, 0.3, 0.4 to a rate of 0.5; the rest at 0.5."""
    s = np.linspace(0, 1, 401)
    slope, none = np.full((3, 400, 1), 1 / 2.0), np.zeros((3, 400, 1))
    rate_0, rate_1 = np.array([0.0, 0.3, 0.5]), np.array([0.0, 0.4, 0.5])
    laws = fastest_laws(s, np.full((3, 401), 0.5), (slope, none), (slope, none), rate_0, rate_1)
    ramps = (0.25 - rate_0**2) / 4 + (0.25 - rate_1**2) / 4
    wanted = (1 - rate_0 - rate_1) / 2 + (1 - ramps) / 0.5
    np.testing.assert_allclose(laws.durations, wanted, rtol=1e-12)


def test_a_bend_alone_holds_the_rate_and_a_jump_is_seen_from_both_sides() -> None:
    """|4 x| <= 1 on the first half, |x| <= 1 on the second: ds/dt 0.5 up to the middle, then a ramp of 1 to 1."""
    s = np.linspace(0, 1, 11)
    bend = np.where(np.arange(10) < 5, 4.0, 1.0)[None, :, None]
    column = np.array([0.0, 1.0])
    rows = column * np.ones_like(bend), (1 - column) * bend
    laws = fastest_laws(s, np.full((1, 11), np.inf), rows, rows, 0.5, 1.0)
    wanted = np.sqrt(np.where(s < 0.55, 0.25, np.minimum(1.0, 0.25 + 2 * (s - 0.5))))
    np.testing.assert_allclose(laws.rates[0], wanted, rtol=1e-9)


@pytest.mark.parametrize("side", [0, 1])
def test_a_bend_on_one_side_of_an_interval_holds_the_rate_at_that_place_alone(side: int) -> None:
    """|4 x| <= 1 where one interval begins, or where it ends, and ramps of 1 beside; at an end no more can be asked."""
    s = np.linspace(0, 1, 11)
    for k in (5, 0 if side == 0 else 9):
        bend = np.where(np.arange(10) == k, 4.0, 0.0)[None, :, None] * np.array([1.0, 0.0])
        slope = np.array([0.0, 1.0]) * np.ones_like(bend)
        rows = [(slope, 0 * bend), (slope, 0 * bend)]
        rows[side] = slope, bend
        free = np.full((1, 11), np.inf)
        rates = fastest_laws(s, free, *rows, np.inf, np.inf).rates[0]
        np.testing.assert_allclose(rates, np.sqrt(0.25 + 2 * np.abs(s - s[k + side])), rtol=1e-8)
        if k != 5:
            asked = [(rate, np.inf)[:: 1 - 2 * side] for rate in (0.5, 0.5 * (1 + 1e-7))]
            found = [fastest_laws(s, free, *rows, *ends) for ends in asked]
            assert [np.isfinite(one.durations[0]) for one in found] == [True, False]


def test_a_slope_that_is_rounding_is_none() -> None:
    """A path that turns: its slope is 1e-18 at the turn, where the bend alone holds the rate to 1."""
    s = np.linspace(-1, 1, 21)
    for turn in (0.0, 1e-18, -1e-15):
        slope = (np.where(np.abs(s) < 1e-9, turn, s) / 1.0)[None, :, None]
        bend = np.ones_like(slope)
        laws = fastest_laws(
            s, np.full((1, 21), np.inf), (slope[:, :-1], bend[:, :-1]), (slope[:, 1:], bend[:, 1:]), 0.0, 0.0
        )
        exact = fastest_laws(
            s, np.full((1, 21), np.inf), (s[None, :-1, None], bend[:, 1:]), (s[None, 1:, None], bend[:, 1:]), 0.0, 0.0
        )
        assert laws.rates[0, 10] == pytest.approx(1.0, abs=1e-8)
        np.testing.assert_allclose(laws.rates, exact.rates, rtol=1e-7, atol=1e-12)


@pytest.mark.parametrize("seed", [79, 125, 168])
def test_slopes_of_several_columns_that_are_rounding_leave_the_rate_that_their_bends_leave(seed: int) -> None:
    """All axes turn at once, as those of a tool that stands, and the largest bend holds the rate there."""
    rng, s = np.random.default_rng(seed), np.linspace(-1, 1, 21)
    size = np.array([1.0, 0.86, 0.73, 0.48, 0.17]) * rng.uniform(0.5, 1.5)
    slope = s[None, :, None] * size
    slope[0, 10] = rng.uniform(-1, 1, 5) * 1e-18
    bend = np.broadcast_to(size, slope.shape)
    begins, ends = (slope[:, :-1], bend[:, :-1]), (slope[:, 1:], bend[:, 1:])
    laws = fastest_laws(s, np.full((1, 21), np.inf), begins, ends, 0.0, 0.0)
    assert laws.rates[0, 10] == pytest.approx(1 / np.sqrt(size[0]), rel=1e-7)


@pytest.mark.parametrize("make", [smooth, jumping])
def test_one_path_alone_has_the_same_answer(make: Callable[..., Paths]) -> None:
    paths = make(5, 40, 30, 4)
    rate = np.where(np.arange(40) % 3 == 0, 2.0, 0.0)
    laws = fastest_laws(*paths, rate, rate[::-1])
    for k in range(40):
        s, top, begins, ends = (tuple(y[k : k + 1] for y in x) if isinstance(x, tuple) else x[k : k + 1] for x in paths)
        alone = fastest_laws(s, top, begins, ends, rate[k], rate[::-1][k])
        assert np.array_equal(alone.rates[0], laws.rates[k], equal_nan=True)
        assert alone.durations[0] == laws.durations[k]


def test_columns_of_zeros_and_tops_beyond_the_rows_change_nothing() -> None:
    s, top, begins, ends = jumping(7, 20, 40, 5)
    far, free = (np.full_like(top, x) for x in (300.0, np.inf))
    laws = fastest_laws(s, far, begins, ends, 0.0, 0.0)
    wider = tuple(tuple(np.concatenate([x, np.zeros_like(x)], axis=-1) for x in rows) for rows in (begins, ends))
    assert laws.rates.max() < 200
    np.testing.assert_allclose(fastest_laws(s, free, begins, ends, 0.0, 0.0).rates, laws.rates, rtol=1e-12)
    assert same(fastest_laws(s, far, *wider, 0.0, 0.0), laws)


def test_what_cannot_be_is_told_path_by_path() -> None:
    """Limits of 1: 0.1 of path take 0.45 of rate away. A top below an end's rate, a rate that cannot be lost or won."""
    s = np.linspace(0, 0.1, 6)
    ones, none = np.ones((5, 5, 1)), np.zeros((5, 5, 1))
    top = np.full((5, 6), 2.0)
    top[1, 5] = 0.3
    rate_0, rate_1 = np.array([0.0, 0.3, 0.46, 0.0, 0.44]), np.array([0.44, 0.31, 0.0, 0.46, 0.0])
    laws = fastest_laws(s, top, (ones, none), (ones, none), rate_0, rate_1)
    np.testing.assert_array_equal(np.isfinite(laws.durations), [True, False, False, False, True])
    np.testing.assert_array_equal(np.isnan(laws.rates[:, 0]), [False, True, True, True, False])
    assert laws.law(1) is None
    first = laws.law(0)
    assert first is not None
    assert first.duration == laws.durations[0] == pytest.approx(first.times[-1])


def test_a_path_that_must_stand_still_takes_for_ever() -> None:
    s, rows = np.linspace(0, 1, 5), (np.ones((2, 4, 1)), np.zeros((2, 4, 1)))
    top = np.array([[1.0, 1.0, 0.0, 1.0, 1.0], [1.0, 0.0, 0.0, 1.0, 1.0]])
    laws = fastest_laws(s, top, rows, rows, 0.0, 0.0)
    # a stop at 0.5 between two quarters of 1/4 + 1/4 each, up and down at 1
    assert laws.durations[0] == pytest.approx(4 * np.sqrt(0.5))
    assert laws.durations[1] == np.inf
    assert laws.law(1) is None


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"s": np.array([0.0, 0.5, 0.5])}, "s that increases"),
        ({"top": np.array([[1.0, np.nan, 1.0]])}, "zero or more"),
        ({"rate_1": -0.1}, "zero or more"),
        ({"ends": (np.full((1, 2, 1), np.inf), np.zeros((1, 2, 1)))}, "end slopes must be finite"),
        ({"ends": (np.zeros((1, 2, 2)), np.zeros((1, 2, 2)))}, r"end slopes \(1, 2, 2\), wanted \(1, 2, 1\)"),
    ],
)
def test_what_is_no_path_is_refused(change: dict[str, object], told: str) -> None:
    rows = np.ones((1, 2, 1)), np.zeros((1, 2, 1))
    given: dict[str, object] = {"s": np.linspace(0, 1, 3), "top": np.ones((1, 3)), "begins": rows, "ends": rows}
    with pytest.raises(ValueError, match=told):
        fastest_laws(**{**given, "rate_0": 0.0, "rate_1": 0.0, **change})  # type: ignore[arg-type]


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.integers(0, 2**32 - 1), st.integers(2, 12), st.integers(1, 5), st.floats(-6, 3), st.floats(0, 1.2))
def test_limits_hold_and_nothing_is_left(seed: int, n: int, m: int, size: float, share: float) -> None:
    """Any scale of limits and ends: no limit is passed, and no single rate between can be raised alone."""
    s, top, begins, ends = jumping(seed, 8, n, m)
    begins, ends = (tuple(x * 10**size for x in rows) for rows in (begins, ends))  # type: ignore[assignment]
    rest = fastest_laws(s, top, begins, ends, 0.0, 0.0)
    laws = fastest_laws(s, top, begins, ends, share * rest.rates[:, min(1, n - 2)], 0.0)
    for found in (rest, laws):
        timed = np.isfinite(found.rates[:, 0])
        if timed.any():
            assert greatest((s, top, begins, ends), found) < 1 + 1e-9
        for i in range(1, n - 1):
            raised = found.rates.copy()
            raised[:, i] += 1e-4 * found.rates.max(axis=1)
            for k in np.flatnonzero(timed):
                alone = TimeLaws(s[k : k + 1], raised[k : k + 1], found.durations[k : k + 1])
                path = s[k : k + 1], top[k : k + 1], *(tuple(x[k : k + 1] for x in y) for y in (begins, ends))
                assert greatest(path, alone) > 1 + 1e-12  # type: ignore[arg-type]


@pytest.mark.parametrize("make", [smooth, jumping])
def test_free_ends_are_the_fastest_that_lead_on(make: Callable[..., Paths]) -> None:
    """An infinite rate at an end is the greatest there: the same path asked for it gives the same, a hair more none."""
    paths = make(8, 20, 40, 5)
    free = fastest_laws(*paths, np.inf, np.inf)
    assert np.isfinite(free.durations).all()
    assert greatest(paths, free) < 1 + 1e-9
    first, last = free.rates[:, 0], free.rates[:, -1]
    given = fastest_laws(*paths, first, last)
    np.testing.assert_allclose(given.rates, free.rates, rtol=1e-6)
    assert not np.isfinite(fastest_laws(*paths, first * (1 + 1e-6), np.inf).durations).any()
    assert (free.durations <= fastest_laws(*paths, 0.0, np.inf).durations).all()


@pytest.mark.parametrize("make", [smooth, jumping])
@pytest.mark.parametrize("n", [60, 300])
def test_rests_are_those_of_toppra(make: Callable[..., Paths], n: int) -> None:
    """Gravity takes up to 0.9 of a limit on one side and leaves as much more on the other: rates as toppra's, at both
    ways of going along (side by side from 64 intervals on); rests of none change no bit."""
    s, top, begins, ends = make(5, 6, n, 5)
    rng = np.random.default_rng(2)
    size, phase = rng.uniform(0, 0.9, (6, 1, 5)), rng.uniform(0, 6, (6, 1, 5))
    g = size * np.sin(3 * s[..., None] + phase)
    none = np.zeros_like(g)
    assert same(
        fastest_laws(s, top, (*begins, none[:, 1:]), (*ends, none[:, 1:]), 0.0, 0.0),
        fastest_laws(s, top, begins, ends, 0.0, 0.0),
    )
    rows = (*begins, g[:, :-1]), (*ends, g[:, 1:])
    laws = fastest_laws(s, top, *rows, 0.0, 0.0)
    free = fastest_laws(s, top, begins, ends, 0.0, 0.0)
    assert not np.allclose(laws.durations, free.durations, rtol=1e-3)
    x = laws.rates**2
    u = (np.diff(x) / (2 * np.diff(s)))[..., None]
    for (slope, bend, rest), there in zip(rows, (x[:, :-1, None], x[:, 1:, None]), strict=True):
        assert np.abs(slope * u + bend * there + rest).max() < 1 + 1e-9
    peers = [fastest_law(s[k], top[k], *(tuple(x[k] for x in one) for one in rows), 0.0, 0.0) for k in range(6)]
    assert sum(peer is not None for peer in peers) >= 4  # its solver gives up on smooth paths
    for k, peer in enumerate(peers):
        if peer is not None:
            np.testing.assert_allclose(laws.rates[k], peer.rates, rtol=2e-6, atol=1e-9)


def test_a_rest_of_a_whole_limit_stands_still() -> None:
    s, ones = np.linspace(0, 1, 9), np.ones((1, 8, 1))
    for g in (1.0, -1.2):
        rows = ones, 0 * ones, g * ones
        assert fastest_laws(s, np.ones((1, 9)), rows, rows, 0.0, 0.0).durations[0] == np.inf
    rows = ones, 0 * ones, 0.5 * ones
    with pytest.raises(ValueError, match="with rests"):
        fastest_laws(s, np.ones((1, 9)), rows, rows, 0.5, 0.0)
