"""Edited texts read as the program itself was read, and as it would read in a world that answers otherwise."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Any

from trajopt_cli.exporters.rapid_scopes import nodes
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import Binary, Call, Name, Node, Number, String, Test
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Answer, ConstantSpeed, HoldRail, Scenario

_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?![\w.])")
_NEAR = 6  # values that a program compares something with and that are tried
_WAYS = 4  # other values that are tried besides


@dataclass(frozen=True, eq=False)
class Reading:
    """How a program was read. entry: as asked for."""

    program: Program
    plant: Plant
    scenario: Scenario = field(default_factory=Scenario)
    entry: str = "main"

    def again(
        self, texts: Mapping[str, str], new: Mapping[str, TextFile] | None = None, scenario: Scenario | None = None
    ) -> Program:
        """The program of edited texts, by path, and of new modules. Raises InputError as reading does."""
        files = [replace(file, text=texts[path]) for path, file in self.program.files.items()]
        kinematics = PlantKinematics(self.plant)
        # Their lines are those of the text as it was.
        world = replace(scenario or self.scenario, hold_rail=HoldRail(), constant_speed=ConstantSpeed())
        return run_program([*files, *(new or {}).values()], world, self.entry, kinematics)

    def otherwise(self) -> Iterator[tuple[str, list[Scenario]]]:
        """For each thing that the scenario says, its name, and scenarios in which it alone is otherwise.

        Values that the program compares it with come first. Not all that are tried suit what asks: a key is one of
        1..5, a text may have to be a number.
        """
        given = self.scenario
        compared = _compared(self.program) if given.signals or given.answers or given.data else {}
        for name, value in given.signals.items():
            near = [one for one in compared.get(name.lower(), ()) if not isinstance(one, str)]
            signals = [{**given.signals, name: one} for one in _others(value, near)]
            yield f"signal {name}", [replace(given, signals=one) for one in signals]
        for name, answer in given.answers.items():
            answers = [{**given.answers, name: one} for one in _others(answer, compared.get(name.lower(), ()))]
            yield f"answer {name}", [replace(given, answers=one) for one in answers]
        for name, datum in given.data.items():
            others = [replace(datum, value=one) for one in _others(datum.value, compared.get(name.lower(), ()))]
            yield f"data {name}", [replace(given, data={**given.data, name: one}) for one in others]
        for name, share in given.searches.items():
            other = 0.5 if share is None else 0.25 + share / 2
            yield f"search {name}", [replace(given, searches={**given.searches, name: other})]
        if given.endless_passes is not None:
            yield "endless_passes", [replace(given, endless_passes=given.endless_passes + 1)]


def _others(value: Any, compared: Iterable[Answer]) -> list[Any]:
    """Other values, and the given one a reading later; compared: what the program holds it against."""
    if isinstance(value, tuple):
        changed = [tuple(_other(one, i) for one in value) for i in range(2)]
        return [(*value[:1], *value), *changed]
    near = [one for one in compared if type(one) is type(value) and one != value][:_NEAR]
    out = list(dict.fromkeys([*near, *(_other(value, i) for i in range(_WAYS))]))
    return [out[0], (out[0], value), *out[1:]]


def _other(value: Any, way: int) -> Any:
    """Another value of the same kind; way: which, of several."""
    match value:
        case bool():
            return not value
        case str() if value.lstrip().startswith("["):  # a record or an array: another first, second, ... number
            place = next(islice(_NUMBER.finditer(value), way, None), None)
            return value if place is None else f"{value[: place.start()]}{float(place[0]) + 1:g}{value[place.end() :]}"
        case str():
            return (f"{value}x", f"{value}1", "1", "")[way % 4]
    first = 1.0 - value if value in (0.0, 1.0) else value + 1.0
    keys = [float(key) for key in range(1, 6) if key != value]  # of a question with five keys
    return [first, *(key for key in keys if key != first)][way % 4]


def _compared(program: Program) -> dict[str, list[Answer]]:
    """The literals that each name is compared with, in IF, WHILE and TEST; of numbers their neighbours, too."""
    out: dict[str, list[Answer]] = {}

    def note(subject: Node, other: Node) -> None:
        if isinstance(subject, Call) and len(subject.args) == 1 and subject.args[0].value is not None:
            subject = subject.args[0].value  # DInput(di1)
        if isinstance(subject, Name) and isinstance(other, Number | String):
            found = out.setdefault(subject.name.lower(), [])
            values = [other.value] if isinstance(other, String) else [other.value + step for step in (0.0, 1.0, -1.0)]
            found += [value for value in values if value not in found]

    for file in program.files.values():
        for node in nodes(tuple(parse_module(file.text, file.path).modules)):
            if isinstance(node, Binary) and node.operator in ("=", "<>", "<", "<=", ">", ">="):
                note(node.left, node.right)
                note(node.right, node.left)
            elif isinstance(node, Test):
                for values, _ in node.cases:
                    for value in values:
                        note(node.subject, value)
    return out
