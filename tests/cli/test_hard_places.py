"""Places that refuse: full disks, rights, other file systems, other runs, clocks that go back. One line, exit code 2,
what was there is whole; or, where nothing is wrong, the same answer as ever."""

from __future__ import annotations

import hashlib
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from pathlib import Path
from time import sleep

import pytest
from fake_planner import CELL, TEXT, Planner

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.job.folder import add_to_folder, open_folder, read_summary
from trajopt_cli.runs import files
from trajopt_cli.runs.folder import read_run, write_run
from trajopt_cli.runs.record import Inputs, RunRecord

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses: [{name: start, at: start}, {name: side, by: [0, 0.02, 0, 0, 0, 0]}]
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
NOBODY = 65534


def tree(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def planned_change(folder: Path) -> None:
    """As if the plan had changed the program's text, by more than fits on a small disk."""
    record = json.loads((folder / "run.json").read_text())
    content = (folder / "program.mod").read_bytes() + b"! planned\n" * 20_000
    (folder / "program.mod").write_bytes(content)
    record["files"]["program.mod"] = hashlib.sha256(content).hexdigest()
    (folder / "run.json").write_text(json.dumps(record))


@pytest.fixture
def made(results: Path) -> Path:
    """The results of the tiny program, with a longer text."""
    planned_change(results)
    return results.absolute()


WRITING = {
    "optimize": ["optimize", "tiny.mod", "--output", "{place}/tiny"],
    "export joint": ["export", "joint", "{results}", "--output", "{place}/out.csv"],
    "export rapid": ["export", "rapid", "{results}", "--output", "{place}/out.mod"],
    "in place": ["export", "rapid", "{results}", "--in-place"],
    "compare runs": ["compare", "runs", "{results}", "{results}", "--report", "{place}/out.html"],
    "new": ["new", "{place}/fresh"],
    "robot add": ["robot", "add", "{robots}/irb140.urdf", "--name", "mine", "--output", "{place}"],
    "iiwa": ["iiwa", "segments", "task.yaml", "--output", "{place}/task"],
}


def command_for(name: str, results: Path, place: Path) -> list[str]:
    """What to run, with the user's program and the results of earlier runs where they are written over."""
    robots = Path(__file__).parents[2] / "robots"
    Path("task.yaml").write_text(TASK)
    for file in ("out.csv", "out.mod", "out.html"):
        (place / file).write_bytes(b"old")
    shutil.copytree(results, place / "tiny")
    if name == "in place":  # the program itself stands there
        shutil.copy("tiny.mod", place / "tiny.mod")
        Path("tiny.mod").unlink()
        Path("tiny.mod").symlink_to(place / "tiny.mod")
    return [part.format(place=place, results=results, robots=robots) for part in WRITING[name]]


def refused(code: int, said: str, word: str) -> None:
    assert code == 2
    lines = said.strip().splitlines()
    assert len(lines) == 1, said
    assert word in lines[0]


# ----------------------------------------------------------------------------------------------------------- full disks


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 8 MB."""
    place = tmp_path / "small"
    place.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=8m", "tmpfs", str(place)]
    if shutil.which("mount") is None or subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip("no file system can be mounted here")
    yield place
    subprocess.run(["umount", "-l", str(place)], check=True)


@pytest.mark.filterwarnings("error::pytest.PytestUnraisableExceptionWarning")  # Python would print it at the end
@pytest.mark.parametrize("name", WRITING)
def test_a_full_disk(name: str, made: Path, small_disk: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = small_disk
    command = command_for(name, made, place)
    capsys.readouterr()
    with open(place / "filling", "wb") as filling:
        free = os.statvfs(place)
        filling.write(b"\0" * (free.f_bavail * free.f_bsize))
    before = tree(place)
    refused(run([*command, "--quiet"]), capsys.readouterr().err, "cannot write: No space left on device")
    assert tree(place) == before


@pytest.mark.parametrize("name", WRITING)
def test_files_that_may_not_grow(name: str, made: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """A limit of the process's own: in the middle of a write."""
    place = tmp_path / "place"
    place.mkdir()
    command = command_for(name, made, place)
    before = tree(place)
    capfd.readouterr()

    def limited() -> int:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        sys.dont_write_bytecode = True  # Python would leave half of what it compiles now to all that come after
        resource.setrlimit(resource.RLIMIT_FSIZE, (300, 300))
        return run([*command, "--quiet"])

    code = in_child(limited)
    assert code == 2
    assert "File too large" in capfd.readouterr().err
    assert tree(place) == before


def in_child(call: Callable[[], int]) -> int:
    """Exit code of call in another process, which may lose its rights."""
    pid = os.fork()
    if pid:
        return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    code = 99
    try:
        code = call()
    finally:
        os._exit(code)


# --------------------------------------------------------------------------------------------------------------- rights


@pytest.fixture
def open_place() -> Iterator[Path]:
    """A folder that every user can reach."""
    place = Path(tempfile.mkdtemp(prefix="trajopt-test-"))
    place.chmod(0o755)
    yield place
    place.chmod(0o755)
    shutil.rmtree(place)


@pytest.mark.parametrize("name", [name for name in WRITING if name != "robot add"])
def test_no_right_to_write(
    name: str,
    made: Path,
    open_place: Path,
    monkeypatch: pytest.MonkeyPatch,
    planner: Planner,
    capfd: pytest.CaptureFixture[str],
) -> None:
    """As an ordinary user: root may write anywhere."""
    place, home = open_place / "place", open_place / "home"
    place.mkdir()
    home.mkdir()
    shutil.copytree(made, home / "made")
    monkeypatch.chdir(home)
    for file, text in (("tiny.mod", TEXT), ("tiny.yaml", CELL)):
        (home / file).write_text(text)
    command = command_for(name, home / "made", place)
    place.chmod(0o555)
    before = tree(place)
    capfd.readouterr()

    def ordinary() -> int:
        if os.geteuid() == 0:
            os.setgroups([])
            os.setegid(NOBODY)
            os.seteuid(NOBODY)
        return run([*command, "--quiet"])

    assert in_child(ordinary) == 2
    said = capfd.readouterr().err.strip().splitlines()
    assert len(said) == 1, said
    assert "Permission denied" in said[0]
    assert tree(place) == before


# ---------------------------------------------------------------------------------------------------------------- clock


def test_no_answer_rests_on_the_clock(
    made: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("tiny.mod", "tiny.yaml", *(str(path) for path in made.rglob("*"))):
        os.utime(name, (4.1e9, 4.1e9))  # in 2099
    commands = [
        ["verify", str(made)],
        ["export", "joint", str(made), "--output", "out.csv"],
        ["export", "rapid", str(made), "--in-place"],
        ["compare", "runs", str(made), str(made)],
        ["optimize", "tiny.mod"],
        ["verify", str(made)],
    ]
    for command in commands[:1]:
        assert run([*command, "--quiet"]) == 0
    before = {name: text for name, text in tree(made).items() if name == "summary.json"}

    class Past(datetime):
        @classmethod
        def now(cls, tz: object = None) -> datetime:
            return datetime(1970, 1, 2, tzinfo=UTC)

    monkeypatch.setattr("trajopt_cli.runs.folder.datetime", Past)
    monkeypatch.setattr("trajopt_cli.pipeline.optimize.datetime", Past)
    monkeypatch.setattr("time.time", lambda: -1e9)
    for command in commands:
        assert run([*command, "--quiet"]) == 0, capsys.readouterr().err
    assert json.loads((made / "run.json").read_text())["finished"].startswith("1970-01-02")
    assert {name: text for name, text in tree(made).items() if name == "summary.json"} == before
    assert json.loads((made / "run.json").read_text())["started"].startswith("1970-01-02")


# ---------------------------------------------------------------------------------------------------- other file system


@pytest.fixture
def elsewhere(tmp_path: Path) -> Iterator[Path]:
    """A folder on another file system than that of the tests."""
    memory = Path("/dev/shm")
    if not memory.is_dir() or not os.access(memory, os.W_OK) or memory.stat().st_dev == tmp_path.stat().st_dev:
        pytest.skip("there is no second file system")
    place = Path(tempfile.mkdtemp(dir=memory, prefix="trajopt-test-"))
    yield place
    shutil.rmtree(place)


@pytest.mark.parametrize("linked", [False, True])
def test_results_on_another_file_system(
    linked: bool, planner: Planner, program: Path, elsewhere: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if linked:  # the whole folder of results is a link to another disk, the program too
        Path("results").symlink_to(elsewhere)
        shutil.move("tiny.mod", elsewhere / "tiny.mod")
        Path("tiny.mod").symlink_to(elsewhere / "tiny.mod")
    folder = Path("results/tiny") if linked else elsewhere / "tiny"
    for _ in range(2):
        assert run(["optimize", str(program), "--output", str(folder), "--quiet"]) == 0, capsys.readouterr().err
    planned_change(folder)
    assert run(["verify", str(folder)]) == 0
    assert run(["export", "joint", str(folder), "--output", str(elsewhere / "out.csv")]) == 0
    assert run(["export", "rapid", str(folder), "--in-place"]) == 0
    assert Path("tiny.mod").read_bytes() == (folder / "program.mod").read_bytes()
    assert Path("tiny.mod").is_symlink() is linked
    assert not [path for path in elsewhere.rglob(".*")]


def test_a_place_that_something_is_mounted_on(made: Path, small_disk: Path, capsys: pytest.CaptureFixture[str]) -> None:
    refused(run(["optimize", "tiny.mod", "--output", str(small_disk), "--quiet"]), capsys.readouterr().err, "busy")
    assert tree(small_disk) == {}


# ----------------------------------------------------------------------------------------------------- two runs at once


class Note(RunRecord[dict[str, int]]):
    """The record of a folder that only this test makes."""

    KIND = "plan"


def test_runs_that_write_one_folder_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every folder that anybody meets is one run's, whole; the last one stays."""
    folder, rounds = tmp_path / "both", 40

    def write(who: int) -> int:
        for n in range(rounds):
            content = {f"{who}/{i}": f"{who} {n}".encode() * 100 for i in range(3)}
            write_run(folder, Note, content, "test", options={"who": who, "n": n}, inputs=Inputs())
        return 0

    def read() -> int:
        for _ in range(3 * rounds):
            if folder.exists():
                found = read_run(folder, Note)
                who, n = found.record.options["who"], found.record.options["n"]
                if set(found.contents.values()) != {f"{who} {n}".encode() * 100}:
                    return 3
            sleep(0.001)
        return 0

    pids = []
    for call in (lambda: write(1), lambda: write(2), read):
        pid = os.fork()
        if not pid:
            code = 4
            try:
                code = call()
            finally:
                os._exit(code)
        pids.append(pid)
    assert [os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) for pid in pids] == [0, 0, 0]
    assert read_run(folder, Note).record.options["n"] == rounds - 1
    assert [path.name for path in tmp_path.iterdir()] == ["both"]


def test_without_an_exchange_of_names_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(files, "_exchange", lambda one, other: False)
    folder = tmp_path / "both"
    pids = []
    for who in (b"1", b"2"):
        pid = os.fork()
        if not pid:
            code = 4
            try:
                for _ in range(60):
                    files.write_folder(folder, {"a": who, "b": who})
                code = 0
            finally:
                os._exit(code)
        pids.append(pid)
    assert [os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) for pid in pids] == [0, 0]
    assert tree(folder) in ({"a": b"1", "b": b"1"}, {"a": b"2", "b": b"2"})
    assert [path.name for path in tmp_path.iterdir()] == ["both"]


def test_two_commands_that_add_to_one_folder(program: Path) -> None:
    Path("task.yaml").write_text(TASK)
    assert run(["iiwa", "segments", "task.yaml", "--output", "out", "--quiet"]) == 0
    first, second = open_folder(Path("out")), open_folder(Path("out"))
    add_to_folder(first, {"one.csv": b"1"}, {"one": {}})
    with pytest.raises(InputError) as caught:
        add_to_folder(second, {"two.csv": b"2"}, {"two": {}})
    assert str(caught.value) == "out: another run has changed it meanwhile, and that stays; run this again"
    assert {"one", "two"} & set(read_summary(Path("out"))) == {"one"}
    assert Path("out/one.csv").read_bytes() == b"1"


def test_a_run_that_does_not_let_go_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import fcntl

    folder = tmp_path / "held"
    write_run(folder, Note, {}, "test", options={}, inputs=Inputs())
    handle = os.open(folder, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    monkeypatch.setattr(files, "PATIENCE", 0.1)
    before = tree(folder)
    with pytest.raises(InputError, match="held: another run is writing it; run this again when that has ended"):
        write_run(folder, Note, {}, "test", options={}, inputs=Inputs())
    os.close(handle)
    assert tree(folder) == before
    write_run(folder, Note, {}, "test", options={}, inputs=Inputs())
