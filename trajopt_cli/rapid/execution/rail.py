"""The rail: during which motions it must stand still, and where it stands for targets that leave it open (9E9).

It stands in every wait that the cell file does not free, and wherever it or a comment of the program says so.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence, Set
from dataclasses import replace
from pathlib import PurePath

from trajopt_cli.motion import ExternalAxes, Happens, Hold, Motion, Move, PathEvent, Program, SignalEvent, Wait
from trajopt_cli.rapid.data.scope import CallFrame, Datum, ExternalDatum
from trajopt_cli.rapid.execution.context import Context, RailPlaces
from trajopt_cli.rapid.execution.named import Around, Entry, Modules, check_name, named, placed, routines_of, within
from trajopt_cli.rapid.language.syntax import DataDeclaration, Expression, Name, walk
from trajopt_cli.rapid.language.text import listed
from trajopt_cli.scenario import HoldRail, Lines, condition_key
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

# [s] between an output and a wait that is taken to be for what the output does; a num of 0.1 is a little more than that
_AFTER_OUTPUT = 0.1 + 1e-6
_SHOWN = 3  # places in a sentence
_UNASKED = (Hold.GRIPPER, Hold.WAIT)  # who holds the rail where nobody has said so


def fill_holds(run: Context, modules: Modules) -> None:
    """Fill the hold of every motion of a finished run, and warn of marks and entries that hold none.

    Raises InputError for a procedure or a line in the cell file that the program does not have.
    """
    wish = run.scenario.hold_rail
    held = within(run, [*_entries(run, modules)], Move | Wait)
    after, freed = frozenset(map(id, _after_outputs(run.motions))), _freed(run, modules)
    for index, motion in enumerate(run.motions):
        if isinstance(motion, Wait) and motion.settles:
            continue
        hold = held[index].hold if index in held else None
        if hold is None and isinstance(motion, Wait) and motion.hold is None and index not in freed:
            hold = _of_wait(wish, id(motion) in after, run.scenario.rail is not None)
        if hold is not None:
            object.__setattr__(motion, "hold", hold)  # still the run's own
    for first, end in run.units.rail_inactive:
        for motion in run.motions[first:end]:
            if not (isinstance(motion, SignalEvent) or (isinstance(motion, Wait) and motion.settles)):
                object.__setattr__(motion, "hold", Hold.UNIT)


def _of_wait(wish: HoldRail, after_output: bool, has_rail: bool) -> Hold | None:
    """Who holds the rail in a wait that nobody names."""
    if wish.waits:
        return Hold.CELL
    if wish.free is True or (after_output and wish.gripper is False):
        return Hold.GRIPPER if after_output and wish.gripper else None
    if after_output:
        return Hold.GRIPPER
    return Hold.WAIT if has_rail and wish.waits is None else None


def _freed(run: Context, modules: Modules) -> Set[int]:
    """The waits that the cell file frees by line or name; warns of the entries that free none.

    Raises InputError for a line that the program does not have, and for a name that is none of it.
    """
    free = run.scenario.hold_rail.free
    if isinstance(free, bool):
        return frozenset()
    out, waits = set[int](), [i for i, one in enumerate(run.motions) if isinstance(one, Wait) and not one.settles]
    for one, place in free.items():
        if isinstance(one, Lines):
            with placed(place):
                spans = [span for found in named(run, modules, "waits.rail.free", (), [one]) for span in found.spans]
        else:
            spans = [span for span, name in routines_of(modules) if name.lower() == one.lower()]
        around, name = Around([spans]), None if isinstance(one, Lines) else condition_key(one)
        found = {i for i in waits if around(run.links[i]) or name in run.waited[i]}
        if not found:
            if isinstance(one, str) and not spans:
                message = f"waits.rail.free: '{one}' is no procedure, and nothing that the program waits for"
                check_name(modules, one, message, place)
            run.warn(WarningKind.UNUSED, f"waits.rail.free in the cell file: no wait ran in or for {one}", place)
        out |= found
    return out


def held_by_default(program: Program) -> str | None:
    """One sentence on the waits of some time that hold the rail unasked; None for none."""
    waits = [one for one in program.motions if isinstance(one, Wait) and one.hold in _UNASKED and one.duration > 0]
    if not waits:
        return None
    places = list(dict.fromkeys(f"{PurePath(wait.source.file).name}:{wait.source.line}" for wait in waits))
    count = f"{len(waits)} waits" if len(waits) > 1 else "1 wait"
    return (
        f"the rail holds still in {count} ({listed(places, _SHOWN)}); "
        "'waits: {rail: free}' in the cell file lets it move"
    )


def freed_by_default(program: Program) -> Program:
    """The program whose rail may move in the waits of held_by_default."""
    motions = [
        replace(one, hold=None) if isinstance(one, Wait) and one.hold in _UNASKED else one for one in program.motions
    ]
    return replace(program, motions=tuple(motions))


def _entries(run: Context, modules: Modules) -> Iterator[Entry]:
    """The program's own marks, then what the cell file names by procedure or line."""
    for span in run.held:
        place = run.files[span.file].source(span.start)
        yield Entry((span,), "marked 'hold rail', but no move and no wait ran there", place, Hold.PROGRAM)
    wish, unused = run.scenario.hold_rail, "hold_rail in the cell file: no move and no wait ran in "
    for one in named(run, modules, "hold_rail", wish.procedures, wish.lines):
        yield Entry(one.spans, f"{unused}{one.text}", hold=Hold.CELL)


