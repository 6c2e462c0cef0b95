"""`trajopt batch FOLDER`: every program of a folder of backups."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import AsJson, Jobs, Quiet, TimeLimit, patience_of
from trajopt_cli.cli.process import wrote
from trajopt_cli.cli.study import Scheduler, client_for


def batch(
    folder: Annotated[Path, typer.Argument(metavar="FOLDER", help="With backups or programs in it, at any depth.")],
    scheduler: Scheduler = None,
    output: Annotated[
        Path | None, typer.Option(metavar="FOLDER", help="Results folder; default: results/FOLDER_batch.")
    ] = None,
    jobs: Jobs = None,
    time_limit: TimeLimit = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Optimise every program below FOLDER, each in a process of its own, into one table and one page.

    --jobs is how many programs at once, --time-limit is of each.

    A cell file is taken from beside its program or backup; a backup without one gets one of its MOC.cfg, in the results
    folder's cells/, to be corrected there. Called again, it goes on: programs whose inputs are the same are not planned
    again. Exit code 1: some program failed, and why. A cluster's workers must see FOLDER, too.

    \b
    Example:
      trajopt batch backups --time-limit 60
    """
    from concurrent.futures import Executor, ThreadPoolExecutor
    from contextlib import ExitStack

    from trajopt_cli.cli.console import print_json, result, show, stdout, tell, told, warn
    from trajopt_cli.errors import InputError
    from trajopt_cli.parameter_study.backups import (
        INDEX,
        RECORD,
        Row,
        batch_line,
        batch_table,
        failed,
        programs_below,
        remarks,
    )
    from trajopt_cli.parameter_study.backups import batch as run_batch
    from trajopt_cli.runs.files import check_writable
    from trajopt_cli.table import seconds
    from trajopt_cli.workers import cores

    patience_of(time_limit)
    place = output or Path("results") / f"{folder.resolve().name or 'root'}_batch"
    found, left_out = programs_below(folder, place)
    if not found:
        raise InputError("; ".join(["holds no program: no RAPID text with a PROC main", *left_out]), file=str(folder))
    check_writable(place, into=True)
    at_once = jobs or cores()

    def heard(row: Row, left: int) -> None:
        times = f"{seconds(row['as_written_s'], 'not known')} s → {seconds(row['rapid_s'])} s"
        warn(f"{row['program']}: {row['reason'] if row['status'] == 'failed' else times}; {left} to go")

    options = [] if time_limit is None else ["--time-limit", f"{time_limit:g}"]
    wrote(place / RECORD)
    with ExitStack() as stack:
        executor: Executor = ThreadPoolExecutor(at_once)
        if scheduler is not None:
            executor = stack.enter_context(client_for(scheduler, jobs, None)).get_executor()
        stack.enter_context(executor)
        each = max(1, cores() // at_once) if scheduler is None else 1
        rows = run_batch(found, place, executor, options, each, (lambda *_: None) if quiet else heard)
    if as_json:
        print_json({"folder": str(place), "programs": rows})
    elif quiet:
        result(batch_line(rows))
    else:
        console = stdout()
        show(console, batch_table(f"programs below {folder}", rows))
        tell(console, [*remarks(rows), *left_out, "", batch_line(rows)])
    told([f"written to {place}: {INDEX} (open it in a browser), {RECORD}, and a folder per program"], as_json, quiet)
    if failed(rows):
        raise typer.Exit(1)
