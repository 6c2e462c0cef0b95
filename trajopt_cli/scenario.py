"""What a program cannot know about its world: signal values and how long its waits last at least."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Scenario:
    """signals: value per signal name in lower case. waits: least duration [s] per signal or condition, as written in
    the program, blanks and case ignored. pass_limit: how often one loop may run before the reader gives up."""

    signals: Mapping[str, float] = field(default_factory=dict)
    waits: Mapping[str, float] = field(default_factory=dict)
    pass_limit: int = 100_000
