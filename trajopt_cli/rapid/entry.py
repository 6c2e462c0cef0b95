"""Which procedure a program starts with, and what else it could be started with."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Program
from trajopt_cli.rapid.data.scope import ModuleScope
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import Module, ProcedureCall, Routine, walk
from trajopt_cli.rapid.language.text import listed

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
    shown = listed([f"{one[0].name} ({_place(one)})" for one in ready], _SHOWN)
    raise NoEntry(f"there is no PROC {entry}(); start with another by --entry: {shown}", file=name)


def _place(procedure: Procedure) -> str:
    routine, scope = procedure
    place = scope.places.source(routine.start)
    return f"{place.file}:{place.line}"


_MOVE = re.compile(r"Move(?!Robot)|(Trigg|Search)[JLC]$|(Arc|Disp|Paint|Cap)[LC]|Spot(ML|[JL])", re.IGNORECASE)
_MOST = 8


def moves_nothing(program: Program) -> str:
    """One line for a program without moves: what was run, and which procedures have moves, the first of them."""
    others = [(name, moves) for name, moves in startable(program) if name.lower() != program.entry.lower()]
    text = f"{program.entry} moves nothing when run"
    if not others:
        return text
    named = listed([f"{name} ({moves} move{'s' * (moves > 1)})" for name, moves in others], _MOST)
    return f"{text}; other procedures that can be started (--entry): {named}"


def startable(program: Program) -> tuple[tuple[str, int], ...]:
    """The procedures without arguments that have moves, as they stand in the files, and how many.

    Counted are the instructions in their text and in that of the procedures they call, each once.
    """
    trees = [parse_module(file.text, file.path) for file in program.files.values()]
    items = [item for tree in trees for module in tree.modules for item in module.items]
    procedures = {item.name.lower(): item for item in items if isinstance(item, Routine) and item.kind == "PROC"}
    own: dict[str, tuple[int, frozenset[str]]] = {}
    for key, routine in procedures.items():
        called = [node.name.lower() for node in walk(routine) if isinstance(node, ProcedureCall)]
        moves = sum(name not in procedures and _MOVE.match(name) is not None for name in called)
        own[key] = moves, frozenset(called) & procedures.keys()
    ready = [key for key, routine in procedures.items() if all(one.optional for one in routine.parameters)]
    counted = [(procedures[key].name, sum(own[one][0] for one in _reached(key, own))) for key in ready]
    return tuple((name, moves) for name, moves in counted if moves)


def _reached(start: str, own: dict[str, tuple[int, frozenset[str]]]) -> Iterable[str]:
    """A procedure and all that it calls, and so on."""
    found, todo = {start}, [start]
    while todo:
        new = own[todo.pop()][1] - found
        found |= new
        todo += new
    return found
