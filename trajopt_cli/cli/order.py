"""`trajopt order PROGRAM`: the fastest order of what may be done in any."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of, wrote
from trajopt_cli.cli.study import Scheduler, tasks_on

if TYPE_CHECKING:
    from trajopt_cli.study.order import Ordered, Tour
    from trajopt_cli.table import TextTable


def order(
    program: opt.ProgramPaths,
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    group: Annotated[
        str | None, opt.given("--group", "NAME", "Which group of the cell file's order, where it has several.")
    ] = None,
    target: opt.TargetOption = "rapid",
    apply: Annotated[
        bool,
        typer.Option("--apply", help="Write the best order into your program; the file as it was stays as NAME.bak."),
    ] = False,
    output: Annotated[Path | None, opt.results_at("results/PROGRAM_order")] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
    jobs: opt.Jobs = None,
    scheduler: Scheduler = None,
    time_limit: opt.TimeLimit = None,
) -> None:
    """Find the fastest order of parts that the cell file lists under its key order.

    Rail and configuration are free at every part. The order is optimal for the search's own times up to 12 parts; the
    most promising orders are planned and checked. The best is written as RAPID where the parts are plain statements
    that share nothing. Exit code 1: no order can be done, or --apply could not write it.

    \b
    Example:
      trajopt order programs/rivets.mod
    """
    from trajopt_cli.cli.console import answer_no, print_answer, told, warn
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.folder import check_replaceable
    from trajopt_cli.study.order import Ordered, apply_order, order_of, order_record, write_order
    from trajopt_cli.study.order_text import group_of
    from trajopt_cli.table import by_name

    patience = opt.patience_of(time_limit)
    job = job_of(program, cell, entry, assume_identity)
    found = group_of(job, group)
    folder = output or Path("results") / f"{job.program.name}_order"
    check_replaceable(folder)
    with ProgressView(patience, quiet) as view, tasks_on(scheduler, patience):
        answer = order_of(found, Target(target), view.show, patience, jobs)
    if not isinstance(answer, Ordered):
        answer_no(answer, as_json)
    files = (*job.program.files, str(job.cell_path))
    table, lines = _table(program[0].name or job.title, answer), [by_name(line, files) for line in answer.remarks]
    count = write_order(folder, answer, table, lines)
    wrote(folder)
    print_answer(as_json, quiet, lambda: order_record(answer), answer.in_words, [table, *lines, "", answer.in_words])
    written = [f"written to {folder}: report.html, order.json and {count - 1} files more"]
    if apply and answer.new_text is not None:
        backup = apply_order(answer)
        wrote(Path(found.file))
        written.append(f"written to {found.file}: the best order; as it was: {backup.name}")
    told(written, as_json, quiet)
    if apply and answer.why_not is not None:
        warn(f"{found.file}: stays as it is: {by_name(answer.why_not, files)}")
        raise typer.Exit(1)


def _table(program: str, answer: Ordered) -> TextTable:
    """The written order, that of the nearest neighbour, the best of the model and the fastest plan."""
    from trajopt_cli.table import percent, seconds, tabulate

    best, now = answer.best, answer.written.planned
    names: dict[tuple[int, ...], list[str]] = {}
    for name, one in (
        ("as written", answer.written.order),
        ("nearest neighbour", answer.nearest),
        ("best of the model", answer.best_of_model),
        ("fastest plan", None if best is None else best.order),
    ):
        if one is not None:
            names.setdefault(one, []).append(name)

    def saved(tour: Tour) -> float | None:
        return None if now is None or tour.planned is None or tour is answer.written else now - tour.planned

    return tabulate(
        f"{program}, {answer.target.value}: in which order {answer.group.name}",
        [answer.found[order] for order in names],
        {
            "": lambda tour: ", ".join(names[tour.order]),
            ">model [s]": lambda tour: seconds(tour.model if tour.model < float("inf") else None, "-"),
            ">planned [s]": lambda tour: seconds(tour.planned, "-"),
            ">saves [s]": lambda tour: seconds(saved(tour)),
            ">of it": lambda tour: "" if (gain := saved(tour)) is None or not now else percent(gain / now),
            "~order": lambda tour: " ".join(str(i + 1) for i in tour.order),
        },
    )
