"""Arcs and zones of RAPID programs: where the tool passes, by geometry; where it rests; what stays refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import load_task
from trajopt_cli.iiwa.task.model import Route
from trajopt_cli.iiwa.task.segments import planned

MODULE = """\
MODULE seam
  CONST robtarget a := [[500,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget b := [[500,150,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget c := [[560,150,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveJ a, v100, fine, tool0;
    MoveL b, v100, z10, tool0;
    MoveL c, v100, fine, tool0;
    MoveC Offs(c,30,-30,0), Offs(c,0,-60,0), v50, fine, tool0;
    MoveL Offs(c,0,-80,0), v100, z1, tool0;
    WaitTime 0.5;
    MoveL a, v200, z50, tool0;
  ENDPROC
ENDMODULE
"""
TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
passing: {tolerance: 0.2 mm}
approach: none
a_max: 1
epsilon_max: 4
jerk: 20
angular_jerk: 80
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
program: seam.mod
"""


def route(folder: Path, module: str = MODULE, task: str = TASK) -> tuple[Route, tuple[str, ...]]:
    (folder / "seam.mod").write_text(module)
    (folder / "seam.yaml").write_text(task)
    found = load_task(folder / "seam.yaml")
    return found.route, found.notes


def test_zones_are_passed_arcs_followed_and_the_rest_are_stops(tmp_path: Path) -> None:
    wanted, notes = route(tmp_path)
    assert wanted.caps[-1] == pytest.approx([0.2, np.radians(500), 1, 4, 20, 80])  # v200, then the task's own
    found, facts = planned(wanted)
    assert [(piece.origin, piece.goal, piece.dwell) for piece in found.pieces] == [
        ("a", "c", False),
        ("c", "Offs(c,0,-60,0)", False),
        ("Offs(c,0,-60,0)", "Offs(c,0,-80,0)", False),
        ("Offs(c,0,-80,0)", "Offs(c,0,-80,0)", True),
        ("Offs(c,0,-80,0)", "a", False),
    ]
    corner, arc = (found.pose[piece.first : piece.last + 1, :3] for piece in found.pieces[:2])
    # the middle of a parabola that begins and ends 10 mm from its point: (p_0 + 2 p + p_1) / 4
    b = np.array([0.5, 0.15, 0.3])
    nearest = corner[np.argmin(np.linalg.norm(corner - b, axis=1))]
    assert nearest == pytest.approx(b + np.array([0.0025, -0.0025, 0]), abs=2.2e-4)
    beyond = corner[corner[:, 1] < 0.139]
    assert beyond[:, 0] == pytest.approx(np.full(len(beyond), 0.5), abs=2e-4)
    radius = np.linalg.norm(arc - [0.56, 0.12, 0.3], axis=1)
    assert radius == pytest.approx(np.full(len(arc), 0.03), abs=2.2e-4)
    assert arc[:, 0].max() == pytest.approx(0.59, abs=2.2e-4)
    assert [fact.v_top for fact in facts] == pytest.approx([0.1, 0.05, 0.1, 0.2], rel=0.2)
    assert facts[1].v_top <= 0.05 * (1 + 1e-6)
    for fact in facts:
        assert fact.passed is not None
        assert fact.passed.away <= 2e-4
    assert "2 fly-by zones are stops: the program waits or ends there, or no way leads on" in notes


def test_a_corner_into_an_arc_goes_on_from_where_the_corner_ends(tmp_path: Path) -> None:
    wanted, _ = route(tmp_path, MODULE.replace("MoveL c, v100, fine", "MoveL c, v100, z10"))
    begin, end = wanted.stops[:2]
    steps = np.diff(wanted.poses[begin : end + 1, :3], axis=0)
    steps /= np.linalg.norm(steps, axis=1)[:, None]
    assert (steps[1:] * steps[:-1]).sum(axis=1).min() > 0.9


def test_speeds_are_those_of_the_move_that_a_corners_half_belongs_to(tmp_path: Path) -> None:
    wanted, _ = route(tmp_path, MODULE.replace("MoveL c, v100", "MoveL c, v20"))
    found, _ = planned(wanted)
    rows = found.pose[: found.pieces[0].last + 1, :3]
    speed = np.linalg.norm(np.diff(rows, axis=0), axis=1) / 1e-3
    after = rows[1:, 0] > 0.5 + 0.004
    assert speed[after].max() <= 0.02 * (1 + 1e-6)
    assert speed.max() == pytest.approx(0.1, rel=1e-2)


def test_points_on_one_line_make_no_arc(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"seam\.mod:9:5: MoveC .*: "):
        route(tmp_path, MODULE.replace("Offs(c,30,-30,0)", "Offs(c,0,-30,0)"))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("MoveJ a", "MoveC b, a", "MoveC is not a straight segment; a task takes MoveL, MoveC and a first MoveJ only"),
        ("MoveL c, v100, fine", "MoveJ c, v100, fine", "MoveJ is not a straight segment"),
        ("MoveC Offs", "AccSet 50,50; MoveC Offs", "AccSet is active here"),
    ],
)
def test_what_no_path_is_stays_refused(tmp_path: Path, old: str, new: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        route(tmp_path, MODULE.replace(old, new, 1))
