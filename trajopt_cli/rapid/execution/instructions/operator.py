"""What the operator is asked on the pendant."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.execution.answers import fill
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall, String

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

_BREAKS = (
    "MaxTime", "DIBreak", "DIPassive", "DOBreak", "DOPassive", "PersBoolBreak", "PersBoolPassive", "BreakFlag",
    "UIActiveSignal",
)  # fmt: skip


def _read_key(run: Execution, node: ProcedureCall) -> None:
    """A function key, 1 to 5; the first one that has a text stands in."""
    args = bind(run, node, ("TPAnswer", "TPText", "TPFK1", "TPFK2", "TPFK3", "TPFK4", "TPFK5"), _BREAKS)
    answer, _, *keys = args.required
    offered = [i for i, key in enumerate(keys, start=1) if _labelled(key)] or [1]
    value = fill(run, answer, f"TPReadFK asks the operator for {run.text(answer)}, a key of 1..5", float(offered[0]))
    if value is not None and value.data not in (1, 2, 3, 4, 5):
        raise run.error(
            answer, f"the answer {value.data:.15g} to '{run.text(answer)}' in the cell file is not a key from 1 to 5"
        )
    _unbroken(run, args.value("breakflag"))


def _labelled(key: Expression) -> bool:
    if isinstance(key, String):
        return bool(key.value.strip())
    return not (isinstance(key, Name) and key.name.lower() == "stempty")


def _read_number(run: Execution, node: ProcedureCall) -> None:
    args = bind(run, node, ("TPAnswer", "TPText"), _BREAKS)
    answer = args.required[0]
    fill(run, answer, f"{node.name} asks the operator for {run.text(answer)}")
    _unbroken(run, args.value("breakflag"))


def _message(run: Execution, node: ProcedureCall) -> None:
    r"""A box on the pendant; only \Result is an answer."""
    options = ("Header", "MsgLine2", "MsgLine3", "MsgLine4", "MsgLine5", "Wrap", "Buttons", "Icon", "Image", "Result")
    args = bind(run, node, ("MsgLine1",), (*options, *_BREAKS))
    result = args.value("result")
    if result is not None:
        fill(run, result, f"UIMsgBox asks the operator for {run.text(result)}")
    _unbroken(run, args.value("breakflag"))


def _unbroken(run: Execution, flag: Expression | None) -> None:
    """Nothing breaks off what the operator does."""
    if flag is not None:
        run.assign(flag, Value(NUM, 0.0))


EFFECT = Effect.STOPS
INSTRUCTIONS: dict[str, Instruction] = {
    "TPReadFK": _read_key,
    "TPReadNum": _read_number,
    "TPReadDnum": _read_number,
    "UIMsgBox": _message,
}
