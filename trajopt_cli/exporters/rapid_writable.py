"""Which motions of a program can be given other rail positions and configurations, known before anything is planned."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import replace
from functools import cached_property
from typing import cast

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_call import read_move
from trajopt_cli.exporters.rapid_check import first_difference
from trajopt_cli.exporters.rapid_passes import Passes, passes, resting
from trajopt_cli.exporters.rapid_points import text_detours
from trajopt_cli.exporters.rapid_reading import Reading
from trajopt_cli.exporters.rapid_scopes import Scopes, names_in
from trajopt_cli.exporters.rapid_stretches import Stretch, Stretches
from trajopt_cli.exporters.rapid_targets import PoseMove, Targets, confdata_counts, declared_name
from trajopt_cli.exporters.rapid_text import Edits, Names
from trajopt_cli.exporters.rapid_write import Choices, Intent, write
from trajopt_cli.motion import ExternalAxes, Hold, Motion, Move, MoveAbsJ, MoveExtJ, Program, Span, Wait
from trajopt_cli.problem.editable import Changes, Loops, droppable, may_go
from trajopt_cli.problem.plant import Plant

_STEP, _STEPS = 0.01, 997  # mm; how far targets are moved along the rail to see what else moves, and how many ways
KEPT = "kept as programmed on the RAPID target"
_PLACES = 5  # that a note names
_TRIALS = 8  # of a long program each takes as long as reading it


def text_changes(program: Program, plant: Plant, reading: Reading, loops: Loops = Loops.KEEP) -> Changes:
    """What a plan may change so that the program's text can carry it; all else must stay as programmed.

    - A literal target, if its statement runs once or with another literal each time.
    - A computed target whose statement runs once, if it can be said in numbers.
    - A wait that runs once, where a line could stand in its place.
    - KEEP: what runs several times and is served by one text, tied to one answer; but nothing that depends on a
      variable becomes a number.
    - UNROLL: whatever lies in a stretch that can be written flat.
    - A joint move can have points added before it; passes of one statement have the same, but where they can be written
      flat.

    The last word has a trial: computed targets and flat stretches are written with the values of the program itself,
    and what is read back must be the program; then everything is written with other values, in the way that an export
    falls back on, and what is read back must have those. Nothing is written out that hangs on the scenario: what a
    program does with a search, an answer or an input must stay its own.
    """
    text = _Text(program, plant, reading, Scopes(program.files))
    if loops is Loops.UNROLL:
        free = text.unrolled()
        detours, straight = text_detours(program, plant, text.scopes, free, _inside(text.flat))
        gone = droppable(program, plant) & free
        return Changes(free, (), gone, tuple(text.kept(free, loops)), detours, straight)
    free, ties = text.kept_loops()
    detours, straight = text_detours(program, plant, text.scopes, free)
    return Changes(free, ties, text.droppable(free), tuple(text.kept(free, loops)), detours, straight)


def safest(program: Program, plant: Plant, scopes: Scopes, reading: Reading, loops: Loops = Loops.KEEP) -> Choices:
    """How to write what other ways cannot: no declaration is edited where a new one will do, and, if loops may be
    unrolled, all is written out."""
    own, flat = _Text(program, plant, reading, scopes).tried(loops)
    return Choices(frozenset(own), tuple(flat), isolated=True, loops=loops)


class _Text:
    """A program as the export can change it."""

    def __init__(self, program: Program, plant: Plant, reading: Reading, scopes: Scopes):
        self.program, self.plant, self.reading, self.scopes = program, plant, reading, scopes
        self.stretches = Stretches(program, scopes, reading)
        self.runs = Counter(motion.written.statement for motion in program.motions)
        self.flat: list[Stretch] = []  # what unrolled() can write flat
        self.moving: set[int] = set()  # what cannot change as others are computed from it, as far as known
        self.single = {i for i, motion in enumerate(program.motions) if self.runs[motion.written.statement] == 1}

    @cached_property
    def bound(self) -> set[int]:
        """The moves that can refer to no other target: run several times, or to whatever a variable names."""
        return {
            i
            for i, motion in enumerate(self.program.motions)
            if isinstance(motion, Move)
            and (i not in self.single or (motion.written.aggregate and self.scopes.depends_on(motion)))
        }

    # ----------------------------------------------------------------------------------------------------- loops kept

    def kept_loops(self) -> tuple[frozenset[int], tuple[Passes, ...]]:
        """What can carry other values where every loop stays one, and which motions must have the same."""
        own, _ = self.tried(Loops.KEEP)
        groups = passes(self.program, self.bound, own)
        for _ in range(_TRIALS):
            free, ties = self._with(own, groups)
            wrong = self._disturbed(free, Choices(frozenset(own), ()), ties)
            if wrong is None:
                return free, ties
            if not groups:
                break
            groups = self._without_what_moves(wrong, groups)
        return self._free(set(), []) & self.single - self.bound, ()

    def _with(self, own: set[int], groups: list[Passes]) -> tuple[frozenset[int], tuple[Passes, ...]]:
        alone = (self._literals() | own) - self.bound
        inside = {i for group in groups for i in group}
        dwells = _places_to_dwell(self.program, self.scopes, own)
        waits = resting(self.program, dwells, groups)
        free = alone | inside | (dwells & self.single) | {i for group in waits for i in group}
        return frozenset(free), tuple(group for group in (*groups, *waits) if len(group) > 1)

    def _without_what_moves(self, wrong: int, groups: list[Passes]) -> list[Passes]:
        """The groups but those whose literal a motion computes with; but all with a literal where that is none."""
        motion = self.program.motions[wrong] if wrong < len(self.program.motions) else None
        names = {name.lower() for name in names_in(motion.target)} if isinstance(motion, Move) else set()
        literals = [group for group in groups if self.program.motions[group[0]].written.aggregate is not None]
        read = [group for group in literals if not names.isdisjoint(self._called(group))]
        gone = read or literals or groups
        self.moving |= {i for group in gone for i in group}
        return [group for group in groups if group not in gone]

    def _called(self, group: Passes) -> Iterator[str]:
        """What the literal of a group is called where it is declared and where it is moved to, in lower case."""
        declaration = self.program.motions[group[0]].written.declaration
        if declaration is not None:
            text = self.program.files[declaration.file].text[declaration.start : declaration.end]
            yield declared_name(text).lower()
        for motion in (self.program.motions[i] for i in group):
            if isinstance(motion, Move):
                yield motion.target.lower()

    # ---------------------------------------------------------------------------------------------------- written flat

    def unrolled(self) -> frozenset[int]:
        """What can carry values of its own where loops and calls may be written out."""
        own, flat = self.tried(Loops.UNROLL)
        self.flat = flat
        out = self._free(own, flat)
        several = {i for i in out if i not in self.single} - _inside(flat)  # edited in place: others compute with them
        for less, fewer, rest in ((out, own, flat), (out - several, own, flat)):
            if not (less & several or fewer or rest):
                return less  # each target by itself, or a new one that nothing else reads
            if self._disturbed(less, Choices(frozenset(fewer), tuple(rest), loops=Loops.UNROLL)) is None:
                return less
        return self._free(set(), []) - several

    def _free(self, own: set[int], flat: list[Stretch]) -> frozenset[int]:
        """What can carry values of its own. own, flat: computed targets and stretches that can be written out."""
        inside = _inside(flat)
        out = {i for i in inside if isinstance(one := self.program.motions[i], Move) or _stands_alone(one)}
        out |= _places_to_dwell(self.program, self.scopes, own | inside) & self.single
        out |= (self._literals() | own) & self.single
        shared = _shared_literals(self.program)
        for i, motion in enumerate(self.program.motions):
            literal = isinstance(motion, Move) and motion.written.aggregate is not None
            if literal and i not in self.single | inside and motion.written.statement not in shared:
                out |= set() if self._needs_a_line(motion) else {i}
        return frozenset(out)

    # ------------------------------------------------------------------------------------------------------------ both

    def tried(self, loops: Loops) -> tuple[set[int], list[Stretch]]:
        """The computed targets and the stretches that come out as the program when written with its own values."""
        program, scopes = self.program, self.scopes
        own = {i for i in range(len(program.motions)) if self._can_be_said(i, loops)}
        flat = self.stretches.every() if loops is Loops.UNROLL else []
        targets = Targets(program, self.plant, Edits(program.files), Names({}), scopes)
        intents = {
            i: Intent(targets.as_written(motion) if isinstance(motion, Move) else None)
            for i, motion in enumerate(program.motions)
            if isinstance(motion, Move | Wait)
        }
        reads = 0
        while (own or flat) and reads < _TRIALS:
            covered = _inside(flat)
            choices = Choices(frozenset(own - covered), tuple(flat), loops=loops)
            try:
                export = write(program, self.plant, scopes, self.stretches, intents, choices)
            except InputError as error:
                wrong = _blamed(program, error)
            else:
                reads += 1
                try:
                    difference = first_difference(program, self.reading.again(export.texts, export.new))
                except InputError:
                    difference = len(program.motions)
                if difference is None:
                    return own - covered, flat
                wrong = difference
            # What is written nearest before the first difference made it.
            last = max((i for i in own - covered if i <= wrong), default=-1)
            stretch = max((one for one in flat if one.first <= wrong), key=lambda one: one.first, default=None)
            if stretch is not None and stretch.first >= last:
                flat = _without(program, flat, stretch, wrong)
            elif last >= 0:
                statement = program.motions[last].written.statement
                own = {i for i in own if program.motions[i].written.statement != statement}
            else:
                break
        return set(), []

    def _can_be_said(self, index: int, loops: Loops) -> bool:
        """Whether a new target may stand in for a computed one."""
        motion = self.program.motions[index]
        if not isinstance(motion, Move) or motion.written.aggregate is not None or motion.written.target is None:
            return False
        if isinstance(motion, PoseMove) and motion.X_WO is None:
            return False
        if loops is Loops.UNROLL and index not in self.single:
            return False
        if loops is Loops.KEEP and self.scopes.depends_on(motion) is not None:
            return False
        line = index in self.single and self._needs_a_line(motion) and motion.written.statement in self.scopes.compact
        return not line and self.stretches.constant(index)

    def _literals(self) -> set[int]:
        """The moves that have a literal, and room for what may become of them."""
        return {
            i
            for i, motion in enumerate(self.program.motions)
            if isinstance(motion, Move)
            and motion.written.aggregate is not None
            and not (self._needs_a_line(motion) and motion.written.statement in self.scopes.compact)
        }

    def _needs_a_line(self, motion: Motion) -> bool:
        """Whether a move may be dropped or switched, which takes a line of its own, and one answer for all its runs."""
        return (isinstance(motion, PoseMove) and not confdata_counts(motion)) or may_go(motion, self.plant)

    def droppable(self, free: Set[int]) -> frozenset[int]:
        """The motions that can be left out where loops are kept: those of one statement all together or not at all."""
        going = droppable(self.program, self.plant) & free
        statements = [motion.written.statement for motion in self.program.motions]
        staying = {span for i, span in enumerate(statements) if i not in going}
        staying |= {span for span in self.scopes.compact if self.runs[span] > 1}
        return frozenset(i for i in going if statements[i] not in staying)

    def _disturbed(self, free: Set[int], choices: Choices, ties: Iterable[Passes] = ()) -> int | None:
        """The first motion that becomes another when every free move is given a rail position of its own (without a
        rail: a configuration), of tied ones the same; None where all become what they should."""
        program = self.program
        first = {i: group[0] for group in ties for i in group}
        targets = Targets(program, self.plant, Edits(program.files), Names({}), self.scopes)
        intents, wanted = {}, list(program.motions)
        for i, motion in enumerate(program.motions):
            if isinstance(motion, Wait):
                intents[i] = Intent()
            elif isinstance(motion, Move):
                wish = targets.as_written(motion)
                if i in free:
                    wanted[i] = other = self._moved(motion, first.get(i, i) % _STEPS + 1)
                    wish = targets.as_written(other)
                intents[i] = Intent(wish)
        try:
            choices = replace(choices, isolated=True)
            export = write(program, self.plant, self.scopes, self.stretches, intents, choices)
            read = self.reading.again(export.texts, export.new)
        except InputError as error:
            return _blamed(program, error)
        return first_difference(replace(program, motions=tuple(wanted)), read)

    def _moved(self, motion: Move, steps: int) -> Move:
        """A move to the same place with so many steps added to its rail position, without a rail to its confdata."""
        eax = self.plant.rail_eax
        if eax is not None and motion.hold is not Hold.UNIT:
            axes = list(motion.extax)
            axes[eax] = round((motion.extax[eax] or 0.0) + _STEP * steps, 3)
            return replace(motion, extax=cast(ExternalAxes, tuple(axes)))
        if isinstance(motion, PoseMove) and confdata_counts(motion):
            return replace(motion, conf=replace(motion.conf, cf6=motion.conf.cf6 + steps))
        return motion

    def kept(self, free: Set[int], loops: Loops) -> Iterator[str]:
        """What users should know of the moves that are no free ones: where they are, why, what would free them.

        Moves of joints have nothing to change where there is no rail.
        """
        places: dict[tuple[str, str], dict[str, dict[int, None]]] = {}
        for i, motion in enumerate(self.program.motions):
            bound = isinstance(motion, MoveAbsJ | MoveExtJ) and self.plant.rail_eax is None
            if not isinstance(motion, Move) or i in free or bound:
                continue
            reason = self._why_kept(i, motion, loops)
            lines = places.setdefault(reason, {}).setdefault(motion.source.file, {})
            lines[motion.source.line] = None
        for (why, remedy), files in places.items():
            yield f"{KEPT}: {_shown(files)} ({why}); {remedy}"

    def _why_kept(self, index: int, move: Move, loops: Loops) -> tuple[str, str]:
        """Why a move stays as programmed, and what would free it."""
        span = move.written.statement
        thing, runs = self.stretches.hangs_on(index), self.runs[span]
        if loops is Loops.KEEP and (thing is None or self.stretches.constant(index)):
            computed = move.written.aggregate is None
            if computed and (variable := self.scopes.depends_on(move)) is not None:
                remedy = "a declared target would free them, or --loops unroll, which writes this run's values out"
                return f"depend on {variable}", remedy
            if index in self.moving:
                remedy = "declared targets of their own would free them, or --loops unroll"
                return "cannot be edited without moving others", remedy
            if runs > 1:
                remedy = "one statement per pass would free them, or --loops unroll"
                return f"run {runs} times with different values", remedy
        return _why_kept(move, runs, thing, span in self.scopes.compact)


def _why_kept(move: Move, runs: int, thing: str | None, compact: bool) -> tuple[str, str]:
    """Why a move stays as programmed, and what would free it."""
    often = f"run {runs} times" if runs > 1 else ""
    if thing == "endless_passes" or (runs > 1 and thing is None):
        why = f"{often} with different values" if often else "depend on endless_passes"
        return why, "one statement per pass would free them, for an endless loop endless_passes: 1"
    if thing is not None:
        both = " and ".join(part for part in (often, f"depend on {thing}") if part)
        return both, "one statement with a declared target per pass would free them"
    if compact:
        return "are part of an IF without THEN", "IF ... THEN ... ENDIF would free them"
    return "cannot be edited without moving others", "declared targets of their own would free them"


def _shown(files: Mapping[str, Iterable[int]]) -> str:
    """Places by file, a few of them; and how many more."""
    every = [(file, line) for file, lines in files.items() for line in sorted(lines)]
    by_file: dict[str, list[str]] = {}
    for file, line in every[:_PLACES]:
        by_file.setdefault(file, []).append(str(line))
    text = "; ".join(f"{file}:{', '.join(lines)}" for file, lines in by_file.items())
    return f"{text} and {len(every) - _PLACES} more" if len(every) > _PLACES else text


def _inside(flat: list[Stretch]) -> set[int]:
    return {i for stretch in flat for i in range(stretch.first, stretch.last)}


def _shared_literals(program: Program) -> set[Span]:
    """Statements that run several times and meet one literal more than once, among themselves or with another such."""
    runs = Counter(motion.written.statement for motion in program.motions)
    several = [
        m for m in program.motions if isinstance(m, Move) and runs[m.written.statement] > 1 and m.written.aggregate
    ]
    met = Counter(motion.written.aggregate for motion in several)
    return {motion.written.statement for motion in several if met[motion.written.aggregate] > 1}


def _places_to_dwell(program: Program, scopes: Scopes, known: Set[int]) -> set[int]:
    """Waits in whose place a line to where the tool is could stand. known: computed targets that can be written."""
    behind: list[Move | None] = [None] * len(program.motions)
    following: Move | None = None
    for i in range(len(program.motions) - 1, -1, -1):
        behind[i] = following
        motion = program.motions[i]
        following = motion if isinstance(motion, Move) else following
    out, before = set(), -1
    for i, motion in enumerate(program.motions):
        if isinstance(motion, Move):
            before = i
        elif isinstance(motion, Wait) and _stands_alone(motion) and before >= 0:
            compact = motion.condition is not None and motion.written.statement in scopes.compact
            if not compact and _fits_behind(program, scopes, motion, before, behind[i], known):
                out.add(i)
    return out


def _stands_alone(motion: Motion) -> bool:
    """Whether it is a wait, no function in an expression and not beside a move: a line may stand in its place."""
    return isinstance(motion, Wait) and motion.written.target is None and motion.beside is None


def _fits_behind(
    program: Program, scopes: Scopes, wait: Wait, before: int, behind: Move | None, known: Set[int]
) -> bool:
    move = program.motions[before]
    assert isinstance(move, Move)
    if behind is not None and behind.settings != move.settings:
        return False  # they change somewhere between, and the line would be read under others
    if isinstance(move, MoveAbsJ | MoveExtJ) and move.settings.displaced:
        return False
    if isinstance(move, PoseMove) and move.written.aggregate is None and before not in known:
        return False
    at, to = move.written.statement, wait.written.statement
    text = program.files[at.file].text
    call = read_move(move, text[at.start : at.end])
    here, there = (at.file, at.start), (to.file, to.start)
    words = (call.speed, call.tool, call.wobj)
    return all(scopes.same(text[word.start : word.end], here, there) for word in words if word is not None)


def _without(program: Program, flat: list[Stretch], culprit: Stretch, wrong: int) -> list[Stretch]:
    """Stretches but the culprit, and but those that run the same statement as it does where it goes wrong."""
    same = program.motions[wrong].written.statement if wrong < culprit.last else None
    return [
        one
        for one in flat
        if one is not culprit
        and all(motion.written.statement != same for motion in program.motions[one.first : one.last])
    ]


def _blamed(program: Program, error: InputError) -> int:
    """The motion an error is placed at; the last one where it has no place in the program as given."""
    for index, motion in enumerate(program.motions):
        source = motion.source
        if (source.file, source.line, source.column) == (error.file, error.line, error.column):
            return index
    return len(program.motions)
