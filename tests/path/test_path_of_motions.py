"""Which way a motion of a program is."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from small_cells import rapid

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveC, MoveL
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.line import Line
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.path.segment import Segment

N = "[9E9,9E9,9E9,9E9,9E9,9E9]"


def at(x: float, y: float, z: float) -> str:
    return f"[[{x},{y},{z}],[0,0,1,0],[0,0,0,0],{N}]"


def ways(body: str) -> list[Segment]:
    """Of all motions after the first."""
    first, *rest = rapid(body).motions
    assert isinstance(first, MoveL)
    X_WT: Array = first.X_WT
    out: list[Segment] = []
    for motion in rest:
        assert isinstance(motion, MoveL | MoveC)
        out.append(segment_of(motion, X_WT))
        X_WT = motion.X_WT
    return out


def test_lines_and_arcs_are_segments_one_after_the_other() -> None:
    line, arc = ways(
        f"MoveL {at(500, 0, 500)},v100,fine,tool0; MoveL {at(500, 100, 500)},v100,fine,tool0;"
        f" MoveC {at(500, 150, 550)},{at(500, 200, 500)},v100,fine,tool0;"
    )
    assert (type(line), type(arc)) == (Line, Arc)
    ends = np.array([0.0, 1.0])
    np.testing.assert_allclose(arc.pose(ends)[0], line.pose(ends)[1], rtol=0, atol=1e-15)
    # half a circle of 50 mm radius about (500, 150, 500)
    assert line.length == pytest.approx(0.1, rel=1e-12)
    assert arc.length == pytest.approx(np.pi * 0.05, rel=1e-6)
    np.testing.assert_allclose(arc.pose(np.array([0.5]))[0, :3, 3], [0.5, 0.15, 0.55], rtol=0, atol=1e-8)


def test_three_points_on_a_line_are_told_with_their_place() -> None:
    with pytest.raises(InputError, match=r"^t\.mod:6:1: MoveC .*: no circle leads through three points on one line"):
        ways(f"MoveL {at(500, 0, 500)},v100,fine,tool0;\nMoveC {at(500, 50, 500)},{at(500, 90, 500)},v100,fine,tool0;")


def test_numbers_need_no_casadi() -> None:
    """Reading a program measures arcs, and must start at once."""
    script = (
        "import sys, numpy as np, trajopt_cli.path.corner, trajopt_cli.path.joint_corner, trajopt_cli.path.joint_move\n"
        "from trajopt_cli.path.line import Line\n"
        "Line(np.eye(4), np.eye(4)).pose(np.zeros(3))\n"
        "print('casadi' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", script], capture_output=True, text=True).stdout == "False\n"
