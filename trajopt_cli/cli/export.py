"""`trajopt export joint|rapid RESULTS`: plans as files for the machine that executes them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import ResultsFolder

app = typer.Typer(help="Write a plan for the machine that executes it.", rich_markup_mode=None)


@app.command("joint", short_help="Joint CSV at a fixed rate.")
def joint(
    results: ResultsFolder,
    output: Annotated[Path, typer.Option(metavar="FILE.csv", help="The CSV file to write.")],
    rate: Annotated[float, typer.Option(metavar="HZ", help="Rows per second.")] = 1000.0,
) -> None:
    """Joint positions and speeds of trajectory.csv's target at a fixed rate, the exact end as last row."""
    from trajopt_cli.files import write_file
    from trajopt_cli.pipeline import joint_export

    source, trajectory, text = joint_export(results, rate)
    write_file(output, text.encode("ascii"))
    rows = len(trajectory.t)
    typer.echo(f"{output}: the {source.target.value} plan, {rows} rows at {rate:g} Hz, T = {trajectory.duration:.4f} s")
    for when, condition in source.holds:
        typer.echo(f"hold at t = {when:.4f} s until {condition}")


@app.command("rapid", short_help="The program with the rapid plan in it.")
def rapid(
    results: ResultsFolder,
    output: Annotated[
        Path | None, typer.Option(metavar="FILE.mod", help="The module to write; a folder for several modules.")
    ] = None,
    diff: Annotated[bool, typer.Option("--diff", help="Print what differs from the program as given.")] = False,
) -> None:
    """The program with the rapid plan in it; everything else is byte for byte as given."""
    from trajopt_cli.files import write_file
    from trajopt_cli.pipeline import rapid_export

    if output is None and not diff:
        raise typer.BadParameter("give --output, --diff or both")
    modules, difference = rapid_export(results)
    if diff:
        typer.echo(difference, nl=False)
    if output is not None:
        places = {name: output / name if len(modules) > 1 else output for name in modules}
        for name, content in modules.items():
            write_file(places[name], content)
            typer.echo(f"{places[name]}: the rapid plan", err=diff)
