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
        self._latest: dict[str, str] = {}  # what was said last, by label: two plans may be under way

    def __enter__(self) -> ProgressView:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._status is not None:
            self._status.stop()

    def show(self, label: str, progress: Progress) -> None:
        """Tell that the plan called label has reached progress."""
        text = f"{label}: {progress.phase}{_numbers(progress)}"
        known = self._latest.get(label, "")
        self._latest[label] = text
        if self._status is not None:
            self._status.start()  # only now: it draws from a thread, and a second process may be forked before
            self._status.update("   ".join(self._latest.values()))
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
