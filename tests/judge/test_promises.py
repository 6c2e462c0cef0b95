"""What the judge says that it is sure to see it sees; files that are too coarse for a check are told so."""

from __future__ import annotations

import json

import numpy as np
import pytest
from legal_motion import Case, faster, plant_with_rail, rapid_case
from legal_random import random_case, written
from offences import OFFENCES, RATES

from trajopt_cli.cli.tables import promises_table, reports_record, verdict
from trajopt_cli.findings import Report
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.trajectory import Trajectory


def judged(case: Case, step: float, spell: str, speeds: bool = False, times: str | None = None) -> Report:
    text = written(case.rows(step=step, grid_only=True), spell, speeds, times)
    trajectory, resolution = read_csv_text(text, "a.csv")
    return verify(case.program, case.plant, trajectory, resolution, advice=False, promises=True)


@pytest.mark.parametrize("name", OFFENCES)
def test_an_offence_a_hundredth_beyond_what_is_promised_is_found(name: str) -> None:
    """Some of those of benchmarks/bench_promises.py."""
    tried = 0
    for seed in range(40):
        outcome = OFFENCES[name](np.random.default_rng(seed), 1.01)
        if outcome is not None:
            assert outcome.found, (seed, outcome.excess, outcome.promise, [f.message for f in outcome.failed])
            tried += 1
        if tried == 3:
            return
    raise AssertionError(f"{tried} offences were made")


@pytest.mark.parametrize("name", ["joint position", "joint speed", "stop reached, m", "dwell length", "clearance"])
def test_a_hundredth_of_what_is_promised_is_not_always_found(name: str) -> None:
    """A promise that said too much would pass the test above as well: an offence this small is within the grant."""
    outcomes = (OFFENCES[name](np.random.default_rng(seed), 0.01) for seed in range(8))
    assert any(not outcome.found for outcome in outcomes if outcome is not None)


@pytest.mark.parametrize("spell", ["%.9g", "%.6g", "%.5g"])
@pytest.mark.parametrize("step", RATES)
def test_a_legal_motion_in_few_digits_is_legal(spell: str, step: float) -> None:
    """Six significant digits are what C++ streams write. More of them: benchmarks/bench_coarse_files.py."""
    for seed in (0, 3):
        report = judged(random_case(seed), step, spell)
        assert report.legal, [f.message for f in report.findings if not f.passed]


def test_a_wrist_in_steps_of_a_tenth_is_too_coarse() -> None:
    """joint_6 turns the tool about itself: its position does not show that."""
    case = rapid_case()
    rows = case.rows(step=0.004, grid_only=True)
    lines = written(rows, "%.9g", False).split("\n")
    for i, line in enumerate(lines[1:-1], start=1):
        lines[i] = ",".join([*line.split(",")[:-1], f"{float(line.split(',')[-1]):.1f}"])
    trajectory, resolution = read_csv_text("\n".join(lines), "a.csv")
    report = verify(case.program, case.plant, trajectory, resolution, advice=False)
    assert report.too_coarse
    told = [f.message for f in report.findings if not f.passed]
    assert any("rad, limit" in one and "print positions in steps of 0.0001 (SI) or finer" in one for one in told), told


def test_times_in_steps_of_a_hundredth_are_too_coarse_for_a_motion_five_per_cent_too_fast() -> None:
    case = rapid_case()
    fast = Case(case.plant, case.program, tuple(faster(piece, 1.05) for piece in case.pieces))
    for one in (case, fast):
        report = judged(one, 0.015, "%.9g", times="%.2f")
        assert not report.legal
        told = [f.message for f in report.findings if not f.passed and f.check == "printed resolution"]
        assert any("times in steps of 0.001 " in line for line in told), told


@pytest.mark.parametrize(("seed", "step"), [(9, 0.012), (29, 0.012), (59, 0.012), (19, 0.015), (49, 0.015)])
@pytest.mark.parametrize("speeds", [False, True])
def test_a_legal_motion_whose_times_are_rounded_is_never_illegal(seed: int, step: float, speeds: bool) -> None:
    """Gaps of 12 and 15 ms are printed as 10 or 20: a boundary is as far from a row as the longest of them says."""
    report = judged(random_case(seed), step, "%.9g", speeds, times="%.2f")
    assert report.legal or report.too_coarse, [f.message for f in report.findings if not f.passed]


def test_a_rounded_value_next_to_a_fine_one_is_granted_its_own_digits() -> None:
    """One row with all digits, as the start is copied from a cell file, leaves the others what they are."""
    case = rapid_case()
    lines = written(case.rows(step=0.004, grid_only=True), "%.6f", False).split("\n")
    start = ",".join(f"{x:.17g}" for x in case.plant.start)
    lines[1] = f"0,{start}"
    trajectory, resolution = read_csv_text("\n".join(lines), "a.csv")
    report = verify(case.program, case.plant, trajectory, resolution, advice=False)
    assert report.legal, [f.message for f in report.findings if not f.passed]


