"""A results folder is what the run wrote, file by file, or it is refused in one line."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.runs.results import read_results

FOLDER = Path("results/tiny")
READERS = (
    ["export", "rapid", "results/tiny", "--output", "o.mod"],
    ["export", "rapid", "results/tiny", "--in-place"],
    ["export", "rapid", "results/tiny", "--diff"],
    ["export", "joint", "results/tiny", "--output", "o.csv"],
    ["verify", "results/tiny"],
    ["compare", "baseline", "results/tiny"],
)


def test_every_file_is_held_by_every_reader(results: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given = Path("tiny.mod").read_bytes()
    for name in json.loads((results / "run.json").read_text())["files"]:
        content = (results / name).read_bytes()
        (results / name).write_bytes(content + b" ")
        for command in READERS if name == "program.mod" else READERS[:1]:
            capsys.readouterr()
            assert run(command) == 2
            expected = f"results/tiny/{name}: was changed since the run; run trajopt optimize again\n"
            assert capsys.readouterr().err == expected
        (results / name).write_bytes(content)
    read_results(results)
    assert Path("tiny.mod").read_bytes() == given
    assert not Path("o.mod").exists()
    assert not Path("o.csv").exists()


@pytest.mark.parametrize("name", ["program.mod", "input/tiny.mod", "input/tiny.yaml", "rapid.csv", "summary.json"])
def test_a_file_that_is_read_must_be_listed(results: Path, name: str) -> None:
    record = json.loads((results / "run.json").read_text())
    del record["files"][name]
    (results / "run.json").write_text(json.dumps(record))
    with pytest.raises(InputError, match=rf'^results/tiny/run\.json: was not written by trajopt: .*: "{name}" is '):
        read_results(results)


def at(*keys: Any) -> Callable[[Any, Any], None]:
    def put(record: Any, value: Any) -> None:
        for key in keys[:-1]:
            record = record[key]
        record[keys[-1]] = value

    return put


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("target", "x", 'options.target: "x" is none of rapid, stream; '),
        ("cycle_time", 1e308, "options.cycle_time: needs a number, 1e+09 or less, not 1e+308; "),
        ("cycle_time", -1.0, "options.cycle_time: needs a number, zero or more, not -1.0"),
    ],
)
def test_options_that_nobody_gave(results: Path, key: str, value: Any, said: str) -> None:
    record = json.loads((results / "run.json").read_text())
    record["options"][key] = value
    (results / "run.json").write_text(json.dumps(record))
    with pytest.raises(InputError) as caught:
        read_results(results)
    assert str(caught.value).startswith(f"results/tiny/run.json: was not written by trajopt: {said}")


@pytest.mark.parametrize(
    ("put", "what"),
    [
        (at("inputs", "files"), "inputs.files"),
        (at("inputs", "files", 0), "inputs.files[0]"),
        (at("inputs", "files", 0, "path"), "inputs.files[0].path"),
        (at("inputs", "files", 0, "copy"), "inputs.files[0].copy"),
        (at("inputs", "files", 0, "rapid"), "inputs."),  # null: no module
        (at("inputs", "files", 0, "sha256"), "inputs.files[0].sha256"),
        (at("inputs", "program"), "inputs.program"),
        (at("inputs", "cell"), "inputs.cell"),
        (at("options"), "options"),
        (at("options", "program"), "options.program"),
        (at("options", "entry"), "options.entry"),
        (at("options", "assume_identity"), "options.assume_identity"),
        (at("added"), "added"),
    ],
)
@pytest.mark.parametrize("value", [None, 3, 1.5, True, [3], [None], {"a": 1}, "../../x", "/etc/passwd", "", "a\0b"])
def test_each_damage_is_one_line(results: Path, put: Callable[[Any, Any], None], what: str, value: Any) -> None:
    if what == "options" and value == {"a": 1}:
        return  # those of an older run name no entry
    if isinstance(value, str) and what in ("options.program", "options.entry", "inputs.files[0].path"):
        return  # texts that a user may have given; an input is held against its content before it is written
    record = json.loads((results / "run.json").read_text())
    put(record, value)
    (results / "run.json").write_text(json.dumps(record))
    with pytest.raises(InputError) as caught:
        read_results(results)
    assert str(caught.value).startswith(f"results/tiny/run.json: was not written by trajopt: {what}")
    assert str(caught.value).endswith("; move the folder away and make it again")
    assert len(str(caught.value).splitlines()) == 1


def test_modules_that_an_older_export_added_are_refused(results: Path) -> None:
    record = json.loads((results / "run.json").read_text())
    assert record["added"] == []
    record["added"] = [{"path": "new.mod", "rapid": "program.mod"}]
    (results / "run.json").write_text(json.dumps(record))
    with pytest.raises(InputError, match=r"run\.json: .*added"):
        read_results(results)


def test_a_link_out_of_the_folder_is_not_followed(results: Path) -> None:
    (results / "program.mod").rename("elsewhere.mod")
    (results / "program.mod").symlink_to(Path("elsewhere.mod").resolve())
    with pytest.raises(InputError, match=r"program\.mod: is not a file that trajopt wrote"):
        read_results(results)


@pytest.mark.parametrize("content", ["{}", '{"target": 3}', '{"target": "stream", "plans": []}', "[]", "{"])
def test_a_summary_that_trajopt_did_not_write(results: Path, content: str) -> None:
    import hashlib

    record = json.loads((results / "run.json").read_text())
    record["files"]["summary.json"] = hashlib.sha256(content.encode()).hexdigest()
    (results / "run.json").write_text(json.dumps(record))
    (results / "summary.json").write_text(content)
    with pytest.raises(InputError, match=r"summary\.json: is not "):
        read_results(results)
