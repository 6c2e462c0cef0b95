"""Motions that rest for hours: rows that carry their times are two for a rest, all others are written in parts."""

from __future__ import annotations

import tracemalloc
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.joint import MOST_ROWS, resample
from trajopt_cli.exporters.ros2 import accelerations
from trajopt_cli.joint_csv import csv_parts
from trajopt_cli.runs.files import write_file
from trajopt_cli.trajectory import Trajectory

DAY = 86_400.0


def motion(rest: float, before: float = 1.0) -> Trajectory:
    """One axis by 1 rad in `before` s, a rest, and back again."""
    t = np.array([0.0, before, before + rest, 2 * before + rest])
    q = np.array([[0.0], [1.0], [1.0], [0.0]])
    return Trajectory(("joint_1",), t, q, np.zeros_like(q))


@pytest.mark.parametrize("rest", [0.5, 3600.0, DAY])
@pytest.mark.parametrize("before", [1.0, 1.2345])
def test_a_rest_is_two_rows_and_everything_else_stays(rest: float, before: float) -> None:
    given = motion(rest, before)
    found = resample(given, 100.0, rests=False)
    k = found.t * 100.0
    np.testing.assert_allclose(k[:-1], np.rint(k[:-1]), atol=1e-6)
    gap = np.flatnonzero(np.diff(found.t) > 0.015)
    assert len(gap) == 1
    assert found.t[gap[0]] - before < 0.01 + 1e-9
    assert before + rest - found.t[gap[0] + 1] < 0.01 + 1e-9
    for row in (gap[0], gap[0] + 1):
        assert found.q[row, 0] == 1.0
        assert found.qd is not None
        assert found.qd[row, 0] == 0.0
    assert len(found.t) <= 200 * before + 6
    if rest < 10:
        every = resample(given, 100.0)
        same = np.isin(every.t, found.t)
        assert set(found.t) <= set(every.t)
        np.testing.assert_array_equal(every.q[same], found.q)
        assert np.abs(accelerations(found)).max() <= np.abs(accelerations(every)).max() + 1e-9


def test_a_motion_without_rest_has_all_its_rows() -> None:
    t = np.linspace(0.0, 2.0, 21)
    given = Trajectory(("joint_1",), t, np.sin(t)[:, None], np.cos(t)[:, None])
    np.testing.assert_array_equal(resample(given, 100.0, rests=False).t, resample(given, 100.0).t)


def test_a_day_at_a_fixed_rate_is_refused_with_its_rows() -> None:
    with pytest.raises(InputError, match=rf"are 86402000 rows, at most {MOST_ROWS}: give a rate of 57.8 Hz or less"):
        resample(motion(DAY), 1000.0)
    with pytest.raises(InputError, match="rows, at most"):
        resample(motion(1.0, before=DAY), 1000.0, rests=False)


def test_a_file_in_parts_is_never_in_memory_as_a_whole(tmp_path: Path) -> None:
    size, count = 1 << 16, 200

    def parts() -> Iterator[bytes]:
        for i in range(count):
            yield bytes([i]) * size

    tracemalloc.start()
    write_file(tmp_path / "a.bin", parts())
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10 * size
    assert (tmp_path / "a.bin").read_bytes() == b"".join(parts())


def test_what_breaks_off_in_the_middle_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_bytes(b"old")

    def parts() -> Iterator[bytes]:
        yield b"new"
        raise MemoryError

    with pytest.raises(MemoryError):
        write_file(path, parts())
    assert path.read_bytes() == b"old"
    assert [one.name for one in tmp_path.iterdir()] == ["a.csv"]


def test_many_rows_are_worked_out_in_parts() -> None:
    given = motion(200.0)
    tracemalloc.start()
    found = resample(given, 1000.0)
    kept, peak = tracemalloc.get_traced_memory()
    assert found.qd is not None
    assert kept >= found.q.nbytes + found.qd.nbytes + found.t.nbytes
    tracemalloc.stop()
    assert peak < 200_000 * 8 * 3 + 100_000 * 8 * 30
    assert sum(text.count("\n") for text in csv_parts(found)) == len(found.t) + 1
