"""Loops whose LLVM IR numba wrote: what they are given, where they are kept, and whether the files are the sources'."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from shutil import copy

import llvmlite.binding as llvm
import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.native.loops import Loop, loops_kept
from trajopt_cli.native.machine import machine
from trajopt_cli.native.numba_ir import made_by
from trajopt_cli.native.store import Store

PACKAGE = Path(__file__).parents[2] / "trajopt_cli"
SOURCES = sorted(PACKAGE.rglob("*_loops.py"))
SMALL = "small_loops"


def dotted(source: Path) -> str:
    return ".".join(("trajopt_cli", *source.relative_to(PACKAGE).with_suffix("").parts))


def developer(*arguments: str, folder: Path, **environment: str) -> str:
    """What Python prints that finds modules in a folder."""
    paths = os.pathsep.join([str(folder), str(PACKAGE.parent)])
    command = [sys.executable, *arguments]
    return subprocess.check_output(command, text=True, env=os.environ | environment | {"PYTHONPATH": paths})


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The small module, with the file that numba writes for it whatever the environment asks of numba."""
    at = tmp_path_factory.mktemp("source")
    copy(Path(__file__).parent / "small_loops.py", at)
    asked = {"NUMBA_DISABLE_JIT": "1", "NUMBA_BOUNDSCHECK": "1"}
    developer("-m", "trajopt_cli.native.numba_ir", "small_loops", folder=at, **asked)
    return at


@pytest.fixture(scope="module")
def made(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Store, Loop]]:
    """Where the small function is kept, and itself; the module can be found."""
    store = Store(tmp_path_factory.mktemp("loops"))
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(folder)
        found = loops_kept(SMALL, store)
        assert [*found] == ["fill"]
        yield store, found["fill"]


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


def test_neither_numba_nor_the_module_is_imported_and_many_may_ask_at_once(made: tuple[Store, Loop]) -> None:
    fork = multiprocessing.get_context("fork")
    store = Store(made[0].folder / "other")
    others = [fork.Process(target=lambda: right(loops_kept(SMALL, store)["fill"])) for _ in range(2)]
    for one in others:
        one.start()
    for one in others:
        one.join()
    assert [one.exitcode for one in others] == [0, 0]
    assert SMALL not in sys.modules
    every = f"import sys; [loops(name) for name in {[*map(dotted, SOURCES)]}]; print('numba' in sys.modules)"
    assert developer("-c", f"from trajopt_cli.native.loops import loops; {every}", folder=PACKAGE.parent) == "False\n"


def test_where_nothing_can_be_kept_it_is_made_and_called(made: tuple[Store, Loop], tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    store = Store(tmp_path / "file" / "folder")
    right(loops_kept(SMALL, store)["fill"])
    assert store.trouble


def test_code_is_made_anew_for_another_computer(made: tuple[Store, Loop], monkeypatch: pytest.MonkeyPatch) -> None:
    count = len([*made[0].folder.glob("*.block")])
    monkeypatch.setattr(type(machine()), "identity", "another computer")
    for _ in range(2):
        loops_kept(SMALL, made[0])
        assert len([*made[0].folder.glob("*.block")]) == count + 1


@pytest.mark.parametrize("which", ["small_loops.py", "small_loops.ll"])
def test_a_file_that_does_not_belong_to_its_source_is_refused(
    folder: Path, which: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As a source that was changed, a file that is damaged or of another version."""
    for suffix in (".py", ".ll"):
        copy(folder / f"small_loops{suffix}", tmp_path / f"changed_loops{suffix}")
    changed = tmp_path / which.replace("small", "changed")
    monkeypatch.syspath_prepend(tmp_path)
    text = changed.read_text()
    changed.write_text(text.replace("1", "2"))
    with pytest.raises(InputError, match="changed_loops"):
        loops_kept("changed_loops", Store(tmp_path / "store"))


@pytest.mark.long
def test_the_files_are_what_numba_makes_of_the_sources() -> None:
    """To the byte. Another numba, llvmlite or Python writes other text of the same meaning."""
    kept = [source.with_suffix(".ll").read_text() for source in SOURCES]
    if {text.splitlines()[1] for text in kept} != {made_by()}:
        pytest.skip(f"not {made_by()}")
    program = "import sys; from trajopt_cli.native.numba_ir import written; print(*map(written, sys.argv[1:]), sep='|')"
    assert developer("-c", program, *map(dotted, SOURCES), folder=PACKAGE.parent)[:-1].split("|") == kept


@pytest.mark.parametrize("source", SOURCES, ids=lambda source: source.stem)
@pytest.mark.parametrize("triple", ["x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu"])
def test_the_files_are_for_any_processor(source: Path, triple: str) -> None:
    """Nothing in them is the machine's that made them: even the simplest processor of a kind has code."""
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    text = source.with_suffix(".ll").read_text()
    assert "\ntarget " not in text
    module, target = llvm.parse_assembly(text), llvm.Target.from_triple(triple).create_target_machine()
    module.triple, module.data_layout = triple, str(target.target_data)
    assert b"loops." in target.emit_object(module)
