"""`trajopt estimate PROGRAM`: the cycle time of the program as written, and what it rests on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import AsJson, AssumeIdentity, CellPath, Columns, Entry, LogUnits, ProgramPaths, Quiet
from trajopt_cli.cli.process import reading


def estimate(
    program: ProgramPaths,
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    log: Annotated[
        Path | None,
        typer.Option(
            "--log", metavar="FILE.csv", help="A controller's log of time and joints, to compare motion by motion."
        ),
    ] = None,
    units: LogUnits = None,
    columns: Columns = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Estimate PROGRAM's cycle time as written, on its controller, under the cell's limits, with ramps and corners.

    Waits are counted apart; length over programmed speed stands beside it.

    Says which numbers are guesses. Exit code 1: it cannot be driven as written, and why.

    \b
    Example:
      trajopt estimate programs/hinge_cell.mod
    """
    from trajopt_cli.cli.console import no, print_json, result, show, stdout, tell, warn
    from trajopt_cli.cli.estimate_tables import estimate_table, sums
    from trajopt_cli.errors import InputError
    from trajopt_cli.job import MAIN, read_job
    from trajopt_cli.measured.align import align
    from trajopt_cli.measured.log_csv import lost_rows, read_log
    from trajopt_cli.pipeline.planning import undriven
    from trajopt_cli.study.estimate import doubts, estimate, estimate_record, uncalibrated

    if log is None and (units or columns):
        raise InputError("--units and --columns are about a log; give it by --log FILE.csv")
    with reading(program):
        job = read_job(program, cell, entry or MAIN, assume_identity or ())
    measured = None if log is None else read_log(log, job.plant.limits, units, columns)
    answer = estimate(job)
    if isinstance(answer, str):
        no([f"as written it cannot be driven: {answer}"], as_json)
    for line in (*undriven(job), *job.program.warnings):
        warn(f"warning: {line}")
    compared = None
    if measured is not None:
        compared = align(job.program, answer.plan, job.plant.limits.velocity, measured[0], str(log))
    if as_json:
        print_json(estimate_record(answer, compared))
        return
    if quiet:
        result(next(iter(sums(answer, compared))))
        return
    console = stdout()
    show(console, estimate_table(answer, compared))
    tell(console, (*sums(answer, compared), *doubts(answer), *job.program.without_effect))
    if measured is not None and measured[1]:
        tell(console, [f"columns not used: {', '.join(measured[1])}"])
    if measured is not None and (lost := lost_rows(measured[0].t)):
        tell(console, [f"{log}: {lost}"])
    tell(console, [uncalibrated(compared)])
