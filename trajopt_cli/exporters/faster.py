"""Which joint moves a plan drives faster than the program asks."""

from __future__ import annotations

import numpy as np

from trajopt_cli.motion import MoveAbsJ, MoveJ, Program
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant

_EXCESS = 1e-6  # relative; a speed this close to the programmed one is that one


def faster_than_programmed(program: Program, plan: Plan, plant: Plant) -> frozenset[int]:
    """Indices of MoveJ and MoveAbsJ in which TCP, reorientation or rail pass their programmed speed at some row.

    Empty unless the cell frees the speed of joint moves; the plan's trajectory has speeds.
    """
    trajectory = plan.trajectory
    if not plant.free_speed or trajectory.qd is None:
        return frozenset()
    found = set()
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if not isinstance(motion, MoveJ | MoveAbsJ):
            continue
        rows = (trajectory.t >= planned.t_0) & (trajectory.t <= planned.t_1)
        qd = trajectory.qd[rows]
        twist = plant.robot.differential(trajectory.q[rows], motion.tool.X_FT).velocity(qd)
        pairs = [(twist[:, :3], motion.speed.v_tcp), (twist[:, 3:], motion.speed.turning)]
        pairs += [(qd[:, [i]], motion.speed.v_leax) for i in range(plant.layout.r)]
        if any(np.linalg.norm(values, axis=1).max(initial=0.0) > cap * (1 + _EXCESS) for values, cap in pairs):
            found.add(planned.index)
    return frozenset(found)
