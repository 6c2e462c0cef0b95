"""Folders that somebody else has written, or nobody: one line for each, and nothing outside is read."""

from __future__ import annotations

import copy
import hashlib
import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.experiments.catalogue import ExperimentsRecord
from trajopt_cli.iiwa.job.folder import TaskRecord, TaskSummary, read_task_run, write_task_run
from trajopt_cli.iiwa.task.model import AngleMeaning, RotationLaw
from trajopt_cli.runs.folder import check_replaceable, read_run
from trajopt_cli.runs.record import InputFile, Inputs, RunRecord, as_json, sha256
from trajopt_cli.runs.results import PlanRecord

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
ANEW = "move the folder away and make it again"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A task's folder, whole."""
    place = tmp_path / "out"
    files = {"input/t.yaml": b"robot: iiwa7\n", "input/p.mod": b"MODULE p\n", "equilibrium.csv": b"t\n"}
    given = Inputs(
        task="input/t.yaml",
        program="input/p.mod",
        files=[
            InputFile(f"my/{name}", f"input/{name}", files[f"input/{name}"]).record() for name in ("t.yaml", "p.mod")
        ],
    )
    write_task_run(place, "iiwa segments", {"angles": "absolute"}, given, files, {"sequence": SEQUENCE})
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
    found = read_task_run(folder)
    record, given = found.record, found.record.inputs
    assert (given.task, given.program, record.options) == ("input/t.yaml", "input/p.mod", {"angles": "absolute"})
    assert [(one.path, one.place, one.rapid, one.module) for one in given.files] == [
        ("my/t.yaml", "input/t.yaml", None, False),
        ("my/p.mod", "input/p.mod", None, False),
    ]
    assert (record.kind, record.command, record.trajopt) == ("iiwa", "iiwa segments", __version__)
    assert set(found.contents) == {"input/t.yaml", "input/p.mod", "equilibrium.csv", "summary.json"}
    sequence = found.summary(TaskSummary).sequence
    assert (sequence.period_s, sequence.rotation, sequence.angles) == (0.001, RotationLaw.SLERP, AngleMeaning.ABSOLUTE)
    assert [(one.first, one.last, one.origin, one.goal, one.dwell) for one in sequence.pieces] == [
        (0, 5, "a", "b", False), (5, 5, "b", "b", True), (5, 9, "b", "c", False)
    ]  # fmt: skip
    assert sequence.rows == 10


def test_the_record_says_what_it_was_given_and_no_more(folder: Path) -> None:
    run = json.loads((folder / "run.json").read_text())
    assert list(run) == [
        "trajopt", "format", "kind", "command", "versions", "options", "inputs", "files", "finished",
    ]  # fmt: skip
    assert set(run["inputs"]) == {"task", "program", "files"}
    assert run["files"] == {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*")
        if path.is_file() and path.name != "run.json"
    }
    again = folder.parent / "again"
    found = read_task_run(folder)
    files = {name: content for name, content in found.contents.items() if name != "summary.json"}
    write_task_run(again, "iiwa segments", found.record.options, found.record.inputs, files, found.sections())
    other = json.loads((again / "run.json").read_text())
    assert {**other, "finished": ""} == {**run, "finished": ""}
    assert (again / "summary.json").read_bytes() == (folder / "summary.json").read_bytes()


def test_what_was_put_into_a_folder_meanwhile_is_not_lost(folder: Path) -> None:
    (folder / "mine.txt").write_text("kept")
    found, before = read_task_run(folder), (folder / "run.json").read_bytes()
    expected = f"{folder}: holds mine.txt, which trajopt did not write; move it away or choose another --output"
    assert said(lambda: write_task_run(folder, "x", {}, found.record.inputs, found.contents, {})) == expected
    assert ((folder / "mine.txt").read_text(), (folder / "run.json").read_bytes()) == ("kept", before)


def drop(name: str) -> Callable[[dict[str, Any]], None]:
    return lambda run: run.pop(name)


def put(name: str, value: object) -> Callable[[dict[str, Any]], None]:
    return lambda run: run.update({name: value})


def inputs(name: str, value: object) -> Callable[[dict[str, Any]], None]:
    return lambda run: run["inputs"].update({name: value})


def listed(name: str) -> Callable[[dict[str, Any]], None]:
    return lambda run: run["files"].update({name: "0" * 64})


