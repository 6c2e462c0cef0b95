r"""What a plan for the RAPID controller may change of a program's text.

The rail position and configuration of a move are said where its statement stands, around the target's expression, so
it does not matter how that is computed. All executions of a statement share one value, but those that counters of FOR
loops tell apart: they take theirs from an array. With loops unrolled the text is one in which routines that are called
several times have a copy for each call.
"""

from __future__ import annotations

import operator
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveExtJ, MoveJ, PoseMove, Program, Span, Wait
from trajopt_cli.problem.editable import Changes, Loops, droppable, may_go, why_straight
from trajopt_cli.problem.move_call import read_move
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.scopes import Scopes
from trajopt_cli.problem.unrolled import unrolled
from trajopt_cli.rapid.language.syntax import Binary, Call, Expression, Name, Number
from trajopt_cli.scenario import Scenario
from trajopt_cli.units import MM

KEPT = "kept as programmed on the RAPID target"
_PLACES = 5  # that a note names
_SAME = 1e-9  # m and entries of rotations: the same place
_SAME_RAIL = 1e-3  # mm
_MOST = 1000  # elements of an array
_DIMENSIONS = 3  # of a RAPID array
_WHOLE = {"+": operator.add, "-": operator.sub, "*": operator.mul}

Passes = tuple[int, ...]
Key = tuple[Span, tuple[int, ...]]  # a statement, and the elements of an array that its execution takes


@dataclass(frozen=True)
class Counter:
    """A FOR loop whose passes an array can tell apart. at: which of the statement's loops it is. Its passes have the
    values first, first + step and so on, count of them."""

    name: str
    at: int
    first: int
    step: int
    count: int

    def element(self, value: float) -> int:
        """The pass with a value, from 0."""
        return round((value - self.first) / self.step)

    @property
    def index(self) -> str:
        """The pass in RAPID, from 1."""
        if self.step == 1:
            return self.name if self.first == 1 else f"{self.name}{1 - self.first:+d}"
        if self.step == -1:
            return f"{self.first + 1}-{self.name}"
        zero = f"{-self.first:+d}" if self.first else ""
        way = f"{self.name}{zero}" if self.step > 0 else f"{self.first}-{self.name}"
        return f"{way if way == self.name else f'({way})'} DIV {abs(self.step)}+1"


