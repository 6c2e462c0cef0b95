"""Settings that change how the robot moves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import number
from trajopt_cli.rapid.language.syntax import Node, ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _refuse(run: Run, node: Node, what: str, holds: str) -> None:
    raise run.error(node, f"{what} is not supported; plans hold to {holds}, so remove it or ask for that")


def _configuration_on(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, (), ("On", "Off"))
    if "off" in args.optional:
        _refuse(run, node, f"{node.name} \\Off", f"the programmed configuration ({node.name} \\On)")


def _acceleration(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Acc", "Ramp"), ("FinePointRamp",))
    if [number(run, value) for value in args.required] != [100.0, 100.0] or args.optional:
        _refuse(run, node, run.text(node).rstrip(";"), "the cell's full acceleration (AccSet 100, 100)")


def _velocity(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Override", "Max"))
    percent, highest = (number(run, value) for value in args.required)
    if percent != 100.0 or highest < 5000.0:
        _refuse(run, node, run.text(node).rstrip(";"), "the programmed speeds (VelSet 100, 5000)")


def _singularity(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, (), ("Off", "Wrist", "LockAxis4"))
    if "off" not in args.optional:
        _refuse(run, node, run.text(node).rstrip(";"), "exact orientation (SingArea \\Off)")


def _grip_load(run: Run, node: ProcedureCall) -> None:
    bind(run, node, ("Load",))
    run.warn(f"{run.source(node)}: GripLoad changes nothing here; the cell's acceleration limits hold for any load")


INSTRUCTIONS: dict[str, Instruction] = {
    "ConfJ": _configuration_on,
    "ConfL": _configuration_on,
    "AccSet": _acceleration,
    "VelSet": _velocity,
    "SingArea": _singularity,
    "GripLoad": _grip_load,
}
