"""Who may import whom: every import statement, those under TYPE_CHECKING and inside functions included."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Collection, Iterator, Mapping
from fnmatch import fnmatch
from functools import cache
from pathlib import Path
from types import MappingProxyType

import pytest

PACKAGE = Path(__file__).parents[1] / "trajopt_cli"

# Lowest floor first. A room may import rooms of floors under its own, and itself.
FLOORS: tuple[tuple[str, ...], ...] = (
    ("errors", "units", "geometry", "workers", "settings"),
    (
        "motion",
        "warnings",
        "limits",
        "trajectory",
        "scenario",
        "kinematics",
        "joint_csv",
        "moc",
        "print_resolution",
        "sheet",
        "urdf_text",
        "file_kinds",
        "shapes",
        "findings",
        "table",
        "quantity",
        "validation",
        "yaml_file",
    ),
    # segments of paths: rapid measures arcs with it
    ("path", "native"),
    ("rapid", "robot", "cell", "timing", "proximity"),
    ("problem",),
    ("runs", "trajectories", "scene"),
    # the engines side by side, and what looks at plans from outside
    ("graph_search", "path_timing", "nlp", "collision", "bound"),
    # one ladder over the engines; the judge, exporters, pictures and pages
    ("plan", "judge", "exporters", "report", "page", "measured", "adopt"),
    # what is worked on: a program and its cell, or those of a results folder
    ("job",),
    ("pipeline", "iiwa"),
    # the widest composition: everything the pipeline can do, many times over
    ("study",),
    # families of programs and cells: points and programs by the hundred
    ("parameter_study",),
    ("cli",),
)
# The plain data on floors 0 and 1 is a short stack of its own.
STACK = {
    "workers": {"errors"},
    "settings": set[str](),
    "motion": {"geometry", "warnings"},
    "warnings": set[str](),
    "limits": {"geometry"},
    "trajectory": {"geometry"},
    "joint_csv": {"errors", "geometry", "print_resolution", "sheet", "trajectory", "units"},
    "moc": {"errors", "geometry", "units", "warnings"},
    "sheet": {"errors", "geometry"},
    "urdf_text": {"errors"},
    "print_resolution": {"geometry"},
    "errors": set[str](),
    "units": set[str](),
    "geometry": set[str](),
    "scenario": {"errors", "motion"},
    "kinematics": {"geometry", "motion"},
    "shapes": {"geometry"},
    "findings": {"motion"},
    "table": {"findings", "motion"},
    "quantity": {"errors", "units"},
    "validation": {"quantity"},
    "file_kinds": {"errors"},
    "yaml_file": {"errors", "file_kinds", "validation"},
}
# Rooms with floors of their own inside.
INNER: dict[str, tuple[tuple[str, ...], ...]] = {
    "iiwa": (("judge",), ("task",), ("controller", "world"), ("report",), ("job",), ("experiments",)),
}
# Where each third party may be imported, as patterns of paths inside the package.
ADDRESSES: dict[str, tuple[str, ...]] = {
    "casadi": ("robot/symbolic*.py", "path/*", "native/*", "nlp/*", "trajectories/limits/*"),
    "llvmlite": ("native/*",),
    "numba": ("*_loops.py", "native/numba_ir.py"),
    "platformdirs": ("native/*",),
    "pinocchio": ("robot/*", "judge/geometry.py", "judge/mechanism.py"),
    "coal": ("proximity/*",),
    "cascadio": ("proximity/*",),
    "toppra": ("judge/libraries.py",),
    "qdldl": ("nlp/interior_point.py",),
    "ruckig": ("timing/*", "judge/libraries.py"),
    "dask": ("parameter_study/cluster.py",),
    # the latter for types
    "distributed": (
        "parameter_study/cluster.py",
        *(f"parameter_study/{one}.py" for one in ("run", "search")),
        "cli/study.py",
    ),
    "optuna": ("parameter_study/search.py",),
    "psutil": ("parameter_study/guard.py",),
    "scipy": (
        "limits.py",
        "adopt/*",
        "bound/*",
        "collision/*",
        "graph_search/*",
        "nlp/*",
        "path_timing/*",
        "plan/*",
        "trajectories/*",
        "timing/*",
        "measured/*",
        "parameter_study/sampling.py",
        "iiwa/controller/*",
        "iiwa/task/arm_plan.py",
        "report/obstacles.py",
        "judge/libraries.py",
    ),
    "typer": ("cli/*",),
    "rich": ("cli/*",),
    "matplotlib": ("report/*", "iiwa/report/*"),
    "mpl_toolkits": ("report/arm.py",),  # of matplotlib
    "mujoco": ("iiwa/world/*",),
    # What reads files people write by hand (cells, robots, tasks) and records that trajopt wrote.
    "pydantic": (
        "cell/*",
        "robot/*",
        "runs/*",
        "iiwa/task/*",
        "iiwa/job/folder.py",
        "parameter_study/cell_keys.py",
        "parameter_study/study_file.py",
        "validation.py",
        "yaml_file.py",
    ),
    "pydantic_core": (
        "cell/*",
        "parameter_study/study_file.py",
        "runs/*",
        "quantity.py",
        "validation.py",
        "yaml_file.py",
    ),
    "ruamel": ("robot/*", "yaml_file.py"),
    "mcap_ros2": ("exporters/ros2.py",),
    "pyarrow": ("exporters/parquet.py", "parameter_study/results.py"),
    "numpy": ("*",),
}


def floor_of(room: str, floors: tuple[tuple[str, ...], ...] = FLOORS) -> int:
    return next(i for i, rooms in enumerate(floors) if room in rooms)


def inner_rooms(room: str) -> set[str]:
    return {one for floor in INNER[room] for one in floor}


@cache
def statements(text: str, module: str) -> tuple[tuple[int, str, str], ...]:
    """Line, dotted name and what is taken from it of every import in a module's text; "" for `import a.b` itself."""
    return tuple(_statements(text, module))


