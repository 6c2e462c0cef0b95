"""What names of a program stand for at a place of its text, and where new declarations may go."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass
from functools import cached_property

from trajopt_cli.motion import Move, Span, TextFile
from trajopt_cli.rapid.language.lexer import scan
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import (
    AliasDeclaration,
    Assign,
    Call,
    Component,
    DataDeclaration,
    Element,
    For,
    If,
    LateCall,
    Module,
    Name,
    Node,
    ProcedureCall,
    RecordDeclaration,
    Routine,
    String,
)

# What a name stands for: something of the routine or of the module that begins at that offset of that file, or None
# for what all modules share (predefined names and signals included).
Owner = tuple[str, int] | None
_POSITIONS = ("robtarget", "jointtarget", "pose", "pos", "orient")


@dataclass(eq=False)
class _Module:
    node: Module
    own: set[str] = field(default_factory=set)  # LOCAL names
    data: dict[str, Span] = field(default_factory=dict)  # where each is declared
    declared: dict[str, DataDeclaration] = field(default_factory=dict)
    routines: list[Routine] = field(default_factory=list)
    locals: dict[int, set[str]] = field(default_factory=dict)  # by start of the routine


class Scopes:
    """The parsed files of a program."""

    def __init__(self, files: Mapping[str, TextFile]):
        self._files = files
        self._modules: dict[str, list[_Module]] = {}
        self._paths: dict[int, str] = {}  # of routines
        self.compact: set[Span] = set()
        self.procedures: dict[str, list[Routine]] = {}
        for path, file in files.items():
            self._modules[path] = [self._read(path, node) for node in parse_module(file.text, path).modules]

    def _read(self, path: str, node: Module) -> _Module:
        module = _Module(node)
        for item in node.items:
            if isinstance(item, Routine):
                module.routines.append(item)
                self.procedures.setdefault(item.name.lower(), []).append(item)
                self._paths[id(item)] = path
                for inner in nodes(item.body):
                    if isinstance(inner, If) and inner.compact:
                        body = inner.branches[0][1][0]
                        self.compact.add(Span(path, body.start, body.end))
            if isinstance(item, DataDeclaration):
                module.data.setdefault(item.name.lower(), Span(path, item.start, item.end))
                module.declared.setdefault(item.name.lower(), item)
            if getattr(item, "scope", None) == "LOCAL":
                module.own.add(getattr(item, "name", "").lower())
        return module

    def routines(self) -> Iterator[tuple[str, Routine]]:
        """Every routine with its file."""
        for path, several in self._modules.items():
            yield from ((path, routine) for module in several for routine in module.routines)

    def reached(self, entry: str) -> Iterator[tuple[str, Routine]]:
        """The routines that run from an entry on, as far as the text tells, and all TRAPs, with their files."""
        stack = [routine for _, routine in self.routines() if routine.kind == "TRAP"]
        stack += self.procedures.get(entry.lower(), ())
        seen: set[int] = set()
        while stack:
            routine = stack.pop()
            if id(routine) in seen:
                continue
            seen.add(id(routine))
            for name in called_names((routine.body, routine.handlers)):
                stack += [one for _, one in self.routines()] if name is None else self.procedures.get(name, ())
        return ((path, routine) for path, routine in self.routines() if id(routine) in seen)

    def module_data(self) -> Iterator[tuple[str, DataDeclaration]]:
        """Every declaration of a module's data with its file."""
        for path, several in self._modules.items():
            yield from ((path, data) for module in several for data in module.declared.values())

    def path_of(self, routine: Routine) -> str:
        """The file that a routine stands in."""
        return self._paths[id(routine)]

    def _module(self, path: str, offset: int) -> _Module | None:
        modules = self._modules[path]
        i = bisect_right([module.node.start for module in modules], offset) - 1
        return modules[i] if i >= 0 else None

    def routine(self, path: str, offset: int) -> Routine | None:
        """The routine around an offset."""
        module = self._module(path, offset)
        if module is None:
            return None
        i = bisect_right([routine.start for routine in module.routines], offset) - 1
        return module.routines[i] if i >= 0 and offset < module.routines[i].end else None

    def owner(self, name: str, path: str, offset: int) -> Owner:
        """What a name stands for at a place."""
        module, routine, key = self._module(path, offset), self.routine(path, offset), name.lower()
        if module is None:
            return None
        if routine is not None:
            if routine.start not in module.locals:
                module.locals[routine.start] = _names_of(routine)
            if key in module.locals[routine.start]:
                return path, routine.start
        return (path, module.node.start) if key in module.own else None

    def shared(self, text: str, path: str, offset: int) -> str | None:
        """The first name in a piece of code that another module would not see as the code at this place does."""
        return next((name for name in names_in(text) if self.owner(name, path, offset) is not None), None)

    def same(self, text: str, one: tuple[str, int], other: tuple[str, int]) -> bool:
        """Whether the names in a piece of code stand for the same at two places."""
        return all(self.owner(name, *one) == self.owner(name, *other) for name in names_in(text))

    def head(self, path: str, offset: int) -> tuple[int, bool]:
        """Where a declaration for the whole module may be put, and whether that is the end of a line's code.

        Behind the module's line, or behind its RECORDs and ALIASes, which RAPID wants first.
        """
        text, module = self._files[path].text, self._module(path, offset)
        if module is None or not module.node.name:
            return 0, False
        first = [item for item in module.node.items if isinstance(item, RecordDeclaration | AliasDeclaration)]
        if first:
            return first[-1].end, True
        tokens = scan(text[module.node.start : module.node.start + 400])
        last = 1  # MODULE, its name, and what stands in parentheses
        if tokens.kinds[2] == "(":
            last = tokens.kinds.index(")", 2)
        return module.node.start + tokens.starts[last] + len(tokens.texts[last]), True

    def declaration(self, name: str, path: str, offset: int) -> Span | None:
        """The declaration of a module's data that a name stands for at a place, if it is in the same module."""
        module, routine, key = self._module(path, offset), self.routine(path, offset), name.lower()
        if module is None or (routine is not None and self.owner(name, path, offset) == (path, routine.start)):
            return None
        return module.data.get(key)

    def depends_on(self, move: Move) -> str | None:
        """The variable that a move's target depends on, None for none."""
        at = move.written.target
        return None if at is None else self.variable(move.target, at.file, at.start)

    def variable(self, text: str, path: str, offset: int) -> str | None:
        """The first name in a piece of code that may have another value at another time; None where none has.

        Parameters, counters of loops, VAR and PERS; not positions that no statement changes: those are taught.
        """
        return self._variable(names_in(text), path, offset, set())

    def _variable(self, names: Iterable[str], path: str, offset: int, seen: set[str]) -> str | None:
        routine = self.routine(path, offset)
        for name in names:
            key = name.lower()
            if routine is not None and self.owner(name, path, offset) == (path, routine.start):
                inside = (node for node in nodes(routine.body) if isinstance(node, DataDeclaration))
                local = next((node for node in inside if node.name.lower() == key), None)
                if local is None or local.storage != "CONST":
                    return name
            elif (data := self._declared(key, path, offset)) is not None:
                taught = data.type.lower() in _POSITIONS and key not in self._changed
                if data.storage != "CONST" and not taught:
                    return name
            elif key not in seen:
                seen.add(key)
                found = (self._variable_inside(routine, seen) for routine in self.procedures.get(key, ()))
                if (inner := next((one for one in found if one is not None), None)) is not None:
                    return inner
        return None

    def _variable_inside(self, routine: Routine, seen: set[str]) -> str | None:
        """As _variable, for what a function reads besides its own names."""
        path, own = self._paths[id(routine)], _names_of(routine)
        names = (node.name for node in nodes(routine.body) if isinstance(node, Name | Call))
        return self._variable((name for name in names if name.lower() not in own), path, routine.start, seen)

    def _declared(self, key: str, path: str, offset: int) -> DataDeclaration | None:
        """The declaration of a module's data that a name stands for at a place, in whichever module."""
        module = self._module(path, offset)
        if module is not None and key in module.declared:
            return module.declared[key]
        every = (one for several in self._modules.values() for one in several)
        return next((one.declared[key] for one in every if key in one.declared and key not in one.own), None)

    @cached_property
    def _changed(self) -> set[str]:
        """The names that some statement assigns, or hands to a routine or a search that may."""
        out = set()
        for several in self._modules.values():
            for node in (node for module in several for node in nodes(module.node.items)):
                given: list[object] = []
                if isinstance(node, Assign):
                    given = [node.target]
                elif isinstance(node, ProcedureCall | Call) and not node.name.lower().startswith("move"):
                    given = [argument.value for argument in node.args if not isinstance(argument.value, Call)]
                    given = given if self._may_change(node.name) else []
                for thing in given:
                    while isinstance(thing, Component | Element):
                        thing = thing.base
                    if isinstance(thing, Name):
                        out.add(thing.name.lower())
        return out

    def _may_change(self, routine: str) -> bool:
        """Whether a routine may change what it is given by name: a search, or one of the program that says so."""
        called = self.procedures.get(routine.lower(), ())
        modes = (parameter.mode for one in called for parameter in one.parameters)
        return routine.lower().startswith("search") or any(mode is not None for mode in modes)

    def instructions(self, span: Span) -> Iterator[Node]:
        """All nodes in a stretch of statements and in the procedures and functions that they call."""
        routine = self.routine(span.file, span.start)
        seen: set[int] = set()
        bodies: list[Iterable[Node]] = []
        if routine is not None:
            bodies.append(node for node in nodes(routine.body) if span.start <= node.start and node.end <= span.end)
        while bodies:
            for node in bodies.pop():
                yield node
                if isinstance(node, ProcedureCall | Call):
                    for called in self.procedures.get(node.name.lower(), ()):
                        if id(called) not in seen:
                            seen.add(id(called))
                            bodies.append(nodes(called.body))


