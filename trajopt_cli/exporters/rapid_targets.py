"""What targets say of rail and configuration, what a plan wants them to say, and how that is written."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trajopt_cli.exporters.rapid_text import PLACE, Edits, num, plain
from trajopt_cli.geometry import Array, inverse_pose, wxyz_from_rotation
from trajopt_cli.motion import ConfData, Hold, Move, MoveAbsJ, MoveExtJ, MoveJ, PoseMove, Span
from trajopt_cli.problem.detours import JointMove
from trajopt_cli.problem.move_call import parsed, read_move
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Aggregate, Expression, Number
from trajopt_cli.rapid.marks import HOLD, way_around
from trajopt_cli.robot.inverse import confdata, confdata_admits
from trajopt_cli.units import DEG, MM

_SAME_RAIL = 5e-4  # mm: half of the last decimal that is written
_TURNED = 5e-7  # rad: half of what the judge lets pass; written with six decimals an orientation turns by up to 2e-6
_MARKED = re.compile(r"[ \t]*!\s*trajopt\s*:", re.IGNORECASE)


@dataclass(frozen=True)
class Wish:
    """What a target must say: the rails' positions in mm as texts, those of what follows them behind them, and the
    confdata; None for what it may say as it does. counts: the controller looks at its confdata."""

    rail: tuple[str, ...] | None
    conf: ConfData | None
    counts: bool = False


def offsets(move: Move, text: str) -> tuple[float, ...]:
    r"""What EOffs adds to the external axes that a move's target says; mm or deg. text: its statement."""
    found = move.settings.eax_offset
    if any(found) and isinstance(move, MoveAbsJ | MoveExtJ):
        switches = read_move(move, text).switches
        if "useeoffs" not in switches if isinstance(move, MoveExtJ) else "noeoffs" in switches:
            return (0.0,) * 6
    return found


def common_conf(plant: Plant, moves: Sequence[PoseMove], arms: Sequence[Array]) -> ConfData | None:
    """The confdata with which moves may end at the arm's joints (6,) of each: their own where that is one and admits
    all, else of one of them; None where there is none."""
    found = [*dict.fromkeys(move.conf for move in moves)]
    found = [*(found if len(found) == 1 else []), *(confdata(plant.robot, arm) for arm in arms)]
    return next((one for one in found if all(confdata_admits(plant.robot, one, arm) for arm in arms)), None)


def same_rail(one: float, other: float) -> bool:
    """Whether two rail positions [mm] are one as far as the text tells, or as the controller's nums do."""
    return abs(one - other) <= _SAME_RAIL or bool(np.float32(one) == np.float32(other))


# ------------------------------------------------------------------------------------------------------- the literals


def rewritten(text: str, wish: Wish, eaxes: Sequence[int]) -> str | None:
    """A target's literal with a wish in it; a number that says so already keeps its spelling. None where the numbers do
    not stand in it."""
    node = parse_expression(text, "")
    assert isinstance(node, Aggregate)
    changes: list[tuple[Expression, str]] = []
    if wish.conf is not None:
        part = node.items[2]
        if not isinstance(part, Aggregate):
            return None
        numbers = [item for item in part.items if isinstance(item, Number)]
        if len(numbers) < len(part.items):
            return None
        if len(numbers) < 4 and (*(one.value for one in numbers), 0) != wish.conf.numbers:  # S4 wrote no cfx
            changes.append((part, written_conf(wish.conf)))
        elif len(numbers) == 4:
            pairs = zip(numbers, wish.conf.numbers, strict=True)
            changes += [(item, str(number)) for item, number in pairs if item.value != number]
    for eax, rail in zip(eaxes, wish.rail or (), strict=False):
        part = node.items[-1]
        item = part.items[eax] if isinstance(part, Aggregate) else part
        if not isinstance(item, Number):
            return None
        if not same_rail(item.value, float(rail)):
            changes.append((item, rail))
    for item, new in sorted(changes, key=lambda change: -change[0].start):
        text = text[: item.start] + new + text[item.end :]
    return text


def point_literal(point: JointMove, own: JointMove, text: str, eaxes: Sequence[int]) -> str:
    """An additional point before a move as a literal; text: the move's statement, whose options are in force."""
    pairs = enumerate(zip(point.extax, offsets(own, text), strict=True))
    values = [
        "9E9" if value is None else rail_text(value - offset) if i in eaxes else num(value - offset, 6)
        for i, (value, offset) in pairs
    ]
    external = f"[{','.join(values)}]"
    if isinstance(point, MoveAbsJ):
        return f"[[{','.join(num(float(value), 6) for value in point.q / DEG)}],{external}]"
    assert point.X_WO is not None  # why_straight
    return f"[{_pose(inverse_pose(point.X_WO) @ point.X_WT)},{written_conf(point.conf)},{external}]"


def _pose(X: Array) -> str:
    """trans and rot of a pose as RAPID writes them: 0.001 mm, and 1e-6 or as much finer as the orientation needs."""
    position = ",".join(num(float(value) / MM, PLACE) for value in X[:3, 3])
    wxyz = wxyz_from_rotation(X[:3, :3])
    for digits in (6, 7, 8, 9):
        texts = [num(float(value), digits) for value in wxyz]
        said = np.array(texts, dtype=np.float32).astype(np.float64)
        if 2 * np.linalg.norm(said - (said @ wxyz) * wxyz) <= _TURNED:
            break
    return f"[{position}],[{','.join(texts)}]"


def written_conf(conf: ConfData) -> str:
    """Confdata as RAPID writes it."""
    return f"[{','.join(str(value) for value in conf.numbers)}]"


def rail_text(rail: float) -> str:
    """A rail position [mm] as it is written."""
    return plain(rail, PLACE)


# -------------------------------------------------------------------------------------------------- additional points


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
