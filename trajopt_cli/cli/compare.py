"""`trajopt compare baseline PROGRAM|RESULTS`: what the optimum saves, against what, and why."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import AsJson, CellPath

_SHOWN = 3  # failed checks per row; an illegal plan breaks many at once

app = typer.Typer(help="Compare plans of one program.", rich_markup_mode=None)


@app.callback()
def _group() -> None:
    """Compare plans of one program."""


@app.command("baseline", short_help="Today's practice, textbook methods, both optima, and the saving by cause.")
def baseline(
    program: Annotated[
        Path, typer.Argument(metavar="PROGRAM|RESULTS", help="RAPID module, or a results folder of trajopt optimize.")
    ],
    cell: CellPath = None,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE.csv", help="Write the rows as CSV, too.")] = None,
    plots: Annotated[
        Path | None,
        typer.Option("--plots", metavar="FOLDER", help="Draw the rows, the saving by cause and the fastest plan, too."),
    ] = None,
    phi_min: Annotated[
        float, typer.Option(min=0, max=80, metavar="DEG", help="Row thesis: least angle of joint 3 from stretched.")
    ] = 10.0,
    v_transfer: Annotated[
        float | None, typer.Option(min=1e-3, metavar="M/S", help="Row thesis: rail speed between functional areas.")
    ] = None,
    v_area: Annotated[
        float | None, typer.Option(min=1e-3, metavar="M/S", help="Row thesis: rail speed inside a functional area.")
    ] = None,
) -> None:
    """Drive PROGRAM in all ways people would, judge each, and tell where the optimum's saving comes from.

    Savings count against the first legal row. Exit code 1 when no row is legal.
    """
    import json

    from trajopt_cli.baseline.case import RailRule
    from trajopt_cli.cli.comparison_tables import causes_table, comparison_record, rows_csv, rows_table
    from trajopt_cli.cli.console import stdout
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.comparison import compare, comparison_pictures
    from trajopt_cli.files import write_file, write_files
    from trajopt_cli.pipeline import read_program_or_results
    from trajopt_cli.units import DEG

    job = read_program_or_results(program, cell)
    with ProgressView() as view:
        answer = compare(job, view.show, RailRule(phi_min * DEG, v_transfer, v_area))
        pictures = comparison_pictures(answer) if plots is not None else {}
    record = comparison_record(answer)
    if plots is not None:
        write_files(plots, pictures)
    if csv is not None:
        write_file(csv, rows_csv(record["rows"]).encode())
    if as_json:
        typer.echo(json.dumps(record, indent=2, ensure_ascii=False))
    else:
        console = stdout()
        console.print(rows_table(program.name, answer.waits, record["rows"]))
        for row in record["rows"]:
            console.print(f"{row['name']}: {row.get('why') or row['title']}")
            for note in row.get("notes", ()):
                console.print(f"    {note}")
            failed = row.get("failed", [])
            for line in failed[:_SHOWN]:
                console.print(f"    not legal: {line}")
            if len(failed) > _SHOWN:
                console.print(f"    {len(failed) - _SHOWN} checks more failed; --json lists them")
        console.print()
        if isinstance(answer.steps, str):
            console.print(f"saving by cause: nothing to start from: {answer.steps}")
        else:
            console.print(causes_table(answer.steps))
        for line in job.plant.unchecked:
            console.print(line)
        if plots is not None:
            console.print(f"drawn in {plots}: {len(pictures)} pictures")
    if not any(row["legal"] for row in record["rows"]):
        raise typer.Exit(1)
