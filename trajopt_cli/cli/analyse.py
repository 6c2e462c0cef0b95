"""`trajopt analyse PROGRAM`: what the program asks for, in steps of speed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of
from trajopt_cli.errors import InputError


def analyse(
    program: opt.ProgramPaths,
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    axis: Annotated[
        Literal["x", "y", "z", "rail"] | None,
        typer.Option(
            "--axis", help="Draw its moves in the plane of position and speed; needs --plots.", show_default=False
        ),
    ] = None,
    plots: Annotated[Path | None, opt.given("--plots", "FOLDER", "Where the picture goes.")] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Add up PROGRAM's times as written: every move straight (MoveC along its arc) as seen from the carriage, speed
    changing in steps.

    Waits are counted apart. No limit of a joint is asked, so this is not a motion a robot can do.

    \b
    Example:
      trajopt analyse programs/hinge_line.mod
    """
    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.report.stepwise import MODEL, analyse, analysis_record, analysis_table, sums

    if (axis is None) != (plots is None):
        raise InputError("--axis and --plots go together: which axis to draw, and where to")
    job = job_of(program, cell, entry, assume_identity)
    analysis = analyse(job.program, job.plant)
    if axis is not None and plots is not None:
        from trajopt_cli.report.phase_plane import phase_pictures
        from trajopt_cli.runs.transaction import write_files

        pictures = phase_pictures(analysis, job.plant, axis, job.program_path.stem)
        write_files(plots, pictures)
        if not quiet:
            typer.echo(f"drawn in {plots}: {len(pictures)} files", err=True)
    told = [*sums(analysis)]
    table = analysis_table(str(job.program_path), job.program, analysis)
    cycle = next(line for line in told if line.startswith("cycle"))
    print_answer(
        as_json, quiet, lambda: analysis_record(job.program, analysis), cycle, [table, *told, f"model: {MODEL}"]
    )
