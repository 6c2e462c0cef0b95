"""Who may import whom: every import statement, those under TYPE_CHECKING and inside functions included."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from fnmatch import fnmatch
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "trajopt_cli"

# Lowest floor first. A room may import rooms of floors under its own, and itself.
FLOORS: tuple[tuple[str, ...], ...] = (
    ("errors", "units", "geometry", "beside", "door"),
    (
        "motion",
        "limits",
        "trajectory",
        "scenario",
        "kinematics",
        "joint_csv",
        "shapes",
        "findings",
        "quantity",
        "validation",
        "yaml_file",
    ),
    ("rapid", "robot", "cell", "timing", "collision"),
    ("problem",),
    ("runs",),
    ("optimize", "verify", "export", "report"),
    # what is worked on: a program and its cell, or those of a results folder
    ("job",),
    ("pipeline", "compliance"),
    # the widest composition: everything the pipeline can do, many times over
    ("study",),
    ("cli",),
)
# The plain data on floors 0 and 1 is a short stack of its own.
STACK = {
    "beside": {"errors"},
    "door": set[str](),
    "motion": {"geometry"},
    "limits": {"geometry"},
    "trajectory": {"geometry"},
    "joint_csv": {"errors", "geometry", "trajectory", "units"},
    "errors": set[str](),
    "units": set[str](),
    "geometry": set[str](),
    "scenario": {"errors", "motion"},
    "kinematics": {"geometry", "motion"},
    "shapes": {"geometry"},
    "findings": {"motion"},
    "quantity": {"errors", "units"},
    "validation": {"quantity"},
    "yaml_file": {"errors", "validation"},
}
# Rooms with floors of their own inside.
INNER: dict[str, tuple[tuple[str, ...], ...]] = {
    "compliance": (("task",), ("controller", "world"), ("report",), ("job",), ("experiments",)),
}
# Where each third party may be imported, as patterns of paths inside the package.
ADDRESSES: dict[str, tuple[str, ...]] = {
    "casadi": ("robot/symbolic*.py", "optimize/*"),
    "pinocchio": ("robot/*",),
    "coal": ("collision/*",),
    "toppra": ("timing/*",),
    "ruckig": ("timing/*",),
    "scipy": ("optimize/*", "timing/*", "compliance/controller/*"),
    "typer": ("cli/*",),
    "rich": ("cli/*",),
    "matplotlib": ("report/*", "compliance/report/*"),
    "mujoco": ("compliance/world/*",),
    # What reads files people write by hand (cells, robots, tasks) and records that trajopt wrote.
    "pydantic": (
        "cell/*",
        "robot/*",
        "runs/*",
        "compliance/task/*",
        "compliance/job/folder.py",
        "validation.py",
        "yaml_file.py",
    ),
    "pydantic_core": ("cell/*", "runs/*", "quantity.py", "validation.py", "yaml_file.py"),
    "ruamel": ("robot/*", "yaml_file.py"),
    "numpy": ("*",),
}


def floor_of(room: str, floors: tuple[tuple[str, ...], ...] = FLOORS) -> int:
    return next(i for i, rooms in enumerate(floors) if room in rooms)


def imports(text: str, module: str) -> Iterator[tuple[int, str]]:
    """Line and dotted name of every import in a module's text; `from a import b` gives a and a.b."""
    package = module.split(".")[:-1]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            name = ".".join([*base, *([node.module] if node.module else [])])
            yield node.lineno, name
            for alias in node.names:
                yield node.lineno, f"{name}.{alias.name}"


