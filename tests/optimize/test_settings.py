"""Every number that was chosen stands in the one table, with a word on what was measured."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from trajopt_cli import settings

PACKAGE = Path(settings.__file__).parent
TABLE = PACKAGE / "settings.py"
ROOMS = ("bound", "collision", "graph_search", "nlp", "path_timing", "plan", "trajectories")


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


MODULES = sorted(path for room in ROOMS for path in (PACKAGE / room).glob("*.py"))


@pytest.mark.parametrize("path", MODULES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_no_module_keeps_a_number_of_its_own(path: Path) -> None:
    assert numbers(path) == []


def test_every_number_says_what_was_measured() -> None:
    """In the comment on its line and on the lines under it."""
    text = TABLE.read_text(encoding="utf-8")
    entries = re.split(r"^(?=[A-Z_]+(?:: [^=]+)? = )", text, flags=re.M)[1:]
    assert len(entries) > 75
    assert [entry.split(" = ")[0] for entry in entries if not re.search("[Mm]easured", entry)] == []


def test_every_number_is_used() -> None:
    used = {
        word for path in PACKAGE.rglob("*.py") if path != TABLE for word in re.findall(r"\w+", path.read_text("utf-8"))
    }
    table = ast.parse(TABLE.read_text(encoding="utf-8"))
    names = [node.targets[0].id for node in table.body if isinstance(node, ast.Assign)]  # type: ignore[attr-defined]
    assert [name for name in names if name not in used] == []


def test_no_number_is_set_twice() -> None:
    names = numbers(TABLE)
    assert sorted(names) == sorted(set(names))
