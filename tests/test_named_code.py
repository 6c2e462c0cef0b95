"""docs/mathematics.md and docs/judge.md speak of code that exists, and leave out no relation of the nonlinear program
and no check of the judge."""

from __future__ import annotations

import ast
import importlib
import re
from pathlib import Path

import pytest

from trajopt_cli.settings import DEFAULT

ROOT = Path(__file__).parents[1]
TEXT = (ROOT / "docs" / "mathematics.md").read_text(encoding="utf-8")
JUDGE = (ROOT / "docs" / "judge.md").read_text(encoding="utf-8")
NAMED = sorted(set(re.findall(r"`([\w/]+\.py):([\w.]+)`", TEXT + JUDGE)))


def defined(path: Path) -> set[str]:
    """Functions, classes and methods of a module, as name or Class.name."""
    out = set()
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            out.add(node.name)
        if isinstance(node, ast.ClassDef):
            out |= {f"{node.name}.{part.name}" for part in node.body if isinstance(part, ast.FunctionDef)}
    return out


@pytest.mark.parametrize(("file", "name"), NAMED, ids=lambda part: part)
def test_what_the_text_names_exists(file: str, name: str) -> None:
    path = ROOT / file
    assert path.exists()
    assert name in defined(path)


def test_the_text_names_every_relation() -> None:
    formulation = defined(ROOT / "trajopt_cli" / "nlp" / "formulation.py")
    public = {name for name in formulation if re.fullmatch(r"Formulation\.[a-z]\w*", name)}
    assert len(public) > 10
    assert public <= {name for _, name in NAMED}


def test_the_settings_it_quotes_exist() -> None:
    quoted = set(re.findall(r"`([a-z_]+)`", TEXT))
    assert {"elbow", "wrist", "rough_tolerance"} <= quoted
    assert {name for name in ("elbow", "wrist", "rough_tolerance") if not hasattr(DEFAULT, name)} == set()


def test_the_text_names_every_check_and_its_tolerances() -> None:
    tree = ast.parse((ROOT / "trajopt_cli" / "judge" / "verify.py").read_text(encoding="utf-8"))
    called = {node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
    checks = {name for name in called if name.startswith("check_")} - {"check_columns"}  # which refuses the file
    assert len(checks) > 10
    assert checks <= {name for _, name in NAMED}
    tolerances = {name for name in vars(importlib.import_module("trajopt_cli.judge.tolerances")) if name.isupper()}
    quoted = set(re.findall(r"`([A-Z_]{2,})`", JUDGE))
    assert tolerances - quoted == {"COMPUTED"}  # rounding of the judge's own arithmetic
    assert quoted - tolerances == {"OVERLOOKED"}
