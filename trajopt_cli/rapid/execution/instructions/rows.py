r"""Instructions and functions that are a row of a table: those without effect on motion, and that ask the cell file.

A row says what an instruction takes, as the manual writes it (`IODevice Data \Time`), and the effect it has. A star
marks an argument whose variable is filled with the scenario's answer under that variable's name. Nothing looks at the
arguments of functions that are a row. The stand-ins for what is missing end the loops that read files to their end, and
let a text of a date be cut into parts.
"""

from __future__ import annotations

from typing import Any

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.answers import ask, fill, root
from trajopt_cli.rapid.execution.arguments import Effect, FunctionHandler, Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Call, Expression, Name, ProcedureCall, String
from trajopt_cli.scenario import Answer, yaml_answer
from trajopt_cli.warnings import WarningKind

IGNORED, STOPS, RUN, REFUSED = Effect.IGNORED, Effect.STOPS, Effect.RUN, Effect.REFUSED
FILES = "Files, serial channels, raw bytes and configuration"
OPERATOR = "What the operator is asked on the pendant"
SOCKETS = "Sockets and cameras"
MODULES = "Data and modules by name at run time"
OTHERS = "Instructions whose arguments are not looked at"

# Of these the arguments are not even looked at.
UNREAD = (
    (FILES, IGNORED, """
        Open Close Write WriteBin WriteStrBin WriteAnyBin WriteRawBytes WriteBlock WriteVar Rewind ClearIOBuff
        OpenDir CloseDir MakeDir RemoveDir RemoveFile RenameFile CopyFile
        ClearRawBytes CopyRawBytes PackDNHeader PackRawBytes SiClose SiSetCyclic"""),
    (FILES, STOPS, "ReadBlock SiConnect"),
    (SOCKETS, IGNORED, """
        SocketSend SocketSendTo CamFlush CamReqImage CamSetExposure CamSetParameter CamSetProgramMode CamSetRunMode
        CamStartLoadJob"""),
    (SOCKETS, STOPS, "CamLoadJob CamWaitLoadJob"),
    (OTHERS, IGNORED, """
        TPErase TPShow TPWrite UIShow
        ErrLog ErrWrite

        ClkReset ClkStart ClkStop

        IDelete IDisable IEnable IError IPers ISleep IWatch ITimer ISignalAI ISignalAO ISignalDI ISignalDO ISignalGI
        ISignalGO IRMQMessage IVarValue GetTrapData RMQEmptyQueue RMQFindSlot RMQSendMessage

        ClearPath StartMove StopMoveReset PathRecStart PathRecStop
        CornerPathWarning MotionProcessModeSet MotionSup PathLengthReset PathLengthStart PathLengthStop
        PathResol SoftAct SoftDeact
        SupSyncSensorOff SupSyncSensorOn WaitSensorReset
        MotionPlannerSet

        WZBoxDef WZCylDef WZDisable WZDOSet WZEnable WZFree WZHomeJointDef WZLimJointDef WZLimSup WZSphDef
        EGMActJoint EGMActMove EGMActPose EGMGetId EGMReset EGMSetupAI EGMSetupAO EGMSetupGI EGMSetupLTAPP EGMSetupUC
        EGMStop EGMStreamStart EGMStreamStop
        DitherAct DitherDeact TuneReset TuneServo

        ActEventBuffer DeactEventBuffer UIMsgWrite UIMsgWriteAbort
        SpyStart SpyStop TestSignDefine TestSignReset TriggStopProc
        IOBusStart SaveSysData WriteCfgData SetDataSearch
        CheckProgRef EraseModule Save TextTabInstall"""),
    (OTHERS, STOPS, """
        EGMWaitCond IODisable IOEnable RMQReadWait RMQSendWait SetLeadThrough StopMove SystemStopAction"""),
)  # fmt: skip

