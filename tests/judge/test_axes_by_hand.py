"""What the judge makes of axes alone: every least value, every doubt and every verdict, against the formulas written
out for one pair of rows after the other, in rows without a grid whose digits differ from row to row."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from legal_motion import plant_with_rail
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq

from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import joints
from trajopt_cli.judge import samples as rows_module
from trajopt_cli.judge.joints import axis_accelerations, check_joints
from trajopt_cli.judge.samples import Rows, judged_rows, unseen
from trajopt_cli.judge.tolerances import JOINT, REST_JOINT
from trajopt_cli.limits import CoupledRange
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
A = PLANT.limits.acceleration
LAGS = (1, 2, 4, 8, 16, 32)
N = 70  # rows, enough for every lag of second differences
Series = Iterable[tuple[Array, Array]]


def rows_of(seed: int, speeds: bool = True, marked: bool = False, n: int = N, plant: Plant = PLANT) -> Rows:
    """Axes that sway at random, printed in steps that differ from row to row."""
    rng = np.random.default_rng(seed)
    gaps = rng.uniform(0.004, 0.012, n - 1)
    if marked:  # a grid, and here and there a row in it
        gaps = np.full(n - 1, 0.008)
        gaps[4::5], gaps[5::5] = 0.003, 0.005
    t = 0.5 + np.r_[0.0, np.cumsum(gaps)]
    phase, rate = rng.uniform(0, 6, 7), rng.uniform(4, 9, 7)
    size = 0.04 * rng.uniform(0.5, 1, 7)
    q = plant.start + size * np.sin(rate * t[:, None] + phase) + 1e-4 * rng.normal(size=(n, 7))
    qd = size * rate * np.cos(rate * t[:, None] + phase) + 1e-2 * rng.normal(size=(n, 7))
    steps = Resolution(
        rng.uniform(1e-6, 2e-5, n), rng.uniform(1e-6, 5e-5, (n, 7)), rng.uniform(1e-6, 2e-4, (n, 7)) * speeds
    )
    rows = judged_rows(plant, Trajectory(plant.limits.names, t, q, qd if speeds else None), steps)
    assert rows.marked == marked
    return rows


def same(found: Series, wanted: Series) -> None:
    """The same series, one after the other: times and values."""
    found, wanted = list(found), list(wanted)
    assert len(found) == len(wanted)
    for (t, x), (t_wanted, x_wanted) in zip(found, wanted, strict=True):
        np.testing.assert_allclose(t, t_wanted, rtol=1e-15)
        np.testing.assert_allclose(x, x_wanted, rtol=1e-9, atol=1e-11)


def of_axis(j: int, series: Series) -> list[tuple[Array, Array]]:
    """One axis of series that are of all."""
    return [(t, x[:, j]) for t, x in series]


def pairs(n: int, reach: int = 1) -> list[tuple[int, range]]:
    """Every lag m with the rows i for which i + reach m is one."""
    return [(m, range(n - reach * m)) for m in LAGS if reach * m < n]


def printed(rows: Rows, j: int) -> tuple[Array, Array, Array, Array]:
    """Times, positions, and how far each may be off."""
    return rows.t, rows.q[:, j], rows.doubt_q[:, j] / 2, rows.step_t / 2


def second(t: Array, x: Array, off: Array, off_t: Array, i: int, b: int, c: int) -> tuple[float, float]:
    """Twice the second divided difference of three rows, and how far rounding may put it off."""
    out, doubt = [], 0.0
    for k, m in ((i, b), (b, c)):
        rate, open_t = (x[m] - x[k]) / (t[m] - t[k]), off_t[k] + off_t[m]
        doubt += (off[k] + off[m] + abs(rate) * open_t) / (t[m] - t[k] - open_t)
        out.append(rate)
    value, open_t = 2 * (out[1] - out[0]) / (t[c] - t[i]), off_t[i] + off_t[c]
    return value, (2 * doubt + abs(value) * open_t) / (t[c] - t[i] - open_t)


def least_peak(v_0: float, v_1: float, way: float, h: float, a: float) -> float:
    """The least greatest speed of a motion over a way in a time h that begins with v_0 and ends with v_1: it speeds up
    at a, holds, and slows down at a."""
    low = max(v_0, v_1)
    top = (v_0 + v_1 + a * h) / 2

    def beyond(p: float) -> float:
        return p * h - ((p - v_0) ** 2 + (p - v_1) ** 2) / (2 * a) - way

    return low if beyond(low) >= 0 else brentq(beyond, low, top, xtol=1e-14) if beyond(top) >= 0 else top


def mismatch(rows: Rows, j: int, i: int) -> tuple[float, float]:
    """Mean speed of the interval i less the mean of its rows' speeds, and how far rounding may put it off."""
    t, q, off, off_t = printed(rows, j)
    v, off_v = rows.qd[:, j], rows.doubt_v[:, j] / 2
    h, open_t = t[i + 1] - t[i], off_t[i] + off_t[i + 1]
    mean = (q[i + 1] - q[i]) / h
    doubt = (off[i] + off[i + 1] + abs(mean) * open_t) / (h - open_t) + (off_v[i] + off_v[i + 1]) / 2
    return mean - (v[i] + v[i + 1]) / 2, doubt


