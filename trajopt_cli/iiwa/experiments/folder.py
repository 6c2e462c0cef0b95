"""The experiments as a folder: numbers, pictures, and apart from them what a clock measured."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar

from trajopt_cli.iiwa.experiments.catalogue import Experiments
from trajopt_cli.iiwa.experiments.page import experiments_page
from trajopt_cli.iiwa.experiments.pictures import pictures
from trajopt_cli.iiwa.experiments.record import record
from trajopt_cli.runs import REPORT
from trajopt_cli.runs.folder import EXPERIMENTS, write_run
from trajopt_cli.runs.record import Inputs, RunRecord, as_json

_MEASURED = "measured"


class ExperimentsRecord(RunRecord[dict[str, Any]]):
    """run.json of trajopt iiwa experiments, which reads no files."""

    KIND: ClassVar[str] = EXPERIMENTS
    LIBRARIES: ClassVar[tuple[str, ...]] = ("numpy", "pin", "scipy")


def write_experiments(folder: Path, experiments: Experiments) -> int:
    """Write experiments.json, measured.json, the pictures and report.html; how many files that are.

    Everything but measured.json, its picture and run.json is the same bytes each time. Raises InputError where folder
    may not be replaced.
    """
    numbers, drawn = record(experiments), pictures(experiments)
    files = {
        "experiments.json": as_json({name: part for name, part in numbers.items() if name != _MEASURED}),
        "measured.json": as_json(numbers[_MEASURED]),
        **drawn,
        REPORT: experiments_page(numbers, drawn),
    }
    write_run(folder, ExperimentsRecord, files, "iiwa experiments", options={}, inputs=Inputs())
    return len(files)
