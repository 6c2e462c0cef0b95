"""Functions whose value only the running cell knows: rows of tables, answered by the scenario.

Nothing looks at the arguments of those that are a row. The stand-ins for what is missing end the loops that read files
to their end, and let a text of a date be cut into parts.
"""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.answers import ask, fill, root
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.rows import CLOSED
from trajopt_cli.rapid.language.syntax import Call
from trajopt_cli.scenario import Answer, yaml_answer
from trajopt_cli.warnings import WarningKind

EOF_NUM = 9.998e36  # what ReadNum gives behind the last number of a file
EOF_BIN = -1.0

# Name, type, what is asked for, and what stands in for a missing answer (None: 0, "", FALSE).
ASKED: tuple[tuple[str, Type, str, Answer | None], ...] = (
    ("UIMessageBox", NUM, "the operator's button", None),
    ("UINumEntry", NUM, "the operator's number", None),
    ("UINumTune", NUM, "the operator's number", None),
    ("UIDnumEntry", DNUM, "the operator's number", None),
    ("UIDnumTune", DNUM, "the operator's number", None),
    ("UIAlphaEntry", STRING, "the operator's text", None),
    ("UIListView", NUM, "the operator's choice, its number in the list", None),
    ("ReadNum", NUM, "the next number of a file", EOF_NUM),
    ("ReadBin", NUM, "the next byte of a file", EOF_BIN),
    ("ReadStr", STRING, "the next line of a file", "EOF"),
    ("ReadStrBin", STRING, "the next characters of a file", "EOF"),
    ("ReadVar", NUM, "a value of a sensor", None),
    ("FileSize", NUM, "the size of a file in bytes", None),
    ("FSSize", NUM, "the size of a file system", None),
    ("IsFile", BOOL, "whether a file exists", None),
    ("FileTime", NUM, "the time of a file", None),
    ("FileTimeDnum", DNUM, "the time of a file", None),
    ("ModTime", NUM, "the time of a module", None),
    ("ModTimeDnum", DNUM, "the time of a module", None),
    ("RawBytesLen", NUM, "the number of bytes in a rawbytes", None),
    ("TextGet", STRING, "a text of a table", None),
    ("TextTabGet", NUM, "the number of a table of texts", None),
    ("CTime", STRING, "the time of day", "00:00:00"),
    ("CDate", STRING, "the date", "2000-01-01"),
    ("GetTime", NUM, "a part of the time of day", None),
    ("CamGetExposure", NUM, "the camera's exposure", None),
    ("CamGetLoadedJob", STRING, "the camera's job", None),
    ("CamGetName", STRING, "the camera's name", None),
    ("CamNumberOfResults", NUM, "the number of results of a camera", None),
    ("GetSysInfo", STRING, "what the controller says of itself", None),
    ("IsSysId", BOOL, "whether this is the controller of a number", None),
    ("GetMotorTorque", NUM, "a motor's torque", None),
    ("ReadMotor", NUM, "a motor's angle", None),
    ("TestSignRead", NUM, "a test signal", None),
    ("GetServiceInfo", STRING, "the service intervals", None),
    ("ProgMemFree", NUM, "the free memory in bytes", None),
    ("SocketPeek", NUM, "the number of bytes that have come in", None),
    ("IndInpos", BOOL, "whether an independent axis has come to its place", None),
    ("IndSpeed", BOOL, "whether an independent axis has its speed", None),
    ("PathLengthGet", NUM, "the length of the path so far", None),
    ("PathRecValidBwd", BOOL, "whether the recorded path can be run backwards", None),
    ("PathRecValidFwd", BOOL, "whether the recorded path can be run forwards", None),
)
# Name, type and value of what is taken as a robot's in automatic operation, and reported; an answer overrides.
ASSUMED: tuple[tuple[str, Type, Data], ...] = (
    ("OpMode", NUM, 1.0),  # OP_AUTO
    ("RunMode", NUM, 1.0),  # RUN_CONT_CYCLE
    ("RobOS", BOOL, True),
    ("RobName", STRING, "ROB_1"),
    ("GetTaskName", STRING, "T_ROB1"),
    ("TaskRunMec", BOOL, True),
    ("TaskRunRob", BOOL, True),
    ("TaskIsActive", BOOL, True),
    ("TaskIsExecuting", BOOL, True),
    ("TaskInSync", BOOL, False),
    ("IsStopMoveAct", BOOL, False),
    ("NonMotionMode", BOOL, False),
    ("MotionPlannerNo", NUM, 1.0),
    ("EventType", NUM, 0.0),
    ("ExecHandler", NUM, 0.0),
    ("ExecLevel", NUM, 0.0),
    ("PFRestart", BOOL, False),
    ("IsBrakeCheckActive", BOOL, False),
    ("UIClientExist", BOOL, True),
)