_BREAKS = (
    r" \MaxTime \DIBreak \DIPassive \DOBreak \DOPassive \PersBoolBreak \PersBoolPassive \BreakFlag:expr \UIActiveSignal"
)
_LINES = r"\Header \MsgLine2 \MsgLine3 \MsgLine4 \MsgLine5 \Wrap \Buttons \Icon \Image"
_TEXTS = r"\*Title \*Str1 \*Str2 \*Str3 \*Str4 \*Str5"

# Topic, effect, name, what it takes, and the words between its name and the variable that it asks for.
READ = (
    (FILES, RUN, "ReadErrData", rf"TrapEvent *ErrorDomain *ErrorId *ErrorType {_TEXTS}", "reads"),
    (FILES, STOPS, "ReadAnyBin", r"IODevice *Data \Time", "reads"),
    (FILES, STOPS, "ReadRawBytes", r"IODevice *RawData \Time", "reads"),
    (FILES, RUN, "ReadCfgData", r"InstancePath Attribute *CfgData \ListNo", "reads"),
    (FILES, RUN, "UnpackRawBytes", r"RawData StartIndex *Value \Network \Hex1 \IntX \Float4 \ASCII", "reads"),
    (FILES, RUN, "RMQGetMsgData", "Message *Data", "reads"),
    (OPERATOR, STOPS, "TPReadNum", rf"*TPAnswer TPText {_BREAKS}", "asks the operator for"),
    (OPERATOR, STOPS, "TPReadDnum", rf"*TPAnswer TPText {_BREAKS}", "asks the operator for"),
    (OPERATOR, STOPS, "UIMsgBox", rf"MsgLine1 {_LINES} \*Result {_BREAKS}", "asks the operator for"),
    (SOCKETS, STOPS, "CamGetParameter", r"Camera ParName \*NumVar \*BoolVar \*StrVar", "asks the camera for"),
    (SOCKETS, STOPS, "CamGetResult", r"Camera *CamTarget \SceneId \MaxTime", "asks the camera for"),
    (MODULES, STOPS, "WaitLoad", r"LoadNo \UnloadPath \UnloadFile \CheckRef", ""),
    (MODULES, IGNORED, "UnLoad", r"FilePath \ErrIfChanged \Save \File", ""),  # one that is not used is not noticed
    (OTHERS, IGNORED, "SkipWarn", "", ""),
    (OTHERS, IGNORED, "HollowWristReset", "", ""),
)

# SOCKET_CREATED ... SOCKET_CLOSED of the manual: a socket knows its own status, so that a program that waits for a
# connection goes on.
CREATED, CONNECTED, BOUND, LISTENING, CLOSED = 1.0, 2.0, 3.0, 4.0, 5.0
# Effect, name with what it takes, and the status in which it leaves its first argument.
SOCKET_STATUS = (
    (IGNORED, r"SocketCreate Socket \UDP", CREATED),
    (STOPS, r"SocketConnect Socket Address Port \Time", CONNECTED),
    (IGNORED, "SocketBind Socket LocalAddress LocalPort", BOUND),
    (IGNORED, "SocketListen Socket", LISTENING),
    (IGNORED, "SocketClose Socket", CLOSED),
)


def _ignore(run: Context, node: ProcedureCall) -> None:
    """Nothing but the instruction's effect."""


def _reads(topic: str, effect: Effect, name: str, takes: str, words: str) -> None:
    """Fill the starred arguments; nothing breaks off what an operator does, which \\BreakFlag says."""
    words_of = [word for word in takes.split() if word[0] != "\\"]
    form = " ".join(f"{word.replace('*', '')}:expr" if "\\*" in word else word.strip("*") for word in takes.split())

    @Topic(topic).instruction(effect, f"{name} {form}")
    def handler(run: Context, node: ProcedureCall, *required: Expression, **options: Any) -> None:
        given = [one for word, one in zip(words_of, required, strict=True) if word[0] == "*"]
        given += [one for key, one in options.items() if rf"\*{key}" in takes.lower().split()]
        for target in given:
            value = fill(run, target, f"{name} {words} {run.text(target)}")
            if value is None and words == "reads":
                run.ignored[name] += 1
        _unbroken(run, **options)


