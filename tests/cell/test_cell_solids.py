"""Obstacles and what the flange carries in a cell file: what they mean, and the text of every message."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.shapes import Box, Capsule, Mesh

ARM = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\n"
LINKS = "base_link, link_1, link_2, link_3, link_4, link_5, link_6"
TRIANGLE = (
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 50 0 0\nvertex 0 20 10\nendloop\nendfacet\nendsolid\n"
)


def message(text: str, plant: bool = False) -> str:
    read = (lambda: build_plant(parse_cell(text, "cell.yaml"))) if plant else (lambda: parse_cell(text, "cell.yaml"))
    with pytest.raises(InputError) as caught:
        read()
    return str(caught.value)


def obstacle(text: str) -> str:
    return f"{ARM}obstacles:\n  table: {text}\n"


def test_every_kind_of_body_with_units(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "vise.stl").write_text(TRIANGLE)
    (tmp_path / "cell.yaml").write_text(
        ARM + "obstacles:\n"
        '  table: {box: {size: "[800, 600, 40] mm", position: [0.5, 0, -0.02]}, ignore: [base_link, gripper]}\n'
        "  turned: {box: {size: [1, 2, 3], position: [1, 2, 3], rpy: [90 deg, 0, 90 deg]}}\n"
        "  post: {capsule: {from: [0, 0, 0], to: [0, 0, 1.2], radius: 50 mm}}\n"
        "  vise: {mesh: {file: parts/vise.stl, scale: 0.001, position: [0.1, 0, 0], wxyz: [0.5, 0.5, 0.5, 0.5]}}\n"
        "attached:\n"
        "  gripper: {capsule: {from: [0, 0, 0.05], to: [0, 0, 0.05], radius: 0.04}}\n"
        "clearance: 10 mm\n"
    )
    cell = load_cell(tmp_path / "cell.yaml")
    assert cell.mesh_files == (tmp_path / "parts" / "vise.stl",)
    plant = build_plant(cell)
    table, turned, post, vise = plant.obstacles
    assert plant.clearance == 0.01
    assert plant.unchecked == ()
    assert table.ignore == {"base_link", "gripper"}
    assert isinstance(table.shape, Box)
    np.testing.assert_allclose(table.shape.size, [0.8, 0.6, 0.04])
    np.testing.assert_array_equal(table.shape.X[:3, 3], [0.5, 0, -0.02])
    assert isinstance(turned.shape, Box)
    turn = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]])  # Rz(90) Rx(90): x to y, y to z, z to x
    np.testing.assert_allclose(turned.shape.X[:3, :3], turn, atol=1e-15)
    assert isinstance(post.shape, Capsule)
    assert (post.shape.b[2], post.shape.radius) == (1.2, 0.05)
    assert isinstance(vise.shape, Mesh)
    np.testing.assert_allclose(np.sort(vise.shape.vertices, axis=0), [[0, 0, 0], [0, 0, 0], [0.05, 0.02, 0.01]])
    np.testing.assert_allclose(vise.shape.X[:3, :3], turn, atol=1e-15)
    (gripper,) = plant.attached
    assert (gripper.name, gripper.ignore) == ("gripper", frozenset())


def test_a_cell_without_obstacles_says_so() -> None:
    plant = build_plant(parse_cell(ARM, "cell.yaml"))
    assert (plant.obstacles, plant.attached, plant.clearance) == ((), (), 0.0)
    assert plant.unchecked == ("obstacles not checked: the cell file gives none",)


def test_a_robot_without_shapes_says_so(tmp_path: Path) -> None:
    robots = Path(__file__).parents[2] / "robots"
    (tmp_path / "bare.yaml").write_text((robots / "irb140.yaml").read_text().split("collision:\n")[0])
    (tmp_path / "irb140.urdf").write_text((robots / "irb140.urdf").read_text())
    text = ARM.replace("irb140", f"'{tmp_path / 'bare.yaml'}'") + "obstacles: {table: {box: {size: [1, 1, 1]}}}\n"
    assert build_plant(parse_cell(text, "cell.yaml")).unchecked == (
        "obstacles not checked: robot irb140 has no collision shapes",
        "self-collision not checked: robot irb140 has no collision shapes",
    )


BOX = "{box: {size: [1, 1, 1]}}"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            obstacle("{box: {size: [1, 0, 1]}}"),
            "cell.yaml:4: obstacles.table.box.size: needs a number above zero, not 0",
        ),
        (obstacle("{box: {size: [1, 1]}}"), "cell.yaml:4: obstacles.table.box.size: needs 3 numbers, not 2"),
        (obstacle("{box: {position: [1, 1, 1]}}"), "cell.yaml:4: obstacles.table.box.size: is missing; add it"),
        (
            obstacle("{box: {size: [1, 1, 1 kg]}}"),
            "cell.yaml:4: obstacles.table.box.size: unit 'kg' of \"1 kg\" is not one of m, cm, mm",
        ),
        (
            obstacle("{box: {size: [1, 1, .inf]}}"),
            "cell.yaml:4: obstacles.table.box.size: needs a finite number, not inf",
        ),
        (
            obstacle("{box: {size: [1, 1, 1], postion: [0, 0, 0]}}"),
            "cell.yaml:4: obstacles.table.box.postion: unknown key; did you mean 'position'?",
        ),
        (
            obstacle("{capsule: {form: [0, 0, 0], to: [0, 0, 1], radius: 1}}"),
            "cell.yaml:4: obstacles.table.capsule.from: is missing; add it\n"
            "cell.yaml:4: obstacles.table.capsule.form: unknown key; did you mean 'from'?",
        ),
        (
            obstacle("{capsule: {from: [0, 0, 0], to: [0, 0, 1], radius: 0}}"),
            "cell.yaml:4: obstacles.table.capsule.radius: needs a number above zero, not 0",
        ),
        (
            obstacle("{mesh: {file: ../table.stl}}"),
            "cell.yaml:4: obstacles.table.mesh.file: needs a file in the cell file's folder or below it, which results "
            "can keep, not '../table.stl'",
        ),
        (
            obstacle("{mesh: {file: t.stl, scale: -1}}"),
            "cell.yaml:4: obstacles.table.mesh.scale: needs a number above zero, not -1",
        ),
        (
            obstacle("{box: {size: [1, 1, 1]}, capsule: {from: [0, 0, 0], to: [0, 0, 1], radius: 1}}"),
            "cell.yaml:4: obstacles.table: has box and capsule; give one of box, capsule or mesh",
        ),
        (
            obstacle("{ignore: [link_1]}"),
            "cell.yaml:4: obstacles.table: has no shape; give one of box, capsule or mesh",
        ),
        (
            obstacle("{bx: {size: [1, 1, 1]}}"),
            "cell.yaml:4: obstacles.table.bx: unknown key; did you mean 'box'?",
        ),
        (obstacle("1"), "cell.yaml:4: obstacles.table: needs a section of 'key: value' lines, not 1"),
        (ARM + "obstacles: [1]\n", "cell.yaml:3: obstacles: needs a section of 'key: value' lines, not [1]"),
        (
            ARM + f"obstacles:\n  table: {BOX}\n  table: {BOX}\n",
            'cell.yaml:5: broken YAML: found duplicate key "table"',
        ),
        (
            ARM + f"obstacles: {{table: {BOX}}}\nattached: {{table: {BOX}}}\n",
            "cell.yaml:4: attached.table: an obstacle has this name too; give each body its own",
        ),
        (
            ARM + "may_touch: [link_1, link_4]\n",
            "cell.yaml:3: may_touch.0: needs two names, '[link_1, link_4]', not link_1\n"
            "cell.yaml:3: may_touch.1: needs two names, '[link_1, link_4]', not link_4",
        ),
        (ARM + "clearance: -1 mm\n", "cell.yaml:3: clearance: cannot be negative: -0.001"),
        (ARM + "clearance: 3 deg\n", "cell.yaml:3: clearance: unit 'deg' of \"3 deg\" is not one of m, cm, mm"),
    ],
)
def test_messages_of_the_file(text: str, expected: str) -> None:
    assert message(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            obstacle("{box: {size: [1, 1, 1]}, ignore: [base_lnk]}"),
            "cell.yaml:4: obstacles.table.ignore: 'base_lnk' cannot touch it; did you mean 'base_link'?",
        ),
        (
            ARM + f"attached: {{grip: {{box: {{size: [1, 1, 1]}}, ignore: [table]}}}}\nobstacles: {{table: {BOX}}}\n",
            f"cell.yaml:3: attached.grip.ignore: 'table' cannot touch it; known: {LINKS}",
        ),
        (
            ARM + f"obstacles: {{link_3: {BOX}}}\n",
            "cell.yaml:3: obstacles.link_3: robot irb140 has a link of this name; give the body another name",
        ),
        (
            ARM + "may_touch:\n  - [link_4, link_1]\n  - [link_1, link_3]\n",
            "cell.yaml:5: may_touch.1: [link_1, link_3] is not a pair that is checked; known: [base_link, link_3], "
            "[base_link, link_4], [base_link, link_5], [base_link, link_6], [link_1, link_4], [link_1, link_5], "
            "[link_1, link_6]",
        ),
        (
            obstacle("{mesh: {file: table.stl}}"),
            "cell.yaml:4: obstacles.table.mesh.file: no such mesh file: table.stl",
        ),
    ],
)
def test_messages_of_the_plant(text: str, expected: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert message(text, plant=True) == expected


def test_a_broken_mesh_is_said_at_its_key(tmp_path: Path) -> None:
    (tmp_path / "table.stl").write_text("solid but nothing follows, not even one facet of it")
    (tmp_path / "cell.yaml").write_text(obstacle("{mesh: {file: table.stl}}"))
    cell = load_cell(tmp_path / "cell.yaml")
    with pytest.raises(InputError) as caught:
        build_plant(cell)
    said = str(caught.value)
    assert said.startswith(f"{tmp_path / 'cell.yaml'}:4: obstacles.table.mesh.file: ")
    assert "table.stl" in said
    assert "\n" not in said


def test_pairs_that_may_touch_are_left_out_in_either_order() -> None:
    grip = "attached: {grip: {box: {size: [0.1, 0.1, 0.1]}, ignore: [link_3]}}\n"
    all_pairs = build_plant(parse_cell(ARM + grip, "c")).self_pairs
    assert [pair for pair in all_pairs if "grip" in pair] == [(n, "grip") for n in ("base_link", "link_1", "link_2")]
    text = ARM + grip + "may_touch: [[link_4, link_1], [link_2, grip]]\n"
    left = build_plant(parse_cell(text, "c")).self_pairs
    assert set(all_pairs) - set(left) == {("link_1", "link_4"), ("link_2", "grip")}
    none = ", ".join(f"[{a}, {b}]" for a, b in build_plant(parse_cell(ARM, "c")).self_pairs)
    assert build_plant(parse_cell(f"{ARM}may_touch: [{none}]\n", "c")).unchecked[-1] == (
        "self-collision not checked: the cell file lets every pair touch"
    )


def test_units_do_not_change_a_body() -> None:
    metres = parse_cell(obstacle("{box: {size: [1, 2, 3], rpy: [0, 0, 0.5]}}"), "c").obstacles[0].shape
    turn = f"[0, 0, {math.degrees(0.5):.17g}] deg"
    text = f'{{box: {{size: "[100, 200, 300] cm", rpy: "{turn}"}}}}'
    others = parse_cell(obstacle(text), "c").obstacles[0].shape
    assert isinstance(metres, Box)
    assert isinstance(others, Box)
    np.testing.assert_allclose(others.size, metres.size, rtol=1e-15)
    np.testing.assert_allclose(others.X, metres.X, atol=1e-15)