def _after_outputs(motions: Sequence[Motion]) -> Iterator[Wait]:
    """The waits that begin at most _AFTER_OUTPUT after an output was set, by an instruction or at a move's end."""
    since: float | None = None  # [s] since the last output, None where a move has begun since
    for motion in motions:
        if isinstance(motion, Wait) and motion.settles:
            continue
        if isinstance(motion, Wait):
            if since is not None:
                if since <= _AFTER_OUTPUT and motion.beside is None:
                    yield motion
                since += motion.duration
        elif isinstance(motion, SignalEvent):
            since = 0.0 if motion.delay <= _AFTER_OUTPUT else since
        else:
            since = min((one.time for one in motion.events if _near_end(one)), default=None) if motion.events else None


def _near_end(event: PathEvent) -> bool:
    at_end = event.kind is Happens.SIGNAL and not event.from_start and event.distance == 0
    return at_end and event.time <= _AFTER_OUTPUT


class CellRailPlaces(RailPlaces):
    """The rail_at of a cell file while a program runs: of a target's point, of the routines that run from the innermost
    on, and of the output that was set last, the first that it names says where the rail stands."""

    def __init__(self, run: Context, modules: Modules):
        """Raises InputError for a name that the program does not have."""
        self._run, self._used, self._last = run, set[str](), ""
        self._given = run.scenario.rail_at
        self._declared = {
            places.span(node.start, node.end): node.name.lower()
            for module, places in modules
            for node in walk(module)
            if isinstance(node, DataDeclaration)
        }
        for key, one in self._given.items():
            name = re.split(r"\W", key, maxsplit=1)[0]
            check_name(modules, name, f"rail_at.{one.name}: the program has no '{name}'", one.place)

    def set(self, signal: str, value: float) -> bool:
        """An output is set; whether that drives the rail."""
        if (key := condition_key(f"{signal}={value:.15g}")) in self._given:
            self._last = key
        return key == self._last

    def fill(self, point: Expression, extax: ExternalAxes) -> ExternalAxes:
        """The external axes [mm or deg] of a target with the rail where the cell file has it."""
        rail = self._run.scenario.rail
        if rail is None or extax[rail.eax] is not None:
            return extax
        key = next((key for key in self._keys(point) if key in self._given), None)
        if key is None:
            return extax
        self._used.add(key)
        return tuple(self._given[key].d / MM if i == rail.eax else old for i, old in enumerate(extax))

    def _keys(self, point: Expression) -> Iterator[str]:
        run = self._run
        yield condition_key(run.text(point))
        for node in walk(point):
            if isinstance(node, Name):
                yield node.name.lower()
                place = run.find(node.name)  # a parameter stands for the data that the caller gives
                is_read = isinstance(place, ExternalDatum)  # and the next reading may give another value
                origin = place.value.origin if isinstance(place, Datum) and not is_read else None
                if origin is not None and origin.declaration is not None:
                    yield self._declared.get(origin.declaration, "")  # none of a module that is loaded later
        frame: CallFrame | None = run.frame
        while frame is not None:
            if frame.routine is not None:
                yield frame.routine.name.lower()
            frame = frame.caller
        yield self._last

    def warn_unused(self) -> None:
        """Tell of the entries that no target took."""
        for key, one in self._given.items():
            if key not in self._used:
                text = f"rail_at in the cell file: no target took {one.name}; those that give a position keep it"
                self._run.warn(WarningKind.UNUSED, text, one.place)