def speeds(rows: Rows, j: int) -> Series:
    t, q, off, off_t = printed(rows, j)
    for m, every in pairs(len(t)):
        yield t[:-m], np.array([
            max(abs(q[i + m] - q[i]) - off[i] - off[i + m], 0.0) / (t[i + m] - t[i] + off_t[i] + off_t[i + m])
            for i in every
        ])  # fmt: skip
    if rows.qd is None:
        return
    v, step = rows.qd[:, j], rows.doubt_v[:, j]
    yield t, np.abs(v) - step
    if rows.exact:
        spline, places = CubicHermiteSpline(t, q, v), between(t)
        doubt = [max(step[i], step[i + 1]) + 1.5 * mismatch(rows, j, i)[1] for i in range(len(t) - 1)]
        yield places, np.abs(spline(places, 1)) - np.repeat(doubt, 4)
    for sign in (1, -1):
        peaks = []
        for i in range(len(t) - 1):
            e, doubt = mismatch(rows, j, i)
            e = np.sign(e) * max(abs(e) - doubt, 0.0)
            h = t[i + 1] - t[i]
            way = sign * ((v[i] + v[i + 1]) / 2 + e) * h
            peak = least_peak(sign * v[i], sign * v[i + 1], way, h, A[j] * (1 + JOINT))
            peaks.append(peak - max(step[i], step[i + 1]))
        yield t[:-1], np.array(peaks)


def between(t: Array) -> Array:
    """The places between rows that are looked at."""
    return np.concatenate([a + np.array([0.2, 0.4, 0.6, 0.8]) * (b - a) for a, b in pairwise(t)])


@pytest.mark.parametrize(("with_speeds", "marked"), [(False, False), (True, False), (True, True)])
@pytest.mark.parametrize("j", [0, 5])
def test_least_speeds(j: int, with_speeds: bool, marked: bool) -> None:
    """Of every lag, of the rows, of the Hermite, and of the slowest motion between two rows."""
    rows = rows_of(1, with_speeds, marked)
    found = of_axis(j, joints._axis_speeds(rows, 0, N - 1))
    wanted = list(speeds(rows, j))
    if with_speeds:  # the slowest motion alone may be slower than its rows
        for k in (-2, -1):
            floor = wanted[k][1].min()
            found[k] = found[k][0], np.maximum(found[k][1], floor)
            sign = 1 if k == -2 else -1
            low = np.maximum(sign * rows.qd[:-1, j], sign * rows.qd[1:, j])
            low = low - np.maximum(rows.doubt_v[:-1, j], rows.doubt_v[1:, j])
            above = wanted[k][1] > low + 1e-9
            assert above.sum() > 5
            found[k], wanted[k] = ((t[above], x[above]) for t, x in (found[k], wanted[k]))
    same(found, wanted)


