"""What the values of a program depend on, found in its syntax tree: assignments, calls and the conditions around them.

The analysis ignores the order of statements, so it may find a dependence that no run has, but misses none.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from trajopt_cli.problem.scopes import Owner, Scopes
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    Argument,
    Assign,
    Binary,
    Block,
    Boolean,
    Call,
    Component,
    DataDeclaration,
    Element,
    Expression,
    For,
    Goto,
    If,
    Label,
    LateCall,
    Name,
    Node,
    Number,
    ProcedureCall,
    Return,
    Routine,
    String,
    Test,
    Unary,
    While,
)
from trajopt_cli.scenario import Scenario

Key = tuple[Owner, str]  # data: what owns it, and its name in lower case
ROBOT: Key = (None, "where the robot is")
_STEPS = re.compile(r"incr|decr|add|clear|bitset|bitclear|tryint", re.IGNORECASE)  # change their first argument
_FILLS = re.compile(r"tpread|ui|clkread|read|get|unpack|socketreceive|strtobyte", re.IGNORECASE)  # change any
_POSITION = re.compile(r"(c|calc)(robt|jointt|pos)\Z", re.IGNORECASE)
_FRAMES = ("trans", "rot")  # of a target: neither external axes nor configuration


@dataclass(frozen=True, eq=False)
class Branch:
    """A block that runs or repeats as its conditions say. endless: a loop that no condition ends."""

    start: int
    end: int
    conditions: tuple[Expression, ...]
    loop: bool = False
    endless: bool = False


@dataclass(frozen=True, eq=False)
class Place:
    """Where a statement stands: offset in its file, its routine (None: a declaration) and the branches around it."""

    path: str
    start: int
    routine: Routine | None = None
    branches: tuple[Branch, ...] = ()


@dataclass(frozen=True, eq=False)
class Change:
    """A statement that gives data a value. whole: it replaces all of it. within: the offsets between which alone it is
    seen, as a loop's counter is. given: at every call, as a parameter. label: what of the scenario gives the value."""

    key: Key
    reads: tuple[Expression, ...]
    place: Place
    within: tuple[int, int] | None = None
    given: bool = False
    label: str | None = None


@dataclass
class Trace:
    """What an expression depends on. labels: things of the scenario. keys: data, with the elements that are read of it
    (None: any). changes: the statements that give them their values."""

    labels: set[str] = field(default_factory=set)
    keys: dict[Key, set[int] | None] = field(default_factory=dict)
    changes: set[Change] = field(default_factory=set)

    def reads(self, key: Key, element: int | None) -> bool:
        """Whether data is read, of an array an element (from 1)."""
        if key not in self.keys:
            return False
        elements = self.keys[key]
        return elements is None or element is None or element in elements


