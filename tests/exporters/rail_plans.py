"""Small programs on a rail, and plans for them made by hand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trajopt_cli.exporters import rapid_diff
from trajopt_cli.exporters.rapid_write import RapidExport
from trajopt_cli.geometry import inverse_pose
from trajopt_cli.motion import MoveAbsJ, MoveC, MoveJ, MoveL, Program, TextFile, Wait
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.robot.inverse import solutions
from trajopt_cli.scenario import Scenario
from trajopt_cli.trajectory import Trajectory

J1 = "        MoveJ p1,v100,fine,tool0;\n"
J2 = "        MoveJ p2,v100,fine,tool0;\n"


def made(body: str, data: str = "", rest: str = "", more: Mapping[str, TextFile] | None = None) -> Program:
    """A program on the rail, with targets p1 and p2 and the home position; main begins on line 5 + lines of data."""
    text = (
        "MODULE m\n"
        "    CONST jointtarget home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];\n"
        "    CONST robtarget p1:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]]; ! first\n"
        "    CONST robtarget p2:=[[500, 1350., 450], [0,0,1,0], [0,0,0,0], [9E+09,9E9,9E9,9E9,9E9,9E9]];\n"
        f"{data}    PROC main()\n{body}    ENDPROC\n{rest}ENDMODULE\n"
    )
    return run_program([TextFile("m.mod", text, "utf-8"), *(more or {}).values()])


def plan_for(
    program: Program,
    plant: Plant,
    rails: Mapping[int, float],
    dropped: frozenset[int] = frozenset(),
    cfx: Mapping[int, int] | None = None,
) -> Plan:
    """A plan whose rail [m] after motion i is rails[i] (else as before), with real joints at every target."""
    q = np.array(plant.start)
    X_WF = plant.robot.forward(q)
    planned = []
    for i, motion in enumerate(program.motions):
        q_0 = q
        if i not in dropped:
            rail = rails.get(i, q[0]) if plant.rail_eaxes else None
            head = [] if rail is None else [rail]
            if isinstance(motion, MoveAbsJ):
                q = np.array([*head, *motion.q])
                X_WF = plant.robot.forward(q)
            elif isinstance(motion, MoveJ | MoveL | MoveC):
                X_WF = motion.X_WT @ inverse_pose(motion.tool.X_FT)
            if isinstance(motion, MoveJ | MoveL | MoveC | Wait) and (i in rails or not isinstance(motion, Wait)):
                wanted = (cfx or {}).get(i, 0)
                found = [arm for branch, arm in solutions(plant.robot, X_WF, rail, plant.limits) if branch == wanted]
                q = np.array([*head, *min(found, key=lambda arm: float(np.abs(arm).max()))])
        planned.append(PlannedMotion(i, motion.source, float(i), float(i + 1), q_0, q, "test", i in dropped))
    trajectory = Trajectory(plant.limits.names, np.array([0.0, 1.0]), np.array([plant.start, q]))
    return Plan(Target.RAPID, trajectory, tuple(planned), 1.0, "test")


def read_back(program: Program, export: RapidExport, scenario: Scenario | None = None) -> Program:
    """The edited program, as a controller would load it."""
    files = [replace(f, text=export.texts[path]) for path, f in program.files.items()]
    return run_program(files, scenario)


def unified_diff(program: Program, export: RapidExport) -> str:
    """What an export changes."""
    return rapid_diff.unified_diff(program.files, export.texts)


def changed_lines(program: Program, export: RapidExport) -> list[str]:
    """The lines of the diff that begin with + or -."""
    lines = unified_diff(program, export).splitlines()
    return [line for line in lines if line[:1] in ("+", "-") and line[:3] not in ("+++", "---")]
