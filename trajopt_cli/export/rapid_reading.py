"""Edited texts read as the program itself was read, and as it would read in a world that answers otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from trajopt_cli.motion import Program, TextFile
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Answer, Scenario


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
        return run_program([*files, *(new or {}).values()], scenario or self.scenario, self.entry, kinematics)

    def otherwise(self) -> Iterator[list[Scenario]]:
        """Scenarios that differ in one thing: a signal, an answer, a hit, the passes of an endless loop; by thing."""
        given = self.scenario
        for name, value in given.signals.items():
            later = (*value[:1], *value) if isinstance(value, tuple) else (_number(value), value)
            other = tuple(map(_number, value)) if isinstance(value, tuple) else _number(value)
            yield [replace(given, signals={**given.signals, name: one}) for one in (later, other)]
        for name, answer in given.answers.items():
            after = (*answer[:1], *answer) if isinstance(answer, tuple) else (_other(answer), answer)
            changed = tuple(map(_other, answer)) if isinstance(answer, tuple) else _other(answer)
            yield [replace(given, answers={**given.answers, name: reply}) for reply in (after, changed)]
        for name, share in given.searches.items():
            yield [replace(given, searches={**given.searches, name: 0.5 if share is None else 0.25 + share / 2})]
        if given.endless_passes is not None:
            yield [replace(given, endless_passes=given.endless_passes + 1)]


def _other(value: Answer) -> Answer:
    match value:
        case bool():
            return not value
        case str():
            return f"{value}x"
    return _number(value)


def _number(value: float) -> float:
    return 1.0 - value if value in (0.0, 1.0) else value + 1.0
