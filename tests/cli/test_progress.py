"""What progress says on a terminal, in a log, and where it is asked to be quiet."""

from __future__ import annotations

import re
import signal
from io import StringIO

import pytest

from trajopt_cli.cli import progress
from trajopt_cli.cli.progress import ProgressView, line
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience


class Terminal(StringIO):
    def isatty(self) -> bool:
        return True

    @property
    def shown(self) -> list[str]:
        """What each drawing shows."""
        return [text.removesuffix("\x1b[K") for text in self.getvalue().split("\r")[1:]]


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [100.0]
    monkeypatch.setattr(progress, "monotonic", lambda: now[0])
    monkeypatch.setenv("COLUMNS", "200")
    return now


def tick(clock: list[float], seconds: float) -> None:
    clock[0] += seconds
    signal.raise_signal(signal.SIGALRM)


def test_a_terminal_has_one_line_with_the_seconds_gone_and_the_limit(clock: list[float]) -> None:
    terminal, before = Terminal(), signal.getsignal(signal.SIGALRM)
    with ProgressView(Patience(60), stream=terminal) as view:
        assert signal.getitimer(signal.ITIMER_REAL)[1] == 1.0
        view.show("stream", Progress("search"))
        assert terminal.shown[-1] == "0 of 60 s: stream: searching rail and configurations"
        tick(clock, 31.4)
        assert terminal.shown[-1] == "31 of 60 s: stream: searching rail and configurations"
        clock[0] += 1
        view.show("rapid", Progress("judge", 7.0, 6.5))
        assert terminal.shown[-1] == (
            "32 of 60 s: rapid: judging the plan, best 7.000 s, bound 6.500 s, gap 7.7 %; stream: searching rail "
            "and configurations"
        )
        clock[0] += 1
        view.show("results", Progress("write"))
        assert terminal.shown[-1] == "33 of 60 s: writing the files"
    assert terminal.shown[-1] == ""  # taken away at the end
    assert "\n" not in terminal.getvalue()
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    assert signal.getsignal(signal.SIGALRM) == before


def test_a_slow_terminal_is_drawn_four_times_a_second_at_most_and_ends_with_the_newest(clock: list[float]) -> None:
    terminal = Terminal()
    with ProgressView(stream=terminal) as view:
        for i in range(101):
            view.show("stream", Progress("solve", 8.0 - i / 100))
            clock[0] += 0.01
        assert len(terminal.shown) == 5
        tick(clock, 1.0)
        assert terminal.shown[-1] == "2 s: stream: refining the plan, best 7.000 s"


@pytest.mark.parametrize("width", [20, 40, 60, 72, 80, 100])
def test_the_line_never_breaks_and_keeps_the_best_times_as_long_as_it_can(width: int) -> None:
    latest = {"stream": Progress("solve", 6.5), "rapid": Progress("judge", 6.972, 6.698)}
    text = line(latest, "12 of 60 s", width)
    assert len(text) <= width
    assert ("6.500" in text and "6.972" in text) == (width >= 70)
    assert text.startswith("12 of 60 s")


def test_a_log_has_whole_lines_and_few_of_them(clock: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    log = StringIO()
    with ProgressView(stream=log) as view:
        view.show("stream", Progress("search"))
        view.show("rapid", Progress("search"))
        clock[0] += 0.5
        view.show("stream", Progress("timing"))
        assert log.getvalue() == "0 s: stream: searching rail and configurations\n"
        tick(clock, 1.5)
        told = log.getvalue().splitlines()
        assert told[1:] == ["2 s: rapid: searching rail and configurations; stream: timing the paths found"]
        for _ in range(20):  # nothing new
            tick(clock, 1.0)
        assert log.getvalue().splitlines() == told
        tick(clock, 10.0)  # but it still runs
        assert log.getvalue().splitlines()[2:] == [told[1].replace("2 s", "32 s", 1)]
        for i in range(3600):
            clock[0] += 1
            view.show("stream", Progress("solve", 8.0 - i / 1e4))
    lines = log.getvalue().splitlines()
    assert len(lines) < 70
    assert all(re.match(r"\d+ s: rapid: ", one) for one in lines[1:])
    assert "\x1b" not in log.getvalue()
    assert "\r" not in log.getvalue()


def test_the_first_legal_motion_is_told_at_once_and_no_later_one(clock: list[float]) -> None:
    for stream in (Terminal(), StringIO()):
        with ProgressView(stream=stream) as view:
            view.show("stream", Progress("search"))
            clock[0] += 0.1
            view.show("stream", Progress("timing", 8.0))
            assert "best 8.000 s" in stream.getvalue()
            clock[0] += 0.1
            view.show("rapid", Progress("timing", 9.0))
            assert "best 9.000 s" not in stream.getvalue()


def test_quiet_says_nothing_but_what_ctrl_c_does(clock: list[float]) -> None:
    said, waiting = Terminal(), Patience()
    with ProgressView(waiting, quiet=True, stream=said) as view:
        assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
        view.show("stream", Progress("search"))
        assert said.getvalue() == ""
        waiting.answer()
        signal.raise_signal(signal.SIGINT)
        assert said.getvalue().startswith("stopping: the best plan so far is being completed")
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_a_dumb_terminal_is_a_log(clock: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "dumb")
    said = Terminal()
    with ProgressView(stream=said) as view:
        view.show("stream", Progress("search"))
    assert said.getvalue() == "0 s: stream: searching rail and configurations\n"
