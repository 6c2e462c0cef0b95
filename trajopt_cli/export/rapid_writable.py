"""Which motions of a program can be given other rail positions and configurations, known before anything is planned."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Set
from dataclasses import replace
from typing import cast

from trajopt_cli.errors import InputError
from trajopt_cli.export.rapid_call import read_move
from trajopt_cli.export.rapid_check import first_difference
from trajopt_cli.export.rapid_reading import Reading
from trajopt_cli.export.rapid_scopes import Scopes
from trajopt_cli.export.rapid_stretches import Stretch, Stretches
from trajopt_cli.export.rapid_targets import PoseMove, Targets, confdata_counts
from trajopt_cli.export.rapid_text import Edits, Names
from trajopt_cli.export.rapid_write import Choices, Intent, write
from trajopt_cli.motion import ExternalAxes, Move, MoveAbsJ, MoveExtJ, Program, Span, Wait
from trajopt_cli.problem.changes import Changes, droppable, may_go
from trajopt_cli.problem.plant import Plant

_STEP, _STEPS = 0.01, 997  # mm; how far targets are moved along the rail to see what else moves, and how many ways
KEPT = "kept as programmed on the RAPID target"
_PLACES = 5  # that a note names
_TRIALS = 8  # of a long program each takes as long as reading it


def text_changes(program: Program, plant: Plant, reading: Reading) -> Changes:
    """What a plan may change so that the program's text can carry it; all else must stay as programmed.

    - A literal target whose statement runs once, or with another literal each time.
    - A computed target whose statement runs once, if it can be said in numbers.
    - Whatever lies in a stretch that can be written flat.
    - A wait that runs once, where a line could stand in its place.

    The last word has a trial: computed targets and flat stretches are written with the values of the program itself,
    and what is read back must be the program; then everything is written with other values, in the way that an export
    falls back on, and what is read back must have those. Nothing is written out that hangs on the scenario: what a
    program does with a search, an answer or an input must stay its own.
    """
    scopes = Scopes(program.files)
    stretches = Stretches(program, scopes, reading)
    free = _writable(program, plant, reading, scopes, stretches)
    kept = tuple(_kept(program, plant, scopes, stretches, free))
    return Changes(free, (), droppable(program, plant) & free, kept)


def _writable(program: Program, plant: Plant, reading: Reading, scopes: Scopes, stretches: Stretches) -> frozenset[int]:
    """The moves and waits whose text can carry values of their own, by index."""
    runs = Counter(motion.written.statement for motion in program.motions)
    single = {i for i, motion in enumerate(program.motions) if runs[motion.written.statement] == 1}
    computed = {i for i in single if _can_be_said(program, i) and stretches.constant(i)}
    own, flat = _tried(program, plant, scopes, stretches, reading, computed)
    out = _free(program, plant, scopes, own, flat)
    several = {i for i in out if i not in single} - _inside(flat)  # edited in place, so others may compute with them
    for less, fewer, rest in ((out, own, flat), (out - several, own, flat)):
        if not (less & several or fewer or rest):
            return less  # each target by itself, or a new one that nothing else reads
        if _carries_others(program, plant, scopes, stretches, reading, less, Choices(frozenset(fewer), tuple(rest))):
            return less
    return _free(program, plant, scopes, set(), []) - several


def _kept(program: Program, plant: Plant, scopes: Scopes, stretches: Stretches, free: Set[int]) -> Iterator[str]:
    """What users should know of the moves that are no free ones: where they are, why they stay, what would free them.

    Moves of joints have nothing to change where there is no rail.
    """
    runs = Counter(motion.written.statement for motion in program.motions)
    places: dict[tuple[str, str], dict[str, dict[int, None]]] = {}
    for i, motion in enumerate(program.motions):
        bound = isinstance(motion, MoveAbsJ | MoveExtJ) and plant.rail_eax is None
        if not isinstance(motion, Move) or i in free or bound:
            continue
        span = motion.written.statement
        why, remedy = _why_kept(motion, runs[span], stretches.hangs_on(i), span in scopes.compact)
        lines = places.setdefault((why, remedy), {}).setdefault(motion.source.file, {})
        lines[motion.source.line] = None
    for (why, remedy), files in places.items():
        yield f"{KEPT}: {_shown(files)} ({why}); {remedy}"


def _why_kept(move: Move, runs: int, thing: str | None, compact: bool) -> tuple[str, str]:
    """Why a move stays as programmed, and what would free it."""
    often = f"run {runs} times" if runs > 1 else ""
    if thing == "endless_passes" or (runs > 1 and thing is None):
        why = f"{often} in one loop or routine" if often else "hang on endless_passes"
        return why, "a statement of its own for each time would free them, for an endless loop endless_passes: 1"
    if thing is not None:
        both = " and ".join(part for part in (often, f"hang on {thing}") if part)
        return both, "a statement with a declared target, for each time it runs, would free them"
    if compact:
        return "hang on an IF without THEN", "IF ... THEN ... ENDIF would free them"
    return "cannot be edited without moving others", "declared targets of their own would free them"


def _shown(files: Mapping[str, Iterable[int]]) -> str:
    """Places by file, a few of them; and how many more."""
    every = [(file, line) for file, lines in files.items() for line in sorted(lines)]
    by_file: dict[str, list[str]] = {}
    for file, line in every[:_PLACES]:
        by_file.setdefault(file, []).append(str(line))
    text = "; ".join(f"{file}:{', '.join(lines)}" for file, lines in by_file.items())
    return f"{text} and {len(every) - _PLACES} more" if len(every) > _PLACES else text


def safest(program: Program, plant: Plant, scopes: Scopes, stretches: Stretches, reading: Reading) -> Choices:
    """How to write what other ways cannot: no declaration is edited where a new one will do, and all is written out."""
    runs = Counter(motion.written.statement for motion in program.motions)
    single = {i for i, motion in enumerate(program.motions) if runs[motion.written.statement] == 1}
    computed = {i for i in single if _can_be_said(program, i) and stretches.constant(i)}
    own, flat = _tried(program, plant, scopes, stretches, reading, computed)
    return Choices(frozenset(own), tuple(flat), isolated=True)


def _inside(flat: list[Stretch]) -> set[int]:
    return {i for stretch in flat for i in range(stretch.first, stretch.last)}


def _free(program: Program, plant: Plant, scopes: Scopes, own: set[int], flat: list[Stretch]) -> frozenset[int]:
    """What can carry values of its own. own, flat: computed targets and stretches that can be written out."""
    runs = Counter(motion.written.statement for motion in program.motions)
    single = {i for i, motion in enumerate(program.motions) if runs[motion.written.statement] == 1}
    inside = _inside(flat)
    out = {i for i in inside if isinstance(program.motions[i], Move | Wait)}
    shared = _shared_literals(program)
    dwells = _places_to_dwell(program, scopes, own | inside)
    for i, motion in enumerate(program.motions):
        if i in inside:
            continue
        if isinstance(motion, Wait):
            if i in single and i in dwells:
                out.add(i)
        elif isinstance(motion, Move):
            literal = motion.written.aggregate is not None
            switched = isinstance(motion, PoseMove) and not confdata_counts(motion)
            # What may be dropped or switched needs a line of its own, and one answer for all its runs.
            alone = switched or may_go(motion, plant)
            if i in single:
                if (literal or i in own) and not (alone and motion.written.statement in scopes.compact):
                    out.add(i)
            elif literal and not alone and motion.written.statement not in shared:
                out.add(i)
    return frozenset(out)


def _carries_others(
    program: Program,
    plant: Plant,
    scopes: Scopes,
    stretches: Stretches,
    reading: Reading,
    free: Set[int],
    choices: Choices,
) -> bool:
    """Whether every free move can be given a rail position of its own without anything else becoming another."""
    eax = plant.rail_eax
    if eax is None:
        return True
    targets = Targets(program, plant, Edits(program.files), Names({}), scopes)
    intents, wanted = {}, list(program.motions)
    for i, motion in enumerate(program.motions):
        if isinstance(motion, Wait):
            intents[i] = Intent()
        elif isinstance(motion, Move):
            wish = targets.as_written(motion)
            if i in free:
                value = round((motion.extax[eax] or 0.0) + _STEP * (i % _STEPS + 1), 3)
                axes = list(motion.extax)
                axes[eax] = value
                wanted[i] = other = replace(motion, extax=cast(ExternalAxes, tuple(axes)))
                wish = targets.as_written(other)
            intents[i] = Intent(wish)
    try:
        export = write(program, plant, scopes, stretches, intents, replace(choices, isolated=True))
        read = reading.again(export.texts, export.new)
    except InputError:
        return False
    return first_difference(replace(program, motions=tuple(wanted)), read) is None


def _can_be_said(program: Program, index: int) -> bool:
    motion = program.motions[index]
    if not isinstance(motion, Move) or motion.written.aggregate is not None:
        return False
    return motion.written.target is not None and not (isinstance(motion, PoseMove) and motion.X_WO is None)


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
        elif isinstance(motion, Wait) and before >= 0:
            compact = motion.condition is not None and motion.written.statement in scopes.compact
            if not compact and _fits_behind(program, scopes, motion, before, behind[i], known):
                out.add(i)
    return out


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


def _tried(
    program: Program, plant: Plant, scopes: Scopes, stretches: Stretches, reading: Reading, computed: set[int]
) -> tuple[set[int], list[Stretch]]:
    """The computed targets and the stretches that come out as the program when written with its own values."""
    own, flat = set(computed), stretches.every()
    targets = Targets(program, plant, Edits(program.files), Names({}), scopes)
    intents = {
        i: Intent(targets.as_written(motion) if isinstance(motion, Move) else None)
        for i, motion in enumerate(program.motions)
        if isinstance(motion, Move | Wait)
    }
    reads = 0
    while (own or flat) and reads < _TRIALS:
        covered = {i for stretch in flat for i in range(stretch.first, stretch.last)}
        choices = Choices(frozenset(own - covered), tuple(flat))
        try:
            export = write(program, plant, scopes, stretches, intents, choices)
        except InputError as error:
            wrong = _blamed(program, error)
        else:
            reads += 1
            try:
                difference = first_difference(program, reading.again(export.texts, export.new))
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
            own.discard(last)
        else:
            break
    return set(), []


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