def without_type_checking(text: str) -> str:
    tree = ast.parse(text)
    tree.body = [
        node
        for node in tree.body
        if not (isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING")
    ]
    return ast.unparse(tree)


def violations(path: str, text: str) -> list[str]:
    """What is wrong with the imports of one file; path is relative to the package."""
    parts = path.removesuffix(".py").split("/")
    room = parts[0]
    if path == "__init__.py":  # its doors are opened on demand, and named for type checkers only
        return [
            f"{path}:{line}: the package imports {name}"
            for line, name in imports(without_type_checking(text), "trajopt_cli.__init__")
            if name.split(".")[0] not in ("__future__", "importlib", "typing")
        ]
    found = []
    for line, name in imports(text, ".".join(["trajopt_cli", *parts])):
        head, *rest = name.split(".")
        if head != "trajopt_cli":
            if head not in sys.stdlib_module_names:
                allowed = ADDRESSES.get(head)
                if allowed is None:
                    found.append(f"{path}:{line}: {head} has no address in this table")
                elif not any(fnmatch(path, pattern) for pattern in allowed):
                    found.append(f"{path}:{line}: {head} lives in {', '.join(allowed)}")
            continue
        if not rest or rest[0] == "__version__":
            continue
        if rest[0] == room:
            if room in INNER and len(rest) > 1 and len(parts) > 2 and rest[1] != parts[1]:
                here, there = (floor_of(one, INNER[room]) for one in (parts[1], rest[1]))
                if not there < here:
                    found.append(f"{path}:{line}: {room}/{parts[1]} imports {rest[1]}, which is not under it")
            continue
        other = rest[0]
        lower = other in STACK[room] if room in STACK else floor_of(other) < floor_of(room)
        if not lower:
            found.append(f"{path}:{line}: {room} imports {other}, which is not on a floor under it")
    return sorted(set(found))


@pytest.mark.parametrize("path", sorted(str(p.relative_to(PACKAGE)) for p in PACKAGE.rglob("*.py")))
def test_imports_point_downward_and_third_parties_live_at_one_address(path: str) -> None:
    assert violations(path, (PACKAGE / path).read_text(encoding="utf-8")) == []


def test_every_room_stands_on_a_floor() -> None:
    rooms = {p.stem for p in PACKAGE.glob("*.py")} | {p.name for p in PACKAGE.iterdir() if (p / "__init__.py").exists()}
    assert rooms - {"__init__"} == {room for floor in FLOORS for room in floor}
    for room, floors in INNER.items():
        inner = {p.name for p in (PACKAGE / room).iterdir() if (p / "__init__.py").exists()}
        assert inner == {one for floor in floors for one in floor}


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("rapid/reader.py", "from trajopt_cli.robot.model import load_robot", "rapid imports robot"),
        ("rapid/reader.py", "def f():\n    import trajopt_cli.problem.plan", "rapid imports problem"),
        (
            "verify/judge.py",
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from trajopt_cli.optimize import optimize",
            "verify imports optimize",
        ),
        ("verify/judge.py", "from trajopt_cli import optimize", "verify imports optimize"),
        ("verify/judge.py", "from ..optimize import legs", "verify imports optimize"),
        ("verify/judge.py", "import casadi as ca", "casadi lives in"),
        ("optimize/search.py", "from trajopt_cli.pipeline import solve", "optimize imports pipeline"),
        ("errors.py", "from trajopt_cli.units import MM", "errors imports units"),
        ("pipeline.py", "import rich.table", "rich lives in cli/*"),
        ("cell/loader.py", "import yaml", "yaml has no address"),
        ("robot/model.py", "import casadi", "casadi lives in robot/symbolic*.py"),
        ("robot/model.py", "import coal", "coal lives in collision/*"),
        ("collision/pair.py", "from trajopt_cli.robot.model import RobotModel", "collision imports robot"),
        ("shapes.py", "from trajopt_cli.motion import Source", "shapes imports motion"),
        ("__init__.py", "from trajopt_cli.pipeline import solve", "the package imports"),
        ("__init__.py", "import numpy", "the package imports numpy"),
        ("__init__.py", "def f():\n    from trajopt_cli.errors import InputError", "the package imports"),
        ("runs/results.py", "from trajopt_cli.export.rapid_diff import patch", "runs imports export"),
        ("runs/folder.py", "from trajopt_cli.compliance.task.model import Task", "runs imports compliance"),
        ("cli/export.py", "import pydantic", "pydantic lives in"),
        (
            "compliance/task/model.py",
            "from trajopt_cli.compliance.controller.state import State",
            "compliance/task imports controller, which is not under it",
        ),
        (
            "compliance/world/contact.py",
            "from trajopt_cli.compliance.controller import state",
            "compliance/world imports controller",
        ),
        ("compliance/report/forces.py", "from trajopt_cli.compliance import job", "compliance/report imports job"),
    ],
)
def test_the_rules_see_what_they_forbid(path: str, text: str, expected: str) -> None:
    assert any(expected in line for line in violations(path, text)), violations(path, text)
