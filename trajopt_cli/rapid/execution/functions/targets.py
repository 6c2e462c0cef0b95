"""Functions that compute targets."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import ROBTARGET, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.evaluate import evaluate, number
from trajopt_cli.rapid.language.syntax import Call
from trajopt_cli.units import DEG

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _offs(run: Run, node: Call) -> Value:
    """The target shifted along the axes of the work object; orientation, configuration, external axes kept."""
    point, *shifts = bind(run, node, ("Point", "XOffset", "YOffset", "ZOffset")).required
    (x, y, z), *rest = evaluate(run, point, ROBTARGET).data
    dx, dy, dz = (number(run, shift) for shift in shifts)
    return Value(ROBTARGET, ((x + dx, y + dy, z + dz), *rest))


def _rel_tool(run: Run, node: Call) -> Value:
    """The target shifted along its own tool axes, then turned about the new x, the new y and the new z."""
    args = bind(run, node, ("Point", "Dx", "Dy", "Dz"), ("Rx", "Ry", "Rz"))
    point, *shifts = args.required
    p, q, *rest = evaluate(run, point, ROBTARGET).data
    if frames.norm(q) == 0:
        raise run.error(point, f"{run.text(point)} has orientation [0,0,0,0]: it was never given a value")
    dx, dy, dz = (number(run, shift) for shift in shifts)
    moved = frames.compose((p, frames.normalised(q)), ((dx, dy, dz), (1.0, 0.0, 0.0, 0.0)))[0]
    for axis, name in enumerate(("rx", "ry", "rz")):
        turn = args.value(name)
        if turn is not None:
            q = frames.product(q, frames.about(axis, number(run, turn) * DEG))
    return Value(ROBTARGET, (moved, q, *rest))


FUNCTIONS: dict[str, Function] = {
    "Offs": _offs,
    "RelTool": _rel_tool,
}
