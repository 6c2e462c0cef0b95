"""`trajopt view RESULTS`: the page of a results folder in the system's browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def view(
    results: Annotated[
        Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt optimize or trajopt iiwa.")
    ],
    only_print: Annotated[bool, typer.Option("--print", help="Print the page's place and open nothing.")] = False,
    serve: Annotated[
        bool,
        typer.Option(
            "--serve", help="Show it by a server on this machine alone, for a browser that may read no files."
        ),
    ] = False,
) -> None:
    """Open report.html of RESULTS in the browser, or print its path where no browser can be opened.

    A browser that is a snap, or that runs on the Windows side of WSL, may not read files here: then, and with --serve,
    the page is served on a port of 127.0.0.1 until Ctrl-C, this one file and nothing else.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod
      trajopt view results/hinge_cell --print
    """
    from trajopt_cli.cli.page_server import apart, open_browser, serve_page
    from trajopt_cli.runs import REPORT
    from trajopt_cli.runs.folder import read_report

    content = read_report(results)
    place = (results / REPORT).resolve()
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
