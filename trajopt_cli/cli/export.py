"""`trajopt export joint|rapid RESULTS`: plans as files for the machine that executes them."""

from __future__ import annotations

import sys
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
    from trajopt_cli.pipeline.folder import joint_export
    from trajopt_cli.runs.files import write_file

    _check_output(output, results)
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
    diff: Annotated[
        bool, typer.Option("--diff", help="Print what differs from the program as given; patch -p1 takes it.")
    ] = False,
    in_place: Annotated[
        bool, typer.Option("--in-place", help="Write over the program's own files; the old ones stay as NAME.bak.")
    ] = False,
) -> None:
    """The program with the rapid plan in it; everything else is byte for byte as given."""
    from trajopt_cli.pipeline.folder import rapid_export
    from trajopt_cli.runs.files import write_file
    from trajopt_cli.runs.results import write_in_place

    if output is None and not diff and not in_place:
        raise typer.BadParameter("give --output, --diff, --in-place or several of them")
    files = rapid_export(results)
    if diff and not files.patch:
        for why in files.kept or ("the plan needs no change to the program",):
            typer.echo(f"no change: {why}", err=True)
    if diff and sys.stdout.isatty():
        typer.echo(files.difference, nl=False)
    elif diff:
        sys.stdout.flush()
        sys.stdout.buffer.write(files.patch)  # in the files' own encodings and line ends
    if output is not None:
        for one in files.modules:
            path = output / one.place if len(files.modules) > 1 else output
            _check_output(path, results)
            write_file(path, one.content)
            typer.echo(f"{path}: the rapid plan", err=diff)
    if in_place:
        backups = write_in_place(files.modules)
        for one in files.modules:
            if one.given is None:
                typer.echo(f"{one.path}: a new module; load it with the program", err=diff)
            elif one.path in backups:
                typer.echo(f"{one.path}: the rapid plan; as it was: {backups[one.path].name}", err=diff)
            else:
                typer.echo(f"{one.path}: stays as it is", err=diff)
        if any(one.given is None for one in files.modules):
            every = " ".join(str(one.path) for one in files.modules)
            typer.echo(f"from now on give the folder, or all files: trajopt parse {every}", err=diff)


def _check_output(output: Path, results: Path) -> None:
    """Refuse to write over a folder, or over what a results folder holds: its files are held against their hashes."""
    from trajopt_cli.errors import InputError

    if output.is_dir():
        raise InputError("is a folder; --output names a file", file=str(output))
    if output.exists() and output.resolve().is_relative_to(results.resolve()):
        raise InputError("is a file of the results folder; write to another place", file=str(output))
