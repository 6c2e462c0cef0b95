"""The literals of targets with the plan's rail position and configuration in them, and targets declared anew."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trajopt_cli.exporters.rapid_text import PLACE, Edits, Names, num, plain, refusal, same_num
from trajopt_cli.geometry import Array, inverse_pose, wxyz_from_rotation
from trajopt_cli.motion import ConfData, Hold, Move, MoveAbsJ, MoveC, MoveExtJ, PoseMove, Program, Span
from trajopt_cli.problem.editable_text import confdata_counts
from trajopt_cli.problem.move_call import read_move
from trajopt_cli.problem.nearest import is_nearest
from trajopt_cli.problem.plan import PlannedMotion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.program_text import declared_name
from trajopt_cli.problem.scopes import Scopes
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.parser import parse_statement
from trajopt_cli.rapid.language.syntax import Aggregate, Expression, Number, ProcedureCall
from trajopt_cli.robot.inverse import confdata, confdata_admits
from trajopt_cli.units import DEG, MM
from trajopt_cli.warnings import ProgramWarning, WarningKind

_SAME_RAIL = 5e-4  # mm: half of the last decimal that is written
_TURNED = 5e-7  # rad: half of what the judge lets pass; written with six decimals an orientation turns by up to 2e-6
_RAIL_STILL = 1e-9  # m


@dataclass(frozen=True)
class TargetEdit:
    r"""What a target must say: the rail position in mm as text (None to leave it), and the confdata (None likewise).

    monitored: confdata must be switched on (ConfJ \On, ConfL \On) for this move.
    """

    rail: str | None
    conf: ConfData | None
    monitored: bool = False


_STORAGE = ("CONST", "PERS", "VAR")
_PERS = re.compile(r"^[ \t]*(?:TASK\s+)?PERS\s+\w+\s+(\w+)", re.IGNORECASE | re.MULTILINE)


class Targets:
    """Hands out, motion by motion, the name under which a target with the wished values is declared.

    pinned: literals that stay as they are, so that a target with other values is a new one. So do those of a PERS that
    several modules declare: they are one piece of data, and edited in one place they would disagree.
    """

    def __init__(
        self, program: Program, plant: Plant, edits: Edits, names: Names, scopes: Scopes,
        pinned: frozenset[Span] = frozenset(),
    ):  # fmt: skip
        self._program, self._plant, self._edits, self._names = program, plant, edits, names
        self._scopes, self._pinned = scopes, pinned
        self._literals: dict[Span, dict[str, str | None]] = {}  # the names by what they say; None: the literal itself
        self._declared: dict[tuple[str, str, str], str] = {}
        self._points: set[str] = set()
        self.notes: list[ProgramWarning] = []

    # -------------------------------------------------------------------------------------------------- the wishes

    def wish(self, move: Move, planned: PlannedMotion, leave_open: bool = False, dwell: bool = False) -> TargetEdit:
        """What the target of a move must say to be reached as planned; as written where that already holds.

        leave_open: an open rail (9E9) may stay open in a move that does not take the rail along. dwell: for a line
        at the place of the move, along which only the rail moves, so that no configuration is nearer than the planned.
        """
        rail, q, eax, layout = None, planned.q_1, self._plant.rail_eax, self._plant.layout
        if eax is not None and move.hold is not Hold.UNIT:
            still = abs(float(layout.place(q - planned.q_0))) <= _RAIL_STILL
            if not (leave_open and still and move.extax[eax] is None):
                rail = plain(float(layout.place(q)) / MM - self._offsets(move)[eax], PLACE)
        conf, monitored = None, False
        if isinstance(move, PoseMove):
            robot, arm = self._plant.robot, np.asarray(q[layout.arm])
            monitored = not dwell and not confdata_counts(move) and not is_nearest(self._plant, planned, move)
            if confdata_counts(move) or monitored or dwell:
                conf = move.conf if confdata_admits(robot, move.conf, arm) else confdata(robot, arm)
        return TargetEdit(rail, conf, monitored)

    def as_written(self, move: Move) -> TargetEdit:
        """The wish for what a target says now."""
        eax = self._plant.rail_eax
        value = None if eax is None else move.extax[eax]
        rail = None if value is None or eax is None else plain(value - self._offsets(move)[eax], PLACE)
        return TargetEdit(rail, move.conf if isinstance(move, PoseMove) else None)

    def _offsets(self, move: Move) -> tuple[float, ...]:
        r"""What EOffs adds to the external axes that this move's target says; mm or deg."""
        offsets = move.settings.eax_offset
        if any(offsets) and isinstance(move, MoveAbsJ | MoveExtJ):
            switches = read_move(move, self._edits.text(move.written.statement)).switches
            if "useeoffs" not in switches if isinstance(move, MoveExtJ) else "noeoffs" in switches:
                return (0.0,) * 6
        return offsets

    # ------------------------------------------------------------------------------------------------ their targets

    def point(self, move: Move, wish: TargetEdit, several: bool = False) -> str | None:
        """The name that a move must refer to for this wish; None where it may keep what it refers to.

        several: its statement runs several times, so it can hardly refer to another.
        """
        span = move.written.aggregate
        if span is None:
            return None  # a computed target; whether the plan can live with it is seen when the text is read back
        return self._version(span, move, wish, "", 2, in_place=several or span not in self._pinned)

    def own(self, move: Move, wish: TargetEdit) -> str:
        """The name of a new target that says in numbers what a move computes, with the wished values."""
        span = move.written.statement
        name = self._new(move, self.in_numbers(move, wish), span, "", 2)
        text = f"{move.target} is computed; {name} is declared with its value"
        self.notes.append(ProgramWarning(WarningKind.CHANGED, text, move.source))
        return name

    def dwell(self, move: Move, wish: TargetEdit, wait: Span) -> str:
        """The name of a target at the place of a move's, with the wished values, for a statement at wait."""
        span = move.written.aggregate
        if span is None or not self._seen_from(move, wait):
            return self._new(move, self.in_numbers(move, wish), wait, "b", 0)
        # None is the literal itself: the rail moves by less than the last decimal that is written.
        return self._version(span, move, wish, "b", 0, in_place=False) or move.target

    def dwell_at(self, move: MoveAbsJ | MoveExtJ, planned: PlannedMotion, X_WT: Array, wait: Span) -> str:
        """The name of a new robtarget at the axis positions planned, where the tool is at X_WT in the world."""
        beside = move.written.declaration
        if beside is not None and not self._seen_from(move, wait):
            beside = None
        return self._new(move, self.at_joints(move, planned, X_WT), beside or wait, "b", 0, "robtarget")

    def at_joints(self, move: MoveAbsJ | MoveExtJ, planned: PlannedMotion, X_WT: Array) -> str:
        """A robtarget's literal for the axis positions planned; in the world, so no displacement may be active."""
        q, eax = planned.q_1, self._plant.rail_eax
        if move.settings.displaced:
            raise refusal(
                move.source,
                f"the plan moves the rail while the program waits at {move.target}, which are joints, under a program "
                "displacement; end it with PDispOff before, or move to a robtarget",
            )
        layout = self._plant.layout
        rail = None if eax is None else plain(float(layout.place(q)) / MM - move.settings.eax_offset[eax], PLACE)
        wish = TargetEdit(rail, confdata(self._plant.robot, np.asarray(q[layout.arm])))
        assert wish.conf is not None
        return f"[{_pose(X_WT)},{_conf(wish.conf)},{self._external(move, wish, move.settings.eax_offset)}]"

    def literal(self, point: Move, own: Move) -> str:
        """An additional point before a move as a literal, which the move's own options are in force for."""
        values = replace(point, written=own.written)
        return self.in_numbers(values, self.as_written(values))

    def declare_point(self, name: str, type_: str, literal: str, own: Move) -> None:
        """A constant for an additional point: beside the data its move's target is named after, or at the head of the
        module."""
        self._names.take(name)
        if name not in self._points:
            self._points.add(name)
            self._declare(None, own.written.statement, name, type_, literal, base_name(own.target))

    def _seen_from(self, move: Move, place: Span) -> bool:
        """Whether what is declared beside a move's target can be named at a place."""
        beside = move.written.declaration
        if beside is None:
            span = move.written.aggregate
            assert span is not None
            return self._module_wide(span, place)
        base = declared_name(self._edits.text(beside))
        owner = self._scopes.owner(base, beside.file, beside.start)
        return owner is None or owner == self._scopes.owner(base, place.file, place.start)

    def _module_wide(self, one: Span, other: Span) -> bool:
        return one.file == other.file and self._scopes.head(one.file, one.start) == self._scopes.head(
            other.file, other.start
        )

    def _version(
        self, span: Span, move: Move, wish: TargetEdit, suffix: str, first: int, in_place: bool = True
    ) -> str | None:
        versions = self._literals.setdefault(span, {})
        text = self.written_with(self._edits.text(span), move, wish)
        if text in versions:
            return versions[text]
        shared = self._shared(move.written.declaration)
        in_place = in_place and not shared
        if text == self._edits.text(span) and (span in self._pinned or shared):
            versions[text] = None
            return None
        if in_place and None not in versions.values():
            versions[text] = None
            if text != self._edits.text(span):
                self._edits.replace(span, text)
            return None
        statement = move.written.statement
        if self._seen_from(move, statement):
            name = self._names.new(base_name(move.target), suffix, first)
            self._declare(move.written.declaration, span, name, type_of(move), text)
        else:
            name = self._new(move, self.in_numbers(move, wish), statement, suffix, first)
        versions[text] = name
        if not suffix:
            now = self.as_written(move)
            others = ["rail position"] * (wish.rail != now.rail)
            others += ["configuration"] * (wish.conf not in (None, now.conf))
            note = f"{move.target} needs another {' and '.join(others)} here: {name}"
            variable = move.written.declaration is not None and self._storage(move.written.declaration) != "CONST"
            note += f", which does not follow {move.target} if it changes" if variable else ""
            self.notes.append(ProgramWarning(WarningKind.CHANGED, note, move.source))
        return name

    def _storage(self, declaration: Span) -> str:
        return next((word for word in self._edits.text(declaration).upper().split() if word in _STORAGE), "")

    def _shared(self, declaration: Span | None) -> bool:
        """Whether a declaration is one of several modules' for the same PERS."""
        if declaration is None or self._storage(declaration) != "PERS":
            return False
        match = _PERS.match(self._edits.text(declaration))
        return match is not None and self._modules_of_pers[match[1].lower()] > 1

    @cached_property
    def _modules_of_pers(self) -> Counter[str]:
        """How many files declare a PERS that is not LOCAL, by name in lower case."""
        found: Counter[str] = Counter()
        for file in self._program.files.values():
            found.update({match[1].lower() for match in _PERS.finditer(file.text)})
        return found

    def _new(self, move: Move, literal: str, beside: Span, suffix: str, first: int, type_: str | None = None) -> str:
        """The name of a target declared anew; one for each value.

        beside: the declaration of the move's own target, or a place: then it is a constant beside the data it is named
        after, or at the head of the module around that place.
        """
        base = base_name(move.target)
        key = (base, beside.file, literal)
        if key not in self._declared:
            self._declared[key] = self._names.new(base, suffix, first)
            given = beside if beside == move.written.declaration else None
            self._declare(given, beside, self._declared[key], type_ or type_of(move), literal, base)
        return self._declared[key]

    # ----------------------------------------------------------------------------------------------- the literals

    def in_numbers(self, move: Move, wish: TargetEdit) -> str:
        """A move's target as a literal, from the values it has in the run. Raises InputError where they are unknown."""
        if isinstance(move, PoseMove):
            X_WO = self.frame(move)
            conf = _conf(wish.conf or move.conf)
            return f"[{_pose(inverse_pose(X_WO) @ move.X_WT)},{conf},{self._external(move, wish)}]"
        joints = move.q / DEG if isinstance(move, MoveAbsJ) else np.zeros(6)  # MoveExtJ looks at no joints
        return f"[[{','.join(num(float(value), 6) for value in joints)}],{self._external(move, wish)}]"

    def copied(self, move: Move, wish: TargetEdit) -> str:
        """The literal that gives a move's target, with the wish in it, for another module to hold."""
        span = move.written.aggregate
        assert span is not None
        node = parse_expression(self._edits.text(span), span.file)
        assert isinstance(node, Aggregate)
        if node.numbers is None:
            return self.in_numbers(move, wish)
        return self.written_with(self._edits.text(span), move, wish)

    def circle_point(self, move: MoveC, wish: TargetEdit) -> str:
        """The circle point of a move as a literal."""
        return (
            f"[{_pose(inverse_pose(self.frame(move)) @ move.X_WV)},{_conf(wish.conf or move.conf)},"
            f"{self._external(move, wish)}]"
        )

    def base(self, move: Move) -> str:
        """A name to build others from, for a move's target: of the data it comes from, as far as that can be told."""
        if move.written.declaration is not None:
            return declared_name(self._edits.text(move.written.declaration))
        name, at = base_name(move.target), move.written.statement
        routine, once = self._scopes.routine(at.file, at.start), move.written.once
        parameters = [] if routine is None else [parameter.name.lower() for parameter in routine.parameters]
        if routine is None or once is None or name.lower() not in parameters:
            return name
        call = parse_statement(self._edits.text(once), once.file)
        required = [one for one in getattr(call, "args", ()) if one.name is None]
        place = parameters.index(name.lower())
        optional = any(parameter.optional for parameter in routine.parameters[: place + 1])
        if not isinstance(call, ProcedureCall) or call.name.lower() != routine.name.lower() or optional:
            return name  # called from somewhere further inside
        argument = required[place]
        return base_name(self._edits.text(once)[argument.start : argument.end])

    @staticmethod
    def frame(move: PoseMove) -> Array:
        """X_WO of a move. Raises InputError where it has none."""
        if move.X_WO is None:
            raise refusal(
                move.source,
                f"{move.target} is computed, and its work object {move.wobj} is no fixed frame: declare it as a "
                "robtarget of its own",
            )
        return move.X_WO

    def written_with(self, text: str, move: Move, wish: TargetEdit) -> str:
        """A target's literal with the wish in it; a number that says so already keeps its spelling."""
        node = parse_expression(text, move.source.file)
        assert isinstance(node, Aggregate)
        changes: list[tuple[Expression, str]] = []
        if wish.conf is not None and isinstance(move, PoseMove) and wish.conf != move.conf:
            part = node.items[2]
            if isinstance(part, Aggregate) and len(part.items) == len(_four(wish.conf)):  # S4 wrote no cfx
                wanted, written = _four(wish.conf), _four(move.conf)
                changes += [
                    (item, str(new)) for item, old, new in zip(part.items, written, wanted, strict=True) if old != new
                ]
            else:
                changes.append((part, _conf(wish.conf)))
        eax = self._plant.rail_eax
        if eax is not None and wish.rail is not None:
            part = node.items[3 if isinstance(move, PoseMove) else 1]
            item = part.items[eax] if isinstance(part, Aggregate) else part
            value = move.extax[eax]
            if isinstance(item, Number):
                said: float | None = item.value
            else:
                said = None if value is None else value - self._offsets(move)[eax]
            if said is None or not same_rail(said, float(wish.rail)):
                changes.append((item, wish.rail if isinstance(part, Aggregate) else self._external(move, wish)))
        for item, new in sorted(changes, key=lambda change: -change[0].start):
            text = text[: item.start] + new + text[item.end :]
        return text

    def _external(self, move: Move, wish: TargetEdit, offsets: tuple[float, ...] | None = None) -> str:
        """External axes as a target must say them, EOffs taken out again, with the wished rail position."""
        taken = self._offsets(move) if offsets is None else offsets
        values = [
            "9E9" if value is None else num(value - offset, 6) for value, offset in zip(move.extax, taken, strict=True)
        ]
        if self._plant.rail_eax is not None and wish.rail is not None:
            values[self._plant.rail_eax] = wish.rail
        return f"[{','.join(values)}]"

    def _declare(self, beside: Span | None, place: Span, name: str, type_: str, literal: str, base: str = "") -> None:
        """Declare name beside a declaration, in its storage class; else a constant, as _new says."""
        relative = None if beside else self._scopes.declaration(base, place.file, place.start)
        if relative is not None:
            scope = "LOCAL " if re.match(r"(?i)LOCAL\b", self._edits.text(relative)) else ""
            self._edits.put_behind(relative, f"{scope}CONST {type_} {name}:={literal};")
            return
        if beside is None:
            offset, alone = self._scopes.head(place.file, place.start)
            declaration = f"CONST {type_} {name}:={literal};"
            end = self._edits.line_of(place.file, offset)[1]
            if not alone:
                self._edits.insert(place.file, offset, declaration + self._edits.line_end(place.file))
            elif self._edits.text(Span(place.file, offset, end)).strip()[:1] in ("", "!"):
                self._edits.insert(place.file, end, f"{self._edits.line_end(place.file)}    {declaration}")
            else:
                self._edits.insert(place.file, offset, f" {declaration}")
            return
        storage = re.match(r"(?i)(?:(?:LOCAL|TASK)\s+)?(?:CONST|VAR|PERS)\b", self._edits.text(beside))
        assert storage is not None  # it parsed as a declaration
        self._edits.put_behind(beside, f"{' '.join(storage[0].split())} {type_} {name}:={literal};")


def same_rail(one: float, other: float) -> bool:
    """Whether two rail positions [mm] are one as far as the text tells."""
    return abs(one - other) <= _SAME_RAIL or same_num(one, other)


def base_name(target: str) -> str:
    """A name to build others from: the first name of data in a target as written."""
    names = re.findall(r"(?<![\w.\\])([^\W\d]\w*+)\s*+(?!:=)(\()?", target)
    found = [name for name, opens in names if not opens] or [name for name, _ in names]
    return found[0] if found else "p"


def type_of(move: Move) -> str:
    """The data type of a move's target."""
    return "robtarget" if isinstance(move, PoseMove) else "jointtarget"


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


def _four(conf: ConfData) -> tuple[int, int, int, int]:
    return conf.cf1, conf.cf4, conf.cf6, conf.cfx


def _conf(conf: ConfData) -> str:
    return f"[{','.join(str(value) for value in _four(conf))}]"