def _statements(text: str, module: str) -> Iterator[tuple[int, str, str]]:
    package = module.split(".")[:-1]
    left: list[ast.AST] = [ast.parse(text)]
    while left:
        node = left.pop()
        for part in ("body", "orelse", "handlers", "finalbody", "cases"):  # expressions import nothing
            left += inner if isinstance(inner := getattr(node, part, None), list) else []
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name, ""
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            name = ".".join([*base, *([node.module] if node.module else [])])
            for alias in node.names:
                yield node.lineno, name, alias.name


def imports(text: str, module: str) -> Iterator[tuple[int, str]]:
    """Line and dotted name of every import in a module's text; `from a import b` gives a and a.b."""
    for line, name, what in statements(text, module):
        yield line, name
        if what:
            yield line, f"{name}.{what}"


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
        if other == "iiwa" and (room != "cli" or (rest[1:2] and rest[1] in inner_rooms("iiwa"))):
            found.append(f"{path}:{line}: the iiwa job is behind one door, trajopt_cli.iiwa, for commands alone")
        lower = other in STACK[room] if room in STACK else floor_of(other) < floor_of(room)
        if not lower:
            found.append(f"{path}:{line}: {room} imports {other}, which is not on a floor under it")
    return sorted(set(found))


def test_imports_point_downward_and_third_parties_live_at_one_address() -> None:
    paths = sorted(PACKAGE.rglob("*.py"))
    assert len(paths) > 400
    assert [line for p in paths for line in violations(str(p.relative_to(PACKAGE)), p.read_text("utf-8"))] == []


def test_every_room_stands_on_a_floor() -> None:
    rooms = {p.stem for p in PACKAGE.glob("*.py")} | {p.name for p in PACKAGE.iterdir() if (p / "__init__.py").exists()}
    assert rooms - {"__init__"} == {room for floor in FLOORS for room in floor}
    for room, floors in INNER.items():
        inner = {p.name for p in (PACKAGE / room).iterdir() if (p / "__init__.py").exists()}
        assert inner == {one for floor in floors for one in floor}


