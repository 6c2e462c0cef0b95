"""Every supported instruction and function by name: their files enter them when they are imported."""

from __future__ import annotations

from trajopt_cli.rapid.execution.functions import data, numbers, poses, rows, strings, targets
from trajopt_cli.rapid.execution.functions import signals as read_signals
from trajopt_cli.rapid.execution.instructions import (
    displacement,
    flow,
    moves,
    multimove,
    processes,
    searches,
    settings,
    signals,
    symbols,
    triggers,
    units,
    variables,
    waits,
)
from trajopt_cli.rapid.execution.instructions import rows as instruction_rows
from trajopt_cli.rapid.execution.registry import FUNCTIONS, INSTRUCTIONS

FILES = (
    moves, triggers, searches, processes, displacement, waits, signals, variables, settings, units, flow, symbols,
    multimove, instruction_rows, targets, poses, numbers, data, read_signals, strings, rows,
)  # fmt: skip
__all__ = ["FUNCTIONS", "INSTRUCTIONS"]