class EditableText:
    """A program's text and what may change of it.

    program: as given, or with loops unrolled; its motions are the same ones. changes: the answer. dwells: of each wait
    that a line can stand in for the move before it.
    """

    def __init__(
        self, program: Program, plant: Plant, scenario: Scenario, loops: Loops = Loops.KEEP,
        routines: Collection[str] | None = None,
    ):  # fmt: skip
        """routines: names in lower case of those of which there are copies where loops are unrolled; None: all."""
        self.plant, self.loops = plant, loops
        self.program = program if loops is Loops.KEEP else unrolled(program, plant, scenario, routines)
        self.scopes = Scopes(self.program.files)
        self._counters: dict[Span, tuple[Counter, ...]] = {}
        self._moves_behind = _moves_behind(self.program)
        self.dwells = dict(self._places_to_dwell())
        self.changes = self._changes()

    def text_of(self, span: Span) -> str:
        """The text between two places of a file."""
        return self.scopes.text(span)

    # --------------------------------------------------------------------------------------------------- the groups

    def counters(self, span: Span) -> tuple[Counter, ...]:
        """The FOR loops around a statement whose passes an array can tell apart, the outermost first."""
        if span not in self._counters:
            place = self.scopes.place(span)
            loops = () if place is None else place.loops
            names = [loop.name.lower() for loop in loops]
            found: list[Counter] = []
            size = 1
            for at in reversed(range(len(loops))):
                written = loops[at].first, loops[at].last, loops[at].step
                bounds = [self._constant(one, span.file, span.start) for one in written]
                hidden = names[at] in names[at + 1 :]
                if hidden or None in bounds[:2] or (loops[at].step is not None and bounds[2] is None):
                    continue
                first, last = bounds[0] or 0, bounds[1] or 0
                step = bounds[2] or (1 if first <= last else -1)
                count = (last - first) // step + 1
                size *= max(count, 1)
                if count > 0 and size <= _MOST and len(found) < _DIMENSIONS:
                    found.append(Counter(loops[at].name, at, first, step, count))
            self._counters[span] = tuple(reversed(found))
        return self._counters[span]

    def _constant(self, node: Expression | None, path: str, offset: int) -> int | None:
        """A whole number that an expression at a place is in every run; None for none."""
        if isinstance(node, Name):
            data = self.scopes.declared(node.name, path, offset)
            known = data is not None and data[1].storage == "CONST"
            return self._constant(data[1].value, data[0], data[1].start) if data is not None and known else None
        if isinstance(node, Binary) and node.operator in _WHOLE:
            sides = self._constant(node.left, path, offset), self._constant(node.right, path, offset)
            return None if sides[0] is None or sides[1] is None else _WHOLE[node.operator](sides[0], sides[1])
        if isinstance(node, Call) and node.name.lower() == "dim" and "dim" not in self.scopes.procedures:
            array, number = [one.value for one in node.args]
            data = self.scopes.declared(array.name, path, offset) if isinstance(array, Name) else None
            at = self._constant(number, path, offset)
            sizes = () if data is None or at is None else data[1].sizes[at - 1 : at]
            return self._constant(sizes[0], path, offset) if sizes else None
        return int(node.value) if isinstance(node, Number) and node.value == int(node.value) else None

    def key(self, index: int) -> Key:
        """What tells the executions of a motion's statement apart."""
        written = self.program.motions[index].written
        counters = self.counters(written.statement)
        return written.statement, tuple(one.element(written.counters[one.at]) for one in counters)

    @cached_property
    def statements(self) -> Mapping[Span, Passes]:
        """The motions of each statement, in order."""
        found: dict[Span, list[int]] = defaultdict(list)
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, Move | Wait):
                found[motion.written.statement].append(i)
        return {span: tuple(indices) for span, indices in found.items()}

    @cached_property
    def groups(self) -> Mapping[Key, Passes]:
        """The motions that share one value, in order."""
        found: dict[Key, list[int]] = defaultdict(list)
        for indices in self.statements.values():
            for i in indices:
                found[self.key(i)].append(i)
        return {key: tuple(indices) for key, indices in found.items()}

    # -------------------------------------------------------------------------------------------------- the changes

    def _changes(self) -> Changes:
        free, ties, kept = set[int](), list[Passes](), list[tuple[Passes, tuple[str, str]]]()
        for (span, _), group in self.groups.items():
            if isinstance(self.program.motions[group[0]], Wait):
                places = {self.before(i) for i in self.statements[span]}
                moves = [self.program.motions[self.dwells[i]] for i in group if i in self.dwells]
                added = {move.settings.eax_offset for move in moves if isinstance(move, Move)}
                if len(places) == 1 and None not in places and len(added) == 1:
                    free |= set(group)
                    ties.append(group)
            elif (why := self._why_kept(span, group)) is None:
                free |= set(group)
                ties.append(group)
            else:
                kept.append((group, why))
        going = droppable(self.program, self.plant) & free
        gone = {
            i
            for span, indices in self.statements.items()
            if set(indices) <= going and not (self._compact(span) and len(indices) > 1)
            for i in indices
        }
        return Changes(
            frozenset(free),
            tuple(sorted(group for group in ties if len(group) > 1)),
            frozenset(gone),
            tuple(self._kept(kept)),
            *self._detours(free),
        )

    def _why_kept(self, span: Span, group: Passes) -> tuple[str, str] | None:
        """Why moves that share one value stay as programmed, and what would free them; None where they need not."""
        moves = [move for i in group if isinstance(move := self.program.motions[i], Move)]
        if self._compact(span) and any(self._needs_a_line(move) for move in moves):
            return "are part of an IF without THEN", "IF ... THEN ... ENDIF would free them"
        if moves[0].written.target is None:
            return "are written without a target", "a move with a target would free them"
        alike = len(group) == 1 or self._alike(group)
        if alike and not (len(group) > 1 and any(isinstance(self._moves_behind[i], MoveExtJ) for i in group)):
            return None
        remedy = "one statement for each would free them"
        if self.loops is Loops.KEEP:
            remedy += ", or --loops unroll where routines are called several times"
        return f"run {len(group)} times with different rail values or configurations", remedy

    def _alike(self, group: Passes) -> bool:
        """Whether one rail position and configuration may serve all executions, as it does in the program."""
        first, *others = [move for i in group if isinstance(move := self.program.motions[i], Move)]
        rails = [self._written_rails[i] for i in group]
        if np.ptp(rails, axis=0).max(initial=0.0) > _SAME_RAIL:
            return False
        one = one_place(self.program, group)
        for move in others:
            if type(move) is not type(first) or move.settings.eax_offset != first.settings.eax_offset:
                return False
            if isinstance(move, PoseMove) and isinstance(first, PoseMove) and not one and move.conf != first.conf:
                return False
        return True

    @cached_property
    def _written_rails(self) -> Sequence[Array]:
        """Where the rails (r,) are programmed to be at the end of each motion [mm]."""
        plant, out = self.plant, list[Array]()
        now = plant.start[plant.layout.rail]
        for motion in self.program.motions:
            if isinstance(motion, Move):
                now = plant.rail_after(motion.extax, now)
            out.append(now / MM)
        return out

    def _compact(self, span: Span) -> bool:
        place = self.scopes.place(span)
        return place is not None and place.compact

    def _needs_a_line(self, motion: Motion) -> bool:
        """Whether a move may be skipped or switched, which takes a line of its own, and one answer for all its runs."""
        return (isinstance(motion, PoseMove) and not confdata_counts(motion)) or may_go(motion, self.plant)

    # ---------------------------------------------------------------------------------------------------------- waits

    def _places_to_dwell(self) -> Iterator[tuple[int, int]]:
        """Waits in whose place a line to where the tool is could stand, and the move before each. Behind a fly-by axes
        settle for \\InPos alone, which no line says."""
        before = settled = -1
        for i, motion in enumerate(self.program.motions):
            if isinstance(motion, Move):
                before = i
            elif isinstance(motion, Wait) and motion.settles:
                settled = i
            elif isinstance(motion, Wait) and _stands_alone(motion) and before >= 0:
                move, own = self.program.motions[before], motion.written.statement
                assert isinstance(move, Move)
                compact = motion.condition is not None and self._compact(own)
                stands = move.zone.stop or (isinstance(move, PoseMove) and settled < before)
                stands = stands and not isinstance(move, MoveExtJ)
                if not compact and stands and self._fits_behind(own, move, self._moves_behind[i]):
                    yield i, before

    def before(self, wait: int) -> Span | None:
        """The statement of the move whose place a line in a wait's place says again."""
        move = self.dwells.get(wait)
        return None if move is None else self.program.motions[move].written.statement

    def _fits_behind(self, wait: Span, move: Move, behind: Move | None) -> bool:
        if move.written.target is None or (behind is not None and behind.settings != move.settings):
            return False  # they change somewhere between, and the line would be read under others
        at = move.written.statement
        call = read_move(move, self.text_of(at))
        if not self.scopes.same(self.text_of(call.speed), at, wait):
            return False
        words = (call.target if isinstance(move, PoseMove) else None, call.tool, call.wobj)
        return all(self.scopes.repeats(self.text_of(word), at, wait) for word in words if word is not None)

    # -------------------------------------------------------------------------------------------------------- detours

    def _detours(self, free: Set[int]) -> tuple[tuple[Passes, ...], dict[int, str]]:
        """The joint moves before which the text can have points, in groups that must have the same, and why others
        cannot."""
        straight: dict[int, str] = {}
        groups: list[Passes] = []
        for indices in self.statements.values():
            moves = {i: one for i in indices if isinstance(one := self.program.motions[i], MoveJ | MoveAbsJ)}
            whys = {i: why_straight(one) or self._why_no_point(one, i in free) for i, one in moves.items()}
            refused = next((why for why in whys.values() if why is not None), None)
            if refused is None and not _one_frame(self.program, tuple(moves)):
                refused = "its tool, work object or settings are not the same in all passes"
            if refused is not None:
                straight |= {i: why or refused for i, why in whys.items()}
            elif moves:
                groups.append(tuple(moves))
        return tuple(sorted(groups)), dict(sorted(straight.items()))

    def _why_no_point(self, motion: MoveJ | MoveAbsJ, free: bool) -> str | None:
        if self._compact(motion.written.statement):
            return "it is part of an IF without THEN; IF ... THEN ... ENDIF would free it"
        if any(motion.extax[eax] is None for eax in self.plant.rail_eaxes) and not free:
            return "it leaves the rail where it is (9E9), and its target cannot be changed"
        return None

    # ---------------------------------------------------------------------------------------------------------- notes

    def _kept(self, kept: Iterable[tuple[Passes, tuple[str, str]]]) -> Iterator[str]:
        """What users should know of the moves that are no free ones: where they are, why, what would free them.

        Moves of joints have nothing to change where there is no rail.
        """
        places: dict[tuple[str, str], dict[str, dict[int, None]]] = {}
        for group, told in kept:
            for motion in [self.program.motions[i] for i in group]:
                if not (isinstance(motion, MoveAbsJ | MoveExtJ) and not self.plant.rail_eaxes):
                    lines = places.setdefault(told, {}).setdefault(motion.source.file, {})
                    lines[motion.source.line] = None
        for (why, remedy), files in places.items():
            yield f"{KEPT}: {_shown(files)} ({why}); {remedy}"


def confdata_counts(move: PoseMove) -> bool:
    r"""Whether the controller looks at a move's confdata (ConfJ, ConfL \On)."""
    return move.settings.conf_j if isinstance(move, MoveJ) else move.settings.conf_l


def one_place(program: Program, group: Sequence[int]) -> bool:
    """Whether all executions bring the flange to one place."""
    poses = [one for i in group if isinstance(one := program.motions[i], PoseMove)]
    return all(np.abs(_flange(one) - _flange(poses[0])).max() <= _SAME for one in poses[1:])


def _flange(motion: PoseMove) -> Array:
    return motion.X_WT @ inverse_pose(motion.tool.X_FT)


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
