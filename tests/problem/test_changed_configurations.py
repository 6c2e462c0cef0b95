"""Which confdata a plan does not keep."""

from __future__ import annotations

import numpy as np
from small_cells import plant_with_rail, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveJ
from trajopt_cli.problem.configurations import changed_configurations
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import solutions
from trajopt_cli.trajectory import Trajectory

BODY = """MoveJ p_in, v500, fine, tool0;
ConfJ \\Off;
MoveJ p_in, v500, fine, tool0;
ConfJ \\On;
FOR i FROM 1 TO 2 DO
MoveJ p_in, v500, fine, tool0;
ENDFOR
MoveAbsJ j_home, v500, fine, tool0;"""


def arm(plant: Plant, X_WF: Array, cfx: int) -> Array:
    found = [q for branch, q in solutions(plant.robot, X_WF, 0.6, plant.limits) if branch == cfx]
    return np.r_[0.6, min(found, key=lambda q: float(np.abs(q).max()))]


def test_a_changed_configuration_is_told_with_its_motion_and_both_confdata() -> None:
    r"""cfx 1 is the wrist flipped: axes 4 and 6 turn by half a turn, into quadrants 2 or -2 and the like. ConfJ \Off
    demands nothing, and two passes of one move are one line."""
    program, plant = rapid(BODY), plant_with_rail()
    branches = iter([0, 1, 1, 1])
    ends = [
        arm(plant, motion.X_WT, next(branches)) if isinstance(motion, MoveJ) else plant.start
        for motion in program.motions
    ]
    motions = tuple(
        PlannedMotion(i, motion.source, float(i), i + 1.0, plant.start, q, "test")
        for i, (motion, q) in enumerate(zip(program.motions, ends, strict=True))
    )
    path = Trajectory(plant.limits.names, np.array([0.0, 1.0]), np.array([plant.start, ends[-1]]))
    (line,) = changed_configurations(program, plant, Plan(Target.RAPID, path, motions, None, "test"))
    flipped = ends[1][1:]
    quadrants = [int(np.floor(flipped[i] / (np.pi / 2))) for i in (0, 3, 5)]
    assert line == f"t.mod:10:1: MoveJ p_in: confdata [0,0,0,0] → [{','.join(map(str, quadrants))},1]"