def test_the_door_of_the_iiwa_job_opens_what_it_names_and_imports_nothing_before() -> None:
    from trajopt_cli import iiwa

    assert all(getattr(iiwa, name) is not None for name in iiwa.__all__)
    listed = without_type_checking((PACKAGE / "iiwa" / "__init__.py").read_text("utf-8"))
    assert {name.split(".")[0] for _, name in imports(listed, "trajopt_cli.iiwa.__init__")} == {"importlib", "typing"}
    assert {p.name for p in (PACKAGE / "cli").glob("*.py") if "trajopt_cli.iiwa" in p.read_text("utf-8")} <= {
        *("iiwa.py", "verify.py", "schema.py"),
    }


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("rapid/reader.py", "from trajopt_cli.robot.model import load_robot", "rapid imports robot"),
        ("rapid/reader.py", "def f():\n    import trajopt_cli.problem.plan", "rapid imports problem"),
        (
            "judge/verify.py",
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from trajopt_cli.plan import optimize",
            "judge imports plan",
        ),
        ("judge/verify.py", "from trajopt_cli import plan", "judge imports plan"),
        ("judge/verify.py", "from ..plan import solve", "judge imports plan"),
        ("judge/verify.py", "import casadi as ca", "casadi lives in"),
        ("graph_search/search.py", "from trajopt_cli.pipeline import solve", "graph_search imports pipeline"),
        ("errors.py", "from trajopt_cli.units import MM", "errors imports units"),
        ("path/line.py", "from trajopt_cli.rapid.zones import ways", "path imports rapid"),
        ("pipeline/optimize.py", "import rich.table", "rich lives in cli/*"),
        ("cell/loader.py", "import yaml", "yaml has no address"),
        ("robot/model.py", "import casadi", "casadi lives in robot/symbolic*.py"),
        ("robot/model.py", "import coal", "coal lives in proximity/*"),
        ("proximity/pair.py", "from trajopt_cli.robot.model import RobotModel", "proximity imports robot"),
        ("shapes.py", "from trajopt_cli.motion import Source", "shapes imports motion"),
        ("__init__.py", "from trajopt_cli.pipeline import solve", "the package imports"),
        ("__init__.py", "import numpy", "the package imports numpy"),
        ("__init__.py", "def f():\n    from trajopt_cli.errors import InputError", "the package imports"),
        ("runs/results.py", "from trajopt_cli.exporters.rapid_diff import patch", "runs imports exporters"),
        ("runs/folder.py", "from trajopt_cli.iiwa.task.model import Task", "runs imports iiwa"),
        ("cli/export.py", "import pydantic", "pydantic lives in"),
        ("cli/iiwa.py", "def f():\n    from trajopt_cli.iiwa.job.folder import open_folder", "behind one door"),
        ("cli/iiwa.py", "from trajopt_cli.iiwa import judge", "behind one door"),
        ("study/table.py", "from trajopt_cli import iiwa", "behind one door"),
        (
            "iiwa/task/model.py",
            "from trajopt_cli.iiwa.controller.lag import Lag",
            "iiwa/task imports controller, which is not under it",
        ),
        (
            "iiwa/world/contact.py",
            "from trajopt_cli.iiwa.controller import state",
            "iiwa/world imports controller",
        ),
        ("iiwa/report/forces.py", "from trajopt_cli.iiwa import job", "iiwa/report imports job"),
    ],
)
def test_the_rules_see_what_they_forbid(path: str, text: str, expected: str) -> None:
    assert any(expected in line for line in violations(path, text)), violations(path, text)


# ---------------------------------------------------------------------------------------------------------- the judge

