"""What a plan for the RAPID controller may change of a program's text, answered from its syntax tree.

A target serves the moves that its literal or its expression names; what else depends on it stays as programmed. The
order of the questions: which moves have a literal, which computed targets a number can stand in for, which passes of
loops and routines one text serves, and which statements can be written out motion by motion.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import (
    DEFAULT_SETTINGS,
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    SignalEvent,
    Span,
    Wait,
)
from trajopt_cli.problem.data_flow import ROBOT, Branch, Change, DataFlow, Key, Place, Trace
from trajopt_cli.problem.editable import Changes, Loops, droppable, may_go, why_straight
from trajopt_cli.problem.move_call import called, last_argument, read_move
from trajopt_cli.problem.plant import Plant
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

PoseMove = MoveJ | MoveL | MoveC
Passes = tuple[int, ...]
KEPT = "kept as programmed on the RAPID target"
_PLACES = 5  # that a note names
_SAME = 1e-9  # m and entries of rotations: the same place
_LOOKS_AT_AXES = re.compile(r"\b(extax|robconf|robax|eoffson)\b", re.IGNORECASE)
_SETS = re.compile(
    r"(accset|pathacc|worldacc|conf[jl]|singarea|velset|speedref|grip|mechunit|(de)?actunit|cirpath|sync|pdisp|eoffs"
    r"|softact|softdeact|corr|tune|motsup)",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class SingleRun:
    """A statement that ran exactly once, and the motions it made: those from first up to, not including, last."""

    span: Span
    first: int
    last: int


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


class EditableText:
    """A program's text and what may change of it.

    changes: the answer. own: moves whose computed target a new one may stand in for. pinned: literals that must stay,
    as what stays is computed from them. flat: statements that may be written out motion by motion.
    """

    def __init__(self, program: Program, plant: Plant, scenario: Scenario, loops: Loops = Loops.KEEP):
        self.program, self.plant, self.loops = program, plant, loops
        self.scopes = Scopes(program.files)
        self.flow = DataFlow(self.scopes, scenario, program.entry)
        self.runs = Counter(motion.written.statement for motion in program.motions)
        self.single = {i for i, motion in enumerate(program.motions) if self.runs[motion.written.statement] == 1}
        self._traces: dict[tuple[Span, bool], Trace] = {}
        self._moving: set[int] = set()  # that cannot change as others are computed from it
        self.flat = self._writable_runs() if loops is Loops.UNROLL else ()
        covered = _inside(self.flat)
        self.own = frozenset(i for i in range(len(program.motions)) if i not in covered and self._can_be_said(i))
        self.changes = self._unrolled() if loops is Loops.UNROLL else self._loops_kept()

    # ------------------------------------------------------------------------------------------------- the statements

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
            loops = {(at.path, branch) for at, branch in self.flow.loops(self._place(span))}
            out[span] = MoveStatement(
                span,
                moves[0].target,
                tuple(indices),
                tuple(move.written.aggregate for move in moves),
                self.scopes.depends_on(moves[0]),
                tuple(sorted(Span(path, branch.start, branch.end) for path, branch in loops)),
            )
        return out

    @cached_property
    def bound(self) -> frozenset[int]:
        """The moves that can refer to no other target: run several times, or, where loops are kept, to whatever a
        variable names."""
        return frozenset(
            i
            for i, motion in enumerate(self.program.motions)
            if isinstance(motion, Move)
            and (i not in self.single or (motion.written.aggregate and self.scopes.depends_on(motion)))
        )

    def _place(self, span: Span) -> Place:
        return self.flow.places.get((span.file, span.start)) or Place(
            span.file, span.start, self.scopes.routine(span.file, span.start)
        )

    def _text(self, span: Span) -> str:
        return self.program.files[span.file].text[span.start : span.end]

    def trace(self, move: Move, target: bool = False) -> Trace:
        """What the target of a move depends on; target: its external axes and configuration alone."""
        span = move.written.target
        if span is None:
            return Trace()
        key = (span, target)
        if key not in self._traces:
            expression = parse_expression(self._text(span), span.file)
            found = self._traces[key] = self.flow.trace((expression,), self._place(move.written.statement), target)
            if ROBOT in found.keys:
                found.labels |= self._labels_of_position(move.written.statement)
        return self._traces[key]

    def _labels_of_position(self, span: Span) -> set[str]:
        """What of the scenario decides where the robot is before a statement: the move before it, or all of them."""
        node = self.flow.before.get((span.file, span.start))
        while node is not None and not self._makes_moves(node, span.file):
            node = self.flow.before[span.file, node.start]
        motion = None if node is None else self._motion_at.get((span.file, node.start))
        return self.trace(motion).labels if isinstance(motion, Move) else self._labels_of_moves

    def _makes_moves(self, node: Node, path: str) -> bool:
        inside = (one for one in nodes(node) if isinstance(one, ProcedureCall | LateCall))
        return any(isinstance(self._motion_at.get((path, one.start)), Move) or self._moves(one) for one in inside)

    @cached_property
    def _labels_of_moves(self) -> set[str]:
        """What of the scenario decides which moves the program makes, and where to."""
        labels: set[str] = set()
        for path, routine, branch in self.flow.branches:
            if branch in self._moving_branches:
                labels |= self.flow.trace(branch.conditions, Place(path, branch.start, routine)).labels
        for span, one in self.statements.items():
            if None in one.literals and (node := self.flow.nodes.get((span.file, span.start))):
                labels |= self._labels_of(node, self._place(span))
        return labels

    def literal_data(self, move: Move) -> tuple[Key, int | None] | None:
        """The data whose declaration holds a move's literal, and which element of an array it is."""
        declaration, literal = move.written.declaration, move.written.aggregate
        if declaration is None or literal is None:
            return None
        text = self._text(declaration)
        name, _, value = text.partition(":=")
        key = (self.scopes.owner(declared_name(text), declaration.file, declaration.start), declared_name(text).lower())
        if "{" not in name:
            return key, None
        node = parse_expression(value.rstrip().removesuffix(";"), declaration.file)
        offset = literal.start - declaration.start - len(name) - len(":=")
        items = node.items if isinstance(node, Aggregate) else ()
        return key, next((i for i, item in enumerate(items, 1) if item.start == offset), None)

    # ---------------------------------------------------------------------------------------------- computed targets

    def scenario_of(self, index: int) -> str | None:
        """What of the scenario the target of a move hangs on, or the statement around it that runs once."""
        motion = self.program.motions[index]
        label = None
        if isinstance(motion, Move) and index in self._constants:
            label = self.flow.first(self.trace(motion).labels)
        once = motion.written.once
        return label or (self._rejected.get(once) if once is not None else None)

    def depends_on_scenario(self, index: int) -> bool:
        """Whether the target of a move, computed and in one place in all its runs, hangs on the scenario."""
        motion = self.program.motions[index]
        return index in self._constants and isinstance(motion, Move) and bool(self.trace(motion).labels)

    @cached_property
    def _constants(self) -> frozenset[int]:
        """The moves to computed targets whose statement goes to one place, however often it runs."""
        out: set[int] = set()
        for one in self.statements.values():
            if None in one.literals and _one_target(self.program, one.runs):
                out |= set(one.runs)
        return frozenset(out)

    def _can_be_said(self, index: int) -> bool:
        """Whether a new target in numbers may stand in for a computed one."""
        motion = self.program.motions[index]
        if not isinstance(motion, Move) or motion.written.aggregate is not None or motion.written.target is None:
            return False
        if isinstance(motion, PoseMove) and motion.X_WO is None:
            return False
        if index not in self._constants or self.depends_on_scenario(index) or self._acts(motion):
            return False
        if index not in self.single and self.loops is Loops.UNROLL:
            return False
        if self.loops is Loops.KEEP and self.scopes.depends_on(motion) is not None:
            return False
        compact = motion.written.statement in self.scopes.compact
        return not (index in self.single and self.needs_a_line(motion) and compact)

    def _acts(self, move: Move) -> bool:
        """Whether computing a target changes data that outlive it."""
        span = move.written.target
        assert span is not None
        names = {node.name.lower() for node in _calls(parse_expression(self._text(span), span.file))}
        routines = [one for name in names for one in self.scopes.procedures.get(name, ())]
        return any(
            change.key[0] != (change.place.path, routine.start) and not change.given
            for one in routines
            for routine in self._reached(one)
            for change in self._changes_of_routine(routine)
        )

    def needs_a_line(self, motion: Motion) -> bool:
        """Whether a move may be skipped or switched, which takes a line of its own, and one answer for all its runs."""
        return (isinstance(motion, PoseMove) and not confdata_counts(motion)) or may_go(motion, self.plant)

    def _literals(self) -> set[int]:
        """The moves that have a literal, and room for what may become of them."""
        return {
            i
            for i, motion in enumerate(self.program.motions)
            if isinstance(motion, Move)
            and motion.written.aggregate is not None
            and not (self.needs_a_line(motion) and motion.written.statement in self.scopes.compact)
        }

    # ----------------------------------------------------------------------------------------------------- loops kept

    def _loops_kept(self) -> Changes:
        groups = [group for group in self._passes() if not self._moves_others(group, self.own)]
        alone = (self._literals() | self.own) - self.bound
        inside = {i for group in groups for i in group}
        dwells = self._places_to_dwell(self.own)
        waits = self._resting(dwells, groups)
        free = frozenset(alone | inside | (dwells & self.single) | {i for group in waits for i in group})
        ties = tuple(group for group in (*groups, *waits) if len(group) > 1)
        going = droppable(self.program, self.plant) & free
        statements = [motion.written.statement for motion in self.program.motions]
        staying = {span for i, span in enumerate(statements) if i not in going}
        staying |= {span for span in self.scopes.compact if self.runs[span] > 1}
        gone = frozenset(i for i in going if statements[i] not in staying)
        return Changes(free, ties, gone, tuple(self._kept(free)), *self._detours(free))

    def _passes(self) -> Iterator[Passes]:
        """The moves that can refer to no other target, in groups that one text serves: one literal, or one target
        declared for a computed one."""
        found: dict[Span, list[int]] = {}
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, Move) and i in self.bound:
                span = motion.written.aggregate or (motion.written.statement if i in self.own else None)
                if span is not None:
                    found.setdefault(span, []).append(i)
        behind = _moves_behind(self.program)
        for group in found.values():
            moves = [self.program.motions[i] for i in group]
            if (
                _one_place(self.program, group)
                and not any(isinstance(behind[i], MoveExtJ) for i in group)
                and all(not isinstance(move, PoseMove) or confdata_counts(move) for move in moves)
            ):
                yield tuple(group)

    def _moves_others(self, group: Passes, own: Set[int]) -> bool:
        """Whether what stays as programmed is computed from the literal that serves these moves."""
        first = self.program.motions[group[0]]
        assert isinstance(first, Move)
        if first.written.aggregate is None:
            return False
        data = self.literal_data(first)
        found = any(trace.keys.keys() & {ROBOT} or (data and trace.reads(*data)) for trace in self._staying(own))
        if found:
            self._moving |= set(group)
        return found

    @cached_property
    def pinned(self) -> frozenset[Span]:
        """Literals in declarations that what stays is computed from."""
        staying = self._staying(self.own)
        out = set()
        for motion in self.program.motions:
            if isinstance(motion, Move) and motion.written.declaration is not None and motion.written.aggregate:
                if motion.written.aggregate in out:
                    continue
                data = self.literal_data(motion)
                if data is not None and any(trace.reads(*data) for trace in staying):
                    out.add(motion.written.aggregate)
        return frozenset(out)

    def _staying(self, own: Set[int]) -> list[Trace]:
        """Of the computed targets that stay what they depend on."""
        covered = _inside(self.flat)
        out: dict[int, Trace] = {}
        for one in self.statements.values():
            for i, literal in zip(one.runs, one.literals, strict=True):
                motion = self.program.motions[i]
                if literal is None and i not in own and i not in covered and isinstance(motion, Move):
                    trace = self.trace(motion, True)
                    out[id(trace)] = trace
        return [*out.values(), *self._beside_targets]

    @cached_property
    def _beside_targets(self) -> Sequence[Trace]:
        """What conditions, signals and offsets depend on, where any of them may look at external axes."""
        if not any(_LOOKS_AT_AXES.search(file.text) for file in self.program.files.values()):
            return ()
        out = [
            self.flow.trace(branch.conditions, Place(path, branch.start, routine), True)
            for path, routine, branch in self.flow.branches
        ]
        for key, node in self.flow.nodes.items():
            offset = isinstance(node, ProcedureCall) and node.name.lower() == "eoffson"
            if isinstance(node, ProcedureCall) and (offset or not isinstance(self._motion_at.get(key), Move | None)):
                values = [one.value for one in node.args if one.value is not None]
                trace = self.flow.trace(values, self.flow.places[key], True)
                if offset and not any((one.name or "").lower() == "exep" for one in node.args):
                    trace.keys[ROBOT] = None
                out.append(trace)
        return out

    def _resting(self, dwells: Set[int], groups: Collection[Passes]) -> list[Passes]:
        """The waits that run several times in whose place one line can stand: all of them follow the same passes.

        dwells: the waits that a line can stand in for.
        """
        group_of = {i: number for number, group in enumerate(groups) for i in group}
        found: dict[Span, list[tuple[int, int | None]]] = {}
        before: int | None = None
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, Move):
                before = group_of.get(i)
            elif isinstance(motion, Wait) and i not in self.single:
                found.setdefault(motion.written.statement, []).append((i, before if i in dwells else None))
        return [
            tuple(i for i, _ in waits)
            for waits in found.values()
            if waits[0][1] is not None and len({number for _, number in waits}) == 1
        ]

    # ---------------------------------------------------------------------------------------------------- written out

    def _unrolled(self) -> Changes:
        inside = _inside(self.flat)
        out = {i for i in inside if isinstance(one := self.program.motions[i], Move) or _stands_alone(one)}
        out |= self._places_to_dwell(self.own | inside) & self.single
        out |= (self._literals() | self.own) & self.single
        shared = _shared_literals(self.program)
        staying = self._staying(self.own)
        for i, motion in enumerate(self.program.motions):
            literal = isinstance(motion, Move) and motion.written.aggregate is not None
            if literal and i not in self.single | inside and motion.written.statement not in shared:
                assert isinstance(motion, Move)
                data = self.literal_data(motion)
                moves = any(ROBOT in trace.keys or (data and trace.reads(*data)) for trace in staying)
                if not self.needs_a_line(motion) and not moves:  # edited in place
                    out.add(i)
        free = frozenset(out)
        gone = droppable(self.program, self.plant) & free
        return Changes(free, (), gone, tuple(self._kept(free)), *self._detours(free, inside))

    @cached_property
    def _known_runs(self) -> Mapping[Span, SingleRun]:
        """The innermost statements that ran once around motions whose own statement ran several times."""
        motions = self.program.motions
        wanted = {
            motion.written.once
            for i, motion in enumerate(motions)
            if i not in self.single and motion.written.once is not None
        } - self.scopes.compact
        ends: dict[Span, tuple[int, int]] = {}
        for i, motion in enumerate(motions):
            if (once := motion.written.once) in wanted and once is not None:
                ends[once] = (ends.get(once, (i, i))[0], i + 1)
        out = {}
        for span, (first, last) in ends.items():
            region = self._region(span)
            while first > 0 and self._ran_in(motions[first - 1], span, region):
                first -= 1
            while last < len(motions) and self._ran_in(motions[last], span, region):
                last += 1
            out[span] = SingleRun(span, first, last)
        return out

    def _ran_in(self, motion: Motion, span: Span, region: Set[int]) -> bool:
        at = motion.written.once
        if at is None or (at.file == span.file and span.start <= at.start < span.end):
            return at is not None
        routine = self.scopes.routine(at.file, at.start)
        return routine is not None and id(routine) in region

    def around(self, index: int) -> SingleRun | None:
        """The innermost statement around a motion that ran once and may be written out, None where there is none."""
        once = self.program.motions[index].written.once
        return None if once is None or once in self._rejected else self._known_runs.get(once)

    @cached_property
    def _rejected(self) -> Mapping[Span, str | None]:
        """The statements that ran once and may not be written out, and what of the scenario they hang on."""
        out: dict[Span, str | None] = {}
        for span in self._known_runs:
            statements = list(self._statements_in(span))
            labels: set[str] = set()
            for place, node in statements:
                if (span.file, node.start) == (place.path, place.start) and node.start == span.start:
                    labels |= self._labels_around(place)
                labels |= self._labels_of(node, place)
            for _, branch, place in self._branches_in(span):
                labels |= self.flow.trace(branch.conditions, place).labels
            if self._leaves(span, statements):
                out[span] = None
            elif labels:
                out[span] = self.flow.first(labels)
        return out

    def _labels_around(self, place: Place) -> set[str]:
        """What the number of times that a statement runs hangs on."""
        labels: set[str] = set()
        for at, branch in self.flow.loops(place):
            labels |= self.flow.trace(branch.conditions, at).labels
        if self.flow.in_endless(place) and "endless_passes" in self.flow.order:
            labels.add("endless_passes")
        return labels

    def _labels_of(self, node: Node, place: Place) -> set[str]:
        """What of the scenario a motion hangs on; that a wait ends with its signal is no such thing."""
        motion = self._motion_at.get((place.path, node.start))
        if motion is None or not isinstance(node, ProcedureCall):
            return set()
        args = node.args if isinstance(motion, Move) else node.args[-1:]
        waits = isinstance(motion, Wait) and motion.condition is not None
        return set() if waits else self.flow.trace([one.value for one in args if one.value is not None], place).labels

    @cached_property
    def _motion_at(self) -> Mapping[tuple[str, int], Motion]:
        """A motion of each statement that makes some, by file and offset."""
        spans = ((motion.written.statement, motion) for motion in self.program.motions)
        return {(span.file, span.start): motion for span, motion in spans}

    def _leaves(self, span: Span, statements: Iterable[tuple[Place, Node]]) -> bool:
        """Whether a statement may end otherwise than at its end."""
        for place, node in statements:
            textual = place.path == span.file and span.start <= node.start < span.end
            if isinstance(node, Simple) or (textual and isinstance(node, Return | Goto)):
                return True
            if any(branch.endless and (branch.start >= span.start or not textual) for branch in place.branches):
                return True
        return False

    def _region(self, span: Span) -> set[int]:
        """Ids of the routines that a statement calls, directly or not."""
        return {id(one) for one in self._reached_from(node for _, node in self._own_statements(span))}

    def _own_statements(self, span: Span) -> Iterator[tuple[Place, Node]]:
        for place, node in self._by_routine.get(id(self.scopes.routine(span.file, span.start)), ()):
            if span.start <= node.start < span.end:
                yield place, node

    def _statements_in(self, span: Span) -> Iterator[tuple[Place, Node]]:
        """The statements in a statement and in the routines that it calls."""
        yield from self._own_statements(span)
        for key in self._region(span):
            yield from self._by_routine.get(key, ())

    @cached_property
    def _by_routine(self) -> Mapping[int, Sequence[tuple[Place, Node]]]:
        out: dict[int, list[tuple[Place, Node]]] = defaultdict(list)
        for key, place in self.flow.places.items():
            out[id(place.routine)].append((place, self.flow.nodes[key]))
        return out

    def _branches_in(self, span: Span) -> Iterator[tuple[Routine, Branch, Place]]:
        """The branches in a statement and in the routines that it calls on which motions depend."""
        region, around = self._region(span), self._place(span).branches
        for path, routine, branch in self.flow.branches:
            textual = path == span.file and span.start <= branch.start < span.end and branch not in around
            if (textual or id(routine) in region) and branch in self._moving_branches:
                yield routine, branch, Place(path, branch.start, routine)

    @cached_property
    def _moving_branches(self) -> frozenset[Branch]:
        """The branches around motions, calls that make some, and statements that leave something."""
        out: set[Branch] = set()
        for key, place in self.flow.places.items():
            node = self.flow.nodes[key]
            if key in self._motion_at or isinstance(node, Return | Goto | Simple) or self._moves(node):
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

    def _reached(self, routine: Routine) -> list[Routine]:
        return [routine, *self._reached_from(node for _, node in self._by_routine.get(id(routine), ()))]

    def _reached_from(self, statements: Iterable[Node]) -> list[Routine]:
        seen: dict[int, Routine] = {}
        stack = list(statements)
        while stack:
            for name in called_names(stack.pop()):
                every = self.scopes.procedures.values() if name is None else [self.scopes.procedures.get(name, [])]
                for routine in (one for several in every for one in several):
                    if id(routine) not in seen:
                        seen[id(routine)] = routine
                        stack += [node for _, node in self._by_routine.get(id(routine), ())]
        return list(seen.values())

    def _changes_of_routine(self, routine: Routine) -> Iterator[Change]:
        for several in self.flow.changes.values():
            yield from (one for one in several if one.place.routine is routine)

    def _writable_runs(self) -> tuple[SingleRun, ...]:
        """The statements that may be written out motion by motion so that all else stays as it is."""
        several = (i for i in range(len(self.program.motions)) if i not in self.single)
        runs = outermost(run for i in several if (run := self.around(i)) is not None)
        bad = [run for run in runs if self._unwritable(run)]
        while bad:
            spans = {
                self.program.motions[i].written.statement
                for run in bad
                for i in range(run.first, run.last)
                if i not in self.single
            }
            runs = [
                run
                for run in runs
                if run not in bad and not any(m.written.statement in spans for m in self._motions_of(run))
            ]
            bad = self._carrying(runs)
        return tuple(runs)

    def _motions_of(self, run: SingleRun) -> Sequence[Motion]:
        return self.program.motions[run.first : run.last]

    def _unwritable(self, run: SingleRun) -> bool:
        """Whether another module cannot say what a statement does, or it leaves settings behind."""
        motions = self._motions_of(run)
        moves = [motion for motion in motions if isinstance(motion, Move)]
        if any(not self.seen_everywhere(motion) for motion in motions):
            return True
        if any(move.settings != moves[0].settings for move in moves):
            return True
        reads = {motion.written.statement: motion for motion in motions}.values()
        if any(self._outlives(change, run) for motion in reads for change in self._changes_beside_target(motion)):
            return True  # where it is written out, its frames, speeds and zones are those of its beginning
        names = {node.name for _, node in self._statements_in(run.span) if isinstance(node, ProcedureCall)}
        if not any(_SETS.match(name) for name in names):
            return False
        around = [self.program.motions[: run.first][::-1], self.program.motions[run.last :]]
        given = [next((one.settings for one in part if isinstance(one, Move)), None) for part in around]
        before, after = given[0] or DEFAULT_SETTINGS, given[1]
        own = moves[0].settings if moves else before
        return own.displaced or own != before or after not in (None, own)

    def seen_everywhere(self, motion: Motion) -> bool:
        """Whether a motion can be said in a module of its own: its names are known there, or what they stand for."""
        span, text = motion.written.statement, self._text(motion.written.statement)
        cut: list[Span] = []
        if isinstance(motion, Move):
            call = read_move(motion, text)
            if isinstance(motion, PoseMove) and motion.X_WO is None:
                return False
            cut = [call.target, *([call.via] if isinstance(motion, MoveC) and call.via is not None else [])]
            if self.scopes.shared(self._text(call.speed), span.file, span.start) is not None:
                if motion.settings.override != 1.0 or motion.settings.v_max is not None or isinstance(motion, MoveExtJ):
                    return False
                cut += [call.speed, *([call.override] if call.override is not None else [])]
        elif isinstance(motion, SignalEvent | Wait):
            valued = isinstance(motion, SignalEvent) or motion.condition is None
            if valued and called(text, span).lower() in ("setdo", "setgo", "setao", "waittime"):
                last = last_argument(motion, text)
                start = span.start + text.rindex(last)
                cut = [Span(span.file, start, start + len(last))]
        for part in sorted(cut, key=lambda one: -one.start):
            text = text[: part.start - span.start] + "0" + text[part.end - span.start :]
        return self.scopes.shared(text, span.file, span.start) is None

    def _changes_beside_target(self, motion: Motion) -> set[Change]:
        """What gives the other arguments of a motion their values, but a speed that is written in numbers."""
        span, place = motion.written.statement, self._place(motion.written.statement)
        node = self.flow.nodes.get((span.file, span.start))
        if not isinstance(node, ProcedureCall) or not isinstance(motion, Move):
            return set()
        call = read_move(motion, self._text(span))
        numbers = {call.target.start, call.via.start if call.via else -1}
        if self.scopes.shared(self._text(call.speed), span.file, span.start) is not None:
            numbers.add(call.speed.start)
        reads = [one.value for one in node.args if one.value is not None and one.value.start not in numbers]
        return self.flow.trace(reads, place).changes

    def _carrying(self, runs: Sequence[SingleRun]) -> list[SingleRun]:
        """The statements that give data a value which motions outside depend on."""
        if not runs:
            return []
        covered = _inside(runs)
        needed: set[Change] = set()
        for span in {m.written.statement for i, m in enumerate(self.program.motions) if i not in covered}:
            node, place = self.flow.nodes.get((span.file, span.start)), self._place(span)
            said = span in self.statements and all(self._can_be_said(i) for i in self.statements[span].runs)
            if isinstance(node, ProcedureCall):
                target = self.statements[span].target if said else None
                values = (one.value for one in node.args if one.value is not None)
                reads = tuple(one for one in values if self._text(Span(span.file, one.start, one.end)) != target)
                needed |= {one for one in self.flow.trace(reads, place).changes if not self._fresh(one, place)}
        for path, routine, branch in self.flow.branches:
            inside = any(run.span.file == path and run.span.start <= branch.start < run.span.end for run in runs)
            if branch in self._moving_branches and not inside:
                place = Place(path, branch.start, routine)
                needed |= {
                    one for one in self.flow.trace(branch.conditions, place).changes if not self._fresh(one, place)
                }
        return [run for run in runs if any(self._outlives(change, run) for change in needed)]

    def _fresh(self, change: Change, reader: Place) -> bool:
        """Whether a change gives data its value anew, whatever was there, before a reader runs."""
        if change.given or change.place.routine is None:
            return True
        return self.flow.precedes(change.place, reader) and len(change.reads) < 2

    def _outlives(self, change: Change, run: SingleRun) -> bool:
        """Whether a statement makes a change that is seen when it has ended."""
        place, span, routine = change.place, run.span, change.place.routine
        textual = place.path == span.file and span.start <= place.start < span.end
        if change.given or routine is None or not (textual or id(routine) in self._region(span)):
            return False
        if change.within is not None and textual:
            return False
        return textual or change.key[0] != (place.path, routine.start)

    # ---------------------------------------------------------------------------------------------------------- waits

    def _places_to_dwell(self, known: Set[int]) -> set[int]:
        """Waits in whose place a line to where the tool is could stand. known: computed targets that can be written."""
        behind = _moves_behind(self.program)
        out, before = set(), -1
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, Move):
                before = i
            elif isinstance(motion, Wait) and _stands_alone(motion) and before >= 0:
                compact = motion.condition is not None and motion.written.statement in self.scopes.compact
                if not compact and self._fits_behind(motion, before, behind[i], known):
                    out.add(i)
        return out

    def _fits_behind(self, wait: Wait, before: int, behind: Move | None, known: Set[int]) -> bool:
        move = self.program.motions[before]
        assert isinstance(move, Move)
        if behind is not None and behind.settings != move.settings:
            return False  # they change somewhere between, and the line would be read under others
        if isinstance(move, MoveAbsJ | MoveExtJ) and move.settings.displaced:
            return False
        if isinstance(move, PoseMove) and move.written.aggregate is None and before not in known:
            return False
        at, to = move.written.statement, wait.written.statement
        call = read_move(move, self._text(at))
        here, there = (at.file, at.start), (to.file, to.start)
        words = (call.speed, call.tool, call.wobj)
        return all(self.scopes.same(self._text(word), here, there) for word in words if word is not None)

    # ---------------------------------------------------------------------------------------------------- added points

    def _detours(self, free: Set[int], alone: Set[int] = frozenset()) -> tuple[tuple[Passes, ...], dict[int, str]]:
        """The joint moves before which the text can have points, in groups that must have the same, and why others
        cannot. alone: those that can be written out, each for itself."""
        straight: dict[int, str] = {}
        passes: dict[Span, list[int]] = defaultdict(list)
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, MoveJ | MoveAbsJ):
                why = why_straight(motion) or self._why_no_point(motion, i in free)
                straight |= {} if why is None else {i: why}
                passes[motion.written.statement].append(i)
        groups: list[Passes] = []
        for indices in passes.values():
            together = tuple(i for i in indices if i not in alone)
            refused = next((straight[i] for i in together if i in straight), None)
            if refused is None and not _one_frame(self.program, together):
                refused = "its tool, work object or settings are not the same in all passes"
            if refused is not None:
                straight |= {i: straight.get(i, refused) for i in together}
            elif together:
                groups.append(together)
            groups += [(i,) for i in indices if i in alone and i not in straight]
        return tuple(sorted(groups)), dict(sorted(straight.items()))

    def _why_no_point(self, motion: MoveJ | MoveAbsJ, free: bool) -> str | None:
        if motion.written.statement in self.scopes.compact:
            return "it is part of an IF without THEN; IF ... THEN ... ENDIF would free it"
        if self.plant.rail_eax is not None and motion.extax[self.plant.rail_eax] is None and not free:
            return "it leaves the rail where it is (9E9), and its target cannot be changed"
        return None

    # -------------------------------------------------------------------------------------------------------- reasons

    def _kept(self, free: Set[int]) -> Iterator[str]:
        """What users should know of the moves that are no free ones: where they are, why, what would free them.

        Moves of joints have nothing to change where there is no rail.
        """
        places: dict[tuple[str, str], dict[str, dict[int, None]]] = {}
        for i, motion in enumerate(self.program.motions):
            bound = isinstance(motion, MoveAbsJ | MoveExtJ) and self.plant.rail_eax is None
            if not isinstance(motion, Move) or i in free or bound:
                continue
            lines = places.setdefault(self._why_kept(i, motion), {}).setdefault(motion.source.file, {})
            lines[motion.source.line] = None
        for (why, remedy), files in places.items():
            yield f"{KEPT}: {_shown(files)} ({why}); {remedy}"

    def _why_kept(self, index: int, move: Move) -> tuple[str, str]:
        """Why a move stays as programmed, and what would free it."""
        span = move.written.statement
        thing, runs = self.scenario_of(index), self.runs[span]
        if self.loops is Loops.KEEP and (thing is None or not self.depends_on_scenario(index)):
            computed = move.written.aggregate is None
            if computed and (variable := self.scopes.depends_on(move)) is not None:
                remedy = "a declared target would free them, or --loops unroll, which writes this run's values out"
                return f"depend on {variable}", remedy
            if index in self._moving:
                remedy = "declared targets of their own would free them, or --loops unroll"
                return "cannot be edited without moving others", remedy
            if runs > 1:
                remedy = "one statement per pass would free them, or --loops unroll"
                return f"run {runs} times with different values", remedy
        often = f"run {runs} times" if runs > 1 else ""
        if thing == "endless_passes" or (runs > 1 and thing is None):
            why = f"{often} with different values" if often else "depend on endless_passes"
            return why, "one statement per pass would free them, for an endless loop endless_passes: 1"
        if thing is not None:
            both = " and ".join(part for part in (often, f"depend on {thing}") if part)
            return both, "one statement with a declared target per pass would free them"
        if span in self.scopes.compact:
            return "are part of an IF without THEN", "IF ... THEN ... ENDIF would free them"
        return "cannot be edited without moving others", "declared targets of their own would free them"


