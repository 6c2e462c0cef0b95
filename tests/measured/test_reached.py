"""What axes reached, from logs of motions in closed form: never more than the truth, most of it, and no noise."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.limits import AccelerationTable, JointLimits, TcpCaps
from trajopt_cli.measured.identify import Kind
from trajopt_cli.measured.reached import Reached, contradictions, reached_in, tool_beyond
from trajopt_cli.trajectory import Trajectory

NAMES = tuple(f"joint_{i}" for i in range(1, 7))
LIMITS = JointLimits(NAMES, np.full(6, -4.0), np.full(6, 4.0), np.full(6, 3.0), np.full(6, 10.0))
CENT = np.radians(0.01)
Motion = Callable[[np.ndarray], np.ndarray]


def waves(seed: int, end: float = 12.0) -> tuple[Motion, np.ndarray, np.ndarray]:
    """Six axes that each swing in three frequencies, and their top speeds and accelerations (6,) until end [s]."""
    rng = np.random.default_rng(seed)
    size, rate, at = rng.uniform(0.05, 0.6, (3, 6)), rng.uniform(0.5, 6, (3, 6)), rng.uniform(0, 6.3, (3, 6))

    def of(t: np.ndarray, power: int = 0) -> np.ndarray:
        return np.sum(size * rate**power * np.sin(t[:, None, None] * rate + at + power * np.pi / 2), axis=1)

    v, a = (np.abs(of(np.linspace(0, end, 20_001), power)).max(axis=0) for power in (1, 2))
    return of, v, a


def trapezoids(t: np.ndarray, a: float, v: float) -> np.ndarray:
    """To and fro without a rest, ramps of v / a and 0.4 s between them."""
    ramp, cruise = v / a, 0.4
    half = 2 * ramp + cruise
    z, back = np.mod(t, half), np.mod(t, 2 * half) >= half
    s = np.where(z < ramp, a * z**2 / 2, np.where(z < ramp + cruise, v * (z - ramp / 2), v * (ramp + cruise)))
    s = np.where(z >= ramp + cruise, v * (ramp + cruise) - a * (half - z) ** 2 / 2, s)
    return np.where(back, v * (ramp + cruise) - s, s)


def one_axis(t: np.ndarray, q: np.ndarray, quantum: float = CENT) -> Trajectory:
    rows = np.zeros((len(t), 6))
    rows[:, 2] = np.rint(q / quantum) * quantum
    return Trajectory(NAMES, t, rows)


def of(log: Trajectory, kind: Kind) -> Reached | None:
    return next((one for one in reached_in([log], ["a.csv"], LIMITS) if one.kind is kind), None)


def recorded(
    t: np.ndarray, motion: Motion, rng: np.random.Generator, quantum: float, jitter: float, lost: float, stale: float
) -> Trajectory:
    """A motion in rows at t that are rounded and come early or late, some lost, some those of the row before."""
    q = np.rint(motion(np.clip(t + rng.normal(size=len(t)) * jitter, 0, t[-1])) / quantum) * quantum
    held = np.maximum(np.arange(len(t)) - (rng.random(len(t)) < stale), 0)
    kept = rng.random(len(t)) >= lost
    return Trajectory(NAMES, t[kept], q[held][kept])


@pytest.mark.parametrize(
    ("period", "quantum", "jitter", "lost", "stale", "least"),
    [
        (0.004, 1e-5, 0.0, 0.0, 0.0, 0.97),
        (0.008, CENT, 0.0, 0.0, 0.0, 0.95),
        (0.004, 10 * CENT, 0.0, 0.0, 0.0, 0.9),  # steps as large as what is told: more noise than value in one window
        (0.004, CENT, 1e-3, 0.02, 0.0, 0.9),
        (0.008, CENT, 2e-3, 0.1, 0.1, 0.8),
        (0.024, 10 * CENT, 1e-3, 0.05, 0.0, 0.8),
    ],
)
def test_most_of_the_truth_and_never_more(
    period: float, quantum: float, jitter: float, lost: float, stale: float, least: float
) -> None:
    shares = []
    for seed in range(4):
        motion, v, a = waves(seed)
        log = recorded(np.arange(0, 12, period), motion, np.random.default_rng(seed), quantum, jitter, lost, stale)
        for one in reached_in([log], ["a.csv"], LIMITS):
            shares.append(one.value / (v if one.kind is Kind.SPEED else a)[NAMES.index(one.axis)])
    assert len(shares) == 48
    assert max(shares) <= 1.0
    assert np.median(shares) >= least


def test_noise_and_bursts_are_no_acceleration() -> None:
    """A steady speed, by a clock that is off; and by one that held rows back, and then gave them all at once."""
    t = np.arange(0, 20, 0.004)
    rng = np.random.default_rng(1)
    for jitter in (5e-4, 2e-3):
        found = of(one_axis(t, 0.1 * (t + rng.normal(size=len(t)) * jitter)), Kind.ACCELERATION)
        assert found is None or found.value < 0.02
    q = 0.1 * t
    q[3000] += 0.01  # one row that is off
    assert of(one_axis(t, q), Kind.ACCELERATION) is None
    for rows in (5, 17, 40):
        stamps = t.copy()
        for end in (2000, 2100, 4000):
            stamps[end - rows : end] = t[end] - 0.001 * np.arange(rows, 0, -1)
        log = one_axis(stamps, 0.1 * t)
        found = of(log, Kind.ACCELERATION)
        assert found is None or found.value < 0.02
        assert of(log, Kind.SPEED).value == pytest.approx(0.1, rel=0.02)  # type: ignore[union-attr]


@pytest.mark.parametrize(("a", "too_low"), [(9.0, False), (10.45, False), (12.5, True)])
def test_a_limit_that_a_log_passes_is_told_with_place_and_posture(a: float, too_low: bool) -> None:
    t = np.arange(0, 10, 0.004)
    log = one_axis(t, trapezoids(t, a, 1.5))
    found = of(log, Kind.ACCELERATION)
    assert found is not None
    assert 0.95 * a < found.value <= a
    assert found.too_low is too_low
    said = [*contradictions([log], ["a.csv"], LIMITS, [found])]
    assert [("joint_3 reached" in one, "a.csv" in one) for one in said] == [(True, True)] * too_low
    assert np.interp(found.at, t, log.q[:, 2]) == pytest.approx(found.posture["joint_3"], abs=0.05)


def test_a_table_is_asked_at_the_posture_and_to_the_side() -> None:
    """A limit that is lower to the negative side, and the lower the larger joint_2 is."""
    grid = (np.array([0.0, 1.0]),)
    lower, upper = np.array([[8.0], [4.0]]), np.array([[40.0], [40.0]])
    table = AccelerationTable(("joint_3",), ("joint_2",), grid, lower, upper)
    limits = replace(LIMITS, acceleration=np.where(np.arange(6) == 2, 4.0, 10.0), table=table)
    t = np.arange(0, 10, 0.004)
    log = one_axis(t, trapezoids(t, 6.0, 1.5))
    log = Trajectory(NAMES, t, log.q + np.outer(t / 10, np.arange(6) == 1))
    found = next(one for one in reached_in([log], ["a.csv"], limits) if one.kind is Kind.ACCELERATION)
    assert found.at > 8
    assert found.limit == pytest.approx(8 - 4 * found.posture["joint_2"])
    assert 0.65 < np.mod(found.at, 1.8) < 1.15  # ramps of 0.25 s: it slows down, and then goes faster backwards


def test_a_posture_beyond_the_range_in_force_is_told() -> None:
    t = np.arange(0, 2, 0.01)
    log = one_axis(t, 4.02 * np.sin(t))
    assert "its range in force" in next(contradictions([log], ["a.csv"], LIMITS, []))
    assert [*contradictions([one_axis(t, 3.99 * np.sin(t))], ["a.csv"], LIMITS, [])] == []


def test_identify_answers_of_a_log_without_rests(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    t = np.arange(0, 12, 0.008)
    q = np.degrees(np.column_stack([trapezoids(t, 26.0, 1.5), *np.zeros((3, len(t))), t / 40, 0 * t]))
    rows = [";".join(f"{value:.3f}".replace(".", ",") for value in [now, *row]) for now, row in zip(t, q, strict=True)]
    log = tmp_path / "made.csv"
    log.write_text("\n".join(["t [s];" + ";".join(f"J{i} [deg]" for i in range(1, 7)), *rows]) + "\n")
    assert run(["identify", str(log), "--robot", "irb140", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    reached = {(one["axis"], one["kind"]): one for one in told["reached"]}
    assert reached["joint_1", "acceleration"]["value"] == pytest.approx(26.0, rel=0.1)
    assert ("joint_5", "speed") in reached
    assert ("joint_5", "acceleration") not in reached  # it goes on steadily
    assert ("joint_2", "speed") not in reached
    assert len(told["contradictions"]) == 1
    assert told["contradictions"][0].startswith("joint_1 reached")
    assert run(["identify", str(log), "--robot", "irb140", "--output", str(tmp_path / "limits.yaml")]) == 1
    assert "NOTHING WRITTEN" in capsys.readouterr().err


def test_a_tool_beyond_its_caps_is_told() -> None:
    """On a circle in space that it goes around at 1.5 m/s, which takes 4.5 m/s2 towards the middle."""
    t = np.arange(0, 8, 0.004)
    angle, tilt = 3.0 * t, np.array([[0.6, 0.0, 0.8], [0.0, 1.0, 0.0]])
    p = np.rint((0.5 * np.column_stack([np.cos(angle), np.sin(angle)]) @ tilt) / 1e-5) * 1e-5
    for speed, acceleration, told in ((1.45, 4.4, []), (1.35, 9.0, ["speed"]), (9.0, 4.0, ["acceleration"])):
        said = [*tool_beyond(t, p, TcpCaps(speed, acceleration), "a.csv")]
        assert ["acceleration" if "m/s²" in one else "speed" for one in said] == told
