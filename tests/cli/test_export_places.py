"""`trajopt export`: the list of formats, the example of each, and places that are looked at before any work."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import NoReturn

import pytest

from trajopt_cli.cli import app, run
from trajopt_cli.errors import InputError
from trajopt_cli.runs.files import check_file

KINDS = [command.name for group in app.registered_groups if group.name == "export" for command in
         group.typer_instance.registered_commands]  # fmt: skip


@pytest.fixture
def no_work(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def fail(*_: object) -> NoReturn:
        raise AssertionError("the results were read before the place was looked at")

    monkeypatch.setattr("trajopt_cli.exporters.recorded.recorded", fail)
    monkeypatch.chdir(tmp_path)


@pytest.mark.usefixtures("no_work")
@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "rapid"])
@pytest.mark.parametrize(
    ("place", "said"),
    [
        (".", ".: is a folder; --output names a file"),
        ("nowhere/x", "nowhere: is not a folder to write to; make it or correct --output"),
        ("/dev/null", "/dev/null: is no file; --output names one"),
        ("a" * 250, "a" * 250 + ": cannot write: File name too long"),
    ],
)
def test_a_place_that_cannot_be_is_one_line_before_any_work(
    kind: str, place: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["export", kind, "results/hinge_cell", "--output", place]) == 2
    assert capsys.readouterr().err == f"{said}\n"
    assert [*Path().iterdir()] == []


@pytest.mark.usefixtures("no_work")
def test_a_folder_that_may_not_be_written_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refuse(path: Path, *_: object) -> NoReturn:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))

    monkeypatch.setattr(
        "trajopt_cli.runs.files.open", refuse, raising=False
    )  # root, as whom tests often run, may write anywhere
    assert run(["export", "joint", "results/x", "--output", "x.csv"]) == 2
    assert capsys.readouterr().err == "x.csv: cannot write: Permission denied\n"


def test_a_file_of_another_results_folder_is_not_written_over(
    tmp_path: Path,
) -> None:
    other = tmp_path / "other"
    other.mkdir()
    (other / "run.json").write_text("{}")
    (other / "stream.csv").write_text("t\n")
    with pytest.raises(InputError, match="is a file of a results folder"):
        check_file(other / "stream.csv")
    check_file(other / "new.csv")
    assert (other / "stream.csv").read_text() == "t\n"
