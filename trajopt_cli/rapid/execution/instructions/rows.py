r"""Instructions that are a row of a table: those without effect on motion, and those that only ask the scenario.

A row says what an instruction takes, as the manual writes it (`IODevice Data \Time`), and the effect it has. A star
marks an argument whose variable is filled with the scenario's answer under that variable's name.
"""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.execution.answers import fill
from trajopt_cli.rapid.execution.arguments import Arguments, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.effect import Effect, Handler
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall, String

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
    r" \MaxTime \DIBreak \DIPassive \DOBreak \DOPassive \PersBoolBreak \PersBoolPassive \BreakFlag \UIActiveSignal"
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
# Effect, name, what it takes, and the status in which it leaves its first argument.
SOCKET_STATUS = (
    (IGNORED, "SocketCreate", r"Socket \UDP", CREATED),
    (STOPS, "SocketConnect", r"Socket Address Port \Time", CONNECTED),
    (IGNORED, "SocketBind", "Socket LocalAddress LocalPort", BOUND),
    (IGNORED, "SocketListen", "Socket", LISTENING),
    (IGNORED, "SocketClose", "Socket", CLOSED),
)


def _ignore(run: Context, node: ProcedureCall) -> None:
    """Nothing but the instruction's effect."""


def _takes(text: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Required and optional arguments of a row, without stars."""
    names = text.replace("*", "").split()
    return tuple(one for one in names if one[0] != "\\"), tuple(one[1:] for one in names if one[0] == "\\")


def _reads(name: str, takes: str, words: str) -> Handler:
    """Fill the starred arguments; nothing breaks off what an operator does, which \\BreakFlag says."""
    required, optional = _takes(takes)
    filled = {one.strip("\\*").lower() for one in takes.split() if "*" in one}

    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, required, optional)
        given = [*zip((one.lower() for one in required), args.required, strict=True), *args.optional.items()]
        for key, target in given:
            if key in filled and target is not None:
                value = fill(run, target, f"{name} {words} {run.text(target)}")
                if value is None and words == "reads":
                    run.ignored[name] += 1
        _unbroken(run, args)

    return handler


def _unbroken(run: Context, args: Arguments) -> None:
    flag = args.value("breakflag")
    if flag is not None:
        run.assign(flag, Value(NUM, 0.0))


def _leaves(takes: str, status: float) -> Handler:
    required, optional = _takes(takes)

    def handler(run: Context, node: ProcedureCall) -> None:
        _mark(run, bind(run, node, required, optional).required[0], status)

    return handler


def _mark(run: Context, socket: Expression, status: float) -> None:
    place = run.locate(socket)
    if place.type.name != "socketdev":
        raise run.error(socket, f"needs a socketdev, found {run.text(socket)} of type {place.type.name}")
    place.value = Value(place.type, status)


# --------------------------------------------------------------------------------------- those with a rule of their own


def _path(run: Context, node: ProcedureCall) -> None:
    r"""Between StorePath and RestoPath no move may have \Conc (RAPID, argument \Conc)."""
    run.stored = node.name.lower() == "storepath"


def _guided(run: Context, node: ProcedureCall) -> None:
    raise run.error(node, f"{node.name} lets a sensor guide the robot, so its path is not in the program; leave it out")


def _accept(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, ("Socket", "ClientSocket"), ("ClientAddress", "Time"))
    _mark(run, args.required[1], CONNECTED)
    address = args.value("clientaddress")
    if address is not None:
        fill(run, address, f"SocketAccept tells {run.text(address)}, who has connected")


def _receive(run: Context, node: ProcedureCall) -> None:
    options = ("Str", "RawData", "Data", "ReadNoOfBytes", "NoRecBytes", "RemoteAddress", "RemotePort", "Time")
    args = bind(run, node, ("Socket",), options)
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


def _read_key(run: Context, node: ProcedureCall) -> None:
    """A function key, 1 to 5; the first one that has a text stands in."""
    required, optional = _takes(f"TPAnswer TPText TPFK1 TPFK2 TPFK3 TPFK4 TPFK5 {_BREAKS}")
    args = bind(run, node, required, optional)
    answer, _, *keys = args.required
    offered = [i for i, key in enumerate(keys, start=1) if _labelled(key)] or [1]
    value = fill(run, answer, f"TPReadFK asks the operator for {run.text(answer)}, a key of 1..5", float(offered[0]))
    if value is not None and value.data not in (1, 2, 3, 4, 5):
        shown = f"{value.data:.15g} to '{run.text(answer)}'"
        raise run.error(answer, f"the answer {shown} in the cell file is not a key from 1 to 5")
    _unbroken(run, args)


def _labelled(key: Expression) -> bool:
    if isinstance(key, String):
        return bool(key.value.strip())
    return not (isinstance(key, Name) and key.name.lower() == "stempty")


# By topic, effect and name.
INSTRUCTIONS: list[tuple[str, Effect, str, Handler]] = [
    *[(topic, effect, name, _ignore) for topic, effect, names in UNREAD for name in names.split()],
    *[(topic, effect, name, _reads(name, takes, words)) for topic, effect, name, takes, words in READ],
    *[(SOCKETS, effect, name, _leaves(takes, status)) for effect, name, takes, status in SOCKET_STATUS],
    (SOCKETS, STOPS, "SocketAccept", _accept),
    (SOCKETS, STOPS, "SocketReceive", _receive),
    (SOCKETS, STOPS, "SocketReceiveFrom", _receive),
    (OPERATOR, STOPS, "TPReadFK", _read_key),
    (OTHERS, STOPS, "StorePath", _path),
    (OTHERS, IGNORED, "RestoPath", _path),
    (OTHERS, REFUSED, "EGMRunJoint", _guided),
    (OTHERS, REFUSED, "EGMRunPose", _guided),
]