def test_the_hermite_between_rows() -> None:
    """Its places and accelerations are SciPy's; rounding of both ends of an interval, and of its length, enters."""
    j, rows = 5, rows_of(3, marked=True)
    t, q, off, off_t = printed(rows, j)
    v, off_v, h = rows.qd[:, j], rows.doubt_v[:, j] / 2, np.diff(rows.t)
    spline = CubicHermiteSpline(t, q, v)
    begin, end = 2 * spline.c[1], 6 * spline.c[0] * h + 2 * spline.c[1]
    open_a, inner = [], []
    for i in range(N - 1):
        open_t = off_t[i] + off_t[i + 1]
        change = off_v[i] + off_v[i + 1] + abs(v[i + 1] - v[i]) / h[i] * open_t
        open_a.append((6 * mismatch(rows, j, i)[1] + change) / (h[i] - open_t))
        # a Hermite's base functions of both slopes are 4/27 at most
        fastest = max(abs(v[i]), abs(v[i + 1]))
        inner.append(max(off[i], off[i + 1]) + 8 / 27 * (h[i] * max(off_v[i], off_v[i + 1]) + fastest * open_t))
    np.testing.assert_allclose(rows.mismatch[0][:, j], [mismatch(rows, j, i)[0] for i in range(N - 1)], atol=1e-12)
    np.testing.assert_allclose(rows.mismatch[1][:, j], [mismatch(rows, j, i)[1] for i in range(N - 1)], rtol=1e-9)
    np.testing.assert_allclose(rows.hermite_rounding[:, j], open_a, rtol=1e-9)
    np.testing.assert_allclose(rows.inner_doubt[:, j], inner, rtol=1e-9)
    granted = np.array(open_a) + rows.truncation[:, j]
    found = of_axis(j, axis_accelerations(rows, 0, N - 1))[-2:]
    same(found, [(t[:-1], np.abs(begin) - granted), (t[1:], np.abs(end) - granted)])


@pytest.mark.parametrize("with_speeds", [False, True])
@pytest.mark.parametrize("j", [0, 5])
def test_least_accelerations(j: int, with_speeds: bool) -> None:
    """Second divided differences of the positions, and differences of the speeds."""
    rows = rows_of(2, with_speeds)
    t, q, off, off_t = printed(rows, j)
    wanted = []
    for m, every in pairs(N, 2):
        parts = [second(t, q, off, off_t, i, i + m, i + 2 * m) for i in every]
        wanted.append((t[m : N - m], np.array([abs(x) - doubt for x, doubt in parts])))
    if with_speeds:
        v, off_v = rows.qd[:, j], rows.doubt_v[:, j] / 2
        for m, every in pairs(N):
            change = [max(abs(v[i + m] - v[i]) - off_v[i] - off_v[i + m], 0.0) for i in every]
            wanted.append((t[:-m], np.array(change) / [t[i + m] - t[i] + off_t[i] + off_t[i + m] for i in every]))
    same(of_axis(j, axis_accelerations(rows, 0, N - 1)), wanted)


@pytest.mark.parametrize("j", [0, 5])
def test_least_accelerations_at_both_ends_of_a_file(j: int) -> None:
    """From rest an axis goes a h^2/2 in a time h at most."""
    rows = rows_of(4)
    t, q, off, off_t = printed(rows, j)
    wanted = []
    for a, b in ((0, 1), (N - 2, N - 1)):
        way, h = max(abs(q[b] - q[a]) - off[a] - off[b], 0.0), t[b] - t[a] + off_t[a] + off_t[b]
        wanted.append(2 * way / h**2)
    same(of_axis(j, [joints._from_rest(rows)]), [(t[[0, -1]], np.array(wanted))])
    assert min(wanted) > 0


