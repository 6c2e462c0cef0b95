"""Instructions whose arguments are not looked at: their effect is all there is to them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.execution.arguments import Instruction
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution


def plain(run: Execution, node: ProcedureCall) -> None:
    """Nothing but the instruction's effect."""


def _path(run: Execution, node: ProcedureCall) -> None:
    """Between StorePath and RestoPath no move may have \\Conc (RAPID, argument \\Conc)."""
    run.stored = node.name.lower() == "storepath"


def _guided(run: Execution, node: ProcedureCall) -> None:
    raise run.error(node, f"{node.name} lets a sensor guide the robot, so its path is not in the program; leave it out")


_NAMES = {
    Effect.IGNORED: """
        TPErase TPShow TPWrite UIShow
        ErrLog ErrWrite

        ClkReset ClkStart ClkStop

        IDelete IDisable IEnable IError IPers ISleep IWatch ITimer ISignalAI ISignalAO ISignalDI ISignalDO ISignalGI
        ISignalGO IRMQMessage IVarValue GetTrapData RMQEmptyQueue RMQFindSlot RMQSendMessage

        ClearPath RestoPath StartMove StopMoveReset PathRecStart PathRecStop
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
        CheckProgRef EraseModule Save TextTabInstall
    """,
    Effect.STOPS: """
        EGMWaitCond IODisable IOEnable RMQReadWait RMQSendWait SetLeadThrough StopMove StorePath
        SystemStopAction
    """,
    Effect.REFUSED: "EGMRunJoint EGMRunPose",
}
EFFECTS = {name: effect for effect, names in _NAMES.items() for name in names.split()}
INSTRUCTIONS: dict[str, Instruction] = {
    **{name: _guided if effect is Effect.REFUSED else plain for name, effect in EFFECTS.items()},
    "StorePath": _path,
    "RestoPath": _path,
}
