"""Groups of statements that may be done in any order: where they stand in the program, what they move, and its text
with them in another order."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from pathlib import PurePath

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_check import first_difference, read_again
from trajopt_cli.job import Job
from trajopt_cli.motion import Program, SignalEvent, Wait
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.scopes import nodes
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.scenario import Lines
from trajopt_cli.validation import hint

LEAST, GREATEST = 2, 60
"""Parts of a group."""
_WRITES = ("incr", "decr", "add", "clear")  # instructions that change what they are given
_JUMPS = (syntax.Goto, syntax.Label, syntax.Return, syntax.Raise, syntax.Simple)


@dataclass(frozen=True, eq=False)
class Part:
    """One of a group. name: for people. statements: in one routine, one behind the other. lines: start and end of their
    lines in the file. motions: its first one in the program, and the one behind its last."""

    name: str
    statements: tuple[syntax.Statement, ...]
    lines: tuple[int, int]
    motions: tuple[int, int] = (0, 0)


@dataclass(frozen=True, eq=False)
class Group:
    """Parts of a program that may be done in any order, in the order they are written in. file: where they stand."""

    job: Job
    name: str
    file: str
    parts: tuple[Part, ...]

    def program(self, order: Sequence[int]) -> Program:
        """The program with its parts in another order; every motion is the very same."""
        motions = self.job.program.motions
        return replace(self.job.program, motions=tuple(motions[i] for i in self.indices(order)))

    def indices(self, order: Sequence[int]) -> list[int]:
        """Which motions of the program as written come in this order."""
        inside = [i for k in order for i in range(*self.parts[k].motions)]
        first, behind = self.parts[0].motions[0], self.parts[-1].motions[1]
        return [*range(first), *inside, *range(behind, len(self.job.program.motions))]

    def changes(self, order: Sequence[int], changes: Changes) -> Changes:
        """What may change of the program as written, for the one in another order."""
        now = {before: after for after, before in enumerate(self.indices(order))}
        return replace(
            changes,
            values=frozenset(now[i] for i in changes.values),
            ties=tuple(tuple(sorted(now[i] for i in group)) for group in changes.ties),
            droppable=frozenset(now[i] for i in changes.droppable),
        )

    def text(self, order: Sequence[int]) -> str:
        """The file's text with the lines of its parts in another order; comments between them stay where they are."""
        text, out, at = self.job.program.files[self.file].text, "", 0
        for here, part in zip(self.parts, (self.parts[k] for k in order), strict=True):
            out += text[at : here.lines[0]] + text[slice(*part.lines)]
            at = here.lines[1]
        return out + text[at:]

    def why_not(self, order: Sequence[int]) -> str | None:
        """Why this order is not written into the program, None where it can be: what it reads as is the program with
        the very same motions in that order, and nothing that one part leaves behind is used in another."""
        for one in (*_jumps(self), *self._shared, *_left_behind(self)):
            return one
        texts = {path: file.text for path, file in self.job.program.files.items()} | {self.file: self.text(order)}
        try:
            read = read_again(self.job.program, self.job.plant, self.job.scenario, texts)
        except InputError as error:
            return f"in that order it reads: {error}"
        wanted = self.program(order)
        difference = first_difference(wanted, read)
        if difference is None:
            return None
        motion = wanted.motions[min(difference, len(wanted.motions) - 1)]
        return f"{motion.source} asks for something else in that order: an instruction of another part changes it"

    @cached_property
    def _shared(self) -> tuple[str, ...]:
        """Data that one part changes and another one uses."""
        routines = _routines(self.job.program)
        used = [set(_names(part, routines, written=False)) for part in self.parts]
        changed = [set(_names(part, routines, written=True)) for part in self.parts]
        return tuple(
            f"{name} is changed in {one.name} and used in {other.name}"
            for i, one in enumerate(self.parts)
            for k, other in enumerate(self.parts)
            for name in sorted(changed[i] & used[k])
            if i != k
        )


