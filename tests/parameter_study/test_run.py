"""Studies that go wrong on the way end in the same bytes as one that does not: nothing lost, nothing twice."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path

import pytest
from distributed import Client
from pyarrow import parquet
from tiny import STUDY, at_once, greedy, in_a_moment, killed_once, written

from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.cluster import Evaluate, client_at
from trajopt_cli.parameter_study.point import evaluate
from trajopt_cli.parameter_study.results import POINTS, new_or_same
from trajopt_cli.parameter_study.run import run_study
from trajopt_cli.parameter_study.study_file import Study, read_study


@pytest.fixture
def study(tmp_path: Path) -> Study:
    return read_study(written(tmp_path))


def undisturbed(study: Study, folder: Path, work: Evaluate = at_once) -> bytes:
    """The file of all rows, made one after the other in this process."""
    results = new_or_same(folder, study)
    results.write_part([work(study.inputs, study.design.point(i)) for i in range(len(study.design))], [])
    results.finish()
    return (folder / POINTS).read_bytes()


def test_a_cluster_gives_the_bytes_that_this_process_gives(study: Study, client: Client, tmp_path: Path) -> None:
    _, tally = run_study(study, tmp_path / "out", client, work=at_once)
    assert tally.counts == {"ok": 120}
    assert tally.best == (at_once(study.inputs, study.design.point(11))["rapid_s"], 11)  # sin(11) is the least of them
    assert (tmp_path / "out" / POINTS).read_bytes() == undisturbed(study, tmp_path / "alone")


@pytest.mark.long
def test_a_worker_that_is_killed_costs_nothing(study: Study, client: Client, tmp_path: Path) -> None:
    inputs = replace(study.inputs, price=str(tmp_path / "mark"))
    study = replace(study, inputs=inputs)
    run_study(study, tmp_path / "out", client, work=killed_once)
    assert (tmp_path / "mark").exists()
    assert (tmp_path / "out" / POINTS).read_bytes() == undisturbed(study, tmp_path / "alone")


@pytest.mark.long
def test_a_point_that_takes_all_memory_or_raises_is_a_row_with_its_reason(
    study: Study, client: Client, tmp_path: Path
) -> None:
    results, tally = run_study(study, tmp_path / "out", client, work=greedy)
    rows = results.rows().to_pylist()
    assert tally.counts == {"ok": 118, "memory": 1, "failed": 1}
    assert "process was ended" in rows[50]["reason"]
    assert "ZeroDivisionError: an error of ours" in rows[70]["reason"]
    assert rows[50]["limits.joint_1.velocity_rad_per_s"] == study.design.point(50).values[0]
    expected = [at_once(study.inputs, study.design.point(i)) for i in range(120)]
    assert [row for i, row in enumerate(rows) if i not in (50, 70)] == [
        row for i, row in enumerate(expected) if i not in (50, 70)
    ]


def test_a_study_that_was_interrupted_goes_on(study: Study, client: Client, tmp_path: Path) -> None:
    """Stopped twice, with what had come back written."""
    counts = []

    def stop(*_: object) -> None:
        if len(counts) < 2:
            counts.append(1)
            raise KeyboardInterrupt

    for _ in range(2):
        with pytest.raises(KeyboardInterrupt):
            run_study(study, tmp_path / "out", client, stop, in_a_moment)
        assert not (tmp_path / "out" / POINTS).exists()
    assert len([*(tmp_path / "out" / "parts").iterdir()]) == 2
    run_study(study, tmp_path / "out", client, work=in_a_moment)
    assert (tmp_path / "out" / POINTS).read_bytes() == undisturbed(study, tmp_path / "alone")
    for part in (tmp_path / "out" / "parts").iterdir():
        inside = parquet.read_table(part)["point"].to_pylist()
        assert inside == sorted(inside)
    points = [
        row["point"]
        for part in (tmp_path / "out" / "timings").iterdir()
        for row in parquet.read_table(part).to_pylist()
    ]
    assert sorted(points) == [*range(120)]


def test_inputs_that_changed_are_refused_by_name(study: Study, tmp_path: Path) -> None:
    new_or_same(tmp_path / "out", study)
    new_or_same(tmp_path / "out", study)
    (tmp_path / "tiny.mod").write_text((tmp_path / "tiny.mod").read_text().replace("vmax", "v100"))
    with pytest.raises(InputError, match=r"other inputs: tiny\.mod changed since"):
        new_or_same(tmp_path / "out", read_study(tmp_path / "study.yaml"))
    written(tmp_path, STUDY.replace("40", "41"))
    with pytest.raises(InputError, match="the study file changed since"):
        new_or_same(tmp_path / "out", read_study(tmp_path / "study.yaml"))
    with pytest.raises(InputError, match="something else"):
        new_or_same(tmp_path, study)
    (tmp_path / "out" / "parts").mkdir()
    (tmp_path / "out" / "parts" / "part-000000.parquet").write_bytes(b"PAR1")
    with pytest.raises(InputError, match="cannot be read"):
        new_or_same(tmp_path / "out", study).known()


HERE = Path(__file__).parent


@contextmanager
def cluster(port: int) -> Iterator[None]:
    """A scheduler and a worker, processes of their own, killed at the end."""
    paths = os.pathsep.join([str(HERE.parents[1]), str(HERE)])
    host = ["--host", "127.0.0.1", "--no-dashboard"]
    ours = [["distributed.cli.dask_scheduler", "--port", str(port), *host]]
    ours += [["distributed.cli.dask_worker", f"tcp://127.0.0.1:{port}", "--nthreads", "1", "--no-nanny"]]
    quiet, knowing = subprocess.DEVNULL, {**os.environ, "PYTHONPATH": paths}
    with ExitStack() as stack:
        both = [
            stack.enter_context(subprocess.Popen([sys.executable, "-m", *one], stdout=quiet, stderr=quiet, env=knowing))
            for one in ours
        ]
        try:
            yield
        finally:
            for process in both:
                process.kill()


@pytest.mark.long
def test_a_scheduler_may_go_and_come_back(study: Study, tmp_path: Path) -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    first, second = cluster(port), cluster(port)
    said = []

    def listen(_: str, progress: object) -> None:
        said.append(str(progress))
        if len(said) == 2:  # with most rows still to come
            first.__exit__(None, None, None)
            second.__enter__()

    first.__enter__()
    try:
        with client_at(f"tcp://127.0.0.1:{port}") as client:
            run_study(study, tmp_path / "out", client, listen, in_a_moment)
    finally:
        second.__exit__(None, None, None)
    assert any("is gone; waiting for it" in one for one in said)
    assert (tmp_path / "out" / POINTS).read_bytes() == undisturbed(study, tmp_path / "alone")


@pytest.mark.long
def test_ctrl_c_ends_the_command_and_the_same_command_goes_on(study: Study, client: Client, tmp_path: Path) -> None:
    """True points of two moves; the signal goes to all processes of the command, as a terminal's does."""
    command = [sys.executable, "-m", "trajopt_cli.cli", "study", "run", "study.yaml", "--jobs", "1", "--output", "out"]
    with subprocess.Popen(
        command, cwd=tmp_path, start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        while not [*(tmp_path / "out" / "parts").glob("*.parquet")] and process.poll() is None:
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 130, said
    assert "Traceback" not in said
    before = new_or_same(tmp_path / "out", study).known().sum()
    assert 0 < before < 120
    _, tally = run_study(study, tmp_path / "out", client)
    assert tally.before == before
    assert (tmp_path / "out" / POINTS).read_bytes() == undisturbed(study, tmp_path / "alone", evaluate)


def test_the_manuals_example_runs_on_a_client_of_ones_own(
    study: Study, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """On two moves, three points, and threads of this process."""
    example = (HERE.parents[1] / "docs/studies.md").read_text().split("```python\n")[1].split("```")[0]
    example = example.replace("programs/studies/which_rail.yaml", "study.yaml")
    example = example.replace("n_workers=2,", "processes=False, n_workers=1, dashboard_address=None,")
    written(tmp_path, STUDY.replace("{range: [0.5, 1.5], count: 40}", "[1]"))
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(example, names)
    assert "Counter({'ok': 3}) fastest" in capsys.readouterr().out
    once = read_study(tmp_path / "study.yaml")
    assert names["rows"] == [evaluate(once.inputs, once.design.point(i)) for i in range(3)]
