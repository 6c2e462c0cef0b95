"""The second process: what it tells arrives in order, and however it ends, this one knows and goes on."""

from __future__ import annotations

import gc
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.workers import Worker, give_back

Tell = Callable[[int], None]


def test_messages_and_answer_arrive_in_order() -> None:
    heard: list[int] = []

    def work(tell: Tell) -> int:
        for i in range(5):
            tell(i)
        return os.getpid()

    with Worker(work, heard.append) as beside:
        assert beside.answer() != os.getpid()
    assert heard == [0, 1, 2, 3, 4]


def test_listening_does_not_wait() -> None:
    def work(tell: Tell) -> int:
        time.sleep(60)
        return 0

    start = time.perf_counter()
    with Worker(work, print) as beside:
        beside.listen()
    assert time.perf_counter() - start < 10


def test_an_input_error_comes_back_with_its_place() -> None:
    def work(tell: Tell) -> int:
        raise InputError("no such target", file="a.mod", line=3, column=5)

    with Worker(work, print) as beside, pytest.raises(InputError, match=r"^a\.mod:3:5: no such target$"):
        beside.answer()


def test_a_process_that_dies_is_noticed() -> None:
    def work(tell: Tell) -> int:
        os._exit(7)

    with (
        Worker(work, print) as beside,
        pytest.raises(RuntimeError, match=r"^a worker process ended by exit code 7$"),
    ):
        beside.answer()


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_what_is_in_no_use_any_more_goes_back_to_the_system() -> None:
    def resident() -> float:
        return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6

    cycle: list[object] = [bytearray(2000) for _ in range(30_000)]  # 60 MB in pieces
    top = bytearray(2000)  # above them
    cycle.append(cycle)
    gc.disable()
    try:
        del cycle
        before = resident()
        give_back()
    finally:
        gc.enable()
    assert resident() < before - 50
    assert len(top) == 2000