def _asked(name: str, type_: Type, what: str, default: Answer | None) -> Function:
    return lambda run, node: ask(run, node, name, type_, f"{name} asks for {what}", default)


def _assumed(name: str, type_: Type, data: Data) -> Function:
    def handler(run: Context, node: Call) -> Value:
        if run.external.known(name):
            return ask(run, node, name, type_, f"{name} asks for its value")
        shown = yaml_answer(data)
        run.warn(
            WarningKind.ASSUMED,
            f"{name}() is taken to be {shown}; another value is an answer in the cell file, '{name}: {shown}'",
        )
        return Value(type_, data)

    return handler


def _clock(run: Context, node: Call) -> Value:
    (clock,) = bind(run, node, ("Clock",), ("HighRes",)).required
    return ask(run, clock, root(run, clock), NUM, f"ClkRead asks for the seconds on {run.text(clock)}")


def _test_and_set(run: Context, node: Call) -> Value:
    """TRUE where the flag was free; it is taken afterwards."""
    (flag,) = bind(run, node, ("Object",)).required
    free = not run.condition(flag)
    run.assign(flag, Value(BOOL, True))
    return Value(BOOL, free)


def _read_directory(run: Context, node: Call) -> Value:
    """Whether there was one more file, and its name in the variable."""
    _, name = bind(run, node, ("Dev", "FileName")).required
    more = ask(run, node, "ReadDir", BOOL, "ReadDir asks whether the folder holds one more file")
    if more.data:
        fill(run, name, f"ReadDir reads {run.text(name)}")
    return more


def _next_symbol(run: Context, node: Call) -> Value:
    name, _ = bind(run, node, ("Object", "Block"), ("Recursive",)).required
    more = ask(run, node, "GetNextSym", BOOL, "GetNextSym asks whether the search finds one more name")
    if more.data:
        fill(run, name, f"GetNextSym reads {run.text(name)}")
    return more


def _socket_status(run: Context, node: Call) -> Value:
    """As the program itself has left the socket; one that it never made is closed."""
    (socket,) = bind(run, node, ("Socket",)).required
    value = run.locate(socket).value
    if value.type.name != "socketdev":
        raise run.error(socket, f"SocketGetStatus takes a socketdev, and {run.text(socket)} is a {value.type.name}")
    status = value.data
    return Value(NUM, CLOSED if status is None else status)


def _fastest(run: Context, node: Call) -> Value:
    """The TCP speed of vmax, mm/s."""
    bind(run, node, ())
    return Value(NUM, VMAX)


def _synchronised(run: Context, node: Call) -> Value:
    """Whether moves go together with other robots'."""
    bind(run, node, ())
    return Value(BOOL, run.settings.synchronised)


_UNIT_ACTIVE = _assumed("IsMechUnitActive", BOOL, True)


def _is_active(run: Context, node: Call) -> Value:
    """As ActUnit and DeactUnit have left a unit of the cell; others are taken to be active."""
    (unit,) = bind(run, node, ("MechUnit",)).required
    name = run.unit(unit).lower()
    return Value(BOOL, name in run.units.active) if name in run.units.axes else _UNIT_ACTIVE(run, node)


FUNCTIONS: dict[str, Function] = {
    **{row[0]: _asked(*row) for row in ASKED},
    **{row[0]: _assumed(*row) for row in ASSUMED},
    "ClkRead": _clock,
    "TestAndSet": _test_and_set,
    "ReadDir": _read_directory,
    "GetNextSym": _next_symbol,
    "SocketGetStatus": _socket_status,
    "IsMechUnitActive": _is_active,
    "IsSyncMoveOn": _synchronised,
    "MaxRobSpeed": _fastest,
}
