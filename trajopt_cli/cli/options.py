"""Arguments and options that several commands share."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from trajopt_cli.errors import InputError

if TYPE_CHECKING:
    from trajopt_cli.problem.stop_condition import Patience


def given(flag: str, metavar: str, about: str, **more: Any) -> Any:
    """An option that takes a value, by its flag, what stands for the value, and its help; no default is shown."""
    return typer.Option(flag, metavar=metavar, help=about, **more)


ProgramPaths = Annotated[
    list[Path],
    typer.Argument(metavar="PROGRAM...", help="RAPID module, several, a program list (.pgf), or their folder."),
]
CellPath = Annotated[
    Path | None,
    given("--cell", "FILE.yaml", "Cell file; default: PROGRAM.yaml beside the program, or cell.yaml in its folder."),
]
Entry = Annotated[str | None, given("--entry", "PROC", "The procedure to start with; default: main.")]
AssumeIdentity = Annotated[
    list[str] | None,
    given(
        "--assume-identity",
        "NAME",
        "Take this tool, work object or mechanical unit as the identity where the program does not declare it; "
        "may be repeated.",
    ),
]
ChosenTarget = Annotated[
    Literal["stream", "rapid"] | None,
    typer.Option(
        "--target",
        help="Whose plan leads, and is in trajectory.csv; default: the RAPID controller's leads, a joint stream's is "
        "in the file.",
        show_default=False,
    ),
]
TargetOption = Annotated[
    Literal["stream", "rapid"],
    typer.Option("--target", help="Whose plan is asked for: a joint stream's or the RAPID controller's."),
]
Jobs = Annotated[
    int | None,
    given("--jobs", "N", "Worker processes; default: one per core. The answer does not depend on it.", min=1),
]
TimeLimit = Annotated[
    float | None,
    given(
        "--time-limit",
        "S",
        "Be done S seconds after the start, judging and writing included; 0 takes the first legal answer. Two "
        "such runs may differ. Ctrl-C stops improving, too; a second one gives up.",
    ),
]
ResultsFolder = Annotated[Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt optimize.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document instead of text.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="One-line result; no progress.")]
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="The grid of each duration, too.")]


def results_at(default: str, what: str = "Results folder") -> Any:
    """The option --output of a command that writes a folder. default: where that is if nobody says it."""
    return given("--output", "FOLDER", f"{what}; default: {default}.")


def file_of_results(kind: str, name: str) -> Any:
    """The option --output of a command that writes one file. kind: of file, in words; name: in RESULTS, by default."""
    endings = f"FILE{Path(name).suffix}"
    return given("--output", endings, f"The {kind}; default: {name} in RESULTS.")


def patience_of(time_limit: float | None) -> Patience:
    """How long a search may go on. Raises InputError for a limit that is no time."""
    from trajopt_cli.problem.stop_condition import Patience

    if time_limit is not None and not 0 <= time_limit < math.inf:
        raise InputError(f"--time-limit: needs a time of 0 s or more, not {time_limit:g}")
    return Patience(time_limit)


def passed_on(time_limit: float | None) -> list[str]:
    """The same for a trajopt optimize that a command runs."""
    patience_of(time_limit)
    return [] if time_limit is None else ["--time-limit", f"{time_limit:g}"]


def robots(incomplete: str) -> list[str]:
    """Names of robots that ship, for the shell to complete."""
    from trajopt_cli.robot.model import robot_names

    return [name for name in robot_names() if name.startswith(incomplete)]


_LOOPS = (
    "RAPID plan: one rail position and configuration for every statement that moves (FOR loops take theirs from "
    "arrays), or a copy of a routine for each of its calls where that is faster."
)
LoopsOption = Annotated[Literal["keep", "unroll"], typer.Option("--loops", help=_LOOPS)]
LoopsOfProgram = Annotated[
    Literal["keep", "unroll"] | None,
    typer.Option("--loops", help=f"{_LOOPS} Of a program, keep; a results folder brings its own.", show_default=False),
]
LogUnits = Annotated[
    str | None,
    given(
        "--units",
        "UNIT,...",
        "Units of a log's columns whose heads name none: s or ms, deg or rad, mm or m, as in deg,mm.",
    ),
]
Columns = Annotated[
    str | None,
    given(
        "--columns",
        "NAME=HEAD,...",
        "Which of a log's columns is what where the heads do not tell: time=Stamp,joint_1=#3. A robot's name "
        "alone takes the columns that its heads begin or end with: ROB_2.",
    ),
]
