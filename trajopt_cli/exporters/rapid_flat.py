"""Statements that cannot carry a plan in place, written out motion by motion in a module of their own."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import PurePath

from trajopt_cli.exporters.rapid_points import Point, point_lines
from trajopt_cli.exporters.rapid_targets import TargetEdit, Targets, type_of
from trajopt_cli.exporters.rapid_text import Edits, Names, plain
from trajopt_cli.motion import (
    Hold,
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveJ,
    Program,
    SignalEvent,
    Span,
    TextFile,
)
from trajopt_cli.problem.move_call import called, last_argument, read_move
from trajopt_cli.problem.scopes import Scopes
from trajopt_cli.problem.single_runs import SingleRun
from trajopt_cli.rapid.language.syntax import Assign, LateCall, Node, ProcedureCall
from trajopt_cli.rapid.marks import FLAT, HOLD
from trajopt_cli.units import DEG, MM
from trajopt_cli.warnings import ProgramWarning, WarningKind

_INDENT = "    "


@dataclass(frozen=True)
class FlatMotion:
    r"""What becomes of one motion. wish: of its target, None for what is no move. text: what stands in its place.

    fast: at vmax. before, behind: statements around it. points: additional ones on the way to it.
    """

    wish: TargetEdit | None = None
    text: str | None = None
    fast: bool = False
    before: tuple[str, ...] = ()
    behind: tuple[str, ...] = ()
    points: tuple[Point, ...] = ()


class FlatModule:
    """The module that holds flat stretches: one procedure each, and the targets they need."""

    def __init__(self, program: Program, edits: Edits, names: Names, scopes: Scopes, targets: Targets):
        self._program, self._edits, self._names = program, edits, names
        self._scopes, self._targets = scopes, targets
        self._data: list[str] = []
        self._known: dict[tuple[str, str], str] = {}
        self._bodies: list[tuple[str, list[str]]] = []
        self._beside: str | None = None  # the file whose folder, encoding and line end it takes

    def declare(self, base: str, type_: str, literal: str) -> str:
        """The name of a target in this module; one for each literal."""
        if (type_, literal) not in self._known:
            name = self._known[type_, literal] = self._names.new(base, "flat", 0)
            self._data.append(f"{_INDENT}LOCAL CONST {type_} {name}:={literal};")
        return self._known[type_, literal]

    def add(self, run: SingleRun, indices: Sequence[int], how: Callable[[int], FlatMotion]) -> ProgramWarning:
        """Write a statement out as a procedure and call it where it stood; what users should know.

        indices: its motions without those that are dropped. how: what becomes of each.
        """
        self._beside = self._beside or run.span.file
        name = self._names.new("trajopt_flat", "", len(self._bodies) + 1)
        lines: list[str] = []
        for index in indices:
            motion, done = self._program.motions[index], how(index)
            text = done.text if done.text is not None else self._statement(motion, done)
            held = not isinstance(motion, SignalEvent) and motion.hold is Hold.PROGRAM
            lines += self._points(motion, done, text)
            lines += [*done.before, f"{text} {HOLD}" if held else text, *done.behind]
        self._bodies.append((name, lines))
        self._edits.replace_by(run.span, f"{name};", FLAT)
        written = " ".join(self._edits.text(run.span).split())
        short = written if len(written) <= 40 else f"{written[:37]}..."
        left = self._left_behind(run)
        also = f"; not carried over: {', '.join(left)}" if left else ""
        line = self._edits.line_number(run.span)
        text = f"'{short}' is written flat as {name}{also}"
        return ProgramWarning(WarningKind.CHANGED, text, f"{run.span.file}:{line}")

    def module(self, entry: str) -> tuple[str, TextFile] | None:
        """Path and text of the module; None where no stretch was added."""
        if self._beside is None:
            return None
        given, path = self._program.files[self._beside], PurePath(self._beside)
        name = self._names.new(re.sub(r"\W", "_", entry), "flat", 0)
        lines = [f"MODULE {name}", *self._data]
        for proc, body in self._bodies:
            lines += ["", f"{_INDENT}PROC {proc}()", *(f"{_INDENT * 2}{line}" for line in body), f"{_INDENT}ENDPROC"]
        end = self._edits.line_end(self._beside)
        text = end.join([*lines, "ENDMODULE", ""])
        mark = "\ufeff" if given.text.startswith("\ufeff") else ""
        place = str(path.with_name(f"{name}{'.modx' if path.suffix.lower() in ('.modx', '.sysx') else '.mod'}"))
        return place, TextFile(place, mark + re.sub(r"\r\n|\r|\n", lambda _: end, text), given.encoding)

    def _points(self, motion: Motion, how: FlatMotion, text: str) -> list[str]:
        """The lines of additional points, whose targets are declared here."""
        lines: list[str] = []
        for one in how.points:
            assert isinstance(motion, MoveJ | MoveAbsJ)
            if (one.type, one.name) not in self._known:  # passes of one text through one point share its name
                self._known[one.type, one.name] = one.name
                self._names.take(one.name)
                self._data.append(f"{_INDENT}LOCAL CONST {one.type} {one.name}:={one.literal};")
            lines += point_lines(one, motion, self._edits.text(motion.written.statement), text, how.fast)
        return lines

    def _statement(self, motion: Motion, how: FlatMotion) -> str:
        span = motion.written.statement
        text = self._edits.text(span)
        changes: list[tuple[Span, str]] = []
        if isinstance(motion, Move):
            assert how.wish is not None
            changes = self._of_move(motion, how.wish, how.fast, text)
        elif self._scopes.shared(text, span.file, span.start) is not None:  # its value alone is known here alone
            last = last_argument(motion, text)
            start = span.start + text.rindex(last)
            value = motion.value if isinstance(motion, SignalEvent) else motion.programmed
            changes = [(Span(span.file, start, start + len(last)), plain(value))]
        for where, new in sorted(changes, key=lambda change: -change[0].start):
            text = text[: where.start - span.start] + new + text[where.end - span.start :]
        gap = (lambda match: match[1] + _INDENT * 3) if "!" in text else " "  # behind a comment the line must end
        return re.sub(r"[ \t]*(\r\n|\r|\n)\s*", gap, text)

    def _of_move(self, move: Move, wish: TargetEdit, fast: bool, text: str) -> list[tuple[Span, str]]:
        call, span = read_move(move, text), move.written.statement
        targets = self._targets
        type_ = type_of(move)
        aggregate = move.written.aggregate
        literal = targets.in_numbers(move, wish) if aggregate is None else targets.copied(move, wish)
        name = self.declare(targets.base(move), type_, literal)
        changes = [(call.target, name)]
        if isinstance(move, MoveC) and call.via is not None:
            changes.append(
                (call.via, self.declare(f"{targets.base(move)}_via", type_, targets.circle_point(move, wish)))
            )
        if fast:
            changes.append((call.speed, "vmax"))
        elif self._scopes.shared(self._edits.text(call.speed), span.file, span.start) is not None:
            speed = move.speed
            values = (speed.v_tcp / MM, speed.v_ori / DEG, speed.v_leax / MM, speed.v_reax / DEG)
            changes.append((call.speed, f"[{','.join(plain(value) for value in values)}]"))
            fast = True
        if fast and call.override is not None:  # a literal has it, and it would hold vmax down
            changes.append((call.override, ""))
        return changes

    def _left_behind(self, run: SingleRun) -> list[str]:
        """What else the statement does, by the names of its instructions, each once."""
        carried = {
            called(self._edits.text(motion.written.statement), motion.written.statement).lower()
            for motion in self._program.motions[run.first : run.last]
        }
        found: dict[str, str] = {}
        for node in self._scopes.instructions(run.span):
            name = _instruction(node)
            known = name is None or name.lower() in carried or name.lower() in self._scopes.procedures
            if name is not None and not known:
                found.setdefault(name.lower(), name)
        return list(found.values())


def _instruction(node: Node) -> str | None:
    if isinstance(node, Assign):
        return "assignments"
    if isinstance(node, LateCall):
        return "what late-bound procedures do besides"
    return node.name if isinstance(node, ProcedureCall) else None