def outermost(runs: Iterable[SingleRun]) -> list[SingleRun]:
    """Statements that lie in no other one, in the order they run."""
    out: list[SingleRun] = []
    for run in sorted(set(runs), key=lambda one: (one.first, -one.last, one.span.start, -one.span.end)):
        if not out or run.first >= out[-1].last:
            out.append(run)
    return out


def confdata_counts(move: PoseMove) -> bool:
    r"""Whether the controller looks at a move's confdata (ConfJ, ConfL \On)."""
    return move.settings.conf_j if isinstance(move, MoveJ) else move.settings.conf_l


def declared_name(declaration: str) -> str:
    """The name in a data declaration, without the dimensions of an array."""
    return declaration.split(":=")[0].split("{")[0].split()[-1]


def _inside(runs: Iterable[SingleRun]) -> set[int]:
    return {i for run in runs for i in range(run.first, run.last)}


def _calls(node: Expression) -> Iterator[Call]:
    return (one for one in nodes(node) if isinstance(one, Call))


def _stands_alone(motion: Motion) -> bool:
    """Whether it is a wait, no function in an expression and not beside a move: a line may stand in its place."""
    return isinstance(motion, Wait) and motion.written.target is None and motion.beside is None


def _moves_behind(program: Program) -> Sequence[Move | None]:
    behind: list[Move | None] = []
    following: Move | None = None
    for motion in reversed(program.motions):
        behind.append(following)
        following = motion if isinstance(motion, Move) else following
    return behind[::-1]


