"""What names of a program stand for at a place of its text, where statements stand, and where declarations may go."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field, fields
from functools import cached_property

from trajopt_cli.motion import Span, TextFile
from trajopt_cli.rapid.data.predefined import predefined
from trajopt_cli.rapid.language.lexer import scan
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    AliasDeclaration,
    Assign,
    Block,
    Call,
    Component,
    DataDeclaration,
    Element,
    Expression,
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
    Test,
    While,
)

# What a name stands for: something of the routine or of the module that begins at that offset of that file, or None
# for what all modules share (predefined names and signals included).
Owner = tuple[str, int] | None
_MOVES = re.compile(r"(Move|Trigg)\w*|(Arc|Disp|Paint|Cap)[LC]\w*|Spot(ML|[JL])\w*", re.IGNORECASE)
# The functions that an export writes: a target with the rail or the configuration elsewhere.
_WRAPPERS = re.compile(
    r"LOCAL FUNC (robtarget|jointtarget) (?P<name>\w+)\(\1 p,(num rail\w*(,num rail\w*)*"
    r"(\\confdata conf)?|confdata conf)\) "
    r"(p\.extax\.eax_[a-f]:=rail\w*; )*((IF Present\(conf\) )?p\.robconf:=conf; )?RETURN p; ENDFUNC"
)
_PURE = frozenset(("offs", "reltool", "abs", "sqrt", "sin", "cos", "round", "trunc"))
_SHIFTS = ("offs", "reltool")  # their target has the external axes and the configuration of the one they are given


@dataclass(frozen=True, eq=False)
class Place:
    """Where a statement stands: its routine, the FOR loops around it there, the outermost first, and its block.
    compact: it is part of an IF without THEN."""

    routine: Routine
    loops: tuple[For, ...]
    block: Block
    compact: bool


@dataclass(eq=False)
class _Module:
    node: Module
    own: set[str] = field(default_factory=set)  # LOCAL names
    data: dict[str, DataDeclaration] = field(default_factory=dict)
    routines: list[Routine] = field(default_factory=list)
    locals: dict[int, set[str]] = field(default_factory=dict)  # by start of the routine


class Scopes:
    """The parsed files of a program."""

    def __init__(self, files: Mapping[str, TextFile]):
        self.files = files
        self._modules: dict[str, list[_Module]] = {}
        self._paths: dict[int, str] = {}  # of routines
        self.places: dict[tuple[str, int], Place] = {}  # of statements, by file and offset
        self.procedures: dict[str, list[Routine]] = {}
        self._wrappers: dict[tuple[Owner, str], str] = {}  # texts of functions that an export has written
        for path, file in files.items():
            self._modules[path] = [self._read(path, node) for node in parse_module(file.text, path).modules]

    def _read(self, path: str, node: Module) -> _Module:
        module = _Module(node)
        for item in node.items:
            if isinstance(item, Routine):
                module.routines.append(item)
                self.procedures.setdefault(item.name.lower(), []).append(item)
                self._paths[id(item)] = path
                if item.kind == "FUNC":
                    text = " ".join(self.files[path].text[item.start : item.end].split())
                    if _WRAPPERS.fullmatch(text):
                        self._wrappers[(path, node.start), item.name.lower()] = text.removeprefix("LOCAL ")
                for block in (item.body, *(handler.body for handler in item.handlers)):
                    self._place(path, item, block, ())
            if isinstance(item, DataDeclaration):
                module.data.setdefault(item.name.lower(), item)
            if getattr(item, "scope", None) == "LOCAL":
                module.own.add(getattr(item, "name", "").lower())
        return module

    def _place(self, path: str, routine: Routine, block: Block, loops: tuple[For, ...], compact: bool = False) -> None:
        for node in block:
            self.places[path, node.start] = Place(routine, loops, block, compact)
            match node:
                case If():
                    for _, inner in (*node.branches, (None, node.otherwise)):
                        self._place(path, routine, inner, loops, node.compact)
                case For():
                    self._place(path, routine, node.body, (*loops, node))
                case While():
                    self._place(path, routine, node.body, loops)
                case Test():
                    for inner in (*(inner for _, inner in node.cases), node.default or ()):
                        self._place(path, routine, inner, loops)

    def place(self, span: Span) -> Place | None:
        """Where a statement stands; None for a call in an expression."""
        return self.places.get((span.file, span.start))

    def text(self, span: Span) -> str:
        """The text between two places of a file."""
        return self.files[span.file].text[span.start : span.end]

    def path_of(self, routine: Routine) -> str:
        """The file that a routine stands in."""
        return self._paths[id(routine)]

    def module(self, path: str, offset: int) -> Module | None:
        """The module around an offset."""
        found = self._module(path, offset)
        return None if found is None else found.node

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

    def same(self, text: str, one: Span, other: Span) -> bool:
        """Whether the names in a piece of code stand for the same at two places."""
        return all(
            self.owner(name, one.file, one.start) == self.owner(name, other.file, other.start)
            for name in names_in(text)
        )

    def head(self, path: str, offset: int) -> tuple[int, bool]:
        """Where a declaration for the whole module may be put, and whether that is the end of a line's code.

        Behind the module's line, or behind its RECORDs and ALIASes, which RAPID wants first.
        """
        text, module = self.files[path].text, self._module(path, offset)
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

    def declared(self, name: str, path: str, offset: int) -> tuple[str, DataDeclaration] | None:
        """The file and the declaration of the data that a name stands for at a place; None where it is none, as a
        parameter, or several modules declare it."""
        owner, key = self.owner(name, path, offset), name.lower()
        module, routine = self._module(path, offset), self.routine(path, offset)
        if module is not None and owner == (path, module.node.start):
            return (path, module.data[key]) if key in module.data else None
        if routine is not None and owner == (path, routine.start):
            own = [node for node in nodes(routine.body) if isinstance(node, DataDeclaration | For)]
            found = [node for node in own if node.name.lower() == key]
            one = found[0] if len(found) == 1 else None
            return (path, one) if isinstance(one, DataDeclaration) else None
        every = self._shared.get(key, ())
        return every[0] if len(every) == 1 else None

    @cached_property
    def _shared(self) -> Mapping[str, list[tuple[str, DataDeclaration]]]:
        """The data that all modules see."""
        found: dict[str, list[tuple[str, DataDeclaration]]] = defaultdict(list)
        for path, several in self._modules.items():
            for module in several:
                for key, data in module.data.items():
                    if key not in module.own:
                        found[key].append((path, data))
        return found

    # ------------------------------------------------------------------------------------------------------- targets

    def base(self, target: Expression) -> Name | Aggregate | None:
        """What gives a target its external axes and configuration: a name or a literal; None for another function's
        result, a parameter's element or the like."""
        while isinstance(target, Call) and target.name.lower() in {*_SHIFTS} - self.procedures.keys():
            first = next((one.value for one in target.args if one.name is None), None)
            if first is None:
                return None
            target = first
        return target if isinstance(target, Name | Aggregate) else None

    def wrappers(self, place: Span) -> Mapping[str, str]:
        """The functions that an export has written into the module around a place: texts by names in lower case."""
        module = self._module(place.file, place.start)
        owner = None if module is None else (place.file, module.node.start)
        return {name: text for (one, name), text in self._wrappers.items() if one == owner}

    @cached_property
    def _uses(self) -> Mapping[tuple[str, int], list[tuple[str, int]]]:
        """Where data is named, by its declaration's file and offset: the moves whose target it is, as places of
        statements; for any other use, and in texts, a place that is none."""
        targets: dict[int, int] = {}
        found: dict[tuple[str, int], list[tuple[str, int]]] = defaultdict(list)
        for path, several in self._modules.items():
            for node in (one for module in several for one in nodes(module.node.items)):
                if isinstance(node, ProcedureCall) and _MOVES.fullmatch(node.name):
                    given = [one.value for one in node.args if one.name is None and one.value is not None][:2]
                    targets |= {id(self.base(one)): node.start for one in given}
                elif isinstance(node, Name | String):  # a text may be what SetDataVal asks for
                    name = node.name if isinstance(node, Name) else node.value
                    if (data := self.declared(name, path, node.start)) is not None:
                        found[data[0], data[1].start].append((path, targets.get(id(node), -1)))
        return found

    def named(self, declaration: Span) -> int:
        """How often data is named."""
        return len(self._uses[declaration.file, declaration.start])

    def serves_moves(self, name: Name, path: str, ran: Set[tuple[str, int]]) -> Span | None:
        """The literal in the declaration of a name that nothing but moves that ran refer to, as target or as what Offs
        and RelTool shift; None where it is none. ran: places of statements."""
        data = self.declared(name.name, path, name.start)
        if data is None or data[1].sizes or not isinstance(data[1].value, Aggregate):
            return None
        if data[1].type.lower() not in ("robtarget", "jointtarget"):
            return None
        if not all(use in ran for use in self._uses[data[0], data[1].start]):
            return None
        return Span(data[0], data[1].value.start, data[1].value.end)

    # ----------------------------------------------------------------------------------------------------- variables

    def repeats(self, text: str, place: Span, later: Span) -> bool:
        """Whether an expression at a place means the same at a later statement that runs behind it: it names what
        nothing changes, or both stand in one block, and nothing between them changes data."""
        if not self.same(text, place, later):
            return False
        names = [name.lower() for name in names_in(text)]
        calls = {name for name in names if name in _PURE and name not in self.procedures}
        if all(name in calls or self._steady(name, place) for name in names):
            return True
        here, there = self.place(place), self.place(later)
        if here is None or there is None or here.block is not there.block:
            return False
        between = [node for node in here.block if place.start < node.start < later.start]
        mentioned = {node.name.lower() for one in between for node in nodes(one) if isinstance(node, Name)}
        quiet = all(isinstance(one, ProcedureCall) and one.name.lower() not in self.procedures for one in between)
        known = all(name in calls or self._is_data(name, place) for name in names)
        return quiet and known and not mentioned & set(names)

    def _is_data(self, name: str, place: Span) -> bool:
        return name not in self.procedures and (name in predefined() or self.owner(name, place.file, place.start)
                                                is not None or name in self._shared)  # fmt: skip

    def _steady(self, name: str, place: Span) -> bool:
        """Whether a name is data that no statement changes."""
        data = self.declared(name, place.file, place.start)
        if data is None:
            return name in predefined() and self.owner(name, place.file, place.start) is None
        return data[1].storage == "CONST" or name not in self._changed

    @cached_property
    def _changed(self) -> set[str]:
        """The names that some statement assigns, or gives to something that may."""
        out = set()
        for node in (
            one for several in self._modules.values() for module in several for one in nodes(module.node.items)
        ):
            given: list[object] = []
            if isinstance(node, Assign):
                given = [node.target]
            elif isinstance(node, ProcedureCall | Call | LateCall):
                moves = isinstance(node, ProcedureCall) and _MOVES.fullmatch(node.name)
                given = [] if moves else [argument.value for argument in node.args]
            for thing in given:
                while isinstance(thing, Component | Element):
                    thing = thing.base
                if isinstance(thing, Name):
                    out.add(thing.name.lower())
        return out


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
            if not isinstance(top, Aggregate):
                stack += [getattr(top, part.name) for part in reversed(fields(top))]
            elif top.numbers is None:
                stack += reversed(top.items)


def _names_of(routine: Routine) -> set[str]:
    names = {parameter.name.lower() for parameter in routine.parameters}
    names |= {node.name.lower() for node in nodes(routine.body) if isinstance(node, DataDeclaration | For)}
    return names
