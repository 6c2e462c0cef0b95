"""A program's text: its statements that move, and what their targets depend on."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveC, PoseMove, Program, Span, Wait
from trajopt_cli.problem.data_flow import ROBOT, Branch, DataFlow, Key, Place, Trace
from trajopt_cli.problem.scopes import Scopes, called_names, nodes
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    Call,
    Expression,
    Goto,
    LateCall,
    Node,
    ProcedureCall,
    Return,
    Routine,
    Simple,
)
from trajopt_cli.scenario import Scenario

Passes = tuple[int, ...]
_SAME = 1e-9  # m and entries of rotations: the same place


@dataclass(frozen=True)
class MoveStatement:
    """A statement that moves. target: its expression as written. runs: its motions, in order. literals: of each run the
    `[...]` that gives the target's value, None where it is computed. variable: the first name in the target that may
    have another value at another time. loops: the loops around it, those around calls of its routine included."""

    span: Span
    target: str
    runs: Passes
    literals: tuple[Span | None, ...]
    variable: str | None
    loops: tuple[Span, ...]


class ProgramText:
    """The parsed files of a program, beside the motions of its run. single: motions whose statement ran once."""

    def __init__(self, program: Program, scenario: Scenario):
        self.program = program
        self.scopes = Scopes(program.files)
        self.flow = DataFlow(self.scopes, scenario, program.entry, program.passes > 0)
        self.runs = Counter(motion.written.statement for motion in program.motions)
        self.single = {i for i, motion in enumerate(program.motions) if self.runs[motion.written.statement] == 1}
        self._traces: dict[tuple[Span, bool], Trace] = {}

    @cached_property
    def statements(self) -> Mapping[Span, MoveStatement]:
        """The statements that move, by their place in the text."""
        found: dict[Span, list[int]] = defaultdict(list)
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, Move):
                found[motion.written.statement].append(i)
        out = {}
        for span, indices in found.items():
            moves = [move for i in indices if isinstance(move := self.program.motions[i], Move)]
            loops = {(at.path, branch) for at, branch in self.flow.loops(self.place(span))}
            out[span] = MoveStatement(
                span,
                moves[0].target,
                tuple(indices),
                tuple(move.written.aggregate for move in moves),
                self.scopes.depends_on(moves[0]),
                tuple(sorted(Span(path, branch.start, branch.end) for path, branch in loops)),
            )
        return out

    def place(self, span: Span) -> Place:
        """Where a statement stands."""
        return self.flow.places.get((span.file, span.start)) or Place(
            span.file, span.start, self.scopes.routine(span.file, span.start)
        )

    def text_of(self, span: Span) -> str:
        """The text between two places of a file."""
        return self.program.files[span.file].text[span.start : span.end]

    @cached_property
    def motion_at(self) -> Mapping[tuple[str, int], Motion]:
        """A motion of each statement that makes some, by file and offset."""
        spans = ((motion.written.statement, motion) for motion in self.program.motions)
        return {(span.file, span.start): motion for span, motion in spans}

    def trace(self, move: Move, target: bool = False) -> Trace:
        """What the target of a move depends on; target: its external axes and configuration alone."""
        span = move.written.target
        if span is None:
            return Trace()
        key = (span, target)
        if key not in self._traces:
            expression = parse_expression(self.text_of(span), span.file)
            found = self._traces[key] = self.flow.trace((expression,), self.place(move.written.statement), target)
            if ROBOT in found.keys:
                found.labels |= self._labels_of_position(move.written.statement)
        return self._traces[key]

    def _labels_of_position(self, span: Span) -> set[str]:
        """What of the scenario decides where the robot is before a statement: the move before it, or all of them."""
        node = self.flow.before.get((span.file, span.start))
        while node is not None and not self._makes_moves(node, span.file):
            node = self.flow.before[span.file, node.start]
        motion = None if node is None else self.motion_at.get((span.file, node.start))
        return self.trace(motion).labels if isinstance(motion, Move) else self._labels_of_moves

    @cached_property
    def _labels_of_moves(self) -> set[str]:
        """What of the scenario decides which moves the program makes, and where to."""
        labels: set[str] = set()
        for path, routine, branch in self.flow.branches:
            if branch in self.moving_branches:
                labels |= self.flow.trace(branch.conditions, Place(path, branch.start, routine)).labels
        for span, one in self.statements.items():
            if None in one.literals and (node := self.flow.nodes.get((span.file, span.start))):
                labels |= self.labels_of(node, self.place(span))
        return labels

    def labels_of(self, node: Node, place: Place) -> set[str]:
        """What of the scenario a motion hangs on; that a wait ends with its signal is no such thing."""
        motion = self.motion_at.get((place.path, node.start))
        if motion is None or not isinstance(node, ProcedureCall):
            return set()
        args = node.args if isinstance(motion, Move) else node.args[-1:]
        waits = isinstance(motion, Wait) and motion.condition is not None
        return set() if waits else self.flow.trace([one.value for one in args if one.value is not None], place).labels

    def literal_data(self, move: Move) -> tuple[Key, int | None] | None:
        """The data whose declaration holds a move's literal, and which element of an array it is."""
        declaration, literal = move.written.declaration, move.written.aggregate
        if declaration is None or literal is None:
            return None
        text = self.text_of(declaration)
        name, _, value = text.partition(":=")
        key = (self.scopes.owner(declared_name(text), declaration.file, declaration.start), declared_name(text).lower())
        if "{" not in name:
            return key, None
        node = parse_expression(value.rstrip().removesuffix(";"), declaration.file)
        offset = literal.start - declaration.start - len(name) - len(":=")
        items = node.items if isinstance(node, Aggregate) else ()
        return key, next((i for i, item in enumerate(items, 1) if item.start == offset), None)

    @cached_property
    def constants(self) -> frozenset[int]:
        """The moves to computed targets whose statement goes to one place, however often it runs."""
        out: set[int] = set()
        for one in self.statements.values():
            if None in one.literals and _one_target(self.program, one.runs):
                out |= set(one.runs)
        return frozenset(out)

    def depends_on_scenario(self, index: int) -> bool:
        """Whether the target of a move, computed and in one place in all its runs, hangs on the scenario."""
        motion = self.program.motions[index]
        return index in self.constants and isinstance(motion, Move) and bool(self.trace(motion).labels)

    @cached_property
    def by_routine(self) -> Mapping[int, Sequence[tuple[Place, Node]]]:
        """The statements of each routine, by its id."""
        out: dict[int, list[tuple[Place, Node]]] = defaultdict(list)
        for key, place in self.flow.places.items():
            out[id(place.routine)].append((place, self.flow.nodes[key]))
        return out

    @cached_property
    def moving_branches(self) -> frozenset[Branch]:
        """The branches around motions, calls that make some, and statements that leave something."""
        out: set[Branch] = set()
        for key, place in self.flow.places.items():
            node = self.flow.nodes[key]
            if key in self.motion_at or isinstance(node, Return | Goto | Simple) or self._moves(node):
                out |= set(place.branches)
        return frozenset(out)

    def _moves(self, node: Node) -> bool:
        if isinstance(node, LateCall):
            return True
        routines = self.scopes.procedures.get(node.name.lower(), ()) if isinstance(node, ProcedureCall) else ()
        return any(id(inner) in self._moving_routines for one in routines for inner in self._reached(one))

    @cached_property
    def _moving_routines(self) -> frozenset[int]:
        spans = {motion.written.statement for motion in self.program.motions}
        return frozenset(id(self.scopes.routine(span.file, span.start)) for span in spans)

    def _makes_moves(self, node: Node, path: str) -> bool:
        inside = (one for one in nodes(node) if isinstance(one, ProcedureCall | LateCall))
        return any(isinstance(self.motion_at.get((path, one.start)), Move) or self._moves(one) for one in inside)

    def _reached(self, routine: Routine) -> list[Routine]:
        return [routine, *self.reached_from(node for _, node in self.by_routine.get(id(routine), ()))]

    def reached_from(self, statements: Iterable[Node]) -> list[Routine]:
        """The routines that statements call, directly or not."""
        seen: dict[int, Routine] = {}
        stack = list(statements)
        while stack:
            for name in called_names(stack.pop()):
                every = self.scopes.procedures.values() if name is None else [self.scopes.procedures.get(name, [])]
                for routine in (one for several in every for one in several):
                    if id(routine) not in seen:
                        seen[id(routine)] = routine
                        stack += [node for _, node in self.by_routine.get(id(routine), ())]
        return list(seen.values())

    def acts(self, move: Move) -> bool:
        """Whether computing a target changes data that outlive it."""
        span = move.written.target
        assert span is not None
        names = {node.name.lower() for node in _calls(parse_expression(self.text_of(span), span.file))}
        routines = [one for name in names for one in self.scopes.procedures.get(name, ())]
        return any(
            change.key[0] != (change.place.path, routine.start) and not change.given
            for routine in (inner for one in routines for inner in self._reached(one))
            for several in self.flow.changes.values()
            for change in several
            if change.place.routine is routine
        )


def declared_name(declaration: str) -> str:
    """The name in a data declaration, without the dimensions of an array."""
    return declaration.split(":=")[0].split("{")[0].split()[-1]


def _calls(node: Expression) -> Iterator[Call]:
    return (one for one in nodes(node) if isinstance(one, Call))


def _one_target(program: Program, indices: Passes) -> bool:
    """Whether all passes of a statement have one target in numbers."""
    first, *others = (program.motions[i] for i in indices)
    return all(_target_numbers(one, first) for one in others)


def _target_numbers(one: Motion, other: Motion) -> bool:
    assert isinstance(one, Move)
    assert isinstance(other, Move)
    if type(one) is not type(other) or one.extax != other.extax:
        return False
    if isinstance(one, MoveAbsJ) and isinstance(other, MoveAbsJ):
        return bool(np.abs(one.q - other.q).max() <= _SAME)
    if isinstance(one, PoseMove) and isinstance(other, PoseMove):
        same = one.conf == other.conf and np.abs(one.X_WT - other.X_WT).max() <= _SAME
        vias = [move.X_WV for move in (one, other) if isinstance(move, MoveC)]
        return bool(same and (not vias or np.abs(vias[0] - vias[-1]).max() <= _SAME))
    return True