# What the judge may import of this package, by module; the names where not all of a module is data. All of these the
# optimiser uses too: data types and units.
SHARED: dict[str, tuple[str, ...]] = {
    "errors": (),
    "geometry": ("Array", "BoolArray", "IndexArray"),
    "limits": (),
    "motion": (),
    "warnings": (),
    "problem.plan": ("Target",),
    "scenario": ("Follower", "PositionerAxis"),
    "shapes": (),
    "trajectory": ("Trajectory",),
    "units": (),
}
# What else it may import: its own answer, the reader of files, distances, and libraries for advice. Nothing of the
# optimiser leads there.
APART: dict[str, tuple[str, ...]] = {
    "proximity.pair": ("Pair",),
    "findings": (),
    "joint_csv": ("Resolution", "check_reach", "read_csv_text"),
    "print_resolution": ("Digits",),
    "sheet": ("TIME", "TIMES", "Head", "Sheet", "missing_rows"),
}
# Meshes are read into the plant, where the judge finds them, and looked into by proximity.pair.
MESHES = "proximity.meshes"
# Of a module with computing names, what the shared modules themselves may use.
PLAIN = {"geometry": (*SHARED["geometry"], "readonly"), "trajectory": SHARED["trajectory"]}
OPTIMISERS = ("plan", "bound", "collision", "graph_search", "nlp", "path_timing", "trajectories", "path")

# The judge of the compliant job, and what it may import besides itself: data, its own answer, what reads folders, YAML
# and joint CSV, where a robot's files are, and of the other judge the robot by pin, wording and differences of rows.
COMPLIANT = "iiwa.judge"
COMPLIANT_MAY: dict[str, tuple[str, ...]] = {
    "errors": ("ErrorKind", "InputError", "of_kind"),
    "findings": ("Finding", "Report"),
    "geometry": ("Array",),
    "joint_csv": ("Resolution", "check_reach", "read_csv_text"),
    "motion": ("Source",),
    "native.loops": ("loops",),
    "robot.catalogue": ("find_robot",),
    "runs": ("SUMMARY",),
    "runs.folder": ("TASK", "ResultsFolder", "read_bytes", "read_run"),
    "runs.record": ("RunRecord",),
    "trajectory": ("Trajectory",),
    "judge.findings": ("finding",),
    "judge.mechanism": ("Mechanism",),
    "judge.samples": ("second_differences",),
    "judge.tolerances": ("COMPUTED",),
    "yaml_file": ("line_of", "parse", "read_text"),
}
# All that this judge and the job it judges have in common: plain data, readers with what they stand on, and what links
# loops that were compiled before, each its own.
COMPLIANT_SHARED = {
    "errors", "findings", "geometry", "joint_csv", "limits", "motion", "print_resolution", "warnings", "quantity",
    "native.loops", "native.machine", "native.store", "native.writing",
    "robot.catalogue", "robot.structure", "runs.files", "runs.folder", "runs.record", "shapes", "sheet", "trajectory",
    "file_kinds", "scenario", "units", "validation", "yaml_file",
}  # fmt: skip


@cache
def sources() -> Mapping[str, str]:
    """The text of every module by its dotted name inside the package; a package's own is that of its __init__, a door's
    without what it names for type checkers only."""
    names = {p: str(p.relative_to(PACKAGE).with_suffix("")).replace("/", ".") for p in PACKAGE.rglob("*.py")}
    texts = {name.removesuffix(".__init__"): p.read_text("utf-8") for p, name in names.items()}
    return MappingProxyType(texts | {"iiwa": without_type_checking(texts["iiwa"])})


@cache
def packages(modules: tuple[str, ...]) -> frozenset[str]:
    """Those with modules in them."""
    return frozenset(".".join(parts[:i]) for parts in (one.split(".") for one in modules) for i in range(1, len(parts)))


def inner_imports(module: str, text: str, modules: Mapping[str, str]) -> Iterator[tuple[int, str, str]]:
    """Line, module and what is taken from it ("" for the module as a whole) of a module's imports of this package."""
    own = f"{module}.__init__" if module in packages(tuple(modules)) else module
    for line, dotted, what in statements(text, f"trajopt_cli.{own}"):
        if dotted.partition(".")[0] == "trajopt_cli":
            name = dotted.partition(".")[2]
            inside = f"{name}.{what}".strip(".")
            yield (line, inside, "") if inside in modules else (line, name, what)