def group_of(job: Job, name: str | None = None) -> Group:
    """The group of the cell file's order of this name, the only one where None.

    Raises InputError, placed in the cell file, for a group that is not there, for parts that are not, do not stand one
    behind the other in one routine, are called elsewhere, or move nothing.
    """
    known = job.cell.order
    if not known:
        text = "has no order; say what may be done in any order: 'order: {rivets: [Rivet1, Rivet2]}'"
        raise InputError(text, file=str(job.cell_path))
    if name is None and len(known) > 1:
        raise InputError(f"--group: the cell file has {len(known)} groups: {', '.join(known)}; name one")
    name = name or next(iter(known))
    if name not in known:
        raise InputError(f"--group {name}: {hint(name, [*known])}")
    key = f"order.{name}"
    if len(known[name]) > GREATEST:
        raise job.cell.error(key, f"has {len(known[name])} parts; {GREATEST} at most")
    found = [_found(job, key, part) for part in known[name]]
    places = {(path, routine.start) for path, routine, _ in found}
    if len(places) > 1:
        raise job.cell.error(key, "its parts stand in several routines; they have to stand one behind the other in one")
    path, routine, _ = found[0]
    parts = sorted((part for _, _, part in found), key=lambda part: part.lines)
    _check_row(job, key, path, routine, parts)
    return _with_motions(Group(job, name, path, tuple(parts)), key)


def _found(job: Job, key: str, part: Lines | str) -> tuple[str, syntax.Routine, Part]:
    """File, routine and part that a line of the cell file names."""
    if isinstance(part, str):
        calls = [
            (path, routine, one)
            for path, routine in _routines(job.program)
            for one in routine.body
            if isinstance(one, syntax.ProcedureCall) and one.name.lower() == part.lower() and not one.args
        ]
        every = [
            one for _, routine in _routines(job.program) for one in nodes(routine.body)
            if isinstance(one, syntax.ProcedureCall) and one.name.lower() == part.lower()
        ]  # fmt: skip
        if len(calls) != 1 or len(every) != 1:
            told = "no statement calls it" if not every else f"{len(every)} statements call it"
            known = [routine.name for _, routine in _routines(job.program)]
            advice = hint(part, known) if not every else "a part is one call without arguments; name lines instead"
            raise job.cell.error(key, f"{part}: {told}; {advice}")
        path, routine, call = calls[0]
        return path, routine, _part(job, key, path, part, (call,))
    paths = [path for path in job.program.files if part.file is None or PurePath(path).match(part.file)]
    if len(paths) != 1:
        said = "no file has this name" if not paths else "several files; write FILE:FIRST-LAST"
        raise job.cell.error(key, f"{part}: {said}")
    for path, routine in _routines(job.program):
        text = job.program.files[path].text
        line = Places(text, path).line
        inside = [one for one in routine.body if path == paths[0] and part.first <= line(one.start) <= part.last]
        if inside:
            statements = tuple(inside)
            if line(statements[-1].end) > part.last:
                raise job.cell.error(key, f"{part}: cuts through a statement that ends behind line {part.last}")
            return path, routine, _part(job, key, path, f"line{'s' * (part.first < part.last)} {part}", statements)
    raise job.cell.error(key, f"{part}: no statement of a routine begins there")


def _part(job: Job, key: str, path: str, name: str, statements: tuple[syntax.Statement, ...]) -> Part:
    """A part with its whole lines. Raises InputError where it shares one of them with other code."""
    text = job.program.files[path].text
    start = max(text.rfind(sign, 0, statements[0].start) for sign in "\r\n") + 1
    match = re.compile(r"\r\n|\r|\n|\Z").search(text, statements[-1].end)
    assert match is not None  # \Z always matches
    before, behind = text[start : statements[0].start], text[statements[-1].end : match.start()].strip()
    behind = behind.removeprefix(";").strip()
    if before.strip() or (behind and not behind.startswith("!")):
        raise job.cell.error(key, f"{name}: shares a line with other statements; give it lines of its own")
    return Part(name, statements, (start, match.start()))


def _check_row(job: Job, key: str, path: str, routine: syntax.Routine, parts: Sequence[Part]) -> None:
    """Raise InputError unless the parts stand one behind the other, each statement in one of them."""
    row = [one.start for part in parts for one in part.statements]
    if len(set(row)) < len(row):
        raise job.cell.error(key, "two of its parts have a statement in common")
    between = [one for one in routine.body if row[0] <= one.start <= row[-1] and one.start not in row]
    if between:
        line = Places(job.program.files[path].text, path).line(between[0].start)
        raise job.cell.error(key, f"line {line} of {path} stands between its parts and is in none; put it into one")


_MARK = "WaitTime 0; "  # stands before every part and behind the last, and shows among the motions; waits for nothing


