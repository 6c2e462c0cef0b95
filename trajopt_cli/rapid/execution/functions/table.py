"""Every supported function by name: one handler and one line in the FUNCTIONS of its topic."""

from __future__ import annotations

from trajopt_cli.rapid.execution.arguments import Function
from trajopt_cli.rapid.execution.functions import data, numbers, poses, rows, signals, strings, targets

TOPICS = (targets, poses, numbers, data, signals, strings, rows)
FUNCTIONS: dict[str, Function] = {name: handler for topic in TOPICS for name, handler in topic.FUNCTIONS.items()}
# Those that wait for an operator or for what a device sends: the fly-by point before them is a stop, see Effect.STOPS.
STOPPING = (
    "UIMessageBox", "UINumEntry", "UINumTune", "UIDnumEntry", "UIDnumTune", "UIAlphaEntry", "UIListView", "ReadNum",
    "ReadBin", "ReadStr", "ReadStrBin",
)  # fmt: skip