def reached(starts: Collection[str], modules: Mapping[str, str]) -> set[str]:
    """The modules that importing these brings along, TYPE_CHECKING and functions included, packages on the way too;
    of the answer the packages are left out."""
    seen: set[str] = set()
    todo = list(starts)
    while todo:
        module = todo.pop()
        if module in seen or module not in modules:
            continue
        seen.add(module)
        parts = module.split(".")
        todo += [".".join(parts[:i]) for i in range(1, len(parts))]
        todo += [name for _, name, _ in inner_imports(module, modules[module], modules)]
    return seen - packages(tuple(modules))


def rooms(modules: Mapping[str, str], *names: str) -> set[str]:
    return {module for module in modules if module.split(".")[0] in names}


def of_compliant_job(modules: Mapping[str, str]) -> set[str]:
    return {module for module in modules if f"{module}.".startswith(f"{COMPLIANT}.")}


def judge_violations(modules: Mapping[str, str]) -> list[str]:
    """What ties the judge to the optimiser, or to anything that no list above allows."""
    judge = rooms(modules, "judge")
    allowed = SHARED | APART
    found = []
    for module in sorted(judge):
        for line, name, what in inner_imports(module, modules[module], modules):
            if name.split(".")[0] == "judge":
                continue
            if name not in allowed or what == "*" or (allowed[name] and what not in allowed[name]):
                found.append(f"{module}:{line}: the judge may not import {what or 'anything'} from {name}")
    everything = reached(judge, modules)
    for module in sorted(everything):
        for line, name in imports(modules[module], f"trajopt_cli.{module}"):
            if name.split(".")[0] in ("casadi", "importlib", "runpy"):
                found.append(f"{module}:{line}: {name} is out of the judge's reach")
        for line, name, what in inner_imports(module, modules[module], modules):
            if name in PLAIN and what not in PLAIN[name]:
                found.append(f"{module}:{line}: {name}.{what} computes, and the judge reaches this module")
    found += [f"the judge reaches {m}" for m in sorted(everything - judge - set(allowed) - {MESHES})]
    both = everything & reached(rooms(modules, *OPTIMISERS), modules)
    return found + [f"judge and optimiser both reach {m}" for m in sorted(both - set(SHARED) - {MESHES})]


def test_the_judge_shares_data_with_the_optimiser_and_nothing_that_computes() -> None:
    modules = sources()
    assert judge_violations(modules) == []
    # and the lists say no more than is true
    judge = reached(rooms(modules, "judge"), modules)
    optimiser = reached(rooms(modules, *OPTIMISERS), modules)
    assert judge - rooms(modules, "judge") == {*SHARED, *APART, MESHES}
    assert judge & optimiser == {*SHARED, MESHES}


@pytest.mark.parametrize(
    ("module", "text", "expected"),
    [
        ("judge.verify", "from trajopt_cli.geometry import axis_angle", "may not import axis_angle from geometry"),
        ("judge.verify", "from trajopt_cli import geometry", "may not import anything from geometry"),
        ("judge.samples", "from trajopt_cli.trajectory import hermite", "may not import hermite from trajectory"),
        ("judge.samples", "import trajopt_cli.robot.arm", "may not import anything from robot.arm"),
        ("judge.samples", "from ..robot import differential", "may not import anything from robot.differential"),
        ("judge.samples", "def f():\n    from trajopt_cli.path.line import Line", "may not import Line from path.line"),
        (
            "judge.samples",
            "from trajopt_cli.problem.path_ik import follow",
            "may not import follow from problem.path_ik",
        ),
        ("judge.samples", "from trajopt_cli.motion import *", "may not import * from motion"),
        (
            "judge.machine",
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from trajopt_cli.problem.plant import Plant",
            "may not import Plant from problem.plant",
        ),
        ("judge.machine", "import importlib", "importlib is out of the judge's reach"),
        ("motion", "from trajopt_cli.geometry import rotation_about", "geometry.rotation_about computes"),
        ("findings", "from trajopt_cli import trajectory", "trajectory. computes"),
        ("proximity.pair", "from trajopt_cli.robot.chain import pin_model", "the judge reaches robot.chain"),
        ("joint_csv", "import casadi", "casadi is out of the judge's reach"),
        ("plan.solve", "from trajopt_cli.joint_csv import x", "judge and optimiser both reach joint_csv"),
        ("problem", "from trajopt_cli.robot.model import RobotModel", "the judge reaches robot.model"),
    ],
)
def test_the_judges_rule_sees_what_it_forbids(module: str, text: str, expected: str) -> None:
    """One import more in one module; path may or may not be there."""
    modules = {"path": "", "path.line": "", **sources()}
    modules[module] += f"\n{text}\n"
    assert any(expected in line for line in judge_violations(modules)), judge_violations(modules)


