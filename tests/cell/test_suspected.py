"""Bare numbers that look like another unit: the odd ones are a warning, the absurd ones an error."""

from __future__ import annotations

from pathlib import Path

import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import parse_task
from trajopt_cli.problem.plant import build_plant

REPOSITORY = Path(__file__).parents[2]
CELL = """robot: irb140_rail
rail: {eax: a, stroke: [-0.2, 2.2]}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
TABLE = """positioners:
  STN1:
    - eax: b
      frame: {position: [0.65, 0.5, 0.1], rpy: [0, 0, 0]}
      range: "[-185, 185] deg"
      velocity: 150 deg/s
      acceleration: 300 deg/s2
      source: x
start:"""


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '"[0, 0, 0, 0, 30, 0] deg"',
            "[0, 0, 0, 0, 8, 0]",
            "cell.yaml:3: start.joints: 8 without a unit is 8 rad, 458.366 deg; if deg are meant, write "
            '"[0, 0, 0, 0, 8, 0] deg"',
        ),
        (
            "[-0.2, 2.2]",
            "[-2, 22]",
            'cell.yaml:2: rail.stroke: 22 without a unit is 22 m, 22000 mm; if mm are meant, write "[-2, 22] mm"',
        ),
        (
            "start:",
            "limits: {joint_1: {velocity: 250, source: x}}\nstart:",
            "cell.yaml:3: limits.joint_1.velocity: 250 without a unit is 250 rad/s, 14323.9 deg/s; if deg/s are meant, "
            'write "250 deg/s"',
        ),
        (
            "start:",
            "tcp: {speed: 1e2, acceleration: 20, source: x}\nstart:",
            'cell.yaml:3: tcp.speed: 100 without a unit is 100 m/s, 100000 mm/s; if mm/s are meant, write "100 mm/s"',
        ),
        (
            "start:",
            "obstacles: {post: {box: {size: [0.1, 0.1, 50]}}}\nstart:",
            "cell.yaml:3: obstacles.post.box.size: 50 without a unit is 50 m, 50000 mm; if mm are meant, write "
            '"[0.1, 0.1, 50] mm"',
        ),
    ],
)
def test_an_odd_number_is_a_warning(old: str, new: str, said: str) -> None:
    assert old in CELL
    cell = parse_cell(CELL.replace(old, new, 1), "cell.yaml")
    assert [str(one) for one in cell.doubts] == [said]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"[0, 0, 0, 0, 30, 0] deg"', "[0, 0, 0, 0, 30, 0]", 'write "[0, 0, 0, 0, 30, 0] deg"'),
        ("start:", "limits: {joint_2: {upper: 90, source: x}}\nstart:", "limits.joint_2.upper: 90 without a unit"),
        ("start:", "limits: {rail: {velocity: 1500, source: x}}\nstart:", 'if mm/s are meant, write "1500 mm/s"'),
        (
            "start:",
            "obstacles: {t: {capsule: {from: [0, 0, 0], to: [0, 0, 900], radius: 40}}}\nstart:",
            "[0, 0, 900] mm",
        ),
        ("[-0.2, 2.2]", "[-200, 2200]", "no rail is longer than 100 m"),
        ("start:", TABLE.replace("0.65, 0.5", "650, 500"), 'if mm are meant, write "[650, 500, 0.1] mm"'),
        ("start:", TABLE.replace("0.65", "1.0e+8"), "STN1.0.frame: position reaches 1e+08 m, at most 10000 m"),
        ("start:", TABLE.replace("[0, 0, 0]", "[0, 0, 90]"), "rpy: 90 without a unit is 90 rad, 5156.62 deg"),
        ("start:", TABLE.replace("185] deg", "1e300] deg"), "STN1.0: range goes from -3.22886 to 1.74533e+298 rad, at"),
    ],
)
def test_an_absurd_number_is_refused(old: str, new: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_cell(CELL.replace(old, new, 1), "cell.yaml")
    assert said in str(caught.value)
    assert str(caught.value).startswith("cell.yaml:")
    assert "\n" not in str(caught.value)


def test_a_start_that_was_meant_in_degrees_is_told_where_the_range_forbids_it() -> None:
    cell = parse_cell("robot: irb140\nstart: {joints: [0, 0, 0, 0, 8, 0]}\n", "cell.yaml")
    with pytest.raises(InputError, match=r'lies outside its range .*; if this is in degrees, write "8 deg"'):
        build_plant(cell)


def test_what_has_a_unit_or_is_plausible_is_taken_as_it_is() -> None:
    text = CELL + (
        "limits: {joint_6: {lower: -6.98, upper: 400 deg, velocity: 450 deg/s, source: x}}\n"
        "obstacles: {floor: {box: {size: [10, 10, 0.1], rpy: [0, 0, 3.2]}}, far: {box: {size: '[90, 1, 1] m'}}}\n"
    )
    assert parse_cell(text, "cell.yaml").doubts == ()
    for path in (REPOSITORY / "programs").glob("*.yaml"):
        if "robot: irb" in path.read_text():
            assert parse_cell(path.read_text(), str(path)).doubts == ()


def test_a_task_of_an_iiwa_is_looked_at_too() -> None:
    path = REPOSITORY / "programs" / "iiwa_cube.yaml"
    text = path.read_text()
    assert parse_task(text, str(path)).notes == ()
    odd = parse_task(text.replace("v_max: 0.4 m/s", "v_max: 400"), str(path)).notes
    assert len(odd) == 1
    assert '400 without a unit is 400 m/s, 400000 mm/s; if mm/s are meant, write "400 mm/s"' in odd[0]
    with pytest.raises(InputError, match=r"start\.joints: -100 without a unit is -100 rad"):
        parse_task(text.replace('"[0, 30, 0, -100, 0, 50, 0] deg"', "[0, 30, 0, -100, 0, 50, 0]"), str(path))
