"""`trajopt sensitivity PROGRAM|RESULTS`: what this cell's owner should change first."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import reading
from trajopt_cli.cli.study import Scheduler, tasks_on

if TYPE_CHECKING:
    from trajopt_cli.table import TextTable


def sensitivity(
    program: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROGRAM...|RESULTS",
            help="RAPID module, several, a program list (.pgf), their folder, or a results folder of trajopt optimize, "
            "whose plans are then not made again.",
        ),
    ],
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    loops: opt.LoopsOfProgram = None,
    target: Annotated[
        Literal["stream", "rapid", "both"], typer.Option(help="Whose plan is asked about: a joint stream's, RAPID's.")
    ] = "both",
    search: Annotated[
        bool,
        typer.Option("--search", help="Plan anew with every lever that saves a millisecond, too: exact, and slow."),
    ] = False,
    output: Annotated[Path | None, opt.results_at("none are written", "Folder for numbers and pictures")] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
    everything: Annotated[bool, typer.Option("--all", help="List every lever, also those that save nothing.")] = False,
    jobs: opt.Jobs = None,
    scheduler: Scheduler = None,
    time_limit: opt.TimeLimit = None,
) -> None:
    """Tell how much of PROGRAM's cycle time each limit, speed, wait and place of the cell is worth.

    One change at a time: limits and speeds by 10 %, waits 10 % shorter, the rail's stroke 10 % longer, places by 10 mm;
    the largest saving first. Each is solved again from the present plan, with the linear estimate beside it. Exit code
    1: the program cannot be done, and why.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod
      trajopt sensitivity results/hinge_cell --target stream
    """
    from trajopt_cli.cli.console import answer_no, print_answer
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.job import is_results, read_program_or_results
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.folder import check_replaceable
    from trajopt_cli.study import sensitivity as study

    if output is not None:
        check_replaceable(output)
    patience = opt.patience_of(time_limit)
    with reading(program):
        wanted = Loops(loops) if loops else None
        job, made_of_loops = read_program_or_results(program, cell, entry, assume_identity or (), wanted)
    results = program[0] if is_results(program[0]) else None
    targets = tuple(Target) if target == "both" else (Target(target),)
    with ProgressView(patience, quiet) as view, tasks_on(scheduler, patience):
        answer = study.sensitivity(job, made_of_loops, results, targets, view.show, jobs, search, patience)
    if not isinstance(answer, study.Sensitivity):
        answer_no(answer, as_json)
    name, plans = program[0].name or job.title, answer.plans
    tables = {
        one: study.levers_table(name, one, rows, plans[one].duration, everything, search)
        for one, rows in answer.rows.items()
        if not isinstance(rows, str)
    }
    parts: list[TextTable | str] = []
    for one, rows in answer.rows.items():
        if not isinstance(rows, str):
            parts += [tables[one], *study.rest_lines(rows, plans[one].duration, answer.again[one], everything), ""]
    first = [answer.first(one) for one in answer.rows]
    parts += [*(f"not asked: {line}" for line in answer.not_asked), "", *first]
    print_answer(as_json, quiet, lambda: study.sensitivity_record(answer), "\n".join(first), parts)
    if output is not None:
        count = study.write_sensitivity(output, answer, [*tables.values()])
        if not quiet:
            typer.echo(f"written to {output}: {count} files", err=True)
