"""`trajopt schema`: what the loaders take is what the schemas allow, by jsonschema as the second opinion."""

from __future__ import annotations

import json
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from ruamel.yaml import YAML
from typer.testing import CliRunner

from trajopt_cli.cell.document import CellDocument
from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli import app
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.document import TaskDocument
from trajopt_cli.iiwa.task.loader import load_task
from trajopt_cli.limits import AXIS_LIMITS, TcpCaps

REPOSITORY = Path(__file__).parents[1]
PROGRAMS = REPOSITORY / "programs"
TASKS = sorted(PROGRAMS.glob("iiwa_*.yaml"))
CELLS = sorted({*PROGRAMS.glob("*.yaml"), *(REPOSITORY / "tests/data").rglob("*cell*.yaml")} - {*TASKS})
ROBOTS = sorted((REPOSITORY / "robots").glob("*.yaml"))
CELL = 'robot: irb140_rail\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}\nrail: {eax: a, stroke: [0, 2]}\n'
TASK = (PROGRAMS / "iiwa_cube.yaml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def schemas() -> dict[str, Draft202012Validator]:
    """By kind, as the command prints them."""
    found = {}
    for kind in ("cell", "task", "robot"):
        printed = CliRunner().invoke(app, ["schema", kind])
        assert printed.exit_code == 0
        schema = json.loads(printed.stdout)
        Draft202012Validator.check_schema(schema)
        found[kind] = Draft202012Validator(schema)
    return found


def plain(text: str) -> Any:
    """The YAML as a schema sees it: JSON's types."""
    return json.loads(json.dumps(YAML(typ="safe").load(text)))


def files() -> list[tuple[str, Path]]:
    kinds = (("cell", CELLS), ("task", TASKS), ("robot", ROBOTS))
    return [(kind, path) for kind, paths in kinds for path in paths]


@pytest.mark.parametrize(("kind", "path"), files(), ids=lambda part: getattr(part, "stem", part))
def test_what_ships_is_allowed(kind: str, path: Path, schemas: dict[str, Draft202012Validator]) -> None:
    assert [error.message for error in schemas[kind].iter_errors(plain(path.read_text(encoding="utf-8")))] == []


def test_every_limit_is_a_key_of_the_cell_file(schemas: dict[str, Draft202012Validator]) -> None:
    found = schemas["cell"].schema["$defs"]  # type: ignore[index]
    for section in ("JointLimitSection", "RailLimitSection"):
        assert {*AXIS_LIMITS} == {*found[section]["properties"]} - {"lower", "upper", "acceleration_factor", "source"}
    caps = [one.name for one in fields(TcpCaps)]
    assert [*caps, "source"] == [*found["TcpSection"]["properties"]]


GOOD = [
    "limits: {rail: {velocity: 1 m/s, acceleration: '2.5 m/s²', source: me}}",
    "limits: {joint_1: {velocity: 90 deg/s, acceleration: 10, jerk: 500 deg/s^3, lower: -90 deg, source: me}}",
    "tcp: {speed: 250 mm/s, acceleration: 2, source: me}",
    "obstacles: {table: {box: {size: '[1, 1, 0.1] m', position: [600 mm, 0, 0], rpy: '[0, 0, 45] deg'}}}",
    "obstacles: {post: {capsule: {from: [1, 0, 0], to: [1, 0, 1], radius: 40 mm}, ignore: [link_1]}}",
    "attached: {part: {mesh: {file: part.stl, scale: 0.001}}}",
    "may_touch: [[link_1, link_4]]",
    "clearance: 5 mm",
    "signals: {di1: 1, di2: [0, 0, 1], di3: true}",
    "answers: {nParts: 3, sName: left, bMore: [true, false], p: '[1,2,3]'}",
    "data: {nCount: 3, pPick: '[[500,0,600],[1,0,0,0]]', p2: {type: robtarget, value: '[...]'}, n3: [1, 2]}",
    "waits: {di1: 200 ms, di2: timeout, di3: 0, 'di4 = 1': Timeout}",
    "searches: {pFound: 0.5, di2: never, di3: ' NEVER'}",
    "endless_passes: 3",
    "hold_rail: {procedures: [Weld], lines: [41, 'hinge.mod:44'], waits: true}",
    "constant_speed: [weld, 41, 'glue.mod:35-48']",
    "free: {axis: z, within: [-180 deg, 90 deg], in: [Drill, tDrill, 41]}",
    "free: [{axis: x}, {axis: z, within: '[-0.5, 0.5] rad'}]",
    "pass_limit: 10\nstatement_limit: 100\nassume_identity: [tGrip]\nstubs: [Log]\noptional: [p1]",
    "free_speed: true\njerk_limits: false\nprofile: optimistic",
    "base: null",
]
BAD = [
    "limit: {}",
    "rails: {eax: a}",
    "limits: {joint_1: {velocity: 90 mm/s, source: me}}",
    "limits: {joint_1: {velocity: fast, source: me}}",
    "limits: {joint_1: {velocity: 1}}",
    "limits: {joint_1: {speed: 1, source: me}}",
    "limits: {rail: {lower: 0, velocity: 1, source: me}}",
    "tcp: {speed: -1, acceleration: 2, source: me}",
    "tcp: {speed: true, acceleration: 2, source: me}",
    "obstacles: {table: {box: {size: [1, 1]}}}",
    "obstacles: {table: {box: {size: [1, 1, 1], turn: 3}}}",
    "obstacles: [table]",
    "may_touch: [link_1, link_4]",
    "clearance: -1",
    "clearance: 5 deg",
    "signals: {di1: []}",
    "signals: 1",
    "waits: {di1: -1}",
    "waits: {di1: never}",
    "searches: {pFound: always}",
    "searches: {pFound: -0.5}",
    "endless_passes: 0",
    "endless_passes: 1.5",
    "hold_rail: {lines: [1.5]}",
    "hold_rail: {waits: 1}",
    "free_speed: 1",
    "stubs: Log",
    "free: z",
    "free: {axis: w}",
    "free: {axis: z, in: []}",
]


def fresh(text: str) -> str:
    """A cell with these keys, instead of its own where both give one."""
    keys = {line.split(":")[0] for line in text.splitlines()}
    return "".join(f"{line}\n" for line in CELL.splitlines() if line.split(":")[0] not in keys) + text + "\n"


@pytest.mark.parametrize("text", GOOD)
def test_what_the_loader_takes_of_a_cell_is_allowed(text: str, schemas: dict[str, Draft202012Validator]) -> None:
    parse_cell(fresh(text), "cell.yaml")
    assert [error.message for error in schemas["cell"].iter_errors(plain(fresh(text)))] == []


@pytest.mark.parametrize("text", BAD)
def test_what_the_schema_refuses_of_a_cell_the_loader_refuses(
    text: str, schemas: dict[str, Draft202012Validator]
) -> None:
    with pytest.raises(InputError):
        parse_cell(fresh(text), "cell.yaml")
    assert list(schemas["cell"].iter_errors(plain(fresh(text))))


TASKS_CHANGED = [
    ("v_max: 0.2 m/s", True),
    (f"v_max: [{', '.join(['0.2, 250 mm/s'] * 8)}]", True),
    ("v_max: 3 deg", False),
    ("K: [1 N/mm, 1000, 1000, 100, 100, 100 Nm/rad]", True),
    ("K: [1000, 1000, 1000]", False),
    ("D: [500, 500, 500, 10, 10, 10 N]", False),
    ("h: 2 ms", True),
    ("h: 2 m", False),
    ("passing: {tolerance: 0.2 mm}", True),
    ("passing: stop", True),
    ("passing: slow", False),
    ("poses: [start, {by: [0, 0, 100 mm, 0, 0, 0], dwell: 1 s, name: up}]", True),
    ("poses: [start, {up: [0, 0, 100 mm, 0, 0, 0]}]", False),
    ("poses: [home, {by: [0, 0, 0.1, 0, 0, 0]}]", False),
    ("sensor: {bias: 0.01, ripple: [{frequency: 8 Hz, amplitude: 0.1 Nm}]}", True),
    ("pushes: [{from: 1 s, to: 2 s, force: [10 N, 0, 0, 0, 0, 0]}]", True),
    ("clamps: {torque: [1, 2]}", False),
    ("profile: s-curves", False),
    ("stiffness: 3", False),
]


@pytest.mark.parametrize(("text", "taken"), TASKS_CHANGED)
def test_loader_and_schema_agree_on_tasks(
    text: str, taken: bool, tmp_path: Path, schemas: dict[str, Draft202012Validator]
) -> None:
    key = text.split(":")[0]
    lines = YAML(typ="safe").load(TASK)
    content = {name: value for name, value in lines.items() if name != key} | YAML(typ="safe").load(text)
    path = tmp_path / "task.yaml"
    path.write_text(json.dumps(content))  # JSON is YAML
    if taken:
        load_task(path)
    else:
        with pytest.raises(InputError):
            load_task(path)
    assert (not list(schemas["task"].iter_errors(plain(json.dumps(content))))) is taken


@pytest.mark.parametrize(("kind", "model"), [("cell", CellDocument), ("task", TaskDocument)])
def test_every_key_is_there_and_described(kind: str, model: Any, schemas: dict[str, Draft202012Validator]) -> None:
    keys = schemas[kind].schema["properties"]
    assert list(keys) == list(model.model_fields)
    assert [name for name, key in keys.items() if len(key.get("description", "")) < 5] == []


def test_the_editors_line_names_the_file_that_the_help_names() -> None:
    printed = CliRunner().invoke(app, ["schema", "--help"]).stdout
    assert "# yaml-language-server: $schema=cell.schema.json" in " ".join(printed.split())
