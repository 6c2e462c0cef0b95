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


def judged(rows: Trajectory, steps: Resolution | None = None, promises: bool = False) -> Report:
    return verify(ASKED, PLANT, rows, steps, advice=False, promises=promises)


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
    report = judged(rows, Resolution(0.0, steps, np.full(7, 1e-9)), promises=True)
    found = of_file(report.findings, "printed resolution")
    assert (found[0].value, found[0].limit, found[0].unit) == (pytest.approx(over * 1e-4), tol.COARSEST_PRINT, "m")
    assert (found[0].passed, found[0].time) == (over < 1, pytest.approx(rows.t[17]))
    promised = [one for one in report.promises if one.most is not None and one.least > one.most and one.needs]
    promised = [one for one in promised if not one.check.startswith("path")]
    promised = [one for one in promised if (one.check, one.subject) != ("stop reached", "TCP")]
    told = [(one.subject, one.value, one.limit, one.unit, one.passed) for one in found[1:]]
    assert told == [(one.subject, one.least, one.most, one.unit, False) for one in promised]
    assert angular > 0
    if over > 1:  # a tenth of a millimetre of it is half of what may be open: steps of 2.6e-5 would do
        told = ": printed digits leave the TCP this uncertain; print positions in steps of 1e-05 (SI) or finer"
        assert found[0].message.endswith(told)


def test_what_digits_hide_of_speeds_is_told_one_by_one() -> None:
    """Steps of a hundredth of a radian in a second: each axis whose acceleration may be off by more than a
    motion that is 3 % too fast, as the promises have it."""
    rows = RIDE.rows()
    steps = Resolution(0.0, np.full(7, 1e-7), np.r_[1e-7, np.full(6, 0.2)])
    report = judged(rows, steps, promises=True)
    coarse = of_file(report.findings, "printed resolution")[1:]
    wanted = [one for one in report.promises if one.needs and one.most is not None and one.least > one.most]
    wanted = [one for one in wanted if not one.check.startswith("path")]
    assert [(f.subject, f.value, f.limit) for f in coarse] == [(one.subject, one.least, one.most) for one in wanted]
    assert {one.check for one in wanted} >= {"joint acceleration", "TCP acceleration"}
    for one, promise in zip(coarse, wanted, strict=True):
        needs = " and ".join(f"{name} in steps of {step:g}" for name, step in promise.needs)
        assert f"{promise.subject} may be off unseen by" in one.message
        assert f" of {promise.check}: print {needs} (SI) or finer" in one.message
    assert not report.legal


def test_promises_are_told_where_they_are_asked_for() -> None:
    rows = RIDE.rows()
    assert judged(rows).promises == ()
    assert len(judged(rows, promises=True).promises) > 20
    assert judged(rows).rate == pytest.approx(100.0)
