"""Every supported instruction by name: one handler and one line in the INSTRUCTIONS of its topic."""

from __future__ import annotations

from trajopt_cli.rapid.execution.arguments import Instruction
from trajopt_cli.rapid.execution.instructions import (
    displacement,
    files,
    flow,
    moves,
    multimove,
    nothing,
    operator,
    processes,
    searches,
    settings,
    signals,
    sockets,
    symbols,
    triggers,
    variables,
    waits,
)

INSTRUCTIONS: dict[str, Instruction] = {
    **moves.INSTRUCTIONS,
    **triggers.INSTRUCTIONS,
    **searches.INSTRUCTIONS,
    **processes.INSTRUCTIONS,
    **displacement.INSTRUCTIONS,
    **waits.INSTRUCTIONS,
    **signals.INSTRUCTIONS,
    **variables.INSTRUCTIONS,
    **settings.INSTRUCTIONS,
    **flow.INSTRUCTIONS,
    **files.INSTRUCTIONS,
    **operator.INSTRUCTIONS,
    **sockets.INSTRUCTIONS,
    **symbols.INSTRUCTIONS,
    **multimove.INSTRUCTIONS,
    **nothing.INSTRUCTIONS,
}
