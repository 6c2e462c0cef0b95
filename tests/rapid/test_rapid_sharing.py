"""What moves share is the state they were programmed in, and a run leaves nothing to the collector."""

from __future__ import annotations

import gc
import os
import signal
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveL, Program, TextFile
from trajopt_cli.rapid.execution.recursion_limit import room
from trajopt_cli.rapid.reader import read_program, run_program

_DATA = """
CONST robtarget p:=[[100,200,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
VAR speeddata s:=[100,500,5000,1000];
VAR zonedata z:=[FALSE,10,15,15,1.5,15,1.5];
PERS tooldata t:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
PERS wobjdata w:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
"""
_MOVE = "MoveL p,s,z,t\\WObj:=w;\n"


def _run(body: str, more: str = "") -> Program:
    text = f"MODULE m\n{_DATA}PROC main()\n{body}ENDPROC\n{more}ENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")])


def _said(program: Program) -> list[tuple[float, float, float, float]]:
    """Speed [mm/s], zone [mm], z of the tool and x of the target [mm] of each move."""
    return [
        (
            round(1e3 * motion.speed.v_tcp, 3),
            round(1e3 * motion.zone.radius, 3),
            round(1e3 * motion.tool.X_FT[2, 3], 3),
            round(1e3 * motion.X_WT[0, 3], 3),
        )
        for motion in program.motions
        if isinstance(motion, MoveL)
    ]


_BEFORE = (100, 10, 100, 100)


@pytest.mark.parametrize(
    ("change", "after"),
    [
        ("s.v_tcp:=50;\n", (50, 10, 100, 100)),
        ("s:=v200;\n", (200, 10, 100, 100)),
        ("z.pzone_tcp:=5;\n", (100, 5, 100, 100)),
        ("t.tframe.trans.z:=50;\n", (100, 10, 50, 100)),
        ("w.uframe.trans.x:=7;\n", (100, 10, 100, 107)),
        ("w.oframe.trans.x:=-7;\n", (100, 10, 100, 93)),
        ("VelSet 50,5000;\n", (50, 10, 100, 100)),
        ("VelSet 100,30;\n", (30, 10, 100, 100)),
        ("PDispSet [[1000,0,0],[1,0,0,0]];\n", (100, 10, 100, 1100)),
    ],
)
def test_a_change_between_two_moves_counts_for_the_second(change: str, after: tuple[float, ...]) -> None:
    assert _said(_run(_MOVE + change + _MOVE)) == [_BEFORE, after]


def test_each_of_two_displacements_counts_for_its_move() -> None:
    program = _run("".join(f"PDispSet [[{x},0,0],[1,0,0,0]];\n{_MOVE}" for x in (5, 9)))
    assert [x for _, _, _, x in _said(program)] == [105, 109]


def test_a_name_means_what_it_means_where_the_move_stands() -> None:
    own = """PROC inside()
VAR speeddata s:=[20,500,5000,1000];
VAR zonedata z:=[FALSE,2,15,15,1.5,15,1.5];
MoveL p,s,z,t\\WObj:=w;
ENDPROC
PROC given(speeddata s,PERS tooldata t)
MoveL p,s,z,t\\WObj:=w;
ENDPROC
"""
    tool = "PERS tooldata u:=[TRUE,[[0,0,7],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
    program = _run(f"{_MOVE}inside;\n{_MOVE}given v300,u;\n{_MOVE}", tool + own)
    assert _said(program) == [_BEFORE, (20, 2, 100, 100), _BEFORE, (300, 10, 7, 100), _BEFORE]


def test_moves_that_say_the_same_share_what_they_say() -> None:
    first, second = (motion for motion in _run(_MOVE + _MOVE).motions if isinstance(motion, MoveL))
    assert first.speed is second.speed
    assert first.zone is second.zone
    assert first.tool is second.tool
    assert first.X_WO is second.X_WO


def test_poses_made_together_are_those_of_each_move() -> None:
    rng = np.random.default_rng(5)
    q = rng.normal(size=(50, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    p = rng.uniform(-900, 900, (50, 3))
    moves = "".join(
        f"MoveL [[{x:.4f},{y:.4f},{z:.4f}],[{a:.9f},{b:.9f},{c:.9f},{d:.9f}],[0,0,0,0],"
        "[9E9,9E9,9E9,9E9,9E9,9E9]],s,z,t;\n"
        for (x, y, z), (a, b, c, d) in zip(p, q, strict=True)
    )
    poses = np.array([motion.X_WT for motion in _run(moves).motions if isinstance(motion, MoveL)])
    expected = Rotation.from_quat(q[:, [1, 2, 3, 0]]).as_matrix()
    assert np.allclose(poses[:, :3, :3], expected, atol=1e-6)  # nums of 32 bits
    assert np.allclose(poses[:, :3, 3], p / 1000, atol=1e-7)
    assert np.array_equal(poses[:, 3], np.tile([0, 0, 0, 1], (50, 1)))
    motion = _run(_MOVE).motions[0]
    assert isinstance(motion, MoveL)
    assert not motion.X_WT.flags.writeable


@pytest.mark.parametrize("count", [10, 300])
def test_a_run_leaves_nothing_to_the_collector(count: int) -> None:
    gc.collect()
    gc.disable()
    try:
        program = _run(_MOVE * count, "RECORD r\nnum n;\nENDRECORD\n")
        assert len(program.motions) == count
        assert gc.collect() < 100
    finally:
        gc.enable()


def _process() -> list[object]:
    """What a library must leave to the process that it runs in."""
    handlers = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGALRM)]
    collector = (gc.isenabled(), gc.get_threshold(), gc.get_freeze_count())
    return [collector, sys.getrecursionlimit(), dict(os.environ), handlers, np.geterr(), threading.active_count()]


@pytest.mark.parametrize(
    ("body", "count"),
    [
        (_MOVE, 1),
        ("FOR i FROM 1 TO 10001 DO WaitTime 0; ENDFOR", 10_001),
        ("MoveL nowhere,s,z,t;", 0),
        ("MoveL p s;", 0),
    ],
)
@pytest.mark.parametrize("collecting", [True, False])
def test_reading_leaves_the_process_as_it_was(tmp_path: Path, body: str, count: int, collecting: bool) -> None:
    path = tmp_path / "m.mod"
    path.write_text(f"MODULE m\n{_DATA}PROC main()\n{body}\nENDPROC\nENDMODULE\n")
    if not collecting:
        gc.disable()
    gc.unfreeze()  # a command that ran in this process froze what it had, and some of that may end meanwhile
    try:
        before = _process()
        try:
            assert len(read_program(path).motions) == count
        except InputError:
            assert count == 0
        assert _process() == before
    finally:
        gc.enable()


def test_the_limit_of_nesting_is_back_once_the_last_thread_has_left() -> None:
    before = sys.getrecursionlimit()  # a command that ran in this process has raised it for good
    sys.setrecursionlimit(5_000)
    try:
        first, second = room(), room()
        first.__enter__()
        second.__enter__()
        first.__exit__(None, None, None)
        assert sys.getrecursionlimit() > 5_000  # the second still needs it
        second.__exit__(None, None, None)
        assert sys.getrecursionlimit() == 5_000
    finally:
        sys.setrecursionlimit(before)