@pytest.mark.parametrize("with_speeds", [False, True])
def test_least_jerks(with_speeds: bool) -> None:
    """Second divided differences of speeds, or third ones of positions, of the file with rest before it and behind."""
    n, j = 120, 3  # a lag of 32 rows fits thrice into it and its rests
    rows = rows_of(5, with_speeds, n=n)
    t, q, off, off_t = printed(rows, j)
    rest = np.arange(1, 33) * 1e-3
    x, half = (rows.qd[:, j], rows.doubt_v[:, j] / 2) if with_speeds else (q, off)
    before, behind = (0.0, 0.0) if with_speeds else (q[0], q[-1])
    x = np.r_[np.full(32, before), x, np.full(32, behind)]
    half, off_t = (np.r_[np.full(32, one[0]), one, np.full(32, one[-1])] for one in (half, off_t))
    t = np.r_[t[0] - rest[::-1], t, t[-1] + rest]
    wanted = []
    for m, every in pairs(len(t), 2 if with_speeds else 3):
        if with_speeds:
            parts = [second(t, x, half, off_t, i, i + m, i + 2 * m) for i in every]
            wanted.append((t[m : len(t) - m], np.array([abs(a) - doubt for a, doubt in parts])))
            continue
        values = []
        for i in every:
            (a, off_a), (b, off_b) = (second(t, x, half, off_t, k, k + m, k + 2 * m) for k in (i, i + m))
            values.append(3 * (abs(b - a) - off_a - off_b) / (t[i + 3 * m] - t[i] + off_t[i] + off_t[i + 3 * m]))
        wanted.append((t[m : len(t) - 2 * m], np.array(values)))
    same(of_axis(j, joints._jerks(rows, 0, n - 1)), wanted)


@pytest.mark.parametrize("j", [0, 5])
def test_speeds_that_differ_from_those_of_the_positions(j: int) -> None:
    """Full acceleration one way and then the other takes the mean speed off the mean of the speeds by A h/4; less of it
    is left where the speeds themselves need some."""
    rows = rows_of(6)
    excess, off, may = (one[:, j] for one in joints._off_columns(rows, 0, N - 1))
    top = A[j] * (1 + JOINT)
    for i in range(N - 1):
        (e, doubt), h = mismatch(rows, j, i), rows.t[i + 1] - rows.t[i]
        change = abs(rows.qd[i + 1, j] - rows.qd[i, j]) - (rows.doubt_v[i, j] + rows.doubt_v[i + 1, j]) / 2
        used = min(max(change, 0.0) / (top * h), 1.0)
        room = top * h / 4 * (1 - used**2)
        assert (off[i], may[i]) == (pytest.approx(abs(e), rel=1e-9), pytest.approx(room + doubt, rel=1e-9))
        assert excess[i] == pytest.approx(abs(e) - room - doubt, abs=1e-12)


def test_least_speeds_at_rows_and_rest() -> None:
    """With speeds the printed one less its step; else the mean to the faster neighbour less A h/2. An axis rests up to
    1e-5, and up to A tau where the boundary may be tau away."""
    for with_speeds, marked in ((True, False), (True, True), (False, False)):
        rows = rows_of(7, with_speeds, marked)
        if with_speeds:
            least = np.maximum(np.abs(rows.qd) - rows.doubt_v, 0.0)
        else:
            h = np.diff(rows.t) + (rows.step_t[1:] + rows.step_t[:-1]) / 2
            way = np.abs(np.diff(rows.q, axis=0)) - (rows.doubt_q[1:] + rows.doubt_q[:-1]) / 2
            mean = np.maximum(np.maximum(way, 0.0) / h[:, None] - A * h[:, None] / 2, 0.0)
            least = np.array([mean[max(i - 1, 0) : i + 1].max(axis=0) for i in range(N)])
        np.testing.assert_allclose(rows.least_axis_speed[:], least, rtol=1e-9, atol=1e-15)
        long = np.diff(rows.t) + (rows.step_t[1:] + rows.step_t[:-1]) / 2
        tau = np.array([0.0 if marked else long[max(i - 1, 0) : i + 1].max() / 2 for i in range(N)])
        np.testing.assert_allclose(rows.open_time, tau, rtol=1e-12)
        assert unseen(rows, 9) == pytest.approx(4 * tau[9])
        for factor in (0.99, 1.01):  # of the speed that the fastest axis may have there
            scale = factor / (least / (REST_JOINT + A * tau[:, None])).max(axis=1)
            if with_speeds:
                slow = rows.qd * scale[:, None]
                slow = np.sign(slow) * (np.abs(slow) + (1 - scale[:, None]) * rows.doubt_v)
                steps = Resolution(rows.step_t, rows.doubt_q, rows.doubt_v)
                again = judged_rows(PLANT, Trajectory(PLANT.limits.names, rows.t, rows.q, slow), steps)
                assert again.axes_rest.all() == (factor < 1) == again.axes_rest.any()


