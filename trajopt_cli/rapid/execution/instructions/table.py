"""Every supported instruction by name: one handler and one line in the INSTRUCTIONS of its topic."""

from __future__ import annotations

from trajopt_cli.rapid.execution.arguments import Instruction
from trajopt_cli.rapid.execution.instructions import flow, moves, nothing, settings, signals, variables, waits

INSTRUCTIONS: dict[str, Instruction] = {
    **moves.INSTRUCTIONS,
    **waits.INSTRUCTIONS,
    **signals.INSTRUCTIONS,
    **variables.INSTRUCTIONS,
    **settings.INSTRUCTIONS,
    **flow.INSTRUCTIONS,
    **nothing.INSTRUCTIONS,
}
