"""A program with a copy of its routines for each call of them, so that the executions of a text can be told apart.

A call of a procedure that moves gets a copy of its own, but the first one; FOR loops with constant bounds around such
calls are written out. Names keep their meaning: a copy stands behind its routine. Nothing else changes, so whatever the
program reads at run time it reads as before.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace

from trajopt_cli.motion import Program
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.problem.scopes import Scopes, nodes
from trajopt_cli.rapid.language.lexer import scan
from trajopt_cli.rapid.language.syntax import For, Label, LateCall, Node, Number, ProcedureCall, Routine
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario

_MOST = 2_000_000  # characters that copies may add
_NAME_LIMIT = 32
_MARKED = re.compile(r"[ \t]*!\s*trajopt\s*:", re.IGNORECASE)

Edit = tuple[int, int, str]


def unrolled(program: Program, plant: Plant, scenario: Scenario, routines: Collection[str] | None = None) -> Program:
    """The program with copies, read again; as given where there is nothing to copy.

    routines: names in lower case of those of which copies are wanted; None: all. Raises InputError as reading does.
    """
    texts = _Copies(Scopes(program.files), program, routines).texts()
    if all(texts[path] == file.text for path, file in program.files.items()):
        return program
    files = [replace(file, text=texts[path]) for path, file in program.files.items()]
    world = scenario.without_lines  # their lines are those as given
    read = run_program(files, world, program.entry, PlantKinematics(plant.at_home))
    same = len(read.motions) == len(program.motions)
    if not same or any(type(a) is not type(b) for a, b in zip(program.motions, read.motions, strict=True)):
        return program  # a routine that looks at its own name, or the like
    pairs = zip(program.motions, read.motions, strict=True)
    return replace(program, files=read.files, motions=tuple(replace(a, written=b.written) for a, b in pairs))


@dataclass
class _Copies:
    scopes: Scopes
    program: Program
    wanted: Collection[str] | None
    _edits: dict[str, list[Edit]] = field(default_factory=dict)
    _behind: dict[int, list[str]] = field(default_factory=dict)  # copies, by the routine's id
    _seen: set[int] = field(default_factory=set)  # routines that a call has taken for itself
    _size: int = 0

    def texts(self) -> dict[str, str]:
        """All files with the copies."""
        self._used = {word.lower() for file in self.program.files.values() for word in _names(file.text)}
        moving = {motion.written.statement for motion in self.program.motions}
        self._moving = {id(self.scopes.routine(span.file, span.start)) for span in moving}
        entry = next(iter(self.scopes.procedures.get(self.program.entry.lower(), ())), None)
        self._edits = {path: [] for path in self.program.files}
        if entry is not None:
            path = self.scopes.path_of(entry)
            self._seen.add(id(entry))
            self._edits[path] += self._inside(entry, path, (entry,), first=True)
        for key, copies in self._behind.items():
            routine = next(one for several in self.scopes.procedures.values() for one in several if id(one) == key)
            path = self.scopes.path_of(routine)
            self._edits[path].append((routine.end, routine.end, "".join(copies)))
        return {path: _edited(file.text, self._edits[path], 0) for path, file in self.program.files.items()}

    def _copied(self, node: Node, around: tuple[Routine, ...]) -> Routine | None:
        """The procedure that a call asks for, if a copy of it may tell its executions apart."""
        if not isinstance(node, ProcedureCall):
            return None
        found = self.scopes.procedures.get(node.name.lower(), ())
        if len(found) != 1 or found[0].kind != "PROC" or found[0] in around:
            return None
        if self.wanted is not None and not self._reaches(found[0], self.wanted, set()):
            return None
        return found[0] if self._moves(found[0], set()) else None

    def _moves(self, routine: Routine, seen: set[int]) -> bool:
        return any(id(one) in self._moving for one in self._called(routine, seen))

    def _reaches(self, routine: Routine, names: Collection[str], seen: set[int]) -> bool:
        return any(one.name.lower() in names for one in self._called(routine, seen))

    def _called(self, routine: Routine, seen: set[int]) -> Iterator[Routine]:
        """A routine and all that it calls."""
        if id(routine) in seen:
            return
        seen.add(id(routine))
        yield routine
        for node in nodes(routine.body):
            for one in self.scopes.procedures.get(getattr(node, "name", ""), ()) if isinstance(node, LateCall) else ():
                yield from self._called(one, seen)
            if isinstance(node, ProcedureCall):
                for one in self.scopes.procedures.get(node.name.lower(), ()):
                    yield from self._called(one, seen)

    def _inside(self, routine: Routine, path: str, around: tuple[Routine, ...], first: bool) -> list[Edit]:
        """The edits inside a routine, or a copy of it. first: the calls in it may be first ones."""
        return list(self._block(routine.body, path, around, first, {}))

    def _block(
        self, block: object, path: str, around: tuple[Routine, ...], first: bool, counters: Mapping[str, int]
    ) -> Iterator[Edit]:
        stack = [*reversed(block)] if isinstance(block, tuple) else [block]
        while stack:
            node = stack.pop()
            if isinstance(node, tuple):
                stack += reversed(node)
            elif isinstance(node, For) and (passes := self._passes(node, path, around)) is not None:
                text = self.program.files[path].text
                parts = []
                for value in passes:
                    now = {**counters, node.name.lower(): value}
                    edits = [*self._block(node.body, path, around, first, now), *_counted(text, node, now)]
                    start, end = _body(text, node)
                    inner, outer = _gap(text, node.body[0].start), _gap(text, node.start)
                    parts.append(_edited(text[start:end], edits, start).replace(inner, outer).strip())
                    self._size += end - start
                yield node.start, node.end, _gap(text, node.start).join(parts)
            elif isinstance(node, ProcedureCall):
                routine = self._copied(node, around)
                if routine is not None and self._size < _MOST:
                    name = self._copy(routine, (*around, routine), first)
                    yield node.start, node.start + len(node.name), name
            elif isinstance(node, Node):
                stack += [getattr(node, name) for name in reversed(_PARTS) if hasattr(node, name)]

    def _copy(self, routine: Routine, around: tuple[Routine, ...], first: bool) -> str:
        """The name of the copy that a call has for itself; the routine's own for the first call of all."""
        path = self.scopes.path_of(routine)
        text = self.program.files[path].text
        if first and id(routine) not in self._seen:
            self._seen.add(id(routine))
            self._edits[path] += self._inside(routine, path, around, first)
            return routine.name
        self._seen.add(id(routine))
        name = self._new(routine.name)
        edits = self._inside(routine, path, around, first=False)
        at = routine.start + text[routine.start : routine.end].index(
            routine.name, text[routine.start :].upper().index("PROC") + 4
        )
        edits.append((at, at + len(routine.name), name))
        gap = _gap(text, routine.start)
        copies = self._behind.setdefault(id(routine), [])
        copies.append(f"{gap}{_edited(text[routine.start : routine.end], edits, routine.start)}")
        self._size += routine.end - routine.start
        return name

    def _passes(self, loop: For, path: str, around: tuple[Routine, ...]) -> list[int] | None:
        """The values of a loop that is written out: with constant bounds, around calls that get copies."""
        inside = [*nodes(loop.body)]
        text = self.program.files[path].text
        if not loop.body or any(isinstance(node, Label) for node in inside):
            return None
        if _MARKED.match(text, _body(text, loop)[0]):  # which would mark one statement of many
            return None
        if any(isinstance(node, For) and node.name.lower() == loop.name.lower() for node in inside):
            return None
        if not any(self._copied(node, around) for node in inside):
            return None
        bounds = [loop.first, loop.last, *([] if loop.step is None else [loop.step])]
        numbers = [int(one.value) for one in bounds if isinstance(one, Number) and one.value == int(one.value)]
        if len(numbers) < len(bounds) or (len(numbers) == 3 and numbers[2] == 0):
            return None
        first, last = numbers[:2]
        step = numbers[2] if len(numbers) == 3 else 1 if first <= last else -1
        values = list(range(first, last + (1 if step > 0 else -1), step))
        return values if values and len(values) * (loop.end - loop.start) + self._size <= _MOST else None

    def _new(self, base: str) -> str:
        number = 2
        while True:
            name = f"{base[: _NAME_LIMIT - len(str(number)) - 1]}_{number}"
            if name.lower() not in self._used:
                self._used.add(name.lower())
                return name
            number += 1