def compliant_violations(modules: Mapping[str, str]) -> list[str]:
    """What ties the judge of the compliant job to the job: a tool of one would hide the other's mistakes."""
    judge, allowed = of_compliant_job(modules), COMPLIANT_MAY
    found = []
    for module in sorted(judge):
        for line, name, what in inner_imports(module, modules[module], modules):
            if name != COMPLIANT and name not in judge and what not in allowed.get(name, ()):
                found.append(f"{module}:{line}: this judge may not import {what or 'anything'} from {name}")
        for name in re.findall(r'"trajopt_cli\.([\w.]+)"', modules[module]):
            if name not in judge:
                found.append(f"{module}: this judge may not link {name}")
    everything = reached(judge, modules)
    for module in sorted(everything):
        if (module.split(".")[0] == "iiwa" and module not in judge) or module.startswith("robot.srs"):
            found.append(f"this judge reaches {module}")
        for line, name in imports(modules[module], f"trajopt_cli.{module}"):
            if name.split(".")[0] in ("importlib", "runpy") and "metadata" not in name and module != "native.loops":
                found.append(f"{module}:{line}: {name} is out of this judge's reach")
    both = everything & reached(rooms(modules, "iiwa") - of_compliant_job(modules), modules)
    return found + [f"judge and job both reach {m}" for m in sorted(both - COMPLIANT_SHARED)]


def test_the_judge_of_the_compliant_job_shares_data_and_readers_with_it_and_nothing_that_computes() -> None:
    modules = sources()
    assert compliant_violations(modules) == []
    # and the lists say no more than is true
    judge = of_compliant_job(modules)
    taken = {(name, what) for m in judge for _, name, what in inner_imports(m, modules[m], modules)}
    assert {(name, what) for name, what in taken if name not in {*judge, COMPLIANT}} == {
        (name, what) for name, names in COMPLIANT_MAY.items() for what in names
    }
    assert (
        reached(judge, modules) & reached(rooms(modules, "iiwa") - of_compliant_job(modules), modules)
        == COMPLIANT_SHARED
    )


@pytest.mark.parametrize(
    ("module", "text", "expected"),
    [
        ("iiwa.judge.path", "from trajopt_cli.iiwa.task.legs import legs", "may not import legs from"),
        ("iiwa.judge.joints", "from trajopt_cli.robot.srs import load_srs", "may not import load_srs from"),
        (
            "iiwa.judge.joints",
            "def f():\n    import trajopt_cli.robot.srs_inverse",
            "this judge reaches robot.srs_inv",
        ),
        ("iiwa.judge.law", 'LOOPS = "trajopt_cli.robot.inverse_loops"', "this judge may not link robot.inverse_loops"),
        (
            "iiwa.judge.samples",
            "from trajopt_cli.geometry import rotation_from_wxyz",
            "may not import rotation_from",
        ),
        ("iiwa.judge.verify", "from importlib import import_module", "importlib is out of this judge's reach"),
        (
            "judge.samples",
            "from trajopt_cli.timing.point_to_point import x",
            "judge and job both reach timing.point_to_",
        ),
        ("robot.catalogue", "from trajopt_cli.robot.srs import load_srs", "this judge reaches robot.srs"),
    ],
)
def test_the_compliant_judges_rule_sees_what_it_forbids(module: str, text: str, expected: str) -> None:
    modules = dict(sources())
    modules[module] += f"\n{text}\n"
    assert any(expected in line for line in compliant_violations(modules)), compliant_violations(modules)
