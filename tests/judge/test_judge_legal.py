"""Legal motions stay legal however they are written down: rows, digits, speed columns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial

import numpy as np
import pytest
from legal_motion import B_IN, B, Case, bench_case, faster, held_case, hold, rapid_case, stream_case
from legal_runs import line_line

from trajopt_cli.joint_csv import Resolution, header, read_csv_text
from trajopt_cli.judge import samples as rows_module
from trajopt_cli.judge.verify import verify as verify_with_advice
from trajopt_cli.motion import Wait
from trajopt_cli.problem.plan import Target
from trajopt_cli.trajectory import Trajectory

verify = partial(verify_with_advice, advice=False)
CASES = {"rapid": rapid_case, "stream": stream_case, "bench": bench_case, "held": held_case}


def printed(trajectory: Trajectory, decimals: int | None, speeds: bool) -> tuple[Trajectory, Resolution | None]:
    if decimals is None:
        qd = trajectory.qd if speeds else None
        return Trajectory(trajectory.names, trajectory.t, trajectory.q, qd), None
    table = np.hstack([trajectory.t[:, None], trajectory.q, *([trajectory.qd] if speeds else [])])
    row = ",".join([f"%.{decimals}f"] * table.shape[1])
    lines = [",".join(header(trajectory.names, speeds)), *(row % tuple(values) for values in table.tolist())]
    return read_csv_text("\n".join(lines), "printed.csv")


@cache
def made_rows(name: str, grid_only: bool, step: float) -> Trajectory:
    return CASES[name]().rows(grid_only=grid_only, step=step)


@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("decimals", [None, 6])
@pytest.mark.parametrize(
    ("grid_only", "step"), [(False, 0.002), (True, 0.001), (True, 0.004)], ids=["own", "1kHz", "250Hz"]
)
@pytest.mark.parametrize("name", CASES)
def test_a_legal_motion_passes(name: str, grid_only: bool, step: float, decimals: int | None, speeds: bool) -> None:
    """On either target, if legal for both: both targets meet every kind of rows, digits and speeds."""
    case = CASES[name]()
    trajectory, resolution = printed(made_rows(name, grid_only, step), decimals, speeds)
    odd = (name == "held") ^ (step > 0.002) ^ (decimals is None) ^ speeds
    target = Target.RAPID if name in ("rapid", "held") and odd else None
    report = verify(case.program, case.plant, trajectory, resolution, target=target)
    assert report.legal, [f.message for f in report.findings if not f.passed]


@pytest.mark.parametrize("made", [*CASES.values(), line_line])
def test_what_is_left_out_in_a_long_file_is_at_no_point(
    made: Callable[[], Case], monkeypatch: pytest.MonkeyPatch
) -> None:
    case = made()
    rows, found = case.rows(grid_only=True, step=0.004), []
    for block in (2, 7, 10**6):  # of two rows each, and all rows in one: nothing is left out
        monkeypatch.setattr(rows_module, "BLOCK", block)
        found.append(verify(case.program, case.plant, rows))
    assert found[0].legal
    assert found[0] == found[1] == found[2]


@pytest.mark.parametrize("step", [0.003, 0.0043, 0.0071, 0.01])
def test_a_rapid_motion_passes_whatever_its_rows_miss(step: float) -> None:
    """The rail rides through a whole wait: its rest at either end lies between two rows."""
    case = rapid_case()
    report = verify(case.program, case.plant, case.rows(grid_only=True, step=step), target=Target.RAPID)
    assert report.legal, [f.message for f in report.findings if not f.passed]


def without_the_wait(trajectory: Trajectory, first: int, last: int) -> Trajectory:
    keep = np.r_[: first + 1, last : len(trajectory.t)]
    qd = None if trajectory.qd is None else trajectory.qd[keep]
    return Trajectory(trajectory.names, trajectory.t[keep], trajectory.q[keep], qd)


def long_rest(seconds: float) -> tuple[Case, Trajectory, int, int]:
    """The bench's motion with a long wait, and the rows at which that begins and ends."""
    case = bench_case()
    wait = next(k for k, motion in enumerate(case.program.motions) if isinstance(motion, Wait))
    motions = list(case.program.motions)
    motions[wait] = replace(motions[wait], duration=seconds)
    pieces = list(case.pieces)
    pieces[wait] = hold(pieces[wait].at(np.zeros(1))[0][0], seconds)
    case = Case(case.plant, replace(case.program, motions=tuple(motions)), tuple(pieces))
    rows = case.rows()
    first, last = np.searchsorted(rows.t, [case.starts[wait], case.starts[wait] + seconds])
    return case, rows, int(first), int(last)


@pytest.mark.parametrize("grid", [False, True], ids=["own", "250Hz"])
def test_a_rest_needs_two_rows_however_long_it_is(grid: bool) -> None:
    case, rows, first, last = long_rest(1.0)
    if grid:
        rows = case.rows(grid_only=True, step=0.004)
        still = np.flatnonzero(~rows.qd.any(axis=1) & (rows.t > 0.1) & (rows.t < rows.t[-1] - 0.1))
        first, last = int(still[0]), int(still[-1])
    assert rows.t[last] - rows.t[first] > 0.9
    report = verify(case.program, case.plant, without_the_wait(rows, first, last), target=Target.RAPID)
    assert report.legal, [f.message for f in report.findings if not f.passed]


def test_a_rest_between_two_rows_is_one_only_where_both_say_so() -> None:
    case, rows, first, last = long_rest(1.0)
    sparse = without_the_wait(rows, first, last)
    moved, fast = sparse.q.copy(), sparse.qd.copy()
    moved[first + 1, 3] += 1e-9
    fast[first + 1, 3] = 1e-9
    for q, qd in ((sparse.q, None), (moved, sparse.qd), (sparse.q, fast)):
        report = verify(case.program, case.plant, Trajectory(sparse.names, sparse.t, q, qd))
        assert "row spacing" in {f.check for f in report.findings if not f.passed}


