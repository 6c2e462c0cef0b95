"""Progress on stderr: one line that lives where there is a terminal, a line per phase where there is none."""

from __future__ import annotations

from types import TracebackType

from trajopt_cli.cli.console import stderr
from trajopt_cli.problem.progress import Progress


class ProgressView:
    """Shows what it is told between `with` and its end."""

    def __init__(self) -> None:
        self._console = stderr()
        self._status = self._console.status("reading") if self._console.is_terminal else None
        self._last = ""

    def __enter__(self) -> ProgressView:
        if self._status is not None:
            self._status.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._status is not None:
            self._status.stop()

    def show(self, label: str, progress: Progress) -> None:
        """Tell that the plan called label has reached progress."""
        text = f"{label}: {progress.phase}{_numbers(progress)}"
        if self._status is not None:
            self._status.update(text)
        elif (here := f"{label}: {progress.phase}") != self._last:
            self._last = here
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
