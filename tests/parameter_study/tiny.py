"""A study of two moves, and points that take no time."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import numpy as np

from trajopt_cli.parameter_study.point import PointInputs, Row, blank
from trajopt_cli.parameter_study.sampling import Point

MODULE = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    TASK PERS wobjdata table:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
    CONST robtarget p_in:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_in, vmax, fine, tool0 \\WObj:=table;
        MoveAbsJ j_home, vmax, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 90, 0] deg'}\nsettle: 0\n"
CELL += "tcp: {speed: 2, acceleration: 20, source: x}\n"
STUDY = """programs: [tiny.mod]
vary:
  limits.joint_1.velocity: {range: [0.5, 1.5], count: 40}
  tcp.speed: [1.0, 2.0, 3 m/s]
answers: [rapid]
"""


def written(folder: Path, study: str = STUDY, cell: str = CELL) -> Path:
    """The study file, with all that it names beside it."""
    (folder / "tiny.mod").write_text(MODULE)
    (folder / "tiny.yaml").write_text(cell)
    (folder / "study.yaml").write_text(study)
    return folder / "study.yaml"


def at_once(inputs: PointInputs, point: Point) -> Row:
    """A row by a closed form."""
    return {**blank(inputs, point, "ok", ""), "rapid_s": 1.0 + float(np.sin(point.index))}


def in_a_moment(inputs: PointInputs, point: Point) -> Row:
    """The same, after a while."""
    time.sleep(0.02)
    return at_once(inputs, point)


def killed_once(inputs: PointInputs, point: Point) -> Row:
    """The same; one point kills its worker where that has not happened yet."""
    mark = Path(inputs.price or "")
    if point.index == 50 and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return at_once(inputs, point)


def greedy(inputs: PointInputs, point: Point) -> Row:
    """The same; one point takes memory without end whenever it is tried, another one raises."""
    kept = []
    while point.index == 50:
        kept.append(np.ones(2_000_000))
        time.sleep(0.005)
    if point.index == 70:
        raise ZeroDivisionError("an error of ours")
    return at_once(inputs, point)
