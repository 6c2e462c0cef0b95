"""Progress on stderr: one line that lives where there is a terminal, a line per phase where there is none."""

from __future__ import annotations

import signal
from time import monotonic
from types import FrameType, TracebackType

from rich.live import Live
from rich.text import Text

from trajopt_cli.cli.console import stderr
from trajopt_cli.problem.patience import Patience
from trajopt_cli.problem.progress import Progress

_ABREAST = 2  # plans under way at once: one for each process
_AGAIN = 0.5  # s; long against the tidying up that an interrupt sets off
_TICK = 1.0  # s between looks at the clock


class ProgressView:
    """Shows what it is told between `with` and its end, and keeps Ctrl-C from being lost there.

    CasADi takes a KeyboardInterrupt inside a solver for a request to stop that solver, and the caller goes on with what
    it got. So an interrupt is remembered and raised again until it is through: every half second, and when the next
    progress is told.

    Where there is patience and an answer at hand, the first interrupt ends only the search for a better one.

    A terminal sees how long each phase has been running: some take minutes and have nothing to tell.
    """

    def __init__(self, patience: Patience | None = None) -> None:
        self._interrupted, self._patience = False, patience
        self._console = stderr()
        # without a thread that draws: other processes are forked while it is up, and no timer with them
        self._line = Live(console=self._console, auto_refresh=False, transient=True)
        self._latest: dict[str, tuple[Progress, float]] = {}  # what was said last by label, and since when it is so
        self._drawing = False

    def __enter__(self) -> ProgressView:
        handlers = {signal.SIGINT: self._interrupt, signal.SIGALRM: self._tick}
        self._before = {number: signal.signal(number, handler) for number, handler in handlers.items()}
        if self._console.is_terminal:
            signal.setitimer(signal.ITIMER_REAL, _TICK, _TICK)
        return self

    def _tick(self, number: int, frame: FrameType | None) -> None:
        if self._interrupted:
            self._interrupt(number, frame)
        elif self._latest and not self._drawing:
            self._draw()

    def _interrupt(self, number: int, frame: FrameType | None) -> None:
        patience = self._patience
        if patience is not None and patience.answered and not (patience.interrupted or self._interrupted):
            patience.interrupt()
            self._console.print("stopping: the best plan so far is being completed (Ctrl-C again to give it up)")
            return
        self._interrupted = True
        signal.setitimer(signal.ITIMER_REAL, _AGAIN)
        raise KeyboardInterrupt

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._line.stop()

    def show(self, label: str, progress: Progress) -> None:
        """Tell that the plan called label has reached progress."""
        if self._interrupted:
            raise KeyboardInterrupt
        before, since = self._latest.pop(label, (None, 0.0))
        goes_on = before is not None and before.phase == progress.phase
        self._latest[label] = progress, since if goes_on else monotonic()
        if self._console.is_terminal:
            self._draw()
        elif not goes_on:
            self._console.print(f"{label}: {progress.phase}{_numbers(progress)}")

    def _draw(self) -> None:
        self._drawing, now, parts = True, monotonic(), []
        for label, (progress, since) in [*self._latest.items()][-_ABREAST:]:
            spent = f" ({now - since:.0f} s)" if now - since >= _TICK else ""
            parts.append(f"{label}: {progress.phase}{spent}{_numbers(progress)}")
        self._line.start()
        self._line.update(Text("   ".join(parts)), refresh=True)
        self._drawing = False


def _numbers(progress: Progress) -> str:
    parts = []
    if progress.incumbent is not None:
        parts.append(f"best {progress.incumbent:.3f} s")
    if progress.bound is not None:
        parts.append(f"bound {progress.bound:.3f} s")
    if progress.gap is not None:
        parts.append(f"gap {100 * progress.gap:.1f} %")
    return "  " + ", ".join(parts) if parts else ""
