"""Additional points of a plan in a program's text: which moves can have them, and the lines that drive to them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Set
from dataclasses import dataclass

import numpy as np

from trajopt_cli.exporters.rapid_call import read_move
from trajopt_cli.exporters.rapid_scopes import Scopes
from trajopt_cli.exporters.rapid_text import Edits
from trajopt_cli.motion import Hold, MoveAbsJ, MoveJ, Program, Span
from trajopt_cli.problem.detours import JointMove
from trajopt_cli.problem.editable import why_straight
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.language.parser import parse_statement
from trajopt_cli.rapid.language.syntax import ProcedureCall
from trajopt_cli.rapid.marks import HOLD, way_around

Groups = tuple[tuple[int, ...], ...]
_MARKED = re.compile(r"[ \t]*!\s*trajopt\s*:", re.IGNORECASE)


def text_detours(
    program: Program, plant: Plant, scopes: Scopes, free: Set[int], alone: Set[int] = frozenset()
) -> tuple[Groups, dict[int, str]]:
    """The joint moves before which the text can have points, in groups that must have the same, and why others cannot.

    free: motions whose rail position can be another. alone: those that can be written out, each for itself.
    """
    straight: dict[int, str] = {}
    passes: dict[Span, list[int]] = defaultdict(list)
    for i, motion in enumerate(program.motions):
        if not isinstance(motion, MoveJ | MoveAbsJ):
            continue
        why = why_straight(motion) or _why_not(motion, plant, scopes, i in free)
        if why is not None:
            straight[i] = why
        passes[motion.written.statement].append(i)
    groups: list[tuple[int, ...]] = []
    for indices in passes.values():
        together = tuple(i for i in indices if i not in alone)
        refused = any(i in straight for i in together)
        if not refused and not _one_frame(program, together):
            straight |= dict.fromkeys(together, "its tool, work object or settings are not the same in all passes")
        elif refused:
            why = next(straight[i] for i in together if i in straight)
            straight |= {i: why for i in together if i not in straight}
        elif together:
            groups.append(together)
        groups += [(i,) for i in indices if i in alone and i not in straight]
    return tuple(sorted(groups)), dict(sorted(straight.items()))


def _why_not(motion: JointMove, plant: Plant, scopes: Scopes, free: bool) -> str | None:
    if motion.written.statement in scopes.compact:
        return "it is part of an IF without THEN; IF ... THEN ... ENDIF would free it"
    if plant.rail_eax is not None and motion.extax[plant.rail_eax] is None and not free:
        return "it leaves the rail where it is (9E9), and its target cannot be changed"
    return None


def _one_frame(program: Program, passes: tuple[int, ...]) -> bool:
    """Whether the passes of one statement see one target in one place."""
    moves = [motion for i in passes if isinstance(motion := program.motions[i], MoveJ | MoveAbsJ)]
    frames = {_frame(one) for one in moves}
    return len(frames) < 2 and all((one.settings, one.speed) == (moves[0].settings, moves[0].speed) for one in moves)


def _frame(motion: JointMove) -> tuple[bytes, bytes]:
    """Tool and place of the frame that a target of a move is written in."""
    X_WO = motion.X_WO if isinstance(motion, MoveJ) else None
    return motion.tool.X_FT.tobytes(), b"" if X_WO is None else np.asarray(X_WO).tobytes()


@dataclass(frozen=True)
class Point:
    r"""One line to be written before a move. name: of its target, which is declared as literal. zone: as written.
    around: what it leads around. held: the rail stands still on the way. monitored: ConfJ \On is written around it."""

    name: str
    type: str
    literal: str
    zone: str
    around: tuple[str, ...]
    held: bool
    monitored: bool


def point(motion: JointMove, own: JointMove, literal: str) -> Point:
    """A point of the program with the points, before its own motion."""
    pose = isinstance(motion, MoveJ)
    return Point(
        motion.target,
        "robtarget" if pose else "jointtarget",
        literal,
        motion.zone.name,
        motion.detour,
        own.hold is Hold.PROGRAM,
        pose and not own.settings.conf_j,
    )


def point_lines(point: Point, own: JointMove, written: str, now: str, fast: bool) -> list[str]:
    r"""The lines of a point before its own motion's statement.

    written: the statement as given, now: as it will stand. Speed, `\V`, tool and work object are the statement's.
    fast: at vmax.
    """
    call, span = read_move(own, written), own.written.statement

    def word(part: Span | None) -> str:
        return "" if part is None else written[part.start - span.start : part.end - span.start]

    given, then = _parsed(written, span), _parsed(now, span)
    place = next(i for i, arg in enumerate(given.args) if span.start + arg.start == call.speed.start)
    speed = "vmax" if fast else now[then.args[place].start : then.args[place].end]
    if not fast and any((arg.name or "").lower() == "v" for arg in then.args):
        speed += word(call.override)
    wobj = f" {word(call.wobj)}" if call.wobj is not None else ""
    switches = r"\NoEOffs" if isinstance(own, MoveAbsJ) and "noeoffs" in call.switches else ""
    name = "MoveJ" if point.type == "robtarget" else "MoveAbsJ"
    move = f"{name} {point.name}{switches}, {speed}, {point.zone}, {word(call.tool)}{wobj};"
    way = way_around(point.around)
    lines = [way, f"{move} {HOLD}"] if point.held else [f"{move} {way}"]
    return [r"ConfJ \On;", *lines, r"ConfJ \Off;"] if point.monitored else lines


def put_above(edits: Edits, span: Span, lines: list[str]) -> None:
    """Lines before a statement's, above a comment there that marks it; what stands before it on its own line stays."""
    end, indent = edits.line_end(span.file), edits.indentation(span)
    begin = edits.line_of(span.file, span.start)[0]
    above = edits.line_of(span.file, max(begin - len(end), 0)) if begin else (0, 0)
    if not edits.before(span).strip() and begin and _MARKED.match(edits.text(Span(span.file, *above))):
        edits.insert(span.file, above[0], "".join(f"{indent}{line}{end}" for line in lines))
    else:
        edits.insert(span.file, span.start, "".join(f"{line}{end}{indent}" for line in lines))


def _parsed(text: str, span: Span) -> ProcedureCall:
    call = parse_statement(text, span.file)
    assert isinstance(call, ProcedureCall)  # every motion's statement is one
    return call
