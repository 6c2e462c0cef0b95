"""What place, order, sensitivity and compare share out, on a cluster's processes."""

from __future__ import annotations

import os
import pickle
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from distributed import Client

from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.cluster import tasks_at
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.workers import handed_to, shared_out

NAMES = (3, 1, 2)


def _squares(own: int) -> dict[int, Callable[[Callable[[Any], None]], tuple[int, int]]]:
    """Tasks that tell their name and answer with its square and the process that found it."""

    def task(name: int, tell: Callable[[Any], None]) -> tuple[int, int]:
        tell(name)
        return name**2 + own, os.getpid()

    return {name: partial(task, name) for name in NAMES}


def test_answers_come_from_other_processes_in_the_tasks_order(client: Client) -> None:
    told = list[int]()
    with handed_to(partial(tasks_at, client.scheduler.address, Patience())):
        found = shared_out(_squares(10), told.append)
    assert [(name, answer) for name, (answer, _) in found.items()] == [(name, name**2 + 10) for name in NAMES]
    assert os.getpid() not in {process for _, process in found.values()}
    assert sorted(told) == sorted(NAMES)
    assert {process for _, process in shared_out(_squares(0), told.append, 1).values()} == {os.getpid()}


def test_what_a_task_raises_is_raised_here(client: Client) -> None:
    def task(tell: Callable[[Any], None]) -> None:
        raise InputError("no such place", file="cell.yaml", line=3)

    with pytest.raises(InputError) as said:
        tasks_at(client.scheduler.address, Patience(), {"one": task}, lambda _: None)
    assert (said.value.file, said.value.line) == ("cell.yaml", 3)


def test_after_an_interruption_what_is_left_is_asked_here(client: Client) -> None:
    patience = Patience()
    patience.interrupt()
    found = tasks_at(client.scheduler.address, patience, _squares(0), lambda _: None)
    assert {process for _, process in found.values()} == {os.getpid()}
    assert [*found] == [*NAMES]


def test_patience_keeps_what_is_left_on_a_computer_whose_clock_differs() -> None:
    now = [100.0]
    patience = Patience(20.0, lambda: now[0])
    patience.settle()
    now[0] += 15.0
    there = pickle.loads(pickle.dumps(patience))
    assert there.limit == 5.0
    assert there.settled
    assert not there.over
    assert pickle.loads(pickle.dumps(Patience())).limit is None
