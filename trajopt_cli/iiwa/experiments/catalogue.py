"""All of chapter 6 at once: the table of experiments, the run that takes them in turns, and its folder."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

from trajopt_cli.iiwa.experiments import moving, pushed
from trajopt_cli.iiwa.experiments.setup import Bench, Experiment
from trajopt_cli.iiwa.job.folder import check_place
from trajopt_cli.iiwa.report.answer import Answer
from trajopt_cli.iiwa.report.page import picture_page
from trajopt_cli.iiwa.world.mujoco_world import available
from trajopt_cli.iiwa.world.worlds import Engine
from trajopt_cli.page.document import Section
from trajopt_cli.page.tables import drawn, facts, points
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import EXPERIMENTS as KIND
from trajopt_cli.runs.folder import check_replaceable, write_run
from trajopt_cli.runs.record import Inputs, RunRecord, as_json
from trajopt_cli.table import TextTable
from trajopt_cli.units import DEG, MM
from trajopt_cli.workers import in_turns

ROBOT = "iiwa7"
_STEPS = (pushed.force_stiffness, pushed.force_damping, pushed.orientation, pushed.all_axes)
_PUSHED = (*_STEPS, pushed.force_error, pushed.guiding, pushed.zeroing, pushed.stability)
_MOVING = (moving.speed, moving.stiffness, moving.damping, moving.collision)
EXPERIMENTS: dict[str, Callable[[Bench], Experiment]] = {
    one.__name__: one for one in (*_PUSHED, *_MOVING, pushed.loop_time)
}
_MEASURED = "loop_time"  # alone, before a second process takes its part of the machine
_CLOCK = "What the clock said in this run is in measured.json and loop_time.svg: no two runs are alike in it."
# The longest first, so that neither of two processes waits long for the other.
_ORDER = ("collision", "force_damping", "force_stiffness")
# What a name in a record ends in: its unit for people, and what that is in SI.
_UNITS = {
    "_m_s": ("m/s", 1.0),
    "_kg": ("kg", 1.0),
    "_rad": ("°", DEG),
    "_m": ("mm", MM),
    "_N": ("N", 1.0),
    "_s": ("s", 1.0),
}
_TURNS = ("alpha", "beta", "gamma")
# Of axes in one table: lengths, and forces, whose unit is the row's.
_LENGTHS = ("steady", "force_over_stiffness", "largest", "mean", "thesis_largest", "thesis_mean")
_HEAD = ("section", "title", "notes")

Tell = Callable[[str], None]
_Answer = tuple[dict[str, Any], dict[str, Any], dict[str, bytes]]  # record, what a clock measured, pictures


class Shown(NamedTuple):
    """A section for people: its name and heading, single numbers with their names, tables, and notes."""

    name: str
    heading: str
    facts: list[tuple[str, str]]
    tables: list[TextTable]
    notes: list[str]


def sections(numbers: Mapping[str, Any], measured: Mapping[str, Any]) -> Iterator[Shown]:
    """Every experiment of experiments.json (numbers) and measured.json, and the worst of the flange after 6.1.4."""
    for name, one in numbers.items():
        if name == "flange_worst" and one:
            caption = "6.1.5 the flange behind the controller, worst of all"
            yield Shown("flange", caption, [], [_table(caption, one)], numbers["flange_worst_notes"])
        elif isinstance(one, dict) and "section" in one:
            record = {**one, **measured.get(name, {})}
            yield Shown(name, f"{one['section']} {one['title']}", _singles(record), list(_tables(record)), one["notes"])


def experiments_page(numbers: Mapping[str, Any], pictures: Mapping[str, Mapping[str, bytes]]) -> bytes:
    """report.html. pictures: files by name, by experiment; that of the loop's times, which differ from run to run, is
    named instead."""
    groups = []
    for one in sections(numbers, {}):
        files = {} if one.name == _MEASURED else pictures.get(one.name, {})
        notes = [*one.notes, *([_CLOCK] if one.name == _MEASURED else [])]
        html = facts(one.facts) + "".join(map(drawn, one.tables)) + points(notes)
        shown = [(file, content) for file, content in files.items() if file.endswith(".svg")]
        groups.append((Section(one.name, one.heading, html), shown))
    about = (
        "Chapter 6 of the thesis that the compliant job goes back to (V. Číhala, Poddajné řízení průmyslového robota, "
        f"ČVUT 2020), its numbers beside ours; engine {numbers['engine']}"
    )
    return picture_page("iiwa experiments", about, groups)


def _singles(record: Mapping[str, Any]) -> list[tuple[str, str]]:
    out = []
    for key, value in record.items():
        vector = isinstance(value, list) and bool(value) and isinstance(value[0], float)
        if key not in _HEAD and (isinstance(value, (int, float, str)) or vector):
            shown = f"({', '.join(_cell(key, one) for one in value)})" if vector else _cell(key, value)
            out.append((_named(key)[0], shown))
    return out


def _tables(record: Mapping[str, Any]) -> Iterator[TextTable]:
    """The lists of rows in a record, rows within rows flat."""
    for key, rows in record.items():
        if isinstance(rows, list) and rows and isinstance(rows[0], dict):
            inner = sorted({name for row in rows for name, value in row.items() if isinstance(value, list)})
            flat = {
                name: [{"setting": row["label"], **part} for row in rows for part in row[name] or []] for name in inner
            }
            yield from (_table(name, some) for name, some in (flat or {key: rows}).items() if some)


def _table(caption: str, rows: Sequence[Mapping[str, Any]]) -> TextTable:
    numeric = [any(isinstance(row[key], (int, float)) for row in rows) for key in rows[0]]
    heads = tuple(f"{'>' if right else ''}{_named(key)[0]}" for key, right in zip(rows[0], numeric, strict=True))
    cells = [tuple(_cell(key, value, str(row.get("axis", ""))) for key, value in row.items()) for row in rows]
    return TextTable(caption.replace("_", " "), heads, tuple(cells))


def _named(key: str) -> tuple[str, float]:
    """A recorded name for people with its unit, and what that unit is in SI."""
    ending = next((one for one in _UNITS if key.endswith(one)), "")
    unit, size = _UNITS.get(ending, ("", 1.0))
    name = key.removesuffix(ending).replace("_", " ")
    return f"{name} [{unit}]" if unit else name, size


def _cell(key: str, value: Any, axis: str = "") -> str:
    """A recorded value for people; axis: what the row is about, "" for none."""
    if value is None:
        return "–"
    if key in _LENGTHS and axis:
        return f"{value / DEG:.3f} °" if axis in _TURNS else f"{value / MM:.3f} mm"
    if key == "force":
        return f"{value:g} {'Nm' if axis in _TURNS else 'N'}"
    if isinstance(value, dict):
        return ", ".join(f"{_cell(key, one)} ({name})" for name, one in value.items())
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    return f"{value / _named(key)[1]:.4g}".replace("-", "−")


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
    alone = _one(_MEASURED, bench, tell)
    names = [*_ORDER, *(name for name in EXPERIMENTS if name not in (*_ORDER, _MEASURED))]
    tasks: dict[str, Callable[[Tell], _Answer]] = {name: partial(_one, name, bench) for name in names}
    done = collected(bench.engine, {_MEASURED: alone, **in_turns(tasks, tell)})
    count = write_experiments(folder, done)
    where = f"written to {folder}: report.html (open it in a browser) and {count - 1} files more"
    return Answer(done.record, f"written to {folder}: {count} files", list(done.texts()), folder, where)


def collected(engine: Engine, answers: Mapping[str, _Answer]) -> Experiments:
    """Every experiment's answer by name, with the worst of the flange's over 6.1.1 to 6.1.4."""
    records = {name: answers[name][0] for name in EXPERIMENTS}
    steps = {one.__name__: records[one.__name__] for one in _STEPS}
    worst, notes = pushed.flange_worst(steps.values())
    numbers = {
        "engine": engine.value,
        **steps,
        "flange_worst": worst or None,
        "flange_worst_notes": notes,
        "flange_worst_of_the_earlier_work_m": dict(zip(("largest", "mean"), pushed.FLANGE_EARLIER, strict=True)),
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
