"""Points worked out on a Dask cluster: this computer's own, one at an address, or one that somebody has a Client of."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from itertools import islice
from multiprocessing import resource_tracker
from typing import Any

import dask
from distributed import Client, Future, KilledWorker, LocalCluster, WorkerPlugin, as_completed, get_worker, wait
from distributed.comm import CommClosedError

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.point import PointInputs, Row, blank, evaluate
from trajopt_cli.parameter_study.sampling import Point
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.workers import Tasks, cores, deaf, give_back, in_turns

Evaluate = Callable[[PointInputs, Point], Row]
Say = Callable[[str], None]

TASK_SECONDS = 2.0
"""What a task should take at least, so that scheduler and worker take next to nothing of it."""
TASKS_A_SECOND = 100.0
"""Tasks that a scheduler should be given at most. Measured: 240 with 64 workers, its own process theirs, too."""
MOST_POINTS = 500
"""Points of a task at most, so that what one worker loses is worked out again soon."""
AHEAD = 3
"""Tasks in flight for each thread of the cluster: one at work, one behind it, one on its way."""
BACK_WITHIN = 600.0
"""s that a scheduler may be gone."""
_LOOK = 5.0  # s between two looks at how many threads there are
_LISTEN = 0.5  # s between two looks at whether tasks are to go on
_TRY = 1.0  # s between two attempts to reach a scheduler
_GIVE_BACK = 60.0  # s: looking for garbage takes 0.07 s in a process that plans
_LOST = (CancelledError, CommClosedError, TimeoutError, OSError)

_LOCAL = {
    "distributed.scheduler.allowed-failures": 0,  # points of a worker that died are tried one by one
    "distributed.worker.profile.enabled": False,  # it looks at a worker's stack a hundred times a second
    # looks of every process at itself: so they take 1.5 % of a core in all with two workers, by default 5.7 %
    "distributed.admin.tick.interval": "500 ms",
    "distributed.admin.system-monitor.interval": "2 s",
    "distributed.worker.memory.monitor-interval": "500 ms",
}
_given = [0.0]  # when this process last gave memory back
_KNOWN: dict[str, PointInputs] = {}  # what the points of this worker's studies follow from, by digest


@dataclass(frozen=True)
class Done:
    """Points that are worked out: their rows; of each its number, what it took [s of processor] and which worker did
    it; what all took there by the clock [s]."""

    rows: Sequence[Row]
    timings: Sequence[tuple[int, float, str]]
    elapsed: float


class _Unknown(RuntimeError):
    """A worker has not heard of a study's inputs: it came up with a new scheduler."""


class _Inputs(WorkerPlugin):  # type: ignore[misc]  # Dask is not looked into
    """Brings a study's inputs to every worker, those that come later too."""

    def __init__(self, inputs: PointInputs):
        self.inputs, self.name = inputs, f"trajopt-study-{inputs.digest}"

    def setup(self, worker: object) -> None:
        """Called on every worker when it comes up."""
        _KNOWN[self.inputs.digest] = self.inputs

    def teardown(self, worker: object) -> None:
        """Called when the study is done."""
        _KNOWN.pop(self.inputs.digest, None)


def _work(digest: str, evaluate: Evaluate, points: Sequence[Point]) -> Done:
    """A task: some points, one after the other. Runs on a worker."""
    inputs = _KNOWN.get(digest)
    if inputs is None:
        raise _Unknown
    rows, timings, begin, worker = [], [], time.monotonic(), str(get_worker().name)
    for point in points:
        start = time.thread_time()
        rows.append(evaluate(inputs, point))
        timings.append((point.index, time.thread_time() - start, worker))
    if time.monotonic() - _given[0] > _GIVE_BACK:
        give_back()
        _given[0] = time.monotonic()
    return Done(rows, timings, time.monotonic() - begin)


def _version() -> str:
    return __version__


