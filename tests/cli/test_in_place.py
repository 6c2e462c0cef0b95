from __future__ import annotations

import hashlib
import json
import os
import shutil
import stat
import subprocess
from pathlib import Path

import pytest
from fake_planner import Planner

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.runs.transaction import replace_files

OLD, NEW = b"MODULE m\r\nENDMODULE", b"MODULE m\r\n! edited\r\nENDMODULE"


def tree(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


# --------------------------------------------------------------------------------------------------- the files alone


def test_all_files_change_and_the_old_ones_stay_beside_them(tmp_path: Path) -> None:
    one, two, same = (tmp_path / name for name in ("one.mod", "two.mod", "same.mod"))
    for path in (one, two, same):
        path.write_bytes(OLD)
    one.chmod(0o640)
    (tmp_path / "two.mod.bak").write_bytes(b"older")
    backups = replace_files({one: (OLD, NEW), two: (OLD, NEW), same: (OLD, OLD)}, {tmp_path / "new.mod": NEW})
    assert backups == {one: tmp_path / "one.mod.bak", two: tmp_path / "two.mod.bak2"}
    assert tree(tmp_path) == {
        "one.mod": NEW, "one.mod.bak": OLD, "two.mod": NEW, "two.mod.bak": b"older", "two.mod.bak2": OLD,
        "same.mod": OLD, "new.mod": NEW,
    }  # fmt: skip
    assert stat.S_IMODE(one.stat().st_mode) == stat.S_IMODE((tmp_path / "one.mod.bak").stat().st_mode) == 0o640


def test_a_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real/m.mod").write_bytes(OLD)
    (tmp_path / "m.mod").symlink_to("real/m.mod")
    replace_files({tmp_path / "m.mod": (OLD, NEW)}, {})
    assert (tmp_path / "m.mod").is_symlink()
    assert tree(tmp_path / "real") == {"m.mod": NEW, "m.mod.bak": OLD}


@pytest.mark.parametrize("fails", range(1, 5))
def test_what_fails_half_way_leaves_everything_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fails: int
) -> None:
    paths = [tmp_path / f"{i}.mod" for i in range(3)]
    for path in paths:
        path.write_bytes(OLD)
    before, real, calls = tree(tmp_path), os.replace, []

    def replace(source: Path, target: Path) -> None:
        calls.append(target)
        if len(calls) == fails:
            raise PermissionError(13, "Permission denied", str(target))
        real(source, target)

    monkeypatch.setattr("trajopt_cli.runs.files.os.replace", replace)
    change = {path: (OLD, NEW) for path in paths}
    if fails > len(paths):
        replace_files(change, {})
        return
    with pytest.raises(InputError, match=rf"{fails - 1}\.mod: cannot write: Permission denied"):
        replace_files(change, {tmp_path / "new.mod": NEW})
    assert tree(tmp_path) == before


def test_a_new_file_replaces_nothing(tmp_path: Path) -> None:
    for name in ("m.mod", "new.mod"):
        (tmp_path / name).write_bytes(OLD)
    before = tree(tmp_path)
    with pytest.raises(InputError, match=r"new\.mod: cannot write: File exists"):
        replace_files({tmp_path / "m.mod": (OLD, NEW)}, {tmp_path / "new.mod": NEW})
    with pytest.raises(InputError, match=r"m\.mod: is not what it was any more; nothing is written"):
        replace_files({tmp_path / "m.mod": (NEW, NEW)}, {})
    assert tree(tmp_path) == before


# ----------------------------------------------------------------------------------------------------- the command


def edited() -> bytes:
    """Results of the tiny program as if the plan had changed a line of it."""
    content = Path("results/tiny", "program.mod").read_bytes().replace(b"j_side:=[[20,", b"j_side:=[[20.5,")
    recorded({"program.mod": content})
    return content


def recorded(files: dict[str, bytes]) -> None:
    """Put files into the results of the tiny program as if the run had written them."""
    folder = Path("results/tiny")
    record = json.loads((folder / "run.json").read_text())
    for name, content in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)
        record["files"][name] = hashlib.sha256(content).hexdigest()
    (folder / "run.json").write_text(json.dumps(record))


def test_in_place_writes_over_the_users_own_file(
    program: Path, results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given, content = program.read_bytes(), edited()
    capsys.readouterr()
    assert run(["export", "rapid", "results/tiny", "--in-place"]) == 0
    assert capsys.readouterr().out.startswith("wrote tiny.mod (RAPID plan, ")
    assert (program.read_bytes(), Path("tiny.mod.bak").read_bytes()) == (content, given)
    assert run(["export", "rapid", "results/tiny", "--in-place"]) == 2
    said = "tiny.mod: is not the file that the results were made from (that is kept as tiny.mod.bak); run trajopt"
    assert capsys.readouterr().err == f"{said} optimize again\n"


def test_in_place_refuses_a_file_that_is_not_the_one_it_was_made_from(
    program: Path, results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edited()
    program.write_bytes(program.read_bytes() + b"! later\n")
    before = tree(Path())
    capsys.readouterr()
    assert run(["export", "rapid", "results/tiny", "--in-place"]) == 2
    said = "tiny.mod: is not the file that the results were made from; run trajopt optimize again"
    assert said in capsys.readouterr().err
    assert tree(Path()) == before


@pytest.mark.skipif(shutil.which("patch") is None, reason="the patch command is not there")
def test_the_printed_diff_can_be_applied(
    planner: Planner, program: Path, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    program.write_bytes(program.read_text().replace("MODULE Tiny", "MODULE Tiny ! Tür").encode("cp1252"))
    program.write_bytes(program.read_bytes().replace(b"\n", b"\r\n"))
    assert run(["optimize", str(program), "--quiet"]) == 0
    content = edited()
    capfdbinary.readouterr()
    assert run(["export", "rapid", "results/tiny", "--diff"]) == 0
    subprocess.run(["patch", "-p1", "--fuzz=0"], input=capfdbinary.readouterr().out, check=True, capture_output=True)
    assert program.read_bytes() == content