def test_truncation_is_twice_the_error_of_a_hermite() -> None:
    """The cubic through a quartic c t^4 has an acceleration that is off by h^2/12 * 24 c at both ends of an interval.
    It is no more than a motion has whose acceleration changes from one limit to the other in 30 ms; a switch shows on
    one side only and counts for nothing."""
    t = np.r_[np.arange(20) * 4e-3, 0.0785, np.arange(20, 41) * 4e-3]
    j, q, qd = 4, np.zeros((42, 7)), np.zeros((42, 7))

    def truncation(c: float, begin: float = -1.0) -> Array:
        u = np.maximum(t - begin, 0.0)
        q[:, j], qd[:, j] = c * u**4, 4 * c * u**3
        rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd), None)
        return np.asarray(rows.truncation[:, j])

    h = np.diff(t)
    np.testing.assert_allclose(truncation(50.0), 2 * h**2 / 12 * 24 * 50.0, rtol=1e-3)
    most = h**2 / 12 * A[j] / 0.03**2
    np.testing.assert_allclose(truncation(1e4), most, rtol=1e-9)
    kinked = truncation(50.0, 0.0800001)
    assert kinked[:20].max() < 1e-6
    q[:, j], qd[:, j] = 30 * np.maximum(t - 0.08, 0.0) ** 3, 90 * np.maximum(t - 0.08, 0.0) ** 2  # jerk jumps
    assert judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd), None).truncation[:, j].max() < 1e-6
    short = judged_rows(PLANT, Trajectory(PLANT.limits.names, t[:2], q[:2], qd[:2]), None)
    assert not short.truncation[:].any()


def test_positions_between_rows() -> None:
    """An axis that has turned back between two rows went on for v^2/(2 A) at least, less what its digits hide."""
    j, rows = 2, rows_of(8, marked=True)
    qd = np.random.default_rng(8).normal(size=(N, 7))
    qd[::5] = 0.0  # to rest is not back
    rows = replace(rows, trajectory=replace(rows.trajectory, qd=qd))
    t, q, v, step = rows.t, rows.q[:, j], rows.qd[:, j], rows.doubt_v[:, j]
    places = [(times, up[:, j], down[:, j]) for times, up, down in joints._positions(rows, 0, N - 1)]
    spline, at = CubicHermiteSpline(t, q, v), between(t)
    wanted = [(t, q, q), (), (at, spline(at), spline(at))]
    for k in (0, 2):
        for found, one in zip(places[k], wanted[k], strict=True):
            np.testing.assert_allclose(found, one, rtol=1e-12)
    turns = []
    for i in range(N - 1):
        if v[i] * v[i + 1] < 0:
            reach = [max(abs(v[k]) - step[k], 0.0) ** 2 / (2 * A[j]) for k in (i, i + 1)]
            far = np.array([q[i], q[i + 1]]) + np.sign(v[i]) * np.array(reach)
            turns.append((t[i], far.max() if v[i] > 0 else q[i], far.min() if v[i] < 0 else q[i]))
    assert len(turns) > 15
    found = np.array(places[1]).T
    turned = np.isin(found[:, 0], [when for when, _, _ in turns])
    np.testing.assert_allclose(found[turned], turns, rtol=1e-12)
    here = q[np.searchsorted(t, found[~turned, 0])]
    np.testing.assert_array_equal(found[~turned, 1:], np.column_stack([here, here]))  # where another one has
    assert len(list(joints._positions(rows_of(8), 0, N - 1))) == 2
    assert len(list(joints._positions(rows_of(8, speeds=False), 0, N - 1))) == 1


