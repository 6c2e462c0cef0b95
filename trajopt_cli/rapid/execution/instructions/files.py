"""Files, serial channels, raw bytes and configuration: what is written has no effect, what is read is an answer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.execution.answers import fill
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.execution.instructions.no_effect import plain
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution


def _reads(name: str, *required: str, optional: tuple[str, ...] = ()) -> tuple[str, Instruction]:
    """An instruction that fills its last argument, under that variable's name."""

    def handler(run: Execution, node: ProcedureCall) -> None:
        _fill(run, name, bind(run, node, required, optional).required[-1])

    return name, handler


def _fill(run: Execution, name: str, target: Expression) -> None:
    if fill(run, target, f"{name} reads {run.text(target)}") is None:
        run.ignored[name] += 1


def _read_error(run: Execution, node: ProcedureCall) -> None:
    options = ("Title", "Str1", "Str2", "Str3", "Str4", "Str5")
    args = bind(run, node, ("TrapEvent", "ErrorDomain", "ErrorId", "ErrorType"), options)
    for target in (*args.required[1:], *args.optional.values()):
        if target is not None:
            _fill(run, "ReadErrData", target)


_PLAIN = """
    Open Close Write WriteBin WriteStrBin WriteAnyBin WriteRawBytes WriteBlock WriteVar Rewind ClearIOBuff ReadBlock
    OpenDir CloseDir MakeDir RemoveDir RemoveFile RenameFile CopyFile
    ClearRawBytes CopyRawBytes PackDNHeader PackRawBytes
    SiConnect SiClose SiSetCyclic
"""

INSTRUCTIONS: dict[str, Instruction] = {
    **dict.fromkeys(_PLAIN.split(), plain),
    "ReadErrData": _read_error,
    **dict(
        (
            _reads("ReadAnyBin", "IODevice", "Data", optional=("Time",)),
            _reads("ReadRawBytes", "IODevice", "RawData", optional=("Time",)),
            _reads("ReadCfgData", "InstancePath", "Attribute", "CfgData", optional=("ListNo",)),
            _reads(
                "UnpackRawBytes", "RawData", "StartIndex", "Value",
                optional=("Network", "Hex1", "IntX", "Float4", "ASCII"),
            ),
            _reads("RMQGetMsgData", "Message", "Data"),
        )
    ),
}  # fmt: skip
EFFECTS = {
    **dict.fromkeys(_PLAIN.split(), Effect.IGNORED),
    **dict.fromkeys(("ReadAnyBin", "ReadRawBytes", "ReadBlock", "SiConnect"), Effect.STOPS),
}
