"""Instructions that steer the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _exit_cycle(run: Run, node: ProcedureCall) -> None:
    from trajopt_cli.rapid.execution.interpreter import Exit

    bind(run, node, ())
    raise Exit


INSTRUCTIONS: dict[str, Instruction] = {
    "ExitCycle": _exit_cycle,
}