def _check_versions(client: Client) -> None:
    """Raise InputError where the workers have another trajopt than this one, or none."""
    try:
        versions = client.run(_version)
    except ImportError as error:
        raise InputError("the cluster's workers lack trajopt: pip install 'trajopt-cli[study]' there") from error
    if other := {*versions.values()} - {__version__}:
        raise InputError(f"the cluster's workers have trajopt {', '.join(other)}, this is {__version__}")


@contextmanager
def local_client(jobs: int | None = None, memory: float | None = None) -> Iterator[Client]:
    """A client of a cluster on this computer, a process for each of jobs, by default one for every core. memory: of
    each process at most [bytes]; None: its share of what there is."""
    limit = "auto" if memory is None else int(memory * 1.2)  # a point's own bound comes first, and in words
    how = {"threads_per_worker": 1, "memory_limit": limit, "dashboard_address": ":0", "silence_logs": 50}
    resource_tracker.ensure_running()  # it hears Ctrl-C again where it is started by the way
    with dask.config.set(_LOCAL), deaf():
        cluster = LocalCluster(n_workers=jobs or cores(), **how)
    with cluster, Client(cluster, set_as_default=False) as client:
        yield client


@contextmanager
def client_at(address: str) -> Iterator[Client]:
    """A client of the scheduler at an address. Raises InputError where there is none."""
    try:
        client = Client(address, set_as_default=False, timeout=10)
    except (OSError, ValueError) as error:
        raise InputError(f"--scheduler {address}: {error}") from error
    with client:
        yield client


def tasks_at(address: str, patience: Patience, tasks: Tasks, hear: Callable[[Any], None]) -> dict[Any, Any]:
    """The answers of a study's tasks by the cluster at an address, as workers.in_turns gives them. What a task tells is
    heard when it is done. What is left when patience is interrupted is asked here, where it ends at once. Connected for
    one call: processes are forked between two of them, which threads of a client would not survive. Raises InputError
    where the cluster cannot be used, and what a task raises."""
    done: dict[Any, Any] = {}
    with client_at(address) as client, client.as_current():
        _check_versions(client)
        running = {client.submit(_task, task, pure=False): name for name, task in tasks.items()}
        while running and not patience.interrupted:
            with suppress(TimeoutError):
                for future in wait([*running], timeout=_LISTEN, return_when="FIRST_COMPLETED").done:
                    told, done[running.pop(future)] = future.result()
                    for message in told:
                        hear(message)
        client.cancel([*running], force=True)
    done |= in_turns({name: task for name, task in tasks.items() if name not in done}, hear, 1)
    return {name: done[name] for name in tasks}


def _task(task: Callable[[Callable[[Any], None]], Any]) -> tuple[list[Any], Any]:
    """What a task tells, and its answer. Runs on a worker."""
    told = list[Any]()
    answer = task(told.append)
    give_back()
    return told, answer


