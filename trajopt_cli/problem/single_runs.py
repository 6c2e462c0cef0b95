"""Statements that ran exactly once, and which of them may be written out motion by motion (--loops unroll)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property

from trajopt_cli.motion import (
    DEFAULT_SETTINGS,
    Motion,
    Move,
    MoveC,
    MoveExtJ,
    PoseMove,
    SignalEvent,
    Span,
    Wait,
)
from trajopt_cli.problem.data_flow import Branch, Change, Place
from trajopt_cli.problem.move_call import called, last_argument, read_move
from trajopt_cli.problem.program_text import ProgramText
from trajopt_cli.rapid.language.syntax import (
    Expression,
    Goto,
    Node,
    ProcedureCall,
    Return,
    Routine,
    Simple,
)

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


class SingleRuns:
    """The innermost statements that ran once around motions whose own statement ran several times."""

    def __init__(self, text: ProgramText):
        self._text = text

    @cached_property
    def _known_runs(self) -> Mapping[Span, SingleRun]:
        """The innermost statements that ran once around motions whose own statement ran several times."""
        motions = self._text.program.motions
        wanted = {
            motion.written.once
            for i, motion in enumerate(motions)
            if i not in self._text.single and motion.written.once is not None
        } - self._text.scopes.compact
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
        routine = self._text.scopes.routine(at.file, at.start)
        return routine is not None and id(routine) in region

    def _around(self, index: int) -> SingleRun | None:
        """The innermost statement around a motion that ran once and may be written out, None where there is none."""
        once = self._text.program.motions[index].written.once
        return None if once is None or once in self.rejected else self._known_runs.get(once)

    @cached_property
    def rejected(self) -> Mapping[Span, str | None]:
        """The statements that ran once and may not be written out, and what of the scenario they hang on."""
        out: dict[Span, str | None] = {}
        for span in self._known_runs:
            statements = list(self._statements_in(span))
            labels: set[str] = set()
            for place, node in statements:
                if (span.file, node.start) == (place.path, place.start) and node.start == span.start:
                    labels |= self._labels_around(place)
                labels |= self._text.labels_of(node, place)
            for _, branch, place in self._branches_in(span):
                labels |= self._text.flow.trace(branch.conditions, place).labels
            if self._leaves(span, statements):
                out[span] = None
            elif labels:
                out[span] = self._text.flow.first(labels)
        return out

    def _labels_around(self, place: Place) -> set[str]:
        """What the number of times that a statement runs hangs on."""
        labels: set[str] = set()
        for at, branch in self._text.flow.loops(place):
            labels |= self._text.flow.trace(branch.conditions, at).labels
        if self._text.flow.in_endless(place) and "endless_passes" in self._text.flow.order:
            labels.add("endless_passes")
        return labels

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
        return {id(one) for one in self._text.reached_from(node for _, node in self._own_statements(span))}

    def _own_statements(self, span: Span) -> Iterator[tuple[Place, Node]]:
        for place, node in self._text.by_routine.get(id(self._text.scopes.routine(span.file, span.start)), ()):
            if span.start <= node.start < span.end:
                yield place, node

    def _statements_in(self, span: Span) -> Iterator[tuple[Place, Node]]:
        """The statements in a statement and in the routines that it calls."""
        yield from self._own_statements(span)
        for key in self._region(span):
            yield from self._text.by_routine.get(key, ())

    def _branches_in(self, span: Span) -> Iterator[tuple[Routine, Branch, Place]]:
        """The branches in a statement and in the routines that it calls on which motions depend."""
        region, around = self._region(span), self._text.place(span).branches
        for path, routine, branch in self._text.flow.branches:
            textual = path == span.file and span.start <= branch.start < span.end and branch not in around
            if (textual or id(routine) in region) and branch in self._text.moving_branches:
                yield routine, branch, Place(path, branch.start, routine)

    def writable(self, said: Callable[[int], bool]) -> tuple[SingleRun, ...]:
        """The statements that may be written out motion by motion so that all else stays as it is."""
        several = (i for i in range(len(self._text.program.motions)) if i not in self._text.single)
        runs = outermost(run for i in several if (run := self._around(i)) is not None)
        bad = [run for run in runs if self._unwritable(run)]
        while bad:
            spans = {
                self._text.program.motions[i].written.statement
                for run in bad
                for i in range(run.first, run.last)
                if i not in self._text.single
            }
            runs = [
                run
                for run in runs
                if run not in bad and not any(m.written.statement in spans for m in self._motions_of(run))
            ]
            bad = self._carrying(runs, said)
        return tuple(runs)

    def _motions_of(self, run: SingleRun) -> Sequence[Motion]:
        return self._text.program.motions[run.first : run.last]

    def _unwritable(self, run: SingleRun) -> bool:
        """Whether another module cannot say what a statement does, or it leaves settings behind."""
        motions = self._motions_of(run)
        moves = [motion for motion in motions if isinstance(motion, Move)]
        if any(not self._seen_everywhere(motion) for motion in motions):
            return True
        if any(move.settings != moves[0].settings for move in moves):
            return True
        reads = {motion.written.statement: motion for motion in motions}.values()
        if any(self._outlives(change, run) for motion in reads for change in self._changes_beside_target(motion)):
            return True  # where it is written out, its frames, speeds and zones are those of its beginning
        names = {node.name for _, node in self._statements_in(run.span) if isinstance(node, ProcedureCall)}
        if not any(_SETS.match(name) for name in names):
            return False
        around = [self._text.program.motions[: run.first][::-1], self._text.program.motions[run.last :]]
        given = [next((one.settings for one in part if isinstance(one, Move)), None) for part in around]
        before, after = given[0] or DEFAULT_SETTINGS, given[1]
        own = moves[0].settings if moves else before
        return own.displaced or own != before or after not in (None, own)

    def _seen_everywhere(self, motion: Motion) -> bool:
        """Whether a motion can be said in a module of its own: its names are known there, or what they stand for."""
        span, text = motion.written.statement, self._text.text_of(motion.written.statement)
        cut: list[Span] = []
        if isinstance(motion, Move):
            call = read_move(motion, text)
            if isinstance(motion, PoseMove) and motion.X_WO is None:
                return False
            cut = [call.target, *([call.via] if isinstance(motion, MoveC) and call.via is not None else [])]
            if self._text.scopes.shared(self._text.text_of(call.speed), span.file, span.start) is not None:
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
        return self._text.scopes.shared(text, span.file, span.start) is None

    def _changes_beside_target(self, motion: Motion) -> set[Change]:
        """What gives the other arguments of a motion their values, but a speed that is written in numbers."""
        span, place = motion.written.statement, self._text.place(motion.written.statement)
        node = self._text.flow.nodes.get((span.file, span.start))
        if not isinstance(node, ProcedureCall) or not isinstance(motion, Move):
            return set()
        call = read_move(motion, self._text.text_of(span))
        numbers = {call.target.start, call.via.start if call.via else -1}
        if self._text.scopes.shared(self._text.text_of(call.speed), span.file, span.start) is not None:
            numbers.add(call.speed.start)
        reads = [one.value for one in node.args if one.value is not None and one.value.start not in numbers]
        return self._text.flow.trace(reads, place).changes

    def _carrying(self, runs: Sequence[SingleRun], said: Callable[[int], bool]) -> list[SingleRun]:
        """The statements that give data a value which motions outside depend on."""
        if not runs:
            return []
        text, covered = self._text, inside(runs)
        needed: set[Change] = set()
        for span in {m.written.statement for i, m in enumerate(text.program.motions) if i not in covered}:
            node, known = text.flow.nodes.get((span.file, span.start)), text.statements.get(span)
            if isinstance(node, ProcedureCall):
                target = known.target if known is not None and all(said(i) for i in known.runs) else None
                values = (one.value for one in node.args if one.value is not None)
                reads = tuple(one for one in values if text.text_of(Span(span.file, one.start, one.end)) != target)
                needed |= self._lasting(reads, text.place(span))
        for path, routine, branch in text.flow.branches:
            around = any(run.span.file == path and run.span.start <= branch.start < run.span.end for run in runs)
            if branch in text.moving_branches and not around:
                needed |= self._lasting(branch.conditions, Place(path, branch.start, routine))
        return [run for run in runs if any(self._outlives(change, run) for change in needed)]

    def _lasting(self, reads: Iterable[Expression], reader: Place) -> set[Change]:
        """What expressions depend on, but what gives data their values anew before the reader runs."""
        flow = self._text.flow
        return {
            change
            for change in flow.trace(reads, reader).changes
            if not change.given
            and change.place.routine is not None
            and not (flow.precedes(change.place, reader) and len(change.reads) < 2)
        }

    def _outlives(self, change: Change, run: SingleRun) -> bool:
        """Whether a statement makes a change that is seen when it has ended."""
        place, span, routine = change.place, run.span, change.place.routine
        textual = place.path == span.file and span.start <= place.start < span.end
        if change.given or routine is None or not (textual or id(routine) in self._region(span)):
            return False
        if change.within is not None and textual:
            return False
        return textual or change.key[0] != (place.path, routine.start)


def outermost(runs: Iterable[SingleRun]) -> list[SingleRun]:
    """Statements that lie in no other one, in the order they run."""
    out: list[SingleRun] = []
    for run in sorted(set(runs), key=lambda one: (one.first, -one.last, one.span.start, -one.span.end)):
        if not out or run.first >= out[-1].last:
            out.append(run)
    return out


def inside(runs: Iterable[SingleRun]) -> set[int]:
    """The motions that statements made."""
    return {i for run in runs for i in range(run.first, run.last)}
