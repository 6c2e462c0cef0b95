"""What is kept between runs: it comes back as it was, or not at all."""

from __future__ import annotations

import multiprocessing
import os
from dataclasses import replace
from pathlib import Path

import casadi as ca
import llvmlite
import llvmlite.binding as llvm
import numpy as np
import pytest
from small_cells import plant_with_rail

from trajopt_cli.native import store as module
from trajopt_cli.native.machine import machine
from trajopt_cli.native.store import Store, exact
from trajopt_cli.nlp.block import Expressed, express
from trajopt_cli.nlp.block_cache import Native
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.trajectories.axes import Axes

ARRAYS = {"a": np.arange(12.0).reshape(3, 4), "b": np.array([1, 2], dtype=np.int64)}


def test_what_was_written_is_read(tmp_path: Path) -> None:
    Store(tmp_path / "new").write("key", ARRAYS)
    found = Store(tmp_path / "new").read("key")
    assert found is not None
    assert found.keys() == ARRAYS.keys()
    for name, wanted in ARRAYS.items():
        np.testing.assert_array_equal(found[name], wanted, strict=True)
    assert Store(tmp_path / "new").read("other key") is None


def spoiled(content: bytes) -> dict[str, bytes]:
    middle = len(content) // 2
    return {
        "cut off": content[:middle],
        "empty": b"",
        "one bit": content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :],
        "longer": content + b"\0",
        "text": b"hello\n",
    }


@pytest.mark.parametrize("how", spoiled(b"12"))
def test_a_damaged_entry_is_made_anew(tmp_path: Path, how: str) -> None:
    store = Store(tmp_path)
    store.write("key", ARRAYS)
    (file,) = tmp_path.iterdir()
    file.write_bytes(spoiled(file.read_bytes())[how])
    assert store.read("key") is None
    store.write("key", ARRAYS)
    assert store.read("key") is not None


def test_what_a_killed_process_left_goes_and_what_a_living_one_writes_stays(tmp_path: Path) -> None:
    import fcntl

    for name in ("left.part", "busy.part"):
        (tmp_path / name).write_bytes(b"half")
    with open(tmp_path / "busy.part", "rb") as busy:
        fcntl.flock(busy, fcntl.LOCK_EX)
        Store(tmp_path).write("key", ARRAYS)
        assert {path.suffix for path in tmp_path.iterdir()} == {".block", ".part"}
        assert (tmp_path / "busy.part").exists()
    Store(tmp_path).write("key", ARRAYS)
    assert {path.suffix for path in tmp_path.iterdir()} == {".block"}


@pytest.mark.parametrize("mode", [0o777, 0o770, 0o1777])
def test_a_folder_that_others_may_write_to_is_not_used(tmp_path: Path, mode: int) -> None:
    """What it holds would be run."""
    store = Store(tmp_path)
    store.write("key", ARRAYS)
    assert store.read("key") is not None
    tmp_path.chmod(mode)
    assert store.read("key") is None
    store.write("other", ARRAYS)
    assert store.trouble == f"{tmp_path}: others may write there, and what is kept is run as code"
    tmp_path.chmod(0o700)
    assert store.read("other") is None


def test_an_entry_under_anothers_name_is_absent(tmp_path: Path) -> None:
    store = Store(tmp_path)
    store.write("key", ARRAYS)
    (file,) = tmp_path.iterdir()
    store.write("other", ARRAYS)
    (other,) = set(tmp_path.iterdir()) - {file}
    other.write_bytes(file.read_bytes())
    assert store.read("other") is None


