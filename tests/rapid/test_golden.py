"""Golden pairs: one feature each, a small program beside what it must come to.

golden/NAME.mod (several modules in one file, or a folder golden/NAME/ of them) and golden/NAME.json:

    feature      one line, unlike all others
    cell         what the cell file says: signals, answers, waits, searches, ...; robot and start are filled in
    robot        "irb140" or "irb140_rail": the program may ask where it is, and confdata is checked
    entry        the procedure to run, "main" if left out
    motions      an object per motion, with those fields of `parse --json` that matter; their number counts
    error        instead of motions: what is said, line by line, the file's name left out
    warnings     texts, each a part of one warning of its own; with [] there must be none
    line_length, arc_length, ignored, configurations, notes: as in `parse --json`

Numbers agree within 1e-4. Objects in lists may be told in part, other objects are told whole.
"""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli.listing_record import listing_record
from trajopt_cli.cli.parse import notes_on
from trajopt_cli.errors import InputError
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.problem.configurations import check_configurations
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.language.text import read_text
from trajopt_cli.rapid.listing import describe
from trajopt_cli.rapid.reader import run_program

FOLDER = Path(__file__).parent / "golden"
MODULES = {".mod", ".sys", ".prg", ".modx", ".sysx"}
KEYS = {
    *("feature", "cell", "robot", "entry", "motions", "error", "warnings"),
    *("line_length", "arc_length", "ignored", "configurations", "notes"),
}
TOLERANCE = 1e-4
LEAST = 60  # pairs

ROBOTS: dict[str, dict[str, Any]] = {
    "irb140": {"robot": "irb140", "start": {"joints": "[0, 0, 0, 0, 30, 0] deg"}},
    "irb140_rail": {
        "robot": "irb140_rail",
        "rail": {"eax": "a", "stroke": [-0.2, 2.2]},
        "limits": {"rail": {"velocity": 1.0, "acceleration": 3.0, "source": "a test"}},
        "start": {"joints": "[0, 0, 0, 0, 30, 0] deg", "rail": 0},
    },
}


def names() -> list[str]:
    return sorted(path.stem for path in FOLDER.glob("*.json"))


@cache
def wanted(name: str) -> dict[str, Any]:
    content: dict[str, Any] = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    return content


def modules(name: str) -> list[TextFile]:
    """The program's files under the name they have in the folder, so that messages tell of no machine."""
    folder = FOLDER / name
    paths = [p for p in sorted(folder.rglob("*")) if p.suffix in MODULES] if folder.is_dir() else [folder]
    if paths == [folder]:
        paths = [path for path in FOLDER.glob(f"{name}.*") if path.suffix in MODULES]
    return [replace(read_text(path), path=path.relative_to(FOLDER).as_posix()) for path in paths]


def run(name: str) -> tuple[Program, dict[str, Any]]:
    """The program of a pair, and its record as `parse --json` prints it."""
    content = wanted(name)
    cell = parse_cell(json.dumps(ROBOTS[content.get("robot", "irb140")] | content.get("cell", {})), "cell.yaml")
    plant = build_plant(cell) if "robot" in content else None
    kinematics = None if plant is None else PlantKinematics(plant)
    program = run_program(modules(name), cell.scenario, content.get("entry", "main"), kinematics)
    listing = describe(program, kinematics)
    found = None if plant is None else check_configurations(program, plant)
    return program, listing_record(program, listing, found, [*notes_on(program, listing, plant)])


