"""Folders that somebody else has written, or nobody: one line for each, and nothing outside is read."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from trajopt_cli.compliance.job.task_folder import SequenceRecord, read_task_folder, sequence_of, write_task_folder
from trajopt_cli.errors import InputError
from trajopt_cli.runs.folder import EXPERIMENTS, PLAN, TASK, check_replaceable, read_run, record, sha256

SEQUENCE = {
    "period_s": 0.001,
    "rotation": "slerp",
    "angles": "absolute",
    "pieces": [
        {"first": 0, "last": 5, "from": "a", "to": "b", "dwell": False},
        {"first": 5, "last": 5, "from": "b", "to": "b", "dwell": True},
        {"first": 5, "last": 9, "from": "b", "to": "c", "dwell": False},
    ],
}
FOREIGN = "was not written by trajopt"
CHANGED = "summary.json: is not what trajopt wrote; make the folder again"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A task's folder, whole."""
    place = tmp_path / "out"
    files = {"input/t.yaml": b"robot: iiwa7\n", "input/p.mod": b"MODULE p\n", "equilibrium.csv": b"t\n"}
    write_task_folder(place, files, {"sequence": SEQUENCE}, "input/t.yaml", "input/p.mod", {"command": "segments"})
    return place


def change(folder: Path, edit: Callable[[dict[str, Any]], None]) -> None:
    """run.json after edit."""
    run = json.loads((folder / "run.json").read_text())
    edit(run)
    (folder / "run.json").write_text(json.dumps(run))


def change_summary(folder: Path, content: bytes) -> None:
    """summary.json of another content, and listed so."""
    (folder / "summary.json").write_bytes(content)
    change(folder, lambda run: run["files"].update({"summary.json": sha256(content)}))


def said(call: Callable[[], object]) -> str:
    with pytest.raises(InputError) as caught:
        call()
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_a_folder_comes_back(folder: Path) -> None:
    found = read_task_folder(folder)
    assert (found.task, found.program, dict(found.options)) == ("input/t.yaml", "input/p.mod", {"command": "segments"})
    assert set(found.files) == {"input/t.yaml", "input/p.mod", "equilibrium.csv"}
    pieces = ((0, 5, "a", "b", False), (5, 5, "b", "b", True), (5, 9, "b", "c", False))
    assert sequence_of(found) == SequenceRecord(0.001, "slerp", "absolute", pieces)
    assert sequence_of(found).rows == 10


def drop(name: str) -> Callable[[dict[str, Any]], None]:
    return lambda run: run.pop(name)


def put(name: str, value: object) -> Callable[[dict[str, Any]], None]:
    return lambda run: run.update({name: value})


def listed(name: str) -> Callable[[dict[str, Any]], None]:
    return lambda run: run["files"].update({name: "0" * 64})


@pytest.mark.parametrize(
    ("edit", "expected"),
    [
        (drop("files"), FOREIGN),
        (drop("inputs"), FOREIGN),
        (drop("options"), FOREIGN),
        (put("options", [1]), FOREIGN),
        (put("format", "1"), FOREIGN),
        (put("format", True), FOREIGN),
        (put("format", None), FOREIGN),
        (put("format", 0), FOREIGN),
        (put("format", 2), "is of format 2; this trajopt reads up to 1"),
        (put("format", 10**400), "is of format a very large number; this trajopt reads up to 1"),
        (put("files", ["equilibrium.csv"]), FOREIGN),
        (put("files", {"equilibrium.csv": 3}), f'{FOREIGN}: its files have "equilibrium.csv"'),
        (put("inputs", []), FOREIGN),
        (put("inputs", {}), FOREIGN),
        (put("inputs", {"task": 3, "program": None}), FOREIGN),
        (put("inputs", {"task": ["input/t.yaml"], "program": None}), FOREIGN),
        (put("inputs", {"task": "../secret", "program": None}), FOREIGN),
        (put("inputs", {"task": "input/t.yaml", "program": "/etc/hostname"}), FOREIGN),
        (put("inputs", {"task": "input/t.yaml", "program": []}), FOREIGN),
        (put("inputs", {"task": "summary.json", "program": None}), FOREIGN),
        (put("kind", ["iiwa"]), FOREIGN),
        (
            put("kind", "x" * 300),
            'was written as an unknown kind, "' + "x" * 76 + "...; this needs a folder of iiwa segments",
        ),
        (put("kind", "plan"), "was made by trajopt optimize; this needs a folder of iiwa segments"),
        (listed("../secret"), f'{FOREIGN}: its files have "../secret"'),
        (listed("input/../../secret"), f'{FOREIGN}: its files have "input/../../secret"'),
        (listed("/etc/hostname"), f'{FOREIGN}: its files have "/etc/hostname"'),
        (listed(""), f'{FOREIGN}: its files have ""'),
        (listed("."), f'{FOREIGN}: its files have "."'),
        (listed("a\0b"), f'{FOREIGN}: its files have "a\\u0000b"'),
        (listed("\ud800"), f'{FOREIGN}: its files have "\\ud800"'),
        (listed("n" * 300), "cannot read: File name too long"),
        (listed("gone.csv"), "cannot read: No such file or directory"),
        (listed("input"), "is not a file that trajopt wrote; make the folder again"),
        (lambda run: run["files"].pop("summary.json"), FOREIGN),
    ],
)
def test_a_run_record_of_any_content_is_one_line(
    folder: Path, edit: Callable[[dict[str, Any]], None], expected: str
) -> None:
    (folder.parent / "secret").write_text("s")
    change(folder, edit)
    assert said(lambda: read_task_folder(folder)).endswith(f": {expected}")


