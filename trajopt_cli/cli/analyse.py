"""`trajopt analyse PROGRAM`: what the program asks for, in steps of speed."""

from __future__ import annotations

from trajopt_cli.cli.options import AsJson, AssumeIdentity, CellPath, Entry, ProgramPaths, Quiet
from trajopt_cli.cli.process import reading


def analyse(
    program: ProgramPaths,
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Add up PROGRAM's times as written: every move straight (MoveC along its arc) as seen from the carriage, speed
    changing in steps.

    Waits are counted apart. No limit of a joint is asked, so this is not a motion a robot can do.

    \b
    Example:
      trajopt analyse programs/hinge_line.mod
    """
    from trajopt_cli.cli.analysis_table import MODEL, analysis_record, analysis_table, sums
    from trajopt_cli.cli.console import print_json, result, show, stdout, tell
    from trajopt_cli.job import MAIN, read_job
    from trajopt_cli.report.stepwise import analyse

    with reading(program):
        job = read_job(program, cell, entry or MAIN, assume_identity or ())
    analysis = analyse(job.program, job.plant)
    if as_json:
        print_json(analysis_record(job.program, analysis))
        return
    if quiet:
        result(next(line for line in sums(analysis) if line.startswith("cycle")))
        return
    console = stdout()
    show(console, analysis_table(str(job.program_path), job.program, analysis))
    tell(console, [*sums(analysis), f"model: {MODEL}"])
