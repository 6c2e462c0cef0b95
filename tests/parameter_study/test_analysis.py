"""What a study's rows say together, against closed forms and brute force."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.stats import norm, qmc

from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.analysis import StudyRows, pareto, variance_shares

Array = NDArray[np.float64]


def rows(y: Any, **factors: Any) -> StudyRows:
    columns = {"point": range(len(y)), **factors, "rapid_s": [*y], "status": ["ok"] * len(y), "reason": [""] * len(y)}
    return StudyRows(columns, {})


def sampled(count: int, many: int) -> Array:
    return np.asarray(qmc.LatinHypercube(many, rng=np.random.default_rng(3)).random(count))


def shares(y: Any, **factors: Any) -> dict[str, tuple[float, float]]:
    found = variance_shares(rows(y, **factors), "rapid_s")
    assert found is not None
    return {one.factor: (one.alone, one.total) for one in found.shares}


def test_shares_of_ishigamis_function() -> None:
    """sin x1 + a sin² x2 + b x3⁴ sin x1 on (−π, π)³: Ishigami and Homma, 1990."""
    a, b = 7.0, 0.1
    x = np.pi * (2 * sampled(1000, 3) - 1)
    y = np.sin(x[:, 0]) + a * np.sin(x[:, 1]) ** 2 + b * x[:, 2] ** 4 * np.sin(x[:, 0])
    one, two = (1 + b * np.pi**4 / 5) ** 2 / 2, a**2 / 8
    together = b**2 * np.pi**8 * (1 / 18 - 1 / 50)
    total = one + two + together
    found = variance_shares(rows(y, a=x[:, 0], b=x[:, 1], c=x[:, 2]), "rapid_s")
    assert found is not None
    assert found.explained > 0.99
    told = {share.factor: (share.alone, share.total) for share in found.shares}
    assert told["a"] == pytest.approx((one / total, (one + together) / total), abs=0.02)
    assert told["b"] == pytest.approx((two / total, two / total), abs=0.02)
    assert told["c"] == pytest.approx((0, together / total), abs=0.02)
    assert [share.factor for share in found.shares] == ["a", "b", "c"]


def test_shares_of_a_sum_are_its_variances_whatever_the_distributions() -> None:
    """3 u + 2 g + h(name): u even in (0, 1), g Gauss', names with values of their own."""
    s = sampled(800, 3)
    names = np.array(["red", "green", "blue"])[(3 * s[:, 2]).astype(int)]
    value = {"red": 0.0, "green": 1.0, "blue": 5.0}
    y = 3 * s[:, 0] + 2 * norm.ppf(s[:, 1]) + [value[one] for one in names]
    variances = 9 / 12, 4.0, np.var([*value.values()])
    told = shares(y, u=s[:, 0], g=norm.ppf(s[:, 1]), name=[str(one) for one in names])
    for factor, variance in zip(("u", "g", "name"), variances, strict=True):
        assert told[factor] == pytest.approx((variance / sum(variances),) * 2, abs=0.015)


def test_shares_of_a_grid_are_those_of_its_means() -> None:
    """Six rails, four heights: the analysis of variance of the table itself."""
    rail, height = (np.repeat(np.arange(6.0), 4), np.tile(np.arange(4.0), 6))
    table = (np.maximum(8 - np.arange(6.0), 5)[:, None] + 0.2 * (np.arange(4.0) - 1.5) ** 2).ravel()
    total = table.var()
    square = table.reshape(6, 4)
    told = shares(table, rail=rail, height=height)
    assert told["rail"] == pytest.approx((square.mean(axis=1).var() / total,) * 2, abs=1e-6)
    assert told["height"] == pytest.approx((square.mean(axis=0).var() / total,) * 2, abs=1e-6)


def test_of_many_factors_the_few_that_matter_are_named() -> None:
    """60 offsets, 300 points: a sum of two of them."""
    s = sampled(300, 60) - 0.5
    told = shares(8 + s[:, 7] - 2 * s[:, 30], **{f"x{i}": s[:, i] for i in range(60)})
    assert told["x30"] == pytest.approx((0.8, 0.8), abs=0.03)
    assert told["x7"] == pytest.approx((0.2, 0.2), abs=0.03)
    assert max(total for name, (_, total) in told.items() if name not in ("x7", "x30")) < 0.01


def test_columns_that_vary_together_are_one_factor() -> None:
    """Drives by name: a speed follows from the name, two drives have the same. Six of them, four heights."""
    drives = {"a": 1.0, "b": 1.0, "c": 2.0, "d": 3.0, "e": 4.0, "f": 5.0}
    extra = dict(zip(drives, (0.0, 1.0, 0.3, 0.2, 0.1, 0.0), strict=True))
    names, heights = [one for one in drives for _ in range(4)], [0.0, 1.0, 2.0, 3.0] * 6
    y = [8 / drives[one] + extra[one] + 0.5 * z for one, z in zip(names, heights, strict=True)]
    factors = {"rail.velocity": [drives[one] for one in names], "rail.source": names, "z": heights}
    rail, z = np.var([8 / drives[one] + extra[one] for one in drives]), 0.25 * np.var([0, 1, 2, 3])
    told = shares(y, **factors)
    assert told == {
        "rail": (pytest.approx(rail / (rail + z)), pytest.approx(rail / (rail + z))),
        "z": (pytest.approx(z / (rail + z)), pytest.approx(z / (rail + z))),
    }


def test_an_answer_that_never_varies_or_hardly_a_point_has_no_shares() -> None:
    assert variance_shares(rows([5.0] * 9, x=range(9)), "rapid_s") is None
    assert variance_shares(rows([5.0, 6.0], x=[0, 1]), "rapid_s") is None


def test_noise_is_not_explained() -> None:
    """What no factor foretells stays unexplained, however many terms there could be."""
    found = variance_shares(rows(np.random.default_rng(1).normal(size=200), x=sampled(200, 1)[:, 0]), "rapid_s")
    assert found is not None
    assert found.explained < 0.05


@pytest.mark.parametrize("make", [np.random.default_rng(0).random, lambda shape: np.floor(3 * sampled(*shape))])
def test_the_front_is_what_nothing_beats(make: Callable[[tuple[int, int]], Array]) -> None:
    for _ in range(20):
        values = make((30, 2))
        found = pareto(values)

        def beaten(i: int, values: Array = values) -> bool:
            better = ((values <= values[i]).all(axis=1)) & ((values < values[i]).any(axis=1))
            same_before = (values[:i] == values[i]).all(axis=1).any()
            return bool(better.any() or same_before)

        assert {*found} == {i for i in range(30) if not beaten(i)}
        assert (np.diff(values[found, 0]) > 0).all()


def test_points_without_an_answer_are_no_best_points() -> None:
    study = StudyRows(
        {
            "x": [1, 2, 3, 4],
            "rapid_s": [5.0, None, 4.0, 3.0],
            "saved_s": [1.0, None, 2.0, 3.0],
            "status": ["ok", "infeasible", "ok", "failed"],
        },
        {},
    )
    assert study.best("rapid_s").tolist() == [2, 0]
    assert study.best("saved_s").tolist() == [2, 0]
    assert (study.factors, study.answers, study.chosen(None)) == (("x",), ("rapid_s", "saved_s"), "rapid_s")
    with pytest.raises(InputError):
        study.chosen("stream_s")
