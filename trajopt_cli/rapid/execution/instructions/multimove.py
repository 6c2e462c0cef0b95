r"""MultiMove: moves that several robots make together, between SyncMoveOn and SyncMoveOff, each with an \ID.

All robots begin and end the moves with one \ID together, so the slowest of them decides (application manual MultiMove,
3HAC021272, "Motion principles"); there every move has an \ID, and no other move has one (same, "Synchronizing
argument"). SyncMoveOn and SyncMoveOff wait for the other tasks, and the robot stands at a stop point for them (RAPID
reference manual, SyncMoveOn and SyncMoveOff, "Limitations").
"""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.rapid.execution.arguments import Arguments, Effect, Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.settings import change
from trajopt_cli.rapid.execution.instructions.waits import record
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall

_MULTIMOVE = Topic("MultiMove")


def together(run: Context, node: ProcedureCall, args: Arguments) -> tuple[int | None, float | None]:
    r"""The \ID of a move and what the other robots take for it [s], each None where nothing says it.

    Raises InputError for a synchronised move without an \ID, and for one with it that is not synchronised.
    """
    if "id" not in args.optional:
        if run.settings.synchronised:
            message = (
                f"{node.name} without \\ID runs behind SyncMoveOn, where every move needs the \\ID that it has in "
            )
            message = f"{message}the other tasks; give it one, or end the sequence with SyncMoveOff before it"
            raise run.error(node, message)
        return None, None
    given = args.optional["id"]
    if given is None:
        raise run.error(node, f"\\ID of {node.name} needs a number, such as \\ID:=10")
    if not run.settings.synchronised:
        message = f"{node.name} has an \\ID, and no SyncMoveOn ran before it"
        raise run.error(given, f"{message}; leave the \\ID out, or start where the program does")
    value = run.number(given)
    if value < 0 or value != int(value):
        raise run.error(given, f"\\ID of {node.name} is {value:.6g}; it takes a whole number from 0")
    run.external.asked("partner", f"{value:.0f}")
    return int(value), run.scenario.partner.get(int(value))


@_MULTIMOVE.instruction(Effect.WAITS, r"SyncMoveOn SyncID TaskList \TimeOut:num", r"SyncMoveOff SyncID \TimeOut:num")
def _meeting(run: Context, node: ProcedureCall, sync: Expression, *_: Expression, timeout: float | None = None) -> None:
    """SyncMoveOn or SyncMoveOff: a wait for the other tasks, at a stop point."""
    name = run.text(sync)
    least = run.external.least(name)
    if least is None and timeout is None:
        message = f"{node.name} {name} waits forever: the cell file says timeout, and \\TimeOut is not given"
        raise Refused(message)
    record(run, node, timeout or 0.0 if least is None else least, name)
    if least is None:
        message = f"{name}: the other tasks do not come within \\TimeOut"
        raise Refused(message, error=f"ERR_{node.name.upper()}")
    change(run, replace(run.settings, synchronised=node.name.lower() == "syncmoveon"))


@_MULTIMOVE.instruction(Effect.WAITS, "SyncMoveSuspend", "SyncMoveResume", "SyncMoveUndo")
def _set(run: Context, node: ProcedureCall) -> None:
    """Moves go together from here on, or each by itself; at a stop point, without a wait for the other tasks."""
    on = node.name.lower() == "syncmoveresume"
    if run.settings.synchronised is not on:
        record(run, node, 0.0, in_position=True)
        change(run, replace(run.settings, synchronised=on))
    else:
        run.ignored[node.name] += 1
