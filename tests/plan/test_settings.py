"""Every number that was chosen is a field of one frozen value, with a word on its unit and what was measured."""

from __future__ import annotations

import ast
import re
from dataclasses import fields
from pathlib import Path

import pytest

from trajopt_cli import settings
from trajopt_cli.settings import Settings

PACKAGE = Path(settings.__file__).parent
TABLE = PACKAGE / "settings.py"
ROOMS = ("bound", "collision", "graph_search", "nlp", "path_timing", "plan", "trajectories")
MODULES = sorted(path for room in ROOMS for path in (PACKAGE / room).rglob("*.py"))


def numbers(path: Path) -> list[str]:
    """Public names in capitals that a module sets to a number or an expression of numbers."""
    found = []
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            name = node.targets[0].id
            values = [part.value for part in ast.walk(node.value) if isinstance(part, ast.Constant)]
            if re.fullmatch("[A-Z][A-Z_]*", name) and any(isinstance(value, int | float) for value in values):
                found.append(name)
    return found


@pytest.mark.parametrize("path", MODULES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_no_module_has_a_number_for_others(path: Path) -> None:
    assert numbers(path) == []


def test_there_are_few_and_each_has_a_comment() -> None:
    named = {one.name for one in fields(Settings)}
    assert len(named) <= 80
    text = TABLE.read_text(encoding="utf-8")
    assert {name for name in named if not re.search(rf"^    {name}: .*  # \w", text, re.M)} == set()


def test_every_number_is_used() -> None:
    used = {
        word
        for path in PACKAGE.rglob("*.py")
        if path != TABLE
        for word in re.findall(r"(?:settings|DEFAULT)\.(\w+)", path.read_text("utf-8"))
    }
    text = TABLE.read_text(encoding="utf-8")
    derived = [name for name, one in vars(Settings).items() if isinstance(one, property)]
    names = [*(one.name for one in fields(Settings)), *derived]
    assert [name for name in names if name not in used and f"self.{name}" not in text] == []
    assert len(derived) > 20
