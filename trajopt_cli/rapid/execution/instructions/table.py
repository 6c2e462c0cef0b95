"""Every supported instruction by name: one handler and one line in the INSTRUCTIONS of its topic, and its effect."""

from __future__ import annotations

from trajopt_cli.rapid.execution.arguments import Instruction
from trajopt_cli.rapid.execution.instructions import (
    displacement,
    files,
    flow,
    moves,
    multimove,
    no_effect,
    operator,
    processes,
    searches,
    settings,
    signals,
    sockets,
    symbols,
    triggers,
    units,
    variables,
    waits,
)
from trajopt_cli.rapid.execution.instructions.effect import Effect

INSTRUCTIONS: dict[str, Instruction] = {
    **moves.INSTRUCTIONS,
    **triggers.INSTRUCTIONS,
    **searches.INSTRUCTIONS,
    **processes.INSTRUCTIONS,
    **displacement.INSTRUCTIONS,
    **waits.INSTRUCTIONS,
    **signals.INSTRUCTIONS,
    **variables.INSTRUCTIONS,
    **settings.INSTRUCTIONS,
    **units.INSTRUCTIONS,
    **flow.INSTRUCTIONS,
    **files.INSTRUCTIONS,
    **operator.INSTRUCTIONS,
    **sockets.INSTRUCTIONS,
    **symbols.INSTRUCTIONS,
    **multimove.INSTRUCTIONS,
    **no_effect.INSTRUCTIONS,
}
_TOPICS = (
    moves, triggers, searches, processes, displacement, waits, signals, variables, settings, units, flow, files,
    operator, sockets, symbols, multimove, no_effect,
)  # fmt: skip


def effects(topic: object) -> dict[str, Effect]:
    """The effect of every instruction of a topic: its own in EFFECTS, else the topic's EFFECT, else RUN."""
    own, default = getattr(topic, "EFFECTS", {}), getattr(topic, "EFFECT", Effect.RUN)
    return {name: own.get(name, default) for name in getattr(topic, "INSTRUCTIONS", {})}


EFFECTS: dict[str, Effect] = {name: effect for topic in _TOPICS for name, effect in effects(topic).items()}
