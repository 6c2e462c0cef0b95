"""What else a program could be started with, for one whose entry moves nothing."""

from __future__ import annotations

import re
from collections.abc import Iterable

from trajopt_cli.motion import Program
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import ProcedureCall, Routine
from trajopt_cli.rapid.language.walk import walk

_MOVE = re.compile(r"Move(?!Robot)|(Trigg|Search)[JLC]$|(Arc|Disp|Paint|Cap)[LC]|Spot(ML|[JL])", re.IGNORECASE)
_SHOWN = 8


def moves_nothing(program: Program) -> str:
    """One line for a program without moves: what was run, and which procedures have moves, the first of them."""
    others = [(name, moves) for name, moves in startable(program) if name.lower() != program.entry.lower()]
    text = f"{program.entry} moves nothing when run"
    if not others:
        return text
    named = ", ".join(f"{name} ({moves} move{'s' * (moves > 1)})" for name, moves in others[:_SHOWN])
    more = f" and {len(others) - _SHOWN} more" if len(others) > _SHOWN else ""
    return f"{text}; other procedures that can be started (--entry): {named}{more}"


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
