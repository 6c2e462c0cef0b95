"""Modules into scopes: which names exist, of which type, and what their data begins with."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from math import prod
from typing import TypeVar

from trajopt_cli.motion import Span
from trajopt_cli.rapid.data import datatypes
from trajopt_cli.rapid.data.datatypes import ARRAY_LIMIT, SIZE_LIMIT, Array, Origin, Type, Value
from trajopt_cli.rapid.data.scope import CallFrame, Datum, ExternalDatum, Mismatch, ModuleScope, Scope
from trajopt_cli.rapid.execution import external_data
from trajopt_cli.rapid.execution.construction import maker
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.evaluate import opaque
from trajopt_cli.rapid.execution.recursion_limit import room
from trajopt_cli.rapid.execution.types import find_type
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import Aggregate, DataDeclaration, Module, Name, Node, walk
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.warnings import WarningKind

_Entry = TypeVar("_Entry", bound=tuple[Node, ModuleScope])

_CHAIN_LIMIT = 200  # declarations that need each other before any of them has a value


def load(run: Context, modules: Sequence[tuple[Module, Places]]) -> tuple[ModuleScope, ...]:
    """Enter the names of all modules, then compute the initial data of all; the scope of each module, in order.

    Initial data is computed even where nobody uses it, as a controller does: a broken target must not hide. Raises
    InputError for a name declared twice and for data that does not fit its type.
    """
    with room():
        return _load(run, modules)


def _load(run: Context, modules: Sequence[tuple[Module, Places]]) -> tuple[ModuleScope, ...]:
    scopes: list[tuple[ModuleScope, Module]] = []
    for module, places in modules:
        scope = ModuleScope(places=places, name=module.name)
        scopes.append((scope, module))
        run.modules[module.name.lower()] = scope
        run.files[places.file] = places
        for node in module.items:
            if isinstance(node, syntax.Routine):
                for target in _targets(run, scope, node.scope):
                    _enter(target.routines, node.name, (node, scope))
            elif isinstance(node, (syntax.RecordDeclaration, syntax.AliasDeclaration)):
                for target in _targets(run, scope, node.scope):
                    _enter(target.types, node.name, (node, scope))
    for arrays in (False, True):  # their sizes may need constants of every module
        for scope, module in scopes:
            frame = CallFrame(scope)
            with run.inside(frame):
                for item in module.items:
                    if type(item) is DataDeclaration and bool(item.sizes) is arrays:
                        _add(run, scopes, scope, item, declare(run, item, frame))
    for scope, _ in scopes:
        for datum in scope.data.values():
            if type(datum) is not ExternalDatum:  # its values are read already, and reading it takes one of a sequence
                _ = datum.value
    return tuple(scope for scope, _ in scopes)


def _targets(run: Context, scope: ModuleScope, written: str | None) -> tuple[Scope, ...]:
    return (scope,) if written == "LOCAL" else (scope, run.shared)


def _enter(known: dict[str, _Entry], name: str, entry: _Entry) -> None:
    key = name.lower()
    if key in known:
        first, module = known[key]
        _refuse(name, (entry[1], entry[0]), (module, first))
    known[key] = entry


def _refuse(name: str, second: tuple[ModuleScope, Node], first: tuple[ModuleScope, Node]) -> None:
    (scope, node), (before, other) = second, first
    places = before.places
    where = f"line {places.line(other.start)}" if scope is before else str(places.source(other.start))
    raise scope.places.error(node.start, f"'{name}' is declared twice, first in {where}; rename one of them")


def _add(
    run: Context, scopes: list[tuple[ModuleScope, Module]], scope: ModuleScope, node: DataDeclaration, datum: Datum
) -> None:
    """Enter data. A PERS that several modules declare is one and the same."""
    key = node.name.lower()
    if run.external.gives(key):
        before = None if node.scope == "LOCAL" else run.shared.data.get(key)
        datum = before if type(before) is ExternalDatum else external_data.declared(run, node, node.name, datum)
    shared = None if node.scope == "LOCAL" else run.shared.data.get(key)
    if key in scope.data or shared is not None:
        if key in scope.data or shared is None or not (shared.storage == node.storage == "PERS"):
            first = _declaration(scopes, key, scope if key in scope.data else None)
            _refuse(node.name, (scope, node), first)
            return
        if not datatypes.same_type(shared.type, datum.type):
            first = _declaration(scopes, key, None)
            where = first[0].places.source(first[1].start)
            message = f"PERS {node.name} is a {datum.type.name} here and a {shared.type.name} in {where}"
            raise scope.places.error(node.start, f"{message}; rename one of them")
        if node.value is not None and shared is not datum:
            if key not in run.valued:
                shared.take(datum)
            elif shared.value.data != datum.value.data:
                place = scope.places.source(node.start)
                what = f"PERS {node.name} has a different value in another module, and that one is used"
                run.warn(WarningKind.UNUSUAL, what, place)
        datum = shared
    scope.data[key] = datum
    if node.scope != "LOCAL":
        run.shared.data[key] = datum
        if node.value is not None and node.storage == "PERS":
            run.valued.add(key)


def _declaration(
    scopes: list[tuple[ModuleScope, Module]], key: str, own: ModuleScope | None
) -> tuple[ModuleScope, DataDeclaration]:
    """The first declaration of data: in a module, or of those that all modules see."""
    return next(
        (scope, node)
        for scope, module in scopes
        for node in module.items
        if isinstance(node, DataDeclaration)
        and node.name.lower() == key
        and (scope is own if own else node.scope != "LOCAL")
    )


_value, _origin, _span = maker(Value), maker(Origin), maker(Span)


def declare(run: Context, node: DataDeclaration, frame: CallFrame) -> Datum:
    """The data of a declaration that stands in frame, which runs. What needs other data is computed when asked for."""
    scope = frame.scope
    type_ = scope.resolved.get(node.type) or find_type(run, node.type, node)
    if node.sizes:
        for depth, size in enumerate(node.sizes):
            _ask_size(run, node, size, depth)
        sizes = tuple([run.integer(size, "an array size") for size in node.sizes])
        if min(sizes) < 1:
            raise run.error(node, f"{node.name} has an array size below 1")
        type_ = Array(type_, sizes, len(sizes))
        if (count := prod(sizes)) > SIZE_LIMIT:
            raise run.error(node, f"{node.name} has {count} elements; at most {SIZE_LIMIT} are supported")
        if type_.size > ARRAY_LIMIT:
            raise run.error(node, f"{node.name} holds {type_.size} values; at most {ARRAY_LIMIT} are supported")
    constant = (scope.places, node.start) if node.storage == "CONST" else None
    value, first = node.value, None
    if value is None:
        first = Value(type_, type_.default)
    elif type(value) is Aggregate and type_.layout is not None:
        data = type_.layout.read(scope.places.text[value.start : value.end])
        if data is not None:
            file = scope.places.file
            first = _value((type_, data, _origin((file, value, _span((file, node.start, node.end))))))
    if first is not None:
        return Datum(type_, first, constant, node.storage)
    return Datum(type_, partial(_initial, run, node, type_, frame), constant, node.storage)


def _ask_size(run: Context, node: DataDeclaration, size: syntax.Expression, depth: int) -> None:
    """Ask for an array size that nothing declares; the array's own value tells one that fits."""
    for name in walk(size) if type(size) is not syntax.Number else ():
        if isinstance(name, Name) and run.find(name.name) is None:
            value: syntax.Expression | None = node.value
            for _ in range(depth):
                value = value.items[0] if isinstance(value, Aggregate) and value.items else None
            count = len(value.items) if isinstance(value, Aggregate) and size is name else 1
            external_data.size(run, name, node.name, count)


def _initial(run: Context, node: DataDeclaration, type_: Type, frame: CallFrame) -> Value:
    assert node.value is not None
    if id(node) in run.computing:
        raise frame.scope.places.error(node.start, f"the value of '{node.name}' refers to itself")
    if len(run.computing) >= _CHAIN_LIMIT:
        message = f"the value of '{node.name}' depends on more than {_CHAIN_LIMIT} other data declared after it"
        raise frame.scope.places.error(node.start, message)
    run.computing.add(id(node))
    before, run.frame = run.frame, frame
    try:
        if datatypes.is_opaque(type_):
            return opaque(run, node.value, type_)
        value = run.evaluate(node.value, type_)
    except Mismatch as error:
        raise error.about(node.value, node.name) from None
    except RecursionError:
        raise frame.scope.places.error(node.start, f"the value of '{node.name}' is nested too deeply") from None
    finally:
        run.frame = before
        run.computing.discard(id(node))
    if value.origin is None or value.origin.declaration is not None:
        return Value(type_, value.data, value.origin)
    span = frame.scope.places.span(node.start, node.end)
    return Value(type_, value.data, value.origin._replace(declaration=span))
