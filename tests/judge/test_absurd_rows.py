"""Rows that are no motion of a robot: refused where they are read, and never searched without end."""

from __future__ import annotations

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_without_rail, rapid

from trajopt_cli.errors import InputError
from trajopt_cli.findings import CLEARANCE, SELF_CLEARANCE, Finding
from trajopt_cli.geometry import pose
from trajopt_cli.joint_csv import ABSURD, check_reach, write_csv_text
from trajopt_cli.judge import clearance, continuous_collision
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.problem.plant import Plant
from trajopt_cli.shapes import Box, Solid
from trajopt_cli.trajectory import Trajectory

FAR_BOX = Solid(Box("far", np.array([0.1, 0.1, 0.1]), pose(np.eye(3), [5.0, 0.0, 0.0])))
PROGRAM = rapid("MoveAbsJ j_home,v1000,fine,tool0;")


def rows(plant: Plant, n: int, value: float = 0.0, row: int = 0, axis: int = 0) -> Trajectory:
    q = np.tile(plant.start, (n, 1))
    q[row, axis] = value or q[row, axis]
    return Trajectory(plant.limits.names, 1e-3 * np.arange(n), q, np.zeros_like(q))


def test_a_cell_of_a_million_is_refused_with_its_line_value_and_range() -> None:
    plant = plant_without_rail()
    text = write_csv_text(rows(plant, 5000, 1e6, row=4500, axis=2))
    with pytest.raises(InputError) as caught:
        judge(plant, PROGRAM, text, "a.csv")
    low, high = plant.limits.lower[2], plant.limits.upper[2]
    assert str(caught.value).startswith(f"a.csv:4502: joint_3 is 1e+06 rad, its range [{low:.6g}, {high:.6g}] rad")


def test_the_bound_is_a_hundred_ranges_on_either_side() -> None:
    plant = plant_without_rail()
    low, high, fast = plant.limits.lower, plant.limits.upper, plant.limits.velocity
    for side, sign in ((high, 1), (low, -1)):
        far = side[1] + sign * ABSURD * (high[1] - low[1])
        check_reach(rows(plant, 3, far * (1 - 1e-12), 1, 1), low, high, fast, "a.csv")
        with pytest.raises(InputError, match=r"a\.csv:3: joint_2 "):
            check_reach(rows(plant, 3, far * (1 + 1e-9), 1, 1), low, high, fast, "a.csv")


def test_a_speed_of_a_million_is_refused_with_its_line_value_and_limit() -> None:
    plant = plant_without_rail()
    one = rows(plant, 50)
    qd = np.zeros_like(one.q)
    qd[7, 1] = -1e6
    limit = plant.limits.velocity[1]
    with pytest.raises(InputError) as caught:
        judge(plant, PROGRAM, write_csv_text(replace(one, qd=qd)), "a.csv")
    assert str(caught.value).startswith(f"a.csv:9: the speed of joint_2 is -1e+06 rad/s, its limit {limit:.6g} rad/s")
    qd[7, 1] = ABSURD * limit
    check_reach(replace(one, qd=qd), plant.limits.lower, plant.limits.upper, plant.limits.velocity, "a.csv")


def to_and_fro(plant: Plant, n: int) -> Trajectory:
    """Axis 1 turns a hundred times between any two rows."""
    q = np.tile(plant.start, (n, 1))
    q[::2, 0], q[1::2, 0] = -300.0, 300.0
    return Trajectory(plant.limits.names, 1e-3 * np.arange(n), q, None)


def facing(found: list[Finding], check: str) -> Finding:
    return next(one for one in found if one.check == check)


def test_a_search_that_ends_before_its_time_is_no_pass(monkeypatch: pytest.MonkeyPatch) -> None:
    plant = replace(plant_without_rail(), obstacles=(FAR_BOX,), clearance=0.01)
    moving = to_and_fro(plant, 40)
    for module in (continuous_collision, clearance):
        monkeypatch.setattr(module, "LOOKS", 30)
    for check in (CLEARANCE, SELF_CLEARANCE):
        found = facing(check_clearance(PROGRAM, plant, moving, lambda _: None), check)
        assert found.value > found.limit
        assert not found.passed
        assert "are not judged to the end: after 30 looks the nearest is" in found.message


def test_memory_does_not_grow_with_the_looks_that_a_motion_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    beside = Solid(Box("beside", np.array([0.05, 0.05, 0.05]), pose(np.eye(3), [1.2, 0.0, 0.4])))
    plant = replace(plant_without_rail(), obstacles=(beside,), clearance=0.0)
    moving = to_and_fro(plant, 75)
    monkeypatch.setattr(continuous_collision, "_AT_ONCE", 128)
    peaks = []
    for looks in (800, 2_400):
        for module in (continuous_collision, clearance):
            monkeypatch.setattr(module, "LOOKS", looks)
        tracemalloc.start()
        check_clearance(PROGRAM, plant, moving, lambda _: None)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 2 * peaks[0]
