"""What every test has: a cache folder that is not the user's, a terminal of no width, and the same examples every time.

That folder is pytest's own, so machine code is kept from run to run: what it comes from is in its key. --cache-clear
begins anew, -p no:cacheprovider begins with nothing.

--shuffle SEED runs files, and the tests of each, in another order: no test may need one that ran before it.
"""

from __future__ import annotations

import gc
import os
import random
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path
from shutil import rmtree

import pytest
from _pytest.assertion import rewrite
from hypothesis import settings
from no_browser import MISSING

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):  # as the command does: the other core has other tests
    os.environ.setdefault(_name, "1")
_FOLDER = tempfile.TemporaryDirectory()
for _name in ("COLUMNS", "NO_COLOR", "FORCE_COLOR"):  # what is printed depends on them
    os.environ.pop(_name, None)

os.fsync = os.fstat  # type: ignore[assignment]  # no test pulls the plug: waiting for the disk is for nothing
gc.disable()  # until all tests are loaded

settings.register_profile("same", derandomize=True, deadline=None)
settings.register_profile("search", deadline=None)  # other examples in every run: --hypothesis-profile=search
settings.load_profile("same")


def pytest_configure(config: pytest.Config) -> None:
    """Workers share the folder of the process that started them.

    Where the tree is to have no bytecode it has some as long as the tests run: workers and the many processes that they
    start would compile everything each.
    """
    if "PYTEST_XDIST_WORKER" in os.environ:
        return
    folder = Path(_FOLDER.name)
    with suppress(AttributeError, OSError):  # no such plugin; a folder that cannot be written to
        folder = config.cache.mkdir("trajopt")
    os.environ["XDG_CACHE_HOME"] = str(folder)
    if os.environ.pop("PYTHONDONTWRITEBYTECODE", None):
        sys.dont_write_bytecode = False
        config.add_cleanup(partial(_remove_others, {*_bytecode()}))


def _bytecode() -> Iterator[Path]:
    """The folders of the tree with bytecode."""
    tree = Path(__file__).parents[1]
    for part in ("tests", "trajopt_cli"):
        yield from (tree / part).rglob("__pycache__")


def _remove_others(kept: set[Path]) -> None:
    for folder in {*_bytecode()} - kept:
        rmtree(folder, ignore_errors=True)


@pytest.fixture
def unrefined(monkeypatch: pytest.MonkeyPatch) -> None:
    """Streams are the first legal ones, in a tenth of the time."""
    from unrefined import IMPROVED, as_it_comes

    monkeypatch.setattr(IMPROVED, as_it_comes)


@pytest.fixture(scope="module")
def coarse() -> Iterator[None]:
    """All streams of a module are solved on the coarse grids of long programs, in a third of the time."""
    from unrefined import coarse_grids

    with coarse_grids():
        yield


@pytest.fixture(scope="module")
def few_places() -> Iterator[None]:
    """All rails of a module have their places searched on coarse grids and refined once."""
    from unrefined import coarse_search

    with pytest.MonkeyPatch.context() as patch:
        coarse_search(patch)
        yield


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--regenerate", action="store_true", help="write tests/golden/sentences.txt anew")
    parser.addoption("--shuffle", type=int, metavar="SEED", help="run files, and the tests of each, in random order")


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """A file's tests stay together: what they share is made once."""
    if (seed := config.getoption("--shuffle")) is None:
        return
    files: dict[str, list[pytest.Item]] = {}
    for item in items:
        files.setdefault(item.nodeid.split("::")[0], []).append(item)
    chance, order = random.Random(seed), list(files.values())
    chance.shuffle(order)
    for tests in order:
        chance.shuffle(tests)
    items[:] = [item for tests in order for item in tests]


@pytest.hookimpl(tryfirst=True)
def pytest_collection(session: pytest.Session) -> None:
    """Where all tests run in several processes, the second begins to prepare their files at the other end.

    pytest would rewrite the assertions of every file in every process; so each does half of them and reads the others.
    """
    whole = session.config.args_source is pytest.Config.ArgsSource.TESTPATHS
    if os.environ.get("PYTEST_XDIST_WORKER") != "gw1" or sys.dont_write_bytecode or not whole:
        return
    with suppress(AttributeError, TypeError):  # pytest's own: with another version it does all by itself
        state = session.config.stash[rewrite.assertstate_key]
        for path in sorted(Path(__file__).parent.rglob("test_*.py"), reverse=True):
            folder = rewrite.get_cache_dir(path)
            kept = folder / f"{path.stem}{rewrite.PYC_TAIL}"
            if rewrite._read_pyc(path, kept) is not None or not rewrite.try_makedirs(folder):
                break
            stat, code = rewrite._rewrite_test(path, session.config)
            rewrite._write_pyc(state, code, stat, kept)


def pytest_collection_finish() -> None:
    """What is loaded by now stays until the end: looking through it for garbage is work for nothing."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 50)  # as the command does
    gc.enable()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """pytest itself gives no reason for a skip unless it is asked."""
    count = sum(MISSING in str(report.longrepr) for report in terminalreporter.getreports("skipped"))
    if count:
        terminalreporter.write_line(f"{count} tests of the report page did not run: {MISSING}")
