"""The closed conditions against eigenvalues, simulated periods and the thesis' numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.controller.stability import StabilityVerdict, largest_period, poles, stability, stability_map
from trajopt_cli.iiwa.job.texts import law_table
from trajopt_cli.iiwa.task.model import Compliance, Integration

H = 1e-3
EULER, EXACT = Integration.EULER, Integration.EXACT


def transition(k: float, d: float, m: float, h: float, integration: Integration) -> Array:
    if integration is EULER:
        return np.array([[1 - h * d / m, -h * k / m], [h, 1]])
    return np.asarray(expm(h * np.array([[-d / m, -k / m], [1, 0]])))


def all_axes(k: float, d: float, m: float) -> Compliance:
    return Compliance(np.full(6, k), np.full(6, d), np.full(6, m))


@pytest.mark.parametrize("integration", Integration)
def test_verdicts_and_poles_are_those_of_the_eigenvalues(integration: Integration) -> None:
    """500 draws over decades of k, d, m, h, half of them near a bound; hand guiding and no damping among them."""
    rng = np.random.default_rng(7)
    seen = set()
    for draw in range(500):
        m, h = 10 ** rng.uniform(-1, 2), 10 ** rng.uniform(-3, -1)
        k = 0.0 if draw % 7 == 0 else 10 ** rng.uniform(0, 4)
        d = 10 ** rng.uniform(-1, 4)
        if draw % 2 and integration is EULER:
            bound = h * k if draw % 4 == 1 and k > 0 else 2 * m / h + h * k / 2
            d = bound * (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-4, -1))
        if draw % 11 == 0 and k > 0:
            d = 0.0
        values = np.linalg.eigvals(transition(k, d, m, h, integration))
        radius = np.abs(values).max()
        found = stability(all_axes(k, d, m), h, integration)[0]
        both = poles(k, d, m, h, integration)
        assert sorted(np.abs(both)) == pytest.approx(sorted(np.abs(values)), rel=1e-6, abs=1e-9)
        assert np.sum(both) == pytest.approx(np.sum(values).real, rel=1e-9, abs=1e-9)
        seen.add(found.verdict)
        if found.verdict is StabilityVerdict.STABLE:
            assert radius < 1
        elif found.verdict is StabilityVerdict.MARGINAL:
            assert radius == pytest.approx(1, abs=1e-12)
        else:
            assert radius > 1
        grid = stability_map([k], [d], m, h, integration)
        assert grid.shape == (1, 1)
        assert grid[0, 0] == found.verdict
    assert seen == set(StabilityVerdict) - ({StabilityVerdict.UNSTABLE} if integration is EXACT else set())


@pytest.mark.parametrize(
    ("k", "d", "m", "h", "verdict"),
    [
        (1000, 500, 25, 1e-3, StabilityVerdict.STABLE),
        (0, 500, 25, 1e-3, StabilityVerdict.MARGINAL),
        (0, 50001, 25, 1e-3, StabilityVerdict.UNSTABLE),
        (1000, 0, 25, 1e-3, StabilityVerdict.UNSTABLE),
        (1000, 1, 25, 1e-3, StabilityVerdict.MARGINAL),  # d = h k to the digit: swings
        (0, 64, 1, 1 / 32, StabilityVerdict.MARGINAL),  # poles 1 and -1: the speed turns round every period
        (4096, 128, 1, 1 / 32, StabilityVerdict.UNSTABLE),  # both bounds at once: a double pole at -1
        (2048, 96, 1, 1 / 32, StabilityVerdict.MARGINAL),  # h d/m = 2 + h^2 k/(2 m) = 3: a pole at -1, the other at 0
    ],
)
def test_single_cases_on_the_bounds(k: float, d: float, m: float, h: float, verdict: StabilityVerdict) -> None:
    """Exact in binary; what a million periods make of a state says the same as the verdict."""
    assert stability(all_axes(k, d, m), h)[0].verdict is verdict
    grown = np.linalg.norm(np.linalg.matrix_power(transition(k, d, m, h, EULER), 1_000_000))
    assert (grown > 1e5) == (verdict is StabilityVerdict.UNSTABLE)


def test_the_largest_period_is_where_the_poles_leave_the_circle() -> None:
    rng = np.random.default_rng(8)
    for _ in range(120):
        k, d, m = 10 ** rng.uniform(0, 4), 10 ** rng.uniform(0, 4), 10 ** rng.uniform(-1, 2)
        h = largest_period(k, d, m)
        inside, outside = (
            np.abs(np.linalg.eigvals(transition(k, d, m, h * factor, EULER))).max() for factor in (0.999, 1.001)
        )
        assert inside < 1 < outside
        # and every shorter period settles too
        for share in rng.uniform(0, 1, 5):
            assert stability(all_axes(k, d, m), h * share)[0].verdict is StabilityVerdict.STABLE
    assert largest_period(0, 500, 25) == pytest.approx(0.1)
    assert largest_period(1000, 0, 25) == 0
    assert largest_period(1000, 500, 25, EXACT) == np.inf


def test_what_settles_and_what_does_not_in_simulation() -> None:
    """One step either side of h k = d, 4000 periods: the swing dies out or grows by what the poles say."""
    for d, grows in ((0.9, True), (1.1, False)):
        x = response(np.zeros((4001, 6)), H, all_axes(1000, d, 25), x_0=np.ones(6)).x
        first, last = np.abs(x[:1100]).max(), np.abs(x[-1100:]).max()
        assert bool(last > first) is grows


def test_margins_of_the_thesis_axis() -> None:
    """K = 1000, D = 500, M = 25: s = -10 +- sqrt(60), ratio 500 / (2 sqrt(25000)); angles 30, 20, 3."""
    compliance = Compliance(
        np.array([1000.0] * 3 + [30] * 3), np.array([500.0] * 3 + [20] * 3), np.array([25.0] * 3 + [3] * 3)
    )
    x, *_, gamma = stability(compliance, H)
    slow = 10 - np.sqrt(60)
    assert x.damping_ratio == pytest.approx(1.5811388)
    assert x.slowest == pytest.approx(1 / slow, rel=2e-3)
    assert x.slowest == pytest.approx(-H / np.log(1 - H * slow), rel=1e-9)
    assert x.h_max == pytest.approx(2 / (10 + np.sqrt(60)), rel=1e-12)
    assert gamma.axis == "gamma"
    assert gamma.h_max == pytest.approx(2 / (20 / 6 + np.sqrt((20 / 6) ** 2 - 10)), rel=1e-12)
    guided = stability(all_axes(0, 500, 25), H, EXACT)[0]
    assert guided.slowest == pytest.approx(25 / 500, rel=1e-12)
    assert guided.damping_ratio == np.inf
    assert stability(all_axes(1000, 0, 25), H, EXACT)[0].slowest == np.inf
    assert stability(all_axes(1000, 20, 25), H, EXACT)[0].slowest == pytest.approx(2 * 25 / 20, rel=1e-9)


def test_the_slow_pole_survives_rounding() -> None:
    """k m twelve decades under d^2: the pole is at 1 - h k/d, not at 1."""
    slow = max(poles(1e-6, 1e3, 1.0, H, EXACT), key=abs)
    assert 1 - abs(slow) == pytest.approx(H * 1e-9, rel=1e-3)


@pytest.mark.parametrize(
    ("k", "d", "m", "integration", "sentence"),
    [
        (1000, 500, 25, EULER, "x settles"),
        (0, 500, 25, EULER, "x has k = 0: it stays where it is put (hand guiding)"),
        (
            2000,
            0.5,
            25,
            EULER,
            "x is unstable: d = 0.5 N s/m must be above h k = 2 N s/m (k = 2000 N/m, h = 1 ms); raise d, lower k or h, "
            "or use the exact discretisation",
        ),
        (
            1000,
            500,
            0.2,
            EULER,
            "x is unstable: d = 500 N s/m must be below 2 m/h + h k/2 = 400.5 N s/m (m = 0.2 kg, h = 1 ms); "
            "lower d, raise m, lower h, or use the exact discretisation",
        ),
        (
            1000,
            0,
            25,
            EXACT,
            "x has d = 0 with k = 1000 N/m: it oscillates forever; give it some damping",
        ),
    ],
)
def test_sentences(k: float, d: float, m: float, integration: Integration, sentence: str) -> None:
    assert stability(all_axes(k, d, m), H, integration)[0].sentence == sentence


def test_a_turning_axis_has_its_own_units() -> None:
    assert "N m s/rad" in stability(all_axes(30, 0.01, 3), H)[5].sentence


def test_the_map_is_the_verdict_of_every_pair() -> None:
    k, d = np.array([0.0, 100, 1000, 9000]), np.array([0.0, 0.5, 5, 500, 49900, 50100])
    for integration in Integration:
        grid = stability_map(k, d, 25.0, H, integration)
        assert grid.shape == (4, 6)
        for i, stiffness in enumerate(k):
            for j, damping in enumerate(d):
                if stiffness == damping == 0:
                    assert grid[i, j] == StabilityVerdict.UNSTABLE
                else:
                    assert grid[i, j] == stability(all_axes(stiffness, damping, 25), H, integration)[0].verdict


def test_the_table_of_laws_says_when_each_holds() -> None:
    first, second = stability(all_axes(1000, 500, 25), H), stability(all_axes(500, 500, 25), H)
    changed = law_table([*first, *(replace(axis, since=2.5) for axis in second)], H)
    holds = changed.heads.index("holds [s]")
    assert [(row[holds], row[changed.heads.index(">K")]) for row in changed.rows] == [
        ("0 to 2.5", "1000"),
        ("2.5 on", "500"),
    ]
    assert "holds [s]" not in law_table(first, H).heads
