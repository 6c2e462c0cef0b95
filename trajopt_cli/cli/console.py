"""Where answers go: stdout for them, stderr for progress and for a no."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, NoReturn

import typer
from rich.console import Console

from trajopt_cli.cli.layout import Fitted, wrapped
from trajopt_cli.cli.listing import terminal_width
from trajopt_cli.table import TextTable, Verbatim

if TYPE_CHECKING:
    from trajopt_cli.pipeline.optimize import Collides, Illegal
    from trajopt_cli.problem.plan import Infeasible, NoPlan

_UNBOUND = 100_000  # columns where nobody tells: a log has lines of any length
_DEEPER = "    "  # before what follows the first line of a text that takes several
_REPORT = "This is an error in trajopt; please report it with program and cell file"


def stdout(quiet: bool = False) -> Console:
    """The console for answers: as wide as the terminal, in plain text where there is none. quiet: it says nothing, and
    a command prints its result with result()."""
    width = terminal_width(piped=_UNBOUND)
    return Console(highlight=False, markup=False, emoji=False, width=width, quiet=quiet)


def show(console: Console, table: TextTable) -> None:
    """Print a table with every figure whole: one that is too narrow for its first column is not cut."""
    console.print(Fitted(table), crop=False, no_wrap=True, overflow="ignore")


def tell(console: Console, lines: Iterable[str]) -> None:
    """Print lines, each with what does not fit hanging below it."""
    for line in lines:
        text = line.lstrip(" ")
        for part in wrapped(text, console.width, line[: len(line) - len(text)], _DEEPER) or [""]:
            console.print(part, crop=False, no_wrap=True, overflow="ignore")


def print_answer(
    as_json: bool, quiet: bool, record: Callable[[], Any], line: str, parts: Iterable[TextTable | str]
) -> None:
    """Print an answer: its record as one JSON document, the line that --quiet leaves, or its tables and lines."""
    if as_json:
        print_json(record())
    elif quiet:
        typer.echo(line)
    else:
        console = stdout()
        for part in parts:
            if isinstance(part, TextTable):
                show(console, part)
            elif isinstance(part, Verbatim):
                console.print(part, soft_wrap=True)
            else:
                tell(console, [part])


def result(text: str) -> None:
    """Print a line of what --quiet leaves: the result."""
    typer.echo(text)


def warn(text: str) -> None:
    """Say on stderr what the user should know of the result, whatever is asked to be quiet."""
    typer.echo(text, err=True)


def told(lines: Iterable[str], as_json: bool, quiet: bool) -> None:
    """Say what was written: beside JSON on stderr, and nothing where it is to be quiet."""
    for line in () if quiet else lines:
        if as_json:
            warn(line)
        else:
            tell(stdout(), [line])


def print_json(record: Any) -> None:
    """Print one JSON document; numbers that are none (NaN, infinite) become null, which JSON has."""
    typer.echo(json.dumps(_plain(record), indent=2, ensure_ascii=False, allow_nan=False))


def _plain(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {str(key): _plain(one) for key, one in value.items()}
    return [_plain(one) for one in value] if isinstance(value, list | tuple) else value


def no(lines: Iterable[str], as_json: bool, feasible: bool | None = False, **record: Any) -> NoReturn:
    """Say on stderr why the answer is no, as JSON on stdout, too, where that is asked; and stop with exit code 1.

    feasible: None where it is not known that it cannot be done.
    """
    lines = list(lines)
    if as_json:
        print_json({"feasible": feasible, **record, "why": lines})
    for line in lines:
        typer.echo(line, err=True)
    raise typer.Exit(1)


def answer_no(answer: Infeasible | NoPlan | Illegal | Collides, as_json: bool = False) -> NoReturn:
    """Say why there is no result, and stop with exit code 1."""
    from trajopt_cli.pipeline.optimize import Collides, Illegal
    from trajopt_cli.problem.plan import Infeasible, NoPlan

    match answer:
        case Infeasible():
            place = {"index": answer.index, "source": str(answer.source)}
            no([str(answer)], as_json, answer="infeasible", motion=place, limit=answer.message)
        case NoPlan(label=label, message=message):
            line = f"NOTHING WRITTEN: no {label} plan found although the program can be done ({message}). {_REPORT}."
            no([line], as_json, None, answer="no plan", plan=label)
        case Collides(label=label, hits=hits):
            what = f"the {label} plan collides. The planner took it for clear: please report that; move or add a point"
            if not label:
                what = "the robot cannot stand at its start. Correct the start or the obstacle"
            last = f"NOTHING WRITTEN: {what}, or say in the cell file what may touch ('ignore', 'may_touch')"
            no([*(hit.message for hit in hits), last], as_json, None, answer="collides", plan=label or "start")
        case Illegal(label=label, finding=finding):
            what = finding.message or f"{finding.check} of {finding.subject} failed"
            line = f"NOTHING WRITTEN: the judge rejects the {label} plan: {what}. {_REPORT}."
            no([line], as_json, None, answer="illegal", plan=label)
