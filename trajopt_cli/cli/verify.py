"""`trajopt verify RESULTS|FILE.csv`: the judge's word on files, whoever wrote them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import CellPath
from trajopt_cli.errors import InputError


def verify(
    what: Annotated[Path, typer.Argument(metavar="RESULTS|FILE.csv", help="A results folder, or a joint CSV file.")],
    program: Annotated[Path | None, typer.Option(metavar="PROGRAM", help="The program a CSV file executes.")] = None,
    cell: CellPath = None,
    everything: Annotated[
        bool, typer.Option("--all", help="List every case, not only the worst of each check.")
    ] = False,
) -> None:
    """Judge trajectories against program and limits. Exit code 0: legal, 1: not."""
    from trajopt_cli.cli.console import stdout
    from trajopt_cli.cli.tables import advice_table, failures, findings_table, verdict
    from trajopt_cli.pipeline import verify_file, verify_results

    if what.is_dir():
        if program is not None or cell is not None:
            raise typer.BadParameter("a results folder holds its own program and cell; leave --program and --cell out")
        _, reports = verify_results(what)
    elif not what.exists():
        raise InputError("no such file or folder", file=str(what))
    elif program is None:
        raise typer.BadParameter(f"{what} is a file: say which --program it executes")
    else:
        reports = {what.name: verify_file(what, program, cell)[1]}
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
