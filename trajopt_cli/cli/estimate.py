"""`trajopt estimate PROGRAM`: the cycle time of the program as written, and what it rests on."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from trajopt_cli.table import TextTable


def estimate(
    program: opt.ProgramPaths,
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    log: Annotated[
        Path | None,
        opt.given(
            "--log",
            "FILE.csv",
            "A controller's log of time and joints, to compare motion by motion; or a folder of logs.",
        ),
    ] = None,
    units: opt.LogUnits = None,
    columns: opt.Columns = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Estimate PROGRAM's cycle time as written, on its controller, under the cell's limits, with ramps and corners.

    Waits are counted apart; length over programmed speed stands beside it.

    Says which numbers are guesses. Exit code 1: it cannot be driven as written, and why.

    \b
    Example:
      trajopt estimate programs/hinge_cell.mod
    """
    from trajopt_cli.cli.console import no, print_answer, warn
    from trajopt_cli.errors import InputError, InputErrorGroup
    from trajopt_cli.measured.log_csv import logs_of, lost_rows, read_log
    from trajopt_cli.pipeline.planning import undriven
    from trajopt_cli.study import estimate as study

    if log is None and (units or columns):
        raise InputError("--units and --columns are about a log; give it by --log FILE.csv")
    job = job_of(program, cell, entry, assume_identity)
    read, wrong, many = {}, [], log is not None and log.is_dir()
    for path in logs_of([log] if log else []):
        try:
            read[str(path)] = read_log(path, job.plant.limits, units, columns)
        except InputError as error:
            if not many or error.file is None:
                raise
            wrong.append(error)
    answer = study.estimate(job)
    if isinstance(answer, str):
        no([f"as written it cannot be driven: {answer}"], as_json)
    for line in (*undriven(job), *job.program.warnings):
        warn(f"warning: {line}")
    logs = study.beside(answer, {path: motion for path, (motion, _) in read.items()}, wrong) if log else None
    if logs and not logs.alignments:
        raise InputErrorGroup(logs.wrong)
    compared = logs.alignments[0] if logs and not many else None

    def parts() -> Iterator[TextTable | str]:
        yield study.logs_table(answer, logs.alignments) if logs and many else study.estimate_table(answer, compared)
        yield from (*study.sums(answer, compared), *study.doubts(answer), *job.program.without_effect)
        for file, (motion, unused) in read.items():
            notes = [f"columns not used: {', '.join(unused)}" if unused else "", lost_rows(motion.t)]
            yield from (f"{file}: {note}" for note in notes if note)
        yield from (*((*logs.against, *logs.settled) if logs else ()), study.uncalibrated(logs))

    said = logs.said if logs and many else next(iter(study.sums(answer, compared)))
    print_answer(as_json, quiet, lambda: study.estimate_record(answer, logs, many), said, parts())
    if logs and logs.wrong:
        raise InputErrorGroup(logs.wrong)