def rail_file(t: Array, d: Array, v: Array | None = None, j: int = 0) -> Trajectory:
    """One axis moves, the others stand where they start."""
    q, qd = np.tile(PLANT.start, (len(t), 1)), np.zeros((len(t), 7))
    q[:, j] = d
    if v is not None:
        qd[:, j] = v
    return Trajectory(PLANT.limits.names, t, q, None if v is None else qd)


def limited(plant: Plant = PLANT, **changes: float) -> Plant:
    """The plant with other limits of the rail."""
    given = {name: getattr(plant.limits, name) for name in changes}
    new = {name: np.r_[value, np.full(6, 1e9) if given[name] is None else given[name][1:]]
           for name, value in changes.items()}  # fmt: skip
    return replace(plant, limits=replace(plant.limits, **new, jerk_binds="jerk" in new or plant.limits.jerk_binds))


WAVE = 0.06  # m: the rail sways by that once in a second


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("step", [None, 2e-5])
@pytest.mark.parametrize("with_speeds", [True, False])
def test_a_limit_is_broken_a_hair_beyond_its_tolerance(with_speeds: bool, step: float | None, sign: int) -> None:
    """Value and time are those of the worst place; passed is whether the value is within a millionth of the limit, of a
    position within a millionth of the range and half a printed step."""
    t = np.arange(0, 1.2, 0.005)
    d, v = 1.0 + sign * WAVE * np.sin(2 * np.pi * t), sign * WAVE * 2 * np.pi * np.cos(2 * np.pi * t)
    file = rail_file(t, d, v if with_speeds else None)
    r = step or 1e-12
    steps = None if step is None else Resolution(0.0, np.full(7, step), np.full(7, step * with_speeds))

    def told(plant: Plant) -> dict[str, tuple[float, float, float | None, bool]]:
        found = check_joints(judged_rows(plant, file, steps), lambda _: None)
        return {f.check: (f.value, f.limit, f.time, f.passed) for f in found if f.subject == "rail"}

    wide = limited(velocity=50.0, acceleration=500.0, lower=-10.0, upper=10.0, jerk=5e7)
    for side in ("upper", "lower"):
        for over in (0.99, 1.01):
            end = d.max() if side == "upper" else d.min()
            towards = 1 if side == "upper" else -1
            # end - limit = tolerance (upper - lower) + r/2
            other = -9.0 if side == "upper" else 11.0
            x = (over * r / 2 + over * JOINT * abs(end - other)) / (1 + over * JOINT)
            end -= towards * x
            lower, upper = sorted((end, other))
            plant = limited(wide, lower=lower, upper=upper)
            value, limit, when, passed = told(plant)["joint position"]
            assert (value, limit) == (pytest.approx(end + towards * x, abs=1e-12), end)
            assert when == pytest.approx(0.25 if (side == "upper") == (sign > 0) else 0.75)
            assert passed == (over < 1), (side, over)
    for field in ("velocity", "acceleration", "jerk"):
        check = "joint speed" if field == "velocity" else f"joint {field}"
        value, _, when, passed = told(wide)[check]
        assert passed
        for over in (0.9, 1.1):
            limit = value / (1 + over * JOINT)
            again = told(limited(wide, **{field: limit}))[check]
            assert again == (pytest.approx(value, rel=1e-12), pytest.approx(limit), when, over < 1)