def _unbroken(run: Context, breakflag: Expression | None = None, **_: object) -> None:
    if breakflag is not None:
        run.assign(breakflag, Value(NUM, 0.0))


def _leaves(effect: Effect, form: str, status: float) -> None:
    @Topic(SOCKETS).instruction(effect, form)
    def handler(run: Context, node: ProcedureCall, socket: Expression, *_: Expression, **__: bool) -> None:
        _mark(run, socket, status)


def _mark(run: Context, socket: Expression, status: float) -> None:
    place = run.locate(socket)
    if place.type.name != "socketdev":
        raise run.error(socket, f"needs a socketdev, found {run.text(socket)} of type {place.type.name}")
    place.value = Value(place.type, status)


for topic, effect, names in UNREAD:
    Topic(topic).enter(effect, *names.split())(_ignore)
for row in READ:
    _reads(*row)
for status in SOCKET_STATUS:
    _leaves(*status)

# --------------------------------------------------------------------------------------- those with a rule of their own


@Topic(OTHERS).enter(STOPS, "StorePath")
@Topic(OTHERS).enter(IGNORED, "RestoPath")
def _path(run: Context, node: ProcedureCall) -> None:
    r"""Between StorePath and RestoPath no move may have \Conc (RAPID, argument \Conc)."""
    run.stored = node.name.lower() == "storepath"


@Topic(OTHERS).enter(REFUSED, "EGMRunJoint", "EGMRunPose")
def _guided(run: Context, node: ProcedureCall) -> None:
    raise run.error(node, f"{node.name} lets a sensor guide the robot, so its path is not in the program; leave it out")


@Topic(SOCKETS).instruction(STOPS, r"SocketAccept Socket ClientSocket \ClientAddress:expr \Time")
def _accept(
    run: Context,
    node: ProcedureCall,
    _: Expression,
    client: Expression,
    clientaddress: Expression | None = None,
    time: bool = False,
) -> None:
    _mark(run, client, CONNECTED)
    if clientaddress is not None:
        fill(run, clientaddress, f"SocketAccept tells {run.text(clientaddress)}, who has connected")


_RECEIVED = r"\Str:expr \RawData:expr \Data:expr \RemoteAddress:expr \RemotePort:expr"


@Topic(SOCKETS).instruction(
    STOPS,
    *(
        rf"{name} Socket {_RECEIVED} \ReadNoOfBytes \NoRecBytes:expr \Time"
        for name in ("SocketReceive", "SocketReceiveFrom")
    ),
)
def _receive(
    run: Context, node: ProcedureCall, _: Expression, norecbytes: Expression | None = None, **options: Any
) -> None:
    received: Value | None = None
    for name in ("str", "rawdata", "data", "remoteaddress", "remoteport"):
        if name in options:
            value = fill(run, options[name], f"{node.name} receives {run.text(options[name])}")
            received = value if name == "str" else received
    if norecbytes is not None and received is not None:
        run.assign(norecbytes, Value(NUM, float(len(str(received.data)))))
    elif norecbytes is not None:
        fill(run, norecbytes, f"{node.name} counts the bytes it receives in {run.text(norecbytes)}")


@Topic(OPERATOR).instruction(STOPS, f"TPReadFK TPAnswer TPText TPFK1 TPFK2 TPFK3 TPFK4 TPFK5 {_BREAKS}")
def _read_key(
    run: Context, node: ProcedureCall, answer: Expression, text: Expression, *keys: Expression, **options: Any
) -> None:
    """A function key, 1 to 5; the first one that has a text stands in."""
    offered = [i for i, key in enumerate(keys, start=1) if _labelled(key)] or [1]
    value = fill(run, answer, f"TPReadFK asks the operator for {run.text(answer)}, a key of 1..5", float(offered[0]))
    if value is not None and value.data not in (1, 2, 3, 4, 5):
        shown = f"{value.data:.15g} to '{run.text(answer)}'"
        raise Refused(f"the answer {shown} in the cell file is not a key from 1 to 5", "TPAnswer")
    _unbroken(run, **options)


