"""Sockets and cameras: what is sent has no effect, what comes is an answer of the scenario.

A socket knows its own status, so that a program that waits for a connection goes on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.execution.answers import fill
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import locate
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.execution.instructions.no_effect import plain
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

# SOCKET_CREATED ... SOCKET_CLOSED of the manual
CREATED, CONNECTED, BOUND, LISTENING, CLOSED = 1.0, 2.0, 3.0, 4.0, 5.0


def _to(status: float, *required: str, optional: tuple[str, ...] = ()) -> Instruction:
    """An instruction that leaves its first argument, a socket, in a status."""

    def handler(run: Execution, node: ProcedureCall) -> None:
        args = bind(run, node, ("Socket", *required), optional)
        _mark(run, args.required[0], status)

    return handler


def _mark(run: Execution, socket: Expression, status: float) -> None:
    place = locate(run, socket)
    if place.type.name != "socketdev":
        raise run.error(socket, f"needs a socketdev, found {run.text(socket)} of type {place.type.name}")
    place.value = Value(place.type, status)


def _accept(run: Execution, node: ProcedureCall) -> None:
    args = bind(run, node, ("Socket", "ClientSocket"), ("ClientAddress", "Time"))
    _mark(run, args.required[1], CONNECTED)
    address = args.value("clientaddress")
    if address is not None:
        fill(run, address, f"SocketAccept tells {run.text(address)}, who has connected")


def _receive(run: Execution, node: ProcedureCall) -> None:
    required = ("Socket",)
    options = ("Str", "RawData", "Data", "ReadNoOfBytes", "NoRecBytes", "RemoteAddress", "RemotePort", "Time")
    args = bind(run, node, required, options)
    received: Value | None = None
    for name in ("str", "rawdata", "data", "remoteaddress", "remoteport"):
        target = args.value(name)
        if target is not None:
            value = fill(run, target, f"{node.name} receives {run.text(target)}")
            received = value if name == "str" else received
    count = args.value("norecbytes")
    if count is not None and received is not None:
        run.assign(count, Value(NUM, float(len(str(received.data)))))
    elif count is not None:
        fill(run, count, f"{node.name} counts the bytes it receives in {run.text(count)}")


def _camera_parameter(run: Execution, node: ProcedureCall) -> None:
    args = bind(run, node, ("Camera", "ParName"), ("NumVar", "BoolVar", "StrVar"))
    for target in args.optional.values():
        if target is not None:
            fill(run, target, f"CamGetParameter asks the camera for {run.text(target)}")


def _camera_result(run: Execution, node: ProcedureCall) -> None:
    args = bind(run, node, ("Camera", "CamTarget"), ("SceneId", "MaxTime"))
    target = args.required[1]
    fill(run, target, f"CamGetResult asks the camera for {run.text(target)}")


_SENT = """
    SocketSend SocketSendTo CamFlush CamReqImage CamSetExposure CamSetParameter CamSetProgramMode CamSetRunMode
    CamStartLoadJob
"""

INSTRUCTIONS: dict[str, Instruction] = {
    "SocketCreate": _to(CREATED, optional=("UDP",)),
    "SocketConnect": _to(CONNECTED, "Address", "Port", optional=("Time",)),
    "SocketBind": _to(BOUND, "LocalAddress", "LocalPort"),
    "SocketListen": _to(LISTENING),
    "SocketClose": _to(CLOSED),
    "SocketAccept": _accept,
    "SocketReceive": _receive,
    "SocketReceiveFrom": _receive,
    "CamGetParameter": _camera_parameter,
    "CamGetResult": _camera_result,
    **dict.fromkeys(("CamLoadJob", "CamWaitLoadJob", *_SENT.split()), plain),
}
EFFECT = Effect.STOPS  # the program waits for the other side
_AT_ONCE = ("SocketCreate", "SocketBind", "SocketListen", "SocketClose", *_SENT.split())
EFFECTS = dict.fromkeys(_AT_ONCE, Effect.IGNORED)
