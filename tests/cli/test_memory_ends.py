"""Too little memory, from the start or in the middle: one line and exit code 2."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from trajopt_cli import cli
from trajopt_cli.cli.process import out_of_memory
from trajopt_cli.workers import ProcessEnded, Worker

ROOT = Path(__file__).parents[2]
linux = pytest.mark.skipif(sys.platform != "linux", reason="ulimit -v, /proc")


def limited(kilobytes: int, *arguments: str) -> subprocess.CompletedProcess[str]:
    """A command that may have so much address space; 60 s of processor time end what goes round and round."""

    def limits() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (1024 * kilobytes,) * 2)
        resource.setrlimit(resource.RLIMIT_CPU, (60, 60))

    command = [sys.executable, "-m", "trajopt_cli.cli", *arguments]
    return subprocess.run(command, cwd=ROOT, preexec_fn=limits, capture_output=True, text=True, check=False)


@linux
@pytest.mark.parametrize("kilobytes", [100_000, 250_000, 300_000])
def test_too_little_room_is_one_line(kilobytes: int, tmp_path: Path) -> None:
    ended = limited(kilobytes, "optimize", "programs/bench_irb140.mod", "--quiet", "--output", str(tmp_path / "r"))
    assert ended.returncode == 2
    assert ended.stdout == ""
    assert ended.stderr.count("\n") == 1
    assert ended.stderr.startswith(f"out of memory: the process may have {1024 * kilobytes // 10**6} MB (ulimit -v); ")
    assert list(tmp_path.iterdir()) == []


@linux
def test_what_needs_little_room_has_it() -> None:
    assert limited(330_000, "parse", "programs/bench_irb140.mod").returncode == 0


@pytest.mark.parametrize(
    "error",
    [
        MemoryError("Unable to allocate 165. MiB"),
        RuntimeError("std::bad_alloc"),
        RuntimeError("can't start new thread"),
        ImportError("libassimp.so.6: failed to map segment from shared object"),
        OSError(12, "Cannot allocate memory"),
        SystemError("error return without exception set"),
    ],
)
def test_the_end_of_memory_in_the_middle_is_one_line(
    error: Exception, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def ends(*_: object, **__: object) -> int:
        raise error

    monkeypatch.setattr(cli, "_commands", lambda: ends)
    monkeypatch.setattr(cli, "_give_up_stdout", lambda: None)
    assert cli.run(["parse", "a.mod"]) == 2
    said = capsys.readouterr().err
    assert said.startswith("out of memory: ")
    assert said.count("\n") == 1


def test_other_errors_are_not_called_so(monkeypatch: pytest.MonkeyPatch) -> None:
    assert out_of_memory(RuntimeError("an error of ours")) is None

    def ends(*_: object, **__: object) -> int:
        raise RuntimeError("an error of ours")

    monkeypatch.setattr(cli, "_commands", lambda: ends)
    with pytest.raises(RuntimeError, match="an error of ours"):
        cli.run(["parse", "a.mod"])


def test_memory_that_ends_beside_is_told_here() -> None:
    def work(tell: object) -> int:
        raise MemoryError("of 3 GB")

    with Worker(work, print) as beside, pytest.raises(MemoryError, match="of 3 GB"):
        beside.answer()


def test_a_process_that_the_system_ends_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def work(tell: object) -> int:
        os.kill(os.getpid(), signal.SIGKILL)
        return 0

    def ends(*_: object, **__: object) -> int:
        with Worker(work, print) as beside:
            return beside.answer()

    monkeypatch.setattr(cli, "_commands", lambda: ends)
    assert cli.run(["parse", "a.mod"]) == 2
    assert capsys.readouterr().err.startswith("a worker process ended by SIGKILL; where memory is short, ")
    assert issubclass(ProcessEnded, RuntimeError)