def _with_motions(group: Group, key: str) -> Group:
    """The group with what each part moves: what the program does between marks around it."""
    job, text = group.job, group.job.program.files[group.file].text
    end = group.parts[-1].statements[-1].end
    end = end if text[end - 1] == ";" else text.index(";", end) + 1
    marked, at, starts = "", 0, []
    for offset in (*(part.statements[0].start for part in group.parts), end):
        marked += text[at:offset]
        starts.append(len(marked))
        marked, at = marked + _MARK, offset
    texts = {path: file.text for path, file in job.program.files.items()} | {group.file: marked + text[at:]}
    try:
        read = read_again(job.program, job.plant, job.scenario, texts).motions
    except InputError as error:
        raise job.cell.error(key, f"with a wait before each part the program cannot be read: {error}") from error
    places = [motion.written.statement for motion in read]
    found = [[i for i, one in enumerate(places) if one.file == group.file and one.start == start] for start in starts]
    passes = len(found[0])
    if any(len(one) != 1 for one in found) or len(read) != len(job.program.motions) + len(starts):
        told = "never" if not passes else f"{passes} times" if passes > 1 else "in part only"
        raise job.cell.error(key, f"its parts run {told}; they have to stand in a routine that runs once")
    bounds = [one[0] - marks for marks, one in enumerate(found)]
    parts = tuple(replace(part, motions=pair) for part, pair in zip(group.parts, pairwise(bounds), strict=True))
    for part in parts:
        if part.motions[0] == part.motions[1]:
            raise job.cell.error(key, f"{part.name}: moves nothing")
    return replace(group, parts=parts)


def _routines(program: Program) -> list[tuple[str, syntax.Routine]]:
    return [
        (path, item)
        for path, file in program.files.items()
        for module in parse_module(file.text, path).modules
        for item in module.items
        if isinstance(item, syntax.Routine)
    ]


# ------------------------------------------------------------------------------------------------ what parts share


def _jumps(group: Group) -> Iterator[str]:
    for part in group.parts:
        for one in nodes(part.statements):
            if isinstance(one, _JUMPS):
                yield f"{part.name} jumps or ends the routine ({type(one).__name__.upper()})"


def _names(part: Part, routines: Sequence[tuple[str, syntax.Routine]], written: bool) -> Iterator[str]:
    """The data that a part uses, or changes, with the procedures and functions that it calls; their own is left out."""
    known: dict[str, list[syntax.Routine]] = {}
    for _, routine in routines:
        known.setdefault(routine.name.lower(), []).append(routine)
    seen: set[int] = set()
    blocks: list[tuple[object, set[str]]] = [(part.statements, set())]
    while blocks:
        block, own = blocks.pop()
        for node in nodes(block):
            if isinstance(node, syntax.ProcedureCall | syntax.Call):
                for called in known.get(node.name.lower(), ()):
                    if id(called) not in seen:
                        seen.add(id(called))
                        blocks.append((called.body, _own(called)))
            used = [node.name.lower()] if isinstance(node, syntax.Name) else []
            yield from (name for name in (_changed(node, known) if written else used) if name not in own)


def _changed(node: syntax.Node, known: Mapping[str, Sequence[syntax.Routine]]) -> Iterator[str]:
    given: list[object] = []
    if isinstance(node, syntax.Assign):
        given = [node.target]
    elif isinstance(node, syntax.ProcedureCall | syntax.Call):
        name = node.name.lower()
        modes = [parameter.mode for one in known.get(name, ()) for parameter in one.parameters]
        if name in _WRITES or name.startswith("search") or any(mode is not None for mode in modes):
            given = [argument.value for argument in node.args]
    for thing in given:
        while isinstance(thing, syntax.Component | syntax.Element):
            thing = thing.base
        if isinstance(thing, syntax.Name):
            yield thing.name.lower()


def _own(routine: syntax.Routine) -> set[str]:
    names = {parameter.name.lower() for parameter in routine.parameters}
    return names | {
        node.name.lower() for node in nodes(routine.body) if isinstance(node, syntax.DataDeclaration | syntax.For)
    }


def _left_behind(group: Group) -> Iterator[str]:
    """Outputs that parts leave at different values, and conditions that wait for an output of another part."""
    last: dict[str, tuple[float, str]] = {}
    for part in group.parts:
        inside = group.job.program.motions[slice(*part.motions)]
        own = {one.signal.lower(): one.value for one in inside if isinstance(one, SignalEvent)}
        for signal, value in own.items():
            before = last.setdefault(signal, (value, part.name))
            if before[0] != value:
                yield f"{signal} is left at {before[0]:g} by {before[1]} and at {value:g} by {part.name}"
        for other in group.parts:
            conditions = [
                one.condition.lower()
                for one in group.job.program.motions[slice(*other.motions)]
                if isinstance(one, Wait) and one.condition
            ]
            for signal in own if other is not part else ():
                if any(re.search(rf"\b{re.escape(signal)}\b", text) for text in conditions):
                    yield f"{signal} is set in {part.name} and waited for in {other.name}"
