"""The literals of targets with the plan's rail position and configuration in them, and targets declared anew."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.export.rapid_text import Edits, Names, millimetres, plain
from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.motion import (
    ConfData,
    ExternalAxes,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    Span,
)
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Aggregate, Expression
from trajopt_cli.robot.inverse import confdata, confdata_admits
from trajopt_cli.units import MM

_SAME_RAIL = 5e-7  # mm: half of the last decimal that is written


@dataclass(frozen=True)
class Wish:
    """What a target must say: the rail position in mm as text (None without a rail), and the confdata."""

    rail: str | None
    conf: ConfData | None


@dataclass(eq=False)
class _Literal:
    """A literal of the program, the values it carries or will carry, and the names that carry them.

    versions: None stands for the literal itself, edited in place.
    """

    move: Move
    versions: dict[Wish, str | None] = field(default_factory=dict)


class Targets:
    """Hands out, motion by motion, the name under which a target with the wished values is declared."""

    def __init__(self, program: Program, plant: Plant, edits: Edits, names: Names):
        self._program, self._plant, self._edits, self._names = program, plant, edits, names
        self._literals: dict[Span, _Literal] = {}
        self._declared: dict[tuple[str, Wish], str] = {}
        self.notes: list[str] = []

    def wish(self, move: Move, q: Array) -> Wish:
        """What the target of a move must say to be reached at axis positions q; as written where that already holds."""
        rail = None
        if self._plant.rail_eax is not None:
            rail = millimetres(float(q[0]))
            written = move.extax[self._plant.rail_eax]
            if written is not None and abs(written - float(q[0]) / MM) <= _SAME_RAIL:
                rail = f"{written!r}"
        conf = None
        if isinstance(move, (MoveJ, MoveL)):
            arm = np.asarray(q[-6:])
            robot = self._plant.robot
            conf = move.conf if confdata_admits(robot, move.conf, arm) else confdata(robot, arm)
        return Wish(rail, conf)

    def point(self, move: Move, wish: Wish) -> str | None:
        """The name that a move must refer to for this wish; None where it may keep what it refers to."""
        span = move.written.aggregate
        if span is None:
            return None  # a computed target; whether the plan can live with it is seen when the text is read back
        return self._version(span, move, wish, "", 2)

    def dwell(self, move: Move, wish: Wish) -> str:
        """The name of a target at the place of a move's, with the wished values."""
        span = move.written.aggregate
        if span is None:
            raise InputError(
                f"the plan moves the rail while the program waits at {move.target}, which is computed; "
                "declare it as a robtarget of its own",
                file=move.source.file,
                line=move.source.line,
                column=move.source.column,
            )
        # None is the literal itself: the rail moves by less than the last decimal that is written.
        return self._version(span, move, wish, "b", 0, in_place=False) or move.target

    def dwell_at(self, move: MoveAbsJ | MoveExtJ, q: Array, X_WT: Array) -> str:
        """The name of a new robtarget at axis positions q, where the tool is at X_WT in the world."""
        span = move.written.declaration or move.written.aggregate
        rail = millimetres(float(q[0]))
        wish = Wish(rail, confdata(self._plant.robot, np.asarray(q[-6:])))
        base = _base_name(move.target)
        key = (base, wish)
        if span is None:
            span = move.written.statement
        if key not in self._declared:
            name = self._declared[key] = self._names.new(base, "b", 0)
            position = ",".join(plain(float(value) / MM, 9) for value in X_WT[:3, 3])
            rotation = ",".join(plain(float(value), 15) for value in wxyz_from_rotation(X_WT[:3, :3]))
            assert wish.conf is not None
            literal = f"[[{position}],[{rotation}],{_conf(wish.conf)},{self._external(move.extax, rail)}]"
            self._declare(span, move, name, "robtarget", literal)
        return self._declared[key]

    def _version(
        self, span: Span, move: Move, wish: Wish, suffix: str, first: int, in_place: bool = True
    ) -> str | None:
        literal = self._literals.setdefault(span, _Literal(move))
        if wish in literal.versions:
            return literal.versions[wish]
        text = self._written_with(self._edits.text(span), move, wish)
        if in_place and None not in literal.versions.values():
            literal.versions[wish] = None
            if text != self._edits.text(span):
                self._edits.replace(span, text)
            return None
        name = self._names.new(_base_name(move.target), suffix, first)
        literal.versions[wish] = name
        self._declare(move.written.declaration or span, move, name, self._type(move), text)
        if in_place:
            self.notes.append(f"{move.source}: {move.target} is wanted with other values; {name} is declared beside it")
        return name

    @staticmethod
    def _type(move: Move) -> str:
        return "robtarget" if isinstance(move, (MoveJ, MoveL)) else "jointtarget"

    # ----------------------------------------------------------------------------------------------- the literals

    def _written_with(self, text: str, move: Move, wish: Wish) -> str:
        """A target's literal with the wish in it; a number that says so already keeps its spelling."""
        node = parse_expression(text, move.source.file)
        assert isinstance(node, Aggregate)
        pose = isinstance(move, (MoveJ, MoveL))
        changes: list[tuple[Expression, str]] = []
        if wish.conf is not None and isinstance(move, (MoveJ, MoveL)) and wish.conf != move.conf:
            part = node.items[2]
            if isinstance(part, Aggregate):
                wanted, written = _four(wish.conf), _four(move.conf)
                changes += [
                    (item, str(new)) for item, old, new in zip(part.items, written, wanted, strict=True) if old != new
                ]
            else:
                changes.append((part, _conf(wish.conf)))
        eax = self._plant.rail_eax
        if eax is not None and wish.rail is not None and move.extax[eax] != float(wish.rail):
            part = node.items[3 if pose else 1]
            if isinstance(part, Aggregate):
                changes.append((part.items[eax], wish.rail))
            else:
                changes.append((part, self._external(move.extax, wish.rail)))
        for item, new in sorted(changes, key=lambda change: -change[0].start):
            text = text[: item.start] + new + text[item.end :]
        return text

    def _external(self, extax: ExternalAxes, rail: str) -> str:
        values = ["9E9" if value is None else plain(value) for value in extax]
        assert self._plant.rail_eax is not None
        values[self._plant.rail_eax] = rail
        return f"[{','.join(values)}]"

    def _declare(self, beside: Span, move: Move, name: str, type_: str, literal: str) -> None:
        """Declare name beside a declaration, in its storage class; at the module's head for a target without one."""
        if move.written.declaration is None:
            head = _module_head(self._program.files[beside.file].text, beside)
            line = f"{self._edits.line_end(beside.file)}    CONST {type_} {name}:={literal};"
            self._edits.insert(beside.file, self._edits.line_of(beside.file, head)[1], line)
            return
        storage = re.match(r"(?i)(?:(?:LOCAL|TASK)\s+)?(?:CONST|VAR|PERS)\b", self._edits.text(beside))
        assert storage is not None  # it parsed as a declaration
        self._edits.put_behind(beside, f"{' '.join(storage[0].split())} {type_} {name}:={literal};")


def _module_head(text: str, span: Span) -> int:
    """Where the line of the MODULE that span stands in ends, roughly: an offset on that line."""
    heads = [match.end() for match in re.finditer(r"(?im)^[ \t]*MODULE\b", text) if match.end() <= span.start]
    return heads[-1] if heads else 0


def _base_name(target: str) -> str:
    """A name to build others from: the first name in a target as written."""
    match = re.match(r"[^\W\d]\w*", target)
    return match[0] if match else "p"


def _four(conf: ConfData) -> tuple[int, int, int, int]:
    return conf.cf1, conf.cf4, conf.cf6, conf.cfx


def _conf(conf: ConfData) -> str:
    return f"[{','.join(str(value) for value in _four(conf))}]"