@pytest.mark.parametrize(
    "text", [b"[" * 100_000, b"\xff", b"", b"[]", b'{"trajopt": ' + b"1" * 5000 + b"}", b"{}", b"null", b"\xed\xa0\x80"]
)
def test_a_run_record_that_is_no_record_is_one_line(folder: Path, text: bytes) -> None:
    (folder / "run.json").write_bytes(text)
    for call in (read_task_folder, check_replaceable):
        assert said(lambda call=call: call(folder)).startswith(f"{folder / 'run.json'}: ")  # type: ignore[misc]


def test_nothing_behind_a_link_or_a_device_is_read(folder: Path) -> None:
    place, outside = folder / "equilibrium.csv", folder.parent / "outside.csv"
    os.replace(place, outside)
    place.symlink_to(outside)
    expected = f"{place}: is not a file that trajopt wrote; make the folder again"
    assert said(lambda: read_task_folder(folder)) == expected
    place.unlink()
    os.mkfifo(place)
    assert said(lambda: read_task_folder(folder)) == expected
    place.unlink()
    place.symlink_to(place)
    assert said(lambda: read_task_folder(folder)).startswith(f"{place}: cannot read: ")


@pytest.mark.parametrize(
    ("kind", "command"), [(PLAN, "optimize"), (TASK, "iiwa segments"), (EXPERIMENTS, "iiwa experiments")]
)
def test_a_folder_that_is_not_there_names_the_command_that_makes_it(tmp_path: Path, kind: str, command: str) -> None:
    expected = f"none: does not exist; make it with trajopt {command}"
    assert said(lambda: read_run(tmp_path / "none", kind)).endswith(expected)
    (tmp_path / "file").write_text("")
    assert "file/x: does not exist" in said(lambda: read_run(tmp_path / "file" / "x", kind))
    assert said(lambda: read_run(tmp_path / "file", kind)).endswith("is not a results folder of trajopt (no run.json)")
    assert said(lambda: read_run(tmp_path, kind)).endswith("is not a results folder of trajopt (no run.json)")


@pytest.mark.parametrize("length", [250, 300])
def test_a_name_too_long_is_said_before_the_work(tmp_path: Path, length: int) -> None:
    place = tmp_path / ("n" * length)
    assert said(lambda: check_replaceable(place)) == f"{place}: cannot write: File name too long"
    inner = tmp_path / ("n" * 300) / "out"
    assert said(lambda: check_replaceable(inner)) == f"{inner}: cannot write: File name too long"
    assert said(lambda: read_run(tmp_path / ("n" * 300), TASK)).endswith("cannot read: File name too long")


def test_a_large_foreign_folder_is_refused_at_its_first_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "empty").mkdir()
    check_replaceable(tmp_path)
    for i in range(20):
        (tmp_path / f"{i}.txt").write_text("")
    looked, is_dir = list[Path](), Path.is_dir

    def look(path: Path) -> bool:
        looked.append(path)
        return is_dir(path)

    monkeypatch.setattr(Path, "is_dir", look)
    assert "(no run.json) and is not replaced" in said(lambda: check_replaceable(tmp_path))
    assert len(looked) < 20


def _with(*path: str | int, value: object) -> dict[str, Any]:
    section = copy.deepcopy(SEQUENCE)
    node: Any = section
    for part in path[:-1]:
        node = node[part]
    node[path[-1]] = value
    return section


@pytest.mark.parametrize(
    "section",
    [
        {},
        _with("period_s", value="0.001"),
        _with("period_s", value=True),
        _with("period_s", value=0.0),
        _with("period_s", value=float("nan")),
        _with("period_s", value=float("inf")),
        _with("period_s", value=10**400),
        _with("rotation", value="euler"),
        _with("rotation", value=["slerp"]),
        _with("angles", value=None),
        _with("pieces", value=[]),
        _with("pieces", value={"first": 0}),
        _with("pieces", 0, value=[0, 5, "a", "b", False]),
        _with("pieces", 0, "first", value=1),
        _with("pieces", 0, "first", value=-1),
        _with("pieces", 0, "first", value=False),
        _with("pieces", 0, "last", value=4),
        _with("pieces", 0, "last", value=5.0),
        _with("pieces", 2, "last", value=4),
        _with("pieces", 2, "last", value=True),
        _with("pieces", 1, "from", value=None),
        _with("pieces", 1, "to", value=3),
        _with("pieces", 1, "dwell", value=0),
    ],
)
def test_a_sequence_that_trajopt_did_not_write_is_one_line(folder: Path, section: dict[str, Any]) -> None:
    change_summary(folder, json.dumps({"sequence": section}).encode())
    found = read_task_folder(folder)
    assert said(lambda: sequence_of(found)).endswith(CHANGED)


@pytest.mark.parametrize("text", [b"{}", b'{"sequence": [1]}', b'{"sequence": null}'])
def test_a_summary_needs_its_sequence(folder: Path, text: bytes) -> None:
    change_summary(folder, text)
    assert said(lambda: read_task_folder(folder)).endswith(CHANGED)


@pytest.mark.parametrize("text", [b"[]", b"{", b"[" * 100_000])
def test_a_summary_is_a_record(folder: Path, text: bytes) -> None:
    change_summary(folder, text)
    assert said(lambda: read_task_folder(folder)).startswith(f"{folder / 'summary.json'}: is not ")


def test_a_record_of_half_a_character_comes_back() -> None:
    content = {"name": "p\ud800\udc80", "ä": 1}
    written = record(content)
    assert json.loads(written.decode("utf-8")) == {"name": "p\U00010080", "ä": 1}  # the two halves make one
    assert json.loads(record({"name": "\ud800"}).decode("utf-8")) == {"name": "\ud800"}
    assert "ä" in written.decode("utf-8")
