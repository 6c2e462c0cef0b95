"""The fuzzer sees what it looks for: every kind of finding, made on purpose."""

from __future__ import annotations

import os
import random
import sys
import warnings
from collections.abc import Callable
from pathlib import Path

import fuzz_oracle
import pytest
from fuzz_mutate import mutated
from fuzz_oracle import Hang, guarded, judged
from fuzz_readers import Reader
from fuzz_run import Tally, add, block, shrunk, tried

from trajopt_cli.errors import InputError


def raising(error: BaseException) -> Callable[[], str]:
    def work() -> str:
        raise error

    return work


@pytest.mark.parametrize(
    ("work", "place"),
    [
        (raising(KeyError("x")), "KeyError outside trajopt"),
        (raising(RecursionError()), "RecursionError outside trajopt"),
        (raising(MemoryError()), "MemoryError outside trajopt"),
        (raising(OSError("no file")), "OSError without a file outside trajopt"),
        (raising(InputError("no", excerpt="\n".join(["much"] * 1000))), "message of more than a page outside trajopt"),
        (lambda: str(warnings.warn("old", RuntimeWarning, stacklevel=1)), "RuntimeWarning outside trajopt"),
    ],
)
def test_what_must_not_be_is_a_finding(work: Callable[[], str], place: str) -> None:
    ended = guarded(work)
    assert ended.finding is not None
    assert ended.finding.place == place


def test_bad_input_is_none() -> None:
    assert guarded(raising(InputError("wrong"))).finding is None
    assert guarded(raising(FileNotFoundError(2, "no such file", "a.mod"))).finding is None
    assert guarded(lambda: "read").how == "read"


def test_the_way_of_an_error_goes_through_trajopt_alone() -> None:
    from trajopt_cli.cell.loader import parse_cell

    ended = guarded(lambda: str(parse_cell("robot: [", "c.yaml")))
    assert {name for name, _ in ended.way} >= {"cell/loader.py", "yaml_file.py"}


def test_what_takes_too_long_is_a_finding(monkeypatch: pytest.MonkeyPatch) -> None:
    import signal

    monkeypatch.setattr(fuzz_oracle, "SECONDS", 0.05)
    before = signal.signal(signal.SIGPROF, fuzz_oracle._alarm)
    try:

        def forever() -> str:
            while True:
                try:
                    sum(range(1000))
                except Exception:  # noqa: BLE001  a reader may catch all of these
                    continue

        ended = guarded(forever)
    finally:
        signal.signal(signal.SIGPROF, before)
    assert ended.finding is not None
    assert Hang.__name__ in ended.finding.place


@pytest.mark.parametrize(
    ("how", "out", "err", "place"),
    [
        ("exit 3", "", "no", "exit 3: no"),
        ("exit -11", "", "", "exit -11: "),
        ("exit 2", "", "", "exit 2 without a word"),
        ("exit 2", "", "Traceback (most recent call last):", "stderr: Traceback (most recent call last):"),
        ("exit 0", "", "x.py:3: RuntimeWarning: overflow", "stderr: x.py:_: RuntimeWarning: overflow"),
        ("exit 2", "", "\x1b[31m", "stderr with the control character '\\x1b': \x1b[_m"),
        ("exit 2", "", "x" * 4001, f"stderr of more than a page: {'x' * 60}"),
        ("exit 0", "a\x07", "", "stdout with the control character '\\x07'"),
    ],
)
def test_what_a_command_must_not_do(how: str, out: str, err: str, place: str) -> None:
    ended = judged(how, out, err)
    assert ended.finding is not None
    assert ended.finding.place == place


@pytest.mark.parametrize("how", ["exit 0", "exit 1", "exit 2", "exit 130"])
def test_what_a_command_may_do(how: str) -> None:
    assert judged(how, "a\tb\n", "f:3: wrong; give another").finding is None


def test_a_file_left_behind_is_a_finding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def careless(arguments: list[str]) -> int:
        (Path(arguments[0]).parent / "stray").write_text("")
        sys.stderr.write("no\n")
        return 2

    monkeypatch.setattr("trajopt_cli.cli.run", careless)
    reader = Reader("any", "x", [b""], (), None, lambda path: [str(path)])
    ended = tried(reader, b"", tmp_path)
    assert ended.finding is not None
    assert ended.finding.place == "exit 2, left behind: stray: "


def test_a_case_is_the_same_for_the_same_seed() -> None:
    seeds = [b"robot: irb140\nstart: {joints: [0, 1, 2]}\n", "ß 1.5 \x00".encode()]
    first, again = ([mutated(random.Random(f"x{k}"), seeds, ("word",)) for k in range(200)] for _ in range(2))
    assert first == again
    assert len(set(first)) > 150


def breaks_at_seven(path: Path) -> None:
    if b"7" in path.read_bytes():
        raise ZeroDivisionError


def test_a_finding_is_kept_and_cut_down_to_what_matters(tmp_path: Path) -> None:
    folder, tally = tmp_path / "case", Tally()
    folder.mkdir()
    reader = Reader("any", "x", [b"a: 1\nb: 22\nc: 7\n" * 5], (), breaks_at_seven, lambda path: ["--version"])
    block(reader, random.Random(1), tally, 20, folder)
    assert tally.cases == 20
    assert set(tally.findings) == {"ZeroDivisionError outside trajopt"}
    count, told, data = tally.findings["ZeroDivisionError outside trajopt"]
    assert 15 <= count <= 20
    assert "breaks_at_seven" in told
    assert shrunk(reader, data, folder, "read", "ZeroDivisionError outside trajopt") == b"7"
    add(tally, guarded(lambda: "read"), b"")
    assert (tally.cases, tally.ended["read"]) == (21, 21 - count)


def test_ways_that_are_new_are_seeds_from_then_on(tmp_path: Path) -> None:
    from trajopt_cli.cell.loader import load_cell

    folder, tally = tmp_path / "case", Tally()
    folder.mkdir()
    reader = Reader("any", "x.yaml", [b"robot: irb140\n"], (), load_cell, lambda path: ["parse", os.fspath(path)])
    block(reader, random.Random(1), tally, 60, folder)
    assert 3 < len(tally.pool) < 60
    assert not tally.findings
