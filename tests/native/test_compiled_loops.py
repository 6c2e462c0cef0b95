"""Loops compiled by numba: what they are given, where they are kept, and when numba is asked."""

from __future__ import annotations

import multiprocessing
import sys
from contextlib import ExitStack, nullcontext
from pathlib import Path
from time import sleep

import numba
import numpy as np
import pytest

from trajopt_cli.native.loops import Loop, _key, loops_kept, prepared
from trajopt_cli.native.machine import machine
from trajopt_cli.native.store import Store
from trajopt_cli.workers import Worker

SMALL = "native.small_loops"


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Store, Loop]:
    """Where the small function is kept, and itself."""
    store = Store(tmp_path_factory.mktemp("loops"))
    found = loops_kept(SMALL, store)
    assert [*found] == ["fill"]
    return store, found["fill"]


def right(fill: Loop) -> None:
    """Strides of rows and columns, of none, backwards; a division by zero is NumPy's; nothing else is written."""
    every = np.random.default_rng(3).uniform(1, 2, (6, 8))
    every[4, 6] = 0.0
    for x in (every[::2, ::3], every[::-1, 6:4:-1], np.broadcast_to(every[1], (6, 8)), np.asfortranarray(every)):
        at, out = np.array([2, 0, 1]), np.full(4, 7.0)
        fill(x, -2.5, at, out)
        with np.errstate(divide="ignore"):
            np.testing.assert_allclose(out, [*(-2.5 * np.sin(x[at, 0]) / x[at, 1]), 7.0], rtol=1e-15)


def test_what_numba_compiled_is_called_with_arrays_as_they_lie(made: tuple[Store, Loop]) -> None:
    right(made[1])


@pytest.mark.parametrize(
    ("k", "wrong"),
    [
        (0, np.zeros(3)),
        (0, np.zeros((3, 3), dtype=np.float32)),
        (2, np.zeros(3)),
        (2, np.arange(6)[::2]),
        (1, np.zeros(1)),
        (3, 0.0),
        (slice(3, 4), []),
    ],
)
def test_an_argument_of_another_kind_is_refused(made: tuple[Store, Loop], k: int | slice, wrong: object) -> None:
    """It would be read as what it is not."""
    given: list[object] = [np.ones((3, 3)), 1.0, np.arange(3), np.zeros(3)]
    given[k] = wrong  # type: ignore[call-overload]
    with pytest.raises((TypeError, ValueError)):
        made[1](*given)  # type: ignore[arg-type]


def test_what_is_kept_needs_no_numba_and_many_may_ask_at_once(
    made: tuple[Store, Loop], monkeypatch: pytest.MonkeyPatch
) -> None:
    """None for a module is an ImportError where it is asked for."""
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.delitem(sys.modules, SMALL)
    kept = loops_kept(SMALL, made[0])
    right(kept["fill"])
    assert SMALL not in sys.modules
    with pytest.raises(ImportError):
        loops_kept(SMALL, Store(made[0].folder / "other"))
    fork = multiprocessing.get_context("fork")
    others = [fork.Process(target=lambda: right(loops_kept(SMALL, made[0])["fill"])) for _ in range(2)]
    for one in others:
        one.start()
    for one in others:
        one.join()
    assert [one.exitcode for one in others] == [0, 0]


def test_what_the_environment_asks_of_numba_changes_nothing_that_is_kept(
    made: tuple[Store, Loop], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """NUMBA_DISABLE_JIT=1 leaves Python functions, of which nothing was kept, for runs without it, too."""
    for name in ("DISABLE_JIT", "BOUNDSCHECK"):
        monkeypatch.setattr(numba.config, name, 1)
    monkeypatch.delitem(sys.modules, SMALL)
    store = Store(tmp_path)
    right(loops_kept(SMALL, store)["fill"])
    kept, usual = (one.read(_key(SMALL)) for one in (store, made[0]))
    assert kept is not None
    assert usual is not None
    assert len(kept["code"]) == len(usual["code"])  # names of symbols count what the process compiled before
    assert (numba.config.DISABLE_JIT, numba.config.BOUNDSCHECK) == (1, 1)


def test_where_nothing_can_be_kept_it_is_compiled_and_called(made: tuple[Store, Loop], tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    store = Store(tmp_path / "file" / "folder")
    right(loops_kept(SMALL, store)["fill"])
    assert store.trouble


def test_code_is_made_anew_for_another_computer_numba_or_text(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (text := tmp_path / "changed_loops.py").write_bytes((Path(__file__).parent / "small_loops.py").read_bytes())
    monkeypatch.syspath_prepend(tmp_path)
    store = Store(tmp_path / "store")
    for count in range(1, 5):
        for _ in range(2):
            loops_kept("changed_loops", store)
            assert len([*store.folder.glob("*.block")]) == count
        if count == 1:
            monkeypatch.setattr("trajopt_cli.native.loops.version", lambda _: "0.0")
        elif count == 2:
            monkeypatch.setattr(type(machine()), "identity", "another computer")
        else:
            text.write_text(text.read_text() + "\n")


def test_who_asks_for_what_another_process_compiles_waits_for_it(
    made: tuple[Store, Loop], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The other process has no numba, and ends well: it takes what is there when its turn comes. Where nothing can be
    kept it has nothing to do."""
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.delitem(sys.modules, SMALL, raising=False)
    assert isinstance(prepared([SMALL], made[0]), nullcontext)
    store, kept = Store(tmp_path / "store"), made[0].read(_key(SMALL))
    assert kept is not None
    with ExitStack() as mine, ExitStack() as theirs:
        mine.enter_context(store.making(_key(SMALL)))
        other = theirs.enter_context(prepared([SMALL], store))
        assert isinstance(other, Worker)
        sleep(0.1)
        assert not other.done
        store.write(_key(SMALL), kept)
        mine.close()
        assert other.answer() is None
    with prepared([SMALL], Store(tmp_path / "file" / "store")) as other:
        assert isinstance(other, Worker)
        assert other.answer() is None
    with pytest.raises(ImportError):
        loops_kept(SMALL, Store(tmp_path / "empty"))
