"""`trajopt compare runs A B ...`: results folders side by side."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from trajopt_cli.cli.options import AsJson, Quiet

if TYPE_CHECKING:
    from rich.console import Console

    from trajopt_cli.runs.compared import ComparedRuns

MOST = 20  # motions that are listed unless all are asked for


def runs(
    results: Annotated[
        list[Path],
        typer.Argument(metavar="RESULTS RESULTS...", help="Two results folders of trajopt optimize or more."),
    ],
    target: Annotated[
        Literal["stream", "rapid"] | None,
        typer.Option(help="Whose motions are put side by side; default: the first run's.", show_default=False),
    ] = None,
    everything: Annotated[bool, typer.Option("--all", help="List every motion, in the program's order.")] = False,
    diff: Annotated[bool, typer.Option("--diff", help="Show the lines of the program that differ, too.")] = False,
    report: Annotated[
        Path | None, typer.Option("--report", metavar="FILE.html", help="Write the comparison as a page, too.")
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Compare runs: cycle times, inputs that differ, motions and the limits that hold them back.

    Differences count against the first folder. Nothing is planned again.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod --gentle --output results/gentle
      trajopt compare runs results/hinge_cell results/gentle
    """
    from trajopt_cli.cli.console import print_json, result, stdout
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.compared import compare_runs
    from trajopt_cli.runs.compared_tables import runs_line, runs_record
    from trajopt_cli.runs.files import check_file, write_file

    if report is not None:
        check_file(report, "--report")
    answer = compare_runs(results, Target(target) if target else None)
    if as_json:
        print_json(runs_record(answer))
    elif quiet:
        result(runs_line(answer))
    else:
        _print(stdout(), answer, everything, diff)
    if report is not None:
        from trajopt_cli.page.runs import runs_page

        write_file(report, runs_page(answer))
        if not quiet:
            typer.echo(f"written to {report}", err=True)


def _print(console: Console, answer: ComparedRuns, everything: bool, diff: bool) -> None:
    from trajopt_cli.cli.console import show, tell
    from trajopt_cli.runs.compared_tables import bindings_table, cycles_table, inputs_lines, motions_table

    for run in answer.runs:
        console.print(f"{run.letter}: {run.folder} ({', '.join(run.inputs.modules)})")
    tell(console, [f"note: {note}" for note in answer.notes])
    console.print()
    show(console, cycles_table(answer))
    for line in inputs_lines(answer, diff):
        console.print(line)
    console.print()
    rows = answer.rows if everything else answer.by_difference[:MOST]
    if rows:
        show(console, motions_table(answer, rows))
    left = len(answer.by_difference) - len(rows)
    if not everything and left > 0:
        console.print(f"{left} more motions differ; --all lists every one")
    same = len(answer.rows) - len(answer.by_difference)
    if not everything and same:
        console.print(f"{same} of {len(answer.rows)} motions take the same time")
    if answer.bound_otherwise:
        console.print()
        show(console, bindings_table(answer))