def test_the_first_and_the_last_row_are_looked_at() -> None:
    """From the least position to the greatest or back: one of them is at the end that is nearer to its limit."""
    t = np.arange(0, 0.5, 0.005)
    for sign, upper in ((1, 1.5), (1, 1.6), (-1, 1.5), (-1, 1.6)):
        file = rail_file(t, 1.0 + sign * 0.4 * (t - 0.25) / 0.25)
        rows = judged_rows(limited(upper=upper, lower=0.45), file, None)
        (found,) = (
            f for f in check_joints(rows, lambda _: None) if f.subject == "rail" and f.check == "joint position"
        )
        assert found.time == (t[-1] if (sign > 0) == (upper < 1.55) else 0.0)


def test_coupled_joints_are_held_to_the_range_of_their_sum() -> None:
    """Value, limit and time are those of the sum; rounding of every joint counts by its factor, and where the sum
    turned back between two rows it went on for v^2/(2 A), A the sum of the joints' by their factors."""
    factors = np.array([-0.5, 2.0])
    t = np.sort(np.r_[np.arange(60) * 5e-3, 0.1525])
    bare = np.arange(60) * 5e-3
    kinds = [(marks, speeds, sign) for marks in (bare, t) for speeds in (False, True) for sign in (1, -1)]
    for t, speeds_given, sign in kinds:
        marked = len(t) > 60
        q, qd = np.tile(PLANT.start, (len(t), 1)), np.zeros((len(t), 7))
        x, v = sign * 0.2 * np.sin(12 * t), sign * 2.4 * np.cos(12 * t)
        q[:, 2], qd[:, 2], q[:, 3], qd[:, 3] = 0.3 * x, 0.3 * v, 0.575 * x, 0.575 * v  # sum: x
        step = np.full(7, 1e-4)
        steps = Resolution(0.0, step, step if speeds_given else 0 * step)
        doubt = 2.5e-4 / 2
        top = 0.5 * A[2] + 2 * A[3]
        places = {float(time): float(value) for time, value in zip(t, x, strict=True)}
        if speeds_given and marked:
            spline, at = CubicHermiteSpline(t, x, v), between(t)
            places |= dict(zip(at.tolist(), spline(at).tolist(), strict=True))
        if speeds_given:
            for i in range(len(t) - 1):
                if v[i] * v[i + 1] < 0:
                    reach = np.maximum(np.abs(v[i : i + 2]) - 2.5e-4, 0) ** 2 / (2 * top)
                    far = x[i : i + 2] + np.sign(v[i]) * reach
                    places[float(t[i])] = float(far.max() if v[i] > 0 else far.min())
        for high in (True, False):
            when = max(places, key=lambda time: places[time] if high else -places[time])
            end = places[when]
            for over in (0.99, 1.01):
                other = end - 3.0 if high else end + 3.0
                limit = end - (1 if high else -1) * over * (doubt + JOINT * 3.0)
                one = CoupledRange(("joint_2", "joint_3"), tuple(factors), *sorted((limit, other)))
                plant = replace(PLANT, limits=replace(PLANT.limits, coupled=(one,)))
                rows = judged_rows(plant, Trajectory(PLANT.limits.names, t, q, qd if speeds_given else None), steps)
                assert rows.exact == (speeds_given and marked)
                found = check_joints(rows, lambda _: None)[0]
                with pytest.MonkeyPatch.context() as small:
                    small.setattr(rows_module, "PIECE", 16)
                    small.setattr(rows_module, "OVERLAP", 4)
                    again = judged_rows(plant, rows.trajectory, steps)
                    assert check_joints(again, lambda _: None)[0] == found
                assert (found.subject, found.unit) == ("-0.5 joint_2 + 2 joint_3", "rad")
                assert (found.value, found.limit) == (pytest.approx(end, abs=1e-9), limit)
                assert found.time == pytest.approx(when, abs=1e-9)
                assert found.passed == (over < 1)
