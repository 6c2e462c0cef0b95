"""What ran in the procedures and lines that the cell file names, with all that was called there."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import PurePath

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.motion import PathMove, Source, Span
from trajopt_cli.rapid.execution.context import Context, Link
from trajopt_cli.rapid.language.syntax import DataDeclaration, Module, Name, Routine, Statement
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.rapid.language.walk import walk
from trajopt_cli.scenario import Lines
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


def check_name(modules: Modules, name: str, message: str, place: Source) -> None:
    """Raise InputError with the message and the nearest name where name stands nowhere in the program. place: of it in
    the cell file."""
    known = {
        node.name.lower(): node.name
        for module, _ in modules
        for node in walk(module)
        if isinstance(node, Name | Routine | DataDeclaration)
    }
    if name.lower() not in known:
        close = get_close_matches(name.lower(), sorted(known), n=1)
        message += f"; did you mean '{known[close[0]]}'?" if close else f"; {_few([*known.values()])}"
        raise InputError(message, file=place.file, line=place.line, kind=ErrorKind.CELL)


def _few(names: Sequence[str]) -> str:
    more = f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return f"there is {', '.join(names[:_SHOWN])}{more}"


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


def fill_constant_speed(run: Context, modules: Modules) -> None:
    """Mark the lines and arcs of a finished run that constant_speed names, and warn of entries that name none.

    Raises InputError for a procedure or a line in the cell file that the program does not have.
    """
    wish = run.scenario.constant_speed
    entries = [*named(run, modules, "constant_speed", wish.procedures, wish.lines)]
    if not entries:
        return
    around = Around([entry.spans for entry in entries])
    used: set[int] = set()
    for motion, link in zip(run.motions, run.links, strict=True):
        if isinstance(motion, PathMove) and (found := around(link)):
            used |= found
            object.__setattr__(motion, "constant_speed", True)  # still the run's own
    for number, entry in enumerate(entries):
        if number not in used:
            run.warn(WarningKind.UNUSED, f"constant_speed in the cell file: no line and no arc ran in {entry.text}")
