"""All of chapter 6 at once: the table of experiments, the run that takes them in turns, and its folder."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

from trajopt_cli.iiwa.experiments.measuring import force_error, loop_time, stability
from trajopt_cli.iiwa.experiments.moving import collision, damping, feed_scheduling, speed, stiffness
from trajopt_cli.iiwa.experiments.published import FLANGE_EARLIER
from trajopt_cli.iiwa.experiments.pushed import (
    all_axes,
    flange_worst,
    force_damping,
    force_stiffness,
    guiding,
    orientation,
    zeroing,
)
from trajopt_cli.iiwa.experiments.setup import Bench, Experiment
from trajopt_cli.iiwa.experiments.tables import experiments_page, sections
from trajopt_cli.iiwa.job.folder import check_place
from trajopt_cli.iiwa.report.answer import Answer
from trajopt_cli.iiwa.world.mujoco_world import available
from trajopt_cli.iiwa.world.worlds import Engine
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import EXPERIMENTS as KIND
from trajopt_cli.runs.folder import check_replaceable, write_run
from trajopt_cli.runs.record import Inputs, RunRecord, as_json
from trajopt_cli.table import TextTable
from trajopt_cli.workers import in_turns

ROBOT = "iiwa7"
EXPERIMENTS: dict[str, Callable[[Bench], Experiment]] = {
    "force_stiffness": force_stiffness,
    "force_damping": force_damping,
    "orientation": orientation,
    "all_axes": all_axes,
    "force_error": force_error,
    "guiding": guiding,
    "zeroing": zeroing,
    "stability": stability,
    "speed": speed,
    "stiffness": stiffness,
    "damping": damping,
    "collision": collision,
    "dosing": feed_scheduling,
    "loop_time": loop_time,
}
_STEPS = ("force_stiffness", "force_damping", "orientation", "all_axes")
_ALONE = "loop_time"
# The longest first, so that neither of two processes waits long for the other.
_ORDER = ("dosing", "collision", "force_damping", "force_stiffness")

Tell = Callable[[str], None]
_Answer = tuple[dict[str, Any], dict[str, Any], dict[str, bytes]]  # record, what a clock measured, pictures


class ExperimentsRecord(RunRecord[dict[str, Any]]):
    """run.json of trajopt iiwa experiments, which reads no files."""

    KIND: ClassVar[str] = KIND
    LIBRARIES: ClassVar[tuple[str, ...]] = ("numpy", "pin", "scipy")


@dataclass(frozen=True, eq=False)
class Experiments:
    """Chapter 6. numbers: as in experiments.json; measured: what differs from run to run; pictures: files by name, by
    experiment."""

    numbers: dict[str, Any]
    measured: dict[str, Any]
    pictures: Mapping[str, Mapping[str, bytes]]

    @property
    def record(self) -> dict[str, Any]:
        """All numbers as plain data."""
        return {**self.numbers, "measured": self.measured}

    def texts(self) -> Iterator[TextTable | list[str]]:
        """For a terminal, section by section: tables, single numbers and notes."""
        for one in sections(self.numbers, self.measured):
            yield from (replace(part, title=f"{one.heading}: {part.title}") for part in one.tables)
            singles = ", ".join(f"{name} {value}" for name, value in one.facts)
            yield [*([f"{one.heading}: {singles}"] if singles else []), *one.notes, ""]


def run_experiments(folder: Path, engine: str, tell: Tell) -> Answer:
    """All of chapter 6, written into a folder. tell: hears which experiment begins.

    engine: "spring" or "mujoco" moves the arm; "auto" is MuJoCo where it is installed. Raises InputError for mujoco
    where it is not, and where folder may not be replaced.
    """
    check_place(folder, "--output")
    check_replaceable(folder)
    bench = bench_of(engine)
    # before a second process takes its part of the machine
    alone = _one(_ALONE, bench, tell)
    names = [*_ORDER, *(name for name in EXPERIMENTS if name not in (*_ORDER, _ALONE))]
    tasks: dict[str, Callable[[Tell], _Answer]] = {name: partial(_one, name, bench) for name in names}
    done = collected(bench.engine, {_ALONE: alone, **in_turns(tasks, tell)})
    count = write_experiments(folder, done)
    where = f"written to {folder}: report.html (open it in a browser) and {count - 1} files more"
    return Answer(done.record, f"written to {folder}: {count} files", list(done.texts()), folder, where)


def collected(engine: Engine, answers: Mapping[str, _Answer]) -> Experiments:
    """Every experiment's answer by name, with the worst of the flange's over 6.1.1 to 6.1.4."""
    records = {name: answers[name][0] for name in EXPERIMENTS}
    worst, notes = flange_worst(records[name] for name in _STEPS)
    numbers = {
        "engine": engine.value,
        **{name: records[name] for name in _STEPS},
        "flange_worst": worst or None,
        "flange_worst_notes": notes,
        "flange_worst_of_the_earlier_work_m": dict(zip(("largest", "mean"), FLANGE_EARLIER, strict=True)),
        **records,
    }
    measured = {name: answer[1] for name, answer in answers.items() if answer[1]}
    return Experiments(numbers, measured, {name: answers[name][2] for name in EXPERIMENTS})


def bench_of(engine: str) -> Bench:
    """The arm in an engine's world. Raises InputError for MuJoCo where it is not installed."""
    best = Engine.SPRING if available() is None else Engine.MUJOCO
    return Bench(load_srs(ROBOT), best if engine == "auto" else Engine(engine))


def write_experiments(folder: Path, experiments: Experiments) -> int:
    """Write experiments.json, measured.json, the pictures and report.html; how many files that are.

    Everything but measured.json, its picture and run.json is the same bytes each time. Raises InputError where folder
    may not be replaced.
    """
    files = {
        "experiments.json": as_json(experiments.numbers),
        "measured.json": as_json(experiments.measured),
        **{name: content for drawn in experiments.pictures.values() for name, content in drawn.items()},
        REPORT: experiments_page(experiments.numbers, experiments.pictures),
    }
    write_run(folder, ExperimentsRecord, files, "iiwa experiments", options={}, inputs=Inputs())
    return len(files)


def _one(name: str, bench: Bench, tell: Tell) -> _Answer:
    tell(name)
    done = EXPERIMENTS[name](bench)
    return done.record, dict(done.measured), done.draw()