class DataFlow:
    """Every change of data in a program, and what values depend on. endless: a loop in it never ends."""

    def __init__(self, scopes: Scopes, scenario: Scenario, entry: str, endless: bool):
        self.scopes = scopes
        self.order = [
            *(f"signal {name}" for name in scenario.signals),
            *(f"answer {name}" for name in scenario.answers),
            *(f"data {name}" for name in scenario.data),
            *(f"search {name}" for name in scenario.searches),
            "endless_passes",
        ]
        self._labels = {
            what: {name.lower(): f"{what} {name}" for name in names}
            for what, names in (
                ("signal", scenario.signals),
                ("answer", scenario.answers),
                ("data", scenario.data),
                ("search", scenario.searches),
            )
        }
        self._endless = endless
        self.places: dict[tuple[str, int], Place] = {}  # of statements, by file and offset
        self.nodes: dict[tuple[str, int], Node] = {}
        self.before: dict[tuple[str, int], Node | None] = {}  # the statement before each in its block
        self.changes: dict[Key, list[Change]] = defaultdict(list)
        self.calls: dict[int, list[Place]] = defaultdict(list)  # by id of the routine
        self.branches: list[tuple[str, Routine, Branch]] = []
        self._returns: dict[int, list[Expression]] = defaultdict(list)
        for path, routine in scopes.reached(entry):
            self._block(routine.body, Place(path, routine.start, routine))
            for handler in routine.handlers:
                self._block(handler.body, Place(path, routine.start, routine))
        for path, data in scopes.module_data():
            if data.value is not None:
                self._change(data.name, (data.value,), Place(path, data.start))

    # ------------------------------------------------------------------------------------------------ the statements

    def _block(self, block: Block, around: Place) -> None:
        labels = {node.name.lower(): node for node in block if isinstance(node, Label)}
        for node in block:
            if isinstance(node, Goto) and (label := labels.get(node.label.lower())) and label.start < node.start:
                around = self._inside(around, Branch(label.start, node.end, (), True, True))
        for before, node in zip((None, *block), block, strict=False):
            self.before[around.path, node.start] = before
            place = Place(around.path, node.start, around.routine, around.branches)
            self.places[place.path, node.start] = place
            self.nodes[place.path, node.start] = node
            self._statement(node, place)

    def _inside(self, place: Place, branch: Branch) -> Place:
        assert place.routine is not None
        self.branches.append((place.path, place.routine, branch))
        return Place(place.path, place.start, place.routine, (*place.branches, branch))

    def _statement(self, node: Node, place: Place) -> None:
        match node:
            case Assign():
                part = () if isinstance(node.target, Name) else (node.target,)
                self._change(_root(node.target), (node.value, *part), place)
            case DataDeclaration() if node.value is not None:
                self._change(node.name, (node.value,), place)
            case ProcedureCall():
                self._call(node.name, node.args, place)
            case LateCall():
                name = node.name.value.rsplit(":", 1)[-1] if isinstance(node.name, String) else None
                for one in self.scopes.procedures if name is None else (name,):
                    self._call(one, node.args, place)
            case If():
                conditions = tuple(condition for condition, _ in node.branches)
                for _, block in (*node.branches, (None, node.otherwise)):
                    self._branch(block, place, conditions)
            case Test():
                values = tuple(one for several, _ in node.cases for one in several)
                for block in (*(block for _, block in node.cases), node.default or ()):
                    self._branch(block, place, (node.subject, *values))
            case For():
                bounds = tuple(one for one in (node.first, node.last, node.step) if one is not None)
                self._change(node.name, bounds, place, (node.start, node.end))
                self._block(node.body, self._inside(place, Branch(node.start, node.end, bounds, True)))
            case While():
                endless = isinstance(node.condition, Boolean) and node.condition.value
                branch = Branch(node.start, node.end, (node.condition,), True, endless)
                self._block(node.body, self._inside(place, branch))
            case Return() if node.value is not None:
                around = [one for branch in place.branches for one in branch.conditions]
                self._returns[id(place.routine)] += [node.value, *around]

    def _branch(self, block: Block, place: Place, conditions: tuple[Expression, ...]) -> None:
        if block:
            self._block(block, self._inside(place, Branch(block[0].start, block[-1].end, conditions)))

    def _change(
        self, name: str | None, reads: Iterable[Expression], place: Place,
        within: tuple[int, int] | None = None, label: str | None = None,
    ) -> None:  # fmt: skip
        if name is not None:
            key = self.key(name, place)
            self.changes[key].append(Change(key, tuple(reads), place, within, False, label))

    def _call(self, name: str, args: tuple[Argument, ...], place: Place) -> None:
        routines = self.scopes.procedures.get(name.lower(), ())
        required = [one for one in args if one.name is None]
        values = tuple(one.value for one in args if one.value is not None)
        for routine in routines:
            self.calls[id(routine)].append(place)
            path, taken = self.scopes.path_of(routine), iter(required)
            for parameter in routine.parameters:
                named = (one for one in args if one.name and one.name.lower() == parameter.name.lower())
                given = next(named if parameter.optional else taken, None)
                if given is None or given.value is None:
                    continue
                key = ((path, routine.start), parameter.name.lower())
                self.changes[key].append(Change(key, (given.value,), place, given=True))
                if parameter.mode is not None:
                    back = Name(routine.start, routine.start, parameter.name)
                    root = _root(given.value)
                    if root is not None:
                        there = self.key(root, place)
                        self.changes[there].append(Change(there, (back,), Place(path, routine.start, routine)))
        if routines:
            return
        if name.lower().startswith("search"):
            known = [one.name.lower() for one in _names(values) if isinstance(one, Name)]
            label = next((self._labels["search"][one] for one in known if one in self._labels["search"]), None)
            at = required[1].value if len(required) > 1 else None
            if at is not None:
                self._change(_root(at), (Name(place.start, place.start, ROBOT[1]),), place, label=label)
            return
        for i, one in enumerate(required):
            root = None if one.value is None else _root(one.value)
            if root is None:
                continue
            label = self._labels["answer"].get(root.lower())
            if label or _FILLS.match(name) or (i == 0 and _STEPS.match(name)):
                self._change(root, values, place, label=label)

    # -------------------------------------------------------------------------------------------------- dependences

    def key(self, name: str, place: Place) -> Key:
        """The data that a name stands for at a place."""
        return self.scopes.owner(name, place.path, place.start), name.lower()

    def trace(self, expressions: Iterable[Expression], place: Place, target: bool = False) -> Trace:
        """What expressions at a place depend on.

        target: they give a target, and what only its position and orientation depend on is left out. Conditions around
        the place itself are no dependences: where they do not hold, it does not run.
        """
        out, seen = Trace(), set[int]()
        context = self._context(place.routine, set()) | set(place.branches)
        stack: list[tuple[Expression, Place]] = [(one, place) for one in expressions]
        while stack:
            top, at = stack.pop()
            for node, element in _names_with_elements((top,), target):
                key, elements = self.key(node.name, at), None if element is None else {element}
                for what in ("signal", "data") if isinstance(node, Name) else ("answer",):
                    if key[1] in self._labels[what]:
                        out.labels.add(self._labels[what][key[1]])
                if isinstance(node, Call):
                    if _POSITION.match(node.name):
                        out.keys[ROBOT] = None
                    for routine in self.scopes.procedures.get(key[1], ()):
                        if id(routine) not in seen:
                            seen.add(id(routine))
                            inside = Place(self.scopes.path_of(routine), routine.start, routine)
                            stack += [(one, inside) for one in self._returns[id(routine)]]
                    continue
                before = out.keys.get(key, set())
                out.keys[key] = None if before is None or elements is None else before | elements
                for change in self.changes.get(key, ()):
                    if change in out.changes or not _sees(change, at) or self._later(change.place, place):
                        continue
                    out.changes.add(change)
                    out.labels |= set() if change.label is None else {change.label}
                    if self._endless and self._carried(change, place):
                        out.labels.add("endless_passes")
                    stack += [(one, change.place) for one in change.reads]
                    stack += self._conditions(change.place, context, seen)
        return out

    def _context(self, routine: Routine | None, seen: set[int]) -> set[Branch]:
        """The branches around every call of a routine."""
        if routine is None or id(routine) in seen:
            return set()
        every = [
            {*place.branches, *self._context(place.routine, seen | {id(routine)})} for place in self.calls[id(routine)]
        ]
        return set.intersection(*every) if every else set()

    def _conditions(self, place: Place, context: set[Branch], seen: set[int]) -> Iterator[tuple[Expression, Place]]:
        """The conditions on which a statement runs, but those of the context."""
        for branch in place.branches:
            if branch not in context:
                yield from ((one, place) for one in branch.conditions)
        if place.routine is not None and id(place.routine) not in seen:
            seen.add(id(place.routine))
            for call in self.calls[id(place.routine)]:
                yield from self._conditions(call, context, seen)

    def _carried(self, change: Change, reader: Place) -> bool:
        """Whether an endless loop may carry a value over into its next pass."""
        if (
            change.given
            or change.within is not None
            or change.place.routine is None
            or not self.in_endless(change.place)
        ):
            return False
        itself = any(self.key(node.name, change.place) == change.key for node in _names(change.reads))
        return itself or not self.precedes(change.place, reader)

    def precedes(self, place: Place, reader: Place, seen: frozenset[int] = frozenset()) -> bool:
        """Whether a statement has always run when another runs, in every pass and every call."""
        if place.routine is reader.routine:
            return place.start < reader.start and set(place.branches) <= set(reader.branches)
        if reader.routine is None or id(reader.routine) in seen:
            return False
        calls = self.calls[id(reader.routine)]
        return bool(calls) and all(self.precedes(place, call, seen | {id(reader.routine)}) for call in calls)

    def _later(self, place: Place, reader: Place) -> bool:
        """Whether a statement only runs when another in the same routine will not run again."""
        if place.routine is None or place.routine is not reader.routine or place.start < reader.start:
            return False
        repeated = any(branch.loop for branch in set(place.branches) & set(reader.branches))
        return not repeated and not self._often(place.routine, frozenset())

    def _often(self, routine: Routine, seen: frozenset[int]) -> bool:
        """Whether a routine may be called several times."""
        calls = self.calls[id(routine)]
        if len(calls) > 1 or id(routine) in seen or routine.kind != "PROC":
            return True
        seen |= {id(routine)}
        return any(
            any(branch.loop for branch in call.branches) or (call.routine and self._often(call.routine, seen))
            for call in calls
        )

    def in_endless(self, place: Place, seen: frozenset[int] = frozenset()) -> bool:
        """Whether an endless loop is around a place, here or around a call."""
        if any(branch.endless for branch in place.branches):
            return True
        routine = place.routine
        if routine is None or id(routine) in seen:
            return False
        return any(self.in_endless(call, seen | {id(routine)}) for call in self.calls[id(routine)])

    def loops(self, place: Place, seen: frozenset[int] = frozenset()) -> Iterator[tuple[Place, Branch]]:
        """The loops around a place, those around calls of its routine as well."""
        yield from ((place, branch) for branch in place.branches if branch.loop)
        if place.routine is not None and id(place.routine) not in seen:
            for call in self.calls[id(place.routine)]:
                yield from self.loops(call, seen | {id(place.routine)})

    def first(self, labels: Iterable[str]) -> str | None:
        """Of things of the scenario the one that stands first in it."""
        return min(labels, key=self.order.index, default=None)


