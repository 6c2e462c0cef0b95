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
    ("errors", "units", "geometry", "files", "beside"),
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
        "yaml_file",
    ),
    # segments of paths: rapid measures arcs with it
    ("path",),
    ("rapid", "robot", "cell", "timing", "collision"),
    ("problem",),
    ("runs",),
    ("optimize", "verify", "export", "report"),
    # what is worked on: a program and its cell, or those of a results folder
    ("job", "rapid_results"),
    ("pipeline", "compliance"),
    # the widest composition: everything the pipeline can do, many times over
    ("study",),
    ("cli",),
)
# The plain data on floors 0 and 1 is a short stack of its own.
STACK = {
    "files": {"errors"},
    "beside": {"errors"},
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
    "yaml_file": {"errors", "quantity"},
}
# Where each third party may be imported, as patterns of paths inside the package.
ADDRESSES: dict[str, tuple[str, ...]] = {
    "casadi": ("robot/symbolic*.py", "path/*", "optimize/*"),
    "pinocchio": ("robot/*",),
    "coal": ("collision/*",),
    "toppra": ("timing/*",),
    "ruckig": ("timing/*",),
    "scipy": ("optimize/*", "timing/*", "compliance/controller/*"),
    "typer": ("cli/*",),
    "rich": ("cli/*",),
    "matplotlib": ("report/*", "compliance/report/*"),
    "mujoco": ("compliance/world/*",),
    # The rooms that read files people write by hand: cell files, robot descriptions, task files.
    "pydantic": ("cell/*", "robot/*", "compliance/task/*", "yaml_file.py"),
    "pydantic_core": ("cell/*", "quantity.py", "yaml_file.py"),
    "ruamel": ("robot/*", "yaml_file.py"),
    "numpy": ("*",),
}


def floor_of(room: str) -> int:
    return next(i for i, rooms in enumerate(FLOORS) if room in rooms)


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


def violations(path: str, text: str) -> list[str]:
    """What is wrong with the imports of one file; path is relative to the package."""
    parts = path.removesuffix(".py").split("/")
    room = parts[0]
    if path == "__init__.py":
        return [
            f"{path}:{line}: the package imports {name}"
            for line, name in imports(text, "trajopt_cli.__init__")
            if name != "__future__" and not name.startswith("__future__.")
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
        if not rest or rest[0] in ("__version__", room):
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
    assert rooms - {"__init__"} <= {room for floor in FLOORS for room in floor}


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
        ("path/line.py", "from trajopt_cli.rapid.zones import ways", "path imports rapid"),
        ("pipeline.py", "import rich.table", "rich lives in cli/*"),
        ("cell/loader.py", "import yaml", "yaml has no address"),
        ("robot/model.py", "import casadi", "casadi lives in robot/symbolic*.py"),
        ("robot/model.py", "import coal", "coal lives in collision/*"),
        ("collision/pair.py", "from trajopt_cli.robot.model import RobotModel", "collision imports robot"),
        ("shapes.py", "from trajopt_cli.motion import Source", "shapes imports motion"),
        ("__init__.py", "from trajopt_cli.pipeline import solve", "the package imports"),
    ],
)
def test_the_rules_see_what_they_forbid(path: str, text: str, expected: str) -> None:
    assert any(expected in line for line in violations(path, text)), violations(path, text)