def _shared_literals(program: Program) -> set[Span]:
    """Statements that run several times and meet one literal more than once, among themselves or with another such."""
    runs = Counter(motion.written.statement for motion in program.motions)
    several = [
        m for m in program.motions if isinstance(m, Move) and runs[m.written.statement] > 1 and m.written.aggregate
    ]
    met = Counter(motion.written.aggregate for motion in several)
    return {motion.written.statement for motion in several if met[motion.written.aggregate] > 1}


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


def _one_place(program: Program, group: Sequence[int]) -> bool:
    """Whether all passes bring the flange to one place, with the same offset of the external axes."""
    first, *others = (program.motions[i] for i in group)
    assert isinstance(first, Move)
    for motion in others:
        assert isinstance(motion, Move)
        if type(motion) is not type(first) and not (isinstance(motion, PoseMove) and isinstance(first, PoseMove)):
            return False
        if motion.settings.eax_offset != first.settings.eax_offset or motion.extax != first.extax:
            return False
        poses = [one for one in (motion, first) if isinstance(one, PoseMove)]
        if len({one.conf for one in poses}) > 1:
            return False
        if poses and np.abs(_flange(poses[0]) - _flange(poses[-1])).max() > _SAME:
            return False
    return True


def _flange(motion: PoseMove) -> Array:
    return motion.X_WT @ inverse_pose(motion.tool.X_FT)


def _one_frame(program: Program, passes: Passes) -> bool:
    """Whether the passes of one statement see one target in one place."""
    moves = [motion for i in passes if isinstance(motion := program.motions[i], MoveJ | MoveAbsJ)]
    frames = {
        (one.tool.X_FT.tobytes(), one.X_WO.tobytes() if isinstance(one, MoveJ) and one.X_WO is not None else b"")
        for one in moves
    }
    return len(frames) < 2 and all((one.settings, one.speed) == (moves[0].settings, moves[0].speed) for one in moves)


def _shown(files: Mapping[str, Iterable[int]]) -> str:
    """Places by file, a few of them; and how many more."""
    every = [(file, line) for file, lines in files.items() for line in sorted(lines)]
    by_file: dict[str, list[str]] = {}
    for file, line in every[:_PLACES]:
        by_file.setdefault(file, []).append(str(line))
    text = "; ".join(f"{file}:{', '.join(lines)}" for file, lines in by_file.items())
    return f"{text} and {len(every) - _PLACES} more" if len(every) > _PLACES else text
