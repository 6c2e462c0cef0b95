"""`trajopt batch FOLDER`: every program of a folder of backups."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import wrote
from trajopt_cli.cli.study import Scheduler, client_for


def batch(
    folder: Annotated[Path, typer.Argument(metavar="FOLDER", help="With backups or programs in it, at any depth.")],
    scheduler: Scheduler = None,
    output: Annotated[Path | None, opt.results_at("results/FOLDER_batch")] = None,
    jobs: opt.Jobs = None,
    time_limit: opt.TimeLimit = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
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

    from trajopt_cli.cli.console import print_answer, told, warn
    from trajopt_cli.errors import InputError
    from trajopt_cli.parameter_study import backups
    from trajopt_cli.runs.files import check_writable
    from trajopt_cli.table import seconds
    from trajopt_cli.workers import cores

    options = opt.passed_on(time_limit)
    place = output or Path("results") / f"{folder.resolve().name or 'root'}_batch"
    found, left_out = backups.programs_below(folder, place)
    if not found:
        raise InputError("; ".join(["holds no program: no RAPID text with a PROC main", *left_out]), file=str(folder))
    check_writable(place, into=True)
    at_once = jobs or cores()

    def heard(row: backups.Row, left: int) -> None:
        times = f"{seconds(row['as_written_s'], 'not known')} s → {seconds(row['rapid_s'])} s"
        warn(f"{row['program']}: {row['reason'] if row['status'] == 'failed' else times}; {left} to go")

    wrote(place / backups.RECORD)
    with ExitStack() as stack:
        executor: Executor = ThreadPoolExecutor(at_once)
        if scheduler is not None:
            executor = stack.enter_context(client_for(scheduler, jobs, None)).get_executor()
        stack.enter_context(executor)
        each = max(1, cores() // at_once) if scheduler is None else 1
        hear = (lambda *_: None) if quiet else heard
        rows = backups.batch(found, place, executor, options, each, hear)
    line, table = backups.batch_line(rows), backups.batch_table(f"programs below {folder}", rows)
    record = {"folder": str(place), "programs": rows}
    print_answer(as_json, quiet, lambda: record, line, [table, *backups.remarks(rows), *left_out, "", line])
    files = f"{backups.INDEX} (open it in a browser), {backups.RECORD}, and a folder per program"
    told([f"written to {place}: {files}"], as_json, quiet)
    if backups.failed(rows):
        raise typer.Exit(1)
