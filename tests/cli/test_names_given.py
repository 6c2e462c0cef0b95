"""Names on the command line: empty ones, and ones that are no text."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.mark.parametrize("language", ["C.UTF-8", "C"])
def test_a_name_that_is_no_text_leaves_json_valid(program: Path, language: str) -> None:
    name = os.fsdecode(b"t\xfcr.mod")
    program.rename(name)
    command = [sys.executable, "-m", "trajopt_cli.cli", "parse", str(Path(name).resolve())]
    world = {**os.environ, "LC_ALL": language}
    root = Path(__file__).parents[2]
    done = subprocess.run([*command, "--json"], capture_output=True, check=True, env=world, cwd=root)
    assert json.loads(done.stdout.decode("utf-8"))["files"] == [str(Path(name).resolve())]
    text = subprocess.run(command, capture_output=True, check=True, env=world, cwd=root).stdout.decode("utf-8")
    assert r"t\udcfcr.mod" in text
