"""How a running statement leaves its place: exceptions that are no errors."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import Value
from trajopt_cli.rapid.language.syntax import Goto


class Exit(Exception):
    """The program says that it is over."""


class Return(Exception):
    """RETURN was run; value None in a PROC."""

    def __init__(self, value: Value | None):
        self.value = value


class Jump(Exception):
    """GOTO was run."""

    def __init__(self, node: Goto):
        self.node = node


class Retry(Exception):
    """RETRY was run."""


class TryNext(Exception):
    """TRYNEXT was run."""