def differs(found: Any, expected: Any, where: str, part: bool) -> list[str]:
    """What is not as expected, each with its place; part: an object may tell only some of its keys."""
    if isinstance(expected, dict) and isinstance(found, dict):
        unknown = [f"{where}: no such field '{key}'" for key in expected.keys() - found.keys()]
        extra = [] if part else [f"{where}.{key}: {found[key]!r}" for key in found.keys() - expected.keys()]
        both = expected.keys() & found.keys()
        return (
            unknown + extra + [d for key in both for d in differs(found[key], expected[key], f"{where}.{key}", False)]
        )
    if isinstance(expected, list) and isinstance(found, list):
        if len(found) != len(expected):
            return [f"{where}: {len(found)} of them, expected {len(expected)}: {found!r}"]
        return [
            d
            for i, (one, other) in enumerate(zip(found, expected, strict=True))
            for d in differs(one, other, f"{where}[{i}]", True)
        ]
    numbers = all(isinstance(value, int | float) and not isinstance(value, bool) for value in (found, expected))
    if numbers:
        return [] if abs(found - expected) <= TOLERANCE else [f"{where}: {found!r}, expected {expected!r}"]
    return [] if found == expected and type(found) is type(expected) else [f"{where}: {found!r}, expected {expected!r}"]


def without_files(text: str, files: list[TextFile]) -> str:
    for file in files:
        text = text.replace(f"{file.path}:", "")
    return text


def unmatched(warnings: list[str], expected: list[str]) -> list[str]:
    """Expected parts that no warning of its own has; with none expected, the warnings there are."""
    left = list(warnings)
    missing = []
    for part in expected:
        found = next((warning for warning in left if part in warning), None)
        if found is None:
            missing.append(part)
        else:
            left.remove(found)
    return missing if expected else left


@pytest.mark.parametrize("name", names())
def test_program_comes_to(name: str) -> None:
    content = wanted(name)
    if "error" in content:
        with pytest.raises(InputError) as caught:
            run(name)
        assert without_files(str(caught.value), modules(name)) == content["error"]
        return
    program, record = run(name)
    for key in ("motions", "line_length", "arc_length", "ignored", "configurations", "notes"):
        if key in content:
            assert differs(record[key], content[key], key, False) == [], json.dumps(record[key], indent=1)
    if "warnings" in content:
        assert unmatched([*map(str, program.warnings)], content["warnings"]) == [], tuple(map(str, program.warnings))


def test_every_program_has_its_expectation_and_the_other_way_round() -> None:
    programs = {path.stem for path in FOLDER.iterdir() if path.suffix in MODULES or path.is_dir()}
    strangers = [p.name for p in FOLDER.iterdir() if p.is_file() and p.suffix not in {*MODULES, ".json"}]
    assert programs == set(names())
    assert strangers == []


def test_every_pair_shows_a_feature_of_its_own() -> None:
    features = [wanted(name)["feature"] for name in names()]
    assert [one for one in features if features.count(one) > 1] == []
    assert len(features) >= LEAST


@pytest.mark.parametrize("name", names())
def test_an_expectation_says_something_and_nothing_unknown(name: str) -> None:
    content = wanted(name)
    assert content.keys() <= KEYS
    assert content["feature"].strip()
    assert "\n" not in content["feature"]
    assert "error" in content or "motions" in content or content.get("warnings")


@pytest.mark.parametrize(
    ("found", "expected", "part", "count"),
    [
        ({"a": 1, "b": 2}, {"a": 1}, True, 0),
        ({"a": 1, "b": 2}, {"a": 1}, False, 1),
        ({"a": 1.00009}, {"a": 1}, True, 0),
        ({"a": 1.0002}, {"a": 1}, True, 1),
        ({"a": None}, {"a": 0}, True, 1),
        ({"a": True}, {"a": 1}, True, 1),
        ({"a": 1}, {"c": None}, True, 1),
        ([{"a": 1, "b": 2}], [{"a": 1}], False, 0),
        ([1, 2], [1], False, 1),
        ([[1, 2]], [[1, 3]], False, 1),
        ({"a": {"b": 1, "c": 2}}, {"a": {"b": 1}}, True, 1),
    ],
)
def test_the_comparison_sees_what_differs(found: Any, expected: Any, part: bool, count: int) -> None:
    assert len(differs(found, expected, "", part)) == count
