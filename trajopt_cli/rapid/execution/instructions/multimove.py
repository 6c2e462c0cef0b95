r"""MultiMove: moves that several robots make together, between SyncMoveOn and SyncMoveOff, each with an \ID.

All robots begin and end the moves with one \ID together, so the slowest of them decides (application manual MultiMove,
3HAC021272, "Motion principles"); there every move has an \ID, and no other move has one (same, "Synchronizing
argument"). SyncMoveOn and SyncMoveOff wait for the other tasks, and the robot stands at a stop point for them (RAPID
reference manual, SyncMoveOn and SyncMoveOff, "Limitations").
"""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.rapid.execution.arguments import Arguments, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.effect import Effect, Handler, Topic
from trajopt_cli.rapid.execution.instructions.settings import change
from trajopt_cli.rapid.execution.instructions.waits import record
from trajopt_cli.rapid.language.syntax import ProcedureCall


def together(run: Context, node: ProcedureCall, args: Arguments) -> tuple[int | None, float | None]:
    r"""The \ID of a move and what the other robots take for it [s], each None where nothing says it.

    Raises InputError for a synchronised move without an \ID, and for one with it that is not synchronised.
    """
    if "id" not in args.optional:
        if run.settings.synchronised:
            message = (
                f"{node.name} without \\ID runs behind SyncMoveOn, where every move needs the \\ID that it has in "
            )
            raise run.error(
                node, f"{message}the other tasks; give it one, or end the sequence with SyncMoveOff before it"
            )
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


def _meeting(on: bool, required: tuple[str, ...]) -> Handler:
    """SyncMoveOn or SyncMoveOff: a wait for the other tasks, at a stop point."""

    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, required, ("TimeOut",))
        name = run.text(args.required[0])
        limit, least = args.value("timeout"), run.external.least(name)
        if least is None and limit is None:
            raise run.error(
                node, f"{node.name} {name} waits forever: the cell file says timeout, and \\TimeOut is not given"
            )
        record(run, node, run.number(limit) if least is None and limit is not None else least or 0.0, name)
        if least is None:
            raise run.fault(node, f"ERR_{node.name.upper()}", f"{name}: the other tasks do not come within \\TimeOut")
        change(run, replace(run.settings, synchronised=on))

    return handler


def _set(on: bool) -> Handler:
    """Moves go together from here on, or each by itself; at a stop point, without a wait for the other tasks."""

    def handler(run: Context, node: ProcedureCall) -> None:
        bind(run, node, ())
        if run.settings.synchronised is not on:
            record(run, node, 0.0, in_position=True)
            change(run, replace(run.settings, synchronised=on))
        else:
            run.ignored[node.name] += 1

    return handler


INSTRUCTIONS: Topic = {
    Effect.WAITS: {
        "SyncMoveOn": _meeting(True, ("SyncID", "TaskList")),
        "SyncMoveOff": _meeting(False, ("SyncID",)),
        "SyncMoveSuspend": _set(False),
        "SyncMoveResume": _set(True),
        "SyncMoveUndo": _set(False),
    }
}
