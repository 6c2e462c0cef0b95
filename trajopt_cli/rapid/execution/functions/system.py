"""Functions about the controller: taken as a robot's in automatic operation, and said so; the scenario overrides."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import BOOL, NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.answers import ask
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.units import unit_name
from trajopt_cli.rapid.language.syntax import Call
from trajopt_cli.scenario import yaml_answer
from trajopt_cli.warnings import WarningKind

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

# OP_AUTO and RUN_CONT_CYCLE of the manual
_AUTOMATIC, _CONTINUOUS = 1.0, 1.0


def _taken(name: str, type_: Type, data: Data) -> tuple[str, Function]:
    """A function with a value that is assumed, under its own name in the scenario."""

    def handler(run: Execution, node: Call) -> Value:
        if run.world.known(name):
            return ask(run, node, name, type_, f"{name} asks for its value")
        shown = yaml_answer(data)
        run.warn(
            WarningKind.ASSUMED,
            f"{name}() is taken to be {shown}; another value is an answer in the cell file, '{name}: {shown}'",
        )
        return Value(type_, data)

    return name, handler


def _fastest(run: Execution, node: Call) -> Value:
    """The TCP speed of vmax, mm/s."""
    bind(run, node, ())
    return Value(NUM, VMAX)


def _synchronised(run: Execution, node: Call) -> Value:
    """Whether moves go together with other robots'."""
    bind(run, node, ())
    return Value(BOOL, run.settings.synchronised)


_TAKEN: tuple[tuple[str, Function], ...] = (
    _taken("OpMode", NUM, _AUTOMATIC),
    _taken("RunMode", NUM, _CONTINUOUS),
    _taken("RobOS", BOOL, True),
    _taken("RobName", STRING, "ROB_1"),
    _taken("GetTaskName", STRING, "T_ROB1"),
    _taken("TaskRunMec", BOOL, True),
    _taken("TaskRunRob", BOOL, True),
    _taken("TaskIsActive", BOOL, True),
    _taken("TaskIsExecuting", BOOL, True),
    _taken("TaskInSync", BOOL, False),
    _taken("IsStopMoveAct", BOOL, False),
    _taken("NonMotionMode", BOOL, False),
    _taken("MotionPlannerNo", NUM, 1.0),
    _taken("EventType", NUM, 0.0),
    _taken("ExecHandler", NUM, 0.0),
    _taken("ExecLevel", NUM, 0.0),
    _taken("PFRestart", BOOL, False),
    _taken("IsBrakeCheckActive", BOOL, False),
    _taken("UIClientExist", BOOL, True),
)

_ASSUMED_ACTIVE = _taken("IsMechUnitActive", BOOL, True)[1]


def _is_active(run: Execution, node: Call) -> Value:
    """As ActUnit and DeactUnit have left a unit of the cell; others are taken to be active."""
    (unit,) = bind(run, node, ("MechUnit",)).required
    name = unit_name(run, unit).lower()
    return Value(BOOL, name in run.units.active) if name in run.units.axes else _ASSUMED_ACTIVE(run, node)


FUNCTIONS: dict[str, Function] = {
    **dict(_TAKEN),
    "IsMechUnitActive": _is_active,
    "IsSyncMoveOn": _synchronised,
    "MaxRobSpeed": _fastest,
}