@dataclass(eq=False)
class Pool:
    """Works points out on a client's cluster. work: what makes a row of a point. say: hears what goes wrong and on.

    When a scheduler gives a task up because its worker died, its points are tried again one by one; one whose worker
    dies then, too, is a row that says so, as is one that raises an error. When the scheduler is lost, all that had not
    come back is given to the one that comes back at its address.
    """

    client: Client
    inputs: PointInputs
    work: Evaluate = evaluate
    say: Say = lambda _: None
    _waiting: deque[tuple[Point, ...]] = field(default_factory=deque)
    _suspects: deque[Point] = field(default_factory=deque)
    _on_trial: Point | None = None
    _running: dict[Future, tuple[Point, ...]] = field(default_factory=dict)
    _mean: float = TASK_SECONDS  # s of a point, the later ones counting more
    _threads: int = 0
    _looked: float = 0.0
    _own: bool = False  # whether the client was made here, in place of one that was lost

    def done(self, points: Iterable[Point]) -> Iterator[Done]:
        """The points' rows as they come; points are taken when there is a worker for them."""
        source = iter(points)
        try:
            self._introduce()
            while True:
                try:
                    yield from self._until_lost(source)
                    return
                except _LOST:
                    self._come_back()
        finally:
            with suppress(*_LOST):
                self.client.cancel([*self._running], force=True)
                self.client.unregister_worker_plugin(f"trajopt-study-{self.inputs.digest}")
            if self._own:
                self.client.close()

    def _until_lost(self, source: Iterator[Point]) -> Iterator[Done]:
        """Rows until all are there. Raises one of _LOST where the scheduler is gone."""
        coming = as_completed(loop=self.client.loop)
        self._fill(source, coming)
        while self._running:
            future = next(coming)
            points = self._running.pop(future)
            if future.status == "finished":
                found: Done = future.result()
                spent = found.elapsed / len(points)
                self._mean = spent if self._mean == TASK_SECONDS else (3 * self._mean + spent) / 4
                yield found
            elif future.status == "error":
                error = future.exception()
                if isinstance(error, _Unknown):
                    self._waiting.append(points)
                    self._introduce()
                elif isinstance(error, KilledWorker) and points[0] is not self._on_trial:
                    self._suspects.extend(points)
                elif len(points) > 1:
                    self._waiting.extend((point,) for point in points)
                else:
                    yield self._failed(points[0], error)
            else:
                self._waiting.append(points)
                raise CancelledError
            future.release()
            self._fill(source, coming)

    def _fill(self, source: Iterator[Point], coming: as_completed) -> None:
        """Give the cluster as much as it has room for: points that were with a worker that died each by itself, and
        behind all others, so that nobody else is blamed."""
        if time.monotonic() - self._looked > _LOOK or not self._threads:
            self._threads, self._looked = sum(self.client.nthreads().values()) or 1, time.monotonic()
        while len(self._running) < AHEAD * self._threads:
            points = self._waiting.popleft() if self._waiting else tuple(islice(source, self._size()))
            if not points:
                break
            self._submit(points, coming)
        if not self._running and self._suspects:
            self._on_trial = self._suspects.popleft()
            self._submit((self._on_trial,), coming)

    def _size(self) -> int:
        """Points of a task."""
        wanted = max(TASK_SECONDS, self._threads / TASKS_A_SECOND)
        return max(1, min(MOST_POINTS, int(wanted / max(self._mean, 1e-6))))

    def _submit(self, points: tuple[Point, ...], coming: as_completed) -> None:
        future = self.client.submit(_work, self.inputs.digest, self.work, points, pure=False)
        self._running[future] = points
        coming.add(future)

    def _failed(self, point: Point, error: BaseException | None) -> Done:
        status, said = "memory", "its worker's process was ended each time, as where memory runs out"
        if not isinstance(error, KilledWorker):
            what = " ".join(f"{type(error).__name__}: {error}".split())
            status, said = "failed", f"an error in trajopt, please report it: {what}"
        return Done([blank(self.inputs, point, status, said)], [(point.index, 0.0, "")], 0.0)

    def _introduce(self) -> None:
        """Bring the inputs to the workers. Raises InputError where these have another trajopt, or none."""
        _check_versions(self.client)
        self.client.register_plugin(_Inputs(self.inputs))

    def _come_back(self) -> None:
        """Reach the scheduler again, or the one that took its place. Raises InputError after BACK_WITHIN."""
        self._waiting.extend(self._running.values())
        self._running.clear()
        address, until = self.client.scheduler.address, time.monotonic() + BACK_WITHIN
        self.say(f"the scheduler at {address} is gone; waiting for it")
        if self._own:
            self.client.close()
        while True:
            try:
                self.client = Client(address, set_as_default=False, timeout=10)
                self._own, self._threads = True, 0
                self._introduce()
                return
            except _LOST as error:
                if time.monotonic() > until:
                    said = f"the scheduler at {address} did not come back within {BACK_WITHIN:.0f} s"
                    raise InputError(f"{said}; the same command goes on from what is written") from error
                time.sleep(_TRY)
