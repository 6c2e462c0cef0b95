"""The plan of one point, kept with its page in the study's results folder: `trajopt study plan`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from trajopt_cli.errors import InputError
from trajopt_cli.job import read_job
from trajopt_cli.parameter_study.backups import outcome, run_command
from trajopt_cli.parameter_study.offsets import is_offset, moved, shifted
from trajopt_cli.parameter_study.point import cell_data
from trajopt_cli.parameter_study.study_file import Study
from trajopt_cli.runs.files import write_file
from trajopt_cli.runs.transaction import write_files
from trajopt_cli.study.places import What, site_of

PLANS = "plans"
"""Of a study's results folder: the results folders of points, by their numbers."""


def keep_plan(study: Study, index: int, folder: Path, options: Sequence[str] = ()) -> dict[str, Any]:
    """Write a point's program and cell out as files, and have trajopt optimize plan them in a process of its own.

    folder: of the study's results; the plan's is PLANS/index in it. options: of optimize, besides. Gives status, times
    [s] and the reason of a failure as a row of a batch has them. Raises InputError for a point that the study does not
    have, and for one whose work objects stand elsewhere, which is not written as text.
    """
    if not 0 <= index < len(study.design):
        raise InputError(f"has no point {index}, but 0 to {len(study.design) - 1}", file=str(study.path))
    inputs, point = study.inputs, study.design.point(index)
    values = dict(zip(inputs.keys, point.values, strict=True))
    offsets = {key: value for key, value in values.items() if is_offset(key)}
    programs = shifted([*inputs.programs.values()][point.program], offsets)
    with TemporaryDirectory(prefix="trajopt-plan-") as place:
        cell, names = Path(place, inputs.cell_file), [Path(one.path).name for one in programs]
        texts = {name: one.text.encode(one.encoding) for name, one in zip(names, programs, strict=True)}
        data = json.dumps(cell_data(inputs, values), indent=1).encode()  # which YAML reads, too
        write_files(Path(place), {**inputs.beside, **texts, inputs.cell_file: data})
        for what, ranges in moved(offsets):
            site = site_of(read_job([Path(place, name) for name in names], cell, inputs.entry), what, ranges)
            if site.what is What.STATION:
                raise InputError(
                    f"place.{site.name}: a work object's place is in the program, and is not written there"
                )
            write_file(cell, site.changed_cell(tuple(one.low for one in ranges), str(cell)).encode())
        out = folder.resolve() / PLANS / str(index)
        words = ["optimize", *names, "--cell", inputs.cell_file, "--entry", inputs.entry]
        return outcome(*run_command([*words, "--output", str(out), "--json", *options], place))
