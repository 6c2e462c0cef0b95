"""report.html of the compliant job: what its charts carry, and what it says of runs that end badly."""

from __future__ import annotations

import json
import re
from base64 import b64decode, b64encode
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.experiments.catalogue import experiments_page
from trajopt_cli.iiwa.report.page import AFTER, Chart, Curve, charts_data

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses:
  - {name: start, at: start}
  - {name: side, by: [0, 0.06, 0, 0, 0, 10 deg]}
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""


def unpacked(block: dict[str, Any]) -> Array:
    return np.frombuffer(b64decode(block["f32"]), "<f4").reshape(block["shape"]).astype(np.float64)


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert found
    return json.loads(found[1])


def folder_of(tmp_path: Path, task: str) -> Path:
    (tmp_path / "small.yaml").write_text(task)
    assert run(["iiwa", "segments", str(tmp_path / "small.yaml"), "--output", str(tmp_path / "out")]) == 0
    return tmp_path / "out"


def test_a_chart_keeps_the_one_sample_that_matters() -> None:
    t = np.arange(100_000) * 1e-3
    y = np.sin(t)
    y[54_321] = -7.0
    specs, arrays = charts_data([Chart("one", "One", "mm", [Curve("y", t, y, AFTER)], [(5.0, "allowed")], peak=True)])
    (series,) = specs["one"]["series"]
    shown_t, shown_y = unpacked(arrays[series["t"]]), unpacked(arrays[series["y"]])
    assert len(shown_t) == len(shown_y) < 6000
    assert shown_t[int(np.argmin(shown_y))] == pytest.approx(54.321)
    assert shown_y.min() == -7.0
    assert specs["one"]["points"] == [{"t": pytest.approx(54.321), "y": -7.0}]
    assert specs["one"]["limits"] == [{"value": 5.0, "name": "allowed"}]


def test_a_simulation_is_shown_as_it_is_written(tmp_path: Path) -> None:
    folder = folder_of(tmp_path, TASK)
    assert run(["iiwa", "simulate", str(folder)]) == 0
    page = (folder / "report.html").read_text()
    assert len(page) < 1_000_000
    data, summary = data_of(page), json.loads((folder / "summary.json").read_text())["simulation"]
    assert [one["name"] for one in data["clock"]["cycles"]] == ["commanded", "predicted"]
    assert data["clock"]["duration"] == pytest.approx(summary["duration_s"])
    lag = unpacked(data["arrays"][data["charts"]["lag"]["series"][0]["y"]])
    assert lag.max() == pytest.approx(1000 * summary["lag"]["largest_m"], rel=1e-6)
    assert f"{1000 * summary['lag']['largest_m']:.2f} mm" in page
    (chart,) = [one for name, one in data["charts"].items() if name == "joint-0"]
    assert [one["value"] for one in chart["limits"]] == pytest.approx([-170, 170])
    assert "report.html" in json.loads((folder / "run.json").read_text())["files"]


def test_a_dosed_sequence_stands_beside_what_it_was_made_from(tmp_path: Path) -> None:
    folder, dosed = folder_of(tmp_path, TASK), tmp_path / "dosed"
    assert run(["iiwa", "dose", str(folder), "--max-lag", "20mm", "--output", str(dosed)]) == 0
    page = (dosed / "report.html").read_text()
    data, summary = data_of(page), json.loads((dosed / "summary.json").read_text())["dosing"]
    assert [one["name"] for one in data["clock"]["cycles"]] == ["as programmed", "scheduled, inverse law"]
    assert data["charts"]["lag"]["limits"] == [{"value": pytest.approx(20.0), "name": "allowed"}]
    before, after = (unpacked(data["arrays"][one["y"]]).max() for one in data["charts"]["lag"]["series"])
    assert before > 20.0 >= after - 1e-5
    made = summary["feeds"]["inverse"]
    assert f"{made['duration_s']:.3f} s" in page
    assert f"{made['least_duration_s']:.3f} s" in page


def test_a_run_that_the_arm_cannot_follow_shows_what_was_asked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = folder_of(tmp_path, TASK + "pushes: [{from: 0.1, to: 0.9, force: [0, 0, 3000, 0, 0, 0]}]\n")
    assert run(["iiwa", "simulate", str(folder)]) == 1
    (told,) = [line for line in capsys.readouterr().err.splitlines() if "cannot be reached" in line]
    page = (folder / "report.html").read_text()
    data = data_of(page)
    assert [one["name"] for one in data["clock"]["cycles"]] == ["commanded"]
    assert [one["name"] for one in data["scene"]["cycles"]] == ["commanded"]
    assert '<dd class="big">broken</dd>' in page
    assert escape(told.split(";")[0]) in page


def test_the_experiments_numbers_in_units_for_people() -> None:
    numbers = {
        "engine": "spring",
        "flange_worst": [],
        "flange_worst_notes": [],
        "speed": {
            "section": "6.2.1",
            "title": "speed",
            "notes": ["a note"],
            "largest_relative_difference": 0.123,
            "rows": [{"value": 0.1, "thesis_deviation_m": 0.089, "relative_difference": None}],
        },
        "stability": {
            "section": "6.1.8",
            "title": "<b>",
            "notes": [],
            "runs": [
                {"label": "k", "axes": [{"axis": "alpha", "steady": np.pi / 180, "force": 2.0, "settling_s": 1.0}]}
            ],
        },
        "loop_time": {"section": "6.3", "title": "time", "notes": [], "thesis_worst_s": 0.5},
    }
    speed, loop = b"<svg>1</svg>", b"<svg>2</svg>"
    pictures = {
        "speed": {"speed.svg": speed, "speed.png": b"png"},
        "stability": {"stability.svg": b"x" * 700_000},
        "loop_time": {"loop_time.svg": loop},
    }
    page = experiments_page(numbers, pictures).decode()
    for wanted in (
        "thesis deviation [mm]",
        ">89<",
        "largest relative difference</dt><dd>0.123<",
        "1.000 °",
        "2 Nm",
        "&lt;b&gt;",
        ">–<",
    ):
        assert wanted in page
    assert b64encode(speed).decode() in page
    assert b64encode(loop).decode() not in page
    assert "Not in this page, for its size: stability.svg" in page
    assert len(page) < 200_000
