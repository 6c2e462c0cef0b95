"""What progress says on a terminal and where there is none."""

from __future__ import annotations

import signal
from io import StringIO

import pytest
from rich.console import Console

from trajopt_cli.cli import progress
from trajopt_cli.cli.progress import ProgressView
from trajopt_cli.problem.progress import Progress


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [100.0]
    monkeypatch.setattr(progress, "monotonic", lambda: now[0])
    return now


def test_a_terminal_sees_how_long_a_phase_has_been_running(clock: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    said = StringIO()
    monkeypatch.setattr(progress, "stderr", lambda: Console(file=said, force_terminal=True, width=120))
    before = signal.getsignal(signal.SIGALRM)
    with ProgressView() as view:
        assert signal.getitimer(signal.ITIMER_REAL)[1] == 1.0
        view.show("stream", Progress("search"))
        assert "s)" not in said.getvalue()
        clock[0] += 31.4
        signal.raise_signal(signal.SIGALRM)
        assert said.getvalue().endswith("stream: search (31 s)")
        view.show("rapid", Progress("timing", 7.0))
        view.show("stream", Progress("search", 8.0))  # the same phase goes on
        assert said.getvalue().endswith("rapid: timing  best 7.000 s   stream: search (31 s)  best 8.000 s")
        view.show("stream", Progress("timing"))
        assert said.getvalue().endswith("rapid: timing  best 7.000 s   stream: timing")
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    assert signal.getsignal(signal.SIGALRM) == before


def test_where_there_is_no_terminal_each_phase_is_a_line(clock: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    said = StringIO()
    monkeypatch.setattr(progress, "stderr", lambda: Console(file=said, width=120))
    with ProgressView() as view:
        assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
        for one in (Progress("search"), Progress("search", 8.0), Progress("timing", 8.0)):
            view.show("stream", one)
            clock[0] += 60
    assert said.getvalue().splitlines() == ["stream: search", "stream: timing  best 8.000 s"]
