"""`trajopt compare baseline PROGRAM`: what the optimum saves, and against what."""

from __future__ import annotations

import typer

from trajopt_cli.cli.options import AsJson, CellPath, ProgramPath

_SHOWN = 3  # failed checks per row; an illegal plan breaks many at once

app = typer.Typer(help="Compare plans of one program.", rich_markup_mode=None)


@app.callback()
def _group() -> None:
    """Compare plans of one program."""


@app.command("baseline", short_help="As written, fixed rail, both optima.")
def baseline(program: ProgramPath, cell: CellPath = None, as_json: AsJson = False) -> None:
    """Solve and judge PROGRAM as written, with a fixed rail, and free on both targets; savings against the first.

    Exit code 1 when no row is legal.
    """
    import json

    from trajopt_cli.cli.console import stdout
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.cli.tables import baseline_records, baseline_table
    from trajopt_cli.pipeline import compare, read_job

    job = read_job(program, cell)
    with ProgressView() as view:
        rows = compare(job, view.show)
    records = baseline_records(rows)
    if as_json:
        typer.echo(json.dumps(records, indent=2, ensure_ascii=False))
    else:
        console = stdout()
        console.print(baseline_table(program.name, rows, records))
        for record in records:
            failed = record.get("failed", [])
            for line in failed[:_SHOWN]:
                console.print(f"{record['name']}: {line}")
            if len(failed) > _SHOWN:
                console.print(f"{record['name']}: {len(failed) - _SHOWN} checks more failed; --json lists them")
    if not any(record["legal"] for record in records):
        raise typer.Exit(1)
