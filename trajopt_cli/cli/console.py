"""Where answers go: stdout for them, stderr for progress and for a no."""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

import typer
from rich.console import Console
from rich.measure import Measurement
from rich.table import Table

if TYPE_CHECKING:
    from trajopt_cli.pipeline.optimise import Collides, Illegal
    from trajopt_cli.pipeline.planning import NoPlan
    from trajopt_cli.problem.plan import Infeasible

_PIPED_WIDTH = 300  # columns when nobody tells; tables of paths and numbers must not wrap in a log


def _console(stderr: bool) -> Console:
    console = Console(stderr=stderr, highlight=False, markup=False, emoji=False, soft_wrap=False)
    if not console.is_terminal:
        console.width = _PIPED_WIDTH
    return console


def stdout() -> Console:
    """The console for answers."""
    return _console(stderr=False)


def show(console: Console, table: Table) -> None:
    """Print a table with every figure whole: a terminal that is too narrow wraps lines rather than lose digits."""
    least = Measurement.get(console, console.options.update(max_width=_PIPED_WIDTH), table).maximum
    width = console.width
    console.width = max(width, least)
    console.print(table, crop=False)
    console.width = width


def stderr() -> Console:
    """The console for progress and errors."""
    return _console(stderr=True)


def answer_no(answer: Infeasible | NoPlan | Illegal | Collides) -> NoReturn:
    """Say on stderr why there is no result, and stop with exit code 1."""
    from trajopt_cli.pipeline.optimise import Collides, Illegal
    from trajopt_cli.pipeline.planning import NoPlan
    from trajopt_cli.problem.plan import Infeasible

    match answer:
        case Infeasible():
            typer.echo(str(answer), err=True)
        case NoPlan(label=label, message=message):
            typer.echo(
                f"NOTHING WRITTEN: no {label} plan found although the program can be done ({message}). "
                "This is an error in trajopt; please report it with program and cell file.",
                err=True,
            )
        case Collides(label=label, hits=hits):
            for hit in hits:
                typer.echo(hit.message, err=True)
            what = f"the {label} plan collides. The planner does not look at obstacles: move or add a point"
            if not label:
                what = "the robot cannot stand at its start. Correct the start or the obstacle"
            typer.echo(
                f"NOTHING WRITTEN: {what}, or say in the cell file what may touch ('ignore', 'may_touch')", err=True
            )
        case Illegal(label=label, finding=finding):
            what = finding.message or f"{finding.check} of {finding.subject} failed"
            typer.echo(
                f"NOTHING WRITTEN: the judge rejects the {label} plan: {what}. "
                "This is an error in trajopt; please report it with program and cell file.",
                err=True,
            )
    raise typer.Exit(1)
