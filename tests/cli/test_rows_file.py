"""The rows of a plan in files without a name: what comes back, in which process, and what a full disk says."""

from __future__ import annotations

import resource
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.runs.files import write_folder
from trajopt_cli.runs.record import sha256
from trajopt_cli.runs.rows import RowsFile, without_rows
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.workers import Worker

NAMES = ("rail", "joint_1", "joint_2")


def a_plan(n: int, speeds: bool = True, seed: int = 7) -> Plan:
    rng = np.random.default_rng(seed)
    t = np.cumsum(rng.uniform(1e-3, 1.0, n))
    qd = rng.normal(size=(n, 3)) if speeds else None
    return Plan(Target.STREAM, Trajectory(NAMES, t, rng.normal(size=(n, 3)), qd), (), None, "")


def same(one: Trajectory, other: Trajectory) -> bool:
    if (one.qd is None) != (other.qd is None):
        return False
    pairs = [(one.t, other.t), (one.q, other.q)] + ([] if one.qd is None else [(one.qd, other.qd)])
    return one.names == other.names and all(np.array_equal(a, b) for a, b in pairs)


@pytest.mark.parametrize("speeds", [True, False])
def test_rows_come_back_bit_for_bit_and_the_last_written_alone(speeds: bool, tmp_path: Path) -> None:
    kept = RowsFile(tmp_path / "not" / "there")
    for n in (9000, 20):
        plan = a_plan(n, speeds)
        assert same(kept.keep(plan).trajectory, plan.trajectory)
        assert same(kept.kept(without_rows(plan)).trajectory, plan.trajectory)
        kept.text.seek(0)
        assert kept.text.read() == write_csv_text(plan.trajectory)
        assert without_rows(plan).duration == plan.duration
    assert not [*tmp_path.iterdir()]


def test_they_go_without_a_word_and_rows_that_were_read_stay(tmp_path: Path) -> None:
    """Python warns of files that nobody has closed, where it is asked to."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        plan = RowsFile(tmp_path).keep(a_plan(50))
    assert [str(one.message) for one in said] == []
    assert same(plan.trajectory, a_plan(50).trajectory)


def test_another_process_writes_them_and_this_one_reads_them(tmp_path: Path) -> None:
    kept, plan = RowsFile(tmp_path / "results"), a_plan(50)
    with Worker(lambda _: without_rows(kept.keep(plan)), lambda _: None) as beside:
        told = beside.answer()
    assert len(told.trajectory.t) == 2
    assert same(kept.kept(told).trajectory, plan.trajectory)


def test_a_folder_takes_them_under_several_names(tmp_path: Path) -> None:
    kept, plan = RowsFile(tmp_path / "results"), a_plan(50)
    kept.keep(plan)
    text = write_csv_text(plan.trajectory).encode()
    assert sha256(kept.content) == sha256(text)
    write_folder(tmp_path / "results", {"a.csv": kept.content, "b/a.csv": kept.content, "c": b"c"})
    assert (tmp_path / "results" / "a.csv").read_bytes() == (tmp_path / "results" / "b" / "a.csv").read_bytes() == text


def test_a_place_that_takes_no_files_is_said_in_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # Python would leave half of what it compiles under the limit
    kept, before = RowsFile(tmp_path / "results"), resource.getrlimit(resource.RLIMIT_FSIZE)
    with pytest.raises(InputError, match="cannot write"):
        RowsFile(Path("/proc/self/nothing"))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, before[1]))
    try:
        with pytest.raises(InputError, match="cannot write: File too large"):
            kept.keep(a_plan(50))
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
