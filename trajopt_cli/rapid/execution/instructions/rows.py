r"""Instructions that are a row of a table: those without effect on motion, and those that only ask the scenario.

A row says what an instruction takes, as the manual writes it (`IODevice Data \Time`), and the effect it has. A star
marks an argument whose variable is filled with the scenario's answer under that variable's name.
"""

from __future__ import annotations

from typing import Any

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.execution.answers import fill
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.registry import Effect, Refused, Topic
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
