"""When rows are too far apart and digits too few for a file to be judged: to a hair, and what is told of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from by_hand import Ride, at
from legal_motion import home, move_j, plant_with_rail, program

from trajopt_cli.findings import Finding, Report
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge.verify import verify
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
RIDE = Ride(((0.0, 4), (0.5, 12), (0.2, 5)), between=60, step=0.01)
ASKED = program(move_j(11, "p_11", at(0.5)), home(12, 0.2))


def judged(rows: Trajectory, steps: Resolution | None = None) -> Report:
    return verify(ASKED, PLANT, rows, steps, advice=False)


def of_file(found: Sequence[Finding], check: str) -> list[Finding]:
    return [one for one in found if one.check == check]


@pytest.mark.parametrize("r_t", [0.0, 1e-4])
def test_rows_may_be_twenty_milliseconds_apart(r_t: float) -> None:
    """And what their times are printed in; the widest gap is told with the row before it."""
    rows = RIDE.rows()
    for wide, passed in ((0.02 + r_t, True), (0.02 + r_t + 3e-10, False), (0.02 + r_t + 1e-6, False)):
        t = rows.t.copy()
        t[31:] += wide - 0.01
        steps = Resolution(r_t, np.full(7, 1e-9), np.full(7, 1e-9))
        (found,) = of_file(judged(Trajectory(rows.names, t, rows.q, rows.qd), steps).findings, "row spacing")
        assert (found.value, found.limit, found.unit) == (pytest.approx(wide, abs=1e-12), tol.LARGEST_GAP, "s")
        assert found.passed == (passed or (wide - 0.02 - r_t < 2e-11))
        assert found.time == pytest.approx(t[30])
    assert "sample the motion at 50 Hz or more" in found.message


@pytest.mark.parametrize("over", [0.99, 1.01])
def test_digits_may_hide_a_tenth_of_a_millimetre(over: float) -> None:
    """What half a step of every axis does at the tool by its column, where that is most; and what steps would do."""
    rows = RIDE.rows()
    J = PLANT.robot.jacobian(PLANT.start[None])[0]
    linear, angular = (np.linalg.norm(part, axis=0).sum() for part in (J[:3], J[3:]))
    step = over * tol.COARSEST_PRINT * 2 / linear
    steps = np.full((len(rows.t), 7), step * 0.9)
    steps[17] = step
    report = judged(rows, Resolution(0.0, steps, np.full(7, 1e-9)))
    found = of_file(report.findings, "printed resolution")
    assert (found[0].value, found[0].limit, found[0].unit) == (pytest.approx(over * 1e-4), tol.COARSEST_PRINT, "m")
    assert (found[0].passed, found[0].time) == (over < 1, pytest.approx(rows.t[17]))
    # the tool's orientation is hidden too where that is more than 1 mrad; every other limit is ten times coarser
    turned = over * 1e-4 * angular / linear
    assert {(one.subject, one.unit) for one in found[1:]} >= (
        {("tool", "rad")} if turned > tol.COARSEST_TURN else set()
    )
    assert angular > 0
    if over > 1:  # a tenth of a millimetre of it is half of what may be open: steps of 2.6e-5 would do
        told = ": printed digits leave the TCP this uncertain; print positions in steps of 1e-05 (SI) or finer"
        assert found[0].message.endswith(told)


@pytest.mark.parametrize("over", [0.99, 1.01])
def test_digits_of_speeds_may_hide_six_percent_of_an_acceleration(over: float) -> None:
    """Rows 10 ms apart: a mean over 32 of them is off by 2 r_v / 0.32 s, half a step at both ends, twice."""
    rows = RIDE.rows()
    a = PLANT.limits.acceleration[3]
    step = over * 0.06 * a * 32 * 0.01 / 2
    r_v = np.full(7, 1e-9)
    r_v[3] = step
    report = judged(rows, Resolution(0.0, np.full(7, 1e-9), r_v))
    found = {one.subject: one for one in of_file(report.findings, "printed resolution") if not one.passed}
    assert (PLANT.limits.names[3] in found) == (over > 1)
    if over > 1:
        one = found[PLANT.limits.names[3]]
        assert (one.value, one.limit) == (pytest.approx(over * 0.06 * a), pytest.approx(0.06 * a))
        assert one.unit == "rad/s2"
        needed = float(one.message.split("in steps of ")[1].split(" ")[0])
        assert step / 20 < needed <= step / 2 * 1.01  # a power of ten that leaves half of what may be hidden


@pytest.mark.parametrize("over", [0.99, 1.01])
def test_digits_of_times_may_hide_three_percent_of_a_speed(over: float) -> None:
    """Without speeds: a mean speed at its limit over 0.32 s, both times off by half a step and granted as much."""
    rows = RIDE.rows()
    v = PLANT.limits.velocity.max()
    r_t = over * 0.03 * 0.32 / 2
    report = judged(Trajectory(rows.names, rows.t, rows.q, None), Resolution(r_t, np.full(7, 1e-12), np.full(7, 1e-12)))
    found = [one for one in of_file(report.findings, "printed resolution") if one.unit == "rad/s" and not one.passed]
    assert (len(found) > 0) == (over > 1)
    assert all("times in steps of 0.001" in one.message for one in found)
    assert v > 0


@pytest.mark.parametrize("speeds", [True, False])
def test_a_bare_grid_says_what_it_leaves_open(speeds: bool) -> None:
    """tau, half a row spacing, before and behind each end of a wait: 4 tau; a stop is a tau^2 / 2 away at most, and its
    speed a tau off, without speeds that of the middle between two rows h apart: a h / 2 more."""
    rows = RIDE.rows(speeds)
    grid = judged(rows).grid
    assert grid is not None
    assert grid.rate == pytest.approx(100.0)
    assert grid.dwell == pytest.approx(0.02, abs=1e-6)
    a = PLANT.tcp.acceleration
    assert grid.stop == pytest.approx(tol.STOP_POSITION + a * 0.005**2 / 2, abs=1e-7)
    assert grid.rest == pytest.approx(tol.REST_LINEAR + a * (0.005 if speeds else 0.01), rel=1e-3)


def test_digits_of_positions_open_speeds_that_are_not_printed() -> None:
    """Two rows h apart, each off by p at the tool, tell a speed to 2 p / h, and a change of it to twice that."""
    p = {step: judged(RIDE.rows(False), Resolution(0.0, np.full(7, step), np.full(7, 0.0))) for step in (1e-7, 3e-5)}
    J = np.linalg.norm(PLANT.robot.jacobian(PLANT.start[None])[0][:3], axis=0).sum()
    fine, coarse = (one.grid for one in p.values())
    assert fine is not None
    assert coarse is not None
    assert coarse.rest - fine.rest == pytest.approx(4 * J * (3e-5 - 1e-7) / 2 / 0.01, rel=0.05)
