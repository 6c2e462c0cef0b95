"""A place that cannot be written is told before anything is solved, by every command that writes."""

from __future__ import annotations

from pathlib import Path

import pytest
from fake_planner import Planner

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.runs.files import check_writable


@pytest.fixture
def places(program: Path, results: Path) -> Path:
    """Beside the program: results of it, and a folder that is somebody else's."""
    Path("mine").mkdir()
    Path("mine/notes.txt").write_text("precious")
    return program


@pytest.mark.parametrize(
    ("command", "option", "kind"),
    [
        (["optimize", "tiny.mod"], "--output", "folder"),
        (["sensitivity", "tiny.mod"], "--output", "folder"),
        (["place", "tiny.mod", "--what", "base", "--range", "x=0..1"], "--output", "folder"),
        (["place", "tiny.mod", "--what", "base", "--range", "x=0..1"], "--apply", "file"),
        (["compare", "baseline", "tiny.mod"], "--plots", "into"),
        (["compare", "baseline", "tiny.mod"], "--csv", "file"),
        (["iiwa", "segments", "task.yaml"], "--output", "folder"),
        (["iiwa", "experiments", "--engine", "spring"], "--output", "folder"),
    ],
)
def test_nothing_is_solved_for_a_place_that_cannot_be_written(
    places: Path,
    planner: Planner,
    command: list[str],
    option: str,
    kind: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def solve(*_: object, **__: object) -> None:
        raise AssertionError("it is solved")

    monkeypatch.setattr("trajopt_cli.iiwa.experiments.catalogue.bench_of", solve)
    monkeypatch.setattr("trajopt_cli.iiwa.job.segments.read_task", solve)
    bad = {"tiny.mod/below": "a file where a folder should be"}
    if Path("/proc").is_dir():
        bad["/proc/nowhere" if kind != "into" else "/proc"] = "a place of the system"
    if kind == "folder":
        bad["mine"] = "somebody's folder"
        bad["tiny.mod"] = "a file"
    before = sorted(Path().rglob("*"))
    for place, what in bad.items():
        assert run([*command, option, place]) == 2, what
        said = capsys.readouterr().err
        assert len(said.splitlines()) == 1, what
        assert place.split("/")[0] in said or "/proc" in said
    assert planner.asked == []
    assert sorted(Path().rglob("*")) == before


def test_a_folder_without_the_right_to_write_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(dir: Path) -> None:
        raise PermissionError(13, "Permission denied")

    check_writable(tmp_path / "new" / "deeper" / "file")
    assert [*tmp_path.iterdir()] == []
    monkeypatch.setattr("trajopt_cli.runs.files.TemporaryFile", refuse)
    with pytest.raises(InputError, match=r"new/file: cannot write: Permission denied"):
        check_writable(tmp_path / "new" / "file")
    monkeypatch.undo()
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="file: is a file, and no folder to write to"):
        check_writable(tmp_path / "file" / "below" / "it")
    with pytest.raises(InputError, match="file: is a file, and no folder to write to"):
        check_writable(tmp_path / "file", into=True)


@pytest.mark.parametrize("into", [False, True])
def test_the_root_of_the_file_system_is_no_place(into: bool) -> None:
    with pytest.raises(InputError, match="//: is the whole file system; choose a folder in it"):
        check_writable(Path("//"), into)
