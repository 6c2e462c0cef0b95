"""Modules into scopes: which names exist, of which type, and what their data begins with."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, TypeVar

from trajopt_cli.rapid.data.datatypes import TYPES, Array, Atomic, Record, Type, Value
from trajopt_cli.rapid.data.scope import Datum, Frame, ModuleScope, Scope
from trajopt_cli.rapid.execution.evaluate import evaluate, integer
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    AliasDeclaration,
    DataDeclaration,
    Item,
    Module,
    RecordDeclaration,
    Routine,
)
from trajopt_cli.rapid.language.text import Places

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run

_Thing = TypeVar("_Thing")


def load(run: Run, modules: Sequence[tuple[Module, Places]]) -> tuple[ModuleScope, ...]:
    """Enter the names of all modules, then compute the initial data of all; the scope of each module, in order.

    Initial data is computed even where nobody uses it, as a controller does: a broken target must not hide. Raises
    InputError for a name declared twice and for data that does not fit its type.
    """
    scopes = []
    for module, places in modules:
        scope = ModuleScope(places=places)
        scopes.append((scope, module))
        run.files[places.file] = places
        for node in module.items:
            if not isinstance(node, DataDeclaration):
                _enter(run, scope, node)
    for scope, module in scopes:  # sizes and values may need types and constants of every module
        frame = Frame(scope)
        for node in module.items:
            if isinstance(node, DataDeclaration):
                datum = declare(run, node, frame)
                for target in _targets(run, scope, node.scope):
                    _add(scope, node, node.name, target.data, datum)
    for scope, _ in scopes:
        for datum in scope.data.values():
            _ = datum.value
    return tuple(scope for scope, _ in scopes)


def _targets(run: Run, scope: ModuleScope, written: str | None) -> tuple[Scope, ...]:
    return (scope,) if written == "LOCAL" else (scope, run.shared)


def _add(scope: ModuleScope, node: Item, name: str, known: dict[str, _Thing], thing: _Thing) -> None:
    if name.lower() in known:
        raise scope.places.error(node.start, f"'{name}' is declared twice; rename one of them")
    known[name.lower()] = thing


def _enter(run: Run, scope: ModuleScope, node: Item) -> None:
    match node:
        case Routine():
            for target in _targets(run, scope, node.scope):
                _add(scope, node, node.name, target.routines, (node, scope))
        case RecordDeclaration() | AliasDeclaration():
            for target in _targets(run, scope, node.scope):
                _add(scope, node, node.name, target.types, (node, scope))


def declare(run: Run, node: DataDeclaration, frame: Frame) -> Datum:
    """The data of a declaration. Its initial value is computed in frame, when first asked for."""
    constant = f"a CONST (line {frame.scope.places.line(node.start)})" if node.storage == "CONST" else None
    with run.inside(frame):
        type_ = find_type(run, node.type)
        if node.sizes:
            sizes = tuple(integer(run, size, "an array size") for size in node.sizes)
            if min(sizes) < 1:
                raise run.error(node, f"{node.name} has an array size below 1")
            if _count(sizes) > _ARRAY_LIMIT:
                raise run.error(node, f"{node.name} has {_count(sizes)} elements; at most {_ARRAY_LIMIT} are supported")
            type_ = Array(type_, sizes, len(sizes))
    return Datum(type_, partial(_initial, run, node, type_, frame), constant)


_ARRAY_LIMIT = 1_000_000


def _count(sizes: Sequence[int]) -> int:
    count = 1
    for size in sizes:
        count *= size
    return count


def _initial(run: Run, node: DataDeclaration, type_: Type, frame: Frame) -> Value:
    if _valueless(type_):
        return Value(type_, node.value.numbers if isinstance(node.value, Aggregate) else type_.default)
    if node.value is None:
        return Value(type_, type_.default)
    if node in run.computing:
        raise run.error(node, f"the value of '{node.name}' refers to itself")
    run.computing.append(node)
    with run.inside(frame):
        value = evaluate(run, node.value, type_)
        span = run.places().span(node.start, node.end)
    run.computing.remove(node)
    return Value(
        type_, value.data, value.origin and value.origin._replace(declaration=value.origin.declaration or span)
    )


def _valueless(type_: Type) -> bool:
    """Types of process options (welddata ...): their data is carried along as bare numbers."""
    element = type_.element if isinstance(type_, Array) else type_
    return element.default is None


def find_type(run: Run, name: str, above: tuple[str, ...] = ()) -> Type:
    """The type of a name, by RAPID's order: own module, other modules, predefined. Unknown ones have no value."""
    key = name.lower()
    found = run.frame.scope.types.get(key) or run.shared.types.get(key)
    if found is None:
        return TYPES.get(key) or Atomic(key)
    node, scope = found
    if key in above:
        raise scope.places.error(node.start, f"type '{node.name}' contains itself")
    with run.inside(Frame(scope)):
        if isinstance(node, AliasDeclaration):
            return find_type(run, node.type, (*above, key))
        components = tuple((part.lower(), find_type(run, type_, (*above, key))) for type_, part in node.components)
    return Record(key, components)
