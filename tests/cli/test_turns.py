"""Tasks taken in turns by two processes."""

from __future__ import annotations

import os
import time

import pytest

from trajopt_cli.beside import cores, in_turns
from trajopt_cli.errors import InputError


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
