"""Which moves may end with the tool turned about an axis of its own, as the cell file says (free)."""

from __future__ import annotations

from collections.abc import Iterator

from trajopt_cli.motion import PoseMove, instruction_name, motion_name
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.named import Around, Modules, check_name, named, placed, routines_of
from trajopt_cli.scenario import FreeTool
from trajopt_cli.warnings import WarningKind

_EVERYWHERE = "the program"


def fill_free(run: Context, modules: Modules) -> None:
    """Fill the free turn of every move of a finished run, and warn of what frees none.

    A name is that of a procedure, with all that it calls, else of an instruction (DispL) or of a tool. A tool that
    stands in the world while the robot holds the work object (robhold FALSE) is not turned: it does not move.
    Raises InputError for a line that the program does not have, and for a name that is none of it.
    """
    for entry in run.scenario.free:
        used, standing = set[str](), list[PoseMove]()
        for where, motion in _moves(run, modules, entry):
            used.add(where)
            if motion.tool.stationary:
                standing.append(motion)
            else:
                object.__setattr__(motion, "free", entry.turn)  # still the run's own
        if standing:
            text = "moves a work object that the robot holds, the tool stands in the world (robhold FALSE)"
            told = f"free in the cell file: {motion_name(standing[0])} {text}; it stays as taught"
            run.warn(WarningKind.UNUSED, told, standing[0].source)
        for where in [*entry.names, *map(str, entry.lines)] or [_EVERYWHERE]:
            if where in used:
                continue
            named_so = where if where in (*entry.names, _EVERYWHERE) else f"line {where}"
            text = f"free in the cell file: no move to a robtarget ran in {named_so}"
            run.warn(WarningKind.UNUSED, text, entry.place)


def _moves(run: Context, modules: Modules, entry: FreeTool) -> Iterator[tuple[str, PoseMove]]:
    """The moves to poses that an entry names, each with every name or line that names it."""
    moves = [(one, link) for one, link in zip(run.motions, run.links, strict=True) if isinstance(one, PoseMove)]
    if not entry.names and not entry.lines:
        yield from ((_EVERYWHERE, motion) for motion, _ in moves)
        return
    procedures = {name.lower() for _, name in routines_of(modules)}
    for name in entry.names:
        words = [{instruction_name(motion).lower(), motion.tool.name.lower()} for motion, _ in moves]
        if name.lower() in procedures:
            around = Around([one.spans for one in named(run, modules, "free", [name.lower()], ())])
            yield from ((name, motion) for motion, link in moves if around(link))
        elif any(name.lower() in own for own in words):
            yield from ((name, motion) for (motion, _), own in zip(moves, words, strict=True) if name.lower() in own)
        else:
            message = f"free: '{name}' is no procedure, no instruction and no tool that moves here"
            check_name(modules, name, message, entry.place)
    for line in entry.lines:
        with placed(entry.place):
            around = Around([one.spans for one in named(run, modules, "free", (), [line])])
        yield from ((str(line), motion) for motion, link in moves if around(link))
