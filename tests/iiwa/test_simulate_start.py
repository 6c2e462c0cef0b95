"""The law alone against the whole loop on an arm that follows exactly, where the path begins away from the start."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.iiwa.job.folder import Opened
from trajopt_cli.iiwa.job.segments import make_segments
from trajopt_cli.iiwa.job.simulation import Simulated, run_controller
from trajopt_cli.iiwa.task.model import Feed, Integration
from trajopt_cli.robot.srs import load_srs

TASK = """\
start: {{joints: "[0, 30, 0, -100, 0, 50, 0] deg"}}
h: 4 ms
approach: none
profile: trapezoid
rotation: {rotation}
angles: {angles}
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
poses:
  - {first}
  - {{name: second, by: [0.02, -0.06, 0.03, 5 deg, 10 deg, -8 deg]}}
tool: {{position: [0, 0, 0.1]}}
K: [1000, 800, 1200, 30, 25, 40]
D: [500, 400, 300, 20, 15, 25]
M: [25, 25, 25, 3, 3, 3]
pushes: [{{from: 0.1, to: 0.2, force: [5, 0, -5, 0.3, 0, 0]}}]
"""
HOME = np.radians([0.0, 30, 0, -100, 0, 50, 0])
# The orientation at the start is a half turn about y, which absolute angles have to name.
FIRST = {
    "relative": "{name: first, at: [0.55, 0.05, 0.21, 12 deg, -15 deg, 20 deg]}",
    "absolute": "{name: first, at: [0.55, 0.05, 0.21, -165 deg, 10 deg, 170 deg]}",
}


def opened(tmp_path: Path, rotation: str, angles: str) -> Opened:
    task = tmp_path / "off.yaml"
    task.write_text(TASK.format(rotation=rotation, angles=angles, first=FIRST[angles]))
    return make_segments(task, tmp_path / "off", None, None).opened


@pytest.mark.parametrize("rotation", ["tait-bryan", "slerp"])
@pytest.mark.parametrize("angles", ["relative", "absolute"])
@pytest.mark.parametrize(("feed", "step"), [(Feed.POSITION, Integration.EULER), (Feed.VELOCITY, Integration.EXACT)])
def test_the_law_alone_begins_where_the_loop_does(
    tmp_path: Path, rotation: str, angles: str, feed: Feed, step: Integration
) -> None:
    job = opened(tmp_path, rotation, angles)
    alone, loop = (run_controller(job, None, engine, feed, step, None) for engine in (None, "spring"))
    assert isinstance(alone, Simulated)
    assert isinstance(loop, Simulated)
    assert (alone.loop, loop.broken) == (None, ())
    X = load_srs("iiwa7").forward(HOME)
    np.testing.assert_allclose(alone.x[0], np.r_[X[:3, 3] + 0.1 * X[:3, 2], 0, 0, 0], rtol=0, atol=1e-9)
    assert np.linalg.norm(alone.x_e[0] - alone.x[0]) > 0.05
    np.testing.assert_allclose(alone.x, loop.x, rtol=0, atol=1e-7)
    np.testing.assert_allclose(alone.x_e, loop.x_e, rtol=0, atol=1e-12)
    assert alone.lag.maximum == pytest.approx(loop.lag.maximum, abs=1e-7)
    assert alone.lag.turn_maximum == pytest.approx(loop.lag.turn_maximum, abs=1e-7)
    assert alone.settle == round(alone.settle, 1)


def test_runs_end_together_however_long_the_last_pose_is_held(tmp_path: Path) -> None:
    job = opened(tmp_path, "tait-bryan", "relative")
    runs = [run_controller(job, None, engine, Feed.POSITION, None, 0.0048) for engine in (None, "spring")]
    rows = [len(run.x) for run in runs if isinstance(run, Simulated)]
    assert rows == [len(job.equilibrium.pose) + 2] * 2
