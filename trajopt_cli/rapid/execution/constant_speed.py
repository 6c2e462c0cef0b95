"""Which lines and arcs must keep their programmed speed all along, as the cell file says: a weld, a bead of glue."""

from __future__ import annotations

from trajopt_cli.motion import MoveC, MoveL
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.named import Around, Modules, named
from trajopt_cli.warnings import WarningKind


def fill_constant_speed(run: Context, modules: Modules) -> None:
    """Mark the lines and arcs of a finished run that constant_speed names, and warn of entries that name none.

    Raises InputError for a procedure or a line in the cell file that the program does not have.
    """
    wish = run.scenario.constant_speed
    entries = [*named(run, modules, "constant_speed", wish.procedures, wish.lines)]
    if not entries:
        return
    around = Around([entry.spans for entry in entries])
    used: set[int] = set()
    for motion, link in zip(run.motions, run.links, strict=True):
        if isinstance(motion, MoveL | MoveC) and (found := around(link)):
            used |= found
            object.__setattr__(motion, "constant_speed", True)  # still the run's own, as in once.py
    for number, entry in enumerate(entries):
        if number not in used:
            run.warn(WarningKind.UNUSED, f"constant_speed in the cell file: no line and no arc ran in {entry.text}")
