"""A legal motion never fails: axes at any accelerations within limits, seen in any rows, printed to any digits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from legal_motion import plant_with_rail

from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.joints import check_joints
from trajopt_cli.judge.samples import judged_rows
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
V, A = PLANT.limits.velocity, PLANT.limits.acceleration


@dataclass(frozen=True)
class Drive:
    """Every axis at piecewise constant acceleration: switch times (m+1,), accelerations (m, k); rest at both ends."""

    times: Array
    a: Array

    def at(self, t: Array) -> tuple[Array, Array]:
        v_start = np.vstack([np.zeros(7), np.cumsum(self.a * np.diff(self.times)[:, None], axis=0)])
        h = np.diff(self.times)[:, None]
        q_start = np.vstack([np.zeros(7), np.cumsum(v_start[:-1] * h + self.a * h * h / 2, axis=0)])
        i = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.a) - 1)
        u = (t - self.times[i])[:, None]
        return PLANT.start + q_start[i] + u * (v_start[i] + u * self.a[i] / 2), v_start[i] + u * self.a[i]


def drive(seed: int) -> Drive:
    """Random spurts of full or partial acceleration within speed limits, each axis brought to rest at the end."""
    rng = np.random.default_rng(seed)
    lengths = rng.uniform(0.003, 0.05, 12)
    a, v = [], np.zeros(7)
    for h in lengths:
        want = rng.choice([-1.0, -0.5, 0.0, 1.0, 1.0], 7) * A * 0.999999
        want = np.where(np.abs(v + want * h) > V, (np.sign(v) * V - v) / h, want)
        v = v + want * h
        a.append(np.clip(want, -A, A))
    v = (np.array(a) * lengths[:, None]).sum(axis=0)
    brake = float(np.max(np.abs(v) / A)) * 1.000001 + 1e-3
    return Drive(np.r_[0.0, np.cumsum([*lengths, brake])], np.vstack([*a, -v / brake]))


def rows_for(motion: Drive, step: float, marks: bool, offset: float) -> Array:
    end = motion.times[-1]
    grid = np.arange(0.0, end, step) + offset * step
    marked = motion.times if marks else np.array([0.0, end])
    near = np.abs(grid[:, None] - marked[None, :]).min(axis=1) < 1e-5
    return np.unique(np.r_[grid[(grid < end) & ~near], marked])


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    step=st.sampled_from([1e-3, 4e-3, 0.0071]),
    marks=st.booleans(),
    offset=st.sampled_from([0.0, 0.37]),
    digits=st.sampled_from([None, 8, 6, 5]),
    speeds=st.booleans(),
)
def test_no_rows_of_a_legal_motion_are_called_too_fast(
    seed: int, step: float, marks: bool, offset: float, digits: int | None, speeds: bool
) -> None:
    motion = drive(seed)
    t = rows_for(motion, step, marks, offset)
    q, qd = motion.at(t)
    resolution = None
    if digits is not None:
        t, q, qd = (np.round(x, digits) for x in (t, q, qd))
        r = 10.0**-digits
        resolution = Resolution(r, np.full(7, r), np.full(7, r if speeds else 0.0))
    rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd if speeds else None), resolution)
    bad = [f for f in check_joints(rows, lambda _: None) if not f.passed and f.check != "joint position"]
    assert not bad, [f.message for f in bad]


def rail_rows(t: Array, d: Array, v: Array | None) -> Trajectory:
    q = np.tile(PLANT.start, (len(t), 1))
    q[:, 0] = d
    qd = None
    if v is not None:
        qd = np.zeros_like(q)
        qd[:, 0] = v
    return Trajectory(PLANT.limits.names, t, q, qd)


def failed(trajectory: Trajectory) -> dict[str, float]:
    rows = judged_rows(PLANT, trajectory, None)
    return {f.check: f.value for f in check_joints(rows, lambda _: None) if not f.passed and f.subject == "rail"}


def test_a_peak_speed_between_two_rows_is_seen() -> None:
    """0.985 m/s at two rows 40 ms apart, the mean between them 0.999: at 3 m/s2 the least peak p is above 1 m/s.

    v(t) rises with A to p, holds, and falls: p h - (p - v)^2 / A = mean h.
    """
    h, v, mean, a = 0.04, 0.985, 0.999, 3.0
    ramp = np.arange(12) * h
    slope = v / ramp[-1]
    t = np.r_[ramp, ramp[-1] + h + ramp]
    d_top = slope * ramp[-1] ** 2 / 2
    d = np.r_[slope * ramp**2 / 2, d_top + mean * h + v * ramp - slope * ramp**2 / 2]
    speed = np.r_[slope * ramp, v - slope * ramp]
    peak = v + (a * h - np.sqrt((a * h) ** 2 - 4 * a * h * (mean - v))) / 2
    assert peak > 1.001
    assert failed(rail_rows(t, d, speed)) == {"joint speed": pytest.approx(peak, rel=1e-5)}


def test_a_mean_speed_above_the_limit_is_seen_without_speed_columns() -> None:
    t = np.arange(0, 1.5, 0.01)
    v_end = 1.0 + 1.1e-6
    ramp = 0.5
    d = np.where(t < ramp, v_end / ramp * t**2 / 2, v_end * ramp / 2 + v_end * (t - ramp))
    found = failed(rail_rows(t[:100], d[:100], None))
    assert found["joint speed"] == pytest.approx(v_end, rel=1e-9)


def test_starting_at_speed_is_too_much_acceleration() -> None:
    """0.02 m/s in the first 10 ms row from rest needs 2 * 0.02 / 0.01 = 4 m/s2, whatever comes after."""
    t = np.arange(0, 20) * 0.01
    found = failed(rail_rows(t, 0.02 * t, None))
    assert found["joint acceleration"] == pytest.approx(4.0, rel=1e-6)


@pytest.mark.parametrize("begin", [10.0, 88000.0])
def test_an_acceleration_of_a_thousandth_too_much_is_seen_early_and_late(begin: float) -> None:
    """Late in a cycle times have five digits less; the rail goes 0.15 s up and 0.15 s down, on a row's edge or not."""
    for half in (0.15, 0.15037):
        t = begin + np.unique(np.r_[np.arange(301) * 1e-3, half, 2 * half])
        early, late = np.minimum(t - begin, half), np.maximum(t - begin - half, 0.0)
        share, speed = early**2 / 2 + half * late - late**2 / 2, early - late
        assert failed(rail_rows(t, 3.0 * share, 3.0 * speed)) == {}
        found = failed(rail_rows(t, 3.003 * share, 3.003 * speed))
        assert found == {"joint acceleration": pytest.approx(3.003, rel=1e-5)}


@pytest.mark.parametrize("side", [1, -1])
def test_the_hermite_is_judged_at_both_ends(side: int) -> None:
    """From rest to 15 mm/s in 10 ms, 105 um on: 2.2 m/s2 could do it, the Hermite begins with 1.5 + 1.8 (backwards:
    ends with it)."""
    h, v, more = 0.01, 0.015, 0.003
    t = np.unique(np.r_[np.arange(31) * h, 0.0333, 0.2633])
    speed = np.interp(t, [0.1, 0.1 + h, 0.2, 0.2 + h], [0.0, v, v, 0.0])
    d = np.r_[0.0, np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(t))]
    d[t > 0.105] += more * h
    if side < 0:
        t, d, speed = t[-1] - t[::-1], d[::-1], -speed[::-1]
    trajectory = rail_rows(t, d, speed)
    assert judged_rows(PLANT, trajectory, None).exact
    assert failed(trajectory) == {"joint acceleration": pytest.approx(v / h + 6 * more / h, rel=0.02)}
