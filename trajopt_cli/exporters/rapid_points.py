"""Additional points of a plan in a program's text: the lines that move to them."""

from __future__ import annotations

import re
from dataclasses import dataclass

from trajopt_cli.exporters.rapid_text import Edits
from trajopt_cli.motion import Hold, MoveAbsJ, MoveJ, Span
from trajopt_cli.problem.detours import JointMove
from trajopt_cli.problem.move_call import parsed, read_move
from trajopt_cli.rapid.marks import HOLD, way_around

_MARKED = re.compile(r"[ \t]*!\s*trajopt\s*:", re.IGNORECASE)


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


def point(motion: JointMove, own: JointMove, literal: str, around: tuple[str, ...]) -> Point:
    """A point of the program with the points, before its own motion."""
    pose = isinstance(motion, MoveJ)
    return Point(
        motion.target,
        "robtarget" if pose else "jointtarget",
        literal,
        motion.zone.name,
        around,
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

    given, then = parsed(written, span), parsed(now, span)
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
