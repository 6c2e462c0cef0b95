"""Work in processes beside this one: the two targets of a run, or many tasks taken in turns."""

from __future__ import annotations

import ctypes
import gc
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from contextvars import ContextVar
from multiprocessing.connection import Connection
from types import TracebackType
from typing import Any, Generic, TypeVar

from trajopt_cli.errors import InputError

_DIE_WITH_PARENT = 1  # PR_SET_PDEATHSIG
Answer = TypeVar("Answer")
Name = TypeVar("Name")


def cores() -> int:
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def give_back() -> None:
    """Return to the system, and so to other processes, what memory this one has no more use for: the C library keeps
    most of what a phase with many small arrays leaves, and cycles of objects wait for their number to grow."""
    gc.collect()
    if sys.platform == "linux":
        with suppress(AttributeError):  # of the GNU C library alone
            ctypes.CDLL(None).malloc_trim(0)


class ProcessEnded(RuntimeError):
    """A worker process ended without an answer: by a signal, or by an error it has printed."""

    def __init__(self, code: int | None):
        name = signal.Signals(-code).name if code is not None and code < 0 else f"exit code {code}"
        super().__init__(f"a worker process ended by {name}")


class Worker(Generic[Answer]):
    """work(tell) running in a forked process between `with` and its end; what it tells is heard here.

    Forked, not spawned: nothing is read or built twice. So start it before any thread. work, what it tells and its
    answer must not need this process' later state; told messages and the answer are pickled.
    """

    def __init__(self, work: Callable[[Callable[[Any], None]], Answer], hear: Callable[[Any], None]):
        self._hear = hear
        fork = multiprocessing.get_context("fork")
        self._messages, theirs = fork.Pipe(duplex=False)
        self._process = fork.Process(target=_run, args=(work, theirs, os.getpid()), daemon=True)
        with deaf():  # _run takes it from there
            self._process.start()
        theirs.close()  # only the other process holds that end, so that its death is an end of file here
        self._answer: list[Answer] = []

    def __enter__(self) -> Worker[Answer]:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._process.terminate()
        self._process.join()
        self._messages.close()

    @property
    def done(self) -> bool:
        """Whether the answer is there; what was told so far is heard."""
        self.listen()
        return bool(self._answer)

    def listen(self) -> None:
        """Hear what was told so far, without waiting."""
        while not self._answer and self._messages.poll():
            self._receive()

    def answer(self) -> Answer:
        """Wait for the answer. Raises what work raised if that is an InputError or a MemoryError, ProcessEnded if the
        process broke down."""
        while not self._answer:
            self._receive()
        return self._answer[0]

    def _receive(self) -> None:
        try:
            kind, content = self._messages.recv()
        except EOFError:
            self._process.join()
            raise ProcessEnded(self._process.exitcode) from None
        if kind == "error":
            raise content
        if kind == "answer":
            self._answer.append(content)
        else:
            self._hear(content)


@contextmanager
def deaf() -> Iterator[None]:
    """Threads and processes that come up inside do not hear Ctrl-C, which is this one's to answer."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _run(work: Callable[[Callable[[Any], None]], Any], pipe: Connection, parent: int) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the first process' to answer; it ends this one
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    if sys.platform == "linux":  # elsewhere a process that is left alone ends when it next says something
        ctypes.CDLL(None).prctl(_DIE_WITH_PARENT, signal.SIGKILL)
    if os.getppid() != parent:  # it went before it could be said
        os._exit(1)
    try:
        pipe.send(("answer", work(lambda message: pipe.send(("told", message)))))
    except InputError as error:
        pipe.send(("error", error))
    except MemoryError as error:
        pipe.send(("error", MemoryError(str(error))))


def in_turns(
    tasks: Mapping[Name, Callable[[Callable[[Any], None]], Answer]],
    hear: Callable[[Any], None],
    jobs: int | None = None,
) -> dict[Name, Answer]:
    """Every task's answer under its name, in the tasks' order; processes take the next task as they come free.

    jobs: how many processes, this one among them; by default one for every core. A task is given what it may tell; that
    is heard here. With one process all is done in this one. What a task leaves behind besides its answer may be lost:
    it is done in any process.
    """
    names = list(tasks)
    max_workers = min(jobs or cores(), len(names))
    if max_workers < 2:
        return {name: task(hear) for name, task in tasks.items()}
    taken = multiprocessing.get_context("fork").Value("i", 0)

    def work(tell: Callable[[Any], None]) -> dict[int, Answer]:
        done: dict[int, Answer] = {}
        while True:
            with taken.get_lock():
                i = taken.value
                taken.value = i + 1
            if i >= len(names):
                return done
            done[i] = tasks[names[i]](tell)

    with ExitStack() as stack:
        others = [stack.enter_context(Worker(work, hear)) for _ in range(max_workers - 1)]

        def hear_all(message: Any) -> None:
            hear(message)
            for other in others:
                other.listen()

        done = work(hear_all)
        for other in others:
            done |= other.answer()
    return {name: done[i] for i, name in enumerate(names)}


Tasks = Mapping[Any, Callable[[Callable[[Any], None]], Any]]
Elsewhere = Callable[[Tasks, Callable[[Any], None]], dict[Any, Any]]
"""Gives every task's answer under its name, in the tasks' order, as in_turns does; tasks and answers are pickled."""

_ELSEWHERE: ContextVar[Elsewhere | None] = ContextVar("elsewhere", default=None)


@contextmanager
def handed_to(elsewhere: Elsewhere) -> Iterator[None]:
    """What is shared out inside is done elsewhere: on a cluster."""
    before = _ELSEWHERE.set(elsewhere)
    try:
        yield
    finally:
        _ELSEWHERE.reset(before)


def shared_out(
    tasks: Mapping[Name, Callable[[Callable[[Any], None]], Answer]],
    hear: Callable[[Any], None],
    jobs: int | None = None,
) -> dict[Name, Answer]:
    """As in_turns; where handed_to says so, elsewhere. For independent questions of a study, each of which plans."""
    elsewhere = _ELSEWHERE.get()
    return in_turns(tasks, hear, jobs) if elsewhere is None else elsewhere(tasks, hear)
