"""A bound on what work in this thread may take of the processor and of memory, where no signal can come."""

from __future__ import annotations

import ctypes
from threading import Event, Lock, Thread, get_ident
from time import clock_gettime, pthread_getcpuclockid
from types import TracebackType

_LOOK = 0.05  # s between two looks
_AGAIN = 20  # looks between two attempts: a library may take the exception for its own


class OutOfTime(BaseException):
    """The work took longer than it may."""


class OutOfMemory(BaseException):
    """The process took more memory than it may."""


class Guard:
    """Raises OutOfTime or OutOfMemory in the thread that enters it, once it takes more than it may.

    seconds: of the thread's own processor time, so that a busy computer changes nothing. memory: of the whole process
    [bytes]. None: no bound. A library call is ended when it comes back to Python.
    """

    def __init__(self, seconds: float | None, memory: float | None):
        self._bounds, self._thread = (seconds, memory), get_ident()
        self._clock = pthread_getcpuclockid(self._thread)
        self._start, self._over, self._lock = clock_gettime(self._clock), Event(), Lock()
        self._watcher = Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Guard:
        if self._bounds != (None, None):
            self._watcher.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.end()

    def end(self) -> None:
        """Raise nothing any more; may be called again."""
        with self._lock:
            self._over.set()
            _raise(self._thread, None)

    def _watch(self) -> None:
        looks = 0
        while not self._over.wait(_LOOK):
            why = self._exceeded()
            if why is not None and looks % _AGAIN == 0:
                with self._lock:
                    if not self._over.is_set():
                        _raise(self._thread, why)
            looks += why is not None

    def _exceeded(self) -> type[BaseException] | None:
        seconds, memory = self._bounds
        if seconds is not None and clock_gettime(self._clock) - self._start > seconds:
            return OutOfTime
        return OutOfMemory if memory is not None and _resident() > memory else None


def _resident() -> float:
    """Memory of this process [bytes]."""
    import psutil  # comes with dask.distributed

    return float(psutil.Process().memory_info().rss)


def _raise(thread: int, what: type[BaseException] | None) -> None:
    """Raise in a thread, when it next runs Python; None: take back what was not raised yet."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), None if what is None else ctypes.py_object(what))
