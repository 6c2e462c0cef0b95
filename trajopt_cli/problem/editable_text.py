"""What a plan for the RAPID controller may change of a program's text, answered from its syntax tree.

A target serves the moves that its literal or its expression names; what else depends on it stays as programmed. The
order of the questions: which moves have a literal, which computed targets a number can stand in for, which passes of
loops and routines one text serves, and which statements can be written out motion by motion.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import (
    Motion,
    Move,
    MoveAbsJ,
    MoveExtJ,
    MoveJ,
    PoseMove,
    Program,
    Span,
    Wait,
)
from trajopt_cli.problem.data_flow import ROBOT, Place, Trace
from trajopt_cli.problem.editable import Changes, Loops, droppable, may_go, why_straight
from trajopt_cli.problem.move_call import read_move
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.program_text import Passes, ProgramText
from trajopt_cli.problem.single_runs import SingleRuns, inside
from trajopt_cli.rapid.language.syntax import (
    ProcedureCall,
)
from trajopt_cli.scenario import Scenario

KEPT = "kept as programmed on the RAPID target"
_PLACES = 5  # that a note names
_SAME = 1e-9  # m and entries of rotations: the same place
_LOOKS_AT_AXES = re.compile(r"\b(extax|robconf|robax|eoffson)\b", re.IGNORECASE)


class EditableText(ProgramText):
    """A program's text and what may change of it.

    changes: the answer. own: moves whose computed target a new one may stand in for. pinned: literals that must stay,
    as what stays is computed from them. flat: statements that may be written out motion by motion.
    """

    def __init__(self, program: Program, plant: Plant, scenario: Scenario, loops: Loops = Loops.KEEP):
        super().__init__(program, scenario)
        self.plant, self.loops = plant, loops
        self._moving: set[int] = set()  # that cannot change as others are computed from it
        self._single_runs = SingleRuns(self)
        self.flat = self._single_runs.writable(self._can_be_said) if loops is Loops.UNROLL else ()
        covered = inside(self.flat)
        self.own = frozenset(i for i in range(len(program.motions)) if i not in covered and self._can_be_said(i))
        self.changes = self._unrolled() if loops is Loops.UNROLL else self._loops_kept()

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

    def scenario_of(self, index: int) -> str | None:
        """What of the scenario the target of a move hangs on, or the statement around it that runs once."""
        motion = self.program.motions[index]
        label = None
        if isinstance(motion, Move) and index in self.constants:
            label = self.flow.first(self.trace(motion).labels)
        once = motion.written.once
        return label or (self._single_runs.rejected.get(once) if once is not None else None)

    def _can_be_said(self, index: int) -> bool:
        """Whether a new target in numbers may stand in for a computed one."""
        motion = self.program.motions[index]
        if not isinstance(motion, Move) or motion.written.aggregate is not None or motion.written.target is None:
            return False
        if isinstance(motion, PoseMove) and motion.X_WO is None:
            return False
        if index not in self.constants or self.depends_on_scenario(index) or self.acts(motion):
            return False
        if index not in self.single and self.loops is Loops.UNROLL:
            return False
        if self.loops is Loops.KEEP and self.scopes.depends_on(motion) is not None:
            return False
        compact = motion.written.statement in self.scopes.compact
        return not (index in self.single and self.needs_a_line(motion) and compact)

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
        covered = inside(self.flat)
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
            if isinstance(node, ProcedureCall) and (offset or not isinstance(self.motion_at.get(key), Move | None)):
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

    def _unrolled(self) -> Changes:
        covered = inside(self.flat)
        out = {i for i in covered if isinstance(one := self.program.motions[i], Move) or _stands_alone(one)}
        out |= self._places_to_dwell(self.own | covered) & self.single
        out |= (self._literals() | self.own) & self.single
        shared = _shared_literals(self.program)
        staying = self._staying(self.own)
        for i, motion in enumerate(self.program.motions):
            literal = isinstance(motion, Move) and motion.written.aggregate is not None
            if literal and i not in self.single | covered and motion.written.statement not in shared:
                assert isinstance(motion, Move)
                data = self.literal_data(motion)
                moves = any(ROBOT in trace.keys or (data and trace.reads(*data)) for trace in staying)
                if not self.needs_a_line(motion) and not moves:  # edited in place
                    out.add(i)
        free = frozenset(out)
        gone = droppable(self.program, self.plant) & free
        return Changes(free, (), gone, tuple(self._kept(free)), *self._detours(free, covered))

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
        call = read_move(move, self.text_of(at))
        here, there = (at.file, at.start), (to.file, to.start)
        words = (call.speed, call.tool, call.wobj)
        return all(self.scopes.same(self.text_of(word), here, there) for word in words if word is not None)

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
            why = f"{often} with different values" if often else "change from pass to pass"
            return why, "one statement per pass would free them"
        if thing is not None:
            both = " and ".join(part for part in (often, f"depend on {thing}") if part)
            return both, "one statement with a declared target per pass would free them"
        if span in self.scopes.compact:
            return "are part of an IF without THEN", "IF ... THEN ... ENDIF would free them"
        return "cannot be edited without moving others", "declared targets of their own would free them"


def confdata_counts(move: PoseMove) -> bool:
    r"""Whether the controller looks at a move's confdata (ConfJ, ConfL \On)."""
    return move.settings.conf_j if isinstance(move, MoveJ) else move.settings.conf_l


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
