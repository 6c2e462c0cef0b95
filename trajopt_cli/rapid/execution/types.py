"""The type that a name stands for in a program: its own records and aliases, and the predefined ones."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import DEPTH_LIMIT, SIZE_LIMIT, TYPES, Atomic, Record, Type
from trajopt_cli.rapid.data.scope import ModuleScope
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import AliasDeclaration, DataDeclaration, Parameter, RecordDeclaration, Routine
from trajopt_cli.warnings import WarningKind

_CHAIN_LIMIT = 200  # types that need each other


def find_type(run: Context, name: str, node: DataDeclaration | Parameter | Routine | None = None) -> Type:
    """The type of a name, by RAPID's order: own module, other modules, predefined.

    An unknown one is no error as long as nothing uses it, so it is only noted; node: the declaration that asks.
    """
    scope = run.frame.scope
    found = _type(run, scope, name, ())
    if not found.known and node is not None:
        what = getattr(node, "name", name)
        message = f"type '{name}' of '{what}' is not declared; this does no harm unless something uses '{what}'"
        run.note(f"type {found.name}", WarningKind.UNUSUAL, message, node)
    scope.resolved[name] = found
    return found


def _type(run: Context, scope: ModuleScope, name: str, above: tuple[str, ...]) -> Type:
    known = scope.resolved.get(name)
    if known is not None:
        return known
    key = name.lower()
    found = scope.types.get(key) or run.shared.types.get(key)
    if found is None:
        return TYPES.get(key) or Atomic(key, known=False)
    node, home = found
    if len(above) >= _CHAIN_LIMIT:
        message = f"type '{name}' is at the end of a chain of more than {_CHAIN_LIMIT} others"
        raise home.places.error(node.start, message)
    if home is not scope or key not in home.resolved:
        if key in above:
            raise home.places.error(node.start, f"type '{node.name}' contains itself")
        made = home.resolved.get(key)
        if made is None:
            home.resolved[key] = made = _made(run, node, home, key, (*above, key))
        return made
    return home.resolved[key]


def _made(
    run: Context, node: RecordDeclaration | AliasDeclaration, home: ModuleScope, key: str, above: tuple[str, ...]
) -> Type:
    if isinstance(node, AliasDeclaration):
        type_ = _type(run, home, node.type, above)
        if not type_.known:
            raise home.places.error(node.start, f"type '{node.type}' of ALIAS {node.name} is not declared anywhere")
        return type_
    parts = []
    for written, part in node.components:
        type_ = _type(run, home, written, above)
        if not type_.known:
            raise home.places.error(node.start, f"type '{written}' in RECORD {node.name} is not declared anywhere")
        parts.append((part.lower(), type_))
    record = Record(key, tuple(parts))
    if record.depth > DEPTH_LIMIT:
        raise home.places.error(node.start, f"RECORD {node.name} is nested deeper than {DEPTH_LIMIT} records")
    if record.size > SIZE_LIMIT:
        raise home.places.error(node.start, f"RECORD {node.name} holds {record.size} values; at most {SIZE_LIMIT}")
    return record
