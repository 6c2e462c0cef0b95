"""`trajopt analyse PROGRAM`: what the program asks for, in steps of speed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from trajopt_cli.cli.options import AsJson, AssumeIdentity, CellPath, Entry, ProgramPaths, Quiet
from trajopt_cli.cli.process import reading
from trajopt_cli.errors import InputError


def analyse(
    program: ProgramPaths,
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    axis: Annotated[
        Literal["x", "y", "z", "rail"] | None,
        typer.Option(
            "--axis", help="Draw its moves in the plane of position and speed; needs --plots.", show_default=False
        ),
    ] = None,
    plots: Annotated[
        Path | None, typer.Option("--plots", metavar="FOLDER", help="Where the picture goes.", show_default=False)
    ] = None,
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

    if (axis is None) != (plots is None):
        raise InputError("--axis and --plots go together: which axis to draw, and where to")
    with reading(program):
        job = read_job(program, cell, entry or MAIN, assume_identity or ())
    analysis = analyse(job.program, job.plant)
    if axis is not None and plots is not None:
        from trajopt_cli.report.phase_plane import phase_pictures
        from trajopt_cli.runs.transaction import write_files

        pictures = phase_pictures(analysis, job.plant, axis, job.program_path.stem)
        write_files(plots, pictures)
        if not quiet:
            typer.echo(f"drawn in {plots}: {len(pictures)} files", err=True)
    if as_json:
        print_json(analysis_record(job.program, analysis))
        return
    if quiet:
        result(next(line for line in sums(analysis) if line.startswith("cycle")))
        return
    console = stdout()
    show(console, analysis_table(str(job.program_path), job.program, analysis))
    tell(console, [*sums(analysis), f"model: {MODEL}"])
