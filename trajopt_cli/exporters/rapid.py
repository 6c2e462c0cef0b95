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

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import mismatches, rail_moves, read_again
from trajopt_cli.exporters.rapid_targets import Targets
from trajopt_cli.exporters.rapid_text import Edits, Names
from trajopt_cli.exporters.rapid_write import Intent, RapidExport, write
from trajopt_cli.motion import Move, MoveAbsJ, MoveJ, Program, Wait
from trajopt_cli.problem.detours import Numbering, unfolded, with_detours
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.editable_text import EditableText
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.scopes import Scopes
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
    place, for what cannot be written; EditableText knows before planning what that is.
    """
    if plan.target is not Target.RAPID:
        raise ValueError(f"only a plan for the RAPID controller can be written as RAPID, not one for {plan.target}")
    if faster and not plant.free_speed:
        raise ValueError("motions faster than programmed need a plant with free_speed")
    scenario = scenario or Scenario()
    intents = _intents(program, plan, plant, faster)
    try:
        export = write(EditableText(program, plant, scenario, loops), intents)
    except InputError as error:
        if loops is Loops.UNROLL:
            raise
        try:
            export = write(EditableText(program, plant, scenario, Loops.UNROLL), intents)
        except InputError:
            raise error from None
    there, parts = with_detours(program, plant, plan.detours), unfolded(plan)
    numbering = Numbering(len(program.motions), plan.detours)
    faster = frozenset(k for k in range(numbering.with_points) if numbering.own(k) in faster)
    try:
        read = read_again(program, plant, scenario, export.texts, export.new)
    except InputError as error:
        raise InputError(f"the plan cannot be written into this program; edited, it reads: {error}") from error
    for mismatch in mismatches(there, parts, plant, read, faster):
        raise mismatch
    return export


def _intents(program: Program, plan: Plan, plant: Plant, faster: frozenset[int]) -> dict[int, Intent]:
    targets = Targets(program, plant, Edits(program.files), Names({}), Scopes({}))  # for its wishes only
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
                out[planned.index] = Intent(wish, part, fast=planned.index in faster, points=points)
        elif isinstance(motion, Wait):
            out[planned.index] = Intent(dwell=planned if rail_moves(planned, plant) else None)
    return out