def _sees(change: Change, at: Place) -> bool:
    if change.within is None:
        return True
    return change.place.path == at.path and change.within[0] <= at.start < change.within[1]


def _root(node: Expression) -> str | None:
    while isinstance(node, Component | Element):
        node = node.base
    return node.name if isinstance(node, Name) else None


def _names(nodes: Iterable[Expression | None]) -> Iterator[Name | Call]:
    return (node for node, _ in _names_with_elements(nodes, False))


def _names_with_elements(nodes: Iterable[Expression | None], target: bool) -> Iterator[tuple[Name | Call, int | None]]:
    """Names and calls in expressions; of an element with a constant index its number."""
    stack = list(nodes)
    while stack:
        node = stack.pop()
        match node:
            case Name():
                yield node, None
            case Call():
                yield node, None
                stack += [one.value for one in node.args]
            case Component():
                if not (target and node.name.lower() in _FRAMES):
                    stack.append(node.base)
            case Element():
                index = node.indices[0]
                if isinstance(node.base, Name) and len(node.indices) == 1 and isinstance(index, Number):
                    yield node.base, round(index.value)
                else:
                    stack += [node.base, *node.indices]
            case Unary():
                stack.append(node.operand)
            case Binary():
                stack += [node.left, node.right]
            case Aggregate() if node.numbers is None:
                stack += node.items
