"""Instructions without effect on motion: counted in Run.ignored, their arguments not even looked at."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.execution.arguments import Instruction
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def nothing(name: str) -> Instruction:
    """The handler of an instruction that does nothing here; name: as in the manual."""

    def handler(run: Run, node: ProcedureCall) -> None:
        run.ignored[name] += 1

    return handler


_NAMES = """
    TPErase TPShow TPWrite UIShow
    ErrLog ErrWrite ProcerrRecovery

    ClkReset ClkStart ClkStop

    IDelete IDisable IEnable IError IPers ISleep IWatch ITimer ISignalAI ISignalAO ISignalDI ISignalDO ISignalGI
    ISignalGO IRMQMessage IVarValue GetTrapData RMQEmptyQueue RMQFindSlot RMQReadWait RMQSendMessage RMQSendWait

    ClearPath RestoPath StartMove StartMoveRetry StopMove StopMoveReset StorePath PathRecStart PathRecStop
    CornerPathWarning MotionProcessModeSet MotionSup PathLengthReset PathLengthStart PathLengthStop
    PathResol SoftAct SoftDeact
    DropSensor DropWObj SupSyncSensorOff SupSyncSensorOn WaitSensorReset
    WaitSyncTask MotionPlannerSet

    WZBoxDef WZCylDef WZDisable WZDOSet WZEnable WZFree WZHomeJointDef WZLimJointDef WZLimSup WZSphDef
    EGMActJoint EGMActMove EGMActPose EGMGetId EGMReset EGMSetupAI EGMSetupAO EGMSetupGI EGMSetupLTAPP EGMSetupUC
    EGMStop EGMStreamStart EGMStreamStop EGMWaitCond
    DitherAct DitherDeact TuneReset TuneServo SetLeadThrough

    ActEventBuffer DeactEventBuffer UIMsgWrite UIMsgWriteAbort
    SpyStart SpyStop TestSignDefine TestSignReset TriggStopProc
    IOBusStart IODisable IOEnable SaveSysData WriteCfgData SetDataSearch
    CheckProgRef EraseModule Save TextTabInstall
"""


def _guided(run: Run, node: ProcedureCall) -> None:
    """Not nothing at all, but nothing that a program tells."""
    raise run.error(node, f"{node.name} lets a sensor guide the robot, so its path is not in the program; leave it out")


INSTRUCTIONS: dict[str, Instruction] = {
    **{name: nothing(name) for name in _NAMES.split()},
    "EGMRunJoint": _guided,
    "EGMRunPose": _guided,
}