def test_the_verdict_says_what_a_bare_grid_leaves_open() -> None:
    """Nearly two gaps of a rest may be missing: 8 ms at 250 Hz; the nearest row to a stop is half a gap away."""
    case = random_case(3)
    report = judged(case, 0.004, "%.17g", speeds=True)
    assert report.rate == pytest.approx(250)
    line = verdict("a.csv", report)
    told = "dwell known to 8 ms, stops to 0.041 mm and 0.04 m/s"
    assert line == f"a.csv: legal at 250 Hz: {told} ({len(report.findings)} checks)"
    a = case.plant.tcp.acceleration
    told = {(one.check, one.unit): one for one in report.promises}
    assert told["stop reached", "m"].least == pytest.approx(1e-6 + a * 0.002**2 / 2, rel=1e-6)
    assert told["dwell length", "s"].least == pytest.approx(0.008, abs=1e-8)
    own = verify(case.program, case.plant, case.rows(), advice=False, promises=True)
    assert own.rate is None
    assert verdict("a.csv", own) == f"a.csv: legal ({len(own.findings)} checks)"
    assert {one.check: one.least for one in own.promises}["dwell length"] < 2e-9


@pytest.mark.parametrize("lost", [(40,), (40, 90, 91)])
def test_a_file_that_lost_rows_is_judged_by_its_gaps_and_says_where(lost: tuple[int, ...]) -> None:
    """Times in steps of 4 ms stay exact: the gap is one of 8 or 12 ms, and nothing else is open."""
    case = random_case(3)
    lines = written(case.rows(step=0.004, grid_only=True), "%.17g", False, "%.4f").split("\n")
    rows = len(lines) - 2
    text = "\n".join(line for i, line in enumerate(lines) if i - 1 not in lost)
    trajectory, resolution = read_csv_text(text, "a.csv")
    report = verify(case.program, case.plant, trajectory, resolution, advice=False, promises=True)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    assert "t = 0.156 and 0.164 s" in report.missing
    assert report.missing.startswith(f"{len(lost)} of {rows} ")
    assert verdict("a.csv", report).endswith(report.missing)
    dwell = {one.check: one.least for one in report.promises}["dwell length"]
    assert dwell >= 0.008 + 0.004 * (len(lost) - 1) * (1 - 1e-9)


def test_so_many_lost_rows_that_a_stop_may_hide_in_the_gap_are_too_coarse() -> None:
    case = random_case(3)
    lines = written(case.rows(step=0.004, grid_only=True), "%.17g", False, "%.4f").split("\n")
    trajectory, resolution = read_csv_text("\n".join(lines[:41] + lines[47:]), "a.csv")
    report = verify(case.program, case.plant, trajectory, resolution, advice=False)
    assert report.too_coarse
    (failed,) = [f for f in report.findings if not f.passed]
    assert (failed.check, failed.time, failed.value) == ("row spacing", pytest.approx(0.156), pytest.approx(0.028))
    assert report.missing in failed.message


def test_columns_in_another_order_are_the_same_motion() -> None:
    case = random_case(3)
    lines = written(case.rows(step=0.01, grid_only=True), "%.9g", True).splitlines()
    n = len(case.plant.limits.names)
    order = [*range(n, 0, -1), 0, *range(2 * n, n, -1)]  # the last axis first, and the time behind the positions
    other = "\n".join(",".join(line.split(",")[i] for i in order) for line in lines)
    plain, turned = (judge(case.plant, case.program, text, "a.csv", advice=False) for text in ("\n".join(lines), other))
    assert plain.legal
    assert turned.findings == plain.findings


def test_promises_are_in_the_table_and_in_json() -> None:
    report = judged(random_case(3), 0.004, "%.6g")
    record = json.loads(json.dumps(reports_record({"a.csv": report}, ())))["files"]["a.csv"]
    assert (record["too_coarse"], record["rows_per_second"]) == (False, pytest.approx(250))
    assert [one["check"] for one in record["promises"]] == [one.check for one in report.promises]
    assert promises_table("a.csv", report).row_count == len(report.promises)
    assert {one.check for one in report.promises} >= {
        "joint position", "joint speed", "joint acceleration", "TCP speed", "TCP acceleration", "path deviation",
        "path rotation", "stop reached", "stop rest", "rail target", "way while held", "dwell length", "duration",
        "clearance", "programmed reorientation",
    }  # fmt: skip


def test_a_file_of_few_rows_is_no_coarse_one() -> None:
    """Lags that it has no rows for are no fault of its digits."""
    case = rapid_case()
    rows = case.rows(step=0.004, grid_only=True)
    short = Trajectory(rows.names, rows.t[:3], rows.q[:3], None)
    report = verify(case.program, case.plant, short, advice=False)
    assert not any(f.check == "printed resolution" for f in report.findings if not f.passed)


def test_levers_reach_at_least_as_far_as_the_robot() -> None:
    """The way that a body's points go when one axis turns, against the lever that the judge grants."""
    from trajopt_cli.judge.mechanism import mechanism_of
    from trajopt_cli.judge.promises import levers

    plant = plant_with_rail()
    reach = levers(plant, mechanism_of(plant), ())
    rng = np.random.default_rng(0)
    q = np.c_[np.zeros(200), rng.uniform(-2, 2, (200, 6))]
    J = plant.robot.jacobian(q)[:, :3]
    assert (np.linalg.norm(J, axis=1) <= np.array(reach) + 1e-9).all()
