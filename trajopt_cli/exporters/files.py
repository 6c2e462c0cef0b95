"""A plan as files for the machine that executes it, and which joint moves it drives faster than the program asks."""

from __future__ import annotations

from typing import Literal

import numpy as np

from trajopt_cli.exporters.joint import resample
from trajopt_cli.exporters.rapid import export_rapid
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.motion import MoveAbsJ, MoveJ, Program
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scenario import Scenario

JOINTS = "joints.csv"
_EXCESS = 1e-6  # relative; a speed this close to the programmed one is that one


def export(
    plan: Plan,
    kind: Literal["joint", "rapid"] = "joint",
    *,
    rate: float = 1000.0,
    program: Program | None = None,
    plant: Plant | None = None,
    scenario: Scenario | None = None,
) -> dict[str, bytes]:
    """A plan's files, content by name, for a machine that follows a joint stream or for the RAPID controller.

    joint: joints.csv, rows at rate [Hz] and the exact end as last row; given a plant, axes that follow too. rapid: the
    modules of program, by the path they were read from and in their own encoding, with the plan in them; needs the
    program and the plant that the plan was made for, and the scenario the program was read with.

    Raises InputError for a rate outside (0, 1e5] Hz and for what cannot be written as RAPID, with its place; ValueError
    for a kind that there is not, a plan of the other target, or a missing program or plant.
    """
    if kind == "joint":
        rows = plan.trajectory if plant is None else plant.with_followers(plan.trajectory)
        return {JOINTS: write_csv_text(resample(rows, rate)).encode("ascii")}
    if kind != "rapid":
        raise ValueError(f"no export is called {kind!r}: joint or rapid")
    if program is None or plant is None:
        raise ValueError("the RAPID export needs program and plant, as the plan was made for them")
    faster = faster_than_programmed(program, plan, plant)
    written = export_rapid(program, plan, plant, faster, scenario)
    return {path: text.encode(program.files[path].encoding) for path, text in written.texts.items()}


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
