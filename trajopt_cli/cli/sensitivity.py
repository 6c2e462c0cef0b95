"""`trajopt sensitivity PROGRAM|RESULTS`: what this cell's owner should change first."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from trajopt_cli.cli.options import (
    AsJson,
    AssumeIdentity,
    CellPath,
    Entry,
    Jobs,
    LoopsOfProgram,
    Quiet,
    TimeLimit,
    patience_of,
)
from trajopt_cli.cli.process import reading
from trajopt_cli.cli.study import Scheduler, tasks_on


def sensitivity(
    program: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROGRAM...|RESULTS",
            help="RAPID module, several, a program list (.pgf), their folder, or a results folder of trajopt optimize, "
            "whose plans are then not made again.",
        ),
    ],
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    loops: LoopsOfProgram = None,
    target: Annotated[
        Literal["stream", "rapid", "both"], typer.Option(help="Whose plan is asked about: a joint stream's, RAPID's.")
    ] = "both",
    search: Annotated[
        bool,
        typer.Option("--search", help="Plan anew with every lever that saves a millisecond, too: exact, and slow."),
    ] = False,
    output: Annotated[
        Path | None,
        typer.Option("--output", metavar="FOLDER", help="Folder for numbers and pictures; default: none are written."),
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
    everything: Annotated[bool, typer.Option("--all", help="List every lever, also those that save nothing.")] = False,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    time_limit: TimeLimit = None,
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
    from trajopt_cli.cli.console import answer_no, print_json, result, show, stdout, tell
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.cli.sensitivity_tables import levers_table, rest_lines
    from trajopt_cli.job import is_results, read_program_or_results
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.folder import check_replaceable
    from trajopt_cli.study.sensitivity import Sensitivity, sensitivity, sensitivity_record, write_sensitivity

    if output is not None:
        check_replaceable(output)
    patience = patience_of(time_limit)
    with reading(program):
        wanted = Loops(loops) if loops else None
        job, made_of_loops = read_program_or_results(program, cell, entry, assume_identity or (), wanted)
    results = program[0] if is_results(program[0]) else None
    targets = tuple(Target) if target == "both" else (Target(target),)
    with ProgressView(patience, quiet) as view, tasks_on(scheduler, patience):
        answer = sensitivity(job, made_of_loops, results, targets, view.show, jobs, search, patience)
    if not isinstance(answer, Sensitivity):
        answer_no(answer, as_json)
    name, plans = program[0].name or job.title, answer.plans
    tables = {
        one: levers_table(name, one, rows, plans[one].duration, everything, search)
        for one, rows in answer.rows.items()
        if not isinstance(rows, str)
    }
    if as_json:
        print_json(sensitivity_record(answer))
    elif quiet:
        for one in answer.rows:
            result(answer.first(one))
    else:
        console = stdout()
        for one, rows in answer.rows.items():
            if not isinstance(rows, str):
                show(console, tables[one])
                tell(console, rest_lines(rows, plans[one].duration, answer.again[one], everything))
                console.print()
        tell(console, (f"not asked: {line}" for line in answer.not_asked))
        console.print()
        tell(console, (answer.first(one) for one in answer.rows))
    if output is not None:
        count = write_sensitivity(output, answer, [*tables.values()])
        if not quiet:
            typer.echo(f"written to {output}: {count} files", err=True)