def names_in(text: str) -> Iterator[str]:
    r"""Names of data and routines in a piece of code; those of options (\WObj), parameters (Speed:=v100) and components
    (.x) are none."""
    tokens = scan(text)
    for i, kind in enumerate(tokens.kinds):
        if kind != "name" or tokens.kinds[i + 1] == ":=":
            continue
        if i == 0 or tokens.kinds[i - 1] not in ("\\", "."):
            yield tokens.texts[i]


def nodes(thing: object) -> Iterator[Node]:
    """Every node under a node or a block, itself included, outer ones first."""
    stack = [thing]
    while stack:
        top = stack.pop()
        if isinstance(top, tuple):
            stack += reversed(top)
        elif isinstance(top, Node):
            yield top
            if is_dataclass(top):
                stack += [getattr(top, part.name) for part in reversed(fields(top))]


def called_names(thing: object) -> Iterator[str | None]:
    """What a node or a block calls, in lower case; None: it may be anything."""
    for one in nodes(thing):
        if isinstance(one, ProcedureCall | Call):
            yield one.name.lower()
        elif isinstance(one, LateCall):
            yield one.name.value.rsplit(":", 1)[-1].lower() if isinstance(one.name, String) else None


def _names_of(routine: Routine) -> set[str]:
    names = {parameter.name.lower() for parameter in routine.parameters}
    names |= {node.name.lower() for node in nodes(routine.body) if isinstance(node, DataDeclaration | For)}
    return names