@pytest.mark.parametrize(
    ("edit", "expected"),
    [
        (drop("trajopt"), f"{FOREIGN}: trajopt: is missing; {ANEW}"),
        (drop("files"), f"{FOREIGN}: files: is missing; {ANEW}"),
        (drop("inputs"), f"{FOREIGN}: inputs: is missing; {ANEW}"),
        (drop("options"), f"{FOREIGN}: options: is missing; {ANEW}"),
        (put("options", [1]), f"{FOREIGN}: options: needs an object, not [1]; {ANEW}"),
        (put("format", "1"), f"{FOREIGN}: format: needs a whole number, not 1; {ANEW}"),
        (put("format", True), f"{FOREIGN}: format: needs a whole number, not true; {ANEW}"),
        (put("format", None), f"{FOREIGN}: format: needs a whole number, not nothing; {ANEW}"),
        (put("format", 0), f"{FOREIGN}: format: needs a whole number above zero, not 0; {ANEW}"),
        (put("format", 2), "is of format 2; this trajopt reads up to 1"),
        (put("format", 10**400), "is of format a very large number; this trajopt reads up to 1"),
        (put("files", ["equilibrium.csv"]), f'{FOREIGN}: files: needs an object, not ["equilibrium.csv"]; {ANEW}'),
        (put("files", {"equilibrium.csv": 3}), f"{FOREIGN}: files.equilibrium.csv: needs text, not 3; {ANEW}"),
        (put("inputs", []), f"{FOREIGN}: inputs: needs an object, not []; {ANEW}"),
        (put("inputs", {}), f"{FOREIGN}: inputs.task: is missing; {ANEW}"),
        (inputs("task", 3), f"{FOREIGN}: inputs.task: needs text, not 3; {ANEW}"),
        (inputs("task", ["input/t.yaml"]), f"{FOREIGN}: inputs.task: needs text, not a list; {ANEW}"),
        (inputs("task", "../secret"), f'{FOREIGN}: inputs.task: "../secret" is not an input that files lists; {ANEW}'),
        (
            inputs("program", "/etc/hostname"),
            f'{FOREIGN}: inputs.program: "/etc/hostname" is not an input that files lists; {ANEW}',
        ),
        (inputs("program", []), f"{FOREIGN}: inputs.program: needs text, not a list; {ANEW}"),
        (
            inputs("task", "summary.json"),
            f'{FOREIGN}: inputs.task: "summary.json" is not an input that files lists; {ANEW}',
        ),
        (inputs("files", [3]), f"{FOREIGN}: inputs.files[0]: needs an object, not 3; {ANEW}"),
        (
            lambda run: run["inputs"]["files"][1].update(copy="input/t.yaml"),
            f'{FOREIGN}: inputs.files[1].copy: "input/t.yaml" is the place of another file, too; {ANEW}',
        ),
        (
            lambda run: run["inputs"]["files"][1].update(sha256="0"),
            f'{FOREIGN}: inputs.files[1].sha256: "0" is not the one that files lists; {ANEW}',
        ),
        (put("kind", ["iiwa"]), f"{FOREIGN}: kind: needs text, not a list; {ANEW}"),
        (
            put("kind", "x" * 300),
            'was written as an unknown kind, "' + "x" * 76 + "...; this needs a folder of iiwa segments",
        ),
        (put("kind", "plan"), "was made by trajopt optimize; this needs a folder of iiwa segments"),
        *(
            (listed(name), f"{FOREIGN}: files: {json.dumps(name)} is not a name inside the folder; {ANEW}")
            for name in ("../secret", "input/../../secret", "/etc/hostname", "", ".", "a\0b", "\ud800")
        ),
        (listed("n" * 300), "cannot read: File name too long"),
        (listed("gone.csv"), "cannot read: No such file or directory"),
        (listed("input"), "is not a file that trajopt wrote; make the folder again"),
        (lambda run: run["files"].pop("summary.json"), f'{FOREIGN}: files: "summary.json" is missing; {ANEW}'),
    ],
)
def test_a_run_record_of_any_content_is_one_line(
    folder: Path, edit: Callable[[dict[str, Any]], None], expected: str
) -> None:
    (folder.parent / "secret").write_text("s")
    change(folder, edit)
    assert said(lambda: read_task_run(folder)).endswith(f": {expected}")


@pytest.mark.parametrize(
    "text", [b"[" * 100_000, b"\xff", b"", b"[]", b'{"trajopt": ' + b"1" * 5000 + b"}", b"{}", b"null", b"\xed\xa0\x80"]
)
def test_a_run_record_that_is_no_record_is_one_line(folder: Path, text: bytes) -> None:
    (folder / "run.json").write_bytes(text)
    for call in (read_task_run, check_replaceable):
        assert said(lambda call=call: call(folder)).startswith(f"{folder / 'run.json'}: ")  # type: ignore[misc]


def test_nothing_behind_a_link_or_a_device_is_read(folder: Path) -> None:
    place, outside = folder / "equilibrium.csv", folder.parent / "outside.csv"
    os.replace(place, outside)
    place.symlink_to(outside)
    expected = f"{place}: is not a file that trajopt wrote; make the folder again"
    assert said(lambda: read_task_run(folder)) == expected
    place.unlink()
    os.mkfifo(place)
    assert said(lambda: read_task_run(folder)) == expected
    place.unlink()
    place.symlink_to(place)
    assert said(lambda: read_task_run(folder)) == expected


