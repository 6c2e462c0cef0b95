"""Tasks taken in turns by two processes."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.workers import cores, in_turns


def test_answers_come_under_their_names_in_order_and_all_that_is_told_is_heard() -> None:
    heard: list[str] = []

    def task(i: int):  # type: ignore[no-untyped-def]
        def work(tell):  # type: ignore[no-untyped-def]
            tell(f"begin {i}")
            time.sleep(0.02 * (3 - i % 3))
            return i * i, os.getpid()

        return work

    answers = in_turns({f"task {i}": task(i) for i in range(7)}, heard.append)
    assert list(answers) == [f"task {i}" for i in range(7)]
    assert [answer[0] for answer in answers.values()] == [i * i for i in range(7)]
    assert sorted(heard) == [f"begin {i}" for i in range(7)]
    if cores() > 1:
        assert len({process for _, process in answers.values()}) == 2


@pytest.mark.parametrize("bad", range(4))
def test_an_input_error_of_any_task_comes_back(bad: int) -> None:
    def task(i: int):  # type: ignore[no-untyped-def]
        def work(tell):  # type: ignore[no-untyped-def]
            if i == bad:
                raise InputError(f"task {i}")
            time.sleep(0.01)
            return i

        return work

    with pytest.raises(InputError, match=f"task {bad}"):
        in_turns({i: task(i) for i in range(4)}, lambda _: None)


@pytest.mark.parametrize("jobs", [1, 2, 3])
def test_as_many_processes_work_as_are_asked_for(jobs: int) -> None:
    def task(i: int):  # type: ignore[no-untyped-def]
        def work(tell):  # type: ignore[no-untyped-def]
            time.sleep(0.1)
            return i, os.getpid()

        return work

    answers = in_turns({i: task(i) for i in range(6)}, lambda _: None, jobs)
    assert [answer[0] for answer in answers.values()] == list(range(6))
    assert len({process for _, process in answers.values()}) == jobs


ORPHAN = """
import os, signal, sys, time
from trajopt_cli.workers import Worker

def work(tell):
    tell(os.getpid())
    while True:
        pass

def hear(pid):
    os.write(1, f"{pid}\\n".encode())
    os.kill(os.getpid(), signal.SIGKILL)

with Worker(work, hear) as beside:
    beside.answer()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere it ends at its next word")
def test_a_process_ends_with_the_one_that_started_it() -> None:
    """However busy it is: that one is killed, and can tell it nothing."""
    done = subprocess.run([sys.executable, "-c", ORPHAN], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == -signal.SIGKILL
    other = Path(f"/proc/{int(done.stdout)}/stat")
    for _ in range(100):
        if not other.exists() or other.read_text().rsplit(")", 1)[1].split()[0] == "Z":
            return
        time.sleep(0.05)
    os.kill(int(done.stdout), signal.SIGKILL)
    pytest.fail("it outlived the other")
