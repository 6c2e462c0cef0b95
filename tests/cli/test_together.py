"""Files that change together: all of them or none, killed at every step and at random moments; and what a journal that
somebody else wrote can do, which is nothing outside its folder."""

from __future__ import annotations

import hashlib
import json
import os
import random
import signal
import sys
from pathlib import Path
from time import sleep
from typing import Any

import pytest
from killed import dying_at, killed_at

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.runs import transaction
from trajopt_cli.runs.results import RapidModule, write_in_place
from trajopt_cli.runs.transaction import JOURNAL, put_back, replace_files, write_files

MODULE = "MODULE {0}\n PROC {0}_go()\n ENDPROC\nENDMODULE\n"


def tree(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.fixture
def modules(tmp_path: Path) -> dict[str, Any]:
    """Three modules in two folders, one of them behind a link and one that stays as it is, and a new one."""
    root = tmp_path / "cell"
    for name in ("prog/main", "prog/same", "sys/base"):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / f"{name}.mod").write_text(MODULE.format(Path(name).name) * 50)
    (root / "prog/main.mod.bak").write_text("somebody's")
    (root / "link.mod").symlink_to("sys/base.mod")
    given = {path: path.read_bytes() for path in (root / "prog/main.mod", root / "prog/same.mod", root / "link.mod")}
    wanted = {path: (old, old if path.stem == "same" else old + b"! new\n") for path, old in given.items()}
    return {"root": root, "wanted": wanted, "added": {root / "prog/flat.mod": b"MODULE flat\nENDMODULE\n"}}


def fresh(modules: dict[str, Any], tmp_path: Path, name: str) -> tuple[Path, dict[Path, Any], dict[Path, bytes]]:
    """The same in a folder of its own."""
    import shutil

    root = tmp_path / name
    shutil.copytree(modules["root"], root, symlinks=True)
    moved = [{root / path.relative_to(modules["root"]): what for path, what in modules[key].items()}
             for key in ("wanted", "added")]  # fmt: skip
    return root, moved[0], moved[1]


def test_all_or_none_whenever_the_process_is_killed(modules: dict[str, Any], tmp_path: Path) -> None:
    old, rng = tree(modules["root"]), random.Random(1)
    root, wanted, added = fresh(modules, tmp_path, "whole")
    replace_files(wanted, added)
    new = tree(root)
    assert new.keys() - old.keys() == {"prog/main.mod.bak2", "sys/base.mod.bak", "prog/flat.mod"}
    seen, told = set(), 0
    for step in range(300):
        root, wanted, added = fresh(modules, tmp_path, str(step))
        done = killed_at(step, replace_files, wanted, added)
        files = [*wanted, *added]
        for _ in range(rng.randrange(3)):  # the next run is killed, too
            killed_at(rng.randrange(25), put_back, files)
        told += bool(put_back(files))
        found = tree(root)
        if not done and found.keys() - old.keys() == {JOURNAL}:  # killed before it said a word: the next to write
            replace_files(wanted, added)
            assert tree(root) == new
            continue
        assert found in (old, new), f"killed before step {step}"
        seen.add(found == new)
        if done:
            break
    assert done
    assert seen == {True, False}
    assert told


def test_a_journal_that_says_done_too_early_is_taken_back_first(modules: dict[str, Any]) -> None:
    """The disk fills up as the end is noted; the process is killed while it undoes everything."""
    old = tree(modules["root"])

    def done(journal: transaction._Journal) -> None:
        journal._append(transaction._DONE)
        raise OSError(28, os.strerror(28))

    def change() -> None:
        transaction._Journal.done = done  # type: ignore[method-assign]
        transaction._undo = undo_one  # type: ignore[assignment]
        replace_files(modules["wanted"], modules["added"])

    whole_undo, undone = transaction._undo, 0

    def undo_one(*args: Any) -> bool:
        nonlocal undone
        undone += 1
        if undone > 1:
            os._exit(9)
        return whole_undo(*args)

    assert not dying_at(10_000, change)
    assert tree(modules["root"]) != old
    assert put_back([*modules["wanted"], *modules["added"]])
    assert tree(modules["root"]) == old


