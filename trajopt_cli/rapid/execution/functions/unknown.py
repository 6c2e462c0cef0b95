"""Functions whose value only the running cell knows: the scenario answers under the function's name.

The stand-ins for what lacks end the loops that read files to their end, and let a text of a date be cut into parts.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Type, Value
from trajopt_cli.rapid.execution.answers import ask, fill, root
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.evaluate import condition, locate
from trajopt_cli.rapid.execution.instructions.sockets import CLOSED
from trajopt_cli.rapid.language.syntax import Call
from trajopt_cli.scenario import Answer

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

EOF_NUM = 9.998e36  # what ReadNum gives behind the last number of a file
EOF_BIN = -1.0


def _unknown(name: str, type_: Type, what: str, default: Answer | None = None) -> tuple[str, Function]:
    """A function that is answered under its own name; its arguments are not looked at."""

    def handler(run: Execution, node: Call) -> Value:
        return ask(run, node, name, type_, f"{name} asks for {what}", default)

    return name, handler


def _clock(run: Execution, node: Call) -> Value:
    (clock,) = bind(run, node, ("Clock",), ("HighRes",)).required
    return ask(run, clock, root(run, clock), NUM, f"ClkRead asks for the seconds on {run.text(clock)}")


def _test_and_set(run: Execution, node: Call) -> Value:
    """TRUE where the flag was free; it is taken afterwards."""
    (flag,) = bind(run, node, ("Object",)).required
    free = not condition(run, flag)
    run.assign(flag, Value(BOOL, True))
    return Value(BOOL, free)


def _read_directory(run: Execution, node: Call) -> Value:
    """Whether there was one more file, and its name in the variable."""
    _, name = bind(run, node, ("Dev", "FileName")).required
    more = ask(run, node, "ReadDir", BOOL, "ReadDir asks whether the folder holds one more file")
    if more.data:
        fill(run, name, f"ReadDir reads {run.text(name)}")
    return more


def _next_symbol(run: Execution, node: Call) -> Value:
    name, _ = bind(run, node, ("Object", "Block"), ("Recursive",)).required
    more = ask(run, node, "GetNextSym", BOOL, "GetNextSym asks whether the search finds one more name")
    if more.data:
        fill(run, name, f"GetNextSym reads {run.text(name)}")
    return more


def _socket_status(run: Execution, node: Call) -> Value:
    """As the program itself has left the socket; one that it never made is closed."""
    (socket,) = bind(run, node, ("Socket",)).required
    value = locate(run, socket).value
    if value.type.name != "socketdev":
        raise run.error(socket, f"SocketGetStatus takes a socketdev, and {run.text(socket)} is a {value.type.name}")
    status = value.data
    return Value(NUM, CLOSED if status is None else status)


_ASKED: tuple[tuple[str, Function], ...] = (
    _unknown("UIMessageBox", NUM, "the operator's button"),
    _unknown("UINumEntry", NUM, "the operator's number"),
    _unknown("UINumTune", NUM, "the operator's number"),
    _unknown("UIDnumEntry", DNUM, "the operator's number"),
    _unknown("UIDnumTune", DNUM, "the operator's number"),
    _unknown("UIAlphaEntry", STRING, "the operator's text"),
    _unknown("UIListView", NUM, "the operator's choice, its number in the list"),
    _unknown("ReadNum", NUM, "the next number of a file", EOF_NUM),
    _unknown("ReadBin", NUM, "the next byte of a file", EOF_BIN),
    _unknown("ReadStr", STRING, "the next line of a file", "EOF"),
    _unknown("ReadStrBin", STRING, "the next characters of a file", "EOF"),
    _unknown("ReadVar", NUM, "a value of a sensor"),
    _unknown("FileSize", NUM, "the size of a file in bytes"),
    _unknown("FSSize", NUM, "the size of a file system"),
    _unknown("IsFile", BOOL, "whether a file exists"),
    _unknown("FileTime", NUM, "the time of a file"),
    _unknown("FileTimeDnum", DNUM, "the time of a file"),
    _unknown("ModTime", NUM, "the time of a module"),
    _unknown("ModTimeDnum", DNUM, "the time of a module"),
    _unknown("RawBytesLen", NUM, "the number of bytes in a rawbytes"),
    _unknown("TextGet", STRING, "a text of a table"),
    _unknown("TextTabGet", NUM, "the number of a table of texts"),
    _unknown("CTime", STRING, "the time of day", "00:00:00"),
    _unknown("CDate", STRING, "the date", "2000-01-01"),
    _unknown("GetTime", NUM, "a part of the time of day"),
    _unknown("CamGetExposure", NUM, "the camera's exposure"),
    _unknown("CamGetLoadedJob", STRING, "the camera's job"),
    _unknown("CamGetName", STRING, "the camera's name"),
    _unknown("CamNumberOfResults", NUM, "the number of results of a camera"),
    _unknown("GetSysInfo", STRING, "what the controller says of itself"),
    _unknown("IsSysId", BOOL, "whether this is the controller of a number"),
    _unknown("GetMotorTorque", NUM, "a motor's torque"),
    _unknown("ReadMotor", NUM, "a motor's angle"),
    _unknown("TestSignRead", NUM, "a test signal"),
    _unknown("GetServiceInfo", STRING, "the service intervals"),
    _unknown("ProgMemFree", NUM, "the free memory in bytes"),
    _unknown("SocketPeek", NUM, "the number of bytes that have come in"),
    _unknown("IndInpos", BOOL, "whether an independent axis has come to its place"),
    _unknown("IndSpeed", BOOL, "whether an independent axis has its speed"),
    _unknown("PathLengthGet", NUM, "the length of the path so far"),
    _unknown("PathRecValidBwd", BOOL, "whether the recorded path can be run backwards"),
    _unknown("PathRecValidFwd", BOOL, "whether the recorded path can be run forwards"),
)

FUNCTIONS: dict[str, Function] = {
    **dict(_ASKED),
    "ClkRead": _clock,
    "TestAndSet": _test_and_set,
    "ReadDir": _read_directory,
    "GetNextSym": _next_symbol,
    "SocketGetStatus": _socket_status,
}
