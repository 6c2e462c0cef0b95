"""What ran in the procedures and lines that the cell file names, with all that was called there."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import PurePath
from types import UnionType

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.motion import Hold, Motion, PathMove, PoseMove, Source, Span, instruction_name, motion_name
from trajopt_cli.rapid.execution.context import Context, Link
from trajopt_cli.rapid.language.syntax import DataDeclaration, Module, Name, Routine, Statement, walk
from trajopt_cli.rapid.language.text import Places, listed
from trajopt_cli.scenario import FreeTool, Lines
from trajopt_cli.warnings import WarningKind

Modules = Sequence[tuple[Module, Places]]
_SHOWN = 5  # names in a message


@dataclass(frozen=True)
class Named:
    """A procedure or some lines: where they stand, and what messages call them ("weld", "line 41")."""

    spans: tuple[Span, ...]
    text: str


def named(
    run: Context, modules: Modules, key: str, procedures: Collection[str], lines: Collection[Lines]
) -> Iterator[Named]:
    """What a key of the cell file names, procedures first. procedures: in lower case.

    Raises InputError for a procedure or a line that the program does not have.
    """
    if procedures:
        routines = routines_of(modules)
        for name in sorted(procedures):
            spans = tuple(span for span, spelled in routines if spelled.lower() == name)
            if not spans:
                message = f"{key} in the cell file: the program has no procedure '{name}'"
                known = [spelled for _, spelled in routines]
                hinted = run.meant(name, message, known)
                raise InputError(f"{message}; {_few(known)}" if hinted == message else hinted, kind=ErrorKind.CELL)
            yield Named(spans, name)
    for one in sorted(lines, key=lambda one: (one.file or "", one.first, one.last)):
        text = f"line {one}" if one.first == one.last else f"lines {one}"
        names = sorted({PurePath(places.file).name for _, places in modules})
        if one.file is None and len(names) > 1:
            message = f"{text} could be in any of {len(names)} files; name one, '{names[0]}:{one}'"
            raise InputError(f"{key} in the cell file: {message}", kind=ErrorKind.CELL)
        begun = [*_statements(one.file, modules)]
        spans = tuple(span for line, span in begun if one.first <= line <= one.last)
        if not spans:
            near = min((line for line, _ in begun), key=lambda line: abs(line - one.first), default=None)
            hint = _few(names) if near is None else f"the nearest one is in line {near}"
            raise InputError(f"{key} in the cell file: no statement begins in {text}; {hint}", kind=ErrorKind.CELL)
        yield Named(spans, text)


def routines_of(modules: Modules) -> list[tuple[Span, str]]:
    """The routines of a program, with their names as spelled."""
    return [
        (places.span(node.start, node.end), node.name)
        for module, places in modules
        for node in module.items
        if isinstance(node, Routine)
    ]


@contextmanager
def placed(place: Source) -> Iterator[None]:
    """Errors that leave the block are of the cell file's line."""
    try:
        yield
    except InputError as error:
        raise InputError(error.message, file=place.file, line=place.line, kind=ErrorKind.CELL) from None


def check_name(
    modules: Modules, name: str, message: str, place: Source, fitting: Collection[str] | None = None
) -> None:
    """Raise InputError with the message and the nearest name where name stands nowhere in the program. place: of it in
    the cell file. fitting: the names that would do, None for all."""
    known = {
        node.name.lower(): node.name
        for module, _ in modules
        for node in walk(module)
        if isinstance(node, Name | Routine | DataDeclaration)
    }
    if name.lower() not in known:
        known = known if fitting is None else {one.lower(): one for one in sorted(fitting)}
        close = get_close_matches(name.lower(), sorted(known), n=1)
        message += f"; did you mean '{known[close[0]]}'?" if close else f"; {_few([*known.values()])}"
        raise InputError(message, file=place.file, line=place.line, kind=ErrorKind.CELL)


def _few(names: Sequence[str]) -> str:
    return f"there is {listed(names, _SHOWN)}"


def _statements(file: str | None, modules: Modules) -> Iterator[tuple[int, Span]]:
    """The statements and routines of a file, or of the only one, each with the line it begins in."""
    for module, places in modules:
        if file is None or PurePath(places.file).name.lower() == file.lower():
            for node in walk(module):
                if isinstance(node, Statement | Routine):
                    yield places.line(node.start), places.span(node.start, node.end)