def test_files_written_together_leave_nothing_beside_them(tmp_path: Path) -> None:
    drawn = {"a.svg": b"<svg/>" * 100, "b.svg": b"<svg></svg>" * 100, "c.svg": b"new"}
    for step in range(200):
        folder = tmp_path / str(step)
        write_files(folder, {"a.svg": b"1", "b.svg": b"2"})
        old = tree(folder)
        done = killed_at(step, write_files, folder, drawn)
        put_back(folder / name for name in drawn)
        assert {name: text for name, text in tree(folder).items() if name[0] != "."} in (old, drawn)
        write_files(folder, drawn | {"c.svg": b"newer"})
        assert tree(folder) == drawn | {"c.svg": b"newer"}, f"killed before step {step}"
        if done:
            break
    assert done


def test_random_kills_from_outside(modules: dict[str, Any], tmp_path: Path) -> None:
    rng, seen = random.Random(2), set()
    for round_ in range(10):
        root, wanted, _ = fresh(modules, tmp_path, str(round_))
        pid = os.fork()
        if not pid:
            try:
                while True:  # to and fro; the backups go, so that there are two states
                    for path in replace_files(wanted, {}).values():
                        path.unlink()
                    wanted = {path: (new, old) for path, (old, new) in wanted.items()}
            finally:
                os._exit(1)
        sleep(rng.uniform(0.0, 0.03))
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        put_back(wanted)
        found = [path.read_bytes() for path in wanted]
        states = [[pair[k] for pair in wanted.values()] for k in (0, 1)]
        assert found in states
        seen.add(found == states[0])
        assert not [name for name in tree(root) if ".trajopt-" in name]
    assert seen


def test_the_next_command_says_so_and_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    paths = [tmp_path / f"{name}.mod" for name in ("one", "two", "three")]
    modules = []
    for path in paths:
        old = MODULE.format(path.stem).encode()
        path.write_bytes(old)
        modules.append(RapidModule(path, Path(path.name), old + b"! planned\n", old))
    before = tree(tmp_path)
    steps = 0
    while not any(path.read_bytes().endswith(b"planned\n") for path in paths):
        put_back(paths)
        assert not killed_at(steps, write_in_place, modules)
        steps += 1
    assert tree(tmp_path) != before
    assert run(["parse", *map(str, paths), "--entry", "one_go"]) == 0
    said = capsys.readouterr().err
    assert said == f"{tmp_path}: a run that wrote here was killed half-way; put back as before it: one.mod\n"
    assert tree(tmp_path) == before
    assert len(write_in_place(modules)) == 3