def _labelled(key: Expression) -> bool:
    if isinstance(key, String):
        return bool(key.value.strip())
    return not (isinstance(key, Name) and key.name.lower() == "stempty")


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


_CELL = Topic("Functions whose value only the running cell knows")


def _asked(name: str, type_: Type, what: str, default: Answer | None) -> FunctionHandler:
    return lambda run, node: ask(run, node, name, type_, f"{name} asks for {what}", default)


def _assumed(name: str, type_: Type, data: Data) -> FunctionHandler:
    def handler(run: Context, node: Call) -> Value:
        if run.external.known(name):
            return ask(run, node, name, type_, f"{name} asks for its value")
        shown = yaml_answer(data)
        what = f"{name}() is taken to be {shown}; another value is an answer in the cell file, '{name}: {shown}'"
        run.warn(WarningKind.ASSUMED, what)
        return Value(type_, data)

    return handler


for asked in ASKED:
    _CELL.enter_function(asked[0], _asked(*asked), stops=asked[0] in _STOPPING)
for assumed in ASSUMED:
    _CELL.enter_function(assumed[0], _assumed(*assumed))


@_CELL.function(r"ClkRead Clock \HighRes")
def _clock(run: Context, node: Call, clock: Expression, **_: bool) -> Value:
    return ask(run, clock, root(run, clock), NUM, f"ClkRead asks for the seconds on {run.text(clock)}")


@_CELL.function("TestAndSet Object")
def _test_and_set(run: Context, node: Call, flag: Expression) -> Value:
    """TRUE where the flag was free; it is taken afterwards."""
    free = not run.condition(flag)
    run.assign(flag, Value(BOOL, True))
    return Value(BOOL, free)


@_CELL.function("ReadDir Dev FileName")
def _read_directory(run: Context, node: Call, _: Expression, name: Expression) -> Value:
    """Whether there was one more file, and its name in the variable."""
    return _next(run, node, name, "the folder holds one more file")


@_CELL.function(r"GetNextSym Object Block \Recursive")
def _next_symbol(run: Context, node: Call, name: Expression, *_: Expression, **__: bool) -> Value:
    return _next(run, node, name, "the search finds one more name")


def _next(run: Context, node: Call, name: Expression, what: str) -> Value:
    more = ask(run, node, node.name, BOOL, f"{node.name} asks whether {what}")
    if more.data:
        fill(run, name, f"{node.name} reads {run.text(name)}")
    return more


@_CELL.function("SocketGetStatus Socket")
def _socket_status(run: Context, node: Call, socket: Expression) -> Value:
    """As the program itself has left the socket; one that it never made is closed."""
    value = run.locate(socket).value
    if value.type.name != "socketdev":
        message = f"SocketGetStatus takes a socketdev, and {run.text(socket)} is a {value.type.name}"
        raise Refused(message, "Socket")
    return Value(NUM, CLOSED if value.data is None else value.data)


_CELL.values("MaxRobSpeed", NUM)(lambda: VMAX)  # the TCP speed of vmax, mm/s
_UNIT_ACTIVE = _assumed("IsMechUnitActive", BOOL, True)


_CELL.function("IsSyncMoveOn")(lambda run, node: Value(BOOL, run.settings.synchronised))  # with other robots


@_CELL.function("IsMechUnitActive MechUnit:unit")
def _is_active(run: Context, node: Call, unit: str) -> Value:
    """As ActUnit and DeactUnit have left a unit of the cell; others are taken to be active."""
    name = unit.lower()
    return Value(BOOL, name in run.units.active) if name in run.units.axes else _UNIT_ACTIVE(run, node)
