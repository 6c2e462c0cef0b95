"""`trajopt cell show` and `trajopt view CELL.yaml`: every body of a cell, without a plan."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from trajopt_cli.cli import run

CELL = """robot: irb140
start: {joints: "[0, 0, 0, 0, 30, 0] deg"}
positioners:
  STN1: {eax: b, frame: {position: [0.6, 0, 0]}, range: "[-90, 90] deg", velocity: 1, acceleration: 1, start: 90 deg,
    source: a test}
obstacles:
  post: {on: STN1, box: {size: [0.2, 0.1, 0.3], position: [0.1, 0, 0.15]}, ignore: [base_link]}
  cell: {list: {file: bodies.csv}}
attached: {grip: {capsule: {from: [0, 0, 0], to: [0, 0, 0.1], radius: 0.02}}}
"""


@pytest.fixture
def cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "tetra.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    (tmp_path / "bodies.csv").write_text("name,file,x [mm],y [mm],z [mm]\ncorner,tetra.obj,1000,0,0\n")
    (tmp_path / "c.yaml").write_text(CELL)
    monkeypatch.chdir(tmp_path)
    return tmp_path / "c.yaml"


def test_every_body_is_listed_with_the_box_around_it(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The table stands at 90 degrees: the post's length lies along y."""
    assert run(["cell", "show", str(cell), "--json"]) == 0
    found = {one["name"]: one for one in json.loads(capsys.readouterr().out)["bodies"]}
    assert list(found) == ["post", "cell/corner", "grip"]
    assert found["post"]["low"] == pytest.approx([0.55, 0.0, 0.0])
    assert found["post"]["high"] == pytest.approx([0.65, 0.2, 0.3])
    assert (found["post"]["on"], found["post"]["ignore"]) == ("stn1", ["base_link"])
    assert found["cell/corner"]["kind"].endswith("solid")
    assert found["cell/corner"]["high"] == pytest.approx([2, 1, 1])
    assert (found["grip"]["on"], found["grip"]["high"]) == ("flange", pytest.approx([0.02, 0.02, 0.12]))
    assert run(["cell", "show", str(cell)]) == 0
    assert all(name in capsys.readouterr().out for name in ("post",))
    assert run(["cell", "show", str(cell), "--quiet"]) == 0
    assert "3 bodies" in capsys.readouterr().out


def test_a_cell_is_drawn_without_a_plan(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["view", str(cell), "--print"]) == 0
    assert Path(capsys.readouterr().out.strip()) == cell.parent / "c.html"
    page = (cell.parent / "c.html").read_text()
    block = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert block is not None
    scene = json.loads(block[1])["scene"]
    assert {one["name"] for one in scene["static"]} == {"cell/corner"}
    (post,) = (one for one in scene["bodies"] if one["name"] == "post")
    assert post["link"] == len(scene["chain"])
    assert "turned" in scene["cycles"][0]
    assert run(["view", str(cell), "--print", "--output", "other.html"]) == 0
    assert (cell.parent / "other.html").read_text() == page


@pytest.mark.parametrize(
    "arguments", [["cell", "show", "nothing.yaml"], ["view", "nothing.yaml"], ["view", ".", "--output", "x.html"]]
)
def test_what_is_no_cell_is_refused(cell: Path, arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(arguments) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1
