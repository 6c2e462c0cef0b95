"""Files and folders are whole at every instant: a process is killed at each of its steps and the disk is looked at."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.runs import files

OLD = {"run.json": b"old", "input/a.mod": b"old module", "gone.csv": b"only in the old one"}
NEW = {"run.json": b"new", "input/a.mod": b"new module", "stream.csv": b"1,2\n"}

# Runs write_folder and dies, as by kill -9, before its n-th call that changes the disk.
KILLED = """
import os, shutil, sys
from pathlib import Path
from trajopt_cli.runs import files

left = int(sys.argv[2])

def deadly(function):
    def call(*args, **kwargs):
        global left
        left -= 1
        if left < 0:
            os._exit(9)
        return function(*args, **kwargs)
    return call

files.os.rename = deadly(os.rename)
files.os.fsync = deadly(os.fsync)
files.shutil.rmtree = deadly(shutil.rmtree)
files.fill = deadly(files.fill)
if sys.argv[3] == "two renames":
    files._exchange = lambda one, other: False
else:
    files._exchange = deadly(files._exchange)
files.write_folder(Path(sys.argv[1]), {"run.json": b"new", "input/a.mod": b"new module", "stream.csv": b"1,2\\n"})
print("done")
"""


def content(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def write(folder: Path, new: dict[str, bytes]) -> None:
    for name, data in new.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)


@pytest.mark.parametrize("way", ["exchange", "two renames"])
def test_a_folder_is_old_or_new_whenever_the_process_is_killed(tmp_path: Path, way: str) -> None:
    seen = set()
    for step in range(100):
        folder = tmp_path / str(step) / "cell"
        write(folder, OLD)
        command = [sys.executable, "-c", KILLED, str(folder), str(step), way]
        done = "done" in subprocess.run(command, capture_output=True, text=True, check=False).stdout
        if way == "two renames":  # the gap between the two renames is closed by whoever looks next
            files.recover(folder)
        found = content(folder)
        assert found in (OLD, NEW), f"killed before step {step}"
        seen.add(found == NEW)
        files.write_folder(folder, NEW)
        assert content(folder) == NEW
        assert [path.name for path in folder.parent.iterdir()] == ["cell"], f"left behind after step {step}"
        if done:
            break
    assert done
    assert seen == {True, False}


def test_this_machine_exchanges_names_in_one_step(tmp_path: Path) -> None:
    if sys.platform != "linux":
        pytest.skip("only Linux has the exchange")
    one, other = tmp_path / "one", tmp_path / "other"
    write(one, {"a": b"1"})
    write(other, {"a": b"2"})
    if not files._exchange(one, other):
        pytest.skip("this file system cannot exchange two names")
    assert (content(one), content(other)) == ({"a": b"2"}, {"a": b"1"})


def test_a_failure_while_writing_leaves_the_old_folder_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "cell"
    write(folder, OLD)

    def interrupted(file: object, data: bytes) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(files, "fill", interrupted)
    with pytest.raises(KeyboardInterrupt):
        files.write_folder(folder, NEW)
    assert content(folder) == OLD
    assert [path.name for path in tmp_path.iterdir()] == ["cell"]


def test_a_folder_another_process_is_writing_is_left_alone(tmp_path: Path) -> None:
    import fcntl

    busy = tmp_path / ".cell.trajopt-01234567"
    busy.mkdir()
    handle = os.open(busy, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    files.write_folder(tmp_path / "cell", NEW)
    assert busy.exists()
    os.close(handle)
    files.write_folder(tmp_path / "cell", NEW)
    assert not busy.exists()


def test_folders_that_are_not_ours_are_left_alone(tmp_path: Path) -> None:
    strangers = [".cell.trajopt-mine", ".other.trajopt-01234567", "cell.bak", ".cell"]
    for name in strangers:
        write(tmp_path / name, {"a": b"1"})
    files.write_folder(tmp_path / "cell", NEW)
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["cell", *strangers])


def test_a_file_is_old_or_new_and_leaves_nothing_beside_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "deep" / "joints.csv"
    files.write_file(path, b"old")
    files.write_file(path, b"new")
    assert path.read_bytes() == b"new"

    def broken(one: Path, other: Path) -> None:
        raise OSError(28, "No space left on device", str(other))

    monkeypatch.setattr(files.os, "replace", broken)
    with pytest.raises(InputError, match=r"joints\.csv: cannot write: No space left on device: .*/joints\.csv$"):
        files.write_file(path, b"newer")
    assert [p.name for p in path.parent.iterdir()] == ["joints.csv"]
    assert path.read_bytes() == b"new"


@pytest.mark.parametrize("next_call", [lambda path: files.write_file(path, b"new"), files.check_file])
def test_what_a_killed_export_left_goes_with_the_next(tmp_path: Path, next_call: Callable[[Path], None]) -> None:
    import fcntl

    path, left, busy = (tmp_path / name for name in ("a.csv", ".a.csv.trajopt-01234567", ".a.csv.trajopt-89abcdef"))
    strangers = [".b.csv.trajopt-01234567", ".a.csv.trajopt-mine", ".a.csv"]
    for one in (left, busy, *(tmp_path / name for name in strangers)):
        one.write_bytes(b"half")
    with open(busy, "rb") as living:
        fcntl.flock(living, fcntl.LOCK_EX)
        next_call(path)
        assert not left.exists()
        assert busy.exists()
    next_call(path)
    assert sorted(one.name for one in tmp_path.iterdir() if one != path) == sorted(strangers)


def test_a_file_is_old_or_new_whenever_the_process_is_killed(tmp_path: Path) -> None:
    seen = set()
    for step in range(50):
        path = tmp_path / str(step) / "a.csv"
        files.write_file(path, b"old")
        pid = os.fork()
        if not pid:
            code, left = 1, [step]

            def deadly(function: Callable[..., object], left: list[int] = left) -> Callable[..., object]:
                def call(*args: object, **kwargs: object) -> object:
                    left[0] -= 1
                    if left[0] < 0:
                        os._exit(9)
                    return function(*args, **kwargs)

                return call

            try:
                for name in ("replace", "fsync", "open"):
                    setattr(os, name, deadly(getattr(os, name)))
                files.fill = deadly(files.fill)  # type: ignore[assignment]
                files.locked = deadly(files.locked)  # type: ignore[assignment]
                files.write_file(path, b"new")
                code = 0
            finally:
                os._exit(code)
        done = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 0
        seen.add(path.read_bytes())
        files.write_file(path, b"newer")
        assert content(path.parent) == {"a.csv": b"newer"}, f"left behind after step {step}"
        if done:
            break
    assert done
    assert seen == {b"old", b"new"}


def test_a_place_that_cannot_be_written_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match=r"file/cell: cannot write: File exists: .*/file$"):
        files.write_folder(tmp_path / "file" / "cell", NEW)
