"""`trajopt view RESULTS|CELL.yaml`: the page of a results folder, or of a cell, in the system's browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli import options as opt


def view(
    results: Annotated[
        Path,
        typer.Argument(
            metavar="RESULTS|CELL.yaml", help="Results folder of trajopt optimize or trajopt iiwa, or a cell file."
        ),
    ],
    output: Annotated[
        Path | None, opt.given("--output", "FILE.html", "Of a cell: the page; default: CELL.html here.")
    ] = None,
    only_print: Annotated[bool, typer.Option("--print", help="Print the page's place and open nothing.")] = False,
    serve: Annotated[
        bool,
        typer.Option(
            "--serve", help="Show it by a server on this machine alone, for a browser that may read no files."
        ),
    ] = False,
) -> None:
    """Open report.html of RESULTS in the browser, or print its path where no browser can be opened.

    Of a cell file a page is written that draws robot, obstacles and positioners as they stand, without any plan.

    A browser that is a snap, or that runs on the Windows side of WSL, may not read files here: then, and with --serve,
    the page is served on a port of 127.0.0.1 until Ctrl-C, this one file and nothing else.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod
      trajopt view results/hinge_cell --print
      trajopt view programs/hinge_cell_fenced.yaml --print
    """
    from trajopt_cli.cli.page_server import apart, open_browser, serve_page
    from trajopt_cli.errors import InputError
    from trajopt_cli.runs import REPORT
    from trajopt_cli.runs.folder import read_report

    if results.suffix.lower() in (".yaml", ".yml") and not results.is_dir():
        place = (output or Path(f"{results.stem}.html")).resolve()
        content = _cell_page(results, place)
    elif output is not None:
        raise InputError(f"--output: {results} has its page already; leave it out, or give a cell file")
    else:
        content, place = read_report(results), (results / REPORT).resolve()
    if only_print:
        typer.echo(str(place))
        return
    reason = None if serve else apart()
    if serve or reason is not None:
        if reason is not None:
            typer.echo(f"{reason}: the page is served instead", err=True)
        serve_page(content, lambda address: typer.echo(f"{address}  until Ctrl-C"))
    elif not open_browser(place.as_uri()):
        typer.echo(str(place))
        typer.echo("no browser could be opened here; open this file in one", err=True)


def _cell_page(cell: Path, place: Path) -> bytes:
    """The page of a cell file, written to its place."""
    from trajopt_cli.cell.loader import load_cell
    from trajopt_cli.page.standing import cell_page
    from trajopt_cli.problem.plant import build_plant
    from trajopt_cli.runs.files import check_file, write_file

    check_file(place)
    content = cell_page(build_plant(load_cell(cell)), cell.name)
    write_file(place, content)
    return content
