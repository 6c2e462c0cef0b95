"""`trajopt parse PROGRAM`: the flat motions, each with its place."""

from __future__ import annotations

from trajopt_cli.cli.options import AsJson, CellPath, ProgramPath


def parse(program: ProgramPath, cell: CellPath = None, as_json: AsJson = False) -> None:
    """Run PROGRAM on paper and print its motions in order with file:line. Needs no cell file; one gives signals."""
    import typer

    from trajopt_cli.pipeline import read_flat, scenario_for
    from trajopt_cli.rapid.listing import describe

    flat = read_flat(program, scenario_for(program, cell))
    typer.echo(describe(flat))
    for warning in flat.warnings:
        typer.echo(f"warning: {warning}", err=True)
