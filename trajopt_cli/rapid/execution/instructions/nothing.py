"""Instructions without effect on motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.execution.arguments import Instruction
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _nothing(run: Run, node: ProcedureCall) -> None:
    """No effect on motion; the arguments are not even looked at."""


INSTRUCTIONS: dict[str, Instruction] = {
    "WaitRob": _nothing,
    "TPWrite": _nothing,
    "TPErase": _nothing,
    "TPShow": _nothing,
    "ErrWrite": _nothing,
    "ClkReset": _nothing,
    "ClkStart": _nothing,
    "ClkStop": _nothing,
}
