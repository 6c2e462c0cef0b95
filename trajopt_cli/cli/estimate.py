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
            "--log",
            metavar="FILE.csv",
            help="A controller's log of time and joints, to compare motion by motion; or a folder of logs.",
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
    from trajopt_cli.cli.estimate_tables import estimate_table, logs_table, sums
    from trajopt_cli.errors import InputError, InputErrorGroup
    from trajopt_cli.job import MAIN, read_job
    from trajopt_cli.measured.log_csv import logs_of, lost_rows, read_log
    from trajopt_cli.pipeline.planning import undriven
    from trajopt_cli.study.estimate import beside, doubts, estimate, estimate_record, uncalibrated

    if log is None and (units or columns):
        raise InputError("--units and --columns are about a log; give it by --log FILE.csv")
    with reading(program):
        job = read_job(program, cell, entry or MAIN, assume_identity or ())
    read, wrong, many = {}, [], log is not None and log.is_dir()
    for path in logs_of([log] if log else []):
        try:
            read[str(path)] = read_log(path, job.plant.limits, units, columns)
        except InputError as error:
            if not many or error.file is None:
                raise
            wrong.append(error)
    answer = estimate(job)
    if isinstance(answer, str):
        no([f"as written it cannot be driven: {answer}"], as_json)
    for line in (*undriven(job), *job.program.warnings):
        warn(f"warning: {line}")
    logs = beside(answer, {path: motion for path, (motion, _) in read.items()}, wrong) if log else None
    if logs and not logs.alignments:
        raise InputErrorGroup(logs.wrong)
    compared = logs.alignments[0] if logs and not many else None
    if as_json:
        print_json(estimate_record(answer, logs, many))
    elif quiet:
        result(logs.said if logs and many else next(iter(sums(answer, compared))))
    else:
        console = stdout()
        show(console, logs_table(answer, logs.alignments) if logs and many else estimate_table(answer, compared))
        tell(console, (*sums(answer, compared), *doubts(answer), *job.program.without_effect))
        for file, (motion, unused) in read.items():
            notes = [f"columns not used: {', '.join(unused)}" if unused else "", lost_rows(motion.t)]
            tell(console, [f"{file}: {note}" for note in notes if note])
        tell(console, [*((*logs.against, *logs.settled) if logs else ()), uncalibrated(logs)])
    if logs and logs.wrong:
        raise InputErrorGroup(logs.wrong)
