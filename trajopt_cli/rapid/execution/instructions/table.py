"""Every supported instruction by name: its handler, its effect and its topic in the manual."""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType
from typing import NamedTuple

from trajopt_cli.rapid.execution.instructions import (
    displacement,
    flow,
    moves,
    multimove,
    processes,
    rows,
    searches,
    settings,
    signals,
    symbols,
    triggers,
    units,
    variables,
    waits,
)
from trajopt_cli.rapid.execution.instructions.effect import Effect, Handler


class Instruction(NamedTuple):
    """An instruction; name as the manual spells it."""

    name: str
    topic: str
    effect: Effect
    handler: Handler


def _of(module: ModuleType) -> Iterator[Instruction]:
    """The instructions of a file; its docstring's first words are their topic."""
    topic = (module.__doc__ or "").split("\n")[0].split(":")[0].rstrip(".")
    for effect, handlers in module.INSTRUCTIONS.items():
        for name, handler in handlers.items():
            yield Instruction(name, topic, effect, handler)


TOPICS = (
    moves, triggers, searches, processes, displacement, waits, signals, variables, settings, units, flow, symbols,
    multimove,
)  # fmt: skip
INSTRUCTIONS: dict[str, Instruction] = {
    **{one.name: one for module in TOPICS for one in _of(module)},
    **{name: Instruction(name, topic, effect, handler) for topic, effect, name, handler in rows.INSTRUCTIONS},
}
