"""What a running program finds out about its world: signals and answers as the scenario gives them.

A reading of a signal gives, in this order: what the program set it to, or a wait made sure of; the scenario's value, of
a sequence the next one, the last one staying; else it is missing, noted once per name, and 0 stands in, so that one run
finds everything that is missing. Outputs begin at 0 where the scenario says nothing.

A wait always comes true unless the scenario lets it time out. Of a sequence it drops the values before the first that
fits; that one is what the next reading gives. A plain value that contradicts the wait gives way to what it waited for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from trajopt_cli.rapid.data.datatypes import Type, Value
from trajopt_cli.rapid.data.scope import ExternalDatum
from trajopt_cli.rapid.language.text import listed
from trajopt_cli.scenario import Answer, Missing, Scenario, condition_key

_SHOWN = 7  # names in a warning


class External:
    """Signal values, answers and data from outside as they stand now; names in lower case.

    missing: what the scenario does not say, by section and name. data: what it gives as data, and what stands in for
    what nothing declares. grows: the names that stand in for arrays of unknown size. fitting: of names that nothing
    declares, values that let a wait come true. spelled: the type that the scenario writes beside data. not_digital: the
    values of signals that are neither 0 nor 1.
    """

    def __init__(self, scenario: Scenario):
        self.scenario = scenario
        self.missing: dict[tuple[str, str], Missing] = {}
        self._given: dict[str, dict[str, Answer | tuple[Answer, ...]]] = {  # by section of the cell file
            "signals": {name.lower(): values for name, values in scenario.signals.items()},
            "answers": {name.lower(): values for name, values in scenario.answers.items()},
            "data": {name.lower(): given.value for name, given in scenario.data.items()},
        }
        self._waits = {condition_key(text): seconds for text, seconds in scenario.waits.items()}
        self._values: dict[str, float] = {}
        self.fitting: dict[str, Answer] = {}
        self.grows: set[str] = set()
        self.spelled = {name.lower(): given.type for name, given in scenario.data.items()}
        self._typed: dict[tuple[str, Type, type, Answer], Value] = {}
        self.data = {name: ExternalDatum(name, self.reading) for name in self._given["data"]}
        self._taken: dict[tuple[str, str], int] = {}  # how many values of a sequence are behind
        self._trying = 0
        self._asked: set[tuple[str, str]] = set()  # section and name of all that the program asked for or set
        # Of a digital signal that would be a slip, which only the instruction that uses it can tell.
        self.not_digital = {
            name.lower(): value
            for name, given in scenario.signals.items()
            for value in (given if isinstance(given, tuple) else (given,))
            if value not in (0, 1)
        }

    @property
    def trying(self) -> bool:
        """Whether a condition is only tried: what is unknown stands in, and is not reported as missing."""
        return self._trying > 0

    @contextmanager
    def _trial(self) -> Iterator[None]:
        self._trying += 1
        try:
            yield
        finally:
            self._trying -= 1

    # --------------------------------------------------------------------------------------------------- signals

    def set(self, signal: str, value: float) -> None:
        """The program sets a signal, or a wait has made sure of its value."""
        self._values[signal] = value
        self._asked.add(("signals", signal))

    def unused(self) -> list[str]:
        """A sentence for each section of the scenario with names that the program never asked for."""
        given: dict[str, Iterable[str]] = {
            "signals": self.scenario.signals,
            "answers": self.scenario.answers,
            "data": self.scenario.data,
            "waits": self.scenario.waits,
            "searches": self.scenario.searches,
            "partner": map(str, self.scenario.partner),
            "stubs": self.scenario.stubs,
        }
        sentences = []
        for section, names in given.items():
            key = condition_key if section == "waits" else str.lower
            left = sorted(name for name in names if (section, key(name)) not in self._asked)
            if left:
                sentences.append(f"the program never uses {listed(left, _SHOWN)} ({section} in the cell file)")
        for name in sorted(self.scenario.assume_identity):
            if ("assume_identity", name.lower()) not in self._asked:
                sentences.append(f"--assume-identity {name}: the program uses no such tool, work object or unit")
        return sentences

    def asked(self, section: str, name: str) -> None:
        """The program asks for something of the scenario; name in lower case."""
        self._asked.add((section, name))

    def signal(self, key: str) -> float | None:
        """The value that a reading of a signal gives; None where neither the program nor the scenario gave it one."""
        value = self._values.get(key)
        if value is not None:
            return value
        given = self._next("signals", key)
        return None if given is None else float(given)

    def output(self, signal: str) -> float:
        """The value that a reading of an output gives; nothing is missing."""
        return self.signal(signal) or 0.0

    def now(self, signal: str) -> float:
        """An output's value without reading it: its sequence stays where it is."""
        self._asked.add(("signals", signal))
        return self._values.get(signal, float(self.left("signals", signal)[0]))

    def awaited(self, signal: str, fits: Callable[[float], bool], value: float | None) -> tuple[float, ...]:
        """A wait for a signal came true; from here on it reads as the module says.

        value: the only one that fits, None where there are several; then a plain value that does not fit stays. Returns
        what is left of a sequence of which no value fits, else nothing.
        """
        self._asked.add(("signals", signal))
        if signal not in self._values and isinstance(self._given["signals"].get(signal), tuple):
            left = tuple(float(one) for one in self.left("signals", signal))
            count = next((count for count, one in enumerate(left) if fits(one)), None)
            if count is None:
                return left
            self.take("signals", signal, count)
            return ()
        if value is not None:
            self._values[signal] = value
        return ()

    def poll(self, holds: Callable[[], bool]) -> bool:
        """Whether a condition comes true on the way through the sequences that it reads.

        If it does, the readings that made it true are the next ones; if not, the sequences stand where they stood.
        """
        first = dict(self._taken)
        with self._trial():
            while True:
                before = dict(self._taken)
                true = holds()
                if true or not self._went_on(before):
                    self._taken = before if true else first
                    return true

    def _went_on(self, before: dict[tuple[str, str], int]) -> bool:
        """Whether a later reading can differ: some sequence has gone on to another of its values."""
        sequences = ((key, taken, self._given[key[0]][key[1]]) for key, taken in self._taken.items())
        return any(
            isinstance(given, tuple) and min(taken, len(given) - 1) != min(before.get(key, 0), len(given) - 1)
            for key, taken, given in sequences
        )

    # --------------------------------------------------------------------------------------------------- the rest

    def least(self, *texts: str) -> float | None:
        """The least duration [s] of a wait: the first of texts that the scenario knows decides. None: it times out."""
        if not self._waits:
            return 0.0
        keys = [condition_key(text) for text in texts]
        self._asked.update(("waits", key) for key in keys)
        return next((self._waits[key] for key in keys if key in self._waits), 0.0)

    def known(self, name: str) -> bool:
        """Whether the scenario has an answer under name."""
        self._asked.add(("answers", name.lower()))
        return name.lower() in self._given["answers"]

    def answer(self, key: str) -> Answer | None:
        """The answer under a name, None where the scenario has none."""
        return self._next("answers", key)

    def _next(self, section: str, key: str) -> Answer | None:
        """The value that the next reading gives, None where the scenario has none."""
        self._asked.add((section, key))
        given = self._given[section].get(key)
        if not isinstance(given, tuple):
            return given
        count = self._taken.get((section, key), 0)
        self._taken[section, key] = count + 1
        return given[min(count, len(given) - 1)]

    def gives(self, name: str) -> bool:
        """Whether the scenario has a value for data of this name; in lower case."""
        return name in self._given["data"]

    def typed(self, datum: ExternalDatum, answer: Answer, value: Value) -> None:
        """Remember one of the scenario's values for data, as a value of its type."""
        self._typed[datum.name, datum.type, type(answer), answer] = value

    def value(self, datum: ExternalDatum, answer: Answer) -> Value:
        """One of the scenario's values for data, as a value of its type."""
        return self._typed[datum.name, datum.type, type(answer), answer]

    def reading(self, datum: ExternalDatum) -> Value:
        """What the next reading of data gives."""
        answer = self._next("data", datum.name)
        assert answer is not None  # such data has a value in the cell file
        return self.value(datum, answer)

    def left(self, section: str, key: str) -> tuple[Answer, ...]:
        """The values that readings to come can give; 0 for a signal without any."""
        given = self._given[section].get(key, 0.0)
        if not isinstance(given, tuple):
            return (given,)
        return given[min(self._taken.get((section, key), 0), len(given) - 1) :]

    def take(self, section: str, key: str, count: int) -> None:
        """Let so many values of a sequence be behind."""
        self._taken[section, key] = self._taken.get((section, key), 0) + count