def test_a_run_that_is_at_it_is_waited_for_and_then_said(
    modules: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    ready, go = os.pipe()
    pid = os.fork()
    if not pid:
        try:
            transaction.sync = lambda folder: (os.write(go, b"."), sleep(30)) if folder.name == "sys" else None
            replace_files(modules["wanted"], {})
        finally:
            os._exit(1)
    os.read(ready, 1)
    before = tree(modules["root"])
    monkeypatch.setattr(transaction, "PATIENCE", 0.1)
    with pytest.raises(InputError, match=r"cell: another run is writing here; run this again when it has ended"):
        put_back(modules["wanted"])
    with pytest.raises(InputError, match="another run is writing here"):
        replace_files({}, {modules["root"] / "x.mod": b"x"})
    assert tree(modules["root"]) == before
    os.kill(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
    assert put_back(modules["wanted"])


def killed_once_main_is_new(modules: dict[str, Any]) -> tuple[Path, dict[Path, Any], Path]:
    """The folder, what was to change, and main.mod, which has changed when the process was killed."""
    root, wanted = modules["root"], modules["wanted"]
    main = root / "prog/main.mod"
    steps = 0
    while main.read_bytes() == wanted[main][0]:
        put_back(wanted)
        killed_at(steps, replace_files, wanted, {})
        steps += 1
    return root, wanted, main


def test_what_the_user_changed_meanwhile_stays(modules: dict[str, Any]) -> None:
    root, wanted, main = killed_once_main_is_new(modules)
    main.write_bytes(b"the user's own\n")
    put_back(wanted)
    assert main.read_bytes() == b"the user's own\n"
    assert (root / "prog/main.mod.bak2").read_bytes() == wanted[main][0]
    assert not (root / JOURNAL).exists()


def test_what_cannot_be_put_back_says_how_to_go_on(modules: dict[str, Any]) -> None:
    root, wanted, _ = killed_once_main_is_new(modules)
    (root / "prog/main.mod.bak2").write_bytes(b"another")
    with pytest.raises(InputError) as error:
        put_back(wanted)
    kept = "main.mod.bak2 does not hold what it was; to keep the files as they are, remove"
    assert str(error.value).endswith(f"{kept} {root / JOURNAL}")
    (root / JOURNAL).unlink()
    assert put_back(wanted) == []


def digest(text: bytes) -> str:
    return hashlib.sha256(text).hexdigest()


@pytest.mark.parametrize("done", [False, True])
@pytest.mark.parametrize(
    "change",
    [
        {"name": "../victim", "part": "../.victim.trajopt-00000000.new", "backup": "../victim.bak"},
        {"name": "{outside}/victim", "part": "x", "backup": "{outside}/victim.bak"},
        {"name": "out/victim", "part": "out/.victim.trajopt-00000000.new", "backup": "out/victim.bak"},
        {"name": "m.mod", "part": "../victim", "backup": "m.mod.bak"},
        {"name": "m.mod", "part": "precious", "backup": "m.mod.bak"},
        {"name": "m.mod", "part": ".m.mod.trajopt-00000000.new", "backup": "../victim"},
        {"name": "m.mod", "part": ".m.mod.trajopt-00000000.new", "backup": "precious"},
    ],
)
def test_a_journal_of_somebody_else_reaches_nothing_outside(tmp_path: Path, change: dict[str, str], done: bool) -> None:
    outside, folder = tmp_path / "outside", tmp_path / "outside/given"
    folder.mkdir(parents=True)
    (outside / "victim").write_bytes(b"new")
    (outside / "victim.bak").write_bytes(b"old")
    (folder / "m.mod").write_bytes(b"new")
    (folder / "m.mod.bak").write_bytes(b"old")
    (folder / "precious").write_bytes(b"old")
    (folder / "out").symlink_to(outside)
    said = {key: text.replace("{outside}", str(outside)) for key, text in change.items()}
    files = [{"was": digest(b"old"), "becomes": digest(b"new"), **said}]
    (folder / JOURNAL).write_text(json.dumps({"files": files}) + "\n" + ("done\n" if done else ""))
    before = tree(tmp_path)
    with pytest.raises(InputError, match=r"is no journal of trajopt's: .*; remove it"):
        put_back([folder / "m.mod", folder / said["name"]])
    assert tree(tmp_path) == before


def test_added_files_go_only_where_they_are_the_ones_that_were_added(tmp_path: Path) -> None:
    (tmp_path / "mine.mod").write_bytes(b"mine")
    change = {"name": "mine.mod", "was": None, "becomes": digest(b"theirs"), "backup": None,
              "part": ".mine.mod.trajopt-00000000.new"}  # fmt: skip
    (tmp_path / JOURNAL).write_text(json.dumps({"files": [change]}) + "\n")
    assert put_back([tmp_path / "mine.mod"]) == []
    assert tree(tmp_path) == {"mine.mod": b"mine"}


@pytest.mark.parametrize(
    "text", [b"", b"{", b"[]\n", b'{"files": 3}\n', b'{"files": [{}]}\n', b"\0" * 100, b"[" * 9999]
)
def test_a_damaged_journal_is_none(tmp_path: Path, text: bytes) -> None:
    path = tmp_path / "m.mod"
    path.write_bytes(b"old")
    (tmp_path / JOURNAL).write_bytes(text)
    replace_files({path: (b"old", b"new")}, {})
    assert tree(tmp_path) == {"m.mod": b"new", "m.mod.bak": b"old"}


@pytest.mark.skipif(sys.platform == "win32", reason="no pipes with names")
@pytest.mark.parametrize("kind", ["pipe", "folder", "link"])
def test_something_else_of_that_name_is_said(tmp_path: Path, kind: str) -> None:
    path, journal = tmp_path / "m.mod", tmp_path / JOURNAL
    path.write_bytes(b"old")
    if kind == "pipe":
        os.mkfifo(journal)
    elif kind == "folder":
        journal.mkdir()
    else:
        journal.symlink_to("m.mod")
    assert put_back([path]) == []
    with pytest.raises(InputError, match=r"\.trajopt-unfinished: .*remove it"):
        replace_files({path: (b"old", b"new")}, {})
    assert path.read_bytes() == b"old"
