"""`trajopt verify RESULTS|FILE.csv`: the judge's word on files, whoever wrote them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import AssumeIdentity, CellPath, Entry
from trajopt_cli.cli.process import reading
from trajopt_cli.errors import InputError


def verify(
    what: Annotated[Path, typer.Argument(metavar="RESULTS|FILE.csv", help="A results folder, or a joint CSV file.")],
    program: Annotated[
        list[Path] | None,
        typer.Option(metavar="PROGRAM", help="The program a CSV file executes; repeat it for several modules."),
    ] = None,
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    everything: Annotated[
        bool, typer.Option("--all", help="List every case, not only the worst of each check.")
    ] = False,
) -> None:
    """Judge trajectories against program and limits. Exit code 0: legal, 1: not."""
    from trajopt_cli.cli.console import stdout
    from trajopt_cli.cli.tables import advice_table, failures, findings_table, verdict
    from trajopt_cli.job import MAIN, read_job
    from trajopt_cli.pipeline.folder import verify_file, verify_results

    if what.is_dir():
        if program or cell is not None:
            raise typer.BadParameter("a results folder holds its own program and cell; leave --program and --cell out")
        if entry is not None or assume_identity:
            message = "a results folder holds its own entry and assumptions; leave --entry and --assume-identity out"
            raise typer.BadParameter(message)
        with reading():
            _, reports = verify_results(what)
    elif not what.exists():
        raise InputError("no such file or folder", file=str(what))
    elif not program:
        raise typer.BadParameter(f"{what} is a file: say which --program it executes")
    else:
        with reading():
            job = read_job(program, cell, entry or MAIN, assume_identity or ())
        reports = {what.name: verify_file(what, job)}
    console = stdout()
    for name, report in reports.items():
        console.print(findings_table(name, report, everything))
        if report.advice:
            console.print(advice_table(name, report, everything))
    for name, report in reports.items():
        for line in failures(report.advice):
            console.print(f"advice: {line}")
        console.print(verdict(name, report))
        for line in failures(report.findings):
            console.print(f"  {line}")
    if not all(report.legal for report in reports.values()):
        raise typer.Exit(1)
