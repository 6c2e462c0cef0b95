"""`trajopt study optimize`: the best point is found where it is known, whatever the cluster."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import pytest
from distributed import Client
from pyarrow import parquet
from tiny import written

from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.cluster import Pool
from trajopt_cli.parameter_study.point import PointInputs, Row, blank
from trajopt_cli.parameter_study.sampling import Point
from trajopt_cli.parameter_study.search import Goal, search
from trajopt_cli.parameter_study.study_file import Study, read_study

VARY = """programs: [tiny.mod]
answers: [rapid]
sampling: {latin_hypercube: 10}
vary:
  limits.joint_1.velocity: {uniform: [1.0, 3.0]}
  limits.joint_1.acceleration: {list: [2, 4, 6, 8, 10, 12]}
price: 100 * limits.joint_1.velocity
"""


def stand_in(inputs: PointInputs, point: Point) -> Row:
    """Least at a velocity of 2.3 and an acceleration of 8; nothing can be done below 1.2."""
    v, a = point.values
    if v < 1.2:
        return blank(inputs, point, "infeasible", "too slow")
    return {**blank(inputs, point, "ok", ""), "rapid_s": 5 + (v - 2.3) ** 2 + 0.01 * (a - 8) ** 2, "price": 100 * v}


@pytest.fixture(autouse=True)
def a_task_of_several_points(monkeypatch: pytest.MonkeyPatch) -> None:
    """As soon as it is known that these take no time."""
    monkeypatch.setattr("trajopt_cli.parameter_study.search.Pool", partial(Pool, _mean=0.1))


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Study:
    monkeypatch.chdir(tmp_path)
    return read_study(written(tmp_path, VARY))


@pytest.mark.long
def test_a_known_optimum_is_found_and_a_stopped_search_goes_on(study: Study, client: Client, tmp_path: Path) -> None:
    goal = Goal("rapid_s", points=80, seed=1)
    found = search(study, goal, tmp_path / "whole", client, work=stand_in)
    assert found is not None
    assert found["rapid_s"] == pytest.approx(5.0, abs=0.01)
    assert found["limits.joint_1.acceleration_rad_per_s2"] == 8
    # stopped after some of its parts
    whole = tmp_path / "whole"
    half = tmp_path / "half"
    half.mkdir()
    for name in ("study.yaml", "study.json", *(f"parts/part-{i:06}.parquet" for i in range(4))):
        (half / name).parent.mkdir(exist_ok=True)
        (half / name).write_bytes((whole / name).read_bytes())
    assert search(study, goal, half, client, work=stand_in) == found
    assert (half / "points.parquet").read_bytes() == (whole / "points.parquet").read_bytes()


def test_the_best_point_keeps_its_constraints(study: Study, client: Client, tmp_path: Path) -> None:
    goal = Goal("rapid_s", ("price <= 150", "limits.joint_1.acceleration >= 3"), points=80, seed=1)
    best = search(study, goal, tmp_path / "out", client, work=stand_in)
    assert best is not None
    assert best["price"] <= 150
    assert best["rapid_s"] == pytest.approx(5 + 0.8**2, abs=0.03)


def test_the_same_levels_are_planned_once(client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Six combinations, twenty points: no row is worked out again, and each has its number."""
    monkeypatch.chdir(tmp_path)
    vary = VARY.replace("{uniform: [1.0, 3.0]}", "[1.5, 2.3]").replace("[2, 4, 6, 8, 10, 12]", "[2, 8, 12]")
    study = read_study(written(tmp_path, vary))
    best = search(study, Goal("rapid_s", points=20), tmp_path / "out", client, work=stand_in)
    assert best is not None
    assert best["rapid_s"] == 5.0
    rows, timings = (parquet.read_table(tmp_path / "out" / name) for name in ("points.parquet", "timings"))
    assert rows["point"].to_pylist() == [*range(20)]
    assert len(timings) <= 6
    for row in rows.to_pylist():
        v, a = row["limits.joint_1.velocity_rad_per_s"], row["limits.joint_1.acceleration_rad_per_s2"]
        assert row["rapid_s"] == 5 + (v - 2.3) ** 2 + 0.01 * (a - 8) ** 2


def test_nothing_found_is_no_point(study: Study, client: Client, tmp_path: Path) -> None:
    goal = Goal("rapid_s", ("price <= 1",), points=8)
    assert search(study, goal, tmp_path / "out", client, work=stand_in) is None


@pytest.mark.parametrize("goal", [("speed",), ("rapid_s", ("price < 3",)), ("rapid_s", ("price",))])
def test_goals_that_are_none_are_refused(goal: tuple[str, ...]) -> None:
    with pytest.raises(InputError):
        Goal(*goal)  # type: ignore[arg-type]


def test_a_constraint_on_what_is_not_there_is_refused(study: Study, client: Client, tmp_path: Path) -> None:
    with pytest.raises(InputError):
        search(study, Goal("rapid_s", ("colour <= 3",), points=4), tmp_path / "out", client, work=stand_in)
