"""Files are written in one way, by runs.files and runs.together: whole or not at all. Whoever opens, renames or removes
one by himself is named here, with the reason."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "trajopt_cli"
ALLOWED = {
    "runs/files.py": "the way itself",
    "runs/transaction.py": "the way of several files at once",
    "runs/rows.py": "files without a name, gone with their process",
    "native/numba_ir.py": "a developer's command that writes sources of the package",
    "native/store.py": "a cache, that may be lost at any time, on the floor below",
    "proximity/meshes.py": "a copy of a mesh for the library, in a temporary folder",
    "parameter_study/point.py": "the files of a robot's own, in a temporary folder of a worker",
    "parameter_study/backups.py": "a point's program and cell, in a temporary folder",
    "cli/health.py": "a trial run in a temporary folder",
    "cli/__init__.py": "opens /dev/null where stdout is closed",
}
METHODS = {"write_text", "write_bytes", "mkdir", "unlink", "rmdir", "symlink_to", "hardlink_to", "rename", "chmod"}
FUNCTIONS = {
    "os": {"open", "replace", "rename", "remove", "unlink", "mkdir", "makedirs", "link", "symlink", "truncate"},
    "shutil": {"copy", "copy2", "copyfile", "copytree", "move", "rmtree"},
    "np": {"save", "savez", "savez_compressed", "savetxt"},
    "tempfile": {"NamedTemporaryFile", "TemporaryFile", "mkstemp", "mkdtemp", "TemporaryDirectory"},
}
NAMES = FUNCTIONS["tempfile"] | {"open"}
WORDS = [*METHODS, *NAMES, *(rf"{module}\s*\.\s*{name}" for module, names in FUNCTIONS.items() for name in names)]
ANY = re.compile(rf"\b(?:{'|'.join(WORDS)})\s*\(")


def writes(text: str) -> Iterator[int]:
    """The lines that change a disk, or could. Only texts with one of the names, called, are parsed."""
    for node in ast.walk(ast.parse(text)) if ANY.search(text) else ():
        if not isinstance(node, ast.Call):
            continue
        match node.func:
            case ast.Attribute(value=ast.Name(id=module), attr=name) if name in FUNCTIONS.get(module, ()):
                yield node.lineno
            case ast.Attribute(attr=name) if name in METHODS:
                yield node.lineno
            case ast.Name(id=name) if name in NAMES:
                modes = [one.value for one in (*node.args[1:2], *(k.value for k in node.keywords if k.arg == "mode"))
                         if isinstance(one, ast.Constant)]  # fmt: skip
                if name != "open" or (modes and set(str(modes[0])) & set("wax+")):
                    yield node.lineno


def test_nobody_else_writes() -> None:
    found = {
        f"{path.relative_to(PACKAGE).as_posix()}:{line}"
        for path in PACKAGE.rglob("*.py")
        for line in writes(path.read_text(encoding="utf-8"))
        if path.relative_to(PACKAGE).as_posix() not in ALLOWED
    }
    assert found == set()


def test_those_who_may_do() -> None:
    for name in ALLOWED:
        assert [*writes((PACKAGE / name).read_text(encoding="utf-8"))], name
