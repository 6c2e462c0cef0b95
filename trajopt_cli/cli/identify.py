"""`trajopt identify LOG...`: limits of the axes from what a controller recorded."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli import options as opt


def identify(
    logs: Annotated[
        list[Path],
        typer.Argument(metavar="LOG...", help="CSV with a time and every joint, rows 4 to 100 ms apart; or a folder."),
    ],
    robot: Annotated[
        str | None, opt.given("--robot", "NAME", "Whose axes these are: a name of 'trajopt robot list'.")
    ] = None,
    cell: Annotated[
        Path | None, opt.given("--cell", "FILE.yaml", "The cell file, for its robot and the limits in force.")
    ] = None,
    output: Annotated[
        Path | None,
        opt.given("--output", "FILE.yaml", "Where to write the limits: section for the cell file; default: nowhere."),
    ] = None,
    units: opt.LogUnits = None,
    columns: opt.Columns = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Fit speed, acceleration and jerk of every axis to LOGs of its motions, with 90 % intervals.

    A limit is reported where several motions of different length reach the same peak; otherwise why not. Of any log it
    is told what each axis reached, and which limit in force is lower. Exit code 1: nothing to write, or no motion.

    \b
    Example:
      trajopt identify log.csv --robot irb140 --output limits.yaml
    """
    from trajopt_cli.cli.console import no, print_json, result, show, stdout, tell
    from trajopt_cli.errors import InputError
    from trajopt_cli.measured.identify import identify
    from trajopt_cli.measured.limits_file import (
        identified_record,
        identified_table,
        limits_in_force,
        limits_section,
        seen_lines,
    )
    from trajopt_cli.measured.log_csv import logs_of, lost_rows, read_log
    from trajopt_cli.measured.reached import contradictions, reached_in
    from trajopt_cli.runs.files import check_file, write_file

    logs = logs_of(logs)
    if output is not None and any(output.resolve() == path.resolve() for path in [*logs, *([cell] if cell else [])]):
        raise InputError("--output is one of the inputs; name another file", file=str(output))
    if output is not None:
        check_file(output, "--output")
    limits, place = limits_in_force(robot, cell)
    read = [read_log(path, limits, units, columns) for path in logs]
    names, motions = [path.name for path in logs], [one for one, _ in read]
    found, seen = identify(motions, limits)
    reached = reached_in(motions, names, limits)
    against = [*contradictions(motions, names, limits, reached)]
    if as_json:
        print_json(identified_record(found, seen, [str(path) for path in logs], limits, reached, against))
    elif not quiet:
        console = stdout()
        show(console, identified_table(found, reached, limits, place))
        tell(console, seen_lines(names, seen, [unused for _, unused in read], found))
        told = {name: lost_rows(one.t) for name, (one, _) in zip(names, read, strict=True)}
        tell(console, [*(f"{name}: {lost}" for name, lost in told.items() if lost), *against])
    text = limits_section(found, names)
    if not text and (output is not None or not reached):
        no(["NOTHING WRITTEN: these logs show no limit of any axis"], False)
    if output is not None:
        write_file(output, text.encode())
        if quiet and not as_json:
            result(f"written to {output}")
        else:
            typer.echo(f"written to {output}", err=True)
