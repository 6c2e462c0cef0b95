"""Every supported instruction and function by name: their files enter them when they are imported."""

from __future__ import annotations

from trajopt_cli.rapid.execution.arguments import FUNCTIONS, INSTRUCTIONS
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
    targets,
    triggers,
    units,
    values,
    waits,
)

FILES = (
    moves, triggers, searches, processes, displacement, waits, signals, settings, units, flow, multimove, rows, targets,
    values,
)  # fmt: skip
__all__ = ["FUNCTIONS", "INSTRUCTIONS"]