def test_a_wait_cut_short_is_seen_between_two_rows_as_well() -> None:
    case, rows, first, last = long_rest(1.0)
    sparse = without_the_wait(rows, first, last)
    t = sparse.t.copy()
    t[first + 1 :] -= 1e-6
    report = verify(case.program, case.plant, Trajectory(sparse.names, t, sparse.q, sparse.qd))
    assert [f.check for f in report.findings if not f.passed] == ["dwell length"]


def test_one_odd_row_makes_no_marked_file() -> None:
    """A recorder's hiccup splits one gap of an even grid; a switch within a gap is still nobody's fault."""
    case = rapid_case()
    grid = case.rows(grid_only=True, step=0.004)
    odd = np.sort(np.append(grid.t, 0.5013))
    fine = case.rows(step=1e-4)
    pick = np.searchsorted(fine.t, odd - 1e-9)
    rows = Trajectory(fine.names, fine.t[pick], fine.q[pick], fine.qd[pick])
    report = verify(case.program, case.plant, rows)
    assert report.legal, [f.message for f in report.findings if not f.passed]


def test_every_promised_check_is_made() -> None:
    case = stream_case()
    made = {f.check for f in verify(case.program, case.plant, case.rows()).findings}
    assert made == {
        "row spacing", "printed resolution", "start", "start rest", "stop rest", "dwell length", "dwell rest",
        "dwell drift", "duration", "rail target", "end rest", "end", "line position", "line rotation", "line progress",
        "arm holds", "joint position", "joint speed", "joint acceleration", "speed columns", "TCP speed",
        "TCP acceleration", "programmed speed", "programmed reorientation",
        "self clearance",
    }  # fmt: skip


def test_a_stream_is_not_a_rapid_motion() -> None:
    case = stream_case()
    report = verify(case.program, case.plant, case.rows(), target=Target.RAPID)
    failed = {f.check for f in report.findings if not f.passed}
    assert {"axes rest", "joint line"} <= failed


def test_values_are_the_motions_own() -> None:
    """rail: 3 m/s2 and the peak of the slowest trapezoid; line: 0.08 m at 6 shares per second, 60 of acceleration."""
    case = rapid_case()
    report = verify(case.program, case.plant, case.rows(step=1e-3))
    found = {(f.check, f.subject, f.source.line if f.source else 0): f for f in report.findings}
    line = found["programmed speed", "TCP", 12]
    assert line.value == pytest.approx(0.48, abs=1e-9)
    assert line.time is not None
    assert 0.1 <= line.time - case.starts[1] <= case.pieces[1].T - 0.1
    rail = next(f for f in report.findings if (f.check, f.subject) == ("joint acceleration", "rail"))
    assert rail.value == pytest.approx(3.0, rel=1e-9)
    assert rail.unit == "m/s2"
    dwell = found["dwell length", "TCP", 13]
    assert (dwell.value, dwell.limit, dwell.unit) == (pytest.approx(0.1, abs=1e-12), 0.1, "s")


def test_values_are_those_of_the_tool_in_force() -> None:
    """The grip's own point runs 0.0707 m at 4 shares per second on the line; the flange, turning, does not."""
    case = bench_case()
    length = float(np.linalg.norm(B_IN[:3, 3] - B[:3, 3]))
    assert case.pieces[1].T > 0.38  # the profile reaches its 4 shares per second
    found = {
        (f.check, f.source.line): f.value
        for f in verify(case.program, case.plant, case.rows()).findings
        if f.source and f.check.startswith("programmed")
    }
    assert found["programmed speed", 12] == pytest.approx(4 * length, rel=1e-6)
    assert found["programmed reorientation", 12] == pytest.approx(4 * 0.4, rel=1e-6)
    assert found["programmed speed", 13] == pytest.approx(0.0, abs=1e-7)
    assert found["programmed reorientation", 13] == pytest.approx(4 * 0.3, rel=1e-6)


def test_a_slow_plan_is_legal() -> None:
    case = rapid_case()
    pieces = list(case.pieces)
    pieces = [faster(piece, 0.7) for piece in pieces[:2]] + [hold(pieces[2].at(np.zeros(1))[0][0], 0.25)] + pieces[3:]
    report = verify(case.program, case.plant, Case(case.plant, case.program, tuple(pieces)).rows(), target=Target.RAPID)
    assert report.legal, [f.message for f in report.findings if not f.passed]


@pytest.mark.parametrize("made", [*CASES.values(), line_line])
@pytest.mark.parametrize("speeds", [True, False])
def test_a_file_that_is_judged_in_pieces_is_judged_as_a_whole(
    made: Callable[[], Case], speeds: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every value of every finding and its time, whatever is at hand of a long file at once."""
    case = made()
    rows = case.rows(step=0.002) if speeds else case.rows(grid_only=True, step=0.004)
    rng = np.random.default_rng(7)
    spoiled = Trajectory(rows.names, rows.t, rows.q + 1e-4 * (rng.random(rows.q.shape) < 0.01), rows.qd)
    for trajectory in (spoiled,) if speeds else (rows, spoiled):
        whole = verify(case.program, case.plant, trajectory, target=Target.RAPID)
        with monkeypatch.context() as small:
            small.setattr(rows_module, "PIECE", 300)
            small.setattr(rows_module, "_KEPT", 2)
            small.setattr(rows_module, "_ROOM", 10**6)
            assert verify(case.program, case.plant, trajectory, target=Target.RAPID) == whole
