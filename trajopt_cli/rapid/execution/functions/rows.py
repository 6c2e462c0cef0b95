"""Functions whose value only the running cell knows: rows of tables, answered by the scenario.

Nothing looks at the arguments of those that are a row. The stand-ins for what is missing end the loops that read files
to their end, and let a text of a date be cut into parts.
"""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.answers import ask, fill, root
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.rows import CLOSED
from trajopt_cli.rapid.execution.registry import FunctionHandler, Refused, Topic
from trajopt_cli.rapid.language.syntax import Call, Expression
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
# Of these the ones that wait for an operator or for what a device sends: the fly-by point before them is a stop, see
# Effect.STOPS.
_STOPPING = (
    "UIMessageBox", "UINumEntry", "UINumTune", "UIDnumEntry", "UIDnumTune", "UIAlphaEntry", "UIListView", "ReadNum",
    "ReadBin", "ReadStr", "ReadStrBin",
)  # fmt: skip
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


_TOPIC = Topic(__doc__)


def _asked(name: str, type_: Type, what: str, default: Answer | None) -> FunctionHandler:
    return lambda run, node: ask(run, node, name, type_, f"{name} asks for {what}", default)


def _assumed(name: str, type_: Type, data: Data) -> FunctionHandler:
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


for asked in ASKED:
    _TOPIC.enter_function(asked[0], _asked(*asked), stops=asked[0] in _STOPPING)
for assumed in ASSUMED:
    _TOPIC.enter_function(assumed[0], _assumed(*assumed))


@_TOPIC.function(r"ClkRead Clock \HighRes")
def _clock(run: Context, node: Call, clock: Expression, **_: bool) -> Value:
    return ask(run, clock, root(run, clock), NUM, f"ClkRead asks for the seconds on {run.text(clock)}")


@_TOPIC.function("TestAndSet Object")
def _test_and_set(run: Context, node: Call, flag: Expression) -> Value:
    """TRUE where the flag was free; it is taken afterwards."""
    free = not run.condition(flag)
    run.assign(flag, Value(BOOL, True))
    return Value(BOOL, free)


@_TOPIC.function("ReadDir Dev FileName")
def _read_directory(run: Context, node: Call, _: Expression, name: Expression) -> Value:
    """Whether there was one more file, and its name in the variable."""
    return _next(run, node, name, "the folder holds one more file")


@_TOPIC.function(r"GetNextSym Object Block \Recursive")
def _next_symbol(run: Context, node: Call, name: Expression, *_: Expression, **__: bool) -> Value:
    return _next(run, node, name, "the search finds one more name")


def _next(run: Context, node: Call, name: Expression, what: str) -> Value:
    more = ask(run, node, node.name, BOOL, f"{node.name} asks whether {what}")
    if more.data:
        fill(run, name, f"{node.name} reads {run.text(name)}")
    return more


@_TOPIC.function("SocketGetStatus Socket")
def _socket_status(run: Context, node: Call, socket: Expression) -> Value:
    """As the program itself has left the socket; one that it never made is closed."""
    value = run.locate(socket).value
    if value.type.name != "socketdev":
        message = f"SocketGetStatus takes a socketdev, and {run.text(socket)} is a {value.type.name}"
        raise Refused(message, "Socket")
    return Value(NUM, CLOSED if value.data is None else value.data)


_TOPIC.values("MaxRobSpeed", NUM)(lambda: VMAX)  # the TCP speed of vmax, mm/s
_UNIT_ACTIVE = _assumed("IsMechUnitActive", BOOL, True)


@_TOPIC.function("IsSyncMoveOn")
def _synchronised(run: Context, node: Call) -> Value:
    """Whether moves go together with other robots'."""
    return Value(BOOL, run.settings.synchronised)


@_TOPIC.function("IsMechUnitActive MechUnit:unit")
def _is_active(run: Context, node: Call, unit: str) -> Value:
    """As ActUnit and DeactUnit have left a unit of the cell; others are taken to be active."""
    name = unit.lower()
    return Value(BOOL, name in run.units.active) if name in run.units.axes else _UNIT_ACTIVE(run, node)
