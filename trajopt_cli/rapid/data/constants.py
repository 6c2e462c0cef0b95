"""Predefined constants about operator, files, sockets and the controller. Figures as in ABB's reference manual."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import NUM, STRING, Data, Type


def _counted(first: int, names: str) -> dict[str, tuple[Type, Data]]:
    """Names in the order of their numbers."""
    return {name.lower(): (NUM, float(number)) for number, name in enumerate(names.split(), start=first)}


WAIT_MAX = 8388608.0  # s, about 97 days: a num that is exact

# By name in lower case.
CONSTANTS: dict[str, tuple[Type, Data]] = {
    **_counted(-1, "btnNone btnOK btnAbrtRtryIgn btnOKCancel btnRetryCancel btnYesNo btnYesNoCancel"),
    **_counted(0, "resUnkwn resOK resAbort resRetry resIgnore resCancel resYes resNo"),
    **_counted(0, "iconNone iconInfo iconWarning iconError"),
    **_counted(1, "SOCKET_CREATED SOCKET_CONNECTED SOCKET_BOUND SOCKET_LISTENING SOCKET_CLOSED"),
    **_counted(0, "OP_UNDEF OP_AUTO OP_MAN_PROG OP_MAN_TEST"),
    **_counted(0, "RUN_UNDEF RUN_CONT_CYCLE RUN_INSTR_FWD RUN_INSTR_BWD RUN_SIM RUN_STEP_MOVE"),
    **_counted(0, "EVENT_NONE EVENT_POWERON EVENT_START EVENT_STOP EVENT_QSTOP EVENT_RESTART EVENT_RESET EVENT_STEP"),
    **_counted(0, "HANDLER_NONE HANDLER_BWD HANDLER_ERR HANDLER_UNDO"),
    **_counted(0, "LEVEL_NORMAL LEVEL_TRAP LEVEL_SERVICE"),
    **_counted(0, "SIGORIG_NONE SIGORIG_CFG SIGORIG_ALIAS"),
    **{name: (NUM, size) for name, size in {"usint": 1.0, "uint": 2.0, "udint": 4.0, "ulint": 8.0}.items()},
    **{name: (NUM, -size) for name, size in {"sint": 1.0, "int": 2.0, "dint": 4.0, "lint": 8.0}.items()},
    "edge": (NUM, 2.0),
    "eof": (STRING, "EOF"),
    "eof_num": (NUM, 9.998e36),
    "eof_bin": (NUM, -1.0),
    "wait_max": (NUM, WAIT_MAX),
    "stempty": (STRING, ""),
    "diskhome": (STRING, "HOME:"),
    "disktemp": (STRING, "TEMP:"),
}
