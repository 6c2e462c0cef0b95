"""A little of the fuzzing in every run of the tests, always the same cases; and all cases that were findings once."""

from __future__ import annotations

import os
import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from fuzz_readers import CORPUS, Reader
from fuzz_run import COMMAND, Tally, all_readers, block, every_way

CASES = {
    "rapid": 250, "list": 300, "cell": 150, "moc": 150, "task": 100, "poses": 300, "joint csv": 150, "iiwa csv": 200,
    "urdf": 150, "robot": 60, "plan folder": 60, "task folder": 80, "log": 150, "stl": 200, "obj": 200, "options": 40,
}  # fmt: skip


@pytest.fixture(scope="module")
def known(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Reader]:
    return all_readers(tmp_path_factory.mktemp("workspace"))


@pytest.fixture
def case(tmp_path: Path) -> Iterator[Path]:
    before = Path.cwd()
    (folder := tmp_path / "case").mkdir()
    os.chdir(folder)
    yield folder
    os.chdir(before)


@pytest.mark.parametrize("name", CASES)
def test_broken_input_is_refused_in_words(name: str, known: dict[str, Reader], case: Path) -> None:
    tally = Tally()
    block(known[name], random.Random(f"suite:{name}"), tally, CASES[name], case)
    assert tally.cases == CASES[name]
    assert not tally.findings, {where: told for where, (_, told, _) in tally.findings.items()}
    if name != "moc":  # of which all is read that can be
        assert tally.ended["refused"] + tally.ended["exit 2"] > CASES[name] / 3  # most are broken
    if name != "options":
        assert tally.ended["read"] + tally.ended["run"] > 0
        assert sum(count for how, count in tally.ended.items() if how.startswith("exit")) == CASES[name] // COMMAND


def test_every_reader_has_its_cases(known: dict[str, Reader]) -> None:
    assert set(CASES) == set(known)


@pytest.mark.parametrize(
    "file", [pytest.param(one, id=f"{one.parent.name}/{one.name}") for one in sorted(CORPUS.glob("*/*"))]
)
def test_what_was_a_finding_is_none_now(file: Path, known: dict[str, Reader], case: Path) -> None:
    reader = known[file.parent.name.replace("_", " ")]
    for how, ended in every_way(reader, file.read_bytes(), case):
        assert ended.finding is None, f"{how}: {ended.finding}"
