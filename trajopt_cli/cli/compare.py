"""`trajopt compare baseline PROGRAM|RESULTS`: what the optimum saves, against what, and why."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from trajopt_cli.cli.compare_runs import runs
from trajopt_cli.cli.options import (
    AsJson,
    AssumeIdentity,
    CellPath,
    Entry,
    LoopsOfProgram,
    Quiet,
    TimeLimit,
    patience_of,
)
from trajopt_cli.cli.process import reading, wrote
from trajopt_cli.cli.study import Scheduler, tasks_on

if TYPE_CHECKING:
    from trajopt_cli.problem.plan import Target

app = typer.Typer(help="Compare plans of one program.", rich_markup_mode=None)


@app.callback()
def _group() -> None:
    """Compare plans of one program."""


app.command("runs", short_help="Compare results folders: times, motions, limits, inputs.")(runs)


@app.command("baseline", short_help="Today's practice, textbook methods, both optima, and the saving by cause.")
def baseline(
    program: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROGRAM...|RESULTS",
            help="RAPID module, several, a program list (.pgf), their folder, or a results folder of trajopt optimize.",
        ),
    ],
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    loops: LoopsOfProgram = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE.csv", help="Write the rows as CSV, too.")] = None,
    plots: Annotated[
        Path | None,
        typer.Option("--plots", metavar="FOLDER", help="Draw the rows, the saving by cause and the fastest plan, too."),
    ] = None,
    target: Annotated[
        Literal["stream", "rapid"] | None,
        typer.Option(
            help="Whose plan --plots draws; default: stream, of a results folder its own.", show_default=False
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", metavar="FOLDER", help="Results folder; default: results/PROGRAM_comparison."),
    ] = None,
    phi_min: Annotated[
        float, typer.Option(min=0, max=80, metavar="DEG", help="Row thesis: least angle of joint 3 from stretched.")
    ] = 10.0,
    v_transfer: Annotated[
        float | None, typer.Option(min=1e-3, metavar="M/S", help="Row thesis: rail speed between functional areas.")
    ] = None,
    v_area: Annotated[
        float | None, typer.Option(min=1e-3, metavar="M/S", help="Row thesis: rail speed inside a functional area.")
    ] = None,
    scheduler: Scheduler = None,
    time_limit: TimeLimit = None,
) -> None:
    """Compare the optimum with today's practice and textbook methods, and split its saving by cause.

    Savings count against the first legal row. Exit code 1 when no row is legal.

    \b
    Example:
      trajopt compare baseline programs/hinge_cell.mod --csv rows.csv
    """
    from trajopt_cli.cli.comparison_tables import causes_table, comparison_line, row_lines, rows_table
    from trajopt_cli.cli.console import print_json, result, show, stdout, tell, told
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.cli.remarks import by_name
    from trajopt_cli.job import read_program_or_results
    from trajopt_cli.pipeline.optimize import held_unasked
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.runs.files import write_file
    from trajopt_cli.runs.folder import check_replaceable
    from trajopt_cli.runs.transaction import write_files
    from trajopt_cli.study.case import RailRule
    from trajopt_cli.study.comparison import compare, comparison_pictures
    from trajopt_cli.study.comparison_folder import ComparisonOptions, write_comparison
    from trajopt_cli.study.comparison_record import comparison_record, rows_csv
    from trajopt_cli.units import DEG

    patience = patience_of(time_limit)
    with reading(program):
        wanted = Loops(loops) if loops else None
        job, made_of_loops = read_program_or_results(program, cell, entry, assume_identity or (), wanted)
    _check_places(csv, plots)
    folder = output or Path("results") / f"{job.program.name}_comparison"
    check_replaceable(folder)
    with ProgressView(patience, quiet) as view, tasks_on(scheduler, patience):
        rule = RailRule(phi_min * DEG, v_transfer, v_area)
        answer = compare(job, view.show, rule, made_of_loops, patience)
    record = comparison_record(answer)
    if csv is not None:
        write_file(csv, rows_csv(record["rows"]).encode())
        wrote(csv)
    if as_json:
        print_json(record)
    elif quiet:
        result(comparison_line(record["rows"]))
    else:
        console = stdout()
        show(console, rows_table(program[0].name or job.title, answer.waits, record["rows"], answer.settling))
        files = (*job.program.files, str(job.cell_path))
        tell(console, row_lines(record["rows"], files))
        console.print()
        if isinstance(answer.steps, str):
            why = f"saving by cause: not available, there is no plan to start from ({answer.steps})"
            tell(console, [by_name(why, files)])
        else:
            show(console, causes_table(answer.steps))
        for line in (*job.plant.unchecked, *answer.notices, *held_unasked(job)):
            tell(console, [by_name(line, files)])
    if plots is not None:
        pictures = comparison_pictures(answer, _drawn(target, program[0]))
        write_files(plots, pictures)
        if not quiet:
            typer.echo(f"drawn in {plots}: {len(pictures)} files", err=True)
    options = ComparisonOptions(
        program=[str(path) for path in job.paths],
        cell=str(job.cell_path),
        entry=job.program.entry,
        assume_identity=list(job.assume_identity),
        loops=made_of_loops.value,
    )
    count = write_comparison(folder, answer, options)
    wrote(folder)
    told([f"written to {folder}: report.html (open it in a browser) and {count - 1} files more"], as_json, quiet)
    if not any(row["legal"] for row in record["rows"]):
        raise typer.Exit(1)


def _drawn(target: str | None, program: Path) -> Target:
    """Whose plan is drawn: as asked for, else as a results folder was made, else the stream's."""
    from trajopt_cli.job import is_results
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.results import read_results

    if target is None and is_results(program):
        return read_results(program).target
    return Target(target or "stream")


def _check_places(csv: Path | None, plots: Path | None) -> None:
    """Before minutes of work: the places to write to can be what they are meant to be."""
    from trajopt_cli.errors import InputError
    from trajopt_cli.runs.files import check_writable

    if csv is not None and csv.is_dir():
        raise InputError("is a folder; --csv names a file", file=str(csv))
    if csv is not None and not csv.parent.is_dir():
        raise InputError("is not a folder to write to; make it or correct --csv", file=str(csv.parent))
    if plots is not None and plots.exists() and not plots.is_dir():
        raise InputError("is a file; --plots names a folder", file=str(plots))
    for place in (csv, plots):
        if place is not None:
            check_writable(place, into=place is plots)