@pytest.mark.parametrize(
    ("kind", "command"),
    [(PlanRecord, "optimize"), (TaskRecord, "iiwa segments"), (ExperimentsRecord, "iiwa experiments")],
)
def test_a_folder_that_is_not_there_names_the_command_that_makes_it(
    tmp_path: Path, kind: type[RunRecord[Any]], command: str
) -> None:
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
    assert said(lambda: read_run(tmp_path / ("n" * 300), TaskRecord)).endswith("cannot read: File name too long")


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
    ("section", "wrong"),
    [
        ({}, "period_s: is missing"),
        (_with("period_s", value="0.001"), "period_s: needs a finite number, not 0.001"),
        (_with("period_s", value=True), "period_s: needs a finite number, not true"),
        (_with("period_s", value=0.0), "period_s: needs a number above zero, not 0.0"),
        (_with("period_s", value=float("nan")), "period_s: needs a finite number, not nan"),
        (_with("period_s", value=float("inf")), "period_s: needs a finite number, not inf"),
        (_with("period_s", value=10**400), "period_s: needs a finite number, not a number of about 401 digits"),
        (_with("rotation", value="euler"), "rotation: euler is not one of 'tait-bryan' or 'slerp'"),
        (_with("rotation", value=["slerp"]), "rotation: a list is not one of 'tait-bryan' or 'slerp'"),
        (_with("angles", value=None), "angles: nothing is not one of 'relative' or 'absolute'"),
        (_with("pieces", value=[]), "pieces: needs at least 1, not 0"),
        (_with("pieces", value={"first": 0}), "pieces: needs a list, not a section"),
        (_with("pieces", 0, value=[0, 5]), "pieces[0]: needs an object, not [0, 5]"),
        (_with("pieces", 0, "first", value=1), "pieces[0]: rows 1 to 5 do not go on from row 0"),
        (_with("pieces", 0, "first", value=-1), "pieces[0]: rows -1 to 5 do not go on from row 0"),
        (_with("pieces", 0, "first", value=False), "pieces[0].first: needs a whole number, not false"),
        (_with("pieces", 0, "last", value=4), "pieces[1]: rows 5 to 5 do not go on from row 4"),
        (_with("pieces", 0, "last", value=5.0), "pieces[0].last: needs a whole number, not 5.0"),
        (_with("pieces", 2, "last", value=4), "pieces[2]: rows 5 to 4 do not go on from row 5"),
        (_with("pieces", 2, "last", value=True), "pieces[2].last: needs a whole number, not true"),
        (_with("pieces", 1, "from", value=None), "pieces[1].from: needs text, not nothing"),
        (_with("pieces", 1, "to", value=3), "pieces[1].to: needs text, not 3"),
        (_with("pieces", 1, "dwell", value=0), "pieces[1].dwell: needs true or false, not 0"),
    ],
)
def test_a_sequence_that_trajopt_did_not_write_is_one_line(folder: Path, section: dict[str, Any], wrong: str) -> None:
    change_summary(folder, json.dumps({"sequence": section}).encode())
    found = read_task_run(folder)
    join = ": " if wrong.startswith("pieces[") and "rows" in wrong else "."
    expected = f"summary.json: is not what trajopt wrote: sequence{join}{wrong}; make the folder again"
    assert said(lambda: found.summary(TaskSummary)).endswith(expected)


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        (b"{}", "sequence: is missing"),
        (b'{"sequence": [1]}', "sequence: needs an object, not [1]"),
        (b'{"sequence": null}', "sequence: needs an object, not null"),
    ],
)
def test_a_summary_needs_its_sequence(folder: Path, text: bytes, wrong: str) -> None:
    change_summary(folder, text)
    expected = f"summary.json: is not what trajopt wrote: {wrong}; make the folder again"
    assert said(lambda: read_task_run(folder).summary(TaskSummary)).endswith(expected)


@pytest.mark.parametrize("text", [b"[]", b"{", b"[" * 100_000])
def test_a_summary_is_a_as_json(folder: Path, text: bytes) -> None:
    change_summary(folder, text)
    assert said(lambda: read_task_run(folder).sections()).startswith(f"{folder / 'summary.json'}: is not ")


def test_a_record_of_half_a_character_comes_back() -> None:
    content = {"name": "p\ud800\udc80", "ä": 1}
    written = as_json(content)
    assert json.loads(written.decode("utf-8")) == {"name": "p\U00010080", "ä": 1}  # the two halves make one
    assert json.loads(as_json({"name": "\ud800"}).decode("utf-8")) == {"name": "\ud800"}
    assert "ä" in written.decode("utf-8")
