"""Which procedure a program starts with."""

from __future__ import annotations

from collections.abc import Sequence

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.scope import ModuleScope
from trajopt_cli.rapid.language.syntax import Module, Routine

_SHOWN = 10

Procedure = tuple[Routine, ModuleScope]


class NoEntry(InputError):
    """The program has no procedure of the wanted name."""


def find_entry(modules: Sequence[tuple[Module, ModuleScope]], entry: str, name: str) -> Procedure:
    """The procedure of that name, in any case; a LOCAL one where no other has the name.

    name: of the program, for messages. Raises InputError where there is none, with those that could be started, and
    where several LOCAL ones have the name.
    """
    procedures = [
        (node, scope)
        for module, scope in modules
        for node in module.items
        if isinstance(node, Routine) and node.kind == "PROC"
    ]
    found = [one for one in procedures if one[0].name.lower() == entry.lower()]
    shared = [one for one in found if one[0].scope != "LOCAL"]
    if shared or len(found) == 1:
        return (shared or found)[0]
    if found:
        places = ", ".join(_place(one) for one in found)
        raise InputError(f"there are {len(found)} LOCAL PROC {entry} ({places}); rename all but one", file=name)
    ready = [one for one in procedures if all(parameter.optional for parameter in one[0].parameters)]
    if not ready:
        message = f"there is no PROC {entry}(), nor another procedure without arguments to start with"
        raise NoEntry(message, file=name)
    shown = ", ".join(f"{one[0].name} ({_place(one)})" for one in ready[:_SHOWN])
    more = f" and {len(ready) - _SHOWN} more" if len(ready) > _SHOWN else ""
    raise NoEntry(f"there is no PROC {entry}(); start with another by --entry: {shown}{more}", file=name)


def _place(procedure: Procedure) -> str:
    routine, scope = procedure
    place = scope.places.source(routine.start)
    return f"{place.file}:{place.line}"
