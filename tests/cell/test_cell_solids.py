"""Obstacles and what the flange carries in a cell file: what they mean, and the text of every message."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.problem.plant import build_plant, unwatched
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.model import load_robot
from trajopt_cli.shapes import Box, Capsule, Cue, Grip, Mesh

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


def test_a_fence_is_a_wall_along_its_points() -> None:
    """As far from any place as the floor plan says: the line of points, grown by half the thickness."""
    points = [(1.0, -1.0), (1.2, 0.5), (0.0, 1.5), (-1.0, 1.5)]
    text = obstacle("{fence: {points: [[1, -1], [1.2, 500 mm], [0, 1.5], [-1, 1.5]], height: 2, thickness: 40 mm}}")
    walls = build_plant(parse_cell(text, "c")).obstacles
    assert [wall.name for wall in walls] == ["table 1", "table 2", "table 3"]
    rng = np.random.default_rng(7)
    for _ in range(50):
        place = np.r_[rng.uniform(-2, 2, 2), 1.0]
        ball = Capsule("ball", place, place, 0.01)
        apart = []
        for p, q in pairwise(np.array(points)):
            s = np.clip((place[:2] - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
            apart.append(float(np.linalg.norm(place[:2] - p - s * (q - p))))
        found = min(Pair(ball, wall.shape).distance(np.eye(4), np.eye(4)) for wall in walls)
        assert found == pytest.approx(min(apart) - 0.02 - 0.01, abs=0.0085)  # square ends: (sqrt 2 - 1) half thickness
        assert found <= min(apart) - 0.03 + 1e-6
    heights = [Pair(Capsule("b", [1, -1, z], [1, -1, z], 0.1), walls[0].shape).distance(np.eye(4), np.eye(4))
               for z in (2.5, -0.5)]  # fmt: skip
    np.testing.assert_allclose(heights, 0.4, atol=1e-9)
    (alone,) = build_plant(parse_cell(obstacle("{fence: {points: [[1, 0], [1, 1]], height: 2}}"), "c")).obstacles
    assert alone.name == "table"


def test_the_rail_is_a_beam_under_the_base_from_end_to_end() -> None:
    text = (
        "robot: irb140_rail\nstart: {joints: [0, 0, 0, 0, 0.5, 0], rail: 0}\n"
        "rail: {eax: a, stroke: [-0.5, 2], track: {width: 400 mm, height: 0.3}, frame: {position: [0, 0, 0.3], "
        "rpy: [0, 0, 30 deg]}}\n"
    )
    plant = build_plant(parse_cell(text, "c"))
    (track,) = plant.obstacles
    assert (track.name, track.ignore) == ("track", {"base_link"})
    assert isinstance(track.shape, Box)
    np.testing.assert_allclose(track.shape.size, [3.0, 0.4, 0.3])
    for rail in (-0.5, 2.0):
        base = np.linalg.inv(track.shape.X) @ plant.robot.base(rail)
        np.testing.assert_allclose(base[:3, 3], [rail - 0.75, 0, 0.15], atol=1e-12)  # on the top, 0.25 m from the end
        assert abs(base[2, 2]) == pytest.approx(1)


def test_what_is_taken_on_the_way_and_when() -> None:
    cell = parse_cell(
        obstacle(f"{BOX}\n  cube: {BOX}") + 'attach:\n  - {part: cube, at: "cell.mod:41", detach: 57}\n'
        '  - {part: table, at: doGrip=1, detach: "doGrip = 0"}\n'
        "  - {part: cube, at: 60}\n",
        "c",
    )
    assert cell.grips == (
        Grip("cube", Cue("cell.mod", 41), Cue(None, 57)),
        Grip("table", Cue(signal="dogrip", value=1.0), Cue(signal="dogrip", value=0.0)),
        Grip("cube", Cue(None, 60)),
    )
    plant = build_plant(cell)
    assert [solid.name for solid in plant.parts] == ["table", "cube"]
    assert ("link_1", "cube") in plant.self_pairs


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
        "collisions not checked: robot irb140 has no bodies",
    )


def test_links_without_a_shape_are_named(tmp_path: Path) -> None:
    robots = Path(__file__).parents[2] / "robots"
    lines = (robots / "irb140.yaml").read_text().splitlines()
    kept = [line for line in lines if not any(word in line for word in ("link_3:", "link_3]", "[link_3"))]
    (tmp_path / "part.yaml").write_text("\n".join(kept))
    (tmp_path / "irb140.urdf").write_text((robots / "irb140.urdf").read_text())
    text = ARM.replace("irb140", f"'{tmp_path / 'part.yaml'}'") + "obstacles: {table: {box: {size: [1, 1, 1]}}}\n"
    cell = parse_cell(text, "cell.yaml")
    plant = build_plant(cell)
    (notice,) = unwatched(cell, plant.robot)
    assert plant.unchecked == ("collisions of link_3 not checked: robot irb140 has no bodies for them",)
    assert "link_3 of irb140 has no collision shape and may touch anything unseen" in str(notice)
    assert unwatched(parse_cell(text.replace(str(tmp_path / "part.yaml"), "irb140"), "c"), load_robot("irb140")) == ()


BOX = "{box: {size: [1, 1, 1]}}"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (obstacle("{box: {size: [1, 0, 1]}}"), "cell.yaml:4: obstacles.table.box.size:"),
        (obstacle("{box: {size: [1, 1]}}"), "cell.yaml:4:"),
        (obstacle("{box: {position: [1, 1, 1]}}"), "cell.yaml:4:"),
        (obstacle("{box: {size: [1, 1, 1 kg]}}"), "cell.yaml:4: obstacles.table.box.size:"),
        (obstacle("{box: {size: [1, 1, .inf]}}"), "cell.yaml:4: obstacles.table.box.size:"),
        (obstacle("{box: {size: [1, 1, 1], postion: [0, 0, 0]}}"), "cell.yaml:4: obstacles.table.box.postion:"),
        (
            obstacle("{capsule: {form: [0, 0, 0], to: [0, 0, 1], radius: 1}}"),
            "cell.yaml:4: obstacles.table.capsule.from:",
        ),
        (
            obstacle("{capsule: {from: [0, 0, 0], to: [0, 0, 1], radius: 0}}"),
            "cell.yaml:4: obstacles.table.capsule.radius:",
        ),
        (obstacle("{mesh: {file: ../table.stl}}"), "cell.yaml:4: obstacles.table.mesh.file:"),
        (obstacle("{mesh: {file: t.stl, scale: -1}}"), "cell.yaml:4: obstacles.table.mesh.scale:"),
        (
            obstacle("{box: {size: [1, 1, 1]}, capsule: {from: [0, 0, 0], to: [0, 0, 1], radius: 1}}"),
            "cell.yaml:4: obstacles.table:",
        ),
        (obstacle("{ignore: [link_1]}"), "cell.yaml:4: obstacles.table:"),
        (obstacle("{bx: {size: [1, 1, 1]}}"), "cell.yaml:4: obstacles.table.bx:"),
        (obstacle("1"), "cell.yaml:4: obstacles.table:"),
        (obstacle("{fence: {points: [[1, 0]], height: 2}}"), "cell.yaml:4:"),
        (obstacle("{fence: {points: [[1, 0], [1, 0]], height: 2}}"), "cell.yaml:4: obstacles.table.fence:"),
        (obstacle("{fence: {points: [[1, 0], [1, 2], [0, 2]], height: 2}}") + f"  table 2: {BOX}\n", "cell.yaml:5:"),
        (
            obstacle("{fence: {points: [[1, 0], [1, 2], [0, 2]], height: 2}}") + f"attached: {{table 1: {BOX}}}\n",
            "cell.yaml:5:",
        ),
        (
            obstacle("{fence: {points: [[1, 0], [1, 2]], height: 2}}") + "attach: [{part: table, at: 4}]\n",
            "cell.yaml:5: attach.0.part:",
        ),
        (
            ARM + "attached: {fence: {fence: {points: [[1, 0], [1, 2]], height: 2}}}\n",
            "cell.yaml:3: attached.fence.fence:",
        ),
        (obstacle(f"{BOX}\nattach: [{{part: tabel, at: 41}}]"), "cell.yaml:5: attach.0.part:"),
        (obstacle(f"{BOX}\nattach: [{{part: table, at: SetDO doGrip}}]"), "cell.yaml:5: attach.0.at:"),
        (obstacle(f"{BOX}\nattach: [{{part: table, at: 41, detach: 41}}]"), "cell.yaml:5: attach.0:"),
        (ARM + f"attached: {{grip: {BOX}}}\ntool_radius: 30 mm\n", "cell.yaml:4: tool_radius:"),
        (ARM + "tool_radius: 40\n", "cell.yaml:3: tool_radius:"),
        (ARM + "obstacles: [1]\n", "cell.yaml:3: obstacles:"),
        (ARM + f"obstacles:\n  table: {BOX}\n  table: {BOX}\n", "cell.yaml:5:"),
        (ARM + f"obstacles: {{table: {BOX}}}\nattached: {{table: {BOX}}}\n", "cell.yaml:4: attached.table:"),
        (ARM + "may_touch: [link_1, link_4]\n", "cell.yaml:3: may_touch.0:"),
        (ARM + "clearance: -1 mm\n", "cell.yaml:3: clearance:"),
        (ARM + "clearance: 3 deg\n", "cell.yaml:3: clearance:"),
    ],
)
def test_messages_of_the_file(text: str, expected: str) -> None:
    assert message(text).startswith(expected)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (obstacle("{box: {size: [1, 1, 1]}, ignore: [base_lnk]}"), "cell.yaml:4: obstacles.table.ignore:"),
        (
            ARM + f"attached: {{grip: {{box: {{size: [1, 1, 1]}}, ignore: [table]}}}}\nobstacles: {{table: {BOX}}}\n",
            f"cell.yaml:3: attached.grip.ignore: 'table' cannot touch it; known: {LINKS}",
        ),
        (ARM + f"obstacles: {{link_3: {BOX}}}\n", "cell.yaml:3: obstacles.link_3:"),
        (ARM + "may_touch:\n  - [link_4, link_1]\n  - [link_1, link_3]\n", "cell.yaml:5: may_touch.1:"),
        (obstacle("{mesh: {file: table.stl}}"), "cell.yaml:4: obstacles.table.mesh.file:"),
    ],
)
def test_messages_of_the_plant(text: str, expected: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert message(text, plant=True).startswith(expected)


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
