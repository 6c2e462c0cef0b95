r"""A plan written back into its RAPID program: edits in place, every other character as it was.

A target's expression stays as written: rail and configuration change in the numbers of a declaration, or by a function
around the target, which is added to the module; RelTool around all that turns a tool that is free about its axis. A
dropped motion becomes a comment, a wait in which the rail moves a MoveL in its place. A move with confdata switched off
(ConfJ \Off) has `ConfJ \On;` before it and `ConfJ \Off;` behind it where the plan wants another configuration than the
nearest. A way around obstacles is a joint move to a constant for each point; with free_speed a motion planned faster
than programmed has vmax. docs/exports.md shows all of it.

The edited text is read again and held against the plan, motion by motion, before anybody sees it.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import mismatches, rail_moves, read_again
from trajopt_cli.exporters.rapid_targets import offsets
from trajopt_cli.exporters.rapid_write import Disagreement, Intent, RapidExport, write
from trajopt_cli.motion import Hold, Move, MoveAbsJ, MoveJ, PoseMove, Program, Wait
from trajopt_cli.problem.detours import Numbering, unfolded, with_detours
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import EditableText, confdata_counts
from trajopt_cli.problem.nearest import is_nearest
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.tool_turns import turned
from trajopt_cli.scenario import Scenario
from trajopt_cli.units import DEG

_RAIL_STILL = 1e-9  # m


def export_rapid(
    program: Program,
    plan: Plan,
    plant: Plant,
    faster: frozenset[int] = frozenset(),
    scenario: Scenario | None = None,
    loops: Loops = Loops.KEEP,
) -> RapidExport:
    """The program's files with the rapid plan in them.

    faster: indices of MoveJ and MoveAbsJ that the plan moves faster than programmed; only with plant.free_speed.
    scenario: as the program was read with, for reading the result back. loops: as the plan was made for. Raises
    InputError, with the place, for what cannot be written; EditableText knows before planning what that is.
    """
    if plan.target is not Target.RAPID:
        raise ValueError(f"only a plan for the RAPID controller can be written as RAPID, not one for {plan.target}")
    if faster and not plant.free_speed:
        raise ValueError("motions faster than programmed need a plant with free_speed")
    scenario, program = scenario or Scenario(), turned(program, plan.turns)
    intents = intents_of(program, plan, plant, faster)
    there, parts = with_detours(program, plant, plan.detours), unfolded(plan)
    numbering = Numbering(len(program.motions), plan.detours)
    faster = frozenset(k for k in range(numbering.with_points) if numbering.own(k) in faster)
    unsure: frozenset[int] = frozenset()
    while True:
        export = written(program, plant, scenario, intents, loops, unsure)
        try:
            read = read_again(program, plant, scenario, export.texts)
        except InputError as error:
            raise InputError(f"the plan cannot be written into this program; edited, it reads: {error}") from error
        found = [*mismatches(there, parts, plant, read, faster)]
        places = {(one.file, one.line, one.column) for one in found}
        moves = ((i, one.source) for i, one in enumerate(program.motions) if isinstance(one, Move))
        # What depends on where the robot is (CRobT) may say otherwise in the edited program than in the given one.
        again = unsure.union(i for i, source in moves if (source.file, source.line, source.column) in places)
        if not found:
            return export
        if again == unsure:
            raise found[0]
        unsure = again


def written(
    program: Program, plant: Plant, scenario: Scenario, intents: dict[int, Intent], loops: Loops,
    unsure: frozenset[int] = frozenset(),
) -> RapidExport:  # fmt: skip
    """The program's files with what shall become of its motions; copies of routines only where executions of one
    statement disagree. unsure: as write has it. Raises InputError, with the place, for what cannot be written."""
    routines: frozenset[str] = frozenset()
    text = EditableText(program, plant, scenario)
    while True:
        try:
            return write(text, intents, unsure)
        except Disagreement as error:
            if loops is Loops.KEEP or error.routines <= routines:
                raise
            routines |= error.routines
            text = EditableText(program, plant, scenario, loops, routines)


def intents_of(program: Program, plan: Plan, plant: Plant, faster: frozenset[int]) -> dict[int, Intent]:
    """What a plan makes of each motion."""
    numbering = Numbering(len(program.motions), plan.detours)
    there = with_detours(program, plant, plan.detours)
    parts = {one.index: one for one in unfolded(plan).motions}
    out, before = dict[int, Intent](), None
    for planned in plan.motions:
        motion, part = program.motions[planned.index], parts[numbering.at(planned.index)]  # from its last point on
        if planned.dropped:
            out[planned.index] = Intent(drop=True)
        elif isinstance(motion, Move):
            before = motion
            monitored = not isinstance(motion, PoseMove) or confdata_counts(motion)
            points = there.motions[part.index - len(planned.via) : part.index]
            out[planned.index] = Intent(
                _rail(program, motion, plant, part),
                float(np.abs((part.q_1 - part.q_0)[plant.layout.rail]).max(initial=0.0)) > _RAIL_STILL,
                np.asarray(part.q_1[plant.layout.arm]) if isinstance(motion, PoseMove) else None,
                monitored or is_nearest(plant, part, motion),
                fast=planned.index in faster,
                points=tuple(one for one in points if isinstance(one, MoveJ | MoveAbsJ)),
                turn=motion.turn / DEG if isinstance(motion, PoseMove) else 0.0,
            )
        elif isinstance(motion, Wait):
            rail = None if before is None else _rail(program, before, plant, part)
            moves = rail_moves(planned, plant)
            out[planned.index] = Intent(rail, moves, np.asarray(part.q_1[plant.layout.arm]))
    return out


def _rail(program: Program, move: Move, plant: Plant, planned: PlannedMotion) -> tuple[float, ...] | None:
    """Where a target must say that the rails are, and what follows them [mm]."""
    if not plant.rail_eaxes or move.hold is Hold.UNIT:
        return None
    span = move.written.statement
    taken = offsets(move, program.files[span.file].text[span.start : span.end])
    there = plant.with_rail(move.extax, planned.q_1[plant.layout.rail])
    return tuple((there[eax] or 0.0) - taken[eax] for eax in plant.driven_eaxes)
