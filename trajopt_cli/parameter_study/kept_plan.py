"""The plan of one point, kept with its page in the study's results folder: `trajopt study plan`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.parameter_study.backups import failed_row, outcome, run_command
from trajopt_cli.parameter_study.cell_keys import put
from trajopt_cli.parameter_study.point import cell_data, job_at, without_root
from trajopt_cli.parameter_study.study_file import Study
from trajopt_cli.runs.transaction import write_files

PLANS = "plans"
"""Of a study's results folder: the results folders of points, by their numbers."""


def keep_plan(study: Study, index: int, folder: Path, options: Sequence[str] = ()) -> dict[str, Any]:
    """Write a point's program and cell out as files, and have trajopt optimize plan them in a process of its own.

    folder: of the study's results; the plan's is PLANS/index in it. options: of optimize, besides. Gives status, times
    [s] and the reason of a failure as a row of a batch has them. Raises InputError for a point that the study does not
    have.
    """
    if not 0 <= index < len(study.design):
        raise InputError(f"has no point {index}, but 0 to {len(study.design) - 1}", file=str(study.path))
    inputs, point = study.inputs, study.design.point(index)
    try:
        job = job_at(inputs, point)
    except InputError as error:
        return failed_row(without_root(inputs, str(error)))
    data = cell_data(inputs, dict(zip(inputs.keys, point.values, strict=True)))
    if any(key.startswith(("place.base.", "place.rail.")) for key in inputs.keys):
        rail = job.cell.rail
        X = job.cell.X_WB if rail is None else rail.X_WR
        frame = {"position": X[:3, 3].tolist(), "wxyz": wxyz_from_rotation(X[:3, :3]).tolist()}
        put(data, "base" if rail is None else "rail.frame", frame)
    texts = {Path(one.path).name: one.text.encode(one.encoding) for one in job.program.files.values()}
    with TemporaryDirectory(prefix="trajopt-plan-") as place:
        cell = json.dumps(data, indent=1).encode()  # which YAML reads, too
        write_files(Path(place), {**inputs.beside, **texts, inputs.cell_file: cell})
        out = folder.resolve() / PLANS / str(index)
        words = ["optimize", *texts, "--cell", inputs.cell_file, "--entry", inputs.entry]
        return outcome(*run_command([*words, "--output", str(out), "--json", *options], place))
