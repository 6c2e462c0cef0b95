r"""A plan written back into its RAPID program: three kinds of edits, every other character as it was.

- Target literals get the planned rail position (eax) and configuration (confdata), in their declaration or in the
  statement, only in the numbers that change. A literal that two motions want with different values stays with the
  first; a second target is declared beside it, and the later motion refers to that.
- A dropped motion becomes a comment, `! dropped by trajopt: MoveJ ...;`.
- `WaitTime t;` in which the rail moves becomes `MoveL p_b, v500 \T:=t, fine, tool0;`: the tool stands still, the rail
  takes the time of the wait. \T follows the speed without a comma of its own (RAPID allows one there, and rarely sees
  it). A wait for a signal stays, with such a MoveL of its least duration before it.

With free_speed a fourth: the speed of a motion planned faster than programmed becomes vmax.

The edited text is read again and held against the plan, motion by motion, before anybody sees it.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass, replace

from trajopt_cli.errors import InputError
from trajopt_cli.export.rapid_check import check_export
from trajopt_cli.export.rapid_targets import Targets
from trajopt_cli.export.rapid_text import Edits, Names, plain
from trajopt_cli.motion import Move, MoveAbsJ, MoveExtJ, MoveJ, MoveL, Program, Source, Span, Wait
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.language.parser import parse_module, parse_statement
from trajopt_cli.rapid.language.syntax import Argument, If, ProcedureCall
from trajopt_cli.rapid.reader import walk
from trajopt_cli.scenario import Scenario

_RAIL_STILL = 1e-9  # m


@dataclass(frozen=True)
class RapidExport:
    """texts: every file of the program by path, to be encoded as its TextFile says. notes: what users should know."""

    texts: Mapping[str, str]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Action:
    """What happens to one statement. point, dwell: names of targets it must refer to, or that stand in for a wait."""

    drop: bool = False
    point: str | None = None
    fast: bool = False
    dwell: str | None = None


def export_rapid(
    program: Program,
    plan: Plan,
    plant: Plant,
    faster: frozenset[int] = frozenset(),
    scenario: Scenario | None = None,
    entry: str = "main",
) -> RapidExport:
    """The program's files with the rapid plan in them.

    faster: indices of MoveJ and MoveAbsJ that the plan moves faster than programmed; only with plant.free_speed.
    scenario, entry: as the program was read with, for reading the result back. Raises InputError, with the place, for
    what cannot be written in place: a computed target that would have to change, a statement that runs several times
    and would have to differ.
    """
    if plan.target is not Target.RAPID:
        raise ValueError(f"only a plan for the RAPID controller can be written as RAPID, not one for {plan.target}")
    if faster and not plant.free_speed:
        raise ValueError("motions faster than programmed need a plant with free_speed")
    edits = Edits(program.files)
    targets = Targets(program, plant, edits, Names(program.files))
    actions: dict[Span, tuple[_Action, int]] = {}
    notes: list[str] = []
    for planned in sorted(plan.motions, key=lambda planned: planned.index):
        motion = program.motions[planned.index]
        action = _Action()
        if isinstance(motion, Move):
            if planned.dropped:
                action = _Action(drop=True)
            else:
                wish = targets.wish(motion, planned.q_1)
                action = _Action(point=targets.point(motion, wish), fast=planned.index in faster)
        elif isinstance(motion, Wait) and rail_moves(planned, plant):
            action = _Action(dwell=_dwell_target(program, plan, planned, plant, targets))
        span = motion.written.statement
        before, _ = actions.setdefault(span, (action, planned.index))
        if before != action:
            raise _place(
                motion.source,
                "this statement runs more than once, and the plan wants something else of it each time; "
                "write it out once for each time it runs",
            )
    compact = _compact_bodies(program)
    for span, (action, index) in actions.items():
        if action == _Action():
            continue
        motion = program.motions[index]
        if span in compact and (action.drop or (action.dwell and isinstance(motion, Wait) and motion.condition)):
            raise _place(motion.source, "this statement hangs on an IF without THEN; write IF ... THEN ... ENDIF")
        notes += _apply(program, plan, edits, index, action)
    export = RapidExport(edits.result(), (*notes, *targets.notes))
    check_export(program, plan, plant, export.texts, scenario, entry)
    return export


def unified_diff(program: Program, export: RapidExport) -> str:
    """What an export changes, as a unified diff; empty where nothing does."""
    parts = []
    for path, file in program.files.items():
        old, new = (text.splitlines(keepends=True) for text in (file.text, export.texts[path]))
        for line in difflib.unified_diff(old, new, f"a/{path}", f"b/{path}"):
            parts.append(line if line.endswith(("\n", "\r")) else f"{line}\n\\ No newline at end of file\n")
    return "".join(parts)


def rail_moves(planned: PlannedMotion, plant: Plant) -> bool:
    """Whether the rail is elsewhere at the end of a motion."""
    return plant.rail_eax is not None and abs(float(planned.q_1[0] - planned.q_0[0])) > _RAIL_STILL


def _place(source: Source, message: str) -> InputError:
    return InputError(message, file=source.file, line=source.line, column=source.column)


def _index_before(program: Program, plan: Plan, index: int) -> int:
    """The last move before a motion that is not dropped; -1 where there is none."""
    dropped = {planned.index for planned in plan.motions if planned.dropped}
    while (index := index - 1) >= 0:
        if isinstance(program.motions[index], Move) and index not in dropped:
            break
    return index


def _dwell_target(program: Program, plan: Plan, planned: PlannedMotion, plant: Plant, targets: Targets) -> str:
    wait = program.motions[planned.index]
    index = _index_before(program, plan, planned.index)
    if index < 0:
        raise _place(wait.source, "the plan moves the rail in a wait before the first move; begin with MoveAbsJ home")
    move = program.motions[index]
    if isinstance(move, (MoveJ, MoveL)):
        # The wait begins where the move ended, and only the rail (and the joints behind it) differ at its end.
        return targets.dwell(move, targets.wish(move, planned.q_1))
    assert isinstance(move, (MoveAbsJ, MoveExtJ))
    tool = next((m.tool for m in reversed(program.motions[: planned.index]) if isinstance(m, MoveAbsJ)), None)
    X_WF = plant.robot.forward(planned.q_0)
    return targets.dwell_at(move, planned.q_1, X_WF @ tool.X_FT if tool else X_WF)


def _compact_bodies(program: Program) -> set[Span]:
    """The statements that hang on an IF without THEN: they cannot be removed or doubled."""
    found = set()
    for path, file in program.files.items():
        for node in walk(parse_module(file.text, path)):
            if isinstance(node, If) and node.compact:
                body = node.branches[0][1][0]
                found.add(Span(path, body.start, body.end))
    return found


def _apply(program: Program, plan: Plan, edits: Edits, index: int, action: _Action) -> list[str]:
    motion = program.motions[index]
    span = motion.written.statement
    if action.drop:
        edits.comment_out(span)
        return [f"{motion.source}: dropped, as the program allows"]
    if action.dwell is not None:
        assert isinstance(motion, Wait)
        return [_write_dwell(program, plan, edits, index, motion, action.dwell)]
    if action.point is not None and motion.written.target is not None:
        edits.replace(motion.written.target, action.point)
    if action.fast and isinstance(motion, Move):
        _write_vmax(edits, motion)
        return [f"{motion.source}: at vmax, as the cell allows (free_speed)"]
    return []


def _write_dwell(program: Program, plan: Plan, edits: Edits, index: int, wait: Wait, name: str) -> str:
    span = wait.written.statement
    move = program.motions[_index_before(program, plan, index)]
    speed, tool, wobj = _words(program, plan, edits, index)
    frame = "" if isinstance(move, (MoveAbsJ, MoveExtJ)) else wobj  # the place of joints is written in the world
    if wait.condition is None:
        seconds = edits.text(_inside(span, _arguments(edits, span)[0][-1]))
    else:
        seconds = plain(wait.duration)
    text = rf"MoveL {name}, {speed} \T:={seconds}, fine, {tool}{frame};"
    if wait.condition is None:
        edits.replace(span, text)
    else:
        edits.put_before(span, text)
    return f"{wait.source}: the rail moves while the tool waits, to {name}"


def _write_vmax(edits: Edits, motion: Move) -> None:
    span = motion.written.statement
    required, options = _arguments(edits, span)
    edits.replace(_inside(span, required[1]), "vmax")
    override = options.get("v")
    if override is not None:  # it would hold vmax down
        text = edits.text(span)
        start = len(text[: override.start].rstrip().removesuffix(",").rstrip())
        edits.replace(Span(span.file, span.start + start, span.start + override.end), "")


def _words(program: Program, plan: Plan, edits: Edits, index: int) -> tuple[str, str, str]:
    r"""Speed, tool and ` \WObj:=w` (or nothing) as the last move before a motion writes them.

    MoveExtJ writes no tool; then the last move that does counts.
    """
    speed: str | None = None
    wobj: str | None = None
    while (index := _index_before(program, plan, index)) >= 0:
        span = program.motions[index].written.statement
        required, options = _arguments(edits, span)
        speed = speed or edits.text(_inside(span, required[1]))
        frame = options.get("wobj")
        wobj = wobj or (f" {edits.text(_inside(span, frame))}" if frame is not None else "")
        if len(required) > 3:
            return speed, edits.text(_inside(span, required[3])), wobj
    return speed or "v100", "tool0", wobj or ""


def _arguments(edits: Edits, span: Span) -> tuple[list[Argument], dict[str, Argument]]:
    """Arguments of the call that stands at span, required ones in order and optional ones by name."""
    call = parse_statement(edits.text(span), span.file)
    assert isinstance(call, ProcedureCall)  # every motion's statement is one
    required = [arg for arg in call.args if arg.name is None]
    return required, {arg.name.lower(): arg for arg in call.args if arg.name is not None}


def _inside(span: Span, arg: Argument) -> Span:
    return replace(span, start=span.start + arg.start, end=span.start + arg.end)