class Around:
    """Which stretches a motion stands in, by the statement that made it and those it ran inside, calls included."""

    def __init__(self, stretches: Sequence[Sequence[Span]]):
        self._stretches = [(span, number) for number, spans in enumerate(stretches) for span in spans]
        self._links: dict[int, frozenset[int]] = {}  # by id
        self._statements: dict[int, frozenset[int]] = {}  # by id, of the statement alone

    def __call__(self, link: Link | None) -> frozenset[int]:
        """The numbers of those stretches."""
        passed = []
        while link is not None and id(link) not in self._links:
            passed.append(link)
            link = link[1]
        found = frozenset[int]() if link is None else self._links[id(link)]
        for one in reversed(passed):
            self._links[id(one)] = found = found | self._own(one)
        return found

    def _own(self, link: Link) -> frozenset[int]:
        node, _, file = link
        if id(node) not in self._statements:
            self._statements[id(node)] = frozenset(
                number for span, number in self._stretches if span.file == file and span.start <= node.start < span.end
            )
        return self._statements[id(node)]


@dataclass(frozen=True)
class Entry:
    """One mark of the program or one name or line of the cell file: where it holds, and what to say if it does not."""

    spans: tuple[Span, ...]
    unused: str
    place: Source | None = None
    hold: Hold | None = None


def within(run: Context, entries: Sequence[Entry], kinds: UnionType | type[Motion]) -> dict[int, Entry]:
    """The first entry that each motion of these kinds stands in, by the motion's index; warns of those without any."""
    if not entries:
        return {}
    around, used, out = Around([entry.spans for entry in entries]), set[int](), dict[int, Entry]()
    for index, (motion, link) in enumerate(zip(run.motions, run.links, strict=True)):
        if isinstance(motion, kinds) and (found := around(link)):
            used |= found
            out[index] = entries[min(found)]
    for number, entry in enumerate(entries):
        if number not in used:
            run.warn(WarningKind.UNUSED, entry.unused, entry.place)
    return out


def fill_constant_speed(run: Context, modules: Modules) -> None:
    """Mark the lines and arcs of a finished run that constant_speed names, and warn of entries that name none.

    Raises InputError for a procedure or a line in the cell file that the program does not have.
    """
    wish, unused = run.scenario.constant_speed, "constant_speed in the cell file: no line and no arc ran in "
    found = named(run, modules, "constant_speed", wish.procedures, wish.lines)
    for index in within(run, [Entry(one.spans, f"{unused}{one.text}") for one in found], PathMove):
        object.__setattr__(run.motions[index], "constant_speed", True)  # still the run's own


_EVERYWHERE = "the program"


def fill_free(run: Context, modules: Modules) -> None:
    """Fill the free turn of every move of a finished run, and warn of what frees none.

    A name is that of a procedure, with all that it calls, else of an instruction (DispL) or of a tool. A tool that
    stands in the world while the robot holds the work object (robhold FALSE) is not turned: it does not move.
    Raises InputError for a line that the program does not have, and for a name that is none of it.
    """
    for entry in run.scenario.free:
        used, standing = set[str](), list[PoseMove]()
        for where, motion in _moves(run, modules, entry):
            used.add(where)
            if motion.tool.stationary:
                standing.append(motion)
            else:
                object.__setattr__(motion, "free", entry.turn)  # still the run's own
        if standing:
            text = "moves a work object that the robot holds, the tool stands in the world (robhold FALSE)"
            told = f"free in the cell file: {motion_name(standing[0])} {text}; it stays as taught"
            run.warn(WarningKind.UNUSED, told, standing[0].source)
        for where in [*entry.names, *map(str, entry.lines)] or [_EVERYWHERE]:
            if where in used:
                continue
            named_so = where if where in (*entry.names, _EVERYWHERE) else f"line {where}"
            text = f"free in the cell file: no move to a robtarget ran in {named_so}"
            run.warn(WarningKind.UNUSED, text, entry.place)


def _moves(run: Context, modules: Modules, entry: FreeTool) -> Iterator[tuple[str, PoseMove]]:
    """The moves to poses that an entry names, each with every name or line that names it."""
    moves = [(one, link) for one, link in zip(run.motions, run.links, strict=True) if isinstance(one, PoseMove)]
    if not entry.names and not entry.lines:
        yield from ((_EVERYWHERE, motion) for motion, _ in moves)
        return
    routines = {name for _, name in routines_of(modules)}
    procedures = {name.lower() for name in routines}
    for name in entry.names:
        words = [{instruction_name(motion).lower(), motion.tool.name.lower()} for motion, _ in moves]
        if name.lower() in procedures:
            around = Around([one.spans for one in named(run, modules, "free", [name.lower()], ())])
            yield from ((name, motion) for motion, link in moves if around(link))
        elif any(name.lower() in own for own in words):
            yield from ((name, motion) for (motion, _), own in zip(moves, words, strict=True) if name.lower() in own)
        else:
            message = f"free: '{name}' is no procedure, no instruction and no tool that moves here"
            of_moves = {word for motion, _ in moves for word in (instruction_name(motion), motion.tool.name)}
            check_name(modules, name, message, entry.place, routines | of_moves)
    for line in entry.lines:
        with placed(entry.place):
            around = Around([one.spans for one in named(run, modules, "free", (), [line])])
        yield from ((str(line), motion) for motion, link in moves if around(link))
