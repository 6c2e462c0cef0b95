"""A plan's wishes written into a program: numbers in place where a declaration serves one value, else functions and
arrays beside the code, so that every target's expression stays as written."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import Literal

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters import rapid_targets as targets
from trajopt_cli.exporters.rapid_text import TURN, Edits, Names, plain, refusal
from trajopt_cli.geometry import Array
from trajopt_cli.motion import ConfData, Move, MoveAbsJ, MoveJ, PoseMove, Source, Span, Wait
from trajopt_cli.problem.detours import JointMove, quoted
from trajopt_cli.problem.editable_text import EditableText, Passes, confdata_counts
from trajopt_cli.problem.move_call import last_argument, read_move
from trajopt_cli.problem.scopes import nodes
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Call, Name
from trajopt_cli.robot.inverse import confdata, confdata_admits
from trajopt_cli.warnings import ProgramWarning, WarningKind

_WIDTH = 100  # characters of a line of an array
_ABOUT = {
    "RailAt": "p with the rail at rail, and where it is given in configuration conf",
    "RailAtJ": "p with the rail at rail",
    "ConfAt": "p in configuration conf",
}


@dataclass(frozen=True)
class RapidExport:
    """texts: every file of the program by path, to be encoded as its TextFile says. notes: what users should know."""

    texts: Mapping[str, str]
    notes: tuple[ProgramWarning, ...] = ()


@dataclass(frozen=True, eq=False)
class Intent:
    """What shall become of one motion, a move or a wait in which the rail moves.

    rail: where it and what follows it is at the end as the target says it [mm], EOffs taken out; None where the target
    says nothing of it.
    moves: it gets there meanwhile. arm (6,): the joints at the end [rad]; None: the configuration stays as written.
    nearest: no others are nearer. drop: the move is left out. fast: at vmax. points: additional joint moves before it.
    turn: how far the tool is turned about its axis there, from as the target says it [deg].
    """

    rail: tuple[float, ...] | None = None
    moves: bool = False
    arm: Array | None = None
    nearest: bool = True
    drop: bool = False
    fast: bool = False
    points: tuple[JointMove, ...] = ()
    turn: float = 0.0


class Disagreement(InputError):
    """Executions of one statement want what it cannot say. routines: where it stands, names in lower case."""

    routines: frozenset[str] = frozenset()


def write(text: EditableText, intents: Mapping[int, Intent], unsure: Set[int] = frozenset()) -> RapidExport:
    """The edited program. Raises Disagreement, with the place, for a statement that cannot do what is wished.

    unsure: moves whose targets may say otherwise in the edited program than in the given one.
    """
    return _Writer(text, intents, unsure).result()


class _Writer:
    def __init__(self, text: EditableText, intents: Mapping[int, Intent], unsure: Set[int]):
        self._text, self._program, self._plant, self._scopes = text, text.program, text.plant, text.scopes
        self._intents, self._unsure = intents, unsure
        spans = (one.written.statement for one in self._program.motions)
        self._ran = {(span.file, span.start) for span in spans}  # in the cycle, of a program that never ends
        self._freed: Counter[Span] = Counter()  # uses of declared arrays that are no more
        self._edits, self._names = Edits(self._program.files), Names(self._program.files)
        self._notes: list[ProgramWarning] = []
        self._monitored: list[Source] = []
        self._functions: dict[tuple[str, int, str], str] = {}  # by module and kind
        self._arrays: dict[tuple[str, int, str], str] = {}  # by module and what it holds
        self._chosen: dict[str, str] = {}  # names of new ones, by kind
        self._wrapped: list[Source] = []
        self._turned: list[Source] = []
        self._wishes: dict[Span, dict[int, targets.Wish]] = {}  # of the executions of each statement that moves
        self._literals: dict[Span, Span | None] = {}  # of statements
        self._in_place: dict[Span, targets.Wish] = {}  # what literals say anew

    def result(self) -> RapidExport:
        """The texts with all edits made."""
        written = {
            span: tuple(i for i in indices if i in self._intents) for span, indices in self._text.statements.items()
        }
        moves = {i for i, motion in enumerate(self._program.motions) if isinstance(motion, Move)}
        moving = {span: indices for span, indices in written.items() if indices and indices[0] in moves}
        self._check(moving)
        self._wishes = {span: self._wishes_of(indices) for span, indices in moving.items() if not self._dropped(span)}
        self._choose_literals()
        for literal, wish in self._in_place.items():
            new = targets.rewritten(self._edits.text(literal), wish, self._plant.driven_eaxes)
            assert new is not None  # or it would not have been chosen
            if new != self._edits.text(literal):
                self._edits.replace(literal, new)
        for span, indices in written.items():
            if span in moving:
                self._move(span, indices)
            elif indices:
                self._wait(span, indices)
        for declaration, count in self._freed.items():
            if count == self._scopes.named(declaration):
                self._edits.remove(declaration)
        for places, what in (
            (self._wrapped, "a function around the target sets another rail position or configuration"),
            (self._turned, "RelTool around the target turns the tool about its axis"),
            (self._monitored, "ConfJ \\On added: the plan needs a configuration other than the nearest"),
        ):
            more = f" and {len(places) - 1} more" if len(places) > 1 else ""
            if places:
                self._notes.append(ProgramWarning(WarningKind.CHANGED, what, f"{places[0]}{more}"))
        return RapidExport(self._edits.result(), (*dict.fromkeys(self._notes),))

    def _dropped(self, span: Span) -> bool:
        return any(i in self._intents and self._intents[i].drop for i in self._text.statements[span])

    # ------------------------------------------------------------------------------------------------ what it says

    def _check(self, moving: Mapping[Span, Passes]) -> None:
        """Whether all executions want the same but their rail and configuration, and groups that share one value the
        same of these. Raises Disagreement."""
        wrong = []
        for indices in moving.values():
            first = self._intents[indices[0]]
            points = [[(one.target, one.zone) for one in self._intents[i].points] for i in indices]
            same = all((self._intents[i].drop, self._intents[i].fast) == (first.drop, first.fast) for i in indices)
            if not same or any(one != points[0] for one in points):
                wrong.append(indices[0])
            for group in [] if first.drop else self._grouped(indices):
                wanted = [self._intents[i] for i in group]
                rails, turns = {_shown(one.rail) for one in wanted}, {_shown((one.turn,)) for one in wanted}
                if len(turns) > 1 or (len(rails) > 1 and self._needed(group)):
                    wrong.append(group[0])
        self._refuse(wrong)

    def _refuse(
        self,
        wrong: Sequence[int],
        why: str = "the plan wants something else each time this statement runs, which it cannot say",
    ) -> None:
        if wrong:
            source = self._program.motions[wrong[0]].source
            found = Disagreement(why, file=source.file, line=source.line, column=source.column)
            spans = [self._program.motions[i].written.statement for i in wrong]
            routines = [self._scopes.routine(span.file, span.start) for span in spans]
            found.routines = frozenset(one.name.lower() for one in routines if one is not None)
            raise found

    def _grouped(self, indices: Passes) -> Iterable[list[int]]:
        """A statement's executions, those together that share one value."""
        groups: dict[object, list[int]] = defaultdict(list)
        for i in indices:
            groups[self._text.key(i)].append(i)
        return groups.values()

    def _wishes_of(self, indices: Passes) -> dict[int, targets.Wish]:
        """What the target of a statement must say in each of its executions."""
        monitored = any(not self._intents[i].nearest for i in indices)
        out = dict[int, targets.Wish]()
        for group in self._grouped(indices):
            rails = {_shown(self._intents[i].rail) for i in group}
            rail = rails.pop() if len(rails) == 1 else None  # where none of them needs to say it
            moves = [move for i in group if isinstance(move := self._program.motions[i], PoseMove)]
            arms = [arm for i in group if (arm := self._intents[i].arm) is not None]
            counts = bool(moves) and (monitored or confdata_counts(moves[0]))
            conf = None
            if counts and len(arms) == len(group):
                conf = targets.common_conf(self._plant, moves, arms)
                as_written = all(
                    confdata_admits(self._plant.robot, move.conf, arm) for move, arm in zip(moves, arms, strict=True)
                )
                if conf is None and not as_written:
                    self._refuse(group)
                if as_written and len({move.conf for move in moves}) > 1:
                    conf = None
            out |= dict.fromkeys(group, targets.Wish(rail, conf, counts))
        return out

    def _needed(self, indices: Sequence[int]) -> bool:
        """Whether the target of a move does not say in some execution what it must."""
        return any(self._says_otherwise(i) for i in indices)

    def _says_otherwise(self, index: int) -> bool:
        move, intent = self._program.motions[index], self._intents[index]
        assert isinstance(move, Move)
        if index in self._unsure:
            return True
        taken = targets.offsets(move, self._edits.text(move.written.statement)) if intent.rail else ()
        for eax, rail in zip(self._plant.driven_eaxes, intent.rail or (), strict=False):
            said = move.extax[eax]
            if intent.moves if said is None else not targets.same_rail(said - taken[eax], rail):
                return True
        wish = self._wishes.get(move.written.statement, {}).get(index)
        return isinstance(move, PoseMove) and wish is not None and wish.conf not in (None, move.conf)

    def _choose_literals(self) -> None:
        """The literals that are edited in place: of one value for all moves that name them."""
        users: dict[Span, list[Span]] = defaultdict(list)
        for span in self._wishes:
            if (literal := self._literal(span)) is not None:
                users[literal].append(span)
        for literal, spans in users.items():
            indices = [i for span in spans for i in self._wishes[span]]
            wishes = [self._wishes[span][i] for span in spans for i in self._wishes[span]]
            if not self._needed(indices):
                continue
            rails = {one.rail for one in wishes}
            confs = {one.conf for one in wishes if one.counts and one.conf is not None}
            silent = any(one.counts and one.conf is None for one in wishes)
            changed = confs and any(
                isinstance(move := self._program.motions[i], PoseMove) and move.conf not in confs for i in indices
            )
            if len(rails) == 1 and len(confs) < 2 and not (silent and changed):
                wish = targets.Wish(next(iter(rails)), next(iter(confs), None))
                if targets.rewritten(self._edits.text(literal), wish, self._plant.driven_eaxes) is not None:
                    self._in_place[literal] = wish

    def _literal(self, span: Span) -> Span | None:
        """The literal of a statement's target, in it or in a declaration that serves nothing but moves."""
        if span not in self._literals:
            self._literals[span] = self._find_literal(span)
        return self._literals[span]

    def _find_literal(self, span: Span) -> Span | None:
        target = self._program.motions[self._text.statements[span][0]].written.target
        if target is None:
            return None
        node = parse_expression(self._edits.text(target), span.file)
        base = self._scopes.base(node)
        if isinstance(base, Name):
            there = Name(target.start + base.start, target.start + base.end, base.name)
            return self._scopes.serves_moves(there, span.file, self._ran)
        return None if base is None else Span(span.file, target.start + base.start, target.start + base.end)

    # -------------------------------------------------------------------------------------------------- the statements

    def _move(self, span: Span, indices: Passes) -> None:
        move, intent, edits = self._program.motions[indices[0]], self._intents[indices[0]], self._edits
        assert isinstance(move, Move)
        if intent.drop:
            self._refuse_compact(span, move)
            edits.comment_out(span)
            self._notes.append(ProgramWarning(WarningKind.CHANGED, "dropped, as the program allows", move.source))
            return
        wishes = self._wishes[span]
        if intent.points and isinstance(move, MoveJ | MoveAbsJ):
            self._refuse_compact(span, move)
            self._points(move, intent)
        if any(not self._intents[i].nearest for i in indices):
            self._refuse_compact(span, move)
            self._monitored.append(move.source)
            kind = "ConfJ" if isinstance(move, MoveJ) else "ConfL"
            edits.put_before(span, rf"{kind} \On;")
            edits.put_behind(span, rf"{kind} \Off;")
        if self._literal(span) not in self._in_place and self._needed(indices):
            assert move.written.target is not None
            said = any(isinstance(m := self._program.motions[i], PoseMove) and wishes[i].conf not in (None, m.conf)
                       for i in indices) or not self._unsure.isdisjoint(indices)  # fmt: skip
            self._wrapped.append(move.source)
            edits.replace(move.written.target, self._around(span, move, wishes, said))
        if any(self._intents[i].turn for i in indices):
            assert move.written.target is not None
            begin, end = self._reltool(span, move, {i: self._intents[i].turn for i in indices})
            edits.insert(span.file, move.written.target.start, begin)
            edits.insert(span.file, move.written.target.end, end)
            self._turned.append(move.source)
        if intent.fast:
            call = read_move(move, edits.text(span))
            edits.replace(call.speed, "vmax")
            if call.override is not None:  # it would hold vmax down
                edits.replace(call.override, "")
            told = "at vmax, as the cell allows (free_speed)"
            self._notes.append(ProgramWarning(WarningKind.CHANGED, told, move.source))

    def _refuse_compact(self, span: Span, motion: Move | Wait) -> None:
        place = self._scopes.place(span)
        if place is not None and place.compact:
            raise refusal(motion.source, "this statement is part of an IF without THEN; write IF ... THEN ... ENDIF")

    def _points(self, move: MoveJ | MoveAbsJ, intent: Intent) -> None:
        """The points before a move as its text has them; blanks in names of bodies, and what its file cannot hold, as a
        comment can have them."""
        span, edits = move.written.statement, self._edits
        encoding, text = self._program.files[span.file].encoding, edits.text(span)
        lines = []
        for one in intent.points:
            around = tuple(name.encode(encoding, "replace").decode(encoding) for name in one.detour)
            made = targets.point(one, move, targets.point_literal(one, move, text, self._plant.driven_eaxes), around)
            lines += targets.point_lines(made, move, text, text, intent.fast)
            if self._names.take(made.name):
                self._declare(span, f"CONST {made.type} {made.name}:={made.literal};")
        targets.put_above(edits, span, lines)
        names = ", ".join(one.target for one in intent.points)
        verb = "are" if len(intent.points) > 1 else "is"
        told = f"{names} {verb} added before {move.target}, around {quoted(intent.points[0].detour)}"
        self._notes.append(ProgramWarning(WarningKind.CHANGED, told, move.source))

    # ------------------------------------------------------------------------------------------------- the waits

    def _wait(self, span: Span, indices: Passes) -> None:
        """A wait in which the rail moves becomes a line in place, or has one before it where it waits for a signal."""
        if not any(self._intents[i].moves for i in indices):
            return
        wait, before = self._program.motions[indices[0]], [self._text.before(i) for i in indices]
        assert isinstance(wait, Wait)
        if None in before or len(set(before)) > 1:
            self._refuse(indices, "the plan moves the rail in this wait, and no line can stand in its place")
        wishes = self._wishes_of_wait(indices)
        move = self._program.motions[self._text.dwells[indices[0]]]
        assert isinstance(move, PoseMove | MoveAbsJ)
        said = any(wish.conf is not None for wish in wishes.values())
        call = read_move(move, self._edits.text(move.written.statement))
        assert call.tool is not None
        speed, tool = self._edits.text(call.speed), self._edits.text(call.tool)
        wobj = "" if call.wobj is None else self._edits.text(call.wobj)
        frame = wobj or r"\WObj:=wobj0"
        here = None if isinstance(move, PoseMove) else rf"CRobT(\Tool:={tool}{frame})"
        target = self._around(span, move, wishes, said, here)
        turns = {i: self._intents.get(self._text.dwells[i], Intent()).turn for i in indices}
        if here is None and any(turns.values()):
            target = target.join(self._reltool(span, move, turns))
        seconds = plain(wait.duration) if wait.condition else last_argument(wait, self._edits.text(span))
        line = rf"MoveL {target},{speed}\T:={seconds},fine,{tool}{wobj};"
        if wait.condition is None:
            self._edits.replace(span, line)
        else:
            self._edits.put_before(span, line)
        self._notes.append(ProgramWarning(WarningKind.CHANGED, "the rail moves while the tool waits", wait.source))

    def _wishes_of_wait(self, indices: Passes) -> dict[int, targets.Wish]:
        """The same of lines that stand in for waits; a confdata only where that of the moves before does not do."""
        out = dict[int, targets.Wish]()
        said = [self._said_conf(self._text.dwells[i]) for i in indices]
        arms = [self._intents[i].arm for i in indices]
        counts = any(
            conf is not False and arm is not None and not (conf and confdata_admits(self._plant.robot, conf, arm))
            for conf, arm in zip(said, arms, strict=True)
        )
        for group in self._grouped(indices):
            rails = {_shown(self._intents[i].rail) for i in group}
            if len(rails) > 1 or None in rails:
                self._refuse(group)
            conf = None
            if counts:
                own = [arm for i in group if (arm := self._intents[i].arm) is not None]
                if (conf := targets.common_conf(self._plant, [], own)) is None:
                    self._refuse(group)
            out |= dict.fromkeys(group, targets.Wish(rails.pop(), conf, counts))
        return out

    def _said_conf(self, index: int) -> ConfData | Literal[False] | None:
        """The confdata that a move's expression, without what is put around it, has in the edited text; None where that
        is not known, False where a line behind it does not look at it."""
        move = self._program.motions[index]
        assert isinstance(move, Move)
        if not move.settings.conf_l:
            return False
        if isinstance(move, MoveAbsJ):
            return confdata(self._plant.robot, move.q)
        assert isinstance(move, PoseMove)
        assert move.written.target is not None
        node = parse_expression(self._edits.text(move.written.target), move.source.file)
        if self._wrapper(move.written.statement, node) is not None:
            return None
        literal = self._literal(move.written.statement)
        wish = None if literal is None else self._in_place.get(literal)
        return move.conf if wish is None or wish.conf is None else wish.conf

    # ------------------------------------------------------------------------------------------- functions and arrays

    def _around(
        self, span: Span, move: Move, wishes: Mapping[int, targets.Wish], says_conf: bool, here: str | None = None
    ) -> str:
        """A move's target with the function around it that says what a statement's executions want. here: what stands
        for the place that joints lead to."""
        assert move.written.target is not None
        text = here or self._edits.text(move.written.target)
        node = parse_expression(text, span.file)
        if (known := self._wrapper(span, node)) is not None:
            inner, *others = (one.value for one in known.args)
            assert inner is not None
            text = text[inner.start : inner.end]
            says_conf = says_conf or any(wish.counts for wish in wishes.values())
            own = span == move.written.statement
            for name in (one for one in nodes(tuple(others)) if isinstance(one, Name) and own):
                data = self._scopes.declared(name.name, span.file, span.start)
                if data is not None and data[1].scope == "LOCAL" and data[1].sizes:
                    self._freed[Span(data[0], data[1].start, data[1].end)] += 1
        rails = {i: wish.rail for i, wish in wishes.items()}
        base = base_name(text)
        given = {i: one for i, one in rails.items() if one is not None}
        if 0 < len(given) < len(wishes):  # the others stay where they are, wherever that is
            self._refuse([next(i for i in wishes if i not in given)])
        parts = []
        if given:
            letters = self._letters if len(self._letters) > 1 else ("",)
            each = [{i: one[n] for i, one in given.items()} for n in range(len(letters))]
            names = [f"rail{letter}{_titled(base)}" for letter in letters]
            values = (self._value(span, "num", name, one) for name, one in zip(names, each, strict=True))
            parts.append(",".join(values))
        if says_conf:
            confs = {i: targets.written_conf(wish.conf) for i, wish in wishes.items() if wish.conf is not None}
            if len(confs) < len(wishes):  # the others keep theirs, whichever that is
                self._refuse([next(i for i, wish in wishes.items() if wish.conf is None)])
            conf = self._value(span, "confdata", f"conf{_titled(base)}", confs)
            parts.append(conf if not parts else rf"{parts.pop()}\conf:={conf}")
        if not parts:  # its target says nothing
            self._refuse(list(wishes))
        type_ = "robtarget" if here or isinstance(move, PoseMove) else "jointtarget"
        kind = "ConfAt" if not given else "RailAt" if type_ == "robtarget" else "RailAtJ"
        return f"{self._function(span, kind, type_)}({text},{parts[0]})"

    def _reltool(self, span: Span, move: Move, turns: Mapping[int, float]) -> tuple[str, str]:
        r"""What stands before and behind a move's target and turns it by angles [deg] about the tool's axis, by
        execution: RelTool(TARGET,0,0,0\Rz:=ANGLE)."""
        assert isinstance(move, PoseMove)
        assert move.free is not None
        assert move.written.target is not None
        name = f"turn{_titled(base_name(self._edits.text(move.written.target)))}"
        value = self._value(span, "num", name, {i: plain(turn, TURN) for i, turn in turns.items()})
        return "RelTool(", rf",0,0,0\R{'xyz'[move.free.axis.index(1.0)]}:={value})"

    def _wrapper(self, span: Span, node: object) -> Call | None:
        """A target's call of a function that an export has written for this rail; None where it is none."""
        text = self._scopes.wrappers(span).get(node.name.lower(), "") if isinstance(node, Call) else ""
        said = sorted(re.findall(r"eax_([a-f]):=", text))
        return node if isinstance(node, Call) and text and said in ([], sorted(self._letters)) else None

    @property
    def _letters(self) -> tuple[str, ...]:
        """Of the external axes that rails and what follows them have."""
        return tuple("abcdef"[eax] for eax in self._plant.driven_eaxes)

    def _function(self, span: Span, kind: str, type_: str) -> str:
        """The name of the function in a statement's module, which is added where it is not there."""
        key = (*self._module(span), kind)
        if key not in self._functions:
            for text in self._scopes.wrappers(span).values():
                known = text.split("(")[0].split()[-1]
                if text.lower() == " ".join(_function(kind, known, type_, self._letters)).lower():
                    self._functions[key] = known
            if key not in self._functions:
                name = self._functions[key] = self._chosen.setdefault(kind, self._names.new(kind))
                self._add(span, [f"! {_ABOUT[kind]}", *_function(kind, name, type_, self._letters)])
        return self._functions[key]

    def _module(self, span: Span) -> tuple[str, int]:
        module = self._scopes.module(span.file, span.start)
        return span.file, module.start if module else 0

    def _add(self, span: Span, lines: Sequence[str]) -> None:
        """A routine at the end of a statement's module."""
        module, end = self._scopes.module(span.file, span.start), self._edits.line_end(span.file)
        text = self._program.files[span.file].text
        about, head, *body = lines
        indent = self._indentation(span)
        inner = [f"{indent or '    '}{one}" for one in body[:-1]]
        indented = [f"{indent}{one}" for one in (about, f"LOCAL {head}", *inner, body[-1])]
        if module is None or not module.name:
            self._edits.insert(span.file, len(text), "".join(f"{end}{line}" for line in indented) + end)
            return
        at = module.end - len("ENDMODULE")
        begin = self._edits.line_of(span.file, at)[0]
        if text[begin:at].strip():
            self._edits.insert(span.file, at, "".join(f"{end}{line}" for line in indented) + end)
        else:
            self._edits.insert(span.file, begin, end + "".join(f"{line}{end}" for line in indented))

    def _value(self, span: Span, type_: str, name: str, values: Mapping[int, str]) -> str:
        """What a statement's executions want: one value, or an element of an array of its own."""
        if len(set(values.values())) == 1:
            return next(iter(values.values()))
        counters = self._text.counters(span)
        by_key = {self._text.key(i)[1]: value for i, value in values.items()}
        used = list(range(len(counters)))
        for n in reversed(range(len(counters))):
            if _same_without(by_key, n):
                used.remove(n)
                by_key = {key[:n] + key[n + 1 :]: value for key, value in by_key.items()}
        sizes = [counters[n].count for n in used]
        size, gap = ",".join(map(str, sizes)), f"{self._edits.line_end(span.file)}{self._indentation(span)}    "
        said = f"{{{size}}}:={_nested(sizes, by_key, gap)};"
        key = (*self._module(span), said)
        if key not in self._arrays:
            self._arrays[key] = self._names.new(name)
            self._declare(span, f"LOCAL CONST {type_} {self._arrays[key]}{said}")
        return f"{self._arrays[key]}{{{','.join(counters[n].index for n in used)}}}"

    def _indentation(self, span: Span) -> str:
        """How far the items of a statement's module stand in."""
        module = self._scopes.module(span.file, span.start)
        if module is None or not module.items:
            return ""
        return self._edits.indentation(Span(span.file, module.items[-1].start, module.items[-1].end))

    def _declare(self, span: Span, declaration: str) -> None:
        """Declare something at the head of a statement's module."""
        offset, alone = self._scopes.head(span.file, span.start)
        end = self._edits.line_of(span.file, offset)[1]
        if not alone:
            self._edits.insert(span.file, offset, declaration + self._edits.line_end(span.file))
        elif self._edits.text(Span(span.file, offset, end)).strip()[:1] in ("", "!"):
            self._edits.insert(
                span.file, end, f"{self._edits.line_end(span.file)}{self._indentation(span)}{declaration}"
            )
        else:
            self._edits.insert(span.file, offset, f" {declaration}")


