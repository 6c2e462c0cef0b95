r"""A plan written back into its RAPID program: edits in place, every other character as it was.

- Target literals get the planned rail position (eax) and configuration (confdata), in whichever module they stand, in
  their declaration or in the statement, only in the numbers that change. A literal that two motions want with different
  values stays with the first; a second target is declared beside it, and the later motion refers to that. What EOffs
  adds is taken out again.
- A computed target (`Offs(p1,0,0,50)`) that must say something else becomes a target of its own, declared with the
  value it has, in the frame of the move.
- A statement that runs several times keeps one answer for all its runs, so loops and routines stay what they are. A
  plan with another answer for each run (--loops unroll) is written out flat: the innermost statement around it that
  runs once becomes a comment and a call of a procedure in a new module, which holds its motions one after the other.
- A dropped motion becomes a comment, `! dropped by trajopt: MoveJ ...;`.
- `WaitTime t;` in which the rail moves becomes `MoveL p_b, v500 \T:=t, fine, tool0;`: the tool stands still, the rail
  takes the time of the wait. \T follows the speed without a comma of its own (RAPID allows one there, and rarely sees
  it). A wait for a signal stays, with such a MoveL of its least duration before it.
- A move with confdata switched off (ConfJ, ConfL \Off), which ends in the nearest configuration, gets
  `ConfJ \On;` before it and `ConfJ \Off;` behind it where the plan wants another.
- A way around obstacles becomes a MoveJ (before a MoveAbsJ a MoveAbsJ) for each additional point, on a line of its own
  before the move, `MoveJ pVia_10, v1000, z20, tool0 \WObj:=wobj0; ! trajopt: way around 'column'`, to a constant beside
  the move's target.
- With free_speed the speed of a motion planned faster than programmed becomes vmax.

The edited text is read again and held against the plan, motion by motion, before anybody sees it.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import mismatches, rail_moves
from trajopt_cli.exporters.rapid_reading import Reading
from trajopt_cli.exporters.rapid_scopes import Scopes
from trajopt_cli.exporters.rapid_stretches import Stretches
from trajopt_cli.exporters.rapid_targets import Targets
from trajopt_cli.exporters.rapid_text import Edits, Names, refusal
from trajopt_cli.exporters.rapid_writable import safest
from trajopt_cli.exporters.rapid_write import Choices, Intent, RapidExport, write
from trajopt_cli.motion import Move, MoveAbsJ, MoveJ, Program, Wait
from trajopt_cli.problem.detours import Numbering, unfolded, with_detours
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scenario import Scenario


def export_rapid(
    program: Program,
    plan: Plan,
    plant: Plant,
    faster: frozenset[int] = frozenset(),
    scenario: Scenario | None = None,
    entry: str = "main",
    loops: Loops = Loops.KEEP,
) -> RapidExport:
    """The program's files with the rapid plan in them.

    faster: indices of MoveJ and MoveAbsJ that the plan moves faster than programmed; only with plant.free_speed.
    scenario, entry: as the program was read with, for reading the result back. loops: as the plan was made for; KEEP
    makes no number of what depends on a variable, unless nothing else carries the plan. Raises InputError, with the
    place, for what cannot be written; text_changes() knows before planning what that is.
    """
    if plan.target is not Target.RAPID:
        raise ValueError(f"only a plan for the RAPID controller can be written as RAPID, not one for {plan.target}")
    if faster and not plant.free_speed:
        raise ValueError("motions faster than programmed need a plant with free_speed")
    reading = Reading(program, plant, scenario or Scenario(), entry)
    scopes = Scopes(program.files)
    stretches = Stretches(program, scopes, reading)
    there, parts = with_detours(program, plant, plan.detours), unfolded(plan)
    numbering = Numbering(len(program.motions), plan.detours)
    intents = _intents(program, plan, plant, faster, scopes)
    faster = frozenset(k for k in range(numbering.with_points) if numbering.own(k) in faster)
    choices, last = Choices(loops=loops), False
    refused: InputError | None = None
    while True:
        found: list[tuple[int | None, InputError]] = []
        try:
            export = write(program, plant, scopes, stretches, intents, choices)
            found = list(mismatches(there, parts, plant, reading, export.texts, export.new, faster))
        except InputError as error:
            refused = failure = refused or error
        else:
            if not found:
                return export
            failure = found[0][1]
        # A computed target that the edits leave, or make, another than planned gets a declaration of its own.
        others = {numbering.own(index) for index, _ in found if index is not None and not numbering.is_point(index)}
        computed = {index for index in others if _is_computed(program, index)}
        spans = {program.motions[index].written.statement for index in computed}  # with all passes of each
        wrong = {index for index, motion in enumerate(program.motions) if motion.written.statement in spans}
        own = {index for index in wrong if _may_be_said(program, scopes, stretches, loops, index)} - choices.own
        if own:
            choices = replace(choices, own=choices.own | own)
        elif not choices.isolated:
            choices = Choices(isolated=True, loops=loops)
        elif not last:
            choices, last = safest(program, plant, scopes, reading, loops), True
        else:
            hanging = computed - choices.own
            raise refused or (_hanging(program, scopes, stretches, min(hanging)) if hanging else failure)


def _may_be_said(program: Program, scopes: Scopes, stretches: Stretches, loops: Loops, index: int) -> bool:
    """Whether a computed target may be written out in numbers."""
    motion = program.motions[index]
    assert isinstance(motion, Move)
    return stretches.constant(index) and (loops is Loops.UNROLL or scopes.depends_on(motion) is None)


def _hanging(program: Program, scopes: Scopes, stretches: Stretches, index: int) -> InputError:
    motion = program.motions[index]
    assert isinstance(motion, Move)
    variable = scopes.depends_on(motion) if stretches.constant(index) else None
    why = "hangs on what only the scenario says" if variable is None else f"depends on {variable}"
    return refusal(
        motion.source, f"the plan wants other values for {motion.target}, which {why}; it cannot be written out"
    )


def _is_computed(program: Program, index: int) -> bool:
    motion = program.motions[index]
    return isinstance(motion, Move) and motion.written.aggregate is None


def _intents(program: Program, plan: Plan, plant: Plant, faster: frozenset[int], scopes: Scopes) -> dict[int, Intent]:
    targets = Targets(program, plant, Edits(program.files), Names({}), scopes)  # for its wishes only
    numbering = Numbering(len(program.motions), plan.detours)
    there = with_detours(program, plant, plan.detours)
    parts = {one.index: one for one in unfolded(plan).motions}
    last = [parts[numbering.at(one.index)] for one in plan.motions]  # of each motion, from its last point on
    runs = Counter(motion.written.statement for motion in program.motions)
    texts = [(motion.written.statement, motion.written.aggregate) for motion in program.motions]
    moving = {texts[numbering.own(one.index)] for one in last if rail_moves(one, plant)}  # in some pass
    out = {}
    for planned, part in zip(plan.motions, last, strict=True):
        motion = program.motions[planned.index]
        if isinstance(motion, Move):
            if planned.dropped:
                out[planned.index] = Intent(drop=True)
            else:
                text = texts[planned.index]
                wish = targets.wish(motion, part, leave_open=runs[text[0]] > 1 and text not in moving)
                before = there.motions[part.index - len(planned.via) : part.index]
                points = tuple(one for one in before if isinstance(one, MoveJ | MoveAbsJ))
                out[planned.index] = Intent(wish, fast=planned.index in faster, points=points)
        elif isinstance(motion, Wait):
            out[planned.index] = Intent(dwell=planned if rail_moves(planned, plant) else None)
    return out
