"""Row `practice`: how such cells are driven today. The arm folds, the rail moves alone, the arm unfolds and works."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from trajopt_cli.motion import ExternalAxes, Motion, Move, MoveAbsJ, MoveExtJ, PathMove, Program, Tool, Written, Zone
from trajopt_cli.problem.decision_scope import AS_WRITTEN, FIXED_RAIL
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.study.case import Answer, Case, NotApplicable, planned

_STOP = Zone("fine", True)
_FLANGE = Tool("tool0", np.eye(4))
_SAME = 1e-9  # m or rad: the rail or the arm is already there


def practice(case: Case) -> Answer:
    """The program with the missing detours put in, as the controller drives it (Krotký 2014, 4.2: today's cycle).

    Before every move that would take the rail along, the arm folds to its home pose (the cell's start) and the rail
    moves alone. Where the program gives the rail no positions it stands at the best one for each station.
    """
    if not case.plant.robot.has_rail:
        return NotApplicable("the robot rides no rail")
    if case.plant.layout.r > 1:
        return NotApplicable("the robot rides several rails")
    program = case.program
    if not case.gives_rail:
        best = case.solve(program, Target.STREAM, FIXED_RAIL)
        if isinstance(best, Infeasible):
            return best
        program = with_rail(
            program, case.plant, [float(case.plant.layout.place(motion.q_1)) for motion in best.motions]
        )
    detoured = with_detours(program, case.plant)
    added = len(detoured.motions) - len(program.motions)
    note = f"{added} moves added: home and the rail alone" if added else "the program makes these detours itself"
    return planned(detoured, case.solve(detoured, Target.RAPID, AS_WRITTEN), (note,))


def with_rail(program: Program, plant: Plant, rail: list[float]) -> Program:
    """The program with the rail at rail[i] [m] at the end of motion i, for every move."""
    motions = [
        replace(motion, extax=_extax(motion.extax, plant, rail[i])) if isinstance(motion, Move) else motion
        for i, motion in enumerate(program.motions)
    ]
    return replace(program, motions=tuple(motions))


def with_detours(program: Program, plant: Plant) -> Program:
    """The program in which the rail moves only while the arm is folded; lines and arcs that carry it along stay."""
    out: list[Motion] = []
    layout = plant.robot.layout
    home, rail = plant.at_home.start[layout.arm], float(layout.place(plant.start))
    folded = bool(np.abs(plant.start[layout.arm] - home).max() <= _SAME)
    for motion in program.motions:
        if isinstance(motion, Move):
            asked = plant.rail_value(motion.extax)
            given = None if asked is None else float(asked[0])
            moves = given is not None and abs(given - rail) > _SAME
            ends_folded = isinstance(motion, MoveAbsJ) and bool(np.abs(motion.q - home).max() <= _SAME)
            if moves and not isinstance(motion, PathMove):
                assert given is not None
                if not folded:
                    out.append(_fold(motion, plant, rail))
                if not ends_folded and not isinstance(motion, MoveExtJ):
                    out.append(_ride(motion, plant, given))
            rail = rail if given is None else given
            folded = ends_folded or (isinstance(motion, MoveExtJ) and (folded or moves))
        out.append(motion)
    return replace(program, motions=tuple(out))


def _fold(before: Move, plant: Plant, rail: float) -> MoveAbsJ:
    """The arm to its home pose, the rail staying at rail."""
    return MoveAbsJ(
        source=before.source, written=Written(before.written.statement), target="home", speed=before.speed, zone=_STOP,
        extax=_extax(before.extax, plant, rail), q=plant.at_home.start[plant.robot.layout.arm],
        tool=getattr(before, "tool", _FLANGE),
    )  # fmt: skip


def _ride(before: Move, plant: Plant, rail: float) -> MoveExtJ:
    """The rail alone to rail."""
    return MoveExtJ(
        source=before.source, written=Written(before.written.statement), target="rail", speed=before.speed, zone=_STOP,
        extax=_extax(before.extax, plant, rail),
    )  # fmt: skip


def _extax(extax: ExternalAxes, plant: Plant, rail: float) -> ExternalAxes:
    return plant.with_rail(extax, np.array([rail]))