def _shown(rail: tuple[float, ...] | None) -> tuple[str, ...] | None:
    return None if rail is None else tuple(map(targets.rail_text, rail))


def _function(kind: str, name: str, type_: str, letters: Sequence[str]) -> list[str]:
    """The lines of a function that gives a target other positions of external axes or another configuration."""
    names = ["rail" if len(letters) == 1 else f"rail_{letter}" for letter in letters]
    rails = [f"p.extax.eax_{letter}:={one};" for letter, one in zip(letters, names, strict=True)]
    given = ",".join(f"num {one}" for one in names)
    if kind == "ConfAt":
        return [f"FUNC {type_} {name}({type_} p,confdata conf)", "p.robconf:=conf;", "RETURN p;", "ENDFUNC"]
    if kind == "RailAtJ":
        return [f"FUNC {type_} {name}({type_} p,{given})", *rails, "RETURN p;", "ENDFUNC"]
    conf = "IF Present(conf) p.robconf:=conf;"
    return [rf"FUNC {type_} {name}({type_} p,{given}\confdata conf)", *rails, conf, "RETURN p;", "ENDFUNC"]


def base_name(target: str) -> str:
    """A name to build others from: the first name of data in a target as written."""
    names = re.findall(r"(?<![\w.\\])([^\W\d]\w*+)\s*+(?!:=)(\()?", target)
    found = [name for name, opens in names if not opens] or [name for name, _ in names]
    return found[0] if found else "p"


