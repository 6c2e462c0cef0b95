"""Progress on stderr: one line that lives where there is a terminal, a line per phase where there is none."""

from __future__ import annotations

import signal
from types import FrameType, TracebackType

from rich.live import Live
from rich.text import Text

from trajopt_cli.cli.console import stderr
from trajopt_cli.problem.patience import Patience
from trajopt_cli.problem.progress import Progress

_ABREAST = 2  # plans under way at once: one for each process
_AGAIN = 0.5  # s; long against the tidying up that an interrupt sets off


class ProgressView:
    """Shows what it is told between `with` and its end, and keeps Ctrl-C from being lost there.

    CasADi takes a KeyboardInterrupt inside a solver for a request to stop that solver, and the caller goes on with what
    it got. So an interrupt is remembered and raised again until it is through: every half second, and when the next
    progress is told.

    Where there is patience and an answer at hand, the first interrupt ends only the search for a better one.
    """

    def __init__(self, patience: Patience | None = None) -> None:
        self._interrupted, self._patience = False, patience
        self._console = stderr()
        # without a thread that draws: other processes are forked while it is up
        self._line = Live(console=self._console, auto_refresh=False, transient=True)
        self._latest: dict[str, str] = {}  # what was said last, by label: two plans may be under way

    def __enter__(self) -> ProgressView:
        self._before = {number: signal.signal(number, self._interrupt) for number in (signal.SIGINT, signal.SIGALRM)}
        return self

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
        text = f"{label}: {progress.phase}{_numbers(progress)}"
        known = self._latest.get(label, "")
        self._latest.pop(label, None)
        self._latest[label] = text
        if self._console.is_terminal:
            self._line.start()
            self._line.update(Text("   ".join([*self._latest.values()][-_ABREAST:])), refresh=True)
        elif not known.startswith(f"{label}: {progress.phase}  ") and known != f"{label}: {progress.phase}":
            self._console.print(text)


def _numbers(progress: Progress) -> str:
    parts = []
    if progress.incumbent is not None:
        parts.append(f"best {progress.incumbent:.3f} s")
    if progress.bound is not None:
        parts.append(f"bound {progress.bound:.3f} s")
    if progress.gap is not None:
        parts.append(f"gap {100 * progress.gap:.1f} %")
    return "  " + ", ".join(parts) if parts else ""
