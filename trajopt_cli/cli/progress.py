"""Progress on stderr: one line that lives where there is a terminal, a line now and then where there is none."""

from __future__ import annotations

import os
import signal
import sys
from time import monotonic
from types import FrameType, TracebackType
from typing import TextIO

from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.table import TOLD_GAP

_ABREAST = 2  # plans under way at once: one for each process
_ALONE = frozenset({"program", "results"})  # what is under way before and after all plans
_AGAIN = 0.5  # s; long against the tidying up that an interrupt sets off
_TICK = 1.0  # s between looks at the clock
_DRAWN = 0.25  # s between two drawings at least: a slow line carries no more
_SILENT = 30.0  # s after which a log says the same again

# What a phase is in words, and in few words where the line is short of room.
_WORDS = {
    "reach": ("checking what can be reached", "reach"),
    "search": ("searching rail and configurations", "searching"),
    "timing": ("timing the paths found", "timing"),
    "solve": ("refining the plan", "refining"),
    "ease": ("making the plan gentler", "easing"),
    "tool turns": ("turning tools that are free about their axis", "turning tools"),
    "ways around": ("looking for ways around what is touched", "ways around"),
    "stopped": ("waiting for the RAPID plan", "waiting"),
    "bound": ("proving the bound", "bound"),
    "done": ("plan found", "found"),
    "judge": ("judging the plan", "judging"),
    "as written": ("timing the program as written", "as written"),
    "loops": ("estimating what writing loops out would save", "loops"),
    "write": ("writing the files", "writing"),
    "plots": ("drawing", "drawing"),
    "solve again": ("solving the plan again", "solving again"),
}


def log_pause(spent: float) -> float:
    """Seconds between two lines of a log at least: two, and a tenth of the time so far; an hour has some 60 lines."""
    return max(2.0, spent / 10)


class ProgressView:
    """Shows what it is told between `with` and its end, and keeps Ctrl-C from being lost there.

    CasADi takes a KeyboardInterrupt inside a solver for a request to stop that solver, and the caller goes on with what
    it got. So an interrupt is remembered and raised again until it is through: every half second, and when the next
    progress is told.

    Where there is patience and an answer at hand, the first interrupt ends only the search for a better one.

    A terminal has one line, as wide as it is, with the seconds gone, of how many; it is drawn four times a second at
    most and taken away at the end. A log has whole lines when something changed; that there is a first legal motion is
    shown at once. quiet: nothing is shown.
    """

    def __init__(self, patience: Patience | None = None, quiet: bool = False, stream: TextIO | None = None) -> None:
        self._interrupted, self._patience, self._quiet = False, patience, quiet
        self._stream = stream or sys.stderr
        # not what FORCE_COLOR or a library takes for a terminal: the line is drawn with carriage returns
        self._live = self._stream.isatty() and os.environ.get("TERM") != "dumb"
        self._latest: dict[str, Progress] = {}  # what was said last by label, the newest last
        self._start = monotonic()
        self._shown = -_SILENT  # when something was shown last, from the start [s]
        self._news = self._drawing = False
        self._word = ""  # to say once, and soon: not in the middle of a drawing that a signal came into

    def __enter__(self) -> ProgressView:
        handlers = {signal.SIGINT: self._interrupt, signal.SIGALRM: self._tick}
        self._before = {number: signal.signal(number, handler) for number, handler in handlers.items()}
        if not self._quiet:
            # no thread: other processes are forked while this is up, and no timer with them
            signal.setitimer(signal.ITIMER_REAL, _TICK, _TICK)
        return self

    def _tick(self, number: int, frame: FrameType | None) -> None:
        if self._interrupted:
            self._interrupt(number, frame)
        else:
            self._show()

    def _interrupt(self, number: int, frame: FrameType | None) -> None:
        patience = self._patience
        if patience is not None and patience.answered and not (patience.interrupted or self._interrupted):
            patience.interrupt()
            self._word = "stopping: the best plan so far is being completed (Ctrl-C again to give it up)"
            self._show()
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
        self._clear()

    def show(self, label: str, progress: Progress) -> None:
        """Tell that the plan called label has reached progress."""
        if self._interrupted:
            raise KeyboardInterrupt
        if progress.incumbent is not None and all(one.incumbent is None for one in self._latest.values()):
            self._shown = -_SILENT
        self._news |= self._latest.pop(label, None) != progress
        self._latest[label] = progress
        self._show()

    def _show(self) -> None:
        """Show what there is, unless it was just done: the clock will come back to it."""
        if self._word and not self._drawing:
            self._clear()
            self._say(f"{self._word}\n")
            self._word = ""
        spent = monotonic() - self._start
        pause = _DRAWN if self._live else log_pause(spent)
        due = self._news or self._live or spent - self._shown >= _SILENT
        if self._quiet or self._drawing or not self._latest or not due or spent - self._shown < pause:
            return
        self._drawing = True
        if self._live:
            self._say(f"\r{line(self._latest, self._clock(spent), self._width() - 1)}\x1b[K")
        else:
            self._say(f"{line(self._latest, self._clock(spent))}\n")
        self._news, self._shown, self._drawing = False, spent, False

    def _clock(self, spent: float) -> str:
        patience = self._patience
        if patience is None or patience.limit is None:
            return f"{spent:.0f} s"
        unsettled = spent > patience.limit and not patience.settled
        return f"{spent:.0f} of {patience.limit:g} s{', no legal motion yet' if unsettled else ''}"

    def _width(self) -> int:
        told = os.environ.get("COLUMNS", "")
        if told.isdecimal() and int(told) > 0:
            return int(told)
        return os.get_terminal_size(self._stream.fileno()).columns or 80

    def _clear(self) -> None:
        if self._live and not self._quiet and self._latest:
            self._say("\r\x1b[K")

    def _say(self, text: str) -> None:
        self._stream.write(text)
        self._stream.flush()


def line(latest: dict[str, Progress], clock: str, width: int | None = None) -> str:
    """What is under way, in as many words as width has room for."""
    newest = [*latest][-1]
    labels = [newest] if newest in _ALONE else sorted([name for name in latest if name not in _ALONE][-_ABREAST:])
    for few, bare in ((False, False), (True, False), (True, True)):
        parts = []
        for label in labels:
            words = _WORDS.get(latest[label].phase, (latest[label].phase,) * 2)[few]
            numbers = "".join(f", {part}" for part in _numbers(latest[label])[: 1 if bare else None])
            parts.append(f"{words}{numbers}" if label in _ALONE else f"{label}: {words}{numbers}")
        text = f"{clock}: {'; '.join(parts)}"
        if width is None or len(text) <= width:
            return text
    return text if width is None else f"{text[: max(width - 1, 0)]}…"


def _numbers(progress: Progress) -> list[str]:
    parts = []
    if progress.incumbent is not None:
        parts.append(f"best {progress.incumbent:.3f} s")
    if progress.bound is not None:
        parts.append(f"bound {progress.bound:.3f} s")
    if progress.gap is not None and progress.gap <= TOLD_GAP:
        parts.append(f"gap {100 * progress.gap:.1f} %")
    return parts