def _titled(name: str) -> str:
    """A target's name behind another word: pPick as Pick, p_n1 as _n1."""
    rest = name[1:]
    return rest if name[:1] in "pj" and (rest[:1].isupper() or rest[:1] in ("_", *"0123456789")) else f"_{name}"


def _same_without(values: Mapping[tuple[int, ...], str], n: int) -> bool:
    """Whether values do not depend on the counter number n."""
    found: dict[tuple[int, ...], set[str]] = defaultdict(set)
    for key, value in values.items():
        found[key[:n] + key[n + 1 :]].add(value)
    return all(len(several) == 1 for several in found.values())


def _nested(sizes: Sequence[int], known: Mapping[tuple[int, ...], str], end: str) -> str:
    """An array's literal; elements that no execution of the run took are as the nearest that one took."""
    keys, near = np.array(list(known)), np.cumprod([max(sizes)] * len(sizes))[::-1]  # the inner loops' passes first
    values = list(known.values())

    def part(index: tuple[int, ...]) -> str:
        if len(index) == len(sizes):
            return known.get(index) or values[int((np.abs(keys - index) @ near).argmin())]
        return f"[{','.join(part((*index, i)) for i in range(sizes[len(index)]))}]"

    text, lines = part(()), [""]
    for piece in re.split(r"(?<=,)", text):
        if len(lines[-1]) + len(piece) > _WIDTH:
            lines.append("")
        lines[-1] += piece
    return end.join(lines)
