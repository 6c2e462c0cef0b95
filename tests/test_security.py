"""SECURITY.md is true: its numbers are the code's, and what it names is there."""

from __future__ import annotations

import re
from pathlib import Path

from trajopt_cli.proximity import meshes
from trajopt_cli.runs import folder
from trajopt_cli.runs.transaction import JOURNAL

REPOSITORY = Path(__file__).parents[1]
TEXT = (REPOSITORY / "SECURITY.md").read_text(encoding="utf-8")


def test_its_numbers_are_the_codes() -> None:
    words = " ".join(TEXT.split())
    assert f"`run.json` has at most {folder.MOST_RECORD // 10**6} MB" in words
    assert f"all files together at most {folder.MOST_BYTES // 10**9} GB" in words
    assert f"a mesh {meshes.MOST_BYTES // 10**6} MB" in words
    assert f"`{JOURNAL}`" in words


def test_the_files_that_it_names_are_there() -> None:
    named = re.findall(r"`(tests/[\w/.]+)`|\]\(([\w/.]+)\)", TEXT)
    assert len(named) >= 4
    for pair in named:
        assert (REPOSITORY / (pair[0] or pair[1])).is_file(), pair


def test_the_readme_says_what_hashes_are_for() -> None:
    readme = (REPOSITORY / "README.md").read_text(encoding="utf-8")
    assert "its hashes are for accident, not for attack" in " ".join(readme.split())