def test_a_folder_that_cannot_be_made_is_done_without(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    for folder, why in ((tmp_path / "file" / "trajopt", "Not a directory"), (Path("~/x"), "no home folder")):
        store = Store(folder)
        assert store.read("key") is None
        assert store.trouble is None
        store.write("key", ARRAYS)
        assert why in str(store.trouble)
        assert store.read("key") is None
    assert not Path("~").exists()


def test_what_was_read_longest_ago_makes_room(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store = Store(tmp_path)
    store.write("0", ARRAYS)
    (first,) = tmp_path.iterdir()
    monkeypatch.setattr(module, "MOST_BYTES", 3.5 * first.stat().st_size)
    (tmp_path / "notes.txt").write_text("not ours")
    (tmp_path / "killed.part").write_bytes(b"x" * first.stat().st_size)
    for i in range(1, 5):
        for file in tmp_path.iterdir():  # older than what comes next
            os.utime(file, ns=(file.stat().st_mtime_ns - 10**9,) * 2)
        store.write(str(i), ARRAYS)
        assert store.read("0") is not None, "it is asked for every time"
    assert [store.read(str(i)) is not None for i in range(5)] == [True, False, False, True, True]
    assert sorted(file.suffix for file in tmp_path.iterdir()) == [".block"] * 3 + [".txt"]


def test_processes_that_write_at_once_leave_a_whole_entry(tmp_path: Path) -> None:
    context = multiprocessing.get_context("fork")
    many = {"a": np.arange(50_000.0)}

    def write() -> None:
        for _ in range(20):
            Store(tmp_path).write("key", many)

    writers = [context.Process(target=write) for _ in range(3)]
    for one in writers:
        one.start()
    read = 0
    while any(one.is_alive() for one in writers):
        found = Store(tmp_path).read("key")
        if found is not None:
            np.testing.assert_array_equal(found["a"], many["a"])
            read += 1
        else:
            assert not read, "an entry was there and is damaged or gone"
    assert [one.exitcode for one in writers] == [0, 0, 0]
    assert Store(tmp_path).read("key") is not None
    assert len(list(tmp_path.iterdir())) == 1


def small() -> Expressed:
    return express(2, 1, lambda z, p: [(ca.sin(z[0]) * z[1] ** 2 - p[0], 0.0, 1.0)])


def test_a_kept_block_is_not_expressed_again(tmp_path: Path) -> None:
    z, p, lam = np.array([[0.5, 2.0]]), np.array([[0.25]]), np.array([[3.0]])
    first = Native(machine(), Store(tmp_path)).block("small", "key", small)

    def unwanted() -> Expressed:
        raise AssertionError("expressed again")

    again = Native(machine(), Store(tmp_path)).block("small", "key", unwanted)
    with pytest.raises(AssertionError, match="expressed again"):
        Native(machine(), Store(tmp_path)).block("small", "key 2", unwanted)
    s, c = np.sin(0.5), np.cos(0.5)
    for block in (first, again):
        g, jacobian = block.values(z, p)
        np.testing.assert_allclose(g, [[4 * s - 0.25]], rtol=1e-15)
        np.testing.assert_allclose(jacobian, [[4 * c, 4 * s]], rtol=1e-15)
        np.testing.assert_allclose(block.curvature(z, p, lam), 3 * np.array([[-4 * s, 4 * c, 2 * s]]), rtol=1e-15)
        assert [x.tolist() for x in block.shape.hessian_at] == [[0, 0, 1], [0, 1, 1]]
        assert (block.shape.lower.tolist(), block.shape.upper.tolist()) == ([0.0], [1.0])


def test_code_for_another_computer_is_not_taken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    Native(machine(), Store(tmp_path)).block("small", "key", small)
    for part in (llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten(), llvmlite.__version__):
        assert f" {part}" in machine().identity
    monkeypatch.setattr(type(machine()), "identity", "another computer")
    Native(machine(), Store(tmp_path)).block("small", "key", small)
    assert len(list(tmp_path.iterdir())) == 2


def test_robots_that_differ_in_a_hair_have_blocks_of_their_own(tmp_path: Path) -> None:
    axes = Axes.of(plant_with_rail())
    ours = Native(machine(), Store(tmp_path))
    same = Formulation(Axes.of(plant_with_rail()), ours).node("joints", "l").block
    assert Formulation(axes, ours).node("joints", "l").block is same
    longer = replace(axes.robot, arm=replace(axes.robot.arm, c2=np.nextafter(axes.robot.arm.c2, 1.0)))
    assert Formulation(replace(axes, robot=longer), ours).node("joints", "l").block is not same
    higher = replace(axes, upper=np.nextafter(axes.upper, 9.0))
    assert Formulation(higher, ours).node("joints", "l").block is not same


def test_only_data_has_an_exact_text() -> None:
    assert exact({"b": 1, "a": (2.0, None)}) == exact({"a": (2.0, None), "b": 1})
    assert exact(np.zeros(2)) != exact(np.zeros((1, 2)))
    assert exact(0.1 + 0.2) != exact(0.3)
    with pytest.raises(TypeError, match="function is no plain data"):
        exact(small)
