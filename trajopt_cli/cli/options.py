"""Arguments and options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

ProgramPath = Annotated[Path, typer.Argument(metavar="PROGRAM", help="RAPID module with the program's entry.")]
CellPath = Annotated[
    Path | None,
    typer.Option("--cell", metavar="FILE.yaml", help="Cell file; default: PROGRAM.yaml beside the program."),
]
ResultsFolder = Annotated[Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt optimize.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")]
