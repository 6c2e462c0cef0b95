"""What a running program finds out about its world: signals and answers as the scenario gives them.

What the scenario lacks is noted once per name and stands in as 0, so that one run finds everything that is missing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.scenario import Answer, Lack, Scenario

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run
    from trajopt_cli.rapid.language.syntax import Node


class World:
    """Signal values and answers as they stand now; names in lower case."""

    def __init__(self, scenario: Scenario):
        self.scenario = scenario
        self.lacks: dict[tuple[str, str], Lack] = {}
        self._values: dict[str, float] = {}
        self._read: dict[tuple[str, str], int] = {}  # how often a sequence was read

    def lack(self, run: Run, section: str, name: str, node: Node, reason: str, value: str) -> None:
        """Note that the scenario lacks something, once per name; see Lack for what the parts mean."""
        key = (section, name.lower())
        if key not in self.lacks:
            self.lacks[key] = Lack(section, name, run.source(node), reason, value)

    def set(self, signal: str, value: float) -> None:
        """The program sets a signal, or a wait has made sure of its value."""
        self._values[signal] = value

    def output(self, signal: str) -> float:
        """What the program last set a signal to; 0 before."""
        return self._values.get(signal, 0.0)

    def signal(self, run: Run, node: Node, name: str) -> float:
        """The value that a reading of a signal gives; name as the program spells it."""
        key = name.lower()
        if key in self._values:
            return self._values[key]
        given = self.scenario.signals.get(key)
        if given is None:
            reason = f"'{name}' is not declared in the program and has no value as a signal"
            self.lack(run, "signals", name, node, reason, "0")
            return 0.0
        return float(self._next("signals", key, given))

    def answer(self, run: Run, node: Node, name: str, reason: str, default: Answer) -> Answer:
        """The answer that is asked for under name; default stands in where the scenario has none."""
        given = self.scenario.answers.get(name.lower())
        if given is None:
            shown = f'"{default}"' if isinstance(default, str) else f"{default:g}"
            self.lack(run, "answers", name, node, reason, shown)
            return default
        return self._next("answers", name.lower(), given)

    def _next(self, section: str, key: str, given: Answer | tuple[Answer, ...]) -> Answer:
        if not isinstance(given, tuple):
            return given
        count = self._read.get((section, key), 0)
        self._read[section, key] = count + 1
        return given[min(count, len(given) - 1)]
