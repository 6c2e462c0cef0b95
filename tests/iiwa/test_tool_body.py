"""A tool's own body against obstacles, and starts inside of them: depths by hand, pushes by MuJoCo."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.job.segments import Segments, make_segments
from trajopt_cli.iiwa.job.simulation import Simulated, run_controller
from trajopt_cli.robot.srs import load_srs

HOME = np.radians([0.0, 30, 0, -100, 0, 50, 0])
FLANGE = load_srs("iiwa7").forward(HOME)[:3, 3]  # the tool points down from there


def off(*by: float) -> np.ndarray:
    return FLANGE + np.array(by)


TASK = """\
start: {{joints: "[0, 30, 0, -100, 0, 50, 0] deg"}}
h: 2 ms
profile: trapezoid
v_max: 0.1
omega_max: 1
a_max: 1
epsilon_max: 5
poses: [start, {{name: aside, by: [0, {way}, 0, 0, 0, 0]}}]
tool: {{position: [0, 0, 0.2]{peg}}}
K: [2000, 2000, 2000, 30, 30, 30]
D: [300, 300, 300, 20, 20, 20]
M: [10, 10, 10, 1, 1, 1]
contact:
  tip: 0.01
  obstacles:
    block: {{box: {{position: {at}, size: [0.2, 0.04, 0.04]}}, stiffness: 2e4, damping: 100}}
"""
PEG = ", capsule: {from: [0, 0, 0.02], to: [0, 0, 0.18], radius: 0.01}"


def simulated(folder: Path, at: np.ndarray, peg: str = PEG, engine: str = "spring", way: float = 0.08) -> Simulated:
    task = folder / "peg.yaml"
    task.write_text(TASK.format(at=np.round(at, 6).tolist(), peg=peg, way=way))
    made = make_segments(task, folder / "peg", None, None)
    assert isinstance(made, Segments)
    found = run_controller(made.opened, made.opened.task.contact, engine, None, None, None, "peg.yaml")
    assert isinstance(found, Simulated)
    return found


BESIDE = off(0, 0.08, -0.1)  # half-way down the peg, 60 mm to its side; the tip passes below


def test_a_peg_runs_into_what_its_tip_passes(tmp_path: Path) -> None:
    run = simulated(tmp_path, BESIDE, peg="")
    assert (run.touch, run.links) == (None, ())
    run = simulated(tmp_path, BESIDE)
    assert run.touch is None
    (link,) = run.links
    assert (link.link, link.obstacle) == ("tool", "block")
    # it goes 80 mm; its side is 10 mm before its axis, the block's 20 mm before its middle
    assert link.depth == pytest.approx(0.03, abs=2e-3)


@pytest.mark.skipif(not __import__("importlib").util.find_spec("mujoco"), reason="the extra sim")
def test_in_mujoco_the_block_holds_the_peg(tmp_path: Path) -> None:
    run = simulated(tmp_path, BESIDE, engine="mujoco")
    (link,) = [one for one in run.links if one.link == "tool"]
    assert link.force is not None
    assert link.force > 20
    held = FLANGE[1] + 0.08 - run.tool[-1, 1]
    assert 0.02 < held < 0.031  # the spring of 2000 N/m is what gives, not the block
    assert link.depth < 0.005


@pytest.mark.parametrize(
    ("at", "part"),
    [
        (off(0, 0, -0.22), "the tip"),
        (off(0, 0, -0.1), "tool"),
        (off(0, 0.01, 0.1), "link_6"),
    ],
)
def test_a_start_inside_an_obstacle_is_refused_by_name(tmp_path: Path, at: np.ndarray, part: str) -> None:
    with pytest.raises(InputError, match=f"{part}.*block") as error:
        simulated(tmp_path, at)
    assert error.value.file == "peg.yaml"


def test_a_start_beside_an_obstacle_is_none_inside(tmp_path: Path) -> None:
    """The peg's side and the block's are 1 mm apart."""
    assert simulated(tmp_path, off(0, 0.031, -0.1), way=-0.02).links == ()