_PARTS = ("branches", "otherwise", "body", "cases", "default")  # of statements: what holds others


def _counted(text: str, loop: For, counters: Mapping[str, int]) -> Iterator[Edit]:
    """The values of counters in their places in a loop's body."""
    start, end = _body(text, loop)
    tokens = scan(text[start:end])
    for i, kind in enumerate(tokens.kinds):
        before = tokens.kinds[i - 1] if i else ""
        value = counters.get(tokens.texts[i].lower()) if kind == "name" and before not in ("\\", ".") else None
        if value is not None and tokens.kinds[i + 1] != ":=":
            at = start + tokens.starts[i]
            yield at, at + len(tokens.texts[i]), f"({value})" if value < 0 else str(value)


def _body(text: str, loop: For) -> tuple[int, int]:
    """From behind DO to before ENDFOR, comments included."""
    bound = (loop.step or loop.last).end
    return bound + text[bound : loop.body[0].start].upper().index("DO") + 2, loop.end - len("ENDFOR")


def _edited(text: str, edits: list[Edit], offset: int) -> str:
    """A stretch that begins at an offset with edits made; of those inside another one the other counts."""
    parts, at = [], 0
    for start, end, new in sorted(edits, key=lambda edit: (edit[0], -edit[1])):
        if start - offset >= at:
            parts += [text[at : start - offset], new]
            at = end - offset
    return "".join(parts) + text[at:]


def _gap(text: str, start: int) -> str:
    """A line end and the indentation of the line that start is on."""
    begin = max(text.rfind("\n", 0, start), text.rfind("\r", 0, start)) + 1
    line = text[begin:start]
    end = "\r\n" if "\r\n" in text else "\r" if "\r" in text and "\n" not in text else "\n"
    return end + line[: len(line) - len(line.lstrip())]


def _names(text: str) -> Iterator[str]:
    tokens = scan(text)
    return (word for kind, word in zip(tokens.kinds, tokens.texts, strict=True) if kind == "name")
