"""What the system refuses is one line and exit code 2, and never covers what went wrong before."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.runs.files import write_file
from trajopt_cli.runs.transaction import replace_files


def refusal(number: int, path: Path | None = None) -> OSError:
    return OSError(number, os.strerror(number), *(() if path is None else (str(path),)))


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("more", [[], ["--json"]])
def test_an_output_that_cannot_be_written(program: Path, more: list[str]) -> None:
    command = [sys.executable, "-m", "trajopt_cli.cli", "parse", str(program.resolve()), *more]
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            command, stdout=full, stderr=subprocess.PIPE, text=True, cwd=Path(__file__).parents[2], check=False
        )
    assert (done.returncode, done.stderr) == (2, "cannot write the output: No space left on device\n")


def test_an_output_that_is_closed() -> None:
    command = ["sh", "-c", 'exec "$0" -m trajopt_cli.cli --version >&-', sys.executable]
    done = subprocess.run(command, stderr=subprocess.PIPE, text=True, cwd=Path(__file__).parents[2], check=False)
    assert (done.returncode, done.stderr) == (2, "cannot write the output: it is closed\n")


@pytest.mark.parametrize("command", [["parse"], ["optimize"], ["analyse"], ["compare", "baseline"], ["verify"]])
def test_a_name_that_is_too_long(program: Path, command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    name = "a" * 300 + ".mod"
    assert run([*command, name]) == 2
    said = capsys.readouterr().err
    assert said.startswith(name)
    assert said.endswith(": File name too long\n")
    assert run([*command, str(program), "--cell" if command != ["verify"] else "--program", name]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1


@contextmanager
def read_only() -> Iterator[None]:
    """A file system that lets nothing be made or removed, as Linux does: asked before whether there is the name."""
    opened, os_open = open, os.open

    def refuse_new(path: Any, mode: str = "r", *args: Any, **kwargs: Any) -> Any:
        if "x" in mode:
            raise refusal(errno.EROFS, path)
        return opened(path, mode, *args, **kwargs)

    def refuse_made(path: Any, flags: int, *args: Any) -> int:
        if flags & os.O_CREAT:
            raise refusal(errno.EROFS, path)
        return os_open(path, flags, *args)

    def unlink(path: Path, missing_ok: bool = False) -> None:
        raise refusal(errno.EROFS, path)

    with patch("builtins.open", refuse_new), patch("os.open", refuse_made), patch.object(Path, "unlink", unlink):
        yield


def test_a_read_only_disk_is_said_of_the_file_itself(tmp_path: Path) -> None:
    path = tmp_path / "m.mod"
    path.write_bytes(b"old")
    with read_only(), pytest.raises(InputError, match=r"m\.mod: cannot write: Read-only file system"):
        replace_files({path: (b"old", b"new")}, {})
    with read_only(), pytest.raises(InputError, match=r"n\.mod: cannot write: Read-only file system"):
        replace_files({}, {tmp_path / "n.mod": b"new"})
    with read_only(), pytest.raises(InputError) as caught:
        write_file(path, b"new")
    assert isinstance(caught.value.__cause__, OSError)
    assert isinstance(caught.value.__cause__.__context__, type(None))  # the refusal to write, not the one to tidy up
    assert [*tmp_path.iterdir()] == [path]


def test_a_full_disk_names_no_file_that_is_none(tmp_path: Path) -> None:
    def full(*_: object) -> None:
        raise refusal(errno.ENOSPC)

    with patch("trajopt_cli.runs.files.os.fsync", full), pytest.raises(InputError) as caught:
        write_file(tmp_path / "a", b"x")
    assert str(caught.value) == f"{tmp_path}/a: cannot write: No space left on device"
    assert [*tmp_path.iterdir()] == []
