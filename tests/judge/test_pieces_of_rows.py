"""Rows that are worked out in pieces, looked at in windows and left out in blocks; and what kind of file rows make."""

from __future__ import annotations

import numpy as np
import pytest
from legal_motion import plant_with_rail
from tcp_motion import forward_acceleration

from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import samples as module
from trajopt_cli.judge.findings import Columns, Series, Worst, axis_unit, digits, finding, worse
from trajopt_cli.judge.samples import Along, Blocks, Boxes, Pieces, judged_rows, windows
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(92)


@pytest.mark.parametrize("per", [1, 4])
def test_pieces_are_the_whole(per: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Any part of them, however it is asked for; what was looked at last is at hand, and no more than a few."""
    monkeypatch.setattr(module, "PIECE", 8)
    n = 8 * per * 9 + 3
    values, asked = np.random.default_rng(91).normal(size=(n, 3)), []

    def make(a: int, b: int) -> tuple[Array, ...]:
        asked.append((a, b))
        return values[a:b, 0], values[a:b]

    pieces = Pieces(n, make, per)
    one, table = Along(pieces), Along(pieces, 1)
    np.testing.assert_array_equal(one[:], values[:, 0])
    assert [b - a for a, b in asked] == [8 * per] * 9 + [3]
    assert len(pieces._kept) == module._KEPT
    asked.clear()
    table[n - 1]
    table[n - 8 * per : n]
    assert asked == []
    rng = np.random.default_rng(92)
    for a, b in rng.integers(0, n + 4, (300, 2)):
        np.testing.assert_array_equal(one[a:b], values[a:b, 0])
        np.testing.assert_array_equal(table[a:b], values[a:b])
        np.testing.assert_array_equal(table[a:], values[a:])
        np.testing.assert_array_equal(table[a:b, 1], values[a:b, 1])
        np.testing.assert_array_equal(table[a:b, :2], values[a:b, :2])
    for i in range(n):
        assert one[i] == values[i, 0]
        assert table[i, 2] == values[i, 2]
    asked.clear()
    whole = pieces.whole()
    np.testing.assert_array_equal(whole[1], values)
    assert len(asked) == 10
    pieces = Pieces(n, make, per)
    asked.clear()
    for i in (0, 1, 2, 3, 4, 0, 5, 0):  # the first is looked at again and again: another one goes
        Along(pieces)[i * 8 * per]
    assert [a // (8 * per) for a, _ in asked] == [0, 1, 2, 3, 4, 5]
    monkeypatch.setattr(module, "_ROOM", 3 * 8 * per * 4 * 8)  # three pieces
    dear = Pieces(n, make, per, dear=True)
    asked.clear()
    for _ in range(2):  # all rows over and over: the first three stay, of the others each has gone when it is wanted
        np.testing.assert_array_equal(Along(dear, 1)[:], values)
    assert [a // (8 * per) for a, _ in asked] == [*range(10), *range(3, 10)]


@pytest.mark.parametrize("n", [1, 5, 64, 65, 70, 71, 100, 200])
def test_windows_share_rows(n: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """All rows, no window longer than a piece and what is shared, and any that are so near are in one of them."""
    monkeypatch.setattr(module, "PIECE", 10)
    first = 7
    found = list(windows(first, first + n))
    assert found[0][0] == first
    assert found[-1][1] == first + n
    assert all(b - a <= 10 + module.OVERLAP for a, b in found)
    assert [a for a, _ in found] == [first + 10 * k for k in range(len(found))]
    assert len(found) == max(-(-(n - module.OVERLAP) // 10), 1)
    for i in range(first, first + n):
        k = min(i + module.OVERLAP, first + n)
        assert any(a <= i and k <= b for a, b in found)


def test_blocks() -> None:
    rng = np.random.default_rng(93)
    n = 2 * module.BLOCK + 7
    blocks, x = Blocks(n), rng.normal(size=(n, 2))
    parts = [slice(0, module.BLOCK), slice(module.BLOCK, 2 * module.BLOCK), slice(2 * module.BLOCK, n)]
    np.testing.assert_array_equal(blocks.most(x), [x[part].max(axis=0) for part in parts])
    boxes = blocks.boxes(x, np.array([0.1, 0.2, 0.3]))
    np.testing.assert_array_equal(boxes.low, [x[part].min(axis=0) for part in parts])
    np.testing.assert_array_equal(boxes.high, [x[part].max(axis=0) for part in parts])
    np.testing.assert_array_equal(blocks.rows(np.array([0, 2])), [*range(module.BLOCK), *range(2 * module.BLOCK, n)])
    B = module.BLOCK
    assert blocks.inside(3, 3 * B + 5) == slice(1, 3)
    assert blocks.inside(B, 2 * B) == slice(2, 2)
    corner = Boxes(np.zeros((2, 2)), np.ones((2, 2)), np.array([0.0, 1.0]))
    np.testing.assert_allclose(corner.off(np.array([4.0, -4.0])), 5.0)
    np.testing.assert_allclose(corner.off(np.array([0.5, 1.5])), 0.5)
    for P, size, wanted in (([0.5, 1.5], 0.5, [0, 1]), ([0.5, 1.5], 0.49, [1]), ([0.5, 2.5], 0.49, [])):
        assert corner.near(np.array(P), size).tolist() == wanted
    assert corner.near(np.array([0.5, 2.0])).tolist() == [1]


def file(t: Array, q: Array | None = None, qd: Array | None = None) -> Trajectory:
    still = np.tile(PLANT.start, (len(t), 1))
    return Trajectory(PLANT.limits.names, t, still if q is None else q, qd)


def test_steps_are_never_finer_than_numbers_are() -> None:
    """Positions and speeds to 1e-12, times to four units in the last place of the latest."""
    t = 1000.0 + np.arange(5) * 0.01
    rows = judged_rows(PLANT, file(t), None)
    assert (rows.doubt_q == 1e-12).all()
    assert (rows.doubt_v == 1e-12).all()
    np.testing.assert_allclose(rows.step_t, 4 * np.finfo(float).eps * t[-1], rtol=1e-12)
    assert rows.doubt_tables is None
    steps = Resolution(np.array([1e-3, 0, 0, 0, 2e-3]), np.r_[1e-6, np.full(6, 1e-15)], np.full(7, 1e-5), None)
    rows = judged_rows(PLANT, file(t), steps)
    assert rows.doubt_q[3].tolist() == [1e-6] + [1e-12] * 6
    assert rows.doubt_v[2].tolist() == [1e-5] * 7
    assert rows.step_t[[0, 4]].tolist() == [1e-3, 2e-3]
    assert rows.doubt_t == 2e-3
    assert rows.step_t[2] == pytest.approx(4 * np.finfo(float).eps * t[-1])


def test_gaps_of_a_standstill_are_no_longer_than_others() -> None:
    """Where the speeds of both rows are zero and the positions the same, to 1e-12; without speeds nobody says so."""
    t = np.cumsum([0.0, 0.01, 0.012, 0.5, 0.014, 0.7, 0.01])
    q, qd = np.tile(PLANT.start, (7, 1)), np.zeros((7, 7))
    q[:, 2] += [0.0, 0.001, 0.002, 0.002, 0.004, 0.004, 0.005]
    qd[:, 2] = [0.0, 0.1, 0.0, 0.0, 0.2, 0.2, 0.0]
    median = np.median([0.01, 0.012, 0.014, 0.7, 0.01])
    np.testing.assert_allclose(judged_rows(PLANT, file(t, q, qd), None).gaps, [0.01, 0.012, median, 0.014, 0.7, 0.01])
    np.testing.assert_allclose(judged_rows(PLANT, file(t, q), None).gaps, np.diff(t))
    for way, speed, still in ((0.9e-12, 0.0, True), (2e-12, 0.0, False), (0.0, 1.9e-12, True), (0.0, 2.1e-12, False)):
        moved, fast = q.copy(), qd.copy()
        moved[3:, 5] += way
        fast[3, 5] = speed
        assert (judged_rows(PLANT, file(t, moved, fast), None).gaps[2] < 0.1) == still
    at_rest = judged_rows(PLANT, file(t, None, np.zeros((7, 7))), None)
    assert at_rest.gaps.tolist() == [0.0] * 6
    short = judged_rows(PLANT, file(np.cumsum([0.0, 0.02, 0.001]), None, np.zeros((3, 7))), None)
    assert short.gaps.tolist() == [0.0, 0.0]


@pytest.mark.parametrize("doubt", [0.0, 1e-5])
def test_a_marked_file_is_a_grid_with_rows_in_it(doubt: float) -> None:
    """At least two fifths of the inner gaps are whole, as many shorter ones as there are marks; rows may be shifted by
    2e-5 s and what times are printed in. The first and the last gap do not count."""

    def marked(inner: list[float], marks: int = 1, ends: float = 0.5) -> bool:
        t = np.cumsum([0.0, ends, *inner, ends])
        steps = Resolution(doubt, np.full(7, 1e-9), np.zeros(7))
        return judged_rows(PLANT, file(t), steps, marks).marked

    g, near = 0.01, 2e-5 + 2 * doubt
    assert not marked([g] * 10)
    assert marked([g] * 8 + [0.004, 0.006])
    assert marked([g] * 8 + [0.004, 0.006], 2)
    assert not marked([g] * 8 + [0.004, 0.006], 3)
    assert marked([g] * 8 + [0.004, 0.006], 0)
    assert not marked([g] * 10, 0)
    assert marked([g] * 4 + [0.004] * 6)
    assert not marked([g] * 3 + [0.004] * 5)
    assert marked([g] * 8 + [g - near - 1e-7])
    assert not marked([g] * 8 + [g - near + 1e-7])
    assert not marked([g] * 3 + [g - near + 1e-7] + [0.004] * 7)
    assert marked([g] * 3 + [g - near + 1e-7] + [0.004] * 6)
    assert not marked([])
    assert judged_rows(PLANT, file(np.arange(2) * 0.01), None).marked is False


@pytest.mark.parametrize("doubt", [0.0, 1e-6])
def test_a_grid_is_known_under_many_more_rows(rng: np.random.Generator, doubt: float) -> None:
    """Our densest files have three rows in four beside the grid; that of another rate, or a log, is none of them."""
    grid = np.arange(2000) * 1e-3
    faster = np.round(0.5 + np.arange(4000) * 2.5e-4, 9)
    files = {
        "boundaries": (np.r_[grid, rng.uniform(0, 2, 6000)], True),
        "a rest": (np.r_[grid[:800], grid[1500:], rng.uniform(0, 0.8, 2400), rng.uniform(1.5, 2, 1500)], True),
        "two rates": (np.r_[grid, faster], False),
        "two rates that sway": (np.r_[grid, faster] + rng.uniform(-1e-6, 1e-6, 6000), False),
        "a log": (np.cumsum(rng.uniform(2e-4, 1e-3, 6000)), False),
        "holes": (np.r_[np.delete(grid, rng.integers(1, 1999, 300)), rng.uniform(0, 2, 6000)], False),
    }  # fmt: skip
    for name, (times, marked) in files.items():
        t = np.unique(np.round(times, 9))
        t = t[np.r_[True, np.diff(t) > 1e-5]]
        q = np.tile(PLANT.start, (len(t), 1)) + 0.01 * np.sin(t)[:, None]
        qd = np.tile(0.01 * np.cos(t)[:, None], q.shape[1])
        if name == "a rest":
            still = (t >= 0.799) & (t <= 1.5)
            q[still], qd[still] = q[np.argmax(still)], 0.0
        steps = Resolution(doubt, np.zeros(q.shape[1]), np.zeros(q.shape[1]))
        rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd), steps, marks=20)
        assert rows.marked == marked, name


def test_turning_is_the_acceleration_of_speeds_alone() -> None:
    rng = np.random.default_rng(94)
    q, qd = PLANT.start + rng.uniform(-1, 1, (30, 7)), rng.normal(size=(30, 7))
    rows = judged_rows(PLANT, file(np.arange(30) * 0.01, q, qd), None)
    wanted = forward_acceleration(PLANT.robot, q, qd, np.zeros_like(qd))
    np.testing.assert_allclose(rows.turning[:], wanted, atol=1e-9)
    inner = rows.hermite_places
    X, V, A = rows.hermite_motion
    np.testing.assert_allclose(X[5:9], PLANT.robot.forward(inner[1][5:9]), atol=1e-9)
    np.testing.assert_allclose(V[:], (PLANT.robot.jacobian(inner[1][:]) @ inner[2][:][..., None])[..., 0], atol=1e-8)
    np.testing.assert_allclose(A[:], forward_acceleration(PLANT.robot, *(one[:] for one in inner[1:])), atol=1e-6)


# --- findings ----------------------------------------------------------------------------------------------------


def test_the_worst_of_several_series_is_the_first_greatest() -> None:
    """However they are cut; one at a limit of zero is worse than all, if it has any value."""
    t = np.arange(10.0)
    values = [np.array([1.0, 5, 2, 5, 1, 1, 1, 1, 1, 0]), np.array([0.0, 1, 2, 3, 4, 5, 6, 7, 8, 8]), np.full(10, 8.0)]
    for cut in (1, 3, 10):
        series = Series(2.0)
        for a in range(0, 10, cut):
            series.add((t[a : a + cut], x[a : a + cut]) for x in values)
        series.add([(t[:0], t[:0])] * 3)
        assert series.found == [Worst(5.0, 2.0, 1.0), Worst(8.0, 2.0, 8.0), Worst(8.0, 2.0, 0.0)]
        assert series.worst == Worst(8.0, 2.0, 8.0)
    late = Series(2.0)
    late.add([(t, values[2])], begin=1)
    late.add([(t, values[1])], begin=0)
    assert [one.time for one in late.found] == [8.0, 0.0]
    assert worse(None, Worst(0.0, 1.0, 0.0)) == Worst(0.0, 1.0, 0.0)
    assert worse(Worst(1.0, 2.0, 0.0), Worst(1.1, 2.0, 1.0)).time == 1.0
    assert worse(Worst(1.0, 2.0, 0.0), Worst(1.0, 2.0, 1.0)).time == 0.0
    assert worse(Worst(9.0, 2.0, 0.0), Worst(1e-9, 0.0, 1.0)).time == 1.0
    assert worse(Worst(1e-9, 2.0, 0.0), Worst(0.0, 0.0, 1.0)).time == 0.0


def test_columns_are_series_side_by_side(rng: np.random.Generator) -> None:
    """What a series of its own says of every column, however the rows are cut; of no values nothing."""
    limits, t = np.array([2.0, 0.5, 1.0]), np.arange(12.0)
    tables = [rng.integers(-3, 4, (12, 3)).astype(np.float64) for _ in range(4)]
    for cut in (1, 3, 5, 12):
        columns, each = Columns(limits), [Series(float(limit)) for limit in limits]
        columns.add([(t[:1], tables[0][:1])], begin=2.5)
        for j, series in enumerate(each):
            series.add([(t[:1], tables[0][:1, j])], begin=2.5)
        for a in range(0, 12, cut):
            part = slice(a, a + cut)
            columns.add((t[part], table[part]) for table in tables)
            for j, series in enumerate(each):
                series.add((t[part], table[part, j]) for table in tables)
        columns.add([(t[:0], tables[0][:0])])
        assert [columns.worst(j) for j in range(3)] == [series.worst for series in each]
    assert Columns(limits).worst(1) == Worst(0.0, 0.5, 0.0)


def test_values_are_printed_with_the_digits_that_tell_them_apart() -> None:
    assert digits(1.0, 2.0) == ("1", "2")
    assert digits(1.00001, 1.0) == ("1.00001", "1")
    assert digits(3.0000031, 3.0) == ("3.000003", "3")
    assert digits(0.5, 0.5) == ("0.5", "0.5")
    assert digits(1.0 + 2e-15, 1.0) == ("1.000000000000002", "1")
    assert (axis_unit("rail"), axis_unit("joint_1")) == ("m", "rad")
    told = finding("check", "TCP", 1.23456, 1.0, "m", False, time=0.12345, bound="at most", note=" here", words="is")
    assert told.message == "TCP is 1.235 m at t = 0.123 s, at most 1 here"
    assert finding("check", "TCP", 2.0, 1.0, "m", False).message == "TCP check 2 m, limit 1"
    assert finding("check", "TCP", 0.5, 1.0, "m", True, time=1.0).message == ""
